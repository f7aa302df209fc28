"""The renderer's other GPU: it draws nothing and writes down what it is told, on a tape (tape.py).

The renderer is the same; its batching, wide lines, pixel rectangles and accumulation are on the tape as what they have
become.  Only where a picture reads itself (glCopyPixels, glAccum) a real screen draws along.
"""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import ExitStack
from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from glsim.machine import constants as gl
from glsim.machine.frame import Accum, Frame, Packet, Pixels, QueryMark
from glsim.render.draw import Renderer
from glsim.render.gpu import Buffer, Program, VertexArray
from glsim.render.specialise import specialised_body, split
from glsim.render.tape import SAMPLES, STATE, Picture, Tape

if TYPE_CHECKING:
    from glsim.render.context import Offscreen

SMALLEST_BLOCK = 16384  # bytes of a uniform block that every WebGL2 has room for
# commands that change nothing about the picture
SILENT = {
    "glFinish", "glPixelStorei", "glReadPixels", "glGenQueries", "glBeginQuery", "glEndQuery", "glDeleteQueries",
    "glGetQueryObjectuiv",
}  # fmt: skip
COMPONENTS: dict[int, int] = {gl.GL_RGBA: 4, gl.GL_RED: 1, gl.GL_DEPTH_COMPONENT: 1}


class TapeRecorder:
    """A gpu.GPU and gpu.Commands in one that appends operations to a picture of a tape."""

    max_samples = 4

    def __init__(self, tape: Tape, picture: Picture) -> None:
        self.tape, self.operations = tape, picture.operations
        self.info: dict[str, Any] = {"GL_MAX_UNIFORM_BLOCK_SIZE": SMALLEST_BLOCK}
        self.names = 0
        self.unit = 0

    def __enter__(self) -> TapeRecorder:
        return self

    def __exit__(self, *exception: object) -> None:
        pass

    def gc(self) -> int:
        return 0

    def name(self) -> int:
        self.names += 1
        return self.names

    # ------------------------------------------------------------ gpu.GPU

    def buffer(self, data: Any = None, *, reserve: int = 0, dynamic: bool = False) -> Buffer:
        return _Buffer(self, reserve)

    def program(self, *, vertex_shader: str, fragment_shader: str) -> Program:
        return _Program(self, vertex_shader, fragment_shader)

    def vertex_array(self, program: _Program, content: Any, *, index_buffer: _Buffer) -> VertexArray:
        number = self.name()
        parts = [[entry[0].number, *_layout(entry[1], entry[2:])] for entry in content]
        self.operations.append(["array", number, program.number, parts, index_buffer.number])
        return _VertexArray(self, number)

    # ------------------------------------------------------------ gpu.Commands

    def __getattr__(self, name: str) -> Callable[..., None]:
        if name not in STATE | SILENT:
            raise AttributeError(name)

        def command(*arguments: Any) -> None:
            if name in STATE:
                self.operations.append([name, *map(_plain, arguments)])

        setattr(self, name, command)
        return command

    def glGenTextures(self, count: int, names: Any) -> None:
        names._obj.value = self.name()

    def glDeleteTextures(self, count: int, names: Any) -> None:
        self.operations.append(["glDeleteTextures", list(names)])

    def glActiveTexture(self, unit: int) -> None:
        self.unit = int(unit) - int(gl.GL_TEXTURE0)

    def glBindTexture(self, target: int, number: int) -> None:
        self.operations.append(["texture", self.unit, int(target), int(number)])

    def glTexParameterfv(self, target: int, name: int, values: Any) -> None:
        self.operations.append(["glTexParameterfv", int(target), int(name), list(values)])

    def glTexImage2D(self, target: int, level: int, internal: int, width: int, height: int, *rest: Any) -> None:
        self._image(target, level, internal, (width, height), *rest[1:])

    def glTexImage3D(
        self, target: int, level: int, internal: int, width: int, height: int, depth: int, *rest: Any
    ) -> None:
        self._image(target, level, internal, (width, height, depth), *rest[1:])

    def _image(
        self, target: int, level: int, internal: int, size: Sequence[int], format: int, kind: int, address: int
    ) -> None:
        length = int(np.prod(size)) * COMPONENTS[format] * (4 if kind == gl.GL_FLOAT else 1)
        blob = self.tape.blob(ctypes.string_at(address, length))
        self.operations.append(
            ["image", int(target), level, int(internal), [*map(int, size)], int(format), int(kind), blob]
        )


