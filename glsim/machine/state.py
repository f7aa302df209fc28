"""The state of the machine, grouped as glPushAttrib groups it, with the specification's initial values.

Each group is an immutable tuple.  A command replaces the group it changes, so a Draw that holds the groups of its time
needs no copy, and comparing two states is comparing tuples.  Colours are (red, green, blue, alpha), positions
(x, y, z, w); numbers are Python floats and are rounded to float32 when they go to the GPU or into matrix arithmetic.
Initial values: OpenGL 1.5 specification, tables 6.5 to 6.24.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from typing import Any, NamedTuple, TypeVar

from glsim.machine import constants as gl
from glsim.machine.texture import Texture

Color = tuple[float, float, float, float]
Tuple = TypeVar("Tuple", bound=tuple[Any, ...])
BLACK: Color = (0.0, 0.0, 0.0, 1.0)
WHITE: Color = (1.0, 1.0, 1.0, 1.0)

MAX_LIGHTS = 8
TEXTURE_UNITS = 4
MAX_CLIP_PLANES = 6


def with_item(values: Tuple, number: int, value: Any) -> Tuple:
    """A tuple or named tuple with another value at one place; three times as fast as ``_replace``."""
    return tuple.__new__(type(values), (*values[:number], value, *values[number + 1 :]))


class Face(NamedTuple):
    """Material of one side of a surface: the lecture's k_a, k_d, k_s and n, and emission."""

    ambient: Color = (0.2, 0.2, 0.2, 1.0)
    diffuse: Color = (0.8, 0.8, 0.8, 1.0)
    specular: Color = BLACK
    emission: Color = BLACK
    shininess: float = 0.0


class Material(NamedTuple):
    front: Face = Face()
    back: Face = Face()


class Light(NamedTuple):
    """One light source.  Position and spot direction are in eye coordinates: glLight transforms them when called."""

    ambient: Color = BLACK
    diffuse: Color = BLACK
    specular: Color = BLACK
    position: Color = (0.0, 0.0, 1.0, 0.0)
    spot_direction: tuple[float, float, float] = (0.0, 0.0, -1.0)
    spot_exponent: float = 0.0
    spot_cutoff: float = 180.0
    constant_attenuation: float = 1.0
    linear_attenuation: float = 0.0
    quadratic_attenuation: float = 0.0


# glColorMaterial's mode -> properties of a Face that follow the current colour (section 2.14.3)
TRACKED: dict[int, tuple[str, ...]] = {
    gl.GL_AMBIENT: ("ambient",),
    gl.GL_DIFFUSE: ("diffuse",),
    gl.GL_AMBIENT_AND_DIFFUSE: ("ambient", "diffuse"),
    gl.GL_SPECULAR: ("specular",),
    gl.GL_EMISSION: ("emission",),
}


class Lighting(NamedTuple):
    """Group GL_LIGHTING_BIT, but for the material."""

    enabled: bool = False
    shade_model: int = gl.GL_SMOOTH
    ambient: Color = (0.2, 0.2, 0.2, 1.0)
    local_viewer: bool = False
    two_side: bool = False
    color_control: int = gl.GL_SINGLE_COLOR
    lobe: int = gl.GL_BLINN_TORRANCE_GLSIM
    back_lighting: int = gl.GL_CLAMP_NORMAL_GLSIM
    color_material: bool = False
    color_material_face: int = gl.GL_FRONT_AND_BACK
    color_material_mode: int = gl.GL_AMBIENT_AND_DIFFUSE
    light_enabled: tuple[bool, ...] = (False,) * MAX_LIGHTS
    lights: tuple[Light, ...] = (Light(diffuse=WHITE, specular=WHITE),) + (Light(),) * (MAX_LIGHTS - 1)


class Transform(NamedTuple):
    """Group GL_TRANSFORM_BIT; clip planes are in eye space."""

    matrix_mode: int = gl.GL_MODELVIEW
    normalize: bool = False
    rescale_normal: bool = False
    clip_enabled: tuple[bool, ...] = (False,) * MAX_CLIP_PLANES
    clip_planes: tuple[Color, ...] = ((0.0, 0.0, 0.0, 0.0),) * MAX_CLIP_PLANES


class Viewport(NamedTuple):
    """Group GL_VIEWPORT_BIT; in pixels, and the depth range in [0, 1]."""

    x: int = 0
    y: int = 0
    width: int = 0
    height: int = 0
    near: float = 0.0
    far: float = 1.0


class Point(NamedTuple):
    """Group GL_POINT_BIT; sizes in pixels, distance_attenuation as 1 / sqrt(a + b d + c d^2)."""

    size: float = 1.0
    smooth: bool = False
    size_min: float = 0.0
    size_max: float = 255.0
    fade_threshold: float = 1.0
    distance_attenuation: tuple[float, float, float] = (1.0, 0.0, 0.0)


