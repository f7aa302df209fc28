"""How much of one patch another one sees: rays between low-discrepancy points, against the original polygons.

The share of a pair's form factor that is not blocked is sum w V / sum w, over rays with the kernel's weights
w = cos(theta_1) cos(theta_2) / r^2.  Sixteen rays first; where they disagree, 48 more, in groups of sixteen.  The
points depend on the pair alone, so results are the same however many threads work.  Of few patches, all large, each
pair gets twice as many.

A small share, as through a distant door, is often missed by all of the first rays.  Since that pair is then taken as
hidden, the others must make up for it: of the later groups only those count whose rays disagree too.  So the mean over
many pairs is right, whichever group comes first: a group that agrees would have ended the search, and one that does not
would have been averaged with all that do not.
"""

from __future__ import annotations

import os
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.bodies import ASK, GAP, HIDDEN, bodies_of, judge
from glsim.radiosity.patches import Patches
from glsim.radiosity.rays import add_seen, rays_between, rays_from_points
from glsim.radiosity.scene import Scene

Float = NDArray[np.float64]
Int = NDArray[np.int64]
FIRST, MORE = 16, 48  # rays of a pair
FEW = 1000  # patches, of which each pair gets twice as many
POINT_RAYS = 12  # from a vertex to a patch, before MORE
FEW_RAYS = 2  # from a vertex to a patch that sends little
CHUNK = 1 << 12  # pairs at a time, in each thread

# Fractional parts of k times these are evenly spread over the four-dimensional cube (Roberts 2018).
_ROOT = 1.1673039782614187  # x^5 = x + 1
TABLE = np.outer(np.arange(2 * (FIRST + MORE)), [_ROOT**-k for k in range(1, 5)]) % 1.0


