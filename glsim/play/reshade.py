"""The same draws under another shade model and specular lobe, without light, or as wireframe."""

from __future__ import annotations

from collections.abc import Callable

from glsim.machine import constants as gl
from glsim.machine.frame import Accum, Clear, Draw, Frame, Packet, QueryMark, Vertices
from glsim.names import SHADING

SHADE_MODEL = {"flat": gl.GL_FLAT, "gouraud": gl.GL_SMOOTH, "phong": gl.GL_PHONG_WIN}
LOBE = {"blinn": gl.GL_BLINN_TORRANCE_GLSIM, "phong": gl.GL_PHONG_LOBE_GLSIM}
WHOLE = gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT


def reshaded(shade: str | None, lobe: str | None) -> Callable[[Draw], Draw] | None:
    """A function draw -> draw under another shading mode (see ``shaded``) and lobe; None if both are None.

    shade None keeps the program's shade model; lobe None is "blinn"."""
    if shade is None and lobe is None:
        return None

    def change(draw: Draw) -> Draw:
        if shade is None:
            lighting = draw.state.lighting._replace(lobe=LOBE[lobe or "blinn"])
            return draw.with_state(draw.state._replace(lighting=lighting))
        return next(shaded(Frame(0, 0, [draw]), SHADING.get(shade, shade), lobe or "blinn").draws)

    return change


def shaded(frame: Frame, mode: str, lobe: str) -> Frame:
    """The frame with every lit draw under another shade model and lobe, or as wireframe, or without light."""
    if mode == "wireframe":
        return _unlit(frame).map_draws(_outlined)
    if mode == "unlit":
        return _unlit(frame)

    def change(draw: Draw) -> Draw:
        lighting = draw.state.lighting._replace(shade_model=SHADE_MODEL[mode], lobe=LOBE[lobe])
        return draw.with_state(draw.state._replace(lighting=lighting))

    return frame.map_draws(change)


def _unlit(frame: Frame) -> Frame:
    """Lit draws in the plain colour k_d of their material."""
    blocks: dict[int, Vertices] = {}

    def change(draw: Draw) -> Draw:
        lighting, block = draw.state.lighting, draw.block
        if not lighting.enabled:
            return draw
        plain = draw.with_state(draw.state._replace(lighting=lighting._replace(enabled=False)))
        if lighting.color_material:
            return plain
        if not block.materials:
            plain.color = draw.material.front.diffuse
            return plain
        if id(block) not in blocks:
            blocks[id(block)] = Vertices(block.rows.copy(), block.columns, [])
        plain.vertices = blocks[id(block)]
        end = draw.first + draw.count
        plain.vertices.rows[draw.first : end, 6:10] = draw.material.front.diffuse
        for vertex, material in draw.material_changes():
            plain.vertices.rows[vertex:end, 6:10] = material.front.diffuse
        return plain

    return frame.map_draws(change)


def _outlined(draw: Draw) -> Draw:
    """Polygons as their edges."""
    polygon = draw.state.polygon._replace(front_mode=gl.GL_LINE, back_mode=gl.GL_LINE)
    return draw.with_state(draw.state._replace(polygon=polygon))


def needed(packets: list[Packet]) -> list[Packet]:
    """The packets from the last glClear on that clears all colour, depth and (if a test uses it) stencil values.

    All packets if there is no such glClear, or if there is a glAccum or a query."""
    if any(isinstance(packet, (Accum, QueryMark)) for packet in packets):
        return packets
    stencil = any(packet.state.stencil.test for packet in packets if not isinstance(packet, QueryMark))
    for at in range(len(packets) - 1, 0, -1):
        packet = packets[at]
        if isinstance(packet, Clear) and _wipes(packet, stencil):
            return packets[at:]
    return packets


def _wipes(clear: Clear, stencil: bool) -> bool:
    state = clear.state
    buffers = WHOLE | (gl.GL_STENCIL_BUFFER_BIT if stencil else 0)
    writes = all(state.color_buffer.mask) and state.depth.mask and not state.scissor.test
    return clear.mask & buffers == buffers and writes and (not stencil or state.stencil.write_mask & 255 == 255)
