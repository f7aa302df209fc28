"""The abstract machine that the gl commands drive.  It knows no GPU.

Registers (current normal, colour, ...) and groups of state change as commands come; each glEnd adds a Draw to the
packets of the frame.  At a flush point the packets go to the ``device``, which draws them.
"""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from glsim.machine.constants import GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE
from glsim.machine.errors import invalid_operation
from glsim.machine.frame import ROW, ROW_BYTES, Draw, Frame, Packet, Vertices
from glsim.machine.matrix import Matrix, identity
from glsim.machine.state import (
    ColorBuffer,
    Depth,
    Lighting,
    Material,
    Polygon,
    Snapshot,
    Transform,
    Viewport,
    take_groups,
)

# Vertices are handed to the device when they take more than this, so that a program that never flushes stays small.
LARGE = 256 * 1024 * 1024

# Depths of the matrix stacks; the specification's minimum is 32, 2 and 2.
STACK_DEPTH: dict[int, int] = {GL_MODELVIEW: 64, GL_PROJECTION: 32, GL_TEXTURE: 32}


class Device(Protocol):
    """What the machine needs of whatever draws its frames."""

    width: int
    height: int

    def execute(self, packets: list[Packet]) -> None: ...

    def finish(self) -> None: ...

    def read(self, x: int, y: int, width: int, height: int, what: str) -> NDArray[Any]: ...

    def describe(self) -> dict[str, Any]: ...


def _ignore(row: bytes) -> int:
    """Where glVertex writes outside of glBegin/glEnd: the specification leaves it undefined, drivers ignore it."""
    return 0


class Machine:
    """State of one context.  The short names at the top are what the hot commands of gl/immediate.py touch."""

    __slots__ = (
        "alpha", "begin_material", "blue", "busy", "capturing", "client", "color_buffer", "depth", "device",
        "edge_flag", "first", "fog_coord", "green", "hints", "index", "inside", "lighting", "material", "materials",
        "modelview", "nx", "ny", "nz", "packets", "pixel_store", "polygon", "projection", "recorder", "red",
        "secondary_color", "stack", "stacks", "stream", "texcoord", "texture_stack", "transform", "viewport",
        "w_rows", "write",
    )  # fmt: skip

    def __init__(self, device: Device) -> None:
        self.device = device
        self.capturing: Frame | None = None
        self.recorder: Callable[[str, tuple[Any, ...]], Any] | None = None
        self.reset()

    def reset(self) -> None:
        """Set every state to its initial value; what was drawn and not flushed is dropped."""
        # current values, section 2.7
        self.nx, self.ny, self.nz = 0.0, 0.0, 1.0
        self.red = self.green = self.blue = self.alpha = 1.0
        self.texcoord = [(0.0, 0.0, 0.0, 1.0)] * 8
        self.secondary_color = (0.0, 0.0, 0.0, 1.0)
        self.fog_coord = 0.0
        self.index = 1.0
        self.edge_flag = True
        # groups
        self.lighting = Lighting()
        self.material = Material()
        self.transform = Transform()
        self.viewport = Viewport(0, 0, self.device.width, self.device.height)
        self.polygon = Polygon()
        self.depth = Depth()
        self.color_buffer = ColorBuffer()
        self.hints: dict[int, int] = {}
        self.pixel_store: dict[int, int] = {}
        self.client: dict[Any, Any] = {}
        # matrices
        self.modelview, self.projection, self.texture_stack = [identity()], [identity()], [identity()]
        self.stacks: dict[int, list[Matrix]] = {
            GL_MODELVIEW: self.modelview,
            GL_PROJECTION: self.projection,
            GL_TEXTURE: self.texture_stack,
        }
        self.stack = self.modelview
        # vertices and packets since the last flush
        self.inside: int | None = None
        self.busy = self.recorder is not None
        self.first = 0
        self.begin_material = self.material
        self.packets: list[Packet] = []
        self._new_stream()

    def _new_stream(self) -> None:
        self.stream = io.BytesIO()
        self.materials: list[tuple[int, Material]] = []
        self.w_rows: list[tuple[int, Any]] = []
        self.write: Callable[[bytes], int] = _ignore

    # ------------------------------------------------------------ primitives

    def begin(self, mode: int) -> None:
        self.inside = mode
        self.busy = True
        self.first = self.stream.tell() // ROW_BYTES
        self.begin_material = self.material
        self.write = self.stream.write

    def end(self) -> None:
        mode = self.inside
        if mode is None:
            raise invalid_operation("there is no glBegin before this glEnd")
        self.inside = None
        self.busy = self.recorder is not None
        self.write = _ignore
        first, end = self.first, self.stream.tell()
        count = end // ROW_BYTES - first
        transform = (self.modelview[-1], self.projection[-1])
        self.packets.append(Draw(mode, first, count, None, transform, self.begin_material, self.snapshot()))
        if end > LARGE:
            self.flush()

    def add_draw(self, mode: int, rows: NDArray[np.float32], w: Any, indices: NDArray[np.uint32] | None) -> None:
        """A whole primitive at once: vertex arrays.  rows (n, 10) float32, w (n,) or None."""
        first = self.stream.tell() // ROW_BYTES
        self.stream.write(np.ascontiguousarray(rows, np.float32).data)
        if w is not None:
            self.w_rows.append((first, w))
        transform = (self.modelview[-1], self.projection[-1])
        self.packets.append(Draw(mode, first, len(rows), indices, transform, self.material, self.snapshot()))
        if self.stream.tell() > LARGE:
            self.flush()

    def snapshot(self) -> Snapshot:
        return Snapshot._make(take_groups(self))

    # ------------------------------------------------------------ flush points

    def flush(self) -> None:
        """Hand all packets to the device; nothing happens between glBegin and glEnd."""
        if not self.packets or self.inside is not None:
            return
        vertices = self._take_vertices()
        packets, self.packets = self.packets, []
        for packet in packets:
            if type(packet) is Draw:
                packet.vertices = vertices
        if self.capturing is not None:
            self.capturing.packets += packets
        self.device.execute(packets)

    def _take_vertices(self) -> Vertices:
        rows = np.frombuffer(self.stream.getbuffer(), np.float32).reshape(-1, ROW)
        w = None
        if self.w_rows:
            w = np.ones(len(rows), np.float32)
            for row, values in self.w_rows:
                w[row : row + np.size(values)] = values
        vertices = Vertices(rows, w, self.materials)
        self._new_stream()
        return vertices

    # ------------------------------------------------------------ interception

    def intercept(self, name: str, arguments: tuple[Any, ...]) -> Any:
        """A command came that is illegal between glBegin and glEnd, or that must be recorded."""
        if self.inside is not None:
            raise invalid_operation("not allowed between glBegin and glEnd").during(name, arguments)
        assert self.recorder is not None
        return self.recorder(name, arguments)

    def record(self, recorder: Callable[[str, tuple[Any, ...]], Any] | None) -> None:
        """Send every command to ``recorder`` instead of executing it; None ends that."""
        self.recorder = recorder
        self.busy = recorder is not None or self.inside is not None

    def top(self) -> Matrix:
        return self.stack[-1]
