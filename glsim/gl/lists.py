"""Display lists: section 5.4 of the specification."""

from __future__ import annotations

import builtins
from typing import Any, NamedTuple

import numpy as np

from glsim.gl.naming import free_name
from glsim.machine import constants as gl
from glsim.machine.commands import COMMANDS
from glsim.machine.errors import GLError, invalid_enum, invalid_operation, invalid_value, out_of_memory
from glsim.machine.frame import Call, Draw
from glsim.machine.geometry import Geometry
from glsim.machine.machine import MAX_LIST_NESTING, MOST_NAMES, Machine
from glsim.machine.pixels import PixelStore
from glsim.machine.record import ARRAY_CALLS, ListRecorder, implementations

STATIC_FAMILIES = {
    "glBegin", "glEnd", "glVertex", "glNormal", "glColor", "glTexCoord", "glMultiTexCoord", "glSecondaryColor",
    "glFogCoord", "glEdgeFlag", "glEdgeFlagv", "glRect", *ARRAY_CALLS,
}  # fmt: skip
STATIC = {name for name, command in COMMANDS.items() if command.family in STATIC_FAMILIES}
DRAWING = {"glEnd", "glRect", *ARRAY_CALLS} - {"glArrayElement"}


INITIAL_STORE = PixelStore()  # while a list is executed: it holds its pixels as they are


class Unpacking(NamedTuple):
    """A call whose pixels lie in memory as glPixelStore said when the list was compiled."""

    call: Call
    store: PixelStore


Item = tuple[int, Geometry | Call | Unpacking]  # with the number of the last call in it


def glNewList(m: Machine, n: int, mode: int) -> None:
    if n <= 0:
        raise invalid_value("n", n, "the number of a list, more than 0")
    if mode not in (gl.GL_COMPILE, gl.GL_COMPILE_AND_EXECUTE):
        raise invalid_enum("mode", mode, "GL_COMPILE or GL_COMPILE_AND_EXECUTE")
    if m.compiling is not None:
        raise invalid_operation(f"list {m.compiling.number} has no glEndList yet")
    m.compiling = ListRecorder(m, int(n), mode == gl.GL_COMPILE_AND_EXECUTE)
    m.record(m.compiling)


def glEndList(m: Machine) -> None:
    if m.compiling is None:
        raise invalid_operation("there is no glNewList before this glEndList")
    recorder, m.compiling = m.compiling, None
    m.objects.lists[recorder.number] = compile_list(recorder)
    m.record(recorder.outer)


def compile_list(recorder: ListRecorder) -> list[Item]:
    """Runs of calls that only make vertices become Geometry; the rest stays calls."""
    items: list[Item] = []
    run: list[int] = []  # positions of glBegin, glEnd, glRect, ... since ``first``
    first = 0
    for position in recorder.others:
        name, arguments = recorder.calls[position]
        if name in STATIC:
            run.append(position)
            continue
        items += _compiled(recorder, first, position, run)
        run, first = [], position + 1
        store = recorder.stores.get(position, INITIAL_STORE)
        call = Call(name, arguments)
        items.append((position, call if store == INITIAL_STORE else Unpacking(call, store)))
    return items + _compiled(recorder, first, len(recorder.calls), run)


