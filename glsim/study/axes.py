"""Axes of a comparison: what changes from column to column and from row to row.

An axis is a name and a list of values; each value says how it changes the Setting of a picture: what is drawn
(``segments``, ``camera``), with which lights and materials (``light``, ``shininess``), or how (``mode``, ``lobe``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from math import cos, radians, sin
from typing import Any, NamedTuple

import numpy as np

from glsim.names import did_you_mean
from glsim.scenes.staging import Camera, Lamp, attenuation, camera_of, cutoff, lamp_of, within
from glsim.study import changes
from glsim.study.changes import ChangeOf
from glsim.study.looks import GOURAUD, LOBES, Look


@dataclass(frozen=True)
class Setting:
    """What decides a picture.

    arguments: of the source that draws, such as ("segments", 16).  changes: of the state of all draws.
    look, lobe: how it is shaded; picture: the name of a given picture that is shown instead.
    """

    look: Look = GOURAUD
    lobe: str = "blinn"
    arguments: tuple[tuple[str, Any], ...] = ()
    changes: tuple[ChangeOf, ...] = ()
    picture: str | None = None


class Value(NamedTuple):
    """A column or a row.  name: its key in results; label, formula: its heading."""

    name: str
    label: str
    change: Callable[[Setting], Setting]
    formula: str = ""


class Axis(NamedTuple):
    name: str
    values: tuple[Value, ...]

    @property
    def names(self) -> list[str]:
        return [value.name for value in self.values]


def putting(**values: Any) -> Callable[[Setting], Setting]:
    """A change of a Setting to these values."""
    return lambda old: replace(old, **values)


def mode_axis(looks: Iterable[tuple[str, Look]]) -> Axis:
    """Looks by name."""
    return Axis("mode", tuple(Value(name, one.label, putting(look=one), one.formula) for name, one in looks))


def lobe_axis(lobes: Iterable[str]) -> Axis:
    return Axis("lobe", tuple(Value(name, LOBES[name], putting(lobe=name)) for name in lobes))


def picture_values(names: Iterable[str]) -> tuple[Value, ...]:
    return tuple(Value(name, name, putting(picture=name)) for name in names)


# ---------------------------------------------------------------- what can be swept


class Sweepable(NamedTuple):
    """read: text -> value, raises ValueError.  state: value -> change of state; None: an argument of the source.
    separator: between the values of a list.  label: str.format of the value's text."""

    read: Callable[[str], Any]
    state: Callable[[Any], ChangeOf] | None = None
    separator: str = ","
    label: str = "{}"


def _number(name: str, least: float, most: float) -> Callable[[str], float]:
    return lambda text: within(name, text, least, most)


def _segments(text: str) -> int:
    value = within("the number of segments", text, 1, 2000)
    if value % 1.0:
        raise ValueError(f"the number of segments is a whole one, not {text}")
    return int(value)


SWEEPABLE = {
    "segments": Sweepable(_segments, label="{} segments"),
    "shininess": Sweepable(_number("shininess", 0, 128), changes.shininess, label="n = {}"),
    "material": Sweepable(str),
    "light": Sweepable(lamp_of, changes.light, "/", "light {}"),
    "brightness": Sweepable(_number("the brightness", 0, 1000), changes.brightness, label="I_d = I_s = {}"),
    "attenuation": Sweepable(attenuation, changes.attenuation, "/", "attenuation {}"),
    "cutoff": Sweepable(cutoff, changes.cutoff, label="cutoff {}°"),
    "exponent": Sweepable(_number("a spot's exponent", 0, 128), changes.exponent, label="spot exponent {}"),
    "ambient": Sweepable(_number("ambient", 0, 10), changes.ambient, label="I_a = {}"),
    "camera": Sweepable(camera_of, None, "/", "camera {}"),
}


def sweep(name: str, given: Any, parameters: Iterable[str] = ()) -> Axis:
    """An axis of values.

    given: the values, or one of them, or their text as on the command line.  parameters: of a drawing function; it can
    be swept by these as by the names of SWEEPABLE.
    Raises ValueError for an unknown name, a value that cannot be, or the same value twice.
    """
    known = {**SWEEPABLE, **{own: Sweepable(str, label=own + " = {}") for own in parameters}}
    if name not in known:
        raise ValueError(f"compare: axes are {', '.join(known)}, not {name!r}{did_you_mean(name, known)}")
    kind = known[name]
    given = given.split(kind.separator) if isinstance(given, str) else given
    texts = list(given) if isinstance(given, (list, tuple, range, np.ndarray)) else [given]
    values = []
    for one in texts:
        text = one.strip() if isinstance(one, str) else _text(one)
        try:
            value = one if isinstance(one, (Lamp, Camera)) or name in parameters else kind.read(text)
        except ValueError as error:
            raise ValueError(f"compare: {name}: {error}") from None
        values.append(_value(name, text, kind, value))
    names = [value.name for value in values]
    if not names or len(set(names)) < len(names):
        raise ValueError(f"compare: {name} needs values, each once, not {', '.join(names) or 'none'}")
    return Axis(name, tuple(values))


def _value(name: str, text: str, kind: Sweepable, value: Any) -> Value:
    if kind.state is not None:
        change = kind.state(value)

        def put(old: Setting) -> Setting:  # where a light is comes first: a cone is for one at a place
            return replace(old, changes=(change, *old.changes) if name == "light" else (*old.changes, change))

        return Value(text, kind.label.format(text), put)
    pair = (name, value)
    return Value(text, kind.label.format(text), lambda old: replace(old, arguments=(*old.arguments, pair)))


def _text(value: Any) -> str:
    """A value of Python as it would be typed."""
    if isinstance(value, Lamp):
        return ",".join(f"{number:g}" for number in value.position)
    if isinstance(value, Camera):
        return f"{value.azimuth:g},{value.elevation:g},{value.distance:g}"
    if isinstance(value, (tuple, list)):
        return ",".join(map(_text, value))
    return f"{value:g}" if isinstance(value, float) else str(value)


# ---------------------------------------------------------------- animations


def animation(text: str, frames: int, view: Camera | None) -> Axis:
    """The third axis of a comparison, along time: "turntable", "light" (once around) or NAME=VALUES.

    view: the camera that goes around; None where the source sets its own."""
    name, equals, values = text.partition("=")
    if equals:
        return sweep(name, values)
    if frames < 1:
        raise ValueError(f"compare: an animation has 1 picture or more, not {frames}")
    turns = [360.0 * k / frames for k in range(frames)]
    if text == "turntable":
        if view is None:
            raise ValueError("compare: a turntable needs a scene whose camera can move; animate the light instead")
        cameras = [replace(view, azimuth=view.azimuth + turn) for turn in turns]
        return sweep("camera", cameras)
    if text == "light":
        places = [(5.0 * sin(radians(turn)), 3.0, 5.0 * cos(radians(turn)) - 1.0, 0.0) for turn in turns]
        return sweep("light", [Lamp(place) for place in places])
    known = ("turntable", "light", *SWEEPABLE)
    raise ValueError(f"compare: animations are {', '.join(known[:2])} or NAME=VALUES, not {text!r}"
                     f"{did_you_mean(text, known)}")  # fmt: skip
