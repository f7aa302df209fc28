"""A Frame: what a program has drawn, as data.

Everything that looks at a picture is a consumer of a Frame: the renderer draws it, compare draws it with another shade
model, probe evaluates one of its pixels.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from html import escape
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine.matrix import Matrix
from glsim.machine.pixels import PixelMode
from glsim.machine.state import Color, Material, RasterPosition, Snapshot

# One vertex: position x y z, normal nx ny nz, colour r g b a, as float32.
ROW = 10
ROW_BYTES = 4 * ROW


# modelview, projection, texture; then the texture matrices of the other units if a program ever set one
Matrices = tuple[Matrix, ...]

# Where in display lists a Draw was made, outermost list first: (number of the list, number of the call in it).
Trail = tuple[tuple[int, int], ...]


class Vertices:
    """The vertices between two flushes, or of a display list.

    rows: (n, 10) float32; columns 0:3 position, 3:6 normal, 6:10 colour.
    columns: name of a further attribute -> (n, width) float32, or (1, width) if all vertices have the same value.
    materials: (first vertex, material) for each glMaterial between glBegin and glEnd, in order.
    static: the rows will be drawn again and again, so the GPU may keep them.
    """

    __slots__ = ("__weakref__", "columns", "materials", "rows", "static")

    def __init__(
        self,
        rows: NDArray[np.float32],
        columns: dict[str, NDArray[np.float32]],
        materials: Sequence[tuple[int, Material]],
        static: bool = False,
    ) -> None:
        self.rows, self.columns, self.materials, self.static = rows, columns, materials, static

    def column(self, name: str) -> NDArray[np.float32]:
        """The attribute ``name`` as (n, width): one row for each vertex."""
        values = self.columns[name]
        return values if len(values) == len(self.rows) else np.repeat(values[:1], len(self.rows), axis=0)

    def varies(self, name: str) -> bool:
        return name in self.columns and len(self.columns[name]) > 1

    def take(self, chosen: NDArray[Any], materials: Sequence[tuple[int, Material]] = ()) -> Vertices:
        """Some of the vertices, in another order."""
        columns = {name: values if len(values) == 1 else values[chosen] for name, values in self.columns.items()}
        return Vertices(self.rows[chosen], columns, materials)


class Draw:
    """One glBegin/glEnd, glRect, glDrawArrays or glDrawElements.

    Vertices ``first`` to ``first + count`` of ``vertices``, taken in the order of ``indices`` (relative to ``first``)
    if there are any, make primitives of ``mode``.  ``matrices``: see Matrices.
    """

    __slots__ = (
        "call", "color", "count", "first", "indices", "material", "matrices", "mode", "state", "trail", "vertices",
    )  # fmt: skip

    def __init__(
        self,
        mode: int,
        first: int,
        count: int,
        indices: NDArray[np.uint32] | None,
        matrices: Matrices,
        material: Material,
        state: Snapshot,
        vertices: Vertices | None = None,
    ) -> None:
        self.mode, self.first, self.count, self.indices = mode, first, count, indices
        self.matrices, self.material, self.state = matrices, material, state
        self.vertices = vertices
        self.color: Color | None = None  # replaces the colour of all vertices, for a display list that sets no colour
        self.call: int | None = None  # the number of the call that ended it, if calls are recorded
        self.trail: Trail = ()  # position in the display lists, if ``call`` is a glCallList

    def with_state(self, state: Snapshot) -> Draw:
        """The same geometry under another state."""
        draw = Draw(self.mode, self.first, self.count, self.indices, self.matrices, self.material, state)
        draw.vertices, draw.color, draw.call, draw.trail = self.vertices, self.color, self.call, self.trail
        return draw

    def material_changes(self) -> list[tuple[int, Material]]:
        """glMaterial between this Draw's glBegin and glEnd: (first vertex, material), the last one for each vertex."""
        changes = self.block.materials
        if not changes:
            return []
        begin, end = (bisect_left(changes, at, key=itemgetter(0)) for at in (self.first, self.first + self.count))
        return list(dict(changes[begin:end]).items())

    def materials_at(self, chosen: NDArray[Any]) -> list[Material]:
        """The material at each of some vertices (numbers in the block)."""
        changes = self.material_changes()
        materials = [self.material, *(material for _, material in changes)]
        firsts = np.array([vertex for vertex, _ in changes])
        return [materials[k] for k in np.searchsorted(firsts, chosen, side="right")]

    @property
    def block(self) -> Vertices:
        """The vertices that ``first`` and ``indices`` refer to; they are None until the machine is flushed."""
        assert self.vertices is not None
        return self.vertices


