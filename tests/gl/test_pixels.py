"""Pixel rectangles where the driver is no witness: what they return, and what it gets wrong."""

from __future__ import annotations

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.gl import GLError
from tests.drawing import pixel_coordinates


def start() -> None:
    pixel_coordinates(0.0)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)


def test_drawn_pixels_come_back_as_they_were(screen: glsim.Offscreen) -> None:
    start()
    data = np.random.default_rng(0).integers(0, 256, (9, 7, 4), np.uint8)
    glRasterPos2i(11, 13)
    glDrawPixels(7, 9, GL_RGBA, GL_UNSIGNED_BYTE, data)
    assert np.frombuffer(glReadPixels(11, 13, 7, 9, GL_RGBA, GL_UNSIGNED_BYTE), np.uint8).tobytes() == data.tobytes()
    assert not screen.pixels()[:, :11].any()


@pytest.mark.parametrize(
    ("format", "expected"),
    [
        (GL_LUMINANCE, [0.9]), (GL_LUMINANCE_ALPHA, [0.9, 0.8]), (GL_RGB, [0.2, 0.3, 0.4]), (GL_ALPHA, [0.8]),
        (GL_BGRA, [0.4, 0.3, 0.2, 0.8]), (GL_GREEN, [0.3]),
    ],
)  # fmt: skip
def test_formats_that_are_read(screen: glsim.Offscreen, format: int, expected: list[float]) -> None:
    glClearColor(0.2, 0.3, 0.4, 0.8)
    glClear(GL_COLOR_BUFFER_BIT)
    assert np.ravel(glReadPixels(5, 5, 1, 1, format, GL_FLOAT)) == pytest.approx(expected, abs=0.006)


def test_packed_types_are_read(screen: glsim.Offscreen) -> None:
    glClearColor(1.0, 0.5, 0.0, 1.0)
    glClear(GL_COLOR_BUFFER_BIT)
    [[word]] = glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, outputType=None)
    assert (word >> 11, word >> 5 & 63, word & 31) == (31, 32, 0)


def test_reading_is_transferred(screen: glsim.Offscreen) -> None:
    glClearColor(0.4, 0.4, 0.4, 1.0)
    glClear(GL_COLOR_BUFFER_BIT)
    glPixelTransferf(GL_RED_SCALE, 2.0)
    glPixelTransferf(GL_GREEN_BIAS, -0.1)
    assert np.ravel(glReadPixels(0, 0, 1, 1, GL_RGB, GL_FLOAT)) == pytest.approx([0.8, 0.3, 0.4], abs=0.01)
    assert screen.pixels()[0, 0, 0] == 102, "the picture itself is not"


def test_reading_into_an_array_with_a_row_length(screen: glsim.Offscreen) -> None:
    glClearColor(1, 1, 1, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    memory = np.zeros((4, 10), np.uint8)
    glPixelStorei(GL_PACK_ROW_LENGTH, 10)
    glPixelStorei(GL_PACK_SKIP_PIXELS, 2)
    glPixelStorei(GL_PACK_SKIP_ROWS, 1)
    glPixelStorei(GL_PACK_ALIGNMENT, 1)
    assert glReadPixels(0, 0, 5, 2, GL_RED, GL_UNSIGNED_BYTE, memory) is memory
    expected = np.zeros((4, 10), np.uint8)
    expected[1:3, 2:7] = 255
    assert (memory == expected).all()


def test_pixel_maps_by_the_specification(screen: glsim.Offscreen) -> None:
    """Each component times the size less one, rounded (section 3.6.5)."""
    start()
    glPixelTransferi(GL_MAP_COLOR, 1)
    glPixelMapfv(GL_PIXEL_MAP_B_TO_B, 3, [0.25, 0.5, 1.0])
    glRasterPos2i(0, 0)
    blue = np.array([0, 63, 64, 191, 192, 255], np.uint8)
    glDrawPixels(6, 1, GL_BLUE, GL_UNSIGNED_BYTE, blue)
    glPixelTransferi(GL_MAP_COLOR, 0)
    found = np.frombuffer(glReadPixels(0, 0, 6, 1, GL_BLUE, GL_UNSIGNED_BYTE), np.uint8)
    assert found.tolist() == [64, 64, 128, 128, 255, 255]


def test_index_shift_and_offset(screen: glsim.Offscreen) -> None:
    start()
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 4, [0.0, 0.2, 0.4, 1.0])
    glPixelTransferi(GL_INDEX_SHIFT, -2)
    glPixelTransferi(GL_INDEX_OFFSET, 1)
    glRasterPos2i(0, 0)
    glDrawPixels(4, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, np.array([0, 4, 11, 15], np.uint8))
    found = np.frombuffer(glReadPixels(0, 0, 4, 1, GL_RED, GL_UNSIGNED_BYTE), np.uint8)
    assert found.tolist() == [51, 102, 255, 0]


