"""Links between the nodes of trees in inner loops, see hierarchy.py.

A node is a patch or a part of one.  Its arrays: corners (N, 4, 3); counts, sizes (diameters) (N,); normals, centers
(N, 3); child (N,), the first of its four parts, -1 for a leaf; parent (N,), -1 for a root.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.radiosity.compiled import jit, parallel, prange
from glsim.radiosity.pairs import pair
from glsim.radiosity.polygon import MOST_CORNERS, at_point, clip, dot, lambert, too_far


@jit
def along_links(ends: Any, S: Any, tilt: Any, B: Any, moments: Any, out: Any, slopes: Any) -> None:
    """Send light along k links in both directions, and add what arrives to ``out`` and ``slopes``.

    ends: (k, 2), the nodes that each link joins; S: (k,), A_p F_pq; tilt: (k, 2, 3): at a point x of either end, with
    area A, the form factor is S / A (1 + tilt . (x - center)).  B: (N, 3), the mean radiosity of each node; moments:
    (N, 3, 3), its mean of B (x - center) by channel and direction.
    out: (N, 3), irradiance times area; slopes: (N, 3, 3), how that changes over the node, by channel and direction.
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
    corners: Any, counts: Any, normals: Any, centers: Any, sizes: Any, child: Any, pairs: Any, S: Any, tilt: Any,
    uneven: Any,
) -> None:  # fmt: skip
    """Write the form factors of pairs of nodes (k, 2) without occlusion, and how these change over each end.

    S: (k,), A_p F_pq.  tilt: (k, 2, 3), see ``along_links``.  uneven: (k, 2), the largest difference between the linear
    form factor and the one at the middles of an end and of its parts.  For leaves tilt and uneven are 0.
    """
    for row in prange(len(pairs)):
        p, q = pairs[row, 0], pairs[row, 1]
        work_1, work_2 = np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3))
        S[row] = pair(
            corners[p], counts[p], normals[p], corners[q], counts[q], normals[q], centers[p], centers[q], sizes[p],
            sizes[q], False, work_1, work_2,
        )  # fmt: skip
        for e in range(2):
            uneven[row, e] = 0.0
            tilt[row, e] = 0.0
            if S[row] > 0.0 and child[p] >= 0:
                uneven[row, e] = _linear(centers, normals[p], p, child[p], corners[q], counts[q], tilt[row, e], work_1)
            p, q = q, p


@jit
def _linear(
    centers: Any, normal: Any, p: int, child: int, polygon: Any, count: int, tilt: Any, work: Any
) -> float:  # fmt: skip
    """Fit a linear function to the form factors from the middles of a node's four parts to a polygon.

    By least squares.  p: the node's number; child: its first part's.  Writes the slope over the mean into tilt (3,).
    Returns the largest deviation of the function from the form factors there and at the node's own middle.
    work: (MOST_CORNERS, 3), is overwritten.
    """
    values, at = np.empty(5), np.empty((5, 3))
    for c in range(5):
        point = centers[p] if c == 4 else centers[child + c]
        left = clip(polygon, count, normal, dot(normal, point), work)
        values[c] = max(lambert(point, normal, work, left), 0.0) if left > 2 else 0.0
        at[c] = point - centers[p]
    mean = (values[0] + values[1] + values[2] + values[3]) / 4.0
    if mean <= 0.0:
        return float(values[4])
    x = at[1] - at[0]
    x = x / np.sqrt(dot(x, x))
    y = np.array([normal[1] * x[2] - normal[2] * x[1], normal[2] * x[0] - normal[0] * x[2],
                  normal[0] * x[1] - normal[1] * x[0]])  # fmt: skip
    xx = xy = yy = fx = fy = 0.0
    for c in range(4):
        u, v, f = dot(at[c], x), dot(at[c], y), values[c] - mean
        xx, xy, yy, fx, fy = xx + u * u, xy + u * v, yy + v * v, fx + f * u, fy + f * v
    below = xx * yy - xy * xy
    a, b = (fx * yy - fy * xy) / below, (fy * xx - fx * xy) / below
    least, worst = mean, 0.0
    for c in range(5):
        value = mean + a * dot(at[c], x) + b * dot(at[c], y)
        worst = max(worst, abs(values[c] - value))
        least = min(least, mean + 2.0 * (value - mean))  # towards the corners
    share = 1.0 if least >= 0.0 else mean / (mean - least)
    for k in range(3):
        tilt[k] = share * (a * x[k] + b * y[k]) / mean
    return float(worst)


@jit
def links_at(
    points: Any, normals: Any, node: Any, parent: Any, starts: Any, others: Any, corners: Any, counts: Any,
    node_normals: Any, centers: Any, sizes: Any, least: Any,
) -> Any:  # fmt: skip
    """Find the nodes that send light to points (m, 3) with unit normals (m, 3) on the leaves ``node`` (m,).

    They are linked to the leaf or to a node that the leaf is part of: node p with others[starts[p] : starts[p + 1]].
    Returns three arrays (f,): numbers of points, numbers of nodes, and the form factors between them, with nothing in
    between.  Those below ``least`` (N,), a limit for each sending node, are left out.
    """
    most = 0
    for v in range(len(points)):
        p = node[v]
        while p >= 0:
            most += starts[p + 1] - starts[p]
            p = parent[p]
    rows, columns, factors = np.empty(most, np.int64), np.empty(most, np.int64), np.empty(most)
    written = 0
    work = np.empty((MOST_CORNERS, 3))
    for v in range(len(points)):
        p = node[v]
        while p >= 0:
            for k in range(starts[p], starts[p + 1]):
                q = others[k]
                if too_far(points[v], centers[q], sizes[q], least[q]):
                    continue
                value = at_point(points[v], normals[v], corners[q], counts[q], node_normals[q], work)
                if value > least[q]:
                    rows[written], columns[written], factors[written] = v, q, value
                    written += 1
            p = parent[p]
    return rows[:written], columns[:written], factors[:written]
