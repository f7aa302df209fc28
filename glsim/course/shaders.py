"""Exercises in GLSL: the real shader, compiled with the function that a student wrote."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.course.exercise import Shader
from glsim.course.judging import Mark, failed, mark
from glsim.files import data_folder
from glsim.machine.frame import Frame
from glsim.play.capture import capture
from glsim.render.context import own_screen
from glsim.render.programs import shader_replaced


class FunctionError(ValueError):
    """The text has no such function."""


def frame_for(part: Shader) -> Frame:
    """The test picture of a part, recorded."""
    with own_screen(*part.size), capture() as frame:
        part.draw()
    return frame


def replaced(file: str, function: str, text: str) -> str:
    """The text of shaders/``file`` with ``function`` replaced by the function of that name in ``text``.

    #line directives let the compiler's messages name the line of ``text``.
    Raises FunctionError if ``text`` has no such function."""
    source = (data_folder("shaders") / file).read_text(encoding="utf-8")
    written = _function(text, function)
    if written is None:
        raise FunctionError(f"the file defines no function {function}")
    present = _function(source, function)
    assert present is not None, f"shaders/{file} has no function {function}"
    line = text[: written.start()].count("\n") + 1
    after = source[: present.end()].count("\n") + 1
    return f"{source[: present.start()]}\n#line {line}\n{written[0]}\n#line {after}\n{source[present.end() :]}"


def _function(text: str, name: str) -> re.Match[str] | None:
    """A function of GLSL whose closing brace stands at the beginning of a line."""
    return re.search(rf"^\w+ {name}\([^)]*\)\s*\{{.*?^\}}", text, re.MULTILINE | re.DOTALL)


def drawn_with(frame: Frame, file: str, function: str, text: str) -> NDArray[np.uint8]:
    """The picture of a Frame, (height, width, 4), drawn with the student's function.

    Raises FunctionError, or ValueError with the compiler's message."""
    with shader_replaced(file, replaced(file, function, text)), own_screen(frame.width, frame.height) as screen:
        screen.execute(frame.packets)
        return screen.pixels()


def judge_shader(part: Shader, answer: dict[str, Any]) -> Mark:
    """Compare the picture that the student's function gives with the right one, then with those of typical mistakes."""
    value = answer.get("value")
    if value is None:
        return failed(part, answer)
    frame = frame_for(part)
    with own_screen(*part.size) as screen:
        screen.execute(frame.packets)
        expected = np.ascontiguousarray(screen.pixels()[..., :3])
    try:
        actual = np.asarray(value, np.uint8)
    except (TypeError, ValueError, OverflowError):
        return failed(part, {})
    if actual.shape != expected.shape:
        return failed(part, {})
    if _alike(actual, expected):
        return mark(part)
    for text, hint in part.mistakes:
        if _alike(actual, drawn_with(frame, part.file, part.function, text)[..., :3]):
            return mark(part, hint, expected=expected, actual=actual)
    return mark(part, part.hint, expected=expected, actual=actual)


def _alike(a: NDArray[np.uint8], b: NDArray[np.uint8]) -> bool:
    """Whether two pictures of one shader may differ only by rounding."""
    return int(np.abs(a.astype(np.int16) - b).max(initial=0)) <= 1
