"""Cutting patches along the lines where polygons touch: the radiosity is discontinuous there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.bodies import GAP
from glsim.radiosity.near import overlapping
from glsim.radiosity.scene import Scene, area_of

Float = NDArray[np.float64]
Segments = list[tuple[Float, Float]]
LAYER = 2.5 * GAP  # of the scene's size: layers that are nearer to each other cannot be told apart by rays
TOUCHING = 1e-6  # of the scene's size: this near, polygons touch
SLIVER = 1e-3  # of a whole cell's area: smaller pieces are left out


def contacts(scene: Scene, shortest: float = 0.0) -> dict[int, Segments]:
    """Return for each polygon, by its number, the edges of other polygons that lie in its plane and near it.

    They belong to bodies that stand on it, or to coplanar polygons such as a lamp in a ceiling.  Near means that the
    edge's bounding box overlaps the polygon's.  Polygons without such edges are not in the dictionary, nor are edges
    below a length of ``shortest``.
    """
    tolerance, layer = TOUCHING * scene.size, LAYER * scene.size
    many = np.array([len(polygon) for polygon in scene.polygons])
    owner, corners = np.repeat(np.arange(len(many)), many), np.concatenate(scene.polygons)
    begin = np.cumsum(many) - many
    following = np.arange(len(corners)) + 1
    following[begin + many - 1] = begin
    box = np.minimum.reduceat(corners, begin) - layer, np.maximum.reduceat(corners, begin) + layer
    ends = corners[following]
    long = np.flatnonzero(np.linalg.norm(ends - corners, axis=1) > shortest)
    number, edge = overlapping(box, (np.minimum(corners, ends)[long], np.maximum(corners, ends)[long]))
    edge = long[edge]
    origin, normal = corners[begin[number]], scene.normals[number]
    on = owner[edge] != number
    for points in (corners, ends):
        on &= np.abs(np.einsum("nk,nk->n", points[edge] - origin, normal)) < layer
    segments: dict[int, Segments] = {}
    for k, e in zip(number[on].tolist(), edge[on].tolist(), strict=True):
        segments.setdefault(k, []).append((corners[e], ends[e]))
    return {k: _once(some, tolerance) for k, some in segments.items()}


def _once(segments: Segments, tolerance: float) -> Segments:
    """Return the segments without those that run between the same two points as one before, in either direction."""
    keys = [frozenset(tuple(np.round(end / tolerance)) for end in segment) for segment in segments]
    return list(dict(zip(reversed(keys), reversed(segments), strict=True)).values())[::-1]


def near_segments(cells: Float, segments: Segments, normal: Float, tolerance: float) -> NDArray[np.bool_]:
    """Return a mask (k, number of segments): which cells (k, 4, 3) each segment may cut.

    Such a cell has corners on both sides of the segment's line and does not lie wholly beyond one of its ends.
    """
    result = np.zeros((len(cells), len(segments)), bool)
    for number, (a, b) in enumerate(segments):
        along, across = b - a, np.cross(normal, b - a)
        length = float(np.linalg.norm(along))
        side, ahead = (cells - a) @ across / length, (cells - a) @ along / length
        beside = (ahead.max(axis=1) > tolerance) & (ahead.min(axis=1) < length - tolerance)
        result[:, number] = (side.min(axis=1) < -tolerance) & (side.max(axis=1) > tolerance) & beside
    return result


def cut(cell: Float, segments: Segments, normal: Float, scale: float) -> list[Float]:
    """Cut a cell (k, 3) along the segments that go through it into convex pieces of at most four corners."""
    pieces = [cell]
    for a, b in segments:
        pieces = [part for piece in pieces for part in _halves(piece, a, b, normal, TOUCHING * scale)]
    whole = area_of(cell)
    return [part for piece in pieces for part in at_most_four(piece) if area_of(part) > SLIVER * whole]


def _halves(piece: Float, a: Float, b: Float, normal: Float, tolerance: float) -> list[Float]:
    """Cut a piece (k, 3) along the line through a and b, if the segment from a to b goes through it."""
    across = np.cross(normal, b - a)
    sides = (piece - a) @ (across / np.linalg.norm(across))
    if sides.min() > -tolerance or sides.max() < tolerance or not _goes_through(piece, a, b, normal, tolerance):
        return [piece]
    return [_side(piece, sides), _side(piece, -sides)]


def _side(piece: Float, sides: Float) -> Float:
    """Return the part of a piece (k, 3) in which ``sides`` (k,), linear between the corners, is positive."""
    inside = []
    for k in range(len(piece)):
        a, b = sides[k], sides[(k + 1) % len(piece)]
        if a >= 0.0:
            inside.append(piece[k])
        if (a > 0.0 > b) or (a < 0.0 < b):
            inside.append(piece[k] + a / (a - b) * (piece[(k + 1) % len(piece)] - piece[k]))
    return np.array(inside)


def _goes_through(piece: Float, a: Float, b: Float, normal: Float, tolerance: float) -> bool:
    """Return whether a segment is inside a convex polygon for more than a point."""
    enter, leave = 0.0, 1.0
    for p, q in zip(piece, np.roll(piece, -1, axis=0), strict=True):
        inward = np.cross(normal, q - p)
        length = np.linalg.norm(inward)
        if length == 0.0:
            continue
        d_a, d_b = float((a - p) @ inward / length), float((b - p) @ inward / length)
        if d_a <= tolerance and d_b <= tolerance:
            return False
        if d_a != d_b:
            t = d_a / (d_a - d_b)
            if d_a < 0.0:
                enter = max(enter, t)
            elif d_b < 0.0:
                leave = min(leave, t)
    return (leave - enter) * float(np.linalg.norm(b - a)) > tolerance


def at_most_four(polygon: Float) -> list[Float]:
    """Cut a convex polygon into pieces of at most four corners."""
    parts = []
    while len(polygon) > 4:
        parts.append(polygon[:4])
        polygon = np.concatenate([polygon[:1], polygon[3:]])
    return [*parts, polygon] if len(polygon) > 2 else parts
