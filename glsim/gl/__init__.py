"""OpenGL 1.x as textbooks use it: a drop-in for ``OpenGL.GL``.

``from glsim.gl import *`` gives the commands of OpenGL 1.0-1.5 with all their suffixes, PyOpenGL's suffix-free forms
(glVertex, glColor, glLight, ...), the constants, and GLError.  They drive the current context, which
``glsim.offscreen(width, height)`` makes.  Commands that are not emulated yet raise NotImplementedError and are listed
in UNSUPPORTED.

Extensions (glGetString(GL_EXTENSIONS) names them):

- GL_WIN_phong_shading: ``glShadeModel(GL_PHONG_WIN)`` evaluates the lighting equation at every fragment.
- GL_GLSIM_specular_lobe: ``glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, lobe)`` with GL_BLINN_TORRANCE_GLSIM,
  (N.H)^n, or GL_PHONG_LOBE_GLSIM, (R.V)^n with R = (N.L)N + S and S = (N.L)N - L.
- GL_GLSIM_back_lighting: ``glLightModeli(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM, policy)`` says what happens where
  N.L < 0: GL_CLAMP_NORMAL_GLSIM (no light) or GL_FLIP_NORMAL_GLSIM (N becomes -N).  Two-sided lighting is separate:
  GL_LIGHT_MODEL_TWO_SIDE.
"""

from __future__ import annotations

import ctypes
from typing import Any

from glsim.gl import arrays, attrib, enable, fragment, immediate, light, lists, matrix, query, raster, texture, vertex
from glsim.gl.dispatch import SUFFIX_FREE, missing, suffix_free, typed_arrays, variant
from glsim.machine import constants
from glsim.machine.commands import COMMANDS
from glsim.machine.errors import GLError
from glsim.machine.errors import NoContextError as NoContextError
from glsim.machine.record import implementations

error = GLError  # PyOpenGL's other name for it

GLbyte, GLubyte, GLshort, GLushort = ctypes.c_byte, ctypes.c_ubyte, ctypes.c_short, ctypes.c_ushort
GLint, GLuint, GLfloat, GLdouble = ctypes.c_int, ctypes.c_uint, ctypes.c_float, ctypes.c_double
GLenum, GLbitfield, GLsizei, GLboolean = ctypes.c_uint, ctypes.c_uint, ctypes.c_int, ctypes.c_ubyte
GLclampf, GLclampd, GLvoid = ctypes.c_float, ctypes.c_double, None


_TOPICS = (vertex, arrays, matrix, light, raster, fragment, texture, enable, attrib, lists, query)
_BODIES = {
    name: body
    for topic in _TOPICS
    for name, body in vars(topic).items()
    if name.startswith("gl") and name[2:3].isupper()
}


def _functions() -> dict[str, Any]:
    """Every command of the table by name, and PyOpenGL's suffix-free forms."""
    functions: dict[str, Any] = {}
    for command in COMMANDS.values():
        hot = getattr(immediate, command.name, None)
        body = _BODIES.get(command.name) or _BODIES.get(command.family)
        functions[command.name] = hot or (variant(command, body) if body else missing(command))
    for family in SUFFIX_FREE:
        functions[family] = suffix_free(family, functions)
    functions.update(typed_arrays(functions))
    for kind in ("Boolean", "Integer", "Float", "Double"):
        functions[f"glGet{kind}"] = functions[f"glGet{kind}v"]
    return functions


UNSUPPORTED = tuple(
    name
    for name, command in COMMANDS.items()
    if not (hasattr(immediate, name) or name in _BODIES or command.family in _BODIES)
)
globals().update({name: value for name, value in vars(constants).items() if name.startswith("GL_")})
globals().update(_functions())

__all__ = [name for name in globals() if name.startswith("GL") or (name.startswith("gl") and name[2:3].isupper())]
__all__ += ["error"]
implementations.update({name: globals()[name] for name in COMMANDS})
