"""How a picture is drawn: its shading mode, specular lobe and back lighting, written as ``phong:blinn:two-sided``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from glsim.machine import constants as gl
from glsim.machine.frame import Frame
from glsim.names import LOBES as LOBE_NAMES
from glsim.names import SHADING, did_you_mean
from glsim.play.reshade import shaded
from glsim.study.changes import ChangeOf, light_model


class Mode(NamedTuple):
    """label: a heading.  formula: how a pixel's colour C comes about.  options: kinds of options that it takes."""

    label: str
    formula: str
    options: tuple[str, ...] = ()


SHADED = ("lobe", "back")
MODES = {
    "wireframe": Mode("Wireframe", "C = k_d,  all edges"),
    "hidden-line": Mode("Hidden line", "C = k_d,  edges that no face hides"),
    "unlit": Mode("Unlit", "C = k_d"),
    "flat": Mode("Flat", "C = I(N_k),  one vertex k for each face", SHADED),
    "gouraud": Mode("Gouraud", "C = w_1 I(N_1) + w_2 I(N_2) + w_3 I(N_3)", SHADED),
    "phong": Mode("Phong", "C = I(N/|N|),  N = w_1 N_1 + w_2 N_2 + w_3 N_3", SHADED),
    "native": Mode("Driver's fixed function", "I by the driver,  at the vertices", SHADED),
    "direct": Mode("Direct illumination", "B = E + R F E"),
    "radiosity": Mode("Radiosity", "B = E + R F B"),
    "pyrender": Mode("pyrender", "metallic-roughness,  at each pixel"),
}
OUTLINES = ("wireframe", "hidden-line")  # differences from them, or of them, mean nothing
RADIOSITY = ("direct", "radiosity")
ONE_LOBE = {"native": "fixed function has (N·H)^n only", "pyrender": "pyrender has one lobe only, drawn once"}
TRUEST = ("radiosity", "direct", "phong", "native", "gouraud", "flat")  # first what the others approximate
LOBES = {"blinn": "Blinn-Torrance  (N·H)^n", "phong": "Phong  (R·V)^n"}
BACK = {  # where N.L < 0: two_side, back lighting, in words
    "clamp": (False, gl.GL_CLAMP_NORMAL_GLSIM, "no light where N·L < 0"),
    "flip": (False, gl.GL_FLIP_NORMAL_GLSIM, "-N where N·L < 0"),
    "two-sided": (True, gl.GL_CLAMP_NORMAL_GLSIM, "-N on back faces"),
}
ALIASES = {**SHADING, "hiddenline": "hidden-line", "two-side": "two-sided", "twosided": "two-sided"}


class Look(NamedTuple):
    """A mode with its options; lobe None: as the row says, back None: as the scene has it."""

    mode: str = "gouraud"
    lobe: str | None = None
    back: str | None = None

    @property
    def label(self) -> str:
        """As a heading: "Phong shading, (N·H)^n, flip"."""
        lobe = " shading, " + LOBES[self.lobe].split("  ")[1] if self.lobe else ""
        return MODES[self.mode].label + lobe + (f", {self.back}" if self.back else "")

    @property
    def formula(self) -> str:
        """How the colour comes about, and what happens where N.L < 0: one line."""
        return ",  ".join(filter(None, (MODES[self.mode].formula, BACK[self.back][2] if self.back else "")))

    def changes(self) -> list[ChangeOf]:
        """What ``back`` changes in the state of the draws."""
        return [light_model(*BACK[self.back][:2])] if self.back else []

    def of(self, frame: Frame, lobe: str) -> Frame:
        """The frame's draws with this look; lobe: where the look names none."""
        return shaded(frame, self.mode, self.lobe or lobe)


GOURAUD = Look()


def truest(names: Sequence[str]) -> str:
    """Of columns the one that the others approximate: of looks the one that evaluates the light most fully (Phong
    shading does so at every pixel), of anything else the first."""
    modes = [name.partition(":")[0] for name in names]
    return next((names[modes.index(mode)] for mode in TRUEST if mode in modes), names[0])


def look(text: str) -> Look:
    """A look as it is written.  Raises ValueError for an unknown mode or option, or one that the mode does not take."""
    name, *options = (ALIASES.get(word, word) for word in text.strip().split(":"))
    if name not in MODES:
        raise ValueError(f"compare: modes are {', '.join(MODES)}, not {name or 'none'}{did_you_mean(name, MODES)}")
    given: dict[str, str] = {}
    for option in options:
        known = {**dict.fromkeys(LOBE_NAMES, "lobe"), **dict.fromkeys(BACK, "back")}
        if option not in known:
            hint = did_you_mean(option, known)
            raise ValueError(f"compare: {text}: options of a mode are {', '.join(known)}, not {option!r}{hint}")
        kind = known[option]
        if kind not in MODES[name].options:
            raise ValueError(f"compare: {text}: {name} has no {'lobe' if kind == 'lobe' else 'back lighting'}")
        if kind in given:
            raise ValueError(f"compare: {text}: {given[kind]} and {option} exclude each other")
        given[kind] = LOBE_NAMES.get(option, option) if kind == "lobe" else option
    if name == "native" and (given.get("lobe") == "phong" or given.get("back") == "flip"):
        raise ValueError(f"compare: {text}: the driver's fixed function has (N·H)^n, clamp and two-sided only")
    return Look(name, **given)
