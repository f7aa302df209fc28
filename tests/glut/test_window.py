"""Real windows: under Xvfb, with keys and a mouse that xdotool moves.  Skipped where those or glfw are missing."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("glfw")
pytestmark = pytest.mark.skipif(not (shutil.which("Xvfb") and shutil.which("xdotool")), reason="needs Xvfb and xdotool")

PROGRAM = """
from OpenGL.GL import *
from OpenGL.GLUT import *
log = open("log.txt", "w")

def note(name):
    def callback(*arguments):
        print(name, *arguments, glutGetModifiers(), file=log, flush=True)
        if arguments[0] == b"q":
            glutLeaveMainLoop()
    return callback

def display():
    glClearColor(1, 0.5, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glutSwapBuffers()
    print("display", file=log, flush=True)

glutInit()
glutInitDisplayMode(GLUT_DOUBLE)
glutInitWindowSize(200, 150)
glutCreateWindow("glsim window test")
glutDisplayFunc(display)
glutReshapeFunc(note("reshape"))
glutKeyboardFunc(note("key"))
glutSpecialFunc(note("special"))
glutMouseFunc(note("mouse"))
glutMotionFunc(note("motion"))
glutPassiveMotionFunc(note("passive"))
submenu = glutCreateMenu(note("submenu"))
glutAddMenuEntry("inner", 11)
glutCreateMenu(note("menu"))
glutAddMenuEntry("first", 1)
glutAddSubMenu("more", submenu)
glutAttachMenu(GLUT_RIGHT_BUTTON)
glutTimerFunc(100, note("timer"), 7)
glutMainLoop()
print("left", file=log, flush=True)
"""


@pytest.fixture
def display() -> Iterator[str]:
    read, write = os.pipe()
    words = ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x480x24", "+extension", "GLX", "-nolisten", "tcp"]
    server = subprocess.Popen(words, pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    number = b""
    while not number.endswith(b"\n"):
        part = os.read(read, 16)
        if not part:
            pytest.skip("Xvfb does not start here")
        number += part
    yield ":" + number.decode().strip()
    server.terminate()
    server.wait(10)


@pytest.mark.slow
def test_keys_mouse_and_resizing_reach_the_program(display: str, tmp_path: Path) -> None:
    script = tmp_path / "program.py"
    script.write_text(PROGRAM)
    environment = {**os.environ, "DISPLAY": display}
    environment.pop("WAYLAND_DISPLAY", None)
    words = [sys.executable, "-m", "glsim", "run", str(script), "--window", "--timeout", "60", "--json"]
    running = subprocess.Popen(words, env=environment, stdout=subprocess.PIPE, text=True)
    log = tmp_path / "log.txt"

    def tool(*words: str) -> str:
        return subprocess.run(["xdotool", *words], env=environment, capture_output=True, text=True).stdout.strip()

    def wait_for(words: str) -> None:
        for _ in range(200):
            if log.exists() and words in log.read_text().splitlines():
                return
            time.sleep(0.1)
        raise AssertionError(f"{words!r} did not come: {log.read_text() if log.exists() else 'no log'}")

    try:
        wait_for("timer 7 0")
        window = tool("search", "--name", "glsim window test").split()[0]
        tool("mousemove", "--window", window, "50", "60")
        wait_for("passive 50 60 0")
        tool("mousedown", "1")
        tool("mousemove", "--window", window, "80", "90")
        tool("mouseup", "1")
        tool("windowfocus", window)
        for key in ("g", "Left", "shift+a", "Escape"):
            tool("key", key)
        for words in ("mouse 0 0 50 60 0", "motion 80 90 0", "mouse 0 1 80 90 0", "key b'g' 80 90 0",
                      "special 100 80 90 0", "key b'A' 80 90 1", "key b'\\x1b' 80 90 0"):  # fmt: skip
            wait_for(words)
        for y, words in ((47, "menu 1 0"), (83, "submenu 11 0")):  # rows of 18 pixels from where the menu was opened
            tool("mousemove", "--window", window, "20", "40")
            wait_for("passive 20 40 0")
            tool("click", "3")
            tool("mousemove", "--window", window, "40", str(y))
            wait_for(f"passive 40 {y} 0")
            tool("click", "1")
            wait_for(words)
        tool("windowsize", window, "300", "220")
        wait_for("reshape 300 220 0")
        tool("key", "q")
        said, _ = running.communicate(timeout=30)
    finally:
        running.kill()
    assert json.loads(said)["status"] == "ok"
    assert log.read_text().splitlines()[-1] == "left"
