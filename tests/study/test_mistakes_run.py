"""What ``glsim run`` says of mistakes, and mistakes that only a program with a window can make."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import glsim
from glsim.cli import main
from glsim.cli import run as cli_run
from glsim.gl import glRectf
from glsim.machine.frame import Frame
from glsim.machine.record import Recorder
from tests.drawing import program_file

PROGRAM = """
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    CAMERA
    gluLookAt(1, 2, 4, 0, 0, 0, 0, 1, 0)
    glutSolidCube(0.5)
    SWAP
def reshape(w, h):
    glMatrixMode(GL_PROJECTION)
    IDENTITY
    gluPerspective(45, w / h, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
LAMP
glutDisplayFunc(display)
glutReshapeFunc(reshape)
glutMainLoop()
"""
MENDED = {
    "CAMERA": "glLoadIdentity()",
    "SWAP": "glutSwapBuffers()",
    "IDENTITY": "glLoadIdentity()",
    "LAMP": "glEnable(GL_LIGHT0)",
}


def written(folder: Path, *bad: str) -> str:
    text = PROGRAM
    for word, mended in MENDED.items():
        text = text.replace(word, "pass" if word in bad else mended)
    return program_file(folder, text)


@pytest.mark.slow
def test_the_last_line_of_a_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    script = written(tmp_path, "LAMP", "IDENTITY")
    assert main(["run", script, "--out", str(tmp_path / "out")]) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert last == (
        f"glsim trace --mistakes {script} explains: gluPerspective without glLoadIdentity (line 20); 1 more"
    )


@pytest.mark.slow
def test_a_run_as_json_and_one_without_mistakes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", written(tmp_path, "SWAP"), "--out", str(tmp_path / "out"), "--json"]) == 0
    (found,) = json.loads(capsys.readouterr().out)["mistakes"]
    assert (found["kind"], found["line"]) == ("never-swapped", 15)
    assert found["sentence"].startswith("the window has two buffers")
    assert main(["run", written(tmp_path), "--out", str(tmp_path / "out")]) == 0
    assert "explains" not in capsys.readouterr().out


@pytest.mark.slow
def test_recording_is_given_up_when_there_is_much(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Then the picture is the same, and nothing is said."""
    script, pictures = written(tmp_path, "LAMP"), []
    for most in (4_000, 8, 0):
        monkeypatch.setattr(cli_run, "MOST_CALLS", most)
        assert main(["run", script, "--out", str(tmp_path / "out"), "--frames", "2"]) == 0
        assert ("explains" in capsys.readouterr().out) == (most == 4_000)
        pictures.append([path.read_bytes() for path in sorted((tmp_path / "out").iterdir())])
    assert len(pictures[0]) == 2
    assert pictures[0] == pictures[1] == pictures[2]


@pytest.mark.slow
def test_a_projection_in_a_reshape_function_and_at_the_start(tmp_path: Path) -> None:
    """Only a function that is called again and again multiplies it again and again."""
    (found,) = glsim.trace(written(tmp_path, "IDENTITY")).mistakes
    assert found.kind == "perspective-again"
    (found,) = glsim.trace(written(tmp_path, "CAMERA")).mistakes  # the glLoadIdentity of reshape helps once
    assert found.kind == "camera-again"
    at_start = PROGRAM.replace("glutReshapeFunc(reshape)", "reshape(1, 1)").replace("IDENTITY", "pass")
    for word, mended in MENDED.items():
        at_start = at_start.replace(word, mended)
    assert glsim.trace(program_file(tmp_path, at_start)).mistakes == []


def test_a_recorder_that_gave_up_stays_silent(screen: glsim.Offscreen) -> None:
    """Also when glsim.capture makes it current again."""
    machine = screen.machine
    frame = machine.outlet.frame = Frame(128, 128)
    recorder = Recorder(machine, frame, most=3)
    machine.record(recorder)
    try:
        with glsim.capture() as inner:
            for _ in range(4):
                glRectf(-1, -1, 1, 1)
        glRectf(-1, -1, 1, 1)
        assert machine.recorder is None
        assert len(list(inner.draws)) == 4
        assert frame.calls == frame.history == []
    finally:
        machine.record(None)
        machine.outlet.frame = None
