"""Patches: the small polygons between which light is exchanged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import Scene
from glsim.radiosity.textures import mean_texels

Float = NDArray[np.float64]
Int = NDArray[np.int64]


@dataclass(frozen=True, repr=False)
class Clusters:
    """Which patches are clusters of smaller ones, see clusters.py.

    of: (n,), the number of each patch's cluster, -1 if it is none; start: (c + 1,), cluster k has the pieces start[k]
    up to start[k + 1].
    """

    of: Int
    start: Int
    pieces: Patches

    def chosen(self, numbers: Int) -> Clusters | None:
        """Return the clusters of the patches with these numbers; None if none of them is a cluster."""
        kept = self.of[numbers]
        wanted = kept[kept >= 0]
        if not len(wanted):
            return None
        of, many = np.full(len(kept), -1), np.diff(self.start)[wanted]
        of[kept >= 0] = np.arange(len(wanted))
        start = np.concatenate([[0], np.cumsum(many)])
        pieces = np.repeat(self.start[wanted] - start[:-1], many) + np.arange(start[-1])
        return Clusters(of, start, self.pieces.chosen(pieces))

    @cached_property
    def share(self) -> Float:
        """(m,): how much of its cluster's area lies in each piece and those before it, from 0 to 1."""
        total = np.concatenate([[0.0], np.cumsum(self.pieces.area)])
        begin, many = total[self.start[:-1]], np.diff(self.start)
        whole = np.repeat(total[self.start[1:]] - begin, many)
        return np.asarray((total[1:] - np.repeat(begin, many)) / whole)

    @cached_property
    def patch(self) -> Int:
        """(m,): the patch that each piece is part of."""
        clusters = np.flatnonzero(self.of >= 0)
        number = np.empty(len(self.start) - 1, np.int64)
        number[self.of[clusters]] = clusters
        return np.repeat(number, np.diff(self.start))


@dataclass(frozen=True, repr=False)
class Patches:
    """n patches, convex and planar with three or four corners.

    corners: (n, 4, 3), a triangle repeats its last corner; counts: (n,) 3 or 4; polygon: (n,) number in scene.polygons;
    level: (n,) how often it was divided into four.
    area: (n,); center, normal: (n, 3); size: (n,), the diameter of a sphere around the center; rho, E: (n, 3).
    clusters: None if each patch is a part of one polygon.
    """

    scene: Scene
    corners: Float
    counts: Int
    polygon: Int
    level: Int
    area: Float
    center: Float
    normal: Float
    size: Float
    rho: Float
    E: Float
    clusters: Clusters | None = None

    def __repr__(self) -> str:
        return f"<Patches of {self.scene.name}: {len(self)}>"

    def __len__(self) -> int:
        return len(self.corners)

    def noted(self, note: str) -> Patches:
        """Return the same patches of a scene with one more note."""
        return replace(self, scene=replace(self.scene, notes=(*self.scene.notes, note)))

    @property
    def group(self) -> Int:
        """The number of the wall or smooth body that each patch is part of, (n,)."""
        scene = self.scene
        return np.asarray(scene.group or range(len(scene.polygons)), np.int64)[self.polygon]

    @property
    def is_cluster(self) -> NDArray[np.bool_]:
        """Whether each patch stands for several smaller ones, (n,)."""
        return np.zeros(len(self), bool) if self.clusters is None else np.asarray(self.clusters.of >= 0)

    def with_clusters(self, others: Patches, of: Int) -> Patches:
        """Return other patches, of which those with a number of these patches' clusters, of (n,), are these patches."""
        assert self.clusters is not None
        mine, theirs = np.flatnonzero(self.is_cluster), np.flatnonzero(of >= 0)
        number = np.empty(len(mine), np.int64)
        number[self.clusters.of[mine]] = mine
        changed = {}
        for name in ("area", "center", "normal", "size", "rho", "E"):
            changed[name] = getattr(others, name).copy()
            changed[name][theirs] = getattr(self, name)[number[of[theirs]]]
        return replace(others, **changed, clusters=replace(self.clusters, of=of))

    def chosen(self, numbers: Int) -> Patches:
        """Return the patches with these numbers; each cluster at most once."""
        p, c = self, self.clusters
        some = {name: getattr(p, name)[numbers] for name in ARRAYS}
        return Patches(p.scene, **some, clusters=None if c is None else c.chosen(numbers))

    def drawn(self) -> tuple[Patches, Int]:
        """Return what is drawn, patches that are no clusters and the pieces of clusters, and the patch of each."""
        if self.clusters is None:
            return self, np.arange(len(self))
        alone, pieces = np.flatnonzero(~self.is_cluster), self.clusters.pieces
        first = replace(self, clusters=None).chosen(alone)
        names = ("corners", "counts", "polygon", "level")
        both = (np.concatenate([getattr(first, name), getattr(pieces, name)]) for name in names)
        return patches_from(self.scene, *both), np.concatenate([alone, self.clusters.patch])

    def triangles(self) -> tuple[Float, Int]:
        """Return the patches as triangles (m, 3, 3), and the patch of each (m,)."""
        quads = np.flatnonzero(self.counts == 4)
        first, second = self.corners[:, [0, 1, 2]], self.corners[quads][:, [0, 2, 3]]
        return np.concatenate([first, second]), np.concatenate([np.arange(len(self)), quads])


