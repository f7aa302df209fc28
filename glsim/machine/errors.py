"""What a program is told when it asks for something OpenGL does not allow."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from glsim.machine import constants as gl
from glsim.machine.constants import Enum


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
        """The same error, of a call that made the failing one: glLight makes glLightfv, say."""
        inner = self.baseOperation or name
        if not related(inner, name):
            self.description = f"{inner}: {self.description}"
        self.baseOperation, self.cArguments = name, tuple(arguments)
        return self

    def __str__(self) -> str:
        call = f"{self.baseOperation}: " if self.baseOperation else ""
        return f"{call}{self.description} ({self.err!r})"


class NoContextError(RuntimeError):
    """A gl command was called while no context is current.  A program that uses GLUT is told of glutCreateWindow."""

    uses_glut = False  # glutInit sets it to True

    def __str__(self) -> str:
        problem, _, remedy = super().__str__().partition(": ")
        if self.uses_glut and "glsim.offscreen" in remedy:
            return f"{problem}: call glutCreateWindow before the first gl command"
        return super().__str__()


def invalid_enum(argument: str, value: object, expected: str) -> GLError:
    return GLError(gl.GL_INVALID_ENUM, f"{argument} must be {expected}, not {show(value)}")


def invalid_value(argument: str, value: object, expected: str) -> GLError:
    return GLError(gl.GL_INVALID_VALUE, f"{argument} must be {expected}, not {show(value)}")


def invalid_operation(sentence: str) -> GLError:
    return GLError(gl.GL_INVALID_OPERATION, sentence)


def stack_overflow(sentence: str) -> GLError:
    return GLError(gl.GL_STACK_OVERFLOW, sentence)


def stack_underflow(sentence: str) -> GLError:
    return GLError(gl.GL_STACK_UNDERFLOW, sentence)


def out_of_memory(sentence: str) -> GLError:
    return GLError(gl.GL_OUT_OF_MEMORY, sentence)


def show(value: object) -> str:
    """A value as a message quotes it: never longer than a line."""
    if isinstance(value, int) and not isinstance(value, (bool, Enum)):
        if value.bit_length() > 64:
            return f"a number of {value.bit_length()} bits"
        return f"{value} (0x{value:X})" if value > 255 else str(value)
    array: Any = value if hasattr(value, "dtype") and hasattr(value, "tolist") else None
    text = repr(value) if array is None else repr(array.tolist())
    if array is not None and array.size > 4:
        text = f"an array of shape {array.shape}"
    return text if len(text) <= 60 else text[:57] + "..."


def related(one: str, other: str) -> bool:
    """Whether two names are variants of a call: glLight and glLightfv."""
    return one.startswith(other) or other.startswith(one)
