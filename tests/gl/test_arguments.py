"""What may stand for a number or an array: what PyOpenGL takes; and the sentence for what may not."""

from __future__ import annotations

import array
import ctypes
import itertools
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import glsim
from glsim import gl
from glsim.gl import *
from glsim.machine.commands import COMMANDS
from glsim.machine.record import NUMBERS_ONLY
from glsim.machine.types import plain

FLOATS = ctypes.POINTER(ctypes.c_float)


def pointer(*values: float, kind: Any = ctypes.c_float) -> Any:
    return ctypes.cast((kind * len(values))(*values), ctypes.POINTER(kind))


def current_color() -> list[float]:
    return [round(float(value), 3) for value in glGetFloatv(GL_CURRENT_COLOR)]


# ---------------------------------------------------------------- pointers


def test_a_rectangle_takes_as_many_numbers_of_a_pointer_as_it_needs(screen: glsim.Offscreen) -> None:
    glRectfv(pointer(-1, -1, 9), pointer(0, 1, 9))
    assert screen.pixels()[64, [32, 96], 0].tolist() == [255, 0]


POINTERS: list[tuple[Callable[[Any], object], list[float]]] = [
    (lambda p: (glColor3fv(p), current_color()[:3])[1], [0.5, 0.25, 1.0]),
    (lambda p: (glColor4fv(p), current_color())[1], [0.5, 0.25, 1.0, 0.75]),
    (lambda p: (glNormal3fv(p), glGetFloatv(GL_CURRENT_NORMAL).tolist())[1], [0.5, 0.25, 1.0]),
    (lambda p: (glTexCoord2fv(p), glGetFloatv(GL_CURRENT_TEXTURE_COORDS).tolist())[1], [0.5, 0.25, 0.0, 1.0]),
    (lambda p: (glSecondaryColor3fv(p), glGetFloatv(GL_CURRENT_SECONDARY_COLOR).tolist())[1], [0.5, 0.25, 1.0, 1.0]),
    (lambda p: (glFogCoordfv(p), [glGetFloatv(GL_CURRENT_FOG_COORDINATE)])[1], [0.5]),
    (lambda p: (glLightfv(GL_LIGHT0, GL_DIFFUSE, p), glGetLightfv(GL_LIGHT0, GL_DIFFUSE).tolist())[1],
     [0.5, 0.25, 1.0, 0.75]),
    (lambda p: (glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, p), glGetLightfv(GL_LIGHT0, GL_SPOT_DIRECTION).tolist())[1],
     [0.5, 0.25, 1.0]),
    (lambda p: (glMaterialfv(GL_FRONT, GL_SHININESS, p), [glGetMaterialfv(GL_FRONT, GL_SHININESS)])[1], [0.5]),
    (lambda p: (glMaterialfv(GL_FRONT, GL_AMBIENT, p), glGetMaterialfv(GL_FRONT, GL_AMBIENT).tolist())[1],
     [0.5, 0.25, 1.0, 0.75]),
    (lambda p: (glFogfv(GL_FOG_COLOR, p), glGetFloatv(GL_FOG_COLOR).tolist())[1], [0.5, 0.25, 1.0, 0.75]),
    (lambda p: (glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, p),
                glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR).tolist())[1], [0.5, 0.25, 1.0, 0.75]),
    (lambda p: (glTexGenfv(GL_S, GL_OBJECT_PLANE, p), glGetTexGenfv(GL_S, GL_OBJECT_PLANE).tolist())[1],
     [0.5, 0.25, 1.0, 0.75]),
    (lambda p: (glWindowPos2fv(p), glGetFloatv(GL_CURRENT_RASTER_POSITION).tolist())[1], [0.5, 0.25, 0.0, 1.0]),
    (lambda p: (glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 4, p), glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R).tolist())[1],
     [0.5, 0.25, 1.0, 0.75]),
]  # fmt: skip


@pytest.mark.parametrize(("use", "found"), POINTERS)
def test_vectors_come_from_pointers(screen: glsim.Offscreen, use: Callable[[Any], object], found: list[float]) -> None:
    values = (ctypes.c_float * 6)(0.5, 0.25, 1.0, 0.75, 7, 7)
    for given in (ctypes.cast(values, FLOATS), ctypes.pointer(values)):
        screen.reset()
        assert use(given) == found


