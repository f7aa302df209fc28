"""How much of one patch another one sees: rays between low-discrepancy points, against the original polygons.

The share of a pair's form factor that is not blocked is sum w V / sum w, over rays with the kernel's weights
w = cos(theta_1) cos(theta_2) / r^2.  Sixteen rays first; where they disagree, 48 more.  The points depend on the pair
alone, so results are the same however many threads work.  Of few patches, all large, each pair gets twice as many.
"""

from __future__ import annotations

import os
import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.kernels import jit
from glsim.radiosity.patches import Patches
from glsim.radiosity.scene import Scene, area_of, normal_of

Float = NDArray[np.float64]
Int = NDArray[np.int64]
FIRST, MORE = 16, 48  # rays of a pair
FEW = 1000  # patches, of which each pair gets twice as many
POINT_RAYS = 8  # from a vertex to a patch, before MORE
FEW_RAYS = 2  # from a vertex to a patch that sends little
CHUNK = 1 << 12  # pairs at a time, in each thread
GAP = 1e-5  # of the scene's size, left out at both ends of a ray, so that it does not meet the patches themselves

# Fractional parts of k times these are evenly spread over the four-dimensional cube (Roberts 2018).
_ROOT = 1.1673039782614187  # x^5 = x + 1
TABLE = np.outer(np.arange(2 * (FIRST + MORE)), [_ROOT**-k for k in range(1, 5)]) % 1.0


@jit
def _off(squared: float, gap: float) -> float:
    """How much of a ray is left out at either end."""
    return float(min(gap / np.sqrt(squared), 0.5)) if squared > 0.0 else 0.5