def test_stencil_map(screen: glsim.Offscreen) -> None:
    start()
    glPixelMapfv(GL_PIXEL_MAP_S_TO_S, 4, [9.0, 7.0, 5.0, 3.0])
    glPixelTransferi(GL_MAP_STENCIL, 1)
    glRasterPos2i(0, 0)
    glDrawPixels(4, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, np.array([0, 1, 6, 255], np.uint8))
    glPixelTransferi(GL_MAP_STENCIL, 0)
    assert list(glReadPixels(0, 0, 4, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE)) == [9, 7, 5, 3]


def test_fogged_pixels(screen: glsim.Offscreen) -> None:
    """Fragments of pixel rectangles are fogged by the raster position's distance; Mesa takes 0 for bitmaps."""
    start()
    glEnable(GL_FOG)
    glFogi(GL_FOG_MODE, GL_LINEAR)
    glFogfv(GL_FOG_COLOR, [0, 1, 0, 1])
    glFogf(GL_FOG_END, 2.0)
    glColor3f(1, 0, 0)
    glRasterPos3f(4, 4, -0.5)
    glBitmap(8, 1, 0, 0, 0, 0, b"\xff")
    assert screen.pixels()[-5, 4, :3].tolist() == pytest.approx([191, 64, 0], abs=1)


def test_maps_come_back(screen: glsim.Offscreen) -> None:
    glPixelMapfv(GL_PIXEL_MAP_G_TO_G, 2, [0.25, 1.5])
    assert glGetPixelMapfv(GL_PIXEL_MAP_G_TO_G).tolist() == [0.25, 1.0]
    assert glGetPixelMapusv(GL_PIXEL_MAP_G_TO_G).tolist() == [16383, 65535]
    assert glGetIntegerv(GL_PIXEL_MAP_G_TO_G_SIZE) == 2


def test_the_pixel_mode_is_pushed_without_the_maps(screen: glsim.Offscreen) -> None:
    glPushAttrib(GL_PIXEL_MODE_BIT)
    glPixelZoom(3, 4)
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, [1.0, 0.0])
    glPopAttrib()
    assert (glGetFloatv(GL_ZOOM_X), glGetFloatv(GL_ZOOM_Y)) == (1.0, 1.0)
    assert glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R).tolist() == [1.0, 0.0]


