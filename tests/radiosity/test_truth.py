"""What a user gets from the default command, against path tracing: the Cornell box as it is drawn."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from glsim import radiosity
from tests.radiosity.test_cornell import deviation

POINTS = 1024  # on each patch of the reference; with 64 of them the points alone would be off by 0.6 %


def spread(ring: np.ndarray) -> np.ndarray:
    """POINTS points spread evenly over a convex polygon of three or four corners."""
    k = np.arange(1, POINTS + 1)
    u, v = (k * 0.7548776662466927) % 1.0, (k * 0.5698402909980532) % 1.0  # Roberts (2018)
    triangles = [ring[[0, m, m + 1]] for m in range(1, len(ring) - 1)]
    areas = np.array([np.linalg.norm(np.cross(t[1] - t[0], t[2] - t[0])) for t in triangles])
    first = areas[0] / areas.sum()
    which = (u >= first).astype(int)
    u = np.where(which == 0, u / first, (u - first) / max(1.0 - first, 1e-300))
    corner, one, two = np.array([triangles[min(w, len(triangles) - 1)] for w in which]).transpose(1, 0, 2)
    root = np.sqrt(u)[:, None]
    return corner + root * (1.0 - v[:, None]) * (one - corner) + root * v[:, None] * (two - corner)


def drawn_on(traced: dict[str, np.ndarray], result: radiosity.Radiosity) -> np.ndarray:
    """Mean radiosity of each patch of the reference, interpolated between the vertices as GL_SMOOTH does."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    mesh = result.mesh
    tree = EmbreeScene()
    TriangleMesh(tree, np.ascontiguousarray(mesh.vertices[mesh.triangles], np.float32))
    points = np.array([spread(traced["ring_vertices"][a:b]) for a, b in pairwise(traced["ring_offsets"])])
    down = np.broadcast_to(-traced["normal"][:, None], points.shape).reshape(-1, 3).astype(np.float32)
    start = (points + 0.5 * traced["normal"][:, None]).reshape(-1, 3).astype(np.float32)
    hit = tree.run(start, np.ascontiguousarray(down), output=True)
    met = hit["primID"] >= 0
    assert met.mean() > 0.9999  # slivers along the blocks' feet have no patch
    corners = result.vertex_radiosity[mesh.triangles[np.maximum(hit["primID"], 0)]]
    u, v = hit["u"][:, None], hit["v"][:, None]
    shown = (1.0 - u - v) * corners[:, 0] + u * corners[:, 1] + v * corners[:, 2]
    weight = met.reshape(len(points), POINTS, 1)
    return np.asarray((shown.reshape(*weight.shape[:2], 3) * weight).sum(axis=1) / weight.sum(axis=1))


def test_the_default_picture_of_the_cornell_box(traced: dict[str, np.ndarray]) -> None:
    """The reference's own noise is 0.28 % rms."""
    shown = drawn_on(traced, radiosity.solve("cornell"))
    rms, bias = deviation(shown, traced)
    assert rms < 0.005
    assert abs(bias) < 0.0015
    reflected = (traced["B"] - traced["E"]).sum(axis=1)
    lit = reflected > 1e-9
    off = np.abs((shown - traced["B"]).sum(axis=1)[lit] / reflected[lit])
    assert off.max() < 0.1


@pytest.mark.parametrize("corner", [3, 4])
def test_points_spread_over_a_polygon(corner: int) -> None:
    ring = np.array([(0, 0, 0), (4, 0, 0), (4, 2, 0), (0, 1, 0)], float)[:corner]
    points = spread(ring)
    area, inside = 4.0 if corner == 3 else 6.0, points[:, 0] < 2.0
    assert inside.mean() == pytest.approx((1.0 if corner == 3 else 2.5) / area, abs=0.003)
    assert (points[:, 1] >= 0.0).all()
