"""Every exercise: right solutions get all points, the starter and typical mistakes lose some, with the right hint."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.cli import main
from glsim.course.asking import Answers
from glsim.course.cells import lessons
from glsim.course.checking import judged
from glsim.course.exercise import Definition, Drawn, Exercise, Picture, exercises
from glsim.course.handout import hints, starter
from glsim.course.isolation import Separate
from glsim.course.redrawing import redrawn
from glsim.machine.frame import Frame
from glsim.render.context import drawn
from tests.course.grading import VARIANTS, changed, marks_of, solution_of, variants_of

EXERCISES = exercises()
QUICK = 2  # mistakes of each exercise that are tried in a quick run; programs are processes, and slow
WRONG = [
    pytest.param(
        one, name, id=f"{one.name}-{name}", marks=pytest.mark.slow if k >= QUICK or one.definition.program else ()
    )
    for one in EXERCISES
    if (VARIANTS / f"{one.name}.py").exists()
    for k, name in enumerate(variants_of(one.name).WRONG)
]


ASKED = [pytest.param(one, id=one.name, marks=pytest.mark.slow if one.definition.program else ()) for one in EXERCISES]


@pytest.mark.parametrize("one", ASKED)
def test_right_solutions_get_all_points(one: Exercise, tmp_path: Path) -> None:
    variants = variants_of(one.name).RIGHT
    assert len(variants) >= 2, "two solutions beside the reference, written differently"
    for text in (solution_of(one), *variants.values()):
        result = marks_of(one, text, tmp_path)
        assert result.first_failure is None, f"{result.first_failure}\n{text}"
        assert result.points == one.points


@pytest.mark.parametrize("one", ASKED)
def test_the_starter_fails_with_a_hint(one: Exercise, tmp_path: Path) -> None:
    result = marks_of(one, starter(one), tmp_path)
    assert result.first_failure is not None
    assert result.first_failure.hint
    assert "Error" not in result.first_failure.hint, "the starter runs"
    assert len(variants_of(one.name).WRONG) >= 8, "eight typical mistakes"


@pytest.mark.parametrize(("one", "name"), WRONG)
def test_a_mistake_loses_points_and_gets_its_hint(one: Exercise, name: str, tmp_path: Path) -> None:
    change, words = variants_of(one.name).WRONG[name]
    result = marks_of(one, changed(one, change), tmp_path)
    assert result.first_failure is not None, "the mistake is not noticed"
    assert result.points < one.points
    assert words in result.first_failure.hint, result.first_failure.hint


def test_every_exercise_belongs_to_a_lesson_that_names_it() -> None:
    course = {one.number: one for one in lessons()}
    for one in EXERCISES:
        lesson = course.get(one.definition.lesson)
        assert lesson is not None, f"{one.name}: there is no lesson {one.definition.lesson}"
        text = "\n".join(cell.source for cell in lesson.cells)
        assert f"Exercise {one.number}" in text, f"lesson {lesson.number} does not name exercise {one.number}"


def test_whatever_names_an_exercise_names_its_lesson(capsys: pytest.CaptureFixture[str]) -> None:
    """Exercise 3 belongs to lesson 7: a number alone would be taken for the other."""
    belongs = {str(one.number): f"{one.number} (lesson {one.definition.lesson}):" for one in EXERCISES}
    for lesson in lessons():
        for cell in lesson.cells:
            for number in re.findall(r"\bExercises? (\d+)", cell.source):
                assert f"Exercise {belongs[number]}" in cell.source, f"{lesson.name}: exercise {number}"
    assert main(["exercise", "list"]) == 0
    listed = capsys.readouterr().out.splitlines()
    assert [f"(lesson {one.definition.lesson})" in line for one, line in zip(EXERCISES, listed, strict=True)]
    one = next(one for one in EXERCISES if one.number != one.definition.lesson)
    assert main(["exercise", "show", str(one.number)]) == 0
    assert one.heading in capsys.readouterr().out
    assert one.heading in starter(one)
    assert one.heading == f"Exercise {belongs[str(one.number)]} {one.title}"


def test_a_frame_over_which_a_judge_stumbles_gets_no_points() -> None:
    part = Drawn("the camera", lambda frame: str(np.linalg.inv(np.zeros((4, 4)))))
    one = Exercise(Path("01_x.py"), 1, "", Definition("", 1, "", [part], program=True))
    result = judged(one, Answers([{}], Frame(8, 8)))
    assert result.points == 0
    assert "cannot be judged" in result.marks[0].hint


@pytest.mark.parametrize("one", EXERCISES, ids=lambda one: one.name)
def test_no_text_of_an_exercise_holds_its_solution(one: Exercise) -> None:
    """Lines of the solution's code are neither in the starter nor in the hints."""
    code = [line.strip() for line in solution_of(one).splitlines() if line.strip().startswith("return ")]
    shown = one.definition.starter + "\n".join(hints(one)) + one.statement
    assert not [line for line in code if len(line) > 16 and line in shown]


def test_a_shown_statement_keeps_the_signs_of_its_formulas(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["exercise", "show", "area_light"]) == 0
    shown = capsys.readouterr().out
    assert r"$\mathbf{\Gamma}_k$" in shown
    assert r"\sum_k \gamma_k\," in shown


@pytest.mark.slow
def test_drawing_a_students_frame_again_has_a_time_limit(tmp_path: Path) -> None:
    """How much is drawn is the program's choice; within the limit it is the picture that is drawn here."""
    one = next(one for one in EXERCISES if any(isinstance(part, Picture) for part in one.definition.parts))
    with glsim.offscreen(32, 24), glsim.capture() as frame:
        glsim.gl.glRectf(-0.5, -0.5, 0.5, 0.2)
    assert np.array_equal(redrawn(frame, Separate(), 60.0), drawn(frame)[..., :3])
    part = next(part for part in one.definition.parts if isinstance(part, Picture))
    with Image.open(one.path.parent / part.name) as expected:
        frame.width, frame.height = expected.size
    frame.packets *= 300_000
    alone = replace(one, definition=replace(one.definition, parts=[part]))
    result = judged(alone, Answers([{}], frame), seconds=1.5)
    assert result.points == 0
    assert "cannot be drawn again within 1.5 seconds" in result.marks[0].hint
