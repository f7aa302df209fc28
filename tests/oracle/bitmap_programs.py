"""Bitmaps and the raster position."""

from __future__ import annotations

import numpy as np

from glsim.gl import *
from tests.drawing import SHINY, ball, camera, lamp, material
from tests.oracle.pixel_programs import start
from tests.oracle.programs import program
from tests.oracle.texture_programs import filters, texels, upload

LETTER = bytes([0x18, 0x3C, 0x66, 0x66, 0x7E, 0x66, 0x66, 0x00, 0xFF, 0x81])  # an A over a bar, 8 x 10


def letters(number: int = 3) -> None:
    for _ in range(number):
        glBitmap(8, 10, 1.0, 2.0, 9.0, 0.5, LETTER)


# ---------------------------------------------------------------- bitmaps


@program
def bitmap() -> None:
    start()
    glColor3f(1, 0.8, 0.2)
    glRasterPos2i(20, 30)
    letters(6)


@program
def bitmap_takes_the_colour_of_the_raster_position() -> None:
    start()
    glColor3f(1, 0, 0)
    glRasterPos2f(20.4, 60.7)
    glColor3f(0, 1, 0)
    letters()
    glRasterPos2f(20.4, 30.7)
    letters()


@program
def bitmap_lit() -> None:
    start()
    lamp(position=(0.3, 0.2, 1.0, 0.0))
    material(**SHINY)
    glNormal3f(0.3, 0.1, 0.9)
    glRasterPos3f(40, 50, -0.2)
    glDisable(GL_LIGHTING)
    letters()


@program
def bitmap_clipped_position_draws_nothing() -> None:
    start()
    glColor3f(1, 1, 0)
    glRasterPos2f(-1, 30)
    letters()
    glRasterPos2f(0, 60)
    letters()
    glBitmap(0, 0, 0, 0, -30, 10, None)
    letters(5)


@program
def bitmap_behind() -> None:
    camera()
    lamp()
    material(**SHINY)
    ball(mode=GL_TRIANGLES)
    glDisable(GL_LIGHTING)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    for z in (-1.5, -0.5, 1.2):
        glRasterPos3f(-0.3 + z / 9, z / 5, z)
        letters()


@program
def bitmap_with_skips() -> None:
    start()
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 24)
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5)
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 1)
    glPixelStorei(GL_UNPACK_LSB_FIRST, 1)
    glRasterPos2i(10, 10)
    rng = np.random.default_rng(1)
    glBitmap(16, 12, 0, 0, 0, 0, rng.integers(0, 256, 24 // 8 * 14, np.uint8).tobytes())


@program
def bitmaps_in_lists() -> None:
    """How GLUT and books draw text: a list for each letter, called by a string."""
    start()
    glNewList(100 + ord("A"), GL_COMPILE)
    letters(1)
    glEndList()
    glNewList(100 + ord("B"), GL_COMPILE)
    glBitmap(8, 8, 0, 0, 10, 0, bytes([0xFF, 0x81, 0xBD, 0xA5, 0xA5, 0xBD, 0x81, 0xFF]))
    glEndList()
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4)  # the lists remember what it was
    glColor3f(0.5, 1, 0.5)
    glRasterPos2i(8, 40)
    glPushAttrib(GL_LIST_BIT)
    glListBase(100)
    glCallLists(6, GL_UNSIGNED_BYTE, b"ABBAAB")
    glPopAttrib()


@program
def bitmap_blended() -> None:
    start()
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    glColor4f(1, 0.5, 0.1, 0.4)
    glRasterPos2i(30, 30)
    for _ in range(4):
        glBitmap(8, 10, 0, 0, 9.0, 3.0, LETTER)


@program
def bitmap_textured() -> None:
    start()
    upload(texels())
    filters(GL_NEAREST, GL_NEAREST)
    glEnable(GL_TEXTURE_2D)
    glTexCoord2f(0.4, 0.3)
    glRasterPos2i(10, 50)
    letters(2)


@program
def window_position() -> None:
    start()
    camera()
    glColor3f(0.9, 0.4, 0.8)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glWindowPos2i(50, 60)
    letters()
    glWindowPos3f(20.5, 20.5, 0.5)
    letters()


@program
def raster_position_is_popped() -> None:
    start()
    glColor3f(1, 0.5, 0)
    glRasterPos2i(10, 20)
    glPushAttrib(GL_CURRENT_BIT)
    glColor3f(0, 0.5, 1)
    glRasterPos2i(10, 60)
    letters()
    glPopAttrib()
    letters()
