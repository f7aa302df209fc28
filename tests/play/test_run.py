"""glsim run: unmodified programs, in a process of their own."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from glsim.cli import main
from glsim.play.plan import Plan
from glsim.play.python2 import converted, is_python_3
from glsim.play.run import events_from, run

ROOT = Path(__file__).parents[2]
WINDOW = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
import sys
glutInit(sys.argv)
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
glutInitWindowSize(120, 80)
glutCreateWindow(b"test")
"""


def program(folder: Path, text: str, front: str = WINDOW) -> str:
    path = folder / "program.py"
    path.write_text(front + textwrap.dedent(text), encoding="utf-8")
    return str(path)


def picture(folder: Path, name: str = "frame_000.png") -> np.ndarray:
    return np.asarray(Image.open(folder / "out" / name))


def play(folder: Path, script: str, timeout: float = 60.0, **options: Any) -> dict[str, Any]:
    return run(Plan(script, out=str(folder / "out"), count=True, **options), timeout)


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


def test_steps_come_in_their_order(tmp_path: Path) -> None:
    events = events_from("a", "special 101;mouse 0 1 10 20;motion 11 21;menu 5;reshape 60 40;tick")
    record = play(tmp_path, program(tmp_path, LOG), events=events)
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


def test_without_idle_and_events_time_jumps_to_the_timer(tmp_path: Path) -> None:
    script = program(
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


def test_pictures_are_the_same_each_time(tmp_path: Path) -> None:
    script = program(
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


def test_any_program_is_shaded_otherwise_and_resized(tmp_path: Path) -> None:
    script = program(tmp_path, LIT)
    pictures = {}
    for shade in ("flat", "smooth", "phong"):
        assert play(tmp_path, script, shade=shade, size=(100, 100))["status"] == "ok"
        pictures[shade] = picture(tmp_path)
        assert pictures[shade].shape == (100, 100, 3)
    colours = {shade: len(np.unique(image.reshape(-1, 3), axis=0)) for shade, image in pictures.items()}
    assert colours["flat"] < 30 < colours["smooth"]
    apart = np.abs(pictures["phong"].astype(int) - pictures["smooth"])
    assert apart.max() > 40, "the highlight is inside of a face"


def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    gif = tmp_path / "all.gif"
    words = ["--out", str(tmp_path / "out"), "--keys", "ab", "--gif", str(gif), "--json"]
    code = main(["run", program(tmp_path, LOG), *words])
    said = json.loads(capsys.readouterr().out)
    assert code == 0, said
    assert (said["status"], said["frames"]) == ("ok", 3)
    assert Image.open(gif).n_frames >= 2


def test_command_line_arguments_go_to_the_program(tmp_path: Path) -> None:
    text = "open('log.txt', 'w').write(repr(sys.argv[1:]))\nglutDisplayFunc(lambda: None)\nglutMainLoop()\n"
    script = program(tmp_path, text)
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


def test_an_exception_is_the_scripts(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    script = program(tmp_path, "def display():\n    glBegin(GL_LIGHTING)\nglutDisplayFunc(display)\nglutMainLoop()\n")
    record = play(tmp_path, script)
    assert record["status"] == "gl-error"
    assert record["errors"][0]["line"] == len(WINDOW.splitlines()) + 2
    said = capfd.readouterr().err
    assert "glBegin(GL_LIGHTING)" in said
    assert "glsim/" not in said.replace("program.py", "")


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
    record = play(tmp_path, program(tmp_path, text), frames=3)
    assert (record["status"], record["frames"]) == (status, frames), record


def test_an_endless_loop_is_stopped_and_its_pictures_are_there(tmp_path: Path) -> None:
    text = "def idle():\n    while True: pass\nglutDisplayFunc(glutSwapBuffers)\nglutIdleFunc(idle)\nglutMainLoop()\n"
    started = time.monotonic()
    record = play(tmp_path, program(tmp_path, text), timeout=4.0, frames=5)
    assert time.monotonic() - started < 10
    assert (record["status"], record["pictures"]) == ("timeout", ["frame_000.png"])
    assert picture(tmp_path).shape == (80, 120, 3)


def test_interrupting(tmp_path: Path) -> None:
    text = "glutDisplayFunc(glutSwapBuffers)\nglutIdleFunc(lambda: open('here', 'w').close())\nglutMainLoop()\n"
    script = program(tmp_path, text)
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


# ---------------------------------------------------------------- what programs import


def test_imports_of_all_kinds(tmp_path: Path) -> None:
    script = program(
        tmp_path,
        """
        import OpenGL
        OpenGL.ERROR_CHECKING = False
        from OpenGL import GL, GLU, GLUT
        import OpenGL.GL as gl
        from OpenGL.GL.ARB.multitexture import *
        from OpenGL.GL.EXT.fog_coord import glInitFogCoordEXT, glFogCoordfEXT
        from OpenGL.arrays import vbo
        from OpenGL.error import GLError, GLUError
        from OpenGL.constants import GLfloat
        import numpy
        assert gl.GL_LIGHT0 is GL.GL_LIGHT0 and glInitMultitextureARB() and glInitFogCoordEXT()
        assert GL_TEXTURE1_ARB == GL.GL_TEXTURE1
        corners = vbo.VBO(numpy.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0)], 'f'))
        def display():
            glClear(GL_COLOR_BUFFER_BIT)
            glActiveTextureARB(GL_TEXTURE0_ARB)
            corners.bind()
            glEnableClientState(GL_VERTEX_ARRAY)
            glVertexPointerf(corners)
            glDrawArrays(GL_TRIANGLES, 0, 3)
            try:
                glEnable(12345)
            except GLError as error:
                assert error.err == GL_INVALID_ENUM
            glutSwapBuffers()
        glutDisplayFunc(display)
        glutMainLoop()
        """,
    )
    record = play(tmp_path, script)
    assert record["status"] == "ok", record
    assert picture(tmp_path)[60, 100].tolist() == [255, 255, 255]


PYTHON_2 = b"import sys\nprint 'angle', 7/2\nif sys.maxint > 0 and {}.has_key(1):\n\tpass\nraise ValueError, 'no'\n"


def test_python_2_is_recognized_and_converted() -> None:
    assert not is_python_3(PYTHON_2, "old.py")
    assert is_python_3(b"print('new')", "new.py")
    text = converted(PYTHON_2, "old.py")
    assert "print('angle', 7/2)" in text
    assert "1 in {}" in text


def test_python_2_programs_run(tmp_path: Path) -> None:
    old = "print 'old'\ndef display():\n\tglClearColor(1, 0, 0, 1)\n\tglClear(GL_COLOR_BUFFER_BIT)\n"
    old += "\tglutSwapBuffers()\n"
    script = program(tmp_path, old + "glutDisplayFunc(display)\nglutMainLoop()\n")
    record = play(tmp_path, script)
    assert record["status"] == "ok"
    assert "converted from Python 2" in record["notes"][0]
    assert picture(tmp_path)[0, 0].tolist() == [255, 0, 0]
    assert play(tmp_path, script, python2=False)["status"] == "python-error"


def test_compare_takes_a_program(tmp_path: Path) -> None:
    from glsim import compare

    sheet = compare(program(tmp_path, LIT), modes=["wireframe", "flat", "phong"], lobes=["blinn"])
    assert sheet.images["blinn", "flat"].shape == (80, 120, 3)
    assert sheet.difference("blinn", "phong").max() > 20
    with pytest.raises(ValueError, match="gives no picture"):
        compare(program(tmp_path, "raise ValueError('no')"), modes=["flat"], lobes=["blinn"])


# ---------------------------------------------------------------- other window libraries


def test_pygame_programs(tmp_path: Path) -> None:
    pytest.importorskip("pygame")
    script = program(
        tmp_path,
        """
        import pygame
        from OpenGL.GL import *
        pygame.init()
        pygame.display.set_mode((90, 60), pygame.DOUBLEBUF | pygame.OPENGL)
        clock, color = pygame.time.Clock(), (1, 0, 0)
        while True:
            for event in pygame.event.get():
                if event.type == pygame.KEYDOWN and event.unicode == "g":
                    color = (0, 1, 0)
            glClearColor(*color, pygame.time.get_ticks() / 255)
            glClear(GL_COLOR_BUFFER_BIT)
            pygame.display.flip()
            clock.tick(60)
        """,
        front="",
    )
    record = play(tmp_path, script, frames=3, events=["tick", "key g"])
    assert (record["status"], record["frames"]) == ("ok", 3)
    assert [picture(tmp_path, f"frame_00{k}.png")[5, 5].tolist() for k in (1, 2)] == [[255, 0, 0], [0, 255, 0]]
    assert picture(tmp_path).shape == (60, 90, 3)


def test_glfw_programs(tmp_path: Path) -> None:
    pytest.importorskip("glfw")
    script = program(
        tmp_path,
        """
        import glfw
        from OpenGL.GL import *
        glfw.init()
        window = glfw.create_window(90, 60, "test", None, None)
        glfw.make_context_current(window)
        keys = []
        glfw.set_key_callback(window, lambda w, key, scancode, action, mods: keys.append(key))
        while not glfw.window_should_close(window):
            glViewport(0, 0, *glfw.get_framebuffer_size(window))
            glClearColor(len(keys) / 2, glfw.get_time(), 0, 1)
            glClear(GL_COLOR_BUFFER_BIT)
            glfw.swap_buffers(window)
            glfw.poll_events()
        """,
        front="",
    )
    assert play(tmp_path, script, frames=3, events=["key g"])["status"] == "ok"
    assert [picture(tmp_path, f"frame_00{k}.png")[5, 5, 0] for k in range(3)] == [0, 255, 255]
    assert picture(tmp_path, "frame_002.png")[5, 5, 1] == 10


def test_without_a_display_a_program_is_told_what_to_do(tmp_path: Path) -> None:
    pytest.importorskip("glfw")
    text = "import glsim.glut as glut\nglut.glutInit()\nglut.glutCreateWindow('x')\nglut.glutMainLoop()\n"
    environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    words = [sys.executable, "-c", text]
    said = subprocess.run(words, env=environment, capture_output=True, text=True, cwd=ROOT).stderr
    assert "glsim run SCRIPT needs none" in said


def test_python_2_programs_keep_their_keys_their_division_and_their_modules(tmp_path: Path) -> None:
    (tmp_path / "helper.py").write_text("print 'helper'\nhalf = 3 / 2\n")
    old = textwrap.dedent("""
        import string, Image, helper
        log = open("log.txt", "w")
        print >>log, 7 / 2, 7.0 / 2, -7 / 2, helper.half, string.join(["a", "b"]), Image.new("RGB", (2, 2)).size
        n = 9
        n /= 2
        print >>log, n
        def key(c, x, y):
            print >>log, c == 'a', c in 'abc'
            log.flush()
        glutKeyboardFunc(key)
        glutDisplayFunc(lambda: None)
        glutMainLoop()
        """)
    record = play(tmp_path, program(tmp_path, old), events=["key a"])
    assert record["status"] == "ok", record
    assert (tmp_path / "log.txt").read_text().splitlines() == ["3 3.5 -4 1 a b (2, 2)", "4", "True True"]


def test_modules_of_python_2_beside_a_program_of_python_3_are_converted(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "__init__.py").write_text("")
    (tmp_path / "parts" / "deep.py").write_text("import string\nprint 'deep'\nletters = string.join(['a', 'b'], '')\n")
    (tmp_path / "helper.py").write_text("print 'helper'\nhalf = 3 / 2\n")
    new = "import helper\nfrom parts import deep\nprint(helper.half, 3 / 2, deep.letters, file=open('log.txt', 'w'))\n"
    new += "glutDisplayFunc(lambda: None)\nglutMainLoop()\n"
    record = play(tmp_path, program(tmp_path, new))
    assert record["status"] == "ok", record
    assert (tmp_path / "log.txt").read_text() == "1 1.5 ab\n"
    assert play(tmp_path, program(tmp_path, new), python2=False)["status"] == "python-error"


def test_arrays_of_characters_are_pixels(tmp_path: Path) -> None:
    """Python 2's array("c"), filled by chr and drawn."""
    old = textwrap.dedent("""
        from array import array
        print 'old'
        pixels = array("c", "\\0" * 12)
        for k in range(4):
            pixels[3 * k] = chr(255)
        pixels[4:6] = array('c', 'ab')
        pixels.append('z')
        print pixels[1] == '\\0', len(pixels), pixels.tostring()[4:6], pixels[4:6] == array('c', 'ab')
        def display():
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
            glDrawPixels(2, 2, GL_RGB, GL_UNSIGNED_BYTE, pixels)
            glutSwapBuffers()
        glutDisplayFunc(display)
        glutMainLoop()
        """)
    record = play(tmp_path, program(tmp_path, old))
    assert record["status"] == "ok", record
    lit = picture(tmp_path)[..., 0].nonzero()
    assert len(lit[0]) == 4


def test_a_display_function_that_never_returns_leaves_its_picture(tmp_path: Path) -> None:
    text = "import time\nreal = time.sleep\ndef display():\n    while True:\n        glClear(GL_COLOR_BUFFER_BIT)\n"
    text += "        glutSwapBuffers()\nglutDisplayFunc(display)\nglutMainLoop()\n"
    record = play(tmp_path, program(tmp_path, text), timeout=6.0)
    assert (record["status"], record["pictures"]) == ("timeout", ["frame_000.png"])


def test_later_versions_can_be_asked_for(tmp_path: Path) -> None:
    script = program(
        tmp_path,
        """
        import numpy
        assert not bool(glCreateShader) and not glGenFramebuffers
        assert b"GL_ARB_multitexture" in glGetString(GL_EXTENSIONS) and glutExtensionSupported("GL_ARB_multitexture")
        glTexImage2Dub(GL_TEXTURE_2D, 0, GL_RGB, 0, GL_RGB, numpy.zeros((8, 4, 3), "u1"))
        assert glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == 8
        glWindowPos2i(0, 0)
        glDrawPixelsf(GL_LUMINANCE, numpy.ones((3, 3), "f"))
        assert glReadPixelsub(0, 0, 1, 1, GL_RGB) == b"\\xff" * 3
        glCreateShader(GL_VERTEX_SHADER)
        """,
    )
    record = play(tmp_path, script)
    assert record["errors"][0]["error"].startswith("RuntimeError: glCreateShader came with OpenGL 2.0")
