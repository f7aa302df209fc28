r"""The light of a lamp gets weaker with the distance, and a spot shines into a cone only:

$$ a = \frac{1}{k_0 + k_1 d + k_2 d^2}, \qquad
s = \begin{cases} 0 & \text{outside of the cone} \\ (-\mathbf{L} \cdot \mathbf{S})^e & \text{inside} \end{cases} $$

Write three functions:

- `attenuation(d, k_0, k_1, k_2)`: the factor $a$, a number; $d$ is the distance from the lamp.
- `spot(L, S, cutoff, e)`: the factor $s$, a number. `L` is the unit vector from the surface to the lamp, `S` the unit vector
  in which the spot shines, `cutoff` the angle in degrees between the axis and the edge of the cone, at most 90, or 180:
  OpenGL's word for a lamp that is no spot, for which $s = 1$.
- `lamp(P, lamp, k, S, cutoff, e)`: the factor $a\,s$ at the point `P`, a number. `lamp` is the lamp's position, four numbers as
  `glLightfv(GL_LIGHT0, GL_POSITION, ...)` takes them: with a fourth number of 0 it is a directional light, which has no
  distance; the first three point towards it and need not be a unit vector. `k` are $k_0, k_1, k_2$.
  `S` need not be a unit vector here.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors
from glsim.shading import terms

STARTER = '''\
import numpy as np


def attenuation(d, k_0, k_1, k_2):
    """The share of the lamp's light at the distance d, a number."""
    return 1.0


def spot(L, S, cutoff, e):
    """The share of a spot's light, a number.  L: unit vector to the lamp.  S: unit vector in which the spot shines.
    cutoff: degrees.  e: exponent."""
    return 1.0


def lamp(P, lamp, k, S, cutoff, e):
    """Both factors at the point P, a number.  lamp: position, four numbers.  k: three numbers."""
    return 1.0
