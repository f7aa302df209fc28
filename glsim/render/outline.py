"""What core profiles lack: wide and stippled lines, and polygons drawn as edges or points.

Such Draws are replaced by others over vertices of their own: wide lines by triangles, unfilled polygons by lines or
points, without the diagonals of quads and polygons, and only for the faces that are wanted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from glsim.machine.assembly import corners, counterclockwise, outlines
from glsim.machine.clipping import distances
from glsim.machine.constants import (
    GL_BACK,
    GL_CCW,
    GL_FILL,
    GL_FLAT,
    GL_FRONT,
    GL_FRONT_AND_BACK,
    GL_LINE,
    GL_LINE_LOOP,
    GL_LINE_STRIP,
    GL_LINES,
    GL_POINTS,
    GL_POLYGON,
    GL_QUADS,
    GL_TRIANGLES,
)
from glsim.machine.frame import Draw, Vertices
from glsim.machine.matrix import evaluate, multiply
from glsim.machine.state import Material, Snapshot
from glsim.render.batch import assembled

Float = NDArray[np.float32]


def prepare(draws: Iterable[Draw]) -> Iterator[Draw]:
    """The Draws as the core profile can draw them."""
    draws = list(draws)
    if not any(map(_need, draws)):
        yield from draws
        return
    for (need, _, _), group in groupby(draws, key=lambda draw: (_need(draw), id(draw.vertices), draw.state)):
        if need == "unfilled":
            yield from prepare(part for draw in group for part in unfilled(draw))
        elif need == "lines":
            yield from lines(list(group))
        else:
            yield from group


def _need(draw: Draw) -> str:
    kind = corners(draw.mode)
    state = draw.state
    if kind == 3 and (state.polygon.front_mode != GL_FILL or state.polygon.back_mode != GL_FILL):
        return "unfilled"
    if kind == 2 and (state.line.stipple or widened(state)) and "line_corner" not in draw.block.columns:
        return "lines"
    return ""


def line_width(state: Snapshot) -> float:
    """The width lines are drawn with: rounded, at least one pixel (section 3.4.2); a smooth line's is exact."""
    return state.line.width if state.line.smooth else max(float(np.floor(state.line.width + 0.5)), 1.0)


def widened(state: Snapshot) -> bool:
    """Whether lines are drawn as areas."""
    return state.line.smooth or line_width(state) > 1.0


def line_margin(state: Snapshot) -> int:
    """Pixels by which a wide line may reach beyond the viewport, for only its middle is clipped (section 2.11)."""
    return int(np.ceil(line_width(state) / 2.0)) + 1


def positions(block: Vertices, chosen: NDArray[np.uint32]) -> Float:
    """Homogeneous positions (n, 4) in object space."""
    w = block.columns.get("w")
    result = np.ones((len(chosen), 4), np.float32)
    result[:, :3] = block.rows[chosen, :3]
    if w is not None:
        result[:, 3] = w[chosen, 0]
    return result


