"""GLU: closed forms, round trips and areas; and the views of an installed libGLU, where there is one."""

from __future__ import annotations

import ctypes
import ctypes.util
import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import glsim
from glsim.gl import *
from glsim.glu import *

Float = NDArray[np.float64]
RULES = {
    "ODD": lambda n: n % 2 == 1, "NONZERO": lambda n: n != 0, "POSITIVE": lambda n: n > 0, "NEGATIVE": lambda n: n < 0,
    "ABS_GEQ_TWO": lambda n: abs(n) >= 2,
}  # fmt: skip


def rule_named(name: str) -> int:
    return int(globals()[f"GLU_TESS_WINDING_{name}"])


# ---------------------------------------------------------------- views


def camera() -> None:
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(50, 1.5, 0.5, 30)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(3, 2, 5, 0.5, 0, -1, 0.1, 1, 0)


def test_perspective_maps_the_frustum_to_the_cube(screen: glsim.Offscreen) -> None:
    glMatrixMode(GL_PROJECTION)
    gluPerspective(90, 2.0, 1.0, 11.0)
    for z, depth in ((-1, -1), (-11, 1)):
        x, y, d, w = np.array([2.0 * -z, -z, z, 1.0]) @ np.asarray(glGetDoublev(GL_PROJECTION_MATRIX), float)
        assert np.allclose([x / w, y / w, d / w], [1, 1, depth], atol=1e-6)


def test_look_at_puts_the_centre_on_the_axis(screen: glsim.Offscreen) -> None:
    camera()
    m = np.asarray(glGetDoublev(GL_MODELVIEW_MATRIX), float)
    assert np.allclose(m[:3, :3] @ m[:3, :3].T, np.identity(3), atol=1e-6)
    assert np.allclose(np.array([3, 2, 5, 1]) @ m, [0, 0, 0, 1], atol=1e-5)
    centre = np.array([0.5, 0, -1, 1]) @ m
    assert np.allclose(centre[:3], [0, 0, -math.dist((3, 2, 5), (0.5, 0, -1))], atol=1e-5)
    up = np.array([0.1, 1, 0, 0]) @ m
    assert abs(up[0]) < 1e-6
    assert up[1] > 0


def test_project_and_unproject_are_inverse(screen: glsim.Offscreen) -> None:
    camera()
    for point in ((0, 0, 0), (1, -0.5, 0.3), (-2, 1, -4)):
        window = gluProject(*point)
        assert np.allclose(gluUnProject(*window), point, atol=1e-5)
    assert np.allclose(gluProject(0.5, 0, -1)[:2], [64, 64], atol=1e-4)


def test_unproject4_gives_w_and_takes_a_depth_range(screen: glsim.Offscreen) -> None:
    camera()
    x, y, z = gluUnProject(30, 40, 0.75)
    a, b, c, d = gluUnProject4(30, 40, 0.2 + 0.75 * 0.4, 1.0, near=0.2, far=0.6)
    assert d != 1.0
    assert np.allclose([a / d, b / d, c / d], [x, y, z])


def test_what_has_no_place_raises_value_error(screen: glsim.Offscreen) -> None:
    zero, one = np.zeros((4, 4)), np.identity(4)
    with pytest.raises(ValueError, match=r"gluProject: .* plane of the eye"):
        gluProject(0, 0, 0, zero, one, [0, 0, 9, 9])
    with pytest.raises(ValueError, match=r"gluUnProject: .* no inverse"):
        gluUnProject(0, 0, 0, zero, one, [0, 0, 9, 9])


def test_pick_matrix_enlarges_a_pixel(screen: glsim.Offscreen) -> None:
    glMatrixMode(GL_PROJECTION)
    gluPickMatrix(10.5, 20.5, 1, 1, [0, 0, 128, 128])
    gluOrtho2D(0, 128, 0, 128)
    glRecti(10, 20, 11, 21)
    assert (screen.pixels()[..., :3] == 255).all()


@pytest.fixture(scope="module")
def library() -> ctypes.CDLL:
    """The installed GLU; only calls that need no context can be made."""
    path = ctypes.util.find_library("GLU")
    if path is None:
        pytest.skip("no libGLU is installed")
    return ctypes.CDLL(path)


