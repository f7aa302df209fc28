"""Asking the GPU which primitives cover a pixel, and what their fragments there are made of.

Primitives are drawn with their vertices in red, green and blue.  Interpolation then gives each fragment a colour whose
red, green and blue are the weights of the three vertices.  Everything else about a fragment is computed from those
weights on the CPU (glsim.study.fragments).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import PLAIN, corners
from glsim.machine.frame import Clear, Draw, Packet, Pixels
from glsim.machine.interrupts import uninterrupted
from glsim.machine.state import ColorBuffer, Depth, Lighting, Scissor, Snapshot, Stencil
from glsim.render.batch import assembled, separate
from glsim.render.lines import clip_positions, line_width, point_size, widened
from glsim.render.outline import prepare
from glsim.render.pixels import Fragments, Reader, as_fragments

if TYPE_CHECKING:
    from glsim.render.context import Offscreen

Float = NDArray[np.float64]
PROBES = 6  # outputs of shaders/probe.frag
RED_GREEN_BLUE = np.eye(3, dtype=np.float32)


@dataclass(frozen=True)
class Piece:
    """Primitives of one packet as the core profile draws them: plain triangles, lines or points, no vertex shared.

    packet: its number in the frame.  corners: vertices of a primitive; size: how many of ``draw`` make one: six for a
    wide line.  source: for each primitive the numbers of its vertices in the program's Draw, if they are its own.
    pixels: what the fragments of a pixel rectangle look up.
    """

    packet: int
    draw: Draw
    corners: int
    size: int
    source: NDArray[np.uint32] | None
    pixels: Fragments | None = None

    @property
    def count(self) -> int:
        return self.draw.count // self.size

    def vertices(self, primitives: NDArray[np.int64]) -> NDArray[np.uint32]:
        """Numbers in the draw's block of the corners of primitives: (n, corners)."""
        ends = np.array([0, 2] if self.size == 6 else range(self.corners))  # of a wide line's ends: A A B, A B B
        return np.asarray(primitives[:, None] * self.size + ends, np.uint32)

    def only(self, primitive: int) -> Piece:
        """One of the primitives alone."""
        chosen = np.arange(primitive * self.size, (primitive + 1) * self.size, dtype=np.uint32)
        source = None if self.source is None else self.source[[primitive]]
        return Piece(self.packet, _alone(self.draw, chosen), self.corners, self.size, source, self.pixels)


class Sample(NamedTuple):
    """A fragment: weights of the primitive's corners (perspective-correct), coverage of a smooth line or point, front
    side or not, distance for the fog, depth in [0, 1], the texels of all units (4, 4)."""

    weights: Float
    coverage: float
    front: bool
    fog_distance: float
    depth: float
    texels: Float


class GBuffer(NamedTuple):
    """What is seen at each pixel, top row first (the G-buffer of Saito & Takahashi 1990).

    piece: (height, width) numbers in ``pieces``, -1 where nothing was drawn; primitive: (height, width) numbers in the
    piece; front: (height, width), whether its front is seen; weights: (height, width, 3) of its corners; depth:
    (height, width) in [0, 1].
    """

    pieces: list[Piece]
    piece: NDArray[np.int64]
    primitive: NDArray[np.int64]
    front: NDArray[np.bool_]
    weights: Float
    depth: NDArray[np.float32]


def _alone(draw: Draw, chosen: NDArray[np.uint32]) -> Draw:
    """Some vertices of a Draw, as plain primitives over vertices of their own."""
    materials = []
    if draw.block.materials:
        materials = list(enumerate(draw.materials_at(chosen)))
    block = draw.block.take(chosen, materials)
    plain = Draw(PLAIN[corners(draw.mode)], 0, len(chosen), None, draw.matrices, draw.material, draw.state, block)
    if materials:
        plain.material = materials[0][1]
    plain.color = draw.color
    return plain


