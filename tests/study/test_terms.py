"""glsim.terms: the summands add up to the picture."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.gl import *
from glsim.play.capture import capture
from glsim.play.reshade import shaded
from tests.oracle import PROGRAMS


@pytest.mark.parametrize("mode", ["flat", "gouraud", "phong"])
@pytest.mark.parametrize("scene", ["teapot", "spheres", "torus"])
def test_the_sum_is_the_picture_where_nothing_is_clamped(scene: str, mode: str) -> None:
    frame = shaded(glsim.frame_of(scene, size=160), mode, "blinn")
    terms = glsim.terms(frame)
    free = terms.lit & ~terms.clamped
    assert free.sum() > 3000
    assert np.abs(terms.sum[free] * 255.0 - terms.picture[free][:, :3]).max() <= 1.0
    assert terms.clamped.any() or scene == "torus"
    over = terms.sum[terms.clamped] * 255.0 - terms.picture[terms.clamped][:, :3]
    assert (over.max(axis=1) > 0.0).all()
    of_lights = [f"light {k} {name}" for k in (0, 1) for name in ("ambient", "diffuse", "specular")]
    assert set(terms.summands) == {"emission", "scene ambient", *of_lights}
    assert terms.lights == [0, 1]


LIT = [name for name in PROGRAMS if name.startswith(("light_", "term_", "material_", "two_sid", "color_material"))]
assert len(LIT) >= 36


@pytest.mark.parametrize("name", LIT)
def test_lit_programs(name: str, screen: glsim.Offscreen) -> None:
    with capture() as frame:
        PROGRAMS[name]()
    terms = glsim.terms(frame)
    assert np.array_equal(terms.picture, screen.pixels())
    assert np.array_equal(terms.depth, screen.depth())
    drawn = terms.picture[..., 3] > 0
    assert drawn.sum() > 4000
    assert np.array_equal(terms.covered, drawn)
    free = terms.lit & ~terms.clamped
    assert free.sum() >= 300
    if "separate" not in name and "texture" not in name:
        assert np.abs(terms.sum[free] * 255.0 - terms.picture[free][:, :3]).max() <= 1.0


def test_cosines_and_normals(screen: glsim.Offscreen) -> None:
    """A quad that faces the eye, lit from 60 degrees."""
    with capture() as frame:
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT3)
        glLightfv(GL_LIGHT3, GL_POSITION, [3**0.5, 0, 1, 0])
        glNormal3f(0, 0, 1)
        glRectf(-0.5, -0.5, 0.5, 0.5)
        glDisable(GL_LIGHTING)
        glColor3f(0.2, 0.4, 0.6)
        glRectf(0.6, 0.6, 0.9, 0.9)
    terms = glsim.terms(frame)
    assert terms.N_L[3][64, 64] == pytest.approx(0.5)
    assert terms.cosine[3][64, 64] == pytest.approx(np.cos(np.radians(30)))
    assert terms.normal[64, 64] == pytest.approx([0, 0, 1])
    assert terms.summands["unlit"][16, 112] == pytest.approx([0.2, 0.4, 0.6])
    assert not terms.lit[16, 112]
    assert terms.covered[16, 112]
    assert not terms.covered[2, 2]
    assert terms.statistics()["pixels"] == int(terms.covered.sum())


def test_a_picture_without_fragments(screen: glsim.Offscreen) -> None:
    with capture() as frame:
        glClear(GL_COLOR_BUFFER_BIT)
    terms = glsim.terms(frame)
    assert not terms.covered.any()
    assert not terms.sum.any()
    assert terms.sheet.size[0] > 0


def test_the_sheet(tmp_path: Path) -> None:
    terms = glsim.terms("sphere", size=64)
    terms.save(tmp_path / "terms.png")
    with Image.open(tmp_path / "terms.png") as sheet:
        assert sheet.size[0] > 5 * 256
        assert len(sheet.convert("RGB").getcolors(1 << 22)) > 500
    with pytest.raises(ValueError, match="extension"):
        terms.save(tmp_path / "terms.nothing")
    assert not list(tmp_path.glob("*nothing*"))
