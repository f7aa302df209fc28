"""State queries and read-back: section 6 of the specification, and glReadPixels."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from glsim.gl.arrays import ARRAYS, array_key, client
from glsim.gl.enable import CAPS, UNIT_CAPS, glIsEnabled
from glsim.gl.evaluators import MAX_EVAL_ORDER
from glsim.gl.fragment import HINTS
from glsim.gl.pixels import BIASES, MAX_PIXEL_MAP_TABLE, SCALES
from glsim.gl.raster import LARGEST_LINE, LARGEST_POINT
from glsim.gl.select import MAX_NAME_STACK_DEPTH
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_value
from glsim.machine.machine import ATTRIB_STACK_DEPTH, MAX_LIST_NESTING, STACK_DEPTH, Machine
from glsim.machine.pixels import MAPS, PACK_FIELDS, UNPACK_FIELDS
from glsim.machine.state import MAX_CLIP_PLANES, MAX_LIGHTS, TEXTURE_UNITS
from glsim.machine.texture import MAX_3D_TEXTURE_SIZE, MAX_TEXTURE_SIZE
from glsim.machine.types import fill

Getter = Callable[[Machine], Any]

# Colours and the like: as integers they map linearly from [-1, 1] to the whole range (section 6.1.2).
COLOURS = {
    gl.GL_CURRENT_COLOR, gl.GL_CURRENT_NORMAL, gl.GL_LIGHT_MODEL_AMBIENT, gl.GL_COLOR_CLEAR_VALUE,
    gl.GL_DEPTH_CLEAR_VALUE, gl.GL_DEPTH_RANGE, gl.GL_CURRENT_SECONDARY_COLOR,
    gl.GL_AMBIENT, gl.GL_DIFFUSE, gl.GL_SPECULAR, gl.GL_EMISSION, gl.GL_FOG_COLOR, gl.GL_BLEND_COLOR,
    gl.GL_TEXTURE_ENV_COLOR, gl.GL_TEXTURE_BORDER_COLOR,
    gl.GL_ALPHA_TEST_REF, gl.GL_CURRENT_RASTER_COLOR, gl.GL_ACCUM_CLEAR_VALUE,
}  # fmt: skip


def _signed(mask: int) -> int:
    """A 32-bit mask as glGetIntegerv returns it."""
    return mask - (1 << 32) if mask >= 1 << 31 else mask


GETTERS: dict[int, Getter] = {
    gl.GL_CURRENT_COLOR: lambda m: (m.red, m.green, m.blue, m.alpha),
    gl.GL_CURRENT_NORMAL: lambda m: (m.nx, m.ny, m.nz),
    gl.GL_CURRENT_TEXTURE_COORDS: lambda m: m.current[f"texcoord{m.texture.active_unit}"],
    gl.GL_CURRENT_SECONDARY_COLOR: lambda m: m.current["secondary_color"],
    gl.GL_CURRENT_FOG_COORDINATE: lambda m: m.current["fog_coord"][0],
    gl.GL_CURRENT_INDEX: lambda m: m.index,
    gl.GL_EDGE_FLAG: lambda m: m.current["edge_flag"][0],
    gl.GL_MATRIX_MODE: lambda m: m.transform.matrix_mode,
    gl.GL_MODELVIEW_MATRIX: lambda m: m.modelview[-1].get(),
    gl.GL_PROJECTION_MATRIX: lambda m: m.projection[-1].get(),
    gl.GL_TEXTURE_MATRIX: lambda m: m.stacks[gl.GL_TEXTURE][-1].get(),
    gl.GL_TRANSPOSE_MODELVIEW_MATRIX: lambda m: m.modelview[-1].get().T,
    gl.GL_TRANSPOSE_PROJECTION_MATRIX: lambda m: m.projection[-1].get().T,
    gl.GL_TRANSPOSE_TEXTURE_MATRIX: lambda m: m.stacks[gl.GL_TEXTURE][-1].get().T,
    gl.GL_MODELVIEW_STACK_DEPTH: lambda m: len(m.modelview),
    gl.GL_PROJECTION_STACK_DEPTH: lambda m: len(m.projection),
    gl.GL_TEXTURE_STACK_DEPTH: lambda m: len(m.stacks[gl.GL_TEXTURE]),
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
    gl.GL_DOUBLEBUFFER: lambda m: m.device.describe().get("double", False),
    gl.GL_RED_BITS: lambda m: 8,
    gl.GL_GREEN_BITS: lambda m: 8,
    gl.GL_BLUE_BITS: lambda m: 8,
    gl.GL_ALPHA_BITS: lambda m: 8,
    gl.GL_INDEX_BITS: lambda m: 0,
    gl.GL_DEPTH_BITS: lambda m: m.device.describe().get("depth_bits", 24),
    gl.GL_STENCIL_BITS: lambda m: m.device.describe().get("stencil_bits", 8),
    gl.GL_SUBPIXEL_BITS: lambda m: 8,
    gl.GL_SAMPLES: lambda m: m.device.describe().get("samples", 0),
    gl.GL_SAMPLE_BUFFERS: lambda m: int(m.device.describe().get("samples", 0) > 0),
    gl.GL_LIST_INDEX: lambda m: 0,
    gl.GL_RENDER_MODE: lambda m: m.rendering.mode,
    gl.GL_NAME_STACK_DEPTH: lambda m: len(m.rendering.selection.names) if m.rendering.selection else 0,
    gl.GL_MAX_NAME_STACK_DEPTH: lambda m: MAX_NAME_STACK_DEPTH,
    gl.GL_SELECTION_BUFFER_SIZE: lambda m: len(m.rendering.selection.buffer) if m.rendering.selection else 0,
    gl.GL_FEEDBACK_BUFFER_SIZE: lambda m: len(m.rendering.feedback.buffer) if m.rendering.feedback else 0,
    gl.GL_FEEDBACK_BUFFER_TYPE: lambda m: m.rendering.feedback.type if m.rendering.feedback else gl.GL_2D,
    gl.GL_MAX_TEXTURE_UNITS: lambda m: TEXTURE_UNITS,
    gl.GL_CURRENT_RASTER_POSITION: lambda m: (m.raster.x, m.raster.y, m.raster.z, m.raster.w),
    gl.GL_CURRENT_RASTER_POSITION_VALID: lambda m: m.raster.valid,
    gl.GL_CURRENT_RASTER_DISTANCE: lambda m: m.raster.distance,
    gl.GL_CURRENT_RASTER_COLOR: lambda m: m.raster.color,
    gl.GL_CURRENT_RASTER_INDEX: lambda m: 1.0,
    gl.GL_CURRENT_RASTER_TEXTURE_COORDS: lambda m: m.raster.texcoords[m.texture.active_unit],
    gl.GL_ZOOM_X: lambda m: m.pixel.zoom[0],
    gl.GL_ZOOM_Y: lambda m: m.pixel.zoom[1],
    gl.GL_MAP_COLOR: lambda m: m.pixel.map_color,
    gl.GL_MAP_STENCIL: lambda m: m.pixel.map_stencil,
    gl.GL_INDEX_SHIFT: lambda m: m.pixel.index_shift,
    gl.GL_INDEX_OFFSET: lambda m: m.pixel.index_offset,
    gl.GL_DEPTH_SCALE: lambda m: m.pixel.depth_scale,
    gl.GL_DEPTH_BIAS: lambda m: m.pixel.depth_bias,
    gl.GL_READ_BUFFER: lambda m: m.pixel.read_buffer,
    gl.GL_DRAW_BUFFER: lambda m: m.color_buffer.draw_buffer,
    gl.GL_AUX_BUFFERS: lambda m: 0,
    gl.GL_MAX_PIXEL_MAP_TABLE: lambda m: MAX_PIXEL_MAP_TABLE,
    gl.GL_ACCUM_CLEAR_VALUE: lambda m: m.accum_clear,
    gl.GL_ACCUM_RED_BITS: lambda m: 32,
    gl.GL_ACCUM_GREEN_BITS: lambda m: 32,
    gl.GL_ACCUM_BLUE_BITS: lambda m: 32,
    gl.GL_ACCUM_ALPHA_BITS: lambda m: 32,
    gl.GL_INDEX_CLEAR_VALUE: lambda m: 0.0,
    gl.GL_INDEX_WRITEMASK: lambda m: -1,
    gl.GL_MAP1_GRID_DOMAIN: lambda m: m.evaluators.grid_1[1:],
    gl.GL_MAP1_GRID_SEGMENTS: lambda m: m.evaluators.grid_1[0],
    gl.GL_MAP2_GRID_DOMAIN: lambda m: (*m.evaluators.grid_2[1:3], *m.evaluators.grid_2[4:]),
    gl.GL_MAP2_GRID_SEGMENTS: lambda m: (m.evaluators.grid_2[0], m.evaluators.grid_2[3]),
    gl.GL_MAX_EVAL_ORDER: lambda m: MAX_EVAL_ORDER,
    gl.GL_ARRAY_BUFFER_BINDING: lambda m: m.client.array_buffer,
    gl.GL_ELEMENT_ARRAY_BUFFER_BINDING: lambda m: m.client.element_buffer,
    gl.GL_TEXTURE_BINDING_3D: lambda m: m.texture.unit.names[2],
    gl.GL_TEXTURE_BINDING_CUBE_MAP: lambda m: m.texture.unit.names[3],
    gl.GL_MAX_3D_TEXTURE_SIZE: lambda m: MAX_3D_TEXTURE_SIZE,
    gl.GL_MAX_CUBE_MAP_TEXTURE_SIZE: lambda m: MAX_TEXTURE_SIZE,
    gl.GL_MAX_TEXTURE_LOD_BIAS: lambda m: 15.0,
    gl.GL_NUM_COMPRESSED_TEXTURE_FORMATS: lambda m: 0,
    gl.GL_COMPRESSED_TEXTURE_FORMATS: lambda m: (),
    gl.GL_LIST_MODE: lambda m: 0,
    gl.GL_MAX_ELEMENTS_VERTICES: lambda m: 1 << 20,
    gl.GL_MAX_ELEMENTS_INDICES: lambda m: 1 << 20,
    gl.GL_SMOOTH_POINT_SIZE_RANGE: lambda m: (1.0, LARGEST_POINT),
    gl.GL_SMOOTH_LINE_WIDTH_RANGE: lambda m: (1.0, LARGEST_LINE),
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
    gl.GL_TEXTURE_BINDING_1D: lambda m: m.texture.unit.names[0],
    gl.GL_TEXTURE_BINDING_2D: lambda m: m.texture.unit.names[1],
    gl.GL_MAX_TEXTURE_SIZE: lambda m: MAX_TEXTURE_SIZE,
    gl.GL_ACTIVE_TEXTURE: lambda m: gl.GL_TEXTURE0 + m.texture.active_unit,
    gl.GL_CLIENT_ACTIVE_TEXTURE: lambda m: gl.GL_TEXTURE0 + m.client.unit,
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
    gl.GL_MAJOR_VERSION: lambda m: 1,
    gl.GL_MINOR_VERSION: lambda m: 5,
    gl.GL_NUM_EXTENSIONS: lambda m: len(EXTENSIONS.split()),
    gl.GL_LIST_BASE: lambda m: m.list_base,
    gl.GL_MAX_LIST_NESTING: lambda m: MAX_LIST_NESTING,
}


# GL_PIXEL_MAP_I_TO_I_SIZE and on: the order in which the sizes of the pixel maps are numbered
GL_MAP_SIZES = int(gl.GL_PIXEL_MAP_I_TO_I_SIZE)
SIZED_MAPS = sorted(int(name) for name in MAPS)


def _pointer_getter(array: int, field: str) -> Getter:
    return lambda m: getattr(client(m, array_key(m, array)).pointer, field)


for _prefix, _array in ((repr(array)[3:], array) for array in ARRAYS.values()):
    for _suffix, _field in (("SIZE", "size"), ("TYPE", "type"), ("STRIDE", "stride"), ("BUFFER_BINDING", "buffer")):
        _name = getattr(gl, f"GL_{_prefix}_{_suffix}", None)
        if _name is not None:
            GETTERS[_name] = _pointer_getter(_array, _field)
for _names, _field in ((SCALES, "scale"), (BIASES, "bias")):
    for _name, _place in _names.items():
        GETTERS[_name] = lambda m, _field=_field, _place=_place: getattr(m.pixel, _field)[_place]  # type: ignore[misc]


def _lookup(m: Machine, pname: int) -> Any:
    getter = GETTERS.get(pname)
    if getter is not None:
        return getter(m)
    if pname in CAPS or pname in UNIT_CAPS or pname in ARRAYS:
        return glIsEnabled(m, pname)
    if pname in UNPACK_FIELDS:
        return getattr(m.stores.unpack, UNPACK_FIELDS[pname])
    if pname in PACK_FIELDS:
        return getattr(m.stores.pack, PACK_FIELDS[pname])
    if pname - GL_MAP_SIZES in range(len(SIZED_MAPS)):
        return len(m.pixel.map(SIZED_MAPS[pname - GL_MAP_SIZES]))
    if pname in HINTS:
        return getattr(m.hints, HINTS[pname])
    raise invalid_enum("pname", pname, "a state variable such as GL_VIEWPORT")


def answer(values: Any, kind: str, colour: bool = False) -> Any:
    """Python numbers as PyOpenGL returns them: one number alone, else an array of the type asked for.

    kind: b boolean, i or ui integer, f float32, d float64.
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
    array = array.astype({"b": np.uint8, "i": np.int32, "ui": np.uint32, "f": np.float32, "d": np.float64}[kind])
    return array.reshape(-1)[0] if array.size == 1 else array


