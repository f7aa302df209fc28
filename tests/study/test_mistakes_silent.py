"""Where the rules of glsim.study.mistakes stay silent: what looks like a mistake and is meant."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluOrtho2D, gluPerspective
from glsim.glu.quadric import gluNewQuadric, gluQuadricOrientation, gluSphere
from glsim.glut.shapes import glutSolidCube, glutSolidSphere
from glsim.glut.teaset import glutSolidTeapot
from tests.drawing import captured, lit
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


def kinds(program: Callable[[], None]) -> list[str]:
    return [found.kind for found in glsim.trace(captured(program)).mistakes]


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


# ---------------------------------------------------------------- winding and normals


@meant
def a_cube_with_culling() -> None:
    scene()
    glEnable(GL_CULL_FACE)
    box(0.5)


@wrong("culled-front")
def a_cube_with_clockwise_faces_and_culling() -> None:
    scene()
    glEnable(GL_CULL_FACE)
    box(0.5, turned=True)


@meant
def a_cube_with_clockwise_faces_and_gl_cw() -> None:
    scene()
    glEnable(GL_CULL_FACE)
    glFrontFace(GL_CW)
    box(0.5, turned=True)


@wrong("culled-front")
def a_cube_without_light_with_clockwise_faces_and_culling() -> None:
    scene()
    glDisable(GL_LIGHTING)
    glEnable(GL_CULL_FACE)
    box(0.5, turned=True)


@meant
def clockwise_faces_that_nobody_notices() -> None:
    scene()
    box(0.5, turned=True)


@wrong("normals-opposed")
def clockwise_faces_under_two_sided_lighting() -> None:
    scene()
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    box(0.5, turned=True)


@wrong("normals-away")
def a_cube_whose_normals_point_inside() -> None:
    scene()
    box(0.5, normals=-1)


@wrong("normals-away")
def a_cube_with_one_normal_that_points_inside() -> None:
    scene()
    box(0.5, flipped=0)


@wrong("normals-away")
def a_cube_that_is_turned_inside_out() -> None:
    scene()
    box(0.5, turned=True, normals=-1)


@wrong("normals-away")
def a_display_list_with_normals_that_point_inside() -> None:
    scene()
    glNewList(1, GL_COMPILE)
    box(0.5, normals=-1)
    glEndList()
    glCallList(1)


@wrong("normals-away")
def an_array_of_normals_that_point_to_the_back() -> None:
    lit()
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_NORMAL_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, np.array([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], np.float32))
    glNormalPointer(GL_FLOAT, 0, np.array([[0, 0.6, -0.8]] * 3, np.float32))
    glDrawArrays(GL_TRIANGLES, 0, 3)


@meant
def a_room_that_is_seen_from_inside() -> None:
    scene()
    glEnable(GL_CULL_FACE)
    box(9, turned=True, normals=-1)


@meant
def a_flat_thing_that_is_seen_from_behind() -> None:
    scene()
    glRotatef(180, 0, 1, 0)
    glNormal3f(0, 0, 1)
    glRectf(-0.5, -0.5, 0.5, 0.5)


@meant
def a_curtain_under_two_sided_lighting() -> None:
    scene()
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glRotatef(180, 0, 1, 0)
    glNormal3f(0, 0, 1)
    glRectf(-0.5, -0.5, 0.5, 0.5)


@meant
def a_sky_inside_of_which_the_eye_is() -> None:
    lit()
    view(0.1)
    quadric = gluNewQuadric()
    gluQuadricOrientation(quadric, GLU_INSIDE)
    gluSphere(quadric, 10, 16, 8)


GLU_INSIDE = 100021


@meant
def shapes_of_glut() -> None:
    scene()
    for k, shape in enumerate((lambda: glutSolidSphere(0.4, 40, 40), lambda: glutSolidCube(0.5))):
        glPushMatrix()
        glTranslatef(k - 0.5, 0, 0)
        shape()
        glPopMatrix()
    glutSolidTeapot(0.3)


# ---------------------------------------------------------------- camera


@meant
def a_camera_in_a_matrix_for_textures() -> None:
    """As for shadow maps: projections and cameras in GL_TEXTURE, and to read a matrix back."""
    scene()
    glMatrixMode(GL_TEXTURE)
    gluPerspective(45, 1, 1, 20)
    gluLookAt(1, 2, 3, 0, 0, 0, 0, 1, 0)
    glMatrixMode(GL_MODELVIEW)
    glPushMatrix()
    glLoadIdentity()
    gluPerspective(45, 1, 1, 20)
    glGetFloatv(GL_MODELVIEW_MATRIX)
    glPopMatrix()
    glutSolidCube(1)


@meant
def a_tilted_camera_and_the_shift_of_a_stereo_pair() -> None:
    lit()
    glMatrixMode(GL_PROJECTION)
    glFrustum(-0.3, 0.4, -0.4, 0.4, 1, 20)
    glTranslatef(0.1, 0, 0)
    glMatrixMode(GL_MODELVIEW)
    glRotatef(10, 0, 0, 1)
    gluLookAt(1, 2, 4, 0, 0, 0, 0, 1, 0)
    glutSolidCube(1)


@wrong("camera-in-projection")
def a_camera_of_glTranslate_in_the_projection() -> None:
    lit()
    view()
    glMatrixMode(GL_PROJECTION)
    glTranslatef(0, 0, -4)
    glMatrixMode(GL_MODELVIEW)
    glutSolidCube(1)


@wrong("camera-in-projection")
def one_matrix_for_all() -> None:
    lit()
    glMatrixMode(GL_PROJECTION)
    gluPerspective(45, 1, 1, 20)
    glTranslatef(0, 0, -4)
    product = glGetFloatv(GL_PROJECTION_MATRIX)
    glLoadMatrixf(product)
    glMatrixMode(GL_MODELVIEW)
    glutSolidCube(1)


@meant
def an_overlay_in_two_dimensions() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    view()
    glColor3f(1, 1, 1)
    glTranslatef(0, 0, -4)
    glRectf(-1, -1, 1, 1)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluOrtho2D(0, 100, 0, 100)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glColor3f(1, 0, 0)
    glRectf(10, 10, 90, 90)


@meant
def a_depth_buffer_that_is_fine_enough() -> None:
    scene(0.01)
    glutSolidCube(1)


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


@pytest.mark.parametrize("program", MEANT, ids=lambda program: program.__name__)
def test_what_is_meant_is_no_mistake(program: Callable[[], None], screen: glsim.Offscreen) -> None:
    assert kinds(program) == []


@pytest.mark.parametrize("program", WRONG, ids=lambda program: program.__name__)
def test_variants_of_a_mistake_are_found(program: Callable[[], None], screen: glsim.Offscreen) -> None:
    assert kinds(program) == [WRONG[program]]
