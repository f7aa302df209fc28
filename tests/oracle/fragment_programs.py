"""Rasterization, fog, and what happens to fragments."""

from __future__ import annotations

import math
from functools import partial

from glsim.gl import *
from tests.drawing import SHINY, ball, camera, lamp, material, pixel_coordinates, wheel
from tests.oracle.programs import PROGRAMS, program

# ---------------------------------------------------------------- points and lines


def dots() -> None:
    glBegin(GL_POINTS)
    for k in range(36):
        glColor3f(k / 36, 1 - k / 36, 0.5)
        glVertex2f(k % 6 * 0.31 - 0.78, k // 6 * 0.31 - 0.77)
    glEnd()


for _size in (1.0, 2.0, 3.4, 5.0, 10.0):

    @partial(PROGRAMS.__setitem__, f"point_size_{_size:g}")
    def _points(size: float = _size) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        glPointSize(size)
        dots()


@program
def points_smaller_with_distance() -> None:
    camera(4.0)
    glPointSize(20.0)
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, [0.2, 0.1, 0.3])
    glPointParameterf(GL_POINT_SIZE_MIN, 3.0)
    glPointParameterf(GL_POINT_SIZE_MAX, 12.0)
    glBegin(GL_POINTS)
    for k in range(12):
        glColor3f(1 - k / 12, k / 12, 0.7)
        glVertex3f(0.24 * k - 1.3, 0.1 * k - 0.6, 2.5 - 0.8 * k)
    glEnd()


# ---------------------------------------------------------------- polygons


def hill(n: int = 6) -> None:
    """Flat quads: a bent one would have two slopes, a degenerate one at a pole any."""
    glBegin(GL_QUADS)
    for i in range(n):
        for j in range(n):
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                x, y = 1.6 * (i + a) / n - 0.8, 1.6 * (j + b) / n - 0.8
                glVertex3f(x, y, 0.6 * math.cos(3 * x))
    glEnd()


for _mode, _cap in ((GL_LINE, GL_POLYGON_OFFSET_LINE), (GL_POINT, GL_POLYGON_OFFSET_POINT)):

    @partial(PROGRAMS.__setitem__, f"polygon_offset_for_{_mode.name[3:].lower()}s")
    def _offset(mode: int = _mode, cap: int = _cap) -> None:
        """Hidden lines as books draw them: edges pulled in front of the faces."""
        camera()
        glRotatef(-60, 1, 0, 0)
        glRotatef(25, 0, 0, 1)
        glColor3f(0.2, 0.3, 0.6)
        hill()
        glPolygonMode(GL_FRONT_AND_BACK, mode)
        glEnable(cap)
        glPolygonOffset(-2.5, -8.0)
        glPointSize(4)
        glColor3f(1, 1, 0.5)
        hill()


