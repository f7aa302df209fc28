"""shaders/README.md names every file and every constant, and nothing that is not there."""

from __future__ import annotations

import re

import pytest

import glsim.gl
from glsim.files import data_folder
from glsim.machine import constants
from glsim.machine.state import Combine
from glsim.render import programs
from glsim.render.key import ProgramKey, UnitKind

FOLDER = data_folder("shaders")
README = (FOLDER / "README.md").read_text(encoding="utf-8")


def names(pattern: str, text: str = README) -> set[str]:
    return set(re.findall(pattern, text, re.MULTILINE))


def printed() -> set[str]:
    """The constants in front of a program with textures; not the values that they are compared with."""
    unit = UnitKind(0, 2, True, True, False, False, False, 0, Combine(), (True,) * 3, (0,) * 4)
    text = programs.constants(ProgramKey(units=(unit,)))
    found = names(r"^(?:#define|const [\w\[\]]+) (\w+)", text) - set(programs.ENUMS)
    return {name for name in found if not name.startswith("PIXELS_")}


def test_every_file_is_there() -> None:
    files = {path.name for path in FOLDER.iterdir()} - {"README.md"}
    assert names(r"`(\w+\.(?:glsl|vert|frag))`") == files


def test_every_constant_has_a_row() -> None:
    rows = "\n".join(line.split("|")[1] for line in README.splitlines() if re.match(r"\| `[A-Z]", line))
    told = names(r"`([A-Z_0-9]+)`", rows)
    for name in ("TEXTURE", "SAMPLER"):
        assert {f"{name}_0", f"{name}_3"} <= told
        told |= {f"{name}_1", f"{name}_2"}
    assert told == printed()


@pytest.mark.parametrize("name", sorted(names(r"\b(gl[A-Z]\w+)")))
def test_the_commands_are_the_apis(name: str) -> None:
    assert hasattr(glsim.gl, name)


@pytest.mark.parametrize("name", sorted(names(r"\b(GL_[A-Z0-9_]+)")))
def test_the_enumerants_are_the_apis(name: str) -> None:
    assert hasattr(constants, name) or name == "GL_ES"  # which is GLSL's own


def test_functions_and_members_that_it_names_are_in_the_glsl() -> None:
    for file, function in re.findall(r"`(\w+\.\w+)`: `(\w+)`", README):
        assert re.search(rf"\b{function}\b", (FOLDER / file).read_text(encoding="utf-8")), (file, function)
