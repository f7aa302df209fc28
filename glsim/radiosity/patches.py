"""Patches: the small polygons between which light is exchanged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import Scene, normal_of

Float = NDArray[np.float64]
Int = NDArray[np.int64]


@dataclass(frozen=True, repr=False)
class Patches:
    """n patches, convex and planar with three or four corners.

    rings: (n, 4, 3), a triangle repeats its last corner; counts: (n,) 3 or 4; polygon: (n,) number in scene.rings;
    level: (n,) how often it was divided into four.
    area, center (n, 3), normal (n, 3), size (n,): diameter; rho, E: (n, 3).
    """

    scene: Scene
    rings: Float
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
        return len(self.rings)

    def triangles(self) -> tuple[Float, Int]:
        """Triangles (m, 3, 3), and the patch of each (m,)."""
        quads = np.flatnonzero(self.counts == 4)
        first, second = self.rings[:, [0, 1, 2]], self.rings[quads][:, [0, 2, 3]]
        return np.concatenate([first, second]), np.concatenate([np.arange(len(self)), quads])


def patches_from(scene: Scene, rings: Float, counts: Int, polygon: Int, level: Int | None = None) -> Patches:
    """Patches from their rings (n, 4, 3), numbers of corners and the polygons these are parts of."""
    two = np.stack([rings[:, [0, 1, 2]], rings[:, [0, 2, 3]]])
    areas = np.linalg.norm(np.cross(two[:, :, 1] - two[:, :, 0], two[:, :, 2] - two[:, :, 0]), axis=2) / 2.0
    area = areas.sum(axis=0)
    center = (two.mean(axis=2) * areas[:, :, None]).sum(axis=0) / area[:, None]
    size = 2.0 * np.linalg.norm(rings - center[:, None], axis=2).max(axis=1)
    normals = np.array([normal_of(ring) for ring in scene.rings])
    rho, E = (np.array([getattr(m, name) for m in scene.materials], np.float64) for name in ("rho", "E"))
    paint = np.asarray(scene.material)[polygon]
    if level is None:
        level = np.zeros(len(rings), np.int64)
    return Patches(scene, rings, counts, polygon, level, area, center, normals[polygon], size, rho[paint], E[paint])


def patches_of(scene: Scene, rings: Sequence[Float], polygon: Sequence[int]) -> Patches:
    """Patches from a list of rings with three or four corners each."""
    return patches_from(
        scene, four_corners(rings), np.array([len(ring) for ring in rings], np.int64), np.array(polygon, np.int64)
    )


def four_corners(rings: Sequence[Float]) -> Float:
    return np.array([ring if len(ring) == 4 else [*ring, ring[-1]] for ring in rings], np.float64).reshape(-1, 4, 3)
