"""Exercises in GLSL: the real shader, compiled with the function that a student wrote."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.course.exercise import Shader
from glsim.course.judging import Mark, failed, mark
from glsim.files import data_folder
from glsim.machine.frame import Frame
from glsim.play.capture import capture
from glsim.render.compile import ShaderError
from glsim.render.context import drawn, own_screen
from glsim.render.programs import shader_replaced


class FunctionError(ValueError):
    """The text has no such function, or is no GLSL."""


@cache
def frame_for(part: Shader) -> Frame:
    """The test picture of a part, recorded."""
    with own_screen(*part.size), capture() as frame:
        part.draw()
    return frame


def replaced(file: str, function: str, text: str) -> str:
    """The text of shaders/``file`` with ``text``, which defines ``function`` anew, in the place of that function.

    #line directives let the compiler's messages name the line of ``text``.
    Raises FunctionError if ``text`` has no such function."""
    source = (data_folder("shaders") / file).read_text(encoding="utf-8")
    if _function(text, function) is None:
        raise FunctionError(f"the file defines no function {function}")
    present = _function(source, function)
    assert present is not None, f"shaders/{file} has no function {function}"
    after = source[: present.end()].count("\n") + 1
    return f"{source[: present.start()]}\n#line 1\n{text}\n#line {after}\n{source[present.end() :]}"


def _function(text: str, name: str) -> re.Match[str] | None:
    """A function of GLSL whose closing brace stands at the beginning of a line."""
    return re.search(rf"^\w+ {name}\([^)]*\)\s*\{{.*?^\}}", text, re.MULTILINE | re.DOTALL)


def drawn_with(frame: Frame, file: str, function: str, text: str) -> NDArray[np.uint8]:
    """The picture of a Frame, (height, width, 4), drawn with the student's function.

    Raises FunctionError without such a function, or with the compiler's first message."""
    with shader_replaced(file, replaced(file, function, text)):
        try:
            return drawn(frame)
        except ShaderError as error:
            raise FunctionError(_first_message(str(error))) from None


def _first_message(text: str) -> str:
    """The compiler's first message, with the line of the student's text if it says one."""
    found = re.search(r"^constants:(\d+):\s*(?:error:)?\s*(.+)$", text, re.MULTILINE)
    return f"line {found[1]}: {found[2]}" if found else " ".join(text.split())[:300]


def judge_shader(part: Shader, answer: dict[str, Any]) -> Mark:
    """Compare the picture that the student's function gives with the right one, then with those of typical mistakes."""
    value = answer.get("value")
    if value is None:
        return failed(part, answer)
    expected = _expected(part)
    try:
        actual = np.asarray(value, np.uint8)
    except (TypeError, ValueError, OverflowError):
        return failed(part, {})
    if actual.shape != expected.shape:
        return failed(part, {})
    if _alike(actual, expected):
        return mark(part)
    for text, hint in part.mistakes:
        if _alike(actual, _mistaken(part, text)):
            return mark(part, hint, expected=expected, actual=actual)
    return mark(part, part.hint, expected=expected, actual=actual)


@cache
def _expected(part: Shader) -> NDArray[np.uint8]:
    return np.ascontiguousarray(drawn(frame_for(part))[..., :3])


@cache
def _mistaken(part: Shader, text: str) -> NDArray[np.uint8]:
    return drawn_with(frame_for(part), part.file, part.function, text)[..., :3]


def _alike(a: NDArray[np.uint8], b: NDArray[np.uint8]) -> bool:
    """Whether two pictures of one shader may differ only by rounding."""
    return int(np.abs(a.astype(np.int16) - b).max(initial=0)) <= 1
