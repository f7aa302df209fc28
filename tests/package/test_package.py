"""What is shipped: the wheel, the lessons, the README, quick imports."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
import tarfile
import zipfile
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import glsim
from glsim.course.exercise import exercise
from glsim.course.handout import write_starter
from glsim.play.frames import frame_of
from glsim.web.modules import PLAYER
from glsim.web.page import SCRIPTS

ROOT = Path(__file__).resolve().parents[2]

pytestmark = pytest.mark.skipif(not (ROOT / "pyproject.toml").exists(), reason="needs a checkout")


def run(*command: str, cwd: Path | None = None, **environment: str) -> subprocess.CompletedProcess[str]:
    done = subprocess.run(
        command, cwd=cwd, env={**os.environ, **environment}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr + done.stdout
    return done


@pytest.fixture(scope="module")
def dist(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """sdist, and the wheel built from the sdist."""
    folder = tmp_path_factory.mktemp("dist")
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", str(folder), str(ROOT))
    return folder


@pytest.mark.slow
def test_the_wheel_has_shaders_and_lessons_and_nothing_else(dist: Path) -> None:
    with zipfile.ZipFile(next(dist.glob("*.whl"))) as wheel:
        names = wheel.namelist()
    for kind in ("shaders", "lessons"):
        for path in (ROOT / kind).iterdir():
            assert path.is_dir() or f"glsim/{kind}/{path.name}" in names
    assert {f"glsim/{library}/__init__.pyi" for library in ("gl", "glu", "glut")} <= set(names)
    shown = {f"glsim/web/{path.name}" for path in (ROOT / "glsim/web").iterdir() if path.suffix in (".js", ".css")}
    assert {f"glsim/web/{name}" for name in ("page.css", *SCRIPTS, *PLAYER)} <= shown <= set(names)
    assert {"glsim/py.typed", "glsim/gl/manual.txt"} <= set(names)
    assert not [name for name in names if not name.startswith(("glsim/", "glsim-"))]
    with tarfile.open(next(dist.glob("*.tar.gz"))) as sdist:
        inside = {name.split("/")[1] for name in sdist.getnames() if "/" in name}
    assert {"glsim", "shaders", "lessons", "tests", "README.md", "LICENSE", "pyproject.toml"} <= inside


@pytest.mark.slow
def test_the_wheel_draws_from_a_clean_environment(dist: Path, tmp_path: Path) -> None:
    """The dependencies are lent by this environment; glsim itself comes from the wheel alone."""
    run(sys.executable, "-m", "venv", str(tmp_path / "venv"))
    python = str(tmp_path / "venv" / "bin" / "python")
    run(python, "-m", "pip", "install", "-q", "--no-deps", str(next(dist.glob("*.whl"))))
    purelib = Path(run(python, "-c", "import sysconfig; print(sysconfig.get_paths()['purelib'])").stdout.strip())
    (purelib / "lent.pth").write_text(f"{Path(np.__file__).parents[1]}\n")
    where = run(python, "-c", "import glsim; print(glsim.__file__)", cwd=tmp_path, PYTHONPATH="").stdout.strip()
    assert where.startswith(str(tmp_path))
    command = str(tmp_path / "venv" / "bin" / "glsim")
    run(command, "compare", "sphere", "--size", "32", "-o", "sheet.png", cwd=tmp_path, PYTHONPATH="")
    assert (tmp_path / "sheet.png").stat().st_size > 1000


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", (ROOT / "README.md").read_text(), re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("program", blocks("python"))
@pytest.mark.slow
def test_python_of_the_readme(program: str, tmp_path: Path) -> None:
    run(sys.executable, "-c", program, cwd=tmp_path, PYTHONPATH=str(ROOT))
    assert [path for path in tmp_path.iterdir() if path.suffix in (".png", ".html")]


@pytest.mark.parametrize("number", [1, 2])
@pytest.mark.slow
def test_short_programs_of_the_readme(number: int, tmp_path: Path) -> None:
    run(sys.executable, "-c", blocks("py")[number], cwd=tmp_path, PYTHONPATH=str(ROOT))


@pytest.mark.slow
def test_pictures_of_the_readme_are_bright_whole_and_without_mistakes(tmp_path: Path) -> None:
    (tmp_path / "teapot.py").write_text(blocks("py")[0])
    fan, teapot = blocks("python")[0], frame_of(tmp_path / "teapot.py", calls=True)
    body = fan.partition("screen = ")[2].partition("\n")[2].partition("screen.save")[0]
    head = fan.partition("screen = ")[0]
    for frame in (frame_of(lambda: exec(head + body, {}), calls=True), teapot):
        assert glsim.trace(frame).mistakes == []
        pixels = glsim.terms(frame).picture[..., :3].astype(int)
        lit = pixels.max(axis=2) > 40
        assert lit.mean() > 0.15
        assert pixels[lit].mean() > 80
        assert not np.concatenate([lit[0], lit[-1], lit[:, 0], lit[:, -1]]).any()


COMMANDS = [
    line
    for block in blocks("sh")
    for line in block.splitlines()
    if line.startswith("glsim ") and "--window" not in line  # tests/glut/test_window.py opens windows
]


def test_the_readme_has_commands() -> None:
    assert len(COMMANDS) >= 20
    assert {line.split()[1] for line in COMMANDS} == {
        "compare", "draw", "exercise", "explain", "export", "grade", "lesson", "probe", "radiosity", "run", "tape",
        "terms", "trace",
    }  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("command", COMMANDS, ids=lambda line: line.partition("#")[0].strip())
def test_glsim_commands_of_the_readme(command: str, tmp_path: Path) -> None:
    """In a folder with the README's teapot.py, a tape and a submission; what a command is to write is there then."""
    (tmp_path / "teapot.py").write_text(blocks("py")[0])
    (tmp_path / "teapot.glt").write_bytes(glsim.tape(frame_of("teapot", size=64)))
    write_starter(exercise("3"), tmp_path / "submissions" / "ann")
    words = shlex.split(command, comments=True)[1:]
    run(sys.executable, "-m", "glsim", *words, cwd=tmp_path, PYTHONPATH=str(ROOT))
    written = [
        name for option, name in pairwise(words) if option in ("-o", "--out", "--gif", "--json", "--direct", "--steps")
    ]
    if words[0] == "run" and "--out" not in words:
        written.append("frames")
    for name in written:
        path = tmp_path / name
        if path.is_dir():
            assert list(path.glob("*.png"))
        elif "all" in words:  # --views all
            path = tmp_path / f"{path.stem}-0{path.suffix}" if path.suffix == ".png" else path
        assert path.stat().st_size > 0


def test_the_readmes_number_of_programs() -> None:
    from tests.oracle import PROGRAMS

    found = re.search(r"draws (\d+) programs", (ROOT / "README.md").read_text())
    assert found
    assert int(found[1]) == len(PROGRAMS)


@pytest.mark.slow
def test_imports_are_lazy() -> None:
    heavy = "{'numpy', 'moderngl', 'trimesh', 'scipy', 'rich', 'PIL', 'OpenGL'}"
    code = f"import sys, glsim; print({heavy} & set(sys.modules))"
    assert run(sys.executable, "-c", code).stdout.strip() == "set()"
    code = f"import sys, glsim\nfrom glsim.gl import *\ns = glsim.offscreen(8, 8)\nprint({heavy} & set(sys.modules))"
    assert set(eval(run(sys.executable, "-c", code).stdout)) == {"numpy", "moderngl"}
    code = "import sys\nfrom glsim.cli import main\ntry: main(['--help'])\nexcept SystemExit: pass\n"
    code += f"print({heavy} & set(sys.modules))"
    assert run(sys.executable, "-c", code).stdout.splitlines()[-1] == "set()"
