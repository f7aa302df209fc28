"""Marks: compares what a student's file answered with what is expected, and finds the hint for what is wrong."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.course.exercise import Call, Part, Value

Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class Mark:
    """The judgement of one part.

    about: what the part asks.  points: of ``most``.  hint: what is wrong, in the lecture's terms; "" if it is right.
    expected, actual: pictures (height, width, 3) uint8, if the part is judged by its picture."""

    about: str
    points: int
    most: int
    hint: str = ""
    expected: NDArray[np.uint8] | None = None
    actual: NDArray[np.uint8] | None = None

    @property
    def right(self) -> bool:
        return self.points == self.most


def mark(part: Part, hint: str = "", **pictures: Any) -> Mark:
    """The mark of a part: all its points without a hint, none with one."""
    return Mark(part.about, 0 if hint else part.points, part.points, hint, **pictures)


def failed(part: Part, answer: dict[str, Any]) -> Mark:
    """The mark of a part whose code raised an exception, or that was not answered."""
    line = f"line {answer['line']}: " if isinstance(answer.get("line"), int) else ""
    return mark(part, f"{line}{answer.get('error') or 'no answer came'}")


def judge_call(part: Call, answer: dict[str, Any]) -> Mark:
    """Compare a function's values for all arguments with the right function's, then with those of typical mistakes."""
    values = answer.get("value")
    if not isinstance(values, list) or len(values) != len(part.arguments):
        return failed(part, answer)
    expected = [np.asarray(part.expected(*arguments), float) for arguments in part.arguments]
    for arguments, wanted, value in zip(part.arguments, expected, values, strict=True):
        wrong = unusable(value, wanted, part.function)
        if wrong:
            return mark(part, f"{wrong}; it was called as {shown_call(part.function, arguments)}")
    actual = [as_numbers(value) for value in values]
    if agree(actual, expected, part.tolerance):
        return mark(part)
    for mistake in part.mistakes:
        with np.errstate(all="ignore"):
            typical = [np.asarray(mistake.answer(*arguments), float) for arguments in part.arguments]
        if agree(actual, typical, part.tolerance):
            return mark(part, mistake.hint)
    return mark(part, f"{part.hint} {example(part, expected, actual)}")


def judge_value(part: Value, answer: dict[str, Any]) -> Mark:
    """Compare constants."""
    values = answer.get("value")
    if not isinstance(values, list) or len(values) != len(part.expected):
        return failed(part, answer)
    for (name, right), value in zip(part.expected.items(), values, strict=True):
        wanted = np.asarray(right, float)
        wrong = unusable(value, wanted, name)
        if wrong:
            return mark(part, wrong)
        if agree([as_numbers(value)], [wanted], part.tolerance):
            continue
        for typical, hint in part.wrong.get(name, ()):
            typical = np.asarray(typical, float)
            if typical.shape == wanted.shape and agree([as_numbers(value)], [typical], part.tolerance):
                return mark(part, hint)
        return mark(part, f"{name}: {part.hint}")
    return mark(part)


def as_numbers(value: Any) -> Numbers:
    return np.asarray(value, dtype=np.float64)


def unusable(value: Any, wanted: Numbers, name: str) -> str:
    """A sentence if an answer cannot be compared: no numbers, another shape, NaN or infinity; else ""."""
    try:
        given = as_numbers(value)
    except (TypeError, ValueError):
        return f"{name} must be numbers"
    if given.shape != wanted.shape and given.squeeze().shape != wanted.squeeze().shape:
        return f"{name} gives {words(given.shape)}; expected: {words(wanted.shape)}"
    if not np.isfinite(given).all() and np.isfinite(wanted).all():
        kind = "NaN" if np.isnan(given).any() else "infinity"
        return f"{name} gives {kind}: is there a division by 0, or a root of a negative number?"
    return ""


def words(shape: tuple[int, ...]) -> str:
    """A shape in words: "a number", "3 numbers", "a 2 x 3 array"."""
    if shape in ((), (1,)):
        return "a number"
    return f"{shape[0]} numbers" if len(shape) == 1 else f"a {' x '.join(map(str, shape))} array"


def agree(actual: list[Numbers], expected: list[Numbers], tolerance: float) -> bool:
    """Whether no number is off by more than ``tolerance`` times the largest expected number, or times 1 if that is
    more."""
    for a, b in zip(actual, expected, strict=True):
        if a.squeeze().shape != b.squeeze().shape:
            return False
        scale = max(1.0, float(np.abs(b[np.isfinite(b)]).max(initial=0.0)))
        if not np.allclose(a.squeeze(), b.squeeze(), rtol=0.0, atol=tolerance * scale, equal_nan=False):
            return False
    return True


def example(part: Call, expected: list[Numbers], actual: list[Numbers]) -> str:
    """The simplest arguments with a wrong value, and the values: "lambert([0, 0, 1], [0, 1, 0]) gives 1, not 0"."""
    for arguments, wanted, value in zip(part.arguments, expected, actual, strict=True):
        if not agree([value], [wanted], part.tolerance):
            call = shown_call(part.function, arguments)
            return f"{call} gives {shown_number(value)}; expected: {shown_number(wanted)}"
    return ""


def shown_call(function: str, arguments: tuple[Any, ...]) -> str:
    return f"{function}({', '.join(shown_number(argument) for argument in arguments)})"


def shown_number(value: Any) -> str:
    if isinstance(value, (str, bool)) or value is None or callable(value):
        return repr(value)
    array = np.asarray(value)
    if array.dtype == object or array.size > 16:
        return f"<{words(array.shape)}>"
    text = np.array2string(array, precision=4, separator=", ", suppress_small=True, floatmode="maxprec")
    return text.replace("\n", "")
