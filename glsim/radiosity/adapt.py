"""More patches where the light changes fast: at the borders of shadows, and near contacts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.factors import Factors
from glsim.radiosity.gather import gathered
from glsim.radiosity.mesh import mesh_of
from glsim.radiosity.patches import Patches
from glsim.radiosity.quadtree import divided
from glsim.radiosity.solvers import solved

Float = NDArray[np.float64]
ROUNDS = 8  # at most


def refined(patches: Patches, count: int, factors_of: Callable[[Patches], Factors]) -> Patches:
    """Divide patches until there are about ``count``, first those with the largest interpolation error.

    factors_of: finds the form factors of patches.  Between two solutions the number of patches at most doubles.
    """
    for _ in range(ROUNDS):
        wanted = min(count, 2 * len(patches)) - len(patches)
        if wanted < 3:
            break
        wrong = interpolation_error(factors_of(patches)) * patches.area
        worst = np.argsort(-wrong)[: max(1, wanted // 4)]  # the balance of the quadtree divides some more
        chosen = np.zeros(len(patches), bool)
        chosen[worst[wrong[worst] > 0.0]] = True
        if not chosen.any():
            break
        patches = divided(patches, chosen)
    return patches


def interpolation_error(factors: Factors) -> Float:
    """Return how far the radiosity gathered at each patch's middle is from the mean at its corners: (n,)."""
    patches = factors.patches
    B = solved(factors, tolerance=1e-4)[-1].B
    mesh = mesh_of(patches)
    at_corners = gathered(factors, mesh, B)[mesh.corners]
    between = np.where((patches.counts == 4)[:, None], at_corners.mean(axis=1), at_corners[:, :3].mean(axis=1))
    points = patches.center + 1e-6 * patches.scene.size * patches.normal
    H = factors.at_points(points, patches.normal, np.arange(len(patches)), B)
    return np.asarray(np.abs(patches.E + patches.rho * H - between).max(axis=1))
