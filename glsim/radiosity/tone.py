"""Tone mapping: from radiosity to the colours of a screen."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.patches import Patches

Float = NDArray[np.float64]
TONES = {
    "linear": "B / white, cut off at 1",
    "reinhard": "L / (1 + L) with L = B / white, for scenes with bright lamps (Reinhard et al. 2002)",
}
GAMMA = 2.2


def automatic_white(patches: Patches, B: Float) -> float:
    """Choose the radiosity that becomes white, from the radiosity B (n, 3) of the patches.

    It is 1.1 times the radiosity that 95 % of the area does not exceed; patches that emit do not count.
    """
    dark = patches.E.max(axis=1) == 0.0
    chosen = dark if dark.any() else np.ones(len(B), bool)
    values, areas = B[chosen].max(axis=1), patches.area[chosen]
    order = np.argsort(values)
    share = np.cumsum(areas[order]) / areas.sum()
    white = float(values[order][min(int(np.searchsorted(share, 0.95)), len(order) - 1)]) * 1.1
    return white if white > 0.0 else 1.0


def toned(B: Float, white: float, tone: str = "linear", gamma: float = GAMMA) -> Float:
    """Turn radiosity of any shape into colours in [0, 1]: tone mapping, then the power 1 / gamma.

    white: the radiosity that becomes 1; tone: a name of TONES.  Raises ValueError for another name.
    """
    if tone not in TONES:
        raise ValueError(f"tones are {', '.join(TONES)}, not {tone!r}")
    L = np.maximum(B, 0.0) / white
    if tone == "reinhard":
        L = L / (1.0 + L)
    return np.asarray(np.clip(L, 0.0, 1.0) ** (1.0 / gamma))
