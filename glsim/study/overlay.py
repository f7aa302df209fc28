"""Arrows, lines and labels drawn over a picture so that they can be read on any background."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import atan2, cos, hypot, pi, sin
from typing import TYPE_CHECKING

from glsim.pictures import INK

if TYPE_CHECKING:
    from PIL import Image, ImageDraw

RGB = tuple[int, int, int]
Place = tuple[float, float]  # pixels from the upper left
FINE = 3  # strokes are drawn three times as large, and then made smaller: soft edges
HALO = 2.0  # pixels of white around a stroke


@dataclass
class Stroke:
    """A line along points; closed and filled if ``filled``.  width: pixels."""

    points: Sequence[Place]
    color: RGB
    width: float
    filled: bool = False


@dataclass
class Overlay:
    """Strokes and labels over a picture; ``image`` gives both together."""

    picture: Image.Image
    strokes: list[Stroke] = field(default_factory=list)
    labels: list[tuple[str, Place, RGB, float]] = field(default_factory=list)

    def line(self, points: Sequence[Place], color: RGB, width: float = 2.0) -> None:
        self.strokes.append(Stroke(points, color, width))

    def dashed(self, start: Place, end: Place, color: RGB, width: float = 2.0, dash: float = 7.0) -> None:
        length = hypot(end[0] - start[0], end[1] - start[1])
        for k in range(0, int(length / dash) + 1, 2):
            a, b = (min(t * dash / max(length, 1e-9), 1.0) for t in (k, k + 1))
            self.line([_between(start, end, a), _between(start, end, b)], color, width)

    def arrow(self, start: Place, end: Place, color: RGB, width: float = 3.2) -> None:
        """An arrow; one that is shorter than its head becomes a ring with a dot: it points at who looks."""
        length, head = hypot(end[0] - start[0], end[1] - start[1]), 4.2 * width
        if length < 0.8 * head:
            self.ring(start, 2.4 * width, color, 0.7 * width)
            self.disc(start, 0.9 * width, color)
            return
        angle = atan2(end[1] - start[1], end[0] - start[0])
        neck = _between(start, end, 1.0 - 0.8 * head / length)
        self.line([start, neck], color, width)
        wings = [(end[0] - head * cos(angle + turn), end[1] - head * sin(angle + turn)) for turn in (-0.38, 0.38)]
        self.strokes.append(Stroke([end, *wings], color, 1.0, filled=True))

    def ring(self, middle: Place, radius: float, color: RGB, width: float = 2.0) -> None:
        self.line(_circle(middle, radius), color, width)

    def disc(self, middle: Place, radius: float, color: RGB) -> None:
        self.strokes.append(Stroke(_circle(middle, radius), color, 1.0, filled=True))

    def label(self, text: str, at: Place, color: RGB = INK, size: float = 17.0) -> None:
        """Text near a place: where it hides least of the strokes and of other labels."""
        self.labels.append((text, at, color, size))

    def image(self) -> Image.Image:
        """The picture with all that was drawn."""
        from PIL import Image, ImageDraw, ImageFilter

        width, height = self.picture.size
        result = self.picture.convert("RGB")
        large = (width * FINE, height * FINE)
        ink, halo = Image.new("RGBA", large), Image.new("L", large)
        ink_pen, halo_pen = ImageDraw.Draw(ink), ImageDraw.Draw(halo)
        for stroke in self.strokes:
            _draw(halo_pen, stroke, 255, 2.0 * HALO)
        for stroke in self.strokes:
            _draw(ink_pen, stroke, (*stroke.color, 255), 0.0)
        halo, ink = (layer.resize((width, height), Image.Resampling.BOX) for layer in (halo, ink))
        shadow = halo.filter(ImageFilter.GaussianBlur(3.0)).point([int(0.45 * k) for k in range(256)])
        result.paste((0, 0, 0), (1, 2), shadow)
        result.paste((255, 255, 255), (0, 0), halo)
        result.paste(ink, (0, 0), ink.getchannel("A"))
        self._write(ImageDraw.Draw(result), (width, height))
        return result

    def _write(self, pen: ImageDraw.ImageDraw, size: tuple[int, int]) -> None:
        """Write the labels one after the other, each in the best of several places."""
        from PIL import ImageFont

        taken: list[tuple[float, float, float, float]] = []
        points = [point for stroke in self.strokes for point in _close(stroke.points)]
        for text, at, color, points_high in self.labels:
            font = ImageFont.load_default(points_high)
            left, top, right, bottom = pen.textbbox((0, 0), text, font)
            w, h = right - left + 6.0, bottom - top + 6.0

            def badness(box: tuple[float, float, float, float]) -> float:
                outside = max(0.0, -box[0], -box[1], box[2] - size[0], box[3] - size[1])
                covered = sum(box[0] < x < box[2] and box[1] < y < box[3] for x, y in points)
                return 50.0 * outside + covered + sum(_overlap(box, other) for other in taken)

            choices = []
            for distance in (12.0, 20.0, 30.0):
                for k in range(16):
                    turn = 2.0 * pi * k / 16
                    x, y = at[0] + cos(turn) * (distance + w / 2.0), at[1] + sin(turn) * (distance + h / 2.0)
                    choices.append((x - w / 2.0, y - h / 2.0, x + w / 2.0, y + h / 2.0))
            best = min(
                choices, key=lambda box: badness(box) + 0.02 * hypot(box[0] + w / 2 - at[0], box[1] + h / 2 - at[1])
            )
            taken.append(best)
            place = best[0] + 3.0 - left, best[1] + 3.0 - top
            pen.text(place, text, color, font, stroke_width=3, stroke_fill=(255, 255, 255))


def _between(start: Place, end: Place, t: float) -> Place:
    return start[0] + t * (end[0] - start[0]), start[1] + t * (end[1] - start[1])


def _circle(middle: Place, radius: float) -> list[Place]:
    angles = [2.0 * pi * k / 32 for k in range(33)]
    return [(middle[0] + radius * cos(a), middle[1] + radius * sin(a)) for a in angles]


def _close(points: Sequence[Place]) -> list[Place]:
    """Points along a line, at most six pixels apart."""
    result: list[Place] = []
    for start, end in pairwise(points):
        steps = min(int(hypot(end[0] - start[0], end[1] - start[1]) / 6.0) + 1, 500)
        result += [_between(start, end, k / steps) for k in range(steps)]
    return [*result, points[-1]]


def _overlap(a: tuple[float, float, float, float], b: tuple[float, float, float, float]) -> float:
    """The common area of two boxes, in pixels."""
    return max(0.0, min(a[2], b[2]) - max(a[0], b[0])) * max(0.0, min(a[3], b[3]) - max(a[1], b[1]))


def _draw(pen: ImageDraw.ImageDraw, stroke: Stroke, color: int | tuple[int, ...], more: float) -> None:
    """Draw a stroke, ``more`` pixels wider."""
    points = [(x * FINE, y * FINE) for x, y in stroke.points]
    width = round((stroke.width + more) * FINE)
    if stroke.filled:
        pen.polygon(points, color)
    if more or not stroke.filled:
        closed = [*points, points[0]] if stroke.filled else points
        pen.line(closed, color, width, joint="curve")
        radius = width / 2.0
        for x, y in (closed[0], closed[-1]):
            pen.ellipse((x - radius, y - radius, x + radius, y + radius), color)
