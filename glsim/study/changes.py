"""Changes of lights, materials and light model in all that a Frame draws, and in the calls that led to it.

The driver's fixed function is given calls, glsim draws; a Change says the same to both, so that their pictures can
still be compared.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from glsim.machine import constants as gl
from glsim.machine.frame import Call, Draw, Frame, Vertices
from glsim.machine.state import Light, Lighting, Material
from glsim.scenes.staging import Lamp, Vector


class Change(NamedTuple):
    """draw: the changed copy of a Draw.  calls: what sets the same values in the initial state."""

    draw: Callable[[Draw], Draw]
    calls: tuple[Call, ...]


ChangeOf = Callable[[Frame], Change]  # a change may depend on what is there, such as which light is on


def changed(frame: Frame, wanted: Sequence[ChangeOf]) -> tuple[Frame, list[Change]]:
    """The frame with each Draw changed, one change after the other, and the changes for ``changed_calls``."""
    changes = []
    for change_of in wanted:
        changes.append(change_of(frame))
        frame = frame.map_draws(changes[-1].draw)
    return frame, changes


def changed_calls(calls: Sequence[Call], changes: Sequence[Change]) -> list[Call]:
    """The calls that make the changes, then the recorded ones without those that would set the same state anew.

    At the beginning the modelview matrix is the identity: positions of lights are in eye space."""
    first = [call for change in changes for call in change.calls]
    fixed = {target for call in first for target in _targets(call)}
    return [*first, *(call for call in calls if not fixed & set(_targets(call)))]


def _targets(call: Call) -> list[tuple[Any, ...]]:
    """What a call of glLight, glLightModel or glMaterial sets; nothing for others."""
    name, arguments = call.name, call.arguments
    if name.startswith("glLightModel"):
        return [("light model", int(arguments[0]))]
    if name.startswith("glLight"):
        return [("light", int(arguments[0]), int(arguments[1]))]
    if name.startswith("glMaterial"):
        return [("material", int(arguments[1]))]
    return []


# ---------------------------------------------------------------- light model and lights


def _lighting(change: Callable[[Lighting], Lighting], *calls: Call) -> Change:
    def draw(old: Draw) -> Draw:
        return old.with_state(old.state._replace(lighting=change(old.state.lighting)))

    return Change(draw, calls)


def light_model(two_side: bool, back_lighting: int) -> ChangeOf:
    """What happens where N.L < 0; the driver knows GL_LIGHT_MODEL_TWO_SIDE alone."""
    call = Call("glLightModeli", (gl.GL_LIGHT_MODEL_TWO_SIDE, int(two_side)))
    return lambda frame: _lighting(lambda old: old._replace(two_side=two_side, back_lighting=back_lighting), call)


def ambient(value: float) -> ChangeOf:
    """I_a of the scene, the glow that is everywhere."""
    color = (value, value, value, 1.0)
    call = Call("glLightModelfv", (gl.GL_LIGHT_MODEL_AMBIENT, color))
    return lambda frame: _lighting(lambda old: old._replace(ambient=color), call)


def first_light(frame: Frame) -> tuple[int, Light, Vector]:
    """Of the first lit draw: the number of the first light that is on, the light, and where its object's origin is in
    eye space.  Raises ValueError if nothing is lit."""
    for draw in frame.draws:
        lighting = draw.state.lighting
        if lighting.enabled and any(lighting.light_enabled):
            number = lighting.light_enabled.index(True)
            x, y, z = draw.matrices[0].get()[3, :3].tolist()
            return number, lighting.lights[number], (x, y, z)
    raise ValueError("compare: no light is on here, so none can be changed")


def _set_light(number: int, parameters: dict[str, Any]) -> Change:
    """A light with other values for some fields of ``Light``."""
    calls = [
        Call("glLightfv" if isinstance(value, tuple) else "glLightf",
             (gl.GL_LIGHT0 + number, getattr(gl, f"GL_{name.upper()}"), value))
        for name, value in parameters.items()
    ]  # fmt: skip

    def change(old: Lighting) -> Lighting:
        lights = list(old.lights)
        lights[number] = lights[number]._replace(**parameters)
        return old._replace(lights=tuple(lights))

    return _lighting(change, *calls)


def light(lamp: Lamp) -> ChangeOf:
    """The first light is put where ``lamp`` is, and takes its cone, attenuation and brightness where the lamp has
    any."""

    def of(frame: Frame) -> Change:
        number, _, middle = first_light(frame)
        parameters: dict[str, Any] = {"position": lamp.position}
        if lamp.cutoff != 180.0:
            parameters |= {"spot_cutoff": lamp.cutoff, "spot_exponent": lamp.exponent}
        if lamp.position[3] != 0.0:
            parameters["spot_direction"] = lamp.aim(middle)
        if lamp.attenuation != (1.0, 0.0, 0.0):
            parameters |= _attenuated(lamp.attenuation)
        if lamp.brightness != 1.0:
            parameters |= _bright(lamp.brightness)
        return _set_light(number, parameters)

    return of


def _placed_light(what: str, parameters: dict[str, Any]) -> ChangeOf:
    """Values of the first light that mean nothing if it is a direction."""

    def of(frame: Frame) -> Change:
        number, old, _ = first_light(frame)
        if old.position[3] == 0.0:
            raise ValueError(
                f"compare: {what} means nothing for a light that is a direction: put it at a place with W = 1,"
                " as in --light 0,2,3,1"
            )
        return _set_light(number, parameters)

    return of


def _attenuated(k: Vector) -> dict[str, Any]:
    return dict(zip(("constant_attenuation", "linear_attenuation", "quadratic_attenuation"), k, strict=True))


def _bright(value: float) -> dict[str, Any]:
    return dict.fromkeys(("diffuse", "specular"), (value, value, value, 1.0))


def attenuation(k: Vector) -> ChangeOf:
    return _placed_light("attenuation", _attenuated(k))


def brightness(value: float) -> ChangeOf:
    return lambda frame: _set_light(first_light(frame)[0], _bright(value))


def cutoff(degrees: float) -> ChangeOf:
    return _placed_light("a spot's cutoff", {"spot_cutoff": degrees})


def exponent(value: float) -> ChangeOf:
    return _placed_light("a spot's exponent", {"spot_exponent": value})


# ---------------------------------------------------------------- materials


def shininess(n: float) -> ChangeOf:
    """n of all materials, front and back."""

    def material(old: Material) -> Material:
        return Material(*(face._replace(shininess=n) for face in old))

    return lambda frame: _material(material, Call("glMaterialf", (gl.GL_FRONT_AND_BACK, gl.GL_SHININESS, n)))


def _material(change: Callable[[Material], Material], *calls: Call) -> Change:
    blocks: dict[int, Vertices] = {}

    def draw(old: Draw) -> Draw:
        new = old.with_state(old.state)
        new.material = change(old.material)
        block = old.block
        if block.materials:
            if id(block) not in blocks:
                materials = [(vertex, change(material)) for vertex, material in block.materials]
                blocks[id(block)] = Vertices(block.rows, block.columns, materials, block.static)
            new.vertices = blocks[id(block)]
        return new

    return Change(draw, calls)
