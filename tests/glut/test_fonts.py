"""GLUT's fonts, and what they have in common with freeglut 3.4's."""

from __future__ import annotations

import hashlib
from collections.abc import Callable

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glut import fonts
from glsim.glut.fonts import *

# font, height, rows below the base line, length of "Hello, World!", digest of what freeglut hands to glBitmap
BITMAP = [
    (GLUT_BITMAP_9_BY_15, 16, 4, 117, "ca058812461eae4d"),
    (GLUT_BITMAP_8_BY_13, 14, 3, 104, "9edcf9605002a21d"),
    (GLUT_BITMAP_TIMES_ROMAN_10, 14, 4, 61, "1572116ef9ccb0f9"),
    (GLUT_BITMAP_TIMES_ROMAN_24, 29, 7, 136, "9dac056c30847aa4"),
    (GLUT_BITMAP_HELVETICA_10, 14, 3, 59, "3a3263a67b5193fd"),
    (GLUT_BITMAP_HELVETICA_12, 16, 4, 72, "5a35d6524246417e"),
    (GLUT_BITMAP_HELVETICA_18, 23, 5, 108, "142a43139f0e1f69"),
]
# font, vertices, their moment, length of "Hello, World!" rounded and not
STROKE = [
    (GLUT_STROKE_ROMAN, 1086, -822.226, 737, 736.8448),
    (GLUT_STROKE_MONO_ROMAN, 1086, -735.402, 1362, 1361.9060),
]
HELLO = "Hello, World!"


@pytest.fixture
def pixels(screen: glsim.Offscreen) -> glsim.Offscreen:
    """One unit for a pixel, and a white raster colour."""
    glMatrixMode(GL_PROJECTION)
    glOrtho(0, 128, 0, 128, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glColor3f(1, 1, 1)
    return screen


def lit(screen: glsim.Offscreen) -> np.ndarray:
    """Bottom row first."""
    return screen.pixels()[::-1, :, 0] > 0


@pytest.mark.parametrize(("font", "height", "descent", "length", "digest"), BITMAP)
def test_bitmap_fonts_are_freeglut_s(
    font: fonts.BitmapFont, height: int, descent: int, length: int, digest: str
) -> None:
    assert (glutBitmapHeight(font), font.descent, glutBitmapLength(font, HELLO)) == (height, descent, length)
    assert sorted(font.glyphs) == list(range(1, 256))
    data = b"".join(bytes([glyph.width]) + glyph.bits for glyph in font.glyphs.values())
    assert hashlib.sha256(data).hexdigest()[:16] == digest


@pytest.mark.parametrize(("font", "height", "descent", "length", "digest"), BITMAP)
def test_bitmap_characters_are_drawn(
    pixels: glsim.Offscreen, font: fonts.BitmapFont, height: int, descent: int, length: int, digest: str
) -> None:
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8)
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 3)
    for character in b"Ag8\xe9":
        glClear(GL_COLOR_BUFFER_BIT)
        glRasterPos2i(20, 40)
        glutBitmapCharacter(font, character)
        width, bits = font.glyphs[character]
        expected = np.zeros((128, 128), bool)
        rows = np.unpackbits(np.frombuffer(bits, np.uint8).reshape(height, -1), axis=1)[:, :width]
        expected[40 - descent : 40 - descent + height, 20 : 20 + width] = rows
        assert (lit(pixels) == expected).all()
        assert glGetFloatv(GL_CURRENT_RASTER_POSITION)[0] == 20 + width
    assert glGetIntegerv(GL_UNPACK_ALIGNMENT) == 8


def test_the_letter_a(pixels: glsim.Offscreen) -> None:
    glRasterPos2i(0, 0)
    glutBitmapCharacter(GLUT_BITMAP_8_BY_13, "A")
    picture = ["".join(".#"[int(cell)] for cell in row) for row in lit(pixels)[8::-1, :8]]
    assert picture == [
        "...##...",
        "..#..#..",
        ".#....#.",
        ".#....#.",
        ".#....#.",
        ".######.",
        ".#....#.",
        ".#....#.",
        ".#....#.",
    ]


def test_widths() -> None:
    assert {glutBitmapWidth(GLUT_BITMAP_8_BY_13, c) for c in range(1, 256)} == {8}
    assert {glutBitmapWidth(GLUT_BITMAP_9_BY_15, c) for c in range(1, 256)} == {9}
    assert glutBitmapWidth(GLUT_BITMAP_HELVETICA_18, "A") == glutBitmapWidth(GLUT_BITMAP_HELVETICA_18, b"A") == 12
    assert [glutBitmapWidth(GLUT_BITMAP_8_BY_13, c) for c in (-1, 0, 256)] == [0, 0, 0]
    assert {glutStrokeWidth(GLUT_STROKE_MONO_ROMAN, c) for c in range(32, 128)} == {105}
    assert glutStrokeWidth(GLUT_STROKE_ROMAN, "A") == 80
    assert glutStrokeWidthf(GLUT_STROKE_ROMAN, "A") == pytest.approx(80.4905)
    assert [glutStrokeWidth(GLUT_STROKE_ROMAN, c) for c in (-1, 31, 128)] == [0, 0, 0]


def test_lengths_are_of_the_longest_line() -> None:
    assert glutBitmapLength(GLUT_BITMAP_8_BY_13, "two\nlines longer\nx") == 8 * 12
    assert glutBitmapLength(GLUT_BITMAP_8_BY_13, b"") == 0
    assert glutBitmapLength(GLUT_BITMAP_8_BY_13, b"ab\0cd") == 16
    assert glutBitmapLength(GLUT_BITMAP_8_BY_13, "\xe9") == 8
    assert glutStrokeLength(GLUT_STROKE_MONO_ROMAN, "a\nbc\n") == 210
    assert glutStrokeLengthf(GLUT_STROKE_MONO_ROMAN, "a\nbc\n") == pytest.approx(2 * 104.762)
    assert glutStrokeLength(GLUT_STROKE_ROMAN, "") == 0


