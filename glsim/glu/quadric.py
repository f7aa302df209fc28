"""Quadrics: how they are drawn, and what cylinder.py, disc.py and sphere.py have in common.

The vertices come in the order of GLU's sample implementation, so that flat shading, lines, points and culling agree:
around an axis x is the sine and y the cosine of the angle, and faces are counterclockwise seen from outside.  Numbers
are rounded to float32 where that implementation rounds them, so that the same pixels are covered.  Even its wrong
normals are copied: along the lines of a cylinder they ignore the slope of the side.  Only for points and silhouettes
with GLU_FLAT, where that implementation reads memory it never set, glsim computes the right normals.
"""

from __future__ import annotations

import math
from collections.abc import Callable
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


def float32(values: Any) -> list[float]:
    return np.asarray(values, np.float32).astype(np.float64).tolist()  # type: ignore[no-any-return]


def steps(first: float, last: float, count: int) -> Single:
    """From first to last in count steps, in float32 as GLU has them."""
    fractions = np.arange(count + 1, dtype=np.float32) / np.float32(count)
    covered = (np.float32(first - last) * fractions).astype(np.float64)
    return (first - covered).astype(np.float32)


def circle(slices: int, turn: float = 0.0) -> tuple[list[float], list[float]]:
    """Sines and cosines around; the last is exactly the first.  turn: in slices."""
    angles = np.float32(2.0 * math.pi * (np.arange(slices) + turn) / slices).astype(np.float64)
    sines, cosines = float32(np.sin(angles)), float32(np.cos(angles))
    return [*sines, sines[0]], [*cosines, cosines[0]]


def rings_of(radii: Single, sines: list[float], cosines: list[float]) -> tuple[list[list[float]], list[list[float]]]:
    """x and y of the vertices, [ring][slice]."""
    x, y = (float32(np.multiply.outer(radii, np.array(around, np.float32))) for around in (sines, cosines))
    return x, y  # type: ignore[return-value]


def line_strips(
    vertex: Callable[[int, int], None],
    strips: list[list[tuple[int, int]]],
    normal: Callable[[int], None] = lambda i: None,
) -> None:
    """Each strip as one line: vertex(i, j) is called for its points, after normal(i)."""
    for strip in strips:
        gl.glBegin(gl.GL_LINE_STRIP)
        for i, j in strip:
            normal(i)
            vertex(i, j)
        gl.glEnd()
