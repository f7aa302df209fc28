"""Who set what: for each piece of state the call, with the user's line, that set it last.

A path such as ("lighting", "lights", 0, "position") names a piece of state: fields of machine.state.Snapshot, or
("material", "front", "diffuse").

A call may set a piece of state to the value that it has already.  Comparing values does not show that, so the call is
made again on a second machine, whose state is a copy in which every piece is an object that nothing else refers to.
Whatever is another object after the call was set by it:

    piece = _distinct_copy((0.2, 0.2, 0.2, 1.0))  # an equal tuple, but not the same object
    state = Lighting(ambient=piece)
    ... the machine runs glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.2, 0.2, 0.2, 1.0]) ...
    state.ambient == piece                  # True: the value has not changed
    state.ambient is piece                  # False: so this call set ("lighting", "ambient")
"""

from __future__ import annotations

import operator
from collections.abc import Generator, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.gl.lists import numbers_called
from glsim.machine import constants as gl
from glsim.machine.commands import COMMANDS
from glsim.machine.current import driving
from glsim.machine.device import NoDevice
from glsim.machine.errors import GLError
from glsim.machine.frame import Call, Frame, Moment, Trail
from glsim.machine.machine import MAX_LIST_NESTING, Machine
from glsim.machine.matrix import leaf
from glsim.machine.record import REGISTERS_ONLY, implementations, moment
from glsim.machine.state import Material, Snapshot

Path = tuple[str | int, ...]
BEFORE = -1  # in place of a call: it was set before the recording began

# Families that set pieces of a Snapshot or of the material from their arguments.
SETTER_FAMILIES = {
    "glActiveTexture", "glAlphaFunc", "glBindTexture", "glBlendColor", "glBlendEquation", "glBlendFunc",
    "glBlendFuncSeparate", "glClearColor", "glClearDepth", "glClearStencil", "glClipPlane", "glColorMask",
    "glColorMaterial", "glCullFace", "glDepthFunc", "glDepthMask", "glDepthRange", "glDisable", "glDrawBuffer",
    "glEnable", "glFog", "glFrontFace", "glHint", "glLight", "glLightModel", "glLineStipple", "glLineWidth",
    "glLogicOp", "glMaterial", "glMatrixMode", "glPointParameter", "glPointSize", "glPolygonMode", "glPolygonOffset",
    "glPolygonStipple", "glSampleCoverage", "glScissor", "glShadeModel", "glStencilFunc", "glStencilMask",
    "glStencilOp", "glTexEnv", "glTexGen", "glViewport",
}  # fmt: skip
MULTIPLY_FAMILIES = {
    "glMultMatrix", "glMultTransposeMatrix", "glTranslate", "glScale", "glRotate", "glFrustum", "glOrtho",
}  # fmt: skip
LOAD_FAMILIES = {"glLoadIdentity", "glLoadMatrix", "glLoadTransposeMatrix"}
CALLING = ("glCallList", "glCallLists")
# families of calls that are repeated to follow a display list: all that change state, none that draw
STACKS = {"glPushMatrix", "glPopMatrix", "glPushAttrib", "glPopAttrib"}
REPLAYED = SETTER_FAMILIES | MULTIPLY_FAMILIES | LOAD_FAMILIES | STACKS


class _Integer(int):
    pass


class _Float(float):
    pass


def _distinct_copy(value: Any) -> Any:
    """A copy with equal values in which each number and tuple is a new object, so that ``is`` tells copies apart."""
    if hasattr(value, "_fields"):
        return type(value)._make(map(_distinct_copy, value))
    if isinstance(value, tuple):
        return tuple(map(_distinct_copy, value)) if value and not _is_leaf(value) else (*value,)
    if isinstance(value, int):
        return _Integer(value)
    return _Float(value) if isinstance(value, float) else value


def _is_leaf(value: tuple[Any, ...]) -> bool:
    """Whether a tuple is one piece of state (a colour, a position); each item of other tuples is a piece."""
    return isinstance(value[0], float) or (isinstance(value[0], int) and not isinstance(value[0], bool))


def _paths(old: Any, new: Any, same: Any, path: Path = ()) -> Iterator[Path]:
    """The paths at which two states differ; same: compares two leaves (operator.eq or operator.is_)."""
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


