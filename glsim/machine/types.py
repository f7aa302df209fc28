"""Number types: from the suffix of a command to the GL constant to the NumPy type; and values of ctypes."""

from __future__ import annotations

import ctypes
from array import array
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.constants import Enum

SUFFIXES: dict[str, Enum] = {
    "b": gl.GL_BYTE,
    "s": gl.GL_SHORT,
    "i": gl.GL_INT,
    "f": gl.GL_FLOAT,
    "d": gl.GL_DOUBLE,
    "ub": gl.GL_UNSIGNED_BYTE,
    "us": gl.GL_UNSIGNED_SHORT,
    "ui": gl.GL_UNSIGNED_INT,
}
DTYPES: dict[int, type] = {
    gl.GL_BYTE: np.int8,
    gl.GL_UNSIGNED_BYTE: np.uint8,
    gl.GL_SHORT: np.int16,
    gl.GL_UNSIGNED_SHORT: np.uint16,
    gl.GL_INT: np.int32,
    gl.GL_UNSIGNED_INT: np.uint32,
    gl.GL_FLOAT: np.float32,
    gl.GL_DOUBLE: np.float64,
}

C_TYPES: dict[str, Any] = {  # OpenGL's names of C's types (table 2.2)
    "GLbyte": ctypes.c_byte, "GLshort": ctypes.c_short, "GLint": ctypes.c_int, "GLsizei": ctypes.c_int,
    "GLubyte": ctypes.c_ubyte, "GLboolean": ctypes.c_ubyte, "GLushort": ctypes.c_ushort, "GLuint": ctypes.c_uint,
    "GLenum": ctypes.c_uint, "GLbitfield": ctypes.c_uint, "GLfloat": ctypes.c_float, "GLclampf": ctypes.c_float,
    "GLdouble": ctypes.c_double, "GLclampd": ctypes.c_double, "GLvoid": None,
}  # fmt: skip

_Number: Any = ctypes.c_int.__base__  # what c_int, c_float, ... have in common
_Reference: Any = type(ctypes.byref(ctypes.c_int()))
_Pointer: Any = ctypes.POINTER(ctypes.c_int).__base__
_ADDRESSES = (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_wchar_p)  # how long what lies there is, they don't say


def plain(value: Any, count: int | None = None) -> Any:
    """What ctypes wraps, as NumPy takes it; anything else as it is.

    c_float, c_uint, ... become their number, byref(x) becomes x, a pointer becomes an array of the first ``count``
    elements it leads to, over the same memory (and stays a pointer if ``count`` is None: it has no end of its own).
    """
    if isinstance(value, _Reference):
        whole = ctypes.cast(value, ctypes.c_void_p).value == ctypes.addressof(value._obj)
        return plain(value._obj) if whole else value  # byref(x, offset): where it ends is not known
    if isinstance(value, _Number) and not isinstance(value, _ADDRESSES):
        return value.value
    if not isinstance(value, _Pointer) or count is None or not value:
        return value
    element = value._type_
    while hasattr(element, "_length_"):  # a pointer to an array
        element = element._type_
    return np.ctypeslib.as_array(ctypes.cast(value, ctypes.POINTER(element)), (count,))


def is_pointer(value: Any) -> bool:
    """Whether this is an address of ctypes: it has no length, so iterating over it never ends."""
    return isinstance(value, (_Pointer, *_ADDRESSES))


def raw_bytes(value: Any) -> NDArray[np.uint8] | None:
    """The memory of bytes, or of what stands for them: a bytearray, a memoryview, an array of bytes, a str whose
    characters are bytes, as in Python 2.  None for anything else."""
    if isinstance(value, str):
        if any(character > "\xff" for character in value):
            raise ValueError("a str stands for bytes here, but this one has characters that are no bytes")
        value = value.encode("latin-1")
    if isinstance(value, array) and value.itemsize > 1:
        return None
    if not isinstance(value, (bytes, bytearray, memoryview, array)):
        return None
    if not memoryview(value).c_contiguous:
        raise TypeError("a memoryview must be contiguous: bytes(view) makes a copy that is")
    return np.frombuffer(value, np.uint8)


def fill(array: Any, values: Any) -> Any:
    """Write ``values`` into the first elements of ``array``, a program's array for a result; return ``array``."""
    values = np.ravel(values)
    if isinstance(array, list):
        array[: len(values)] = values.tolist()
        return array
    target = array._obj if isinstance(array, _Reference) else array
    try:
        view = np.asarray(plain(target, len(values)) if is_pointer(target) else target)
    except (TypeError, ValueError):
        view = np.asarray(None)
    if isinstance(target, (int, float, tuple)) or view.dtype.kind not in "biuf" or not view.flags.writeable:
        raise TypeError(
            f"the array for the answer must be a list, or a NumPy or ctypes array of numbers, not {array!r:.60}"
        )
    if view.size < len(values):
        raise ValueError(f"the array for the answer has room for {view.size} numbers, but the answer has {len(values)}")
    view.flat[: len(values)] = values
    return array