def test_unproject4_is_that_of_the_installed_glu(screen: glsim.Offscreen, library: ctypes.CDLL) -> None:
    camera()
    matrices = [glGetDoublev(name) for name in (GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX)]
    result = (ctypes.c_double * 4)()
    pointers = [ctypes.byref(result, 8 * k) for k in range(4)]
    passed = [(ctypes.c_double * 16)(*np.ravel(m)) for m in matrices] + [(ctypes.c_int * 4)(1, 2, 80, 90)]
    numbers = [ctypes.c_double(n) for n in (12.0, 34.0, 0.4, 2.5)]
    assert library.gluUnProject4(*numbers, *passed, ctypes.c_double(0.1), ctypes.c_double(0.8), *pointers) == 1
    assert np.allclose(gluUnProject4(12, 34, 0.4, 2.5, *matrices, [1, 2, 80, 90], 0.1, 0.8), list(result))


def test_error_strings_are_those_of_the_installed_glu(library: ctypes.CDLL) -> None:
    library.gluErrorString.restype = ctypes.c_char_p
    for code in (*range(1280, 1290), *range(100150, 100160), *range(100250, 100290), *range(100900, 100906)):
        assert gluErrorString(code) == library.gluErrorString(code)


def test_strings() -> None:
    assert gluGetString(GLU_VERSION) == b"1.3"
    assert gluCheckExtension(b"GLU_EXT_nurbs_tessellator", gluGetString(GLU_EXTENSIONS))
    assert not gluCheckExtension("GLU_EXT", gluGetString(GLU_EXTENSIONS))
    with pytest.raises(GLUerror, match=r"gluGetString: name must be GLU_VERSION or GLU_EXTENSIONS, not 7"):
        gluGetString(7)


# ---------------------------------------------------------------- quadrics


def fed_back(draw: Callable[[], Any]) -> list[Float]:
    """The polygons that are drawn, as points (n, 3) in object coordinates."""
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(-2, 2, -2, 2, -2, 2)
    glMatrixMode(GL_MODELVIEW)
    glFeedbackBuffer(500_000, GL_3D)
    glRenderMode(GL_FEEDBACK)
    draw()
    polygons = []
    for token, *vertices in glRenderMode(GL_RENDER):
        assert token == GL_POLYGON_TOKEN
        polygons.append(np.array([v.vertex[:3] for v in vertices]) * [4 / 128, 4 / 128, -4] + [-2, -2, 2])
    return polygons


def outward_area(polygons: list[Float]) -> tuple[float, float]:
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


# ---------------------------------------------------------------- tessellator


def triangles(contours: list[Any], rule: int = GLU_TESS_WINDING_ODD, turned: Float | None = None) -> Float:
    """(n, 3, 3) from the tessellator; turned: a matrix for the points, with the normal left to GLU."""
    cutter, corners = gluNewTess(), []
    gluTessCallback(cutter, GLU_TESS_VERTEX, corners.append)
    gluTessCallback(cutter, GLU_TESS_COMBINE, lambda at, data, weights: at)
    gluTessProperty(cutter, GLU_TESS_WINDING_RULE, rule)
    if turned is None:
        gluTessNormal(cutter, 0, 0, 1)
    gluTessBeginPolygon(cutter, None)
    for contour in contours:
        gluTessBeginContour(cutter)
        for x, y in contour:
            point = np.array([x, y, 0.0]) if turned is None else turned @ [x, y, 0.0]
            gluTessVertex(cutter, point, point)
        gluTessEndContour(cutter)
    gluTessEndPolygon(cutter)
    return np.array(corners, float).reshape(-1, 3, 3)


def doubled_areas(corners: Float) -> Float:
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def area(corners: Float) -> float:
    return float(np.linalg.norm(doubled_areas(corners), axis=1).sum() / 2) if len(corners) else 0.0


def square(half: float, backwards: bool = False) -> list[tuple[float, float]]:
    corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
    return corners[::-1] if backwards else corners


