"""Polygons in inner loops: clipping, area, and the form factor from a point."""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.radiosity.compiled import jit

MOST_CORNERS = 6  # a quad clipped by a plane has five


@jit
def dot(a: Any, b: Any) -> float:
    return float(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


@jit
def area(ring: Any, count: int) -> float:
    x = y = z = 0.0
    for k in range(1, count - 1):
        ax, ay, az = ring[k, 0] - ring[0, 0], ring[k, 1] - ring[0, 1], ring[k, 2] - ring[0, 2]
        bx, by, bz = ring[k + 1, 0] - ring[0, 0], ring[k + 1, 1] - ring[0, 1], ring[k + 1, 2] - ring[0, 2]
        x += ay * bz - az * by
        y += az * bx - ax * bz
        z += ax * by - ay * bx
    return float(0.5 * np.sqrt(x * x + y * y + z * z))


@jit
def clip(ring: Any, count: int, n: Any, at: float, out: Any) -> int:
    """The part of a polygon where n.p > at: writes its corners into ``out`` (MOST_CORNERS, 3), returns how many."""
    kept = 0
    for k in range(count):
        a, b = ring[k], ring[(k + 1) % count]
        da, db = dot(n, a) - at, dot(n, b) - at
        if da >= 0.0:
            out[kept] = a
            kept += 1
        if (da > 0.0 and db < 0.0) or (da < 0.0 and db > 0.0):
            t = da / (da - db)
            for c in range(3):
                out[kept, c] = a[c] + t * (b[c] - a[c])
            kept += 1
    return kept


@jit
def lambert(p: Any, n: Any, ring: Any, count: int) -> float:
    """Form factor from a point p with normal n to a polygon on its front side (Lambert 1760):
    1/(2 pi) sum of angle_k (n . unit(r_k x r_k+1)), positive if the polygon turns its front to p."""
    total = 0.0
    ax, ay, az = ring[count - 1, 0] - p[0], ring[count - 1, 1] - p[1], ring[count - 1, 2] - p[2]
    for k in range(count):
        bx, by, bz = ring[k, 0] - p[0], ring[k, 1] - p[1], ring[k, 2] - p[2]
        cx, cy, cz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        length = np.sqrt(cx * cx + cy * cy + cz * cz)
        if length > 0.0:
            angle = np.arctan2(length, ax * bx + ay * by + az * bz)
            total += angle * (n[0] * cx + n[1] * cy + n[2] * cz) / length
        ax, ay, az = bx, by, bz
    return float(-total / (2.0 * np.pi))


@jit
def at_point(point: Any, way: Any, ring: Any, count: int, normal: Any, work: Any) -> float:
    """Form factor from a point with normal ``way`` to the part of a polygon that is in front of it."""
    if dot(normal, point) - dot(normal, ring[0]) <= 0.0:
        return 0.0
    at = dot(way, point)
    above = below = False
    for k in range(count):
        d = dot(way, ring[k]) - at
        above |= d > 0.0
        below |= d < 0.0
    if not above:
        return 0.0
    if not below:
        return float(lambert(point, way, ring, count))
    kept = clip(ring, count, way, at, work)
    return float(lambert(point, way, work, kept)) if kept > 2 else 0.0


@jit
def too_far(point: Any, center: Any, size: float, least: float) -> bool:
    """Whether the form factor from a point to a polygon of diameter ``size`` must be below ``least``: A / (pi r^2),
    with the largest area and the smallest distance that it may have."""
    x, y, z = center[0] - point[0], center[1] - point[1], center[2] - point[2]
    r = np.sqrt(x * x + y * y + z * z) - size / 2.0
    return bool(least >= 1.0 or (r > 0.0 and size * size / 2.0 < least * np.pi * r * r))


@jit
def bilinear(corners: Any, u: float, v: float, k: int) -> float:
    """Bilinear between four corners, u from the first to the second, v from the first to the last."""
    near = corners[0, k] + u * (corners[1, k] - corners[0, k])
    far = corners[3, k] + u * (corners[2, k] - corners[3, k])
    return float(near + v * (far - near))
