"""State queries and read-back: section 6 of the specification, and glReadPixels."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from glsim.gl.arrays import ARRAYS, client
from glsim.gl.enable import CAPS, LATER, glIsEnabled, series
from glsim.gl.fragment import HINTS
from glsim.gl.raster import LARGEST_LINE, LARGEST_POINT
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_value, out_of_memory
from glsim.machine.machine import ATTRIB_STACK_DEPTH, MAX_LIST_NESTING, STACK_DEPTH, Machine
from glsim.machine.state import MAX_CLIP_PLANES, MAX_LIGHTS
from glsim.machine.texture import MAX_TEXTURE_SIZE
from glsim.machine.types import DTYPES

Getter = Callable[[Machine], Any]

# Colours and the like: as integers they map linearly from [-1, 1] to the whole range (section 6.1.2).
COLOURS = {
    gl.GL_CURRENT_COLOR, gl.GL_CURRENT_NORMAL, gl.GL_LIGHT_MODEL_AMBIENT, gl.GL_COLOR_CLEAR_VALUE,
    gl.GL_DEPTH_CLEAR_VALUE, gl.GL_DEPTH_RANGE, gl.GL_CURRENT_SECONDARY_COLOR,
    gl.GL_AMBIENT, gl.GL_DIFFUSE, gl.GL_SPECULAR, gl.GL_EMISSION, gl.GL_FOG_COLOR, gl.GL_BLEND_COLOR,
    gl.GL_TEXTURE_ENV_COLOR, gl.GL_TEXTURE_BORDER_COLOR,
    gl.GL_ALPHA_TEST_REF,
}  # fmt: skip


def _signed(mask: int) -> int:
    """A 32-bit mask as glGetIntegerv returns it."""
    return mask - (1 << 32) if mask >= 1 << 31 else mask


GETTERS: dict[int, Getter] = {
    gl.GL_CURRENT_COLOR: lambda m: (m.red, m.green, m.blue, m.alpha),
    gl.GL_CURRENT_NORMAL: lambda m: (m.nx, m.ny, m.nz),
    gl.GL_CURRENT_TEXTURE_COORDS: lambda m: m.current["texcoord0"],
    gl.GL_CURRENT_SECONDARY_COLOR: lambda m: m.current["secondary_color"],
    gl.GL_CURRENT_FOG_COORDINATE: lambda m: m.current["fog_coord"][0],
    gl.GL_CURRENT_INDEX: lambda m: m.index,
    gl.GL_EDGE_FLAG: lambda m: m.current["edge_flag"][0],
    gl.GL_MATRIX_MODE: lambda m: m.transform.matrix_mode,
    gl.GL_MODELVIEW_MATRIX: lambda m: m.modelview[-1].get(),
    gl.GL_PROJECTION_MATRIX: lambda m: m.projection[-1].get(),
    gl.GL_TEXTURE_MATRIX: lambda m: m.texture_stack[-1].get(),
    gl.GL_TRANSPOSE_MODELVIEW_MATRIX: lambda m: m.modelview[-1].get().T,
    gl.GL_TRANSPOSE_PROJECTION_MATRIX: lambda m: m.projection[-1].get().T,
    gl.GL_TRANSPOSE_TEXTURE_MATRIX: lambda m: m.texture_stack[-1].get().T,
    gl.GL_MODELVIEW_STACK_DEPTH: lambda m: len(m.modelview),
    gl.GL_PROJECTION_STACK_DEPTH: lambda m: len(m.projection),
    gl.GL_TEXTURE_STACK_DEPTH: lambda m: len(m.texture_stack),
    gl.GL_MAX_MODELVIEW_STACK_DEPTH: lambda m: STACK_DEPTH[gl.GL_MODELVIEW],
    gl.GL_MAX_PROJECTION_STACK_DEPTH: lambda m: STACK_DEPTH[gl.GL_PROJECTION],
    gl.GL_MAX_TEXTURE_STACK_DEPTH: lambda m: STACK_DEPTH[gl.GL_TEXTURE],
    gl.GL_VIEWPORT: lambda m: m.viewport[:4],
    gl.GL_MAX_VIEWPORT_DIMS: lambda m: (16384, 16384),
    gl.GL_DEPTH_RANGE: lambda m: m.viewport[4:],
    gl.GL_LIGHT_MODEL_AMBIENT: lambda m: m.lighting.ambient,
    gl.GL_LIGHT_MODEL_LOCAL_VIEWER: lambda m: m.lighting.local_viewer,
    gl.GL_LIGHT_MODEL_TWO_SIDE: lambda m: m.lighting.two_side,
    gl.GL_LIGHT_MODEL_COLOR_CONTROL: lambda m: m.lighting.color_control,
    gl.GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM: lambda m: m.lighting.lobe,
    gl.GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM: lambda m: m.lighting.back_lighting,
    gl.GL_SHADE_MODEL: lambda m: m.lighting.shade_model,
    gl.GL_COLOR_MATERIAL_FACE: lambda m: m.lighting.color_material_face,
    gl.GL_COLOR_MATERIAL_PARAMETER: lambda m: m.lighting.color_material_mode,
    gl.GL_MAX_LIGHTS: lambda m: MAX_LIGHTS,
    gl.GL_CULL_FACE_MODE: lambda m: m.polygon.cull_face,
    gl.GL_FRONT_FACE: lambda m: m.polygon.front_face,
    gl.GL_DEPTH_FUNC: lambda m: m.depth.func,
    gl.GL_DEPTH_WRITEMASK: lambda m: m.depth.mask,
    gl.GL_DEPTH_CLEAR_VALUE: lambda m: m.depth.clear,
    gl.GL_COLOR_CLEAR_VALUE: lambda m: m.color_buffer.clear,
    gl.GL_COLOR_WRITEMASK: lambda m: m.color_buffer.mask,
    gl.GL_RGBA_MODE: lambda m: True,
    gl.GL_INDEX_MODE: lambda m: False,
    gl.GL_STEREO: lambda m: False,
    gl.GL_DOUBLEBUFFER: lambda m: False,
    gl.GL_RED_BITS: lambda m: 8,
    gl.GL_GREEN_BITS: lambda m: 8,
    gl.GL_BLUE_BITS: lambda m: 8,
    gl.GL_ALPHA_BITS: lambda m: 8,
    gl.GL_INDEX_BITS: lambda m: 0,
    gl.GL_DEPTH_BITS: lambda m: 24,
    gl.GL_STENCIL_BITS: lambda m: 8,
    gl.GL_SUBPIXEL_BITS: lambda m: 8,
    gl.GL_SAMPLES: lambda m: m.device.describe().get("samples", 0),
    gl.GL_SAMPLE_BUFFERS: lambda m: int(m.device.describe().get("samples", 0) > 0),
    gl.GL_LIST_INDEX: lambda m: 0,
    gl.GL_RENDER_MODE: lambda m: gl.GL_RENDER,
    gl.GL_MAX_TEXTURE_UNITS: lambda m: 1,
    gl.GL_POLYGON_MODE: lambda m: (m.polygon.front_mode, m.polygon.back_mode),
    gl.GL_POLYGON_OFFSET_FACTOR: lambda m: m.polygon.offset_factor,
    gl.GL_POLYGON_OFFSET_UNITS: lambda m: m.polygon.offset_units,
    gl.GL_POINT_SIZE: lambda m: m.point.size,
    gl.GL_POINT_SIZE_MIN: lambda m: m.point.size_min,
    gl.GL_POINT_SIZE_MAX: lambda m: m.point.size_max,
    gl.GL_POINT_FADE_THRESHOLD_SIZE: lambda m: m.point.fade_threshold,
    gl.GL_POINT_DISTANCE_ATTENUATION: lambda m: m.point.distance_attenuation,
    gl.GL_POINT_SIZE_RANGE: lambda m: (1.0, LARGEST_POINT),
    gl.GL_POINT_SIZE_GRANULARITY: lambda m: 0.1,
    gl.GL_ALIASED_POINT_SIZE_RANGE: lambda m: (1.0, LARGEST_POINT),
    gl.GL_LINE_WIDTH: lambda m: m.line.width,
    gl.GL_LINE_WIDTH_RANGE: lambda m: (1.0, LARGEST_LINE),
    gl.GL_LINE_WIDTH_GRANULARITY: lambda m: 0.1,
    gl.GL_ALIASED_LINE_WIDTH_RANGE: lambda m: (1.0, LARGEST_LINE),
    gl.GL_LINE_STIPPLE_PATTERN: lambda m: m.line.stipple_pattern,
    gl.GL_LINE_STIPPLE_REPEAT: lambda m: m.line.stipple_factor,
    gl.GL_TEXTURE_BINDING_1D: lambda m: m.texture.names[0],
    gl.GL_TEXTURE_BINDING_2D: lambda m: m.texture.names[1],
    gl.GL_MAX_TEXTURE_SIZE: lambda m: MAX_TEXTURE_SIZE,
    gl.GL_ACTIVE_TEXTURE: lambda m: gl.GL_TEXTURE0,
    gl.GL_CLIENT_ACTIVE_TEXTURE: lambda m: gl.GL_TEXTURE0,
    gl.GL_FOG_COLOR: lambda m: m.fog.color,
    gl.GL_FOG_MODE: lambda m: m.fog.mode,
    gl.GL_FOG_DENSITY: lambda m: m.fog.density,
    gl.GL_FOG_START: lambda m: m.fog.start,
    gl.GL_FOG_END: lambda m: m.fog.end,
    gl.GL_FOG_INDEX: lambda m: m.fog.color_index,
    gl.GL_FOG_COORDINATE_SOURCE: lambda m: m.fog.coordinate_source,
    gl.GL_SCISSOR_BOX: lambda m: m.scissor[1:],
    gl.GL_ALPHA_TEST_FUNC: lambda m: m.color_buffer.alpha_func,
    gl.GL_ALPHA_TEST_REF: lambda m: m.color_buffer.alpha_reference,
    gl.GL_STENCIL_FUNC: lambda m: m.stencil.func,
    gl.GL_STENCIL_REF: lambda m: m.stencil.reference,
    gl.GL_STENCIL_VALUE_MASK: lambda m: _signed(m.stencil.value_mask),
    gl.GL_STENCIL_WRITEMASK: lambda m: _signed(m.stencil.write_mask),
    gl.GL_STENCIL_FAIL: lambda m: m.stencil.fail,
    gl.GL_STENCIL_PASS_DEPTH_FAIL: lambda m: m.stencil.depth_fail,
    gl.GL_STENCIL_PASS_DEPTH_PASS: lambda m: m.stencil.depth_pass,
    gl.GL_STENCIL_CLEAR_VALUE: lambda m: m.stencil.clear,
    gl.GL_BLEND_SRC: lambda m: m.color_buffer.blend_function[0],
    gl.GL_BLEND_DST: lambda m: m.color_buffer.blend_function[1],
    gl.GL_BLEND_SRC_RGB: lambda m: m.color_buffer.blend_function[0],
    gl.GL_BLEND_DST_RGB: lambda m: m.color_buffer.blend_function[1],
    gl.GL_BLEND_SRC_ALPHA: lambda m: m.color_buffer.blend_function[2],
    gl.GL_BLEND_DST_ALPHA: lambda m: m.color_buffer.blend_function[3],
    gl.GL_BLEND_EQUATION: lambda m: m.color_buffer.blend_equation,
    gl.GL_BLEND_COLOR: lambda m: m.color_buffer.blend_color,
    gl.GL_LOGIC_OP_MODE: lambda m: m.color_buffer.logic_op,
    gl.GL_SAMPLE_COVERAGE_VALUE: lambda m: m.multisample.coverage_value,
    gl.GL_SAMPLE_COVERAGE_INVERT: lambda m: m.multisample.coverage_invert,
    gl.GL_MAX_CLIP_PLANES: lambda m: MAX_CLIP_PLANES,
    gl.GL_ATTRIB_STACK_DEPTH: lambda m: len(m.attrib_stack),
    gl.GL_MAX_ATTRIB_STACK_DEPTH: lambda m: ATTRIB_STACK_DEPTH,
    gl.GL_CLIENT_ATTRIB_STACK_DEPTH: lambda m: len(m.client_attrib_stack),
    gl.GL_MAX_CLIENT_ATTRIB_STACK_DEPTH: lambda m: ATTRIB_STACK_DEPTH,
    gl.GL_LIST_BASE: lambda m: m.list_base,
    gl.GL_MAX_LIST_NESTING: lambda m: MAX_LIST_NESTING,
}


def _pointer_getter(array: int, field: str) -> Getter:
    return lambda m: getattr(client(m, array).pointer, field)


for _array, _prefix in (
    (gl.GL_VERTEX_ARRAY, "VERTEX_ARRAY"), (gl.GL_COLOR_ARRAY, "COLOR_ARRAY"),
    (gl.GL_TEXTURE_COORD_ARRAY, "TEXTURE_COORD_ARRAY"), (gl.GL_NORMAL_ARRAY, "NORMAL_ARRAY"),
):  # fmt: skip
    for _field in ("size", "type", "stride"):
        _name = getattr(gl, f"GL_{_prefix}_{_field.upper()}", None)
        if _name is not None:
            GETTERS[_name] = _pointer_getter(_array, _field)


def _lookup(m: Machine, pname: int) -> Any:
    getter = GETTERS.get(pname)
    if getter is not None:
        return getter(m)
    if pname in CAPS or pname in LATER or series(pname):
        return glIsEnabled(m, pname)
    if pname in ARRAYS:
        return client(m, pname).enabled
    if pname in (*ALIGNMENTS, *UNPACKING, *IGNORED_IF_0):
        return m.pixel_store.get(pname, 4 if pname in ALIGNMENTS else 0)
    if pname in HINTS:
        return m.hints.get(pname, gl.GL_DONT_CARE)
    if any(pname == value for name, value in vars(gl).items() if name.startswith("GL_")):
        raise NotImplementedError(f"glGet({pname!r}) is not in glsim yet")
    raise invalid_enum("pname", pname, "a state variable such as GL_VIEWPORT")


def answer(values: Any, kind: str, colour: bool = False) -> Any:
    """Python numbers as PyOpenGL returns them: one number alone, else an array of the type asked for.

    kind: b boolean, i integer, f float32, d float64.
    """
    array: Any = np.asarray(values, np.float64)
    if kind == "i" and colour:
        array = np.trunc(np.float64(np.float32(array)) * 2147483647.0)  # 1.0 is the largest integer
    elif kind == "i":
        array = np.floor(array + 0.5)
    elif kind == "b":
        array = array != 0.0
    elif kind == "d":
        array = np.float32(array)
    array = array.astype({"b": np.uint8, "i": np.int32, "f": np.float32, "d": np.float64}[kind])
    return array.reshape(-1)[0] if array.size == 1 else array


def into(array: Any, values: Any) -> Any:
    """``values``, or ``array`` filled with them if the program gave one."""
    if array is None:
        return values
    if isinstance(array, list):
        array[: np.size(values)] = np.ravel(values).tolist()
        return array
    view = np.asarray(array)
    view.reshape(-1)[: np.size(values)] = np.ravel(values)
    return array


def glGetBooleanv(m: Machine, pname: int, params: Any = None) -> Any:
    return into(params, answer(_lookup(m, pname), "b"))


def glGetIntegerv(m: Machine, pname: int, params: Any = None) -> Any:
    return into(params, answer(_lookup(m, pname), "i", pname in COLOURS))


def glGetFloatv(m: Machine, pname: int, params: Any = None) -> Any:
    return into(params, answer(_lookup(m, pname), "f"))


def glGetDoublev(m: Machine, pname: int, params: Any = None) -> Any:
    return into(params, answer(_lookup(m, pname), "d"))


def glGetError(m: Machine) -> int:
    """Always GL_NO_ERROR: an error is raised by the call that causes it."""
    return int(gl.GL_NO_ERROR)


def glGetString(m: Machine, name: int) -> bytes:
    """As bytes, like PyOpenGL."""
    info = m.device.describe()
    if name == gl.GL_VENDOR:
        return b"glsim"
    if name == gl.GL_RENDERER:
        return f"glsim on {info['renderer']}".encode()
    if name == gl.GL_VERSION:
        from glsim import __version__

        return f"1.5 glsim {__version__} on OpenGL {info['version']}".encode()
    if name == gl.GL_EXTENSIONS:
        return b"GL_WIN_phong_shading GL_GLSIM_specular_lobe GL_GLSIM_back_lighting"
    raise invalid_enum("name", name, "GL_VENDOR, GL_RENDERER, GL_VERSION or GL_EXTENSIONS")


COMPONENTS = {
    gl.GL_RED: (0,), gl.GL_GREEN: (1,), gl.GL_BLUE: (2,), gl.GL_ALPHA: (3,),
    gl.GL_RGB: (0, 1, 2), gl.GL_RGBA: (0, 1, 2, 3), gl.GL_BGR: (2, 1, 0), gl.GL_BGRA: (2, 1, 0, 3),
}  # fmt: skip
LARGEST_RECTANGLE = 16384
ALIGNMENTS = (gl.GL_PACK_ALIGNMENT, gl.GL_UNPACK_ALIGNMENT)
UNPACKING = (gl.GL_UNPACK_ROW_LENGTH, gl.GL_UNPACK_SKIP_ROWS, gl.GL_UNPACK_SKIP_PIXELS, gl.GL_UNPACK_SWAP_BYTES)
IGNORED_IF_0 = (
    gl.GL_PACK_SWAP_BYTES, gl.GL_PACK_LSB_FIRST, gl.GL_PACK_ROW_LENGTH, gl.GL_PACK_SKIP_ROWS, gl.GL_PACK_SKIP_PIXELS,
    gl.GL_PACK_IMAGE_HEIGHT, gl.GL_PACK_SKIP_IMAGES, gl.GL_UNPACK_LSB_FIRST, gl.GL_UNPACK_IMAGE_HEIGHT,
    gl.GL_UNPACK_SKIP_IMAGES,
)  # fmt: skip


def glPixelStore(m: Machine, pname: int, param: float) -> None:
    """How pixels lie in the program's memory.  Read-back comes tightly packed, as PyOpenGL asks for."""
    if pname in ALIGNMENTS:
        if param not in (1, 2, 4, 8):
            raise invalid_value("param", param, "1, 2, 4 or 8")
    elif pname in IGNORED_IF_0:
        if param != 0:
            raise NotImplementedError(f"glPixelStore({pname!r}) with anything but 0 is not in glsim yet")
    elif pname not in UNPACKING:
        raise invalid_enum("pname", pname, "GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH or another way to store pixels")
    elif param < 0:
        raise invalid_value("param", param, "at least 0")
    m.pixel_store = {**m.pixel_store, int(pname): int(param)}


