"""A mesh as glsim draws it, and normals for meshes that have none."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.state import Face

Float = NDArray[np.float32]
Uint = NDArray[np.uint32]


@dataclass
class Mesh:
    """Vertices and the triangles and quads between them, counter-clockwise seen from outside.

    positions, normals: (n, 3) float32.  triangles: (m, 3), quads: (k, 4) uint32.
    colors: (n, 4) float32 in [0, 1], or None.  material: None means the scene's default.
    """

    positions: Float
    normals: Float
    triangles: Uint
    quads: Uint
    colors: Float | None = None
    material: Face | None = None


def grid(points: NDArray[Any], normals: NDArray[Any]) -> Mesh:
    """A sheet of quads over points (rows, columns, 3); a quad with a side of no length becomes a triangle.

    The outside is where the rows run down and the columns to the right.
    """
    rows, columns = points.shape[:2]
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = (i * columns + j).ravel()
    quads = np.stack([a, a + columns, a + columns + 1, a + 1], 1)
    positions = points.reshape(-1, 3)
    corners = positions[quads]
    short = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2) < 1e-7
    triangles = [quads[~short.any(axis=1)][:0, :3]]
    for side in range(4):
        collapsed = quads[short[:, side] & (short.sum(axis=1) == 1)]
        triangles.append(np.delete(collapsed, side, axis=1))
    return Mesh(
        positions.astype(np.float32),
        normals.reshape(-1, 3).astype(np.float32),
        np.concatenate(triangles).astype(np.uint32),
        quads[~short.any(axis=1)].astype(np.uint32),
    )


def join(meshes: list[Mesh]) -> Mesh:
    """Several meshes without colours as one."""
    offsets = np.cumsum([0, *(len(mesh.positions) for mesh in meshes[:-1])]).astype(np.uint32)
    return Mesh(
        np.concatenate([mesh.positions for mesh in meshes]),
        np.concatenate([mesh.normals for mesh in meshes]),
        np.concatenate([mesh.triangles + k for mesh, k in zip(meshes, offsets, strict=True)]),
        np.concatenate([mesh.quads + k for mesh, k in zip(meshes, offsets, strict=True)]),
    )


def unit(vectors: NDArray[Any]) -> NDArray[Any]:
    """Vectors (..., 3) made unit length; zero vectors stay zero."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0.0, length, 1.0)


def with_normals(positions: NDArray[np.floating], triangles: Uint, crease: float = 40.0) -> Mesh:
    """A mesh with generated normals, for positions (n, 3) and triangles (m, 3).

    A corner gets the mean of the normals of all triangles at its position, weighted with their angles there (Thuermer
    and Wuethrich, 1998), or, where that differs from its own triangle's normal by more than ``crease`` degrees, its
    own triangle's: smooth surfaces are smooth, the edges of a box stay sharp.
    """
    corners = positions[triangles].astype(np.float64)
    own = unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    to_next, to_last = (unit(np.roll(corners, shift, axis=1) - corners) for shift in (-1, 1))
    angles = np.arccos(np.clip(np.einsum("mck,mck->mc", to_next, to_last), -1, 1))
    _, place = np.unique(positions.astype(np.float32), axis=0, return_inverse=True)
    place = place.reshape(-1)[triangles.astype(np.int64)]  # (m, 3): number of the position of each corner
    count = int(place.max(initial=-1)) + 1
    weighted = angles[:, :, None] * own[:, None, :]
    sums = np.stack([np.bincount(place.ravel(), weighted[..., k].ravel(), minlength=count) for k in range(3)], axis=1)
    smooth = unit(sums)[place]  # (m, 3 corners, 3)
    sharp = np.einsum("mck,mk->mc", smooth, own) < np.cos(np.radians(crease))
    normals = np.where(sharp[..., None], own[:, None, :], smooth)
    if not sharp.any():
        vertex_normals = np.zeros(positions.shape)
        vertex_normals[triangles] = smooth
        return Mesh(positions.astype(np.float32), vertex_normals.astype(np.float32), triangles, _no_quads())
    return Mesh(
        corners.reshape(-1, 3).astype(np.float32),
        normals.reshape(-1, 3).astype(np.float32),
        np.arange(3 * len(triangles), dtype=np.uint32).reshape(-1, 3),
        _no_quads(),
    )


def _no_quads() -> Uint:
    return np.empty((0, 4), np.uint32)


def faceted(mesh: Mesh) -> Mesh:
    """The same triangles and quads with one normal each: low-poly."""
    parts = []
    for faces in (mesh.triangles, mesh.quads):
        if not len(faces):
            continue
        corners = mesh.positions[faces]
        normal = unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, -1] - corners[:, 0]))
        size = faces.shape[1]
        numbers = np.arange(faces.size, dtype=np.uint32).reshape(-1, size)
        empty = np.empty((0, 7 - size), np.uint32)
        triangles, quads = (numbers, empty) if size == 3 else (empty, numbers)
        parts.append(Mesh(corners.reshape(-1, 3), np.repeat(normal, size, axis=0).astype(np.float32), triangles, quads))
    return join(parts)
