"""Breaking the scene into patches: quads where that is possible, cut along the lines where other polygons touch."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.contacts import TOUCHING, contacts, cut, near_segments
from glsim.radiosity.hidden import exposed
from glsim.radiosity.patches import Patches, four_corners, patches_from
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Scene, SceneError, area_of

Float = NDArray[np.float64]


def subdivide(scene: Scene, count: int = 2000, length: float | None = None, rays: Rays | None = None) -> Patches:
    """Break a scene into patches with edges of about ``length``, or into about ``count`` patches altogether.

    Patches that nobody can see are left out; rays: to find these, by default new ones.  Raises SceneError for a count
    below 1 and for a length that is not positive.
    """
    if length is None:
        if count < 1:
            raise SceneError(f"--patches: at least 1 patch is needed, not {count}")
        length = length_for(scene, count)
    if not length > 0.0:
        raise SceneError(f"the length of patches must be more than 0, not {length}")
    cuts = contacts(scene)
    corners: list[Float] = []
    owner: list[int] = []
    for number, polygon in enumerate(scene.polygons):
        cells = _cells(polygon, length)
        segments = cuts.get(number, [])
        touched = near_segments(cells, segments, scene.normals[number], TOUCHING * scene.size)
        parts = [cells[~touched]]
        for cell in cells[touched]:
            corners_of_cell = cell if len(polygon) == 4 else cell[:3]
            pieces = cut(corners_of_cell, segments, scene.normals[number], scene.size)
            parts += [four_corners(pieces)] if pieces else []
        corners += parts
        owner += [number] * sum(map(len, parts))
    all_corners = np.concatenate(corners)
    counts = np.where((all_corners[:, 2] == all_corners[:, 3]).all(axis=1), 3, 4)
    return exposed(patches_from(scene, all_corners, counts, np.array(owner, np.int64)), rays or Rays(scene))


def length_for(scene: Scene, count: int) -> float:
    """Return the length of edges with which all grids together have about ``count`` cells.

    Each polygon has at least one cell.  If that alone takes more than half of ``count``, there are more cells.
    """
    count = max(count, number_of_cells(scene, 2.0 * scene.size) + count // 2)
    short, long = 1e-4 * scene.size, 2.0 * scene.size
    for _ in range(40):
        middle = (short * long) ** 0.5
        short, long = (short, middle) if number_of_cells(scene, middle) <= count else (middle, long)
    return long


def number_of_cells(scene: Scene, length: float) -> int:
    """Return how many cells all grids have together, before they are cut."""
    return sum(_number_of_cells(polygon, length) for polygon in scene.polygons)


def _steps(polygon: Float, length: float) -> tuple[int, int]:
    """Return how many cells lie along the first and along the second edge of a quad."""
    edges = np.linalg.norm(np.roll(polygon, -1, axis=0) - polygon, axis=1)
    along, across = (edges[0] + edges[2]) / 2.0, (edges[1] + edges[3]) / 2.0
    return max(1, round(along / length)), max(1, round(across / length))


def _number_of_cells(polygon: Float, length: float) -> int:
    """Return how many cells the grid of one polygon has."""
    if len(polygon) == 4:
        along, across = _steps(polygon, length)
        return along * across
    return sum(_triangle_steps(polygon[[0, k, k + 1]], length) ** 2 for k in range(1, len(polygon) - 1))


def _triangle_steps(polygon: Float, length: float) -> int:
    """Return how many cells lie along an edge of a triangle."""
    return max(1, round(float(np.sqrt(2.0 * area_of(polygon))) / length))


def _cells(polygon: Float, length: float) -> Float:
    """Cut a quad into a grid of quads, or another polygon into a fan of triangles and smaller ones: (k, 4, 3)."""
    if len(polygon) == 4:
        m, k = _steps(polygon, length)
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
