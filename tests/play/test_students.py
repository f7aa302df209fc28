"""Programs as students write them: what they rely on without knowing, and what goes wrong in them."""

from __future__ import annotations

import json
import textwrap
from pathlib import Path

import pytest
from PIL import Image

from glsim.cli import main
from glsim.glut.loop import key
from glsim.play.run import animate, events_from
from tests.drawing import picture
from tests.drawing import play_text as play

pytestmark = pytest.mark.slow  # each test runs programs in processes of their own

IMPORTS = "from OpenGL.GL import *\nfrom OpenGL.GLU import *\nfrom OpenGL.GLUT import *\n"
WINDOW = IMPORTS + "glutInit()\nglutInitWindowSize(60, 40)\nglutCreateWindow(b'w')\nglutDisplayFunc(lambda: None)\n"


# ---------------------------------------------------------------- names from star imports


def test_escape_ends_the_program_by_a_sys_that_was_never_imported(tmp_path: Path) -> None:
    text = WINDOW + "def key(k, x, y):\n    if k == b'\\x1b': sys.exit(0)\nglutKeyboardFunc(key)\nglutMainLoop()\n"
    record = play(tmp_path, text, events=["key 0x1B"])
    assert (record["status"], record["errors"]) == ("ok", [])
    assert "the script exited in keyboard" in record["notes"]


def test_other_modules_and_errors_from_star_imports(tmp_path: Path) -> None:
    text = """
    os.path.join("a", "b"); ctypes.c_float(1); traceback.format_exc(); logging.getLogger(); platform.PLATFORM
    print(GLDEBUGPROC, GLfloat_3, GLvoidp, file=sys.stderr)
    try:
        glEnable(GL_TRIANGLES)
    except error.GLError as problem:
        print("caught", problem.err, file=open("caught", "w"))
    glutMainLoop()
    """
    record = play(tmp_path, WINDOW + textwrap.dedent(text))
    assert record["errors"] == []
    assert (tmp_path / "caught").read_text().startswith("caught")