class _Buffer:
    def __init__(self, recorder: TapeRecorder, size: int) -> None:
        self.recorder, self.number, self.size = recorder, recorder.name(), size
        self.orphan()

    def orphan(self, size: int = -1) -> None:
        self.size = size if size >= 0 else self.size
        self.recorder.operations.append(["buffer", self.number, self.size])

    def write(self, data: Any) -> None:
        blob = self.recorder.tape.blob(np.ascontiguousarray(data).tobytes())
        self.recorder.operations.append(["write", self.number, blob])

    def bind_to_uniform_block(self, binding: int = 0, *, offset: int = 0, size: int = -1) -> None:
        self.recorder.operations.append(["uniform", binding, self.number, offset, size])


class _Program:
    """By name only its inputs: a player gives blocks and samplers the numbers that the tape's head says."""

    def __init__(self, recorder: TapeRecorder, vertex: str, fragment: str) -> None:
        self.number = recorder.name()
        bodies = [split(text)[1] for text in (vertex, fragment)]
        texts = [specialised_body(body, es) for es in (False, True) for body in bodies]
        self.inputs = set(re.findall(r"^in \w+ (\w+);", texts[0], re.MULTILINE))
        recorder.operations.append(["program", self.number, *(recorder.tape.blob(text.encode()) for text in texts)])

    def __contains__(self, name: str) -> bool:
        return name in self.inputs

    def __setitem__(self, name: str, value: Any) -> None:
        raise KeyError(name)

    def get(self, key: str, default: Any) -> Any:
        return default


class _VertexArray:
    def __init__(self, recorder: TapeRecorder, number: int) -> None:
        self.recorder, self.number = recorder, number

    def render(self, mode: int | None = None, vertices: int = -1, *, first: int = 0, instances: int = -1) -> None:
        assert mode is not None
        self.recorder.operations.append(
            ["draw", self.number, int(mode), int(vertices), int(first), max(int(instances), 1)]
        )


def _plain(value: Any) -> float | int:
    """A number that JSON has."""
    return float(value) if isinstance(value, (float, np.floating)) else int(value)


def _layout(layout: str, names: Sequence[str]) -> list[Any]:
    """moderngl's "3f 12x 4f" with the names of inputs -> [bytes of a vertex, per instance, inputs]."""
    words, _, per = layout.partition("/")
    waiting, inputs, offset = list(names), [], 0
    for word in words.split():
        count, kind = re.findall(r"\d+|[fux]", word)[:2]
        if kind != "x":
            inputs.append([waiting.pop(0), int(count), kind, offset])
        offset += int(count) * (1 if kind == "x" else 4)
    return [offset, int(per == "i"), inputs]


# ---------------------------------------------------------------- Frames on tape


def record(frames: Mapping[str, Frame], samples: int = 0) -> Tape:
    """A tape with one picture for each Frame; all Frames have one size.

    A screen is opened only if a Frame has packets that read the picture.
    """
    if samples not in SAMPLES:
        raise ValueError(f"a tape has {', '.join(map(str, SAMPLES))} samples, not {samples!r}")
    sizes = {(frame.width, frame.height) for frame in frames.values()}
    if len(sizes) != 1:
        raise ValueError(f"a tape has pictures of one size, not of {sorted(sizes)}")
    tape = Tape(*sizes.pop(), samples)
    for name, frame in frames.items():
        tape.pictures.append(Picture(name))
        _record(tape, tape.pictures[-1], frame.packets)
    return tape


def _record(tape: Tape, picture: Picture, packets: Iterable[Packet]) -> None:
    recorder = TapeRecorder(tape, picture)
    renderer = Renderer(recorder, recorder, (tape.width, tape.height))
    packets = [packet for packet in packets if not isinstance(packet, QueryMark)]  # queries draw nothing
    with ExitStack() as resources:
        screen: Offscreen | None = None
        if any(map(_reads, packets)):
            from glsim.render.context import own_screen  # it needs moderngl, which a browser lacks

            screen = resources.enter_context(own_screen(tape.width, tape.height, samples=tape.samples))
        for _, group in groupby(enumerate(packets, 1), key=lambda numbered: _reads(numbered[1]) and numbered[0]):
            run = [packet for _, packet in group]
            renderer.execute(run, screen.read if screen else _cannot_read)
            if screen is not None:
                screen.execute(run)


def _reads(packet: Packet) -> bool:
    """Whether the renderer must know the picture so far."""
    return isinstance(packet, Accum) or (isinstance(packet, Pixels) and packet.copied is not None)


def _cannot_read(x: int, y: int, width: int, height: int, what: str) -> Any:
    raise AssertionError("only packets that _reads knows read the picture")


def tape(frame: Frame, *, samples: int = 0) -> bytes:
    """What glsim told the GPU to draw a Frame, as a tape (tape.py describes the format).

    The tape draws the same picture in a browser (glsim/web/player.js) and, with ``glsim draw``, here.
    samples: multisampling, 0 for none, or 2, 4, 8, 16, 32.  Raises ValueError for another number.
    """
    return record({"picture": frame}, samples).to_bytes()