@jit
def _rays(
    rings: Any, counts: Any, normals: Any, pairs: Any, table: Any, gap: float, first: int, count: int, origins: Any,
    ways: Any, weights: Any,
) -> None:  # fmt: skip
    """Rays first .. first + count of each pair: origins, ways (count per pair, 3) float32, and weights.

    table: where each ray begins and ends, (rays, 4) in [0, 1), shifted for each pair.
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
        o_0, o_u, o_v = _edges(rings[i], counts[i], normals[i], e[0])
        t_0, t_x, t_y = _edges(rings[j], counts[j], normals[j], e[1])
        one, two = counts[i] == 3, counts[j] == 3
        (ax, ay, az), (bx, by, bz), (cx, cy, cz), (dx, dy, dz) = e[0]
        (fx, fy, fz), (gx, gy, gz), (hx, hy, hz), (kx, ky, kz) = e[1]
        (mx, my, mz), (nx, ny, nz) = normals[i], normals[j]
        fx, fy, fz = fx - ax, fy - ay, fz - az
        for s in range(count):  # written out: this is where the time goes
            u, v = table[first + s, 0] + shift[0], table[first + s, 1] + shift[1]
            x, y = table[first + s, 2] + shift[2], table[first + s, 3] + shift[3]
            u, v = u - (u >= 1.0), v - (v >= 1.0)
            x, y = x - (x >= 1.0), y - (y >= 1.0)
            if one and u + v > 1.0:
                u, v = 1.0 - u, 1.0 - v
            if two and x + y > 1.0:
                x, y = 1.0 - x, 1.0 - y
            uv, xy = u * v, x * y
            px, py, pz = u * bx + v * cx + uv * dx, u * by + v * cy + uv * dy, u * bz + v * cz + uv * dz
            wx = fx + x * gx + y * hx + xy * kx - px
            wy = fy + x * gy + y * hy + xy * ky - py
            wz = fz + x * gz + y * hz + xy * kz - pz
            squared = wx * wx + wy * wy + wz * wz
            c_1, c_2 = wx * mx + wy * my + wz * mz, -(wx * nx + wy * ny + wz * nz)
            at = row * count + s
            off = _off(squared, gap)
            origins[at, 0] = ax + px + off * wx
            origins[at, 1] = ay + py + off * wy
            origins[at, 2] = az + pz + off * wz
            ways[at, 0] = (1.0 - 2.0 * off) * wx
            ways[at, 1] = (1.0 - 2.0 * off) * wy
            ways[at, 2] = (1.0 - 2.0 * off) * wz
            density = (o_0 + u * o_u + v * o_v) * (t_0 + x * t_x + y * t_y)
            weights[at] = density * c_1 * c_2 / (squared * squared) if c_1 > 0.0 and c_2 > 0.0 else 0.0


@jit
def _edges(ring: Any, count: int, n: Any, e: Any) -> tuple[float, float, float]:
    """A patch as e_0 + u e_1 + v e_2 + u v e_3; a, b, c of its area for each unit of u and v, a + b u + c v."""
    for k in range(3):
        e[0, k], e[1, k] = ring[0, k], ring[1, k] - ring[0, k]
        if count == 3:
            e[2, k], e[3, k] = ring[2, k] - ring[0, k], 0.0
        else:
            e[2, k] = ring[3, k] - ring[0, k]
            e[3, k] = ring[2, k] - ring[1, k] - e[2, k]
    return _triple(n, e[1], e[2]), _triple(n, e[1], e[3]), _triple(n, e[3], e[2])


@jit
def _triple(n: Any, a: Any, b: Any) -> float:
    """n . (a x b)"""
    return float(
        n[0] * (a[1] * b[2] - a[2] * b[1]) + n[1] * (a[2] * b[0] - a[0] * b[2]) + n[2] * (a[0] * b[1] - a[1] * b[0])
    )


@jit
def _point_rays(
    points: Any, normals: Any, rows: Any, rings: Any, counts: Any, facing: Any, columns: Any, gap: float, first: int,
    count: int, origins: Any, ways: Any, weights: Any,
) -> None:  # fmt: skip
    """Rays from points to low-discrepancy points of patches (the two-dimensional sequence)."""
    q, e = np.empty(3), np.empty((4, 3))
    for row in range(len(rows)):
        v, j = rows[row], columns[row]
        t_0, t_x, t_y = _edges(rings[j], counts[j], facing[j], e)
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
            off = _off(squared, gap)
            for k in range(3):
                way = q[k] - points[v, k]
                origins[at, k] = points[v, k] + off * way
                ways[at, k] = (1.0 - 2.0 * off) * way
            density = t_0 + x * t_x + y * t_y
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


SEEN, ASK, HIDDEN = 1, 2, 0  # what the bodies alone tell of a pair


@jit
def judge(one: Any, two: Any, rows: Any, columns: Any, starts: Any, solid: Any, out: Any) -> None:
    """What convex bodies tell of pairs, by the hull of both ends: SEEN if it misses all bodies, HIDDEN if all of it
    goes through one that is ``solid`` (k,), else ASK.

    one, two: (n, m, 2), see Bodies.reach, of the ends ``rows`` and ``columns``; starts: (k + 1,), body b has the planes
    starts[b] to starts[b + 1].  At t between the ends the least distance from a plane is (1 - t) a + t b exactly.
    """
    for row in range(len(rows)):
        i, j = rows[row], columns[row]
        out[row] = SEEN
        for b in range(len(solid)):
            enter = enter_whole = 0.0
            leave = leave_whole = 1.0
            for m in range(starts[b], starts[b + 1]):
                enter, leave = _behind(one[i, m, 0], two[j, m, 0], enter, leave)
                if leave - enter < TOUCH:
                    break
                enter_whole, leave_whole = _behind(one[i, m, 1], two[j, m, 1], enter_whole, leave_whole)
            if leave - enter >= TOUCH:
                between = enter_whole > TOUCH and leave_whole < 1.0 - TOUCH  # and not on the body itself
                if solid[b] and between and leave_whole - enter_whole >= TOUCH:
                    out[row] = HIDDEN
                    break
                out[row] = ASK


@jit
def _behind(a: float, b: float, enter: float, leave: float) -> tuple[float, float]:
    """Where between enter and leave (1 - t) a + t b is at most 0."""
    if a > 0.0:
        return (max(enter, a / (a - b)), leave) if b < 0.0 else (1.0, 0.0)
    return (enter, min(leave, a / (a - b))) if b > 0.0 else (enter, leave)


@dataclass(frozen=True)
class Bodies:
    """Convex bodies outside of which nothing can stand in between.

    planes: (m, 4), a body is where n.p <= d for all of its (n, d); starts: (k + 1,), where each body's begin; solid:
    (k,), whether nothing goes through without meeting a polygon.
    """

    planes: Float
    starts: Int
    solid: NDArray[np.bool_]

    def reach(self, corners: Float) -> NDArray[np.float32]:
        """How far in front of each plane what has these corners (n, c, 3) is: least and most, (n, m, 2)."""
        result = np.empty((len(corners), len(self.planes), 2), np.float32)
        for first in range(0, len(corners), CHUNK):
            away = corners[first : first + CHUNK] @ self.planes[:, :3].T - self.planes[:, 3]
            result[first : first + CHUNK, :, 0] = away.min(axis=1)
            result[first : first + CHUNK, :, 1] = away.max(axis=1)
        return result


MOST_BODIES, MOST_PLANES = 48, 24  # more are not worth asking
TOUCH = 1e-6  # of the way between two ends: what is shorter only touches
THIN = 1e-4  # of the scene's size: thinner bodies are taken a little thicker


def bodies_of(scene: Scene) -> Bodies | None:
    """The bodies of a scene; None if they are too many to be of use.

    Polygons that have the whole scene on their front side are its shell, which blocks nothing.  The others form bodies
    by common corners.  A convex one is the space behind its own polygons; of another the box around it is taken.
    """
    if len(scene.rings) > 4000:
        return None
    points = np.concatenate(scene.rings)
    tolerance = THIN * scene.size
    inner = [ring for ring in scene.rings if ((points - ring[0]) @ normal_of(ring)).min() < -tolerance]
    groups = _connected(inner, tolerance)
    if len(groups) > MOST_BODIES:
        return None
    planes, starts, solid = [np.zeros((0, 4))], [0], []
    for rings in groups:
        found, own = _box_planes(rings), _own_planes(rings, tolerance)
        convex = own is not None and len(found) + len(own) <= MOST_PLANES
        if own is not None and convex:
            found = np.concatenate([found, own])
        within = np.concatenate(rings) @ found[:, :3].T
        if float((found[:, 3] - within.min(axis=0)).min()) < tolerance:
            found = found + np.array([0.0, 0.0, 0.0, tolerance / 10.0])
        planes.append(found)
        starts.append(starts[-1] + len(found))
        solid.append(convex and _closed_but_for_a_plane(rings, tolerance))
    return Bodies(np.concatenate(planes), np.array(starts), np.array(solid, np.bool_))


def _connected(rings: list[Float], tolerance: float) -> list[list[Float]]:
    """Polygons that have corners in common."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    if not rings:
        return []
    corners = np.round(np.concatenate(rings) / tolerance).astype(np.int64)
    _, corner = np.unique(corners, axis=0, return_inverse=True)
    owner = np.repeat(np.arange(len(rings)), [len(ring) for ring in rings])
    n = len(rings)
    graph = coo_matrix((np.ones(len(owner)), (owner, n + corner.ravel())), shape=(n + len(corners),) * 2)
    _, label = connected_components(graph, directed=False)
    groups: dict[int, list[Float]] = {}
    for ring, number in zip(rings, label[:n].tolist(), strict=True):
        groups.setdefault(number, []).append(ring)
    return list(groups.values())


