"""The illumination equation as OpenGL evaluates it, with every factor of every term kept.

    I = emission + k_a I_a + sum over lights of
            attenuation * spot * ( k_a I_a,light + k_d I_d (N.L) + k_s I_s (N.H)^n )

This is equation 2.5 of OpenGL 1.5, section 2.14.1; the lecture's sum over all lights.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike

from glsim.shading.terms import (
    Float,
    attenuation,
    dot,
    halfway,
    normalize,
    power,
    reflection,
    spotlight,
    towards_light,
)


class LightSource(Protocol):
    """A light: glsim.machine.state.Light is one.  Colours begin with red, green, blue; vectors are in N's space.

    position: (x, y, z, w), a point if w is not 0, else the direction TOWARDS the light.  spot_cutoff: degrees, 180 for
    no spot.  The attenuations are k_0, k_1 and k_2 of ``terms.attenuation``.
    """

    @property
    def ambient(self) -> Sequence[float]: ...
    @property
    def diffuse(self) -> Sequence[float]: ...
    @property
    def specular(self) -> Sequence[float]: ...
    @property
    def position(self) -> Sequence[float]: ...
    @property
    def spot_direction(self) -> Sequence[float]: ...
    @property
    def spot_exponent(self) -> float: ...
    @property
    def spot_cutoff(self) -> float: ...
    @property
    def constant_attenuation(self) -> float: ...
    @property
    def linear_attenuation(self) -> float: ...
    @property
    def quadratic_attenuation(self) -> float: ...


class Surface(NamedTuple):
    """A material: reflectances and emission (..., 3), for each point or for all; n: shininess in [0, 128]."""

    k_a: ArrayLike
    k_d: ArrayLike
    k_s: ArrayLike
    emission: ArrayLike
    n: ArrayLike


class Contribution(NamedTuple):
    """What one light adds, and the factors it is made of: vectors (..., 3), scalars (..., 1), terms (..., 3).

    d: distance, inf for a directional light.  N: the normal, flipped where ``flip`` is set and N.L < 0.  H_or_R: the
    vector of the highlight; cosine: N.H or R.V; power: cosine^n where N.L > 0, else 0.  ambient, diffuse, specular: the
    light's terms, multiplied by ``strength``, which is attenuation times spot.
    """

    L: Float
    d: Float
    attenuation: Float
    spot: Float
    N: Float
    N_L: Float
    V: Float
    H_or_R: Float
    cosine: Float
    power: Float
    ambient: Float
    diffuse: Float
    specular: Float

    @property
    def strength(self) -> Float:
        return np.asarray(self.attenuation * self.spot)


class Illumination(NamedTuple):
    """All terms, (..., 3) each, not clamped.  ambient: k_a times the scene's ambient light."""

    emission: Float
    ambient: Float
    lights: list[Contribution]

    @property
    def highlight(self) -> Float:
        """The specular terms of all lights."""
        return np.asarray(sum((light.specular for light in self.lights), np.zeros_like(self.ambient)))

    @property
    def color(self) -> Float:
        """Everything but the specular terms."""
        return np.asarray(sum((light.ambient + light.diffuse for light in self.lights), self.emission + self.ambient))

    @property
    def sum(self) -> Float:
        return self.color + self.highlight


def towards(light: LightSource, P: Float) -> tuple[Float, Float, Float]:
    """Unit vectors to the light from points P (..., 3), distances (..., 1) and attenuation (..., 1)."""
    position, w = np.asarray(light.position[:3], np.float64), light.position[3]
    if w == 0.0:
        ones = np.ones((*P.shape[:-1], 1))
        return np.broadcast_to(normalize(position), P.shape), ones * np.inf, ones
    to_light = position / w - P
    d = np.sqrt(dot(to_light, to_light))
    k = light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation
    return normalize(to_light), d, attenuation(d, *k)


def contribution(
    surface: Surface, light: LightSource, N: Float, P: Float, V: Float, *, lobe: str = "blinn", flip: bool = False
) -> Contribution:
    """What one light adds at points P with unit normals N and unit vectors V to the eye; see ``illuminate``."""
    L, d, attenuated = towards(light, P)
    spot = spotlight(L, normalize(light.spot_direction), light.spot_cutoff, light.spot_exponent)
    strength = attenuated * spot
    N = towards_light(N, L, flip)
    N_L = dot(N, L)
    H_or_R = reflection(N, L) if lobe == "phong" else halfway(L, V)
    cosine = dot(H_or_R, V) if lobe == "phong" else dot(N, H_or_R)
    highlight = np.where(N_L > 0.0, power(cosine, surface.n), 0.0)
    I_a, I_d, I_s = (np.asarray(color[:3], np.float64) for color in (light.ambient, light.diffuse, light.specular))
    return Contribution(
        L, d, attenuated, spot, N, N_L, np.broadcast_to(V, L.shape), H_or_R, cosine, highlight,
        ambient=strength * np.asarray(surface.k_a) * I_a,
        diffuse=strength * np.asarray(surface.k_d) * I_d * np.maximum(N_L, 0.0),
        specular=strength * np.asarray(surface.k_s) * I_s * highlight,
    )  # fmt: skip


def illuminate(
    surface: Surface,
    lights: Sequence[LightSource],
    N: ArrayLike,
    P: ArrayLike,
    *,
    scene_ambient: ArrayLike = (0.0, 0.0, 0.0),
    local_viewer: bool = True,
    lobe: str = "blinn",
    flip: bool = False,
) -> Illumination:
    """Evaluate the equation at points P (..., 3) with unit normals N (..., 3), the eye at the origin.

    scene_ambient: I_a of the whole scene.  local_viewer: V = -P / |P|, else V = (0, 0, 1).  lobe: "blinn" for (N.H)^n,
    "phong" for (R.V)^n.  flip: where N.L < 0, use -N instead of N.  Raises ValueError for another lobe.
    """
    if lobe not in ("blinn", "phong"):
        raise ValueError(f'illuminate: lobe must be "blinn" or "phong", not {lobe!r}')
    N, P = np.asarray(N, np.float64), np.asarray(P, np.float64)
    surface = Surface(*(np.asarray(part, np.float64) for part in surface))
    V = normalize(-P) if local_viewer else np.array([0.0, 0.0, 1.0])
    shape = np.broadcast_shapes(N.shape, P.shape)
    emission = np.broadcast_to(surface.emission, shape).astype(np.float64)
    ambient = np.broadcast_to(np.asarray(surface.k_a) * np.asarray(scene_ambient, np.float64), shape)
    contributions = [contribution(surface, light, N, P, V, lobe=lobe, flip=flip) for light in lights]
    return Illumination(emission, ambient, contributions)