NESTED = [square(3), square(2), square(1, backwards=True)]  # winding numbers 1, 2, 1 from outside in


@pytest.mark.parametrize(
    ("rule", "expected"),
    [("ODD", 36 - 16 + 4), ("NONZERO", 36), ("POSITIVE", 36), ("NEGATIVE", 0), ("ABS_GEQ_TWO", 16 - 4)],
)
def test_winding_rules(rule: str, expected: float) -> None:
    assert area(triangles(NESTED, rule_named(rule))) == pytest.approx(expected)
    assert (doubled_areas(triangles(NESTED, rule_named(rule)))[:, 2] > 0).all()


def test_a_star_has_a_hole_by_the_odd_rule() -> None:
    star = [(math.cos(k * 0.8 * math.pi), math.sin(k * 0.8 * math.pi)) for k in range(5)]
    inner = math.cos(0.4 * math.pi) / math.cos(0.2 * math.pi)  # radius of the pentagon in the middle
    points = 5 * math.sin(math.pi / 5) * inner  # the star without crossings: ten triangles round the middle
    pentagon = 2.5 * math.sin(0.4 * math.pi) * inner**2
    assert area(triangles([star], GLU_TESS_WINDING_NONZERO)) == pytest.approx(points)
    assert area(triangles([star], GLU_TESS_WINDING_ODD)) == pytest.approx(points - pentagon)


def test_the_normal_is_found_in_any_plane() -> None:
    q, _ = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))
    for contour in (square(1.5), [(-1, -1), (1, 0.9), (1, -1), (-1, 1)]):
        assert area(triangles([contour], turned=q)) == pytest.approx(area(triangles([contour])))
    for backwards in (False, True):  # it is where the contour goes counterclockwise
        side = np.linalg.det(q) * (-1 if backwards else 1)
        assert np.allclose(doubled_areas(triangles([square(1.0, backwards)], turned=q)) / 4, q[:, 2] * side)


def test_points_on_a_line_stay_and_make_no_empty_triangle() -> None:
    corners = triangles([[(0, 0), (1, 0), (2, 0), (2, 2), (1, 2), (1, 2), (0, 2), (0, 1)]])
    assert (doubled_areas(corners)[:, 2] > 0).all()
    assert area(corners) == pytest.approx(4)
    assert len(np.unique(corners.reshape(-1, 3), axis=0)) == 7


def boundary(contours: list[Any]) -> list[Any]:
    """The loops of GLU_TESS_BOUNDARY_ONLY."""
    cutter, loops = gluNewTess(), []
    gluTessCallback(cutter, GLU_TESS_BEGIN, lambda mode: loops.append([mode]))
    gluTessCallback(cutter, GLU_TESS_VERTEX, lambda v: loops[-1].append(v))
    gluTessProperty(cutter, GLU_TESS_BOUNDARY_ONLY, GL_TRUE)
    gluTessNormal(cutter, 0, 0, 1)
    gluTessBeginPolygon(cutter)
    for contour in contours:
        gluTessBeginContour(cutter)
        for point in contour:
            gluTessVertex(cutter, (*point, 0), point)
        gluTessEndContour(cutter)
    gluTessEndPolygon(cutter)
    assert [loop[0] for loop in loops] == [GL_LINE_LOOP] * len(loops)
    return [loop[1:] for loop in loops]


def test_boundary_only_gives_loops_with_the_inside_on_their_left() -> None:
    signed = []
    for points in boundary([square(2), square(1)]):
        x, y = np.array(points).T
        signed.append(float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2))
    assert sorted(signed) == [-4, 16]


def test_loops_that_touch_stay_apart() -> None:
    turned = [(x + 1, y + 1) for x, y in square(1)]
    assert [len(loop) for loop in boundary([turned, [(-x, -y) for x, y in turned]])] == [4, 4]


