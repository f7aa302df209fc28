"""Frame times of GLUT programs, glsim against PyOpenGL: python tests/benchmarks/programs.py SCRIPT... [--frames 40]

Needs an interpreter with PyOpenGL >= 3.1.10, freeglut and a display (Xvfb will do), and with glsim's dependencies.
The program's callbacks are called by the same few lines in both: reshape once, then timer, idle and display, each frame
ended by glFinish.  Implementations take turns, each in a process of its own; the median frame is printed.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
WARM_UP = 5  # frames that are not counted: textures and programs are made


def play(implementation: str, script: str, frames: int) -> list[float]:
    """Milliseconds of each frame, in this process."""
    if implementation == "glsim":
        sys.path.insert(0, str(ROOT))
        from glsim.play import pyopengl

        pyopengl.install()
    from OpenGL import GL, GLUT

    called: dict[str, Callable[..., Any]] = {}
    times: list[float] = []

    def register(kind: str) -> Callable[..., None]:
        return lambda function=None, *rest: called.__setitem__(kind, function)

    def timer(milliseconds: float, function: Callable[[Any], Any], value: Any = 0) -> None:
        called["Timer"] = lambda: function(value)

    def main_loop() -> None:
        size = (GLUT.glutGet(GLUT.GLUT_WINDOW_WIDTH), GLUT.glutGet(GLUT.GLUT_WINDOW_HEIGHT))
        (called.get("Reshape") or (lambda w, h: GL.glViewport(0, 0, w, h)))(*size)
        for _ in range(frames):
            started = time.perf_counter()
            for kind in ("Timer", "Idle", "Display"):
                function = called.get(kind)
                if function is not None:
                    function()
            GL.glFinish()
            times.append((time.perf_counter() - started) * 1000.0)
        raise SystemExit

    for kind in ("Display", "Reshape", "Idle"):
        setattr(GLUT, f"glut{kind}Func", register(kind))
    GLUT.glutTimerFunc, GLUT.glutMainLoop = timer, main_loop
    if implementation == "glsim":  # a swap reads the picture only for glsim run
        GLUT.glutSwapBuffers = GL.glFlush
    os.chdir(Path(script).parent)
    sys.path.insert(0, str(Path(script).parent))
    sys.argv = [script]
    with contextlib.suppress(SystemExit):
        exec(compile(Path(script).read_bytes(), script, "exec"), {"__name__": "__main__", "__file__": script})
    return times


def measure(implementation: str, script: str, frames: int) -> float | None:
    """The median frame in milliseconds, from a process of its own; None if the program does not run."""
    words = [sys.executable, __file__, script, "--frames", str(frames), "--play", implementation]
    said = subprocess.run(words, capture_output=True, text=True, check=False).stdout.strip().splitlines()
    try:
        times = json.loads(said[-1])[WARM_UP:]
        return statistics.median(times) if times else None
    except (IndexError, ValueError):
        return None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scripts", nargs="+")
    parser.add_argument("--frames", type=int, default=40)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--play", choices=("PyOpenGL", "glsim"), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.play:
        print("\n" + json.dumps(play(options.play, os.path.abspath(options.scripts[0]), options.frames)))
        return
    print(f"{'program':30} {'PyOpenGL':>10} {'glsim':>10} {'ratio':>7}   [ms a frame]")
    for script in options.scripts:
        found: dict[str, list[float]] = {"PyOpenGL": [], "glsim": []}
        for _ in range(options.rounds):
            for implementation, medians in found.items():
                median = measure(implementation, script, options.frames)
                if median is not None:
                    medians.append(median)
        if all(found.values()):
            a, b = (statistics.median(medians) for medians in found.values())
            print(f"{Path(script).stem:30} {a:10.2f} {b:10.2f} {a / b:7.2f}")
        else:
            print(f"{Path(script).stem:30} does not run in both")


if __name__ == "__main__":
    main()
