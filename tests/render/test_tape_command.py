"""``glsim tape`` and ``glsim draw``: what they write, what they say, how they end."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.cli import main
from glsim.render.context import drawn
from glsim.render.tape import Tape


def said(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    code = main(words)
    out, err = capsys.readouterr()
    return code, out, err


def test_there_and_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, _ = said(capsys, "tape", "teapot", "--size", "64", "-o", "a.glt")
    length = Path("a.glt").stat().st_size
    assert (code, out) == (0, f"wrote a.glt: 64 x 64 pixels, {length} bytes\n")
    code, out, _ = said(capsys, "draw", "a.glt", "-o", "a.png")
    assert (code, out) == (0, f"wrote a.png: picture 0 of 1, by glsim {glsim.__version__}\n")
    wanted = drawn(glsim.frame_of("teapot", size=64))[..., :3]
    assert np.array_equal(np.asarray(Image.open("a.png")), wanted)
    assert glsim.tape(glsim.frame_of("teapot", size=64)) == Path("a.glt").read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.glt", "a.png"]


def test_samples_and_json(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, _ = said(capsys, "tape", "sphere", "--size", "32", "--samples", "4", "--json")
    assert (code, json.loads(out)["output"]) == (0, "picture.glt")
    assert Tape.from_bytes(Path("picture.glt").read_bytes()).samples == 4
    code, out, _ = said(capsys, "draw", "picture.glt", "--json")
    assert code == 0
    made_by = f"glsim {glsim.__version__}"
    assert json.loads(out) == {
        "status": "ok", "output": "picture.png", "picture": "picture", "pictures": 1, "made_by": made_by,
    }  # fmt: skip


@pytest.mark.slow
def test_a_program_that_fails_leaves_what_it_drew(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    script, target = tmp_path / "half.py", tmp_path / "half.glt"
    script.write_text("""
import glsim
from glsim.gl import *
screen = glsim.offscreen(32, 32)
glRectf(-0.5, -0.5, 0.5, 0.5)
glFlush()
1 / 0
""")
    code, _, err = said(capsys, "tape", str(script), "-o", str(target))
    assert code == 1
    assert "ended early (line 7): ZeroDivisionError" in err
    assert any(operation[0] == "draw" for operation in Tape.from_bytes(target.read_bytes()).pictures[0].operations)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["draw", "none.glt"], "none.glt"),
        (["draw", "text.glt"], "text.glt: these bytes are no tape of glsim"),
        (["draw", "text.glt", "-o", "x.foo"], "x.foo: the name must end in .png"),
        (["draw", "text.glt", "-o", "no/x.png"], "there is no folder no; make it first"),
        (["draw", "good.glt", "--picture", "7"], "good.glt: this tape has no picture 7: it holds 1, numbered from 0"),
        (["tape", "teapto"], "did you mean 'teapot'?"),
        (["tape", "teapot", "-o", "no/x.glt"], "there is no folder no; make it first"),
        (["tape", "teapot", "--frame", "1"], "--frame is for programs"),
    ],
)
def test_what_cannot_be_done_is_said(
    words: list[str], sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    Path("text.glt").write_text("no tape, but a text of some length")
    good = glsim.tape(glsim.Frame(8, 8))
    Path("good.glt").write_bytes(good)
    code, out, err = said(capsys, *words)
    assert (code, out) == (1, "")
    assert sentence in err
    code, out, _ = said(capsys, *words, "--json")
    assert code == 1
    assert sentence in json.loads(out)["error"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["good.glt", "text.glt"]


def test_samples_that_no_tape_has() -> None:
    with pytest.raises(ValueError, match="a tape has 0, 2, 4, 8, 16, 32 samples, not 3"):
        glsim.tape(glsim.Frame(8, 8), samples=3)
