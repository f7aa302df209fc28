"""What the commands of the README draw, in small, held against approved pictures.

Lettering depends on Pillow's version, and what is computed in NumPy on the processor: such pictures have tolerances.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import glsim
from glsim.play.reshade import shaded
from glsim.study.compare import compare

SHEET = {"mean": 1.0}  # only lettering may change
ROUNDED = {"blocks": 0, "mean": 0.2}


@pytest.mark.gl(size=(96, 96))
@pytest.mark.parametrize("mode", ["flat", "gouraud", "phong"])
@pytest.mark.parametrize("scene", ["teapot", "sphere"])
def test_scenes(scene: str, mode: str, gl_snapshot: Any) -> None:
    gl_snapshot(shaded(glsim.frame_of(scene, size=96), mode, "blinn"))


def test_sheet_of_modes_and_lobes(gl_snapshot: Any) -> None:
    result = compare("sphere:10", size=64)
    gl_snapshot(np.vstack([np.hstack([result.images[lobe, mode] for mode in ("flat", "gouraud", "phong")])
                           for lobe in ("blinn", "phong")]), "pictures", **ROUNDED)  # fmt: skip
    gl_snapshot(result.sheet, "sheet", **SHEET)


def test_sheet_of_terms(gl_snapshot: Any) -> None:
    gl_snapshot(glsim.terms("sphere", size=64).sheet, **SHEET)
