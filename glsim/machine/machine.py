"""The abstract machine that the gl commands drive.  It knows no GPU.

Registers (current normal, colour, ...) and groups of state change as commands come; each glEnd adds a Draw to the
packets of the frame.  At a flush point the packets go to the ``device``, which draws them.
"""

from __future__ import annotations

import io
from _thread import get_ident
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.constants import GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE
from glsim.machine.device import Device
from glsim.machine.errors import NoContextError, invalid_operation
from glsim.machine.frame import ROW, ROW_BYTES, Draw, Matrices, Packet, Vertices
from glsim.machine.holdings import Objects, PixelStores, Rendering, VertexArrays
from glsim.machine.interception import Outlet, Recording
from glsim.machine.interrupts import uninterrupted
from glsim.machine.matrix import Matrix, identity
from glsim.machine.pixels import PixelMode
from glsim.machine.state import (
    TEXTURE_UNITS,
    Color,
    ColorBuffer,
    Depth,
    Evaluators,
    Fog,
    Hints,
    Lighting,
    Line,
    Material,
    Multisample,
    Point,
    Polygon,
    PolygonStipple,
    RasterPosition,
    Scissor,
    Snapshot,
    Stencil,
    Texturing,
    Transform,
    Viewport,
    take_groups,
)
from glsim.machine.tracks import INITIAL_VALUES, Track, column_of

# The machine flushes by itself when vertices and images of the packets take more than LARGE bytes, or when there are
# more than MANY packets: so a program that never calls glFlush does not run out of memory.
LARGE = 256 * 1024 * 1024
MANY = 1 << 18

ATTRIB_STACK_DEPTH = 16  # of glPushAttrib and of glPushClientAttrib; the specification's minimum
MAX_LIST_NESTING = 64  # of display lists that call each other; the specification's minimum
MOST_NAMES = 1 << 20  # the most names that one call of glGenTextures, glGenLists, ... can ask for
# Depths of the matrix stacks; the specification's minimum is 32, 2 and 2.
STACK_DEPTH: dict[int, int] = {GL_MODELVIEW: 64, GL_PROJECTION: 32, GL_TEXTURE: 32}


# Current values that glVertex writes beside the position.
REGISTERS = ("nx", "ny", "nz", "red", "green", "blue", "alpha")


def _ignore(row: bytes) -> int:
    """``write`` outside of glBegin/glEnd: drops the vertex, as drivers do; the specification leaves it undefined."""
    return 0


