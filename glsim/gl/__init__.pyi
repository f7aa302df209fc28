"""Signatures and manual of the gl commands.  Written by ``python -m glsim.gl.generate``; do not edit."""

import ctypes
from collections.abc import Sequence
from typing import Any

from glsim.machine.constants import Enum
from glsim.machine.errors import GLError as GLError
from glsim.machine.errors import NoContextError as NoContextError

Numbers = float | Sequence[Any] | Any  # a number, a sequence of numbers, a numpy or ctypes array

__all__ = [
    "GLError",
    "GL_2D",
    "GL_2_BYTES",
    "GL_3D",
    "GL_3D_COLOR",
    "GL_3D_COLOR_TEXTURE",
    "GL_3_BYTES",
    "GL_4D_COLOR_TEXTURE",
    "GL_4_BYTES",
    "GL_ACCUM",
    "GL_ACCUM_ALPHA_BITS",
    "GL_ACCUM_BLUE_BITS",
    "GL_ACCUM_BUFFER_BIT",
    "GL_ACCUM_CLEAR_VALUE",
    "GL_ACCUM_GREEN_BITS",
    "GL_ACCUM_RED_BITS",
    "GL_ACTIVE_TEXTURE",
    "GL_ADD",
    "GL_ADD_SIGNED",
    "GL_AFFINE_GLSIM",
    "GL_ALIASED_LINE_WIDTH_RANGE",
    "GL_ALIASED_POINT_SIZE_RANGE",
    "GL_ALL_ATTRIB_BITS",
    "GL_ALL_CLIENT_ATTRIB_BITS",
    "GL_ALPHA",
    "GL_ALPHA12",
    "GL_ALPHA16",
    "GL_ALPHA4",
    "GL_ALPHA8",
    "GL_ALPHA_BIAS",
    "GL_ALPHA_BITS",
    "GL_ALPHA_SCALE",
    "GL_ALPHA_TEST",
    "GL_ALPHA_TEST_FUNC",
    "GL_ALPHA_TEST_REF",
    "GL_ALWAYS",
    "GL_AMBIENT",
    "GL_AMBIENT_AND_DIFFUSE",
    "GL_AND",
    "GL_AND_INVERTED",
    "GL_AND_REVERSE",
    "GL_ARRAY_BUFFER",
    "GL_ARRAY_BUFFER_BINDING",
    "GL_ATTRIB_STACK_DEPTH",
    "GL_AUTO_NORMAL",
    "GL_AUX0",
    "GL_AUX1",
    "GL_AUX2",
    "GL_AUX3",
    "GL_AUX_BUFFERS",
    "GL_BACK",
    "GL_BACK_LEFT",
    "GL_BACK_RIGHT",
    "GL_BGR",
    "GL_BGRA",
    "GL_BITMAP",
    "GL_BITMAP_TOKEN",
    "GL_BLEND",
    "GL_BLEND_COLOR",
    "GL_BLEND_DST",
    "GL_BLEND_DST_ALPHA",
    "GL_BLEND_DST_RGB",
    "GL_BLEND_EQUATION",
    "GL_BLEND_SRC",
    "GL_BLEND_SRC_ALPHA",
    "GL_BLEND_SRC_RGB",
    "GL_BLINN_TORRANCE_GLSIM",
    "GL_BLUE",
    "GL_BLUE_BIAS",
    "GL_BLUE_BITS",
    "GL_BLUE_SCALE",
    "GL_BUFFER_ACCESS",
    "GL_BUFFER_MAPPED",
    "GL_BUFFER_MAP_POINTER",
    "GL_BUFFER_SIZE",
    "GL_BUFFER_USAGE",
    "GL_BYTE",
    "GL_C3F_V3F",
    "GL_C4F_N3F_V3F",
    "GL_C4UB_V2F",
    "GL_C4UB_V3F",
    "GL_CCW",
    "GL_CLAMP",
    "GL_CLAMP_NORMAL_GLSIM",
    "GL_CLAMP_TO_BORDER",
    "GL_CLAMP_TO_EDGE",
    "GL_CLEAR",
    "GL_CLIENT_ACTIVE_TEXTURE",
    "GL_CLIENT_ALL_ATTRIB_BITS",
    "GL_CLIENT_ATTRIB_STACK_DEPTH",
    "GL_CLIENT_PIXEL_STORE_BIT",
    "GL_CLIENT_VERTEX_ARRAY_BIT",
    "GL_CLIP_PLANE0",
    "GL_CLIP_PLANE1",
    "GL_CLIP_PLANE2",
    "GL_CLIP_PLANE3",
    "GL_CLIP_PLANE4",
    "GL_CLIP_PLANE5",
    "GL_COEFF",
    "GL_COLOR",
    "GL_COLOR_ARRAY",
    "GL_COLOR_ARRAY_BUFFER_BINDING",
    "GL_COLOR_ARRAY_POINTER",
    "GL_COLOR_ARRAY_SIZE",
    "GL_COLOR_ARRAY_STRIDE",
    "GL_COLOR_ARRAY_TYPE",
    "GL_COLOR_BUFFER_BIT",
    "GL_COLOR_CLEAR_VALUE",
    "GL_COLOR_INDEX",
    "GL_COLOR_INDEXES",
    "GL_COLOR_LOGIC_OP",
    "GL_COLOR_MATERIAL",
    "GL_COLOR_MATERIAL_FACE",
    "GL_COLOR_MATERIAL_PARAMETER",
    "GL_COLOR_SUM",
    "GL_COLOR_WRITEMASK",
    "GL_COMBINE",
    "GL_COMBINE_ALPHA",
    "GL_COMBINE_RGB",
    "GL_COMPARE_R_TO_TEXTURE",
    "GL_COMPILE",
    "GL_COMPILE_AND_EXECUTE",
    "GL_COMPRESSED_ALPHA",
    "GL_COMPRESSED_INTENSITY",
    "GL_COMPRESSED_LUMINANCE",
    "GL_COMPRESSED_LUMINANCE_ALPHA",
    "GL_COMPRESSED_RGB",
    "GL_COMPRESSED_RGBA",
    "GL_COMPRESSED_TEXTURE_FORMATS",
    "GL_CONSTANT",
    "GL_CONSTANT_ALPHA",
    "GL_CONSTANT_ATTENUATION",
    "GL_CONSTANT_COLOR",
    "GL_COPY",
    "GL_COPY_INVERTED",
    "GL_COPY_PIXEL_TOKEN",
    "GL_CULL_FACE",
    "GL_CULL_FACE_MODE",
    "GL_CURRENT_BIT",
    "GL_CURRENT_COLOR",
    "GL_CURRENT_FOG_COORD",
    "GL_CURRENT_FOG_COORDINATE",
    "GL_CURRENT_INDEX",
    "GL_CURRENT_NORMAL",
    "GL_CURRENT_QUERY",
    "GL_CURRENT_RASTER_COLOR",
    "GL_CURRENT_RASTER_DISTANCE",
    "GL_CURRENT_RASTER_INDEX",
    "GL_CURRENT_RASTER_POSITION",
    "GL_CURRENT_RASTER_POSITION_VALID",
    "GL_CURRENT_RASTER_TEXTURE_COORDS",
    "GL_CURRENT_SECONDARY_COLOR",
    "GL_CURRENT_TEXTURE_COORDS",
    "GL_CW",
    "GL_DECAL",
    "GL_DECR",
    "GL_DECR_WRAP",
    "GL_DEPTH",
    "GL_DEPTH_BIAS",
    "GL_DEPTH_BITS",
    "GL_DEPTH_BUFFER_BIT",
    "GL_DEPTH_CLEAR_VALUE",
    "GL_DEPTH_COMPONENT",
    "GL_DEPTH_COMPONENT16",
    "GL_DEPTH_COMPONENT24",
    "GL_DEPTH_COMPONENT32",
    "GL_DEPTH_FUNC",
    "GL_DEPTH_RANGE",
    "GL_DEPTH_SCALE",
    "GL_DEPTH_TEST",
    "GL_DEPTH_TEXTURE_MODE",
    "GL_DEPTH_WRITEMASK",
    "GL_DIFFUSE",
    "GL_DITHER",
    "GL_DOMAIN",
    "GL_DONT_CARE",
    "GL_DOT3_RGB",
    "GL_DOT3_RGBA",
    "GL_DOUBLE",
    "GL_DOUBLEBUFFER",
    "GL_DRAW_BUFFER",
    "GL_DRAW_PIXEL_TOKEN",
    "GL_DST_ALPHA",
    "GL_DST_COLOR",
    "GL_DYNAMIC_COPY",
    "GL_DYNAMIC_DRAW",
    "GL_DYNAMIC_READ",
    "GL_EDGE_FLAG",
    "GL_EDGE_FLAG_ARRAY",
    "GL_EDGE_FLAG_ARRAY_BUFFER_BINDING",
    "GL_EDGE_FLAG_ARRAY_POINTER",
    "GL_EDGE_FLAG_ARRAY_STRIDE",
    "GL_ELEMENT_ARRAY_BUFFER",
    "GL_ELEMENT_ARRAY_BUFFER_BINDING",
    "GL_EMISSION",
    "GL_ENABLE_BIT",
    "GL_EQUAL",
    "GL_EQUIV",
    "GL_EVAL_BIT",
    "GL_EXP",
    "GL_EXP2",
    "GL_EXTENSIONS",
    "GL_EYE_LINEAR",
    "GL_EYE_PLANE",
    "GL_FALSE",
    "GL_FASTEST",
    "GL_FEEDBACK",
    "GL_FEEDBACK_BUFFER_POINTER",
    "GL_FEEDBACK_BUFFER_SIZE",
    "GL_FEEDBACK_BUFFER_TYPE",
    "GL_FILL",
    "GL_FIXED",
    "GL_FLAT",
    "GL_FLIP_NORMAL_GLSIM",
    "GL_FLOAT",
    "GL_FOG",
    "GL_FOG_BIT",
    "GL_FOG_COLOR",
    "GL_FOG_COORD",
    "GL_FOG_COORDINATE",
    "GL_FOG_COORDINATE_ARRAY",
    "GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING",
    "GL_FOG_COORDINATE_ARRAY_POINTER",
    "GL_FOG_COORDINATE_ARRAY_STRIDE",
    "GL_FOG_COORDINATE_ARRAY_TYPE",
    "GL_FOG_COORDINATE_SOURCE",
    "GL_FOG_COORD_ARRAY",
    "GL_FOG_COORD_ARRAY_BUFFER_BINDING",
    "GL_FOG_COORD_ARRAY_POINTER",
    "GL_FOG_COORD_ARRAY_STRIDE",
    "GL_FOG_COORD_ARRAY_TYPE",
    "GL_FOG_COORD_SRC",
    "GL_FOG_DENSITY",
    "GL_FOG_END",
    "GL_FOG_HINT",
    "GL_FOG_INDEX",
    "GL_FOG_MODE",
    "GL_FOG_START",
    "GL_FRAGMENT_DEPTH",
    "GL_FRONT",
    "GL_FRONT_AND_BACK",
    "GL_FRONT_FACE",
    "GL_FRONT_LEFT",
    "GL_FRONT_RIGHT",
    "GL_FUNC_ADD",
    "GL_FUNC_REVERSE_SUBTRACT",
    "GL_FUNC_SUBTRACT",
    "GL_GENERATE_MIPMAP",
    "GL_GENERATE_MIPMAP_HINT",
    "GL_GEQUAL",
    "GL_GREATER",
    "GL_GREEN",
    "GL_GREEN_BIAS",
    "GL_GREEN_BITS",
    "GL_GREEN_SCALE",
    "GL_HALF_FLOAT",
    "GL_HALF_NV",
    "GL_HINT_BIT",
    "GL_INCR",
    "GL_INCR_WRAP",
    "GL_INDEX_ARRAY",
    "GL_INDEX_ARRAY_BUFFER_BINDING",
    "GL_INDEX_ARRAY_POINTER",
    "GL_INDEX_ARRAY_STRIDE",
    "GL_INDEX_ARRAY_TYPE",
    "GL_INDEX_BITS",
    "GL_INDEX_CLEAR_VALUE",
    "GL_INDEX_LOGIC_OP",
    "GL_INDEX_MODE",
    "GL_INDEX_OFFSET",
    "GL_INDEX_SHIFT",
    "GL_INDEX_WRITEMASK",
    "GL_INT",
    "GL_INTENSITY",
    "GL_INTENSITY12",
    "GL_INTENSITY16",
    "GL_INTENSITY4",
    "GL_INTENSITY8",
    "GL_INTERPOLATE",
    "GL_INVALID_ENUM",
    "GL_INVALID_OPERATION",
    "GL_INVALID_VALUE",
    "GL_INVERT",
    "GL_KEEP",
    "GL_LEFT",
    "GL_LEQUAL",
    "GL_LESS",
    "GL_LIGHT0",
    "GL_LIGHT1",
    "GL_LIGHT2",
    "GL_LIGHT3",
    "GL_LIGHT4",
    "GL_LIGHT5",
    "GL_LIGHT6",
    "GL_LIGHT7",
    "GL_LIGHTING",
    "GL_LIGHTING_BIT",
    "GL_LIGHT_MODEL_AMBIENT",
    "GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM",
    "GL_LIGHT_MODEL_COLOR_CONTROL",
    "GL_LIGHT_MODEL_LOCAL_VIEWER",
    "GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM",
    "GL_LIGHT_MODEL_TWO_SIDE",
    "GL_LINE",
    "GL_LINEAR",
    "GL_LINEAR_ATTENUATION",
    "GL_LINEAR_MIPMAP_LINEAR",
    "GL_LINEAR_MIPMAP_NEAREST",
    "GL_LINES",
    "GL_LINE_BIT",
    "GL_LINE_LOOP",
    "GL_LINE_RESET_TOKEN",
    "GL_LINE_SMOOTH",
    "GL_LINE_SMOOTH_HINT",
    "GL_LINE_STIPPLE",
    "GL_LINE_STIPPLE_PATTERN",
    "GL_LINE_STIPPLE_REPEAT",
    "GL_LINE_STRIP",
    "GL_LINE_TOKEN",
    "GL_LINE_WIDTH",
    "GL_LINE_WIDTH_GRANULARITY",
    "GL_LINE_WIDTH_RANGE",
    "GL_LIST_BASE",
    "GL_LIST_BIT",
    "GL_LIST_INDEX",
    "GL_LIST_MODE",
    "GL_LOAD",
    "GL_LOGIC_OP",
    "GL_LOGIC_OP_MODE",
    "GL_LUMINANCE",
    "GL_LUMINANCE12",
    "GL_LUMINANCE12_ALPHA12",
    "GL_LUMINANCE12_ALPHA4",
    "GL_LUMINANCE16",
    "GL_LUMINANCE16_ALPHA16",
    "GL_LUMINANCE4",
    "GL_LUMINANCE4_ALPHA4",
    "GL_LUMINANCE6_ALPHA2",
    "GL_LUMINANCE8",
    "GL_LUMINANCE8_ALPHA8",
    "GL_LUMINANCE_ALPHA",
    "GL_MAJOR_VERSION",
    "GL_MAP1_COLOR_4",
    "GL_MAP1_GRID_DOMAIN",
    "GL_MAP1_GRID_SEGMENTS",
    "GL_MAP1_INDEX",
    "GL_MAP1_NORMAL",
    "GL_MAP1_TEXTURE_COORD_1",
    "GL_MAP1_TEXTURE_COORD_2",
    "GL_MAP1_TEXTURE_COORD_3",
    "GL_MAP1_TEXTURE_COORD_4",
    "GL_MAP1_VERTEX_3",
    "GL_MAP1_VERTEX_4",
    "GL_MAP2_COLOR_4",
    "GL_MAP2_GRID_DOMAIN",
    "GL_MAP2_GRID_SEGMENTS",
    "GL_MAP2_INDEX",
    "GL_MAP2_NORMAL",
    "GL_MAP2_TEXTURE_COORD_1",
    "GL_MAP2_TEXTURE_COORD_2",
    "GL_MAP2_TEXTURE_COORD_3",
    "GL_MAP2_TEXTURE_COORD_4",
    "GL_MAP2_VERTEX_3",
    "GL_MAP2_VERTEX_4",
    "GL_MAP_COLOR",
    "GL_MAP_STENCIL",
    "GL_MATRIX_MODE",
    "GL_MAX",
    "GL_MAX_3D_TEXTURE_SIZE",
    "GL_MAX_ATTRIB_STACK_DEPTH",
    "GL_MAX_CLIENT_ATTRIB_STACK_DEPTH",
    "GL_MAX_CLIP_PLANES",
    "GL_MAX_CUBE_MAP_TEXTURE_SIZE",
    "GL_MAX_ELEMENTS_INDICES",
    "GL_MAX_ELEMENTS_VERTICES",
    "GL_MAX_EVAL_ORDER",
    "GL_MAX_LIGHTS",
    "GL_MAX_LIST_NESTING",
    "GL_MAX_MODELVIEW_STACK_DEPTH",
    "GL_MAX_NAME_STACK_DEPTH",
    "GL_MAX_PIXEL_MAP_TABLE",
    "GL_MAX_PROJECTION_STACK_DEPTH",
    "GL_MAX_TEXTURE_LOD_BIAS",
    "GL_MAX_TEXTURE_SIZE",
    "GL_MAX_TEXTURE_STACK_DEPTH",
    "GL_MAX_TEXTURE_UNITS",
    "GL_MAX_VIEWPORT_DIMS",
    "GL_MIN",
    "GL_MINOR_VERSION",
    "GL_MIRRORED_REPEAT",
    "GL_MODELVIEW",
    "GL_MODELVIEW_MATRIX",
    "GL_MODELVIEW_STACK_DEPTH",
    "GL_MODULATE",
    "GL_MULT",
    "GL_MULTISAMPLE",
    "GL_MULTISAMPLE_BIT",
    "GL_N3F_V3F",
    "GL_NAME_STACK_DEPTH",
    "GL_NAND",
    "GL_NEAREST",
    "GL_NEAREST_MIPMAP_LINEAR",
    "GL_NEAREST_MIPMAP_NEAREST",
    "GL_NEVER",
    "GL_NICEST",
    "GL_NONE",
    "GL_NOOP",
    "GL_NOR",
    "GL_NORMALIZE",
    "GL_NORMAL_ARRAY",
    "GL_NORMAL_ARRAY_BUFFER_BINDING",
    "GL_NORMAL_ARRAY_POINTER",
    "GL_NORMAL_ARRAY_STRIDE",
    "GL_NORMAL_ARRAY_TYPE",
    "GL_NORMAL_MAP",
    "GL_NOTEQUAL",
    "GL_NO_ERROR",
    "GL_NUM_COMPRESSED_TEXTURE_FORMATS",
    "GL_NUM_EXTENSIONS",
    "GL_OBJECT_LINEAR",
    "GL_OBJECT_PLANE",
    "GL_ONE",
    "GL_ONE_MINUS_CONSTANT_ALPHA",
    "GL_ONE_MINUS_CONSTANT_COLOR",
    "GL_ONE_MINUS_DST_ALPHA",
    "GL_ONE_MINUS_DST_COLOR",
    "GL_ONE_MINUS_SRC_ALPHA",
    "GL_ONE_MINUS_SRC_COLOR",
    "GL_OPERAND0_ALPHA",
    "GL_OPERAND0_RGB",
    "GL_OPERAND1_ALPHA",
    "GL_OPERAND1_RGB",
    "GL_OPERAND2_ALPHA",
    "GL_OPERAND2_RGB",
    "GL_OR",
    "GL_ORDER",
    "GL_OR_INVERTED",
    "GL_OR_REVERSE",
    "GL_OUT_OF_MEMORY",
    "GL_PACK_ALIGNMENT",
    "GL_PACK_IMAGE_HEIGHT",
    "GL_PACK_LSB_FIRST",
    "GL_PACK_ROW_LENGTH",
    "GL_PACK_SKIP_IMAGES",
    "GL_PACK_SKIP_PIXELS",
    "GL_PACK_SKIP_ROWS",
    "GL_PACK_SWAP_BYTES",
    "GL_PASS_THROUGH_TOKEN",
    "GL_PERSPECTIVE_CORRECTION_HINT",
    "GL_PHONG_HINT_WIN",
    "GL_PHONG_LOBE_GLSIM",
    "GL_PHONG_WIN",
    "GL_PIXEL_MAP_A_TO_A",
    "GL_PIXEL_MAP_A_TO_A_SIZE",
    "GL_PIXEL_MAP_B_TO_B",
    "GL_PIXEL_MAP_B_TO_B_SIZE",
    "GL_PIXEL_MAP_G_TO_G",
    "GL_PIXEL_MAP_G_TO_G_SIZE",
    "GL_PIXEL_MAP_I_TO_A",
    "GL_PIXEL_MAP_I_TO_A_SIZE",
    "GL_PIXEL_MAP_I_TO_B",
    "GL_PIXEL_MAP_I_TO_B_SIZE",
    "GL_PIXEL_MAP_I_TO_G",
    "GL_PIXEL_MAP_I_TO_G_SIZE",
    "GL_PIXEL_MAP_I_TO_I",
    "GL_PIXEL_MAP_I_TO_I_SIZE",
    "GL_PIXEL_MAP_I_TO_R",
    "GL_PIXEL_MAP_I_TO_R_SIZE",
    "GL_PIXEL_MAP_R_TO_R",
    "GL_PIXEL_MAP_R_TO_R_SIZE",
    "GL_PIXEL_MAP_S_TO_S",
    "GL_PIXEL_MAP_S_TO_S_SIZE",
    "GL_PIXEL_MODE_BIT",
    "GL_POINT",
    "GL_POINTS",
    "GL_POINT_BIT",
    "GL_POINT_DISTANCE_ATTENUATION",
    "GL_POINT_FADE_THRESHOLD_SIZE",
    "GL_POINT_SIZE",
    "GL_POINT_SIZE_GRANULARITY",
    "GL_POINT_SIZE_MAX",
    "GL_POINT_SIZE_MIN",
    "GL_POINT_SIZE_RANGE",
    "GL_POINT_SMOOTH",
    "GL_POINT_SMOOTH_HINT",
    "GL_POINT_TOKEN",
    "GL_POLYGON",
    "GL_POLYGON_BIT",
    "GL_POLYGON_MODE",
    "GL_POLYGON_OFFSET_FACTOR",
    "GL_POLYGON_OFFSET_FILL",
    "GL_POLYGON_OFFSET_LINE",
    "GL_POLYGON_OFFSET_POINT",
    "GL_POLYGON_OFFSET_UNITS",
    "GL_POLYGON_SMOOTH",
    "GL_POLYGON_SMOOTH_HINT",
    "GL_POLYGON_STIPPLE",
    "GL_POLYGON_STIPPLE_BIT",
    "GL_POLYGON_TOKEN",
    "GL_POSITION",
    "GL_PREVIOUS",
    "GL_PRIMARY_COLOR",
    "GL_PROJECTION",
    "GL_PROJECTION_MATRIX",
    "GL_PROJECTION_STACK_DEPTH",
    "GL_PROXY_TEXTURE_1D",
    "GL_PROXY_TEXTURE_2D",
    "GL_PROXY_TEXTURE_3D",
    "GL_PROXY_TEXTURE_CUBE_MAP",
    "GL_Q",
    "GL_QUADRATIC_ATTENUATION",
    "GL_QUADS",
    "GL_QUAD_STRIP",
    "GL_QUERY_COUNTER_BITS",
    "GL_QUERY_RESULT",
    "GL_QUERY_RESULT_AVAILABLE",
    "GL_R",
    "GL_R3_G3_B2",
    "GL_READ_BUFFER",
    "GL_READ_ONLY",
    "GL_READ_WRITE",
    "GL_RED",
    "GL_RED_BIAS",
    "GL_RED_BITS",
    "GL_RED_SCALE",
    "GL_REFLECTION_MAP",
    "GL_RENDER",
    "GL_RENDERER",
    "GL_RENDER_MODE",
    "GL_REPEAT",
    "GL_REPLACE",
    "GL_RESCALE_NORMAL",
    "GL_RETURN",
    "GL_RGB",
    "GL_RGB10",
    "GL_RGB10_A2",
    "GL_RGB12",
    "GL_RGB16",
    "GL_RGB4",
    "GL_RGB5",
    "GL_RGB5_A1",
    "GL_RGB8",
    "GL_RGBA",
    "GL_RGBA12",
    "GL_RGBA16",
    "GL_RGBA2",
    "GL_RGBA4",
    "GL_RGBA8",
    "GL_RGBA_MODE",
    "GL_RGB_SCALE",
    "GL_RIGHT",
    "GL_S",
    "GL_SAMPLES",
    "GL_SAMPLES_PASSED",
    "GL_SAMPLE_ALPHA_TO_COVERAGE",
    "GL_SAMPLE_ALPHA_TO_ONE",
    "GL_SAMPLE_BUFFERS",
    "GL_SAMPLE_COVERAGE",
    "GL_SAMPLE_COVERAGE_INVERT",
    "GL_SAMPLE_COVERAGE_VALUE",
    "GL_SCISSOR_BIT",
    "GL_SCISSOR_BOX",
    "GL_SCISSOR_TEST",
    "GL_SECONDARY_COLOR_ARRAY",
    "GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING",
    "GL_SECONDARY_COLOR_ARRAY_POINTER",
    "GL_SECONDARY_COLOR_ARRAY_SIZE",
    "GL_SECONDARY_COLOR_ARRAY_STRIDE",
    "GL_SECONDARY_COLOR_ARRAY_TYPE",
    "GL_SELECT",
    "GL_SELECTION_BUFFER_POINTER",
    "GL_SELECTION_BUFFER_SIZE",
    "GL_SEPARATE_SPECULAR_COLOR",
    "GL_SET",
    "GL_SHADE_MODEL",
    "GL_SHADING_LANGUAGE_VERSION",
    "GL_SHININESS",
    "GL_SHORT",
    "GL_SINGLE_COLOR",
    "GL_SMOOTH",
    "GL_SMOOTH_LINE_WIDTH_GRANULARITY",
    "GL_SMOOTH_LINE_WIDTH_RANGE",
    "GL_SMOOTH_POINT_SIZE_GRANULARITY",
    "GL_SMOOTH_POINT_SIZE_RANGE",
    "GL_SOURCE0_ALPHA",
    "GL_SOURCE0_RGB",
    "GL_SOURCE1_ALPHA",
    "GL_SOURCE1_RGB",
    "GL_SOURCE2_ALPHA",
    "GL_SOURCE2_RGB",
    "GL_SPECULAR",
    "GL_SPHERE_MAP",
    "GL_SPOT_CUTOFF",
    "GL_SPOT_DIRECTION",
    "GL_SPOT_EXPONENT",
    "GL_SRC0_ALPHA",
    "GL_SRC0_RGB",
    "GL_SRC1_ALPHA",
    "GL_SRC1_RGB",
    "GL_SRC2_ALPHA",
    "GL_SRC2_RGB",
    "GL_SRC_ALPHA",
    "GL_SRC_ALPHA_SATURATE",
    "GL_SRC_COLOR",
    "GL_STACK_OVERFLOW",
    "GL_STACK_UNDERFLOW",
    "GL_STATIC_COPY",
    "GL_STATIC_DRAW",
    "GL_STATIC_READ",
    "GL_STENCIL",
    "GL_STENCIL_BITS",
    "GL_STENCIL_BUFFER_BIT",
    "GL_STENCIL_CLEAR_VALUE",
    "GL_STENCIL_FAIL",
    "GL_STENCIL_FUNC",
    "GL_STENCIL_INDEX",
    "GL_STENCIL_PASS_DEPTH_FAIL",
    "GL_STENCIL_PASS_DEPTH_PASS",
    "GL_STENCIL_REF",
    "GL_STENCIL_TEST",
    "GL_STENCIL_VALUE_MASK",
    "GL_STENCIL_WRITEMASK",
    "GL_STEREO",
    "GL_STREAM_COPY",
    "GL_STREAM_DRAW",
    "GL_STREAM_READ",
    "GL_SUBPIXEL_BITS",
    "GL_SUBTRACT",
    "GL_T",
    "GL_T2F_C3F_V3F",
    "GL_T2F_C4F_N3F_V3F",
    "GL_T2F_C4UB_V3F",
    "GL_T2F_N3F_V3F",
    "GL_T2F_V3F",
    "GL_T4F_C4F_N3F_V4F",
    "GL_T4F_V4F",
    "GL_TEXTURE",
    "GL_TEXTURE0",
    "GL_TEXTURE1",
    "GL_TEXTURE10",
    "GL_TEXTURE11",
    "GL_TEXTURE12",
    "GL_TEXTURE13",
    "GL_TEXTURE14",
    "GL_TEXTURE15",
    "GL_TEXTURE16",
    "GL_TEXTURE17",
    "GL_TEXTURE18",
    "GL_TEXTURE19",
    "GL_TEXTURE2",
    "GL_TEXTURE20",
    "GL_TEXTURE21",
    "GL_TEXTURE22",
    "GL_TEXTURE23",
    "GL_TEXTURE24",
    "GL_TEXTURE25",
    "GL_TEXTURE26",
    "GL_TEXTURE27",
    "GL_TEXTURE28",
    "GL_TEXTURE29",
    "GL_TEXTURE3",
    "GL_TEXTURE30",
    "GL_TEXTURE31",
    "GL_TEXTURE4",
    "GL_TEXTURE5",
    "GL_TEXTURE6",
    "GL_TEXTURE7",
    "GL_TEXTURE8",
    "GL_TEXTURE9",
    "GL_TEXTURE_1D",
    "GL_TEXTURE_2D",
    "GL_TEXTURE_3D",
    "GL_TEXTURE_ALPHA_SIZE",
    "GL_TEXTURE_BASE_LEVEL",
    "GL_TEXTURE_BINDING_1D",
    "GL_TEXTURE_BINDING_2D",
    "GL_TEXTURE_BINDING_3D",
    "GL_TEXTURE_BINDING_CUBE_MAP",
    "GL_TEXTURE_BIT",
    "GL_TEXTURE_BLUE_SIZE",
    "GL_TEXTURE_BORDER",
    "GL_TEXTURE_BORDER_COLOR",
    "GL_TEXTURE_COMPARE_FUNC",
    "GL_TEXTURE_COMPARE_MODE",
    "GL_TEXTURE_COMPONENTS",
    "GL_TEXTURE_COMPRESSED",
    "GL_TEXTURE_COMPRESSED_IMAGE_SIZE",
    "GL_TEXTURE_COMPRESSION_HINT",
    "GL_TEXTURE_COORD_ARRAY",
    "GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING",
    "GL_TEXTURE_COORD_ARRAY_POINTER",
    "GL_TEXTURE_COORD_ARRAY_SIZE",
    "GL_TEXTURE_COORD_ARRAY_STRIDE",
    "GL_TEXTURE_COORD_ARRAY_TYPE",
    "GL_TEXTURE_CUBE_MAP",
    "GL_TEXTURE_CUBE_MAP_NEGATIVE_X",
    "GL_TEXTURE_CUBE_MAP_NEGATIVE_Y",
    "GL_TEXTURE_CUBE_MAP_NEGATIVE_Z",
    "GL_TEXTURE_CUBE_MAP_POSITIVE_X",
    "GL_TEXTURE_CUBE_MAP_POSITIVE_Y",
    "GL_TEXTURE_CUBE_MAP_POSITIVE_Z",
    "GL_TEXTURE_DEPTH",
    "GL_TEXTURE_DEPTH_SIZE",
    "GL_TEXTURE_ENV",
    "GL_TEXTURE_ENV_COLOR",
    "GL_TEXTURE_ENV_MODE",
    "GL_TEXTURE_FILTER_CONTROL",
    "GL_TEXTURE_GEN_MODE",
    "GL_TEXTURE_GEN_Q",
    "GL_TEXTURE_GEN_R",
    "GL_TEXTURE_GEN_S",
    "GL_TEXTURE_GEN_T",
    "GL_TEXTURE_GREEN_SIZE",
    "GL_TEXTURE_HEIGHT",
    "GL_TEXTURE_INTENSITY_SIZE",
    "GL_TEXTURE_INTERNAL_FORMAT",
    "GL_TEXTURE_LOD_BIAS",
    "GL_TEXTURE_LUMINANCE_SIZE",
    "GL_TEXTURE_MAG_FILTER",
    "GL_TEXTURE_MATRIX",
    "GL_TEXTURE_MAX_LEVEL",
    "GL_TEXTURE_MAX_LOD",
    "GL_TEXTURE_MIN_FILTER",
    "GL_TEXTURE_MIN_LOD",
    "GL_TEXTURE_PRIORITY",
    "GL_TEXTURE_RED_SIZE",
    "GL_TEXTURE_RESIDENT",
    "GL_TEXTURE_STACK_DEPTH",
    "GL_TEXTURE_WIDTH",
    "GL_TEXTURE_WRAP_R",
    "GL_TEXTURE_WRAP_S",
    "GL_TEXTURE_WRAP_T",
    "GL_TRANSFORM_BIT",
    "GL_TRANSPOSE_COLOR_MATRIX",
    "GL_TRANSPOSE_MODELVIEW_MATRIX",
    "GL_TRANSPOSE_PROJECTION_MATRIX",
    "GL_TRANSPOSE_TEXTURE_MATRIX",
    "GL_TRIANGLES",
    "GL_TRIANGLE_FAN",
    "GL_TRIANGLE_STRIP",
    "GL_TRUE",
    "GL_UNPACK_ALIGNMENT",
    "GL_UNPACK_IMAGE_HEIGHT",
    "GL_UNPACK_LSB_FIRST",
    "GL_UNPACK_ROW_LENGTH",
    "GL_UNPACK_SKIP_IMAGES",
    "GL_UNPACK_SKIP_PIXELS",
    "GL_UNPACK_SKIP_ROWS",
    "GL_UNPACK_SWAP_BYTES",
    "GL_UNSIGNED_BYTE",
    "GL_UNSIGNED_BYTE_2_3_3_REV",
    "GL_UNSIGNED_BYTE_3_3_2",
    "GL_UNSIGNED_INT",
    "GL_UNSIGNED_INT64",
    "GL_UNSIGNED_INT_10_10_10_2",
    "GL_UNSIGNED_INT_2_10_10_10_REV",
    "GL_UNSIGNED_INT_8_8_8_8",
    "GL_UNSIGNED_INT_8_8_8_8_REV",
    "GL_UNSIGNED_SHORT",
    "GL_UNSIGNED_SHORT_1_5_5_5_REV",
    "GL_UNSIGNED_SHORT_4_4_4_4",
    "GL_UNSIGNED_SHORT_4_4_4_4_REV",
    "GL_UNSIGNED_SHORT_5_5_5_1",
    "GL_UNSIGNED_SHORT_5_6_5",
    "GL_UNSIGNED_SHORT_5_6_5_REV",
    "GL_V2F",
    "GL_V3F",
    "GL_VENDOR",
    "GL_VERSION",
    "GL_VERTEX_ARRAY",
    "GL_VERTEX_ARRAY_BUFFER_BINDING",
    "GL_VERTEX_ARRAY_POINTER",
    "GL_VERTEX_ARRAY_SIZE",
    "GL_VERTEX_ARRAY_STRIDE",
    "GL_VERTEX_ARRAY_TYPE",
    "GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING",
    "GL_VIEWPORT",
    "GL_VIEWPORT_BIT",
    "GL_WEIGHT_ARRAY_BUFFER_BINDING",
    "GL_WRITE_ONLY",
    "GL_XOR",
    "GL_ZERO",
    "GL_ZOOM_X",
    "GL_ZOOM_Y",
    "GLbitfield",
    "GLboolean",
    "GLbyte",
    "GLclampd",
    "GLclampf",
    "GLdouble",
    "GLdouble_16",
    "GLdouble_3",
    "GLdouble_4",
    "GLenum",
    "GLfloat",
    "GLfloat_16",
    "GLfloat_3",
    "GLfloat_4",
    "GLint",
    "GLshort",
    "GLsizei",
    "GLubyte",
    "GLuint",
    "GLushort",
    "GLvoid",
    "error",
    "glAccum",
    "glActiveTexture",
    "glAlphaFunc",
    "glAreTexturesResident",
    "glArrayElement",
    "glBegin",
    "glBeginQuery",
    "glBindBuffer",
    "glBindTexture",
    "glBitmap",
    "glBlendColor",
    "glBlendEquation",
    "glBlendFunc",
    "glBlendFuncSeparate",
    "glBufferData",
    "glBufferSubData",
    "glCallList",
    "glCallLists",
    "glClear",
    "glClearAccum",
    "glClearColor",
    "glClearDepth",
    "glClearIndex",
    "glClearStencil",
    "glClientActiveTexture",
    "glClipPlane",
    "glColor",
    "glColor3b",
    "glColor3bv",
    "glColor3d",
    "glColor3dv",
    "glColor3f",
    "glColor3fv",
    "glColor3i",
    "glColor3iv",
    "glColor3s",
    "glColor3sv",
    "glColor3ub",
    "glColor3ubv",
    "glColor3ui",
    "glColor3uiv",
    "glColor3us",
    "glColor3usv",
    "glColor4b",
    "glColor4bv",
    "glColor4d",
    "glColor4dv",
    "glColor4f",
    "glColor4fv",
    "glColor4i",
    "glColor4iv",
    "glColor4s",
    "glColor4sv",
    "glColor4ub",
    "glColor4ubv",
    "glColor4ui",
    "glColor4uiv",
    "glColor4us",
    "glColor4usv",
    "glColorMask",
    "glColorMaterial",
    "glColorPointer",
    "glColorPointerb",
    "glColorPointerd",
    "glColorPointerf",
    "glColorPointeri",
    "glColorPointers",
    "glColorPointerub",
    "glColorPointerui",
    "glColorPointerus",
    "glCompressedTexImage1D",
    "glCompressedTexImage2D",
    "glCompressedTexImage3D",
    "glCompressedTexSubImage1D",
    "glCompressedTexSubImage2D",
    "glCompressedTexSubImage3D",
    "glCopyPixels",
    "glCopyTexImage1D",
    "glCopyTexImage2D",
    "glCopyTexSubImage1D",
    "glCopyTexSubImage2D",
    "glCopyTexSubImage3D",
    "glCullFace",
    "glDeleteBuffers",
    "glDeleteLists",
    "glDeleteQueries",
    "glDeleteTextures",
    "glDepthFunc",
    "glDepthMask",
    "glDepthRange",
    "glDisable",
    "glDisableClientState",
    "glDrawArrays",
    "glDrawBuffer",
    "glDrawElements",
    "glDrawElementsub",
    "glDrawElementsui",
    "glDrawElementsus",
    "glDrawPixels",
    "glDrawPixelsb",
    "glDrawPixelsd",
    "glDrawPixelsf",
    "glDrawPixelsi",
    "glDrawPixelss",
    "glDrawPixelsub",
    "glDrawPixelsui",
    "glDrawPixelsus",
    "glDrawRangeElements",
    "glEdgeFlag",
    "glEdgeFlagPointer",
    "glEdgeFlagPointerb",
    "glEdgeFlagv",
    "glEnable",
    "glEnableClientState",
    "glEnd",
    "glEndList",
    "glEndQuery",
    "glEvalCoord",
    "glEvalCoord1d",
    "glEvalCoord1dv",
    "glEvalCoord1f",
    "glEvalCoord1fv",
    "glEvalCoord2d",
    "glEvalCoord2dv",
    "glEvalCoord2f",
    "glEvalCoord2fv",
    "glEvalMesh1",
    "glEvalMesh2",
    "glEvalPoint1",
    "glEvalPoint2",
    "glFeedbackBuffer",
    "glFinish",
    "glFlush",
    "glFog",
    "glFogCoord",
    "glFogCoordPointer",
    "glFogCoordd",
    "glFogCoorddv",
    "glFogCoordf",
    "glFogCoordfv",
    "glFogf",
    "glFogfv",
    "glFogi",
    "glFogiv",
    "glFrontFace",
    "glFrustum",
    "glGenBuffers",
    "glGenLists",
    "glGenQueries",
    "glGenTextures",
    "glGetBoolean",
    "glGetBooleanv",
    "glGetBufferParameteriv",
    "glGetBufferPointerv",
    "glGetBufferSubData",
    "glGetClipPlane",
    "glGetCompressedTexImage",
    "glGetDouble",
    "glGetDoublev",
    "glGetError",
    "glGetFloat",
    "glGetFloatv",
    "glGetInteger",
    "glGetIntegerv",
    "glGetLightfv",
    "glGetLightiv",
    "glGetMapdv",
    "glGetMapfv",
    "glGetMapiv",
    "glGetMaterialfv",
    "glGetMaterialiv",
    "glGetPixelMapfv",
    "glGetPixelMapuiv",
    "glGetPixelMapusv",
    "glGetPointerv",
    "glGetPolygonStipple",
    "glGetPolygonStippleub",
    "glGetQueryObjectiv",
    "glGetQueryObjectuiv",
    "glGetQueryiv",
    "glGetString",
    "glGetStringi",
    "glGetTexEnvfv",
    "glGetTexEnviv",
    "glGetTexGendv",
    "glGetTexGenfv",
    "glGetTexGeniv",
    "glGetTexImage",
    "glGetTexImageb",
    "glGetTexImaged",
    "glGetTexImagef",
    "glGetTexImagei",
    "glGetTexImages",
    "glGetTexImageub",
    "glGetTexImageui",
    "glGetTexImageus",
    "glGetTexLevelParameterfv",
    "glGetTexLevelParameteriv",
    "glGetTexParameterfv",
    "glGetTexParameteriv",
    "glHint",
    "glIndex",
    "glIndexMask",
    "glIndexPointer",
    "glIndexPointerb",
    "glIndexPointerd",
    "glIndexPointerf",
    "glIndexPointeri",
    "glIndexPointers",
    "glIndexPointerub",
    "glIndexPointerui",
    "glIndexPointerus",
    "glIndexd",
    "glIndexdv",
    "glIndexf",
    "glIndexfv",
    "glIndexi",
    "glIndexiv",
    "glIndexs",
    "glIndexsv",
    "glIndexub",
    "glIndexubv",
    "glInitNames",
    "glInterleavedArrays",
    "glIsBuffer",
    "glIsEnabled",
    "glIsList",
    "glIsQuery",
    "glIsTexture",
    "glLight",
    "glLightModel",
    "glLightModelf",
    "glLightModelfv",
    "glLightModeli",
    "glLightModeliv",
    "glLightf",
    "glLightfv",
    "glLighti",
    "glLightiv",
    "glLineStipple",
    "glLineWidth",
    "glListBase",
    "glLoadIdentity",
    "glLoadMatrixd",
    "glLoadMatrixf",
    "glLoadName",
    "glLoadTransposeMatrixd",
    "glLoadTransposeMatrixf",
    "glLogicOp",
    "glMap1d",
    "glMap1f",
    "glMap2d",
    "glMap2f",
    "glMapBuffer",
    "glMapGrid1d",
    "glMapGrid1f",
    "glMapGrid2d",
    "glMapGrid2f",
    "glMaterial",
    "glMaterialf",
    "glMaterialfv",
    "glMateriali",
    "glMaterialiv",
    "glMatrixMode",
    "glMultMatrixd",
    "glMultMatrixf",
    "glMultTransposeMatrixd",
    "glMultTransposeMatrixf",
    "glMultiDrawArrays",
    "glMultiDrawElements",
    "glMultiTexCoord",
    "glMultiTexCoord1d",
    "glMultiTexCoord1dv",
    "glMultiTexCoord1f",
    "glMultiTexCoord1fv",
    "glMultiTexCoord1i",
    "glMultiTexCoord1iv",
    "glMultiTexCoord1s",
    "glMultiTexCoord1sv",
    "glMultiTexCoord2d",
    "glMultiTexCoord2dv",
    "glMultiTexCoord2f",
    "glMultiTexCoord2fv",
    "glMultiTexCoord2i",
    "glMultiTexCoord2iv",
    "glMultiTexCoord2s",
    "glMultiTexCoord2sv",
    "glMultiTexCoord3d",
    "glMultiTexCoord3dv",
    "glMultiTexCoord3f",
    "glMultiTexCoord3fv",
    "glMultiTexCoord3i",
    "glMultiTexCoord3iv",
    "glMultiTexCoord3s",
    "glMultiTexCoord3sv",
    "glMultiTexCoord4d",
    "glMultiTexCoord4dv",
    "glMultiTexCoord4f",
    "glMultiTexCoord4fv",
    "glMultiTexCoord4i",
    "glMultiTexCoord4iv",
    "glMultiTexCoord4s",
    "glMultiTexCoord4sv",
    "glNewList",
    "glNormal",
    "glNormal3b",
    "glNormal3bv",
    "glNormal3d",
    "glNormal3dv",
    "glNormal3f",
    "glNormal3fv",
    "glNormal3i",
    "glNormal3iv",
    "glNormal3s",
    "glNormal3sv",
    "glNormalPointer",
    "glNormalPointerb",
    "glNormalPointerd",
    "glNormalPointerf",
    "glNormalPointeri",
    "glNormalPointers",
    "glNormalPointerub",
    "glNormalPointerui",
    "glNormalPointerus",
    "glOrtho",
    "glPassThrough",
    "glPixelMapfv",
    "glPixelMapuiv",
    "glPixelMapusv",
    "glPixelStore",
    "glPixelStoref",
    "glPixelStorei",
    "glPixelTransfer",
    "glPixelTransferf",
    "glPixelTransferi",
    "glPixelZoom",
    "glPointParameter",
    "glPointParameterf",
    "glPointParameterfv",
    "glPointParameteri",
    "glPointParameteriv",
    "glPointSize",
    "glPolygonMode",
    "glPolygonOffset",
    "glPolygonStipple",
    "glPopAttrib",
    "glPopClientAttrib",
    "glPopMatrix",
    "glPopName",
    "glPrioritizeTextures",
    "glPushAttrib",
    "glPushClientAttrib",
    "glPushMatrix",
    "glPushName",
    "glRasterPos",
    "glRasterPos2d",
    "glRasterPos2dv",
    "glRasterPos2f",
    "glRasterPos2fv",
    "glRasterPos2i",
    "glRasterPos2iv",
    "glRasterPos2s",
    "glRasterPos2sv",
    "glRasterPos3d",
    "glRasterPos3dv",
    "glRasterPos3f",
    "glRasterPos3fv",
    "glRasterPos3i",
    "glRasterPos3iv",
    "glRasterPos3s",
    "glRasterPos3sv",
    "glRasterPos4d",
    "glRasterPos4dv",
    "glRasterPos4f",
    "glRasterPos4fv",
    "glRasterPos4i",
    "glRasterPos4iv",
    "glRasterPos4s",
    "glRasterPos4sv",
    "glReadBuffer",
    "glReadPixels",
    "glReadPixelsb",
    "glReadPixelsd",
    "glReadPixelsf",
    "glReadPixelsi",
    "glReadPixelss",
    "glReadPixelsub",
    "glReadPixelsui",
    "glReadPixelsus",
    "glRect",
    "glRectd",
    "glRectdv",
    "glRectf",
    "glRectfv",
    "glRecti",
    "glRectiv",
    "glRects",
    "glRectsv",
    "glRenderMode",
    "glRotate",
    "glRotated",
    "glRotatef",
    "glSampleCoverage",
    "glScale",
    "glScaled",
    "glScalef",
    "glScissor",
    "glSecondaryColor",
    "glSecondaryColor3b",
    "glSecondaryColor3bv",
    "glSecondaryColor3d",
    "glSecondaryColor3dv",
    "glSecondaryColor3f",
    "glSecondaryColor3fv",
    "glSecondaryColor3i",
    "glSecondaryColor3iv",
    "glSecondaryColor3s",
    "glSecondaryColor3sv",
    "glSecondaryColor3ub",
    "glSecondaryColor3ubv",
    "glSecondaryColor3ui",
    "glSecondaryColor3uiv",
    "glSecondaryColor3us",
    "glSecondaryColor3usv",
    "glSecondaryColorPointer",
    "glSecondaryColorPointerb",
    "glSecondaryColorPointerd",
    "glSecondaryColorPointerf",
    "glSecondaryColorPointeri",
    "glSecondaryColorPointers",
    "glSecondaryColorPointerub",
    "glSecondaryColorPointerui",
    "glSecondaryColorPointerus",
    "glSelectBuffer",
    "glShadeModel",
    "glStencilFunc",
    "glStencilMask",
    "glStencilOp",
    "glTexCoord",
    "glTexCoord1d",
    "glTexCoord1dv",
    "glTexCoord1f",
    "glTexCoord1fv",
    "glTexCoord1i",
    "glTexCoord1iv",
    "glTexCoord1s",
    "glTexCoord1sv",
    "glTexCoord2d",
    "glTexCoord2dv",
    "glTexCoord2f",
    "glTexCoord2fv",
    "glTexCoord2i",
    "glTexCoord2iv",
    "glTexCoord2s",
    "glTexCoord2sv",
    "glTexCoord3d",
    "glTexCoord3dv",
    "glTexCoord3f",
    "glTexCoord3fv",
    "glTexCoord3i",
    "glTexCoord3iv",
    "glTexCoord3s",
    "glTexCoord3sv",
    "glTexCoord4d",
    "glTexCoord4dv",
    "glTexCoord4f",
    "glTexCoord4fv",
    "glTexCoord4i",
    "glTexCoord4iv",
    "glTexCoord4s",
    "glTexCoord4sv",
    "glTexCoordPointer",
    "glTexCoordPointerb",
    "glTexCoordPointerd",
    "glTexCoordPointerf",
    "glTexCoordPointeri",
    "glTexCoordPointers",
    "glTexCoordPointerub",
    "glTexCoordPointerui",
    "glTexCoordPointerus",
    "glTexEnv",
    "glTexEnvf",
    "glTexEnvfv",
    "glTexEnvi",
    "glTexEnviv",
    "glTexGen",
    "glTexGend",
    "glTexGendv",
    "glTexGenf",
    "glTexGenfv",
    "glTexGeni",
    "glTexGeniv",
    "glTexImage1D",
    "glTexImage1Db",
    "glTexImage1Dd",
    "glTexImage1Df",
    "glTexImage1Di",
    "glTexImage1Ds",
    "glTexImage1Dub",
    "glTexImage1Dui",
    "glTexImage1Dus",
    "glTexImage2D",
    "glTexImage2Db",
    "glTexImage2Dd",
    "glTexImage2Df",
    "glTexImage2Di",
    "glTexImage2Ds",
    "glTexImage2Dub",
    "glTexImage2Dui",
    "glTexImage2Dus",
    "glTexImage3D",
    "glTexImage3Db",
    "glTexImage3Dd",
    "glTexImage3Df",
    "glTexImage3Di",
    "glTexImage3Ds",
    "glTexImage3Dub",
    "glTexImage3Dui",
    "glTexImage3Dus",
    "glTexParameter",
    "glTexParameterf",
    "glTexParameterfv",
    "glTexParameteri",
    "glTexParameteriv",
    "glTexSubImage1D",
    "glTexSubImage1Db",
    "glTexSubImage1Dd",
    "glTexSubImage1Df",
    "glTexSubImage1Di",
    "glTexSubImage1Ds",
    "glTexSubImage1Dub",
    "glTexSubImage1Dui",
    "glTexSubImage1Dus",
    "glTexSubImage2D",
    "glTexSubImage2Db",
    "glTexSubImage2Dd",
    "glTexSubImage2Df",
    "glTexSubImage2Di",
    "glTexSubImage2Ds",
    "glTexSubImage2Dub",
    "glTexSubImage2Dui",
    "glTexSubImage2Dus",
    "glTexSubImage3D",
    "glTexSubImage3Db",
    "glTexSubImage3Dd",
    "glTexSubImage3Df",
    "glTexSubImage3Di",
    "glTexSubImage3Ds",
    "glTexSubImage3Dub",
    "glTexSubImage3Dui",
    "glTexSubImage3Dus",
    "glTranslate",
    "glTranslated",
    "glTranslatef",
    "glUnmapBuffer",
    "glVertex",
    "glVertex2d",
    "glVertex2dv",
    "glVertex2f",
    "glVertex2fv",
    "glVertex2i",
    "glVertex2iv",
    "glVertex2s",
    "glVertex2sv",
    "glVertex3d",
    "glVertex3dv",
    "glVertex3f",
    "glVertex3fv",
    "glVertex3i",
    "glVertex3iv",
    "glVertex3s",
    "glVertex3sv",
    "glVertex4d",
    "glVertex4dv",
    "glVertex4f",
    "glVertex4fv",
    "glVertex4i",
    "glVertex4iv",
    "glVertex4s",
    "glVertex4sv",
    "glVertexPointer",
    "glVertexPointerb",
    "glVertexPointerd",
    "glVertexPointerf",
    "glVertexPointeri",
    "glVertexPointers",
    "glVertexPointerub",
    "glVertexPointerui",
    "glVertexPointerus",
    "glViewport",
    "glWindowPos",
    "glWindowPos2d",
    "glWindowPos2dv",
    "glWindowPos2f",
    "glWindowPos2fv",
    "glWindowPos2i",
    "glWindowPos2iv",
    "glWindowPos2s",
    "glWindowPos2sv",
    "glWindowPos3d",
    "glWindowPos3dv",
    "glWindowPos3f",
    "glWindowPos3fv",
    "glWindowPos3i",
    "glWindowPos3iv",
    "glWindowPos3s",
    "glWindowPos3sv",
]

