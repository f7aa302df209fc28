"""Which machine the gl commands drive.

``make_current`` tells everybody who holds a reference; the gl modules do, so that the hot commands reach the machine
through one global name.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from glsim.machine.errors import NoContextError

if TYPE_CHECKING:
    from glsim.machine.machine import Machine


class NoMachine:
    """Stands in while no context is current: whatever is asked of it, it says what to do."""

    def __getattr__(self, name: str) -> Any:
        raise NoContextError(
            "no context is current: call glsim.offscreen(width, height) before the first gl command"
            " (and keep what it returns)"
        )


_current: Any = NoMachine()
_listeners: list[Callable[[Any], None]] = []


def current_machine() -> Machine:
    """The machine that gl commands drive now (or the stand-in that raises NoContextError)."""
    return _current  # type: ignore[no-any-return]


def make_current(machine: Machine | None) -> None:
    global _current
    _current = machine if machine is not None else NoMachine()
    for listener in _listeners:
        listener(_current)


def on_switch(listener: Callable[[Any], None]) -> None:
    """Call ``listener`` with the machine now and at each later switch."""
    _listeners.append(listener)
    listener(_current)
