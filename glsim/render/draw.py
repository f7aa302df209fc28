"""Executing packets with moderngl: upload what a plan needs, then one call per batch."""

from __future__ import annotations

import ctypes
import math
import weakref
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import groupby
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.frame import Accum, Clear, Draw, Packet, Pixels, QueryMark, Vertices
from glsim.machine.matrix import Matrix, evaluate, inverse_transpose, multiply
from glsim.machine.pixels import PixelMode
from glsim.machine.state import (
    TEXTURE_UNITS,
    ColorBuffer,
    Light,
    Lighting,
    Material,
    RasterPosition,
    Snapshot,
    TextureUnit,
)
from glsim.render.batch import MOST_OBJECTS, Batch, Object, Plan, plans
from glsim.render.lines import line_width, margin
from glsim.render.outline import prepare
from glsim.render.pixels import Fragments, Reader, as_fragments, merged_bitmaps, plain_state
from glsim.render.programs import BINDINGS, ProgramKey, build, draw_key
from glsim.render.raw import RawGL
from glsim.render.textures import Textures

LAST_VERTEX_CONVENTION = 0x8E4E
PRIMITIVES = {1: moderngl.POINTS, 2: moderngl.LINES, 3: moderngl.TRIANGLES}
ROW_SIZE = 256  # of a Transform and of a Material in shaders/state.glsl
LIGHTS_SIZE = 1024
RASTER_SIZE = 336
TEXTURING_SIZE = 1024
SHARED = {"Lights": LIGHTS_SIZE, "Raster": RASTER_SIZE, "Texturing": TEXTURING_SIZE}  # blocks of which there is one
PROGRAM_POINT_SIZE, TEXTURE_CUBE_MAP_SEAMLESS, DEPTH_CLAMP = 0x8642, 0x884F, 0x864F
CORE_BITS = 0x4000 | 0x100 | 0x400  # colour, depth and stencil; there is no accumulation buffer in the core profile


# Inputs of main.vert beside position, normal and color: how they lie in a buffer, and where they come from.
INPUTS = {
    **{f"texcoord{unit}": ("4f", f"texcoord{unit}") for unit in range(TEXTURE_UNITS)},
    "depth_offset": ("1f", "depth_offset"),
    "position_w": ("1f", "w"),
    "lit_position": ("4f", "lit_position"),
    "secondary_color": ("4f", "secondary_color"),
    "fog_coord": ("1f", "fog_coord"),
    "other_end": ("4f", "other_end"),
    "line_corner": ("2f", "line_corner"),
    "line_begin": ("1f", "line_begin"),
}


class Source:
    """Buffers with vertices and indices, and the vertex arrays over them.

    The renderer has one that every plan overwrites, and one for each block of vertices of a display list, kept as
    long as the list.
    """

    def __init__(self, ctx: moderngl.Context) -> None:
        self.ctx = ctx
        self.buffers: dict[str, moderngl.Buffer] = {}
        self.vertex_arrays: dict[ProgramKey, moderngl.VertexArray] = {}
        self.indices: weakref.ref[Any] | None = None  # what the index buffer holds, if it is kept
        self.columns: set[str] = set()  # which columns are there

    def write(self, name: str, data: NDArray[Any], busy: bool) -> None:
        """Replace a buffer's content.  While the GPU may still read the old one it gets new memory."""
        data = np.ascontiguousarray(data)
        buffer = self.buffers.get(name)
        if buffer is None:
            buffer = self.buffers[name] = self.ctx.buffer(reserve=max(data.nbytes, 1024), dynamic=True)
        elif busy or buffer.size < data.nbytes:
            buffer.orphan(max(buffer.size, data.nbytes))
        if data.nbytes:
            buffer.write(data)

    def fill(self, vertices: Vertices, inputs: Sequence[str], busy: bool) -> None:
        """Write the columns that a program with these inputs reads and that are not there yet."""
        for name in inputs:
            column = INPUTS[name][1]
            if column not in self.columns:
                self.write(name, vertices.column(column), busy)
                self.columns.add(column)

    def vertex_array(self, key: ProgramKey, program: moderngl.Program, per: str) -> moderngl.VertexArray:
        """per: "/v" if objects are numbered per vertex, "/i" if per instance."""
        if key not in self.vertex_arrays:
            inputs = [("3f", "position"), ("3f", "normal"), ("4f", "color")]
            layout = " ".join(form if name in program else f"{4 * int(form[0])}x" for form, name in inputs)
            content: list[Any] = [(self.buffers["rows"], layout, *(name for _, name in inputs if name in program))]
            content += [(self.buffers[name], form, name) for name, (form, _) in INPUTS.items() if name in program]
            if "object" in program:
                content.append((self.buffers["object"], "1u4" + per, "object"))
            indices = self.buffers["indices"]
            self.vertex_arrays[key] = self.ctx.vertex_array(program, content, index_buffer=indices)
        return self.vertex_arrays[key]


