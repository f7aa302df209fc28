"""A mesh as glsim draws it, and normals for meshes that have none."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.state import Face

Float = NDArray[np.float32]
Uint = NDArray[np.uint32]


class MeshError(ValueError):
    """A mesh file that cannot be drawn; the message names the file and what is wrong with it."""


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

    Seen from outside, rows follow each other downwards and columns to the right; quads are then counter-clockwise.
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


BLOCK = 1 << 19  # triangles worked on at a time, so that a mesh of millions needs little more memory than itself


def blocks(triangles: NDArray[Any]) -> Iterator[slice]:
    return (slice(first, first + BLOCK) for first in range(0, len(triangles), BLOCK))


def area_vectors(positions: NDArray[Any], triangles: Uint) -> NDArray[Any]:
    """Normals of triangles (m, 3) as long as twice their areas: (m, 3) float64."""
    a, b, c = (positions[triangles[:, k]].astype(np.float64) for k in range(3))
    return np.cross(b - a, c - a)


def with_normals(positions: NDArray[Any], triangles: Uint, crease: float = 40.0) -> Mesh:
    """A mesh with generated normals, for positions (n, 3) and triangles (m, 3).

    A corner of a triangle gets the mean of the normals of the triangles at its position that make at most ``crease``
    degrees with its own, weighted with their angles there (Thuermer and Wuethrich, 1998): smooth surfaces are smooth,
    the edges of a box stay sharp, and the round side of a tin is round up to its rim.  Vertices are shared where all
    corners at a position have one normal in the whole mesh; else each triangle has its own three.
    """
    positions = positions.astype(np.float32)
    _, place = np.unique(positions.view(np.dtype((np.void, 12))).ravel(), return_inverse=True)
    place = place.reshape(-1)  # vertices at one position have one number
    sums = np.zeros((int(place.max(initial=-1)) + 1, 3))
    for block in blocks(triangles):
        face_normals, angles = _corners(positions, triangles[block])
        for corner in range(3):
            where, weighted = place[triangles[block, corner]], angles[:, corner, None] * face_normals
            for axis in range(3):
                sums[:, axis] += np.bincount(where, weighted[:, axis], minlength=len(sums))
    mean = unit(sums)
    shared = Mesh(positions, mean.astype(np.float32)[place], triangles, _no_quads())

    bent = np.zeros(len(sums), bool)  # positions where two triangles can make more than ``crease``: one is half off
    for block in blocks(triangles):
        at = place[triangles[block]]
        face_normals = unit(area_vectors(positions, triangles[block]))
        bent[at[np.einsum("mck,mk->mc", mean[at], face_normals) < np.cos(np.radians(crease / 2)) + 1e-9]] = True
    corners = np.flatnonzero(bent[place[triangles.ravel()]])
    corner_normals = shared.normals[triangles.ravel()]
    corner_normals[corners], sharp = _within(positions, triangles, place, corners, crease)
    if not sharp:
        return shared
    order = np.arange(triangles.size, dtype=np.uint32).reshape(-1, 3)
    return Mesh(positions[triangles.ravel()], corner_normals, order, _no_quads())


def _corners(positions: Float, triangles: Uint) -> tuple[NDArray[Any], NDArray[Any]]:
    """The unit normals (m, 3) of triangles, and their angles (m, 3) at their corners, in radians."""
    corners = positions[triangles].astype(np.float64)
    to_next, to_last = (unit(np.roll(corners, shift, axis=1) - corners) for shift in (-1, 1))
    angles = np.arccos(np.clip(np.einsum("mck,mck->mc", to_next, to_last), -1, 1))
    return unit(area_vectors(positions, triangles)), angles


def _within(
    positions: Float, triangles: Uint, place: NDArray[Any], corners: NDArray[Any], crease: float
) -> tuple[NDArray[Any], bool]:
    """The normals (c, 3) of corners, 3 m + k for corner k of triangle m, as means within the crease; whether a triangle
    was left out.  A triangle without an area takes all, because it has no normal of its own."""
    own, weighted = np.empty((len(corners), 3)), np.empty((len(corners), 3))
    for block in blocks(corners):
        own[block], angles = _corners(positions, triangles[corners[block] // 3])
        weighted[block] = own[block] * np.take_along_axis(angles, corners[block, None] % 3, axis=1)
    limit = np.where(own.any(axis=1), np.cos(np.radians(crease)) - 1e-9, -2.0)
    found, sharp = np.empty((len(corners), 3)), False
    for group in _meeting(place[triangles.ravel()[corners]]):
        for one in np.array_split(group, -(-group.size * group.shape[1] // BLOCK), axis=1):
            near = own[one] @ own[group].swapaxes(1, 2) >= limit[one][..., None]
            found[one] = near.astype(np.float64) @ weighted[group]
            sharp |= not near.all()
    return unit(found).astype(np.float32), sharp


def _meeting(places: NDArray[Any]) -> Iterator[NDArray[Any]]:
    """Indices of what has one place, (g, v): g places, at each of which v meet; not too many pairs at a time."""
    order = np.argsort(places, kind="stable")
    _, first, count = np.unique(places[order], return_index=True, return_counts=True)
    for v in np.unique(count):
        groups = first[count == v]
        for some in np.array_split(groups, -(-len(groups) * int(v) ** 2 // BLOCK)):
            if len(some):
                yield order[some[:, None] + np.arange(v)]


def _no_quads() -> Uint:
    return np.empty((0, 4), np.uint32)
