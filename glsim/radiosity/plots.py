"""Pictures of the numbers: how the residual falls, and the matrix of form factors."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from glsim.radiosity.solvers import SolverStep

PAPER, INK, GRID = (250, 250, 248), (30, 32, 38), (215, 215, 212)
COLORS = ((200, 60, 40), (40, 90, 200), (30, 140, 80), (160, 90, 180), (210, 140, 20), (90, 90, 90))


def convergence(series: dict[str, Sequence[SolverStep]], size: tuple[int, int] = (720, 440)) -> Image.Image:
    """Draw the residual over the iterations, logarithmically, with a line for each solver's steps."""
    picture = Image.new("RGB", size, PAPER)
    pen, font = ImageDraw.Draw(picture), ImageFont.load_default(13)
    left, top, right, bottom = 64, 24, size[0] - 16, size[1] - 44
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
    for k in range(5):
        pen.text((left + (right - left) * k / 4, bottom + 8), f"{most * k / 4:g}", INK, font, anchor="ma")
    pen.text(((left + right) / 2, bottom + 24), "iteration", INK, font, anchor="ma")
    pen.text((left, 4), "residual", INK, font)
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
    left, top, bar = 64, 52, 16
    sheet = Image.new("RGB", (left + size + 3 * bar + 60, top + size + 20), PAPER)
    sheet.paste(cells, (left, top))
    pen, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    for k in range(0, len(F), _step(len(F))):
        middle = (k + 0.5) * size / len(F)
        pen.text((left - 6, top + middle), str(k), INK, font, anchor="rm")
        pen.text((left + middle, top - 5), str(k), INK, font, anchor="ms")
    pen.text((left + size / 2, 14), "patch j, which receives", INK, font, anchor="mm")
    name = Image.new("RGB", (200, 18), PAPER)
    ImageDraw.Draw(name).text((100, 9), "patch i, which sends", INK, font, anchor="mm")
    sheet.paste(name.rotate(90, expand=True), (4, top + size // 2 - 100))
    x = left + size + bar
    scale = np.repeat(np.linspace(255, 0, size)[:, None], bar, axis=1).astype(np.uint8)
    sheet.paste(Image.fromarray(scale), (x, top))
    pen.rectangle((x - 1, top - 1, x + bar, top + size), outline=INK)
    pen.text((x + bar / 2, top - 5), "F", INK, font, anchor="ms")
    for decade in range(5):
        text = f"{largest * 10.0**-decade:.2g}"
        pen.text((x + bar + 6, top + decade * (size - 1) / 4), text, INK, font, anchor="lm")
    return sheet


def _step(n: int) -> int:
    """The distance of the numbers that are written at n rows: 1, 2 or 5 times a power of ten, at most 12 of them."""
    return int(next(k * 10**power for power in range(9) for k in (1, 2, 5) if n <= 12 * k * 10**power))