def into(array: Any, values: Any) -> Any:
    """``values``, or ``array`` filled with them if the program gave one."""
    return values if array is None else fill(array, values)


def glGetBooleanv(m: Machine, pname: int, params: Any = None) -> Any:
    return into(params, answer(_lookup(m, pname), "b"))


def glGetIntegerv(m: Machine, pname: int, params: Any = None) -> Any:
    return into(params, answer(_lookup(m, pname), "i", pname in COLOURS))


def glGetFloatv(m: Machine, pname: int, params: Any = None) -> Any:
    return into(params, answer(_lookup(m, pname), "f"))


def glGetDoublev(m: Machine, pname: int, params: Any = None) -> Any:
    return into(params, answer(_lookup(m, pname), "d"))


# pname of glGetPointerv -> vertex array
POINTERS: dict[int, int] = {
    gl.GL_VERTEX_ARRAY_POINTER: gl.GL_VERTEX_ARRAY, gl.GL_NORMAL_ARRAY_POINTER: gl.GL_NORMAL_ARRAY,
    gl.GL_COLOR_ARRAY_POINTER: gl.GL_COLOR_ARRAY, gl.GL_INDEX_ARRAY_POINTER: gl.GL_INDEX_ARRAY,
    gl.GL_TEXTURE_COORD_ARRAY_POINTER: gl.GL_TEXTURE_COORD_ARRAY,
    gl.GL_EDGE_FLAG_ARRAY_POINTER: gl.GL_EDGE_FLAG_ARRAY,
    gl.GL_FOG_COORDINATE_ARRAY_POINTER: gl.GL_FOG_COORDINATE_ARRAY,
    gl.GL_SECONDARY_COLOR_ARRAY_POINTER: gl.GL_SECONDARY_COLOR_ARRAY,
}  # fmt: skip


