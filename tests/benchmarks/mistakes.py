"""What it costs that ``glsim run`` looks for mistakes: whole runs with and without, medians of interleaved rounds.

    python tests/benchmarks/mistakes.py [--rounds N]

The programs make few calls, as many as are recorded at most, and so many that recording is given up.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

PROGRAM = """
import math
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glLoadIdentity()
    gluLookAt(0, 0, 4, 0, 0, 0, 0, 1, 0)
    glutSolidTeapot(0.5)
    for k in range(COUNT // 20):
        glPushMatrix()
        glTranslatef(math.sin(k), math.cos(k), 0)
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (0.5, k % 7 / 7, 0.2, 1))
        glBegin(GL_TRIANGLES)
        for x, y in ((0, 0), (0.1, 0), (0, 0.1), (0, 0.1), (0.1, 0), (0.1, 0.1)):
            glNormal3f(0, 0, 1)
            glVertex3f(x, y, 0.1)
        glEnd()
        glPopMatrix()
    glutSwapBuffers()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(300, 300)
glutCreateWindow("t")
for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
    glEnable(capability)
glMatrixMode(GL_PROJECTION)
gluPerspective(45, 1, 1, 20)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
"""
RUN = "import sys, glsim.cli.run as run\nif {without}: run.MOST_CALLS = 0\nfrom glsim.cli import main\nsys.exit(main())"


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=7)
    rounds = parser.parse_args().rounds
    print(f"{'calls':>8} {'without':>8} {'with':>8} {'ratio':>6}   seconds of a whole run")
    with tempfile.TemporaryDirectory() as folder:
        for count in (100, 1000, 4000, 200_000):
            script = Path(folder) / "program.py"
            script.write_text(PROGRAM.replace("COUNT", str(count)))
            times: dict[bool, list[float]] = {True: [], False: []}
            for _ in range(rounds):
                for without in times:
                    start = time.perf_counter()
                    words = ["run", str(script), "--out", str(Path(folder) / "out")]
                    command = [sys.executable, "-c", RUN.format(without=without), *words]
                    subprocess.run(command, check=True, capture_output=True)
                    times[without].append(time.perf_counter() - start)
            slow, quick = median(times[False]), median(times[True])
            print(f"{count:8} {quick:8.2f} {slow:8.2f} {slow / quick:6.2f}")


if __name__ == "__main__":
    main()
