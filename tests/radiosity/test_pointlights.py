"""The same room by fixed function's equation, under direct illumination, and with light that bounces."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from glsim import radiosity
from glsim.cli import main
from glsim.radiosity.pointlights import ambient_of, lamps_of
from glsim.radiosity.scene import Builder, Material, Scene, View, box, quad
from glsim.radiosity.scenes import BUILT_IN, BuiltIn
from glsim.radiosity.subdivide import subdivide
from glsim.scenes import Camera
from glsim.study.compare import compare
from tests.radiosity.helpers import hall


def lamp_over_floor() -> Scene:
    """A lamp of 1 x 1 that emits 20, 3 above a floor; the camera is just below the lamp and looks down."""
    b = Builder("lamp")
    b.add([quad((-4, 0, -4), (-4, 0, 4), (4, 0, 4), (4, 0, -4))], Material("floor", (0.5, 0.4, 0.3)))
    b.add(
        [quad((-0.5, 3, -0.5), (0.5, 3, -0.5), (0.5, 3, 0.5), (-0.5, 3, 0.5))],
        Material("lamp", (0.0,) * 3, (20.0,) * 3),
    )
    return b.scene(View((0.0, 2.9, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, -1.0), 20.0))


def test_a_lamp_as_opengls_light_is_a_disc() -> None:
    """In the middle of the picture the light model gives rho E A / (A + pi h^2), and the ambient term."""
    scene = lamp_over_floor()
    result = radiosity.solve(scene, 400)
    arriving = 20.0 / (1.0 + np.pi * 9.0) + ambient_of(result)
    expected = np.minimum(np.array([0.5, 0.4, 0.3]) * arriving / result.shown_white, 1.0)
    assert 0.2 < expected.min() < 0.9
    picture = compare(scene, modes=("gouraud", "phong"), size=65, patches=400).images
    for mode, most in (("phong", 1.0), ("gouraud", 4.0)):  # between vertices there are chords
        assert picture["diffuse", mode][32, 32] == pytest.approx(255.0 * expected ** (1 / 2.2), abs=most)


def test_what_shadows_and_bounces_add() -> None:
    found = compare("cornell", modes=("gouraud", "direct", "radiosity"), size=128, patches=600)
    light = {mode: (picture / 255.0) ** 2.2 for (_, mode), picture in found.images.items()}
    assert set(light) == {"gouraud", "direct", "radiosity"}
    assert (light["direct"] <= light["radiosity"] + 0.01).all()
    ceiling, block = (slice(8, 14), slice(40, 50)), (slice(90, 115), slice(66, 90))
    assert light["direct"][ceiling].max() < 0.01 < light["radiosity"][ceiling].min()
    assert light["direct"][block].mean() < 0.01 < 0.1 < light["gouraud"][block].mean()  # no shadows in fixed function
    # the ambient term makes up for what bounces, in the mean
    assert light["gouraud"].mean() == pytest.approx(light["radiosity"].mean(), rel=0.35)


def test_the_drivers_own_light_agrees(native: object) -> None:
    found = compare("plates", modes=("gouraud", "native"), size=96, patches=60)
    assert found.reference == "native"
    assert found.difference("diffuse", "gouraud").max() <= 60  # one step in the dark is many after gamma
    assert found.difference("diffuse", "gouraud").mean() < 1.0


def test_many_lamps_are_gathered_by_material() -> None:
    b = Builder("lamps")
    b.add(box((0, 0, 0), (10, 3, 10), inside=True), Material("wall", (0.5,) * 3))
    for x in range(9):
        b.add(
            [quad((x, 2.9, 4), (x + 0.5, 2.9, 4), (x + 0.5, 2.9, 5), (x, 2.9, 5))],
            Material("tube", (0.0,) * 3, (2.0,) * 3),
        )
    b.add(box((4, 1, 1), (5, 2, 2)), Material("bulb", (0.0,) * 3, (1.0, 3.0, 1.0)))
    patches = subdivide(b.scene().checked(), 300)
    one, other = sorted(lamps_of(patches), key=lambda lamp: lamp.area)
    assert one.area == pytest.approx(4.5)
    assert one.direction == pytest.approx([0.0, -1.0, 0.0])
    assert other.direction is None  # a closed body shines all around
    assert other.at == pytest.approx([4.5, 1.5, 1.5])
    assert other.area == pytest.approx(6.0)


def test_of_too_many_lamps_none_loses_its_power() -> None:
    b = Builder("lamps")
    b.add(box((0, 0, 0), (10, 3, 10), inside=True), Material("wall", (0.5,) * 3))
    for x in range(10):
        lamp = Material(f"lamp {x}", (0.0,) * 3, (1.0 + x, 2.0, 0.0))
        b.add([quad((x, 2.9, 4), (x + 0.5, 2.9, 4), (x + 0.5, 2.9, 5), (x, 2.9, 5))], lamp)
    lamps = lamps_of(subdivide(b.scene().checked(), 300))
    assert len(lamps) == 8
    power = sum(lamp.area * lamp.E for lamp in lamps)
    assert power == pytest.approx([0.5 * sum(1.0 + x for x in range(10)), 10.0, 0.0])


def test_ambient_in_a_furnace() -> None:
    """B = 2 everywhere, of which E = 1 is emitted, 0.5 reflected once: the rest has bounced more than once."""
    result = radiosity.solve("furnace", 100)
    assert ambient_of(result) == pytest.approx(1.0, rel=1e-3)


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(BUILT_IN, "hall", BuiltIn("two cameras", hall))
    out = tmp_path / "two.png"
    words = ["compare", "hall", "--modes", "gouraud,radiosity", "--size", "64", "--patches", "300", "--view", "1"]
    assert main([*words, "-o", str(out), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [row["mode"] for row in told["differences"]] == ["gouraud", "radiosity"]
    assert out.exists()


def test_what_cannot_be_compared(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(ValueError, match="the scene has its own lamps, materials and cameras: use --view"):
        compare("cornell", camera=Camera())
    assert main(["compare", "teapot", "--modes", "gouraud,radiosity"]) == 1
    assert "the built-in scenes are" in capsys.readouterr().err
    assert main(["compare", "plates", "--modes", "radiosity", "--patches", "20", "--view", "3"]) == 1
    assert "plates has 1 view, numbered from 0; there is no 3" in capsys.readouterr().err
