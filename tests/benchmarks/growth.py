"""How time and memory grow with what is drawn: python tests/benchmarks/growth.py [--json]

Each subject is measured at four sizes, over three decades where that fits: milliseconds of CPU time of the process, the
lowest of five (with llvmpipe's share, which runs in the same thread), and KiB that the process holds more afterwards.
"growth" is the exponent between the two largest sizes: 1 is linear, 2 would be quadratic.
"""

from __future__ import annotations

import argparse
import gc
import json
import math
import os
import time
from collections.abc import Callable
from typing import Any

os.environ.setdefault("LP_NUM_THREADS", "0")

import numpy as np

import glsim
from glsim.gl import *

ROUNDS = 5


def corners(count: int) -> list[tuple[float, float, float]]:
    """The corners of small triangles, all different."""
    return np.random.default_rng(0).uniform(-1.0, 1.0, (3 * count, 3)).tolist()


def immediate(triangles: int) -> Callable[[], Any]:
    points = corners(triangles)

    def draw() -> None:
        glBegin(GL_TRIANGLES)
        for x, y, z in points:
            glVertex3f(x, y, z)
        glEnd()
        glFinish()

    return draw


def primitives(count: int) -> Callable[[], Any]:
    """glBegin and glEnd around each triangle, with its own matrix."""

    def draw() -> None:
        for k in range(count):
            glPushMatrix()
            glTranslatef(0.0, 0.0, 0.1 / (k + 1))
            glBegin(GL_TRIANGLES)
            for x, y in ((0.0, 0.0), (0.01, 0.0), (0.0, 0.01)):
                glVertex2f(x, y)
            glEnd()
            glPopMatrix()
        glFinish()

    return draw


def compiling(triangles: int) -> Callable[[], Any]:
    draw = immediate(triangles)

    def compile_list() -> None:
        glNewList(1, GL_COMPILE)
        draw()
        glEndList()

    return compile_list


def lists(triangles: int) -> Callable[[], Any]:
    compiling(triangles)()

    def call() -> None:
        glCallList(1)
        glFinish()

    return call


def many_lists(count: int) -> Callable[[], Any]:
    """Making, calling and deleting lists of a triangle each."""

    def draw() -> None:
        first = glGenLists(count)
        for number in range(first, first + count):
            glNewList(number, GL_COMPILE)
            glRectf(0.0, 0.0, 0.01, 0.01)
            glEndList()
        for number in range(first, first + count):
            glCallList(number)
        glFinish()
        glDeleteLists(first, count)

    return draw


def arrays(triangles: int) -> Callable[[], Any]:
    points = np.array(corners(triangles), np.float32)
    glEnableClientState(GL_VERTEX_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, points)

    def draw() -> None:
        glDrawArrays(GL_TRIANGLES, 0, len(points))
        glFinish()

    return draw


def textures(pixels: int) -> Callable[[], Any]:
    """Giving a new image to a texture, and drawing with it."""
    side = 1 << round(math.log2(math.sqrt(pixels)))
    image = np.zeros((side, side, 4), np.uint8)
    glEnable(GL_TEXTURE_2D)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)

    def draw() -> None:
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, image)
        glRectf(0.0, 0.0, 0.01, 0.01)
        glFinish()

    return draw


def contexts(count: int) -> Callable[[], Any]:
    """Opening contexts and releasing them."""

    def draw() -> None:
        for screen in [glsim.offscreen(16, 16) for _ in range(count)]:
            screen.release()

    return draw


SUBJECTS: dict[str, tuple[Callable[[int], Callable[[], Any]], tuple[int, ...]]] = {
    "immediate mode [triangles]": (immediate, (100, 1000, 10_000, 100_000)),
    "glBegin/glEnd [primitives]": (primitives, (10, 100, 1000, 10_000)),
    "compiling a list [triangles]": (compiling, (100, 1000, 10_000, 100_000)),
    "calling a list [triangles]": (lists, (100, 1000, 10_000, 100_000)),
    "many lists [lists]": (many_lists, (10, 100, 1000, 10_000)),
    "vertex arrays [triangles]": (arrays, (100, 1000, 10_000, 100_000)),
    "textures [texels]": (textures, (1 << 12, 1 << 15, 1 << 18, 1 << 22)),
    "contexts [contexts]": (contexts, (1, 3, 10, 30)),
}


def resident() -> int:
    """KiB of memory that the process holds (Linux)."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") // 1024


def measured(make: Callable[[int], Callable[[], Any]], size: int) -> tuple[float, int]:
    """(milliseconds, KiB) at one size, on a screen of its own."""
    gc.collect()
    with glsim.offscreen(64, 64) as screen:
        before = resident()
        run = make(size)
        run()
        times = []
        for _ in range(ROUNDS):
            start = time.process_time()
            run()
            times.append((time.process_time() - start) * 1e3)
        held = resident() - before
        if make is not contexts:
            screen.release()
    return min(times), max(held, 0)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    table: dict[str, Any] = {}
    for name, (make, sizes) in SUBJECTS.items():
        rows = [measured(make, size) for size in sizes]
        growth = math.log(rows[-1][0] / rows[-2][0]) / math.log(sizes[-1] / sizes[-2])
        table[name] = {"sizes": sizes, "ms": [r[0] for r in rows], "KiB": [r[1] for r in rows], "growth": growth}
        if not options.json:
            cells = "".join(
                f"{size:>9}: {ms:8.2f} ms {kib:7d} KiB" for size, (ms, kib) in zip(sizes, rows, strict=True)
            )
            print(f"{name:30} {cells}   growth {growth:.2f}", flush=True)
    if options.json:
        print(json.dumps(table, indent=1))


if __name__ == "__main__":
    main()
