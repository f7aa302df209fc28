"""Quadrics: spheres, cylinders, discs.

The vertices come in the order of GLU's sample implementation, so that flat shading, lines, points and culling agree:
around an axis x is the sine and y the cosine of the angle, and faces are counterclockwise seen from outside.  Numbers
are rounded to float32 where that implementation rounds them, so that the same pixels are covered.  Even its wrong
normals are copied: along the lines of a cylinder they ignore the slope of the side.  Only for points and silhouettes
with GLU_FLAT, where that implementation reads memory it never set, glsim computes the right normals.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu import constants
from glsim.glu.errors import one_of, warn

NAMES = constants.NAMES
FILL, LINE, POINT, SILHOUETTE = (NAMES[f"GLU_{name}"] for name in ("FILL", "LINE", "POINT", "SILHOUETTE"))
SMOOTH, FLAT, NONE = (NAMES[f"GLU_{name}"] for name in ("SMOOTH", "FLAT", "NONE"))
GLU_ERROR = NAMES["GLU_ERROR"]
OUTSIDE, INSIDE = NAMES["GLU_OUTSIDE"], NAMES["GLU_INSIDE"]


MOST_PIECES = 1 << 20  # of a shape: slices times stacks


class Quadric:
    """How quadrics are drawn: gluNewQuadric."""

    def __init__(self) -> None:
        self.style: int = FILL
        self.normals: int = SMOOTH
        self.orientation: int = OUTSIDE
        self.texture = False
        self.on_error: Callable[[int], Any] | None = None

    @property
    def side(self) -> float:
        return 1.0 if self.orientation == OUTSIDE else -1.0

    def normal(self, x: float, y: float, z: float) -> None:
        if self.normals != NONE:
            gl.glNormal3f(x, y, z)

    def fail(self, name: str, sentence: str, error: str = "GLU_INVALID_VALUE") -> None:
        """GLU reports errors to the callback; without one there is a warning."""
        if self.on_error is None:
            warn(NAMES[error], f"{name}: {sentence}")
        else:
            self.on_error(NAMES[error])

    def too_many(self, name: str, *pieces: int) -> bool:
        """Report that a shape of so many pieces both ways is not drawn."""
        if pieces[0] * pieces[1] <= MOST_PIECES:
            return False
        self.fail(name, f"draws at most {MOST_PIECES} pieces, not {pieces[0]} * {pieces[1]}", "GLU_OUT_OF_MEMORY")
        return True

    def choose(self, field: str, name: str, value: int, choices: tuple[int, ...]) -> None:
        """Set a field to one of the choices."""
        if value in choices:
            setattr(self, field, value)
        else:
            argument = {"style": "draw", "normals": "normal"}.get(field, field)
            self.fail(name, f"{argument} must be {one_of(choices)}, not {value!r}", "GLU_INVALID_ENUM")


def gluNewQuadric() -> Quadric:
    """A new object for gluSphere, gluCylinder and gluDisk: filled, smooth normals outwards, no texture coordinates."""
    return Quadric()


def gluDeleteQuadric(quad: Quadric) -> None:
    """Accepted without effect: Python frees the object."""


def gluQuadricDrawStyle(quad: Quadric, draw: int) -> None:
    """Draw quadrics as ``draw`` says: GLU_FILL, GLU_LINE, GLU_SILHOUETTE (no lines between faces) or GLU_POINT."""
    quad.choose("style", "gluQuadricDrawStyle", draw, (FILL, LINE, SILHOUETTE, POINT))


def gluQuadricNormals(quad: Quadric, normal: int) -> None:
    """normal: GLU_SMOOTH gives one normal a vertex, GLU_FLAT one a face, GLU_NONE none."""
    quad.choose("normals", "gluQuadricNormals", normal, (NONE, FLAT, SMOOTH))


def gluQuadricOrientation(quad: Quadric, orientation: int) -> None:
    """orientation: the side that normals point to and that faces show, GLU_OUTSIDE or GLU_INSIDE."""
    quad.choose("orientation", "gluQuadricOrientation", orientation, (OUTSIDE, INSIDE))


def gluQuadricTexture(quad: Quadric, texture: bool) -> None:
    """texture: whether quadrics get texture coordinates."""
    quad.texture = bool(texture)


def gluQuadricCallback(quad: Quadric, which: int = GLU_ERROR, function: Callable[[int], Any] | None = None) -> None:
    """Set the error callback: function(error code) is called at each error.  None: GLU issues a GLUWarning instead."""
    if which != GLU_ERROR:
        quad.fail("gluQuadricCallback", f"which must be GLU_ERROR, not {which!r}", "GLU_INVALID_ENUM")
    quad.on_error = function


Single = NDArray[np.float32]


def _float32(values: Any) -> list[float]:
    return np.asarray(values, np.float32).astype(np.float64).tolist()  # type: ignore[no-any-return]


def _steps(first: float, last: float, count: int) -> Single:
    """From first to last in count steps, in float32 as GLU has them."""
    fractions = np.arange(count + 1, dtype=np.float32) / np.float32(count)
    way = (np.float32(first - last) * fractions).astype(np.float64)
    return (first - way).astype(np.float32)


def _circle(slices: int, turn: float = 0.0) -> tuple[list[float], list[float]]:
    """Sines and cosines around; the last is exactly the first.  turn: in slices."""
    angles = np.float32(2.0 * math.pi * (np.arange(slices) + turn) / slices).astype(np.float64)
    sines, cosines = _float32(np.sin(angles)), _float32(np.cos(angles))
    return [*sines, sines[0]], [*cosines, cosines[0]]


def _rings(radii: Single, sines: list[float], cosines: list[float]) -> tuple[list[list[float]], list[list[float]]]:
    """x and y of the vertices, [ring][slice]."""
    x, y = (_float32(np.multiply.outer(radii, np.array(around, np.float32))) for around in (sines, cosines))
    return x, y  # type: ignore[return-value]


# ---------------------------------------------------------------- cylinder


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
    sines, cosines = _circle(slices)
    x, y = _rings(_steps(base, top, stacks), sines, cosines)
    z = _float32(np.arange(stacks + 1) * height / stacks)
    middle = _circle(slices, -0.5) if quad.normals == FLAT else (sines, cosines)

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
        _strips(vertex, [[(i, j) for i in range(slices + 1)] for j in rings], face_normal)
        for i in range(slices):
            quad.normal(flank * sines[i], flank * cosines[i], 0.0)
            _strips(vertex, [[(i, j) for j in range(stacks + 1)]])


# ---------------------------------------------------------------- discs


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
    sines, cosines = _float32(np.sin(angles)), _float32(np.cos(angles))
    if whole:
        sines[slices], cosines[slices] = sines[0], cosines[0]
    outside = quad.orientation == OUTSIDE
    quad.normal(0.0, 0.0, quad.side)
    radii = _steps(outer, inner, loops)
    x, y = _rings(radii, sines, cosines)
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
        _strips(vertex, [[(i, j) for j in range(loops + 1)] for i in spokes])
    if inner == outer:
        rings = (0,)
    _strips(vertex, [[(i, j) for i in range(slices + 1)] for j in rings])
    if quad.style == LINE and inner != outer:
        _strips(vertex, [[(i, j) for j in range(loops + 1)] for i in spokes])


def _strips(
    vertex: Callable[[int, int], None],
    strips: list[list[tuple[int, int]]],
    normal: Callable[[int], None] = lambda i: None,
) -> None:
    for strip in strips:
        gl.glBegin(gl.GL_LINE_STRIP)
        for i, j in strip:
            normal(i)
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


class _Sphere:
    """The vertices of a sphere and their normals; i: slice, j: stack from the pole at +z."""

    def __init__(self, quad: Quadric, radius: float, slices: int, stacks: int) -> None:
        self.quad, self.slices, self.stacks = quad, slices, stacks
        self.sines, self.cosines = _circle(slices)
        polar = np.float32(math.pi * np.arange(stacks + 1) / stacks).astype(np.float64)
        self.ring, self.axis = _float32(np.sin(polar)), _float32(np.cos(polar))
        radii = (radius * np.sin(polar)).astype(np.float32)
        radii[[0, stacks]] = 0.0  # it comes to a point at both ends
        self.x, self.y = _rings(radii, self.sines, self.cosines)
        self.z = _float32(np.float32(radius * np.cos(polar)))
        self.flat_sines, self.flat_cosines = _circle(slices, -0.5)
        between = np.float32(math.pi * (np.arange(stacks + 1) - 0.5) / stacks).astype(np.float64)
        self.flat_ring, self.flat_axis = _float32(np.sin(between)), _float32(np.cos(between))

    def smooth(self, i: int, j: int) -> None:
        """The normal of a vertex."""
        side, ring = self.quad.side, self.ring[j]
        if self.quad.normals == SMOOTH:
            gl.glNormal3f(side * self.sines[i] * ring, side * self.cosines[i] * ring, side * self.axis[j])

    def flat(self, i: int, j: int) -> None:
        """With GLU_FLAT: the normal of the face between slices i - 1 and i and stacks j - 1 and j."""
        side, ring = self.quad.side, self.flat_ring[j]
        if self.quad.normals == FLAT:
            gl.glNormal3f(
                side * self.flat_sines[i] * ring, side * self.flat_cosines[i] * ring, side * self.flat_axis[j]
            )

    def vertex(self, i: int, j: int) -> None:
        if self.quad.texture:
            gl.glTexCoord2f(1.0 - i / self.slices, 1.0 - j / self.stacks)
        gl.glVertex3f(self.x[j][i], self.y[j][i], self.z[j])

    def fan(self, pole: int, j: int) -> None:
        """The triangles between a pole and the ring beside it."""
        backwards = (self.quad.orientation == OUTSIDE) == (pole == 0)
        gl.glBegin(gl.GL_TRIANGLE_FAN)
        self.smooth(0, pole)
        gl.glVertex3f(0.0, 0.0, self.z[pole])
        for i in range(self.slices, -1, -1) if backwards else range(self.slices + 1):
            if not backwards or i < self.slices:
                self.flat(i + backwards, max(j, pole))
            self.smooth(i, j)
            self.vertex(i, j)
        gl.glEnd()

    def strip(self, j: int) -> None:
        """The faces between two rings."""
        first, second = (j + 1, j) if self.quad.orientation == OUTSIDE else (j, j + 1)
        gl.glBegin(gl.GL_QUAD_STRIP)
        for i in range(self.slices + 1):
            self.smooth(i, first)
            self.vertex(i, first)
            self.flat(i, j + 1)
            self.smooth(i, second)
            self.vertex(i, second)
        gl.glEnd()

    def points(self) -> None:
        gl.glBegin(gl.GL_POINTS)
        for j in range(self.stacks + 1):
            for i in range(self.slices):
                around, along = self.quad.side * self.ring[j], self.quad.side * self.axis[j]
                self.quad.normal(self.sines[i] * around, self.cosines[i] * around, along)
                self.vertex(i, j)
        gl.glEnd()

    def lines(self) -> None:
        """Rings, and arcs from pole to pole."""
        side = self.quad.side
        for j in range(1, self.stacks):
            gl.glBegin(gl.GL_LINE_STRIP)
            for i in range(self.slices + 1):
                if self.quad.normals == FLAT:
                    x, y = self.flat_sines[i] * self.ring[j], self.flat_cosines[i] * self.ring[j]
                    gl.glNormal3f(side * x, side * y, side * self.axis[j])
                self.smooth(i, j)
                self.vertex(i, j)
            gl.glEnd()
        for i in range(self.slices):
            gl.glBegin(gl.GL_LINE_STRIP)
            for j in range(self.stacks + 1):
                if self.quad.normals == FLAT:
                    x, y = self.sines[i] * self.flat_ring[j], self.cosines[i] * self.flat_ring[j]
                    gl.glNormal3f(side * x, side * y, side * self.flat_axis[j])
                self.smooth(i, j)
                self.vertex(i, j)
            gl.glEnd()


def gluSphere(quad: Quadric, radius: float, slices: int, stacks: int) -> None:
    """Draw a sphere around the origin whose poles lie on the z axis.

    radius: in object coordinates.  slices: pieces around the z axis (of longitude); stacks: along it (of latitude).
    """
    slices, stacks = int(slices), int(stacks)
    if slices < 2 or stacks < 1 or radius < 0:
        quad.fail("gluSphere", "needs at least 2 slices, 1 stack and a radius of at least 0")
        return
    if quad.too_many("gluSphere", slices, stacks):
        return
    sphere = _Sphere(quad, radius, slices, stacks)
    if quad.style == POINT:
        sphere.points()
    elif quad.style != FILL:
        sphere.lines()
    else:
        first, last = 0, stacks
        if not quad.texture:  # fans around the poles; with texture the strips go on to them
            first, last = 1, stacks - 1
            sphere.fan(0, 1)
            sphere.fan(stacks, stacks - 1)
        for j in range(first, last):
            sphere.strip(j)
