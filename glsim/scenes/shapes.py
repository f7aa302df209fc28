"""Built-in shapes: sphere, torus, cube, terrain and the Utah teapot."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.scenes.mesh import Mesh, grid, join, unit

Array = NDArray[np.float64]


def sphere(slices: int = 32) -> Mesh:
    """Unit sphere of ``slices`` meridians and half as many bands; normals are exact."""
    theta = np.linspace(0, np.pi, max(slices // 2, 2) + 1)[:, None]
    phi = np.linspace(0, 2 * np.pi, slices + 1)[None, :]
    ring = np.sin(theta)
    ring[[0, -1]] = 0.0
    points = np.stack([ring * np.sin(phi), np.cos(theta) + 0 * phi, ring * np.cos(phi)], axis=2)
    return grid(points, points)


def torus(slices: int = 48) -> Mesh:
    """Torus of radius 1 around y, tube radius 0.4; normals are exact."""
    around = np.linspace(0, 2 * np.pi, slices + 1)[None, :]
    tube = np.linspace(0, -2 * np.pi, slices // 2 + 1)[:, None]
    out = np.stack([np.cos(tube) * np.sin(around), np.sin(tube) + 0 * around, np.cos(tube) * np.cos(around)], axis=2)
    ring = np.stack([np.sin(around), 0 * around, np.cos(around)], axis=2)
    return grid(ring + 0.4 * out, out)


def cube(slices: int = 1) -> Mesh:
    """Cube of edge 2, each face cut into slices x slices quads."""
    t = np.linspace(-1, 1, slices + 1)
    x, y = np.meshgrid(t, -t)
    face = np.stack([x, y, np.ones_like(x)], axis=2)
    normal = np.broadcast_to((0.0, 0.0, 1.0), face.shape)
    turns = [
        np.eye(3)[[0, 1, 2]],
        np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
        np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]]),
    ]
    turns += [turn @ np.diag([-1.0, 1.0, -1.0]) for turn in turns]
    return join([grid(face @ turn.T, normal @ turn.T) for turn in turns])


# Waves whose sum is the terrain: height, wave vector (x, z), phase.
_WAVES = (
    (0.28, 1.9, 0.7, 0.3), (0.20, -1.1, 2.6, 1.7), (0.13, 3.7, 2.1, 4.0), (0.09, -4.9, 3.3, 2.2),
    (0.055, 6.3, -5.1, 0.9), (0.03, 9.7, 8.3, 5.1),
)  # fmt: skip


def terrain(slices: int = 96) -> Mesh:
    """Hills over [-1.5, 1.5]^2 in x and z, y up; normals from the exact gradient."""
    t = np.linspace(-1.5, 1.5, slices + 1)
    x, z = np.meshgrid(t, t)
    y, dx, dz = np.zeros_like(x), np.zeros_like(x), np.zeros_like(x)
    for height, kx, kz, phase in _WAVES:
        angle = kx * x + kz * z + phase
        y += height * np.sin(angle)
        dx += height * kx * np.cos(angle)
        dz += height * kz * np.cos(angle)
    return grid(np.stack([x, y, z], axis=2), unit(np.stack([-dx, np.ones_like(x), -dz], axis=2)))


def teapot(slices: int = 8) -> Mesh:
    """The Utah teapot from its Bezier patches, each cut into slices x slices quads; about 2 high, y up.

    Normals are the cross product of the exact partial derivatives.
    """
    t = np.linspace(0.0, 1.0, slices + 1)
    return join([_patch(patch, t) for patch in patches()])


def patches() -> Array:
    """The 32 bicubic patches: control points (32, 4, 4, 3) as published, z up.

    The table has a quarter of the body, lid and bottom, and half of handle and spout; the rest are mirror images.
    """
    points = np.array(_POINTS.split(), float).reshape(-1, 3)
    result = []
    for number, line in enumerate(_PATCHES.strip().splitlines()):
        patch = points[np.array(line.split(), int)].reshape(4, 4, 3)
        mirrored_x, mirrored_y = (patch[:, ::-1] * m for m in ((-1, 1, 1), (1, -1, 1)))
        result += [patch, mirrored_y]
        if number < 6:  # not handle and spout
            result += [mirrored_x, patch * (-1, -1, 1)]
    return np.array(result)


def _bernstein(t: Array) -> tuple[Array, Array]:
    """The four cubic Bernstein polynomials at t and their derivatives, (n, 4) each."""
    s = 1 - t
    values = np.stack([s**3, 3 * s * s * t, 3 * s * t * t, t**3], axis=1)
    slopes = np.stack([-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t], axis=1)
    return values, slopes


def _patch(control: Array, t: Array) -> Mesh:
    inside = np.clip(t, 1e-3, 1 - 1e-3)  # where a patch shrinks to a point, the normal is the one next to it
    b, _ = _bernstein(t)
    bi, di = _bernstein(inside)
    points = np.einsum("ia,jb,abk->ijk", b, b, control)
    du = np.einsum("ia,jb,abk->ijk", di, bi, control)
    dv = np.einsum("ia,jb,abk->ijk", bi, di, control)
    normals = unit(np.cross(dv, du))
    y_up = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]]) / 1.5
    return grid(((points - (0, 0, 1.575)) @ y_up.T)[:, ::-1], (normals @ (1.5 * y_up).T)[:, ::-1])


# Martin Newell's control points (1975) in the reduced form that GLUT ships: rim, body (2), lid (2), bottom,
# handle (2), spout (2).
_PATCHES = """
102 103 104 105 4 5 6 7 8 9 10 11 12 13 14 15
12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27
24 25 26 27 29 30 31 32 33 34 35 36 37 38 39 40
96 96 96 96 97 98 99 100 101 101 101 101 0 1 2 3
0 1 2 3 106 107 108 109 110 111 112 113 114 115 116 117
118 118 118 118 124 122 119 121 123 126 125 120 40 39 38 37
41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56
53 54 55 56 57 58 59 60 61 62 63 64 28 65 66 67
68 69 70 71 72 73 74 75 76 77 78 79 80 81 82 83
80 81 82 83 84 85 86 87 88 89 90 91 92 93 94 95
"""
_POINTS = """
0.2 0 2.7  0.2 -0.112 2.7  0.112 -0.2 2.7  0 -0.2 2.7  1.3375 0 2.53125  1.3375 -0.749 2.53125
0.749 -1.3375 2.53125  0 -1.3375 2.53125  1.4375 0 2.53125  1.4375 -0.805 2.53125  0.805 -1.4375 2.53125
0 -1.4375 2.53125  1.5 0 2.4  1.5 -0.84 2.4  0.84 -1.5 2.4  0 -1.5 2.4  1.75 0 1.875  1.75 -0.98 1.875
0.98 -1.75 1.875  0 -1.75 1.875  2 0 1.35  2 -1.12 1.35  1.12 -2 1.35  0 -2 1.35  2 0 0.9  2 -1.12 0.9  1.12 -2 0.9
0 -2 0.9  -2 0 0.9  2 0 0.45  2 -1.12 0.45  1.12 -2 0.45  0 -2 0.45  1.5 0 0.225  1.5 -0.84 0.225  0.84 -1.5 0.225
0 -1.5 0.225  1.5 0 0.15  1.5 -0.84 0.15  0.84 -1.5 0.15  0 -1.5 0.15  -1.6 0 2.025  -1.6 -0.3 2.025
-1.5 -0.3 2.25  -1.5 0 2.25  -2.3 0 2.025  -2.3 -0.3 2.025  -2.5 -0.3 2.25  -2.5 0 2.25  -2.7 0 2.025
-2.7 -0.3 2.025  -3 -0.3 2.25  -3 0 2.25  -2.7 0 1.8  -2.7 -0.3 1.8  -3 -0.3 1.8  -3 0 1.8  -2.7 0 1.575
-2.7 -0.3 1.575  -3 -0.3 1.35  -3 0 1.35  -2.5 0 1.125  -2.5 -0.3 1.125  -2.65 -0.3 0.9375  -2.65 0 0.9375
-2 -0.3 0.9  -1.9 -0.3 0.6  -1.9 0 0.6  1.7 0 1.425  1.7 -0.66 1.425  1.7 -0.66 0.6  1.7 0 0.6  2.6 0 1.425
2.6 -0.66 1.425  3.1 -0.66 0.825  3.1 0 0.825  2.3 0 2.1  2.3 -0.25 2.1  2.4 -0.25 2.025  2.4 0 2.025  2.7 0 2.4
2.7 -0.25 2.4  3.3 -0.25 2.4  3.3 0 2.4  2.8 0 2.475  2.8 -0.25 2.475  3.525 -0.25 2.49375  3.525 0 2.49375
2.9 0 2.475  2.9 -0.15 2.475  3.45 -0.15 2.5125  3.45 0 2.5125  2.8 0 2.4  2.8 -0.15 2.4  3.2 -0.15 2.4  3.2 0 2.4
0 0 3.15  0.8 0 3.15  0.8 -0.45 3.15  0.45 -0.8 3.15  0 -0.8 3.15  0 0 2.85  1.4 0 2.4  1.4 -0.784 2.4
0.784 -1.4 2.4  0 -1.4 2.4  0.4 0 2.55  0.4 -0.224 2.55  0.224 -0.4 2.55  0 -0.4 2.55  1.3 0 2.55
1.3 -0.728 2.55  0.728 -1.3 2.55  0 -1.3 2.55  1.3 0 2.4  1.3 -0.728 2.4  0.728 -1.3 2.4  0 -1.3 2.4  0 0 0
1.425 -0.798 0  1.5 0 0.075  1.425 0 0  0.798 -1.425 0  0 -1.5 0.075  0 -1.425 0  1.5 -0.84 0.075  0.84 -1.5 0.075
"""
