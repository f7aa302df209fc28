"""Clipping to the clip volume: section 2.11 of the specification."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine.constants import GL_POLYGON, GL_QUADS, GL_TRIANGLES
from glsim.machine.frame import Draw
from glsim.machine.state import Transform

Float = NDArray[np.float64]
VIEW_PLANES = 6  # the planes of the view volume come before those of glClipPlane

# Kinds of edges of a polygon.  GL_LINE mode draws BOUNDARY and INTRODUCED edges, but no INTERIOR edge.  INTRODUCED:
# made by clipping at a plane of glClipPlane.
INTERIOR, BOUNDARY, INTRODUCED = 0, 1, 2


def edge_kinds(draw: Draw, rings: NDArray[np.uint32]) -> NDArray[np.int64]:
    """The kind (n, k) of the edge from each corner to the next: INTERIOR if glEdgeFlag is GL_FALSE (section 2.6.2).

    rings: (n, k) vertex numbers around each polygon.  Edge flags apply to GL_TRIANGLES, GL_QUADS and GL_POLYGON only.
    """
    if draw.mode not in (GL_TRIANGLES, GL_QUADS, GL_POLYGON) or not draw.block.varies("edge_flag"):
        return np.full(rings.shape, BOUNDARY)
    return np.where(draw.block.column("edge_flag")[rings, 0] != 0.0, BOUNDARY, INTERIOR)


def distances(clip: Float, eye: Float, transform: Transform) -> Float:
    """Signed distances (n, p) from the planes of the clip volume; negative is outside.

    clip, eye: clip and eye coordinates of the vertices, (n, 4).  p: the six planes of the view volume, then the enabled
    planes of glClipPlane.
    """
    x, y, z, w = clip.T
    planes = [w + x, w - x, w + y, w - y, w + z, w - z]
    for plane, enabled in zip(transform.clip_planes, transform.clip_enabled, strict=True):
        if enabled:
            planes.append(eye @ np.array(plane))
    return np.stack(planes, axis=1)


class Clipped(NamedTuple):
    """The part of a primitive that lies inside of all planes: m vertices.

    rows: (m, c).  new: (m,), True for a vertex that clipping made.  edges: (m,), kind of the edge to the next vertex.
    """

    rows: Float
    new: NDArray[np.bool_]
    edges: NDArray[np.int64]


def clipped(rows: Float, distances: Float, edges: NDArray[np.int64] | None = None, introduced: int = 0) -> Clipped:
    """One primitive, rows (k, c), cut where a distance (k, p) is negative (Sutherland and Hodgman).

    edges: for a polygon the kind of the edge from each corner to the next; None for a line or a point.
    introduced: number of the first plane whose new edges are INTRODUCED; those of the planes before it are INTERIOR.
    """
    closed = edges is not None
    left = [(np.append(row, d), False, BOUNDARY) for row, d in zip(rows, distances, strict=True)]
    if edges is not None:
        left = [(row, new, int(edge)) for (row, new, _), edge in zip(left, edges, strict=True)]
    width, count = rows.shape[1], distances.shape[1]
    for number in range(count):
        plane, kept = width + number, []
        for k, (a, new, edge) in enumerate(left):
            b = left[(k + 1) % len(left)][0]
            if a[plane] >= 0.0:
                kept.append((a, new, edge))
            if (closed or k + 1 < len(left)) and (a[plane] >= 0.0) != (b[plane] >= 0.0):
                at = a + a[plane] / (a[plane] - b[plane]) * (b - a)
                leaves = INTRODUCED if number >= introduced else INTERIOR
                kept.append((at, True, leaves if a[plane] >= 0.0 else edge))
        left = kept
    whole = np.array([row for row, _, _ in left]).reshape(-1, width + count)
    return Clipped(whole[:, :width], np.array([new for _, new, _ in left], bool), np.array([e for *_, e in left], int))