ARRAYS = ("corners", "counts", "polygon", "level", "area", "center", "normal", "size", "rho", "E")  # of Patches


def patches_from(scene: Scene, corners: Float, counts: Int, polygon: Int, level: Int | None = None) -> Patches:
    """Return patches with these corners (n, 4, 3), counts of corners (n,), and polygons of which they are parts (n,).

    level: (n,), how often each was divided into four; by default 0.
    """
    two = np.stack([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])
    areas = np.linalg.norm(np.cross(two[:, :, 1] - two[:, :, 0], two[:, :, 2] - two[:, :, 0]), axis=2) / 2.0
    area = areas.sum(axis=0)
    center = (two.mean(axis=2) * areas[:, :, None]).sum(axis=0) / area[:, None]
    size = 2.0 * np.linalg.norm(corners - center[:, None], axis=2).max(axis=1)
    rho, E = (np.array([getattr(m, name) for m in scene.materials], np.float64) for name in ("rho", "E"))
    paint = np.asarray(scene.material)[polygon]
    if level is None:
        level = np.zeros(len(corners), np.int64)
    reflected = rho[paint] * texels_of(scene, corners, polygon)
    return Patches(
        scene, corners, counts, polygon, level, area, center, scene.normals[polygon], size, reflected, E[paint]
    )


def texels_of(scene: Scene, corners: Float, polygon: Int) -> Float:
    """Return the mean texel (n, 3) of patches with corners (n, 4, 3) of these polygons (n,); 1 without a texture."""
    result = np.ones((len(corners), 3))
    for number, material in enumerate(scene.materials):
        if material.texture is not None:
            of = np.flatnonzero(np.asarray(scene.material)[polygon] == number)
            M = np.array([scene.mapping[k] for k in polygon[of].tolist()]).reshape(-1, 2, 4)
            result[of] = mean_texels(material.texture, corners[of], M)
    return result


def patches_of(scene: Scene, polygons: Sequence[Float], owners: Sequence[int]) -> Patches:
    """Return patches from polygons with three or four corners; owners: for each the scene's polygon it is part of."""
    counts = np.array([len(polygon) for polygon in polygons], np.int64)
    return patches_from(scene, four_corners(polygons), counts, np.array(owners, np.int64))


def four_corners(polygons: Sequence[Float]) -> Float:
    """Return polygons of three or four corners as one array (n, 4, 3); a triangle repeats its last corner."""
    filled = [polygon if len(polygon) == 4 else [*polygon, polygon[-1]] for polygon in polygons]
    return np.array(filled, np.float64).reshape(-1, 4, 3)
