"""Selection and feedback, against the driver's and against what follows from the specification."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.gl import GLError
from glsim.machine.commands import COMMANDS
from glsim.play.capture import capture
from glsim.render.native import Native, pass_on
from tests.drawing import SHINY, ball, camera, lamp, material


def natively(native: Native, draw: Callable[[], None], mode: int, kind: int = GL_3D_COLOR) -> tuple[int, np.ndarray]:
    """What the driver answers: glRenderMode's number and the buffer."""
    with capture(calls=True) as frame:
        draw()
    buffer = np.zeros(4096, np.uint32 if mode == GL_SELECT else np.float32)
    native.replay([])
    native.loader.make_current()
    load = native.loader.load
    if mode == GL_SELECT:
        select = ctypes.CFUNCTYPE(None, ctypes.c_int, ctypes.c_void_p)(load("glSelectBuffer"))
        select(buffer.size, buffer.ctypes.data)
    else:
        feed_back = ctypes.CFUNCTYPE(None, ctypes.c_int, ctypes.c_uint, ctypes.c_void_p)(load("glFeedbackBuffer"))
        feed_back(buffer.size, kind, buffer.ctypes.data)
    render_mode = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_uint)(load("glRenderMode"))
    render_mode(mode)
    for name, arguments, *_ in frame.calls:
        native._call(name, pass_on(COMMANDS[name], arguments, []))
    count = render_mode(GL_RENDER)
    native.loader.release_current()
    return count, buffer


def triangle(x: float, y: float, z: float, size: float = 0.3) -> None:
    glBegin(GL_TRIANGLES)
    for a, b in ((0, 0), (1, 0), (0, 1)):
        glVertex3f(x + a * size, y + b * size, z + a * 0.1)
    glEnd()


def named_triangles() -> None:
    glInitNames()
    glPushName(7)
    for k in range(6):
        glLoadName(k)
        triangle(-1.2 + 0.4 * k, -0.5, 0.2 * k - 0.6)
    glPushName(4294967295)
    triangle(0.0, 0.9, 0.5)
    triangle(0.0, 1.9, -0.5)
    glPopName()
    glPopName()
    triangle(0, 0, 0)


def points_and_lines() -> None:
    glInitNames()
    glPushName(1)
    glBegin(GL_POINTS)
    glVertex3f(0.5, 0.5, 0.3)
    glVertex3f(1.5, 0.5, 0.9)
    glEnd()
    glLoadName(2)
    glBegin(GL_LINE_LOOP)
    glVertex3f(-2, 0, -0.2)
    glVertex3f(2, 0, 0.4)
    glVertex3f(0, 3, 0.9)
    glEnd()
    glLoadName(3)
    glBegin(GL_LINES)
    glVertex3f(2, 2, 0)
    glVertex3f(1.1, 3, 0)
    glEnd()


def picked_balls() -> None:
    """With a perspective, a culled side and glEnable(GL_CLIP_PLANE0)."""
    camera(4.0)
    glEnable(GL_CULL_FACE)
    glClipPlane(GL_CLIP_PLANE0, [1, 0, 0, 0.2])
    glEnable(GL_CLIP_PLANE0)
    glInitNames()
    glPushName(0)
    for k in range(4):
        glPushName(k)
        glPushMatrix()
        glTranslatef(k - 1.5, 0, -k)
        ball(8, 6, radius=0.4, mode=GL_TRIANGLES)
        glPopMatrix()
        glPopName()


def raster_positions() -> None:
    glInitNames()
    glPushName(5)
    glRasterPos3f(0.2, 0.3, 0.4)
    glLoadName(6)
    glRasterPos3f(2, 0, 0)