def glGetPointerv(m: Machine, pname: int) -> Any:
    """The array itself, or the offset into a buffer object; None if none was given."""
    if pname in POINTERS:
        pointer = client(m, array_key(m, POINTERS[pname])).pointer
        return pointer.offset if pointer.buffer else pointer.data
    if pname == gl.GL_SELECTION_BUFFER_POINTER:
        return m.rendering.selection.buffer if m.rendering.selection else None
    if pname == gl.GL_FEEDBACK_BUFFER_POINTER:
        return m.rendering.feedback.buffer if m.rendering.feedback else None
    raise invalid_enum("pname", pname, "a pointer such as GL_VERTEX_ARRAY_POINTER")


def glGetError(m: Machine) -> int:
    """Always GL_NO_ERROR: an error is raised by the call that causes it."""
    return int(gl.GL_NO_ERROR)


# glsim's own, and those that became part of OpenGL 1.1 to 1.5
EXTENSIONS: bytes = (
    b"GL_WIN_phong_shading GL_GLSIM_specular_lobe GL_GLSIM_back_lighting GL_GLSIM_affine_interpolation "
    b"GL_ARB_depth_texture GL_ARB_multitexture GL_ARB_occlusion_query GL_ARB_point_parameters GL_ARB_shadow "
    b"GL_ARB_texture_border_clamp GL_ARB_texture_cube_map GL_ARB_texture_env_add GL_ARB_texture_env_combine "
    b"GL_ARB_texture_env_crossbar "
    b"GL_ARB_texture_env_dot3 GL_ARB_texture_mirrored_repeat GL_ARB_transpose_matrix GL_ARB_vertex_buffer_object "
    b"GL_ARB_window_pos GL_EXT_bgra GL_EXT_blend_color GL_EXT_blend_func_separate GL_EXT_blend_minmax "
    b"GL_EXT_blend_subtract GL_EXT_draw_range_elements GL_EXT_fog_coord GL_EXT_multi_draw_arrays GL_EXT_packed_pixels "
    b"GL_EXT_rescale_normal GL_EXT_secondary_color GL_EXT_separate_specular_color GL_EXT_stencil_wrap GL_EXT_texture3D "
    b"GL_EXT_texture_lod_bias GL_SGIS_generate_mipmap GL_SGIS_texture_edge_clamp GL_SGIS_texture_lod"
)


