"""A Probe's equation with its numbers as LaTeX and as MathML.

A formula is a list of lines; a line is a list of atoms: words of a small vocabulary, or numbers.  Both notations are
written from the same lines.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

if TYPE_CHECKING:
    from glsim.study.probe import Evaluation, Probe

Line = list[str | float | Sequence[float]]

_PRODUCT = "<mrow><mo>(</mo><mi>{}</mi><mo>&#8901;</mo><mi>{}</mi><mo>)</mo></mrow>"

# a word -> LaTeX, MathML
SYMBOLS = {
    "=": ("&=", "<mo>=</mo>"),
    "+": ("+", "<mo>+</mo>"),
    "*": (r"\,", "<mo>&#8290;</mo>"),
    "x": (r"\cdot", "<mo>&#8901;</mo>"),
    "(": ("(", "<mo>(</mo>"),
    ")": (")", "<mo>)</mo>"),
    "I": ("I", "<mi>I</mi>"),
    "clamp": (r"\mathrm{clamp}", "<mi>clamp</mi>"),
    "attenuation": (r"\mathrm{attenuation}", "<mi>attenuation</mi>"),
    "spot": (r"\mathrm{spot}", "<mi>spot</mi>"),
    **{
        name: (rf"{name[0]}_{{{name[2:]}}}", f"<msub><mi>{name[0]}</mi><mi>{name[2:]}</mi></msub>")
        for name in ("k_a", "k_d", "k_s", "I_a", "I_d", "I_s")
    },
    "N.L": (r"(N\cdot L)", _PRODUCT.format("N", "L")),
    "N.H^n": (r"(N\cdot H)^n", f"<msup>{_PRODUCT.format('N', 'H')}<mi>n</mi></msup>"),
    "R.V^n": (r"(R\cdot V)^n", f"<msup>{_PRODUCT.format('R', 'V')}<mi>n</mi></msup>"),
}  # fmt: skip


def lines(evaluation: Evaluation) -> Iterator[Line]:
    """The equation at one place: a line for each term, first in symbols, then in numbers."""
    e = evaluation
    yield [f"The equation at the {e.at}"]
    yield ["emission", "=", e.emission]
    yield ["ambient", "=", "k_a", "*", "I_a", "=", e.k_a, "x", e.scene_ambient, "=", e.ambient]
    for light in e.lights:
        of = "N.H^n" if light.vector == "H" else "R.V^n"
        plain = light.attenuation == light.spot == 1.0
        factor: Line = [] if plain else [light.attenuation, "x", light.spot, "x"]
        named: Line = [] if plain else ["attenuation", "*", "spot", "*"]
        name = f" of light {light.light}"
        yield [
            "ambient" + name,
            "=",
            *named,
            "k_a",
            "*",
            "I_a",
            "=",
            *factor,
            e.k_a,
            "x",
            light.I_a,
            "=",
            light.ambient,
        ]
        diffuse: Line = [*factor, e.k_d, "x", light.I_d, "x", max(light.N_L, 0.0)]
        yield ["diffuse" + name, "=", *named, "k_d", "*", "I_d", "*", "N.L", "=", *diffuse, "=", light.diffuse]
        specular: Line = [*factor, e.k_s, "x", light.I_s, "x", light.power]
        yield ["specular" + name, "=", *named, "k_s", "*", "I_s", "*", of, "=", *specular, "=", light.specular]
    yield ["I", "=", e.sum]
    if e.sum != e.clamped:
        yield ["clamp", "(", "I", ")", "=", e.clamped]


def _document(probe: Probe) -> Iterator[Line]:
    yield [f"Pixel ({probe.x}, {probe.y})", "=", probe.pixel]
    winner = probe.winner
    if winner is None:
        return
    yield [winner.shading]
    for evaluation in winner.evaluations:
        yield from lines(evaluation)
    if len(winner.evaluations) > 1:
        total: Line = ["interpolated", "="]
        for k, evaluation in enumerate(winner.evaluations):
            total += [*(["+"] if k else []), evaluation.weight, "x", evaluation.clamped]
        yield [*total, "=", winner.primary[:3]]
    if not winner.evaluations:
        yield ["colour", "=", winner.primary[:3]]
    for step in winner.steps:
        if step.name.endswith("test"):
            yield [f"{step.name}: {step.formula}"]
        else:
            yield [f"{step.name} ({step.formula})", "=", step.color[:3]]


def _digits(value: float) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def latex(probe: Probe) -> str:
    """An aligned display equation."""

    def atom(part: str | float | Sequence[float]) -> str:
        if isinstance(part, str):
            return SYMBOLS[part][0] if part in SYMBOLS else rf"\text{{{_escaped(part)}}}"
        if isinstance(part, (int, float)):
            return _digits(part)
        return r"\begin{pmatrix}" + r"\\".join(map(_digits, part)) + r"\end{pmatrix}"

    return (
        "$$\\begin{aligned}\n" + " \\\\\n".join(_once(line, atom) for line in _document(probe)) + "\n\\end{aligned}$$"
    )


def _once(line: Line, atom: Callable[[str | float | Sequence[float]], str]) -> str:
    """A LaTeX line with one alignment mark "&": at its first "=", or at its beginning if it has none."""
    words = " ".join(map(atom, line)).replace("&=", "\0", 1).replace("&=", "=").replace("\0", "&=")
    return words if "&=" in words else "&" + words


def _escaped(text: str) -> str:
    return "".join("\\" + c if c in "_%&#{}$" else r"\^{}" if c == "^" else c for c in text)


def mathml(probe: Probe) -> str:
    """A MathML table with a row for each line."""

    def atom(part: str | float | Sequence[float]) -> str:
        if isinstance(part, str):
            return SYMBOLS[part][1] if part in SYMBOLS else f"<mtext>{escape(part)}</mtext>"
        if isinstance(part, (int, float)):
            return f"<mn>{_digits(part)}</mn>"
        rows = "".join(f"<mtr><mtd><mn>{_digits(value)}</mn></mtd></mtr>" for value in part)
        return f"<mrow><mo>(</mo><mtable>{rows}</mtable><mo>)</mo></mrow>"

    rows = "".join(f"<mtr><mtd><mrow>{''.join(map(atom, line))}</mrow></mtd></mtr>" for line in _document(probe))
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mtable>{rows}</mtable></math>'
