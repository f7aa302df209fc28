"""Form factors on a cluster of worker processes: the same as here, even if a worker dies."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("distributed")

from distributed import Client, LocalCluster, get_task_stream

from glsim import cli, radiosity
from glsim.radiosity.distributed import Blocks
from glsim.radiosity.scene import SceneError
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.subdivide import subdivide

PATCHES = 700
pytestmark = pytest.mark.slow  # worker processes are started


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    with LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=":0", memory_limit="1GiB", silence_logs=50
    ) as found:
        yield found


@pytest.fixture(scope="module")
def here() -> radiosity.Radiosity:
    return radiosity.solve("cornell", PATCHES, solver="cg")


def same(one: radiosity.Radiosity, other: radiosity.Radiosity) -> None:
    np.testing.assert_allclose(one.B, other.B, rtol=1e-7)
    np.testing.assert_allclose(one.vertex_radiosity, other.vertex_radiosity, rtol=1e-7)


def test_the_same_as_on_one_machine(cluster: Any, here: radiosity.Radiosity) -> None:
    there = radiosity.solve("cornell", PATCHES, scheduler=cluster.scheduler_address)
    same(there, here)
    assert there.factors.row_sums == pytest.approx(here.factors.row_sums, rel=1e-6)
    for i in (0, 300, len(here.patches) - 1):
        assert np.array_equal(there.factors.row(i), here.factors.row(i))
    assert there.report()["solver"] == "cg"
    assert there.direct() == pytest.approx(here.direct(), rel=1e-7)


def test_a_worker_dies_midway(cluster: Any, here: radiosity.Radiosity) -> None:
    killed: list[int] = []

    def progress(stage: str, done: int, of: int) -> None:
        if stage == "form factors" and done > 0.3 * of and not killed:
            killed.append(next(iter(cluster.workers.values())).pid)
            os.kill(killed[0], signal.SIGKILL)

    same(radiosity.solve("cornell", PATCHES, scheduler=cluster.scheduler_address, progress=progress), here)
    assert killed


def test_an_interrupted_run_goes_on_without_us(cluster: Any, here: radiosity.Radiosity) -> None:
    def progress(stage: str, done: int, of: int) -> None:
        if stage == "form factors" and done > 0.2 * of:
            raise KeyboardInterrupt

    address = cluster.scheduler_address
    with pytest.raises(KeyboardInterrupt):
        radiosity.solve("cornell", PATCHES, scheduler=address, progress=progress, checkpoint="mine")
    with Client(address, set_as_default=False) as client:
        kept = client.get_dataset("mine")
        assert len(kept) >= 32
        client.gather(kept)
        with get_task_stream(client) as stream:
            same(radiosity.solve("cornell", PATCHES, scheduler=address, checkpoint="mine"), here)
        again = {str(task["key"]).split("-")[0] for task in stream.data}
        assert "_block_product" in again
        assert "glsim" not in again
        assert "mine" not in client.list_datasets()


def test_the_command(cluster: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "plates.png"
    words = ["radiosity", "plates", "--patches", "50", "--scheduler", cluster.scheduler_address, "-o", str(out)]
    assert cli.main(words) == 0
    assert out.exists()


# ---------------------------------------------------------------- what can go wrong


def test_nobody_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("glsim.radiosity.distributed.WAIT", 1)
    with pytest.raises(SceneError, match=r"no Dask scheduler answers at tcp://127.0.0.1:1: start one with"):
        radiosity.solve("plates", 50, scheduler="tcp://127.0.0.1:1")
    with pytest.raises(SceneError, match="an address such as tcp://HOST:8786 is needed, not 'nonsense'"):
        radiosity.solve("plates", 50, scheduler="nonsense")


def test_no_workers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("glsim.radiosity.distributed.WAIT", 1)
    with (
        LocalCluster(n_workers=0, dashboard_address=":0", silence_logs=50) as empty,
        pytest.raises(SceneError, match="has no workers: start some with dask worker tcp"),
    ):
        radiosity.solve("plates", 50, scheduler=empty.scheduler_address)


def test_what_would_not_fit(cluster: Any) -> None:
    patches = subdivide(BUILT_IN["cornell"].make().checked(), 30000)
    with (
        Client(cluster.scheduler_address, set_as_default=False) as client,
        pytest.raises(SceneError, match=r"need 1\.\d GiB for their form factors, and the workers have 2\.0 GiB"),
    ):
        Blocks(client, patches, print)


def test_other_methods_stay_here(cluster: Any) -> None:
    with pytest.raises(SceneError, match="with --scheduler the method is contour"):
        radiosity.solve("plates", 50, scheduler=cluster.scheduler_address, method="hemicube")