GL_2D: Enum
GL_2_BYTES: Enum
GL_3D: Enum
GL_3D_COLOR: Enum
GL_3D_COLOR_TEXTURE: Enum
GL_3_BYTES: Enum
GL_4D_COLOR_TEXTURE: Enum
GL_4_BYTES: Enum
GL_ACCUM: Enum
GL_ACCUM_ALPHA_BITS: Enum
GL_ACCUM_BLUE_BITS: Enum
GL_ACCUM_BUFFER_BIT: Enum
GL_ACCUM_CLEAR_VALUE: Enum
GL_ACCUM_GREEN_BITS: Enum
GL_ACCUM_RED_BITS: Enum
GL_ACTIVE_TEXTURE: Enum
GL_ADD: Enum
GL_ADD_SIGNED: Enum
GL_AFFINE_GLSIM: Enum
GL_ALIASED_LINE_WIDTH_RANGE: Enum
GL_ALIASED_POINT_SIZE_RANGE: Enum
GL_ALL_ATTRIB_BITS: Enum
GL_ALL_CLIENT_ATTRIB_BITS: Enum
GL_ALPHA: Enum
GL_ALPHA12: Enum
GL_ALPHA16: Enum
GL_ALPHA4: Enum
GL_ALPHA8: Enum
GL_ALPHA_BIAS: Enum
GL_ALPHA_BITS: Enum
GL_ALPHA_SCALE: Enum
GL_ALPHA_TEST: Enum
GL_ALPHA_TEST_FUNC: Enum
GL_ALPHA_TEST_REF: Enum
GL_ALWAYS: Enum
GL_AMBIENT: Enum
GL_AMBIENT_AND_DIFFUSE: Enum
GL_AND: Enum
GL_AND_INVERTED: Enum
GL_AND_REVERSE: Enum
GL_ARRAY_BUFFER: Enum
GL_ARRAY_BUFFER_BINDING: Enum
GL_ATTRIB_STACK_DEPTH: Enum
GL_AUTO_NORMAL: Enum
GL_AUX0: Enum
GL_AUX1: Enum
GL_AUX2: Enum
GL_AUX3: Enum
GL_AUX_BUFFERS: Enum
GL_BACK: Enum
GL_BACK_LEFT: Enum
GL_BACK_RIGHT: Enum
GL_BGR: Enum
GL_BGRA: Enum
GL_BITMAP: Enum
GL_BITMAP_TOKEN: Enum
GL_BLEND: Enum
GL_BLEND_COLOR: Enum
GL_BLEND_DST: Enum
GL_BLEND_DST_ALPHA: Enum
GL_BLEND_DST_RGB: Enum
GL_BLEND_EQUATION: Enum
GL_BLEND_SRC: Enum
GL_BLEND_SRC_ALPHA: Enum
GL_BLEND_SRC_RGB: Enum
GL_BLINN_TORRANCE_GLSIM: Enum
GL_BLUE: Enum
GL_BLUE_BIAS: Enum
GL_BLUE_BITS: Enum
GL_BLUE_SCALE: Enum
GL_BUFFER_ACCESS: Enum
GL_BUFFER_MAPPED: Enum
GL_BUFFER_MAP_POINTER: Enum
GL_BUFFER_SIZE: Enum
GL_BUFFER_USAGE: Enum
GL_BYTE: Enum
GL_C3F_V3F: Enum
GL_C4F_N3F_V3F: Enum
GL_C4UB_V2F: Enum
GL_C4UB_V3F: Enum
GL_CCW: Enum
GL_CLAMP: Enum
GL_CLAMP_NORMAL_GLSIM: Enum
GL_CLAMP_TO_BORDER: Enum
GL_CLAMP_TO_EDGE: Enum
GL_CLEAR: Enum
GL_CLIENT_ACTIVE_TEXTURE: Enum
GL_CLIENT_ALL_ATTRIB_BITS: Enum
GL_CLIENT_ATTRIB_STACK_DEPTH: Enum
GL_CLIENT_PIXEL_STORE_BIT: Enum
GL_CLIENT_VERTEX_ARRAY_BIT: Enum
GL_CLIP_PLANE0: Enum
GL_CLIP_PLANE1: Enum
GL_CLIP_PLANE2: Enum
GL_CLIP_PLANE3: Enum
GL_CLIP_PLANE4: Enum
GL_CLIP_PLANE5: Enum
GL_COEFF: Enum
GL_COLOR: Enum
GL_COLOR_ARRAY: Enum
GL_COLOR_ARRAY_BUFFER_BINDING: Enum
GL_COLOR_ARRAY_POINTER: Enum
GL_COLOR_ARRAY_SIZE: Enum
GL_COLOR_ARRAY_STRIDE: Enum
GL_COLOR_ARRAY_TYPE: Enum
GL_COLOR_BUFFER_BIT: Enum
GL_COLOR_CLEAR_VALUE: Enum
GL_COLOR_INDEX: Enum
GL_COLOR_INDEXES: Enum
GL_COLOR_LOGIC_OP: Enum
GL_COLOR_MATERIAL: Enum
GL_COLOR_MATERIAL_FACE: Enum
GL_COLOR_MATERIAL_PARAMETER: Enum
GL_COLOR_SUM: Enum
GL_COLOR_WRITEMASK: Enum
GL_COMBINE: Enum
GL_COMBINE_ALPHA: Enum
GL_COMBINE_RGB: Enum
GL_COMPARE_R_TO_TEXTURE: Enum
GL_COMPILE: Enum
GL_COMPILE_AND_EXECUTE: Enum
GL_COMPRESSED_ALPHA: Enum
GL_COMPRESSED_INTENSITY: Enum
GL_COMPRESSED_LUMINANCE: Enum
GL_COMPRESSED_LUMINANCE_ALPHA: Enum
GL_COMPRESSED_RGB: Enum
GL_COMPRESSED_RGBA: Enum
GL_COMPRESSED_TEXTURE_FORMATS: Enum
GL_CONSTANT: Enum
GL_CONSTANT_ALPHA: Enum
GL_CONSTANT_ATTENUATION: Enum
GL_CONSTANT_COLOR: Enum
GL_COPY: Enum
GL_COPY_INVERTED: Enum
GL_COPY_PIXEL_TOKEN: Enum
GL_CULL_FACE: Enum
GL_CULL_FACE_MODE: Enum
GL_CURRENT_BIT: Enum
GL_CURRENT_COLOR: Enum
GL_CURRENT_FOG_COORD: Enum
GL_CURRENT_FOG_COORDINATE: Enum
GL_CURRENT_INDEX: Enum
GL_CURRENT_NORMAL: Enum
GL_CURRENT_QUERY: Enum
GL_CURRENT_RASTER_COLOR: Enum
GL_CURRENT_RASTER_DISTANCE: Enum
GL_CURRENT_RASTER_INDEX: Enum
GL_CURRENT_RASTER_POSITION: Enum
GL_CURRENT_RASTER_POSITION_VALID: Enum
GL_CURRENT_RASTER_TEXTURE_COORDS: Enum
GL_CURRENT_SECONDARY_COLOR: Enum
GL_CURRENT_TEXTURE_COORDS: Enum
GL_CW: Enum
GL_DECAL: Enum
GL_DECR: Enum
GL_DECR_WRAP: Enum
GL_DEPTH: Enum
GL_DEPTH_BIAS: Enum
GL_DEPTH_BITS: Enum
GL_DEPTH_BUFFER_BIT: Enum
GL_DEPTH_CLEAR_VALUE: Enum
GL_DEPTH_COMPONENT: Enum
GL_DEPTH_COMPONENT16: Enum
GL_DEPTH_COMPONENT24: Enum
GL_DEPTH_COMPONENT32: Enum
GL_DEPTH_FUNC: Enum
GL_DEPTH_RANGE: Enum
GL_DEPTH_SCALE: Enum
GL_DEPTH_TEST: Enum
GL_DEPTH_TEXTURE_MODE: Enum
GL_DEPTH_WRITEMASK: Enum
GL_DIFFUSE: Enum
GL_DITHER: Enum
GL_DOMAIN: Enum
GL_DONT_CARE: Enum
GL_DOT3_RGB: Enum
GL_DOT3_RGBA: Enum
GL_DOUBLE: Enum
GL_DOUBLEBUFFER: Enum
GL_DRAW_BUFFER: Enum
GL_DRAW_PIXEL_TOKEN: Enum
GL_DST_ALPHA: Enum
GL_DST_COLOR: Enum
GL_DYNAMIC_COPY: Enum
GL_DYNAMIC_DRAW: Enum
GL_DYNAMIC_READ: Enum
GL_EDGE_FLAG: Enum
GL_EDGE_FLAG_ARRAY: Enum
GL_EDGE_FLAG_ARRAY_BUFFER_BINDING: Enum
GL_EDGE_FLAG_ARRAY_POINTER: Enum
GL_EDGE_FLAG_ARRAY_STRIDE: Enum
GL_ELEMENT_ARRAY_BUFFER: Enum
GL_ELEMENT_ARRAY_BUFFER_BINDING: Enum
GL_EMISSION: Enum
GL_ENABLE_BIT: Enum
GL_EQUAL: Enum
GL_EQUIV: Enum
GL_EVAL_BIT: Enum
GL_EXP: Enum
GL_EXP2: Enum
GL_EXTENSIONS: Enum
GL_EYE_LINEAR: Enum
GL_EYE_PLANE: Enum
GL_FALSE: Enum
GL_FASTEST: Enum
GL_FEEDBACK: Enum
GL_FEEDBACK_BUFFER_POINTER: Enum
GL_FEEDBACK_BUFFER_SIZE: Enum
GL_FEEDBACK_BUFFER_TYPE: Enum
GL_FILL: Enum
GL_FIXED: Enum
GL_FLAT: Enum
GL_FLIP_NORMAL_GLSIM: Enum
GL_FLOAT: Enum
GL_FOG: Enum
GL_FOG_BIT: Enum
GL_FOG_COLOR: Enum
GL_FOG_COORD: Enum
GL_FOG_COORDINATE: Enum
GL_FOG_COORDINATE_ARRAY: Enum
GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING: Enum
GL_FOG_COORDINATE_ARRAY_POINTER: Enum
GL_FOG_COORDINATE_ARRAY_STRIDE: Enum
GL_FOG_COORDINATE_ARRAY_TYPE: Enum
GL_FOG_COORDINATE_SOURCE: Enum
GL_FOG_COORD_ARRAY: Enum
GL_FOG_COORD_ARRAY_BUFFER_BINDING: Enum
GL_FOG_COORD_ARRAY_POINTER: Enum
GL_FOG_COORD_ARRAY_STRIDE: Enum
GL_FOG_COORD_ARRAY_TYPE: Enum
GL_FOG_COORD_SRC: Enum
GL_FOG_DENSITY: Enum
GL_FOG_END: Enum
GL_FOG_HINT: Enum
GL_FOG_INDEX: Enum
GL_FOG_MODE: Enum
GL_FOG_START: Enum
GL_FRAGMENT_DEPTH: Enum
GL_FRONT: Enum
GL_FRONT_AND_BACK: Enum
GL_FRONT_FACE: Enum
GL_FRONT_LEFT: Enum
GL_FRONT_RIGHT: Enum
GL_FUNC_ADD: Enum
GL_FUNC_REVERSE_SUBTRACT: Enum
GL_FUNC_SUBTRACT: Enum
GL_GENERATE_MIPMAP: Enum
GL_GENERATE_MIPMAP_HINT: Enum
GL_GEQUAL: Enum
GL_GREATER: Enum
GL_GREEN: Enum
GL_GREEN_BIAS: Enum
GL_GREEN_BITS: Enum
GL_GREEN_SCALE: Enum
GL_HALF_FLOAT: Enum
GL_HALF_NV: Enum
GL_HINT_BIT: Enum
GL_INCR: Enum
GL_INCR_WRAP: Enum
GL_INDEX_ARRAY: Enum
GL_INDEX_ARRAY_BUFFER_BINDING: Enum
GL_INDEX_ARRAY_POINTER: Enum
GL_INDEX_ARRAY_STRIDE: Enum
GL_INDEX_ARRAY_TYPE: Enum
GL_INDEX_BITS: Enum
GL_INDEX_CLEAR_VALUE: Enum
GL_INDEX_LOGIC_OP: Enum
GL_INDEX_MODE: Enum
GL_INDEX_OFFSET: Enum
GL_INDEX_SHIFT: Enum
GL_INDEX_WRITEMASK: Enum
GL_INT: Enum
GL_INTENSITY: Enum
GL_INTENSITY12: Enum
GL_INTENSITY16: Enum
GL_INTENSITY4: Enum
GL_INTENSITY8: Enum
GL_INTERPOLATE: Enum
GL_INVALID_ENUM: Enum
GL_INVALID_OPERATION: Enum
GL_INVALID_VALUE: Enum
GL_INVERT: Enum
GL_KEEP: Enum
GL_LEFT: Enum
GL_LEQUAL: Enum
GL_LESS: Enum
GL_LIGHT0: Enum
GL_LIGHT1: Enum
GL_LIGHT2: Enum
GL_LIGHT3: Enum
GL_LIGHT4: Enum
GL_LIGHT5: Enum
GL_LIGHT6: Enum
GL_LIGHT7: Enum
GL_LIGHTING: Enum
GL_LIGHTING_BIT: Enum
GL_LIGHT_MODEL_AMBIENT: Enum
GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM: Enum
GL_LIGHT_MODEL_COLOR_CONTROL: Enum
GL_LIGHT_MODEL_LOCAL_VIEWER: Enum
GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM: Enum
GL_LIGHT_MODEL_TWO_SIDE: Enum
GL_LINE: Enum
GL_LINEAR: Enum
GL_LINEAR_ATTENUATION: Enum
GL_LINEAR_MIPMAP_LINEAR: Enum
GL_LINEAR_MIPMAP_NEAREST: Enum
GL_LINES: Enum
GL_LINE_BIT: Enum
GL_LINE_LOOP: Enum
GL_LINE_RESET_TOKEN: Enum
GL_LINE_SMOOTH: Enum
GL_LINE_SMOOTH_HINT: Enum
GL_LINE_STIPPLE: Enum
GL_LINE_STIPPLE_PATTERN: Enum
GL_LINE_STIPPLE_REPEAT: Enum
GL_LINE_STRIP: Enum
GL_LINE_TOKEN: Enum
GL_LINE_WIDTH: Enum
GL_LINE_WIDTH_GRANULARITY: Enum
GL_LINE_WIDTH_RANGE: Enum
GL_LIST_BASE: Enum
GL_LIST_BIT: Enum
GL_LIST_INDEX: Enum
GL_LIST_MODE: Enum
GL_LOAD: Enum
GL_LOGIC_OP: Enum
GL_LOGIC_OP_MODE: Enum
GL_LUMINANCE: Enum
GL_LUMINANCE12: Enum
GL_LUMINANCE12_ALPHA12: Enum
GL_LUMINANCE12_ALPHA4: Enum
GL_LUMINANCE16: Enum
GL_LUMINANCE16_ALPHA16: Enum
GL_LUMINANCE4: Enum
GL_LUMINANCE4_ALPHA4: Enum
GL_LUMINANCE6_ALPHA2: Enum
GL_LUMINANCE8: Enum
GL_LUMINANCE8_ALPHA8: Enum
GL_LUMINANCE_ALPHA: Enum
GL_MAJOR_VERSION: Enum
GL_MAP1_COLOR_4: Enum
GL_MAP1_GRID_DOMAIN: Enum
GL_MAP1_GRID_SEGMENTS: Enum
GL_MAP1_INDEX: Enum
GL_MAP1_NORMAL: Enum
GL_MAP1_TEXTURE_COORD_1: Enum
GL_MAP1_TEXTURE_COORD_2: Enum
GL_MAP1_TEXTURE_COORD_3: Enum
GL_MAP1_TEXTURE_COORD_4: Enum
GL_MAP1_VERTEX_3: Enum
GL_MAP1_VERTEX_4: Enum
GL_MAP2_COLOR_4: Enum
GL_MAP2_GRID_DOMAIN: Enum
GL_MAP2_GRID_SEGMENTS: Enum
GL_MAP2_INDEX: Enum
GL_MAP2_NORMAL: Enum
GL_MAP2_TEXTURE_COORD_1: Enum
GL_MAP2_TEXTURE_COORD_2: Enum
GL_MAP2_TEXTURE_COORD_3: Enum
GL_MAP2_TEXTURE_COORD_4: Enum
GL_MAP2_VERTEX_3: Enum
GL_MAP2_VERTEX_4: Enum
GL_MAP_COLOR: Enum
GL_MAP_STENCIL: Enum
GL_MATRIX_MODE: Enum
GL_MAX: Enum
GL_MAX_3D_TEXTURE_SIZE: Enum
GL_MAX_ATTRIB_STACK_DEPTH: Enum
GL_MAX_CLIENT_ATTRIB_STACK_DEPTH: Enum
GL_MAX_CLIP_PLANES: Enum
GL_MAX_CUBE_MAP_TEXTURE_SIZE: Enum
GL_MAX_ELEMENTS_INDICES: Enum
GL_MAX_ELEMENTS_VERTICES: Enum
GL_MAX_EVAL_ORDER: Enum
GL_MAX_LIGHTS: Enum
GL_MAX_LIST_NESTING: Enum
GL_MAX_MODELVIEW_STACK_DEPTH: Enum
GL_MAX_NAME_STACK_DEPTH: Enum
GL_MAX_PIXEL_MAP_TABLE: Enum
GL_MAX_PROJECTION_STACK_DEPTH: Enum
GL_MAX_TEXTURE_LOD_BIAS: Enum
GL_MAX_TEXTURE_SIZE: Enum
GL_MAX_TEXTURE_STACK_DEPTH: Enum
GL_MAX_TEXTURE_UNITS: Enum
GL_MAX_VIEWPORT_DIMS: Enum
GL_MIN: Enum
GL_MINOR_VERSION: Enum
GL_MIRRORED_REPEAT: Enum
GL_MODELVIEW: Enum
GL_MODELVIEW_MATRIX: Enum
GL_MODELVIEW_STACK_DEPTH: Enum
GL_MODULATE: Enum
GL_MULT: Enum
GL_MULTISAMPLE: Enum
GL_MULTISAMPLE_BIT: Enum
GL_N3F_V3F: Enum
GL_NAME_STACK_DEPTH: Enum
GL_NAND: Enum
GL_NEAREST: Enum
GL_NEAREST_MIPMAP_LINEAR: Enum
GL_NEAREST_MIPMAP_NEAREST: Enum
GL_NEVER: Enum
GL_NICEST: Enum
GL_NONE: Enum
GL_NOOP: Enum
GL_NOR: Enum
GL_NORMALIZE: Enum
GL_NORMAL_ARRAY: Enum
GL_NORMAL_ARRAY_BUFFER_BINDING: Enum
GL_NORMAL_ARRAY_POINTER: Enum
GL_NORMAL_ARRAY_STRIDE: Enum
GL_NORMAL_ARRAY_TYPE: Enum
GL_NORMAL_MAP: Enum
GL_NOTEQUAL: Enum
GL_NO_ERROR: Enum
GL_NUM_COMPRESSED_TEXTURE_FORMATS: Enum
GL_NUM_EXTENSIONS: Enum
GL_OBJECT_LINEAR: Enum
GL_OBJECT_PLANE: Enum
GL_ONE: Enum
GL_ONE_MINUS_CONSTANT_ALPHA: Enum
GL_ONE_MINUS_CONSTANT_COLOR: Enum
GL_ONE_MINUS_DST_ALPHA: Enum
GL_ONE_MINUS_DST_COLOR: Enum
GL_ONE_MINUS_SRC_ALPHA: Enum
GL_ONE_MINUS_SRC_COLOR: Enum
GL_OPERAND0_ALPHA: Enum
GL_OPERAND0_RGB: Enum
GL_OPERAND1_ALPHA: Enum
GL_OPERAND1_RGB: Enum
GL_OPERAND2_ALPHA: Enum
GL_OPERAND2_RGB: Enum
GL_OR: Enum
GL_ORDER: Enum
GL_OR_INVERTED: Enum
GL_OR_REVERSE: Enum
GL_OUT_OF_MEMORY: Enum
GL_PACK_ALIGNMENT: Enum
GL_PACK_IMAGE_HEIGHT: Enum
GL_PACK_LSB_FIRST: Enum
GL_PACK_ROW_LENGTH: Enum
GL_PACK_SKIP_IMAGES: Enum
GL_PACK_SKIP_PIXELS: Enum
GL_PACK_SKIP_ROWS: Enum
GL_PACK_SWAP_BYTES: Enum
GL_PASS_THROUGH_TOKEN: Enum
GL_PERSPECTIVE_CORRECTION_HINT: Enum
GL_PHONG_HINT_WIN: Enum
GL_PHONG_LOBE_GLSIM: Enum
GL_PHONG_WIN: Enum
GL_PIXEL_MAP_A_TO_A: Enum
GL_PIXEL_MAP_A_TO_A_SIZE: Enum
GL_PIXEL_MAP_B_TO_B: Enum
GL_PIXEL_MAP_B_TO_B_SIZE: Enum
GL_PIXEL_MAP_G_TO_G: Enum
GL_PIXEL_MAP_G_TO_G_SIZE: Enum
GL_PIXEL_MAP_I_TO_A: Enum
GL_PIXEL_MAP_I_TO_A_SIZE: Enum
GL_PIXEL_MAP_I_TO_B: Enum
GL_PIXEL_MAP_I_TO_B_SIZE: Enum
GL_PIXEL_MAP_I_TO_G: Enum
GL_PIXEL_MAP_I_TO_G_SIZE: Enum
GL_PIXEL_MAP_I_TO_I: Enum
GL_PIXEL_MAP_I_TO_I_SIZE: Enum
GL_PIXEL_MAP_I_TO_R: Enum
GL_PIXEL_MAP_I_TO_R_SIZE: Enum
GL_PIXEL_MAP_R_TO_R: Enum
GL_PIXEL_MAP_R_TO_R_SIZE: Enum
GL_PIXEL_MAP_S_TO_S: Enum
GL_PIXEL_MAP_S_TO_S_SIZE: Enum
GL_PIXEL_MODE_BIT: Enum
GL_POINT: Enum
GL_POINTS: Enum
GL_POINT_BIT: Enum
GL_POINT_DISTANCE_ATTENUATION: Enum
GL_POINT_FADE_THRESHOLD_SIZE: Enum
GL_POINT_SIZE: Enum
GL_POINT_SIZE_GRANULARITY: Enum
GL_POINT_SIZE_MAX: Enum
GL_POINT_SIZE_MIN: Enum
GL_POINT_SIZE_RANGE: Enum
GL_POINT_SMOOTH: Enum
GL_POINT_SMOOTH_HINT: Enum
GL_POINT_TOKEN: Enum
GL_POLYGON: Enum
GL_POLYGON_BIT: Enum
GL_POLYGON_MODE: Enum
GL_POLYGON_OFFSET_FACTOR: Enum
GL_POLYGON_OFFSET_FILL: Enum
GL_POLYGON_OFFSET_LINE: Enum
GL_POLYGON_OFFSET_POINT: Enum
GL_POLYGON_OFFSET_UNITS: Enum
GL_POLYGON_SMOOTH: Enum
GL_POLYGON_SMOOTH_HINT: Enum
GL_POLYGON_STIPPLE: Enum
GL_POLYGON_STIPPLE_BIT: Enum
GL_POLYGON_TOKEN: Enum
GL_POSITION: Enum
GL_PREVIOUS: Enum
GL_PRIMARY_COLOR: Enum
GL_PROJECTION: Enum
GL_PROJECTION_MATRIX: Enum
GL_PROJECTION_STACK_DEPTH: Enum
GL_PROXY_TEXTURE_1D: Enum
GL_PROXY_TEXTURE_2D: Enum
GL_PROXY_TEXTURE_3D: Enum
GL_PROXY_TEXTURE_CUBE_MAP: Enum
GL_Q: Enum
GL_QUADRATIC_ATTENUATION: Enum
GL_QUADS: Enum
GL_QUAD_STRIP: Enum
GL_QUERY_COUNTER_BITS: Enum
GL_QUERY_RESULT: Enum
GL_QUERY_RESULT_AVAILABLE: Enum
GL_R: Enum
GL_R3_G3_B2: Enum
GL_READ_BUFFER: Enum
GL_READ_ONLY: Enum
GL_READ_WRITE: Enum
GL_RED: Enum
GL_RED_BIAS: Enum
GL_RED_BITS: Enum
GL_RED_SCALE: Enum
GL_REFLECTION_MAP: Enum
GL_RENDER: Enum
GL_RENDERER: Enum
GL_RENDER_MODE: Enum
GL_REPEAT: Enum
GL_REPLACE: Enum
GL_RESCALE_NORMAL: Enum
GL_RETURN: Enum
GL_RGB: Enum
GL_RGB10: Enum
GL_RGB10_A2: Enum
GL_RGB12: Enum
GL_RGB16: Enum
GL_RGB4: Enum
GL_RGB5: Enum
GL_RGB5_A1: Enum
GL_RGB8: Enum
GL_RGBA: Enum
GL_RGBA12: Enum
GL_RGBA16: Enum
GL_RGBA2: Enum
GL_RGBA4: Enum
GL_RGBA8: Enum
GL_RGBA_MODE: Enum
GL_RGB_SCALE: Enum
GL_RIGHT: Enum
GL_S: Enum
GL_SAMPLES: Enum
GL_SAMPLES_PASSED: Enum
GL_SAMPLE_ALPHA_TO_COVERAGE: Enum
GL_SAMPLE_ALPHA_TO_ONE: Enum
GL_SAMPLE_BUFFERS: Enum
GL_SAMPLE_COVERAGE: Enum
GL_SAMPLE_COVERAGE_INVERT: Enum
GL_SAMPLE_COVERAGE_VALUE: Enum
GL_SCISSOR_BIT: Enum
GL_SCISSOR_BOX: Enum
GL_SCISSOR_TEST: Enum
GL_SECONDARY_COLOR_ARRAY: Enum
GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING: Enum
GL_SECONDARY_COLOR_ARRAY_POINTER: Enum
GL_SECONDARY_COLOR_ARRAY_SIZE: Enum
GL_SECONDARY_COLOR_ARRAY_STRIDE: Enum
GL_SECONDARY_COLOR_ARRAY_TYPE: Enum
GL_SELECT: Enum
GL_SELECTION_BUFFER_POINTER: Enum
GL_SELECTION_BUFFER_SIZE: Enum
GL_SEPARATE_SPECULAR_COLOR: Enum
GL_SET: Enum
GL_SHADE_MODEL: Enum
GL_SHADING_LANGUAGE_VERSION: Enum
GL_SHININESS: Enum
GL_SHORT: Enum
GL_SINGLE_COLOR: Enum
GL_SMOOTH: Enum
GL_SMOOTH_LINE_WIDTH_GRANULARITY: Enum
GL_SMOOTH_LINE_WIDTH_RANGE: Enum
GL_SMOOTH_POINT_SIZE_GRANULARITY: Enum
GL_SMOOTH_POINT_SIZE_RANGE: Enum
GL_SOURCE0_ALPHA: Enum
GL_SOURCE0_RGB: Enum
GL_SOURCE1_ALPHA: Enum
GL_SOURCE1_RGB: Enum
GL_SOURCE2_ALPHA: Enum
GL_SOURCE2_RGB: Enum
GL_SPECULAR: Enum
GL_SPHERE_MAP: Enum
GL_SPOT_CUTOFF: Enum
GL_SPOT_DIRECTION: Enum
GL_SPOT_EXPONENT: Enum
GL_SRC0_ALPHA: Enum
GL_SRC0_RGB: Enum
GL_SRC1_ALPHA: Enum
GL_SRC1_RGB: Enum
GL_SRC2_ALPHA: Enum
GL_SRC2_RGB: Enum
GL_SRC_ALPHA: Enum
GL_SRC_ALPHA_SATURATE: Enum
GL_SRC_COLOR: Enum
GL_STACK_OVERFLOW: Enum
GL_STACK_UNDERFLOW: Enum
GL_STATIC_COPY: Enum
GL_STATIC_DRAW: Enum
GL_STATIC_READ: Enum
GL_STENCIL: Enum
GL_STENCIL_BITS: Enum
GL_STENCIL_BUFFER_BIT: Enum
GL_STENCIL_CLEAR_VALUE: Enum
GL_STENCIL_FAIL: Enum
GL_STENCIL_FUNC: Enum
GL_STENCIL_INDEX: Enum
GL_STENCIL_PASS_DEPTH_FAIL: Enum
GL_STENCIL_PASS_DEPTH_PASS: Enum
GL_STENCIL_REF: Enum
GL_STENCIL_TEST: Enum
GL_STENCIL_VALUE_MASK: Enum
GL_STENCIL_WRITEMASK: Enum
GL_STEREO: Enum
GL_STREAM_COPY: Enum
GL_STREAM_DRAW: Enum
GL_STREAM_READ: Enum
GL_SUBPIXEL_BITS: Enum
GL_SUBTRACT: Enum
GL_T: Enum
GL_T2F_C3F_V3F: Enum
GL_T2F_C4F_N3F_V3F: Enum
GL_T2F_C4UB_V3F: Enum
GL_T2F_N3F_V3F: Enum
GL_T2F_V3F: Enum
GL_T4F_C4F_N3F_V4F: Enum
GL_T4F_V4F: Enum
GL_TEXTURE: Enum
GL_TEXTURE0: Enum
GL_TEXTURE1: Enum
GL_TEXTURE10: Enum
GL_TEXTURE11: Enum
GL_TEXTURE12: Enum
GL_TEXTURE13: Enum
GL_TEXTURE14: Enum
GL_TEXTURE15: Enum
GL_TEXTURE16: Enum
GL_TEXTURE17: Enum
GL_TEXTURE18: Enum
GL_TEXTURE19: Enum
GL_TEXTURE2: Enum
GL_TEXTURE20: Enum
GL_TEXTURE21: Enum
GL_TEXTURE22: Enum
GL_TEXTURE23: Enum
GL_TEXTURE24: Enum
GL_TEXTURE25: Enum
GL_TEXTURE26: Enum
GL_TEXTURE27: Enum
GL_TEXTURE28: Enum
GL_TEXTURE29: Enum
GL_TEXTURE3: Enum
GL_TEXTURE30: Enum
GL_TEXTURE31: Enum
GL_TEXTURE4: Enum
GL_TEXTURE5: Enum
GL_TEXTURE6: Enum
GL_TEXTURE7: Enum
GL_TEXTURE8: Enum
GL_TEXTURE9: Enum
GL_TEXTURE_1D: Enum
GL_TEXTURE_2D: Enum
GL_TEXTURE_3D: Enum
GL_TEXTURE_ALPHA_SIZE: Enum
GL_TEXTURE_BASE_LEVEL: Enum
GL_TEXTURE_BINDING_1D: Enum
GL_TEXTURE_BINDING_2D: Enum
GL_TEXTURE_BINDING_3D: Enum
GL_TEXTURE_BINDING_CUBE_MAP: Enum
GL_TEXTURE_BIT: Enum
GL_TEXTURE_BLUE_SIZE: Enum
GL_TEXTURE_BORDER: Enum
GL_TEXTURE_BORDER_COLOR: Enum
GL_TEXTURE_COMPARE_FUNC: Enum
GL_TEXTURE_COMPARE_MODE: Enum
GL_TEXTURE_COMPONENTS: Enum
GL_TEXTURE_COMPRESSED: Enum
GL_TEXTURE_COMPRESSED_IMAGE_SIZE: Enum
GL_TEXTURE_COMPRESSION_HINT: Enum
GL_TEXTURE_COORD_ARRAY: Enum
GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING: Enum
GL_TEXTURE_COORD_ARRAY_POINTER: Enum
GL_TEXTURE_COORD_ARRAY_SIZE: Enum
GL_TEXTURE_COORD_ARRAY_STRIDE: Enum
GL_TEXTURE_COORD_ARRAY_TYPE: Enum
GL_TEXTURE_CUBE_MAP: Enum
GL_TEXTURE_CUBE_MAP_NEGATIVE_X: Enum
GL_TEXTURE_CUBE_MAP_NEGATIVE_Y: Enum
GL_TEXTURE_CUBE_MAP_NEGATIVE_Z: Enum
GL_TEXTURE_CUBE_MAP_POSITIVE_X: Enum
GL_TEXTURE_CUBE_MAP_POSITIVE_Y: Enum
GL_TEXTURE_CUBE_MAP_POSITIVE_Z: Enum
GL_TEXTURE_DEPTH: Enum
GL_TEXTURE_DEPTH_SIZE: Enum
GL_TEXTURE_ENV: Enum
GL_TEXTURE_ENV_COLOR: Enum
GL_TEXTURE_ENV_MODE: Enum
GL_TEXTURE_FILTER_CONTROL: Enum
GL_TEXTURE_GEN_MODE: Enum
GL_TEXTURE_GEN_Q: Enum
GL_TEXTURE_GEN_R: Enum
GL_TEXTURE_GEN_S: Enum
GL_TEXTURE_GEN_T: Enum
GL_TEXTURE_GREEN_SIZE: Enum
GL_TEXTURE_HEIGHT: Enum
GL_TEXTURE_INTENSITY_SIZE: Enum
GL_TEXTURE_INTERNAL_FORMAT: Enum
GL_TEXTURE_LOD_BIAS: Enum
GL_TEXTURE_LUMINANCE_SIZE: Enum
GL_TEXTURE_MAG_FILTER: Enum
GL_TEXTURE_MATRIX: Enum
GL_TEXTURE_MAX_LEVEL: Enum
GL_TEXTURE_MAX_LOD: Enum
GL_TEXTURE_MIN_FILTER: Enum
GL_TEXTURE_MIN_LOD: Enum
GL_TEXTURE_PRIORITY: Enum
GL_TEXTURE_RED_SIZE: Enum
GL_TEXTURE_RESIDENT: Enum
GL_TEXTURE_STACK_DEPTH: Enum
GL_TEXTURE_WIDTH: Enum
GL_TEXTURE_WRAP_R: Enum
GL_TEXTURE_WRAP_S: Enum
GL_TEXTURE_WRAP_T: Enum
GL_TRANSFORM_BIT: Enum
GL_TRANSPOSE_COLOR_MATRIX: Enum
GL_TRANSPOSE_MODELVIEW_MATRIX: Enum
GL_TRANSPOSE_PROJECTION_MATRIX: Enum
GL_TRANSPOSE_TEXTURE_MATRIX: Enum
GL_TRIANGLES: Enum
GL_TRIANGLE_FAN: Enum
GL_TRIANGLE_STRIP: Enum
GL_TRUE: Enum
GL_UNPACK_ALIGNMENT: Enum
GL_UNPACK_IMAGE_HEIGHT: Enum
GL_UNPACK_LSB_FIRST: Enum
GL_UNPACK_ROW_LENGTH: Enum
GL_UNPACK_SKIP_IMAGES: Enum
GL_UNPACK_SKIP_PIXELS: Enum
GL_UNPACK_SKIP_ROWS: Enum
GL_UNPACK_SWAP_BYTES: Enum
GL_UNSIGNED_BYTE: Enum
GL_UNSIGNED_BYTE_2_3_3_REV: Enum
GL_UNSIGNED_BYTE_3_3_2: Enum
GL_UNSIGNED_INT: Enum
GL_UNSIGNED_INT64: Enum
GL_UNSIGNED_INT_10_10_10_2: Enum
GL_UNSIGNED_INT_2_10_10_10_REV: Enum
GL_UNSIGNED_INT_8_8_8_8: Enum
GL_UNSIGNED_INT_8_8_8_8_REV: Enum
GL_UNSIGNED_SHORT: Enum
GL_UNSIGNED_SHORT_1_5_5_5_REV: Enum
GL_UNSIGNED_SHORT_4_4_4_4: Enum
GL_UNSIGNED_SHORT_4_4_4_4_REV: Enum
GL_UNSIGNED_SHORT_5_5_5_1: Enum
GL_UNSIGNED_SHORT_5_6_5: Enum
GL_UNSIGNED_SHORT_5_6_5_REV: Enum
GL_V2F: Enum
GL_V3F: Enum
GL_VENDOR: Enum
GL_VERSION: Enum
GL_VERTEX_ARRAY: Enum
GL_VERTEX_ARRAY_BUFFER_BINDING: Enum
GL_VERTEX_ARRAY_POINTER: Enum
GL_VERTEX_ARRAY_SIZE: Enum
GL_VERTEX_ARRAY_STRIDE: Enum
GL_VERTEX_ARRAY_TYPE: Enum
GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING: Enum
GL_VIEWPORT: Enum
GL_VIEWPORT_BIT: Enum
GL_WEIGHT_ARRAY_BUFFER_BINDING: Enum
GL_WRITE_ONLY: Enum
GL_XOR: Enum
GL_ZERO: Enum
GL_ZOOM_X: Enum
GL_ZOOM_Y: Enum
GLbitfield = ctypes.c_uint
GLboolean = ctypes.c_ubyte
GLbyte = ctypes.c_byte
GLclampd = ctypes.c_double
GLclampf = ctypes.c_float
GLdouble = ctypes.c_double
GLdouble_16: type[ctypes.Array[ctypes.c_double]]
GLdouble_3: type[ctypes.Array[ctypes.c_double]]
GLdouble_4: type[ctypes.Array[ctypes.c_double]]
GLenum = ctypes.c_uint
GLfloat = ctypes.c_float
GLfloat_16: type[ctypes.Array[ctypes.c_float]]
GLfloat_3: type[ctypes.Array[ctypes.c_float]]
GLfloat_4: type[ctypes.Array[ctypes.c_float]]
GLint = ctypes.c_int
GLshort = ctypes.c_short
GLsizei = ctypes.c_int
GLubyte = ctypes.c_ubyte
GLuint = ctypes.c_uint
GLushort = ctypes.c_ushort
GLvoid: None
import glsim.machine.errors as error

