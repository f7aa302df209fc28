"""Single polygons in inner loops: clipping, area, and the form factor from a point.

A polygon is convex and planar: an array (k, 3) of which the first ``count`` rows are corners, counterclockwise as seen
from its front.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.radiosity.compiled import jit

MOST_CORNERS = 6  # a quad clipped by a plane has five


@jit
def dot(a: Any, b: Any) -> float:
    """Return the scalar product of two vectors (3,)."""
    return float(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


@jit
def area(polygon: Any, count: int) -> float:
    """Return the area of a polygon: half the length of the sum of cross products."""
    x = y = z = 0.0
    for k in range(1, count - 1):
        ax, ay, az = polygon[k, 0] - polygon[0, 0], polygon[k, 1] - polygon[0, 1], polygon[k, 2] - polygon[0, 2]
        m = k + 1
        bx, by, bz = polygon[m, 0] - polygon[0, 0], polygon[m, 1] - polygon[0, 1], polygon[m, 2] - polygon[0, 2]
        x += ay * bz - az * by
        y += az * bx - ax * bz
        z += ax * by - ay * bx
    return float(0.5 * np.sqrt(x * x + y * y + z * z))


@jit
def clip(polygon: Any, count: int, n: Any, at: float, out: Any) -> int:
    """Cut off the part of a polygon where n.p < at, for a plane's unit normal n (3,) and distance ``at``.

    Writes the corners of the rest into ``out`` (MOST_CORNERS, 3) and returns how many there are.  (Sutherland and
    Hodgman 1974)
    """
    written = 0
    for k in range(count):  # numbers one by one: numba takes long to compile assignments of arrays
        following = k + 1 if k + 1 < count else 0
        da, db = dot(n, polygon[k]) - at, dot(n, polygon[following]) - at
        if da >= 0.0:
            for c in range(3):
                out[written, c] = polygon[k, c]
            written += 1
        if (da > 0.0 and db < 0.0) or (da < 0.0 and db > 0.0):
            t = da / (da - db)
            for c in range(3):
                out[written, c] = polygon[k, c] + t * (polygon[following, c] - polygon[k, c])
            written += 1
    return written


@jit
def lambert(p: Any, n: Any, polygon: Any, count: int) -> float:
    """Return the form factor from a point p (3,) with unit normal n (3,) to a polygon wholly in front of it.

    It is 1/(2 pi) sum_k angle_k n . unit(r_k x r_k+1), with r_k from p to corner k and angle_k between r_k and r_k+1;
    positive if the polygon turns its front to p.  (Lambert 1760; Cohen & Wallace 1993, section 4.6)
    """
    total = 0.0
    ax, ay, az = polygon[count - 1, 0] - p[0], polygon[count - 1, 1] - p[1], polygon[count - 1, 2] - p[2]
    for k in range(count):
        bx, by, bz = polygon[k, 0] - p[0], polygon[k, 1] - p[1], polygon[k, 2] - p[2]
        cx, cy, cz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        length = np.sqrt(cx * cx + cy * cy + cz * cz)
        if length > 0.0:
            angle = np.arctan2(length, ax * bx + ay * by + az * bz)
            total += angle * (n[0] * cx + n[1] * cy + n[2] * cz) / length
        ax, ay, az = bx, by, bz
    return float(-total / (2.0 * np.pi))


@jit
def at_point(point: Any, normal: Any, polygon: Any, count: int, polygon_normal: Any, work: Any) -> float:
    """Return the form factor from a point (3,) with a unit normal (3,) to the part of a polygon in front of the point.

    0 if the polygon turns its back to the point.  work: (MOST_CORNERS, 3), is overwritten.
    """
    if dot(polygon_normal, point) - dot(polygon_normal, polygon[0]) <= 0.0:
        return 0.0
    at = dot(normal, point)
    above = below = False
    for k in range(count):
        d = dot(normal, polygon[k]) - at
        above |= d > 0.0
        below |= d < 0.0
    if not above:
        return 0.0
    if not below:
        return float(lambert(point, normal, polygon, count))
    left = clip(polygon, count, normal, at, work)
    return float(lambert(point, normal, work, left)) if left > 2 else 0.0


@jit
def too_far(point: Any, center: Any, size: float, least: float) -> bool:
    """Return whether the form factor from a point (3,) to a polygon is certainly below ``least``.

    center: (3,) of the polygon, size: its diameter d.  The form factor is at most A / (pi r^2) with an area A of at
    most d^2 / 2 and a distance r of at least |point - center| - d / 2.
    """
    x, y, z = center[0] - point[0], center[1] - point[1], center[2] - point[2]
    r = np.sqrt(x * x + y * y + z * z) - size / 2.0
    return bool(least >= 1.0 or (r > 0.0 and size * size / 2.0 < least * np.pi * r * r))


@jit
def bilinear(corners: Any, u: float, v: float, k: int) -> float:
    """Return column k between the values (4, 3) at a quad's corners, bilinearly.

    u in [0, 1] runs from the first corner to the second, v from the first to the last.
    """
    near = corners[0, k] + u * (corners[1, k] - corners[0, k])
    far = corners[3, k] + u * (corners[2, k] - corners[3, k])
    return float(near + v * (far - near))
