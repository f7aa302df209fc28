"""Textures of materials, made of numbers: reflectances (not screen colours), and they repeat without a seam."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim.radiosity.textures import BLACKEST, Texture

Float = NDArray[np.float64]
SIZE = 512  # texels along an edge


def noise(seed: int, slope: float = 1.5, size: int = SIZE) -> Float:
    """Return a field (size, size) of mean 0 and variance 1 that repeats; its spectrum falls with ``slope``."""
    frequency = np.hypot(*np.meshgrid(np.fft.fftfreq(size, 1.0 / size), np.fft.fftfreq(size, 1.0 / size)))
    frequency[0, 0] = np.inf
    white = np.random.default_rng(seed).normal(size=(size, size))
    field = np.fft.ifft2(np.fft.fft2(white) / frequency**slope).real
    return np.asarray(field / field.std())


def texture(rho: ArrayLike, shade: Float) -> Texture:
    """Return a texture of one paint (3,), or of many (h, w, 3), times a shade (h, w)."""
    return Texture(np.clip(np.asarray(rho) * shade[..., None], BLACKEST, 0.95).astype(np.float32))


def blocks(rows: int, columns: int, joint: float, shift: float = 0.5) -> tuple[Float, Float]:
    """Return a number in [0, 1) for each texel's block, and whether (1, 0) it is block or joint.

    Rows of blocks; each second row is shifted by a part of a block.  joint: part of a block's height.
    """
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE
    row = np.floor(y * rows)
    along = x * columns + shift * (row % 2)
    column = np.floor(along) % columns
    wide = joint * columns / rows
    inside = ((y * rows) % 1.0 > joint) & (along % 1.0 > wide)
    number = np.random.default_rng(4).random((rows, columns))[row.astype(int), column.astype(int)]
    return number, inside.astype(float)


def bricks() -> Texture:
    """Two metres of a red brick wall."""
    number, inside = blocks(24, 8, 0.12)
    shade = (0.75 + 0.5 * number + 0.06 * noise(1, 0.6)) * (1.0 + 0.06 * noise(2, 2.0))
    rho = np.where(inside[..., None] > 0, np.array((0.42, 0.2, 0.13)), (0.5, 0.47, 0.42))
    return texture(rho, np.where(inside > 0, shade, 0.9 + 0.05 * noise(3, 0.5)))


def concrete() -> Texture:
    """Four metres of a floor of four slabs, with stains."""
    number, inside = blocks(2, 2, 0.008, 0.0)
    shade = (0.93 + 0.1 * number) * (1.0 + 0.12 * noise(5, 1.6) + 0.03 * noise(6, 0.3)) * (0.45 + 0.55 * inside)
    return texture((0.42, 0.405, 0.38), shade)


def boards() -> Texture:
    """Two metres of a floor of oak boards."""
    number, inside = blocks(12, 2, 0.03, 0.37)
    grain = np.repeat(noise(7, 1.0)[:, ::8], 8, axis=1)
    warm = np.array((0.47, 0.3, 0.17)) + (number[..., None] - 0.5) * (0.16, 0.11, 0.07)
    return texture(warm, (1.0 + 0.07 * grain) * (0.5 + 0.5 * inside))


def terrazzo() -> Texture:
    """Two metres of a floor of light and dark squares of stone."""
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE
    dark = (np.floor(x * 2) + np.floor(y * 2)) % 2 > 0
    rho = np.where(dark[..., None], (0.36, 0.32, 0.27), np.array((0.56, 0.52, 0.45)))
    joint = np.minimum.reduce([(2 * x) % 1.0, 1.0 - (2 * x) % 1.0, (2 * y) % 1.0, 1.0 - (2 * y) % 1.0]) > 0.006
    vein = 1.0 - 0.22 * np.exp(-((noise(8, 1.8) / 0.08) ** 2))
    return texture(rho, vein * (1.0 + 0.05 * noise(9, 0.9)) * (0.6 + 0.4 * joint))


def sheets() -> Texture:
    """Two metres of corrugated steel, with rust; the corrugation runs up the texture."""
    x = np.mgrid[0:SIZE, 0:SIZE][1] / SIZE
    wave = 0.88 + 0.12 * np.cos(2.0 * np.pi * 10.0 * x)
    rust = np.clip(noise(10, 1.7) - 0.6, 0.0, 1.0)[..., None]
    rho = np.array((0.46, 0.48, 0.5)) * (1.0 - rust) + np.array((0.36, 0.2, 0.12)) * rust
    return texture(rho, wave)
