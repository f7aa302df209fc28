"""What type checkers and editors know: a student's program with star imports, and its mistakes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from glsim import gl, glu, glut

ROOT = Path(__file__).resolve().parents[2]

PROGRAM = """
import sys
from math import cos, sin

from glsim.gl import *
from glsim.glu import *
from glsim.glut import *

angle: float = 0.0
quadric = gluNewQuadric()
texture = glGenTextures(1)


def reshape(width: int, height: int) -> None:
    glViewport(0, 0, width, height)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(45, width / max(height, 1), 1, 20)
    glMatrixMode(GL_MODELVIEW)


def display() -> None:
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    gluLookAt(0, 2, 5, 0, 0, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, (1, 2, 3, 0))
    glLight(GL_LIGHT0, GL_DIFFUSE, [1, 1, 1, 1])
    glDepthMask(GL_FALSE)
    glRotatef(angle, 0, 1, 0)
    glBegin(GL_TRIANGLES)
    for k in range(3):
        glNormal3f(0, 0, 1)
        glTexCoord2f(cos(k), sin(k))
        glVertex3fv([cos(2 * k), sin(2 * k), 0])
    glEnd()
    gluSphere(quadric, 1.0, 20, 16)
    glutSolidTeapot(0.5)
    glutBitmapCharacter(GLUT_BITMAP_HELVETICA_18, ord("a"))
    x, y, z = gluProject(0, 0, 0)
    print(glGetFloatv(GL_MODELVIEW_MATRIX)[0][0], x, y, z, glGetString(GL_VERSION), gluErrorString(glGetError()))
    numbers = (GLfloat * 4)(1, 2, 3, 4)
    glColor4fv(numbers)
    glDeleteTextures([texture])
    glutSwapBuffers()


def keyboard(key: bytes, x: int, y: int) -> None:
    if key == b"q":
        glutLeaveMainLoop()


def timer(value: int) -> None:
    global angle
    angle += 2
    glutPostRedisplay()
    glutTimerFunc(20, timer, value + 1)


glutInit(sys.argv)
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
glutInitWindowSize(400, 300)
glutCreateWindow("student")
glEnable(GL_LIGHTING)
glShadeModel(GL_PHONG_WIN)
glutDisplayFunc(display)
glutReshapeFunc(reshape)
glutKeyboardFunc(keyboard)
glutTimerFunc(20, timer, 0)
try:
    glutMainLoop()
except GLError as error_:
    print(error_)
"""
MISTAKES = ['glVertex3f("1", 0, 0)', "glEnable(GL_LIGHTNING)", "glVertex3(0, 0, 0)", "gluPerspective(45, 1)"]


def mypy(path: Path) -> list[str]:
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(path.parent / "cache"), str(path)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    return [line for line in done.stdout.splitlines() if ": error:" in line and path.name in line]


def pyright(path: Path) -> list[str]:
    pytest.importorskip("pyright")
    command = [sys.executable, "-m", "pyright", "--outputjson", "--pythonpath", sys.executable, str(path)]
    (path.parent / "pyrightconfig.json").write_text(json.dumps({"extraPaths": [str(ROOT)]}))
    done = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, check=False)
    found = json.loads(done.stdout)["generalDiagnostics"]
    return [f"{one['range']['start']['line'] + 1}: {one['message']}" for one in found if one["severity"] == "error"]


@pytest.mark.parametrize("checker", [mypy, pyright])
@pytest.mark.slow
def test_a_students_program_is_typed(checker: object, tmp_path: Path) -> None:
    assert callable(checker)
    (tmp_path / "student.py").write_text(PROGRAM)
    assert checker(tmp_path / "student.py") == []
    lines = PROGRAM.count("\n")
    (tmp_path / "student.py").write_text(PROGRAM + "\n".join(MISTAKES) + "\n")
    found = checker(tmp_path / "student.py")
    assert len(found) == len(MISTAKES), found
    assert all(any(str(lines + k) in line for line in found) for k in range(1, len(MISTAKES) + 1))


def test_the_package_says_that_it_is_typed() -> None:
    assert (ROOT / "glsim" / "py.typed").exists()


@pytest.mark.parametrize("module", [gl, glu, glut])
def test_stubs_name_what_a_star_import_binds(module: object) -> None:
    text = Path(str(module.__file__)).with_suffix(".pyi").read_text()  # type: ignore[attr-defined]
    names = text[text.index("__all__ = [") :].partition("]")[0].split('"')[1::2]
    assert sorted(names) == sorted(module.__all__)  # type: ignore[attr-defined]
