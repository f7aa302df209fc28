"""Buffer objects (section 2.9) and occlusion queries (section 4.1.7)."""

from __future__ import annotations

import ctypes
from array import array as pyarray
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.gl.naming import free_name, names_from, new_names, returned_names
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_operation, invalid_value, out_of_memory
from glsim.machine.frame import Query, QueryMark, Vertices
from glsim.machine.machine import Machine
from glsim.machine.types import fill, is_pointer, plain, raw_bytes

LARGEST_BUFFER = 1 << 31
USAGES = (
    gl.GL_STREAM_DRAW, gl.GL_STREAM_READ, gl.GL_STREAM_COPY, gl.GL_STATIC_DRAW, gl.GL_STATIC_READ, gl.GL_STATIC_COPY,
    gl.GL_DYNAMIC_DRAW,
    gl.GL_DYNAMIC_READ, gl.GL_DYNAMIC_COPY,
)  # fmt: skip
FIELDS: dict[int, str] = {gl.GL_ARRAY_BUFFER: "array_buffer", gl.GL_ELEMENT_ARRAY_BUFFER: "element_buffer"}


class Buffer:
    """A buffer object.  version: counts the changes of its data.

    vertices: the Vertices that were drawn from it, by arrays._buffers_key, so that the GPU keeps them.
    """

    __slots__ = ("access", "data", "mapped", "usage", "version", "vertices")

    def __init__(self) -> None:
        self.data: NDArray[np.uint8] = np.zeros(0, np.uint8)
        self.usage, self.access = int(gl.GL_STATIC_DRAW), int(gl.GL_READ_WRITE)
        self.mapped = False
        self.version = 0
        self.vertices: dict[Any, Vertices] = {}


def _bound(m: Machine, target: int) -> Buffer:
    if target not in FIELDS:
        raise invalid_enum("target", target, "GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER")
    name = getattr(m.client, FIELDS[target])
    if not name:
        raise invalid_operation("no buffer is bound to this target: call glBindBuffer first")
    buffer: Buffer = m.objects.buffers[name]
    return buffer


def glGenBuffers(m: Machine, n: int, buffers: Any = None) -> Any:
    """As PyOpenGL: one name for n = 1, an array of names for more; or into ``buffers``."""
    names = new_names(m, "buffers", n, m.objects.buffers.__contains__)
    m.objects.buffers.update(dict.fromkeys(names))
    return returned_names(names, buffers)


def glBindBuffer(m: Machine, target: int, buffer: int) -> None:
    if target not in FIELDS:
        raise invalid_enum("target", target, "GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER")
    name = int(buffer or 0)
    if name and m.objects.buffers.get(name) is None:
        m.objects.buffers[name] = Buffer()
    setattr(m.client, FIELDS[target], name)


def glDeleteBuffers(m: Machine, n: Any, buffers: Any = None) -> None:
    """glDeleteBuffers(n, names), or glDeleteBuffers(names)."""
    for name in names_from(n, buffers):
        if name > 0:
            free_name(m, "buffers", name)
        if m.objects.buffers.pop(name, None) is not None:
            for field in FIELDS.values():
                if getattr(m.client, field) == name:
                    setattr(m.client, field, 0)


def glIsBuffer(m: Machine, buffer: int) -> int:
    return int(m.objects.buffers.get(int(buffer)) is not None)


def _bytes(data: Any, length: int | None = None) -> NDArray[np.uint8]:
    """The memory of what a program passes; length: how many bytes of it, if the program says so."""
    memory = raw_bytes(data)
    if memory is not None:
        return memory
    if is_pointer(data) and length is not None and length >= 0:
        return np.asarray(plain(ctypes.cast(data, ctypes.POINTER(ctypes.c_uint8)), length))
    array = np.asarray(data)
    if array.dtype.kind not in "biuf":
        raise TypeError("data must be bytes, an array or None")
    if not isinstance(data, (np.ndarray, ctypes.Array, pyarray)):
        array = array.astype(np.float32)
    return np.ascontiguousarray(array).reshape(-1).view(np.uint8)


