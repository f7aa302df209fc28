"""glEnable, glDisable, glIsEnabled: the capabilities, and the field of the state that holds each."""

from __future__ import annotations

from typing import Any

from glsim.gl.arrays import ARRAYS, array_key, client
from glsim.gl.light import set_color_material
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum
from glsim.machine.machine import Machine
from glsim.machine.state import MAX_CLIP_PLANES, MAX_LIGHTS

# cap -> (group, field) of a Machine
CAPS: dict[int, tuple[str, str]] = {
    gl.GL_LIGHTING: ("lighting", "enabled"),
    gl.GL_COLOR_MATERIAL: ("lighting", "color_material"),
    gl.GL_NORMALIZE: ("transform", "normalize"),
    gl.GL_RESCALE_NORMAL: ("transform", "rescale_normal"),
    gl.GL_POINT_SMOOTH: ("point", "smooth"),
    gl.GL_LINE_SMOOTH: ("line", "smooth"),
    gl.GL_LINE_STIPPLE: ("line", "stipple"),
    gl.GL_CULL_FACE: ("polygon", "cull"),
    gl.GL_POLYGON_SMOOTH: ("polygon", "smooth"),
    gl.GL_POLYGON_STIPPLE: ("polygon", "stipple"),
    gl.GL_POLYGON_OFFSET_FILL: ("polygon", "offset_fill"),
    gl.GL_POLYGON_OFFSET_LINE: ("polygon", "offset_line"),
    gl.GL_POLYGON_OFFSET_POINT: ("polygon", "offset_point"),
    gl.GL_AUTO_NORMAL: ("evaluators", "auto_normal"),
    gl.GL_INDEX_LOGIC_OP: ("color_buffer", "index_logic_op"),
    gl.GL_FOG: ("fog", "enabled"),
    gl.GL_COLOR_SUM: ("fog", "color_sum"),
    gl.GL_DEPTH_TEST: ("depth", "test"),
    gl.GL_STENCIL_TEST: ("stencil", "test"),
    gl.GL_SCISSOR_TEST: ("scissor", "test"),
    gl.GL_ALPHA_TEST: ("color_buffer", "alpha_test"),
    gl.GL_BLEND: ("color_buffer", "blend"),
    gl.GL_DITHER: ("color_buffer", "dither"),
    gl.GL_COLOR_LOGIC_OP: ("color_buffer", "logic_op_enabled"),
    gl.GL_MULTISAMPLE: ("multisample", "enabled"),
    gl.GL_SAMPLE_ALPHA_TO_COVERAGE: ("multisample", "alpha_to_coverage"),
    gl.GL_SAMPLE_ALPHA_TO_ONE: ("multisample", "alpha_to_one"),
    gl.GL_SAMPLE_COVERAGE: ("multisample", "coverage"),
}
# first cap of a numbered series -> (group, field holding a tuple, how many)
SERIES: dict[int, tuple[str, str, int]] = {
    gl.GL_MAP1_COLOR_4: ("evaluators", "enabled_1", 9),
    gl.GL_MAP2_COLOR_4: ("evaluators", "enabled_2", 9),
    gl.GL_LIGHT0: ("lighting", "light_enabled", MAX_LIGHTS),
    gl.GL_CLIP_PLANE0: ("transform", "clip_enabled", MAX_CLIP_PLANES),
}
# capability of the active texture unit -> (field of TextureUnit, index in this field)
UNIT_CAPS: dict[int, tuple[str, int]] = {
    gl.GL_TEXTURE_1D: ("enabled", 0), gl.GL_TEXTURE_2D: ("enabled", 1), gl.GL_TEXTURE_3D: ("enabled", 2),
    gl.GL_TEXTURE_CUBE_MAP: ("enabled", 3), gl.GL_TEXTURE_GEN_S: ("generated", 0), gl.GL_TEXTURE_GEN_T: ("generated",
    1),
    gl.GL_TEXTURE_GEN_R: ("generated", 2), gl.GL_TEXTURE_GEN_Q: ("generated", 3),
}  # fmt: skip
EXPECTED = "something that can be enabled, such as GL_LIGHTING or GL_DEPTH_TEST"


def series(cap: int) -> tuple[str, str, int] | None:
    """(group, field, number) of GL_LIGHTi and GL_CLIP_PLANEi."""
    for first, (group, field, count) in SERIES.items():
        if 0 <= cap - first < count:
            return group, field, cap - first
    return None


def glEnable(m: Machine, cap: int) -> None:
    switch(m, cap, True)


def glDisable(m: Machine, cap: int) -> None:
    switch(m, cap, False)


def switch(m: Machine, cap: int, value: bool) -> None:
    place = CAPS.get(cap)
    if place is not None:
        group, field = place
        if cap == gl.GL_COLOR_MATERIAL and m.lighting.color_material != value:
            set_color_material(m, value)
        else:
            setattr(m, group, getattr(m, group)._replace(**{field: value}))
        return
    if cap in UNIT_CAPS:
        field, number = UNIT_CAPS[cap]
        unit = m.texture.unit
        before = getattr(unit, field)
        changed: dict[str, Any] = {field: (*before[:number], value, *before[number + 1 :])}
        unit = unit._replace(**changed)
        m.texture = m.texture.with_unit(m.texture.active_unit, unit)
        return
    numbered = series(cap)
    if numbered is not None:
        group, field, number = numbered
        flags = list(getattr(getattr(m, group), field))
        flags[number] = value
        setattr(m, group, getattr(m, group)._replace(**{field: tuple(flags)}))
    else:
        raise invalid_enum("cap", cap, EXPECTED)


def glIsEnabled(m: Machine, cap: int) -> int:
    place = CAPS.get(cap)
    if place is not None:
        return int(getattr(getattr(m, place[0]), place[1]))
    numbered = series(cap)
    if numbered is not None:
        return int(getattr(getattr(m, numbered[0]), numbered[1])[numbered[2]])
    if cap in UNIT_CAPS:
        return int(getattr(m.texture.unit, UNIT_CAPS[cap][0])[UNIT_CAPS[cap][1]])
    if cap in ARRAYS:
        return int(client(m, array_key(m, cap)).enabled)
    raise invalid_enum("cap", cap, EXPECTED)
