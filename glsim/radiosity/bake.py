"""From radiosity of patches to colours of vertices.

The light at a vertex is gathered there once more from all patches (a final gather), as if the vertex were a small
patch; the mean of the patches around it, which textbooks take, stays as ``averaged``.  Vertices are split where the
surface has a crease.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.exposure import covered
from glsim.radiosity.formfactors import Progress
from glsim.radiosity.mesh import Mesh
from glsim.radiosity.patches import Patches
from glsim.radiosity.solvers import Factors
from glsim.radiosity.sweep import uneven

Float = NDArray[np.float64]
Int = NDArray[np.int64]
AT_ONCE = 1024  # points
NEAR = 0.02  # form factors from which on it matters that a patch is not evenly bright


def radiosity_at(
    factors: Factors, points: Float, normals: Float, patch: Int, B: Float, progress: Progress | None = None
) -> Float:
    """Radiosity (k, 3) at points on the patches ``patch``: E + rho times the irradiance that all patches send there."""
    tell = progress or (lambda stage, done, of: None)
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
    uneven(points, normals, rows, patches.rings, patches.counts, patches.normal, columns, bright, NEAR, added)
    near = np.flatnonzero(added.any(axis=1))
    rows, columns, added = rows[near], columns[near], added[near]
    many = np.zeros(len(rows), np.bool_)
    seen = factors.visibility.from_points(points, normals, patches, rows, columns, many)
    return np.stack([np.bincount(rows, seen * added[:, k], len(points)) for k in range(3)], axis=1)


def averaged(patches: Patches, mesh: Mesh, B: Float) -> Float:
    """Radiosity at the vertices as the mean of the patches around, by their areas: what textbooks teach first."""
    vertex, patch = np.divmod(
        np.unique(mesh.triangles.ravel() * len(patches) + np.repeat(mesh.triangle_patch, 3)), len(patches)
    )
    area = patches.area[patch]
    weight = np.bincount(vertex, area, len(mesh.vertices))
    return np.stack([np.bincount(vertex, area * B[patch, k], len(weight)) / weight for k in range(3)], axis=1)


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
