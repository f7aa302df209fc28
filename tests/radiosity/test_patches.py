"""Patches: cut where bodies stand, left out where nobody sees them, drawn without T-vertices."""

from __future__ import annotations

import numpy as np
import pytest

from glsim.radiosity.mesh import mesh_of
from glsim.radiosity.methods import compute
from glsim.radiosity.rooms.shapes import beam
from glsim.radiosity.scene import Builder, Material, box, quad
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.subdivide import subdivide
from tests.radiosity.helpers import mesh_area


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
            start, edge = mesh.vertices[a], mesh.vertices[b] - mesh.vertices[a]
            along = (points - start) @ edge / (edge @ edge)
            off = np.linalg.norm(points - start - along[:, None] * edge, axis=1)
            assert not ((off < 1e-6) & (along > 1e-6) & (along < 1 - 1e-6)).any()


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in BUILT_IN if name not in ("museum", "factory")])
def test_built_in_scenes(name: str) -> None:
    """Nothing is odd about them: fronts look inwards, all rooms but the plates are closed.  (For the larger rooms see
    test_rooms.py.)"""
    scene = BUILT_IN[name].make().checked()
    parts = subdivide(scene, 300)
    sums = compute(parts).row_sums
    mean = float(np.average(np.abs(sums - 1.0), weights=parts.area))
    assert mean < 0.01 or name == "plates"
    assert scene.views


def test_a_wall_stays_around_the_end_of_a_beam() -> None:
    """It is thinner than a patch, and its end lies on the middle of one: no more of the wall goes than it covers."""
    b = Builder("beam")
    b.add(box((0, 0, 0), (20, 6, 12), inside=True), Material("wall", (0.5,) * 3, (1.0,) * 3))
    b.add(beam((0, 3, 5), (20, 3, 5), 0.16, 0.2), Material("beam", (0.4,) * 3))
    parts = subdivide(b.scene().checked(), length=2.0)
    assert parts.area[parts.polygon == 0].sum() >= 72.0 - 0.16 * 0.2 - 1e-9
