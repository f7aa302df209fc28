"""GLU's quadrics: areas, sides, normals, errors."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import glsim
from glsim.gl import *
from glsim.glu import *
from tests.drawing import fed_back


def outward_area(polygons: list[NDArray[np.float64]]) -> tuple[float, float]:
    """Area, and how much of it has its counterclockwise side away from the origin."""
    total = outward = 0.0
    for polygon in polygons:
        a = polygon[0]
        normal = sum((np.cross(b - a, c - a) / 2 for b, c in pairwise(polygon[1:])), np.zeros(3))
        area = float(np.linalg.norm(normal))
        total += area
        outward += area * (float(normal @ polygon.mean(axis=0)) > 0)
    return total, outward


@pytest.mark.parametrize("orientation", [GLU_OUTSIDE, GLU_INSIDE])
@pytest.mark.parametrize("textured", [False, True])
def test_a_sphere_has_its_radius_area_and_sides(orientation: int, textured: bool, screen: glsim.Offscreen) -> None:
    quad = gluNewQuadric()
    gluQuadricOrientation(quad, orientation)
    gluQuadricTexture(quad, textured)
    polygons = fed_back(lambda: gluSphere(quad, 1.5, 60, 40))
    assert np.allclose(np.linalg.norm(np.concatenate(polygons), axis=1), 1.5, atol=1e-4)
    total, outward = outward_area(polygons)
    assert total == pytest.approx(4 * math.pi * 1.5**2, rel=5e-3)
    assert outward == pytest.approx(total if orientation == GLU_OUTSIDE else 0.0, abs=1e-3)


def test_a_cone_lies_on_its_surface(screen: glsim.Offscreen) -> None:
    polygons = fed_back(lambda: gluCylinder(gluNewQuadric(), 1.2, 0.4, 1.6, 64, 3))
    x, y, z = np.concatenate(polygons).T
    assert np.allclose(np.hypot(x, y), 1.2 - 0.8 * z / 1.6, atol=1e-4)
    total, outward = outward_area(polygons)
    assert total == pytest.approx(math.pi * 1.6 * math.hypot(0.8, 1.6), rel=5e-3)
    assert outward == pytest.approx(total)


def test_a_partial_disk_has_its_area_and_place(screen: glsim.Offscreen) -> None:
    polygons = fed_back(lambda: gluPartialDisk(gluNewQuadric(), 0.5, 1.5, 50, 4, 30, 90))
    x, y, z = np.concatenate(polygons).T
    angle = np.degrees(np.arctan2(x, y))
    assert angle.min() == pytest.approx(30, abs=0.01)
    assert angle.max() == pytest.approx(120, abs=0.01)
    assert abs(z).max() < 1e-6
    assert outward_area(polygons)[0] == pytest.approx(math.pi * (1.5**2 - 0.5**2) / 4, rel=1e-3)


SHAPES: dict[str, Callable[[Any], None]] = {
    "sphere": lambda quad: gluSphere(quad, 1.5, 9, 7),
    "cone": lambda quad: gluCylinder(quad, 1.2, 0.4, 1.6, 7, 3),
    "disk": lambda quad: gluDisk(quad, 0.3, 1.5, 9, 2),
    "full disk": lambda quad: gluDisk(quad, 0.0, 1.5, 9, 2),
}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("orientation", [GLU_OUTSIDE, GLU_INSIDE])
def test_flat_normals_are_those_of_the_faces(
    shape: str, orientation: int, screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The last vertex of a face has its normal."""
    faces: list[Any] = []
    state: dict[str, Any] = {}

    def vertex(*point: float) -> None:
        state["points"].append(point)
        points, fan = state["points"], state["mode"] == GL_TRIANGLE_FAN
        if len(points) >= 3 and (fan or (len(points) >= 4 and len(points) % 2 == 0)):
            a, b, c = (points[0], *points[-2:]) if fan else (points[-4], points[-3], points[-1])
            faces.append((np.cross(np.subtract(b, a), np.subtract(c, a)), state["normal"]))

    monkeypatch.setattr(glsim.gl, "glBegin", lambda mode: state.update(mode=mode, points=[]))
    monkeypatch.setattr(glsim.gl, "glEnd", lambda: None)
    monkeypatch.setattr(glsim.gl, "glNormal3f", lambda *normal: state.update(normal=np.array(normal)))
    monkeypatch.setattr(glsim.gl, "glVertex3f", vertex)
    quad = gluNewQuadric()
    gluQuadricOrientation(quad, orientation)
    gluQuadricNormals(quad, GLU_FLAT)
    SHAPES[shape](quad)
    assert len(faces) >= 18
    least = 0.5 if (shape, orientation) == ("cone", GLU_INSIDE) else 0.98  # GLU forgets to turn its slope
    for cross, normal in faces:
        if np.linalg.norm(cross) > 1e-6:  # not at a pole
            assert cross @ normal / np.linalg.norm(cross) > least


@pytest.mark.parametrize(("normals", "steps"), [(GLU_SMOOTH, False), (GLU_FLAT, True)])
def test_flat_normals_shade_faces_evenly(normals: int, steps: bool, screen: glsim.Offscreen) -> None:
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glShadeModel(GL_FLAT if steps else GL_SMOOTH)
    glRotatef(90, 1, 0, 0)
    quad = gluNewQuadric()
    gluQuadricNormals(quad, normals)
    gluCylinder(quad, 0.9, 0.9, 0.9, 12, 1)
    row = screen.pixels()[80, 10:-10, 0].astype(int)
    assert (len(np.unique(row)) < 8) == steps


def test_quadric_errors_go_to_the_callback_or_are_warnings(screen: glsim.Offscreen) -> None:
    quad, errors = gluNewQuadric(), []
    with pytest.warns(GLUWarning, match=r"gluSphere: needs at least 2 slices"):
        gluSphere(quad, 1.0, 1, 5)
    with pytest.warns(GLUWarning, match=r"gluQuadricNormals: normal must be GLU_NONE, GLU_FLAT or GLU_SMOOTH, not 3"):
        gluQuadricNormals(quad, 3)
    gluQuadricCallback(quad, GLU_ERROR, errors.append)
    gluCylinder(quad, 1.0, 1.0, 1.0, 5, 0)
    gluQuadricDrawStyle(quad, 3)
    assert errors == [GLU_INVALID_VALUE, GLU_INVALID_ENUM]
