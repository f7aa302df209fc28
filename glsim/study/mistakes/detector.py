"""Telling all rules each call and each Draw of a program."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from glsim.machine.commands import COMMANDS
from glsim.machine.frame import Draw, Frame
from glsim.study.mistakes.rules import RULES, Findings, Mistake, Rule, Seen
from glsim.study.provenance import Step


class Detector:
    """Is told each Step and each Draw of a frame in order, and says what is wrong."""

    def __init__(self, frame: Frame) -> None:
        self.frame = frame
        self.rules = [one(frame) for one in RULES.values()]
        self.told: dict[str, list[Rule]] = {}  # by name of a command
        for name, command in COMMANDS.items():
            self.told[name] = [one for one in self.rules if command.family in one.commands]
        self.draws: list[Seen] = []

    def call(self, step: Step) -> Iterator[Mistake]:
        for one in self.told[step.call.name]:
            with suppress(IndexError, TypeError, ValueError):  # arguments for which the program has got an error
                yield from self._said(one, one.on_call(step), step)

    def draw(self, draw: Draw, step: Step) -> Iterator[Mistake]:
        seen = Seen(draw, step, step.after.state)
        _ = seen.lit and seen.normals_given  # kept: the provenance is true only now
        self.draws.append(seen)
        for one in self.rules:
            yield from self._said(one, one.on_draw(seen))

    def end(self) -> Iterator[Mistake]:
        for one in self.rules:
            yield from self._said(one, one.at_end(self.draws))

    def _said(self, one: Rule, findings: Findings, step: Step | None = None) -> Iterator[Mistake]:
        for number, words in findings:
            where = self.frame.calls[number].where if 0 <= number < len(self.frame.calls) else None
            if step is not None and step.trail and number == step.number:
                where = step.call.where  # of the call in the display list
            yield Mistake(one.kind, one.sentence.format(**words), number, words.get("where", where))


def checked() -> dict[str, str]:
    """kind -> what is looked at, also where nothing is found."""
    return {kind: one.looks_at for kind, one in RULES.items()}
