"""Quadrics: spheres, cylinders, discs.

The vertices come in the order of GLU's sample implementation, so that flat shading, lines, points and culling agree:
around an axis x is the sine and y the cosine of the angle, and faces are counterclockwise seen from outside.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from glsim import gl
from glsim.glu import constants
from glsim.glu.errors import GLUError

NAMES = constants.NAMES
FILL, LINE, POINT, SILHOUETTE = (NAMES[f"GLU_{name}"] for name in ("FILL", "LINE", "POINT", "SILHOUETTE"))
SMOOTH, FLAT, NONE = (NAMES[f"GLU_{name}"] for name in ("SMOOTH", "FLAT", "NONE"))
OUTSIDE, INSIDE = NAMES["GLU_OUTSIDE"], NAMES["GLU_INSIDE"]


class Quadric:
    """How quadrics are drawn: gluNewQuadric."""

    def __init__(self) -> None:
        self.style: int = FILL
        self.normals: int = SMOOTH
        self.orientation: int = OUTSIDE
        self.texture = False
        self.on_error: Callable[[int], Any] | None = None

    def normal(self, x: float, y: float, z: float) -> None:
        if self.normals != NONE:
            gl.glNormal3f(x, y, z)

    def fail(self, name: str, sentence: str) -> None:
        """GLU reports errors to the callback; without one they are raised."""
        if self.on_error is None:
            raise GLUError(int(NAMES["GLU_INVALID_VALUE"]), f"{name}: {sentence}")
        self.on_error(int(NAMES["GLU_INVALID_VALUE"]))


def gluNewQuadric() -> Quadric:
    return Quadric()


def gluDeleteQuadric(quad: Quadric) -> None:
    pass


def _choice(name: str, value: int, choices: Iterable[int]) -> int:
    if value not in choices:
        words = " or ".join(map(repr, choices))
        raise GLUError(int(NAMES["GLU_INVALID_ENUM"]), f"{name}: must be {words}, not {value!r}")
    return value


def gluQuadricDrawStyle(quad: Quadric, draw: int) -> None:
    quad.style = _choice("gluQuadricDrawStyle", draw, (FILL, LINE, SILHOUETTE, POINT))


def gluQuadricNormals(quad: Quadric, normal: int) -> None:
    quad.normals = _choice("gluQuadricNormals", normal, (NONE, FLAT, SMOOTH))


def gluQuadricOrientation(quad: Quadric, orientation: int) -> None:
    quad.orientation = _choice("gluQuadricOrientation", orientation, (OUTSIDE, INSIDE))


def gluQuadricTexture(quad: Quadric, texture: bool) -> None:
    quad.texture = bool(texture)


def gluQuadricCallback(quad: Quadric, which: int, function: Callable[[int], Any] | None = None) -> None:
    """function(error code) is called instead of raising."""
    _choice("gluQuadricCallback", which, (NAMES["GLU_ERROR"],))
    quad.on_error = function


def _float32(values: Any) -> list[float]:
    return np.asarray(values, np.float32).astype(np.float64).tolist()  # type: ignore[no-any-return]


def _circle(slices: int, turn: float = 0.0) -> tuple[list[float], list[float]]:
    """Sines and cosines around, in float32; the last is exactly the first.  turn: in slices."""
    angles = np.float32(2.0 * math.pi * (np.arange(slices) + turn) / slices).astype(np.float64)
    sines, cosines = _float32(np.sin(angles)), _float32(np.cos(angles))
    return [*sines, sines[0]], [*cosines, cosines[0]]


# ---------------------------------------------------------------- cylinder


def gluCylinder(quad: Quadric, base: float, top: float, height: float, slices: int, stacks: int) -> None:
    """Around the z axis from z = 0 with radius ``base`` to z = height with radius ``top``; no caps."""
    slices, stacks = int(slices), int(stacks)
    if slices < 2 or stacks < 1 or base < 0 or top < 0 or height < 0:
        quad.fail("gluCylinder", "needs at least 2 slices, 1 stack, and radii and a height of at least 0")
        return
    length = math.hypot(base - top, height)
    if length == 0.0:
        quad.fail("gluCylinder", "has neither height nor different radii")
        return
    side = 1.0 if quad.orientation == OUTSIDE else -1.0
    slope, flank = side * (base - top) / length, side * height / length
    sines, cosines = _circle(slices)
    middle = _circle(slices, -0.5) if quad.normals == FLAT else (sines, cosines)

    def normal(i: int, at: tuple[list[float], list[float]] = (sines, cosines)) -> None:
        quad.normal(flank * at[0][i], flank * at[1][i], slope)

    def vertex(i: int, j: int) -> None:
        if quad.texture:
            gl.glTexCoord2f(1.0 - i / slices, j / stacks)
        radius = base - (base - top) * (j / stacks)
        gl.glVertex3f(radius * sines[i], radius * cosines[i], j * height / stacks)

    if quad.style == FILL:
        for j in range(stacks):
            gl.glBegin(gl.GL_QUAD_STRIP)
            for i in range(slices + 1):
                normal(i, middle)
                for k in (j, j + 1) if quad.orientation == OUTSIDE else (j + 1, j):
                    vertex(i, k)
            gl.glEnd()
    elif quad.style == POINT:
        gl.glBegin(gl.GL_POINTS)
        for i in range(slices):
            normal(i)
            for j in range(stacks + 1):
                vertex(i, j)
        gl.glEnd()
    else:
        rings = [*range(1, stacks), 0, stacks] if quad.style == LINE else [0, stacks]
        for j in rings:
            gl.glBegin(gl.GL_LINE_STRIP)
            for i in range(slices + 1):
                normal(i, middle)
                vertex(i, j)
            gl.glEnd()
        for i in range(slices):
            normal(i)
            gl.glBegin(gl.GL_LINE_STRIP)
            for j in range(stacks + 1):
                vertex(i, j)
            gl.glEnd()


# ---------------------------------------------------------------- discs


def gluDisk(quad: Quadric, inner: float, outer: float, slices: int, loops: int) -> None:
    """In the plane z = 0, with a hole of radius ``inner``."""
    gluPartialDisk(quad, inner, outer, slices, loops, 0.0, 360.0)


def gluPartialDisk(
    quad: Quadric, inner: float, outer: float, slices: int, loops: int, start: float, sweep: float
) -> None:
    """The part of a disc from angle ``start`` on over ``sweep`` degrees; 0 is +y, 90 is +x."""
    slices, loops = int(slices), int(loops)
    if slices < 2 or loops < 1 or outer <= 0 or inner < 0 or inner > outer:
        quad.fail("gluPartialDisk", "needs at least 2 slices, 1 loop, and 0 <= inner <= outer with outer > 0")
        return
    sweep = min(max(sweep, -360.0), 360.0)
    if sweep < 0:
        start, sweep = start + sweep, -sweep
    whole = sweep == 360.0
    angles = math.radians(start) + math.radians(sweep) * np.arange(slices + 1) / slices
    sines, cosines = _float32(np.sin(angles)), _float32(np.cos(angles))
    if whole:
        sines[slices], cosines[slices] = sines[0], cosines[0]
    outside = quad.orientation == OUTSIDE
    quad.normal(0.0, 0.0, 1.0 if outside else -1.0)

    def vertex(i: int, j: int) -> None:
        radius = outer - (outer - inner) * (j / loops)
        if quad.texture:
            scale = radius / outer / 2
            gl.glTexCoord2f(scale * sines[i] + 0.5, scale * cosines[i] + 0.5)
        gl.glVertex3f(radius * sines[i], radius * cosines[i], 0.0)

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
        _strips(vertex, [[(i, j) for j in range(loops + 1)] for i in spokes])
    if inner == outer:
        rings = (0,)
    _strips(vertex, [[(i, j) for i in range(slices + 1)] for j in rings])
    if quad.style == LINE and inner != outer:
        _strips(vertex, [[(i, j) for j in range(loops + 1)] for i in spokes])


def _strips(vertex: Callable[[int, int], None], strips: list[list[tuple[int, int]]]) -> None:
    for strip in strips:
        gl.glBegin(gl.GL_LINE_STRIP)
        for i, j in strip:
            vertex(i, j)
        gl.glEnd()


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


# ---------------------------------------------------------------- sphere


def gluSphere(quad: Quadric, radius: float, slices: int, stacks: int) -> None:
    """Around the origin; the poles are on the z axis."""
    slices, stacks = int(slices), int(stacks)
    if slices < 2 or stacks < 1 or radius < 0:
        quad.fail("gluSphere", "needs at least 2 slices, 1 stack and a radius of at least 0")
        return
    outside = quad.orientation == OUTSIDE
    side = 1.0 if outside else -1.0
    sines, cosines = _circle(slices)
    polar = np.float32(math.pi * np.arange(stacks + 1) / stacks).astype(np.float64)
    ring, axis = _float32(np.sin(polar)), _float32(np.cos(polar))
    radii = [0.0, *(radius * r for r in ring[1:stacks]), 0.0]  # it comes to a point at both ends
    flat_sines, flat_cosines = _circle(slices, -0.5)
    middle = np.float32(math.pi * (np.arange(stacks + 1) - 0.5) / stacks).astype(np.float64)
    flat_ring, flat_axis = _float32(np.sin(middle)), _float32(np.cos(middle))

    def smooth(i: int, j: int) -> None:
        if quad.normals == SMOOTH:
            gl.glNormal3f(side * sines[i] * ring[j], side * cosines[i] * ring[j], side * axis[j])

    def flat(i: int, j: int) -> None:
        if quad.normals == FLAT:
            gl.glNormal3f(
                side * flat_sines[i] * flat_ring[j], side * flat_cosines[i] * flat_ring[j], side * flat_axis[j]
            )

    def vertex(i: int, j: int) -> None:
        if quad.texture:
            gl.glTexCoord2f(1.0 - i / slices, 1.0 - j / stacks)
        gl.glVertex3f(radii[j] * sines[i], radii[j] * cosines[i], radius * axis[j])

    if quad.style == FILL:
        first, last = 0, stacks
        if not quad.texture:  # fans around the poles; with texture the strips go on to them
            first, last = 1, stacks - 1
            for pole, j in ((0, 1), (stacks, stacks - 1)):
                backwards = outside == (pole == 0)
                gl.glBegin(gl.GL_TRIANGLE_FAN)
                smooth(0, pole)
                gl.glVertex3f(0.0, 0.0, radius * axis[pole])
                for i in range(slices, -1, -1) if backwards else range(slices + 1):
                    if not backwards or i < slices:
                        flat(i + backwards, max(j, pole))
                    smooth(i, j)
                    vertex(i, j)
                gl.glEnd()
        for j in range(first, last):
            gl.glBegin(gl.GL_QUAD_STRIP)
            for i in range(slices + 1):
                flat(i, j + 1)
                for k in (j + 1, j) if outside else (j, j + 1):
                    smooth(i, k)
                    vertex(i, k)
            gl.glEnd()
    elif quad.style == POINT:
        gl.glBegin(gl.GL_POINTS)
        for j in range(stacks + 1):
            for i in range(slices):
                if quad.normals != NONE:
                    gl.glNormal3f(side * sines[i] * ring[j], side * cosines[i] * ring[j], side * axis[j])
                vertex(i, j)
        gl.glEnd()
    else:
        for j in range(1, stacks):
            gl.glBegin(gl.GL_LINE_STRIP)
            for i in range(slices + 1):
                flat(i, j)
                smooth(i, j)
                vertex(i, j)
            gl.glEnd()
        for i in range(slices):
            gl.glBegin(gl.GL_LINE_STRIP)
            for j in range(stacks + 1):
                flat(i, j)
                smooth(i, j)
                vertex(i, j)
            gl.glEnd()
