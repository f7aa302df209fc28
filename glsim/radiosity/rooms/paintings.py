"""Paintings, made of numbers: textures of reflectances, square, the first row on top."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.rooms.surfaces import noise, texture
from glsim.radiosity.textures import Texture

Float = NDArray[np.float64]
SIZE = 256  # texels along an edge
Y, X = (np.mgrid[0:SIZE, 0:SIZE] + 0.5) / SIZE  # from above, from the left


def _soft(low: float, high: float, at: Float, blur: float) -> Float:
    """Return a field that is 1 between two values and falls to 0 within ``blur``."""
    return np.asarray(np.clip((at - low) / blur, 0, 1) * np.clip((high - at) / blur, 0, 1))


def fields() -> Texture:
    """Two soft fields of red and orange on a dark red ground."""
    brush = noise(21, 1.1, SIZE)
    image = np.broadcast_to((0.3, 0.03, 0.03), (SIZE, SIZE, 3)).copy()
    for low, high, paint in ((0.08, 0.52, (0.75, 0.16, 0.02)), (0.58, 0.92, (0.62, 0.04, 0.05))):
        shape = _soft(0.08, 0.92, X + 0.006 * brush, 0.05) * _soft(low, high, Y + 0.008 * noise(22, 1.2, SIZE), 0.06)
        image += shape[..., None] * (np.array(paint) - image)
    return texture(image, 1.0 + 0.08 * brush)


def grid() -> Texture:
    """Black lines on white, and a few of their rectangles red, blue and yellow."""
    image = np.broadcast_to((0.78, 0.77, 0.72), (SIZE, SIZE, 3)).copy()
    for left, right, top, bottom, paint in (
        (0.3, 1.0, 0.0, 0.66, (0.6, 0.03, 0.02)), (0.0, 0.3, 0.66, 1.0, (0.03, 0.07, 0.4)),
        (0.86, 1.0, 0.84, 1.0, (0.8, 0.55, 0.03)),
    ):  # fmt: skip
        image[(left < X) & (right > X) & (top < Y) & (bottom > Y)] = paint
    lines = (np.abs(X - 0.3) < 0.014) | (np.abs(Y - 0.66) < 0.014) | ((np.abs(Y - 0.3) < 0.02) & (X < 0.3))
    lines |= ((np.abs(X - 0.86) < 0.014) & (Y > 0.66)) | ((np.abs(Y - 0.84) < 0.02) & (X > 0.86))
    image[lines] = 0.02
    return texture(image, np.ones((SIZE, SIZE)))


def squares() -> Texture:
    """Four squares in each other, from lemon to ochre."""
    image = np.broadcast_to((0.45, 0.21, 0.02), (SIZE, SIZE, 3)).copy()
    for half, paint in ((0.4, (0.6, 0.33, 0.02)), (0.29, (0.75, 0.5, 0.03)), (0.18, (0.8, 0.68, 0.1))):
        image[(np.abs(X - 0.5) < half) & (np.abs(Y - 0.5 - (0.5 - half) / 2) < half)] = paint
    return texture(image, 1.0 + 0.03 * noise(23, 0.4, SIZE))


def circles() -> Texture:
    """Rings in sixteen squares, each in four colours."""
    random = np.random.default_rng(5)
    paints = np.array([(0.65, 0.06, 0.04), (0.04, 0.13, 0.45), (0.8, 0.5, 0.03), (0.05, 0.3, 0.18), (0.75, 0.7, 0.6),
                       (0.3, 0.07, 0.3), (0.1, 0.4, 0.5), (0.75, 0.27, 0.03)])  # fmt: skip
    chosen = np.array([[random.permutation(8)[:4] for _ in range(4)] for _ in range(4)])
    row, column = (4 * Y).astype(int), (4 * X).astype(int)
    wave = 0.03 * noise(24, 1.4, SIZE)
    r = np.hypot(4 * X % 1.0 - 0.5, 4 * Y % 1.0 - 0.5) + wave
    number = np.digitize(r, (0.14, 0.28, 0.42))
    return texture(paints[chosen[row, column, number]], 1.0 + 0.06 * noise(25, 0.8, SIZE))


def bulge() -> Texture:
    """A chequerboard of black and white that swells to a sphere."""
    x, y = 2.0 * X - 1.0, 2.0 * Y - 1.0
    r = np.hypot(x, y)
    swell = np.where(r < 0.8, np.arcsin(np.minimum(r / 0.8, 1.0)) / (np.pi / 2) * 0.8 / np.maximum(r, 1e-9), 1.0)
    black = (np.floor(6 * swell * x) + np.floor(6 * swell * y)) % 2 > 0
    light = np.where(r < 0.8, np.sqrt(np.maximum(1.0 - (r / 0.8) ** 2, 0.0)) * 0.4 + 0.6, 1.0)
    return texture(np.where(black[..., None], (0.03, 0.04, 0.12), np.array((0.78, 0.76, 0.7))), light)


def mountains() -> Texture:
    """Ridges behind ridges in the haze of an evening."""
    image = np.array((0.75, 0.42, 0.2)) + Y[..., None] * np.array((0.05, 0.2, 0.3))
    image[np.hypot(X - 0.68, 1.1 * (Y - 0.3)) < 0.07] = (0.85, 0.72, 0.4)
    for k in range(6):
        line = 0.42 + 0.1 * k - (0.09 - 0.008 * k) * noise(30 + k, 1.6, SIZE)[0]
        near = (k + 1.0) / 6.0
        paint = (1.0 - near) * np.array((0.6, 0.42, 0.4)) + near * np.array((0.03, 0.07, 0.1))
        image[line < Y] = paint
    return texture(image, 1.0 + 0.04 * noise(26, 0.6, SIZE))
