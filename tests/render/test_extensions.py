"""glsim's own shading: per fragment, the (R.V)^n lobe, flipped normals.  Checked against the equation in NumPy."""

from __future__ import annotations

import numpy as np
import pytest

import glsim
from glsim.gl import *

LIGHT = np.array([0.6, 0.4, 0.9])
N_POWER = 12.0


def tilted_plane(normals: list[tuple[float, float, float]]) -> None:
    """A square that fills the picture, seen straight, with one normal per corner."""
    glBegin(GL_QUADS)
    for (x, y), n in zip(((-1, -1), (1, -1), (1, 1), (-1, 1)), normals, strict=True):
        glNormal3f(*n)
        glVertex3f(x, y, 0)
    glEnd()


def light_up() -> None:
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_POSITION, [*LIGHT, 0.0])
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.3, 0.3, 0.3, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.6, 0.6, 0.6, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, N_POWER)


def equation(n: np.ndarray, lobe: str, flip: bool = False) -> np.ndarray:
    """k_d (N.L) + k_s (N.H)^n or k_s (R.V)^n for unit normals (..., 3)."""
    light = LIGHT / np.linalg.norm(LIGHT)
    view = np.array([0, 0, 1.0])
    n_l = n @ light
    if flip:
        n = np.where(n_l[..., None] < 0, -n, n)
        n_l = np.abs(n_l)
    if lobe == "blinn":
        h = light + view
        cosine = n @ (h / np.linalg.norm(h))
    else:
        s = n_l[..., None] * n - light
        cosine = (n_l[..., None] * n + s) @ view
    lit = 0.3 * n_l + 0.6 * np.maximum(cosine, 0) ** N_POWER
    return np.clip(np.where(n_l > 0, lit, 0), 0, 1)


CORNERS = [(-0.5, -0.4, 0.77), (0.6, -0.3, 0.74), (0.5, 0.6, 0.62), (-0.3, 0.5, 0.81)]


@pytest.mark.parametrize("lobe", ["blinn", "phong"])
@pytest.mark.parametrize("flip", [False, True])
def test_per_vertex(screen: glsim.Offscreen, lobe: str, flip: bool) -> None:
    light_up()
    glLightModeli(
        GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM if lobe == "phong" else GL_BLINN_TORRANCE_GLSIM
    )
    glLightModeli(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM, GL_FLIP_NORMAL_GLSIM if flip else GL_CLAMP_NORMAL_GLSIM)
    rng = np.random.default_rng(4)
    normals = rng.normal(size=(40, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    for k, n in enumerate(normals):
        glViewport(3 * k, 0, 3, 3)
        tilted_plane([tuple(n)] * 4)
    shown = screen.pixels()[126, 1:120:3, 0]
    assert np.abs(shown - 255 * equation(normals, lobe, flip)).max() <= 1


@pytest.mark.parametrize("lobe", ["blinn", "phong"])
def test_per_fragment_interpolates_the_normal(screen: glsim.Offscreen, lobe: str) -> None:
    light_up()
    glShadeModel(GL_PHONG_WIN)
    glLightModeli(
        GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM if lobe == "phong" else GL_BLINN_TORRANCE_GLSIM
    )
    corners = [CORNERS[0], CORNERS[1], CORNERS[2], tuple(np.array(CORNERS[0]) + CORNERS[2] - CORNERS[1])]  # linear
    tilted_plane(corners)
    t = (np.arange(128) + 0.5) / 128
    a, b, d = (np.array(c) for c in (corners[0], corners[1], corners[3]))
    n = a + t[None, :, None] * (b - a) + t[::-1, None, None] * (d - a)  # top row first
    n /= np.linalg.norm(n, axis=2, keepdims=True)
    assert np.abs(screen.pixels()[..., 0] - 255 * equation(n, lobe)).max() <= 1


def test_phong_shading_finds_the_highlight_that_gouraud_misses(screen: glsim.Offscreen) -> None:
    light_up()
    glLightfv(GL_LIGHT0, GL_POSITION, [0, 0, 1, 0])
    glMaterialf(GL_FRONT, GL_SHININESS, 60.0)
    corners = [(-0.6, -0.6, 0.53), (0.6, -0.6, 0.53), (0.6, 0.6, 0.53), (-0.6, 0.6, 0.53)]
    tilted_plane(corners)
    gouraud = screen.pixels()[64, 64, 0]
    glShadeModel(GL_PHONG_WIN)
    tilted_plane(corners)
    assert gouraud < 60
    assert screen.pixels()[64, 64, 0] > 220


def test_materials_and_colors_reach_the_fragments(screen: glsim.Offscreen) -> None:
    """Under GL_PHONG_WIN: per-vertex materials, colour material, two sides, separate specular colour."""
    glShadeModel(GL_PHONG_WIN)
    light_up()
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [1, 1, 1, 1])
    glLightfv(GL_LIGHT0, GL_POSITION, [0, 0, -1, 0])  # behind: only ambient light
    glMaterialfv(GL_BACK, GL_AMBIENT, [0, 0, 1, 1])
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glMaterialfv(GL_BACK, GL_DIFFUSE, [0, 0, 0, 1])
    glColorMaterial(GL_FRONT, GL_AMBIENT)
    glEnable(GL_COLOR_MATERIAL)
    glBegin(GL_TRIANGLES)
    for x in (-1, 0):
        for dx, dy, color in ((0, 0, (1, 0, 0)), (0.9, 0, (0, 1, 0)), (0, 0.9, (1, 1, 0)))[:: 1 if x else -1]:
            glColor3f(*color)
            glNormal3f(0, 0, 1)
            glVertex2f(x + dx, dy)
    glEnd()
    picture = screen.pixels()
    front = picture[62, 1, :3].tolist()
    assert front[0] > 240
    assert front[1] < 15
    assert picture[60, 66, :3].tolist() == [0, 0, 255]


def test_flat_takes_the_provoking_vertex(screen: glsim.Offscreen) -> None:
    glShadeModel(GL_FLAT)
    colors = np.eye(4)[:, :3]
    for mode, count, provoking in ((GL_TRIANGLES, 3, 2), (GL_QUADS, 4, 3), (GL_POLYGON, 4, 0), (GL_QUAD_STRIP, 4, 3)):
        glBegin(mode)
        corners = (
            ((-1, -1), (1, -1), (-1, 1), (1, 1)) if mode == GL_QUAD_STRIP else ((-1, -1), (1, -1), (1, 1), (-1, 1))
        )
        for k in range(count):
            glColor3fv(colors[k])
            glVertex2f(*corners[k])
        glEnd()
        assert np.array_equal(screen.pixels()[100, 100, :3], 255 * colors[provoking]), mode
