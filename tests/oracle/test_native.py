"""glsim draws what the driver's own fixed function draws."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import glsim
from glsim.machine.frame import Call
from glsim.play.capture import capture
from glsim.render.native import Native, NoNativeError
from tests.oracle import PROGRAMS
from tests.oracle.line_programs import LINES, SMOOTH
from tests.oracle.measure import Difference, measure
from tests.oracle.pixel_programs import ACCUMULATED

# A concave or self-crossing polygon has no defined triangulation, so nothing is asserted about where it is split.


def both(screen: glsim.Offscreen, native: Native, draw: Callable[[], None]) -> Difference:
    with capture(calls=True) as frame:
        draw()
    errors: list[tuple[str, int]] = []
    reference = native.replay(frame.calls, errors)
    assert not errors
    assert reference.any(), "the program draws nothing"
    return measure(screen.pixels(), reference)


# Single pixels whose direction lies just between two faces of a cube map.
BETWEEN_FACES = {"cube_map_normal_map", "cube_map_object_linear"}


@pytest.mark.parametrize("name", PROGRAMS)
def test_program(name: str, screen: glsim.Offscreen, native: Native) -> None:
    found = both(screen, native, PROGRAMS[name])
    assert found.coverage == 0, f"{found.coverage} pixels are covered by one only"
    assert found.within_1 >= 0.999, found
    assert found.worst <= 3 or name in BETWEEN_FACES, found


def test_accumulation(screen: glsim.Offscreen) -> None:
    drawn = {}
    for name, draw in ACCUMULATED.items():
        screen.reset()
        with capture(calls=True) as frame:
            draw()
        drawn[name] = screen.pixels(), frame.calls
    try:
        native = Native(screen.width, screen.height, ("osmesa",))
    except NoNativeError as error:
        pytest.skip(f"no accumulation buffer to compare with: {error}")
    for name, (ours, calls) in drawn.items():
        errors: list[tuple[str, int]] = []
        found = measure(ours, native.replay(calls, errors))
        assert not errors
        assert found.worst <= 1, (name, found)
    native.release()


def grown(covered: np.ndarray) -> np.ndarray:
    """Covered pixels and their neighbours."""
    padded = np.pad(covered, 1)
    height, width = covered.shape
    return np.any([padded[y : y + height, x : x + width] for y in range(3) for x in range(3)], axis=0)


@pytest.mark.parametrize("name", LINES)
def test_wide_and_stippled_lines(name: str, screen: glsim.Offscreen, native: Native) -> None:
    with capture(calls=True) as frame:
        LINES[name]()
    fresh = Native(screen.width, screen.height)  # after other replays Mesa's glPopAttrib has not put back all lighting
    ours, theirs = screen.pixels(), fresh.replay(frame.calls)
    fresh.release()
    a, b = ours.any(axis=2), theirs.any(axis=2)
    assert a.sum() == pytest.approx(b.sum(), rel=0.06)
    far = (a & ~grown(b)) | (b & ~grown(a))
    assert far.sum() <= (3 if "stipple" in name else 0), "more than a pixel apart"
    assert measure(ours, theirs).within_1 > 0.99


@pytest.mark.parametrize("name", SMOOTH)
def test_clipped_smooth_lines(name: str, screen: glsim.Offscreen, native: Native) -> None:
    found = both(screen, native, SMOOTH[name])
    assert found.coverage == 0
    assert found.worst <= 3


def test_the_comparison_can_fail(screen: glsim.Offscreen, native: Native) -> None:
    with capture(calls=True) as frame:
        PROGRAMS["light_default"]()
    other = [
        call._replace(arguments=(call.arguments[0], 0.1, *call.arguments[2:])) if call.name == "glVertex3f" else call
        for call in frame.calls
    ]
    assert measure(screen.pixels(), native.replay(other)).coverage > 0
    assert np.any(screen.pixels())


def test_a_replay_leaves_no_colour_behind(native: Native, screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        PROGRAMS["ortho_and_viewport"]()
    before = native.replay(frame.calls).copy()
    native.replay([Call("glColor4s", (40, -1, 0, 3))])
    assert (native.replay(frame.calls) == before).all()