def glAccum(op: int, value: float) -> None:
    """Computes with the accumulation buffer, which sums pictures for blur and soft edges.

    op: GL_ACCUM (add value times the picture), GL_LOAD (the same, replacing), GL_ADD (add value), GL_MULT (multiply by value) or
        GL_RETURN (value times the sum becomes the picture)
    value: a factor, or what is added"""

def glActiveTexture(texture: int) -> None:
    """Chooses the texture unit that glTexEnv, glTexGen, glBindTexture, glEnable(GL_TEXTURE_2D) and the texture matrix mean.

    texture: GL_TEXTURE0 (the initial value) to GL_TEXTURE3"""

def glAlphaFunc(func: int, ref: float) -> None:
    """Says which fragments pass the alpha test, once glEnable(GL_ALPHA_TEST) is called.

    func: GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL or GL_ALWAYS (the initial value)
    ref: what alpha is compared with, 0 to 1"""

def glAreTexturesResident(n: Any, textures: Any = ..., residences: Any = ...) -> Any:
    """Returns whether textures lie in fast memory: all do, one True for each; as in PyOpenGL also without n.

    n: how many names
    textures: a name or a sequence of names
    residences: an array to fill, instead of a new one"""

def glArrayElement(i: int) -> None:
    """Adds one vertex of the enabled arrays, as glVertex and its companions would, between glBegin and glEnd.

    i: number of the vertex, from 0
    Also between glBegin and glEnd."""

