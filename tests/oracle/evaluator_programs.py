"""Evaluators: curves, surfaces, meshes."""

from __future__ import annotations

from functools import partial

import numpy as np

from glsim.gl import *
from tests.drawing import SHINY, camera, lamp, material
from tests.oracle.programs import PROGRAMS, program
from tests.oracle.texture_programs import filters, texels, upload

ARC = [-0.9, -0.6, 0.0, -0.3, 1.6, 0.0, 0.2, -1.8, 0.0, 0.9, 0.7, 0.0]
COLORS = [1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.5]


@program
def evaluator_curve() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glMap1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 4, ARC)
    glEnable(GL_MAP1_VERTEX_3)
    glBegin(GL_LINE_STRIP)
    for k in range(31):
        glEvalCoord1f(k / 30)
    glEnd()


@program
def evaluator_curve_coloured_on_a_grid() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glMap1f(GL_MAP1_VERTEX_3, -1.0, 3.0, 3, 4, ARC)
    glMap1f(GL_MAP1_COLOR_4, -1.0, 3.0, 4, 3, COLORS)
    glEnable(GL_MAP1_VERTEX_3)
    glEnable(GL_MAP1_COLOR_4)
    glMapGrid1f(20, -1.0, 3.0)
    glEvalMesh1(GL_LINE, 0, 20)
    glTranslatef(0, 0.1, 0)
    glPointSize(3)
    glEvalMesh1(GL_POINT, 2, 15)
    glTranslatef(0, 0.1, 0)
    glBegin(GL_LINE_STRIP)
    for k in range(3, 12):
        glEvalPoint1(k)
    glEnd()


PATCH = np.array(
    [[(x, y, 0.6 * np.sin(3 * x) * np.cos(2 * y)) for y in (-1, -0.3, 0.4, 1)] for x in (-1, -0.2, 0.5, 1)]
)


def patch(kind: int = GL_MAP2_VERTEX_3) -> None:
    points = PATCH.astype(np.float32)
    if kind == GL_MAP2_VERTEX_4:
        w = np.array([1.0, 0.7, 1.4, 1.0])[:, None, None] * np.ones((4, 4, 1))
        points = np.concatenate([points * w, w], axis=2).astype(np.float32)
    k = points.shape[2]
    glMap2f(kind, 0.0, 1.0, 4 * k, 4, 0.0, 1.0, k, 4, points)
    glEnable(kind)
    glMapGrid2f(12, 0.0, 1.0, 10, 0.0, 1.0)
    glRotatef(-50, 1, 0, 0)
    glRotatef(30, 0, 0, 1)


for _kind in (GL_MAP2_VERTEX_3, GL_MAP2_VERTEX_4):

    @partial(PROGRAMS.__setitem__, f"evaluator_surface_auto_normal_{_kind.name[8:].lower()}")
    def _surface(kind: int = _kind) -> None:
        camera(3.5)
        lamp()
        material(**SHINY)
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
        glEnable(GL_AUTO_NORMAL)
        glEnable(GL_NORMALIZE)
        patch(kind)
        glEvalMesh2(GL_FILL, 0, 12, 0, 10)


for _mode in (GL_POINT, GL_LINE):

    @partial(PROGRAMS.__setitem__, f"evaluator_surface_as_{_mode.name[3:].lower()}")
    def _mesh(mode: int = _mode) -> None:
        camera(3.5)
        patch()
        glColor3f(0.9, 0.8, 0.2)
        glEvalMesh2(mode, 1, 11, 0, 9)


@program
def evaluator_surface_textured_and_coloured() -> None:
    camera(3.5)
    upload(texels())
    filters()
    glEnable(GL_TEXTURE_2D)
    patch()
    glMap2f(GL_MAP2_TEXTURE_COORD_2, 0, 1, 4, 2, 0, 1, 2, 2, [0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 1.0])
    glMap2f(GL_MAP2_COLOR_4, 0, 1, 8, 2, 0, 1, 4, 2, [1.0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1])
    glEnable(GL_MAP2_TEXTURE_COORD_2)
    glEnable(GL_MAP2_COLOR_4)
    glEvalMesh2(GL_FILL, 0, 12, 0, 10)


@program
def evaluator_surface_by_hand() -> None:
    camera(3.5)
    lamp()
    material(**SHINY)
    glEnable(GL_AUTO_NORMAL)
    patch()
    for j in range(6):
        glBegin(GL_TRIANGLE_STRIP)
        for i in range(9):
            glEvalCoord2f(i / 8, j / 6)
            glEvalCoord2f(i / 8, (j + 1) / 6)
        glEnd()
    glBegin(GL_POINTS)
    glEvalPoint2(3, 4)
    glEnd()


@program
def evaluator_surface_normals_from_a_map() -> None:
    camera(3.5)
    lamp()
    material(**SHINY)
    patch()
    normals = [0.0, 0.3, 1.0, 0.4, 0.0, 0.9, -0.4, 0.1, 0.8, 0.0, -0.5, 0.9]
    glMap2d(GL_MAP2_NORMAL, 0, 1, 6, 2, 0, 1, 3, 2, normals)
    glEnable(GL_MAP2_NORMAL)
    glEvalMesh2(GL_FILL, 0, 12, 0, 10)


@program
def evaluator_in_a_list() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glNewList(1, GL_COMPILE)
    glMap1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 4, ARC)
    glEnable(GL_MAP1_VERTEX_3)
    glBegin(GL_LINE_STRIP)
    for k in range(11):
        glEvalCoord1f(k / 10)
    glEnd()
    glEndList()
    glCallList(1)
    glColor3f(1, 0, 0)
    glTranslatef(0, 0.3, 0)
    glCallList(1)
