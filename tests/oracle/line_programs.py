"""Wide and stippled lines, and polygons drawn as edges or points: materials, culling, clipping."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

from glsim.gl import *
from tests.drawing import SHINY, ball, camera, lamp, material
from tests.oracle.programs import PROGRAMS, program

# Where a wide line ends and where a stipple pattern changes may differ by one pixel: drivers have rules of their own.
LINES: dict[str, Callable[[], None]] = {}
# Mesa rounds the ends of a line to 1/256 pixel and knows no coverage more exactly: one more 1/255 of each colour.
SMOOTH: dict[str, Callable[[], None]] = {}


def star() -> None:
    glBegin(GL_LINES)
    for k in range(16):
        a = k * math.pi / 8 + 0.1
        glColor3f(k / 16, 1 - k / 16, 0.5)
        glVertex2f(0.2 * math.cos(a), 0.2 * math.sin(a))
        glVertex2f(0.9 * math.cos(a), 0.9 * math.sin(a))
    glEnd()


for _width in (2.0, 3.0, 5.4, 9.0):

    @partial(LINES.__setitem__, f"line_width_{_width:g}")
    def _wide(width: float = _width) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        glLineWidth(width)
        star()


@partial(LINES.__setitem__, "wide_lines_flat_in_perspective")
def wide_lines_lit_flat_in_perspective() -> None:
    glShadeModel(GL_FLAT)
    camera(2.2)
    glLineWidth(4.0)
    glRotatef(60, 1, 0.2, 0)
    for k in range(6):
        glBegin(GL_LINE_STRIP)
        for j in range(5):
            glColor3f(k / 6, j / 5, 0.6)
            glVertex3f(0.4 * j - 0.9, 0.35 * k - 0.9, 0.1 * (j % 2))
        glEnd()


for _pattern, _factor in ((0x00FF, 1), (0x3333, 2), (0x0C0F, 3)):

    @partial(LINES.__setitem__, f"line_stipple_{_pattern:04x}_{_factor}")
    def _stippled(pattern: int = _pattern, factor: int = _factor) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_LINE_STIPPLE)
        glLineStipple(factor, pattern)
        star()


@partial(LINES.__setitem__, "line_stipple_wide")
def line_stipple_wide() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_LINE_STIPPLE)
    glLineStipple(2, 0x3F07)
    glLineWidth(3.0)
    star()


for _width in (1.0, 2.0, 3.5, 7.25):

    @partial(PROGRAMS.__setitem__, f"smooth_lines_of_width_{_width:g}")
    def _smooth_lines(width: float = _width) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_LINE_SMOOTH)
        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        glLineWidth(width)
        star()


@program
def smooth_lines_on_the_faces_of_a_ball() -> None:
    """Without perspective: with it Mesa interpolates the distance from the line wrongly, and lines get thinner."""
    glClear(GL_COLOR_BUFFER_BIT)
    glOrtho(-1.2, 1.2, -1.2, 1.2, -2, 2)
    lamp()
    material(**SHINY)
    glEnable(GL_LINE_SMOOTH)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE)
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    glRotatef(17, 1, 0.6, 0.3)
    ball(8, 6)


# ---------------------------------------------------------------- materials


def painted(mode: int, count: int = 12) -> None:
    """Every third vertex has a glMaterial before it."""
    lamp(GL_LIGHT0, (0.0, 0.0, 1.0, 0.0))
    glBegin(mode)
    for k in range(count):
        if k % 3 == 0:
            glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, [k % 2, k / count, 1 - k / count, 1])
        a = 2 * math.pi * k / count
        strip = mode in (GL_TRIANGLE_STRIP, GL_QUAD_STRIP)
        x, y = (0.15 * (k // 2) - 0.4, 0.7 * (k % 2) - 0.3) if strip else (0.8 * math.cos(a), 0.7 * math.sin(a))
        glVertex2f(x, y)
    glEnd()


for _mode in (GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP):
    for _shade in (GL_FLAT, GL_SMOOTH):
        for _smooth in (False, True):

            @partial(
                (PROGRAMS if _smooth else LINES).__setitem__,
                f"materials_of_wide_{_mode!r}_{_shade!r}{'_smooth' * _smooth}",
            )
            def _painted_lines(mode: int = _mode, shade: int = _shade, smooth: bool = _smooth) -> None:
                glShadeModel(shade)
                glLineWidth(4)
                if smooth:
                    glEnable(GL_LINE_SMOOTH)
                    glEnable(GL_BLEND)
                    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
                painted(mode)


for _mode in (GL_TRIANGLES, GL_TRIANGLE_FAN, GL_TRIANGLE_STRIP, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON):

    @partial(LINES.__setitem__, f"materials_of_the_wide_outlines_of_{_mode!r}")
    def _painted_outlines(mode: int = _mode) -> None:
        glShadeModel(GL_FLAT)
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
        glLineWidth(4)
        painted(mode)


@program
def material_after_the_last_vertex_is_not_the_next_primitives() -> None:
    lamp()
    glBegin(GL_TRIANGLES)
    for x, y in ((-0.9, -0.9), (0, -0.9), (-0.5, 0.5)):
        glVertex2f(x, y)
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, [1, 0, 0, 1])
    glEnd()
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, [0, 1, 0, 1])
    glBegin(GL_TRIANGLES)
    for x, y in ((0.1, -0.9), (0.9, -0.9), (0.5, 0.5)):
        glVertex2f(x, y)
    glEnd()


# ---------------------------------------------------------------- polygons that are not filled


def clockwise() -> None:
    glBegin(GL_TRIANGLES)
    for x, y in ((0, 0), (0, 0.8), (0.8, 0)):
        glVertex2f(x, y)
    glEnd()


for _mode in (GL_LINE, GL_POINT):

    @partial(PROGRAMS.__setitem__, f"nothing_left_to_draw_{_mode!r}")
    def _culled(mode: int = _mode) -> None:
        """Flushes in which all polygons are culled, incomplete or without boundary edges."""
        glRectf(-0.9, -0.9, -0.5, -0.5)
        glPolygonMode(GL_FRONT_AND_BACK, mode)
        glEnable(GL_CULL_FACE)
        for width in (1, 3):
            glLineWidth(width)
            glFlush()
            clockwise()
            glFlush()
            glNewList(1, GL_COMPILE)
            clockwise()
            glEndList()
            glCallList(1)
            glFlush()
            glBegin(GL_POLYGON)
            glVertex2f(0, 0)
            glEnd()
            glFlush()
            glEdgeFlag(GL_FALSE)
            glRectf(0.1, 0.1, 0.1, 0.1)
            glFlush()
            glBegin(GL_TRIANGLES)
            for x, y in ((0, 0), (0.8, 0), (0, 0.8)):
                glVertex2f(x, y)
            glEnd()
            glEdgeFlag(GL_TRUE)
            glFlush()
        glCullFace(GL_FRONT_AND_BACK)
        glRectf(0, 0, 0.5, 0.5)


# ---------------------------------------------------------------- clipping


def cut(view: bool = False) -> None:
    """A clip plane, and for half of the programs a viewport that is smaller than the window."""
    glClipPlane(GL_CLIP_PLANE1, [-0.5, -1, 0, 0.31])
    glEnable(GL_CLIP_PLANE1)
    if view:
        glViewport(30, 22, 64, 70)


@program
def points_at_the_border_of_the_clip_volume() -> None:
    for k, viewport in enumerate(((0, 0, 128, 128), (30, 30, 60, 60))):
        glViewport(*viewport)
        glPointSize(5 + k)
        glBegin(GL_POINTS)
        for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1), (1.001, 0.5), (0.5, -1.001), (0.9999, 0.5)):
            glColor3f(1, x / 2 + 0.5, y / 2 + 0.5)
            glVertex2f(x, y)
        glEnd()


def rays() -> None:
    """Lines that begin outside of the clip volume, end there, or pass it by."""
    glBegin(GL_LINES)
    for x0, y0, z0, x1, y1, z1 in (
        (-1.7, -0.53, 0, 0.6, 0.31, 0), (0.11, 0.4, 0, 0.23, 1.9, 0), (-0.7, 0.9, -1.6, -0.4, -0.8, 0.5),
        (1.04, -0.9, 0, 1.04, 0.9, 0), (0.96, -0.83, 0, 0.96, 0.37, 0), (0.2, -1.21, 0, 0.7, -0.17, 1.4),
    ):  # fmt: skip
        glColor3f(1, 0.3, 0.2)
        glVertex3f(x0, y0, z0)
        glColor3f(0.1, 1, 0.9)
        glVertex3f(x1, y1, z1)
    glEnd()


for _name, _width, _smooth, _stipple in (
    ("wide", 7, False, False), ("stippled", 1, False, True), ("wide_stippled", 5, False, True),
    ("smooth", 6, True, False), ("smooth_stippled", 4, True, True),
):  # fmt: skip
    for _view in (False, True):

        @partial((SMOOTH if _smooth else LINES).__setitem__, f"clipped_{_name}_lines{'_in_a_viewport' * _view}")
        def _rays(width: float = _width, smooth: bool = _smooth, stipple: bool = _stipple, view: bool = _view) -> None:
            cut(view)
            glLineWidth(width)
            if smooth:
                glEnable(GL_LINE_SMOOTH)
                glEnable(GL_BLEND)
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
            if stipple:
                glEnable(GL_LINE_STIPPLE)
                glLineStipple(2, 0x3F07)
            rays()


@program
def a_wide_line_beside_the_clip_volume_is_not_there() -> None:
    glRectf(-0.1, -0.1, 0.1, 0.1)
    glLineWidth(9)
    glBegin(GL_LINES)
    for x, y in ((1.03, -0.9), (1.03, 0.9), (-0.9, -1.02), (0.9, -1.02)):
        glVertex2f(x, y)
    glEnd()


def tent(mode: int = GL_TRIANGLES) -> None:
    glBegin(mode)
    for j, (x, y, z) in enumerate(((-0.8, -0.7, 0), (0.8, -0.7, -0.2), (0, 0.8, 0.1), (-0.95, 0.9, 0))):
        if j < 3 or mode != GL_TRIANGLES:
            glColor3f(1 - j / 3, j / 3, 0.5)
            glNormal3f(x, y, 0.6)
            glVertex3f(x, y, z)
    glEnd()


for _mode in (GL_LINE, GL_POINT):
    for _shade in (GL_SMOOTH, GL_FLAT):
        for _lit in (False, True):

            @partial(PROGRAMS.__setitem__, f"cut_by_a_plane_{_mode!r}_{_shade!r}{'_lit' * _lit}")
            def _cut(mode: int = _mode, shade: int = _shade, lit: bool = _lit) -> None:
                """Edges and corners that glClipPlane makes."""
                glShadeModel(shade)
                glPolygonMode(GL_FRONT_AND_BACK, mode)
                glPointSize(5)
                cut()
                if lit:
                    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
                    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR)
                    lamp(GL_LIGHT0, (0.5, 0.6, 0.4, 1.0))
                    material(GL_FRONT, **SHINY)
                    material(GL_BACK, diffuse=(0.1, 0.8, 0.3, 1), specular=(0.5, 0.1, 0.1, 1), shininess=4)
                tent()
                glScalef(0.7, -0.6, 1)
                tent()


@program
def corners_that_the_view_volume_makes() -> None:
    """In the window's border, in the viewport's, and at the near and the far plane."""
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT)
    glPointSize(5)
    for viewport in ((0, 0, 128, 128), (40, 50, 40, 50)):
        glViewport(*viewport)
        for scale, depth in ((1.6, 0), (0.9, -4), (0.7, 5)):
            glBegin(GL_TRIANGLES)
            for j, (x, y) in enumerate(((-0.8, -0.7), (0.83, -0.7), (0.02, 0.81))):
                glColor3f(1 - j / 3, j / 3, 0.5)
                glVertex3f(scale * x, scale * y, depth * (j == 1))
            glEnd()


@program
def several_planes_cut_an_outline() -> None:
    """Of a quad as a whole, in perspective, with a plane that the near plane cuts too."""
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    camera(2.0)
    glClipPlane(GL_CLIP_PLANE0, [1, 0.2, 0, 0.35])
    glClipPlane(GL_CLIP_PLANE2, [-0.3, -1, 0.1, 0.5])
    glEnable(GL_CLIP_PLANE0)
    glEnable(GL_CLIP_PLANE2)
    glRotatef(50, 0.3, 1, 0.1)
    for scale in (0.8, 1.3, 2.4):
        glTranslatef(0, 0, 0.1)
        glColor3f(1, scale / 2.5, 0.3)
        glBegin(GL_TRIANGLES)
        for x, y in ((-scale, -scale), (scale, -scale), (scale, scale)):
            glVertex2f(x, y)
        glEnd()
    glTranslatef(0, 0, 0.1)
    glColor3f(0.2, 0.6, 1)
    glRectf(-0.9, -0.6, 0.9, 0.7)
