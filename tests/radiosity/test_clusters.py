"""Scenes of many small polygons, and of polygons that lie on each other."""

from __future__ import annotations

import numpy as np
import pytest

from glsim import radiosity
from glsim.radiosity.clusters import clustered
from glsim.radiosity.lamps import Lamps
from glsim.radiosity.methods import compute
from glsim.radiosity.near import overlapping
from glsim.radiosity.patches import patches_of
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Builder, Material, Scene, View, box, quad
from glsim.radiosity.subdivide import subdivide
from glsim.radiosity.visibility import Visibility
from glsim.scenes import shapes

WALL, LAMP = Material("wall", (0.7,) * 3), Material("lamp", (0.0,) * 3, (10.0,) * 3)


def sphere(segments: int, radius: float, middle: tuple[float, float, float]) -> list[np.ndarray]:
    mesh = shapes.sphere(segments)
    points = mesh.positions.astype(float)
    points = points * radius / np.linalg.norm(points, axis=1).max() + middle
    return [points[face] for face in (*mesh.triangles, *mesh.quads)]


def ball_room(segments: int, material: Material) -> Scene:
    """A room of 2 x 2 x 2 with a ball of radius 0.4 in its middle."""
    b = Builder("ball")
    b.add(box((0, 0, 0), (2, 2, 2), inside=True), WALL)
    b.add([quad((0.7, 1.99, 0.7), (1.3, 1.99, 0.7), (1.3, 1.99, 1.3), (0.7, 1.99, 1.3))], LAMP)
    b.add(sphere(segments, 0.4, (1.0, 1.0, 1.0)), material, smooth=True)
    return b.scene(View((1.0, 1.0, 1.98), (1.0, 0.9, 0.0), fov=80.0)).checked()


def test_boxes_that_overlap() -> None:
    random = np.random.default_rng(3)
    low = [random.random((count, 3)) for count in (120, 150)]
    boxes = [(some, some + 0.3 * random.random(some.shape)) for some in low]
    rows, columns = overlapping(*boxes)
    (a, b), (c, d) = boxes
    expected = ((a[:, None] <= d) & (c <= b[:, None])).all(axis=2)
    assert (np.stack([rows, columns], axis=1) == np.argwhere(expected)).all()
    assert 0 < len(rows) < expected.size


def test_a_ball_of_clusters() -> None:
    """It has the area of its triangles, and what it exchanges with the room is what its triangles exchange."""
    scene = ball_room(24, Material("stone", (0.5,) * 3))
    rays = Rays(scene)
    whole = subdivide(scene, length=0.3, rays=rays)
    parts = clustered(whole, 0.3)
    assert parts.is_cluster.sum() < 120 < len(whole) / 4
    assert parts.area.sum() == pytest.approx(whole.area.sum())
    pieces, of = parts.drawn()
    assert np.bincount(of, pieces.area) == pytest.approx(parts.area)
    sent, sums = [], []
    for factors in (compute(whole, rays=rays), compute(parts, rays=rays)):
        ball = factors.patches.rho[:, 0] == 0.5
        sent.append(factors.S[ball][:, ~ball].sum())
        sums.append(np.average(factors.row_sums[~ball], weights=factors.patches.area[~ball]))
    assert sent[1] == pytest.approx(sent[0], rel=0.01)
    assert sums[1] == pytest.approx(sums[0], abs=3e-3)


def test_a_lamp_of_clusters_shines_as_its_triangles() -> None:
    scene = ball_room(24, LAMP)
    rays = Rays(scene)
    parts = clustered(subdivide(scene, length=0.4, rays=rays), 0.4)
    visibility = Visibility(rays)
    points = np.random.default_rng(5).random((200, 3)) * (2, 0, 2)
    up = np.tile((0.0, 1.0, 0.0), (200, 1))
    exact = Lamps(patches_of(scene, [scene.polygons[k] for k in scene.emitters], scene.emitters), visibility)
    found, true = (lamps.at_points(points, up)[:, 0] for lamps in (Lamps.of(parts, visibility), exact))
    assert len(exact.parts) > 5 * len(parts.chosen(np.flatnonzero(parts.is_cluster)))
    assert found.mean() == pytest.approx(true.mean(), rel=0.02)
    assert np.sqrt(((found - true) ** 2).mean()) < 0.06 * true.mean()


def test_as_many_patches_as_asked_for() -> None:
    """And the light is that of the scene with all its triangles as patches."""
    scene = ball_room(32, Material("stone", (0.5,) * 3))
    few, many = (radiosity.solve(scene, patches, drawn=0) for patches in (300, len(scene.polygons) + 200))
    assert len(few.patches) < 450
    assert len(many.patches) > 700
    power = [
        (result.patches.area * (result.B - result.patches.E)[:, 0])[result.patches.rho[:, 0] == rho].sum()
        for rho in (0.5, 0.7) for result in (few, many)
    ]  # fmt: skip
    assert power[0] == pytest.approx(power[1], rel=0.03)
    assert power[2] == pytest.approx(power[3], rel=0.01)
    assert few.mesh.areas.sum() == pytest.approx(many.mesh.areas.sum(), rel=0.005)


@pytest.mark.parametrize("gap", [0.0, 2e-5, 4e-5])
def test_layers_count_once(gap: float) -> None:
    """A rug and a second one on it, on the floor or a hair above; a lamp behind the ceiling lights nothing."""
    b = Builder("layers")
    b.add(box((0, 0, 0), (2, 2, 2), inside=True), WALL)
    for height, half in ((gap, 0.8), (2 * gap, 0.5)):
        a, c = 1 - half, 1 + half
        b.add(
            [quad((a, height, a), (a, height, c), (c, height, c), (c, height, a))], Material(f"rug {half}", (0.3,) * 3)
        )
    y = 2.0 + gap
    lamp = quad((0.7, y, 0.7), (1.3, y, 0.7), (1.3, y, 1.3), (0.7, y, 1.3))
    b.add([lamp], LAMP)
    b.add([quad((0.0, 1.2, 0.5), (0.0, 1.7, 0.5), (0.0, 1.7, 1.5), (0.0, 1.2, 1.5))], LAMP)
    factors = compute(subdivide(b.scene().checked(), 600))
    assert factors.row_sums.max() < 1.03
    assert factors.row_sums.mean() == pytest.approx(1.0, abs=2e-3)
    parts = factors.patches
    up = np.isclose(parts.normal[:, 1], 1.0)
    assert parts.area[up].sum() == pytest.approx(4.0, rel=1e-6)
    ceiling = parts.E[:, 0] * np.isclose(parts.normal[:, 1], -1.0)
    assert (ceiling.max() > 0.0) == (gap == 0.0)  # in one plane the lamp is seen, behind the ceiling it is not


def test_rows_that_sum_to_more_are_mended() -> None:
    """Two equal boxes that reach into each other: light that both would take is taken once."""
    b = Builder("boxes")
    b.add(box((0, 0, 0), (2, 2, 2), inside=True), WALL)
    b.add(box((0.7, 1.9, 0.7), (1.3, 1.95, 1.3)), LAMP)
    for k in range(4):
        moved = [np.add(polygon, (0.0, 3e-5 * k, 1e-5 * k)) for polygon in box((0.5, 0.0, 0.5), (1.5, 0.4, 1.5))]
        b.add(moved, Material(f"box {k}", (0.5,) * 3))
    result = radiosity.solve(b.scene(), 400, drawn=0)
    assert result.factors.row_sums.max() < 1.0101
    before = compute(result.patches).row_sums
    assert (before > 1.01).any() == any("mended" in note for note in result.report()["notes"])
