"""What a Frame draws, in the terms of a physically based renderer: triangles in eye space, metallic-roughness
materials, radiant lights.  The formulas are in glsim.study.metallic."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import corners, primitives
from glsim.machine.frame import Accum, Clear, Draw, Frame, Packet, Pixels
from glsim.machine.stage import Stage, surface, vertex_stage
from glsim.machine.state import Light, Lighting, Snapshot
from glsim.play.reshade import needed
from glsim.study.metallic import DIELECTRIC, RGB, Metal, Source, metal, source

Float = NDArray[np.float64]
Notes = dict[str, None]  # sentences, each once, in order
Falloffs = dict[Light, tuple[float, float]]  # of positional lights: mean of d^2 times the attenuation, and of itself

OVER = (gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
MOST_MATERIALS = 32  # in one Draw: with more, vertex colours stand for them


class Around(NamedTuple):
    """What surrounds a part.  ambient: factor of the base colour, 1 for what is drawn unlit.  projection: for points as
    rows, the transpose of the specification's.  local_viewer: whether V points to the eye, else along z."""

    sources: tuple[Source, ...]
    ambient: float
    projection: tuple[tuple[float, ...], ...]
    viewport: tuple[int, int, int, int]
    local_viewer: bool


class Part(NamedTuple):
    """Points, lines or triangles of one material: corners 1, 2 or 3 a primitive, one after the other.

    positions, normals: (n, 3) float32 in eye space.  colors: (n, 4), factors of the whole colour, or None.
    both_sides: nothing is culled; else triangles that turn clockwise on the screen are.  wire: only edges are drawn.
    blended: with its alpha over what lies behind.
    """

    corners: int
    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    colors: NDArray[np.float32] | None
    material: Metal
    around: Around
    both_sides: bool
    wire: bool
    blended: bool


class Physical(NamedTuple):
    """A Frame, converted.  background: linear RGB.  notes: sentences about what could not be converted."""

    width: int
    height: int
    background: RGB
    parts: list[Part]
    notes: list[str]


def physical(frame: Frame) -> Physical:
    """Convert what ``frame`` shows, from its last glClear of the whole picture on."""
    packets = needed(frame.packets)
    clears = [p for p in packets if isinstance(p, Clear) and p.mask & gl.GL_COLOR_BUFFER_BIT]
    r, g, b = np.clip(clears[-1].state.color_buffer.clear[:3], 0.0, 1.0).tolist() if clears else (0.0, 0.0, 0.0)
    pieces = [_piece(p) for p in packets if isinstance(p, Draw) and p.count]
    pieces = [piece for piece in pieces if len(piece.corners)]
    notes: Notes = dict.fromkeys(_left_out(packets))
    falloffs = _falloffs(pieces)
    sorted_parts: dict[Any, list[Part]] = {}
    for number, piece in enumerate(pieces):
        for part in _parts(piece, falloffs, notes):
            key = (part.corners, part.colors is None, *part[4:], number if part.blended else 0)
            sorted_parts.setdefault(key, []).append(part)
    return Physical(frame.width, frame.height, (r, g, b), [_joined(parts) for parts in sorted_parts.values()],
                    list(notes))  # fmt: skip


def _joined(parts: list[Part]) -> Part:
    def column(name: str) -> Any:
        return np.concatenate([getattr(part, name) for part in parts])

    colors = None if parts[0].colors is None else column("colors")
    return parts[0]._replace(positions=column("positions"), normals=column("normals"), colors=colors)


# ---------------------------------------------------------------- geometry


class _Piece(NamedTuple):
    """A Draw in eye space.  chosen: numbers of its vertices in its block.  corners: (m, k), which of them each of m
    primitives has.  points, normals: (len(chosen), 3)."""

    draw: Draw
    chosen: NDArray[np.uint32]
    corners: NDArray[np.int64]
    stage: Stage
    points: Float
    normals: Float


