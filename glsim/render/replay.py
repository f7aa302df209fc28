"""Playing a tape with moderngl: what ``glsim draw`` does with a file ending in .glt.

A tape may come from anywhere, and a driver believes what it is told.  So whatever the driver would read memory by
(addresses, sizes, indices) is checked here, and errors that it reports end the picture with a sentence.  A tape's GLSL
goes to the driver's compiler as it is: like any program it may be slow, or never end.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, field
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.interrupts import uninterrupted
from glsim.render.compile import BINDINGS, link
from glsim.render.context import own_screen
from glsim.render.gpu import Buffer, Commands, Program, VertexArray
from glsim.render.programs import FRONT
from glsim.render.raw import SIGNATURES
from glsim.render.tape import STATE, Operation, Picture, Tape, TapeError

if TYPE_CHECKING:
    from moderngl import Context

MOST_BYTES = 1 << 31  # of all buffers and images that a picture has at a time
MOST_STRIDE = 2048  # bytes from one vertex to the next that OpenGL promises
PRIMITIVES = (gl.GL_POINTS, gl.GL_LINES, gl.GL_TRIANGLES)
# bytes that one element of an image with this format and type has
ELEMENT = {
    (int(format), int(kind)): components * size
    for format, components in ((gl.GL_RGBA, 4), (gl.GL_RED, 1), (gl.GL_DEPTH_COMPONENT, 1))
    for kind, size in ((gl.GL_UNSIGNED_BYTE, 1), (gl.GL_FLOAT, 4))
}
WIDEST_TEXEL = 16  # bytes of any internal format, at most


def replayed(tape: Tape, number: int = 0) -> NDArray[np.uint8]:
    """The picture with this number on a tape, drawn here: (height, width, 4) uint8, top row first.

    Raises TapeError if the tape has no such picture, or operations that are none; ValueError if this device has not
    as many samples.
    """
    if not 0 <= number < len(tape.pictures):
        raise TapeError(f"this tape has no picture {number}: it holds {len(tape.pictures)}, numbered from 0")
    with own_screen(tape.width, tape.height, samples=tape.samples) as screen:
        with uninterrupted(), screen.ctx:
            screen._target.use()
            _Player(tape, screen.ctx, screen._raw).play(tape.pictures[number])
        return screen.pixels()


@dataclass
class _Held:
    """A buffer.  written: what its first bytes are; of the others nothing is known."""

    gpu: Buffer
    size: int
    written: bytes = b""


@dataclass
class _Array:
    """A program's inputs.  parts: (buffer, bytes of a vertex, bytes of the last one that are read, per instance)."""

    gpu: VertexArray
    program: Program
    indices: _Held
    parts: list[tuple[_Held, int, int, bool]] = field(default_factory=list)


