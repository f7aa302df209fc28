"""EGL through ctypes: a context without a window, on a GPU or on Mesa's software rasteriser.

One loader serves both kinds of context: a 3.3 core profile for glsim's own drawing and a compatibility profile, the
driver's real fixed function, for the oracle.  Its display is its own, so that another library that terminates its EGL
display (pyrender does) takes nothing away.
"""

from __future__ import annotations

import ctypes
import os
from typing import Any

from glsim.render import osmesa

EGL_OPENGL_API, EGL_NONE, EGL_WIDTH, EGL_HEIGHT, EGL_DRAW, EGL_READ, EGL_EXTENSIONS = (
    0x30A2, 0x3038, 0x3057, 0x3056, 0x3059, 0x305A, 0x3055,
)  # fmt: skip
PLATFORM_SURFACELESS, PLATFORM_DEVICE = 0x31DD, 0x313F
TRACK_REFERENCES = 0x3352
# pbuffer, desktop OpenGL, 8 bits for each colour, 24 bits of depth, 8 of stencil
CONFIG = (0x3033, 0x0001, 0x3040, 0x0008, 0x3024, 8, 0x3023, 8, 0x3022, 8, 0x3021, 8, 0x3025, 24, 0x3026, 8, EGL_NONE)
# version 3.3, core profile, forward compatible
CORE = (0x3098, 3, 0x30FB, 3, 0x30FD, 1, 0x31B1, 1, EGL_NONE)
POINTERS = (
    "eglGetProcAddress", "eglCreatePbufferSurface", "eglCreateContext", "eglGetCurrentContext", "eglGetCurrentSurface",
    "eglGetCurrentDisplay", "eglGetDisplay",
)  # fmt: skip


def _ints(values: tuple[int, ...]) -> Any:
    return (ctypes.c_int * len(values))(*values)


def _library() -> ctypes.CDLL:
    try:
        ctypes.CDLL("libGL.so.1")  # EGL hands out GL's functions, but some drivers only once libGL is there
        egl = ctypes.CDLL("libEGL.so.1")
    except OSError as error:
        raise RuntimeError(str(error)) from None
    for name in POINTERS:
        getattr(egl, name).restype = ctypes.c_void_p
    egl.eglQueryString.restype = ctypes.c_char_p
    egl.eglGetProcAddress.argtypes = [ctypes.c_char_p]
    egl.eglQueryString.argtypes = [ctypes.c_void_p, ctypes.c_int]
    egl.eglMakeCurrent.argtypes = [ctypes.c_void_p] * 4
    egl.eglGetCurrentSurface.argtypes = [ctypes.c_int]
    return egl


def _devices(egl: ctypes.CDLL) -> list[int]:
    address = egl.eglGetProcAddress(b"eglQueryDevicesEXT")
    if not address:
        return []
    query = ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(address)
    devices, count = (ctypes.c_void_p * 64)(), ctypes.c_int()
    query(64, devices, ctypes.byref(count))
    return [device for device in devices[: count.value] if device]


def _is_nvidia(egl: ctypes.CDLL, device: int) -> bool:
    """Whether the device belongs to NVIDIA's own driver, which has no surfaceless platform."""
    address = egl.eglGetProcAddress(b"eglQueryDeviceStringEXT")
    query = ctypes.CFUNCTYPE(ctypes.c_char_p, ctypes.c_void_p, ctypes.c_int)(address)
    return b"EGL_NV" in (query(device, EGL_EXTENSIONS) or b"")


def count_devices() -> int:
    """How many EGL devices there are; 0 without EGL."""
    try:
        return len(_devices(_library()))
    except RuntimeError:
        return 0


