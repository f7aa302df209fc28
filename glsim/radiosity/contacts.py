"""Cutting patches along the lines where polygons touch: the radiosity is discontinuous there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import Scene, area_of

Float = NDArray[np.float64]
Segments = list[tuple[Float, Float]]
TOUCHING = 1e-6  # of the scene's size: this near, polygons touch
SLIVER = 1e-3  # of a whole cell's area: smaller pieces are left out
MANY = 4000  # polygons: a mesh with more has polygons as small as patches, and no patch is cut


def contacts(scene: Scene) -> dict[int, Segments]:
    """Return for each polygon, by its number, the edges of other polygons that lie in its plane and near it.

    They belong to bodies that stand on it, or to coplanar polygons such as a lamp in a ceiling.  Near means that the
    edge's bounding box overlaps the polygon's.  Polygons without such edges are not in the dictionary.
    """
    if len(scene.polygons) > MANY:
        return {}
    tolerance = TOUCHING * scene.size
    owner = np.repeat(np.arange(len(scene.polygons)), [len(polygon) for polygon in scene.polygons])
    starts = np.concatenate(scene.polygons)
    ends = np.concatenate([np.roll(polygon, -1, axis=0) for polygon in scene.polygons])
    segments: dict[int, Segments] = {}
    for number, (polygon, normal) in enumerate(zip(scene.polygons, scene.normals, strict=True)):
        low, high = polygon.min(axis=0) - tolerance, polygon.max(axis=0) + tolerance
        near = (np.abs((starts - polygon[0]) @ normal) < tolerance) & (np.abs((ends - polygon[0]) @ normal) < tolerance)
        near &= (owner != number) & (np.maximum(starts, ends) >= low).all(axis=1)
        near &= (np.minimum(starts, ends) <= high).all(axis=1)
        if near.any():
            segments[number] = [(starts[k], ends[k]) for k in np.flatnonzero(near)]
    return segments


def near_segments(cells: Float, segments: Segments, normal: Float, tolerance: float) -> NDArray[np.bool_]:
    """Return a mask (k,) of the cells (k, 4, 3) that a segment may cut.

    Such a cell has corners on both sides of the segment's line and does not lie wholly beyond one of its ends.
    """
    result = np.zeros(len(cells), bool)
    for a, b in segments:
        along, across = b - a, np.cross(normal, b - a)
        length = float(np.linalg.norm(along))
        side, ahead = (cells - a) @ across / length, (cells - a) @ along / length
        beside = (ahead.max(axis=1) > tolerance) & (ahead.min(axis=1) < length - tolerance)
        result |= (side.min(axis=1) < -tolerance) & (side.max(axis=1) > tolerance) & beside
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
