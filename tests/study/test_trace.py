"""glsim.trace: what each call changed; each diagnosis fires on a bad program and is silent on the mended one."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut.shapes import glutSolidCube
from glsim.play.capture import capture
from glsim.play.plan import Plan
from glsim.play.run import run
from glsim.study.mistakes import CHECKED, DIAGNOSES

Program = Callable[[bool], None]
BAD: dict[str, Program] = {}


def mistake(kind: str) -> Callable[[Program], Program]:
    def note(program: Program) -> Program:
        BAD[kind] = program
        return program

    return note


def lit() -> None:
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for capability in (GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST):
        glEnable(capability)


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


def kinds(program: Program, mended: bool) -> list[str]:
    with capture(calls=True) as frame:
        program(mended)
    return [entry.kind for entry in glsim.trace(frame).mistakes]


@pytest.mark.parametrize("kind", BAD)
def test_a_diagnosis_fires(kind: str, screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        BAD[kind](False)
    (found,) = glsim.trace(frame).mistakes
    assert found.kind == kind
    assert found.where is not None
    assert found.where.file == __file__
    assert "{" not in found.sentence


@pytest.mark.parametrize("kind", BAD)
def test_a_diagnosis_is_silent_on_the_mended_program(kind: str, screen: glsim.Offscreen) -> None:
    assert kinds(BAD[kind], True) == []


def test_every_diagnosis_is_tested() -> None:
    assert {*BAD, "error", "missing-buffer"} == set(DIAGNOSES) == set(CHECKED)


@pytest.mark.parametrize("slices", [3, 4, 5, 6, 7, 8, 10, 12, 16, 24])
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


def test_colours_that_lighting_ignores_are_named(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glColor3f(1, 0, 0)  # 0: seen
        glRectf(-1, -1, 0, 0)
        lit()
        glColor3f(0, 1, 0)  # ignored by the first, seen by the second
        glRectf(-1, -1, 0, 0)
        glDisable(GL_LIGHTING)
        glRectf(-1, -1, 0, 0)
        glEnable(GL_LIGHTING)
        glColor3f(0, 0, 1)  # ignored
        glRectf(-1, -1, 0, 0)
        glColor3f(0, 1, 1)  # kept for the raster position
        glRectf(-1, -1, 0, 0)
        glWindowPos2i(3, 3)
        glEnable(GL_COLOR_MATERIAL)
        glColor3f(1, 1, 1)  # the material
        glRectf(-1, -1, 0, 0)
    noted = [entry.text for entry in glsim.trace(frame).entries if entry.note]
    assert noted == ["glColor3f(0, 0, 1)"]
    assert "glColor has no effect: GL_LIGHTING is on" in next(e.note for e in glsim.trace(frame).entries if e.note)


WITHOUT_BUFFERS = """
from OpenGL.GL import *
from OpenGL.GLUT import *
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glColor3f(1, 0, 0)
    glRectf(-0.9, -0.9, 0.9, 0.9)
    glTranslatef(0, 0, 0.5)
    glColor3f(0, 1, 0)
    glRectf(-0.5, -0.5, 0.5, 0.5)  # behind the red one
    glDisable(GL_DEPTH_TEST)
    glEnable(GL_STENCIL_TEST)
    glStencilFunc(GL_EQUAL, 1, 1)
    glColor3f(0, 0, 1)
    glRectf(-0.2, -0.2, 0.2, 0.2)
    glutSwapBuffers()
    print(glGetIntegerv(GL_DEPTH_BITS), glGetIntegerv(GL_STENCIL_BITS), file=open("bits.txt", "w"))
