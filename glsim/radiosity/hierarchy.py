"""Hierarchical radiosity: far parts of the scene exchange light as wholes, near ones in detail.

Each patch is the root of a quadtree whose leaves are the elements.  A link joins two nodes that see each other, on
the coarsest levels on which it is accurate enough; n elements need about n links, not n^2 form factors.  Sources:
Hanrahan, Salzman and Aupperle, A rapid hierarchical radiosity algorithm (1991); Cohen & Wallace (1993), chapter 7.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.checkpoint import Checkpoint
from glsim.radiosity.formfactors import MENDED, NEGLIGIBLE, SHARES, TOO_MUCH, brightness, mending
from glsim.radiosity.links import along_links, link_factors, links_at
from glsim.radiosity.methods import compute, memory_of_machine
from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress, silent
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import SceneError
from glsim.radiosity.solvers import solved
from glsim.radiosity.tree import Tree
from glsim.radiosity.visibility import FIRST, Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]
BLOCK = 1 << 19  # pairs at a time
ACCURACY = 5e-5  # the error allowed in the radiosity that one link brings, in mean radiosities
SIZE = 36  # bytes of a link
NONE = np.zeros((0, 2), np.int64)  # pairs
SENDERS = 4000  # the assumed number of nodes that send light to a point
VARIES = 0.1  # the assumed relative difference between the radiosities of a node's parts


@dataclass(frozen=True, repr=False)
class Links:
    """k links between the nodes of a tree: a kind of factors.Factors.

    ends: (k, 2), the nodes p and q of each link; S: (k,) float32, A_p F_pq = A_q F_qp; tilt: (k, 2, 3) float32, how the
    form factor changes over either end, see links.along_links.  patches: the elements.  seconds: by stage.
    """

    tree: Tree
    visibility: Visibility
    ends: NDArray[np.int32]
    S: NDArray[np.float32]
    tilt: NDArray[np.float32]
    accuracy: float
    seconds: dict[str, float] = field(default_factory=dict)
    method: str = "hierarchical"

    def __repr__(self) -> str:
        return f"<Links of {self.tree.nodes.scene.name}: {len(self.S)} between {len(self.tree.nodes)} nodes>"

    @cached_property
    def patches(self) -> Patches:
        """The elements: the leaves of the tree."""
        return self.tree.nodes.chosen(self.tree.leaves)

    def times(self, B: Float) -> Float:
        """Return S B (n, 3) of the elements: pull radiosity up, send it along the links, push what arrives down."""
        area = self.tree.nodes.area[:, None]
        arriving, slopes = np.zeros((len(area), 3)), np.zeros((len(area), 3, 3))
        along_links(self.ends, self.S, self.tilt, *self.tree.pulled(B), arriving, slopes)
        return self.tree.pushed(arriving / area, slopes / area[:, None]) * self.patches.area[:, None]

    @property
    def row_sums(self) -> Float:
        """(n,): 1 in a closed scene, less where light escapes."""
        return np.asarray(self.times(np.ones((len(self.patches), 3)))[:, 0] / self.patches.area)

    def mended(self) -> Links:
        """Return links of which no element's row sums to more than TOO_MUCH; see formfactors.mending."""
        before = self.row_sums

        def scaled(c: Float) -> Links:
            of = self.tree.pulled(np.repeat(c[:, None], 3, axis=1))[0][:, 0]
            return replace(self, S=(self.S * of[self.ends[:, 0]] * of[self.ends[:, 1]]).astype(np.float32))

        c = mending(lambda c: scaled(c).row_sums if (c < 1.0).any() else before, len(before))
        if (c == 1.0).all():
            return self
        note = MENDED.format(int((before > TOO_MUCH).sum()), before.max())
        return replace(scaled(c), tree=replace(self.tree, nodes=self.tree.nodes.noted(note)))

    def keep(self, checkpoint: str) -> None:
        """Save the links in the file ``checkpoint``, from which the next ``linked`` takes them."""
        _checkpoint(checkpoint, self.tree, self.accuracy).save(ends=self.ends, S=self.S, tilt=self.tilt, open=NONE)

    def row(self, i: int) -> Float:
        """Return F[i, :], (n,), of one element: by reciprocity what all others would receive from it."""
        alone = np.zeros((len(self.patches), 3))
        alone[i] = 1.0
        return np.asarray(self.times(alone)[:, 0] / self.patches.area[i])

    def at_points(self, points: Float, normals: Float, patch: Int, B: Float) -> Float:
        """Return the irradiance (k, 3) at points (k, 3), with unit normals (k, 3), on the elements ``patch`` (k,).

        The light comes from all nodes linked to the element or to a node that it is part of, each with its own form
        factor at the point.
        """
        from scipy.sparse import csr_matrix

        nodes, radiosity = self.tree.nodes, self.tree.pulled(B)[0]
        bright = brightness(nodes, radiosity)
        least = NEGLIGIBLE / SENDERS / bright
        starts, others = self.by_node

        def factors_at(part: Int) -> tuple[Int, Int, Float]:
            at = (points[part], normals[part], self.tree.leaves[patch[part]])
            of = (nodes.corners, nodes.counts, nodes.normal, nodes.center, nodes.size, least)
            rows, columns, factors = links_at(*at, self.tree.parent, starts, others, *of)
            return part[rows], columns, factors

        parts = np.array_split(np.arange(len(points)), 8)
        rows, columns, factors = map(
            np.concatenate, zip(*self.visibility.rays.pool.map(factors_at, parts), strict=True)
        )
        kind = np.searchsorted(SHARES, factors * bright[columns])
        factors *= self.visibility.from_points(points, normals, nodes, rows, columns, kind)
        begin = np.searchsorted(rows, np.arange(len(points) + 1))
        return np.asarray(csr_matrix((factors, columns, begin), (len(points), len(nodes))) @ radiosity)

    @property
    def asymmetry(self) -> float:
        """0: each link is used in both directions."""
        return 0.0

    @property
    def matrix(self) -> None:
        """None: there are only links."""
        return None

    @cached_property
    def by_node(self) -> tuple[Int, NDArray[np.int32]]:
        """Return where each node's links begin, (N + 1,), and the nodes at their other ends, (2 k,)."""
        one = self.ends.T.ravel()
        order = np.argsort(one, kind="stable")
        starts = np.searchsorted(one[order], np.arange(len(self.tree.nodes) + 1))
        return starts, self.ends[:, ::-1].T.ravel()[order]


