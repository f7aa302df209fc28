"""Who sees whom: rays, and the bodies that save most of them."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

from glsim import radiosity
from glsim.radiosity import rays
from glsim.radiosity.methods import compute
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Builder, Material, Scene, box, normal_of, quad
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.solution import _compiled
from glsim.radiosity.subdivide import subdivide
from glsim.radiosity.visibility import Visibility
from tests.radiosity.helpers import hall


@pytest.mark.parametrize("make", [BUILT_IN["cornell"].make, hall])
def test_what_bodies_tell_agrees_with_rays(make: Callable[[], Scene]) -> None:
    """Weighted by form factors: rays that graze a wall may be wrong where hardly any light goes."""
    parts = subdivide(make().checked(), 450)
    S = compute(parts, "analytic").S
    i, j = np.nonzero(np.triu(S))
    arrays = parts, np.stack([i, j], axis=1)
    with_bodies, rays_alone = Visibility(Rays(parts.scene)), Visibility(Rays(parts.scene))
    rays_alone.bodies = None
    share, asked = with_bodies.fractions_and_undecided(*arrays)
    everywhere, all_asked = rays_alone.fractions_and_undecided(*arrays)
    assert len(asked) < len(all_asked) == len(i)
    sure = np.setdiff1d(np.arange(len(i)), asked)
    assert set(np.unique(share[sure])) == {0.0, 1.0}
    assert np.array_equal(share[asked], everywhere[asked])
    assert (S[i, j] * np.abs(share - everywhere)).sum() < 1e-5 * S[i, j].sum()


def test_a_thin_wall_blocks() -> None:
    """Alone in a room, with one face or two: as thin as can be."""
    for faces in (1, 2):
        b = Builder("wall")
        b.add(box((0, 0, 0), (2, 2, 2), inside=True), Material("room", (0.5,) * 3, (1.0,) * 3))
        screen = quad((1, 0, 0), (1, 2, 0), (1, 2, 2), (1, 0, 2))
        b.add([screen, screen[::-1]][:faces], Material("screen", (0.5,) * 3))
        parts = subdivide(b.scene().checked(), 200)
        S = compute(parts).S
        left, right = (np.flatnonzero((side * (parts.center[:, 0] - 1.0)) > 0.01) for side in (1.0, -1.0))
        assert S[np.ix_(left, right)].sum() < 5e-6 * S[np.ix_(left, left)].sum()  # a ray may end just before it


@pytest.mark.parametrize("height", [0.001, 0.02, 0.3, 1.0])
@pytest.mark.parametrize("thickness", [0.0, 1e-4, 5e-4, 0.01])
def test_what_stands_free_is_seen(height: float, thickness: float) -> None:
    """A lamp below the ceiling, a sheet or a thin box: it lights the room, and its rows sum to 1."""
    b = Builder("room")
    b.add(box((-1, 0, -1), (1, 2, 1), inside=True), Material("wall", (0.7,) * 3))
    top, lamp = 2.0 - height, Material("lamp", (0.0,) * 3, (20.0,) * 3)
    b.add([quad((-0.3, top, -0.3), (0.3, top, -0.3), (0.3, top, 0.3), (-0.3, top, 0.3))], lamp)
    if thickness:
        body = box((-0.3, top, -0.3), (0.3, top + thickness, 0.3))
        b.add([face for face in body if abs(normal_of(face)[1] + 1.0) > 1e-9], Material("shade", (0.2,) * 3))
    result = radiosity.solve(b.scene(), 300)
    shines = result.patches.E.max(axis=1) > 0.0
    assert normal_of(result.patches.scene.polygons[6])[1] == -1.0
    assert result.factors.row_sums[shines] == pytest.approx(1.0, abs=0.01)
    assert result.B[~shines].max() > 0.5


def test_a_sheet_has_two_sides() -> None:
    """Two rooms with a wall between them, red on one side, blue on the other: nothing gets through, nothing is lost."""
    b = Builder("rooms")
    for x, name, rho in ((0.0, "red", (0.7, 0.1, 0.1)), (1.0, "blue", (0.1, 0.1, 0.7))):
        left, right, *rest = box((x, 0, 0), (x + 1, 1, 1), inside=True)
        wall, outer = (right, left) if name == "red" else (left, right)
        b.add([wall], Material(name, rho))
        b.add([outer, *rest], Material(f"room {name}", (0.5,) * 3, (1.0, 1.0, 1.0) if name == "red" else (0.0,) * 3))
    result = radiosity.solve(b.scene(), 400)
    assert result.patches.area.sum() == pytest.approx(12.0)
    assert result.factors.row_sums == pytest.approx(1.0, abs=5e-3)
    assert result.B[result.patches.center[:, 0] > 1.0 + 1e-9].max() < 1e-3
    assert result.report()["notes"] == []


@pytest.mark.parametrize(
    "more", [{}, {"adaptive": True}, {"method": "hierarchical"}, {"method": "point"}, {"method": "hemicube"}]
)
def test_a_solution_has_one_object_for_its_rays(more: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """One pool with the threads asked for, and three Embree trees: the scene, and moved a little to either side."""
    _compiled(more.get("method") == "hierarchical")
    pools: list[int] = []
    trees: list[int] = []

    def pool(threads: int) -> ThreadPoolExecutor:
        pools.append(threads)
        return ThreadPoolExecutor(threads)

    def tree(triangles: np.ndarray) -> Any:
        trees.append(len(triangles))
        return built(triangles)

    built = rays._tree
    monkeypatch.setattr(rays, "ThreadPoolExecutor", pool)
    monkeypatch.setattr(rays, "_tree", tree)
    result = radiosity.solve("cornell", 120, threads=1, **more)
    result.direct()
    assert pools == [1]
    assert trees == 3 * [len(result.patches.scene.triangles())]
