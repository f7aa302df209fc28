"""The light that comes straight from lamps, gathered at points: however large patches are, shadows are sharp.

A lamp is a whole polygon, not its patches, so that its rays are spread over all of it.  The form factor is Lambert's
formula, exact; the share that is not blocked is found by rays, many to the lamps that matter at a point.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.contacts import at_most_four
from glsim.radiosity.formfactors import factors_at
from glsim.radiosity.patches import Patches, patches_of
from glsim.radiosity.visibility import Effort, Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]
AT_ONCE = 1 << 21  # form factors
FEW = 64  # polygons that are taken whole
SHARES = 0.01, 0.2  # of a point's light from all lamps: lamps that bring less than these get fewer rays
EFFORTS = Effort(4, 28), Effort(32, 96), Effort(240, 0)  # a shadow's border is where the first ray passes


@dataclass(frozen=True, repr=False)
class Lamps:
    """What emits in a scene.  parts: a patch for each convex polygon of at most four corners."""

    parts: Patches
    visibility: Visibility

    @staticmethod
    def of(patches: Patches, visibility: Visibility) -> Lamps:
        """Return the lamps of a scene: whole polygons if these are few and all of each is seen, else patches."""
        scene, pieces = patches.scene, patches.drawn()[0]
        shown = np.bincount(pieces.polygon, pieces.area, len(scene.polygons))
        lamps = np.array(scene.emitters, np.int64)
        if len(lamps) > FEW or (shown[lamps] < (1.0 - 1e-6) * scene.areas[lamps]).any():
            return Lamps(patches.chosen(np.flatnonzero(patches.E.max(axis=1) > 0.0)), visibility)
        parts = [(part, k) for k in lamps.tolist() for part in at_most_four(scene.polygons[k])]
        return Lamps(patches_of(scene, [part for part, _ in parts], [k for _, k in parts]), visibility)

    def __repr__(self) -> str:
        return f"<Lamps of {self.parts.scene.name}: {len(self.parts)}>"

    def at_points(self, points: Float, normals: Float) -> Float:
        """Return the irradiance (k, 3) at points (k, 3) with unit normals (k, 3)."""
        step = max(1, AT_ONCE // len(self.parts))
        parts = [self._at_points(points[k : k + step], normals[k : k + step]) for k in range(0, len(points), step)]
        return np.concatenate([np.zeros((0, 3)), *parts])

    def _at_points(self, points: Float, normals: Float) -> Float:
        """Return the same, for as many points as there is memory for."""
        p = self.parts
        factors = np.zeros((len(points), len(p)))
        least = np.zeros(len(p))
        factors_at(points, normals, p, least, self.visibility.rays, factors)
        rows, columns = np.nonzero(factors)
        light = factors * p.E.max(axis=1)
        kind = np.searchsorted(SHARES, light[rows, columns] / light.sum(axis=1)[rows])
        factors[rows, columns] *= self.visibility.from_points(points, normals, p, rows, columns, kind, EFFORTS)
        return np.asarray(factors @ p.E)
