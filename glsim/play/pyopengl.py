"""``import OpenGL`` gives glsim: for this process, whether PyOpenGL is installed or not.

Modules that exist here stand in for OpenGL.GL, GLU, GLUT, error, arrays and a few more.  Modules of extensions
(OpenGL.GL.ARB.multitexture, ...) give the commands and constants of OpenGL 1.5 under their old names.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from importlib import import_module
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

import numpy as np

from glsim.machine.constants import Enum
from glsim.machine.errors import NoContextError
from glsim.play.starnames import Later, later_names, star_names

SUFFIXES = ("ARB", "EXT", "SGIS", "SGI", "NV", "ATI", "HP", "IBM", "WIN", "MESA", "APPLE")
Wrap = Callable[[str, Any], Any]


def install(wrap: Wrap | None = None) -> None:
    """From now on ``import OpenGL`` gives glsim.

    wrap: called with the name and the function of each command, returns the function that takes its place."""
    for name in [name for name in sys.modules if name == "OpenGL" or name.startswith("OpenGL.")]:
        del sys.modules[name]
    sys.meta_path.insert(0, _Finder(wrap or (lambda name, function: function)))


class _Finder(MetaPathFinder, Loader):
    def __init__(self, wrap: Wrap) -> None:
        self.wrap = wrap

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if name in CONTENT or name.startswith(EXTENSIONS):
            return ModuleSpec(name, self, is_package=True)
        return None

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        return None

    def exec_module(self, module: ModuleType) -> None:
        module.__file__ = f"<glsim for {module.__name__}>"
        known = CONTENT.get(module.__name__)
        fill(module, known() if known is not None else _extension(module.__name__), self.wrap)


def fill(module: ModuleType, content: Mapping[str, Any], wrap: Wrap) -> None:
    """Put names into a module, commands wrapped."""
    for name, value in content.items():
        public = name.startswith("gl") and callable(value) and not isinstance(value, (type, Later))
        module.__dict__[name] = wrap(name, value) if public else value
    if "__all__" in content:
        module.__dict__["__all__"] = list(content["__all__"])


def counted_libraries(wrap: Wrap) -> dict[str, ModuleType]:
    """glsim.gl, glu and glut with every command wrapped."""
    libraries = {}
    for name in ("glsim.gl", "glsim.glu", "glsim.glut"):
        libraries[name] = ModuleType(name)
        fill(libraries[name], vars(import_module(name)), wrap)
    return libraries


def _commands(which: str) -> dict[str, Any]:
    """Commands and constants of glsim.gl, glu or glut."""
    module: Any = import_module(f"glsim.{which.lower()}")
    return {name: getattr(module, name) for name in module.__all__}


def _library(which: str) -> dict[str, Any]:
    """All that the star import of OpenGL.GL, GLU or GLUT gives, with the list of its names."""
    content = _commands(which)
    constants = vars(import_module("glsim.gl")) | later_names()
    if which == "GLUT":
        NoContextError.uses_glut = True  # "call glutCreateWindow", not "call glsim.offscreen"
    if which == "GL":
        content = {**later_names(), **content, "as_8_bit": _bytes()["as_8_bit"]}
    elif which == "GLUT":
        content["as_8_bit"] = _bytes()["as_8_bit"]
    content.update(star_names(which, constants, _errors()))
    content["__all__"] = list(content)
    return content


def _errors() -> dict[str, Any]:
    from glsim.glu.errors import GLUError
    from glsim.machine.errors import GLError, NoContextError

    return {
        "GLError": GLError, "GLerror": GLError, "GLUError": GLUError, "GLUerror": GLUError, "GLUTError": RuntimeError,
        "GLUTerror": RuntimeError, "Error": Exception, "NullFunctionError": AttributeError,
        "NoContext": NoContextError, "CopyError": TypeError,
    }  # fmt: skip


def _no_shaders(*arguments: Any) -> Any:
    raise RuntimeError("GLSL programs are OpenGL 2; glsim emulates the fixed function of OpenGL 1.5")


def _extension(module: str) -> dict[str, Any]:
    """Names of an extension such as OpenGL.GL.ARB.multitexture: glActiveTextureARB is glActiveTexture, GL_TEXTURE0_ARB
    GL_TEXTURE0; glInitMultitextureARB() says whether it is there."""
    gl: Any = import_module("glsim.gl")
    _, _, vendor, *rest = module.split(".")
    extension = rest[0] if rest else ""
    content = {
        (f"{name}_{vendor}" if name.startswith("GL_") else f"{name}{vendor}"): getattr(gl, name)
        for name in gl.__all__
        if name.startswith("GL_") or (name.startswith("gl") and name[2].isupper())
    }
    words = "".join(word[:1].upper() + word[1:] for word in extension.split("_"))
    content[f"glInit{words}{vendor}"] = lambda: extension in SUPPORTED_EXTENSIONS
    content["__all__"] = list(content)
    return content


EXTENSIONS = tuple(f"OpenGL.GL.{vendor}" for vendor in SUFFIXES)
SUPPORTED_EXTENSIONS = {
    "multitexture", "texture_env_combine", "texture_env_add", "texture_env_crossbar", "texture_env_dot3",
    "texture_cube_map", "texture_border_clamp", "depth_texture", "shadow", "transpose_matrix", "window_pos",
    "point_parameters", "vertex_buffer_object", "occlusion_query", "texture3D", "texture_lod_bias", "fog_coord",
    "secondary_color", "blend_color", "blend_minmax", "blend_subtract", "multi_draw_arrays", "stencil_wrap",
    "generate_mipmap", "texture_edge_clamp", "bgra", "packed_pixels", "rescale_normal", "polygon_offset",
}  # fmt: skip


# ---------------------------------------------------------------- OpenGL.arrays

ARRAYS: Mapping[str, type] = {
    "GLfloatArray": np.float32, "GLdoubleArray": np.float64, "GLintArray": np.int32, "GLuintArray": np.uint32,
    "GLubyteArray": np.uint8, "GLbyteArray": np.int8, "GLshortArray": np.int16, "GLushortArray": np.uint16,
    "GLenumArray": np.uint32, "ArrayDatatype": np.float32,
}  # fmt: skip


class _Array:
    """As far as programs use PyOpenGL's array types: making arrays, and their size in bytes."""

    def __init__(self, dtype: type) -> None:
        self.dtype = dtype

    def zeros(self, shape: Any, typeCode: Any = None) -> Any:
        return np.zeros(shape, self.dtype)

    def asArray(self, value: Any, typeCode: Any = None) -> Any:
        return np.asarray(value, self.dtype)

    def arrayByteCount(self, value: Any) -> int:
        return int(np.asarray(value).nbytes)

    def arraySize(self, value: Any, typeCode: Any = None) -> int:
        return int(np.size(value))