def test_edge_flags_mark_the_boundary() -> None:
    cutter, flags, edges = gluNewTess(), [False], []
    gluTessCallback(cutter, GLU_TESS_EDGE_FLAG, flags.append)
    gluTessCallback(cutter, GLU_TESS_VERTEX, lambda v: edges.append((v, flags[-1])))
    gluTessBeginPolygon(cutter)
    gluTessBeginContour(cutter)
    for k, point in enumerate(square(1)):
        gluTessVertex(cutter, (*point, 0), k)
    gluTessEndContour(cutter)
    gluTessEndPolygon(cutter)
    marked = set()
    for k in range(0, len(edges), 3):
        for (a, flag), (b, _) in zip(edges[k : k + 3], [*edges[k + 1 : k + 3], edges[k]], strict=True):
            if flag:
                marked.add((a, b))
    assert marked == {(0, 1), (1, 2), (2, 3), (3, 0)}


def test_combine_mixes_the_four_ends_of_crossing_edges() -> None:
    cutter, calls = gluNewTess(), []
    gluTessCallback(cutter, GLU_TESS_COMBINE_DATA, lambda at, data, weights, polygon: calls.append((at, data, polygon)))
    gluTessCallback(cutter, GLU_TESS_VERTEX_DATA, lambda vertex, polygon: None)
    gluTessBeginPolygon(cutter, "polygon")
    gluTessBeginContour(cutter)
    for name, point in zip("abcd", [(0, 0, 1), (2, 2, 1), (2, 0, 1), (0, 2.0, 1)], strict=True):
        gluTessVertex(cutter, point, name)
    gluTessEndContour(cutter)
    gluTessEndPolygon(cutter)
    ((at, data, polygon),) = calls
    assert np.allclose(at, [1, 1, 1])
    assert sorted(data) == list("abcd")
    assert polygon == "polygon"


def test_tessellator_errors() -> None:
    cutter, errors = gluNewTess(), []
    with pytest.warns(GLUWarning, match=r"gluTessVertex: gluTessBeginPolygon must come first \(gluTessBeginPolygon"):
        gluTessVertex(cutter, (0, 0, 0))
    cutter = gluNewTess()
    gluTessCallback(cutter, GLU_TESS_ERROR, errors.append)
    gluTessEndPolygon(cutter)
    gluTessBeginPolygon(cutter)
    gluTessBeginContour(cutter)
    gluTessEndPolygon(cutter)
    gluTessProperty(cutter, GLU_TESS_WINDING_RULE, 7)
    expected = [GLU_TESS_MISSING_BEGIN_POLYGON, GLU_TESS_MISSING_END_CONTOUR, GLU_INVALID_VALUE]
    gluTessBeginPolygon(cutter)
    gluTessBeginContour(cutter)
    for point in ((0, 0, 0), (2, 2, 0), (2, 0, 0), (0, 1, 0)):
        gluTessVertex(cutter, point)
    gluTessEndContour(cutter)
    gluTessEndPolygon(cutter)
    assert errors == [*expected, GLU_TESS_NEED_COMBINE_CALLBACK]


def winding_numbers(contours: list[Any], points: Float) -> tuple[NDArray[np.int64], Float]:
    """Of each point (n, 2), and how far it is from the contours."""
    winding, distance = np.zeros(len(points), np.int64), np.full(len(points), np.inf)
    for contour in contours:
        ring = np.array(contour, float)
        for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
            d = b - a
            left = d[0] * (points[:, 1] - a[1]) - d[1] * (points[:, 0] - a[0]) > 0
            winding += (a[1] <= points[:, 1]) & (points[:, 1] < b[1]) & left
            winding -= (b[1] <= points[:, 1]) & (points[:, 1] < a[1]) & ~left
            t = np.clip((points - a) @ d / max(float(d @ d), 1e-300), 0, 1)
            distance = np.minimum(distance, np.linalg.norm(points - a - t[:, None] * d, axis=1))
    return winding, distance


def covered(corners: Float, points: Float) -> NDArray[np.int64]:
    """How many triangles each point lies in."""
    count = np.zeros(len(points), np.int64)
    for triangle in corners[:, :, :2]:
        inside = np.ones(len(points), bool)
        for p, q in zip(triangle, np.roll(triangle, -1, axis=0), strict=True):
            inside &= (q[0] - p[0]) * (points[:, 1] - p[1]) - (q[1] - p[1]) * (points[:, 0] - p[0]) > 0
        count += inside
    return count