def glBegin(mode: int) -> None:
    """Begins a primitive: every glVertex until glEnd is one of its corners.  Only glVertex, glColor, glNormal, glTexCoord,
    glMaterial, glEdgeFlag, glEvalCoord, glArrayElement and glCallList may stand between the two.

    mode: GL_POINTS; GL_LINES (pairs), GL_LINE_STRIP, GL_LINE_LOOP; GL_TRIANGLES (triples), GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN;
        GL_QUADS (fours), GL_QUAD_STRIP (pairs); GL_POLYGON (one, convex)"""

def glBeginQuery(target: int, id: int) -> None:
    """Begins to count the samples that pass the depth test, until glEndQuery.

    target: GL_SAMPLES_PASSED
    id: the number of a query"""

def glBindBuffer(target: int, buffer: int) -> None:
    """Makes a buffer current.  While one is, the pointers of vertex arrays (or the numbers of glDrawElements) are offsets into it.

    target: GL_ARRAY_BUFFER for vertices, GL_ELEMENT_ARRAY_BUFFER for the numbers of vertices
    buffer: from glGenBuffers; 0 for none"""

def glBindTexture(target: int, texture: int) -> None:
    """Makes a texture current: glTexImage2D fills it, and what is drawn uses it once glEnable(GL_TEXTURE_2D) is called.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or GL_TEXTURE_CUBE_MAP
    texture: from glGenTextures; 0 for the one that every context has"""

def glBitmap(width: int, height: int, xorig: Any, yorig: Any, xmove: Any, ymove: Any, bitmap: Any) -> None:
    """Draws the 1 bits of a picture in the raster colour, then moves the raster position: how letters are drawn.

    width: in pixels
    height: in pixels
    xorig: column of the bitmap that lies on the raster position
    yorig: row of the bitmap that lies on the raster position
    xmove: pixels by which the raster position moves right afterwards
    ymove: pixels by which the raster position moves up afterwards
    bitmap: rows of bits, the bottom row first, or None to move only"""

def glBlendColor(red: float, green: float, blue: float, alpha: float) -> None:
    """Sets the colour that GL_CONSTANT_COLOR and GL_CONSTANT_ALPHA mean.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    alpha: from 0 to 1"""

def glBlendEquation(mode: int) -> None:
    """Says how the two weighted colours of blending become one.

    mode: GL_FUNC_ADD (the initial value), GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN or GL_MAX"""

def glBlendFunc(sfactor: int, dfactor: int) -> None:
    """Sets the weights of blending, once glEnable(GL_BLEND) is called: new = sfactor * fragment + dfactor * what is there.
    GL_SRC_ALPHA and GL_ONE_MINUS_SRC_ALPHA make transparency.

    sfactor: GL_ZERO, GL_ONE (the initial value), GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR,
        GL_SRC_COLOR, GL_DST_ALPHA, GL_CONSTANT_COLOR, GL_SRC_ALPHA_SATURATE, ...
    dfactor: the same names without GL_SRC_ALPHA_SATURATE; initially GL_ZERO"""

def glBlendFuncSeparate(srcRGB: int, dstRGB: int, srcAlpha: int, dstAlpha: int) -> None:
    """Sets the weights of blending for colour and for alpha, each as in glBlendFunc.

    srcRGB: weight of the fragment's colour
    dstRGB: weight of the colour that is there
    srcAlpha: weight of the fragment's alpha
    dstAlpha: weight of the alpha that is there"""

def glBufferData(target: int, size: Any, data: Any = ..., usage: int = ...) -> None:
    """Fills the bound buffer with new contents; as in PyOpenGL also glBufferData(target, data, usage).

    target: GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER
    size: in bytes
    data: an array or bytes; None for a buffer without contents
    usage: GL_STATIC_DRAW, GL_DYNAMIC_DRAW, GL_STREAM_DRAW, ...: a hint without effect here"""

def glBufferSubData(target: int, offset: Any, size: Any, data: Any = ...) -> None:
    """Replaces a part of the bound buffer; as in PyOpenGL also glBufferSubData(target, offset, data).

    target: GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER
    offset: where the part begins, in bytes
    size: in bytes
    data: an array or bytes"""

def glCallList(n: int) -> None:
    """Does the commands of a display list; a list that does not exist does nothing.

    n: number of the list
    Also between glBegin and glEnd."""

def glCallLists(n: Any, type: int = ..., lists: Any = ...) -> None:
    """Does the commands of several display lists, each numbered glListBase + number; as in PyOpenGL also glCallLists(lists).

    n: how many
    type: of the numbers: GL_UNSIGNED_BYTE, GL_INT, GL_2_BYTES, ...
    lists: the numbers: a string, bytes, or an array
    Also between glBegin and glEnd."""

def glClear(mask: int) -> None:
    """Fills buffers with the values that glClearColor, glClearDepth, glClearStencil and glClearAccum set.

    mask: one or several, joined with |: GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT, GL_ACCUM_BUFFER_BIT"""

def glClearAccum(r: float, g: float, b: float, a: float) -> None:
    """Sets the colour that glClear fills the accumulation buffer with.

    r: red, -1 to 1
    g: green, -1 to 1
    b: blue, -1 to 1
    a: alpha, -1 to 1"""

def glClearColor(r: float, g: float, b: float, a: float) -> None:
    """Sets the colour that glClear fills with.

    r: red, 0 to 1
    g: green, 0 to 1
    b: blue, 0 to 1
    a: alpha, 0 to 1"""

def glClearDepth(d: float) -> None:
    """Sets the depth that glClear fills with.

    d: from 0 (near) to 1 (far, the initial value)"""

def glClearIndex(index: float) -> None:
    """Sets the colour index that glClear fills with.  Accepted without effect: every context is RGBA.

    index: a number"""

def glClearStencil(s: int) -> None:
    """Sets the number that glClear fills the stencil buffer with.

    s: from 0 (the initial value) to 255"""

def glClientActiveTexture(texture: int) -> None:
    """Chooses the texture unit that glTexCoordPointer and GL_TEXTURE_COORD_ARRAY mean.

    texture: GL_TEXTURE0 (the initial value) to GL_TEXTURE3"""

def glClipPlane(plane: int, equation: Numbers) -> None:
    """Cuts away what lies behind a plane, once glEnable(GL_CLIP_PLANE0) is called: a x + b y + c z + d >= 0 is kept.  The modelview
    matrix of this moment takes the plane to eye space.

    plane: GL_CLIP_PLANE0 to GL_CLIP_PLANE5
    equation: a, b, c, d: a sequence of four numbers"""

def glColor(*arguments: Any) -> Any:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Numbers, or a sequence of them, of any type; glColor3b and so on take one.
    Also between glBegin and glEnd."""

def glColor3b(red: int, green: int, blue: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: -128 to 127 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor3bv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -128 to 127 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor3d(red: float, green: float, blue: float) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    Also between glBegin and glEnd."""

def glColor3dv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glColor3f(red: float, green: float, blue: float) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    Also between glBegin and glEnd."""

def glColor3fv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glColor3i(red: int, green: int, blue: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor3iv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor3s(red: int, green: int, blue: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: -32768 to 32767 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor3sv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -32768 to 32767 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor3ub(red: int, green: int, blue: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: 0 to 255 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor3ubv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 255 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor3ui(red: int, green: int, blue: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: 0 to 4294967295 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor3uiv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 4294967295 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor3us(red: int, green: int, blue: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: 0 to 65535 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor3usv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 65535 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor4b(red: int, green: int, blue: int, alpha: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Whole numbers: -128 to 127 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor4bv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -128 to 127 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor4d(red: float, green: float, blue: float, alpha: float) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Also between glBegin and glEnd."""

def glColor4dv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glColor4f(red: float, green: float, blue: float, alpha: float) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Also between glBegin and glEnd."""

def glColor4fv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glColor4i(red: int, green: int, blue: int, alpha: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Whole numbers: -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor4iv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor4s(red: int, green: int, blue: int, alpha: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Whole numbers: -32768 to 32767 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor4sv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -32768 to 32767 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glColor4ub(red: int, green: int, blue: int, alpha: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Whole numbers: 0 to 255 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor4ubv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 255 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor4ui(red: int, green: int, blue: int, alpha: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Whole numbers: 0 to 4294967295 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor4uiv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 4294967295 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor4us(red: int, green: int, blue: int, alpha: int) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    red: from 0 (none) to 1 (full)
    green: from 0 to 1
    blue: from 0 to 1
    alpha: opacity for blending, from 0 (clear) to 1 (opaque); 1 where it is not given
    Whole numbers: 0 to 65535 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColor4usv(v: Numbers) -> None:
    """Sets the current colour, for the vertices that follow.  With GL_LIGHTING it has no effect, unless GL_COLOR_MATERIAL makes it
    a property of the material.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 65535 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glColorMask(r: int, g: int, b: int, a: int) -> None:
    """Says which components of a colour are written.

    r: red, True or False
    g: green
    b: blue
    a: alpha"""

def glColorMaterial(face: int, mode: int) -> None:
    """Says which property of the material follows glColor, once glEnable(GL_COLOR_MATERIAL) is called; call glColorMaterial before
    that.

    face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK
    mode: GL_AMBIENT_AND_DIFFUSE (the initial value), GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR or GL_EMISSION"""

def glColorPointer(size: int, type: int, stride: int, pointer: Numbers) -> None:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    size: numbers of a colour: 3 or 4
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glColorPointerb(array: Any) -> Any:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    glColorPointerb(array), an array of GL_BYTE numbers; size and stride follow from it."""

def glColorPointerd(array: Any) -> Any:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    glColorPointerd(array), an array of GL_DOUBLE numbers; size and stride follow from it."""

def glColorPointerf(array: Any) -> Any:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    glColorPointerf(array), an array of GL_FLOAT numbers; size and stride follow from it."""

def glColorPointeri(array: Any) -> Any:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    glColorPointeri(array), an array of GL_INT numbers; size and stride follow from it."""

def glColorPointers(array: Any) -> Any:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    glColorPointers(array), an array of GL_SHORT numbers; size and stride follow from it."""

def glColorPointerub(array: Any) -> Any:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    glColorPointerub(array), an array of GL_UNSIGNED_BYTE numbers; size and stride follow from it."""

def glColorPointerui(array: Any) -> Any:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    glColorPointerui(array), an array of GL_UNSIGNED_INT numbers; size and stride follow from it."""

def glColorPointerus(array: Any) -> Any:
    """Names the array of colours, used once glEnableClientState(GL_COLOR_ARRAY) is called.  Whole numbers run over the range of
    their type, so that 255 is full for GL_UNSIGNED_BYTE.

    glColorPointerus(array), an array of GL_UNSIGNED_SHORT numbers; size and stride follow from it."""

def glCompressedTexImage1D(target: int, level: int, internalformat: int, width: int, border: int, imageSize: int, data: Numbers) -> None:
    """Would give the bound texture a compressed picture.  Refused with GL_INVALID_ENUM: there are no compressed formats here.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    internalformat: what a texel keeps: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, ..., or the
        number of components from 1 to 4
    width: in pixels
    border: 0, or 1 for a border of one texel around the picture
    imageSize: size of the data in bytes
    data: the compressed picture"""

def glCompressedTexImage2D(target: int, level: int, internalformat: int, width: int, height: int, border: int, imageSize: int, data: Numbers) -> None:
    """Would give the bound texture a compressed picture.  Refused with GL_INVALID_ENUM: there are no compressed formats here.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    internalformat: what a texel keeps: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, ..., or the
        number of components from 1 to 4
    width: in pixels
    height: in pixels
    border: 0, or 1 for a border of one texel around the picture
    imageSize: size of the data in bytes
    data: the compressed picture"""

def glCompressedTexImage3D(target: int, level: int, internalformat: int, width: int, height: int, depth: int, border: int, imageSize: int, data: Numbers) -> None:
    """Would give the bound texture a compressed picture.  Refused with GL_INVALID_ENUM: there are no compressed formats here.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    internalformat: what a texel keeps: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, ..., or the
        number of components from 1 to 4
    width: in pixels
    height: in pixels
    depth: number of layers
    border: 0, or 1 for a border of one texel around the picture
    imageSize: size of the data in bytes
    data: the compressed picture"""

def glCompressedTexSubImage1D(target: int, level: int, xoffset: int, width: int, format: int, imageSize: int, data: Numbers) -> None:
    """Would replace a part of a compressed picture.  Refused with GL_INVALID_ENUM: there are no compressed formats here.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    width: in pixels
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    imageSize: size of the data in bytes
    data: the compressed picture"""

def glCompressedTexSubImage2D(target: int, level: int, xoffset: int, yoffset: int, width: int, height: int, format: int, imageSize: int, data: Numbers) -> None:
    """Would replace a part of a compressed picture.  Refused with GL_INVALID_ENUM: there are no compressed formats here.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    yoffset: row of the first texel to replace, from the bottom
    width: in pixels
    height: in pixels
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    imageSize: size of the data in bytes
    data: the compressed picture"""

def glCompressedTexSubImage3D(target: int, level: int, xoffset: int, yoffset: int, zoffset: int, width: int, height: int, depth: int, format: int, imageSize: int, data: Numbers) -> None:
    """Would replace a part of a compressed picture.  Refused with GL_INVALID_ENUM: there are no compressed formats here.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    yoffset: row of the first texel to replace, from the bottom
    zoffset: layer of the first texel to replace
    width: in pixels
    height: in pixels
    depth: number of layers
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    imageSize: size of the data in bytes
    data: the compressed picture"""

def glCopyPixels(x: int, y: int, width: int, height: int, type: int) -> None:
    """Draws a rectangle of the framebuffer again at the raster position.

    x: left edge in pixels
    y: lower edge in pixels, counted from the bottom
    width: in pixels
    height: in pixels
    type: what is copied: GL_COLOR, GL_DEPTH or GL_STENCIL"""

def glCopyTexImage1D(target: int, level: int, internalformat: int, x: int, y: int, width: int, border: int) -> None:
    """Gives the bound texture a picture from the framebuffer.

    target: GL_TEXTURE_1D; GL_TEXTURE_2D or a face of a cube map
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    internalformat: what a texel keeps: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, ..., or the
        number of components from 1 to 4
    x: left edge in the framebuffer, in pixels
    y: lower edge in the framebuffer, in pixels
    width: in pixels
    border: 0, or 1 for a border of one texel around the picture"""

def glCopyTexImage2D(target: int, level: int, internalformat: int, x: int, y: int, width: int, height: int, border: int) -> None:
    """Gives the bound texture a picture from the framebuffer.

    target: GL_TEXTURE_1D; GL_TEXTURE_2D or a face of a cube map
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    internalformat: what a texel keeps: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, ..., or the
        number of components from 1 to 4
    x: left edge in the framebuffer, in pixels
    y: lower edge in the framebuffer, in pixels
    width: in pixels
    height: in pixels
    border: 0, or 1 for a border of one texel around the picture"""

def glCopyTexSubImage1D(target: int, level: int, xoffset: int, x: int, y: int, width: int) -> None:
    """Replaces a part of the bound texture's picture by a part of the framebuffer.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D (or a face of a cube map) or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    x: left edge in the framebuffer, in pixels
    y: lower edge in the framebuffer, in pixels
    width: in pixels"""

def glCopyTexSubImage2D(target: int, level: int, xoffset: int, yoffset: int, x: int, y: int, width: int, height: int) -> None:
    """Replaces a part of the bound texture's picture by a part of the framebuffer.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D (or a face of a cube map) or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    yoffset: row of the first texel to replace, from the bottom
    x: left edge in the framebuffer, in pixels
    y: lower edge in the framebuffer, in pixels
    width: in pixels
    height: in pixels"""

def glCopyTexSubImage3D(target: int, level: int, xoffset: int, yoffset: int, zoffset: int, x: int, y: int, width: int, height: int) -> None:
    """Replaces a part of the bound texture's picture by a part of the framebuffer.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D (or a face of a cube map) or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    yoffset: row of the first texel to replace, from the bottom
    zoffset: layer of the first texel to replace
    x: left edge in the framebuffer, in pixels
    y: lower edge in the framebuffer, in pixels
    width: in pixels
    height: in pixels"""

def glCullFace(mode: int) -> None:
    """Says which faces are left out, once glEnable(GL_CULL_FACE) is called.

    mode: GL_BACK (the initial value), GL_FRONT or GL_FRONT_AND_BACK"""

def glDeleteBuffers(n: Any, buffers: Any = ...) -> None:
    """Frees buffers: glDeleteBuffers(n, names), or as in PyOpenGL glDeleteBuffers(names).

    n: how many names
    buffers: a name or a sequence of names"""

def glDeleteLists(list: int, range: int) -> None:
    """Frees display lists with successive numbers.

    list: number of the first
    range: how many"""

def glDeleteQueries(n: Any, ids: Any = ...) -> None:
    """Frees queries: glDeleteQueries(n, names), or glDeleteQueries(names).

    n: how many names
    ids: a name or a sequence of names"""

def glDeleteTextures(n: Any, textures: Any = ...) -> None:
    """Frees textures: glDeleteTextures(n, names), or as in PyOpenGL glDeleteTextures(names).

    n: how many names
    textures: a name or a sequence of names"""

def glDepthFunc(func: int) -> None:
    """Says which fragments pass the depth test, once glEnable(GL_DEPTH_TEST) is called.

    func: GL_LESS (the initial value: what is nearer), GL_LEQUAL, GL_EQUAL, GL_GREATER, GL_GEQUAL, GL_NOTEQUAL, GL_ALWAYS or GL_NEVER"""

def glDepthMask(flag: int) -> None:
    """Says whether the depth buffer is written.

    flag: True (the initial value) or False"""

def glDepthRange(zNear: float, zFar: float) -> None:
    """Says to which depths in the depth buffer the near and the far plane are mapped.

    zNear: depth of the near plane, 0 to 1; initially 0
    zFar: depth of the far plane, 0 to 1; initially 1"""

def glDisable(cap: int) -> None:
    """Switches something on (glEnable) or off (glDisable).

    cap: GL_LIGHTING, GL_LIGHT0 to GL_LIGHT7, GL_COLOR_MATERIAL, GL_NORMALIZE, GL_RESCALE_NORMAL; GL_DEPTH_TEST, GL_STENCIL_TEST,
        GL_ALPHA_TEST, GL_SCISSOR_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_DITHER; GL_CULL_FACE, GL_POLYGON_OFFSET_FILL,
        GL_POLYGON_STIPPLE, GL_LINE_STIPPLE, GL_LINE_SMOOTH, GL_POINT_SMOOTH; GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D,
        GL_TEXTURE_CUBE_MAP, GL_TEXTURE_GEN_S, _T, _R, _Q; GL_FOG, GL_COLOR_SUM, GL_CLIP_PLANE0 to GL_CLIP_PLANE5, GL_AUTO_NORMAL,
        GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3, ..., GL_MULTISAMPLE"""

def glDisableClientState(array: int) -> None:
    """Switches a vertex array on (glEnableClientState) or off (glDisableClientState).

    array: GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY,
        GL_EDGE_FLAG_ARRAY or GL_INDEX_ARRAY"""

def glDrawArrays(mode: int, first: int, count: int) -> None:
    """Draws a primitive from successive vertices of the enabled arrays.

    mode: as in glBegin
    first: number of the first vertex, from 0
    count: how many vertices"""

def glDrawBuffer(buf: int) -> None:
    """Says which colour buffer is drawn to.

    buf: GL_BACK, GL_FRONT, GL_LEFT, GL_FRONT_AND_BACK: one picture here; GL_NONE draws no colours"""

def glDrawElements(mode: int, count: int, type: int, indices: Numbers) -> None:
    """Draws a primitive from the vertices of the enabled arrays that a list of numbers names.

    mode: as in glBegin
    count: how many numbers
    type: of the numbers: GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
    indices: numbers of vertices, or, while a buffer is bound to GL_ELEMENT_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glDrawElementsub(mode: Any, indices: Any) -> Any:
    """Draws a primitive from the vertices of the enabled arrays that a list of numbers names.

    glDrawElementsub(mode, indices), an array of GL_UNSIGNED_BYTE numbers; count follows from it."""