class EGLLoader:
    """A current EGL context with a pbuffer of width x height pixels.

    core: a 3.3 core profile; else the driver's default context, which has the fixed function if the driver has it.
    device: index of an EGL device; None takes GLCONTEXT_DEVICE_INDEX, else what opens first.
    Raises RuntimeError with what EGL said.
    """

    def __init__(self, core: bool, width: int = 16, height: int = 16, device: int | None = None) -> None:
        self.egl = _library()
        if device is None and os.environ.get("GLCONTEXT_DEVICE_INDEX", "").isdigit():
            device = int(os.environ["GLCONTEXT_DEVICE_INDEX"])
        message = "EGL has neither devices nor a surfaceless platform"
        for display in self._displays(device):
            try:
                self._open(display, core, width, height)
                return
            except RuntimeError as error:
                message = str(error)
        raise RuntimeError(message)

    def _displays(self, device: int | None) -> list[int]:
        """The displays to try: the device asked for; or else devices of other drivers than Mesa, Mesa's surfaceless
        platform, which is on Mesa's first device but a display of its own, and Mesa's devices."""
        extensions = (self.egl.eglQueryString(None, EGL_EXTENSIONS) or b"").split()
        address = self.egl.eglGetProcAddress(b"eglGetPlatformDisplayEXT")
        if not address:
            return []
        get = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_uint, ctypes.c_void_p, ctypes.c_void_p)(address)
        attributes = _ints((TRACK_REFERENCES, 1, EGL_NONE)) if b"EGL_KHR_display_reference" in extensions else None
        devices = _devices(self.egl)
        if device is not None:
            if device >= len(devices):
                raise RuntimeError(f"there is no EGL device {device}: {len(devices)} found")
            return [get(PLATFORM_DEVICE, devices[device], attributes)]
        places = [(PLATFORM_DEVICE, candidate) for candidate in devices if _is_nvidia(self.egl, candidate)]
        if b"EGL_MESA_platform_surfaceless" in extensions:
            places.append((PLATFORM_SURFACELESS, 0))
        places += [(PLATFORM_DEVICE, candidate) for candidate in devices]
        return [display for platform, candidate in places if (display := get(platform, candidate, attributes))]

    def _open(self, display: int, core: bool, width: int, height: int) -> None:
        egl, self.display = self.egl, ctypes.c_void_p(display)
        if not egl.eglInitialize(self.display, None, None):
            raise RuntimeError(f"eglInitialize failed (EGL error 0x{egl.eglGetError():X})")
        config, count = ctypes.c_void_p(), ctypes.c_int()
        egl.eglBindAPI(EGL_OPENGL_API)
        egl.eglChooseConfig(self.display, _ints(CONFIG), ctypes.byref(config), 1, ctypes.byref(count))
        if not count.value:
            raise RuntimeError("EGL has no configuration with desktop OpenGL and a pbuffer")
        size = _ints((EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE))
        self.surface = ctypes.c_void_p(egl.eglCreatePbufferSurface(self.display, config, size))
        attributes = _ints(CORE if core else (EGL_NONE,))
        self.context = ctypes.c_void_p(egl.eglCreateContext(self.display, config, None, attributes))
        if not self.surface.value or not self.context.value:
            raise RuntimeError(f"eglCreateContext failed (EGL error 0x{egl.eglGetError():X})")
        self.previous: list[tuple[Any, ...]] = []
        self.make_current()

    def make_current(self) -> None:
        """Raises RuntimeError if the context is gone."""
        self.egl.eglBindAPI(EGL_OPENGL_API)
        if not self.egl.eglMakeCurrent(self.display, self.surface, self.surface, self.context):
            code = self.egl.eglGetError()
            raise RuntimeError(f"eglMakeCurrent failed (EGL error 0x{code:X}): did another library end this display?")

    def load(self, name: str) -> int:
        return self.egl.eglGetProcAddress(name.encode()) or 0

    def __enter__(self) -> EGLLoader:
        egl = self.egl
        if osmesa.in_use:
            self.release_current()
        current = egl.eglGetCurrentContext()
        if current == self.context.value:
            self.previous.append(())
        else:
            surfaces = (egl.eglGetCurrentSurface(EGL_DRAW), egl.eglGetCurrentSurface(EGL_READ))
            self.previous.append((egl.eglGetCurrentDisplay(), *surfaces, current) if current else ())
            self.make_current()
        return self

    def __exit__(self, *exception: Any) -> None:
        previous = self.previous.pop()
        if previous:
            self.egl.eglMakeCurrent(*previous)

    def release_current(self) -> None:
        self.egl.eglMakeCurrent(self.display, None, None, None)

    def release(self) -> None:
        if self.context:
            self.release_current()
            self.egl.eglDestroySurface(self.display, self.surface)
            self.egl.eglDestroyContext(self.display, self.context)
            self.context = ctypes.c_void_p()
