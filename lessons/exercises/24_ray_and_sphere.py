r"""A ray is $O + t\,\mathbf{D}$ with a unit vector $\mathbf{D}$ and $t > 0$. It meets the sphere around $C$ with the radius $r$ where

$$ |O + t\,\mathbf{D} - C| = r, \qquad t^2 + 2 b\, t + |O - C|^2 - r^2 = 0, \qquad b = (O - C) \cdot \mathbf{D} $$

Write three functions. Points and vectors are arrays of three numbers.

- `meet(O, D, C, r)`: the distance $t$ at which the ray meets the sphere for the first time, a number; -1 if it never does.
  What lies behind $O$ is not met. $O$ may be inside of the sphere: then the ray meets it from within.
- `in_shadow(P, lamp, C, r)`: 1 if the sphere stands between the point `P` and the lamp, else 0. Both are outside of it.
- `bounce(O, D, C, r)`: the ray that a mirror sphere sends on, two rows of three numbers: the point where it is met, and the unit
  vector of the new direction. `O` is outside, and the ray does meet the sphere.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors
from glsim.shading import terms

STARTER = '''\
import numpy as np


def meet(O, D, C, r):
    """The distance along the ray from O in the direction D to the sphere around C, a number; -1 if it is missed."""
    return -1.0


def in_shadow(P, lamp, C, r):
    """1 if the sphere is between P and the lamp, else 0."""
    return 0


def bounce(O, D, C, r):
    """Two rows: the point where the ray meets the sphere, and the direction in which it goes on."""
    return np.array([O, D])
'''


def roots(O, D, C, r):
    """Both distances to the sphere, the nearer one first; NaN if the line misses it."""
    b = (O - C) @ D
    under = b * b - ((O - C) @ (O - C) - r * r)
    root = np.sqrt(under) if under >= 0 else np.nan
    return -b - root, -b + root


def meet(O, D, C, r):
    return next((t for t in roots(O, D, C, r) if t > 0), -1.0)


def in_shadow(P, lamp, C, r):
    way = lamp - P
    distance = np.linalg.norm(way)
    return int(0 < meet(P, way / distance, C, r) < distance)


def mirrored(D, N):
    return terms.reflection(N, -D)


def bounce(O, D, C, r, direction=mirrored):
    P = O + meet(O, D, C, r) * D
    return np.array([P, direction(D, (P - C) / r)])


RNG = np.random.default_rng(24)


def rays(count, seed, off, behind=False):
    """Rays that pass the centre of a sphere at ``off`` (low, high) times its radius: (O, D, C, r)."""
    rng = np.random.default_rng(seed)
    for D in unit_vectors(count, seed + 100):
        C, r = rng.uniform(-2, 2, 3), rng.uniform(0.5, 2)
        aside = np.cross(D, rng.normal(size=3))
        aside = rng.uniform(*off) * r * aside / np.linalg.norm(aside)
        yield C + aside - (-1 if behind else 1) * rng.uniform(1.2, 3) * r * D, D, C, r


def inside(count, seed):
    rng = np.random.default_rng(seed)
    for D, aside in zip(
        unit_vectors(count, seed + 100), unit_vectors(count, seed + 200)
    ):
        C, r = rng.uniform(-2, 2, 3), rng.uniform(0.5, 2)
        yield C + rng.uniform(0, 0.8) * r * aside, D, C, r


O, X, Z = np.zeros(3), np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, -1.0])
HITS = [
    (O, Z, 5 * Z, 1.0),
    (np.array([0.6, 0.0, 0.0]), Z, 5 * Z, 1.0),
    *rays(15, 1, (0.2, 0.9)),
]
MISSES = [
    (np.array([1.5, 0.0, 0.0]), Z, 5 * Z, 1.0),
    *rays(8, 2, (1.05, 2)),
    *rays(4, 3, (0, 0.9)),
]
BEHIND = [(O, Z, -5 * Z, 1.0), *rays(8, 4, (0, 0.9), behind=True)]
INSIDE = [(O, Z, O, 2.0), (0.5 * Z, Z, O, 1.0), *inside(10, 5)]


def shadows(seed, far, off=(0, 0.9), behind=False):
    """P, lamp, C, r: the lamp at ``far`` times the distance that goes through the sphere (or is before it)."""
    for P, L, C, r in rays(8, seed, off, behind):
        yield P, P + far * (roots(P, L, C, r)[0] if behind else (C - P) @ L) * L, C, r


SHADOWS = [
    (O, np.array([0.0, 4.0, 0.0]), np.array([0.0, 2.0, 0.0]), 1.0),
    *shadows(6, 2.5),
]
SHADOWS += [tuple(0.1 * x for x in case) for case in SHADOWS[1:5]]  # nearer than 1
BESIDE = [
    (O, np.array([0.0, 4.0, 0.0]), np.array([3.0, 2.0, 0.0]), 1.0),
    *shadows(7, 2.5, (1.05, 3)),
]
BESIDE += [(P, P + 8 * L, C, r) for P, L, C, r in rays(4, 11, (0, 0.8), behind=True)]
BEYOND = [(O, np.array([0.0, 0.5, 0.0]), np.array([0.0, 2.0, 0.0]), 1.0)]
BEYOND += [
    (P, P + 0.7 * meet(P, L, C, r) * L, C, r) for P, L, C, r in rays(8, 8, (0, 0.9))
]
BEYOND += [(P, P + 3 * L, C, r) for P, L, C, r in rays(6, 9, (0, 0.9), behind=True)]
BEYOND += [(P, P + 0.05 * L, C, 0.2 * r) for P, L, C, r in rays(4, 10, (0, 0.1))]


def shadowed_by(test):
    """Wrong shadows: ``test`` gets the distance to the sphere, that to the lamp and both roots."""

    def wrong(P, lamp, C, r):
        way = lamp - P
        distance = np.linalg.norm(way)
        return int(
            test(
                meet(P, way / distance, C, r), distance, roots(P, way / distance, C, r)
            )
        )

    return wrong


def unnormalised(P, lamp, C, r):
    """In the shadow by roots for a direction that is no unit vector."""
    return int(0 < meet(P, lamp - P, C, r) < np.linalg.norm(lamp - P))


SHADOW_MISTAKES = [
    Mistake(unnormalised, "The direction to the lamp is no unit vector, and the formula for t asks for one."),
    Mistake(shadowed_by(lambda t, d, both: t > 0), "Whatever the ray meets casts a shadow here, also what is farther away than the lamp."),
    Mistake(shadowed_by(lambda t, d, both: not np.isnan(both[0])), "A sphere behind P casts no shadow on it: the ray begins at P."),
    Mistake(shadowed_by(lambda t, d, both: t < d), "A sphere that is not met at all gives -1, which is less than the distance, too."),
    Mistake(shadowed_by(lambda t, d, both: 0 < t < 1), "The ray has a unit vector, so t is a distance: compare it with that of the lamp, not with 1."),
    Mistake(lambda P, lamp, C, r: in_shadow(P, P + 1e6 * (lamp - P), C, r), "Whatever the ray meets casts a shadow here, also what is farther away than the lamp."),
    Mistake(lambda P, lamp, C, r: 1 - in_shadow(P, lamp, C, r), "Light and shadow are exchanged: 1 is shadow."),
    Mistake(lambda P, lamp, C, r: in_shadow(P, 2 * P - lamp, C, r), "The shadow ray goes away from the lamp."),
    Mistake(lambda P, lamp, C, r: in_shadow(P, P + lamp, C, r), "The lamp's position is taken as the direction: the ray goes from P to the lamp."),
    Mistake(lambda P, lamp, C, r: 0, "Nothing casts a shadow here."),
    Mistake(lambda P, lamp, C, r: 1, "Everything lies in the shadow here."),
]  # fmt: skip

EXERCISE = Definition(
    title="A ray meets a sphere",
    lesson=28,
    starter=STARTER,
    parts=[
        Call(
            "a sphere before the eye",
            "meet",
            HITS,
            meet,
            hint="Solve the quadratic equation for t; of its two roots the smaller one is met first.",
            mistakes=[
                Mistake(lambda *a: -1.0, "No ray meets anything: are the signs of b and of what is under the root right?"),
                Mistake(lambda *a: roots(*a)[1], "This is where the ray leaves the sphere: the other root is nearer."),
                Mistake(lambda *a: -roots(*a)[0], "The sign is the other way round: b is negative before the sphere."),
                Mistake(lambda *a: -roots(*a)[1], "The sign is the other way round: b is negative before the sphere."),
                Mistake(lambda O, D, C, r: (C - O) @ D, "This is where the ray comes closest to the centre; the surface is met before."),
                Mistake(lambda O, D, C, r: np.linalg.norm(C - O) - r, "This holds for a ray through the centre alone."),
                Mistake(lambda *a: 2 * roots(*a)[0], "t is twice too large: with 2 b in the equation the 2 of the formula for roots is gone."),
                Mistake(lambda *a: 0.5 * roots(*a)[0], "t is half of what it should be: with 2 b in the equation the 2 of the formula for roots is gone."),
                Mistake(lambda O, D, C, r: meet(O, D, C, np.sqrt(r)), "The radius is squared in the equation."),
                Mistake(lambda O, D, C, r: meet(O - C, D, C, r), "C is subtracted twice, or not at all where it should be."),
                Mistake(lambda O, D, C, r: meet(O, D, np.zeros(3), r), "C is missing: this is a sphere around the origin."),
                Mistake(lambda O, D, C, r: -(O - C) @ D - ((O - C) @ D) ** 2 + (O - C) @ (O - C) - r * r, "The root is missing."),
            ],
            points=2,
        ),
        Call(
            "a ray that misses",
            "meet",
            MISSES,
            meet,
            hint="Where the number under the root is negative there is no real root: the ray misses, and the answer is -1.",
            mistakes=[
                Mistake(lambda O, D, C, r: -(O - C) @ D if np.isnan(roots(O, D, C, r)[0]) else meet(O, D, C, r), "A negative number under the root is taken for 0: the ray only comes close to the sphere."),
                Mistake(lambda O, D, C, r: 0.0 if np.isnan(roots(O, D, C, r)[0]) else meet(O, D, C, r), "A ray that misses gives 0; -1 is asked for."),
                Mistake(lambda O, D, C, r: -1.0, "Some of these rays do meet the sphere."),
            ],
        ),
        Call(
            "a sphere behind the eye",
            "meet",
            BEHIND,
            meet,
            hint="What lies behind O has t < 0, and is not met.",
            mistakes=[
                Mistake(lambda *a: roots(*a)[0], "t is negative: the sphere lies behind the eye, and a ray goes forward only."),
                Mistake(lambda *a: roots(*a)[1], "t is negative: the sphere lies behind the eye, and a ray goes forward only."),
                Mistake(lambda *a: abs(roots(*a)[0]), "The absolute value brings what lies behind the eye before it."),
                Mistake(lambda *a: abs(roots(*a)[1]), "The absolute value brings what lies behind the eye before it."),
            ],
        ),
        Call(
            "from the inside",
            "meet",
            INSIDE,
            meet,
            hint="Inside of the sphere one root is negative and the other positive; the positive one is met.",
            mistakes=[
                Mistake(lambda *a: roots(*a)[0], "This root is behind O; inside of a sphere the other one is before it."),
                Mistake(lambda *a: -1.0, "The smaller root is behind O, but the ray does meet the sphere, from within: look at the other root."),
                Mistake(lambda *a: min(map(abs, roots(*a))), "The nearer of the two may be behind O."),
            ],
        ),
        Call("the shadow", "in_shadow", SHADOWS + BESIDE, in_shadow,
             hint="Send a ray from P to the lamp: if it meets the sphere before it is there, P is in the shadow.", mistakes=SHADOW_MISTAKES),
        Call("spheres that cast no shadow", "in_shadow", SHADOWS[:2] + BEYOND, in_shadow,
             hint="Only what stands between P and the lamp casts a shadow: neither what is farther away nor what is behind P.", mistakes=SHADOW_MISTAKES),
        Call(
            "a mirror sphere",
            "bounce",
            HITS,
            bounce,
            hint="The normal of a sphere points from its centre to the point; the direction is mirrored at it (lesson 9, with L = -D).",
            mistakes=[
                Mistake(lambda O, D, C, r: bounce(O, D, C, r, lambda D, N: -mirrored(D, N)), "The new ray goes into the sphere: -D points back to the eye, and R of lesson 9 is made of L = -D."),
                Mistake(lambda O, D, C, r: bounce(O, D, C, r, lambda D, N: -D), "The ray goes back where it came from: mirror it at the normal."),
                Mistake(lambda O, D, C, r: bounce(O, D, C, r, lambda D, N: D), "The ray goes on through the sphere: mirror it at the normal."),
                Mistake(lambda O, D, C, r: bounce(O, D, C, r, lambda D, N: N), "This is the normal; the direction is mirrored at it."),
                Mistake(lambda O, D, C, r: bounce(O, D, C, r, lambda D, N: D - (D @ N) * N), "The part along the normal must be subtracted twice: once brings the ray into the surface, twice to the other side."),
                Mistake(lambda O, D, C, r: bounce(O, D, C, r, lambda D, N: terms.normalize(D - (D @ N) * N)), "The ray slides along the surface: the part along the normal must be subtracted twice."),
                Mistake(lambda O, D, C, r: bounce(O, D, C, r, lambda D, N: D - 2 * r * r * (D @ N) * N), "The normal is not of unit length: from the centre to the point it is as long as the radius."),
                Mistake(lambda O, D, C, r: bounce(O, D, C, r, lambda D, N: mirrored(D, terms.normalize(O + meet(O, D, C, r) * D))), "The normal is the point itself: that holds for a sphere around the origin."),
                Mistake(lambda O, D, C, r: np.array([meet(O, D, C, r) * D, bounce(O, D, C, r)[1]]), "O is missing in the point: it is O + t D."),
                Mistake(lambda O, D, C, r: bounce(O, D, C, r)[::-1], "The rows are exchanged: first the point, then the direction."),
                Mistake(lambda O, D, C, r: np.array([C, bounce(O, D, C, r)[1]]), "The first row is the centre; the point on the surface is asked for."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