def glDrawElementsui(mode: Any, indices: Any) -> Any:
    """Draws a primitive from the vertices of the enabled arrays that a list of numbers names.

    glDrawElementsui(mode, indices), an array of GL_UNSIGNED_INT numbers; count follows from it."""

def glDrawElementsus(mode: Any, indices: Any) -> Any:
    """Draws a primitive from the vertices of the enabled arrays that a list of numbers names.

    glDrawElementsus(mode, indices), an array of GL_UNSIGNED_SHORT numbers; count follows from it."""

def glDrawPixels(width: int, height: int, format: int, type: int, pixels: Numbers) -> None:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    width: in pixels
    height: in pixels
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    pixels: rows of pixels, the bottom row first: an array, bytes, or None; glPixelStorei says how they lie"""

def glDrawPixelsb(*arguments: Any) -> Any:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    glDrawPixelsb(format, pixels), an array of GL_BYTE numbers; the size is the array's, width first."""

def glDrawPixelsd(*arguments: Any) -> Any:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    glDrawPixelsd(format, pixels), an array of GL_DOUBLE numbers; the size is the array's, width first."""

def glDrawPixelsf(*arguments: Any) -> Any:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    glDrawPixelsf(format, pixels), an array of GL_FLOAT numbers; the size is the array's, width first."""

def glDrawPixelsi(*arguments: Any) -> Any:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    glDrawPixelsi(format, pixels), an array of GL_INT numbers; the size is the array's, width first."""

def glDrawPixelss(*arguments: Any) -> Any:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    glDrawPixelss(format, pixels), an array of GL_SHORT numbers; the size is the array's, width first."""

def glDrawPixelsub(*arguments: Any) -> Any:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    glDrawPixelsub(format, pixels), an array of GL_UNSIGNED_BYTE numbers; the size is the array's, width first."""

def glDrawPixelsui(*arguments: Any) -> Any:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    glDrawPixelsui(format, pixels), an array of GL_UNSIGNED_INT numbers; the size is the array's, width first."""

def glDrawPixelsus(*arguments: Any) -> Any:
    """Draws a rectangle of pixels from the program's memory, its lower left corner at the raster position.

    glDrawPixelsus(format, pixels), an array of GL_UNSIGNED_SHORT numbers; the size is the array's, width first."""

def glDrawRangeElements(mode: int, start: int, end: int, count: int, type: int, indices: Numbers) -> None:
    """Draws like glDrawElements, with the promise that all numbers lie in a range.

    mode: as in glBegin
    start: the smallest number
    end: the largest number
    count: how many numbers
    type: of the numbers: GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
    indices: numbers of vertices, or, while a buffer is bound to GL_ELEMENT_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glEdgeFlag(flag: int) -> None:
    """Says whether the edges that begin at the following vertices are outlines: glPolygonMode with GL_LINE or GL_POINT draws only
    those.

    flag: True (the initial value) or False; with v a sequence of one
    Also between glBegin and glEnd."""

def glEdgeFlagPointer(stride: int, pointer: Numbers) -> None:
    """Names the array of edge flags, one byte each, used once glEnableClientState(GL_EDGE_FLAG_ARRAY) is called.

    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glEdgeFlagPointerb(array: Any) -> Any:
    """Names the array of edge flags, one byte each, used once glEnableClientState(GL_EDGE_FLAG_ARRAY) is called.

    glEdgeFlagPointerb(array), an array of GL_BYTE numbers; size and stride follow from it."""

def glEdgeFlagv(flag: Numbers) -> None:
    """Says whether the edges that begin at the following vertices are outlines: glPolygonMode with GL_LINE or GL_POINT draws only
    those.

    flag: True (the initial value) or False; with v a sequence of one
    Also between glBegin and glEnd."""

def glEnable(cap: int) -> None:
    """Switches something on (glEnable) or off (glDisable).

    cap: GL_LIGHTING, GL_LIGHT0 to GL_LIGHT7, GL_COLOR_MATERIAL, GL_NORMALIZE, GL_RESCALE_NORMAL; GL_DEPTH_TEST, GL_STENCIL_TEST,
        GL_ALPHA_TEST, GL_SCISSOR_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_DITHER; GL_CULL_FACE, GL_POLYGON_OFFSET_FILL,
        GL_POLYGON_STIPPLE, GL_LINE_STIPPLE, GL_LINE_SMOOTH, GL_POINT_SMOOTH; GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D,
        GL_TEXTURE_CUBE_MAP, GL_TEXTURE_GEN_S, _T, _R, _Q; GL_FOG, GL_COLOR_SUM, GL_CLIP_PLANE0 to GL_CLIP_PLANE5, GL_AUTO_NORMAL,
        GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3, ..., GL_MULTISAMPLE"""

def glEnableClientState(array: int) -> None:
    """Switches a vertex array on (glEnableClientState) or off (glDisableClientState).

    array: GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY,
        GL_EDGE_FLAG_ARRAY or GL_INDEX_ARRAY"""

def glEnd() -> None:
    """Ends the primitive that glBegin began.  Corners that make no whole primitive are ignored."""

def glEndList() -> None:
    """Ends the display list that glNewList began."""

def glEndQuery(target: int) -> None:
    """Ends what glBeginQuery began; glGetQueryObjectuiv returns the count.

    target: GL_SAMPLES_PASSED"""

def glEvalCoord(*arguments: Any) -> Any:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    u: place along u
    Numbers, or a sequence of them, of any type; glEvalCoord1f and so on take one.
    Also between glBegin and glEnd."""

def glEvalCoord1d(u: float) -> None:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    u: place along u
    Also between glBegin and glEnd."""

def glEvalCoord1dv(v: Numbers) -> None:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    v: place along v; with the v suffix a sequence of u, or of u and v
    Also between glBegin and glEnd."""

def glEvalCoord1f(u: float) -> None:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    u: place along u
    Also between glBegin and glEnd."""

def glEvalCoord1fv(v: Numbers) -> None:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    v: place along v; with the v suffix a sequence of u, or of u and v
    Also between glBegin and glEnd."""

def glEvalCoord2d(u: float, v: float) -> None:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    u: place along u
    v: place along v; with the v suffix a sequence of u, or of u and v
    Also between glBegin and glEnd."""

def glEvalCoord2dv(v: Numbers) -> None:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    v: place along v; with the v suffix a sequence of u, or of u and v
    Also between glBegin and glEnd."""

def glEvalCoord2f(u: float, v: float) -> None:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    u: place along u
    v: place along v; with the v suffix a sequence of u, or of u and v
    Also between glBegin and glEnd."""

def glEvalCoord2fv(v: Numbers) -> None:
    """Evaluates the enabled curves or surfaces at one point and sends what they give: a vertex, a normal, a colour.

    v: place along v; with the v suffix a sequence of u, or of u and v
    Also between glBegin and glEnd."""

def glEvalMesh1(mode: int, p1: int, p2: int) -> None:
    """Draws the curve at steps of the grid.

    mode: GL_POINT or GL_LINE
    p1: the first step
    p2: the last step"""

def glEvalMesh2(mode: int, p1: int, p2: int, q1: int, q2: int) -> None:
    """Draws the surface at steps of the grid.

    mode: GL_POINT, GL_LINE or GL_FILL
    p1: the first step of u
    p2: the last step of u
    q1: the first step of v
    q2: the last step of v"""

def glEvalPoint1(p: int) -> None:
    """Evaluates the curve or the surface at one point of the grid.

    p: step of u
    Also between glBegin and glEnd."""

def glEvalPoint2(p: int, q: int) -> None:
    """Evaluates the curve or the surface at one point of the grid.

    p: step of u
    q: step of v
    Also between glBegin and glEnd."""

def glFeedbackBuffer(size: Any, type: int, buffer: Any = ...) -> Any:
    """Makes room for feedback; returns that array.  Call it before glRenderMode(GL_FEEDBACK).

    size: in numbers
    type: what each vertex tells: GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE or GL_4D_COLOR_TEXTURE
    buffer: an array to use, instead of a new one"""

def glFinish() -> None:
    """Returns when the picture so far is drawn."""

def glFlush() -> None:
    """Says that the picture so far should be drawn soon."""

def glFog(*arguments: Any) -> Any:
    """Sets a property of the fog that glEnable(GL_FOG) switches on.

    pname: GL_FOG_MODE (GL_EXP, GL_EXP2, GL_LINEAR), GL_FOG_DENSITY (0 or more, for GL_EXP and GL_EXP2), GL_FOG_START and
        GL_FOG_END (distances, for GL_LINEAR), GL_FOG_COLOR (red, green, blue, alpha), GL_FOG_COORD_SRC (GL_FRAGMENT_DEPTH or
        GL_FOG_COORD), GL_FOG_INDEX
    params: the values: a sequence of numbers, or one number where one is enough
    Numbers, or a sequence of them, of any type; glFogf and so on take one."""

def glFogCoord(*arguments: Any) -> Any:
    """Sets the current fog coordinate: the distance that fog uses instead of the depth, after glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD).

    coord: distance from the viewer, in the units of your scene
    Numbers, or a sequence of them, of any type; glFogCoordf and so on take one.
    Also between glBegin and glEnd."""

def glFogCoordPointer(type: int, stride: int, pointer: Numbers) -> None:
    """Names the array of fog coordinates, used once glEnableClientState(GL_FOG_COORD_ARRAY) is called.

    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glFogCoordd(coord: float) -> None:
    """Sets the current fog coordinate: the distance that fog uses instead of the depth, after glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD).

    coord: distance from the viewer, in the units of your scene
    Also between glBegin and glEnd."""

def glFogCoorddv(v: Numbers) -> None:
    """Sets the current fog coordinate: the distance that fog uses instead of the depth, after glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD).

    v: a sequence of one number
    Also between glBegin and glEnd."""

def glFogCoordf(coord: float) -> None:
    """Sets the current fog coordinate: the distance that fog uses instead of the depth, after glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD).

    coord: distance from the viewer, in the units of your scene
    Also between glBegin and glEnd."""

def glFogCoordfv(v: Numbers) -> None:
    """Sets the current fog coordinate: the distance that fog uses instead of the depth, after glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD).

    v: a sequence of one number
    Also between glBegin and glEnd."""

def glFogf(pname: int, param: float) -> None:
    """Sets a property of the fog that glEnable(GL_FOG) switches on.

    pname: GL_FOG_MODE (GL_EXP, GL_EXP2, GL_LINEAR), GL_FOG_DENSITY (0 or more, for GL_EXP and GL_EXP2), GL_FOG_START and
        GL_FOG_END (distances, for GL_LINEAR), GL_FOG_COLOR (red, green, blue, alpha), GL_FOG_COORD_SRC (GL_FRAGMENT_DEPTH or
        GL_FOG_COORD), GL_FOG_INDEX
    param: the value: one number or one constant"""

def glFogfv(pname: int, params: Numbers) -> None:
    """Sets a property of the fog that glEnable(GL_FOG) switches on.

    pname: GL_FOG_MODE (GL_EXP, GL_EXP2, GL_LINEAR), GL_FOG_DENSITY (0 or more, for GL_EXP and GL_EXP2), GL_FOG_START and
        GL_FOG_END (distances, for GL_LINEAR), GL_FOG_COLOR (red, green, blue, alpha), GL_FOG_COORD_SRC (GL_FRAGMENT_DEPTH or
        GL_FOG_COORD), GL_FOG_INDEX
    params: the values: a sequence of numbers, or one number where one is enough"""

def glFogi(pname: int, param: int) -> None:
    """Sets a property of the fog that glEnable(GL_FOG) switches on.

    pname: GL_FOG_MODE (GL_EXP, GL_EXP2, GL_LINEAR), GL_FOG_DENSITY (0 or more, for GL_EXP and GL_EXP2), GL_FOG_START and
        GL_FOG_END (distances, for GL_LINEAR), GL_FOG_COLOR (red, green, blue, alpha), GL_FOG_COORD_SRC (GL_FRAGMENT_DEPTH or
        GL_FOG_COORD), GL_FOG_INDEX
    param: the value: one number or one constant
    Whole numbers."""

def glFogiv(pname: int, params: Numbers) -> None:
    """Sets a property of the fog that glEnable(GL_FOG) switches on.

    pname: GL_FOG_MODE (GL_EXP, GL_EXP2, GL_LINEAR), GL_FOG_DENSITY (0 or more, for GL_EXP and GL_EXP2), GL_FOG_START and
        GL_FOG_END (distances, for GL_LINEAR), GL_FOG_COLOR (red, green, blue, alpha), GL_FOG_COORD_SRC (GL_FRAGMENT_DEPTH or
        GL_FOG_COORD), GL_FOG_INDEX
    params: the values: a sequence of numbers, or one number where one is enough
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glFrontFace(mode: int) -> None:
    """Says which side of a polygon is its front: the one from which its corners run in this order on the screen.

    mode: GL_CCW, counter-clockwise (the initial value), or GL_CW, clockwise"""

def glFrustum(left: float, right: float, bottom: float, top: float, zNear: float, zFar: float) -> None:
    """Multiplies the current matrix (usually GL_PROJECTION) by a perspective view: the pyramid from the eye through a rectangle in
    the near plane.

    left: x of the rectangle's left edge
    right: x of its right edge
    bottom: y of its lower edge
    top: y of its upper edge
    zNear: distance from the eye to the near plane, more than 0
    zFar: distance from the eye to the far plane, more than 0"""

def glGenBuffers(n: Any, buffers: Any = ...) -> Any:
    """Gives unused names for buffers: one number for n = 1, else an array of numbers.

    n: how many names
    buffers: an array to fill, instead of a new one"""

def glGenLists(s: int) -> Any:
    """Returns the first of several unused numbers of display lists in a row.

    s: how many"""

def glGenQueries(n: Any, ids: Any = ...) -> Any:
    """Gives unused names for queries: one number for n = 1, else an array of numbers.

    n: how many names
    ids: an array to fill, instead of a new one"""

def glGenTextures(n: Any, textures: Any = ...) -> Any:
    """Gives unused names for textures: one number for n = 1, else an array of numbers.

    n: how many names
    textures: an array to fill, instead of a new one"""

def glGetBoolean(pname: Any, params: Any = ...) -> Any:
    """Returns a value of the state, as the type in the command's name: one number or an array.

    pname: GL_MODELVIEW_MATRIX, GL_VIEWPORT, GL_CURRENT_COLOR, GL_MAX_LIGHTS, ...; whatever can be set can be asked
    params: an array to fill, instead of a new one"""

def glGetBooleanv(pname: int, params: Any = ...) -> Any:
    """Returns a value of the state, as the type in the command's name: one number or an array.

    pname: GL_MODELVIEW_MATRIX, GL_VIEWPORT, GL_CURRENT_COLOR, GL_MAX_LIGHTS, ...; whatever can be set can be asked
    params: an array to fill, instead of a new one"""

