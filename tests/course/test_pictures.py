"""The pictures beside the exercises are what their solutions draw.

To make one anew: python -m tests.course.test_pictures."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from glsim.course.asking import ask
from glsim.course.exercise import Exercise, Picture, exercises
from glsim.render.context import own_screen
from tests.course.grading import Forked, solution_of

WITH_PICTURES = [one for one in exercises() if any(isinstance(part, Picture) for part in one.definition.parts)]


def drawn(exercise: Exercise, folder: Path) -> np.ndarray:
    """The picture of an exercise's solution, (height, width, 3)."""
    path = folder / exercise.filename
    path.write_text(solution_of(exercise), encoding="utf-8")
    frame = ask(exercise, path, Forked()).frame
    assert frame is not None
    with own_screen(frame.width, frame.height) as screen:
        screen.execute(frame.packets)
        return np.ascontiguousarray(screen.pixels()[..., :3])


def names(exercise: Exercise) -> list[Path]:
    return [exercise.path.parent / part.name for part in exercise.definition.parts if isinstance(part, Picture)]


@pytest.mark.slow
@pytest.mark.parametrize("one", WITH_PICTURES, ids=lambda one: one.name)
def test_the_picture_is_what_the_solution_draws(one: Exercise, tmp_path: Path) -> None:
    for path in names(one):
        assert (np.asarray(Image.open(path).convert("RGB")) == drawn(one, tmp_path)).all()


if __name__ == "__main__":
    for one in WITH_PICTURES:
        if one.name in sys.argv[1:] or len(sys.argv) == 1:
            with tempfile.TemporaryDirectory() as folder:
                Image.fromarray(drawn(one, Path(folder))).save(names(one)[0], optimize=True)
