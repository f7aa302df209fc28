"""Ctrl-C at a good moment: what a signal's handler raises waits until a critical section has ended."""

from __future__ import annotations

import signal
import threading
from _signal import getsignal  # type: ignore[import-not-found]  # without the search for names in enums: ten times as fast
from _signal import signal as set_handler
from types import FrameType
from typing import Any

NAMES = ("SIGINT", "SIGTERM", "SIGALRM")
SIGNALS: list[int] = [getattr(signal, name) for name in NAMES if hasattr(signal, name)]  # Windows has no SIGALRM


class _Held:
    """Stands in for a signal's handler, and notes that the signal came."""

    def __init__(self, number: int, handler: Any) -> None:
        self.number, self.handler = number, handler
        self.arrived: list[FrameType | None] = []

    def __call__(self, number: int, frame: FrameType | None) -> None:
        self.arrived.append(frame)


class uninterrupted:  # noqa: N801 - read as a word: with uninterrupted():
    """Hold back KeyboardInterrupt, and what handlers of SIGTERM and SIGALRM raise, until the block has ended.

    moderngl's C code calls Python functions and uses their results without checking for an exception; and an operation
    such as switching to another context must not stop half-way.  Python runs signal handlers in the main thread only.
    """

    __slots__ = ("held",)

    def __enter__(self) -> None:
        self.held: list[_Held] = []
        if threading.get_ident() != threading.main_thread().ident:
            return
        try:
            for number in SIGNALS:
                handler = getsignal(number)
                if callable(handler) and type(handler) is not _Held:  # else nothing is raised, or it is held already
                    self.held.append(_Held(number, handler))
                    set_handler(number, self.held[-1])
        except BaseException:  # by a signal that was not held yet
            self._put_back()
            raise

    def __exit__(self, *exception: Any) -> None:
        try:
            self._put_back()
        except BaseException:  # by a signal that is not held any more
            self._put_back()
            raise
        for held in self.held:
            if held.arrived:
                held.handler(held.number, held.arrived[0])

    def _put_back(self) -> None:
        for held in self.held:
            set_handler(held.number, held.handler)
