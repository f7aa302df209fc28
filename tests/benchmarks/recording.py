"""What recording costs: the same calls without it, with packets alone, and with calls, lines and state changes.

    python tests/benchmarks/recording.py [--rounds N]

Prints microseconds a call, medians of interleaved rounds.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from statistics import median

import glsim
from glsim.gl import *


def vertices() -> int:
    """Immediate mode: a normal and a vertex, 10,000 times."""
    glBegin(GL_TRIANGLES)
    for k in range(10_000):
        glNormal3f(0.0, 0.0, 1.0)
        glVertex3f(0.1, 0.2, 0.001 * k)
    glEnd()
    return 20_002


def objects() -> int:
    """Many small objects: matrix, material and light calls, 500 times."""
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    for k in range(500):
        glPushMatrix()
        glTranslatef(0.001 * k, 0.0, 0.0)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, (0.002 * k, 0.5, 0.5, 1.0))
        glLightfv(GL_LIGHT0, GL_POSITION, (0.0, 0.001 * k, 1.0, 0.0))
        glRectf(0.0, 0.0, 0.1, 0.1)
        glPopMatrix()
    return 3002


def off(draw: Callable[[], int]) -> int:
    return draw()


def packets(draw: Callable[[], int]) -> int:
    with glsim.capture():
        return draw()


def calls(draw: Callable[[], int]) -> int:
    with glsim.capture(calls=True):
        return draw()


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=15)
    rounds = parser.parse_args().rounds
    screen = glsim.offscreen(64, 64)
    print(f"{'calls':12} {'off':>8} {'packets':>8} {'calls':>8}   microseconds a call, with flushing")
    for draw in (vertices, objects):
        times: dict[str, list[float]] = {way.__name__: [] for way in (off, packets, calls)}
        for _ in range(rounds):
            for way in (off, packets, calls):
                screen.reset()
                start = time.perf_counter()
                count = way(draw)
                glFinish()
                times[way.__name__].append((time.perf_counter() - start) / count * 1e6)
        print(f"{draw.__name__:12} " + " ".join(f"{median(values):8.2f}" for values in times.values()))


if __name__ == "__main__":
    main()
