"""GLUT's bitmap and stroke fonts.

The glyphs are freeglut 3.4's, bit for bit; fonts.npz has them.  Bitmap fonts: characters 1 to 255 (ISO 8859-1), rows
bottom up, each in whole bytes; the widths and heights are in pixels.  Stroke fonts: characters 32 to 127 as line
strips in a coordinate system in which capitals are 100 high.

8 by 13 and 9 by 15 are X11's misc-fixed fonts, in the public domain; Helvetica and Times are X11's too, copyright Adobe
Systems and Digital Equipment Corporation, free to use and change with their notice; the stroke fonts are freeglut's
(MIT licence).  FONTS.md has the notices.
"""

from __future__ import annotations

import operator
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from glsim import gl

DATA = Path(__file__).with_name("fonts.npz")
NEWLINE = ord("\n")
draw_join_dots = False  # GLUT_STROKE_FONT_DRAW_JOIN_DOTS: glutStrokeCharacter adds a point at each vertex

Point = tuple[float, float]


class BitmapGlyph(NamedTuple):
    """``bits``: rows bottom up, each in whole bytes."""

    width: int
    bits: bytes


class StrokeGlyph(NamedTuple):
    """``advance``: how far to the right the next character is."""

    advance: float
    strips: tuple[tuple[Point, ...], ...]


class BitmapFont:
    """One of the seven fonts of pixels.  ``height`` and ``descent``, the rows below the base line, in pixels."""

    kind = "bitmap"

    def __init__(self, name: str, height: int, descent: int) -> None:
        self.name, self.height, self.descent = name, height, descent

    def __repr__(self) -> str:
        return self.name

    @cached_property
    def glyphs(self) -> dict[int, BitmapGlyph]:
        """By character."""
        with np.load(DATA) as data:
            widths, bits = data[f"{self.name}_widths"].tolist(), data[f"{self.name}_bits"].tobytes()
        glyphs, start = {}, 0
        for character, width in enumerate(widths, 1):
            end = start + (width + 7) // 8 * self.height
            glyphs[character] = BitmapGlyph(width, bits[start:end])
            start = end
        return glyphs


class StrokeFont:
    """One of the two fonts of lines.  ``height``: from line to line."""

    kind = "stroke"

    def __init__(self, name: str, height: float) -> None:
        self.name, self.height = name, height

    def __repr__(self) -> str:
        return self.name

    @cached_property
    def glyphs(self) -> dict[int, StrokeGlyph]:
        """By character."""
        with np.load(DATA) as data:
            advances, counts, lengths, points = (
                data[f"{self.name}_{part}"].tolist() for part in ("advances", "strips", "lengths", "points")
            )
        glyphs, ends = {}, np.cumsum(lengths).tolist()
        strips = [tuple(map(tuple, points[end - length : end])) for length, end in zip(lengths, ends, strict=True)]
        first = 0
        for character, (advance, count) in enumerate(zip(advances, counts, strict=True), 32):
            glyphs[character] = StrokeGlyph(advance, tuple(strips[first : first + count]))
            first += count
        return glyphs


GLUT_BITMAP_9_BY_15 = BitmapFont("GLUT_BITMAP_9_BY_15", 16, 4)
GLUT_BITMAP_8_BY_13 = BitmapFont("GLUT_BITMAP_8_BY_13", 14, 3)
GLUT_BITMAP_TIMES_ROMAN_10 = BitmapFont("GLUT_BITMAP_TIMES_ROMAN_10", 14, 4)
GLUT_BITMAP_TIMES_ROMAN_24 = BitmapFont("GLUT_BITMAP_TIMES_ROMAN_24", 29, 7)
GLUT_BITMAP_HELVETICA_10 = BitmapFont("GLUT_BITMAP_HELVETICA_10", 14, 3)
GLUT_BITMAP_HELVETICA_12 = BitmapFont("GLUT_BITMAP_HELVETICA_12", 16, 4)
GLUT_BITMAP_HELVETICA_18 = BitmapFont("GLUT_BITMAP_HELVETICA_18", 23, 5)
GLUT_STROKE_ROMAN = StrokeFont("GLUT_STROKE_ROMAN", float(np.float32(152.381)))
GLUT_STROKE_MONO_ROMAN = StrokeFont("GLUT_STROKE_MONO_ROMAN", float(np.float32(152.381)))


