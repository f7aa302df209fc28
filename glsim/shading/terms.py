"""The factors of the illumination equation, one function each."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Float = NDArray[np.float64]


def dot(a: ArrayLike, b: ArrayLike) -> Float:
    """a.b along the last axis: (..., 3), (..., 3) -> (..., 1), so that it multiplies colours."""
    return np.asarray(np.sum(np.asarray(a, np.float64) * np.asarray(b, np.float64), axis=-1, keepdims=True))


def normalize(v: ArrayLike) -> Float:
    """v / |v|; the zero vector stays zero.  (..., 3) -> (..., 3)"""
    v = np.asarray(v, np.float64)
    length = np.sqrt(dot(v, v))
    return np.asarray(np.divide(v, length, out=np.zeros_like(v), where=length > 0.0))


def power(cosine: ArrayLike, n: ArrayLike) -> Float:
    """max(cosine, 0)^n, and 1 where n is 0 (OpenGL 1.5, section 2.14.1)."""
    cosine, n = np.asarray(cosine, np.float64), np.asarray(n, np.float64)
    return np.asarray(np.where(n == 0.0, 1.0, np.maximum(cosine, 0.0) ** np.where(n == 0.0, 1.0, n)))


def lambert(N: ArrayLike, L: ArrayLike) -> Float:
    """Lambert's cosine law: max(N.L, 0).  N: unit normal, L: unit vector to the light.  -> (..., 1) in [0, 1]"""
    return np.maximum(dot(N, L), 0.0)


def reflection(N: ArrayLike, L: ArrayLike) -> Float:
    """L mirrored at N: R = (N.L) N + S with S = (N.L) N - L.  Unit vectors (..., 3)."""
    projected = dot(N, L) * np.asarray(N, np.float64)
    S = projected - np.asarray(L, np.float64)
    return projected + S


def phong_specular(N: ArrayLike, L: ArrayLike, V: ArrayLike, n: ArrayLike) -> Float:
    """Phong's highlight (R.V)^n.  V: unit vector to the eye, n: shininess.  -> (..., 1) in [0, 1]"""
    return power(dot(reflection(N, L), V), n)


def blinn_torrance_specular(N: ArrayLike, L: ArrayLike, V: ArrayLike, n: ArrayLike) -> Float:
    """Blinn's highlight (N.H)^n with H halfway between L and V: OpenGL's.  -> (..., 1) in [0, 1]"""
    H = normalize(np.asarray(L, np.float64) + np.asarray(V, np.float64))
    return power(dot(N, H), n)


def attenuation(d: ArrayLike, k_0: float = 1.0, k_1: float = 0.0, k_2: float = 0.0) -> Float:
    """1 / (k_0 + k_1 d + k_2 d^2) at distance d from the light (OpenGL 1.5, equation 2.4)."""
    d = np.asarray(d, np.float64)
    return np.asarray(1.0 / (k_0 + k_1 * d + k_2 * d * d))


def spotlight(L: ArrayLike, direction: ArrayLike, cutoff: float, exponent: float) -> Float:
    """(-L.direction)^exponent inside the cone of ``cutoff`` degrees, else 0; 1 everywhere for cutoff 180.

    L: unit vectors (..., 3) to the light; direction: unit vector in which it shines.  -> (..., 1) in [0, 1]
    """
    cosine = -dot(L, direction)
    if cutoff == 180.0:
        return np.ones_like(cosine)
    return np.where(cosine < np.cos(np.radians(cutoff)), 0.0, power(cosine, exponent))
