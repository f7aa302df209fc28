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


def halfway(L: ArrayLike, V: ArrayLike) -> Float:
    """The unit vector halfway between L and V: H = (L + V) / |L + V|.  Unit vectors (..., 3); 0 where V = -L."""
    return normalize(np.asarray(L, np.float64) + np.asarray(V, np.float64))


def phong_specular(N: ArrayLike, L: ArrayLike, V: ArrayLike, n: ArrayLike) -> Float:
    """Phong's highlight (R.V)^n.  V: unit vector to the eye, n: shininess.  -> (..., 1) in [0, 1]"""
    return power(dot(reflection(N, L), V), n)


def blinn_torrance_specular(N: ArrayLike, L: ArrayLike, V: ArrayLike, n: ArrayLike) -> Float:
    """Blinn's highlight (N.H)^n with H halfway between L and V: OpenGL's.  -> (..., 1) in [0, 1]"""
    return power(dot(N, halfway(L, V)), n)


def ambient(k_a: ArrayLike, I_a: ArrayLike) -> Float:
    """The ambient glow k_a I_a, for each channel.  Reflectance in [0, 1], intensity >= 0; (..., 3) -> (..., 3)"""
    return np.asarray(np.asarray(k_a, np.float64) * np.asarray(I_a, np.float64))


def diffuse(k_d: ArrayLike, I_d: ArrayLike, N: ArrayLike, L: ArrayLike) -> Float:
    """Diffuse reflection k_d I_d (N.L), for each channel; 0 where the light is behind.  -> (..., 3)"""
    return np.asarray(np.asarray(k_d, np.float64) * np.asarray(I_d, np.float64) * lambert(N, L))


def clamp(intensity: ArrayLike) -> Float:
    """What a screen can show of I: I > 1 becomes 1, I < 0 becomes 0 (the lecture's special cases)."""
    return np.clip(np.asarray(intensity, np.float64), 0.0, 1.0)


def towards_light(N: ArrayLike, L: ArrayLike, flip: bool = False) -> Float:
    """The normal that the equation uses where N.L < 0: N itself (N.L is then clamped to 0), or with ``flip`` -N."""
    N = np.asarray(N, np.float64)
    return np.where(dot(N, L) < 0.0, -N, N) if flip else N


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


def refraction(N: ArrayLike, L: ArrayLike, n_1: float, n_2: float) -> Float:
    """The direction into the second medium by Snell's law, n_1 sin(theta_1) = n_2 sin(theta_2).

    N: unit normal on L's side; L: unit vector back along the incoming ray; n_1, n_2: refractive indices (> 0) on
    L's side and beyond.  -> unit vectors (..., 3); NaN where the light is totally reflected.
    """
    N, L = np.asarray(N, np.float64), np.asarray(L, np.float64)
    cos_1 = dot(N, L)
    ratio = n_1 / n_2
    squared = 1.0 - ratio * ratio * (1.0 - cos_1 * cos_1)
    cos_2 = np.sqrt(np.where(squared >= 0.0, squared, np.nan))
    return np.asarray((ratio * cos_1 - cos_2) * N - ratio * L)


def fresnel(cosine: ArrayLike, n_1: float, n_2: float) -> Float:
    """Share of unpolarised light that a boundary of two dielectrics reflects: Fresnel's equations.

    cosine: of the angle of incidence, in [0, 1]; n_1, n_2: refractive indices (> 0) before and behind the boundary.
    -> in [0, 1]; 1 where the light is totally reflected.  Source: Hecht, Optics, section 4.6.
    """
    cos_1 = np.clip(np.asarray(cosine, np.float64), 0.0, 1.0)
    squared = 1.0 - (n_1 / n_2) ** 2 * (1.0 - cos_1 * cos_1)
    cos_2 = np.sqrt(np.maximum(squared, 0.0))
    with np.errstate(invalid="ignore"):  # 0 / 0 at grazing incidence between equal media
        across = (n_1 * cos_1 - n_2 * cos_2) / (n_1 * cos_1 + n_2 * cos_2)
        along = (n_1 * cos_2 - n_2 * cos_1) / (n_1 * cos_2 + n_2 * cos_1)
    reflected = np.nan_to_num((across * across + along * along) / 2.0)
    return np.asarray(np.where(squared < 0.0, 1.0, reflected))


def fresnel_schlick(cosine: ArrayLike, F_0: ArrayLike) -> Float:
    """Schlick's approximation (1994), F_0 + (1 - F_0) (1 - cosine)^5.  F_0: reflectance at cosine 1, in [0, 1]."""
    F_0 = np.asarray(F_0, np.float64)
    return np.asarray(F_0 + (1.0 - F_0) * (1.0 - np.clip(np.asarray(cosine, np.float64), 0.0, 1.0)) ** 5)
