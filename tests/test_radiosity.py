"""Radiosity against its witnesses: closed forms, energy, Monte Carlo, and a path-traced reference."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

pytest.importorskip("numba")
pytest.importorskip("embreex")

from glsim import radiosity
from glsim.radiosity import kernels
from glsim.radiosity.bake import averaged, gathered, radiosity_at, toned, unevenness
from glsim.radiosity.formfactors import METHODS, FormFactors, compute
from glsim.radiosity.hemicube import delta_form_factors, hemicube
from glsim.radiosity.load import scene_from
from glsim.radiosity.mesh import mesh_of
from glsim.radiosity.patches import Patches, patches_of, subdivide
from glsim.radiosity.scene import Builder, Material, Scene, SceneError, box, normal_of, quad
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.solvers import SOLVERS, System, solved
from glsim.radiosity.textbook import monte_carlo
from glsim.radiosity.visibility import Visibility

ENVIRONMENT = {**os.environ, "PYTHONPATH": str(Path(__file__).parent.parent)}
REFERENCE = Path(__file__).parent / "reference"
CASES = json.loads((REFERENCE / "analytic_cases.json").read_text())


def form_factor(one: Any, two: Any, exact: bool = True) -> float:
    """F from polygon one to polygon two."""
    rings = [np.array(ring, float) for ring in (one, two)]
    normals = [normal_of(ring) for ring in rings]
    centers = [ring.mean(axis=0) for ring in rings]
    sizes = [
        2 * float(np.linalg.norm(ring - center, axis=1).max()) for ring, center in zip(rings, centers, strict=True)
    ]
    work = np.empty((6, 3)), np.empty((6, 3))
    S = kernels.pair(
        rings[0], len(rings[0]), normals[0], rings[1], len(rings[1]), normals[1], centers[0], centers[1], sizes[0],
        sizes[1], exact, *work,
    )  # fmt: skip
    return S / kernels._area(rings[0], len(rings[0]))


# ---------------------------------------------------------------- closed forms


@pytest.mark.parametrize("case", CASES["polygon_pairs"], ids=lambda case: case["name"])
def test_polygon_pairs(case: dict[str, Any]) -> None:
    assert form_factor(case["poly1"], case["poly2"]) == pytest.approx(case["F12"], rel=1e-6)
    assert form_factor(case["poly2"], case["poly1"]) * kernels._area(
        np.array(case["poly2"], float), 4
    ) == pytest.approx(case["F12"] * kernels._area(np.array(case["poly1"], float), 4), rel=1e-6)


def disc(radius: float, z: float, up: bool, corners: int = 400) -> np.ndarray:
    """A polygon with the disc's area."""
    angle = np.arange(corners) * 2 * np.pi / corners
    r = radius * np.sqrt(2 * np.pi / (corners * np.sin(2 * np.pi / corners)))
    ring = np.stack([r * np.cos(angle), r * np.sin(angle), 0 * angle + z], axis=1)
    return ring if up else ring[::-1]


@pytest.mark.parametrize("case", CASES["discs"], ids=lambda case: f"{case['r1']}-{case['r2']}-{case['distance']}")
def test_discs(case: dict[str, Any]) -> None:
    found = form_factor(disc(case["r1"], 0.0, True), disc(case["r2"], case["distance"], False))
    assert found == pytest.approx(case["F12"], rel=1e-4)


def test_from_a_point() -> None:
    corner = [case for case in CASES["point_to_polygon"] if "corner of parallel" in case["name"]]
    for case in corner:
        a, b, c = case["a"], case["b"], case["c"]
        ring = np.array([(0, 0, c), (0, b, c), (a, b, c), (a, 0, c)], float)
        assert kernels.lambert(np.zeros(3), np.array([0.0, 0, 1]), ring, 4) == pytest.approx(case["F"], rel=1e-12)
    ring = disc(1.0, 1.0, False)
    assert kernels.lambert(np.zeros(3), np.array([0.0, 0, 1]), ring, len(ring)) == pytest.approx(0.5, rel=1e-4)


def room(size: tuple[float, float, float], materials: list[Material]) -> Scene:
    b = Builder("room")
    for ring, material in zip(box((0, 0, 0), size, inside=True), materials, strict=True):
        b.add([ring], material)
    return b.scene()


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
    parts = patches_of(scene, list(scene.rings), list(range(6)))
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


# ---------------------------------------------------------------- laws


@pytest.fixture(scope="module")
def closed() -> FormFactors:
    return compute(subdivide(BUILT_IN["cornell-closed"].make().checked(), 900))


def test_reciprocity_and_rows(closed: FormFactors) -> None:
    assert np.array_equal(closed.S, closed.S.T)
    error = np.abs(closed.row_sums - 1.0)
    assert error.mean() < 6e-4
    assert error.max() < 0.01
    assert np.abs(closed.closed().row_sums - 1.0).max() < 1e-5


