"""Key -> GLSL: the key (key.py) is printed as constants in front of the sources in shaders/."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache

from glsim.files import data_folder
from glsim.machine import constants as gl
from glsim.machine.state import TEXTURE_UNITS, Combine
from glsim.machine.texture import CUBE
from glsim.render.key import PIXELS, LightKind, ProgramKey, UnitKind

ENUMS = {
    "FOG_OFF": 0, "FOG_LINEAR": int(gl.GL_LINEAR), "FOG_EXP": int(gl.GL_EXP), "FOG_EXP2": int(gl.GL_EXP2),
    **{repr(name): int(name) for name in (
        gl.GL_MODULATE, gl.GL_DECAL, gl.GL_BLEND, gl.GL_REPLACE, gl.GL_ADD, gl.GL_COMBINE, gl.GL_ALWAYS, gl.GL_NEVER,
        gl.GL_LESS, gl.GL_EQUAL,
        gl.GL_LEQUAL, gl.GL_GREATER, gl.GL_NOTEQUAL, gl.GL_GEQUAL, gl.GL_ADD_SIGNED, gl.GL_INTERPOLATE,
        gl.GL_SUBTRACT, gl.GL_DOT3_RGB,
        gl.GL_DOT3_RGBA, gl.GL_TEXTURE, gl.GL_TEXTURE0, gl.GL_CONSTANT, gl.GL_PRIMARY_COLOR, gl.GL_PREVIOUS,
        gl.GL_SRC_COLOR,
        gl.GL_ONE_MINUS_SRC_COLOR, gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA, gl.GL_OBJECT_LINEAR, gl.GL_EYE_LINEAR,
        gl.GL_SPHERE_MAP, gl.GL_REFLECTION_MAP, gl.GL_NORMAL_MAP,
    )},
}  # fmt: skip


def _glsl(value: bool | int) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def constants(key: ProgramKey) -> str:
    """The key as GLSL, to stand in front of the sources; shaders/README.md tells what each constant means."""
    lines = [f"#define SHADED {'flat' if key.flat else 'smooth'}", f"const int OBJECTS = {key.objects};"]
    lines.append(f"#define CLIPPING {int(any(key.clip_plane))}")
    lines.append(f"const bool MANY_OBJECTS = {_glsl(key.objects > 1)};")
    lines += [f"const int {name} = {value};" for name, value in ENUMS.items()]
    lines.append(f"const int FOG = {int(key.fog)};")
    lines.append(f"const int ALPHA_FUNC = {int(key.alpha_func)};")
    lines.append(f"const bool[6] CLIP_PLANE = bool[6]({', '.join(map(_glsl, key.clip_plane))});")
    for name in (
        "affine", "depth_offset", "smooth_lines", "lit_elsewhere",
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
    lines += [f"#define PIXELS_{name.upper() or 'NONE'} {number}" for name, number in PIXELS.items()]
    lines.append(f"#define PIXELS {key.pixels}")
    return "\n".join(lines + _unit_constants(key.units)) + "\n"


SAMPLERS = {1: "sampler2D", 2: "sampler2D", 3: "sampler3D", CUBE: "samplerCube"}
NO_UNIT = UnitKind(-1, 0, False, False, False, False, False, 0, None, (False,) * 3, (0,) * 4)


def _unit_constants(units: tuple[UnitKind, ...]) -> list[str]:
    """The texture units as GLSL: TEXTURE_0 to TEXTURE_3 for the preprocessor, and arrays by unit."""
    by_number = {unit.number: unit for unit in units}
    every = [by_number.get(number, NO_UNIT) for number in range(TEXTURE_UNITS)]
    lines = [f"#define TEXTURES {int(bool(units))}"]
    for number, unit in enumerate(every):
        lines.append(f"#define TEXTURE_{number} {int(unit is not NO_UNIT)}")
        lines.append(f"#define SAMPLER_{number} {'sampler2DShadow' if unit.compare else SAMPLERS.get(unit.kind, '')}")
    if not units:
        return lines
    combines = [unit.combine or Combine() for unit in every]
    arrays: list[tuple[str, str, list[bool] | list[int]]] = [
        ("bool", "TEXTURE_IS_1D", [unit.kind == 1 for unit in every]),
        ("bool", "TEXTURE_HAS_COLOR", [unit.has_color for unit in every]),
        ("bool", "TEXTURE_HAS_ALPHA", [unit.has_alpha for unit in every]),
        ("bool", "TEXTURE_IS_INTENSITY", [unit.is_intensity for unit in every]),
        ("bool", "TEXTURE_IS_DEPTH", [unit.is_depth for unit in every]),
        ("bool", "CLAMP", [flag for unit in every for flag in unit.clamp]),
        ("bool", "CLAMPS", [any(unit.clamp) for unit in every]),
        ("int", "TEXENV", [unit.environment for unit in every]),
        ("int", "TEXGEN", [mode for unit in every for mode in unit.generated]),
        ("int", "COMBINE_RGB", [combine.rgb for combine in combines]),
        ("int", "COMBINE_ALPHA", [combine.alpha for combine in combines]),
        ("int", "SOURCE_RGB", [source for combine in combines for source in combine.source_rgb]),
        ("int", "SOURCE_ALPHA", [source for combine in combines for source in combine.source_alpha]),
        ("int", "OPERAND_RGB", [operand for combine in combines for operand in combine.operand_rgb]),
        ("int", "OPERAND_ALPHA", [operand for combine in combines for operand in combine.operand_alpha]),
    ]
    for kind, name, values in arrays:
        size = f"{kind}[{len(values)}]"
        words = [_glsl(value) if kind == "bool" else str(int(value)) for value in values]
        lines.append(f"const {size} {name} = {size}({', '.join(words)});")
    return lines


INCLUDE = re.compile(r'^#include "([\w.]+)"$')
_replaced: dict[str, str] = {}  # files of shaders/ for which another text stands, and the text


@contextmanager
def shader_replaced(file: str, text: str) -> Iterator[None]:
    """Within the block, contexts that are opened compile ``text`` instead of a file of shaders/."""
    _replaced[file] = text
    expand.cache_clear()
    try:
        yield
    finally:
        del _replaced[file]
        expand.cache_clear()


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
        text = _replaced.get(name) or (data_folder("shaders") / name).read_text(encoding="utf-8")
        for position, line in enumerate(text.splitlines(), 1):
            include = INCLUDE.match(line)
            if not include:
                lines.append(line)
            elif include[1] not in files:
                lines += [*read(include[1]), f"#line {1000 * number + position + 1}"]
            else:
                lines.append("")
        return lines

    return "\n".join(read(name)) + "\n", ("constants", *files)


def root_files(key: ProgramKey) -> dict[str, str]:
    """By stage the file in shaders/ that includes all others."""
    return {"vertex": "main.vert", "fragment": "probe.frag" if key.probe else "main.frag"}


FRONT = "#version 330 core\n"
# OpenGL ES 3.0, which is WebGL2's, has GL_ES defined, and no precision by default
ES_FRONT = "#version 300 es\n" + "".join(
    f"precision highp {kind};\n"
    for kind in ("float", "int", "sampler2D", "sampler3D", "samplerCube", "sampler2DShadow")
)


def sources(key: ProgramKey, es: bool = False) -> dict[str, str]:
    """The exact GLSL of a key: {"vertex": ..., "fragment": ...}.  es: as a browser compiles it, in GLSL ES 3.00."""
    front = (ES_FRONT if es else FRONT) + constants(key)
    return {stage: front + expand(name)[0] for stage, name in root_files(key).items()}
