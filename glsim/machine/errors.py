"""What a program is told when it asks for something OpenGL does not allow."""

from __future__ import annotations

import dis
import os
from collections.abc import Sequence
from ctypes import ArgumentError
from struct import error as StructError  # noqa: N812
from typing import Any

from glsim.machine.commands import COMMANDS, NUMBERS, numbers_wanted
from glsim.machine.constants import (
    GL_INVALID_ENUM,
    GL_INVALID_OPERATION,
    GL_INVALID_VALUE,
    GL_OUT_OF_MEMORY,
    GL_STACK_OVERFLOW,
    GL_STACK_UNDERFLOW,
    Enum,
)


class GLError(Exception):
    """An OpenGL error, raised by the call that caused it, as PyOpenGL does.

    Attributes (PyOpenGL's names):
        err: the error code, such as GL_INVALID_ENUM.
        baseOperation: name of the command; cArguments: what it was called with; result: None.
        description: the sentence that says what was wrong.
    """

    def __init__(self, err: Enum, description: str) -> None:
        super().__init__(err, description)
        self.err = err
        self.description = description
        self.baseOperation: str | None = None
        self.cArguments: tuple[Any, ...] = ()
        self.result: Any = None

    def during(self, name: str, arguments: Sequence[Any]) -> GLError:
        """The same error, knowing the command in which it happened."""
        if self.baseOperation is None:
            self.baseOperation, self.cArguments = name, tuple(arguments)
        return self

    def __str__(self) -> str:
        call = f"{self.baseOperation}: " if self.baseOperation else ""
        return f"{call}{self.description} ({self.err!r})"


class NoContextError(RuntimeError):
    """A gl command was called while no context is current."""


def invalid_enum(argument: str, value: object, expected: str) -> GLError:
    return GLError(GL_INVALID_ENUM, f"{argument} must be {expected}, not {show(value)}")


def invalid_value(argument: str, value: object, expected: str) -> GLError:
    return GLError(GL_INVALID_VALUE, f"{argument} must be {expected}, not {show(value)}")


def invalid_operation(sentence: str) -> GLError:
    return GLError(GL_INVALID_OPERATION, sentence)


def stack_overflow(sentence: str) -> GLError:
    return GLError(GL_STACK_OVERFLOW, sentence)


def stack_underflow(sentence: str) -> GLError:
    return GLError(GL_STACK_UNDERFLOW, sentence)


def out_of_memory(sentence: str) -> GLError:
    return GLError(GL_OUT_OF_MEMORY, sentence)


def show(value: object) -> str:
    """A value as a message quotes it: never longer than a line."""
    if isinstance(value, int) and not isinstance(value, (bool, Enum)):
        if value.bit_length() > 64:
            return f"a number of {value.bit_length()} bits"
        return f"{value} (0x{value:X})" if value > 255 else str(value)
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def explain(error: Exception, name: str, arguments: Sequence[Any]) -> Exception:
    """Turn what a command's body raised into a sentence that names the call and the argument."""
    if isinstance(error, GLError):
        return error.during(name, arguments)
    if isinstance(error, MemoryError):
        return out_of_memory("there is not enough memory for it").during(name, arguments)
    said = is_a_sentence(error)
    if said and not isinstance(error, TypeError):
        return type(error)(f"{name}: {error}") if type(error) is ValueError else error
    command = COMMANDS[name]
    for place, ((argument, kind), value) in enumerate(zip(command.arguments, arguments, strict=False)):
        expected = _complaint(kind, value, numbers_wanted(command, arguments, place) if command.vector else None)
        if expected:
            return TypeError(f"{name}: {argument} must be {expected}, not {show(value)}")
    if said:
        return TypeError(f"{name}: {error}")
    if isinstance(error, MISUSE):
        given = ", ".join(map(show, arguments))
        return TypeError(f"{name}({', '.join(command.parameters)}) cannot be called with ({given})")
    return error


# what Python, NumPy and ctypes raise when they are given something they do not expect
MISUSE = (TypeError, ValueError, ArithmeticError, LookupError, BufferError, StructError, ArgumentError)
PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RAISE = dis.opmap["RAISE_VARARGS"]


def is_a_sentence(error: Exception) -> bool:
    """Whether a ``raise`` of glsim made the error; if not, it has the words of Python, NumPy or ctypes."""
    at = error.__traceback__
    while at is not None and at.tb_next is not None:
        at = at.tb_next
    if at is None:
        return True
    code = at.tb_frame.f_code
    return code.co_filename.startswith(PACKAGE) and code.co_code[at.tb_lasti] == RAISE


def _complaint(kind: str, value: object, count: int | None) -> str:
    """What an argument of this type should have been; empty if the value will do.  count: how many numbers of it."""
    if kind == "data":
        return _array_complaint(value, count)
    try:
        number = float(value)  # type: ignore[arg-type]
        if isinstance(value, (str, bytes)):
            return "a number"
        if kind not in ("f", "d", "boolean"):
            int(number)
    except (TypeError, ValueError, OverflowError):
        return "a constant such as GL_LIGHTING" if kind == "enum" else "a number"
    if kind in NUMBERS and kind not in ("f", "d") and number != int(number):
        return "an integer"
    return ""


def _array_complaint(value: Any, count: int | None) -> str:
    import numpy as np  # so that ``glsim --help`` is quick

    from glsim.machine.types import is_pointer

    numbers = "a list, tuple or array of numbers" if count is None else f"a list, tuple or array of {count} numbers"
    if is_pointer(value):
        return f"{numbers} (a pointer of ctypes does not say how many there are)"
    if value is None or isinstance(value, (bytes, bytearray)):
        return "" if count is None else numbers
    try:
        array = np.asarray(value)
        return "" if array.dtype.kind in "biuf" and count in (None, array.size) else numbers
    except (TypeError, ValueError):
        return numbers
