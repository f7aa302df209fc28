"""glsim against PyOpenGL on the driver's own fixed function: python tests/benchmarks/fixed_function.py [--json]

Needs an interpreter with PyOpenGL >= 3.1.10 and with glsim's dependencies (glsim is taken from this checkout).
Prints nanoseconds per call (loop overhead subtracted; glVertex includes its share of glEnd and of the flush) and
milliseconds per frame of a lit sphere of 100,000 triangles and of 500 small cubes.  Each implementation runs in a
process of its own, in turns; the median of all rounds is printed, with the ratio.
"""

from __future__ import annotations

import argparse
import importlib
import json
import math
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

SIZE = 512
ROOT = Path(__file__).resolve().parents[2]


def open_pyopengl() -> Any:
    """PyOpenGL on a compatibility context (OSMesa)."""
    os.environ["PYOPENGL_PLATFORM"] = "osmesa"
    from OpenGL import GL, osmesa

    context = osmesa.OSMesaCreateContextExt(GL.GL_RGBA, 24, 8, 0, None)
    pixels = (GL.GLubyte * (SIZE * SIZE * 4))()
    osmesa.OSMesaMakeCurrent(context, pixels, GL.GL_UNSIGNED_BYTE, SIZE, SIZE)
    return GL, (context, pixels)


def open_glsim() -> Any:
    sys.path.insert(0, str(ROOT))
    import glsim

    screen = glsim.offscreen(SIZE, SIZE)
    return importlib.import_module("glsim.gl"), screen


OPEN = {"PyOpenGL": open_pyopengl, "glsim": open_glsim}


def sphere(slices: int = 250, stacks: int = 201) -> tuple[Any, Any]:
    """Points of a unit sphere (also its normals) and about 100,000 triangles."""
    import numpy as np

    phi = np.linspace(0, math.pi, stacks + 1)[:, None]
    theta = np.linspace(0, 2 * math.pi, slices + 1)[None, :]
    points = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), np.cos(phi) + 0 * theta], 2)
    i, j = np.meshgrid(np.arange(stacks), np.arange(slices), indexing="ij")
    a = i * (slices + 1) + j
    b = a + slices + 1
    triangles = np.concatenate(
        [np.stack([a, b, a + 1], 2)[1:].reshape(-1, 3), np.stack([a + 1, b, b + 1], 2)[:-1].reshape(-1, 3)]
    )
    return points.reshape(-1, 3).astype("f4"), triangles.astype("u4")


def setup(gl: Any, lights: int) -> None:
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.glFrustum(-0.4, 0.4, -0.4, 0.4, 1, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_LIGHTING)
    for k in range(8):
        light = gl.GL_LIGHT0 + k
        (gl.glEnable if k < lights else gl.glDisable)(light)
        angle = k * math.pi / 4
        gl.glLightfv(light, gl.GL_POSITION, [4 * math.cos(angle), 4 * math.sin(angle), 4.0, 1.0])
        gl.glLightfv(light, gl.GL_DIFFUSE, [1.0 / lights, 0.9 / lights, 0.8 / lights, 1.0])
        gl.glLightfv(light, gl.GL_SPECULAR, [0.5, 0.5, 0.5, 1.0])
    gl.glMaterialfv(gl.GL_FRONT_AND_BACK, gl.GL_AMBIENT_AND_DIFFUSE, [0.8, 0.4, 0.3, 1.0])
    gl.glMaterialfv(gl.GL_FRONT_AND_BACK, gl.GL_SPECULAR, [0.4, 0.4, 0.4, 1.0])
    gl.glMaterialf(gl.GL_FRONT_AND_BACK, gl.GL_SHININESS, 30.0)


def frame_time(gl: Any, draw: Callable[[], None], distance: float = 3.0, runs: int = 9) -> float:
    times = []
    for k in range(runs + 2):
        start = time.perf_counter()
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        gl.glLoadIdentity()
        gl.glTranslatef(0.0, 0.0, -distance)
        gl.glRotatef(float(k), 0.3, 1.0, 0.2)
        draw()
        gl.glFinish()
        times.append((time.perf_counter() - start) * 1e3)
    return statistics.median(times[2:])


