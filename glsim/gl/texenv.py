"""Texture units: what a texel does to a fragment, and where texture coordinates come from (sections 2.11.4, 3.8.13)."""

from __future__ import annotations

from typing import Any

from glsim.gl.arguments import exactly, unit
from glsim.gl.matrix import in_eye_space
from glsim.machine import constants as gl
from glsim.machine.constants import Enum
from glsim.machine.errors import invalid_enum, invalid_value
from glsim.machine.machine import Machine
from glsim.machine.state import TEXTURE_UNITS, Color, TextureUnit


def unit_number(texture: int, argument: str = "texture") -> int:
    """GL_TEXTUREi -> i."""
    number = texture - gl.GL_TEXTURE0
    if not 0 <= number < TEXTURE_UNITS:
        raise invalid_enum(argument, texture, f"GL_TEXTURE0 to GL_TEXTURE{TEXTURE_UNITS - 1}")
    return number


def glActiveTexture(m: Machine, texture: int) -> None:
    number = unit_number(texture)
    m.texture = m.texture._replace(active_unit=number)
    m.several_texture_matrices |= number > 0
    m.stacks[gl.GL_TEXTURE] = m.texture_stacks[number]
    m.stack = m.stacks[m.transform.matrix_mode]


def _set(m: Machine, **changes: Any) -> None:
    m.texture = m.texture.with_unit(m.texture.active_unit, m.texture.unit._replace(**changes))


# ---------------------------------------------------------------- environment

