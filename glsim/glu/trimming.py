"""Trimming a NURBS surface: which part of the parameters (u, v) lies on the left of the loops."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.glu import tess
from glsim.glu.constants import NAMES

Float = NDArray[np.float64]


def inside(u: Float, v: Float, loops: list[Float]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which cells of the grid lie inside the trimming loops (on their left), and which may be cut by them."""
    winding = np.zeros((len(u) - 1, len(v) - 1), np.int64)
    cut = np.zeros_like(winding, bool)
    x, y = ((u[:-1] + u[1:]) / 2)[:, None], ((v[:-1] + v[1:]) / 2)[None]
    for loop in loops:
        for (x0, y0), (x1, y1) in zip(loop, np.roll(loop, -1, axis=0), strict=True):
            left = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) > 0
            winding += (y0 <= y) & (y < y1) & left
            winding -= (y1 <= y) & (y < y0) & ~left
            near_u = (u[:-1] < max(x0, x1)) & (u[1:] > min(x0, x1))
            near_v = (v[:-1] < max(y0, y1)) & (v[1:] > min(y0, y1))
            cut |= near_u[:, None] & near_v[None]
    return (winding > 0) & ~cut, cut


def filled(loops: list[list[tuple[float, float]]]) -> list[tuple[float, float]]:
    """The corners of triangles that fill loops."""
    corners: list[tuple[float, float]] = []
    cutter = tess.gluNewTess()
    tess.gluTessProperty(cutter, NAMES["GLU_TESS_WINDING_RULE"], NAMES["GLU_TESS_WINDING_POSITIVE"])
    tess.gluTessNormal(cutter, 0, 0, 1)
    tess.gluTessCallback(cutter, NAMES["GLU_TESS_VERTEX"], corners.append)
    tess.gluTessCallback(cutter, NAMES["GLU_TESS_COMBINE"], lambda at, data, weights: (at[0], at[1]))
    tess.gluTessBeginPolygon(cutter)
    for loop in loops:
        tess.gluTessBeginContour(cutter)
        for x, y in loop:
            tess.gluTessVertex(cutter, (x, y, 0.0), (x, y))
        tess.gluTessEndContour(cutter)
    tess.gluTessEndPolygon(cutter)
    return corners


def holds(loops: list[Float], x: float, y: float) -> bool:
    """Whether a point lies inside the trimming loops."""
    return bool(inside(np.array([x, x]), np.array([y, y]), loops)[0].any())


def clipped(loop: Float, low: float, high: float, bottom: float, top: float) -> list[tuple[float, float]]:
    """A loop cut to a rectangle (Sutherland and Hodgman)."""
    points = [(float(x), float(y)) for x, y in loop]
    for axis, limit, sign in ((0, low, 1), (0, high, -1), (1, bottom, 1), (1, top, -1)):
        corners: list[tuple[float, float]] = []
        for a, b in zip(points, [*points[1:], *points[:1]], strict=True):
            inside_a, inside_b = sign * (a[axis] - limit) >= 0, sign * (b[axis] - limit) >= 0
            if inside_a:
                corners.append(a)
            if inside_a != inside_b:
                t = (limit - a[axis]) / (b[axis] - a[axis])
                corners.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
        points = corners
    return points
