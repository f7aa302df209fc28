"""What is read from mesh files, and what is told of the rest."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from glsim.radiosity.load import scene_from
from glsim.radiosity.patches import patches_of
from glsim.radiosity.scene import Builder, Material, Scene, SceneError, box, quad
from glsim.radiosity.textures import texture_of

WALL = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
PICTURE = np.zeros((2, 2, 3), np.uint8)
PICTURE[0], PICTURE[1] = ((255, 0, 0), (0, 255, 0)), ((0, 0, 255), (255, 255, 255))  # upper row, lower row


def written(folder: Path, obj: str, mtl: str = "") -> Scene:
    (folder / "a.mtl").write_text(mtl)
    (folder / "a.obj").write_text("mtllib a.mtl\n" + obj)
    return scene_from(folder / "a.obj")


def glb(folder: Path, mesh: Any, edit: Any = lambda header: None) -> Scene:
    """A trimesh as a GLB file whose JSON was edited."""
    import trimesh

    from glsim.scenes.plain import header_of, with_header

    data = trimesh.Scene(mesh).export(file_type="glb")
    header = header_of(data, "glb")
    edit(header)
    (folder / "a.glb").write_bytes(with_header(data, "glb", header))
    return scene_from(folder / "a.glb")


def sheet(**material: Any) -> Any:
    """A unit square of two triangles, with texture coordinates."""
    import trimesh

    visual = trimesh.visual.TextureVisuals(
        uv=[(0, 0), (1, 0), (1, 1), (0, 1)], material=trimesh.visual.material.PBRMaterial(name="wall", **material)
    )
    return trimesh.Trimesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)], visual=visual,
                           process=False)  # fmt: skip


@pytest.mark.parametrize(
    "text",
    [
        f"{WALL}usemtl A\nf 1 2 3 4\n",
        f"{WALL}usemtl A\nf -4 -3 -2 -1\n",
        f"{WALL}usemtl A\nf\t1\t2\t3\t4\n".replace("v 1 1 0", "v\t1\t1\t0"),
        f"{WALL}usemtl A\nf 1 2 \\\n 3 4\n",
        f"{WALL}vt 0 0\nvn 0 0 1\nusemtl A\nf -4/-1/-1 -3/-1/-1 -2/-1/-1 -1/-1/-1\n",
        f"{WALL}usemtl A\r\n  f 1 2 3 4\r\n",
    ],
)
def test_ways_to_write_one_quad(text: str, tmp_path: Path) -> None:
    behind = "v 0 0 -9\nv 1 0 -9\nv 0 1 -9\nusemtl B\nf 5 6 7\n"  # so that counting backwards is seen to be relative
    scene = written(tmp_path, text + behind, "newmtl A\n\tKd 0.1 0.2 0.3\nKe 3 2 1\nnewmtl B\nKd .5 .5 .5\n")
    polygons = {scene.materials[paint].name: p for p, paint in zip(scene.polygons, scene.material, strict=True)}
    assert {name: len(p) for name, p in polygons.items()} == {"A": 4, "B": 3}
    assert (polygons["A"].min(axis=0) == 0.0).all()
    assert sorted(polygons["A"].sum(axis=1)) == [0, 1, 1, 2]
    (lamp,) = (m for m in scene.materials if m.name == "A")
    assert lamp.rho == (0.1, 0.2, 0.3)
    assert lamp.E == (3.0, 2.0, 1.0)


def test_a_texture_is_the_reflectance(tmp_path: Path) -> None:
    Image.fromarray(PICTURE).save(tmp_path / "p.png")
    text = f"{WALL}vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl A\nf 1/1 2/2 3/3 4/4\n"
    scene = written(tmp_path, text, "newmtl A\nKd 0 0 0\nmap_Kd p.png\n")
    assert scene.notes == ("materials with Kd 0 and map_Kd, whose Kd is taken as 1: 1",)
    corners = [
        quad((x, y, 0), (x + 0.5, y, 0), (x + 0.5, y + 0.5, 0), (x, y + 0.5, 0)) for y in (0.5, 0) for x in (0, 0.5)
    ]
    rho = patches_of(scene, corners, [0] * 4).rho
    np.testing.assert_allclose(rho.reshape(2, 2, 3), np.where(PICTURE > 0, 0.99, 0.0), atol=2e-3)
    whole = patches_of(scene, [scene.polygons[0]], [0]).rho[0]
    np.testing.assert_allclose(whole, 0.495, atol=2e-3)


def test_the_mean_of_a_texture_counts_areas() -> None:
    """A trapezium and a triangle that cover unequal parts of a ramp, against the integral."""
    ramp = np.repeat(np.linspace(0, 255, 256).astype(np.uint8)[None, :, None], 3, axis=2)
    texture = texture_of(ramp)
    b = Builder("ramp")
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    b.add([quad(*((x, y, 0) for x, y in square))], Material("ramp", (0.5,) * 3, texture=texture), st=[square])
    shapes = [quad((0, 0, 0), (1, 0, 0), (1, 0.2, 0), (0, 1, 0)), quad((0, 0, 0), (1, 0, 0), (0, 1, 0))]
    found = patches_of(b.scene(), shapes, [0, 0]).rho[:, 0]
    x = (np.arange(256) + 0.5) / 256
    for value, height in zip(found, (1.0 - 0.8 * x, 1.0 - x), strict=True):
        assert value == pytest.approx(0.5 * np.average(texture.texels[0, :, 0], weights=height), rel=0.01)


def test_colours_of_vertices_and_faces(tmp_path: Path) -> None:
    import trimesh

    colored = WALL.replace("0 0\n", "0 0 1 0 0\n", 1).replace("v 1 1 0", "v 1 1 0 0 0 1")
    text = (
        colored.replace("v 1 0 0\n", "v 1 0 0 0 1 0\n").replace("v 0 1 0\n", "v 0 1 0 1 1 1\n") + "f 1 2 3\nf 1 3 4\n"
    )
    (tmp_path / "a.obj").write_text(text)
    rho = {tuple(np.round(m.rho, 3)) for m in scene_from(tmp_path / "a.obj").materials}
    assert rho == {(0.333, 0.333, 0.333), (0.667, 0.333, 0.667)}
    faces = trimesh.creation.box()
    faces.visual.face_colors = np.repeat(np.array([[51, 102, 204, 255], [255, 0, 0, 255]], np.uint8), 6, axis=0)
    faces.export(tmp_path / "b.ply")
    rho = {tuple(np.round(m.rho, 3)) for m in scene_from(tmp_path / "b.ply").materials}
    assert rho == {(0.2, 0.4, 0.8), (0.99, 0.0, 0.0)}


def test_what_gltf_says(tmp_path: Path) -> None:
    def edit(header: Any) -> None:
        header["materials"][0]["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": 8.0}}
        header["extensionsUsed"] = ["KHR_materials_emissive_strength", "KHR_lights_punctual"]
        header["cameras"] = [{"type": "perspective", "perspective": {"yfov": np.pi / 3}}]
        turn = [0.0, 2**-0.5, 0.0, 2**-0.5]  # a quarter around y: it looks along -x
        header["nodes"] += [{"name": "eye", "camera": 0, "translation": [0, 0, 1]}]
        header["nodes"] += [{"translation": [5, 2, 0], "rotation": turn, "children": [len(header["nodes"]) - 1]}]
        header["scenes"][0]["nodes"].append(len(header["nodes"]) - 1)

    mesh = sheet(emissiveFactor=(1.0, 0.5, 0.25), doubleSided=True, alphaMode="BLEND", baseColorFactor=(0.5,) * 4)
    scene = glb(tmp_path, mesh, edit)
    assert scene.materials[0].E == (8.0, 4.0, 2.0)
    assert [len(polygon) for polygon in scene.polygons] == [4, 4]
    assert scene.checked().normals[:, 2].tolist() == [1.0, -1.0]
    assert scene.notes == (
        "transparent materials, taken as opaque: 1",
        "parts of the file that radiosity does not use: KHR_lights_punctual",
    )
    (view,) = scene.views
    np.testing.assert_allclose(view.eye, (6, 2, 0), atol=1e-12)
    np.testing.assert_allclose(view.target, (5, 2, 0), atol=1e-12)
    assert view.name == "eye"
    assert view.fov == pytest.approx(60.0)


def test_a_textured_sheet_of_gltf(tmp_path: Path) -> None:
    scene = glb(tmp_path, sheet(baseColorTexture=Image.fromarray(PICTURE), baseColorFactor=(0.5, 1.0, 1.0, 1.0)))
    np.testing.assert_allclose(patches_of(scene, [scene.polygons[0]], [0]).rho[0], (0.25, 0.495, 0.495), atol=3e-3)


def test_what_is_missing_or_left_out_is_told(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text(f"mtllib no.mtl\n{WALL}usemtl A\nf 1 2 3 4\n")
    assert scene_from(tmp_path / "a.obj").notes == ("files that are not in its folder: no.mtl",)
    scene = written(tmp_path, f"{WALL}usemtl A\nf 1 2 3 4\n", "newmtl A\nKd 1 1 1\nKs 1 1 1\nd 0.3\nmap_Kd no.png\n")
    assert scene.notes == (
        "transparent materials, taken as opaque: 1", "materials with Ks, which reflect diffusely alone: 1",
        "files that are not in its folder: no.png",
    )  # fmt: skip


def test_exitances_and_second_sides_by_name(tmp_path: Path) -> None:
    text = f"{WALL}usemtl A\nf 1 2 3 4\n"
    written(tmp_path, text, "newmtl A\nKd .5 .5 .5\n")
    scene = scene_from(tmp_path / "a.obj", emit={"A": (3.0, 2.0, 1.0)}, two_sided=True).checked()
    assert scene.materials[0].E == (3.0, 2.0, 1.0)
    assert scene.normals[:, 2].tolist() == [1.0, -1.0]
    b = Builder("box")
    b.add(box((0, 0, 0), (1, 1, 1)), Material("paint", (0.5,) * 3))
    assert len(b.scene().two_sided().polygons) == 6
    with pytest.raises(SceneError, match=r"a.obj has no material named lamp; it has A"):
        scene_from(tmp_path / "a.obj", emit={"lamp": (1.0, 1.0, 1.0)})


@pytest.mark.parametrize("st", [None, [[(0, 0), (1, 0), (1, 1)]], [[(0, 0), (1, 0), (5, 5), (0, 1)]]])
def test_texture_coordinates_that_do_not_fit(st: Any) -> None:
    b = Builder("picture")
    with pytest.raises(SceneError, match="texture"):
        b.add(
            [quad((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))],
            Material("p", (1, 1, 1), texture=texture_of(PICTURE)),
            st=st,
        )
