"""Form factors against closed forms, Monte Carlo and each other."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from glsim.radiosity.formfactors import FormFactors
from glsim.radiosity.methods import compute
from glsim.radiosity.patches import patches_of
from glsim.radiosity.polygon import area, lambert
from glsim.radiosity.progress import silent
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Builder, Material, Scene, box
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.solvers import solved
from glsim.radiosity.subdivide import subdivide
from glsim.radiosity.textbook import monte_carlo
from tests.radiosity.helpers import CASES, disc, form_factor, room


@pytest.mark.parametrize("case", CASES["polygon_pairs"], ids=lambda case: case["name"])
def test_polygon_pairs(case: dict[str, Any]) -> None:
    assert form_factor(case["poly1"], case["poly2"]) == pytest.approx(case["F12"], rel=1e-6)
    assert form_factor(case["poly2"], case["poly1"]) * area(np.array(case["poly2"], float), 4) == pytest.approx(
        case["F12"] * area(np.array(case["poly1"], float), 4), rel=1e-6
    )


@pytest.mark.parametrize("case", CASES["discs"], ids=lambda case: f"{case['r1']}-{case['r2']}-{case['distance']}")
def test_discs(case: dict[str, Any]) -> None:
    found = form_factor(disc(case["r1"], 0.0, True), disc(case["r2"], case["distance"], False))
    assert found == pytest.approx(case["F12"], rel=1e-4)


def test_from_a_point() -> None:
    corner = [case for case in CASES["point_to_polygon"] if "corner of parallel" in case["name"]]
    for case in corner:
        a, b, c = case["a"], case["b"], case["c"]
        polygon = np.array([(0, 0, c), (0, b, c), (a, b, c), (a, 0, c)], float)
        assert lambert(np.zeros(3), np.array([0.0, 0, 1]), polygon, 4) == pytest.approx(case["F"], rel=1e-12)
    polygon = disc(1.0, 1.0, False)
    assert lambert(np.zeros(3), np.array([0.0, 0, 1]), polygon, len(polygon)) == pytest.approx(0.5, rel=1e-4)


@pytest.mark.parametrize("case", ["box_1x2x3", "cube_one_emitter"])
def test_boxes_with_one_patch_for_each_wall(case: str) -> None:
    given_ = CASES[case]
    order = ["x0", "x1", "y0", "y1", "z0", "z1"]  # as scene.box makes them
    at = [given_["faces"].index(name) for name in order]
    rho, E = (np.atleast_2d(np.array(given_[name], float)) for name in ("rho", "E"))
    rho, E = (values if values.shape[0] == 6 else values.T for values in (rho, E))
    spread = [np.broadcast_to(values, (6, 3)) if values.shape[1] in (1, 3) else values for values in (rho, E)]
    materials = [
        Material(f"m{k}", tuple(spread[0][k].tolist()), tuple(spread[1][k].tolist()))
        for k in at
    ]  # fmt: skip
    scene = room(tuple(map(float, given_["size"])), materials).checked()
    parts = patches_of(scene, list(scene.polygons), list(range(6)))
    factors = compute(parts, exact=True)
    assert pytest.approx(np.array(given_["F"])[np.ix_(at, at)], rel=1e-6, abs=1e-9) == factors.F
    B = solved(factors, "lu")[-1].B
    expected = np.atleast_2d(np.array(given_["B"], float))
    expected = np.broadcast_to(expected if expected.shape[0] == 6 else expected.T, (6, 3))
    assert pytest.approx(expected[at], rel=1e-5) == B


@pytest.mark.parametrize("case", CASES["furnace"], ids=lambda case: str(case["rho"]))
def test_furnace(case: dict[str, float]) -> None:
    """Every wall of a closed room emits and reflects alike: B = E / (1 - rho)."""
    rho, E = case["rho"], case["E"]
    scene = room((1, 2, 3), [Material("wall", (rho,) * 3, (E,) * 3)] * 6).checked()
    factors = compute(subdivide(scene, 150), exact=True).closed()
    B = solved(factors, tolerance=1e-9, most=5000)[-1].B
    assert pytest.approx(np.full(B.shape, case["B"]), rel=2e-4) == B


def test_reciprocity_and_rows(closed: FormFactors) -> None:
    assert np.array_equal(closed.S, closed.S.T)
    error = np.abs(closed.row_sums - 1.0)
    assert error.mean() < 6e-4
    assert error.max() < 0.01
    assert np.abs(closed.closed().row_sums - 1.0).max() < 1e-5


def turned(scene: Scene, scale: float = 1.0) -> Scene:
    turn, _ = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    return replace(scene, polygons=tuple(scale * polygon @ turn.T + (3.0, -2.0, 7.0) for polygon in scene.polygons))


@pytest.mark.parametrize("scale", [1.0, 0.01, 1000.0])
def test_nothing_changes_when_the_scene_is_moved_turned_or_scaled(scale: float) -> None:
    scene = BUILT_IN["goral"].make().checked()
    one, two = (compute(subdivide(s, 150), exact=True) for s in (scene, turned(scene, scale)))
    assert pytest.approx(one.F, rel=1e-5, abs=1e-9) == two.F


def test_nothing_changes_far_from_the_origin() -> None:
    """Rays have single precision: at a million, a unit cube would have corners of a sixteenth."""
    scene = BUILT_IN["cornell"].make().checked()
    away = replace(scene, polygons=tuple(polygon / 500.0 + (1e6, -2e6, 3e6) for polygon in scene.polygons)).checked()
    one, two = (compute(subdivide(s, 150)) for s in (scene, away))
    assert len(one.patches) == len(two.patches)
    assert pytest.approx(one.F, abs=2e-3) == two.F
    assert two.row_sums == pytest.approx(one.row_sums, abs=2e-3)


def test_a_sphere_from_inside() -> None:
    """F_ij = A_j / (4 pi R^2) wherever two patches are: with many flat patches nearly, with round ones exactly."""
    import trimesh

    b = Builder("sphere")
    lamp, wall = Material("lamp", (0.5,) * 3, (10.0, 5.0, 0.0)), Material("wall", (0.5, 0.7, 0.9))
    for polygon in trimesh.creation.icosphere(3, radius=2.0).triangles:
        b.add([polygon[::-1]], lamp if polygon[:, 1].min() > 1.0 else wall)
    parts = subdivide(b.scene().checked(), length=100.0)
    factors = compute(parts)
    assert len(parts) == 1280
    expected = np.tile(parts.area / parts.area.sum(), (len(parts), 1))
    apart = np.linalg.norm(parts.center[:, None] - parts.center, axis=2) > 1.0
    assert np.abs(factors.F[apart] / expected[apart] - 1.0).mean() < 0.02
    B = solved(factors)[-1].B
    H = (parts.area @ parts.E) / (parts.area.sum() - parts.area @ parts.rho)
    assert pytest.approx(parts.E + parts.rho * H, rel=0.01) == B


def test_threads_do_not_change_the_result() -> None:
    parts = subdivide(BUILT_IN["cornell"].make().checked(), 300)
    assert np.array_equal(compute(parts, rays=Rays(parts.scene, 1)).S, compute(parts, rays=Rays(parts.scene, 3)).S)


@pytest.mark.slow
def test_blocked_pairs_against_monte_carlo() -> None:
    parts = subdivide(BUILT_IN["cornell"].make().checked(), 60)
    ours = compute(parts)
    free = compute(parts, "analytic").S
    S, error = monte_carlo(parts, ours.visibility.rays, 3000, 1, silent)
    own = 0.06 * free  # where a pair is partly hidden, 16 rays, or 64, are off by half of 1 / sqrt(64)
    sure = error > 0
    apart = np.linalg.norm(parts.center[:, None] - parts.center, axis=2)
    sure &= apart > parts.size[:, None] + parts.size  # near ones have errors without a variance
    deviations = np.abs(ours.S - S)[sure] / np.hypot(error, own)[sure]
    assert np.median(deviations) < 0.5
    assert np.quantile(deviations, 0.99) < 3
    far = apart > parts.size[:, None] + parts.size
    assert ours.S[far].sum() == pytest.approx(S[far].sum(), rel=5e-3)


@settings(max_examples=12, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.integers(0, 2**32 - 1))
def test_random_rooms_with_random_blocks(seed: int) -> None:
    """Rows of any closed room sum to 1."""
    rng = np.random.default_rng(seed)
    size = rng.uniform(1, 3, 3)
    b = Builder("random")
    b.add(box((0, 0, 0), size.tolist(), inside=True), Material("wall", (0.6,) * 3, (1.0,) * 3))
    low = size * rng.uniform(0.15, 0.4, 3) * (1, rng.integers(0, 2), 1)  # on the floor, or in the air
    high = low + size * rng.uniform(0.1, 0.4, 3)
    b.add(box(low.tolist(), high.tolist()), Material("block", (0.3,) * 3))
    factors = compute(subdivide(b.scene().checked(), 250))
    error = np.abs(factors.row_sums - 1.0)
    assert np.average(error, weights=factors.patches.area) < 2e-3
