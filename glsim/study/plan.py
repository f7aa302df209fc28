"""Which axes a comparison has: its columns and rows, from what ``compare`` was asked for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from glsim.names import LOBES as LOBE_NAMES
from glsim.names import did_you_mean
from glsim.study import axes as ax
from glsim.study.axes import Axis, Setting, Value
from glsim.study.looks import LOBES, MODES, ONE_LOBE, SHADED, Look, look

DEFAULT_MODES = ("flat", "gouraud", "phong")


class Plan(NamedTuple):
    """The axes, and what all pictures have in common."""

    columns: Axis
    rows: Axis
    start: Setting
    legend: str

    def turned(self, columns: str | None) -> Plan:
        """The plan with the axis of this name as columns."""
        names = [self.columns.name, self.rows.name]
        if columns is None or columns == names[0]:
            return self
        if columns != names[1]:
            raise ValueError(f"compare: columns can be {' or '.join(filter(None, names))}, not {columns!r}"
                             f"{did_you_mean(columns, names)}")  # fmt: skip
        return self._replace(columns=self.rows, rows=self.columns)


def _words(given: str | Sequence[str]) -> list[str]:
    """Names in a text, or in a list.  Raises TypeError for what is no name."""
    for word in given:
        if not isinstance(word, str):
            raise TypeError(f"compare: modes and lobes are names, not {word!r}")
    return [word.strip() for word in (given.split(",") if isinstance(given, str) else given)]


def looks_of(modes: str | Sequence[str] | None, no_scene: bool, sweeps: int) -> dict[str, Look]:
    """The looks by their names."""
    if no_scene:
        if modes is not None or sweeps:
            raise ValueError("compare: modes and sweeps need a scene to draw: name one beside the pictures")
        return {}
    words = (DEFAULT_MODES if sweeps < 2 else ("phong",)) if modes is None else _words(modes)
    found = [look(word) for word in words]
    names = [":".join(filter(None, one)) for one in found]
    if not names:
        raise ValueError(f"compare: modes are {', '.join(MODES)}, not none")
    _once("mode", names)
    return dict(zip(names, found, strict=True))


def lobes_of(lobes: str | Sequence[str] | None) -> list[str] | None:
    if lobes is None:
        return None
    names = [LOBE_NAMES.get(name, name) for name in _words(lobes)]
    unknown = [name for name in names if name not in LOBES]
    if unknown or not names:
        hint = did_you_mean(unknown[0], LOBES) if unknown else ""
        raise ValueError(f"compare: lobes are {', '.join(LOBES)}, not {', '.join(unknown) or 'none'}{hint}")
    _once("lobe", names)
    return names


def _once(kind: str, names: Sequence[str]) -> None:
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise ValueError(f"compare: {kind} {twice} is given twice")


def planned(
    looks: dict[str, Look], lobes: list[str] | None, given: Mapping[str, Any], sweeps: Mapping[str, Any], room: bool,
    parameters: Sequence[str],
) -> Plan:  # fmt: skip
    """The columns are modes; the rows are lobes, or the values of a sweep.  Two sweeps make both: the first the
    columns."""
    swept = [ax.sweep(name, values, parameters) for name, values in sweeps.items()]
    if len(swept) > 2 or (len(swept) == 2 and (len(looks) > 1 or given or len(lobes or []) > 1)):
        names = ", ".join([*(["mode"] if len(looks) > 1 else []), *(axis.name for axis in swept)])
        raise ValueError(f"compare: a sheet has two axes, not {names}: of two sweeps give one mode and one lobe")
    if room and swept:
        raise ValueError("compare: with radiosity the scene has its own lamps and materials, so nothing is swept")
    if swept and lobes and len(lobes) > 1:
        looks = _with_lobes(looks, lobes)
        lobes = lobes[:1]
    named = any(one.lobe for one in looks.values())
    driver = all(one.mode == "native" for one in looks.values())  # which has no other lobe
    single = any(one.mode in ONE_LOBE for one in looks.values())
    lobes = lobes or (["blinn"] if swept or named or single else list(LOBES))
    if looks and driver and not given and "blinn" not in lobes:
        raise ValueError("compare: the driver's fixed function has the lobe blinn only")
    start = Setting(lobe=lobes[0])
    if not looks:
        return Plan(Axis("picture", ax.picture_values(given)), Axis("", (Value("", "", ax.putting()),)), start, "")
    modes = ax.mode_axis(looks.items())
    modes = modes._replace(values=modes.values + ax.picture_values(given))
    _once("column", modes.names)
    legend = _legend(looks, lobes)
    if len(swept) == 2:
        start = replace(start, look=next(iter(looks.values())))
        return Plan(swept[0], swept[1], start, f"{modes.values[0].label}: {legend}")
    if swept:
        return Plan(modes, swept[0], start, legend)
    if room:
        return Plan(modes, Axis("lobe", (Value("diffuse", "", ax.putting()),)), start, "")
    rows = ax.lobe_axis(lobes)
    if named and len(lobes) == 1:  # the columns say which lobe
        rows = rows._replace(values=(rows.values[0]._replace(label=""),))
    return Plan(modes, rows, start, legend)


def _with_lobes(looks: dict[str, Look], lobes: list[str]) -> dict[str, Look]:
    """Each look with each lobe, where it has lobes and names none."""
    found = {}
    for name, one in looks.items():
        if one.lobe or one.mode == "native" or MODES[one.mode].options != SHADED:
            found[name] = one
        else:
            found |= {f"{name}:{lobe}": one._replace(lobe=lobe) for lobe in lobes}
    return found


def _legend(looks: dict[str, Look], lobes: list[str]) -> str:
    """The illumination equation, if it is evaluated."""
    if not any(MODES[one.mode].options for one in looks.values()):
        return ""
    several = len(lobes) > 1 or any(one.lobe for one in looks.values())
    cosine = "cos" if several else {"blinn": "(N·H)", "phong": "(R·V)"}[lobes[0]]
    return f"I(N) = k_a I_a + k_d I_d (N·L) + k_s I_s {cosine}^n"
