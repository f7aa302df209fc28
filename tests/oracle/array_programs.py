"""Entry paths: vertex arrays, the variants of the vertex commands, incomplete primitives."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from glsim.gl import *
from glsim.gl import GLfloat
from tests.drawing import SHINY, camera, lamp, material
from tests.oracle.programs import MODES, program

# ---------------------------------------------------------------- entry paths


def lit_arrays(draw: Callable[[np.ndarray], None]) -> None:
    camera()
    lamp()
    material(**SHINY)
    theta, phi = np.meshgrid(np.linspace(0, np.pi, 15), np.linspace(0, 2 * np.pi, 21), indexing="ij")
    points = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], 2).reshape(-1, 3)
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_NORMAL_ARRAY)
    draw(points)


def grid_indices(rows: int = 14, columns: int = 20, dtype: str = "u4") -> np.ndarray:
    """Two triangles for each cell of a grid of points."""
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    a = (i * (columns + 1) + j).ravel()
    b = a + columns + 1
    return np.stack([a, b, b + 1, a, b + 1, a + 1], 1).astype(dtype).ravel()


@program
def arrays_of_doubles() -> None:
    def draw(points: np.ndarray) -> None:
        glVertexPointer(3, GL_DOUBLE, 0, points)
        glNormalPointer(GL_DOUBLE, 0, points)
        indices = grid_indices()
        glDrawElements(GL_TRIANGLES, len(indices), GL_UNSIGNED_INT, indices)

    lit_arrays(draw)


@program
def arrays_with_stride_and_shorts_as_normals() -> None:
    def draw(points: np.ndarray) -> None:
        mixed = np.zeros(len(points), [("p", "f4", 3), ("n", "i2", 4)])
        mixed["p"], mixed["n"][:, :3] = points, np.round(points * 32767)
        memory = mixed.tobytes()
        glVertexPointer(3, GL_FLOAT, 20, memory)
        glNormalPointer(GL_SHORT, 20, memory[12:])
        indices = grid_indices(dtype="u2")
        glDrawRangeElements(GL_TRIANGLES, 0, len(points) - 1, len(indices), GL_UNSIGNED_SHORT, indices)

    lit_arrays(draw)


@program
def arrays_interleaved() -> None:
    def draw(points: np.ndarray) -> None:
        glInterleavedArrays(GL_N3F_V3F, 0, np.concatenate([points, points], 1).astype("f4"))
        indices = grid_indices()
        glDrawElements(GL_TRIANGLES, len(indices), GL_UNSIGNED_INT, indices)

    lit_arrays(draw)


@program
def arrays_by_element() -> None:
    def draw(points: np.ndarray) -> None:
        glVertexPointer(3, GL_FLOAT, 0, points.astype("f4"))
        glNormalPointer(GL_FLOAT, 0, points.astype("f4"))
        glBegin(GL_TRIANGLES)
        for i in grid_indices():
            glArrayElement(int(i))
        glEnd()

    lit_arrays(draw)


@program
def arrays_homogeneous_and_colors_of_bytes() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    points = np.array([(-1.2, -1, 0, 2), (0.9, -0.7, 0, 1), (0.3, 0.4, 0, 0.5), (-0.5, 0.7, 0, 1)], "f4")
    colors = np.array([(255, 0, 0, 255), (0, 200, 30, 255), (90, 0, 255, 255), (255, 255, 0, 255)], "u1")
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glVertexPointer(4, GL_FLOAT, 0, points)
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors)
    glDrawArrays(GL_POLYGON, 0, 4)


@program
def suffix_variants() -> None:
    """One triangle for each kind of colour and vertex call."""
    glClear(GL_COLOR_BUFFER_BIT)
    colors = (
        (glColor3b, (127, -20, 60)), (glColor3s, (32767, 10000, -5)), (glColor3i, (2**31 - 1, 2**30, 0)),
        (glColor3f, (0.5, 0.25, 1.0)), (glColor3d, (0.1, 0.9, 0.3)), (glColor3ub, (255, 128, 7)),
        (glColor3us, (65535, 300, 40000)), (glColor3ui, (2**32 - 1, 2**31, 2**30)),
        (glColor4f, (0.5, 0.25, 1.0, 0.5)), (glColor4ub, (25, 128, 200, 255)),
    )  # fmt: skip
    vertices = (glVertex2i, glVertex2f, glVertex2d, glVertex2s)
    glOrtho(0, 40, 0, 40, -1, 1)
    for k, (color, values) in enumerate(colors):
        color(*values)
        vertex = vertices[k % 4]
        x, y = 2 + 12 * (k % 3), 1 + 9 * (k // 3)
        glBegin(GL_TRIANGLES)
        vertex(x, y)
        vertex(x + 10, y)
        vertex(x + 4, y + 7)
        glEnd()


@program
def vector_variants() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glBegin(GL_TRIANGLES)
    glColor3ubv([200, 100, 50])
    glVertex3fv((-0.9, -0.9, 0.0))
    glColor4fv(np.array([0.1, 0.8, 0.3, 1.0], "f4"))
    glVertex2dv([0.8, -0.7])
    glColor3dv((GLfloat * 3)(0.9, 0.1, 0.9))
    glVertex4f(0.2, 1.2, 0.0, 1.5)
    glEnd()


@program
def rectangles() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glColor3f(0.9, 0.5, 0.1)
    glRectf(-0.83, -0.71, 0.11, 0.23)
    glColor3f(0.1, 0.6, 0.8)
    glRectd(0.3, 0.3, 0.7, 0.9)
    glRectfv([-0.5, 0.5], [-0.2, 0.8])


@program
def incomplete_primitives() -> None:
    """Vertices that make no whole primitive are ignored."""
    glClear(GL_COLOR_BUFFER_BIT)
    for k, mode in enumerate(MODES):
        for count in (2, 3, 5, 7):  # with 0 or 1 Mesa 22.3.6 drops what follows; see gl/test_vertex.py
            glBegin(mode)
            for j in range(count):
                x = -0.95 + 0.19 * k + 0.08 * (j % 2)
                glColor3f(0.3 + 0.1 * j, 1 - 0.1 * k, 0.4)
                glVertex2f(x, -0.9 + count * 0.23 + 0.1 * (j // 2) + 0.0113 * j)
            glEnd()
