"""Breaking the scene into patches: quads where that is possible, cut along the lines where other polygons touch."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.contacts import TOUCHING, contacts, cut, near_segments
from glsim.radiosity.hidden import exposed
from glsim.radiosity.patches import Patches, four_corners, patches_from
from glsim.radiosity.scene import Scene, SceneError, area_of, normal_of

Float = NDArray[np.float64]


def subdivide(scene: Scene, count: int = 2000, length: float | None = None) -> Patches:
    """Patches with edges of about ``length``, or about ``count`` patches altogether.

    Raises SceneError for a count or length that cannot be.
    """
    if length is None:
        if count < 1:
            raise SceneError(f"--patches: at least 1 patch is needed, not {count}")
        length = length_for(scene, count)
    if not length > 0.0:
        raise SceneError(f"the length of patches must be more than 0, not {length}")
    normals = np.array([normal_of(ring) for ring in scene.rings])
    cuts = contacts(scene, normals)
    rings: list[Float] = []
    polygon: list[int] = []
    for number, ring in enumerate(scene.rings):
        cells = _cells(ring, length)
        segments = cuts.get(number, [])
        touched = near_segments(cells, segments, normals[number], TOUCHING * scene.size)
        parts = [cells[~touched]]
        for cell in cells[touched]:
            own = cell if len(ring) == 4 else cell[:3]
            pieces = cut(own, segments, normals[number], scene.size)
            parts += [four_corners(pieces)] if pieces else []
        rings += parts
        polygon += [number] * sum(map(len, parts))
    whole = np.concatenate(rings)
    counts = np.where((whole[:, 2] == whole[:, 3]).all(axis=1), 3, 4)
    return exposed(patches_from(scene, whole, counts, np.array(polygon, np.int64)))


def length_for(scene: Scene, count: int) -> float:
    """The length at which the grids have about ``count`` cells; more, if polygons that are small anyway would leave
    less than half of them to the others."""
    count = max(count, number_of_cells(scene, 2.0 * scene.size) + count // 2)
    short, long = 1e-4 * scene.size, 2.0 * scene.size
    for _ in range(40):
        middle = (short * long) ** 0.5
        short, long = (short, middle) if number_of_cells(scene, middle) <= count else (middle, long)
    return long


def number_of_cells(scene: Scene, length: float) -> int:
    """Of all grids, before they are cut."""
    return sum(_number_of_cells(ring, length) for ring in scene.rings)


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


def _cells(ring: Float, length: float) -> Float:
    """A quad as a grid of quads, another polygon as a fan of triangles, each divided into smaller ones: (k, 4, 3)."""
    if len(ring) == 4:
        m, k = _steps(ring, length)
        u, v = np.linspace(0, 1, m + 1)[:, None, None], np.linspace(0, 1, k + 1)[None, :, None]
        a, b, c, d = ring
        p = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
        return np.stack([p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]], axis=2).reshape(-1, 4, 3)
    fans = [ring[[0, corner, corner + 1]] for corner in range(1, len(ring) - 1)]
    return np.concatenate([_triangle_cells(fan, _triangle_steps(fan, length)) for fan in fans])


def _triangle_cells(triangle: Float, s: int) -> Float:
    """s^2 triangles of the same shape."""
    a, b, c = triangle
    i, j = np.meshgrid(np.arange(s), np.arange(s), indexing="ij")
    upright, turned = np.stack([i, j], axis=2)[i + j < s], np.stack([i, j], axis=2)[i + j < s - 1]
    steps = np.concatenate([
        upright[:, None] + [[0, 0], [1, 0], [0, 1], [0, 1]], turned[:, None] + [[1, 0], [1, 1], [0, 1], [0, 1]]
    ])  # fmt: skip
    return np.asarray(a + (b - a) * (steps[:, :, :1] / s) + (c - a) * (steps[:, :, 1:] / s))
