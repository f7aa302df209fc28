"""What a solution is good for: files, pictures, reports."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from glsim import radiosity
from glsim.radiosity.gather import averaged
from glsim.radiosity.hierarchy import linked
from glsim.radiosity.scene import Builder, Material, SceneError, box, quad
from glsim.radiosity.tree import tree_of
from glsim.radiosity.watch import save_steps, watched
from glsim.scenes import Camera
from tests.radiosity.helpers import mesh_area


@pytest.fixture(scope="module")
def small() -> radiosity.Radiosity:
    return radiosity.solve("cornell", 250)


def test_a_picture_in_a_file(small: radiosity.Radiosity, tmp_path: Path) -> None:
    small.save(tmp_path / "c.png", size=128)
    with Image.open(tmp_path / "c.png") as picture:
        colors = np.asarray(picture.convert("RGB")).astype(int)
    assert colors[60, 12, 0] > 1.5 * colors[60, 12, 1]  # red left
    assert colors[60, 118, 1] > 1.2 * colors[60, 118, 0]  # green right, in yellow light


@pytest.mark.parametrize("name", ["c.glb", "c.ply"])
def test_a_mesh_in_a_file(name: str, small: radiosity.Radiosity, tmp_path: Path) -> None:
    import trimesh

    small.save(tmp_path / name)
    mesh = trimesh.load(tmp_path / name, force="mesh")
    assert len(mesh.faces) == len(small.mesh.triangles)
    assert len(np.unique(mesh.visual.vertex_colors, axis=0)) > 100


def test_arrays_in_a_file(small: radiosity.Radiosity, tmp_path: Path) -> None:
    small.save(tmp_path / "c.npz")
    with np.load(tmp_path / "c.npz") as stored:
        assert stored["triangles"].shape == (len(stored["triangle_patch"]), 3, 3)
        assert stored["B"].shape == stored["E"].shape == stored["rho"].shape == stored["normal"].shape
        assert stored["area"].sum() == pytest.approx(mesh_area(stored["triangles"]), rel=1e-9)


def test_pictures_of_iterations(small: radiosity.Radiosity, tmp_path: Path) -> None:
    """Of Jacobi's iteration 0 shows the lamp alone, 1 no light on the ceiling, the last one the solution; all textures
    apart, a vertex has the mean of the patches around it."""
    pictures = watched(small, "jacobi", 64)
    assert [picture.caption.split(",")[:2] for picture in pictures[:3]] == [
        ["jacobi", f" bounces: {k}"] for k in range(3)
    ]
    means = [picture.pixels.mean() for picture in pictures]
    assert means == sorted(means)
    assert (pictures[0].pixels.max(axis=2) > 0).mean() < 0.05
    ceiling = [int(picture.pixels[6, 12:26].max()) for picture in pictures]
    assert ceiling[1] == 0
    assert ceiling[2] > 40
    coarse = replace(small, mesh=small.patch_mesh)
    solution = coarse.picture(64, B=averaged(coarse.patches, coarse.mesh, coarse.B))
    apart = np.abs(np.asarray(solution).astype(int) - pictures[-1].pixels)
    assert apart.mean() < 1.0
    assert apart.max() <= 8
    shots = watched(small, "shooting", 32)
    assert len(shots) == 8
    save_steps(small, tmp_path / "s.gif", "shooting", 32)
    save_steps(small, tmp_path / "s.png", "jacobi", 32)
    with Image.open(tmp_path / "s.gif") as moving:
        assert moving.n_frames == 8
    assert sorted(path.name for path in tmp_path.iterdir()) == ["s.gif", "s.png"]


def test_the_row_has_a_scale(small: radiosity.Radiosity) -> None:
    """Beside the scene: white on top, black below; the patch is orange."""
    picture = np.asarray(small.row_picture(5, 200)).astype(int)
    assert picture.shape == (44 + 200 + 12, 200 + 108, 3)
    assert picture[44 + 1, 200 + 20].min() > 250
    assert picture[44 + 197, 200 + 20].max() < 10
    orange = (np.abs(picture - (255, 128, 0)) < 3).all(axis=2)
    assert orange[44:, :200].sum() > 20
    assert not orange[:44].any()


def test_another_ending_is_refused(small: radiosity.Radiosity, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=r"must end in"):
        small.save(tmp_path / "c.xyz")


def test_the_report(small: radiosity.Radiosity) -> None:
    report = small.report()
    assert json.loads(json.dumps(report))["n"] == len(small.patches)
    assert report["row_sum_error_mean"] < 2e-3


def test_direct_light_does_not_reach_the_lamps_ceiling(small: radiosity.Radiosity) -> None:
    direct = small.direct()
    ceiling = small.mesh.normals[:, 1] < -0.9
    dark = ceiling & (small.patches.E[small.mesh.patch].max(axis=1) == 0.0)
    assert direct[dark].max() < 1e-6  # no light shines directly onto the ceiling that holds the lamp
    assert small.vertex_radiosity[dark].min() > 0.001
    assert small.beside_direct(64).size[0] > 128


def test_pictures_of_numbers(small: radiosity.Radiosity, gl_snapshot: Any) -> None:
    """The solution, a row of the form factors on the scene, the residual, the matrix.

    NumPy's last digits depend on the processor, lettering on the libraries that draw it."""
    gl_snapshot(small.picture(96), "solution", max=4, mean=0.3)
    gl_snapshot(small.row_picture(5, 64), "row", max=4, mean=0.3)
    gl_snapshot(small.convergence_picture(), "residual", mean=2.0)
    gl_snapshot(small.matrix_picture(250), "matrix", mean=2.0)


