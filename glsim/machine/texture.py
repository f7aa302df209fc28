"""Texture objects: immutable, so that a Draw keeps the texture as it was.

Texels are kept as red, green, blue, alpha of 8 bits in the form the base internal format gives them (OpenGL 1.5, table
3.20): luminance (L, L, L, 1), intensity (I, I, I, I), alpha (0, 0, 0, A); depth textures as float32.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl

# internal format -> base internal format; 1 to 4 are OpenGL 1.0's numbers of components
BASE_FORMATS: dict[int, int] = {1: gl.GL_LUMINANCE, 2: gl.GL_LUMINANCE_ALPHA, 3: gl.GL_RGB, 4: gl.GL_RGBA}
for _base, _formats in (
    (gl.GL_ALPHA, (gl.GL_ALPHA, gl.GL_ALPHA4, gl.GL_ALPHA8, gl.GL_ALPHA12, gl.GL_ALPHA16)),
    (gl.GL_LUMINANCE, (gl.GL_LUMINANCE, gl.GL_LUMINANCE4, gl.GL_LUMINANCE8, gl.GL_LUMINANCE12, gl.GL_LUMINANCE16)),
    (gl.GL_LUMINANCE_ALPHA, (
        gl.GL_LUMINANCE_ALPHA, gl.GL_LUMINANCE4_ALPHA4, gl.GL_LUMINANCE6_ALPHA2, gl.GL_LUMINANCE8_ALPHA8,
        gl.GL_LUMINANCE12_ALPHA4,
        gl.GL_LUMINANCE12_ALPHA12, gl.GL_LUMINANCE16_ALPHA16,
    )),
    (gl.GL_INTENSITY, (gl.GL_INTENSITY, gl.GL_INTENSITY4, gl.GL_INTENSITY8, gl.GL_INTENSITY12, gl.GL_INTENSITY16)),
    (gl.GL_RGB, (gl.GL_RGB, gl.GL_R3_G3_B2, gl.GL_RGB4, gl.GL_RGB5, gl.GL_RGB8, gl.GL_RGB10, gl.GL_RGB12, gl.GL_RGB16)),
    (gl.GL_RGBA, (gl.GL_RGBA, gl.GL_RGBA2, gl.GL_RGBA4, gl.GL_RGB5_A1, gl.GL_RGBA8, gl.GL_RGB10_A2, gl.GL_RGBA12,
    gl.GL_RGBA16)),
):  # fmt: skip
    BASE_FORMATS.update(dict.fromkeys(_formats, _base))

BASE_FORMATS.update(dict.fromkeys(
    (gl.GL_DEPTH_COMPONENT, gl.GL_DEPTH_COMPONENT16, gl.GL_DEPTH_COMPONENT24, gl.GL_DEPTH_COMPONENT32),
    gl.GL_DEPTH_COMPONENT
))  # fmt: skip
BASE_FORMATS.update({  # generic compressed formats: a driver may choose not to compress, and glsim does not
    gl.GL_COMPRESSED_ALPHA: gl.GL_ALPHA, gl.GL_COMPRESSED_LUMINANCE: gl.GL_LUMINANCE,
    gl.GL_COMPRESSED_INTENSITY: gl.GL_INTENSITY,
    gl.GL_COMPRESSED_LUMINANCE_ALPHA: gl.GL_LUMINANCE_ALPHA, gl.GL_COMPRESSED_RGB: gl.GL_RGB,
    gl.GL_COMPRESSED_RGBA: gl.GL_RGBA,
})  # fmt: skip

MAX_TEXTURE_SIZE = 4096
MAX_3D_TEXTURE_SIZE = 512
CUBE = 4  # the kind of cube maps; 1, 2 and 3 are the dimensions of the others


@dataclass(frozen=True, eq=False)
class Image:
    """One level of one face: texels, and the format the program asked for.

    texels: (height, width, 4) uint8, with a depth in front if there are three dimensions; (height, width, 1) float32
    for a depth texture.
    """

    texels: NDArray[Any]
    internal_format: int

    @property
    def base_format(self) -> int:
        return BASE_FORMATS[self.internal_format]

    @property
    def size(self) -> tuple[int, ...]:
        """(height, width) or (depth, height, width)."""
        return self.texels.shape[:-1]


class Images:
    """All images of a texture: (face, level) -> Image; the face is 0 but for cube maps."""

    __slots__ = ("__weakref__", "by_level")

    def __init__(self, by_level: dict[tuple[int, int], Image] | None = None) -> None:
        self.by_level = by_level or {}

    def get(self, level: int, face: int = 0) -> Image | None:
        return self.by_level.get((face, level))


@dataclass(frozen=True)
class Sampler:
    """glTexParameter."""

    min_filter: int = gl.GL_NEAREST_MIPMAP_LINEAR
    mag_filter: int = gl.GL_LINEAR
    wrap_s: int = gl.GL_REPEAT
    wrap_t: int = gl.GL_REPEAT
    wrap_r: int = gl.GL_REPEAT
    border_color: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    priority: float = 1.0
    min_lod: float = -1000.0
    max_lod: float = 1000.0
    base_level: int = 0
    max_level: int = 1000
    lod_bias: float = 0.0
    depth_mode: int = gl.GL_LUMINANCE
    compare_mode: int = 0
    compare_func: int = gl.GL_LEQUAL
    generate_mipmap: bool = False


def in_base_format(rgba: NDArray[Any], base: int, one: float) -> NDArray[Any]:
    """Red, green, blue, alpha (..., 4) as texels of a base internal format have them; one: what stands for 1."""
    result = rgba.copy()
    if base in (gl.GL_LUMINANCE, gl.GL_LUMINANCE_ALPHA, gl.GL_INTENSITY):
        result[..., :3] = rgba[..., :1]
    if base == gl.GL_INTENSITY:
        result[..., 3] = rgba[..., 0]
    elif base in (gl.GL_LUMINANCE, gl.GL_RGB):
        result[..., 3] = one
    elif base == gl.GL_ALPHA:
        result[..., :3] = 0
    return result


NO_IMAGES = Images()


@dataclass(frozen=True, eq=False)
class Texture:
    """A texture object as it is at one time.  kind: 1, 2 or 3 dimensions, or CUBE."""

    kind: int
    images: Images = NO_IMAGES
    sampler: Sampler = Sampler()

    @property
    def faces(self) -> range:
        return range(6 if self.kind == CUBE else 1)

    @property
    def base(self) -> Image | None:
        return self.images.get(self.sampler.base_level)

    @property
    def is_depth(self) -> bool:
        return self.base is not None and self.base.base_format == gl.GL_DEPTH_COMPONENT

    @property
    def base_format(self) -> int:
        """The base internal format for the texture environment; of a depth texture GL_DEPTH_TEXTURE_MODE."""
        base = self.base
        assert base is not None
        return self.sampler.depth_mode if self.is_depth else base.base_format

    @property
    def border_color(self) -> NDArray[Any]:
        """The border's colour as texels have it, (4,): table 3.15."""
        assert self.base is not None
        return in_base_format(np.array(self.sampler.border_color), self.base.base_format, 1.0)

    @property
    def mipmapped(self) -> bool:
        return self.sampler.min_filter not in (gl.GL_NEAREST, gl.GL_LINEAR)

    @property
    def complete(self) -> bool:
        """Whether it can be used: section 3.8.10."""
        base, first = self.base, self.sampler.base_level
        if base is None or 0 in base.size or first > self.sampler.max_level:
            return False
        if self.kind == CUBE and base.size[0] != base.size[1]:
            return False
        last = min(first + max(base.size).bit_length() - 1, self.sampler.max_level) if self.mipmapped else first
        for face in self.faces:
            size = base.size
            for level in range(first, last + 1):
                image = self.images.get(level, face)
                if image is None or image.size != size or image.base_format != base.base_format:
                    return False
                size = tuple(max(length // 2, 1) for length in size)
        return True


def mipmaps(base: Image) -> list[Image]:
    """``base`` and all levels below it, by averaging 2 x 2 (x 2) texels (section 3.8.8)."""
    levels = [base]
    texels = base.texels.astype(np.float64)
    while max(texels.shape[:-1]) > 1:
        for axis, length in enumerate(texels.shape[:-1]):
            if length > 1:
                even = np.take(texels, range(0, length // 2 * 2, 2), axis)
                texels = (even + np.take(texels, range(1, length // 2 * 2, 2), axis)) / 2.0
        if base.texels.dtype == np.uint8:
            texels = np.floor(texels + 0.5)
        levels.append(Image(texels.astype(base.texels.dtype), base.internal_format))
    return levels
