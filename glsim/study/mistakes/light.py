"""Mistakes with lights: where they are, and whether they shine."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from glsim.machine import constants as gl
from glsim.machine.frame import Frame
from glsim.study.mistakes.rules import Findings, Rule, Seen, is_look_at, rule, via
from glsim.study.provenance import BEFORE, Path, Step


@rule
class NoLight(Rule):
    """Silent if any draw of the picture has a light (a first pass without may be meant), if the program set the
    light of the scene, and for materials that emit light."""

    kind, topic = "no-light", "light"
    looks_at = "lights are on but no light is enabled"
    sentence = (
        "GL_LIGHTING is on, but no light is enabled: only the dim glow of the scene is left; call glEnable(GL_LIGHT0)"
    )

    def at_end(self, draws: list[Seen]) -> Findings:
        lit = [seen for seen in draws if seen.lit]
        if any(any(seen.state.lighting.light_enabled) for seen in lit):
            return
        for seen in lit:
            face = seen.draw.material.front
            if seen.setter("lighting", "ambient") is None and not any(face.emission[:3]):
                yield seen.at(seen.setter("lighting", "enabled")), {}
                return


@rule
class BlackLight(Rule):
    """Silent for GL_LIGHT0, and as soon as one colour of the light is not black or its diffuse colour was set."""

    kind, topic = "black-light", "light"
    looks_at = "GL_LIGHT1 to 7 left black"
    sentence = (
        "GL_LIGHT{light} is enabled, but black: unlike GL_LIGHT0, whose colours are white, it shines only after"
        " glLightfv(GL_LIGHT{light}, GL_DIFFUSE, (1, 1, 1, 1))"
    )

    def on_draw(self, seen: Seen) -> Findings:
        lighting = seen.state.lighting
        if not seen.lit:
            return
        for k, enabled in enumerate(lighting.light_enabled):
            light = lighting.lights[k]
            black = not any((*light.ambient[:3], *light.diffuse[:3], *light.specular[:3]))
            if enabled and k and black and seen.setter("lighting", "lights", k, "diffuse") is None:
                yield seen.at(seen.setter("lighting", "light_enabled", k)), {"light": k}


@rule
class PositionOfThree(Rule):
    """Silent for four numbers."""

    kind, topic = "position-of-three", "light"
    looks_at = "a GL_POSITION of three numbers"
    sentence = (
        "GL_POSITION of GL_LIGHT{light} has three numbers; the missing w counts as 0, a direction, and in C it would be"
        " whatever lies behind the array: add 1.0 for a lamp at that point, 0.0 for a direction"
    )
    commands = frozenset({"glLight"})

    def on_call(self, step: Step) -> Findings:
        light, name, value = (*step.call.arguments, None, None, None)[:3]
        if name == gl.GL_POSITION and np.size(value) == 3:
            yield step.number, {"light": int(light) - gl.GL_LIGHT0}


@rule
class LightBeforeCamera(Rule):
    """Silent for a light at the eye or along the view (a headlight)."""

    kind, topic = "light-before-camera", "light"
    looks_at = "a light placed before gluLookAt"
    sentence = (
        "the position of GL_LIGHT{light} was set before {camera}: it is fixed to the camera; if it shall stay in the"
        " world, set GL_POSITION after gluLookAt"
    )

    def on_draw(self, seen: Seen) -> Findings:
        cameras = self._look_ats(seen.modelview_calls)
        if not cameras or not seen.lit or seen.bent:
            return
        lighting, provenance = seen.state.lighting, seen.provenance
        for k, enabled in enumerate(lighting.light_enabled):
            path: Path = ("lighting", "lights", k, "position")
            setter, placed = provenance.setters.get(path, BEFORE), provenance.placed.get(path)
            if not enabled or placed is None or setter == BEFORE or setter > cameras[0] or self._look_ats(placed.chain):
                continue
            x, y, z, w = lighting.lights[k].position
            if x == y == 0.0 and (z == 0.0 or w == 0.0):
                continue
            camera = via(self.frame.calls[cameras[0]]) + self.line(cameras[0])
            yield setter, {"light": k, "camera": camera}

    def _look_ats(self, chain: Sequence[int]) -> list[int]:
        return self.calls_of(list(chain), is_look_at)


@rule
class NoSpecular(Rule):
    """A light was given a specular colour, or a material a shininess, and no material of the picture has k_s.  Silent
    if one has, by glMaterial or by glColorMaterial, and where the program made it black itself."""

    kind, topic = "no-k_s", "light"
    looks_at = "specular light without k_s"
    sentence = (
        "{cause} has no effect: GL_SPECULAR of the material is black, as it is at the start, so there is no highlight;"
        " call glMaterialfv(GL_FRONT, GL_SPECULAR, ...)"
    )

    def __init__(self, frame: Frame) -> None:
        super().__init__(frame)
        self.shiny = False
        self.causes: dict[int, str] = {}

    def on_draw(self, seen: Seen) -> Findings:
        lighting = seen.state.lighting
        if seen.lit and any(lighting.light_enabled):
            materials = [seen.draw.material, *(material for _, material in seen.draw.material_changes())]
            tracked = lighting.color_material and lighting.color_material_mode == gl.GL_SPECULAR
            said = seen.setter("material", "front", "specular") is not None  # to be black: that is meant
            self.shiny |= tracked or said or any(any(face.specular[:3]) for m in materials for face in m)
            shininess = seen.setter("material", "front", "shininess")
            if shininess is not None and seen.draw.material.front.shininess > 0.0:
                self.causes[seen.at(shininess)] = "GL_SHININESS"
            for k, enabled in enumerate(lighting.light_enabled):
                setter = seen.setter("lighting", "lights", k, "specular")
                if enabled and setter is not None and any(lighting.lights[k].specular[:3]):
                    self.causes[seen.at(setter)] = f"GL_SPECULAR of GL_LIGHT{k}"
        yield from ()

    def at_end(self, draws: list[Seen]) -> Findings:
        if self.causes and not self.shiny:
            number = min(self.causes)
            yield number, {"cause": self.causes[number]}
