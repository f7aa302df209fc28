"""Lighting and materials: section 2.14 of the specification."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from glsim.gl.arguments import exactly, numbers
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_value
from glsim.machine.frame import ROW_BYTES
from glsim.machine.machine import Machine
from glsim.machine.matrix import transform, transform_direction
from glsim.machine.state import MAX_LIGHTS, TRACKED, Color, Face, Light, Material

FACES = "GL_FRONT, GL_BACK or GL_FRONT_AND_BACK"
LIGHT_COLORS: dict[int, str] = {gl.GL_AMBIENT: "ambient", gl.GL_DIFFUSE: "diffuse", gl.GL_SPECULAR: "specular"}
MATERIAL_COLORS: dict[int, str] = {**LIGHT_COLORS, gl.GL_EMISSION: "emission"}
ATTENUATIONS: dict[int, str] = {
    gl.GL_CONSTANT_ATTENUATION: "constant_attenuation",
    gl.GL_LINEAR_ATTENUATION: "linear_attenuation",
    gl.GL_QUADRATIC_ATTENUATION: "quadratic_attenuation",
}


def _color(params: Any) -> Color:
    """Four numbers; a missing alpha is 1."""
    values = numbers(params)
    if len(values) == 4:
        return values
    if len(values) < 3:
        raise ValueError(f"a colour needs four numbers (red, green, blue, alpha), not {len(values)}")
    return (*values, 1.0)[:4]  # type: ignore[return-value]


def glShadeModel(m: Machine, mode: int) -> None:
    """Where the lighting equation is evaluated: GL_SMOOTH at each vertex, GL_PHONG_WIN at each fragment.

    GL_FLAT: at each vertex, too, but the whole primitive takes the colour of its provoking vertex.
    """
    if mode not in (gl.GL_FLAT, gl.GL_SMOOTH, gl.GL_PHONG_WIN):
        raise invalid_enum("mode", mode, "GL_FLAT, GL_SMOOTH or GL_PHONG_WIN")
    m.lighting = m.lighting._replace(shade_model=mode)


def glMaterial(m: Machine, face: int, pname: int, params: Any) -> None:
    change = CHANGES.get(pname)
    if change is None:
        if pname == gl.GL_COLOR_INDEXES and face in (gl.GL_FRONT, gl.GL_BACK, gl.GL_FRONT_AND_BACK):
            exactly(params, 3, "GL_COLOR_INDEXES")  # for colour-index mode, which no context has
            return
        expected = "GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION or GL_SHININESS"
        raise invalid_enum("pname", pname, expected)
    if face not in (gl.GL_FRONT, gl.GL_BACK, gl.GL_FRONT_AND_BACK):
        raise invalid_enum("face", face, FACES)
    value = _shininess(params) if pname == gl.GL_SHININESS else _color(params)
    front, back = m.material
    if face == gl.GL_FRONT_AND_BACK:
        front, back = change(front, value), change(back, value)
    elif face == gl.GL_FRONT:
        front = change(front, value)
    else:
        back = change(back, value)
    m.material = _material(Material, (front, back))
    if m.inside is not None:
        m.materials.append((m.stream.tell() // ROW_BYTES, m.material))


# tuple.__new__ makes a named tuple twice as fast as its own constructor; glMaterial is called once an object.
_face: Callable[..., Face] = tuple.__new__
_material: Callable[..., Material] = tuple.__new__

# pname of glMaterial -> the face with one property changed.  Fields: ambient, diffuse, specular, emission, shininess.
CHANGES: dict[int, Callable[[Face, Any], Face]] = {
    gl.GL_AMBIENT: lambda f, value: _face(Face, (value, f[1], f[2], f[3], f[4])),
    gl.GL_DIFFUSE: lambda f, value: _face(Face, (f[0], value, f[2], f[3], f[4])),
    gl.GL_AMBIENT_AND_DIFFUSE: lambda f, value: _face(Face, (value, value, f[2], f[3], f[4])),
    gl.GL_SPECULAR: lambda f, value: _face(Face, (f[0], f[1], value, f[3], f[4])),
    gl.GL_EMISSION: lambda f, value: _face(Face, (f[0], f[1], f[2], value, f[4])),
    gl.GL_SHININESS: lambda f, value: _face(Face, (f[0], f[1], f[2], f[3], value)),
}


def _shininess(params: Any) -> float:
    (n,) = exactly(params, 1, "GL_SHININESS")
    if not 0.0 <= n <= 128.0:
        raise invalid_value("GL_SHININESS", n, "in [0, 128]")
    return n


def current_material(m: Machine) -> Material:
    """The material in force: with GL_COLOR_MATERIAL the tracked properties are the current colour."""
    lighting = m.lighting
    if not lighting.color_material:
        return m.material
    color = (m.red, m.green, m.blue, m.alpha)
    change = CHANGES[lighting.color_material_mode]
    front, back = m.material
    return Material(
        front if lighting.color_material_face == gl.GL_BACK else change(front, color),
        back if lighting.color_material_face == gl.GL_FRONT else change(back, color),
    )


def glColorMaterial(m: Machine, face: int, mode: int) -> None:
    if face not in (gl.GL_FRONT, gl.GL_BACK, gl.GL_FRONT_AND_BACK):
        raise invalid_enum("face", face, FACES)
    if mode not in TRACKED:
        raise invalid_enum("mode", mode, "GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR or GL_EMISSION")
    m.material = current_material(m)  # what was tracked until now stays
    m.lighting = m.lighting._replace(color_material_face=face, color_material_mode=mode)


def set_color_material(m: Machine, enabled: bool) -> None:
    """glEnable/glDisable(GL_COLOR_MATERIAL): the tracked properties keep the last colour."""
    m.material = current_material(m)
    m.lighting = m.lighting._replace(color_material=enabled)


def _light_number(light: int) -> int:
    number = light - gl.GL_LIGHT0
    if not 0 <= number < MAX_LIGHTS:
        raise invalid_enum("light", light, f"GL_LIGHT0 to GL_LIGHT{MAX_LIGHTS - 1}")
    return number


def glLight(m: Machine, light: int, pname: int, params: Any) -> None:
    """Position and spot direction are transformed by the modelview matrix NOW (section 2.14.1)."""
    number = _light_number(light)
    old = m.lighting.lights[number]
    if pname in LIGHT_COLORS:
        new = old._replace(**{LIGHT_COLORS[pname]: _color(params)})  # type: ignore[arg-type]
    elif pname == gl.GL_POSITION:
        values = numbers(params)
        if len(values) < 3:
            raise ValueError(f"GL_POSITION needs four numbers (x, y, z, w), not {len(values)}")
        position = np.array([*values, 0.0][:4], np.float32)  # a missing w: a direction
        eye = transform(m.modelview[-1].get(), position).tolist()
        new = old._replace(position=tuple(eye))
    elif pname == gl.GL_SPOT_DIRECTION:
        direction = np.array(exactly(params, 3, "GL_SPOT_DIRECTION"), np.float32)
        eye = transform_direction(m.modelview[-1].get(), direction).tolist()
        new = old._replace(spot_direction=tuple(eye))
    else:
        new = _light_number_parameter(old, pname, params)
    lights = m.lighting.lights
    m.lighting = m.lighting._replace(lights=(*lights[:number], new, *lights[number + 1 :]))


def _light_number_parameter(old: Light, pname: int, params: Any) -> Light:
    if pname == gl.GL_SPOT_EXPONENT:
        (value,) = exactly(params, 1, "GL_SPOT_EXPONENT")
        if not 0.0 <= value <= 128.0:
            raise invalid_value("GL_SPOT_EXPONENT", value, "in [0, 128]")
        return old._replace(spot_exponent=value)
    if pname == gl.GL_SPOT_CUTOFF:
        (value,) = exactly(params, 1, "GL_SPOT_CUTOFF")
        if not (0.0 <= value <= 90.0 or value == 180.0):
            raise invalid_value("GL_SPOT_CUTOFF", value, "an angle in [0, 90] degrees, or 180 for no spot")
        return old._replace(spot_cutoff=value)
    if pname in ATTENUATIONS:
        (value,) = exactly(params, 1, "an attenuation")
        if not value >= 0.0:
            raise invalid_value("the attenuation", value, "at least 0")
        return old._replace(**{ATTENUATIONS[pname]: value})  # type: ignore[arg-type]
    raise invalid_enum("pname", pname, "a light parameter such as GL_POSITION, GL_DIFFUSE or GL_SPOT_CUTOFF")


def glLightModel(m: Machine, pname: int, params: Any) -> None:
    lighting = m.lighting
    if pname == gl.GL_LIGHT_MODEL_AMBIENT:
        m.lighting = lighting._replace(ambient=_color(params))
        return
    (value,) = exactly(params, 1, "this parameter")
    if pname == gl.GL_LIGHT_MODEL_LOCAL_VIEWER:
        m.lighting = lighting._replace(local_viewer=value != 0.0)
    elif pname == gl.GL_LIGHT_MODEL_TWO_SIDE:
        m.lighting = lighting._replace(two_side=value != 0.0)
    elif pname in _LIGHT_MODEL_CHOICES:
        field, choices = _LIGHT_MODEL_CHOICES[pname]  # type: ignore[index]
        if value not in choices:
            names = " or ".join(repr(choice) for choice in choices)
            raise invalid_enum("param", int(value), names)
        m.lighting = lighting._replace(**{field: next(choice for choice in choices if choice == value)})  # type: ignore[arg-type]
    else:
        raise invalid_enum("pname", pname, "a light model parameter such as GL_LIGHT_MODEL_AMBIENT")


_LIGHT_MODEL_CHOICES = {
    gl.GL_LIGHT_MODEL_COLOR_CONTROL: ("color_control", (gl.GL_SINGLE_COLOR, gl.GL_SEPARATE_SPECULAR_COLOR)),
    gl.GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM: ("lobe", (gl.GL_BLINN_TORRANCE_GLSIM, gl.GL_PHONG_LOBE_GLSIM)),
    gl.GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM: ("back_lighting", (gl.GL_CLAMP_NORMAL_GLSIM, gl.GL_FLIP_NORMAL_GLSIM)),
}


def glGetLight(m: Machine, light: int, pname: int) -> tuple[float, ...]:
    source = m.lighting.lights[_light_number(light)]
    if pname in LIGHT_COLORS:
        return getattr(source, LIGHT_COLORS[pname])  # type: ignore[no-any-return]
    if pname == gl.GL_POSITION:
        return source.position
    if pname == gl.GL_SPOT_DIRECTION:
        return source.spot_direction
    if pname == gl.GL_SPOT_EXPONENT:
        return (source.spot_exponent,)
    if pname == gl.GL_SPOT_CUTOFF:
        return (source.spot_cutoff,)
    if pname in ATTENUATIONS:
        return (getattr(source, ATTENUATIONS[pname]),)
    raise invalid_enum("pname", pname, "a light parameter such as GL_POSITION")


def glGetMaterial(m: Machine, face: int, pname: int) -> tuple[float, ...]:
    if face not in (gl.GL_FRONT, gl.GL_BACK):
        raise invalid_enum("face", face, "GL_FRONT or GL_BACK")
    side = current_material(m)[0 if face == gl.GL_FRONT else 1]
    if pname == gl.GL_SHININESS:
        return (side.shininess,)
    if pname not in MATERIAL_COLORS:
        raise invalid_enum("pname", pname, "GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION or GL_SHININESS")
    return getattr(side, MATERIAL_COLORS[pname])  # type: ignore[no-any-return]
