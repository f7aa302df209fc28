"""Form factors: how much of what leaves one patch arrives at another.

S[i, j] = A_i F_ij is stored, once for each pair, so that reciprocity A_i F_ij = A_j F_ji is exact.  F[i, j] is the
fraction of what leaves patch i that arrives at j; in a closed scene each row sums to 1.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity import matrix, pairs
from glsim.radiosity.checkpoint import Checkpoint
from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress
from glsim.radiosity.rays import Rays
from glsim.radiosity.visibility import Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]
BLOCK = 1 << 21  # pairs at a time
AT_ONCE = 16  # rows or points that a thread takes
TOO_MUCH = 1.01  # a row of form factors that sums to more is mended; rays alone are off by less
MENDED = (
    "patches at which more than all light would arrive (things that reach into each other), mended: {}, worst {:.2f}"
)
NEGLIGIBLE = 0.02  # of the mean light from one patch at a point: form factors that bring less are left out
SHARES = 3e-4, 3e-3  # of the mean light at a point: pairs that bring less than these get fewer rays


@dataclass(frozen=True, repr=False)
class FormFactors:
    """The matrix of form factors of n patches: a kind of factors.Factors.

    S: (n, n) float32, S_ij = A_i F_ij, symmetric; method: a name of methods.METHODS; seconds: by stage; error: (n, n),
    the standard errors of S, of "monte-carlo" alone.
    """

    patches: Patches
    visibility: Visibility
    S: NDArray[np.float32]
    method: str
    seconds: dict[str, float] = field(default_factory=dict)
    error: NDArray[np.float32] | None = None

    def __repr__(self) -> str:
        return f"<FormFactors of {self.patches.scene.name}: {len(self.S)} x {len(self.S)}, {self.method}>"

    def row(self, i: int) -> Float:
        """Return F[i, :], (n,): the shares of patch i's light that arrive at each patch."""
        return np.asarray(self.S[i] / self.patches.area[i], np.float64)

    @property
    def F(self) -> Float:
        """F as a matrix (n, n) float64: for small scenes and lessons."""
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
        """Return S B (n, 3) for B (n, 3), summed in float64."""
        result = np.empty((len(self.S), 3))
        matrix.product(self.S, np.ascontiguousarray(B), result)
        return result

    def at_points(self, points: Float, normals: Float, patch: Int, B: Float) -> Float:
        """Return the irradiance (k, 3) at points (k, 3) with unit normals (k, 3), from all patches."""
        return irradiance(self.patches, self.visibility, points, normals, B)

    @property
    def asymmetry(self) -> float:
        """The largest |S_ij - S_ji|: how far reciprocity is from being exact."""
        S = self.S
        return max(
            (float(np.abs(S[k : k + 512] - S[:, k : k + 512].T).max()) for k in range(0, len(S), 512)), default=0.0
        )

    def keep(self, checkpoint: str) -> None:
        """Save S in the file ``checkpoint``, which the next ``compute`` reads; only for "contour" and "analytic"."""
        if self.method in ("contour", "analytic"):
            Checkpoint(checkpoint, self.patches, f"{self.method} False").save(rows=np.triu(self.S))

    def mended(self) -> FormFactors:
        """Return form factors of which no row sums to more than TOO_MUCH; see ``mending``."""
        S, area = self.S, self.patches.area
        before = self.row_sums
        c = mending(lambda c: c * (S @ c.astype(np.float32)) / area if (c < 1.0).any() else before, len(area))
        less = np.flatnonzero(c < 1.0)
        if not len(less):
            return self
        S[less] *= c[less, None].astype(np.float32)
        S[:, less] *= c[less].astype(np.float32)
        return replace(self, patches=self.patches.noted(MENDED.format(int((before > TOO_MUCH).sum()), before.max())))

    def closed(self, rounds: int = 50) -> FormFactors:
        """Return form factors scaled so that each row sums to 1, for scenes that are closed.

        S_ij becomes c_i c_j S_ij, which stays symmetric; the factors c are found by iteration.
        """
        area, S = self.patches.area, self.S.astype(np.float64)
        c = np.ones(len(area))
        for _ in range(rounds):
            c = np.sqrt(c * area / np.maximum(S @ c, 1e-300))
        return replace(self, S=(c[:, None] * S * c).astype(np.float32), error=None)


