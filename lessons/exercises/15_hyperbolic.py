r"""Equal steps on the screen are no equal steps on a surface. With the values $f_k$ at the vertices, their distances $w_k$ from the
eye (the $w$ of clip space), and the weights $s_k$ of a pixel **on the screen**, $\sum_k s_k = 1$:

$$ f_\mathrm{affine} = \sum_k s_k f_k, \qquad f_\mathrm{hyperbolic} = \frac{\sum_k s_k f_k / w_k}{\sum_k s_k / w_k} $$

A fence of length 1 begins at the distance 1 and ends at the distance 3. `MIDDLE`: which place of the fence, between 0 and 1, is seen midway between its
two ends in the picture? `MIDDLE_AFFINE`: which one does affine interpolation claim?

Write `affine(s, f_1, f_2)` and `hyperbolic(s, f_1, f_2, w_1, w_2)` for an edge: $s$ is 0 at the first vertex and 1 at the second. $f_1$ and $f_2$ are numbers or arrays
of numbers. Write `in_triangle(s, f, w)` for a triangle: `s` and `w` have three numbers, `f` is an array (3, m) with a row for each vertex; returns m numbers.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, Value

STARTER = '''\
import numpy as np

MIDDLE = 0
MIDDLE_AFFINE = 0


def affine(s, f_1, f_2):
    """Returns the value at s (0 to 1) between f_1 and f_2, in equal steps on the screen."""
    return f_1


def hyperbolic(s, f_1, f_2, w_1, w_2):
    """Returns the value at s (0 to 1) on the screen between vertices at the distances w_1 and w_2."""
    return f_1


def in_triangle(s, f, w):
    """Returns the m values at a pixel.  s: weights on the screen (3,); f: (3, m); w: distances (3,)."""
    return f[0]
'''


def affine(s, f_1, f_2):
    return (1 - s) * f_1 + s * f_2


def hyperbolic(s, f_1, f_2, w_1, w_2):
    return affine(s, f_1 / w_1, f_2 / w_2) / affine(s, 1 / w_1, 1 / w_2)


def in_triangle(s, f, w):
    return (s / w) @ f / (s / w).sum()


RNG = np.random.default_rng(15)
EDGES = [(0.5, 0.0, 1.0), (0.25, 2.0, 4.0)]
EDGES += [(float(RNG.uniform()), *RNG.uniform(-2, 3, (2, 3))) for _ in range(16)]
DEEP = [(0.5, 0.0, 1.0, 1.0, 5.0), (0.5, 2.0, 4.0, 2.0, 1.0)]
DEEP += [(*edge, *map(float, RNG.uniform(0.5, 9, 2))) for edge in EDGES[2:]]
TRIANGLES = [
    (np.array([0.5, 0.25, 0.25]), np.array([[0.0], [1.0], [1.0]]), np.array([1.0, 2.0, 4.0]))
]  # fmt: skip
TRIANGLES += [
    (RNG.dirichlet((2, 2, 2)), RNG.uniform(-1, 2, (3, m)), RNG.uniform(0.5, 9, 3))
    for m in (1, 2, 3, 3, 4, 2, 3, 2, 4, 1)
]

EXERCISE = Definition(
    title="Hyperbolic interpolation",
    lesson=19,
    starter=STARTER,
    parts=[
        Value(
            "the middle of the fence",
            {"MIDDLE": 0.25, "MIDDLE_AFFINE": 0.5},
            hint="Use s = 1/2, f = 0 and 1 at the ends, w = 1 and 3.",
            wrong={
                "MIDDLE": [(0.5, "The near half of the fence takes more than half of the picture: midway in the picture its middle is not reached yet."),
                           (0.75, "The far end was given the larger share: the near part looks large, so midway in the picture one is still near the beginning."),
                           (1 / 3, "This is the ratio of the distances: put s = 1/2 into the formula."),
                           (2.0, "This is the distance of the middle; the place on the fence, from 0 to 1, is asked for."),
                           (1.5, "This is the distance from the eye there; the place on the fence, from 0 to 1, is asked for.")],
                "MIDDLE_AFFINE": [(0.25, "This is the right place; affine interpolation ignores the distances.")],
            },
            points=1,
        ),
        Call(
            "affine, on an edge",
            "affine",
            EDGES,
            affine,
            hint="At s = 0 it is f_1, at s = 1 it is f_2, and a straight line between them.",
            mistakes=[
                Mistake(lambda s, a, b: s * a + (1 - s) * b, "The ends are exchanged: at s = 0 the value is f_1."),
                Mistake(lambda s, a, b: (a + b) / 2, "This is the mean of both: s has to count."),
                Mistake(lambda s, a, b: a + s * b, "At s = 1 this is f_1 + f_2: the share of f_1 has to shrink."),
                Mistake(lambda s, a, b: a if s < 0.5 else b, "This takes the nearer end: interpolate."),
                Mistake(lambda s, a, b: s * (b - a), "This begins at 0: it should begin at f_1."),
            ],
        ),
        Call(
            "hyperbolic, on an edge",
            "hyperbolic",
            DEEP,
            hyperbolic,
            hint="Interpolate f / w and 1 / w in equal steps on the screen, and divide one by the other.",
            mistakes=[
                Mistake(lambda s, a, b, w, v: affine(s, a, b), "This is affine: the distances do not count."),
                Mistake(lambda s, a, b, w, v: hyperbolic(1 - s, a, b, w, v), "The ends are exchanged: at s = 0 the value is f_1."),
                Mistake(lambda s, a, b, w, v: hyperbolic(s, a, b, v, w), "Here the far end counts more. Either the distances are exchanged (w_1 belongs to f_1), or the values are multiplied by w: divide."),
                Mistake(lambda s, a, b, w, v: affine(s, a / w, b / v), "This is f / w, interpolated: the division by the interpolated 1 / w is missing."),
                Mistake(lambda s, a, b, w, v: affine(s, a / w, b / v) * affine(s, 1 / w, 1 / v), "Divide by the interpolated 1 / w; here it is a factor."),
                Mistake(lambda s, a, b, w, v: affine(s, a / w, b / v) * affine(s, w, v), "This multiplies by the interpolated w. On the screen w is not linear, 1 / w is."),
                Mistake(lambda s, a, b, w, v: affine(s, a, b) / affine(s, 1 / w, 1 / v), "The values must be divided by their own w before they are interpolated."),
                Mistake(lambda s, a, b, w, v: affine(s, a / w, b / v) / affine(s, w, v), "The divisor is the interpolated 1 / w, not the interpolated w."),
                Mistake(lambda s, a, b, w, v: affine(s, a * w, b * v) / affine(s, 1 / w, 1 / v), "The values are multiplied by w; divide by it."),
                Mistake(lambda s, a, b, w, v: affine(s, a / w**2, b / v**2) / affine(s, 1 / w**2, 1 / v**2), "The distance counts once, not squared."),
            ],
            points=2,
        ),
        Call(
            "in a triangle",
            "in_triangle",
            TRIANGLES,
            in_triangle,
            hint="Each vertex counts with s / w; the sum of these weights must be divided out again.",
            mistakes=[
                Mistake(lambda s, f, w: s @ f, "This is affine: the distances do not count."),
                Mistake(lambda s, f, w: (s / w) @ f, "The division by the sum of s / w is missing."),
                Mistake(lambda s, f, w: (s * w) @ f / (s * w).sum(), "The weights are multiplied by w; divide by it: what is far away counts less."),
                Mistake(lambda s, f, w: (s / w) @ f * (s @ w), "This multiplies by the interpolated w. On the screen w is not linear, 1 / w is."),
                Mistake(lambda s, f, w: (s / w) @ f / (1 / w).sum(), "The divisor is 1 / w interpolated: the weights s belong there, too."),
                Mistake(lambda s, f, w: (1 / w) @ f / (1 / w).sum(), "The weights s are missing: every pixel of the triangle gets the same."),
                Mistake(lambda s, f, w: (s / w) @ f * w.mean(), "This multiplies by the mean distance: each pixel has its own 1 / w."),
                Mistake(lambda s, f, w: (s / w**2) @ f / (s / w**2).sum(), "The distance counts once, not squared."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
