"""Bidirectional reflectance distribution functions: the lecture's rho(theta_i, phi_i, theta_r, phi_r).

A BRDF says how much of the light from direction L leaves towards V:  I = sum over lights of  f(L, V) I_L (N.L).
Values are in 1/sr; two laws of physics can be checked: reciprocity, f(L, V) = f(V, L), and energy, albedo <= 1.
The lecture's Phong model breaks both; the others keep reciprocity.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim.shading.terms import Float, dot, fresnel_schlick, halfway, power, reflection

PI = float(np.pi)


def frame(N: Float) -> tuple[Float, Float]:
    """Two unit vectors that make a right-handed orthonormal frame with each N (..., 3) (Duff et al. 2017)."""
    x, y, z = np.moveaxis(N, -1, 0)
    sign = np.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    T = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=-1)
    B = np.stack([b, sign + y * y * a, -y], axis=-1)
    return T, B


def around(N: Float, cosine: Float, phi: Float) -> Float:
    """Unit vectors (..., 3) at polar angle arccos(cosine) from N and azimuth phi (radians) about N; both (...)."""
    T, B = frame(N)
    sine = np.sqrt(np.maximum(1.0 - cosine * cosine, 0.0))[..., None]
    return cosine[..., None] * N + sine * (np.cos(phi)[..., None] * T + np.sin(phi)[..., None] * B)


class BRDF(ABC):
    """N, L, V are unit vectors (..., 3): normal, towards the light, towards the eye; u: numbers in [0, 1), (..., 2)."""

    @abstractmethod
    def _value(self, N: Float, L: Float, V: Float) -> Float:
        """f where both N.L and N.V are positive."""

    @abstractmethod
    def sample(self, N: ArrayLike, V: ArrayLike, u: ArrayLike) -> Float:
        """Directions L (..., 3) with the density ``pdf``, which follows the lobe of f; L may lie below the surface."""

    @abstractmethod
    def pdf(self, N: ArrayLike, L: ArrayLike, V: ArrayLike) -> Float:
        """Density of what ``sample`` gives, in 1/sr, (..., 1)."""

    def evaluate(self, N: ArrayLike, L: ArrayLike, V: ArrayLike) -> Float:
        """f in 1/sr, (..., channels); 0 where light or eye is behind the surface."""
        N, L, V = (np.asarray(v, np.float64) for v in (N, L, V))
        seen = (dot(N, L) > 0.0) & (dot(N, V) > 0.0)
        with np.errstate(all="ignore"):
            return np.where(seen, self._value(N, L, V), 0.0)

    def albedo(self, cosine: float = 1.0, resolution: int = 128) -> Float:
        """Share of the light from one direction L that leaves in all directions: the integral of f(L, V) (N.V) over V.

        cosine: N.L in (0, 1].  -> (channels,); more than 1 means that light is made from nothing.  By importance
        sampling at the midpoints of resolution x resolution cells.  Raises ValueError for another cosine.
        """
        if not 0.0 < cosine <= 1.0:
            raise ValueError(f"albedo: cosine must be in (0, 1], not {cosine}")
        middle = (np.arange(resolution) + 0.5) / resolution
        u = np.stack(np.meshgrid(middle, middle), axis=-1).reshape(-1, 2)
        N = np.broadcast_to((0.0, 0.0, 1.0), (len(u), 3))
        L = np.broadcast_to((np.sqrt(1.0 - cosine * cosine), 0.0, cosine), (len(u), 3))
        V = self.sample(N, L, u)
        density = self.pdf(N, V, L)
        weight = np.divide(np.maximum(dot(N, V), 0.0), density, out=np.zeros_like(density), where=density > 0.0)
        return np.asarray((self.evaluate(N, L, V) * weight).mean(axis=0))

    def reciprocity_error(self, pairs: int = 1000, seed: int = 0) -> float:
        """Largest |f(L, V) - f(V, L)| over random directions, relative to the larger of both; 0 if reciprocal."""
        rng = np.random.default_rng(seed)
        N = np.broadcast_to((0.0, 0.0, 1.0), (pairs, 3))
        L, V = (around(N, rng.uniform(0.01, 1.0, pairs), rng.uniform(0.0, 2 * PI, pairs)) for _ in range(2))
        f_LV, f_VL = self.evaluate(N, L, V), self.evaluate(N, V, L)
        largest = np.maximum(np.maximum(f_LV, f_VL), 1e-12)
        return float(np.max(np.abs(f_LV - f_VL) / largest))


def _cosine_power(axis: Float, n: float, u: ArrayLike) -> Float:
    """Directions about ``axis`` with density (n + 1) / (2 pi) cos^n."""
    u = np.asarray(u, np.float64)
    return around(axis, (1.0 - u[..., 0]) ** (1.0 / (n + 1.0)), 2.0 * PI * u[..., 1])


@dataclass(frozen=True)
class Lambertian(BRDF):
    """k_d / pi: the same in all directions.  k_d: reflectance in [0, 1], a number or (3,)."""

    k_d: ArrayLike = 1.0

    def _value(self, N: Float, L: Float, V: Float) -> Float:
        return np.asarray(np.asarray(self.k_d) / PI * np.ones_like(dot(N, L)))

    def sample(self, N: ArrayLike, V: ArrayLike, u: ArrayLike) -> Float:
        return _cosine_power(np.asarray(N, np.float64), 1.0, u)

    def pdf(self, N: ArrayLike, L: ArrayLike, V: ArrayLike) -> Float:
        return np.maximum(dot(N, L), 0.0) / PI


@dataclass(frozen=True)
class NormalizedPhong(BRDF):
    """k_s (n + 2) / (2 pi) (R.V)^n: reciprocal; k_s is its albedo at normal incidence.  (Lafortune & Willems 1994)"""

    k_s: ArrayLike = 1.0
    n: float = 20.0

    def _value(self, N: Float, L: Float, V: Float) -> Float:
        return np.asarray(np.asarray(self.k_s) * (self.n + 2.0) / (2.0 * PI) * power(dot(reflection(N, L), V), self.n))

    def sample(self, N: ArrayLike, V: ArrayLike, u: ArrayLike) -> Float:
        return _cosine_power(reflection(N, V), self.n, u)

    def pdf(self, N: ArrayLike, L: ArrayLike, V: ArrayLike) -> Float:
        return np.asarray((self.n + 1.0) / (2.0 * PI) * power(dot(reflection(N, V), L), self.n))


@dataclass(frozen=True)
class Phong(NormalizedPhong):
    """The lecture's highlight k_s (R.V)^n as a BRDF: it does not fall with N.L, so f = k_s (R.V)^n / (N.L).

    Neither reciprocal nor bound by energy: what the physics-based models mend.  (Phong 1975)
    """

    def _value(self, N: Float, L: Float, V: Float) -> Float:
        return np.asarray(np.asarray(self.k_s) * power(dot(reflection(N, L), V), self.n) / dot(N, L))


@dataclass(frozen=True)
class BlinnPhong(BRDF):
    """k_s c (N.H)^n, reciprocal, with c = (n + 2) (n + 4) / (8 pi (2^(-n/2) + n)): then k_s is the albedo at normal
    incidence.  (Blinn 1977; c: Giesen, Phong and Blinn-Phong normalization factors, 2009)"""

    k_s: ArrayLike = 1.0
    n: float = 20.0

    def _value(self, N: Float, L: Float, V: Float) -> Float:
        n = self.n
        scale = (n + 2.0) * (n + 4.0) / (8.0 * PI * (2.0 ** (-n / 2.0) + n))
        return np.asarray(np.asarray(self.k_s) * scale * power(dot(N, halfway(L, V)), n))

    def sample(self, N: ArrayLike, V: ArrayLike, u: ArrayLike) -> Float:
        return reflection(_cosine_power(np.asarray(N, np.float64), self.n, u), V)

    def pdf(self, N: ArrayLike, L: ArrayLike, V: ArrayLike) -> Float:
        H = halfway(L, V)
        density = (self.n + 1.0) / (2.0 * PI) * power(dot(N, H), self.n)
        return _of_reflected(density, H, V)


@dataclass(frozen=True)
class CookTorrance(BRDF):
    """Microfacets: f = F D G / (4 (N.L) (N.V)), Torrance & Sparrow 1967, Cook & Torrance 1982.

    F_0: Fresnel reflectance at normal incidence in [0, 1], a number or (3,), by Schlick's formula.  m: roughness > 0,
    the root mean square slope in Beckmann's D = exp(-tan^2 / m^2) / (pi m^2 cos^4).
    G = min(1, 2 (N.H) (N.V) / (V.H), 2 (N.H) (N.L) / (V.H)): V-shaped grooves shade and hide each other.
    """

    F_0: ArrayLike = 0.9
    m: float = 0.3

    def __post_init__(self) -> None:
        if not self.m > 0.0:
            raise ValueError(f"CookTorrance: the roughness m must be more than 0, not {self.m}")

    def distribution(self, N_H: ArrayLike) -> Float:
        """Beckmann's D at the cosine N.H: how many facets face H, in 1/sr."""
        squared = np.clip(np.asarray(N_H, np.float64), 1e-9, 1.0) ** 2
        m_2 = self.m * self.m
        return np.asarray(np.exp((squared - 1.0) / (squared * m_2)) / (PI * m_2 * squared * squared))

    def _value(self, N: Float, L: Float, V: Float) -> Float:
        H = halfway(L, V)
        N_L, N_V, N_H, V_H = dot(N, L), dot(N, V), dot(N, H), dot(V, H)
        G = np.minimum(1.0, np.minimum(2.0 * N_H * N_V / V_H, 2.0 * N_H * N_L / V_H))
        return np.asarray(fresnel_schlick(V_H, self.F_0) * self.distribution(N_H) * G / (4.0 * N_L * N_V))

    def sample(self, N: ArrayLike, V: ArrayLike, u: ArrayLike) -> Float:
        u = np.asarray(u, np.float64)
        tan_2 = -self.m * self.m * np.log(1.0 - u[..., 0])
        H = around(np.asarray(N, np.float64), 1.0 / np.sqrt(1.0 + tan_2), 2.0 * PI * u[..., 1])
        return reflection(H, V)

    def pdf(self, N: ArrayLike, L: ArrayLike, V: ArrayLike) -> Float:
        H = halfway(L, V)
        N_H = np.maximum(dot(N, H), 0.0)
        return _of_reflected(self.distribution(N_H) * N_H, H, V)


def _of_reflected(density: NDArray[np.float64], H: Float, V: ArrayLike) -> Float:
    """Density of L from that of H: d omega_L = 4 (V.H) d omega_H."""
    V_H = dot(V, H)
    return np.divide(density, 4.0 * V_H, out=np.zeros_like(density), where=V_H > 0.0)