def mending(sums: Callable[[Float], Float], n: int) -> Float:
    """Return factors c (n,), at most 1, with which no row of c_i c_j S_ij / A_i sums to more than TOO_MUCH.

    More than 1 cannot arrive at a patch, but polygons that reach into each other may be seen twice.  sums: the row sums
    for given c (n,).
    """
    c = np.ones(n)
    for _ in range(50):
        now = sums(c)
        if now.max(initial=0.0) <= TOO_MUCH:
            break
        c = np.where(now > TOO_MUCH, c * np.sqrt(1.0 / np.maximum(now, 1.0)), c)
    return c


def irradiance(patches: Patches, visibility: Visibility, points: Float, normals: Float, B: Float) -> Float:
    """Return the irradiance (k, 3) at points (k, 3) with unit normals (k, 3), from patches of radiosity B (n, 3).

    Form factors along which hardly any light comes are left out (NEGLIGIBLE), others get few rays (SHARES).
    """
    p = patches
    bright = brightness(p, B)
    least = NEGLIGIBLE / len(p) / bright
    factors = np.zeros((len(points), len(p)))
    factors_at(points, normals, p, least, visibility.rays, factors)
    rows, columns = np.nonzero(factors)
    kind = np.searchsorted(SHARES, factors[rows, columns] * bright[columns])
    factors[rows, columns] *= visibility.from_points(points, normals, p, rows, columns, kind)
    return np.asarray(factors @ B)


def factors_at(points: Float, normals: Float, patches: Patches, least: Float, rays: Rays, out: Float) -> None:
    """Write pairs.point_factors of points (k, 3) and all patches into out (k, n), in the threads of ``rays``."""
    p = patches

    def some(first: int, last: int) -> None:
        here = slice(first, last)
        of = (p.corners, p.counts, p.normal, p.center, p.size)
        pairs.point_factors(points[here], normals[here], *of, least, out[here])

    rays.share(some, len(points), AT_ONCE)


def brightness(patches: Patches, B: Float) -> Float:
    """Return the brightest channel of B (n, 3), relative to its mean over the area: (n,), more than 0."""
    most = B.max(axis=1)
    return np.asarray(np.maximum(most / max(float(np.average(most, weights=patches.area)), 1e-300), 1e-300))


def by_pairs(
    patches: Patches,
    visibility: Visibility | None,
    rays: Rays,
    method: str,
    exact: bool,
    progress: Progress,
    checkpoint: str | None,
) -> tuple[NDArray[np.float32], dict[str, float]]:
    """Return S (n, n), computed in blocks of rows, and the seconds of each stage.

    S of a pair is its value without occlusion times the share that is not blocked; if ``visibility`` is None, nothing
    is blocked.  The other arguments: see methods.compute.
    """
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
            upper_rows(patches, visibility, rays, first, last, exact, S[first:last], seconds)
            first = last
            progress("form factors", of - (n - first) * (n - first - 1) // 2, of)
    except KeyboardInterrupt:
        stored.save(rows=S[:first])
        raise
    stored.remove()
    for k in range(0, n, 1024):  # S is symmetric: add the upper triangle to the lower one
        S[k:, k : k + 1024] += np.triu(S[k : k + 1024, k:], 1).T if k else np.triu(S[:1024], 1).T
    return S, seconds


def next_rows(n: int, first: int, size: int | None = None) -> int:
    """Return where the block of rows that begins at ``first`` ends, if it has about ``size`` pairs (default: BLOCK)."""
    return min(n, first + max(1, (size or BLOCK) // (n - first)))


def upper_rows(
    patches: Patches, visibility: Visibility | None, rays: Rays, first: int, last: int, exact: bool,
    out: NDArray[np.float32], seconds: dict[str, float],
) -> None:  # fmt: skip
    """Write S of patches ``first`` up to ``last`` with all of higher number into out (last - first, n).

    visibility: None if nothing blocks.  rays: whose threads work.  seconds: of each stage; the time of this call is
    added to them.
    """
    p, start = patches, time.perf_counter()

    def some(begin: int, end: int) -> None:
        of = (p.corners, p.counts, p.normal, p.center, p.size)
        pairs.rows(*of, first + begin, first + end, exact, out[begin:end])

    rays.share(some, last - first, AT_ONCE)
    middle = time.perf_counter()
    if visibility is not None:
        rows, columns = np.nonzero(out[:, first:])
        numbers = np.stack([rows + first, columns + first], axis=1)
        shares = visibility.fractions(p, numbers)
        out[rows, columns + first] *= shares.astype(np.float32)
    seconds["form factors"] += middle - start
    seconds["visibility"] += time.perf_counter() - middle
