"""The polygon tessellator: contours of any shape, with holes and crossings, become triangles.

The points are put on a grid of whole numbers, so that every question (on which side is a point? do two edges meet?) has
an exact answer.  The contours cut each other into pieces that meet at their ends only.  A line sweeps over them from
left to right: it counts the winding numbers, which say what lies inside, and cuts the inside into triangles.

Sources: K. Hertel and K. Mehlhorn, Fast triangulation of simple polygons (1983); J. Hobby, Practical segment
intersection with finite precision output (1999).
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from functools import cmp_to_key, partial
from itertools import islice, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.constants import GLU_TESS_MAX_COORD, NAMES
from glsim.glu.errors import one_of, warn

Float = NDArray[np.float64]
Whole = NDArray[np.int64]
Edge = tuple[int, int]  # the numbers of two points
Point = tuple[int, int]  # on the grid
CELLS = 2**30  # of the grid: the products of two differences still fit into 64 bits
MOST_ROUNDS = 60
MOST_PAIRS = 2**20  # of edges that are looked at together
RULES: dict[int, Callable[[int], bool]] = {
    NAMES["GLU_TESS_WINDING_ODD"]: lambda n: n % 2 == 1,
    NAMES["GLU_TESS_WINDING_NONZERO"]: lambda n: n != 0,
    NAMES["GLU_TESS_WINDING_POSITIVE"]: lambda n: n > 0,
    NAMES["GLU_TESS_WINDING_NEGATIVE"]: lambda n: n < 0,
    NAMES["GLU_TESS_WINDING_ABS_GEQ_TWO"]: lambda n: abs(n) >= 2,
}
PROPERTIES: tuple[int, ...] = tuple(
    NAMES[f"GLU_TESS_{name}"] for name in ("WINDING_RULE", "BOUNDARY_ONLY", "TOLERANCE")
)
CALLBACKS = ("BEGIN", "VERTEX", "END", "ERROR", "EDGE_FLAG", "COMBINE")


class Tessellator:
    """gluNewTess: callbacks, properties and the contours of the polygon that is being described."""

    def __init__(self) -> None:
        self.callbacks: dict[str, tuple[Callable[..., Any], bool]] = {}  # name -> function, whether it wants the data
        self.rule: int = NAMES["GLU_TESS_WINDING_ODD"]
        self.boundary_only = False
        self.tolerance = 0.0
        self.normal = np.zeros(3)
        self.contours: list[list[tuple[Float, Any]]] | None = None
        self.open = False  # between gluTessBeginContour and gluTessEndContour
        self.polygon_data: Any = None

    def call(self, name: str, *arguments: Any) -> Any:
        found = self.callbacks.get(name)
        if found is None:
            return None
        function, wants_data = found
        return function(*arguments, self.polygon_data) if wants_data else function(*arguments)

    def fail(self, sentence: str, error: str) -> None:
        """To the callback; without one there is a warning."""
        if "ERROR" not in self.callbacks:
            warn(NAMES[error], sentence)
        else:
            self.call("ERROR", NAMES[error])

    @property
    def depth(self) -> int:
        """0: no polygon is begun; 1: a polygon; 2: a contour."""
        return 0 if self.contours is None else 1 + self.open

    def require(self, depth: int, name: str) -> None:
        """Report each begin or end that is missing before the call ``name``, and go on as if it had been there."""
        while self.depth < depth:
            if self.depth == 0:
                self.fail(f"{name}: gluTessBeginPolygon must come first", "GLU_TESS_MISSING_BEGIN_POLYGON")
                self.contours = []
            else:
                self.fail(f"{name}: gluTessBeginContour must come first", "GLU_TESS_MISSING_BEGIN_CONTOUR")
                gluTessBeginContour(self)
        while self.depth > depth:
            if self.depth == 2:
                self.open = False
                self.fail(f"{name}: gluTessEndContour must come first", "GLU_TESS_MISSING_END_CONTOUR")
            else:
                self.contours = None
                self.fail(f"{name}: gluTessEndPolygon must come first", "GLU_TESS_MISSING_END_POLYGON")


def gluNewTess() -> Tessellator:
    """A new object for the gluTess... functions, without callbacks, with the winding rule GLU_TESS_WINDING_ODD."""
    return Tessellator()


def gluDeleteTess(tess: Tessellator) -> None:
    """Accepted without effect: Python frees the object."""


def gluTessCallback(tess: Tessellator, which: int, function: Callable[..., Any] | None) -> None:
    """function: what is called; None for nothing."""
    for name in CALLBACKS:
        for wants_data in (False, True):
            if which == NAMES[f"GLU_TESS_{name}{'_DATA' if wants_data else ''}"]:
                if function is None:
                    tess.callbacks.pop(name, None)
                else:
                    tess.callbacks[name] = function, wants_data
                return
    sentence = f"gluTessCallback: which must be GLU_TESS_BEGIN, GLU_TESS_VERTEX or another callback, not {which!r}"
    tess.fail(sentence, "GLU_INVALID_ENUM")


def gluTessProperty(tess: Tessellator, which: int, data: float) -> None:
    """The winding rule, whether only the boundary is wanted, and a tolerance, which has no effect."""
    if which == NAMES["GLU_TESS_WINDING_RULE"] and data in RULES:
        tess.rule = int(data)
    elif which == NAMES["GLU_TESS_BOUNDARY_ONLY"]:
        tess.boundary_only = bool(data)
    elif which == NAMES["GLU_TESS_TOLERANCE"] and 0.0 <= data <= 1.0:
        tess.tolerance = float(data)
    elif which in PROPERTIES:
        expected = "from 0 to 1" if which == NAMES["GLU_TESS_TOLERANCE"] else one_of(RULES)
        tess.fail(f"gluTessProperty: data must be {expected}, not {data!r}", "GLU_INVALID_VALUE")
    else:
        tess.fail(f"gluTessProperty: which must be {one_of(PROPERTIES)}, not {which!r}", "GLU_INVALID_ENUM")


def gluGetTessProperty(tess: Tessellator, which: int, data: Any = None) -> Any:
    """The value, also in ``data``, an array of one number, if given."""
    if which not in PROPERTIES:
        tess.fail(f"gluGetTessProperty: which must be {one_of(PROPERTIES)}, not {which!r}", "GLU_INVALID_ENUM")
        return data
    value = float((tess.rule, tess.boundary_only, tess.tolerance)[PROPERTIES.index(which)])
    if data is None:
        return value
    data[0] = value
    return data


def gluTessNormal(tess: Tessellator, x: float, y: float, z: float) -> None:
    """Set the normal of the polygon's plane; (0, 0, 0): glsim computes it from the contours."""
    tess.normal = np.array([x, y, z], np.float64)