def _piece(draw: Draw) -> _Piece:
    count = draw.count if draw.indices is None else len(draw.indices)
    numbers = primitives(draw.mode, count, draw.indices, last=False).astype(np.int64) + draw.first
    chosen, places = np.unique(numbers, return_inverse=True)
    stage = vertex_stage(draw, chosen.astype(np.uint32), 0, colors=False)
    with np.errstate(all="ignore"):
        points = stage.eye[:, :3] / stage.eye[:, 3:]
    k = corners(draw.mode)
    rings = places.reshape(-1, k)
    whole = np.asarray(np.isfinite(points).all(axis=1))
    normals = np.where(np.isfinite(stage.normal), stage.normal, 0.0)
    normals[~normals.any(axis=1)] = (0.0, 0.0, 1.0)  # no direction: a physically based shader would divide by zero
    return _Piece(draw, chosen.astype(np.uint32), rings[whole[rings].all(axis=1)], stage, points, normals)


def _parts(piece: _Piece, falloffs: Falloffs, notes: Notes) -> Iterator[Part]:
    """The parts of a Draw: one for each material and side."""
    state = piece.draw.state
    lighting, polygon, view = state.lighting, state.polygon, state.viewport
    sources, ambient = _sources(lighting, falloffs, notes) if lighting.enabled else ((), np.zeros(3))
    projection = tuple(map(tuple, piece.draw.matrices[1].get().astype(np.float64).tolist()))
    around = Around(sources, float(not lighting.enabled), projection, (view.x, view.y, view.width, view.height),
                    lighting.local_viewer)  # fmt: skip
    blended = state.color_buffer.blend and state.color_buffer.blend_function[:2] == OVER
    for side, sign, order, both in _sides(piece):
        mode = polygon.front_mode if side == gl.GL_FRONT else polygon.back_mode
        wire = piece.corners.shape[1] == 3 and mode != gl.GL_FILL
        for material, rings, colors in _materials(piece, side, ambient, notes):
            numbers = rings[:, order].ravel()
            yield Part(rings.shape[1], piece.points[numbers].astype(np.float32),
                       (sign * piece.normals[numbers]).astype(np.float32),
                       None if colors is None else colors[numbers].astype(np.float32),
                       material, around, both, wire, blended)  # fmt: skip


def _sides(piece: _Piece) -> list[tuple[int, float, slice, bool]]:
    """Which sides of a Draw's primitives are shown: (whose material, factor of the normals, order of the corners so
    that they run counterclockwise on the screen, whether the other side looks the same)."""
    lighting, polygon = piece.draw.state.lighting, piece.draw.state.polygon
    given, turned = slice(None), slice(None, None, -1)
    two = lighting.enabled and lighting.two_side
    if piece.corners.shape[1] < 3 or not (two or polygon.cull):
        return [(gl.GL_FRONT, 1.0, given, True)]
    front, back = (given, turned) if polygon.front_face == gl.GL_CCW else (turned, given)
    culled = {polygon.cull_face} if polygon.cull else set()
    culled |= {gl.GL_FRONT, gl.GL_BACK} if gl.GL_FRONT_AND_BACK in culled else set()
    sides: list[tuple[int, float, slice, bool]] = []
    if gl.GL_FRONT not in culled:
        sides.append((gl.GL_FRONT, 1.0, front, False))
    if gl.GL_BACK not in culled:
        sides.append((gl.GL_BACK, -1.0, back, False) if two else (gl.GL_FRONT, 1.0, back, False))
    return sides


# ---------------------------------------------------------------- materials


