"""Each diagnosis of glsim.trace fires on a bad program and is silent on the mended one."""

from __future__ import annotations

import math

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt
from glsim.glut.polyhedra import glutSolidCube
from glsim.play.capture import capture
from glsim.study.mistakes import RULES
from tests.drawing import captured, lit
from tests.study.planted import BAD, Program


def kinds(program: Program, mended: bool) -> list[str]:
    return [entry.kind for entry in glsim.trace(captured(lambda: program(mended))).mistakes]


@pytest.mark.parametrize("kind", BAD)
def test_a_diagnosis_fires(kind: str, screen: glsim.Offscreen) -> None:
    (found,) = glsim.trace(captured(lambda: BAD[kind](False))).mistakes
    assert found.kind == kind
    assert found.where is not None
    assert found.where.file.endswith("planted.py")
    assert "{" not in found.sentence


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=pytest.mark.slow if kind == "highlight-lost" else ()) for kind in BAD]
)
def test_a_diagnosis_is_silent_on_the_mended_program(kind: str, screen: glsim.Offscreen) -> None:
    assert kinds(BAD[kind], True) == []


def test_every_diagnosis_is_tested() -> None:
    assert {*BAD, "error", "missing-buffer", "never-swapped"} == set(RULES)


@pytest.mark.parametrize(
    "slices", [3, 4, 5, 6, 7, *(pytest.param(n, marks=pytest.mark.slow) for n in (8, 10, 12, 16, 24))]
)
def test_coarse_spheres_lose_their_highlight(slices: int) -> None:
    assert [entry.kind for entry in glsim.trace(f"sphere:{slices}").mistakes] == ["highlight-lost"]


@pytest.mark.parametrize("slices", [64, 96])
def test_fine_spheres_keep_it(slices: int) -> None:
    assert glsim.trace(f"sphere:{slices}").mistakes == []


def test_a_camera_at_the_point_it_looks_at(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        gluLookAt(0, 0, 1, 0, 0, 1, 0, 1, 0)
        lit()
        glutSolidCube(0.5)
    (found,) = glsim.trace(frame).mistakes
    assert found.kind == "up-along-view"
    assert found.sentence.startswith("gluLookAt(0, 0, 1, 0, 0, 1, 0, 1, 0): up is parallel")


def test_a_matrix_that_flattens(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        lit()
        glScalef(0, 0, 0)
        glNormal3f(0, 0, 1)
        glRectf(-0.5, -0.5, 0.5, 0.5)
    (found,) = glsim.trace(frame).mistakes
    assert "the modelview matrix flattens the scene" in found.sentence


def test_three_numbers_where_the_memory_goes_on(screen: glsim.Offscreen) -> None:
    """PyOpenGL passes the array's address on, and the driver reads the number behind it; here it is 0."""
    with capture(calls=True) as frame:
        glLightfv(GL_LIGHT0, GL_POSITION, np.array([1, 2, 3, 99], np.float32)[:3])
        glLight(GL_LIGHT1, GL_POSITION, (1, 2, 3))
        glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, (0, 0, -1))
    assert glGetLightfv(GL_LIGHT0, GL_POSITION).tolist() == [1, 2, 3, 0]
    found = glsim.trace(frame).mistakes
    assert [entry.kind for entry in found] == ["position-of-three"] * 2
    assert "GL_LIGHT1 has three numbers" in found[1].sentence


@pytest.mark.parametrize("angle", [math.radians(30), math.pi, 1.5708, -0.785, math.radians(45) * 3, math.radians(17)])
def test_angles_that_look_like_radians(angle: float, screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glRotatef(angle, 0, 1, 0)
        glRectf(0, 0, 1, 1)
    assert [entry.kind for entry in glsim.trace(frame).mistakes] == ["radians"]


@pytest.mark.parametrize("angle", [0, 1, 2, 3, 0.5, 0.1, 1.5, 2.25, 45.0, 180 / math.pi, 0.7, -3.0, 90, 6.2, 5.5, 0.02])
def test_angles_that_do_not(angle: float, screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glRotatef(angle, 0, 1, 0)
        glRectf(0, 0, 1, 1)
    assert not glsim.trace(frame).mistakes


@pytest.mark.parametrize("scene", ["teapot", "torus", "cube", "low-terrain", "terrain"])
def test_built_in_scenes_are_free_of_mistakes(scene: str) -> None:
    assert not glsim.trace(scene, size=128).mistakes


def test_each_matrix_stack_has_its_own_pushes(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glMatrixMode(GL_PROJECTION)
        glPushMatrix()
        glMatrixMode(GL_MODELVIEW)
        glPushMatrix()
        glMatrixMode(GL_PROJECTION)
        glPopMatrix()
        glRectf(0, 0, 1, 1)
    (found,) = glsim.trace(frame).mistakes
    assert frame.calls[found.call].name == "glPushMatrix"
    assert found.call == 3


def test_depth_without_a_reason_to_be_cleared(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_ALWAYS)
        glRectf(0, 0, 1, 1)
    assert not glsim.trace(frame).mistakes


def test_surplus_arguments_are_named_with_the_command_that_takes_them() -> None:
    glsim.offscreen(16, 16)
    with capture(calls=True) as frame:
        glColor3f(1, 1, 0, 1)
        glRotatef(90, 0, 0, 1, 0)
        glGenTextures(1)
    said = [mistake.sentence for mistake in glsim.trace(frame).mistakes]
    assert said == [
        "glColor3f(1, 1, 0, 1): glColor3f takes 3 arguments (red, green, blue) and ignores what comes after: glColor4f"
        " takes 4",
        "glRotatef(90, 0, 0, 1, 0): glRotatef takes 4 arguments (angle, x, y, z) and ignores what comes after",
    ]


def test_normals_of_several_lengths_are_told_as_a_span(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        lit()
        glBegin(GL_TRIANGLES)
        for z, (x, y) in ((2, (-0.5, -0.5)), (3, (0.5, -0.5)), (2.5, (0, 0.5))):
            glNormal3f(0, 0, z)
            glVertex2f(x, y)
        glEnd()
    (found,) = glsim.trace(frame).mistakes
    assert "normals have length 2 to 3 in eye space (glNormal got 2 to 3)" in found.sentence


def test_numbers_that_are_none_and_arguments_that_are_missing(screen: glsim.Offscreen) -> None:
    nan, infinite = float("nan"), float("inf")
    with capture(calls=True) as frame:
        lit()
        glEnable(GL_CULL_FACE)
        for wrong in (lambda: glRotatef("x", 1, 0, 0), lambda: glClear(), lambda: glEnable()):
            with pytest.raises((TypeError, ValueError)):
                wrong()
        glRotatef(nan, 1, infinite, 0)
        glColor3f(nan, 1, 1)
        glBegin(GL_TRIANGLES)
        for x in (nan, infinite, 1e38):
            glNormal3f(x, 0, 0)
            glVertex3f(x, -x, 1)
        glEnd()
    assert "radians" not in [found.kind for found in glsim.trace(frame).mistakes]