class _Player:
    """One picture's buffers, programs, arrays and textures by their numbers on the tape."""

    def __init__(self, tape: Tape, gpu: Context, raw: Commands) -> None:
        self.tape, self.gpu, self.raw = tape, gpu, raw
        self.buffers: dict[int, _Held] = {}
        self.blocks: dict[int, tuple[_Held, int]] = {}  # binding -> buffer, and the first byte that is not read
        self.ranges: dict[int, int] = {}  # binding -> bytes
        self.programs: dict[int, Program] = {}
        self.arrays: dict[int, _Array] = {}
        self.textures: dict[int, int] = {}
        self.bound: tuple[int, int] = (0, 0)  # unit and texture of the last operation "texture"
        self.memory: dict[tuple[int, ...], int] = {}  # what a buffer or image takes

    def play(self, picture: Picture) -> None:
        for at, operation in enumerate(picture.operations):
            try:
                self.operate(operation)
            except Exception as error:  # of moderngl, ctypes or below, all for one reason
                what, why = str(operation), f"{type(error).__name__}: {error}".splitlines()
                raise TapeError(
                    f"operation {at} of the tape cannot be played: {what[:80]}{'...' * (len(what) > 80)}"
                    f" ({' '.join(' '.join(why).split())[:200]})"
                ) from None

    def operate(self, operation: Operation) -> None:
        name, *arguments = operation
        own = getattr(self, f"on_{name}", None)
        if own is not None:
            own(*arguments)
        elif name in STATE and len(arguments) == len(SIGNATURES[name]):
            getattr(self.raw, name)(*arguments)
        else:
            raise ValueError("there is no such operation")
        if self.gpu.error != "GL_NO_ERROR":
            raise ValueError("the driver refuses it")

    def blob(self, number: int) -> bytes:
        return self.tape.blobs[_within(number, len(self.tape.blobs))]

    def takes(self, size: int, *key: int) -> None:
        self.memory[key] = size
        if sum(self.memory.values()) > MOST_BYTES:
            raise ValueError(f"buffers and images of a picture take at most {MOST_BYTES} bytes")

    def on_buffer(self, number: int, size: int) -> None:
        size = max(_within(size, MOST_BYTES), 1)
        self.takes(size, number)
        if number in self.buffers:
            held = self.buffers[number]
            held.gpu.orphan(size)
            held.size, held.written = size, b""
        else:
            self.buffers[number] = _Held(self.gpu.buffer(reserve=size, dynamic=True), size)

    def on_write(self, number: int, blob: int) -> None:
        held, data = self.buffers[number], self.blob(blob)
        if len(data) > held.size:
            raise ValueError(f"the buffer has {held.size} bytes, and the blob {len(data)}")
        held.gpu.write(data)
        held.written = data if len(data) >= len(held.written) else data + held.written[len(data) :]

    def on_uniform(self, binding: int, number: int, offset: int, size: int) -> None:
        held, end = self.buffers[number], _within(offset, MOST_BYTES) + _within(size, MOST_BYTES)
        if binding not in BINDINGS.values() or end > held.size:
            raise ValueError(f"a uniform block reads a part of a buffer, and this one has {held.size} bytes")
        held.gpu.bind_to_uniform_block(binding, offset=offset, size=size)
        self.blocks[binding], self.ranges[binding] = (held, end), size

    def on_program(self, number: int, vertex: int, fragment: int, *es: int) -> None:
        bodies = [self.blob(blob).decode() for blob in (vertex, fragment)]
        if any("#" in body for body in bodies):
            raise ValueError("programs of tapes have nothing left for GLSL's preprocessor")
        self.programs[number] = link(self.gpu, *(FRONT + body for body in bodies))

    def on_array(self, number: int, program: int, parts: list[Any], indices: int) -> None:
        linked, content, read = self.programs[program], [], []
        for buffer, stride, per_instance, inputs in parts:
            layout, *names = _content(linked, stride, per_instance, inputs)
            if names:
                content.append((self.buffers[buffer].gpu, layout, *names))
                last = max(offset + 4 * components for name, components, _, offset in inputs if name in names)
                read.append((self.buffers[buffer], stride, last, bool(per_instance)))
        held = self.buffers[indices]
        array = self.gpu.vertex_array(linked, content, index_buffer=held.gpu)
        self.arrays[number] = _Array(array, linked, held, read)

    def on_draw(self, number: int, mode: int, count: int, first: int, instances: int) -> None:
        array = self.arrays[number]
        indices = np.frombuffer(array.indices.written, "<u4", len(array.indices.written) // 4)
        if mode not in PRIMITIVES or _within(first, MOST_BYTES) + _within(count, MOST_BYTES) > len(indices):
            raise ValueError(f"points, lines or triangles are drawn with some of the {len(indices)} indices")
        vertices = int(indices[first : first + count].max(initial=0)) + 1
        for held, stride, last, per_instance in array.parts:
            if (_within(instances, 1 << 20) if per_instance else vertices) > (held.size - last) // stride + 1:
                raise ValueError(f"a buffer of {held.size} bytes has less vertices or instances")
        if not array.parts or (instances != 1 and not any(per_instance for *_, per_instance in array.parts)):
            raise ValueError("a draw has vertices, and as many instances as an input says")
        self.check_blocks(array.program)
        array.gpu.render(mode, count, first=first, instances=instances)

    def check_blocks(self, program: Program) -> None:
        for name, binding in BINDINGS.items():
            block = program.get(name, None)
            if block is not None:
                held, end = self.blocks[binding]
                if end > held.size or self.ranges[binding] < block.size:
                    raise ValueError(f"the block {name} has {block.size} bytes, more than the buffer gives it")

    def on_texture(self, unit: int, target: int, number: int) -> None:
        self.raw.glActiveTexture(gl.GL_TEXTURE0 + _within(unit, 16))
        if number not in self.textures:
            name = ctypes.c_uint()
            self.raw.glGenTextures(1, ctypes.byref(name))
            self.textures[number] = name.value
        self.raw.glBindTexture(target, self.textures[number])
        self.bound = (unit, number)

    def on_glDeleteTextures(self, numbers: list[int]) -> None:
        names = [self.textures.pop(number) for number in numbers]
        self.raw.glDeleteTextures(len(names), (ctypes.c_uint * len(names))(*names))

    def on_glTexParameterfv(self, target: int, name: int, values: list[float]) -> None:
        self.raw.glTexParameterfv(target, name, (ctypes.c_float * 4)(*values))

    def on_image(
        self, target: int, level: int, internal: int, size: list[int], format: int, kind: int, blob: int
    ) -> None:
        texels = self.blob(blob)
        number = prod(_within(side, 1 << 15) for side in size)
        if len(size) not in (2, 3) or len(texels) < number * ELEMENT[format, kind]:
            raise ValueError("the blob has too few bytes for the image")
        self.takes(number * WIDEST_TEXEL, *self.bound, target, level)
        self.raw.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
        upload = self.raw.glTexImage3D if len(size) == 3 else self.raw.glTexImage2D
        upload(target, level, internal, *size, 0, format, kind, ctypes.cast(ctypes.c_char_p(texels), ctypes.c_void_p))


def _within(number: int, end: int) -> int:
    """The number.  Raises ValueError unless it is a whole one from 0 to ``end``, without that."""
    if type(number) is not int or not 0 <= number < end:
        raise ValueError(f"a whole number from 0 to {end - 1} is needed, not {number!r}"[:100])
    return number


def _content(program: Program, stride: int, per_instance: int, inputs: list[Any]) -> list[str]:
    """An array's part as moderngl wants it: "3f 12x 4f" and the names of the inputs that the program has.

    Raises ValueError if the inputs do not lie one behind the other within the stride.
    """
    words, names, at = [], [], 0
    for name, components, kind, offset in [*inputs, ("", 0, "", _within(stride, MOST_STRIDE + 1))]:
        known = not name or (components in (1, 2, 3, 4) and kind in ("f", "u"))
        if not known or _within(offset, MOST_STRIDE + 1) < at:
            raise ValueError("inputs are 1 to 4 numbers, f or u, one behind the other within the stride")
        if offset > at:
            words.append(f"{offset - at}x")
            at = offset
        if name in program:
            words.append(f"{components}{'u4' if kind == 'u' else 'f'}")
            names.append(name)
            at += 4 * components
    return [" ".join(words) + ("/i" if per_instance else "/v"), *names]
