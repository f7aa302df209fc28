"""From radiosity of patches to colours of vertices.

The light at a vertex is gathered there once more from all patches (a final gather), as if the vertex were a small
patch; the mean of the patches around it, which textbooks take, stays as ``averaged``.  Vertices are split where the
surface has a crease.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.patches import Patches

Float = NDArray[np.float64]
Int = NDArray[np.int64]
Progress = Callable[[str, int, int], object]
INWARD = 0.02  # how far a vertex at a border is moved into the largest patch it belongs to, when it gathers
NEGLIGIBLE = 1e-5  # of all the light a vertex gets: such contributions are not asked whether they are seen


@dataclass(frozen=True)
class Mesh:
    """Triangles without T-vertices.

    vertices, normals: (V, 3); at: (V, 3) where light is gathered; patch: (V,) the largest patch each vertex belongs
    to; triangles: (T, 3) numbers of vertices; triangle_patch: (T,).
    """

    vertices: Float
    normals: Float
    at: Float
    patch: Int
    triangles: Int
    triangle_patch: Int


def mesh_of(patches: Patches) -> Mesh:
    """The patches as triangles that share vertices; a patch whose edges have vertices of its neighbours on them becomes
    a fan around its middle."""
    scale = patches.scene.size
    keys: dict[tuple[float, ...], int] = {}
    positions: list[Float] = []
    members: list[list[int]] = []

    def vertex(point: Float, patch: int) -> int:
        surface = _surface(patches, patch)
        key = (*np.round(point / scale, 7).tolist(), surface)
        number = keys.setdefault(key, len(positions))
        if number == len(positions):
            positions.append(point)
            members.append([])
        members[number].append(patch)
        return number

    corners = [[vertex(patches.rings[k, c], k) for c in range(patches.counts[k])] for k in range(len(patches))]
    by_surface: dict[int, list[int]] = {}
    for k in range(len(patches)):
        by_surface.setdefault(_surface(patches, k), []).append(k)
    around: dict[int, float] = {}  # the angle that patches take up around each vertex
    triangles: list[tuple[int, int, int]] = []
    owner: list[int] = []
    for chosen in by_surface.values():
        there = np.array(sorted({number for k in chosen for number in corners[k]}))
        points = np.array([positions[number] for number in there])
        for k in chosen:
            ring = _with_neighbours(corners[k], positions, there, points, 1e-7 * scale)
            for before, a, after in zip([ring[-1], *ring[:-1]], ring, [*ring[1:], ring[0]], strict=True):
                if k not in members[a]:
                    members[a].append(k)
                angle = _angle(positions[before] - positions[a], positions[after] - positions[a])
                around[a] = around.get(a, 0.0) + angle
            if len(ring) == len(corners[k]):
                parts = [(ring[0], ring[m], ring[m + 1]) for m in range(1, len(ring) - 1)]
            else:
                middle = vertex(patches.center[k], k)
                parts = [(middle, ring[m], ring[(m + 1) % len(ring)]) for m in range(len(ring))]
            triangles += parts
            owner += [k] * len(parts)
    where = np.array(positions)
    patch = np.array([max(group, key=lambda k: patches.area[k]) for group in members])
    normals = np.array([_mean(patches.normal[group], patches.area[group]) for group in members])
    border = np.array([around.get(number, 7.0) < 6.28 for number in range(len(where))])
    at = np.where(border[:, None], where + INWARD * (patches.center[patch] - where), where)
    return Mesh(where, normals, at, patch, np.array(triangles), np.array(owner))


def _angle(a: Float, b: Float) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b))


def _surface(patches: Patches, k: int) -> int:
    """Patches of one flat polygon, or of one smooth body, share vertices."""
    scene = patches.scene
    polygon = int(patches.polygon[k])
    return scene.group[polygon] if scene.group else polygon


def _with_neighbours(ring: list[int], positions: list[Float], there: Int, points: Float, tolerance: float) -> list[int]:
    """The ring with the vertices that lie on its edges."""
    result: list[int] = []
    for a, b in zip(ring, [*ring[1:], ring[0]], strict=True):
        result.append(a)
        start, way = positions[a], positions[b] - positions[a]
        length = float(np.linalg.norm(way))
        along = (points - start) @ way / (length * length)
        off = np.linalg.norm(points - start - along[:, None] * way, axis=1)
        inside = (off < tolerance) & (along * length > tolerance) & ((1.0 - along) * length > tolerance)
        result += there[np.flatnonzero(inside)[np.argsort(along[inside])]].tolist()
    return result


def _mean(normals: Float, areas: Float) -> Float:
    total = (normals * areas[:, None]).sum(axis=0)
    length = np.linalg.norm(total)
    return np.asarray(total / length if length > 0.0 else normals[0])


def gathered(patches: Patches, mesh: Mesh, B: Float, progress: Progress | None = None) -> Float:
    """Radiosity at the vertices (V, 3): E + rho times the irradiance that all patches send there."""
    from glsim.radiosity import kernels
    from glsim.radiosity.visibility import Visibility

    tell = progress or (lambda stage, done, of: None)
    visibility = Visibility(patches.scene)
    brightest = B.max(axis=1)
    least = NEGLIGIBLE * float((patches.area * brightest).sum() / patches.area.sum()) / np.maximum(brightest, 1e-300)
    H = np.empty((len(mesh.vertices), 3))
    lift = 1e-6 * patches.scene.size * mesh.normals
    points = mesh.at + lift
    arrays = (patches.rings, patches.counts, patches.normal)
    step = max(1, (1 << 21) // len(patches))
    for first in range(0, len(points), step):
        last = min(first + step, len(points))
        factors = np.zeros((last - first, len(patches)))
        kernels.gather(points, mesh.normals, *arrays, least, first, last, factors)
        rows, columns = np.nonzero(factors)
        if visibility.bodies is None or len(visibility.bodies.counts):
            shares = visibility.from_points(points[first:last], mesh.normals[first:last], patches, rows, columns)
            factors[rows, columns] *= shares
        H[first:last] = factors @ B
        tell("vertices", last, len(points))
    return np.asarray(patches.E[mesh.patch] + patches.rho[mesh.patch] * H)


def averaged(patches: Patches, mesh: Mesh, B: Float) -> Float:
    """Radiosity at the vertices as the mean of the patches around, by area: what textbooks teach first."""
    total, weight = np.zeros((len(mesh.vertices), 3)), np.zeros(len(mesh.vertices))
    for corner in range(3):
        np.add.at(total, mesh.triangles[:, corner], B[mesh.triangle_patch])
        np.add.at(weight, mesh.triangles[:, corner], 1.0)
    return total / np.maximum(weight, 1.0)[:, None]


# ---------------------------------------------------------------- from radiosity to the screen

TONES = {
    "linear": "B / white, cut off at 1",
    "reinhard": "L / (1 + L) with L = B / white, for scenes with bright lamps (Reinhard et al. 2002)",
}
GAMMA = 2.2


def automatic_white(patches: Patches, B: Float) -> float:
    """The radiosity that becomes white: a little more than what 95 % of the lit area has, lamps aside."""
    dark = patches.E.max(axis=1) == 0.0
    chosen = dark if dark.any() else np.ones(len(B), bool)
    values, areas = B[chosen].max(axis=1), patches.area[chosen]
    order = np.argsort(values)
    share = np.cumsum(areas[order]) / areas.sum()
    white = float(values[order][min(int(np.searchsorted(share, 0.95)), len(order) - 1)]) * 1.1
    return white if white > 0.0 else 1.0


def toned(B: Float, white: float, tone: str = "linear", gamma: float = GAMMA) -> Float:
    """Colours in [0, 1] for the screen: tone mapping, then the power 1 / gamma."""
    if tone not in TONES:
        raise ValueError(f"tones are {', '.join(TONES)}, not {tone!r}")
    L = np.maximum(B, 0.0) / white
    if tone == "reinhard":
        L = L / (1.0 + L)
    return np.asarray(np.clip(L, 0.0, 1.0) ** (1.0 / gamma))
