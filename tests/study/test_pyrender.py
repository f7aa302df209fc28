"""glsim.study.pyrender: where both models coincide the pictures do, and what differs is said."""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from glsim import gl
from glsim.machine.frame import Frame
from glsim.machine.state import Light
from glsim.play.frames import frame_of
from glsim.render.context import own_screen
from glsim.scenes import Face, Lamp, Scene
from glsim.scenes.shapes import sphere
from glsim.study import pyrender
from glsim.study.metallic import cone, exponent, face, metal, source
from glsim.study.physical import physical

SIZE = 96
installed = pytest.mark.skipif(find_spec("pyrender") is None, reason="pyrender is not installed (extra `pyrender`)")

# ---------------------------------------------------------------- what is drawn


def screen(
    k_d: Any = 0.0, k_s: float = 0.0, n: float = 20.0, *, k_a: float = 0.0, E: Any = 0.0, lights: int = 1
) -> None:
    """A square that fills the picture: N = V = (0, 0, 1), and the lights shine along it."""
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glLightModelfv(gl.GL_LIGHT_MODEL_AMBIENT, [0.5, 0.5, 0.5, 1])
    for number in range(lights):
        gl.glEnable(gl.GL_LIGHT0 + number)
        for name in (gl.GL_DIFFUSE, gl.GL_SPECULAR):
            gl.glLightfv(gl.GL_LIGHT0 + number, name, [1 / lights] * 3 + [1])
    side = gl.GL_FRONT_AND_BACK
    for name, value in ((gl.GL_AMBIENT, k_a), (gl.GL_DIFFUSE, k_d), (gl.GL_SPECULAR, k_s), (gl.GL_EMISSION, E)):
        gl.glMaterialfv(side, name, [*np.broadcast_to(value, 3).tolist(), 1])
    gl.glMaterialf(side, gl.GL_SHININESS, n)
    gl.glRectf(-1, -1, 1, 1)


def unlit() -> None:
    """Three unlit bands, the last one half transparent over grey, on a clear colour; and one line."""
    gl.glClearColor(0.2, 0.4, 0.6, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glColor3f(1, 0.5, 0.25)
    gl.glRectf(-0.9, -0.9, -0.4, 0.9)
    gl.glBegin(gl.GL_QUADS)
    for x, red in ((-0.3, 0), (0.2, 1)):
        for y in (-0.9, 0.9) if red == 0 else (0.9, -0.9):
            gl.glColor3f(red, 0.5, 0)
            gl.glVertex3f(x, -y, 0)
    gl.glEnd()
    gl.glEnable(gl.GL_BLEND)
    gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
    gl.glColor4f(1, 0, 0, 0.5)
    gl.glRectf(0.3, -0.9, 0.8, 0.9)


def sides() -> None:
    """A square seen from its front and one from its back, two-sided, and two that are culled."""
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    for capability in (gl.GL_LIGHTING, gl.GL_LIGHT0, gl.GL_DEPTH_TEST):
        gl.glEnable(capability)
    gl.glLightModelfv(gl.GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
    gl.glLightModeli(gl.GL_LIGHT_MODEL_TWO_SIDE, 1)
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, [0.8, 0.2, 0.2, 1])
    gl.glMaterialfv(gl.GL_BACK, gl.GL_DIFFUSE, [0.2, 0.8, 0.2, 1])
    gl.glRectf(-1, -1, -0.5, 1)
    gl.glNormal3f(0, 0, -1)
    gl.glFrontFace(gl.GL_CW)
    gl.glNormal3f(0, 0, -1)
    gl.glRectf(-0.5, -1, 0, 1)
    gl.glFrontFace(gl.GL_CCW)
    gl.glNormal3f(0, 0, 1)
    gl.glEnable(gl.GL_CULL_FACE)
    gl.glRectf(0, -1, 0.5, 1)
    gl.glCullFace(gl.GL_FRONT)
    gl.glRectf(0.5, -1, 1, 1)


def ball(k_d: tuple[float, float, float], k_s: float, n: float, light: tuple[float, float, float, float]) -> Scene:
    look = Face((0, 0, 0, 1), (*k_d, 1), (k_s, k_s, k_s, 1), (0, 0, 0, 1), n)
    return Scene("ball", [sphere(64)], look, lights=[Lamp(light)], background=(0.0, 0.0, 0.0))


def lamp_near(light: Callable[[], None]) -> None:
    """A wide floor of many squares under a positional light one unit above its middle."""
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    for capability in (gl.GL_LIGHTING, gl.GL_LIGHT0, gl.GL_DEPTH_TEST):
        gl.glEnable(capability)
    gl.glShadeModel(gl.GL_PHONG_WIN)
    gl.glLightModelfv(gl.GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, [0.7, 0.7, 0.7, 1])
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_SPECULAR, [1, 1, 1, 1])
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, [0, 0, 0.5, 1])
    light()
    gl.glRectf(-1, -1, 1, 1)


