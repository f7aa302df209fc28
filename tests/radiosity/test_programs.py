"""Which side of a program's polygons reflects, and which of them are one smooth surface."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from glsim import radiosity
from glsim.gl import *
from glsim.glut import glutSolidCube, glutSolidCylinder, glutSolidSphere, glutSolidTeapot
from glsim.play.frames import frame_of
from glsim.radiosity.load import scene_from
from glsim.radiosity.scene import Scene, box, normal_of


def drawn(draw: Any) -> Scene:
    """The scene of a function's picture, from the middle of a room of edge 4."""

    def whole() -> None:
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        draw()

    return scene_from(frame_of(whole))


def paint(rho: float, emission: float = 0.0, face: Any = GL_FRONT_AND_BACK) -> None:
    glMaterialfv(face, GL_DIFFUSE, [rho, rho, rho, 1.0])
    glMaterialfv(face, GL_EMISSION, [emission, emission, emission, 1.0])


def quads(polygons: Any, normals: bool = False) -> None:
    glBegin(GL_QUADS)
    for polygon in polygons:
        if normals:
            glNormal3f(*normal_of(polygon))
        for corner in polygon:
            glVertex3f(*corner)
    glEnd()


ROOM = box((-2, -2, -2), (2, 2, 2), inside=True)
CEILING = np.array([(-1, 1.99, -1), (1, 1.99, -1), (1, 1.99, 1), (-1, 1.99, 1)], float)


def room(normals: bool = False, reverse: bool = False) -> None:
    glEnable(GL_LIGHTING)
    order = slice(None, None, -1 if reverse else 1)
    paint(0.7)
    quads([polygon[order] for polygon in ROOM], normals)
    paint(0.0, 10.0)
    quads([CEILING[order]], normals)
    paint(0.5)


def fronts(scene: Scene, below: float = 1.9) -> np.ndarray:
    """For each polygon whose middle is so near to the origin, the cosine between its front and the way outwards."""
    middles = np.array([polygon.mean(axis=0) for polygon in scene.polygons])
    near = np.linalg.norm(middles, axis=1) < below
    fronts = np.array([normal_of(polygon) for polygon in scene.polygons])
    return np.einsum("nk,nk->n", middles[near], fronts[near]) / np.linalg.norm(middles[near], axis=1)


# ---------------------------------------------------------------- the front


def test_a_teapot_in_a_room(tmp_path: Path) -> None:
    """A program as students write it: the corners of glutSolidTeapot run clockwise, the room has no normals."""
    program = tmp_path / "teapot.py"
    walls = [(polygon.tolist(), 0.7, 0.0) for polygon in ROOM] + [(CEILING.tolist(), 0.0, 10.0)]
    program.write_text(f"""
from OpenGL.GL import *
from OpenGL.GLUT import *
from OpenGL.GLU import *
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for polygon, rho, emission in {walls}:
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [rho] * 3 + [1])
        glMaterialfv(GL_FRONT, GL_EMISSION, [emission] * 3 + [1])
        glBegin(GL_QUADS)
        for corner in polygon:
            glVertex3f(*corner)
        glEnd()
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.5] * 3 + [1])
    glMaterialfv(GL_FRONT, GL_EMISSION, [0, 0, 0, 1])
    glutSolidTeapot(0.8)
    glutSwapBuffers()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH)
glutCreateWindow("teapot")
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glMatrixMode(GL_PROJECTION)
gluPerspective(60, 1, 0.1, 20)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
""")
    scene = scene_from(program)
    assert (fronts(scene) > 0.0).mean() > 0.75  # the others are of the lip's inner side and of the handle
    white = np.array([scene.materials[m].rho[0] == np.float32(0.7) for m in scene.material])
    assert (fronts(scene, 9.0)[white] < 0.0).all()
    assert white.sum() == 6
    against, unsaid = scene.notes
    assert against.startswith("polygons whose normals look away from the side that winding and GL_FRONT_FACE make the")
    assert unsaid.endswith("or GL_CULL_FACE: winding alone decided which side reflects: 6")


def test_what_is_clockwise_is_as_bright() -> None:
    """A sphere whose corners a mirror turned, in light from all sides: it was a black hole."""

    def draw(width: float) -> Any:
        def sphere() -> None:
            room(normals=True)
            glScalef(width, 1.0, 1.0)
            glutSolidSphere(1.0, 12, 8)

        return sphere

    bright = []
    for width in (1.0, -1.0):
        found = radiosity.solve(drawn(draw(width)), 250, vertices="average")
        bright.append(found.patches.area @ found.B[:, 0])
        assert found.report()["row_sum_error_mean"] < 0.02
    assert bright[0] == pytest.approx(bright[1], rel=2e-3)


