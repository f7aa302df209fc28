"""GLUT's menus in real windows: a list over the picture, from which a click chooses."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from glsim.glut.loop import Loop
from glsim.glut.window import Pixels

ROW, WIDTH = 18, 180  # pixels
PAPER, INK, MARKED = (240, 240, 240), (20, 20, 20), (180, 205, 255)


class Line(NamedTuple):
    """One line of an open menu; menu is None for the heading of a submenu, which cannot be chosen."""

    text: str
    menu: int | None
    value: int


class Popup:
    """An open menu at (x, y), in pixels from the upper left corner.  Submenus are indented below their headings."""

    def __init__(self, loop: Loop, menu: int, x: int, y: int) -> None:
        self.loop, self.x, self.y = loop, x, y
        self.lines = self._lines(menu, 0)

    def _lines(self, number: int, depth: int) -> list[Line]:
        menu: Any = self.loop.menus.get(number)
        lines: list[Line] = []
        for label, value, submenu in menu.entries if menu is not None and depth < 5 else ():
            text = "    " * depth + label
            if submenu:
                lines += [Line(text, None, 0), *self._lines(value, depth + 1)]
            else:
                lines.append(Line(text, number, value))
        return lines

    def at(self, x: int, y: int) -> Line | None:
        """The line under the pointer."""
        row = (y - self.y) // ROW
        inside = 0 <= x - self.x < WIDTH and 0 <= row < len(self.lines)
        return self.lines[row] if inside else None

    def choose(self, x: int, y: int) -> None:
        """Call the menu's function for the line that was clicked."""
        line = self.at(x, y)
        if line is not None and line.menu is not None:
            self.loop.menu = line.menu
            self.loop.call("menu", self.loop.menus[line.menu].function, line.value)

    def drawn_on(self, picture: Pixels, pointer: tuple[int, int]) -> Pixels:
        """The picture with the menu over it."""
        from PIL import Image, ImageDraw

        image = Image.fromarray(picture)
        draw = ImageDraw.Draw(image)
        marked = self.at(*pointer)
        for row, line in enumerate(self.lines):
            top = self.y + row * ROW
            paper = MARKED if line is marked and line.menu is not None else PAPER
            draw.rectangle((self.x, top, self.x + WIDTH, top + ROW), fill=paper)
            draw.text((self.x + 6, top + 3), line.text, fill=INK)
        return np.asarray(image)