class Inspector:
    """Inspects packets of a frame on a screen of the frame's size."""

    def __init__(self, screen: Offscreen) -> None:
        self.screen = screen
        self.renderer = screen._renderer
        with uninterrupted(), screen.ctx:
            self.target = screen._framebuffer(0, PROBES)

    # ------------------------------------------------------------ packets -> primitives

    def pieces(self, number: int, packet: Packet) -> list[Piece]:
        """The primitives of packet ``number`` in the order they are drawn."""
        with uninterrupted(), self.screen.ctx:
            return list(self._pieces(number, packet))

    def _pieces(self, number: int, packet: Packet) -> Iterator[Piece]:
        if isinstance(packet, Pixels):
            read: Reader = self.screen._reread
            for rectangle in as_fragments(packet, (self.screen.width, self.screen.height), read):
                quad = _alone(rectangle.draw, assembled(rectangle.draw))
                yield Piece(number, quad, 3, 3, None, rectangle)
        elif isinstance(packet, Draw):
            for part in prepare([packet]):
                for draw in separate(part, self.renderer.limit):
                    chosen, kind = assembled(draw), corners(draw.mode)
                    size = 6 if kind == 2 and widened(draw.state) else kind
                    same_block = draw.block is packet.block
                    source = chosen.reshape(-1, kind) - np.uint32(packet.first) if same_block else None
                    if len(chosen):
                        yield Piece(number, _alone(draw, chosen), kind, size, source)

    # ------------------------------------------------------------ one pixel

    def sample(self, piece: Piece, primitive: int, x: int, y: int) -> Sample | None:
        """The fragment of one primitive at pixel x, y from the lower left; None if the primitive does not cover it."""
        one = piece.only(primitive)
        state = one.draw.state
        test = state.scissor
        inside = test.x <= x < test.x + test.width and test.y <= y < test.y + test.height
        if test.test and not inside:
            return None
        always = Depth(True, gl.GL_ALWAYS)
        buffers = ColorBuffer(dither=False)
        alone = state._replace(scissor=Scissor(True, x, y, 1, 1), depth=always, stencil=Stencil(), color_buffer=buffers)
        with uninterrupted(), self.screen.ctx:
            self.target.use()
            self.renderer.execute([Clear(0x4100, alone)], self.screen._reread)
            self.renderer.probe(1, _marked(one, alone), piece.pixels)
            primitive_of = self._read(1, x, y)
            if primitive_of[0] == 0.0:
                return None
            place, texels = self._read(0, x, y), [self._read(2 + unit, x, y) for unit in range(4)]
            depth = self._depth(x, y)
        with np.errstate(invalid="ignore"):  # a texel may be no number
            return Sample(
                place[:3].astype(np.float64)[: piece.corners], float(place[3]), bool(primitive_of[2] > 0.0),
                float(primitive_of[3]), depth, np.array(texels, np.float64),
            )  # fmt: skip

    def _read(self, probe: int, x: int, y: int) -> NDArray[np.float32]:
        data = self.target.read((x, y, 1, 1), 4, attachment=1 + probe, dtype="f4")
        return np.frombuffer(data, np.float32)

    def _depth(self, x: int, y: int) -> float:
        value = np.zeros(1, np.float32)
        self.target.use()
        self.renderer.raw.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        self.renderer.raw.glReadPixels(x, y, 1, 1, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT, value.ctypes.data)
        return float(value[0])

    def draw(self, piece: Piece, primitive: int, x: int, y: int) -> None:
        """Draw one primitive on the screen itself, at this pixel alone."""
        one = piece.only(primitive).draw
        with uninterrupted(), self.screen.ctx:
            self.screen._target.use()
            self.renderer.core.forget()
            if piece.pixels is not None:
                self.renderer.textures.rectangle(piece.pixels.image)
            self.renderer.draw([one.with_state(one.state._replace(scissor=Scissor(True, x, y, 1, 1)))], piece.pixels)

    # ------------------------------------------------------------ the whole picture

    def g_buffer(self, packets: Sequence[Packet]) -> GBuffer:
        """What is seen at each pixel after all packets are drawn."""
        pieces: list[Piece] = []
        for at, packet in enumerate(packets):
            if isinstance(packet, Clear):
                color = packet.state.color_buffer._replace(clear=(0.0, 0.0, 0.0, 0.0))
                self._into_target(packet._replace(state=packet.state._replace(color_buffer=color)))
            for piece in self.pieces(at, packet):
                if any(piece.draw.state.color_buffer.mask[:3]):
                    self._mark(piece, len(pieces) + 1)
                    pieces.append(piece)
            self.screen.execute([packet])
        with uninterrupted(), self.screen.ctx:
            place, primitive = (self._read_probe(probe) for probe in (0, 1))
            depth = self._read_depth()
        number: NDArray[np.int64] = np.rint(primitive[..., 0]).astype(np.int64) - 1
        sizes = np.array([2 if piece.size == 6 else 1 for piece in pieces] or [1])
        numbers = np.rint(primitive[..., 1]).astype(np.int64) // sizes[np.maximum(number, 0)]
        return GBuffer(pieces, number, numbers, primitive[..., 2] > 0.0, place[..., :3].astype(np.float64), depth)

    def _into_target(self, packet: Packet) -> None:
        with uninterrupted(), self.screen.ctx:
            self.target.use()
            self.renderer.execute([packet], self.screen._reread)

    def _mark(self, piece: Piece, number: int) -> None:
        state = piece.draw.state
        colors = state.color_buffer._replace(blend=False, logic_op_enabled=False, dither=False, mask=(True,) * 4)
        with uninterrupted(), self.screen.ctx:
            self.target.use()
            self.renderer.probe(number, _marked(piece, state._replace(color_buffer=colors)), piece.pixels)

    def _read_probe(self, probe: int) -> NDArray[np.float32]:
        data = self.target.read(components=4, attachment=1 + probe, dtype="f4")
        return np.frombuffer(data, np.float32).reshape(self.screen.height, self.screen.width, 4)[::-1]

    def _read_depth(self) -> NDArray[np.float32]:
        depth = np.zeros((self.screen.height, self.screen.width), np.float32)
        self.target.use()
        self.renderer.raw.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        size = (self.screen.width, self.screen.height)
        self.renderer.raw.glReadPixels(0, 0, *size, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT, depth.ctypes.data)
        return depth[::-1]


