"""Columns and rows of glsim.compare: looks, sweeps, given pictures."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.gl import *
from glsim.render.native import Native
from glsim.scenes import Camera, Lamp, open_scene
from glsim.scenes.staging import lamp_of
from glsim.study.compare import compare

SPOT = Lamp((0.5, 1.0, -1.5, 1.0), 0.9, cutoff=40.0, exponent=3.0, attenuation=(1.0, 0.1, 0.05))


def one(what: Any, **options: Any) -> np.ndarray:
    """The only picture of a comparison, 64 pixels wide."""
    (picture,) = compare(what, **{"size": 64, "lobes": "blinn", "modes": "phong", **options}).images.values()
    return picture


def open_shell() -> None:
    """A strip of quads bent around the y axis, open towards the eye, so that its back sides are seen too."""
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_POSITION, [0.4, 0.6, 1, 0])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.8, 0.3, 0.1, 1])
    glMaterialfv(GL_BACK, GL_DIFFUSE, [0.1, 0.4, 0.9, 1])
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, [0.6, 0.6, 0.6, 1])
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 8)
    glNewList(1, GL_COMPILE)
    glBegin(GL_QUAD_STRIP)
    for k in range(17):
        angle = 0.9 + k * 1.5 * np.pi / 16
        if k == 8:
            glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40)
        glNormal3f(np.sin(angle), 0, np.cos(angle))
        for y in (0.8, -0.8):
            glVertex3f(0.8 * np.sin(angle), y, 0.8 * np.cos(angle))
    glEnd()
    glEndList()
    glRotatef(20, 1, 0, 0)
    glCallList(1)


# ---------------------------------------------------------------- looks


@pytest.mark.parametrize("back", ["clamp", "two-sided"])
def test_back_lighting_is_the_drivers(native: Native, back: str) -> None:
    result = compare(open_shell, modes=[f"gouraud:{back}", f"native:{back}"], size=96)
    assert result.difference("blinn", f"gouraud:{back}").max() <= 1, "from the driver's picture"
    assert result.rows.names == ["blinn"], "the driver has no other lobe"


def test_the_driver_alone(native: Native, tmp_path: Path) -> None:
    result = compare("cube", modes="native", size=32)
    assert list(result.images) == [("blinn", "native")]
    result.save(tmp_path / "page.html")
    both = compare("cube", modes="native", lobes="blinn,phong", size=32)
    assert [strip.title for strip in both.strips()] == ["Blinn-Torrance  (N·H)^n"]
    assert both.sheet.size[1] > 64
    with pytest.raises(ValueError, match="has the lobe blinn only"):
        compare("cube", modes="native", lobes="phong", size=32)


def test_a_lobe_that_the_driver_lacks_compares_nothing(native: Native) -> None:
    """Gouraud shading would be compared with itself."""
    result = compare("cube", modes="gouraud,native", lobes="blinn,phong", size=32)
    assert result.reference == "native"
    assert [(row["lobe"], row["mode"], row["max"]) for row in result.metrics[2:]] == [("phong", "gouraud", None)]
    assert result.metrics[0]["max"] <= 1
    assert result.difference_words("phong", "gouraud") == []
    assert result.strips()[1].metrics == [None]


def test_flip_lights_what_looks_away() -> None:
    images = compare(open_shell, modes="phong:clamp,phong:flip,phong:two-sided", lobes="blinn", size=96).images
    clamp, flip, two = (images["blinn", f"phong:{back}"].astype(int) for back in ("clamp", "flip", "two-sided"))
    assert (flip >= clamp).all()
    assert (flip.sum(axis=2) - clamp.sum(axis=2)).max() > 100
    assert (two[..., 2] > two[..., 0] + 20).any(), "the blue material of the back sides"
    assert not (flip[..., 2] > flip[..., 0] + 20).any(), "flip keeps the material of the front"


def test_a_column_has_its_own_lobe() -> None:
    result = compare("sphere:12", modes="phong:blinn,phong:phong", size=64)
    usual = compare("sphere:12", modes="phong", size=64).images
    assert result.rows.names == ["blinn"]
    for lobe in ("blinn", "phong"):
        assert np.array_equal(result.images["blinn", f"phong:{lobe}"], usual[lobe, "phong"])


def test_hidden_lines() -> None:
    images = compare("cube", modes="wireframe,hidden-line", lobes="blinn", size=128, camera=Camera(30, 25, 4)).images
    wire, hidden = (images["blinn", mode] for mode in ("wireframe", "hidden-line"))
    background = wire[0, 0]
    edges, seen = ((picture != background).any(axis=2) for picture in (wire, hidden))
    assert not (seen & ~edges).any()
    assert 0.65 < seen.sum() / edges.sum() < 0.85, "nine of twelve edges"


def test_hidden_lines_of_what_has_texture_fog_and_blending() -> None:
    def draw() -> None:
        glClearColor(1, 1, 1, 1)
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        for capability in (GL_DEPTH_TEST, GL_TEXTURE_2D, GL_FOG, GL_BLEND):
            glEnable(capability)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes([255, 0, 0]))
        glColor4f(0, 0, 1, 0.5)
        glRectf(-0.5, -0.5, 0.5, 0.5)

    picture = one(draw, modes="hidden-line")
    assert (picture[20:44, 20:44] == 255).all()
    assert (picture != 255).any()


# ---------------------------------------------------------------- sweeps


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("shininess", [1, 60]),
        ("light", ["1,0.5,0.5,1", Lamp((0, 1, -1, 0), 0.5), replace(SPOT, direction=(0.0, -1.0, 0.2))]),
        ("brightness", [0.3]),
        ("ambient", ["0.8"]),
    ],
)
def test_sweeps_say_the_same_to_the_driver(native: Native, name: str, values: list[Any]) -> None:
    result = compare(open_shell, modes="gouraud,native", sweep={name: values}, size=96)
    plain = one(open_shell, modes="gouraud", size=96)
    for row in result.rows.names:
        assert result.difference(row, "gouraud").max() <= 1
        assert not np.array_equal(result.images[row, "gouraud"], plain)


@pytest.mark.parametrize(
    ("sweep", "lamp"),
    [
        ({"cutoff": "10"}, replace(SPOT, cutoff=10.0)),
        ({"exponent": "60"}, replace(SPOT, exponent=60.0)),
        ({"attenuation": "0.5"}, replace(SPOT, attenuation=(1.0, 0.0, 0.5))),
        ({"attenuation": "0,1,0"}, replace(SPOT, attenuation=(0.0, 1.0, 0.0))),
        ({"brightness": "0.2"}, replace(SPOT, brightness=0.2)),
        ({"light": "-1,1,-2,1"}, replace(SPOT, position=(-1.0, 1.0, -2.0, 1.0))),
    ],
)
def test_a_swept_light_is_a_scene_with_that_light(sweep: dict[str, str], lamp: Lamp) -> None:
    swept = one("sphere:24", lights=[SPOT], sweep=sweep)
    assert np.array_equal(swept, one("sphere:24", lights=[lamp]))
    assert not np.array_equal(swept, one("sphere:24", lights=[SPOT]))


def test_a_cone_is_for_the_light_that_was_moved() -> None:
    """In either order, and though the scene's own light is a direction."""
    moved = one("sphere:24", lights=[Lamp((2.0, 0.0, -1.0, 1.0), cutoff=9.0)])
    for sweep in ({"light": "2,0,-1,1", "cutoff": "9"}, {"cutoff": "9", "light": "2,0,-1,1"}):
        assert np.array_equal(one("sphere:24", lights=["0,1,1"], sweep=sweep), moved)


