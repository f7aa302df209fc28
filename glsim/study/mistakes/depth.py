"""Mistakes with the depth buffer, the stencil buffer and the two buffers of a window."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.frame import Frame
from glsim.machine.stage import window
from glsim.study.mistakes.rules import Findings, Rule, Seen, rule
from glsim.study.provenance import Step

TOPIC = "depth and buffers"
MOST_WORK = 6_000_000  # points times triangles
MOST_TRIANGLES = 20_000


@rule
class MissingBuffer(Rule):
    """Silent if the window has the buffer."""

    kind, topic = "missing-buffer", TOPIC
    looks_at = "a depth or stencil test without a buffer"
    sentence = "{test} has no effect, because the window has no {buffer} buffer: add {flag} to glutInitDisplayMode"

    def on_draw(self, seen: Seen) -> Findings:
        for kind in ("depth", "stencil"):
            if getattr(seen.asked, kind).test and not getattr(seen.state, kind).test:
                words = {"test": f"GL_{kind.upper()}_TEST", "buffer": kind, "flag": f"GLUT_{kind.upper()}"}
                yield seen.at(seen.setter(kind, "test")), words


@rule
class DepthNotCleared(Rule):
    """Silent with GL_ALWAYS, and if the depth buffer is cleared within 15 lines of the colours."""

    kind, topic = "depth-not-cleared", TOPIC
    looks_at = "a depth buffer that is never cleared"
    sentence = (
        "GL_DEPTH_TEST is on, but this glClear leaves the depth buffer as it is: the next frame is hidden behind this"
        " one; add GL_DEPTH_BUFFER_BIT"
    )
    commands = frozenset({"glClear"})

    def __init__(self, frame: Frame) -> None:
        super().__init__(frame)
        self.clear: int | None = None  # the last glClear of the colour buffer
        self.depth_clear: int | None = None
        self.stale: int | None = None  # a glClear without the depth buffer, before a Draw with the depth test

    def on_call(self, step: Step) -> Findings:
        mask = int(step.call.arguments[0])
        self.clear = step.number if mask & gl.GL_COLOR_BUFFER_BIT else self.clear
        self.depth_clear = step.number if mask & gl.GL_DEPTH_BUFFER_BIT else self.depth_clear
        yield from ()

    def on_draw(self, seen: Seen) -> Findings:
        tested = seen.state.depth.test and seen.state.depth.func != gl.GL_ALWAYS
        if tested and self.clear is not None and not self._cleared_together():
            self.stale = self.clear
        yield from ()

    def _cleared_together(self) -> bool:
        """Whether the depth buffer was cleared with, or a few lines from, the last glClear of colours."""
        if self.clear is None or self.depth_clear is None:
            return False
        one, two = (self.frame.calls[number].where for number in (self.clear, self.depth_clear))
        near = one is not None and two is not None and one.file == two.file and abs(one.line - two.line) <= 15
        return self.depth_clear >= self.clear or near

    def at_end(self, draws: list[Seen]) -> Findings:
        if self.stale is not None:
            yield self.stale, {}


@rule
class NeverSwapped(Rule):
    """Silent for windows with one buffer, and for a program that ends with an error before it could swap."""

    kind, topic = "never-swapped", TOPIC
    looks_at = "GLUT_DOUBLE without glutSwapBuffers"
    sentence = (
        "the window has two buffers, and what this and all else draws stays in the one that is not seen: call"
        " glutSwapBuffers() at the end of the display function"
    )

    def at_end(self, draws: list[Seen]) -> Findings:
        if self.frame.unswapped and not self.frame.error and draws:
            yield draws[-1].call, {}


@rule
class NoDepthTest(Rule):
    """Something far is drawn over something near: looked at on a grid of points.  Silent if any draw has the depth
    test; for what is drawn with other projections (a 2-D overlay), with blending, with a stencil test or without
    colours (passes); for pictures in the right order and at one depth; and beyond 20,000 triangles."""

    kind, topic = "no-depth-test", TOPIC
    looks_at = "overlap without GL_DEPTH_TEST"
    sentence = (
        "{what} is drawn over what is nearer to the eye, because GL_DEPTH_TEST is off: glEnable(GL_DEPTH_TEST), with"
        " GLUT_DEPTH and glClear(GL_DEPTH_BUFFER_BIT)"
    )

    def __init__(self, frame: Frame) -> None:
        super().__init__(frame)
        self.tested = False
        self.parts: list[list[Seen]] = [[]]  # since each glClear of the colours

    commands = frozenset({"glClear"})

    def on_call(self, step: Step) -> Findings:
        if int(step.call.arguments[0]) & gl.GL_COLOR_BUFFER_BIT:
            self.parts.append([])
        yield from ()

    def on_draw(self, seen: Seen) -> Findings:
        self.tested |= seen.asked.depth.test
        self.parts[-1].append(seen)
        yield from ()

    def at_end(self, draws: list[Seen]) -> Findings:
        if self.tested:
            return
        for part in self.parts:
            groups: dict[bytes, list[Seen]] = {}
            for seen in part:
                state = seen.state
                whole = all(state.color_buffer.mask[:3]) and not state.color_buffer.logic_op_enabled
                if seen.areas and whole and not (state.color_buffer.blend or state.stencil.test or seen.bent):
                    groups.setdefault(seen.draw.matrices[1].get().tobytes(), []).append(seen)
            for group in groups.values():
                guilty = drawn_over(group)
                if guilty is not None:
                    yield guilty.call, {"what": "this" if len(group) > 1 else "a part of this"}
                    return


def drawn_over(draws: list[Seen]) -> Seen | None:
    """The first of some Draws that covers what is nearer, at 2 % of the points that are covered; None if none does."""
    corners, owners = [], []
    for number, seen in enumerate(draws):
        one, polygon = seen.surface, seen.state.polygon
        front = one.front(polygon.front_face)
        kept = np.ones(len(one), bool)
        if polygon.cull:
            kept = {gl.GL_BACK: front, gl.GL_FRONT: ~front}.get(polygon.cull_face, ~kept)  # type: ignore[call-overload]
        kept &= (one.clip[..., 3] > 0.0).all(axis=1)
        corners.append(window(one.clip[kept].reshape(-1, 4), seen.state.viewport)[:, :3].reshape(-1, 3, 3))
        owners.append(np.full(int(kept.sum()), number))
    at, owner = np.concatenate(corners), np.concatenate(owners)
    at, owner = at[np.isfinite(at).all(axis=(1, 2))], owner[np.isfinite(at).all(axis=(1, 2))]
    if not 1 < len(at) <= MOST_TRIANGLES:
        return None
    side = int(np.clip(np.sqrt(MOST_WORK / len(at)), 16, 64))
    low, high = at[..., :2].min(axis=(0, 1)), at[..., :2].max(axis=(0, 1))
    view = draws[0].state.viewport
    low = np.maximum(low, (view.x, view.y))
    high = np.minimum(high, (view.x + view.width, view.y + view.height))
    if (high <= low).any():
        return None
    steps = (np.arange(side) + 0.5) / side
    wrong = np.zeros(len(draws), int)
    covered = 0
    for y in low[1] + steps * (high[1] - low[1]):
        crossing = (at[..., 1].min(axis=1) <= y) & (at[..., 1].max(axis=1) >= y)
        if crossing.any():
            some, numbers = _row(at[crossing], owner[crossing], low[0] + steps * (high[0] - low[0]), y)
            covered += some
            np.add.at(wrong, numbers, 1)
    guilty = np.flatnonzero(wrong > max(3, 0.02 * covered))
    return draws[int(guilty[0])] if len(guilty) else None


def _row(
    at: NDArray[np.float64], owner: NDArray[np.int_], x: NDArray[np.float64], y: float
) -> tuple[int, NDArray[np.int_]]:
    """Along one row of points: how many are covered, and the Draw of each that covers what is nearer."""
    a, b, c = at[:, 0], at[:, 1], at[:, 2]
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    usable = np.abs(area) > 1e-9
    a, b, c, area, owner = a[usable], b[usable], c[usable], area[usable], owner[usable]
    if not len(area):
        return 0, owner

    def weight(p: NDArray[np.float64], q: NDArray[np.float64]) -> NDArray[np.float64]:
        dx, dy = (q - p)[:, 0], (q - p)[:, 1]
        return np.asarray((dx[:, None] * (y - p[:, 1:2]) - dy[:, None] * (x - p[:, :1])) / area[:, None])

    u, v, w = weight(b, c), weight(c, a), weight(a, b)
    inside = (u > 0) & (v > 0) & (w > 0)
    depth = u * a[:, 2:] + v * b[:, 2:] + w * c[:, 2:]
    seen = inside.any(axis=0)
    last = len(inside) - 1 - np.argmax(inside[::-1], axis=0)  # who draws last at each point
    nearest = np.where(inside, depth, np.inf).min(axis=0, initial=np.inf)
    shown = np.take_along_axis(depth, last[None], axis=0)[0]
    margin = 1e-4 + 1e-3 * np.ptp(at[..., 2])
    behind = seen & (shown > nearest + margin)
    return int(seen.sum()), owner[last[behind]]
