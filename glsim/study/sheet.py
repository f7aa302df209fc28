"""Laying out a Comparison, or the terms of a picture, as one labelled picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

if TYPE_CHECKING:
    from glsim.study.compare import Comparison
    from glsim.study.terms import Terms

PAPER, INK, FAINT = (250, 250, 248), (30, 32, 38), (110, 114, 124)


def draw_sheet(comparison: Comparison) -> Image.Image:
    """Columns: modes.  Rows: for each lobe the pictures, then their amplified differences from the first mode."""
    from glsim.study.compare import AMPLIFIED, MODES, ROWS

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
        _upright(sheet, ROWS[lobe], font, INK, (gap // 2, y), height)
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


# ---------------------------------------------------------------- the terms of a picture

TILE = 288  # pixels, the larger side
SCALE = np.array([(68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 201, 98), (253, 231, 37)], float)
BEHIND, NOTHING = (60, 60, 70), (235, 235, 232)


def heat(values: NDArray[np.float64], covered: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """[0, 1] from violet to yellow; negative values grey, uncovered pixels white."""
    places = np.linspace(0.0, 1.0, len(SCALE))
    colors = np.stack([np.interp(values, places, SCALE[:, channel]) for channel in range(3)], axis=-1)
    colors[values < 0.0] = BEHIND
    colors[~covered] = NOTHING
    return np.asarray(colors, np.uint8)


def terms_sheet(terms: Terms) -> Image.Image:
    """A row for the whole picture, then one for each light."""
    covered = terms.covered

    def color(image: NDArray[np.float64]) -> NDArray[np.uint8]:
        return np.asarray(np.clip(image, 0.0, 1.0) * 255.0 + 0.5, np.uint8)

    seen = terms.depth[covered]
    near, far = (float(seen.min()), float(seen.max())) if seen.size else (0.0, 1.0)
    depth = (terms.depth.astype(float) - near) / max(far - near, 1e-12)
    normals = np.where(covered[..., None], 0.5 + 0.5 * terms.normal, np.array(NOTHING) / 255.0)
    mask = np.where(terms.clamped[..., None], [255, 60, 30], np.where(covered[..., None], BEHIND, NOTHING))
    of = "N·H" if terms.vector == "H" else "R·V"
    rows: list[list[tuple[str, NDArray[np.uint8]]]] = [
        [
            ("the picture", terms.picture[..., :3]),
            ("sum of all terms", color(terms.sum)),
            (f"red: I > 1, clamped at {int(terms.clamped.sum())} pixels", mask.astype(np.uint8)),
            ("normal, (N + 1) / 2", color(normals)),
            (f"depth, {near:.4f} to {far:.4f}", heat(np.clip(depth, 0.0, 1.0), covered)),
        ],
        [
            (f"{name}, max {image.max():.3f}", color(image))
            for name, image in terms.summands.items()
            if "light" not in name
        ],
    ]
    for light in terms.lights:
        parts = {name: terms.summands[f"light {light} {name}"] for name in ("ambient", "diffuse", "specular")}
        row = [(f"light {light} {name}, max {image.max():.3f}", color(image)) for name, image in parts.items()]
        row.append((f"light {light} N·L, 0 to 1; grey: behind", heat(terms.N_L[light], terms.lit)))
        row.append((f"light {light} {of}, 0 to 1", heat(terms.cosine[light], terms.lit)))
        rows.append(row)
    title = "I = emission + k_a I_a + sum over lights of (ambient + diffuse + specular)"
    if terms.more:
        title += f".   {', '.join(terms.more).capitalize()} of the picture come later and are not in the terms."
    return tiles(title, rows)


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
