"""Hierarchical radiosity: far parts of the scene exchange light as wholes, near ones in detail.

Each patch is the root of a quadtree whose leaves are the elements.  A link joins two nodes that see each other, on
whatever levels the light between them is even enough; n elements need about n links, not n^2 form factors.  Sources:
Hanrahan, Salzman and Aupperle, A rapid hierarchical radiosity algorithm (1991); Cohen & Wallace (1993), chapter 7.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.checkpoint import Checkpoint
from glsim.radiosity.formfactors import DIM, NEGLIGIBLE, brightness
from glsim.radiosity.links import along_links, link_factors, links_at
from glsim.radiosity.methods import compute, memory_of_machine
from glsim.radiosity.patches import Patches, patches_from
from glsim.radiosity.progress import Progress, silent
from glsim.radiosity.quadtree import quarters
from glsim.radiosity.scene import Scene, SceneError
from glsim.radiosity.solvers import solved
from glsim.radiosity.subdivide import length_for, number_of_cells, subdivide
from glsim.radiosity.visibility import FIRST, Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]
ROOTS = 1600  # about how many patches there are at most before they are divided
DEEPEST = 6  # levels below a root
BLOCK = 1 << 19  # pairs at a time
ACCURACY = 5e-5  # how uneven, in mean radiosities, the light of one link may be
SIZE = 36  # bytes of a link
NONE = np.zeros((0, 2), np.int64)  # pairs
SENDERS = 4000  # about as many nodes send light to a point
VARIES = 0.1  # by so much, it is assumed, the radiosity of a node's parts differs


@dataclass(frozen=True, repr=False)
class Tree:
    """Quadtrees over patches.

    nodes: all of them, level by level, the roots first; parent: (N,), -1 for roots; child: (N,) the first of four that
    follow each other, -1 for leaves; levels: where each level begins, and the end.
    """

    nodes: Patches
    parent: Int
    child: Int
    levels: tuple[int, ...]

    def __repr__(self) -> str:
        return f"<Tree of {self.nodes.scene.name}: {len(self.nodes)} nodes, {len(self.leaves)} elements>"

    @cached_property
    def leaves(self) -> Int:
        """(n,): the node of each element."""
        return np.flatnonzero(self.child < 0)

    def pulled(self, B: Float) -> tuple[Float, Float]:
        """Of all nodes, from the radiosity of the elements (n, 3): means by area (N, 3), and means of B (x - center),
        (N, 3, 3) by channel and direction."""
        nodes = self.nodes
        power, moments = np.zeros((len(nodes), 3)), np.zeros((len(nodes), 3, 3))
        power[self.leaves] = B * nodes.area[self.leaves, None]
        for low, high in reversed(list(zip(self.levels[:-1], self.levels[1:], strict=True))):
            inner = low + np.flatnonzero(self.child[low:high] >= 0)
            parts = self.child[inner, None] + np.arange(4)
            power[inner] = power[parts].sum(axis=1)
            apart = nodes.center[parts] - nodes.center[inner, None]
            moments[inner] = (moments[parts] + power[parts][..., None] * apart[:, :, None, :]).sum(axis=1)
        return power / nodes.area[:, None], moments / nodes.area[:, None, None]

    def pushed(self, H: Float, slopes: Float) -> Float:
        """Irradiance of the elements (n, 3): what arrives at nodes, H + slope (x - center), arrives at all below."""
        H, slopes, center = H.copy(), slopes.copy(), self.nodes.center
        for low, high in zip(self.levels[1:-1], self.levels[2:], strict=True):
            above = self.parent[low:high]
            apart = center[low:high] - center[above]
            H[low:high] += H[above] + np.einsum("ncd,nd->nc", slopes[above], apart)
            slopes[low:high] += slopes[above]
        return np.asarray(H[self.leaves])


def tree_over(roots: Patches, length: float) -> Tree:
    """Patches divided until their edges are about ``length``."""
    edges = np.sqrt(roots.area * np.where(roots.counts == 4, 1.0, 2.0))
    depth = np.clip(np.round(np.log2(np.maximum(edges / length, 1e-9))), 0, DEEPEST).astype(np.int64)
    rings, counts, polygon = [roots.rings], [roots.counts], [roots.polygon]
    parent, child, levels = [np.full(len(roots), -1)], [np.full(len(roots), -1)], [0, len(roots)]
    while (inner := np.flatnonzero(depth > 0)).size:
        child[-1][inner] = levels[-1] + 4 * np.arange(len(inner))
        parent.append(np.repeat(levels[-2] + inner, 4))
        depth = np.repeat(depth[inner] - 1, 4)
        child.append(np.full(len(depth), -1))
        rings.append(quarters(rings[-1][inner], counts[-1][inner]).reshape(-1, 4, 3))
        counts.append(np.repeat(counts[-1][inner], 4))
        polygon.append(np.repeat(polygon[-1][inner], 4))
        levels.append(levels[-1] + len(depth))
    level = np.repeat(np.arange(len(rings)), [len(part) for part in rings])
    whole = np.concatenate(rings), np.concatenate(counts), np.concatenate(polygon)
    nodes = patches_from(roots.scene, *whole, level)
    return Tree(nodes, np.concatenate(parent), np.concatenate(child), tuple(levels))


def tree_of(scene: Scene, count: int) -> Tree:
    """About ``count`` elements over as few roots as the scene's polygons need, or ROOTS."""
    length = length_for(scene, count)
    fewest = max(ROOTS, 2 * number_of_cells(scene, scene.size))
    depth = 0
    while depth < DEEPEST and number_of_cells(scene, length * 2.0**depth) > fewest:
        depth += 1
    return tree_over(subdivide(scene, length=length * 2.0**depth), length)


