"""How much two pictures differ: the numbers that snapshot tests decide by and comparisons report.

Pictures are arrays (height, width, channels) uint8 of one shape; values and differences are in steps of 1/255.
"""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[np.uint8]

LUMINANCE = np.array([0.2126, 0.7152, 0.0722])  # of linear Rec. 709 primaries, ITU-R BT.709
VISIBLE = 2  # 1/255: the largest difference that another renderer's rounding makes


def difference(a: Pixels, b: Pixels) -> NDArray[np.int16]:
    """b - a, with sign: (height, width, channels) int16 in -255..255.  Raises ValueError if the shapes differ."""
    if a.shape != b.shape:
        sizes = " and ".join(f"{p.shape[1]} x {p.shape[0]} with {p.shape[2]} channels" for p in (a, b))
        raise ValueError(f"pictures of one size are needed to compare them, not {sizes}")
    return b.astype(np.int16) - a.astype(np.int16)


def amplified(d: NDArray[np.int16], factor: int) -> Pixels:
    """A difference d, |d| times ``factor``, at most 255, as a picture of the same shape."""
    return np.asarray(np.minimum(np.abs(d.astype(np.int32)) * factor, 255), np.uint8)


def metrics(a: Pixels, b: Pixels) -> dict[str, float]:
    """The differences of two pictures as numbers.

    max, mean, rmse: of |b - a| over all pixels and channels, in 1/255.
    different: the share of pixels that differ in any channel, in [0, 1].
    ssim: structural similarity, 1 for equal pictures (see ``ssim``).
    flip: the mean of FLIP (Andersson et al. 2020), 0 for equal pictures, if the package flip-evaluator is installed.
    """
    d = np.abs(difference(a, b))
    values = {
        "max": float(d.max(initial=0)),
        "mean": float(d.mean()) if d.size else 0.0,
        "rmse": float(np.sqrt(np.mean(np.square(d, dtype=np.float64)))) if d.size else 0.0,
        "different": float(d.any(axis=2).mean()) if d.size else 0.0,
        "ssim": ssim(a, b),
    }
    if find_spec("flip_evaluator"):
        values["flip"] = flip(a, b)
    return values


def ssim(a: Pixels, b: Pixels) -> float:
    """The mean structural similarity of the luminance of two pictures, in [-1, 1].

    Wang, Bovik, Sheikh, Simoncelli: Image quality assessment, 2004: Gaussian windows with a standard deviation of 1.5
    pixels, cut at 11 x 11, K_1 = 0.01, K_2 = 0.03."""
    difference(a, b)
    if np.array_equal(a, b):
        return 1.0
    x, y = (_luminance(picture) for picture in (a, b))
    mean_x, mean_y = windowed(x), windowed(y)
    variance_x, variance_y = windowed(x * x) - mean_x**2, windowed(y * y) - mean_y**2
    covariance = windowed(x * y) - mean_x * mean_y
    c_1, c_2 = (0.01 * 255.0) ** 2, (0.03 * 255.0) ** 2
    likeness = (2 * mean_x * mean_y + c_1) * (2 * covariance + c_2)
    return float(np.mean(likeness / ((mean_x**2 + mean_y**2 + c_1) * (variance_x + variance_y + c_2))))


def windowed(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Each value (height, width) as the mean of its neighbours under ssim's window; the edges are mirrored.

    It is scipy.ndimage.gaussian_filter, whose import takes longer than all of ``glsim compare``'s drawing."""
    weights = np.exp(-np.square(np.arange(6) / 1.5) / 2)
    weights /= weights[0] + 2 * weights[1:].sum()
    for _ in range(2):  # along the columns, then, transposed, along the rows
        padded, count = np.pad(values, ((5, 5), (0, 0)), "symmetric"), len(values)
        means = weights[0] * padded[5 : 5 + count]
        for k in range(1, 6):
            means += weights[k] * (padded[5 - k : 5 - k + count] + padded[5 + k : 5 + k + count])
        values = means.T
    return values


def flip(a: Pixels, b: Pixels) -> float:
    """The mean FLIP difference, in [0, 1], at the 67 pixels a degree of a monitor seen from 0.7 m.

    Andersson et al.: FLIP, A difference evaluator for alternating images, 2020.  Needs the package flip-evaluator."""
    flip_evaluator: Any = __import__("flip_evaluator")
    pictures = [np.ascontiguousarray(_rgb(picture), np.float32) / np.float32(255.0) for picture in (a, b)]
    return float(flip_evaluator.evaluate(*pictures, "LDR")[1])


def same_sign_blocks(a: Pixels, b: Pixels, least: int = VISIBLE) -> int:
    """The number of 3 x 3 blocks of pixels in which a channel of b is at all nine pixels brighter than in a, or at all
    nine darker, by at least ``least``/255.

    Rounding scatters differences of either sign; a wrong light, normal or vertex moves whole regions one way."""
    d = difference(a, b)
    if min(d.shape[:2]) < 3:
        return 0
    found = np.zeros((d.shape[0] - 2, d.shape[1] - 2), bool)
    for moved in (d >= least, d <= -least):
        runs = moved[:, :-2] & moved[:, 1:-1] & moved[:, 2:]
        found |= (runs[:-2] & runs[1:-1] & runs[2:]).any(axis=2)
    return int(found.sum())


def _rgb(picture: Pixels) -> Pixels:
    return np.repeat(picture[..., :1], 3, axis=2) if picture.shape[2] < 3 else picture[..., :3]


def _luminance(picture: Pixels) -> NDArray[np.float64]:
    return np.asarray(_rgb(picture) @ LUMINANCE)
