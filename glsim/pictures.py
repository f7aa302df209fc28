"""Laying out pictures on paper: labels, tiles in rows, numbers as colours."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

PAPER, INK, FAINT = (250, 250, 248), (30, 32, 38), (110, 114, 124)
TILE = 288  # pixels, the larger side
SCALE = np.array([(68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 201, 98), (253, 231, 37)], float)
DARK_GREY, OFF_WHITE = (60, 60, 70), (235, 235, 232)


def heat(values: NDArray[np.float64], covered: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Values (height, width) as RGB (height, width, 3): [0, 1] from violet to yellow, negative values dark grey.

    covered: (height, width); pixels outside become nearly white."""
    places = np.linspace(0.0, 1.0, len(SCALE))
    colors = np.stack([np.interp(values, places, SCALE[:, channel]) for channel in range(3)], axis=-1)
    colors[values < 0.0] = DARK_GREY
    colors[~covered] = OFF_WHITE
    return np.asarray(colors, np.uint8)


def tiles(title: str, rows: Sequence[Sequence[tuple[str, NDArray[np.uint8]]]], tile: int = TILE) -> Image.Image:
    """Labelled pictures in rows; tile: their larger side in pixels, at most."""
    height, width = rows[0][0][1].shape[:2]
    factor = min(1.0, tile / max(height, width)) if max(height, width) > tile else max(1, tile // max(height, width))
    size = round(width * factor), round(height * factor)
    gap, line = 8, 20
    columns = max(map(len, rows))
    sheet = Image.new("RGB", (gap + columns * (size[0] + gap), line + gap + len(rows) * (size[1] + line + gap)), PAPER)
    pen, font, small = ImageDraw.Draw(sheet), ImageFont.load_default(13), ImageFont.load_default(12)
    pen.text((gap, gap // 2), title, INK, font)
    method = Image.Resampling.LANCZOS if factor < 1 else Image.Resampling.NEAREST
    for number, row in enumerate(rows):
        y = line + gap + number * (size[1] + line + gap)
        for column, (label, image) in enumerate(row):
            x = gap + column * (size[0] + gap)
            pen.text((x, y), label, INK, small)
            sheet.paste(Image.fromarray(np.ascontiguousarray(image)).resize(size, method), (x, y + line))
    return sheet


def upright(
    sheet: Image.Image, words: str, font: ImageFont.FreeTypeFont | ImageFont.ImageFont, color: tuple[int, int, int],
    corner: tuple[int, int], height: int,
) -> None:  # fmt: skip
    """Text that runs upwards, centred beside a picture."""
    box = font.getbbox(words)
    label = Image.new("RGB", (int(box[2]) + 2, int(box[3]) + 4), PAPER)
    ImageDraw.Draw(label).text((0, 0), words, color, font)
    turned = label.rotate(90, expand=True)
    sheet.paste(turned, (corner[0], corner[1] + max(0, (height - turned.height) // 2)))
