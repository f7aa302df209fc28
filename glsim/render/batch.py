"""Planning: which Draws go to the GPU together.

Neighbouring Draws that make the same kind of primitive under the same state differ only in matrices and materials.
Those become rows of two buffers, each vertex carries the number of its row, and the Draws become one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from glsim.machine.assembly import SEPARATE, assemble, complete, corners
from glsim.machine.constants import GL_FLAT, GL_LINES, GL_POINTS, GL_TRIANGLES
from glsim.machine.frame import Draw, Vertices
from glsim.machine.matrix import Matrix
from glsim.machine.state import Material, Snapshot

Uint32 = NDArray[np.uint32]

# Draws with more vertices than this are not merged with others: reading a row for each vertex would cost more than
# the call it saves (tests/benchmarks/merge.py).
MERGE_BELOW = 4096

Object = tuple[tuple[Matrix, Matrix], Material]


@dataclass
class Batch:
    """Draws that become one call: ``objects`` rows from ``base``, ``count`` indices from ``start``."""

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
    """All batches of consecutive Draws over one block of vertices."""

    vertices: Vertices
    objects: list[Object] = field(default_factory=list)
    batches: list[Batch] = field(default_factory=list)
    rows: Uint32 = field(default_factory=lambda: np.empty(0, np.uint32))  # object of each vertex, relative to the batch
    indices: Uint32 = field(default_factory=lambda: np.empty(0, np.uint32))


def plan(draws: Sequence[Draw], limit: int) -> Plan:
    """Group ``draws``, which share one Vertices; no batch has more than ``limit`` objects (see ``separate``)."""
    result = Plan(draws[0].vertices)
    spans: list[tuple[int, int, int]] = []  # first vertex, end, object relative to the batch
    batch: Batch | None = None
    for draw in draws:
        changes = _material_changes(draw)
        if batch is None or not _fits(batch, draw, len(changes), limit):
            batch = Batch(draw.state, corners(draw.mode), draw.vertices, len(result.objects), 0, [])
            result.batches.append(batch)
        batch.draws.append(draw)
        row = _row(result, batch, (draw.matrices, draw.material))
        first, known = draw.first, {draw.material: row}
        for vertex, material in changes:
            spans.append((first, vertex, row))
            if material not in known:
                known[material] = _row(result, batch, (draw.matrices, material))
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
        and batch.state == draw.state
    )


def _row(plan: Plan, batch: Batch, thing: Object) -> int:
    """The row of an object in the batch; the last row serves again if it is the same."""
    if not batch.objects or not _same(plan.objects[-1], thing):
        plan.objects.append(thing)
        batch.objects += 1
    return batch.objects - 1


def separate(draw: Draw, limit: int) -> list[Draw]:
    """``draw``, or if it uses more than ``limit`` materials the same primitives as several Draws that do not."""
    changes = _material_changes(draw)
    if len(changes) < limit or len({material for _, material in changes}) < limit:
        return [draw]
    size = corners(draw.mode)
    chosen = _assembled(draw, draw.first, draw.count)
    old = draw.vertices
    firsts = np.array([vertex for vertex, _ in changes])
    materials = [draw.material, *(material for _, material in changes)]
    used = [materials[k] for k in np.searchsorted(firsts, chosen, side="right")]
    vertices = Vertices(old.rows[chosen], None if old.w is None else old.w[chosen], list(enumerate(used)))
    mode = {1: GL_POINTS, 2: GL_LINES, 3: GL_TRIANGLES}[size]
    step = (limit - 1) // size * size
    parts = []
    for first in range(0, len(chosen), step):
        count = min(step, len(chosen) - first)
        part = Draw(mode, first, count, None, draw.matrices, used[first], draw.state)
        part.vertices = vertices
        parts.append(part)
    return parts


def _same(a: Object, b: Object) -> bool:
    return a[0][0] is b[0][0] and a[0][1] is b[0][1] and a[1] is b[1]


def _material_changes(draw: Draw) -> list[tuple[int, Material]]:
    """glMaterial between this Draw's glBegin and glEnd: (first vertex, material), the last one for each vertex."""
    changes = draw.vertices.materials
    if not changes or draw.indices is not None:
        return []
    inside = {vertex: material for vertex, material in changes if draw.first <= vertex < draw.first + draw.count}
    return sorted(inside.items())


def _rows(spans: list[tuple[int, int, int]], count: int) -> Uint32:
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
    whole = complete(mode, draw.count) == draw.count
    return draw.mode == mode and draw.indices is None and draw.first == end and whole


def _assembled(draw: Draw, first: int, count: int) -> Uint32:
    lighting = draw.state.lighting
    last = lighting.shade_model == GL_FLAT or (lighting.enabled and lighting.two_side) or draw.indices is not None
    if draw.indices is None:
        pattern = assemble(draw.mode, count, last)
        if pattern is None:
            return np.arange(first, first + complete(draw.mode, count), dtype=np.uint32)
        return pattern + np.uint32(first)
    pattern = assemble(draw.mode, len(draw.indices), last)
    chosen = draw.indices[: complete(draw.mode, len(draw.indices))] if pattern is None else draw.indices[pattern]
    return chosen + np.uint32(first)
