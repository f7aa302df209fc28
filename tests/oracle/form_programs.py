"""PyOpenGL's short forms of commands, and offsets into buffer objects: the replay passes what the C functions want."""

from __future__ import annotations

import ctypes

import numpy as np

from glsim.gl import *
from tests.oracle.programs import program

SURFACE = [[(-0.9 + 0.6 * i, -0.9 + 0.6 * j, 0.0) for j in range(4)] for i in range(4)]
SURFACE[1][2] = (0.2, 0.6, 0.0)
CURVE = [(-0.9, 0.9, 0.0), (-0.3, -0.9, 0.0), (0.4, 0.9, 0.0), (0.9, -0.5, 0.0)]
COLORS = [[(0.2, 0.4, 1.0, 1.0), (1.0, 0.3, 0.1, 1.0)], [(0.1, 0.9, 0.2, 1.0), (1.0, 1.0, 0.2, 1.0)]]


@program
def maps_of_nested_lists() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 0, 1, SURFACE)
    glMap2d(GL_MAP2_COLOR_4, 0, 1, 0, 1, np.array(COLORS))
    glEnable(GL_MAP2_VERTEX_3)
    glEnable(GL_MAP2_COLOR_4)
    glMapGrid2f(8, 0, 1, 8, 0, 1)
    glEvalMesh2(GL_FILL, 0, 8, 0, 8)
    glColor3f(1, 1, 1)
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, CURVE)
    glEnable(GL_MAP1_VERTEX_3)
    glMapGrid1f(20, 0, 1)
    glEvalMesh1(GL_POINT, 0, 20)


@program
def offsets_into_buffers() -> None:
    """Interleaved vertices and indices of 16 bits, each after a header of its own."""
    glClear(GL_COLOR_BUFFER_BIT)
    vertices = np.array([(x, y, r, g, 0.5) for x, y, r, g in (
        (-0.8, -0.8, 1, 0), (0.8, -0.8, 0, 1), (0.8, 0.8, 1, 1), (-0.8, 0.8, 0, 0))], np.float32)  # fmt: skip
    glBindBuffer(GL_ARRAY_BUFFER, 1)
    glBufferData(GL_ARRAY_BUFFER, 8 + vertices.nbytes, None, GL_STATIC_DRAW)
    glBufferSubData(GL_ARRAY_BUFFER, 8, vertices)
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 2)
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, np.array([9, 0, 1, 2, 0, 2, 3], np.uint16), GL_STATIC_DRAW)
    glVertexPointer(2, GL_FLOAT, 20, ctypes.c_void_p(8))
    glColorPointer(3, GL_FLOAT, 20, ctypes.c_void_p(16))
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, ctypes.c_void_p(2))
    glDisableClientState(GL_VERTEX_ARRAY)
    glDisableClientState(GL_COLOR_ARRAY)
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0)
    glBindBuffer(GL_ARRAY_BUFFER, 0)
    glDeleteBuffers([1, 2])


@program
def short_forms_of_names_and_tables() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    for k in range(3):
        glNewList(65 + k, GL_COMPILE)
        glRectf(-0.9 + 0.6 * k, -0.8, -0.4 + 0.6 * k, 0.2)
        glEndList()
    glColor3f(0.9, 0.6, 0.2)
    glCallLists("AC")
    glColor3f(0.2, 0.6, 0.9)
    glCallLists([66])
    glPixelMapfv(GL_PIXEL_MAP_G_TO_G, [1.0, 0.5])
    glPixelZoom(20, 20)
    glRasterPos2f(-0.8, 0.4)
    glDrawPixels(2, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, np.array([0xF800, 0x07E0], np.uint16))
    glPolygonStipple(np.indices((32, 32)).sum(axis=0) // 4 % 2)
    glEnable(GL_POLYGON_STIPPLE)
    glRectf(0.1, 0.3, 0.9, 0.9)
    glDisable(GL_POLYGON_STIPPLE)
    glBindTexture(GL_TEXTURE_2D, 3)
    glDeleteTextures([3])


@program
def several_primitives_at_once() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnableClientState(GL_VERTEX_ARRAY)
    points = [(0.25 * k - 0.9, 0.7 * (-1) ** k) for k in range(8)]
    glVertexPointer(2, GL_FLOAT, 0, np.array(points, np.float32))
    glColor3f(0.9, 0.6, 0.2)
    glMultiDrawArrays(GL_TRIANGLES, [0, 4], [3, 3], 2)
    glColor3f(0.2, 0.6, 0.9)
    glMultiDrawElements(GL_LINE_STRIP, [2, 3], GL_UNSIGNED_INT, [np.array([0, 7]), np.array([1, 3, 6])], 2)
    glDisableClientState(GL_VERTEX_ARRAY)
