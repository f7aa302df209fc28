"""Why a pixel has its colour: every fragment that came to it, with every factor of every term.

The GPU says which primitives cover the pixel and with which weights (glsim.render.inspect); the equation and what
follows it are evaluated in NumPy (glsim.shading, glsim.study.fragments).  What comes out must be the picture's pixel.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from glsim.machine.frame import Where
from glsim.study.text import as_json

Numbers = tuple[float, ...]
Bytes = tuple[int, int, int, int]


@dataclass(frozen=True)
class Vertex:
    """A corner of the primitive.  number: in the program's Draw, -1 if glsim made it.  position: in object space.  eye:
    its position in eye space.  normal: in eye space, before it is turned round for a back side.  window: pixels from
    the lower left, and depth; NaN if the corner is behind the eye.  linear: the corner's weight on the screen.
    hyperbolic: its perspective-correct weight.  Values are interpolated with the hyperbolic weights, or with the linear
    ones under GL_AFFINE_GLSIM; the weights that are not used are NaN if a corner is behind the eye.  color: RGBA: the
    result of lighting in [0, 1] if the equation ran at the vertices, else the vertex's current colour."""

    number: int
    position: Numbers
    eye: Numbers
    normal: Numbers
    window: Numbers
    linear: float
    hyperbolic: float
    color: Numbers


@dataclass(frozen=True)
class LightTerms:
    """What one light adds (see shading.Contribution).  vector: "H" or "R"; direction: of it; cosine: N.H or R.V."""

    light: int
    I_a: Numbers
    I_d: Numbers
    I_s: Numbers
    L: Numbers
    d: float
    attenuation: float
    spot: float
    N_L: float
    V: Numbers
    vector: str
    direction: Numbers
    cosine: float
    power: float
    ambient: Numbers
    diffuse: Numbers
    specular: Numbers


@dataclass(frozen=True)
class Evaluation:
    """One evaluation of the illumination equation.  at: "fragment" or "vertex 3"; weight: its share of the fragment's
    colour; sum: before clamping."""

    at: str
    weight: float
    P: Numbers
    N: Numbers
    k_a: Numbers
    k_d: Numbers
    k_s: Numbers
    n: float
    emission: Numbers
    ambient: Numbers
    scene_ambient: Numbers
    lights: tuple[LightTerms, ...]
    sum: Numbers
    clamped: Numbers


@dataclass(frozen=True)
class Step:
    """What happens to the fragment after lighting.  color: RGBA after it; passed: False if the fragment ends here."""

    name: str
    formula: str
    color: Numbers
    passed: bool = True


@dataclass(frozen=True)
class Fragment:
    """One fragment at the pixel.

    packet: number in frame.packets; draw: among the Draws, -1 for a pixel rectangle; where: the call's line.
    what: such as "triangle 5 of GL_QUADS, quad 2".  shading: where the equation ran, in words.
    killed: the test that the fragment failed, or "colour mask"; "" if it was written.
    before, after: the pixel before and after the fragment, RGBA of 8 bits, from the GPU; computed: ``after`` as
    evaluated on the CPU.
    """

    packet: int
    draw: int
    where: Where | None
    what: str
    front: bool
    shading: str
    vertices: tuple[Vertex, ...]
    P: Numbers
    N: Numbers
    evaluations: tuple[Evaluation, ...]
    primary: Numbers
    highlight: Numbers
    steps: tuple[Step, ...]
    depth: float
    killed: str
    before: Bytes
    after: Bytes
    computed: Bytes


@dataclass(frozen=True)
class Event:
    """A glClear or glAccum.  covers: whether it overwrites the pixel's colour; after: the pixel then, 8-bit RGBA."""

    packet: int
    what: str
    where: Where | None
    covers: bool
    after: Bytes


@dataclass(frozen=True)
class Probe:
    """A pixel and all that happened to it.

    x, y: in pixels from the upper left.  height: of the picture.  pixel: its RGBA in the picture, 8 bits each.
    computed: the winner's ``computed``; the same as ``pixel`` if there is no winner, or an event came after it.
    """

    x: int
    y: int
    height: int
    pixel: Bytes
    computed: Bytes
    fragments: tuple[Fragment, ...]
    events: tuple[Event, ...]

    def __repr__(self) -> str:
        seen = "the background" if self.winner is None else f"draw {self.winner.draw}, {self.winner.what}"
        return f"<Probe ({self.x}, {self.y}): pixel {self.pixel}, {len(self.fragments)} fragments, seen is {seen}>"

    @property
    def covered(self) -> Event | None:
        """The last glClear or glAccum that left nothing of what was there before."""
        return next((event for event in reversed(self.events) if event.covers), None)

    @property
    def winner(self) -> Fragment | None:
        """The last fragment that was written and is still there; None where only the background is seen."""
        first = -1 if self.covered is None else self.covered.packet
        seen = (fragment for fragment in reversed(self.fragments) if not fragment.killed and fragment.packet > first)
        return next(seen, None)

    def as_dict(self) -> dict[str, Any]:
        """Plain dictionaries, lists and numbers: for JSON."""
        return {**as_json(self), "winner": None if self.winner is None else self.fragments.index(self.winner)}

    def latex(self) -> str:
        """The winning fragment's equation with its numbers, as LaTeX."""
        from glsim.study.formulas import latex

        return latex(self)

    def mathml(self) -> str:
        """The same as MathML."""
        from glsim.study.formulas import mathml

        return mathml(self)

    def _repr_latex_(self) -> str:
        return self.latex()

    def __rich__(self) -> Any:
        from glsim.study.report import probe_report

        return probe_report(self)
