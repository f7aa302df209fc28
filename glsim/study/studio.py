"""Draws the pictures of a comparison: one Frame for each scene, and from it each look."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.frame import Frame
from glsim.render.context import Offscreen, own_screen
from glsim.study.axes import Axis, Setting
from glsim.study.changes import Change, changed, changed_calls
from glsim.study.looks import ONE_LOBE, OUTLINES, RADIOSITY
from glsim.study.sources import Source

Pixels = NDArray[np.uint8]
Key = tuple[str, str]  # names of row and column


class Cell(NamedTuple):
    """One picture of a comparison, or the words that stand where there is none.

    pixels: (height, width, 3), top row first.  frame: what was drawn, as it was shaded; None if glsim did not shade it.
    """

    pixels: Pixels | None
    words: str = ""
    frame: Frame | None = None


def settings(rows: Axis, columns: Axis, start: Setting) -> Iterator[tuple[Key, Setting]]:
    """The setting of each cell, row by row."""
    for row in rows.values:
        for column in columns.values:
            yield (row.name, column.name), column.change(row.change(start))


class Studio:
    """A source, given pictures by name, and a screen that is opened when something is drawn.

    Use it in a ``with`` block, after which the screen is released."""

    def __init__(
        self, source: Source, given: Mapping[str, Pixels], samples: int, backend: str = "auto", calls: bool = False
    ) -> None:
        self.source, self.given, self.samples, self.backend, self.calls = source, given, samples, backend, calls
        self.remarks: dict[str, None] = dict.fromkeys(source.remarks)  # sentences, each once

    def __enter__(self) -> Studio:
        self.resources = ExitStack()
        return self

    def __exit__(self, *exception: object) -> None:
        self.resources.close()

    @cached_property
    def screen(self) -> Offscreen:
        size = self.source.width, self.source.height
        return self.resources.enter_context(own_screen(*size, samples=self.samples, backend=self.backend))

    def cells(self, rows: Axis, columns: Axis, start: Setting, tell: Callable[[str], object]) -> dict[Key, Cell]:
        """All cells of a sheet.  tell: called with what is being drawn."""
        self.source.forget()
        cells: dict[Key, Cell] = {}
        physical: dict[Key, Any] = {}
        for key, setting in settings(rows, columns, start):
            tell(f"drawing {', '.join(filter(None, reversed(key)))}")
            if setting.look.mode == "pyrender" and setting.picture is None:
                if setting.lobe != start.lobe:
                    cells[key] = Cell(None, ONE_LOBE["pyrender"])
                    continue
                plain = not setting.arguments and not setting.changes
                physical[key] = (self.source.original if plain else None) or self._frame(setting)[0]
                cells[key] = Cell(None)
            else:
                cells[key] = self._cell(setting)
        if physical:
            from glsim.study.pyrender import pictures

            tell("drawing with pyrender")
            size = self.source.width, self.source.height
            note = self.remarks.setdefault
            drawn = pictures(list(physical.values()), *size, samples=self.samples, note=note)
            cells |= {key: Cell(self.source.finished(picture)) for key, picture in zip(physical, drawn, strict=True)}
        return cells

    def frame(self, setting: Setting) -> Frame:
        """The frame of a setting before it is shaded."""
        return self._frame(setting)[0]

    def _frame(self, setting: Setting) -> tuple[Frame, list[Change]]:
        """The frame of a setting before it is shaded, and what was changed in it."""
        frame = self.source.frame(setting.arguments, self.screen, self.calls)
        return changed(frame, [*setting.changes, *setting.look.changes()])

    def _cell(self, setting: Setting) -> Cell:
        if setting.picture is not None:
            return Cell(self.given[setting.picture])
        look, source = setting.look, self.source
        if look.mode in RADIOSITY:
            return Cell(source.solved(look.mode, self.samples))
        if look.mode == "native" and not look.lobe and setting.lobe != "blinn":
            return Cell(None, ONE_LOBE["native"])
        frame, changes = self._frame(setting)
        if look.mode == "native":
            return Cell(source.finished(native(frame, changes)))
        shaded = look.of(frame, setting.lobe)
        self.screen.reset()
        self.screen.execute(shaded.packets)
        pixels = np.ascontiguousarray(self.screen.pixels()[..., :3])
        return Cell(source.finished(pixels), "", None if source.toned or look.mode in OUTLINES else shaded)


def native(frame: Frame, changes: list[Change]) -> Pixels:
    """The calls of a Frame, with its changes, replayed on the driver's fixed function."""
    if not frame.calls:
        raise ValueError("compare: native needs the calls of a Frame: glsim.capture(calls=True)")
    from glsim.render.native import Native

    lacking = _tests_without_buffer(frame)
    calls = [call for call in frame.calls if call.name != "glEnable" or int(call.arguments[0]) not in lacking]
    oracle = Native(frame.width, frame.height)
    try:
        return np.ascontiguousarray(oracle.replay(changed_calls(calls, changes))[..., :3])
    finally:
        oracle.release()


def _tests_without_buffer(frame: Frame) -> set[int]:
    """GL_DEPTH_TEST and GL_STENCIL_TEST, where the program enabled the test but its window has no such buffer: then the
    test is on in the program's state and off in the draws.  The driver's replay always has the buffers."""
    tests = {"depth": gl.GL_DEPTH_TEST, "stencil": gl.GL_STENCIL_TEST}
    numbers = [moment.call for moment in frame.history]
    lacking = set()
    for draw in frame.draws:
        state = frame.history[max(bisect_right(numbers, draw.call or 0) - 1, 0)].state
        lacking |= {int(test) for kind, test in tests.items()
                    if getattr(state, kind).test and not getattr(draw.state, kind).test}  # fmt: skip
    return lacking
