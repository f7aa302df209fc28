"""glEnable, glDisable, glIsEnabled: the capabilities, and the field of the state that holds each."""

from __future__ import annotations

from typing import Any, get_type_hints

from glsim.gl.arrays import ARRAYS, array_key, client
from glsim.gl.light import set_color_material
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum
from glsim.machine.machine import Machine
from glsim.machine.state import MAX_CLIP_PLANES, MAX_LIGHTS, Evaluators, Snapshot, TextureUnit, Texturing, with_item

GROUPS: dict[str, Any] = {**get_type_hints(Snapshot), "evaluators": Evaluators}

# cap -> (group of a Machine, field)
SINGLE: dict[int, tuple[str, str]] = {
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
# every cap of these -> (group, number of the field in it, number in the tuple that the field holds or None)
CAPS: dict[int, tuple[str, int, int | None]] = {
    **{cap: (group, GROUPS[group]._fields.index(field), None) for cap, (group, field) in SINGLE.items()},
    **{
        first + k: (group, GROUPS[group]._fields.index(field), k)
        for first, (group, field, count) in SERIES.items()
        for k in range(count)
    },
}
# capability of the active texture unit -> (number of the field of TextureUnit, number in the tuple that it holds)
_ENABLED, _GENERATED = (TextureUnit._fields.index(field) for field in ("enabled", "generated"))
UNIT_CAPS: dict[int, tuple[int, int]] = {
    gl.GL_TEXTURE_1D: (_ENABLED, 0), gl.GL_TEXTURE_2D: (_ENABLED, 1), gl.GL_TEXTURE_3D: (_ENABLED, 2),
    gl.GL_TEXTURE_CUBE_MAP: (_ENABLED, 3), gl.GL_TEXTURE_GEN_S: (_GENERATED, 0), gl.GL_TEXTURE_GEN_T: (_GENERATED, 1),
    gl.GL_TEXTURE_GEN_R: (_GENERATED, 2), gl.GL_TEXTURE_GEN_Q: (_GENERATED, 3),
}  # fmt: skip
# cap -> a group with it disabled and enabled, the last that were made: programs switch to and fro
_last_pair: dict[int, tuple[Any, Any]] = {}
EXPECTED = "something that can be enabled, such as GL_LIGHTING or GL_DEPTH_TEST"


def glEnable(m: Machine, cap: int) -> None:
    switch(m, cap, True)


def glDisable(m: Machine, cap: int) -> None:
    switch(m, cap, False)


def switch(m: Machine, cap: int, value: bool) -> None:
    place = CAPS.get(cap)
    if place is None:
        _switch_of_unit(m, cap, value)
        return
    group, field, number = place
    before = getattr(m, group)
    flags = before[field]
    if (flags if number is None else flags[number]) is value:
        return
    if cap == gl.GL_COLOR_MATERIAL:
        set_color_material(m, value)
        return
    pair = _last_pair.get(cap)
    if pair is None or pair[not value] is not before:
        after = with_item(before, field, value if number is None else with_item(flags, number, value))
        pair = _last_pair[cap] = (before, after) if value else (after, before)
    setattr(m, group, pair[value])


def _switch_of_unit(m: Machine, cap: int, value: bool) -> None:
    if cap not in UNIT_CAPS:
        raise invalid_enum("cap", cap, EXPECTED)
    field, number = UNIT_CAPS[cap]
    units, active = m.texture
    unit: Any = units[active]
    if unit[field][number] is not value:
        unit = with_item(unit, field, with_item(unit[field], number, value))
        m.texture = Texturing(with_item(units, active, unit), active)


def glIsEnabled(m: Machine, cap: int) -> int:
    if cap in CAPS:
        return int(flag(m, cap))
    if cap in UNIT_CAPS:
        field, number = UNIT_CAPS[cap]
        unit: Any = m.texture.unit
        return int(unit[field][number])
    if cap in ARRAYS:
        return int(client(m, array_key(m, cap)).enabled)
    raise invalid_enum("cap", cap, EXPECTED)


def flag(m: Machine, cap: int) -> bool:
    """Whether one of CAPS is enabled."""
    group, field, number = CAPS[cap]
    flags = getattr(m, group)[field]
    return bool(flags if number is None else flags[number])
