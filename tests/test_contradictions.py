"""Where Mesa 22.3.6 contradicts the specification, glsim follows the specification (see gl/SUPPORT.md)."""

from __future__ import annotations

import numpy as np
import pytest

import glsim
from glsim.gl import *


def square(x: float = -1.0, backwards: bool = False) -> None:
    corners = ((x, -1), (x + 1, -1), (x + 1, 1), (x, 1))
    glNormal3f(0, 0, -1 if backwards else 1)
    glBegin(GL_QUADS)
    for corner in reversed(corners) if backwards else corners:
        glVertex2f(*corner)
    glEnd()


def lit() -> None:
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])


def test_enabling_color_material_takes_the_current_colour_at_once(screen: glsim.Offscreen) -> None:
    """Section 2.14.3; in Mesa a glMaterial that no vertex has used yet goes before."""
    lit()
    glColor3f(1, 0, 0)
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, [0, 1, 0, 1])
    glEnable(GL_COLOR_MATERIAL)
    square()
    assert screen.pixels()[64, 32, :3].tolist() == [255, 0, 0]


def test_popping_lighting_restores_the_material(screen: glsim.Offscreen) -> None:
    """Table 6.9: materials are in GL_LIGHTING_BIT; in Mesa one that no vertex has used yet stays."""
    lit()
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0, 0, 1])
    glPushAttrib(GL_LIGHTING_BIT)
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0, 0, 1, 1])
    glPopAttrib()
    square()
    assert screen.pixels()[64, 32, :3].tolist() == [255, 0, 0]
    assert glGetMaterialfv(GL_FRONT, GL_DIFFUSE).tolist() == [1, 0, 0, 1]


def test_the_back_tracks_all_of_the_colour(screen: glsim.Offscreen) -> None:
    """In Mesa glColorMaterial(GL_BACK) loses green and blue when glColor changes between primitives."""
    lit()
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glColorMaterial(GL_BACK, GL_DIFFUSE)
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(1, 0, 0)
    square(-1.0, backwards=True)
    glColor3f(0, 0.6, 1)
    glNormal3f(0, 0, -1)
    square(0.0, backwards=True)
    found = screen.pixels()[64, [32, 96], :3]
    assert found == pytest.approx(np.array([[255, 0, 0], [0, 153, 255]]), abs=1)


def test_smooth_points_are_discs(screen: glsim.Offscreen) -> None:
    """Section 3.3: the fragments of a smooth point are weighted by coverage; Mesa 22 draws hard discs."""
    glEnable(GL_POINT_SMOOTH)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ZERO)
    glPointSize(21.5)
    glBegin(GL_POINTS)
    glVertex2f(0.013, 0.021)
    glEnd()
    covered = screen.pixels()[..., 0] / 255.0
    assert covered.sum() == pytest.approx(np.pi * (21.5 / 2) ** 2, rel=0.01)
    assert 0.0 < covered[covered > 0].min() < 0.5


def test_a_shininess_of_0_is_a_highlight_wherever_there_is_light(screen: glsim.Offscreen) -> None:
    """Equation 2.5: max(N.H, 0)^0 is 1; in Mesa it is 0 where N.H < 0, and other numbers where light is attenuated."""
    lit()
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0, 0, 0, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.2, 0.4, 0.6, 1])
    glLightfv(GL_LIGHT0, GL_POSITION, [0.8, 0, -0.6, 0])
    glNormal3f(0.1, 0, -1)  # N.L > 0 and N.H < 0
    glRectf(-1, -1, 1, 1)
    assert screen.pixels()[64, 64, :3].tolist() == [51, 102, 153]