def test_what_byref_refers_to_is_taken_whole(screen: glsim.Offscreen) -> None:
    values = (ctypes.c_float * 3)(0.5, 0.25, 1.0)
    glColor3fv(ctypes.byref(values))
    assert current_color() == [0.5, 0.25, 1, 1]
    with pytest.raises(TypeError, match="glColor3fv: v must be a list, tuple or array of 3 numbers"):
        glColor3fv(ctypes.byref(values, 4))


def test_a_list_keeps_what_a_pointer_led_to(screen: glsim.Offscreen) -> None:
    values = (ctypes.c_float * 4)(0.5, 0.25, 1.0, 0.75)
    glNewList(1, GL_COMPILE)
    glColor4fv(ctypes.cast(values, FLOATS))
    glLightfv(GL_LIGHT0, GL_SPECULAR, ctypes.pointer(values))
    glEndList()
    values[:] = (0, 0, 0, 0)
    glCallList(1)
    assert current_color() == glGetLightfv(GL_LIGHT0, GL_SPECULAR).tolist() == [0.5, 0.25, 1.0, 0.75]


def test_matrices_and_planes_come_from_pointers(screen: glsim.Offscreen) -> None:
    matrix = pointer(*range(16))
    glLoadMatrixf(matrix)
    assert glGetFloatv(GL_MODELVIEW_MATRIX).ravel().tolist() == list(range(16))
    glLoadIdentity()
    glMultMatrixd(pointer(*range(16), kind=ctypes.c_double))
    assert glGetFloatv(GL_MODELVIEW_MATRIX).ravel().tolist() == list(range(16))
    glLoadIdentity()
    glClipPlane(GL_CLIP_PLANE0, pointer(1, 2, 3, 4, kind=ctypes.c_double))
    assert glGetClipPlane(GL_CLIP_PLANE0).tolist() == [1, 2, 3, 4]


def test_indices_points_pixels_and_buffers_come_from_pointers(screen: glsim.Offscreen) -> None:
    glEnableClientState(GL_VERTEX_ARRAY)
    glVertexPointer(2, GL_FLOAT, 0, (ctypes.c_float * 8)(-1, -1, 0, -1, 0, 1, -1, 1))
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, pointer(0, 1, 2, 3, kind=ctypes.c_ushort))
    glWindowPos2i(100, 100)
    glDrawPixels(2, 1, GL_RGB, GL_UNSIGNED_BYTE, pointer(255, 0, 0, 0, 255, 0, kind=ctypes.c_ubyte))
    picture = screen.pixels()
    assert picture[64, 32, 0] == 255
    assert picture[27, 100:102, :2].tolist() == [[255, 0], [0, 255]]
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, pointer(*range(6)))
    assert glGetMapfv(GL_MAP1_VERTEX_3, GL_COEFF).tolist() == list(range(6))
    glBindBuffer(GL_ARRAY_BUFFER, 1)
    glBufferData(GL_ARRAY_BUFFER, 8, pointer(1, 2, 3), GL_STATIC_DRAW)
    assert glGetBufferSubData(GL_ARRAY_BUFFER, 0, 8).view(np.float32).tolist() == [1, 2]


def test_answers_go_where_pointers_lead(screen: glsim.Offscreen) -> None:
    numbers, one, pixel = (ctypes.c_float * 4)(), ctypes.c_int(), (ctypes.c_ubyte * 4)()
    glGetFloatv(GL_CURRENT_COLOR, ctypes.cast(numbers, FLOATS))
    assert list(numbers) == [1, 1, 1, 1]
    glGetIntegerv(GL_DEPTH_BITS, ctypes.byref(one))
    assert one.value == 24
    glGetIntegerv(GL_STENCIL_BITS, ctypes.pointer(one))
    assert one.value == 8
    glGenTextures(1, one)
    assert one.value == 1
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, array=ctypes.cast(pixel, ctypes.POINTER(ctypes.c_ubyte)))
    assert list(pixel)[:3] == [0, 0, 0]
    glNewList(1, GL_COMPILE)
    glGetIntegerv(GL_DEPTH_BITS, one)
    glEndList()
    assert one.value == 24


