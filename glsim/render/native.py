"""The oracle: replay recorded calls on the platform's REAL fixed function.

A compatibility context is opened through EGL (surfaceless, or on a device) or OSMesa with ctypes; the command table
says how each call's arguments are passed.  No PyOpenGL is involved.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.commands import COMMANDS, Command
from glsim.machine.constants import GL_2_BYTES, GL_3_BYTES, GL_4_BYTES
from glsim.machine.frame import Call
from glsim.machine.types import DTYPES, SUFFIXES
from glsim.render.device import one_line, opening
from glsim.render.egl import EGLLoader
from glsim.render.osmesa import OSMesaLoader

C_TYPES: dict[str, Any] = {
    "b": ctypes.c_int8, "s": ctypes.c_int16, "i": ctypes.c_int32, "f": ctypes.c_float, "d": ctypes.c_double,
    "ub": ctypes.c_uint8, "us": ctypes.c_uint16, "ui": ctypes.c_uint32, "enum": ctypes.c_uint32,
    "bitfield": ctypes.c_uint32, "boolean": ctypes.c_uint8, "sizei": ctypes.c_int32, "data": ctypes.c_void_p,
}  # fmt: skip


# the initial values of glPixelTransfer: maps, shift, offset, then scale and bias of each component
PIXEL_TRANSFER = {0x0D10: 0.0, 0x0D11: 0.0, **{0x0D14 + k: float(k % 2 == 0) for k in range(8)}}


LOADERS: dict[str, Any] = {"egl": EGLLoader, "osmesa": OSMesaLoader}


class NoNativeError(RuntimeError):
    """This platform has no fixed function that can be reached without a window."""


class Native:
    """A context with the driver's fixed function, of a given size.  Raises NoNativeError if there is none.

    backends: what is tried; only "osmesa" has an accumulation buffer.
    """

    def __init__(self, width: int, height: int, backends: Sequence[str] = ("egl", "osmesa")) -> None:
        self.width, self.height = width, height
        opening()
        said = []
        for name in backends:
            try:
                self.loader: Any = LOADERS[name](core=False, width=width, height=height)
            except Exception as error:
                said.append(f"{name}: {one_line(error)}")
                continue
            self.backend = name
            self.functions: dict[str, Any] = {}
            self.version = self._string(0x1F02)
            self.renderer = self._string(0x1F01)
            if self._is_compatibility():
                self.loader.release_current()
                return
            said.append(f"{name}: {self.version} has no fixed function")
            self.loader.release()
        raise NoNativeError("no native fixed function: " + "; ".join(said))

    def _string(self, name: int) -> str:
        address = self.loader.load("glGetString")
        text = ctypes.CFUNCTYPE(ctypes.c_char_p, ctypes.c_uint)(address)(name)
        return (text or b"").decode()

    def _is_compatibility(self) -> bool:
        self._call("glShadeModel", (0x1D01,))
        return self.error() == 0

    def error(self) -> int:
        return int(ctypes.CFUNCTYPE(ctypes.c_uint)(self.loader.load("glGetError"))())

    def replay(self, calls: Iterable[Call], errors: list[tuple[str, int]] | None = None) -> NDArray[np.uint8]:
        """Run the calls from the initial state; the picture, top row first, (height, width, 4) uint8.

        Queries are left out.  Errors are appended to ``errors`` as (command, code).
        """
        self.loader.make_current()
        try:
            self._reset()
            kept: list[Any] = []  # arrays that pointers lead to
            inside = False
            for name, arguments, *_ in calls:
                command = COMMANDS[name]
                if command.result:
                    continue
                self._call(name, pass_on(command, arguments, kept))
                inside = name == "glBegin" or (inside and name != "glEnd")
                code = 0 if inside else self.error()
                if code and errors is not None:
                    errors.append((name, code))
            return self._pixels()
        finally:
            self.loader.release_current()

    def release(self) -> None:
        self.loader.release()

    def _reset(self) -> None:
        """A context starts in the initial state; what earlier replays changed is put back."""
        while self.error():
            pass
        if not hasattr(self, "_pushed"):
            self._pushed = True
        else:
            self._call("glPopAttrib", ())
            self._call("glPopClientAttrib", ())
            for unit in (3, 2, 1, 0):
                self._call("glActiveTexture", (0x84C0 + unit,))
                self._reset_matrix(0x1702)  # GL_TEXTURE
            self._reset_matrix(0x1701)  # GL_PROJECTION
            self._reset_matrix(0x1700)  # GL_MODELVIEW
        self._call("glPushAttrib", (0xFFFFFFFF,))
        self._call("glPushClientAttrib", (0xFFFFFFFF,))
        self._call("glClear", (0x4500,))
        while self.error():
            pass

    def _reset_matrix(self, mode: int) -> None:
        self._call("glMatrixMode", (mode,))
        while not self.error():
            self._call("glPopMatrix", ())
        self._call("glLoadIdentity", ())

    def _pixels(self) -> NDArray[np.uint8]:
        picture = np.zeros((self.height, self.width, 4), np.uint8)
        self._call("glFinish", ())
        for pname, value in PIXEL_TRANSFER.items():  # reading is changed by it too
            self._call("glPixelTransferf", (pname, value))
        self._call("glPixelStorei", (0x0D05, 1))
        read = ctypes.CFUNCTYPE(None, *[ctypes.c_int] * 4, ctypes.c_uint, ctypes.c_uint, ctypes.c_void_p)
        read(self.loader.load("glReadPixels"))(0, 0, self.width, self.height, 0x1908, 0x1401, picture.ctypes.data)
        return picture[::-1]

    def _call(self, name: str, arguments: tuple[Any, ...]) -> None:
        function = self.functions.get(name)
        if function is None:
            address = self.loader.load(name)
            if not address:
                raise NoNativeError(f"the driver has no {name}")
            kinds = [C_TYPES[kind] for _, kind in COMMANDS[name].arguments]
            function = self.functions[name] = ctypes.CFUNCTYPE(None, *kinds)(address)
        function(*arguments)


def pass_on(command: Command, arguments: tuple[Any, ...], kept: list[Any]) -> tuple[Any, ...]:
    """Python arguments of a recorded call -> what ctypes passes to the C function."""
    passed: list[Any] = []
    element = command.type
    names = dict(zip(command.parameters, arguments, strict=False))
    for (_, kind), value in zip(command.arguments, arguments, strict=False):
        if kind == "data" and value is None:
            passed.append(None)
        elif kind == "data":
            several_bytes = names.get("type") in (GL_2_BYTES, GL_3_BYTES, GL_4_BYTES)
            number: Any = SUFFIXES[element] if element else names.get("type")
            dtype = np.uint8 if several_bytes else DTYPES.get(number, np.float32)
            raw = isinstance(value, (bytes, bytearray))
            array = np.frombuffer(value, np.uint8) if raw else np.ascontiguousarray(value, dtype)
            kept.append(array)
            passed.append(array.ctypes.data)
        elif kind in ("f", "d"):
            passed.append(float(value))
        elif kind == "boolean":
            passed.append(bool(value))
        elif value is None:
            passed.append(0)
        else:
            passed.append(int(value))
    return tuple(passed)
