"""Per-fragment operations, fog and the framebuffer: sections 3.10 and 4 of the specification."""

from __future__ import annotations

from typing import Any

from glsim.gl.arguments import as_int32, exactly, numbers, unit
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_value
from glsim.machine.frame import Accum, Clear
from glsim.machine.machine import Machine
from glsim.machine.state import Color


def _check_func(func: int) -> None:
    if not gl.GL_NEVER <= func <= gl.GL_ALWAYS:
        raise invalid_enum("func", func, "a comparison such as GL_LESS or GL_LEQUAL")


# ---------------------------------------------------------------- fog


def glFog(m: Machine, pname: int, params: Any) -> None:
    if pname == gl.GL_FOG_COLOR:
        values = numbers(params)
        if len(values) < 3:
            raise ValueError(f"GL_FOG_COLOR needs four numbers, not {len(values)}")
        color: Color = (*map(unit, (*values, 1.0)[:4]),)  # type: ignore[assignment]
        m.fog = m.fog._replace(color=color)
        return
    (value,) = exactly(params, 1, "this parameter")
    if pname == gl.GL_FOG_MODE:
        if value not in (gl.GL_LINEAR, gl.GL_EXP, gl.GL_EXP2):
            raise invalid_enum("GL_FOG_MODE", int(value), "GL_LINEAR, GL_EXP or GL_EXP2")
        m.fog = m.fog._replace(mode=int(value))
    elif pname == gl.GL_FOG_DENSITY:
        if not value >= 0:
            raise invalid_value("GL_FOG_DENSITY", value, "at least 0")
        m.fog = m.fog._replace(density=value)
    elif pname == gl.GL_FOG_START:
        m.fog = m.fog._replace(start=value)
    elif pname == gl.GL_FOG_END:
        m.fog = m.fog._replace(end=value)
    elif pname == gl.GL_FOG_INDEX:
        m.fog = m.fog._replace(color_index=value)
    elif pname == gl.GL_FOG_COORDINATE_SOURCE:
        if value not in (gl.GL_FRAGMENT_DEPTH, gl.GL_FOG_COORDINATE):
            raise invalid_enum("GL_FOG_COORDINATE_SOURCE", int(value), "GL_FRAGMENT_DEPTH or GL_FOG_COORDINATE")
        m.fog = m.fog._replace(coordinate_source=int(value))
    else:
        raise invalid_enum("pname", pname, "a fog parameter such as GL_FOG_MODE or GL_FOG_COLOR")


# ---------------------------------------------------------------- tests


def glScissor(m: Machine, x: int, y: int, width: int, height: int) -> None:
    if width < 0 or height < 0:
        raise invalid_value("width and height", (width, height), "at least 0")
    m.scissor = m.scissor._replace(x=as_int32(x), y=as_int32(y), width=as_int32(width), height=as_int32(height))


def glSampleCoverage(m: Machine, value: float, invert: bool) -> None:
    m.multisample = m.multisample._replace(coverage_value=unit(value), coverage_invert=bool(invert))


def glAlphaFunc(m: Machine, func: int, ref: float) -> None:
    _check_func(func)
    m.color_buffer = m.color_buffer._replace(alpha_func=func, alpha_reference=unit(ref))


def glStencilFunc(m: Machine, func: int, ref: int, mask: int) -> None:
    _check_func(func)
    reference = min(max(int(ref), 0), 255)
    m.stencil = m.stencil._replace(func=int(func), reference=reference, value_mask=int(mask) & 0xFFFFFFFF)


STENCIL_OPERATIONS = (
    gl.GL_KEEP,
    gl.GL_ZERO,
    gl.GL_REPLACE,
    gl.GL_INCR,
    gl.GL_DECR,
    gl.GL_INVERT,
    gl.GL_INCR_WRAP,
    gl.GL_DECR_WRAP,
)


def glStencilOp(m: Machine, sfail: int, dpfail: int, dppass: int) -> None:
    for name, value in (("sfail", sfail), ("dpfail", dpfail), ("dppass", dppass)):
        if value not in STENCIL_OPERATIONS:
            raise invalid_enum(name, value, "GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT or a _WRAP form")
    m.stencil = m.stencil._replace(fail=sfail, depth_fail=dpfail, depth_pass=dppass)


def glDepthFunc(m: Machine, func: int) -> None:
    _check_func(func)
    m.depth = m.depth._replace(func=func)


# ---------------------------------------------------------------- blending and logic op

SOURCE_AND_DESTINATION = {
    gl.GL_ZERO, gl.GL_ONE, gl.GL_SRC_COLOR, gl.GL_ONE_MINUS_SRC_COLOR, gl.GL_DST_COLOR, gl.GL_ONE_MINUS_DST_COLOR,
    gl.GL_SRC_ALPHA,
    gl.GL_ONE_MINUS_SRC_ALPHA, gl.GL_DST_ALPHA, gl.GL_ONE_MINUS_DST_ALPHA, gl.GL_CONSTANT_COLOR,
    gl.GL_ONE_MINUS_CONSTANT_COLOR,
    gl.GL_CONSTANT_ALPHA, gl.GL_ONE_MINUS_CONSTANT_ALPHA,
}  # fmt: skip


def glBlendFunc(m: Machine, sfactor: int, dfactor: int) -> None:
    glBlendFuncSeparate(m, sfactor, dfactor, sfactor, dfactor)


