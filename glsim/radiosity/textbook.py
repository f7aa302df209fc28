"""Form factors as textbooks begin with them, to see how far they are from the truth: from point to point, from point to
disc, and by Monte Carlo.  (Cohen & Wallace 1993, sections 4.7 and 4.11)"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress
from glsim.radiosity.visibility import Visibility

Float = NDArray[np.float64]


def disc_or_point(patches: Patches, visibility: Visibility, disc: bool, progress: Progress) -> NDArray[np.float32]:
    """S from centre to centre: A_i A_j cos cos / (pi r^2), or with the other patch as a disc of its area,
    A_i A_j cos cos / (pi r^2 + A_j), in the mean of both directions.  One ray decides what is seen."""
    n = len(patches)
    S = np.zeros((n, n), np.float32)
    area = patches.area
    for i in range(n):
        way = patches.center[i + 1 :] - patches.center[i]
        squared = np.einsum("jk,jk->j", way, way)
        kernel = np.maximum(way @ patches.normal[i], 0.0)
        kernel = kernel * np.maximum(-np.einsum("jk,jk->j", way, patches.normal[i + 1 :]), 0.0)
        there = np.flatnonzero(kernel > 0.0)
        if disc:
            below = np.pi * squared[there, None] + np.stack(
                [area[i + 1 :][there], np.full(len(there), area[i])], axis=1
            )
            share = (1.0 / below).mean(axis=1) / squared[there]
        else:
            share = 1.0 / (np.pi * squared[there] ** 2)
        seen = visibility.between(np.broadcast_to(patches.center[i], (len(there), 3)), patches.center[i + 1 + there])
        values = area[i] * area[i + 1 :][there] * kernel[there] * share * seen
        S[i, i + 1 + there] = S[i + 1 + there, i] = values
        progress("form factors", i + 1, n)
    return S


def monte_carlo(
    patches: Patches, visibility: Visibility, samples: int, seed: int, progress: Progress
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """S as the mean of A_i A_j cos cos V / (pi r^2) over random points of both patches, and its standard errors."""
    n = len(patches)
    rng = np.random.default_rng(seed)
    S, error = np.zeros((n, n), np.float32), np.zeros((n, n), np.float32)
    for i in range(n):
        count = n - i - 1
        if not count:
            break
        p = _points(patches, np.full(count * samples, i), rng)
        others = np.repeat(np.arange(i + 1, n), samples)
        way = _points(patches, others, rng) - p
        squared = np.einsum("jk,jk->j", way, way)
        kernel = np.maximum(way @ patches.normal[i], 0.0) * np.maximum(
            -np.einsum("jk,jk->j", way, patches.normal[others]), 0.0
        )
        seen = np.flatnonzero(kernel > 0.0)
        values = np.zeros(count * samples)
        free = visibility.between(p[seen], p[seen] + way[seen])
        values[seen] = kernel[seen] / (np.pi * squared[seen] ** 2) * free
        values = values.reshape(count, samples) * (patches.area[i] * patches.area[i + 1 :])[:, None]
        S[i, i + 1 :] = S[i + 1 :, i] = values.mean(axis=1)
        error[i, i + 1 :] = error[i + 1 :, i] = values.std(axis=1, ddof=1) / np.sqrt(samples)
        progress("form factors", i + 1, n)
    return S, error


def _points(patches: Patches, which: NDArray[np.int64], rng: np.random.Generator) -> Float:
    """A random point of each patch, uniform over its area."""
    rings = patches.rings[which]
    one = np.linalg.norm(np.cross(rings[:, 1] - rings[:, 0], rings[:, 2] - rings[:, 0]), axis=1)
    two = np.linalg.norm(np.cross(rings[:, 2] - rings[:, 0], rings[:, 3] - rings[:, 0]), axis=1)
    first = rng.random(len(which)) * (one + two) < one
    u, v = rng.random((2, len(which), 1))
    fold = u + v > 1.0
    u, v = np.where(fold, 1.0 - u, u), np.where(fold, 1.0 - v, v)
    b = np.where(first[:, None], rings[:, 1], rings[:, 2])
    c = np.where(first[:, None], rings[:, 2], rings[:, 3])
    return np.asarray(rings[:, 0] + u * (b - rings[:, 0]) + v * (c - rings[:, 0]))
