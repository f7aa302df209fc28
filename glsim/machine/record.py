"""Recording calls: the stream that the native replay, the trace and display lists are made of."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from glsim.machine.frame import Call
from glsim.machine.machine import Machine

# What executes each command; glsim.gl fills this in.
implementations: dict[str, Callable[..., Any]] = {}


class Recorder:
    """Appends each call to ``calls`` and then executes it."""

    def __init__(self, machine: Machine, calls: list[Call]) -> None:
        self.machine, self.calls = machine, calls

    def __call__(self, name: str, arguments: tuple[Any, ...]) -> Any:
        self.calls.append(Call(name, tuple(map(frozen, arguments))))
        self.machine.record(None)
        try:
            return implementations[name](*arguments)
        finally:
            self.machine.record(self)


def frozen(argument: Any) -> Any:
    """A copy that the program cannot change later."""
    if isinstance(argument, (int, float, str, bytes, tuple)) or argument is None:
        return argument
    if isinstance(argument, list):
        return tuple(map(frozen, argument))
    return np.array(argument)