@program
def scissor() -> None:
    glClearColor(0.3, 0.3, 0.3, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_SCISSOR_TEST)
    glScissor(20, 30, 70, 50)
    glClearColor(0.1, 0.1, 0.5, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glColor3f(1, 1, 0)
    glRectf(-0.3, -0.9, 0.3, 0.9)
    glDisable(GL_SCISSOR_TEST)
    glRectf(0.7, 0.7, 0.9, 0.9)


@program
def polygon_stipple() -> None:
    pixel_coordinates(0.0)
    glEnable(GL_POLYGON_STIPPLE)
    glPolygonStipple(bytes((k * 37 + k // 4) % 256 for k in range(128)))
    glColor3f(1, 0.8, 0.2)
    glRecti(5, 7, 120, 110)


@program
def polygon_offset() -> None:
    camera()
    glRotatef(50, 1, 0, 0)
    glColor3f(0.2, 0.4, 0.8)
    glRectf(-1, -1, 1, 1)
    glEnable(GL_POLYGON_OFFSET_FILL)
    glPolygonOffset(-1.0, -100.0)
    glColor3f(0.9, 0.3, 0.1)
    glRectf(-0.5, -0.5, 0.5, 0.5)


for _mode in (GL_LINE, GL_POINT):

    @partial(PROGRAMS.__setitem__, f"polygon_mode_{_mode.name[3:].lower()}")
    def _unfilled(mode: int = _mode) -> None:
        glPolygonMode(GL_FRONT_AND_BACK, mode)
        camera(4.5)
        glColor3f(0.9, 0.7, 0.3)
        glRotatef(20, 1, 1, 0)
        glTranslatef(-0.7, 0, 0)
        ball(9, 6)
        glTranslatef(1.7, 0, 0)
        for primitive, count in ((GL_POLYGON, 7), (GL_TRIANGLE_FAN, 6), (GL_QUAD_STRIP, 6), (GL_TRIANGLE_STRIP, 5)):
            glBegin(primitive)
            for k in range(count):
                a = 2 * math.pi * k / count
                strip = primitive in (GL_QUAD_STRIP, GL_TRIANGLE_STRIP)
                x, y = (0.3 * (k // 2) - 0.4, 0.3 * (k % 2) - 0.2) if strip else (0.5 * math.cos(a), 0.5 * math.sin(a))
                glColor3f(1, k / count, 0.2)
                glVertex3f(x, y, 0)
            glEnd()
            glTranslatef(-0.3, -0.2, -0.7)


@program
def polygon_mode_per_face_with_culling_and_edge_flags() -> None:
    glPolygonMode(GL_FRONT, GL_LINE)
    glPolygonMode(GL_BACK, GL_FILL)
    camera(4.0)
    for k in range(8):
        glPushMatrix()
        glTranslatef(k % 4 * 0.75 - 1.1, k // 4 * 1.1 - 0.5, 0)
        glRotatef(180 * (k % 2), 0, 1, 0)
        (glEnable if k >= 4 else glDisable)(GL_CULL_FACE)
        glCullFace(GL_BACK if k < 6 else GL_FRONT)
        glBegin(GL_POLYGON)
        for j in range(5):
            glEdgeFlag(j != k % 5)
            glColor3f(1, j / 5, k / 8)
            glVertex2f(0.35 * math.cos(1.257 * j), 0.35 * math.sin(1.257 * j))
        glEnd()
        glPopMatrix()


@program
def wireframe_lit_and_two_sided() -> None:
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    camera()
    lamp()
    material(GL_FRONT, **SHINY)
    material(GL_BACK, diffuse=(0, 0.8, 0.3, 1))
    for turn in (40, 200):
        glPushMatrix()
        glRotatef(turn, 0.3, 1, 0)
        wheel(lambda k: None)
        glPopMatrix()


# ---------------------------------------------------------------- clip planes


@program
def clip_planes() -> None:
    camera()
    lamp()
    material(**SHINY)
    glClipPlane(GL_CLIP_PLANE0, [0.3, 1.0, 0.0, 0.2])
    glRotatef(30, 0, 0, 1)
    glClipPlane(GL_CLIP_PLANE3, [-1.0, 0.0, 0.5, 0.6])
    glEnable(GL_CLIP_PLANE0)
    glEnable(GL_CLIP_PLANE3)
    glScalef(1, 0.8, 1)
    ball(20, 14, mode=GL_TRIANGLES)
    glDisable(GL_CLIP_PLANE3)
    glDisable(GL_LIGHTING)
    glBegin(GL_LINES)
    glVertex3f(-1, -1, 1.0)
    glVertex3f(1, 1, 1.0)
    glEnd()


# ---------------------------------------------------------------- fog


def foggy(mode: int, **parameters: float) -> None:
    glClearColor(0.5, 0.5, 0.6, 1)
    camera(4.0)
    lamp()
    material(**SHINY)
    glEnable(GL_FOG)
    glFogi(GL_FOG_MODE, mode)
    glFogfv(GL_FOG_COLOR, [0.5, 0.5, 0.6, 1.0])
    for name, value in parameters.items():
        glFogf(globals()["GL_FOG_" + name.upper()], value)
    for k in range(4):
        glPushMatrix()
        glTranslatef(0.8 * k - 1.3, 0.2 * k - 0.3, 1.5 - 1.7 * k)
        ball(12, 8, 0.5, mode=GL_TRIANGLES)
        glPopMatrix()


PROGRAMS["fog_linear"] = partial(foggy, GL_LINEAR, start=2.0, end=8.0)
PROGRAMS["fog_exp"] = partial(foggy, GL_EXP, density=0.3)
PROGRAMS["fog_exp2"] = partial(foggy, GL_EXP2, density=0.25)


@program
def fog_by_coordinate() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_FOG)
    glFogi(GL_FOG_MODE, GL_LINEAR)
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE)
    glFogfv(GL_FOG_COLOR, [0, 0, 1, 1])
    glBegin(GL_TRIANGLES)
    for x, y, c in ((-0.9, -0.8, 0.0), (0.9, -0.6, 0.5), (0, 0.9, 1.0)):
        glColor3f(1, 1, 0)
        glFogCoordf(c)
        glVertex2f(x, y)
    glEnd()


@program
def color_sum() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_COLOR_SUM)
    glBegin(GL_TRIANGLES)
    for x, y, c in ((-0.9, -0.8, (1, 0, 0)), (0.9, -0.6, (0, 0.5, 0)), (0, 0.9, (0, 0, 1))):
        glColor3f(0.3, 0.4, 0.2)
        glSecondaryColor3fv(c)
        glVertex2f(x, y)
    glEnd()


# ---------------------------------------------------------------- alpha test, blending, logic op, stencil


def overlapping(alpha: float = 0.6) -> None:
    for k in range(4):
        glBegin(GL_TRIANGLES)
        for j, (x, y) in enumerate(((-0.9, -0.9), (0.5, -0.6), (-0.2, 0.6))):
            glColor4f(0.3 + 0.2 * j, 1 - 0.25 * k, 0.25 * k, alpha * (j + 1) / 3)
            glVertex2f(x + 0.15 * k, y + 0.1 * k)
        glEnd()


for _func in (GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS):

    @partial(PROGRAMS.__setitem__, f"alpha_{_func.name[3:].lower()}")
    def _alpha(func: int = _func) -> None:
        glClearColor(0.1, 0.1, 0.1, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_ALPHA_TEST)
        glAlphaFunc(func, 0.4)
        overlapping()


BLENDS = {
    "over": (GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA),
    "add": (GL_ONE, GL_ONE),
    "multiply": (GL_DST_COLOR, GL_ZERO),
    "destination_alpha": (GL_ONE_MINUS_DST_ALPHA, GL_DST_ALPHA),
    "saturate": (GL_SRC_ALPHA_SATURATE, GL_ONE),
    "constant": (GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA),
    "inverse": (GL_ONE_MINUS_DST_COLOR, GL_ONE_MINUS_SRC_COLOR),
}
for _name, _factors in BLENDS.items():

    @partial(PROGRAMS.__setitem__, f"blend_{_name}")
    def _blend(factors: tuple[int, int] = _factors) -> None:
        glClearColor(0.3, 0.4, 0.5, 0.7)
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_BLEND)
        glBlendColor(0.7, 0.4, 0.2, 0.5)
        glBlendFunc(*factors)
        overlapping()


for _equation in (GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX):

    @partial(PROGRAMS.__setitem__, f"blend_equation_{_equation.name[3:].lower()}")
    def _blend_equation(equation: int = _equation) -> None:
        glClearColor(0.3, 0.4, 0.5, 0.7)
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_BLEND)
        glBlendEquation(equation)
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE, GL_ONE, GL_ZERO)
        overlapping()


for _op in (GL_CLEAR, GL_XOR, GL_INVERT, GL_AND_REVERSE, GL_NAND, GL_OR, GL_EQUIV, GL_COPY_INVERTED, GL_SET, GL_NOOP):

    @partial(PROGRAMS.__setitem__, f"logic_op_{_op.name[3:].lower()}")
    def _logic(op: int = _op) -> None:
        glClearColor(0.3, 0.4, 0.5, 1.0)
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_COLOR_LOGIC_OP)
        glLogicOp(op)
        for k in range(4):
            glColor4ub(40 * k + 17, 255 - 50 * k, 77, 200)
            glRectf(-0.9 + 0.2 * k, -0.8 + 0.3 * k, 0.3 + 0.2 * k, 0.1 + 0.2 * k)


