"""How much of one patch another one sees: rays between low-discrepancy points, against the original polygons.

The share of a pair's form factor that is not blocked is sum w V / sum w, over rays with the kernel's weights
w = cos(theta_1) cos(theta_2) / r^2.  Sixteen rays first; where they disagree, 48 more.  The points depend on the pair
alone, so results are the same however many threads work.
"""

from __future__ import annotations

import os
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.kernels import jit
from glsim.radiosity.patches import Patches
from glsim.radiosity.scene import Scene, area_of, normal_of

Float = NDArray[np.float64]
Int = NDArray[np.int64]
FIRST, MORE = 16, 48  # rays of a pair
POINT_RAYS = 8  # from a vertex to a patch, before MORE
CHUNK = 1 << 14  # pairs at a time, in each thread
SHORTEN = 1e-4  # of a ray, at both ends, so that it does not meet the patches themselves

# Fractional parts of k times these are evenly spread over the four-dimensional cube (Roberts 2018).
_ROOT = 1.1673039782614187  # x^5 = x + 1
TABLE = np.outer(np.arange(FIRST + MORE), [_ROOT**-k for k in range(1, 5)]) % 1.0


@jit
def _rays(
    rings: Any, counts: Any, normals: Any, pairs: Any, table: Any, first: int, count: int, origins: Any, ways: Any,
    weights: Any,
) -> None:  # fmt: skip
    """Rays first .. first + count of each pair: origins, ways (count per pair, 3) float32, and weights.

    table: where each ray begins and ends, (FIRST + MORE, 4) in [0, 1), shifted for each pair.
    """
    e, shift = np.empty((2, 4, 3)), np.empty(4)
    for row in range(len(pairs)):
        i, j = pairs[row, 0], pairs[row, 1]
        seed = np.uint64(i) * np.uint64(0x9E3779B97F4A7C15) + np.uint64(j) * np.uint64(0xC2B2AE3D27D4EB4F)
        for k in range(4):  # splitmix64
            seed = seed + np.uint64(0x9E3779B97F4A7C15)
            z = seed
            z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
            z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
            z = z ^ (z >> np.uint64(31))
            shift[k] = float(z >> np.uint64(11)) / 9007199254740992.0
        even = _edges(rings[i], counts[i], e[0])
        even &= _edges(rings[j], counts[j], e[1])
        for s in range(count):
            u, v = table[first + s, 0] + shift[0], table[first + s, 1] + shift[1]
            x, y = table[first + s, 2] + shift[2], table[first + s, 3] + shift[3]
            u, v = u - (u >= 1.0), v - (v >= 1.0)
            x, y = x - (x >= 1.0), y - (y >= 1.0)
            if counts[i] == 3 and u + v > 1.0:
                u, v = 1.0 - u, 1.0 - v
            if counts[j] == 3 and x + y > 1.0:
                x, y = 1.0 - x, 1.0 - y
            squared = c_1 = c_2 = 0.0
            at = row * count + s
            for k in range(3):
                p = e[0, 0, k] + u * e[0, 1, k] + v * (e[0, 2, k] + u * e[0, 3, k])
                way = e[1, 0, k] + x * e[1, 1, k] + y * (e[1, 2, k] + x * e[1, 3, k]) - p
                squared += way * way
                c_1 += way * normals[i, k]
                c_2 -= way * normals[j, k]
                origins[at, k] = p + SHORTEN * way
                ways[at, k] = (1.0 - 2.0 * SHORTEN) * way
            weight = max(c_1, 0.0) * max(c_2, 0.0) / (squared * squared) if squared > 0.0 else 0.0
            if not even:
                weight *= _density(rings[i], counts[i], u, v) * _density(rings[j], counts[j], x, y)
            weights[at] = weight


