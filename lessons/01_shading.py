"""Lesson 1: where is the illumination equation evaluated?

Run it:     python lessons/01_shading.py
You see:    01_shading.png, one sphere of few quads, three times.
            Left, GL_FLAT: once per quad, every quad has one colour.
            Middle, GL_SMOOTH (Gouraud): at the vertices, colours are interpolated; the highlight is dull and has
            corners, because no vertex lies where it is brightest.
            Right, GL_PHONG_WIN (Phong): at every pixel, with the interpolated normal; the highlight is round.

            The silhouette stays a polygon in all three: shading changes colours, not geometry.
"""

import math

import glsim
from glsim.gl import *

SLICES, STACKS = 12, 8


def point(i, j):
    """Point of the unit sphere on stack i and slice j; it is its own normal."""
    theta, phi = math.pi * i / STACKS, 2 * math.pi * j / SLICES
    return math.sin(theta) * math.sin(phi), math.cos(theta), math.sin(theta) * math.cos(phi)


def sphere():
    glBegin(GL_QUADS)
    for i in range(STACKS):
        for j in range(SLICES):
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                x, y, z = point(i + a, j + b)
                glNormal3f(x, y, z)
                glVertex3f(x, y, z)
    glEnd()


screen = glsim.offscreen(900, 300)
glClearColor(0.13, 0.14, 0.17, 1.0)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glLightfv(GL_LIGHT0, GL_POSITION, [-2.0, 3.0, 4.0, 1.0])
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.7, 0.2, 0.15, 1.0])  # k_a and k_d
glMaterialfv(GL_FRONT, GL_SPECULAR, [0.7, 0.7, 0.7, 1.0])  # k_s
glMaterialf(GL_FRONT, GL_SHININESS, 40.0)  # n

glMatrixMode(GL_PROJECTION)
glFrustum(-0.36, 0.36, -0.36, 0.36, 1.0, 10.0)
glMatrixMode(GL_MODELVIEW)
glTranslatef(0.0, 0.0, -3.3)
for column, mode in enumerate((GL_FLAT, GL_SMOOTH, GL_PHONG_WIN)):
    glViewport(300 * column, 0, 300, 300)
    glShadeModel(mode)
    sphere()

screen.save("01_shading.png")
