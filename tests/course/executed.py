"""Lessons that were run, for the tests that look at their outputs: each lesson is run once in a process."""

from __future__ import annotations

from functools import cache

from glsim.course.cells import lesson
from glsim.course.outputs import Output, execute


@cache
def outputs_of(name: str) -> tuple[Output, ...]:
    """The outputs of glsim's own lesson of this name, such as 07_lambert."""
    return tuple(execute(lesson(name)))
