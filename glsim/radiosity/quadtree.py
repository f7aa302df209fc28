"""Patches divided into four, and again: where the light changes fast, and as levels of detail for links."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.mesh import outline
from glsim.radiosity.patches import Patches, patches_from

Float = NDArray[np.float64]
Int = NDArray[np.int64]


def quarters(corners: Float, counts: Int) -> Float:
    """Cut each patch (n, 4, 3) at the middles of its edges into four: (n, 4, 4, 3).

    A quad becomes quads, a triangle triangles of its shape.
    """
    a, b, c, d = (corners[:, k] for k in range(4))
    ab, bc, cd, da, m = (a + b) / 2, (b + c) / 2, (c + d) / 2, (d + a) / 2, (a + b + c + d) / 4
    quads = np.stack([_stack(a, ab, m, da), _stack(ab, b, bc, m), _stack(m, bc, c, cd), _stack(da, m, cd, d)], axis=1)
    ca = (c + a) / 2
    three = _stack(a, ab, ca, ca), _stack(ab, b, bc, bc), _stack(ca, bc, c, c), _stack(ab, bc, ca, ca)
    return np.where((counts == 4)[:, None, None, None], quads, np.stack(three, axis=1))


def _stack(*corners: Float) -> Float:
    """Return patches (n, 4, 3) from four arrays of corners (n, 3)."""
    return np.stack(corners, axis=1)


def divided(patches: Patches, chosen: NDArray[np.bool_]) -> Patches:
    """Return the patches with the chosen ones (a mask (n,)) in four parts each; clusters are never divided.

    More are divided until neighbours are at most one level apart: a balanced quadtree.
    """
    now = _divide(patches, chosen & ~patches.is_cluster)
    while (coarse := _unbalanced(now)).any():
        now = _divide(now, coarse)
    return now


def _divide(patches: Patches, chosen: NDArray[np.bool_]) -> Patches:
    """Return the patches that are not chosen, and after them the quarters of those that are."""

    def joined(values: Int, more: int = 0) -> Int:
        return np.concatenate([values[~chosen], np.repeat(values[chosen] + more, 4)])

    parts = quarters(patches.corners[chosen], patches.counts[chosen]).reshape(-1, 4, 3)
    corners = np.concatenate([patches.corners[~chosen], parts])
    result = patches_from(
        patches.scene, corners, joined(patches.counts), joined(patches.polygon), joined(patches.level, 1)
    )
    if patches.clusters is None:
        return result
    of = np.concatenate([patches.clusters.of[~chosen], np.full(4 * int(chosen.sum()), -1)])
    return patches.with_clusters(result, of)


def _unbalanced(patches: Patches) -> NDArray[np.bool_]:
    """Return a mask (n,) of the patches with an edge on which lies a vertex of patches more than one level finer."""
    lines = outline(patches)
    finest = np.zeros(len(lines.positions), np.int64)
    np.maximum.at(finest, lines.corners.ravel(), np.repeat(patches.level, 4))
    result = np.zeros(len(patches), bool)
    for (patch, _), vertices in lines.between.items():
        result[patch] |= finest[vertices].max() > patches.level[patch] + 1
    return result & ~patches.is_cluster