def glReadPixels(
    m: Machine,
    x: int,
    y: int,
    width: int,
    height: int,
    format: int,
    type: int,
    array: Any = None,
    outputType: Any = bytes,
) -> Any:
    """Pixels, bottom row first.  As PyOpenGL: bytes for GL_UNSIGNED_BYTE, else an array; or into ``array``."""
    if width < 0 or height < 0:
        raise invalid_value("width and height", (width, height), "at least 0")
    if max(width, height) > LARGEST_RECTANGLE:
        raise out_of_memory(f"a rectangle of {width} x {height} pixels is larger than any picture")
    dtype = DTYPES.get(type)
    if dtype is None:
        raise invalid_enum("type", type, "GL_UNSIGNED_BYTE, GL_FLOAT or another number type")
    x, y, width, height = int(x), int(y), int(width), int(height)
    m.flush()
    if format == gl.GL_DEPTH_COMPONENT:
        pixels = m.device.read(x, y, width, height, "depth")[..., None]
    elif format in COMPONENTS:
        pixels = m.device.read(x, y, width, height, "color")[..., COMPONENTS[format]]  # type: ignore[index]
    elif format == gl.GL_STENCIL_INDEX:
        pixels = m.device.read(x, y, width, height, "stencil")[..., None]
        return _deliver(pixels.astype(dtype), type, array, outputType, width, height)
    elif format in (gl.GL_COLOR_INDEX, gl.GL_LUMINANCE, gl.GL_LUMINANCE_ALPHA):
        raise NotImplementedError(f"glReadPixels of {format!r} is not in glsim yet")
    else:
        raise invalid_enum("format", format, "GL_RGB, GL_RGBA or GL_DEPTH_COMPONENT")
    return _deliver(_convert(pixels, dtype), type, array, outputType, width, height)


