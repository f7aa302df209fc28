"""Programs with one mistake each, and the same programs mended: ``program(mended)``."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidCube
from tests.drawing import lit

Program = Callable[[bool], None]
BAD: dict[str, Program] = {}


def mistake(kind: str) -> Callable[[Program], Program]:
    def note(program: Program) -> Program:
        assert kind not in BAD
        BAD[kind] = program
        return program

    return note


@mistake("normals-scaled")
def scaled(mended: bool) -> None:
    lit()
    glScalef(0.5, 0.5, 0.5)
    if mended:
        glEnable(GL_NORMALIZE)
    glutSolidCube(1)


@mistake("normals-not-unit")
def long_normals(mended: bool) -> None:
    lit()
    glNormal3f(0, 0, 1 if mended else 3)
    glRectf(-1, -1, 1, 1)


@mistake("surplus")
def alpha_too_many(mended: bool) -> None:
    glColor3f(1, 1, 0, *(() if mended else (1,)))
    glRectf(-1, -1, 1, 1)


@mistake("light-before-camera")
def headlight(mended: bool) -> None:
    lit()
    glLoadIdentity()
    if not mended:
        glLightfv(GL_LIGHT0, GL_POSITION, [1, 2, 3, 1])
    gluLookAt(3, 3, 3, 0, 0, 0, 0, 1, 0)
    if mended:
        glLightfv(GL_LIGHT0, GL_POSITION, [1, 2, 3, 1])
    glutSolidCube(1)


@mistake("lighting-without-normals")
def no_normals(mended: bool) -> None:
    lit()
    glBegin(GL_TRIANGLES)
    for z in (0.0, 0.8, -0.8):
        if mended:
            glNormal3f(0.6, 0.0, 0.8)
        glVertex3f(z, 0.5 * z * z, z)
    glEnd()


@mistake("color-material-order")
def order(mended: bool) -> None:
    lit()
    if mended:
        glColorMaterial(GL_FRONT, GL_SPECULAR)
        glEnable(GL_COLOR_MATERIAL)
    else:
        glEnable(GL_COLOR_MATERIAL)
        glColorMaterial(GL_FRONT, GL_SPECULAR)
    glutSolidCube(1)


@mistake("highlight-lost")
def coarse(mended: bool) -> None:
    """A lamp close to the middle of a square."""
    lit()
    glLightfv(GL_LIGHT0, GL_POSITION, [0, 0, 0.5, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [1, 1, 1, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, 60)
    glNormal3f(0, 0, 1)
    count = 30 if mended else 1
    for i in range(count):
        for j in range(count):
            x, y = 2 * i / count - 1, 2 * j / count - 1
            glRectf(x, y, x + 2 / count, y + 2 / count)


@mistake("near-plane")
def near(mended: bool) -> None:
    glMatrixMode(GL_PROJECTION)
    gluPerspective(60, 1, 0.5 if mended else 0, 10)
    glMatrixMode(GL_MODELVIEW)
    glTranslatef(0, 0, -3)
    glRectf(-1, -1, 1, 1)


@mistake("radians")
def radians(mended: bool) -> None:
    glRotatef(30 if mended else math.radians(30), 0, 0, 1)
    glRectf(-0.5, -0.5, 0.5, 0.5)


@mistake("matrix-stack")
def unbalanced(mended: bool) -> None:
    glPushMatrix()
    glRectf(-0.5, -0.5, 0.5, 0.5)
    if mended:
        glPopMatrix()


@mistake("depth-not-cleared")
def stale(mended: bool) -> None:
    glClear(GL_COLOR_BUFFER_BIT | (GL_DEPTH_BUFFER_BIT if mended else 0))
    glEnable(GL_DEPTH_TEST)
    glRectf(-0.5, -0.5, 0.5, 0.5)


@mistake("normals-zero")
def no_direction(mended: bool) -> None:
    lit()
    glNormal3f(0, 0, 1 if mended else 0)
    glRectf(-0.5, -0.5, 0.5, 0.5)


@mistake("up-along-view")
def from_above(mended: bool) -> None:
    gluLookAt(0, 0.5, 0, 0, 0, 0, *((0, 0, -1) if mended else (0, 1, 0)))
    lit()
    glutSolidCube(0.5)


@mistake("position-of-three")
def three_numbers(mended: bool) -> None:
    lit()
    glLightfv(GL_LIGHT0, GL_POSITION, (1, 2, 3, 1) if mended else (1, 2, 3))
    glutSolidCube(0.5)


@mistake("projection-in-modelview")
def bent(mended: bool) -> None:
    lit()
    if mended:
        glMatrixMode(GL_PROJECTION)
    gluPerspective(45, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glTranslatef(0, 0, -4)
    glutSolidCube(1)


# ---------------------------------------------------------------- camera


def view(near: float = 1.0, far: float = 20.0) -> None:
    glMatrixMode(GL_PROJECTION)
    gluPerspective(45, 1, near, far)
    glMatrixMode(GL_MODELVIEW)


@mistake("camera-in-projection")
def camera_in_projection(mended: bool) -> None:
    lit()
    view()
    glMatrixMode(GL_MODELVIEW if mended else GL_PROJECTION)
    gluLookAt(2, 2, 4, 0, 0, 0, 0, 1, 0)
    glMatrixMode(GL_MODELVIEW)
    glutSolidCube(1)


@mistake("rotation-before-camera")
def rotation_before_camera(mended: bool) -> None:
    lit()
    view()
    if not mended:
        glRotatef(20, 0, 1, 0)
    gluLookAt(2, 2, 4, 0, 0, 0, 0, 1, 0)
    if mended:
        glRotatef(20, 0, 1, 0)
    glutSolidCube(1)


@mistake("camera-again")
def camera_again(mended: bool) -> None:
    """Two frames."""
    view()
    for _ in range(2):
        lit()
        if mended:
            glLoadIdentity()
        gluLookAt(2, 2, 4, 0, 0, 0, 0, 1, 0)
        glutSolidCube(0.5)


@mistake("perspective-again")
def perspective_again(mended: bool) -> None:
    """The window gets another size."""
    for _ in range(2):
        glMatrixMode(GL_PROJECTION)
        if mended:
            glLoadIdentity()
        gluPerspective(45, 1, 1, 20)
        glMatrixMode(GL_MODELVIEW)
        glLoadIdentity()
        lit()
        glTranslatef(0, 0, -4)
        glRectf(-1, -1, 1, 1)


@mistake("coarse-depth")
def coarse_depth(mended: bool) -> None:
    lit()
    view(0.1 if mended else 1e-4, 1000)
    glTranslatef(0, 0, -5)
    glutSolidCube(1)


# ---------------------------------------------------------------- light


@mistake("no-light")
def no_light(mended: bool) -> None:
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    if mended:
        glEnable(GL_LIGHT0)
    glutSolidCube(1)


@mistake("black-light")
def black_light(mended: bool) -> None:
    lit()
    glEnable(GL_LIGHT1)
    glLightfv(GL_LIGHT1, GL_POSITION, (1, 1, 1, 0))
    if mended:
        glLightfv(GL_LIGHT1, GL_DIFFUSE, (1, 1, 1, 1))
    glutSolidCube(1)


@mistake("no-k_s")
def no_specular(mended: bool) -> None:
    lit()
    glLightfv(GL_LIGHT0, GL_SPECULAR, (1, 1, 1, 1))
    if mended:
        glMaterialfv(GL_FRONT, GL_SPECULAR, (1, 1, 1, 1))
    glutSolidCube(1)


# ---------------------------------------------------------------- colours


@mistake("color-range")
def bytes_as_floats(mended: bool) -> None:
    glColor3f(*((1, 0.5, 0) if mended else (255, 128, 0)))
    glRectf(-1, -1, 1, 1)


@mistake("color-ignored")
def ignored(mended: bool) -> None:
    lit()
    if mended:
        glEnable(GL_COLOR_MATERIAL)
    glColor3f(1, 0, 0)
    glutSolidCube(1)


# ---------------------------------------------------------------- texture


def checkered(min_filter: bool = True) -> None:
    glEnable(GL_TEXTURE_2D)
    glBindTexture(GL_TEXTURE_2D, glGenTextures(1))
    if min_filter:
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
    texels = np.random.default_rng(1).integers(0, 255, (8, 8, 3), np.uint8)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, texels)


def textured_square() -> None:
    glBegin(GL_QUADS)
    glNormal3f(0.6, 0, 0.8)
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        glTexCoord2f(x, y)
        glVertex2f(x - 0.5, y - 0.5)
    glEnd()


@mistake("incomplete-texture")
def incomplete(mended: bool) -> None:
    checkered(mended)
    textured_square()


@mistake("texture-replaces-light")
def replaced(mended: bool) -> None:
    lit()
    glMatrixMode(GL_PROJECTION)
    glOrtho(-1, 1, -1, 1, 1, 3)
    glMatrixMode(GL_MODELVIEW)
    glTranslatef(0, 0, -2)
    checkered()
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE if mended else GL_REPLACE)
    textured_square()


# ---------------------------------------------------------------- winding and normals


@mistake("culled-front")
def clockwise(mended: bool) -> None:
    glEnable(GL_CULL_FACE)
    corners = [(-0.5, -0.5), (0.5, -0.5), (0, 0.5)]
    glBegin(GL_TRIANGLES)
    for x, y in corners if mended else corners[::-1]:
        glVertex2f(x, y)
    glEnd()


@mistake("normals-away")
def away(mended: bool) -> None:
    lit()
    glNormal3f(0, 0, 1 if mended else -1)
    glRectf(-0.5, -0.5, 0.5, 0.5)


@mistake("normals-opposed")
def opposed(mended: bool) -> None:
    lit()
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glNormal3f(0, 0, 1)
    glRectf(-0.5, -0.5, *((0.5, 0.5) if mended else (-1.0, 0.5)))


# ---------------------------------------------------------------- depth


@mistake("no-depth-test")
def overlapping(mended: bool) -> None:
    if mended:
        glEnable(GL_DEPTH_TEST)
    for z, color in ((0.5, (1, 0, 0)), (-0.5, (0, 1, 0))):  # the near one first
        glColor3f(*color)
        glBegin(GL_QUADS)
        for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
            glVertex3f(x, y, -z)
        glEnd()
