"""Interception: how somebody sees, or changes, what passes through a machine.

Two streams pass through a machine, and each can be intercepted at one place:

    commands   program -> [recorder] -> the command's body -> packets
    packets    flush   -> [outlet]   -> the device, which draws them

``Machine.recorder`` is called with (name, arguments) of every command *instead of* the command's body; it runs the body
itself, later (a display list being compiled) or never.  ``Machine.outlet`` is given the packets of a flush and returns
those that the device shall draw.  For example, what a program draws under another shade model, written down as data:

    machine.record(Recorder(machine, frame))         # commands: noted in frame.calls, and executed
    machine.outlet.change = reshaded("phong", None)  # packets: each Draw gets another shade model ...
    machine.outlet.frame = frame                     # ... and is noted in frame.packets, as it will be drawn
    glBegin(GL_TRIANGLES)                            # -> recorder("glBegin", (GL_TRIANGLES,)) -> the body of glBegin
    glFlush()                                        # -> recorder("glFlush", ()) -> Machine.flush -> outlet -> device
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from glsim.machine.frame import Draw, Frame, Packet

Recording = Callable[[str, tuple[Any, ...]], Any]


@dataclass(slots=True)
class Outlet:
    """What the packets of a flush pass on their way to the device, in the order of the fields.

    collector: takes all of them, and nothing is drawn: glRenderMode(GL_SELECT) and GL_FEEDBACK.
    limit: returns each packet without the tests of those buffers that the window does not have.
    change: makes of each Draw another one: under another shade model, say.
    frame: the packets that will be drawn are appended to its ``packets`` (``glsim.capture``).
    """

    collector: Callable[[list[Packet]], None] | None = None
    limit: Callable[[Packet], Packet] | None = None
    change: Callable[[Draw], Draw] | None = None
    frame: Frame | None = None

    def passed(self, packets: list[Packet]) -> list[Packet]:
        """Send the packets of one flush through the fields; return the packets that the device draws."""
        if self.collector is not None:
            self.collector(packets)
            return []
        if self.limit is not None:
            packets = [self.limit(packet) for packet in packets]
        if self.change is not None:
            packets = [self.change(packet) if type(packet) is Draw else packet for packet in packets]
        if self.frame is not None:
            self.frame.packets += packets
        return packets

    def reset(self) -> None:
        """Called when the machine is reset: end selection or feedback mode, and empty the Frame that is captured."""
        self.collector = None
        if self.frame is not None:
            self.frame.packets.clear()
