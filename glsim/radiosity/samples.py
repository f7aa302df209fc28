"""Sample points in inner loops: where rays between two patches, or from a point to a patch, begin and end.

Results for ``count`` rays of each of k
pairs, one pair after the other: origins, directions (k count, 3) float32; weights (k count,), the rays' shares of the
form factor, cos(theta_1) cos(theta_2) / r^2 times the area that a sample stands for.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from glsim.radiosity.compiled import jit


class Surface(NamedTuple):
    """Where rays to n patches begin and end.

    corners: (n, 4, 3); counts: (n,); normals: (n, 3); of, start, share: of clusters, see patches.Clusters; pieces,
    piece_counts, piece_normals: (m, 4, 3), (m,) and (m, 3), of their pieces.
    """

    corners: Any
    counts: Any
    normals: Any
    of: Any
    start: Any
    share: Any
    pieces: Any
    piece_counts: Any
    piece_normals: Any


@jit
def _point_on(surface: Any, patch: int, u: float, v: float, out: Any, side: Any) -> None:
    """Write the point (u, v) of a patch into out (3,), and the unit normal there into side (3,).

    The pieces of a cluster lie side by side along u, each as wide as its share of the area.
    """
    cluster = surface.of[patch]
    if cluster < 0:
        _point(surface.corners[patch], surface.counts[patch], u, v, out)
        for k in range(3):
            side[k] = surface.normals[patch, k]
        return
    low, high = surface.start[cluster], surface.start[cluster + 1] - 1
    begin = low
    while low < high:
        middle = (low + high) // 2
        if surface.share[middle] > u:
            high = middle
        else:
            low = middle + 1
    before = surface.share[low - 1] if low > begin else 0.0
    u = min(max((u - before) / max(surface.share[low] - before, 1e-300), 0.0), 1.0)
    _point(surface.pieces[low], surface.piece_counts[low], u, v, out)
    for k in range(3):
        side[k] = surface.piece_normals[low, k]


@jit
def rays_between(
    surface: Any, pairs: Any, table: Any, gap: float, first: int, count: int, origins: Any, directions: Any,
    weights: Any,
) -> None:  # fmt: skip
    """Write the rays number ``first`` to ``first + count`` of each pair of patches (k, 2) of a Surface.

    table: (rays, 4) in [0, 1), where each ray begins on the first patch (two numbers) and ends on the second; each pair
    shifts it by four numbers that are hashed from its two patch numbers (splitmix64): results depend on the pair alone.
    gap: how far in front of the patches both ends are, so that a ray does not meet the patches themselves.
    """
    corners, counts, normals = surface.corners, surface.counts, surface.normals
    e, shift = np.empty((2, 4, 3)), np.empty(4)
    ends, sides = np.empty((2, 3)), np.empty((2, 3))
    for row in range(len(pairs)):
        i, j = pairs[row, 0], pairs[row, 1]
        seed = np.uint64(i) * np.uint64(0x9E3779B97F4A7C15) + np.uint64(j) * np.uint64(0xC2B2AE3D27D4EB4F)
        for k in range(4):  # splitmix64
            seed = seed + np.uint64(0x9E3779B97F4A7C15)
            z = seed
            z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
            z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
            z = z ^ (z >> np.uint64(31))
            shift[k] = float(z >> np.uint64(11)) / 9007199254740992.0
        if surface.of[i] >= 0 or surface.of[j] >= 0:
            for s in range(count):
                squared = c_1 = c_2 = 0.0
                for k in range(2):
                    u, v = table[first + s, 2 * k] + shift[2 * k], table[first + s, 2 * k + 1] + shift[2 * k + 1]
                    _point_on(surface, j if k else i, u - (u >= 1.0), v - (v >= 1.0), ends[k], sides[k])
                for k in range(3):
                    d = ends[1, k] - ends[0, k]
                    squared, c_1, c_2 = squared + d * d, c_1 + d * sides[0, k], c_2 - d * sides[1, k]
                    origins[row * count + s, k] = ends[0, k] + gap * sides[0, k]
                    directions[row * count + s, k] = d + gap * (sides[1, k] - sides[0, k])
                shining = c_1 > 0.0 and c_2 > 0.0
                weights[row * count + s] = c_1 * c_2 / (squared * squared) if shining else 0.0
            continue
        o_0, o_u, o_v = _edges(corners[i], counts[i], normals[i], e[0])
        t_0, t_x, t_y = _edges(corners[j], counts[j], normals[j], e[1])
        one, two = counts[i] == 3, counts[j] == 3
        ax, ay, az, bx, by, bz = e[0, 0, 0], e[0, 0, 1], e[0, 0, 2], e[0, 1, 0], e[0, 1, 1], e[0, 1, 2]
        cx, cy, cz, dx, dy, dz = e[0, 2, 0], e[0, 2, 1], e[0, 2, 2], e[0, 3, 0], e[0, 3, 1], e[0, 3, 2]
        fx, fy, fz, gx, gy, gz = e[1, 0, 0], e[1, 0, 1], e[1, 0, 2], e[1, 1, 0], e[1, 1, 1], e[1, 1, 2]
        hx, hy, hz, kx, ky, kz = e[1, 2, 0], e[1, 2, 1], e[1, 2, 2], e[1, 3, 0], e[1, 3, 1], e[1, 3, 2]
        mx, my, mz = normals[i, 0], normals[i, 1], normals[i, 2]
        nx, ny, nz = normals[j, 0], normals[j, 1], normals[j, 2]
        fx, fy, fz = fx - ax, fy - ay, fz - az
        for s in range(count):  # without a loop over x, y, z, for speed
            u, v = table[first + s, 0] + shift[0], table[first + s, 1] + shift[1]
            x, y = table[first + s, 2] + shift[2], table[first + s, 3] + shift[3]
            u, v = u - (u >= 1.0), v - (v >= 1.0)
            x, y = x - (x >= 1.0), y - (y >= 1.0)
            if one and u + v > 1.0:
                u, v = 1.0 - u, 1.0 - v
            if two and x + y > 1.0:
                x, y = 1.0 - x, 1.0 - y
            uv, xy = u * v, x * y
            px, py, pz = u * bx + v * cx + uv * dx, u * by + v * cy + uv * dy, u * bz + v * cz + uv * dz
            wx = fx + x * gx + y * hx + xy * kx - px
            wy = fy + x * gy + y * hy + xy * ky - py
            wz = fz + x * gz + y * hz + xy * kz - pz
            squared = wx * wx + wy * wy + wz * wz
            c_1, c_2 = wx * mx + wy * my + wz * mz, -(wx * nx + wy * ny + wz * nz)
            at = row * count + s
            origins[at, 0] = ax + px + gap * mx
            origins[at, 1] = ay + py + gap * my
            origins[at, 2] = az + pz + gap * mz
            directions[at, 0] = wx + gap * (nx - mx)
            directions[at, 1] = wy + gap * (ny - my)
            directions[at, 2] = wz + gap * (nz - mz)
            density = (o_0 + u * o_u + v * o_v) * (t_0 + x * t_x + y * t_y)
            weights[at] = density * c_1 * c_2 / (squared * squared) if c_1 > 0.0 and c_2 > 0.0 else 0.0


@jit
def rays_from_points(
    points: Any, normals: Any, rows: Any, surface: Any, columns: Any, gap: float, first: int, count: int, origins: Any,
    directions: Any, weights: Any,
) -> None:  # fmt: skip
    """Write the rays number ``first`` to ``first + count`` from points[rows] (k,) to the patches ``columns``
    (k,) of a Surface.

    They end at the points of the two-dimensional sequence of Roberts (2018), the same for every pair.
    """
    corners, counts, patch_normals = surface.corners, surface.counts, surface.normals
    q, side, e = np.empty(3), np.empty(3), np.empty((4, 3))
    for row in range(len(rows)):
        v, j = rows[row], columns[row]
        t_0, t_x, t_y = _edges(corners[j], counts[j], patch_normals[j], e)
        if surface.of[j] >= 0:
            t_0, t_x, t_y = 1.0, 0.0, 0.0
        for s in range(count):
            x, y = 0.5 + (first + s) * 0.7548776662466927, 0.5 + (first + s) * 0.5698402909980532
            x, y = x - np.floor(x), y - np.floor(y)
            _point_on(surface, j, x, y, q, side)
            squared = c_1 = c_2 = 0.0
            at = row * count + s
            for k in range(3):
                d = q[k] - points[v, k]
                squared += d * d
                c_1 += d * normals[v, k]
                c_2 -= d * side[k]
            for k in range(3):
                origins[at, k] = points[v, k] + gap * normals[v, k]
                directions[at, k] = q[k] - points[v, k] + gap * (side[k] - normals[v, k])
            density = t_0 + x * t_x + y * t_y
            weights[at] = density * max(c_1, 0.0) * max(c_2, 0.0) / (squared * squared) if squared > 0.0 else 0.0


@jit
def _edges(polygon: Any, count: int, n: Any, e: Any) -> tuple[float, float, float]:
    """Write a patch as the function e_0 + u e_1 + v e_2 + u v e_3 of u, v in [0, 1] into e (4, 3).

    Returns a, b, c: at (u, v) a patch with unit normal n has the area (a + b u + c v) du dv.
    """
    for k in range(3):
        e[0, k], e[1, k] = polygon[0, k], polygon[1, k] - polygon[0, k]
        if count == 3:
            e[2, k], e[3, k] = polygon[2, k] - polygon[0, k], 0.0
        else:
            e[2, k] = polygon[3, k] - polygon[0, k]
            e[3, k] = polygon[2, k] - polygon[1, k] - e[2, k]
    return _triple(n, e[1], e[2]), _triple(n, e[1], e[3]), _triple(n, e[3], e[2])


@jit
def _triple(n: Any, a: Any, b: Any) -> float:
    """Return the triple product n . (a x b)."""
    return float(
        n[0] * (a[1] * b[2] - a[2] * b[1]) + n[1] * (a[2] * b[0] - a[0] * b[2]) + n[2] * (a[0] * b[1] - a[1] * b[0])
    )


@jit
def _point(polygon: Any, count: int, u: float, v: float, out: Any) -> None:
    """Write the point (u, v) of a patch into out (3,): bilinear in a quad; a triangle is half of a folded square."""
    if count == 3:
        if u + v > 1.0:
            u, v = 1.0 - u, 1.0 - v
        for k in range(3):
            out[k] = polygon[0, k] + u * (polygon[1, k] - polygon[0, k]) + v * (polygon[2, k] - polygon[0, k])
    else:
        for k in range(3):
            a = polygon[0, k] + u * (polygon[1, k] - polygon[0, k])
            b = polygon[3, k] + u * (polygon[2, k] - polygon[3, k])
            out[k] = a + v * (b - a)


@jit
def add_seen(weights: Any, blocked: Any, count: int, group: int, decided: bool, seen: Any, total: Any) -> None:
    """Add the weights of each pair's ``count`` rays to total (k,), and of those that are not blocked to seen (k,).

    Rays are taken in groups of ``group``.  decided: add only groups in which some rays are blocked
    and some are not; visibility.py says why.
    """
    for row in range(len(seen)):
        for first in range(row * count, (row + 1) * count, group):
            free = whole = 0.0
            for ray in range(first, first + group):
                whole += weights[ray]
                if not blocked[ray]:
                    free += weights[ray]
            if not decided or 0.0 < free < whole:
                seen[row] += free
                total[row] += whole