# ---------------------------------------------------------------- arguments


def _bitmap(name: str, font: Any) -> BitmapFont:
    if isinstance(font, BitmapFont):
        return font
    raise TypeError(f"{name}: font must be a bitmap font such as GLUT_BITMAP_HELVETICA_18, not {font!r}")


def _stroke(name: str, font: Any) -> StrokeFont:
    if isinstance(font, StrokeFont):
        return font
    raise TypeError(f"{name}: font must be GLUT_STROKE_ROMAN or GLUT_STROKE_MONO_ROMAN, not {font!r}")


def _code(name: str, character: Any) -> int:
    """The number of a character, given as a number or as text of length 1."""
    if isinstance(character, (str, bytes)) and len(character) == 1:
        return ord(character)
    try:
        return operator.index(character)
    except TypeError:
        raise TypeError(f"{name}: character must be a number or one character, not {character!r}") from None


def _codes(name: str, string: Any) -> bytes:
    """The characters of a string, up to a zero byte as in C."""
    if isinstance(string, str):
        try:
            string = string.encode("latin-1")
        except UnicodeEncodeError as error:
            raise ValueError(f"{name}: the fonts have no {string[error.start]!r}, only ISO 8859-1") from None
    try:
        return memoryview(string).tobytes().partition(b"\0")[0]
    except TypeError:
        raise TypeError(f"{name}: string must be bytes or str, not {string!r}") from None


# ---------------------------------------------------------------- bitmap fonts


def _push_unpacking() -> None:
    """Glyphs lie in memory without gaps, whatever the program said of its own pictures."""
    gl.glPushClientAttrib(gl.GL_CLIENT_PIXEL_STORE_BIT)
    for parameter in (
        gl.GL_UNPACK_SWAP_BYTES,
        gl.GL_UNPACK_LSB_FIRST,
        gl.GL_UNPACK_ROW_LENGTH,
        gl.GL_UNPACK_SKIP_ROWS,
        gl.GL_UNPACK_SKIP_PIXELS,
    ):
        gl.glPixelStorei(parameter, 0)
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)


def _draw_glyph(font: BitmapFont, glyph: BitmapGlyph) -> None:
    gl.glBitmap(glyph.width, font.height, 0.0, float(font.descent), float(glyph.width), 0.0, glyph.bits)


def glutBitmapCharacter(font: BitmapFont, character: int | str | bytes) -> None:
    """Draw at the raster position and move it to the right; numbers outside 1 to 255 draw nothing."""
    glyph = _bitmap("glutBitmapCharacter", font).glyphs.get(_code("glutBitmapCharacter", character))
    if glyph is not None:
        _push_unpacking()
        _draw_glyph(font, glyph)
        gl.glPopClientAttrib()


def glutBitmapString(font: BitmapFont, string: bytes | str) -> None:
    """Draw a text at the raster position; a newline moves it back to the start and down by the font's height."""
    glyphs = _bitmap("glutBitmapString", font).glyphs
    codes = _codes("glutBitmapString", string)
    if not codes:
        return
    _push_unpacking()
    width = 0
    for code in codes:
        if code == NEWLINE:
            gl.glBitmap(0, 0, 0.0, 0.0, float(-width), float(-font.height), None)
            width = 0
        else:
            _draw_glyph(font, glyphs[code])
            width += glyphs[code].width
    gl.glPopClientAttrib()