@jit
def _edges(ring: Any, count: int, e: Any) -> bool:
    """A patch as e_0 + u e_1 + v e_2 + u v e_3; whether its points lie equally dense."""
    size = bend = 0.0
    for k in range(3):
        e[0, k], e[1, k] = ring[0, k], ring[1, k] - ring[0, k]
        if count == 3:
            e[2, k], e[3, k] = ring[2, k] - ring[0, k], 0.0
        else:
            e[2, k] = ring[3, k] - ring[0, k]
            e[3, k] = ring[2, k] - ring[1, k] - e[2, k]
        size += e[1, k] * e[1, k] + e[2, k] * e[2, k]
        bend += e[3, k] * e[3, k]
    return bool(bend <= 1e-12 * size)


@jit
def _point_rays(
    points: Any, normals: Any, rows: Any, rings: Any, counts: Any, facing: Any, columns: Any, first: int, count: int,
    origins: Any, ways: Any, weights: Any,
) -> None:  # fmt: skip
    """Rays from points to low-discrepancy points of patches (the two-dimensional sequence)."""
    q = np.empty(3)
    for row in range(len(rows)):
        v, j = rows[row], columns[row]
        for s in range(count):
            x, y = 0.5 + (first + s) * 0.7548776662466927, 0.5 + (first + s) * 0.5698402909980532
            x, y = x - np.floor(x), y - np.floor(y)
            _point(rings[j], counts[j], x, y, q)
            squared = c_1 = c_2 = 0.0
            at = row * count + s
            for k in range(3):
                way = q[k] - points[v, k]
                squared += way * way
                c_1 += way * normals[v, k]
                c_2 -= way * facing[j, k]
                origins[at, k] = points[v, k] + SHORTEN * way
                ways[at, k] = (1.0 - 2.0 * SHORTEN) * way
            density = _density(rings[j], counts[j], x, y)
            weights[at] = density * max(c_1, 0.0) * max(c_2, 0.0) / (squared * squared) if squared > 0.0 else 0.0


@jit
def _point(ring: Any, count: int, u: float, v: float, out: Any) -> None:
    """A point of a quad (bilinear) or of a triangle (folded)."""
    if count == 3:
        if u + v > 1.0:
            u, v = 1.0 - u, 1.0 - v
        for k in range(3):
            out[k] = ring[0, k] + u * (ring[1, k] - ring[0, k]) + v * (ring[2, k] - ring[0, k])
    else:
        for k in range(3):
            a = ring[0, k] + u * (ring[1, k] - ring[0, k])
            b = ring[3, k] + u * (ring[2, k] - ring[3, k])
            out[k] = a + v * (b - a)


@jit
def _add(weights: Any, hit: Any, count: int, seen: Any, total: Any) -> None:
    for row in range(len(seen)):
        for s in range(count):
            w = weights[row * count + s]
            total[row] += w
            if hit[row * count + s] < 0:
                seen[row] += w


@jit
def may_be_blocked(centers: Any, radii: Any, pairs: Any, boxes: Any, out: Any) -> None:
    """Whether the capsule around two patches meets any of the oriented boxes (k, 5, 3): centre, axes, half sizes."""
    for row in range(len(pairs)):
        i, j = pairs[row, 0], pairs[row, 1]
        r = max(radii[i], radii[j])
        out[row] = False
        for b in range(len(boxes)):
            enter, leave = 0.0, 1.0
            for axis in range(3):
                start = along = 0.0
                for k in range(3):
                    start += boxes[b, 1 + axis, k] * (centers[i, k] - boxes[b, 0, k])
                    along += boxes[b, 1 + axis, k] * (centers[j, k] - centers[i, k])
                half = boxes[b, 4, axis] + r
                if along == 0.0:
                    if abs(start) > half:
                        leave = -1.0
                else:
                    t_0, t_1 = (-half - start) / along, (half - start) / along
                    enter, leave = max(enter, min(t_0, t_1)), min(leave, max(t_0, t_1))
                if enter > leave:
                    break
            if enter <= leave:
                out[row] = True
                break


@jit
def _density(ring: Any, count: int, u: float, v: float) -> float:
    """Area for each unit of u and v at a point of a patch."""
    if count == 3:
        return 1.0
    x, y = np.empty(3), np.empty(3)
    for k in range(3):
        x[k] = (1.0 - v) * (ring[1, k] - ring[0, k]) + v * (ring[2, k] - ring[3, k])
        y[k] = (1.0 - u) * (ring[3, k] - ring[0, k]) + u * (ring[2, k] - ring[1, k])
    a, b, c = x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]
    return float(np.sqrt(a * a + b * b + c * c))


