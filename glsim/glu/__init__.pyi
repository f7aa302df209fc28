"""What glu gives.  Written by ``python -m glsim.gl.generate``; do not edit."""

from collections.abc import Callable
from typing import Any
from glsim.glu.errors import GLUError as GLUError
from glsim.glu.quadric import Quadric as GLUQuadric
from glsim.glu.errors import GLUWarning as GLUWarning
from glsim.machine.constants import Enum
from glsim.glu.errors import GLUError as GLUerror
from glsim.glu.nurbsobject import Nurbs as GLUnurbs
from glsim.glu.nurbsobject import Nurbs as GLUnurbsObj
from glsim.glu.quadric import Quadric as GLUquadric
from glsim.glu.quadric import Quadric as GLUquadricObj
from glsim.glu.tess import Tessellator as GLUtesselator
from glsim.glu.tess import Tessellator as GLUtesselatorObj
from glsim.glu.tess import Tessellator as GLUtriangulatorObj
from glsim.glu.nurbs import gluBeginCurve as gluBeginCurve
from glsim.glu.tess import gluBeginPolygon as gluBeginPolygon
from glsim.glu.nurbs import gluBeginSurface as gluBeginSurface
from glsim.glu.nurbs import gluBeginTrim as gluBeginTrim
from glsim.glu.images import gluBuild1DMipmapLevels as gluBuild1DMipmapLevels
from glsim.glu.images import gluBuild1DMipmaps as gluBuild1DMipmaps
from glsim.glu.images import gluBuild2DMipmapLevels as gluBuild2DMipmapLevels
from glsim.glu.images import gluBuild2DMipmaps as gluBuild2DMipmaps
from glsim.glu.images import gluBuild3DMipmapLevels as gluBuild3DMipmapLevels
from glsim.glu.images import gluBuild3DMipmaps as gluBuild3DMipmaps
from glsim.glu.errors import gluCheckExtension as gluCheckExtension
from glsim.glu.cylinder import gluCylinder as gluCylinder
from glsim.glu.nurbs import gluDeleteNurbsRenderer as gluDeleteNurbsRenderer
from glsim.glu.quadric import gluDeleteQuadric as gluDeleteQuadric
from glsim.glu.tess import gluDeleteTess as gluDeleteTess
from glsim.glu.disc import gluDisk as gluDisk
from glsim.glu.nurbs import gluEndCurve as gluEndCurve
from glsim.glu.tess import gluEndPolygon as gluEndPolygon
from glsim.glu.nurbs import gluEndSurface as gluEndSurface
from glsim.glu.nurbs import gluEndTrim as gluEndTrim
from glsim.glu.errors import gluErrorString as gluErrorString
from glsim.glu.nurbs import gluGetNurbsProperty as gluGetNurbsProperty
from glsim.glu.errors import gluGetString as gluGetString
from glsim.glu.tess import gluGetTessProperty as gluGetTessProperty
from glsim.glu.nurbs import gluLoadSamplingMatrices as gluLoadSamplingMatrices
from glsim.glu.view import gluLookAt as gluLookAt
from glsim.glu.nurbs import gluNewNurbsRenderer as gluNewNurbsRenderer
from glsim.glu.quadric import gluNewQuadric as gluNewQuadric
from glsim.glu.tess import gluNewTess as gluNewTess
from glsim.glu.tess import gluNextContour as gluNextContour
from glsim.glu.nurbs import gluNurbsCallback as gluNurbsCallback
from glsim.glu.nurbs import gluNurbsCallbackData as gluNurbsCallbackData
from glsim.glu.nurbs import gluNurbsCallbackData as gluNurbsCallbackDataEXT
from glsim.glu.nurbs import gluNurbsCurve as gluNurbsCurve
from glsim.glu.nurbs import gluNurbsProperty as gluNurbsProperty
from glsim.glu.nurbs import gluNurbsSurface as gluNurbsSurface
from glsim.glu.view import gluOrtho2D as gluOrtho2D
from glsim.glu.disc import gluPartialDisk as gluPartialDisk
from glsim.glu.view import gluPerspective as gluPerspective
from glsim.glu.view import gluPickMatrix as gluPickMatrix
from glsim.glu.view import gluProject as gluProject
from glsim.glu.nurbs import gluPwlCurve as gluPwlCurve
from glsim.glu.quadric import gluQuadricCallback as gluQuadricCallback
from glsim.glu.quadric import gluQuadricDrawStyle as gluQuadricDrawStyle
from glsim.glu.quadric import gluQuadricNormals as gluQuadricNormals
from glsim.glu.quadric import gluQuadricOrientation as gluQuadricOrientation
from glsim.glu.quadric import gluQuadricTexture as gluQuadricTexture
from glsim.glu.images import gluScaleImage as gluScaleImage
from glsim.glu.sphere import gluSphere as gluSphere
from glsim.glu.tess import gluTessBeginContour as gluTessBeginContour
from glsim.glu.tess import gluTessBeginPolygon as gluTessBeginPolygon
from glsim.glu.tess import gluTessCallback as gluTessCallback
from glsim.glu.tess import gluTessEndContour as gluTessEndContour
from glsim.glu.tess import gluTessEndPolygon as gluTessEndPolygon
from glsim.glu.tess import gluTessNormal as gluTessNormal
from glsim.glu.tess import gluTessProperty as gluTessProperty
from glsim.glu.tess import gluTessVertex as gluTessVertex
from glsim.glu.view import gluUnProject as gluUnProject
from glsim.glu.view import gluUnProject4 as gluUnProject4

