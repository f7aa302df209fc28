"""Form factors between two polygons with nothing in between, in inner loops.

S = A_1 F_12 = A_2 F_21 is the double area integral of cos(theta_1) cos(theta_2) / (pi r^2).  The distance decides
how it is found:

    far      Lambert's formula from one point of the smaller polygon to the other, exact over that other polygon
    middle   the same from 2 x 2 Gauss points of a quad, or from three points of each triangle
    near     Stokes' theorem twice: S = 1/(2 pi) sum over pairs of edges of (d_1 . d_2) integral integral ln r ds dt,
             see contour.py

Before that, each polygon is clipped by the plane of the other, so that no part behind it counts.
Sources: Cohen & Wallace, Radiosity and Realistic Image Synthesis (1993), chapter 4; Sparrow (1963) for the contours.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.radiosity.compiled import jit
from glsim.radiosity.contour import contour
from glsim.radiosity.polygon import MOST_CORNERS, area, at_point, clip, dot, lambert, too_far

NEAR, MIDDLE = 3.0, 9.0  # distances, in diameters of the larger polygon
G = 0.5 / np.sqrt(3.0)  # Gauss' points of a square: 1/2 +- G


@jit
def _by_points(one: Any, n_1: int, normal: Any, two: Any, n_2: int, several: bool) -> float:
    """Return the area of polygon ``one`` times the mean over its points of Lambert's formula for polygon ``two``.

    normal: (3,) of ``one``.  several: take Gauss' points (2 x 2 of a quad, 3 of each triangle) instead of the middle.
    """
    p = np.empty(3)
    if several and n_1 == 4:
        total = 0.0
        for i in range(2):
            for j in range(2):
                u, v = 0.5 + (2 * i - 1) * G, 0.5 + (2 * j - 1) * G
                for k in range(3):
                    p[k] = (1 - u) * (1 - v) * one[0, k] + u * (1 - v) * one[1, k] + u * v * one[2, k]
                    p[k] += (1 - u) * v * one[3, k]
                total += lambert(p, normal, two, n_2)
        return float(area(one, n_1) * total / 4.0)
    total = 0.0
    triangle = np.empty((3, 3))
    for m in range(1, n_1 - 1):
        for k in range(3):
            triangle[0, k], triangle[1, k], triangle[2, k] = one[0, k], one[m, k], one[m + 1, k]
        weight = area(triangle, 3)
        if several:
            for corner in range(3):  # exact for polynomials of second degree
                for k in range(3):
                    p[k] = (triangle[0, k] + triangle[1, k] + triangle[2, k] + 3.0 * triangle[corner, k]) / 6.0
                total += weight / 3.0 * lambert(p, normal, two, n_2)
        elif n_1 == 3:
            for k in range(3):
                p[k] = (triangle[0, k] + triangle[1, k] + triangle[2, k]) / 3.0
            total += weight * lambert(p, normal, two, n_2)
    if not several and n_1 > 3:
        for k in range(3):
            p[k] = 0.0
            for m in range(n_1):
                p[k] += one[m, k] / n_1
        total = area(one, n_1) * lambert(p, normal, two, n_2)
    return float(total)


@jit
def pair(
    polygon_1: Any, count_1: int, n_1: Any, polygon_2: Any, count_2: int, n_2: Any, center_1: Any, center_2: Any,
    size_1: float, size_2: float, exact: bool, clipped_1: Any, clipped_2: Any,
) -> float:  # fmt: skip
    """Return S = A_1 F_12 of two polygons (k, 3) with count_1 and count_2 corners; 0 if they show each other no front.

    n: unit normals (3,); center: (3,); size: diameters.  exact: by contours at any distance.  clipped_1, clipped_2:
    (MOST_CORNERS, 3), are overwritten.
    """
    larger = max(size_1, size_2)
    at_1, at_2 = dot(n_1, polygon_1[0]), dot(n_2, polygon_2[0])
    eps = 1e-9 * larger
    behind_1 = behind_2 = front_1 = front_2 = False
    for k in range(count_2):
        d = dot(n_1, polygon_2[k]) - at_1
        front_2 |= d > eps
        behind_2 |= d < -eps
    if not front_2:
        return 0.0
    for k in range(count_1):
        d = dot(n_2, polygon_1[k]) - at_2
        front_1 |= d > eps
        behind_1 |= d < -eps
    if not front_1:
        return 0.0
    one, two = polygon_1, polygon_2
    if behind_2:
        count_2 = clip(polygon_2, count_2, n_1, at_1, clipped_2)
        two = clipped_2
    if behind_1:
        count_1 = clip(polygon_1, count_1, n_2, at_2, clipped_1)
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
        return float(max(_by_points(one, count_1, n_1, two, count_2, several), 0.0))
    return float(max(_by_points(two, count_2, n_2, one, count_1, several), 0.0))


@jit
def rows(
    corners: Any, counts: Any, normals: Any, centers: Any, sizes: Any, first: int, last: int, exact: bool, out: Any
) -> None:
    """Write S of patches ``first`` up to ``last`` with all patches of higher number into out (last - first, n).

    corners: (n, 4, 3); counts, sizes (diameters): (n,); normals, centers: (n, 3).  exact: see ``pair``.
    """
    n = len(corners)
    clipped_1, clipped_2 = np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3))
    for r in range(last - first):
        i = first + r
        for j in range(i + 1, n):
            out[r, j] = pair(
                corners[i], counts[i], normals[i], corners[j], counts[j], normals[j], centers[i], centers[j], sizes[i],
                sizes[j], exact, clipped_1, clipped_2,
            )  # fmt: skip


@jit
def point_factors(
    points: Any, normals: Any, corners: Any, counts: Any, patch_normals: Any, centers: Any, sizes: Any, least: Any,
    out: Any,
) -> None:  # fmt: skip
    """Write the form factors from points (k, 3) with unit normals (k, 3) to all n patches into out (k, n).

    Those below ``least`` (n,) stay 0.  The patches as in ``rows``.
    """
    work = np.empty((MOST_CORNERS, 3))
    for r in range(len(points)):
        for j in range(len(corners)):
            if not too_far(points[r], centers[j], sizes[j], least[j]):
                value = at_point(points[r], normals[r], corners[j], counts[j], patch_normals[j], work)
                out[r, j] = value if value > least[j] else 0.0
