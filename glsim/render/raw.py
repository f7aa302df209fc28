"""The GL commands that the core profile kept and moderngl does not wrap, called directly.

State that survived into the core profile (depth function, culling, masks, clears) is passed on with the very
enumerants the program gave.
"""

from __future__ import annotations

import ctypes
from typing import Any

TYPES: dict[str, Any] = {
    "i": ctypes.c_int,
    "u": ctypes.c_uint,
    "f": ctypes.c_float,
    "d": ctypes.c_double,
    "b": ctypes.c_ubyte,
    "p": ctypes.c_void_p,
}
SIGNATURES = {
    "glEnable": "u", "glDisable": "u", "glViewport": "iiii", "glDepthRange": "dd", "glDepthFunc": "u",
    "glDepthMask": "b", "glColorMask": "bbbb", "glCullFace": "u", "glFrontFace": "u", "glClear": "u",
    "glClearColor": "ffff", "glClearDepth": "d", "glClearStencil": "i", "glProvokingVertex": "u", "glFinish": "",
    "glReadPixels": "iiiiuup", "glPixelStorei": "ui", "glScissor": "iiii", "glPolygonOffset": "ff",
    "glStencilFunc": "uiu", "glStencilOp": "uuu", "glStencilMask": "u", "glBlendFuncSeparate": "uuuu",
    "glBlendEquation": "u", "glBlendColor": "ffff", "glLogicOp": "u", "glSampleCoverage": "fb",
    "glGenRenderbuffers": "ip", "glDeleteRenderbuffers": "ip", "glBindRenderbuffer": "uu",
    "glRenderbufferStorageMultisample": "uiuii",
    "glFramebufferRenderbuffer": "uuuu", "glBindFramebuffer": "uu", "glBlitFramebuffer": "iiiiiiiiuu",
    "glGenTextures": "ip", "glDeleteTextures": "ip", "glBindTexture": "uu", "glActiveTexture": "u",
    "glTexImage2D": "uiiiiiuup", "glTexImage3D": "uiiiiiiuup", "glTexParameterf": "uuf",
    "glGenQueries": "ip", "glBeginQuery": "uu", "glEndQuery": "u", "glDeleteQueries": "ip",
    "glGetQueryObjectuiv": "uup", "glTexParameteri": "uui", "glTexParameterfv": "uup",
}  # fmt: skip


class RawGL:
    """``raw.glDepthFunc(GL_LESS)``: each command of SIGNATURES as a method."""

    def __init__(self, loader: Any) -> None:
        for name, signature in SIGNATURES.items():
            address = loader.load(name)
            if not address:
                raise RuntimeError(f"the driver has no {name}")
            setattr(self, name, ctypes.CFUNCTYPE(None, *(TYPES[t] for t in signature))(address))

    def __getattr__(self, name: str) -> Any:  # for type checkers: the commands are set in __init__
        raise AttributeError(name)
