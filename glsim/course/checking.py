"""Checks a student's file: asks it, judges every part, and says the first thing that is wrong."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from glsim.course.asking import SECONDS, Answers, ask
from glsim.course.exercise import Call, Drawn, Exercise, Part, Picture, Shader, Value
from glsim.course.isolation import Isolation, Separate
from glsim.course.judging import Mark, failed, judge_call, judge_value, mark
from glsim.machine.frame import Frame
from glsim.metrics import amplified, difference


@dataclass(frozen=True)
class Result:
    """The marks of a file, one for each part of the exercise.  isolation: the name of that in which the file ran."""

    exercise: Exercise
    marks: tuple[Mark, ...]
    printed: str = ""
    note: str = ""
    isolation: str = Separate.name

    @cached_property
    def points(self) -> int:
        return sum(mark.points for mark in self.marks)

    @property
    def first_failure(self) -> Mark | None:
        return next((mark for mark in self.marks if not mark.right), None)


def check(exercise: Exercise, file: Path, isolation: Isolation | None = None, seconds: float = SECONDS) -> Result:
    """Judge a student's file.  isolation: none for the student's own machine.  seconds: that the file
    may run, and again that redrawing its picture may take.

    Raises FileNotFoundError if there is no such file."""
    isolation = isolation or Separate()
    return judged(exercise, ask(exercise, file, isolation, seconds), isolation, seconds)


def judged(
    exercise: Exercise, answers: Answers, isolation: Isolation | None = None, seconds: float = SECONDS
) -> Result:
    """The marks for a file's answers.  isolation: in which the file ran, and in which its picture is redrawn.
    seconds: that redrawing may take."""
    isolation = isolation or Separate()
    marks = tuple(
        _judge(exercise, part, answer, answers, isolation, seconds)
        for part, answer in zip(exercise.definition.parts, answers.values, strict=True)
    )
    return Result(exercise, marks, answers.printed, answers.note, isolation.name)


def _judge(
    exercise: Exercise, part: Part, answer: dict[str, object], answers: Answers, isolation: Isolation, seconds: float
) -> Mark:
    if isinstance(part, Call):
        return judge_call(part, answer)
    if isinstance(part, Value):
        return judge_value(part, answer)
    if isinstance(part, Shader):
        from glsim.course.shaders import judge_shader

        return judge_shader(part, answer)
    if answers.frame is None or answer.get("error"):
        return failed(part, answer)
    if isinstance(part, Drawn):
        return _judge_frame(part, answers.frame)
    return _judge_picture(exercise, part, answers.frame, isolation, seconds)


def _judge_frame(part: Drawn, frame: Frame) -> Mark:
    """What the part's judge says of a Frame.  One that it stumbles over is not right either."""
    try:
        return mark(part, part.judge(frame) or "")
    except Exception as error:  # any number may stand in a student's matrices
        return mark(part, f"what the program draws cannot be judged ({error}): is a scale 0, or a number not finite?")


def _judge_picture(exercise: Exercise, part: Picture, frame: Frame, isolation: Isolation, seconds: float) -> Mark:
    """Redraw the Frame and compare it with the picture beside the exercise, by the rule for other renderers."""
    from glsim.course.redrawing import RedrawError, redrawn
    from glsim.testing.rule import broken

    expected = np.asarray(Image.open(exercise.path.parent / part.name).convert("RGB"))
    height, width = expected.shape[:2]
    if (frame.width, frame.height) != (width, height):
        return mark(part, f"the picture has {frame.width} x {frame.height} pixels, and {width} x {height} are expected")
    try:
        actual = redrawn(frame, isolation, seconds)
    except RedrawError as error:
        return mark(part, str(error))
    return mark(part, part.hint if broken(expected, actual) else "", expected=expected, actual=actual)


def side_by_side(expected: NDArray[np.uint8], actual: NDArray[np.uint8]) -> Image.Image:
    """Expected picture, actual picture and 8 times their difference, labelled, in a row."""
    from glsim.pictures import tiles

    pictures = [("expected", expected), ("yours", actual)]
    if expected.shape == actual.shape:
        pictures.append(("8 times the difference", amplified(difference(expected, actual), 8)))
    return tiles("", [pictures])
