"""Recording calls: the stream that the native replay, the trace and display lists are made of."""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Callable
from ctypes import c_void_p
from typing import Any

import numpy as np

from glsim.machine.commands import COMMANDS, Command, numbers_wanted
from glsim.machine.constants import Enum
from glsim.machine.frame import Accum, Call, Clear, Draw, Frame, Moment, Packet, Pixels, Where
from glsim.machine.machine import Machine
from glsim.machine.pixels import PixelStore
from glsim.machine.sentences import MISUSE, explain
from glsim.machine.types import is_pointer, plain, raw_bytes

# What executes each command; glsim.gl fills this in.
implementations: dict[str, Callable[..., Any]] = {}


new_call: Callable[..., Call] = tuple.__new__  # twice as fast as the constructor


class Recorder:
    """Notes each call, with the user's line and what it changed, and executes it.

    most: after so many calls it gives up: the frame is emptied, and recording costs nothing any more."""

    def __init__(self, machine: Machine, frame: Frame, most: float = math.inf) -> None:
        self.machine, self.calls, self.history = machine, frame.calls, frame.history
        self.frame, self.most = frame, most
        self.lines: dict[tuple[Any, int], Where] = {}  # of the user's program, by code and line
        if not self.history:
            self.history.append(moment(machine, len(self.calls) - 1))

    def restart(self) -> None:
        """Forget the calls until now: the machine was reset."""
        self.calls.clear()
        self.history[:] = [moment(self.machine, -1)]

    def __call__(self, name: str, arguments: tuple[Any, ...]) -> Any:
        if len(self.calls) >= self.most:
            return self._give_up(name, arguments)
        if name in HOT:
            return self._hot(name, arguments)
        machine = self.machine
        self.note(name, frozen_arguments(name, arguments))
        packets, first = machine.packets, len(machine.packets)
        machine.recorder, machine.busy = None, machine.inside is not None
        try:
            return implementations[name](*arguments)
        finally:
            if isinstance(machine.recorder, ListRecorder):  # the call was glNewList
                machine.recorder.outer = self
            else:
                machine.recorder, machine.busy = self, True
            if name not in REGISTERS_ONLY:
                self.changed(packets, first)

    def _give_up(self, name: str, arguments: tuple[Any, ...]) -> Any:
        machine = self.machine
        for listed in (self.frame.calls, self.frame.history, self.frame.packets):
            listed.clear()
        self.most = 0  # if somebody makes it current again
        machine.record(None)
        if machine.outlet.frame is self.frame:
            machine.outlet.frame = None
        return implementations[name](*arguments)

    def _hot(self, name: str, arguments: tuple[Any, ...]) -> None:
        """A command of gl/immediate.py: called once a vertex, it changes no state."""
        caller = sys._getframe(3)
        line = caller.f_code, caller.f_lineno
        where = self.lines.get(line)
        if where is None:
            where = users_line(caller)
            if where is not None and where[:2] == (line[0].co_filename, line[1]):
                self.lines[line] = where
        arguments = frozen_arguments(name, arguments)
        self.calls.append(new_call(Call, (name, arguments, where)))
        machine = self.machine
        machine.recorder = None
        try:
            implementations[name](*arguments)
        finally:
            machine.recorder = self

    def note(self, name: str, arguments: tuple[Any, ...]) -> None:
        if len(self.calls) < self.most:  # within a display list it goes on
            self.calls.append(Call(name, arguments, users_line(sys._getframe(2))))

    def changed(self, packets: list[Packet], first: int) -> None:
        """After a call: append a Moment to the history if the state changed; write the call's number into new packets.

        packets, first: the machine's list of packets before the call, and its length at that time.
        """
        number = len(self.calls) - 1
        later = [] if packets is self.machine.packets else self.machine.packets
        for made, start in ((packets, first), (later, 0)):
            for k in range(start, len(made)):
                packet = made[k]
                if type(packet) is Draw:
                    packet.call = number
                elif isinstance(packet, (Clear, Pixels, Accum)):
                    made[k] = packet._replace(call=number)
        now = moment(self.machine, number)
        if now[1:] != self.history[-1][1:]:
            self.history.append(now)


def moment(m: Machine, call: int) -> Moment:
    stacks = (m.modelview, m.projection, *m.texture_stacks)
    return Moment(call, m.snapshot(), m.material, tuple([s[-1] for s in stacks]), tuple([len(s) for s in stacks]))


# Packages of glsim whose files users_line skips; it also skips generated code ("<gl command ...>").
PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
INNER = tuple(os.path.join(PACKAGE, room, "") for room in ("gl", "glu", "glut", "machine", "play", "render", "study"))
_inner: dict[str, bool] = {}


def users_line(frame: Any) -> Where | None:
    """The line of the user's program that is being executed; None if there is none.

    frame: the stack frame to begin with; the search goes from callee to caller.
    """
    via = ""
    while frame is not None:
        code = frame.f_code
        name = code.co_filename
        inner = _inner.get(name)
        if inner is None:
            inner = _inner[name] = name.startswith((*INNER, "<gl command"))
        if not inner:
            return Where(name, frame.f_lineno, via)
        if code.co_name.startswith("glu"):
            via = _written(frame)
        frame = frame.f_back
    return None


def _written(frame: Any) -> str:
    """The call of a GLU or GLUT function as text: its name; for GLU with the arguments, if all are int or float."""
    code, values = frame.f_code, frame.f_locals
    arguments = [values[name] for name in code.co_varnames[: code.co_argcount]]
    if code.co_name.startswith("glut") or not all(type(value) in (int, float) for value in arguments):
        return str(code.co_name)
    return f"{code.co_name}({', '.join(format(value, 'g') for value in arguments)})"


