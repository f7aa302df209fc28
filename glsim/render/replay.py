"""Playing a tape with moderngl: what ``glsim draw`` does with a file ending in .glt."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.interrupts import uninterrupted
from glsim.render.compile import link
from glsim.render.context import own_screen
from glsim.render.gpu import GPU, Buffer, Commands, Program, VertexArray
from glsim.render.programs import FRONT
from glsim.render.raw import SIGNATURES
from glsim.render.tape import Operation, Picture, Tape, TapeError

# bytes that one element of an image with this format and type has
ELEMENT = {
    (int(format), int(kind)): components * size
    for format, components in ((gl.GL_RGBA, 4), (gl.GL_RED, 1), (gl.GL_DEPTH_COMPONENT, 1))
    for kind, size in ((gl.GL_UNSIGNED_BYTE, 1), (gl.GL_FLOAT, 4))
}


def replayed(tape: Tape, number: int = 0) -> NDArray[np.uint8]:
    """The picture with this number on a tape, drawn here: (height, width, 4) uint8, top row first.

    Raises TapeError if the tape has no such picture, or operations that are none.
    """
    if not 0 <= number < len(tape.pictures):
        raise TapeError(f"this tape has {len(tape.pictures)} pictures, so none with number {number}")
    with own_screen(tape.width, tape.height, samples=tape.samples) as screen:
        with uninterrupted(), screen.ctx:
            screen._target.use()
            _Player(tape, screen.ctx, screen._raw).play(tape.pictures[number])
        return screen.pixels()


class _Player:
    """One picture's buffers, programs, arrays and textures by their numbers on the tape."""

    def __init__(self, tape: Tape, gpu: GPU, raw: Commands) -> None:
        self.tape, self.gpu, self.raw = tape, gpu, raw
        self.buffers: dict[int, Buffer] = {}
        self.programs: dict[int, Program] = {}
        self.arrays: dict[int, VertexArray] = {}
        self.textures: dict[int, int] = {}

    def play(self, picture: Picture) -> None:
        for at, operation in enumerate(picture.operations):
            try:
                self.operate(operation)
            except (KeyError, IndexError, TypeError, ValueError, ctypes.ArgumentError) as error:
                raise TapeError(f"operation {at} of the tape, {str(operation)[:80]}: {error!r}") from None

    def operate(self, operation: Operation) -> None:
        name, *arguments = operation
        own = getattr(self, f"on_{name}", None)
        if own is not None:
            own(*arguments)
        elif name in SIGNATURES:
            getattr(self.raw, name)(*arguments)
        else:
            raise ValueError("there is no such operation")

    def on_buffer(self, number: int, size: int) -> None:
        if number in self.buffers:
            self.buffers[number].orphan(max(size, 1))
        else:
            self.buffers[number] = self.gpu.buffer(reserve=max(size, 1), dynamic=True)

    def on_write(self, number: int, blob: int) -> None:
        self.buffers[number].write(self.tape.blobs[blob])

    def on_uniform(self, binding: int, number: int, offset: int, size: int) -> None:
        self.buffers[number].bind_to_uniform_block(binding, offset=offset, size=size)

    def on_program(self, number: int, vertex: int, fragment: int, *es: int) -> None:
        texts = (FRONT + self.tape.blobs[blob].decode() for blob in (vertex, fragment))
        self.programs[number] = link(self.gpu, *texts)

    def on_array(self, number: int, program: int, parts: list[Any], indices: int) -> None:
        linked = self.programs[program]
        content = [(self.buffers[buffer], *_content(linked, *rest)) for buffer, *rest in parts]
        used = [entry for entry in content if len(entry) > 2]
        self.arrays[number] = self.gpu.vertex_array(linked, used, index_buffer=self.buffers[indices])

    def on_draw(self, number: int, mode: int, count: int, first: int, instances: int) -> None:
        self.arrays[number].render(mode, count, first=first, instances=instances)

    def on_texture(self, unit: int, target: int, number: int) -> None:
        self.raw.glActiveTexture(gl.GL_TEXTURE0 + unit)
        if number not in self.textures:
            name = ctypes.c_uint()
            self.raw.glGenTextures(1, ctypes.byref(name))
            self.textures[number] = name.value
        self.raw.glBindTexture(target, self.textures[number])

    def on_glDeleteTextures(self, numbers: list[int]) -> None:
        names = [self.textures.pop(number) for number in numbers]
        self.raw.glDeleteTextures(len(names), (ctypes.c_uint * len(names))(*names))

    def on_glTexParameterfv(self, target: int, name: int, values: list[float]) -> None:
        self.raw.glTexParameterfv(target, name, (ctypes.c_float * 4)(*values))

    def on_image(
        self, target: int, level: int, internal: int, size: list[int], format: int, kind: int, blob: int
    ) -> None:
        texels = self.tape.blobs[blob]
        if len(texels) < int(np.prod(size)) * ELEMENT[format, kind]:
            raise ValueError("the blob has too few bytes for the image")
        self.raw.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
        upload = self.raw.glTexImage3D if len(size) == 3 else self.raw.glTexImage2D
        upload(target, level, internal, *size, 0, format, kind, ctypes.cast(texels, ctypes.c_void_p))


def _content(program: Program, stride: int, per_instance: int, inputs: list[Any]) -> list[str]:
    """An array's part as moderngl wants it: "3f 12x 4f" and the names of the inputs that the program has."""
    words, names, at = [], [], 0
    for name, components, kind, offset in [*inputs, ("", 0, "", stride)]:
        if offset > at:
            words.append(f"{offset - at}x")
            at = offset
        if name in program:
            words.append(f"{components}{'u4' if kind == 'u' else 'f'}")
            names.append(name)
            at += 4 * components
    return [" ".join(words) + ("/i" if per_instance else "/v"), *names]