REFUSED: list[tuple[Callable[[], object], str]] = [
    (lambda: glRectfv(itertools.count(), itertools.count()), "glRectfv: v1 must be a list, .* of 2 numbers"),
    (lambda: glRectfv(FLOATS(), FLOATS()), "glRectfv: v1 must be .* 2 numbers"),
    (lambda: glVertex3fv(itertools.count()), "glVertex3fv: v must be a list, tuple or array of 3 numbers"),
    (lambda: glColor3fv([1, 0, 1, 1]), "glColor3fv: v must be a list, tuple or array of 3 numbers, not"),
    (lambda: glColor3fv(ctypes.c_void_p(8)), "glColor3fv: v must be a list, tuple or array of 3 numbers"),
    (lambda: glColor(pointer(1, 2, 3)), "glColor: a number or a sequence of numbers is needed"),
    (lambda: glVertex(itertools.count()), "glVertex: a number or a sequence of numbers is needed"),
    (lambda: glLightfv(GL_LIGHT0, GL_DIFFUSE, itertools.count()), "glLightfv: params must be a list"),
    (lambda: glLoadMatrixf(itertools.count()), "glLoadMatrixf: m must be a list, tuple or array of 16 numbers"),
    (lambda: glLoadMatrixf([[1, 2], [3]]), "glLoadMatrixf: m must be a list, tuple or array of 16 numbers"),
    (lambda: glVertexPointer(3, GL_FLOAT, 0, pointer(1, 2, 3)), "glVertexPointer: pointer must be .* does not say how"),
    (lambda: glInterleavedArrays(GL_V3F, 0, pointer(1, 2)), "glInterleavedArrays: pointer must be .* does not say how"),
    (lambda: glDrawPixels(1, 1, GL_RGB, GL_FLOAT, itertools.count()), "glDrawPixels: pixels must be"),
    (lambda: glDrawPixels(1, 1, GL_RGB, GL_UNSIGNED_BYTE, ctypes.c_void_p(8)), "glDrawPixels: pixels must be"),
    (lambda: glDrawElements(GL_POINTS, 1, GL_UNSIGNED_INT, ctypes.c_void_p(8)), "glDrawElements: indices must be"),
    (lambda: glBufferData(GL_ARRAY_BUFFER, pointer(1, 2), GL_STATIC_DRAW), "glBufferData: .* must be"),
    (lambda: glDeleteTextures(pointer(1, 2)), "glDeleteTextures: n must be a number"),
    (lambda: glVertexPointerf(pointer(1, 2, 3)), "glVertexPointerf: an array of numbers is needed"),
    (lambda: glTexImage2Df(GL_TEXTURE_2D, 0, GL_RGB, 0, GL_RGB, [[1, 2], [3]]), "glTexImage2Df: an array of numbers"),
    (lambda: glMaterial(), "glMaterial takes 3 arguments .face, pname, params., not 0"),
    (lambda: glLight(GL_LIGHT0), "glLight takes 3 arguments .light, pname, params., not 1"),
    (lambda: glRotatef(10**400, 0, 0, 1), "glRotatef: angle must be a number"),
    (lambda: glViewport(0, 0, float("nan"), 1), "glViewport: width must be a number"),
    (lambda: glGetFloatv(GL_VIEWPORT, (0, 0, 0, 0)), "glGetFloatv: the array for the answer must be a list"),
    (lambda: glGetFloatv(GL_VIEWPORT, np.zeros(2)), "glGetFloatv: the array for the answer has room for 2 numbers"),
    (lambda: glGetFloatv(GL_VIEWPORT, object()), "glGetFloatv: the array for the answer must be"),
    (lambda: glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, memoryview(b"a" * 64)[::2]),
     "glDrawPixels: a memoryview must be contiguous"),
    (lambda: glBitmap(8, 1, 0, 0, 0, 0, "\u1234"), "glBitmap: a str stands for bytes here"),
    (lambda: glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, [1, "a", 2]),
     "glTexImage2D: pixels must be"),
    (lambda: glPolygonStipple([1, 2]), "glPolygonStipple: a bitmap of 32 x 32 pixels needs 128 bytes"),
]  # fmt: skip


