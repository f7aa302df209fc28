"""Deliberate mistakes that a snapshot test must see, and harmless differences that it must not.

``python -m tests.testing.sensitivity`` prints the table.  Each pair is judged as if another renderer had made the
baseline: with the same renderer pictures must be equal, and nothing is missed.  TINY are mistakes as small as the
rounding of another renderer, which only the renderer of the baseline can see.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from math import cos, pi, sin
from pathlib import Path
from typing import NamedTuple

import numpy as np

import glsim
from glsim.gl import *
from glsim.images import Pixels, rgba
from glsim.metrics import metrics, same_sign_blocks
from glsim.testing.baselines import Baseline
from glsim.testing.rule import judge
from glsim.testing.screens import opaque

SIZE = 256


class Pair(NamedTuple):
    expected: Pixels
    actual: Pixels


@dataclass(frozen=True)
class Ball:
    """A lit sphere in perspective; each field is something that a program can get wrong."""

    slices: int = 32
    shininess: float = 32.0
    brightness: float = 1.0
    ambient: float = 0.2
    specular: float = 0.6
    light: tuple[float, ...] = (2.0, 2.0, 3.0, 0.0)
    shade: int = GL_SMOOTH
    lobe: int = GL_BLINN_TORRANCE_GLSIM
    back: int = GL_CLAMP_NORMAL_GLSIM
    normals: float = 1.0  # their length
    flipped: int = -1  # the number of a vertex whose normal points inwards
    moved: int = -1  # the number of a vertex that lies 0.01 too far to the right
    missing: int = -1  # the number of a triangle that is not drawn
    first: int = 0  # which of a triangle's corners comes first
    backwards: bool = False  # the order of the triangles
    as_list: bool = False
    depth: bool = True
    shift: int = 0  # of the viewport, in pixels
    radius: float = 1.0

    def draw(self) -> None:
        glViewport(self.shift, 0, SIZE, SIZE)
        glMatrixMode(GL_PROJECTION)
        glFrustum(-0.4, 0.4, -0.4, 0.4, 1.0, 20.0)
        glMatrixMode(GL_MODELVIEW)
        for capability in (GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST):
            glEnable(capability)
        if not self.depth:
            glDisable(GL_DEPTH_TEST)
        glShadeModel(self.shade)
        glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, self.lobe)
        glLightModeli(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM, self.back)
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [self.ambient] * 3 + [1.0])
        glLightfv(GL_LIGHT0, GL_POSITION, self.light)
        glLightfv(GL_LIGHT0, GL_DIFFUSE, [self.brightness] * 3 + [1.0])
        glLightfv(GL_LIGHT0, GL_SPECULAR, [self.brightness] * 3 + [1.0])
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.7, 0.35, 0.2, 1.0])
        glMaterialfv(GL_FRONT, GL_SPECULAR, [self.specular] * 3 + [1.0])
        glMaterialf(GL_FRONT, GL_SHININESS, self.shininess)
        glTranslatef(0.0, 0.0, -3.2)
        if self.as_list:
            number = glGenLists(1)
            glNewList(number, GL_COMPILE)
            self.triangles()
            glEndList()
            glCallList(number)
            glDeleteLists(number, 1)
        else:
            self.triangles()

    def triangles(self) -> None:
        bands = self.slices // 2
        corners = [
            [((i + a) * (self.slices + 1) + j + b, i + a, j + b) for a, b in three]
            for i in range(bands)
            for j in range(self.slices)
            for three in (((0, 0), (1, 0), (1, 1)), ((0, 0), (1, 1), (0, 1)))
        ]
        glBegin(GL_TRIANGLES)
        for number, three in list(enumerate(corners))[:: -1 if self.backwards else 1]:
            if number == self.missing:
                continue
            for vertex, i, j in three[self.first :] + three[: self.first]:
                theta, phi = pi * i / bands, 2 * pi * j / self.slices
                x, y, z = sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi)
                length = -self.normals if vertex == self.flipped else self.normals
                glNormal3f(x * length, y * length, z * length)
                r = self.radius
                glVertex3f(r * x + (0.01 if vertex == self.moved else 0.0), r * y, r * z)
        glEnd()


FRONT = 8 * 33 + 2  # the number of a vertex in the middle of the picture
LIT = 6 * 33 + 3  # of one where the highlight is
BALL, FLAT = Ball(), Ball(shade=GL_FLAT)


def drawn(draw: Callable[[], object]) -> Pixels:
    """What a function draws, SIZE x SIZE."""
    with glsim.offscreen(SIZE, SIZE) as screen:
        draw()
        pixels = opaque(screen)
    screen.release()
    return pixels


def wrong(ball: Ball = BALL, **fields: object) -> Pair:
    return Pair(drawn(ball.draw), drawn(replace(ball, **fields).draw))  # type: ignore[arg-type]


def floor(hyperbolic: bool = True, nearest: bool = False) -> Pixels:
    """A chequered floor in perspective; without the division for each pixel, the texture's lines break."""

    def draw() -> None:
        image = np.kron(np.indices((8, 8)).sum(0) % 2, np.ones((8, 8))).astype(np.uint8) * 200 + 40
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST if nearest else GL_LINEAR)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST if nearest else GL_LINEAR)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 64, 64, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, image)
        glEnable(GL_TEXTURE_2D)
        glBegin(GL_TRIANGLES)
        for s, t in ((0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)):
            x, y, w = 2.0 * s - 1.0, -0.8, 1.0 + 2.0 * t
            glTexCoord2f(s, t)
            if hyperbolic:
                glVertex4f(x, y, 0.0, w)
            else:
                glVertex4f(x / w, y / w, 0.0, 1.0)
        glEnd()

    return drawn(draw)


