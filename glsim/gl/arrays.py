"""Vertex arrays: section 2.8 of the specification.

The arrays are read when glDrawArrays or glDrawElements is called, as a driver does.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.gl.arguments import array_from
from glsim.gl.texenv import unit_number
from glsim.machine import constants
from glsim.machine import constants as gl
from glsim.machine.assembly import MINIMUM
from glsim.machine.constants import Enum
from glsim.machine.errors import invalid_enum, invalid_operation, invalid_value
from glsim.machine.frame import ROW, ROW_BYTES, Draw, Vertices
from glsim.machine.machine import Machine
from glsim.machine.pixels import as_unit
from glsim.machine.state import TEXTURE_UNITS
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


def elements(m: Machine, pointer: Pointer, first: int, count: int) -> NDArray[Any]:
    """The ``count`` elements of a vertex array from ``first`` on: (count, size), in the number type of the array."""
    dtype = np.dtype(DTYPES[pointer.type])
    width = pointer.size * dtype.itemsize
    stride = pointer.stride or width
    if pointer.buffer:
        memory: NDArray[np.uint8] = m.objects.buffers[pointer.buffer].data[max(pointer.offset, 0) :]
    else:
        memory = pointer.data.view(np.uint8)
    end = (first + count - 1) * stride + width
    if first < 0 or end > memory.size:
        there = max(0, (memory.size - width) // stride + 1)
        raise ValueError(f"element {first + count - 1} was asked of a vertex array of {there} elements")
    if stride % dtype.itemsize == 0 and memory.size % dtype.itemsize == 0:
        return np.ndarray((count, pointer.size), dtype, memory, first * stride, (stride, dtype.itemsize))
    rows = np.ndarray((count, width), np.uint8, memory, first * stride, (stride, 1))
    return np.ascontiguousarray(rows).view(dtype)


def as_colour(values: NDArray[Any]) -> NDArray[Any]:
    """Integers map linearly onto [0, 1] or [-1, 1]; floats stay, uncopied."""
    return values if values.dtype.kind == "f" else as_unit(values)


# client array -> column of frame.COLUMNS, components, values that fill what the array lacks
EXTRA: dict[Any, tuple[str, tuple[float, ...]]] = {
    gl.GL_TEXTURE_COORD_ARRAY: ("texcoord0", (0.0, 0.0, 0.0, 1.0)),
    **{
        (gl.GL_TEXTURE_COORD_ARRAY, unit): (f"texcoord{unit}", (0.0, 0.0, 0.0, 1.0)) for unit in range(1, TEXTURE_UNITS)
    },
    gl.GL_SECONDARY_COLOR_ARRAY: ("secondary_color", (0.0, 0.0, 0.0, 1.0)),
    gl.GL_FOG_COORDINATE_ARRAY: ("fog_coord", (0.0,)),
    gl.GL_EDGE_FLAG_ARRAY: ("edge_flag", (1.0,)),
}
Columns = dict[str, NDArray[np.float32]]


def gather(m: Machine, first: int, count: int) -> tuple[NDArray[np.float32], Columns] | None:
    """Rows (count, 10) and other columns (count, width) from the enabled arrays; None without vertex array."""
    vertex = client(m, gl.GL_VERTEX_ARRAY)
    if not _usable(m, vertex):
        return None
    positions = elements(m, vertex.pointer, first, count)
    rows = np.empty((count, ROW), np.float32)
    size = vertex.pointer.size
    rows[:, : min(size, 3)] = positions[:, :3]
    if size == 2:
        rows[:, 2] = 0.0
    columns = {"w": positions[:, 3:4].astype(np.float32)} if size == 4 else {}
    normal = client(m, gl.GL_NORMAL_ARRAY)
    rows[:, 3:6] = as_colour(elements(m, normal.pointer, first, count)) if _usable(m, normal) else (m.nx, m.ny, m.nz)
    color = client(m, gl.GL_COLOR_ARRAY)
    if _usable(m, color):
        rows[:, 6 : 6 + color.pointer.size] = as_colour(elements(m, color.pointer, first, count))
        if color.pointer.size == 3:
            rows[:, 9] = 1.0
    else:
        rows[:, 6:10] = m.red, m.green, m.blue, m.alpha
    for array, (name, fill) in EXTRA.items():
        state = client(m, array)
        if _usable(m, state):
            values = elements(m, state.pointer, first, count)
            values = as_colour(values) if array == gl.GL_SECONDARY_COLOR_ARRAY else values
            columns[name] = np.tile(np.array(fill, np.float32), (count, 1))
            columns[name][:, : values.shape[1]] = values
    return rows, columns


def _usable(m: Machine, array: Client) -> bool:
    there = array.pointer.data is not None or m.objects.buffers.get(array.pointer.buffer) is not None
    return array.enabled and there


def _check_mode(mode: int) -> None:
    if mode not in MINIMUM:
        raise invalid_enum("mode", mode, "one of the ten primitives GL_POINTS to GL_POLYGON")


def glDrawArrays(m: Machine, mode: int, first: int, count: int) -> None:
    _check_mode(mode)
    if count < 0 or first < 0:
        raise invalid_value("first and count", (first, count), "at least 0")
    if count:
        _add(m, mode, int(first), int(count), None)


def _add(m: Machine, mode: int, first: int, count: int, indices: Any) -> None:
    """Draw the ``count`` elements from ``first`` on.  indices: their order, relative to ``first``, or None."""
    key = _buffers_key(m, first, count)
    if key is None:
        found = gather(m, first, count)
        if found is not None:
            m.add_draw(mode, *found, indices)
        return
    kept = m.objects.buffers[key[0]].vertices
    if key not in kept:
        found = gather(m, first, count)
        assert found is not None
        if len(kept) >= MOST_KEPT:
            kept.clear()
        current = {name: np.array([value], np.float32) for name, value in m.current.items()}
        kept[key] = Vertices(found[0], {**current, **found[1]}, [], static=True)
    m.add(Draw(mode, 0, count, indices, m.matrices(), m.material, m.snapshot(), kept[key]))


MOST_KEPT = 64


def _buffers_key(m: Machine, first: int, count: int) -> tuple[Any, ...] | None:
    """All that determines the vertices, as a key, if the enabled arrays lie in buffer objects; else None.

    Draws with the same key have the same vertices, so the GPU keeps these.  key[0]: buffer object of the positions.
    """
    vertex = m.client.arrays.get(gl.GL_VERTEX_ARRAY)
    if vertex is None or not vertex.enabled or m.objects.buffers.get(vertex.pointer.buffer) is None:
        return None
    parts: list[Any] = [vertex.pointer.buffer, first, count]
    for array, state in m.client.arrays.items():
        if state.enabled:
            buffer = m.objects.buffers.get(state.pointer.buffer)
            if buffer is None or buffer.mapped:
                return None
            parts += [array, state.pointer, buffer.version]
    parts += [m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha, *m.current.values()]
    return tuple(parts)


def glMultiDrawArrays(m: Machine, mode: int, first: Any, count: Any, primcount: int) -> None:
    for k in range(primcount):
        glDrawArrays(m, mode, first[k], count[k])


INDEX_TYPES = (gl.GL_UNSIGNED_BYTE, gl.GL_UNSIGNED_SHORT, gl.GL_UNSIGNED_INT)


def glDrawElements(m: Machine, mode: int, count: int, type: int, indices: Any) -> None:
    _check_mode(mode)
    if count < 0:
        raise invalid_value("count", count, "at least 0")
    if type not in INDEX_TYPES:
        raise invalid_enum("type", type, "GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or GL_UNSIGNED_INT")
    dtype = DTYPES[type]
    numbers: NDArray[Any]
    if m.client.element_buffer and not isinstance(indices, bytes):  # bytes: from a display list
        start, size = offset_from(indices), count * np.dtype(dtype).itemsize
        numbers = np.frombuffer(m.objects.buffers[m.client.element_buffer].data[start : start + size].tobytes(), dtype)
    else:
        numbers = array_from(_checked(indices, dtype), dtype, "indices").view(dtype)
    if numbers.size < count:
        raise ValueError(f"indices holds {numbers.size} numbers, but count is {count}")
    numbers = numbers[:count].astype(np.uint32)
    if not count:
        return
    least, most = int(numbers.min()), int(numbers.max())
    _add(m, mode, least, most - least + 1, numbers - np.uint32(least))


def _checked(indices: Any, dtype: type) -> Any:
    """Indices that fit their type as they are: neither fractions nor numbers that would wrap."""
    if isinstance(indices, (bytes, bytearray, memoryview)) or indices is None:
        return indices
    array = np.asarray(indices)
    if array.dtype.kind not in "iu":
        raise TypeError(f"indices must be integers, not {array.dtype}")
    least, most = (int(array.min()), int(array.max())) if array.size else (0, 0)
    if least < 0 or most > np.iinfo(dtype).max:
        raise ValueError(f"indices from {least} to {most} do not fit the type, which holds 0 to {np.iinfo(dtype).max}")
    return array


def glDrawRangeElements(m: Machine, mode: int, start: int, end: int, count: int, type: int, indices: Any) -> None:
    if end < start:
        raise invalid_value("end", end, f"at least start ({start})")
    glDrawElements(m, mode, count, type, indices)


def glMultiDrawElements(m: Machine, mode: int, count: Any, type: int, indices: Any, primcount: int) -> None:
    for k in range(primcount):
        glDrawElements(m, mode, count[k], type, indices[k])


def glArrayElement(m: Machine, i: int) -> None:
    if i < 0:
        raise invalid_value("i", i, "at least 0")
    normal, color = client(m, gl.GL_NORMAL_ARRAY), client(m, gl.GL_COLOR_ARRAY)
    if _usable(m, normal):
        m.nx, m.ny, m.nz = as_colour(elements(m, normal.pointer, i, 1))[0].tolist()
    if _usable(m, color):
        values = as_colour(elements(m, color.pointer, i, 1))[0].tolist()
        m.red, m.green, m.blue, m.alpha = [*values, 1.0][:4]
    for array, (name, fill) in EXTRA.items():
        state = client(m, array)
        if _usable(m, state):
            given = elements(m, state.pointer, i, 1)[0].tolist()
            m.set_current(name, (*given, *fill[len(given) :]))
    if _usable(m, client(m, gl.GL_VERTEX_ARRAY)):
        if m.inside is None:
            raise invalid_operation("a vertex is only allowed between glBegin and glEnd")
        found = gather(m, i, 1)
        assert found is not None
        if "w" in found[1]:
            m.columns.append(("w", m.stream.tell() // ROW_BYTES, found[1]["w"]))
        m.write(found[0].tobytes())