def test_glsims_own_star_imports_bind_them_too(tmp_path: Path) -> None:
    text = """
    from glsim.gl import *
    from glsim.glut import *
    import glsim
    screen = glsim.offscreen(8, 8)
    try:
        glEnable(GL_TRIANGLES)
    except error.GLError:
        sys.exit(0)
    """
    record = play(tmp_path, text)
    assert (record["errors"], record["notes"]) == ([], ["the script called sys.exit"])


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("glEnable(GL_LIGHTNING)", "GL_LIGHTING"),
        ("glVertex3(0, 0, 0)", "glVertex3f"),
        ("glutSolidTeepot(1)", "glutSolidTeapot"),
        ("from OpenGL.GL import GL_DEPTH_TESTS", "GL_DEPTH_TEST"),
    ],
)
def test_misspelt_names_get_a_suggestion(
    line: str, meant: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    record = play(tmp_path, WINDOW + line + "\n")
    assert f"did you mean '{meant}'?" in record["errors"][0]["error"]
    assert f"did you mean '{meant}'?" in capfd.readouterr().err


def test_typed_images_of_three_dimensions_and_stipples(tmp_path: Path) -> None:
    text = """
    import numpy
    image = numpy.arange(2 * 4 * 8 * 3, dtype="u1").reshape(2, 4, 8, 3)
    glTexImage3Dub(GL_TEXTURE_3D, 0, GL_RGB, 0, GL_RGB, image)
    for length, name in ((2, GL_TEXTURE_WIDTH), (4, GL_TEXTURE_HEIGHT), (8, GL_TEXTURE_DEPTH)):
        assert glGetTexLevelParameteriv(GL_TEXTURE_3D, 0, name) == length
    glTexSubImage3Df(GL_TEXTURE_3D, 0, 0, 0, 0, GL_RGB, numpy.ones((2, 4, 8, 3), "f"))
    assert glGetPolygonStippleub().tolist() == [255] * 128
    glEdgeFlagPointerb(numpy.ones(3, "u1"))
    """
    assert play(tmp_path, WINDOW + textwrap.dedent(text))["errors"] == []


# ---------------------------------------------------------------- mistakes of syntax

BROKEN = {
    "a missing bracket": ("glClearColor(0, 0, 0, 1\nglClear(GL_COLOR_BUFFER_BIT)\n", 1, "was never closed"),
    "a missing colon": ("x = 1\nif x\n    x = 2\n", 2, "expected ':'"),
    "a missing quote": ("x = 1\nprint('hello)\n", 2, "unterminated string literal"),
    "a bad indent": ("def f():\n    x = 1\n      y = 2\n", 3, "unexpected indent"),
    "a lost indent": ("def f():\nreturn 1\n", 2, "expected an indented block"),
    "tabs and spaces": ("if True:\n        x = 1\n\ty = 2\n", 3, "inconsistent use of tabs and spaces"),
    "a call without brackets": ("def f:\n    pass\n", 1, "expected '('"),
    "return outside of a function": ("x = 1\nreturn x\n", 2, "'return' outside function"),
    "an assignment for a comparison": ("x = 1\nif x = 2:\n    pass\n", 2, "Maybe you meant '=='"),
}


@pytest.mark.parametrize("what", BROKEN)
def test_a_mistake_of_syntax_is_told_in_pythons_words(
    what: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    text, line, words = BROKEN[what]
    (tmp_path / "program.py").write_text(text)
    assert main(["run", str(tmp_path / "program.py"), "--json", "--out", str(tmp_path / "out")]) == 1
    out, err = capfd.readouterr()
    record = json.loads(out)
    assert record["errors"][0]["line"] == line
    assert words in record["errors"][0]["error"]
    assert f'program.py", line {line}' in err
    assert words in err


@pytest.mark.parametrize("what", BROKEN)
def test_so_it_is_in_a_module_beside_the_program(what: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    text, line, words = BROKEN[what]
    (tmp_path / "helper.py").write_text(text)
    record = play(tmp_path, "x = 1\nimport helper\n")
    assert record["errors"][0]["line"] == 2
    assert words in record["errors"][0]["error"]
    assert f'helper.py", line {line}' in capfd.readouterr().err


def test_what_only_python_2_takes_is_converted(tmp_path: Path) -> None:
    (tmp_path / "helper.py").write_text("def half(n):\n    print 'half', n\n    return n / 2\n")
    record = play(tmp_path, "import helper\nassert helper.half(3) == 1\nassert 3 / 2 == 1.5\n")
    assert record["errors"] == []


# ---------------------------------------------------------------- names of modules

SHADOWED = (
    "random", "json", "types", "copy", "numbers", "tempfile", "time", "string", "queue", "datetime", "signal", "math",
    "enum", "struct", "io", "typing", "inspect", "platform", "logging", "numpy", "PIL", "rich",
)  # fmt: skip


def test_a_students_modules_may_have_the_names_of_pythons(tmp_path: Path) -> None:
    for name in SHADOWED:
        (tmp_path / f"{name}.py").write_text(f"MINE = '{name}'\n")
    (tmp_path / "scene.py").write_text("import random, types\nfrom copy import MINE\nassert random.MINE == 'random'\n")
    text = "".join(f"import {name}; assert {name}.MINE == '{name}'\n" for name in SHADOWED)
    text += "from random import MINE\nimport scene\n" + WINDOW + "glutSolidTeapot(1)\nglutMainLoop()\n"
    record = play(tmp_path, text)
    assert (record["status"], record["errors"]) == ("ok", [])


def test_such_a_module_may_use_pythons_of_another_name_and_fail_as_itself(tmp_path: Path) -> None:
    (tmp_path / "random.py").write_text("import math\nTAU = math.tau\nraise RuntimeError('mine')\n")
    record = play(tmp_path, "import random\n")
    assert record["errors"][0]["error"] == "RuntimeError: mine"
    assert play(tmp_path, "import random\nassert random.random\n", name="random.py")["errors"] == []


def test_own_packages_are_found(tmp_path: Path) -> None:
    (tmp_path / "types").mkdir()
    (tmp_path / "types" / "__init__.py").write_text("from . import shapes\n")
    (tmp_path / "types" / "shapes.py").write_text("N = 3\n")
    (tmp_path / "model").mkdir()
    (tmp_path / "model" / "__init__.py").write_text("")
    (tmp_path / "model" / "cube.py").write_text("from . import __name__ as n\nimport random\nrandom.random()\n")
    text = """
    import types
    import types.shapes
    from types import shapes
    from model.cube import n
    assert types.shapes.N == shapes.N == 3 and n == "model"
    """
    record = play(tmp_path, text)
    assert record["errors"] == []


# ---------------------------------------------------------------- time and chance


def test_time_stands_still_for_own_files_and_runs_for_libraries(tmp_path: Path) -> None:
    (tmp_path / "clock.py").write_text("import time, datetime\nnow = time.time\nday = datetime.date.today\n")
    text = """
    import datetime, queue, threading, time
    from datetime import datetime as Moment
    import clock
    assert time.time() == clock.now() == 1e9 and time.time_ns() == 10**18 and time.monotonic() == 0.0
    time.sleep(2.5)
    assert time.perf_counter() == 2.5 and clock.now() == 1e9 + 2.5
    moment = Moment.now()
    assert moment == datetime.datetime.fromtimestamp(1e9 + 2.5)
    assert isinstance(moment, datetime.datetime) and issubclass(Moment, datetime.date)
    assert Moment(2020, 1, 2) - datetime.timedelta(days=1) == Moment(2020, 1, 1)
    assert clock.day() == moment.date()
    assert Moment.utcnow() == Moment.fromtimestamp(1e9 + 2.5, datetime.UTC).replace(tzinfo=None)
    try:
        queue.Queue().get(timeout=0.05)  # waits on the real clock
    except queue.Empty:
        pass
    assert not threading.Event().wait(0.05)
    """
    record = play(tmp_path, text, timeout=30.0)
    assert record["status"] == "no-window", record


def test_random_numbers_repeat_also_after_seed_without_a_number(tmp_path: Path) -> None:
    text = """
    import random, numpy
    random.seed(); numpy.random.seed()
    numbers = [random.random(), random.Random().random(), numpy.random.rand(), numpy.random.default_rng().random()]
    print(*numbers, file=open("numbers", "a"))
    """
    for _ in range(2):
        assert play(tmp_path, text)["errors"] == []
    first, second = (tmp_path / "numbers").read_text().splitlines()
    assert first == second


def test_pandas(tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    text = (
        WINDOW
        + "import pandas, datetime\nassert pandas.Timestamp(datetime.datetime.now()).year == 2001\nglutMainLoop()\n"
    )
    record = play(tmp_path, text)
    assert (record["status"], record["errors"]) == ("ok", [])


# ---------------------------------------------------------------- what is left behind


def test_pictures_of_an_earlier_run_go_and_the_users_stay(tmp_path: Path) -> None:
    loop = WINDOW + "glutIdleFunc(glutPostRedisplay)\nglutMainLoop()\n"
    assert len(play(tmp_path, loop, frames=4)["pictures"]) == 4
    Image.new("RGB", (4, 4)).save(tmp_path / "out" / "frame_777.png")
    (tmp_path / "out" / "frame_778.png").write_bytes(b"no picture")
    play(tmp_path, loop, frames=2)
    left = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert left == ["frame_000.png", "frame_001.png", "frame_777.png", "frame_778.png"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--gif", "x.png"], "--gif x.png: the name must end in .gif"),
        (["--gif", "x.exe"], "--gif x.exe: the name must end in .gif"),
        (["--mp4", "x.gif"], "--mp4 x.gif: the name must end in .mp4"),
        (["--gif", "nowhere/x.gif"], "--gif nowhere/x.gif: there is no folder nowhere; make it first"),
    ],
)
def test_animations_of_other_kinds_are_refused_before_the_program_runs(
    words: list[str], sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("program.py").write_text("open('ran', 'w')\n")
    assert main(["run", "program.py", *words]) == 1
    assert sentence in capfd.readouterr().err
    assert not Path("ran").exists()
    assert not list(tmp_path.glob("x.*"))


def test_mp4_of_one_pixel_is_refused(tmp_path: Path) -> None:
    Image.new("RGB", (1, 1)).save(tmp_path / "one.png")
    with pytest.raises(ValueError, match=r"x\.mp4: pictures of 1 x 1 are too small for MP4"):
        animate([tmp_path / "one.png"], tmp_path / "x.mp4")
    assert not (tmp_path / "x.mp4").exists()


def test_a_timeout_says_where_the_program_hung(tmp_path: Path) -> None:
    record = play(tmp_path, "import time\ndef wait():\n    while True:\n        x = 1\n\nwait()\n", timeout=1.5)
    assert record["status"] == "timeout"
    assert record["notes"][-1] in [
        f"stopped after 1.5 seconds (--timeout), in line {line} of program.py" for line in (3, 4)
    ]


def test_pictures_that_cannot_be_written(tmp_path: Path) -> None:
    text = WINDOW + "import shutil, os\nshutil.rmtree(OUT)\nglutMainLoop()\n"
    record = play(tmp_path, text.replace("OUT", repr(str(tmp_path / "out"))))
    assert record["status"] == "python-error"
    assert "frame_000.png cannot be written to" in record["errors"][0]["error"]


# ---------------------------------------------------------------- what a student trips over


def test_a_picture_that_was_swapped_before_the_program_hung_is_kept(tmp_path: Path) -> None:
    text = """
    def display():
        glClearColor(1, 0, 0, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        glutSwapBuffers()
        while True:
            pass
    glutDisplayFunc(display)
    glutMainLoop()
    """
    front = WINDOW.replace("glutInit()", "glutInit()\nglutInitDisplayMode(GLUT_DOUBLE)")
    record = play(tmp_path, front + textwrap.dedent(text), timeout=4.0)
    assert record["status"] == "timeout"
    assert record["pictures"] == ["frame_000.png"]
    assert picture(tmp_path)[0, 0].tolist() == [255, 0, 0]


def test_a_begin_that_is_never_ended(tmp_path: Path) -> None:
    text = "def display():\n    glBegin(GL_TRIANGLES)\n    glVertex2f(0, 0)\nglutDisplayFunc(display)\nglutMainLoop()\n"
    record = play(tmp_path, WINDOW + text)
    assert record["status"] == "gl-error"
    assert record["errors"][0]["error"].startswith("glBegin(GL_TRIANGLES) is never ended: glEnd is missing")


def test_a_display_function_that_was_called_instead_of_passed(tmp_path: Path) -> None:
    record = play(tmp_path, WINDOW + "def display(): pass\nglutDisplayFunc(display())\n")
    assert (
        "glutDisplayFunc: a function is needed, not None: write glutDisplayFunc(display), not"
        in (record["errors"][0]["error"])
    )


def test_a_program_that_imports_glut_is_told_of_glutcreatewindow(tmp_path: Path) -> None:
    record = play(tmp_path, IMPORTS + "glClearColor(1, 1, 1, 1)\n")
    assert "call glutCreateWindow before the first gl command" in record["errors"][0]["error"]


@pytest.mark.parametrize(
    ("word", "code"), [("a", b"a"), ("esc", b"\x1b"), ("space", b" "), ("0x41", b"A"), ("enter", b"\r")]
)
def test_keys_have_names(word: str, code: bytes) -> None:
    assert key(word) == code
    assert events_from("", f"key {word}") == [f"key {word}"]


@pytest.mark.parametrize("word", ["ab", "0x100", "0xZZ", "€"])
def test_keys_that_there_are_not(word: str) -> None:
    with pytest.raises(ValueError, match=r'--events "key .*": a key is one character, esc, '):
        events_from("", f"key {word}")


def test_native_has_no_depth_buffer_where_the_window_has_none(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    text = """
    def display():
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        glColor3f(1, 0, 0); glRectf(-0.9, -0.9, 0.9, 0.9)
        glTranslatef(0, 0, 0.5)
        glColor3f(0, 1, 0); glRectf(-0.5, -0.5, 0.5, 0.5)  # behind the red one
        glutSwapBuffers()
    glEnable(GL_DEPTH_TEST)
    glutDisplayFunc(display)
    glutMainLoop()
    """
    front = WINDOW.replace("glutInit()", "glutInit()\nglutInitDisplayMode(GLUT_DOUBLE)")
    (tmp_path / "program.py").write_text(front + textwrap.dedent(text))
    words = ["--modes", "gouraud,native", "--lobe", "blinn", "-o", str(tmp_path / "sheet.png"), "--json"]
    assert main(["compare", str(tmp_path / "program.py"), *words]) == 0
    assert [row["max"] for row in json.loads(capfd.readouterr().out)["differences"]] == [0, 0]