class Visibility:
    """Rays against the triangles of a scene.

    middle: of the scene; single precision is enough around it, wherever the scene is.  Outside of ``bodies`` (see
    ``bodies_of``) nothing can block; None if they are too many to be of use.
    """

    def __init__(self, scene: Scene, threads: int | None = None) -> None:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene

        self.scene: Any = EmbreeScene()
        triangles = scene.triangles()
        self.middle = (triangles.min(axis=(0, 1)) + triangles.max(axis=(0, 1))) / 2.0
        self.mesh = TriangleMesh(self.scene, np.ascontiguousarray(triangles - self.middle, np.float32))
        self.gap = GAP * scene.size
        self.bodies = bodies_of(scene)
        self.kept: tuple[Float, NDArray[np.float32]] | None = None
        self.local = threading.local()
        self.pool = ThreadPoolExecutor(threads or os.cpu_count() or 1)
        self.scene.run(np.zeros((1, 3), np.float32), np.ones((1, 3), np.float32))  # builds Embree's tree, once

    def blocked(self, origins: NDArray[np.float32], ways: NDArray[np.float32]) -> NDArray[np.int32]:
        """For each ray, from an origin (counted from ``middle``) along the whole of its way: -1 if nothing is hit."""
        return np.asarray(self.scene.run(origins, ways, dists=self._ones(len(origins)), query="OCCLUDED"))

    def between(self, starts: Float, ends: Float) -> NDArray[np.bool_]:
        """Whether points (n, 3) see other points."""
        way = ends - starts
        off = np.minimum(self.gap / np.maximum(np.linalg.norm(way, axis=1), 1e-300), 0.5)[:, None]
        origins = (starts - self.middle + off * way).astype(np.float32)
        return self.blocked(origins, ((1.0 - 2.0 * off) * way).astype(np.float32)) < 0

    def _ones(self, size: int) -> NDArray[np.float32]:
        """How far rays go: the whole way.  Embree writes into it."""
        kept = getattr(self.local, "ones", None)
        if kept is None or len(kept) < size:
            kept = self.local.ones = np.empty(size, np.float32)
        kept[:size] = 1.0
        return np.asarray(kept[:size])

    def fractions(self, rings: Float, counts: Int, normals: Float, pairs: Int) -> Float:
        """The share of the form factor of each pair (k, 2) that is not blocked, (k,) in [0, 1]."""
        return self.asked(rings, counts, normals, pairs)[0]

    def asked(self, rings: Float, counts: Int, normals: Float, pairs: Int) -> tuple[Float, Int]:
        """The same, and the numbers of the pairs for which rays were needed: of the others the share is certain."""
        reach = self._reach_of(rings)
        result, asked = self._judged(reach, reach, pairs[:, 0], pairs[:, 1])
        rings = rings - self.middle
        chunks = [asked[k : k + CHUNK] for k in range(0, len(asked), CHUNK)]
        work = self.pool.map(lambda chunk: self._chunk(rings, counts, normals, pairs[chunk]), chunks)
        for chunk, values in zip(chunks, work, strict=True):
            result[chunk] = values
        return result, asked

    def _reach_of(self, rings: Float) -> NDArray[np.float32] | None:
        """Bodies.reach, remembered for the patches that were asked for last."""
        if self.bodies is None:
            return None
        if self.kept is None or self.kept[0] is not rings:
            self.kept = rings, self.bodies.reach(rings)
        return self.kept[1]

    def _judged(
        self, one: NDArray[np.float32] | None, two: NDArray[np.float32] | None, rows: Int, columns: Int
    ) -> tuple[Float, Int]:
        """The share of each pair that is seen, as far as the bodies tell, and which pairs need rays."""
        bodies = self.bodies
        if bodies is None:
            return np.ones(len(rows)), np.arange(len(rows))
        verdict = np.empty(len(rows), np.uint8)

        def judged(k: int) -> None:
            part = slice(k, k + CHUNK)
            judge(one, two, rows[part], columns[part], bodies.starts, bodies.solid, bodies.exact, verdict[part])

        list(self.pool.map(judged, range(0, len(rows), CHUNK)))
        return (verdict != HIDDEN).astype(np.float64), np.flatnonzero(verdict == ASK)

    def from_points(
        self, points: Float, ways: Float, patches: Patches, rows: Int, columns: Int, dim: NDArray[np.bool_]
    ) -> Float:
        """The share of the form factor from points[rows], with normals ``ways``, to patches[columns] that is seen.
        Those from which little light comes (``dim``) get fewer rays."""
        reach = self.bodies.reach(points[:, None]) if self.bodies is not None else None
        result, asked = self._judged(reach, self._reach_of(patches.rings), rows, columns)
        few, many = asked[dim[asked]], asked[~dim[asked]]
        points, rings = points - self.middle, patches.rings - self.middle
        work = [(few[k : k + CHUNK], FEW_RAYS, 0) for k in range(0, len(few), CHUNK)]
        work += [(many[k : k + CHUNK], POINT_RAYS, MORE) for k in range(0, len(many), CHUNK)]

        def one(chunk: Int, count: int, more: int) -> Float:
            seen, total = np.zeros(len(chunk)), np.zeros(len(chunk))
            arrays = (points, ways, rows[chunk], rings, patches.counts, patches.normal, columns[chunk])
            self._send(arrays, 0, count, count, seen, total)
            mixed = np.flatnonzero((seen > 0.0) & (seen < total))
            if more and len(mixed):
                arrays = (*arrays[:2], rows[chunk[mixed]], *arrays[3:6], columns[chunk[mixed]])
                seen_more, total_more = np.zeros(len(mixed)), np.zeros(len(mixed))
                self._send(arrays, count, more, count, seen_more, total_more)
                seen[mixed] += seen_more
                total[mixed] += total_more
            return np.divide(seen, total, out=np.zeros_like(seen), where=total > 0.0)

        for (chunk, _, _), values in zip(work, self.pool.map(lambda task: one(*task), work), strict=True):
            result[chunk] = values
        return result

    def _send(self, arrays: Any, first: int, count: int, group: int, seen: Float, total: Float) -> None:
        origins, ways, weights = self._room(len(seen) * count)
        points, normals, rows, rings, counts, facing, columns = arrays
        rays_from_points(
            points, normals, rows, rings, counts, facing, columns, self.gap, first, count, origins, ways, weights
        )
        add_seen(weights, self.blocked(origins, ways), count, group, first > 0, seen, total)

    def _chunk(self, rings: Float, counts: Int, normals: Float, pairs: Int) -> Float:
        seen, total = np.zeros(len(pairs)), np.zeros(len(pairs))
        times = 2 if len(rings) < FEW else 1
        group = times * FIRST
        self._shoot(rings, counts, normals, pairs, 0, group, group, seen, total)
        mixed = np.flatnonzero((seen > 0.0) & (seen < total))
        if len(mixed):
            more, of = np.zeros(len(mixed)), np.zeros(len(mixed))
            self._shoot(rings, counts, normals, pairs[mixed], group, times * MORE, group, more, of)
            seen[mixed] += more
            total[mixed] += of
        return np.divide(seen, total, out=np.zeros_like(seen), where=total > 0.0)

    def _shoot(
        self, rings: Float, counts: Int, normals: Float, pairs: Int, first: int, count: int, group: int, seen: Float,
        total: Float,
    ) -> None:  # fmt: skip
        origins, ways, weights = self._room(len(pairs) * count)
        rays_between(rings, counts, normals, pairs, TABLE, self.gap, first, count, origins, ways, weights)
        add_seen(weights, self.blocked(origins, ways), count, group, first > 0, seen, total)

    def _room(self, size: int) -> tuple[NDArray[np.float32], NDArray[np.float32], Float]:
        """Arrays for so many rays: each thread's own, again and again."""
        kept = getattr(self.local, "room", None)
        if kept is None or len(kept[2]) < size:
            kept = np.empty((size, 3), np.float32), np.empty((size, 3), np.float32), np.empty(size)
            self.local.room = kept
        return kept[0][:size], kept[1][:size], kept[2][:size]
