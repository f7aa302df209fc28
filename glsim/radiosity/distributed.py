"""Form factors on many machines: Dask workers compute blocks of rows of S, store them, and multiply by them.

A block holds the rows ``first`` up to ``last`` of S from column ``first`` on.  S is symmetric, so the cluster stores
about n^2 / 2 numbers, and this machine none.  If a worker dies, Dask computes its blocks again on the other workers.
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
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Scene, SceneError
from glsim.radiosity.visibility import Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]
Rows = NDArray[np.float32]
WAIT = 20  # seconds for the scheduler and its first worker
FEWEST = 32  # blocks, so that all workers have something to do


def _dask() -> Any:
    """Return the package distributed, imported only when it is needed."""
    return import_module("distributed")


def connected(address: str) -> Any:
    """Return a client of the scheduler at an address, "tcp://host:8786".

    Raises SceneError if no scheduler answers, or if it has no worker.
    """
    if find_spec("distributed") is None:
        raise SceneError("--scheduler needs the package distributed: pip install glsim[dask]")
    parts = re.fullmatch(r"(?:tcp://)?([^/:\s]+):(\d+)", address)
    if not parts:
        raise SceneError(f"--scheduler: an address such as tcp://HOST:8786 is needed, not {address!r}")
    try:
        socket.create_connection((parts[1], int(parts[2])), timeout=WAIT).close()  # before dask waits and complains
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
    """Form factors in blocks of rows on the workers; a kind of factors.Factors.

    starts: (k + 1,), block b has the rows starts[b] to starts[b + 1].  seconds: by stage.
    """

    method = "contour"
    asymmetry = 0.0  # each pair is stored once, so S_ij = S_ji
    matrix = None  # S is on the workers

    def __init__(
        self, client: Any, patches: Patches, progress: Progress, dataset: str | None = None, rays: Rays | None = None
    ) -> None:
        """Compute the form factors of patches on the workers of a client, and wait until all blocks are finished.

        dataset: if this program is interrupted, the cluster keeps the blocks as a dataset of this name and goes on
        computing them; a later program with the same patches gets them, whatever name it gives.  rays: on this machine,
        of the patches' scene.  Raises SceneError if the blocks would take more than half of the workers' memory.
        """
        self.client, self.patches, self.rays = client, patches, rays
        start = time.perf_counter()
        self._check_memory()
        self.starts = _starts(len(patches))
        mark = mark_of(patches, self.method)
        self.scattered = client.submit(_identity, patches)  # a task, not data: see _identity
        self.blocks = [
            client.submit(_compute_block, self.scattered, low, high, key=f"glsim-{mark}-{low}")
            for low, high in self._bounds()
        ]
        if dataset:
            self.keep(dataset)
        self._wait(progress)
        if dataset:
            client.unpublish_dataset(dataset)
        self.seconds = {"form factors": time.perf_counter() - start}

    def _bounds(self) -> list[tuple[int, int]]:
        """Return the first row of each block, and the row after its last."""
        return list(zip(self.starts[:-1], self.starts[1:], strict=True))

    def _check_memory(self) -> None:
        """Raise SceneError if the blocks would take more than half of the workers' memory."""
        needed = 2 * len(self.patches) ** 2
        memory = sum(worker["memory_limit"] or 0 for worker in self.client.scheduler_info(-1)["workers"].values())
        if 0 < memory < 2 * needed:
            raise SceneError(
                f"{len(self.patches)} patches need {needed / 2**30:.1f} GiB for their form factors, and the workers"
                f" have {memory / 2**30:.1f} GiB, half of it for that: take fewer patches (--patches) or more workers"
            )

    def _wait(self, progress: Progress) -> None:
        """Wait for all blocks, and tell how many pairs are done."""
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

    def _call_each(self, function: Any, arguments: Sequence[tuple[Any, ...]]) -> list[Any]:
        """Call the function on the workers with each of the arguments, and return the results in order."""
        try:
            return list(self.client.gather([self.client.submit(function, *some, pure=False) for some in arguments]))
        except Exception as error:
            raise _failure(error) from error

    def times(self, B: Float) -> Float:
        """Return S B (n, 3) for B (n, 3)."""
        radiosity = self.client.submit(_identity, B)
        lows = self.starts[:-1]
        parts = self._call_each(
            _block_product, [(block, radiosity, low) for block, low in zip(self.blocks, lows, strict=True)]
        )
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
        """Visibility by rays on this machine."""
        return Visibility(self.rays or Rays(self.patches.scene))

    def keep(self, checkpoint: str) -> None:
        """Leave the blocks on the workers under a name."""
        self.client.publish_dataset(self.blocks, name=checkpoint, override=True)

    def row(self, i: int) -> Float:
        """Return F[i, :], (n,)."""
        parts = [
            (block, i - low, low <= i < high)
            for block, (low, high) in zip(self.blocks, self._bounds(), strict=True)
            if low <= i
        ]
        return np.asarray(np.concatenate(self._call_each(_row_part, parts)) / self.patches.area[i], np.float64)

    def at_points(self, points: Float, normals: Float, patch: Int, B: Float) -> Float:
        """Return the irradiance (k, 3) at points (k, 3) with unit normals (k, 3), a part of it from each worker."""
        radiosity = self.client.submit(_identity, B)
        parts = np.array_split(np.arange(len(points)), max(1, len(self.client.nthreads())))
        return np.concatenate(
            self._call_each(_irradiance, [(self.scattered, points[part], normals[part], radiosity) for part in parts])
        )


