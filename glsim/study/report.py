"""Probes, explanations and traces as tables for the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isnan
from pathlib import Path
from typing import Any

from rich.console import Group
from rich.table import Table
from rich.text import Text

from glsim.machine.frame import Where
from glsim.study.explain import Explanation, Setting
from glsim.study.mistakes import CHECKED
from glsim.study.probe import Evaluation, Fragment, LightTerms, Probe
from glsim.study.trace import Trace


def number(value: float) -> str:
    """At most four digits after the point; 0.0000 is only written for what is not 0."""
    return f"{value:.4g}" if value == 0 or abs(value) >= 1000 else f"{value:.4f}"


def vector(values: Sequence[float]) -> str:
    return "(" + ", ".join(number(value) for value in values) + ")"


def swatch(color: Sequence[int]) -> Text:
    r, g, b = color[:3]
    return Text.assemble(("    ", f"on rgb({r},{g},{b})"), f" ({r}, {g}, {b}, {color[3]})  #{r:02x}{g:02x}{b:02x}")


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
    parts.append(_afterwards(winner))
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
        weights = ("-" if isnan(v.linear) else f"{v.linear:.4f}", f"{v.hyperbolic:.4f}")
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
    row("glow", "k_a I_a, I_a of the scene " + vector(e.scene_ambient), e.glow, end_section=True)
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


def _afterwards(fragment: Fragment) -> Table:
    table = Table("step", "how", title="From there to the picture", title_justify="left")
    for channel in "RGBA":
        table.add_column(channel, justify="right")
    ways = {
        "flat": "the provoking vertex' own",
        "colours interpolated": "the vertices' colours times their hyperbolic weights",
        "Phong": "the fragment's own",
    }
    words = next((text for key, text in ways.items() if key in fragment.shading), "")
    table.add_row("colour", words, *map(number, fragment.primary))
    for step in fragment.steps:
        table.add_row(step.name, step.formula, *map(number, step.color))
    table.add_row("8 bits", f"round(255 x), before {fragment.before}", *map(str, fragment.computed), style="bold")
    return table


# ---------------------------------------------------------------- explain


def explanations(all_of_them: Sequence[Explanation]) -> Iterator[Table]:
    """The first draw whole; of the others what is not as in the draw before."""
    known: dict[str, Setting] = {}
    for explanation in all_of_them:
        yield explained(explanation, known)
        known = {setting.name: setting for setting in (*explanation.key, *explanation.uniforms)}


def explained(explanation: Explanation, known: dict[str, Setting]) -> Table:
    """known: settings that need not be shown again."""
    where = line(explanation.where)
    title = f"draw {explanation.draw}: {explanation.what} {where}".rstrip()
    table = Table("call", "line", "->  GLSL", "value", title=title, title_justify="left")
    for heading, settings in (("key", explanation.key), ("uniforms", explanation.uniforms)):
        shown = [setting for setting in settings if known.get(setting.name) != setting]
        for number_of, setting in enumerate(shown):
            calls = "\n".join(f"{o.text} {o.through}".rstrip() for o in setting.origins) or "(initial value)"
            lines = "\n".join(line(origin.where) for origin in setting.origins)
            note = Text(f"\n{setting.note}" if setting.note else "", style="dim")
            table.add_row(calls, lines, setting.name, Text.assemble(setting.value, note),
                          end_section=number_of == len(shown) - 1)  # fmt: skip
        if not shown:
            table.add_row("", "", f"the {heading} as in the draw before", "", end_section=True)
    return table


# ---------------------------------------------------------------- trace


def calls_table(trace: Trace) -> Table:
    table = Table("", "call", "line", "what it changed")
    for entry in trace.entries:
        changes = "\n".join(f"{state}: {old} -> {new}" for state, old, new in entry.changes)
        if entry.redundant:
            changes = "redundant: it was so already"
        changes = entry.note or changes
        if entry.drew:
            changes = f"{entry.drew} draw" + ("s" if entry.drew > 1 else "") + (f"\n{changes}" if changes else "")
        table.add_row(
            str(entry.call),
            entry.text,
            line(entry.where),
            changes,
            style="dim" if entry.redundant or entry.note else "",
        )
    return table


def mistakes_list(trace: Trace) -> Text:
    if not trace.mistakes:
        checks = "\n".join(f"  {what}" for what in CHECKED.values())
        return Text.assemble(("None of these mistakes was found; others were not looked for:\n", "green"), checks)
    parts: list[tuple[str, str]] = []
    for mistake in trace.mistakes:
        parts += [
            (f"{line(mistake.where) or 'program'}: ", "bold"),
            (f"{mistake.kind}: ", "red"),
            (mistake.sentence + "\n", ""),
        ]
    return Text.assemble(*parts)
