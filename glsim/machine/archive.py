"""A Frame as a file, and back: numbers and names, never code.

The file is an npz archive of two entries: ``document``, JSON text, and ``bytes``, the memory of all arrays.  The
document is a list of nodes, each [kind, item, item, ...]: a Draw, a Matrix, a tuple, an array, ...  An item is a
number, a text, true, false, null, or [k], the node with number k, which stands before this one.  What a Frame shares
(the state of a hundred draws, say) is one node.

The program that wrote the file is not trusted.  Therefore nothing is unpickled, only the kinds listed here are built,
each field must have the type that its class declares, and arrays must have the shapes that the renderer relies on.
"""

from __future__ import annotations

import io
import json
import os
import types
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any, Union, get_args, get_origin, get_type_hints

import numpy as np

from glsim.files import read_regular, write_atomically
from glsim.machine import state
from glsim.machine.constants import Enum
from glsim.machine.frame import (
    ROW,
    Accum,
    Call,
    Clear,
    Draw,
    Frame,
    Moment,
    Pixels,
    Query,
    QueryMark,
    Vertices,
    Where,
)
from glsim.machine.matrix import Matrix, leaf
from glsim.machine.pixels import PixelMode, PixelStore
from glsim.machine.texture import BASE_FORMATS, Image, Images, Sampler, Texture

MOST_BYTES = 1 << 30  # of a file
LARGEST_PICTURE = 16384
VERSION = 1
CONTAINERS = (Union, types.UnionType, tuple, list, dict)  # types that are made of others

# What is written field by field.
RECORDS: dict[str, type] = {
    record.__name__: record
    for record in (
        *(group for group in vars(state).values() if isinstance(group, type) and hasattr(group, "_fields")),
        PixelMode, PixelStore, Clear, Pixels, Accum, QueryMark, Where, Call, Moment, Image, Sampler, Texture, Frame,
    )
}  # fmt: skip
DRAW = (
    "mode", "first", "count", "indices", "matrices", "material", "state", "vertices", "color", "call", "trail",
)  # fmt: skip


# ---------------------------------------------------------------- writing


def save(frame: Frame, path: str | os.PathLike[str]) -> None:
    """Write ``frame`` to ``path``."""
    writer = _Writer()
    writer.item(frame)
    document = json.dumps({"version": VERSION, "nodes": writer.nodes}, separators=(",", ":")).encode()
    text, memory = (np.frombuffer(data, np.uint8) for data in (document, writer.memory.getbuffer()))

    def write(name: str) -> None:
        with open(name, "wb") as file:
            np.savez(file, document=text, bytes=memory)

    write_atomically(path, write)


class _Writer:
    def __init__(self) -> None:
        self.nodes: list[list[Any]] = []
        self.memory = io.BytesIO()
        self.known: dict[int, tuple[list[int], Any]] = {}  # id -> item, value (held: its id stays unique)

    def item(self, value: Any) -> Any:
        """The item for a value: the value itself if it is simple, else [number] of its node, which is added if new."""
        kind = type(value)
        if value is None or kind in (bool, int, float, str):
            return value
        if isinstance(value, np.generic):
            return value.item() if value.dtype.kind in "biuf" else repr(value)
        found = self.known.get(id(value))
        if found is None:
            node = self.node(value)
            found = [len(self.nodes)], value
            self.nodes.append(node)
            self.known[id(value)] = found
        return found[0]

    def node(self, value: Any) -> list[Any]:
        kind = type(value)
        name = kind.__name__
        if kind in (tuple, list):
            return [name, *map(self.item, value)]
        if RECORDS.get(name) is kind:
            return [name, *(self.item(getattr(value, field)) for field in _fields(RECORDS[name]))]
        if kind is dict:
            return ["dict", *(self.item(part) for pair in value.items() for part in pair)]
        if kind is Enum:
            return ["Enum", value.name, int(value)]
        if kind is np.ndarray and value.dtype.kind in "biuf":
            return ["array", value.dtype.newbyteorder("<").str, list(value.shape), self.store(value)]
        if kind in (bytes, bytearray):
            return ["bytes", len(value), self.store(np.frombuffer(value, np.uint8))]
        if kind is Matrix:
            return ["Matrix", self.item(value.get())]
        if kind is Vertices:
            return ["Vertices", *map(self.item, (value.rows, value.columns, list(value.materials), value.static))]
        if kind is Draw:
            return ["Draw", *(self.item(getattr(value, field)) for field in DRAW)]
        if kind is Images:
            return ["Images", self.item(value.by_level)]
        if kind is Query:
            return ["Query", value.result]
        return ["text", repr(value)[:200]]  # an argument that is no number: a gl command refused it, or will

    def store(self, array: np.ndarray) -> int:
        """Where in the entry ``bytes`` the memory of an array begins."""
        self.memory.write(bytes(-self.memory.tell() % 16))
        start = self.memory.tell()
        self.memory.write(np.ascontiguousarray(array, array.dtype.newbyteorder("<")).tobytes())
        return start


