"""The inner loops of the solvers and of links, compiled; S is float32, sums are float64."""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.radiosity.kernels import (
    MOST_CORNERS,
    _area,
    _dot,
    at_point,
    clip,
    jit,
    lambert,
    pair,
    parallel,
    prange,
    too_far,
)


@jit
def sweep(S: Any, area: Any, rho: Any, E: Any, B: Any, omega: float) -> None:
    """B_i <- (1 - omega) B_i + omega (E_i + rho_i sum_j S_ij B_j / A_i), in order; B (n, 3) is changed."""
    n = len(area)
    for i in range(n):
        r = g = b = 0.0
        for j in range(n):
            s = S[i, j]
            r += s * B[j, 0]
            g += s * B[j, 1]
            b += s * B[j, 2]
        B[i, 0] += omega * (E[i, 0] + rho[i, 0] * r / area[i] - B[i, 0])
        B[i, 1] += omega * (E[i, 1] + rho[i, 1] * g / area[i] - B[i, 1])
        B[i, 2] += omega * (E[i, 2] + rho[i, 2] * b / area[i] - B[i, 2])


@parallel
def product(S: Any, B: Any, out: Any) -> None:
    """out = S B for B (n, 3)."""
    n = len(S)
    for i in prange(n):
        r = g = b = 0.0
        for j in range(n):
            s = S[i, j]
            r += s * B[j, 0]
            g += s * B[j, 1]
            b += s * B[j, 2]
        out[i, 0], out[i, 1], out[i, 2] = r, g, b


@jit
def along_links(ends: Any, S: Any, tilt: Any, B: Any, moments: Any, out: Any, slopes: Any) -> None:
    """Adds to what arrives at nodes: the irradiance times area ``out`` (N, 3) and its slope times area ``slopes``
    (N, 3, 3), channel and direction.  B: means (N, 3); moments: means of B (x - center), (N, 3, 3).

    A link's form factor at x on its first end is S / A (1 + tilt . (x - center)), and so on its second.
    """
    sent = np.empty((2, 3))
    for k in range(len(S)):
        for e in range(2):
            q = ends[k, e]
            for c in range(3):
                sent[e, c] = B[q, c]
                for d in range(3):
                    sent[e, c] += tilt[k, e, d] * moments[q, c, d]
        for e in range(2):
            p = ends[k, e]
            for c in range(3):
                value = S[k] * sent[1 - e, c]
                out[p, c] += value
                for d in range(3):
                    slopes[p, c, d] += value * tilt[k, e, d]


@parallel
def link_factors(
    rings: Any, counts: Any, normals: Any, centers: Any, sizes: Any, child: Any, pairs: Any, S: Any, tilt: Any,
    uneven: Any,
) -> None:  # fmt: skip
    """S (k,) of pairs of nodes (k, 2), nothing in between; for each end how the form factor changes over it, relative
    to its mean: tilt (k, 2, 3); and by how much it differs from that at the middles of its parts, (k, 2).  An element
    has neither."""
    for row in prange(len(pairs)):
        p, q = pairs[row, 0], pairs[row, 1]
        work_1, work_2 = np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3))
        S[row] = pair(
            rings[p], counts[p], normals[p], rings[q], counts[q], normals[q], centers[p], centers[q], sizes[p],
            sizes[q], False, work_1, work_2,
        )  # fmt: skip
        for e in range(2):
            uneven[row, e] = 0.0
            tilt[row, e] = 0.0
            if S[row] > 0.0 and child[p] >= 0:
                uneven[row, e] = _linear(centers, normals[p], p, child[p], rings[q], counts[q], tilt[row, e], work_1)
            p, q = q, p


