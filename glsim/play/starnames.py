"""What ``from OpenGL.GL import *`` and its like bind beside commands and constants.

PyOpenGL's star imports also give a program modules of Python, C types and errors, and programs rely on it: very many
call ``sys.exit`` and import no ``sys``.
"""

from __future__ import annotations

import ctypes
import json
import logging
import os
import sys
import traceback
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from glsim.machine.constants import Enum
from glsim.machine.types import C_TYPES


class Later:
    """A command that came after OpenGL 1.5: false, so that programs can ask for it, and an error when it is called."""

    def __init__(self, name: str, version: str) -> None:
        self.__name__ = name
        self.origin = f"came with OpenGL {version}" if version else "is of an extension"

    def __bool__(self) -> bool:
        return False

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        raise RuntimeError(f"{self.__name__} {self.origin}; glsim emulates the fixed function of OpenGL 1.5")


@cache
def later_names() -> dict[str, Any]:
    """Commands and constants that came after OpenGL 1.5; glInitGl20VERSION() and the like tell a program so."""
    later = json.loads(Path(__file__).with_name("later.json").read_text())
    content: dict[str, Any] = {}
    for name, version in later["commands"].items():  # "" instead of the version for an extension
        if name.startswith("glInit"):
            content[name] = (lambda: True) if name.startswith("glInitGl1") else (lambda: False)
        else:
            content[name] = Later(name, version)
    content.update({name: Enum(name, value) for name, value in later["constants"].items()})
    return content


def _callback(*arguments: Any) -> Any:
    return getattr(ctypes, "WINFUNCTYPE", ctypes.CFUNCTYPE)(None, *arguments)


_DEBUG = _callback(*[ctypes.c_uint] * 4, ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p)
TYPES: dict[str, Any] = {  # C's types by the names that PyOpenGL gives them
    **C_TYPES,
    "void": None,
    **dict.fromkeys(("GLhandle", "GLhandleARB"), ctypes.c_uint),
    **dict.fromkeys(("GLfixed", "GLclampx", "int32_t"), ctypes.c_int),
    **dict.fromkeys(("GLhalfNV", "GLhalfARB"), ctypes.c_ushort),
    **dict.fromkeys(("GLintptr", "GLintptrARB", "GLvdpauSurfaceNV"), ctypes.c_ssize_t),
    **dict.fromkeys(("GLsizeiptr", "GLsizeiptrARB", "size_t"), ctypes.c_size_t),
    **dict.fromkeys(("GLint64", "GLint64EXT", "int64_t"), ctypes.c_int64),
    **dict.fromkeys(("GLuint64", "GLuint64EXT"), ctypes.c_uint64),
    **dict.fromkeys(("GLchar", "GLcharARB"), ctypes.c_char),
    **dict.fromkeys(("GLvoidp", "GLeglImageOES", "GLsync"), ctypes.c_void_p),
    **dict.fromkeys(("GLDEBUGPROC", "GLDEBUGPROCARB", "GLDEBUGPROCKHR", "GLDEBUGPROCAMD"), _DEBUG),
    "GLulong": ctypes.c_ulong, "GLubyte_3": ctypes.c_ubyte * 3,
    **{f"GLfloat_{n}": ctypes.c_float * n for n in (2, 3, 4)},
    **{f"GLdouble_{n}": ctypes.c_double * n for n in (2, 3, 4)},
    "c_int": ctypes.c_int, "c_char_p": ctypes.c_char_p, "ctypes": ctypes, "sizeof": ctypes.sizeof,
    "ctypes_version": [1, 1, 0], "GL_CHAR": bytes, "GL_VOID_P": object(),
    "Constant": Enum, "bytes": bytes, "unicode": str, "long": int, "integer_types": (int,),
}  # fmt: skip
ARRAY_CONSTANTS = {
    "GLclampd": "GL_DOUBLE", "GLclampf": "GL_FLOAT", "GLfloat": "GL_FLOAT", "GLdouble": "GL_DOUBLE",
    "GLbyte": "GL_BYTE", "GLshort": "GL_SHORT", "GLint": "GL_INT", "GLubyte": "GL_UNSIGNED_BYTE",
    "GLushort": "GL_UNSIGNED_SHORT", "GLuint": "GL_UNSIGNED_INT", "GLenum": "GL_UNSIGNED_INT",
}  # fmt: skip
# GL constants that come with the types
TYPE_CONSTANTS = (
    "GL_FALSE", "GL_TRUE", "GL_BYTE", "GL_UNSIGNED_BYTE", "GL_SHORT", "GL_UNSIGNED_SHORT", "GL_INT", "GL_UNSIGNED_INT",
    "GL_UNSIGNED_INT64", "GL_FLOAT", "GL_DOUBLE", "GL_HALF_FLOAT", "GL_HALF_NV", "GL_FIXED",
)  # fmt: skip
ERRORS = ("Error", "GLError", "GLerror", "GLUError", "GLUerror", "GLUTError", "GLUTerror")
# PyOpenGL's own modules that its star imports bind
MODULES = {
    "GL": {
        "platform": "platform", "arrays": "arrays", "error": "error", "constants": "constants", "constant": "constant",
        "extensions": "extensions", "wrapper": "wrapper", "converters": "converters", "contextdata": "contextdata",
        "VERSION": "GL.VERSION", "pointers": "GL.pointers", "images": "GL.images", "exceptional": "GL.exceptional",
        "glget": "GL.glget", "ARB": "GL.ARB", "KHR": "GL.KHR", "imaging": "GL.ARB.imaging",
        "vboimplementation": "GL.vboimplementation",
    },
    "GLU": {
        "platform": "platform", "quadrics": "GLU.quadrics", "projection": "GLU.projection", "tess": "GLU.tess",
        "glustruct": "GLU.glustruct", "glunurbs": "GLU.glunurbs",
    },
    "GLUT": {
        "platform": "platform", "arrays": "arrays", "error": "error", "constant": "constant", "logs": "logs",
        "contextdata": "contextdata", "special": "GLUT.special", "fonts": "GLUT.fonts", "freeglut": "GLUT.freeglut",
        "osx": "GLUT.osx",
    },
}  # fmt: skip


