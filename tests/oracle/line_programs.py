"""Wide and stippled lines, and polygons drawn as edges or points: materials, culling, clipping."""

from __future__ import annotations

import math
from functools import partial

from glsim.gl import *
from tests.oracle.fragment_programs import LINES
from tests.oracle.programs import PROGRAMS, lamp, program

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

            @partial((PROGRAMS if _smooth else LINES).__setitem__, f"materials_of_wide_{_mode!r}_{_shade!r}{'_smooth' * _smooth}")
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