def test_energy_balance_and_linearity(closed: FormFactors) -> None:
    steps = solved(closed, "cg", tolerance=1e-7)
    assert steps[-1].balance == pytest.approx(1.0, abs=1e-5)
    p = closed.patches
    absorbed = (p.area[:, None] * (1 - p.rho) / np.maximum(p.rho, 1e-12) * (steps[-1].B - p.E)).sum()
    leak = ((1.0 - closed.row_sums) * p.area) @ steps[-1].B
    assert absorbed + leak.sum() == pytest.approx((p.area[:, None] * p.E).sum(), rel=1e-4)
    system = System.of(closed)
    doubled = replace(system, E=2.0 * system.E)
    twice = next(SOLVERS["lu"](doubled)).B
    assert twice == pytest.approx(2.0 * next(SOLVERS["lu"](system)).B, rel=1e-9)


@pytest.mark.parametrize("solver", SOLVERS)
def test_solvers_agree(solver: str, closed: FormFactors) -> None:
    exact = solved(closed, "lu")[-1].B
    steps = solved(closed, solver, tolerance=1e-6)
    assert np.abs(steps[-1].B - exact).max() < 3e-5 * exact.max()
    residuals = [step.residual for step in steps]
    assert residuals[-1] <= 1e-6
    assert solver == "lu" or residuals[-1] < residuals[0]


def test_jacobis_iterations_are_bounces(closed: FormFactors) -> None:
    system = System.of(closed)
    steps = SOLVERS["jacobi"](system)
    first, second = next(steps).B, next(steps).B
    assert np.array_equal(first, system.E)
    assert second == pytest.approx(system.E + system.rho * (closed.F @ system.E), rel=1e-4, abs=1e-6)


def test_a_solver_does_not_pretend(closed: FormFactors) -> None:
    with pytest.raises(SceneError, match="did not converge: after 2 iterations"):
        solved(closed, "jacobi", most=2)
    with pytest.raises(SceneError, match="the solvers are"):
        solved(closed, "magic")


def turned(scene: Scene, scale: float = 1.0) -> Scene:
    turn, _ = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    return replace(scene, rings=tuple(scale * ring @ turn.T + (3.0, -2.0, 7.0) for ring in scene.rings))


@pytest.mark.parametrize("scale", [1.0, 0.01, 1000.0])
def test_nothing_changes_when_the_scene_is_moved_turned_or_scaled(scale: float) -> None:
    scene = BUILT_IN["goral"].make().checked()
    one, two = (compute(subdivide(s, 150), exact=True) for s in (scene, turned(scene, scale)))
    assert pytest.approx(one.F, rel=1e-5, abs=1e-9) == two.F


def test_nothing_changes_far_from_the_origin() -> None:
    """Rays have single precision: at a million, a unit cube would have corners of a sixteenth."""
    scene = BUILT_IN["cornell"].make().checked()
    away = replace(scene, rings=tuple(ring / 500.0 + (1e6, -2e6, 3e6) for ring in scene.rings)).checked()
    one, two = (compute(subdivide(s, 150)) for s in (scene, away))
    assert len(one.patches) == len(two.patches)
    assert pytest.approx(one.F, abs=2e-3) == two.F
    assert two.row_sums == pytest.approx(one.row_sums, abs=2e-3)


def test_a_sphere_from_inside() -> None:
    """F_ij = A_j / (4 pi R^2) wherever two patches are: with many flat patches nearly, with round ones exactly."""
    import trimesh

    b = Builder("sphere")
    lamp, wall = Material("lamp", (0.5,) * 3, (10.0, 5.0, 0.0)), Material("wall", (0.5, 0.7, 0.9))
    for ring in trimesh.creation.icosphere(3, radius=2.0).triangles:
        b.add([ring[::-1]], lamp if ring[:, 1].min() > 1.0 else wall)
    parts = subdivide(b.scene().checked(), length=100.0)
    factors = compute(parts)
    assert len(parts) == 1280
    expected = np.tile(parts.area / parts.area.sum(), (len(parts), 1))
    apart = np.linalg.norm(parts.center[:, None] - parts.center, axis=2) > 1.0
    assert np.abs(factors.F[apart] / expected[apart] - 1.0).mean() < 0.02
    B = solved(factors)[-1].B
    H = (parts.area @ parts.E) / (parts.area.sum() - parts.area @ parts.rho)
    assert pytest.approx(parts.E + parts.rho * H, rel=0.01) == B


