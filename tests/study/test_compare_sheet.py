"""The numbers, the sheet and the page of a comparison."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.cli import main
from glsim.cli.compare import EPILOG
from glsim.metrics import amplified
from glsim.study.axes import SWEEPABLE
from glsim.study.compare import compare
from glsim.study.equations import equations, grid
from glsim.study.looks import truest as truest_of
from glsim.study.sheet import written
from glsim.web.page import typeset


def test_metrics_by_hand() -> None:
    a = np.zeros((12, 20, 3), np.uint8)
    b = a.copy()
    b[2:5, 3:7] = (10, 0, 40)
    result = compare({"a": a, "b": b})
    row = result.metrics[1]
    assert (row["picture"], row["reference"], row["max"]) == ("b", "a", 40)
    assert row["mean"] == pytest.approx(12 * 50 / (12 * 20 * 3))
    assert row["rmse"] == pytest.approx((12 * (100 + 1600) / (12 * 20 * 3)) ** 0.5)
    assert row["different"] == pytest.approx(12 / 240)
    assert result.metrics[0]["ssim"] == 1.0 > row["ssim"]
    assert result.statistics()[1] == {"picture": "b", "max": 40, "mean": round(600 / 720, 4)}
    assert json.loads(json.dumps(result.metrics)) == result.metrics


def test_differences_are_amplified_and_clamped() -> None:
    d = np.array([[[0, 3, -3], [100, -100, 255]]], np.int16)
    assert amplified(d, 8).tolist() == [[[0, 24, 24], [255, 255, 255]]]
    a = np.full((64, 64, 3), 100, np.uint8)
    b = a + np.uint8(5)
    sheet = np.asarray(compare({"a": a, "b": b}, differences="x8").sheet)
    assert (sheet == 40).all(axis=2).sum() > 200
    off = np.asarray(compare({"a": a, "b": b}, differences="off").sheet)
    assert not (off == 40).all(axis=2).any()
    assert off.shape[0] < sheet.shape[0]


@pytest.mark.parametrize(("largest", "factor"), [(255, 1), (254, 2), (128, 2), (5, 64), (1, 64), (0, 1)])
def test_differences_are_amplified_until_the_largest_is_white(largest: int, factor: int) -> None:
    dark = np.zeros((32, 32, 3), np.uint8)
    result = compare({"dark": dark, "a little": dark + np.uint8(largest // 2), "most": dark + np.uint8(largest)})
    assert result.amplified == factor
    assert [result.difference_words("", name)[0] for name in ("a little", "most")] == [f"difference x{factor}"] * 2
    assert result.strips()[0].gain == factor
    assert (np.asarray(result.sheet) == min(factor * largest, 255)).all(axis=2).sum() > 50


def test_the_reference() -> None:
    """Without being told, the one that the others approximate."""
    for modes, truest in (("wireframe,unlit,flat,phong:flip,phong", "phong:flip"), ("flat,gouraud", "gouraud"),
                          ("hidden-line,unlit", "hidden-line")):  # fmt: skip
        assert compare("cube", modes=modes, lobes="blinn", size=32).reference == truest
    assert truest_of(["gouraud", "phong", "direct", "radiosity", "pyrender"]) == "radiosity"
    assert truest_of(["expected.png", "actual.png"]) == "expected.png"
    result = compare("cube", modes="wireframe,flat,gouraud,phong", lobes="blinn", size=32, reference="smooth")
    assert {row["reference"] for row in result.metrics} == {"gouraud"}
    assert result.difference("blinn", "gouraud").max() == 0
    assert [result.has_difference("blinn", name) for name in result.columns.names] == [False, True, False, True]


@pytest.mark.parametrize(("layout", "ratio"), [("projector", 16 / 9), ("paper", 2**-0.5), ("paper", 2**0.5)])
def test_pages_are_filled(layout: str, ratio: float) -> None:
    segments = [4, 8, 12, 16] if ratio < 1 else [8]
    sheet = compare("sphere", modes="gouraud,phong", segments=segments, size=64, layout=layout).sheet
    assert sheet.width / sheet.height == pytest.approx(ratio, abs=0.01)
    ink = (np.asarray(sheet).astype(int).sum(axis=2) < 600).any(axis=1)
    assert ink.mean() > 0.6


def test_indices_and_exponents() -> None:
    assert typeset("w_1 k_d <(N·L)^n") == "w<sub>1</sub> k<sub>d</sub> &lt;(N·L)<sup>n</sup>"
    for name in ("test_a", "a_b.png", "GL_LIGHT_0", "k_dd", "x/a_b", "a ^ b"):
        assert typeset(name) == name, "no symbol of a formula"
    assert written("k_d", 20).width < written("kd", 20).width < written("k d", 20).width
    assert not np.array_equal(np.asarray(written("k_d", 20)), np.asarray(written("k^d", 20)))
    assert written("file_name.png", 20).width > written("filename.png", 20).width


def test_captions_and_title_are_drawn() -> None:
    plain_sheet, told = (
        np.asarray(compare("cube", modes="flat,phong", lobes="blinn", size=128, **options).sheet)
        for options in ({}, {"captions": {"phong": "as in 1975"}, "title": "a lamp"})
    )
    assert told.shape[0] > plain_sheet.shape[0]


@pytest.fixture
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few equations, for tests of other things."""
    monkeypatch.setattr("glsim.study.equations.POINTS", 5)


