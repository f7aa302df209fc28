"""Laying out a Comparison as one labelled picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw, ImageFont

if TYPE_CHECKING:
    from glsim.study.compare import Comparison

PAPER, INK, FAINT = (250, 250, 248), (30, 32, 38), (110, 114, 124)


def draw_sheet(comparison: Comparison) -> Image.Image:
    """Columns: modes.  Rows: for each lobe the pictures, then their amplified differences from the first mode."""
    from glsim.study.compare import AMPLIFIED, LOBES, MODES

    first = next(iter(comparison.images.values()))
    height, width = first.shape[:2]
    text = max(11, min(width, 512) // 22)
    gap, line = text // 2, round(text * 1.5)
    font, small = ImageFont.load_default(text), ImageFont.load_default(max(10, round(text * 0.8)))
    left, top = line + gap, 2 * line + gap
    columns, lobes = len(comparison.modes), comparison.lobes
    differences = columns > 1
    block = height + gap + (height + line + gap if differences else 0)
    size = (left + columns * (width + gap), top + len(lobes) * block)
    sheet = Image.new("RGB", size, PAPER)
    pen = ImageDraw.Draw(sheet)
    pen.text((left, gap // 2), comparison.title, INK, font)
    for column, mode in enumerate(comparison.modes):
        pen.text((left + column * (width + gap) + width // 2, line + gap // 2), MODES[mode], INK, font, anchor="ma")
    for row, lobe in enumerate(lobes):
        y = top + row * block
        _upright(sheet, LOBES[lobe], font, INK, (gap // 2, y), height)
        for column, mode in enumerate(comparison.modes):
            x = left + column * (width + gap)
            if (lobe, mode) not in comparison.images:
                words = "fixed function has (N·H)^n only"
                pen.text((x + width // 2, y + height // 2), words, FAINT, small, anchor="mm")
                continue
            sheet.paste(Image.fromarray(comparison.images[lobe, mode]), (x, y))
            if differences:
                d = comparison.difference(lobe, mode)
                amplified = np.minimum(d * AMPLIFIED, 255).astype(np.uint8)
                sheet.paste(Image.fromarray(amplified), (x, y + height + gap))
                words = "reference" if column == 0 else f"max {d.max()}   mean {d.mean():.2f}"
                pen.text((x + width // 2, y + 2 * height + gap + gap // 3), words, FAINT, small, anchor="ma")
        if differences:
            words = f"difference, {AMPLIFIED} times amplified"
            _upright(sheet, words, small, FAINT, (gap // 2, y + height + gap), height)
    return sheet


def _upright(
    sheet: Image.Image, words: str, font: ImageFont.FreeTypeFont | ImageFont.ImageFont, color: tuple[int, int, int],
    corner: tuple[int, int], height: int,
) -> None:  # fmt: skip
    """Text that runs upwards, centred beside a picture."""
    box = font.getbbox(words)
    label = Image.new("RGB", (int(box[2]) + 2, int(box[3]) + 4), PAPER)
    ImageDraw.Draw(label).text((0, 0), words, color, font)
    turned = label.rotate(90, expand=True)
    sheet.paste(turned, (corner[0], corner[1] + max(0, (height - turned.height) // 2)))
