"""Probes as tables for the terminal, and tables as HTML."""

from __future__ import annotations

from collections.abc import Sequence
from io import StringIO
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console, Group
from rich.table import Table
from rich.text import Text

from glsim.machine.frame import Where

if TYPE_CHECKING:
    from glsim.study.probe import Evaluation, Fragment, LightTerms, Probe


def number(value: float) -> str:
    """At most four digits after the point; 0.0000 is only written for what is not 0."""
    return f"{value:.4g}" if value == 0 or abs(value) >= 1000 else f"{value:.4f}"


def vector(values: Sequence[float]) -> str:
    return "(" + ", ".join(number(value) for value in values) + ")"


def swatch(color: Sequence[int]) -> Text:
    r, g, b = color[:3]
    return Text.assemble(("    ", f"on rgb({r},{g},{b})"), f" ({r}, {g}, {b}, {color[3]})  #{r:02x}{g:02x}{b:02x}")


def html(*parts: Any) -> str:
    """Tables and texts as HTML, for Jupyter."""
    console = Console(file=StringIO(), record=True, width=160, force_jupyter=False)
    for part in parts:
        console.print(part)
    return console.export_html(inline_styles=True, code_format='<pre style="line-height: 1.2">{code}</pre>')


def line(where: Where | None) -> str:
    return f"{Path(where.file).name}:{where.line}" if where is not None else ""


def place(fragment: Fragment) -> str:
    where = fragment.where
    return line(where) + (f" ({where.via})" if where is not None and where.via else "")


def probe_report(probe: Probe) -> Group:
    parts: list[Any] = [Text.assemble((f"Pixel ({probe.x}, {probe.y})  ", "bold"), swatch(probe.pixel))]
    parts.append(Text.assemble("the equation gives  ", swatch(probe.computed)))
    parts.append(_history(probe))
    winner = probe.winner
    if winner is None:
        by = f", by {probe.covered.what} {line(probe.covered.where)}".rstrip() if probe.covered is not None else ""
        parts.append(f"No fragment is seen here: this is the background{by}.")
        return Group(*parts)
    draw = f"draw {winner.draw}, " if winner.draw >= 0 else ""
    side = f", {'front' if winner.front else 'back'} side" if len(winner.vertices) == 3 else ""
    title = f"{draw}{winner.what}{side} {place(winner)}".rstrip()
    parts += ["", Text(f"It shows {title}", style="bold")]
    if winner.vertices:
        parts += [Text(winner.shading), _vertices(winner, probe.height)]
        if winner.evaluations:
            parts.append(f"at the pixel, in eye space:  P = {vector(winner.P)}   N = {vector(winner.N)}")
    parts += [_evaluation(evaluation) for evaluation in winner.evaluations]
    parts.append(_after_lighting(winner))
    return Group(*parts)


def _history(probe: Probe) -> Table:
    headings = ("#", "what came to the pixel", "where", "outcome", "pixel")
    table = Table(*headings, title="History", title_justify="left")
    rows: list[tuple[int, tuple[Any, ...]]] = []
    first = -1 if probe.covered is None else probe.covered.packet
    for event in probe.events:
        row = (str(event.packet), event.what, line(event.where), "covers all" if event.covers else "", str(event.after))
        rows.append((event.packet, row))
    for fragment in probe.fragments:
        outcome = f"fails the {fragment.killed}" if fragment.killed else "written"
        outcome = "not written: colour mask" if fragment.killed == "colour mask" else outcome
        outcome += ", covered later" if not fragment.killed and fragment.packet < first else ""
        row = (str(fragment.packet), fragment.what, place(fragment), outcome, str(fragment.after))
        rows.append((fragment.packet, row))
    for _, row in sorted(rows, key=lambda entry: entry[0]):
        table.add_row(*row)
    return table


def _vertices(fragment: Fragment, height: int) -> Table:
    """On the screen y counts from the top, as the pixel's does."""
    table = Table("vertex", "object space", "eye space", "normal", "on screen", title_justify="left")
    for heading in ("linear", "hyperbolic", "R", "G", "B"):
        table.add_column(heading, justify="right")
    for v in fragment.vertices:
        name = str(v.number) if v.number >= 0 else "-"
        at = "behind the eye" if isnan(v.window[0]) else f"({v.window[0]:.1f}, {height - v.window[1]:.1f})"
        weights = ("-" if isnan(weight) else f"{weight:.4f}" for weight in (v.linear, v.hyperbolic))
        table.add_row(
            name, vector(v.position), vector(v.eye[:3]), vector(v.normal), at, *weights, *map(number, v.color[:3])
        )
    return table


def _evaluation(e: Evaluation) -> Table:
    weight = "" if e.weight == 1.0 else f", weight {e.weight:.4f}"
    table = Table("term", "factors", title=f"The equation at the {e.at}{weight}", title_justify="left")
    for channel in "RGB":
        table.add_column(channel, justify="right")

    def row(term: str, factors: str, values: Sequence[float] | None = None, **style: Any) -> None:
        table.add_row(term, factors, *(map(number, values) if values else ("", "", "")), **style)

    row("P, N", f"{vector(e.P)}  {vector(e.N)}")
    row("emission", "", e.emission)
    row("k_a", "", e.k_a)
    row("k_d", "", e.k_d)
    row("k_s", f"n = {e.n:g}", e.k_s)
    row("ambient", "k_a I_a, I_a of the scene " + vector(e.scene_ambient), e.ambient, end_section=True)
    for light in e.lights:
        _light_rows(row, light)
    row("sum", "", e.sum, style="bold")
    row("clamped", "to [0, 1]" if e.sum != e.clamped else "nothing to clamp", e.clamped)
    return table


def _light_rows(row: Any, light: LightTerms) -> None:
    name = f"light {light.light}"
    d = "a direction" if light.d == float("inf") else f"d = {number(light.d)}"
    row(name, f"L = {vector(light.L)}, {d}, attenuation {number(light.attenuation)}, spot {number(light.spot)}")
    behind = "" if light.N_L > 0.0 else "  <= 0: the light is behind"
    row("", f"N.L = {number(light.N_L)}{behind}")
    of = "N.H" if light.vector == "H" else "R.V"
    row("", f"{light.vector} = {vector(light.direction)}, V = {vector(light.V)}")
    row("", f"{of} = {number(light.cosine)}, ({of})^n = {number(light.power)}")
    f = "" if light.attenuation == light.spot == 1.0 else "attenuation spot "
    row("  ambient", f"{f}k_a I_a, I_a = {vector(light.I_a)}", light.ambient)
    row("  diffuse", f"{f}k_d I_d (N.L), I_d = {vector(light.I_d)}", light.diffuse)
    row("  specular", f"{f}k_s I_s ({of})^n, I_s = {vector(light.I_s)}", light.specular, end_section=True)


def _after_lighting(fragment: Fragment) -> Table:
    table = Table("step", "how", title="From there to the picture", title_justify="left")
    for channel in "RGBA":
        table.add_column(channel, justify="right")
    weights = "linear" if ", affine" in fragment.shading else "hyperbolic"
    sources = {
        "flat": "the provoking vertex' own",
        "colours interpolated": f"the vertices' colours times their {weights} weights",
        "Phong": "the fragment's own",
    }
    words = next((text for key, text in sources.items() if key in fragment.shading), "")
    table.add_row("colour", words, *map(number, fragment.primary))
    for step in fragment.steps:
        table.add_row(step.name, step.formula, *map(number, step.color))
    table.add_row("8 bits", f"round(255 x), before {fragment.before}", *map(str, fragment.computed), style="bold")
    return table
