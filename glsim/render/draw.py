"""Executing packets with moderngl: upload what a plan needs, then one call per batch."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from glsim.machine.constants import GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER
from glsim.machine.frame import Clear, Draw, Packet, Vertices
from glsim.machine.matrix import evaluate, inverse_transpose, multiply
from glsim.machine.state import Light, Lighting, Material, Snapshot
from glsim.render.batch import Batch, Object, Plan, plan, separate
from glsim.render.programs import BINDINGS, ProgramKey, build, program_key
from glsim.render.raw import RawGL

LAST_VERTEX_CONVENTION = 0x8E4E
PRIMITIVES = {1: moderngl.POINTS, 2: moderngl.LINES, 3: moderngl.TRIANGLES}
ROW_SIZE = 256  # of a Transform and of a Material in shaders/state.glsl
LIGHTS_SIZE = 1024
CORE_BITS = 0x4000 | 0x100 | 0x400  # colour, depth and stencil; there is no accumulation buffer in the core profile


class Renderer:
    """Draws packets into the framebuffer that is bound when ``execute`` is called."""

    def __init__(self, ctx: moderngl.Context, raw: RawGL) -> None:
        self.ctx, self.raw = ctx, raw
        self.limit = min(ctx.info["GL_MAX_UNIFORM_BLOCK_SIZE"], 65536) // ROW_SIZE
        self.programs: dict[ProgramKey, moderngl.Program] = {}
        self.vertex_arrays: dict[ProgramKey, moderngl.VertexArray] = {}
        self.buffers = {name: ctx.buffer(reserve=1024, dynamic=True) for name in ("rows", "w", "object", "indices")}
        self.uniforms = {name: ctx.buffer(reserve=1024, dynamic=True) for name in BINDINGS}
        self.uploaded_lights: Lighting | None = None
        self.fixed: Snapshot | None = None
        self.busy = False  # whether the GPU may still read the buffers

    # ------------------------------------------------------------ packets

    def execute(self, packets: Iterable[Packet]) -> None:
        """Draw; the context must be current and the framebuffer bound."""
        self.fixed = None  # somebody else may have changed the driver's state since
        for _, group in groupby(packets, key=_kind):
            run = list(group)
            if isinstance(run[0], Clear):
                for packet in run:
                    self._clear(packet)  # type: ignore[arg-type]
            else:
                self._draw(run)  # type: ignore[arg-type]

    def _clear(self, packet: Clear) -> None:
        state, raw = packet.state, self.raw
        self._apply(state)
        raw.glColorMask(*state.color_buffer.mask)
        raw.glDepthMask(state.depth.mask)
        raw.glClearColor(*state.color_buffer.clear)
        raw.glClearDepth(state.depth.clear)
        raw.glClear(packet.mask & CORE_BITS)

    def _draw(self, draws: Sequence[Draw]) -> None:
        for _, group in groupby((part for draw in draws for part in separate(draw, self.limit)), key=_vertices):
            todo = plan(list(group), self.limit)
            many = len(todo.rows) > 0
            self._upload(todo)
            for batch in todo.batches:
                if batch.count:
                    self._draw_batch(batch, many and batch.objects > 1)
            self.busy = True

    def _draw_batch(self, batch: Batch, many: bool) -> None:
        self._apply(batch.state)
        self._upload_lights(batch.state.lighting)
        key = program_key(batch.state)._replace(
            has_w=batch.vertices.w is not None, points=batch.corners == 1, objects=self.limit if many else 1
        )
        for name in ("Transforms", "Materials"):
            size = ROW_SIZE * key.objects
            self.uniforms[name].bind_to_uniform_block(BINDINGS[name], offset=ROW_SIZE * batch.base, size=size)
        self.uniforms["Lights"].bind_to_uniform_block(BINDINGS["Lights"], size=LIGHTS_SIZE)
        if key.points:
            width, height = batch.state.viewport[2:4]
            self.program(key)["point_shift"] = 2.002 / 256 / max(width, 1), 1.998 / 256 / max(height, 1)
        self.vertex_array(key).render(PRIMITIVES[batch.corners], vertices=batch.count, first=batch.start)

    # ------------------------------------------------------------ programs and buffers

    def program(self, key: ProgramKey) -> moderngl.Program:
        if key not in self.programs:
            self.programs[key] = build(self.ctx, key)
        return self.programs[key]

    def vertex_array(self, key: ProgramKey) -> moderngl.VertexArray:
        if key not in self.vertex_arrays:
            program = self.program(key)
            inputs = [("3f", "position"), ("3f", "normal"), ("4f", "color")]
            layout = " ".join(form if name in program else f"{4 * int(form[0])}x" for form, name in inputs)
            content: list[Any] = [(self.buffers["rows"], layout, *(name for _, name in inputs if name in program))]
            if "position_w" in program:
                content.append((self.buffers["w"], "1f", "position_w"))
            if "object" in program:
                content.append((self.buffers["object"], "1u4", "object"))
            self.vertex_arrays[key] = self.ctx.vertex_array(program, content, index_buffer=self.buffers["indices"])
        return self.vertex_arrays[key]

    def _write(self, buffer: moderngl.Buffer, data: NDArray[Any], room: int = 0) -> None:
        """Replace a buffer's content, with ``room`` bytes at least.

        While the GPU may still read the old content the buffer gets new memory, so that nobody waits.
        """
        data = np.ascontiguousarray(data)
        size = max(room, data.nbytes)
        if self.busy or buffer.size < size:
            buffer.orphan(max(buffer.size, size))
        if data.nbytes:
            buffer.write(data)

    def _upload(self, todo: Plan) -> None:
        self._write(self.buffers["rows"], todo.vertices.rows)
        self._write(self.buffers["indices"], todo.indices)
        if todo.vertices.w is not None:
            self._write(self.buffers["w"], todo.vertices.w)
        if len(todo.rows):
            self._write(self.buffers["object"], todo.rows)
        room = len(todo.objects) + self.limit  # a block always has `limit` rows, wherever it begins
        self._write(self.uniforms["Transforms"], transforms(todo.objects), room * ROW_SIZE)
        self._write(self.uniforms["Materials"], materials(todo.objects), room * ROW_SIZE)

    def _upload_lights(self, lighting: Lighting) -> None:
        if lighting is not self.uploaded_lights:
            self._write(self.uniforms["Lights"], lights(lighting))
            self.uploaded_lights = lighting

    # ------------------------------------------------------------ state that the core profile kept

    def _apply(self, state: Snapshot) -> None:
        old, raw = self.fixed, self.raw
        if old is state:
            return
        self.fixed = state
        if old is None:
            raw.glProvokingVertex(LAST_VERTEX_CONVENTION)
        if old is None or old.viewport != state.viewport:
            x, y, width, height, near, far = state.viewport
            raw.glViewport(x, y, width, height)
            raw.glDepthRange(near, far)
        if old is None or old.polygon != state.polygon:
            self._switch(GL_CULL_FACE, state.polygon.cull)
            raw.glCullFace(state.polygon.cull_face)
            raw.glFrontFace(state.polygon.front_face)
        if old is None or old.depth != state.depth:
            self._switch(GL_DEPTH_TEST, state.depth.test)
            raw.glDepthFunc(state.depth.func)
            raw.glDepthMask(state.depth.mask)
        if old is None or old.color_buffer != state.color_buffer:
            self._switch(GL_DITHER, state.color_buffer.dither)
            raw.glColorMask(*state.color_buffer.mask)

    def _switch(self, cap: int, on: bool) -> None:
        (self.raw.glEnable if on else self.raw.glDisable)(cap)


def _kind(packet: Packet) -> type:
    return type(packet)


def _vertices(draw: Draw) -> Vertices:
    return draw.vertices


# ---------------------------------------------------------------- rows of shaders/state.glsl


def transforms(objects: Sequence[Object]) -> NDArray[np.float32]:
    """struct Transform for each object: (n, 64) float32."""
    evaluate({matrix: None for (pair, _) in objects for matrix in pair})
    modelview = np.array([pair[0].value for pair, _ in objects])
    projection = np.array([pair[1].value for pair, _ in objects])
    rows = np.zeros((len(objects), ROW_SIZE // 4), np.float32)
    with np.errstate(all="ignore"):
        rows[:, 0:16] = multiply(projection, modelview).reshape(-1, 16)
    rows[:, 16:32] = modelview.reshape(-1, 16)
    rows[:, 32:44].reshape(-1, 3, 4)[:, :, :3] = inverse_transpose(modelview)
    return rows


def materials(objects: Sequence[Object]) -> NDArray[np.float32]:
    """struct Material for each object: (n, 64) float32."""
    rows = np.zeros((len(objects), ROW_SIZE // 4), np.float32)
    packed: dict[int, list[float]] = {}
    table = []
    for _, material in objects:
        if id(material) not in packed:
            packed[id(material)] = _faces(material)
        table.append(packed[id(material)])
    rows[:, :40] = table
    return rows


def _faces(material: Material) -> list[float]:
    values: list[float] = []
    for face in material:
        values += (*face.ambient, *face.diffuse, *face.specular, *face.emission, face.shininess, 0.0, 0.0, 0.0)
    return values


def lights(lighting: Lighting) -> NDArray[np.float32]:
    """The block Lights: eight struct Light and scene_ambient, (256,) float32."""
    block = np.zeros(LIGHTS_SIZE // 4, np.float32)
    for k, light in enumerate(lighting.lights):
        block[24 * k : 24 * k + 24] = _light(light)
    block[192:196] = lighting.ambient
    return block


def _light(light: Light) -> list[float]:
    x, y, z, w = light.position
    position = (x / w, y / w, z / w) if w else _unit((x, y, z))
    cosine = -1.0 if light.spot_cutoff == 180.0 else math.cos(math.radians(light.spot_cutoff))
    return [
        *position, w, *light.ambient, *light.diffuse, *light.specular, *_unit(light.spot_direction),
        light.spot_exponent, light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation, cosine,
    ]  # fmt: skip


def _unit(vector: tuple[float, float, float]) -> tuple[float, float, float]:
    length = math.sqrt(sum(c * c for c in vector))
    return tuple(c / length for c in vector) if length > 0.0 else vector  # type: ignore[return-value]
