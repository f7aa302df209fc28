"""Which machine the gl commands drive: each thread has its own, as in OpenGL.

The commands read it from one global name, ``current`` of glsim/gl/immediate.py.  As long as a single thread has a
machine, ``current`` is that machine.  When a second thread has one, too, ``current`` is a Router.  The Router passes
each call on to a copy of the command that belongs to the calling thread: a function with the same code, whose global
``current`` is the machine of this thread.

    def glNormal3f(nx, ny, nz):        # in immediate.py, whose globals are the dict G
        m = current                    # one thread: G["current"] is its machine, and this is all that is paid
    copy = FunctionType(glNormal3f.__code__, {**G, "current": my_machine})  # ThreadState.command("glNormal3f")
    copy(0, 0, 1)                      # the same code, which finds my_machine under the name ``current``
    glNormal3f(0, 0, 1)                # several threads: G["current"] is the Router.  It has a recorder, so the command
                                       # calls Router.recorder("glNormal3f", (0, 0, 1)), and that calls copy(0, 0, 1)
"""

from __future__ import annotations

import os
import threading
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FunctionType
from typing import TYPE_CHECKING, Any

from glsim.machine.errors import NoContextError
from glsim.machine.interrupts import uninterrupted
from glsim.machine.record import implementations

if TYPE_CHECKING:
    from glsim.machine.machine import Machine

NO_CONTEXT = (
    "no context is current: call glsim.offscreen(width, height) before the first gl command (and keep what it returns)"
)


class NoMachine:
    """The value of ``current`` while no context is current: each access raises NoContextError with ``sentence``."""

    def __init__(self, sentence: str = NO_CONTEXT) -> None:
        self.__dict__["sentence"] = sentence

    def __getattr__(self, name: str) -> Any:
        raise NoContextError(self.__dict__["sentence"])


class ThreadState:
    """The machine that is current in one thread, and this thread's copies of the commands.

    Python deletes the object when the thread ends.
    """

    def __init__(self) -> None:
        self.machine: Any = _no_machine
        self.namespace: dict[str, Any] = {}
        self.commands: dict[str, Callable[..., Any]] = {}
        weakref.finalize(self, _thread_ended, id(self)).atexit = False

    def command(self, name: str) -> Callable[..., Any]:
        """The thread's own copy of a command."""
        if name not in self.commands:
            if not self.commands:
                self.namespace = {**_namespace, "current": self.machine}
            public: Any = implementations[name]
            self.commands[name] = FunctionType(
                public.__code__, self.namespace, name, public.__defaults__, public.__closure__
            )
        return self.commands[name]


class _Local(threading.local):
    def __init__(self) -> None:
        self.state = ThreadState()


class Router:
    """The value of ``current`` while several threads have a machine: it passes each call on to the thread's copy."""

    busy = True  # so that each command comes here

    def recorder(self, name: str, arguments: tuple[Any, ...]) -> Any:
        return _local.state.command(name)(*arguments)

    intercept = recorder


_no_machine: Any = NoMachine()
_namespace: dict[str, Any] = {}  # the globals of the commands
_machines: dict[int, Any] = {}  # id of a ThreadState -> the machine that is current in the thread
_lock = threading.RLock()


def this_thread() -> ThreadState:
    """The calling thread's state."""
    return _local.state


def current_machine() -> Machine:
    """The machine that this thread's gl commands drive now (or the stand-in that raises NoContextError)."""
    return _local.state.machine  # type: ignore[no-any-return]


def make_current(machine: Machine | None) -> None:
    """Let this thread's gl commands drive ``machine``, or nothing.

    Raises RuntimeError if it is current in another thread: a context is current in one thread at a time.
    """
    with uninterrupted():
        _switch(machine)


@contextmanager
def driving(machine: Machine) -> Iterator[None]:
    """Send the gl commands of the block to ``machine``; signals wait until the block has ended."""
    with uninterrupted():
        before = current_machine()
        try:
            _switch(machine)
            yield
        finally:
            _switch(before)


@contextmanager
def current_again() -> Iterator[None]:
    """After the block this thread's gl commands drive what they drove before it, whatever the block made current."""
    before = current_machine()
    try:
        yield
    finally:
        make_current(None if isinstance(before, NoMachine) else before)


def attach(namespace: dict[str, Any]) -> None:
    """Keep ``current`` in these globals up to date."""
    global _namespace
    _namespace = namespace
    _choose()


def _switch(machine: Any) -> None:
    state = _local.state
    with _lock:
        if machine is None or isinstance(machine, NoMachine):
            state.machine = _no_machine
            _machines.pop(id(state), None)
        else:
            if machine.thread != threading.get_ident() and machine in _machines.values():
                raise RuntimeError(
                    "this context is current in another thread: open one for this thread, with glsim.offscreen"
                )
            machine.thread = threading.get_ident()
            state.machine = _machines[id(state)] = machine
        state.namespace["current"] = state.machine
        _choose()


def _choose() -> None:
    """Set the global ``current``: the NoMachine, the machine if only one thread has one, or the Router."""
    machines = list(_machines.values())
    _namespace["current"] = _no_machine if not machines else machines[0] if len(machines) == 1 else _router


def _thread_ended(state: int) -> None:
    """A thread has ended.  state: the id of its ThreadState."""
    with _lock:
        _machines.pop(state, None)
        _choose()


def forget(sentence: str) -> None:
    """Forget the current machine of every thread: each gl command now raises NoContextError(sentence)."""
    global _no_machine
    _no_machine = NoMachine(sentence)
    _machines.clear()
    _switch(None)


_router = Router()
_local = _Local()
if hasattr(os, "register_at_fork"):  # no other thread is switching while the process is copied
    os.register_at_fork(before=_lock.acquire, after_in_parent=_lock.release, after_in_child=_lock.release)