@pytest.mark.parametrize("recording", [False, True])
@pytest.mark.parametrize(("call", "sentence"), REFUSED)
def test_what_has_no_end_or_no_numbers_gets_a_sentence(
    screen: glsim.Offscreen, call: Callable[[], object], sentence: str, recording: bool
) -> None:
    glBindBuffer(GL_ARRAY_BUFFER, 1 if "glBufferData" in sentence else 0)
    with glsim.capture(calls=recording), pytest.raises((TypeError, ValueError), match=f"^{sentence}"):
        call()


# ---------------------------------------------------------------- numbers of ctypes

C_TYPES = {"f": ctypes.c_float, "d": ctypes.c_double, "ub": ctypes.c_ubyte, "us": ctypes.c_ushort, "b": ctypes.c_byte,
           "s": ctypes.c_short, "i": ctypes.c_int, "sizei": ctypes.c_int, "boolean": ctypes.c_ubyte}  # fmt: skip
ALIKE = sorted(
    name
    for name in NUMBERS_ONLY
    if COMMANDS[name].arguments and name not in ("glNewList", "glBegin", "glRenderMode", "glReadPixels")
)


def outcome(screen: glsim.Offscreen, name: str, arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """What a command gives or raises, and what it leaves behind."""
    screen.reset()
    try:
        result = repr(getattr(gl, name)(*arguments))
    except GLError as error:
        result = str(error.err)
    machine = screen.machine
    registers = [float(plain(getattr(machine, r))) for r in ("nx", "ny", "nz", "red", "green", "blue", "alpha")]
    matrices = [stack[-1].get().tolist() for stack in machine.stacks.values()]
    client = (
        machine.stores.unpack,
        machine.client.array_buffer,
        machine.client.unit,
        machine.list_base,
        machine.accum_clear,
    )
    return result, registers, matrices, client, machine.snapshot(), machine.current, machine.raster, machine.pixel


@pytest.mark.parametrize("name", ALIKE)
def test_numbers_of_ctypes_are_numbers(screen: glsim.Offscreen, name: str) -> None:
    kinds = [kind for _, kind in COMMANDS[name].arguments]
    for value in (1, GL_LIGHTING, GL_TEXTURE0):
        python = tuple(float(value) if kind in ("f", "d") else value & 0x7F if kind in ("b", "ub", "s", "us") else value
                      for kind in kinds)  # fmt: skip
        wrapped = tuple(C_TYPES.get(kind, ctypes.c_uint)(v) for kind, v in zip(kinds, python, strict=True))
        assert outcome(screen, name, wrapped) == outcome(screen, name, python)


def test_names_of_ctypes_are_names(screen: glsim.Offscreen) -> None:
    glNewList(ctypes.c_uint(3), GL_COMPILE)
    glColor3f(0.5, 0, 0)
    glEndList()
    glBindBuffer(GL_ARRAY_BUFFER, ctypes.c_uint(4))
    glCallList(ctypes.c_uint(3))
    assert current_color() == [0.5, 0, 0, 1]
    assert glIsList(ctypes.c_uint(3))
    assert glIsBuffer(ctypes.c_uint(4))
    assert not glIsList(ctypes.c_uint(4))


def test_a_triangle_of_ctypes(screen: glsim.Offscreen) -> None:
    f = ctypes.c_float
    for listed in (False, True):
        screen.reset()
        glClear(GL_COLOR_BUFFER_BIT)
        if listed:
            glNewList(1, GL_COMPILE)
        color = f(0.5)
        glBegin(ctypes.c_uint(GL_TRIANGLES))
        glColor3f(f(1), color, f(0))
        for x, y in ((-1, -1), (1, -1), (1, 1)):
            glVertex2f(f(x), ctypes.c_double(y))
        glEnd()
        if listed:
            color.value = 0
            glEndList()
            glCallList(1)
        assert screen.pixels()[100, 100].tolist() == [255, 128, 0, 255]


def test_the_current_colour_may_be_of_ctypes_for_everything_that_draws(screen: glsim.Offscreen) -> None:
    glColor4f(*map(ctypes.c_float, (0.0, 1.0, 0.0, 1.0)))
    glNormal3f(*map(ctypes.c_float, (0, 0, 1)))
    glRectf(-1, -1, 0, 1)
    glEnableClientState(GL_VERTEX_ARRAY)
    glVertexPointer(2, GL_FLOAT, 0, np.array([(0, -1), (1, -1), (1, 0), (0, 0)], np.float32))
    glDrawArrays(GL_QUADS, 0, 4)
    glWindowPos2i(64, 64)
    glBitmap(8, 1, 0, 0, 0, 0, b"\xff")
    picture = screen.pixels()
    assert picture[64, 32, 1] == picture[96, 96, 1] == picture[63, 66, 1] == 255


# ---------------------------------------------------------------- surplus arguments


def test_surplus_arguments_are_ignored(screen: glsim.Offscreen) -> None:
    """As by PyOpenGL, whose commands are C functions."""
    glColor3f(1, 0.5, 0, 0.25)
    assert current_color() == [1, 0.5, 0, 1]
    glColor3fv([0, 1, 0], 3)
    assert current_color() == [0, 1, 0, 1]
    glRotatef(90, 0, 0, 1, 7)
    glClear(GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT)
    glEnable(GL_LIGHTING, GL_LIGHT0)
    assert glIsEnabled(GL_LIGHTING)
    assert not glIsEnabled(GL_LIGHT0)
    glNewList(1, GL_COMPILE)
    glColor3f(0.5, 0, 1, 0)
    glTranslatef(1, 0, 0, 1)
    glEndList()
    glCallList(1)
    assert current_color() == [0.5, 0, 1, 1]
    with pytest.raises(TypeError):
        glEnd(1)


# ---------------------------------------------------------------- what stands for bytes


@pytest.mark.parametrize(
    "bits", [b"\xf0", "\xf0", bytearray(b"\xf0"), memoryview(b"\xf0"), array.array("B", [0xF0]),
             array.array("b", [-16]),             np.array([0xF0], np.uint8), [0xF0], (ctypes.c_ubyte * 1)(0xF0)]
)  # fmt: skip
def test_bitmaps_are_bytes_of_many_kinds(screen: glsim.Offscreen, bits: Any) -> None:
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    for listed in (False, True):
        glClear(GL_COLOR_BUFFER_BIT)
        if listed:
            glNewList(1, GL_COMPILE)
        glWindowPos2i(0, 0)
        glBitmap(8, 1, 0, 0, 0, 0, bits)
        if listed:
            glEndList()
            glCallList(1)
        assert screen.pixels()[127, :8, 0].tolist() == [255] * 4 + [0] * 4


@pytest.mark.parametrize(
    "pixels", ["\xff\0\x80", b"\xff\0\x80", array.array("B", [255, 0, 128]), array.array("b", [-1, 0, -128]),
               array.array("i", [255, 0, 128]), array.array("d", [255, 0, 128])]
)  # fmt: skip
def test_pixels_are_bytes_of_many_kinds(screen: glsim.Offscreen, pixels: Any) -> None:
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glWindowPos2i(0, 0)
    glDrawPixels(1, 1, GL_RGB, GL_UNSIGNED_BYTE, pixels)
    assert screen.pixels()[127, 0, :3].tolist() == [255, 0, 128]
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels)
    assert glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE) == b"\xff\0\x80"


def test_a_stipple_is_a_str_and_lies_in_memory_as_glpixelstore_says(screen: glsim.Offscreen) -> None:
    """Section 3.5.2: the pattern is unpacked like a bitmap of 32 x 32 pixels."""
    glPolygonStipple("\xf0\0\0\x01" * 32)
    assert glGetPolygonStipple() == b"\xf0\0\0\x01" * 32
    glPixelStorei(GL_UNPACK_LSB_FIRST, 1)
    glNewList(1, GL_COMPILE)
    glPolygonStipple(b"\x0f\0\0\x80" * 32)
    glEndList()
    glPixelStorei(GL_UNPACK_LSB_FIRST, 0)
    glCallList(1)
    assert glGetPolygonStipple() == b"\xf0\0\0\x01" * 32
