"""glsim run: unmodified programs, in a process of their own."""

from __future__ import annotations

import json
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from glsim.cli import main
from glsim.play.run import events_from
from tests.drawing import WINDOW, picture, play, program_file

# ---------------------------------------------------------------- steps


LOG = """
    log = open("log.txt", "w")
    def note(name):
        def callback(*arguments):
            print(name, *arguments, file=log, flush=True)
            if name in ("key", "timer"):
                glutPostRedisplay()
            if name == "reshape":
                glViewport(0, 0, *arguments)
        return callback
    def display():
        print("display", glutGet(GLUT_ELAPSED_TIME), file=log, flush=True)
        glClearColor(0, glutGet(GLUT_ELAPSED_TIME) / 255, 1, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        glutSwapBuffers()
    glutDisplayFunc(display)
    glutReshapeFunc(note("reshape"))
    glutVisibilityFunc(note("visibility"))
    glutKeyboardFunc(note("key"))
    glutSpecialFunc(note("special"))
    glutMouseFunc(note("mouse"))
    glutMotionFunc(note("motion"))
    menu = glutCreateMenu(note("menu"))
    glutAddMenuEntry("one", 1)
    glutAttachMenu(GLUT_RIGHT_BUTTON)
    glutTimerFunc(50, note("timer"), 7)
    glutTimerFunc(50, note("timer"), 8)
    glutMainLoop()
"""


@pytest.mark.slow
def test_steps_come_in_their_order(tmp_path: Path) -> None:
    events = events_from("a", "special 101;mouse 0 1 10 20;motion 11 21;menu 5;reshape 60 40;tick")
    record = play(tmp_path, program_file(tmp_path, LOG), events=events)
    assert (record["status"], record["frames"]) == ("ok", 8)
    assert (tmp_path / "log.txt").read_text().splitlines() == [
        "reshape 120 80", "visibility 1", "display 0",
        "key b'a' 0 0", "display 20",
        "special 101 0 0",
        "mouse 0 1 10 20", "timer 7", "timer 8", "display 60",
        "motion 11 21",
        "menu 5",
        "reshape 60 40", "display 120",
    ]  # fmt: skip
    assert record["pictures"] == [f"frame_{k:03d}.png" for k in range(8)]
    assert picture(tmp_path, "frame_005.png")[0, 0].tolist() == [0, 60, 255]
    assert picture(tmp_path, "frame_006.png").shape == (40, 60, 3)
    assert record["calls"]["glutSwapBuffers"] == 4


@pytest.mark.slow
def test_without_idle_and_events_time_jumps_to_the_timer(tmp_path: Path) -> None:
    script = program_file(
        tmp_path,
        """
        def tick(value):
            print(value, glutGet(GLUT_ELAPSED_TIME), file=open("log.txt", "a"))
            glutTimerFunc(1000, tick, value + 1)
        glutDisplayFunc(lambda: None)
        glutTimerFunc(5, tick, 1)
        glutMainLoop()
        """,
    )
    play(tmp_path, script, frames=4)
    assert (tmp_path / "log.txt").read_text() == "1 20\n2 1020\n3 2020\n"


@pytest.mark.slow
def test_pictures_are_the_same_each_time(tmp_path: Path) -> None:
    script = program_file(
        tmp_path,
        """
        import random, time, datetime
        import numpy
        def display():
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
            glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST)
            glRotatef(360 * random.random() + 10 * time.time() + datetime.datetime.now().second, *numpy.random.rand(3))
            glutSolidTorus(0.2, 0.6, 12, 20)
            glutSwapBuffers()
        glutDisplayFunc(display)
        glutIdleFunc(glutPostRedisplay)
        glutMainLoop()
        """,
    )
    play(tmp_path, script, frames=3)
    first = [picture(tmp_path, f"frame_{k:03d}.png") for k in range(3)]
    shutil.rmtree(tmp_path / "out")
    play(tmp_path, script, frames=3)
    for k in range(3):
        assert (picture(tmp_path, f"frame_{k:03d}.png") == first[k]).all()
    assert (first[0] != first[1]).any()


# ---------------------------------------------------------------- options


LIT = """
    glMatrixMode(GL_PROJECTION)
    gluOrtho2D(-1, 1, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    def display():
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_CULL_FACE)
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glMaterialfv(GL_FRONT, GL_SPECULAR, [1, 1, 1, 1])
        glMaterialf(GL_FRONT, GL_SHININESS, 30)
        glutSolidSphere(0.9, 8, 6)
        glutSwapBuffers()
    glutDisplayFunc(display)
    glutMainLoop()
"""


@pytest.mark.slow
def test_any_program_is_shaded_otherwise_and_resized(tmp_path: Path) -> None:
    script = program_file(tmp_path, LIT)
    pictures = {}
    for shade in ("flat", "smooth", "phong"):
        assert play(tmp_path, script, shade=shade, size=(100, 100))["status"] == "ok"
        pictures[shade] = picture(tmp_path)
        assert pictures[shade].shape == (100, 100, 3)
    colours = {shade: len(np.unique(image.reshape(-1, 3), axis=0)) for shade, image in pictures.items()}
    assert colours["flat"] < 30 < colours["smooth"]
    apart = np.abs(pictures["phong"].astype(int) - pictures["smooth"])
    assert apart.max() > 40, "the highlight is inside of a face"