def gluTessBeginPolygon(tess: Tessellator, data: Any = None) -> None:
    """data: what the callbacks whose names end in _DATA get."""
    tess.require(0, "gluTessBeginPolygon")
    tess.contours, tess.polygon_data = [], data


def gluTessBeginContour(tess: Tessellator) -> None:
    """Begin a contour of the polygon: its vertices come by gluTessVertex, in order around it."""
    tess.require(1, "gluTessBeginContour")
    assert tess.contours is not None
    tess.contours.append([])
    tess.open = True


def gluTessVertex(tess: Tessellator, location: Any, data: Any = None) -> None:
    """location: x, y, z; data: what the vertex callback gets."""
    tess.require(2, "gluTessVertex")
    x, y, z = (float(c) for c in location[:3])
    if not max(abs(x), abs(y), abs(z)) <= GLU_TESS_MAX_COORD:
        tess.fail("gluTessVertex: location must be within 1e150 of the origin", "GLU_TESS_COORD_TOO_LARGE")
        x, y, z = (min(max(c, -GLU_TESS_MAX_COORD), GLU_TESS_MAX_COORD) if c == c else 0.0 for c in (x, y, z))
    assert tess.contours is not None
    tess.contours[-1].append((np.array([x, y, z]), data))


def gluTessEndContour(tess: Tessellator) -> None:
    """End the contour; its last vertex is joined to its first."""
    tess.require(2, "gluTessEndContour")
    tess.open = False


