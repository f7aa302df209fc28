"""Calls, constants, values and matrices as text, and results as what JSON can hold."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np

from glsim.machine import constants as gl
from glsim.machine.commands import COMMANDS
from glsim.machine.constants import Enum
from glsim.machine.frame import Call, Where

BUFFER_BITS = (gl.GL_COLOR_BUFFER_BIT, gl.GL_DEPTH_BUFFER_BIT, gl.GL_STENCIL_BUFFER_BIT, gl.GL_ACCUM_BUFFER_BIT)


def call_text(call: Call) -> str:
    """A call as it would be written, at most a line."""
    via = f"{call.where.via}: " if call.where is not None and call.where.via else ""
    kinds = [kind for _, kind in COMMANDS[call.name].arguments]
    pairs = zip(call.arguments, [*kinds, *[""] * len(call.arguments)], strict=False)
    words = ", ".join(_argument(argument, kind) for argument, kind in pairs if argument is not None)
    if call.name == "glClear":
        names = [repr(bit) for bit in BUFFER_BITS if int(call.arguments[0]) & bit]
        words = " | ".join(names) or words
    text = f"{via}{call.name}({words})"
    return text if len(text) <= 110 else text[:107] + "..."


def enum_name(value: Any) -> str:
    """The name of a constant, whoever computed it: GL_LIGHT0 + 1, or a number that a state variable holds."""
    if isinstance(value, Enum) or not isinstance(value, int) or isinstance(value, bool):
        return repr(value)
    return repr(_ENUMS.get(value, value))


# value -> constant; values up to 255 are left out, because many constants share them
_ENUMS = {int(value): value for value in reversed(vars(gl).values()) if isinstance(value, Enum) and value > 255}


def _argument(value: Any, kind: str = "") -> str:
    if kind in ("enum", "param"):
        return enum_name(int(value)) if isinstance(value, float) and value > 255 and value.is_integer() else (
            enum_name(value) if isinstance(value, int) else _argument(value))  # fmt: skip
    if isinstance(value, np.ndarray):
        return f"array of shape {value.shape}" if value.size > 16 else _argument(value.ravel().tolist())
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_argument, value)) + "]"
    if isinstance(value, float):
        return f"{value:.6g}"
    return f"{len(value)} bytes" if isinstance(value, (bytes, bytearray)) else repr(value)


def value_text(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, tuple):
        return "(" + ", ".join(map(value_text, value)) + ")"
    return enum_name(value)


def matrix_text(columns: Any) -> str:
    """A matrix as text, row by row as in mathematics, or "identity".  columns: (4, 4), its columns as rows."""
    if np.array_equal(columns, np.eye(4)):
        return "identity"
    return "[" + "; ".join(" ".join(f"{value:.4g}" for value in row) for row in np.asarray(columns).T) + "]"


def as_json(value: Any) -> Any:
    """A result as what JSON can hold: dataclasses become dictionaries, tuples lists, infinite numbers and NaN None."""
    if is_dataclass(value):
        return {entry.name: as_json(getattr(value, entry.name)) for entry in fields(value)}
    if isinstance(value, Where):
        return value._asdict()
    if isinstance(value, (tuple, list)):
        return [as_json(entry) for entry in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value