def glGetBufferParameteriv(target: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of the bound buffer.

    target: GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER
    pname: GL_BUFFER_SIZE (bytes), GL_BUFFER_USAGE, GL_BUFFER_ACCESS or GL_BUFFER_MAPPED
    params: the values: a sequence of numbers, or one number where one is enough
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetBufferPointerv(target: int, pname: int) -> Any:
    """Returns the address that glMapBuffer gave, or None.

    target: GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER
    pname: GL_BUFFER_MAP_POINTER"""

def glGetBufferSubData(target: int, offset: Any, size: Any, data: Any = ...) -> Any:
    """Returns a part of the bound buffer, as an array of bytes.

    target: GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER
    offset: where the part begins, in bytes
    size: in bytes
    data: an array to fill, instead of a new one"""

def glGetClipPlane(plane: int) -> Any:
    """Returns the four numbers of a clip plane in eye space.

    plane: GL_CLIP_PLANE0 to GL_CLIP_PLANE5"""

def glGetCompressedTexImage(target: int, lod: int) -> Any:
    """Would return a compressed picture.  Refused with GL_INVALID_OPERATION: no texture is compressed.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D or GL_TEXTURE_3D
    lod: level of the mipmap"""

def glGetDouble(pname: Any, params: Any = ...) -> Any:
    """Returns a value of the state, as the type in the command's name: one number or an array.

    pname: GL_MODELVIEW_MATRIX, GL_VIEWPORT, GL_CURRENT_COLOR, GL_MAX_LIGHTS, ...; whatever can be set can be asked
    params: an array to fill, instead of a new one"""

def glGetDoublev(pname: int, params: Any = ...) -> Any:
    """Returns a value of the state, as the type in the command's name: one number or an array.

    pname: GL_MODELVIEW_MATRIX, GL_VIEWPORT, GL_CURRENT_COLOR, GL_MAX_LIGHTS, ...; whatever can be set can be asked
    params: an array to fill, instead of a new one"""

def glGetError() -> Any:
    """Returns GL_NO_ERROR always: an error is raised, as GLError, by the call that causes it.

    Also between glBegin and glEnd."""

def glGetFloat(pname: Any, params: Any = ...) -> Any:
    """Returns a value of the state, as the type in the command's name: one number or an array.

    pname: GL_MODELVIEW_MATRIX, GL_VIEWPORT, GL_CURRENT_COLOR, GL_MAX_LIGHTS, ...; whatever can be set can be asked
    params: an array to fill, instead of a new one"""

def glGetFloatv(pname: int, params: Any = ...) -> Any:
    """Returns a value of the state, as the type in the command's name: one number or an array.

    pname: GL_MODELVIEW_MATRIX, GL_VIEWPORT, GL_CURRENT_COLOR, GL_MAX_LIGHTS, ...; whatever can be set can be asked
    params: an array to fill, instead of a new one"""

def glGetInteger(pname: Any, params: Any = ...) -> Any:
    """Returns a value of the state, as the type in the command's name: one number or an array.

    pname: GL_MODELVIEW_MATRIX, GL_VIEWPORT, GL_CURRENT_COLOR, GL_MAX_LIGHTS, ...; whatever can be set can be asked
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetIntegerv(pname: int, params: Any = ...) -> Any:
    """Returns a value of the state, as the type in the command's name: one number or an array.

    pname: GL_MODELVIEW_MATRIX, GL_VIEWPORT, GL_CURRENT_COLOR, GL_MAX_LIGHTS, ...; whatever can be set can be asked
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetLightfv(light: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of a light; positions and directions are in eye space.

    light: GL_LIGHT0 to GL_LIGHT7
    pname: as in glLight
    params: an array to fill, instead of a new one"""

def glGetLightiv(light: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of a light; positions and directions are in eye space.

    light: GL_LIGHT0 to GL_LIGHT7
    pname: as in glLight
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetMapdv(map: int, value: int, params: Any = ...) -> Any:
    """Returns a property of a Bezier curve or surface.

    map: as in glMap1f and glMap2f
    value: GL_COEFF (the control points), GL_ORDER or GL_DOMAIN
    params: an array to fill, instead of a new one"""

def glGetMapfv(map: int, value: int, params: Any = ...) -> Any:
    """Returns a property of a Bezier curve or surface.

    map: as in glMap1f and glMap2f
    value: GL_COEFF (the control points), GL_ORDER or GL_DOMAIN
    params: an array to fill, instead of a new one"""

def glGetMapiv(map: int, value: int, params: Any = ...) -> Any:
    """Returns a property of a Bezier curve or surface.

    map: as in glMap1f and glMap2f
    value: GL_COEFF (the control points), GL_ORDER or GL_DOMAIN
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetMaterialfv(face: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of the material.

    face: GL_FRONT or GL_BACK
    pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION or GL_SHININESS
    params: an array to fill, instead of a new one"""

def glGetMaterialiv(face: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of the material.

    face: GL_FRONT or GL_BACK
    pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION or GL_SHININESS
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetPixelMapfv(map: int, values: Any = ...) -> Any:
    """Returns the table of a pixel map.

    map: as in glPixelMap
    values: an array to fill, instead of a new one"""

def glGetPixelMapuiv(map: int, values: Any = ...) -> Any:
    """Returns the table of a pixel map.

    map: as in glPixelMap
    values: an array to fill, instead of a new one"""

def glGetPixelMapusv(map: int, values: Any = ...) -> Any:
    """Returns the table of a pixel map.

    map: as in glPixelMap
    values: an array to fill, instead of a new one"""

def glGetPointerv(pname: int) -> Any:
    """Returns the array, or the offset into a buffer, that a vertex array uses; None if none was given.

    pname: GL_VERTEX_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER, ..., GL_SELECTION_BUFFER_POINTER"""

def glGetPolygonStipple() -> Any:
    """Returns the pattern of glPolygonStipple as 128 bytes."""

def glGetPolygonStippleub() -> Any:
    """Returns the pattern of glPolygonStipple as 128 bytes.

    glGetPolygonStippleub() returns 128 GL_UNSIGNED_BYTE numbers."""

def glGetQueryObjectiv(id: Any, pname: int, params: Any = ...) -> Any:
    """Returns the count of a query that has ended.

    id: the number of a query
    pname: GL_QUERY_RESULT or GL_QUERY_RESULT_AVAILABLE
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetQueryObjectuiv(id: Any, pname: int, params: Any = ...) -> Any:
    """Returns the count of a query that has ended.

    id: the number of a query
    pname: GL_QUERY_RESULT or GL_QUERY_RESULT_AVAILABLE
    params: an array to fill, instead of a new one
    Whole numbers."""

def glGetQueryiv(target: int, pname: int, params: Any = ...) -> Any:
    """Returns which query is counting, or how many bits its counter has.

    target: GL_SAMPLES_PASSED
    pname: GL_CURRENT_QUERY or GL_QUERY_COUNTER_BITS
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetString(name: int) -> Any:
    """Returns a text about the context, as bytes.

    name: GL_VENDOR, GL_RENDERER, GL_VERSION, GL_EXTENSIONS, or GL_SHADING_LANGUAGE_VERSION (there is none, and the text says so)"""

def glGetStringi(name: int, index: int) -> Any:
    """Returns one text of a list, as bytes; programs of OpenGL 3.0 and later ask for the extensions so, one by one.

    name: GL_EXTENSIONS
    index: from 0 to glGetIntegerv(GL_NUM_EXTENSIONS) - 1"""

def glGetTexEnvfv(env: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of the texture environment.

    env: GL_TEXTURE_ENV or GL_TEXTURE_FILTER_CONTROL
    pname: as in glTexEnv
    params: an array to fill, instead of a new one"""

def glGetTexEnviv(env: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of the texture environment.

    env: GL_TEXTURE_ENV or GL_TEXTURE_FILTER_CONTROL
    pname: as in glTexEnv
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetTexGendv(coord: int, pname: int, params: Any = ...) -> Any:
    """Returns how a texture coordinate is made.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE or GL_EYE_PLANE
    params: an array to fill, instead of a new one"""

def glGetTexGenfv(coord: int, pname: int, params: Any = ...) -> Any:
    """Returns how a texture coordinate is made.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE or GL_EYE_PLANE
    params: an array to fill, instead of a new one"""

def glGetTexGeniv(coord: int, pname: int, params: Any = ...) -> Any:
    """Returns how a texture coordinate is made.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE or GL_EYE_PLANE
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetTexImage(target: Any, level: Any, format: int, type: int, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or a face of a cube map
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    array: an array to fill, instead of a new one
    outputType: bytes (the default) or an array type, for what is returned for GL_UNSIGNED_BYTE"""

def glGetTexImageb(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    glGetTexImageb(target, level, format) returns GL_BYTE numbers."""

def glGetTexImaged(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    glGetTexImaged(target, level, format) returns GL_DOUBLE numbers."""

def glGetTexImagef(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    glGetTexImagef(target, level, format) returns GL_FLOAT numbers."""

def glGetTexImagei(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    glGetTexImagei(target, level, format) returns GL_INT numbers."""

def glGetTexImages(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    glGetTexImages(target, level, format) returns GL_SHORT numbers."""

def glGetTexImageub(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    glGetTexImageub(target, level, format) returns GL_UNSIGNED_BYTE numbers."""

def glGetTexImageui(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    glGetTexImageui(target, level, format) returns GL_UNSIGNED_INT numbers."""

def glGetTexImageus(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns the picture of the bound texture: bytes for GL_UNSIGNED_BYTE, else an array.

    glGetTexImageus(target, level, format) returns GL_UNSIGNED_SHORT numbers."""

def glGetTexLevelParameterfv(target: int, level: Any, pname: int, params: Any = ...) -> Any:
    """Returns a property of one level of the bound texture.

    target: as in glTexImage2D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    pname: GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_BORDER, GL_TEXTURE_INTERNAL_FORMAT,
        GL_TEXTURE_RED_SIZE, ...
    params: an array to fill, instead of a new one"""

def glGetTexLevelParameteriv(target: int, level: Any, pname: int, params: Any = ...) -> Any:
    """Returns a property of one level of the bound texture.

    target: as in glTexImage2D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    pname: GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_BORDER, GL_TEXTURE_INTERNAL_FORMAT,
        GL_TEXTURE_RED_SIZE, ...
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glGetTexParameterfv(target: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of the bound texture.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or GL_TEXTURE_CUBE_MAP
    pname: as in glTexParameter
    params: an array to fill, instead of a new one"""

def glGetTexParameteriv(target: int, pname: int, params: Any = ...) -> Any:
    """Returns a property of the bound texture.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or GL_TEXTURE_CUBE_MAP
    pname: as in glTexParameter
    params: an array to fill, instead of a new one
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glHint(target: int, hint: int) -> None:
    """Says whether speed or quality matters more.  Without effect, but for GL_AFFINE_GLSIM: there is one way to draw everything.

    target: GL_PERSPECTIVE_CORRECTION_HINT, GL_LINE_SMOOTH_HINT, GL_FOG_HINT, ...
    hint: GL_FASTEST, GL_NICEST or GL_DONT_CARE; of GL_PERSPECTIVE_CORRECTION_HINT also GL_AFFINE_GLSIM, an extension:
        colours, normals, texture coordinates and fog are interpolated linearly on the screen, which is wrong in perspective"""

def glIndex(*arguments: Any) -> Any:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    c: the index
    Numbers, or a sequence of them, of any type; glIndexs and so on take one.
    Also between glBegin and glEnd."""

def glIndexMask(mask: int) -> None:
    """Says which bits of colour indices are written.  Accepted without effect: every context is RGBA.

    mask: the bits"""

def glIndexPointer(type: int, stride: int, pointer: Numbers) -> None:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glIndexPointerb(array: Any) -> Any:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    glIndexPointerb(array), an array of GL_BYTE numbers; size and stride follow from it."""

def glIndexPointerd(array: Any) -> Any:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    glIndexPointerd(array), an array of GL_DOUBLE numbers; size and stride follow from it."""

def glIndexPointerf(array: Any) -> Any:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    glIndexPointerf(array), an array of GL_FLOAT numbers; size and stride follow from it."""

def glIndexPointeri(array: Any) -> Any:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    glIndexPointeri(array), an array of GL_INT numbers; size and stride follow from it."""

def glIndexPointers(array: Any) -> Any:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    glIndexPointers(array), an array of GL_SHORT numbers; size and stride follow from it."""

def glIndexPointerub(array: Any) -> Any:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    glIndexPointerub(array), an array of GL_UNSIGNED_BYTE numbers; size and stride follow from it."""

def glIndexPointerui(array: Any) -> Any:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    glIndexPointerui(array), an array of GL_UNSIGNED_INT numbers; size and stride follow from it."""

def glIndexPointerus(array: Any) -> Any:
    """Names the array of colour indices.  Accepted without effect: every context is RGBA.

    glIndexPointerus(array), an array of GL_UNSIGNED_SHORT numbers; size and stride follow from it."""

def glIndexd(c: float) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    c: the index
    Also between glBegin and glEnd."""

def glIndexdv(v: Numbers) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    v: a sequence of one number
    Also between glBegin and glEnd."""

def glIndexf(c: float) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    c: the index
    Also between glBegin and glEnd."""

def glIndexfv(v: Numbers) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    v: a sequence of one number
    Also between glBegin and glEnd."""

def glIndexi(c: int) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    c: the index
    Whole numbers.
    Also between glBegin and glEnd."""

def glIndexiv(v: Numbers) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    v: a sequence of one number
    Also between glBegin and glEnd."""

def glIndexs(c: int) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    c: the index
    Whole numbers.
    Also between glBegin and glEnd."""

def glIndexsv(v: Numbers) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    v: a sequence of one number
    Also between glBegin and glEnd."""

def glIndexub(c: int) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    c: the index
    Whole numbers.
    Also between glBegin and glEnd."""

def glIndexubv(v: Numbers) -> None:
    """Sets the current colour index.  Accepted without effect: every context is RGBA.

    v: a sequence of one number
    Also between glBegin and glEnd."""

def glInitNames() -> None:
    """Empties the stack of names that selection uses."""

def glInterleavedArrays(format: int, stride: int, pointer: Numbers) -> None:
    """Names one array that holds several vertex arrays side by side, and switches them on.

    format: what a vertex holds, in order: GL_V3F, GL_N3F_V3F, GL_C4UB_V3F, GL_T2F_V3F, GL_T2F_N3F_V3F, GL_T2F_C4F_N3F_V3F, ...
    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glIsBuffer(buffer: int) -> Any:
    """Returns whether this is the name of a buffer that was bound.

    buffer: a name"""

def glIsEnabled(cap: int) -> Any:
    """Returns whether something is switched on.

    cap: as in glEnable"""

def glIsList(list: int) -> Any:
    """Returns whether there is a display list of this number.

    list: a number"""

def glIsQuery(id: int) -> Any:
    """Returns whether this is the name of a query that was begun.

    id: the number of a query"""

def glIsTexture(texture: int) -> Any:
    """Returns whether this is the name of a texture that was bound.

    texture: a name"""

def glLight(*arguments: Any) -> Any:
    """Sets a property of a light.  Its position and direction are transformed by the modelview matrix of this moment, and then stay
    where they are: place a light after gluLookAt to fix it in the scene, before to fix it to the camera.

    light: GL_LIGHT0 to GL_LIGHT7
    pname: GL_POSITION (x, y, z, w: w = 1 for a lamp at a point, w = 0 for the sun in a direction); GL_AMBIENT, GL_DIFFUSE,
        GL_SPECULAR (red, green, blue and alpha, 0 to 1); GL_SPOT_DIRECTION (three numbers), GL_SPOT_CUTOFF (half the cone's angle
        in degrees, 0 to 90, or 180 for no cone), GL_SPOT_EXPONENT (0 to 128); GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION,
        GL_QUADRATIC_ATTENUATION (0 or more)
    params: as many numbers as the property has: four for a position or a colour
    Numbers, or a sequence of them, of any type; glLightf and so on take one."""

def glLightModel(*arguments: Any) -> Any:
    """Sets a property of lighting as a whole.

    pname: GL_LIGHT_MODEL_AMBIENT (light from everywhere: red, green, blue, alpha, initially 0.2, 0.2, 0.2, 1);
        GL_LIGHT_MODEL_TWO_SIDE (1: back faces are lit by their own material and turned normals); GL_LIGHT_MODEL_LOCAL_VIEWER (1:
        the highlight looks from the eye's place, 0: along z); GL_LIGHT_MODEL_COLOR_CONTROL (GL_SINGLE_COLOR, or
        GL_SEPARATE_SPECULAR_COLOR: the highlight is added after texturing); GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM
        (GL_BLINN_TORRANCE_GLSIM or GL_PHONG_LOBE_GLSIM); GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM (GL_CLAMP_NORMAL_GLSIM or
        GL_FLIP_NORMAL_GLSIM)
    params: the values: a sequence of numbers, or one number where one is enough
    Numbers, or a sequence of them, of any type; glLightModelf and so on take one."""

def glLightModelf(pname: int, param: float) -> None:
    """Sets a property of lighting as a whole.

    pname: GL_LIGHT_MODEL_AMBIENT (light from everywhere: red, green, blue, alpha, initially 0.2, 0.2, 0.2, 1);
        GL_LIGHT_MODEL_TWO_SIDE (1: back faces are lit by their own material and turned normals); GL_LIGHT_MODEL_LOCAL_VIEWER (1:
        the highlight looks from the eye's place, 0: along z); GL_LIGHT_MODEL_COLOR_CONTROL (GL_SINGLE_COLOR, or
        GL_SEPARATE_SPECULAR_COLOR: the highlight is added after texturing); GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM
        (GL_BLINN_TORRANCE_GLSIM or GL_PHONG_LOBE_GLSIM); GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM (GL_CLAMP_NORMAL_GLSIM or
        GL_FLIP_NORMAL_GLSIM)
    param: the value: one number or one constant"""

def glLightModelfv(pname: int, params: Numbers) -> None:
    """Sets a property of lighting as a whole.

    pname: GL_LIGHT_MODEL_AMBIENT (light from everywhere: red, green, blue, alpha, initially 0.2, 0.2, 0.2, 1);
        GL_LIGHT_MODEL_TWO_SIDE (1: back faces are lit by their own material and turned normals); GL_LIGHT_MODEL_LOCAL_VIEWER (1:
        the highlight looks from the eye's place, 0: along z); GL_LIGHT_MODEL_COLOR_CONTROL (GL_SINGLE_COLOR, or
        GL_SEPARATE_SPECULAR_COLOR: the highlight is added after texturing); GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM
        (GL_BLINN_TORRANCE_GLSIM or GL_PHONG_LOBE_GLSIM); GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM (GL_CLAMP_NORMAL_GLSIM or
        GL_FLIP_NORMAL_GLSIM)
    params: the values: a sequence of numbers, or one number where one is enough"""

def glLightModeli(pname: int, param: int) -> None:
    """Sets a property of lighting as a whole.

    pname: GL_LIGHT_MODEL_AMBIENT (light from everywhere: red, green, blue, alpha, initially 0.2, 0.2, 0.2, 1);
        GL_LIGHT_MODEL_TWO_SIDE (1: back faces are lit by their own material and turned normals); GL_LIGHT_MODEL_LOCAL_VIEWER (1:
        the highlight looks from the eye's place, 0: along z); GL_LIGHT_MODEL_COLOR_CONTROL (GL_SINGLE_COLOR, or
        GL_SEPARATE_SPECULAR_COLOR: the highlight is added after texturing); GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM
        (GL_BLINN_TORRANCE_GLSIM or GL_PHONG_LOBE_GLSIM); GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM (GL_CLAMP_NORMAL_GLSIM or
        GL_FLIP_NORMAL_GLSIM)
    param: the value: one number or one constant
    Whole numbers."""

def glLightModeliv(pname: int, params: Numbers) -> None:
    """Sets a property of lighting as a whole.

    pname: GL_LIGHT_MODEL_AMBIENT (light from everywhere: red, green, blue, alpha, initially 0.2, 0.2, 0.2, 1);
        GL_LIGHT_MODEL_TWO_SIDE (1: back faces are lit by their own material and turned normals); GL_LIGHT_MODEL_LOCAL_VIEWER (1:
        the highlight looks from the eye's place, 0: along z); GL_LIGHT_MODEL_COLOR_CONTROL (GL_SINGLE_COLOR, or
        GL_SEPARATE_SPECULAR_COLOR: the highlight is added after texturing); GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM
        (GL_BLINN_TORRANCE_GLSIM or GL_PHONG_LOBE_GLSIM); GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM (GL_CLAMP_NORMAL_GLSIM or
        GL_FLIP_NORMAL_GLSIM)
    params: the values: a sequence of numbers, or one number where one is enough
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glLightf(light: int, pname: int, param: float) -> None:
    """Sets a property of a light.  Its position and direction are transformed by the modelview matrix of this moment, and then stay
    where they are: place a light after gluLookAt to fix it in the scene, before to fix it to the camera.

    light: GL_LIGHT0 to GL_LIGHT7
    pname: GL_POSITION (x, y, z, w: w = 1 for a lamp at a point, w = 0 for the sun in a direction); GL_AMBIENT, GL_DIFFUSE,
        GL_SPECULAR (red, green, blue and alpha, 0 to 1); GL_SPOT_DIRECTION (three numbers), GL_SPOT_CUTOFF (half the cone's angle
        in degrees, 0 to 90, or 180 for no cone), GL_SPOT_EXPONENT (0 to 128); GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION,
        GL_QUADRATIC_ATTENUATION (0 or more)
    param: the value: one number or one constant"""

def glLightfv(light: int, pname: int, params: Numbers) -> None:
    """Sets a property of a light.  Its position and direction are transformed by the modelview matrix of this moment, and then stay
    where they are: place a light after gluLookAt to fix it in the scene, before to fix it to the camera.

    light: GL_LIGHT0 to GL_LIGHT7
    pname: GL_POSITION (x, y, z, w: w = 1 for a lamp at a point, w = 0 for the sun in a direction); GL_AMBIENT, GL_DIFFUSE,
        GL_SPECULAR (red, green, blue and alpha, 0 to 1); GL_SPOT_DIRECTION (three numbers), GL_SPOT_CUTOFF (half the cone's angle
        in degrees, 0 to 90, or 180 for no cone), GL_SPOT_EXPONENT (0 to 128); GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION,
        GL_QUADRATIC_ATTENUATION (0 or more)
    params: as many numbers as the property has: four for a position or a colour"""

def glLighti(light: int, pname: int, param: int) -> None:
    """Sets a property of a light.  Its position and direction are transformed by the modelview matrix of this moment, and then stay
    where they are: place a light after gluLookAt to fix it in the scene, before to fix it to the camera.

    light: GL_LIGHT0 to GL_LIGHT7
    pname: GL_POSITION (x, y, z, w: w = 1 for a lamp at a point, w = 0 for the sun in a direction); GL_AMBIENT, GL_DIFFUSE,
        GL_SPECULAR (red, green, blue and alpha, 0 to 1); GL_SPOT_DIRECTION (three numbers), GL_SPOT_CUTOFF (half the cone's angle
        in degrees, 0 to 90, or 180 for no cone), GL_SPOT_EXPONENT (0 to 128); GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION,
        GL_QUADRATIC_ATTENUATION (0 or more)
    param: the value: one number or one constant
    Whole numbers."""

def glLightiv(light: int, pname: int, params: Numbers) -> None:
    """Sets a property of a light.  Its position and direction are transformed by the modelview matrix of this moment, and then stay
    where they are: place a light after gluLookAt to fix it in the scene, before to fix it to the camera.

    light: GL_LIGHT0 to GL_LIGHT7
    pname: GL_POSITION (x, y, z, w: w = 1 for a lamp at a point, w = 0 for the sun in a direction); GL_AMBIENT, GL_DIFFUSE,
        GL_SPECULAR (red, green, blue and alpha, 0 to 1); GL_SPOT_DIRECTION (three numbers), GL_SPOT_CUTOFF (half the cone's angle
        in degrees, 0 to 90, or 180 for no cone), GL_SPOT_EXPONENT (0 to 128); GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION,
        GL_QUADRATIC_ATTENUATION (0 or more)
    params: as many numbers as the property has: four for a position or a colour
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glLineStipple(factor: int, pattern: int) -> None:
    """Sets the pattern of dashed lines, once glEnable(GL_LINE_STIPPLE) is called.

    factor: how many pixels each bit of the pattern lasts, 1 to 256
    pattern: 16 bits, used from the lowest; a 1 draws"""

def glLineWidth(width: float) -> None:
    """Sets the width of lines.

    width: in pixels, more than 0; initially 1"""

def glListBase(base: int) -> None:
    """Sets what is added to the numbers of glCallLists.

    base: a whole number; initially 0"""

def glLoadIdentity() -> None:
    """Replaces the current matrix by the identity, which changes nothing."""

def glLoadMatrixd(m: Numbers) -> None:
    """Replaces the current matrix.  glLoadMatrix takes columns one after the other, glLoadTransposeMatrix rows.

    m: 16 numbers, flat or 4 x 4"""

def glLoadMatrixf(m: Numbers) -> None:
    """Replaces the current matrix.  glLoadMatrix takes columns one after the other, glLoadTransposeMatrix rows.

    m: 16 numbers, flat or 4 x 4"""

def glLoadName(name: int) -> None:
    """Replaces the last name on the stack of names that selection uses.

    name: a whole number, 0 or more"""

def glLoadTransposeMatrixd(m: Numbers) -> None:
    """Replaces the current matrix.  glLoadMatrix takes columns one after the other, glLoadTransposeMatrix rows.

    m: 16 numbers, flat or 4 x 4"""

def glLoadTransposeMatrixf(m: Numbers) -> None:
    """Replaces the current matrix.  glLoadMatrix takes columns one after the other, glLoadTransposeMatrix rows.

    m: 16 numbers, flat or 4 x 4"""

def glLogicOp(op: int) -> None:
    """Says how the bits of new and old colours become one, once glEnable(GL_COLOR_LOGIC_OP) is called.

    op: GL_COPY (the initial value), GL_XOR, GL_AND, GL_OR, GL_INVERT, GL_CLEAR, GL_SET, GL_NOOP, GL_EQUIV, ..."""

def glMap1d(target: int, u1: Any, u2: Any, stride: Any, order: Any = ..., points: Any = ...) -> None:
    """Sets the control points of a Bezier curve; as in PyOpenGL also glMap1f(target, u1, u2, points).

    target: what the curve gives: GL_MAP1_VERTEX_3, GL_MAP1_VERTEX_4, GL_MAP1_NORMAL, GL_MAP1_COLOR_4, GL_MAP1_TEXTURE_COORD_2, ...
    u1: value of u where the curve begins
    u2: value of u where it ends
    stride: numbers from one control point to the next
    order: how many control points: the degree + 1
    points: the control points"""

def glMap1f(target: int, u1: Any, u2: Any, stride: Any, order: Any = ..., points: Any = ...) -> None:
    """Sets the control points of a Bezier curve; as in PyOpenGL also glMap1f(target, u1, u2, points).

    target: what the curve gives: GL_MAP1_VERTEX_3, GL_MAP1_VERTEX_4, GL_MAP1_NORMAL, GL_MAP1_COLOR_4, GL_MAP1_TEXTURE_COORD_2, ...
    u1: value of u where the curve begins
    u2: value of u where it ends
    stride: numbers from one control point to the next
    order: how many control points: the degree + 1
    points: the control points"""

def glMap2d(target: int, u1: Any, u2: Any, ustride: Any, uorder: Any, v1: Any, v2: Any = ..., vstride: Any = ..., vorder: Any = ..., points: Any = ...) -> None:
    """Sets the control points of a Bezier surface; as in PyOpenGL also glMap2f(target, u1, u2, v1, v2, points).

    target: what the surface gives: GL_MAP2_VERTEX_3, GL_MAP2_VERTEX_4, GL_MAP2_NORMAL, GL_MAP2_COLOR_4, ...
    u1: value of u where the surface begins
    u2: value of u where it ends
    ustride: numbers from one control point to the next along u
    uorder: how many control points along u
    v1: value of v where the surface begins
    v2: value of v where it ends
    vstride: numbers from one control point to the next along v
    vorder: how many control points along v
    points: the control points"""

def glMap2f(target: int, u1: Any, u2: Any, ustride: Any, uorder: Any, v1: Any, v2: Any = ..., vstride: Any = ..., vorder: Any = ..., points: Any = ...) -> None:
    """Sets the control points of a Bezier surface; as in PyOpenGL also glMap2f(target, u1, u2, v1, v2, points).

    target: what the surface gives: GL_MAP2_VERTEX_3, GL_MAP2_VERTEX_4, GL_MAP2_NORMAL, GL_MAP2_COLOR_4, ...
    u1: value of u where the surface begins
    u2: value of u where it ends
    ustride: numbers from one control point to the next along u
    uorder: how many control points along u
    v1: value of v where the surface begins
    v2: value of v where it ends
    vstride: numbers from one control point to the next along v
    vorder: how many control points along v
    points: the control points"""

def glMapBuffer(target: int, access: int) -> Any:
    """Returns the address of the bound buffer's memory, which the program may read and write until glUnmapBuffer.

    target: GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER
    access: GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE"""

def glMapGrid1d(un: int, u1: float, u2: float) -> None:
    """Divides the range of u into equal steps for glEvalMesh1.

    un: how many steps
    u1: value of u at step 0
    u2: value of u at step un"""

def glMapGrid1f(un: int, u1: float, u2: float) -> None:
    """Divides the range of u into equal steps for glEvalMesh1.

    un: how many steps
    u1: value of u at step 0
    u2: value of u at step un"""

def glMapGrid2d(un: int, u1: float, u2: float, vn: int, v1: float, v2: float) -> None:
    """Divides the ranges of u and v into equal steps for glEvalMesh2.

    un: how many steps of u
    u1: value of u at step 0
    u2: value of u at step un
    vn: how many steps of v
    v1: value of v at step 0
    v2: value of v at step vn"""

def glMapGrid2f(un: int, u1: float, u2: float, vn: int, v1: float, v2: float) -> None:
    """Divides the ranges of u and v into equal steps for glEvalMesh2.

    un: how many steps of u
    u1: value of u at step 0
    u2: value of u at step un
    vn: how many steps of v
    v1: value of v at step 0
    v2: value of v at step vn"""

def glMaterial(*arguments: Any) -> Any:
    """Sets a property of the surface for the vertices that follow: how much of each light it reflects.

    face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK
    pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION (red, green, blue and alpha, 0 to 1), GL_AMBIENT_AND_DIFFUSE (both) or
        GL_SHININESS (one number from 0, a broad highlight, to 128, a small one)
    params: the four numbers of a colour, or the one of GL_SHININESS
    Numbers, or a sequence of them, of any type; glMaterialf and so on take one.
    Also between glBegin and glEnd."""

def glMaterialf(face: int, pname: int, param: float) -> None:
    """Sets a property of the surface for the vertices that follow: how much of each light it reflects.

    face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK
    pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION (red, green, blue and alpha, 0 to 1), GL_AMBIENT_AND_DIFFUSE (both) or
        GL_SHININESS (one number from 0, a broad highlight, to 128, a small one)
    param: the value: one number or one constant
    Also between glBegin and glEnd."""

def glMaterialfv(face: int, pname: int, params: Numbers) -> None:
    """Sets a property of the surface for the vertices that follow: how much of each light it reflects.

    face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK
    pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION (red, green, blue and alpha, 0 to 1), GL_AMBIENT_AND_DIFFUSE (both) or
        GL_SHININESS (one number from 0, a broad highlight, to 128, a small one)
    params: the four numbers of a colour, or the one of GL_SHININESS
    Also between glBegin and glEnd."""

def glMateriali(face: int, pname: int, param: int) -> None:
    """Sets a property of the surface for the vertices that follow: how much of each light it reflects.

    face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK
    pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION (red, green, blue and alpha, 0 to 1), GL_AMBIENT_AND_DIFFUSE (both) or
        GL_SHININESS (one number from 0, a broad highlight, to 128, a small one)
    param: the value: one number or one constant
    Whole numbers.
    Also between glBegin and glEnd."""

def glMaterialiv(face: int, pname: int, params: Numbers) -> None:
    """Sets a property of the surface for the vertices that follow: how much of each light it reflects.

    face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK
    pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION (red, green, blue and alpha, 0 to 1), GL_AMBIENT_AND_DIFFUSE (both) or
        GL_SHININESS (one number from 0, a broad highlight, to 128, a small one)
    params: the four numbers of a colour, or the one of GL_SHININESS
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glMatrixMode(mode: int) -> None:
    """Chooses the matrix that the following matrix commands change.

    mode: GL_MODELVIEW (the initial value: the scene before the camera), GL_PROJECTION (the camera's lens) or GL_TEXTURE"""

def glMultMatrixd(m: Numbers) -> None:
    """Multiplies the current matrix M by another, M := M m, so that m acts on the vertices first.  glMultMatrix takes columns one
    after the other, glMultTransposeMatrix rows.

    m: 16 numbers, flat or 4 x 4"""

def glMultMatrixf(m: Numbers) -> None:
    """Multiplies the current matrix M by another, M := M m, so that m acts on the vertices first.  glMultMatrix takes columns one
    after the other, glMultTransposeMatrix rows.

    m: 16 numbers, flat or 4 x 4"""

def glMultTransposeMatrixd(m: Numbers) -> None:
    """Multiplies the current matrix M by another, M := M m, so that m acts on the vertices first.  glMultMatrix takes columns one
    after the other, glMultTransposeMatrix rows.

    m: 16 numbers, flat or 4 x 4"""

def glMultTransposeMatrixf(m: Numbers) -> None:
    """Multiplies the current matrix M by another, M := M m, so that m acts on the vertices first.  glMultMatrix takes columns one
    after the other, glMultTransposeMatrix rows.

    m: 16 numbers, flat or 4 x 4"""

def glMultiDrawArrays(mode: int, first: Numbers, count: Numbers, primcount: int) -> None:
    """Draws several primitives from the enabled arrays, as a glDrawArrays for each.

    mode: as in glBegin
    first: the first vertex of each primitive: a sequence
    count: how many vertices each primitive has: a sequence
    primcount: how many primitives"""

def glMultiDrawElements(mode: int, count: Numbers, type: int, indices: Numbers, primcount: int) -> None:
    """Draws several primitives, as a glDrawElements for each.

    mode: as in glBegin
    count: how many numbers each primitive has: a sequence
    type: of the numbers: GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
    indices: a sequence with the numbers of each primitive
    primcount: how many primitives"""

def glMultiTexCoord(*arguments: Any) -> Any:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Numbers, or a sequence of them, of any type; glMultiTexCoord1s and so on take one.
    Also between glBegin and glEnd."""

def glMultiTexCoord1d(target: int, s: float) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    Also between glBegin and glEnd."""

def glMultiTexCoord1dv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord1f(target: int, s: float) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    Also between glBegin and glEnd."""

def glMultiTexCoord1fv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord1i(target: int, s: int) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    Whole numbers.
    Also between glBegin and glEnd."""

def glMultiTexCoord1iv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord1s(target: int, s: int) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    Whole numbers.
    Also between glBegin and glEnd."""

def glMultiTexCoord1sv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord2d(target: int, s: float, t: float) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    Also between glBegin and glEnd."""

def glMultiTexCoord2dv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord2f(target: int, s: float, t: float) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    Also between glBegin and glEnd."""

def glMultiTexCoord2fv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord2i(target: int, s: int, t: int) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glMultiTexCoord2iv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord2s(target: int, s: int, t: int) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glMultiTexCoord2sv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord3d(target: int, s: float, t: float, r: float) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    Also between glBegin and glEnd."""

def glMultiTexCoord3dv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord3f(target: int, s: float, t: float, r: float) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    Also between glBegin and glEnd."""

def glMultiTexCoord3fv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord3i(target: int, s: int, t: int, r: int) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glMultiTexCoord3iv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord3s(target: int, s: int, t: int, r: int) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glMultiTexCoord3sv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord4d(target: int, s: float, t: float, r: float, q: float) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Also between glBegin and glEnd."""

def glMultiTexCoord4dv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord4f(target: int, s: float, t: float, r: float, q: float) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Also between glBegin and glEnd."""

def glMultiTexCoord4fv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord4i(target: int, s: int, t: int, r: int, q: int) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glMultiTexCoord4iv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glMultiTexCoord4s(target: int, s: int, t: int, r: int, q: int) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glMultiTexCoord4sv(target: int, v: Numbers) -> None:
    """Sets the current texture coordinates of one texture unit, for the vertices that follow.

    target: the unit, GL_TEXTURE0 to GL_TEXTURE3
    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glNewList(n: int, mode: int) -> None:
    """Begins a display list: the commands until glEndList are kept, and glCallList does them again.

    n: number of the list, from glGenLists
    mode: GL_COMPILE (kept only) or GL_COMPILE_AND_EXECUTE (kept and done at once)"""

def glNormal(*arguments: Any) -> Any:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    nx: x component
    ny: y component
    nz: z component
    Numbers, or a sequence of them, of any type; glNormal3b and so on take one.
    Also between glBegin and glEnd."""

def glNormal3b(nx: int, ny: int, nz: int) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    nx: x component
    ny: y component
    nz: z component
    Whole numbers: -128 to 127 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glNormal3bv(v: Numbers) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -128 to 127 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glNormal3d(nx: float, ny: float, nz: float) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    nx: x component
    ny: y component
    nz: z component
    Also between glBegin and glEnd."""

def glNormal3dv(v: Numbers) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glNormal3f(nx: float, ny: float, nz: float) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    nx: x component
    ny: y component
    nz: z component
    Also between glBegin and glEnd."""

def glNormal3fv(v: Numbers) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glNormal3i(nx: int, ny: int, nz: int) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    nx: x component
    ny: y component
    nz: z component
    Whole numbers: -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glNormal3iv(v: Numbers) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glNormal3s(nx: int, ny: int, nz: int) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    nx: x component
    ny: y component
    nz: z component
    Whole numbers: -32768 to 32767 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glNormal3sv(v: Numbers) -> None:
    """Sets the current normal, for the vertices that follow.  Lighting needs one of length 1 at each vertex, pointing out of the
    surface; GL_NORMALIZE mends other lengths.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -32768 to 32767 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glNormalPointer(type: int, stride: int, pointer: Numbers) -> None:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glNormalPointerb(array: Any) -> Any:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    glNormalPointerb(array), an array of GL_BYTE numbers; size and stride follow from it."""

def glNormalPointerd(array: Any) -> Any:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    glNormalPointerd(array), an array of GL_DOUBLE numbers; size and stride follow from it."""

def glNormalPointerf(array: Any) -> Any:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    glNormalPointerf(array), an array of GL_FLOAT numbers; size and stride follow from it."""

def glNormalPointeri(array: Any) -> Any:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    glNormalPointeri(array), an array of GL_INT numbers; size and stride follow from it."""

def glNormalPointers(array: Any) -> Any:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    glNormalPointers(array), an array of GL_SHORT numbers; size and stride follow from it."""

def glNormalPointerub(array: Any) -> Any:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    glNormalPointerub(array), an array of GL_UNSIGNED_BYTE numbers; size and stride follow from it."""

def glNormalPointerui(array: Any) -> Any:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    glNormalPointerui(array), an array of GL_UNSIGNED_INT numbers; size and stride follow from it."""

def glNormalPointerus(array: Any) -> Any:
    """Names the array of normals, three numbers each, used once glEnableClientState(GL_NORMAL_ARRAY) is called.

    glNormalPointerus(array), an array of GL_UNSIGNED_SHORT numbers; size and stride follow from it."""

def glOrtho(left: float, right: float, bottom: float, top: float, zNear: float, zFar: float) -> None:
    """Multiplies the current matrix (usually GL_PROJECTION) by a parallel view: a box that is seen without perspective.

    left: x of the box's left side
    right: x of its right side
    bottom: y of its lower side
    top: y of its upper side
    zNear: distance to the near plane along the view; may be negative
    zFar: distance to the far plane along the view"""

def glPassThrough(token: float) -> None:
    """Puts a mark of your own into the feedback.

    token: a number"""

def glPixelMapfv(map: int, size: Any, values: Any = ...) -> None:
    """Sets a table that glPixelTransferi(GL_MAP_COLOR, 1) looks values up in; as in PyOpenGL also without the size.

    map: GL_PIXEL_MAP_R_TO_R, G_TO_G, B_TO_B, A_TO_A, I_TO_R, I_TO_G, I_TO_B, I_TO_A, I_TO_I or S_TO_S
    size: how many entries; a power of two for maps from indices
    values: the entries: 0 to 1 for colours, whole numbers run over their type's range"""

def glPixelMapuiv(map: int, size: Any, values: Any = ...) -> None:
    """Sets a table that glPixelTransferi(GL_MAP_COLOR, 1) looks values up in; as in PyOpenGL also without the size.

    map: GL_PIXEL_MAP_R_TO_R, G_TO_G, B_TO_B, A_TO_A, I_TO_R, I_TO_G, I_TO_B, I_TO_A, I_TO_I or S_TO_S
    size: how many entries; a power of two for maps from indices
    values: the entries: 0 to 1 for colours, whole numbers run over their type's range"""

def glPixelMapusv(map: int, size: Any, values: Any = ...) -> None:
    """Sets a table that glPixelTransferi(GL_MAP_COLOR, 1) looks values up in; as in PyOpenGL also without the size.

    map: GL_PIXEL_MAP_R_TO_R, G_TO_G, B_TO_B, A_TO_A, I_TO_R, I_TO_G, I_TO_B, I_TO_A, I_TO_I or S_TO_S
    size: how many entries; a power of two for maps from indices
    values: the entries: 0 to 1 for colours, whole numbers run over their type's range"""

def glPixelStore(*arguments: Any) -> Any:
    """Says how pixels lie in the program's memory, for glTexImage2D, glDrawPixels, glReadPixels and glBitmap.

    pname: GL_UNPACK_ALIGNMENT (rows begin at multiples of 1, 2, 4 or 8 bytes; initially 4), GL_UNPACK_ROW_LENGTH,
        GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, and GL_PACK_... for reading
    param: the value: one number or one constant
    Numbers, or a sequence of them, of any type; glPixelStoref and so on take one."""

def glPixelStoref(pname: int, param: float) -> None:
    """Says how pixels lie in the program's memory, for glTexImage2D, glDrawPixels, glReadPixels and glBitmap.

    pname: GL_UNPACK_ALIGNMENT (rows begin at multiples of 1, 2, 4 or 8 bytes; initially 4), GL_UNPACK_ROW_LENGTH,
        GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, and GL_PACK_... for reading
    param: the value: one number or one constant"""

def glPixelStorei(pname: int, param: int) -> None:
    """Says how pixels lie in the program's memory, for glTexImage2D, glDrawPixels, glReadPixels and glBitmap.

    pname: GL_UNPACK_ALIGNMENT (rows begin at multiples of 1, 2, 4 or 8 bytes; initially 4), GL_UNPACK_ROW_LENGTH,
        GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, and GL_PACK_... for reading
    param: the value: one number or one constant
    Whole numbers."""

def glPixelTransfer(*arguments: Any) -> Any:
    """Changes the colours and depths of pixels on their way between program and framebuffer.

    pname: GL_RED_SCALE, GL_RED_BIAS and so on for green, blue, alpha and depth; GL_MAP_COLOR, GL_MAP_STENCIL (0 or 1);
        GL_INDEX_SHIFT, GL_INDEX_OFFSET
    param: the value: one number or one constant
    Numbers, or a sequence of them, of any type; glPixelTransferf and so on take one."""

def glPixelTransferf(pname: int, param: float) -> None:
    """Changes the colours and depths of pixels on their way between program and framebuffer.

    pname: GL_RED_SCALE, GL_RED_BIAS and so on for green, blue, alpha and depth; GL_MAP_COLOR, GL_MAP_STENCIL (0 or 1);
        GL_INDEX_SHIFT, GL_INDEX_OFFSET
    param: the value: one number or one constant"""

def glPixelTransferi(pname: int, param: int) -> None:
    """Changes the colours and depths of pixels on their way between program and framebuffer.

    pname: GL_RED_SCALE, GL_RED_BIAS and so on for green, blue, alpha and depth; GL_MAP_COLOR, GL_MAP_STENCIL (0 or 1);
        GL_INDEX_SHIFT, GL_INDEX_OFFSET
    param: the value: one number or one constant
    Whole numbers."""

def glPixelZoom(zx: float, zy: float) -> None:
    """Sets the size at which glDrawPixels and glCopyPixels draw each pixel.

    zx: factor to the right; negative mirrors
    zy: factor upwards; negative mirrors"""

def glPointParameter(*arguments: Any) -> Any:
    """Sets how points shrink with their distance from the eye.

    pname: GL_POINT_DISTANCE_ATTENUATION (three numbers a, b, c: the size is divided by the root of a + b d + c d^2),
        GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE (pixels)
    params: the values: a sequence of numbers, or one number where one is enough
    Numbers, or a sequence of them, of any type; glPointParameterf and so on take one."""

def glPointParameterf(pname: int, param: float) -> None:
    """Sets how points shrink with their distance from the eye.

    pname: GL_POINT_DISTANCE_ATTENUATION (three numbers a, b, c: the size is divided by the root of a + b d + c d^2),
        GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE (pixels)
    param: the value: one number or one constant"""

def glPointParameterfv(pname: int, params: Numbers) -> None:
    """Sets how points shrink with their distance from the eye.

    pname: GL_POINT_DISTANCE_ATTENUATION (three numbers a, b, c: the size is divided by the root of a + b d + c d^2),
        GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE (pixels)
    params: the values: a sequence of numbers, or one number where one is enough"""

def glPointParameteri(pname: int, param: int) -> None:
    """Sets how points shrink with their distance from the eye.

    pname: GL_POINT_DISTANCE_ATTENUATION (three numbers a, b, c: the size is divided by the root of a + b d + c d^2),
        GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE (pixels)
    param: the value: one number or one constant
    Whole numbers."""

def glPointParameteriv(pname: int, params: Numbers) -> None:
    """Sets how points shrink with their distance from the eye.

    pname: GL_POINT_DISTANCE_ATTENUATION (three numbers a, b, c: the size is divided by the root of a + b d + c d^2),
        GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE (pixels)
    params: the values: a sequence of numbers, or one number where one is enough
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glPointSize(size: float) -> None:
    """Sets the diameter of points.

    size: in pixels, more than 0; initially 1"""

def glPolygonMode(face: int, mode: int) -> None:
    """Says how polygons are drawn.

    face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK
    mode: GL_FILL (the initial value), GL_LINE (their edges) or GL_POINT (their corners)"""

def glPolygonOffset(factor: float, units: float) -> None:
    """Shifts the depth of polygons, so that lines drawn on them stay visible, once glEnable(GL_POLYGON_OFFSET_FILL) is called.

    factor: times the slope of the polygon's depth
    units: times the smallest difference of the depth buffer; positive is away from the viewer"""

def glPolygonStipple(mask: Numbers) -> None:
    """Sets the pattern of 32 x 32 pixels through which polygons are drawn, once glEnable(GL_POLYGON_STIPPLE) is called.

    mask: 128 bytes, rows from the bottom, or a 32 x 32 array of ones and zeros"""

def glPopAttrib() -> None:
    """Brings back the state that the last glPushAttrib put on the stack."""

def glPopClientAttrib() -> None:
    """Brings back the state that the last glPushClientAttrib put on the stack."""

def glPopMatrix() -> None:
    """Brings back the matrix that the last glPushMatrix put on the stack."""

def glPopName() -> None:
    """Takes the last name from the stack of names that selection uses."""

def glPrioritizeTextures(n: int, textures: Numbers, priorities: Numbers) -> None:
    """Says which textures matter most.  Accepted without effect: all are in fast memory.

    n: how many names
    textures: a name or a sequence of names
    priorities: numbers from 0 to 1, one for each"""

def glPushAttrib(mask: int) -> None:
    """Puts a group of state on a stack; glPopAttrib brings it back.

    mask: one or several, joined with |: GL_CURRENT_BIT, GL_ENABLE_BIT, GL_LIGHTING_BIT, GL_POLYGON_BIT, GL_TEXTURE_BIT,
        GL_ALL_ATTRIB_BITS, ..."""

def glPushClientAttrib(mask: int) -> None:
    """Puts the state of vertex arrays or of glPixelStore on a stack; glPopClientAttrib brings it back.

    mask: GL_CLIENT_VERTEX_ARRAY_BIT, GL_CLIENT_PIXEL_STORE_BIT or GL_CLIENT_ALL_ATTRIB_BITS"""

def glPushMatrix() -> None:
    """Puts a copy of the current matrix on its stack; glPopMatrix brings it back."""

def glPushName(name: int) -> None:
    """Puts a name on the stack of names: what is drawn from now on has it, for selection.

    name: a whole number, 0 or more"""

def glRasterPos(*arguments: Any) -> Any:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given
    Numbers, or a sequence of them, of any type; glRasterPos2s and so on take one."""

def glRasterPos2d(x: float, y: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up"""

def glRasterPos2dv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos2f(x: float, y: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up"""

def glRasterPos2fv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos2i(x: int, y: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    Whole numbers."""

def glRasterPos2iv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos2s(x: int, y: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    Whole numbers."""

def glRasterPos2sv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos3d(x: float, y: float, z: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given"""

def glRasterPos3dv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos3f(x: float, y: float, z: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given"""

def glRasterPos3fv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos3i(x: int, y: int, z: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given
    Whole numbers."""

def glRasterPos3iv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos3s(x: int, y: int, z: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given
    Whole numbers."""

def glRasterPos3sv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos4d(x: float, y: float, z: float, w: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given"""

def glRasterPos4dv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos4f(x: float, y: float, z: float, w: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given"""

def glRasterPos4fv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos4i(x: int, y: int, z: int, w: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given
    Whole numbers."""

def glRasterPos4iv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glRasterPos4s(x: int, y: int, z: int, w: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given
    Whole numbers."""

def glRasterPos4sv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw.  The position is transformed and lit like a vertex; where a point there
    would be clipped, nothing is drawn.

    v: a sequence of as many numbers as the digit of the name says"""

def glReadBuffer(src: int) -> None:
    """Says which colour buffer is read.

    src: GL_BACK, GL_FRONT or GL_LEFT: one picture here"""

def glReadPixels(x: Any, y: Any, width: Any, height: Any, format: int, type: int, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    x: left edge in pixels
    y: lower edge in pixels, counted from the bottom
    width: in pixels
    height: in pixels
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    array: an array to fill, instead of a new one
    outputType: bytes (the default) or an array type, for what is returned for GL_UNSIGNED_BYTE"""

def glReadPixelsb(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    glReadPixelsb(x, y, width, height, format) returns GL_BYTE numbers."""

def glReadPixelsd(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    glReadPixelsd(x, y, width, height, format) returns GL_DOUBLE numbers."""

def glReadPixelsf(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    glReadPixelsf(x, y, width, height, format) returns GL_FLOAT numbers."""

def glReadPixelsi(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    glReadPixelsi(x, y, width, height, format) returns GL_INT numbers."""

def glReadPixelss(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    glReadPixelss(x, y, width, height, format) returns GL_SHORT numbers."""

def glReadPixelsub(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    glReadPixelsub(x, y, width, height, format) returns GL_UNSIGNED_BYTE numbers."""

def glReadPixelsui(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    glReadPixelsui(x, y, width, height, format) returns GL_UNSIGNED_INT numbers."""

def glReadPixelsus(*arguments: Any, array: Any = ..., outputType: Any = ...) -> Any:
    """Returns pixels of the picture, the bottom row first: bytes for GL_UNSIGNED_BYTE, else an array.

    glReadPixelsus(x, y, width, height, format) returns GL_UNSIGNED_SHORT numbers."""

def glRect(*arguments: Any) -> Any:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    x1: x of one corner
    y1: y of that corner
    x2: x of the opposite corner
    y2: y of that corner
    v1: x and y of one corner
    v2: x and y of the opposite corner
    Numbers, or a sequence of them, of any type; glRects and so on take one."""

def glRectd(x1: float, y1: float, x2: float, y2: float) -> None:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    x1: x of one corner
    y1: y of that corner
    x2: x of the opposite corner
    y2: y of that corner"""

def glRectdv(v1: Numbers, v2: Numbers) -> None:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    v1: x and y of one corner
    v2: x and y of the opposite corner"""

def glRectf(x1: float, y1: float, x2: float, y2: float) -> None:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    x1: x of one corner
    y1: y of that corner
    x2: x of the opposite corner
    y2: y of that corner"""

def glRectfv(v1: Numbers, v2: Numbers) -> None:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    v1: x and y of one corner
    v2: x and y of the opposite corner"""

def glRecti(x1: int, y1: int, x2: int, y2: int) -> None:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    x1: x of one corner
    y1: y of that corner
    x2: x of the opposite corner
    y2: y of that corner
    Whole numbers."""

def glRectiv(v1: Numbers, v2: Numbers) -> None:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    v1: x and y of one corner
    v2: x and y of the opposite corner"""

def glRects(x1: int, y1: int, x2: int, y2: int) -> None:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    x1: x of one corner
    y1: y of that corner
    x2: x of the opposite corner
    y2: y of that corner
    Whole numbers."""

def glRectsv(v1: Numbers, v2: Numbers) -> None:
    """Draws a rectangle in the plane z = 0, with its sides along the axes.

    v1: x and y of one corner
    v2: x and y of the opposite corner"""

def glRenderMode(mode: int) -> Any:
    """Says what drawing does; returns what the mode before found: a list of hits or of feedback, or 0.

    mode: GL_RENDER (draws), GL_SELECT (finds what lies in the view volume) or GL_FEEDBACK (returns the transformed primitives)"""

def glRotate(*arguments: Any) -> Any:
    """Turns what is drawn from now on around an axis through the origin, counter-clockwise when the axis points at you.

    angle: in degrees, not radians
    x: x component of the axis
    y: y component of the axis
    z: z component of the axis; the axis need not have length 1, but not length 0
    Numbers, or a sequence of them, of any type; glRotatef and so on take one."""

def glRotated(angle: float, x: float, y: float, z: float) -> None:
    """Turns what is drawn from now on around an axis through the origin, counter-clockwise when the axis points at you.

    angle: in degrees, not radians
    x: x component of the axis
    y: y component of the axis
    z: z component of the axis; the axis need not have length 1, but not length 0"""

def glRotatef(angle: float, x: float, y: float, z: float) -> None:
    """Turns what is drawn from now on around an axis through the origin, counter-clockwise when the axis points at you.

    angle: in degrees, not radians
    x: x component of the axis
    y: y component of the axis
    z: z component of the axis; the axis need not have length 1, but not length 0"""

def glSampleCoverage(value: float, invert: int) -> None:
    """Sets how many samples of a pixel are drawn, once glEnable(GL_SAMPLE_COVERAGE) is called.

    value: share of the samples, 0 to 1
    invert: True for the other samples"""

def glScale(*arguments: Any) -> Any:
    """Stretches what is drawn from now on, about the origin.  It stretches normals too: enable GL_NORMALIZE with lighting.

    x: factor along x; 1 changes nothing, -1 mirrors
    y: factor along y
    z: factor along z
    Numbers, or a sequence of them, of any type; glScalef and so on take one."""

def glScaled(x: float, y: float, z: float) -> None:
    """Stretches what is drawn from now on, about the origin.  It stretches normals too: enable GL_NORMALIZE with lighting.

    x: factor along x; 1 changes nothing, -1 mirrors
    y: factor along y
    z: factor along z"""

def glScalef(x: float, y: float, z: float) -> None:
    """Stretches what is drawn from now on, about the origin.  It stretches normals too: enable GL_NORMALIZE with lighting.

    x: factor along x; 1 changes nothing, -1 mirrors
    y: factor along y
    z: factor along z"""

def glScissor(x: int, y: int, width: int, height: int) -> None:
    """Sets the rectangle outside of which nothing is drawn, once glEnable(GL_SCISSOR_TEST) is called.

    x: left edge in pixels
    y: lower edge in pixels, counted from the bottom
    width: in pixels
    height: in pixels"""

def glSecondaryColor(*arguments: Any) -> Any:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Numbers, or a sequence of them, of any type; glSecondaryColor3b and so on take one.
    Also between glBegin and glEnd."""

def glSecondaryColor3b(red: int, green: int, blue: int) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: -128 to 127 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3bv(v: Numbers) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -128 to 127 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3d(red: float, green: float, blue: float) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Also between glBegin and glEnd."""

def glSecondaryColor3dv(v: Numbers) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glSecondaryColor3f(red: float, green: float, blue: float) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Also between glBegin and glEnd."""

def glSecondaryColor3fv(v: Numbers) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glSecondaryColor3i(red: int, green: int, blue: int) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3iv(v: Numbers) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -2147483648 to 2147483647 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3s(red: int, green: int, blue: int) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: -32768 to 32767 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3sv(v: Numbers) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: -32768 to 32767 stand for -1 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3ub(red: int, green: int, blue: int) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: 0 to 255 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3ubv(v: Numbers) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 255 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3ui(red: int, green: int, blue: int) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: 0 to 4294967295 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3uiv(v: Numbers) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 4294967295 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3us(red: int, green: int, blue: int) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    red: from 0 to 1
    green: from 0 to 1
    blue: from 0 to 1
    Whole numbers: 0 to 65535 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColor3usv(v: Numbers) -> None:
    """Sets the current secondary colour, which is added after texturing when GL_COLOR_SUM is enabled and lighting is not.

    v: a sequence of as many numbers as the digit of the name says
    Whole numbers: 0 to 65535 stand for 0 to 1.
    Also between glBegin and glEnd."""

def glSecondaryColorPointer(size: int, type: int, stride: int, pointer: Numbers) -> None:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    size: numbers of a colour: 3
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glSecondaryColorPointerb(array: Any) -> Any:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    glSecondaryColorPointerb(array), an array of GL_BYTE numbers; size and stride follow from it."""

def glSecondaryColorPointerd(array: Any) -> Any:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    glSecondaryColorPointerd(array), an array of GL_DOUBLE numbers; size and stride follow from it."""

def glSecondaryColorPointerf(array: Any) -> Any:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    glSecondaryColorPointerf(array), an array of GL_FLOAT numbers; size and stride follow from it."""

def glSecondaryColorPointeri(array: Any) -> Any:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    glSecondaryColorPointeri(array), an array of GL_INT numbers; size and stride follow from it."""

def glSecondaryColorPointers(array: Any) -> Any:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    glSecondaryColorPointers(array), an array of GL_SHORT numbers; size and stride follow from it."""

def glSecondaryColorPointerub(array: Any) -> Any:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    glSecondaryColorPointerub(array), an array of GL_UNSIGNED_BYTE numbers; size and stride follow from it."""

def glSecondaryColorPointerui(array: Any) -> Any:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    glSecondaryColorPointerui(array), an array of GL_UNSIGNED_INT numbers; size and stride follow from it."""

def glSecondaryColorPointerus(array: Any) -> Any:
    """Names the array of secondary colours, used once glEnableClientState(GL_SECONDARY_COLOR_ARRAY) is called.

    glSecondaryColorPointerus(array), an array of GL_UNSIGNED_SHORT numbers; size and stride follow from it."""

def glSelectBuffer(size: Any, buffer: Any = ...) -> Any:
    """Makes room for the hits of selection; returns that array.  Call it before glRenderMode(GL_SELECT).

    size: in whole numbers; a hit needs three and one for each name
    buffer: an array to use, instead of a new one"""

def glShadeModel(mode: int) -> None:
    """Says where the illumination equation is evaluated.

    mode: GL_FLAT: once for each primitive; GL_SMOOTH (the initial value): at each vertex, and the colours are interpolated
        (Gouraud); GL_PHONG_WIN: at each fragment, with interpolated normals (Phong)"""

def glStencilFunc(func: int, ref: int, mask: int) -> None:
    """Says which fragments pass the stencil test, once glEnable(GL_STENCIL_TEST) is called: func compares ref & mask with the
    stencil buffer's value & mask.

    func: GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL or GL_ALWAYS (the initial value)
    ref: the number compared with, 0 to 255
    mask: the bits that count"""

def glStencilMask(mask: int) -> None:
    """Says which bits of the stencil buffer are written.

    mask: the bits"""

def glStencilOp(sfail: int, dpfail: int, dppass: int) -> None:
    """Says what happens to the stencil buffer's value: GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP or
    GL_DECR_WRAP.

    sfail: where the stencil test fails
    dpfail: where it passes and the depth test fails
    dppass: where both pass"""

def glTexCoord(*arguments: Any) -> Any:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Numbers, or a sequence of them, of any type; glTexCoord1s and so on take one.
    Also between glBegin and glEnd."""

def glTexCoord1d(s: float) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    Also between glBegin and glEnd."""

def glTexCoord1dv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord1f(s: float) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    Also between glBegin and glEnd."""

def glTexCoord1fv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord1i(s: int) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    Whole numbers.
    Also between glBegin and glEnd."""

def glTexCoord1iv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord1s(s: int) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    Whole numbers.
    Also between glBegin and glEnd."""

def glTexCoord1sv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord2d(s: float, t: float) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    Also between glBegin and glEnd."""

def glTexCoord2dv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord2f(s: float, t: float) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    Also between glBegin and glEnd."""

def glTexCoord2fv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord2i(s: int, t: int) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glTexCoord2iv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord2s(s: int, t: int) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glTexCoord2sv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord3d(s: float, t: float, r: float) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    Also between glBegin and glEnd."""

def glTexCoord3dv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord3f(s: float, t: float, r: float) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    Also between glBegin and glEnd."""

def glTexCoord3fv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord3i(s: int, t: int, r: int) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glTexCoord3iv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord3s(s: int, t: int, r: int) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glTexCoord3sv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord4d(s: float, t: float, r: float, q: float) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Also between glBegin and glEnd."""

def glTexCoord4dv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord4f(s: float, t: float, r: float, q: float) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Also between glBegin and glEnd."""

def glTexCoord4fv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord4i(s: int, t: int, r: int, q: int) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glTexCoord4iv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoord4s(s: int, t: int, r: int, q: int) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    s: along the picture's width, 0 left and 1 right
    t: along the picture's height, 0 bottom and 1 top; 0 where it is not given
    r: along the layers of a 3D texture; 0 where it is not given
    q: the divisor of homogeneous coordinates; 1 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glTexCoord4sv(v: Numbers) -> None:
    """Sets the current texture coordinates of texture unit 0, for the vertices that follow.  From 0 to 1 they run once over the
    picture.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glTexCoordPointer(size: int, type: int, stride: int, pointer: Numbers) -> None:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    size: numbers of one texture coordinate: 1 to 4
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glTexCoordPointerb(array: Any) -> Any:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    glTexCoordPointerb(array), an array of GL_BYTE numbers; size and stride follow from it."""

def glTexCoordPointerd(array: Any) -> Any:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    glTexCoordPointerd(array), an array of GL_DOUBLE numbers; size and stride follow from it."""

def glTexCoordPointerf(array: Any) -> Any:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    glTexCoordPointerf(array), an array of GL_FLOAT numbers; size and stride follow from it."""

def glTexCoordPointeri(array: Any) -> Any:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    glTexCoordPointeri(array), an array of GL_INT numbers; size and stride follow from it."""

def glTexCoordPointers(array: Any) -> Any:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    glTexCoordPointers(array), an array of GL_SHORT numbers; size and stride follow from it."""

def glTexCoordPointerub(array: Any) -> Any:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    glTexCoordPointerub(array), an array of GL_UNSIGNED_BYTE numbers; size and stride follow from it."""

def glTexCoordPointerui(array: Any) -> Any:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    glTexCoordPointerui(array), an array of GL_UNSIGNED_INT numbers; size and stride follow from it."""

def glTexCoordPointerus(array: Any) -> Any:
    """Names the array of texture coordinates of the unit that glClientActiveTexture chose, used once
    glEnableClientState(GL_TEXTURE_COORD_ARRAY) is called.

    glTexCoordPointerus(array), an array of GL_UNSIGNED_SHORT numbers; size and stride follow from it."""

def glTexEnv(*arguments: Any) -> Any:
    """Says how a texture's colour and the fragment's colour become one.

    target: GL_TEXTURE_ENV, or GL_TEXTURE_FILTER_CONTROL (with GL_TEXTURE_LOD_BIAS)
    pname: GL_TEXTURE_ENV_MODE (GL_MODULATE: multiply, the initial value; GL_REPLACE; GL_DECAL; GL_BLEND; GL_ADD; GL_COMBINE),
        GL_TEXTURE_ENV_COLOR, and for GL_COMBINE: GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SRC0_RGB, GL_OPERAND0_RGB, GL_RGB_SCALE, ...
    params: the values: a sequence of numbers, or one number where one is enough
    Numbers, or a sequence of them, of any type; glTexEnvf and so on take one."""

def glTexEnvf(target: int, pname: int, param: float) -> None:
    """Says how a texture's colour and the fragment's colour become one.

    target: GL_TEXTURE_ENV, or GL_TEXTURE_FILTER_CONTROL (with GL_TEXTURE_LOD_BIAS)
    pname: GL_TEXTURE_ENV_MODE (GL_MODULATE: multiply, the initial value; GL_REPLACE; GL_DECAL; GL_BLEND; GL_ADD; GL_COMBINE),
        GL_TEXTURE_ENV_COLOR, and for GL_COMBINE: GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SRC0_RGB, GL_OPERAND0_RGB, GL_RGB_SCALE, ...
    param: the value: one number or one constant"""

def glTexEnvfv(target: int, pname: int, params: Numbers) -> None:
    """Says how a texture's colour and the fragment's colour become one.

    target: GL_TEXTURE_ENV, or GL_TEXTURE_FILTER_CONTROL (with GL_TEXTURE_LOD_BIAS)
    pname: GL_TEXTURE_ENV_MODE (GL_MODULATE: multiply, the initial value; GL_REPLACE; GL_DECAL; GL_BLEND; GL_ADD; GL_COMBINE),
        GL_TEXTURE_ENV_COLOR, and for GL_COMBINE: GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SRC0_RGB, GL_OPERAND0_RGB, GL_RGB_SCALE, ...
    params: the values: a sequence of numbers, or one number where one is enough"""

def glTexEnvi(target: int, pname: int, param: int) -> None:
    """Says how a texture's colour and the fragment's colour become one.

    target: GL_TEXTURE_ENV, or GL_TEXTURE_FILTER_CONTROL (with GL_TEXTURE_LOD_BIAS)
    pname: GL_TEXTURE_ENV_MODE (GL_MODULATE: multiply, the initial value; GL_REPLACE; GL_DECAL; GL_BLEND; GL_ADD; GL_COMBINE),
        GL_TEXTURE_ENV_COLOR, and for GL_COMBINE: GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SRC0_RGB, GL_OPERAND0_RGB, GL_RGB_SCALE, ...
    param: the value: one number or one constant
    Whole numbers."""

def glTexEnviv(target: int, pname: int, params: Numbers) -> None:
    """Says how a texture's colour and the fragment's colour become one.

    target: GL_TEXTURE_ENV, or GL_TEXTURE_FILTER_CONTROL (with GL_TEXTURE_LOD_BIAS)
    pname: GL_TEXTURE_ENV_MODE (GL_MODULATE: multiply, the initial value; GL_REPLACE; GL_DECAL; GL_BLEND; GL_ADD; GL_COMBINE),
        GL_TEXTURE_ENV_COLOR, and for GL_COMBINE: GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SRC0_RGB, GL_OPERAND0_RGB, GL_RGB_SCALE, ...
    params: the values: a sequence of numbers, or one number where one is enough
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glTexGen(*arguments: Any) -> Any:
    """Says how texture coordinates are made from the vertices, once glEnable(GL_TEXTURE_GEN_S) and so on are called.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE (GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP), GL_OBJECT_PLANE
        or GL_EYE_PLANE (four numbers)
    params: the values: a sequence of numbers, or one number where one is enough
    Numbers, or a sequence of them, of any type; glTexGeni and so on take one."""

def glTexGend(coord: int, pname: int, param: float) -> None:
    """Says how texture coordinates are made from the vertices, once glEnable(GL_TEXTURE_GEN_S) and so on are called.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE (GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP), GL_OBJECT_PLANE
        or GL_EYE_PLANE (four numbers)
    param: the value: one number or one constant"""

def glTexGendv(coord: int, pname: int, params: Numbers) -> None:
    """Says how texture coordinates are made from the vertices, once glEnable(GL_TEXTURE_GEN_S) and so on are called.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE (GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP), GL_OBJECT_PLANE
        or GL_EYE_PLANE (four numbers)
    params: the values: a sequence of numbers, or one number where one is enough"""

def glTexGenf(coord: int, pname: int, param: float) -> None:
    """Says how texture coordinates are made from the vertices, once glEnable(GL_TEXTURE_GEN_S) and so on are called.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE (GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP), GL_OBJECT_PLANE
        or GL_EYE_PLANE (four numbers)
    param: the value: one number or one constant"""

def glTexGenfv(coord: int, pname: int, params: Numbers) -> None:
    """Says how texture coordinates are made from the vertices, once glEnable(GL_TEXTURE_GEN_S) and so on are called.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE (GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP), GL_OBJECT_PLANE
        or GL_EYE_PLANE (four numbers)
    params: the values: a sequence of numbers, or one number where one is enough"""

def glTexGeni(coord: int, pname: int, param: int) -> None:
    """Says how texture coordinates are made from the vertices, once glEnable(GL_TEXTURE_GEN_S) and so on are called.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE (GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP), GL_OBJECT_PLANE
        or GL_EYE_PLANE (four numbers)
    param: the value: one number or one constant
    Whole numbers."""

def glTexGeniv(coord: int, pname: int, params: Numbers) -> None:
    """Says how texture coordinates are made from the vertices, once glEnable(GL_TEXTURE_GEN_S) and so on are called.

    coord: GL_S, GL_T, GL_R or GL_Q
    pname: GL_TEXTURE_GEN_MODE (GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP), GL_OBJECT_PLANE
        or GL_EYE_PLANE (four numbers)
    params: the values: a sequence of numbers, or one number where one is enough
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glTexImage1D(target: int, level: int, internalformat: int, width: int, border: int, format: int, type: int, pixels: Numbers) -> None:
    """Gives the bound 1D texture a picture.

    target: GL_TEXTURE_1D or GL_PROXY_TEXTURE_1D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    internalformat: what a texel keeps: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, ..., or the
        number of components from 1 to 4
    width: in texels
    border: 0, or 1 for a border of one texel around the picture
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    pixels: rows of pixels, the bottom row first: an array, bytes, or None; glPixelStorei says how they lie"""

def glTexImage1Db(*arguments: Any) -> Any:
    """Gives the bound 1D texture a picture.

    glTexImage1Db(target, level, internalformat, border, format, pixels), an array of GL_BYTE numbers;
    the size is the array's, width first."""

def glTexImage1Dd(*arguments: Any) -> Any:
    """Gives the bound 1D texture a picture.

    glTexImage1Dd(target, level, internalformat, border, format, pixels), an array of GL_DOUBLE numbers;
    the size is the array's, width first."""

def glTexImage1Df(*arguments: Any) -> Any:
    """Gives the bound 1D texture a picture.

    glTexImage1Df(target, level, internalformat, border, format, pixels), an array of GL_FLOAT numbers;
    the size is the array's, width first."""

def glTexImage1Di(*arguments: Any) -> Any:
    """Gives the bound 1D texture a picture.

    glTexImage1Di(target, level, internalformat, border, format, pixels), an array of GL_INT numbers;
    the size is the array's, width first."""

def glTexImage1Ds(*arguments: Any) -> Any:
    """Gives the bound 1D texture a picture.

    glTexImage1Ds(target, level, internalformat, border, format, pixels), an array of GL_SHORT numbers;
    the size is the array's, width first."""

def glTexImage1Dub(*arguments: Any) -> Any:
    """Gives the bound 1D texture a picture.

    glTexImage1Dub(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_BYTE numbers;
    the size is the array's, width first."""

def glTexImage1Dui(*arguments: Any) -> Any:
    """Gives the bound 1D texture a picture.

    glTexImage1Dui(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_INT numbers;
    the size is the array's, width first."""

def glTexImage1Dus(*arguments: Any) -> Any:
    """Gives the bound 1D texture a picture.

    glTexImage1Dus(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_SHORT numbers;
    the size is the array's, width first."""

def glTexImage2D(target: int, level: int, internalformat: int, width: int, height: int, border: int, format: int, type: int, pixels: Numbers) -> None:
    """Gives the bound texture a picture.

    target: GL_TEXTURE_2D, a face such as GL_TEXTURE_CUBE_MAP_POSITIVE_X, or a GL_PROXY_...
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    internalformat: what a texel keeps: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, ..., or the
        number of components from 1 to 4
    width: in texels
    height: in texels
    border: 0, or 1 for a border of one texel around the picture
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    pixels: rows of pixels, the bottom row first: an array, bytes, or None; glPixelStorei says how they lie"""

def glTexImage2Db(*arguments: Any) -> Any:
    """Gives the bound texture a picture.

    glTexImage2Db(target, level, internalformat, border, format, pixels), an array of GL_BYTE numbers;
    the size is the array's, width first."""

def glTexImage2Dd(*arguments: Any) -> Any:
    """Gives the bound texture a picture.

    glTexImage2Dd(target, level, internalformat, border, format, pixels), an array of GL_DOUBLE numbers;
    the size is the array's, width first."""

def glTexImage2Df(*arguments: Any) -> Any:
    """Gives the bound texture a picture.

    glTexImage2Df(target, level, internalformat, border, format, pixels), an array of GL_FLOAT numbers;
    the size is the array's, width first."""

def glTexImage2Di(*arguments: Any) -> Any:
    """Gives the bound texture a picture.

    glTexImage2Di(target, level, internalformat, border, format, pixels), an array of GL_INT numbers;
    the size is the array's, width first."""

def glTexImage2Ds(*arguments: Any) -> Any:
    """Gives the bound texture a picture.

    glTexImage2Ds(target, level, internalformat, border, format, pixels), an array of GL_SHORT numbers;
    the size is the array's, width first."""

def glTexImage2Dub(*arguments: Any) -> Any:
    """Gives the bound texture a picture.

    glTexImage2Dub(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_BYTE numbers;
    the size is the array's, width first."""

def glTexImage2Dui(*arguments: Any) -> Any:
    """Gives the bound texture a picture.

    glTexImage2Dui(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_INT numbers;
    the size is the array's, width first."""

def glTexImage2Dus(*arguments: Any) -> Any:
    """Gives the bound texture a picture.

    glTexImage2Dus(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_SHORT numbers;
    the size is the array's, width first."""

def glTexImage3D(target: int, level: int, internalformat: int, width: int, height: int, depth: int, border: int, format: int, type: int, pixels: Numbers) -> None:
    """Gives the bound 3D texture its layers of pictures.

    target: GL_TEXTURE_3D or GL_PROXY_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    internalformat: what a texel keeps: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, ..., or the
        number of components from 1 to 4
    width: in texels
    height: in texels
    depth: number of layers
    border: 0, or 1 for a border of one texel around the picture
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    pixels: rows of pixels, the bottom row first: an array, bytes, or None; glPixelStorei says how they lie"""

def glTexImage3Db(*arguments: Any) -> Any:
    """Gives the bound 3D texture its layers of pictures.

    glTexImage3Db(target, level, internalformat, border, format, pixels), an array of GL_BYTE numbers;
    the size is the array's, width first."""

def glTexImage3Dd(*arguments: Any) -> Any:
    """Gives the bound 3D texture its layers of pictures.

    glTexImage3Dd(target, level, internalformat, border, format, pixels), an array of GL_DOUBLE numbers;
    the size is the array's, width first."""

def glTexImage3Df(*arguments: Any) -> Any:
    """Gives the bound 3D texture its layers of pictures.

    glTexImage3Df(target, level, internalformat, border, format, pixels), an array of GL_FLOAT numbers;
    the size is the array's, width first."""

def glTexImage3Di(*arguments: Any) -> Any:
    """Gives the bound 3D texture its layers of pictures.

    glTexImage3Di(target, level, internalformat, border, format, pixels), an array of GL_INT numbers;
    the size is the array's, width first."""

def glTexImage3Ds(*arguments: Any) -> Any:
    """Gives the bound 3D texture its layers of pictures.

    glTexImage3Ds(target, level, internalformat, border, format, pixels), an array of GL_SHORT numbers;
    the size is the array's, width first."""

def glTexImage3Dub(*arguments: Any) -> Any:
    """Gives the bound 3D texture its layers of pictures.

    glTexImage3Dub(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_BYTE numbers;
    the size is the array's, width first."""

def glTexImage3Dui(*arguments: Any) -> Any:
    """Gives the bound 3D texture its layers of pictures.

    glTexImage3Dui(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_INT numbers;
    the size is the array's, width first."""

def glTexImage3Dus(*arguments: Any) -> Any:
    """Gives the bound 3D texture its layers of pictures.

    glTexImage3Dus(target, level, internalformat, border, format, pixels), an array of GL_UNSIGNED_SHORT numbers;
    the size is the array's, width first."""

def glTexParameter(*arguments: Any) -> Any:
    """Sets how the bound texture is read.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or GL_TEXTURE_CUBE_MAP
    pname: GL_TEXTURE_MIN_FILTER (GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, ...; the initial value needs mipmaps),
        GL_TEXTURE_MAG_FILTER (GL_NEAREST, GL_LINEAR), GL_TEXTURE_WRAP_S, _T, _R (GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
        GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT), GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD,
        GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_LOD_BIAS, GL_GENERATE_MIPMAP, GL_TEXTURE_COMPARE_MODE,
        GL_TEXTURE_COMPARE_FUNC, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_PRIORITY
    params: the values: a sequence of numbers, or one number where one is enough
    Numbers, or a sequence of them, of any type; glTexParameterf and so on take one."""

def glTexParameterf(target: int, pname: int, param: float) -> None:
    """Sets how the bound texture is read.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or GL_TEXTURE_CUBE_MAP
    pname: GL_TEXTURE_MIN_FILTER (GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, ...; the initial value needs mipmaps),
        GL_TEXTURE_MAG_FILTER (GL_NEAREST, GL_LINEAR), GL_TEXTURE_WRAP_S, _T, _R (GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
        GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT), GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD,
        GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_LOD_BIAS, GL_GENERATE_MIPMAP, GL_TEXTURE_COMPARE_MODE,
        GL_TEXTURE_COMPARE_FUNC, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_PRIORITY
    param: the value: one number or one constant"""

def glTexParameterfv(target: int, pname: int, params: Numbers) -> None:
    """Sets how the bound texture is read.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or GL_TEXTURE_CUBE_MAP
    pname: GL_TEXTURE_MIN_FILTER (GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, ...; the initial value needs mipmaps),
        GL_TEXTURE_MAG_FILTER (GL_NEAREST, GL_LINEAR), GL_TEXTURE_WRAP_S, _T, _R (GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
        GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT), GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD,
        GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_LOD_BIAS, GL_GENERATE_MIPMAP, GL_TEXTURE_COMPARE_MODE,
        GL_TEXTURE_COMPARE_FUNC, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_PRIORITY
    params: the values: a sequence of numbers, or one number where one is enough"""

def glTexParameteri(target: int, pname: int, param: int) -> None:
    """Sets how the bound texture is read.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or GL_TEXTURE_CUBE_MAP
    pname: GL_TEXTURE_MIN_FILTER (GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, ...; the initial value needs mipmaps),
        GL_TEXTURE_MAG_FILTER (GL_NEAREST, GL_LINEAR), GL_TEXTURE_WRAP_S, _T, _R (GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
        GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT), GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD,
        GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_LOD_BIAS, GL_GENERATE_MIPMAP, GL_TEXTURE_COMPARE_MODE,
        GL_TEXTURE_COMPARE_FUNC, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_PRIORITY
    param: the value: one number or one constant
    Whole numbers."""

def glTexParameteriv(target: int, pname: int, params: Numbers) -> None:
    """Sets how the bound texture is read.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D or GL_TEXTURE_CUBE_MAP
    pname: GL_TEXTURE_MIN_FILTER (GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, ...; the initial value needs mipmaps),
        GL_TEXTURE_MAG_FILTER (GL_NEAREST, GL_LINEAR), GL_TEXTURE_WRAP_S, _T, _R (GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
        GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT), GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD,
        GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_LOD_BIAS, GL_GENERATE_MIPMAP, GL_TEXTURE_COMPARE_MODE,
        GL_TEXTURE_COMPARE_FUNC, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_PRIORITY
    params: the values: a sequence of numbers, or one number where one is enough
    Whole numbers; in colours -2147483648 to 2147483647 stand for -1 to 1."""

def glTexSubImage1D(target: int, level: int, xoffset: int, width: int, format: int, type: int, pixels: Numbers) -> None:
    """Replaces a part of the bound texture's picture.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D (or a face of a cube map) or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    width: in texels
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    pixels: rows of pixels, the bottom row first: an array, bytes, or None; glPixelStorei says how they lie"""

def glTexSubImage1Db(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage1Db(target, level, xoffset, format, pixels), an array of GL_BYTE numbers; the size is the array's."""

def glTexSubImage1Dd(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage1Dd(target, level, xoffset, format, pixels), an array of GL_DOUBLE numbers; the size is the array's."""

def glTexSubImage1Df(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage1Df(target, level, xoffset, format, pixels), an array of GL_FLOAT numbers; the size is the array's."""

def glTexSubImage1Di(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage1Di(target, level, xoffset, format, pixels), an array of GL_INT numbers; the size is the array's."""

def glTexSubImage1Ds(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage1Ds(target, level, xoffset, format, pixels), an array of GL_SHORT numbers; the size is the array's."""

def glTexSubImage1Dub(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage1Dub(target, level, xoffset, format, pixels), an array of GL_UNSIGNED_BYTE numbers; the size is the array's."""

def glTexSubImage1Dui(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage1Dui(target, level, xoffset, format, pixels), an array of GL_UNSIGNED_INT numbers; the size is the array's."""

def glTexSubImage1Dus(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage1Dus(target, level, xoffset, format, pixels), an array of GL_UNSIGNED_SHORT numbers; the size is the array's."""

def glTexSubImage2D(target: int, level: int, xoffset: int, yoffset: int, width: int, height: int, format: int, type: int, pixels: Numbers) -> None:
    """Replaces a part of the bound texture's picture.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D (or a face of a cube map) or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    yoffset: row of the first texel to replace, from the bottom
    width: in texels
    height: in texels
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    pixels: rows of pixels, the bottom row first: an array, bytes, or None; glPixelStorei says how they lie"""

def glTexSubImage2Db(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage2Db(target, level, xoffset, yoffset, format, pixels), an array of GL_BYTE numbers;
    the size is the array's, width first."""

def glTexSubImage2Dd(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage2Dd(target, level, xoffset, yoffset, format, pixels), an array of GL_DOUBLE numbers;
    the size is the array's, width first."""

def glTexSubImage2Df(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage2Df(target, level, xoffset, yoffset, format, pixels), an array of GL_FLOAT numbers;
    the size is the array's, width first."""

def glTexSubImage2Di(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage2Di(target, level, xoffset, yoffset, format, pixels), an array of GL_INT numbers;
    the size is the array's, width first."""

def glTexSubImage2Ds(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage2Ds(target, level, xoffset, yoffset, format, pixels), an array of GL_SHORT numbers;
    the size is the array's, width first."""

def glTexSubImage2Dub(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage2Dub(target, level, xoffset, yoffset, format, pixels), an array of GL_UNSIGNED_BYTE numbers;
    the size is the array's, width first."""

def glTexSubImage2Dui(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage2Dui(target, level, xoffset, yoffset, format, pixels), an array of GL_UNSIGNED_INT numbers;
    the size is the array's, width first."""

def glTexSubImage2Dus(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage2Dus(target, level, xoffset, yoffset, format, pixels), an array of GL_UNSIGNED_SHORT numbers;
    the size is the array's, width first."""

def glTexSubImage3D(target: int, level: int, xoffset: int, yoffset: int, zoffset: int, width: int, height: int, depth: int, format: int, type: int, pixels: Numbers) -> None:
    """Replaces a part of the bound texture's picture.

    target: GL_TEXTURE_1D, GL_TEXTURE_2D (or a face of a cube map) or GL_TEXTURE_3D
    level: of the mipmap: 0 is the full picture, each further level has half its width and height
    xoffset: column of the first texel to replace
    yoffset: row of the first texel to replace, from the bottom
    zoffset: layer of the first texel to replace
    width: in texels
    height: in texels
    depth: number of layers
    format: what the numbers are: GL_RGB, GL_RGBA, GL_LUMINANCE, GL_RED, GL_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_BGRA, ...
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    pixels: rows of pixels, the bottom row first: an array, bytes, or None; glPixelStorei says how they lie"""

def glTexSubImage3Db(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage3Db(target, level, xoffset, yoffset, zoffset, format, pixels), an array of GL_BYTE numbers;
    the size is the array's, width first."""

def glTexSubImage3Dd(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage3Dd(target, level, xoffset, yoffset, zoffset, format, pixels), an array of GL_DOUBLE numbers;
    the size is the array's, width first."""

def glTexSubImage3Df(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage3Df(target, level, xoffset, yoffset, zoffset, format, pixels), an array of GL_FLOAT numbers;
    the size is the array's, width first."""

def glTexSubImage3Di(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage3Di(target, level, xoffset, yoffset, zoffset, format, pixels), an array of GL_INT numbers;
    the size is the array's, width first."""

def glTexSubImage3Ds(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage3Ds(target, level, xoffset, yoffset, zoffset, format, pixels), an array of GL_SHORT numbers;
    the size is the array's, width first."""

def glTexSubImage3Dub(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage3Dub(target, level, xoffset, yoffset, zoffset, format, pixels), an array of GL_UNSIGNED_BYTE numbers;
    the size is the array's, width first."""

def glTexSubImage3Dui(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage3Dui(target, level, xoffset, yoffset, zoffset, format, pixels), an array of GL_UNSIGNED_INT numbers;
    the size is the array's, width first."""

def glTexSubImage3Dus(*arguments: Any) -> Any:
    """Replaces a part of the bound texture's picture.

    glTexSubImage3Dus(target, level, xoffset, yoffset, zoffset, format, pixels), an array of GL_UNSIGNED_SHORT numbers;
    the size is the array's, width first."""

def glTranslate(*arguments: Any) -> Any:
    """Moves what is drawn from now on.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer
    Numbers, or a sequence of them, of any type; glTranslatef and so on take one."""

def glTranslated(x: float, y: float, z: float) -> None:
    """Moves what is drawn from now on.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer"""

def glTranslatef(x: float, y: float, z: float) -> None:
    """Moves what is drawn from now on.

    x: to the right, in the units of your scene
    y: up
    z: towards the viewer"""

def glUnmapBuffer(target: int) -> Any:
    """Ends what glMapBuffer began; returns True when the contents are whole.

    target: GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER"""

def glVertex(*arguments: Any) -> Any:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given
    Numbers, or a sequence of them, of any type; glVertex2s and so on take one.
    Also between glBegin and glEnd."""

def glVertex2d(x: float, y: float) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    Also between glBegin and glEnd."""

def glVertex2dv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex2f(x: float, y: float) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    Also between glBegin and glEnd."""

def glVertex2fv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex2i(x: int, y: int) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    Whole numbers.
    Also between glBegin and glEnd."""

def glVertex2iv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex2s(x: int, y: int) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    Whole numbers.
    Also between glBegin and glEnd."""

def glVertex2sv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex3d(x: float, y: float, z: float) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    Also between glBegin and glEnd."""

def glVertex3dv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex3f(x: float, y: float, z: float) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    Also between glBegin and glEnd."""

def glVertex3fv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex3i(x: int, y: int, z: int) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glVertex3iv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex3s(x: int, y: int, z: int) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glVertex3sv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex4d(x: float, y: float, z: float, w: float) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given
    Also between glBegin and glEnd."""

def glVertex4dv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex4f(x: float, y: float, z: float, w: float) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given
    Also between glBegin and glEnd."""

def glVertex4fv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex4i(x: int, y: int, z: int, w: int) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glVertex4iv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertex4s(x: int, y: int, z: int, w: int) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    x: to the right, in the units of your scene
    y: up, in the units of your scene
    z: towards the viewer, in the units of your scene; 0 where it is not given
    w: the divisor of homogeneous coordinates; 1 where it is not given
    Whole numbers.
    Also between glBegin and glEnd."""

def glVertex4sv(v: Numbers) -> None:
    """Adds a corner to the primitive, with the current colour, normal, texture coordinates and material.  The modelview and the
    projection matrix take it to the screen.

    v: a sequence of as many numbers as the digit of the name says
    Also between glBegin and glEnd."""

def glVertexPointer(size: int, type: int, stride: int, pointer: Numbers) -> None:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    size: numbers of a position: 2, 3 or 4
    type: of one number: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT or GL_DOUBLE
    stride: bytes from one element to the next; 0 where they follow each other without a gap
    pointer: the array, or, while a buffer is bound to GL_ARRAY_BUFFER, the offset into that buffer in bytes"""

def glVertexPointerb(array: Any) -> Any:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    glVertexPointerb(array), an array of GL_BYTE numbers; size and stride follow from it."""

def glVertexPointerd(array: Any) -> Any:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    glVertexPointerd(array), an array of GL_DOUBLE numbers; size and stride follow from it."""

def glVertexPointerf(array: Any) -> Any:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    glVertexPointerf(array), an array of GL_FLOAT numbers; size and stride follow from it."""

def glVertexPointeri(array: Any) -> Any:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    glVertexPointeri(array), an array of GL_INT numbers; size and stride follow from it."""

def glVertexPointers(array: Any) -> Any:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    glVertexPointers(array), an array of GL_SHORT numbers; size and stride follow from it."""

def glVertexPointerub(array: Any) -> Any:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    glVertexPointerub(array), an array of GL_UNSIGNED_BYTE numbers; size and stride follow from it."""

def glVertexPointerui(array: Any) -> Any:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    glVertexPointerui(array), an array of GL_UNSIGNED_INT numbers; size and stride follow from it."""

def glVertexPointerus(array: Any) -> Any:
    """Names the array of positions that glDrawArrays, glDrawElements and glArrayElement use, once
    glEnableClientState(GL_VERTEX_ARRAY) is called.

    glVertexPointerus(array), an array of GL_UNSIGNED_SHORT numbers; size and stride follow from it."""

def glViewport(x: int, y: int, width: int, height: int) -> None:
    """Sets the rectangle of the window that the picture fills; usually called in the reshape callback.

    x: left edge in pixels
    y: lower edge in pixels, counted from the bottom
    width: in pixels
    height: in pixels"""

def glWindowPos(*arguments: Any) -> Any:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels
    z: depth from 0 (near) to 1 (far); 0 where it is not given
    Numbers, or a sequence of them, of any type; glWindowPos2s and so on take one."""

def glWindowPos2d(x: float, y: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels"""

def glWindowPos2dv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    v: a sequence of as many numbers as the digit of the name says"""

def glWindowPos2f(x: float, y: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels"""

def glWindowPos2fv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    v: a sequence of as many numbers as the digit of the name says"""

def glWindowPos2i(x: int, y: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels
    Whole numbers."""

def glWindowPos2iv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    v: a sequence of as many numbers as the digit of the name says"""

def glWindowPos2s(x: int, y: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels
    Whole numbers."""

def glWindowPos2sv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    v: a sequence of as many numbers as the digit of the name says"""

def glWindowPos3d(x: float, y: float, z: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels
    z: depth from 0 (near) to 1 (far); 0 where it is not given"""

def glWindowPos3dv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    v: a sequence of as many numbers as the digit of the name says"""

def glWindowPos3f(x: float, y: float, z: float) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels
    z: depth from 0 (near) to 1 (far); 0 where it is not given"""

def glWindowPos3fv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    v: a sequence of as many numbers as the digit of the name says"""

def glWindowPos3i(x: int, y: int, z: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels
    z: depth from 0 (near) to 1 (far); 0 where it is not given
    Whole numbers."""

def glWindowPos3iv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    v: a sequence of as many numbers as the digit of the name says"""

def glWindowPos3s(x: int, y: int, z: int) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    x: from the left edge, in pixels
    y: from the lower edge, in pixels
    z: depth from 0 (near) to 1 (far); 0 where it is not given
    Whole numbers."""

def glWindowPos3sv(v: Numbers) -> None:
    """Sets where glBitmap and glDrawPixels begin to draw, in pixels of the window.

    v: a sequence of as many numbers as the digit of the name says"""

