"""Textures: pictures whose texels are reflectances.

A polygon is planar, so that its texture coordinates are an affine function of the position: (s, t) = M (x, y, z, 1).
Light is exchanged with the mean reflectance of each patch; the drawn picture has every texel, see view.py.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

Float = NDArray[np.float64]
Int = NDArray[np.int64]
BLACKEST = 1e-3  # of a texel: no paint is blacker, and the irradiance of a patch is its radiosity over rho
FINEST = 32  # samples of a texture along each edge of a patch


@dataclass(frozen=True, eq=False, repr=False)
class Texture:
    """texels: (height, width, 3) reflectances in [0, 1], the first row at t = 1; it repeats in both directions."""

    texels: NDArray[np.float32]

    def __repr__(self) -> str:
        return f"<Texture {self.texels.shape[1]} x {self.texels.shape[0]}>"

    @cached_property
    def peak(self) -> Float:
        """The largest texel of each channel, (3,)."""
        return np.asarray(self.texels.reshape(-1, 3).max(axis=0), np.float64)

    def at(self, st: Float) -> Float:
        """Return the texels at texture coordinates (..., 2): (..., 3)."""
        height, width = self.texels.shape[:2]
        column = np.floor(st[..., 0] * width).astype(np.int64) % width
        row = np.floor((1.0 - st[..., 1]) * height).astype(np.int64) % height
        return np.asarray(self.texels[row, column], np.float64)


def texture_of(pixels: ArrayLike) -> Texture:
    """Return the texture of a picture for screens, (height, width, 3 or 4) uint8: its values follow the sRGB curve."""
    values = np.asarray(pixels)[..., :3].astype(np.float32) / 255.0
    linear = np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)
    return Texture(np.maximum(linear, BLACKEST).astype(np.float32))


def mapping_of(polygon: Float, st: Float) -> Float | None:
    """Return M (2, 4) of a planar polygon (k, 3) whose corners have the texture coordinates st (k, 2).

    None if no M fits all corners: a picture that is bent over more than three corners.
    """
    around = polygon - polygon.mean(axis=0)
    slope = (np.linalg.pinv(around, rcond=1e-6) @ (st - st.mean(axis=0))).T  # least squares, nothing along the normal
    M = np.column_stack([slope, st.mean(axis=0) - slope @ polygon.mean(axis=0)])
    return M if np.abs(mapped(M, polygon) - st).max() <= 1e-4 * max(float(np.ptp(st)), 1.0) else None


def mapped(M: Float, points: Float) -> Float:
    """Return the texture coordinates (..., 2) of points (..., 3)."""
    return np.asarray(points @ np.swapaxes(M[..., :3], -1, -2) + M[..., None, :, 3])


def mean_texels(texture: Texture, corners: Float, M: Float) -> Float:
    """Return the mean texel (n, 3) of patches with corners (n, 4, 3), whose texture coordinates are M (n, 2, 4).

    Each patch is sampled in a grid as fine as the texels, at most FINEST x FINEST, weighted by the area of its cells.
    """
    height, width = texture.texels.shape[:2]
    texels = (np.ptp(mapped(M, corners), axis=1) * (width, height)).max(axis=1)
    fine = 2 ** np.clip(np.ceil(np.log2(np.maximum(texels, 1.0))), 0, np.log2(FINEST)).astype(np.int64)
    result = np.empty((len(corners), 3))
    for many in np.unique(fine).tolist():
        of = np.flatnonzero(fine == many)
        for some in np.array_split(of, max(1, len(of) * many * many // 1_000_000)):
            middle = (np.arange(many) + 0.5) / many
            u, v = (axis.reshape(-1, 1) for axis in np.meshgrid(middle, middle))
            a, b, c, d = (corners[some, None, k] for k in range(4))
            points = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
            cells = np.cross((1 - v) * (b - a) + v * (c - d), (1 - u) * (d - a) + u * (c - b))
            weight = np.linalg.norm(cells, axis=2)[..., None]
            result[some] = (weight * texture.at(mapped(M[some], points))).sum(axis=1) / weight.sum(axis=1)
    return result
