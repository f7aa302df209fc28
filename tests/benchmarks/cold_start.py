"""A fresh process that draws one lit sphere at 256 x 256 and saves a PNG: glsim against PyOpenGL.

    python tests/benchmarks/cold_start.py [--rounds 15] [--json]

Needs an interpreter with PyOpenGL >= 3.1.10, numpy, Pillow and glsim's dependencies.  The two programs differ only in
how they open a context and read the picture.  Wall time of whole processes, in turns; medians.  Also what
``import glsim`` and ``from glsim.gl import *`` add to ``import numpy``.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

SCENE = """
import math
glMatrixMode(GL_PROJECTION)
glFrustum(-0.4, 0.4, -0.4, 0.4, 1, 100)
glMatrixMode(GL_MODELVIEW)
glTranslatef(0, 0, -3)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glLightfv(GL_LIGHT0, GL_POSITION, [2.0, 3.0, 4.0, 1.0])
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.8, 0.4, 0.3, 1.0])
glMaterialfv(GL_FRONT, GL_SPECULAR, [0.5, 0.5, 0.5, 1.0])
glMaterialf(GL_FRONT, GL_SHININESS, 30.0)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
def point(i, j):
    theta, phi = math.pi * i / 24, 2 * math.pi * j / 32
    return math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi)
glBegin(GL_QUADS)
for i in range(24):
    for j in range(32):
        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
            p = point(i + a, j + b)
            glNormal3f(*p)
            glVertex3f(*p)
glEnd()
"""

PROGRAMS = {
    "PyOpenGL": """
import os
os.environ["PYOPENGL_PLATFORM"] = "osmesa"
import numpy
from OpenGL.GL import *
from OpenGL import osmesa
from PIL import Image
context = osmesa.OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, None)
pixels = (GLubyte * (256 * 256 * 4))()
osmesa.OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, 256, 256)
"""
    + SCENE
    + """
data = glReadPixels(0, 0, 256, 256, GL_RGB, GL_UNSIGNED_BYTE)
Image.frombytes("RGB", (256, 256), data).transpose(Image.Transpose.FLIP_TOP_BOTTOM).save(FILE)
""",
    "glsim": """
import glsim
from glsim.gl import *
screen = glsim.offscreen(256, 256)
"""
    + SCENE
    + """
screen.save(FILE)
""",
}
IMPORTS = {
    "import numpy": "import numpy",
    "import glsim": "import numpy, glsim",
    "from glsim.gl import *": "from glsim.gl import *",
}


def wall(program: str) -> float:
    """Milliseconds of a fresh interpreter running ``program``."""
    environment = dict(os.environ, PYTHONPATH=str(ROOT))
    start = time.perf_counter()
    subprocess.run([sys.executable, "-c", program], env=environment, check=True)
    return (time.perf_counter() - start) * 1e3


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        jobs = {name: f"FILE = {folder + '/picture.png'!r}\n{text}" for name, text in PROGRAMS.items()}
        jobs.update(IMPORTS)
        times: dict[str, list[float]] = {name: [] for name in jobs}
        for job in jobs.values():
            wall(job)
        for _ in range(options.rounds):
            for name, job in jobs.items():
                times[name].append(wall(job))
    table = {name: statistics.median(values) for name, values in times.items()}
    table["glsim / PyOpenGL"] = statistics.median(a / b for a, b in zip(times["glsim"], times["PyOpenGL"], strict=True))
    table["import glsim adds"] = table["import glsim"] - table["import numpy"]
    if options.json:
        print(json.dumps(table, indent=1))
        return
    for name, value in table.items():
        print(f"{name:24} {value:8.2f}" + ("" if "/" in name else " ms"))


if __name__ == "__main__":
    main()
