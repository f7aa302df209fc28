"""A comparison as one live picture: what its columns and rows show side by side, a browser shows in place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from glsim.machine.frame import Frame
from glsim.study.axes import Axis, Setting, Value
from glsim.study.changes import changed
from glsim.study.live import Shading, shaded_live
from glsim.study.looks import MODES, RADIOSITY, Look
from glsim.study.plan import Plan
from glsim.study.sources import Source
from glsim.study.studio import Studio
from glsim.web.live import Live

SIZE = 480  # pixels: one picture has more room than each of several
NOT_LIVE = ("native", "pyrender", *RADIOSITY)
LOOKS = [name for name in MODES if name not in NOT_LIVE]


def live_sheet(
    plan: Plan, source: Source, title: str, controls: Sequence[str], samples: int, backend: str,
    captions: Mapping[str, str],
) -> Live:  # fmt: skip
    """Modes and lobes are chosen as such; of what is swept each value, or each pair of values, is a picture.

    Raises ValueError for modes that are drawn by something else than glsim's programs."""
    axes = {axis.name: axis for axis in (plan.rows, plan.columns)}
    looks = _looks(axes.pop("mode", None), plan.start)
    lobes = axes.pop("lobe", None)
    modes, rows = _split(looks, [plan.start.lobe] if lobes is None else lobes.names)
    with Studio(source.of_size(max(source.width, SIZE)), {}, samples, backend, calls=True) as studio:
        settings = _settings([*axes.values()], plan.start, captions)
        frames = {name: studio.frame(setting) for name, setting in settings.items()}
    shadings = {name: _shading(look) for name, look in modes.items()}
    first = next(iter(shadings)), rows[0]
    return replace(shaded_live(frames, title, shadings, rows, first, ["mode", "lobe", *controls], samples), apart=True)


def _looks(modes: Axis | None, start: Setting) -> dict[str, Look]:
    settings = {start.look.mode: start} if modes is None else {one.name: one.change(start) for one in modes.values}
    for name, setting in settings.items():
        if setting.picture is not None or setting.look.mode in NOT_LIVE:
            raise ValueError(f"compare: a live picture has the modes {', '.join(LOOKS)}, not {name}")
    return {name: setting.look for name, setting in settings.items()}


def _split(looks: dict[str, Look], lobes: list[str]) -> tuple[dict[str, Look], list[str]]:
    """Modes, and lobes: those that the looks name, if each mode is there with each of them."""
    named = list(dict.fromkeys(look.lobe for look in looks.values() if look.lobe))
    modes = {_words(look, looks): look._replace(lobe=None) for look in looks.values()}
    if len(named) * len(modes) == len(looks) > 0 and named:
        return modes, named
    return {name if look.lobe else _words(look, looks): look for name, look in looks.items()}, lobes


def _words(look: Look, looks: dict[str, Look]) -> str:
    """The mode and what happens where N.L < 0; the latter alone if all have one mode."""
    one = look.back and len({other.mode for other in looks.values()}) == 1
    return " ".join(filter(None, (None if one else look.mode, look.back)))


def _settings(axes: list[Axis], start: Setting, captions: Mapping[str, str]) -> dict[str, Setting]:
    """By their labels, or captions, the settings of all values of axes."""
    found = {"": replace(start, look=Look())}
    for axis in axes:
        found = {", ".join(filter(None, (name, _label(value, captions)))): value.change(setting)
                 for name, setting in found.items() for value in axis.values}  # fmt: skip
    return {name or "picture": setting for name, setting in found.items()}


def _label(value: Value, captions: Mapping[str, str]) -> str:
    """What a button says: of a number, of what it is."""
    number = value.name.lstrip("-").replace(".", "", 1).isdigit()
    return captions.get(value.name, value.label if number else value.name)


def _shading(look: Look) -> Shading:
    def shaded(frame: Frame, lobe: str) -> Frame:
        return look.of(changed(frame, look.changes())[0], lobe)

    return shaded
