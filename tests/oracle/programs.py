"""Small programs, each about one thing.  ``PROGRAMS`` maps a name to a function that draws in a 128 x 128 picture."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import numpy as np

from glsim.gl import *
from tests.drawing import ball, camera, lamp, pixel_coordinates

PROGRAMS: dict[str, Callable[[], None]] = {}


def program(function: Callable[[], None]) -> Callable[[], None]:
    PROGRAMS[function.__name__] = function
    return function


# ---------------------------------------------------------------- primitives x shade model x entry path

MODES = (
    GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
    GL_QUAD_STRIP, GL_POLYGON,
)  # fmt: skip


def vertices_for(mode: int) -> tuple[np.ndarray, np.ndarray]:
    """Positions and colours of about a dozen vertices that make sensible primitives of a mode."""
    rng = np.random.default_rng(int(mode) + 5)
    if mode in (GL_LINE_LOOP, GL_TRIANGLE_FAN, GL_POLYGON):
        angle = np.arange(9) * 2 * np.pi / 9
        points = np.stack([0.8 * np.cos(angle), 0.7 * np.sin(angle), 0 * angle], 1)
    elif mode in (GL_TRIANGLE_STRIP, GL_QUAD_STRIP, GL_LINE_STRIP):
        k = np.arange(11)
        points = np.stack([k / 6 - 0.83, np.where(k % 2, 0.6, -0.55) + 0.03 * k, 0 * k], 1)
        if mode == GL_QUAD_STRIP:
            points[:, 0] = (k // 2) / 3 - 0.8
    elif mode == GL_QUADS:
        corner = np.array([(0, 0), (0.7, 0), (0.7, 0.7), (0, 0.7)])
        offsets = ((-0.85, -0.8), (0.1, -0.75), (-0.8, 0.1))
        points = np.concatenate([np.c_[corner + offset, np.zeros(4)] for offset in offsets])
    else:
        points = np.c_[rng.uniform(-0.9, 0.9, (12, 2)), np.zeros(12)]
    colors = np.c_[rng.uniform(0.2, 1.0, (len(points), 3)), np.ones(len(points))]
    if mode in (GL_QUADS, GL_QUAD_STRIP, GL_POLYGON):
        # colours that are linear in x and y look the same however the polygon is cut into triangles: how is not
        # specified, and Mesa itself cuts glDrawElements' quads and strips along the other diagonal
        colors[:, :3] = 0.5 + 0.3 * points[:, [0, 1, 0]] * (1, 1, -1)
    return points.astype("f4"), colors.astype("f4")


def draw_primitive(mode: int, shade: int, path: str) -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glShadeModel(shade)
    points, colors = vertices_for(mode)
    if path == "begin":
        glBegin(mode)
        for p, c in zip(points.tolist(), colors.tolist()):
            glColor4fv(c)
            glVertex3fv(p)
        glEnd()
        return
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, points)
    glColorPointer(4, GL_FLOAT, 0, colors)
    if path == "arrays":
        glDrawArrays(mode, 0, len(points))
    else:
        order = np.arange(len(points), dtype=np.uint16)
        glDrawElements(mode, len(points), GL_UNSIGNED_SHORT, order)


for _mode in MODES:
    for _shade in (GL_FLAT, GL_SMOOTH):
        for _path in ("begin", "arrays", "elements"):
            _name = f"{_mode.name[3:]}_{_shade.name[3:]}_{_path}".lower()
            PROGRAMS[_name] = partial(draw_primitive, _mode, _shade, _path)


# ---------------------------------------------------------------- matrices, clipping, depth, culling, masks


@program
def clipped_by_every_plane_flat() -> None:
    glShadeModel(GL_FLAT)
    clipped()


@program
def clipped_by_every_plane_smooth() -> None:
    clipped()


def clipped() -> None:
    camera(2.0)
    rng = np.random.default_rng(3)
    for mode in (GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_LINES, GL_LINE_LOOP, GL_POINTS):
        glBegin(mode)
        for _ in range(12):
            glColor3f(*rng.uniform(0.2, 1, 3))
            glVertex3f(*(rng.uniform(-1, 1, 3) * (2.5, 2.5, 4)))
        glEnd()
    glBegin(GL_POLYGON)
    glColor3f(0.9, 0.4, 0.2)
    for k in range(6):
        glVertex3f(3 * math.cos(k), 3 * math.sin(k), 1.2 * math.cos(k))
    glEnd()


@program
def near_plane_cuts_a_lit_polygon() -> None:
    camera(1.3)
    lamp()
    glRotatef(70, 1, 0, 0)
    glBegin(GL_POLYGON)
    for k in range(8):
        glNormal3f(0, 0.1 * k, 1)
        glVertex3f(1.5 * math.cos(k * math.pi / 4), 1.5 * math.sin(k * math.pi / 4), 0)
    glEnd()


@program
def matrix_stack() -> None:
    camera(5.0)
    lamp()
    for k in range(5):
        glPushMatrix()
        glRotatef(72 * k, 0, 0, 1)
        glTranslatef(1.3, 0, 0)
        glRotatef(20 * k, 1, 1, 0)
        glScalef(0.4, 0.4, 0.4)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.2 * k, 0.5, 1 - 0.2 * k, 1])
        ball(12, 8)
        glPopMatrix()


@program
def load_and_multiply() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadMatrixd(np.diag([0.9, 0.8, 1.0, 1.0]))
    glMatrixMode(GL_MODELVIEW)
    glLoadTransposeMatrixf([[1, 0, 0, 0.1], [0, 1, 0, -0.2], [0, 0, 1, 0], [0, 0, 0, 1]])
    glMultMatrixd([0.8, 0.3, 0, 0, -0.3, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
    glMultTransposeMatrixd([1, 0.2, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1])
    glRotated(33.0, 0.0, 0.0, -2.0)
    glBegin(GL_TRIANGLE_FAN)
    for k in range(7):
        glColor3f(k / 7, 0.5, 1 - k / 7)
        glVertex2d(0.8 * math.cos(k), 0.8 * math.sin(k))
    glEnd()


@program
def rotations() -> None:
    """About each axis and its opposite, and about others."""
    glClear(GL_COLOR_BUFFER_BIT)
    axes = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -3, 0), (0, 0, 1), (0, 0, -1), (1, 2, 3), (-1, 0.5, 0), (0, 1, 1)]
    for k, axis in enumerate(axes):
        glLoadIdentity()
        glTranslatef(k % 3 * 0.62 - 0.62, k // 3 * 0.62 - 0.62, 0)
        glRotatef(20 + 31 * k, *axis)
        glColor3f(1 - k / 9, 0.4, k / 9)
        glRectf(-0.25, -0.15, 0.25, 0.15)


@program
def ortho_and_viewport() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glViewport(20, 10, 90, 100)
    glMatrixMode(GL_PROJECTION)
    glOrtho(-3, 5, -2, 4, -1, 7)
    glMatrixMode(GL_MODELVIEW)
    glTranslatef(0.5, 0.5, -2)
    ball(12, 8)


@program
def depth_range_and_functions() -> None:
    glClearDepth(0.7)
    camera()
    glDisable(GL_DEPTH_TEST)
    glClear(GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    functions = (GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS)
    for k, function in enumerate(functions):
        glDepthRange(0.1 * k, 1 - 0.03 * k)
        glDepthFunc(function)
        glColor3f(1 - k / 8, k / 8, 0.5)
        glBegin(GL_TRIANGLES)
        glVertex3f(-1.2 + 0.2 * k, -1, 1.5)
        glVertex3f(-0.2 + 0.2 * k, -0.9, -2)
        glVertex3f(-0.8 + 0.2 * k, 1.2, -0.5)
        glEnd()


@program
def depth_mask() -> None:
    camera()
    glDepthMask(GL_FALSE)
    glColor3f(1, 0, 0)
    glRectf(-0.7, -0.7, 0.3, 0.3)
    glDepthMask(GL_TRUE)
    glTranslatef(0, 0, -1)
    glColor3f(0, 1, 0)
    glRectf(-0.3, -0.3, 0.9, 0.9)


@program
def color_mask() -> None:
    glClearColor(0.2, 0.3, 0.4, 1.0)
    glClear(GL_COLOR_BUFFER_BIT)
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE)
    glColor3f(1, 1, 0)
    glRectf(-0.7, -0.7, 0.3, 0.3)
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE)
    glRectf(-0.3, -0.3, 0.9, 0.9)


for _front in (GL_CCW, GL_CW):
    for _cull in (GL_FRONT, GL_BACK, GL_FRONT_AND_BACK):

        @partial(PROGRAMS.__setitem__, f"cull_{_cull.name[3:]}_{_front.name[3:]}".lower())
        def _culling(front: int = _front, cull: int = _cull) -> None:
            camera(1.8)
            glEnable(GL_CULL_FACE)
            glCullFace(cull)
            glFrontFace(front)
            lamp()
            glEnable(GL_COLOR_MATERIAL)
            glColor3f(0.3, 0.8, 0.6)
            ball(mode=GL_TRIANGLES)
            glNormal3f(0, 0, 1)
            glBegin(GL_LINES)
            glVertex3f(-0.5, 0.2, 0.6)
            glVertex3f(0.2, 0.1, 0.6)
            glEnd()


@program
def many_objects() -> None:
    """More objects than a uniform block has rows."""
    camera(6.0)
    lamp()
    for k in range(400):
        glPushMatrix()
        glTranslatef(k % 20 * 0.22 - 2.1, k // 20 * 0.22 - 2.1, 0)
        glRotatef(k, 1, 1, 0)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [k % 20 / 20, k // 20 / 20, 0.5, 1])
        glBegin(GL_QUADS)
        glNormal3f(0, 0, 1)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            glVertex2f(0.1 * x, 0.1 * y)
        glEnd()
        glPopMatrix()


@program
def mixed_primitives_in_order() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    rng = np.random.default_rng(11)
    for k in range(30):
        glShadeModel(GL_FLAT if k % 3 else GL_SMOOTH)
        glBegin(MODES[k % 10])
        for _ in range(4 + k % 5):
            glColor3fv(rng.uniform(0.2, 1, 3))
            glVertex2fv(rng.uniform(-0.9, 0.9, 2))
        glEnd()


# ---------------------------------------------------------------- coordinates exactly on or between pixels


@program
def points_between_pixels() -> None:
    pixel_coordinates(0.0)
    glBegin(GL_POINTS)
    for k in range(40):
        glVertex2i(3 * k + 2, k * 7 % 120 + 3)
    glEnd()


@program
def points_on_pixels() -> None:
    pixel_coordinates(0.5)
    glBegin(GL_POINTS)
    for k in range(40):
        glVertex2i(3 * k + 2, k * 7 % 120 + 3)
    glEnd()


@program
def lines_between_pixels() -> None:
    pixel_coordinates(0.0)
    for k in range(10):
        glBegin(GL_LINE_LOOP)
        for x, y in ((5, 5), (12, 5), (12, 100 - 5 * k), (5, 100 - 5 * k)):
            glVertex2i(x + 10 * k, y)
        glEnd()
    glBegin(GL_LINES)
    for k in range(20):
        glVertex2i(4 * k + 2, k * 7 % 120 + 3)
        glVertex2i(k * 37 % 120, 4 * k + 5)
    glEnd()


for _shift in (0.0, 0.5):

    @partial(PROGRAMS.__setitem__, "areas_on_pixels" if _shift else "areas_between_pixels")
    def _areas(shift: float = _shift) -> None:
        pixel_coordinates(shift)
        for k in range(10):
            glRecti(2 + 12 * k, 3 + 10 * k, 9 + 12 * k, 9 + 10 * k)
        glBegin(GL_TRIANGLES)
        for k in range(40):
            x, y = k % 8 * 15 + 3, k // 8 * 24 + 2
            glVertex2i(x, y)
            glVertex2i(x + k * 5 % 13 + 1, y + k * 3 % 7)
            glVertex2i(x + k * 7 % 11, y + 8 + k % 12)
        glEnd()
