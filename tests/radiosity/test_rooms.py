"""The museum and the factory, and what they are made of."""

from __future__ import annotations

import inspect

import numpy as np
import pytest

from glsim.radiosity.rays import Rays
from glsim.radiosity.rooms import paintings, surfaces
from glsim.radiosity.rooms.shapes import beam, block, pipe, reveal, stairs, turned, wall
from glsim.radiosity.scene import area_of, normal_of
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.textures import BLACKEST, Texture


def volume(polygons: list[np.ndarray]) -> float:
    """Of a closed body whose fronts look outwards."""
    fans = [p[[0, k, k + 1]] for p in polygons for k in range(1, len(p) - 1)]
    return float(sum(np.linalg.det(fan) for fan in fans)) / 6.0


@pytest.mark.parametrize(
    ("polygons", "expected"),
    [
        (beam((1, 2, 3), (1, 2, 8), 0.2, 0.3), 5.0 * 0.2 * 0.3),
        (beam((1, 2, 3), (1, 9, 3), 0.2, 0.3), 7.0 * 0.2 * 0.3),
        (block((0, 1, 2), (1, 3, 5), ""), 6.0),
        (pipe([(0, 0, 0), (4, 0, 0), (4, 3, 0), (4, 3, -5)], 0.5, 4, ends=True), 12.0 * 0.5),
        (turned((7, 0, 3), [(0.0, 0.0), (1.0, 0.5), (1.0, 2.0), (0.0, 2.6)], 4), 2.0 * (1.5 + 1.1 / 3.0)),
    ],
)
def test_bodies_look_outwards_and_are_closed(polygons: list[np.ndarray], expected: float) -> None:
    assert volume(polygons) == pytest.approx(expected, rel=1e-9)
    assert volume([np.add(polygon, (100.0, -50.0, 30.0)) for polygon in polygons]) == pytest.approx(expected, rel=1e-6)


def test_a_wall_with_openings() -> None:
    place, holes = ((0, 0, 4), (5, 0, 0), (0, 3, 0)), [(1.0, 0.0, 2.0, 2.0), (3.0, 1.0, 4.5, 2.0), (3.2, 2.2, 3.8, 2.8)]
    parts = wall(*place, holes)
    assert sum(map(area_of, parts)) == pytest.approx(15.0 - 2.0 - 1.5 - 0.36)
    assert all(normal_of(part)[2] == pytest.approx(1.0) for part in parts)
    sides = reveal(*place, 0.4, holes[0])
    middle = np.array((1.5, 1.0, 3.8))
    assert all(normal_of(side) @ (middle - side.mean(axis=0)) > 0.0 for side in sides)
    assert sum(map(area_of, sides)) == pytest.approx(0.4 * 6.0)


def test_stairs_go_up() -> None:
    treads, carriers = stairs((0, 0, 0), (3, 0, 0), 10, 1.0, 0.2)
    heights = [max(polygon[:, 1].max() for polygon in treads[k : k + 6]) for k in range(0, len(treads), 6)]
    np.testing.assert_allclose(np.diff(heights), 0.2)
    assert max(polygon[:, 1].max() for polygon in carriers) > 2.0
    assert min(polygon[:, 1].min() for polygon in carriers) >= 0.0


@pytest.mark.parametrize("name", ["museum", "factory"])
def test_a_room_is_closed(name: str) -> None:
    """From its fronts one sees fronts, but for what is inside of bodies; its cameras stand in the open."""
    room = BUILT_IN[name].make().checked()
    assert room.notes == ()
    assert len(room.polygons) < 1700
    rays, random = Rays(room), np.random.default_rng(3)
    for view in room.views:
        assert view.name
        direction = random.normal(size=(2000, 3))
        origins = np.repeat((np.array(view.eye) - rays.middle)[None].astype(np.float32), len(direction), axis=0)
        hit = rays.nearest(origins, direction, 0.0)
        assert (hit >= 0).mean() > 0.999
        assert (np.einsum("nk,nk->n", room.normals[hit], direction) < 0.0).mean() > 0.995


def test_textures_are_reflectances() -> None:
    made = [make() for module in (surfaces, paintings) for name, make in inspect.getmembers(module, inspect.isfunction)
            if make.__module__ == module.__name__ and not inspect.signature(make).parameters]  # fmt: skip
    assert len(made) == 11
    for texture in made:
        assert isinstance(texture, Texture)
        assert texture.texels.min() >= np.float32(BLACKEST)
        assert texture.texels.max() <= 0.95
        assert texture.texels.std() > 0.01
