"""Radiosity at vertices, and its colours."""

from __future__ import annotations

import numpy as np
import pytest

from glsim import radiosity
from glsim.radiosity.gather import Gatherer, averaged, gathered, radiosity_at
from glsim.radiosity.lamps import Lamps
from glsim.radiosity.mesh import mesh_of
from glsim.radiosity.methods import compute
from glsim.radiosity.patches import patches_of
from glsim.radiosity.scene import Builder, Material, quad
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.solvers import solved
from glsim.radiosity.subdivide import subdivide
from glsim.radiosity.tone import toned


@pytest.mark.slow
def test_vertices_where_light_changes_fast() -> None:
    """At the vertices, most of which are in corners and at shadows, against a gather from seven times the patches."""
    scene = BUILT_IN["cornell"].make().checked()
    coarse, fine = (compute(subdivide(scene, count)) for count in (500, 3500))
    B, B_fine = (solved(factors)[-1].B for factors in (coarse, fine))
    mesh, mesh_fine = (mesh_of(factors.patches) for factors in (coarse, fine))
    _, gatherer = Gatherer(fine, B_fine, Lamps.of(fine.patches, fine.visibility)).on(mesh_fine)
    here = mesh.at, mesh.normals
    H = gatherer.direct(*here) + gatherer.bounced(*here, np.zeros(len(mesh.at), int))
    true = coarse.patches.E[mesh.patch] + coarse.patches.rho[mesh.patch] * H
    even = radiosity_at(coarse, mesh.at, mesh.normals, mesh.patch, B)
    dark = coarse.patches.E[mesh.patch].max(axis=1) == 0.0

    def rms(shown: np.ndarray) -> float:
        return float(np.sqrt(((shown - true)[dark] ** 2).sum() / (true[dark] ** 2).sum()))

    assert rms(gathered(coarse, mesh, B)) < 0.014
    assert rms(even) < 0.03  # if patches were evenly bright
    assert 0.1 < rms(averaged(coarse.patches, mesh, B)) < 0.2  # as textbooks do it


def test_vertices_in_a_furnace() -> None:
    """Where all walls have the same B, so have all vertices, gathered or averaged."""
    found = radiosity.solve("furnace", 200, close=True)
    assert found.vertex_radiosity == pytest.approx(np.full(found.vertex_radiosity.shape, 2.0), rel=0.01)
    mean = averaged(found.patches, found.mesh, found.B)
    assert mean == pytest.approx(np.full(mean.shape, 2.0), rel=1e-3)


def test_averages_are_weighted_by_area() -> None:
    """However many triangles a patch is drawn as: here one of nine times the area lies beside three of one."""
    b = Builder("strips")
    wide, narrow = quad((0, 0, 0), (3, 0, 0), (3, 3, 0), (0, 3, 0)), quad((3, 0, 0), (4, 0, 0), (4, 1, 0), (3, 1, 0))
    b.add([wide, *(np.add(narrow, (0, k, 0)) for k in range(3))], Material("lamp", (0.5,) * 3, (1.0,) * 3), smooth=True)
    scene = b.scene().checked()
    parts = patches_of(scene, list(scene.polygons), range(4))
    mesh = mesh_of(parts)
    assert np.bincount(mesh.triangle_patch)[0] > 4  # a fan
    B = np.array([[1.0], [2.0], [4.0], [8.0]]).repeat(3, axis=1)
    mean = averaged(parts, mesh, B)
    for y, expected in ((0.0, 11 / 10), (1.0, (9 + 2 + 4) / 11), (2.0, (9 + 4 + 8) / 11)):
        at = np.flatnonzero((mesh.vertices == (3, y, 0)).all(axis=1))
        assert mean[at] == pytest.approx(expected)


def test_tones() -> None:
    B = np.array([[0.0, 0.5, 1.0], [2.0, 4.0, 1e9]])
    assert toned(B, 1.0, gamma=1.0).tolist() == [[0.0, 0.5, 1.0], [1.0, 1.0, 1.0]]
    assert toned(B, 1.0, "reinhard", 1.0)[0].tolist() == pytest.approx([0.0, 1 / 3, 0.5])
    assert toned(B, 2.0)[0, 2] == pytest.approx(0.5 ** (1 / 2.2))
    with pytest.raises(ValueError, match="tones are"):
        toned(B, 1.0, "sepia")
