"""Pictures of the numbers: how the residual falls, the matrix of form factors, and one of its rows on the scene."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from glsim.pictures import INK, PAPER, upright
from glsim.radiosity.solvers import SolverStep
from glsim.radiosity.tone import GAMMA

GRID = (215, 215, 212)
SCALE = 108  # pixels for a scale of brightness beside a picture
COLORS = ((200, 60, 40), (40, 90, 200), (30, 140, 80), (160, 90, 180), (210, 140, 20), (90, 90, 90))


def convergence(series: dict[str, Sequence[SolverStep]], size: tuple[int, int] = (720, 440)) -> Image.Image:
    """Draw the residual over the iterations, logarithmically, with a line for each solver's steps."""
    picture = Image.new("RGB", size, PAPER)
    pen, font = ImageDraw.Draw(picture), ImageFont.load_default(13)
    left, top, right, bottom = 64, 28, size[0] - 16, size[1] - 44
    lowest = min((max(step.residual, 1e-16) for steps in series.values() for step in steps), default=1e-6)
    decades = max(1, int(np.ceil(-np.log10(lowest))))
    most = max(max((step.iteration for step in steps), default=1) for steps in series.values()) or 1

    def at(iteration: float, residual: float) -> tuple[float, float]:
        y = top + (bottom - top) * min(max(-np.log10(max(residual, 1e-16)) / decades, 0.0), 1.0)
        return left + (right - left) * iteration / most, float(y)

    for decade in range(decades + 1):
        y = at(0, 10.0**-decade)[1]
        pen.line([(left, y), (right, y)], GRID)
        pen.text((left - 8, y), f"{10.0**-decade:g}", INK, font, anchor="rm")
    for k in range(0, most + 1, _step(most)):
        pen.text((at(k, 1.0)[0], bottom + 8), str(k), INK, font, anchor="ma")
    pen.text(((left + right) / 2, bottom + 24), "iteration", INK, font, anchor="ma")
    pen.text((left, 4), "residual: |E - (I - R F) B| / |E|, of the worst channel", INK, font)
    for number, (name, steps) in enumerate(series.items()):
        color = COLORS[number % len(COLORS)]
        points = [at(step.iteration, step.residual) for step in steps]
        if len(points) > 1:
            pen.line(points, color, 2)
        for x, y in points if len(points) < 60 else points[:1]:
            pen.ellipse([x - 2, y - 2, x + 2, y + 2], color)
        pen.text((right - 4, top + 4 + 18 * number), name, color, font, anchor="ra")
    return picture


def matrix(F: NDArray[np.float64], size: int = 640) -> Image.Image:
    """Draw form factors (n, n) as brightness, logarithmically over four decades, row 0 on top.

    size: pixels of the matrix; the numbers of its rows and columns and the scale of brightness stand beside it.
    """
    largest = float(F.max()) or 1.0
    shades = 1.0 + np.log10(np.maximum(F / largest, 1e-4)) / 4.0
    image = Image.fromarray(np.asarray(shades * 255.0, np.uint8))
    cells = image.resize((size, size), Image.Resampling.NEAREST if len(F) < size else Image.Resampling.BOX)
    left, top = 64, 52
    sheet = Image.new("RGB", (left + size + SCALE, top + size + 34), PAPER)
    sheet.paste(cells, (left, top))
    pen, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    for k in range(0, len(F), _step(len(F))):
        middle = (k + 0.5) * size / len(F)
        pen.text((left - 6, top + middle), str(k), INK, font, anchor="rm")
        pen.text((left + middle, top - 5), str(k), INK, font, anchor="ms")
    pen.text((left + size / 2, 14), "patch j, which receives", INK, font, anchor="mm")
    upright(sheet, "patch i, which sends", font, INK, (6, top), size)
    pen.text((left, top + size + 10), "F: the share of what leaves i that arrives at j", INK, font)
    shown = np.linspace(1.0, 0.0, size)
    ticks = [(decade / 4.0, f"{largest * 10.0**-decade:.2g}") for decade in range(5)]
    _scale(sheet, (left + size + 16, top), shown, ticks, "F")
    return sheet


def on_scene(picture: Image.Image, patch: int, bright: float) -> Image.Image:
    """Return the picture of row ``patch`` of the form factors on the scene, with its title and its scale.

    bright: the form factor per unit of area that is white; smaller ones are shown with the power 1 / GAMMA.
    """
    size, top = picture.size[1], 44
    sheet = Image.new("RGB", (picture.size[0] + SCALE, top + size + 12), PAPER)
    sheet.paste(picture, (0, top))
    pen, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    pen.text((8, 6), f"where the light of patch i = {patch} (orange) arrives:", INK, font)
    pen.text((8, 24), "F / A, the share for each unit of area", INK, font)
    shares = (1.0, 0.5, 0.25, 0.1, 0.0)
    ticks = [(1.0 - share ** (1.0 / GAMMA), f"{share * bright:.2g}") for share in shares]
    _scale(sheet, (picture.size[0] + 16, top), np.linspace(1.0, 0.0, size), ticks, "F / A")
    return sheet


def _scale(
    sheet: Image.Image,
    corner: tuple[int, int],
    shown: NDArray[np.float64],
    ticks: Sequence[tuple[float, str]],
    name: str,
) -> None:
    """Draw a bar of greys (height,) in [0, 1], from above, with its name, and numbers at parts of its height."""
    (x, top), size, bar = corner, len(shown), 16
    pen, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    sheet.paste(Image.fromarray(np.repeat(shown[:, None] * 255.0, bar, axis=1).astype(np.uint8)), (x, top))
    pen.rectangle((x - 1, top - 1, x + bar, top + size), outline=INK)
    pen.text((x + bar / 2, top - 5), name, INK, font, anchor="ms")
    for part, text in ticks:
        pen.text((x + bar + 6, top + part * (size - 1)), text, INK, font, anchor="lm")


def _step(n: int) -> int:
    """The distance of the numbers that are written at n rows: 1, 2 or 5 times a power of ten, at most 12 of them."""
    return int(next(k * 10**power for power in range(9) for k in (1, 2, 5) if n <= 12 * k * 10**power))