def test_what_is_swept_of_a_scene_is_that_scene() -> None:
    scene = open_scene("sphere:24")
    shiny = replace(scene, material=scene.material._replace(shininess=9.0))
    assert np.array_equal(one(scene, sweep={"shininess": [9]}), one(shiny))
    assert np.array_equal(one("sphere", segments="24"), one(scene))
    assert np.array_equal(one(scene, sweep={"material": "jade"}), one(scene, material="jade"))
    assert np.array_equal(one(scene, sweep={"camera": "40,5,6"}), one(scene, camera="40,5,6"))
    jade = one("cube", segments="3", material="jade")
    assert np.array_equal(jade, one("cube:3", material="jade"))


def test_columns_and_rows_are_chosen() -> None:
    sheet = compare("sphere:8", segments=[4, 8], modes="flat,phong", size=32)
    turned = compare("sphere:8", segments=[4, 8], modes="flat,phong", size=32, columns="segments")
    assert (sheet.columns.name, sheet.rows.name) == ("mode", "segments")
    assert (turned.columns.name, turned.rows.name) == ("segments", "mode")
    assert all(np.array_equal(picture, turned.images[key[::-1]]) for key, picture in sheet.images.items())
    two = compare("sphere", sweep={"shininess": "4,40", "light": "0,1,1/1,0,1"}, size=32)
    assert (two.columns.names, two.rows.names) == (["4", "40"], ["0,1,1", "1,0,1"])
    assert len({picture.tobytes() for picture in two.images.values()}) == 4
    lobes = compare("sphere", segments=[8], modes="wireframe,phong", lobes="blinn,phong", size=32)
    assert lobes.columns.names == ["wireframe", "phong:blinn", "phong:phong"]