def eye_and_clip(draw: Draw, chosen: NDArray[np.uint32]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions (n, 4) in eye space and in clip space."""
    evaluate(draw.matrices)
    modelview, projection = (matrix.get()[None] for matrix in draw.matrices[:2])
    P = positions(draw.block, chosen).astype(np.float64)
    return P @ modelview[0], np.asarray(P @ multiply(projection, modelview)[0].astype(np.float64))


def clip_positions(draw: Draw, chosen: NDArray[np.uint32]) -> NDArray[np.float64]:
    """Positions (n, 4) in clip space."""
    return eye_and_clip(draw, chosen)[1]


# ---------------------------------------------------------------- lines

ENDS = np.array([0, 0, 1, 1])  # of a wide line's corners
CORNERS = np.array([(-1, -1), (-1, 1), (1, -1), (1, 1)], np.float32)
TRIANGLES = np.array([0, 1, 2, 1, 3, 2], np.uint32)  # both end in the line's second vertex, the provoking one


def lines(draws: list[Draw]) -> list[Draw]:
    """Wide or stippled lines; the Draws share their vertices and their state."""
    block, state = draws[0].block, draws[0].state
    wide = widened(state)
    ends = [assembled(draw).reshape(-1, 2) for draw in draws]
    order = ENDS if wide else np.array([0, 1])
    chosen = np.concatenate(ends)[:, order].ravel()
    materials: list[tuple[int, Material]] = []
    result, first = [], 0
    vertices = block.take(chosen)
    for draw, pairs in zip(draws, ends, strict=True):
        count = pairs.size * (2 if wide else 1)
        if block.materials and draw.indices is None:
            used = draw.materials_at(chosen[first : first + count])
            materials += [(first + k, material) for k, material in enumerate(used)]
        part = Draw(GL_LINES, first, count, None, draw.matrices, draw.material, state, vertices)
        if wide:
            part.indices = (np.arange(len(pairs), dtype=np.uint32)[:, None] * 4 + TRIANGLES).ravel()
        part.color = draw.color
        result.append(part)
        first += count
    others = np.concatenate(ends)[:, 1 - order].ravel()
    vertices.columns["other_end"] = positions(block, others)
    vertices.columns["line_corner"] = np.tile(CORNERS if wide else CORNERS[[0, 2]], (len(chosen) // len(order), 1))
    if state.line.stipple:
        begins = [_begins(draw, pairs) for draw, pairs in zip(draws, ends, strict=True)]
        vertices.columns["line_begin"] = np.repeat(np.concatenate(begins), len(order))[:, None]
    vertices.materials = materials
    return result


def _begins(draw: Draw, pairs: NDArray[np.uint32]) -> Float:
    """How many pixels of the stipple pattern come before each line (n, 2): (n,).

    A strip or loop goes on where its last line ended; separate lines begin anew (section 3.4.2).
    """
    begins = np.zeros(len(pairs), np.float32)
    if draw.mode in (GL_LINE_STRIP, GL_LINE_LOOP) and len(pairs):
        begins[1:] = np.floor(np.cumsum(_visible_lengths(draw, pairs)))[:-1]
    return begins


def _visible_lengths(draw: Draw, pairs: NDArray[np.uint32]) -> NDArray[np.float64]:
    """Pixels of what clipping leaves of each line: smooth ones are measured along, others in their longer coordinate."""
    eye, clip = eye_and_clip(draw, pairs.ravel())
    planes = distances(clip, eye, draw.state.transform).reshape(*pairs.shape, -1)
    a, b = planes[:, 0], planes[:, 1]
    clip = clip.reshape(-1, 2, 4)
    with np.errstate(all="ignore"):
        at = a / (a - b)
        enters = np.where((a < 0.0) & (b >= 0.0), at, 0.0).max(axis=1)
        leaves = np.where((a >= 0.0) & (b < 0.0), at, 1.0).min(axis=1)
        part = np.stack([enters, leaves], axis=1)[..., None]
        left = clip[:, :1] + part * (clip[:, 1:] - clip[:, :1])
        way = np.diff(left[..., :2] / left[..., 3:], axis=1)[:, 0] * (np.array(draw.state.viewport[2:4]) / 2)
    lengths = np.linalg.norm(way, axis=1) if draw.state.line.smooth else np.abs(way).max(axis=1)
    lengths[(enters > leaves) | ((a < 0.0) & (b < 0.0)).any(axis=1)] = 0.0
    return np.nan_to_num(lengths, posinf=0.0)


# ---------------------------------------------------------------- unfilled polygons


def unfilled(draw: Draw) -> Iterator[Draw]:
    """The polygons of a Draw, each in the mode of the face it shows."""
    count = draw.count if draw.indices is None else len(draw.indices)
    loops, provoking = outlines(draw.mode, count)
    if not len(loops):
        return
    numbers = (np.arange(count, dtype=np.uint32) if draw.indices is None else draw.indices) + np.uint32(draw.first)
    rings, provoking = numbers[loops], numbers[provoking]
    front = facing(draw, rings)
    polygon = draw.state.polygon
    for first, end in _runs(draw.state, front):
        is_front = bool(front[first])
        culled = polygon.cull and polygon.cull_face in (GL_FRONT_AND_BACK, GL_FRONT if is_front else GL_BACK)
        mode = polygon.front_mode if is_front else polygon.back_mode
        kept = slice(first, end)
        if not culled:
            yield _face(draw, rings[kept], provoking[kept], mode, is_front)


def _runs(state: Snapshot, front: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """Neighbouring polygons that are drawn alike, in their order: of one facing, or all if it makes no difference."""
    polygon, lighting = state.polygon, state.lighting
    if polygon.front_mode == polygon.back_mode and not polygon.cull and not (lighting.enabled and lighting.two_side):
        yield 0, len(front)
        return
    turns = (np.flatnonzero(np.diff(front)) + 1).tolist()
    yield from zip([0, *turns], [*turns, len(front)], strict=True)


def facing(draw: Draw, rings: NDArray[np.uint32]) -> NDArray[np.bool_]:
    """Which polygons (n, k) show their front."""
    clip = clip_positions(draw, rings.ravel()).reshape(*rings.shape, 4)
    return np.equal(counterclockwise(clip), draw.state.polygon.front_face == GL_CCW)


def _face(draw: Draw, rings: NDArray[np.uint32], provoking: NDArray[np.uint32], mode: int, front: bool) -> Draw:
    """Polygons of one facing as filled areas, edges or points."""
    state = draw.state._replace(polygon=draw.state.polygon._replace(front_mode=GL_FILL, back_mode=GL_FILL, cull=False))
    if mode == GL_FILL:
        if draw.mode == GL_POLYGON:
            return _part(draw, GL_POLYGON, rings.ravel(), None, state, True)
        if rings.shape[1] == 4:  # cut as Mesa does where some polygons of a Draw are not filled
            rings = rings[:, [0, 1, 3, 1, 2, 3]]
        return _part(draw, GL_TRIANGLES, rings.ravel(), None, state, True)
    flags = np.ones(rings.shape, bool)
    if draw.mode in (GL_TRIANGLES, GL_QUADS, GL_POLYGON) and draw.block.varies("edge_flag"):
        flags = draw.block.column("edge_flag")[rings, 0] != 0.0
    offsets = _depth_offsets(draw, rings, mode)
    each = np.broadcast_to(np.arange(len(rings))[:, None], rings.shape)[flags]  # the polygon of each edge or corner
    if mode == GL_LINE:
        chosen = np.stack([rings, np.roll(rings, -1, axis=1)], axis=2)[flags].ravel()
        each = np.repeat(each, 2)
        part = _part(draw, GL_LINES, chosen, provoking[each], state, front)
    else:
        part = _part(draw, GL_POINTS, rings[flags], provoking[each], state, front)
    if offsets is not None:
        part.block.columns["depth_offset"] = offsets[each, None]
    return part


def _depth_offsets(draw: Draw, rings: NDArray[np.uint32], mode: int) -> Float | None:
    """glPolygonOffset for polygons (n, k) drawn as lines or points: m factor + r units in window depth (section 3.5.5).

    m: the steepest slope of the polygon's plane; r: the smallest difference that 24 bits of depth resolve.
    """
    polygon = draw.state.polygon
    if not (polygon.offset_line if mode == GL_LINE else polygon.offset_point):
        return None
    viewport = draw.state.viewport
    clip = clip_positions(draw, rings.ravel()).reshape(*rings.shape, 4)
    with np.errstate(all="ignore"):
        scale = np.array([viewport.width, viewport.height, viewport.far - viewport.near]) / 2
        corners = clip[..., :3] / clip[..., 3:] * scale
        corners = corners - corners[:, :1]
        normal = np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1)  # Newell's, for any number of corners
        slope = np.abs(normal[:, :2]).max(axis=1) / np.abs(normal[:, 2])
    slope = np.nan_to_num(slope, nan=0.0, posinf=0.0)
    return np.asarray(polygon.offset_factor * slope + polygon.offset_units * 2.0**-24, np.float32)


def _part(
    draw: Draw,
    mode: int,
    chosen: NDArray[np.uint32],
    provoking: NDArray[np.uint32] | None,
    state: Snapshot,
    front: bool,
) -> Draw:
    """A Draw of some of the vertices.  provoking: whose colour and normal they take under flat shading."""
    block = draw.block
    vertices = block.take(chosen)
    flat = state.lighting.shade_model == GL_FLAT and provoking is not None
    source = provoking if flat and provoking is not None else chosen
    if flat:
        vertices.rows[:, 3:] = block.rows[source, 3:]
    material = draw.material
    if block.materials and draw.indices is None:
        vertices.materials = list(enumerate(draw.materials_at(source)))
    if not front and state.lighting.enabled and state.lighting.two_side:  # lines and points have no back: turn it round
        vertices.rows[:, 3:6] *= -1
        material = Material(material.back, material.back)
        vertices.materials = [(k, Material(m.back, m.back)) for k, m in vertices.materials]
        face = state.lighting.color_material_face
        if state.lighting.color_material and face == GL_FRONT:
            state = state._replace(lighting=state.lighting._replace(color_material=False))
        elif state.lighting.color_material:
            state = state._replace(lighting=state.lighting._replace(color_material_face=GL_FRONT_AND_BACK))
    part = Draw(mode, 0, len(chosen), None, draw.matrices, material, state, vertices)
    part.color = draw.color
    return part
