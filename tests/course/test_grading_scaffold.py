"""The autograder folders work in the layouts of their platforms, also when a submission tries to be imported."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import jsonschema
import pytest

import glsim
from glsim.cli import main
from glsim.course.exercise import exercise
from tests.course.grading import solution_of

LAMBERT = exercise("lambert")
SCHEMAS = Path(__file__).parent / "schemas"
HIJACK = "raise SystemExit('the submission was imported')\n"


def environment(**more: str) -> dict[str, str]:
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "GLSIM_BACKEND") if name in os.environ}
    return {**kept, "PYTHONPATH": str(Path(glsim.__file__).parents[1]), "GLSIM_PYTHON": sys.executable, **more}


def submission(folder: Path, text: str) -> None:
    """A submission with modules that would get in the way if the grader looked for its own in the folder."""
    folder.mkdir(parents=True)
    (folder / LAMBERT.filename).write_text(text)
    for name in ("json.py", "numpy.py", "glsim.py", "sitecustomize.py"):
        (folder / name).write_text(HIJACK)


def conforms(path: Path, schema: str) -> Any:
    document = json.loads(path.read_text())
    jsonschema.Draft202012Validator(json.loads((SCHEMAS / f"{schema}.json").read_text())).validate(document)
    return document


@pytest.mark.slow
def test_gradescope(tmp_path: Path) -> None:
    assert main(["grade", "--scaffold", "gradescope", str(tmp_path / "source"), "--exercise", "3"]) == 0
    assert {path.name for path in (tmp_path / "source").iterdir()} == {"README.md", "run_autograder", "setup.sh"}
    shutil.copy(tmp_path / "source" / "run_autograder", tmp_path)  # as the platform does
    (tmp_path / "results").mkdir()
    submission(tmp_path / "submission", solution_of(LAMBERT))
    command = [str(tmp_path / "run_autograder")]
    given = environment(AUTOGRADER=str(tmp_path))
    subprocess.run(command, env=given, cwd=tmp_path, check=True)
    document = conforms(tmp_path / "results" / "results.json", "gradescope")
    assert document["score"] == LAMBERT.points
    assert [path.name for path in (tmp_path / "results").iterdir()] == ["results.json"]
    (tmp_path / "results" / "results.json").unlink()
    broken = subprocess.run(command, env={**given, "GLSIM_PYTHON": "false"}, cwd=tmp_path, check=False)
    assert broken.returncode != 0
    assert not (tmp_path / "results" / "results.json").exists()


@pytest.mark.slow
def test_classroom50(tmp_path: Path) -> None:
    bundle, checkout = tmp_path / "bundle", tmp_path / "checkout"
    assert main(["grade", "--scaffold", "classroom50", str(bundle), "--exercise", "lambert"]) == 0
    assert json.loads((bundle / "runtime.json").read_text())["apt"]
    submission(checkout, "def lambert(N, L): return float(N @ L)\n")
    (checkout / "result.json").symlink_to(tmp_path / "elsewhere")
    runner = {
        "CLASSROOM": "cg", "ASSIGNMENT": "lambert", "ASSIGNMENT_TYPE": "individual", "OWNER": "eve",
        "SUBMISSION_TAG": "submit/2026-06-01T14-32-05Z-a1b2c3d",
        "COMMIT_URL": "https://x/commit/a", "RELEASE_URL": "https://x/r", "REVIEW_URL": "https://x/d",
    }  # fmt: skip
    command = [sys.executable, str(bundle / "autograder.py")]
    subprocess.run(command, env=environment(**runner), cwd=checkout, check=True)
    assert not (checkout / "result.json").is_symlink()
    assert not (tmp_path / "elsewhere").exists()
    document = conforms(checkout / "result.json", "classroom50")
    assert (document["owner"], document["score"], document["max-score"]) == ("eve", 2, LAMBERT.points)
    assert document["submission"] == runner["SUBMISSION_TAG"]
    text = (checkout / "result.json").read_text()
    assert not [
        line for line in solution_of(LAMBERT).splitlines() if line.startswith("    return") and line.strip() in text
    ]
    broken = subprocess.run(command, env=environment(GLSIM_PYTHON="false"), cwd=checkout, check=False)
    assert broken.returncode != 0


def test_scripts_are_scripts_and_nothing_is_overwritten(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for platform in ("gradescope", "classroom50"):
        words = ["grade", "--scaffold", platform, str(tmp_path / platform), "--exercise", "3,5"]
        assert main([*words, "--json"]) == 0
        files = [Path(name) for name in json.loads(capsys.readouterr().out)["files"]]
        before = [path.read_bytes() for path in files]
        assert not [path for path in files if b"@" in path.read_bytes()], "a word was not filled in"
        assert main(words) == 1
        assert "is there already" in capsys.readouterr().err
        assert [path.read_bytes() for path in files] == before
        for path in files:
            if path.read_bytes().startswith(b"#!"):
                subprocess.run(["bash", "-n", str(path)], check=True)
                assert os.access(path, os.X_OK)
            if path.suffix == ".py":
                compile(path.read_text(), str(path), "exec")
    assert "--exercise 03_lambert,05_snell " in (tmp_path / "gradescope" / "run_autograder").read_text()
