"""Errors that are easily forgotten: the codes are those of the driver's own fixed function."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import glsim
from glsim import gl
from glsim.gl import *
from glsim.machine.frame import Call
from glsim.render.native import Native

POINTS, PLANE = np.zeros(12, np.float32), np.zeros(48, np.float32)
UNIT_1 = ("glActiveTexture", GL_TEXTURE1)
RGB = (GL_RGB, GL_UNSIGNED_BYTE, None)
PROXY_2D, PROXY_CUBE = GL_PROXY_TEXTURE_2D, GL_PROXY_TEXTURE_CUBE_MAP

ERRORS: dict[str, tuple[list[tuple[Any, ...]], list[int]]] = {
    "a map of another unit": ([UNIT_1, ("glMap1f", GL_MAP1_VERTEX_3, 0, 1, 3, 2, POINTS)], [GL_INVALID_OPERATION]),
    "a surface of another unit": (
        [UNIT_1, ("glMap2f", GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, PLANE)], [GL_INVALID_OPERATION]),
    "a bad map of another unit": (
        [UNIT_1, ("glMap1f", GL_MAP1_VERTEX_3, 1, 1, 3, 2, POINTS)], [GL_INVALID_VALUE]),
    "interleaved backwards": ([("glInterleavedArrays", GL_V3F, -2, POINTS)], [GL_INVALID_VALUE]),
    "unsigned indices": ([("glIndexPointer", GL_UNSIGNED_INT, 0, POINTS)], [GL_INVALID_ENUM]),
    "indices of bytes": ([("glIndexPointer", GL_UNSIGNED_BYTE, 0, POINTS)], []),
    "a boolean below 0": ([("glPixelStorei", GL_UNPACK_SWAP_BYTES, -1), ("glPixelStorei", GL_PACK_LSB_FIRST, -7)], []),
    "a fractional alignment": ([("glPixelStoref", GL_UNPACK_ALIGNMENT, 3.7), ("glPixelStoref", GL_PACK_ALIGNMENT, 0.9)],
                               []),
    "no alignment": ([("glPixelStoref", GL_UNPACK_ALIGNMENT, 2.6)], [GL_INVALID_VALUE]),
    "colour indices of a material": ([("glMaterialiv", GL_FRONT, GL_COLOR_INDEXES, [0, 1, 1])], []),
    "proxy": ([("glTexImage2D", PROXY_2D, 0, GL_RGB, 4, 4, 0, *RGB)], []),
    "proxy: border": ([("glTexImage2D", PROXY_2D, 0, GL_RGB, 4, 4, -1, *RGB)], [GL_INVALID_VALUE]),
    "proxy: level": ([("glTexImage2D", PROXY_2D, -1, GL_RGB, 4, 4, 0, *RGB)], [GL_INVALID_VALUE]),
    "proxy: format": ([("glTexImage2D", PROXY_2D, 0, GL_RGB, 4, 4, 0, 77, GL_FLOAT, None)], [GL_INVALID_ENUM]),
    "proxy: type": ([("glTexImage2D", PROXY_2D, 0, GL_RGB, 4, 4, 0, GL_RGB, 77, None)], [GL_INVALID_ENUM]),
    "proxy: internal format": ([("glTexImage2D", PROXY_2D, 0, 77, 4, 4, 0, *RGB)], [GL_INVALID_VALUE]),
    "proxy: width": ([("glTexImage2D", PROXY_2D, 0, GL_RGB, -4, 4, 0, *RGB)], [GL_INVALID_VALUE]),
    "proxy: depth and colour": (
        [("glTexImage2D", PROXY_2D, 0, GL_DEPTH_COMPONENT, 4, 4, 0, *RGB)], [GL_INVALID_OPERATION]),
    "proxy: too large": ([("glTexImage2D", PROXY_2D, 0, GL_RGB, 1 << 20, 4, 0, *RGB)], []),
    "proxy: a face that is no square": ([("glTexImage2D", PROXY_CUBE, 0, GL_RGB, 4, 8, 0, *RGB)], []),
    "too large": ([("glTexImage2D", GL_TEXTURE_2D, 0, GL_RGB, 1 << 20, 4, 0, *RGB)], [GL_INVALID_VALUE]),
    "a face that is no square": (
        [("glTexImage2D", GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, GL_RGB, 4, 8, 0, *RGB)], [GL_INVALID_VALUE]),
    "a query twice": (
        [("glBeginQuery", GL_SAMPLES_PASSED, 1), ("glBeginQuery", GL_SAMPLES_PASSED, 2),
         ("glEndQuery", GL_SAMPLES_PASSED)], [GL_INVALID_OPERATION]),
    "the end of no query, in a list": (
        [("glNewList", 1, GL_COMPILE), ("glEndQuery", GL_SAMPLES_PASSED), ("glEndList",), ("glCallList", 1)],
        [GL_INVALID_OPERATION]),
}  # fmt: skip


@pytest.mark.parametrize("what", ERRORS)
def test_errors(screen: glsim.Offscreen, native: Native, what: str) -> None:
    calls, expected = ERRORS[what]
    ours = []
    for name, *arguments in calls:
        try:
            getattr(gl, name)(*arguments)
        except GLError as error:
            ours.append(int(error.err))
    theirs: list[tuple[str, int]] = []
    native.replay([Call(name, tuple(arguments)) for name, *arguments in calls], theirs)
    assert ours == [code for _, code in theirs] == expected


def test_a_query_in_a_list_counts_when_the_list_is_called(screen: glsim.Offscreen) -> None:
    """Section 5.4 does not name glBeginQuery among the commands that are executed at once."""
    query = int(glGenQueries(1))
    glNewList(1, GL_COMPILE)
    glBeginQuery(GL_SAMPLES_PASSED, query)
    glRectf(-1, -1, 0, 1)
    glEndQuery(GL_SAMPLES_PASSED)
    glEndList()
    assert not glIsQuery(query)
    glCallList(1)
    assert glGetQueryObjectuiv(query, GL_QUERY_RESULT) == 64 * 128


def test_only_textures_are_resident(screen: glsim.Offscreen) -> None:
    """Section 3.8.12: 0, and names that are no texture's, are GL_INVALID_VALUE."""
    first, second = glGenTextures(2).tolist()
    glBindTexture(GL_TEXTURE_2D, first)
    assert glAreTexturesResident([first]).tolist() == [1]
    for names in ([0], [first, second], [77], [-1]):
        with pytest.raises(GLError, match="glAreTexturesResident: textures must be names of textures") as raised:
            glAreTexturesResident(len(names), names)
        assert raised.value.err == GL_INVALID_VALUE


