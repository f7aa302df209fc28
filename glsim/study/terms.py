"""The picture taken apart: the summands of the illumination equation as images that add up."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glsim.files import write_atomically
from glsim.machine.constants import GL_PHONG_LOBE_GLSIM
from glsim.machine.frame import Frame
from glsim.play.frames import frame_of
from glsim.render.context import own_screen
from glsim.render.inspect import GBuffer, Inspector, Piece
from glsim.shading import normalize
from glsim.study.fragments import Shaded, shade

if TYPE_CHECKING:
    from PIL import Image

Float = NDArray[np.float64]


@dataclass
class Terms:
    """Images of (height, width, ...), top row first, float64.

    picture: the rendered picture, (height, width, 4) uint8.  summands: name -> (height, width, 3), not clamped:
    "emission", "scene ambient", "light 0 ambient", "light 0 diffuse", "light 0 specular", ..., and "unlit", the colour
    of fragments without lighting.  Each pixel has the terms of the last fragment written, before texture.
    normal: unit normals in eye space, (height, width, 3).  depth: (height, width) in [0, 1].
    N_L, cosine: number of the light -> (height, width); cosine is N.H or R.V.
    covered, lit, clamped: (height, width) bool: whether a fragment was drawn, whether it was lit, and whether clamping
    to [0, 1] changed the sum of its terms.
    vector: "H" or "R", the lobe of the lit pixels that were evaluated last.
    later_stages: those of "texture", "fog" and "blending" that the frame uses; the terms leave them out.
    """

    picture: NDArray[np.uint8]
    depth: NDArray[np.float32]
    covered: NDArray[np.bool_]
    lit: NDArray[np.bool_]
    clamped: NDArray[np.bool_]
    normal: Float
    summands: dict[str, Float] = field(default_factory=dict)
    N_L: dict[int, Float] = field(default_factory=dict)
    cosine: dict[int, Float] = field(default_factory=dict)
    vector: str = "H"
    later_stages: tuple[str, ...] = ()

    def __repr__(self) -> str:
        (height, width), lights = self.depth.shape, ", ".join(map(str, self.lights)) or "none"
        counts = f"{self.covered.sum()} pixels covered, {self.lit.sum()} lit, {self.clamped.sum()} clamped"
        return f"<Terms {width} x {height}: {counts}, lights {lights}>"

    @property
    def sum(self) -> Float:
        """All summands together, not clamped: (height, width, 3)."""
        return np.asarray(sum(self.summands.values(), np.zeros_like(self.normal)))

    @property
    def lights(self) -> list[int]:
        return sorted(self.N_L)

    def statistics(self) -> dict[str, Any]:
        """For each summand its mean and largest value over the covered pixels, and how many pixels were clamped."""
        covered = self.covered if self.covered.any() else np.ones_like(self.covered)
        means = {name: image[covered].mean(axis=0).round(6).tolist() for name, image in self.summands.items()}
        largest = {name: round(float(image[covered].max()), 6) for name, image in self.summands.items()}
        return {
            "pixels": int(self.covered.sum()), "lit": int(self.lit.sum()), "clamped": int(self.clamped.sum()),
            "mean": means, "largest": largest,
        }  # fmt: skip

    @property
    def sheet(self) -> Image.Image:
        """All images, labelled."""
        return terms_sheet(self)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the sheet; the file's ending says the format."""
        sheet = self.sheet
        write_atomically(path, lambda name: sheet.save(name))

    def _repr_png_(self) -> bytes | None:
        return self.sheet._repr_png_()


def terms(what: Any, **options: Any) -> Terms:
    """Take the picture of ``what`` apart.

    what: a Frame (glsim.capture), or anything else that play.frames.frame_of takes, with its options.
    """
    frame: Frame = frame_of(what, **options)
    with own_screen(frame.width, frame.height) as screen:
        g_buffer = Inspector(screen).g_buffer(frame.packets)
        picture = screen.pixels()
    return taken_apart(g_buffer, picture)


