"""``Prober`` follows a pixel through a Frame and fills the data of probe.py; ``probe`` does so for anything drawn."""

from __future__ import annotations

import operator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.current import current_again
from glsim.machine.frame import Accum, Clear, Draw, Frame, Packet, Pixels, QueryMark, Where
from glsim.machine.state import Scissor
from glsim.play.frames import frame_of
from glsim.render.context import Offscreen, offscreen
from glsim.render.inspect import Inspector, Piece, Sample, candidates
from glsim.render.key import draw_key
from glsim.shading import Contribution, dot
from glsim.study.fragments import (
    COMPARISON_SIGNS,
    COMPARISONS,
    Shaded,
    blended,
    fog_factor,
    logic_op,
    shade,
    textured,
    to_8_bits,
)
from glsim.study.probe import Bytes, Evaluation, Event, Fragment, LightTerms, Numbers, Probe, Step, Vertex
from glsim.study.text import enum_name

Pair = tuple[NDArray[np.float64], NDArray[np.float64]]
KINDS = {3: "triangle", 2: "line", 1: "point"}
DEPTHS = (1 << 24) - 1


class Prober:
    """Probes pixels of one frame.  The picture begins black; it has one sample a pixel."""

    def __init__(self, frame: Frame) -> None:
        self.frame = frame
        with current_again():
            self.screen: Offscreen = offscreen(frame.width, frame.height)
        self.inspector = Inspector(self.screen)
        reads = any(isinstance(packet, Pixels) and packet.copied for packet in frame.packets)
        self.pieces: list[list[Piece]] = []
        self.draws: list[int] = []  # for each packet its number among the Draws
        for number, packet in enumerate(frame.packets):
            self.draws.append(sum(draw >= 0 for draw in self.draws) if isinstance(packet, Draw) else -1)
            self.pieces.append(self.inspector.pieces(number, packet))
            if reads:  # what glCopyPixels copies must be there
                self.screen.execute([packet])

    def release(self) -> None:
        self.screen.release()

    def at(self, x: int, y: int) -> Probe:
        """All that happened to a pixel.  Raises ValueError for one outside of the picture."""
        width, height = self.frame.width, self.frame.height
        x, y = operator.index(x), operator.index(y)
        if not (0 <= x < width and 0 <= y < height):
            raise ValueError(f"probe: the picture has {width} x {height} pixels, and ({x}, {y}) is not one of them")
        up = height - 1 - int(y)
        self.screen.reset()
        fragments: list[Fragment] = []
        events: list[Event] = []
        for number, packet in enumerate(self.frame.packets):
            for piece in self.pieces[number]:
                for primitive in candidates(piece, x, up).tolist():
                    fragment = self._fragment(packet, piece, primitive, x, up)
                    if fragment is not None:
                        fragments.append(fragment)
            if isinstance(packet, (Clear, Accum, QueryMark)):
                self.screen.execute([_at_pixel(packet, x, up)])
            if isinstance(packet, (Clear, Accum)):
                where, after = _line(self.frame, packet), self._pixel(x, up)
                events.append(Event(number, _name(packet), where, _covers(packet, x, up), after))
        pixel = self._pixel(x, up)
        result = Probe(x, y, height, pixel, pixel, tuple(fragments), tuple(events))
        winner = result.winner
        untouched = winner is not None and all(event.packet < winner.packet for event in events)
        return replace(result, computed=winner.computed) if winner is not None and untouched else result

    def _pixel(self, x: int, y: int) -> Bytes:
        r, g, b, a = self.screen.read(x, y, 1, 1, "color")[0, 0].tolist()
        return r, g, b, a

    def _fragment(self, packet: Packet, piece: Piece, primitive: int, x: int, y: int) -> Fragment | None:
        sample = self.inspector.sample(piece, primitive, x, y)
        if sample is None:
            return None
        before, depth = self._pixel(x, y), float(self.screen.read(x, y, 1, 1, "depth")[0, 0])
        stencil = int(self.screen.read(x, y, 1, 1, "stencil")[0, 0])
        self.inspector.draw(piece, primitive, x, y)
        after = self._pixel(x, y)
        one = piece.only(primitive)
        lit = shade(one, np.zeros(1, np.int64), sample.weights[None], not sample.front)
        primary = lit.primary[0]
        if piece.pixels is not None and piece.pixels.kind == "color":
            left, bottom = piece.pixels.origin
            color = piece.pixels.image[y - bottom, x - left].astype(np.float64)
            primary = color / 255.0 if piece.pixels.image.dtype == np.uint8 else color
        steps, killed, computed = _after_lighting(one, sample, primary, lit.highlight[0], before, depth, stencil)
        rectangle = piece.pixels is not None
        what = (
            _name(packet) if rectangle else f"{KINDS[piece.corners]} {primitive} of {_mode(packet, piece, primitive)}"
        )
        return Fragment(
            packet=piece.packet,
            draw=self.draws[piece.packet],
            where=_line(self.frame, packet),
            what=what,
            front=sample.front,
            shading="none" if rectangle else _shading(lit, piece, not sample.front),
            vertices=() if rectangle else _vertices(one, sample, lit),
            P=_floats(lit.P[0]),
            N=_floats(lit.N[0]),
            evaluations=_evaluations(one, sample, lit),
            primary=_floats(primary),
            highlight=_floats(lit.highlight[0]),
            steps=tuple(steps),
            depth=sample.depth,
            killed=killed,
            before=before,
            after=after,
            computed=computed,
        )


