"""A tape: what the renderer told the GPU, written down, so that others can do the same: a browser, or moderngl again.

A tape holds one or more pictures, each a list of operations that begins with nothing, and the data (blobs) that the
operations of all pictures share.  A blob is known by its SHA-256, so equal data are stored once, in a tape and on a
page with several tapes.

The file (ending .glt), all numbers little-endian:

    bytes 0-7    b"glsimtap"
    8-11         version of the format, 1
    12-15        length of the JSON in bytes, padded with spaces to a multiple of 4
    16-          the JSON, in UTF-8; then the blobs in the JSON's order, each padded with zeros to a multiple of 4

The JSON is an object:

    made_by      "glsim 1.2.3"
    width, height, samples      of the framebuffer, which has RGBA of 8 bits, 24 bits of depth and 8 of stencil
    bindings, samplers          name of each uniform block, or sampler -> its binding, or texture unit
    es                          what stands in front of a program's texts in OpenGL ES, instead of #version 330 core
    blobs                       [[first 32 hexadecimal digits of the SHA-256, length], ...]
    pictures                    [{"name": ..., "operations": [[name, argument, ...], ...]}, ...]

Operations; buffers, programs and arrays are numbers, a blob is its number in ``blobs``:

    ["buffer", number, size]                   take new memory for a buffer
    ["write", number, blob]                    copy to the beginning of a buffer
    ["uniform", binding, buffer, offset, size] what a uniform block reads
    ["program", number, vertex, fragment, vertex in ES, fragment in ES]   blobs with the shaders' texts: shaders/ with
                                               the constants folded (render/specialise.py)
    ["array", number, program, [[buffer, stride, per instance, [[input, components, "f" or "u", offset], ...]], ...],
        index buffer]                          a program's inputs
    ["draw", array, mode, count, first, instances]  indexed, with 32 bits for each index
    ["texture", unit, target, number]          bind a texture to a unit
    ["image", target, level, internal format, [width, height(, depth)], format, type, blob]   to the bound texture
    ["glDepthFunc", 513] ...                   the commands of STATE, with their arguments
    ["glTexParameterfv", target, name, [4 numbers]], ["glDeleteTextures", [number, ...]]

A picture begins with a framebuffer of (0, 0, 0, 0), depth 1 and stencil 0, and OpenGL's initial state.
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass, field
from hashlib import sha256
from typing import Any

from glsim.render.compile import BINDINGS, SAMPLERS
from glsim.render.programs import ES_FRONT
from glsim.version import __version__

MAGIC, VERSION = b"glsimtap", 1
HEADER = struct.Struct("<8sII")

SAMPLES = (0, 2, 4, 8, 16, 32)
# commands of numbers alone, without addresses or names of objects: a driver takes or refuses whatever stands there
STATE = {
    "glEnable", "glDisable", "glViewport", "glDepthRange", "glDepthFunc", "glDepthMask", "glColorMask", "glCullFace",
    "glFrontFace", "glClear", "glClearColor", "glClearDepth", "glClearStencil", "glProvokingVertex", "glScissor",
    "glPolygonOffset", "glStencilFunc", "glStencilOp", "glStencilMask", "glBlendFuncSeparate", "glBlendEquation",
    "glBlendColor", "glLogicOp", "glSampleCoverage", "glTexParameterf", "glTexParameteri",
}  # fmt: skip

Operation = list[Any]


class TapeError(ValueError):
    """These bytes are no tape, or one of another version."""


@dataclass
class Picture:
    name: str
    operations: list[Operation] = field(default_factory=list)


@dataclass
class Tape:
    """width, height, samples: of the framebuffer.  blobs: in the order of their numbers."""

    width: int
    height: int
    samples: int = 0
    pictures: list[Picture] = field(default_factory=list)
    blobs: list[bytes] = field(default_factory=list)
    made_by: str = f"glsim {__version__}"

    def __post_init__(self) -> None:
        self._numbers = {blob: number for number, blob in enumerate(self.blobs)}

    def blob(self, data: bytes) -> int:
        """The number of a blob, which is stored if it is new."""
        number = self._numbers.get(data)
        if number is None:
            number = self._numbers[data] = len(self.blobs)
            self.blobs.append(data)
        return number

    def to_bytes(self) -> bytes:
        head = {
            "made_by": self.made_by,
            "width": self.width,
            "height": self.height,
            "samples": self.samples,
            "bindings": BINDINGS,
            "samplers": SAMPLERS,
            "es": ES_FRONT,
            "blobs": [[_name(blob), len(blob)] for blob in self.blobs],
            "pictures": [{"name": picture.name, "operations": picture.operations} for picture in self.pictures],
        }
        text = json.dumps(head, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        padded = (blob + bytes(-len(blob) % 4) for blob in self.blobs)
        return HEADER.pack(MAGIC, VERSION, len(text)) + text + b"".join(padded)

    @classmethod
    def from_bytes(cls, data: bytes) -> Tape:
        """The tape in these bytes.  Raises TapeError with a sentence if there is none, or a damaged one.

        What the operations do to each other is checked when they are played (replay.py).
        """
        if len(data) < HEADER.size or data[:8] != MAGIC:
            raise TapeError("these bytes are no tape of glsim: a tape begins with the word glsimtap")
        _, version, length = HEADER.unpack_from(data)
        if version != VERSION:
            raise TapeError(f"this tape has version {version} of the format, and this glsim reads version {VERSION}")
        at = HEADER.size + length
        try:
            head = json.loads(data[HEADER.size : at], parse_constant=_no_number)
            made_by, bindings = str(head["made_by"]), (head["bindings"], head["samplers"])
            width, height, samples = (_whole(head[name]) for name in ("width", "height", "samples"))
            pictures = [Picture(str(one["name"]), _operations(one["operations"])) for one in head["pictures"]]
            sizes = [(str(name), _whole(size)) for name, size in head["blobs"]]
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            raise TapeError(f"this tape is damaged: its head cannot be read ({type(error).__name__})") from None
        if not (1 <= width <= 16384 and 1 <= height <= 16384) or samples not in SAMPLES:
            raise TapeError(f"this tape is damaged: no picture has {width} x {height} pixels with {samples} samples")
        if bindings != (BINDINGS, SAMPLERS):
            raise TapeError(f"this tape is for other shaders: play it with the glsim that made it, {made_by[:40]}")
        blobs = []
        for name, size in sizes:
            blobs.append(data[at : at + size])
            if _name(blobs[-1]) != name:
                raise TapeError("this tape is damaged: the data of a blob are not those that its name promises")
            at += size + -size % 4
        if at != len(data):
            raise TapeError(f"this tape is damaged: it has {len(data)} bytes, and its head tells of {at}")
        return cls(width, height, samples, pictures, blobs, made_by)


def _whole(value: Any) -> int:
    """Raises TypeError unless the value is a whole number from 0 on."""
    if type(value) is not int or value < 0:
        raise TypeError
    return value


def _no_number(name: str) -> float:
    """For Infinity and NaN, which Python's JSON has and a browser's has not."""
    raise ValueError


def _operations(value: Any) -> list[Operation]:
    """Raises TypeError unless the value is a list of lists that begin with a name."""
    if not isinstance(value, list):
        raise TypeError
    if not all(isinstance(one, list) and one and isinstance(one[0], str) for one in value):
        raise TypeError
    return value


def _name(blob: bytes) -> str:
    return sha256(blob).hexdigest()[:32]