def _materials(
    piece: _Piece, side: int, ambient: Float, notes: Notes
) -> Iterator[tuple[Metal, NDArray[np.int64], Float | None]]:
    """The materials of one side of a Draw, the primitives (m, k) that have them, and factors (vertices, 4) or None."""
    lighting, rings = piece.draw.state.lighting, piece.corners
    if not lighting.enabled:
        yield Metal(), rings, np.clip(piece.stage.current, 0.0, 1.0)
        return
    face, alpha = surface(lighting, side, piece.draw.materials_at(piece.chosen), piece.stage.current)
    k_a, k_d, k_s, emission, n = (np.asarray(column, np.float64) for column in face)
    rows = np.concatenate([k_d, k_s, emission + k_a * ambient, n, alpha], axis=1)
    kinds, kind = np.unique(rows, axis=0, return_inverse=True)
    of_corners = kind.reshape(-1)[rings]
    same = (of_corners == of_corners[:, :1]).all(axis=1) & (len(kinds) <= MOST_MATERIALS)
    for number in np.unique(of_corners[same, 0]):
        yield _noted(kinds[number], notes), rings[same & (of_corners[:, 0] == number)], None
    if not same.all():
        mean = rows[rings[~same]].mean(axis=(0, 1))
        notes["colours that vary from vertex to vertex also multiply the highlight: glTF's vertex colours are factors"
              " of the base colour, and pyrender applies them to the whole"] = None  # fmt: skip
        factors = np.c_[rows[:, :3] / np.maximum(mean[:3], 1e-6), rows[:, 10:] / max(mean[10], 1e-6)]
        yield _noted(mean, notes), rings[~same], factors


def _noted(row: Float, notes: Notes) -> Metal:
    """The Metal of k_d, k_s, glow (RGB each), n and alpha; a note if it cannot be as bright as OpenGL's."""
    k_d, k_s, n = row[:3].tolist(), row[3:6].tolist(), float(row[9])
    r, g, b = np.clip(row[6:9], 0.0, None).tolist()
    material = metal(k_d, k_s, n, (r, g, b), float(np.clip(row[10], 0.0, 1.0)))
    base = np.array(material.base[:3])
    F_0 = DIELECTRIC + material.metallic * (base - DIELECTRIC)
    diffuse = (1.0 - F_0) * (1.0 - DIELECTRIC) * (1.0 - material.metallic) * base
    kept = float(diffuse.sum()) / max(sum(k_d), 1e-9)
    if base.max() > 0.9999 and kept < 0.99:
        name = ", ".join(f"{value:.3g}" for value in k_d)
        notes[f"the material with k_d = ({name}) would reflect more light than arrives: its base colour is scaled down,"
              f" and its diffuse light is {kept:.0%} of OpenGL's"] = None  # fmt: skip
    return material


# ---------------------------------------------------------------- lights


def _falloffs(pieces: list[_Piece]) -> Falloffs:
    """For each positional light, over the triangles that it lights, weighted by area, the geometric means of d^2 times
    its attenuation (in pyrender a light of intensity 1 has 1 / d^2) and of its attenuation."""
    sums: dict[Light, NDArray[np.float64]] = {}
    for piece in pieces:
        lighting = piece.draw.state.lighting
        lights = {light for light, on in zip(lighting.lights, lighting.light_enabled, strict=True)
                  if on and light.position[3] != 0.0}  # fmt: skip
        if not lighting.enabled or piece.corners.shape[1] < 3 or not lights:
            continue
        at = piece.points[piece.corners]
        area = np.linalg.norm(np.cross(at[:, 1] - at[:, 0], at[:, 2] - at[:, 0]), axis=1)
        centre, N = at.mean(axis=1), piece.normals[piece.corners].mean(axis=1)
        for light in lights:
            to_light = np.array(light.position[:3]) / light.position[3] - centre
            d = np.maximum(np.linalg.norm(to_light, axis=1), 1e-9)
            lit = np.einsum("nk,nk->n", N, to_light) > 0.0
            weight = area * np.where(lit, 1.0, 1e-6)  # if nothing is lit, all surfaces count
            k_c, k_l, k_q = light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation
            fall = -np.log(np.maximum(k_c + k_l * d + k_q * d * d, 1e-30))
            values = np.array([weight.sum(), weight @ (fall + 2.0 * np.log(d)), weight @ fall])
            sums[light] = sums.get(light, np.zeros(3)) + values
    return {light: (float(np.exp(a / w)), float(np.exp(b / w))) for light, (w, a, b) in sums.items() if w > 0.0}


