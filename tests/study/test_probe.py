"""glsim.probe: what it computes is what the picture has, and what it says is so."""

from __future__ import annotations

import json
import xml.dom.minidom
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.gl import *
from glsim.play.capture import capture
from glsim.play.plan import Plan
from glsim.play.reshade import shaded
from glsim.play.run import run
from glsim.study.prober import Prober
from tests.drawing import portions
from tests.oracle import PROGRAMS


def wrong(frame: glsim.Frame, picture: np.ndarray, pixels: list[tuple[int, int]]) -> list[Any]:
    """Pixels at which the equation, or one of its fragments, is more than 1/255 from what was drawn."""
    prober = Prober(frame)
    found = []
    for x, y in pixels:
        probe = prober.at(x, y)
        apart = [np.abs(np.subtract(fragment.computed, fragment.after)).max() for fragment in probe.fragments]
        apart.append(np.abs(np.subtract(probe.computed, picture[y, x].astype(int))).max())
        if tuple(picture[y, x]) != probe.pixel or max(apart) > 1:
            found.append((x, y, probe.computed, probe.pixel, tuple(picture[y, x]), apart))
    prober.release()
    return found


def some_pixels(picture: np.ndarray, count: int, rng: np.random.Generator) -> list[tuple[int, int]]:
    """Mostly pixels that were drawn."""
    ys, xs = np.nonzero(picture.any(axis=2))
    chosen = rng.choice(len(xs), min(count, len(xs)), replace=False)
    return [(int(xs[k]), int(ys[k])) for k in chosen] + [(int(rng.integers(128)), int(rng.integers(128)))]


GROUPS = [list(PROGRAMS)[k::80] for k in range(80)]


@pytest.mark.parametrize("group", portions(80))
def test_the_equation_gives_the_pixel_in_every_program(group: int, screen: glsim.Offscreen) -> None:
    """All programs of the oracle, six pixels of each: points, lines, textures, fog, blending, bitmaps, ..."""
    rng = np.random.default_rng(group)
    for name in GROUPS[group]:
        screen.reset()
        screen.make_current()
        with capture() as frame:
            PROGRAMS[name]()
        picture = screen.pixels()
        assert not wrong(frame, picture, some_pixels(picture, 5, rng)), name


@pytest.mark.parametrize("mode", ["flat", "gouraud", "phong"])
@pytest.mark.parametrize("lobe", ["blinn", "phong"])
@pytest.mark.parametrize("scene", ["teapot", pytest.param("spheres", marks=pytest.mark.slow), "low-terrain"])
def test_the_equation_gives_the_pixel_in_scenes(scene: str, mode: str, lobe: str) -> None:
    frame = shaded(glsim.frame_of(scene, size=128), mode, lobe)
    other = glsim.offscreen(128, 128)
    other.execute(frame.packets)
    picture = other.pixels()
    other.release()
    rng = np.random.default_rng(len(scene) + len(mode) + len(lobe))
    assert not wrong(frame, picture, some_pixels(picture, 12, rng))


def test_a_wrong_material_is_found_out(screen: glsim.Offscreen) -> None:
    """The check can fail."""
    with capture() as frame:
        PROGRAMS["light_default"]()
    picture = screen.pixels()
    for draw in frame.draws:
        face = draw.material.front._replace(diffuse=(0.1, 0.9, 0.1, 1.0))
        draw.material = draw.material._replace(front=face)
    rng = np.random.default_rng(0)
    assert len(wrong(frame, picture, some_pixels(picture, 20, rng))) > 10


def floor() -> None:
    """A quad that goes away from the eye, black near and white far."""
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glFrustum(-1, 1, -1, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glBegin(GL_TRIANGLES)
    for z in ((1.0, 9.0, 9.0), (1.0, 9.0, 1.0)):
        for k, depth in enumerate(z):
            glColor3f(*[(depth - 1.0) / 8.0] * 3)
            glVertex3f((-1.0, -1.0, 1.0)[k] * 3 if z[2] == 9.0 else (-1.0, 1.0, 1.0)[k] * 3, -1.0, -depth)
    glEnd()


def test_weights_are_hyperbolic_and_linear(screen: glsim.Offscreen) -> None:
    """Perspective distortion: halfway on the screen is not halfway in space."""
    with capture() as frame:
        floor()
    probe = glsim.probe(frame, 64, 88)
    winner = probe.winner
    assert winner is not None
    linear = np.array([v.linear for v in winner.vertices])
    hyperbolic = np.array([v.hyperbolic for v in winner.vertices])
    w = np.array([-v.eye[2] for v in winner.vertices])
    assert linear.sum() == pytest.approx(1.0)
    assert hyperbolic == pytest.approx(linear / w / (linear / w).sum(), abs=1e-5)
    on_screen = np.array([v.window[:2] for v in winner.vertices])
    assert linear @ on_screen == pytest.approx([64.5, 128 - 88.5], abs=0.01)
    depth = hyperbolic @ w
    assert probe.pixel[0] == pytest.approx((depth - 1) / 8 * 255, abs=1.01)
    assert abs(depth - linear @ w) > 0.5


def lit_quad(z: float, color: tuple[float, float, float]) -> None:
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [*color, 0.5])
    glBegin(GL_QUADS)
    glNormal3f(0, 0, 1)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex3f(x, y, z)
    glEnd()


