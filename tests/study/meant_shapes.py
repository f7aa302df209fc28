"""Programs that look like a mistake and are meant, and variants of mistakes: winding, normals, camera."""

from __future__ import annotations

import numpy as np

from glsim.gl import *
from glsim.glu import gluLookAt, gluNewQuadric, gluOrtho2D, gluPerspective, gluQuadricOrientation, gluSphere
from glsim.glut import glutSolidCube, glutSolidSphere
from glsim.glut.teaset import glutSolidTeapot
from tests.drawing import lit
from tests.study.meant import box, meant, scene, wrong
from tests.study.planted import view

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


@wrong("projection-in-modelview")
def a_parallel_projection_in_the_modelview() -> None:
    lit()
    glOrtho(-1, 1, -1, 1, -1, 1)
    glEnable(GL_NORMALIZE)
    glutSolidCube(0.5)


@wrong("projection-in-modelview")
def a_perspective_in_the_modelview_without_light() -> None:
    gluPerspective(45, 1, 1, 20)
    glTranslatef(0, 0, -4)
    glRectf(-1, -1, 1, 1)
