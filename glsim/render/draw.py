"""Executing packets on the GPU: upload what a plan needs, then one call per batch."""

from __future__ import annotations

import ctypes
import weakref
from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import PLAIN
from glsim.machine.frame import Accum, Clear, Draw, Packet, Pixels, QueryMark, Vertices
from glsim.machine.state import Lighting, Snapshot
from glsim.render import uniforms
from glsim.render.accumulation import Accumulation
from glsim.render.batch import MOST_OBJECTS, Batch, Plan, plans
from glsim.render.compile import BINDINGS, build
from glsim.render.corestate import CoreState
from glsim.render.gpu import GPU, Buffer, Commands, Program
from glsim.render.key import ProgramKey, draw_key
from glsim.render.lines import margin
from glsim.render.outline import prepare
from glsim.render.pixels import Fragments, Reader, as_fragments, merged_bitmaps
from glsim.render.source import INPUTS, Source
from glsim.render.textures import Textures
from glsim.render.uniforms import LIGHTS, RASTER, ROW_SIZE, TEXTURING

# size of the blocks of which there is one; Transforms and Materials have a row of ROW_SIZE bytes for each object
SHARED = {"Lights": LIGHTS.itemsize, "Raster": RASTER.itemsize, "Texturing": TEXTURING.itemsize}
CORE_BITS = 0x4000 | 0x100 | 0x400  # colour, depth and stencil; there is no accumulation buffer in the core profile


