"""What tests of exercises share: marks of a text, without a process for each."""

from __future__ import annotations

import importlib
import importlib.util
import multiprocessing
import os
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from types import ModuleType

from glsim.course.answering import answered
from glsim.course.asking import Answers, request_for
from glsim.course.checking import Result, check, judged
from glsim.course.exercise import Exercise

HERE = Path(__file__).parent
SOLUTIONS, VARIANTS = HERE / "solutions", HERE / "variants"


class Forked:
    """For programs: a process that begins with glsim imported already, which is several times as quick."""

    name = "forked"

    def run(self, command: Sequence[str], folder: Path, seconds: float) -> str:
        """Run ``python -P -m module arguments...``, as the isolations of glsim.course do."""
        context = multiprocessing.get_context("forkserver")
        context.set_forkserver_preload(["glsim.play.player", "glsim.play.capture", "glsim.glut.shapes", "glsim.glu"])
        process = context.Process(target=_run_module, args=(command[3:], str(folder / "work")))
        process.start()
        process.join(seconds)
        if process.is_alive():
            process.kill()
            process.join()
            return f"stopped after {seconds:g} seconds"
        return "" if process.exitcode == 0 else f"the process ended with exit code {process.exitcode}"


def _run_module(command: Sequence[str], folder: str) -> None:
    os.chdir(folder)
    nothing = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 1)
    os.dup2(nothing, 2)
    sys.argv[1:] = command[1:]
    importlib.import_module(command[0]).main()


def solution_of(exercise: Exercise) -> str:
    return (SOLUTIONS / exercise.filename).read_text(encoding="utf-8")


@cache
def variants_of(name: str) -> ModuleType:
    """The module tests/course/variants/NN_topic.py.

    RIGHT: name -> text of a right solution that is written differently.
    WRONG: name -> (what is wrong, words of the hint).  What is wrong is a whole text, or a list of pairs (old, new) to
    be replaced in the solution."""
    spec = importlib.util.spec_from_file_location(f"variants_{name}", VARIANTS / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def changed(exercise: Exercise, change: str | list[tuple[str, str]]) -> str:
    """A wrong text: the solution with replacements, or the text itself."""
    if isinstance(change, str):
        return change
    text = solution_of(exercise)
    for old, new in change:
        assert old in text, f"{exercise.name}: the solution has no {old!r}"
        text = text.replace(old, new)
    return text


def marks_of(exercise: Exercise, text: str, folder: Path) -> Result:
    """The result for a text; programs that draw run in a process of their own."""
    path = folder / exercise.filename
    path.write_text(text, encoding="utf-8")
    if exercise.definition.program:
        return check(exercise, path, Forked())
    document = answered(request_for(exercise, path, folder))
    return judged(exercise, Answers(document["answers"], printed=document["printed"]))
