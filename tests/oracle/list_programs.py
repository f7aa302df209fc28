"""Display lists and attribute stacks."""

from __future__ import annotations

import math

import numpy as np

from glsim.gl import *
from tests.drawing import SHINY, ball, camera, lamp, material, wheel
from tests.oracle.programs import program


@program
def list_of_geometry() -> None:
    camera()
    lamp()
    material(**SHINY)
    glNewList(1, GL_COMPILE)
    ball(12, 8)
    glEndList()
    glCallList(1)


@program
def list_compiled_and_executed() -> None:
    camera()
    lamp()
    glNewList(3, GL_COMPILE_AND_EXECUTE)
    glColor3f(0.9, 0.2, 0.2)
    glTranslatef(-0.6, 0, 0)
    ball(10, 6, 0.5)
    glEndList()
    glTranslatef(1.2, 0, 0)
    glCallList(3)


@program
def list_whose_vertices_come_again() -> None:
    """The same corners in several triangles, some before the list sets a fog coordinate; filled, then as edges."""
    camera()
    glEnable(GL_FOG)
    glFogi(GL_FOG_MODE, GL_LINEAR)
    glFogfv(GL_FOG_COLOR, (0.1, 0.2, 0.6, 1.0))
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE)
    fan = [(0.0, 0.0), (0.5, 0.0), (0.3, 0.4), (-0.3, 0.4), (-0.5, 0.0), (-0.3, -0.4), (0.3, -0.4), (0.5, 0.0)]
    glNewList(1, GL_COMPILE)
    glBegin(GL_TRIANGLES)
    for number, corners in enumerate(zip(fan[:1] * 6, fan[1:], fan[2:], strict=False)):
        if number >= 3:
            glFogCoordf(0.5 if number % 2 else 0.1)
        for corner in corners:
            glVertex2f(*corner)
    glEnd()
    glEndList()
    for k, mode in enumerate((GL_FILL, GL_LINE)):
        glPolygonMode(GL_FRONT_AND_BACK, mode)
        glColor3f(1.0, 0.8 - 0.6 * k, 0.1)
        glFogCoordf(0.3)
        glPushMatrix()
        glTranslatef(1.1 * k - 0.55, 0, 0)
        glCallList(1)
        glPopMatrix()


@program
def list_takes_the_callers_values() -> None:
    """Colour and normal that the list does not set are those at the call; what it sets stays set."""
    camera()
    glNewList(1, GL_COMPILE)
    glBegin(GL_TRIANGLES)
    glVertex2f(-0.3, -0.3)
    glVertex2f(0.3, -0.3)
    glColor3f(1, 1, 0)
    glVertex2f(0, 0.4)
    glEnd()
    glEndList()
    for k, color in enumerate(((1, 0, 0), (0, 1, 0), (0.2, 0.3, 1))):
        glPushMatrix()
        glTranslatef(0.7 * k - 0.7, 0.5, 0)
        glColor3fv(color)
        glCallList(1)
        glTranslatef(0, -1, 0)
        glCallList(1)
        glPopMatrix()


@program
def list_with_state_leaks_it() -> None:
    camera()
    glNewList(1, GL_COMPILE)
    lamp()
    material(**SHINY)
    glShadeModel(GL_FLAT)
    glRotatef(30, 1, 1, 0)
    glEndList()
    glCallList(1)
    ball(10, 6)


@program
def lists_nested_and_resolved_late() -> None:
    camera()
    glNewList(1, GL_COMPILE)
    glColor3f(0.2, 0.8, 0.3)
    glCallList(2)
    glTranslatef(0.5, 0.2, 0)
    glCallList(2)
    glCallList(77)
    glEndList()
    glNewList(2, GL_COMPILE)
    glRectf(-0.2, -0.2, 0.2, 0.2)
    glEndList()
    glCallList(1)
    glNewList(2, GL_COMPILE)
    glBegin(GL_TRIANGLES)
    glVertex2f(-0.2, -0.2)
    glVertex2f(0.2, -0.2)
    glVertex2f(0, 0.3)
    glEnd()
    glEndList()
    glTranslatef(-1.3, -0.6, 0)
    glCallList(1)


@program
def list_inside_a_primitive() -> None:
    """A list called between glBegin and glEnd."""
    camera()
    glNewList(1, GL_COMPILE)
    glColor3f(1, 0.5, 0)
    glVertex2f(0.1, 0.1)
    glVertex2f(0.8, 0.2)
    glEndList()
    glBegin(GL_TRIANGLES)
    glCallList(1)
    glVertex2f(0.3, 0.9)
    glEnd()


