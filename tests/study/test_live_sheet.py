"""Comparisons as live pictures: what becomes a mode, a lobe or a picture, and what can be changed."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.course.outputs import LIVE, shown
from glsim.gl import *
from glsim.glut import glutSolidSphere
from glsim.study.live import controls_of
from glsim.web.live import Live


def ball(light: str = "directional", shine: float = 20.0) -> None:
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(capability)
    glLightfv(GL_LIGHT0, GL_POSITION, [0.5, 1.0, 2.0, float(light == "point")])
    glMaterialf(GL_FRONT, GL_SHININESS, shine)
    glutSolidSphere(0.8, 8, 6)


def sheet(**options: Any) -> glsim.Comparison:
    return glsim.compare(ball, size=32, **{"live": "camera", "differences": "off", **options})


def made(**options: Any) -> Live:
    live = sheet(**options).live
    assert live is not None
    return live


def test_modes_and_lobes_are_chosen_as_such() -> None:
    live = made(modes="wireframe,flat,phong", lobes="phong,blinn")
    assert (live.modes, live.lobes, live.frames) == (["wireframe", "flat", "phong"], ["phong", "blinn"], ["picture"])
    assert (live.mode, live.lobe) == ("wireframe", "phong")


def test_what_is_swept_is_a_picture_each() -> None:
    live = made(modes="gouraud,phong", sweep={"light": ["directional", "point"]})
    assert (live.modes, live.frames, live.apart) == (["gouraud", "phong"], ["directional", "point"], True)
    assert [moment["lights"][0]["values"]["position"][3] for moment in live.moments] == [0.0, 1.0]
    assert made(modes="phong", sweep={"shine": [1, 20]}).frames == ["shine = 1", "shine = 20"]
    both = made(modes="phong", sweep={"shine": [1, 20], "light": ["directional", "point"]})
    assert len(both.frames) == len(both.moments) == 4
    named = made(modes="phong", sweep={"light": ["directional", "point"]}, captions={"point": "a bulb"})
    assert named.frames == ["directional", "a bulb"]


def test_lobes_and_sides_that_modes_name_are_choices_of_their_own() -> None:
    live = made(modes="phong:phong,phong:blinn")
    assert (live.modes, live.lobes, live.lobe) == (["phong"], ["phong", "blinn"], "phong")
    live = made(modes="phong:clamp,phong:flip,phong:two-sided", lobes="blinn")
    assert (live.modes, live.lobes) == (["clamp", "flip", "two-sided"], ["blinn"])
    live = made(modes="flat:phong,phong:blinn")
    assert (live.modes, live.lobes) == (["flat:phong", "phong:blinn"], ["blinn"])


@pytest.mark.parametrize("modes", ["gouraud,native", "pyrender"])
def test_what_glsim_does_not_draw_cannot_be_live(modes: str, native: Any) -> None:
    with pytest.raises(ValueError, match=r"a live picture has the modes wireframe, .*phong, not"):
        sheet(modes=modes, lobes="blinn")


def test_the_sheet_is_the_same_and_is_the_still_picture() -> None:
    live, still = sheet(modes="flat,phong"), sheet(modes="flat,phong", live=None)
    contents, before = shown(live), shown(still)
    assert contents["image/png"] == before["image/png"]
    assert LIVE not in before
    assert "<glsim-live>" in contents[LIVE]
    assert "customElements" not in contents[LIVE]
    assert contents["text/html"].startswith("<iframe ")
    assert live.live is not None
    assert live.live.tape.width == 480  # alone it has more room


def test_show_takes_another_still_picture_and_a_point() -> None:
    still = Image.new("RGB", (40, 20), (9, 8, 7))
    figure = glsim.show(ball, size=32, still=still, point=(16, 16), controls="lights.position")
    assert figure.live.point == (16, 16)
    assert figure.live.poster.shape == (20, 40, 3)
    assert Image.open(io.BytesIO(figure._repr_png_())).size == (40, 20)
    plain = glsim.show(ball, size=32, samples=0)
    picture = np.asarray(Image.open(io.BytesIO(plain._repr_png_())))
    assert np.array_equal(picture, plain.live.poster)


def test_controls() -> None:
    assert controls_of("camera") == []
    assert controls_of("edges, lights.position,materials") == ["edges", "lights.position", "materials"]
    assert controls_of(["lights.spot", "lights.attenuation"]) == ["lights.spot", "lights.attenuation"]
    for wrong in ("lights.shininess", "materials.position", "sound", "lights.", "edges.position"):
        with pytest.raises(ValueError, match=r"controls of a live picture are mode, lobe, edges, .* not"):
            controls_of(wrong)
