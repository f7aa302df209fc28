"""The same draws under another shade model and specular lobe, without light, as wireframe or as visible edges."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from glsim.machine import constants as gl
from glsim.machine.frame import Accum, Clear, Draw, Frame, Packet, QueryMark, Vertices
from glsim.machine.state import Color, ColorBuffer, Fog, Texturing
from glsim.names import SHADING

SHADE_MODEL = {"flat": gl.GL_FLAT, "gouraud": gl.GL_SMOOTH, "phong": gl.GL_PHONG_WIN}
LOBE = {"blinn": gl.GL_BLINN_TORRANCE_GLSIM, "phong": gl.GL_PHONG_LOBE_GLSIM}
WHOLE = gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT


def reshaded(shade: str | None, lobe: str | None) -> Callable[[Draw], Draw] | None:
    """A function that takes a Draw and returns it under another shading mode (see ``shaded``) and lobe; None if both
    arguments are None, because then nothing changes.

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
    """The frame with every lit draw under another shade model and lobe, without light, or as the edges of polygons:
    all of them ("wireframe"), or those that no polygon hides ("hidden-line")."""
    if mode == "hidden-line":
        return _hidden_line(frame)
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


def _hidden_line(frame: Frame) -> Frame:
    """Each Draw twice: filled with the background's colour and moved away from the eye a little, then as its edges."""
    packets: list[Packet] = []
    background: Color = (0.0, 0.0, 0.0, 0.0)
    for packet in _unlit(frame).packets:
        if isinstance(packet, Clear) and packet.mask & gl.GL_COLOR_BUFFER_BIT:
            background = packet.state.color_buffer.clear
        if isinstance(packet, Draw) and packet.mode >= gl.GL_TRIANGLES:
            packets += [_blanked(packet, background), _outlined(packet)]
        else:
            packets.append(packet)
    return replace(frame, packets=packets)


def _blanked(draw: Draw, color: Color) -> Draw:
    """Polygons filled with one opaque colour, behind where their edges are."""
    state = draw.state
    plain = draw.with_state(
        state._replace(
            lighting=state.lighting._replace(enabled=False, color_material=False),
            texture=Texturing(), fog=Fog(), color_buffer=ColorBuffer(mask=state.color_buffer.mask),
            polygon=state.polygon._replace(front_mode=gl.GL_FILL, back_mode=gl.GL_FILL, offset_fill=True,
                                           offset_factor=1.0, offset_units=1.0),
        )
    )  # fmt: skip
    plain.color = color
    return plain


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
