"""GLU's NURBS: points, normals, sampling, trimming, errors."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import *
from tests.drawing import fed_back

RING = [(1, 0, 1), (1, 1, 0.5**0.5), (0, 1, 1), (-1, 1, 0.5**0.5), (-1, 0, 1), (-1, -1, 0.5**0.5), (0, -1, 1),
        (1, -1, 0.5**0.5), (1, 0, 1)]  # fmt: skip
RING_KNOTS = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]


def sampled(nurb: Any, draw: Callable[[], None]) -> dict[str, Float]:
    """What the callbacks of GLU_NURBS_TESSELLATOR get."""
    got: dict[str, list[Any]] = {"vertex": [], "normal": [], "color": []}
    gluNurbsProperty(nurb, GLU_NURBS_MODE, GLU_NURBS_TESSELLATOR)
    gluNurbsCallback(nurb, GLU_NURBS_VERTEX, got["vertex"].append)
    gluNurbsCallback(nurb, GLU_NURBS_NORMAL, got["normal"].append)
    gluNurbsCallback(nurb, GLU_NURBS_COLOR, got["color"].append)
    draw()
    return {name: np.array(values) for name, values in got.items()}


def test_a_rational_circle_has_one_radius(screen: glsim.Offscreen) -> None:
    nurb = gluNewNurbsRenderer()
    gluNurbsProperty(nurb, GLU_SAMPLING_TOLERANCE, 5)

    def draw() -> None:
        gluBeginCurve(nurb)
        gluNurbsCurve(nurb, RING_KNOTS, [(x * w, y * w, 0, w) for x, y, w in RING], GL_MAP1_VERTEX_4)
        gluEndCurve(nurb)

    points = sampled(nurb, draw)["vertex"]
    assert len(points) > 60
    assert np.allclose(np.linalg.norm(points, axis=1), 1.0, atol=1e-6)


def paraboloid(nurb: Any, *trims: Any, form: str = "short") -> None:
    """z = x^2 + y^2 over [-1, 1]^2 with u = (x + 1) / 2, as one biquadratic patch."""
    x, square = np.array([-1.0, 0.0, 1.0]), np.array([1.0, -1.0, 1.0])
    control = np.stack(np.broadcast_arrays(x[:, None], x[None], square[:, None] + square[None]), axis=2)
    knots = [0, 0, 0, 1, 1, 1]
    gluBeginSurface(nurb)
    if form == "short":
        gluNurbsSurface(nurb, knots, knots, control, GL_MAP2_VERTEX_3)
    else:
        gluNurbsSurface(nurb, 6, knots, 6, knots, 9, 3, control.ravel(), 3, 3, GL_MAP2_VERTEX_3)
    for trim in trims:
        gluBeginTrim(nurb)
        gluPwlCurve(nurb, np.array(trim, np.float32), GLU_MAP1_TRIM_2)
        gluEndTrim(nurb)
    gluEndSurface(nurb)


@pytest.mark.parametrize("form", ["short", "C"])
def test_a_patch_has_its_points_and_normals(form: str, screen: glsim.Offscreen) -> None:
    nurb = gluNewNurbsRenderer()
    got = sampled(nurb, lambda: paraboloid(nurb, form=form))
    x, y, z = got["vertex"].T
    assert np.allclose(z, x**2 + y**2, atol=1e-6)
    expected = np.stack([-2 * x, -2 * y, np.ones_like(x)], axis=1)
    assert np.allclose(got["normal"], expected / np.linalg.norm(expected, axis=1, keepdims=True), atol=1e-6)


def test_domain_steps_are_samples_per_unit(screen: glsim.Offscreen) -> None:
    nurb = gluNewNurbsRenderer()
    gluNurbsProperty(nurb, GLU_SAMPLING_METHOD, GLU_DOMAIN_DISTANCE)
    gluNurbsProperty(nurb, GLU_U_STEP, 7)
    gluNurbsProperty(nurb, GLU_V_STEP, 4)
    x, y, _ = sampled(nurb, lambda: paraboloid(nurb))["vertex"].T
    assert (len(np.unique(x)), len(np.unique(y))) == (8, 5)


@pytest.mark.parametrize(("method", "error"), [(GLU_OBJECT_PARAMETRIC_ERROR, 0.01), (GLU_OBJECT_PARAMETRIC_ERROR, 0.1)])
def test_parametric_error_is_kept(method: int, error: float, screen: glsim.Offscreen) -> None:
    nurb = gluNewNurbsRenderer()
    gluNurbsProperty(nurb, GLU_SAMPLING_METHOD, method)
    gluNurbsProperty(nurb, GLU_PARAMETRIC_TOLERANCE, error)
    x, y, _ = sampled(nurb, lambda: paraboloid(nurb))["vertex"].T
    steps = [float(np.diff(np.unique(c)).max()) for c in (x, y)]
    worst = sum(h**2 / 4 for h in steps)  # of z = x^2 + y^2 under a chord
    assert error / 3 < worst <= error


def test_faces_are_counterclockwise_where_the_normal_points(screen: glsim.Offscreen) -> None:
    polygons = fed_back(lambda: paraboloid(gluNewNurbsRenderer()))
    for corners in polygons:
        assert np.cross(corners[1] - corners[0], corners[2] - corners[0])[2] > 0
    seen = 0.0
    for x, y, _ in (corners.T for corners in polygons):
        seen += float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2)
    assert seen == pytest.approx(4, rel=1e-4)


BORDER = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]
HOLE = [[0.3, 0.3], [0.3, 0.6], [0.7, 0.6], [0.7, 0.3], [0.3, 0.3]]
ISLAND = [[0.4, 0.4], [0.6, 0.4], [0.6, 0.5], [0.4, 0.5], [0.4, 0.4]]


@pytest.mark.parametrize(
    ("trims", "part"),
    [((), 1.0), ((BORDER,), 1.0), ((BORDER, HOLE), 1 - 0.12), ((BORDER, HOLE, ISLAND), 1 - 0.12 + 0.02),
     ((ISLAND,), 0.02), ((HOLE,), 0.0)],
)  # fmt: skip
def test_trimming_leaves_its_area(trims: Any, part: float, screen: glsim.Offscreen) -> None:
    glMatrixMode(GL_MODELVIEW)
    glScalef(1, 1, 0.1)
    paraboloid(gluNewNurbsRenderer(), *trims)
    lit = int((screen.pixels()[..., 0] > 0).sum())
    assert lit / 128**2 == pytest.approx(part, abs=0.008)


def test_a_trimming_curve_cuts_a_circle(screen: glsim.Offscreen) -> None:
    nurb = gluNewNurbsRenderer()
    gluBeginSurface(nurb)
    plane = np.array([[(-1, -1, 0), (-1, 1, 0)], [(1, -1, 0), (1, 1, 0)]], float)
    gluNurbsSurface(nurb, [0, 0, 1, 1], [0, 0, 1, 1], plane, GL_MAP2_VERTEX_3)
    gluBeginTrim(nurb)
    circle = [((0.5 + 0.4 * x) * w, (0.5 + 0.4 * y) * w, w) for x, y, w in RING]
    gluNurbsCurve(nurb, RING_KNOTS, circle, GLU_MAP1_TRIM_3)
    gluEndTrim(nurb)
    gluEndSurface(nurb)
    lit = int((screen.pixels()[..., 0] > 0).sum())
    assert lit / 128**2 == pytest.approx(math.pi * 0.16, rel=0.01)


def test_colours_are_interpolated_and_the_current_one_stays(screen: glsim.Offscreen) -> None:
    nurb = gluNewNurbsRenderer()
    glColor3f(0.25, 0.5, 0.75)
    gluBeginCurve(nurb)
    gluNurbsCurve(nurb, [0, 0, 1, 1], [(0, 0, 0, 1), (1, 1, 0, 1)], GL_MAP1_COLOR_4)
    gluNurbsCurve(nurb, [0, 0, 1, 1], [(-1, 0.004, 0), (1, 0.004, 0)], GL_MAP1_VERTEX_3)
    gluEndCurve(nurb)
    row = screen.pixels()[..., 0].max(axis=0).astype(float)
    assert np.allclose(row[1:-1], np.linspace(0, 255, 128)[1:-1], atol=3)
    assert np.allclose(glGetFloatv(GL_CURRENT_COLOR)[:3], [0.25, 0.5, 0.75])


def test_outlines_leave_the_inside_free(screen: glsim.Offscreen) -> None:
    counts = []
    for mode in (GLU_FILL, GLU_OUTLINE_POLYGON, GLU_OUTLINE_PATCH):
        glClear(GL_COLOR_BUFFER_BIT)
        nurb = gluNewNurbsRenderer()
        gluNurbsProperty(nurb, GLU_DISPLAY_MODE, mode)
        glLoadIdentity()
        glScalef(0.9, 0.9, 0.1)
        paraboloid(nurb)
        counts.append(int((screen.pixels()[..., 0] > 0).sum()))
    fill, polygon, patch = counts
    assert fill > 2 * polygon
    assert polygon > 2 * patch
    assert patch == pytest.approx(4 * 0.9 * 128, rel=0.03)


def test_nurbs_properties_and_errors(screen: glsim.Offscreen) -> None:
    nurb, errors = gluNewNurbsRenderer(), []
    assert gluGetNurbsProperty(nurb, GLU_SAMPLING_TOLERANCE) == 50.0
    value = np.zeros(1, np.float32)
    gluGetNurbsProperty(nurb, GLU_U_STEP, value)
    assert value[0] == 100.0
    with pytest.warns(GLUWarning, match=r"gluNurbsCurve: knots must not decrease \(decreasing knot"):
        gluNurbsCurve(nurb, [0, 0, 1, 0.5], [(0, 0, 0), (1, 1, 1)], GL_MAP1_VERTEX_3)
    with pytest.raises(GLUError, match=r"control must be an array of 3 dimensions"):
        gluNurbsSurface(nurb, [0, 0, 1, 1], [0, 0, 1, 1], [(0, 0, 0)], GL_MAP2_VERTEX_3)
    gluNurbsCallback(nurb, GLU_NURBS_ERROR, errors.append)
    gluEndCurve(nurb)
    gluBeginTrim(nurb)
    gluPwlCurve(nurb, BORDER, GLU_MAP1_TRIM_2)
    gluNurbsProperty(nurb, GLU_DISPLAY_MODE, 5)
    gluNurbsProperty(nurb, 77, 5)
    assert errors == [GLU_NURBS_ERROR7, GLU_NURBS_ERROR15, GLU_NURBS_ERROR19, GLU_INVALID_VALUE, GLU_INVALID_ENUM]
