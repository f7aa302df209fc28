"""A fragment on the CPU: lighting, texture environment, fog, tests and blending in float64, as shaders/ does them.

Together with glsim.machine.stage this is a second implementation of the pipeline, to check the GPU against.  The
results of rasterisation and texture lookup (weights, depth, texels) are read from the GPU by glsim.render.inspect.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim import shading
from glsim.machine import constants as gl
from glsim.machine.stage import Stage, illumination, shown, vertex_stage
from glsim.machine.state import ColorBuffer, Combine, Fog, TextureUnit
from glsim.render.inspect import Piece
from glsim.render.key import UnitKind, unit_kind
from glsim.shading import Illumination

Float = NDArray[np.float64]

# ---------------------------------------------------------------- lighting


@dataclass(frozen=True)
class Shaded:
    """The colours of n fragments of a piece, and where they come from.

    where: where the colour is computed: "fragment" (Phong), "vertex" (Gouraud) or "provoking" (flat, also without
    lighting); "none" without lighting, if the vertices' colours are interpolated.
    stage: the m vertices of the fragments' primitives.  corners: (n, k), for each fragment the numbers of its k corners
    among these.  weights: (n, k), perspective-correct.
    terms: the terms of the equation, for m vertices or n fragments; None without lighting.
    N, P: normal and position of the fragments in eye space, (n, 3).
    primary: colour RGBA (n, 4) in [0, 1].  highlight: separate specular colour (n, 3) in [0, 1].
    """

    where: str
    stage: Stage
    corners: NDArray[np.int64]
    weights: Float
    terms: Illumination | None
    N: Float
    P: Float
    primary: Float
    highlight: Float

    def spread(self, values: Float) -> Float:
        """Values at the places of ``where`` (m vertices or n fragments, c channels) -> values at the fragments, (n, c).

        Phong: unchanged; flat: of the provoking vertex; else interpolated with the weights."""
        if self.where == "fragment":
            return values
        if self.where == "provoking":
            return np.asarray(values[self.corners[:, -1]])
        return interpolated(values, self.corners, self.weights)


def interpolated(values: Float, corners: NDArray[np.int64], weights: Float) -> Float:
    """Values of vertices (m, c) -> of fragments (n, c)."""
    return np.asarray(np.einsum("nk,nkc->nc", weights, values[corners]))


def shade(piece: Piece, primitives: NDArray[np.int64], weights: Float, back: bool) -> Shaded:
    """The colours of n fragments of a piece.

    primitives: (n,) number of each fragment's primitive.  weights: (n, k) weights of its corners, perspective-correct.

    back: whether the fragments show the back side.
    """
    draw = piece.draw
    lighting = draw.state.lighting
    numbers = piece.vertices(primitives)
    chosen, places = np.unique(numbers, return_inverse=True)
    corners: NDArray[np.int64] = places.reshape(numbers.shape)
    weights = weights[:, : piece.corners]
    stage = vertex_stage(draw, chosen.astype(np.uint32), 0, colors=False)
    point = stage.point
    N, P = interpolated(stage.normal, corners, weights), interpolated(point, corners, weights)
    if not lighting.enabled:
        where = "provoking" if lighting.shade_model == gl.GL_FLAT else "none"
        place = Shaded(where, stage, corners, weights, None, N, P, np.empty(0), np.empty(0))
        return _with(place, place.spread(stage.front), place.spread(stage.highlight))
    sign, side = (-1.0, gl.GL_BACK) if back and lighting.two_side and piece.corners == 3 else (1.0, gl.GL_FRONT)
    if lighting.shade_model == gl.GL_PHONG_WIN:
        N = shading.normalize(N) * sign
        color = interpolated(stage.current, corners, weights)
        materials = draw.materials_at(numbers[:, -1])
        terms, alpha = illumination(lighting, side, materials, N, P, color)
        return Shaded("fragment", stage, corners, weights, terms, N, P, *shown(lighting, terms, alpha))
    terms, alpha = illumination(lighting, side, draw.materials_at(chosen), stage.normal * sign, point, stage.current)
    where = "provoking" if lighting.shade_model == gl.GL_FLAT else "vertex"
    place = Shaded(where, stage, corners, weights, terms, N * sign, P, np.empty(0), np.empty(0))
    color, highlight = shown(lighting, terms, alpha)
    return _with(place, place.spread(color), place.spread(highlight))


def _with(place: Shaded, primary: Float, highlight: Float) -> Shaded:
    fields = (place.where, place.stage, place.corners, place.weights, place.terms, place.N, place.P)
    return Shaded(*fields, primary, highlight)


# ---------------------------------------------------------------- texture environment


class Textured(NamedTuple):
    """One texture unit: its texel (4,), and the fragment's colour (4,) after its texture environment."""

    unit: int
    environment: int
    texel: Float
    color: Float


