"""The dining room that stands for other people's files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from glsim.radiosity.load import scene_from
from glsim.radiosity.scene import area_of
from tests.radiosity.dining import dining, things, write_dining


def volume(triangles: np.ndarray) -> float:
    """Of a closed body whose fronts look outwards; negative for inwards."""
    return float(np.einsum("nk,nk->n", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])).sum()) / 6.0


def test_the_room_is_what_it_says() -> None:
    parts = {thing.name: thing.triangles for thing in things()}
    assert 7500 < sum(map(len, parts.values())) < 8000
    assert volume(np.concatenate([parts["floor"], parts["walls"]])) == pytest.approx(-6.0 * 2.8 * 5.0)
    assert volume(parts["bulb 0"]) == pytest.approx(4.0 / 3.0 * np.pi * 0.055**3, rel=0.1)
    assert min(volume(parts[f"{name} 3"]) for name in ("plate", "bowl", "glass")) > 0.0


def test_its_file_is_the_same_room(tmp_path: Path) -> None:
    scene, read = dining().checked(), scene_from(write_dining(tmp_path)).checked()
    area, E = np.zeros((2, 1)), np.zeros((2, 3))
    for k, some in enumerate((scene, read)):
        for polygon, paint in zip(some.polygons, some.material, strict=True):
            area[k] += area_of(polygon)
            E[k] += area_of(polygon) * np.array(some.materials[paint].E)
    assert len(read.polygons) < 0.92 * len(scene.polygons)  # pairs of triangles became quads
    assert area[1] == pytest.approx(area[0], rel=1e-5)
    assert E[1] == pytest.approx(E[0], rel=1e-4)