@pytest.mark.parametrize("solver", SOLVERS)
def test_round_patches_of_a_sphere(solver: str) -> None:
    """The closed solution of analytic_cases.json, by every solver; a round patch also sees itself."""
    case = CASES["sphere"]["example"]
    area, E, rho = (np.array(case[name], float) for name in ("areas", "E", "rho"))
    S = (area[:, None] * area / area.sum()).astype(np.float32)
    for step in SOLVERS[solver](System(lambda B: S.astype(float) @ B, area, rho, E, S)):
        if step.residual < 1e-9 or step.iteration > 2000:
            break
    assert pytest.approx(np.array(case["B"]), rel=1e-5) == step.B
    assert step.balance == pytest.approx(1.0, abs=1e-6)


def test_threads_do_not_change_the_result() -> None:
    parts = subdivide(BUILT_IN["cornell"].make().checked(), 300)
    assert np.array_equal(compute(parts, threads=1).S, compute(parts, threads=3).S)


def test_blocked_pairs_against_monte_carlo() -> None:
    parts = subdivide(BUILT_IN["cornell"].make().checked(), 60)
    ours = compute(parts)
    free = compute(parts, "analytic").S
    S, error = monte_carlo(parts, 3000, 1, lambda *_: None)
    own = 0.06 * free  # where a pair is partly hidden, 16 rays, or 64, are off by half of 1 / sqrt(64)
    sure = error > 0
    apart = np.linalg.norm(parts.center[:, None] - parts.center, axis=2)
    sure &= apart > parts.size[:, None] + parts.size  # near ones have errors without a variance
    deviations = np.abs(ours.S - S)[sure] / np.hypot(error, own)[sure]
    assert np.median(deviations) < 0.5
    assert np.quantile(deviations, 0.99) < 3
    far = apart > parts.size[:, None] + parts.size
    assert ours.S[far].sum() == pytest.approx(S[far].sum(), rel=5e-3)


@pytest.mark.parametrize("name", ["cornell", "museum", "factory"])
def test_what_bodies_tell_agrees_with_rays(name: str) -> None:
    """Weighted by form factors: rays that graze a wall may be wrong where hardly any light goes."""
    parts = subdivide(BUILT_IN[name].make().checked(), 700)
    S = compute(parts, "analytic").S
    i, j = np.nonzero(np.triu(S))
    arrays = parts.rings, parts.counts, parts.normal, np.stack([i, j], axis=1)
    with_bodies, rays_alone = Visibility(parts.scene), Visibility(parts.scene)
    rays_alone.bodies = None
    share, asked = with_bodies.asked(*arrays)
    everywhere, all_asked = rays_alone.asked(*arrays)
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
    assert normal_of(result.patches.scene.rings[6])[1] == -1.0
    assert result.factors.row_sums[shines] == pytest.approx(1.0, abs=0.01)
    assert result.B[~shines].max() > 0.5


@pytest.mark.parametrize("count", [300, 1300, 5000])
def test_no_patch_inside_of_a_block_stays(count: int) -> None:
    """Not even a sliver along its foot: the area is that of all that can be seen."""
    parts = subdivide(BUILT_IN["cornell-closed"].make().checked(), count)
    floor = parts.polygon == 0
    seen = 552.8 * 559.2 - 0.5 * 3.2 * 559.2 - 55259.5
    assert -0.1 < seen - parts.area[floor].sum() < 10.0  # cells that would be slivers are left out


def test_the_floor_below_a_table_stays() -> None:
    """Below a sheet that shows its back, but not inside of anything."""
    b = Builder("table")
    b.add(box((0, 0, 0), (6, 3, 4), inside=True), Material("wall", (0.7,) * 3, (1.0,) * 3))
    b.add([quad((2, 0.8, 1.5), (2, 0.8, 2.5), (4, 0.8, 2.5), (4, 0.8, 1.5))], Material("wood", (0.5,) * 3))
    parts = subdivide(b.scene().checked(), 700)
    floor = parts.polygon == 2
    assert parts.normal[floor][0] == pytest.approx([0.0, 1.0, 0.0])
    assert parts.area[floor].sum() == pytest.approx(24.0)


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


@pytest.mark.parametrize("method", [name for name in METHODS if name != "hierarchical"])
def test_methods(method: str) -> None:
    scene = room((1, 1, 1), [Material("wall", (0.5,) * 3, (1.0,) * 3)] * 6).checked()
    factors = compute(subdivide(scene, 150), method)
    assert np.array_equal(factors.S, factors.S.T)
    error = np.abs(factors.row_sums - 1.0).mean()
    assert (
        error
        < {"contour": 1e-3, "analytic": 1e-3, "point": 0.2, "disc": 0.1, "monte-carlo": 0.2, "hemicube": 0.02}[method]
    )
    assert (factors.error is not None) == (method == "monte-carlo")