def cube(flipped: bool) -> Pixels:
    """A cube seen at an angle; the normal of one face points inwards."""

    def draw() -> None:
        for capability in (GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST):
            glEnable(capability)
        glLightfv(GL_LIGHT0, GL_POSITION, [1.0, 2.0, 3.0, 0.0])
        glMatrixMode(GL_PROJECTION)
        glOrtho(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0)
        glMatrixMode(GL_MODELVIEW)
        glRotatef(30.0, 1.0, 0.0, 0.0)
        glRotatef(40.0, 0.0, 1.0, 0.0)
        glScalef(0.5, 0.5, 0.5)
        glEnable(GL_NORMALIZE)
        glBegin(GL_QUADS)
        for face, normal in enumerate(np.concatenate([np.eye(3), -np.eye(3)])):
            across = np.roll(normal, 1)
            up = np.cross(normal, across)
            glNormal3fv(-normal if flipped and face == 2 else normal)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                glVertex3fv(normal + a * across + b * up)
        glEnd()

    return drawn(draw)


def changed(change: Callable[[Pixels], Pixels], picture: Pixels | None = None) -> Pair:
    """A ball, and what a function makes of its picture."""
    before = drawn(BALL.draw) if picture is None else picture
    return Pair(before, change(before.copy()))


def _gamma(picture: Pixels) -> Pixels:
    picture[..., :3] = np.rint(255.0 * (picture[..., :3] / 255.0) ** (1.0 / 2.2))
    return picture


def _transparent(picture: Pixels) -> Pixels:
    picture[..., 3] = 0
    return picture


def _white_block(picture: Pixels) -> Pixels:
    picture[200:215, 300:315] = 255
    return picture


MISTAKES: dict[str, Callable[[], Pair]] = {
    "shininess 31 instead of 32": lambda: wrong(shininess=31.0),
    "light 1 % dimmer": lambda: wrong(brightness=0.99),
    "light 2 % dimmer": lambda: wrong(brightness=0.98),
    "light moved by 0.05": lambda: wrong(light=(2.05, 2.0, 3.0, 0.0)),
    "light 0.5 degrees lower": lambda: wrong(light=(2.0, 1.96, 3.03, 0.0)),
    "ambient light forgotten": lambda: wrong(ambient=0.0),
    "specular term forgotten": lambda: wrong(specular=0.0),
    "one vertex normal flipped": lambda: wrong(flipped=FRONT),
    "normal flipped on one face": lambda: Pair(cube(False), cube(True)),
    "normals 5 % too long": lambda: wrong(normals=1.05),
    "31 slices instead of 32": lambda: wrong(slices=31),
    "one vertex moved by 0.01": lambda: wrong(moved=LIT),
    "one triangle missing": lambda: wrong(missing=2 * (8 * 32 + 2)),
    "sphere 1 % larger": lambda: wrong(radius=1.01),
    "picture one pixel to the right": lambda: wrong(shift=1),
    "provoking vertex: the first": lambda: wrong(FLAT, first=1),
    "Phong's lobe instead of Blinn's": lambda: wrong(lobe=GL_PHONG_LOBE_GLSIM),
    "N·L not clamped": lambda: wrong(Ball(light=(3.0, 0.0, -1.0, 0.0)), back=GL_FLIP_NORMAL_GLSIM),
    "Phong shading instead of Gouraud": lambda: wrong(shade=GL_PHONG_WIN),
    "depth test off": lambda: wrong(Ball(backwards=True), depth=False),
    "affine instead of hyperbolic": lambda: Pair(floor(), floor(hyperbolic=False)),
    "texture filter nearest": lambda: Pair(floor(), floor(nearest=True)),
    "gamma applied twice": lambda: changed(_gamma),
    "upside down": lambda: changed(lambda picture: picture[::-1]),
    "red and blue exchanged": lambda: changed(lambda picture: picture[..., [2, 1, 0, 3]]),
    "alpha 0 instead of 255": lambda: changed(_transparent),
    "60 rows instead of 100": lambda: changed(lambda p: p[:60], np.full((100, 100, 4), 255, np.uint8)),
    "white block of 15 x 15 in 512 x 512": lambda: changed(_white_block, np.full((512, 512, 4), 90, np.uint8)),
}