def quadratic() -> None:
    gl.glLightf(gl.GL_LIGHT0, gl.GL_CONSTANT_ATTENUATION, 0)
    gl.glLightf(gl.GL_LIGHT0, gl.GL_QUADRATIC_ATTENUATION, 4)


def spot() -> None:
    quadratic()
    gl.glLightf(gl.GL_LIGHT0, gl.GL_SPOT_CUTOFF, 40)


DIFFUSE = ball((0.8, 0.5, 0.2), 0.0, 0.0, (-1.0, 1.0, 2.0, 0.0))
SHINY = ball((0.3, 0.3, 0.3), 0.6, 40.0, (-0.5, 0.6, 1.0, 0.0))
DRAWN: dict[str, Any] = {
    "diffuse": partial(screen, (0.8, 0.5, 0.2)),
    "strong": partial(screen, 0.3, 0.5, 20.0),
    "weak": partial(screen, 0.3, 0.02, 100.0),
    "metal": partial(screen, 0.2, 0.3, 6.0),
    "glowing": partial(screen, 0.0, k_a=0.4, E=(0.3, 0.1, 0.0), lights=0),
    "eight lights": partial(screen, 0.6, lights=8),
    "unlit": unlit,
    "sides": sides,
    "quadratic": partial(lamp_near, quadratic),
    "spot": partial(lamp_near, spot),
    "diffuse ball": DIFFUSE,
    "shiny ball": SHINY,
}
Pair = tuple[NDArray[np.int16], NDArray[np.int16]]


@pytest.fixture(scope="module")
def pairs() -> dict[str, Pair]:
    """By name: the picture by glsim, shaded for each pixel, and the one by pyrender."""
    from glsim.play.reshade import shaded

    frames = {name: frame_of(what, size=SIZE) for name, what in DRAWN.items()}
    theirs = pyrender.pictures(list(frames.values()))
    ours = []
    with own_screen(SIZE, SIZE) as target:
        for frame in frames.values():
            target.reset()
            target.execute(shaded(frame, "phong", "blinn").packets)
            ours.append(target.pixels()[..., :3])
    return {name: (a.astype(np.int16), b.astype(np.int16)) for name, a, b in zip(frames, ours, theirs, strict=True)}


# ---------------------------------------------------------------- pictures


@installed
@pytest.mark.slow
def test_seen_along_the_normal_both_models_give_the_same_colour(pairs: dict[str, Pair]) -> None:
    for name in ("strong", "weak", "metal", "glowing"):
        ours, theirs = pairs[name]
        assert np.ptp(ours) > 0 or ours.max() > 20, name
        assert np.abs(theirs - ours).max() <= 1, name


@installed
@pytest.mark.slow
@pytest.mark.parametrize("name", ["diffuse", "eight lights"])
def test_a_diffuse_surface_has_the_four_percent_of_a_dielectric_on_top(pairs: dict[str, Pair], name: str) -> None:
    ours, theirs = pairs[name]
    assert np.abs(theirs - ours - 255 * 0.01).max() <= 1  # F_0 / 4 of a light of 1, at alpha = 1 along the normal


@installed
@pytest.mark.slow
def test_a_diffuse_sphere_is_that_of_the_lecture(pairs: dict[str, Pair]) -> None:
    ours, theirs = pairs["diffuse ball"]
    inside = ours.max(axis=2) > 0
    assert inside.sum() > 1000
    difference = (theirs - ours)[inside]
    assert difference.min() >= -1
    assert difference.max() <= 6
    assert (theirs[0, 0] == 0).all()


@installed
@pytest.mark.slow
def test_the_highlight_is_at_the_same_place_as_high_and_narrower(pairs: dict[str, Pair]) -> None:
    spots = []
    for picture in pairs["shiny ball"]:
        bright = np.argwhere(picture[..., 0] > 0.75 * picture.max())
        spots.append((bright.mean(axis=0), math.sqrt(len(bright)), picture.max()))
    (centre, width, height), (their_centre, their_width, their_height) = spots
    assert 3 < width < SIZE / 4
    assert np.abs(their_centre - centre).max() < 1.0
    assert 0.65 < their_width / width < 0.9  # 0.77 by the formulas of the two lobes
    assert abs(int(their_height) - int(height)) <= 12


