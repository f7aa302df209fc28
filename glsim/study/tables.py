"""Explanations and traces as tables for the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rich.table import Table
from rich.text import Text

from glsim.study.mistakes import RULES, TOPICS
from glsim.study.report import line

if TYPE_CHECKING:
    from glsim.study.explain import Explanation, Setting
    from glsim.study.trace import Trace

# ---------------------------------------------------------------- explain


def explanations(all_of_them: Sequence[Explanation]) -> Iterator[Table]:
    """A table for each Draw: all settings of the first, and of each other those that differ from the Draw before."""
    known: dict[str, Setting] = {}
    for explanation in all_of_them:
        yield explained(explanation, known)
        known = {setting.name: setting for setting in (*explanation.key, *explanation.uniforms)}


def explained(explanation: Explanation, known: dict[str, Setting]) -> Table:
    """The table of one Draw.  known: settings that need not be shown again."""
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
        looked_at = ((topic, "; ".join(r.looks_at for r in RULES.values() if r.topic == topic)) for topic in TOPICS)
        lines = "\n".join(f"  {topic}: {what}" for topic, what in looked_at)
        return Text.assemble(("None of these mistakes was found; others were not looked for:\n", "green"), lines)
    parts: list[tuple[str, str]] = []
    for mistake in trace.mistakes:
        parts += [
            (f"{line(mistake.where) or 'program'}: ", "bold"),
            (f"{mistake.kind}: ", "red"),
            (mistake.sentence + "\n", ""),
        ]
    return Text.assemble(*parts)
