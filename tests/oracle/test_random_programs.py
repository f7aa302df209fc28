"""Random valid programs look the same by glsim and by the driver's fixed function."""

from __future__ import annotations

import numpy as np
import pytest

import glsim
from glsim.render.native import Native
from tests.drawing import portions
from tests.oracle.author import Author
from tests.oracle.random_programs import flag, pictures, shortest, whole

PORTIONS, PROGRAMS = 200, 2  # 400 programs a run; python -m tests.oracle.random_programs --count 5000 makes more


@pytest.mark.parametrize("portion", portions(PORTIONS))
def test_random_programs(portion: int, screen: glsim.Offscreen, native: Native) -> None:
    found = []
    for seed in range(portion * PROGRAMS, (portion + 1) * PROGRAMS):
        lines = Author(seed).program()
        said = flag(lines, screen)
        if said:
            found.append("\n".join([f"# seed {seed}: {said}", *lines]))
    assert not found, "\n\n".join(found)


def test_programs_draw_something(screen: glsim.Offscreen, native: Native) -> None:
    drawn = [np.any(pictures(Author(seed).program(), screen)[1]) for seed in range(10)]
    assert sum(drawn) >= 8


def test_a_difference_is_found_and_made_short(screen: glsim.Offscreen, native: Native) -> None:
    """The driver replays calls, so what a program asks of glsim alone makes the two pictures differ."""
    same = ["glClear(GL_COLOR_BUFFER_BIT)", "glColor3f(0, 1, 0)", "glRectf(-0.5, -0.5, 0.5, 0.5)"]
    assert flag(same, screen) == ""
    odd = "from glsim.machine.current import current_machine; current_machine().red = 0.5"
    lines = [*same[:2], "glEnable(GL_DEPTH_TEST)", odd, "glPushMatrix()", same[2], "glPopMatrix()"]
    assert flag(lines, screen).startswith("Difference(coverage=0, worst=128")
    assert shortest(lines, lambda fewer: whole(fewer) and bool(flag(fewer, screen))) == [odd, same[2]]
