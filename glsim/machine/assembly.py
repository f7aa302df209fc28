"""Primitive assembly: which vertices make which triangle, line or point (OpenGL 1.5, section 2.6.1).

Flat shading takes the colour of a primitive from its provoking vertex (table 2.12): the last vertex of a triangle, the
fourth of a quad, the first of a polygon.  The GPU takes it from the LAST vertex of a triangle or line, so each index
pattern in this file puts the provoking vertex last.  The specification does not say along which diagonal a quad is cut
into triangles.  glsim does as Mesa: along v0-v2; but along v1-v3, so that both triangles end in the fourth vertex,
under flat shading, under two-sided lighting, in glDrawElements and in display lists.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl

Indices = NDArray[np.uint32]

# Smallest number of vertices that draws something, and what each further primitive adds.
MINIMUM = {
    gl.GL_POINTS: (1, 1),
    gl.GL_LINES: (2, 2),
    gl.GL_LINE_STRIP: (2, 1),
    gl.GL_LINE_LOOP: (2, 1),
    gl.GL_TRIANGLES: (3, 3),
    gl.GL_TRIANGLE_STRIP: (3, 1),
    gl.GL_TRIANGLE_FAN: (3, 1),
    gl.GL_QUADS: (4, 4),
    gl.GL_QUAD_STRIP: (4, 2),
    gl.GL_POLYGON: (3, 1),
}

# Corners of a primitive -> the mode whose primitives are just that.
PLAIN = {1: gl.GL_POINTS, 2: gl.GL_LINES, 3: gl.GL_TRIANGLES}

# Modes whose primitives share no vertices: several Draws of one mode in a row are like one.
SEPARATE = {gl.GL_POINTS, gl.GL_LINES, gl.GL_TRIANGLES, gl.GL_QUADS}


def corners(mode: int) -> int:
    """3 for modes that make triangles, 2 for lines, 1 for points."""
    if mode == gl.GL_POINTS:
        return 1
    return 2 if mode in (gl.GL_LINES, gl.GL_LINE_STRIP, gl.GL_LINE_LOOP) else 3


def complete(mode: int, count: int) -> int:
    """How many of ``count`` vertices make whole primitives; the rest is ignored."""
    least, step = MINIMUM[mode]  # type: ignore[index]
    return 0 if count < least else count - (count - least) % step


def assemble(mode: int, count: int, last: bool) -> Indices | None:
    """Vertex numbers of the triangles (three each), lines (two) or points that ``count`` vertices make.

    None means 0, 1, 2, ... (nothing to rearrange).  ``last``: both triangles of a quad end in its fourth vertex, the
    provoking one.
    """
    if mode in (gl.GL_POINTS, gl.GL_LINES, gl.GL_TRIANGLES):
        return None
    pattern = _small_pattern if count <= 4096 else _pattern
    return pattern(mode, complete(mode, count), last)


def _pattern(mode: int, count: int, last: bool) -> Indices:
    if count == 0:
        return np.empty(0, np.uint32)
    i = np.arange(count, dtype=np.uint32)
    if mode == gl.GL_LINE_STRIP:
        return _pack(i[:-1], i[1:])
    if mode == gl.GL_LINE_LOOP:
        return _pack(i, np.roll(i, -1))
    if mode == gl.GL_TRIANGLE_STRIP:
        k = i[:-2]
        odd = k % 2
        return _pack(k + odd, k + 1 - odd, k + 2)
    if mode == gl.GL_TRIANGLE_FAN:
        return _pack(np.zeros_like(i[1:-1]), i[1:-1], i[2:])
    if mode == gl.GL_POLYGON:
        return _pack(i[1:-1], i[2:], np.zeros_like(i[1:-1]))
    k = i[::4] if mode == gl.GL_QUADS else i[:-2:2]
    a, b, c, d = (k, k + 1, k + 2, k + 3) if mode == gl.GL_QUADS else (k, k + 1, k + 3, k + 2)
    if mode == gl.GL_QUAD_STRIP:
        return _pack(a, b, c, d, a, c)  # the provoking vertex is 2i + 4, here c
    return _pack(a, b, d, b, c, d) if last else _pack(a, b, c, a, c, d)


def primitives(mode: int, count: int, indices: Indices | None, last: bool) -> Indices:
    """The vertex numbers of ``assemble``, also where nothing is rearranged.

    count: how many vertices there are.  indices: their order (glDrawElements), or None for 0, 1, 2, ..., count - 1.
    """
    pattern = assemble(mode, count, last)
    if indices is None:
        return np.arange(complete(mode, count), dtype=np.uint32) if pattern is None else pattern
    return indices[: complete(mode, count)] if pattern is None else indices[pattern]


_small_pattern = lru_cache(maxsize=512)(_pattern)


def outlines(mode: int, count: int) -> tuple[Indices, Indices]:
    """The polygons that ``count`` vertices make, for modes that make areas: (rings, provoking).

    rings: (n, corners) vertex numbers around each polygon; provoking: (n,) the vertex whose colour a flat one takes.
    """
    count = complete(mode, count)
    i = np.arange(count, dtype=np.uint32)
    if mode == gl.GL_POLYGON:
        return i[None] if count else i.reshape(0, 3), i[:1]
    if mode == gl.GL_QUADS:
        rings = i.reshape(-1, 4)
        return rings, rings[:, 3]
    if mode == gl.GL_QUAD_STRIP:
        a = i[:-2:2]
        return np.stack([a, a + 1, a + 3, a + 2], axis=1), a + 3
    triangles = assemble(mode, count, last=False)
    rings = (i if triangles is None else triangles).reshape(-1, 3)
    return rings, rings[:, 2]


def counterclockwise(clip: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which polygons (n, k, 4) in clip coordinates turn counterclockwise on the screen: the sign of the area of their
    visible part (equation 3.7)."""
    xyw = clip[..., [0, 1, 3]]
    area = np.zeros(len(xyw))
    for k in range(1, xyw.shape[1] - 1):
        area += np.linalg.det(xyw[:, [0, k, k + 1]])
    return area > 0


def _pack(*columns: Indices) -> Indices:
    indices = np.stack(columns, axis=1).ravel()
    indices.flags.writeable = False  # shared through the cache
    return indices
