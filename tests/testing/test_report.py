"""The report of a run, and the approval of pictures in it."""

from __future__ import annotations

import json

import pytest
import scipy.ndimage  # noqa: F401  (a run within this process forgets what it imported, and NumPy can be loaded once)
from PIL import Image

import glsim.testing.report
import glsim.web.page  # noqa: F401
from glsim.cli import main
from tests.testing.projects import BALL, ball, png

pytest_plugins = "pytester"


def test_the_report(project: pytest.Pytester, capsys: pytest.CaptureFixture[str]) -> None:
    ball(project)
    project.runpytest_inprocess("--gl-update")
    ball(project, blue=40, more="\n    def test_new(gl_snapshot):\n        gl_snapshot(np.zeros((4, 4)), 'first')\n")
    result = project.runpytest_inprocess("--gl-report", "artifact")
    result.stdout.fnmatch_lines(["1 pictures failed, 1 have no baseline", "report: artifact/index.html"])
    folder = project.path / "artifact"
    html = (folder / "index.html").read_text()
    assert html.index("test_ball.py::test_ball") < html.index("test_ball.py::test_new")
    assert "http://" not in html.replace("http://www.w3.org", "")
    place = "__gl_snapshots__/test_ball"
    assert (folder / "candidates" / place / "test_new-first.png").is_file()
    with Image.open(folder / "differences" / place / "test_ball.png") as sheet:
        assert sheet.getpixel((sheet.width - 100, sheet.height // 2)) == (0, 0, 255), "40 x 16, in blue"
    capsys.readouterr()
    assert main(["snapshots", "list", "artifact", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [(entry["status"], entry["name"]) for entry in told["snapshots"]] == [("failed", ""), ("missing", "first")]
    ball(project)
    assert project.runpytest_inprocess("--gl-report", "artifact").ret == 0
    assert not (folder / "candidates").exists(), "nothing of an earlier run is left: one test passed, the other is gone"


def test_a_run_replaces_what_is_said_of_the_tests_that_ran(
    project: pytest.Pytester, capsys: pytest.CaptureFixture[str]
) -> None:
    """Failed, missing and unused pictures of other tests wait for approval until their tests run, or are gone."""
    more = "\n    def test_{0}(gl_snapshot):\n        gl_snapshot(np.full((4, 4), {1}))\n"
    ball(project, more=more.format("fails", 0.1) + more.format("old", 0.2))
    project.makepyfile(test_other="def test_passes(gl_snapshot): gl_snapshot([[0.0]])")
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=4)
    ball(project, more=more.format("fails", 0.9) + more.format("new", 0.3))

    def waiting(*arguments: str) -> tuple[int, list[str], list[str]]:
        run = project.runpytest_inprocess(*arguments).ret
        capsys.readouterr()
        if main(["snapshots", "list", "--json"]) != 0:
            return int(run), [], []
        told = json.loads(capsys.readouterr().out)
        pictures = {path.name for path in project.path.glob("gl-report/candidates/**/*.png")}
        assert {f"{entry['base']}.png" for entry in told["snapshots"]} == pictures, "each has its picture"
        return int(run), sorted(entry["base"] for entry in told["snapshots"]), told["unused"]

    old = ["__gl_snapshots__/test_ball/test_old.png"]
    assert waiting() == (1, ["test_fails", "test_new"], old), "an unused baseline is told while another test fails"
    assert waiting("test_other.py") == (0, ["test_fails", "test_new"], old)
    assert waiting("test_ball.py::test_ball") == (0, ["test_fails", "test_new"], old)
    assert waiting("-k", "absent") == (5, ["test_fails", "test_new"], old)
    assert waiting("test_ball.py::test_fails", "--gl-update") == (0, ["test_new"], old)
    assert main(["snapshots", "clean"]) == 0
    assert not png(project, "test_old").exists()
    assert main(["snapshots", "approve"]) == 0
    assert waiting("test_ball.py::test_new") == (0, [], []), "all is said"
    assert not (project.path / "gl-report" / "index.html").exists()
    assert waiting() == (0, [], [])


def test_a_test_that_fails_keeps_what_may_be_its_baselines(project: pytest.Pytester) -> None:
    """It may have failed before it took them all."""
    text = """
    import numpy as np, pytest
    def test_it(gl_snapshot):
        gl_snapshot(np.zeros((4, 4)))
        assert not {0}
        gl_snapshot(np.zeros((4, 4)), "Second, " + 9 * "a long name ")
    @pytest.mark.xfail
    def test_it_too(gl_snapshot):
        assert not {0}
        gl_snapshot(np.zeros((4, 4)))
    """
    project.makepyfile(test_it=text.replace("{0}", "False"))
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=1, xpassed=1)
    folder = png(project, file="test_it").parent
    assert len(list(folder.iterdir())) == 3
    (folder / "test_items.png").write_bytes((folder / "test_it.png").read_bytes())
    project.makepyfile(test_it=text.replace("{0}", "True"))
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1, xfailed=1)
    unused = [line for line in result.stdout.lines if line.startswith("unused baseline")]
    assert unused == ["unused baseline: __gl_snapshots__/test_it/test_items.png"]


def test_a_downloaded_report_is_approved(project: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> None:
    """CI fails and keeps its folder; here its pictures become baselines; CI passes."""
    ball(project, more="\n    def test_new(gl_snapshot):\n        gl_snapshot(np.zeros((4, 4)), 'first')\n")
    monkeypatch.setenv("CI", "true")
    project.runpytest_inprocess("--gl-report", "artifact").assert_outcomes(failed=2)
    assert main(["snapshots", "approve", "artifact", "test_ball.py::test_ball"]) == 0
    assert png(project).exists()
    assert not png(project, "test_new-first").exists()
    assert main(["snapshots", "approve", "artifact", "no such test"]) != 0
    assert main(["snapshots", "approve", "artifact", "--json"]) == 0
    project.runpytest_inprocess().assert_outcomes(passed=2)


@pytest.mark.parametrize(
    "folder", ["../outside/__gl_snapshots__/x", "/tmp/__gl_snapshots__/x", "src", "a/../../__gl_snapshots__/x"]
)
def test_a_strangers_report_writes_baselines_only(project: pytest.Pytester, folder: str) -> None:
    ball(project)
    project.runpytest_inprocess("--gl-report", "artifact")
    path = project.path / "artifact" / "report.json"
    report = json.loads(path.read_text())
    report["snapshots"][0]["folder"] = folder
    report["unused"] = [f"{folder}/x.png"]
    path.write_text(json.dumps(report))
    before = sorted(project.path.rglob("*"))
    assert main(["snapshots", "approve", "artifact"]) != 0
    assert main(["snapshots", "clean", "artifact"]) != 0
    assert sorted(project.path.rglob("*")) == before


def test_a_folder_with_other_files_is_left_alone(project: pytest.Pytester) -> None:
    ball(project)
    (project.path / "notes").mkdir()
    (project.path / "notes" / "mine.txt").write_text("mine")
    assert project.runpytest_inprocess("--gl-report", "notes").ret == pytest.ExitCode.USAGE_ERROR
    assert (project.path / "notes" / "mine.txt").read_text() == "mine"
    assert main(["snapshots", "list", "notes"]) != 0


@pytest.mark.parametrize("right", [True, False])
def test_a_picture_that_must_differ_is_never_approved(project: pytest.Pytester, right: bool) -> None:
    """It is held against another snapshot's baseline, and must not take its place."""
    project.makepyfile(
        test_ball=BALL.replace("{blue}", "0")
        + f"        gl_snapshot(np.full((20, 30, 3), 7 if {right} else picture, np.uint8), max=(5, 255))\n"
    )
    project.runpytest_inprocess("--gl-update")
    before = png(project).read_bytes()
    result = project.runpytest_inprocess("--gl-report", "out")
    result.assert_outcomes(passed=int(right), failed=int(not right))
    assert main(["snapshots", "approve", str(project.path / "out"), "--root", str(project.path)]) == 0
    assert png(project).read_bytes() == before
    assert not list(project.path.glob("out/candidates/**/*.png"))


def test_a_folder_of_the_projects_own_is_left_alone(project: pytest.Pytester) -> None:
    own = project.path / "gl-report"
    own.mkdir()
    (own / "index.html").write_text("mine")
    ball(project)
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1)
    assert [path.name for path in own.iterdir()] == ["index.html"]
    assert (own / "index.html").read_text() == "mine"
