"""What a rule is: one classic mistake, what is said of it, and what it is told of a program."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import corners
from glsim.machine.commands import COMMANDS
from glsim.machine.frame import Call, Draw, Frame, Where
from glsim.machine.state import Snapshot
from glsim.render.batch import assembled
from glsim.study.mistakes.surfaces import Surface, surface
from glsim.study.provenance import BEFORE, Provenance, Step

Findings = Iterator[tuple[int, dict[str, Any]]]  # (number of a call, words for the sentence)


class Mistake(NamedTuple):
    """kind: of RULES; call: its number."""

    kind: str
    sentence: str
    call: int
    where: Where | None

    @property
    def looks_at(self) -> str:
        """The mistake in a few words."""
        return RULES[self.kind].looks_at


@dataclass
class Seen:
    """One Draw, at the time when the walk through the calls has come to it.

    step: the call that made it, with the provenance of the state, which is true only now.  asked: the state that the
    program set; in ``draw.state`` the depth and stencil tests are off where the window has no such buffer.
    """

    draw: Draw
    step: Step
    asked: Snapshot
    memo: dict[str, Any] = field(default_factory=dict)  # what rules have computed and share

    @property
    def call(self) -> int:
        return self.draw.call or 0

    @property
    def state(self) -> Snapshot:
        return self.draw.state

    @property
    def provenance(self) -> Provenance:
        return self.step.provenance

    @property
    def modelview_calls(self) -> list[int]:
        """The calls whose product is the modelview matrix."""
        return self.provenance.chains["modelview"][-1]

    @property
    def projection_calls(self) -> list[int]:
        return self.provenance.chains["projection"][-1]

    def setter(self, *path: str | int) -> int | None:
        """The call that set a piece of state, BEFORE if that is older than the recording; None if nothing set it."""
        return self.provenance.setters.get(path)

    def at(self, number: int | None) -> int:
        """The call ``number``, or the one that draws if that is not known."""
        return self.call if number is None or number == BEFORE else number

    @cached_property
    def chosen(self) -> NDArray[np.uint32]:
        """The vertices of its primitives, in order (numbers in the block)."""
        return assembled(self.draw)

    @property
    def areas(self) -> bool:
        """Whether it makes triangles that are filled."""
        polygon = self.state.polygon
        filled = polygon.front_mode == polygon.back_mode == gl.GL_FILL
        return corners(self.draw.mode) == 3 and filled and len(self.chosen) > 0

    @cached_property
    def bent(self) -> bool:
        """Whether the modelview matrix is projective: w is not 1."""
        return bool(np.any(self.draw.matrices[0].get()[:, 3] != (0.0, 0.0, 0.0, 1.0)))

    @property
    def lit(self) -> bool:
        return self.state.lighting.enabled and len(self.chosen) > 0

    @cached_property
    def surface(self) -> Surface:
        return surface(self.draw, self.chosen)

    @cached_property
    def normals_given(self) -> bool:
        """Whether the program gave normals: with glNormal, or from an array, or through a shape of GLU or GLUT."""
        given = self.draw.block.rows[np.unique(self.chosen), 3:6]
        return "glNormal" in self.provenance.registers or not bool((given == (0.0, 0.0, 1.0)).all())


class Rule:
    """One mistake.  The docstring of a subclass says when it stays silent.

    kind: its name.  topic: a heading of TOPICS.  looks_at: the mistake in a few words.  sentence: what is said of it,
    with {words} to be filled in.  commands: families of commands whose calls it is told of, or EVERY.
    """

    kind: ClassVar[str]
    topic: ClassVar[str]
    looks_at: ClassVar[str]
    sentence: ClassVar[str]
    commands: ClassVar[frozenset[str]] = frozenset()

    def __init__(self, frame: Frame) -> None:
        self.frame = frame

    def on_call(self, step: Step) -> Findings:
        """Told each call of ``commands``, in order; those in display lists when a list is called."""
        return iter(())

    def on_draw(self, seen: Seen) -> Findings:
        """Told each Draw, in order."""
        return iter(())

    def at_end(self, draws: list[Seen]) -> Findings:
        """Told all Draws at the end; their provenance is that of the end."""
        return iter(())

    # ------------------------------------------------------------ helpers

    def line(self, number: int) -> str:
        """ " (line 12)" """
        where = self.frame.calls[number].where
        return f" (line {where.line})" if where is not None else ""

    def calls_of(self, numbers: list[int] | tuple[int, ...], is_it: Callable[[Call], bool]) -> list[int]:
        """Those calls of a product of matrices that are what is asked for, first one first."""
        return [number for number in numbers if number != BEFORE and is_it(self.frame.calls[number])]


EVERY = frozenset(command.family for command in COMMANDS.values())
RULES: dict[str, type[Rule]] = {}
TOPICS = ("camera", "light", "colours and material", "normals and winding", "texture", "depth and buffers", "calls")


def rule(one: type[Rule]) -> type[Rule]:
    """Decorates the class of a rule: it is looked for from now on."""
    assert one.topic in TOPICS
    assert one.kind not in RULES
    RULES[one.kind] = one
    return one


def via(call: Call) -> str:
    """The call of GLU or GLUT that a call came from, as text; "" if the program made it itself."""
    return call.where.via if call.where is not None else ""


def is_look_at(call: Call) -> bool:
    return via(call).startswith("gluLookAt") and COMMANDS[call.name].family == "glMultMatrix"


def is_perspective(call: Call) -> bool:
    return via(call).startswith("gluPerspective") or call.name == "glFrustum"
