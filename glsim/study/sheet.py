"""The sheet of a comparison: pictures in columns and rows, with headings, formulas and amplified differences."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from glsim.metrics import amplified
from glsim.pictures import FAINT, INK, PAPER

if TYPE_CHECKING:
    from glsim.study.axes import Value
    from glsim.study.comparison import Comparison

Pixels = NDArray[np.uint8]
Color = tuple[int, int, int]

EMPTY: Color = (238, 238, 235)
SHARE = 0.3  # of a difference: its height under a picture, or its width beside it, as a share of the picture's
# Page and size of text in pixels: 16:9 for a projector, A4 at 300 dpi for paper; None: as large as the pictures are.
LAYOUTS: dict[str, tuple[tuple[int, int], int] | None] = {
    "screen": None, "projector": ((1920, 1080), 25), "paper": ((2480, 3508), 44),
}  # fmt: skip


# ---------------------------------------------------------------- text


def written(text: str, size: float, color: Color = INK, paper: Color = PAPER) -> Image.Image:
    """A line of text as a picture; "k_d" has an index and "x^n" an exponent, of one character or digits."""
    drops = {"": 0.0, "_": 0.48 * size, "^": -0.02 * size}
    line = Image.new("RGB", (_width(text, size), round(1.45 * size)), paper)
    pen, x = ImageDraw.Draw(line), 0.0
    for mark, words in _runs(text):
        font = _font(mark, size)
        pen.text((x, drops[mark] + 0.1 * size), words, color, font)
        x += font.getlength(words)
    return line


@cache
def _font(mark: str, size: float) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(max(size * (0.72 if mark else 1.0), 8.0))


@lru_cache(4096)
def _width(text: str, size: float) -> int:
    """The width of a written line in pixels, without writing it."""
    return int(sum(_font(mark, size).getlength(words) for mark, words in _runs(text))) + 2


def _runs(text: str) -> list[tuple[str, str]]:
    """Text cut where the size of the letters changes: (mark, letters); mark: "_" for an index, "^" for an exponent."""
    runs, at = [], 0
    for found in re.finditer(r"(?<=\w)_(\d+|\w)\b|\^(\d+|\w)", text):
        runs += [("", text[at : found.start()]), (found[0][0], found[0][1:])]
        at = found.end()
    return [run for run in [*runs, ("", text[at:])] if run[1]]


def broken(text: str, size: float, width: int) -> list[str]:
    """Text in lines of at most ``width`` pixels: broken where commas are followed by two spaces."""
    if _width(text, size) <= width or ",  " not in text:
        return [text]
    return [line for words in text.split(",  ") for line in broken(words, size, width)]


def fitted(text: str, size: float, width: int, color: Color = INK) -> list[Image.Image]:
    """Text in lines as ``broken`` gives them; what is still too wide is written smaller."""
    found = []
    for line in broken(text, size, width):
        shrunk = size * width / _width(line, size) * 0.98
        found.append(written(line, size if _width(line, size) <= width else max(shrunk, 8.0), color))
    return found


# ---------------------------------------------------------------- geometry


@dataclass(frozen=True)
class Grid:
    """Where things are on a sheet, in pixels, for pictures of width x height.

    text: size of headings.  differences: "under" the pictures with their numbers at the right, "beside" the pictures,
    "stacked" under them with the numbers below, or "" for none.  heads: lines over the columns, below their names.
    labelled: whether rows have labels."""

    columns: int
    rows: int
    width: int
    height: int
    text: int
    differences: str
    labelled: bool
    heads: int = 0

    @property
    def gap(self) -> int:
        return max(self.text // 2, 4)

    @property
    def small(self) -> float:
        return max(0.8 * self.text, 10.0)

    @property
    def line(self) -> int:
        """The height of a small line."""
        return round(1.45 * self.small)

    @property
    def words(self) -> tuple[int, int]:
        """Room for the numbers of a difference."""
        return round(7.2 * self.small), 4 * self.line

    @property
    def difference(self) -> tuple[int, int]:
        """Room for the picture of a difference."""
        if self.differences == "beside":
            return max(round(SHARE * self.width), self.words[0]), max(self.height - self.words[1] - self.gap // 2, 8)
        if self.differences == "stacked":
            return self.width // 2, self.height // 2
        height = min(max(round(SHARE * self.height), self.words[1]), self.height)
        return round(height * self.width / self.height), height

    @property
    def cell(self) -> tuple[int, int]:
        """Room for a picture and its difference."""
        width, height = self.difference
        if self.differences == "beside":
            return self.width + self.gap // 2 + width, self.height
        if self.differences == "stacked":
            return max(self.width, self.words[0]), self.height + self.gap // 2 * 2 + height + self.words[1]
        if self.differences == "under":
            return max(self.width, width + self.gap + self.words[0]), self.height + self.gap // 2 + max(
                height, self.words[1]
            )
        return self.width, self.height

    @property
    def column(self) -> int:
        """The width of a column: tiny pictures leave room for a heading."""
        return max(self.cell[0], 8 * self.text)

    @property
    def left(self) -> int:
        return self.gap + (round(1.6 * self.text) + self.gap if self.labelled else 0)

    @property
    def top(self) -> int:
        return round(1.5 * self.gap + 3.5 * self.text) + self.line * self.heads

    def corner(self, column: int, row: int) -> tuple[int, int]:
        """The upper left corner of a cell."""
        space = self.gap + (self.gap if self.differences == "beside" else 0)
        return self.left + column * (self.column + space), self.top + row * (self.cell[1] + self.gap)

    @property
    def size(self) -> tuple[int, int]:
        x, y = self.corner(self.columns - 1, self.rows)
        return x + self.column + self.gap, y


def _grid(comparison: Comparison, width: int, height: int, text: int, where: str = "under") -> Grid:
    columns, rows = comparison.columns.values, comparison.rows.values
    differences = where if comparison.amplified and len(columns) > 1 else ""
    grid = Grid(len(columns), len(rows), width, height, text, differences, any(row.label for row in rows))
    lines = [[broken(text, grid.small, grid.column) for text, _ in _head(comparison, column)] for column in columns]
    return replace(grid, heads=max(sum(map(len, head)) for head in lines))


def _head(comparison: Comparison, column: Value) -> list[tuple[str, Color]]:
    """What stands under a column's name: the user's caption, then the formula."""
    words = [(comparison.captions.get(column.name, ""), INK), (column.formula, FAINT)]
    return [(text, color) for text, color in words if text]


def _largest(comparison: Comparison, page: tuple[int, int], text: int, ratio: float) -> Grid:
    """The grid with the largest pictures that fits a page.  ratio: of the pictures' height to their width."""
    grids = []
    for where in ("under", "beside", "stacked"):
        width = page[0]
        while width > 16:
            grid = _grid(comparison, width, max(round(width * ratio), 1), text, where)
            if grid.size[0] <= page[0] and grid.size[1] <= page[1]:
                break
            width = int(0.985 * width)
        grids.append(grid)
    return max(grids, key=lambda grid: grid.width)


