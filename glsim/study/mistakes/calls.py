"""Mistakes that are seen at a single call, and errors."""

from __future__ import annotations

import inspect
import math
from functools import cache

from glsim.machine.commands import COMMANDS, FAMILIES
from glsim.machine.frame import Frame
from glsim.machine.record import implementations
from glsim.study.mistakes.rules import EVERY, Findings, Rule, Seen, rule
from glsim.study.provenance import Step
from glsim.study.text import call_text


@cache
def _parameters(name: str) -> tuple[str, ...]:
    return tuple(inspect.signature(implementations[name]).parameters)


@rule
class Surplus(Rule):
    """Silent for as many arguments as the command takes."""

    kind, topic = "surplus", "calls"
    looks_at = "arguments that a command ignores"
    sentence = "{call}: {name} takes {count} ({names}) and ignores what comes after{other}"
    commands = EVERY

    def on_call(self, step: Step) -> Findings:
        call, names = step.call, _parameters(step.call.name)
        if step.trail or len(call.arguments) <= len(names):
            return
        one = COMMANDS[call.name]
        wider = [
            c.name for c in FAMILIES[one.family] if len(c.parameters) == len(call.arguments) and c.type == one.type
        ]
        other = f": {wider[0]} takes {len(call.arguments)}" if wider else ""
        count = f"{len(names)} argument{'s' * (len(names) != 1)}"
        words = {"call": call_text(call), "name": call.name, "count": count, "names": ", ".join(names), "other": other}
        yield step.number, words


@rule
class Radians(Rule):
    """Silent for whole numbers, and for angles that are no usual angle in radians."""

    kind, topic = "radians", "calls"
    looks_at = "radians for glRotate"
    sentence = (
        "{call} turns by {angle:.4g} degrees; if {degrees:.6g} degrees were meant, leave out the conversion: glRotate"
        " takes degrees"
    )
    commands = frozenset({"glRotate"})

    def on_call(self, step: Step) -> Findings:
        angle = float(step.call.arguments[0])
        if not step.trail and is_radians(angle):
            yield step.number, {"call": call_text(step.call), "angle": angle, "degrees": math.degrees(angle)}


def is_radians(angle: float) -> bool:
    """Whether an angle for glRotate looks like degrees converted to radians: exactly a whole or half number of degrees,
    or 30, 45, 60, 90, ... degrees in a few digits."""
    if not math.isfinite(angle) or angle == 0.0 or abs(angle) > 2.0 * math.pi + 1e-6 or angle.is_integer():
        return False
    degrees = abs(math.degrees(angle))
    exact = abs(2.0 * degrees - round(2.0 * degrees)) < 1e-6 and degrees > 0.5
    return exact or any(abs(degrees - usual) < 2e-3 * usual for usual in (30, 45, 60, 90, 120, 135, 150, 180, 270, 360))


@rule
class MatrixStack(Rule):
    """Silent if each glPushMatrix has its glPopMatrix in the end, each matrix mode by itself, and for a program that
    an error ended in between."""

    kind, topic = "matrix-stack", "calls"
    looks_at = "glPushMatrix without glPopMatrix"
    sentence = "this glPushMatrix has no glPopMatrix: if that is so in each frame, the stack overflows"
    commands = frozenset({"glPushMatrix", "glPopMatrix"})

    def __init__(self, frame: Frame) -> None:
        super().__init__(frame)
        self.pushes: dict[int, list[int]] = {}  # by matrix mode

    def on_call(self, step: Step) -> Findings:
        pushes = self.pushes.setdefault(step.before.state.transform.matrix_mode, [])
        if step.after is not step.before and step.call.name == "glPushMatrix":
            pushes.append(step.number)
        elif step.after is not step.before and pushes:
            pushes.pop()
        yield from ()

    def at_end(self, draws: list[Seen]) -> Findings:
        for push in () if self.frame.error else sorted(push for pushes in self.pushes.values() for push in pushes):
            yield push, {}


@rule
class Error(Rule):
    """Silent for a program that runs to its end."""

    kind, topic = "error", "calls"
    looks_at = "an error that ends the program"
    sentence = "{error}"

    def at_end(self, draws: list[Seen]) -> Findings:
        if self.frame.error:
            yield len(self.frame.calls) - 1, {"error": self.frame.error, "where": self.frame.error_at}
