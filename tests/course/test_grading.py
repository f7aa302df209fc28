"""``glsim grade``: the same marks whatever the number of processes and their order; what is done survives a kill."""

from __future__ import annotations

import contextlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from glsim.cli import main
from glsim.course.asking import Answers
from glsim.course.checking import judged
from glsim.course.exercise import exercise, exercises
from glsim.course.grading import run
from glsim.course.grading.record import Record, Store
from glsim.course.grading.submissions import Submission, submissions
from tests.course.grading import SOLUTIONS, changed, solution_of, variants_of

LAMBERT, SNELL, GLSL = exercise("lambert"), exercise("snell"), exercise("33")
SLEEP = "import time\ntime.sleep(60)\n"


@pytest.fixture(scope="module")
def handed_in(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Six submissions: right, wrong, a zip with a wrong shader, one that crashes, an empty folder, a broken zip."""
    folder = tmp_path_factory.mktemp("handed-in")
    wrong = next(iter(variants_of(LAMBERT.name).WRONG.values()))[0]
    for name, text in (
        ("ann", solution_of(LAMBERT)),
        ("bob\n🦊", changed(LAMBERT, wrong)),
        ("-j", "import os\nos._exit(0)"),
    ):
        (folder / name).mkdir()
        (folder / name / LAMBERT.filename).write_text(text)
    shader = next(iter(variants_of(GLSL.name).WRONG.values()))[0]
    with zipfile.ZipFile(folder / "eve_1_assignsubmission_file_.zip", "w") as archive:
        archive.writestr(f"x/{GLSL.filename}", changed(GLSL, shader))
        archive.writestr("lambert (1).py", next(iter(variants_of(LAMBERT.name).RIGHT.values())))
    (folder / "empty").mkdir()
    (folder / "broken.zip").write_bytes(b"PK")
    return folder


def grade(*words: str) -> int:
    return main(["grade", *words])


POINTS = {"ann": 5, "bob\\n🦊": 2, "-j": 0, "eve_1_assignsubmission_file_.zip": 5, "empty": 0, "broken.zip": 0}


@pytest.mark.slow
def test_marks_are_the_same_with_any_number_of_processes(handed_in: Path, tmp_path: Path) -> None:
    for jobs in ("1", "3"):
        assert (
            grade(str(handed_in), "--exercise", "3,33", "-j", jobs, "-o", str(tmp_path / jobs), "--format", "json") == 0
        )
    one, three = ((tmp_path / jobs / "marks.json").read_bytes() for jobs in ("1", "3"))
    assert one == three
    document = json.loads(one)
    marks = {s["submission"]: s["marks"][0] for s in document["submissions"]}
    assert {name: mark["points"] for name, mark in marks.items()} == POINTS
    assert "ended its process" in marks["-j"]["note"]
    assert "no zip archive" in marks["broken.zip"]["note"]
    assert {mark["isolation"] for s in document["submissions"] for mark in s["marks"] if mark["file"]} <= {
        "bubblewrap", "Landlock", "resource limits", "not isolated",
    }  # fmt: skip
    nothing_of_a_solution(tmp_path)


def nothing_of_a_solution(folder: Path) -> None:
    """No line of a solution's code is in any file below a folder."""
    lines = {
        line.strip()
        for path in SOLUTIONS.iterdir()
        for line in path.read_text(encoding="utf-8").splitlines()
        if line.strip().startswith("return ") and len(line.strip()) > 16
    }
    for path in folder.rglob("*.*"):
        text = path.read_bytes().decode("utf-8", "replace") if path.is_file() else ""
        assert not [line for line in lines if line in text], path


@pytest.mark.slow
def test_only_what_has_changed_is_graded_again(
    handed_in: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "all"
    shutil.copytree(handed_in, folder)
    words = (str(folder), "--exercise", "3", "-o", str(folder / "marks"), "--json", "-j", "2", "--format", "json")
    graded: list[str] = []
    original = run._all

    def counted(tasks: list[run.Task], jobs: int) -> Any:
        graded.extend(task.blank.submission for task in tasks)
        return original(tasks, jobs)

    monkeypatch.setattr(run, "_all", counted)
    assert grade(*words) == 0
    first = json.loads(capsys.readouterr().out)
    marks = (folder / "marks" / "marks.json").read_bytes()
    assert len(graded) == 4
    graded.clear()
    assert grade(*words, "--resume") == 0
    assert json.loads(capsys.readouterr().out) == first
    assert graded == []
    assert (folder / "marks" / "marks.json").read_bytes() == marks
    (folder / "ann" / LAMBERT.filename).write_text("x = 1")
    store = Store(folder / "marks" / "records")
    damaged = next(path for path in store.folder.iterdir() if path.name.startswith("eve"))
    damaged.write_text("{")
    assert grade(*words, "--resume") == 0
    assert sorted(graded) == ["ann", "eve_1_assignsubmission_file_.zip"]
    second = json.loads(capsys.readouterr().out)
    assert second["points"] != first["points"]
    assert sum(second["points"]) == sum(first["points"]) - 5


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_what_is_done_survives_an_end_and_no_process_stays(number: int, tmp_path: Path) -> None:
    folder = tmp_path / "all"
    for name, text in (("a", solution_of(LAMBERT)), ("b", SLEEP), ("c", SLEEP)):
        (folder / name).mkdir(parents=True)
        (folder / name / LAMBERT.filename).write_text(text)
    records = tmp_path / "marks" / "records"
    words = [
        sys.executable,
        "-m",
        "glsim",
        "grade",
        str(folder),
        "--exercise",
        "3",
        "-j",
        "2",
        "-o",
        str(tmp_path / "marks"),
    ]
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    process = subprocess.Popen(
        words, stderr=subprocess.PIPE, text=True, env={**os.environ, "TMPDIR": str(scratch)}, start_new_session=True
    )
    wait_until(lambda: list(records.glob("*.json")))
    time.sleep(0.5)
    (os.killpg if number == signal.SIGINT else os.kill)(process.pid, number)  # a terminal's Ctrl-C is for all
    began = time.monotonic()
    _, errors = process.communicate(timeout=30)
    assert time.monotonic() - began < 10
    assert process.returncode == (130 if number == signal.SIGINT else -number)
    if number == signal.SIGINT:
        assert "1 of 3 marks are kept; --resume goes on" in errors
        assert "Traceback" not in errors
    assert [path.name[:2] for path in records.glob("[!.]*.json")] == ["a-"]
    wait_until(lambda: not running(str(scratch)))
    assert not list(scratch.iterdir())


def wait_until(ready: Callable[[], object], seconds: float = 30.0) -> None:
    limit = time.monotonic() + seconds
    while not ready():
        assert time.monotonic() < limit
        time.sleep(0.05)


def running(scratch: str) -> list[int]:
    """Processes whose command or environment has the name of the folder for temporary files."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(OSError):
            words = Path(f"/proc/{name}/cmdline").read_bytes() + Path(f"/proc/{name}/environ").read_bytes()
            if scratch.encode() in words:
                found.append(int(name))
    return found


def crash(task: run.Task) -> Record:
    """What a driver's crash does."""
    if b"crash" in task.data:
        os._exit(11)
    return task.blank


@pytest.mark.slow
def test_a_crash_of_the_grader_fails_one_submission_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    order = [f"s{n}" for n in range(8)]
    random.Random(1).shuffle(order)
    for number, name in enumerate(order):
        (tmp_path / name).mkdir()
        (tmp_path / name / LAMBERT.filename).write_text("crash" if number in (3, 6) else "x = 1")
    monkeypatch.setattr(run, "graded", crash)
    monkeypatch.setattr(run, "_check_machine", lambda: None)
    records = list(run.grade(submissions(tmp_path), [LAMBERT], jobs=2, seconds=5.0))
    assert len(records) == 8
    assert {record.submission for record in records if record.failure} == {order[3], order[6]}


@pytest.mark.slow
def test_a_failure_is_no_mark(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "all" / "ann").mkdir(parents=True)
    (tmp_path / "all" / "ann" / LAMBERT.filename).write_text("x = 1")
    words = (str(tmp_path / "all"), "--exercise", "3", "-o", str(tmp_path / "marks"))

    def fail(*arguments: object) -> None:
        raise OSError("no space left")

    monkeypatch.setattr(run, "check", fail)
    monkeypatch.setattr(run, "_check_machine", lambda: None)
    monkeypatch.setattr(run, "_all", lambda tasks, jobs: map(run.graded, tasks))
    for name in ("gradescope", "classroom50"):
        assert grade(*words, "--format", name) == 1
        assert "ann, 03_lambert: not graded: OSError: no space left" in capsys.readouterr().err
        assert not list((tmp_path / "marks").rglob("result*.json")), "no file rather than a wrong mark"
    assert grade(*words, "--resume", "--json") == 1, "a failure is tried again"
    assert json.loads(capsys.readouterr().out)["status"] == "failures"


def test_what_the_system_refuses_to_read_is_no_mark(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A folder without permissions; and whatever else goes wrong with one submission, the others have their marks."""
    for name in ("ann", "bob", "eve"):
        (tmp_path / "all" / name).mkdir(parents=True)
    original = run.choose

    def refusing(submission: Submission, *rest: Any) -> Any:
        if submission.name == "bob":
            raise PermissionError(13, "Permission denied", "x\udcff")
        return original(submission, *rest)

    monkeypatch.setattr(run, "choose", refusing)
    assert grade(str(tmp_path / "all"), "--exercise", "3,5", "-o", str(tmp_path / "marks"), "--format", "csv") == 1
    errors = capsys.readouterr().err
    assert "bob, 03_lambert: not graded: PermissionError: [Errno 13] Permission denied" in errors
    assert "ann" not in errors
    assert "bob,,,,10," in (tmp_path / "marks" / "marks.csv").read_text()


def test_a_machine_on_which_nothing_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "03_lambert.py").write_text("x = 1")
    answers = Answers([{"error": "bwrap: no permission"}])
    monkeypatch.setattr(run, "check", lambda one, *rest: judged(one, answers))
    assert grade(str(tmp_path), "--exercise", "3", "-o", str(tmp_path / "marks")) == 1
    assert "nothing can be graded here (" in capsys.readouterr().err


def test_wrong_command_lines(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for words in (["--exercise", "3"], [str(tmp_path)], [str(tmp_path), "--exercise", "3", "--format", "xml"]):
        with pytest.raises(SystemExit) as ended:
            grade(*words)
        assert ended.value.code == 2
    assert grade(str(tmp_path / "none"), "--exercise", "3") == 1
    assert grade(str(tmp_path), "--exercise", "lambret") == 1
    assert "lambert" in capsys.readouterr().err
    assert len(exercises()) > 3
