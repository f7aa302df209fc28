"""From OpenGL's materials and lights to metallic-roughness materials and radiant lights: the formulas.

OpenGL's equation shows I_d k_d (N.L) + I_s k_s (N.H)^n.  glTF's metallic-roughness model, as pyrender computes it:

    I (N.L) [ (1 - F) c_diff / pi  +  F G D / (4 (N.L) (N.V)) ]     c_diff = 0.96 (1 - metallic) base
                                                                     F_0 = 0.04 (1 - metallic) + metallic base

with Schlick's F, Smith's G with k = (roughness + 1)^2 / 8 (Karis: Real Shading in Unreal Engine 4, 2013), and the GGX
distribution D with alpha = roughness^2 (Walter et al.: Microfacet Models for Refraction, 2007).  The conversion makes
both equations agree where N = L = V = H:

    I = pi I_d            because a Lambert surface reflects c / pi of the irradiance
    alpha^2 = 2 / (n + 2)           Walter et al., section 5.2; roughness = sqrt(alpha)
    F_0 = 4 alpha^2 k_s             so that pi F_0 D / 4 is k_s; D is 1 / (pi alpha^2) at N = H
    c_diff = k_d / (1 - F_0)

With this alpha the core of GGX's highlight is narrower than that of (N.H)^n, with half of the height at 0.77 of the
angle, and its tails are longer: no alpha makes the two curves equal.

A dielectric has F_0 >= 0.04.  Where k_s asks for less, the highlight keeps its height and becomes wider.  metallic and
base then follow from F_0 and c_diff as in Khronos's conversion of specular-glossiness materials
(KHR_materials_pbrSpecularGlossiness, "convert between workflows").  A base colour above 1 would reflect more light than
arrives; it is scaled down to 1, and a note says so.

    E + k_a (ambient of the scene and of the lights)       the emissive colour: neither depends on N, L or V
    falloff 1 / (k_c + k_l d + k_q d^2)                     1 / d^2, with the intensity whose logarithm is right on
                                                            average over the lit surface; exact if k_c = k_l = 0
    spot (cos)^e inside a cutoff                            KHR_lights_punctual's cone: the cutoff is its outer angle,
                                                            the angle of half the intensity is the same
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine.state import Face, Light

Float = NDArray[np.float64]
RGB = tuple[float, float, float]

DIELECTRIC = 0.04  # F_0 of what is no metal: glTF 2.0, appendix B
MAX_N = 128.0  # GL_SHININESS


class Metal(NamedTuple):
    """A metallic-roughness material.  base: RGBA; glow: the light that it sends out whatever shines on it."""

    base: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    metallic: float = 0.0
    roughness: float = 1.0
    glow: RGB = (0.0, 0.0, 0.0)


class Source(NamedTuple):
    """A light in eye space.  kind: "directional", "point" or "spot".  color: radiance, or intensity over d^2, with pi.

    direction: in which the light goes.  inner, outer: half angles of the cone, radians.
    """

    kind: str
    color: RGB
    position: RGB = (0.0, 0.0, 0.0)
    direction: RGB = (0.0, 0.0, -1.0)
    inner: float = 0.0
    outer: float = 0.0


def metal(
    k_d: Sequence[float], k_s: Sequence[float], n: float, glow: RGB = (0.0, 0.0, 0.0), alpha: float = 1.0
) -> Metal:
    """The metallic-roughness material for k_d and k_s (RGB) and n, as the top of this file says.

    glow: the sum of the terms that depend on no direction, E + k_a (I_a + ...).
    """
    d, s = np.clip(k_d, 0.0, None), np.clip(k_s, 0.0, None)
    strength = max(_brightness(s), 1e-9)
    alpha_2 = min(max(2.0 / (n + 2.0), DIELECTRIC / (4.0 * strength)), 1.0)
    F_0 = np.clip(4.0 * alpha_2 * s, 0.0, 0.98)
    c_diff = d / (1.0 - np.maximum(F_0, DIELECTRIC))
    dielectric = 1.0 - DIELECTRIC
    m = _metallic(_brightness(c_diff), _brightness(F_0))
    base = c_diff / (dielectric * max(1.0 - m, 1e-6))
    if m > 0.0:
        from_specular = np.clip((F_0 - DIELECTRIC * (1.0 - m)) / m, 0.0, None)
        base = base + (from_specular - base) * m * m
    r, g, b = (base / max(1.0, float(base.max()))).tolist()
    return Metal((r, g, b, alpha), m, float(alpha_2**0.25), glow)


def face(material: Metal) -> Face:
    """The way back: k_d, k_s and n for a metallic-roughness material, with n <= 128.

    k_a is the base colour, which pyrender multiplies with the scene's ambient light.
    """
    base, m = np.array(material.base[:3], np.float64), material.metallic
    alpha_2 = max(max(material.roughness, DIELECTRIC) ** 4, 2.0 / (MAX_N + 2.0))
    F_0 = DIELECTRIC * (1.0 - m) + m * base
    k_d = (1.0 - F_0) * (1.0 - DIELECTRIC) * (1.0 - m) * base
    k_s, a = F_0 / (4.0 * alpha_2), material.base[3]
    return Face((*_rgb(base), a), (*_rgb(k_d), a), (*_rgb(k_s), 1.0), (*material.glow, 1.0), 2.0 / alpha_2 - 2.0)


def _brightness(rgb: Float) -> float:
    """Perceived brightness, as Khronos's conversion weighs red, green and blue."""
    return float(np.sqrt(rgb**2 @ (0.299, 0.587, 0.114)))


