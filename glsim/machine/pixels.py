"""Pixel rectangles between a program's memory and the machine: sections 3.6 and 4.3 of the specification.

Unpacking turns memory into components and packing components into memory (packing.py); pixel transfer scales, biases
and maps the components between both.
Rectangles are (height, width, components), bottom row first, with a depth in front for 3D textures.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl

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


def colors(mode: PixelMode, format: int, values: Values) -> Values:
    """Red, green, blue, alpha after pixel transfer: uint8, or float64 in [0, 1]; section 3.6.4."""
    if format == gl.GL_COLOR_INDEX:
        return clamped(_looked_up(mode, values))
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
        return rgba if rgba.dtype == np.uint8 else clamped(rgba)
    unit = rgba / 255.0 if rgba.dtype == np.uint8 else rgba
    unit = unit * np.array(mode.scale) + np.array(mode.bias)
    if mode.map_color:
        unit = clamped(unit)
        for k, name in enumerate(COLOR_MAPS):
            table = np.array(mode.map(name))
            unit[..., k] = table[np.floor(unit[..., k] * (len(table) - 1) + 0.5).astype(np.int64)]
    return clamped(unit)


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
    return clamped(as_unit(values) * mode.depth_scale + mode.depth_bias).astype(np.float32)


def as_unit(values: Values) -> NDArray[np.float64]:
    """Integers map linearly onto [0, 1] or [-1, 1] (table 2.9); floats stay."""
    if values.dtype.kind == "f":
        return values.astype(np.float64)
    scale = 2.0 ** (8 * values.dtype.itemsize) - 1.0
    return values / scale if values.dtype.kind == "u" else (2.0 * values + 1.0) / scale


def as_bytes(rgba: Values) -> NDArray[np.uint8]:
    """Colours, uint8 or floats in [0, 1], as uint8."""
    return rgba if rgba.dtype == np.uint8 else np.floor(clamped(rgba) * 255.0 + 0.5).astype(np.uint8)


def clamped(values: Values) -> Values:
    return np.asarray(np.clip(np.nan_to_num(values), 0.0, 1.0))