__all__ = [
    "GLUError",
    "GLUQuadric",
    "GLUWarning",
    "GLU_AUTO_LOAD_MATRIX",
    "GLU_BEGIN",
    "GLU_CCW",
    "GLU_CULLING",
    "GLU_CW",
    "GLU_DISPLAY_MODE",
    "GLU_DOMAIN_DISTANCE",
    "GLU_EDGE_FLAG",
    "GLU_END",
    "GLU_ERROR",
    "GLU_EXTENSIONS",
    "GLU_EXTERIOR",
    "GLU_FALSE",
    "GLU_FILL",
    "GLU_FLAT",
    "GLU_INCOMPATIBLE_GL_VERSION",
    "GLU_INSIDE",
    "GLU_INTERIOR",
    "GLU_INVALID_ENUM",
    "GLU_INVALID_OPERATION",
    "GLU_INVALID_VALUE",
    "GLU_LINE",
    "GLU_MAP1_TRIM_2",
    "GLU_MAP1_TRIM_3",
    "GLU_NONE",
    "GLU_NURBS_BEGIN",
    "GLU_NURBS_BEGIN_DATA",
    "GLU_NURBS_BEGIN_DATA_EXT",
    "GLU_NURBS_BEGIN_EXT",
    "GLU_NURBS_COLOR",
    "GLU_NURBS_COLOR_DATA",
    "GLU_NURBS_COLOR_DATA_EXT",
    "GLU_NURBS_COLOR_EXT",
    "GLU_NURBS_END",
    "GLU_NURBS_END_DATA",
    "GLU_NURBS_END_DATA_EXT",
    "GLU_NURBS_END_EXT",
    "GLU_NURBS_ERROR",
    "GLU_NURBS_ERROR1",
    "GLU_NURBS_ERROR10",
    "GLU_NURBS_ERROR11",
    "GLU_NURBS_ERROR12",
    "GLU_NURBS_ERROR13",
    "GLU_NURBS_ERROR14",
    "GLU_NURBS_ERROR15",
    "GLU_NURBS_ERROR16",
    "GLU_NURBS_ERROR17",
    "GLU_NURBS_ERROR18",
    "GLU_NURBS_ERROR19",
    "GLU_NURBS_ERROR2",
    "GLU_NURBS_ERROR20",
    "GLU_NURBS_ERROR21",
    "GLU_NURBS_ERROR22",
    "GLU_NURBS_ERROR23",
    "GLU_NURBS_ERROR24",
    "GLU_NURBS_ERROR25",
    "GLU_NURBS_ERROR26",
    "GLU_NURBS_ERROR27",
    "GLU_NURBS_ERROR28",
    "GLU_NURBS_ERROR29",
    "GLU_NURBS_ERROR3",
    "GLU_NURBS_ERROR30",
    "GLU_NURBS_ERROR31",
    "GLU_NURBS_ERROR32",
    "GLU_NURBS_ERROR33",
    "GLU_NURBS_ERROR34",
    "GLU_NURBS_ERROR35",
    "GLU_NURBS_ERROR36",
    "GLU_NURBS_ERROR37",
    "GLU_NURBS_ERROR4",
    "GLU_NURBS_ERROR5",
    "GLU_NURBS_ERROR6",
    "GLU_NURBS_ERROR7",
    "GLU_NURBS_ERROR8",
    "GLU_NURBS_ERROR9",
    "GLU_NURBS_MODE",
    "GLU_NURBS_MODE_EXT",
    "GLU_NURBS_NORMAL",
    "GLU_NURBS_NORMAL_DATA",
    "GLU_NURBS_NORMAL_DATA_EXT",
    "GLU_NURBS_NORMAL_EXT",
    "GLU_NURBS_RENDERER",
    "GLU_NURBS_RENDERER_EXT",
    "GLU_NURBS_TESSELLATOR",
    "GLU_NURBS_TESSELLATOR_EXT",
    "GLU_NURBS_TEXTURE_COORD",
    "GLU_NURBS_TEXTURE_COORD_DATA",
    "GLU_NURBS_TEX_COORD_DATA_EXT",
    "GLU_NURBS_TEX_COORD_EXT",
    "GLU_NURBS_VERTEX",
    "GLU_NURBS_VERTEX_DATA",
    "GLU_NURBS_VERTEX_DATA_EXT",
    "GLU_NURBS_VERTEX_EXT",
    "GLU_OBJECT_PARAMETRIC_ERROR",
    "GLU_OBJECT_PARAMETRIC_ERROR_EXT",
    "GLU_OBJECT_PATH_LENGTH",
    "GLU_OBJECT_PATH_LENGTH_EXT",
    "GLU_OUTLINE_PATCH",
    "GLU_OUTLINE_POLYGON",
    "GLU_OUTSIDE",
    "GLU_OUT_OF_MEMORY",
    "GLU_PARAMETRIC_ERROR",
    "GLU_PARAMETRIC_TOLERANCE",
    "GLU_PATH_LENGTH",
    "GLU_POINT",
    "GLU_SAMPLING_METHOD",
    "GLU_SAMPLING_TOLERANCE",
    "GLU_SILHOUETTE",
    "GLU_SMOOTH",
    "GLU_TESS_BEGIN",
    "GLU_TESS_BEGIN_DATA",
    "GLU_TESS_BOUNDARY_ONLY",
    "GLU_TESS_COMBINE",
    "GLU_TESS_COMBINE_DATA",
    "GLU_TESS_COORD_TOO_LARGE",
    "GLU_TESS_EDGE_FLAG",
    "GLU_TESS_EDGE_FLAG_DATA",
    "GLU_TESS_END",
    "GLU_TESS_END_DATA",
    "GLU_TESS_ERROR",
    "GLU_TESS_ERROR1",
    "GLU_TESS_ERROR2",
    "GLU_TESS_ERROR3",
    "GLU_TESS_ERROR4",
    "GLU_TESS_ERROR5",
    "GLU_TESS_ERROR6",
    "GLU_TESS_ERROR7",
    "GLU_TESS_ERROR8",
    "GLU_TESS_ERROR_DATA",
    "GLU_TESS_MAX_COORD",
    "GLU_TESS_MISSING_BEGIN_CONTOUR",
    "GLU_TESS_MISSING_BEGIN_POLYGON",
    "GLU_TESS_MISSING_END_CONTOUR",
    "GLU_TESS_MISSING_END_POLYGON",
    "GLU_TESS_NEED_COMBINE_CALLBACK",
    "GLU_TESS_TOLERANCE",
    "GLU_TESS_VERTEX",
    "GLU_TESS_VERTEX_DATA",
    "GLU_TESS_WINDING_ABS_GEQ_TWO",
    "GLU_TESS_WINDING_NEGATIVE",
    "GLU_TESS_WINDING_NONZERO",
    "GLU_TESS_WINDING_ODD",
    "GLU_TESS_WINDING_POSITIVE",
    "GLU_TESS_WINDING_RULE",
    "GLU_TRUE",
    "GLU_UNKNOWN",
    "GLU_U_STEP",
    "GLU_VERSION",
    "GLU_VERSION_1_1",
    "GLU_VERSION_1_2",
    "GLU_VERSION_1_3",
    "GLU_VERTEX",
    "GLU_V_STEP",
    "GLUerror",
    "GLUnurbs",
    "GLUnurbsObj",
    "GLUquadric",
    "GLUquadricObj",
    "GLUtesselator",
    "GLUtesselatorObj",
    "GLUtriangulatorObj",
    "gluBeginCurve",
    "gluBeginPolygon",
    "gluBeginSurface",
    "gluBeginTrim",
    "gluBuild1DMipmapLevels",
    "gluBuild1DMipmaps",
    "gluBuild2DMipmapLevels",
    "gluBuild2DMipmaps",
    "gluBuild3DMipmapLevels",
    "gluBuild3DMipmaps",
    "gluCheckExtension",
    "gluCylinder",
    "gluDeleteNurbsRenderer",
    "gluDeleteQuadric",
    "gluDeleteTess",
    "gluDisk",
    "gluEndCurve",
    "gluEndPolygon",
    "gluEndSurface",
    "gluEndTrim",
    "gluErrorString",
    "gluGetNurbsProperty",
    "gluGetString",
    "gluGetTessProperty",
    "gluLoadSamplingMatrices",
    "gluLookAt",
    "gluNewNurbsRenderer",
    "gluNewQuadric",
    "gluNewTess",
    "gluNextContour",
    "gluNurbsCallback",
    "gluNurbsCallbackData",
    "gluNurbsCallbackDataEXT",
    "gluNurbsCurve",
    "gluNurbsProperty",
    "gluNurbsSurface",
    "gluOrtho2D",
    "gluPartialDisk",
    "gluPerspective",
    "gluPickMatrix",
    "gluProject",
    "gluPwlCurve",
    "gluQuadricCallback",
    "gluQuadricDrawStyle",
    "gluQuadricNormals",
    "gluQuadricOrientation",
    "gluQuadricTexture",
    "gluScaleImage",
    "gluSphere",
    "gluTessBeginContour",
    "gluTessBeginPolygon",
    "gluTessCallback",
    "gluTessEndContour",
    "gluTessEndPolygon",
    "gluTessNormal",
    "gluTessProperty",
    "gluTessVertex",
    "gluUnProject",
    "gluUnProject4",
]

