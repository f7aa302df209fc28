"""Breaking the scene into patches: quads where that is possible, cut along the lines where other polygons touch."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.clusters import clustered
from glsim.radiosity.contacts import TOUCHING, Segments, contacts, cut, near_segments
from glsim.radiosity.hidden import exposed
from glsim.radiosity.patches import Patches, four_corners, patches_from
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Scene, SceneError, area_of

Float = NDArray[np.float64]
MORE = 1.5  # times the patches asked for: more of them are worth a note
SHORT = 0.3  # of a cell's edge: shorter edges that touch a polygon do not cut its cells


def subdivide(
    scene: Scene, count: int = 2000, length: float | None = None, rays: Rays | None = None, small: float | None = None
) -> Patches:
    """Break a scene into patches with edges of about ``length``, or into about ``count`` patches altogether.

    small: if it is given, polygons that are small beside this length are gathered in clusters, see clusters.py; without
    ``length`` that is so if there are more polygons than ``count``.  Patches that nobody can see are left out;
    rays: to find these, by default new ones.  Raises SceneError for a count
    below 1 and for a length that is not positive.
    """
    whole = length is None
    if length is None:
        if count < 1:
            raise SceneError(f"--patches: at least 1 patch is needed, not {count}")
        length, gather = length_for(scene, count)
        small = length if gather else None
    if not length > 0.0:
        raise SceneError(f"the length of patches must be more than 0, not {length}")
    cuts = contacts(scene, SHORT * length)
    corners: list[Float] = []
    owner: list[int] = []
    single = np.sqrt(2.0 * scene.areas) < length  # a triangle with a smaller area is one cell
    for number, polygon in enumerate(scene.polygons):
        cells = polygon[None, [0, 1, 2, 2]] if len(polygon) == 3 and single[number] else _cells(polygon, length)
        if number in cuts:
            cells = _cut(cells, len(polygon) == 4, cuts[number], scene.normals[number], scene.size)
        corners.append(cells)
        owner += [number] * len(cells)
    all_corners = np.concatenate(corners)
    counts = np.where((all_corners[:, 2] == all_corners[:, 3]).all(axis=1), 3, 4)
    parts = exposed(patches_from(scene, all_corners, counts, np.array(owner, np.int64)), rays or Rays(scene))
    parts = parts if small is None else clustered(parts, small)
    if whole and len(parts) > MORE * count + 100:
        parts = parts.noted(f"{len(parts)} patches where about {count} were asked for: the scene has"
                            f" {len(scene.polygons)} polygons, and bodies that touch cut others")  # fmt: skip
    return parts


def _cut(cells: Float, quads: bool, segments: Segments, normal: Float, scale: float) -> Float:
    """Return cells (k, 4, 3) of a polygon cut along the segments that go through them; scale: the scene's size."""
    touched = near_segments(cells, segments, normal, TOUCHING * scale)
    parts = [cells[~touched.any(axis=1)]]
    for number in np.flatnonzero(touched.any(axis=1)).tolist():
        cell = cells[number] if quads else cells[number, :3]
        pieces = cut(cell, [segments[k] for k in np.flatnonzero(touched[number])], normal, scale)
        parts += [four_corners(pieces)] if pieces else []
    return np.concatenate(parts)