@dataclass(frozen=True, repr=False)
class Links:
    """ends: (k, 2) nodes; S: (k,) float32, A_p F_pq = A_q F_qp; tilt: (k, 2, 3) float32, how the form factor changes
    over either end, see links.along_links.  visibility: rays in the scene, for what is asked later.  patches: the
    elements.  seconds: by stage."""

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
        nodes, leaves = self.tree.nodes, self.tree.leaves
        return patches_from(
            nodes.scene, nodes.rings[leaves], nodes.counts[leaves], nodes.polygon[leaves], nodes.level[leaves]
        )

    def times(self, B: Float) -> Float:
        """S B for the elements: pull, gather along the links, push."""
        area = self.tree.nodes.area[:, None]
        arriving, slopes = np.zeros((len(area), 3)), np.zeros((len(area), 3, 3))
        along_links(self.ends, self.S, self.tilt, *self.tree.pulled(B), arriving, slopes)
        return self.tree.pushed(arriving / area, slopes / area[:, None]) * self.patches.area[:, None]

    @property
    def row_sums(self) -> Float:
        """(n,): 1 in a closed scene, less where light escapes."""
        return np.asarray(self.times(np.ones((len(self.patches), 3)))[:, 0] / self.patches.area)

    def keep(self, checkpoint: str) -> None:
        """Save them where the next ``linked`` looks."""
        _checkpoint(checkpoint, self.tree, self.accuracy).save(ends=self.ends, S=self.S, tilt=self.tilt, open=NONE)

    def row(self, i: int) -> Float:
        """F[i, :], (n,), for one element: what it would send everywhere."""
        alone = np.zeros((len(self.patches), 3))
        alone[i] = 1.0
        return np.asarray(self.times(alone)[:, 0] / self.patches.area[i])

    def at_points(self, points: Float, ways: Float, patch: Int, B: Float) -> Float:
        """Irradiance (k, 3) at points with normals ``ways`` on the elements ``patch``: from all nodes linked to the
        element or to what it is part of, each with its own form factor at the point."""
        from scipy.sparse import csr_matrix

        nodes, radiosity = self.tree.nodes, self.tree.pulled(B)[0]
        bright = brightness(nodes, radiosity)
        least = NEGLIGIBLE / SENDERS / bright
        starts, others = self.by_node

        def found(part: Int) -> tuple[Int, Int, Float]:
            at = (points[part], ways[part], self.tree.leaves[patch[part]])
            of = (nodes.rings, nodes.counts, nodes.normal, nodes.center, nodes.size, least)
            rows, columns, factors = links_at(*at, self.tree.parent, starts, others, *of)
            return part[rows], columns, factors

        parts = np.array_split(np.arange(len(points)), 8)
        rows, columns, factors = map(np.concatenate, zip(*self.visibility.pool.map(found, parts), strict=True))
        dim = factors < DIM / bright[columns]
        factors *= self.visibility.from_points(points, ways, nodes, rows, columns, dim)
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
        """Where each node's links begin (N + 1,), and the nodes at their other ends (2 k,)."""
        one = self.ends.T.ravel()
        order = np.argsort(one, kind="stable")
        starts = np.searchsorted(one[order], np.arange(len(self.tree.nodes) + 1))
        return starts, self.ends[:, ::-1].T.ravel()[order]


def linked(tree: Tree, accuracy: float = ACCURACY, threads: int | None = None, progress: Progress | None = None,
           limit: int | None = None, checkpoint: str | None = None) -> Links:  # fmt: skip
    """The links of a tree, each refined until the light along it is even to ``accuracy`` mean radiosities or its ends
    are elements.  How bright the nodes are is known from a solution for the roots alone.

    checkpoint: see methods.compute.  Raises SceneError if the roots' form factors, or the links, would not fit into
    ``limit`` bytes (by default half of the machine's memory).
    """
    tell = progress or silent
    nodes, count = tree.nodes, tree.levels[1]
    roots = patches_from(nodes.scene, nodes.rings[:count], nodes.counts[:count], nodes.polygon[:count])
    coarse = compute(
        roots, threads=threads, limit=limit, progress=lambda _, done, of: tell("coarse solution", done, of)
    )
    B = solved(coarse, tolerance=1e-3)[-1].B
    start = time.perf_counter()
    mean = float(np.average(B.mean(axis=1), weights=roots.area))
    kept = _checkpoint(checkpoint, tree, accuracy)
    refiner = _Refiner(tree, B, accuracy * mean, coarse.visibility, kept.load())
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
        kept.save(ends=ends, S=S, tilt=tilt, open=np.concatenate([NONE, *refiner.open]))
        raise
    kept.remove()
    seconds = {"form factors": coarse.seconds["form factors"] + coarse.seconds["visibility"],
               "links": time.perf_counter() - start}  # fmt: skip
    return Links(tree, coarse.visibility, *refiner.links(), accuracy, seconds)


