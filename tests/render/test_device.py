"""Opening contexts, switching between them, living beside other users of OpenGL."""

from __future__ import annotations

import json
import sys

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.machine.current import current_machine
from glsim.render.device import order
from glsim.render.native import Native
from tests.drawing import python

TRIANGLE = "glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(0, 1); glEnd()"


def triangle(color: tuple[float, float, float]) -> None:
    glColor3f(*color)
    glBegin(GL_TRIANGLES)
    for x, y in ((-1, -1), (3, -1), (-1, 3)):
        glVertex2f(x, y)
    glEnd()


# Stands before a program to make libraries impossible to load, as on a machine that lacks them.
MASK = """
import ctypes
real = ctypes.CDLL
class Masked(real):
    def __init__(self, name, *a, **k):
        if name and ("OSMesa" in name or "libEGL" in name): raise OSError(name + ": cannot open shared object file")
        super().__init__(name, *a, **k)
ctypes.CDLL = Masked
"""


def test_several_contexts(screen: glsim.Offscreen) -> None:
    other = glsim.offscreen(32, 16)
    glEnable(GL_LIGHTING)
    assert glGetIntegerv(GL_VIEWPORT).tolist() == [0, 0, 32, 16]
    glDisable(GL_LIGHTING)
    triangle((1, 0, 0))
    with screen:
        assert not glIsEnabled(GL_LIGHTING)
        triangle((0, 1, 0))
        with other:
            glClearDepth(0.5)
        assert current_machine() is screen.machine
        assert glGetFloatv(GL_DEPTH_CLEAR_VALUE) == 1
    assert current_machine() is other.machine
    assert other.pixels()[8, 16].tolist() == [255, 0, 0, 255]
    assert screen.pixels()[64, 64].tolist() == [0, 255, 0, 255]
    other.release()
    with pytest.raises(RuntimeError, match="no context is current"):
        glFlush()
    screen.make_current()
    glFlush()


def test_reset_puts_everything_back(screen: glsim.Offscreen) -> None:
    glClearColor(1, 1, 1, 1)
    glColorMask(False, True, True, True)
    glDepthMask(False)
    glPushMatrix()
    glTranslatef(1, 1, 1)
    glEnable(GL_LIGHTING)
    glClear(GL_COLOR_BUFFER_BIT)
    triangle((1, 1, 1))
    screen.pixels()
    screen.reset()
    assert not screen.pixels().any()
    assert (screen.depth() == 1).all()
    assert not glIsEnabled(GL_LIGHTING)
    assert glGetIntegerv(GL_MODELVIEW_STACK_DEPTH) == 1
    triangle((1, 0, 1))
    assert screen.pixels()[64, 64].tolist() == [255, 0, 255, 255]


def test_another_context_in_the_process_does_no_harm(screen: glsim.Offscreen, native: Native) -> None:
    """The native oracle leaves its own context, and then none, current between draws."""
    triangle((0, 0, 1))
    native.replay([])
    assert screen.pixels()[64, 64].tolist() == [0, 0, 255, 255]
    native.loader.make_current()
    triangle((1, 1, 0))
    assert screen.pixels()[64, 64].tolist() == [255, 255, 0, 255]
    native.loader.release_current()


