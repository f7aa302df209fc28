"""One vocabulary for shading, and suggestions for what is misspelt."""

from __future__ import annotations

import sys

import pytest

import glsim
from glsim import gl, glu, glut
from glsim.cli import main
from glsim.names import did_you_mean, hint_for
from glsim.scenes import MeshError, material, open_scene


@pytest.mark.parametrize(
    ("module", "wrong", "right"),
    [(gl, "GL_LIGHTNING", "GL_LIGHTING"), (gl, "glVertex3", "glVertex3f"), (gl, "glLigthf", "glLightf"),
     (gl, "glRotate3f", "glRotatef"), (gl, "glvertex3f", "glVertex3f"), (glu, "gluPerspectve", "gluPerspective"),
     (glut, "glutSwapBuffer", "glutSwapBuffers"), (glsim, "comapre", "compare")],
)  # fmt: skip
def test_misspelt_names_of_modules(module: object, wrong: str, right: str) -> None:
    with pytest.raises(AttributeError, match=f"has no attribute '{wrong}'; did you mean '{right}'"):
        getattr(module, wrong)


def test_names_that_are_like_no_other() -> None:
    with pytest.raises(AttributeError, match=r"has no attribute 'xyz'$"):
        _ = gl.xyz  # type: ignore[attr-defined]
    assert did_you_mean("cheese", ["teapot", "sphere"]) == ""


@pytest.mark.parametrize(
    ("program", "hint"),
    [
        ("from glsim.gl import *\nglEnable(GL_LIGHTNING)", "; did you mean 'GL_LIGHTING'?"),
        (
            "from glsim.gl import *\ndef draw(angel):\n    glVertex3(angle, 0, 0)\ndraw(1)",
            "; did you mean 'glVertex3f'?",
        ),
        ("def draw(angel):\n    return angle\ndraw(1)", "; did you mean 'angel'?"),
        ("pritn(1)", "; did you mean 'print'?"),
        ("from glsim.gl import GL_LIGHTNING", "; did you mean 'GL_LIGHTING'?"),
        ("import math\nmath.sqtr(1)", "; did you mean 'sqrt'?"),
        ("import glsim.gl\nglsim.gl.GL_LIGHTNING", ""),  # the error says it itself
        ("1 / 0", ""),
    ],
)
def test_hints_for_errors_of_programs(program: str, hint: str) -> None:
    try:
        exec(compile(program, "program.py", "exec"), {"__builtins__": __builtins__})
    except Exception as error:
        found = hint_for(error)
    assert found == hint


def test_misspelt_scenes_materials_and_modes() -> None:
    with pytest.raises(MeshError, match="did you mean 'teapot'"):
        open_scene("tepot")
    with pytest.raises(ValueError, match="did you mean 'gold'"):
        material("golden")
    with pytest.raises(ValueError, match="did you mean 'gouraud'"):
        glsim.compare("cube", modes=["gourad"])
    with pytest.raises(ValueError, match="did you mean 'blinn'"):
        glsim.compare("cube", lobes=["blin"])


@pytest.mark.parametrize(
    ("words", "hint"),
    [("comapre teapot", "compare"), ("run x.py --shade gourad", "gouraud"), ("run x.py --lobe blin", "blinn"),
     ("trace torsu", "torus"), ("radiosity cornel", "cornell")],
)  # fmt: skip
def test_misspelt_words_of_the_command_line(words: str, hint: str, capsys: pytest.CaptureFixture[str]) -> None:
    try:
        code = main(words.split())
    except SystemExit as error:
        code = int(str(error.code))
    assert code in (1, 2)
    assert f"did you mean '{hint}'" in " ".join(capsys.readouterr().err.split())


def test_smooth_and_gouraud_are_one(monkeypatch: pytest.MonkeyPatch) -> None:
    sheet = glsim.compare("cube", size=32, modes=["smooth"], lobes=["blinn-torrance"])
    assert list(sheet.images) == [("blinn", "gouraud")]
    plans = []
    monkeypatch.setattr("glsim.play.run.run", lambda plan, *more, **words: plans.append(plan) or sys.exit(0))
    for name in ("smooth", "gouraud"):
        with pytest.raises(SystemExit):
            main(["run", "x.py", "--shade", name])
    assert [plan.shade for plan in plans] == ["gouraud", "gouraud"]