# ---------------------------------------------------------------- names


def _name(packet: Packet) -> str:
    if isinstance(packet, Clear):
        return "glClear"
    if isinstance(packet, Accum):
        return f"glAccum({enum_name(int(packet.operation))})"
    if isinstance(packet, Pixels):
        return "glCopyPixels" if packet.copied else "glBitmap" if packet.kind == "bitmap" else "glDrawPixels"
    return "query" if isinstance(packet, QueryMark) else repr(packet.mode)


def _mode(packet: Packet, piece: Piece, primitive: int) -> str:
    assert isinstance(packet, Draw)
    if piece.corners == 3 and packet.mode in (gl.GL_QUADS, gl.GL_QUAD_STRIP) and piece.source is not None:
        return f"{packet.mode!r}, quad {primitive // 2}"
    return repr(packet.mode)


def _line(frame: Frame, packet: Packet) -> Where | None:
    number = None if isinstance(packet, QueryMark) else packet.call
    return frame.calls[number].where if number is not None and number < len(frame.calls) else None


def _shading(lit: Shaded, piece: Piece, back: bool) -> str:
    lighting = piece.draw.state.lighting
    if not lighting.enabled:
        affine = ", affine" if draw_key(piece.draw).affine else ""
        flat = lit.where == "provoking"
        return "no lighting, " + ("flat: the last vertex's colour" if flat else "colours interpolated") + affine
    names = {"provoking": "flat: the equation at the provoking vertex",
             "vertex": "Gouraud: the equation at the vertices, colours interpolated",
             "fragment": "Phong: normals interpolated, the equation at the fragment"}  # fmt: skip
    if draw_key(piece.draw).affine:
        names = {where: f"{words}, affine" for where, words in names.items()}
    side = ", back side: N turned round" if lighting.two_side and back and piece.corners == 3 else ""
    return names[lit.where] + side


def _covers(packet: Clear | Accum, x: int, y: int) -> bool:
    """Whether a glClear, or glAccum(GL_RETURN), leaves nothing of the pixel's colour."""
    test, mask = packet.state.scissor, packet.state.color_buffer.mask
    inside = not test.test or (test.x <= x < test.x + test.width and test.y <= y < test.y + test.height)
    colors = packet.mask & gl.GL_COLOR_BUFFER_BIT if isinstance(packet, Clear) else packet.operation == gl.GL_RETURN
    return bool(colors) and inside and all(mask[:3])


def _floats(values: Any) -> Numbers:
    return tuple(float(value) for value in np.ravel(values))


def _at_pixel(packet: Clear | Accum | QueryMark, x: int, y: int) -> Packet:
    """The packet at one pixel alone."""
    if isinstance(packet, QueryMark):
        return packet
    test = packet.state.scissor
    inside = not test.test or (test.x <= x < test.x + test.width and test.y <= y < test.y + test.height)
    size = 1 if inside else 0
    return packet._replace(state=packet.state._replace(scissor=Scissor(True, x, y, size, size)))


# ---------------------------------------------------------------- the equation


