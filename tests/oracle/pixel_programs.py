"""Pixel rectangles: glDrawPixels, glCopyPixels, the accumulation buffer."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from glsim.gl import *
from tests.drawing import pixel_coordinates
from tests.oracle.programs import PROGRAMS, program
from tests.oracle.texture_programs import filters, square, texels, upload


def start() -> None:
    """Window coordinates are object coordinates; a grey picture."""
    glClearColor(0.2, 0.25, 0.3, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)
    pixel_coordinates(0.0)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)


# ---------------------------------------------------------------- glDrawPixels

FORMATS = {
    "rgb": (GL_RGB, 3), "rgba": (GL_RGBA, 4), "bgr": (GL_BGR, 3), "bgra": (GL_BGRA, 4), "luminance": (GL_LUMINANCE, 1),
    "luminance_alpha": (GL_LUMINANCE_ALPHA, 2), "red": (GL_RED, 1), "green": (GL_GREEN, 1), "blue": (GL_BLUE, 1),
    "alpha": (GL_ALPHA, 1),
}  # fmt: skip
for _name, (_format, _components) in FORMATS.items():

    @partial(PROGRAMS.__setitem__, f"draw_pixels_{_name}")
    def _draw_pixels(format: int = _format, components: int = _components) -> None:
        start()
        glRasterPos2i(15, 20)
        glDrawPixels(40, 30, format, GL_UNSIGNED_BYTE, texels(40, 30, components))


for _type, _dtype in (
    (GL_BYTE, "i1"), (GL_UNSIGNED_SHORT, "u2"), (GL_SHORT, "i2"), (GL_UNSIGNED_INT, "u4"), (GL_INT, "i4"),
    (GL_FLOAT, "f4"),
):  # fmt: skip

    @partial(PROGRAMS.__setitem__, f"draw_pixels_of_type_{_type.name[3:].lower()}")
    def _typed(type: int = _type, dtype: str = _dtype) -> None:
        start()
        glRasterPos2i(15, 20)
        unit = np.linspace(-0.3, 1.2, 30 * 20 * 3).reshape(20, 30, 3)
        info = None if dtype == "f4" else np.iinfo(dtype)
        data = unit if info is None else np.clip(unit * info.max, info.min, info.max)
        glDrawPixels(30, 20, GL_RGB, type, data.astype(dtype))


for _zoom in ((2.0, 3.0), (0.57, 0.57), (-1.0, 1.0), (1.0, -2.0), (1.63, 0.57)):

    @partial(PROGRAMS.__setitem__, f"pixel_zoom_{_zoom[0]:g}_{_zoom[1]:g}")
    def _zoomed(zoom: tuple[float, float] = _zoom) -> None:
        start()
        glRasterPos2i(60, 60)
        glPixelZoom(*zoom)
        glDrawPixels(30, 20, GL_RGBA, GL_UNSIGNED_BYTE, texels(30, 20))
        glPixelZoom(1, 1)


@program
def draw_pixels_over_the_edge() -> None:
    start()
    glRasterPos2i(100, 110)
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, texels(60, 60))
    glRasterPos2i(0, 0)
    glBitmap(0, 0, 0, 0, -20, -10, None)
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, texels(60, 60))


@program
def draw_pixels_through_all_tests() -> None:
    start()
    glEnable(GL_SCISSOR_TEST)
    glScissor(20, 20, 60, 50)
    glEnable(GL_ALPHA_TEST)
    glAlphaFunc(GL_GREATER, 0.31)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE)
    glColorMask(1, 0, 1, 1)
    glRasterPos2i(10, 15)
    glDrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, texels(64, 64))


@program
def draw_pixels_behind() -> None:
    start()
    glEnable(GL_DEPTH_TEST)
    glColor3f(1, 0, 0)
    glBegin(GL_QUADS)
    for x, y in ((30, 30), (90, 30), (90, 90), (30, 90)):
        glVertex3f(x, y, 0)
    glEnd()
    for x, z in ((20, 0.5), (60, -0.5)):
        glRasterPos3f(x, 40, z)
        glDrawPixels(30, 20, GL_RGBA, GL_UNSIGNED_BYTE, texels(30, 20))


@program
def draw_pixels_textured() -> None:
    start()
    upload(texels())
    filters(GL_NEAREST, GL_NEAREST)
    glEnable(GL_TEXTURE_2D)
    glTexCoord2f(0.7, 0.2)
    glRasterPos3f(15, 20, 0.5)
    glDrawPixels(40, 30, GL_RGBA, GL_UNSIGNED_BYTE, texels(40, 30))


@program
def draw_pixels_in_a_list() -> None:
    start()
    data = texels(20, 20)
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 4)
    glNewList(1, GL_COMPILE)
    glDrawPixels(20, 16, GL_RGBA, GL_UNSIGNED_BYTE, data)
    glEndList()
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0)
    for x in (10, 50, 90):
        glRasterPos2i(x, x)
        glCallList(1)


@program
def draw_pixels_with_row_length_and_alignment() -> None:
    start()
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8)
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 25)
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 3)
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 2)
    rng = np.random.default_rng(5)
    glRasterPos2i(15, 20)
    glDrawPixels(20, 18, GL_RGB, GL_UNSIGNED_BYTE, rng.integers(0, 256, 80 * 22, np.uint8))


@program
def draw_pixels_swapped() -> None:
    start()
    glPixelStorei(GL_UNPACK_SWAP_BYTES, 1)
    data = (texels(20, 20).astype(np.uint16) * 257).byteswap()
    glRasterPos2i(15, 20)
    glDrawPixels(20, 20, GL_RGBA, GL_UNSIGNED_SHORT, data)


@program
def draw_pixels_transferred() -> None:
    start()
    for name, value in (("RED_SCALE", 0.5), ("RED_BIAS", 0.3), ("GREEN_SCALE", 1.7), ("BLUE_BIAS", -0.2)):
        glPixelTransferf(globals()["GL_" + name], value)
    glRasterPos2i(15, 20)
    glDrawPixels(40, 30, GL_RGBA, GL_UNSIGNED_BYTE, texels(40, 30))


@program
def pixel_maps_into_a_texture() -> None:
    """Not with glDrawPixels, where Mesa gives blue by none of the maps."""
    start()
    glPixelTransferi(GL_MAP_COLOR, 1)
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 4, [1.0, 0.6, 0.3, 0.0])
    glPixelMapfv(GL_PIXEL_MAP_G_TO_G, 8, [0.0, 0.5, 0.1, 0.6, 0.2, 0.7, 0.3, 1.0])
    glPixelMapfv(GL_PIXEL_MAP_B_TO_B, 2, [0.2, 1.0])
    glPixelMapfv(GL_PIXEL_MAP_A_TO_A, 2, [0.0, 1.0])
    upload(texels())
    glPixelTransferi(GL_MAP_COLOR, 0)
    filters(GL_NEAREST, GL_NEAREST)
    glEnable(GL_TEXTURE_2D)
    glTranslatef(64, 64, 0)
    square(size=60.0)


@program
def draw_pixels_of_colour_indices() -> None:
    start()
    for name, values in (
        ("R", [0.0, 1.0, 0.3, 0.8]), ("G", [0.2, 0.0, 0.9, 0.8]), ("B", [0.9, 0.1, 0.4, 0.2]), ("A", [1.0] * 4),
    ):  # fmt: skip
        glPixelMapfv(globals()[f"GL_PIXEL_MAP_I_TO_{name}"], 4, values)
    glRasterPos2i(15, 20)
    glDrawPixels(16, 16, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, np.arange(256, dtype=np.uint8))


@program
def draw_depths() -> None:
    start()
    glEnable(GL_DEPTH_TEST)
    glColorMask(0, 0, 0, 0)
    glRasterPos2i(20, 20)
    ramp = np.linspace(0, 1, 60 * 60, dtype=np.float32)
    glDepthFunc(GL_ALWAYS)
    glDrawPixels(60, 60, GL_DEPTH_COMPONENT, GL_FLOAT, ramp)
    glColorMask(1, 1, 1, 1)
    glDepthFunc(GL_LESS)
    glColor3f(0.3, 0.9, 0.5)
    glBegin(GL_QUADS)
    for x, y in ((0, 0), (110, 0), (110, 110), (0, 110)):
        glVertex3f(x, y, x / 200)
    glEnd()


@program
def draw_depths_in_the_raster_colour() -> None:
    start()
    glColor3f(0.2, 0.5, 0.9)
    glRasterPos2i(20, 20)
    glDrawPixels(60, 60, GL_DEPTH_COMPONENT, GL_FLOAT, np.full(3600, 0.5, np.float32))


@program
def draw_stencils() -> None:
    start()
    glRasterPos2i(20, 20)
    glStencilMask(0x3F)
    glDrawPixels(64, 64, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, np.arange(4096, dtype=np.uint16).astype(np.uint8))
    glEnable(GL_STENCIL_TEST)
    for k, value in enumerate((5, 17, 40)):
        glStencilFunc(GL_LEQUAL, value, 0xFF)
        glColor3f(k / 2, 1 - k / 2, 0.5)
        glRecti(30 * k, 0, 30 * k + 40, 128)


@program
def draw_with_no_colour_buffer() -> None:
    start()
    glDrawBuffer(GL_NONE)
    glEnable(GL_DEPTH_TEST)
    glBegin(GL_TRIANGLES)
    for x, y in ((20, 20), (100, 20), (60, 100)):
        glVertex3f(x, y, 0.5)
    glEnd()
    glDrawBuffer(GL_FRONT)
    glColor3f(1, 1, 0)
    glRecti(0, 0, 70, 128)


# ---------------------------------------------------------------- glCopyPixels


def scene() -> None:
    glBegin(GL_TRIANGLES)
    for color, x, y in (((1, 0, 0), 5, 5), ((0, 1, 0), 60, 10), ((0, 0, 1), 30, 60)):
        glColor3fv(color)
        glVertex3f(x, y, (x - 30) / 60)
    glEnd()


@program
def copy_pixels() -> None:
    start()
    scene()
    glRasterPos2i(64, 64)
    glCopyPixels(0, 0, 62, 62, GL_COLOR)


@program
def copy_pixels_zoomed() -> None:
    start()
    scene()
    glRasterPos2i(64, 30)
    glPixelZoom(1.5, 2)
    glCopyPixels(10, 5, 30, 40, GL_COLOR)
    glPixelZoom(1, 1)


@program
def copy_pixels_transferred() -> None:
    start()
    scene()
    glPixelTransferf(GL_RED_BIAS, 0.3)
    glPixelTransferf(GL_GREEN_SCALE, 0.5)
    glRasterPos2i(64, 64)
    glCopyPixels(0, 0, 62, 62, GL_COLOR)


@program
def copy_depths() -> None:
    start()
    glEnable(GL_DEPTH_TEST)
    scene()
    glDepthFunc(GL_ALWAYS)
    glColorMask(0, 0, 0, 0)
    glRasterPos2i(64, 64)
    glCopyPixels(0, 0, 62, 62, GL_DEPTH)
    glColorMask(1, 1, 1, 1)
    glDepthFunc(GL_GREATER)
    glColor3f(1, 1, 0)
    glBegin(GL_QUADS)
    for x, y in ((64, 64), (126, 64), (126, 126), (64, 126)):
        glVertex3f(x, y, 0.1)
    glEnd()


@program
def copy_stencils() -> None:
    start()
    glEnable(GL_STENCIL_TEST)
    glStencilFunc(GL_ALWAYS, 3, 0xFF)
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE)
    scene()
    glRasterPos2i(64, 64)
    glCopyPixels(0, 0, 62, 62, GL_STENCIL)
    glStencilFunc(GL_EQUAL, 3, 0xFF)
    glColor3f(1, 0, 1)
    glRecti(40, 40, 128, 128)


# ---------------------------------------------------------------- accumulation


ACCUMULATED: dict[str, Callable[[], None]] = {}  # only OSMesa has an accumulation buffer to compare with


@partial(ACCUMULATED.__setitem__, "accumulated")
def accumulated() -> None:
    for k in range(4):
        start()
        glTranslatef(8 * k, 5 * k, 0)
        scene()
        glAccum(GL_LOAD if k == 0 else GL_ACCUM, 0.25)
    glAccum(GL_RETURN, 1.0)


@partial(ACCUMULATED.__setitem__, "accumulated_and_changed")
def accumulated_and_changed() -> None:
    start()
    glClearAccum(0.1, 0.2, -0.3, 0.0)
    glClear(GL_ACCUM_BUFFER_BIT)
    scene()
    glAccum(GL_ACCUM, 0.7)
    glAccum(GL_MULT, 0.8)
    glAccum(GL_ADD, 0.1)
    glAccum(GL_RETURN, 1.2)


@partial(ACCUMULATED.__setitem__, "accumulated_in_a_part")
def accumulated_in_a_part() -> None:
    start()
    scene()
    glAccum(GL_LOAD, 1.0)
    glEnable(GL_SCISSOR_TEST)
    glScissor(20, 10, 60, 30)
    glColorMask(1, 0, 1, 1)
    glAccum(GL_RETURN, 0.5)