def glBufferData(m: Machine, target: int, size: Any, data: Any = None, usage: Any = None) -> None:
    """glBufferData(target, size, data, usage), or in PyOpenGL's form glBufferData(target, data, usage)."""
    if usage is None:
        size, data, usage = None, size, data
    if usage not in USAGES:
        raise invalid_enum("usage", usage, "GL_STATIC_DRAW, GL_DYNAMIC_DRAW, GL_STREAM_DRAW or a _READ or _COPY form")
    buffer = _bound(m, target)
    if size is not None and size < 0:
        raise invalid_value("size", size, "at least 0")
    content = None if data is None else _bytes(data, size)
    length = int(size) if size is not None else len(content) if content is not None else 0
    if length > LARGEST_BUFFER:
        raise out_of_memory(f"{length} bytes are more than a buffer can hold")
    if content is not None and len(content) < length:
        raise ValueError(f"size is {length} bytes, but data has {len(content)}")
    buffer.data = np.zeros(length, np.uint8) if content is None else content[:length].copy()
    buffer.usage, buffer.mapped = int(usage), False
    buffer.version += 1


def _part(buffer: Buffer, offset: int, size: int) -> slice:
    if offset < 0 or size < 0 or offset + size > len(buffer.data):
        raise invalid_value("offset and size", (offset, size), f"inside of the buffer of {len(buffer.data)} bytes")
    if buffer.mapped:
        raise invalid_operation("the buffer is mapped: call glUnmapBuffer first")
    return slice(offset, offset + size)


def glBufferSubData(m: Machine, target: int, offset: int, size: Any, data: Any = None) -> None:
    """glBufferSubData(target, offset, size, data), or in PyOpenGL's form (target, offset, data)."""
    buffer = _bound(m, target)
    content = _bytes(size) if data is None else _bytes(data, int(size))
    length = len(content) if data is None else int(size)
    if len(content) < length:
        raise ValueError(f"size is {length} bytes, but data has {len(content)}")
    buffer.data[_part(buffer, int(offset), length)] = content[:length]
    buffer.version += 1


def glGetBufferSubData(m: Machine, target: int, offset: int, size: int, data: Any = None) -> Any:
    """Bytes of the buffer as an array of uint8, or into ``data``."""
    buffer = _bound(m, target)
    content = buffer.data[_part(buffer, int(offset), int(size))]
    if data is None:
        return content.copy()
    view = np.asarray(plain(data, len(content)))
    if not view.flags.c_contiguous or not view.flags.writeable or isinstance(data, (list, tuple, bytes)):
        raise TypeError("data must be a writable NumPy or ctypes array, or a bytearray")
    fill(view.reshape(-1).view(np.uint8), content)
    return data


def glMapBuffer(m: Machine, target: int, access: int) -> int:
    """The address of the buffer's memory, as PyOpenGL returns it; good until glUnmapBuffer."""
    if access not in (gl.GL_READ_ONLY, gl.GL_WRITE_ONLY, gl.GL_READ_WRITE):
        raise invalid_enum("access", access, "GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE")
    buffer = _bound(m, target)
    if buffer.mapped:
        raise invalid_operation("the buffer is mapped already")
    buffer.mapped, buffer.access = True, int(access)
    return int(buffer.data.ctypes.data)


def glUnmapBuffer(m: Machine, target: int) -> int:
    buffer = _bound(m, target)
    if not buffer.mapped:
        raise invalid_operation("the buffer is not mapped")
    buffer.mapped = False
    buffer.version += 1
    return 1