def _vertices(one: Piece, sample: Sample, lit: Shaded) -> tuple[Vertex, ...]:
    from glsim.machine.stage import window

    rows = lit.corners[0]
    stage, weights = lit.stage, lit.weights[0]
    w = stage.clip[rows, 3]
    in_front = w > 0.0
    linear, hyperbolic = interpolation_weights(weights, w, draw_key(one.draw).affine)
    numbers = [-1] * len(rows) if one.source is None else one.source[0].tolist()
    at = np.where(in_front[:, None], window(stage.clip[rows], one.draw.state.viewport), np.nan)
    positions = one.draw.block.rows[one.vertices(np.zeros(1, np.int64))[0], :3]
    colors = stage.current[rows]
    if lit.where in ("vertex", "provoking") and lit.terms is not None:
        colors = np.column_stack([np.clip(lit.terms.sum[rows], 0.0, 1.0), np.ones(len(rows))])
    return tuple(
        Vertex(
            int(numbers[k]), _floats(positions[k]), _floats(stage.eye[row]), _floats(stage.normal[row]),
            _floats(at[k, :3]), float(linear[k]), float(hyperbolic[k]), _floats(colors[k]),
        )
        for k, row in enumerate(rows)
    )  # fmt: skip


def interpolation_weights(weights: NDArray[np.float64], w: NDArray[np.float64], affine: bool) -> Pair:
    """The linear and the hyperbolic weights of a primitive's corners, (k,) each.

    weights: those with which the GPU interpolated, linear ones if ``affine``.  w: of the corners in clip space.  The
    weights that were not used are NaN if a corner is behind the eye.
    """
    other = weights / w if affine else weights * w
    other = other / other.sum() if (w > 0.0).all() else np.full(len(w), np.nan)
    return (weights, other) if affine else (other, weights)


def _evaluations(one: Piece, sample: Sample, lit: Shaded) -> tuple[Evaluation, ...]:
    """Where the equation ran, with all numbers."""
    if lit.terms is None:
        return ()
    from glsim.machine.constants import GL_BACK, GL_FRONT
    from glsim.machine.stage import surface

    lighting, rows = one.draw.state.lighting, lit.corners[0]
    back = lighting.two_side and not sample.front and one.corners == 3
    chosen = one.vertices(np.zeros(1, np.int64))[0]
    if lit.where == "fragment":
        places = [(0, "fragment", 1.0, lit.N[0], lit.P[0])]
        materials = one.draw.materials_at(chosen[-1:])
        current = lit.weights @ lit.stage.current[rows]
    else:
        numbers = chosen if one.source is None else one.source[0]
        corners = range(len(rows)) if lit.where == "vertex" else [len(rows) - 1]
        sign = -1.0 if back else 1.0
        places = [
            (rows[k], f"vertex {numbers[k]}", lit.weights[0, k] if lit.where == "vertex" else 1.0,
             sign * lit.stage.normal[rows[k]], lit.stage.point[rows[k]])
            for k in corners
        ]  # fmt: skip
        materials = one.draw.materials_at(np.unique(chosen))
        current = lit.stage.current
    face, _ = surface(lighting, GL_BACK if back else GL_FRONT, materials, current)
    enabled = [number for number, on in enumerate(lighting.light_enabled) if on]
    vector = "R" if lighting.lobe == gl.GL_PHONG_LOBE_GLSIM else "H"
    total = lit.terms.sum
    reflectances = [[_floats(entry) for entry in np.asarray(part)] for part in (face.k_a, face.k_d, face.k_s)]
    return tuple(
        Evaluation(
            at, float(weight), _floats(P), _floats(N),
            reflectances[0][row], reflectances[1][row], reflectances[2][row], float(np.asarray(face.n)[row, 0]),
            _floats(lit.terms.emission[row]), _floats(lit.terms.ambient[row]), lighting.ambient[:3],
            tuple(_light(number, lighting.lights[number], light, row, vector)
                  for number, light in zip(enabled, lit.terms.lights, strict=True)),
            _floats(total[row]), _floats(np.clip(total[row], 0.0, 1.0)),
        )
        for row, at, weight, N, P in places
    )  # fmt: skip


def _light(number: int, source: Any, c: Contribution, row: int, vector: str) -> LightTerms:
    def one(values: NDArray[np.float64]) -> float:
        return float(np.broadcast_to(values, (*c.L.shape[:-1], 1))[row, 0])

    def three(values: NDArray[np.float64]) -> Numbers:
        return _floats(np.broadcast_to(values, c.L.shape)[row])

    return LightTerms(
        number, source.ambient[:3], source.diffuse[:3], source.specular[:3], three(c.L), one(c.d), one(c.attenuation),
        one(c.spot), one(dot(c.N, c.L)), three(c.V), vector, three(c.H_or_R), one(c.cosine), one(c.power),
        three(c.ambient), three(c.diffuse), three(c.specular),
    )  # fmt: skip


# ---------------------------------------------------------------- after lighting


