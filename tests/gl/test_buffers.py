"""Buffer objects and occlusion queries."""

from __future__ import annotations

import ctypes

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.gl import GLError

CORNERS = np.array([(-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0)], np.float32)


def vertices_in_a_buffer(usage: int = GL_STATIC_DRAW) -> int:
    name = int(glGenBuffers(1))
    glBindBuffer(GL_ARRAY_BUFFER, name)
    glBufferData(GL_ARRAY_BUFFER, CORNERS.nbytes, CORNERS, usage)
    glVertexPointer(3, GL_FLOAT, 0, None)
    glBindBuffer(GL_ARRAY_BUFFER, 0)
    glEnableClientState(GL_VERTEX_ARRAY)
    return name


def drawn(screen: glsim.Offscreen) -> np.ndarray:
    glClear(GL_COLOR_BUFFER_BIT)
    glDrawArrays(GL_QUADS, 0, 4)
    return screen.pixels()[..., :3]


def test_vertices_come_from_the_buffer(screen: glsim.Offscreen) -> None:
    vertices_in_a_buffer()
    picture = drawn(screen)
    glVertexPointer(3, GL_FLOAT, 0, CORNERS)
    assert (drawn(screen) == picture).all()
    assert picture.any(axis=2).sum() == 64 * 64


def test_a_changed_buffer_draws_anew(screen: glsim.Offscreen) -> None:
    name = vertices_in_a_buffer()
    assert drawn(screen).any(axis=2).sum() == 64 * 64
    assert drawn(screen).any(axis=2).sum() == 64 * 64
    glBindBuffer(GL_ARRAY_BUFFER, name)
    glBufferSubData(GL_ARRAY_BUFFER, 24, 12, np.array([0.5, 0.0, 0.0], np.float32))
    assert drawn(screen).any(axis=2).sum() < 64 * 64


def test_the_current_colour_goes_with_buffers(screen: glsim.Offscreen) -> None:
    vertices_in_a_buffer()
    for color in ((1, 0, 0), (0, 1, 0)):
        glColor3f(*color)
        assert drawn(screen)[64, 64].tolist() == [255 * c for c in color]


def test_offsets_strides_and_indices_in_buffers(screen: glsim.Offscreen) -> None:
    packed = np.zeros(4, [("color", "u1", 4), ("position", "f4", 3)])
    packed["position"], packed["color"] = CORNERS, [(255, 0, 0, 255)] * 4
    names = glGenBuffers(2)
    glBindBuffer(GL_ARRAY_BUFFER, names[0])
    glBufferData(GL_ARRAY_BUFFER, packed.tobytes(), GL_DYNAMIC_DRAW)
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glColorPointer(4, GL_UNSIGNED_BYTE, 16, ctypes.c_void_p(0))
    glVertexPointer(3, GL_FLOAT, 16, ctypes.c_void_p(4))
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1])
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, np.array([9, 0, 1, 2], np.uint16), GL_STATIC_DRAW)
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, ctypes.c_void_p(2))
    picture = screen.pixels()
    assert picture[80, 80].tolist() == [255, 0, 0, 255]
    assert not picture[48, 48].any()


def test_interleaved_arrays_in_a_buffer(screen: glsim.Offscreen) -> None:
    glBindBuffer(GL_ARRAY_BUFFER, glGenBuffers(1))
    rows = np.hstack([np.tile(np.float32([0, 1, 0]), (4, 1)), CORNERS])
    glBufferData(GL_ARRAY_BUFFER, rows.nbytes, rows, GL_STATIC_DRAW)
    glInterleavedArrays(GL_C3F_V3F, 0, None)
    assert drawn(screen)[64, 64].tolist() == [0, 255, 0]