def linked(tree: Tree, accuracy: float = ACCURACY, rays: Rays | None = None, progress: Progress | None = None,
           limit: int | None = None, checkpoint: str | None = None) -> Links:  # fmt: skip
    """Link the nodes of a tree, and refine each link until it is accurate enough or its ends are elements.

    A link is accurate enough if the radiosity that it brings is off by at most ``accuracy`` mean radiosities in any
    part of its ends.  The radiosity of a node is estimated by that of its root, from a solution for the roots alone.

    checkpoint: see methods.compute.  Raises SceneError if the roots' form factors, or the links, would not fit into
    ``limit`` bytes (by default half of the machine's memory).
    """
    tell = progress or silent
    nodes, count = tree.nodes, tree.levels[1]
    roots = nodes.chosen(np.arange(count))
    coarse = compute(roots, rays=rays, limit=limit, progress=lambda _, done, of: tell("coarse solution", done, of))
    B = solved(coarse, tolerance=1e-3)[-1].B
    start = time.perf_counter()
    mean = float(np.average(B.mean(axis=1), weights=roots.area))
    store = _checkpoint(checkpoint, tree, accuracy)
    refiner = _Refiner(tree, B, accuracy * mean, coarse.visibility, store.load())
    pairs, allowed = len(refiner.open), limit if limit is not None else memory_of_machine() // 2
    try:
        while refiner.open:
            refiner.step()
            if SIZE * refiner.count > allowed:
                raise SceneError(
                    f"{SIZE * refiner.count / 2**30:.1f} GiB of links, and not all are found: take fewer patches"
                    " (--patches) or a lower --accuracy"
                )
            tell("links", pairs - min(len(refiner.open), pairs), pairs)
    except KeyboardInterrupt:
        ends, S, tilt = refiner.links()
        store.save(ends=ends, S=S, tilt=tilt, open=np.concatenate([NONE, *refiner.open]))
        raise
    store.remove()
    seconds = {"form factors": coarse.seconds["form factors"] + coarse.seconds["visibility"],
               "links": time.perf_counter() - start}  # fmt: skip
    return Links(tree, coarse.visibility, *refiner.links(), accuracy, seconds)


def _checkpoint(path: str | None, tree: Tree, accuracy: float) -> Checkpoint:
    """Return the checkpoint of a tree's links."""
    return Checkpoint(path, tree.nodes, f"hierarchical {accuracy}")