TINY: dict[str, Callable[[], Pair]] = {
    "light moved by 0.02": lambda: wrong(light=(2.02, 2.0, 3.0, 0.0)),
    "one vertex moved by 0.01, in dim light": lambda: wrong(moved=FRONT),
}


def _noise(amount: int, share: float = 1.0) -> Callable[[Pixels], Pixels]:
    """Differences of either sign, at a share of the pixels."""

    def change(picture: Pixels) -> Pixels:
        random = np.random.default_rng(1)
        steps = random.integers(-amount, amount + 1, (*picture.shape[:2], 3))
        steps *= (random.random(picture.shape[:2]) < share)[..., None]
        picture[..., :3] = np.clip(picture[..., :3].astype(int) + steps, 0, 255)
        return picture

    return change


def _few_outline_pixels(picture: Pixels) -> Pixels:
    """Another renderer covers some pixels of the outline, and others not: 0.04 % of the picture."""
    covered = picture[..., :3].any(axis=2)
    outline = np.argwhere(covered & ~(np.roll(covered, 1, 0) & np.roll(covered, -1, 0)))
    for y, x in outline[:: max(1, len(outline) // 26)][:26]:
        picture[y, x, :3] = 0
    return picture


def _through_files(picture: Pixels) -> Pixels:
    """Without alpha, in 16 bits and as floats: the same picture in other clothes."""
    wide = picture[..., :3].astype(np.uint16) * 257
    return rgba(rgba(wide)[..., :3].astype(np.float32) / np.float32(255.0))


def _native() -> Pair:
    """glsim's picture, and the driver's own fixed function."""
    from glsim.render.native import Native

    with glsim.offscreen(SIZE, SIZE) as screen, glsim.capture(calls=True) as frame:
        BALL.draw()
    pixels = opaque(screen)
    screen.release()
    native = Native(SIZE, SIZE)
    calls = [call for call in frame.calls if "GLSIM" not in str(call.arguments)]
    replayed = rgba(native.replay(calls)[..., :3])
    native.release()
    return Pair(pixels, replayed)


def _elsewhere(**environment: str) -> Pair:
    """The ball in this process, and in one with another renderer."""
    code = (
        "import sys, numpy; from tests.testing import sensitivity as s; numpy.save(sys.argv[1], s.drawn(s.BALL.draw))"
    )
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "ball.npy")
        subprocess.run(
            [sys.executable, "-c", code, path], env={**os.environ, **environment}, check=True, timeout=120,
            cwd=Path(__file__).resolve().parents[2], capture_output=True,
        )  # fmt: skip
        return Pair(drawn(BALL.draw), np.load(path))


HARMLESS: dict[str, Callable[[], Pair]] = {
    "another renderer, the same picture": lambda: changed(lambda picture: picture),
    "softpipe instead of llvmpipe": lambda: _elsewhere(GALLIUM_DRIVER="softpipe"),
    "the driver's own fixed function": _native,
    "rounding: noise of 1": lambda: changed(_noise(1)),
    "noise of 2 at 20 % of the pixels": lambda: changed(_noise(2, 0.2)),
    "26 pixels of the outline": lambda: changed(_few_outline_pixels),
    "16 bits and floats": lambda: changed(_through_files),
    "triangles in another order": lambda: wrong(backwards=True),
    "a display list": lambda: wrong(as_list=True),
}


def passes(pair: Pair, renderer: str = "another") -> bool:
    """Whether a picture passes whose baseline a renderer made; "this" is the picture's own."""
    baseline = Baseline(Path("ball.png"), {"renderer": renderer, "version": "1"})
    return judge(pair.actual, {"renderer": "this", "version": "1"}, [(baseline, pair.expected)]).passed


def row(name: str, pair: Pair) -> str:
    verdicts = " | ".join("passes" if passes(pair, renderer) else "fails" for renderer in ("another", "this"))
    if pair.expected.shape != pair.actual.shape:
        return f"| {name} | - | - | - | - | - | {verdicts} |"
    m = metrics(pair.expected, pair.actual)
    blocks = same_sign_blocks(pair.expected, pair.actual)
    numbers = f"{m['max']:.0f} | {m['mean']:.4f} | {m['different']:.2%} | {m['ssim']:.5f} | {blocks}"
    return f"| {name} | {numbers} | {verdicts} |"


def main() -> None:
    print("| picture | max | mean | different | SSIM | blocks | another renderer | the same renderer |")
    print("| --- " * 8 + "|")
    for name, pair in {**MISTAKES, **TINY, **HARMLESS}.items():
        print(row(name, pair()))


if __name__ == "__main__":
    main()
