"""Radiosity where little light gets through, or things are not convex, against light tracing: photons that bounce."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from glsim.radiosity.bodies import bodies_of, surface_of
from glsim.radiosity.methods import compute
from glsim.radiosity.patches import patches_of
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Builder, Material, Scene, box, normal_of, quad
from glsim.radiosity.solvers import solved
from glsim.radiosity.subdivide import subdivide
from glsim.radiosity.visibility import Visibility

WALL, LAMP = Material("wall", (0.7,) * 3), Material("lamp", (0.0,) * 3, (10.0,) * 3)
DARK = Material("dark", (0.3,) * 3)
Polygons = list[np.ndarray]


def photons(scene: Scene, count: int = 1_000_000, groups: int = 10) -> np.ndarray:
    """What each polygon reflects, as so many independent estimates, (groups, n): photons leave the lamps and bounce
    until they are absorbed, escape or meet a back.  Polygons are moved a little to their
    fronts, lamps most, so that of polygons that lie on each other the right one is met."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    random = np.random.default_rng(7)
    owner = np.array([k for k, polygon in enumerate(scene.polygons) for _ in range(len(polygon) - 2)])
    normals = np.array([normal_of(polygon) for polygon in scene.polygons])
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
            # Lambert's cosine law
            direction = random.normal(size=at.shape)
            direction = direction / np.linalg.norm(direction, axis=1, keepdims=True) + normals[on]
            at = at + 1e-6 * scene.size * normals[on]
            hit = embree.run(at.astype(np.float32), direction.astype(np.float32))
            on = owner[np.maximum(hit, 0)]
            cosine = np.einsum("nk,nk->n", direction, normals[on])
            met = np.flatnonzero((hit >= 0) & (cosine < 0.0))
            group += np.bincount(on[met], minlength=len(rho))
            met = met[random.random(len(met)) < rho[on[met]]]  # the others are absorbed
            corner = triangles[hit[met], 0]
            far = np.einsum("nk,nk->n", corner - at[met], normals[on[met]]) / cosine[met]
            at, on = at[met] + far[:, None] * direction[met], on[met]
    return np.asarray(rho * arrived * power.sum() / (count // groups))


# ---------------------------------------------------------------- scenes: each with a first room, in which the lamp is


def both_sides(polygons: Polygons) -> Polygons:
    return [side for polygon in polygons for side in (polygon, polygon[::-1])]


def at_2(*rectangles: tuple[float, float, float, float]) -> Polygons:
    """Rectangles (y, z, y, z) in the plane x = 2."""
    return [quad((2, a, b), (2, c, b), (2, c, d), (2, a, d)) for a, b, c, d in rectangles]


def lamp(y: float, corners: int = 4, half: float = 0.3) -> Polygons:
    """In the first room, as one quad, or as two triangles; half: of its edge."""
    a, b = 1.0 - half, 1.0 + half
    polygon = quad((a, y, a), (b, y, a), (b, y, b), (a, y, b))
    return [polygon] if corners == 4 else [polygon[[0, 1, 2]], polygon[[0, 2, 3]]]


def rooms(partition: Polygons, lamps: Polygons, things: Polygons = []) -> Scene:  # noqa: B006
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
    b.add([np.add(polygon, (0.0, 0.4, -1.5)) for polygon in lamp(1.7, corners=3)], LAMP)
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
    ours = np.bincount(patches.polygon, patches.area * B, len(scene.polygons))
    traced = photons(scene)
    center = np.array([polygon.mean(axis=0) for polygon in scene.polygons])
    far = center[:, 1] < 0.1 if name == "outside" else center[:, 0] > 2.1
    dark = np.array([scene.materials[m] is not LAMP for m in scene.material])
    for chosen in (far & dark, ~far & dark):
        powers = traced[:, chosen].sum(axis=1)
        error = powers.std(ddof=1) / np.sqrt(len(powers)) / powers.mean()
        assert error < 0.008
        assert ours[chosen].sum() == pytest.approx(powers.mean(), rel=0.006 + 2.0 * error)


@pytest.mark.parametrize("height", [0.5, 1.0, 1.5, 1.99])
def test_a_hanging_lamp_of_two_triangles(height: float) -> None:
    """It lets through what passes beside it, as the same lamp of one quad does."""
    sums = []
    for corners in (3, 4):
        b = Builder("lamp")
        b.add(box((0, 0, 0), (2, 2, 2), inside=True), WALL)
        b.add(both_sides(lamp(height, corners, 0.5)), LAMP)
        factors = compute(subdivide(b.scene().checked(), 500))
        sums.append(np.average(np.abs(factors.row_sums - 1.0), weights=factors.patches.area))
    assert max(sums) < 5e-4


def test_a_table_in_the_open_has_a_top() -> None:
    """Its patches see nothing but the lamp, and no ray from their middles meets that: they are no crate's bottom."""
    parts = subdivide(outside(), 900)
    areas = np.bincount(parts.polygon, parts.area)
    assert areas[1:3] == pytest.approx([4.0 - 0.3, 4.0])  # below the box the top is covered


def test_a_small_share_is_right_in_the_mean() -> None:
    """Through a slit that most of the first sixteen rays miss: the mean over many pairs is the truth, which for
    patches in two parallel planes is how often the middle between two of their points is in the slit."""
    b = Builder("slit")
    b.add(box((0, 0, 0), (4, 2, 2), inside=True), WALL)
    b.add(both_sides(at_2((0, 0, 2, 0.98), (0, 1.02, 2, 2))), LAMP)
    corner = np.stack(np.meshgrid(np.arange(10) / 5, np.arange(10) / 5), axis=2).reshape(-1, 2)  # of 100 patches: y, z
    ends = [
        np.array([quad((x, y, z), (x, y + 0.2, z), (x, y + 0.2, z + 0.2), (x, y, z + 0.2)) for y, z in corner])
        for x in (0.0, 4.0)
    ]
    polygons = np.concatenate([ends[0], ends[1][:, ::-1]])
    pairs = np.stack([index.ravel() for index in np.meshgrid(np.arange(100), np.arange(100, 200))], axis=1)
    scene = b.scene().checked()
    parts = patches_of(scene, list(polygons), [0] * 200)
    parts = replace(parts, normal=np.array([normal_of(polygon) for polygon in polygons]))
    shares = Visibility(Rays(scene)).fractions(parts, pairs)
    random = np.random.default_rng(1)
    z = [polygons[pairs[:, k], :, 2].min(axis=1) + 0.2 * random.random((400, len(pairs))) for k in (0, 1)]
    true = np.abs((z[0] + z[1]) / 2.0 - 1.0) < 0.02
    assert shares.mean() == pytest.approx(true.mean(), rel=0.02)


# ---------------------------------------------------------------- what is a body


def tube() -> Polygons:
    return box((0, 0, 0), (1, 1, 1))[:2] + box((0, 0, 0), (1, 1, 1))[4:]


def roof(low: float = 0.0) -> Polygons:
    """A pyramid over a square, and its square."""
    a, b, c, d, top = np.array([(0, low, 0), (0, low, 1), (1, low, 1), (1, low, 0), (0.5, 1, 0.5)], float)
    return [np.array([a, b, top]), np.array([b, c, top]), np.array([c, d, top]), np.array([d, a, top]),
            np.array([d, c, b, a])]  # fmt: skip


CUBE = box((0, 0, 0), (1, 1, 1))
HALVES = [polygon[[0, 1, 2]] for polygon in CUBE] + [polygon[[0, 2, 3]] for polygon in CUBE]


@pytest.mark.parametrize(
    ("polygons", "proven"),
    [
        (CUBE, True),
        (HALVES, True),
        (CUBE[:5], True),  # one flat hole
        (roof(), True),
        (roof()[:4], True),
        (CUBE[:4], False),  # two holes that meet
        (tube(), False),
        ([polygon[::-1] for polygon in CUBE], False),  # its fronts look inwards
        ([*CUBE, CUBE[0]], False),
        ([*CUBE, CUBE[0][::-1]], False),
        ([*CUBE[:5], HALVES[5]], True),  # half of the last face is the hole
        ([*CUBE[1:], CUBE[0] * (1, 0.9, 1)], True),  # the hole is a slit along the last face
        ([CUBE[0] - (1e-4, 0, 0), *CUBE[1:]], False),  # a gap all around
        (CUBE[1:] + [polygon[::-1] for polygon in CUBE[1:]], False),
        (roof() + [polygon[::-1] * (1, -1, 1) for polygon in roof()[:4]], False),  # a square within an octahedron
        (roof(0.5)[:4] + CUBE[:5], False),
    ],
)
def test_what_is_proven_to_be_a_body(polygons: Polygons, proven: bool) -> None:
    found = surface_of(polygons, 1e-6)
    assert (found is not None) == proven
    turn, _ = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))
    turn *= np.linalg.det(turn)
    assert (surface_of([polygon @ turn.T for polygon in polygons], 1e-6) is not None) == proven


@pytest.mark.parametrize("name", SCENES)
def test_only_bodies_hide_by_themselves(name: str) -> None:
    """The seven bars are bodies, and outside the two boxes that touch each other are none."""
    found = bodies_of(SCENES[name]())
    assert found is not None
    assert found.solid.sum() == (7 if name == "bars" else 0)
