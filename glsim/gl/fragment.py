"""Rasterization state and per-fragment operations: sections 3.5 and 4 of the specification."""

from __future__ import annotations

from glsim.gl.light import set_color_material
from glsim.machine.constants import (
    GL_ACCUM_BUFFER_BIT,
    GL_ALWAYS,
    GL_BACK,
    GL_CCW,
    GL_COLOR_BUFFER_BIT,
    GL_COLOR_MATERIAL,
    GL_CULL_FACE,
    GL_CW,
    GL_DEPTH_BUFFER_BIT,
    GL_DEPTH_TEST,
    GL_DITHER,
    GL_DONT_CARE,
    GL_FASTEST,
    GL_FOG_HINT,
    GL_FRONT,
    GL_FRONT_AND_BACK,
    GL_GENERATE_MIPMAP_HINT,
    GL_LIGHT0,
    GL_LIGHTING,
    GL_LINE_SMOOTH_HINT,
    GL_MULTISAMPLE,
    GL_NEVER,
    GL_NICEST,
    GL_NORMALIZE,
    GL_PERSPECTIVE_CORRECTION_HINT,
    GL_PHONG_HINT_WIN,
    GL_POINT_SMOOTH_HINT,
    GL_POLYGON_SMOOTH_HINT,
    GL_RESCALE_NORMAL,
    GL_STENCIL_BUFFER_BIT,
    GL_TEXTURE_COMPRESSION_HINT,
    Enum,
)
from glsim.machine.errors import invalid_enum, invalid_value
from glsim.machine.frame import Clear
from glsim.machine.machine import Machine
from glsim.machine.state import MAX_LIGHTS

# cap of glEnable -> (group, field) of a Machine
CAPS: dict[int, tuple[str, str]] = {
    GL_LIGHTING: ("lighting", "enabled"),
    GL_COLOR_MATERIAL: ("lighting", "color_material"),
    GL_NORMALIZE: ("transform", "normalize"),
    GL_RESCALE_NORMAL: ("transform", "rescale_normal"),
    GL_CULL_FACE: ("polygon", "cull"),
    GL_DEPTH_TEST: ("depth", "test"),
    GL_DITHER: ("color_buffer", "dither"),
    GL_MULTISAMPLE: ("color_buffer", "multisample"),
}
# caps of OpenGL 1.5 that come with a later version
LATER = (
    "GL_ALPHA_TEST GL_AUTO_NORMAL GL_BLEND GL_CLIP_PLANE0 GL_CLIP_PLANE1 GL_CLIP_PLANE2 GL_CLIP_PLANE3 GL_CLIP_PLANE4 "
    "GL_CLIP_PLANE5 GL_COLOR_LOGIC_OP GL_COLOR_SUM GL_FOG GL_INDEX_LOGIC_OP GL_LINE_SMOOTH GL_LINE_STIPPLE "
    "GL_MAP1_COLOR_4 GL_MAP1_INDEX GL_MAP1_NORMAL GL_MAP1_TEXTURE_COORD_1 GL_MAP1_TEXTURE_COORD_2 "
    "GL_MAP1_TEXTURE_COORD_3 GL_MAP1_TEXTURE_COORD_4 GL_MAP1_VERTEX_3 GL_MAP1_VERTEX_4 GL_MAP2_COLOR_4 GL_MAP2_INDEX "
    "GL_MAP2_NORMAL GL_MAP2_TEXTURE_COORD_1 GL_MAP2_TEXTURE_COORD_2 GL_MAP2_TEXTURE_COORD_3 GL_MAP2_TEXTURE_COORD_4 "
    "GL_MAP2_VERTEX_3 GL_MAP2_VERTEX_4 GL_POINT_SMOOTH GL_POLYGON_OFFSET_FILL GL_POLYGON_OFFSET_LINE "
    "GL_POLYGON_OFFSET_POINT GL_POLYGON_SMOOTH GL_POLYGON_STIPPLE GL_SAMPLE_ALPHA_TO_COVERAGE GL_SAMPLE_ALPHA_TO_ONE "
    "GL_SAMPLE_COVERAGE GL_SCISSOR_TEST GL_STENCIL_TEST GL_TEXTURE_1D GL_TEXTURE_2D GL_TEXTURE_3D GL_TEXTURE_CUBE_MAP "
    "GL_TEXTURE_GEN_Q GL_TEXTURE_GEN_R GL_TEXTURE_GEN_S GL_TEXTURE_GEN_T"
)


