"""The inner loops of the solvers and of links, compiled; S is float32, sums are float64."""

from __future__ import annotations

from typing import Any

import numba as nb
import numpy as np

from glsim.radiosity.kernels import MOST_CORNERS, _area, _dot, at_point, clip, jit, lambert, pair, parallel, too_far


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
    for i in nb.prange(n):
        r = g = b = 0.0
        for j in range(n):
            s = S[i, j]
            r += s * B[j, 0]
            g += s * B[j, 1]
            b += s * B[j, 2]
        out[i, 0], out[i, 1], out[i, 2] = r, g, b


@jit
def along_links(ends: Any, S: Any, B: Any, out: Any) -> None:
    """out_p += S_pq B_q and out_q += S_pq B_p for each link; B, out: (N, 3)."""
    for k in range(len(S)):
        p, q, s = ends[k, 0], ends[k, 1], S[k]
        for c in range(3):
            out[p, c] += s * B[q, c]
            out[q, c] += s * B[p, c]


@parallel
def link_factors(
    rings: Any, counts: Any, normals: Any, centers: Any, sizes: Any, child: Any, pairs: Any, S: Any, spread: Any
) -> None:
    """S (k,) of pairs of nodes (k, 2), nothing in between, and how much the form factor differs between the middles of
    each node's parts, (k, 2): half the difference of the largest and the smallest; 0 for an element."""
    for row in nb.prange(len(pairs)):
        p, q = pairs[row, 0], pairs[row, 1]
        work_1, work_2 = np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3))
        S[row] = pair(
            rings[p], counts[p], normals[p], rings[q], counts[q], normals[q], centers[p], centers[q], sizes[p],
            sizes[q], False, work_1, work_2,
        )  # fmt: skip
        spread[row, 0] = spread[row, 1] = 0.0
        if S[row] > 0.0:
            spread[row, 0] = _spread(centers, normals[p], child[p], rings[q], counts[q], work_1)
            spread[row, 1] = _spread(centers, normals[q], child[q], rings[p], counts[p], work_1)


@jit
def _spread(centers: Any, normal: Any, child: int, ring: Any, count: int, work: Any) -> float:
    if child < 0:
        return 0.0
    low, high = 1e300, 0.0
    kept = clip(ring, count, normal, _dot(normal, centers[child]), work)
    for k in range(4):
        value = max(lambert(centers[child + k], normal, work, kept), 0.0) if kept > 2 else 0.0
        low, high = min(low, value), max(high, value)
    return float(high - low) / 2.0


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
    for row in nb.prange(len(rows)):
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
