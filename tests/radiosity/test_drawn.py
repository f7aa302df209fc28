"""The mesh that is drawn: smaller triangles where light changes fast, without T-vertices."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from glsim import radiosity
from glsim.cli import main
from glsim.radiosity.drawn import Edges
from glsim.radiosity.scene import Builder, Material, SceneError, quad
from tests.radiosity.helpers import mesh_area
from tests.radiosity.test_openings import doorway, lamp, photons, rooms


@pytest.fixture(scope="module")
def box() -> radiosity.Radiosity:
    return radiosity.solve("cornell", 250, drawn=2500)


def test_as_many_vertices_as_asked_for(box: radiosity.Radiosity) -> None:
    assert 2250 < len(box.mesh.vertices) <= 2500
    plain = radiosity.solve("cornell", 250, drawn=0)
    assert (plain.mesh.triangles == plain.patch_mesh.triangles).all()
    assert len(plain.mesh.vertices) < 500


def test_it_covers_the_patches_without_t_vertices(box: radiosity.Radiosity) -> None:
    """Each edge inside of a wall has two triangles, so no vertex can lie on an edge of a neighbour."""
    mesh, coarse = box.mesh, box.patch_mesh
    area = [np.bincount(some.triangle_patch, some.areas, len(box.patches)) for some in (mesh, coarse)]
    assert area[0] == pytest.approx(area[1], rel=1e-9)
    assert mesh_area(mesh.vertices[mesh.triangles]) == pytest.approx(coarse.areas.sum(), rel=1e-9)
    borders = []
    for some in (mesh, coarse):
        edges = Edges.of_triangles(some.triangles)
        assert edges.times.max() == 2
        ends = some.vertices[edges.ends[edges.times == 1]]
        borders.append(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())
    assert borders[0] == pytest.approx(borders[1], rel=1e-9)  # no edge has opened
    a, b, c = np.moveaxis(mesh.vertices[mesh.triangles], 1, 0)
    patch = box.patches.normal[mesh.triangle_patch]
    assert (np.einsum("nk,nk->n", np.cross(b - a, c - a), patch) > 0.0).all()  # fronts stay fronts


def test_vertices_are_where_shadows_are(box: radiosity.Radiosity) -> None:
    """On the floor more triangles lie around the short block's shadow than on as large a part that is evenly lit."""
    mesh = box.mesh
    middle = mesh.vertices[mesh.triangles].mean(axis=1)
    floor = box.patches.polygon[mesh.triangle_patch] == 0
    shadow = floor & (middle[:, 0] < 130) & (middle[:, 2] > 20) & (middle[:, 2] < 220)
    even = floor & (middle[:, 0] > 300) & (middle[:, 0] < 430) & (middle[:, 2] < 200)
    assert shadow.sum() > 3 * even.sum()


def test_direct_light_is_a_part_of_all(box: radiosity.Radiosity) -> None:
    assert box.light is not None
    lamps = box.patches.E[box.mesh.patch].max(axis=1) > 0.0
    assert (box.direct() <= box.vertex_radiosity + 1e-12).all()
    assert box.light.bounced[~lamps].min() > 0.0


def test_a_small_lamp_over_a_large_field() -> None:
    b = Builder("field")
    b.add([quad((-50, 0, -50), (-50, 0, 50), (50, 0, 50), (50, 0, -50))], Material("grass", (0.3,) * 3))
    b.add([quad((-1, 3, -1), (1, 3, -1), (1, 3, 1), (-1, 3, 1))], Material("lamp", (0.0,) * 3, (100.0,) * 3))
    result = radiosity.solve(b.scene(), 300)
    assert result.light is not None
    below = np.linalg.norm(result.mesh.vertices - (0, 0, 0), axis=1).argmin()
    # from a point to a square of edge 2 above it, at the height 3: four times the form factor of a quarter (1 x 1)
    x = 1.0 / 3.0
    quarter = 2.0 * x / np.sqrt(1 + x * x) * np.arctan(x / np.sqrt(1 + x * x)) / (2.0 * np.pi)
    at = result.mesh.vertices[below]
    assert np.hypot(at[0], at[2]) < 1.5
    assert result.light.direct[:, 0].max() == pytest.approx(100.0 * 4.0 * quarter, rel=0.15)


def test_bright_walls_do_not_take_a_thousand_sweeps() -> None:
    b = Builder("snow")
    b.add(radiosity.BUILT_IN["furnace"].make().polygons,
          Material("snow", (0.999,) * 3, (1.0,) * 3))  # fmt: skip
    result = radiosity.solve(b.scene(), 100, close=True)
    assert result.solver == "cg"
    assert result.steps[-1].iteration < 30
    assert pytest.approx(1000.0, rel=0.01) == result.B


@pytest.mark.parametrize("drawn", [-1, 2.5, True])
def test_numbers_of_vertices_that_make_no_sense(drawn: object) -> None:
    with pytest.raises(SceneError, match="drawn must be a whole number from 0 on, not"):
        radiosity.solve("plates", 10, drawn=drawn)  # type: ignore[arg-type]


def test_the_options(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    words = "radiosity goral --patches 60 --size 24 -o a.npz --drawn"
    assert main([*words.split(), "0"]) == 0
    few = np.load("a.npz")["vertices"]
    assert main([*words.split(), "900", "--final-gather", "losses.png"]) == 0
    assert len(np.load("a.npz")["vertices"]) > 5 * len(few)
    assert Path("losses.png").exists()
    with pytest.raises(SystemExit):
        main([*words.split(), "-4"])
    assert "--drawn" in capsys.readouterr().err


def test_a_doorway_and_a_lamp_of_triangles_as_they_are_drawn() -> None:
    """The light in the room behind a door, integrated over the mesh that is drawn, against photons; with any number of
    threads the same."""
    scene = doorway()
    result = radiosity.solve(scene, 600, threads=1)
    mesh, polygon = result.mesh, result.patches.polygon[result.mesh.triangle_patch]
    far = np.array([ring.mean(axis=0)[0] > 2.1 for ring in scene.polygons])
    power = mesh.areas * result.vertex_radiosity[mesh.triangles].mean(axis=1)[:, 0]
    traced = photons(scene)[:, far].sum(axis=1)
    error = traced.std(ddof=1) / np.sqrt(len(traced)) / traced.mean()
    assert power[far[polygon]].sum() == pytest.approx(traced.mean(), rel=0.01 + 2.0 * error)
    again = radiosity.solve(scene, 600, threads=3)
    assert (again.mesh.triangles == mesh.triangles).all()
    assert again.vertex_radiosity == pytest.approx(result.vertex_radiosity, rel=1e-12)
    whole, halves = (radiosity.solve(rooms([], lamp(1.0, corners)), 300) for corners in (4, 3))
    means = [np.average(some.vertex_radiosity[some.mesh.triangles].mean(axis=1)[:, 0], weights=some.mesh.areas)
             for some in (whole, halves)]  # fmt: skip
    assert means[0] == pytest.approx(means[1], rel=0.005)
