"""What the oracle programs of rasterization leave open."""

from __future__ import annotations

import numpy as np
import pytest

import glsim
from glsim.gl import *


def runs(row: np.ndarray) -> list[int]:
    """Lengths of runs of equal values."""
    ends = np.flatnonzero(np.diff(row.astype(int))) + 1
    return np.diff([0, *ends, len(row)]).tolist()


def pixels() -> None:
    glOrtho(0, 128, 0, 128, -1, 1)
    glEnable(GL_LINE_STIPPLE)
    glLineStipple(2, 0x00FF)  # 16 pixels on, 16 off


def test_a_stippled_strip_goes_on_at_its_corners(screen: glsim.Offscreen) -> None:
    pixels()
    glBegin(GL_LINE_STRIP)
    for x in (0, 20, 50, 128):
        glVertex2f(x, 64.5)
    glEnd()
    assert runs(screen.pixels()[63, :, 0] > 0) == [16] * 8


def test_stippled_lines_begin_anew(screen: glsim.Offscreen) -> None:
    pixels()
    glBegin(GL_LINES)
    for a, b in ((0, 24), (24, 128)):
        glVertex2f(a, 64.5)
        glVertex2f(b, 64.5)
    glEnd()
    assert runs(screen.pixels()[63, :, 0] > 0) == [16, 8, 16, 16, 16, 16, 16, 16, 8]


def test_stencil_and_depth_are_read_back(screen: glsim.Offscreen) -> None:
    glEnable(GL_STENCIL_TEST)
    glStencilFunc(GL_ALWAYS, 7, 0xFF)
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE)
    glRectf(-1, -1, 0, 1)
    stencil = np.frombuffer(glReadPixels(0, 0, 128, 128, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE), "u1").reshape(128, 128)
    assert (stencil[:, :64] == 7).all()
    assert (stencil[:, 64:] == 0).all()


def test_polygon_stipple_is_read_back(screen: glsim.Offscreen) -> None:
    mask = bytes(range(128))
    glPolygonStipple(mask)
    assert glGetPolygonStipple() == mask
    glPolygonStipple(np.unpackbits(np.frombuffer(mask, "u1")).reshape(32, 32))
    assert glGetPolygonStipple() == mask


def test_attribute_stacks(screen: glsim.Offscreen) -> None:
    for push, pop, depth in (
        (glPushAttrib, glPopAttrib, GL_ATTRIB_STACK_DEPTH),
        (glPushClientAttrib, glPopClientAttrib, GL_CLIENT_ATTRIB_STACK_DEPTH),
    ):
        with pytest.raises(GLError) as caught:
            pop()
        assert caught.value.err == GL_STACK_UNDERFLOW
        for _ in range(16):
            push(GL_CLIENT_ALL_ATTRIB_BITS)
        assert glGetIntegerv(depth) == 16
        with pytest.raises(GLError) as caught:
            push(0)
        assert caught.value.err == GL_STACK_OVERFLOW
        for _ in range(16):
            pop()


def test_client_state_is_saved(screen: glsim.Offscreen) -> None:
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT)
    glEnableClientState(GL_NORMAL_ARRAY)
    glPopClientAttrib()
    assert not glGetBooleanv(GL_NORMAL_ARRAY)


@pytest.mark.parametrize(
    ("bit", "change", "query"),
    [
        (GL_CURRENT_BIT, lambda: glTexCoord2f(0.25, 0.5), GL_CURRENT_TEXTURE_COORDS),
        (GL_POINT_BIT, lambda: glPointSize(3), GL_POINT_SIZE),
        (GL_LINE_BIT, lambda: glLineWidth(3), GL_LINE_WIDTH),
        (GL_POLYGON_BIT, lambda: glPolygonMode(GL_FRONT, GL_LINE), GL_POLYGON_MODE),
        (GL_LIGHTING_BIT, lambda: glShadeModel(GL_FLAT), GL_SHADE_MODEL),
        (GL_FOG_BIT, lambda: glFogf(GL_FOG_DENSITY, 0.5), GL_FOG_DENSITY),
        (GL_DEPTH_BUFFER_BIT, lambda: glDepthFunc(GL_ALWAYS), GL_DEPTH_FUNC),
        (GL_STENCIL_BUFFER_BIT, lambda: glStencilMask(3), GL_STENCIL_WRITEMASK),
        (GL_VIEWPORT_BIT, lambda: glViewport(1, 2, 3, 4), GL_VIEWPORT),
        (GL_TRANSFORM_BIT, lambda: glMatrixMode(GL_TEXTURE), GL_MATRIX_MODE),
        (GL_COLOR_BUFFER_BIT, lambda: glBlendFunc(GL_ONE, GL_ONE), GL_BLEND_DST),
        (GL_HINT_BIT, lambda: glHint(GL_FOG_HINT, GL_NICEST), GL_FOG_HINT),
        (GL_LIST_BIT, lambda: glListBase(9), GL_LIST_BASE),
        (GL_SCISSOR_BIT, lambda: glScissor(1, 2, 3, 4), GL_SCISSOR_BOX),
        (GL_MULTISAMPLE_BIT, lambda: glSampleCoverage(0.5, True), GL_SAMPLE_COVERAGE_VALUE),
    ],
)
def test_each_group_is_saved_alone(screen: glsim.Offscreen, bit: int, change: object, query: int) -> None:
    before = glGetFloatv(query)
    glPushAttrib(GL_ALL_ATTRIB_BITS & ~bit & ~GL_ENABLE_BIT)
    change()  # type: ignore[operator]
    changed = glGetFloatv(query)
    assert not np.array_equal(before, changed)
    glPopAttrib()
    assert np.array_equal(glGetFloatv(query), changed)
    change()  # type: ignore[operator]
    screen.reset()
    glPushAttrib(bit)
    change()  # type: ignore[operator]
    glPopAttrib()
    assert np.array_equal(glGetFloatv(query), before)


