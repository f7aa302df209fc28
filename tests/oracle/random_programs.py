"""Random valid programs against the driver's fixed function: ``python -m tests.oracle.random_programs --count 5000``.

Prints each program whose pictures differ, made as short as it can be while they do.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import numpy as np

import glsim
from glsim import gl
from glsim.play.capture import capture
from glsim.render.native import Native
from tests.drawing import ball
from tests.oracle.author import Author
from tests.oracle.measure import Difference, measure
from tests.oracle.texture_programs import texels

SIZE = 128
NAMES = {**{name: getattr(gl, name) for name in gl.__all__}, "np": np, "ball": ball, "texels": texels}

PAIRS = (
    ("glBegin(", "glEnd("),
    ("glPushAttrib(", "glPopAttrib("),
    ("glPushMatrix(", "glPopMatrix("),
    ("glNewList(", "glEndList("),
)


def whole(lines: list[str]) -> bool:
    """Whether a program ends all that it begins, and each primitive has its vertices."""
    text = "\n".join(lines)
    primitives = [part.partition("glEnd(")[0] for part in text.split("glBegin(")[1:]]
    enough = all(part.count("glVertex") + part.count("glArrayElement") >= 4 for part in primitives)
    return enough and all(text.count(begin) == text.count(end) for begin, end in PAIRS)


def pictures(lines: list[str], screen: glsim.Offscreen) -> tuple[np.ndarray, np.ndarray]:
    """The program's picture by glsim and by the driver, in a new context of its own: objects and current values of
    earlier programs are gone.  Raises what glsim raises, and GLError for the driver's errors."""
    screen.reset()
    screen.make_current()
    with capture(calls=True) as frame:
        exec("\n".join(lines), dict(NAMES))
    errors: list[tuple[str, int]] = []
    native = Native(screen.width, screen.height)
    try:
        reference = native.replay(frame.calls, errors)
    finally:
        native.release()
    if errors:
        raise gl.GLError(gl.GL_INVALID_OPERATION, f"the driver says {errors}")
    return screen.pixels(), reference


def flag(lines: list[str], screen: glsim.Offscreen) -> str:
    """Empty if both draw the same, else how they differ."""
    try:
        found = measure(*pictures(lines, screen))
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return f"{found}" if differs(found, any("glClipPlane" in line for line in lines)) else ""


def differs(found: Difference, clipped: bool = False) -> bool:
    """The criteria of test_native.py; along an edge that glClipPlane makes the last bit decides about single pixels."""
    if clipped:
        return found.coverage > 2 or found.within_1 < 0.999
    return found.coverage > 0 or found.within_1 < 0.999 or found.worst > 3


def shortest(lines: list[str], interesting: Callable[[list[str]], bool]) -> list[str]:
    """Statements that are not needed are left out: halves, quarters, ... single ones, a beginning with its end."""
    size = len(lines) // 2
    while size:
        start = 0
        while start < len(lines):
            fewer = lines[:start] + lines[start + size :]
            if interesting(fewer):
                lines = fewer
            else:
                start += size
        size = size // 2 if size > 1 else 0
    for first in reversed(range(len(lines))):
        end = next((end for begin, end in PAIRS if lines[first].startswith(begin)), None)
        last = next((k for k in range(first, len(lines)) if end and lines[k].startswith(end)), 0)
        fewer = lines[:first] + lines[first + 1 : last] + lines[last + 1 :]
        if last and interesting(fewer):
            lines = fewer
    return lines


def kind(said: str) -> str:
    """Differences are of one kind, exceptions of theirs."""
    return said.partition("(" if said.startswith("Difference") else ":")[0]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--long", action="store_true", help="print flagged programs as they are")
    options = parser.parse_args()
    screen = glsim.offscreen(SIZE, SIZE)
    start, bad = time.time(), 0
    for seed in range(options.seed, options.seed + options.count):
        lines = Author(seed).program()
        said = flag(lines, screen)
        if not said:
            continue
        bad += 1
        what = kind(said)
        if not options.long:
            lines = shortest(lines, lambda fewer, what=what: whole(fewer) and kind(flag(fewer, screen)) == what)
        print(f"# seed {seed}: {said} -> {flag(lines, screen)}")
        print("\n".join(lines), flush=True)
        print()
    print(f"{options.count} programs, {bad} flagged, {time.time() - start:.0f} s")


if __name__ == "__main__":
    main()