def _compiled(recorder: ListRecorder, first: int, end: int, run: list[int]) -> list[Item]:
    """One Geometry if the calls ``first`` to ``end`` - 1 draw whole primitives without an error, else the calls.

    run: the positions of those that are not called once a vertex.
    """
    calls = recorder.calls[first:end]
    names = [recorder.calls[position][0] for position in run]
    brackets = [name for name in names if name in ("glBegin", "glEnd")]
    balanced = brackets == ["glBegin", "glEnd"] * (len(brackets) // 2)
    if balanced and any(COMMANDS[name].family in DRAWING for name in names):
        try:
            return [(end - 1, Geometry(calls, recorder.clients, first))]
        except (GLError, TypeError, ValueError):
            pass  # errors come when the list is called, as the specification says
    return [(first + k, Call(*call)) for k, call in enumerate(calls)]


def glCallList(m: Machine, n: int) -> None:
    """A list that does not exist is ignored, as is what lies deeper than GL_MAX_LIST_NESTING."""
    items = m.objects.lists.get(int(n))
    if items is None or m.nesting >= MAX_LIST_NESTING:
        return
    m.nesting += 1
    store, m.stores.unpack = m.stores.unpack, INITIAL_STORE
    try:
        for position, item in items:
            drawn = len(m.packets)
            if type(item) is Geometry and m.inside is None:
                item.call(m)
            elif type(item) is Call:
                implementations[item.name](*item.arguments)
            elif type(item) is Unpacking:
                m.stores.unpack = item.store
                implementations[item.call.name](*item.call.arguments)
                m.stores.unpack = INITIAL_STORE
            else:
                raise invalid_operation(f"list {n} begins a primitive of its own")
            if m.outlet.frame is not None:
                for packet in m.packets[drawn:]:
                    if type(packet) is Draw:
                        packet.trail = ((n, position), *packet.trail)
        if m.nesting == 1:
            m.relieve()
    finally:
        m.nesting -= 1
        m.stores.unpack = store


LIST_TYPES: dict[int, str] = {
    gl.GL_BYTE: "i1", gl.GL_UNSIGNED_BYTE: "u1", gl.GL_SHORT: "i2", gl.GL_UNSIGNED_SHORT: "u2", gl.GL_INT: "i4",
    gl.GL_UNSIGNED_INT: "u4", gl.GL_FLOAT: "f4", gl.GL_2_BYTES: "2", gl.GL_3_BYTES: "3", gl.GL_4_BYTES: "4",
}  # fmt: skip


def glCallLists(m: Machine, n: Any, type: int | None = None, lists: Any = None) -> None:
    """glCallLists(n, type, lists), or in PyOpenGL's form glCallLists(lists) with a string, bytes or array."""
    if type is not None and n < 0:
        raise invalid_value("n", n, "at least 0")
    if type is not None and type not in LIST_TYPES:
        raise invalid_enum("type", type, "GL_BYTE, GL_UNSIGNED_BYTE, ... or GL_4_BYTES")
    for number in numbers_called(m.list_base, n, type, lists):
        glCallList(m, number)


def numbers_called(base: int, n: Any, type: int | None = None, lists: Any = None) -> list[int]:
    """The lists that glCallLists calls."""
    numbers = _numbers(n, None) if type is None else _numbers(lists, type)[:n]
    return [(base + number) & 0xFFFFFFFF for number in numbers]


def _numbers(lists: Any, kind: int | None) -> list[int]:
    if isinstance(lists, str):
        lists = lists.encode("latin-1")
    form = LIST_TYPES[kind] if kind is not None else "u1"
    if form.isdigit():  # several bytes make a number, the first the most significant
        raw = np.frombuffer(bytes(lists), np.uint8) if isinstance(lists, (bytes, bytearray)) else np.asarray(lists)
        size = int(form)
        rows = raw.astype(np.int64).reshape(-1)[: len(raw.reshape(-1)) // size * size].reshape(-1, size)
        return [int(sum(int(b) << (8 * (size - 1 - k)) for k, b in enumerate(row))) for row in rows]
    if isinstance(lists, (bytes, bytearray)):
        return np.frombuffer(bytes(lists), form).astype(np.int64).tolist()  # type: ignore[no-any-return]
    return np.asarray(lists).astype(form if kind is not None else np.int64).astype(np.int64).ravel().tolist()


def glListBase(m: Machine, base: int) -> None:
    m.list_base = int(base)


def glGenLists(m: Machine, s: int) -> int:
    """The first of ``s`` unused numbers in a row; they become empty lists."""
    if s < 0:
        raise invalid_value("s", s, "at least 0")
    if s > MOST_NAMES:
        raise out_of_memory(f"{s} display lists are more than the {MOST_NAMES} that can be")
    if s == 0:
        return 0
    first = name = m.objects.lowest.get("lists", 1)
    while name < first + s:
        if name in m.objects.lists:
            first = name + 1
        name += 1
    if first == m.objects.lowest.get("lists", 1):
        m.objects.lowest["lists"] = first + s
    m.objects.lists.update({number: [] for number in range(first, first + s)})
    return first


def glDeleteLists(m: Machine, list: int, range: int) -> None:
    if range < 0:
        raise invalid_value("range", range, "at least 0")
    few = builtins.range(list, list + range) if range < len(m.objects.lists) else m.objects.lists
    for number in [number for number in few if number in m.objects.lists and list <= number < list + range]:
        del m.objects.lists[number]
        free_name(m, "lists", number)


def glIsList(m: Machine, list: int) -> int:
    return int(int(list) in m.objects.lists)
