"""The simplest form factors of textbooks, to compare with the accurate ones: from point to point, from point to disc,
and by Monte Carlo.  (Cohen & Wallace 1993, sections 4.7 and 4.11)"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress
from glsim.radiosity.rays import Rays

Float = NDArray[np.float64]


def disc_or_point(patches: Patches, rays: Rays, disc: bool, progress: Progress) -> NDArray[np.float32]:
    """Return S (n, n) from the centres of the patches; one ray for each pair decides whether it is seen.

    S_ij = A_i A_j cos cos / (pi r^2).  With ``disc`` the other patch is a disc of its area,
    A_i A_j cos cos / (pi r^2 + A_j), and the mean of both directions is taken.
    """
    n = len(patches)
    S = np.zeros((n, n), np.float32)
    area = patches.area
    for i in range(n):
        direction = patches.center[i + 1 :] - patches.center[i]
        squared = np.einsum("jk,jk->j", direction, direction)
        kernel = np.maximum(direction @ patches.normal[i], 0.0)
        kernel = kernel * np.maximum(-np.einsum("jk,jk->j", direction, patches.normal[i + 1 :]), 0.0)
        facing = np.flatnonzero(kernel > 0.0)
        if disc:
            below = np.pi * squared[facing, None] + np.stack(
                [area[i + 1 :][facing], np.full(len(facing), area[i])], axis=1
            )
            share = (1.0 / below).mean(axis=1) / squared[facing]
        else:
            share = 1.0 / (np.pi * squared[facing] ** 2)
        seen = rays.between(np.broadcast_to(patches.center[i], (len(facing), 3)), patches.center[i + 1 + facing])
        values = area[i] * area[i + 1 :][facing] * kernel[facing] * share * seen
        S[i, i + 1 + facing] = S[i + 1 + facing, i] = values
        progress("form factors", i + 1, n)
    return S


def monte_carlo(
    patches: Patches, rays: Rays, samples: int, seed: int, progress: Progress
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return S (n, n) and its standard errors (n, n).

    S_ij is the mean of A_i A_j cos cos V / (pi r^2) over ``samples`` random points of both patches, with V = 1 where
    they see each other, else 0.
    """
    n = len(patches)
    rng = np.random.default_rng(seed)
    S, error = np.zeros((n, n), np.float32), np.zeros((n, n), np.float32)
    for i in range(n):
        count = n - i - 1
        if not count:
            break
        p = _points(patches, np.full(count * samples, i), rng)
        others = np.repeat(np.arange(i + 1, n), samples)
        direction = _points(patches, others, rng) - p
        squared = np.einsum("jk,jk->j", direction, direction)
        kernel = np.maximum(direction @ patches.normal[i], 0.0) * np.maximum(
            -np.einsum("jk,jk->j", direction, patches.normal[others]), 0.0
        )
        seen = np.flatnonzero(kernel > 0.0)
        values = np.zeros(count * samples)
        free = rays.between(p[seen], p[seen] + direction[seen])
        values[seen] = kernel[seen] / (np.pi * squared[seen] ** 2) * free
        values = values.reshape(count, samples) * (patches.area[i] * patches.area[i + 1 :])[:, None]
        S[i, i + 1 :] = S[i + 1 :, i] = values.mean(axis=1)
        error[i, i + 1 :] = error[i + 1 :, i] = values.std(axis=1, ddof=1) / np.sqrt(samples)
        progress("form factors", i + 1, n)
    return S, error


def _points(patches: Patches, which: NDArray[np.int64], rng: np.random.Generator) -> Float:
    """Return a random point of each patch ``which`` (k,), uniform over its area: (k, 3)."""
    corners = patches.corners[which]
    one = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    two = np.linalg.norm(np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 0]), axis=1)
    first = rng.random(len(which)) * (one + two) < one
    u, v = rng.random((2, len(which), 1))
    fold = u + v > 1.0
    u, v = np.where(fold, 1.0 - u, u), np.where(fold, 1.0 - v, v)
    b = np.where(first[:, None], corners[:, 1], corners[:, 2])
    c = np.where(first[:, None], corners[:, 2], corners[:, 3])
    return np.asarray(corners[:, 0] + u * (b - corners[:, 0]) + v * (c - corners[:, 0]))