@program
def stencil_mask_of_a_shape() -> None:
    glClearStencil(2)
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)
    glEnable(GL_STENCIL_TEST)
    glStencilFunc(GL_ALWAYS, 5, 0xFF)
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE)
    glColorMask(0, 0, 0, 0)
    glBegin(GL_TRIANGLES)
    for x, y in ((-0.8, -0.8), (0.8, -0.7), (0, 0.8)):
        glVertex2f(x, y)
    glEnd()
    glColorMask(1, 1, 1, 1)
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP)
    for func, ref, color in ((GL_EQUAL, 5, (1, 0.5, 0)), (GL_NOTEQUAL, 5, (0, 0.3, 0.6))):
        glStencilFunc(func, ref, 0xFF)
        glColor3fv(color)
        glRectf(-0.9, -0.9, 0.9, 0.5)


@program
def stencil_counts_overdraw() -> None:
    camera()
    glClear(GL_STENCIL_BUFFER_BIT)
    glEnable(GL_STENCIL_TEST)
    glStencilFunc(GL_ALWAYS, 0, 0xFF)
    glStencilOp(GL_KEEP, GL_INVERT, GL_INCR)
    for k in range(6):
        glRectf(-1 + 0.2 * k, -1 + 0.15 * k, 0.1 + 0.2 * k, 0.3 + 0.1 * k)
        glTranslatef(0, 0, 0.05)
    glLoadIdentity()
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glDisable(GL_DEPTH_TEST)
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP)
    for k in range(1, 7):
        glStencilFunc(GL_LEQUAL, k, 0xFF)
        glColor3f(k / 6, 1 - k / 6, 0.3)
        glRectf(-1, -1, 1, 1)


@program
def stencil_masks() -> None:
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)
    glEnable(GL_STENCIL_TEST)
    glStencilMask(0x0F)
    glStencilFunc(GL_ALWAYS, 0xFF, 0xFF)
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE)
    glColor3f(0.3, 0.3, 0.9)
    glRectf(-0.8, -0.8, 0.3, 0.3)
    glStencilFunc(GL_EQUAL, 0x05, 0x05)
    glStencilOp(GL_ZERO, GL_KEEP, GL_DECR_WRAP)
    glColor3f(0.9, 0.8, 0.1)
    glRectf(-0.3, -0.3, 0.8, 0.8)
    glStencilFunc(GL_EQUAL, 0x0E, 0x0F)
    glColor3f(0.9, 0.1, 0.1)
    glRectf(-0.9, -0.9, 0.9, 0.9)