def boxes_of(scene: Scene) -> Float:
    """Oriented boxes (k, 5, 3) around the bodies in a scene that can stand between others: (0, 5, 3) if there are none.

    Polygons that have the whole scene on their front side are its shell, which blocks nothing.  The others form bodies
    by common corners.
    """
    points = np.concatenate(scene.rings)
    tolerance = 1e-4 * scene.size
    inner = [ring for ring in scene.rings if ((points - ring[0]) @ normal_of(ring)).min() < -tolerance]
    body: dict[tuple[float, ...], int] = {}
    bodies: list[list[Float]] = []
    for ring in inner:
        keys = [tuple(row) for row in np.round(ring / tolerance).tolist()]
        touched = sorted({body[key] for key in keys if key in body})
        number = touched[0] if touched else len(bodies)
        if not touched:
            bodies.append([])
        bodies[number].append(ring)
        for other in touched[1:]:
            bodies[number] += bodies[other]
            bodies[other] = []
            body = {key: number if value == other else value for key, value in body.items()}
        body.update(dict.fromkeys(keys, number))
    boxes = [_box_around(rings) for rings in bodies if rings]
    return np.array(boxes) if boxes else np.empty((0, 5, 3))


def _box_around(rings: list[Float]) -> Float:
    """The box along the largest polygon's normal and longest edge."""
    largest = max(rings, key=area_of)
    edges = np.roll(largest, -1, axis=0) - largest
    x = edges[np.argmax(np.linalg.norm(edges, axis=1))]
    x = x / np.linalg.norm(x)
    z = normal_of(largest)
    axes = np.stack([x, np.cross(z, x), z])
    inside = np.concatenate(rings) @ axes.T
    low, high = inside.min(axis=0), inside.max(axis=0)
    return np.concatenate([[(low + high) / 2.0 @ axes], axes, [(high - low) / 2.0]])


MOST_BOXES = 48  # more are not worth asking


