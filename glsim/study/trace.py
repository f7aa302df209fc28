"""The stream of calls with what each changed, calls that changed nothing, and classic mistakes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from glsim.machine.commands import COMMANDS
from glsim.machine.frame import Call, Draw, Frame, Where
from glsim.machine.record import REGISTERS_ONLY
from glsim.machine.state import Lighting
from glsim.play.frames import frame_of
from glsim.study.mistakes import Detector, Mistake, checked
from glsim.study.provenance import LOAD_FAMILIES, MULTIPLY_FAMILIES, NAMES, History, Step, value_at
from glsim.study.text import as_json, call_text, matrix_text, value_text


@dataclass(frozen=True)
class Entry:
    """One call, or a run of glVertex and the like.

    changes: (state, old value, new value) as text.  redundant: whether it set only values that were there already.
    drew: how many Draws it made.  note: why it has no effect.
    """

    call: int
    text: str
    where: Where | None
    changes: tuple[tuple[str, str, str], ...] = ()
    redundant: bool = False
    drew: int = 0
    note: str = ""


@dataclass(frozen=True)
class Trace:
    """What a program called, and what is wrong with it."""

    entries: list[Entry]
    mistakes: list[Mistake]

    def __repr__(self) -> str:
        kinds = ", ".join(mistake.kind for mistake in self.mistakes[:5]) + (", ..." if len(self.mistakes) > 5 else "")
        return f"<Trace: {len(self.entries)} entries, {len(self.mistakes)} mistakes{': ' if kinds else ''}{kinds}>"

    def _repr_html_(self) -> str:
        from glsim.study.report import html
        from glsim.study.tables import calls_table, mistakes_list

        return html(mistakes_list(self), calls_table(self))

    def as_dict(self) -> dict[str, Any]:
        return {
            "calls": as_json(self.entries),
            "mistakes": [{**entry._asdict(), "where": as_json(entry.where)} for entry in self.mistakes],
            "checked": checked(),
        }


def trace(what: Any, **options: Any) -> Trace:
    """The calls of ``what`` and the mistakes in them.

    what: a Frame captured with calls, or anything else that play.frames.frame_of takes, with its options.
    """
    frame = frame_of(what, calls=True, **options)
    return Trace(*_traced(frame))


def mistakes_of(frame: Frame) -> list[Mistake]:
    """Only the mistakes in a Frame that was captured with calls."""
    return _traced(frame, entries=False)[1]


@np.errstate(all="ignore")  # NaN and infinite numbers of a program are no mistakes of glsim's
def _traced(frame: Frame, entries: bool = True) -> tuple[list[Entry], list[Mistake]]:
    draws: dict[int, list[Draw]] = {}
    for draw in frame.draws:
        if draw.call is not None:
            draws.setdefault(draw.call, []).append(draw)
    counts = {number: len(made) for number, made in draws.items()}
    detector = Detector(frame)
    listed: list[Entry] = []
    mistakes: list[Mistake] = []
    run: list[tuple[int, Call]] = []
    colors = Colors()
    for step in History(frame).walk():
        number, call, after = step.number, step.call, step.after
        mistakes += detector.call(step)
        made = draws.get(number, [])
        for draw in [draw for draw in made if draw.trail == step.trail or not step.trail]:
            mistakes += detector.draw(draw, step)
            colors.used(draw.state.lighting)
            made.remove(draw)
        if step.trail or not entries:
            continue
        if call.name in REGISTERS_ONLY and call.name != "glBegin":
            run.append((number, call))
            colors.call(number, call)
            continue
        if COMMANDS[call.name].family in ("glRasterPos", "glWindowPos"):
            colors.used(after.state.lighting if call.name.startswith("glRasterPos") else None)
        listed += _run(run)
        run = []
        listed.append(_entry(step, counts.get(number, 0)))
    listed += _run(run)
    mistakes += detector.end()
    return [colors.noted(entry) for entry in listed], list(_once(mistakes))


class Colors:
    """Which calls of glColor no draw saw, because of lighting."""

    def __init__(self) -> None:
        self.new: list[int] = []  # glColor since the last draw
        self.current: list[int] = []  # the glColor in effect at the last draw, if any
        self.lit: set[int] = set()
        self.seen: set[int] = set()
        self.runs: dict[int, list[int]] = {}  # the first call of an Entry -> the glColor in it
        self.first, self.last = -1, -2

    def call(self, number: int, call: Call) -> None:
        """One of glVertex, glColor, ...: calls that follow each other make one Entry."""
        self.first = number if number != self.last + 1 else self.first
        self.last = number
        if COMMANDS[call.name].family == "glColor":
            self.new.append(number)
            self.runs.setdefault(self.first, []).append(number)

    def used(self, lighting: Lighting | None) -> None:
        """A draw or glRasterPos uses the current colour.  lighting: its state; None where lighting does not apply."""
        used = self.new or self.current
        ignored = lighting is not None and lighting.enabled and not lighting.color_material
        (self.lit if ignored else self.seen).update(used)
        self.new, self.current = [], used[-1:]

    def noted(self, entry: Entry) -> Entry:
        inside = self.runs.get(entry.call, [])
        if not inside or not self.lit.issuperset(inside) or not self.seen.isdisjoint(inside):
            return entry
        return replace(entry, note="glColor has no effect: GL_LIGHTING is on and GL_COLOR_MATERIAL is off")


def _once(mistakes: list[Mistake]) -> Iterator[Mistake]:
    """Each kind of mistake once a line."""
    said = set()
    for mistake in mistakes:
        place = mistake.where[:2] if mistake.where is not None else mistake.call
        if (mistake.kind, place) not in said:
            said.add((mistake.kind, place))
            yield mistake


def _run(run: list[tuple[int, Call]]) -> Iterator[Entry]:
    """glNormal, glVertex, ... in a row, counted."""
    if len(run) == 1:
        yield Entry(run[0][0], call_text(run[0][1]), run[0][1].where)
    elif run:
        counts: dict[str, int] = {}
        for _, call in run:
            counts[call.name] = counts.get(call.name, 0) + 1
        text = ", ".join(f"{count} {name}" for name, count in counts.items())
        yield Entry(run[0][0], text, run[0][1].where)


def _entry(step: Step, drew: int) -> Entry:
    call, before, after = step.call, step.before, step.after
    changes = []
    for path in step.paths:
        old = value_text(value_at(before.state, before.material, path))
        new = value_text(value_at(after.state, after.material, path))
        if old != new:
            changes.append((".".join(map(str, path)), old, new))
    matrices = zip(NAMES, before.matrices, after.matrices, before.depths, after.depths, strict=True)
    for name, a, b, deep, deeper in matrices:
        if deep != deeper:
            changes.append((f"{name} stack", f"{deep} deep", f"{deeper} deep"))
        old, new = matrix_text(a.get()), matrix_text(b.get())
        if old != new:
            changes.append((name, old, new))
    family = COMMANDS[call.name].family
    sets = bool(step.paths) or family in LOAD_FAMILIES or family in MULTIPLY_FAMILIES
    glut = call.where is not None and call.where.via.startswith("glut")  # not the user's doing
    redundant = sets and not changes and not COMMANDS[call.name].result and not glut
    return Entry(step.number, call_text(call), call.where, tuple(changes), redundant, drew)
