"""What core profiles lack: wide and stippled lines, and polygons drawn as edges or points.

Such Draws are replaced by others over vertices of their own: wide lines by triangles, unfilled polygons by lines or
points, without the diagonals of quads and polygons, only for the faces that are wanted, and with the edges and corners
that clipping makes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import corners, counterclockwise, outlines
from glsim.machine.clipping import BOUNDARY, INTERIOR, INTRODUCED, VIEW_PLANES, clipped, distances, edge_kinds
from glsim.machine.frame import Draw, Vertices
from glsim.machine.stage import vertex_stage
from glsim.machine.state import Hints, Lighting, Material, Snapshot
from glsim.render.lines import clip_positions, eye_and_clip, lines, positions, widened

Float = NDArray[np.float32]


def prepare(draws: Iterable[Draw]) -> Iterator[Draw]:
    """The same picture as Draws that the core profile can draw: the Draws themselves where it can, else others."""
    draws = list(draws)
    if not any(map(_need, draws)):
        yield from draws
        return
    for (need, _, _), group in groupby(draws, key=lambda draw: (_need(draw), id(draw.vertices), draw.state)):
        if need == "hyperbolic":
            yield from prepare(draw.with_state(draw.state._replace(hints=Hints())) for draw in group)
        elif need == "unfilled":
            yield from prepare(part for draw in group for part in unfilled(draw))
        elif need == "lines":
            yield from lines(list(group))
        else:
            yield from group


def _behind_the_eye(draw: Draw) -> bool:
    """Whether a vertex has no place on the screen, so that nothing can be linear between it and others there."""
    count = draw.count if draw.indices is None else len(draw.indices)
    numbers = np.arange(count, dtype=np.uint32) if draw.indices is None else draw.indices
    return bool((clip_positions(draw, numbers + np.uint32(draw.first))[:, 3] <= 0.0).any())


def _need(draw: Draw) -> str:
    """Why it cannot be drawn as it is: its polygons are "unfilled", its "lines" are wide, or affine interpolation is
    asked for where only a "hyperbolic" one is possible; "" if it can."""
    kind = corners(draw.mode)
    state = draw.state
    if state.hints.perspective_correction == gl.GL_AFFINE_GLSIM and _behind_the_eye(draw):
        return "hyperbolic"
    if kind == 3 and (state.polygon.front_mode != gl.GL_FILL or state.polygon.back_mode != gl.GL_FILL):
        return "unfilled"
    if kind == 2 and (state.line.stipple or widened(state)) and "line_corner" not in draw.block.columns:
        return "lines"
    return ""


# ---------------------------------------------------------------- unfilled polygons


def unfilled(draw: Draw) -> Iterator[Draw]:
    """The polygons of a Draw, each in the mode of the face it shows."""
    count = draw.count if draw.indices is None else len(draw.indices)
    loops, provoking = outlines(draw.mode, count)
    if not len(loops):
        return
    numbers = (np.arange(count, dtype=np.uint32) if draw.indices is None else draw.indices) + np.uint32(draw.first)
    polygons, provoking = numbers[loops], numbers[provoking]
    front = facing(draw, polygons)
    modes = draw.state.polygon
    for first, end in _runs(draw.state, front):
        is_front = bool(front[first])
        culled = modes.cull and modes.cull_face in (gl.GL_FRONT_AND_BACK, gl.GL_FRONT if is_front else gl.GL_BACK)
        mode = modes.front_mode if is_front else modes.back_mode
        if not culled:
            yield from _face(draw, polygons[first:end], provoking[first:end], mode, is_front)


def _runs(state: Snapshot, front: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """Runs (first, end) of polygons that are drawn alike: all front or all back; one run if both are drawn alike."""
    polygon, lighting = state.polygon, state.lighting
    if polygon.front_mode == polygon.back_mode and not polygon.cull and not (lighting.enabled and lighting.two_side):
        yield 0, len(front)
        return
    turns = (np.flatnonzero(np.diff(front)) + 1).tolist()
    yield from zip([0, *turns], [*turns, len(front)], strict=True)


def facing(draw: Draw, polygons: NDArray[np.uint32]) -> NDArray[np.bool_]:
    """Which polygons, given by the numbers of their vertices (n, k), show their front: (n,) bool."""
    clip = clip_positions(draw, polygons.ravel()).reshape(*polygons.shape, 4)
    return np.equal(counterclockwise(clip), draw.state.polygon.front_face == gl.GL_CCW)


def _face(
    draw: Draw, polygons: NDArray[np.uint32], provoking: NDArray[np.uint32], mode: int, front: bool
) -> Iterator[Draw]:
    """Polygons (n, k) that all show the same side, as filled areas, edges or points.

    provoking: the vertex of each polygon (n,) whose colour it has under flat shading.
    """
    state = draw.state._replace(
        polygon=draw.state.polygon._replace(front_mode=gl.GL_FILL, back_mode=gl.GL_FILL, cull=False)
    )
    if mode == gl.GL_FILL:
        if draw.mode == gl.GL_POLYGON:
            yield _part(draw, gl.GL_POLYGON, polygons.ravel(), None, state, True)
            return
        if polygons.shape[1] == 4:  # cut as Mesa does where some polygons of a Draw are not filled
            polygons = polygons[:, [0, 1, 3, 1, 2, 3]]
        yield _part(draw, gl.GL_TRIANGLES, polygons.ravel(), None, state, True)
        return
    edges = edge_kinds(draw, polygons)
    is_drawn = edges == BOUNDARY  # (n, k): edges that the program asked for, and the corners where they begin
    offsets = _depth_offsets(draw, polygons, mode)
    each = np.broadcast_to(np.arange(len(polygons))[:, None], polygons.shape)[
        is_drawn
    ]  # the polygon of each edge or corner
    if mode == gl.GL_LINE:
        chosen = np.stack([polygons, np.roll(polygons, -1, axis=1)], axis=2)[is_drawn].ravel()
        each = np.repeat(each, 2)
        part = _part(draw, gl.GL_LINES, chosen, provoking[each], state, front)
    else:
        part = _part(draw, gl.GL_POINTS, polygons[is_drawn], provoking[each], state, front)
    if offsets is not None:
        part.block.columns["depth_offset"] = offsets[each, None]
    yield part
    if mode == gl.GL_LINE and not any(state.transform.clip_enabled):
        return
    planes = _planes(draw, polygons, mode)
    outside = planes < 0.0
    cut = np.flatnonzero(np.any(outside, axis=(1, 2)) & ~np.any(np.all(outside, axis=1), axis=1))
    if len(cut):
        source = np.repeat(provoking[cut], polygons.shape[1])
        whole = _part(draw, gl.GL_POINTS, polygons[cut].ravel(), source, state, front)
        if offsets is not None:
            whole.block.columns["depth_offset"] = np.repeat(offsets[cut], polygons.shape[1])[:, None]
        yield _introduced(whole, planes[cut], edges[cut], mode)


def _planes(draw: Draw, polygons: NDArray[np.uint32], mode: int) -> NDArray[np.float64]:
    """Distances (n, k, p) of the corners of polygons from the planes that make edges, or corners that are drawn.

    The planes of the view volume are moved inwards a little, so that the GPU does not cut off the corners made there.
    """
    eye, clip = eye_and_clip(draw, polygons.ravel())
    planes = distances(clip, eye, draw.state.transform)
    planes[:, :VIEW_PLANES] -= 1e-5 * np.abs(clip[:, 3:])
    return planes.reshape(*polygons.shape, -1)[..., VIEW_PLANES if mode == gl.GL_LINE else 0 :]


def _introduced(whole: Draw, planes: NDArray[np.float64], edges: NDArray[np.int64], mode: int) -> Draw:
    """The edges or corners that clipping adds to polygons drawn as lines or points (section 2.11).

    An edge along a plane of glClipPlane is drawn.  An edge along the view volume is not, as in Mesa: otherwise every
    polygon that leaves the picture would draw a line along the picture's border.

    whole: all corners of the polygons, planes: see _planes; edges: the kind of the edge from each corner (n, k).
    """
    rows, columns, state = whole.block.rows.copy(), dict(whole.block.columns), whole.state
    lighting = Lighting(shade_model=gl.GL_SMOOTH)
    if state.lighting.enabled and state.lighting.shade_model == gl.GL_PHONG_WIN:
        lighting = state.lighting
    elif state.lighting.enabled:  # colours are interpolated, the equation is not evaluated again
        stage = vertex_stage(whole, np.arange(len(rows), dtype=np.uint32), 0)
        rows[:, 6:10] = stage.front
        columns["secondary_color"] = np.insert(stage.highlight, 3, 1.0, axis=1).astype(np.float32)
        state = state._replace(fog=state.fog._replace(color_sum=True))
    state = state._replace(lighting=lighting, transform=state.transform._replace(clip_enabled=(False,) * 6))
    varying = [name for name, values in columns.items() if len(values) == len(rows)]
    all_columns = [rows, *(columns[name] for name in varying)]
    polygons = np.concatenate(all_columns, axis=1).astype(np.float64).reshape(*edges.shape, -1)
    introduced = []
    for polygon, distances_of, kinds in zip(polygons, planes, edges, strict=True):
        left = clipped(polygon, distances_of, kinds, 0 if mode == gl.GL_LINE else VIEW_PLANES)
        at = np.flatnonzero(left.edges == INTRODUCED if mode == gl.GL_LINE else left.new & (left.edges != INTERIOR))
        if mode == gl.GL_LINE:
            at = np.stack([at, (at + 1) % max(len(left.rows), 1)], axis=1).ravel()
        introduced.append(left.rows[at])
    rows, *values = np.split(
        np.concatenate(introduced).astype(np.float32), np.cumsum([c.shape[1] for c in all_columns])[:-1], 1
    )
    block = Vertices(np.ascontiguousarray(rows), columns | dict(zip(varying, values, strict=True)), [])
    part = Draw(
        gl.GL_LINES if mode == gl.GL_LINE else gl.GL_POINTS,
        0,
        len(rows),
        None,
        whole.matrices,
        whole.material,
        state,
        block,
    )
    part.color = None if whole.state.lighting.enabled and not lighting.enabled else whole.color
    part.call = whole.call
    return part


def _depth_offsets(draw: Draw, polygons: NDArray[np.uint32], mode: int) -> Float | None:
    """glPolygonOffset for polygons (n, k) drawn as lines or points: m factor + r units in window depth (section 3.5.5).

    m: the steepest slope of the polygon's plane; r: the smallest difference that 24 bits of depth resolve.
    """
    polygon = draw.state.polygon
    if not (polygon.offset_line if mode == gl.GL_LINE else polygon.offset_point):
        return None
    viewport = draw.state.viewport
    clip = clip_positions(draw, polygons.ravel()).reshape(*polygons.shape, 4)
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
    flat = state.lighting.shade_model == gl.GL_FLAT and provoking is not None
    source = provoking if flat and provoking is not None else chosen
    if flat:
        vertices.rows[:, 3:] = block.rows[source, 3:]
        if block.varies("secondary_color"):
            vertices.columns["secondary_color"] = block.column("secondary_color")[source]
        if state.lighting.enabled:
            vertices.columns["lit_position"] = positions(block, source)
    material = draw.material
    if block.materials:
        vertices.materials = list(enumerate(draw.materials_at(source)))
    if not front and state.lighting.enabled and state.lighting.two_side:  # lines and points have no back: turn it round
        vertices.rows[:, 3:6] *= -1
        material = Material(material.back, material.back)
        vertices.materials = [(k, Material(m.back, m.back)) for k, m in vertices.materials]
        face = state.lighting.color_material_face
        if state.lighting.color_material and face == gl.GL_FRONT:
            state = state._replace(lighting=state.lighting._replace(color_material=False))
        elif state.lighting.color_material:
            state = state._replace(lighting=state.lighting._replace(color_material_face=gl.GL_FRONT_AND_BACK))
    part = Draw(mode, 0, len(chosen), None, draw.matrices, material, state, vertices)
    part.color, part.call = draw.color, draw.call
    return part