@installed
@pytest.mark.slow
@pytest.mark.parametrize("name", ["unlit", "sides"])
def test_what_needs_no_light_model_is_the_same(pairs: dict[str, Pair], name: str) -> None:
    ours, theirs = pairs[name]
    assert len(np.unique(ours.reshape(-1, 3), axis=0)) >= 3
    assert np.abs(theirs - ours).max() <= (1 if name == "unlit" else 4)


@installed
@pytest.mark.slow
def test_positional_lights_and_spots(pairs: dict[str, Pair]) -> None:
    for name in ("quadratic", "spot"):
        ours, theirs = pairs[name]
        assert np.ptp(ours) > 100, name
        difference = theirs - ours
        assert (np.abs(difference) > 6).any(axis=2).mean() < 0.03, name  # the edge of the cone
        assert abs(float(difference.mean())) < 3, name


@installed
@pytest.mark.slow
def test_pyrender_leaves_nothing_behind() -> None:
    modules, environment = set(sys.modules), dict(os.environ)
    with own_screen(8, 8) as target:
        gl.glClearColor(1, 0, 0, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        theirs = pyrender.picture(frame_of(partial(screen, 0.5), size=9), encoded=True)
        assert target.pixels()[0, 0, :3].tolist() == [255, 0, 0]
    assert theirs.shape == (9, 9, 3)
    assert not {name for name in set(sys.modules) - modules if name.startswith(("pyrender", "OpenGL"))}
    assert dict(os.environ) == environment


# ---------------------------------------------------------------- a pyrender.Scene


@pytest.fixture
def library(monkeypatch: pytest.MonkeyPatch) -> Any:
    """pyrender itself, in this process: only data are made with it, and nothing is drawn."""
    monkeypatch.setenv("PYOPENGL_PLATFORM", "egl")
    return pytest.importorskip("pyrender", reason="pyrender is not installed (extra `pyrender`)")


def facing(eye: tuple[float, float, float]) -> NDArray[np.float64]:
    """A pose at ``eye`` that looks at the origin."""
    z = np.array(eye) / np.linalg.norm(eye)
    x = np.cross((0, 1, 0), z)
    pose = np.eye(4)
    pose[:3] = np.c_[x / np.linalg.norm(x), np.cross(z, x / np.linalg.norm(x)), z, eye]
    return pose


def still_life(library: Any) -> Any:
    """Balls of three materials on a plate in one vertex colour, under a light of each kind."""
    import trimesh

    scene = library.Scene(bg_color=[0.3, 0.4, 0.5, 1.0], ambient_light=[0.05, 0.05, 0.05])
    shape = trimesh.creation.icosphere(subdivisions=3)
    for x, base, metallic, roughness in ((-2.2, (0.8, 0.1, 0.1), 0.0, 0.9), (0.0, (0.9, 0.7, 0.3), 0.4, 0.45),
                                         (2.2, (0.3, 0.3, 0.9), 0.0, 0.5)):  # fmt: skip
        look = library.MetallicRoughnessMaterial(
            baseColorFactor=[*base, 1.0],
            metallicFactor=metallic,
            roughnessFactor=roughness,
            emissiveFactor=[0.2, 0.0, 0.0],
        )
        pose = np.eye(4)
        pose[0, 3] = x
        scene.add(library.Mesh.from_trimesh(shape, material=look), pose=pose)
    plate = trimesh.creation.box((8, 0.1, 4))
    plate.visual.vertex_colors = [120, 160, 120, 255]
    pose = np.eye(4)
    pose[1, 3] = -1.05
    scene.add(library.Mesh.from_trimesh(plate, smooth=False), pose=pose)
    scene.add(library.PerspectiveCamera(yfov=0.7), pose=facing((2, 2, 9)))
    scene.add(library.DirectionalLight(intensity=2.0), pose=facing((3, 5, 4)))
    scene.add(library.PointLight(color=[1.0, 0.8, 0.6], intensity=12.0), pose=facing((-3, 3, 3)))
    cone = {"innerConeAngle": 0.1, "outerConeAngle": 0.4}
    scene.add(library.SpotLight(color=[0.5, 0.8, 1.0], intensity=40.0, **cone), pose=facing((3, 4, 5)))
    return scene


@pytest.mark.slow
def test_a_scene_of_pyrender_comes_back_as_it_was(library: Any) -> None:
    scene = still_life(library)
    draw = pyrender.scene_of(scene)
    assert draw.notes == ()
    frame = frame_of(draw, size=SIZE)
    own, back = pyrender.pictures([scene, frame], SIZE, SIZE)
    assert len(np.unique(own.reshape(-1, 3), axis=0)) > 500
    assert np.abs(own.astype(int) - back).max() <= 1


def test_what_a_scene_of_pyrender_lacks_is_said(library: Any) -> None:
    scene = library.Scene()
    with pytest.raises(ValueError, match="no camera"):
        pyrender.scene_of(scene)
    with pytest.raises(TypeError, match=r"pyrender\.Scene is needed, not 'teapot'"):
        pyrender.scene_of("teapot")
    scene.add(library.PerspectiveCamera(yfov=1.0))
    for k in range(9):
        scene.add(library.DirectionalLight(intensity=1.0 + k))
    assert "the brightest are drawn" in pyrender.scene_of(scene).notes[0]


# ---------------------------------------------------------------- what is said


@installed
@pytest.mark.slow
def test_what_cannot_be_drawn_is_one_sentence() -> None:
    frame = frame_of(partial(screen, 0.5), size=8)
    with pytest.raises(ValueError, match=r"^samples must be at most \d+ in pyrender's context, not 1024$"):
        pyrender.picture(frame, samples=1024)
    with pytest.raises(TypeError, match=r"draws a Frame or a pyrender\.Scene, not 'teapot'"):
        pyrender.picture("teapot")


def test_without_pyrender_the_way_to_install_it_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pyrender, "find_spec", lambda name: None)
    with pytest.raises(pyrender.NoPyrenderError, match=r"pip install 'glsim\[pyrender\]'"):
        pyrender.picture(Frame(8, 8))


