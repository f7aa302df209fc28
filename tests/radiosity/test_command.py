"""The command glsim radiosity."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from glsim.radiosity.compiled import is_cached
from glsim.radiosity.pairs import rows
from glsim.radiosity.scenes import BUILT_IN, BuiltIn
from tests.radiosity.helpers import ENVIRONMENT, hall


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


@pytest.mark.slow
def test_a_camera_around_the_scene(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("goral --patches 30 --size 48 --camera -35,20,3.5 -o a.png") == 0
    assert run("goral --patches 30 --size 48 -o b.png") == 0
    assert Path("a.png").read_bytes() != Path("b.png").read_bytes()
    with pytest.raises(SystemExit):
        run("goral --camera 10 -o c.png")
    assert "--camera" in capsys.readouterr().err


@pytest.mark.slow
def test_several_views(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(BUILT_IN, "hall", BuiltIn("two cameras", hall))
    assert run("hall --patches 300 --size 48 --views all -o a.png -o a.ply --direct d.png") == 0
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
        (
            "goral --camera balcony",
            "goral has no camera named 'balcony'; its cameras have no names; numbers are X,Y,Z/X",
        ),
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


def test_where_nothing_can_be_written_it_compiles_in_each_run() -> None:
    """An installation that is read-only, and no home: numba has no folder for what it compiled."""
    code = """
import tempfile
def refused(*arguments, **more):
    raise PermissionError(30, "Read-only file system")
tempfile.TemporaryFile = refused
import numpy as np
from glsim.radiosity import matrix, rays
from glsim.radiosity.compiled import is_cached
from glsim.radiosity.pairs import rows
from glsim.radiosity.polygon import area
print(area(np.eye(3), 3), is_cached(area), is_cached(rows))
"""
    for nowhere in ({}, {"NUMBA_CACHE_DIR": os.devnull}):
        ran = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, env={**ENVIRONMENT, **nowhere}
        )
        assert ran.returncode == 0, ran.stderr
        assert ran.stdout.split() == [str(np.sqrt(3.0) / 2.0), "False", "False"]
    assert is_cached(rows)


def test_the_command_interrupted(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*arguments: Any) -> None:
        raise KeyboardInterrupt

    assert run("goral --patches 60 -o first.png") == 0  # in a new process the code is compiled before, by a small solve
    (folder / "first.png").unlink()
    with monkeypatch.context() as patched:
        patched.setattr("glsim.radiosity.solution.mesh_of", interrupted)
        assert run("goral --patches 60 -o a.png") == 130
    told = capsys.readouterr().err
    assert "what is done is in a.unfinished.npz; the same command goes on with it" in told
    assert run("goral --patches 60 -o a.png") == 0
    assert [path.name for path in folder.iterdir()] == ["a.png"]


@pytest.mark.parametrize(
    ("camera", "sentence"),
    [
        ("0,0,0/0,0,0", "the eye and the point at which it looks are the same, 0,0,0"),
        ("0,0,0/0,0,1/180", "the angle from bottom to top is 1 to 170 degrees, not 180"),
        ("0,0,0/0,0", "3 numbers are needed, not '0,0'"),
        ("0,0,0/0,0,1/5/6", "an eye, a point to look at and an angle are X,Y,Z/X,Y,Z/DEGREES"),
    ],
)
def test_cameras_that_are_none(camera: str, sentence: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        run(f"goral --camera {camera} --patches 30 -o a.png")
    assert sentence in " ".join(capsys.readouterr().err.split())
    assert not list(folder.iterdir())


def test_a_camera_of_numbers(folder: Path) -> None:
    """The same as the scene's own, and another one."""
    assert run("goral --patches 30 --size 48 -o a.png") == 0
    assert run("goral --patches 30 --size 48 --camera 0.5,0.5,2.6/0.5,0.5,0.5/32 -o b.png") == 0
    assert run("goral --patches 30 --size 48 --camera -0.2,0.5,2.6/0.5,0.5,0.5/32 -o c.png") == 0
    a, b, c = (np.asarray(Image.open(f"{name}.png")) for name in "abc")
    assert (a == b).all()
    assert (a != c).any()


def test_a_lamp_by_name(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The exitance of the scene is replaced; twice as much light is twice the radiosity."""
    for number, words in enumerate(("--emit lamp=1", "--emit lamp=2,2,0")):
        assert run(f"goral --patches 30 {words} -o {number}.npz") == 0
    one, two = (np.load(f"{number}.npz")["B"] for number in (0, 1))
    np.testing.assert_allclose(two, one * (2, 2, 0), rtol=1e-4)
    assert run("goral --emit Lamp=1 -o a.npz") == 1
    assert "goral has no material named Lamp; it has blue, lamp, red, white" in capsys.readouterr().err
    for wrong in ("lamp", "lamp=x", "lamp=1,2", "lamp=-1"):
        with pytest.raises(SystemExit):
            run(f"goral --emit {wrong} -o a.npz")
