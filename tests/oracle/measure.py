"""How far two pictures are apart."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Difference(NamedTuple):
    """coverage: pixels drawn in one picture only; worst and mean over covered pixels in 1/255; share within 1/255."""

    coverage: int
    worst: int
    mean: float
    within_1: float


def measure(a: NDArray[np.uint8], b: NDArray[np.uint8]) -> Difference:
    """Pictures of the same size, RGBA; a pixel is covered where alpha or a colour is not 0."""
    covered_a, covered_b = a.any(axis=2), b.any(axis=2)
    both = covered_a & covered_b
    distance = np.abs(a.astype(int) - b.astype(int)).max(axis=2)[both]
    if not distance.size:
        return Difference(int((covered_a != covered_b).sum()), 0, 0.0, 1.0)
    return Difference(
        int((covered_a != covered_b).sum()),
        int(distance.max()),
        float(distance.mean()),
        float((distance <= 1).mean()),
    )
