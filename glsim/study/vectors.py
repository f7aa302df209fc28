"""The vectors of the illumination equation, N, L, R, H and V, drawn into the picture at a probed pixel."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim import shading
from glsim.machine.frame import Draw, Frame
from glsim.machine.stage import window
from glsim.pictures import FAINT, INK, PAPER
from glsim.play.frames import frame_of
from glsim.render.context import drawn
from glsim.study.overlay import Overlay, Place
from glsim.study.probe import Evaluation, Fragment, LightTerms, Probe
from glsim.study.prober import Prober

if TYPE_CHECKING:
    from PIL import Image

Float = NDArray[np.float64]
# Okabe & Ito's colours, as in glsim.plots
COLORS = {"N": INK, "L": (230, 159, 0), "R": (0, 114, 178), "H": (204, 90, 160), "V": (0, 140, 100)}
SMALLEST = 480  # pixels: smaller pictures are enlarged
PANEL = 330  # pixels: width of the panel beside the picture
LONG = 0.24  # length of the vectors, as a share of the picture


def vectors(
    what: Any, x: int, y: int, *, light: int | None = None, length: float = LONG, panel: bool = True, **options: Any
) -> Image.Image:
    """The picture of ``what`` with the unit vectors N, L, R, H and V as arrows at the point that the pixel shows.

    what: a Frame, a drawing function, a scene, a mesh file or a program: what glsim.probe takes, with its options.
    x, y: pixel from the upper left.  light: number of the light that R, H and the panel belong to (None: the one that
    adds most); L is drawn for every light.  length: that a vector seen from the side has, as a share of the picture's
    smaller side.  panel: the same vectors in the plane of N and L, with their angles, on the right.
    Where the equation runs at the vertices (Gouraud and flat shading), the vectors stand at the vertex of the largest
    weight, and the other vertices show their N.  An arrow that points at the eye is a ring with a dot.

    Raises ValueError where no lit surface is seen, or for a light that is not on.

    Example: ``glsim.vectors("sphere", 240, 200, light=0).save("vectors.png")``
    """
    if not 0.02 <= length <= 1.0:
        raise ValueError(f"vectors: length must be in [0.02, 1], a share of the picture, not {length}")
    frame: Frame = frame_of(what, **options)
    prober = Prober(frame)
    try:
        probe = prober.at(x, y)
    finally:
        prober.release()
    fragment = _lit_surface(probe)
    chosen = max(fragment.evaluations, key=lambda evaluation: evaluation.weight)
    terms = _light(chosen, light)
    from PIL import Image

    picture = Image.fromarray(np.ascontiguousarray(drawn(frame)[..., :3]))
    factor = max(1, -(-SMALLEST // min(picture.size)))
    if factor > 1:
        from PIL.Image import Resampling

        picture = picture.resize((picture.width * factor, picture.height * factor), Resampling.NEAREST)
    overlay = Overlay(picture)
    draw = frame.packets[fragment.packet]
    assert isinstance(draw, Draw)
    view = _View(draw, frame.height, factor, length * min(picture.size))
    _draw_vectors(overlay, view, probe, fragment, chosen, terms)
    image = overlay.image()
    return _beside(image, _panel(probe, fragment, chosen, terms)) if panel else image


def _lit_surface(probe: Probe) -> Fragment:
    """The fragment that is seen at a pixel.  Raises ValueError if it is no lit surface."""
    fragment, at = probe.winner, f"vectors: at ({probe.x}, {probe.y})"
    if fragment is None:
        raise ValueError(f"{at} only the background is seen; choose a pixel of a lit surface")
    if len(fragment.vertices) != 3:
        raise ValueError(f"{at} a {fragment.what.split()[0]} is seen; choose a pixel of a lit surface")
    if not fragment.evaluations:
        raise ValueError(f"{at} the surface is not lit, so there are no vectors; glEnable(GL_LIGHTING) would light it")
    return fragment


def _light(evaluation: Evaluation, number: int | None) -> LightTerms:
    """The terms of one light; of the one that adds most if number is None."""
    numbers = [terms.light for terms in evaluation.lights]
    if not numbers:
        raise ValueError("vectors: no light is on, so there is no L; glEnable(GL_LIGHT0) would switch one on")
    if number is None:
        return max(evaluation.lights, key=lambda terms: sum(terms.ambient) + sum(terms.diffuse) + sum(terms.specular))
    if number not in numbers:
        raise ValueError(f"vectors: light {number} is not on; lights that are: {', '.join(map(str, numbers))}")
    return evaluation.lights[numbers.index(number)]


@dataclass(frozen=True)
class _View:
    """From eye space to pixels of the enlarged picture.  pixels: how long a unit vector seen from the side becomes."""

    draw: Draw
    height: int
    factor: int
    pixels: float

    def clip(self, P: ArrayLike) -> Float:
        return np.asarray(np.append(np.asarray(P, float), 1.0) @ self.draw.matrices[1].get().astype(float))

    def at(self, P: ArrayLike) -> Place:
        x, y = window(self.clip(P)[None], self.draw.state.viewport)[0, :2]
        return float(x) * self.factor, (self.height - float(y)) * self.factor

    def scale(self, P: ArrayLike) -> float:
        """The length in eye space that appears ``pixels`` long at P, seen from the side."""
        P = np.asarray(P, float)
        w = abs(float(self.clip(P)[3]))
        step = 1e-3 * max(w, 1e-3)
        here = np.array(self.at(P))
        moved = [float(np.linalg.norm(np.array(self.at(P + step * axis)) - here)) for axis in np.eye(3)[:2]]
        return float(self.pixels * step / max(*moved, 1e-12))

    def tip(self, P: ArrayLike, direction: ArrayLike) -> Place:
        """The end of the arrow of a unit vector at P; shorter where it would come too near to the eye."""
        P, direction, scale = np.asarray(P, float), np.asarray(direction, float), self.scale(P)
        w = self.clip(P)[3]
        while self.clip(P + scale * direction)[3] < 0.4 * w and scale > 1e-9:
            scale *= 0.8
        return self.at(P + scale * direction)


def _draw_vectors(
    overlay: Overlay, view: _View, probe: Probe, fragment: Fragment, chosen: Evaluation, light: LightTerms
) -> None:
    if chosen.at != "fragment":  # the triangle, and where in it the pixel is
        corners = [view.at(np.array(v.eye[:3]) / v.eye[3]) for v in fragment.vertices]
        overlay.line([*corners, corners[0]], FAINT, 1.6)
        wide = max(float(np.hypot(*np.subtract(a, b))) for a, b in pairwise(corners)) > 60.0
        for other in fragment.evaluations if wide else ():
            if other is not chosen:
                _arrow(overlay, view, other.P, shading.normalize(other.N), "N", "", 2.2)
        middle = ((probe.x + 0.5) * view.factor, (probe.y + 0.5) * view.factor)
        overlay.disc(middle, 3.5, (255, 255, 255))
        overlay.ring(middle, 6.0, INK, 2.0)
    several = len(chosen.lights) > 1
    for terms in chosen.lights:
        if terms is not light:
            _arrow(overlay, view, chosen.P, terms.L, "L", f"L{terms.light}", 2.4)
    N, L, V = shading.normalize(chosen.N), light.L, light.V
    for name, direction in (
        ("R", shading.reflection(N, L)), ("H", shading.halfway(L, V)), ("V", V), ("L", L), ("N", N),
    ):  # fmt: skip
        _arrow(overlay, view, chosen.P, direction, name, f"L{light.light}" if several and name == "L" else name, 3.4)
    overlay.disc(view.at(chosen.P), 4.5, INK)


def _arrow(
    overlay: Overlay, view: _View, P: ArrayLike, direction: ArrayLike, kind: str, label: str, width: float
) -> None:
    end = view.tip(P, direction)
    overlay.arrow(view.at(P), end, COLORS[kind], width)
    if label:
        overlay.label(label, end, COLORS[kind], 22.0)


# ---------------------------------------------------------------- the panel


def _panel(probe: Probe, fragment: Fragment, chosen: Evaluation, light: LightTerms) -> Image.Image:
    """The vectors in the plane of N and L, and their angles."""
    from PIL import Image, ImageDraw, ImageFont

    sheet = Image.new("RGB", (PANEL, 560), PAPER)
    sheet.paste(_side_view(chosen, light), (0, 40))
    pen, font, small = ImageDraw.Draw(sheet), ImageFont.load_default(17), ImageFont.load_default(14)
    pen.text((16, 12), f"pixel ({probe.x}, {probe.y}), light {light.light}", INK, font)
    y = 316
    for color, text in _angles(chosen, light):
        pen.rectangle((16, y + 5, 30, y + 15), color)
        pen.text((38, y), text, INK, small)
        y += 22
    y += 6
    for text in (_where(fragment, chosen), *_remarks(chosen, light)):
        for line in _wrapped(text, small, PANEL - 30):
            pen.text((16, y), line, FAINT, small)
            y += 19
    pen.rectangle((16, y + 8, 40, y + 28), probe.pixel[:3], FAINT)
    pen.text((48, y + 9), f"the pixel: {probe.pixel[:3]}", INK, small)
    return sheet.crop((0, 0, PANEL, max(y + 44, 480)))


def degrees(a: ArrayLike, b: ArrayLike) -> float:
    """The angle between two unit vectors (3,), in degrees."""
    return float(np.degrees(np.arccos(np.clip(np.dot(np.asarray(a, float), np.asarray(b, float)), -1.0, 1.0))))


def _angles(chosen: Evaluation, light: LightTerms) -> list[tuple[tuple[int, int, int], str]]:
    N, L, V = shading.normalize(chosen.N), np.array(light.L), np.array(light.V)
    R, H = shading.reflection(N, L), shading.halfway(L, V)
    rows = [("L", "theta, N and L", "N·L", N, L), ("R", "phi, R and V", "R·V", R, V), ("H", "N and H", "N·H", N, H),
            ("V", "N and V", "N·V", N, V)]  # fmt: skip
    return [
        (COLORS[name], f"{words}: {degrees(a, b):.1f}°,  {product} = {a @ b:.3f}")
        for name, words, product, a, b in rows
    ]


def _where(fragment: Fragment, chosen: Evaluation) -> str:
    if chosen.at == "fragment":
        return "Phong shading: evaluated at this pixel, with the interpolated normal."
    if len(fragment.evaluations) == 1:
        return (
            f"Flat shading: evaluated at the provoking vertex, {chosen.at}, where the arrows are. The ring: the pixel."
        )
    return (
        f"Gouraud shading: evaluated at each vertex; the arrows are at {chosen.at}, whose weight is "
        f"{chosen.weight:.2f}. The ring is the pixel."
    )


def _remarks(chosen: Evaluation, light: LightTerms) -> list[str]:
    """What a student should know about these vectors."""
    lobe = "Phong's (R·V)" if light.vector == "R" else "Blinn's (N·H)"
    remarks = [f"The highlight is {lobe} to the power of {chosen.n:.3g}."]
    if not any(chosen.k_s):
        remarks = ["k_s = 0: the material has no highlight."]
    length = float(np.linalg.norm(chosen.N))
    if abs(length - 1.0) > 1e-3:
        remarks.append(f"N is not of unit length: |N| = {length:.3f}; here it is drawn as if it were.")
    N, L, V = shading.normalize(chosen.N), np.array(light.L), np.array(light.V)
    out = float(np.degrees(np.arcsin(np.clip(abs(V @ np.cross(N, _across(N, L, V))), 0.0, 1.0))))
    if out > 2.0:
        remarks.append(f"V leaves the plane of N and L by {out:.0f}°.")
    if light.N_L < 0.0:
        remarks.append("N·L < 0: the light is behind the surface.")
    return remarks


def _across(N: Float, L: Float, V: Float) -> Float:
    """The direction across N in the plane of N and L, away from L; of N and V if N is L, and zeros if all are one."""
    side = -L if np.linalg.norm(np.cross(N, L)) > 1e-6 else V
    return np.asarray(shading.normalize(side - (side @ N) * N))


def _side_view(chosen: Evaluation, light: LightTerms) -> Image.Image:
    """N upwards, L to the left; R, H and V as they appear in the plane of N and L."""
    from PIL import Image

    N, L, V = shading.normalize(chosen.N), np.array(light.L), np.array(light.V)
    across = _across(N, L, V)
    long, x, y = 132.0, PANEL / 2.0, 198.0 if light.N_L >= 0.0 else 148.0
    overlay = Overlay(Image.new("RGB", (PANEL, 270), PAPER))
    overlay.line([(24.0, y), (PANEL - 24.0, y)], FAINT, 2.0)

    def place(vector: Float) -> Place:
        return float(x + long * (vector @ across)), float(y - long * (vector @ N))

    for name, vector in (("R", shading.reflection(N, L)), ("H", shading.halfway(L, V)), ("V", V), ("L", L), ("N", N)):
        overlay.arrow((x, y), place(vector), COLORS[name], 3.0)
        overlay.label(name, place(vector), COLORS[name], 20.0)
    return overlay.image()


def _wrapped(text: str, font: Any, width: float) -> list[str]:
    """Lines of a text that are at most ``width`` pixels wide."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and font.getlength(longer) > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def _beside(image: Image.Image, panel: Image.Image) -> Image.Image:
    """Picture and panel side by side on paper."""
    from PIL import Image as Images

    sheet = Images.new("RGB", (image.width + panel.width, max(image.height, panel.height)), PAPER)
    sheet.paste(image, (0, (sheet.height - image.height) // 2))
    sheet.paste(panel, (image.width, 0))
    return sheet
