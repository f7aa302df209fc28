"""The command table and what is made from it."""

from __future__ import annotations

import inspect

import pytest

from glsim import gl
from glsim.machine import generate
from glsim.machine.commands import COMMANDS, FAMILIES


def test_every_entry_point_of_opengl_1_5_is_there() -> None:
    assert len(COMMANDS) == 452 + 1  # glGetStringi
    assert all(callable(getattr(gl, name)) for name in COMMANDS)


def test_generated_files_are_what_the_generator_writes() -> None:
    assert (generate.GL / "immediate.py").read_text() == generate.immediate()
    assert (generate.GL / "__init__.pyi").read_text() == generate.stubs()
    assert (generate.GL / "SUPPORT.md").read_text() == generate.support()


@pytest.mark.parametrize(
    ("name", "parameters"),
    [
        ("glVertex3f", "(x: 'float', y: 'float', z: 'float') -> 'None'"),
        ("glTranslated", "(x, y, z)"),
        ("glLightfv", "(light, pname, params)"),
        ("glTexImage2D", "(target, level, internalformat, width, height, border, format, type, pixels)"),
    ],
)
def test_signatures_have_the_specifications_names(name: str, parameters: str) -> None:
    assert str(inspect.signature(getattr(gl, name))) == parameters


def test_variants_of_a_family() -> None:
    names = {command.name for command in FAMILIES["glColor"]}
    assert {"glColor3ub", "glColor3ubv", "glColor4f", "glColor4usv"} <= names
    assert len(names) == 32


def test_what_is_refused_says_so(screen: object) -> None:
    with pytest.raises(gl.GLError, match="a compressed format, of which there is none"):
        gl.glCompressedTexImage2D(gl.GL_TEXTURE_2D, 0, 0x83F0, 4, 4, 0, 8, bytes(8))
    with pytest.raises(gl.GLError, match="colour-index mode"):
        gl.glReadPixels(0, 0, 1, 1, gl.GL_COLOR_INDEX, gl.GL_UNSIGNED_BYTE)


def test_star_import_gives_commands_and_constants_only() -> None:
    assert all(name.startswith(("gl", "GL")) or name == "error" for name in gl.__all__)
    assert {"glBegin", "GL_PHONG_WIN", "GLError", "glColor", "glRotate", "glGetFloat"} <= set(gl.__all__)