def glBlendFuncSeparate(m: Machine, srcRGB: int, dstRGB: int, srcAlpha: int, dstAlpha: int) -> None:
    for name, value in (("source", srcRGB), ("source", srcAlpha), ("destination", dstRGB), ("destination", dstAlpha)):
        if value not in SOURCE_AND_DESTINATION and not (name == "source" and value == gl.GL_SRC_ALPHA_SATURATE):
            raise invalid_enum(f"the {name} factor", value, "a blending factor such as GL_SRC_ALPHA")
    m.color_buffer = m.color_buffer._replace(blend_function=(srcRGB, dstRGB, srcAlpha, dstAlpha))


def glBlendEquation(m: Machine, mode: int) -> None:
    if mode not in (gl.GL_FUNC_ADD, gl.GL_FUNC_SUBTRACT, gl.GL_FUNC_REVERSE_SUBTRACT, gl.GL_MIN, gl.GL_MAX):
        raise invalid_enum("mode", mode, "GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN or GL_MAX")
    m.color_buffer = m.color_buffer._replace(blend_equation=mode)


def glBlendColor(m: Machine, red: float, green: float, blue: float, alpha: float) -> None:
    m.color_buffer = m.color_buffer._replace(blend_color=(unit(red), unit(green), unit(blue), unit(alpha)))


def glLogicOp(m: Machine, op: int) -> None:
    if not gl.GL_CLEAR <= op <= gl.GL_SET:
        raise invalid_enum("op", op, "one of the sixteen logic operations GL_CLEAR to GL_SET")
    m.color_buffer = m.color_buffer._replace(logic_op=op)


# ---------------------------------------------------------------- masks and clears


def glDepthMask(m: Machine, flag: bool) -> None:
    m.depth = m.depth._replace(mask=bool(flag))


def glStencilMask(m: Machine, mask: int) -> None:
    m.stencil = m.stencil._replace(write_mask=int(mask) & 0xFFFFFFFF)


def glColorMask(m: Machine, r: bool, g: bool, b: bool, a: bool) -> None:
    m.color_buffer = m.color_buffer._replace(mask=(bool(r), bool(g), bool(b), bool(a)))


def glClearColor(m: Machine, r: float, g: float, b: float, a: float) -> None:
    m.color_buffer = m.color_buffer._replace(clear=(unit(r), unit(g), unit(b), unit(a)))


def glClearDepth(m: Machine, d: float) -> None:
    m.depth = m.depth._replace(clear=unit(d))


def glClearStencil(m: Machine, s: int) -> None:
    m.stencil = m.stencil._replace(clear=int(s) & 0xFF)


def glClear(m: Machine, mask: int) -> None:
    known = gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT | gl.GL_STENCIL_BUFFER_BIT | gl.GL_ACCUM_BUFFER_BIT
    if mask & ~known:
        raise invalid_value("mask", mask, "a sum of GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT and the like")
    m.add(Clear(int(mask), m.snapshot(), m.accum_clear))


def glClearAccum(m: Machine, r: float, g: float, b: float, a: float) -> None:
    """Values in [-1, 1]."""
    m.accum_clear = _signed(r), _signed(g), _signed(b), _signed(a)


def _signed(value: float) -> float:
    return min(max(float(value), -1.0), 1.0)


def glAccum(m: Machine, op: int, value: float) -> None:
    """The accumulation buffer: four float32 a pixel, so that nothing is rounded or clamped before GL_RETURN."""
    if op not in (gl.GL_ACCUM, gl.GL_LOAD, gl.GL_RETURN, gl.GL_MULT, gl.GL_ADD):
        raise invalid_enum("op", op, "GL_ACCUM, GL_LOAD, GL_RETURN, GL_MULT or GL_ADD")
    m.add(Accum(int(op), float(value), m.snapshot()))


def glClearIndex(m: Machine, index: float) -> None:
    """Accepted; colour-index mode is not emulated."""


def glIndexMask(m: Machine, mask: int) -> None:
    """Accepted; colour-index mode is not emulated."""


# ---------------------------------------------------------------- hints, flush

HINTS: dict[int, str] = {  # target -> its field in the group of hints
    gl.GL_PERSPECTIVE_CORRECTION_HINT: "perspective_correction", gl.GL_POINT_SMOOTH_HINT: "point_smooth",
    gl.GL_LINE_SMOOTH_HINT: "line_smooth", gl.GL_POLYGON_SMOOTH_HINT: "polygon_smooth", gl.GL_FOG_HINT: "fog",
    gl.GL_GENERATE_MIPMAP_HINT: "generate_mipmap", gl.GL_TEXTURE_COMPRESSION_HINT: "texture_compression",
    gl.GL_PHONG_HINT_WIN: "phong",
}  # fmt: skip


def glHint(m: Machine, target: int, hint: int) -> None:
    """Only GL_AFFINE_GLSIM has an effect: values are then interpolated linearly on the screen."""
    if target not in HINTS:
        raise invalid_enum("target", target, "a hint such as GL_PERSPECTIVE_CORRECTION_HINT")
    affine = target == gl.GL_PERSPECTIVE_CORRECTION_HINT and hint == gl.GL_AFFINE_GLSIM
    if hint not in (gl.GL_FASTEST, gl.GL_NICEST, gl.GL_DONT_CARE) and not affine:
        also = "; GL_AFFINE_GLSIM is for GL_PERSPECTIVE_CORRECTION_HINT" if hint == gl.GL_AFFINE_GLSIM else ""
        raise invalid_enum("hint", hint, f"GL_FASTEST, GL_NICEST or GL_DONT_CARE{also}")
    m.hints = m.hints._replace(**{HINTS[target]: hint})


def glFlush(m: Machine) -> None:
    m.flush()


def glFinish(m: Machine) -> None:
    m.flush()
    m.device.finish()
