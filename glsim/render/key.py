"""State -> key: the part of the state that chooses code, never a value.

The sources in shaders/ are ordinary GLSL with ordinary ifs.  The key is printed in front of them as constants, and the
compiler folds away what cannot happen (programs.py).
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from glsim.machine import constants as gl
from glsim.machine.assembly import corners
from glsim.machine.frame import Draw
from glsim.machine.state import MAX_CLIP_PLANES, TRACKED, Combine, Light, Lighting, Snapshot, TextureUnit
from glsim.render.lines import widened

NOTHING_TRACKED = (False, False, False, False)
TRACKS: dict[int, tuple[bool, ...]] = {  # glColorMaterial's mode -> ambient, diffuse, specular, emission
    mode: tuple(name in tracked for name in ("ambient", "diffuse", "specular", "emission"))
    for mode, tracked in TRACKED.items()
}


class LightKind(NamedTuple):
    """What must be computed for one enabled light."""

    number: int
    positional: bool
    attenuated: bool
    spot: bool


class UnitKind(NamedTuple):
    """What must be computed for one texture unit."""

    number: int
    kind: int  # of texture: 1 to 3 dimensions or CUBE
    has_color: bool
    has_alpha: bool
    is_intensity: bool
    is_depth: bool
    compare: bool
    environment: int
    combine: Combine | None  # but for the scales, which are values
    clamp: tuple[bool, ...]  # GL_CLAMP in s, t, r
    generated: tuple[int, ...]  # mode of glTexGen for s, t, r, q, or 0


# what a fragment of a pixel rectangle takes from the rectangle
PIXELS = {"": 0, "color": 1, "depth": 2, "bitmap": 3}


class ProgramKey(NamedTuple):
    """Everything that chooses code.  Fields that do not matter under the present state keep their defaults."""

    flat: bool = False
    affine: bool = False  # values are interpolated linearly on the screen
    per_fragment: bool = False
    lighting: bool = False
    lights: tuple[LightKind, ...] = ()
    lobe_is_phong: bool = False
    flip_normal: bool = False
    local_viewer: bool = False
    two_side: bool = False
    separate_specular: bool = False
    normalize: bool = False
    rescale_normal: bool = False
    front_tracks: tuple[bool, ...] = NOTHING_TRACKED
    back_tracks: tuple[bool, ...] = NOTHING_TRACKED
    color_sum: bool = False
    fog: int = 0
    fog_coordinate: bool = False
    alpha_func: int = gl.GL_ALWAYS
    clip_plane: tuple[bool, ...] = (False,) * MAX_CLIP_PLANES
    polygon_stipple: bool = False
    line_stipple: bool = False
    point_smooth: bool = False
    units: tuple[UnitKind, ...] = ()  # the texture units that are in use
    # what is drawn decides these, not the state
    points: bool = False  # the primitives are points
    areas: bool = True  # the primitives are polygons
    wide_lines: bool = False  # the primitives are lines made of triangles
    has_w: bool = False  # some vertex has a w that is not 1
    object_color: bool = False  # all vertices have the colour of their object
    pixels: int = 0  # the fragments of a pixel rectangle: one of PIXELS
    depth_offset: bool = False  # each vertex says how far it is moved: glPolygonOffset for lines and points
    smooth_lines: bool = False  # wide lines with soft edges
    lit_elsewhere: bool = False  # each vertex says where the equation is evaluated: at a polygon's provoking vertex
    probe: bool = False  # fragments tell what they are made of
    objects: int = 1  # rows of transforms and materials that one draw can use


def draw_key(draw: Draw, objects: int = 1, pixels: str = "", probe: bool = False) -> ProgramKey:
    """The key of the program that draws ``draw``, which is one that a core profile can draw (outline.prepare).

    objects: rows of transforms and materials it can use; pixels: see PIXELS; probe: for an Inspector.
    """
    state, columns = draw.state, draw.block.columns
    wide = "line_corner" in columns and widened(state)
    return program_key(state, corners(draw.mode))._replace(
        wide_lines=wide,
        has_w="w" in columns,
        depth_offset="depth_offset" in columns,
        smooth_lines=wide and state.line.smooth,
        lit_elsewhere="lit_position" in columns,
        pixels=PIXELS[pixels],
        object_color=draw.color is not None,
        probe=probe,
        objects=objects,
    )


def program_key(state: Snapshot, corners: int = 3) -> ProgramKey:
    """The key of a state, for primitives with this many corners; states with the same key share a program.

    The fields that depend on the vertices keep their defaults: draw_key has them all.
    """
    color, fog = state.color_buffer, state.fog
    common = ProgramKey(
        flat=state.lighting.shade_model == gl.GL_FLAT,
        color_sum=fog.color_sum and not state.lighting.enabled,
        fog=fog.mode if fog.enabled else 0,
        fog_coordinate=fog.enabled and fog.coordinate_source == gl.GL_FOG_COORDINATE,
        alpha_func=color.alpha_func if color.alpha_test else gl.GL_ALWAYS,
        clip_plane=state.transform.clip_enabled,
        polygon_stipple=corners == 3 and state.polygon.stipple,
        line_stipple=corners == 2 and state.line.stipple,
        point_smooth=corners == 1 and state.point.smooth,
        points=corners == 1,
        areas=corners == 3,
    )
    if state.lighting.enabled or state.texture.in_use:  # only they need normals
        transform = state.transform
        common = common._replace(
            normalize=transform.normalize, rescale_normal=transform.rescale_normal and not transform.normalize
        )
    if state.texture.in_use:
        kinds = (unit_kind(k, unit) for k, unit in enumerate(state.texture.units))
        common = common._replace(units=tuple(kind for kind in kinds if kind is not None))
    key = _lit(common, state) if state.lighting.enabled else common
    if state.hints.perspective_correction == gl.GL_AFFINE_GLSIM and corners > 1:
        key = key._replace(affine=not key.flat or bool(key.units) or key.fog != 0)  # whether anything is interpolated
    return key


@lru_cache(maxsize=256)
def unit_kind(number: int, unit: TextureUnit) -> UnitKind | None:
    """What a texture unit asks for; None if it is not in use."""
    texture = unit.active
    if texture is None:
        return None
    base, sampler = texture.base_format, texture.sampler
    combine = unit.combine._replace(scale_rgb=1.0, scale_alpha=1.0) if unit.environment == gl.GL_COMBINE else None
    modes = zip(unit.generators, unit.generated, strict=True)
    return UnitKind(
        number=number,
        kind=texture.kind,
        has_color=base != gl.GL_ALPHA,
        has_alpha=base not in (gl.GL_LUMINANCE, gl.GL_RGB),
        is_intensity=base == gl.GL_INTENSITY,
        is_depth=texture.is_depth,
        compare=texture.is_depth and sampler.compare_mode != 0,
        environment=unit.environment,
        combine=combine,
        clamp=tuple(wrap == gl.GL_CLAMP for wrap in (sampler.wrap_s, sampler.wrap_t, sampler.wrap_r)),
        generated=tuple(generator.mode if enabled else 0 for generator, enabled in modes),
    )


def _lit(key: ProgramKey, state: Snapshot) -> ProgramKey:
    """The key with the fields that matter only while GL_LIGHTING is on."""
    lighting = state.lighting
    tracked = TRACKS[lighting.color_material_mode] if lighting.color_material else NOTHING_TRACKED
    front = tracked if lighting.color_material_face != gl.GL_BACK else NOTHING_TRACKED
    back = tracked if lighting.color_material_face != gl.GL_FRONT and lighting.two_side else NOTHING_TRACKED
    kinds = light_kinds(lighting)
    return key._replace(
        per_fragment=lighting.shade_model == gl.GL_PHONG_WIN,
        lighting=True,
        lights=kinds,
        lobe_is_phong=bool(kinds) and lighting.lobe == gl.GL_PHONG_LOBE_GLSIM,
        flip_normal=bool(kinds) and lighting.back_lighting == gl.GL_FLIP_NORMAL_GLSIM,
        local_viewer=bool(kinds) and lighting.local_viewer,
        two_side=lighting.two_side and key.areas,
        separate_specular=bool(kinds) and lighting.color_control == gl.GL_SEPARATE_SPECULAR_COLOR,
        front_tracks=front,
        back_tracks=back if key.areas else NOTHING_TRACKED,
    )


@lru_cache(maxsize=64)
def light_kinds(lighting: Lighting) -> tuple[LightKind, ...]:
    """One for each light that is on, in their order."""

    def kind(number: int, light: Light) -> LightKind:
        positional = light.position[3] != 0.0
        factors = (light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation)
        return LightKind(number, positional, positional and factors != (1.0, 0.0, 0.0), light.spot_cutoff != 180.0)

    return tuple(kind(k, light) for k, light in enumerate(lighting.lights) if lighting.light_enabled[k])
