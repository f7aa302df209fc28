"""Form factors on many machines: blocks of rows are made, stay and are used on the workers of a Dask cluster.

A block holds S of some patches with all of higher number, so that the cluster holds n^2 / 2 numbers, and this machine
none of them.  What a worker that dies had made, Dask makes again on the others.
"""

from __future__ import annotations

import re
import socket
import threading
import time
from collections.abc import Sequence
from functools import cached_property
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.checkpoint import mark_of
from glsim.radiosity.formfactors import BLOCK, irradiance, next_rows, upper_rows
from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress
from glsim.radiosity.scene import Scene, SceneError
from glsim.radiosity.visibility import Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]
Rows = NDArray[np.float32]
WAIT = 20  # seconds for the scheduler and its first worker
FEWEST = 32  # blocks, so that all workers have something to do


def _dask() -> Any:
    return import_module("distributed")


def connected(address: str) -> Any:
    """A client of the scheduler at an address, "tcp://host:8786".  Raises SceneError if there is none, or no worker."""
    if find_spec("distributed") is None:
        raise SceneError("--scheduler needs the package distributed: pip install glsim[dask]")
    found = re.fullmatch(r"(?:tcp://)?([^/:\s]+):(\d+)", address)
    if not found:
        raise SceneError(f"--scheduler: an address such as tcp://HOST:8786 is needed, not {address!r}")
    try:
        socket.create_connection((found[1], int(found[2])), timeout=WAIT).close()  # before dask waits and complains
        client = _dask().Client(address, timeout=WAIT, set_as_default=False)
    except (OSError, OverflowError, ValueError) as error:
        raise SceneError(
            f"no Dask scheduler answers at {address}: start one with dask scheduler, and workers with dask worker"
            f" ADDRESS ({error})"
        ) from error
    try:
        client.wait_for_workers(1, timeout=WAIT)
    except TimeoutError as error:
        client.close()
        raise SceneError(f"the scheduler at {address} has no workers: start some with dask worker {address}") from error
    return client