@pytest.mark.slow
def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    gif = tmp_path / "all.gif"
    words = ["--out", str(tmp_path / "out"), "--keys", "ab", "--gif", str(gif), "--json"]
    code = main(["run", program_file(tmp_path, LOG), *words])
    said = json.loads(capsys.readouterr().out)
    assert code == 0, said
    assert (said["status"], said["frames"]) == ("ok", 3)
    assert Image.open(gif).n_frames >= 2


@pytest.mark.slow
def test_command_line_arguments_go_to_the_program(tmp_path: Path) -> None:
    text = "open('log.txt', 'w').write(repr(sys.argv[1:]))\nglutDisplayFunc(lambda: None)\nglutMainLoop()\n"
    script = program_file(tmp_path, text)
    assert main(["run", script, "--out", str(tmp_path / "out"), "--", "--fast", "3"]) == 0
    assert (tmp_path / "log.txt").read_text() == "['--fast', '3']"


@pytest.mark.parametrize(
    ("events", "sentence"),
    [("jump 3", "events are"), ("mouse 0 1", "events are"), ("special up", "numbers are needed")],
)
def test_bad_events(events: str, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        events_from("", events)


# ---------------------------------------------------------------- programs that end in their own way


@pytest.mark.slow
def test_an_exception_is_the_scripts(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    script = program_file(
        tmp_path, "def display():\n    glBegin(GL_LIGHTING)\nglutDisplayFunc(display)\nglutMainLoop()\n"
    )
    record = play(tmp_path, script)
    assert record["status"] == "gl-error"
    assert record["errors"][0]["line"] == len(WINDOW.splitlines()) + 2
    said = capfd.readouterr().err
    assert "glBegin(GL_LIGHTING)" in said
    assert "glsim/" not in said.replace("program.py", "")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "status", "frames"),
    [
        ("sys.exit(3)", "ok", 1),
        (
            "import os\nglutDisplayFunc(lambda: None)\nglutTimerFunc(1, lambda v: os._exit(0), 0)\nglutMainLoop()",
            "ok",
            1,
        ),
        ("import os\nos._exit(7)", "exit", 0),
        ("open('no such file.png')", "python-error", 0),
        ("def display(): glutLeaveMainLoop()\nglutDisplayFunc(display)\nglutMainLoop()", "ok", 1),
        ("syntax error here", "python-error", 0),
    ],
)
def test_endings(tmp_path: Path, text: str, status: str, frames: int) -> None:
    record = play(tmp_path, program_file(tmp_path, text), frames=3)
    assert (record["status"], record["frames"]) == (status, frames), record


@pytest.mark.slow
def test_an_endless_loop_is_stopped_and_its_pictures_are_there(tmp_path: Path) -> None:
    text = "def idle():\n    while True: pass\nglutDisplayFunc(glutSwapBuffers)\nglutIdleFunc(idle)\nglutMainLoop()\n"
    started = time.monotonic()
    record = play(tmp_path, program_file(tmp_path, text), timeout=4.0, frames=5)
    assert time.monotonic() - started < 10
    assert (record["status"], record["pictures"]) == ("timeout", ["frame_000.png"])
    assert picture(tmp_path).shape == (80, 120, 3)


@pytest.mark.slow
def test_interrupting(tmp_path: Path) -> None:
    text = "glutDisplayFunc(glutSwapBuffers)\nglutIdleFunc(lambda: open('here', 'w').close())\nglutMainLoop()\n"
    script = program_file(tmp_path, text)
    words = [sys.executable, "-m", "glsim", "run", script, "--frames", "1000000", "--out", str(tmp_path / "out")]
    process = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    for _ in range(200):
        if (tmp_path / "here").exists():
            break
        time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=20)
    assert process.returncode == 130
    assert "interrupted" in said
    assert picture(tmp_path).shape == (80, 120, 3)


def test_a_script_that_is_not_there(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "nowhere.py"]) == 1
    assert "nowhere.py: there is no such file" in capsys.readouterr().err


@pytest.mark.slow
def test_compare_takes_a_program(tmp_path: Path) -> None:
    from glsim import compare

    sheet = compare(program_file(tmp_path, LIT), modes=["wireframe", "flat", "phong"], lobes=["blinn"])
    assert sheet.images["blinn", "flat"].shape == (80, 120, 3)
    assert sheet.difference("blinn", "flat").max() > 20
    with pytest.raises(ValueError, match="gives no picture"):
        compare(program_file(tmp_path, "raise ValueError('no')"), modes=["flat"], lobes=["blinn"])


@pytest.mark.slow
def test_a_display_function_that_never_returns_leaves_its_picture(tmp_path: Path) -> None:
    text = "import time\nreal = time.sleep\ndef display():\n    while True:\n        glClear(GL_COLOR_BUFFER_BIT)\n"
    text += "        glutSwapBuffers()\nglutDisplayFunc(display)\nglutMainLoop()\n"
    record = play(tmp_path, program_file(tmp_path, text), timeout=6.0)
    assert (record["status"], record["pictures"]) == ("timeout", ["frame_000.png"])
