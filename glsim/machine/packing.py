"""Pixels in the program's memory: unpacked into components, and packed (sections 3.6.4 and 4.3.2)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_operation
from glsim.machine.pixels import COMPONENTS, SINGLE, PixelStore, Values, clamped
from glsim.machine.types import DTYPES, plain, raw_bytes

FORMATS = "GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_BGR or another pixel format"
TYPES = "GL_UNSIGNED_BYTE, GL_FLOAT, another number type, or a packed type such as GL_UNSIGNED_SHORT_5_6_5"

# packed type -> number type, bits of each component from the first on, whether the first lies in the lowest bits
PACKED: dict[int, tuple[str, tuple[int, ...], bool]] = {
    gl.GL_UNSIGNED_BYTE_3_3_2: ("u1", (3, 3, 2), False),
    gl.GL_UNSIGNED_BYTE_2_3_3_REV: ("u1", (3, 3, 2), True),
    gl.GL_UNSIGNED_SHORT_5_6_5: ("u2", (5, 6, 5), False),
    gl.GL_UNSIGNED_SHORT_5_6_5_REV: ("u2", (5, 6, 5), True),
    gl.GL_UNSIGNED_SHORT_4_4_4_4: ("u2", (4, 4, 4, 4), False),
    gl.GL_UNSIGNED_SHORT_4_4_4_4_REV: ("u2", (4, 4, 4, 4), True),
    gl.GL_UNSIGNED_SHORT_5_5_5_1: ("u2", (5, 5, 5, 1), False),
    gl.GL_UNSIGNED_SHORT_1_5_5_5_REV: ("u2", (5, 5, 5, 1), True),
    gl.GL_UNSIGNED_INT_8_8_8_8: ("u4", (8, 8, 8, 8), False),
    gl.GL_UNSIGNED_INT_8_8_8_8_REV: ("u4", (8, 8, 8, 8), True),
    gl.GL_UNSIGNED_INT_10_10_10_2: ("u4", (10, 10, 10, 2), False),
    gl.GL_UNSIGNED_INT_2_10_10_10_REV: ("u4", (10, 10, 10, 2), True),
}


def check(format: int, type: int) -> None:
    """Raises GLError if OpenGL has no such format or type, or if the two cannot be combined."""
    if format not in COMPONENTS and format not in SINGLE:
        raise invalid_enum("format", format, FORMATS)
    if type not in DTYPES and type not in PACKED and type != gl.GL_BITMAP:
        raise invalid_enum("type", type, TYPES)
    if type == gl.GL_BITMAP and format not in (gl.GL_COLOR_INDEX, gl.GL_STENCIL_INDEX):
        raise invalid_enum("format", format, "GL_COLOR_INDEX or GL_STENCIL_INDEX with type GL_BITMAP")
    if type in PACKED:
        bits = PACKED[type][1]
        fits = (gl.GL_RGBA, gl.GL_BGRA) if len(bits) == 4 else (gl.GL_RGB,)
        if format not in fits:
            raise invalid_operation(f"a packed type with {len(bits)} components needs format {fits[0]!r}")


def unpack(store: PixelStore, size: tuple[int, ...], format: int, type: int, pixels: Any) -> Values:
    """The components (*size, count) that lie in a program's memory; size: (height, width) or (depth, height, width).

    The result has the number type of the memory; of a packed type float64 in [0, 1], of GL_BITMAP uint8, 0 or 1.
    """
    check(format, type)
    count = COMPONENTS[format][0] if format in COMPONENTS else 1
    if type == gl.GL_BITMAP:
        return _bits(store, size, pixels)
    if type in PACKED:
        letters, bits, reverse = PACKED[type]
        words = _rows(store, size, 1, np.dtype(letters), pixels)[..., 0].astype(np.uint64)
        return _split(words, bits, reverse)
    return _rows(store, size, count, np.dtype(DTYPES[type]), pixels)


def _memory(pixels: Any, dtype: np.dtype[Any], count: int) -> NDArray[np.uint8]:
    """The bytes of what a program passes; count: how many numbers are read of a pointer."""
    memory = raw_bytes(pixels)
    if memory is not None:
        return memory
    pixels = plain(pixels, count)
    try:
        array = np.ascontiguousarray(pixels, None if isinstance(pixels, np.ndarray) else dtype)
        return (array if array.dtype == dtype else array.astype(dtype)).reshape(-1).view(np.uint8)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"pixels must be bytes or an array of {dtype} numbers, not {pixels!r:.60}") from None


def _rows(store: PixelStore, size: tuple[int, ...], count: int, dtype: np.dtype[Any], pixels: Any) -> Values:
    """Numbers (*size, count) by the rules of section 3.6.4."""
    *depth, height, width = size
    images = depth[0] if depth else 1
    group = count * dtype.itemsize
    length = store.row_length or width
    stride = -(-length * group // store.alignment) * store.alignment
    step = (store.image_height or height) if depth else height
    skip = store.skip_rows + (store.skip_images * step if depth else 0)

    def needed(stride: int) -> int:
        return (skip + (images - 1) * step + height - 1) * stride + (store.skip_pixels + width) * group

    if 0 in size:
        return np.zeros((*size, count), dtype)
    memory = _memory(pixels, dtype, -(-needed(stride) // dtype.itemsize))
    if needed(stride) > memory.size:
        stride = length * group  # rows without padding, as arrays have them
    if needed(stride) > memory.size:
        shape = " x ".join(map(str, reversed(size)))
        raise ValueError(
            f"{shape} pixels of {count} components need {needed(stride)} bytes, but pixels has {memory.size}"
        )
    start = skip * stride + store.skip_pixels * group
    rows = np.ndarray((images, height, width * group), np.uint8, memory, start, (step * stride, stride, 1))
    values = np.ascontiguousarray(rows).view(dtype).reshape(*size, count)
    return values.byteswap() if store.swap_bytes else values


def _bits(store: PixelStore, size: tuple[int, ...], pixels: Any) -> Values:
    """A bitmap as 0 and 1: (height, width, 1) uint8."""
    height, width = size[-2:]
    stride = -(-(store.row_length or width) // (8 * store.alignment)) * store.alignment
    needed = (store.skip_rows + height - 1) * stride + -(-(store.skip_pixels + width) // 8)
    if 0 in size:
        return np.zeros((height, width, 1), np.uint8)
    memory = _memory(pixels, np.dtype(np.uint8), needed)
    if needed > memory.size:
        tight = -(-(store.row_length or width) // 8)
        stride, needed = tight, (store.skip_rows + height - 1) * tight + -(-(store.skip_pixels + width) // 8)
    if needed > memory.size:
        raise ValueError(f"a bitmap of {width} x {height} pixels needs {needed} bytes, but pixels has {memory.size}")
    wide = -(-(store.skip_pixels + width) // 8)
    rows = np.ndarray((height, wide), np.uint8, memory, store.skip_rows * stride, (stride, 1))
    bits = np.unpackbits(rows, axis=1, bitorder="little" if store.lsb_first else "big")
    return np.ascontiguousarray(bits[:, store.skip_pixels : store.skip_pixels + width, None])


def _shifts(bits: tuple[int, ...], reverse: bool) -> list[int]:
    """Where each component begins, counted from the lowest bit."""
    ends = np.cumsum(bits).tolist()
    return [0, *ends[:-1]] if reverse else [sum(bits) - end for end in ends]


def _split(words: NDArray[np.uint64], bits: tuple[int, ...], reverse: bool) -> Values:
    parts = [
        ((words >> np.uint64(shift)) & np.uint64(2**n - 1)) / (2.0**n - 1.0)
        for n, shift in zip(bits, _shifts(bits, reverse), strict=True)
    ]
    return np.stack(parts, axis=-1)


def pack_colors(format: int, type: int, rgba: Values) -> Values:
    """Colours (..., 4) as the numbers a program asks for, (..., count); packed types have one number a pixel."""
    unit = rgba if rgba.dtype == np.uint8 else clamped(rgba)
    one = 255 if unit.dtype == np.uint8 else 1.0
    if format in (gl.GL_LUMINANCE, gl.GL_LUMINANCE_ALPHA):  # L = R + G + B, section 4.3.2
        summed = np.minimum(unit[..., :3].sum(axis=-1, keepdims=True), one).astype(unit.dtype)
        unit = np.concatenate([summed, unit[..., 3:]], axis=-1)[..., : COMPONENTS[format][0]]
    else:
        count, order = COMPONENTS[format]
        unit = unit[..., [order.index(k) for k in range(count)]]
    if type in PACKED:
        letters, bits, reverse = PACKED[type]
        unit = unit / one
        words = np.zeros(unit.shape[:-1], np.uint64)
        for k, (n, shift) in enumerate(zip(bits, _shifts(bits, reverse), strict=True)):
            words |= np.floor(unit[..., k] * (2.0**n - 1.0) + 0.5).astype(np.uint64) << np.uint64(shift)
        return words[..., None].astype(letters)
    return as_numbers(unit, DTYPES[type])


def as_numbers(unit: Values, dtype: type) -> Values:
    """Components as stored (uint8, or floats in [0, 1]) -> the type asked for (table 4.7)."""
    if unit.dtype == dtype:
        return np.ascontiguousarray(unit)
    unit = unit / 255.0 if unit.dtype == np.uint8 else unit.astype(np.float64)
    kind, bits = np.dtype(dtype).kind, 8 * np.dtype(dtype).itemsize
    if kind == "f":
        return unit.astype(dtype)
    if kind == "u":
        return np.floor(unit * (2.0**bits - 1.0) + 0.5).astype(dtype)
    return np.floor(((2.0**bits - 1.0) * unit - 1.0) / 2.0 + 0.5).astype(dtype)


def pack_into(store: PixelStore, values: Values, memory: NDArray[np.uint8]) -> None:
    """Write (height, width, count) numbers into a program's memory by the rules of section 4.3.2."""
    height, width = values.shape[:2]
    if store.swap_bytes:
        values = values.byteswap()
    rows = np.ascontiguousarray(values).reshape(height, -1).view(np.uint8)
    group = rows.shape[1] // width
    length = store.row_length or width
    stride = -(-length * group // store.alignment) * store.alignment
    start = store.skip_rows * stride + store.skip_pixels * group
    if start + (height - 1) * stride + rows.shape[1] > memory.size:
        stride, start = length * group, store.skip_rows * length * group + store.skip_pixels * group
    if start + (height - 1) * stride + rows.shape[1] > memory.size:
        raise ValueError(f"{width} x {height} pixels do not fit into an array of {memory.size} bytes")
    for k, row in enumerate(rows):
        memory[start + k * stride : start + k * stride + len(row)] = row