def test_the_history_of_a_pixel(screen: glsim.Offscreen) -> None:
    """Behind, before and through: what was hidden and what was blended, in order."""
    with capture(calls=True) as frame:
        glClearColor(0.2, 0.2, 0.2, 1)
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        for capability in (GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST):
            glEnable(capability)
        lit_quad(0.0, (1, 0, 0))
        lit_quad(0.5, (0, 1, 0))
        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        lit_quad(-0.5, (0, 0, 1))
    probe = glsim.probe(frame, 30, 40)
    assert [fragment.killed for fragment in probe.fragments] == ["", "depth test", ""]
    assert [fragment.draw for fragment in probe.fragments] == [0, 1, 2]
    (event,) = probe.events
    assert (event.packet, event.what, event.covers, event.after) == (0, "glClear", True, (51, 51, 51, 255))
    assert event.where is not None
    assert event.where.file == __file__
    winner = probe.winner
    assert winner is not None
    assert winner.before == probe.fragments[0].after
    assert [step.name for step in winner.steps] == ["depth test", "blending"]
    assert "GL_SRC_ALPHA" in winner.steps[-1].formula
    assert winner.where is not None
    assert winner.where.file == __file__
    assert winner.after == probe.pixel
    assert np.abs(np.subtract(probe.computed, probe.pixel)).max() <= 1
    assert tuple(screen.pixels()[40, 30]) == probe.pixel


def test_what_a_clear_or_a_mask_leaves(screen: glsim.Offscreen) -> None:
    """A fragment that was wiped, or that wrote nothing, is not what is seen."""
    with capture() as frame:
        lit_quad(0.0, (1, 0, 0))
        glEnable(GL_SCISSOR_TEST)
        glScissor(0, 0, 64, 128)
        glClearColor(0, 0, 1, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        glDisable(GL_SCISSOR_TEST)
        glColorMask(False, False, False, False)
        lit_quad(0.5, (0, 1, 0))
    left, right = glsim.probe(frame, 20, 20), glsim.probe(frame, 100, 20)
    assert left.winner is None
    assert left.covered is not None
    assert left.pixel == left.computed == (0, 0, 255, 255)
    assert right.winner is right.fragments[0]
    assert right.fragments[1].killed == "colour mask"


def test_attenuation_and_spot_stand_in_the_formula(screen: glsim.Offscreen) -> None:
    with capture() as frame:
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glLightfv(GL_LIGHT0, GL_POSITION, [0.2, 0, 1, 1])
        glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.5)
        glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 60)
        glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 4)
        glShadeModel(GL_PHONG_WIN)
        lit_quad(0.0, (0.4, 0.6, 0.2))
    probe = glsim.probe(frame, 80, 50)
    assert probe.winner is not None
    light = probe.winner.evaluations[0].lights[0]
    assert 0 < light.spot < 1
    assert light.attenuation == pytest.approx(1 / (1 + 0.5 * light.d))
    strength = light.attenuation * light.spot
    assert light.diffuse[0] == pytest.approx(strength * light.N_L * 0.4)
    assert r"\mathrm{attenuation} \, \mathrm{spot}" in probe.latex()


def test_the_terms_of_the_evaluation(screen: glsim.Offscreen) -> None:
    with capture() as frame:
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT2)
        glLightfv(GL_LIGHT2, GL_POSITION, [0, 3, 4, 0])
        glLightfv(GL_LIGHT2, GL_DIFFUSE, [0.5, 0.5, 0.5, 1])
        glLightfv(GL_LIGHT2, GL_SPECULAR, [1, 1, 1, 1])
        glMaterialfv(GL_FRONT, GL_SPECULAR, [0.9, 0.9, 0.9, 1])
        glMaterialf(GL_FRONT, GL_SHININESS, 10)
        glMaterialfv(GL_FRONT, GL_EMISSION, [0.05, 0, 0, 1])
        glShadeModel(GL_FLAT)
        lit_quad(0.0, (0.4, 0.6, 0.2))
    winner = glsim.probe(frame, 64, 64).winner
    assert winner is not None
    (evaluation,) = winner.evaluations  # flat: at the provoking vertex alone
    assert evaluation.at == "vertex 3"
    (light,) = evaluation.lights
    assert light.light == 2
    assert pytest.approx(0.8) == light.N_L
    assert light.vector == "H"
    assert light.cosine == pytest.approx((0.9) ** 0.5)
    assert light.power == pytest.approx(0.9**5)
    assert light.diffuse == pytest.approx((0.16, 0.24, 0.08))
    assert light.specular == pytest.approx([0.9 * 0.9**5] * 3)
    total = np.sum([evaluation.emission, evaluation.ambient, light.ambient, light.diffuse, light.specular], axis=0)
    assert evaluation.sum == pytest.approx(total)