class _Scratch:
    """Repeats calls on machines without a device, apart from the machine of the program."""

    def __init__(self) -> None:
        self.machine = Machine(NoDevice())

    def sets(self, call: Call, before: Moment) -> list[Path]:
        """The pieces of state that a call sets, those too that have the value already."""
        state, material = _distinct_copy(before.state), _distinct_copy(before.material)
        m = self._load(self.machine, state, material)
        m.modelview[-1] = leaf(before.matrices[0].get())
        _run(m, call)
        after = Snapshot(*(getattr(m, name) for name in Snapshot._fields))
        same = operator.is_
        return [*_paths(state, after, same), *_paths(material, m.material, same, ("material",))]

    def machine_at(self, before: Moment) -> Machine:
        """A new machine whose state, material and matrix stacks are those of ``before``."""
        m = self._load(Machine(NoDevice()), before.state, before.material)
        stacks = (m.modelview, m.projection, *m.texture_stacks)
        for stack, matrix, depth in zip(stacks, before.matrices, before.depths, strict=True):
            stack[:] = [leaf(matrix.get())] * depth
        m.stacks[gl.GL_TEXTURE] = m.texture_stacks[m.texture.active_unit]
        m.stack = m.stacks[m.transform.matrix_mode]
        return m

    def _load(self, m: Machine, state: Snapshot, material: Material) -> Machine:
        for name, group in zip(Snapshot._fields, state, strict=True):
            setattr(m, name, group)
        m.material, m.inside, m.busy = material, None, False
        return m


class Placed(NamedTuple):
    """How a call transformed its arguments into eye space: the modelview at that call, (4, 4), its columns as rows,
    and the numbers of the calls whose product it is."""

    modelview: NDArray[np.float32]
    chain: tuple[int, ...]


@dataclass
class Provenance:
    """Which call set each piece of state last, at one point of the program.

    setters: path -> number of the call that set it last; a path without an entry has its initial value.
    through: path -> number of the glCallList, for a path that was set inside a display list.
    chains: "modelview", "projection", "texture0" ... "texture3" -> the matrix stack, bottom first; each matrix is the
    list of the calls whose product it is.
    placed: path of a light position, spot direction, clip plane or eye plane -> how it came into eye space.
    registers: "glColor", "glNormal", ... -> number of the last call of that family.
    """

    setters: dict[Path, int] = field(default_factory=dict)
    through: dict[Path, int] = field(default_factory=dict)
    chains: dict[str, list[list[int]]] = field(default_factory=dict)
    placed: dict[Path, Placed] = field(default_factory=dict)
    registers: dict[str, int] = field(default_factory=dict)


class Step(NamedTuple):
    """One call of the walk: the state before and after it, the paths it set, and the provenance up to this call.

    number: of the call; for a call inside a display list, of the glCallList that executes the list.  trail: its
    position in the display lists, () for a call of the program itself."""

    number: int
    call: Call
    before: Moment
    after: Moment
    paths: list[Path]
    provenance: Provenance
    trail: Trail = ()


