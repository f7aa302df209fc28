"""Breaking the scene into patches: quads where that is possible, cut along the lines where other polygons touch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import Scene, SceneError, area_of, normal_of

Float = NDArray[np.float64]
Int = NDArray[np.int64]
TOUCHING = 1e-6  # of the scene's size: this near, polygons touch
SLIVER = 1e-3  # of a whole patch's area: smaller pieces are left out


@dataclass(frozen=True)
class Patches:
    """n patches, convex and planar with three or four corners.

    rings: (n, 4, 3), a triangle repeats its last corner; counts: (n,) 3 or 4; polygon: (n,) number in scene.rings.
    area, center (n, 3), normal (n, 3), size (n,): diameter; rho, E: (n, 3).
    """

    scene: Scene
    rings: Float
    counts: Int
    polygon: Int
    area: Float
    center: Float
    normal: Float
    size: Float
    rho: Float
    E: Float

    def __len__(self) -> int:
        return len(self.rings)

    def triangles(self) -> tuple[Float, Int]:
        """Triangles (m, 3, 3), and the patch of each (m,)."""
        quads = np.flatnonzero(self.counts == 4)
        first, second = self.rings[:, [0, 1, 2]], self.rings[quads][:, [0, 2, 3]]
        return np.concatenate([first, second]), np.concatenate([np.arange(len(self)), quads])


def patches_of(scene: Scene, rings: list[Float], polygon: list[int]) -> Patches:
    """Patches from their rings and the polygons these are parts of."""
    n = len(rings)
    whole = np.empty((n, 4, 3))
    for k, ring in enumerate(rings):
        whole[k, : len(ring)] = ring
        whole[k, len(ring) :] = ring[-1]
    counts = np.array([len(ring) for ring in rings])
    area = np.array([area_of(ring) for ring in rings])
    center = np.array([_centroid(ring) for ring in rings])
    normals = np.array([normal_of(ring) for ring in scene.rings])
    size = 2.0 * np.linalg.norm(whole - center[:, None], axis=2).max(axis=1)
    materials = [scene.materials[scene.material[p]] for p in polygon]
    rho, E = (np.array([getattr(m, name) for m in materials], np.float64) for name in ("rho", "E"))
    of = np.array(polygon, np.int64)
    return Patches(scene, whole, counts, of, area, center, normals[of], size, rho, E)


def _centroid(ring: Float) -> Float:
    if len(ring) == 3:
        return np.asarray(ring.mean(axis=0))
    parts = [ring[[0, 1, 2]], ring[[0, 2, 3]]]
    weights = [area_of(part) for part in parts]
    return np.asarray(np.average([part.mean(axis=0) for part in parts], axis=0, weights=weights))


def subdivide(scene: Scene, count: int = 2000, length: float | None = None) -> Patches:
    """Patches with edges of about ``length``, or about ``count`` patches altogether.

    Raises SceneError for a count or length that cannot be.
    """
    if length is None:
        if count < 1:
            raise SceneError(f"--patches: at least 1 patch is needed, not {count}")
        length = _length_for(scene, count)
    if not length > 0.0:
        raise SceneError(f"the length of patches must be more than 0, not {length}")
    cuts = _contacts(scene)
    rings: list[Float] = []
    polygon: list[int] = []
    for number, ring in enumerate(scene.rings):
        segments = cuts.get(number, [])
        for cell in _cells(ring, length):
            whole = area_of(cell)
            for piece in _cut(cell, segments, normal_of(ring), scene.size):
                if area_of(piece) > SLIVER * whole:
                    rings.append(piece)
                    polygon.append(number)
    return _exposed(patches_of(scene, rings, polygon))


def _length_for(scene: Scene, count: int) -> float:
    """The length at which the grids have about ``count`` cells."""

    def cells(length: float) -> int:
        return sum(_number_of_cells(ring, length) for ring in scene.rings)

    short, long = 1e-4 * scene.size, 2.0 * scene.size
    for _ in range(60):
        middle = (short * long) ** 0.5
        short, long = (short, middle) if cells(middle) <= count else (middle, long)
    return long


def _steps(ring: Float, length: float) -> tuple[int, int]:
    """How many cells along the first and second edge of a quad."""
    edges = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)
    along, across = (edges[0] + edges[2]) / 2.0, (edges[1] + edges[3]) / 2.0
    return max(1, round(along / length)), max(1, round(across / length))


def _number_of_cells(ring: Float, length: float) -> int:
    if len(ring) == 4:
        along, across = _steps(ring, length)
        return along * across
    return sum(_triangle_steps(ring[[0, k, k + 1]], length) ** 2 for k in range(1, len(ring) - 1))


def _triangle_steps(ring: Float, length: float) -> int:
    return max(1, round(float(np.sqrt(2.0 * area_of(ring))) / length))


def _cells(ring: Float, length: float) -> list[Float]:
    """A quad as a grid of quads, another polygon as a fan of triangles that are divided into smaller ones."""
    if len(ring) == 4:
        m, k = _steps(ring, length)
        u, v = np.linspace(0, 1, m + 1)[:, None, None], np.linspace(0, 1, k + 1)[None, :, None]
        a, b, c, d = ring
        p = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
        return list(np.stack([p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]], axis=2).reshape(-1, 4, 3))
    cells = []
    for corner in range(1, len(ring) - 1):
        a, b, c = ring[0], ring[corner], ring[corner + 1]
        s = _triangle_steps(np.array([a, b, c]), length)

        def at(i: int, j: int, a: Float = a, b: Float = b, c: Float = c, s: int = s) -> Float:
            return np.asarray(a + (b - a) * (i / s) + (c - a) * (j / s))

        for i in range(s):
            for j in range(s - i):
                cells.append(np.array([at(i, j), at(i + 1, j), at(i, j + 1)]))
                if i + j < s - 1:
                    cells.append(np.array([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
    return cells


# ---------------------------------------------------------------- contact


def _contacts(scene: Scene) -> dict[int, list[tuple[Float, Float]]]:
    """For each polygon the edges of others that lie in it: there the light changes at once.  Those of coplanar polygons
    too: a lamp in a ceiling."""
    if len(scene.rings) > 4000:  # a fine mesh: its polygons are no larger than patches
        return {}
    tolerance = TOUCHING * scene.size
    edges = [(a, b) for ring in scene.rings for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True)]
    owner = np.array([k for k, ring in enumerate(scene.rings) for _ in ring])
    starts, ends = np.array([a for a, _ in edges]), np.array([b for _, b in edges])
    found: dict[int, list[tuple[Float, Float]]] = {}
    for number, ring in enumerate(scene.rings):
        normal = normal_of(ring)
        low, high = ring.min(axis=0) - tolerance, ring.max(axis=0) + tolerance
        near = (np.abs((starts - ring[0]) @ normal) < tolerance) & (np.abs((ends - ring[0]) @ normal) < tolerance)
        near &= (owner != number) & (np.maximum(starts, ends) >= low).all(axis=1)
        near &= (np.minimum(starts, ends) <= high).all(axis=1)
        chosen = [(starts[k], ends[k]) for k in np.flatnonzero(near)]
        if chosen:
            found[number] = chosen
    return found


def _cut(cell: Float, segments: list[tuple[Float, Float]], normal: Float, scale: float) -> list[Float]:
    """The cell cut along the segments that go through it, as convex pieces of at most four corners."""
    pieces = [cell]
    for a, b in segments:
        pieces = [part for piece in pieces for part in _halves(piece, a, b, normal, scale)]
    return [part for piece in pieces for part in _at_most_four(piece)]


def _halves(piece: Float, a: Float, b: Float, normal: Float, scale: float) -> list[Float]:
    across = np.cross(normal, b - a)
    length = float(np.linalg.norm(across))
    across = across / length
    sides = (piece - a) @ across
    tolerance = TOUCHING * scale
    if sides.min() > -tolerance or sides.max() < tolerance or not _goes_through(piece, a, b, normal, tolerance):
        return [piece]
    return [_side(piece, sides), _side(piece, -sides)]


def _side(piece: Float, sides: Float) -> Float:
    """Where ``sides`` is positive."""
    kept = []
    for k in range(len(piece)):
        a, b = sides[k], sides[(k + 1) % len(piece)]
        if a >= 0.0:
            kept.append(piece[k])
        if (a > 0.0 > b) or (a < 0.0 < b):
            kept.append(piece[k] + a / (a - b) * (piece[(k + 1) % len(piece)] - piece[k]))
    return np.array(kept)


def _goes_through(piece: Float, a: Float, b: Float, normal: Float, tolerance: float) -> bool:
    """Whether a segment is inside of a convex polygon for more than a point."""
    enter, leave = 0.0, 1.0
    for p, q in zip(piece, np.roll(piece, -1, axis=0), strict=True):
        inward = np.cross(normal, q - p)
        length = np.linalg.norm(inward)
        if length == 0.0:
            continue
        d_a, d_b = float((a - p) @ inward / length), float((b - p) @ inward / length)
        if d_a <= tolerance and d_b <= tolerance:
            return False
        if d_a != d_b:
            t = d_a / (d_a - d_b)
            if d_a < 0.0:
                enter = max(enter, t)
            elif d_b < 0.0:
                leave = min(leave, t)
    return (leave - enter) * float(np.linalg.norm(b - a)) > tolerance


def _at_most_four(ring: Float) -> list[Float]:
    parts = []
    while len(ring) > 4:
        parts.append(ring[:4])
        ring = np.concatenate([ring[:1], ring[3:]])
    return [*parts, ring] if len(ring) > 2 else parts


def _exposed(patches: Patches) -> Patches:
    """Without patches that are covered: inside of a body that stands on them, or behind a coplanar lamp.

    A patch is covered where most rays from it meet the backs of others, or where a smaller polygon of its own plane
    lies on it.
    """
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    scene = patches.scene
    embree = EmbreeScene()
    triangles = scene.triangles()
    TriangleMesh(embree, np.ascontiguousarray(triangles, np.float32))
    owner = np.array([k for k, ring in enumerate(scene.rings) for _ in range(len(ring) - 2)])
    normals = np.array([normal_of(ring) for ring in scene.rings])
    lift = 1e-4 * scene.size
    covered = np.zeros(len(patches), np.int64)
    ways = _fan(patches.normal)
    for way in np.moveaxis(ways, 1, 0):
        origins = (patches.center + lift * patches.normal).astype(np.float32)
        hit = embree.run(origins, np.ascontiguousarray(way, np.float32))
        met = owner[np.maximum(hit, 0)]
        covered += (hit >= 0) & (np.einsum("nk,nk->n", normals[met], way) > 1e-9)
    hidden = covered > ways.shape[1] // 2
    hidden |= _behind_coplanar(patches, normals)
    if not hidden.any():
        return patches
    if np.average(hidden, weights=patches.area) > 0.9:
        raise SceneError(
            f"{scene.name}: nearly all fronts look at backs: are the normals inverted? A room shows its fronts inside;"
            " --flip turns them"
        )
    kept = np.flatnonzero(~hidden)
    rings = [patches.rings[k, : patches.counts[k]] for k in kept]
    return patches_of(scene, rings, patches.polygon[kept].tolist())


def _fan(normals: Float) -> Float:
    """Five directions about each normal: (n, 5, 3)."""
    other = np.where(np.abs(normals[:, :1]) < 0.7, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    t = np.cross(normals, other)
    t /= np.linalg.norm(t, axis=1, keepdims=True)
    b = np.cross(normals, t)
    return np.stack([normals, *(normals + 0.8 * side for side in (t, -t, b, -b))], axis=1)


def _behind_coplanar(patches: Patches, normals: Float) -> NDArray[np.bool_]:
    """Patches whose middle lies on another polygon of the same plane: a smaller one that looks the same way, which is
    seen instead, or one that looks the other way, which lies face to face."""
    scene = patches.scene
    hidden = np.zeros(len(patches), bool)
    areas = np.array([area_of(ring) for ring in scene.rings])
    if len(scene.rings) > 4000:
        return hidden
    tolerance = TOUCHING * scene.size
    for number, ring in enumerate(scene.rings):
        cosine = patches.normal @ normals[number]
        smaller = (cosine > 1.0 - 1e-6) & (areas[patches.polygon] > areas[number] * (1.0 + 1e-9))
        there = (smaller | (cosine < -1.0 + 1e-6)) & (patches.polygon != number)
        there &= np.abs((patches.center - ring[0]) @ normals[number]) < tolerance
        for k in np.flatnonzero(there):
            inward = np.cross(normals[number], np.roll(ring, -1, axis=0) - ring)
            hidden[k] |= bool((((patches.center[k] - ring) * inward).sum(axis=1) > 0.0).all())
    return hidden