def length_for(scene: Scene, count: int) -> tuple[float, bool]:
    """Return the length of edges with which all grids together have about ``count`` cells.

    Each polygon has at least one cell; if that alone takes more than half of ``count``, there are more cells.  But if
    there are more polygons than ``count``, those that are small beside that length are to be gathered in clusters, and
    count by their area: then the second result is True.
    """
    grids = Grids.of(scene)
    fewest = grids.cells(2.0 * scene.size)
    gather = fewest > count
    count = count if gather else max(count, fewest + count // 2)
    short, long = 1e-4 * scene.size, 2.0 * scene.size
    for _ in range(40):
        middle = (short * long) ** 0.5
        short, long = (short, middle) if grids.cells(middle, gather) <= count else (middle, long)
    return long, gather


def number_of_cells(scene: Scene, length: float) -> int:
    """Return how many cells all grids have together, before they are cut."""
    return Grids.of(scene).cells(length)


class Grids(NamedTuple):
    """What tells how many cells there are at any length: edges (q, 2), the lengths of each quad's two sides; triangles
    (t,), the edges of squares as large as twice the triangles of which other polygons are made."""

    edges: Float
    triangles: Float

    @staticmethod
    def of(scene: Scene) -> Grids:
        quads, fans = np.zeros((0, 4, 3)), [np.zeros((0, 3, 3))]
        for _, corners in scene.by_corners:
            if corners.shape[1] == 4:
                quads = corners
            else:
                fans += [corners[:, [0, k, k + 1]] for k in range(1, corners.shape[1] - 1)]
        a, b, c = np.moveaxis(np.concatenate(fans), 1, 0)
        return Grids(_sides(quads), np.sqrt(np.linalg.norm(np.cross(b - a, c - a), axis=1)))

    def cells(self, length: float, gather: bool = False) -> int:
        """Return how many cells of about ``length`` all grids have together, before they are cut.

        gather: polygons below half of that length are a fraction of a cell."""
        sides, triangles = self.edges / length, self.triangles / length
        quads, others = np.maximum(1.0, np.round(sides)).prod(axis=1), np.maximum(1.0, np.round(triangles)) ** 2
        if gather:
            quads = np.where(sides.max(axis=1) < 0.5, sides.prod(axis=1), quads)
            others = np.where(triangles < 0.5, triangles**2 / 2.0, others)
        return int(quads.sum() + others.sum())


def _sides(quads: Float) -> Float:
    """Return the mean lengths of the first and third, and of the second and fourth edge of quads (k, 4, 3): (k, 2)."""
    edges = np.linalg.norm(np.roll(quads, -1, axis=1) - quads, axis=2)
    return np.asarray((edges[:, :2] + edges[:, 2:]) / 2.0)


def _triangle_steps(polygon: Float, length: float) -> int:
    """Return how many cells lie along an edge of a triangle."""
    return max(1, round(float(np.sqrt(2.0 * area_of(polygon))) / length))


def _cells(polygon: Float, length: float) -> Float:
    """Cut a quad into a grid of quads, or another polygon into a fan of triangles and smaller ones: (k, 4, 3)."""
    if len(polygon) == 4:
        m, k = (max(1, round(side / length)) for side in _sides(polygon[None])[0].tolist())
        u, v = np.linspace(0, 1, m + 1)[:, None, None], np.linspace(0, 1, k + 1)[None, :, None]
        a, b, c, d = polygon
        p = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
        return np.stack([p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]], axis=2).reshape(-1, 4, 3)
    fans = [polygon[[0, corner, corner + 1]] for corner in range(1, len(polygon) - 1)]
    return np.concatenate([_triangle_cells(fan, _triangle_steps(fan, length)) for fan in fans])


def _triangle_cells(triangle: Float, s: int) -> Float:
    """Cut a triangle into s^2 triangles of its shape: (s^2, 4, 3), each with its last corner twice."""
    a, b, c = triangle
    i, j = np.meshgrid(np.arange(s), np.arange(s), indexing="ij")
    upright, inverted = np.stack([i, j], axis=2)[i + j < s], np.stack([i, j], axis=2)[i + j < s - 1]
    steps = np.concatenate([
        upright[:, None] + [[0, 0], [1, 0], [0, 1], [0, 1]], inverted[:, None] + [[1, 0], [1, 1], [0, 1], [0, 1]]
    ])  # fmt: skip
    return np.asarray(a + (b - a) * (steps[:, :, :1] / s) + (c - a) * (steps[:, :, 1:] / s))