@pytest.mark.parametrize("solid", [lambda: glutSolidTeapot(0.8), lambda: glutSolidSphere(0.8, 16, 12)])
@pytest.mark.parametrize("clockwise", [False, True])
@pytest.mark.parametrize("mirror", [False, True])
def test_normals_decide(solid: Any, clockwise: bool, mirror: bool) -> None:
    def draw() -> None:
        room(normals=True)
        glFrontFace(GL_CW if clockwise else GL_CCW)
        if mirror:
            glScalef(-1.0, 1.0, 1.0)
        solid()

    cosines = fronts(drawn(draw))
    assert (cosines > 0.0).mean() > 0.75  # the teapot's lip has an inner side


@pytest.mark.parametrize("reverse", [False, True])
def test_without_normals_front_face_decides(reverse: bool) -> None:
    def draw() -> None:
        glFrontFace(GL_CW if reverse else GL_CCW)
        room(reverse=reverse)

    scene = drawn(draw)
    assert (fronts(scene, 9.0) < 0.0).all()
    assert [note.rpartition(": ")[2] for note in scene.notes] == ["6"]  # (0, 0, 1) fits the wall at z = -2


@pytest.mark.parametrize(("culled", "inwards"), [(GL_BACK, True), (GL_FRONT, False)])
def test_without_normals_culling_decides(culled: Any, inwards: bool) -> None:
    """Only one side can be seen, and nothing is left to say."""

    def draw() -> None:
        glEnable(GL_CULL_FACE)
        glCullFace(culled)
        room()

    scene = drawn(draw)
    assert ((fronts(scene, 9.0) < 0.0) == inwards).all()
    assert scene.notes == ()


def test_a_normal_that_was_left_says_nothing() -> None:
    """One normal for a whole cube is across most of its faces; without lighting the last one is left from elsewhere."""

    def draw() -> None:
        room(normals=True)
        glDisable(GL_LIGHTING)
        glNormal3f(0.0, 0.0, -1.0)
        quads(box((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)))

    assert (fronts(drawn(draw), 1.0) > 0.0).all()


def test_a_mirrored_picture_has_the_same_fronts() -> None:
    def draw() -> None:
        glMatrixMode(GL_PROJECTION)
        glScalef(-1.0, 1.0, 1.0)
        glMatrixMode(GL_MODELVIEW)
        glFrontFace(GL_CW)
        room()

    assert (fronts(drawn(draw), 9.0) < 0.0).all()


# ---------------------------------------------------------------- two sides


@pytest.mark.parametrize("two_side", [False, True])
def test_a_sheet_reflects_on_both_sides_where_it_is_lit_so(two_side: bool) -> None:
    """With the material of each; a body has no other side."""

    def draw() -> None:
        room(normals=True)
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_side)
        paint(0.2, face=GL_FRONT)
        paint(0.6, face=GL_BACK)
        quads([np.array([(-1, 0, -1), (-1, 0, 1), (1, 0, 1), (1, 0, -1)], float)], normals=True)
        glTranslatef(0, -1, 0)
        glutSolidCube(0.4)

    scene = drawn(draw)
    sheets = {
        (round(float(normal_of(polygon)[1])), round(scene.materials[m].rho[0], 1))
        for polygon, m in zip(scene.polygons, scene.material, strict=True)
        if np.abs(polygon[:, 1]).max() < 1e-6
    }
    assert sheets == ({(1, 0.2), (-1, 0.6)} if two_side else {(1, 0.2)})
    assert len(scene.polygons) == 7 + 12 + (2 if two_side else 1)


# ---------------------------------------------------------------- smooth


def test_smooth_normals_stay_smooth() -> None:
    """The wall of a cylinder is one surface, its lids are others; with GL_FLAT, and in a cube, each face is one."""

    def cylinder(shade: Any) -> Any:
        def draw() -> None:
            room(normals=True)
            glShadeModel(shade)
            glutSolidCylinder(0.4, 1.0, 12, 3)

        return draw

    def groups(scene: Scene) -> list[int]:
        scene = scene.checked()  # drops triangles at the middle of a lid that have no area
        names = np.array([scene.materials[m].rho[0] == 0.5 for m in scene.material])
        return sorted(np.unique(np.array(scene.group)[names], return_counts=True)[1].tolist())

    smooth = groups(drawn(cylinder(GL_SMOOTH)))
    assert smooth[-1] == 72  # triangles
    assert len(smooth) == 3
    assert set(groups(drawn(cylinder(GL_FLAT)))) == {1}

    def cube() -> None:
        room(normals=True)
        glutSolidCube(1.0)

    assert groups(drawn(cube)) == [2] * 6