def test_what_cannot_be_converted_is_said() -> None:
    def draw() -> None:
        gl.glEnable(gl.GL_FOG)
        gl.glLineWidth(3)
        gl.glScalef(0.5, 0.5, 0.5)
        lamp_near(lambda: gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, [1, 1, 1, 1]))

    notes = physical(frame_of(draw, size=8)).notes
    for words in ("fog", "one pixel wide", "1 / d^2", "I_s is left out", "more light than arrives", "normalised"):
        assert sum(words in sentence for sentence in notes) == (words != "I_s is left out"), words
    assert physical(frame_of(partial(screen, 0.5, 0.3), size=8)).notes == []


# ---------------------------------------------------------------- formulas


@pytest.mark.parametrize("n", [0.0, 1.0, 12.8, 128.0])
@pytest.mark.parametrize("k_d", [0.05, 0.4, 0.7])
@pytest.mark.parametrize("k_s", [0.02, 0.2, 0.5])
def test_grey_materials_come_back(k_d: float, k_s: float, n: float) -> None:
    material = metal([k_d] * 3, [k_s] * 3, n)
    back = face(material)
    strong = 8 * k_s / (n + 2) >= 0.04  # F_0 of a dielectric: a weaker highlight becomes wider
    if max(material.base[:3]) < 1:
        np.testing.assert_allclose(back.diffuse[:3], k_d, rtol=1e-6)
        np.testing.assert_allclose(back.specular[:3], k_s, rtol=1e-6)
    if strong:
        assert back.shininess == pytest.approx(n, abs=1e-6)
    else:
        assert back.shininess < n
    assert 0 <= material.metallic <= 1
    assert 0 < material.roughness <= 1
    assert max(material.base) <= 1


def test_every_material_of_the_literature_can_be_converted() -> None:
    from glsim.scenes import MATERIALS

    for name, look in MATERIALS.items():
        material = metal(look.diffuse[:3], look.specular[:3], look.shininess)
        assert np.isfinite([*material.base, material.metallic, material.roughness]).all(), name
        assert 0 <= min(material.base) <= max(material.base) <= 1, name


@pytest.mark.parametrize(("cutoff", "e"), [(40.0, 0.0), (90.0, 1.0), (90.0, 10.0), (60.0, 3.0), (90.0, 128.0)])
def test_half_of_a_cone_is_at_the_same_angle(cutoff: float, e: float) -> None:
    inner, outer = cone(cutoff, e)
    assert 0 <= inner <= outer <= math.radians(cutoff) + 1e-9
    assert exponent(inner, outer) == pytest.approx(e, rel=1e-6)


def test_a_direction_with_a_cutoff_is_a_spot_seen_from_infinitely_far() -> None:
    light = Light(diffuse=(1, 1, 1, 1), position=(0, 0, 1, 0), spot_cutoff=30.0, spot_exponent=2.0)
    slanted = light._replace(spot_direction=(0.0, math.sin(0.4), -math.cos(0.4)))
    assert source(slanted).color[0] == pytest.approx(math.pi * math.cos(0.4) ** 2)
    assert source(light._replace(spot_direction=(0.0, 1.0, 0.0))).color == (0, 0, 0)