def glutBitmapWidth(font: BitmapFont, character: int | str | bytes) -> int:
    """Width of a character in pixels; 0 for numbers outside 1 to 255."""
    glyph = _bitmap("glutBitmapWidth", font).glyphs.get(_code("glutBitmapWidth", character))
    return 0 if glyph is None else glyph.width


def glutBitmapLength(font: BitmapFont, string: bytes | str) -> int:
    """Width of the longest line of a text, in pixels."""
    glyphs = _bitmap("glutBitmapLength", font).glyphs
    lines = _codes("glutBitmapLength", string).split(b"\n")
    return max(sum(glyphs[code].width for code in line) for line in lines)


def glutBitmapHeight(font: BitmapFont) -> int:
    """Distance from line to line, in pixels."""
    return _bitmap("glutBitmapHeight", font).height


# ---------------------------------------------------------------- stroke fonts


def _draw_strips(mode: int, strips: tuple[tuple[Point, ...], ...]) -> None:
    for strip in strips:
        gl.glBegin(mode)
        for x, y in strip:
            gl.glVertex2f(x, y)
        gl.glEnd()


def glutStrokeCharacter(font: StrokeFont, character: int | str | bytes) -> None:
    """Draw at the origin of the model, which moves to the right; numbers outside 32 to 127 draw nothing."""
    glyph = _stroke("glutStrokeCharacter", font).glyphs.get(_code("glutStrokeCharacter", character))
    if glyph is not None:
        for strip in glyph.strips:
            _draw_strips(gl.GL_LINE_STRIP, (strip,))
            if draw_join_dots:
                _draw_strips(gl.GL_POINTS, (strip,))
        gl.glTranslatef(glyph.advance, 0.0, 0.0)


def glutStrokeString(font: StrokeFont, string: bytes | str) -> None:
    """Draw a text in lines; a newline moves the origin back to the start and down by the font's height."""
    glyphs = _stroke("glutStrokeString", font).glyphs
    length = np.float32(0)
    for code in _codes("glutStrokeString", string):
        glyph = glyphs.get(code)
        if code == NEWLINE:
            gl.glTranslatef(-float(length), -font.height, 0.0)
            length = np.float32(0)
        elif glyph is not None:
            _draw_strips(gl.GL_LINE_STRIP, glyph.strips)
            gl.glTranslatef(glyph.advance, 0.0, 0.0)
            length += np.float32(glyph.advance)


def glutStrokeWidthf(font: StrokeFont, character: int | str | bytes) -> float:
    """Width of a character in object coordinates; 0 for characters that the font does not have."""
    glyph = _stroke("glutStrokeWidthf", font).glyphs.get(_code("glutStrokeWidthf", character))
    return 0.0 if glyph is None else glyph.advance


def glutStrokeWidth(font: StrokeFont, character: int | str | bytes) -> int:
    """Width of a character in object coordinates, rounded."""
    return int(glutStrokeWidthf(_stroke("glutStrokeWidth", font), _code("glutStrokeWidth", character)) + 0.5)


def glutStrokeLengthf(font: StrokeFont, string: bytes | str) -> float:
    """Width of the longest line of a text, in object coordinates."""
    return _longest(_stroke("glutStrokeLengthf", font), _codes("glutStrokeLengthf", string))


def glutStrokeLength(font: StrokeFont, string: bytes | str) -> int:
    """Width of the longest line of a text, in object coordinates, rounded."""
    return int(_longest(_stroke("glutStrokeLength", font), _codes("glutStrokeLength", string)) + 0.5)


def _longest(font: StrokeFont, codes: bytes) -> float:
    """Added up in float32, as freeglut does."""
    lines = [[font.glyphs[code].advance for code in line if code in font.glyphs] for line in codes.split(b"\n")]
    return max(float(np.cumsum(np.array([0.0, *line], np.float32), dtype=np.float32)[-1]) for line in lines)


def glutStrokeHeight(font: StrokeFont) -> float:
    """Distance from line to line, in object coordinates."""
    return _stroke("glutStrokeHeight", font).height
