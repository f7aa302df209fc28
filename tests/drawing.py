"""What many tests share: things to draw, pictures, recorded frames, and programs that run."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from glsim.gl import *
from glsim.machine.frame import Frame
from glsim.play.capture import capture
from glsim.play.plan import Plan
from glsim.play.run import run

ROOT = Path(__file__).resolve().parents[1]

# ---------------------------------------------------------------- things to draw


def camera(distance: float = 3.0) -> None:
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glFrustum(-0.4, 0.4, -0.4, 0.4, 1.0, 20.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glTranslatef(0.0, 0.0, -distance)
    glEnable(GL_DEPTH_TEST)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)


def lamp(light: int = GL_LIGHT0, position: tuple[float, ...] = (2.0, 2.0, 3.0, 1.0), **parameters: object) -> None:
    glEnable(GL_LIGHTING)
    glEnable(light)
    glPushMatrix()
    glLoadIdentity()
    glLightfv(light, GL_POSITION, position)
    glPopMatrix()
    for name, value in parameters.items():
        glLight(light, globals()["GL_" + name.upper()], value)


def lit() -> None:
    """The default light on and buffers cleared, as most programs begin."""
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for capability in (GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST):
        glEnable(capability)


def material(face: int = GL_FRONT_AND_BACK, **parameters: object) -> None:
    for name, value in parameters.items():
        glMaterial(face, globals()["GL_" + name.upper()], value)


SHINY = dict(ambient=(0.1, 0.1, 0.1, 1), diffuse=(0.7, 0.3, 0.2, 1), specular=(0.6, 0.6, 0.6, 1), shininess=20.0)


QUAD = ((0, 0), (1, 0), (1, 1), (0, 1))
TWO_TRIANGLES = (QUAD[0], QUAD[1], QUAD[2], QUAD[0], QUAD[2], QUAD[3])


def ball(slices: int = 20, stacks: int = 14, radius: float = 1.0, scale: float = 1.0, mode: int = GL_QUADS) -> None:
    """A sphere with normals of length ``scale``.

    Mesa cuts a quad along v0-v2, but along v1-v3 if it must be clipped or has two sides: for those, GL_TRIANGLES.
    """

    def point(i: int, j: int) -> tuple[float, float, float]:
        theta, phi = math.pi * i / stacks, 2 * math.pi * j / slices
        return math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi)

    glBegin(mode)
    for i in range(stacks):
        for j in range(slices):
            for a, b in QUAD if mode == GL_QUADS else TWO_TRIANGLES:
                x, y, z = point(i + a, j + b)
                glNormal3f(x * scale, y * scale, z * scale)
                glVertex3f(x * radius, y * radius, z * radius)
    glEnd()


def wheel(inside: Callable[[int], None], mode: int = GL_TRIANGLE_STRIP) -> None:
    """A lit ring; ``inside(k)`` is called before each pair of vertices."""
    glBegin(mode)
    for k in range(25):
        a = k * math.pi / 12
        inside(k)
        glNormal3f(0.4 * math.cos(a), 0.4 * math.sin(a), 0.83)
        glVertex3f(math.cos(a), math.sin(a), 0)
        glVertex3f(0.4 * math.cos(a), 0.4 * math.sin(a), 0.3)
    glEnd()


def pixel_coordinates(shift: float) -> None:
    """A coordinate system of pixels, as two-dimensional programs use it."""
    glClear(GL_COLOR_BUFFER_BIT)
    glOrtho(0, 128, 0, 128, -1, 1)
    glTranslatef(shift, shift, 0)


def portions(count: int) -> list[Any]:
    """For parametrize, where a long test is cut into ``count`` portions: the first is quick, the others are slow."""
    return [0, *(pytest.param(k, marks=pytest.mark.slow) for k in range(1, count))]


# ---------------------------------------------------------------- recorded frames


def captured(draw: Callable[[], Any]) -> Frame:
    """The Frame of what ``draw`` draws into the current context, with its calls."""
    with capture(calls=True) as frame:
        draw()
    return frame


def fed_back(draw: Callable[[], Any]) -> list[NDArray[np.float64]]:
    """The polygons that are drawn, as points (n, 3) in object coordinates."""
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(-2, 2, -2, 2, -2, 2)
    glMatrixMode(GL_MODELVIEW)
    glFeedbackBuffer(500_000, GL_3D)
    glRenderMode(GL_FEEDBACK)
    draw()
    polygons = []
    for token, *vertices in glRenderMode(GL_RENDER):
        assert token == GL_POLYGON_TOKEN
        polygons.append(np.array([v.vertex[:3] for v in vertices]) * [4 / 128, 4 / 128, -4] + [-2, -2, 2])
    return polygons


# ---------------------------------------------------------------- programs that run


def python(
    *words: str, cwd: Path | None = None, seconds: float = 120, **environment: str
) -> subprocess.CompletedProcess[str]:
    """An interpreter of its own, with this checkout's glsim: ``python("-c", "import glsim")``."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), **environment}
    return subprocess.run(
        [sys.executable, *words], cwd=cwd, env=environment, capture_output=True, text=True, check=False, timeout=seconds
    )


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


def program_file(folder: Path, text: str, front: str = WINDOW, name: str = "program.py") -> str:
    """The path of a program that is ``front`` and then ``text``, which may be indented."""
    (folder / name).write_text(front + textwrap.dedent(text), encoding="utf-8")
    return str(folder / name)


def play(folder: Path, script: str, timeout: float = 60.0, **options: Any) -> dict[str, Any]:
    """The report of ``glsim run``; the pictures are in folder/out."""
    return run(Plan(script, out=str(folder / "out"), count=True, **options), timeout)


def play_text(
    folder: Path, text: str, name: str = "program.py", timeout: float = 60.0, **options: Any
) -> dict[str, Any]:
    """As ``play``, with the text of the program instead of its path."""
    return play(folder, program_file(folder, text, front="", name=name), timeout, **options)


def picture(folder: Path, name: str = "frame_000.png") -> NDArray[np.uint8]:
    """A picture of a program that was played: (height, width, 3)."""
    return np.asarray(Image.open(folder / "out" / name))
