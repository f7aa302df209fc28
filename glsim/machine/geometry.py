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
AnyCall = tuple[str, tuple[Any, ...]]


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
        self.draws: list[Draw] = [packet for packet in machine.packets if isinstance(packet, Draw)]
        self.after = {
            name: getattr(machine, name) for name in REGISTERS if getattr(machine, name) == getattr(machine, name)
        }
        self.after_current = {n: v for n, v in machine.current.items() if v[0] == v[0]}
        vertices = machine.take_vertices()
        self.vertices = Vertices(vertices.rows, vertices.columns, [], static=True)
        rows = self.vertices.rows
        self.no_normal, self.no_color = np.isnan(rows[:, 3]), np.isnan(rows[:, 6])
        self.no_column = {n: np.isnan(v[:, 0]) for n, v in vertices.columns.items() if np.isnan(v[:, 0]).any()}
        self.color_is_callers = bool(self.no_color.all())
        self.takes_normal = bool(self.no_normal.any())
        self.takes_color = bool(self.no_color.any()) and not self.color_is_callers
        self.variants: dict[Any, Vertices] = {}
        self.order: list[tuple[int, NDArray[np.uint32]]] | None = None

    def call(self, m: Machine) -> None:
        """Draw with the machine's present state, and leave the current values that the list sets."""
        state, matrices = m.snapshot(), m.matrices()
        filled = state.polygon.front_mode == state.polygon.back_mode == gl.GL_FILL
        vertices = self._resolved(m, not filled or state.fog.color_sum or state.fog.enabled or state.texture.in_use)
        color = (m.red, m.green, m.blue, m.alpha) if self.color_is_callers else None
        if filled and not state.line.stipple:
            parts: list[Any] = [(mode, 0, len(vertices.rows), indices) for mode, indices in self._assembled()]
        else:
            parts = [(part.mode, part.first, part.count, part.indices) for part in self.draws]
        for mode, first, count, indices in parts:
            draw = Draw(mode, first, count, indices, matrices, m.material, state, vertices)
            draw.color = color
            m.packets.append(draw)
        for name, value in self.after.items():
            setattr(m, name, value)
        if self.after_current:
            m.current = self.after_current

    def _assembled(self) -> list[tuple[int, NDArray[np.uint32]]]:
        """All primitives as few pairs (mode, indices) of separate triangles, lines or points.

        Each call returns the same index arrays, so that the GPU can keep its copies of them.
        """
        if self.order is None:
            self.order = []
            for kind, group in groupby(self.draws, key=lambda draw: corners(draw.mode)):
                indices = np.concatenate([_indices(draw) for draw in group])
                if len(indices):
                    self.order.append((PLAIN[kind], indices))
        return self.order

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


def _indices(draw: Draw) -> NDArray[np.uint32]:
    """Plain triangles, lines or points; quads are cut so that both halves end in the provoking vertex."""
    count = draw.count if draw.indices is None else len(draw.indices)
    return primitives(draw.mode, count, draw.indices, last=True) + np.uint32(draw.first)


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
