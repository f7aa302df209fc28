"""The stream of calls with what each changed, calls that changed nothing, and classic mistakes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from glsim.machine.commands import COMMANDS
from glsim.machine.frame import Call, Draw, Frame, Moment, Where
from glsim.machine.record import REGISTERS_ONLY
from glsim.study.explain import matrix_text, value_text
from glsim.study.frames import frame_of
from glsim.study.mistakes import Detector, Mistake
from glsim.study.provenance import NAMES, History, Path, call_text, value_at


@dataclass(frozen=True)
class Entry:
    """One call, or a run of glVertex and the like.

    changes: (state, old value, new value) as text; redundant: it set what was set already; drew: number of its Draws.
    """

    call: int
    text: str
    where: Where | None
    changes: tuple[tuple[str, str, str], ...] = ()
    redundant: bool = False
    drew: int = 0


@dataclass(frozen=True)
class Trace:
    """What a program called, and what is wrong with it."""

    entries: list[Entry]
    mistakes: list[Mistake]

    def as_dict(self) -> dict[str, Any]:
        from glsim.study.probe import plain

        return {
            "calls": plain(self.entries),
            "mistakes": [{**entry._asdict(), "where": plain(entry.where)} for entry in self.mistakes],
        }


def trace(what: Any, **options: Any) -> Trace:
    """The calls of ``what`` and the mistakes in them.

    what: a Frame captured with calls, or anything else that study.frames.frame_of takes, with its options.
    """
    frame = frame_of(what, calls=True, **options)
    return Trace(*_traced(frame))


def _traced(frame: Frame) -> tuple[list[Entry], list[Mistake]]:
    draws: dict[int, list[Draw]] = {}
    for draw in frame.draws:
        if draw.call is not None:
            draws.setdefault(draw.call, []).append(draw)
    detector = Detector(frame)
    entries: list[Entry] = []
    mistakes: list[Mistake] = []
    run: list[tuple[int, Call]] = []
    for number, call, before, after, paths, provenance in History(frame).walk():
        mistakes += detector.call(number, call, before, after)
        for draw in draws.get(number, ()):
            mistakes += detector.draw(draw, provenance)
        if call.name in REGISTERS_ONLY and call.name != "glBegin":
            run.append((number, call))
            continue
        entries += _run(run)
        run = []
        entries.append(_entry(number, call, before, after, paths, len(draws.get(number, ()))))
    entries += _run(run)
    mistakes += detector.end()
    return entries, list(_once(mistakes))


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


def _entry(number: int, call: Call, before: Moment, after: Moment, paths: list[Path], drew: int) -> Entry:
    changes = []
    for path in paths:
        old = value_text(value_at(before.state, before.material, path))
        new = value_text(value_at(after.state, after.material, path))
        if old != new:
            changes.append((".".join(map(str, path)), old, new))
    for name, a, b, deep, deeper in zip(
        NAMES, before.matrices, after.matrices, before.depths, after.depths, strict=True
    ):
        if deep != deeper:
            changes.append((f"{name} stack", f"{deep} deep", f"{deeper} deep"))
        elif a is not b:
            changes.append((name, matrix_text(a.get()), matrix_text(b.get())))
    sets = bool(paths) and not COMMANDS[call.name].result
    return Entry(number, call_text(call), call.where, tuple(changes), sets and not changes, drew)