class Visibility:
    """Rays against the triangles of a scene.

    Outside of ``boxes`` (see ``boxes_of``) nothing can block; None if they are too many to be of use.
    """

    def __init__(self, scene: Scene, threads: int | None = None) -> None:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene

        self.scene: Any = EmbreeScene()
        self.mesh = TriangleMesh(self.scene, np.ascontiguousarray(scene.triangles(), np.float32))
        boxes = boxes_of(scene) if len(scene.rings) < 4000 else None
        self.boxes = boxes if boxes is not None and len(boxes) <= MOST_BOXES else None
        self.local = threading.local()
        self.pool = ThreadPoolExecutor(threads or os.cpu_count() or 1)
        self.scene.run(np.zeros((1, 3), np.float32), np.ones((1, 3), np.float32))  # builds Embree's tree, once

    def blocked(self, origins: NDArray[np.float32], ways: NDArray[np.float32]) -> NDArray[np.int32]:
        """For each ray, from an origin along the whole of its way: -1 if nothing is hit."""
        return np.asarray(self.scene.run(origins, ways, dists=self._ones(len(origins)), query="OCCLUDED"))

    def _ones(self, size: int) -> NDArray[np.float32]:
        """How far rays go: the whole way.  Embree writes into it."""
        kept = getattr(self.local, "ones", None)
        if kept is None or len(kept) < size:
            kept = self.local.ones = np.empty(size, np.float32)
        kept[:size] = 1.0
        return np.asarray(kept[:size])

    def fractions(self, rings: Float, counts: Int, normals: Float, centers: Float, radii: Float, pairs: Int) -> Float:
        """The share of the form factor of each pair (k, 2) that is not blocked, (k,) in [0, 1]."""
        result = np.ones(len(pairs))
        asked = np.arange(len(pairs))
        if self.boxes is not None:
            possible = np.zeros(len(pairs), np.bool_)
            may_be_blocked(centers, radii, pairs, self.boxes, possible)
            asked = np.flatnonzero(possible)
        chunks = [asked[k : k + CHUNK] for k in range(0, len(asked), CHUNK)]
        work = self.pool.map(lambda chunk: self._chunk(rings, counts, normals, pairs[chunk]), chunks)
        for chunk, values in zip(chunks, work, strict=True):
            result[chunk] = values
        return result

    def from_points(self, points: Float, ways: Float, patches: Patches, rows: Int, columns: Int) -> Float:
        """The share of the form factor from points[rows], with normals ``ways``, to patches[columns] that is seen."""
        result = np.ones(len(rows))
        asked = np.arange(len(rows))
        if self.boxes is not None:
            centers = np.concatenate([points, patches.center])
            radii = np.concatenate([np.zeros(len(points)), patches.size / 2.0])
            possible = np.zeros(len(rows), np.bool_)
            may_be_blocked(centers, radii, np.stack([rows, columns + len(points)], axis=1), self.boxes, possible)
            asked = np.flatnonzero(possible)
        chunks = [asked[k : k + CHUNK] for k in range(0, len(asked), CHUNK)]

        def one(chunk: Int) -> Float:
            seen, total = np.zeros(len(chunk)), np.zeros(len(chunk))
            arrays = (points, ways, rows[chunk], patches.rings, patches.counts, patches.normal, columns[chunk])
            self._send(arrays, 0, POINT_RAYS, seen, total)
            mixed = np.flatnonzero((seen > 0.0) & (seen < total))
            if len(mixed):
                arrays = (*arrays[:2], rows[chunk[mixed]], *arrays[3:6], columns[chunk[mixed]])
                more, of = np.zeros(len(mixed)), np.zeros(len(mixed))
                self._send(arrays, POINT_RAYS, MORE, more, of)
                seen[mixed] += more
                total[mixed] += of
            return np.divide(seen, total, out=np.zeros_like(seen), where=total > 0.0)

        for chunk, values in zip(chunks, self.pool.map(one, chunks), strict=True):
            result[chunk] = values
        return result

    def _send(self, arrays: Any, first: int, count: int, seen: Float, total: Float) -> None:
        origins, ways, weights = self._room(len(seen) * count)
        points, normals, rows, rings, counts, facing, columns = arrays
        _point_rays(points, normals, rows, rings, counts, facing, columns, first, count, origins, ways, weights)
        _add(weights, self.blocked(origins, ways), count, seen, total)

    def _chunk(self, rings: Float, counts: Int, normals: Float, pairs: Int) -> Float:
        seen, total = np.zeros(len(pairs)), np.zeros(len(pairs))
        self._shoot(rings, counts, normals, pairs, 0, FIRST, seen, total)
        mixed = np.flatnonzero((seen > 0.0) & (seen < total))
        if len(mixed):
            more, of = np.zeros(len(mixed)), np.zeros(len(mixed))
            self._shoot(rings, counts, normals, pairs[mixed], FIRST, MORE, more, of)
            seen[mixed] += more
            total[mixed] += of
        return np.divide(seen, total, out=np.zeros_like(seen), where=total > 0.0)

    def _shoot(
        self, rings: Float, counts: Int, normals: Float, pairs: Int, first: int, count: int, seen: Float, total: Float
    ) -> None:
        origins, ways, weights = self._room(len(pairs) * count)
        _rays(rings, counts, normals, pairs, TABLE, first, count, origins, ways, weights)
        _add(weights, self.blocked(origins, ways), count, seen, total)

    def _room(self, size: int) -> tuple[NDArray[np.float32], NDArray[np.float32], Float]:
        """Arrays for so many rays: each thread's own, again and again."""
        kept = getattr(self.local, "room", None)
        if kept is None or len(kept[2]) < size:
            kept = np.empty((size, 3), np.float32), np.empty((size, 3), np.float32), np.empty(size)
            self.local.room = kept
        return kept[0][:size], kept[1][:size], kept[2][:size]
