"""Pixel rectangles: sections 3.6, 3.7 and 4.3 of the specification."""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.gl.arguments import numbers
from glsim.gl.texread import deliver
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_operation, invalid_value, out_of_memory
from glsim.machine.frame import Pixels
from glsim.machine.machine import Machine
from glsim.machine.packing import as_numbers, check, pack_colors, pack_into, unpack
from glsim.machine.pixels import INDEX_MAPS, MAPS, PACK_FIELDS, UNPACK_FIELDS, colors, depths, stencils, transferred
from glsim.machine.types import DTYPES, fill, plain

LARGEST_RECTANGLE = 16384
MOST_PIXELS = 1 << 26  # the most pixels of a rectangle, unless the framebuffer has more
MAX_PIXEL_MAP_TABLE = 256
INDEXED = (gl.GL_PIXEL_MAP_I_TO_I, gl.GL_PIXEL_MAP_S_TO_S, *INDEX_MAPS)  # maps whose size is a power of two


# ---------------------------------------------------------------- how pixels lie in memory, and change on their way


def glPixelStore(m: Machine, pname: int, param: float) -> None:
    """How pixels lie in the program's memory.  Arrays that glsim returns are tightly packed, as PyOpenGL's are."""
    fields = UNPACK_FIELDS if pname in UNPACK_FIELDS else PACK_FIELDS
    if pname not in fields:
        raise invalid_enum("pname", pname, "GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH or another way to store pixels")
    field = fields[pname]
    value: Any = param != 0.0 if field in ("swap_bytes", "lsb_first") else int(np.floor(param + 0.5))
    if field == "alignment" and value not in (1, 2, 4, 8):
        raise invalid_value("param", param, "1, 2, 4 or 8")
    if value < 0:
        raise invalid_value("param", param, "at least 0")
    store = m.stores.unpack if fields is UNPACK_FIELDS else m.stores.pack
    store = store._replace(**{field: value})
    if fields is UNPACK_FIELDS:
        m.stores.unpack = store
    else:
        m.stores.pack = store


SCALES: dict[int, int] = {gl.GL_RED_SCALE: 0, gl.GL_GREEN_SCALE: 1, gl.GL_BLUE_SCALE: 2, gl.GL_ALPHA_SCALE: 3}
BIASES: dict[int, int] = {gl.GL_RED_BIAS: 0, gl.GL_GREEN_BIAS: 1, gl.GL_BLUE_BIAS: 2, gl.GL_ALPHA_BIAS: 3}
TRANSFERS: dict[int, tuple[str, type]] = {
    gl.GL_MAP_COLOR: ("map_color", bool), gl.GL_MAP_STENCIL: ("map_stencil", bool),
    gl.GL_INDEX_SHIFT: ("index_shift", int),
    gl.GL_INDEX_OFFSET: ("index_offset", int), gl.GL_DEPTH_SCALE: ("depth_scale", float),
    gl.GL_DEPTH_BIAS: ("depth_bias", float),
}  # fmt: skip


def glPixelTransfer(m: Machine, pname: int, param: float) -> None:
    for field, places in (("scale", SCALES), ("bias", BIASES)):
        if pname in places:
            values = list(getattr(m.pixel, field))
            values[places[pname]] = float(param)
            m.pixel = m.pixel._replace(**{field: tuple(values)})  # type: ignore[arg-type]
            return
    if pname not in TRANSFERS:
        raise invalid_enum("pname", pname, "GL_MAP_COLOR, GL_RED_SCALE, GL_RED_BIAS, GL_DEPTH_SCALE, ...")
    field, kind = TRANSFERS[pname]
    m.pixel = m.pixel._replace(**{field: kind(param)})


def glPixelMap(m: Machine, map: int, size: int, values: Any) -> None:
    """values: ``size`` colour components in [0, 1], or indices for GL_PIXEL_MAP_I_TO_I and S_TO_S."""
    _check_map(map)
    if not 1 <= size <= MAX_PIXEL_MAP_TABLE:
        raise invalid_value("size", size, f"from 1 to {MAX_PIXEL_MAP_TABLE}")
    if map in INDEXED and size & (size - 1):
        raise invalid_value("size", size, "a power of two for a map from indices")
    table = numbers(values)[:size]
    if len(table) < size:
        raise ValueError(f"glPixelMap: values needs {size} numbers, not {len(table)}")
    if map not in (gl.GL_PIXEL_MAP_I_TO_I, gl.GL_PIXEL_MAP_S_TO_S):
        table = tuple(min(max(value, 0.0), 1.0) for value in table)
    at = MAPS.index(map)
    m.pixel = m.pixel._replace(maps=(*m.pixel.maps[:at], table, *m.pixel.maps[at + 1 :]))


