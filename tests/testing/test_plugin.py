"""The plugin in whole runs: the life of a baseline, and what fails."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.ndimage  # noqa: F401  (a run within this process forgets what it imported, and NumPy can be loaded once)
from PIL import Image

import glsim.testing.report
import glsim.web.page  # noqa: F401
from glsim.cli import main
from glsim.testing import baselines
from tests.testing.projects import DRAWN, ball, png

pytest_plugins = "pytester"


def test_the_life_of_a_baseline(project: pytest.Pytester) -> None:
    ball(project)
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(
        ["*test_ball.py:4: snapshot test_ball", "*There is no approved baseline. All pixels are*"]
    )
    assert not png(project).exists(), "nothing is written into the source"
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=1)
    with Image.open(png(project)) as image:
        assert image.text["size"] == "30 x 20"  # type: ignore[attr-defined]
        assert image.text["glsim"]  # type: ignore[attr-defined]
    assert project.runpytest_inprocess().ret == 0
    before = png(project).read_bytes()
    ball(project, blue=9)
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*600 of 600 pixels differ, by at most 9/255*", "*closest baseline:*test_ball.png"])
    assert png(project).read_bytes() == before
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=1)
    assert png(project).read_bytes() != before
    project.runpytest_inprocess().assert_outcomes(passed=1)


def test_updating_writes_no_equal_picture_anew(project: pytest.Pytester) -> None:
    ball(project)
    project.runpytest_inprocess("--gl-update")
    time = png(project).stat().st_mtime_ns
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=1)
    assert png(project).stat().st_mtime_ns == time


def test_ci_writes_no_baselines(project: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> None:
    ball(project)
    monkeypatch.setenv("CI", "true")
    result = project.runpytest_inprocess("--gl-update")
    assert result.ret == pytest.ExitCode.USAGE_ERROR
    assert not png(project).exists()


def test_an_unused_baseline_fails_and_is_cleaned(project: pytest.Pytester, capsys: pytest.CaptureFixture[str]) -> None:
    ball(project, more="\n    def test_old(gl_snapshot):\n        gl_snapshot(np.zeros((4, 4)))\n")
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=2)
    ball(project)
    assert project.runpytest_inprocess("test_ball.py::test_ball").ret == 0, "a part of a file knows of no unused one"
    assert project.runpytest_inprocess("-k", "ball and not old").ret == 1, "the other test is gone, not deselected"
    assert project.runpytest_inprocess("--gl-unused=ignore").ret == 0
    result = project.runpytest_inprocess()
    assert result.ret == pytest.ExitCode.TESTS_FAILED
    result.stdout.fnmatch_lines(["unused baseline: __gl_snapshots__/test_ball/test_old.png"])
    assert main(["snapshots", "clean", "gl-report", "--json"]) == 0
    assert not png(project, "test_old").exists()
    assert png(project).exists()
    assert project.runpytest_inprocess().ret == 0


def test_baselines_of_a_file_that_is_gone(project: pytest.Pytester) -> None:
    ball(project)
    project.makepyfile(test_other="def test_nothing(): pass")
    project.runpytest_inprocess("--gl-update")
    (project.path / "test_ball.py").unlink()
    result = project.runpytest_inprocess()
    assert result.ret == 1
    result.stdout.fnmatch_lines(["unused baseline: __gl_snapshots__/test_ball/test_ball.png"])


def test_a_snapshot_that_is_never_taken_fails(project: pytest.Pytester) -> None:
    project.makepyfile("def test_it(gl_snapshot): pass")
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*gl_snapshot was never called*"])


def test_each_snapshot_has_its_own_name(project: pytest.Pytester) -> None:
    project.makepyfile(
        """
        import numpy as np, pytest
        @pytest.mark.parametrize("k", [1, 2])
        def test_it(gl_snapshot, k):
            gl_snapshot(np.full((4, 4), k / 10))
            gl_snapshot(np.full((4, 4), k / 5), "Brighter")
            with pytest.raises(ValueError, match="has taken a snapshot with no name before"):
                gl_snapshot(np.full((4, 4), k / 10))
        """
    )
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=2)
    names = [path.name for path in baselines.pictures(next((project.path / "__gl_snapshots__").iterdir()))]
    assert len(names) == 4
    assert "test_it[1].png" in names
    project.runpytest_inprocess().assert_outcomes(passed=2)


def test_all_pictures_of_a_test_are_told(project: pytest.Pytester) -> None:
    project.makepyfile(
        """
        import numpy as np
        def test_it(gl_snapshot):
            gl_snapshot(np.zeros((4, 4)), "a")
            gl_snapshot(np.zeros((5, 5)), "b")
        """
    )
    result = project.runpytest_inprocess()
    result.stdout.fnmatch_lines(["*snapshot test_it-a", "*snapshot test_it-b", "0 pictures failed, 2 have no baseline"])


def test_pictures_that_glsim_draws(project: pytest.Pytester) -> None:
    """The fixture gl, a Frame, and a function draw the same."""
    project.makepyfile(
        test_drawn=DRAWN
        + """
    def test_gl(gl, gl_snapshot):
        assert (gl.width, gl.height) == (256, 256)
        draw()
        gl_snapshot(gl)
    @pytest.mark.gl(size=(256, 256))
    def test_function(gl_snapshot):
        gl_snapshot(draw)
    def test_frame(gl, gl_snapshot):
        with glsim.capture() as frame:
            draw()
        gl_snapshot(frame)
    @pytest.mark.gl(size=(40, 30), samples=4)
    def test_small(gl, gl_snapshot):
        draw()
        gl_snapshot(gl)
    """
    )
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=4)
    shots = {path.stem: baselines.read(path) for path in baselines.pictures(png(project, file="test_drawn").parent)}
    assert np.array_equal(shots["test_gl"], shots["test_function"])
    assert np.array_equal(shots["test_gl"], shots["test_frame"])
    assert shots["test_small"].shape == (30, 40, 4)
    assert len(np.unique(shots["test_small"].reshape(-1, 4), axis=0)) > 2, "multisampled"
    facts = baselines.facts(png(project, "test_gl", "test_drawn"))
    assert facts["renderer"]
    assert len(facts["probe"]) == 16
    result = project.runpytest_inprocess()
    result.assert_outcomes(passed=4)
    result.stdout.fnmatch_lines([f"glsim: pictures are drawn by {facts['renderer'][:8]}*"])


def test_objects_that_a_test_leaves_behind_fail(project: pytest.Pytester) -> None:
    project.makepyfile(
        test_leak=DRAWN
        + """
    def test_leak(gl):
        glGenLists(2)
        glBindTexture(GL_TEXTURE_2D, glGenTextures(1))
    def test_state_is_new(gl):
        assert not glIsEnabled(GL_LIGHTING)
        glEnable(GL_LIGHTING)
    def test_state_is_new_again(gl):
        assert not glIsEnabled(GL_LIGHTING)
    """
    )
    result = project.runpytest_inprocess()
    result.assert_outcomes(passed=2, failed=1)
    result.stdout.fnmatch_lines(["*leaves GL objects behind: 1 texture (1)*2 display lists (1, 2)*"])


def test_what_a_test_leaves_open_fails(project: pytest.Pytester) -> None:
    project.makepyfile(
        test_open=DRAWN
        + """
    def test_begin(gl):
        glBegin(GL_TRIANGLES)
    def test_list(gl):
        glNewList(3, GL_COMPILE)
    def test_next(gl, gl_snapshot):
        draw()
        gl_snapshot(gl)
    """
    )
    result = project.runpytest_inprocess("--gl-update")
    result.assert_outcomes(passed=1, failed=2)
    result.stdout.fnmatch_lines(
        ["*leaves glBegin(GL_TRIANGLES) open: *glEnd is missing.", "*leaves glNewList(3, ...) open: glEndList is*"]
    )


def test_a_traceback_shows_the_tests_lines_alone(project: pytest.Pytester) -> None:
    project.makepyfile(
        test_wrong=DRAWN
        + """
    def wrong():
        glEnable(GL_LIGHTING, "my line")
        1 / 0
    def test_nothing(gl_snapshot): gl_snapshot(None)
    def test_tolerance(gl_snapshot): gl_snapshot([[0.0]], least=3)
    def test_begin(gl, gl_snapshot):
        glBegin(GL_TRIANGLES)
        gl_snapshot(gl)
    def test_function(gl_snapshot): gl_snapshot(wrong)
    """
    )
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=4)
    text = result.stdout.str()
    assert "1 / 0" in text
    assert "glsim/testing" not in text
    assert "glsim/images" not in text
    assert "glsim/machine" not in text
    assert "glsim/testing/snapshot.py" in project.runpytest_inprocess("--full-trace", "-k", "nothing").stdout.str()


def test_another_renderer(project: pytest.Pytester) -> None:
    """Its rounding passes, its other pictures do not; an approved one of its own lies beside."""
    text = """
    import numpy as np
    def test_ball(gl_snapshot):
        picture = np.full((30, 30, 3), 100, np.uint8)
        picture[::2] += {odd}
        gl_snapshot(picture, renderer="{renderer}")
    """

    def write(renderer: str, odd: int) -> None:
        project.makepyfile(test_ball=text.replace("{renderer}", renderer).replace("{odd}", str(odd)))

    write("Radeon RX 9 (a driver)", 0)
    project.runpytest_inprocess("--gl-update")
    write("llvmpipe", 1)
    project.runpytest_inprocess().assert_outcomes(passed=1)
    write("Radeon RX 9 (a driver)", 1)
    project.runpytest_inprocess().assert_outcomes(failed=1)
    write("llvmpipe", 50)
    project.runpytest_inprocess().assert_outcomes(failed=1)
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=1)
    assert png(project).exists()
    assert png(project, "test_ball.llvmpipe").exists()
    project.runpytest_inprocess().assert_outcomes(passed=1)
    write("Radeon RX 9 (a driver)", 50)
    assert project.runpytest_inprocess().ret == 0, "any approved picture may match"


def test_a_picture_that_must_differ(project: pytest.Pytester) -> None:
    text = """
    import numpy as np
    def test_it(gl_snapshot):
        gl_snapshot(np.full((9, 9), 0.5))
        gl_snapshot(np.full((9, 9), {value}), mean=(20, 200))
    """
    project.makepyfile(test_it=text.replace("{value}", "0.9"))
    project.runpytest_inprocess("--gl-update").assert_outcomes(passed=1)
    project.runpytest_inprocess().assert_outcomes(passed=1)
    project.makepyfile(test_it=text.replace("{value}", "0.5"))
    result = project.runpytest_inprocess("--gl-update")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*mean is 0, and the test asks for 20 to 200."])


def test_wrong_markers_and_no_pictures(project: pytest.Pytester) -> None:
    project.makepyfile(
        """
        import pytest
        @pytest.mark.gl(32, 32)
        def test_arguments(gl): pass
        @pytest.mark.gl(size=3)
        def test_size(gl): pass
        def test_picture(gl_snapshot):
            gl_snapshot(None)
        """
    )
    result = project.runpytest_inprocess()
    result.assert_outcomes(errors=2, failed=1)
    result.stdout.fnmatch_lines(["*a marker is gl(size*", "*size is (width, height), not 3*", "*a picture is needed*"])


@pytest.mark.slow
def test_workers_know_as_much_as_one_process(project: pytest.Pytester) -> None:
    pytest.importorskip("xdist")
    project.makepyfile(
        test_many="""
        import numpy as np, pytest
        @pytest.mark.parametrize("k", range(12))
        def test_it(gl_snapshot, k):
            gl_snapshot(np.full((9, 9), k / 20))
        """
    )
    project.runpytest_subprocess("-n", "2", "--gl-update").assert_outcomes(passed=12)
    folder = png(project, file="test_many").parent
    assert len(list(folder.glob("*.png"))) == 12
    (folder / "test_it[3].png").unlink()
    (folder / "test_it[5].png").write_bytes((folder / "test_it[6].png").read_bytes())
    (folder / "test_gone.png").write_bytes((folder / "test_it[6].png").read_bytes())
    result = project.runpytest_subprocess("-n", "2")
    result.assert_outcomes(passed=10, failed=2)
    result.stdout.fnmatch_lines(["1 pictures failed, 1 have no baseline"])
    (folder / "test_it[5].png").unlink()
    project.runpytest_subprocess("-n", "2", "--gl-update").assert_outcomes(passed=12)
    result = project.runpytest_subprocess("-n", "2")
    assert result.ret == 1
    result.stdout.fnmatch_lines(["unused baseline: __gl_snapshots__/test_many/test_gone.png"])


@pytest.mark.slow
def test_a_run_without_snapshots_imports_nothing_heavy(project: pytest.Pytester) -> None:
    project.makepyfile(
        """
        import sys
        def test_modules(pytestconfig):
            assert pytestconfig.pluginmanager.hasplugin("glsim-session")
            assert not {"numpy", "moderngl", "PIL", "scipy", "rich"} & set(sys.modules)
        """
    )
    project.runpytest_subprocess().assert_outcomes(passed=1)


def test_a_machine_that_cannot_draw_fails_those_tests_alone(
    project: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GLSIM_BACKEND", "nonsense")
    project.makepyfile(test_ball="def test_drawn(gl): pass\ndef test_other(): pass\n")
    result = project.runpytest_inprocess()
    result.assert_outcomes(errors=1, passed=1)
    result.stdout.fnmatch_lines(["*backend must be auto, egl*not 'nonsense'*"])
    result.stdout.no_fnmatch_line("*Traceback*")