def calls(gl: Any) -> dict[str, float]:
    """ns per call, median of 9."""
    setup(gl, 1)
    loop = range(20_000)
    red, point = [1.0, 0.0, 0.0, 1.0], [0.1, 0.2, 0.3]
    empty = timed(gl, loop, lambda: [None for _ in loop], False)
    vertex, vertexv, normal, color = gl.glVertex3f, gl.glVertex3fv, gl.glNormal3f, gl.glColor3f
    material, front, diffuse = gl.glMaterialfv, gl.GL_FRONT, gl.GL_DIFFUSE
    push, translate, pop, enable, lighting = (
        gl.glPushMatrix,
        gl.glTranslatef,
        gl.glPopMatrix,
        gl.glEnable,
        gl.GL_LIGHTING,
    )
    bodies: dict[str, tuple[Callable[[], Any], bool]] = {
        "glVertex3f with glEnd": (lambda: [vertex(0.1, 0.2, 0.3) for _ in loop], True),
        "glVertex3fv with glEnd": (lambda: [vertexv(point) for _ in loop], True),
        "glNormal3f": (lambda: [normal(0.0, 0.0, 1.0) for _ in loop], True),
        "glColor3f": (lambda: [color(1.0, 0.5, 0.0) for _ in loop], True),
        "glMaterialfv": (lambda: [material(front, diffuse, red) for _ in loop], False),
        "glPush/Translatef/PopMatrix": (lambda: [(push(), translate(0.1, 0.2, 0.3), pop()) for _ in loop], False),
        "glEnable": (lambda: [enable(lighting) for _ in loop], False),
    }
    return {f"{name} [ns]": timed(gl, loop, body, inside) - empty for name, (body, inside) in bodies.items()}


def timed(gl: Any, loop: range, body: Callable[[], Any], inside: bool) -> float:
    times = []
    for _ in range(9):
        gl.glFinish()
        start = time.perf_counter()
        if inside:
            gl.glBegin(gl.GL_POINTS)
        body()
        if inside:
            gl.glEnd()
        times.append(time.perf_counter() - start)
    return statistics.median(times) / len(loop) * 1e9


def spheres(gl: Any) -> dict[str, float]:
    points, triangles = sphere()
    corners = [tuple(p) for p in points[triangles.ravel()].tolist()]

    def immediate() -> None:
        normal, vertex = gl.glNormal3f, gl.glVertex3f
        gl.glBegin(gl.GL_TRIANGLES)
        for x, y, z in corners:
            normal(x, y, z)
            vertex(x, y, z)
        gl.glEnd()

    def arrays() -> None:
        gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
        gl.glEnableClientState(gl.GL_NORMAL_ARRAY)
        gl.glVertexPointer(3, gl.GL_FLOAT, 0, points)
        gl.glNormalPointer(gl.GL_FLOAT, 0, points)
        gl.glDrawElements(gl.GL_TRIANGLES, triangles.size, gl.GL_UNSIGNED_INT, triangles)

    result = {}
    for way, draw in (("immediate", immediate), ("arrays", arrays)):
        for lights in (1, 8):
            setup(gl, lights)
            result[f"100k triangles, {way}, {lights} lights [ms]"] = frame_time(gl, draw)
    return result


def cubes(gl: Any) -> dict[str, float]:
    faces = []
    for axis in range(3):
        for side in (-1, 1):
            ring = [(-1, -1), (1, -1), (1, 1), (-1, 1)][::side]
            quad = [[0.3 * c for c in (*pair[:axis], side, *pair[axis:])] for pair in ring]
            faces.append(([side * float(k == axis) for k in range(3)], quad))

    def draw() -> None:
        for i in range(500):
            gl.glPushMatrix()
            gl.glTranslatef(i % 10 - 4.5, i // 10 % 10 - 4.5, -float(i // 100))
            gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, [i % 10 / 9, i // 10 % 10 / 9, i // 100 / 4, 1.0])
            gl.glBegin(gl.GL_QUADS)
            for normal, quad in faces:
                gl.glNormal3f(*normal)
                for p in quad:
                    gl.glVertex3f(*p)
            gl.glEnd()
            gl.glPopMatrix()

    setup(gl, 1)
    return {"500 cubes, immediate [ms]": frame_time(gl, draw, 14.0)}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--child", choices=OPEN, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.child:
        gl, _context = OPEN[options.child]()
        print(json.dumps({**calls(gl), **spheres(gl), **cubes(gl)}))
        return
    rounds: dict[str, list[dict[str, float]]] = {name: [] for name in OPEN}
    for _ in range(options.rounds):
        for name in OPEN:
            command = [sys.executable, __file__, "--child", name]
            done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
            rounds[name].append(json.loads(done.stdout.splitlines()[-1]))
    table = {
        entry: {name: statistics.median(r[entry] for r in rounds[name]) for name in OPEN}
        for entry in rounds["glsim"][0]
    }
    if options.json:
        print(json.dumps(table, indent=1))
        return
    print(f"{'':44} {'PyOpenGL':>10} {'glsim':>10} {'ratio':>7}")
    for entry, row in table.items():
        print(f"{entry:44} {row['PyOpenGL']:10.1f} {row['glsim']:10.1f} {row['PyOpenGL'] / row['glsim']:7.1f}")


if __name__ == "__main__":
    main()
