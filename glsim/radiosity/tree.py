"""Quadtrees over patches: levels of detail between which light is exchanged, see hierarchy.py."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.patches import Patches, patches_from
from glsim.radiosity.quadtree import quarters
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Scene
from glsim.radiosity.subdivide import length_for, number_of_cells, subdivide

Float = NDArray[np.float64]
Int = NDArray[np.int64]
ROOTS = 1600  # about the largest number of roots of a tree, unless the scene's polygons need more
DEEPEST = 6  # levels below a root


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
        """Return the radiosity of all nodes from that of the elements, B (n, 3).

        Two arrays: the mean over each node's area, (N, 3), and the mean of B (x - center), (N, 3, 3) by channel and
        direction.
        """
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
        """Return the irradiance of the elements (n, 3) from that of all nodes.

        What arrives at a node, H (N, 3) + slopes (N, 3, 3) . (x - center), arrives at all its parts.
        """
        H, slopes, center = H.copy(), slopes.copy(), self.nodes.center
        for low, high in zip(self.levels[1:-1], self.levels[2:], strict=True):
            above = self.parent[low:high]
            apart = center[low:high] - center[above]
            H[low:high] += H[above] + np.einsum("ncd,nd->nc", slopes[above], apart)
            slopes[low:high] += slopes[above]
        return np.asarray(H[self.leaves])


def tree_over(roots: Patches, length: float) -> Tree:
    """Divide patches into four, and again, until their edges are about ``length`` (the scene's unit)."""
    edges = np.sqrt(roots.area * np.where(roots.counts == 4, 1.0, 2.0))
    depth = np.clip(np.round(np.log2(np.maximum(edges / length, 1e-9))), 0, DEEPEST).astype(np.int64)
    depth[roots.is_cluster] = 0
    corners, counts, polygon = [roots.corners], [roots.counts], [roots.polygon]
    parent, child, levels = [np.full(len(roots), -1)], [np.full(len(roots), -1)], [0, len(roots)]
    while (inner := np.flatnonzero(depth > 0)).size:
        child[-1][inner] = levels[-1] + 4 * np.arange(len(inner))
        parent.append(np.repeat(levels[-2] + inner, 4))
        depth = np.repeat(depth[inner] - 1, 4)
        child.append(np.full(len(depth), -1))
        corners.append(quarters(corners[-1][inner], counts[-1][inner]).reshape(-1, 4, 3))
        counts.append(np.repeat(counts[-1][inner], 4))
        polygon.append(np.repeat(polygon[-1][inner], 4))
        levels.append(levels[-1] + len(depth))
    level = np.repeat(np.arange(len(corners)), [len(part) for part in corners])
    whole = np.concatenate(corners), np.concatenate(counts), np.concatenate(polygon)
    nodes = patches_from(roots.scene, *whole, level)
    if roots.clusters is not None:
        of = np.concatenate([roots.clusters.of, np.full(len(nodes) - len(roots), -1)])
        nodes = roots.with_clusters(nodes, of)
    return Tree(nodes, np.concatenate(parent), np.concatenate(child), tuple(levels))


def tree_of(scene: Scene, count: int, rays: Rays | None = None) -> Tree:
    """Return a tree of about ``count`` elements, over as few roots as the scene's polygons need, or about ROOTS."""
    length, gather = length_for(scene, count)
    fewest = max(ROOTS, 0 if gather else 2 * number_of_cells(scene, scene.size))
    depth = 0
    while depth < DEEPEST and number_of_cells(scene, length * 2.0**depth) > fewest:
        depth += 1
    small = length if gather else None
    return tree_over(subdivide(scene, length=length * 2.0**depth, rays=rays, small=small), length)