class History:
    """Walks through the calls of a frame, and through display lists as they are called."""

    def __init__(self, frame: Frame) -> None:
        if not frame.history:
            raise ValueError("the calls of this frame were not recorded: use capture(calls=True)")
        self.frame = frame
        self.moments = {moment.call: moment for moment in frame.history}
        self.scratch = _Scratch()
        self.provenance = Provenance()
        self.attrib_stack: list[tuple[dict[Path, int], dict[str, int], int]] = []  # by glPushAttrib
        self.lists: dict[int, list[int]] = {}
        self.base = 0  # glListBase

    def walk(self) -> Iterator[Step]:
        """Yield a Step for each call, in order.  All share one Provenance object, which is updated at each call."""
        provenance = self.provenance
        first = self.frame.history[0]
        for name, matrix in zip(NAMES, first.matrices, strict=True):
            untouched = np.array_equal(matrix.get(), np.eye(4, dtype=np.float32))
            provenance.chains[name] = [[] if untouched else [BEFORE]]
        for path in _paths(INITIAL, first.state, operator.eq):
            if path[-2] != "bound":  # every machine has texture objects of its own
                provenance.setters[path] = BEFORE
        compiling: list[int] | None = None
        executing = True
        before = first
        start = first.call + 1
        for number, call in enumerate(self.frame.calls[start:], start):
            after = self.moments.get(number, before)
            listed = COMMANDS[call.name].listed
            if call.name == "glNewList":
                compiling, executing = (
                    self.lists.setdefault(int(call.arguments[0]), []),
                    call.arguments[1] != gl.GL_COMPILE,
                )
                compiling.clear()
            elif call.name == "glEndList":
                compiling, executing = None, True
            elif compiling is not None and listed:
                compiling.append(number)
            paths: list[Path] = []
            if call.name == "glListBase" and executing:
                self.base = int(call.arguments[0])
            if executing or not listed:
                if call.name in CALLING:
                    paths = yield from self._called(number, call, before, after)
                else:
                    paths = self._sets(call, before, after)
                    self._apply(number, call, before, after, paths)
            yield Step(number, call, before, after, paths, provenance)
            before = after

    def _called(self, number: int, call: Call, before: Moment, after: Moment) -> Generator[Step, None, list[Path]]:
        """Follow the called display lists call by call.  A change that none of their calls explains is credited to the
        glCallList itself.  Yields a Step for each call in the lists; returns the paths whose values changed."""
        old = dict(self.provenance.setters)
        machine = self.scratch.machine_at(before)
        for list_number in self._called_by(call):
            yield from self._inside(machine, number, list_number, ())
        paths = changed(before, after)
        for path in paths:
            if self.provenance.setters.get(path) == old.get(path):
                self.provenance.setters[path] = number
        return paths

    def _inside(self, machine: Machine, number: int, list_number: int, trail: Trail) -> Iterator[Step]:
        if len(trail) >= MAX_LIST_NESTING:
            return
        for position, listed in enumerate(self.lists.get(list_number, [])):
            call, inner_trail = self.frame.calls[listed], (*trail, (list_number, position))
            before = after = moment(machine, listed)
            paths: list[Path] = []
            if call.name in CALLING:
                for inner in self._called_by(call):
                    yield from self._inside(machine, number, inner, inner_trail)
                after = moment(machine, listed)
            elif call.name in REGISTERS_ONLY or COMMANDS[call.name].family in REPLAYED:
                if call.name not in REGISTERS_ONLY:
                    _run(machine, call)
                    after = moment(machine, listed)
                paths = self._sets(call, before, after)
                self._apply(listed, call, before, after, paths)
                paths_set = [path for path in paths if self.provenance.setters.get(path) == listed]
                self.provenance.through.update(dict.fromkeys(paths_set, number))
            yield Step(number, call, before, after, paths, self.provenance, inner_trail)

    def _called_by(self, call: Call) -> list[int]:
        """The numbers of the lists that a glCallList or glCallLists calls."""
        if call.name == "glCallList":
            return [int(call.arguments[0])]
        arguments = [argument for argument in call.arguments if argument is not None]
        return numbers_called(self.base, *arguments)

    def _sets(self, call: Call, before: Moment, after: Moment) -> list[Path]:
        if call.name in REGISTERS_ONLY:
            return []
        paths = changed(before, after) if after is not before else []
        family = COMMANDS[call.name].family
        if family not in SETTER_FAMILIES:
            return paths
        return list(dict.fromkeys(paths + self.scratch.sets(call, before)))

    def _apply(self, number: int, call: Call, before: Moment, after: Moment, paths: list[Path]) -> None:
        provenance = self.provenance
        if call.name in REGISTERS_ONLY:
            provenance.registers[COMMANDS[call.name].family] = number
            return
        if call.name == "glPushAttrib":
            self.attrib_stack.append((dict(provenance.setters), dict(provenance.registers), int(call.arguments[0])))
        old: dict[Path, int] | None = None
        if call.name == "glPopAttrib" and self.attrib_stack:
            old, registers, mask = self.attrib_stack.pop()
            if mask & gl.GL_CURRENT_BIT:
                provenance.registers = registers
        for path in paths:
            provenance.through.pop(path, None)
            if old is None:
                provenance.setters[path] = number
            elif path in old:
                provenance.setters[path] = old[path]  # glPopAttrib brings back what an earlier call set
            else:
                provenance.setters.pop(path, None)
            if path[-1] in ("position", "spot_direction", "eye_plane") or path[:2] == ("transform", "clip_planes"):
                provenance.placed[path] = Placed(before.matrices[0].get(), tuple(provenance.chains["modelview"][-1]))
        self._matrices(number, call, before, after)

    def _matrices(self, number: int, call: Call, before: Moment, after: Moment) -> None:
        mode, unit = before.state.transform.matrix_mode, before.state.texture.active_unit
        name = {gl.GL_MODELVIEW: "modelview", gl.GL_PROJECTION: "projection", gl.GL_TEXTURE: f"texture{unit}"}[mode]  # type: ignore[index]
        stack = self.provenance.chains[name]
        family = COMMANDS[call.name].family
        if family == "glPushMatrix" and after is not before:
            stack.append(list(stack[-1]))
        elif family == "glPopMatrix" and len(stack) > 1:
            stack.pop()
        elif family in LOAD_FAMILIES:
            stack[-1] = [number]
        elif family in MULTIPLY_FAMILIES:
            stack[-1] = [*stack[-1], number]


def _run(machine: Machine, call: Call) -> None:
    """Execute a call on a scratch machine; errors are ignored, because the program has already got them."""
    errors = GLError, TypeError, ValueError, IndexError, KeyError, OverflowError, NotImplementedError
    with driving(machine), suppress(*errors):
        implementations[call.name](*call.arguments)


NAMES = ("modelview", "projection", "texture0", "texture1", "texture2", "texture3")
INITIAL = Snapshot._make(getattr(Machine(NoDevice()), name) for name in Snapshot._fields)