@program
def list_of_many_kinds_of_primitives() -> None:
    camera()
    lamp()
    glEnable(GL_COLOR_MATERIAL)
    glNewList(1, GL_COMPILE)
    for k, mode in enumerate((GL_QUADS, GL_TRIANGLES, GL_POLYGON, GL_LINE_LOOP, GL_POINTS, GL_TRIANGLE_FAN, GL_LINES)):
        glBegin(mode)
        glNormal3f(0.2, 0.1 * k, 0.9)
        for j in range(12 if mode in (GL_QUADS, GL_TRIANGLES, GL_LINES, GL_POINTS) else 5):
            a = j * 2 * math.pi / 5
            glColor3f(0.4, 0.1 * k, 1 - 0.1 * k)
            glVertex3f(0.3 * k - 0.9 + 0.13 * math.cos(a), 0.2 * (j // 4) + 0.2 * math.sin(a), 0)
        glEnd()
    glEndList()
    for shade in (GL_SMOOTH, GL_FLAT):
        glShadeModel(shade)
        glCallList(1)
        glTranslatef(0, -0.8, 0)


@program
def list_with_materials_inside() -> None:
    camera()
    lamp()
    glNewList(1, GL_COMPILE)
    wheel(lambda k: glMaterialfv(GL_FRONT, GL_DIFFUSE, [k / 25, 0.5, 1 - k / 25, 1]))
    glEndList()
    glCallList(1)


@program
def list_copies_arrays() -> None:
    camera()
    points = np.array([(-0.8, -0.8, 0), (0.8, -0.6, 0), (0.1, 0.9, 0)], "f4")
    colors = np.array([(255, 0, 0), (0, 255, 0), (0, 0, 255)], "u1")
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, points)
    glColorPointer(3, GL_UNSIGNED_BYTE, 0, colors)
    glNewList(1, GL_COMPILE)
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, np.array([2, 0, 1], "u1"))
    glEndList()
    points[:] = 0.0
    glDisableClientState(GL_COLOR_ARRAY)
    glDisableClientState(GL_VERTEX_ARRAY)
    glCallList(1)


@program
def lists_by_number() -> None:
    """glListBase and glCallLists, as text is drawn."""
    camera()
    for k in range(4):
        glNewList(100 + k, GL_COMPILE)
        glColor3f(0.3 * k, 1 - 0.2 * k, 0.5)
        glRectf(-0.15, -0.1 - 0.1 * k, 0.15, 0.1 + 0.1 * k)
        glTranslatef(0.4, 0.0, 0)
        glEndList()
    glTranslatef(-0.8, 0.3, 0)
    glListBase(100)
    glCallLists(3, GL_UNSIGNED_BYTE, np.array([0, 2, 1], "u1"))
    glListBase(0)
    glTranslatef(-1.2, -0.7, 0)
    glCallLists(2, GL_2_BYTES, np.array([0, 103, 0, 101], "u1"))
    glCallLists(1, GL_FLOAT, np.array([102.0], "f4"))


@program
def many_calls_of_one_list() -> None:
    """More instances than a uniform block has rows."""
    camera(6.0)
    lamp()
    glNewList(1, GL_COMPILE)
    glBegin(GL_QUADS)
    glNormal3f(0, 0, 1)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex2f(0.1 * x, 0.1 * y)
    glEnd()
    glEndList()
    for k in range(400):
        glPushMatrix()
        glTranslatef(k % 20 * 0.22 - 2.1, k // 20 * 0.22 - 2.1, 0)
        glRotatef(k, 1, 1, 0)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [k % 20 / 20, k // 20 / 20, 0.5, 1])
        glCallList(1)
        glPopMatrix()


@program
def attributes_pushed_and_popped() -> None:
    camera()
    lamp()
    material(**SHINY)
    glPushAttrib(GL_ALL_ATTRIB_BITS)
    glShadeModel(GL_FLAT)
    glColor3f(1, 0, 0)
    glDisable(GL_LIGHTING)
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0, 1, 0, 1])
    glViewport(0, 0, 64, 64)
    glCullFace(GL_FRONT)
    glEnable(GL_CULL_FACE)
    glDepthFunc(GL_ALWAYS)
    glMatrixMode(GL_PROJECTION)
    ball(10, 6)
    glPopAttrib()
    glTranslatef(0.2, 0.2, 0)
    ball(10, 6, mode=GL_TRIANGLES)


@program
def enables_pushed_and_popped() -> None:
    camera()
    lamp()
    glPushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT)
    glDisable(GL_LIGHTING)
    glEnable(GL_CULL_FACE)
    glColor3f(0.9, 0.6, 0.1)
    glRectf(-1, -1, 0, 0)
    glPopAttrib()
    glNormal3f(0.3, 0.3, 0.9)
    glRectf(0, 0, 1, 1)


@program
def lighting_pushed_and_popped() -> None:
    camera()
    lamp()
    material(**SHINY)
    glPushAttrib(GL_LIGHTING_BIT)
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [0, 0, 1, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0, 1, 0, 1])
    glTranslatef(-0.5, 0, 0)
    ball(10, 6, 0.5)
    glPopAttrib()
    glTranslatef(1.0, 0, 0)
    ball(10, 6, 0.5)
