"""The oracle: replay recorded calls on the platform's REAL fixed function.

A compatibility context is opened through EGL (surfaceless, or on a device) or OSMesa with ctypes; the command table
says how each call's arguments are passed.  No PyOpenGL is involved.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.commands import COMMANDS, Command
from glsim.machine.frame import Call
from glsim.machine.packing import PACKED
from glsim.machine.types import DTYPES, SUFFIXES, raw_bytes
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
        failures = []
        for name in backends:
            try:
                self.loader: Any = LOADERS[name](core=False, width=width, height=height)
            except Exception as error:
                failures.append(f"{name}: {one_line(error)}")
                continue
            self.backend = name
            self.functions: dict[str, Any] = {}
            self.version = self._string(0x1F02)
            self.renderer = self._string(0x1F01)
            if self._is_compatibility():
                self.loader.release_current()
                return
            failures.append(f"{name}: {self.version} has no fixed function")
            self.loader.release()
        raise NoNativeError("no native fixed function: " + "; ".join(failures))

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
            arrays: list[Any] = []  # arrays that pointers lead to
            inside = False
            for name, arguments, *_ in calls:
                command = COMMANDS[name]
                if command.result:
                    continue
                for one, passed in c_calls(name, arguments):
                    self._call(one, pass_on(COMMANDS[one], passed, arrays))
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
            self._call("glColor4f", (1.0, 1.0, 1.0, 1.0))  # Mesa's glPopAttrib leaves a colour that no vertex has used
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


Arguments = tuple[Any, ...]


def c_calls(name: str, arguments: Arguments) -> Iterator[tuple[str, Arguments]]:
    """A recorded call as calls of the C function: without PyOpenGL's short forms, and one by one what draws several."""
    given = dict(zip(COMMANDS[name].parameters, arguments, strict=False))
    if name.startswith("glMultiDraw"):
        lengths, indices = given["count"], given.get("indices", [None] * len(given["count"]))
        for k in range(given["primcount"]):
            if "first" in given:
                yield "glDrawArrays", (given["mode"], given["first"][k], lengths[k])
            else:
                yield "glDrawElements", (given["mode"], lengths[k], given["type"], indices[k])
        return
    if name.startswith("glMap1") and given.get("points") is None and "points" in given:
        points = np.asarray(given["stride"], np.float64)
        given.update(stride=points.shape[1], order=points.shape[0], points=points)
    elif name.startswith("glMap2") and given.get("points") is None and "points" in given:
        points = np.asarray(given["v1"], np.float64)
        orders = {"uorder": points.shape[0], "vorder": points.shape[1]}
        strides = {"ustride": points[0].size, "vstride": points.shape[2]}
        given.update(v1=given["ustride"], v2=given["uorder"], points=points)
        given.update(orders | strides)
    elif name.startswith("glPixelMap") and given.get("values") is None:
        given.update(size=np.size(given["size"]), values=given["size"])
    elif name.startswith("glDelete") and "n" in given:  # glDeleteTextures(names)
        names = next(key for key in given if key != "n")
        if given[names] is None:
            given.update({"n": np.size(given["n"]), names: given["n"]})
    elif name == "glCallLists" and given.get("type") is None:
        lists = raw_bytes(given["n"])
        lists = np.asarray(given["n"]) if lists is None else lists
        given.update(n=lists.size, type=gl.GL_UNSIGNED_INT, lists=lists)
    elif name == "glPolygonStipple" and np.size(given["mask"]) == 1024:  # ones and zeros
        given.update(mask=np.packbits(np.reshape(given["mask"], (32, 32)) != 0, axis=1))
    elif name == "glBufferData" and given.get("usage") is None:
        given.update(size=None, data=given["size"], usage=given["data"])
    elif name == "glBufferSubData" and given.get("data") is None:
        given.update(size=None, data=given["size"])
    if "size" in given and given["size"] is None:
        given["size"] = memory(given["data"], None).nbytes
    yield name, tuple(given.values())


# arrays whose numbers no other argument tells the type of
ELEMENTS: dict[str, type] = {"textures": np.uint32, "buffers": np.uint32, "ids": np.uint32, "flag": np.uint8}
BYTES = {("glBitmap", "data"), ("glPolygonStipple", "mask"), ("glEdgeFlagPointer", "pointer")}


def pass_on(command: Command, arguments: Arguments, arrays: list[Any]) -> Arguments:
    """Python arguments of a recorded call -> what ctypes passes to the C function."""
    passed: list[Any] = []
    names = dict(zip(command.parameters, arguments, strict=False))
    for (parameter, kind), value in zip(command.arguments, arguments, strict=False):
        if kind == "data" and (value is None or (type(value) is int and parameter in ("pointer", "indices"))):
            passed.append(value)  # an offset into a buffer object
        elif kind == "data":
            array = memory(value, _element(command, parameter, names.get("type")))
            arrays.append(array)
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


def _element(command: Command, parameter: str, kind: Any) -> Any:
    """The numpy type of an array argument; None: that of the array itself."""
    if (command.name, parameter) in BYTES or kind in (gl.GL_2_BYTES, gl.GL_3_BYTES, gl.GL_4_BYTES, gl.GL_BITMAP):
        return np.uint8
    if parameter in ELEMENTS:
        return ELEMENTS[parameter]
    if command.name in ("glBufferData", "glBufferSubData"):
        return None
    if kind in PACKED:
        return PACKED[kind][0]
    return DTYPES.get(SUFFIXES[command.type] if command.type else kind, np.float32)


def memory(value: Any, dtype: Any) -> NDArray[Any]:
    """What a program passed, as memory of numbers of a type."""
    array = raw_bytes(value)
    if array is not None:
        return array
    if dtype is None and not hasattr(value, "dtype"):
        dtype = np.float32
    return np.ascontiguousarray(value, dtype)
