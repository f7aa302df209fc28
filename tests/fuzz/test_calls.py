"""Random calls of GL, GLU and GLUT: nothing but sentences of glsim's own, and nothing half-done after them.

``python -m tests.fuzz --calls 1000000`` makes more.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator

import numpy as np
import pytest

from glsim import gl, glu, glut
from glsim.glut.loop import loop
from glsim.machine.current import current_machine, make_current
from tests.fuzz.calls import Fuzz, accepted

CALLS = 6000


@pytest.fixture
def fuzz() -> Iterator[type[Fuzz]]:
    """GLUT without windows and the current context as they were before."""
    before = current_machine()
    with warnings.catch_warnings():
        yield Fuzz
    for number in list(loop.windows):
        loop.close(number)
    make_current(before)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_random_calls(fuzz: type[Fuzz], seed: int) -> None:
    made = fuzz(seed)
    while made.report.calls < CALLS:
        made.round(60)
    print(made.report)
    wrong = {what: count for what, count in made.report.wrong.items() if not what.startswith("warning")}
    assert not wrong, str(made.report)


@pytest.mark.slow
def test_enumerants_are_learned(fuzz: type[Fuzz]) -> None:
    made = fuzz(0)
    while made.report.calls < 3000:
        made.round(60)
    assert int(gl.GL_MODELVIEW) in made.known["glMatrixMode", "mode"]
    assert sum(map(len, made.known.values())) > 300


def test_what_is_not_accepted() -> None:
    assert accepted("glFoo", KeyError("x")) == "KeyError"
    assert accepted("glFoo", TypeError("only length-1 arrays")) == "without the command's name"
    assert accepted("glFoo", TypeError("glFoo: could not convert string to float")) == "foreign words"
    assert accepted("glFoo", TypeError("glFoo: x must be a number, not 'could not convert'")) == ""
    assert accepted("glutFoo", RuntimeError("glutFoo: there is no current window")) == ""


class Failing:
    """A number of the program's own that cannot be had."""

    def __float__(self) -> float:
        raise KeyError("mine")


def test_what_the_program_raises_stays(fuzz: type[Fuzz]) -> None:
    made = fuzz(0)
    with pytest.raises(KeyError, match="mine"):
        glu.gluPerspective(Failing(), 1.0, 1.0, 2.0)  # type: ignore[arg-type]
    tess = glu.gluNewTess()
    glu.gluTessCallback(tess, glu.GLU_TESS_BEGIN, lambda mode: {}[mode])
    glu.gluTessBeginPolygon(tess)
    glu.gluTessBeginContour(tess)
    for corner in ((0, 0, 0), (1, 0, 0), (0, 1, 0)):
        glu.gluTessVertex(tess, corner, corner)
    glu.gluTessEndContour(tess)
    with pytest.raises(KeyError):
        glu.gluTessEndPolygon(tess)
    assert made.report.calls == 0


def test_sentences_of_glu_and_glut(fuzz: type[Fuzz]) -> None:
    fuzz(0)
    with pytest.raises(TypeError, match=r"gluSphere: quad must be what gluNewQuadric\(\) returned, not 3"):
        glu.gluSphere(3, 1.0, 8, 8)
    with pytest.raises(TypeError, match="gluLookAt: centerX must be a number, not 'a'"):
        glu.gluLookAt(0, 0, 1, "a", 0, 0, 0, 1, 0)
    with pytest.raises(TypeError, match="gluProject: these arguments do not go together"):
        glu.gluProject(0, 0, 0, np.zeros(3), np.zeros(3), [0, 0])
    with pytest.raises(TypeError, match="glutDestroyWindow: window must be a number, not None"):
        glut.glutDestroyWindow(None)
    with pytest.raises(ValueError, match="glutSolidTeapot: size must be a finite number, not inf"):
        glut.glutSolidTeapot(float("inf"))
    with pytest.raises(gl.GLError, match=r"gluOrtho2D: glOrtho: left and right must be two different numbers"):
        glu.gluOrtho2D(1, 1, 0, 1)
    with pytest.raises(gl.GLError, match=r"^glTexImage2Df: format must be"):
        gl.glTexImage2Df(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, 0, "a", np.zeros((2, 2, 3)))
    with pytest.raises(ValueError, match="glTexImage2Df: pixels must be an array of 2 or more dimensions"):
        gl.glTexImage2Df(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, 0, gl.GL_RGB, [1])


def test_a_value_that_is_no_number_is_dropped_at_the_flush(fuzz: type[Fuzz]) -> None:
    """The coordinate is added up at the call and looked at when it is needed; afterwards drawing goes on."""
    fuzz(0).window.screen.reset()
    gl.glTexCoord2f(1j, 0)
    gl.glRectf(-1, -1, 1, 1)
    with pytest.raises(TypeError, match=r"glFinish: a texture coordinate, secondary color, .* was no number"):
        gl.glFinish()
    gl.glColor3f(1, 0, 0)
    gl.glRectf(-1, -1, 1, 1)
    assert gl.glReadPixels(3, 3, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE) == bytes([255, 0, 0])
