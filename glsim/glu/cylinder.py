"""Quadrics: cylinders and cones."""

from __future__ import annotations

import math

import numpy as np

from glsim import gl
from glsim.glu.quadric import FILL, FLAT, LINE, OUTSIDE, POINT, Quadric, circle, float32, line_strips, rings_of, steps


def gluCylinder(quad: Quadric, base: float, top: float, height: float, slices: int, stacks: int) -> None:
    """Draw a cylinder or cone around the z axis, without caps, from z = 0 to z = height.

    base, top: radii at z = 0 and z = height.  slices: pieces around the axis; stacks: pieces along it.
    """
    slices, stacks = int(slices), int(stacks)
    if slices < 2 or stacks < 1 or base < 0 or top < 0 or height < 0:
        quad.fail("gluCylinder", "needs at least 2 slices, 1 stack, and radii and a height of at least 0")
        return
    if quad.too_many("gluCylinder", slices, stacks):
        return
    length = math.hypot(base - top, height)
    if length == 0.0:
        quad.fail("gluCylinder", "has neither height nor different radii")
        return
    slope, flank = (base - top) / length, height / length
    flank *= quad.side
    sines, cosines = circle(slices)
    x, y = rings_of(steps(base, top, stacks), sines, cosines)
    z = float32(np.arange(stacks + 1) * height / stacks)
    middle = circle(slices, -0.5) if quad.normals == FLAT else (sines, cosines)

    def face_normal(i: int) -> None:
        quad.normal(flank * middle[0][i], flank * middle[1][i], slope)

    def vertex(i: int, j: int) -> None:
        if quad.texture:
            gl.glTexCoord2f(1.0 - i / slices, j / stacks)
        gl.glVertex3f(x[j][i], y[j][i], z[j])

    if quad.style == FILL:
        for j in range(stacks):
            gl.glBegin(gl.GL_QUAD_STRIP)
            for i in range(slices + 1):
                face_normal(i)
                for k in (j, j + 1) if quad.orientation == OUTSIDE else (j + 1, j):
                    vertex(i, k)
            gl.glEnd()
    elif quad.style == POINT:
        gl.glBegin(gl.GL_POINTS)
        for i in range(slices):
            quad.normal(flank * sines[i], flank * cosines[i], slope)
            for j in range(stacks + 1):
                vertex(i, j)
        gl.glEnd()
    else:
        rings = [*range(1, stacks), 0, stacks] if quad.style == LINE else [0, stacks]
        line_strips(vertex, [[(i, j) for i in range(slices + 1)] for j in rings], face_normal)
        for i in range(slices):
            quad.normal(flank * sines[i], flank * cosines[i], 0.0)
            line_strips(vertex, [[(i, j) for j in range(stacks + 1)]])
