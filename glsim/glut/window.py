"""One GLUT window: an offscreen context, its callbacks, and the picture it shows."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.glut.constants import NAMES
from glsim.render.context import Offscreen

Pixels = NDArray[np.uint8]
DOUBLE, MULTISAMPLE = NAMES["GLUT_DOUBLE"], NAMES["GLUT_MULTISAMPLE"]
SAMPLES = 4  # of a window with GLUT_MULTISAMPLE


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
        self.menus: dict[int, int] = {}  # button -> menu
        self.cursor = NAMES["GLUT_CURSOR_INHERIT"]
        self.data: Any = None
        self.screen = Offscreen(*size, samples=SAMPLES if mode & MULTISAMPLE else 0)
        self.screen.double_buffered = self.double

    @property
    def double(self) -> bool:
        return bool(self.mode & DOUBLE)

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