def _later_caps() -> dict[int, Enum]:
    from glsim.machine import constants

    return {int(getattr(constants, name)): getattr(constants, name) for name in LATER.split()}


LATER_CAPS = _later_caps()


def glEnable(m: Machine, cap: int) -> None:
    _set(m, cap, True)


def glDisable(m: Machine, cap: int) -> None:
    _set(m, cap, False)


def _set(m: Machine, cap: int, value: bool) -> None:
    place = CAPS.get(cap)
    if place is not None:
        group, field = place
        if getattr(getattr(m, group), field) == value:
            return
        if cap == GL_COLOR_MATERIAL:
            set_color_material(m, value)
        else:
            setattr(m, group, getattr(m, group)._replace(**{field: value}))
    elif 0 <= cap - GL_LIGHT0 < MAX_LIGHTS:
        enabled = list(m.lighting.light_enabled)
        enabled[cap - GL_LIGHT0] = value
        m.lighting = m.lighting._replace(light_enabled=tuple(enabled))
    elif cap not in LATER_CAPS:
        raise invalid_enum("cap", cap, "something that can be enabled, such as GL_LIGHTING or GL_DEPTH_TEST")
    elif value:
        raise NotImplementedError(f"glEnable({LATER_CAPS[cap]!r}) is not in glsim yet")


def glIsEnabled(m: Machine, cap: int) -> int:
    place = CAPS.get(cap)
    if place is not None:
        return int(getattr(getattr(m, place[0]), place[1]))
    if 0 <= cap - GL_LIGHT0 < MAX_LIGHTS:
        return int(m.lighting.light_enabled[cap - GL_LIGHT0])
    if cap in LATER_CAPS:
        return 0
    raise invalid_enum("cap", cap, "something that can be enabled, such as GL_LIGHTING or GL_DEPTH_TEST")


def glCullFace(m: Machine, mode: int) -> None:
    if mode not in (GL_FRONT, GL_BACK, GL_FRONT_AND_BACK):
        raise invalid_enum("mode", mode, "GL_FRONT, GL_BACK or GL_FRONT_AND_BACK")
    m.polygon = m.polygon._replace(cull_face=mode)


def glFrontFace(m: Machine, mode: int) -> None:
    if mode not in (GL_CW, GL_CCW):
        raise invalid_enum("mode", mode, "GL_CW or GL_CCW")
    m.polygon = m.polygon._replace(front_face=mode)


def glDepthFunc(m: Machine, func: int) -> None:
    if not GL_NEVER <= func <= GL_ALWAYS:
        raise invalid_enum("func", func, "a comparison such as GL_LESS or GL_LEQUAL")
    m.depth = m.depth._replace(func=func)


def glDepthMask(m: Machine, flag: bool) -> None:
    m.depth = m.depth._replace(mask=bool(flag))


def glColorMask(m: Machine, r: bool, g: bool, b: bool, a: bool) -> None:
    m.color_buffer = m.color_buffer._replace(mask=(bool(r), bool(g), bool(b), bool(a)))


def _unit(value: float) -> float:
    return min(max(float(value), 0.0), 1.0)


def glClearColor(m: Machine, r: float, g: float, b: float, a: float) -> None:
    m.color_buffer = m.color_buffer._replace(clear=(_unit(r), _unit(g), _unit(b), _unit(a)))


def glClearDepth(m: Machine, d: float) -> None:
    m.depth = m.depth._replace(clear=_unit(d))


def glClear(m: Machine, mask: int) -> None:
    known = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT
    if mask & ~known:
        raise invalid_value("mask", mask, "a sum of GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT and the like")
    m.packets.append(Clear(int(mask), m.snapshot()))


HINTS = {
    GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT,
    GL_GENERATE_MIPMAP_HINT, GL_TEXTURE_COMPRESSION_HINT, GL_PHONG_HINT_WIN,
}  # fmt: skip


def glHint(m: Machine, target: int, hint: int) -> None:
    """Accepted; it has no effect."""
    if target not in HINTS:
        raise invalid_enum("target", target, "a hint such as GL_PERSPECTIVE_CORRECTION_HINT")
    if hint not in (GL_FASTEST, GL_NICEST, GL_DONT_CARE):
        raise invalid_enum("hint", hint, "GL_FASTEST, GL_NICEST or GL_DONT_CARE")
    m.hints[target] = hint


def glFlush(m: Machine) -> None:
    m.flush()


def glFinish(m: Machine) -> None:
    m.flush()
    m.device.finish()
