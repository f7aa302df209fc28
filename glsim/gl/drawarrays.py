"""Drawing from vertex arrays: they are read when glDrawArrays or glDrawElements is called, as a driver does."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.gl.arguments import array_from
from glsim.gl.arrays import Client, Pointer, client, offset_from
from glsim.machine import constants as gl
from glsim.machine.assembly import MINIMUM
from glsim.machine.errors import invalid_enum, invalid_operation, invalid_value
from glsim.machine.frame import ROW, ROW_BYTES, Draw, Vertices
from glsim.machine.machine import Machine
from glsim.machine.pixels import as_unit
from glsim.machine.state import TEXTURE_UNITS
from glsim.machine.types import DTYPES

MOST_CACHED = 64  # vertices of draws from one buffer object


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
        length = max(0, (memory.size - width) // stride + 1)
        raise ValueError(f"element {first + count - 1} was asked of a vertex array of {length} elements")
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
    if not is_usable(m, vertex):
        return None
    positions = elements(m, vertex.pointer, first, count)
    rows = np.empty((count, ROW), np.float32)
    size = vertex.pointer.size
    rows[:, : min(size, 3)] = positions[:, :3]
    if size == 2:
        rows[:, 2] = 0.0
    columns = {"w": positions[:, 3:4].astype(np.float32)} if size == 4 else {}
    normal = client(m, gl.GL_NORMAL_ARRAY)
    rows[:, 3:6] = as_colour(elements(m, normal.pointer, first, count)) if is_usable(m, normal) else (m.nx, m.ny, m.nz)
    color = client(m, gl.GL_COLOR_ARRAY)
    if is_usable(m, color):
        rows[:, 6 : 6 + color.pointer.size] = as_colour(elements(m, color.pointer, first, count))
        if color.pointer.size == 3:
            rows[:, 9] = 1.0
    else:
        rows[:, 6:10] = m.red, m.green, m.blue, m.alpha
    for array, (name, fill) in EXTRA.items():
        state = client(m, array)
        if is_usable(m, state):
            values = elements(m, state.pointer, first, count)
            values = as_colour(values) if array == gl.GL_SECONDARY_COLOR_ARRAY else values
            columns[name] = np.tile(np.array(fill, np.float32), (count, 1))
            columns[name][:, : values.shape[1]] = values
    return rows, columns


def is_usable(m: Machine, array: Client) -> bool:
    has_data = array.pointer.data is not None or m.objects.buffers.get(array.pointer.buffer) is not None
    return array.enabled and has_data


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
        gathered = gather(m, first, count)
        if gathered is not None:
            m.add_draw(mode, *gathered, indices)
        return
    cache = m.objects.buffers[key[0]].vertices
    if key not in cache:
        gathered = gather(m, first, count)
        assert gathered is not None
        if len(cache) >= MOST_CACHED:
            cache.clear()
        current = {name: np.array([value], np.float32) for name, value in m.current.items()}
        cache[key] = Vertices(gathered[0], {**current, **gathered[1]}, [], static=True)
    m.add(Draw(mode, 0, count, indices, m.matrices(), m.material, m.snapshot(), cache[key]))


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
    if is_usable(m, normal):
        m.nx, m.ny, m.nz = as_colour(elements(m, normal.pointer, i, 1))[0].tolist()
    if is_usable(m, color):
        values = as_colour(elements(m, color.pointer, i, 1))[0].tolist()
        m.red, m.green, m.blue, m.alpha = [*values, 1.0][:4]
    for array, (name, fill) in EXTRA.items():
        state = client(m, array)
        if is_usable(m, state):
            given = elements(m, state.pointer, i, 1)[0].tolist()
            m.set_current(name, (*given, *fill[len(given) :]))
    if is_usable(m, client(m, gl.GL_VERTEX_ARRAY)):
        if m.inside is None:
            raise invalid_operation("a vertex is only allowed between glBegin and glEnd")
        gathered = gather(m, i, 1)
        assert gathered is not None
        if "w" in gathered[1]:
            m.columns.append(("w", m.stream.tell() // ROW_BYTES, gathered[1]["w"]))
        m.write(gathered[0].tobytes())