def test_hemicube() -> None:
    """In an empty room, against the exact form factors from the middles of the patches; its pixels sum to 1."""
    for resolution in (16, 64):
        assert delta_form_factors(resolution).sum() == pytest.approx(1.0, abs=0.6 / resolution**2)
    parts = subdivide(BUILT_IN["furnace"].make().checked(), 54)
    at_middle = np.zeros((len(parts), len(parts)))
    arrays = (parts.rings, parts.counts, parts.normal, parts.center, parts.size, np.zeros(len(parts)))
    kernels.gather(parts.center, parts.normal, *arrays, at_middle)
    expected = at_middle * parts.area[:, None]
    expected = (expected + expected.T) / 2.0
    error = {r: np.abs(hemicube(parts, print, r) - expected).mean() / expected.mean() for r in (32, 128, 512)}
    assert error[128] < 0.35 * error[32]
    assert error[512] < 0.35 * error[128] < 0.005


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


# ---------------------------------------------------------------- the path-traced Cornell box


@pytest.fixture(scope="module")
def traced() -> dict[str, np.ndarray]:
    with np.load(REFERENCE / "cornell_black_front.npz") as stored:
        return {name: stored[name] for name in stored.files}


@pytest.fixture(scope="module")
def on_reference(traced: dict[str, np.ndarray]) -> tuple[Patches, np.ndarray, FormFactors]:
    """Radiosity on the very patches of the reference."""
    scene = BUILT_IN["cornell"].make().checked()
    offsets, corners = traced["ring_offsets"], traced["ring_vertices"]
    rings = [corners[a:b] for a, b in pairwise(offsets)]
    parts = patches_of(scene, rings, [0] * len(rings))
    parts = replace(parts, rho=traced["rho"], E=traced["E"], normal=traced["normal"], area=traced["area"])
    factors = compute(parts)
    return parts, solved(factors)[-1].B, factors


def deviation(B: np.ndarray, traced: dict[str, np.ndarray], key: str = "B") -> tuple[float, float]:
    """rms of the reflected part, weighted by area, and the bias of the energy."""
    area, E = traced["area"][:, None], traced["E"]
    d, r = B - traced[key], traced[key] - E
    return float(np.sqrt((area * d * d).sum() / (area * r * r).sum())), float((area * d).sum() / (area * r).sum())


def test_cornell_box(traced: dict[str, np.ndarray], on_reference: tuple[Patches, np.ndarray, FormFactors]) -> None:
    rms, bias = deviation(on_reference[1], traced)
    assert rms < 0.0075
    assert abs(bias) < 0.0005


def test_cornell_box_with_four_times_the_patches(traced: dict[str, np.ndarray]) -> None:
    scene = BUILT_IN["cornell"].make().checked()
    rings, of = [], []
    for number, (a, b) in enumerate(pairwise(traced["ring_offsets"])):
        ring = traced["ring_vertices"][a:b]
        middles = (ring + np.roll(ring, -1, axis=0)) / 2
        if len(ring) == 4:
            centre = (ring[0] + ring[1] + ring[2] + ring[3]) / 4
            parts = [np.array([ring[k], middles[k], centre, middles[k - 1]]) for k in range(4)]
        else:
            parts = [np.array([ring[k], middles[k], middles[k - 1]]) for k in range(3)] + [middles]
        rings += parts
        of += [number] * 4
    p = patches_of(scene, rings, [0] * len(rings))
    p = replace(p, rho=traced["rho"][of], E=traced["E"][of], normal=traced["normal"][of])
    B = solved(compute(p))[-1].B
    total = np.stack([np.bincount(of, p.area * B[:, c]) for c in range(3)], axis=1)
    rms, bias = deviation(total / np.bincount(of, p.area)[:, None], traced)
    assert rms < 0.004
    assert abs(bias) < 0.0005


def test_gathering_at_points(
    traced: dict[str, np.ndarray], on_reference: tuple[Patches, np.ndarray, FormFactors]
) -> None:
    """A final gather at the middles of the patches, against path tracing there."""
    parts, B, factors = on_reference
    shown = radiosity_at(factors, traced["centre"], traced["normal"], np.arange(len(parts)), B)
    rms, bias = deviation(shown, traced, "B_centre")
    assert rms < 0.009
    assert abs(bias) < 0.002


