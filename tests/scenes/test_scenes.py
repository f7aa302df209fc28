"""Built-in shapes, normals, mesh files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh

from glsim.scenes import BUILT_IN, MATERIALS, MeshError, material, open_scene
from glsim.scenes.load import from_trimesh, load
from glsim.scenes.mesh import Mesh, unit, with_normals
from glsim.scenes.shapes import patches, sphere, teapot, torus
from glsim.study.compare import compare


def area_vectors(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Area vector of each face and the sum of its corners' normals."""
    areas, normals = [], []
    for faces in (mesh.triangles, mesh.quads):
        corners = mesh.positions[faces]
        areas.append(np.cross(corners[:, 1] - corners[:, 0], corners[:, -1] - corners[:, 0]))
        normals.append(mesh.normals[faces].sum(axis=1))
    return np.concatenate(areas), np.concatenate(normals)


@pytest.mark.parametrize("name", BUILT_IN)
def test_shapes_are_wound_as_their_normals_say(name: str) -> None:
    meshes = open_scene(name).meshes
    assert meshes
    for mesh in meshes:
        assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-5)
        areas, normals = area_vectors(mesh)
        assert (np.einsum("ij,ij->i", areas, normals) > 0).all()
        assert np.abs(mesh.positions).max() <= 1.0001


def test_teapot_is_the_published_one() -> None:
    control = patches()
    assert control.shape == (32, 4, 4, 3)
    assert control[..., 2].min() == 0
    assert control[..., 2].max() == 3.15
    assert control[..., 0].min() == -3
    assert control[..., 0].max() == 3.525
    mesh = teapot(4)
    assert len(mesh.quads) + len(mesh.triangles) == 32 * 16
    size = mesh.positions.max(axis=0) - mesh.positions.min(axis=0)
    assert np.allclose(size * 1.5, (6.43, 3.15, 4.0), atol=0.02)


def test_sphere_and_torus_lie_where_they_should() -> None:
    assert np.allclose(np.linalg.norm(sphere(20).positions, axis=1), 1, atol=1e-6)
    assert len(sphere(20).triangles) == 40
    x, y, z = torus(12).positions.T
    assert np.allclose((np.hypot(x, z) - 1) ** 2 + y**2, 0.16, atol=1e-5)


def test_materials_of_the_literature() -> None:
    assert {"brass", "bronze", "polished-gold", "emerald", "jade", "ruby", "pearl", "obsidian"} <= set(MATERIALS)
    assert len(MATERIALS) == 29
    assert material("Polished Gold") == MATERIALS["polished-gold"]
    assert material("brass").diffuse == (0.780392, 0.568627, 0.113725, 1.0)
    with pytest.raises(ValueError, match="there is no material 'cheese'; the names are emerald"):
        material("cheese")


# ---------------------------------------------------------------- normals


def test_smooth_surfaces_get_smooth_normals_and_boxes_keep_their_edges() -> None:
    ball = trimesh.creation.icosphere(subdivisions=3)
    mesh = with_normals(ball.vertices, ball.faces.astype("u4"))
    assert np.abs(mesh.normals - mesh.positions).max() < 0.02
    box = trimesh.creation.box()
    mesh = with_normals(box.vertices, box.faces.astype("u4"))
    assert len(mesh.positions) == 36
    assert np.allclose(np.abs(mesh.normals).max(axis=1), 1)


def test_at_a_crease_a_corner_keeps_the_mean_of_its_own_side() -> None:
    """The side of a tin is as round at its rim as in its middle, and the lid is flat."""
    tin = trimesh.creation.cylinder(1, 2, sections=12)
    mesh = with_normals(tin.vertices, tin.faces.astype("u4"))
    side = np.repeat(np.abs(np.asarray(tin.face_normals)[:, 2]) < 0.5, 3)
    assert side.sum() == 24 * 3
    assert np.allclose(mesh.normals[~side], np.sign(mesh.positions[~side]) * [0, 0, 1], atol=1e-6)
    assert np.allclose(mesh.normals[side], mesh.positions[side] * [1, 1, 0], atol=1e-6)
    faceted = with_normals(tin.vertices, tin.faces.astype("u4"), crease=29)
    assert np.allclose(faceted.normals.reshape(-1, 3, 3), np.asarray(tin.face_normals)[:, None], atol=1e-6)


