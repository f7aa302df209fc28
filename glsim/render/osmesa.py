"""OSMesa through ctypes: Mesa drawing into plain memory, with neither EGL nor X.

Used as a loader for moderngl (core profile) and for the native fixed function (compatibility profile).
"""

from __future__ import annotations

import ctypes
from ctypes.util import find_library
from typing import Any

OSMESA_RGBA = 0x1908
OSMESA_FORMAT, OSMESA_DEPTH_BITS, OSMESA_STENCIL_BITS, OSMESA_ACCUM_BITS = 0x22, 0x30, 0x31, 0x32
OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_COMPAT_PROFILE = 0x33, 0x34, 0x35
OSMESA_CONTEXT_MAJOR_VERSION, OSMESA_CONTEXT_MINOR_VERSION = 0x36, 0x37
GL_UNSIGNED_BYTE = 0x1401


def _library() -> ctypes.CDLL:
    for name in ("libOSMesa.so.8", "libOSMesa.so.6", find_library("OSMesa")):
        try:
            if name:
                return ctypes.CDLL(name)
        except OSError:
            continue
    raise RuntimeError("libOSMesa.so.8 is not installed")


in_use = False  # whether an OSMesa context was ever made: EGL does not notice when one becomes current


class OSMesaLoader:
    """A current OSMesa context that draws into a buffer of width x height pixels.

    core: a 3.3 core profile, else Mesa's fixed function.  Raises RuntimeError if OSMesa cannot do it.
    """

    def __init__(self, core: bool, width: int = 16, height: int = 16) -> None:
        self.library = _library()
        attributes = [OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS, 8]
        if core:
            attributes += [OSMESA_PROFILE, OSMESA_CORE_PROFILE]
            attributes += [OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3]
        else:
            attributes += [OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, OSMESA_ACCUM_BITS, 16]
        create = self.library.OSMesaCreateContextAttribs
        create.restype = ctypes.c_void_p
        create.argtypes = [ctypes.POINTER(ctypes.c_int), ctypes.c_void_p]
        self.context = create((ctypes.c_int * (len(attributes) + 1))(*attributes, 0), None)
        if not self.context:
            raise RuntimeError("OSMesaCreateContextAttribs made no context")
        self.width, self.height = width, height
        self.pixels = (ctypes.c_ubyte * (width * height * 4))()
        self.library.OSMesaGetCurrentContext.restype = ctypes.c_void_p
        self.library.OSMesaGetProcAddress.restype = ctypes.c_void_p
        self.library.OSMesaGetProcAddress.argtypes = [ctypes.c_char_p]
        make = self.library.OSMesaMakeCurrent
        make.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_int]
        global in_use
        in_use = True
        self.make_current()

    def make_current(self) -> None:
        if not self.library.OSMesaMakeCurrent(self.context, self.pixels, GL_UNSIGNED_BYTE, self.width, self.height):
            raise RuntimeError("OSMesaMakeCurrent failed")

    def load(self, name: str) -> int:
        return self.library.OSMesaGetProcAddress(name.encode()) or 0

    def __enter__(self) -> OSMesaLoader:
        self.make_current()
        return self

    def __exit__(self, *exception: Any) -> None:
        pass

    def release_current(self) -> None:
        self.library.OSMesaMakeCurrent(None, None, 0, 0, 0)

    def release(self) -> None:
        if self.context:
            self.library.OSMesaDestroyContext.argtypes = [ctypes.c_void_p]
            self.library.OSMesaDestroyContext(self.context)
            self.context = None
