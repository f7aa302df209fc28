"""What cannot be solved is refused with a sentence."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from glsim import radiosity
from glsim.radiosity.scene import Builder, Material, SceneError, quad
from glsim.radiosity.scenes import BUILT_IN

SQUARE = quad((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))


GREY, LAMP = Material("grey", (0.5,) * 3), Material("lamp", (0.0,) * 3, (1.0,) * 3)


@pytest.mark.parametrize(
    ("polygons", "material", "sentence"),
    [
        ([SQUARE], Material("mirror", (1.0, 0.5, 0.5)), "less than 1, or light never ends"),
        ([SQUARE], Material("hole", (-0.1, 0.5, 0.5)), "at least 0"),
        ([SQUARE], Material("odd", (float("nan"), 0.5, 0.5)), "finite numbers"),
        ([SQUARE], Material("sink", (0.5,) * 3, (-1.0, 0.0, 0.0)), "must not be negative"),
        ([SQUARE], GREY, "nothing emits light"),
        ([SQUARE * np.nan], LAMP, "coordinates that are not finite"),
        ([SQUARE * 0.0], LAMP, "degenerate"),
        ([], LAMP, "no polygon"),
    ],
)
def test_bad_scenes(polygons: list[np.ndarray], material: Material, sentence: str) -> None:
    b = Builder("bad")
    b.add(polygons, material)
    with pytest.raises(SceneError, match=sentence):
        replace(b.scene(), materials=(material,)).checked()


@pytest.mark.slow
def test_a_room_inside_out() -> None:
    scene = replace(BUILT_IN["goral"].make().flipped(), name="inverted")
    with pytest.raises(SceneError, match="are the normals inverted"):
        radiosity.solve(scene, 60)
    assert radiosity.solve(scene, 60, flip=True).report()["row_sum_error_mean"] < 0.01


def test_what_can_be_mended_is_noted() -> None:
    b = Builder("mended")
    twisted = quad((0, 0, 1), (1, 0, 1), (1, 1, 1.3), (0, 1, 1))
    b.add([SQUARE, SQUARE, SQUARE * (1, 0, 0), twisted], LAMP)
    scene = b.scene().checked()
    assert len(scene.polygons) == 3
    assert sorted(scene.notes) == [
        "degenerate polygons, dropped: 1",
        "duplicate polygons, dropped: 1",
        "polygons that were not planar, split into triangles: 1",
    ]


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: radiosity.solve(3), "a scene is a radiosity.Scene .of a Builder: builder.scene.... a name"),
        (lambda: radiosity.solve(Builder("b")), "a scene is a radiosity.Scene"),
        (lambda: radiosity.solve("."), "is a folder; name a mesh file"),
        (lambda: radiosity.solve("goral", 0), "patches must be a whole number from 1 on, not 0"),
        (lambda: radiosity.solve("goral", "20"), "patches must be a whole number from 1 on, not '20'"),
        (lambda: radiosity.solve("goral", 20, threads=-2), "threads must be a whole number from 1 on, not -2"),
        (
            lambda: radiosity.solve("goral", 20, tolerance=float("nan")),
            "the tolerance must be a number between 0 and 1",
        ),
        (lambda: radiosity.solve("goral", 20, accuracy=-1.0), "the accuracy must be a number between 0 and 1"),
        (lambda: Builder("b").add(SQUARE, LAMP), "add takes a list of polygons, each a list of corners"),
        (lambda: Builder("b").add([[(0, 0), (1, 0), (1, 1)]], LAMP), "add takes a list of polygons"),
    ],
)
def test_wrong_arguments(call: Any, sentence: str) -> None:
    with pytest.raises(SceneError, match=sentence):
        call()
