"""The uniform blocks of shaders/: state -> the bytes that the GPU reads.

Each structure and block is a NumPy structured dtype that is read off the GLSL itself, so the names of its fields are
the members' and their places are those of the layout std140 (OpenGL 3.3 section 2.11.4):

    struct Face { vec4 k_a; ... float n; };     FACE["k_a"] is 4 floats at byte 0, FACE["n"] one float at byte 64
"""

from __future__ import annotations

import math
import re
import struct
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.files import data_folder
from glsim.machine import constants as gl
from glsim.machine.matrix import Matrix, evaluate, inverse_transpose, multiply
from glsim.machine.state import TEXTURE_UNITS, Face, Light, Lighting, Material, Snapshot, TextureUnit
from glsim.machine.texture import Texture
from glsim.render.batch import Object
from glsim.render.lines import line_width

Rows = NDArray[np.void]

# GLSL's types: how NumPy sees them, on what multiple of bytes they begin, how many bytes they fill
BASIC: dict[str, tuple[Any, int, int]] = {
    "float": (np.float32, 4, 4),
    "uint": (np.uint32, 4, 4),
    "vec2": ((np.float32, 2), 8, 8),
    "vec3": ((np.float32, 3), 16, 12),
    "vec4": ((np.float32, 4), 16, 16),
    "uvec4": ((np.uint32, 4), 16, 16),
    "mat3": ((np.float32, (3, 4)), 16, 48),  # three columns, each as long as a vec4
    "mat4": ((np.float32, (4, 4)), 16, 64),  # column by column
}
DECLARATION = re.compile(r"(?:struct|layout\(std140\) uniform)\s+(\w+)\s*\{([^}]*)\}")
MEMBER = re.compile(r"(\w+)\s+(\w+)(?:\[(\d+)\])?;")


def layouts(file: str) -> dict[str, np.dtype[np.void]]:
    """The structures and uniform blocks that a file in shaders/ declares; not those whose size is a constant's."""
    text = re.sub(r"//[^\n]*", "", (data_folder("shaders") / file).read_text(encoding="utf-8"))
    dtypes: dict[str, np.dtype[np.void]] = {}
    for name, body in DECLARATION.findall(text):
        if "[OBJECTS]" not in body:
            dtypes[name] = std140(MEMBER.findall(body), dtypes)
    return dtypes


def std140(members: Sequence[tuple[str, str, str]], structures: dict[str, np.dtype[np.void]]) -> np.dtype[np.void]:
    """The dtype of a structure with these members: (type, name, length of the array or "")."""
    names, formats, offsets, end = [], [], [], 0
    for kind, name, length in members:
        dtype, multiple, size = BASIC[kind] if kind in BASIC else (structures[kind], 16, structures[kind].itemsize)
        if length:  # each element of an array fills whole rows of 16 bytes
            assert size % 16 == 0, f"{name}: elements of {size} bytes would need padding"
            dtype, size = (np.dtype(dtype), int(length)), size * int(length)
        start = -(-end // multiple) * multiple
        names.append(name)
        formats.append(dtype)
        offsets.append(start)
        end = start + size
    return np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": -(-end // 16) * 16})


_state, _raster, _unit = (layouts(file) for file in ("state.glsl", "raster.glsl", "unit.glsl"))
TRANSFORM, MATERIAL = _state["Transform"], _state["Material"]  # both fill ROW_SIZE bytes
FACE_OF_MATERIAL, UNIT = _state["Face"], _unit["Unit"]
LIGHT, LIGHTS, RASTER, TEXTURING = _state["Light"], _state["Lights"], _raster["Raster"], _unit["Texturing"]
ROW_SIZE = 256

# members of struct Face and of struct Light -> fields of machine.state.Face, in the same order, and of Light
FACE = {"k_a": "ambient", "k_d": "diffuse", "k_s": "specular", "emission": "emission", "n": "shininess"}
INTENSITIES = {"I_a": "ambient", "I_d": "diffuse", "I_s": "specular"}
ATTENUATION = ("constant_attenuation", "linear_attenuation", "quadratic_attenuation")


def transforms(objects: Sequence[Object]) -> Rows:
    """struct Transform for each object: (n,) TRANSFORM."""
    evaluate({matrix: None for entry in objects for matrix in entry.matrices})
    modelview = np.array([entry.matrices[0].value for entry in objects])
    projection = np.array([entry.matrices[1].value for entry in objects])
    rows = np.zeros(len(objects), TRANSFORM)
    with np.errstate(all="ignore"):
        rows["modelview_projection"] = multiply(projection, modelview)
    rows["modelview"] = modelview
    rows["normal"][..., :3] = inverse_transpose(modelview)
    rows["texture"] = [entry.matrices[2].value for entry in objects]
    return rows


def materials(objects: Sequence[Object]) -> Rows:
    """struct Material for each object: (n,) MATERIAL."""
    number: dict[int, int] = {}  # of each different material
    different: list[Material] = []
    for entry in objects:
        if id(entry.material) not in number:
            number[id(entry.material)] = len(different)
            different.append(entry.material)
    table = np.zeros(len(different), MATERIAL)  # so that bytes between the members are always the same
    for side, member in enumerate(("front", "back")):
        table[member] = _face_rows([material[side] for material in different])
    if len(different) != len(objects):
        rows = table.view(f"V{MATERIAL.itemsize}")  # which are copied whole, unlike structures
        table = rows[[number[id(entry.material)] for entry in objects]].view(MATERIAL)
    table["color"] = [entry.color or (0.0, 0.0, 0.0, 0.0) for entry in objects]
    return table


_pack_face = struct.Struct(f"17f{FACE_OF_MATERIAL.itemsize - 4 * 17}x").pack  # its members are FACE's, in their order


def _face_rows(faces: Sequence[Face]) -> Rows:
    """struct Face for each: (n,) FACE_OF_MATERIAL.  NumPy takes five times as long to read nested tuples."""
    packed = {id(f): f for f in faces}
    rows = {number: _pack_face(*f[0], *f[1], *f[2], *f[3], f[4]) for number, f in packed.items()}
    return np.frombuffer(b"".join([rows[id(face)] for face in faces]), FACE_OF_MATERIAL)


def lights(lighting: Lighting) -> Rows:
    """The block Lights: () LIGHTS."""
    block = np.zeros((), LIGHTS)
    rows = block["lights"]
    for k, light in enumerate(lighting.lights):
        rows[k] = light_row(light)
    block["I_a_scene"] = lighting.ambient
    return block


@lru_cache(maxsize=256)
def light_row(light: Light) -> Rows:
    """struct Light: () LIGHT."""
    x, y, z, w = light.position
    position = (x / w, y / w, z / w) if w else _unit_vector((x, y, z))
    members = (
        (*position, w), light.ambient, light.diffuse, light.specular,
        _unit_vector(light.spot_direction), light.spot_exponent,
        light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation, cos_spot_cutoff(light),
    )  # fmt: skip
    return np.array(members, LIGHT)


def cos_spot_cutoff(light: Light) -> float:
    """The cosine of a light's cutoff angle; -1 for 180 degrees, where no direction is outside."""
    return -1.0 if light.spot_cutoff == 180.0 else math.cos(math.radians(light.spot_cutoff))


def _unit_vector(vector: tuple[float, float, float]) -> tuple[float, float, float]:
    x, y, z = vector
    length = math.sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length) if length > 0.0 else vector