class VBO:
    """OpenGL.arrays.vbo.VBO: an array in a buffer object."""

    def __init__(
        self, data: Any, usage: Any = "GL_DYNAMIC_DRAW", target: Any = "GL_ARRAY_BUFFER", size: Any = None
    ) -> None:
        from glsim import gl

        self.data, self.gl = np.asarray(data), gl
        self.usage = getattr(gl, usage) if isinstance(usage, str) else usage
        self.target = getattr(gl, target) if isinstance(target, str) else target
        self.buffer = 0

    def bind(self) -> None:
        if not self.buffer:
            self.buffer = int(self.gl.glGenBuffers(1))
            self.gl.glBindBuffer(self.target, self.buffer)
            self.gl.glBufferData(self.target, self.data.nbytes, self.data, self.usage)
        self.gl.glBindBuffer(self.target, self.buffer)

    def unbind(self) -> None:
        self.gl.glBindBuffer(self.target, 0)

    def delete(self) -> None:
        self.gl.glDeleteBuffers(1, [self.buffer])
        self.buffer = 0

    def set_array(self, data: Any, size: Any = None) -> None:
        self.data, self.buffer = np.asarray(data), 0

    def __enter__(self) -> VBO:
        self.bind()
        return self

    def __exit__(self, *exception: Any) -> None:
        self.unbind()

    def __add__(self, offset: int) -> int:
        return int(offset)

    def __len__(self) -> int:
        return len(self.data)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.__dict__["data"], name)

    @property
    def value(self) -> int:  # where glVertexPointer(..., vbo) begins
        return 0


