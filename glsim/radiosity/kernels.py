"""Form factors between polygons without anything in between, compiled by numba.

S = A_1 F_12 = A_2 F_21 is the double area integral of cos(theta_1) cos(theta_2) / (pi r^2).  Three ways, by distance:

    far      Lambert's formula from one point of the smaller polygon to the other, exact over that other polygon
    middle   the same from four points
    near     Stokes' theorem twice: S = 1/(2 pi) sum over pairs of edges of (d_1 . d_2) integral integral ln r ds dt,
             the inner integral exact on the longer edge, the outer one by quadrature that bears ln r's singularity

Before, each polygon is clipped by the plane of the other, so that no part behind it counts.
Sources: Cohen & Wallace, Radiosity and Realistic Image Synthesis (1993), chapter 4; Sparrow (1963) for the contours.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import SceneError

try:
    import numba as nb
except ModuleNotFoundError as error:
    raise SceneError("radiosity needs the package numba: pip install glsim[radiosity]") from error

Float = NDArray[np.float64]
Function = TypeVar("Function", bound=Callable[..., Any])


def _compiled(function: Function, **options: Any) -> Function:
    try:
        compiled: Any = nb.njit(cache=True, nogil=True, error_model="numpy", **options)(function)
    except (RuntimeError, OSError):  # numba finds no folder that it may write into
        compiled = nb.njit(nogil=True, error_model="numpy", **options)(function)
    return compiled  # type: ignore[no-any-return]


def jit(function: Function) -> Function:
    """Compile; the result is kept on disk for the next run, where a folder can be written: NUMBA_CACHE_DIR, glsim's own
    or one in the user's home."""
    return _compiled(function)


def parallel(function: Function) -> Function:
    """The same with threads for nb.prange."""
    return _compiled(function, parallel=True)


def kept(function: Any) -> bool:
    """Whether what was compiled is kept for the next run."""
    return bool(function.stats.cache_path)


prange = nb.prange  # for others, so that the sentence above comes first
NEAR, MIDDLE = 3.0, 9.0  # distances, in diameters of the larger polygon
MOST_CORNERS = 6  # a quad clipped by a plane has five
TINY = 1e-12

_x, _w = np.polynomial.legendre.leggauss(6)
GAUSS_6 = np.stack([(_x + 1.0) / 2.0, _w / 2.0])
_x, _w = np.polynomial.legendre.leggauss(12)
GAUSS_12 = np.stack([(_x + 1.0) / 2.0, _w / 2.0])


def _tanh_sinh(step: float, count: int) -> Float:
    """Nodes in (0, 1), counted from the nearer end with a sign, and weights: exact at ends where f has a logarithm."""
    t = step * np.arange(-count, count + 1)
    u = np.pi / 2.0 * np.sinh(t)
    return np.stack([1.0 / (1.0 + np.exp(-2.0 * u)), step * np.pi / 2.0 * np.cosh(t) / (2.0 * np.cosh(u) ** 2)])


SINGULAR, SINGULAR_FINE = _tanh_sinh(0.28, 11), _tanh_sinh(0.17, 20)