@cache
def _fields(record: Any) -> tuple[str, ...]:
    return tuple(f.name for f in fields(record)) if is_dataclass(record) else tuple(record._fields)


# ---------------------------------------------------------------- reading


def load(path: str | os.PathLike[str]) -> Frame:
    """The Frame that ``save`` wrote.  Raises ValueError for every other file."""
    try:
        document, memory = _entries(read_regular(path, MOST_BYTES))
        frame = _Reader(memory).read(document)
    except (ValueError, TypeError, KeyError, IndexError, OverflowError, RecursionError, zipfile.BadZipFile) as error:
        raise ValueError(f"{Path(path).name} is no Frame that glsim wrote: {error}") from None
    if not isinstance(frame, Frame):
        raise ValueError(f"{Path(path).name} is no Frame that glsim wrote: it holds {type(frame).__name__}")
    return frame


def _entries(data: bytes) -> tuple[Any, np.ndarray]:
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        entries = archive.infolist()
        if any(e.compress_type != zipfile.ZIP_STORED or e.file_size > len(data) for e in entries) or len(entries) != 2:
            raise ValueError("two entries that are not compressed are expected")
    with np.load(io.BytesIO(data), allow_pickle=False) as archive:
        text, memory = archive["document"], archive["bytes"]
    if any(array.dtype != np.uint8 or array.ndim != 1 for array in (text, memory)):
        raise ValueError("its entries are not bytes")
    document = json.loads(text.tobytes())
    if not isinstance(document, dict) or document.get("version") != VERSION:
        raise ValueError(f"version {VERSION} of the format is expected")
    return document, memory


class _Reader:
    def __init__(self, memory: np.ndarray) -> None:
        self.memory = memory
        self.values: list[Any] = []
        self.builders: dict[str, Callable[..., Any]] = {
            "tuple": lambda *items: items,
            "list": lambda *items: list(items),
            "dict": lambda *items: dict(zip(items[::2], items[1::2], strict=True)),
            "Enum": self._enum, "bytes": self._bytes, "text": lambda text: text,
            "Matrix": _matrix, "Vertices": _vertices, "Draw": _draw, "Images": _images, "Query": _query,
            **{name: _builder(record) for name, record in RECORDS.items()},
        }  # fmt: skip

    def read(self, document: Any) -> Any:
        """The value of the last node."""
        values = self.values
        for kind, *items in document["nodes"]:
            if kind == "array":
                values.append(self._array(*items))
                continue
            values.append(self.builders[kind](*[self._value(i) if type(i) is list else i for i in items]))
        return values[-1]

    def _value(self, reference: list[Any]) -> Any:
        (number,) = reference
        if not 0 <= number < len(self.values):
            raise ValueError("a node refers to a later one")
        return self.values[number]

    def _enum(self, name: str, value: int) -> Enum:
        expect(isinstance(name, str) and type(value) is int, "a constant has a name and a number")
        return Enum(name, value)

    def _bytes(self, length: int, start: int) -> bytes:
        return self._memory(length, start).tobytes()

    def _array(self, dtype: str, shape: list[int], start: int) -> np.ndarray:
        kind = np.dtype(dtype)
        expect(kind.kind in "biuf" and kind.itemsize <= 8, "arrays hold numbers")
        expect(all(type(n) is int and 0 <= n <= MOST_BYTES for n in shape) and len(shape) <= 8, "arrays have a shape")
        length = kind.itemsize
        for n in shape:
            length *= n
        return self._memory(length, start).view(kind).reshape(shape).astype(kind.newbyteorder("="))

    def _memory(self, length: int, start: int) -> np.ndarray:
        whole = type(length) is int and type(start) is int
        expect(whole and 0 <= start <= start + length <= len(self.memory), "arrays lie inside of the file")
        return self.memory[start : start + length]


def expect(holds: bool, sentence: str) -> None:
    if not holds:
        raise ValueError(f"{sentence}; this one does not")


def _builder(record: type) -> Callable[..., Any]:
    """A function (*fields) -> record, which raises ValueError unless each field has the declared type."""
    hints = get_type_hints(record)
    names = _fields(record)
    declared = [hints[name] for name in names]
    tests = [_test_of(hint) for hint in declared]
    defaults = getattr(record, "_field_defaults", {})
    lengths = [len(d) if isinstance(d := defaults.get(name), tuple) else None for name in names]
    check = CHECKS.get(record.__name__, lambda made: None)

    def build(*items: Any) -> Any:
        expect(len(items) == len(names), f"{record.__name__} has {len(names)} fields")
        for name, value, hint, test, length in zip(names, items, declared, tests, lengths, strict=True):
            whole = length is None or len(value) == length
            if not (whole and test(value)):
                expect(False, f"{record.__name__}.{name} is of the type {hint}")
        made = record(*items)
        check(made)
        return made

    return build


def fits(value: Any, hint: Any) -> bool:
    """Whether a value is of a type as annotations write it."""
    return _test_of(hint)(value)


