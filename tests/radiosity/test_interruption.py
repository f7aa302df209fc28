"""Work that is interrupted goes on."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from glsim import radiosity
from glsim.radiosity.methods import compute
from glsim.radiosity.scene import SceneError
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.subdivide import subdivide


def test_an_interrupted_run_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("glsim.radiosity.formfactors.BLOCK", 5000)
    parts = subdivide(BUILT_IN["cornell"].make().checked(), 250)
    whole = compute(parts)
    target = str(tmp_path / "rows.npz")
    calls = 0

    def interrupted(stage: str, done: int, of: int) -> None:
        nonlocal calls
        calls += 1
        if calls == 4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        compute(parts, checkpoint=target, progress=interrupted)
    assert Path(target).exists()
    first: list[int] = []
    again = compute(parts, checkpoint=target, progress=lambda stage, done, of: first.append(done))
    assert first[0] > 2 * 5000
    assert np.array_equal(again.S, whole.S)
    assert not Path(target).exists()


@pytest.mark.parametrize(
    ("method", "stage"),
    [("contour", "form factors"), ("contour", "vertices"), ("hierarchical", "links"), ("hierarchical", "vertices")],
)
def test_nothing_is_lost_whenever_one_interrupts(
    method: str, stage: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Blocks of pairs that were done before are not done again."""
    monkeypatch.setattr("glsim.radiosity.formfactors.BLOCK", 20000)
    monkeypatch.setattr("glsim.radiosity.hierarchy.BLOCK", 20000)
    monkeypatch.setattr("glsim.radiosity.gather.AT_ONCE", 200)
    target = str(tmp_path / "kept.npz")

    def run(told: list[str], last: str = "", **more: Any) -> radiosity.Radiosity:
        """Solve; ``told`` gets the stage of each step, and after three of the stage ``last`` someone presses Ctrl-C."""

        def progress(name: str, done: int, of: int) -> None:
            told.append(name)
            if name == last and told.count(name) == 3:
                raise KeyboardInterrupt

        return radiosity.solve("cornell", 500, method=method, progress=progress, **more)

    at_once: list[str] = []
    resumed: list[str] = []
    whole = run(at_once)
    with pytest.raises(KeyboardInterrupt):
        run([], stage, checkpoint=target)
    assert Path(target).exists()
    again = run(resumed, checkpoint=target)
    assert again.vertex_radiosity == pytest.approx(whole.vertex_radiosity, rel=1e-9)
    assert not Path(target).exists()
    work = "links" if method == "hierarchical" else "form factors"
    assert at_once.count(work) > 3
    if stage == "vertices":
        assert resumed.count(work) == 0
    elif method == "contour":
        assert resumed.count(work) == at_once.count(work) - 3
    else:  # pairs that are still open are put into new blocks
        assert 0 < resumed.count(work) < at_once.count(work)


def test_another_scenes_checkpoint_is_left_alone(tmp_path: Path) -> None:
    target = str(tmp_path / "kept.npz")
    other, ours = (compute(subdivide(BUILT_IN[name].make().checked(), 60)) for name in ("plates", "furnace"))
    other.keep(target)
    before = Path(target).read_bytes()
    assert np.array_equal(compute(ours.patches, checkpoint=target).S, ours.S)
    assert Path(target).read_bytes() == before
    ours.keep(target)
    whole = Path(target).read_bytes()
    np.save(tmp_path / "array.npy", np.zeros(3))
    array = (tmp_path / "array.npy").read_bytes()
    for content in (b"nonsense", b"", b"PK", whole[:-2000], whole[:3000], array):
        Path(target).write_bytes(content)
        with pytest.raises(SceneError, match="is no checkpoint: name another file, or remove it"):
            compute(ours.patches, checkpoint=target)