def textured(units: tuple[TextureUnit, ...], primary: Float, texels: Float) -> list[Textured]:
    """Apply the enabled texture units, in order, to a fragment's colour ``primary`` (4,); one entry for each.

    texels: (4, 4), the RGBA texel of each unit."""
    steps: list[Textured] = []
    color = primary
    for number, unit in enumerate(units):
        kind = unit_kind(number, unit)
        if kind is not None:
            color = np.clip(_environment(kind, unit, color, primary, texels), 0.0, 1.0)
            steps.append(Textured(number, unit.environment, texels[number], color))
    return steps


def _environment(kind: UnitKind, unit: TextureUnit, C: Float, primary: Float, texels: Float) -> Float:
    """OpenGL 1.5, tables 3.22 and 3.23."""
    T, C_c = texels[kind.number], np.array(unit.environment_color)
    if kind.environment == gl.GL_COMBINE:
        return _combine(kind.number, unit, C, primary, texels)
    rgb, a = C[:3], C[3]
    if kind.environment == gl.GL_DECAL:
        if kind.has_color:
            rgb = C[:3] * (1 - T[3]) + T[:3] * T[3] if kind.has_alpha else T[:3]
        return np.append(rgb, a)
    if kind.has_color:
        rgb = {
            gl.GL_REPLACE: T[:3], gl.GL_MODULATE: rgb * T[:3], gl.GL_BLEND: rgb * (1 - T[:3]) + C_c[:3] * T[:3],
            gl.GL_ADD: rgb + T[:3],
        }[kind.environment]  # type: ignore[index]  # fmt: skip
    if kind.has_alpha:
        mixed = a * (1 - T[3]) + C_c[3] * T[3] if kind.is_intensity else a * T[3]
        added = a + T[3] if kind.is_intensity else a * T[3]
        a = {gl.GL_REPLACE: T[3], gl.GL_MODULATE: a * T[3], gl.GL_BLEND: mixed, gl.GL_ADD: added}[kind.environment]  # type: ignore[index]
    return np.append(rgb, a)


def _combine(number: int, unit: TextureUnit, C: Float, primary: Float, texels: Float) -> Float:
    """GL_COMBINE: OpenGL 1.5, tables 3.24 and 3.25."""
    combine: Combine = unit.combine
    fixed = {gl.GL_TEXTURE: texels[number], gl.GL_CONSTANT: np.array(unit.environment_color),
    gl.GL_PRIMARY_COLOR: primary,
             gl.GL_PREVIOUS: C}  # fmt: skip

    def source(which: int) -> Float:
        return np.asarray(fixed[which] if which in fixed else texels[which - gl.GL_TEXTURE0])  # type: ignore[index]

    def rgb(k: int) -> Float:
        value, operand = source(combine.source_rgb[k]), combine.operand_rgb[k]
        part = value[:3] if operand in (gl.GL_SRC_COLOR, gl.GL_ONE_MINUS_SRC_COLOR) else np.repeat(value[3], 3)
        return part if operand in (gl.GL_SRC_COLOR, gl.GL_SRC_ALPHA) else 1.0 - part

    def alpha(k: int) -> Float:
        value = source(combine.source_alpha[k])[3:]
        return value if combine.operand_alpha[k] == gl.GL_SRC_ALPHA else 1.0 - value

    color = _combined(combine.rgb, [rgb(k) for k in range(3)])
    if combine.rgb == gl.GL_DOT3_RGBA:
        return np.append(color, color[0]) * combine.scale_rgb
    a = _combined(combine.alpha, [alpha(k) for k in range(3)])
    return np.append(color * combine.scale_rgb, a[0] * combine.scale_alpha)


def _combined(how: int, a: list[Float]) -> Float:
    if how in (gl.GL_DOT3_RGB, gl.GL_DOT3_RGBA):
        return np.full(3, 4.0 * float((a[0] - 0.5) @ (a[1] - 0.5)))
    values: dict[int, Float] = {
        gl.GL_REPLACE: a[0], gl.GL_MODULATE: a[0] * a[1], gl.GL_ADD: a[0] + a[1], gl.GL_ADD_SIGNED: a[0] + a[1] - 0.5,
        gl.GL_INTERPOLATE: a[0] * a[2] + a[1] * (1.0 - a[2]), gl.GL_SUBTRACT: a[0] - a[1],
    }  # fmt: skip
    return values[how]


# ---------------------------------------------------------------- fog, tests, blending


