"""Mistakes with colours: out of range, or ignored."""

from __future__ import annotations

import numpy as np

from glsim.machine import constants as gl
from glsim.machine.commands import COMMANDS
from glsim.machine.frame import Frame
from glsim.study.mistakes.rules import Findings, Rule, Seen, rule
from glsim.study.provenance import Step
from glsim.study.text import call_text

TOPIC = "colours and material"
ARRAYS = frozenset({
    "glDrawArrays", "glDrawElements", "glDrawRangeElements", "glMultiDrawArrays", "glMultiDrawElements",
})  # fmt: skip
LARGEST = {"b": 127, "s": 32767, "i": 2**31 - 1, "us": 65535, "ui": 2**32 - 1}  # what means 1.0


@rule
class ColorRange(Rule):
    """Colours of 0 to 255 where 0 to 1 is wanted.  Silent up to 10 for glColor and glClearColor and up to 50 for lights
    and materials, because more than 1 is a way to make things bright; and for glColor3ub, whose small numbers tell
    objects apart when picking."""

    kind, topic = "color-range", TOPIC
    looks_at = "glColor with 0 to 255"
    sentence = "{call}: {cause}"
    commands = frozenset({"glColor", "glClearColor", "glLight", "glMaterial"})

    def on_call(self, step: Step) -> Findings:
        call = step.call
        family = COMMANDS[call.name].family
        if family in ("glLight", "glMaterial") and (
            len(call.arguments) < 3 or call.arguments[1] not in COLOR_NAMES or np.size(call.arguments[2]) < 3
        ):
            return
        given = call.arguments[2] if family in ("glLight", "glMaterial") else call.arguments
        try:
            values = np.abs(np.ravel(np.asarray(given, np.float64)))
        except (TypeError, ValueError):
            return
        largest = float(values.max(initial=0.0))
        suffix = call.name.removeprefix(family).lstrip("34").removesuffix("v") if family == "glColor" else ""
        if suffix == "ub" or (family in ("glLight", "glMaterial") and call.name.endswith("iv")):
            return
        if suffix in LARGEST:
            if 0.0 < largest <= 255.0 and LARGEST[suffix] > 255:
                cause = f"1.0 is {LARGEST[suffix]} here, so this is black; take glColor3f with 0 to 1, or glColor3ub"
                yield step.number, {"call": call_text(call), "cause": cause}
        elif largest >= (50.0 if family in ("glLight", "glMaterial") else 10.0):
            cause = "colours go from 0 to 1, and what is more counts as 1; divide by 255"
            ub = ", or take glColor3ub" if family == "glColor" and largest <= 255.0 else ""
            yield step.number, {"call": call_text(call), "cause": cause + ub}

    def on_draw(self, seen: Seen) -> Findings:
        if seen.step.call.name in ARRAYS and len(seen.chosen):
            largest = float(np.max(seen.draw.block.rows[np.unique(seen.chosen), 6:9], initial=0.0))
            if largest >= 10.0 and np.ptp(seen.draw.block.rows[seen.chosen, 6:9], axis=0).any():
                cause = f"the colours in the array go to {largest:g}, but should from 0 to 1; take GL_UNSIGNED_BYTE"
                yield seen.call, {"call": call_text(seen.step.call), "cause": cause}


COLOR_NAMES = (gl.GL_AMBIENT, gl.GL_DIFFUSE, gl.GL_SPECULAR, gl.GL_EMISSION, gl.GL_AMBIENT_AND_DIFFUSE)


@rule
class ColorIgnored(Rule):
    """A colour that no draw uses but lit ones without GL_COLOR_MATERIAL.  Silent for white; for a colour that a draw
    without light or a raster position uses too; and where the program sets materials, unless one material stands for
    several colours."""

    kind, topic = "color-ignored", TOPIC
    looks_at = "glColor that lighting ignores"
    sentence = (
        "{what} has no effect: GL_LIGHTING is on, and the colour comes from the material; glEnable(GL_COLOR_MATERIAL),"
        " or glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, ...)"
    )
    commands = frozenset({"glRasterPos", "glWindowPos"})

    def __init__(self, frame: Frame) -> None:
        super().__init__(frame)
        self.ignored: dict[int, tuple[int | None, tuple[float, ...]]] = {}  # glColor -> call of the material, colour
        self.useful: set[int] = set()

    def on_call(self, step: Step) -> Findings:
        lighting = step.after.state.lighting
        number = step.provenance.registers.get("glColor")
        lit = lighting.enabled and not lighting.color_material and step.call.name.startswith("glRasterPos")
        if number is not None and not lit:
            self.useful.add(number)
        yield from ()

    def on_draw(self, seen: Seen) -> Findings:
        number = seen.provenance.registers.get("glColor")
        array = seen.step.call.name in ARRAYS
        if not len(seen.chosen):
            return
        if not seen.lit or seen.state.lighting.color_material:
            if number is not None:
                self.useful.add(number)
            return
        rows = seen.draw.block.rows[np.unique(seen.chosen), 6:10]
        colors = rows if seen.draw.color is None else np.asarray([seen.draw.color])
        blended = seen.state.color_buffer.blend
        white = (np.abs(colors[:, : 4 if blended else 3] - 1.0) < 0.02).all()
        material = seen.setter("material", "front", "diffuse")
        if array and np.ptp(colors, axis=0).any():
            if material is None:
                yield seen.call, {"what": "the array of colours"}
        elif number is not None and not white:
            self.ignored.setdefault(number, (material, tuple(np.round(colors[-1].astype(float), 3))))

    def at_end(self, draws: list[Seen]) -> Findings:
        lost = {number: found for number, found in self.ignored.items() if number not in self.useful}
        for number, (material, _) in sorted(lost.items()):
            different = {color for setter, color in lost.values() if setter == material}
            if material is None or len(different) > 1:
                yield number, {"what": call_text(self.frame.calls[number])}


@rule
class ColorMaterialOrder(Rule):
    """Silent if glColorMaterial changes nothing, or comes first."""

    kind, topic = "color-material-order", TOPIC
    looks_at = "GL_COLOR_MATERIAL enabled before glColorMaterial"
    sentence = (
        "glEnable(GL_COLOR_MATERIAL){line} came before this glColorMaterial: in between the current colour went into"
        " ambient and diffuse of both sides; call glColorMaterial first"
    )
    commands = frozenset({"glEnable", "glDisable", "glColorMaterial"})

    def __init__(self, frame: Frame) -> None:
        super().__init__(frame)
        self.on: int | None = None  # glEnable(GL_COLOR_MATERIAL) that came before any glColorMaterial
        self.said = False

    def on_call(self, step: Step) -> Findings:
        name = step.call.name
        if name != "glColorMaterial":
            if step.call.arguments[0] == gl.GL_COLOR_MATERIAL:
                self.on = step.number if name == "glEnable" and not self.said else None
            return
        old, new = step.before.state.lighting, step.after.state.lighting
        same = old.color_material_face == new.color_material_face and old.color_material_mode == new.color_material_mode
        if self.on is not None and not same:
            yield step.number, {"line": self.line(self.on)}
        self.said, self.on = True, None
