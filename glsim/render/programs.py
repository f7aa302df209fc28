"""State -> key -> GLSL -> program.

The sources in shaders/ are ordinary GLSL with ordinary ifs.  The part of the state that chooses code, never a value,
is the key; it is printed in front of the source as constants, and the compiler folds away what cannot happen.
"""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from glsim.files import data_folder
from glsim.machine.constants import (
    GL_ADD,
    GL_ALPHA,
    GL_ALWAYS,
    GL_AMBIENT,
    GL_AMBIENT_AND_DIFFUSE,
    GL_BACK,
    GL_BLEND,
    GL_CLAMP,
    GL_DECAL,
    GL_DIFFUSE,
    GL_EMISSION,
    GL_EQUAL,
    GL_EXP,
    GL_EXP2,
    GL_FLAT,
    GL_FLIP_NORMAL_GLSIM,
    GL_FOG_COORDINATE,
    GL_FRONT,
    GL_GEQUAL,
    GL_GREATER,
    GL_INTENSITY,
    GL_LEQUAL,
    GL_LESS,
    GL_LINEAR,
    GL_LUMINANCE,
    GL_MODULATE,
    GL_NEVER,
    GL_NOTEQUAL,
    GL_PHONG_LOBE_GLSIM,
    GL_PHONG_WIN,
    GL_REPLACE,
    GL_RGB,
    GL_SEPARATE_SPECULAR_COLOR,
    GL_SPECULAR,
)
from glsim.machine.state import MAX_CLIP_PLANES, Light, Lighting, Snapshot
from glsim.machine.texture import Texture

if TYPE_CHECKING:
    import moderngl

NOTHING_TRACKED = (False, False, False, False)
TRACKED: dict[int, tuple[bool, ...]] = {  # glColorMaterial's mode -> ambient, diffuse, specular, emission
    GL_AMBIENT: (True, False, False, False),
    GL_DIFFUSE: (False, True, False, False),
    GL_AMBIENT_AND_DIFFUSE: (True, True, False, False),
    GL_SPECULAR: (False, False, True, False),
    GL_EMISSION: (False, False, False, True),
}


class LightKind(NamedTuple):
    """What must be computed for one enabled light."""

    number: int
    positional: bool
    attenuated: bool
    spot: bool


class ProgramKey(NamedTuple):
    """Everything that chooses code.  Fields that do not matter under the present state keep their defaults."""

    flat: bool = False
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
    alpha_func: int = GL_ALWAYS
    clip_plane: tuple[bool, ...] = (False,) * MAX_CLIP_PLANES
    polygon_stipple: bool = False
    line_stipple: bool = False
    point_smooth: bool = False
    texture: bool = False
    texture_is_1d: bool = False
    texture_has_color: bool = False
    texture_has_alpha: bool = False
    texture_is_intensity: bool = False
    texenv: int = 0
    clamp_s: bool = False
    clamp_t: bool = False
    # what is drawn decides these, not the state
    points: bool = False  # the primitives are points
    areas: bool = True  # the primitives are polygons
    wide_lines: bool = False  # the primitives are lines made of triangles
    has_w: bool = False  # some vertex has a w that is not 1
    object_color: bool = False  # all vertices have the colour of their object
    objects: int = 1  # rows of transforms and materials that one draw can use


def program_key(state: Snapshot, corners: int = 3) -> ProgramKey:
    """The key of a state, for primitives with this many corners; states with the same key share a program.

    The fields that depend on the vertices keep their defaults.
    """
    color, fog = state.color_buffer, state.fog
    common = ProgramKey(
        flat=state.lighting.shade_model == GL_FLAT,
        color_sum=fog.color_sum and not state.lighting.enabled,
        fog=fog.mode if fog.enabled else 0,
        fog_coordinate=fog.enabled and fog.coordinate_source == GL_FOG_COORDINATE,
        alpha_func=color.alpha_func if color.alpha_test else GL_ALWAYS,
        clip_plane=state.transform.clip_enabled,
        polygon_stipple=corners == 3 and state.polygon.stipple,
        line_stipple=corners == 2 and state.line.stipple,
        point_smooth=corners == 1 and state.point.smooth,
        points=corners == 1,
        areas=corners == 3,
    )
    if state.texture.active is not None:
        common = _textured(common, state.texture.active, state.texture.environment)
    return _lit(common, state) if state.lighting.enabled else common