# ---------------------------------------------------------------- display lists


def test_list_numbers(screen: glsim.Offscreen) -> None:
    first = glGenLists(3)
    assert type(first) is int
    assert [glIsList(first + k) for k in range(4)] == [1, 1, 1, 0]
    glDeleteLists(first, 2)
    assert not glIsList(first)
    assert glGenLists(2) == first
    assert glGenLists(0) == 0
    glCallList(4711)  # does not exist: ignored
    for ask in (glGenLists, glGenTextures):
        with pytest.raises(GLError, match="are more than the") as caught:
            ask(2**40)
        assert caught.value.err == GL_OUT_OF_MEMORY


def test_list_errors(screen: glsim.Offscreen) -> None:
    with pytest.raises(GLError, match="glEndList: there is no glNewList"):
        glEndList()
    with pytest.raises(GLError, match="glNewList: n must be the number of a list"):
        glNewList(0, GL_COMPILE)
    with pytest.raises(GLError, match="glNewList: mode must be GL_COMPILE"):
        glNewList(1, GL_LINES)
    glNewList(1, GL_COMPILE)
    with pytest.raises(GLError, match="list 1 has no glEndList yet"):
        glNewList(2, GL_COMPILE)
    glShadeModel(GL_LINES)  # errors come when the list is called
    glEndList()
    with pytest.raises(GLError, match="glShadeModel: mode must be"):
        glCallList(1)


def test_a_list_that_calls_itself_ends(screen: glsim.Offscreen) -> None:
    glNewList(1, GL_COMPILE)
    glCallList(1)
    glTranslatef(1, 0, 0)
    glEndList()
    glCallList(1)
    assert glGetFloatv(GL_MODELVIEW_MATRIX)[3, 0] == 64
    assert glGetIntegerv(GL_MAX_LIST_NESTING) == 64


def test_what_lists_do_not_record_is_done_at_once(screen: glsim.Offscreen) -> None:
    glNewList(1, GL_COMPILE)
    glEnableClientState(GL_VERTEX_ARRAY)
    glColor3f(0.5, 0, 0)
    assert glGenLists(1) == 1  # list 1 is not there before its glEndList
    glEndList()
    assert glGetBooleanv(GL_VERTEX_ARRAY)
    assert glGetFloatv(GL_CURRENT_COLOR)[0] == 1
    glCallList(1)
    assert glGetFloatv(GL_CURRENT_COLOR)[0] == 0.5


def test_half_a_primitive_in_a_list(screen: glsim.Offscreen) -> None:
    glNewList(1, GL_COMPILE)
    glBegin(GL_TRIANGLES)
    glVertex2f(-1, -1)
    glEndList()
    glCallList(1)
    glVertex2f(3, -1)
    glVertex2f(-1, 3)
    glEnd()
    assert (screen.pixels() == 255).all()


def test_a_list_is_called_after_the_context_was_reset(screen: glsim.Offscreen) -> None:
    glNewList(5, GL_COMPILE)
    glRectf(-1, -1, 1, 1)
    glEndList()
    screen.reset()
    assert not glIsList(5)


def test_numbers_larger_than_any_picture(screen: glsim.Offscreen) -> None:
    """Drawing with them goes on; drivers add such numbers in 32 bits."""
    huge = 10**400
    glViewport(huge, -huge, 8, 8)
    glScissor(huge, 0, 1, 1)
    glLineWidth(float("inf"))
    glStencilFunc(float(GL_LESS), 1, 1)
    glEnable(GL_STENCIL_TEST)
    glBegin(GL_LINES)
    glVertex2f(-1, -1)
    glVertex2f(1, 1)
    glEnd()
    glCopyPixels(2**31 - 1, 2**31 - 1, 4, 4, GL_COLOR)
    assert not screen.pixels().any()
    screen.reset()
    glClearColor(1, 0, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    pixels = np.frombuffer(glReadPixels(-2, screen.height - 1, 4, 3, GL_RGBA, GL_UNSIGNED_BYTE), np.uint8).reshape(
        3, 4, 4
    )
    assert np.array_equal(pixels[..., 0], [[0, 0, 255, 255], [0, 0, 0, 0], [0, 0, 0, 0]])
    assert not any(glReadPixels(2**31 - 1, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE))
