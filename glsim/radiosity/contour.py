"""The form factor of two polygons as a sum over pairs of their edges: Stokes' theorem, used twice.

Source: Sparrow, A new and simpler formulation for radiative angle factors (1963).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.compiled import jit
from glsim.radiosity.polygon import dot

Float = NDArray[np.float64]

_x, _w = np.polynomial.legendre.leggauss(6)
GAUSS_6 = np.stack([(_x + 1.0) / 2.0, _w / 2.0])
_x, _w = np.polynomial.legendre.leggauss(12)
GAUSS_12 = np.stack([(_x + 1.0) / 2.0, _w / 2.0])


def _tanh_sinh(step: float, count: int) -> Float:
    """Return nodes in (0, 1) and weights, (2, 2 count + 1), for integrands with a logarithm's singularity at both ends.

    Tanh-sinh quadrature (Takahasi and Mori 1974): the nodes cluster at both ends so fast that it converges even if the
    integrand is singular there.
    """
    t = step * np.arange(-count, count + 1)
    u = np.pi / 2.0 * np.sinh(t)
    return np.stack([1.0 / (1.0 + np.exp(-2.0 * u)), step * np.pi / 2.0 * np.cosh(t) / (2.0 * np.cosh(u) ** 2)])


SINGULAR, SINGULAR_FINE = _tanh_sinh(0.28, 11), _tanh_sinh(0.17, 20)


@jit
def _inner(p: Any, a: Any, d: Any, length: float) -> float:
    """Return the exact integral of ln |p - q| over all points q of an edge.

    p: (3,); the edge begins at a (3,) and runs ``length`` along the unit vector d (3,).
    """
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
    """Return d_1 . d_2 times the double integral of ln r over the edges a-b and c-d, d_1 and d_2 being unit vectors.

    The inner integral, over the longer edge, is exact.  The outer one is a quadrature, chosen by how near the edges
    come to each other; ``exact`` takes more nodes.
    """
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
    cosine = dot(one, two) / (length_1 * length_2)
    if abs(cosine) < 1e-14:
        return 0.0
    for k in range(3):
        one[k] /= length_1
        two[k] /= length_2
    # cut the outer integral where the other edge's ends are nearest: there the integrand is not smooth
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
    # measure the distance of the edges at five points too: they may be closest between their ends
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
    """Return S = A_1 F_12 of two polygons of which each is wholly in front of the other.

    one, two: corners (k, 3), of which the first n_1 and n_2 count.  S = 1/(2 pi) times the sum of ``_edges`` over all
    pairs of their edges.
    """
    total = 0.0
    for k in range(n_1):
        for m in range(n_2):
            total += _edges(one[k], one[(k + 1) % n_1], two[m], two[(m + 1) % n_2], exact)
    return float(total / (2.0 * np.pi))
