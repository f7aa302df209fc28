"""From radiosity of patches to colours of vertices.

The light at a vertex is gathered there once more from all patches (a final gather), as if the vertex were a small
patch; the mean of the patches around it, which textbooks take, stays as ``averaged``.  Vertices are split where the
surface has a crease.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.compiled import parallel, prange
from glsim.radiosity.factors import Factors
from glsim.radiosity.hidden import covered
from glsim.radiosity.mesh import Mesh
from glsim.radiosity.patches import Patches
from glsim.radiosity.polygon import MOST_CORNERS, area, at_point, bilinear
from glsim.radiosity.progress import Progress, silent

Float = NDArray[np.float64]
Int = NDArray[np.int64]
AT_ONCE = 1024  # points
NEAR = 0.02  # form factors from which on it matters that a patch is not evenly bright


def radiosity_at(
    factors: Factors, points: Float, normals: Float, patch: Int, B: Float, progress: Progress | None = None
) -> Float:
    """Radiosity (k, 3) at points on the patches ``patch``: E + rho times the irradiance that all patches send there."""
    tell = progress or silent
    patches = factors.patches
    raised = points + 1e-6 * patches.scene.size * normals
    H = np.empty((len(points), 3))
    for first in range(0, len(points), AT_ONCE):
        now = slice(first, min(first + AT_ONCE, len(points)))
        H[now] = factors.at_points(raised[now], normals[now], patch[now], B)
        tell("vertices", now.stop, len(points))
    return np.asarray(patches.E[patch] + patches.rho[patch] * H)


def gathered(factors: Factors, mesh: Mesh, B: Float, progress: Progress | None = None) -> Float:
    """Radiosity at the vertices (V, 3).  First as if each patch were evenly bright; then, where a patch is near, with
    what this shows between its corners.  Vertices inside of a body take the mean of the patches around."""
    even = radiosity_at(factors, mesh.at, mesh.normals, mesh.patch, B, progress)
    shown = even
    for _ in range(2):  # the second with corners that the first has mended
        added = unevenness(factors, mesh.at, mesh.normals, shown[mesh.corners])
        shown = np.maximum(even + factors.patches.rho[mesh.patch] * added, 0.0)
    hidden = covered(factors.patches.scene, mesh.at, mesh.normals)  # nobody sees them, but the triangles around
    return np.where(hidden[:, None], averaged(factors.patches, mesh, B), shown)


def unevenness(factors: Factors, points: Float, normals: Float, bright: Float) -> Float:
    """What it adds to the irradiance at points (k, 3) that patches near them are as bright as ``bright`` (n, 4, 3)
    between their corners, and not evenly."""
    from scipy.spatial import cKDTree

    patches = factors.patches
    points = points + 1e-6 * patches.scene.size * normals
    around = cKDTree(points).query_ball_point(patches.center, patches.size)
    columns = np.repeat(np.arange(len(patches)), [len(some) for some in around])
    rows = np.concatenate([np.asarray(some, np.int64) for some in around])
    added = np.zeros((len(rows), 3))
    _uneven(points, normals, rows, patches.rings, patches.counts, patches.normal, columns, bright, NEAR, added)
    near = np.flatnonzero(added.any(axis=1))
    rows, columns, added = rows[near], columns[near], added[near]
    many = np.zeros(len(rows), np.bool_)
    seen = factors.visibility.from_points(points, normals, patches, rows, columns, many)
    return np.stack([np.bincount(rows, seen * added[:, k], len(points)) for k in range(3)], axis=1)


@parallel
def _uneven(
    points: Any, ways: Any, rows: Any, rings: Any, counts: Any, normals: Any, columns: Any, bright: Any, least: float,
    out: Any,
) -> None:  # fmt: skip
    """What is added to the irradiance at points[rows] because patches[columns] are as bright as ``bright`` (n, 4, 3)
    between their corners, and not evenly so bright as their mean: (k, 3).  0 for form factors below ``least``."""
    parts = 4  # along each edge
    for row in prange(len(rows)):
        v, j = rows[row], columns[row]
        work, ring = np.empty((MOST_CORNERS, 3)), np.empty((4, 3))
        whole = at_point(points[v], ways[v], rings[j], counts[j], normals[j], work)
        if whole < least:
            continue
        value, total, whole_area = np.zeros(3), np.zeros(3), 0.0
        for s in range(parts):
            for t in range(parts):
                for c in range(4):
                    u, w = (s + (c == 1 or c == 2)) / parts, (t + (c >= 2)) / parts
                    for k in range(3):
                        ring[c, k] = bilinear(rings[j], u, w, k)
                factor = at_point(points[v], ways[v], ring, 4, normals[j], work)
                weight = area(ring, 4)
                whole_area += weight
                for k in range(3):
                    b = bilinear(bright[j], (s + 0.5) / parts, (t + 0.5) / parts, k)
                    value[k] += factor * b
                    total[k] += weight * b
        for k in range(3):
            out[row, k] = value[k] - whole * total[k] / whole_area


def averaged(patches: Patches, mesh: Mesh, B: Float) -> Float:
    """Radiosity at the vertices as the mean of the patches around, by their areas: what textbooks teach first."""
    vertex, patch = np.divmod(
        np.unique(mesh.triangles.ravel() * len(patches) + np.repeat(mesh.triangle_patch, 3)), len(patches)
    )
    area = patches.area[patch]
    weight = np.bincount(vertex, area, len(mesh.vertices))
    return np.stack([np.bincount(vertex, area * B[patch, k], len(weight)) / weight for k in range(3)], axis=1)
