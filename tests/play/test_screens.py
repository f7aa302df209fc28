"""glsim run and its like with programs that draw into glsim.offscreen."""

from __future__ import annotations

import json
import textwrap
from pathlib import Path

import numpy as np
import pytest

from glsim.cli import main
from glsim.play.frames import frame_of_program
from tests.drawing import picture
from tests.drawing import play_text as play

pytestmark = pytest.mark.slow  # each test runs programs in processes of their own

IMPORTS = "from OpenGL.GL import *\nfrom OpenGL.GLU import *\nfrom OpenGL.GLUT import *\n"
WINDOW = IMPORTS + "glutInit()\nglutInitWindowSize(60, 40)\nglutCreateWindow(b'w')\nglutDisplayFunc(lambda: None)\n"
SCREEN = """
import glsim
from glsim.gl import *
screen = glsim.offscreen(64, 48)
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0)
glBegin(GL_TRIANGLES)
for x, y in ((-0.9, -0.9), (0.9, -0.9), (0, 0.9)):
    glNormal3f(0, 0, 1); glVertex2f(x, y)
glEnd()
"""


def test_a_screen_is_a_window(tmp_path: Path) -> None:
    record = play(tmp_path, SCREEN)
    assert (record["status"], record["frames"], record["pictures"]) == ("ok", 1, ["frame_000.png"])
    assert record["calls"]["glVertex2f"] == 3
    assert picture(tmp_path).shape == (48, 64, 3)
    assert picture(tmp_path)[30, 32].tolist() == [214, 214, 214]


def test_several_screens_released_ones_and_dropped_ones(tmp_path: Path) -> None:
    text = """
    import glsim
    from glsim.gl import *
    def draw(red, size):
        screen = glsim.offscreen(size, size)
        glClearColor(red, 0, 0, 1); glClear(GL_COLOR_BUFFER_BIT)
        return screen
    draw(0.2, 8).release()
    draw(0.4, 9)
    with draw(0.6, 10) as third:
        pass
    """
    record = play(tmp_path, text)
    assert record["pictures"] == ["frame_000.png", "frame_000_w2.png", "frame_000_w3.png"]
    reds = [picture(tmp_path, name)[0, 0, 0] for name in record["pictures"]]
    assert reds == [51, 102, 153]


def test_a_program_that_compares_keeps_glsims_own_screens_out(tmp_path: Path) -> None:
    record = play(tmp_path, SCREEN + "glsim.compare('cube', modes=['flat'], lobes=['blinn'], size=32)\n")
    assert record["pictures"] == ["frame_000.png"]


def test_an_error_keeps_what_was_drawn(tmp_path: Path) -> None:
    record = play(tmp_path, SCREEN + "glEnable(GL_TRIANGLES)\n")
    assert record["status"] == "gl-error"
    assert record["errors"][0]["line"] == 10
    assert picture(tmp_path).any()


def test_shade_and_lobe(tmp_path: Path) -> None:
    tilted = SCREEN.replace("glNormal3f(0, 0, 1)", "glNormal3f(x, y, 0.2)")
    play(tmp_path, tilted, shade="flat")
    assert len(np.unique(picture(tmp_path).reshape(-1, 3), axis=0)) == 2


def test_every_command_takes_such_a_program(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("program.py").write_text(SCREEN)
    commands = {
        "probe": ["32", "30"], "trace": [], "explain": [], "terms": ["-o", "terms.png"],
        "compare": ["--modes", "gouraud,phong,native", "--lobe", "blinn", "-o", "compare.png"],
    }  # fmt: skip
    said = {}
    for command, words in commands.items():
        assert main([command, "program.py", *words, "--json"]) == 0
        said[command] = json.loads(capfd.readouterr().out)
    assert said["probe"]["pixel"][:3] == [214, 214, 214]
    assert [call["text"] for call in said["trace"]["calls"]][2:4] == [
        "glBegin(GL_TRIANGLES)",
        "3 glNormal3f, 3 glVertex2f",
    ]
    assert len(said["explain"]["draws"]) == 1
    assert [row["max"] <= 1 for row in said["compare"]["differences"]] == [True, True, True]


def test_a_window_comes_before_a_screen(tmp_path: Path) -> None:
    (tmp_path / "program.py").write_text(SCREEN + WINDOW + "glRectf(-1, -1, 0, 0)\nglutMainLoop()\n")
    frame = frame_of_program(tmp_path / "program.py", calls=True)
    assert (frame.width, frame.height) == (60, 40)
    assert [call.name for call in frame.calls if call.name == "glRectf"] == ["glRectf"]


def test_a_reset_begins_anew(tmp_path: Path) -> None:
    (tmp_path / "program.py").write_text(SCREEN + "screen.reset()\nglRectf(-1, -1, 0, 0)\n")
    frame = frame_of_program(tmp_path / "program.py", calls=True)
    assert [call.name for call in frame.calls] == ["glRectf"]
    assert len(frame.packets) == 1


def test_native_replays_a_glut_program(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    text = """
    def display():
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        glRotatef(20, 1, 0, 0)
        glutSolidTeapot(0.5)
        glDisable(GL_LIGHTING)
        glRasterPos2f(-0.9, -0.9)
        for letter in b"text":
            glutBitmapCharacter(GLUT_BITMAP_HELVETICA_12, letter)
        glEnable(GL_LIGHTING)
    glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST)
    glutDisplayFunc(display)
    glutMainLoop()
    """
    front = WINDOW.replace("glutInit()", "glutInit()\nglutInitDisplayMode(GLUT_DEPTH)")
    (tmp_path / "program.py").write_text(front + textwrap.dedent(text))
    words = ["--modes", "gouraud,native", "--lobe", "blinn", "-o", str(tmp_path / "sheet.png"), "--json"]
    assert main(["compare", str(tmp_path / "program.py"), *words]) == 0
    rows = json.loads(capfd.readouterr().out)["differences"]
    assert rows[0]["mode"] == "gouraud", "compared with the driver's picture"
    assert rows[0]["max"] <= 3
    assert rows[0]["mean"] < 0.05