@pytest.mark.parametrize("draw", [named_triangles, points_and_lines, picked_balls, raster_positions])
def test_hits_are_the_drivers(screen: glsim.Offscreen, native: Native, draw: Callable[[], None]) -> None:
    count, theirs = natively(native, draw, GL_SELECT)
    screen.reset()
    ours = glSelectBuffer(4096)
    assert glRenderMode(GL_SELECT) == 0
    assert glGetIntegerv(GL_RENDER_MODE) == GL_SELECT
    draw()
    hits = glRenderMode(GL_RENDER)
    assert len(hits) == count > 0
    at = 0
    for hit in hits:
        names = int(ours[at])
        assert hit.names == ours[at + 3 : at + 3 + names].tolist() == theirs[at + 3 : at + 3 + names].tolist()
        assert ours[at + 1 : at + 3] / 2**32 == pytest.approx(theirs[at + 1 : at + 3] / 2**32, abs=2e-6)
        assert (hit.near, hit.far) == pytest.approx(tuple(ours[at + 1 : at + 3] / 4294967295.0))
        at += 3 + names
    assert not screen.pixels().any(), "selection draws nothing"


def test_a_hit_record_is_a_tuple_of_depths_and_names(screen: glsim.Offscreen) -> None:
    glSelectBuffer(64)
    glRenderMode(GL_SELECT)
    glInitNames()
    glPushName(3)
    triangle(0, 0, -0.5)
    [(near, far, names)] = glRenderMode(GL_RENDER)
    assert (near, far) == pytest.approx((0.25, 0.3))
    assert names == [3]


def test_too_small_a_buffer_says_so(screen: glsim.Offscreen) -> None:
    glSelectBuffer(3)
    glRenderMode(GL_SELECT)
    glInitNames()
    glPushName(3)
    triangle(0, 0, 0)
    with pytest.raises(GLError, match="holds 3 numbers"):
        glRenderMode(GL_RENDER)
    assert glGetIntegerv(GL_RENDER_MODE) == GL_RENDER
    triangle(0, 0, 0)
    assert screen.pixels().any(), "after selection, drawing goes on"


def test_errors_of_the_name_stack(screen: glsim.Offscreen) -> None:
    glPopName()  # ignored outside of selection
    with pytest.raises(GLError, match="glSelectBuffer first"):
        glRenderMode(GL_SELECT)
    glSelectBuffer(64)
    glRenderMode(GL_SELECT)
    with pytest.raises(GLError, match="glPushName first"):
        glLoadName(1)
    with pytest.raises(GLError, match="more glPopName"):
        glPopName()
    for name in range(64):
        glPushName(name)
    with pytest.raises(GLError, match="is full"):
        glPushName(64)


# ---------------------------------------------------------------- feedback


def test_feedback_of_points_and_lines_is_the_drivers(screen: glsim.Offscreen, native: Native) -> None:
    def draw() -> None:
        lamp()
        material(**SHINY)
        glTexCoord4f(0.1, 0.2, 0.3, 1.5)
        glNormal3f(0.2, 0.3, 0.9)
        glBegin(GL_POINTS)
        glVertex3f(0.25, 0.5, 0.3)
        glVertex3f(1.5, 0.5, 0.9)
        glEnd()
        glPassThrough(17.0)
        glBegin(GL_LINE_STRIP)
        for k in range(4):
            glNormal3f(0.1 * k, 0.3, 0.9)
            glVertex3f(0.7 * k - 1, 0.2 * k, 0.1 * k)
        glEnd()

    for kind in (GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE):
        count, theirs = natively(native, draw, GL_FEEDBACK, kind)
        screen.reset()
        ours = glFeedbackBuffer(4096, kind)
        glRenderMode(GL_FEEDBACK)
        draw()
        records = glRenderMode(GL_RENDER)
        ours[ours == GL_LINE_RESET_TOKEN] = GL_LINE_TOKEN  # Mesa never says that a pattern begins anew
        assert ours[:count] == pytest.approx(theirs[:count], abs=2e-3)
        assert not ours[count:].any()
        assert [int(record[0]) for record in records] == [
            GL_POINT_TOKEN, GL_PASS_THROUGH_TOKEN, GL_LINE_RESET_TOKEN, GL_LINE_TOKEN, GL_LINE_TOKEN,
        ]  # fmt: skip