def gluTessEndPolygon(tess: Tessellator) -> None:
    """Cut the polygon into triangles, or into its boundary, and hand them to the callbacks."""
    tess.require(1, "gluTessEndPolygon")
    assert tess.contours is not None
    contours, tess.contours = [c for c in tess.contours if len(c) > 2], None
    if not contours:
        return
    try:
        plane = _Plane(tess, contours)
    except _NeedCombineError:
        sentence = "gluTessEndPolygon: contours cross, so a GLU_TESS_COMBINE callback must make the new vertex"
        tess.fail(sentence, "GLU_TESS_NEED_COMBINE_CALLBACK")
        return
    boundary = _boundary(plane, RULES[tess.rule])
    if tess.boundary_only:
        for loop in _joined(boundary, plane.grid):
            tess.call("BEGIN", gl.GL_LINE_LOOP)
            for number in loop:
                tess.call("VERTEX", plane.data[number])
            tess.call("END")
        return
    _emit(tess, _triangles(plane, boundary), plane, set(boundary))


# The interface of GLU 1.1


def gluBeginPolygon(tess: Tessellator) -> None:
    """GLU 1.1: begin a polygon and its first contour."""
    gluTessBeginPolygon(tess)
    gluTessBeginContour(tess)


def gluNextContour(tess: Tessellator, type: int = 0) -> None:
    """GLU 1.1: end a contour and begin the next one.  type: ignored, the winding rule says what is a hole."""
    gluTessEndContour(tess)
    gluTessBeginContour(tess)


def gluEndPolygon(tess: Tessellator) -> None:
    """GLU 1.1: end the last contour and the polygon, which is cut into triangles."""
    gluTessEndContour(tess)
    gluTessEndPolygon(tess)


# ---------------------------------------------------------------- the plane


def _normal(contours: list[list[tuple[Float, Any]]]) -> Float:
    """A normal (3,) of the plane of the contours, on the side from which they are counterclockwise.

    It is the normal of a triangle: of the two points farthest apart along a coordinate axis, and of the point that
    makes the largest triangle with them.
    """
    points = np.array([point for contour in contours for point, _ in contour])
    axis = int(np.argmax(np.ptp(points, axis=0)))
    a, b = points[points[:, axis].argmin()], points[points[:, axis].argmax()]
    normals = np.cross(b - a, points - a)
    normal = normals[(normals**2).sum(axis=1).argmax()]
    if not normal.any():
        return np.array([0.0, 0.0, 1.0])  # they lie on a line
    area = np.zeros(3)
    for contour in contours:
        ring = np.array([point for point, _ in contour]) - a
        area += np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0)
    return np.asarray(normal if area @ normal >= 0 else -normal)


def _flat(normal: Float, points: Float) -> Float:
    """Points (n, 3) projected along the coordinate axis that is nearest to the normal: (n, 2).

    A contour that is counterclockwise seen from the tip of the normal stays counterclockwise.
    """
    axis = int(np.argmax(np.abs(normal)))
    side = 1.0 if normal[axis] >= 0 else -1.0
    u, v = points[:, (axis + 1) % 3], points[:, (axis + 2) % 3]
    return np.stack([u * side, v], axis=1)


class _NeedCombineError(Exception):
    """Contours cross, and there is no callback that makes the new vertex."""


