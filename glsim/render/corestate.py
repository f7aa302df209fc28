"""The state that the core profile kept, from culling to blending: the driver gets it as the program set it."""

from __future__ import annotations

from glsim.machine import constants as gl
from glsim.machine.state import ColorBuffer, Multisample, Polygon, Snapshot, Stencil, Viewport
from glsim.render.gpu import Commands

LAST_VERTEX_CONVENTION = 0x8E4E
PROGRAM_POINT_SIZE, TEXTURE_CUBE_MAP_SEAMLESS, DEPTH_CLAMP = 0x8642, 0x884F, 0x864F


class CoreState:
    """Gives the driver what changed since the last draw.  Call ``forget`` when others may have changed its state."""

    def __init__(self, raw: Commands) -> None:
        self.raw = raw
        self.applied: tuple[Snapshot, int, int] | None = None  # what the driver has

    def forget(self) -> None:
        self.applied = None

    def apply(self, state: Snapshot, corners: int, margin: int = 0) -> None:
        """corners: of the primitives, 3 for polygons; margin: see lines.margin."""
        before = self.applied
        if before is not None and before[0] is state and before[1:] == (corners, margin):
            return
        self.applied = (state, corners, margin)
        if before is None:
            self._always()
        old = before[0] if before else None
        if before is None or (before[0].viewport, *before[1:]) != (state.viewport, corners, margin):
            self._viewport(state.viewport, corners, margin)
        if before is None or (before[0].polygon, before[1]) != (state.polygon, corners):
            self._polygon(state.polygon, corners)
        if old is None or old.depth != state.depth:
            self._switch(gl.GL_DEPTH_TEST, state.depth.test)
            self.raw.glDepthFunc(state.depth.func)
            self.raw.glDepthMask(state.depth.mask)
        if old is None or old.scissor != state.scissor:
            self._switch(gl.GL_SCISSOR_TEST, state.scissor.test)
            self.raw.glScissor(*state.scissor[1:])
        if old is None or old.stencil != state.stencil:
            self._stencil(state.stencil)
        if old is None or old.color_buffer != state.color_buffer:
            self._color_buffer(state.color_buffer)
        if old is None or old.transform.clip_enabled != state.transform.clip_enabled:
            for number, enabled in enumerate(state.transform.clip_enabled):
                self._switch(gl.GL_CLIP_PLANE0 + number, enabled)  # the same value as GL_CLIP_DISTANCE0
        if old is None or old.multisample != state.multisample:
            self._multisample(state.multisample)

    def _always(self) -> None:
        self.raw.glProvokingVertex(LAST_VERTEX_CONVENTION)
        self.raw.glEnable(PROGRAM_POINT_SIZE)
        self.raw.glDisable(
            TEXTURE_CUBE_MAP_SEAMLESS
        )  # in OpenGL 1.x the faces of a cube map know nothing of each other

    def _viewport(self, viewport: Viewport, corners: int, margin: int) -> None:
        x, y, width, height = viewport[:4]
        self.raw.glViewport(x - margin, y - margin, width + 2 * margin, height + 2 * margin)
        self._switch(
            DEPTH_CLAMP, corners == 2 and margin > 0
        )  # shaders/line.glsl clips wide lines, with all their width
        self.raw.glDepthRange(*viewport[4:])

    def _polygon(self, polygon: Polygon, corners: int) -> None:
        """Lines and points are never culled, nor moved by glPolygonOffset."""
        self._switch(gl.GL_CULL_FACE, polygon.cull and corners == 3)
        self._switch(gl.GL_POLYGON_OFFSET_FILL, polygon.offset_fill and corners == 3)
        self.raw.glCullFace(polygon.cull_face)
        self.raw.glFrontFace(polygon.front_face)
        self.raw.glPolygonOffset(polygon.offset_factor, polygon.offset_units)

    def _stencil(self, stencil: Stencil) -> None:
        self._switch(gl.GL_STENCIL_TEST, stencil.test)
        self.raw.glStencilFunc(stencil.func, stencil.reference, stencil.value_mask)
        self.raw.glStencilOp(stencil.fail, stencil.depth_fail, stencil.depth_pass)
        self.raw.glStencilMask(stencil.write_mask)

    def _color_buffer(self, color: ColorBuffer) -> None:
        raw = self.raw
        self._switch(gl.GL_DITHER, color.dither)
        raw.glColorMask(*(color.mask if color.draw_buffer != gl.GL_NONE else (False,) * 4))
        self._switch(gl.GL_BLEND, color.blend and not color.logic_op_enabled)
        raw.glBlendFuncSeparate(*color.blend_function)
        raw.glBlendEquation(color.blend_equation)
        raw.glBlendColor(*color.blend_color)
        self._switch(gl.GL_COLOR_LOGIC_OP, color.logic_op_enabled)
        raw.glLogicOp(color.logic_op)

    def _multisample(self, multisample: Multisample) -> None:
        self._switch(gl.GL_MULTISAMPLE, multisample.enabled)
        self._switch(gl.GL_SAMPLE_ALPHA_TO_COVERAGE, multisample.alpha_to_coverage)
        self._switch(gl.GL_SAMPLE_ALPHA_TO_ONE, multisample.alpha_to_one)
        self._switch(gl.GL_SAMPLE_COVERAGE, multisample.coverage)
        self.raw.glSampleCoverage(multisample.coverage_value, multisample.coverage_invert)

    def _switch(self, cap: int, on: bool) -> None:
        (self.raw.glEnable if on else self.raw.glDisable)(cap)
