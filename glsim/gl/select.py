"""Selection and feedback: sections 5.2 and 5.3 of the specification.

In these modes nothing is drawn.  The CPU transforms, lights and clips the primitives.  Selection records the smallest
and the largest depth of the primitives that are not clipped away; feedback writes their vertices into a buffer.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import corners, counterclockwise, outlines, primitives
from glsim.machine.clipping import BOUNDARY, INTERIOR, VIEW_PLANES, clipped, edge_kinds
from glsim.machine.clipping import distances as clip_distances
from glsim.machine.errors import (
    invalid_enum,
    invalid_operation,
    invalid_value,
    out_of_memory,
    stack_overflow,
    stack_underflow,
)
from glsim.machine.frame import Draw, Packet, Pixels
from glsim.machine.machine import Machine
from glsim.machine.stage import vertex_stage, window
from glsim.machine.state import RasterPosition

Float = NDArray[np.float64]
MAX_NAME_STACK_DEPTH = 64
LARGEST_BUFFER = 1 << 26  # numbers
LARGEST_DEPTH = 4294967295  # depths in hit records are multiplied by 2^32 - 1


class SelectRecord(NamedTuple):
    """One hit, as PyOpenGL returns it: nearest and farthest depth in [0, 1], and the names on the stack."""

    near: float
    far: float
    names: list[int]


class FeedbackVertex(NamedTuple):
    """A vertex of feedback, as PyOpenGL returns it; what the type of feedback lacks is None."""

    vertex: NDArray[np.float32]
    color: NDArray[np.float32] | None = None
    texture: NDArray[np.float32] | None = None


@dataclass
class Selection:
    """Buffer of glSelectBuffer, the name stack, and the hit that is being noted.  length: of what was written."""

    buffer: NDArray[np.uint32]
    names: list[int] = field(default_factory=list)
    depths: tuple[float, float] | None = None
    length: int = 0
    records: int = 0
    overflow: bool = False

    def note(self, near: float, far: float) -> None:
        old = self.depths or (near, far)
        self.depths = min(near, old[0]), max(far, old[1])

    def close(self) -> None:
        """Write a hit record if there was a hit.  It is called before each change of the name stack."""
        if self.depths is None:
            return
        near, far = (round(min(max(depth, 0.0), 1.0) * LARGEST_DEPTH) for depth in self.depths)
        record = [len(self.names), near, far, *self.names]
        room = record[: max(len(self.buffer) - self.length, 0)]
        self.buffer[self.length : self.length + len(room)] = room
        self.overflow |= len(room) < len(record)
        self.length += len(record)
        self.records += 1
        self.depths = None

    def parse(self) -> list[SelectRecord]:
        hits, start = [], 0
        for _ in range(self.records):
            count, near, far = (int(value) for value in self.buffer[start : start + 3])
            names = self.buffer[start + 3 : start + 3 + count].tolist()
            hits.append(SelectRecord(near / LARGEST_DEPTH, far / LARGEST_DEPTH, names))
            start += 3 + count
        return hits


@dataclass
class Feedback:
    """Buffer of glFeedbackBuffer and what was written into it.  length: of all that came, also without room."""

    buffer: NDArray[np.float32]
    type: int
    length: int = 0
    records: list[tuple[Any, ...]] = field(default_factory=list)

    def write(self, token: int, *vertices: Float, count: bool = False) -> None:
        """A token and its vertices, rows of x y z w, colour, texture coordinates."""
        values = [float(token), *([float(len(vertices))] if count else [])]
        parts = [self._parts(vertex) for vertex in vertices]
        for part in parts:
            values += [float(v) for piece in part if piece is not None for v in piece]
        self._append(values)
        self.records.append((token, *(FeedbackVertex(*part) for part in parts)))

    def pass_through(self, token: float) -> None:
        self._append([float(gl.GL_PASS_THROUGH_TOKEN), token])
        self.records.append((gl.GL_PASS_THROUGH_TOKEN, token))

    def _append(self, values: list[float]) -> None:
        room = values[: max(len(self.buffer) - self.length, 0)]
        self.buffer[self.length : self.length + len(room)] = room
        self.length += len(values)

    def _parts(self, vertex: Float) -> tuple[Any, Any, Any]:
        row = vertex.astype(np.float32)
        size = {gl.GL_2D: 2, gl.GL_4D_COLOR_TEXTURE: 4}.get(self.type, 3)  # type: ignore[call-overload]
        color = row[4:8] if self.type not in (gl.GL_2D, gl.GL_3D) else None
        texture = row[8:12] if self.type in (gl.GL_3D_COLOR_TEXTURE, gl.GL_4D_COLOR_TEXTURE) else None
        return row[:size], color, texture


# ---------------------------------------------------------------- commands


def glSelectBuffer(m: Machine, size: int, buffer: Any = None) -> Any:
    """Make, or use, the array of uint32 that hit records are written into; it is returned."""
    if m.rendering.mode != gl.GL_RENDER:
        raise invalid_operation("not allowed in selection or feedback mode")
    m.rendering.selection = Selection(_buffer(size, buffer, np.uint32))
    return m.rendering.selection.buffer


def _buffer(size: int, buffer: Any, dtype: type) -> Any:
    if size < 0:
        raise invalid_value("size", size, "at least 0")
    if size > LARGEST_BUFFER:
        raise out_of_memory(f"a buffer of {size} numbers is more than there is room for")
    if buffer is None:
        return np.zeros(int(size), dtype)
    array = np.asarray(buffer)
    if array is not buffer or array.dtype.itemsize != 4 or array.size < size:
        raise TypeError(f"buffer must be an array of {size} numbers of type {np.dtype(dtype)}")
    return array.reshape(-1)


FEEDBACK_TYPES = (gl.GL_2D, gl.GL_3D, gl.GL_3D_COLOR, gl.GL_3D_COLOR_TEXTURE, gl.GL_4D_COLOR_TEXTURE)


def glFeedbackBuffer(m: Machine, size: int, type: int, buffer: Any = None) -> Any:
    """Make, or use, the array of float32 that feedback is written into; it is returned."""
    if m.rendering.mode != gl.GL_RENDER:
        raise invalid_operation("not allowed in selection or feedback mode")
    if type not in FEEDBACK_TYPES:
        raise invalid_enum("type", type, "GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE or GL_4D_COLOR_TEXTURE")
    m.rendering.feedback = Feedback(_buffer(size, buffer, np.float32), type)
    return m.rendering.feedback.buffer


def glRenderMode(m: Machine, mode: int) -> Any:
    """Begin GL_SELECT or GL_FEEDBACK, or end it.  As PyOpenGL, ending returns a list: SelectRecord for each hit, or
    (token, FeedbackVertex, ...) for each primitive.  Raises GL_STACK_OVERFLOW if the buffer was too small."""
    if mode not in (gl.GL_RENDER, gl.GL_SELECT, gl.GL_FEEDBACK):
        raise invalid_enum("mode", mode, "GL_RENDER, GL_SELECT or GL_FEEDBACK")
    if (mode == gl.GL_SELECT and m.rendering.selection is None) or (
        mode == gl.GL_FEEDBACK and m.rendering.feedback is None
    ):
        name = "glSelectBuffer" if mode == gl.GL_SELECT else "glFeedbackBuffer"
        raise invalid_operation(f"call {name} first, so that there is room for what is found")
    m.flush()
    before, result = m.rendering.mode, 0
    if before == gl.GL_SELECT:
        m.rendering.selection.close()
    selection, feedback = m.rendering.selection, m.rendering.feedback
    _enter(m, mode)
    if before == gl.GL_SELECT:
        if selection.overflow:
            raise stack_overflow(f"the buffer of glSelectBuffer holds {len(selection.buffer)} numbers: too few")
        return selection.parse()
    if before == gl.GL_FEEDBACK:
        if feedback.length > len(feedback.buffer):
            raise stack_overflow(f"the buffer of glFeedbackBuffer holds {len(feedback.buffer)} numbers: too few")
        return feedback.records
    return result


def _enter(m: Machine, mode: int) -> None:
    """Begin a render mode: what is flushed from now on goes to a new Selection or Feedback, or to the device."""
    m.rendering.mode, m.outlet.collector = mode, None
    if mode == gl.GL_SELECT:
        selection = m.rendering.selection = Selection(m.rendering.selection.buffer)

        def select_all(packets: list[Packet]) -> None:
            for draw in packets:
                if isinstance(draw, Draw):
                    select(selection, draw)

        m.outlet.collector = select_all
    elif mode == gl.GL_FEEDBACK:
        feedback = m.rendering.feedback = Feedback(m.rendering.feedback.buffer, m.rendering.feedback.type)

        def feed_all_back(packets: list[Packet]) -> None:
            for packet in packets:
                feed_back(feedback, packet)

        m.outlet.collector = feed_all_back


def _selecting(m: Machine) -> Selection | None:
    """The selection in selection mode, with its hit record closed: the name stack is about to change."""
    if m.rendering.mode != gl.GL_SELECT:
        return None
    m.flush()
    selection: Selection = m.rendering.selection
    selection.close()
    return selection


def glInitNames(m: Machine) -> None:
    selection = _selecting(m)
    if selection is not None:
        selection.names = []


def glPushName(m: Machine, name: int) -> None:
    selection = _selecting(m)
    if selection is not None:
        if len(selection.names) >= MAX_NAME_STACK_DEPTH:
            raise stack_overflow(f"the name stack holds {MAX_NAME_STACK_DEPTH} names and is full: glPopName missing?")
        selection.names.append(int(name) & 0xFFFFFFFF)


def glPopName(m: Machine) -> None:
    selection = _selecting(m)
    if selection is not None:
        if not selection.names:
            raise stack_underflow("the name stack is empty: more glPopName than glPushName")
        selection.names.pop()


def glLoadName(m: Machine, name: int) -> None:
    if m.rendering.mode == gl.GL_SELECT and not m.rendering.selection.names:
        raise invalid_operation("the name stack is empty: call glPushName first")
    selection = _selecting(m)
    if selection is not None:
        selection.names[-1] = int(name) & 0xFFFFFFFF


def glPassThrough(m: Machine, token: float) -> None:
    if m.rendering.mode == gl.GL_FEEDBACK:
        m.flush()
        m.rendering.feedback.pass_through(float(token))


def raster_hit(m: Machine) -> None:
    """A valid raster position is a hit in selection mode."""
    if m.rendering.mode == gl.GL_SELECT:
        m.flush()
        m.rendering.selection.note(m.raster.z, m.raster.z)


# ---------------------------------------------------------------- primitives


class Primitive(NamedTuple):
    """A primitive after clipping.  corners: 1 for a point, 2 for a line, 3 for a polygon.

    rows: (k, 12), for each vertex clip coordinates, colour and texture coordinates.
    """

    corners: int
    rows: Float
    reset: bool  # a line that begins a stipple pattern anew


def _shapes(draw: Draw) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
    """Vertex numbers of the primitives (n, k), and of their provoking vertices (n,)."""
    count = draw.count if draw.indices is None else len(draw.indices)
    kind = corners(draw.mode)
    if kind == 3:
        shapes, provoking = outlines(draw.mode, count)
    else:
        shapes = primitives(draw.mode, count, None, last=True).reshape(-1, kind)
        provoking = shapes[:, -1]
    numbers = (np.arange(count, dtype=np.uint32) if draw.indices is None else draw.indices) + np.uint32(draw.first)
    return numbers[shapes], numbers[provoking]


def _culled(draw: Draw, front: bool) -> bool:
    polygon = draw.state.polygon
    return polygon.cull and polygon.cull_face not in (gl.GL_BACK if front else gl.GL_FRONT,)


def _left(rows: Float, distances: Float, kind: int) -> Float:
    """The rows of one primitive after clipping.  kind: 1 for a point, 2 for a line, 3 for a polygon."""
    return clipped(rows, distances, np.full(len(rows), BOUNDARY) if kind == 3 else None).rows


# ---------------------------------------------------------------- selection


def select(selection: Selection, draw: Draw) -> None:
    """Note the depths of those primitives of a Draw that are in the clip volume."""
    shapes, _ = _shapes(draw)
    if not len(shapes):
        return
    chosen, places = np.unique(shapes, return_inverse=True)
    stage = vertex_stage(draw, chosen.astype(np.uint32), 0, colors=False)
    distances = clip_distances(stage.clip, stage.eye, draw.state.transform)
    places = places.reshape(shapes.shape)
    outside = np.less(distances[places], 0.0)  # (primitives, corners, planes)
    whole: NDArray[np.bool_] = np.logical_not(np.any(outside, axis=(1, 2)))
    partly: NDArray[np.bool_] = np.logical_not(np.any(np.all(outside, axis=1), axis=1)) & ~whole
    depth = window(stage.clip, draw.state.viewport)[:, 2]
    kind = corners(draw.mode)
    if kind == 3 and draw.state.polygon.cull:
        front = np.equal(counterclockwise(stage.clip[places]), draw.state.polygon.front_face == gl.GL_CCW)
        culled = np.where(front, _culled(draw, True), _culled(draw, False))
        whole, partly = whole & ~culled, partly & ~culled
    if whole.any():
        seen = depth[places[whole]]
        selection.note(float(seen.min()), float(seen.max()))
    for k in np.flatnonzero(partly):
        left = _left(stage.clip[places[k]], distances[places[k]], kind)
        if len(left):
            seen = window(left, draw.state.viewport)[:, 2]
            selection.note(float(seen.min()), float(seen.max()))


# ---------------------------------------------------------------- feedback


def feed_back(feedback: Feedback, packet: Packet) -> None:
    if isinstance(packet, Pixels):
        tokens = {"bitmap": gl.GL_BITMAP_TOKEN}
        token = gl.GL_COPY_PIXEL_TOKEN if packet.copied else tokens.get(packet.kind, gl.GL_DRAW_PIXEL_TOKEN)
        feedback.write(token, _raster_row(packet.raster))
    elif isinstance(packet, Draw):
        for primitive in _primitives(packet):
            rows = primitive.rows.copy()
            rows[:, :4] = window(rows[:, :4], packet.state.viewport)
            if primitive.corners == 1:
                feedback.write(gl.GL_POINT_TOKEN, *rows)
            elif primitive.corners == 2:
                feedback.write(gl.GL_LINE_RESET_TOKEN if primitive.reset else gl.GL_LINE_TOKEN, *rows)
            else:
                feedback.write(gl.GL_POLYGON_TOKEN, *rows, count=True)


def _raster_row(raster: RasterPosition) -> Float:
    return np.array([raster.x, raster.y, raster.z, raster.w, *raster.color, *raster.texcoords[0]])


def _primitives(draw: Draw) -> Iterator[Primitive]:
    """What clipping leaves of a Draw, in its order; polygons as glPolygonMode says."""
    shapes, provoking = _shapes(draw)
    if not len(shapes):
        return
    chosen, places = np.unique(np.concatenate([shapes.ravel(), provoking]), return_inverse=True)
    stage = vertex_stage(draw, chosen.astype(np.uint32), 1)
    distances = clip_distances(stage.clip, stage.eye, draw.state.transform)
    kind, polygon = corners(draw.mode), draw.state.polygon
    flat = draw.state.lighting.shade_model == gl.GL_FLAT
    fronts = np.ones(len(shapes), bool)
    edges = edge_kinds(draw, shapes) if kind == 3 else shapes
    rings, last = places[: shapes.size].reshape(shapes.shape), places[shapes.size :]
    if kind == 3:
        fronts = np.equal(counterclockwise(stage.clip[rings]), polygon.front_face == gl.GL_CCW)
    for number, (ring, provoker) in enumerate(zip(rings, last, strict=True)):
        front = bool(fronts[number])
        if kind == 3 and _culled(draw, front):
            continue
        colors = stage.front if front else stage.back
        color = np.repeat(colors[[provoker]], len(ring), axis=0) if flat else colors[ring]
        rows = np.concatenate([stage.clip[ring], color, stage.texcoords[0][ring]], axis=1)
        mode = polygon.front_mode if front else polygon.back_mode
        reset = draw.mode == gl.GL_LINES or number == 0
        if kind != 3 or mode == gl.GL_FILL:
            left = _left(rows, distances[ring], kind)
            if len(left) >= kind:
                yield Primitive(kind, left, reset)
            continue
        outline = clipped(rows, distances[ring], edges[number], VIEW_PLANES)
        for n, k in enumerate(np.flatnonzero(outline.edges != INTERIOR)):
            ends = [k] if mode == gl.GL_POINT else [k, (k + 1) % len(outline.rows)]
            yield Primitive(len(ends), outline.rows[ends], reset and n == 0)
