"""Texture objects: immutable, so that a Draw keeps the texture as it was.

Texels are kept as red, green, blue, alpha in the form the base internal format gives them (OpenGL 1.5, table 3.20):
luminance (L, L, L, 1), intensity (I, I, I, I), alpha (0, 0, 0, A).
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from glsim.machine.constants import (
    GL_ALPHA,
    GL_ALPHA4,
    GL_ALPHA8,
    GL_ALPHA12,
    GL_ALPHA16,
    GL_INTENSITY,
    GL_INTENSITY4,
    GL_INTENSITY8,
    GL_INTENSITY12,
    GL_INTENSITY16,
    GL_LINEAR,
    GL_LUMINANCE,
    GL_LUMINANCE4,
    GL_LUMINANCE4_ALPHA4,
    GL_LUMINANCE6_ALPHA2,
    GL_LUMINANCE8,
    GL_LUMINANCE8_ALPHA8,
    GL_LUMINANCE12,
    GL_LUMINANCE12_ALPHA4,
    GL_LUMINANCE12_ALPHA12,
    GL_LUMINANCE16,
    GL_LUMINANCE16_ALPHA16,
    GL_LUMINANCE_ALPHA,
    GL_NEAREST,
    GL_NEAREST_MIPMAP_LINEAR,
    GL_R3_G3_B2,
    GL_REPEAT,
    GL_RGB,
    GL_RGB4,
    GL_RGB5,
    GL_RGB5_A1,
    GL_RGB8,
    GL_RGB10,
    GL_RGB10_A2,
    GL_RGB12,
    GL_RGB16,
    GL_RGBA,
    GL_RGBA2,
    GL_RGBA4,
    GL_RGBA8,
    GL_RGBA12,
    GL_RGBA16,
)

# internal format -> base internal format; 1 to 4 are OpenGL 1.0's numbers of components
BASE_FORMATS: dict[int, int] = {1: GL_LUMINANCE, 2: GL_LUMINANCE_ALPHA, 3: GL_RGB, 4: GL_RGBA}
for _base, _formats in (
    (GL_ALPHA, (GL_ALPHA, GL_ALPHA4, GL_ALPHA8, GL_ALPHA12, GL_ALPHA16)),
    (GL_LUMINANCE, (GL_LUMINANCE, GL_LUMINANCE4, GL_LUMINANCE8, GL_LUMINANCE12, GL_LUMINANCE16)),
    (GL_LUMINANCE_ALPHA, (
        GL_LUMINANCE_ALPHA, GL_LUMINANCE4_ALPHA4, GL_LUMINANCE6_ALPHA2, GL_LUMINANCE8_ALPHA8, GL_LUMINANCE12_ALPHA4,
        GL_LUMINANCE12_ALPHA12, GL_LUMINANCE16_ALPHA16,
    )),
    (GL_INTENSITY, (GL_INTENSITY, GL_INTENSITY4, GL_INTENSITY8, GL_INTENSITY12, GL_INTENSITY16)),
    (GL_RGB, (GL_RGB, GL_R3_G3_B2, GL_RGB4, GL_RGB5, GL_RGB8, GL_RGB10, GL_RGB12, GL_RGB16)),
    (GL_RGBA, (GL_RGBA, GL_RGBA2, GL_RGBA4, GL_RGB5_A1, GL_RGBA8, GL_RGB10_A2, GL_RGBA12, GL_RGBA16)),
):  # fmt: skip
    BASE_FORMATS.update(dict.fromkeys(_formats, _base))

MAX_TEXTURE_SIZE = 4096


@dataclass(frozen=True, eq=False)
class Image:
    """One level: texels (height, width, 4) uint8, and the format the program asked for."""

    texels: NDArray[np.uint8]
    internal_format: int


@dataclass(frozen=True)
class Sampler:
    """glTexParameter."""

    min_filter: int = GL_NEAREST_MIPMAP_LINEAR
    mag_filter: int = GL_LINEAR
    wrap_s: int = GL_REPEAT
    wrap_t: int = GL_REPEAT
    border_color: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    priority: float = 1.0
    generate_mipmap: bool = False


@dataclass(frozen=True, eq=False)
class Texture:
    """A texture object as it is at one time.  images: by level; dimensions: 1 or 2, 0 before the first bind."""

    dimensions: int = 0
    images: dict[int, Image] = field(default_factory=dict)
    sampler: Sampler = Sampler()

    @property
    def base_format(self) -> int:
        return BASE_FORMATS[self.images[0].internal_format]

    @property
    def mipmapped(self) -> bool:
        return self.sampler.min_filter not in (GL_NEAREST, GL_LINEAR)

    @property
    def complete(self) -> bool:
        """Whether it can be used: section 3.8.10."""
        if 0 not in self.images or 0 in self.images[0].texels.shape:
            return False
        if not self.mipmapped:
            return True
        height, width = self.images[0].texels.shape[:2]
        level = 0
        while (height, width) != (1, 1):
            level, height, width = level + 1, max(height // 2, 1), max(width // 2, 1)
            image = self.images.get(level)
            if image is None or image.texels.shape[:2] != (height, width):
                return False
            if BASE_FORMATS[image.internal_format] != self.base_format:
                return False
        return True


def mipmaps(base: Image) -> dict[int, Image]:
    """All levels below ``base`` by averaging 2 x 2 texels (section 3.8.8)."""
    levels = {0: base}
    texels = base.texels
    while texels.shape[:2] != (1, 1):
        height, width = texels.shape[:2]
        rows = texels[: height // 2 * 2].reshape(height // 2, 2, width, 4) if height > 1 else texels[:, None]
        summed = rows.astype(np.float64).mean(axis=1)
        height, width = summed.shape[:2]
        columns = summed[:, : width // 2 * 2].reshape(height, width // 2, 2, 4) if width > 1 else summed[:, :, None]
        texels = np.floor(columns.mean(axis=2) + 0.5).astype(np.uint8)
        levels[len(levels)] = Image(texels, base.internal_format)
    return levels