def glPixelMapfv(m: Machine, map: int, size: Any, values: Any = None) -> None:
    """glPixelMapfv(map, size, values), or in PyOpenGL's form glPixelMapfv(map, values)."""
    _pixel_map(m, map, size, values, 1.0)


def glPixelMapuiv(m: Machine, map: int, size: Any, values: Any = None) -> None:
    """As glPixelMapfv; components in [0, 2^32 - 1]."""
    _pixel_map(m, map, size, values, 4294967295.0)


def glPixelMapusv(m: Machine, map: int, size: Any, values: Any = None) -> None:
    """As glPixelMapfv; components in [0, 65535]."""
    _pixel_map(m, map, size, values, 65535.0)


def _pixel_map(m: Machine, map: int, size: Any, values: Any, one: float) -> None:
    table = numbers(size if values is None else values)
    if map not in (gl.GL_PIXEL_MAP_I_TO_I, gl.GL_PIXEL_MAP_S_TO_S):
        table = tuple(value / one for value in table)
    glPixelMap(m, map, len(table) if values is None else int(size), table)


def _check_map(map: int) -> None:
    if map not in MAPS:
        raise invalid_enum("map", map, "a pixel map such as GL_PIXEL_MAP_R_TO_R")


def glGetPixelMapfv(m: Machine, map: int, values: Any = None) -> Any:
    """The table of a pixel map, as float32."""
    return _get_pixel_map(m, map, values, 1.0, np.float32)


def glGetPixelMapuiv(m: Machine, map: int, values: Any = None) -> Any:
    """The table of a pixel map, as uint32; components in [0, 2^32 - 1]."""
    return _get_pixel_map(m, map, values, 4294967295.0, np.uint32)


def glGetPixelMapusv(m: Machine, map: int, values: Any = None) -> Any:
    """The table of a pixel map, as uint16; components in [0, 65535]."""
    return _get_pixel_map(m, map, values, 65535.0, np.uint16)


def _get_pixel_map(m: Machine, map: int, values: Any, one: float, dtype: type) -> Any:
    _check_map(map)
    table = np.array(m.pixel.map(map), np.float64)
    if map not in (gl.GL_PIXEL_MAP_I_TO_I, gl.GL_PIXEL_MAP_S_TO_S):
        table = table * one
    converted: Any = table.astype(dtype)
    return converted if values is None else fill(values, converted)


def glPixelZoom(m: Machine, zx: float, zy: float) -> None:
    m.pixel = m.pixel._replace(zoom=(float(zx), float(zy)))


# ---------------------------------------------------------------- drawing


def _check_size(m: Machine, width: int, height: int) -> None:
    if width < 0 or height < 0:
        raise invalid_value("width and height", (width, height), "at least 0")
    if max(width, height) > LARGEST_RECTANGLE:
        raise out_of_memory(f"a rectangle of {width} x {height} pixels is larger than any picture")
    if width * height > max(MOST_PIXELS, m.device.width * m.device.height):
        raise out_of_memory(f"{width} x {height} pixels are more than this picture has, and more than {MOST_PIXELS}")


def _add(m: Machine, kind: str, image: Any, copied: tuple[int, int, int, int] | None) -> None:
    m.add(Pixels(kind, image, copied, m.raster, m.pixel, m.snapshot()), 0 if image is None else image.nbytes)


def glDrawPixels(m: Machine, width: int, height: int, format: int, type: int, pixels: Any) -> None:
    """Draw a rectangle from the program's memory with its lower left corner at the current raster position."""
    _check_size(m, width, height)
    check(format, type)
    if format == gl.GL_STENCIL_INDEX and type == gl.GL_BITMAP and pixels is None:
        raise ValueError("pixels is None: pass bytes or an array")
    if not m.raster.valid:
        return
    values = unpack(m.stores.unpack, (int(height), int(width)), format, type, pixels)
    if format == gl.GL_STENCIL_INDEX:
        _add(m, "stencil", stencils(m.pixel, values), None)
    elif format == gl.GL_DEPTH_COMPONENT:
        _add(m, "depth", depths(m.pixel, values), None)
    else:
        _add(m, "color", colors(m.pixel, format, values), None)


KINDS: dict[int, str] = {gl.GL_COLOR: "color", gl.GL_DEPTH: "depth", gl.GL_STENCIL: "stencil"}


def glCopyPixels(m: Machine, x: int, y: int, width: int, height: int, type: int) -> None:
    """Draw a rectangle of the framebuffer again at the current raster position."""
    if type not in KINDS:
        raise invalid_enum("type", type, "GL_COLOR, GL_DEPTH or GL_STENCIL")
    _check_size(m, width, height)
    if m.raster.valid:
        _add(m, KINDS[type], None, (int(x), int(y), int(width), int(height)))


