"""Radiosity where little light gets through, or things are not convex, against light tracing: photons that bounce."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

pytest.importorskip("numba")
pytest.importorskip("embreex")

from glsim.radiosity.formfactors import compute
from glsim.radiosity.patches import subdivide
from glsim.radiosity.scene import Builder, Material, Scene, box, normal_of, quad
from glsim.radiosity.solvers import solved

WALL, LAMP = Material("wall", (0.7,) * 3), Material("lamp", (0.0,) * 3, (10.0,) * 3)
DARK = Material("dark", (0.3,) * 3)
Rings = list[np.ndarray]


def photons(scene: Scene, count: int = 1_000_000, groups: int = 10) -> np.ndarray:
    """What each polygon reflects, as so many independent estimates, (groups, n): photons leave the lamps and bounce
    until they are absorbed, escape or meet a back.  Polygons are moved a little to their
    fronts, lamps most, so that of polygons that lie on each other the right one is met."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    random = np.random.default_rng(7)
    owner = np.array([k for k, ring in enumerate(scene.rings) for _ in range(len(ring) - 2)])
    normals = np.array([normal_of(ring) for ring in scene.rings])
    rho, E = (np.array([getattr(scene.materials[m], name)[0] for m in scene.material]) for name in ("rho", "E"))
    raised = 3e-6 * scene.size * (1.0 + (E > 0.0))[owner, None, None] * normals[owner, None]
    triangles = scene.triangles() + raised
    embree = EmbreeScene()
    TriangleMesh(embree, np.ascontiguousarray(triangles, np.float32))
    power = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1) / 2.0
    power *= E[owner]
    arrived = np.zeros((groups, len(rho)))
    for group in arrived:
        start = random.choice(len(triangles), count // groups, p=power / power.sum())
        u, v = random.random((2, len(start), 1))
        u, v = np.where(u + v > 1.0, (1.0 - u, 1.0 - v), (u, v))
        a, b, c = np.moveaxis(triangles[start], 1, 0)
        at, on = a + u * (b - a) + v * (c - a), owner[start]
        while len(at):
            way = random.normal(size=at.shape)
            way = way / np.linalg.norm(way, axis=1, keepdims=True) + normals[on]  # Lambert's cosine law
            at = at + 1e-6 * scene.size * normals[on]
            hit = embree.run(at.astype(np.float32), way.astype(np.float32))
            on = owner[np.maximum(hit, 0)]
            cosine = np.einsum("nk,nk->n", way, normals[on])
            met = np.flatnonzero((hit >= 0) & (cosine < 0.0))
            group += np.bincount(on[met], minlength=len(rho))
            met = met[random.random(len(met)) < rho[on[met]]]  # the others are absorbed
            corner = triangles[hit[met], 0]
            far = np.einsum("nk,nk->n", corner - at[met], normals[on[met]]) / cosine[met]
            at, on = at[met] + far[:, None] * way[met], on[met]
    return np.asarray(rho * arrived * power.sum() / (count // groups))


# ---------------------------------------------------------------- scenes: each with a first room, in which the lamp is


def both_sides(rings: Rings) -> Rings:
    return [side for ring in rings for side in (ring, ring[::-1])]


def at_2(*rectangles: tuple[float, float, float, float]) -> Rings:
    """Rectangles (y, z, y, z) in the plane x = 2."""
    return [quad((2, a, b), (2, c, b), (2, c, d), (2, a, d)) for a, b, c, d in rectangles]


def lamp(y: float, corners: int = 4) -> Rings:
    """In the first room, as one quad, or as two triangles."""
    ring = quad((0.7, y, 0.7), (1.3, y, 0.7), (1.3, y, 1.3), (0.7, y, 1.3))
    return [ring] if corners == 4 else [ring[[0, 1, 2]], ring[[0, 2, 3]]]


def rooms(partition: Rings, lamps: Rings, things: Rings = []) -> Scene:  # noqa: B006
    """Two rooms, each 2 x 2 x 2, with a partition between them."""
    b = Builder("rooms")
    b.add(box((0, 0, 0), (4, 2, 2), inside=True), WALL)
    b.add(partition, WALL)
    b.add(things, DARK)
    b.add(lamps, LAMP)
    return b.scene().checked()


def doorway() -> Scene:
    return rooms(both_sides(at_2((0, 0, 2, 0.7), (0, 1.3, 2, 2), (1.4, 0.7, 2, 1.3))), lamp(2.0))


def window() -> Scene:
    return rooms(
        both_sides(at_2((0, 0, 2, 0.7), (0, 1.3, 2, 2), (0, 0.7, 0.7, 1.3), (1.3, 0.7, 2, 1.3))), lamp(1.6, corners=3)
    )


def grid() -> Scene:
    """A wall with sixteen small openings, of bars that are as thin as can be."""
    edges = [0.0, *np.linspace(0.2, 1.8, 8), 2.0]
    bars = [(0.0, edges[k], 2.0, edges[k + 1]) for k in range(0, 9, 2)]
    between = [
        (edges[m], edges[k], edges[m + 1], edges[k + 1]) for k in range(1, 9, 2) for m in range(0, 9, 2)
    ]  # fmt: skip
    return rooms(both_sides(at_2(*bars, *between)), lamp(2.0))


def bars() -> Scene:
    """Thin boxes from the floor to the ceiling."""
    things = [face for k in range(7) for face in box((1.98, 0, 0.05 + 0.28 * k), (2.02, 2, 0.25 + 0.28 * k))]
    return rooms([], lamp(2.0), things)


def corner_block() -> Scene:
    """An L of eight faces stands between lamp and far wall: not convex."""
    y = (0.0, 1.2)
    plan = [(1.6, 0.3), (2.4, 0.3), (2.4, 0.7), (2.0, 0.7), (2.0, 1.7), (1.6, 1.7)]
    walls = [
        quad((a[0], y[0], a[1]), (a[0], y[1], a[1]), (b[0], y[1], b[1]), (b[0], y[0], b[1]))
        for a, b in zip(plan, plan[1:] + plan[:1], strict=True)
    ]
    top = [np.array([(x, y[1], z) for x, z in plan[::-1]], float)]
    return rooms([], lamp(1.7, corners=3), [*walls, *top])


def outside() -> Scene:
    """No room at all: a lamp over a table with a box on it, open to all sides; two boxes hang together by a corner."""
    b = Builder("outside")
    b.add([quad((-2, 0, -2), (-2, 0, 2), (2, 0, 2), (2, 0, -2))], WALL)
    b.add(both_sides([quad((-1, 0.6, -1), (-1, 0.6, 1), (1, 0.6, 1), (1, 0.6, -1))]), DARK)
    b.add(box((-0.3, 0.6, -0.3), (0.2, 1.1, 0.3))[:2] + box((-0.3, 0.6, -0.3), (0.2, 1.1, 0.3))[3:], WALL)
    b.add(box((0.2, 1.1, 0.3), (0.6, 1.4, 0.6)), WALL)
    b.add([ring + (0.0, 0.4, -1.5) for ring in lamp(1.7, corners=3)], LAMP)
    return b.scene().checked()


SCENES: dict[str, Callable[[], Scene]] = {
    scene.__name__: scene for scene in (doorway, window, grid, bars, corner_block, outside)
}


@pytest.mark.parametrize("name", SCENES)
def test_light_that_gets_through(name: str) -> None:
    """What the far room (outside: the floor) reflects, and what all else."""
    scene = SCENES[name]()
    factors = compute(subdivide(scene, 900))
    patches, B = factors.patches, solved(factors)[-1].B[:, 0]
    ours = np.bincount(patches.polygon, patches.area * B, len(scene.rings))
    traced = photons(scene)
    center = np.array([ring.mean(axis=0) for ring in scene.rings])
    far = center[:, 1] < 0.1 if name == "outside" else center[:, 0] > 2.001
    dark = np.array([scene.materials[m] is not LAMP for m in scene.material])
    for chosen in (far & dark, ~far & dark):
        powers = traced[:, chosen].sum(axis=1)
        error = powers.std(ddof=1) / np.sqrt(len(powers)) / powers.mean()
        print(name, ours[chosen].sum() / powers.mean() - 1.0, error)
        assert error < 0.008
        assert ours[chosen].sum() == pytest.approx(powers.mean(), rel=0.006 + 2.0 * error)
