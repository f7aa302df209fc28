"""Many polygons below the size of a patch exchange light as one patch: a cluster.

A modeller's chair has thousands of triangles, and the light that they send together is that of a few patches.  A
cluster gathers small pieces of one material that lie near each other and look to about the same side.  For form factors
it is a rectangle with the pieces' area, middle and mean normal; rays begin and end on the pieces themselves, and the
pieces are what is drawn.  (Smits, Arvo and Greenberg, A clustering algorithm for radiosity in complex environments,
1994; Willmott, Heckbert and Garland, Face cluster radiosity, 1999)
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.patches import ARRAYS, Clusters, Patches

Float = NDArray[np.float64]
Int = NDArray[np.int64]
SMALL, LONG = 0.5, 4.0  # of the length of a patch's edge: the edge of a square, and the diameter, up to which a patch
# may become part of a cluster
REACH = 1.4  # of that length: the edge of the cube in which the pieces of a cluster lie


def clustered(patches: Patches, length: float) -> Patches:
    """Return patches of which small ones are gathered in clusters; length: of a patch's edge, in the scene's unit."""
    plain = np.array([material.texture is None for material in patches.scene.materials])  # texels need their polygon
    plain = plain[np.asarray(patches.scene.material)[patches.polygon]]
    small = np.flatnonzero((patches.area < (SMALL * length) ** 2) & (patches.size < LONG * length) & plain)
    normal = np.round(patches.normal[small], 3)
    side, octant = np.abs(normal).argmax(axis=1), normal >= 0.0  # 24 directions, with which flat ones make a ball
    paint = np.asarray(patches.scene.material)[patches.polygon[small]]
    cube = np.floor(patches.center[small] / (REACH * length)).astype(np.int64)
    _, label, times = np.unique(
        np.column_stack([paint, cube, side, octant]), axis=0, return_inverse=True, return_counts=True
    )
    label = label.ravel()
    several = times[label] > 1
    small, (_, label) = small[several], np.unique(label[several], return_inverse=True)
    if not len(small):
        return patches
    order = np.argsort(label, kind="stable")
    pieces, start = patches.chosen(small[order]), np.searchsorted(label[order], np.arange(label.max() + 2))
    alone = patches.chosen(np.setdiff1d(np.arange(len(patches)), small))
    together = _clusters(pieces, start)
    of = np.concatenate([np.full(len(alone), -1), np.arange(len(together))])
    return replace(_joined(alone, together), clusters=Clusters(of, start, pieces))


def _clusters(pieces: Patches, start: Int) -> Patches:
    """Return a patch for the pieces from number start[k] up to start[k + 1], for each k."""
    begin, many = start[:-1], np.diff(start)
    area = np.add.reduceat(pieces.area, begin)

    def mean(values: Float) -> Float:
        return np.asarray(np.add.reduceat(values * pieces.area[:, None], begin) / area[:, None])

    center, normal = mean(pieces.center), mean(pieces.normal)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    owner = np.repeat(np.arange(len(many)), many)
    off = (pieces.corners - center[owner, None]).reshape(-1, 3)
    spread = np.add.reduceat(np.einsum("nk,nm->nkm", off, off).reshape(-1, 36), begin).reshape(-1, 4, 3, 3).sum(axis=1)
    flat = np.eye(3) - normal[:, :, None] * normal[:, None, :]
    extent, axes = np.linalg.eigh(flat @ spread @ flat)
    x, ratio = axes[:, :, 2], np.sqrt(np.maximum(extent[:, 1], 1e-300) / np.maximum(extent[:, 2], 1e-300))
    x = x - (x * normal).sum(axis=1, keepdims=True) * normal
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    long = np.sqrt(area / np.maximum(ratio, 0.05))
    u, v = x * long[:, None] / 2.0, np.cross(normal, x) * (area / long)[:, None] / 2.0
    corners = np.stack([center - u - v, center + u - v, center + u + v, center - u + v], axis=1)
    largest = np.lexsort((pieces.area, owner))[start[1:] - 1]
    reach = np.maximum.reduceat(np.linalg.norm(off, axis=1).reshape(-1, 4).max(axis=1), begin)
    return Patches(
        pieces.scene, corners, np.full(len(area), 4), pieces.polygon[largest], np.zeros(len(area), np.int64), area,
        center, normal, 2.0 * reach, mean(pieces.rho), mean(pieces.E),
    )  # fmt: skip


def _joined(one: Patches, two: Patches) -> Patches:
    """Return the patches of both, of the same scene."""
    both: dict[str, Any] = {name: np.concatenate([getattr(one, name), getattr(two, name)]) for name in ARRAYS}
    return Patches(one.scene, **both)