def _metallic(diffuse: float, specular: float) -> float:
    """The share of metal in [0, 1] for which c_diff = ``diffuse`` and F_0 = ``specular`` have one base colour:
    a m^2 + b m + c = 0, from F_0 = 0.04 (1 - m) + m base and base = c_diff / (0.96 (1 - m))."""
    if specular <= DIELECTRIC:
        return 0.0
    a, c = DIELECTRIC, DIELECTRIC - specular
    b = diffuse / (1.0 - DIELECTRIC) + specular - 2.0 * DIELECTRIC
    return float(np.clip((-b + np.sqrt(max(b * b - 4.0 * a * c, 0.0))) / (2.0 * a), 0.0, 1.0))


def source(light: Light, share: float = 1.0) -> Source:
    """A light of OpenGL as one of KHR_lights_punctual.

    share: of a positional light of brightness 1, what it would send to the distance 1: the mean over the lit surface of
    d^2 times its attenuation.
    """
    x, y, z, w = light.position
    axis = np.array(light.spot_direction) / max(float(np.linalg.norm(light.spot_direction)), 1e-30)
    r, g, b = np.array(light.diffuse[:3]) * np.pi
    if w == 0.0:
        L = np.array((x, y, z)) / max(float(np.linalg.norm((x, y, z))), 1e-30)
        if light.spot_cutoff <= 90.0:  # seen from infinitely far, the spot's factor is the same everywhere
            cosine = float(-L @ axis)
            inside = cosine >= np.cos(np.radians(light.spot_cutoff))
            r, g, b = np.array((r, g, b)) * (cosine**light.spot_exponent if inside else 0.0)
        return Source("directional", (float(r), float(g), float(b)), direction=_rgb(-L))
    color, position = _rgb(np.array((r, g, b)) * share), _rgb(np.array((x, y, z)) / w)
    if light.spot_cutoff > 90.0:
        return Source("point", color, position)
    return Source("spot", color, position, _rgb(axis), *cone(light.spot_cutoff, light.spot_exponent))


def cone(cutoff: float, exponent: float) -> tuple[float, float]:
    """Inner and outer angle, radians, of the cone whose falloff stands for (cos)^exponent inside ``cutoff`` degrees.

    In KHR_lights_punctual's recommended falloff ((cos - cos outer) / (cos inner - cos outer))^2 half of the intensity
    is where the fraction is sqrt(1/2); here where (cos)^exponent is 1/2.  If that is outside the cutoff, the edge is
    hard.  If the inner angle would have to be negative, the outer one becomes less than the cutoff.
    """
    half = 0.5 ** (1.0 / exponent) if exponent > 0.0 else 0.0
    outer = float(np.cos(np.radians(min(cutoff, 90.0))))
    if half <= outer:
        return float(np.arccos(outer)), float(np.arccos(outer))
    inner = outer + (half - outer) / np.sqrt(0.5)
    if inner > 1.0:
        return 0.0, float(np.arccos((half - np.sqrt(0.5)) / (1.0 - np.sqrt(0.5))))
    return float(np.arccos(inner)), float(np.arccos(outer))


def exponent(inner: float, outer: float) -> float:
    """The way back: GL_SPOT_EXPONENT with half of the intensity at the same angle; angles in radians."""
    half = np.cos(outer) + np.sqrt(0.5) * (np.cos(inner) - np.cos(outer))
    if inner >= outer or half <= 0.0:
        return 0.0
    return float(min(np.log(0.5) / np.log(half), 128.0))


def _rgb(values: Float) -> RGB:
    a, b, c = values.tolist()
    return a, b, c