def _sources(lighting: Lighting, falloffs: Falloffs, notes: Notes) -> tuple[tuple[Source, ...], Float]:
    """The enabled lights, and the ambient light of all of them and of the scene, (3,)."""
    ambient = np.array(lighting.ambient[:3], np.float64)
    sources = []
    for number, (light, on) in enumerate(zip(lighting.lights, lighting.light_enabled, strict=True)):
        if not on:
            continue
        share, mean = falloffs.get(light, (1.0, 1.0))
        ambient += mean * np.array(light.ambient[:3])
        if any(light.diffuse[:3]):
            sources.append(source(light, share))
        for sentence in _unlike(light):
            notes[f"light {number}: {sentence}"] = None
    return tuple(sources), ambient


def _unlike(light: Light) -> Iterator[str]:
    """Sentences about what of a light cannot be converted."""
    if light.specular[:3] != light.diffuse[:3]:
        yield "it has one colour, I_d, also for the highlight; I_s is left out"
    if light.position[3] == 0.0:
        return
    if light.constant_attenuation or light.linear_attenuation:
        yield "it falls off with 1 / d^2, not as OpenGL's attenuation; as bright on average over what it lights"
        if any(light.ambient[:3]):
            yield "its ambient light is the same everywhere, at its mean attenuation"
    if light.spot_cutoff <= 90.0 and light.spot_exponent > 0.0:
        yield "its cone falls off as in KHR_lights_punctual, not with (cos)^e; the angle of half its intensity is kept"


# ---------------------------------------------------------------- what stays behind


def _left_out(packets: list[Packet]) -> Iterator[str]:
    """Sentences about what a program draws with and pyrender does not have."""
    for kind, words in ((Pixels, "glDrawPixels, glCopyPixels and glBitmap"), (Accum, "the accumulation buffer")):
        if any(isinstance(packet, kind) for packet in packets):
            yield f"{words}: left out"
    drawn = [packet for packet in packets if isinstance(packet, Draw) and packet.count]
    for words, is_used in _FEATURES.items():
        if any(is_used(draw.state) for draw in drawn):
            yield words
    if any(corners(d.mode) == 3 and gl.GL_FILL not in (d.state.polygon.front_mode, d.state.polygon.back_mode)
           for d in drawn):  # fmt: skip
        yield "glPolygonMode: edges are drawn with the diagonals of polygons"
    if any(draw.state.lighting.enabled and not draw.state.transform.normalize and _is_scaled(draw) for draw in drawn):
        yield "normals that are not of unit length are normalised, as with GL_NORMALIZE"


_FEATURES: dict[str, Callable[[Snapshot], bool]] = {
    "textures are left out: the material's colour stands for them": lambda s: s.texture.in_use,
    "fog is left out": lambda s: s.fog.enabled,
    "the stencil test is left out": lambda s: s.stencil.test,
    "the alpha test is left out": lambda s: s.color_buffer.alpha_test,
    "clip planes are left out": lambda s: any(s.transform.clip_enabled),
    "what is drawn without depth test is drawn with it": lambda s: not s.depth.test,
    "blending other than (GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA) is left out":
        lambda s: s.color_buffer.blend and s.color_buffer.blend_function[:2] != OVER,
    "affine interpolation is left out": lambda s: s.hints.perspective_correction == gl.GL_AFFINE_GLSIM,
    "lines are one pixel wide": lambda s: s.line.width != 1.0,
}  # fmt: skip


def _is_scaled(draw: Draw) -> bool:
    """Whether any normal of a Draw has another length than 1 in eye space."""
    numbers = np.arange(draw.first, draw.first + draw.count, dtype=np.uint32)
    if draw.indices is not None:
        numbers = draw.indices + np.uint32(draw.first)
    length = np.linalg.norm(vertex_stage(draw, numbers, 0, colors=False).normal, axis=1)
    return bool((np.abs(length - 1.0) > 0.01).any())
