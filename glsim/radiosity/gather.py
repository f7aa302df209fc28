"""From the radiosity of patches to the radiosity of vertices.

A final gather collects the light of all patches once more at each vertex, as if the vertex were a small patch.
``averaged`` takes the mean of the patches around a vertex instead, as textbooks do (Cohen & Wallace 1993, section 9.1).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.compiled import parallel, prange
from glsim.radiosity.factors import Factors
from glsim.radiosity.hidden import covered
from glsim.radiosity.mesh import PatchMesh
from glsim.radiosity.patches import Patches
from glsim.radiosity.polygon import MOST_CORNERS, area, at_point, bilinear
from glsim.radiosity.progress import Progress, silent

Float = NDArray[np.float64]
Int = NDArray[np.int64]
AT_ONCE = 1024  # points
NEAR = 0.02  # from this form factor on the radiosity of a patch is bilinear, below it constant


def radiosity_at(
    factors: Factors, points: Float, normals: Float, patch: Int, B: Float, progress: Progress | None = None
) -> Float:
    """Return the radiosity (k, 3) at points: E + rho times the irradiance from all patches.

    points: (k, 3), with unit normals (k, 3), on the patches numbered ``patch`` (k,); B: (n, 3) of the patches.
    """
    tell = progress or silent
    patches = factors.patches
    raised = points + 1e-6 * patches.scene.size * normals
    H = np.empty((len(points), 3))
    for first in range(0, len(points), AT_ONCE):
        now = slice(first, min(first + AT_ONCE, len(points)))
        H[now] = factors.at_points(raised[now], normals[now], patch[now], B)
        tell("vertices", now.stop, len(points))
    return np.asarray(patches.E[patch] + patches.rho[patch] * H)


def gathered(factors: Factors, mesh: PatchMesh, B: Float, progress: Progress | None = None) -> Float:
    """Return the radiosity at the mesh's vertices (V, 3), from the radiosity B (n, 3) of the patches.

    The first gather takes the radiosity of each patch as constant.  Its result at the patches' corners makes the
    radiosity of near patches bilinear, which corrects the light from them, twice.  A vertex inside a body takes the
    mean of the patches around it.
    """
    even = radiosity_at(factors, mesh.at, mesh.normals, mesh.patch, B, progress)
    shown = even
    for _ in range(2):  # the second time with the corners that the first one corrected
        added = unevenness(factors, mesh.at, mesh.normals, shown[mesh.corners])
        shown = np.maximum(even + factors.patches.rho[mesh.patch] * added, 0.0)
    hidden = covered(
        factors.visibility.rays, mesh.at, mesh.normals
    )  # inside a body, but their triangles reach out of it
    return np.where(hidden[:, None], averaged(factors.patches, mesh, B), shown)


def unevenness(factors: Factors, points: Float, normals: Float, bright: Float) -> Float:
    """Return how much the irradiance at points changes if the radiosity of near patches is bilinear: (k, 3).

    points: (k, 3), with unit normals (k, 3); bright: (n, 4, 3), the radiosity at the patches' corners, between which it
    is bilinear.
    """
    from scipy.spatial import cKDTree

    patches = factors.patches
    points = points + 1e-6 * patches.scene.size * normals
    around = cKDTree(points).query_ball_point(patches.center, patches.size)
    columns = np.repeat(np.arange(len(patches)), [len(some) for some in around])
    rows = np.concatenate([np.asarray(some, np.int64) for some in around])
    added = np.zeros((len(rows), 3))
    _uneven(points, normals, rows, patches.corners, patches.counts, patches.normal, columns, bright, NEAR, added)
    near = np.flatnonzero(added.any(axis=1))
    rows, columns, added = rows[near], columns[near], added[near]
    many = np.zeros(len(rows), np.bool_)
    seen = factors.visibility.from_points(points, normals, patches, rows, columns, many)
    return np.stack([np.bincount(rows, seen * added[:, k], len(points)) for k in range(3)], axis=1)


@parallel
def _uneven(
    points: Any, normals: Any, rows: Any, corners: Any, counts: Any, patch_normals: Any, columns: Any, bright: Any,
    least: float, out: Any,
) -> None:  # fmt: skip
    """Write how the irradiance at points[rows] changes if patches[columns] are not evenly bright, into out (k, 3).

    rows, columns: (k,).  Each patch is cut into 4 x 4 parts.  The change is the light from all parts, each with the
    radiosity at its middle (bilinear between ``bright`` (n, 4, 3) at the corners), minus the light from the whole patch
    with the mean radiosity.  Form factors below ``least`` give 0.  Occlusion is ignored.
    """
    parts = 4  # along each edge
    for row in prange(len(rows)):
        v, j = rows[row], columns[row]
        work, part = np.empty((MOST_CORNERS, 3)), np.empty((4, 3))
        whole = at_point(points[v], normals[v], corners[j], counts[j], patch_normals[j], work)
        if whole < least:
            continue
        value, total, whole_area = np.zeros(3), np.zeros(3), 0.0
        for s in range(parts):
            for t in range(parts):
                for c in range(4):
                    u, w = (s + (c == 1 or c == 2)) / parts, (t + (c >= 2)) / parts
                    for k in range(3):
                        part[c, k] = bilinear(corners[j], u, w, k)
                factor = at_point(points[v], normals[v], part, 4, patch_normals[j], work)
                weight = area(part, 4)
                whole_area += weight
                for k in range(3):
                    b = bilinear(bright[j], (s + 0.5) / parts, (t + 0.5) / parts, k)
                    value[k] += factor * b
                    total[k] += weight * b
        for k in range(3):
            out[row, k] = value[k] - whole * total[k] / whole_area


def averaged(patches: Patches, mesh: PatchMesh, B: Float) -> Float:
    """Return the radiosity at the vertices (V, 3): the mean of the patches around, weighted by their areas."""
    vertex, patch = np.divmod(
        np.unique(mesh.triangles.ravel() * len(patches) + np.repeat(mesh.triangle_patch, 3)), len(patches)
    )
    area = patches.area[patch]
    weight = np.bincount(vertex, area, len(mesh.vertices))
    return np.stack([np.bincount(vertex, area * B[patch, k], len(weight)) / weight for k in range(3)], axis=1)
