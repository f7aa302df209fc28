"""Pixel rectangles between a program's memory and the machine: sections 3.6 and 4.3 of the specification.

Unpacking turns memory into components, pixel transfer scales, biases and maps them, packing is the way back.
Rectangles are (height, width, components), bottom row first, with a depth in front for 3D textures.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_operation
from glsim.machine.types import DTYPES, plain, raw_bytes

Values = NDArray[Any]

# format -> (number of components in memory, index of the component that becomes red, green, blue and alpha).
# Index -1: the value is 0; index -2: it is 1.
COMPONENTS: dict[int, tuple[int, tuple[int, int, int, int]]] = {
    gl.GL_RED: (1, (0, -1, -1, -2)),
    gl.GL_GREEN: (1, (-1, 0, -1, -2)),
    gl.GL_BLUE: (1, (-1, -1, 0, -2)),
    gl.GL_ALPHA: (1, (-1, -1, -1, 0)),
    gl.GL_LUMINANCE: (1, (0, 0, 0, -2)),
    gl.GL_LUMINANCE_ALPHA: (2, (0, 0, 0, 1)),
    gl.GL_RGB: (3, (0, 1, 2, -2)),
    gl.GL_BGR: (3, (2, 1, 0, -2)),
    gl.GL_RGBA: (4, (0, 1, 2, 3)),
    gl.GL_BGRA: (4, (2, 1, 0, 3)),
}
SINGLE = (gl.GL_COLOR_INDEX, gl.GL_STENCIL_INDEX, gl.GL_DEPTH_COMPONENT)
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


class PixelStore(NamedTuple):
    """glPixelStore for one direction; lengths in pixels, alignment in bytes."""

    alignment: int = 4
    row_length: int = 0
    image_height: int = 0
    skip_pixels: int = 0
    skip_rows: int = 0
    skip_images: int = 0
    swap_bytes: bool = False
    lsb_first: bool = False


UNPACK_FIELDS: dict[int, str] = {
    gl.GL_UNPACK_ALIGNMENT: "alignment", gl.GL_UNPACK_ROW_LENGTH: "row_length",
    gl.GL_UNPACK_IMAGE_HEIGHT: "image_height",
    gl.GL_UNPACK_SKIP_PIXELS: "skip_pixels", gl.GL_UNPACK_SKIP_ROWS: "skip_rows",
    gl.GL_UNPACK_SKIP_IMAGES: "skip_images",
    gl.GL_UNPACK_SWAP_BYTES: "swap_bytes", gl.GL_UNPACK_LSB_FIRST: "lsb_first",
}  # fmt: skip
PACK_FIELDS: dict[int, str] = {
    gl.GL_PACK_ALIGNMENT: "alignment", gl.GL_PACK_ROW_LENGTH: "row_length", gl.GL_PACK_IMAGE_HEIGHT: "image_height",
    gl.GL_PACK_SKIP_PIXELS: "skip_pixels", gl.GL_PACK_SKIP_ROWS: "skip_rows", gl.GL_PACK_SKIP_IMAGES: "skip_images",
    gl.GL_PACK_SWAP_BYTES: "swap_bytes", gl.GL_PACK_LSB_FIRST: "lsb_first",
}  # fmt: skip

COLOR_MAPS: tuple[int, ...] = (
    gl.GL_PIXEL_MAP_R_TO_R,
    gl.GL_PIXEL_MAP_G_TO_G,
    gl.GL_PIXEL_MAP_B_TO_B,
    gl.GL_PIXEL_MAP_A_TO_A,
)
INDEX_MAPS: tuple[int, ...] = (
    gl.GL_PIXEL_MAP_I_TO_R,
    gl.GL_PIXEL_MAP_I_TO_G,
    gl.GL_PIXEL_MAP_I_TO_B,
    gl.GL_PIXEL_MAP_I_TO_A,
)
MAPS: tuple[int, ...] = (*COLOR_MAPS, *INDEX_MAPS, gl.GL_PIXEL_MAP_I_TO_I, gl.GL_PIXEL_MAP_S_TO_S)


class PixelMode(NamedTuple):
    """Group GL_PIXEL_MODE_BIT, and the pixel maps, which no group has.

    scale and bias: of red, green, blue, alpha.  maps: in the order of MAPS.
    """

    scale: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    bias: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    depth_scale: float = 1.0
    depth_bias: float = 0.0
    map_color: bool = False
    map_stencil: bool = False
    index_shift: int = 0
    index_offset: int = 0
    zoom: tuple[float, float] = (1.0, 1.0)
    read_buffer: int = gl.GL_FRONT
    maps: tuple[tuple[float, ...], ...] = ((0.0,),) * 10

    def map(self, name: int) -> tuple[float, ...]:
        return self.maps[MAPS.index(name)]

    @property
    def changes_color(self) -> bool:
        return self.map_color or self.scale != (1.0,) * 4 or self.bias != (0.0,) * 4


# ---------------------------------------------------------------- memory -> components


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


# ---------------------------------------------------------------- components -> colours, indices, depths


def colors(mode: PixelMode, format: int, values: Values) -> Values:
    """Red, green, blue, alpha after pixel transfer: uint8, or float64 in [0, 1]; section 3.6.4."""
    if format == gl.GL_COLOR_INDEX:
        return _clamped(_looked_up(mode, values))
    count, order = COMPONENTS[format]
    plain = values.dtype == np.uint8
    unit = values if plain else as_unit(values)
    if count == 4 and order == (0, 1, 2, 3):
        result = unit
    else:
        result = np.empty((*values.shape[:-1], 4), unit.dtype)
        for k, source in enumerate(order):
            result[..., k] = unit[..., source] if source >= 0 else (0 if source == -1 else (255 if plain else 1.0))
    return transferred(mode, result)


def transferred(mode: PixelMode, rgba: Values) -> Values:
    """Scale, bias and map colours (section 3.6.5); uint8 stays as it is if nothing changes."""
    if not mode.changes_color:
        return rgba if rgba.dtype == np.uint8 else _clamped(rgba)
    unit = rgba / 255.0 if rgba.dtype == np.uint8 else rgba
    unit = unit * np.array(mode.scale) + np.array(mode.bias)
    if mode.map_color:
        unit = _clamped(unit)
        for k, name in enumerate(COLOR_MAPS):
            table = np.array(mode.map(name))
            unit[..., k] = table[np.floor(unit[..., k] * (len(table) - 1) + 0.5).astype(np.int64)]
    return _clamped(unit)


def _looked_up(mode: PixelMode, values: Values) -> Values:
    """Colour indices through the maps I_TO_R to I_TO_A, whose sizes are powers of two."""
    index = indices(mode, values)[..., 0]
    tables = [np.array(mode.map(name)) for name in INDEX_MAPS]
    return np.stack([table[index & (len(table) - 1)] for table in tables], axis=-1)


def indices(mode: PixelMode, values: Values) -> NDArray[np.int64]:
    """Colour or stencil indices, shifted and offset."""
    whole = np.floor(np.nan_to_num(values.astype(np.float64))).astype(np.int64)
    shift = min(max(mode.index_shift, -62), 62)
    return (whole << shift if shift >= 0 else whole >> -shift) + mode.index_offset


def stencils(mode: PixelMode, values: Values) -> NDArray[np.uint8]:
    """Stencil indices after pixel transfer: 8 bits."""
    index = indices(mode, values)
    if mode.map_stencil:
        table = np.array(mode.map(gl.GL_PIXEL_MAP_S_TO_S)).astype(np.int64)
        index = table[index & (len(table) - 1)]
    return (index & 255).astype(np.uint8)


def depths(mode: PixelMode, values: Values) -> NDArray[np.float32]:
    """Depths after pixel transfer, in [0, 1]."""
    return _clamped(as_unit(values) * mode.depth_scale + mode.depth_bias).astype(np.float32)


def as_unit(values: Values) -> NDArray[np.float64]:
    """Integers map linearly onto [0, 1] or [-1, 1] (table 2.9); floats stay."""
    if values.dtype.kind == "f":
        return values.astype(np.float64)
    scale = 2.0 ** (8 * values.dtype.itemsize) - 1.0
    return values / scale if values.dtype.kind == "u" else (2.0 * values + 1.0) / scale


def as_bytes(rgba: Values) -> NDArray[np.uint8]:
    """Colours, uint8 or floats in [0, 1], as uint8."""
    return rgba if rgba.dtype == np.uint8 else np.floor(_clamped(rgba) * 255.0 + 0.5).astype(np.uint8)


def _clamped(values: Values) -> Values:
    return np.asarray(np.clip(np.nan_to_num(values), 0.0, 1.0))


# ---------------------------------------------------------------- colours -> memory


def pack_colors(format: int, type: int, rgba: Values) -> Values:
    """Colours (..., 4) as the numbers a program asks for, (..., count); packed types have one number a pixel."""
    unit = rgba if rgba.dtype == np.uint8 else _clamped(rgba)
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
