"""Form factors: how much of what leaves one patch arrives at another.

S[i, j] = A_i F_ij is stored, once for each pair, so that reciprocity A_i F_ij = A_j F_ji is exact.  F[i, j] is the
fraction of what leaves patch i that arrives at j; in a closed scene each row sums to 1.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity import matrix, pairs
from glsim.radiosity.checkpoint import Checkpoint
from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress
from glsim.radiosity.visibility import Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]
BLOCK = 1 << 21  # pairs at a time
NEGLIGIBLE = 0.02  # of what a patch sends to a point in the mean: less is left out
DIM = 3e-4  # of what all send to a point in the mean: for less, few rays are enough


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
    def matrix(self) -> NDArray[np.float32]:
        """S, see factors.Factors."""
        return self.S

    @property
    def row_sums(self) -> Float:
        """(n,): 1 in a closed scene, less where light escapes."""
        return np.asarray(self.S.sum(axis=1, dtype=np.float64) / self.patches.area)

    def times(self, B: Float) -> Float:
        """S B for B (n, 3), summed in float64."""
        result = np.empty((len(self.S), 3))
        matrix.product(self.S, np.ascontiguousarray(B), result)
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
    p = patches
    bright = brightness(p, B)
    least = NEGLIGIBLE / len(p) / bright
    factors = np.zeros((len(points), len(p)))
    pairs.point_factors(points, ways, p.rings, p.counts, p.normal, p.center, p.size, least, factors)
    rows, columns = np.nonzero(factors)
    dim = factors[rows, columns] < DIM / bright[columns]
    factors[rows, columns] *= visibility.from_points(points, ways, p, rows, columns, dim)
    return np.asarray(factors @ B)


def brightness(patches: Patches, B: Float) -> Float:
    """(n,): the radiosity of patches, as a part of the mean of all."""
    most = B.max(axis=1)
    return np.asarray(np.maximum(most / max(float(np.average(most, weights=patches.area)), 1e-300), 1e-300))


def by_pairs(
    patches: Patches,
    visibility: Visibility | None,
    method: str,
    exact: bool,
    progress: Progress,
    checkpoint: str | None,
) -> tuple[NDArray[np.float32], dict[str, float]]:
    """Blocks of rows: first what would arrive if nothing were in between, then the share that does."""
    n = len(patches)
    S = np.zeros((n, n), np.float32)
    seconds = {"form factors": 0.0, "visibility": 0.0}
    of = n * (n - 1) // 2
    stored = Checkpoint(checkpoint, patches, f"{method} {exact}")
    before = stored.load().get("rows", S[:0])
    first = len(before)
    S[:first] = before
    try:
        while first < n:
            last = next_rows(n, first)
            upper_rows(patches, visibility, first, last, exact, S[first:last], seconds)
            first = last
            progress("form factors", of - (n - first) * (n - first - 1) // 2, of)
    except KeyboardInterrupt:
        stored.save(rows=S[:first])
        raise
    stored.remove()
    for k in range(0, n, 1024):  # the lower half is the upper one
        S[k:, k : k + 1024] += np.triu(S[k : k + 1024, k:], 1).T if k else np.triu(S[:1024], 1).T
    return S, seconds


def next_rows(n: int, first: int, size: int | None = None) -> int:
    """Where the block of rows that begins at ``first`` ends, of about ``size`` pairs, by default BLOCK."""
    return min(n, first + max(1, (size or BLOCK) // (n - first)))


def upper_rows(
    patches: Patches, visibility: Visibility | None, first: int, last: int, exact: bool, out: NDArray[np.float32],
    seconds: dict[str, float],
) -> None:  # fmt: skip
    """S of patches first..last with all of higher number, into ``out`` (last - first, n)."""
    p, start = patches, time.perf_counter()
    pairs.rows(p.rings, p.counts, p.normal, p.center, p.size, first, last, exact, out)
    middle = time.perf_counter()
    if visibility is not None:
        rows, columns = np.nonzero(out[:, first:])
        numbers = np.stack([rows + first, columns + first], axis=1)
        shares = visibility.fractions(p.rings, p.counts, p.normal, numbers)
        out[rows, columns + first] *= shares.astype(np.float32)
    seconds["form factors"] += middle - start
    seconds["visibility"] += time.perf_counter() - middle