@pytest.mark.slow
def test_pyrender_in_the_same_process(screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYOPENGL_PLATFORM", "egl")
    monkeypatch.setattr(np, "infty", np.inf, raising=False)  # pyrender 0.1.45 was written for numpy 1
    pyrender = pytest.importorskip("pyrender", reason="pyrender is not installed (extra `pyrender`)")
    import trimesh

    scene = pyrender.Scene(bg_color=[0, 0, 0, 1])
    scene.add(pyrender.Mesh.from_trimesh(trimesh.creation.icosphere()))
    pose = np.eye(4)
    pose[2, 3] = 4
    scene.add(pyrender.PerspectiveCamera(yfov=0.8), pose=pose)
    scene.add(pyrender.DirectionalLight(intensity=5.0), pose=pose)
    renderer = pyrender.OffscreenRenderer(64, 64)
    for color in ((1, 0, 0), (0, 1, 0)):
        theirs, _ = renderer.render(scene)
        triangle(color)
        assert screen.pixels()[64, 64, :3].tolist() == [255 * c for c in color]
        assert theirs[32, 32].any()
    renderer.delete()
    assert screen.pixels()[64, 64, :3].tolist() == [0, 255, 0]


@pytest.mark.parametrize("samples", [2, 4])
def test_multisampling(samples: int) -> None:
    screen = glsim.offscreen(64, 64, samples=samples)
    assert screen.samples == samples
    assert glGetIntegerv(GL_SAMPLES) >= samples  # a driver may take more than it was asked for
    glBegin(GL_TRIANGLES)
    for x, y in ((-0.9, -0.7), (0.8, -0.5), (0.1, 0.9)):
        glVertex2f(x, y)
    glEnd()
    levels = np.unique(screen.pixels()[..., 0])
    screen.release()
    assert len(levels) > samples  # from none to all samples of a pixel covered


def test_depth_of_a_multisampled_picture() -> None:
    screen = glsim.offscreen(32, 32, samples=4)
    glEnable(GL_DEPTH_TEST)
    glTranslatef(0, 0, -0.5)
    triangle((1, 1, 1))
    assert np.allclose(screen.depth(), 0.25, atol=1e-6)
    glDisable(GL_MULTISAMPLE)
    glLoadIdentity()
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glRotatef(20, 0, 0, 1)
    glRectf(-0.5, -0.5, 0.5, 0.5)
    assert len(np.unique(screen.pixels()[..., 0])) == 2
    screen.release()


def test_a_context_made_in_a_with_statement_gives_the_outer_one_back(screen: glsim.Offscreen) -> None:
    with glsim.offscreen(16, 16):
        assert glGetIntegerv(GL_VIEWPORT)[2] == 16
    assert glGetIntegerv(GL_VIEWPORT)[2] == 128


@pytest.mark.slow
def test_contexts_that_nobody_holds_are_freed() -> None:
    program = """
import gc, resource, glsim
from glsim.gl import *
def use():
    screen = glsim.offscreen(512, 512)
    glRectf(0, 0, 1, 1)
    screen.pixels()
for k in range(10): use()
gc.collect()
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
for k in range(40): use(); gc.collect()
print((resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024)
"""
    done = python("-c", program)
    assert float(done.stdout) < 60, done.stderr


def test_a_released_context_says_so(screen: glsim.Offscreen) -> None:
    other = glsim.offscreen(8, 8)
    other.release()
    other.release()
    with pytest.raises(RuntimeError, match="this context was released"):
        other.pixels()
    screen.make_current()
    glFlush()


@pytest.mark.slow
def test_egl_and_osmesa_side_by_side() -> None:
    program = """
import glsim
from glsim.gl import *
def fill(*c): glClearColor(*c, 1); glClear(GL_COLOR_BUFFER_BIT)
a = glsim.offscreen(32, 32, backend="egl"); fill(1, 0, 0); a.pixels()
b = glsim.offscreen(32, 32, backend="osmesa"); fill(0, 1, 0); b.pixels()
a.make_current(); fill(0, 0, 1)
print(a.pixels()[0, 0].tolist(), b.pixels()[0, 0].tolist())
"""
    done = python("-c", program)
    if "no OpenGL context" in done.stderr:
        pytest.skip("EGL or libOSMesa is not installed")
    assert done.stdout.strip() == "[0, 0, 255, 255] [0, 255, 0, 255]"


@pytest.mark.slow
def test_osmesa_draws_the_same() -> None:
    program = f"import glsim\nfrom glsim.gl import *\ns = glsim.offscreen(32, 32, backend='osmesa')\n{TRIANGLE}\n"
    done = python("-c", program + "print(s.backend, int((s.pixels()[..., 0] > 0).sum()))")
    if "no OpenGL context" in done.stderr:
        pytest.skip("libOSMesa is not installed")
    assert done.stdout.split() == ["osmesa", "512"], done.stderr


def test_order_of_backends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("GLSIM_BACKEND", raising=False)
    if sys.platform.startswith("linux"):
        assert [name for name, _ in order()] == ["egl", "osmesa", "x11"]
    monkeypatch.setenv("GLSIM_BACKEND", "osmesa")
    assert order() == [("osmesa", None)]
    assert order("egl:2") == [("egl", 2)]
    for wrong in ("vulkan", "egl:x"):
        with pytest.raises(ValueError, match="backend must be auto, egl, osmesa, x11, native or egl:N"):
            order(wrong)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [((0, 10), "width must be an integer from 1 to 16384, not 0"), ((10, 2.5), "height must be an integer")],
)
def test_sizes_that_cannot_be(arguments: tuple[int, int], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        glsim.offscreen(*arguments)


def test_samples_that_cannot_be() -> None:
    with pytest.raises(ValueError, match="samples must be one of 0, 2"):
        glsim.offscreen(8, 8, samples=1000)


@pytest.mark.slow
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the libraries of Linux are masked")
def test_without_any_gl_library_every_attempt_is_told() -> None:
    done = python("-c", MASK + "import glsim\nglsim.offscreen(8, 8)", DISPLAY="")
    assert done.returncode != 0
    last = done.stderr.strip().splitlines()[-4:]
    assert "no OpenGL context could be opened. Tried:" in last[0]
    assert last[1].split(":")[0].strip() == "egl"
    assert "apt install libegl1 libgl1" in last[1]
    assert "libOSMesa.so.8 is not installed" in last[2]
    assert "libosmesa6" in last[2]
    assert "DISPLAY is not set" in last[3]


@pytest.mark.slow
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the libraries of Linux are masked")
def test_doctor_without_any_gl_library() -> None:
    done = python("-c", MASK + "from glsim.cli import main\nraise SystemExit(main(['doctor', '--json']))", DISPLAY="")
    assert done.returncode == 1
    found = json.loads(done.stdout)
    assert not found["works"]
    assert [entry["works"] for entry in found["backends"]] == [False] * 3
    assert not found["native fixed function"]["works"]
    words = python(
        "-c", MASK + "from glsim.cli import main\nraise SystemExit(main(['doctor']))", DISPLAY="", COLUMNS="200"
    )
    assert "glsim cannot draw here" in words.stdout
    assert "apt install" in words.stdout


@pytest.mark.slow
def test_doctor_here() -> None:
    done = python("-c", "from glsim.cli import main\nraise SystemExit(main(['doctor', '--json']))")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert found["works"]
    assert any(entry["works"] and entry["renderer"] for entry in found["backends"])
