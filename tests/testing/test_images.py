"""Any picture as RGBA: what is taken, and the sentences for what is not."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import moderngl
import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.gl import *
from glsim.images import on_paper, rgba

RED = [255, 0, 0, 255]


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (np.full((2, 3), 128, np.uint8), [128, 128, 128, 255]),
        (np.full((2, 3, 1), 0.5, np.float32), [128, 128, 128, 255]),
        (np.full((2, 3, 2), [10, 20], np.uint8), [10, 10, 10, 20]),
        (np.full((2, 3, 3), [65535, 0, 257], np.uint16), [255, 0, 1, 255]),
        (np.full((2, 3, 4), [1.0, 0.0, 0.2, 0.4]), [255, 0, 51, 102]),
        (np.ones((2, 3), bool), [255, 255, 255, 255]),
        (Image.new("RGB", (3, 2), "red"), RED),
        (Image.new("CMYK", (3, 2), (0, 255, 255, 0)), RED),
        (Image.new("L", (3, 2), 7), [7, 7, 7, 255]),
        (Image.new("I;16", (3, 2), 65535), [255, 255, 255, 255]),
        (Image.new("F", (3, 2), 1.0), [255, 255, 255, 255]),
        (Image.new("1", (3, 2), 1), [255, 255, 255, 255]),
    ],
)
def test_pictures_of_all_kinds(value: Any, expected: list[int]) -> None:
    pixels = rgba(value)
    assert pixels.dtype == np.uint8
    assert pixels.shape == (2, 3, 4)
    assert (pixels == expected).all()


def test_bytes_and_transposed_arrays_of_gl_read_pixels() -> None:
    rows = np.arange(2 * 3 * 3, dtype=np.uint8).reshape(2, 3, 3)
    for value in (rows.tobytes(), rows.reshape(3, 2, 3)):  # PyOpenGL's arrays have (width, height)
        assert (rgba(value, size=(3, 2), origin="lower")[::-1, :, :3] == rows).all()


def test_files(tmp_path: Path) -> None:
    Image.new("RGB", (3, 2), "red").save(tmp_path / "red.png")
    assert (rgba(tmp_path / "red.png") == RED).all()
    (tmp_path / "no.png").write_text("no picture")
    with pytest.raises(ValueError, match="is no picture file"):
        rgba(tmp_path / "no.png")
    with pytest.raises(FileNotFoundError, match="cannot be read"):
        rgba(str(tmp_path / "missing.png"))


def test_frame_buffers(screen: glsim.Offscreen) -> None:
    glClearColor(1.0, 0.0, 0.0, 1.0)
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_SCISSOR_TEST)
    glScissor(0, 0, 128, 64)
    glClearColor(0.0, 0.0, 1.0, 1.0)
    glClear(GL_COLOR_BUFFER_BIT)
    assert rgba(screen)[0, 0].tolist() == RED
    assert rgba(screen)[-1, 0].tolist() == [0, 0, 255, 255]
    context = moderngl.create_context(standalone=True, backend="egl")
    for dtype, components in (("f1", 4), ("f1", 3), ("f2", 4), ("f4", 3)):
        texture = context.texture((5, 3), components, dtype=dtype)
        buffer = context.framebuffer([texture])
        buffer.clear(1.0, 0.0, 0.0, 1.0)
        assert (rgba(buffer) == RED).all()
        assert rgba(buffer).shape == (3, 5, 4)
    context.release()


def test_what_other_libraries_return() -> None:
    colour = np.full((2, 3, 3), [255, 0, 0], np.uint8)
    assert (rgba((colour, np.ones((2, 3), np.float32))) == RED).all()  # pyrender: colour and depth


@pytest.mark.parametrize(
    ("value", "sentence"),
    [
        (np.zeros((0, 3, 3), np.uint8), "the picture is empty"),
        (np.zeros((2, 3, 3), np.int64), r"not int64: if they go to 255, use \.astype"),
        (np.full((2, 3), 200, np.uint16), "in uint16 white is 65535"),
        (np.full((2, 3), 200.0), "divide by 255"),
        (np.full((2, 3), np.nan), "not nan to nan"),
        (np.zeros((3, 20, 30), np.uint8), "channels come first"),
        (np.zeros(12, np.uint8), "add size="),
        (np.zeros((2, 3, 5), np.uint8), "a picture has the shape"),
        (b"123", "bytes do not say how wide"),
        ("", "cannot be read|is no picture"),
    ],
)
def test_what_is_no_picture(value: Any, sentence: str) -> None:
    with pytest.raises((ValueError, OSError), match=sentence):
        rgba(value)


def test_what_is_nothing_like_a_picture() -> None:
    for value in (None, object(), SimpleNamespace(), {"a": 1}, [["x"]]):
        with pytest.raises(TypeError, match="a picture is needed"):
            rgba(value)
    with pytest.raises(ValueError, match="origin is"):
        rgba(np.zeros((2, 2)), origin="top")
    for size in ((0, 2), (1 << 20, 1 << 20)):
        with pytest.raises(ValueError, match="each at least 1"):
            rgba(b"", size=size)
    with pytest.raises(TypeError, match=r"size is \(width, height\)"):
        rgba(b"", size=(1, 2, 3))


def test_transparency_is_seen_on_paper() -> None:
    pixels = np.zeros((16, 16, 4), np.uint8)
    assert {tuple(p) for p in on_paper(pixels).reshape(-1, 3).tolist()} == {(255,) * 3, (204,) * 3}
    pixels[..., 3] = 255
    assert not on_paper(pixels).any()
