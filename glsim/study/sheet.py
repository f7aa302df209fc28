"""The sheet of a comparison: pictures in columns and rows, with headings, formulas and amplified differences."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from glsim.pictures import FAINT, INK, PAPER

if TYPE_CHECKING:
    from glsim.study.axes import Value
    from glsim.study.comparison import Comparison

Pixels = NDArray[np.uint8]
Color = tuple[int, int, int]

EMPTY: Color = (238, 238, 235)
DIFFERENCE = 0.3  # height of a difference, as a share of its picture's
# Page and size of text in pixels: 16:9 for a projector, A4 at 300 dpi for paper; None: as large as the pictures are.
LAYOUTS: dict[str, tuple[tuple[int, int], int] | None] = {
    "screen": None, "projector": ((1920, 1080), 26), "paper": ((2480, 3508), 44),
}  # fmt: skip


# ---------------------------------------------------------------- text


def written(text: str, size: float, color: Color = INK, paper: Color = PAPER) -> Image.Image:
    """A line of text as a picture; "k_d" has an index and "x^n" an exponent, of one character or digits."""
    runs = _runs(text)
    large, small = (ImageFont.load_default(max(size * share, 8.0)) for share in (1.0, 0.72))
    fonts = {"": large, "_": small, "^": small}
    drops = {"": 0.0, "_": 0.48 * size, "^": -0.02 * size}
    width = sum(fonts[mark].getlength(words) for mark, words in runs)
    line = Image.new("RGB", (int(width) + 2, round(1.45 * size)), paper)
    pen, x = ImageDraw.Draw(line), 0.0
    for mark, words in runs:
        pen.text((x, drops[mark] + 0.1 * size), words, color, fonts[mark])
        x += fonts[mark].getlength(words)
    return line


def _runs(text: str) -> list[tuple[str, str]]:
    """Text cut where the size of the letters changes: (mark, letters); mark: "_" for an index, "^" for an exponent."""
    runs, at = [], 0
    for found in re.finditer(r"(?<=\w)_(\d+|\w)\b|\^(\d+|\w)", text):
        runs += [("", text[at : found.start()]), (found[0][0], found[0][1:])]
        at = found.end()
    return [run for run in [*runs, ("", text[at:])] if run[1]]


def fitted(text: str, size: float, width: int, color: Color = INK) -> list[Image.Image]:
    """Text in lines of at most ``width`` pixels: broken where commas are followed by two spaces, then made smaller."""
    line = written(text, size, color)
    if line.width <= width:
        return [line]
    if ",  " in text:
        return [part for words in text.split(",  ") for part in fitted(words, size, width, color)]
    return [written(text, max(size * width / line.width * 0.98, 8.0), color)]


def plain(text: str) -> str:
    """The same text with Unicode's indices and exponents where it has them."""
    text = re.sub(r"_(\d)", lambda found: chr(0x2080 + int(found[1])), text)
    return text.replace("^n", "ⁿ")


# ---------------------------------------------------------------- geometry


