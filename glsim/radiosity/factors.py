"""The protocol of form factors: what the linear system and the final gather read, for a matrix, links and blocks."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.patches import Patches
from glsim.radiosity.visibility import Visibility

Float = NDArray[np.float64]
Int = NDArray[np.int64]


class Factors(Protocol):
    """The form factors of n patches: a matrix (FormFactors), links (Links), or blocks on other machines (Blocks)."""

    @property
    def patches(self) -> Patches:
        """What the form factors are between."""
        ...

    @property
    def method(self) -> str:
        """A name of methods.METHODS."""
        ...

    @property
    def seconds(self) -> dict[str, float]:
        """How long each stage took."""
        ...

    @property
    def visibility(self) -> Visibility:
        """The visibility between points and patches, for the final gather."""
        ...

    @property
    def matrix(self) -> NDArray[np.float32] | None:
        """S (n, n), S_ij = A_i F_ij; None where no matrix is kept."""
        ...

    @property
    def row_sums(self) -> Float:
        """sum_j F_ij (n,): 1 in a closed scene, less where light escapes."""
        ...

    @property
    def asymmetry(self) -> float:
        """The largest |S_ij - S_ji|."""
        ...

    def row(self, i: int) -> Float:
        """Return F[i, :], (n,)."""
        ...

    def times(self, B: Float) -> Float:
        """Return S B (n, 3) for radiosities B (n, 3)."""
        ...

    def at_points(self, points: Float, normals: Float, patch: Int, B: Float) -> Float:
        """Return the irradiance (k, 3) at points (k, 3) with unit normals (k, 3), on the patches ``patch`` (k,)."""
        ...

    def keep(self, checkpoint: str) -> None:
        """Save the form factors under a name, for the next run."""
        ...