class _Plane:
    """The contours on a grid, cut where they meet.

    grid: the points; space: where they are in 3D; data: what the program gave with each, or what its combine callback
    made; edges: (a, b) with a left of b -> how often the contours go from a to b, less how often from b to a.
    """

    def __init__(self, tess: Tessellator, contours: list[list[tuple[Float, Any]]]) -> None:
        self.tess = tess
        self.grid: list[Point] = []
        self.space: list[Float] = []
        self.data: list[Any] = []
        self.numbers: dict[Point, int] = {}
        places = np.array([point for contour in contours for point, _ in contour])
        flat = _flat(tess.normal if tess.normal.any() else _normal(contours), places)
        size = np.ptp(flat, axis=0)
        grid = np.rint((flat - flat.min(axis=0)) / np.where(size > 0, size, 1.0) * CELLS).astype(int).tolist()
        edges: list[Edge] = []
        start = 0
        for contour in contours:
            numbers = [self._given((x, y), *vertex) for (x, y), vertex in zip(grid[start:], contour, strict=False)]
            start += len(contour)
            edges += pairwise([*numbers, numbers[0]])
        self.edges = self._net((edge, 1) for edge in edges)
        for _ in range(MOST_ROUNDS):  # a cut moves to the grid, so an edge may come to meet others
            cuts = {} if _apart(self.grid, self.edges) else self._cuts(list(self.edges))
            if not cuts:
                break
            self.edges = self._net(self._pieces(cuts))

    def _given(self, place: Point, point: Float, data: Any) -> int:
        """The number of a point of a contour.  Points at the same place are one: the combine callback may mix them."""
        number = self.numbers.setdefault(place, len(self.grid))
        if number == len(self.grid):
            self._add(place, point, data)
        elif "COMBINE" in self.tess.callbacks:
            both = [self.data[number], data, None, None]
            mixed = self.tess.call("COMBINE", point.copy(), both, np.array([0.5, 0.5, 0.0, 0.0], np.float32))
            self.data[number] = self.data[number] if mixed is None else mixed
        return number

    def _add(self, place: Point, point: Float, data: Any) -> None:
        self.grid.append(place)
        self.space.append(point)
        self.data.append(data)

    def _net(self, edges: Iterable[tuple[Edge, int]]) -> dict[Edge, int]:
        """Edges that lie on each other as one; those that cancel each other are dropped."""
        net: dict[Edge, int] = {}
        for (a, b), count in edges:
            edge, way = ((a, b), count) if self.grid[a] < self.grid[b] else ((b, a), -count)
            net[edge] = net.get(edge, 0) + way
        return {(a, b): count for (a, b), count in net.items() if count and a != b}

    def _cuts(self, edges: list[Edge]) -> dict[Edge, set[int]]:
        """The points at which each edge has to be cut."""
        cuts: dict[Edge, set[int]] = {}
        if not edges:
            return cuts
        P, ends = np.array(self.grid, np.int64), np.array(edges)
        for first, second in _near(P, ends):
            self._meetings(P, ends, edges, first, second, cuts)
        return cuts

    def _meetings(
        self, P: Whole, ends: Whole, edges: list[Edge], first: Whole, second: Whole, cuts: dict[Edge, set[int]]
    ) -> None:
        """Note in ``cuts`` the points where pairs of edges meet."""
        A, B, C, D = P[ends[first, 0]], P[ends[first, 1]], P[ends[second, 0]], P[ends[second, 1]]
        sides = [_side(C, D, A), _side(C, D, B), _side(A, B, C), _side(A, B, D)]
        a, b, c, d = (np.sign(side) for side in sides)
        crossing = (a * b < 0) & (c * d < 0)
        for k in np.flatnonzero(crossing).tolist():
            one, other = edges[first[k]], edges[second[k]]
            t, u = (float(x[k]) / (float(x[k]) - float(y[k])) for x, y in (sides[:2], sides[2:]))
            number = self._crossing(one, other, t, u)
            for edge in (one, other):
                if number not in edge:
                    cuts.setdefault(edge, set()).add(number)
        touching = [(a == 0, second, A, C, D, first, 0), (b == 0, second, B, C, D, first, 1)]
        touching += [(c == 0, first, C, A, B, second, 0), (d == 0, first, D, A, B, second, 1)]
        for on_line, cut, point, low, high, by, end in touching:
            on_edge = on_line & _between(point, low, high)
            for k in np.flatnonzero(on_edge).tolist():
                cuts.setdefault(edges[cut[k]], set()).add(edges[by[k]][end])

    def _crossing(self, one: Edge, other: Edge, t: float, u: float) -> int:
        """The number of the point where two edges cross: at the fractions t and u of their lengths."""
        (x, y), (x2, y2) = self.grid[one[0]], self.grid[one[1]]
        place = x + round(t * (x2 - x)), y + round(t * (y2 - y))
        if place in self.numbers:
            return self.numbers[place]
        ends = (*one, *other)
        weights = np.array([(1 - t) / 2, t / 2, (1 - u) / 2, u / 2])
        point = np.asarray(weights @ np.array([self.space[end] for end in ends]))
        if "COMBINE" not in self.tess.callbacks:
            raise _NeedCombineError
        given = [self.data[end] for end in ends]
        data = self.tess.call("COMBINE", point.copy(), given, weights.astype(np.float32))
        self.numbers[place] = len(self.grid)
        self._add(place, point, data)
        return self.numbers[place]

    def _pieces(self, cuts: dict[Edge, set[int]]) -> Iterator[tuple[Edge, int]]:
        """The edges cut, with their counts."""
        for (a, b), count in self.edges.items():
            (x, y), (x2, y2) = self.grid[a], self.grid[b]

            def along(n: int, dx: int = x2 - x, dy: int = y2 - y) -> int:
                return self.grid[n][0] * dx + self.grid[n][1] * dy

            for piece in pairwise([a, *sorted(cuts.get((a, b), ()), key=along), b]):
                yield piece, count


