"""Who set what: for each piece of state the call, with the user's line, that set it last.

A path such as ("lighting", "lights", 0, "position") names a piece of state: fields of machine.state.Snapshot, or
("material", "front", "diffuse").  Whether a call sets a path, even to the value it had, is found by running it again on
a machine whose every piece of state is an object of its own: what is another object afterwards was set.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine.commands import COMMANDS
from glsim.machine.constants import (
    GL_ACCUM_BUFFER_BIT,
    GL_COLOR_BUFFER_BIT,
    GL_COMPILE,
    GL_DEPTH_BUFFER_BIT,
    GL_MODELVIEW,
    GL_PROJECTION,
    GL_STENCIL_BUFFER_BIT,
    GL_TEXTURE,
)
from glsim.machine.current import current_machine, make_current
from glsim.machine.errors import GLError
from glsim.machine.frame import Call, Frame, Moment
from glsim.machine.machine import Machine
from glsim.machine.matrix import leaf
from glsim.machine.record import REGISTERS_ONLY, implementations
from glsim.machine.state import Material, Snapshot

Path = tuple[str | int, ...]
BEFORE = -1  # in place of a call: it was set before the recording began

# They set state as it was at another time, or what their lists say: only what they change is theirs.
RESTORING = {"glPopAttrib", "glPushAttrib", "glCallList", "glCallLists"}
# Families that set pieces of a Snapshot or of the material from their arguments.
SETTING = {
    "glActiveTexture", "glAlphaFunc", "glBindTexture", "glBlendColor", "glBlendEquation", "glBlendFunc",
    "glBlendFuncSeparate", "glClearColor", "glClearDepth", "glClearStencil", "glClipPlane", "glColorMask",
    "glColorMaterial", "glCullFace", "glDepthFunc", "glDepthMask", "glDepthRange", "glDisable", "glDrawBuffer",
    "glEnable", "glFog", "glFrontFace", "glLight", "glLightModel", "glLineStipple", "glLineWidth", "glLogicOp",
    "glMaterial", "glMatrixMode", "glPointParameter", "glPointSize", "glPolygonMode", "glPolygonOffset",
    "glPolygonStipple", "glSampleCoverage", "glScissor", "glShadeModel", "glStencilFunc", "glStencilMask",
    "glStencilOp", "glTexEnv", "glTexGen", "glViewport",
}  # fmt: skip
MULTIPLYING = {"glMultMatrix", "glMultTransposeMatrix", "glTranslate", "glScale", "glRotate", "glFrustum", "glOrtho"}
LOADING = {"glLoadIdentity", "glLoadMatrix", "glLoadTransposeMatrix"}


class _Integer(int):
    pass


class _Float(float):
    pass


def _own(value: Any) -> Any:
    """An equal value made of objects that nobody else holds."""
    if hasattr(value, "_fields"):
        return type(value)._make(map(_own, value))
    if isinstance(value, tuple):
        return tuple(map(_own, value)) if value and not _is_leaf(value) else (*value,)
    if isinstance(value, int):
        return _Integer(value)
    return _Float(value) if isinstance(value, float) else value


def _is_leaf(value: tuple[Any, ...]) -> bool:
    """Colours and positions are one piece of state; tuples of groups or of switches have a piece for each."""
    return isinstance(value[0], float) or (isinstance(value[0], int) and not isinstance(value[0], bool))


def _paths(old: Any, new: Any, same: Any, path: Path = ()) -> Iterator[Path]:
    """The pieces in which two states differ."""
    if old is new:
        return
    if hasattr(old, "_fields"):
        for name, a, b in zip(old._fields, old, new, strict=True):
            yield from _paths(a, b, same, (*path, name))
    elif isinstance(old, tuple) and isinstance(new, tuple) and len(old) == len(new) and old and not _leaf_pair(old):
        for k, (a, b) in enumerate(zip(old, new, strict=True)):
            yield from _paths(a, b, same, (*path, k))
    elif not same(old, new):
        yield path


def _leaf_pair(value: tuple[Any, ...]) -> bool:
    return isinstance(value[0], float) or (isinstance(value[0], int) and type(value[0]) not in (bool, _Integer))


def changed(old: Moment, new: Moment) -> list[Path]:
    """The pieces of state whose values differ."""
    return [
        *_paths(old.state, new.state, operator.eq),
        *_paths(old.material, new.material, operator.eq, ("material",)),
    ]


def value_at(state: Snapshot, material: Material, path: Path) -> Any:
    """The piece of state that a path names."""
    value: Any = material if path[0] == "material" else state
    for part in path[1:] if path[0] == "material" else path:
        value = value[part] if isinstance(part, int) else getattr(value, part)
    return value


class _NoDevice:
    width = height = 1


class _Scratch:
    """Runs single calls on a machine of its own."""

    def __init__(self) -> None:
        self.machine = Machine(_NoDevice())  # type: ignore[arg-type]

    def sets(self, call: Call, before: Moment) -> list[Path]:
        m = self.machine
        state, material = _own(before.state), _own(before.material)
        for name, group in zip(Snapshot._fields, state, strict=True):
            setattr(m, name, group)
        m.material, m.inside, m.busy = material, None, False
        m.modelview[-1] = leaf(before.matrices[0].get())
        current = current_machine()
        make_current(m)
        try:
            implementations[call.name](*call.arguments)
        except (GLError, TypeError, ValueError, IndexError, KeyError, OverflowError, NotImplementedError):
            return []
        finally:
            make_current(current if isinstance(current, Machine) else None)
        after = Snapshot(*(getattr(m, name) for name in Snapshot._fields))
        same = operator.is_
        return [*_paths(state, after, same), *_paths(material, m.material, same, ("material",))]


class Placed(NamedTuple):
    """What was fixed in eye space by a call: the modelview then, (4, 4) column first, and the calls that made it."""

    modelview: NDArray[np.float32]
    chain: tuple[int, ...]


@dataclass
class Provenance:
    """Who set what, as of one call.

    setters: for each path the number of the call that set it last; a path that is not there has its initial value.
    through: for paths set inside of a display list, the glCallList.  chains: for "modelview", "projection" and
    "texture0" to "texture3" the stack of the calls whose product each matrix is.  placed: lights, spots and planes.
    registers: for "glColor", "glNormal", ... the last call of that family.
    """

    setters: dict[Path, int] = field(default_factory=dict)
    through: dict[Path, int] = field(default_factory=dict)
    chains: dict[str, list[list[int]]] = field(default_factory=dict)
    placed: dict[Path, Placed] = field(default_factory=dict)
    registers: dict[str, int] = field(default_factory=dict)


class History:
    """Walks through the calls of a frame once; ``upto`` gives the provenance after each call in turn."""

    def __init__(self, frame: Frame) -> None:
        if not frame.history:
            raise ValueError("the calls of this frame were not recorded: use capture(calls=True)")
        self.frame = frame
        self.moments = {moment.call: moment for moment in frame.history}
        self.scratch = _Scratch()
        self.known: dict[tuple[Any, ...], list[Path]] = {}

    def walk(self) -> Iterator[tuple[int, Call, Moment, Moment, list[Path], Provenance]]:
        """For each call: its number, itself, the state before and after, the paths it set, and the provenance after it.

        The provenance is one object that goes on changing.
        """
        found = Provenance()
        first = self.frame.history[0]
        for name, matrix in zip(NAMES, first.matrices, strict=True):
            untouched = np.array_equal(matrix.get(), np.eye(4, dtype=np.float32))
            found.chains[name] = [[] if untouched else [BEFORE]]
        for path in _paths(INITIAL, first.state, operator.eq):
            if path[-2] != "bound":  # every machine has texture objects of its own
                found.setters[path] = BEFORE
        saved: list[dict[Path, int]] = []
        lists: dict[int, list[int]] = {}
        compiling: list[int] | None = None
        executing = True
        before = first
        start = first.call + 1
        for number, call in enumerate(self.frame.calls[start:], start):
            after = self.moments.get(number, before)
            if call.name == "glNewList":
                compiling, executing = lists.setdefault(int(call.arguments[0]), []), call.arguments[1] != GL_COMPILE
                compiling.clear()
            elif call.name == "glEndList":
                compiling, executing = None, True
            elif compiling is not None:
                compiling.append(number)
            paths: list[Path] = []
            if executing or not COMMANDS[call.name].listed:
                paths = self._sets(call, before, after)
                self._apply(found, number, call, before, after, paths, saved)
                if call.name == "glCallList":
                    self._inside(found, number, lists.get(int(call.arguments[0]), []), before, paths)
            yield number, call, before, after, paths, found
            before = after

    def upto(self, number: int) -> Provenance:
        """Who had set what after call ``number``."""
        last = Provenance()
        for at, *_, found in self.walk():
            last = found
            if at >= number:
                break
        return last

    def _sets(self, call: Call, before: Moment, after: Moment) -> list[Path]:
        if call.name in REGISTERS_ONLY:
            return []
        paths = changed(before, after) if after is not before else []
        family = COMMANDS[call.name].family
        if family not in SETTING:
            return paths
        return list(dict.fromkeys(paths + self.scratch.sets(call, before)))

    def _apply(
        self, found: Provenance, number: int, call: Call, before: Moment, after: Moment, paths: list[Path],
        saved: list[dict[Path, int]],
    ) -> None:  # fmt: skip
        family = COMMANDS[call.name].family
        if call.name in REGISTERS_ONLY:
            found.registers[family] = number
            return
        if call.name == "glPushAttrib":
            saved.append(dict(found.setters))
        old = saved.pop() if call.name == "glPopAttrib" and saved else None
        for path in paths:
            found.through.pop(path, None)
            if old is None:
                found.setters[path] = number
            elif path in old:
                found.setters[path] = old[path]  # glPopAttrib brings back what an earlier call set
            else:
                found.setters.pop(path, None)
            if path[-1] in ("position", "spot_direction", "eye_plane") or path[:2] == ("transform", "clip_planes"):
                chain = found.chains["modelview"][-1]
                found.placed[path] = Placed(before.matrices[0].get(), tuple(chain))
        self._matrices(found, number, call, before, after)

    def _matrices(self, found: Provenance, number: int, call: Call, before: Moment, after: Moment) -> None:
        mode = before.state.transform.matrix_mode
        unit = before.state.texture.active_unit
        name = {GL_MODELVIEW: "modelview", GL_PROJECTION: "projection", GL_TEXTURE: f"texture{unit}"}[mode]  # type: ignore[index]
        stack = found.chains[name]
        family = COMMANDS[call.name].family
        if family == "glPushMatrix" and after is not before:
            stack.append(list(stack[-1]))
        elif family == "glPopMatrix" and len(stack) > 1:
            stack.pop()
        elif family in LOADING:
            stack[-1] = [number]
        elif family in (
            "glMultMatrix",
            "glMultTransposeMatrix",
            "glTranslate",
            "glScale",
            "glRotate",
            "glFrustum",
            "glOrtho",
        ):
            stack[-1] = [*stack[-1], number]
        elif call.name in RESTORING and after is not before:  # a list that moved things
            for which, a, b in zip(NAMES, before.matrices, after.matrices, strict=True):
                if a is not b:
                    found.chains[which][-1] = [*found.chains[which][-1], number]

    def _inside(self, found: Provenance, number: int, calls: list[int], before: Moment, paths: list[Path]) -> None:
        """What a display list set is the work of the calls in it."""
        for at in calls:
            call = self.frame.calls[at]
            if COMMANDS[call.name].family in SETTING:
                for path in self.scratch.sets(call, before):
                    found.setters[path], found.through[path] = at, number


BUFFER_BITS = (GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT, GL_ACCUM_BUFFER_BIT)
NAMES = ("modelview", "projection", "texture0", "texture1", "texture2", "texture3")
INITIAL = Snapshot._make(getattr(Machine(_NoDevice()), name) for name in Snapshot._fields)  # type: ignore[arg-type]


def call_text(call: Call) -> str:
    """A call as it would be written, at most a line."""
    via = f"{call.where.via}: " if call.where is not None and call.where.via else ""
    words = ", ".join(_argument(argument) for argument in call.arguments if argument is not None)
    if call.name == "glClear":
        names = [repr(bit) for bit in BUFFER_BITS if int(call.arguments[0]) & bit]
        words = " | ".join(names) or words
    text = f"{via}{call.name}({words})"
    return text if len(text) <= 110 else text[:107] + "..."


def _argument(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"array of shape {value.shape}" if value.size > 16 else _argument(value.ravel().tolist())
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_argument, value)) + "]"
    if isinstance(value, float):
        return f"{value:.6g}"
    return f"{len(value)} bytes" if isinstance(value, (bytes, bytearray)) else repr(value)