'''


def spot(L, S, cutoff, e):
    return float(terms.spotlight(L, S, cutoff, e)[..., 0])


def attenuation(d, k_0, k_1, k_2):
    return float(terms.attenuation(d, k_0, k_1, k_2))


def lamp(
    P, position, k, S, cutoff, e, fade=attenuation, unit=terms.normalize, cone=spot
):
    to_lamp = position[:3] - (P if position[3] else 0)
    a = fade(np.linalg.norm(to_lamp), *k) if position[3] else 1.0
    return a * cone(unit(to_lamp), unit(S), cutoff, e)


def with_cosine(cutoff_cosine, power=lambda cosine, e: cosine**e):
    """Wrong spots: with another cosine of the cone or another fall-off in it."""

    def wrong(L, S, cutoff, e):
        cosine = -L @ S
        if cutoff == 180:
            return 1.0
        return power(cosine, e) if cosine >= cutoff_cosine(cutoff) else 0.0

    return wrong


def edge(cutoff):
    return np.cos(np.radians(cutoff))


def everywhere(L, S, cutoff, e):
    """A wrong lamp that is no spot: the exponent counts."""
    return max(-L @ S, 0) ** e if cutoff == 180 else spot(L, S, cutoff, e)


RNG = np.random.default_rng(19)
DISTANCES = [(2.0, 1.0, 0.0, 0.5), (2.0, 0.5, 1.0, 0.0), (0.5, 0.2, 0.1, 0.3)]
DISTANCES += [tuple(row) for row in RNG.uniform(0.2, 3, (20, 4))]
DOWN = np.array([0.0, 0.0, -1.0])


def tilted(angle, turn=0.3):
    """The unit vector to a lamp that shines down, at ``angle`` degrees off its axis."""
    a = np.radians(angle)
    return np.array([np.sin(a) * np.cos(turn), np.sin(a) * np.sin(turn), np.cos(a)])


def near_axis(count, cutoff, seed):
    """Vectors to the lamp and directions of the spot, inside of the cone: (L, S)."""
    rng = np.random.default_rng(seed + 1000)
    for S in unit_vectors(count, seed):
        across = np.cross(S, rng.normal(size=3))
        angle = np.radians(rng.uniform(0, 0.9 * cutoff))
        yield -np.cos(angle) * S + np.sin(angle) * across / np.linalg.norm(across), S


INSIDE = [(tilted(0), DOWN, 30.0, 2.0), (tilted(20), DOWN, 30.0, 2.0)]
INSIDE += [(L, S, 40.0, 5.0) for L, S in near_axis(8, 40, 3)]
INSIDE += [(L, S, 85.0, 1.5) for L, S in near_axis(8, 85, 4)]
OUTSIDE = [(tilted(a), DOWN, c, e) for a, c, e in (
    (40.0, 30.0, 2.0), (29.0, 30.0, 0.0), (31.0, 30.0, 0.0), (50.0, 60.0, 3.0), (80.0, 60.0, 3.0), (120.0, 80.0, 2.0),
    (89.0, 90.0, 1.0), (91.0, 90.0, 1.0), (150.0, 90.0, 2.0), (35.0, 70.0, 1.0),
)]  # fmt: skip
OUTSIDE += [(L, S, 50.0, 2.0) for L, S in zip(unit_vectors(12, 5), unit_vectors(12, 6))]
NO_SPOT = [
    (L, S, 180.0, e)
    for L, S, e in zip(unit_vectors(8, 7), unit_vectors(8, 8), (0.0, 1.0, 2.0, 5.0) * 2)
]


def lamps(count, w, cutoff, seed):
    rng = np.random.default_rng(seed)
    for L, S in near_axis(count, cutoff, seed):
        P, distance = rng.uniform(-2, 2, 3), rng.uniform(1.5, 4)
        position = np.array([*(distance * L if w == 0 else P + distance * L), w])
        yield (
            P,
            position,
            rng.uniform(0.2, 1, 3),
            S * rng.uniform(0.3, 3),
            float(cutoff),
            3.0,
        )


LAMPS = [
    (
        np.zeros(3),
        np.array([0.0, 0.0, 2.0, 1.0]),
        np.array([1.0, 0.0, 1.0]),
        DOWN,
        45.0,
        1.0,
    ),
    *lamps(10, 1.0, 60, 11),
    *((P, at, k, S, 180.0, e) for P, at, k, S, _, e in lamps(5, 1.0, 60, 12)),
]
SUNS = [
    *((P, at, k, S, 180.0, e) for P, at, k, S, _, e in lamps(5, 0.0, 60, 13)),
    *lamps(8, 0.0, 70, 14),
]


def other_attenuation(formula):
    return lambda P, at, k, S, c, e: lamp(P, at, k, S, c, e, fade=formula)


EXERCISE = Definition(
    title="Attenuation and spots",
    lesson=23,
    starter=STARTER,
    parts=[
        Call(
            "attenuation",
            "attenuation",
            DISTANCES,
            attenuation,
            hint="The share is 1 divided by a polynomial of the distance.",
            mistakes=[
                Mistake(lambda d, a, b, c: 1.0, "Nothing gets weaker with the distance here."),
                Mistake(lambda d, a, b, c: a + b * d + c * d * d, "This is the divisor itself: the light would get stronger with the distance."),
                Mistake(lambda d, a, b, c: 1 / (a + b * d + c * d), "The last term goes with the square of the distance."),
                Mistake(lambda d, a, b, c: 1 / (a + b * d + (c * d) ** 2), "Only the distance is squared, not k_2."),
                Mistake(lambda d, a, b, c: 1 / (a * d * d + b * d + c), "k_0 and k_2 are exchanged: k_0 is the constant one."),
                Mistake(lambda d, a, b, c: 1 / (a + c * d + b * d * d), "k_1 and k_2 are exchanged."),
                Mistake(lambda d, a, b, c: 1 / a + b * d + c * d * d, "Only k_0 is below the fraction bar: parentheses."),
                Mistake(lambda d, a, b, c: min(1 / (a + b * d + c * d * d), 1), "The factor is clamped to 1; OpenGL clamps the colour at the end, not this factor."),
                Mistake(lambda d, a, b, c: 1 / (d * d), "This is nature's law; the lamp's own k_0, k_1 and k_2 are asked for."),
            ],
        ),
        Call(
            "a spot, inside of the cone",
            "spot",
            INSIDE,
            spot,
            hint="Inside the share is a power of the cosine between the axis and the direction from the lamp to the surface, which is -L.",
            mistakes=[
                Mistake(lambda L, S, c, e: 1.0, "The exponent has no effect: towards the edge of the cone it is darker."),
                Mistake(lambda L, S, c, e: 0.0, "L points to the lamp and S away from it: a surface in the middle of the cone has L·S = -1."),
                Mistake(lambda L, S, c, e: -L @ S, "The exponent is missing."),
                Mistake(lambda L, S, c, e: e * (-L @ S), "The exponent is an exponent, not a factor."),
                Mistake(lambda L, S, c, e: (1 - np.arccos(np.clip(-L @ S, -1, 1)) / np.radians(c)) ** e, "The fall-off goes with the cosine, not with the angle."),
                Mistake(with_cosine(np.radians), "The cosine is compared with an angle: compare cosine with cosine."),
                Mistake(with_cosine(np.cos), "cutoff is in degrees, and cos takes radians."),
                Mistake(with_cosine(lambda c: edge(c / 2)), "cutoff is the angle between the axis and the edge, not the whole angle of the cone."),
                Mistake(lambda L, S, c, e: (-L @ S - edge(c)) / (1 - edge(c)), "The cone has no soft edge of its own in OpenGL: only the power of the cosine."),
            ],
        ),
        Call(
            "a spot, outside of the cone",
            "spot",
            OUTSIDE,
            spot,
            hint="Outside of the cone there is no light: the angle at the axis is larger than cutoff where its cosine is smaller than the cosine of cutoff.",
            mistakes=[
                Mistake(lambda L, S, c, e: max(-L @ S, 0) ** e, "The cone has no edge: beyond the angle cutoff there is no light."),
                Mistake(with_cosine(lambda c: -np.inf), "The cone has no edge, and behind the spot the cosine is negative."),
                Mistake(with_cosine(np.radians), "The cosine is compared with an angle: compare cosine with cosine."),
                Mistake(with_cosine(np.cos), "cutoff is in degrees, and cos takes radians."),
                Mistake(with_cosine(lambda c: edge(c / 2)), "cutoff is the angle between the axis and the edge, not the whole angle of the cone."),
                Mistake(lambda L, S, c, e: 0.0 if edge(c) <= -L @ S else max(-L @ S, 0) ** e, "It is dark inside of the cone and light outside: turn the comparison."),
                Mistake(lambda L, S, c, e: abs(L @ S) ** e if abs(L @ S) >= edge(c) else 0, "There is a second cone behind the spot: the sign of the cosine counts."),
            ],
        ),
        Call(
            "a lamp that is no spot",
            "spot",
            NO_SPOT,
            spot,
            hint="With cutoff 180 the lamp shines alike in all directions, whatever the exponent.",
            mistakes=[
                Mistake(everywhere, "With cutoff 180 the lamp is no spot: the exponent does not count either."),
                Mistake(lambda L, S, c, e: float(-L @ S > 0), "Half of the space is dark, but with cutoff 180 all of it gets light."),
                Mistake(lambda L, S, c, e: (-L @ S) ** e, "With cutoff 180 the lamp is no spot: neither cosine nor exponent count."),
            ],
        ),
        Call(
            "a lamp at a place",
            "lamp",
            LAMPS,
            lamp,
            hint="L is the unit vector from P to the lamp, d their distance; S becomes a unit vector too; then both factors are multiplied.",
            mistakes=[
                Mistake(other_attenuation(lambda d, a, b, c: 1.0), "The attenuation is missing."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at[:3] - P), *k), "The spot is missing."),
                Mistake(other_attenuation(lambda d, a, b, c: attenuation(d * d, a, b, c)), "The distance is squared already before it goes into the formula: take the root."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at[:3]), *k) * spot(terms.normalize(at[:3] - P), terms.normalize(S), c, e), "The distance counts from the origin, not from P."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at - [*P, 0]), *k) * spot(terms.normalize(at[:3] - P), terms.normalize(S), c, e), "The fourth number of the position counts in the distance: a vector has three."),
                Mistake(lambda P, at, k, S, c, e: lamp(P, at, k, S, c, e, unit=lambda v: v), "L and S are not normalised: their product is no cosine."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at[:3] - P), *k) * spot(terms.normalize(at[:3] - P), S, c, e), "S is not normalised: the product with L is no cosine."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at[:3] - P), *k) * spot(at[:3] - P, terms.normalize(S), c, e), "L is not normalised: the product with S is no cosine."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at[:3] - P), *k) * spot(terms.normalize(P - at[:3]), terms.normalize(S), c, e), "L points from the lamp to P: it must point to the lamp."),
                Mistake(lambda P, at, k, S, c, e: attenuation(1.0, *k) * spot(terms.normalize(at[:3] - P), terms.normalize(S), c, e), "The distance is 1 everywhere: it is the length of the vector to the lamp before it is normalised."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at[:3] - P), *k) + spot(terms.normalize(at[:3] - P), terms.normalize(S), c, e), "The factors are multiplied, not added."),
            ],
        ),
        Call(
            "a directional light",
            "lamp",
            SUNS,
            lamp,
            hint="A directional light has no distance, so nothing fades; but with a cutoff it still is a spot, and L is the same at every point.",
            mistakes=[
                Mistake(lambda P, at, k, S, c, e: lamp(P, np.array([*at[:3], 1]), k, S, c, e), "The fourth number, 0, is not looked at: a directional light has no place."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at[:3]), *k) * lamp(P, at, k, S, c, e), "A directional light is not attenuated: the length of its vector is no distance."),
                Mistake(lambda P, at, k, S, c, e: attenuation(np.linalg.norm(at[:3] - P), *k) * lamp(P, at, k, S, c, e), "A directional light is not attenuated: it has no distance."),
                Mistake(lambda P, at, k, S, c, e: spot(terms.normalize(at[:3] - P), terms.normalize(S), c, e), "The direction is that to a place; a directional light shines in the same direction at every point."),
                Mistake(lambda P, at, k, S, c, e: 1.0, "A directional light with a cutoff still is a spot."),
                Mistake(lambda P, at, k, S, c, e: spot(at[:3], terms.normalize(S), c, e), "The vector towards a directional light need not be a unit vector: normalise it."),
                Mistake(lambda P, at, k, S, c, e: spot(terms.normalize(-at[:3]), terms.normalize(S), c, e), "The position of a directional light points towards it already: it is L, not -L."),
            ],
        ),
    ],
)  # fmt: skip