GLU_AUTO_LOAD_MATRIX: Enum
GLU_BEGIN: Enum
GLU_CCW: Enum
GLU_CULLING: Enum
GLU_CW: Enum
GLU_DISPLAY_MODE: Enum
GLU_DOMAIN_DISTANCE: Enum
GLU_EDGE_FLAG: Enum
GLU_END: Enum
GLU_ERROR: Enum
GLU_EXTENSIONS: Enum
GLU_EXTERIOR: Enum
GLU_FALSE: Enum
GLU_FILL: Enum
GLU_FLAT: Enum
GLU_INCOMPATIBLE_GL_VERSION: Enum
GLU_INSIDE: Enum
GLU_INTERIOR: Enum
GLU_INVALID_ENUM: Enum
GLU_INVALID_OPERATION: Enum
GLU_INVALID_VALUE: Enum
GLU_LINE: Enum
GLU_MAP1_TRIM_2: Enum
GLU_MAP1_TRIM_3: Enum
GLU_NONE: Enum
GLU_NURBS_BEGIN: Enum
GLU_NURBS_BEGIN_DATA: Enum
GLU_NURBS_BEGIN_DATA_EXT: Enum
GLU_NURBS_BEGIN_EXT: Enum
GLU_NURBS_COLOR: Enum
GLU_NURBS_COLOR_DATA: Enum
GLU_NURBS_COLOR_DATA_EXT: Enum
GLU_NURBS_COLOR_EXT: Enum
GLU_NURBS_END: Enum
GLU_NURBS_END_DATA: Enum
GLU_NURBS_END_DATA_EXT: Enum
GLU_NURBS_END_EXT: Enum
GLU_NURBS_ERROR: Enum
GLU_NURBS_ERROR1: Enum
GLU_NURBS_ERROR10: Enum
GLU_NURBS_ERROR11: Enum
GLU_NURBS_ERROR12: Enum
GLU_NURBS_ERROR13: Enum
GLU_NURBS_ERROR14: Enum
GLU_NURBS_ERROR15: Enum
GLU_NURBS_ERROR16: Enum
GLU_NURBS_ERROR17: Enum
GLU_NURBS_ERROR18: Enum
GLU_NURBS_ERROR19: Enum
GLU_NURBS_ERROR2: Enum
GLU_NURBS_ERROR20: Enum
GLU_NURBS_ERROR21: Enum
GLU_NURBS_ERROR22: Enum
GLU_NURBS_ERROR23: Enum
GLU_NURBS_ERROR24: Enum
GLU_NURBS_ERROR25: Enum
GLU_NURBS_ERROR26: Enum
GLU_NURBS_ERROR27: Enum
GLU_NURBS_ERROR28: Enum
GLU_NURBS_ERROR29: Enum
GLU_NURBS_ERROR3: Enum
GLU_NURBS_ERROR30: Enum
GLU_NURBS_ERROR31: Enum
GLU_NURBS_ERROR32: Enum
GLU_NURBS_ERROR33: Enum
GLU_NURBS_ERROR34: Enum
GLU_NURBS_ERROR35: Enum
GLU_NURBS_ERROR36: Enum
GLU_NURBS_ERROR37: Enum
GLU_NURBS_ERROR4: Enum
GLU_NURBS_ERROR5: Enum
GLU_NURBS_ERROR6: Enum
GLU_NURBS_ERROR7: Enum
GLU_NURBS_ERROR8: Enum
GLU_NURBS_ERROR9: Enum
GLU_NURBS_MODE: Enum
GLU_NURBS_MODE_EXT: Enum
GLU_NURBS_NORMAL: Enum
GLU_NURBS_NORMAL_DATA: Enum
GLU_NURBS_NORMAL_DATA_EXT: Enum
GLU_NURBS_NORMAL_EXT: Enum
GLU_NURBS_RENDERER: Enum
GLU_NURBS_RENDERER_EXT: Enum
GLU_NURBS_TESSELLATOR: Enum
GLU_NURBS_TESSELLATOR_EXT: Enum
GLU_NURBS_TEXTURE_COORD: Enum
GLU_NURBS_TEXTURE_COORD_DATA: Enum
GLU_NURBS_TEX_COORD_DATA_EXT: Enum
GLU_NURBS_TEX_COORD_EXT: Enum
GLU_NURBS_VERTEX: Enum
GLU_NURBS_VERTEX_DATA: Enum
GLU_NURBS_VERTEX_DATA_EXT: Enum
GLU_NURBS_VERTEX_EXT: Enum
GLU_OBJECT_PARAMETRIC_ERROR: Enum
GLU_OBJECT_PARAMETRIC_ERROR_EXT: Enum
GLU_OBJECT_PATH_LENGTH: Enum
GLU_OBJECT_PATH_LENGTH_EXT: Enum
GLU_OUTLINE_PATCH: Enum
GLU_OUTLINE_POLYGON: Enum
GLU_OUTSIDE: Enum
GLU_OUT_OF_MEMORY: Enum
GLU_PARAMETRIC_ERROR: Enum
GLU_PARAMETRIC_TOLERANCE: Enum
GLU_PATH_LENGTH: Enum
GLU_POINT: Enum
GLU_SAMPLING_METHOD: Enum
GLU_SAMPLING_TOLERANCE: Enum
GLU_SILHOUETTE: Enum
GLU_SMOOTH: Enum
GLU_TESS_BEGIN: Enum
GLU_TESS_BEGIN_DATA: Enum
GLU_TESS_BOUNDARY_ONLY: Enum
GLU_TESS_COMBINE: Enum
GLU_TESS_COMBINE_DATA: Enum
GLU_TESS_COORD_TOO_LARGE: Enum
GLU_TESS_EDGE_FLAG: Enum
GLU_TESS_EDGE_FLAG_DATA: Enum
GLU_TESS_END: Enum
GLU_TESS_END_DATA: Enum
GLU_TESS_ERROR: Enum
GLU_TESS_ERROR1: Enum
GLU_TESS_ERROR2: Enum
GLU_TESS_ERROR3: Enum
GLU_TESS_ERROR4: Enum
GLU_TESS_ERROR5: Enum
GLU_TESS_ERROR6: Enum
GLU_TESS_ERROR7: Enum
GLU_TESS_ERROR8: Enum
GLU_TESS_ERROR_DATA: Enum
GLU_TESS_MAX_COORD: float
GLU_TESS_MISSING_BEGIN_CONTOUR: Enum
GLU_TESS_MISSING_BEGIN_POLYGON: Enum
GLU_TESS_MISSING_END_CONTOUR: Enum
GLU_TESS_MISSING_END_POLYGON: Enum
GLU_TESS_NEED_COMBINE_CALLBACK: Enum
GLU_TESS_TOLERANCE: Enum
GLU_TESS_VERTEX: Enum
GLU_TESS_VERTEX_DATA: Enum
GLU_TESS_WINDING_ABS_GEQ_TWO: Enum
GLU_TESS_WINDING_NEGATIVE: Enum
GLU_TESS_WINDING_NONZERO: Enum
GLU_TESS_WINDING_ODD: Enum
GLU_TESS_WINDING_POSITIVE: Enum
GLU_TESS_WINDING_RULE: Enum
GLU_TRUE: Enum
GLU_UNKNOWN: Enum
GLU_U_STEP: Enum
GLU_VERSION: Enum
GLU_VERSION_1_1: Enum
GLU_VERSION_1_2: Enum
GLU_VERSION_1_3: Enum
GLU_VERTEX: Enum
GLU_V_STEP: Enum