class Blocks:
    """Form factors in blocks of rows on the workers; see factors.Factors for what a solver asks of them.

    starts: (k + 1,), block b has the rows starts[b] to starts[b + 1].  seconds: by stage.
    """

    method = "contour"
    asymmetry = 0.0  # each pair is there once
    matrix = None  # not on this machine

    def __init__(
        self, client: Any, patches: Patches, progress: Progress, name: str | None = None, threads: int | None = None
    ) -> None:
        """name: under which the blocks stay on the cluster, and go on being made, if this program is interrupted; one
        that asks for the same patches under any name finds them.  threads: for rays on this machine.  Raises SceneError
        if they would not fit."""
        self.client, self.patches, self.threads = client, patches, threads
        start = time.perf_counter()
        self._check_memory()
        self.starts = _starts(len(patches))
        mark = mark_of(patches, self.method)
        self.there = client.submit(_itself, patches)  # a task, not data: so it can be made again
        self.blocks = [
            client.submit(_block, self.there, low, high, key=f"glsim-{mark}-{low}") for low, high in self._bounds()
        ]
        if name:
            self.keep(name)
        self._wait(progress)
        if name:
            client.unpublish_dataset(name)
        self.seconds = {"form factors": time.perf_counter() - start}

    def _bounds(self) -> list[tuple[int, int]]:
        return list(zip(self.starts[:-1], self.starts[1:], strict=True))

    def _check_memory(self) -> None:
        needed = 2 * len(self.patches) ** 2
        there = sum(worker["memory_limit"] or 0 for worker in self.client.scheduler_info(-1)["workers"].values())
        if 0 < there < 2 * needed:
            raise SceneError(
                f"{len(self.patches)} patches need {needed / 2**30:.1f} GiB for their form factors, and the workers"
                f" have {there / 2**30:.1f} GiB, half of it for that: take fewer patches (--patches) or more workers"
            )

    def _wait(self, progress: Progress) -> None:
        n, done = len(self.patches), 0
        pairs = {
            block.key: (high - low) * (2 * n - low - high - 1) // 2
            for block, (low, high) in zip(self.blocks, self._bounds(), strict=True)
        }
        for block in _dask().as_completed(self.blocks, loop=self.client.loop):
            if block.status != "finished":
                raise _failure(block.exception())
            done += pairs[block.key]
            progress("form factors", done, n * (n - 1) // 2)

    def _each(self, function: Any, arguments: Sequence[tuple[Any, ...]]) -> list[Any]:
        """What the function returns for each of the arguments."""
        try:
            return list(self.client.gather([self.client.submit(function, *some, pure=False) for some in arguments]))
        except Exception as error:
            raise _failure(error) from error

    def times(self, B: Float) -> Float:
        """S B for B (n, 3)."""
        there = self.client.submit(_itself, B)
        lows = self.starts[:-1]
        parts = self._each(_product, [(block, there, low) for block, low in zip(self.blocks, lows, strict=True)])
        result = np.zeros(B.shape)
        for low, part in zip(lows, parts, strict=True):
            result[low:] += part
        return result

    @cached_property
    def row_sums(self) -> Float:
        """(n,): 1 in a closed scene, less where light escapes."""
        return np.asarray(self.times(np.ones((len(self.patches), 3)))[:, 0] / self.patches.area)

    def __repr__(self) -> str:
        return f"<Blocks of {self.patches.scene.name}: {len(self.blocks)} on {self.client.scheduler.address}>"

    @cached_property
    def visibility(self) -> Visibility:
        """Rays on this machine."""
        return Visibility(self.patches.scene, self.threads)

    def keep(self, checkpoint: str) -> None:
        """Leave the blocks on the workers under a name."""
        self.client.publish_dataset(self.blocks, name=checkpoint, override=True)

    def row(self, i: int) -> Float:
        """F[i, :], (n,)."""
        above = [
            (block, i - low, low <= i < high)
            for block, (low, high) in zip(self.blocks, self._bounds(), strict=True)
            if low <= i
        ]
        return np.asarray(np.concatenate(self._each(_row, above)) / self.patches.area[i], np.float64)

    def at_points(self, points: Float, ways: Float, patch: Int, B: Float) -> Float:
        """Irradiance (k, 3) at points with normals ``ways``."""
        there = self.client.submit(_itself, B)
        parts = np.array_split(np.arange(len(points)), max(1, len(self.client.nthreads())))
        return np.concatenate(
            self._each(_irradiance, [(self.there, points[part], ways[part], there) for part in parts])
        )


def _starts(n: int) -> list[int]:
    size = int(np.clip(n * (n - 1) // 2 // FEWEST, 1, BLOCK))
    starts = [0]
    while starts[-1] < n:
        starts.append(next_rows(n, starts[-1], size))
    return starts


def _failure(error: BaseException) -> BaseException:
    if isinstance(error, _dask().KilledWorker):
        return SceneError("workers die again and again over the same block: have they memory enough?")
    if isinstance(error, ModuleNotFoundError):
        return SceneError(f"the workers lack a package ({error}): install glsim[radiosity] where they run")
    return error


# ---------------------------------------------------------------- on the workers

_one_at_a_time = threading.Lock()  # each task uses all threads of its worker
_last: dict[str, Any] = {}


def _itself(what: Any) -> Any:
    return what


def _block(patches: Patches, first: int, last: int) -> Rows:
    out = np.zeros((last - first, len(patches)), np.float32)
    with _one_at_a_time:
        upper_rows(patches, _visibility(patches.scene), first, last, False, out, {"form factors": 0, "visibility": 0})
    return out[:, first:].copy()


def _product(block: Rows, B: Float, first: int) -> Float:
    """What a block adds to S B, from row ``first`` on: to its own rows, and by symmetry to those of its columns."""
    S = block.astype(np.float64)
    result = S.T @ B[first : first + len(S)]
    result[: len(S)] += S @ B[first:]
    return np.asarray(result)


def _row(block: Rows, at: int, own: bool) -> Rows:
    """The part of row ``at`` of S that the block has; of a row that is not its ``own``, this is a column."""
    return np.concatenate([block[:at, at], block[at, at:]]) if own else block[:, at]


def _irradiance(patches: Patches, points: Float, ways: Float, B: Float) -> Float:
    with _one_at_a_time:
        return irradiance(patches, _visibility(patches.scene), points, ways, B)


def _visibility(scene: Scene) -> Visibility:
    """The one of the scene that this worker asked for last, with as many threads as it has."""
    import numba

    threads = _dask().get_worker().state.nthreads
    numba.set_num_threads(min(threads, numba.get_num_threads()))
    if _last.get("scene") is not scene:
        _last.update(scene=scene, visibility=Visibility(scene, threads))
    found: Visibility = _last["visibility"]
    return found