def _box_planes(rings: list[Float]) -> Float:
    """The box along the largest polygon's normal and longest edge: six planes (n, d)."""
    largest = max(rings, key=area_of)
    edges = np.roll(largest, -1, axis=0) - largest
    x = edges[np.argmax(np.linalg.norm(edges, axis=1))]
    x = x / np.linalg.norm(x)
    z = normal_of(largest)
    axes = np.stack([x, np.cross(z, x), z])
    inside = np.concatenate(rings) @ axes.T
    high, low = np.c_[axes, inside.max(axis=0)], np.c_[-axes, -inside.min(axis=0)]
    return np.concatenate([high, low])


def _own_planes(rings: list[Float], tolerance: float) -> Float | None:
    """The planes of the polygons, if all corners are behind all of them."""
    normals = np.array([normal_of(ring) for ring in rings])
    planes = np.c_[normals, np.einsum("nk,nk->n", normals, np.array([ring[0] for ring in rings]))]
    planes = planes[np.unique(np.round(planes / (1.0, 1.0, 1.0, 100 * tolerance), 4), axis=0, return_index=True)[1]]
    beyond = np.concatenate(rings) @ planes[:, :3].T - planes[:, 3]
    return planes if beyond.max() < tolerance else None


def _closed_but_for_a_plane(rings: list[Float], tolerance: float) -> bool:
    """Whether a convex body has no hole, or one flat hole: then whatever goes through it meets a polygon."""
    ends: dict[frozenset[tuple[float, ...]], list[Float]] = {}
    for ring in rings:
        for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
            key = frozenset(tuple(np.round(p / tolerance).tolist()) for p in (a, b))
            ends.setdefault(key, []).append(np.array([a, b]))
    rim = [edges[0] for edges in ends.values() if len(edges) == 1]
    if not rim:
        return True
    points = np.concatenate(rim)
    return bool(np.linalg.svd(points - points.mean(axis=0), compute_uv=False)[-1] < tolerance * len(points))


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
            judge(one, two, rows[part], columns[part], bodies.starts, bodies.solid, verdict[part])

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
            self._send(arrays, 0, count, seen, total)
            mixed = np.flatnonzero((seen > 0.0) & (seen < total))
            if more and len(mixed):
                arrays = (*arrays[:2], rows[chunk[mixed]], *arrays[3:6], columns[chunk[mixed]])
                seen_more, total_more = np.zeros(len(mixed)), np.zeros(len(mixed))
                self._send(arrays, count, more, seen_more, total_more)
                seen[mixed] += seen_more
                total[mixed] += total_more
            return np.divide(seen, total, out=np.zeros_like(seen), where=total > 0.0)

        for (chunk, _, _), values in zip(work, self.pool.map(lambda task: one(*task), work), strict=True):
            result[chunk] = values
        return result

    def _send(self, arrays: Any, first: int, count: int, seen: Float, total: Float) -> None:
        origins, ways, weights = self._room(len(seen) * count)
        points, normals, rows, rings, counts, facing, columns = arrays
        _point_rays(
            points, normals, rows, rings, counts, facing, columns, self.gap, first, count, origins, ways, weights
        )
        _add(weights, self.blocked(origins, ways), count, seen, total)

    def _chunk(self, rings: Float, counts: Int, normals: Float, pairs: Int) -> Float:
        seen, total = np.zeros(len(pairs)), np.zeros(len(pairs))
        times = 2 if len(rings) < FEW else 1
        self._shoot(rings, counts, normals, pairs, 0, times * FIRST, seen, total)
        mixed = np.flatnonzero((seen > 0.0) & (seen < total))
        if len(mixed):
            more, of = np.zeros(len(mixed)), np.zeros(len(mixed))
            self._shoot(rings, counts, normals, pairs[mixed], times * FIRST, times * MORE, more, of)
            seen[mixed] += more
            total[mixed] += of
        return np.divide(seen, total, out=np.zeros_like(seen), where=total > 0.0)

    def _shoot(
        self, rings: Float, counts: Int, normals: Float, pairs: Int, first: int, count: int, seen: Float, total: Float
    ) -> None:
        origins, ways, weights = self._room(len(pairs) * count)
        _rays(rings, counts, normals, pairs, TABLE, self.gap, first, count, origins, ways, weights)
        _add(weights, self.blocked(origins, ways), count, seen, total)

    def _room(self, size: int) -> tuple[NDArray[np.float32], NDArray[np.float32], Float]:
        """Arrays for so many rays: each thread's own, again and again."""
        kept = getattr(self.local, "room", None)
        if kept is None or len(kept[2]) < size:
            kept = np.empty((size, 3), np.float32), np.empty((size, 3), np.float32), np.empty(size)
            self.local.room = kept
        return kept[0][:size], kept[1][:size], kept[2][:size]
