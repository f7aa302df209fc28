"""What a program is told when it asks for something OpenGL does not allow."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable, Sequence
from functools import wraps
from inspect import signature
from opcode import opmap
from traceback import walk_tb
from types import CodeType
from typing import Any, TypeVar

import numpy as np

from glsim.machine.commands import COMMANDS, NUMBERS
from glsim.machine.constants import (
    GL_INVALID_ENUM,
    GL_INVALID_OPERATION,
    GL_INVALID_VALUE,
    GL_OUT_OF_MEMORY,
    GL_STACK_OVERFLOW,
    GL_STACK_UNDERFLOW,
    Enum,
)

F = TypeVar("F", bound=Callable[..., Any])
Kinds = tuple[tuple[str, str], ...]  # of a call's arguments: name and kind, as in the command table


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

    def within(self, name: str, arguments: Sequence[Any]) -> GLError:
        """The same error, of a call that made the failing one: glLight calls glLightfv, gluLookAt calls glMultMatrixf."""
        inner = self.baseOperation or name
        if not _related(inner, name):
            self.description = f"{inner}: {self.description}"
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
        return f"{value} (0x{value:X})" if value > 255 else str(value)
    if isinstance(value, np.ndarray):
        text = repr(value.tolist()) if value.size <= 4 else f"an array of shape {value.shape}"
    else:
        text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def explain(error: Exception, name: str, arguments: Sequence[Any], kinds: Kinds | None = None) -> Exception:
    """What a call raised, as a sentence that begins with the call's name and says which argument is to blame.

    kinds: name and kind of each argument, of a call that has no row in the command table.  The words of Python, NumPy
    or ctypes are none for a student; they become a note of the exception.  What the program itself raised, in a
    callback or in an object's __float__, stays as it is.
    """
    if _of_the_program(error):
        return error
    if isinstance(error, GLError):
        return error.during(name, arguments) if kinds is None else error.within(name, arguments)
    if kinds is None:
        kinds = COMMANDS[name].arguments if name in COMMANDS else ()
    if isinstance(error, MemoryError):
        return out_of_memory(f"there is not enough memory for {_listed(kinds, arguments)}").during(name, arguments)
    size = COMMANDS[name].size if name in COMMANDS and COMMANDS[name].vector else 0
    for (argument, kind), value in zip(kinds, arguments, strict=False):
        expected = _complaint(kind, value, size)
        if expected:
            return _noted(TypeError(f"{name}: {argument} must be {expected}, not {show(value)}"), error)
    if _is_a_sentence(error):
        return _begun_with(name, error)
    return _noted(ValueError(f"{name}: these arguments do not go together: {_listed(kinds, arguments)}"), error)


def explained(name: str, function: F) -> F:
    """A function of GLU or GLUT, or one of PyOpenGL's forms of a GL command, that raises what ``explain`` makes."""

    @wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        try:
            return function(*arguments, **options)
        except Exception as error:
            made = explain(error, name, arguments, _kinds_of(function, len(arguments)))
            if made is error:
                raise
            raise made from None

    return call  # type: ignore[return-value]


def _kinds_of(function: Callable[..., Any], count: int) -> Kinds:
    """Name and kind of each argument, from its annotation: a number, an integer, an object of some class."""
    pairs: list[tuple[str, str]] = []
    for word, parameter in signature(function).parameters.items():
        if parameter.kind is parameter.VAR_POSITIONAL:
            pairs += [(f"argument {k + 1}", "") for k in range(len(pairs), count)]
        else:
            pairs.append((word, ANNOTATED.get(parameter.annotation, "")))
    return tuple(pairs)


# annotation of an argument -> its kind; for objects, what makes them
ANNOTATED = {
    "float": "f", "int": "i", "bool": "boolean", "Quadric": "gluNewQuadric", "Nurbs": "gluNewNurbsRenderer",
    "Tessellator": "gluNewTess",
}  # fmt: skip
MADE_BY = {kind: annotation for annotation, kind in ANNOTATED.items() if kind.startswith("glu")}

PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIBRARY = os.path.dirname(os.path.abspath(os.__file__))  # Python's own modules


def _is_glsim(code: CodeType) -> bool:
    return code.co_filename.startswith((PACKAGE, "<gl command"))


def _of_the_program(error: Exception) -> bool:
    """Whether the program's own code, called by glsim, raised it."""
    files = (frame.f_code for frame, _ in walk_tb(error.__traceback__) if not _is_glsim(frame.f_code))
    return any(
        not code.co_filename.startswith((LIBRARY, "<frozen")) and "site-packages" not in code.co_filename
        for code in files
    )


def _is_a_sentence(error: Exception) -> bool:
    """Whether a raise statement of glsim's made it, so that the words are glsim's."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    if trace is None:
        return False
    code = trace.tb_frame.f_code
    return _is_glsim(code) and code.co_code[trace.tb_lasti] == opmap["RAISE_VARARGS"]


def _begun_with(name: str, error: Exception) -> Exception:
    """The same exception with the call's name in front of its sentence."""
    begin, colon, rest = str(error).partition(": ")
    if begin != name:
        error.args = (f"{name}: {rest if colon and _related(begin, name) else error}",)
    return error


def _related(one: str, other: str) -> bool:
    """Whether two names are variants of a call: glLight and glLightfv."""
    return one.startswith(other) or other.startswith(one)


def _noted(made: Exception, error: Exception) -> Exception:
    """A traceback shows the note below the sentence; it helps who looks for a mistake in glsim."""
    made.add_note(f"({type(error).__name__}: {error})")
    return made


def _listed(kinds: Kinds, arguments: Sequence[Any]) -> str:
    """Arguments and their values, such as: width = 4, height = 4."""
    return ", ".join(f"{word} = {show(value)}" for (word, _), value in zip(kinds, arguments, strict=False))


def _complaint(kind: str, value: object, size: int) -> str:
    """What an argument of this kind should have been; empty if the value will do.

    size: of a vector, how many numbers it has.
    """
    if not kind:
        return ""
    if kind in MADE_BY:
        return "" if type(value).__name__ == MADE_BY[kind] else f"what {kind}() returned"
    if kind == "data":
        return _data_complaint(value, size)
    try:
        number = float(value)  # type: ignore[arg-type]
        if isinstance(value, (str, bytes, bytearray)) or np.ndim(value):  # type: ignore[arg-type]
            return "a number"
        if kind not in ("f", "d", "boolean"):
            int(number)
    except (TypeError, ValueError, OverflowError):
        return "a constant such as GL_LIGHTING" if kind == "enum" else "a number"
    if kind in ("f", "d", "boolean"):
        return ""
    if kind in NUMBERS and number != int(number):
        return "an integer"
    return "" if -(2**31) <= number < 2**32 else "an integer of 32 bits"


def _data_complaint(value: object, size: int) -> str:
    """What an array should have been."""
    numbers = f"{size} numbers" if size else "a list, tuple or array of numbers"
    if value is None or hasattr(value, "bind") or isinstance(value, (ctypes._Pointer, ctypes.c_void_p)):
        return ""
    if isinstance(value, (bytes, bytearray, memoryview, int)) and not size:
        return ""  # raw memory, or an offset into a buffer object
    try:
        array = np.asarray(value)
        if array.dtype.kind not in "biufO" or isinstance(value, (str, bytes)):
            return numbers
        return numbers if size and array.astype(np.float64).size != size else ""
    except (TypeError, ValueError, OverflowError):
        return numbers
