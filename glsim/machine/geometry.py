"""The static part of a display list: vertices that are the same at every glCallList."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import PLAIN, corners, primitives
from glsim.machine.current import driving
from glsim.machine.device import NoDevice
from glsim.machine.frame import Draw, Vertices
from glsim.machine.machine import REGISTERS, Machine
from glsim.machine.record import implementations

NAN = float("nan")
MOST_VARIANTS = 16
GOLDEN = np.uint64(0x9E3779B97F4A7C15)  # 2^64 / golden ratio: multiplication by it spreads bits (Knuth, volume 3, 6.4)
AnyCall = tuple[str, tuple[Any, ...]]
Part = tuple[int, NDArray[np.uint32]]  # mode, vertices


class Geometry:
    """What a run of glBegin, glVertex, glNormal, ... draws, compiled once.

    Values that the list does not set itself are taken from the machine when the list is called: they are NaN in
    ``vertices``.
    """

    def __init__(self, calls: Sequence[AnyCall], clients: dict[int, dict[Any, Any]], first: int) -> None:
        """calls: consecutive calls of a display list.  first: the position of calls[0] in the list.

        clients: position in the list of a call that draws from vertex arrays -> the state of these arrays.
        """
        machine = _execute(calls, clients, first)
        self.after = {
            name: getattr(machine, name) for name in REGISTERS if getattr(machine, name) == getattr(machine, name)
        }
        self.after_current = {n: v for n, v in machine.current.items() if v[0] == v[0]}
        vertices = machine.take_vertices()
        chosen, numbers = different(vertices)
        self.vertices = vertices.take(chosen)
        drawn = [packet for packet in machine.packets if isinstance(packet, Draw)]
        self.parts: list[Part] = [(draw.mode, _indices(draw, numbers)) for draw in drawn]
        rows = self.vertices.rows
        self.no_normal, self.no_color = np.isnan(rows[:, 3]), np.isnan(rows[:, 6])
        self.no_column = {n: np.isnan(v[:, 0]) for n, v in self.vertices.columns.items() if np.isnan(v[:, 0]).any()}
        self.color_is_callers = bool(self.no_color.all())
        self.takes_normal = bool(self.no_normal.any())
        self.takes_color = bool(self.no_color.any()) and not self.color_is_callers
        self.variants: dict[Any, Vertices] = {}
        self.assembled: list[Part] | None = None

    def call(self, m: Machine) -> None:
        """Draw with the machine's present state, and leave the current values that the list sets."""
        state, matrices = m.snapshot(), m.matrices()
        filled = state.polygon.front_mode == state.polygon.back_mode == gl.GL_FILL
        vertices = self._resolved(m, not filled or state.fog.color_sum or state.fog.enabled or state.texture.in_use)
        color = (m.red, m.green, m.blue, m.alpha) if self.color_is_callers else None
        for mode, indices in self._assembled() if filled and not state.line.stipple else self.parts:
            draw = Draw(mode, 0, len(vertices.rows), indices, matrices, m.material, state, vertices)
            draw.color = color
            m.packets.append(draw)
        for name, value in self.after.items():
            setattr(m, name, value)
        if self.after_current:
            m.current = self.after_current

    def _assembled(self) -> list[Part]:
        """All primitives as few pairs (mode, indices) of separate triangles, lines or points.

        Each call returns the same index arrays, so that the GPU can keep its copies of them.
        """
        if self.assembled is None:
            self.assembled = []
            for kind, group in groupby(self.parts, key=lambda part: corners(part[0])):
                indices = np.concatenate([primitives(mode, len(own), own, last=True) for mode, own in group])
                if len(indices):
                    self.assembled.append((PLAIN[kind], indices))
        return self.assembled

    def _resolved(self, m: Machine, all_columns: bool) -> Vertices:
        """The vertices with the machine's current values in place of NaN.

        all_columns: whether NaN is replaced in ``columns``, too.
        """
        current = m.current if all_columns and self.no_column else {}
        key = (
            (m.nx, m.ny, m.nz) if self.takes_normal else None,
            (m.red, m.green, m.blue, m.alpha) if self.takes_color else None,
            tuple(current[name] for name in self.no_column) if current else None,
        )
        variant = self.variants.get(key)
        if variant is None:
            if len(self.variants) >= MOST_VARIANTS:
                self.variants.clear()
            rows = self.vertices.rows.copy()
            rows[self.no_normal, 3:6] = m.nx, m.ny, m.nz
            rows[self.no_color, 6:10] = m.red, m.green, m.blue, m.alpha
            columns = dict(self.vertices.columns)
            for name, missing in self.no_column.items() if current else ():
                columns[name] = np.where(missing[:, None], np.array(current[name], np.float32), columns[name])
            variant = self.variants[key] = Vertices(rows, columns, [], static=True)
        return variant


def different(vertices: Vertices) -> tuple[NDArray[np.intp], NDArray[np.uint32]]:
    """Vertices that agree in every bit become one, which is computed once: (chosen, numbers).

    chosen: vertices that differ from each other; numbers: for each vertex, which of the chosen it is.  A mesh of
    separate triangles has each of its points about six times.
    """
    parts = [values for values in (vertices.rows, *vertices.columns.values()) if len(values) == len(vertices.rows)]
    bits = np.concatenate([np.ascontiguousarray(part).view(np.uint32) for part in parts], axis=1)
    hashes = np.zeros(len(bits), np.uint64)
    for column in bits.T:
        hashes = (hashes ^ (hashes >> np.uint64(29))) * GOLDEN + column
    _, first, group = np.unique(hashes, return_index=True, return_inverse=True)
    chosen = np.sort(first)  # as they came
    numbers = np.searchsorted(chosen, first).astype(np.uint32)[group]
    if len(chosen) == len(bits) or not np.array_equal(bits[chosen][numbers], bits):  # two hashes met: keep all
        return np.arange(len(bits)), np.arange(len(bits), dtype=np.uint32)
    return chosen, numbers


def _indices(draw: Draw, numbers: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """A Draw's vertices in order.  numbers: what each vertex of its block is called now."""
    own = numbers[draw.first : draw.first + draw.count]
    return own if draw.indices is None else own[draw.indices]


def _execute(calls: Sequence[AnyCall], clients: dict[int, dict[Any, Any]], first: int) -> Machine:
    """Run the calls on a new machine whose current normal, colour, texture coordinates, ... are NaN; return it."""
    scratch = Machine(NoDevice())
    scratch.nx = scratch.ny = scratch.nz = scratch.red = scratch.green = scratch.blue = scratch.alpha = NAN
    scratch.tracks = {name: [(0, (NAN,) * len(track[0][1]))] for name, track in scratch.tracks.items()}
    scratch.texcoord = scratch.tracks["texcoord0"]
    with driving(scratch):
        for position, (name, arguments) in enumerate(calls, first):
            if position in clients:
                scratch.client.arrays = clients[position]
            implementations[name](*arguments)
    return scratch
