"""Patches as triangles that share vertices, without T-vertices."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.patches import Patches

Float = NDArray[np.float64]
Int = NDArray[np.int64]
INWARD = 0.02  # part of the way from a vertex at a border to the centre of its largest patch: light is gathered there
SAME = 1e-7  # of the scene's size: this near, points are one vertex


@dataclass(frozen=True, repr=False)
class PatchMesh:
    """Triangles without T-vertices.

    vertices, normals: (V, 3); at: (V, 3) where light is gathered; patch: (V,) the largest patch each vertex belongs
    to; triangles: (T, 3) numbers of vertices; triangle_patch: (T,); corners: (n, 4) vertices at the patches' corners.
    """

    vertices: Float
    normals: Float
    at: Float
    patch: Int
    triangles: Int
    triangle_patch: Int
    corners: Int

    @property
    def areas(self) -> Float:
        """The areas of the triangles, (T,)."""
        a, b, c = np.moveaxis(self.vertices[self.triangles], 1, 0)
        return np.asarray(np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2.0)

    def __repr__(self) -> str:
        return f"<PatchMesh: {len(self.vertices)} vertices, {len(self.triangles)} triangles>"


@dataclass(frozen=True)
class Outline:
    """The edges of patches.

    corners: (n, 4), numbers of vertices, a triangle repeats its last; positions: (V, 3) of the vertices; between: for
    an edge (patch, corner), from that corner to the next, the vertices of neighbours that lie on it, in order.
    """

    corners: Int
    positions: Float
    between: dict[tuple[int, int], list[int]]


def outline(patches: Patches) -> Outline:
    """Give numbers to the patches' corners: patches of one flat polygon, or of one smooth body, share vertices."""
    n = len(patches)
    unit = SAME * patches.scene.size
    keys = np.column_stack(
        [np.round(patches.corners.reshape(-1, 3) / unit).astype(np.int64), np.repeat(patches.group, 4)]
    )
    _, first, number = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    corners = number.reshape(n, 4)
    positions = patches.corners.reshape(-1, 3)[first]
    return Outline(corners, positions, _between(corners, patches.counts, positions, keys[first, 3], unit))


def _between(corners: Int, counts: Int, positions: Float, group: Int, unit: float) -> dict[tuple[int, int], list[int]]:
    """Find the vertices on edges, see Outline.between.

    An edge that two patches share has no vertices on it, so only edges of a single patch and their ends are searched.
    corners: (n, 4); counts: (n,); positions: (V, 3); group: (V,), only vertices of the edge's own count; unit: how near
    to the edge they are.
    """
    from scipy.spatial import cKDTree

    patch, corner = np.nonzero(np.arange(4) < counts[:, None])
    start, end = corners[patch, corner], corners[patch, (corner + 1) % counts[patch]]
    key = np.minimum(start, end) * len(positions) + np.maximum(start, end)
    _, inverse, times = np.unique(key, return_inverse=True, return_counts=True)
    alone = np.flatnonzero((times[inverse] == 1) & (start != end))
    start, end = start[alone], end[alone]
    ends = np.unique(np.concatenate([start, end]))
    middle, reach = (positions[start] + positions[end]) / 2.0, np.linalg.norm(positions[end] - positions[start], axis=1)
    near = cKDTree(positions[ends]).query_ball_point(middle, 0.501 * reach)
    between: dict[tuple[int, int], list[int]] = {}
    for k in range(len(near)):
        vertices = ends[near[k]]
        vertices = vertices[group[vertices] == group[start[k]]]
        direction = (positions[end[k]] - positions[start[k]]) / reach[k]
        along = (positions[vertices] - positions[start[k]]) @ direction
        off = np.linalg.norm(positions[vertices] - positions[start[k]] - along[:, None] * direction, axis=1)
        inside = (off < unit) & (along > unit) & (along < reach[k] - unit)
        if inside.any():
            order = np.argsort(along[inside])
            between[int(patch[alone[k]]), int(corner[alone[k]])] = vertices[inside][order].tolist()
    return between


def mesh_of(patches: Patches) -> PatchMesh:
    """Return the patches as triangles without T-vertices.

    A patch on whose edges lie vertices of its neighbours becomes a fan around its middle.  Of a cluster the pieces are
    drawn; its corners are vertices of one of them.
    """
    if patches.clusters is not None:
        pieces, whole = patches.drawn()
        mesh, corners = mesh_of(pieces), np.empty((len(patches), 4), np.int64)
        corners[whole] = mesh.corners
        return replace(mesh, patch=whole[mesh.patch], triangle_patch=whole[mesh.triangle_patch], corners=corners)
    lines = outline(patches)
    corners, counts = lines.corners, patches.counts
    fans = np.array(sorted({k for k, _ in lines.between}), np.int64)
    plain = np.setdiff1d(np.arange(len(patches)), fans)
    quads = plain[counts[plain] == 4]
    triangles = [corners[plain][:, [0, 1, 2]], corners[quads][:, [0, 2, 3]]]
    owners = [plain, quads]
    for middle, k in enumerate(fans.tolist(), len(lines.positions)):
        loop: list[int] = []
        for corner in range(counts[k]):
            loop += [int(corners[k, corner]), *lines.between.get((k, corner), [])]
        triangles.append(np.array([(middle, a, b) for a, b in zip(loop, [*loop[1:], loop[0]], strict=True)]))
        owners.append(np.full(len(loop), k))
    positions = np.concatenate([lines.positions, patches.center[fans]])
    faces, of = np.concatenate(triangles), np.concatenate(owners)
    return _with_normals(patches, positions, faces, of, corners)


def _with_normals(patches: Patches, positions: Float, triangles: Int, of: Int, corners: Int) -> PatchMesh:
    """Return the mesh of triangles (T, 3) of the patches ``of`` (T,), with normals and points for the gather.

    A vertex's normal is the mean of the patches around it, weighted by area.  Where the angles around a vertex do not
    fill 2 pi it lies at a border, and gathers light a little inside its largest patch.
    """
    around = np.zeros(len(positions))
    for k in range(3):
        corner, one, two = (positions[triangles[:, (k + d) % 3]] for d in range(3))
        one, two = one - corner, two - corner
        angle = np.arctan2(np.linalg.norm(np.cross(one, two), axis=1), np.einsum("nk,nk->n", one, two))
        np.add.at(around, triangles[:, k], angle)
    vertex, patch = triangles.ravel(), np.repeat(of, 3)
    order = np.lexsort((patch, patches.area[patch], vertex))  # the last of each vertex is the largest
    largest = np.empty(len(positions), np.int64)
    largest[vertex[order]] = patch[order]
    pairs = np.unique(vertex * len(patches) + patch)
    vertex, patch = pairs // len(patches), pairs % len(patches)
    normals = np.zeros((len(positions), 3))
    np.add.at(normals, vertex, patches.normal[patch] * patches.area[patch, None])
    length = np.linalg.norm(normals, axis=1)
    flat = length > 1e-12 * patches.area[largest]
    normals = np.where(flat[:, None], normals / np.where(flat, length, 1.0)[:, None], patches.normal[largest])
    at = np.where((around < 6.28)[:, None], positions + INWARD * (patches.center[largest] - positions), positions)
    return PatchMesh(positions, normals, at, largest, triangles, of, corners)
