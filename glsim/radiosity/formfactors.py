"""Form factors: how much of what leaves one patch arrives at another.

S[i, j] = A_i F_ij is stored, once for each pair, so that reciprocity A_i F_ij = A_j F_ji is exact.  F[i, j] is the
fraction of what leaves patch i that arrives at j; in a closed scene each row sums to 1.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.checkpoint import Checkpoint
from glsim.radiosity.patches import Patches
from glsim.radiosity.scene import SceneError

if TYPE_CHECKING:
    from glsim.radiosity.visibility import Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]
Progress = Callable[[str, int, int], object]  # stage, done, of
BLOCK = 1 << 21  # pairs at a time
NEGLIGIBLE = 0.02  # of what a patch sends to a point in the mean: less is left out
DIM = 3e-4  # of what all send to a point in the mean: for less, few rays are enough
METHODS = {
    "contour": "each polygon whole: contour integrals near, Lambert's formula far, visibility by rays",
    "analytic": "the same without visibility: nothing blocks anything",
    "point": "textbook: from centre to centre, cos cos A / (pi r^2), one ray",
    "disc": "from centre to disc, cos cos A / (pi r^2 + A), one ray",
    "monte-carlo": "rays between random points of both patches, with standard errors",
    "hemicube": "the scene as each patch sees it, drawn on half a cube (Cohen and Greenberg 1985)",
    "hierarchical": "links between levels of detail: for tens of thousands of patches",
}


@dataclass(frozen=True, repr=False)
class FormFactors:
    """S: (n, n) float32, symmetric.  visibility: rays in the scene, for what is asked later.  seconds: by stage.
    error: (n, n) standard errors of S, for "monte-carlo"."""

    patches: Patches
    visibility: Visibility
    S: NDArray[np.float32]
    method: str
    seconds: dict[str, float] = field(default_factory=dict)
    error: NDArray[np.float32] | None = None

    def __repr__(self) -> str:
        return f"<FormFactors of {self.patches.scene.name}: {len(self.S)} x {len(self.S)}, {self.method}>"

    def row(self, i: int) -> Float:
        """F[i, :], (n,)."""
        return np.asarray(self.S[i] / self.patches.area[i], np.float64)

    @property
    def F(self) -> Float:
        """The whole matrix, (n, n) float64: for small scenes and lessons."""
        return np.asarray(self.S / self.patches.area[:, None], np.float64)

    @property
    def row_sums(self) -> Float:
        """(n,): 1 in a closed scene, less where light escapes."""
        return np.asarray(self.S.sum(axis=1, dtype=np.float64) / self.patches.area)

    def times(self, B: Float) -> Float:
        """S B for B (n, 3), summed in float64."""
        from glsim.radiosity.sweep import product

        result = np.empty((len(self.S), 3))
        product(self.S, np.ascontiguousarray(B), result)
        return result

    def at_points(self, points: Float, ways: Float, patch: Int, B: Float) -> Float:
        """Irradiance (k, 3) at points with normals ``ways``, from all patches, whichever patch they are on."""
        return irradiance(self.patches, self.visibility, points, ways, B)

    @property
    def asymmetry(self) -> float:
        """The largest |S_ij - S_ji|: how far reciprocity is from being exact."""
        S = self.S
        return max(
            (float(np.abs(S[k : k + 512] - S[:, k : k + 512].T).max()) for k in range(0, len(S), 512)), default=0.0
        )

    def keep(self, checkpoint: str) -> None:
        """Save them where the next ``compute`` looks."""
        if self.method in ("contour", "analytic"):
            Checkpoint(checkpoint, self.patches, f"{self.method} False").save(rows=np.triu(self.S))

    def closed(self, rounds: int = 50) -> FormFactors:
        """Scaled symmetrically so that each row sums to 1: for scenes that are closed.  S_ij becomes c_i c_j S_ij."""
        area, S = self.patches.area, self.S.astype(np.float64)
        c = np.ones(len(area))
        for _ in range(rounds):
            c = np.sqrt(c * area / np.maximum(S @ c, 1e-300))
        return replace(self, S=(c[:, None] * S * c).astype(np.float32), error=None)


def irradiance(patches: Patches, visibility: Visibility, points: Float, ways: Float, B: Float) -> Float:
    """Irradiance (k, 3) at points with normals ``ways`` from patches of radiosity B."""
    from glsim.radiosity import kernels

    p = patches
    bright = brightness(p, B)
    least = NEGLIGIBLE / len(p) / bright
    factors = np.zeros((len(points), len(p)))
    kernels.gather(points, ways, p.rings, p.counts, p.normal, p.center, p.size, least, factors)
    rows, columns = np.nonzero(factors)
    dim = factors[rows, columns] < DIM / bright[columns]
    factors[rows, columns] *= visibility.from_points(points, ways, p, rows, columns, dim)
    return np.asarray(factors @ B)


def brightness(patches: Patches, B: Float) -> Float:
    """(n,): the radiosity of patches, as a part of the mean of all."""
    most = B.max(axis=1)
    return np.asarray(np.maximum(most / max(float(np.average(most, weights=patches.area)), 1e-300), 1e-300))


def memory_needed(n: int) -> int:
    """Bytes for the matrix."""
    return 4 * n * n


def compute(
    patches: Patches, method: str = "contour", *, exact: bool = False, threads: int | None = None,
    progress: Progress | None = None, seed: int = 0, samples: int = 64, limit: int | None = None,
    checkpoint: str | None = None,
) -> FormFactors:  # fmt: skip
    """All form factors.

    method: one of METHODS.  exact: contour integrals for all pairs, not only near ones.  samples, seed: of
    "monte-carlo".  threads: for rays; the result does not depend on it.  limit: bytes that the matrix may take, by
    default half of the machine's memory.  checkpoint: a file in which finished rows are kept when the work is
    interrupted, and from which they are taken if it is there.  Raises SceneError for another method, or if the matrix
    would not fit.
    """
    if method not in METHODS or method == "hierarchical":
        matrices = ", ".join(name for name in METHODS if name != "hierarchical")
        raise SceneError(f"the methods for form factors are {matrices}, not {method!r}")
    n = len(patches)
    allowed = limit if limit is not None else memory_of_machine() // 2
    if memory_needed(n) > allowed:
        raise SceneError(
            f"{n} patches need {memory_needed(n) / 2**30:.1f} GiB for their form factors, and there are"
            f" {allowed / 2**30:.1f} GiB: take fewer patches (--patches), links (--method hierarchical) or a"
            " cluster (--scheduler)"
        )
    from glsim.radiosity.visibility import Visibility

    tell = progress or (lambda stage, done, of: None)
    visibility = Visibility(patches.scene, threads)
    if method in ("contour", "analytic"):
        return _by_pairs(patches, visibility, method, exact, tell, checkpoint)
    from glsim.radiosity.hemicube import hemicube
    from glsim.radiosity.textbook import disc_or_point, monte_carlo

    start = time.perf_counter()
    error = None
    if method == "hemicube":
        S = hemicube(patches, tell)
    elif method == "monte-carlo":
        S, error = monte_carlo(patches, visibility, samples, seed, tell)
    else:
        S = disc_or_point(patches, visibility, disc=method == "disc", progress=tell)
    return FormFactors(patches, visibility, S, method, {"form factors": time.perf_counter() - start}, error)


def memory_of_machine() -> int:
    """Bytes of the machine."""
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (ValueError, OSError, AttributeError):
        return 8 * 2**30


def _by_pairs(
    patches: Patches, visibility: Visibility, method: str, exact: bool, tell: Progress, checkpoint: str | None
) -> FormFactors:
    """Blocks of rows: first what would arrive if nothing were in between, then the share that does."""
    n = len(patches)
    S = np.zeros((n, n), np.float32)
    seconds = {"form factors": 0.0, "visibility": 0.0}
    blocking = visibility if method == "contour" else None
    of = n * (n - 1) // 2
    kept = Checkpoint(checkpoint, patches, f"{method} {exact}")
    before = kept.load().get("rows", S[:0])
    first = len(before)
    S[:first] = before
    try:
        while first < n:
            last = next_rows(n, first)
            upper_rows(patches, blocking, first, last, exact, S[first:last], seconds)
            first = last
            tell("form factors", of - (n - first) * (n - first - 1) // 2, of)
    except KeyboardInterrupt:
        kept.save(rows=S[:first])
        raise
    kept.remove()
    for k in range(0, n, 1024):  # the lower half is the upper one
        S[k:, k : k + 1024] += np.triu(S[k : k + 1024, k:], 1).T if k else np.triu(S[:1024], 1).T
    return FormFactors(patches, visibility, S, method, seconds)


def next_rows(n: int, first: int, size: int | None = None) -> int:
    """Where the block of rows that begins at ``first`` ends, of about ``size`` pairs, by default BLOCK."""
    return min(n, first + max(1, (size or BLOCK) // (n - first)))


def upper_rows(
    patches: Patches, visibility: Visibility | None, first: int, last: int, exact: bool, out: NDArray[np.float32],
    seconds: dict[str, float],
) -> None:  # fmt: skip
    """S of patches first..last with all of higher number, into ``out`` (last - first, n)."""
    from glsim.radiosity import kernels

    p, start = patches, time.perf_counter()
    kernels.rows(p.rings, p.counts, p.normal, p.center, p.size, first, last, exact, out)
    middle = time.perf_counter()
    if visibility is not None:
        rows, columns = np.nonzero(out[:, first:])
        pairs = np.stack([rows + first, columns + first], axis=1)
        shares = visibility.fractions(p.rings, p.counts, p.normal, pairs)
        out[rows, columns + first] *= shares.astype(np.float32)
    seconds["form factors"] += middle - start
    seconds["visibility"] += time.perf_counter() - middle