def _starts(n: int) -> list[int]:
    """Return where blocks of rows begin, and n, so that each has about as many pairs and there are at least FEWEST."""
    size = int(np.clip(n * (n - 1) // 2 // FEWEST, 1, BLOCK))
    starts = [0]
    while starts[-1] < n:
        starts.append(next_rows(n, starts[-1], size))
    return starts


def _failure(error: BaseException) -> BaseException:
    """Return the exception to raise for an error on a worker: a SceneError for a known cause, else the error itself."""
    if isinstance(error, _dask().KilledWorker):
        return SceneError("workers die again and again over the same block: have they memory enough?")
    if isinstance(error, ModuleNotFoundError):
        return SceneError(f"the workers lack a package ({error}): install glsim[radiosity] where they run")
    return error


# ---------------------------------------------------------------- on the workers

_one_at_a_time = threading.Lock()  # each task uses all threads of its worker
_last: dict[str, Any] = {}


def _identity(value: Any) -> Any:
    """Return the argument: as the result of a task, which Dask repeats if a worker dies; data would be lost."""
    return value


def _compute_block(patches: Patches, first: int, last: int) -> Rows:
    """Return S of the patches ``first`` up to ``last`` with all from ``first`` on: (last - first, n - first)."""
    out = np.zeros((last - first, len(patches)), np.float32)
    with _one_at_a_time:
        visibility, seconds = _visibility(patches.scene), {"form factors": 0.0, "visibility": 0.0}
        upper_rows(patches, visibility, visibility.rays, first, last, False, out, seconds)
    return out[:, first:].copy()


def _block_product(block: Rows, B: Float, first: int) -> Float:
    """Return what a block adds to S B from row ``first`` on, (n - first, 3).

    Its rows count for its own patches and, since S is symmetric, its columns for all patches of higher number.
    """
    S = block.astype(np.float64)
    result = S.T @ B[first : first + len(S)]
    result[: len(S)] += S @ B[first:]
    return np.asarray(result)


def _row_part(block: Rows, offset: int, in_block: bool) -> Rows:
    """Return what a block holds of row i of S.

    offset: i minus the block's first row; in_block: whether i is one of its rows.

    Of a row that is not one of them the block holds a part as column ``offset``, because S is symmetric.
    """
    return np.concatenate([block[:offset, offset], block[offset, offset:]]) if in_block else block[:, offset]


def _irradiance(patches: Patches, points: Float, normals: Float, B: Float) -> Float:
    """Return formfactors.irradiance, with the rays of this worker."""
    with _one_at_a_time:
        return irradiance(patches, _visibility(patches.scene), points, normals, B)


def _visibility(scene: Scene) -> Visibility:
    """Return the visibility of a scene, with as many threads as this worker has, remembered for the last scene."""
    import numba

    threads = _dask().get_worker().state.nthreads
    numba.set_num_threads(min(threads, numba.get_num_threads()))
    if _last.get("scene") is not scene:
        _last.update(scene=scene, visibility=Visibility(Rays(scene, threads)))
    visibility: Visibility = _last["visibility"]
    return visibility