def test_equations_are_the_probes() -> None:
    cells = compare("sphere:6", modes="wireframe,gouraud,phong", lobes="blinn", size=10).cells
    said: list[str] = []
    found = equations(cells, said.append)
    assert set(found) == {("blinn", "gouraud"), ("blinn", "phong")}
    assert said[-1] == "equations of picture 2 of 2"
    cell = cells["blinn", "phong"]
    assert cell.frame is not None
    assert cell.pixels is not None
    points = grid(cell.frame, cell)
    assert 20 < len(points) < 100
    (x, y), text = next(iter(found["blinn", "phong"].items()))
    assert text.endswith("8 bits: ({}, {}, {})".format(*cell.pixels[y, x]))
    light = glsim.probe(cell.frame, x, y).winner.evaluations[0].lights[0]
    assert f"N·L = {light.N_L:.3f}" in text
    assert found["blinn", "gouraud"][x, y].count("at the vertex") == 3


@pytest.mark.slow
def test_large_meshes_have_fewer_equations() -> None:
    cell = compare("teapot:32", modes="phong", lobes="blinn", size=128).cells["blinn", "phong"]
    assert cell.frame is not None
    assert len(grid(cell.frame, cell)) < 20


def test_notebooks_and_pages_show_the_element(tmp_path: Path, coarse: None) -> None:
    result = compare("cube", modes="gouraud,native", lobes="blinn,phong", size=32, captions={"gouraud": "<b>"})
    assert result._repr_html_().count("</glsim-compare>") == 2
    result.save(tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text()
    assert text.count("</glsim-compare>") == 2
    assert "&lt;b&gt;" in text
    assert "fixed function has (N·H)<sup>n</sup> only" in text
    assert "I(N) = k<sub>a</sub> I<sub>a</sub> +" in text
    assert "N·L = " in text
    assert [path.name for path in tmp_path.iterdir()] == ["page.html"]
    with pytest.raises(FileNotFoundError, match="there is no folder"):
        result.save(tmp_path / "no" / "page.html")
    with pytest.raises(ValueError, match=r"x.gif: .*animate"):
        result.save(tmp_path / "x.gif")


def test_pyrender_draws_all_its_cells_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []

    def pictures(what: list[object], width: int, height: int, *, samples: int, note: object) -> list[np.ndarray]:
        asked.append(len(what))
        note("something is left out")  # type: ignore[operator]
        return [np.full((height, width, 3), k, np.uint8) for k in range(len(what))]

    monkeypatch.setattr("glsim.study.pyrender.pictures", pictures)
    result = compare("cube", modes="phong,pyrender", sweep={"material": "jade,ruby"}, size=32)
    assert asked == [2]
    assert [result.images[row, "pyrender"][0, 0, 0] for row in ("jade", "ruby")] == [0, 1]
    assert result.notes == ["something is left out"]
    assert compare("cube", modes="phong,pyrender", size=32).rows.names == ["blinn"], "it has one lobe"
    both = compare("cube", modes="phong,pyrender", lobes="blinn,phong", size=32)
    assert asked == [2, 1, 1]
    assert set(both.images) == {("blinn", "phong"), ("blinn", "pyrender"), ("phong", "phong")}
    assert both.cells["phong", "pyrender"].words == "pyrender has one lobe only, drawn once"
    assert set(compare("cube", modes="pyrender", lobes="phong", size=32).images) == {("phong", "pyrender")}


# ---------------------------------------------------------------- command line


def test_the_help_names_every_axis(capsys: pytest.CaptureFixture[str]) -> None:
    named = set(re.findall(r"(\w+)=", EPILOG))
    assert set(SWEEPABLE) <= named
    with pytest.raises(SystemExit):
        main(["compare", "--help"])
    assert "--sweep" in capsys.readouterr().out


def test_all_outputs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, coarse: None
) -> None:
    monkeypatch.chdir(tmp_path)
    words = ["compare", "sphere:6", "--segments", "4,6", "--modes", "gouraud,phong", "--size", "32", "--json"]
    more = ["--caption", "gouraud=as in 1971", "--title", "spheres", "--columns", "segments", "--differences", "off"]
    assert main([*words, *more, "--gif", "a.gif", "--frames", "2", "--html", "a.html", "-o", "a.png"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["outputs"] == ["a.png", "a.gif", "a.html"]
    assert {row["segments"] for row in told["metrics"]} == {"4", "6"}
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.gif", "a.html", "a.png"]
    assert "<h1>spheres" in Path("a.html").read_text()
    assert main([*words, "--html", "only.html"]) == 0
    assert not Path("compare.png").exists()


def test_pictures_on_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, value in (("a", 10), ("b", 30)):
        Image.new("RGB", (40, 30), (value, 0, 0)).save(tmp_path / f"{name}.png")
    words = ["compare", str(tmp_path / "a.png"), str(tmp_path / "b.png"), "-o", str(tmp_path / "out.png")]
    assert main([*words, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["metrics"][1]["max"] == 20
    assert main(["compare", "cube", words[1], *words[3:], "--modes", "flat", "--size", "32"]) == 0
    assert "a.png and flat have 40 x 30 and 32 x 32 pixels" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["nosuch", "-o", "a.txt"], "a.txt: the name must end in .png"),
        (["nosuch", "--html", "a.png"], "--html a.png: the name must end in .html"),
        (["nosuch", "--gif", "a.png"], "--gif a.png: the name must end in .gif"),
        (["nosuch", "--html", "no/a.html"], "there is no folder no"),
        (["nosuch", "-o", "a.gif", "--gif", "a.gif"], "two outputs have this name"),
        (["nosuch", "--animate", "light"], "--animate needs --gif FILE"),
        (["cube", "sphere"], "one scene or program at a time, not cube and sphere"),
        (["cube", "--sweep", "shininess"], "--sweep shininess: NAME=... is needed"),
        (["cube", "--samples", "3"], "samples must be one of"),
        (["nosuch.png"], "nosuch.png: there is no such picture"),
    ],
)
def test_names_are_checked_before_any_work(
    words: list[str], sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["compare", *words]) == 1
    assert sentence in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