def test_where_the_equation_ran(screen: glsim.Offscreen) -> None:
    for model, count, words in ((GL_FLAT, 1, "provoking"), (GL_SMOOTH, 3, "Gouraud"), (GL_PHONG_WIN, 1, "Phong")):
        screen.reset()
        with capture() as frame:
            glEnable(GL_LIGHTING)
            glEnable(GL_LIGHT0)
            glShadeModel(model)
            lit_quad(0.0, (0.4, 0.6, 0.2))
        winner = glsim.probe(frame, 20, 70).winner
        assert winner is not None
        assert len(winner.evaluations) == count
        assert words in winner.shading
        assert sum(entry.weight for entry in winner.evaluations) == pytest.approx(1.0)


def test_background_and_bad_pixels(screen: glsim.Offscreen) -> None:
    with capture() as frame:
        glClear(GL_COLOR_BUFFER_BIT)
    probe = glsim.probe(frame, 0, 127)
    assert probe.winner is None
    assert probe.computed == probe.pixel == (0, 0, 0, 0)
    for x, y in ((128, 0), (-1, 5), (0, 128)):
        with pytest.raises(ValueError, match="128 x 128 pixels"):
            glsim.probe(frame, x, y)


def test_reports(screen: glsim.Offscreen) -> None:
    """JSON, LaTeX, MathML and the table all have the numbers."""
    from rich.console import Console

    with capture() as frame:
        PROGRAMS["light_default"]()
    probe = glsim.probe(frame, 64, 64)
    assert probe.winner is not None
    record = json.loads(json.dumps(probe.as_dict()))
    assert record["fragments"][record["winner"]]["evaluations"][0]["lights"][0]["N_L"] == pytest.approx(
        probe.winner.evaluations[0].lights[0].N_L
    )
    latex = probe.latex()
    assert latex.count("{") == latex.count("}")
    assert r"(N\cdot L)" in latex
    document = xml.dom.minidom.parseString(probe.mathml())
    assert document.documentElement.tagName == "math"
    console = Console(width=160, record=True, file=open("/dev/null", "w"))  # noqa: SIM115
    console.print(probe)
    text = console.export_text()
    for words in (
        "hyperbolic",
        "k_d I_d (N.L)",
        "clamped",
        "8 bits",
        f"{probe.winner.evaluations[0].lights[0].N_L:.4f}",
    ):
        assert words in text


PROGRAM = """
from OpenGL.GL import *
from OpenGL.GLUT import *
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glRotatef(30, 0, 1, 0)
    glutSolidTeapot(0.6)
    glutSwapBuffers()
    glColor3f(1, 1, 1)
    glRectf(-1, -1, 1, 1)
def key(*arguments):
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [1, 0, 0, 1])
    glutPostRedisplay()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(100, 80)
glutCreateWindow("t")
for cap in (GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST):
    glEnable(cap)
glLightfv(GL_LIGHT0, GL_POSITION, [0, 0, -1, 0])
glutDisplayFunc(display)
glutKeyboardFunc(key)
glutMainLoop()
"""


@pytest.mark.slow
def test_a_program_is_probed_as_it_is_shown(tmp_path: Path) -> None:
    """What is drawn after the swap is not in the picture; events come before it."""
    script = tmp_path / "program.py"
    script.write_text(PROGRAM)
    probe = glsim.probe(script, 50, 40, calls=True)
    assert probe.winner is not None
    assert probe.winner.where is not None
    assert (Path(probe.winner.where.file).name, probe.winner.where.line) == ("program.py", 7)
    assert probe.winner.where.via == "glutSolidTeapot"
    red = glsim.probe(script, 50, 40, step=1, events=["key r"])
    assert red.pixel[0] > 40
    assert red.pixel[1] == red.pixel[2] < red.pixel[0]
    done = run(Plan(str(script), out=str(tmp_path / "out"), frames=2, events=["key r"]))
    picture = np.asarray(Image.open(tmp_path / "out" / done["pictures"][-1]))
    assert tuple(picture[40, 50]) == red.pixel[:3]
    (tmp_path / "bad.py").write_text("print(1)\n")
    with pytest.raises(ValueError, match=r"bad\.py gives no picture"):
        glsim.probe(tmp_path / "bad.py", 1, 1)
