"""glsim.trace: what each call changed, drew and ignored; programs that fail."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.gl import *
from glsim.play.capture import capture
from glsim.play.plan import Plan
from glsim.play.run import run
from tests.drawing import lit


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
@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.slow
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
