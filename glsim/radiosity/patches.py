"""Patches: the small polygons between which light is exchanged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import Scene
from glsim.radiosity.textures import mean_texels

Float = NDArray[np.float64]
Int = NDArray[np.int64]


@dataclass(frozen=True, repr=False)
class Patches:
    """n patches, convex and planar with three or four corners.

    corners: (n, 4, 3), a triangle repeats its last corner; counts: (n,) 3 or 4; polygon: (n,) number in scene.polygons;
    level: (n,) how often it was divided into four.
    area: (n,); center, normal: (n, 3); size: (n,), the diameter of a sphere around the center; rho, E: (n, 3).
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

    def __repr__(self) -> str:
        return f"<Patches of {self.scene.name}: {len(self)}>"

    def __len__(self) -> int:
        return len(self.corners)

    def triangles(self) -> tuple[Float, Int]:
        """Return the patches as triangles (m, 3, 3), and the patch of each (m,)."""
        quads = np.flatnonzero(self.counts == 4)
        first, second = self.corners[:, [0, 1, 2]], self.corners[quads][:, [0, 2, 3]]
        return np.concatenate([first, second]), np.concatenate([np.arange(len(self)), quads])


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