@dataclass(frozen=True)
class Grid:
    """Where things are on a sheet, in pixels, for pictures of width x height.

    text: size of headings.  band: height of the differences under the pictures.  heads: lines over the columns."""

    columns: int
    rows: int
    width: int
    height: int
    text: int
    differences: bool
    heads: int
    labelled: bool

    @property
    def gap(self) -> int:
        return max(self.text // 2, 4)

    @property
    def small(self) -> float:
        return max(0.8 * self.text, 10.0)

    @property
    def band(self) -> int:
        return max(round(DIFFERENCE * self.height), round(4.4 * self.small)) if self.differences else 0

    @property
    def column(self) -> int:
        """The width of a column: room for its heading beside tiny pictures."""
        return max(self.width, 8 * self.text)

    @property
    def left(self) -> int:
        return self.gap + (round(1.6 * self.text) + self.gap if self.labelled else 0)

    @property
    def top(self) -> int:
        return round(self.gap + 1.9 * self.text + 1.6 * self.text + 1.45 * self.small * self.heads + 0.5 * self.gap)

    @property
    def block(self) -> int:
        """The height of a row."""
        return self.height + (self.gap // 2 + self.band if self.differences else 0) + self.gap

    @property
    def size(self) -> tuple[int, int]:
        return self.left + self.columns * (self.column + self.gap), self.top + self.rows * self.block


def _grid(comparison: Comparison, width: int, height: int, text: int) -> Grid:
    columns, rows = comparison.columns.values, comparison.rows.values
    small, room = max(0.8 * text, 10.0), max(width, 8 * text)
    lines = [_head(comparison, column, small, room) for column in columns]
    differences = bool(comparison.amplified) and len(columns) > 1
    labelled = any(row.label for row in rows)
    return Grid(len(columns), len(rows), width, height, text, differences, max(map(len, lines)), labelled)


def _head(comparison: Comparison, column: Value, small: float, room: int) -> list[Image.Image]:
    """What stands under a column's heading: the user's caption, then the formula."""
    own = comparison.captions.get(column.name, "")
    words = [(own, INK), (column.formula, FAINT)]
    return [line for text, color in words if text for line in fitted(text, small, room, color)]


def _largest(comparison: Comparison, page: tuple[int, int], text: int, width: int, height: int) -> Grid:
    """The grid with the largest pictures that fits a page."""
    ratio, share = height / width, 1.0
    while True:
        wide = max(int(page[0] * share), 16)
        grid = _grid(comparison, wide, max(round(wide * ratio), 1), text)
        if (grid.size[0] <= page[0] and grid.size[1] <= page[1]) or wide == 16:
            return grid
        share *= 0.985


# ---------------------------------------------------------------- drawing


def draw_sheet(comparison: Comparison) -> Image.Image:
    """The sheet in the comparison's layout.  A page that it does not fill has it in the middle."""
    height, width = np.max([picture.shape[:2] for picture in comparison.images.values()], axis=0).tolist()
    layout = LAYOUTS[comparison.layout]
    if layout is None:
        return _drawn(comparison, _grid(comparison, width, height, max(12, min(width, 640) // 24)))
    page, text = layout
    grid = _largest(comparison, page, text, width, height)
    if comparison.layout == "paper" and grid.size[1] < page[1] / 2:  # lying, or half a page, wastes less
        lying = _largest(comparison, page[::-1], text, width, height)
        grid, page = (lying, page[::-1]) if lying.width > 1.15 * grid.width else (grid, page)
    sheet = Image.new("RGB", page, PAPER)
    drawn = _drawn(comparison, grid)
    up = (page[1] - drawn.height) // 2 if comparison.layout == "projector" else min(page[1] - drawn.height, 2 * text)
    sheet.paste(drawn, ((page[0] - drawn.width) // 2, max(up, 0)))
    return sheet


def _drawn(comparison: Comparison, grid: Grid) -> Image.Image:
    sheet = Image.new("RGB", grid.size, PAPER)
    _title(sheet, comparison, grid)
    for k, column in enumerate(comparison.columns.values):
        x = grid.left + k * (grid.column + grid.gap)
        y = round(grid.gap + 1.9 * grid.text)
        lines = [*fitted(column.label, 1.1 * grid.text, grid.column)[:1],
                 *_head(comparison, column, grid.small, grid.column)]  # fmt: skip
        for line in lines:
            sheet.paste(line, (x + (grid.column - line.width) // 2, y))
            y += round(1.45 * grid.small) if line is not lines[0] else round(1.6 * grid.text)
    for k, row in enumerate(comparison.rows.values):
        y = grid.top + k * grid.block
        if row.label:
            label = fitted(comparison.captions.get(row.name, row.label), grid.text, grid.height)[0]
            turned = label.rotate(90, expand=True)
            sheet.paste(turned, (grid.gap, y + max(0, (grid.height - turned.height) // 2)))
        for number, column in enumerate(comparison.columns.values):
            x = grid.left + number * (grid.column + grid.gap)
            _cell(sheet, comparison, (row.name, column.name), grid, (x, y))
    return sheet


def _title(sheet: Image.Image, comparison: Comparison, grid: Grid) -> None:
    room = sheet.width - grid.left - grid.gap
    title = fitted(comparison.title, 1.25 * grid.text, room)[0]
    sheet.paste(title, (grid.left, grid.gap // 2))
    legend = written(comparison.legend, grid.small, FAINT) if comparison.legend else None
    if legend is not None and title.width + legend.width + 2 * grid.gap <= room:
        sheet.paste(legend, (sheet.width - grid.gap - legend.width, grid.gap // 2 + title.height - legend.height))


def _cell(
    sheet: Image.Image, comparison: Comparison, key: tuple[str, str], grid: Grid, corner: tuple[int, int]
) -> None:
    """A picture, and under it its difference from the reference."""
    x, y = corner
    cell = comparison.cells[key]
    x += (grid.column - grid.width) // 2
    if cell.pixels is None:
        ImageDraw.Draw(sheet).rectangle((x, y, x + grid.width - 1, y + grid.height - 1), EMPTY)
        words = fitted(cell.words, grid.small, grid.width - grid.gap, FAINT)[0]
        sheet.paste(words, (x + (grid.width - words.width) // 2, y + (grid.height - words.height) // 2))
        return
    picture = scaled(cell.pixels, grid.width, grid.height)
    sheet.paste(picture, (x + (grid.width - picture.width) // 2, y + (grid.height - picture.height) // 2))
    if grid.differences:
        _difference(sheet, comparison, key, grid, (x, y + grid.height + grid.gap // 2))


def _difference(
    sheet: Image.Image, comparison: Comparison, key: tuple[str, str], grid: Grid, corner: tuple[int, int]
) -> None:
    x, y = corner
    words = comparison.difference_words(*key)
    if comparison.has_difference(*key):
        picture = scaled(amplified(comparison.difference(*key), comparison.amplified), grid.width, grid.band)
        sheet.paste(picture, (x, y))
        x += picture.width + grid.gap
    for k, text in enumerate(words):
        for line in fitted(text, grid.small, max(grid.width - (x - corner[0]), 5 * grid.text), FAINT)[:1]:
            sheet.paste(line, (x, y + round(1.45 * grid.small * k)))


def amplified(difference: NDArray[np.int16], factor: int) -> Pixels:
    """|difference| times ``factor``, at most 255, as a picture."""
    return np.asarray(np.minimum(np.abs(difference.astype(np.int32)) * factor, 255), np.uint8)


def scaled(pixels: Pixels, width: int, height: int) -> Image.Image:
    """A picture as large as fits width x height."""
    image = Image.fromarray(np.ascontiguousarray(pixels))
    factor = min(width / image.width, height / image.height)
    size = max(round(image.width * factor), 1), max(round(image.height * factor), 1)
    return image if size == image.size else image.resize(size, Image.Resampling.LANCZOS)