class Clear(NamedTuple):
    """One glClear; accum: the value for the accumulation buffer.  call: its number, if calls are recorded."""

    mask: int
    state: Snapshot
    accum: Color = (0.0, 0.0, 0.0, 0.0)
    call: int | None = None


class Pixels(NamedTuple):
    """One glDrawPixels, glCopyPixels or glBitmap.

    kind: "color", "depth", "stencil" or "bitmap".  image: (height, width, 4) colours, uint8 or in [0, 1]; (height,
    width, 1) float32 depths; (height, width, 1) uint8 stencil values or bits.  copied: instead of an image, the
    rectangle of the framebuffer (x, y, width, height) that is read when the packet is drawn.  raster: where it goes.
    """

    kind: str
    image: NDArray[Any] | None
    copied: tuple[int, int, int, int] | None
    raster: RasterPosition
    mode: PixelMode
    state: Snapshot
    call: int | None = None


class Accum(NamedTuple):
    """One glAccum."""

    operation: int
    value: float
    state: Snapshot
    call: int | None = None


class QueryMark(NamedTuple):
    """glBeginQuery or glEndQuery around some packets; query: where the number of samples will be."""

    begin: bool
    query: Query


class Query:
    """An occlusion query: result is None until the device has drawn what it counts."""

    __slots__ = ("__weakref__", "result")

    def __init__(self) -> None:
        self.result: int | None = None


Packet = Draw | Clear | Pixels | Accum | QueryMark


class Where(NamedTuple):
    """A line of the user's program; via: the GLU or GLUT function it called, if it was not the gl command itself."""

    file: str
    line: int
    via: str = ""


class Call(NamedTuple):
    """One call of the API, with the arguments as the program gave them (arrays copied)."""

    name: str
    arguments: tuple[Any, ...]
    where: Where | None = None


class Moment(NamedTuple):
    """The state after a call.  matrices: tops of the stacks for modelview, projection and each texture unit; depths:
    how many matrices each holds."""

    call: int
    state: Snapshot
    material: Material
    matrices: tuple[Matrix, ...]
    depths: tuple[int, ...]


@dataclass
class Frame:
    """Packets in the order of the program.

    If calls were recorded: ``calls`` they came from, and ``history``, the state at the beginning (call -1) and after
    each call that changed it.  ``error``: the sentence of the error that ended the program, ``error_at`` its line.
    ``unswapped``: it was drawn in a window with two buffers, which were never swapped.
    """

    width: int
    height: int
    packets: list[Packet] = field(default_factory=list)
    calls: list[Call] = field(default_factory=list)
    history: list[Moment] = field(default_factory=list)
    error: str = ""
    error_at: Where | None = None
    unswapped: bool = False

    def __repr__(self) -> str:
        counts = f"{len(self.packets)} packets, {len(list(self.draws))} draws, {len(self.calls)} calls"
        return f"<Frame {self.width} x {self.height}: {counts}{', ' + self.error if self.error else ''}>"

    def _repr_html_(self) -> str:
        """A table of what is drawn, for Jupyter."""
        rows = []
        for number, packet in enumerate(self.packets):
            call, what = getattr(packet, "call", None), type(packet).__name__
            if isinstance(packet, Draw):
                count = packet.count if packet.indices is None else len(packet.indices)
                what = f"{packet.mode!r}, {count} vertices"
            where = self.calls[call].where if call is not None and self.calls else None
            rows.append(f"<tr><td>{number}<td>{escape(what)}<td>{where.line if where else ''}")
        return f"{escape(repr(self))}<table><tr><th>packet<th>what<th>line{''.join(rows)}</table>"

    @property
    def draws(self) -> Iterator[Draw]:
        return (packet for packet in self.packets if isinstance(packet, Draw))

    def map_draws(self, change: Callable[[Draw], Draw | None]) -> Frame:
        """A new frame in which each Draw is replaced by ``change(draw)``, or dropped where that is None."""
        changed = ((change(p) if isinstance(p, Draw) else p) for p in self.packets)
        return replace(self, packets=[p for p in changed if p is not None])