class ListRecorder:
    """Between glNewList and glEndList: collects the commands that belong into the list.

    calls: (name, arguments) in order.  others: the positions of all but plain commands of gl/immediate.py.  execute:
    whether the mode is GL_COMPILE_AND_EXECUTE.  clients: position in ``calls`` of a call that draws from vertex
    arrays -> a copy of the arrays at the time of the call.  stores: position of a call that reads pixels -> the
    unpacking state of glPixelStore at that time.
    """

    def __init__(self, machine: Machine, number: int, execute: bool) -> None:
        self.machine, self.number, self.execute = machine, number, execute
        self.calls: list[tuple[str, tuple[Any, ...]]] = []
        self.others: list[int] = []
        self.clients: dict[int, dict[Any, Any]] = {}
        self.stores: dict[int, PixelStore] = {}
        self.outer: Recorder | None = None

    def __call__(self, name: str, arguments: tuple[Any, ...]) -> Any:
        if name in HOT and not self.execute and self.outer is None:
            values = arguments[0] if name in HOT_VECTORS else arguments
            if type(values) in (tuple, list) and PLAIN.issuperset(map(type, values)):
                self.calls.append((name, arguments if values is arguments else (tuple(values),)))
                return None
        given, arguments = arguments, frozen_arguments(name, arguments)
        if self.outer is not None:
            self.outer.note(name, arguments)
        if name in NEVER_LISTED:
            return self._perform(name, given)
        if name in ARRAY_CALLS:
            self.clients[len(self.calls)] = copied(self.machine)
        if name in PIXEL_CALLS:
            self.stores[len(self.calls)] = self.machine.stores.unpack
        try:
            self.calls.append((name, with_indices(self.machine, name, arguments)))
        except Exception as error:
            raise explain(error, name, arguments) from None
        self.others.append(len(self.calls) - 1)
        return self._perform(name, arguments) if self.execute else None

    def _perform(self, name: str, arguments: tuple[Any, ...]) -> Any:
        machine = self.machine
        packets, first = machine.packets, len(machine.packets)
        machine.record(None)
        try:
            return implementations[name](*arguments)
        finally:
            machine.record(self.outer if name == "glEndList" else self)
            if self.outer is not None:
                self.outer.changed(packets, first)


NUMBERS_ONLY = {command.name for command in COMMANDS.values() if all(k != "data" for _, k in command.arguments)}
REGISTERS_ONLY = {
    command.name
    for command in COMMANDS.values()
    if command.family in ("glVertex", "glNormal", "glColor", "glTexCoord", "glMultiTexCoord", "glEdgeFlag", "glBegin")
}
HOT = {c.name for c in COMMANDS.values() if c.family in ("glVertex", "glNormal", "glColor", "glTexCoord")}
HOT_VECTORS = {name for name in HOT if COMMANDS[name].vector}
NEVER_LISTED = {command.name for command in COMMANDS.values() if not command.listed}
PIXEL_CALLS = {command.name for command in COMMANDS.values() if "pixels" in command.parameters}
PIXEL_CALLS |= {"glBitmap", "glPolygonStipple"}
ARRAY_CALLS = {
    "glDrawArrays", "glDrawElements", "glDrawRangeElements", "glMultiDrawArrays", "glMultiDrawElements",
    "glArrayElement",
}  # fmt: skip


def copied(machine: Machine) -> dict[Any, Any]:
    """The state of the vertex arrays, with copies of the data of the enabled ones, from memory or buffer objects."""

    def keep(state: Any) -> Any:
        pointer = state.pointer
        buffer = machine.objects.buffers.get(pointer.buffer)
        data = buffer.data[max(pointer.offset, 0) :] if buffer is not None else pointer.data
        if not state.enabled or data is None:
            return state
        return state._replace(pointer=pointer._replace(data=np.array(data), buffer=0, offset=0))

    return {array: keep(state) for array, state in machine.client.arrays.items()}


def with_indices(machine: Machine, name: str, arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """The arguments of glDrawElements with the indices themselves, if they lie in a buffer object."""
    if not machine.client.element_buffer or name not in ("glDrawElements", "glDrawRangeElements"):
        return arguments
    memory, place = (
        machine.objects.buffers[machine.client.element_buffer].data,
        COMMANDS[name].parameters.index("indices"),
    )
    return (*arguments[:place], memory[arguments[place] or 0 :].tobytes())


PLAIN = frozenset((int, float, bool, Enum))


def frozen_arguments(name: str, arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """Copies of the arguments that the program cannot change later."""
    if name in NUMBERS_ONLY and PLAIN.issuperset(map(type, arguments)):
        return arguments
    try:
        return tuple(map(frozen, python_arguments(COMMANDS[name], arguments)))
    except MISUSE as error:
        raise explain(error, name, arguments) from None


def python_arguments(command: Command, arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """The arguments of a call with Python's numbers instead of ctypes', and an array for a pointer of known length."""
    converted = tuple(map(plain, arguments))
    wanted = [numbers_wanted(command, converted, place) for place in range(min(len(command.arguments), len(converted)))]
    return (*map(plain, converted, wanted), *converted[len(wanted) :])


def frozen(argument: Any) -> Any:
    """A copy that the program cannot change later."""
    if type(argument) is list:
        plain = not argument or type(argument[0]) is float
        return tuple(argument) if plain else tuple(map(frozen, argument))
    if isinstance(argument, (int, float, str, bytes, tuple)) or argument is None:
        return argument
    if isinstance(argument, c_void_p):  # an offset into a buffer object
        return argument.value or 0
    if is_pointer(argument):  # of unknown length
        return argument
    memory = raw_bytes(argument)
    return np.array(argument) if memory is None else memory.tobytes()