def taken_apart(g_buffer: GBuffer, picture: NDArray[np.uint8]) -> Terms:
    shape = g_buffer.piece.shape
    no: NDArray[np.bool_] = np.zeros(shape, bool)
    result = Terms(picture, g_buffer.depth, g_buffer.piece >= 0, no.copy(), no.copy(), np.zeros((*shape, 3)))
    for name in ("emission", "scene ambient"):
        result.summands[name] = np.zeros((*shape, 3))
    order = np.flatnonzero(result.covered)
    if not len(order):
        return result
    groups = g_buffer.piece.ravel()[order] * 2 + g_buffer.front.ravel()[order]
    order = order[np.argsort(groups, kind="stable")]
    groups = np.sort(groups, kind="stable")
    starts = np.flatnonzero(np.diff(groups, prepend=-1))
    result.later_stages = _later_stages(g_buffer)
    for start, end in zip(starts, [*starts[1:], len(order)], strict=True):
        at = np.unravel_index(order[start:end], shape)
        piece = g_buffer.pieces[int(groups[start]) // 2]
        lit = shade(piece, g_buffer.primitive[at], g_buffer.weights[at], back=not groups[start] % 2)
        _add(result, at, piece, lit)
    return result


def _later_stages(g_buffer: GBuffer) -> tuple[str, ...]:
    """The stages after lighting that some piece uses; the summands leave them out."""
    states = [piece.draw.state for piece in g_buffer.pieces]
    used = {
        "texture": any(state.texture.in_use for state in states),
        "fog": any(state.fog.enabled for state in states),
        "blending": any(state.color_buffer.blend for state in states),
    }
    return tuple(name for name, is_used in used.items() if is_used)


def _add(result: Terms, at: Any, piece: Piece, lit: Shaded) -> None:
    """Write the terms of one piece into the images.  at: index arrays (rows, columns) of its n pixels."""

    def put(images: dict[Any, Float], name: Any, values: Float) -> None:
        values = lit.spread(values) if lit.terms is not None else values
        if name not in images:
            images[name] = np.zeros(result.normal.shape[: 2 if values.shape[1] == 1 else 3])
        images[name][at] = values[:, 0] if values.shape[1] == 1 else values

    result.normal[at] = normalize(lit.N)
    if lit.terms is None:
        put(result.summands, "unlit", lit.primary[:, :3])
        return
    result.lit[at] = True
    changed = np.abs(lit.spread(lit.terms.sum) - (lit.primary[:, :3] + lit.highlight)) > 0.5 / 255.0
    result.clamped[at] = np.any(changed, axis=1)
    put(result.summands, "emission", lit.terms.emission)
    put(result.summands, "scene ambient", lit.terms.ambient)
    lighting = piece.draw.state.lighting
    result.vector = "R" if lighting.lobe == GL_PHONG_LOBE_GLSIM else "H"
    numbers = [number for number, on in enumerate(lighting.light_enabled) if on]
    for number, light in zip(numbers, lit.terms.lights, strict=True):
        for name in ("ambient", "diffuse", "specular"):
            put(result.summands, f"light {number} {name}", getattr(light, name))
        put(result.N_L, number, light.N_L)
        put(result.cosine, number, light.cosine)


def terms_sheet(terms: Terms) -> Image.Image:
    """The sheet: a row for the picture as a whole, a row for the terms without light, and a row for each light."""
    from glsim.pictures import DARK_GREY, OFF_WHITE, heat, tiles

    covered = terms.covered

    def color(image: NDArray[np.float64]) -> NDArray[np.uint8]:
        return np.asarray(np.clip(image, 0.0, 1.0) * 255.0 + 0.5, np.uint8)

    seen = terms.depth[covered]
    near, far = (float(seen.min()), float(seen.max())) if seen.size else (0.0, 1.0)
    depth = (terms.depth.astype(float) - near) / max(far - near, 1e-12)
    normals = np.where(covered[..., None], 0.5 + 0.5 * terms.normal, np.array(OFF_WHITE) / 255.0)
    mask = np.where(terms.clamped[..., None], [255, 60, 30], np.where(covered[..., None], DARK_GREY, OFF_WHITE))
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
    if terms.later_stages:
        title += f".   {', '.join(terms.later_stages).capitalize()} of the picture come later and are not in the terms."
    return tiles(title, rows)