@jit
def _dot(a: Any, b: Any) -> float:
    return float(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


@jit
def clip(ring: Any, count: int, n: Any, at: float, out: Any) -> int:
    """The part of a polygon where n.p > at: writes its corners into ``out`` (MOST_CORNERS, 3), returns how many."""
    kept = 0
    for k in range(count):
        a, b = ring[k], ring[(k + 1) % count]
        da, db = _dot(n, a) - at, _dot(n, b) - at
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
def _inner(p: Any, a: Any, d: Any, length: float) -> float:
    """Integral of ln |p - q| over the edge from a along the unit vector d: exact."""
    rx, ry, rz = p[0] - a[0], p[1] - a[1], p[2] - a[2]
    u_0 = -(rx * d[0] + ry * d[1] + rz * d[2])
    u_1 = u_0 + length
    h_2 = max(rx * rx + ry * ry + rz * rz - u_0 * u_0, 0.0)
    q_0, q_1 = h_2 + u_0 * u_0, h_2 + u_1 * u_1
    result = -length
    if q_1 > 0.0:
        result += 0.5 * u_1 * np.log(q_1)
    if q_0 > 0.0:
        result -= 0.5 * u_0 * np.log(q_0)
    if h_2 > 1e-24 * length * length:
        h = np.sqrt(h_2)
        result += h * np.arctan2(h * length, h_2 + u_0 * u_1) if h_2 + u_0 * u_1 != 0.0 else h * np.pi / 2.0
    return float(result)


@jit
def _edges(a: Any, b: Any, c: Any, d: Any, exact: bool) -> float:
    """(d_1 . d_2) times the double integral of ln r over the edges a-b and c-d."""
    one, two = np.empty(3), np.empty(3)
    length_1 = length_2 = 0.0
    for k in range(3):
        one[k], two[k] = b[k] - a[k], d[k] - c[k]
        length_1 += one[k] * one[k]
        length_2 += two[k] * two[k]
    length_1, length_2 = np.sqrt(length_1), np.sqrt(length_2)
    if length_1 == 0.0 or length_2 == 0.0:
        return 0.0
    if length_1 > length_2:  # the outer integral goes over the shorter edge
        return float(_edges(c, d, a, b, exact))
    cosine = _dot(one, two) / (length_1 * length_2)
    if abs(cosine) < 1e-14:
        return 0.0
    for k in range(3):
        one[k] /= length_1
        two[k] /= length_2
    # where the other edge's ends are nearest: there the integrand is not smooth
    cuts = np.empty(4)
    cuts[0] = 0.0
    pieces = 1
    close = 1e300
    for end in range(2):
        s = 0.0
        for k in range(3):
            s += one[k] * ((c[k] if end == 0 else d[k]) - a[k])
        s = min(max(s, 0.0), length_1)
        gap = 0.0
        for k in range(3):
            gap += (a[k] + s * one[k] - (c[k] if end == 0 else d[k])) ** 2
        gap = np.sqrt(gap)
        close = min(close, gap)
        if gap < 0.35 * length_1 and 1e-9 * length_1 < s < (1.0 - 1e-9) * length_1:
            cuts[pieces] = s
            pieces += 1
    if pieces == 3 and cuts[1] > cuts[2]:
        cuts[1], cuts[2] = cuts[2], cuts[1]
    cuts[pieces] = length_1
    # the edges themselves may come close between their ends
    for t in (0.0, 0.25, 0.5, 0.75, 1.0):
        s = 0.0
        gap = 0.0
        along = 0.0
        for k in range(3):
            along += two[k] * (a[k] + t * length_1 * one[k] - c[k])
        along = min(max(along, 0.0), length_2)
        for k in range(3):
            gap += (a[k] + t * length_1 * one[k] - c[k] - along * two[k]) ** 2
        close = min(close, np.sqrt(gap))
    rule = SINGULAR if close < 0.35 * length_1 else (GAUSS_12 if close < 1.2 * length_1 else GAUSS_6)
    if exact:
        rule = SINGULAR_FINE if close < length_1 else GAUSS_12
    total = 0.0
    p = np.empty(3)
    for piece in range(pieces):
        begin, size = cuts[piece], cuts[piece + 1] - cuts[piece]
        if size <= 0.0:
            continue
        for k in range(rule.shape[1]):
            s = begin + size * rule[0, k]
            for axis in range(3):
                p[axis] = a[axis] + s * one[axis]
            total += size * rule[1, k] * _inner(p, c, two, length_2)
    return float(total * cosine)


@jit
def contour(one: Any, n_1: int, two: Any, n_2: int, exact: bool) -> float:
    """S of two polygons, each wholly in front of the other: 1/(2 pi) sum over edges of d_1.d_2 double integral ln r."""
    total = 0.0
    for k in range(n_1):
        for m in range(n_2):
            total += _edges(one[k], one[(k + 1) % n_1], two[m], two[(m + 1) % n_2], exact)
    return float(total / (2.0 * np.pi))


@jit
def _area(ring: Any, count: int) -> float:
    x = y = z = 0.0
    for k in range(1, count - 1):
        ax, ay, az = ring[k, 0] - ring[0, 0], ring[k, 1] - ring[0, 1], ring[k, 2] - ring[0, 2]
        bx, by, bz = ring[k + 1, 0] - ring[0, 0], ring[k + 1, 1] - ring[0, 1], ring[k + 1, 2] - ring[0, 2]
        x += ay * bz - az * by
        y += az * bx - ax * bz
        z += ax * by - ay * bx
    return float(0.5 * np.sqrt(x * x + y * y + z * z))


G = 0.5 / np.sqrt(3.0)  # Gauss' points of a square: 1/2 +- G


@jit
def _from_points(one: Any, n_1: int, normal: Any, two: Any, n_2: int, several: bool) -> float:
    """A_1 times the mean of Lambert's formula over one or several points of polygon ``one``."""
    p = np.empty(3)
    if several and n_1 == 4:
        total, weight = 0.0, 0.0
        for i in range(2):
            for j in range(2):
                u, v = 0.5 + (2 * i - 1) * G, 0.5 + (2 * j - 1) * G
                for k in range(3):
                    p[k] = (1 - u) * (1 - v) * one[0, k] + u * (1 - v) * one[1, k] + u * v * one[2, k]
                    p[k] += (1 - u) * v * one[3, k]
                total += lambert(p, normal, two, n_2)
                weight += 1.0
        return float(_area(one, n_1) * total / weight)
    total = 0.0
    triangle = np.empty((3, 3))
    for m in range(1, n_1 - 1):
        triangle[0], triangle[1], triangle[2] = one[0], one[m], one[m + 1]
        area = _area(triangle, 3)
        if several:
            for corner in range(3):  # exact for polynomials of second degree
                for k in range(3):
                    p[k] = (triangle[0, k] + triangle[1, k] + triangle[2, k] + 3.0 * triangle[corner, k]) / 6.0
                total += area / 3.0 * lambert(p, normal, two, n_2)
        elif n_1 == 3:
            for k in range(3):
                p[k] = (triangle[0, k] + triangle[1, k] + triangle[2, k]) / 3.0
            total += area * lambert(p, normal, two, n_2)
    if not several and n_1 > 3:
        for k in range(3):
            p[k] = 0.0
            for m in range(n_1):
                p[k] += one[m, k] / n_1
        total = _area(one, n_1) * lambert(p, normal, two, n_2)
    return float(total)


@jit
def pair(
    ring_1: Any, count_1: int, n_1: Any, ring_2: Any, count_2: int, n_2: Any, center_1: Any, center_2: Any,
    size_1: float, size_2: float, exact: bool, clipped_1: Any, clipped_2: Any,
) -> float:  # fmt: skip
    """S = A_1 F_12 of two polygons, nothing in between.  size: diameters.  exact: always by contours.

    clipped_1, clipped_2: (MOST_CORNERS, 3), where to work.
    """
    larger = max(size_1, size_2)
    at_1, at_2 = _dot(n_1, ring_1[0]), _dot(n_2, ring_2[0])
    eps = 1e-9 * larger
    behind_1 = behind_2 = front_1 = front_2 = False
    for k in range(count_2):
        d = _dot(n_1, ring_2[k]) - at_1
        front_2 |= d > eps
        behind_2 |= d < -eps
    if not front_2:
        return 0.0
    for k in range(count_1):
        d = _dot(n_2, ring_1[k]) - at_2
        front_1 |= d > eps
        behind_1 |= d < -eps
    if not front_1:
        return 0.0
    one, two = ring_1, ring_2
    if behind_2:
        count_2 = clip(ring_2, count_2, n_1, at_1, clipped_2)
        two = clipped_2
    if behind_1:
        count_1 = clip(ring_1, count_1, n_2, at_2, clipped_1)
        one = clipped_1
    if count_1 < 3 or count_2 < 3:
        return 0.0
    distance = 0.0
    for k in range(3):
        distance += (center_1[k] - center_2[k]) ** 2
    distance = np.sqrt(distance)
    if exact or distance < NEAR * larger:
        return float(max(contour(one, count_1, two, count_2, exact), 0.0))
    several = distance < MIDDLE * larger
    if size_1 <= size_2:
        return float(max(_from_points(one, count_1, n_1, two, count_2, several), 0.0))
    return float(max(_from_points(two, count_2, n_2, one, count_1, several), 0.0))


@parallel
def rows(
    rings: Any, counts: Any, normals: Any, centers: Any, sizes: Any, first: int, last: int, exact: bool, out: Any
) -> None:
    """S of patches first..last with all patches of higher number: out (last - first, n)."""
    n = len(rings)
    for r in nb.prange(last - first):
        i = first + r
        clipped_1, clipped_2 = np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3))
        for j in range(i + 1, n):
            out[r, j] = pair(
                rings[i], counts[i], normals[i], rings[j], counts[j], normals[j], centers[i], centers[j], sizes[i],
                sizes[j], exact, clipped_1, clipped_2,
            )  # fmt: skip


@jit
def at_point(point: Any, way: Any, ring: Any, count: int, normal: Any, work: Any) -> float:
    """Form factor from a point with normal ``way`` to the part of a polygon that is in front of it."""
    if _dot(normal, point) - _dot(normal, ring[0]) <= 0.0:
        return 0.0
    at = _dot(way, point)
    above = below = False
    for k in range(count):
        d = _dot(way, ring[k]) - at
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


@parallel
def gather(points: Any, ways: Any, rings: Any, counts: Any, normals: Any, centers: Any, sizes: Any, least: Any,
           out: Any) -> None:  # fmt: skip
    """Form factors from k points with normals ``ways`` to all n patches: out (k, n).

    Those below ``least`` (n,) are left at 0.
    """
    for r in nb.prange(len(points)):
        work = np.empty((MOST_CORNERS, 3))
        for j in range(len(rings)):
            if not too_far(points[r], centers[j], sizes[j], least[j]):
                value = at_point(points[r], ways[r], rings[j], counts[j], normals[j], work)
                out[r, j] = value if value > least[j] else 0.0
