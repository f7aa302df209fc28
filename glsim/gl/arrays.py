"""Vertex arrays: where they lie (section 2.8 of the specification).  drawarrays.py reads them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from glsim.gl.arguments import array_from
from glsim.gl.texenv import unit_number
from glsim.machine import constants
from glsim.machine import constants as gl
from glsim.machine.constants import Enum
from glsim.machine.errors import invalid_enum, invalid_value
from glsim.machine.machine import Machine
from glsim.machine.types import DTYPES

ARRAYS: dict[int, Enum] = {
    int(array): array
    for array in (
        gl.GL_VERTEX_ARRAY, gl.GL_NORMAL_ARRAY, gl.GL_COLOR_ARRAY, gl.GL_INDEX_ARRAY, gl.GL_TEXTURE_COORD_ARRAY,
        gl.GL_EDGE_FLAG_ARRAY,
        gl.GL_FOG_COORDINATE_ARRAY, gl.GL_SECONDARY_COLOR_ARRAY,
    )
}  # fmt: skip


class Pointer(NamedTuple):
    """What glVertexPointer and its kin remember; ``data`` is None until they are called."""

    size: int = 4
    type: int = gl.GL_FLOAT
    stride: int = 0
    data: Any = None
    buffer: int = 0  # the buffer object that held the array, and where in it
    offset: int = 0


class Client(NamedTuple):
    """State of one vertex array."""

    enabled: bool = False
    pointer: Pointer = Pointer()


# number types that a client array takes (table 2.4); the others take all
SIGNED = (gl.GL_SHORT, gl.GL_INT, gl.GL_FLOAT, gl.GL_DOUBLE)
POINTER_TYPES: dict[int, tuple[Enum, ...]] = {
    gl.GL_VERTEX_ARRAY: SIGNED,
    gl.GL_NORMAL_ARRAY: (gl.GL_BYTE, *SIGNED),
    gl.GL_TEXTURE_COORD_ARRAY: SIGNED,
    gl.GL_FOG_COORDINATE_ARRAY: (gl.GL_FLOAT, gl.GL_DOUBLE),
    gl.GL_INDEX_ARRAY: (gl.GL_UNSIGNED_BYTE, *SIGNED),
}


def _set_pointer(m: Machine, array: int, pointer: Pointer, sizes: tuple[int, ...]) -> None:
    if pointer.size not in sizes:
        raise invalid_value("size", pointer.size, " or ".join(map(str, sizes)))
    allowed = POINTER_TYPES.get(array)
    if pointer.type not in (allowed or DTYPES):
        words = " or ".join(map(repr, allowed)) if allowed else "GL_FLOAT, GL_UNSIGNED_BYTE or another number type"
        raise invalid_enum("type", pointer.type, words)
    if pointer.stride < 0:
        raise invalid_value("stride", pointer.stride, "at least 0")
    if m.client.array_buffer:
        pointer = pointer._replace(data=None, buffer=m.client.array_buffer, offset=offset_from(pointer.data))
    elif pointer.data is not None:
        pointer = pointer._replace(data=array_from(pointer.data, DTYPES[pointer.type], "pointer"))
    key = array_key(m, array)
    m.client.arrays[key] = client(m, key)._replace(pointer=pointer)


def offset_from(value: Any) -> int:
    """Where in a buffer object: None, a number, or as PyOpenGL wants it a ctypes.c_void_p."""
    offset = getattr(value, "value", value)
    return 0 if offset is None else int(offset)


def array_key(m: Machine, array: int) -> Any:
    """The key of a vertex array in ``client.arrays``: (array, unit) for texture coordinates of units from 1 on."""
    return (array, m.client.unit) if array == gl.GL_TEXTURE_COORD_ARRAY and m.client.unit else array


def client(m: Machine, key: Any) -> Client:
    return m.client.arrays.get(key) or (Client(pointer=Pointer(3)) if key == gl.GL_SECONDARY_COLOR_ARRAY else Client())


def glVertexPointer(m: Machine, size: int, type: int, stride: int, pointer: Any) -> None:
    _set_pointer(m, gl.GL_VERTEX_ARRAY, Pointer(size, type, stride, pointer), (2, 3, 4))


def glNormalPointer(m: Machine, type: int, stride: int, pointer: Any) -> None:
    _set_pointer(m, gl.GL_NORMAL_ARRAY, Pointer(3, type, stride, pointer), (3,))


def glColorPointer(m: Machine, size: int, type: int, stride: int, pointer: Any) -> None:
    _set_pointer(m, gl.GL_COLOR_ARRAY, Pointer(size, type, stride, pointer), (3, 4))


def glSecondaryColorPointer(m: Machine, size: int, type: int, stride: int, pointer: Any) -> None:
    _set_pointer(m, gl.GL_SECONDARY_COLOR_ARRAY, Pointer(size, type, stride, pointer), (3,))


def glTexCoordPointer(m: Machine, size: int, type: int, stride: int, pointer: Any) -> None:
    _set_pointer(m, gl.GL_TEXTURE_COORD_ARRAY, Pointer(size, type, stride, pointer), (1, 2, 3, 4))


def glFogCoordPointer(m: Machine, type: int, stride: int, pointer: Any) -> None:
    _set_pointer(m, gl.GL_FOG_COORDINATE_ARRAY, Pointer(1, type, stride, pointer), (1,))


def glIndexPointer(m: Machine, type: int, stride: int, pointer: Any) -> None:
    _set_pointer(m, gl.GL_INDEX_ARRAY, Pointer(1, type, stride, pointer), (1,))


def glEdgeFlagPointer(m: Machine, stride: int, pointer: Any) -> None:
    _set_pointer(m, gl.GL_EDGE_FLAG_ARRAY, Pointer(1, gl.GL_UNSIGNED_BYTE, stride, pointer), (1,))


def _set_client_state(m: Machine, array: int, enabled: bool) -> None:
    if array not in ARRAYS:
        raise invalid_enum("array", array, "GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY or another vertex array")
    key = array_key(m, array)
    m.client.arrays[key] = client(m, key)._replace(enabled=enabled)


def glEnableClientState(m: Machine, array: int) -> None:
    _set_client_state(m, array, True)


def glDisableClientState(m: Machine, array: int) -> None:
    _set_client_state(m, array, False)


def glClientActiveTexture(m: Machine, texture: int) -> None:
    m.client.unit = unit_number(texture)


# format of glInterleavedArrays: texture coordinates, colour size and type, normal?, vertex size (table 2.5)
INTERLEAVED: dict[str, tuple[int, int, int, bool, int]] = {
    "GL_V2F": (0, 0, 0, False, 2),
    "GL_V3F": (0, 0, 0, False, 3),
    "GL_C4UB_V2F": (0, 4, gl.GL_UNSIGNED_BYTE, False, 2),
    "GL_C4UB_V3F": (0, 4, gl.GL_UNSIGNED_BYTE, False, 3),
    "GL_C3F_V3F": (0, 3, gl.GL_FLOAT, False, 3),
    "GL_N3F_V3F": (0, 0, 0, True, 3),
    "GL_C4F_N3F_V3F": (0, 4, gl.GL_FLOAT, True, 3),
    "GL_T2F_V3F": (2, 0, 0, False, 3),
    "GL_T4F_V4F": (4, 0, 0, False, 4),
    "GL_T2F_C4UB_V3F": (2, 4, gl.GL_UNSIGNED_BYTE, False, 3),
    "GL_T2F_C3F_V3F": (2, 3, gl.GL_FLOAT, False, 3),
    "GL_T2F_N3F_V3F": (2, 0, 0, True, 3),
    "GL_T2F_C4F_N3F_V3F": (2, 4, gl.GL_FLOAT, True, 3),
    "GL_T4F_C4F_N3F_V4F": (4, 4, gl.GL_FLOAT, True, 4),
}
FORMATS = {int(getattr(constants, name)): layout for name, layout in INTERLEAVED.items()}


def glInterleavedArrays(m: Machine, format: int, stride: int, pointer: Any) -> None:
    layout = FORMATS.get(format)
    if layout is None:
        raise invalid_enum("format", format, "an interleaved format such as GL_N3F_V3F")
    if stride < 0:
        raise invalid_value("stride", stride, "at least 0")
    texture, color, color_type, normal, vertex = layout
    data = None if m.client.array_buffer else array_from(pointer, np.float32, "pointer").view(np.uint8)
    start, offset = offset_from(pointer) if m.client.array_buffer else 0, 0
    parts = (
        (gl.GL_TEXTURE_COORD_ARRAY, texture, gl.GL_FLOAT),
        (gl.GL_COLOR_ARRAY, color, color_type),
        (gl.GL_NORMAL_ARRAY, 3 if normal else 0, gl.GL_FLOAT),
        (gl.GL_VERTEX_ARRAY, vertex, gl.GL_FLOAT),
    )
    total = sum(_bytes(size, kind) for _, size, kind in parts)
    for array, size, kind in parts:
        key = array_key(m, array)
        if size:
            memory = None if data is None else data[offset:]
            m.client.arrays[key] = Client(
                True, Pointer(size, kind, stride or total, memory, m.client.array_buffer, start + offset)
            )
            offset += _bytes(size, kind)
        else:
            m.client.arrays[key] = client(m, key)._replace(enabled=False)
    for array in (gl.GL_INDEX_ARRAY, gl.GL_EDGE_FLAG_ARRAY):
        m.client.arrays[array] = client(m, array)._replace(enabled=False)


def _bytes(size: int, kind: int) -> int:
    return size * np.dtype(DTYPES[kind]).itemsize if size else 0
