"""GLU's images: mipmaps and scaling."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import *


def level(target: int, number: int, *size: int) -> Any:
    glPixelStorei(GL_PACK_ALIGNMENT, 1)
    texels = glGetTexImage(target, number, GL_RGB, GL_UNSIGNED_BYTE)
    return np.frombuffer(bytes(texels), np.uint8).reshape(*size, 3).astype(int)


def test_mipmaps_are_means(screen: glsim.Offscreen) -> None:
    image = np.random.default_rng(3).integers(0, 256, (16, 32, 3), np.uint8)
    assert gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 32, 16, GL_RGB, GL_UNSIGNED_BYTE, image) == 0
    assert (level(GL_TEXTURE_2D, 0, 16, 32) == image).all()
    for number in range(1, 5):
        n = 2**number
        means = image.reshape(16 // n, n, 32 // n, n, 3).mean(axis=(1, 3))
        assert np.abs(level(GL_TEXTURE_2D, number, 16 // n, 32 // n) - means).max() <= 1
    assert np.abs(level(GL_TEXTURE_2D, 5, 1, 1) - image.mean(axis=(0, 1))).max() <= 1


@pytest.mark.parametrize(("size", "power"), [(3, 4), (5, 4), (6, 8), (11, 8), (12, 16), (64, 64)])
def test_sizes_become_powers_of_two(size: int, power: int, screen: glsim.Offscreen) -> None:
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, size, 1, GL_RGB, GL_FLOAT, np.full((1, size, 3), 0.4, np.float32))
    assert glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == power
    assert (level(GL_TEXTURE_2D, 0, 1, power) == 102).all()


def test_a_scaled_image_keeps_its_mean_and_its_ramp(screen: glsim.Offscreen) -> None:
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    ramp = np.tile(np.linspace(0, 1, 12, dtype=np.float32)[:, None, None], (1, 7, 3))
    small = gluScaleImage(GL_RGB, 7, 12, GL_FLOAT, ramp, 7, 4, GL_FLOAT)
    assert np.allclose(small[:, 0, 0], ramp[:, 0, 0].reshape(4, 3).mean(axis=1))
    out = np.zeros((4, 7, 3), np.uint8)
    glPixelStorei(GL_PACK_ALIGNMENT, 1)
    assert gluScaleImage(GL_RGB, 7, 12, GL_FLOAT, ramp, 7, 4, GL_UNSIGNED_BYTE, out) == 0
    assert np.abs(out - small * 255).max() <= 0.51


def test_only_the_levels_asked_for_are_loaded(screen: glsim.Offscreen) -> None:
    image = np.full((8, 8, 3), 9, np.uint8)
    gluBuild2DMipmapLevels(GL_TEXTURE_2D, GL_RGB, 8, 8, GL_RGB, GL_UNSIGNED_BYTE, 1, 2, 3, image)
    widths = [int(glGetTexLevelParameteriv(GL_TEXTURE_2D, k, GL_TEXTURE_WIDTH)) for k in range(5)]
    assert widths == [0, 0, 4, 2, 0]


def test_image_errors_name_the_call(screen: glsim.Offscreen) -> None:
    image = np.zeros((8, 8, 3), np.uint8)
    with pytest.raises(GLUError, match=r"gluBuild2DMipmaps: format must be .*, not 77 \(invalid enumerant\)"):
        gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 8, 8, 77, GL_UNSIGNED_BYTE, image)
    with pytest.raises(GLUError, match=r"gluScaleImage: widthOut and heightOut must be at least 1"):
        gluScaleImage(GL_RGB, 8, 8, GL_UNSIGNED_BYTE, image, 0, 8, GL_UNSIGNED_BYTE)
