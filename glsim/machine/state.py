"""The state of the machine, grouped as glPushAttrib groups it, with the specification's initial values.

Each group is an immutable tuple.  A command replaces the group it changes, so a Draw that holds the groups of its time
needs no copy, and comparing two states is comparing tuples.  Colours are (red, green, blue, alpha), positions
(x, y, z, w); numbers are Python floats and are rounded to float32 when they go to the GPU or into matrix arithmetic.
Initial values: OpenGL 1.5 specification, tables 6.5 to 6.24.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from typing import NamedTuple

from glsim.machine.constants import (
    GL_AMBIENT_AND_DIFFUSE,
    GL_BACK,
    GL_BLINN_TORRANCE_GLSIM,
    GL_CCW,
    GL_CLAMP_NORMAL_GLSIM,
    GL_FRONT_AND_BACK,
    GL_LESS,
    GL_MODELVIEW,
    GL_SINGLE_COLOR,
    GL_SMOOTH,
)

Color = tuple[float, float, float, float]
BLACK: Color = (0.0, 0.0, 0.0, 1.0)
WHITE: Color = (1.0, 1.0, 1.0, 1.0)

MAX_LIGHTS = 8


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
    """One light source.  Position and spot direction are in eye space, as glLight found them."""

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


class Lighting(NamedTuple):
    """Group GL_LIGHTING_BIT, but for the material."""

    enabled: bool = False
    shade_model: int = GL_SMOOTH
    ambient: Color = (0.2, 0.2, 0.2, 1.0)
    local_viewer: bool = False
    two_side: bool = False
    color_control: int = GL_SINGLE_COLOR
    lobe: int = GL_BLINN_TORRANCE_GLSIM
    back_lighting: int = GL_CLAMP_NORMAL_GLSIM
    color_material: bool = False
    color_material_face: int = GL_FRONT_AND_BACK
    color_material_mode: int = GL_AMBIENT_AND_DIFFUSE
    light_enabled: tuple[bool, ...] = (False,) * MAX_LIGHTS
    lights: tuple[Light, ...] = (Light(diffuse=WHITE, specular=WHITE),) + (Light(),) * (MAX_LIGHTS - 1)


class Transform(NamedTuple):
    """Group GL_TRANSFORM_BIT."""

    matrix_mode: int = GL_MODELVIEW
    normalize: bool = False
    rescale_normal: bool = False


class Viewport(NamedTuple):
    """Group GL_VIEWPORT_BIT; in pixels, and the depth range in [0, 1]."""

    x: int = 0
    y: int = 0
    width: int = 0
    height: int = 0
    near: float = 0.0
    far: float = 1.0


class Polygon(NamedTuple):
    """Group GL_POLYGON_BIT."""

    cull: bool = False
    cull_face: int = GL_BACK
    front_face: int = GL_CCW


class Depth(NamedTuple):
    """Group GL_DEPTH_BUFFER_BIT."""

    test: bool = False
    func: int = GL_LESS
    mask: bool = True
    clear: float = 1.0


class ColorBuffer(NamedTuple):
    """Group GL_COLOR_BUFFER_BIT."""

    mask: tuple[bool, bool, bool, bool] = (True, True, True, True)
    clear: Color = (0.0, 0.0, 0.0, 0.0)
    dither: bool = True
    multisample: bool = True


class Snapshot(NamedTuple):
    """What a Draw or a Clear must know of the state: the groups of its time."""

    lighting: Lighting
    transform: Transform
    viewport: Viewport
    polygon: Polygon
    depth: Depth
    color_buffer: ColorBuffer


take_groups: Callable[[object], tuple[object, ...]] = attrgetter(*Snapshot._fields)
