"""The Cornell box against path tracing."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from glsim.radiosity.formfactors import FormFactors
from glsim.radiosity.gather import radiosity_at
from glsim.radiosity.methods import compute
from glsim.radiosity.patches import Patches, patches_of
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.solvers import solved


@pytest.fixture(scope="module")
def on_reference(traced: dict[str, np.ndarray]) -> tuple[Patches, np.ndarray, FormFactors]:
    """Radiosity on the very patches of the reference."""
    scene = BUILT_IN["cornell"].make().checked()
    offsets, corners = traced["ring_offsets"], traced["ring_vertices"]
    polygons = [corners[a:b] for a, b in pairwise(offsets)]
    parts = patches_of(scene, polygons, [0] * len(polygons))
    parts = replace(parts, rho=traced["rho"], E=traced["E"], normal=traced["normal"], area=traced["area"])
    factors = compute(parts)
    return parts, solved(factors)[-1].B, factors


def deviation(B: np.ndarray, traced: dict[str, np.ndarray], key: str = "B") -> tuple[float, float]:
    """rms of the reflected part, weighted by area, and the bias of the energy."""
    area, E = traced["area"][:, None], traced["E"]
    d, r = B - traced[key], traced[key] - E
    return float(np.sqrt((area * d * d).sum() / (area * r * r).sum())), float((area * d).sum() / (area * r).sum())


def test_cornell_box(traced: dict[str, np.ndarray], on_reference: tuple[Patches, np.ndarray, FormFactors]) -> None:
    rms, bias = deviation(on_reference[1], traced)
    assert rms < 0.0075
    assert abs(bias) < 0.0005


def test_cornell_box_with_four_times_the_patches(traced: dict[str, np.ndarray]) -> None:
    scene = BUILT_IN["cornell"].make().checked()
    polygons, of = [], []
    for number, (a, b) in enumerate(pairwise(traced["ring_offsets"])):
        polygon = traced["ring_vertices"][a:b]
        middles = (polygon + np.roll(polygon, -1, axis=0)) / 2
        if len(polygon) == 4:
            centre = (polygon[0] + polygon[1] + polygon[2] + polygon[3]) / 4
            parts = [np.array([polygon[k], middles[k], centre, middles[k - 1]]) for k in range(4)]
        else:
            parts = [np.array([polygon[k], middles[k], middles[k - 1]]) for k in range(3)] + [middles]
        polygons += parts
        of += [number] * 4
    p = patches_of(scene, polygons, [0] * len(polygons))
    p = replace(p, rho=traced["rho"][of], E=traced["E"][of], normal=traced["normal"][of])
    B = solved(compute(p))[-1].B
    total = np.stack([np.bincount(of, p.area * B[:, c]) for c in range(3)], axis=1)
    rms, bias = deviation(total / np.bincount(of, p.area)[:, None], traced)
    assert rms < 0.004
    assert abs(bias) < 0.0005


def test_gathering_at_points(
    traced: dict[str, np.ndarray], on_reference: tuple[Patches, np.ndarray, FormFactors]
) -> None:
    """A final gather at the middles of the patches, against path tracing there."""
    parts, B, factors = on_reference
    shown = radiosity_at(factors, traced["centre"], traced["normal"], np.arange(len(parts)), B)
    rms, bias = deviation(shown, traced, "B_centre")
    assert rms < 0.009
    assert abs(bias) < 0.002