@pytest.mark.parametrize("crease", [10, 40, 75, 180])
def test_normals_are_those_of_lesson_21(crease: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Weighted with angles within the crease, evaluated pair by pair."""
    monkeypatch.setattr("glsim.scenes.mesh.BLOCK", 50)
    rng = np.random.default_rng(3)
    ball = trimesh.creation.icosphere(subdivisions=2)
    points = (np.asarray(ball.vertices) * (1 + 0.3 * rng.random((len(ball.vertices), 1)))).astype(np.float32)
    faces = np.concatenate([ball.faces, [[0, 0, 5]]]).astype(np.uint32)  # the last has no area
    corner = points[faces].astype(float)
    to_next, to_last = (unit(np.roll(corner, shift, axis=1) - corner) for shift in (-1, 1))
    face = unit(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]))
    weights = np.arccos(np.clip((to_next * to_last).sum(axis=2), -1, 1))
    meet = faces[:, :, None, None] == faces
    close = face @ face.T >= np.cos(np.radians(crease)) - 1e-9
    close[-1] = True  # without a normal of its own it takes all
    expected = unit(np.einsum("acbd,ab,bd,bk->ack", meet, close, weights, face))
    mesh = with_normals(points, faces, crease)
    assert np.allclose(mesh.normals[mesh.triangles], expected, atol=1e-6)
    assert (len(mesh.positions) == len(points)) is (crease == 180)


@pytest.mark.parametrize("name", BUILT_IN)
def test_built_in_scenes_show_what_they_are_for(name: str) -> None:
    """Flat, Gouraud and Phong differ so that one sees it, with either lobe, and nothing is cut at the edges."""
    sheet = compare(name, size=128)
    for lobe in ("blinn", "phong"):
        flat, gouraud, phong = (sheet.images[lobe, mode].astype(int) for mode in ("flat", "gouraud", "phong"))
        assert abs(gouraud - flat).max() > 30, lobe
        between = abs(phong - gouraud).max()
        assert between < 24 if name == "terrain" else between > 40, lobe  # terrain is so fine that they agree
        edge = np.concatenate([phong[0], phong[-1], phong[:, 0], phong[:, -1]])
        assert (edge == edge[0]).all(), lobe


# ---------------------------------------------------------------- files


@pytest.mark.parametrize("kind", ["obj", "ply", "stl", "glb", "off"])
def test_every_format(kind: str, tmp_path: Path) -> None:
    path = tmp_path / f"ball.{kind}"
    ball = trimesh.creation.icosphere(subdivisions=2, radius=40)
    ball.apply_translation((100, 7, -3))
    ball.export(path)
    (mesh,) = load(path)
    assert len(mesh.triangles) == 320
    assert np.allclose(np.linalg.norm(mesh.positions, axis=1), 1, atol=0.01)
    assert np.einsum("ij,ij->i", mesh.positions, mesh.normals).min() > 0.98


def test_materials_and_colors_are_mapped(tmp_path: Path) -> None:
    red = trimesh.creation.box()
    red.visual = trimesh.visual.TextureVisuals(
        material=trimesh.visual.material.PBRMaterial(baseColorFactor=[255, 0, 0, 255], roughnessFactor=0.5)
    )
    red.export(tmp_path / "red.glb")
    (mesh,) = load(tmp_path / "red.glb")
    assert mesh.material is not None
    assert mesh.material.diffuse == (1, 0, 0, 1)
    assert mesh.material.shininess == pytest.approx(2 / 0.5**4 - 2)
    painted = trimesh.creation.box()
    painted.visual.vertex_colors = np.tile([[0, 255, 0, 255]], (8, 1))
    painted.export(tmp_path / "painted.ply")
    (mesh,) = load(tmp_path / "painted.ply")
    assert mesh.colors is not None
    assert len(mesh.colors) == len(mesh.positions)
    assert mesh.colors[0].tolist() == [0, 1, 0, 1]
    faces = trimesh.creation.box()
    faces.visual.face_colors = np.arange(48).reshape(12, 4)
    faces.export(tmp_path / "faces.ply")
    assert len(load(tmp_path / "faces.ply")[0].positions) == 36


def write(path: Path, text: str) -> Path:
    path.write_text(text)
    return path


TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("empty.obj", "", "has no triangles to draw|cannot be read"),
        ("points.obj", TRIANGLE, "has no triangles to draw|cannot be read"),
        ("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "1 of 1 triangles have NaN"),
        ("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "all 1 triangles are degenerate"),
        ("broken.glb", "this is no GLB", "cannot be read as a GLB file"),
        ("broken.stl", "solid nonsense", "cannot be read as a STL file|has no triangles"),
        ("what.xyzzy", "?", "cannot be read as a XYZZY file"),
    ],
)
def test_bad_files_get_a_sentence(tmp_path: Path, name: str, text: str, sentence: str) -> None:
    with pytest.raises(MeshError, match=sentence) as caught:
        load(write(tmp_path / name, text))
    assert name in str(caught.value)


def test_missing_files_and_names() -> None:
    with pytest.raises(MeshError, match=r"nosuch.obj: there is no such file, and the built-in scenes are teapot"):
        open_scene("nosuch.obj")
    with pytest.raises(ValueError, match="the number of slices must be from 1 to 2000, not 'x'"):
        open_scene("sphere:x")


@pytest.mark.parametrize(("shift", "scale"), [((4.5e5, 5.4e6, 300), 1.0), ((0, 0, 0), 1e-30), ((0, 0, 0), 1e30)])
def test_far_away_and_of_extreme_size(shift: tuple[float, ...], scale: float) -> None:
    ball = trimesh.creation.icosphere(subdivisions=2)
    ball.vertices = ball.vertices * scale + shift
    (mesh,) = from_trimesh([ball], "ball")
    assert np.allclose(np.linalg.norm(mesh.positions, axis=1), 1, atol=0.01)
    assert np.einsum("ij,ij->i", mesh.positions, mesh.normals).min() > 0.98


def test_faces_without_vertices() -> None:
    ball = trimesh.Trimesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 9)], process=False)
    with pytest.raises(MeshError, match="uses vertex 9, but there are 3 vertices"):
        from_trimesh([ball], "ball")
    with pytest.raises(MeshError, match="has no triangles"):
        from_trimesh([trimesh.Trimesh()], "nothing")


def test_degenerate_triangles_are_left_out(tmp_path: Path) -> None:
    path = write(tmp_path / "mixed.obj", TRIANGLE + "v 2 0 0\nf 1 2 3\nf 1 2 4\n")
    (mesh,) = load(path)
    assert len(mesh.triangles) == 1
    assert np.isfinite(mesh.normals).all()
