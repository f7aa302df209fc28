"""Signals at a chosen moment of a program, the same in each run."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable
from types import FrameType
from typing import Any


def interrupted(work: Callable[[], object], moment: int = 0) -> int:
    """Does ``work``, with SIGALRM raised before its bytecode number ``moment``, if that is not 0.

    Gives the number of bytecodes that were passed.  What the handler raises comes out of here.
    """
    passed = 0

    def trace(frame: FrameType, event: str, argument: object) -> Any:
        nonlocal passed
        frame.f_trace_opcodes, frame.f_trace_lines = True, False
        if event == "opcode":
            passed += 1
            if passed == moment:
                sys.settrace(None)
                signal.raise_signal(signal.SIGALRM)
        return trace

    sys.settrace(trace)
    try:
        work()
    finally:
        sys.settrace(None)
    return passed