ENVIRONMENTS = (gl.GL_MODULATE, gl.GL_DECAL, gl.GL_BLEND, gl.GL_REPLACE, gl.GL_ADD, gl.GL_COMBINE)
FUNCTIONS = (gl.GL_REPLACE, gl.GL_MODULATE, gl.GL_ADD, gl.GL_ADD_SIGNED, gl.GL_INTERPOLATE, gl.GL_SUBTRACT)
SOURCES = (
    gl.GL_TEXTURE, gl.GL_CONSTANT, gl.GL_PRIMARY_COLOR, gl.GL_PREVIOUS,
    *(gl.GL_TEXTURE0 + k for k in range(TEXTURE_UNITS)),
)  # fmt: skip
ALPHA_OPERANDS = (gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
# pname -> field of Combine, what it can be
COMBINE: dict[int, tuple[str, tuple[int, ...]]] = {
    gl.GL_COMBINE_RGB: ("rgb", (*FUNCTIONS, gl.GL_DOT3_RGB, gl.GL_DOT3_RGBA)),
    gl.GL_COMBINE_ALPHA: ("alpha", FUNCTIONS),
}
# first pname of three -> field of Combine, what it can be
COMBINE_ARGUMENTS: dict[int, tuple[str, tuple[int, ...]]] = {
    gl.GL_SOURCE0_RGB: ("source_rgb", SOURCES),
    gl.GL_SOURCE0_ALPHA: ("source_alpha", SOURCES),
    gl.GL_OPERAND0_RGB: ("operand_rgb", (gl.GL_SRC_COLOR, gl.GL_ONE_MINUS_SRC_COLOR, *ALPHA_OPERANDS)),
    gl.GL_OPERAND0_ALPHA: ("operand_alpha", ALPHA_OPERANDS),
}
SCALES: dict[int, str] = {gl.GL_RGB_SCALE: "scale_rgb", gl.GL_ALPHA_SCALE: "scale_alpha"}


def _argument(pname: int) -> tuple[str, tuple[int, ...], int] | None:
    for first, (field, choices) in COMBINE_ARGUMENTS.items():
        if 0 <= pname - first < 3:
            return field, choices, pname - first
    return None


def _one_of(value: float, choices: tuple[int, ...]) -> int:
    if value not in choices:
        raise invalid_enum("param", int(value), " or ".join(repr(c) for c in choices if isinstance(c, Enum)))
    return int(value)


def glTexEnv(m: Machine, target: int, pname: int, params: Any) -> None:
    place = m.texture.unit
    if target == gl.GL_TEXTURE_FILTER_CONTROL:
        if pname != gl.GL_TEXTURE_LOD_BIAS:
            raise invalid_enum("pname", pname, "GL_TEXTURE_LOD_BIAS")
        _set(m, lod_bias=exactly(params, 1, "GL_TEXTURE_LOD_BIAS")[0])
        return
    if target != gl.GL_TEXTURE_ENV:
        raise invalid_enum("target", target, "GL_TEXTURE_ENV or GL_TEXTURE_FILTER_CONTROL")
    if pname == gl.GL_TEXTURE_ENV_COLOR:
        r, g, b, a = map(unit, exactly(params, 4, "GL_TEXTURE_ENV_COLOR"))
        _set(m, environment_color=(r, g, b, a))
        return
    argument = _argument(pname)
    if pname != gl.GL_TEXTURE_ENV_MODE and pname not in COMBINE and pname not in SCALES and argument is None:
        raise invalid_enum("pname", pname, "GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR or a parameter of GL_COMBINE")
    (value,) = exactly(params, 1, "this parameter")
    if pname == gl.GL_TEXTURE_ENV_MODE:
        _set(m, environment=_one_of(value, ENVIRONMENTS))
    elif pname in COMBINE:
        field, choices = COMBINE[pname]
        _set(m, combine=place.combine._replace(**{field: _one_of(value, choices)}))  # type: ignore[arg-type]
    elif argument is not None:
        field, choices, number = argument
        values = list(getattr(place.combine, field))
        values[number] = _one_of(value, choices)
        _set(m, combine=place.combine._replace(**{field: tuple(values)}))  # type: ignore[arg-type]
    else:
        if value not in (1.0, 2.0, 4.0):
            raise invalid_value("param", value, "1, 2 or 4")
        _set(m, combine=place.combine._replace(**{SCALES[pname]: value}))  # type: ignore[arg-type]


def glGetTexEnv(m: Machine, env: int, pname: int) -> tuple[float, ...]:
    place = m.texture.unit
    if env == gl.GL_TEXTURE_FILTER_CONTROL and pname == gl.GL_TEXTURE_LOD_BIAS:
        return (place.lod_bias,)
    if env != gl.GL_TEXTURE_ENV:
        raise invalid_enum("env", env, "GL_TEXTURE_ENV")
    if pname == gl.GL_TEXTURE_ENV_MODE:
        return (float(place.environment),)
    if pname == gl.GL_TEXTURE_ENV_COLOR:
        return place.environment_color
    argument = _argument(pname)
    if argument is not None:
        return (float(getattr(place.combine, argument[0])[argument[2]]),)
    if pname in COMBINE or pname in SCALES:
        return (float(getattr(place.combine, COMBINE[pname][0] if pname in COMBINE else SCALES[pname])),)
    raise invalid_enum("pname", pname, "GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR or a parameter of GL_COMBINE")


# ---------------------------------------------------------------- coordinates

COORDINATES: dict[int, int] = {gl.GL_S: 0, gl.GL_T: 1, gl.GL_R: 2, gl.GL_Q: 3}
# mode of glTexGen -> coordinates that can have it
GENERATORS: dict[int, tuple[int, ...]] = {
    gl.GL_OBJECT_LINEAR: (0, 1, 2, 3), gl.GL_EYE_LINEAR: (0, 1, 2, 3), gl.GL_SPHERE_MAP: (0, 1),
    gl.GL_REFLECTION_MAP: (0, 1, 2), gl.GL_NORMAL_MAP: (0, 1, 2),
}  # fmt: skip


def _coordinate(coord: int) -> int:
    if coord not in COORDINATES:
        raise invalid_enum("coord", coord, "GL_S, GL_T, GL_R or GL_Q")
    return COORDINATES[coord]


def glTexGen(m: Machine, coord: int, pname: int, params: Any) -> None:
    """An eye plane is taken to eye space NOW by the inverse of the modelview (section 2.11.4)."""
    number = _coordinate(coord)
    place: TextureUnit = m.texture.unit
    generators = list(place.generators)
    if pname == gl.GL_TEXTURE_GEN_MODE:
        (mode,) = exactly(params, 1, "GL_TEXTURE_GEN_MODE")
        if number not in GENERATORS.get(int(mode), ()):
            raise invalid_enum("param", int(mode), " or ".join(repr(g) for g, c in GENERATORS.items() if number in c))
        generators[number] = generators[number]._replace(mode=int(mode))
    elif pname in (gl.GL_OBJECT_PLANE, gl.GL_EYE_PLANE):
        a, b, c, d = exactly(params, 4, "the plane")
        plane: Color = (a, b, c, d)
        if pname == gl.GL_OBJECT_PLANE:
            generators[number] = generators[number]._replace(object_plane=plane)
        else:
            generators[number] = generators[number]._replace(eye_plane=in_eye_space(m, plane))
    else:
        raise invalid_enum("pname", pname, "GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE or GL_EYE_PLANE")
    _set(m, generators=tuple(generators))


def glGetTexGen(m: Machine, coord: int, pname: int) -> tuple[float, ...]:
    generator = m.texture.unit.generators[_coordinate(coord)]
    if pname == gl.GL_TEXTURE_GEN_MODE:
        return (float(generator.mode),)
    if pname == gl.GL_OBJECT_PLANE:
        return generator.object_plane
    if pname == gl.GL_EYE_PLANE:
        return generator.eye_plane
    raise invalid_enum("pname", pname, "GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE or GL_EYE_PLANE")