def star_names(library: str, constants: dict[str, Any], errors: dict[str, Any]) -> dict[str, Any]:
    """What the star import of "GL", "GLU" or "GLUT" binds beside the library's own commands and constants.

    constants: those of OpenGL.  errors: the content of OpenGL.error.
    """
    modules = {name: import_module(f"OpenGL.{path}") for name, path in MODULES[library].items()}
    if library == "GLU":
        few = ("GLboolean", "GLdouble", "GLenum", "GLfloat", "GLint", "GLsizei", "GLubyte", "GLvoid", "ctypes")
        return {
            **modules, **{name: TYPES[name] for name in few}, "ArgumentError": ctypes.ArgumentError,
            **{name: errors[name] for name in ERRORS},
        }  # fmt: skip
    names = {
        **modules, **TYPES,
        "ARRAY_TYPE_TO_CONSTANT": [(name, constants[value]) for name, value in ARRAY_CONSTANTS.items()],
    }  # fmt: skip
    if library == "GL":
        arrays = modules["arrays"]
        names.update({name: getattr(arrays, name) for name in ("ArrayDatatype", "GLenumArray", "GLintArray")})
        names.update({name: errors[name] for name in ERRORS})
        return names | {"ArgumentError": ctypes.ArgumentError, "OpenGL": import_module("OpenGL")}
    return names | {
        **{name: constants[name] for name in TYPE_CONSTANTS},
        "sys": sys, "os": os, "traceback": traceback, "logging": logging, "c_ubyte": ctypes.c_ubyte,
        "c_void_p": ctypes.c_void_p, "FUNCTION_TYPE": ctypes.CFUNCTYPE, "CurrentContextIsValid": lambda: True,
        "fgDeinitialize": lambda exiting=False: None, "INITIALIZED": False,
    }  # fmt: skip