glutInit()
glutInitDisplayMode(GLUT_DOUBLE MODE)
glutInitWindowSize(100, 100)
glutCreateWindow("t")
glutDisplayFunc(display)
glutMainLoop()
"""


@pytest.mark.parametrize(
    ("mode", "bits", "at_30", "at_50", "missing"),
    [
        ("", "0 0", (0, 255, 0), (0, 0, 255), {(6, "depth"), (13, "stencil")}),
        ("| GLUT_DEPTH", "24 0", (255, 0, 0), (0, 0, 255), {(13, "stencil")}),
        ("| GLUT_STENCIL", "24 8", (255, 0, 0), (255, 0, 0), set()),
    ],
)
def test_buffers_that_were_not_asked_for(
    mode: str, bits: str, at_30: tuple[int, ...], at_50: tuple[int, ...], missing: set[tuple[int, str]], tmp_path: Path
) -> None:
    """As freeglut and Mesa: GLUT_STENCIL brings depth along; a test without its buffer has no effect, which is said."""
    script = tmp_path / "buffers.py"
    script.write_text(WITHOUT_BUFFERS.replace("MODE", mode))
    record = run(Plan(str(script), out=str(tmp_path), count=True))
    assert record["status"] == "ok"
    assert (tmp_path / "bits.txt").read_text().split() == bits.split()
    picture = np.asarray(Image.open(tmp_path / "frame_000.png"))
    assert tuple(picture[30, 30]) == at_30
    assert tuple(picture[50, 50]) == at_50
    said = " ".join(record["notes"])
    assert {kind for kind in ("depth", "stencil") if f"no {kind} buffer" in said} == {kind for _, kind in missing}
    found = [entry for entry in glsim.trace(script).mistakes if entry.kind == "missing-buffer"]
    assert {(entry.where.line, kind) for entry in found for kind in ("depth", "stencil")
            if entry.where is not None and f"no {kind} buffer" in entry.sentence} == missing  # fmt: skip
    assert tuple(glsim.probe(script, 30, 30).pixel[:3]) == at_30


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


def test_the_stream(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHTING)
        glShadeModel(GL_FLAT)
        glPushMatrix()
        glTranslatef(1, 0, 0)
        glBegin(GL_TRIANGLES)
        for k in range(3):
            glNormal3f(0, 0, 1)
            glVertex2f(k, k * k)
        glEnd()
        glPopMatrix()
    entries = glsim.trace(frame).entries
    assert [entry.redundant for entry in entries[:3]] == [False, True, False]
    assert entries[2].changes == (("lighting.shade_model", "GL_SMOOTH", "GL_FLAT"),)
    assert entries[3].changes == (("modelview stack", "1 deep", "2 deep"),)
    assert entries[4].changes[0][0] == "modelview"
    assert entries[6].text == "3 glNormal3f, 3 glVertex2f"
    assert entries[7].drew == 1


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


def test_the_commands_say_that_a_program_failed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from glsim.cli import main

    script = tmp_path / "boom.py"
    script.write_text("""
from OpenGL.GL import *
from OpenGL.GLUT import *
def display():
    glRectf(-1, -1, 1, 1)
    1 / 0
glutInit()
glutCreateWindow("t")
glutDisplayFunc(display)
glutMainLoop()
""")
    for words in (["probe", str(script), "5", "5"], ["explain", str(script)], ["trace", str(script)]):
        assert main([*words, "--json"]) == 1
        record = json.loads(capsys.readouterr().out)
        assert record["status"] == "error"
        assert "ZeroDivisionError" in record["error"]
    assert main(["trace", str(script), "--mistakes"]) == 1
    assert "boom.py:6: error: ZeroDivisionError" in capsys.readouterr().out
    assert main(["probe", "cube", "5", "5", "--frame", "1"]) == 1
    assert "--frame is for programs" in capsys.readouterr().err


def test_an_error_that_ends_a_program_is_told(tmp_path: Path) -> None:
    script = tmp_path / "frustum.py"
    script.write_text("""
from OpenGL.GL import *
from OpenGL.GLUT import *
def display():
    glMatrixMode(GL_PROJECTION)
    glFrustum(-1, 1, -1, 1, 0, 10)
glutInit()
glutCreateWindow("t")
glutDisplayFunc(display)
glutMainLoop()
""")
    found = glsim.trace(script).mistakes
    assert {entry.kind for entry in found} == {"near-plane", "error"}
    assert all(entry.where is not None and entry.where.line == 6 for entry in found)


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