coarse = st.tuples(st.integers(0, 4), st.integers(0, 4))  # so that points repeat, touch and line up
fine = st.tuples(st.floats(0, 4, width=32), st.floats(0, 4, width=32))
contour_lists = st.lists(st.one_of(st.lists(coarse, min_size=3, max_size=9), st.lists(fine, min_size=3, max_size=9)),
                         min_size=1, max_size=3)  # fmt: skip


@settings(max_examples=120, deadline=None)
@given(contours=contour_lists, rule=st.sampled_from(sorted(RULES)))
def test_every_polygon_is_filled_as_its_winding_numbers_say(contours: list[Any], rule: str) -> None:
    points = np.random.default_rng(1).uniform(0, 4, (60, 2))
    winding, distance = winding_numbers(contours, points)
    expected = np.array([int(RULES[rule](int(n))) for n in winding])
    sure = distance > 1e-5
    assert (covered(triangles(contours, rule_named(rule)), points) == expected)[sure].all()


def test_a_long_outline_is_quick() -> None:
    angle = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    radius = 1 + 0.3 * np.sin(40 * angle)
    outline = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    x, y = outline.T
    assert area(triangles([outline])) == pytest.approx((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2)


# ---------------------------------------------------------------- NURBS

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


# ---------------------------------------------------------------- images


def level(target: int, number: int, *size: int) -> Any:
    glPixelStorei(GL_PACK_ALIGNMENT, 1)
    texels = glGetTexImage(target, number, GL_RGB, GL_UNSIGNED_BYTE)
    return np.frombuffer(bytes(texels), np.uint8).reshape(*size, 3).astype(int)


def test_mipmaps_are_means(screen: glsim.Offscreen) -> None:
    image = np.random.default_rng(3).integers(0, 256, (16, 32, 3), np.uint8)
    assert gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 32, 16, GL_RGB, GL_UNSIGNED_BYTE, image) == 0
    assert (level(GL_TEXTURE_2D, 0, 16, 32) == image).all()
    for number in range(1, 5):
        n = 2**number
        means = image.reshape(16 // n, n, 32 // n, n, 3).mean(axis=(1, 3))
        assert np.abs(level(GL_TEXTURE_2D, number, 16 // n, 32 // n) - means).max() <= 1
    assert np.abs(level(GL_TEXTURE_2D, 5, 1, 1) - image.mean(axis=(0, 1))).max() <= 1


@pytest.mark.parametrize(("size", "power"), [(3, 4), (5, 4), (6, 8), (11, 8), (12, 16), (64, 64)])
def test_sizes_become_powers_of_two(size: int, power: int, screen: glsim.Offscreen) -> None:
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, size, 1, GL_RGB, GL_FLOAT, np.full((1, size, 3), 0.4, np.float32))
    assert glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == power
    assert (level(GL_TEXTURE_2D, 0, 1, power) == 102).all()


def test_a_scaled_image_keeps_its_mean_and_its_ramp(screen: glsim.Offscreen) -> None:
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    ramp = np.tile(np.linspace(0, 1, 12, dtype=np.float32)[:, None, None], (1, 7, 3))
    small = gluScaleImage(GL_RGB, 7, 12, GL_FLOAT, ramp, 7, 4, GL_FLOAT)
    assert np.allclose(small[:, 0, 0], ramp[:, 0, 0].reshape(4, 3).mean(axis=1))
    out = np.zeros((4, 7, 3), np.uint8)
    glPixelStorei(GL_PACK_ALIGNMENT, 1)
    assert gluScaleImage(GL_RGB, 7, 12, GL_FLOAT, ramp, 7, 4, GL_UNSIGNED_BYTE, out) == 0
    assert np.abs(out - small * 255).max() <= 0.51


def test_only_the_levels_asked_for_are_loaded(screen: glsim.Offscreen) -> None:
    image = np.full((8, 8, 3), 9, np.uint8)
    gluBuild2DMipmapLevels(GL_TEXTURE_2D, GL_RGB, 8, 8, GL_RGB, GL_UNSIGNED_BYTE, 1, 2, 3, image)
    widths = [int(glGetTexLevelParameteriv(GL_TEXTURE_2D, k, GL_TEXTURE_WIDTH)) for k in range(5)]
    assert widths == [0, 0, 4, 2, 0]


def test_image_errors_name_the_call(screen: glsim.Offscreen) -> None:
    image = np.zeros((8, 8, 3), np.uint8)
    with pytest.raises(GLUError, match=r"gluBuild2DMipmaps: format must be .*, not 77 \(invalid enumerant\)"):
        gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 8, 8, 77, GL_UNSIGNED_BYTE, image)
    with pytest.raises(GLUError, match=r"gluScaleImage: widthOut and heightOut must be at least 1"):
        gluScaleImage(GL_RGB, 8, 8, GL_UNSIGNED_BYTE, image, 0, 8, GL_UNSIGNED_BYTE)


def test_a_simple_polygon_of_many_points_needs_no_comparison_of_all_pairs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only neighbours on the sweep line are held against each other; spikes, whose boxes overlap, included."""
    from glsim.glu import tess

    def all_pairs(*arguments: Any) -> Any:
        raise AssertionError("pairs of edges were compared")

    angles = np.linspace(0, 2 * np.pi, 3000, endpoint=False)
    radii = np.where(np.arange(3000) % 2, 1.0, 0.5)
    spikes = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    hole = 0.2 * spikes[::-1]
    compared = 0
    left = tess._left

    def counted(*arguments: Any) -> int:
        nonlocal compared
        compared += 1
        return left(*arguments)

    monkeypatch.setattr(tess, "_near", all_pairs)
    monkeypatch.setattr(tess, "_left", counted)
    corners = triangles([spikes.tolist(), hole.tolist()])
    ring = np.roll(spikes, -1, axis=0)
    expected = abs((spikes[:, 0] * ring[:, 1] - spikes[:, 1] * ring[:, 0]).sum()) / 2 * (1 - 0.2**2)
    assert area(corners) == pytest.approx(expected, rel=1e-6)
    assert compared < 6000 * 100


def test_edges_that_meet_are_found_on_the_sweep_line() -> None:
    from glsim.glu.tess import _apart

    grid = [(0, 0), (10, 10), (0, 10), (10, 0), (5, 5), (20, 20), (3, 0), (3, 10), (10, 5)]
    for one, other, apart in (
        ((0, 1), (2, 3), False),  # crossing
        ((0, 1), (4, 3), False),  # a point on an edge
        ((0, 1), (2, 4), False),
        ((0, 5), (0, 1), False),  # along each other
        ((0, 4), (0, 1), False),
        ((6, 7), (0, 1), False),  # one upright
        ((6, 7), (0, 3), False),
        ((0, 1), (0, 3), True),  # a common end
        ((0, 1), (2, 1), True),
        ((0, 4), (4, 1), True),
        ((6, 7), (4, 8), True),
    ):
        assert _apart(grid, [one, other]) is apart, (one, other)


def test_what_a_row_of_pairs_leaves_out_the_next_has(monkeypatch: pytest.MonkeyPatch) -> None:
    from glsim.glu import tess

    dice = np.random.default_rng(3)
    points, edges = dice.integers(0, 1000, (60, 2)), dice.integers(0, 60, (90, 2))
    low, high = (f(points[edges[:, 0]], points[edges[:, 1]]) for f in (np.minimum, np.maximum))
    meet = ((low[:, None] <= high[None]) & (high[:, None] >= low[None])).all(axis=2)
    expected = {(i, j) for i, j in np.argwhere(meet).tolist() if i < j}
    for most in (1, 7, 1 << 20):
        monkeypatch.setattr(tess, "MOST_PAIRS", most)
        found = [
            tuple(sorted(pair))
            for i, j in tess._near(points, edges)
            for pair in zip(i.tolist(), j.tolist(), strict=True)
        ]
        assert len(found) == len(set(found))
        assert set(found) == expected
