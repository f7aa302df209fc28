"""Planning: which Draws are sent to the GPU together.

Neighbouring Draws that make the same kind of primitive under the same state differ only in matrices and materials.
Those become rows of two buffers, each vertex carries the number of its row, and the Draws become one.  Draws of the
same display list become instances of one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import PLAIN, SEPARATE, complete, corners, primitives
from glsim.machine.frame import Draw, Matrices, Vertices
from glsim.machine.state import Color, Material, Snapshot

Uint32 = NDArray[np.uint32]

# Draws with more vertices than this are not merged with others: reading a row for each vertex would cost more than
# the call it saves.
MERGE_BELOW = 4096

# Rows of transforms and materials that one program has room for; a device may have room for less.
MOST_OBJECTS = 256


class Object:
    """What the Draws of one batch may differ in: it fills one row of the uniform blocks Transforms and Materials."""

    __slots__ = ("color", "material", "matrices")

    def __init__(self, matrices: Matrices, material: Material, color: Color | None) -> None:
        self.matrices, self.material, self.color = matrices, material, color

    def same(self, other: Object) -> bool:
        """Whether both are made of the very same matrices, material and colour, so that one row can serve for both."""
        a, b = self.matrices, other.matrices
        same = a[0] is b[0] and a[1] is b[1] and a[2] is b[2]
        return same and self.material is other.material and self.color is other.color


@dataclass
class Batch:
    """Draws that become one call.

    base, objects: the first row in Transforms and Materials, and the number of rows; start, count: the first index in
    Plan.indices, and the number of indices.  corners: of each primitive.
    """

    state: Snapshot
    corners: int
    vertices: Vertices
    base: int
    objects: int
    draws: list[Draw]
    start: int = 0
    count: int = 0


@dataclass
class Plan:
    """Consecutive batches over one block of vertices.

    rows: for each vertex the number of its object in its batch, (vertices,), or empty if all are 0.  indices: of all
    batches, one after the other.  instances: whether each batch draws all its indices once for every object.
    """

    vertices: Vertices
    batches: list[Batch] = field(default_factory=list)
    rows: Uint32 = field(default_factory=lambda: np.empty(0, np.uint32))
    indices: Uint32 = field(default_factory=lambda: np.empty(0, np.uint32))
    instances: bool = False

    def several(self, batch: Batch) -> bool:
        """Whether the vertices of a batch say which object they belong to."""
        return batch.objects > 1 and (self.instances or len(self.rows) > 0)


def plans(draws: Sequence[Draw], limit: int) -> tuple[list[Object], list[Plan]]:
    """The objects that ``draws`` use, and the plans in whose order they are drawn.

    No batch has more than ``limit`` objects.
    """
    objects: list[Object] = []
    result = []
    for _, group in groupby(draws, key=_grouping):
        members = list(group)
        if members[0].block.static:
            result.append(_instances(members, limit, objects))
            continue
        parts = members
        if members[0].block.materials:
            parts = [part for draw in members for part in separate(draw, limit)]
        result += [plan(list(same), limit, objects) for _, same in groupby(parts, key=lambda draw: id(draw.vertices))]
    return objects, result


def _grouping(draw: Draw) -> tuple[int, ...]:
    """Return a key: neighbouring Draws with equal keys are planned together.

    They share one block of vertices, and if this is static, also the indices, the mode and the range of vertices.
    """
    if not draw.block.static:
        return (id(draw.vertices),)
    return (id(draw.vertices), id(draw.indices), draw.mode, draw.first, draw.count)


def _instances(draws: list[Draw], limit: int, objects: list[Object]) -> Plan:
    """Plan Draws of the same part of a display list: a batch draws its primitives as one instance for each object."""
    first = draws[0]
    indices = _assembled(first, first.first, first.count, keep=True)
    result = Plan(first.block, indices=indices, instances=True)
    batch: Batch | None = None
    for draw in draws:
        if batch is None or batch.objects >= limit or not _alike(batch.draws[0], draw):
            batch = Batch(draw.state, corners(draw.mode), draw.block, len(objects), 0, [], 0, len(indices))
            result.batches.append(batch)
        batch.draws.append(draw)
        objects.append(Object(draw.matrices, draw.material, draw.color))
        batch.objects += 1
    return result


def _alike(a: Draw, b: Draw) -> bool:
    """Whether two Draws have the same state and the same texture matrices of units 1 to 3."""
    same = a.state is b.state or a.state == b.state
    return same and a.matrices[3:] == b.matrices[3:]


def plan(draws: Sequence[Draw], limit: int, objects: list[Object]) -> Plan:
    """Group ``draws``, which share one Vertices, and append their objects (see ``separate``)."""
    result = Plan(draws[0].block)
    spans: list[tuple[int, int, int]] = []  # first vertex, end, object relative to the batch
    batch: Batch | None = None
    changing = bool(result.vertices.materials)
    for draw in draws:
        changes = draw.material_changes() if changing else []
        if batch is None or not _fits(batch, draw, len(changes), limit):
            batch = Batch(draw.state, corners(draw.mode), draw.block, len(objects), 0, [])
            result.batches.append(batch)
        batch.draws.append(draw)
        row = _row(objects, batch, Object(draw.matrices, draw.material, draw.color))
        first = draw.first
        known = {draw.material: row} if changes else {}
        for vertex, material in changes:
            spans.append((first, vertex, row))
            if material not in known:
                known[material] = _row(objects, batch, Object(draw.matrices, material, draw.color))
            first, row = vertex, known[material]
        spans.append((first, draw.first + draw.count, row))
    chunks = [_indices(batch) for batch in result.batches]
    start = 0
    for batch, chunk in zip(result.batches, chunks, strict=True):
        batch.start, batch.count = start, len(chunk)
        start += len(chunk)
    result.indices = np.concatenate(chunks)
    result.rows = _rows(spans, len(result.vertices.rows))
    return result


def _fits(batch: Batch, draw: Draw, changes: int, limit: int) -> bool:
    """Whether ``draw`` can join the batch."""
    return (
        draw.count <= MERGE_BELOW
        and batch.draws[-1].count <= MERGE_BELOW
        and batch.objects + changes < limit
        and batch.corners == corners(draw.mode)
        and _alike(batch.draws[-1], draw)
        and (batch.draws[-1].color is None) == (draw.color is None)
    )


def _row(objects: list[Object], batch: Batch, thing: Object) -> int:
    """The row of an object in the batch: a new one, unless the last object is the same."""
    if not batch.objects or not objects[-1].same(thing):
        objects.append(thing)
        batch.objects += 1
    return batch.objects - 1


def separate(draw: Draw, limit: int) -> list[Draw]:
    """``draw`` itself, or the same primitives as several Draws if it uses more than ``limit`` materials."""
    changes = draw.material_changes()
    if len(changes) < limit or len({material for _, material in changes}) < limit:
        return [draw]
    size = corners(draw.mode)
    chosen = _assembled(draw, draw.first, draw.count)
    used = draw.materials_at(chosen)
    vertices = draw.block.take(chosen, list(enumerate(used)))
    step = (limit - 1) // size * size
    parts = []
    for first in range(0, len(chosen), step):
        count = min(step, len(chosen) - first)
        parts.append(Draw(PLAIN[size], first, count, None, draw.matrices, used[first], draw.state, vertices))
        parts[-1].call = draw.call
    return parts


def _rows(spans: list[tuple[int, int, int]], count: int) -> Uint32:
    """Spans (first vertex, end, row) -> the row of each of ``count`` vertices; empty if all are 0."""
    if not any(row for _, _, row in spans):
        return np.empty(0, np.uint32)
    rows = np.zeros(count, np.uint32)
    for first, end, row in spans:
        rows[first:end] = row
    return rows


def _indices(batch: Batch) -> Uint32:
    """The vertices of the batch's primitives, in order; runs of Draws that share no vertices are assembled at once."""
    parts: list[Uint32] = []
    draws = batch.draws
    k = 0
    while k < len(draws):
        draw = draws[k]
        first, end = draw.first, draw.first + draw.count
        k += 1
        if draw.mode in SEPARATE and draw.indices is None and complete(draw.mode, draw.count) == draw.count:
            while k < len(draws) and _continues(draws[k], draw.mode, end):
                end += draws[k].count
                k += 1
        parts.append(_assembled(draw, first, end - first))
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


def _continues(draw: Draw, mode: int, end: int) -> bool:
    """Whether a Draw begins at vertex ``end`` with whole primitives of the same kind."""
    whole = complete(mode, draw.count) == draw.count
    return draw.mode == mode and draw.indices is None and draw.first == end and whole


def assembled(draw: Draw) -> Uint32:
    """The vertices of a Draw's triangles, lines or points, as numbers in its block."""
    return _assembled(draw, draw.first, draw.count)


def _assembled(draw: Draw, first: int, count: int, keep: bool = False) -> Uint32:
    """The same for ``count`` vertices from ``first`` on.  keep: return the Draw's own array of indices, if no change is
    needed, so that the renderer recognizes the array that the GPU already has."""
    lighting = draw.state.lighting
    last = lighting.shade_model == gl.GL_FLAT or (lighting.enabled and lighting.two_side) or draw.indices is not None
    indices = draw.indices
    if indices is not None:
        count = len(indices)
        if keep and first == 0 and draw.mode == PLAIN[corners(draw.mode)] and complete(draw.mode, count) == count:
            return indices  # the very same array, by which the GPU's copy is found again
    return primitives(draw.mode, count, indices, last) + np.uint32(first)
