"""Materials that change, and glColorMaterial."""

from __future__ import annotations

import math
from functools import partial

from glsim.gl import *
from tests.drawing import SHINY, ball, camera, lamp, material, wheel
from tests.oracle.light_programs import bowl
from tests.oracle.programs import PROGRAMS, program


def material_inside(k: int) -> None:
    if k % 4 == 0:
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [k / 25, 1 - k / 25, 0.5, 1.0])
    if k % 6 == 0:
        glMaterialf(GL_FRONT, GL_SHININESS, 5.0 + k)


for _shade in (GL_FLAT, GL_SMOOTH):

    @partial(PROGRAMS.__setitem__, f"material_changes_inside_begin_{_shade.name[3:].lower()}")
    def _material_changes(shade: int = _shade) -> None:
        glShadeModel(shade)
        camera()
        lamp()
        material(**SHINY)
        wheel(material_inside)


@program
def material_changes_in_quads() -> None:
    camera()
    lamp()
    glBegin(GL_QUADS)
    glNormal3f(0, 0, 1)
    for k in range(16):
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [k % 4 / 3, k // 4 / 3, 0.4, 1.0])
        x, y = k % 4 / 2 - 1, k // 4 / 2 - 1
        for dx, dy in ((0, 0), (0.45, 0), (0.45, 0.45), (0, 0.45)):
            glVertex2f(x + dx, y + dy)
    glEnd()


@program
def material_at_every_vertex() -> None:
    """More materials in one glBegin than a uniform block has rows."""
    camera()
    lamp()
    glBegin(GL_TRIANGLE_FAN)
    glNormal3f(0, 0, 1)
    glMaterialfv(GL_FRONT, GL_EMISSION, [0.3, 0.1, 0.2, 1.0])
    glVertex3f(0, 0, 0)
    for k in range(301):
        a = k * math.pi / 150
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [k / 301, 1 - k / 301, k % 10 / 10, 1.0])
        glVertex3f(math.cos(a), math.sin(a), 0)
    glEnd()


COLOR_MATERIALS = (GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION)
for _mode in COLOR_MATERIALS:

    @partial(PROGRAMS.__setitem__, f"color_material_{_mode.name[3:].lower()}")
    def _color_material(mode: int = _mode) -> None:
        camera()
        lamp(ambient=(0.3, 0.3, 0.3, 1))
        material(**SHINY)
        glColorMaterial(GL_FRONT, mode)
        glEnable(GL_COLOR_MATERIAL)
        wheel(lambda k: glColor3f(k / 25, 1 - k / 25, 0.5))


@program
def color_material_back_only() -> None:
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glColorMaterial(GL_BACK, GL_DIFFUSE)
    glColor3f(0.9, 0.8, 0.1)
    glEnable(GL_COLOR_MATERIAL)
    bowl()


@program
def color_material_keeps_the_last_color() -> None:
    camera()
    lamp()
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(0.1, 0.9, 0.3)
    glDisable(GL_COLOR_MATERIAL)
    glColor3f(1.0, 0.0, 0.0)
    ball()


@program
def color_material_takes_the_color_at_once() -> None:
    camera()
    lamp()
    glColor3f(0.9, 0.2, 0.8)
    glEnable(GL_COLOR_MATERIAL)
    ball()


@program
def integer_parameters() -> None:
    camera()
    lamp()
    most = 2**31 - 1
    glLightiv(GL_LIGHT0, GL_DIFFUSE, [most, most // 2, most // 4, most])
    glLightiv(GL_LIGHT0, GL_POSITION, [1, 2, 1, 1])
    glMaterialiv(GL_FRONT, GL_SPECULAR, [most // 3, most, most // 2, most])
    glMateriali(GL_FRONT, GL_SHININESS, 12)
    ball()
