"""Programs that look like a mistake and are meant, and variants of mistakes: light, colours, textures, depth."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from glsim.gl import *
from glsim.glu import gluLookAt
from glsim.glut import glutSolidCube
from tests.drawing import lit
from tests.study.planted import checkered, textured_square, view

MEANT: list[Callable[[], None]] = []
WRONG: dict[Callable[[], None], str] = {}


def meant(program: Callable[[], None]) -> Callable[[], None]:
    MEANT.append(program)
    return program


def wrong(kind: str) -> Callable[[Callable[[], None]], Callable[[], None]]:
    def note(program: Callable[[], None]) -> Callable[[], None]:
        WRONG[program] = kind
        return program

    return note


def scene(near: float = 1.0) -> None:
    lit()
    view(near)
    glLoadIdentity()
    gluLookAt(1, 2, 4, 0, 0, 0, 0, 1, 0)


def box(size: float, turned: bool = False, normals: int = 1, flipped: int = -1) -> None:
    """A cube of six glBegin; turned: clockwise; flipped: the one face whose normal is turned round."""
    for number in range(6):
        axis, sign = number // 2, 1 if number % 2 == 0 else -1
        u, v = (axis + 1) % 3, (axis + 2) % 3
        corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        if (sign < 0) != turned:
            corners.reverse()
        normal = [0.0, 0.0, 0.0]
        normal[axis] = sign * normals * (-1 if number == flipped else 1)
        glNormal3f(*normal)
        glBegin(GL_QUADS)
        for a, b in corners:
            point = [0.0, 0.0, 0.0]
            point[axis], point[u], point[v] = sign * size, a * size, b * size
            glVertex3f(*point)
        glEnd()


# ---------------------------------------------------------------- light and colours


@meant
def a_first_pass_without_lights() -> None:
    scene()
    glDisable(GL_LIGHT0)
    glutSolidCube(1)
    glEnable(GL_LIGHT0)
    glutSolidCube(1)


@meant
def only_the_glow_of_the_scene() -> None:
    glEnable(GL_LIGHTING)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (1, 1, 1, 1))
    glutSolidCube(1)


@meant
def a_second_light_with_a_colour() -> None:
    scene()
    glEnable(GL_LIGHT3)
    glLightfv(GL_LIGHT3, GL_AMBIENT, (0.2, 0.2, 0.2, 1))
    glutSolidCube(1)


@wrong("black-light")
def a_second_light_in_a_display_list() -> None:
    glNewList(1, GL_COMPILE)
    glEnable(GL_LIGHT2)
    glEndList()
    scene()
    glCallList(1)
    glutSolidCube(1)


@wrong("no-k_s")
def a_shininess_without_specular() -> None:
    scene()
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 50)
    glutSolidCube(1)


@meant
def one_material_of_two_is_shiny() -> None:
    scene()
    glLightfv(GL_LIGHT0, GL_SPECULAR, (1, 1, 1, 1))
    glutSolidCube(0.5)
    glMaterialfv(GL_FRONT, GL_SPECULAR, (0.1, 0.1, 0.1, 1))
    glTranslatef(1, 0, 0)
    glutSolidCube(0.5)


@meant
def a_colour_for_what_is_drawn_without_light() -> None:
    scene()
    glDisable(GL_LIGHTING)
    glColor3f(1, 0, 0)
    glRectf(-1, -1, -0.5, -0.5)
    glEnable(GL_LIGHTING)
    glutSolidCube(0.5)


@meant
def a_colour_and_a_material() -> None:
    scene()
    glColor4ub(255, 0, 0, 255)
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (1, 0, 0, 1))
    glutSolidCube(0.5)


@wrong("color-ignored")
def a_colour_of_bytes_that_was_set_at_the_start() -> None:
    glColor4ub(255, 0, 0, 255)
    scene()
    glutSolidCube(0.5)


@wrong("color-ignored")
def an_array_of_colours() -> None:
    lit()
    glNormal3f(0, 0, 1)
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glVertexPointer(2, GL_FLOAT, 0, np.array([[-1, -1], [1, -1], [0, 1]], np.float32))
    glColorPointer(3, GL_FLOAT, 0, np.eye(3, dtype=np.float32))
    glDrawArrays(GL_TRIANGLES, 0, 3)


@wrong("color-range")
def small_integers() -> None:
    glColor3i(255, 0, 0)
    glRectf(-1, -1, 1, 1)


@wrong("color-range")
def a_background_of_bytes() -> None:
    glClearColor(128, 128, 255, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glRectf(-0.5, -0.5, 0.5, 0.5)


@meant
def bright_colours() -> None:
    scene()
    glLightfv(GL_LIGHT0, GL_DIFFUSE, (3, 3, 3, 1))
    glMaterialiv(GL_FRONT, GL_DIFFUSE, (2**31 - 1, 0, 0, 0))
    glColor3ub(1, 0, 0)
    glutSolidCube(0.5)


# ---------------------------------------------------------------- texture and depth


@meant
def a_texture_that_replaces_without_light() -> None:
    checkered()
    glEnable(GL_DEPTH_TEST)
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    textured_square()


@meant
def a_background_that_replaces() -> None:
    scene()
    checkered()
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    glDepthMask(GL_FALSE)
    glutSolidCube(0.5)
    glDepthMask(GL_TRUE)
    glDisable(GL_TEXTURE_2D)
    glutSolidCube(0.5)


@wrong("texture-replaces-light")
def a_decal_without_alpha_and_without_depth_test() -> None:
    lit()
    glDisable(GL_DEPTH_TEST)
    checkered()
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL)
    glNormal3f(0, 0, 1)
    glRectf(-0.5, -0.5, 0.5, 0.5)


@wrong("coarse-depth")
def a_frustum_that_begins_at_the_eye() -> None:
    lit()
    glMatrixMode(GL_PROJECTION)
    glFrustum(-4e-5, 4e-5, -4e-5, 4e-5, 1e-4, 100)
    glMatrixMode(GL_MODELVIEW)
    glTranslatef(0, 0, -4)
    glutSolidCube(0.5)


@meant
def texture_0_switches_textures_off() -> None:
    checkered()
    glBindTexture(GL_TEXTURE_2D, 0)
    textured_square()


@wrong("incomplete-texture")
def an_image_for_another_texture() -> None:
    checkered()
    glBindTexture(GL_TEXTURE_2D, 77)
    textured_square()


@meant
def culling_is_enough_for_a_convex_thing() -> None:
    scene()
    glDisable(GL_DEPTH_TEST)
    glEnable(GL_CULL_FACE)
    box(0.5)


@wrong("no-depth-test")
def a_cube_without_depth_test() -> None:
    scene()
    glDisable(GL_DEPTH_TEST)
    box(0.5)


@meant
def from_the_back_to_the_front_and_blended() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    for z in (0.5, 0.0, -0.5):
        glColor3f(0.5 - z, 0.5, 0.5)
        glBegin(GL_QUADS)
        for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
            glVertex3f(x, y, z)
        glEnd()
    glEnable(GL_BLEND)
    glBlendFunc(GL_ONE, GL_ONE)
    glTranslatef(0, 0, 0.4)
    glRectf(-0.4, -0.4, 0.4, 0.4)


@meant
def a_planar_shadow() -> None:
    scene()
    glutSolidCube(0.5)
    glDisable(GL_LIGHTING)
    glMultMatrixf([[2, 0, 0, 0], [-1, 0, -1, -1], [0, 0, 2, 0], [0, 0, 0, 2]])
    glColor3f(0, 0, 0)
    glutSolidCube(0.5)