@jit
def _linear(
    centers: Any, normal: Any, p: int, child: int, ring: Any, count: int, tilt: Any, work: Any
) -> float:  # fmt: skip
    """The linear function that is nearest to the form factor to a polygon at the middles of a node's parts: its slope
    over its mean.  Returns the largest deviation from it there and at the node's own middle."""
    values, at = np.empty(5), np.empty((5, 3))
    for c in range(5):
        here = centers[p] if c == 4 else centers[child + c]
        kept = clip(ring, count, normal, _dot(normal, here), work)
        values[c] = max(lambert(here, normal, work, kept), 0.0) if kept > 2 else 0.0
        at[c] = here - centers[p]
    mean = (values[0] + values[1] + values[2] + values[3]) / 4.0
    if mean <= 0.0:
        return float(values[4])
    x = at[1] - at[0]
    x = x / np.sqrt(_dot(x, x))
    y = np.array([normal[1] * x[2] - normal[2] * x[1], normal[2] * x[0] - normal[0] * x[2],
                  normal[0] * x[1] - normal[1] * x[0]])  # fmt: skip
    xx = xy = yy = fx = fy = 0.0
    for c in range(4):
        u, v, f = _dot(at[c], x), _dot(at[c], y), values[c] - mean
        xx, xy, yy, fx, fy = xx + u * u, xy + u * v, yy + v * v, fx + f * u, fy + f * v
    below = xx * yy - xy * xy
    a, b = (fx * yy - fy * xy) / below, (fy * xx - fx * xy) / below
    least, worst = mean, 0.0
    for c in range(5):
        value = mean + a * _dot(at[c], x) + b * _dot(at[c], y)
        worst = max(worst, abs(values[c] - value))
        least = min(least, mean + 2.0 * (value - mean))  # towards the corners
    share = 1.0 if least >= 0.0 else mean / (mean - least)
    for k in range(3):
        tilt[k] = share * (a * x[k] + b * y[k]) / mean
    return float(worst)


@jit
def links_at(
    points: Any, ways: Any, node: Any, parent: Any, starts: Any, others: Any, rings: Any, counts: Any, normals: Any,
    centers: Any, sizes: Any, least: Any,
) -> Any:  # fmt: skip
    """Form factors from points on leaves ``node`` to what is linked to these or to what they are part of, if more than
    ``least``: numbers of points, nodes, factors."""
    most = 0
    for v in range(len(points)):
        p = node[v]
        while p >= 0:
            most += starts[p + 1] - starts[p]
            p = parent[p]
    rows, columns, factors = np.empty(most, np.int64), np.empty(most, np.int64), np.empty(most)
    kept = 0
    work = np.empty((MOST_CORNERS, 3))
    for v in range(len(points)):
        p = node[v]
        while p >= 0:
            for k in range(starts[p], starts[p + 1]):
                q = others[k]
                if too_far(points[v], centers[q], sizes[q], least[q]):
                    continue
                value = at_point(points[v], ways[v], rings[q], counts[q], normals[q], work)
                if value > least[q]:
                    rows[kept], columns[kept], factors[kept] = v, q, value
                    kept += 1
            p = parent[p]
    return rows[:kept], columns[:kept], factors[:kept]


@parallel
def uneven(
    points: Any, ways: Any, rows: Any, rings: Any, counts: Any, normals: Any, columns: Any, bright: Any, least: float,
    out: Any,
) -> None:  # fmt: skip
    """What is added to the irradiance at points[rows] because patches[columns] are as bright as ``bright`` (n, 4, 3)
    between their corners, and not evenly so bright as their mean: (k, 3).  0 for form factors below ``least``."""
    parts = 4  # along each edge
    for row in prange(len(rows)):
        v, j = rows[row], columns[row]
        work, ring = np.empty((MOST_CORNERS, 3)), np.empty((4, 3))
        whole = at_point(points[v], ways[v], rings[j], counts[j], normals[j], work)
        if whole < least:
            continue
        value, total, area = np.zeros(3), np.zeros(3), 0.0
        for s in range(parts):
            for t in range(parts):
                for c in range(4):
                    u, w = (s + (c == 1 or c == 2)) / parts, (t + (c >= 2)) / parts
                    for k in range(3):
                        ring[c, k] = _between(rings[j], u, w, k)
                factor = at_point(points[v], ways[v], ring, 4, normals[j], work)
                weight = _area(ring, 4)
                area += weight
                for k in range(3):
                    b = _between(bright[j], (s + 0.5) / parts, (t + 0.5) / parts, k)
                    value[k] += factor * b
                    total[k] += weight * b
        for k in range(3):
            out[row, k] = value[k] - whole * total[k] / area


@jit
def _between(corners: Any, u: float, v: float, k: int) -> float:
    """Bilinear between four corners, u from the first to the second, v from the first to the last."""
    near = corners[0, k] + u * (corners[1, k] - corners[0, k])
    far = corners[3, k] + u * (corners[2, k] - corners[3, k])
    return float(near + v * (far - near))
