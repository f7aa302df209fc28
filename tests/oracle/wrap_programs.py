"""Beyond the edges of textures: every way to wrap with every filter, in all dimensions; border colours."""

from __future__ import annotations

from functools import partial

import numpy as np

from glsim.gl import *
from tests.oracle.programs import PROGRAMS

# Where a texel ends is a matter of the last bit, so the coordinates keep edges of texels away from pixels' centres.
OFF = 0.013
COORDINATES = (GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R)
TARGETS = (GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D)


def levels(target: int) -> None:
    """A texture of 8 texels a side with all its levels, each with colours of its own."""
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    rng = np.random.default_rng(TARGETS.index(target))
    for level, n in enumerate((8, 4, 2, 1)):
        dimensions = TARGETS.index(target) + 1
        texels = rng.integers(40, 256, (n,) * dimensions + (3,), np.uint8)
        upload = (glTexImage1D, glTexImage2D, glTexImage3D)[dimensions - 1]
        upload(target, level, GL_RGB, *[n] * dimensions, 0, GL_RGB, GL_UNSIGNED_BYTE, texels)


def strip(place: int, low: float, high: float, left: float, right: float) -> None:
    """A third of the picture's height, with coordinates from low to high; r leaves the texture at the top."""
    bottom = -0.95 + 0.65 * place
    glBegin(GL_QUADS)
    for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
        glTexCoord3f(low + (high - low) * s, low + (high - low) * t, low * 0.3 + t)
        glVertex2f(left + (right - left) * s, bottom + 0.6 * t)
    glEnd()


def parameters(target: int, wrap: int, minify: int, magnify: int) -> None:
    for coordinate in COORDINATES:
        glTexParameteri(target, coordinate, wrap)
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify)
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify)
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, [1.0, 0.2, 0.6, 0.5])


for _wrap in (GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT, GL_REPEAT):
    for _minify, _magnify in (
        (GL_NEAREST, GL_NEAREST), (GL_LINEAR, GL_LINEAR), (GL_NEAREST, GL_LINEAR), (GL_LINEAR, GL_NEAREST),
        (GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST), (GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR),
        (GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR), (GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST),
    ):  # fmt: skip

        @partial(PROGRAMS.__setitem__, f"wrapped_{_wrap.name[3:]}_{_minify.name[3:]}_{_magnify.name[3:]}".lower())
        def _wrapped(wrap: int = _wrap, minify: int = _minify, magnify: int = _magnify) -> None:
            glClear(GL_COLOR_BUFFER_BIT)
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
            for place, target in enumerate(TARGETS):
                levels(target)
                parameters(target, wrap, minify, magnify)
                glEnable(target)
                strip(place, -1.4 + OFF, 2.3 + OFF, -0.95, 0.3)  # a texel takes more than a pixel
                strip(place, -7.4 + OFF, 8.7 + OFF, 0.35, 0.95)  # less
                glDisable(target)


BASE_FORMATS = (GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA)
for _format in BASE_FORMATS:

    @partial(PROGRAMS.__setitem__, f"border_color_{_format.name[3:]}".lower())
    def _border(format: int = _format) -> None:
        glClearColor(0.2, 0.4, 0.1, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
        texels = np.random.default_rng(5).integers(0, 256, (4, 4, 4), np.uint8)
        glTexImage2D(GL_TEXTURE_2D, 0, format, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels)
        glEnable(GL_TEXTURE_2D)
        glColor4f(0.9, 0.8, 0.7, 0.9)
        for place, (wrap, filter) in enumerate(
            ((GL_CLAMP, GL_LINEAR), (GL_CLAMP_TO_BORDER, GL_NEAREST), (GL_CLAMP_TO_BORDER, GL_LINEAR))
        ):
            parameters(GL_TEXTURE_2D, wrap, filter, filter)
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE)
            strip(place, -1.4 + OFF, 2.3 + OFF, -0.95, 0.0)
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
            strip(place, -1.4 + OFF, 2.3 + OFF, 0.05, 0.95)


for _compare in (GL_NONE, GL_COMPARE_R_TO_TEXTURE):
    for _mode in (GL_LUMINANCE, GL_INTENSITY, GL_ALPHA):

        @partial(PROGRAMS.__setitem__, f"border_of_depths_{int(_compare != GL_NONE)}_{_mode.name[3:]}".lower())
        def _depths(compare: int = _compare, mode: int = _mode) -> None:
            glClearColor(0.2, 0.4, 0.1, 1)
            glClear(GL_COLOR_BUFFER_BIT)
            glEnable(GL_BLEND)
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
            depths = np.random.default_rng(6).random((4, 4), np.float32)
            glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths)
            glEnable(GL_TEXTURE_2D)
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, compare)
            glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, mode)
            for place, wrap in enumerate((GL_CLAMP, GL_CLAMP_TO_BORDER, GL_CLAMP_TO_EDGE)):
                parameters(GL_TEXTURE_2D, wrap, GL_NEAREST, GL_NEAREST)
                glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, [0.7, 0.1, 0.2, 0.3])
                strip(place, -1.4 + OFF, 2.3 + OFF, -0.95, 0.95)