def glBitmap(
    m: Machine, width: int, height: int, xorig: float, yorig: float, xmove: float, ymove: float, bitmap: Any
) -> None:
    """Draw the 1 bits in the current raster colour, then move the raster position.  bitmap None only moves."""
    _check_size(m, width, height)
    raster = m.raster
    if not raster.valid:
        return
    if bitmap is not None and width and height:
        bits = unpack(m.stores.unpack, (int(height), int(width)), gl.GL_COLOR_INDEX, gl.GL_BITMAP, bitmap)
        at = raster._replace(x=float(np.floor(raster.x + 1e-4 - xorig)), y=float(np.floor(raster.y + 1e-4 - yorig)))
        m.add(Pixels("bitmap", bits, None, at, m.pixel, m.snapshot()), bits.nbytes)
    m.raster = raster._replace(x=raster.x + xmove, y=raster.y + ymove)


# ---------------------------------------------------------------- reading, and the choice of buffers

# There is one colour buffer: front and back, left, are the same picture.
BUFFERS = (gl.GL_FRONT, gl.GL_BACK, gl.GL_LEFT, gl.GL_FRONT_LEFT, gl.GL_BACK_LEFT)
ABSENT = (gl.GL_RIGHT, gl.GL_FRONT_RIGHT, gl.GL_BACK_RIGHT, *(gl.GL_AUX0 + k for k in range(4)))


def _check_buffer(argument: str, buffer: int, allowed: tuple[int, ...]) -> None:
    if buffer in ABSENT:
        raise invalid_operation(f"there is no {buffer!r} here: no stereo and no auxiliary buffers")
    if buffer not in allowed:
        raise invalid_enum(argument, buffer, "GL_FRONT, GL_BACK or another buffer")


def glDrawBuffer(m: Machine, buf: int) -> None:
    """GL_NONE switches colours off; front and back are the same picture."""
    _check_buffer("buf", buf, (*BUFFERS, gl.GL_FRONT_AND_BACK, gl.GL_NONE))
    m.color_buffer = m.color_buffer._replace(draw_buffer=buf)


def glReadBuffer(m: Machine, src: int) -> None:
    """Front and back are the same picture."""
    _check_buffer("src", src, (*BUFFERS, gl.GL_FRONT_AND_BACK, gl.GL_NONE))
    m.pixel = m.pixel._replace(read_buffer=src)


def glReadPixels(
    m: Machine, x: int, y: int, width: int, height: int, format: int, type: int, array: Any = None,
    outputType: Any = bytes,
) -> Any:  # fmt: skip
    """Pixels, bottom row first.  As PyOpenGL: bytes for GL_UNSIGNED_BYTE, else an array; or into ``array``."""
    _check_size(m, width, height)
    check(format, type)
    if format == gl.GL_COLOR_INDEX:
        raise invalid_operation("colour indices can only be read in colour-index mode, which is not emulated")
    if type == gl.GL_BITMAP:
        raise invalid_enum("type", type, "GL_UNSIGNED_BYTE or another number type")
    if m.pixel.read_buffer == gl.GL_NONE and format not in (gl.GL_DEPTH_COMPONENT, gl.GL_STENCIL_INDEX):
        raise invalid_operation("glReadBuffer(GL_NONE) left no colours to read")
    for buffer, wanted in (("depth", gl.GL_DEPTH_COMPONENT), ("stencil", gl.GL_STENCIL_INDEX)):
        if format == wanted and m.device.describe().get(f"{buffer}_bits") == 0:
            raise invalid_operation(
                f"the window has no {buffer} buffer: add GLUT_{buffer.upper()} to glutInitDisplayMode"
            )
    rectangle = int(x), int(y), int(width), int(height)
    m.flush()
    if format == gl.GL_DEPTH_COMPONENT:
        values = as_numbers(depths(m.pixel, m.device.read(*rectangle, "depth")[..., None]), DTYPES[type])
    elif format == gl.GL_STENCIL_INDEX:
        values = stencils(m.pixel, m.device.read(*rectangle, "stencil")[..., None]).astype(DTYPES[type])
    else:
        values = pack_colors(format, type, transferred(m.pixel, m.device.read(*rectangle, "color")))
    if array is None:
        return deliver(values, type, None, outputType)
    view = np.asarray(plain(array, values.size))
    if not (view.flags.c_contiguous and view.flags.writeable) or isinstance(array, (list, tuple, bytes)):
        raise TypeError("array must be a writable NumPy array or bytearray")
    if values.size:
        pack_into(m.stores.pack, values, view.reshape(-1).view(np.uint8))
    return array