def raster(state: Snapshot, origin: tuple[int, int] = (0, 0), probe: int = 0, margin: int = 0) -> Rows:
    """The block Raster: () RASTER.

    origin: lower left pixel of a pixel rectangle; probe: number of a draw, for an Inspector; margin: see lines.margin.
    """
    fog, point, line, viewport = state.fog, state.point, state.line, state.viewport
    block = np.zeros((), RASTER)
    block["fog_color"] = fog.color
    block["fog_density"], block["fog_start"], block["fog_end"] = fog.density, fog.start, fog.end
    block["alpha_reference"] = state.color_buffer.alpha_reference
    block["clip_planes"] = state.transform.clip_planes
    block["point_size"], block["point_size_min"], block["point_size_max"] = point.size, point.size_min, point.size_max
    block["point_fade_threshold"] = point.fade_threshold
    block["point_attenuation"] = point.distance_attenuation
    block["viewport"] = viewport.x, viewport.y, max(viewport.width, 1), max(viewport.height, 1)
    block["line_width"], block["viewport_margin"] = line_width(state), margin
    block["line_stipple_factor"], block["line_stipple_pattern"] = line.stipple_factor, line.stipple_pattern
    block["polygon_stipple"] = np.reshape(state.polygon_stipple.rows, (8, 4))
    block["rectangle_origin"], block["probe_number"] = origin, probe
    return block


BORDERS = (gl.GL_CLAMP, gl.GL_CLAMP_TO_BORDER)
LINEAR = (gl.GL_LINEAR, gl.GL_LINEAR_MIPMAP_NEAREST, gl.GL_LINEAR_MIPMAP_LINEAR)


@lru_cache(maxsize=256)
def _for_browsers(texture: Texture, level_bias: float) -> dict[str, Any]:
    """The members of a Unit that stand for what textures of OpenGL ES lack."""
    sampler = texture.sampler
    borders = [wrap in BORDERS for wrap in (sampler.wrap_s, sampler.wrap_t, sampler.wrap_r)]
    borders[texture.kind :] = [False] * len(borders[texture.kind :])
    border_color = texture.border_color
    if texture.is_depth and sampler.compare_mode:
        border_color[1] = float(sampler.compare_func)
    return {
        "lod_bias": level_bias,
        "magnified_is_linear": sampler.mag_filter == gl.GL_LINEAR,
        "border_color": border_color,
        "border": (*borders, sampler.min_filter in LINEAR),
    }


def texturing(units: Sequence[TextureUnit], matrices: Sequence[Matrix]) -> Rows:
    """The block Texturing: () TEXTURING.  matrices: of the units from 1 on."""
    block = np.zeros((), TEXTURING)
    evaluate(dict.fromkeys(matrices))
    rows = block["units"]
    rows["environment_color"] = [unit.environment_color for unit in units]
    rows["rgb_scale"] = [unit.combine.scale_rgb for unit in units]
    rows["alpha_scale"] = [unit.combine.scale_alpha for unit in units]
    for plane in ("object_plane", "eye_plane"):
        rows[plane] = [[getattr(generator, plane) for generator in unit.generators] for unit in units]
    rows["matrix"] = np.eye(4, dtype=np.float32)
    for number, unit in enumerate(units):
        if unit.active is not None:
            for name, value in _for_browsers(unit.active, unit.level_bias).items():
                rows[name][number] = value
    for number in range(1, TEXTURE_UNITS if matrices else 1):
        rows["matrix"][number] = matrices[number - 1].get()
    return block
