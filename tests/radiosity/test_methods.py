"""The other ways to find form factors."""

from __future__ import annotations

import numpy as np
import pytest

from glsim.radiosity.hemicube import delta_form_factors, hemicube
from glsim.radiosity.methods import METHODS, compute
from glsim.radiosity.pairs import point_factors
from glsim.radiosity.progress import silent
from glsim.radiosity.scene import Material, SceneError
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.subdivide import subdivide
from tests.radiosity.helpers import room


@pytest.mark.parametrize("method", [name for name in METHODS if name != "hierarchical"])
def test_methods(method: str) -> None:
    scene = room((1, 1, 1), [Material("wall", (0.5,) * 3, (1.0,) * 3)] * 6).checked()
    factors = compute(subdivide(scene, 150), method)
    assert np.array_equal(factors.S, factors.S.T)
    error = np.abs(factors.row_sums - 1.0).mean()
    assert (
        error
        < {"contour": 1e-3, "analytic": 1e-3, "point": 0.2, "disc": 0.1, "monte-carlo": 0.2, "hemicube": 0.02}[method]
    )
    assert (factors.error is not None) == (method == "monte-carlo")


def test_hemicube() -> None:
    """In an empty room, against the exact form factors from the middles of the patches; its pixels sum to 1."""
    for resolution in (16, 64):
        assert delta_form_factors(resolution).sum() == pytest.approx(1.0, abs=0.6 / resolution**2)
    parts = subdivide(BUILT_IN["furnace"].make().checked(), 54)
    at_middle = np.zeros((len(parts), len(parts)))
    arrays = (parts.corners, parts.counts, parts.normal, parts.center, parts.size, np.zeros(len(parts)))
    point_factors(parts.center, parts.normal, *arrays, at_middle)
    expected = at_middle * parts.area[:, None]
    expected = (expected + expected.T) / 2.0
    error = {r: np.abs(hemicube(parts, silent, r) - expected).mean() / expected.mean() for r in (32, 128, 512)}
    assert error[128] < 0.35 * error[32]
    assert error[512] < 0.35 * error[128] < 0.005


def test_a_scene_that_would_not_fit() -> None:
    parts = subdivide(BUILT_IN["furnace"].make().checked(), 600)
    with pytest.raises(SceneError, match="take fewer patches"):
        compute(parts, limit=10**6)
    with pytest.raises(SceneError, match="the methods for form factors are"):
        compute(parts, "guess")
