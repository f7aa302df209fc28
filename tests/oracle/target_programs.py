"""Cube maps, textures of three dimensions, depth textures, levels, borders, packed pixels."""

from __future__ import annotations

from functools import partial

import numpy as np

from glsim.gl import *
from tests.drawing import ball, camera
from tests.oracle.programs import PROGRAMS, program
from tests.oracle.texture_programs import filters, square, texels, upload
from tests.oracle.unit_programs import generate, textured_ball

# ---------------------------------------------------------------- cube maps


def cube_map(size: int = 8) -> None:
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    for face in range(6):
        image = texels(size, size, 3) // 2 + np.array([20 * face, 100 - 15 * face, 40], np.uint8)
        place = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face
        glTexImage2D(place, 0, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, image)
    for pname in (GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER):
        glTexParameteri(GL_TEXTURE_CUBE_MAP, pname, GL_LINEAR)
    for pname in (GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T):
        glTexParameteri(GL_TEXTURE_CUBE_MAP, pname, GL_CLAMP_TO_EDGE)


for _generator in (GL_REFLECTION_MAP, GL_NORMAL_MAP, GL_OBJECT_LINEAR):

    @partial(PROGRAMS.__setitem__, f"cube_map_{_generator.name[3:].lower()}")
    def _cube(generator: int = _generator) -> None:
        camera()
        cube_map()
        if generator == GL_OBJECT_LINEAR:
            glTexGenfv(GL_R, GL_OBJECT_PLANE, [0, 0, 1, 0])
        generate({GL_S: generator, GL_T: generator, GL_R: generator})
        textured_ball(GL_TEXTURE_CUBE_MAP)


@program
def cube_map_goes_before_two_dimensions() -> None:
    camera()
    upload(texels())
    cube_map()
    glEnable(GL_TEXTURE_2D)
    glEnable(GL_TEXTURE_CUBE_MAP)
    glTexCoord3f(1, 0.3, -0.2)
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glTexCoord3f(0.9 * x, y, 0.713)
        glVertex3f(x, y, 0)
    glEnd()


# ---------------------------------------------------------------- three dimensions


def volume(width: int = 4, height: int = 6, depth: int = 8) -> None:
    rng = np.random.default_rng(7)
    data = rng.integers(0, 256, (depth, height, width, 4), np.uint8)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, width, height, depth, 0, GL_RGBA, GL_UNSIGNED_BYTE, data)
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR)


def slice_of_volume() -> None:
    glBegin(GL_QUADS)
    for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
        glTexCoord3f(1.4 * s - 0.2, t, 0.2 + 0.5 * s + 0.3 * t)
        glVertex2f(1.8 * s - 0.9, 1.8 * t - 0.9)
    glEnd()


for _wrap in (GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT):

    @partial(PROGRAMS.__setitem__, f"volume_{_wrap.name[3:].lower()}")
    def _volume(wrap: int = _wrap) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        volume()
        for pname in (GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R):
            glTexParameteri(GL_TEXTURE_3D, pname, wrap)
        glEnable(GL_TEXTURE_3D)
        slice_of_volume()


@program
def volume_sub_image() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    volume()
    part = np.full((2, 3, 2, 4), 200, np.uint8)
    glTexSubImage3D(GL_TEXTURE_3D, 0, 1, 2, 3, 2, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE, part)
    glEnable(GL_TEXTURE_3D)
    slice_of_volume()


@program
def volume_with_skipped_images() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    rng = np.random.default_rng(8)
    data = rng.integers(0, 256, (6, 5, 4, 4), np.uint8)
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 5)
    glPixelStorei(GL_UNPACK_SKIP_IMAGES, 1)
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 1)
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, data)
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
    glEnable(GL_TEXTURE_3D)
    slice_of_volume()


# ---------------------------------------------------------------- depth textures


def depth_texture() -> None:
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    ramp = np.linspace(0, 1, 64, dtype=np.float32).reshape(8, 8)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 8, 8, 0, GL_DEPTH_COMPONENT, GL_FLOAT, ramp)
    filters(GL_NEAREST, GL_NEAREST)
    glEnable(GL_TEXTURE_2D)


for _mode in (GL_LUMINANCE, GL_INTENSITY, GL_ALPHA):

    @partial(PROGRAMS.__setitem__, f"depth_texture_{_mode.name[3:].lower()}")
    def _depth(mode: int = _mode) -> None:
        glClearColor(0.2, 0.3, 0.4, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        depth_texture()
        glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, mode)
        glColor4f(0.9, 0.5, 0.7, 0.8)
        square()


for _func in (GL_LEQUAL, GL_GEQUAL):

    @partial(PROGRAMS.__setitem__, f"depth_texture_compared_{_func.name[3:].lower()}")
    def _compared(func: int = _func) -> None:
        glClearColor(0.2, 0.3, 0.4, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        depth_texture()
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, func)
        glBegin(GL_QUADS)
        for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
            glTexCoord3f(s, t, 0.3 + 0.4 * s)
            glVertex2f(1.8 * s - 0.9, 1.8 * t - 0.9)
        glEnd()


