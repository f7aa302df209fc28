"""How much of one patch another one sees: rays between sample points, against the scene's polygons.

The share of a pair's form factor that is not blocked is sum w V / sum w, over rays with the kernel's weights
w = cos(theta_1) cos(theta_2) / r^2.  Sixteen rays first; where they disagree, 48 more, in groups of sixteen.  The
points depend on the pair alone, so results are the same however many threads work.  With fewer than FEW patches, which
are large, each pair gets twice as many rays.

Why only some of the later groups count.  Through a distant door the true share may be 0.02, and then the first 16 rays
of most pairs are all blocked: such a pair is taken as hidden.  Were the shares of the other pairs right, the mean over
all pairs would be too small.  So a pair whose first rays disagree adds only those later groups whose rays disagree too:
its share becomes larger, by as much as the hidden pairs lack, because every group of rays, whether it comes first or
later, is then taken under the same condition.
"""

from __future__ import annotations

import threading
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.bodies import HIDDEN, UNDECIDED, bodies_of, decide
from glsim.radiosity.patches import Patches
from glsim.radiosity.rays import Rays, Single
from glsim.radiosity.samples import Surface, add_seen, rays_between, rays_from_points

Float = NDArray[np.float64]
Int = NDArray[np.int64]
FIRST, MORE = 16, 48  # rays of a pair
FEW = 1000  # patches, of which each pair gets twice as many
CHUNK = 1 << 12  # pairs at a time, in each thread


class Effort(NamedTuple):
    """How many rays a point sends to a patch: ``first``, and where these disagree ``more``."""

    first: int
    more: int


EFFORTS = Effort(2, 0), Effort(4, 12), Effort(12, MORE)  # to a patch that sends little, more, much

# Row k of TABLE: the fractional parts of k / r, k / r^2, k / r^3, k / r^4 with r = _ROOT, which are evenly spread over
# the four-dimensional unit cube (Roberts 2018).
_ROOT = 1.1673039782614187  # x^5 = x + 1
TABLE = np.outer(np.arange(2 * (FIRST + MORE)), [_ROOT**-k for k in range(1, 5)]) % 1.0


def _surface(patches: Patches, middle: Float) -> Surface:
    """Return where rays to patches begin and end; middle: (3,), the origin of their coordinates."""
    c = patches.clusters
    if c is None:
        none = np.full(len(patches), -1), np.zeros(1, np.int64), np.zeros(0)
        return Surface(patches.corners - middle, patches.counts, patches.normal, *none,
                       np.zeros((0, 4, 3)), patches.counts[:0], np.zeros((0, 3)))  # fmt: skip
    return Surface(patches.corners - middle, patches.counts, patches.normal, c.of, c.start, c.share,
                   c.pieces.corners - middle, c.pieces.counts, c.pieces.normal)  # fmt: skip