class Renderer:
    """Draws packets into the framebuffer that is bound when ``execute`` is called.

    size: its width and height.
    """

    def __init__(self, gpu: GPU, raw: Commands, size: tuple[int, int]) -> None:
        self.gpu, self.raw = gpu, raw
        self.limit = min(gpu.info["GL_MAX_UNIFORM_BLOCK_SIZE"] // ROW_SIZE, MOST_OBJECTS)
        self.programs: dict[ProgramKey, Program] = {}
        self.inputs: dict[ProgramKey, list[str]] = {}  # those of INPUTS that the program reads
        self.stream = Source(gpu)
        self.static: weakref.WeakKeyDictionary[Vertices, Source] = weakref.WeakKeyDictionary()
        self.uniforms: dict[str, Buffer] = {name: gpu.buffer(reserve=1024, dynamic=True) for name in BINDINGS}
        self.uploaded: dict[str, tuple[Any, ...]] = {}  # by block, the state that its buffer holds
        self.textures = Textures(raw)
        self.core = CoreState(raw)
        self.numbers = np.arange(self.limit, dtype=np.uint32)
        self.size = size
        self.accumulation = Accumulation(size)
        self.query = 0  # the driver's name of the query that is counting
        self.busy = False  # whether the GPU may still read the buffers
        self.probing = 0  # the number of the draw whose fragments probe.frag inspects; 0: none

    def resize(self, size: tuple[int, int]) -> None:
        self.size, self.accumulation = size, Accumulation(size)

    def reset(self) -> None:
        """Forget the accumulation buffer and a query that has not ended; the context must be current."""
        self.accumulation = Accumulation(self.size)
        if self.query:
            self.raw.glEndQuery(gl.GL_SAMPLES_PASSED)
            self.query = 0

    # ------------------------------------------------------------ packets

    def execute(self, packets: Iterable[Packet], read: Reader) -> None:
        """Draw; the context must be current and the framebuffer bound.

        read: reads a rectangle of the framebuffer (x, y, width, height, "color", "depth" or "stencil").
        """
        self.gpu.gc()
        self.core.forget()
        for kind, group in groupby(packets, key=type):
            run: list[Any] = list(group)
            if kind is Draw:
                self.draw(run)
            elif kind is Pixels:
                for pixels in merged_bitmaps(run, self.size):
                    self._draw_pixels(pixels, read)
            elif kind is Accum:
                for packet in run:
                    self._accumulate(packet, read)
            else:
                for packet in run:
                    (self._clear if kind is Clear else self._mark)(packet)

    def probe(self, number: int, draw: Draw, pixels: Fragments | None) -> None:
        """Draw into the framebuffer of an Inspector.  number: by which the draw is known there, from 1."""
        self.core.forget()
        self.probing = number
        if pixels is not None:
            self.textures.rectangle(pixels.image)
        try:
            self.draw([draw], pixels)
        finally:
            self.probing = 0

    def _clear(self, packet: Clear) -> None:
        state, raw = packet.state, self.raw
        self.core.apply(state, 3)
        raw.glDepthMask(state.depth.mask)
        raw.glClearColor(*state.color_buffer.clear)
        raw.glClearDepth(state.depth.clear)
        raw.glClearStencil(state.stencil.clear)
        raw.glClear(packet.mask & CORE_BITS)
        if packet.mask & gl.GL_ACCUM_BUFFER_BIT:
            self.accumulation.clear(packet)

    def _mark(self, packet: QueryMark) -> None:
        """glBeginQuery and glEndQuery; glEndQuery waits for the result of the query."""
        raw, number = self.raw, ctypes.c_uint()
        if packet.begin:
            raw.glGenQueries(1, ctypes.byref(number))
            raw.glBeginQuery(gl.GL_SAMPLES_PASSED, number.value)
            self.query = number.value
        elif self.query:
            raw.glEndQuery(gl.GL_SAMPLES_PASSED)
            raw.glGetQueryObjectuiv(self.query, gl.GL_QUERY_RESULT, ctypes.byref(number))
            packet.query.result = number.value
            raw.glDeleteQueries(1, ctypes.byref(ctypes.c_uint(self.query)))
            self.query = 0

    def _draw_pixels(self, packet: Pixels, read: Reader) -> None:
        """One glDrawPixels, glCopyPixels or glBitmap."""
        for part in as_fragments(packet, self.size, read):
            self.core.forget()  # reading may have changed the driver's state
            self.textures.rectangle(part.image)
            self.draw([part.draw], part)

    def _accumulate(self, packet: Accum, read: Reader) -> None:
        pixels = self.accumulation.execute(packet, read)
        self.core.forget()  # reading may have changed the driver's state
        if pixels is not None:
            self._draw_pixels(pixels, read)

    # ------------------------------------------------------------ primitives

    def draw(self, draws: Sequence[Draw], pixels: Fragments | None = None) -> None:
        """Draw primitives.  pixels: what the fragments take from a rectangle of pixels."""
        objects, drawing_plans = plans(list(prepare(draws)), self.limit)
        if not objects:
            return  # every polygon is culled, or none is complete
        room = (len(objects) + self.limit) * ROW_SIZE  # a block always has `limit` rows, wherever it begins
        self._write("Transforms", uniforms.transforms(objects), room)
        self._write("Materials", uniforms.materials(objects), room)
        for plan in drawing_plans:
            source = self._static_source(plan) if plan.instances else self._streamed_source(plan)
            for batch in plan.batches:
                if batch.count:
                    self._draw_batch(batch, plan, source, pixels)
            self.busy = True

    def _draw_batch(self, batch: Batch, plan: Plan, source: Source, pixels: Fragments | None) -> None:
        state = batch.state
        objects = self.limit if plan.several(batch) else 1
        key = draw_key(batch.draws[0], objects, pixels.kind if pixels else "", self.probing > 0)
        space = margin(state, batch.corners)
        self.core.apply(state, batch.corners, space)
        self._upload_lights(state.lighting)
        self._upload_raster(state, pixels.origin if pixels else (0, 0), space)
        if key.units:
            self._upload_texturing(batch)
            for unit in key.units:
                self.textures.bind(unit.number, state.texture.units[unit.number])
        for name in ("Transforms", "Materials"):
            size = ROW_SIZE * key.objects
            self.uniforms[name].bind_to_uniform_block(BINDINGS[name], offset=ROW_SIZE * batch.base, size=size)
        for name, size in SHARED.items():
            self.uniforms[name].bind_to_uniform_block(BINDINGS[name], size=size)
        program = self.program(key)
        source.fill(batch.vertices, self.inputs[key], self.busy)
        array = source.vertex_array(key, program, "/i" if plan.instances else "/v")
        mode = gl.GL_TRIANGLES if key.wide_lines else PLAIN[batch.corners]
        array.render(mode, vertices=batch.count, first=batch.start, instances=batch.objects if plan.instances else 1)

    # ------------------------------------------------------------ programs and buffers

    def program(self, key: ProgramKey) -> Program:
        if key not in self.programs:
            program = self.programs[key] = build(self.gpu, key)
            self.inputs[key] = [name for name in INPUTS if name in program]
        return self.programs[key]

    def _streamed_source(self, plan: Plan) -> Source:
        """The buffers that are written anew for each plan."""
        source = self.stream
        source.write("rows", plan.vertices.rows, self.busy)
        source.write("indices", plan.indices, self.busy)
        if len(plan.rows) or "object" not in source.buffers:
            source.write("object", plan.rows, self.busy)
        source.columns.clear()
        return source

    def _static_source(self, plan: Plan) -> Source:
        """The buffers of a display list: written once."""
        source = self.static.get(plan.vertices)
        if source is None:
            source = self.static[plan.vertices] = Source(self.gpu)
            source.write("rows", plan.vertices.rows, False)
            source.write("object", self.numbers, False)
        if source.indices is None or source.indices() is not plan.indices:
            source.write("indices", plan.indices, self.busy)
            source.indices = weakref.ref(plan.indices)
        return source

    def _write(self, name: str, data: NDArray[Any], room: int = 0) -> None:
        """Replace a uniform buffer's content, with ``room`` bytes at least."""
        buffer, size = self.uniforms[name], max(room, data.nbytes)
        if self.busy or buffer.size < size:
            buffer.orphan(max(buffer.size, size))
        buffer.write(data)

    def _upload_lights(self, lighting: Lighting) -> None:
        groups = lighting.lights, lighting.ambient
        if groups != self.uploaded.get("Lights"):
            self._write("Lights", uniforms.lights(lighting))
            self.uploaded["Lights"] = groups

    def _upload_raster(self, state: Snapshot, origin: tuple[int, int], space: int) -> None:
        groups = (
            state.fog, state.transform, state.point, state.viewport, state.line, state.polygon_stipple,
            state.color_buffer.alpha_reference, origin, self.probing, space,
        )  # fmt: skip
        if groups != self.uploaded.get("Raster"):
            self._write("Raster", uniforms.raster(state, origin, self.probing, space))
            self.uploaded["Raster"] = groups

    def _upload_texturing(self, batch: Batch) -> None:
        """The units, with the texture matrices of all but the first, which agree in a batch."""
        groups = batch.state.texture.units, batch.draws[0].matrices[3:]
        if groups != self.uploaded.get("Texturing"):
            self._write("Texturing", uniforms.texturing(*groups))
            self.uploaded["Texturing"] = groups
