"""Parts of rooms, as lists of planar polygons (k, 3) whose fronts look outwards."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim.radiosity.scene import Builder, Material, box, normal_of, planar, quad
from glsim.scenes.mesh import Mesh

Float = NDArray[np.float64]
Polygons = list[Float]
Point = Sequence[float] | Float


def unit(vector: ArrayLike) -> Float:
    """Return a vector (3,) of length 1."""
    v = np.asarray(vector, np.float64)
    return np.asarray(v / np.linalg.norm(v))


def across(direction: Float) -> tuple[Float, Float]:
    """Return two unit vectors that with a direction are right-handed: sideways x up = direction."""
    sideways = unit(np.cross((0.0, 1.0, 0.0) if abs(direction[1]) < 0.99 else (0.0, 0.0, 1.0), direction))
    return sideways, np.cross(direction, sideways)


def ring(middle: Point, direction: ArrayLike, radius: float, sides: int) -> Float:
    """Return a regular polygon (sides, 3) around a point; ``direction`` is its front.  An edge is level."""
    sideways, up = across(unit(direction))
    angle = (np.arange(sides) + 0.5) * 2.0 * np.pi / sides - np.pi / 2.0
    return np.asarray(middle + radius * (np.cos(angle)[:, None] * sideways + np.sin(angle)[:, None] * up))


def between(lower: Float, upper: Float) -> Polygons:
    """Return the quads between two rings (k, 3) of corners; a ring's front looks towards the next."""
    return [
        quad(a, b, d, c) for a, b, c, d in zip(lower, np.roll(lower, -1, 0), upper, np.roll(upper, -1, 0), strict=True)
    ]