@cache
def _test_of(hint: Any) -> Callable[[Any], bool]:
    """A function (value) -> whether it is of the type ``hint``; a Frame asks it for each of its thousands of fields."""
    if hint is Any:
        return lambda value: True
    if hint is float:
        return lambda value: isinstance(value, (int, float))
    origin, inner = get_origin(hint), get_args(hint)
    tests = [_test_of(one) for one in inner if one is not Ellipsis] if origin in CONTAINERS else []
    if origin in (Union, types.UnionType):
        return lambda value: any(test(value) for test in tests)
    if origin is tuple and inner[-1] is not Ellipsis:
        return lambda value: (
            isinstance(value, tuple)
            and len(value) == len(tests)
            and all(test(item) for test, item in zip(tests, value, strict=True))
        )
    if origin in (tuple, list):
        return lambda value: isinstance(value, origin) and all(map(tests[0], value))
    if origin is dict:
        return lambda value: (
            isinstance(value, dict) and all(map(tests[0], value)) and all(map(tests[1], value.values()))
        )
    return lambda value: isinstance(value, hint if origin is None else origin)


# ---------------------------------------------------------------- shapes that the renderer relies on


def _matrix(value: Any) -> Matrix:
    expect(_is_array(value, np.float32, (4, 4)), "a matrix is (4, 4) float32")
    return leaf(value)


def _is_array(value: Any, dtype: Any, shape: Sequence[int | None]) -> bool:
    """shape: None where any length will do."""
    if not isinstance(value, np.ndarray) or value.dtype != dtype or value.ndim != len(shape):
        return False
    return all(wanted in (None, length) for wanted, length in zip(shape, value.shape, strict=True))


def _vertices(rows: Any, columns: Any, materials: Any, static: Any) -> Vertices:
    expect(_is_array(rows, np.float32, (None, ROW)), f"vertices are (n, {ROW}) float32")
    expect(isinstance(static, bool) and fits(columns, dict[str, np.ndarray]), "attributes are arrays by name")
    for column in columns.values():
        fitting = _is_array(column, np.float32, (None, None)) and len(column) in (1, len(rows))
        expect(fitting, "an attribute has a row for each vertex or one for all")
    expect(fits(materials, list[tuple[int, state.Material]]), "materials stand beside the vertex they begin at")
    return Vertices(rows, columns, materials, static)


DRAW_TYPES: dict[str, Any] = {
    "mode": int, "first": int, "count": int, "indices": np.ndarray | None, "matrices": tuple[Matrix, ...],
    "material": state.Material, "state": state.Snapshot, "vertices": Vertices, "color": state.Color | None,
    "call": int | None, "trail": tuple[tuple[int, int], ...],
}  # fmt: skip


def _draw(*items: Any) -> Draw:
    expect(len(items) == len(DRAW), f"Draw has {len(DRAW)} fields")
    for name, value in zip(DRAW, items, strict=True):
        expect(fits(value, DRAW_TYPES[name]), f"Draw.{name} is of the type {DRAW_TYPES[name]}")
    draw = Draw(*items[:8])
    draw.color, draw.call, draw.trail = items[8:]
    expect(0 <= draw.mode <= 9, "Draw.mode is a primitive")
    expect(3 <= len(draw.matrices) <= 2 + state.TEXTURE_UNITS, "a Draw has its matrices")
    expect(0 <= draw.first <= draw.first + draw.count <= len(draw.block.rows), "vertices exist")
    if draw.indices is not None:
        expect(_is_array(draw.indices, np.uint32, (None,)), "indices are uint32")
        expect(not len(draw.indices) or int(draw.indices.max()) < draw.count, "vertices exist")
    return draw


def _images(by_level: Any) -> Images:
    expect(fits(by_level, dict[tuple[int, int], Image]), "images of a texture go by face and level")
    return Images(by_level)


def _query(result: Any) -> Query:
    expect(result is None or type(result) is int, "the result of a query is a number")
    query = Query()
    query.result = result
    return query


def _check_frame(frame: Frame) -> None:
    sizes = (frame.width, frame.height)
    expect(all(1 <= n <= LARGEST_PICTURE for n in sizes), f"a picture has 1 to {LARGEST_PICTURE} pixels a side")


def _check_image(image: Image) -> None:
    expect(image.internal_format in BASE_FORMATS, "an image has an internal format")
    texels = image.texels
    depth, color = _rectangle(texels, 1, np.float32), _rectangle(texels, 4, np.uint8)
    expect(depth or color, "texels are colours of 8 bits or depths")


def _check_pixels(packet: Pixels) -> None:
    expect(packet.kind in ("color", "depth", "stencil", "bitmap"), "pixels are of some kind")
    expect((packet.image is None) != (packet.copied is None), "pixels are an image or copied")
    if packet.image is not None:
        expect(packet.image.ndim == 3 and packet.image.shape[-1] == (4 if packet.kind == "color" else 1), "pixels fit")


def _rectangle(texels: np.ndarray, components: int, dtype: Any) -> bool:
    return texels.dtype == dtype and texels.ndim in (3, 4) and texels.shape[-1] == components


CHECKS: dict[str, Callable[[Any], None]] = {"Frame": _check_frame, "Image": _check_image, "Pixels": _check_pixels}