def test_a_camera_that_is_not_there(small: radiosity.Radiosity) -> None:
    with pytest.raises(SceneError, match="has 1 view, numbered from 0; there is no 3"):
        small.picture(64, 3)


def test_results_in_a_line_and_in_a_notebook(small: radiosity.Radiosity) -> None:
    n, p = len(small.patches), small.patches
    assert repr(small).startswith(f"<Radiosity of cornell: {n} patches, contour, gauss-seidel, ")
    links = linked(tree_of(p.scene, 60))
    assert [repr(some) for some in (p.scene, p, small.factors, links.tree)] == [
        "<Scene cornell: 18 polygons, 1 emitting, 5 materials>", f"<Patches of cornell: {n}>",
        f"<FormFactors of cornell: {n} x {n}, contour>",
        f"<Tree of cornell: {len(links.tree.nodes)} nodes, {len(links.tree.leaves)} elements>",
    ]  # fmt: skip
    for some in (small, small.mesh, links):
        assert len(repr(some)) < 120
        assert "\n" not in repr(some)
    page = small._repr_html_()
    assert '<img src="data:image/png;base64,iVBOR' in page
    assert "<td>form factors</td><td>contour; rows sum to 1 within" in page
    assert (small._repr_png_() or b"").startswith(b"\x89PNG")


def test_what_the_package_offers() -> None:
    assert {"solve", "Radiosity", "Builder", "Material", "Scene", "SceneError", "View", "BUILT_IN"} <= set(
        dir(radiosity)
    )
    assert all(hasattr(radiosity, name) for name in dir(radiosity))


def test_what_escapes_is_told() -> None:
    open_, closed = (radiosity.solve(name, 60).report() for name in ("plates", "furnace"))
    assert open_["notes"] == [f"the scene is open: {100 * open_['leak']:.1f} % of what leaves its surfaces escapes"]
    assert open_["leak"] == pytest.approx(1.0 - 0.4152, abs=2e-3)  # two facing squares, half an edge apart
    assert closed["notes"] == []


def test_what_lights_nothing_is_told() -> None:
    b = Builder("ball")
    b.add(
        [polygon[::-1] for polygon in box((0, 0, 0), (1, 1, 1), inside=True)], Material("glows", (0.1,) * 3, (1.0,) * 3)
    )
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