@program
def shadow_map() -> None:
    """The depths of one view, copied, shade another: both passes of a shadow map."""
    glMatrixMode(GL_PROJECTION)
    glOrtho(-2, 2, -2, 2, -4, 4)
    glMatrixMode(GL_MODELVIEW)
    glEnable(GL_DEPTH_TEST)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    ball(mode=GL_TRIANGLES, radius=0.6)
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 128, 128, 0)
    filters(GL_NEAREST, GL_NEAREST)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    for k, coordinate in enumerate((GL_S, GL_T, GL_R)):
        plane = [0.0, 0.0, 0.0, 0.5 - (0.002 if k == 2 else 0)]
        plane[k] = 0.25 if k < 2 else -0.125
        glTexGenfv(coordinate, GL_EYE_PLANE, plane)
        generate({coordinate: GL_EYE_LINEAR})
    glRotatef(35, 1, 0, 0)
    glBegin(GL_QUADS)
    for x, y in ((-1.6, -1.6), (1.6, -1.6), (1.6, 1.6), (-1.6, 1.6)):
        glVertex3f(x, y, -1.2)
    glEnd()


# ---------------------------------------------------------------- levels, borders, packed pixels

PACKED = {
    GL_UNSIGNED_BYTE_3_3_2: (np.uint8, GL_RGB), GL_UNSIGNED_BYTE_2_3_3_REV: (np.uint8, GL_RGB),
    GL_UNSIGNED_SHORT_5_6_5: (np.uint16, GL_RGB), GL_UNSIGNED_SHORT_5_6_5_REV: (np.uint16, GL_RGB),
    GL_UNSIGNED_SHORT_4_4_4_4: (np.uint16, GL_RGBA), GL_UNSIGNED_SHORT_4_4_4_4_REV: (np.uint16, GL_BGRA),
    GL_UNSIGNED_SHORT_5_5_5_1: (np.uint16, GL_RGBA), GL_UNSIGNED_SHORT_1_5_5_5_REV: (np.uint16, GL_BGRA),
    GL_UNSIGNED_INT_8_8_8_8: (np.uint32, GL_RGBA), GL_UNSIGNED_INT_8_8_8_8_REV: (np.uint32, GL_BGRA),
    GL_UNSIGNED_INT_10_10_10_2: (np.uint32, GL_RGBA), GL_UNSIGNED_INT_2_10_10_10_REV: (np.uint32, GL_RGBA),
}  # fmt: skip
for _type, (_dtype, _format) in PACKED.items():

    @partial(PROGRAMS.__setitem__, f"packed_{_type.name[3:].lower()}")
    def _packed(type: int = _type, dtype: type = _dtype, format: int = _format) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        rng = np.random.default_rng(3)
        data = rng.integers(0, np.iinfo(dtype).max, (8, 8), dtype)
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, format, type, data.tobytes())
        filters(GL_NEAREST, GL_NEAREST)
        glEnable(GL_TEXTURE_2D)
        square()


def coloured_levels() -> None:
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    for level in range(6):
        size = 32 >> level
        color = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0), (255, 0, 255), (0, 255, 255)][level]
        image = np.tile(np.array(color, np.uint8), (size, size, 1))
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, image)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST)
    glEnable(GL_TEXTURE_2D)


for _pname, _value in (
    (GL_TEXTURE_BASE_LEVEL, 2), (GL_TEXTURE_MAX_LEVEL, 1), (GL_TEXTURE_MIN_LOD, 2.0), (GL_TEXTURE_MAX_LOD, 1.0),
    (GL_TEXTURE_LOD_BIAS, 1.5),
):  # fmt: skip

    @partial(PROGRAMS.__setitem__, f"levels_{_pname.name[11:].lower()}")
    def _levels(pname: int = _pname, value: float = _value) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        coloured_levels()
        glTexParameterf(GL_TEXTURE_2D, pname, value)
        for k in range(6):
            glLoadIdentity()
            glTranslatef(-0.6 + 0.6 * (k % 3), -0.5 + k // 3, 0)
            square(0, 0.9 * 2.0 ** (k - 1), 0.25)


@program
def levels_biased_by_the_unit() -> None:
    camera()
    coloured_levels()
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 2.0)
    square(0, 4)


@program
def colour_indices_as_a_texture() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 4, [0.0, 1.0, 0.3, 0.8])
    glPixelMapfv(GL_PIXEL_MAP_I_TO_G, 4, [0.2, 0.0, 0.9, 0.8])
    glPixelMapfv(GL_PIXEL_MAP_I_TO_B, 4, [0.9, 0.1, 0.4, 0.2])
    glPixelMapfv(GL_PIXEL_MAP_I_TO_A, 4, [1.0, 1.0, 0.5, 0.7])
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    data = (np.arange(64, dtype=np.uint8).reshape(8, 8) * 7) % 4
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, data)
    filters(GL_NEAREST, GL_NEAREST)
    glEnable(GL_TEXTURE_2D)
    square()


@program
def pixel_transfer_into_a_texture() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glPixelTransferf(GL_RED_SCALE, 0.5)
    glPixelTransferf(GL_GREEN_BIAS, 0.25)
    upload(texels())
    filters()
    glEnable(GL_TEXTURE_2D)
    square()


@program
def one_dimension_copied() -> None:
    glClearColor(0.1, 0.6, 0.3, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glBegin(GL_TRIANGLES)
    for color, x, y in (((1, 0, 0), -1, -1), ((0, 1, 0), 0, -1), ((0, 0, 1), -0.5, 0)):
        glColor3fv(color)
        glVertex2f(x, y)
    glEnd()
    glColor3f(1, 1, 1)
    glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 0, 10, 64, 0)
    glCopyTexSubImage1D(GL_TEXTURE_1D, 0, 5, 0, 30, 20)
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
    glEnable(GL_TEXTURE_1D)
    glTranslatef(0.3, 0.3, 0)
    square(size=0.6)
