"""Catching what a program draws as data."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from glsim.machine.current import current_machine
from glsim.machine.frame import Frame
from glsim.machine.record import Recorder


@contextmanager
def capture(calls: bool = False) -> Iterator[Frame]:
    """Collect what is drawn inside of the ``with`` block; it is drawn all the same.

    The Frame yielded is complete when the block ends.  calls: record every call too (``frame.calls``).

        with glsim.capture() as frame:
            draw()
    """
    machine = current_machine()
    machine.flush()
    frame = Frame(machine.device.width, machine.device.height)
    before, recorder = machine.capturing, machine.recorder
    machine.capturing = frame
    if calls:
        machine.record(Recorder(machine, frame.calls))
    try:
        yield frame
    finally:
        machine.record(recorder)
        machine.flush()
        machine.capturing = before
