"""What ``help(glLightfv)`` says: a sentence for each command and each parameter, from manual.txt beside this file.

An entry of manual.txt is a line with the names of commands or families, sentences, and a line for each parameter,
``name: meaning``, with indented lines that continue it.  The entry ``*`` has the parameters that always mean the same.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

from glsim.machine.commands import COMMANDS, FAMILIES

COLORS = ("glColor", "glSecondaryColor")
RANGES = {  # of whole numbers that stand for 0 to 1, or -1 to 1 (OpenGL 1.5, table 2.9)
    "ub": "0 to 255 stand for 0 to 1", "us": "0 to 65535 stand for 0 to 1", "ui": "0 to 4294967295 stand for 0 to 1",
    "b": "-128 to 127 stand for -1 to 1", "s": "-32768 to 32767 stand for -1 to 1",
    "i": "-2147483648 to 2147483647 stand for -1 to 1",
}  # fmt: skip
TYPED = {  # PyOpenGL's commands for arrays of one type: how they are called, and what they take from the array
    "Pointer": "(array), an array of {type} numbers; size and stride follow from it.",
    "DrawElements": "(mode, indices), an array of {type} numbers; count follows from it.",
    "ReadPixels": "(x, y, width, height, format) returns {type} numbers.",
    "GetTexImage": "(target, level, format) returns {type} numbers.",
    "DrawPixels": "(format, pixels), an array of {type} numbers; the size is the array's, width first.",
    "TexImage": "(target, level, internalformat, border, format, pixels), an array of {type} numbers;\nthe size is the"
    " array's, width first.",
    "TexSubImage1D": "(target, level, xoffset, format, pixels), an array of {type} numbers; the size is the array's.",
    "TexSubImage2D": "(target, level, xoffset, yoffset, format, pixels), an array of {type} numbers;\nthe size is the"
    " array's, width first.",
    "TexSubImage3D": "(target, level, xoffset, yoffset, zoffset, format, pixels), an array of {type} numbers;\nthe size"
    " is the array's, width first.",
    "PolygonStipple": "() returns 128 {type} numbers.",
}
WORDS = {"b": "GL_BYTE", "ub": "GL_UNSIGNED_BYTE", "s": "GL_SHORT", "us": "GL_UNSIGNED_SHORT", "i": "GL_INT",
         "ui": "GL_UNSIGNED_INT", "f": "GL_FLOAT", "d": "GL_DOUBLE"}  # fmt: skip


class Entry(NamedTuple):
    about: str
    parameters: dict[str, str]


@cache
def entries() -> dict[str, Entry]:
    """Of manual.txt, by the name of the command or its family."""
    manual: dict[str, Entry] = {}
    for block in Path(__file__).with_name("manual.txt").read_text(encoding="utf-8").strip().split("\n\n"):
        names, *lines = block.split("\n")
        text = [line for line in lines if not re.match(r"\s|\w+: ", line)]
        parameters = re.findall(r"^(\w+): (.*(?:\n .*)*)", "\n".join(lines), re.MULTILINE)
        entry = Entry("\n".join(text), dict(parameters))
        manual.update(dict.fromkeys(names.split(), entry))
    return manual


def meaning(name: str, parameter: str) -> str:
    """Of one parameter of a command or family.  Raises KeyError if the manual does not say it."""
    parameters = entries()[name].parameters
    return parameters[parameter] if parameter in parameters else entries()["*"].parameters[parameter]


def doc(name: str, parameters: tuple[str, ...] = ()) -> str:
    """The text of any public gl command: a row of the table, a family without suffix, or a typed array's command."""
    command = COMMANDS.get(name)
    if command is None and name not in FAMILIES:
        return _typed_array(name)
    rows = FAMILIES[name] if command is None else [command]
    key = name if name in entries() else rows[0].family
    if command is None:
        words = dict.fromkeys(word for row in rows for word in row.parameters if word != "v")
        parameters = tuple(word for word in words if word != "param" or "params" not in words)
    lines = [entries()[key].about, ""]
    lines += [f"{word}: {meaning(key, word)}" for word in parameters]
    if command is None:
        lines.append(f"Numbers, or a sequence of them, of any type; {rows[0].name} and so on take one.")
    elif key in (*COLORS, "glNormal") and command.type in RANGES:
        lines.append(f"Whole numbers: {RANGES[command.type]}.")
    elif command.type == "i" and command.size == 0 and "params" in parameters:
        lines.append(f"Whole numbers; in colours {RANGES['i']}.")
    elif command.type in RANGES and any(kind == command.type for _, kind in command.arguments):
        lines.append("Whole numbers.")
    if rows[0].inside and rows[0].family not in ("glBegin", "glEnd"):
        lines.append("Also between glBegin and glEnd.")
    return "\n".join(lines).strip()


def _typed_array(name: str) -> str:
    kind = next(kind for kind in sorted(WORDS, key=len, reverse=True) if name.removesuffix(kind) in FAMILIES)
    base = name.removesuffix(kind)
    usage = next(text for part, text in TYPED.items() if part in base)
    return f"{entries()[base].about}\n\n{name}{usage.format(type=WORDS[kind])}"