def _deliver(converted: Any, type: int, array: Any, outputType: Any, width: int, height: int) -> Any:
    """Pixels (height, width, components) in the form that PyOpenGL returns."""
    if array is not None:
        np.copyto(np.asarray(array).reshape(converted.shape), converted)
        return array
    if type == gl.GL_UNSIGNED_BYTE and outputType is bytes:
        return converted.tobytes()
    # PyOpenGL's shape: (width, height, components) over memory that is in rows
    shape = (width, height, converted.shape[2]) if converted.shape[2] > 1 else (width, height)
    return converted.reshape(shape)


def _convert(pixels: Any, dtype: type) -> Any:
    """Components as stored (uint8 in [0, 255], depth as float in [0, 1]) -> the type asked for (table 4.7)."""
    if pixels.dtype == dtype:
        return np.ascontiguousarray(pixels)
    unit = pixels / 255.0 if pixels.dtype == np.uint8 else pixels.astype(np.float64)
    if np.dtype(dtype).kind == "f":
        return unit.astype(dtype)
    bits = 8 * np.dtype(dtype).itemsize
    if np.dtype(dtype).kind == "u":
        return np.floor(unit * (2.0**bits - 1.0) + 0.5).astype(dtype)
    return np.floor(((2.0**bits - 1.0) * unit - 1.0) / 2.0 + 0.5).astype(dtype)
