"""A vertical line sweeps over a polygon, counts the winding numbers, and cuts the inside into triangles.

Points are on a grid of whole numbers, so that every question (on which side is a point? do two edges meet?) has an
exact answer; edges are pairs of their numbers.

Source: K. Hertel and K. Mehlhorn, Fast triangulation of simple polygons (1983).
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from functools import cmp_to_key, partial
from itertools import islice, pairwise

Edge = tuple[int, int]  # the numbers of two points
Point = tuple[int, int]  # on the grid


def left(a: Point, b: Point, p: Point) -> int:
    """Positive if p is left of the line from a to b, 0 on it."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def sweep(grid: list[Point], edges: Iterable[Edge]) -> Iterator[tuple[int, int, int, list[Edge]]]:
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
        point = grid[number]
        place = bisect_left(met, True, key=lambda edge: left(grid[edge[0]], grid[edge[1]], point) <= 0)
        count = 0
        while place + count < len(met) and met[place + count][1] == number:
            count += 1
        begun = _upwards(grid, begins[number])
        met[place : place + count] = begun
        yield number, place, count, begun


def _upwards(grid: list[Point], edges: list[Edge]) -> list[Edge]:
    """Edges to the right of a common point from the lowest slope to the highest."""

    def order(e: Edge, f: Edge) -> int:
        return -left(grid[e[0]], grid[e[1]], grid[f[1]])

    return sorted(edges, key=cmp_to_key(order))


def apart(grid: list[Point], edges: Iterable[Edge]) -> bool:
    """Whether the edges meet only at their ends.

    Two edges that cross are neighbours on the sweep line before it reaches the crossing (M. Shamos and D. Hoey,
    Geometric intersection problems, 1976), so only neighbours are compared.
    """
    met: list[Edge] = []
    for number, place, count, begun in sweep(grid, edges):
        for a, b in met[place : place + count + 1]:  # the first of them that ends elsewhere
            if b != number and left(grid[a], grid[b], grid[number]) == 0:
                return False  # the point lies on it
        met[place : place + count] = begun
        for k in {place, place + len(begun)}:
            if 0 < k < len(met) and _cross(grid, met[k - 1], met[k]):
                return False
    return True


def _cross(grid: list[Point], one: Edge, other: Edge) -> bool:
    """Whether each of two edges has the ends of the other on both sides."""
    a, b, c, d = (grid[n] for n in (*one, *other))
    return left(a, b, c) * left(a, b, d) < 0 and left(c, d, a) * left(c, d, b) < 0


def boundary_of(grid: list[Point], edges: dict[Edge, int], inside: Callable[[int], bool]) -> list[Edge]:
    """The edges between inside and outside, directed so that the inside is on their left.

    edges: as Plane.edges; inside: the winding rule.
    """
    boundary = []
    windings = [0]  # below, between and above the edges that the line meets
    for _, place, count, begun in sweep(grid, edges):
        winding = windings[place]
        new = [winding]
        for a, b in begun:
            above = winding + edges[a, b]
            if inside(above) != inside(winding):
                boundary.append((a, b) if inside(above) else (b, a))
            winding = above
            new.append(winding)
        windings[place : place + count + 1] = new
    return boundary


class Cutter:
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
        if left(self.grid[a], self.grid[b], self.grid[new]) >= 0:
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


def triangles_of(grid: list[Point], boundary: list[Edge]) -> list[tuple[int, int, int]]:
    """The inside as counterclockwise triangles of point numbers."""
    cutter = Cutter(grid)
    chains: list[deque[int] | None] = [None]  # None: outside
    edges = [(a, b) if grid[a] < grid[b] else (b, a) for a, b in boundary]
    for new, place, count, begun in sweep(grid, edges):
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


def loops_of(boundary: list[Edge], grid: list[Point]) -> list[list[int]]:
    """Directed edges as loops; where several go on, the one that turns most to the left, so that loops stay simple."""
    onward: dict[int, list[int]] = {}
    for a, b in boundary:
        onward.setdefault(a, []).append(b)
    loops = []
    while onward:
        loop = [next(iter(onward))]
        while loop[-1] in onward:
            corner, before = loop[-1], loop[-2] if len(loop) > 1 else None
            choices = onward[corner]
            following = choices[0] if before is None else min(choices, key=partial(_turn, grid, before, corner))
            choices.remove(following)
            if not choices:
                del onward[corner]
            loop.append(following)
        loops.append(loop[:-1])
    return loops


def _turn(grid: list[Point], before: int, corner: int, after: int) -> float:
    """The angle at ``corner`` on the left of the path from ``before`` to ``after``."""
    (x, y), (x0, y0), (x1, y1) = grid[corner], grid[before], grid[after]
    return (math.atan2(y0 - y, x0 - x) - math.atan2(y1 - y, x1 - x)) % math.tau
