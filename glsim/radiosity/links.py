"""Links between nodes in inner loops."""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.radiosity.compiled import jit, parallel, prange
from glsim.radiosity.pairs import pair
from glsim.radiosity.polygon import MOST_CORNERS, at_point, clip, dot, lambert, too_far


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
        kept = clip(ring, count, normal, dot(normal, here), work)
        values[c] = max(lambert(here, normal, work, kept), 0.0) if kept > 2 else 0.0
        at[c] = here - centers[p]
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
