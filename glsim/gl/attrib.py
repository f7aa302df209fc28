"""The attribute stacks: section 6.1.14 of the specification.

The groups of state are immutable, so pushing is keeping references and popping is putting them back.
"""

from __future__ import annotations

from glsim.gl.enable import CAPS, flag, switch
from glsim.gl.texture import rebind
from glsim.machine import constants as gl
from glsim.machine.errors import stack_overflow, stack_underflow
from glsim.machine.machine import ATTRIB_STACK_DEPTH, REGISTERS, Machine

# bit of glPushAttrib -> attributes of a Machine that it saves
GROUPS: dict[int, tuple[str, ...]] = {
    gl.GL_CURRENT_BIT: (*REGISTERS, "index", "current", "raster"),
    gl.GL_POINT_BIT: ("point",),
    gl.GL_LINE_BIT: ("line",),
    gl.GL_POLYGON_BIT: ("polygon",),
    gl.GL_POLYGON_STIPPLE_BIT: ("polygon_stipple",),
    gl.GL_LIGHTING_BIT: ("lighting", "material"),
    gl.GL_TEXTURE_BIT: ("texture",),
    gl.GL_FOG_BIT: ("fog",),
    gl.GL_DEPTH_BUFFER_BIT: ("depth",),
    gl.GL_STENCIL_BUFFER_BIT: ("stencil",),
    gl.GL_VIEWPORT_BIT: ("viewport",),
    gl.GL_TRANSFORM_BIT: ("transform",),
    gl.GL_COLOR_BUFFER_BIT: ("color_buffer",),
    gl.GL_HINT_BIT: ("hints",),
    gl.GL_LIST_BIT: ("list_base",),
    gl.GL_SCISSOR_BIT: ("scissor",),
    gl.GL_MULTISAMPLE_BIT: ("multisample",),
    gl.GL_PIXEL_MODE_BIT: ("pixel",),
    gl.GL_EVAL_BIT: ("evaluators",),
    gl.GL_ACCUM_BUFFER_BIT: ("accum_clear",),
}


def glPushAttrib(m: Machine, mask: int) -> None:
    if len(m.attrib_stack) >= ATTRIB_STACK_DEPTH:
        raise stack_overflow(
            f"the attribute stack holds {ATTRIB_STACK_DEPTH} entries and is full: is a glPopAttrib missing?"
        )
    names = [name for bit, group in GROUPS.items() if mask & bit for name in group]
    saved = {name: getattr(m, name) for name in names}
    flags = {cap: flag(m, cap) for cap in CAPS} if mask & gl.GL_ENABLE_BIT else {}
    units = [(unit.enabled, unit.generated) for unit in m.texture.units] if mask & gl.GL_ENABLE_BIT else []
    m.attrib_stack.append((saved, flags, units))


def glPopAttrib(m: Machine) -> None:
    if not m.attrib_stack:
        raise stack_underflow("the attribute stack is empty: more glPopAttrib than glPushAttrib")
    saved, flags, units = m.attrib_stack.pop()
    for cap, value in flags.items():
        switch(m, cap, value)
    for number, (enabled, generated) in enumerate(units):
        unit = m.texture.units[number]._replace(enabled=enabled, generated=generated)
        m.texture = m.texture.with_unit(number, unit)
    if "pixel" in saved:  # pixel maps belong to no group
        saved["pixel"] = saved["pixel"]._replace(maps=m.pixel.maps)
    for name, value in saved.items():
        setattr(m, name, value)
    if "texture" in saved:
        rebind(m)
        m.stacks[gl.GL_TEXTURE] = m.texture_stacks[m.texture.active_unit]
    m.stack = m.stacks[m.transform.matrix_mode]


# bit of glPushClientAttrib -> attribute of a Machine that it saves
CLIENT_GROUPS: dict[int, str] = {gl.GL_CLIENT_PIXEL_STORE_BIT: "stores", gl.GL_CLIENT_VERTEX_ARRAY_BIT: "client"}


def glPushClientAttrib(m: Machine, mask: int) -> None:
    if len(m.client_attrib_stack) >= ATTRIB_STACK_DEPTH:
        raise stack_overflow("the client attribute stack is full: is a glPopClientAttrib missing?")
    names = [name for bit, name in CLIENT_GROUPS.items() if mask & bit]
    m.client_attrib_stack.append({name: getattr(m, name).copy() for name in names})


def glPopClientAttrib(m: Machine) -> None:
    if not m.client_attrib_stack:
        raise stack_underflow("the client attribute stack is empty: more glPopClientAttrib than glPushClientAttrib")
    for name, value in m.client_attrib_stack.pop().items():
        setattr(m, name, value)
