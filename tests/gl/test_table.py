"""The command table and what is made from it."""

from __future__ import annotations

import inspect

import pytest

from glsim import gl
from glsim.gl import generate, manual
from glsim.machine.commands import COMMANDS, FAMILIES


def test_every_entry_point_of_opengl_1_5_is_there() -> None:
    assert len(COMMANDS) == 452 + 1  # glGetStringi
    assert all(callable(getattr(gl, name)) for name in COMMANDS)


def test_generated_files_are_what_the_generator_writes() -> None:
    assert (generate.GL / "immediate.py").read_text() == generate.immediate()
    assert (generate.GL / "__init__.pyi").read_text() == generate.gl_stubs()
    for library in ("glu", "glut"):
        assert (generate.GL.parent / library / "__init__.pyi").read_text() == generate.library_stubs(library)
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


# ---------------------------------------------------------------- the manual


def undocumented(name: str) -> list[str]:
    about, _, text = getattr(gl, name).__doc__.partition("\n\n")
    words = set(inspect.signature(getattr(gl, name)).parameters) if name in COMMANDS else set()
    if name in FAMILIES and name not in COMMANDS:  # without suffix: the parameters of all variants
        words = {word for row in FAMILIES[name] for word in row.parameters} - {"v", "param"}
    missing = [f"{name}: {word}" for word in words if f"\n{word}: " not in f"\n{text}"]
    return missing + ([] if len(about) > 20 else [name])


def test_the_manual_has_every_command_and_every_parameter() -> None:
    public = [name for name in gl.__all__ if name.startswith("gl") and callable(getattr(gl, name))]
    assert len(public) > 580
    assert [missing for name in public for missing in undocumented(name)] == []


def test_the_manual_has_nothing_else() -> None:
    """A line of a sentence that begins like a parameter would be one."""
    taken: dict[int, set[str]] = {}
    for name, entry in manual.entries().items():
        for row in FAMILIES.get(name) or [COMMANDS[name]] if name != "*" else []:
            words = taken.setdefault(id(entry), set())
            words |= {*row.parameters, *inspect.signature(getattr(gl, row.name)).parameters}
    everything = set().union(*taken.values())
    assert len(everything) > 100
    for name, entry in manual.entries().items():
        assert set(entry.parameters) <= taken.get(id(entry), everything), name


def test_the_manual_says_units_and_ranges() -> None:
    assert "in degrees, not radians" in gl.glRotatef.__doc__
    assert "w = 0 for the sun in a direction" in gl.glLightfv.__doc__
    assert gl.glLight.__doc__.startswith(gl.glLightfv.__doc__.partition("\n\n")[0])
    assert "0 to 255 stand for 0 to 1" in gl.glColor4ub.__doc__
    assert "stand for" not in gl.glColor4f.__doc__ + gl.glVertex3i.__doc__
    assert "array of GL_FLOAT numbers" in gl.glTexCoordPointerf.__doc__
    stub = (generate.GL / "__init__.pyi").read_text()
    assert 'def glRotatef(angle: float, x: float, y: float, z: float) -> None:\n    """Turns what is drawn' in stub