# ---------------------------------------------------------------- what each module has


def _arrays() -> dict[str, Any]:
    return {"vbo": import_module("OpenGL.arrays.vbo"), **{name: _Array(dtype) for name, dtype in ARRAYS.items()}}


def _has_extension(name: Any) -> bool:
    """OpenGL.extensions.hasGLExtension: whether glGetString(GL_EXTENSIONS) names it."""
    gl: Any = import_module("glsim.gl")
    wanted = name if isinstance(name, bytes) else str(name).encode()
    return wanted in gl.glGetString(gl.GL_EXTENSIONS).split()


def _bytes() -> dict[str, Any]:
    def as_8_bit(text: Any) -> bytes:
        return text if isinstance(text, bytes) else str(text).encode("latin-1")

    return {
        "as_8_bit": as_8_bit, "bytes": bytes, "unicode": str, "integer_types": (int,), "as_str": str, "long": int,
        "maxsize": sys.maxsize, "STR_IS_BYTES": False, "STR_IS_UNICODE": True,
    }  # fmt: skip


CONTENT: dict[str, Callable[[], dict[str, Any]]] = {
    "OpenGL": lambda: {
        "__version__": "3.1.10", "version": "3.1.10", "ERROR_CHECKING": True, "ERROR_LOGGING": False,
        "ERROR_ON_COPY": False, "FULL_LOGGING": False, "FORWARD_COMPATIBLE_ONLY": False,
    },
    "OpenGL.GL": lambda: _library("GL"),
    "OpenGL.GLU": lambda: _library("GLU"),
    "OpenGL.GLUT": lambda: _library("GLUT"),
    "OpenGL.GLUT.freeglut": lambda: _commands("GLUT"),
    "OpenGL.GLUT.fonts": lambda: _commands("GLUT"),
    "OpenGL.GLUT.special": lambda: _commands("GLUT"),
    "OpenGL.error": lambda: _errors(),
    "OpenGL.constants": lambda: {k: v for k, v in _commands("GL").items() if k.startswith("GL")},
    "OpenGL.arrays": _arrays,
    "OpenGL.arrays.vbo": lambda: {"VBO": VBO},
    "OpenGL.arrays.numpymodule": dict,
    "OpenGL.platform": lambda: {"PLATFORM": None, "GetCurrentContext": lambda: 1},
    "OpenGL.GL.shaders": lambda: dict.fromkeys(("compileShader", "compileProgram", "ShaderProgram"), _no_shaders),
    "OpenGL.extensions": lambda: dict.fromkeys(("hasExtension", "hasGLExtension"), _has_extension),
    "OpenGL._bytes": _bytes,
    "OpenGL.constant": lambda: {"Constant": Enum, "IntConstant": Enum},
    # modules of PyOpenGL itself, from which programs take nothing
    **dict.fromkeys(
        (
            "OpenGL.images", "OpenGL.plugins", "OpenGL.wrapper", "OpenGL.converters", "OpenGL.contextdata",
            "OpenGL.logs", "OpenGL.GL.VERSION", "OpenGL.GL.pointers", "OpenGL.GL.images", "OpenGL.GL.exceptional",
            "OpenGL.GL.glget", "OpenGL.GL.vboimplementation", "OpenGL.GL.KHR", "OpenGL.GLU.quadrics",
            "OpenGL.GLU.projection", "OpenGL.GLU.glustruct", "OpenGL.GLU.glunurbs", "OpenGL.GLU.tess",
            "OpenGL.GLUT.osx",
        ),
        dict,
    ),
}  # fmt: skip
for _version in ("GL_1_0", "GL_1_1", "GL_1_2", "GL_1_3", "GL_1_4", "GL_1_5"):
    CONTENT[f"OpenGL.GL.VERSION.{_version}"] = CONTENT["OpenGL.GL"]