def test_a_function_is_swept_by_its_parameters() -> None:
    def square(half: float) -> None:
        glRectf(-half, -half, half, half)

    images = compare(square, modes="unlit", sweep={"half": [0.25, 0.5]}, size=64).images
    assert [int(picture[..., 0].astype(bool).sum()) for picture in images.values()] == [16 * 16, 32 * 32]

    def fan(points: list[tuple[float, float]]) -> None:
        glBegin(GL_TRIANGLE_FAN)
        for point in points:
            glVertex2f(*point)
        glEnd()

    shapes = [[(0, 0), (1, 0), (0, 1)], np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])]
    fans = compare(fan, modes="unlit,wireframe", sweep={"points": shapes}, size=32).images
    assert [bool(picture[20, 4].any()) for (_, mode), picture in fans.items() if mode == "unlit"] == [False, True]


def test_an_animation_is_a_third_axis(tmp_path: Path) -> None:
    result = compare("teapot:2", modes="phong", lobes="blinn", size=48, animate="turntable", frames=4)
    result.save(tmp_path / "turn.gif")
    with Image.open(tmp_path / "turn.gif") as file:
        assert file.n_frames == len(result.film) == 4
    light = compare(open_shell, modes="phong", lobes="blinn", size=48, animate="light", frames=3).film
    assert len({np.asarray(sheet.convert("RGB")).tobytes() for sheet in light}) == 3
    shine = compare("sphere:9", modes="phong", lobes="blinn", size=48, animate="shininess=1,80").film
    assert len(shine) == 2
    with pytest.raises(ValueError, match="turntable needs a scene whose camera can move"):
        compare(open_shell, size=48, animate="turntable")


# ---------------------------------------------------------------- given pictures, programs


def test_given_pictures(tmp_path: Path) -> None:
    noise = np.random.default_rng(1).integers(0, 256, (30, 40, 4), np.uint8)
    Image.fromarray(noise).save(tmp_path / "a.png")
    Image.fromarray(255 - noise[..., :3]).save(tmp_path / "b.png")
    result = compare([tmp_path / "a.png", tmp_path / "b.png"])
    assert result.columns.names == ["a.png", "b.png"]
    assert np.array_equal(result.difference("", "b.png"), np.abs(255 - 2 * noise[..., :3].astype(int)))
    beside = compare("cube", modes="flat", lobes="blinn", size=32, pictures={"mine": noise[:32, :32]})
    assert beside.columns.names == ["flat", "mine"]
    assert beside.metrics[1]["max"] is None
    assert beside.notes == ["mine and flat have 32 x 30 and 32 x 32 pixels: no difference can be taken"]
    assert beside.sheet.size[0] > 64
    with pytest.raises(ValueError, match=r"the picture .*a\.png is given twice"):
        compare([tmp_path / "a.png", tmp_path / "b.png", tmp_path / "a.png"])
    with pytest.raises(ValueError, match=r"'x' must be \(height, width, 3 or 4\) of uint8"):
        compare({"x": np.zeros((4, 4))})
    with pytest.raises(ValueError, match="modes and sweeps need a scene"):
        compare([tmp_path / "a.png"], modes="flat")


def test_a_frame_is_shaded_anew(screen: glsim.Offscreen) -> None:
    with glsim.capture(calls=True) as frame:
        open_shell()
    result = compare(frame, modes="gouraud,phong", lobes="blinn")
    assert result.images["blinn", "gouraud"].shape == (128, 128, 3)
    assert np.array_equal(result.images["blinn", "gouraud"], screen.pixels()[..., :3])


@pytest.mark.slow
def test_a_program_runs_once(tmp_path: Path) -> None:
    (tmp_path / "program.py").write_text(
        "import glsim\nfrom glsim.gl import *\n"
        "open('runs', 'a').write('x')\nscreen = glsim.offscreen(40, 30)\nglEnable(GL_LIGHTING)\nglEnable(GL_LIGHT0)\n"
        "glNormal3f(0.3, 0, 0.95)\nglRectf(-0.5, -0.5, 0.5, 0.5)\nscreen.pixels()\nraise ValueError('late')\n"
    )
    result = compare(tmp_path / "program.py", modes="wireframe,flat,gouraud,phong")
    assert len(result.images) == 8
    runs = [path.read_text() for path in (tmp_path / "runs", Path("runs")) if path.exists()]
    Path("runs").unlink(missing_ok=True)
    assert runs == ["x"]
    assert result.note == "program.py ended early: ValueError: late"