def _checkpoint(path: str | None, tree: Tree, accuracy: float) -> Checkpoint:
    return Checkpoint(path, tree.nodes, f"hierarchical {accuracy}")


class _Refiner:
    """state: blocks of pairs that are still open, and what is linked: ends and S.  One thing, so that an interruption
    never finds half a step."""

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
        return self.state[0]

    def links(self) -> tuple[NDArray[np.int32], NDArray[np.float32], NDArray[np.float32]]:
        nothing = np.zeros((0, 2), np.int32), np.zeros(0, np.float32), np.zeros((0, 2, 3), np.float32)
        ends, S, tilt = zip(nothing, *self.state[1], strict=True)
        return np.concatenate(ends), np.concatenate(S), np.concatenate(tilt)

    def step(self) -> None:
        """Links for the last block of pairs, where the light is even enough; the others become pairs of parts."""
        nodes, pairs = self.tree.nodes, self.open[-1]
        S, spread, tilt = np.empty(len(pairs)), np.empty((len(pairs), 2)), np.empty((len(pairs), 2, 3), np.float32)
        link_factors(
            nodes.rings, nodes.counts, nodes.normal, nodes.center, nodes.size, self.tree.child, pairs, S, tilt, spread
        )
        seeing = np.flatnonzero(S > 0.0)
        pairs, S, spread, tilt = pairs[seeing], S[seeing], spread[seeing], tilt[seeing]
        share, asked = self.visibility.asked(nodes.rings, nodes.counts, nodes.normal, pairs)
        uneven = self._unevenness(pairs, S, spread, share, asked) > self.least
        uneven &= self.tree.child[pairs] >= 0
        done = ~uneven.any(axis=1)
        kept = done & (share > 0.0)
        parts = self._parts(pairs[~done], uneven[~done])
        found = pairs[kept].astype(np.int32), (S * share)[kept].astype(np.float32), tilt[kept]
        self.count += len(found[1])
        self.state = [*self.open[:-1], *parts], [*self.state[1], found]

    def _unevenness(self, pairs: Int, S: Float, spread: Float, share: Float, asked: Int) -> Float:
        """By how much the radiosity that a link brings to its ends may be wrong in their parts, (k, 2): because the
        form factor differs between the parts, because some may not be seen, or because the sender is not evenly
        bright."""
        nodes = self.tree.nodes
        bright = np.stack([(nodes.rho[pairs[:, k]] * self.B[pairs[:, 1 - k]]).max(axis=1) for k in (0, 1)], axis=1)
        likely = (share[asked] * FIRST + 0.5) / (FIRST + 1.0)  # 16 rays that agree are no proof
        doubt = np.zeros(len(pairs))
        doubt[asked] = np.sqrt(likely * (1.0 - likely))
        area = nodes.area[pairs]
        sent = VARIES * spread * bright[:, ::-1] * area / area[:, ::-1]
        uneven = np.maximum(np.maximum(spread, (doubt * S)[:, None] / area) * bright, sent)
        uneven[(share == 0.0) & (doubt == 0.0)] = 0.0
        return np.asarray(uneven)

    def _parts(self, pairs: Int, uneven: NDArray[np.bool_]) -> list[Int]:
        """Pairs of the parts of those ends that are uneven, in blocks."""
        four = np.arange(4)
        parts = []
        for k in (0, 1):
            only = uneven[:, k] & ~uneven[:, 1 - k]
            halves = np.empty((int(only.sum()), 4, 2), np.int64)
            halves[:, :, k] = self.tree.child[pairs[only, k], None] + four
            halves[:, :, 1 - k] = pairs[only, 1 - k, None]
            parts.append(halves.reshape(-1, 2))
        both = pairs[uneven.all(axis=1)]
        all_ = np.empty((len(both), 4, 4, 2), np.int64)
        all_[..., 0] = self.tree.child[both[:, 0], None, None] + four[:, None]
        all_[..., 1] = self.tree.child[both[:, 1], None, None] + four
        return _blocks(np.concatenate([*parts, all_.reshape(-1, 2)]))


def _blocks(pairs: Int) -> list[Int]:
    return [pairs[k : k + BLOCK] for k in range(0, len(pairs), BLOCK)]