def test_a_bitmap_string_is_its_characters(pixels: glsim.Offscreen) -> None:
    glRasterPos2i(5, 60)
    glutBitmapString(GLUT_BITMAP_HELVETICA_12, "Ab\n\ncd")
    at = list(glGetFloatv(GL_CURRENT_RASTER_POSITION))[:2]
    assert at == [5 + glutBitmapLength(GLUT_BITMAP_HELVETICA_12, "cd"), 60 - 2 * 16]
    string = lit(pixels)
    glClear(GL_COLOR_BUFFER_BIT)
    for text, y in (("Ab", 60), ("cd", 60 - 2 * 16)):
        glRasterPos2i(5, y)
        for character in text:
            glutBitmapCharacter(GLUT_BITMAP_HELVETICA_12, ord(character))
    assert (lit(pixels) == string).all()


@pytest.mark.parametrize(("font", "vertices", "sum_of_vertices", "length", "lengthf"), STROKE)
def test_stroke_fonts_are_freeglut_s(
    font: fonts.StrokeFont, vertices: int, sum_of_vertices: float, length: int, lengthf: float
) -> None:
    assert glutStrokeHeight(font) == pytest.approx(152.381)
    assert sorted(font.glyphs) == list(range(32, 128))
    points = np.array([point for glyph in font.glyphs.values() for strip in glyph.strips for point in strip])
    assert len(points) == vertices
    assert float(points.ravel() @ np.cos(np.arange(points.size))) == pytest.approx(sum_of_vertices, abs=1e-2)
    assert glutStrokeLength(font, HELLO) == length
    assert glutStrokeLengthf(font, HELLO) == pytest.approx(lengthf, abs=1e-3)


def feedback(draw: Callable[[], None]) -> list[tuple[int, tuple[tuple[float, float], ...]]]:
    """Kinds and window coordinates of what is drawn."""
    glFeedbackBuffer(20000, GL_2D)
    glRenderMode(GL_FEEDBACK)
    draw()
    return [(token, tuple(tuple(v.vertex[:2]) for v in vertices)) for token, *vertices in glRenderMode(GL_RENDER)]


def test_stroke_characters_are_line_strips(pixels: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch) -> None:
    found = feedback(lambda: glutStrokeCharacter(GLUT_STROKE_ROMAN, "A"))
    assert [token for token, _ in found] == [GL_LINE_RESET_TOKEN] * 3
    ends = [end for _, pair in found for end in pair]
    expected = [point for strip in GLUT_STROKE_ROMAN.glyphs[ord("A")].strips for point in strip]
    assert np.array(ends) == pytest.approx(np.array(expected), abs=1e-3)
    assert glGetFloatv(GL_MODELVIEW_MATRIX)[3][0] == pytest.approx(80.4905)
    glLoadIdentity()
    monkeypatch.setattr(fonts, "draw_join_dots", True)
    dotted = feedback(lambda: glutStrokeCharacter(GLUT_STROKE_ROMAN, "A"))
    assert [token for token, _ in dotted].count(GL_POINT_TOKEN) == 6


def test_a_stroke_string_ends_where_its_last_line_does(screen: glsim.Offscreen) -> None:
    glutStrokeString(GLUT_STROKE_ROMAN, "Two\nlines\xe9\n")
    assert glGetFloatv(GL_MODELVIEW_MATRIX)[3] == pytest.approx([0, -2 * 152.381, 0, 1], abs=1e-3)
    glutStrokeString(GLUT_STROKE_ROMAN, b"end")
    assert glGetFloatv(GL_MODELVIEW_MATRIX)[3][0] == pytest.approx(
        glutStrokeLengthf(GLUT_STROKE_ROMAN, "end"), abs=1e-3
    )


def test_fonts_have_names() -> None:
    named = {name: font for name, font in vars(fonts).items() if name.startswith("GLUT_")}
    assert len(named) == 9  # seven bitmap fonts, two stroke fonts
    assert {name: repr(font) for name, font in named.items()} == {name: name for name in named}


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (
            lambda: glutBitmapCharacter(GLUT_STROKE_ROMAN, 65),
            "glutBitmapCharacter: font must be a bitmap font such as GLUT_BITMAP_HELVETICA_18, not GLUT_STROKE_ROMAN",
        ),
        (
            lambda: glutStrokeString(GLUT_BITMAP_8_BY_13, "A"),
            "glutStrokeString: font must be GLUT_STROKE_ROMAN or GLUT_STROKE_MONO_ROMAN, not GLUT_BITMAP_8_BY_13",
        ),
        (
            lambda: glutBitmapWidth(GLUT_BITMAP_8_BY_13, "AB"),
            "glutBitmapWidth: character must be a number or one character, not 'AB'",
        ),
        (
            lambda: glutBitmapString(GLUT_BITMAP_8_BY_13, "\u03c0"),
            "glutBitmapString: the fonts have no '\u03c0', only ISO 8859-1",
        ),
        (lambda: glutStrokeLength(GLUT_STROKE_ROMAN, 5), "glutStrokeLength: string must be bytes or str, not 5"),
    ],
)
def test_bad_arguments_are_named(call: Callable[[], object], sentence: str) -> None:
    with pytest.raises((TypeError, ValueError)) as caught:
        call()
    assert str(caught.value) == sentence
