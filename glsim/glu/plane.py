"""Contours on a grid of whole numbers, cut into pieces that meet at their ends only.

Source: J. Hobby, Practical segment intersection with finite precision output (1999).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.glu.sweep import Edge, Point, apart

Float = NDArray[np.float64]
Whole = NDArray[np.int64]
Contour = list[tuple[Float, Any]]  # points (3,), and what the program gave with each
Combine = Callable[[Float, list[Any], NDArray[np.float32]], Any]
CELLS = 2**30  # of the grid: the products of two differences still fit into 64 bits
MOST_ROUNDS = 60
MOST_PAIRS = 2**20  # of edges that are looked at together


def normal_of(contours: list[Contour]) -> Float:
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
        corners = np.array([point for point, _ in contour]) - a
        area += np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    return np.asarray(normal if area @ normal >= 0 else -normal)


def flat(normal: Float, points: Float) -> Float:
    """Points (n, 3) projected along the coordinate axis that is nearest to the normal: (n, 2).

    A contour that is counterclockwise seen from the tip of the normal stays counterclockwise.
    """
    axis = int(np.argmax(np.abs(normal)))
    side = 1.0 if normal[axis] >= 0 else -1.0
    u, v = points[:, (axis + 1) % 3], points[:, (axis + 2) % 3]
    return np.stack([u * side, v], axis=1)


class NeedCombineError(Exception):
    """Contours cross, and there is no callback that makes the new vertex."""


class Plane:
    """The contours on a grid, cut where they meet.

    grid: the points; space: where they are in 3D; data: what the program gave with each, or what its combine callback
    made; edges: (a, b) with a left of b -> how often the contours go from a to b, less how often from b to a.
    """

    def __init__(self, contours: list[Contour], normal: Float, combine: Combine | None) -> None:
        """normal: (3,), zeros if it is to be computed.

        combine: makes the data of a new vertex from its place in 3D, the data of the four vertices around it,
        and their weights.  Without it NeedCombineError is raised where contours cross.
        """
        self.combine = combine
        self.grid: list[Point] = []
        self.space: list[Float] = []
        self.data: list[Any] = []
        self.numbers: dict[Point, int] = {}
        places = np.array([point for contour in contours for point, _ in contour])
        projected = flat(normal if normal.any() else normal_of(contours), places)
        size = np.ptp(projected, axis=0)
        grid = np.rint((projected - projected.min(axis=0)) / np.where(size > 0, size, 1.0) * CELLS).astype(int).tolist()
        edges: list[Edge] = []
        start = 0
        for contour in contours:
            numbers = [self._given((x, y), *vertex) for (x, y), vertex in zip(grid[start:], contour, strict=False)]
            start += len(contour)
            edges += pairwise([*numbers, numbers[0]])
        self.edges = self._net((edge, 1) for edge in edges)
        for _ in range(MOST_ROUNDS):  # a cut moves to the grid, so an edge may come to meet others
            cuts = {} if apart(self.grid, self.edges) else self._cuts(list(self.edges))
            if not cuts:
                break
            self.edges = self._net(self._pieces(cuts))

    def _given(self, place: Point, point: Float, data: Any) -> int:
        """The number of a point of a contour.  Points at the same place are one: the combine callback may mix them."""
        number = self.numbers.setdefault(place, len(self.grid))
        if number == len(self.grid):
            self._add(place, point, data)
        elif self.combine is not None:
            both = [self.data[number], data, None, None]
            mixed = self.combine(point.copy(), both, np.array([0.5, 0.5, 0.0, 0.0], np.float32))
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
            edge, signed = ((a, b), count) if self.grid[a] < self.grid[b] else ((b, a), -count)
            net[edge] = net.get(edge, 0) + signed
        return {(a, b): count for (a, b), count in net.items() if count and a != b}

    def _cuts(self, edges: list[Edge]) -> dict[Edge, set[int]]:
        """The points at which each edge has to be cut."""
        cuts: dict[Edge, set[int]] = {}
        if not edges:
            return cuts
        P, ends = np.array(self.grid, np.int64), np.array(edges)
        for first, second in near(P, ends):
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
        if self.combine is None:
            raise NeedCombineError
        given = [self.data[end] for end in ends]
        data = self.combine(point.copy(), given, weights.astype(np.float32))
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


def near(P: Whole, edges: Whole) -> Iterator[tuple[Whole, Whole]]:
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
