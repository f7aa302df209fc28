"""Quadrics: discs and parts of discs."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

import numpy as np

from glsim import gl
from glsim.glu.quadric import FILL, LINE, OUTSIDE, POINT, SILHOUETTE, Quadric, float32, line_strips, rings_of, steps


def gluDisk(quad: Quadric, inner: float, outer: float, slices: int, loops: int) -> None:
    """Draw a disc in the plane z = 0 around the origin, seen from +z.

    inner: radius of the hole, 0 for none.  outer: radius of the disc.  slices: pieces around; loops: rings.
    """
    gluPartialDisk(quad, inner, outer, slices, loops, 0.0, 360.0)


def gluPartialDisk(
    quad: Quadric, inner: float, outer: float, slices: int, loops: int, start: float, sweep: float
) -> None:
    """The part of a disc from angle ``start`` on over ``sweep`` degrees; 0 is +y, 90 is +x."""
    slices, loops = int(slices), int(loops)
    if slices < 2 or loops < 1 or outer <= 0 or inner < 0 or inner > outer:
        quad.fail("gluPartialDisk", "needs at least 2 slices, 1 loop, and 0 <= inner <= outer with outer > 0")
        return
    if quad.too_many("gluPartialDisk", slices, loops):
        return
    sweep = min(max(sweep, -360.0), 360.0)
    if sweep < 0:
        start, sweep = start + sweep, -sweep
    whole = sweep == 360.0
    turn = math.pi * sweep / 180.0 * np.arange(slices + 1) / slices
    angles = np.float32(np.float32(start / 180.0 * math.pi) + turn).astype(np.float64)
    sines, cosines = float32(np.sin(angles)), float32(np.cos(angles))
    if whole:
        sines[slices], cosines[slices] = sines[0], cosines[0]
    outside = quad.orientation == OUTSIDE
    quad.normal(0.0, 0.0, quad.side)
    radii = steps(outer, inner, loops)
    x, y = rings_of(radii, sines, cosines)
    scales = [float(radius) / outer / 2 for radius in radii]

    def vertex(i: int, j: int) -> None:
        if quad.texture:
            gl.glTexCoord2f(scales[j] * sines[i] + 0.5, scales[j] * cosines[i] + 0.5)
        gl.glVertex3f(x[j][i], y[j][i], 0.0)

    if quad.style == FILL:
        _fill_disk(quad, vertex, slices, loops, inner == 0.0, outside)
        return
    if quad.style == POINT:
        gl.glBegin(gl.GL_POINTS)
        for i in range(slices if whole else slices + 1):
            for j in range(loops + 1):
                vertex(i, j)
        gl.glEnd()
        return
    spokes = range(slices if whole else slices + 1)
    rings: Iterable[int] = range(loops + 1)
    if quad.style == SILHOUETTE:
        spokes, rings = range(0, 0 if whole else slices + 1, slices), (0, loops)
        line_strips(vertex, [[(i, j) for j in range(loops + 1)] for i in spokes])
    if inner == outer:
        rings = (0,)
    line_strips(vertex, [[(i, j) for i in range(slices + 1)] for j in rings])
    if quad.style == LINE and inner != outer:
        line_strips(vertex, [[(i, j) for j in range(loops + 1)] for i in spokes])


def _fill_disk(
    quad: Quadric, vertex: Callable[[int, int], None], slices: int, loops: int, closed: bool, outside: bool
) -> None:
    """A fan in the middle if there is no hole, and strips around it."""
    if closed:
        gl.glBegin(gl.GL_TRIANGLE_FAN)
        if quad.texture:
            gl.glTexCoord2f(0.5, 0.5)
        gl.glVertex3f(0.0, 0.0, 0.0)
        for i in range(slices, -1, -1) if outside else range(slices + 1):
            vertex(i, loops - 1)
        gl.glEnd()
    for j in range(loops - 1 if closed else loops):
        gl.glBegin(gl.GL_QUAD_STRIP)
        for i in range(slices + 1):
            for k in (j, j + 1) if outside else (j + 1, j):
                vertex(i, k)
        gl.glEnd()
