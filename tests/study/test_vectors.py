"""glsim.vectors: arrows end where the vectors' ends are projected to."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import gluPerspective
from glsim.study.overlay import Overlay
from glsim.study.vectors import COLORS

SIDE = 128
FOVY = 50.0


class Seen(Overlay):
    """An overlay that remembers its arrows."""

    arrows: list[tuple[np.ndarray, np.ndarray, Any]]

    def arrow(self, start: Any, end: Any, color: Any, width: float = 3.2) -> None:
        self.arrows.append((np.array(start), np.array(end), color))
        super().arrow(start, end, color, width)


@pytest.fixture
def seen(monkeypatch: pytest.MonkeyPatch) -> type[Seen]:
    Seen.arrows = []
    monkeypatch.setattr("glsim.study.vectors.Overlay", Seen)
    return Seen


def wall(model: int = GL_PHONG_WIN, light: tuple[float, ...] = (1.0, 2.0, 0.0, 1.0)) -> Callable[[], None]:
    """A wall at z = -4 that faces the eye, its normal leaning by a known angle."""

    def draw() -> None:
        glMatrixMode(GL_PROJECTION)
        gluPerspective(FOVY, 1.0, 1.0, 20.0)
        glMatrixMode(GL_MODELVIEW)
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
        glLightfv(GL_LIGHT0, GL_POSITION, light)
        glShadeModel(model)
        glNormal3f(0.6, 0.0, 0.8)
        glBegin(GL_QUADS)
        for x, y in ((-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5)):
            glVertex3f(x, y, -4.0)
        glEnd()

    return draw


def project(P: np.ndarray, pixels: float) -> np.ndarray:
    """By hand: pixels from the upper left of a square picture."""
    f = 1.0 / np.tan(np.radians(FOVY / 2.0))
    return np.array([(0.5 + 0.5 * f * P[0] / -P[2]) * pixels, (0.5 - 0.5 * f * P[1] / -P[2]) * pixels])


@pytest.mark.parametrize(("x", "y"), [(64, 64), (40, 80), (90, 50)])
def test_arrows_end_at_the_projected_vectors(x: int, y: int, seen: type[Seen]) -> None:
    frame = glsim.frame_of(wall(), size=SIDE)
    glsim.vectors(frame, x, y, panel=False)
    pixels = SIDE * 4.0  # small pictures are enlarged, here by four
    f = 1.0 / np.tan(np.radians(FOVY / 2.0))
    ndc = np.array([(x + 0.5) / SIDE * 2.0 - 1.0, 1.0 - (y + 0.5) / SIDE * 2.0])
    P = np.array([*(ndc * 4.0 / f), -4.0])
    N = np.array([0.6, 0.0, 0.8])
    L = np.array([1.0, 2.0, 0.0]) - P
    L /= np.linalg.norm(L)
    V = -P / np.linalg.norm(P)
    H = (L + V) / np.linalg.norm(L + V)
    R = 2.0 * (N @ L) * N - L
    unit = 0.24 * pixels / (f * pixels / 2.0 / 4.0)  # the length in the scene that is 0.24 of the picture at depth 4
    drawn = {color: (start, end) for start, end, color in seen.arrows}
    for name, direction in {"N": N, "L": L, "R": R, "H": H, "V": V}.items():
        start, end = drawn[COLORS[name]]
        np.testing.assert_allclose(start, project(P, pixels), atol=0.1)
        np.testing.assert_allclose(end, project(P + unit * direction, pixels), atol=0.5, err_msg=name)


def test_gouraud_arrows_are_at_the_vertex_with_the_largest_weight(seen: type[Seen]) -> None:
    frame = glsim.frame_of(wall(GL_SMOOTH), size=SIDE)
    probe = glsim.probe(frame, 80, 40)
    vertex = max(probe.winner.vertices, key=lambda v: v.hyperbolic)
    glsim.vectors(frame, 80, 40, panel=False)
    start = next(start for start, _, color in seen.arrows if color == COLORS["L"])
    np.testing.assert_allclose(start, project(np.array(vertex.eye[:3]), SIDE * 4.0), atol=0.1)
    assert sum(color == COLORS["N"] for _, _, color in seen.arrows) == 3  # the other vertices show their N


def test_an_arrow_at_the_eye_is_a_ring_and_the_picture_stays_beside_the_panel() -> None:
    frame = glsim.frame_of(wall(), size=SIDE)
    with_panel, without = glsim.vectors(frame, 64, 64), glsim.vectors(frame, 64, 64, panel=False)
    assert without.size == (512, 512)
    assert with_panel.width > 512 + 300
    away = (slice(0, 45), slice(0, 45))
    picture = np.asarray(glsim.vectors(frame, 64, 64, panel=False))
    assert (picture[away] == picture[0, 0]).all()
    middle = np.asarray(without)[256 - 14 : 256 + 15, 256 - 14 : 256 + 15].reshape(-1, 3)
    assert (middle == COLORS["V"]).all(axis=1).any()  # V points at the eye: a ring


def test_light_behind_the_surface_is_drawn_too(seen: type[Seen]) -> None:
    frame = glsim.frame_of(wall(light=(-1.0, 0.0, -0.3, 0.0)), size=SIDE)
    assert glsim.vectors(frame, 64, 64).width > 512
    assert any(color == COLORS["L"] for _, _, color in seen.arrows)


def test_what_has_no_vectors_is_said_in_a_sentence() -> None:
    frame = glsim.frame_of(wall(), size=SIDE)
    with pytest.raises(ValueError, match=r"at \(0, 0\) only the background is seen; choose a pixel of a lit surface"):
        glsim.vectors(frame, 0, 0)
    with pytest.raises(ValueError, match="128 x 128 pixels"):
        glsim.vectors(frame, 128, 0)
    with pytest.raises(ValueError, match="light 3 is not on; lights that are: 0"):
        glsim.vectors(frame, 64, 64, light=3)
    with pytest.raises(ValueError, match=r"length must be in \[0.02, 1\]"):
        glsim.vectors(frame, 64, 64, length=0.0)

    def unlit() -> None:
        glRectf(-1, -1, 1, 1)

    def dark() -> None:
        glEnable(GL_LIGHTING)
        glNormal3f(0, 0, 1)
        glRectf(-1, -1, 1, 1)

    def line() -> None:
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glLineWidth(9)
        glBegin(GL_LINES)
        glVertex2f(-1, 0)
        glVertex2f(1, 0)
        glEnd()

    for draw, words in ((unlit, "not lit"), (dark, "no light is on"), (line, "a line is seen")):
        with pytest.raises(ValueError, match=words):
            glsim.vectors(glsim.frame_of(draw, size=SIDE), 64, 64)
