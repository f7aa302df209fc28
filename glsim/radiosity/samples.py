"""Sample points in inner loops: where rays between two patches, or from a point to a patch, begin and end.

Patches as in patches.Patches: corners (n, 4, 3), counts (n,), normals (n, 3).  Results for ``count`` rays of each of k
pairs, one pair after the other: origins, directions (k count, 3) float32; weights (k count,), the rays' shares of the
form factor, cos(theta_1) cos(theta_2) / r^2 times the area that a sample stands for.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.radiosity.compiled import jit


@jit
def rays_between(
    corners: Any, counts: Any, normals: Any, pairs: Any, table: Any, gap: float, first: int, count: int, origins: Any,
    directions: Any, weights: Any,
) -> None:  # fmt: skip
    """Write the rays number ``first`` to ``first + count`` of each pair of patches (k, 2).

    table: (rays, 4) in [0, 1), where each ray begins on the first patch (two numbers) and ends on the second; each pair
    shifts it by four numbers that are hashed from its two patch numbers (splitmix64): results depend on the pair alone.
    gap: how far in front of the patches both ends are, so that a ray does not meet the patches themselves.
    """
    e, shift = np.empty((2, 4, 3)), np.empty(4)
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
        o_0, o_u, o_v = _edges(corners[i], counts[i], normals[i], e[0])
        t_0, t_x, t_y = _edges(corners[j], counts[j], normals[j], e[1])
        one, two = counts[i] == 3, counts[j] == 3
        (ax, ay, az), (bx, by, bz), (cx, cy, cz), (dx, dy, dz) = e[0]
        (fx, fy, fz), (gx, gy, gz), (hx, hy, hz), (kx, ky, kz) = e[1]
        (mx, my, mz), (nx, ny, nz) = normals[i], normals[j]
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
    points: Any, normals: Any, rows: Any, corners: Any, counts: Any, patch_normals: Any, columns: Any, gap: float,
    first: int, count: int, origins: Any, directions: Any, weights: Any,
) -> None:  # fmt: skip
    """Write the rays number ``first`` to ``first + count`` from points[rows] (k,) to patches[columns] (k,).

    They end at the points of the two-dimensional sequence of Roberts (2018), the same for every pair.
    """
    q, e = np.empty(3), np.empty((4, 3))
    for row in range(len(rows)):
        v, j = rows[row], columns[row]
        t_0, t_x, t_y = _edges(corners[j], counts[j], patch_normals[j], e)
        for s in range(count):
            x, y = 0.5 + (first + s) * 0.7548776662466927, 0.5 + (first + s) * 0.5698402909980532
            x, y = x - np.floor(x), y - np.floor(y)
            _point(corners[j], counts[j], x, y, q)
            squared = c_1 = c_2 = 0.0
            at = row * count + s
            for k in range(3):
                d = q[k] - points[v, k]
                squared += d * d
                c_1 += d * normals[v, k]
                c_2 -= d * patch_normals[j, k]
            for k in range(3):
                origins[at, k] = points[v, k] + gap * normals[v, k]
                directions[at, k] = q[k] - points[v, k] + gap * (patch_normals[j, k] - normals[v, k])
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