def test_feedback_of_triangles_is_the_drivers(screen: glsim.Offscreen, native: Native) -> None:
    def draw() -> None:
        camera(4.0)
        lamp()
        material(**SHINY)
        glEnable(GL_CULL_FACE)
        ball(6, 4, radius=0.7, mode=GL_TRIANGLES)

    count, theirs = natively(native, draw, GL_FEEDBACK)
    screen.reset()
    ours = glFeedbackBuffer(4096, GL_3D_COLOR)
    glRenderMode(GL_FEEDBACK)
    draw()
    records = glRenderMode(GL_RENDER)
    kept = {tuple(np.round(vertex.vertex, 1)) for record in records for vertex in record[1:]}
    rows = theirs[:count].reshape(-1, 23)  # token, 3, then three vertices of 7 numbers
    assert kept == {tuple(np.round(row[2 + 7 * k : 5 + 7 * k], 1)) for row in rows for k in range(3)}
    # the driver also keeps triangles without area, at the poles
    assert {record[0] for record in records} == {GL_POLYGON_TOKEN}
    assert ours[1] == 3.0


def test_a_clipped_quad_is_one_polygon(screen: glsim.Offscreen) -> None:
    glFeedbackBuffer(256, GL_2D)
    glRenderMode(GL_FEEDBACK)
    glBegin(GL_QUADS)
    for x, y in ((0, 0), (2, 0), (2, 0.5), (0, 0.5)):
        glVertex2f(x, y)
    glEnd()
    [(token, *vertices)] = glRenderMode(GL_RENDER)
    assert token == GL_POLYGON_TOKEN
    assert sorted(tuple(vertex.vertex) for vertex in vertices) == [(64, 64), (64, 96), (128, 64), (128, 96)]


def test_feedback_of_outlines_has_the_boundary_edges(screen: glsim.Offscreen) -> None:
    """Those of glEdgeFlag and those that glClipPlane makes; not what the view volume makes."""
    glFeedbackBuffer(256, GL_2D)
    glRenderMode(GL_FEEDBACK)
    glClipPlane(GL_CLIP_PLANE0, [-1, 0, 0, 0.5])
    glEnable(GL_CLIP_PLANE0)
    for mode in (GL_LINE, GL_POINT):
        glPolygonMode(GL_FRONT_AND_BACK, mode)
        glBegin(GL_QUADS)
        for flag, x, y in ((False, 0, 0), (True, 2, 0), (True, 2, 2), (True, 0, 2)):
            glEdgeFlag(flag)
            glVertex2f(x, y)
        glEnd()
    found = [(record[0], [tuple(v.vertex) for v in record[1:]]) for record in glRenderMode(GL_RENDER)]
    assert found == [
        (GL_LINE_RESET_TOKEN, [(96, 64), (96, 128)]),
        (GL_LINE_TOKEN, [(64, 128), (64, 64)]),
        (GL_POINT_TOKEN, [(96, 64)]),
        (GL_POINT_TOKEN, [(64, 128)]),
    ]


def test_feedback_of_polygon_mode_and_pixels(screen: glsim.Offscreen) -> None:
    glFeedbackBuffer(256, GL_3D_COLOR)
    glRenderMode(GL_FEEDBACK)
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    triangle(0, 0, 0)
    glColor3f(1, 0.5, 0)
    glRasterPos2f(0.5, 0.5)
    glBitmap(8, 8, 0, 0, 0, 0, bytes(8))
    glDrawPixels(1, 1, GL_RGB, GL_UNSIGNED_BYTE, bytes(4))
    glCopyPixels(0, 0, 1, 1, GL_COLOR)
    records: list[Any] = glRenderMode(GL_RENDER)
    assert [record[0] for record in records[3:]] == [GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN, GL_COPY_PIXEL_TOKEN]
    assert [record[0] for record in records[:3]] == [GL_LINE_RESET_TOKEN, GL_LINE_TOKEN, GL_LINE_TOKEN]
    assert records[3][1].vertex == pytest.approx([96, 96, 0.5])
    assert records[3][1].color == pytest.approx([1, 0.5, 0, 1])
