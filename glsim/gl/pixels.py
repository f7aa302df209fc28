"""Reading pixel rectangles out of a program's memory: sections 3.6.1 to 3.6.4 of the specification."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.constants import (
    GL_ALPHA,
    GL_BGR,
    GL_BGRA,
    GL_BLUE,
    GL_GREEN,
    GL_LUMINANCE,
    GL_LUMINANCE_ALPHA,
    GL_RED,
    GL_RGB,
    GL_RGBA,
    GL_UNPACK_ALIGNMENT,
    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SWAP_BYTES,
    Enum,
)
from glsim.machine.errors import invalid_enum
from glsim.machine.machine import Machine
from glsim.machine.types import DTYPES

# format -> which component of the memory becomes red, green, blue, alpha; -1: 0, -2: 1
COMPONENTS: dict[int, tuple[int, tuple[int, int, int, int]]] = {
    GL_RED: (1, (0, -1, -1, -2)),
    GL_GREEN: (1, (-1, 0, -1, -2)),
    GL_BLUE: (1, (-1, -1, 0, -2)),
    GL_ALPHA: (1, (-1, -1, -1, 0)),
    GL_LUMINANCE: (1, (0, 0, 0, -2)),
    GL_LUMINANCE_ALPHA: (2, (0, 0, 0, 1)),
    GL_RGB: (3, (0, 1, 2, -2)),
    GL_BGR: (3, (2, 1, 0, -2)),
    GL_RGBA: (4, (0, 1, 2, 3)),
    GL_BGRA: (4, (2, 1, 0, 3)),
}
FORMATS = "GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_BGR or another pixel format"


def unpack(m: Machine, width: int, height: int, format: int, type: int, pixels: Any) -> NDArray[np.uint8]:
    """A rectangle of pixels as (height, width, 4) uint8 red, green, blue, alpha; the first row comes first."""
    if format not in COMPONENTS:
        raise invalid_enum("format", format, FORMATS)
    dtype = DTYPES.get(type)
    if dtype is None:
        kind = repr(type) if isinstance(type, Enum) else str(type)
        raise NotImplementedError(f"pixels of type {kind} are not in glsim yet: use GL_UNSIGNED_BYTE or GL_FLOAT")
    if pixels is None:
        return np.zeros((height, width, 4), np.uint8)
    count, order = COMPONENTS[format]
    values = _rows(m, width, height, count, np.dtype(dtype), pixels)
    unit = _unit(values)
    result = np.empty((height, width, 4), np.uint8)
    for k, source in enumerate(order):
        result[..., k] = unit[..., source] if source >= 0 else (0 if source == -1 else 255)
    return result


def _rows(m: Machine, width: int, height: int, count: int, dtype: np.dtype[Any], pixels: Any) -> NDArray[Any]:
    """The components (height, width, count) as they lie in memory, by glPixelStore."""
    if isinstance(pixels, (bytes, bytearray, memoryview)):
        memory = np.frombuffer(pixels, np.uint8)
    else:
        array = np.ascontiguousarray(pixels, None if isinstance(pixels, np.ndarray) else dtype)
        memory = (array if array.dtype == dtype else array.astype(dtype)).reshape(-1).view(np.uint8)
    store = m.pixel_store
    length = store.get(GL_UNPACK_ROW_LENGTH, 0) or width
    alignment = store.get(GL_UNPACK_ALIGNMENT, 4)
    size = count * dtype.itemsize
    stride = -(-length * size // alignment) * alignment
    skip = store.get(GL_UNPACK_SKIP_ROWS, 0) * stride + store.get(GL_UNPACK_SKIP_PIXELS, 0) * size
    if skip + stride * (height - 1) + width * size > memory.size:
        stride = length * size  # rows without padding, as arrays have them
    needed = skip + stride * (height - 1) + width * size
    if needed > memory.size:
        raise ValueError(f"{width} x {height} pixels of {count} components need {needed} bytes, not {memory.size}")
    rows = np.ndarray((height, width * size), np.uint8, memory, skip, (stride, 1))
    values = np.ascontiguousarray(rows).view(dtype).reshape(height, width, count)
    return values.byteswap() if store.get(GL_UNPACK_SWAP_BYTES, 0) else values


def _unit(values: NDArray[Any]) -> NDArray[np.uint8]:
    """Components of any type as 8-bit numbers in [0, 255] (table 2.9)."""
    if values.dtype == np.uint8:
        return values
    if values.dtype.kind == "f":
        unit = values.astype(np.float64)
    elif values.dtype.kind == "u":
        unit = values / (2.0 ** (8 * values.dtype.itemsize) - 1.0)
    else:
        unit = (2.0 * values + 1.0) / (2.0 ** (8 * values.dtype.itemsize) - 1.0)
    return np.floor(np.clip(np.nan_to_num(unit), 0.0, 1.0) * 255.0 + 0.5).astype(np.uint8)
