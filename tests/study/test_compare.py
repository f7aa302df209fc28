"""glsim.compare and the command line."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

import glsim
from glsim.cli import main
from glsim.gl import *
from glsim.render.native import Native
from glsim.scenes import Camera, Lamp
from glsim.study.compare import compare


def test_modes_and_lobes_differ_where_they_must() -> None:
    result = compare("sphere:10", size=96)
    assert set(result.images) == {(lobe, mode) for lobe in ("blinn", "phong") for mode in ("flat", "gouraud", "phong")}
    background = result.images["blinn", "flat"][0, 0]
    silhouettes = {(picture != background).any(axis=2).sum() for picture in result.images.values()}
    assert len(silhouettes) == 1, "shading changes no coverage"
    brightest = {key: int(picture.max()) for key, picture in result.images.items()}
    assert brightest["blinn", "phong"] > brightest["blinn", "gouraud"]
    assert result.difference("phong", "phong").max() == 0, "what the others approximate is the reference"
    assert result.difference("blinn", "gouraud").max() > 20
    flat, smooth = (len(np.unique(result.images["blinn", m].reshape(-1, 3), axis=0)) for m in ("flat", "phong"))
    assert flat < 60 < smooth


def test_a_drawing_function() -> None:
    def two_triangles() -> None:
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glBegin(GL_TRIANGLES)
        for k, (x, y) in enumerate(((-1, -1), (1, -1), (0, 1))):
            glNormal3f(0.4 * k, 0, (1 - 0.16 * k * k) ** 0.5)
            glVertex2f(x, y)
        glEnd()

    result = compare(two_triangles, size=64, lobes=["blinn"], modes=["flat", "gouraud", "wireframe", "unlit"])
    assert result.title == "two_triangles"
    assert len(np.unique(result.images["blinn", "flat"].reshape(-1, 3), axis=0)) == 2
    assert len(np.unique(result.images["blinn", "gouraud"].reshape(-1, 3), axis=0)) > 20
    plain = result.images["blinn", "unlit"]
    assert plain[40, 32].tolist() == [204, 204, 204]
    wires = (result.images["blinn", "wireframe"].any(axis=2)).sum()
    assert 100 < wires < 260 < plain.any(axis=2).sum()
    with pytest.raises(ValueError, match="a drawing function sets its own lights"):
        compare(two_triangles, material="brass")


def test_wireframe_has_no_diagonals() -> None:
    picture = compare("cube", size=128, lobes=["blinn"], modes=["wireframe"], camera=Camera(0, 0, 4)).images
    inside = picture["blinn", "wireframe"][60:68, 60:68]
    assert (inside == inside[0, 0]).all()


def test_the_native_column(native: Native) -> None:
    result = compare("torus", size=128, lobes=["blinn"], modes=["gouraud", "native"])
    assert result.reference == "native"
    d = result.difference("blinn", "gouraud").max(axis=2)
    assert (d <= 1).mean() >= 0.999


def test_lights_material_camera_are_used() -> None:
    def brightest(**options: object) -> np.ndarray:
        return compare("sphere", size=48, lobes=["blinn"], modes=["phong"], **options).images["blinn", "phong"]

    usual = brightest()
    left = brightest(lights=[Lamp((-1.0, 0.0, 0.2, 0.0))])
    assert left[24, 12].sum() > left[24, 36].sum()
    assert brightest(material="emerald")[24, 24].argmax() == 1
    assert not np.array_equal(usual, brightest(camera=Camera(0, 0, 8)))


def test_a_trimesh_is_taken() -> None:
    result = compare(trimesh.creation.capsule(), size=48, lobes=["blinn"], modes=["gouraud"])
    assert result.images["blinn", "gouraud"].max() > 100


def test_a_function_that_draws_nothing_here_is_told() -> None:
    def draw() -> None:
        own = glsim.offscreen(16, 16)
        glClear(GL_COLOR_BUFFER_BIT)
        own.pixels()

    with pytest.raises(ValueError, match="draw draws nothing here: does it open a context of its own"):
        compare(draw, size=32)


def test_fixed_function_has_one_lobe(native: Native) -> None:
    result = compare("cube", size=48, modes=["gouraud", "native"])
    assert ("blinn", "native") in result.images
    assert ("phong", "native") not in result.images
    assert result.sheet.size[0] > 96


def test_the_current_context_is_put_back(screen: glsim.Offscreen) -> None:
    glColor3f(0.25, 0, 0)
    compare("cube", size=32, lobes=["blinn"], modes=["flat"])
    assert glGetFloatv(GL_CURRENT_COLOR)[0] == 0.25


def test_sheet_and_save(tmp_path: Path) -> None:
    result = compare("cube", size=64, lobes=["blinn"])
    assert result._repr_png_().startswith(b"\x89PNG")
    result.save(tmp_path / "sheet.png")
    with Image.open(tmp_path / "sheet.png") as sheet:
        assert sheet.size[0] > 3 * 64
    assert [path.name for path in tmp_path.iterdir()] == ["sheet.png"]
    with pytest.raises(FileNotFoundError, match="there is no folder"):
        result.save(tmp_path / "no" / "sheet.png")
    with pytest.raises(ValueError, match="unknown file extension"):
        result.save(tmp_path / "sheet.what")
    assert [path.name for path in tmp_path.iterdir()] == ["sheet.png"]


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (dict(modes=["flat", "ray"]), "modes are wireframe, .* not ray"),
        (dict(lobes=["cook"]), "lobes are blinn, phong, not cook"),
        (dict(modes=[]), "not none"),
        (dict(material="cheese"), "there is no material"),
    ],
)
def test_wrong_options_get_a_sentence(options: dict[str, object], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        compare("cube", size=32, **options)


# ---------------------------------------------------------------- command line


def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "sheet.png"
    assert main(["compare", "cube", "--size", "32", "--modes", "flat,phong", "-o", str(output), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["status"] == "ok"
    assert report["differences"][1] == {"lobe": "blinn", "mode": "phong", "max": 0, "mean": 0.0}
    assert report["metrics"][1].keys() >= {"lobe", "mode", "reference", "max", "mean", "rmse", "different", "ssim"}
    assert output.exists()
    words = ["compare", "sphere:8", "--size", "32", "--light", "1,2,3", "--light", "0,0,5,1,0.5", "-o", str(output)]
    assert main([*words, "--camera", "10,20,5", "--material", "jade", "--lobe", "phong"]) == 0
    assert "wrote" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [
        (["compare", "nosuch.obj"], 1, "there is no such file"),
        (["compare", "cube", "--modes", "x"], 1, "modes are"),
        (["compare", "cube", "-o", "noext"], 1, "noext: the name must end in .png"),
        (["compare", "cube", *["--light", "-.5,1,1"] * 9], 1, "at most 8 lights, not 9"),
        (["compare"], 2, "name a scene or a mesh file"),
        (["compare", "cube", "--size", "9999999"], 2, "a number of pixels from 16 to 4096"),
        (["compare", "cube", "--light", "1,2"], 2, "3 to 5 numbers are needed"),
        (["compare", "cube", "--camera", "1,2,0.5"], 2, "more than 1 radius"),
        (["nonsense"], 2, "invalid choice"),
        ([], 2, "required"),
    ],
)
def test_command_errors(words: list[str], code: int, sentence: str, capsys: pytest.CaptureFixture[str]) -> None:
    try:
        result = main(words)
    except SystemExit as stop:
        result = int(stop.code or 0)
    assert result == code
    assert sentence in capsys.readouterr().err


def test_errors_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["compare", "nosuch.obj", "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["status"] == "error"


def test_list(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["compare", "--list"]) == 0
    assert "teapot" in capsys.readouterr().out
    assert main(["compare", "--list", "--json"]) == 0
    assert "brass" in json.loads(capsys.readouterr().out)["materials"]