def test_a_camera_around_the_scene(small: radiosity.Radiosity) -> None:
    """Azimuth 0 is the side of the scene's own camera; distance counts radii; elevation goes up."""
    own = small.view(0)
    front = small.view(Camera(0.0, 0.0, 4.0))
    points = np.concatenate(small.patches.scene.polygons)
    middle = (points.min(axis=0) + points.max(axis=0)) / 2.0
    radius = small.patches.scene.size / 2.0
    np.testing.assert_allclose(front.target, middle)
    assert abs(np.linalg.norm(np.subtract(front.eye, middle)) - 4.0 * radius) < 1e-6 * radius
    level = np.subtract(own.eye, own.target) * (1.0, 0.0, 1.0)
    level /= np.linalg.norm(level)
    np.testing.assert_allclose(np.subtract(front.eye, middle) / (4.0 * radius), level, atol=1e-6)
    right = np.subtract(small.view(Camera(90.0, 0.0, 2.0)).eye, middle) / (2.0 * radius)
    np.testing.assert_allclose(right, np.cross((0.0, 1.0, 0.0), level), atol=1e-6)
    above = np.subtract(small.view(Camera(0.0, 30.0, 2.0)).eye, middle) / (2.0 * radius)
    assert abs(above[1] - 0.5) < 1e-6
    assert np.isfinite(small.view(Camera(0.0, 90.0, 2.0)).eye).all()


def test_pictures_from_a_camera_around_the_scene(small: radiosity.Radiosity, tmp_path: Path) -> None:
    camera = Camera(35.0, 20.0, 4.0)
    picture = np.asarray(small.picture(64, camera=camera))
    assert (picture == np.asarray(small.picture(64, camera))).all()
    assert (picture != np.asarray(small.picture(64))).any()
    lit = picture.any(axis=2)
    assert 0.15 < lit.mean() < 0.9
    assert not lit[0].any()  # the whole scene is in the picture
    assert not lit[-1].any()
    small.save(tmp_path / "around.png", size=64, view=camera)
    with Image.open(tmp_path / "around.png") as saved:
        assert (np.asarray(saved) == picture).all()


def test_the_matrix_has_labels_and_a_scale(small: radiosity.Radiosity) -> None:
    picture = np.asarray(small.matrix_picture(200).convert("RGB")).astype(int)
    F = small.factors.matrix / small.patches.area[:, None]
    n = len(F)
    i, j = np.unravel_index(np.argmax(F), F.shape)
    assert picture[52 + int((i + 0.5) * 200 / n), 64 + int((j + 0.5) * 200 / n)].min() > 200
    assert picture[52 + 1, 64 + 200 + 20].min() > 250  # the scale: white on top, black below
    assert picture[52 + 197, 64 + 200 + 20].max() < 10
    assert (picture[20:52, 64:264] < 100).all(axis=2).any()  # numbers of columns


def test_the_automatic_camera_is_where_light_is() -> None:
    """A room with solid walls is seen from inside, one of sheets from outside; the picture is not black."""
    for solid in (False, True):
        b = Builder("room")
        b.add(box((0, 0, 0), (4, 3, 5), inside=True), Material("wall", (0.5,) * 3))
        b.add(box((-0.2, -0.2, -0.2), (4.2, 3.2, 5.2)) if solid else [], Material("brick", (0.5,) * 3))
        b.add([quad((1, 2.99, 1), (3, 2.99, 1), (3, 2.99, 3), (1, 2.99, 3))], Material("lamp", (0.0,) * 3, (5.0,) * 3))
        result = radiosity.solve(b.scene(), 200)
        inside = (np.abs(np.subtract(result.view(0).eye, (2, 1.5, 2.5))) < (2, 1.5, 2.5)).all()
        assert inside == solid
        assert (np.asarray(result.picture(64)) > 20).mean() > 0.2