def _side(a: Whole, b: Whole, p: Whole) -> Whole:
    """Positive where p is left of the line from a to b, 0 on it: twice the area of the triangle."""
    return (b[:, 0] - a[:, 0]) * (p[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (p[:, 0] - a[:, 0])


def _between(p: Whole, a: Whole, b: Whole) -> NDArray[np.bool_]:
    """Whether p, on the line from a to b, lies strictly between them."""
    inside = ((p >= np.minimum(a, b)) & (p <= np.maximum(a, b))).all(axis=1)
    return np.asarray(inside & (p != a).any(axis=1) & (p != b).any(axis=1))


def _near(P: Whole, edges: Whole) -> Iterator[tuple[Whole, Whole]]:
    """Pairs of edges whose bounding boxes meet, some at a time.

    The edges are sorted along one axis; each is compared with the later ones that begin before it ends.  Of the two
    axes it is the one with fewer such pairs.
    """
    A, B = P[edges[:, 0]], P[edges[:, 1]]
    low, high = np.minimum(A, B), np.maximum(A, B)
    orders = np.argsort(low, axis=0, kind="stable")
    rows = np.arange(len(edges))
    ends = [np.searchsorted(low[orders[:, k], k], high[orders[:, k], k], "right") for k in (0, 1)]
    axis = int(ends[1].sum() < ends[0].sum())
    order, counts = orders[:, axis], ends[axis] - rows - 1
    total = np.cumsum(counts)
    start = 0
    while start < len(edges):
        before = int(total[start - 1]) if start else 0
        stop = max(int(np.searchsorted(total, before + MOST_PAIRS)), start + 1)
        first = np.repeat(rows[start:stop], counts[start:stop])
        second = first + 1 + np.arange(len(first)) - (total - counts)[first] + before
        i, j = order[first], order[second]
        meet = (np.maximum(low[i], low[j]) <= np.minimum(high[i], high[j])).all(axis=1)
        yield i[meet], j[meet]
        start = stop


# ---------------------------------------------------------------- the sweep


def _left(a: Point, b: Point, p: Point) -> int:
    """Positive if p is left of the line from a to b, 0 on it."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _sweep(grid: list[Point], edges: Iterable[Edge]) -> Iterator[tuple[int, int, int, list[Edge]]]:
    """Move a vertical line over the points from left to right, with a list of the edges it meets, from bottom to top.

    Yields (point, place, count, begun) for each point: the ``count`` edges of the list from index ``place`` on end at
    the point, and the edges ``begun``, which start at it, replace them.
    """
    begins: dict[int, list[Edge]] = {}
    for edge in edges:
        begins.setdefault(edge[0], []).append(edge)
        begins.setdefault(edge[1], [])
    met: list[Edge] = []
    for number in sorted(begins, key=grid.__getitem__):
        here = grid[number]
        place = bisect_left(met, True, key=lambda edge: _left(grid[edge[0]], grid[edge[1]], here) <= 0)
        count = 0
        while place + count < len(met) and met[place + count][1] == number:
            count += 1
        begun = _upwards(grid, begins[number])
        met[place : place + count] = begun
        yield number, place, count, begun


def _upwards(grid: list[Point], edges: list[Edge]) -> list[Edge]:
    """Edges to the right of a common point from the lowest slope to the highest."""

    def order(e: Edge, f: Edge) -> int:
        return -_left(grid[e[0]], grid[e[1]], grid[f[1]])

    return sorted(edges, key=cmp_to_key(order))


def _apart(grid: list[Point], edges: Iterable[Edge]) -> bool:
    """Whether the edges meet only at their ends.

    Two edges that cross are neighbours on the sweep line before it reaches the crossing (M. Shamos and D. Hoey,
    Geometric intersection problems, 1976), so only neighbours are compared.
    """
    met: list[Edge] = []
    for number, place, count, begun in _sweep(grid, edges):
        for a, b in met[place : place + count + 1]:  # the first of them that ends elsewhere
            if b != number and _left(grid[a], grid[b], grid[number]) == 0:
                return False  # the point lies on it
        met[place : place + count] = begun
        for k in {place, place + len(begun)}:
            if 0 < k < len(met) and _cross(grid, met[k - 1], met[k]):
                return False
    return True


def _cross(grid: list[Point], one: Edge, other: Edge) -> bool:
    """Whether each of two edges has the ends of the other on both sides."""
    a, b, c, d = (grid[n] for n in (*one, *other))
    return _left(a, b, c) * _left(a, b, d) < 0 and _left(c, d, a) * _left(c, d, b) < 0


def _boundary(plane: _Plane, inside: Callable[[int], bool]) -> list[Edge]:
    """The edges between inside and outside, directed so that the inside is on their left."""
    boundary = []
    windings = [0]  # below, between and above the edges that the line meets
    for _, place, count, begun in _sweep(plane.grid, plane.edges):
        winding = windings[place]
        new = [winding]
        for a, b in begun:
            above = winding + plane.edges[a, b]
            if inside(above) != inside(winding):
                boundary.append((a, b) if inside(above) else (b, a))
            winding = above
            new.append(winding)
        windings[place : place + count + 1] = new
    return boundary


class _Cutter:
    """Cuts the inside of the polygon into triangles while the sweep line moves over it.

    Each part of the sweep line inside the polygon lies between two edges and has a chain: the points, from the lower
    edge to the upper edge, that need triangles on their right.  A chain is convex towards the right, so that the points
    of the chain which a new point sees are consecutive.
    """

    def __init__(self, grid: list[Point]) -> None:
        self.grid = grid
        self.triangles: list[tuple[int, int, int]] = []

    def _cut(self, a: int, b: int, new: int) -> bool:
        """The triangle of the points a and b of a chain, a below b, and a new one, if it has an area."""
        if _left(self.grid[a], self.grid[b], self.grid[new]) >= 0:
            return False
        self.triangles.append((a, new, b))
        return True

    def above(self, chain: deque[int], new: int) -> deque[int]:
        """The upper edge of the chain's part ends at ``new``: cut triangles at the upper end, append ``new``."""
        while len(chain) > 1 and self._cut(chain[-2], chain[-1], new):
            chain.pop()
        chain.append(new)
        return chain

    def below(self, chain: deque[int], new: int) -> deque[int]:
        """The lower edge of the chain's part ends at ``new``: cut triangles at the lower end, prepend ``new``."""
        while len(chain) > 1 and self._cut(chain[0], chain[1], new):
            chain.popleft()
        chain.appendleft(new)
        return chain

    def close(self, chain: deque[int], new: int) -> None:
        """Both edges of the chain's part end at ``new``: cut the triangles between the chain and ``new``."""
        for a, b in pairwise(chain):
            self._cut(a, b, new)

    def split(self, chain: deque[int], new: int) -> tuple[deque[int], deque[int]]:
        """``new`` lies between the two edges: split the chain at its rightmost point.

        Returns the chain below ``new`` and the chain above it; both contain ``new``.
        """
        points = list(chain)
        k = max(range(len(points)), key=lambda k: self.grid[points[k]])  # nothing hides the rightmost point
        return self.above(deque(points[: k + 1]), new), self.below(deque(points[k:]), new)


def _triangles(plane: _Plane, boundary: list[Edge]) -> list[tuple[int, int, int]]:
    """The inside as counterclockwise triangles of point numbers."""
    grid = plane.grid
    cutter = _Cutter(grid)
    chains: list[deque[int] | None] = [None]  # None: outside
    edges = [(a, b) if grid[a] < grid[b] else (b, a) for a, b in boundary]
    for new, place, count, begun in _sweep(grid, edges):
        first, last = chains[place], chains[place + count]
        lower = upper = None
        if count == 0 and first is not None:
            lower, upper = cutter.split(first, new)
        elif count:
            lower = None if first is None else cutter.above(first, new)
            upper = None if last is None else cutter.below(last, new)
        for chain in chains[place + 1 : place + count]:
            if chain is not None:
                cutter.close(chain, new)
        if begun:
            inner = [deque([new]) if (first is None) == (k % 2 == 0) else None for k in range(len(begun) - 1)]
            chains[place : place + count + 1] = [lower, *inner, upper]
        else:
            if lower is not None and upper is not None:
                lower.extend(islice(upper, 1, None))
            chains[place : place + count + 1] = [lower if upper is not None else None]
    return cutter.triangles


def _joined(boundary: list[Edge], grid: list[Point]) -> list[list[int]]:
    """Directed edges as loops; where several go on, the one that turns most to the left, so that loops stay simple."""
    onward: dict[int, list[int]] = {}
    for a, b in boundary:
        onward.setdefault(a, []).append(b)
    loops = []
    while onward:
        loop = [next(iter(onward))]
        while loop[-1] in onward:
            here, before = loop[-1], loop[-2] if len(loop) > 1 else None
            choices = onward[here]
            following = choices[0] if before is None else min(choices, key=partial(_turn, grid, before, here))
            choices.remove(following)
            if not choices:
                del onward[here]
            loop.append(following)
        loops.append(loop[:-1])
    return loops


def _turn(grid: list[Point], before: int, here: int, after: int) -> float:
    """The angle at ``here`` on the left of the way from ``before`` to ``after``."""
    (x, y), (x0, y0), (x1, y1) = grid[here], grid[before], grid[after]
    return (math.atan2(y0 - y, x0 - x) - math.atan2(y1 - y, x1 - x)) % math.tau


def _emit(tess: Tessellator, triangles: list[tuple[int, int, int]], plane: _Plane, boundary: set[Edge]) -> None:
    """Triangles to the callbacks, as one GL_TRIANGLES."""
    if not triangles:
        return
    flags = "EDGE_FLAG" in tess.callbacks
    tess.call("BEGIN", gl.GL_TRIANGLES)
    last: bool | None = None
    for a, b, c in triangles:
        for edge in ((a, b), (b, c), (c, a)):
            if flags and (edge in boundary) != last:
                last = edge in boundary
                tess.call("EDGE_FLAG", last)
            tess.call("VERTEX", plane.data[edge[0]])
    tess.call("END")