def _marked(piece: Piece, state: Snapshot) -> Draw:
    """The piece with vertices in red, green and blue, not lit; the alpha of the vertices stays."""
    draw = piece.draw
    marks = np.tile(RED_GREEN_BLUE[: piece.corners], (piece.count, 1))
    if piece.size == 6:  # shaders/line.glsl's order of the two ends
        marks = np.tile(RED_GREEN_BLUE[[0, 0, 1, 0, 1, 1]], (piece.count, 1))
    block = draw.block.take(np.arange(draw.count))
    block.rows[:, 6:9] = marks
    if draw.color is not None:
        block.rows[:, 9] = draw.color[3]
    if draw.state.lighting.enabled and state.color_buffer.alpha_test:
        block.rows[:, 9] = [material.front.diffuse[3] for material in draw.materials_at(np.arange(draw.count))]
    plain = state._replace(lighting=Lighting(shade_model=gl.GL_SMOOTH), fog=state.fog._replace(color_sum=False))
    return Draw(draw.mode, 0, draw.count, None, draw.matrices, draw.material, plain, block)


# ---------------------------------------------------------------- candidates


@np.errstate(all="ignore")
def candidates(piece: Piece, x: int, y: int) -> NDArray[np.int64]:
    """Primitives that may have a fragment at a pixel (from the lower left); all that do are among them.

    A triangle with corners v = (x, y, w) in clip coordinates covers a point p of the screen if all (v_j x v_k).p have
    the sign of its area, wherever its corners are (Olano & Greer 1997); here with a margin of one pixel.
    """
    state = piece.draw.state
    size = np.array([max(state.viewport.width, 1), max(state.viewport.height, 1)])
    p = np.append(2.0 * (np.array([x, y]) + 0.5 - state.viewport[:2]) / size - 1.0, 1.0)
    primitives = np.arange(piece.count)
    v = clip_positions(piece.draw, piece.vertices(primitives).ravel())[:, [0, 1, 3]].reshape(-1, piece.corners, 3)
    margin = 2.0 / size
    if piece.corners == 3:
        edges = np.cross(np.roll(v, -1, axis=1), np.roll(v, -2, axis=1))
        slack = np.abs(edges[..., :2]) @ margin
        area = np.einsum("nk,nk->n", v[:, 0], edges[:, 0])
        signed = (edges @ p) * np.sign(area)[:, None]
        possible = ~np.any(signed < -slack, axis=1) & (area != 0.0)
    else:
        radius = (line_width(state) if piece.corners == 2 else point_size(state)) / 2.0 + 1.5
        at = v[..., :2] / v[..., 2:]
        low, high = at.min(axis=1) - radius * margin, at.max(axis=1) + radius * margin
        possible = np.all((low <= p[:2]) & (p[:2] <= high), axis=1) | np.any(v[..., 2] <= 1e-6, axis=1)
    return np.asarray(primitives[possible])