def test_a_proxy_has_no_size_where_there_is_no_room(screen: glsim.Offscreen) -> None:
    for width, found in ((64, 64), (1 << 20, 0)):
        glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, width, 4, 0, *RGB)
        assert glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == found


def test_the_raster_colour_is_a_colour(screen: glsim.Offscreen) -> None:
    """Section 6.1.2: as integers colours map linearly."""
    glColor4f(1, 0.5, 0, 1)
    glRasterPos2f(0, 0)
    largest = 2147483647
    assert glGetIntegerv(GL_CURRENT_RASTER_COLOR).tolist() == glGetIntegerv(GL_CURRENT_COLOR).tolist()
    assert glGetIntegerv(GL_CURRENT_RASTER_COLOR).tolist()[::2] == [largest, 0]
    glClearAccum(1, -1, 0, 1)
    assert glGetIntegerv(GL_ACCUM_CLEAR_VALUE).tolist() == [largest, -largest, 0, largest]


@pytest.mark.parametrize("size", [(0, 5), (5, -1), (1 << 20, 5), (2.5, 5), ("a", 5)])
def test_a_size_that_is_none(size: tuple[Any, Any]) -> None:
    other = glsim.offscreen(8, 8)
    with pytest.raises(ValueError, match=r"resize: (width|height) must be an integer from 1 to"):
        other.resize(*size)
    assert other.pixels().shape == (8, 8, 4)
    other.release()