def _after_lighting(
    one: Piece,
    sample: Sample,
    primary: NDArray[np.float64],
    highlight: NDArray[np.float64],
    before: Bytes,
    depth: float,
    stencil: int,
) -> tuple[list[Step], str, Bytes]:
    """Texture, highlight, fog, coverage, tests, blending: the steps, the test that failed, the pixel's 8 bits then."""
    state = one.draw.state
    steps: list[Step] = []
    color = primary
    for step in textured(state.texture.units, primary, sample.texels):
        color = step.color
        texel = ", ".join(f"{value:.4f}" for value in step.texel)
        words = f"{enum_name(int(step.environment))} with texel ({texel})"
        steps.append(Step(f"texture unit {step.unit}", words, _floats(color)))
    if (highlight > 0.0).any() or state.fog.color_sum:
        color = np.append(np.minimum(color[:3] + highlight, 1.0), color[3])
        steps.append(Step("highlight", "added after texturing", _floats(color)))
    if state.fog.enabled:
        f = fog_factor(state.fog, sample.fog_distance)
        color = np.append(f * color[:3] + (1.0 - f) * np.array(state.fog.color[:3]), color[3])
        words = f"f C + (1 - f) C_fog, f = {f:.4f} at distance {sample.fog_distance:.4f}"
        steps.append(Step("fog", words, _floats(color)))
    if sample.coverage != 1.0:
        color = np.append(color[:3], color[3] * sample.coverage)
        steps.append(Step("coverage", f"alpha times {sample.coverage:.4f}", _floats(color)))
    killed = _tests(one, sample, color, depth, stencil, steps)
    if killed:
        return steps, killed, before
    if not any(state.color_buffer.mask) or state.color_buffer.draw_buffer == gl.GL_NONE:
        return steps, "colour mask", before
    return steps, "", _written(one, color, before, steps)


def _tests(
    one: Piece, sample: Sample, color: NDArray[np.float64], depth: float, stencil: int, steps: list[Step]
) -> str:
    """The name of the first test the fragment fails, "" if it passes all."""
    state = one.draw.state
    buffers = state.color_buffer
    checks: list[tuple[str, int, int, int]] = []  # name, comparison, the fragment's number, what it is compared with
    if buffers.alpha_test:
        checks.append(
            ("alpha test", buffers.alpha_func, *to_8_bits(np.array([color[3], buffers.alpha_reference])).tolist())
        )
    if state.stencil.test:
        mask, reference = state.stencil.value_mask & 255, min(max(state.stencil.reference, 0), 255)
        checks.append(("stencil test", state.stencil.func, reference & mask, stencil & mask))
    if state.depth.test:
        checks.append(("depth test", state.depth.func, round(sample.depth * DEPTHS), round(depth * DEPTHS)))
    for name, func, mine, stored in checks:
        passed = COMPARISONS[func](mine, stored)
        scale = DEPTHS if name == "depth test" else 1
        shown = f"{mine / scale:.7g} {COMPARISON_SIGNS[func]} {stored / scale:.7g}"
        steps.append(Step(name, shown if passed else f"{shown} is false", _floats(color), passed))
        if not passed:
            return name
    return ""


def _written(one: Piece, color: NDArray[np.float64], before: Bytes, steps: list[Step]) -> Bytes:
    """Blending or logic op, masks, 8 bits."""
    buffers = one.draw.state.color_buffer
    old = np.array(before)
    if buffers.logic_op_enabled:
        result = logic_op(buffers.logic_op, to_8_bits(color), old)
        steps.append(Step("logic op", f"{buffers.logic_op!r}", _floats(result / 255.0)))
    else:
        if buffers.blend:
            color = np.clip(blended(buffers, np.clip(color, 0.0, 1.0), old / 255.0), 0.0, 1.0)
            names = f"{buffers.blend_equation!r} with {buffers.blend_function[0]!r}, {buffers.blend_function[1]!r}"
            steps.append(Step("blending", f"{names} over {before}", _floats(color)))
        result = to_8_bits(color)
    mask = np.array(buffers.mask) & (buffers.draw_buffer != gl.GL_NONE)
    if not mask.all():
        kept = "".join(name for name, writes in zip("RGBA", mask, strict=True) if not writes)
        steps.append(Step("colour mask", f"{kept} kept", _floats(np.where(mask, result, old) / 255.0)))
    r, g, b, a = np.where(mask, result, old).tolist()
    return r, g, b, a


def probe(what: Any, x: int, y: int, **options: Any) -> Probe:
    """Why the pixel x, y (from the upper left) of what ``what`` draws has its colour.

    what: a Frame (glsim.capture), or anything else that play.frames.frame_of takes, with its options.
    Raises ValueError for a pixel outside of the picture.
    """
    return Prober(frame_of(what, **options)).at(x, y)