# OpenGL 1.5 has no shading language.  Programs of later versions print this string, or compare its number.
NO_SHADING_LANGUAGE = (
    b"0.0 none: OpenGL 1.5 has no shaders; glsim.program_source() shows the GLSL that glsim draws with"
)


def glGetString(m: Machine, name: int) -> bytes:
    """As bytes, like PyOpenGL."""
    info = m.device.describe()
    if name == gl.GL_VENDOR:
        return b"glsim"
    if name == gl.GL_RENDERER:
        return f"glsim on {info['renderer']}".encode()
    if name == gl.GL_VERSION:
        from glsim.version import __version__

        return f"1.5 glsim {__version__} on OpenGL {info['version']}".encode()
    if name == gl.GL_EXTENSIONS:
        return EXTENSIONS
    if name == gl.GL_SHADING_LANGUAGE_VERSION:
        return NO_SHADING_LANGUAGE
    raise invalid_enum("name", name, "GL_VENDOR, GL_RENDERER, GL_VERSION or GL_EXTENSIONS")


def glGetStringi(m: Machine, name: int, index: int) -> bytes:
    """The extensions one by one, from 0 to GL_NUM_EXTENSIONS - 1."""
    if name != gl.GL_EXTENSIONS:
        raise invalid_enum("name", name, "GL_EXTENSIONS")
    names = EXTENSIONS.split()
    if not 0 <= index < len(names):
        raise invalid_value("index", index, f"from 0 to {len(names) - 1}")
    return names[int(index)]