class Renderer:
    """Draws packets into the framebuffer that is bound when ``execute`` is called.

    size: its width and height.
    """

    def __init__(self, ctx: moderngl.Context, raw: RawGL, size: tuple[int, int]) -> None:
        self.ctx, self.raw = ctx, raw
        ctx.gc_mode = "context_gc"  # buffers of lists that are gone are released when the context is current
        self.limit = min(ctx.info["GL_MAX_UNIFORM_BLOCK_SIZE"] // ROW_SIZE, MOST_OBJECTS)
        self.programs: dict[ProgramKey, moderngl.Program] = {}
        self.inputs: dict[ProgramKey, list[str]] = {}  # those of INPUTS that the program reads
        self.stream = Source(ctx)
        self.static: weakref.WeakKeyDictionary[Vertices, Source] = weakref.WeakKeyDictionary()
        self.uniforms = {name: ctx.buffer(reserve=1024, dynamic=True) for name in BINDINGS}
        self.textures = Textures(raw)
        self.numbers = np.arange(self.limit, dtype=np.uint32)
        self.uploaded_lights: tuple[Any, ...] = ()
        self.uploaded_raster: tuple[Any, ...] = ()
        self.uploaded_texturing: tuple[Any, ...] = ()
        self.size = size
        self.accumulation: NDArray[np.float32] | None = None
        self.query = 0  # the driver's name of the query that is counting
        self.fixed: tuple[Snapshot, int, int] | None = None
        self.busy = False  # whether the GPU may still read the buffers
        self.probing: int | None = None  # the number of the draw whose fragments shall tell what they are made of

    def resize(self, size: tuple[int, int]) -> None:
        self.size, self.accumulation = size, None

    def reset(self) -> None:
        """Forget the accumulation buffer and a query that has not ended; the context must be current."""
        self.accumulation = None
        if self.query:
            self.raw.glEndQuery(gl.GL_SAMPLES_PASSED)
            self.query = 0

    # ------------------------------------------------------------ packets

    def execute(self, packets: Iterable[Packet], read: Reader) -> None:
        """Draw; the context must be current and the framebuffer bound.

        read: reads a rectangle of the framebuffer (x, y, width, height, "color", "depth" or "stencil").
        """
        self.ctx.gc()
        self.fixed = None  # somebody else may have changed the driver's state since
        for kind, group in groupby(packets, key=type):
            run: list[Any] = list(group)
            if kind is Draw:
                self._draw(run)
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
        """Draw into the framebuffer of an Inspector."""
        self.fixed = None
        self.probing = number
        if pixels is not None:
            self.textures.rectangle(pixels.image)
        try:
            self._draw([draw], pixels)
        finally:
            self.probing = None

    def _clear(self, packet: Clear) -> None:
        state, raw = packet.state, self.raw
        self._apply(state, 3)
        raw.glDepthMask(state.depth.mask)
        raw.glClearColor(*state.color_buffer.clear)
        raw.glClearDepth(state.depth.clear)
        raw.glClearStencil(state.stencil.clear)
        raw.glClear(packet.mask & CORE_BITS)
        if packet.mask & gl.GL_ACCUM_BUFFER_BIT:
            part = self._scissored(state)
            self._accum()[part] = packet.accum

    def _mark(self, packet: QueryMark) -> None:
        """glBeginQuery and glEndQuery; the number is waited for, as soon as the query ends."""
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

    # ------------------------------------------------------------ pixel rectangles and accumulation

    def _draw_pixels(self, packet: Pixels, read: Reader) -> None:
        """One glDrawPixels, glCopyPixels or glBitmap."""
        for part in as_fragments(packet, self.size, read):
            self.fixed = None  # reading may have changed the driver's state
            self.textures.rectangle(part.image)
            self._draw([part.draw], part)

    def _accum(self) -> NDArray[np.float32]:
        """The accumulation buffer, made when it is first used: (height, width, 4), bottom row first."""
        if self.accumulation is None:
            width, height = self.size
            self.accumulation = np.zeros((height, width, 4), np.float32)
        return self.accumulation

    def _scissored(self, state: Snapshot) -> tuple[slice, slice]:
        """The pixels that glScissor lets through: rows, columns."""
        width, height = self.size
        test, x, y, wide, high = state.scissor
        if not test:
            return slice(0, height), slice(0, width)
        return slice(max(y, 0), max(min(y + high, height), 0)), slice(max(x, 0), max(min(x + wide, width), 0))

    def _accumulate(self, packet: Accum, read: Reader) -> None:
        """One glAccum (section 4.2.4); GL_RETURN is drawn like pixels, under scissor and colour mask alone."""
        buffer, part = self._accum(), self._scissored(packet.state)
        rows, columns = part
        width, height = columns.stop - columns.start, rows.stop - rows.start
        if width <= 0 or height <= 0:
            return
        if packet.operation in (gl.GL_ACCUM, gl.GL_LOAD):
            colors = read(columns.start, rows.start, width, height, "color") * np.float32(packet.value / 255.0)
            self.fixed = None
            buffer[part] = colors if packet.operation == gl.GL_LOAD else buffer[part] + colors
        elif packet.operation == gl.GL_MULT:
            buffer[part] *= np.float32(packet.value)
        elif packet.operation == gl.GL_ADD:
            buffer[part] += np.float32(packet.value)
        else:
            image = np.clip(buffer[part] * np.float32(packet.value), 0.0, 1.0)
            state = plain_state(packet.state, self.size, fragments=False)
            raster = RasterPosition(x=float(columns.start), y=float(rows.start))
            self._draw_pixels(Pixels("color", image, None, raster, PixelMode(), state), read)

    # ------------------------------------------------------------ primitives

    def _draw(self, draws: Sequence[Draw], pixels: Fragments | None = None) -> None:
        """pixels: what the fragments take from a rectangle of pixels."""
        objects, todo = plans(list(prepare(draws)), self.limit)
        if not objects:
            return  # every polygon is culled, or none is complete
        room = (len(objects) + self.limit) * ROW_SIZE  # a block always has `limit` rows, wherever it begins
        self._write("Transforms", transforms(objects), room)
        self._write("Materials", materials(objects), room)
        for part in todo:
            source = self._kept(part) if part.instances else self._streamed(part)
            for batch in part.batches:
                if batch.count:
                    self._draw_batch(batch, part, source, pixels)
            self.busy = True

    def _draw_batch(self, batch: Batch, part: Plan, source: Source, pixels: Fragments | None) -> None:
        state = batch.state
        objects = self.limit if part.several(batch) else 1
        key = draw_key(batch.draws[0], objects, pixels.kind if pixels else "", self.probing is not None)
        room = margin(state, batch.corners)
        self._apply(state, batch.corners, room)
        self._upload_lights(state.lighting)
        self._upload_raster(state, (*(pixels.origin if pixels else (0, 0)), self.probing or 0), room)
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
        array = source.vertex_array(key, program, "/i" if part.instances else "/v")
        mode = moderngl.TRIANGLES if key.wide_lines else PRIMITIVES[batch.corners]
        array.render(mode, vertices=batch.count, first=batch.start, instances=batch.objects if part.instances else 1)

    # ------------------------------------------------------------ programs and buffers

    def program(self, key: ProgramKey) -> moderngl.Program:
        if key not in self.programs:
            program = self.programs[key] = build(self.ctx, key)
            self.inputs[key] = [name for name in INPUTS if name in program]
        return self.programs[key]

    def _streamed(self, part: Plan) -> Source:
        """The buffers that are written anew for each plan."""
        source = self.stream
        source.write("rows", part.vertices.rows, self.busy)
        source.write("indices", part.indices, self.busy)
        if len(part.rows) or "object" not in source.buffers:
            source.write("object", part.rows, self.busy)
        source.columns.clear()
        return source

    def _kept(self, part: Plan) -> Source:
        """The buffers of a display list: written once."""
        source = self.static.get(part.vertices)
        if source is None:
            source = self.static[part.vertices] = Source(self.ctx)
            source.write("rows", part.vertices.rows, False)
            source.write("object", self.numbers, False)
        if source.indices is None or source.indices() is not part.indices:
            source.write("indices", part.indices, self.busy)
            source.indices = weakref.ref(part.indices)
        return source

    def _write(self, name: str, data: NDArray[Any], room: int = 0) -> None:
        """Replace a uniform buffer's content, with ``room`` bytes at least."""
        buffer, size = self.uniforms[name], max(room, data.nbytes)
        if self.busy or buffer.size < size:
            buffer.orphan(max(buffer.size, size))
        buffer.write(data)

    def _upload_lights(self, lighting: Lighting) -> None:
        groups = lighting.lights, lighting.ambient
        if groups != self.uploaded_lights:
            self._write("Lights", lights(lighting))
            self.uploaded_lights = groups

    def _upload_raster(self, state: Snapshot, origin: tuple[int, int, int], room: int) -> None:
        groups = (
            state.fog, state.transform, state.point, state.viewport, state.line, state.polygon_stipple,
            state.color_buffer.alpha_reference, origin, room,
        )  # fmt: skip
        if groups != self.uploaded_raster:
            self._write("Raster", raster(state, origin, room))
            self.uploaded_raster = groups

    def _upload_texturing(self, batch: Batch) -> None:
        """The units, with the texture matrices of all but the first, which agree in a batch."""
        groups = batch.state.texture.units, batch.draws[0].matrices[3:]
        if groups != self.uploaded_texturing:
            self._write("Texturing", texturing(*groups))
            self.uploaded_texturing = groups

    # ------------------------------------------------------------ state that the core profile kept

    def _apply(self, state: Snapshot, corners: int, room: int = 0) -> None:
        """Pass on what changed since the last draw; lines and points are never culled.  room: see ``raster``."""
        before, raw = self.fixed, self.raw
        if before is not None and before[0] is state and before[1:] == (corners, room):
            return
        old = before[0] if before else None
        self.fixed = (state, corners, room)
        if old is None:
            raw.glProvokingVertex(LAST_VERTEX_CONVENTION)
            raw.glEnable(PROGRAM_POINT_SIZE)
            raw.glDisable(TEXTURE_CUBE_MAP_SEAMLESS)  # in OpenGL 1.x the faces of a cube map know nothing of each other
        if before is None or (old.viewport, *before[1:]) != (state.viewport, corners, room):  # type: ignore[union-attr]
            x, y, width, height = state.viewport[:4]
            raw.glViewport(x - room, y - room, width + 2 * room, height + 2 * room)
            self._switch(
                DEPTH_CLAMP, corners == 2 and room > 0
            )  # shaders/line.glsl clips wide lines, with all their width
            raw.glDepthRange(*state.viewport[4:])
        if before is None or (old.polygon, before[1]) != (state.polygon, corners):  # type: ignore[union-attr]
            polygon = state.polygon
            self._switch(gl.GL_CULL_FACE, polygon.cull and corners == 3)
            self._switch(gl.GL_POLYGON_OFFSET_FILL, polygon.offset_fill and corners == 3)
            raw.glCullFace(polygon.cull_face)
            raw.glFrontFace(polygon.front_face)
            raw.glPolygonOffset(polygon.offset_factor, polygon.offset_units)
        if old is None or old.depth != state.depth:
            self._switch(gl.GL_DEPTH_TEST, state.depth.test)
            raw.glDepthFunc(state.depth.func)
            raw.glDepthMask(state.depth.mask)
        if old is None or old.scissor != state.scissor:
            self._switch(gl.GL_SCISSOR_TEST, state.scissor.test)
            raw.glScissor(*state.scissor[1:])
        if old is None or old.stencil != state.stencil:
            stencil = state.stencil
            self._switch(gl.GL_STENCIL_TEST, stencil.test)
            raw.glStencilFunc(stencil.func, stencil.reference, stencil.value_mask)
            raw.glStencilOp(stencil.fail, stencil.depth_fail, stencil.depth_pass)
            raw.glStencilMask(stencil.write_mask)
        if old is None or old.color_buffer != state.color_buffer:
            self._apply_color_buffer(state.color_buffer)
        if old is None or old.transform.clip_enabled != state.transform.clip_enabled:
            for number, enabled in enumerate(state.transform.clip_enabled):
                self._switch(gl.GL_CLIP_PLANE0 + number, enabled)  # the same value as GL_CLIP_DISTANCE0
        if old is None or old.multisample != state.multisample:
            multisample = state.multisample
            self._switch(gl.GL_MULTISAMPLE, multisample.enabled)
            self._switch(gl.GL_SAMPLE_ALPHA_TO_COVERAGE, multisample.alpha_to_coverage)
            self._switch(gl.GL_SAMPLE_ALPHA_TO_ONE, multisample.alpha_to_one)
            self._switch(gl.GL_SAMPLE_COVERAGE, multisample.coverage)
            raw.glSampleCoverage(multisample.coverage_value, multisample.coverage_invert)

    def _apply_color_buffer(self, color: ColorBuffer) -> None:
        raw = self.raw
        self._switch(gl.GL_DITHER, color.dither)
        raw.glColorMask(*(color.mask if color.draw_buffer != gl.GL_NONE else (False,) * 4))
        self._switch(gl.GL_BLEND, color.blend and not color.logic_op_enabled)
        raw.glBlendFuncSeparate(*color.blend_function)
        raw.glBlendEquation(color.blend_equation)
        raw.glBlendColor(*color.blend_color)
        self._switch(gl.GL_COLOR_LOGIC_OP, color.logic_op_enabled)
        raw.glLogicOp(color.logic_op)

    def _switch(self, cap: int, on: bool) -> None:
        (self.raw.glEnable if on else self.raw.glDisable)(cap)


# ---------------------------------------------------------------- rows of shaders/state.glsl


def transforms(objects: Sequence[Object]) -> NDArray[np.float32]:
    """struct Transform for each object: (n, 64) float32."""
    evaluate({matrix: None for thing in objects for matrix in thing.matrices})
    modelview = np.array([thing.matrices[0].value for thing in objects])
    projection = np.array([thing.matrices[1].value for thing in objects])
    rows = np.zeros((len(objects), ROW_SIZE // 4), np.float32)
    with np.errstate(all="ignore"):
        rows[:, 0:16] = multiply(projection, modelview).reshape(-1, 16)
    rows[:, 16:32] = modelview.reshape(-1, 16)
    rows[:, 44:60] = np.array([thing.matrices[2].value for thing in objects]).reshape(-1, 16)
    rows[:, 32:44].reshape(-1, 3, 4)[:, :, :3] = inverse_transpose(modelview)
    return rows


def materials(objects: Sequence[Object]) -> NDArray[np.float32]:
    """struct Material for each object: (n, 64) float32."""
    rows = np.zeros((len(objects), ROW_SIZE // 4), np.float32)
    packed: dict[int, list[float]] = {}
    table = []
    for thing in objects:
        material = thing.material
        if id(material) not in packed:
            packed[id(material)] = _faces(material)
        table.append(packed[id(material)])
    rows[:, :40] = table
    rows[:, 40:44] = [thing.color or (0.0, 0.0, 0.0, 0.0) for thing in objects]
    return rows


def _faces(material: Material) -> list[float]:
    values: list[float] = []
    for face in material:
        values += (*face.ambient, *face.diffuse, *face.specular, *face.emission, face.shininess, 0.0, 0.0, 0.0)
    return values


def raster(state: Snapshot, origin: tuple[int, int, int] = (0, 0, 0), room: int = 0) -> NDArray[np.float32]:
    """The block Raster of shaders/raster.glsl: (84,) float32.  origin: of a pixel rectangle, and a probe's number;
    room: see glsim.render.lines.margin."""
    fog, point, line, viewport = state.fog, state.point, state.line, state.viewport
    block = np.zeros(RASTER_SIZE // 4, np.float32)
    block[0:4] = fog.color
    block[4:8] = fog.density, fog.start, fog.end, state.color_buffer.alpha_reference
    block[8:32] = np.ravel(state.transform.clip_planes)
    block[32:36] = point.size, point.size_min, point.size_max, point.fade_threshold
    block[36:39] = point.distance_attenuation
    block[40:44] = viewport.x, viewport.y, max(viewport.width, 1), max(viewport.height, 1)
    block[44:48] = line_width(state), line.stipple_factor, line.stipple_pattern, room
    block[80:83] = origin
    block[48:80] = np.array(state.polygon_stipple.rows, np.uint32).view(np.float32)
    return block


def texturing(units: Sequence[TextureUnit], matrices: Sequence[Matrix]) -> NDArray[np.float32]:
    """The block Texturing: four struct Unit, (256,) float32.  matrices: of the units from 1 on."""
    block = np.zeros((TEXTURE_UNITS, ROW_SIZE // 4), np.float32)
    evaluate(dict.fromkeys(matrices))
    for number, unit in enumerate(units):
        row = block[number]
        row[0:4] = unit.environment_color
        row[4:6] = unit.combine.scale_rgb, unit.combine.scale_alpha
        row[8:24] = np.ravel([generator.object_plane for generator in unit.generators])
        row[24:40] = np.ravel([generator.eye_plane for generator in unit.generators])
        row[40:56] = (matrices[number - 1].get() if number and matrices else np.eye(4, dtype=np.float32)).ravel()
    return block.ravel()


def lights(lighting: Lighting) -> NDArray[np.float32]:
    """The block Lights: eight struct Light and scene_ambient, (256,) float32."""
    block = np.zeros(LIGHTS_SIZE // 4, np.float32)
    for k, light in enumerate(lighting.lights):
        block[24 * k : 24 * k + 24] = _light(light)
    block[192:196] = lighting.ambient
    return block


@lru_cache(maxsize=256)
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