def test_mapped_memory_is_the_buffer(screen: glsim.Offscreen) -> None:
    glBindBuffer(GL_ARRAY_BUFFER, glGenBuffers(1))
    glBufferData(GL_ARRAY_BUFFER, 16, None, GL_STATIC_DRAW)
    address = glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY)
    ctypes.memmove(address, b"0123456789abcdef", 16)
    assert glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED) == 1
    with pytest.raises(GLError, match="mapped already"):
        glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY)
    assert glUnmapBuffer(GL_ARRAY_BUFFER) == 1
    assert bytes(glGetBufferSubData(GL_ARRAY_BUFFER, 4, 4)) == b"4567"
    assert glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE) == 16


def test_bad_buffers(screen: glsim.Offscreen) -> None:
    with pytest.raises(GLError, match="glBindBuffer first"):
        glBufferData(GL_ARRAY_BUFFER, 16, None, GL_STATIC_DRAW)
    name = vertices_in_a_buffer()
    with pytest.raises(ValueError, match="element 4 was asked of a vertex array of 4"):
        glDrawArrays(GL_QUADS, 1, 4)
    glDeleteBuffers(1, [name])
    glDrawArrays(GL_QUADS, 0, 4)
    assert not screen.pixels().any()
    assert not glIsBuffer(name)


# ---------------------------------------------------------------- occlusion queries


def square(z: float) -> None:
    glBegin(GL_QUADS)
    for x, y, _ in CORNERS:
        glVertex3f(x, y, z)
    glEnd()


def test_samples_that_pass_are_counted(screen: glsim.Offscreen) -> None:
    glEnable(GL_DEPTH_TEST)
    glClear(GL_DEPTH_BUFFER_BIT)
    first, second = glGenQueries(2)
    glBeginQuery(GL_SAMPLES_PASSED, first)
    square(0.0)
    glEndQuery(GL_SAMPLES_PASSED)
    glBeginQuery(GL_SAMPLES_PASSED, second)
    square(0.5)
    glEndQuery(GL_SAMPLES_PASSED)
    assert glGetQueryObjectiv(first, GL_QUERY_RESULT_AVAILABLE) == 1
    assert glGetQueryObjectuiv(first, GL_QUERY_RESULT) == 64 * 64
    assert glGetQueryObjectuiv(second, GL_QUERY_RESULT) == 0
    assert glIsQuery(first)
    glDeleteQueries(1, [first])
    assert not glIsQuery(first)


def test_bad_queries(screen: glsim.Offscreen) -> None:
    with pytest.raises(GLError, match="no glBeginQuery"):
        glEndQuery(GL_SAMPLES_PASSED)
    glBeginQuery(GL_SAMPLES_PASSED, 5)
    with pytest.raises(GLError, match="has no glEndQuery yet"):
        glBeginQuery(GL_SAMPLES_PASSED, 6)
    assert glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY) == 5
    with pytest.raises(GLError, match="no query that has ended"):
        glGetQueryObjectiv(5, GL_QUERY_RESULT)


def test_lists_keep_what_was_in_the_buffers(screen: glsim.Offscreen) -> None:
    """Arrays are copied when a list is compiled, also out of buffer objects (section 5.4)."""
    vertices, indices = int(glGenBuffers(1)), int(glGenBuffers(1))
    glBindBuffer(GL_ARRAY_BUFFER, vertices)
    glBufferData(GL_ARRAY_BUFFER, CORNERS, GL_STATIC_DRAW)
    glVertexPointer(3, GL_FLOAT, 0, ctypes.c_void_p(0))
    glEnableClientState(GL_VERTEX_ARRAY)
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices)
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, np.array([9, 0, 1, 2, 3], np.uint16), GL_STATIC_DRAW)
    glNewList(1, GL_COMPILE)
    glDrawArrays(GL_QUADS, 0, 4)
    glEndList()
    glNewList(2, GL_COMPILE_AND_EXECUTE)
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, ctypes.c_void_p(2))
    glEndList()
    assert screen.pixels().any(axis=2).sum() == 64 * 64
    glDeleteBuffers(2, [vertices, indices])
    for number in (1, 2):
        glClear(GL_COLOR_BUFFER_BIT)
        assert not screen.pixels().any()
        glCallList(number)
        assert screen.pixels().any(axis=2).sum() == 64 * 64
