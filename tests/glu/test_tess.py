"""GLU's tessellator: areas and winding numbers, boundaries, edges that meet."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from glsim.gl import *
from glsim.glu import *

Float = NDArray[np.float64]
RULES = {
    "ODD": lambda n: n % 2 == 1, "NONZERO": lambda n: n != 0, "POSITIVE": lambda n: n > 0, "NEGATIVE": lambda n: n < 0,
    "ABS_GEQ_TWO": lambda n: abs(n) >= 2,
}  # fmt: skip


def rule_named(name: str) -> int:
    return int(globals()[f"GLU_TESS_WINDING_{name}"])


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


@settings(max_examples=120)
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


def test_a_simple_polygon_of_many_points_needs_no_comparison_of_all_pairs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only neighbours on the sweep line are held against each other; spikes, whose boxes overlap, included."""
    from glsim.glu import plane, sweep

    def all_pairs(*arguments: Any) -> Any:
        raise AssertionError("pairs of edges were compared")

    angles = np.linspace(0, 2 * np.pi, 3000, endpoint=False)
    radii = np.where(np.arange(3000) % 2, 1.0, 0.5)
    spikes = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    hole = 0.2 * spikes[::-1]
    compared = 0
    left = sweep.left

    def counted(*arguments: Any) -> int:
        nonlocal compared
        compared += 1
        return left(*arguments)

    monkeypatch.setattr(plane, "near", all_pairs)
    monkeypatch.setattr(sweep, "left", counted)
    corners = triangles([spikes.tolist(), hole.tolist()])
    ring = np.roll(spikes, -1, axis=0)
    expected = abs((spikes[:, 0] * ring[:, 1] - spikes[:, 1] * ring[:, 0]).sum()) / 2 * (1 - 0.2**2)
    assert area(corners) == pytest.approx(expected, rel=1e-6)
    assert compared < 6000 * 100


def test_edges_that_meet_are_found_on_the_sweep_line() -> None:
    from glsim.glu.sweep import apart

    grid = [(0, 0), (10, 10), (0, 10), (10, 0), (5, 5), (20, 20), (3, 0), (3, 10), (10, 5)]
    for one, other, expected in (
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
        assert apart(grid, [one, other]) is expected, (one, other)


def test_what_a_row_of_pairs_leaves_out_the_next_has(monkeypatch: pytest.MonkeyPatch) -> None:
    from glsim.glu import plane

    dice = np.random.default_rng(3)
    points, edges = dice.integers(0, 1000, (60, 2)), dice.integers(0, 60, (90, 2))
    low, high = (f(points[edges[:, 0]], points[edges[:, 1]]) for f in (np.minimum, np.maximum))
    meet = ((low[:, None] <= high[None]) & (high[:, None] >= low[None])).all(axis=2)
    expected = {(i, j) for i, j in np.argwhere(meet).tolist() if i < j}
    for most in (1, 7, 1 << 20):
        monkeypatch.setattr(plane, "MOST_PAIRS", most)
        found = [
            tuple(sorted(pair))
            for i, j in plane.near(points, edges)
            for pair in zip(i.tolist(), j.tolist(), strict=True)
        ]
        assert len(found) == len(set(found))
        assert set(found) == expected