class _Refiner:
    """Turns pairs of nodes into links, block by block.

    state: blocks of pairs that are still open, and a list of (ends, S, tilt) of what is linked.  Both are replaced
    in one assignment, so that an interruption never leaves a step half done.
    """

    def __init__(
        self, tree: Tree, B: Float, least: float, visibility: Visibility, before: dict[str, NDArray[Any]]
    ) -> None:
        self.tree, self.least, self.visibility = tree, least, visibility
        root = np.arange(len(tree.nodes))
        for low, high in zip(tree.levels[1:-1], tree.levels[2:], strict=True):
            root[low:high] = root[tree.parent[low:high]]
        self.B = B[root]
        first = before.get("open", np.stack(np.triu_indices(tree.levels[1], 1), axis=1))
        self.state = _blocks(first)[::-1], [(before["ends"], before["S"], before["tilt"])] if before else []
        self.count = len(before.get("S", ()))

    @property
    def open(self) -> list[Int]:
        """Blocks of pairs that are neither links nor refined yet."""
        return self.state[0]

    def links(self) -> tuple[NDArray[np.int32], NDArray[np.float32], NDArray[np.float32]]:
        nothing = np.zeros((0, 2), np.int32), np.zeros(0, np.float32), np.zeros((0, 2, 3), np.float32)
        ends, S, tilt = zip(nothing, *self.state[1], strict=True)
        return np.concatenate(ends), np.concatenate(S), np.concatenate(tilt)

    def step(self) -> None:
        """Link the pairs of the last block that are accurate enough; replace each other pair by pairs of parts."""
        nodes, pairs = self.tree.nodes, self.open[-1]
        S, spread, tilt = np.empty(len(pairs)), np.empty((len(pairs), 2)), np.empty((len(pairs), 2, 3), np.float32)
        link_factors(
            nodes.corners, nodes.counts, nodes.normal, nodes.center, nodes.size, self.tree.child, pairs, S, tilt, spread
        )
        seeing = np.flatnonzero(S > 0.0)
        pairs, S, spread, tilt = pairs[seeing], S[seeing], spread[seeing], tilt[seeing]
        share, undecided = self.visibility.fractions_and_undecided(nodes, pairs)
        uneven = self._unevenness(pairs, S, spread, share, undecided) > self.least
        uneven &= self.tree.child[pairs] >= 0
        done = ~uneven.any(axis=1)
        linked = done & (share > 0.0)
        parts = self._parts(pairs[~done], uneven[~done])
        links = pairs[linked].astype(np.int32), (S * share)[linked].astype(np.float32), tilt[linked]
        self.count += len(links[1])
        self.state = [*self.open[:-1], *parts], [*self.state[1], links]

    def _unevenness(self, pairs: Int, S: Float, spread: Float, share: Float, undecided: Int) -> Float:
        """Estimate the error of the radiosity that a link of each pair would bring to any part of its two ends: (k, 2).

        The error has three causes: the form factor differs between the parts; some parts may be hidden; the radiosity
        varies over the sender.  The result is the largest of the three.
        """
        nodes = self.tree.nodes
        bright = np.stack([(nodes.rho[pairs[:, k]] * self.B[pairs[:, 1 - k]]).max(axis=1) for k in (0, 1)], axis=1)
        likely = (share[undecided] * FIRST + 0.5) / (FIRST + 1.0)  # 16 rays that agree are no proof
        doubt = np.zeros(len(pairs))
        doubt[undecided] = np.sqrt(likely * (1.0 - likely))
        area = nodes.area[pairs]
        sent = VARIES * spread * bright[:, ::-1] * area / area[:, ::-1]
        uneven = np.maximum(np.maximum(spread, (doubt * S)[:, None] / area) * bright, sent)
        uneven[(share == 0.0) & (doubt == 0.0)] = 0.0
        return np.asarray(uneven)

    def _parts(self, pairs: Int, uneven: NDArray[np.bool_]) -> list[Int]:
        """Divide the ends that are uneven, (k, 2), and return the pairs of their parts in blocks."""
        four = np.arange(4)
        parts = []
        for k in (0, 1):
            only = uneven[:, k] & ~uneven[:, 1 - k]
            halves = np.empty((int(only.sum()), 4, 2), np.int64)
            halves[:, :, k] = self.tree.child[pairs[only, k], None] + four
            halves[:, :, 1 - k] = pairs[only, 1 - k, None]
            parts.append(halves.reshape(-1, 2))
        both = pairs[uneven.all(axis=1)]
        quarters = np.empty((len(both), 4, 4, 2), np.int64)
        quarters[..., 0] = self.tree.child[both[:, 0], None, None] + four[:, None]
        quarters[..., 1] = self.tree.child[both[:, 1], None, None] + four
        return _blocks(np.concatenate([*parts, quarters.reshape(-1, 2)]))


def _blocks(pairs: Int) -> list[Int]:
    """Cut pairs (k, 2) into blocks of at most BLOCK."""
    return [pairs[k : k + BLOCK] for k in range(0, len(pairs), BLOCK)]