def glGetBufferParameter(m: Machine, target: int, pname: int) -> tuple[float, ...]:
    buffer = _bound(m, target)
    values = {
        gl.GL_BUFFER_SIZE: len(buffer.data), gl.GL_BUFFER_USAGE: buffer.usage, gl.GL_BUFFER_ACCESS: buffer.access,
        gl.GL_BUFFER_MAPPED: int(buffer.mapped),
    }  # fmt: skip
    if pname not in values:
        raise invalid_enum("pname", pname, "GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS or GL_BUFFER_MAPPED")
    return (float(values[pname]),)  # type: ignore[index]


def glGetBufferPointerv(m: Machine, target: int, pname: int) -> int | None:
    if pname != gl.GL_BUFFER_MAP_POINTER:
        raise invalid_enum("pname", pname, "GL_BUFFER_MAP_POINTER")
    buffer = _bound(m, target)
    return int(buffer.data.ctypes.data) if buffer.mapped else None


# ---------------------------------------------------------------- occlusion queries

ACTIVE = 0  # m.objects.queries[ACTIVE] is the name of the active query, 0 if there is none


def glGenQueries(m: Machine, n: int, ids: Any = None) -> Any:
    """As PyOpenGL: one name for n = 1, an array of names for more; or into ``ids``."""
    names = new_names(m, "queries", n, m.objects.queries.__contains__)
    m.objects.queries.update(dict.fromkeys(names))
    return returned_names(names, ids)


def glDeleteQueries(m: Machine, n: Any, ids: Any = None) -> None:
    """glDeleteQueries(n, names), or glDeleteQueries(names)."""
    for name in names_from(n, ids):
        if name == m.objects.queries.get(ACTIVE):
            glEndQuery(m, gl.GL_SAMPLES_PASSED)
        if name > 0:
            m.objects.queries.pop(name, None)
            free_name(m, "queries", name)


def glIsQuery(m: Machine, id: int) -> int:
    return int(id > 0 and m.objects.queries.get(id) is not None)


def _check_target(target: int) -> None:
    if target != gl.GL_SAMPLES_PASSED:
        raise invalid_enum("target", target, "GL_SAMPLES_PASSED")


def glBeginQuery(m: Machine, target: int, id: int) -> None:
    """Count the samples that pass the depth test until glEndQuery."""
    _check_target(target)
    if m.objects.queries.get(ACTIVE):
        raise invalid_operation(f"query {m.objects.queries[ACTIVE]} has no glEndQuery yet")
    if id <= 0:
        raise invalid_operation("id must be a name from glGenQueries, not 0")
    m.objects.queries[int(id)] = Query()
    m.objects.queries[ACTIVE] = int(id)
    m.add(QueryMark(True, m.objects.queries[int(id)]))


def glEndQuery(m: Machine, target: int) -> None:
    _check_target(target)
    active = m.objects.queries.get(ACTIVE)
    if not active:
        raise invalid_operation("there is no glBeginQuery before this glEndQuery")
    m.add(QueryMark(False, m.objects.queries[active]))
    m.objects.queries[ACTIVE] = 0


def glGetQuery(m: Machine, target: int, pname: int) -> tuple[float, ...]:
    _check_target(target)
    if pname == gl.GL_QUERY_COUNTER_BITS:
        return (32.0,)
    if pname == gl.GL_CURRENT_QUERY:
        return (float(m.objects.queries.get(ACTIVE) or 0),)
    raise invalid_enum("pname", pname, "GL_CURRENT_QUERY or GL_QUERY_COUNTER_BITS")


def glGetQueryObject(m: Machine, id: int, pname: int) -> tuple[float, ...]:
    query = m.objects.queries.get(id) if id > 0 else None
    if query is None or m.objects.queries.get(ACTIVE) == id:
        raise invalid_operation(f"{id} is no query that has ended")
    if pname not in (gl.GL_QUERY_RESULT, gl.GL_QUERY_RESULT_AVAILABLE):
        raise invalid_enum("pname", pname, "GL_QUERY_RESULT or GL_QUERY_RESULT_AVAILABLE")
    m.flush()
    return (float(query.result or 0) if pname == gl.GL_QUERY_RESULT else 1.0,)
