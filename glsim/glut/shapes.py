"""What GLUT's shapes have in common; they are in revolved.py, polyhedra.py and teaset.py.

Vertices, normals and their order are freeglut 3.4's, number by number in float32, so that flat shading, lines, points
and culling agree.  Faces are counterclockwise seen from outside.  Lengths are in object coordinates.
"""

from __future__ import annotations

import math
import operator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.machine.assembly import assemble
from glsim.machine.cache import cached
from glsim.machine.errors import show

Array = NDArray[np.float32]
Indices = NDArray[np.int64]
MEMORY = 64 * 1024 * 1024  # bytes of shapes that each function keeps
MOST_PIECES = 1 << 20  # of a shape: slices times stacks


class Part(NamedTuple):
    """``pieces`` primitives of one mode, each of ``size`` vertices."""

    mode: int
    pieces: int
    size: int


class Shape(NamedTuple):
    """What one call draws: vertices and normals (n, 3) in the order in which they are drawn."""

    vertices: Array
    normals: Array
    texture: Array | None  # (n, 2)
    parts: tuple[Part, ...]


def geometry(vertices: Array, normals: Array, *pieces: tuple[int, Indices], texture: Array | None = None) -> Shape:
    """pieces: a mode and indices (primitives, vertices of each)."""
    order = np.concatenate([indices.ravel() for _, indices in pieces])
    drawn = [None if array is None else array[order] for array in (vertices, normals, texture)]
    for array in drawn:
        if array is not None:
            array.flags.writeable = False  # it stays in a cache
    parts = tuple(Part(mode, *indices.shape) for mode, indices in pieces)
    return Shape(drawn[0], drawn[1], drawn[2], parts)  # type: ignore[arg-type]


@cached(MEMORY)
def _triangles(first: int, strips: int, size: int) -> NDArray[np.uint32]:
    """The triangles of triangle strips of ``size`` vertices each, in their order: one call instead of many."""
    pattern = assemble(gl.GL_TRIANGLE_STRIP, size, last=False)
    assert pattern is not None
    return (first + size * np.arange(strips, dtype=np.uint32)[:, None] + pattern).astype(np.uint32).ravel()


def draw_geometry(shape: Shape) -> None:
    """As freeglut: the vertex arrays are enabled before and disabled after, the current normal stays."""
    buffer = gl.glGetIntegerv(gl.GL_ARRAY_BUFFER_BINDING)
    if buffer:
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, 0)
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glEnableClientState(gl.GL_NORMAL_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, shape.vertices)
    gl.glNormalPointer(gl.GL_FLOAT, 0, shape.normals)
    if shape.texture is not None:
        gl.glEnableClientState(gl.GL_TEXTURE_COORD_ARRAY)
        gl.glTexCoordPointer(2, gl.GL_FLOAT, 0, shape.texture)
    first = 0
    for mode, pieces, size in shape.parts:
        if mode == gl.GL_TRIANGLE_STRIP and pieces > 1:
            triangles = _triangles(first, pieces, size)
            gl.glDrawElements(gl.GL_TRIANGLES, triangles.size, gl.GL_UNSIGNED_INT, triangles)
            first += pieces * size
            continue
        for _ in range(pieces):
            gl.glDrawArrays(mode, first, size)
            first += size
    gl.glDisableClientState(gl.GL_VERTEX_ARRAY)
    gl.glDisableClientState(gl.GL_NORMAL_ARRAY)
    if shape.texture is not None:
        gl.glDisableClientState(gl.GL_TEXTURE_COORD_ARRAY)
    if buffer:
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffer)


def rows(*columns: Any) -> Array:
    """Points (n, 3) from their three coordinates, broadcast against each other."""
    return np.stack(np.broadcast_arrays(*columns), axis=-1).astype(np.float32).reshape(-1, 3)


# ---------------------------------------------------------------- arguments


def length(name: str, argument: str, value: Any) -> float:
    """The number as float32, as freeglut takes it."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        with np.errstate(over="ignore"):
            number = float(np.float32(float(value)))
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name}: {argument} must be a number, not {show(value)}") from None
    if not math.isfinite(number):
        raise ValueError(f"{name}: {argument} must be a finite number, not {show(value)}")
    return number


def whole(name: str, argument: str, value: Any, least: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: {argument} must be a whole number, not {value!r}") from None
    if number < least:
        raise ValueError(f"{name}: {argument} must be at least {least}, not {number}")
    return number


def pieces_of(name: str, one: str, n: Any, least: int, other: str, k: Any, least_other: int) -> tuple[int, int]:
    """The numbers of pieces both ways around."""
    n, k = whole(name, one, n, least), whole(name, other, k, least_other)
    if n * k > MOST_PIECES:
        raise ValueError(f"{name}: {one} times {other} must be at most {MOST_PIECES}, not {n} * {k}")
    return n, k