def test_a_frame_with_pixels_can_be_drawn_again(screen: glsim.Offscreen) -> None:
    from glsim.play.capture import capture

    with capture() as frame:
        start()
        glColor3f(1, 0, 0)
        glRecti(0, 0, 20, 20)
        glRasterPos2i(40, 40)
        glCopyPixels(0, 0, 20, 20, GL_COLOR)
        glAccum(GL_LOAD, 0.5)
        glAccum(GL_RETURN, 1.0)
    first = screen.pixels()
    screen.reset()
    screen.execute(frame.packets)
    assert (screen.pixels() == first).all()
    assert first[-50, 50, 0] == 128


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: glDrawPixels(2, 2, GL_RGB, GL_UNSIGNED_BYTE, bytes(5)), "2 x 2 pixels of 3 components need 12 bytes"),
        (lambda: glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, bytes(8)), "needs format GL_RGB"),
        (lambda: glDrawPixels(2, 2, GL_RGB, GL_BITMAP, bytes(8)), "GL_COLOR_INDEX"),
        (lambda: glDrawPixels(-2, 2, GL_RGB, GL_FLOAT, bytes(8)), "width and height must be at least 0"),
        (lambda: glBitmap(16, 2, 0, 0, 0, 0, bytes(1)), "a bitmap of 16 x 2 pixels needs 4 bytes"),
        (lambda: glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 3, [0, 1, 2]), "a power of two"),
        (lambda: glPixelStorei(GL_UNPACK_ALIGNMENT, 3), "1, 2, 4 or 8"),
        (lambda: glReadBuffer(GL_AUX0), "no auxiliary buffers"),
        (lambda: glDrawBuffer(GL_RIGHT), "no stereo"),
        (lambda: glCopyPixels(0, 0, 1, 1, GL_RGB), "GL_COLOR, GL_DEPTH or GL_STENCIL"),
    ],
)
def test_bad_pixels(screen: glsim.Offscreen, call: object, sentence: str) -> None:
    with pytest.raises((GLError, ValueError), match=sentence):
        call()  # type: ignore[operator]


# ---------------------------------------------------------------- textures read back


def test_texture_images_come_back(screen: glsim.Offscreen) -> None:
    data = np.random.default_rng(1).integers(0, 256, (4, 8, 4), np.uint8)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, data)
    assert glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE) == data.tobytes()
    assert glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_FLOAT).shape == (8, 4, 3)
    assert glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == 8
    assert glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT) == GL_RGBA
    assert glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_RED_SIZE) == 8
    assert glGetTexLevelParameteriv(GL_TEXTURE_2D, 3, GL_TEXTURE_WIDTH) == 0


def test_a_luminance_texture_reads_as_red(screen: glsim.Offscreen) -> None:
    glTexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, bytes([10, 20]))
    assert list(glGetTexImage(GL_TEXTURE_1D, 0, GL_RGB, GL_UNSIGNED_BYTE)) == [10, 0, 0, 20, 0, 0]
    assert list(glGetTexImage(GL_TEXTURE_1D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE)) == [10, 20]


def test_proxies_answer_whether_an_image_could_be(screen: glsim.Offscreen) -> None:
    for width, expected in ((64, 64), (100000, 0)):
        glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, width, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, None)
        assert glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == expected


def test_a_border_is_dropped(screen: glsim.Offscreen) -> None:
    image = np.arange(6 * 6, dtype=np.uint8).reshape(6, 6)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 6, 6, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, image)
    assert glGetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE) == image[1:5, 1:5].tobytes()


def test_popping_keeps_images_and_restores_parameters(screen: glsim.Offscreen) -> None:
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, b"\x10")
    glPushAttrib(GL_TEXTURE_BIT)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, b"\x20")
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP)
    glPopAttrib()
    assert glGetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE) == b"\x20"
    assert glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S) == GL_REPEAT


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: glTexImage3D(GL_TEXTURE_2D, 0, 3, 2, 2, 2, 0, GL_RGB, GL_FLOAT, None), "must be GL_TEXTURE_3D"),
        (lambda: glTexImage2D(GL_TEXTURE_CUBE_MAP, 0, 3, 2, 2, 0, GL_RGB, GL_FLOAT, None), "a face of a cube map"),
        (
            lambda: glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, 3, 2, 4, 0, GL_RGB, GL_FLOAT, None),
            "square for the faces",
        ),
        (lambda: glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP), "GL_OBJECT_LINEAR"),
        (lambda: glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, 3), "1, 2 or 4"),
        (lambda: glActiveTexture(GL_TEXTURE0 + 9), "GL_TEXTURE0 to GL_TEXTURE3"),
        (lambda: glGetTexImage(GL_TEXTURE_2D, 5, GL_RGB, GL_FLOAT), "level 5 of the texture has no image"),
        (
            lambda: glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT, None),
            "a depth texture needs",
        ),
    ],
)
def test_bad_textures(screen: glsim.Offscreen, call: object, sentence: str) -> None:
    with pytest.raises((GLError, ValueError), match=sentence):
        call()  # type: ignore[operator]