def beam(a: Point, b: Point, wide: float, high: float, ends: bool = True) -> Polygons:
    """Return a box from a to b; without ``ends`` where both are inside of other bodies."""
    start, end = np.asarray(a, float), np.asarray(b, float)
    sideways, up = across(unit(end - start))
    corners = [s * wide / 2.0 * sideways + t * high / 2.0 * up for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    lower, upper = start + np.array(corners), end + np.array(corners)
    return [*between(lower, upper), *([lower[::-1], upper] if ends else [])]


def pipe(path: Sequence[Point], radius: float, sides: int = 8, ends: bool = False) -> Polygons:
    """Return a pipe along a path, mitred at its bends; with ``ends`` closed."""
    points = np.array(path, float)
    directions = [unit(step) for step in np.diff(points, axis=0)]
    around = ring(points[0], directions[0], radius, sides)
    result = [around[::-1]] if ends else []
    for k, along in enumerate(directions):
        plane = unit(along + directions[min(k + 1, len(directions) - 1)])
        further = around + ((points[k + 1] - around) @ plane / (along @ plane))[:, None] * along
        result += between(around, further)
        around = further
    return [*result, around] if ends else result


def turned(foot: Point, profile: Sequence[tuple[float, float]], sides: int = 12) -> Polygons:
    """Return a profile of (radius, height), from below upwards, turned around an upright axis through ``foot``."""
    result: Polygons = []
    for (low, y), (high, z) in pairwise(profile):
        lower, upper = (ring(np.add(foot, (0.0, h, 0.0)), (0.0, 1.0, 0.0), r, sides) for r, h in ((low, y), (high, z)))
        corners = [0, 1, 2] if high == 0.0 else [0, 2, 3] if low == 0.0 else [0, 1, 2, 3]
        result += [face[corners] for face in between(lower, upper)]
    return result


def wall(
    corner: Point, along: Point, up: Point, openings: Sequence[tuple[float, float, float, float]] = ()
) -> Polygons:
    """Return a rectangle without its openings, as rectangles; its front looks along ``along`` x ``up``.

    openings: (left, low, right, high) in metres from the corner, beside each other.
    """
    origin, a, b = (np.asarray(v, float) for v in (corner, along, up))
    width, height = float(np.linalg.norm(a)), float(np.linalg.norm(b))
    edges = sorted({0.0, width, *(x for left, _, right, _ in openings for x in (left, right))})
    parts = []
    for left, right in pairwise(edges):
        holes = sorted((low, high) for x, low, y, high in openings if x < (left + right) / 2.0 < y)
        levels = [0.0, *(level for hole in holes for level in hole), height]
        parts += [(left, low, right, high) for low, high in zip(levels[::2], levels[1::2], strict=True) if high > low]
    return [
        np.array([origin + x / width * a + y / height * b for x, y in ((p, q), (r, q), (r, s), (p, s))])
        for p, q, r, s in parts
    ]


def reveal(corner: Point, along: Point, up: Point, deep: float, opening: tuple[float, float, float, float]) -> Polygons:
    """Return the four sides of an opening in a wall (see ``wall``) that is ``deep``, behind its front."""
    origin, a, b = (np.asarray(v, float) for v in (corner, along, up))
    left, low, right, high = opening
    front = np.array(
        [origin + x * unit(a) + y * unit(b) for x, y in ((left, low), (right, low), (right, high), (left, high))]
    )
    return [face[::-1] for face in between(front - deep * unit(np.cross(a, b)), front)]


def stairs(foot: Point, along: Point, steps: int, wide: float, rise: float = 0.19) -> tuple[Polygons, Polygons]:
    """Return treads and the two beams that carry them; ``along``: the level way of the whole flight."""
    start, way = np.asarray(foot, float), np.asarray(along, float)
    side = unit(np.cross(way, (0.0, 1.0, 0.0)))
    treads: Polygons = []
    for k in range(1, steps):
        middle = start + way * (k / steps) + (0.0, k * rise, 0.0)
        half = wide / 2.0 * side
        treads += beam(middle - half, middle + half, 0.9 * float(np.linalg.norm(way)) / steps, 0.05)
    top = start + way + (0.0, steps * rise, 0.0)
    carriers = [
        beam(start + (0.0, 0.16, 0.0) + s * wide / 2.0 * side, top + s * wide / 2.0 * side, 0.06, 0.26, ends=False)
        for s in (-1.0, 1.0)
    ]
    return treads, [face for carrier in carriers for face in carrier]


def placed(mesh: Mesh, at: Point, size: float, turn: float = 0.0) -> Polygons:
    """Return a mesh's polygons, ``size`` high and turned around the upright axis by degrees, standing at a point."""
    points = mesh.positions.astype(np.float64)
    low, high = points.min(axis=0), points.max(axis=0)
    points = (points - [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2]) * (size / (high[1] - low[1]))
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    points = points @ np.array([(c, 0, -s), (0, 1, 0), (s, 0, c)]) + at
    faces = [points[face] for face in (*mesh.triangles, *mesh.quads)]
    return [part for face in faces for part in planar(face)]


def tiled(b: Builder, polygons: Polygons, material: Material, size: float) -> None:
    """Add polygons whose texture repeats after ``size`` metres; on walls t goes upwards.."""
    normals = np.round([normal_of(polygon) for polygon in polygons], 6)
    for normal in np.unique(normals, axis=0):
        x, y, z = np.abs(normal)
        axes = (0, 2) if y > max(x, z) else (2, 1) if x > z else (0, 1)
        some = [polygon for polygon, own in zip(polygons, normals, strict=True) if (own == normal).all()]
        b.add(some, material, smooth=True, st=[polygon[:, axes] / size for polygon in some])


def block(low: Point, high: Point, without: str = "-y") -> Polygons:
    """Return the faces of a box but those named, as in "-y +z": the ones that lie on a floor or a wall."""
    names = ("-x", "+x", "-y", "+y", "-z", "+z")
    return [face for name, face in zip(names, box(tuple(low), tuple(high)), strict=True) if name not in without]


def facing(polygon: Float, point: Point) -> Float:
    """Return a polygon with its front towards a point."""
    return polygon if normal_of(polygon) @ (np.asarray(point, float) - polygon[0]) > 0.0 else polygon[::-1]


def both(polygons: Polygons) -> Polygons:
    """Return sheets with two fronts."""
    return [side for polygon in polygons for side in (polygon, polygon[::-1])]


def moved(polygons: Polygons, by: Point) -> Polygons:
    """Return polygons at another place."""
    return [polygon + np.asarray(by, float) for polygon in polygons]
