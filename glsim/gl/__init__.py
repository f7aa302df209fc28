"""OpenGL 1.x as textbooks use it: a drop-in for ``OpenGL.GL``.

``from glsim.gl import *`` gives the commands of OpenGL 1.0-1.5 with all their suffixes, PyOpenGL's suffix-free forms
(glVertex, glColor, glLight, ...), the constants, and GLError.  They drive the current context, which
``glsim.offscreen(width, height)`` makes.  SUPPORT.md beside this file lists every command, and which few are accepted
without effect or refused.

Extensions (glGetString(GL_EXTENSIONS) names them):

- GL_WIN_phong_shading: ``glShadeModel(GL_PHONG_WIN)`` evaluates the lighting equation at every fragment.
- GL_GLSIM_specular_lobe: ``glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, lobe)`` with GL_BLINN_TORRANCE_GLSIM,
  (N.H)^n, or GL_PHONG_LOBE_GLSIM, (R.V)^n with R = (N.L)N + S and S = (N.L)N - L.
- GL_GLSIM_back_lighting: ``glLightModeli(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM, policy)`` says what happens where
  N.L < 0: GL_CLAMP_NORMAL_GLSIM (no light) or GL_FLIP_NORMAL_GLSIM (N becomes -N).  Two-sided lighting is separate:
  GL_LIGHT_MODEL_TWO_SIDE.
- GL_GLSIM_affine_interpolation: ``glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)`` interpolates colours,
  normals, texture coordinates and fog linearly on the screen, without regard to the distance; GL_FASTEST, GL_NICEST and
  GL_DONT_CARE all mean the correct, hyperbolic interpolation.
"""

from __future__ import annotations

import inspect
from typing import Any

from glsim.gl import (
    arrays,
    attrib,
    buffers,
    drawarrays,
    enable,
    evaluators,
    fragment,
    immediate,
    light,
    lists,
    matrix,
    pixels,
    query,
    raster,
    rasterpos,
    select,
    texcompressed,
    texcopy,
    texenv,
    teximage,
    texread,
    texture,
    vertex,
)
from glsim.gl.dispatch import SUFFIX_FREE, suffix_free, typed_arrays, variant
from glsim.gl.manual import doc
from glsim.machine import constants
from glsim.machine import errors as error  # PyOpenGL's name: error.GLError
from glsim.machine.commands import COMMANDS
from glsim.machine.errors import GLError as GLError
from glsim.machine.errors import NoContextError as NoContextError
from glsim.machine.record import implementations
from glsim.machine.types import C_TYPES
from glsim.names import missing

globals().update(C_TYPES)
globals().update({f"{name}_{n}": C_TYPES[name] * n for name in ("GLfloat", "GLdouble") for n in (3, 4, 16)})


_TOPICS = (
    vertex, arrays, drawarrays, buffers, evaluators, matrix, light, raster, rasterpos, fragment, pixels, select,
    texture, teximage, texcopy, texcompressed, texread, texenv, enable, attrib, lists, query,
)  # fmt: skip
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
        if hot is not None:
            signature = inspect.signature(hot)
            *parameters, _surplus = signature.parameters.values()
            hot.__signature__ = signature.replace(parameters=parameters)
            functions[command.name] = hot
            continue
        body = _BODIES.get(command.name) or _BODIES[command.family]
        functions[command.name] = variant(command, body)
    for family in SUFFIX_FREE:
        functions[family] = suffix_free(family, functions)
    functions.update(typed_arrays(functions))
    for kind in ("Boolean", "Integer", "Float", "Double"):
        functions[f"glGet{kind}"] = functions[f"glGet{kind}v"]
    for function in functions.values():
        parameters = function.__signature__.parameters if function.__name__ in COMMANDS else ()
        function.__doc__ = doc(function.__name__, tuple(parameters))
    return functions


globals().update({name: value for name, value in vars(constants).items() if name.startswith("GL_")})
globals().update(_functions())

__all__ = [name for name in globals() if name.startswith("GL") or (name.startswith("gl") and name[2:3].isupper())]
__all__ += ["error"]
implementations.update({name: globals()[name] for name in COMMANDS})


def __getattr__(name: str) -> Any:
    raise missing(__name__, name, __all__)
