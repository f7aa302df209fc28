"""Writes down what PyOpenGL's star imports bind: ``python pyopengl_names.py FOLDER``, with an interpreter that has it.

star_imports.json   for each of GL, GLU and GLUT: name -> number of a constant, or what else the name is
later.json          the commands and constants of OpenGL.GL that came after OpenGL 1.5: name -> version; name -> number
"""

from __future__ import annotations

import json
import sys
import types
from importlib import import_module
from pathlib import Path
from typing import Any

LATER = ("2_0", "2_1", "3_0", "3_1", "3_2", "3_3", "4_0", "4_1", "4_2", "4_3", "4_4", "4_5", "4_6")


def kind(value: Any) -> int | str:
    if isinstance(value, types.ModuleType):
        return "module"
    if isinstance(value, type):
        return "class"
    if isinstance(value, int):
        return int(value)
    return "function" if callable(value) else "value"


def star_import(library: str) -> dict[str, int | str]:
    names: dict[str, Any] = {}
    exec(f"from OpenGL.{library} import *", names)
    del names["__builtins__"]
    return {name: kind(value) for name, value in sorted(names.items())}


def bound() -> dict[str, dict[str, int | str]]:
    return {library: star_import(library) for library in ("GL", "GLU", "GLUT")}


def version_of(name: str) -> str:
    """The first version of OpenGL after 1.5 that has a name; or "" for an extension."""
    for version in LATER:
        if hasattr(import_module(f"OpenGL.raw.GL.VERSION.GL_{version}"), name):
            return version.replace("_", ".")
    return ""


def main() -> None:
    folder = Path(sys.argv[1])
    names = bound()
    (folder / "star_imports.json").write_text(json.dumps(names, separators=(",", ":")) + "\n")
    from glsim import gl

    later = {name: value for name, value in names["GL"].items() if not hasattr(gl, name)}
    commands = {n: version_of(n) for n, value in later.items() if value == "function" and n.startswith("gl")}
    constants = {n: value for n, value in later.items() if isinstance(value, int) and n.startswith("GL_")}
    text = json.dumps({"commands": commands, "constants": constants}, separators=(",", ":")) + "\n"
    (folder / "later.json").write_text(text)


if __name__ == "__main__":
    main()