def test_vertices_where_light_changes_fast() -> None:
    """At the vertices, most of which are in corners and at shadows, against a gather from ten times the patches."""
    scene = BUILT_IN["cornell"].make().checked()
    coarse, fine = (compute(subdivide(scene, count)) for count in (500, 5000))
    B, B_fine = (solved(factors)[-1].B for factors in (coarse, fine))
    mesh, mesh_fine = (mesh_of(factors.patches) for factors in (coarse, fine))
    bright = gathered(fine, mesh_fine, B_fine)[mesh_fine.corners]
    H = radiosity_at(fine, mesh.at, mesh.normals, np.zeros(len(mesh.at), int), B_fine) - fine.patches.E[0]
    H = H / fine.patches.rho[0] + unevenness(fine.patches, mesh.at, mesh.normals, bright)
    true = coarse.patches.E[mesh.patch] + coarse.patches.rho[mesh.patch] * H
    even = radiosity_at(coarse, mesh.at, mesh.normals, mesh.patch, B)
    dark = coarse.patches.E[mesh.patch].max(axis=1) == 0.0

    def rms(shown: np.ndarray) -> float:
        return float(np.sqrt(((shown - true)[dark] ** 2).sum() / (true[dark] ** 2).sum()))

    assert rms(gathered(coarse, mesh, B)) < 0.014
    assert rms(even) < 0.03  # if patches were evenly bright
    assert 0.1 < rms(averaged(coarse.patches, mesh, B)) < 0.2  # as textbooks do it


# ---------------------------------------------------------------- patches, vertices, files


def test_patches_are_cut_where_bodies_stand() -> None:
    scene = BUILT_IN["cornell"].make().checked()
    parts = subdivide(scene, 700)
    names = [scene.materials[scene.material[p]].name for p in parts.polygon]
    floor = parts.polygon == 0
    footprints = 55259.5
    assert parts.area[floor].sum() == pytest.approx(552.8 * 559.2 - 0.5 * 3.2 * 559.2 - footprints, rel=1e-4)
    ceiling = parts.polygon == 1
    assert parts.area[ceiling].sum() == pytest.approx(556 * 559.2 - 130 * 105, rel=1e-6)
    assert set(names) == {"white", "green", "red", "black", "light"}
    assert set(parts.counts) == {3, 4}


def test_no_t_vertices() -> None:
    """No vertex of a surface lies on an edge of one of its triangles."""
    parts = subdivide(BUILT_IN["cornell"].make().checked(), 400)
    mesh = mesh_of(parts)
    for polygon in (0, 1):
        chosen = mesh.triangles[parts.polygon[mesh.triangle_patch] == polygon]
        points = mesh.vertices[np.unique(chosen)]
        assert mesh_area(mesh.vertices[chosen]) == pytest.approx(parts.area[parts.polygon == polygon].sum(), rel=1e-9)
        for a, b in {(int(t[k]), int(t[(k + 1) % 3])) for t in chosen for k in range(3)}:
            start, way = mesh.vertices[a], mesh.vertices[b] - mesh.vertices[a]
            along = (points - start) @ way / (way @ way)
            off = np.linalg.norm(points - start - along[:, None] * way, axis=1)
            assert not ((off < 1e-6) & (along > 1e-6) & (along < 1 - 1e-6)).any()


def mesh_area(triangles: np.ndarray) -> float:
    return float(
        np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1).sum() / 2
    )


def test_vertices_in_a_furnace() -> None:
    """Where all walls have the same B, so have all vertices, gathered or averaged."""
    found = radiosity.solve("furnace", 200, close=True)
    assert found.vertex_radiosity == pytest.approx(np.full(found.vertex_radiosity.shape, 2.0), rel=0.01)
    mean = averaged(found.patches, found.mesh, found.B)
    assert mean == pytest.approx(np.full(mean.shape, 2.0), rel=1e-3)


def test_tones() -> None:
    B = np.array([[0.0, 0.5, 1.0], [2.0, 4.0, 1e9]])
    assert toned(B, 1.0, gamma=1.0).tolist() == [[0.0, 0.5, 1.0], [1.0, 1.0, 1.0]]
    assert toned(B, 1.0, "reinhard", 1.0)[0].tolist() == pytest.approx([0.0, 1 / 3, 0.5])
    assert toned(B, 2.0)[0, 2] == pytest.approx(0.5 ** (1 / 2.2))
    with pytest.raises(ValueError, match="tones are"):
        toned(B, 1.0, "sepia")


@pytest.mark.parametrize("name", BUILT_IN)
def test_built_in_scenes(name: str) -> None:
    """Nothing is odd about them: fronts look inwards, all rooms but the plates are closed."""
    scene = BUILT_IN[name].make().checked()
    parts = subdivide(scene, 300)
    sums = compute(parts).row_sums
    mean = float(np.average(np.abs(sums - 1.0), weights=parts.area))
    assert mean < 0.01 or name == "plates"
    assert scene.views


@pytest.fixture(scope="module")
def small() -> radiosity.Radiosity:
    return radiosity.solve("cornell", 250)


