"""Random calls, legal and illegal, in and out of order: errors are the driver's.  test_calls.py has stranger ones.

Where a call would read a program's memory the driver is left out: it would crash where glsim raises.
"""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import glsim
from glsim import gl
from glsim.machine.commands import COMMANDS, Command
from glsim.machine.frame import Call
from glsim.render.native import Native

SUPPORTED = list(COMMANDS.values())
ENUMS = sorted({int(getattr(gl, name)) for name in gl.__all__ if name.startswith("GL_")})
LIKELY_NAMES = """
GL_LIGHTING GL_LIGHT0 GL_LIGHT7 GL_DEPTH_TEST GL_FRONT GL_BACK GL_FRONT_AND_BACK GL_AMBIENT GL_DIFFUSE GL_POSITION
GL_SHININESS GL_SPOT_CUTOFF GL_MODELVIEW GL_PROJECTION GL_FLAT GL_SMOOTH GL_TRIANGLES GL_QUADS GL_LINE_LOOP GL_LESS
GL_ALWAYS GL_FOG_MODE GL_LINEAR GL_TEXTURE_2D GL_ONE GL_SRC_ALPHA GL_CW GL_LINE GL_FILL GL_KEEP GL_COMPILE
"""
LIKELY = [int(getattr(gl, name)) for name in LIKELY_NAMES.split()]
NUMBERS = st.one_of(
    st.integers(-3, 40), st.sampled_from([0.0, 1.0, -1.0, 0.5, 90.0, 129.0, 1e30, float("inf"), float("nan")])
)


def argument(kind: str) -> st.SearchStrategy[Any]:
    if kind == "enum":
        return st.one_of(st.sampled_from(LIKELY), st.sampled_from(ENUMS), st.integers(0, 70000))
    if kind == "bitfield":
        return st.integers(0, 0x1FFFF)
    return NUMBERS if kind in ("f", "d") else st.integers(-3, 40)


# Commands without pointers and without state that only one of the two has.
COMPARED = [
    command
    for command in SUPPORTED
    if not command.result
    and all(kind != "data" for _, kind in command.arguments)
    and command.family
    not in ("glBegin", "glEnd", "glArrayElement", "glDrawArrays", "glNewList", "glEndList", "glCallList")
    and command.family not in ("glPixelStore", "glMultiTexCoord", "glClientActiveTexture", "glActiveTexture", "glHint")
    and command.family != "glAccum"  # the driver's context has no accumulation buffer
    and not any(part in command.name for part in ("Copy", "Attrib", "PushMatrix", "PopMatrix", "Query"))
    # the oracle uses the first, and knows later targets of queries
]
FINITE = st.one_of(st.integers(-3, 40), st.sampled_from([0.0, 1.0, -1.0, 0.5, 90.0, 129.0]))


def comparable(command: Command) -> st.SearchStrategy[tuple[str, tuple[Any, ...]]]:
    kinds = (FINITE if kind in ("f", "d") else argument(kind) for _, kind in command.arguments)
    return st.tuples(st.just(command.name), st.tuples(*kinds))


@pytest.mark.slow
@settings(max_examples=200)
@given(calls=st.lists(st.one_of(*map(comparable, COMPARED)), min_size=1, max_size=30))
def test_errors_are_the_drivers(screen: glsim.Offscreen, native: Native, calls: list[Any]) -> None:
    screen.reset()
    ours: list[tuple[int, str, int]] = []
    done: list[Call] = []
    for name, arguments in calls:
        if name in ("glMatrixMode", "glReadBuffer") and arguments[0] > 30000:
            continue  # the driver knows extensions
        try:
            getattr(gl, name)(*arguments)
        except gl.GLError as error:
            ours.append((len(done), name, int(error.err)))
        except (NotImplementedError, ValueError):
            continue  # missing, or fewer numbers than the parameter has: the driver would read beyond them
        done.append(Call(name, arguments))
    theirs: list[tuple[str, int]] = []
    native.replay(done, theirs)
    assert [(name, code) for _, name, code in ours] == theirs
