"""One GLUT window: an offscreen context, its callbacks, and the picture it shows.

A window has a depth and a stencil buffer if glutInitDisplayMode asked for them, as with freeglut and Mesa: else tests
have no effect.  GLUT_STENCIL brings a depth buffer along.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.glut.constants import NAMES
from glsim.machine.frame import Draw, Packet, QueryMark
from glsim.machine.state import Snapshot
from glsim.render.context import Offscreen

Pixels = NDArray[np.uint8]
DOUBLE, MULTISAMPLE = NAMES["GLUT_DOUBLE"], NAMES["GLUT_MULTISAMPLE"]
DEPTH, STENCIL = NAMES["GLUT_DEPTH"], NAMES["GLUT_STENCIL"]
SAMPLES = 4  # of a window with GLUT_MULTISAMPLE
MISSING = "{test} has no effect, because the window has no {kind} buffer: add {flag} to glutInitDisplayMode"


class Window:
    """ident: its number.  callbacks: by kind ("Display", "Reshape", ...).  dirty: glutPostRedisplay was called.

    shown: the picture of the last glutSwapBuffers, (height, width, 3) uint8, top row first; in a single-buffered
    window the picture after the last step.  asked: the size that the program or the user wants; size: the one that the
    reshape callback was told.
    """

    def __init__(
        self, ident: int, title: str, place: tuple[int, int], size: tuple[int, int], mode: int, parent: Window | None
    ) -> None:
        self.ident, self.title, self.place, self.mode, self.parent = ident, title, place, mode, parent
        self.asked = size
        self.size: tuple[int, int] | None = None
        self.callbacks: dict[str, Callable[..., Any]] = {}
        self.dirty = True
        self.hidden = False
        self.shown: Pixels | None = None
        self.swapped = False  # whether the program ever swapped its buffers
        self.menus: dict[int, int] = {}  # button -> menu
        self.cursor = NAMES["GLUT_CURSOR_INHERIT"]
        self.data: Any = None
        self.screen = Offscreen(*size, samples=SAMPLES if mode & MULTISAMPLE else 0)
        self.screen.double_buffered = self.double
        self.screen.depth_bits, self.screen.stencil_bits = (
            24 if mode & (DEPTH | STENCIL) else 0,
            8 if mode & STENCIL else 0,
        )
        self.screen.machine.outlet.limit = self._limited if not mode & STENCIL else None
        self.notes: list[str] = []  # what is to be said
        self.said: set[str] = set()
        self.last: tuple[Snapshot, Snapshot] | None = None  # a state, and that state without tests

    @property
    def double(self) -> bool:
        return bool(self.mode & DOUBLE)

    def _limited(self, packet: Packet) -> Packet:
        """The packet without tests of the buffers that the window lacks."""
        if isinstance(packet, QueryMark):
            return packet
        state = packet.state
        if self.last is None or state is not self.last[0]:
            self.last = state, self._without_tests(state)
        limited = self.last[1]
        if limited is state:
            return packet
        return packet.with_state(limited) if isinstance(packet, Draw) else packet._replace(state=limited)

    def _without_tests(self, state: Snapshot) -> Snapshot:
        if state.depth.test and not self.screen.depth_bits:
            self._note(MISSING.format(test="GL_DEPTH_TEST", kind="depth", flag="GLUT_DEPTH"))
            state = state._replace(depth=state.depth._replace(test=False))
        if state.stencil.test and not self.screen.stencil_bits:
            self._note(MISSING.format(test="GL_STENCIL_TEST", kind="stencil", flag="GLUT_STENCIL"))
            state = state._replace(stencil=state.stencil._replace(test=False))
        return state

    def _note(self, sentence: str) -> None:
        if sentence not in self.said:
            self.said.add(sentence)
            self.notes.append(sentence)

    def make_current(self) -> None:
        self.screen.make_current()

    def picture(self) -> Pixels:
        """What has been drawn until now."""
        return picture_of(self.screen, *self.asked)

    def resize(self) -> None:
        """Give the context the size that was asked for."""
        if self.asked != (self.screen.width, self.screen.height):
            self.screen.resize(*self.asked)

    def release(self) -> None:
        self.screen.release()


def flushed(screen: Offscreen) -> None:
    """Draw what can be drawn now: nothing between glBegin and glEnd or while a display list is compiled."""
    if screen.machine.inside is None and screen.machine.compiling is None:
        screen.machine.flush()


def picture_of(screen: Offscreen, width: int, height: int) -> Pixels:
    """What has been drawn until now: (height, width, 3) uint8, top row first."""
    flushed(screen)
    return np.ascontiguousarray(screen.read(0, 0, width, height, "color")[::-1, :, :3])