def test_files(small: radiosity.Radiosity, tmp_path: Path) -> None:
    import trimesh
    from PIL import Image

    for name in ("c.png", "c.glb", "c.ply", "c.npz"):
        small.save(tmp_path / name, size=128)
    with Image.open(tmp_path / "c.png") as picture:
        colors = np.asarray(picture.convert("RGB")).astype(int)
    assert colors[60, 12, 0] > 1.5 * colors[60, 12, 1]  # red left
    assert colors[60, 118, 1] > 1.2 * colors[60, 118, 0]  # green right, in yellow light
    for name in ("c.glb", "c.ply"):
        mesh = trimesh.load(tmp_path / name, force="mesh")
        assert len(mesh.faces) == len(small.mesh.triangles)
        assert len(np.unique(mesh.visual.vertex_colors, axis=0)) > 100
    with np.load(tmp_path / "c.npz") as stored:
        assert stored["triangles"].shape == (len(stored["triangle_patch"]), 3, 3)
        assert stored["B"].shape == stored["E"].shape == stored["rho"].shape == stored["normal"].shape
        assert stored["area"].sum() == pytest.approx(mesh_area(stored["triangles"]), rel=1e-9)
    with pytest.raises(SceneError, match=r"must end in"):
        small.save(tmp_path / "c.xyz")
    report = small.report()
    assert json.loads(json.dumps(report))["n"] == len(small.patches)
    assert report["row_sum_error_mean"] < 2e-3
    assert small.row_picture(5, 64).size == (64, 64)
    direct = small.direct()
    ceiling = small.mesh.normals[:, 1] < -0.9
    dark = ceiling & (small.patches.E[small.mesh.patch].max(axis=1) == 0.0)
    assert direct[dark].max() < 1e-6  # no light shines directly onto the ceiling that holds the lamp
    assert small.vertex_radiosity[dark].min() > 0.001
    assert small.beside_direct(64).size[0] > 128
    assert len(small.convergence_picture().getcolors(1 << 16)) > 5
    assert len(small.matrix_picture(100).getcolors(1 << 16)) > 20
    with pytest.raises(SceneError, match="has 1 view, numbered from 0; there is no 3"):
        small.picture(64, 3)


def test_a_mesh_file_and_a_program(tmp_path: Path) -> None:
    import trimesh

    room_ = trimesh.creation.box((4, 3, 5))
    room_.invert()
    room_.visual = trimesh.visual.TextureVisuals(
        material=trimesh.visual.material.PBRMaterial(name="wall", baseColorFactor=[0.5, 0.5, 0.5, 1.0])
    )
    lamp = trimesh.creation.icosphere(subdivisions=1, radius=0.4)
    lamp.visual = trimesh.visual.TextureVisuals(
        material=trimesh.visual.material.PBRMaterial(name="lamp", emissiveFactor=[1.0, 1.0, 1.0])
    )
    trimesh.Scene([room_, lamp]).export(tmp_path / "room.glb")
    scene = scene_from(tmp_path / "room.glb")
    assert {material.name for material in scene.materials} == {"wall", "lamp"}
    found = radiosity.solve(tmp_path / "room.glb", 300)
    assert found.report()["row_sum_error_mean"] < 0.01
    brighter = scene_from(tmp_path / "room.glb", {"lamp": Material("lamp", (0.0,) * 3, (5.0, 5.0, 5.0))})
    assert max(material.E[0] for material in brighter.materials) == 5.0
    with pytest.raises(SceneError, match="no material named sky"):
        scene_from(tmp_path / "room.glb", {"sky": Material("sky", (0.0,) * 3)})

    (tmp_path / "program.py").write_text("""
from OpenGL.GL import *
from OpenGL.GLUT import *
def wall(emission, *corners):
    glMaterialfv(GL_FRONT, GL_EMISSION, [emission] * 3 + [1])
    glBegin(GL_QUADS)
    for corner in corners:
        glVertex3f(*corner)
    glEnd()
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glTranslatef(0, 0, -3)
    wall(1.0, (-1, 1, -1), (1, 1, -1), (1, 1, 1), (-1, 1, 1))
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.8, 0.2, 0.2, 1])
    wall(0.0, (-1, -1, 1), (1, -1, 1), (1, -1, -1), (-1, -1, -1))
    glutSwapBuffers()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE)
glutCreateWindow("t")
glEnable(GL_LIGHTING)
glutDisplayFunc(display)
glutMainLoop()
""")
    found = radiosity.solve(tmp_path / "program.py", 60)
    floor = found.patches.E.max(axis=1) == 0.0
    red = found.B[floor].mean(axis=0)
    assert red[0] == pytest.approx(4 * red[1], rel=0.05)
    assert 0.1 < red[0] < 0.2  # about 0.2 of the light arrives, 0.8 of its red leaves


# ---------------------------------------------------------------- bad input

SQUARE = quad((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))
GREY, LAMP = Material("grey", (0.5,) * 3), Material("lamp", (0.0,) * 3, (1.0,) * 3)