class Machine:
    """State of one context.  The short names at the top are what the hot commands of gl/immediate.py touch."""

    __slots__ = (  # noqa: RUF023
        # current values (section 2.7); the others are the last entries of ``tracks``
        "nx", "ny", "nz", "red", "green", "blue", "alpha", "index",
        # vertices since the last flush, and the primitive between glBegin and glEnd
        "stream", "write", "tracks", "texcoord", "columns", "materials", "inside", "first", "begin_material",
        # packets since the last flush
        "packets", "waiting", "latest",
        # matrices (section 2.11.2)
        "modelview", "projection", "texture_stacks", "several_texture_matrices", "stacks", "stack",
        # interception: see interception.py
        "recorder", "busy", "outlet",
        # groups of state (state.py): those of a Snapshot, and those that no Draw needs
        "color_buffer", "depth", "fog", "hints", "lighting", "line", "multisample", "point", "polygon",
        "polygon_stipple", "scissor", "stencil", "texture", "transform", "viewport",
        "accum_clear", "evaluators", "list_base", "material", "pixel", "raster",
        # what glPushAttrib and glPushClientAttrib saved
        "attrib_stack", "client_attrib_stack",
        # by topic: see holdings.py
        "client", "objects", "rendering", "stores",
        # the display list that is being compiled, and how many are being called
        "compiling", "nesting",
        "device", "thread", "__weakref__",
    )  # fmt: skip

    def __init__(self, device: Device) -> None:
        self.device = device
        self.thread = get_ident()  # in which it is current
        self.outlet = Outlet()
        self.recorder: Recording | None = None
        self.reset()

    def reset(self) -> None:
        """Set every state to its initial value; what was drawn and not flushed is dropped.

        A Frame that is being captured, and a Recorder, begin anew.
        """
        recorder: Any = self.recorder
        self._reset_current_values()
        self._reset_groups()
        self._reset_matrices()
        # by topic
        self.client = VertexArrays()
        self.stores = PixelStores()
        self.objects = Objects(textures={(0, texture.kind): texture for texture in self.texture.unit.bound})
        self.rendering = Rendering()
        self.compiling: Any = None  # the ListRecorder between glNewList and glEndList
        self.nesting = 0  # lists that are being called
        # vertices and packets since the last flush
        self.inside: int | None = None
        self.recorder = None
        self.busy = False
        self.first = 0
        self.begin_material = self.material
        self.packets: list[Packet] = []
        self.waiting = 0  # bytes of the pictures in packets
        self._new_stream()
        self.outlet.reset()
        recorder = getattr(recorder, "outer", recorder)  # of a display list that was being compiled
        if recorder is not None:
            recorder.restart()
            self.record(recorder)

    def _reset_current_values(self) -> None:
        """Section 2.7."""
        self.nx, self.ny, self.nz = 0.0, 0.0, 1.0
        self.red = self.green = self.blue = self.alpha = 1.0
        self.index = 1.0
        self.tracks: dict[str, Track] = {name: [(0, value)] for name, value in INITIAL_VALUES.items()}

    def _reset_groups(self) -> None:
        """The groups of state.py, and what glPushAttrib saved of them."""
        width, height = self.device.width, self.device.height
        self.lighting = Lighting()
        self.transform = Transform()
        self.viewport = Viewport(0, 0, width, height)
        self.point = Point()
        self.line = Line()
        self.polygon = Polygon()
        self.polygon_stipple = PolygonStipple()
        self.texture = Texturing()
        self.fog = Fog()
        self.depth = Depth()
        self.stencil = Stencil()
        self.color_buffer = ColorBuffer()
        self.scissor = Scissor(False, 0, 0, width, height)
        self.multisample = Multisample()
        self.hints = Hints()
        self.latest = Snapshot._make(take_groups(self))
        self.material = Material()
        self.raster = RasterPosition()
        self.pixel = PixelMode()
        self.accum_clear: Color = (0.0, 0.0, 0.0, 0.0)
        self.evaluators = Evaluators()
        self.list_base = 0
        self.attrib_stack: list[Any] = []
        self.client_attrib_stack: list[Any] = []

    def _reset_matrices(self) -> None:
        """Section 2.11.2: a stack for each, with the identity on it."""
        self.modelview, self.projection = [identity()], [identity()]
        self.texture_stacks = [[identity()] for _ in range(TEXTURE_UNITS)]
        self.several_texture_matrices = False  # whether a program ever chose the matrix of another unit
        self.stacks: dict[int, list[Matrix]] = {
            GL_MODELVIEW: self.modelview,
            GL_PROJECTION: self.projection,
            GL_TEXTURE: self.texture_stacks[0],  # of the active unit
        }
        self.stack = self.modelview

    def _new_stream(self) -> None:
        self.stream = io.BytesIO()
        self.materials: list[tuple[int, Material]] = []
        self.columns: list[tuple[str, int, Any]] = []
        self.tracks = {name: [(0, track[-1][1])] for name, track in self.tracks.items()}
        self.texcoord = self.tracks["texcoord0"]
        self.write: Callable[[bytes], int] = _ignore

    def _drop_tracks(self) -> None:
        """Drop the vertices of the stream, and give the current values of the tracks their initial values."""
        self.tracks = {name: [(0, value)] for name, value in INITIAL_VALUES.items()}
        self._new_stream()

    @property
    def current(self) -> dict[str, tuple[float, ...]]:
        """Current values of the attributes that have tracks."""
        return {name: track[-1][1] for name, track in self.tracks.items()}

    @current.setter
    def current(self, values: dict[str, tuple[float, ...]]) -> None:
        for name, value in values.items():
            self.set_current(name, value)

    def set_current(self, name: str, value: tuple[float, ...]) -> None:
        """glTexCoord and the like: the value holds from the next vertex on."""
        self.tracks[name].append((self.stream.tell(), value))

    # ------------------------------------------------------------ primitives

    def begin(self, mode: int) -> None:
        if get_ident() != self.thread:
            raise NoContextError(
                "no context is current in this thread: each thread opens its own, with glsim.offscreen"
            )
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
        while self.materials and self.materials[-1][0] == first + count:
            self.materials.pop()  # glMaterial after the last vertex
        self.packets.append(Draw(mode, first, count, None, self.matrices(), self.begin_material, self.snapshot()))
        if end > LARGE or len(self.packets) > MANY:
            self.flush()

    def add_draw(
        self,
        mode: int,
        rows: NDArray[np.float32],
        columns: dict[str, NDArray[np.float32]],
        indices: NDArray[np.uint32] | None,
    ) -> None:
        """A whole primitive at once: vertex arrays.  rows (n, 10) float32; columns (n, width) by name."""
        first = self.stream.tell() // ROW_BYTES
        self.stream.write(np.ascontiguousarray(rows, np.float32).data)
        self.columns += [(name, first, values) for name, values in columns.items()]
        self.packets.append(Draw(mode, first, len(rows), indices, self.matrices(), self.material, self.snapshot()))
        self.relieve()

    def matrices(self) -> Matrices:
        """The matrices on top of the stacks, for a Draw made now: modelview, projection, texture of unit 0.

        The texture matrices of the other units follow if the program has ever used one.
        """
        usual = self.modelview[-1], self.projection[-1], self.texture_stacks[0][-1]
        return usual if not self.several_texture_matrices else (*usual, *[s[-1] for s in self.texture_stacks[1:]])

    def snapshot(self) -> Snapshot:
        """The groups of state as they are; the same object as long as none changes."""
        groups = take_groups(self)
        if groups != self.latest:
            self.latest = Snapshot._make(groups)
        return self.latest

    # ------------------------------------------------------------ flush points

    def add(self, packet: Packet, size: int = 0) -> None:
        """A packet that is no primitive.  size: bytes of its picture."""
        self.packets.append(packet)
        self.waiting += size
        self.relieve()

    def relieve(self) -> None:
        """Hand the packets to the device if they take much memory."""
        if self.stream.tell() + self.waiting > LARGE or len(self.packets) > MANY:
            self.flush()

    def flush(self) -> None:
        """Hand all packets to the device; nothing happens between glBegin and glEnd."""
        if not self.packets or self.inside is not None:
            return
        self.device.check()
        with uninterrupted():
            packets, self.packets, self.waiting = self.packets, [], 0
            try:
                vertices = self.take_vertices()
            except (TypeError, ValueError, OverflowError):
                self._drop_tracks()
                raise TypeError(
                    "a texture coordinate, secondary color, fog coordinate or edge flag was no number;"
                    " what was drawn with it is lost"
                ) from None
            for packet in packets:
                if type(packet) is Draw and packet.vertices is None:
                    packet.vertices = vertices
            drawn = self.outlet.passed(packets)
            if drawn:
                self.device.execute(drawn)

    def complete(self) -> None:
        """Flush before the framebuffer is read.  Raises GLError between glBegin and glEnd."""
        if self.inside is not None:
            raise invalid_operation(f"glBegin({self.inside!r}) has no glEnd yet")
        self.flush()

    def take_vertices(self) -> Vertices:
        """What the stream holds, as arrays; the stream begins anew."""
        rows = np.frombuffer(self.stream.getbuffer(), np.float32).reshape(-1, ROW)
        columns = {name: column_of(track, len(rows)) for name, track in self.tracks.items()}
        for name, first, values in self.columns:
            if name not in columns or len(columns[name]) != len(rows):
                start = columns.get(name, np.ones((1, 1), np.float32))
                columns[name] = np.repeat(start[:1], len(rows), axis=0)
            values = np.asarray(values, np.float32).reshape(-1, columns[name].shape[1])
            columns[name][first : first + len(values)] = values
        vertices = Vertices(rows, columns, self.materials)
        self._new_stream()
        return vertices

    # ------------------------------------------------------------ interception of commands

    def intercept(self, name: str, arguments: tuple[Any, ...]) -> Any:
        """A command came that is illegal between glBegin and glEnd, or that must be recorded."""
        if self.inside is not None:
            raise invalid_operation("not allowed between glBegin and glEnd").during(name, arguments)
        assert self.recorder is not None
        return self.recorder(name, arguments)

    def record(self, recorder: Recording | None) -> None:
        """Send every command to ``recorder`` instead of executing it; None ends that."""
        self.recorder = recorder
        self.busy = recorder is not None or self.inside is not None