class Visibility:
    """How much patches of a scene see of each other.

    rays: of the scene; bodies: convex regions outside of which nothing can block, see bodies.bodies_of; None if they
    are too many to be of use.
    """

    def __init__(self, rays: Rays) -> None:
        self.rays = rays
        self.bodies = bodies_of(rays.scene)
        self.last_reach: tuple[Float, Single] | None = None
        self.local = threading.local()

    def fractions(self, patches: Patches, pairs: Int) -> Float:
        """Return the share of each pair's form factor that is not blocked: (k,), in [0, 1].

        pairs: (k, 2), numbers of patches.
        """
        return self.fractions_and_undecided(patches, pairs)[0]

    def fractions_and_undecided(self, patches: Patches, pairs: Int) -> tuple[Float, Int]:
        """Return the same shares as ``fractions``, and the numbers of the pairs that rays decided.

        The bodies alone decide the other pairs, whose shares, 0 or 1, are certain.
        """
        reach = self._reach_of(patches)
        result, undecided = self._by_bodies(reach, reach, pairs[:, 0], pairs[:, 1])
        surface = _surface(patches, self.rays.middle)
        chunks = [undecided[k : k + CHUNK] for k in range(0, len(undecided), CHUNK)]
        work = self.rays.pool.map(lambda chunk: self._chunk(surface, pairs[chunk]), chunks)
        for chunk, values in zip(chunks, work, strict=True):
            result[chunk] = values
        return result, undecided

    def _reach_of(self, patches: Patches) -> Single | None:
        """Return Bodies.reach of patches, remembered for the patches that were asked for last."""
        if self.bodies is None:
            return None
        if self.last_reach is None or self.last_reach[0] is not patches.corners:
            reach, clusters = self.bodies.reach(patches.corners), patches.clusters
            if clusters is not None:
                of, begin = self.bodies.reach(clusters.pieces.corners), clusters.start[:-1]
                both = np.minimum.reduceat(of[..., 0], begin), np.maximum.reduceat(of[..., 1], begin)
                reach[patches.is_cluster] = np.stack(both, axis=2)[clusters.of[patches.is_cluster]]
            self.last_reach = patches.corners, reach
        return self.last_reach[1]

    def _by_bodies(self, reach_i: Single | None, reach_j: Single | None, rows: Int, columns: Int) -> tuple[Float, Int]:
        """Return the share of each pair (k,) as far as the bodies tell it, and the numbers of the pairs that need rays.

        reach_i, reach_j: Bodies.reach of the ends ``rows`` (k,) and ``columns`` (k,).
        """
        bodies = self.bodies
        if bodies is None:
            return np.ones(len(rows)), np.arange(len(rows))
        verdict = np.empty(len(rows), np.uint8)

        def decide_chunk(k: int) -> None:
            """Decide CHUNK pairs from number k on."""
            part = slice(k, k + CHUNK)
            decide(
                reach_i, reach_j, rows[part], columns[part], bodies.starts, bodies.solid, bodies.exact, verdict[part]
            )

        list(self.rays.pool.map(decide_chunk, range(0, len(rows), CHUNK)))
        return (verdict != HIDDEN).astype(np.float64), np.flatnonzero(verdict == UNDECIDED)

    def from_points(
        self, points: Float, normals: Float, patches: Patches, rows: Int, columns: Int, kind: Int,
        efforts: tuple[Effort, ...] = EFFORTS,
    ) -> Float:  # fmt: skip
        """Return the share of the form factor from points[rows] to patches[columns] that is not blocked: (k,).

        points: (m, 3), with unit normals (m, 3); rows, columns: (k,); kind: (k,), for each pair the number of its
        effort in ``efforts``.
        """
        reach = self.bodies.reach(points[:, None]) if self.bodies is not None else None
        result, undecided = self._by_bodies(reach, self._reach_of(patches), rows, columns)
        points, surface = points - self.rays.middle, _surface(patches, self.rays.middle)
        work = []
        for number, (first, more) in enumerate(efforts):
            some, step = undecided[kind[undecided] == number], max(1, CHUNK * FIRST // first)
            work += [(some[k : k + step], first, more) for k in range(0, len(some), step)]

        def shares(chunk: Int, count: int, more: int) -> Float:
            seen, total = np.zeros(len(chunk)), np.zeros(len(chunk))
            arrays = (points, normals, rows[chunk], surface, columns[chunk])
            self._send(arrays, 0, count, count, seen, total)
            mixed = np.flatnonzero((seen > 0.0) & (seen < total))
            if more and len(mixed):
                arrays = (points, normals, rows[chunk[mixed]], surface, columns[chunk[mixed]])
                seen_more, total_more = np.zeros(len(mixed)), np.zeros(len(mixed))
                self._send(arrays, count, more, count, seen_more, total_more)
                seen[mixed] += seen_more
                total[mixed] += total_more
            return np.divide(seen, total, out=np.zeros_like(seen), where=total > 0.0)

        for (chunk, _, _), values in zip(work, self.rays.pool.map(lambda task: shares(*task), work), strict=True):
            result[chunk] = values
        return result

    def _send(self, arrays: Any, first: int, count: int, group: int, seen: Float, total: Float) -> None:
        """Send the rays ``first`` to ``first + count`` of each point and patch, and add their weights, see add_seen."""
        origins, directions, weights = self._arrays(len(seen) * count)
        points, normals, rows, surface, columns = arrays
        rays_from_points(
            points, normals, rows, surface, columns, self.rays.gap, first, count, origins, directions, weights
        )
        add_seen(weights, self.rays.blocked(origins, directions), count, group, first > 0, seen, total)

    def _chunk(self, surface: Surface, pairs: Int) -> Float:
        """Return the share of each pair (k, 2) by rays alone, in this thread: (k,)."""
        seen, total = np.zeros(len(pairs)), np.zeros(len(pairs))
        times = 2 if len(surface.corners) < FEW else 1
        group = times * FIRST
        self._shoot(surface, pairs, 0, group, group, seen, total)
        mixed = np.flatnonzero((seen > 0.0) & (seen < total))
        if len(mixed):
            seen_more, total_more = np.zeros(len(mixed)), np.zeros(len(mixed))
            self._shoot(surface, pairs[mixed], group, times * MORE, group, seen_more, total_more)
            seen[mixed] += seen_more
            total[mixed] += total_more
        return np.divide(seen, total, out=np.zeros_like(seen), where=total > 0.0)

    def _shoot(
        self, surface: Surface, pairs: Int, first: int, count: int, group: int, seen: Float, total: Float
    ) -> None:
        """Send the rays ``first`` to ``first + count`` of each pair, and add their weights, see add_seen."""
        origins, directions, weights = self._arrays(len(pairs) * count)
        rays_between(surface, pairs, TABLE, self.rays.gap, first, count, origins, directions, weights)
        add_seen(weights, self.rays.blocked(origins, directions), count, group, first > 0, seen, total)

    def _arrays(self, size: int) -> tuple[Single, Single, Float]:
        """Return origins, directions and weights for ``size`` rays; each thread has its own arrays and reuses them."""
        arrays = getattr(self.local, "arrays", None)
        if arrays is None or len(arrays[2]) < size:
            arrays = np.empty((size, 3), np.float32), np.empty((size, 3), np.float32), np.empty(size)
            self.local.arrays = arrays
        return arrays[0][:size], arrays[1][:size], arrays[2][:size]
