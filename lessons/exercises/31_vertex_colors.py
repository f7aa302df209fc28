r"""Patches have one radiosity each; Gouraud shading wants a colour at each vertex. The simplest way is the mean of the patches that meet at the vertex $v$, weighted with their areas:

$$ B_v = \frac{\sum_{i \ni v} A_i B_i}{\sum_{i \ni v} A_i}, \qquad \mathrm{colour} = \left( \min(B / B_\mathrm{white},\, 1) \right)^{1/\gamma}, \qquad \gamma = 2.2 $$

Write `at_vertices(corners, A, B, count)`: the radiosities of `count` vertices, (count, 3). `corners`, (n, 4), has the numbers of the four vertices of each patch, `A` the patches' areas, (n,), `B` their radiosities, (n, 3).
Every vertex belongs to at least one patch. Write `toned(B, white)`: colours for the screen, of the same shape as `B`. And write `bake(corners, A, B, count, white)`: the colours of all vertices, (count, 3); light is averaged, not
the screen's colours.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake
from glsim.radiosity.tone import toned as shown

STARTER = '''\
import numpy as np


def at_vertices(corners, A, B, count):
    """Returns the radiosities (count, 3) of the vertices.  corners: (n, 4) numbers; A: (n,); B: (n, 3)."""
    return np.zeros((count, 3))


def toned(B, white):
    """Returns colours in [0, 1] of the same shape as B.  white: the radiosity that is shown as 1."""
    return B


def bake(corners, A, B, count, white):
    """Returns the colours (count, 3) of the vertices."""
    return np.zeros((count, 3))
'''


def gathered(corners, A, B, count):
    total, weight = np.zeros((count, 3)), np.zeros((count, 1))
    for patch, area, light in zip(corners, A, B, strict=True):
        total[patch] += area * light
        weight[patch] += area
    return total, weight


def at_vertices(corners, A, B, count):
    total, weight = gathered(corners, A, B, count)
    return total / weight


def toned(B, white, gamma=2.2):
    return shown(B, white, gamma=gamma)


def bake(corners, A, B, count, white):
    return toned(at_vertices(corners, A, B, count), white)


def last_patch(corners, A, B, count):
    result = np.zeros((count, 3))
    for patch, light in zip(corners, B, strict=True):
        result[patch] = light
    return result


RNG = np.random.default_rng(31)


def field(columns, rows):
    """A field of columns x rows patches of random sizes; its vertices in a random order."""
    number = RNG.permutation((columns + 1) * (rows + 1)).reshape(rows + 1, columns + 1)
    corners = [
        (number[r, c], number[r, c + 1], number[r + 1, c + 1], number[r + 1, c])
        for r in range(rows)
        for c in range(columns)
    ]
    A = np.outer(RNG.uniform(0.2, 3, rows), RNG.uniform(0.2, 3, columns)).ravel()
    B = RNG.uniform(0, 2, (rows * columns, 3))
    return np.array(corners), A, B, number.size


PAIR = (
    np.array([[0, 1, 2, 3], [1, 4, 5, 2]]),
    np.array([1.0, 3.0]),
    np.array([[1.0, 1.0, 0.0], [0.2, 0.6, 0.4]]),
    6,
)
FIELDS = [PAIR, field(2, 2), field(3, 2), field(4, 4)]
TONES = [(np.array([[0.5, 1.0, 0.1], [2.0, 0.0, 4.0]]), 2.0)]
TONES += [
    (RNG.uniform(0, 1.5, (n, 3)), float(RNG.uniform(0.4, 1.4))) for n in (1, 2, 5, 9)
]

EXERCISE = Definition(
    title="Vertex colours from patches",
    lesson=35,
    starter=STARTER,
    parts=[
        Call(
            "the mean at each vertex",
            "at_vertices",
            FIELDS,
            at_vertices,
            hint="For each vertex add area times radiosity of its patches, and divide by the sum of their areas.",
            mistakes=[
                Mistake(lambda c, A, B, n: at_vertices(c, np.ones(len(A)), B, n), "This is the plain mean: large patches should count more."),
                Mistake(lambda *a: gathered(*a)[0], "The division by the sum of the areas is missing."),
                Mistake(lambda c, A, B, n: gathered(c, np.ones(len(A)), B, n)[0], "This is the sum of the patches' radiosities: a mean is asked for."),
                Mistake(lambda c, A, B, n: at_vertices(c, 1 / A, B, n), "Small patches count more here: the area multiplies, it does not divide."),
                Mistake(lambda c, A, B, n: gathered(c, A, B, n)[0] / A.sum(), "Divide by the areas of the patches at this vertex, not by those of all patches."),
                Mistake(lambda c, A, B, n: gathered(c, A, B, n)[0] / gathered(c, np.ones(len(A)), B, n)[1], "Divide by the sum of the areas, not by the number of patches."),
                Mistake(last_patch, "Each vertex has the radiosity of its last patch: what was there before is overwritten."),
                Mistake(lambda c, A, B, n: last_patch(c[::-1], A, B[::-1], n), "Each vertex has the radiosity of its first patch only."),
                Mistake(lambda c, A, B, n: at_vertices(c, A**2, B, n), "The area counts once, not squared."),
                Mistake(lambda c, A, B, n: np.repeat(A @ B[None] / A.sum(), n, axis=0).reshape(n, 3), "All vertices have the mean of the whole room."),
            ],
            points=2,
        ),
        Call(
            "from radiosity to colour",
            "toned",
            TONES,
            toned,
            hint="Divide by white, cut off at 1, and take the power 1 / 2.2.",
            mistakes=[
                Mistake(lambda B, w: toned(B, w, 1 / 2.2), "The power is 2.2 here: dark places become darker still. It should undo the screen's curve."),
                Mistake(lambda B, w: toned(B, w, 1.0), "The power 1 / gamma is missing: the picture is too dark."),
                Mistake(lambda B, w: (B / w) ** (1 / 2.2), "Some colours exceed 1: cut them off."),
                Mistake(lambda B, w: np.clip(B, 0, 1) ** (1 / 2.2), "white is missing: it is the radiosity that becomes 1."),
                Mistake(lambda B, w: np.clip(B, 0, 1) / w, "Divide by white first, then cut off; and the power is missing."),
                Mistake(lambda B, w: (np.clip(B, 0, 1) / w) ** (1 / 2.2), "Divide by white first, then cut off at 1."),
                Mistake(lambda B, w: np.clip(np.clip(B, 0, None) ** (1 / 2.2) / w, 0, 1), "Divide by white first, then take the power: white must become 1."),
                Mistake(lambda B, w: toned(B * w, 1.0), "Divide by white: a radiosity of white becomes 1."),
                Mistake(lambda B, w: (B / B.max()) ** (1 / 2.2), "The brightest place becomes 1 here; it is white that decides."),
                Mistake(lambda B, w: (B / w / max((B / w).max(), 1)) ** (1 / 2.2), "This divides by the brightest channel: cut off each channel by itself."),
                Mistake(lambda B, w: toned(B, w, 2.0), "This is a square root, gamma = 2; use 2.2."),
            ],
        ),
        Call(
            "baked colours",
            "bake",
            [(*one, white) for one in FIELDS for white in (0.7, 1.6)],
            bake,
            hint="First the mean of the radiosities, then the tone.",
            mistakes=[
                Mistake(lambda c, A, B, n, w: at_vertices(c, A, toned(B, w), n), "Colours of the screen were averaged: their curve is no light any more. Average the radiosities first."),
                Mistake(lambda c, A, B, n, w: toned(at_vertices(c, A, np.minimum(B, w), n), w), "The patches were cut off at white before the mean: a lamp's light is lost at its vertices. Cut off at the end."),
                Mistake(lambda c, A, B, n, w: at_vertices(c, A, B, n), "These are radiosities still: the tone is missing."),
                Mistake(lambda c, A, B, n, w: toned(at_vertices(c, A, B, n), 1.0), "white is not used."),
                Mistake(lambda c, A, B, n, w: toned(at_vertices(c, np.ones(len(A)), B, n), w), "The areas are not used."),
                Mistake(lambda c, A, B, n, w: toned(bake(c, A, B, n, w), 1.0), "The tone is applied twice."),
            ],
        ),
    ],
)  # fmt: skip
