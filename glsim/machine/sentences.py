"""Turns an exception of Python, NumPy or ctypes into an error message that names the gl call and the argument."""

from __future__ import annotations

import dis
import os
from collections.abc import Callable, Sequence
from ctypes import ArgumentError
from functools import wraps
from inspect import signature
from struct import error as StructError  # noqa: N812
from traceback import walk_tb
from types import CodeType
from typing import Any, TypeVar

import numpy as np

from glsim.machine.commands import COMMANDS, NUMBERS, numbers_wanted
from glsim.machine.errors import GLError, out_of_memory, related, show
from glsim.machine.types import is_pointer

F = TypeVar("F", bound=Callable[..., Any])
Kinds = tuple[tuple[str, str], ...]  # of a call's arguments: name and kind, as in the command table


def explain(error: Exception, name: str, arguments: Sequence[Any], kinds: Kinds | None = None) -> Exception:
    """Turn what a command's body raised into a sentence that begins with the call and names the argument.

    kinds: name and kind of each argument, of a function that has no row in the command table.  What the program itself
    raised, in a callback or in an object's __float__, stays as it is.
    """
    if _raised_by_program(error):
        return error
    if isinstance(error, GLError):
        return error.during(name, arguments) if kinds is None else error.within(name, arguments)
    if isinstance(error, MemoryError):
        return out_of_memory("there is not enough memory for it").during(name, arguments)
    has_sentence = is_a_sentence(error)
    if has_sentence and not isinstance(error, TypeError):
        return _begun_with(name, error)
    command = COMMANDS[name] if kinds is None else None
    kinds = command.arguments if command else kinds or ()
    for place, ((argument, kind), value) in enumerate(zip(kinds, arguments, strict=False)):
        count = numbers_wanted(command, arguments, place) if command and command.vector else None
        expected = _complaint(kind, value, count)
        if expected:
            return TypeError(f"{name}: {argument} must be {expected}, not {show(value)}")
    if has_sentence:
        return _begun_with(name, error)
    given = ", ".join(f"{argument} = {show(value)}" for (argument, _), value in zip(kinds, arguments, strict=False))
    unclear = TypeError(f"{name}: these arguments do not go together: {given}")
    unclear.add_note(f"({type(error).__name__}: {error})")  # below the sentence, for who looks for a mistake in glsim
    return unclear


def explained(name: str, function: F) -> F:
    """A function of GLU or GLUT, or one of PyOpenGL's forms of a GL command, that raises what ``explain`` makes."""

    @wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        try:
            return function(*arguments, **options)
        except Exception as error:
            explained_error = explain(error, name, arguments, _argument_kinds(function, len(arguments)))
            if explained_error is error and _raised_by_program(error):
                raise
            raise explained_error from None

    return call  # type: ignore[return-value]


# annotation of an argument -> its kind; for an object of GLU, the name of the function that makes it
ANNOTATED = {
    "float": "f", "int": "i", "bool": "boolean", "Quadric": "gluNewQuadric", "Nurbs": "gluNewNurbsRenderer",
    "Tessellator": "gluNewTess",
}  # fmt: skip
MADE_BY = {kind: annotation for annotation, kind in ANNOTATED.items() if kind.startswith("glu")}


def _argument_kinds(function: Callable[..., Any], count: int) -> Kinds:
    """Name and kind of each argument, from its annotation."""
    pairs: list[tuple[str, str]] = []
    for word, parameter in signature(function).parameters.items():
        if parameter.kind is parameter.VAR_POSITIONAL:
            pairs += [(f"argument {k + 1}", "") for k in range(len(pairs), count)]
        else:
            pairs.append((word, ANNOTATED.get(parameter.annotation, "")))
    return tuple(pairs)


def _begun_with(name: str, error: Exception) -> Exception:
    """The same exception with the call's name in front of its sentence."""
    begin, colon, rest = str(error).partition(": ")
    if begin != name and not begin.startswith(f"{name} "):
        error.args = (f"{name}: {rest if colon and related(begin, name) else error}",)
    return error


# what Python, NumPy and ctypes raise when they are given something they do not expect
MISUSE = (TypeError, ValueError, ArithmeticError, LookupError, BufferError, StructError, ArgumentError)
PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIBRARY = os.path.dirname(os.path.abspath(os.__file__))  # Python's own modules
RAISE = dis.opmap["RAISE_VARARGS"]


def _is_glsim(code: CodeType) -> bool:
    return code.co_filename.startswith((PACKAGE, "<gl command"))


def _raised_by_program(error: Exception) -> bool:
    """Whether the program's own code, called by glsim, raised it."""
    for frame, _ in walk_tb(error.__traceback__):
        file = frame.f_code.co_filename
        if not _is_glsim(frame.f_code) and not file.startswith((LIBRARY, "<frozen")) and "site-packages" not in file:
            return True
    return False


def is_a_sentence(error: Exception) -> bool:
    """Whether a ``raise`` of glsim made the error; if not, it has the words of Python, NumPy or ctypes.

    The bytecode instruction at which the innermost frame of the traceback stopped tells them apart:

        raise ValueError("size must be 2, 3 or 4")  # stopped at RAISE_VARARGS, in a file of glsim -> True
        float("a")                                  # stopped at CALL: float raised it             -> False
        values[7]                                   # stopped at BINARY_SUBSCR                     -> False
        int(argument)                               # RAISE_VARARGS in the program's own __int__   -> False
    """
    at = error.__traceback__
    while at is not None and at.tb_next is not None:
        at = at.tb_next
    if at is None:
        return True
    code = at.tb_frame.f_code
    return _is_glsim(code) and code.co_code[at.tb_lasti] == RAISE


def _complaint(kind: str, value: object, count: int | None) -> str:
    """What an argument of this kind must be, such as "a number"; "" if ``value`` is one.  count: length of an array."""
    if not kind:
        return ""
    if kind in MADE_BY:
        return "" if type(value).__name__ == MADE_BY[kind] else f"what {kind}() returned"
    if kind == "data":
        return _array_complaint(value, count)
    try:
        number = float(value)  # type: ignore[arg-type]
        if isinstance(value, (str, bytes, bytearray)) or np.ndim(value):  # type: ignore[arg-type]
            return "a number"
        if kind not in ("f", "d", "boolean"):
            int(number)
    except (TypeError, ValueError, OverflowError):
        return "a constant such as GL_LIGHTING" if kind == "enum" else "a number"
    if kind in NUMBERS and kind not in ("f", "d") and number != int(number):
        return "an integer"
    return ""


def _array_complaint(value: Any, count: int | None) -> str:
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
