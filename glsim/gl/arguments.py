"""Turning what Python programs pass into what the machine stores, as PyOpenGL does."""

from __future__ import annotations

from struct import error as StructError  # noqa: N812
from struct import pack
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.commands import COMMANDS
from glsim.machine.current import current_machine
from glsim.machine.errors import show
from glsim.machine.machine import REGISTERS
from glsim.machine.record import implementations, python_arguments
from glsim.machine.sentences import MISUSE, explain
from glsim.machine.types import plain, raw_bytes


def retry(error: Exception, name: str, arguments: tuple[Any, ...]) -> Any:
    """A command failed: run it once more with Python's numbers instead of ctypes', or raise a sentence.

    So c_float, byref and pointers may stand wherever numbers and arrays do, and nobody who passes Python's numbers
    pays for it:

        glVertex2f(c_float(1.0), 2.0)                    # the body: struct.error, "required argument is not a float"
        retry(error, "glVertex2f", (c_float(1.0), 2.0))  # python_arguments -> (1.0, 2.0): another object, so
        glVertex2f(1.0, 2.0)                             # ... the second run, which stores the vertex
        retry(error, "glVertex2f", ("a", 2.0))           # nothing is another object, a second run would fail alike:
                                                         # TypeError "glVertex2f: x must be a number, not 'a'"
    """
    machine, given = current_machine(), python_arguments(COMMANDS[name], arguments)
    current = [getattr(machine, register) for register in REGISTERS]
    known = list(map(plain, current))
    if all(now is before for now, before in zip((*given, *known), (*arguments, *current), strict=True)):
        raise (_current_complaint(error, name, current) or explain(error, name, arguments)) from None
    for register, value in zip(REGISTERS, known, strict=True):
        setattr(machine, register, value)
    return implementations[name](*given)


def _current_complaint(error: Exception, name: str, current: list[Any]) -> TypeError | None:
    """The sentence if it was the current normal or colour that could not be packed beside a vertex."""
    for what, values in (("normal", current[:3]), ("color", current[3:])) if isinstance(error, StructError) else ():
        try:
            pack(f"{len(values)}f", *values)
        except MISUSE:
            return TypeError(f"{name}: the current {what} (gl{what.title()}) is not made of numbers: {values!r}")
    return None


def numbers(values: Any) -> tuple[float, ...]:
    """A number, a (nested) sequence or an array -> a flat tuple of floats."""
    kind = type(values)
    if kind is list or kind is tuple:
        try:
            return tuple(map(float, values))
        except (TypeError, ValueError):
            pass
    elif kind is float or kind is int:
        return (float(values),)
    try:
        if not isinstance(values, (str, bytes)) and values is not None:
            return tuple(np.asarray(values, np.float64).ravel().tolist())
    except (TypeError, ValueError):
        pass
    raise TypeError(f"a number or a sequence of numbers is needed, not {show(values)}")


def exactly(values: Any, count: int, what: str) -> tuple[float, ...]:
    """``numbers`` of which there must be ``count`` (more are ignored, as C would)."""
    given = numbers(values)
    if len(given) < count:
        raise ValueError(f"{what} needs {count} numbers, not {len(given)}")
    return given[:count]


def matrix16(values: Any) -> NDArray[np.float32]:
    """Sixteen numbers in any shape -> (4, 4) float32, column first as OpenGL stores matrices."""
    try:
        array = np.asarray(values, np.float32)
    except (TypeError, ValueError):
        raise TypeError(f"a matrix has 16 numbers; {show(values)} is no array of numbers") from None
    if array.size != 16:
        raise ValueError(f"a matrix has 16 numbers, not {array.size}")
    return array.reshape(4, 4).copy()


def as_int32(value: float) -> int:
    """As an integer of 32 bits, which is as large as a C program can pass."""
    return min(max(int(value), -(2**31)), 2**31 - 1)


def unit(value: float) -> float:
    """Clamped to [0, 1]."""
    return min(max(float(value), 0.0), 1.0)


def signed_colour(value: float) -> float:
    """An integer as a colour component: [-2^31, 2^31 - 1] -> [-1, 1], OpenGL 1.5 table 2.9."""
    return (2.0 * value + 1.0) / 4294967295.0


def array_from(data: Any, dtype: type, what: str) -> NDArray[Any]:
    """The data of a program as a flat array of ``dtype``; bytes and the like as uint8.  what: its name in errors."""
    if data is None:
        raise ValueError(f"{what} is None: pass an array, or bind a buffer object first")
    memory = raw_bytes(data)
    if memory is not None:
        return memory
    if isinstance(data, np.ndarray) and data.dtype.kind in "biuf":
        flat = np.ascontiguousarray(data)
        return (flat if flat.dtype == dtype else flat.astype(dtype)).ravel()
    try:
        return np.asarray(data, dtype).ravel()
    except (TypeError, ValueError, OverflowError):
        word = np.dtype(dtype).name
        raise TypeError(f"{what} must be an array or a sequence of {word} numbers, not {show(data)}") from None