def fog_factor(fog: Fog, z: float) -> float:
    """The fog factor f in [0, 1] at eye distance z: C = f C_fragment + (1 - f) C_fog (equations 3.24 to 3.26)."""
    with np.errstate(all="ignore"):
        z, d, start, end = np.float64(z), np.float64(fog.density), np.float64(fog.start), np.float64(fog.end)
        factors = {
            gl.GL_LINEAR: (end - z) / (end - start),
            gl.GL_EXP: np.exp(-d * z),
            gl.GL_EXP2: np.exp(-d * d * z * z),
        }
    return float(np.clip(factors[fog.mode], 0.0, 1.0))  # type: ignore[index]


COMPARISONS: dict[int, Callable[[int, int], bool]] = {
    gl.GL_NEVER: lambda a, b: False, gl.GL_LESS: lambda a, b: a < b, gl.GL_EQUAL: lambda a, b: a == b,
    gl.GL_LEQUAL: lambda a, b: a <= b, gl.GL_GREATER: lambda a, b: a > b, gl.GL_NOTEQUAL: lambda a, b: a != b,
    gl.GL_GEQUAL: lambda a, b: a >= b, gl.GL_ALWAYS: lambda a, b: True,
}  # fmt: skip
COMPARISON_SIGNS: dict[int, str] = {
    gl.GL_NEVER: "never", gl.GL_LESS: "<", gl.GL_EQUAL: "=", gl.GL_LEQUAL: "<=", gl.GL_GREATER: ">",
    gl.GL_NOTEQUAL: "!=",
    gl.GL_GEQUAL: ">=", gl.GL_ALWAYS: "always",
}  # fmt: skip


def blend_factor(factor: int, source: Float, destination: Float, constant: Float) -> Float:
    """One factor of glBlendFunc as (4,) (OpenGL 1.5, table 4.2)."""
    alpha = np.ones(4)
    saturated = np.append(np.repeat(min(source[3], 1.0 - destination[3]), 3), 1.0)
    factors: dict[int, Float] = {
        gl.GL_ZERO: 0 * alpha, gl.GL_ONE: alpha, gl.GL_SRC_COLOR: source, gl.GL_ONE_MINUS_SRC_COLOR: 1 - source,
        gl.GL_DST_COLOR: destination, gl.GL_ONE_MINUS_DST_COLOR: 1 - destination, gl.GL_SRC_ALPHA: source[3] * alpha,
        gl.GL_ONE_MINUS_SRC_ALPHA: (1 - source[3]) * alpha, gl.GL_DST_ALPHA: destination[3] * alpha,
        gl.GL_ONE_MINUS_DST_ALPHA: (1 - destination[3]) * alpha, gl.GL_CONSTANT_COLOR: constant,
        gl.GL_ONE_MINUS_CONSTANT_COLOR: 1 - constant, gl.GL_CONSTANT_ALPHA: constant[3] * alpha,
        gl.GL_ONE_MINUS_CONSTANT_ALPHA: (1 - constant[3]) * alpha, gl.GL_SRC_ALPHA_SATURATE: saturated,
    }  # fmt: skip
    return factors[factor]


def blended(color: ColorBuffer, source: Float, destination: Float) -> Float:
    """glBlendFunc and glBlendEquation of two colours (4,), not yet clamped."""
    constant = np.array(color.blend_color)
    f = [blend_factor(factor, source, destination, constant) for factor in color.blend_function]
    s = np.append(f[0][:3], f[2][3]) * source
    d = np.append(f[1][:3], f[3][3]) * destination
    if color.blend_equation in (gl.GL_MIN, gl.GL_MAX):
        return (np.minimum if color.blend_equation == gl.GL_MIN else np.maximum)(source, destination)
    if color.blend_equation == gl.GL_FUNC_SUBTRACT:
        return np.asarray(s - d)
    return np.asarray(d - s if color.blend_equation == gl.GL_FUNC_REVERSE_SUBTRACT else s + d)


def logic_op(op: int, s: NDArray[np.int64], d: NDArray[np.int64]) -> NDArray[np.int64]:
    """glLogicOp on 8-bit colours (4,): GL_CLEAR is 0x1500, GL_SET 0x150F (OpenGL 1.5, table 4.3)."""
    ops = (0, s & d, s & ~d, s, ~s & d, d, s ^ d, s | d, ~(s | d), ~(s ^ d), ~d, s | ~d, ~s, ~s | d, ~(s & d), 255)
    return np.asarray(ops[int(op) & 15] & np.full(4, 255))


def to_8_bits(color: Float) -> NDArray[np.int64]:
    return np.asarray(np.floor(np.clip(np.nan_to_num(color), 0.0, 1.0) * 255.0 + 0.5), np.int64)
