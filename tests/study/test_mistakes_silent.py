"""Where the rules of glsim.study.mistakes stay silent: what looks like a mistake and is meant."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import glsim
from glsim.gl import *
from glsim.study.trace import mistakes_of
from tests.drawing import captured
from tests.oracle import PROGRAMS
from tests.study import meant_shapes  # noqa: F401  (it fills the lists)
from tests.study.meant import MEANT, WRONG


def kinds(program: Callable[[], None]) -> list[str]:
    return [found.kind for found in glsim.trace(captured(program)).mistakes]


@pytest.mark.parametrize("program", MEANT, ids=lambda program: program.__name__)
def test_what_is_meant_is_no_mistake(program: Callable[[], None], screen: glsim.Offscreen) -> None:
    assert kinds(program) == []


@pytest.mark.parametrize("program", WRONG, ids=lambda program: program.__name__)
def test_variants_of_a_mistake_are_found(program: Callable[[], None], screen: glsim.Offscreen) -> None:
    assert kinds(program) == [WRONG[program]]


# Programs of the comparison with the driver that do what a rule is about, most of them on purpose.
TRUE = {
    "cull_back_ccw": "culled-front", "incomplete_textures_are_off": "incomplete-texture",
    "list_compiled_and_executed": "color-ignored", "ortho_and_viewport": "no-depth-test",
    "smooth_lines_on_the_faces_of_a_ball": "projection-in-modelview",
    **dict.fromkeys(
        ("evaluator_surface_auto_normal_vertex_3", "evaluator_surface_auto_normal_vertex_4", "inside_two_sided",
         "inside_two_sided_flat", "inside_two_sided_separate_specular", "color_material_back_only"), "normals-opposed",
    ),
}  # fmt: skip
OLD = {"normals-not-unit", "normals-scaled", "highlight-lost", "depth-not-cleared"}  # often on purpose there


@pytest.mark.slow
def test_programs_that_are_compared_with_the_driver(screen: glsim.Offscreen) -> None:
    found = {}
    for name, program in PROGRAMS.items():
        screen.reset()
        for kind in {entry.kind for entry in mistakes_of(captured(program))} - OLD:
            found[name] = kind
    assert found == TRUE