def _textured(key: ProgramKey, texture: Texture, environment: int) -> ProgramKey:
    """The key with what the texture unit adds."""
    base = texture.base_format
    return key._replace(
        texture=True,
        texture_is_1d=texture.dimensions == 1,
        texture_has_color=base != GL_ALPHA,
        texture_has_alpha=base not in (GL_LUMINANCE, GL_RGB),
        texture_is_intensity=base == GL_INTENSITY,
        texenv=environment,
        clamp_s=texture.sampler.wrap_s == GL_CLAMP,
        clamp_t=texture.sampler.wrap_t == GL_CLAMP,
    )


def _lit(key: ProgramKey, state: Snapshot) -> ProgramKey:
    """The key with what lighting adds."""
    lighting = state.lighting
    tracked = TRACKED[lighting.color_material_mode] if lighting.color_material else NOTHING_TRACKED
    front = tracked if lighting.color_material_face != GL_BACK else NOTHING_TRACKED
    back = tracked if lighting.color_material_face != GL_FRONT and lighting.two_side else NOTHING_TRACKED
    kinds = light_kinds(lighting)
    return key._replace(
        per_fragment=lighting.shade_model == GL_PHONG_WIN,
        lighting=True,
        lights=kinds,
        lobe_is_phong=bool(kinds) and lighting.lobe == GL_PHONG_LOBE_GLSIM,
        flip_normal=bool(kinds) and lighting.back_lighting == GL_FLIP_NORMAL_GLSIM,
        local_viewer=bool(kinds) and lighting.local_viewer,
        two_side=lighting.two_side and key.areas,
        separate_specular=bool(kinds) and lighting.color_control == GL_SEPARATE_SPECULAR_COLOR,
        normalize=bool(kinds) and state.transform.normalize,
        rescale_normal=bool(kinds) and state.transform.rescale_normal and not state.transform.normalize,
        front_tracks=front,
        back_tracks=back if key.areas else NOTHING_TRACKED,
    )


@lru_cache(maxsize=64)
def light_kinds(lighting: Lighting) -> tuple[LightKind, ...]:
    def kind(number: int, light: Light) -> LightKind:
        positional = light.position[3] != 0.0
        factors = (light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation)
        return LightKind(number, positional, positional and factors != (1.0, 0.0, 0.0), light.spot_cutoff != 180.0)

    return tuple(kind(k, light) for k, light in enumerate(lighting.lights) if lighting.light_enabled[k])


ENUMS = {
    "FOG_OFF": 0, "FOG_LINEAR": int(GL_LINEAR), "FOG_EXP": int(GL_EXP), "FOG_EXP2": int(GL_EXP2),
    "GL_MODULATE": int(GL_MODULATE), "GL_DECAL": int(GL_DECAL), "GL_BLEND": int(GL_BLEND),
    "GL_REPLACE": int(GL_REPLACE), "GL_ADD": int(GL_ADD), "GL_NEVER": int(GL_NEVER), "GL_LESS": int(GL_LESS),
    "GL_EQUAL": int(GL_EQUAL), "GL_LEQUAL": int(GL_LEQUAL), "GL_GREATER": int(GL_GREATER),
    "GL_NOTEQUAL": int(GL_NOTEQUAL), "GL_GEQUAL": int(GL_GEQUAL),
}  # fmt: skip