# ---------------------------------------------------------------- errors


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (dict(modes="flatt"), "modes are .* not flatt; did you mean 'flat'?"),
        (dict(modes="flat,flat"), "mode flat is given twice"),
        (dict(modes="phong:blin"), "options of a mode are .* not 'blin'; did you mean 'blinn'?"),
        (dict(modes="phong:flip:clamp"), "flip and clamp exclude each other"),
        (dict(modes="wireframe:blinn"), "wireframe has no lobe"),
        (dict(modes="unlit:flip"), "unlit has no back lighting"),
        (dict(modes="native:phong"), "fixed function has"),
        (dict(reference="gourad"), "the reference is a column, of flat, gouraud, phong, not 'gourad'; did you mean"),
        (dict(differences="8x"), 'differences are "auto", "off" or amplified'),
        (dict(layout="beamer"), "layouts are screen, projector, paper, not 'beamer'"),
        (dict(captions={"gourad": "x"}), "captions are for .* did you mean 'gouraud'"),
        (dict(sweep={"shinines": "1"}), "axes are .* not 'shinines'; did you mean 'shininess'?"),
        (dict(sweep={"shininess": "1,200"}), "shininess: shininess is from 0 to 128, not 200"),
        (dict(sweep={"shininess": "4,4"}), "needs values, each once, not 4, 4"),
        (dict(sweep={"shininess": "1,x"}), "shininess: numbers separated by commas are needed, not 'x'"),
        (dict(sweep={"light": "0,1"}), "light: 3 to 5 numbers are needed, not '0,1'"),
        (dict(sweep={"material": "bras"}), "did you mean 'brass'"),
        (dict(segments=[8.5]), "the number of segments is a whole one, not 8.5"),
        (dict(animate="turntable", frames=0), "an animation has 1 picture or more, not 0"),
        (dict(segments="0"), "the number of segments is from 1 to 2000"),
        (dict(sweep={"shininess": "1", "ambient": "1"}, modes="flat,phong"), "two axes, not mode, shininess, ambient"),
        (dict(pictures={"flat": np.zeros((4, 4, 3), np.uint8)}), "column flat is given twice"),
        (dict(columns="lobes"), "columns can be mode or lobe, not 'lobes'; did you mean 'lobe'?"),
        (dict(animate="turn"), "animations are turntable, light or NAME=VALUES, not 'turn'"),
        (dict(lights=["0,1,2:cuttoff=3"]), "not 'cuttoff=3'; did you mean 'cutoff'?"),
        (dict(lights=["0,1,2:cutoff=120"]), "a spot's cutoff is from 0 to 90, not 120"),
        (dict(lights=["0,1,2:attenuation=0,0,0"]), "none negative and not all 0"),
        (dict(lights=["0,1,2:direction=0,0,0"]), "direction cannot be 0,0,0"),
    ],
)
def test_wrong_options_get_a_sentence(options: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        compare("cube", size=32, **options)


def test_nothing_to_compare() -> None:
    for what in (None, {}, []):
        with pytest.raises(ValueError, match="nothing to compare: name a scene"):
            compare(what)
    with pytest.raises(TypeError, match="modes and lobes are names, not 3"):
        compare("cube", modes=["flat", 3])  # type: ignore[list-item]


def test_what_cannot_be_swept_says_why() -> None:
    with pytest.raises(ValueError, match="spheres has its own vertices; segments are for teapot, sphere"):
        compare("spheres", segments="8", size=32)
    with pytest.raises(ValueError, match=r"open_shell sets its own segments; .* def open_shell\(segments\)"):
        compare(open_shell, segments="8", size=32)
    with pytest.raises(ValueError, match="cutoff means nothing for a light that is a direction"):
        compare("sphere", sweep={"cutoff": "20"}, size=32)
    with pytest.raises(ValueError, match="no light is on here"):
        compare(lambda: glRectf(0, 0, 1, 1), sweep={"brightness": "1"}, size=32)


def test_lamps_as_they_are_written() -> None:
    assert lamp_of("-2,3,4") == Lamp((-2.0, 3.0, 4.0, 0.0))
    assert lamp_of("0,2,3:cutoff=20:exponent=5") == Lamp((0.0, 2.0, 3.0, 1.0), cutoff=20.0, exponent=5.0)
    assert lamp_of("0,2,3,0:cutoff=20").position[3] == 0.0
    assert lamp_of("0,2,3,1,0.5:direction=0,-1,0").direction == (0.0, -1.0, 0.0)
    assert lamp_of("0,2,3:attenuation=0.25").attenuation == (1.0, 0.0, 0.25)