# ---------------------------------------------------------------- drawing


def draw_sheet(comparison: Comparison) -> Image.Image:
    """The sheet in the comparison's layout.  A page that it does not fill has it in the middle."""
    height, width = np.max([picture.shape[:2] for picture in comparison.images.values()], axis=0).tolist()
    layout = LAYOUTS[comparison.layout]
    if layout is None:
        return _drawn(comparison, _grid(comparison, width, height, max(12, min(width, 640) // 24)))
    page, text = layout
    grid = _largest(comparison, page, text, height / width)
    if comparison.layout == "paper":  # it lies where that gives more room
        lying = _largest(comparison, page[::-1], text, height / width)
        grid, page = (lying, page[::-1]) if lying.width > grid.width else (grid, page)
    sheet = Image.new("RGB", page, PAPER)
    drawn = _drawn(comparison, grid)
    up = page[1] - drawn.height
    sheet.paste(drawn, ((page[0] - drawn.width) // 2, max(min(up // 2, 2 * text), 0)))
    return sheet


def _drawn(comparison: Comparison, grid: Grid) -> Image.Image:
    sheet = Image.new("RGB", grid.size, PAPER)
    _title(sheet, comparison, grid)
    for k, column in enumerate(comparison.columns.values):
        x, y = grid.corner(k, 0)[0], round(grid.gap + 1.9 * grid.text)
        name = fitted(column.label, 1.1 * grid.text, grid.column)[0]
        sheet.paste(name, (x + (grid.column - name.width) // 2, y))
        head = [line for text, color in _head(comparison, column)
                for line in fitted(text, grid.small, grid.column, color)]  # fmt: skip
        for number, line in enumerate(head):
            below = y + round(1.6 * grid.text) + number * grid.line
            sheet.paste(line, (x + (grid.column - line.width) // 2, below))
    for k, row in enumerate(comparison.rows.values):
        if row.label:
            label = fitted(comparison.captions.get(row.name, row.label), grid.text, grid.height)[0]
            turned = label.rotate(90, expand=True)
            sheet.paste(turned, (grid.gap, grid.corner(0, k)[1] + max(0, (grid.height - turned.height) // 2)))
        for number, column in enumerate(comparison.columns.values):
            _cell(sheet, comparison, (row.name, column.name), grid, grid.corner(number, k))
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
    """A picture, and its difference from the reference."""
    x, y = corner[0] + (grid.column - grid.cell[0]) // 2, corner[1]
    cell, box = comparison.cells[key], (grid.width, grid.height)
    if cell.pixels is None:
        ImageDraw.Draw(sheet).rectangle((x, y, x + box[0] - 1, y + box[1] - 1), EMPTY)
        _centred(sheet, fitted(cell.words, grid.small, box[0] - grid.gap, FAINT)[0], (x, y), box)
        return
    _centred(sheet, scaled(cell.pixels, *box), (x, y), box)
    if grid.differences == "beside":
        _difference(sheet, comparison, key, grid, (x + grid.width + grid.gap // 2, y))
    elif grid.differences:
        _difference(sheet, comparison, key, grid, (x, y + grid.height + grid.gap // 2))


def _centred(sheet: Image.Image, picture: Image.Image, corner: tuple[int, int], box: tuple[int, int]) -> None:
    sheet.paste(picture, (corner[0] + (box[0] - picture.width) // 2, corner[1] + (box[1] - picture.height) // 2))


def _difference(
    sheet: Image.Image, comparison: Comparison, key: tuple[str, str], grid: Grid, corner: tuple[int, int]
) -> None:
    """An amplified difference, and its numbers below it or at its right."""
    x, y = corner
    if comparison.has_difference(*key):
        picture = scaled(amplified(comparison.difference(*key), comparison.amplified), *grid.difference)
        sheet.paste(picture, (x, y))
        right = grid.differences == "under"
        x, y = (x + picture.width + grid.gap, y) if right else (x, y + picture.height + grid.gap // 2)
    for k, text in enumerate(comparison.difference_words(*key)):
        sheet.paste(fitted(text, grid.small, grid.words[0], FAINT)[0], (x, y + k * grid.line))


def scaled(pixels: Pixels, width: int, height: int) -> Image.Image:
    """A picture as large as fits width x height."""
    image = Image.fromarray(np.ascontiguousarray(pixels))
    factor = min(width / image.width, height / image.height)
    size = max(round(image.width * factor), 1), max(round(image.height * factor), 1)
    return image if size == image.size else image.resize(size, Image.Resampling.LANCZOS)