def _glsl(value: bool | int) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def constants(key: ProgramKey) -> str:
    """The key as GLSL: what stands in front of the sources."""
    lines = [f"#define SHADED {'flat' if key.flat else 'smooth'}", f"const int OBJECTS = {key.objects};"]
    lines.append(f"#define CLIPPING {int(any(key.clip_plane))}")
    lines.append(f"const bool MANY_OBJECTS = {_glsl(key.objects > 1)};")
    lines += [f"const int {name} = {value};" for name, value in ENUMS.items()]
    lines.append(f"const int FOG = {int(key.fog)};")
    lines.append(f"const int TEXENV = {int(key.texenv)};")
    lines.append(f"const int ALPHA_FUNC = {int(key.alpha_func)};")
    lines.append(f"const bool[6] CLIP_PLANE = bool[6]({', '.join(map(_glsl, key.clip_plane))});")
    for name in (
        "texture", "texture_is_1d", "texture_has_color", "texture_has_alpha", "texture_is_intensity", "clamp_s",
        "clamp_t",
        "points", "areas", "wide_lines", "has_w", "object_color", "color_sum", "fog_coordinate", "polygon_stipple",
        "line_stipple", "point_smooth", "lighting", "per_fragment", "lobe_is_phong", "flip_normal", "local_viewer",
        "two_side",
        "separate_specular", "normalize", "rescale_normal",
    ):  # fmt: skip
        lines.append(f"const bool {name.upper()} = {_glsl(getattr(key, name))};")
    for name in ("front_tracks", "back_tracks"):
        values = ", ".join(map(_glsl, getattr(key, name)))
        lines.append(f"const bool[4] {name.upper()} = bool[4]({values});")
    lines.append(f"const int LIGHTS = {len(key.lights)};")
    kinds = key.lights or (LightKind(0, False, False, False),)  # an array cannot be empty
    for name, kind, column in (
        ("LIGHT_NUMBER", "int", [k.number for k in kinds]),
        ("LIGHT_IS_POSITIONAL", "bool", [k.positional for k in kinds]),
        ("LIGHT_IS_ATTENUATED", "bool", [k.attenuated for k in kinds]),
        ("LIGHT_IS_SPOT", "bool", [k.spot for k in kinds]),
    ):
        size = f"{kind}[{len(kinds)}]"
        lines.append(f"const {size} {name} = {size}({', '.join(map(_glsl, column))});")
    return "\n".join(lines) + "\n"


INCLUDE = re.compile(r'^#include "([\w.]+)"$')


@lru_cache(maxsize=16)
def expand(name: str) -> tuple[str, tuple[str, ...]]:
    """The text of shaders/NAME with its includes, each file once, and the names of the files in it.

    Line L of file number K is numbered 1000 K + L: drivers keep #line's line number in their messages, but not all
    of them its file number.
    """
    files: list[str] = []

    def read(name: str) -> list[str]:
        number = len(files) + 1  # 0 is the printed constants
        files.append(name)
        lines = [f"#line {1000 * number + 1}"]
        path = data_folder("shaders") / name
        for position, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            found = INCLUDE.match(line)
            if not found:
                lines.append(line)
            elif found[1] not in files:
                lines += [*read(found[1]), f"#line {1000 * number + position + 1}"]
            else:
                lines.append("")
        return lines

    return "\n".join(read(name)) + "\n", ("constants", *files)


def sources(key: ProgramKey) -> dict[str, str]:
    """The exact GLSL of a key: {"vertex": ..., "fragment": ...}."""
    front = "#version 330 core\n" + constants(key)
    return {"vertex": front + expand("main.vert")[0], "fragment": front + expand("main.frag")[0]}


BINDINGS = {"Transforms": 0, "Materials": 1, "Lights": 2, "Raster": 3}


def build(ctx: moderngl.Context, key: ProgramKey) -> moderngl.Program:
    """Compile and link.  Raises ShaderError that names the file in shaders/ and the line."""
    import moderngl

    text = sources(key)
    try:
        program = ctx.program(vertex_shader=text["vertex"], fragment_shader=text["fragment"])
    except moderngl.Error as error:
        raise ShaderError(_with_file_names(str(error))) from None
    for name, binding in BINDINGS.items():
        block = program.get(name, None)
        if block is not None:
            block.binding = binding  # type: ignore[union-attr]
    return program


class ShaderError(Exception):
    """A GLSL source in shaders/ does not compile."""


def _with_file_names(message: str) -> str:
    """'0:2007(5): error' or '0(2007) : error' -> 'state.glsl:7: error': #line's numbers become files again."""
    name = "main.frag" if "fragment_shader" in message or "fragment shader" in message.lower() else "main.vert"
    files = expand(name)[1]

    def replace(found: re.Match[str]) -> str:
        number, line = divmod(int(found[1]), 1000)
        return f"{files[number]}:{line}:" if number < len(files) else found[0]

    return re.sub(r"^\d+[:(](\d+)(?:\(\d+\)|\))?\s*:", replace, message, flags=re.MULTILINE)