class Line(NamedTuple):
    """Group GL_LINE_BIT; width in pixels."""

    width: float = 1.0
    smooth: bool = False
    stipple: bool = False
    stipple_factor: int = 1
    stipple_pattern: int = 0xFFFF


class Polygon(NamedTuple):
    """Group GL_POLYGON_BIT."""

    cull: bool = False
    cull_face: int = gl.GL_BACK
    front_face: int = gl.GL_CCW
    front_mode: int = gl.GL_FILL
    back_mode: int = gl.GL_FILL
    smooth: bool = False
    stipple: bool = False
    offset_fill: bool = False
    offset_line: bool = False
    offset_point: bool = False
    offset_factor: float = 0.0
    offset_units: float = 0.0


class PolygonStipple(NamedTuple):
    """Group GL_POLYGON_STIPPLE_BIT: 32 rows, bottom first, the leftmost pixel in the highest bit."""

    rows: tuple[int, ...] = (0xFFFFFFFF,) * 32


class Combine(NamedTuple):
    """GL_COMBINE of a texture unit: the functions, the sources and operands of their arguments, and result scales."""

    rgb: int = gl.GL_MODULATE
    alpha: int = gl.GL_MODULATE
    source_rgb: tuple[int, int, int] = (gl.GL_TEXTURE, gl.GL_PREVIOUS, gl.GL_CONSTANT)
    source_alpha: tuple[int, int, int] = (gl.GL_TEXTURE, gl.GL_PREVIOUS, gl.GL_CONSTANT)
    operand_rgb: tuple[int, int, int] = (gl.GL_SRC_COLOR, gl.GL_SRC_COLOR, gl.GL_SRC_ALPHA)
    operand_alpha: tuple[int, int, int] = (gl.GL_SRC_ALPHA, gl.GL_SRC_ALPHA, gl.GL_SRC_ALPHA)
    scale_rgb: float = 1.0
    scale_alpha: float = 1.0


class TexGen(NamedTuple):
    """Generation of one texture coordinate.  The eye plane is in eye coordinates: glTexGen transforms it at once."""

    mode: int = gl.GL_EYE_LINEAR
    object_plane: Color = (0.0, 0.0, 0.0, 0.0)
    eye_plane: Color = (0.0, 0.0, 0.0, 0.0)


_S, _T, _NO_PLANE = (1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)


class TextureUnit(NamedTuple):
    """One texture unit.  Tuples of four go by target: 1D, 2D, 3D, cube map; or by coordinate: s, t, r, q."""

    enabled: tuple[bool, ...] = (False,) * 4
    names: tuple[int, ...] = (0,) * 4
    bound: tuple[Texture, ...] = tuple(map(Texture, range(1, 5)))
    environment: int = gl.GL_MODULATE
    environment_color: Color = (0.0, 0.0, 0.0, 0.0)
    lod_bias: float = 0.0
    combine: Combine = Combine()
    generated: tuple[bool, ...] = (False,) * 4
    generators: tuple[TexGen, ...] = (
        TexGen(gl.GL_EYE_LINEAR, _S, _S), TexGen(gl.GL_EYE_LINEAR, _T, _T), TexGen(), TexGen(),
    )  # fmt: skip

    @property
    def active(self) -> Texture | None:
        """The texture that is applied: the enabled one of most dimensions; None if it is off or not complete."""
        for texture, enabled in zip(reversed(self.bound), reversed(self.enabled), strict=True):
            if enabled:
                return texture if texture.complete else None
        return None

    @property
    def level_bias(self) -> float:
        """What is added to the level of detail: the active texture's bias and the unit's (section 3.8.8)."""
        texture = self.active
        return min(max((texture.sampler.lod_bias if texture else 0.0) + self.lod_bias, -15.0), 15.0)


class Texturing(NamedTuple):
    """Group GL_TEXTURE_BIT: all units, and the one that glActiveTexture chose."""

    units: tuple[TextureUnit, ...] = (TextureUnit(),) * TEXTURE_UNITS
    active_unit: int = 0

    @property
    def unit(self) -> TextureUnit:
        return self.units[self.active_unit]

    @property
    def in_use(self) -> bool:
        """Whether any unit may apply a texture."""
        return any(True in unit.enabled for unit in self.units)

    def with_unit(self, number: int, unit: TextureUnit) -> Texturing:
        return Texturing(with_item(self.units, number, unit), self.active_unit)