@pytest.mark.parametrize(
    ("rings", "material", "sentence"),
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
def test_bad_scenes(rings: list[np.ndarray], material: Material, sentence: str) -> None:
    b = Builder("bad")
    b.add(rings, material)
    with pytest.raises(SceneError, match=sentence):
        replace(b.scene(), materials=(material,)).checked()


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
    assert len(scene.rings) == 3
    assert sorted(scene.notes) == [
        "degenerate polygons, dropped: 1",
        "duplicate polygons, dropped: 1",
        "polygons that were not planar, split into triangles: 1",
    ]


def test_what_lights_nothing_is_told() -> None:
    b = Builder("ball")
    b.add([ring[::-1] for ring in box((0, 0, 0), (1, 1, 1), inside=True)], Material("glows", (0.1,) * 3, (1.0,) * 3))
    ball = radiosity.solve(b.scene(), 30)
    assert pytest.approx(ball.patches.E) == ball.B
    assert "no patch sees another, so nothing is lit" in ball.report()["notes"][0]
    b = Builder("turned")
    b.add(box((0, 0, 0), (2, 2, 2), inside=True), Material("wall", (0.5,) * 3))
    b.add([quad((4, 0, 0), (4, 1, 0), (4, 1, 1), (4, 0, 1))], Material("lamp", (0.0,) * 3, (9.0,) * 3))  # looks away
    assert "what emits sees nothing, so nothing is lit" in radiosity.solve(b.scene(), 100).report()["notes"][0]


def test_a_scene_without_cameras_has_one() -> None:
    b = Builder("room")
    b.add(box((0, 0, 0), (2, 2, 2), inside=True), Material("wall", (0.5,) * 3, (1.0,) * 3))
    result = radiosity.solve(b.scene(), 30)
    assert len(np.unique(np.asarray(result.picture(32)))) > 1
    with pytest.raises(SceneError, match="patches are numbered from 0 to 23; there is no 24"):
        result.row_picture(24)


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


def test_what_escapes_is_told() -> None:
    open_, closed = (radiosity.solve(name, 60).report() for name in ("plates", "furnace"))
    assert open_["notes"] == [f"the scene is open: {100 * open_['leak']:.1f} % of what leaves its surfaces escapes"]
    assert open_["leak"] == pytest.approx(1.0 - 0.4152, abs=2e-3)  # two facing squares, half an edge apart
    assert closed["notes"] == []


def test_a_scene_that_would_not_fit() -> None:
    parts = subdivide(BUILT_IN["furnace"].make().checked(), 600)
    with pytest.raises(SceneError, match="take fewer patches"):
        compute(parts, limit=10**6)
    with pytest.raises(SceneError, match="the methods for form factors are"):
        compute(parts, "guess")


def test_an_interrupted_run_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("glsim.radiosity.formfactors.BLOCK", 5000)
    parts = subdivide(BUILT_IN["cornell"].make().checked(), 250)
    whole = compute(parts)
    target = str(tmp_path / "rows.npz")
    calls = 0

    def interrupted(stage: str, done: int, of: int) -> None:
        nonlocal calls
        calls += 1
        if calls == 4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        compute(parts, checkpoint=target, progress=interrupted)
    assert Path(target).exists()
    first: list[int] = []
    again = compute(parts, checkpoint=target, progress=lambda stage, done, of: first.append(done))
    assert first[0] > 2 * 5000
    assert np.array_equal(again.S, whole.S)
    assert not Path(target).exists()


@pytest.mark.parametrize(
    ("method", "stage"),
    [("contour", "form factors"), ("contour", "vertices"), ("hierarchical", "links"), ("hierarchical", "vertices")],
)
def test_nothing_is_lost_whenever_one_interrupts(
    method: str, stage: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("glsim.radiosity.formfactors.BLOCK", 20000)
    monkeypatch.setattr("glsim.radiosity.hierarchy.BLOCK", 20000)
    monkeypatch.setattr("glsim.radiosity.bake.AT_ONCE", 200)
    target = str(tmp_path / "kept.npz")
    told: list[tuple[str, int]] = []

    def progress(name: str, done: int, of: int) -> None:
        told.append((name, done))
        if name == stage and len([n for n, _ in told if n == stage]) == 3:
            raise KeyboardInterrupt

    def run(**more: Any) -> radiosity.Radiosity:
        return radiosity.solve("cornell", 500, method=method, **more)

    whole = run()
    with pytest.raises(KeyboardInterrupt):
        run(checkpoint=target, progress=progress)
    assert Path(target).exists()
    stage = "never"
    told.clear()
    again = run(checkpoint=target, progress=progress)
    assert again.vertex_radiosity == pytest.approx(whole.vertex_radiosity, rel=1e-9)
    assert not Path(target).exists()
    first = [done for name, done in told if name in ("form factors", "links")]
    assert not first or method == "hierarchical" or first[0] > 40000


def test_another_scenes_checkpoint_is_left_alone(tmp_path: Path) -> None:
    target = str(tmp_path / "kept.npz")
    other, ours = (compute(subdivide(BUILT_IN[name].make().checked(), 60)) for name in ("plates", "furnace"))
    other.keep(target)
    before = Path(target).read_bytes()
    assert np.array_equal(compute(ours.patches, checkpoint=target).S, ours.S)
    assert Path(target).read_bytes() == before
    ours.keep(target)
    whole = Path(target).read_bytes()
    np.save(tmp_path / "array.npy", np.zeros(3))
    array = (tmp_path / "array.npy").read_bytes()
    for content in (b"nonsense", b"", b"PK", whole[:-2000], whole[:3000], array):
        Path(target).write_bytes(content)
        with pytest.raises(SceneError, match="is no checkpoint: name another file, or remove it"):
            compute(ours.patches, checkpoint=target)


def run(words: str) -> int:
    from glsim.cli import main

    return main(["radiosity", *words.split()])


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_command(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    small = "goral --patches 100 --size 64"
    assert run(f"{small} -o a.png -o a.npz --json") == 0
    record = json.loads(capsys.readouterr().out)
    assert record["status"] == "ok"
    assert record["outputs"] == ["a.png", "a.npz"]
    assert run(f"{small} --json r.json -o c.glb") == 0
    assert "escapes" in capsys.readouterr().out
    written = json.loads(Path("r.json").read_text())
    assert {key: written[key] for key in ("n", "status", "method")} == {
        key: record[key] for key in ("n", "status", "method")
    }
    assert sorted(path.name for path in folder.iterdir()) == ["a.npz", "a.png", "c.glb", "r.json"]
    assert run(f"{small} -o b.png --tone reinhard --white 0.1 --gamma 1.8") == 0
    assert Path("b.png").read_bytes() != Path("a.png").read_bytes()
    capsys.readouterr()
    assert run("--list") == 0
    assert "cornell-closed" in capsys.readouterr().out
    assert run("--json plates --patches 20 -o d.npz") == 0
    assert json.loads(capsys.readouterr().out)["scene"] == "plates"


def test_several_views(folder: Path) -> None:
    assert run("museum --patches 600 --size 48 --views all -o a.png -o a.ply --direct d.png") == 0
    assert sorted(path.name for path in folder.iterdir()) == ["a-0.png", "a-1.png", "a.ply", "d-0.png", "d-1.png"]
    assert Path("a-0.png").read_bytes() != Path("a-1.png").read_bytes()


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("nowhere.glb", "there is no such file, and the built-in scenes are cornell"),
        ("goral --method x", "the methods for form factors are contour, analytic"),
        ("goral --solver x", "the solvers are gauss-seidel, jacobi"),
        ("goral -o a.xyz", "the name must end in .png"),
        ("goral -o no/where/a.png", "there is no folder no/where; make it first"),
        ("goral --json r.txt", "--json r.txt: the report's name must end in .json"),
        ("goral --patches 30 --views 0,4 -o a.png", "goral has 1 view, numbered from 0; there is no 4"),
        ("goral --patches 30 --method hierarchical --solver lu", "no matrix for this solver: choose cg or jacobi"),
        ("goral --method hierarchical --adaptive", "hierarchical radiosity neither needs --adaptive"),
    ],
)
def test_what_the_command_refuses(words: str, sentence: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(words) == 1
    assert sentence in capsys.readouterr().err
    assert not list(folder.iterdir())


@pytest.mark.parametrize("package", ["numba", "embreex"])
@pytest.mark.parametrize("words", ["radiosity plates", "compare plates --modes radiosity"])
def test_a_package_that_is_missing(package: str, words: str, folder: Path) -> None:
    (folder / package).mkdir()
    text = f"raise ModuleNotFoundError('no {package}', name='{package}')"
    (folder / package / "__init__.py").write_text(text)
    hide = (
        f"import importlib.util as u\nold = u.find_spec\nu.find_spec = lambda n: None if n == '{package}' else old(n)"
    )
    code = f"{hide}\nfrom glsim.cli import main\nraise SystemExit(main({words.split()!r}))"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=folder, env=ENVIRONMENT)
    assert ran.returncode == 1
    assert ran.stderr.splitlines()[-1] == f"glsim: radiosity needs the package {package}: pip install glsim[radiosity]"


def test_the_command_interrupted(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*arguments: Any) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr("glsim.radiosity.solution.gathered", interrupted)
        assert run("goral --patches 60 -o a.png") == 130
    told = capsys.readouterr().err
    assert "what is done is in a.unfinished.npz; the same command goes on with it" in told
    assert run("goral --patches 60 -o a.png") == 0
    assert [path.name for path in folder.iterdir()] == ["a.png"]
