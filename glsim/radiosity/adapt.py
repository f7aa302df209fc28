"""More patches where the light changes fast: at the borders of shadows, and near contacts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.factors import Factors
from glsim.radiosity.gather import Gatherer
from glsim.radiosity.lamps import Lamps
from glsim.radiosity.mesh import mesh_of
from glsim.radiosity.patches import Patches
from glsim.radiosity.quadtree import divided
from glsim.radiosity.solvers import solved

Float = NDArray[np.float64]
ROUNDS = 8  # at most


def refined(patches: Patches, count: int, factors_of: Callable[[Patches], Factors]) -> Patches:
    """Divide patches until there are about ``count``, first those with the largest interpolation error.

    factors_of: finds the form factors of patches.  Only the patches that are given are solved: light is gathered from
    them at all smaller ones.
    """
    factors = factors_of(patches)
    B = solved(factors, tolerance=1e-4)[-1].B
    _, gatherer = Gatherer(factors, B, Lamps.of(patches, factors.visibility)).on(mesh_of(patches))
    for _ in range(ROUNDS):
        wanted = min(count, 2 * len(patches)) - len(patches)
        if wanted < 3:
            break
        wrong = interpolation_error(patches, gatherer) * patches.area
        worst = np.argsort(-wrong)[: max(1, wanted // 4)]  # the balance of the quadtree divides some more
        chosen = np.zeros(len(patches), bool)
        chosen[worst[wrong[worst] > 0.0]] = True
        if not chosen.any():
            break
        patches = divided(patches, chosen)
    return patches


def interpolation_error(patches: Patches, gatherer: Gatherer) -> Float:
    """Return how far the radiosity gathered at each patch's middle is from the mean at its corners: (n,).

    gatherer: of the same scene, with a matrix of form factors, which gathers at any point.
    """
    mesh = mesh_of(patches)
    at, normals = np.concatenate([mesh.at, patches.center]), np.concatenate([mesh.normals, patches.normal])
    H = gatherer.direct(at, normals) + gatherer.bounced(at, normals, np.zeros(len(at), np.int64))
    at_corners, middle = H[mesh.corners], H[len(mesh.at) :]
    between = np.where((patches.counts == 4)[:, None], at_corners.mean(axis=1), at_corners[:, :3].mean(axis=1))
    error = (patches.rho * np.abs(middle - between)).max(axis=1)
    return np.where(patches.is_cluster, 0.0, error)
