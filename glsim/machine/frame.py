"""A Frame: what a program has drawn, as data.

Everything that looks at a picture is a consumer of a Frame: the renderer draws it, compare draws it with another shade
model, probe evaluates one of its pixels.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine.matrix import Matrix
from glsim.machine.state import Material, Snapshot

# One vertex: position x y z, normal nx ny nz, colour r g b a, as float32.
ROW = 10
ROW_BYTES = 4 * ROW


class Vertices:
    """The vertices between two flushes.

    rows: (n, 10) float32; columns 0:3 position, 3:6 normal, 6:10 colour.
    w: (n,) float32, or None if every w is 1.
    materials: (first vertex, material) for each glMaterial between glBegin and glEnd, in order.
    """

    __slots__ = ("materials", "rows", "w")

    def __init__(
        self, rows: NDArray[np.float32], w: NDArray[np.float32] | None, materials: Sequence[tuple[int, Material]]
    ) -> None:
        self.rows, self.w, self.materials = rows, w, materials


class Draw:
    """One glBegin/glEnd, glRect, glDrawArrays or glDrawElements.

    Vertices ``first`` to ``first + count`` of ``vertices``, taken in the order of ``indices`` (relative to ``first``)
    if there are any, make primitives of ``mode``.  ``matrices`` are the modelview and the projection.
    """

    __slots__ = ("count", "first", "indices", "material", "matrices", "mode", "state", "vertices")

    vertices: Vertices  # set when the vertices are complete, at the flush

    def __init__(
        self,
        mode: int,
        first: int,
        count: int,
        indices: NDArray[np.uint32] | None,
        matrices: tuple[Matrix, Matrix],
        material: Material,
        state: Snapshot,
    ) -> None:
        self.mode, self.first, self.count, self.indices = mode, first, count, indices
        self.matrices, self.material, self.state = matrices, material, state

    def with_state(self, state: Snapshot) -> Draw:
        """The same geometry under another state."""
        draw = Draw(self.mode, self.first, self.count, self.indices, self.matrices, self.material, state)
        draw.vertices = self.vertices
        return draw


class Clear(NamedTuple):
    """One glClear."""

    mask: int
    state: Snapshot


Packet = Draw | Clear


class Call(NamedTuple):
    """One call of the API, with the arguments as the program gave them (arrays copied)."""

    name: str
    arguments: tuple[Any, ...]


@dataclass
class Frame:
    """Packets in the order of the program, and the calls they came from if those were recorded."""

    width: int
    height: int
    packets: list[Packet] = field(default_factory=list)
    calls: list[Call] = field(default_factory=list)

    @property
    def draws(self) -> Iterator[Draw]:
        return (packet for packet in self.packets if isinstance(packet, Draw))

    def map_draws(self, change: Callable[[Draw], Draw | None]) -> Frame:
        """A new frame in which each Draw is replaced by ``change(draw)``, or dropped where that is None."""
        changed = ((change(p) if isinstance(p, Draw) else p) for p in self.packets)
        return replace(self, packets=[p for p in changed if p is not None])
