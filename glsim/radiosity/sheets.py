"""Which polygons are parts of sheets, and which of the surfaces of bodies; coplanar triangles as quads."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Float = NDArray[np.float64]
Int = NDArray[np.int64]
SAME = 1e-4  # of the scene's size: corners this near are one
FLAT = 1e-6  # how far the fourth corner of a quad may be from the plane of the others, in diameters


def places(polygons: Sequence[Float]) -> tuple[Int, Int]:
    """Return for each corner of all polygons, in order, the number of its polygon and the number of its position.

    Corners with equal positions (see SAME) have the same number.
    """
    points = np.concatenate(polygons)
    unit = SAME * max(float(np.linalg.norm(np.ptp(points, axis=0))), 1e-300)
    owner = np.repeat(np.arange(len(polygons)), [len(polygon) for polygon in polygons])
    return owner, np.unique(np.round(points / unit), axis=0, return_inverse=True)[1].ravel()


def sheets(polygons: Sequence[Float]) -> NDArray[np.bool_]:
    """Return whether each polygon is part of a sheet, and not of a body's surface: (n,).

    A sheet has an edge along which no other polygon runs in the opposite direction.
    """
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    owner, place = places(polygons)
    following = np.concatenate([np.roll(part, -1) for part in np.split(place, np.flatnonzero(np.diff(owner)) + 1)])
    n, many = len(polygons), len(place)
    label = connected_components(coo_matrix((np.ones(many), (owner, n + place)), shape=(n + many,) * 2), False)[1]
    real = place != following  # a pole's edges may have no length
    alone = ~np.isin(following * many + place, place * many + following) & real
    return np.asarray(np.isin(label[:n], label[owner[alone]]))


def quads(corners: Float, pairs: Int, st: Float | None = None) -> tuple[Int, NDArray[np.bool_]]:
    """Join pairs of triangles that are halves of one flat quad: patches of a quad are better than slivers of two.

    corners: (m, 3, 3) of the triangles; pairs: (k, 2), triangles that share an edge and have one material; st:
    (m, 3, 2) texture coordinates, which must fit too.  Return the quads (q, 4), as numbers of rows of corners (3 m),
    and which triangles (m,) are in none.  Two are joined along the longest edge of both, so that the quad is convex.
    """
    alone = np.ones(len(corners), bool)
    edges = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    first = edges.argmax(axis=1)[pairs]  # (k, 2): the longest edge's first corner
    at = 3 * pairs[:, :, None] + (first[:, :, None] + np.arange(3)) % 3  # its start, its end, and the tip
    (start, end, tip), (other_end, other_start, other_tip) = (np.moveaxis(at, 2, 0)[:, :, k] for k in (0, 1))
    four = np.stack([start, other_tip, end, tip], axis=1)
    points = corners.reshape(-1, 3)
    size = np.linalg.norm(points[end] - points[start], axis=1)
    good = np.linalg.norm(points[start] - points[other_start], axis=1) < FLAT * size
    good &= np.linalg.norm(points[end] - points[other_end], axis=1) < FLAT * size
    a, b, c, d = (points[four[:, k]] for k in range(4))
    normal = np.cross(c - a, d - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    good &= np.abs(((b - a) * normal).sum(axis=1)) < FLAT * size
    if st is not None:  # b = a + x (c - a) + y (d - a), and its texture coordinates follow
        s, t = (np.moveaxis(st.reshape(-1, 2)[four], 1, 0)[..., k] for k in (0, 1))
        area = (np.cross(c - a, d - a) * normal).sum(axis=1)
        x = (np.cross(b - a, d - a) * normal).sum(axis=1) / np.maximum(area, 1e-300)
        y = (np.cross(c - a, b - a) * normal).sum(axis=1) / np.maximum(area, 1e-300)
        for w in (s, t):
            good &= np.abs(w[0] + x * (w[2] - w[0]) + y * (w[3] - w[0]) - w[1]) < 1e-4
    chosen = []
    for k in np.flatnonzero(good).tolist():
        if alone[pairs[k]].all():
            alone[pairs[k]] = False
            chosen.append(k)
    return four[chosen].reshape(-1, 4), alone
