"""``import OpenGL`` gives glsim: for this process, whether PyOpenGL is installed or not.

Modules that exist here stand in for OpenGL.GL, GLU, GLUT, error, arrays and a few more.  Modules of extensions
(OpenGL.GL.ARB.multitexture, ...) give the commands and constants of OpenGL 1.5 under their old names.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

import numpy as np

SUFFIXES = ("ARB", "EXT", "SGIS", "SGI", "NV", "ATI", "HP", "IBM", "WIN", "MESA", "APPLE")
Wrap = Callable[[str, Any], Any]


def install(wrap: Wrap | None = None) -> None:
    """wrap: made of each command (name, function), for counting."""
    for name in [name for name in sys.modules if name == "OpenGL" or name.startswith("OpenGL.")]:
        del sys.modules[name]
    sys.meta_path.insert(0, _Finder(wrap or (lambda name, function: function)))


class _Finder(MetaPathFinder, Loader):
    def __init__(self, wrap: Wrap) -> None:
        self.wrap = wrap

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if name == "OpenGL" or name.startswith("OpenGL."):
            return ModuleSpec(name, self, is_package=True)
        return None

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        return None

    def exec_module(self, module: ModuleType) -> None:
        module.__file__ = f"<glsim for {module.__name__}>"
        content = _content(module.__name__)
        names = content.get("__all__")
        for name, value in content.items():
            public = name.startswith(("gl", "glu", "glut")) and callable(value) and not isinstance(value, type)
            module.__dict__[name] = self.wrap(name, value) if public else value
        if names is not None:
            module.__dict__["__all__"] = list(names)
        if module.__name__.startswith("OpenGL.GL."):
            module.__dict__["__getattr__"] = _extension(module.__name__)
            module.__dict__.setdefault("__all__", [])


def _content(name: str) -> dict[str, Any]:
    if name == "OpenGL":
        return {"__version__": "3.1.10", "version": "3.1.10", "ERROR_CHECKING": True, "ERROR_LOGGING": False}
    if name in ("OpenGL.GL", "OpenGL.GLU", "OpenGL.GLUT"):
        return _library(name[7:])
    if name == "OpenGL.error":
        return _errors()
    if name == "OpenGL.constants":
        content = _library("GL")
        return {key: value for key, value in content.items() if key.startswith("GL")}
    if name == "OpenGL.arrays.vbo":
        return {"VBO": VBO}
    if name == "OpenGL.arrays":
        return {"vbo": _submodule("OpenGL.arrays.vbo"), **{t: _Array(d) for t, d in ARRAYS.items()}}
    if name == "OpenGL.platform":
        return {"PLATFORM": None, "GetCurrentContext": lambda: 1}
    if name == "OpenGL.GL.shaders":
        return dict.fromkeys(("compileShader", "compileProgram", "glCreateShader", "glUseProgram"), _no_shaders)
    return {}


def _submodule(name: str) -> ModuleType:
    import importlib

    return importlib.import_module(name)


def _library(which: str) -> dict[str, Any]:
    if which == "GL":
        import glsim.gl as module
    elif which == "GLU":
        import glsim.glu as module  # type: ignore[no-redef]
    else:
        import glsim.glut as module  # type: ignore[no-redef]
    content = {name: getattr(module, name) for name in module.__all__}
    content["__all__"] = list(module.__all__)
    if which != "GL":  # PyOpenGL's GLU gives GLUError and the like
        return content
    content.update(_errors())
    content["__all__"] += ["GLerror", "arrays"]
    content["arrays"] = _submodule("OpenGL.arrays")
    return content


def _errors() -> dict[str, Any]:
    from glsim.glu.errors import GLUError
    from glsim.gl import GLError
    from glsim.machine.errors import NoContextError

    return {
        "GLError": GLError, "GLerror": GLError, "GLUError": GLUError, "GLUerror": GLUError, "GLUTError": RuntimeError,
        "GLUTerror": RuntimeError, "Error": Exception, "NullFunctionError": AttributeError,
        "NoContext": NoContextError, "CopyError": TypeError,
    }  # fmt: skip


def _no_shaders(*arguments: Any) -> Any:
    raise RuntimeError("GLSL programs are OpenGL 2; glsim emulates the fixed function of OpenGL 1.5")


def _extension(module: str) -> Callable[[str], Any]:
    """Names of an extension: glActiveTextureARB is glActiveTexture; glInitMultitextureARB() says whether it is there."""

    def lookup(name: str) -> Any:
        from glsim import gl

        for suffix in SUFFIXES:
            if name.endswith(suffix) and hasattr(gl, name.removesuffix(suffix)):
                return getattr(gl, name.removesuffix(suffix))
        if hasattr(gl, name):
            return getattr(gl, name)
        if name.startswith("glInit"):
            return lambda: module.rpartition(".")[2] in THERE
        raise AttributeError(f"{module} has no {name} here: glsim emulates OpenGL 1.5")

    return lookup


THERE = {
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
    "ArrayDatatype": np.float32,
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

    def __init__(self, data: Any, usage: Any = "GL_DYNAMIC_DRAW", target: Any = "GL_ARRAY_BUFFER", size: Any = None) -> None:
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
