"""Transformation and lighting of vertices on the CPU, for the raster position, selection and feedback.

The same steps as in shaders/main.vert, in float64.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim import shading
from glsim.machine import constants as gl
from glsim.machine.frame import Draw
from glsim.machine.state import TRACKED, Face, Lighting, Material, TextureUnit, Viewport
from glsim.shading import Illumination, Surface, dot

Float = NDArray[np.float64]


class Stage(NamedTuple):
    """n vertices after transformation and lighting.

    eye, clip: eye and clip coordinates (n, 4).  point, normal: the point at which the lighting equation is evaluated,
    and the normal there, in eye coordinates (n, 3).  current: current colours (n, 4).  front, back: colours of the two
    sides (n, 4).  highlight: secondary colour of the front side (n, 3).  texcoords: an array (n, 4) per texture unit.
    """

    eye: Float
    clip: Float
    point: Float
    normal: Float
    current: Float
    front: Float
    back: Float
    highlight: Float
    texcoords: list[Float]


@np.errstate(all="ignore")  # NaN stays NaN, as on the GPU
def vertex_stage(draw: Draw, chosen: NDArray[np.uint32], units: int, colors: bool = True) -> Stage:
    """The vertices ``chosen`` (numbers in the draw's block) as the GPU would have them, with the texture coordinates of
    the first ``units`` units; without ``colors`` they are not lit.

    The arrays hold the transposes of the specification's matrices (machine/matrix.py), and points are rows:

        M = [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]   # the specification's: moves by 5 along x
        modelview = transpose(M)                                       # what Matrix.get() returns
        M (1, 2, 3, 1)^T              = (6, 2, 3, 1)^T                 # one point, as a column
        [[1, 2, 3, 1], ...] @ modelview = [[6, 2, 3, 1], ...]          # the same for n points, as rows
    """
    block, state = draw.block, draw.state
    modelview, projection, *textures = (matrix.get().astype(np.float64) for matrix in draw.matrices)
    P = np.ones((len(chosen), 4))
    P[:, :3] = block.rows[chosen, :3]
    if "w" in block.columns:
        P[:, 3] = block.column("w")[chosen, 0]
    color = np.asarray(block.rows[chosen, 6:10] if draw.color is None else [draw.color] * len(chosen), np.float64)
    eye = P @ modelview
    N = _normals(draw, block.rows[chosen, 3:6].astype(np.float64), modelview)
    lit = (
        block.column("lit_position")[chosen].astype(np.float64) @ modelview if "lit_position" in block.columns else eye
    )
    point = lit[:, :3] / lit[:, 3:]
    front = back = np.clip(color, 0.0, 1.0)
    highlight = np.zeros((len(chosen), 3))
    if state.lighting.enabled and colors:
        front, highlight = _lit(draw, chosen, gl.GL_FRONT, N, point, color)
        back = _lit(draw, chosen, gl.GL_BACK, -N, point, color)[0] if state.lighting.two_side else front
    elif state.fog.color_sum:
        highlight = block.column("secondary_color")[chosen, :3].astype(np.float64)
    texcoords = []
    for number in range(units):
        matrix = textures[number] if number < len(textures) else np.eye(4)
        given = block.column(f"texcoord{number}")[chosen].astype(np.float64)
        texcoords.append(_generated(state.texture.units[number], given, P, eye, N) @ matrix)
    return Stage(eye, eye @ projection, point, N, color, front, back, highlight, texcoords)


def _normals(draw: Draw, normals: Float, modelview: Float) -> Float:
    """Normals in eye space: the inverse transpose of the modelview, then glEnable(GL_NORMALIZE)."""
    try:
        inverse = np.linalg.inv(modelview[:3, :3].T)
    except np.linalg.LinAlgError:
        inverse = np.zeros((3, 3))
    N = normals @ inverse
    transform = draw.state.transform
    if transform.normalize:
        return shading.normalize(N)
    if transform.rescale_normal:
        length = np.linalg.norm(inverse[:, 2])
        return N / length if length else N
    return N


@np.errstate(all="ignore")
def window(clip: Float, viewport: Viewport) -> Float:
    """Clip coordinates (n, 4) -> window x, y in pixels, z in [0, 1], and the w they had (section 2.11.1)."""
    ndc = clip[:, :3] / clip[:, 3:]
    x, y, width, height, near, far = viewport
    scale = np.array([width / 2, height / 2, (far - near) / 2])
    return np.column_stack([ndc * scale + [x + width / 2, y + height / 2, (near + far) / 2], clip[:, 3]])


# ---------------------------------------------------------------- lighting


def _lit(draw: Draw, chosen: NDArray[np.uint32], side: int, N: Float, P: Float, color: Float) -> tuple[Float, Float]:
    """Colour (n, 4) and separate highlight (n, 3) of one side, clamped to [0, 1]."""
    lighting = draw.state.lighting
    terms, alpha = illumination(lighting, side, draw.materials_at(chosen), N, P, color)
    return shown(lighting, terms, alpha)


def surface(lighting: Lighting, side: int, materials: Sequence[Material], color: Float) -> tuple[Surface, Float]:
    """The material of one side at n points as a Surface, and its diffuse alpha (n, 1).

    color: current colours (n, 4); they replace the properties that glColorMaterial tracks.
    """
    different = {id(material): material for material in materials}
    faces = [m.front if side == gl.GL_FRONT else m.back for m in different.values()]
    numbers = {key: number for number, key in enumerate(different)}
    at = np.array([numbers[id(material)] for material in materials], int)
    columns = {name: np.array([getattr(face, name) for face in faces], np.float64)[at] for name in Face._fields}
    if lighting.color_material and lighting.color_material_face not in (
        gl.GL_BACK if side == gl.GL_FRONT else gl.GL_FRONT,
    ):
        for name in TRACKED[lighting.color_material_mode]:
            columns[name] = color
    k_a, k_d, k_s, emission = (columns[name][:, :3] for name in Face._fields[:4])
    return Surface(k_a, k_d, k_s, emission, columns["shininess"][:, None]), columns["diffuse"][:, 3:]


def illumination(
    lighting: Lighting, side: int, materials: Sequence[Material], N: Float, P: Float, color: Float
) -> tuple[Illumination, Float]:
    """All terms at points P (n, 3) with normals N (n, 3) in eye space and current colours (n, 4); alpha (n, 1)."""
    face, alpha = surface(lighting, side, materials, color)
    terms = shading.illuminate(
        face,
        [light for light, enabled in zip(lighting.lights, lighting.light_enabled, strict=True) if enabled],
        N,
        P,
        scene_ambient=lighting.ambient[:3],
        local_viewer=lighting.local_viewer,
        lobe="phong" if lighting.lobe == gl.GL_PHONG_LOBE_GLSIM else "blinn",
        flip=lighting.back_lighting == gl.GL_FLIP_NORMAL_GLSIM,
    )
    return terms, alpha


def shown(lighting: Lighting, terms: Illumination, alpha: Float) -> tuple[Float, Float]:
    """The sum as colour (n, 4) and, with GL_SEPARATE_SPECULAR_COLOR, highlight (n, 3), both clamped to [0, 1]."""
    color, highlight = terms.color, terms.highlight
    if lighting.color_control != gl.GL_SEPARATE_SPECULAR_COLOR:
        color, highlight = color + highlight, np.zeros_like(highlight)
    return shading.clamp(np.concatenate([color, alpha], axis=1)), shading.clamp(highlight)


# ---------------------------------------------------------------- texture coordinates


def _generated(unit: TextureUnit, given: Float, P: Float, eye: Float, N: Float) -> Float:
    """Texture coordinates (n, 4): ``given``, with the coordinates that glTexGen generates in their place."""
    result = given.copy()
    u = shading.normalize(eye[:, :3] / eye[:, 3:])
    R = u - 2.0 * N * dot(N, u)
    for k, (generator, enabled) in enumerate(zip(unit.generators, unit.generated, strict=True)):
        if not enabled:
            continue
        if generator.mode == gl.GL_OBJECT_LINEAR:
            result[:, k] = P @ np.array(generator.object_plane)
        elif generator.mode == gl.GL_EYE_LINEAR:
            result[:, k] = eye @ np.array(generator.eye_plane)
        elif generator.mode == gl.GL_SPHERE_MAP:
            m = 2.0 * np.sqrt(R[:, 0] ** 2 + R[:, 1] ** 2 + (R[:, 2] + 1.0) ** 2)
            result[:, k] = R[:, k] / m + 0.5
        else:
            result[:, k] = N[:, k] if generator.mode == gl.GL_NORMAL_MAP else R[:, k]
    return result
