"""render draws through the protocols of gpu.py, without moderngl: on an object that notes what it is told."""

from __future__ import annotations

import subprocess
import sys

import pytest

BLOCKED = "import sys; sys.modules['moderngl'] = sys.modules['glcontext'] = None\n"  # importing either raises
PLAIN = ("batch", "outline", "lines", "key", "programs", "uniforms", "specialise", "fold", "glsl", "pixels")
DRAWING = (
    "gpu", "draw", "source", "corestate", "compile", "textures", "accumulation", "inspect", "raw", "tape", "recorder",
)  # fmt: skip

RECORDING = """
import re
from glsim.gl import *
from glsim.machine.current import make_current
from glsim.machine.frame import Frame
from glsim.machine.machine import Machine
from glsim.render.draw import Renderer
from glsim.render.specialise import specialised

told = []

class Thing:
    size, glo = 1 << 20, 1
    def __init__(self, kind, text=""):
        self.kind, self.text = kind, text
    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *arguments, **named: told.append((self.kind, name, arguments, named))
    def get(self, name, default):
        return Thing("block") if f"uniform {name} " in self.text else default
    def __contains__(self, name):  # a driver knows the names that are used
        return re.search(rf"^(in|uniform) \\w+ {name};", self.text, re.MULTILINE) is not None
    def __setitem__(self, name, value):
        told.append((self.kind, "set", (name, value), {}))

class Wire:
    info, max_samples = {"GL_MAX_UNIFORM_BLOCK_SIZE": 16384}, 4
    def __enter__(self): return self
    def __exit__(self, *exception): pass
    def gc(self): return 0
    def buffer(self, data=None, *, reserve=0, dynamic=False): return Thing("buffer")
    def program(self, *, vertex_shader, fragment_shader):
        return Thing("program", specialised(vertex_shader) + specialised(fragment_shader))
    def vertex_array(self, program, content, *, index_buffer): return Thing("vertex array")
    def renderbuffer(self, size, components=4, *, samples=0, dtype="f1"): return Thing("renderbuffer")
    def framebuffer(self, color_attachments): return Thing("framebuffer")

class Device:
    width = height = 64
    samples = 0
    double_buffered, depth_bits, stencil_bits = False, 24, 8
    def check(self): pass
    def finish(self): pass
    def execute(self, packets): renderer.execute(packets, None)

renderer = Renderer(Wire(), Thing("raw"), (64, 64))
make_current(Machine(Device()))
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glRasterPos2f(0, 0)
glClear(GL_COLOR_BUFFER_BIT)
glBegin(GL_TRIANGLES)
for x in range(6):
    glVertex2f(x, x * x)
glEnd()
glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes(4))
glFlush()
drawn = [(arguments[0], named["vertices"]) for kind, name, arguments, named in told if name == "render"]
assert drawn == [(4, 6), (4, 6)], drawn
names = {name for kind, name, _, _ in told if kind == "raw"}
assert {"glClear", "glEnable", "glViewport", "glTexImage2D"} <= names, names
print("drawn")
"""

ON_TAPE = """
from glsim.gl import *
from glsim.machine.current import make_current
from glsim.machine.frame import Frame
from glsim.machine.machine import Machine
from glsim.render.recorder import record, tape
from glsim.render.tape import Tape

class Device:
    width = height = 64
    samples = 0
    double_buffered, depth_bits, stencil_bits = False, 24, 8
    def check(self): pass
    def finish(self): pass
    def execute(self, packets): frame.packets += packets

frame = Frame(64, 64)
make_current(Machine(Device()))
glEnable(GL_LIGHTING)
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes(3))
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
glEnable(GL_TEXTURE_2D)
glRectf(-1, -1, 1, 1)
glFlush()
operations = Tape.from_bytes(tape(frame)).pictures[0].operations
assert [one[3] for one in operations if one[0] == "draw"] == [6], operations
assert {"image", "program", "array", "uniform", "write"} <= {one[0] for one in operations}

glRasterPos2f(0, 0)
glCopyPixels(0, 0, 8, 8, GL_COLOR)
glFlush()
try:
    record({"reads what is drawn": frame})
except ModuleNotFoundError as error:
    print(error.name)
"""


def without_moderngl(text: str) -> str:
    done = subprocess.run([sys.executable, "-c", BLOCKED + text], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
@pytest.mark.parametrize("modules", [PLAIN, DRAWING], ids=["plain", "drawing"])
def test_no_module_of_this_half_imports_moderngl(modules: tuple[str, ...]) -> None:
    without_moderngl("\n".join(f"import glsim.render.{name}" for name in modules))


@pytest.mark.slow
def test_the_block_is_one() -> None:
    done = subprocess.run(
        [sys.executable, "-c", BLOCKED + "import glsim.render.context"], capture_output=True, text=True
    )
    assert "ModuleNotFoundError" in done.stderr


@pytest.mark.slow
def test_the_renderer_draws_on_anything_that_has_the_protocols() -> None:
    assert without_moderngl(RECORDING) == "drawn\n"


def test_a_tape_needs_a_device_only_for_what_reads_the_picture() -> None:
    assert without_moderngl(ON_TAPE) == "moderngl\n"