class Fog(NamedTuple):
    """Group GL_FOG_BIT."""

    enabled: bool = False
    color: Color = (0.0, 0.0, 0.0, 0.0)
    mode: int = gl.GL_EXP
    density: float = 1.0
    start: float = 0.0
    end: float = 1.0
    coordinate_source: int = gl.GL_FRAGMENT_DEPTH
    color_sum: bool = False
    color_index: float = 0.0


class Depth(NamedTuple):
    """Group GL_DEPTH_BUFFER_BIT."""

    test: bool = False
    func: int = gl.GL_LESS
    mask: bool = True
    clear: float = 1.0


class Stencil(NamedTuple):
    """Group GL_STENCIL_BUFFER_BIT."""

    test: bool = False
    func: int = gl.GL_ALWAYS
    reference: int = 0
    value_mask: int = 0xFFFFFFFF
    write_mask: int = 0xFFFFFFFF
    fail: int = gl.GL_KEEP
    depth_fail: int = gl.GL_KEEP
    depth_pass: int = gl.GL_KEEP
    clear: int = 0


class ColorBuffer(NamedTuple):
    """Group GL_COLOR_BUFFER_BIT."""

    mask: tuple[bool, bool, bool, bool] = (True, True, True, True)
    clear: Color = (0.0, 0.0, 0.0, 0.0)
    dither: bool = True
    alpha_test: bool = False
    alpha_func: int = gl.GL_ALWAYS
    alpha_reference: float = 0.0
    blend: bool = False
    blend_equation: int = gl.GL_FUNC_ADD
    blend_function: tuple[int, int, int, int] = (
        gl.GL_ONE,
        gl.GL_ZERO,
        gl.GL_ONE,
        gl.GL_ZERO,
    )  # rgb source, destination; alpha
    blend_color: Color = (0.0, 0.0, 0.0, 0.0)
    logic_op_enabled: bool = False
    logic_op: int = gl.GL_COPY
    index_logic_op: bool = False
    draw_buffer: int = gl.GL_FRONT


class Scissor(NamedTuple):
    """Group GL_SCISSOR_BIT; in pixels."""

    test: bool = False
    x: int = 0
    y: int = 0
    width: int = 0
    height: int = 0


class Multisample(NamedTuple):
    """Group GL_MULTISAMPLE_BIT."""

    enabled: bool = True
    alpha_to_coverage: bool = False
    alpha_to_one: bool = False
    coverage: bool = False
    coverage_value: float = 1.0
    coverage_invert: bool = False


class RasterPosition(NamedTuple):
    """Where glDrawPixels and glBitmap begin, and what their fragments carry (section 2.13).

    x, y in pixels, z in [0, 1], w of clip space; distance from the eye; texcoords: one for each unit.
    """

    valid: bool = True
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    w: float = 1.0
    distance: float = 0.0
    color: Color = WHITE
    secondary_color: Color = BLACK
    texcoords: tuple[Color, ...] = (BLACK,) * TEXTURE_UNITS


class Evaluators(NamedTuple):
    """Group GL_EVAL_BIT.

    enabled_1, enabled_2: for the nine maps from GL_MAP1_COLOR_4 and from GL_MAP2_COLOR_4 on, whether each is enabled.
    grid_1: (steps, first u, last u).  grid_2: the same for u, then for v.
    """

    enabled_1: tuple[bool, ...] = (False,) * 9
    enabled_2: tuple[bool, ...] = (False,) * 9
    auto_normal: bool = False
    grid_1: tuple[int, float, float] = (1, 0.0, 1.0)
    grid_2: tuple[int, float, float, int, float, float] = (1, 0.0, 1.0, 1, 0.0, 1.0)


class Hints(NamedTuple):
    """Group GL_HINT_BIT.  Only GL_AFFINE_GLSIM for perspective_correction changes what is drawn."""

    perspective_correction: int = gl.GL_DONT_CARE
    point_smooth: int = gl.GL_DONT_CARE
    line_smooth: int = gl.GL_DONT_CARE
    polygon_smooth: int = gl.GL_DONT_CARE
    fog: int = gl.GL_DONT_CARE
    generate_mipmap: int = gl.GL_DONT_CARE
    texture_compression: int = gl.GL_DONT_CARE
    phong: int = gl.GL_DONT_CARE


class Snapshot(NamedTuple):
    """The groups of state that a Draw or a Clear needs, with the values at the time of its call."""

    lighting: Lighting
    transform: Transform
    viewport: Viewport
    point: Point
    line: Line
    polygon: Polygon
    polygon_stipple: PolygonStipple
    texture: Texturing
    fog: Fog
    depth: Depth
    stencil: Stencil
    color_buffer: ColorBuffer
    scissor: Scissor
    multisample: Multisample
    hints: Hints


take_groups: Callable[[object], tuple[object, ...]] = attrgetter(*Snapshot._fields)
