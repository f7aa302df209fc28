r"""The lecture's special cases: many lights, light from behind, and sums above 1.

$$ I = I_a k_a + \sum_i I_{L,i} \big( k_d \max(\mathbf{N} \cdot \mathbf{L}_i, 0) + k_s\, (\mathbf{R}_i \cdot \mathbf{V})^n \big) $$

Write `illuminate(k_a, k_d, k_s, n, I_a, lights, directions, N, V)`: the colour under $m$ lights, clamped to $[0, 1]$ once, at the end. `lights` are the intensities $I_{L,i}$, (m, 3),
`directions` the unit vectors $\mathbf{L}_i$, (m, 3), and $\mathbf{R}_i = 2 (\mathbf{N} \cdot \mathbf{L}_i) \mathbf{N} - \mathbf{L}_i$. A light with $\mathbf{N} \cdot \mathbf{L}_i \le 0$ adds nothing, no highlight either.

Two other answers to $\mathbf{N} \cdot \mathbf{L} < 0$, for dull surfaces under one light of intensity `I_L`, unclamped: write `flip(k_d, I_L, N, L)`, which uses $-\mathbf{N}$ wherever the normal looks away from the **light**, and
`two_sided(front, back, I_L, N, L, V)`: where the normal looks away from the **eye**, the surface shows its back; it is lit with $-\mathbf{N}$ and the reflectance `back` instead of `front`. `N`, `L`, `V` are unit vectors, colours have three
channels.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def illuminate(k_a, k_d, k_s, n, I_a, lights, directions, N, V):
    """Returns red, green and blue in [0, 1].  lights: intensities (m, 3); directions: unit vectors (m, 3)."""
    return I_a * k_a


def flip(k_d, I_L, N, L):
    """Returns the diffuse colour (3,); the normal is turned towards the light."""
    return k_d


def two_sided(front, back, I_L, N, L, V):
    """Returns the diffuse colour (3,) of the side that the eye sees.  front, back: reflectances (3,)."""
    return front
'''


def terms(k_a, k_d, k_s, n, I_a, lights, directions, N, V, lowest=0.0, tested=True):
    """The glow, and the diffuse and the specular term of each light."""
    cosine = directions @ N
    R = 2 * cosine[:, None] * N - directions
    highlight = np.maximum(R @ V, 0) ** n * ((cosine > 0) | (not tested))
    return (
        I_a * k_a,
        lights * k_d * np.maximum(cosine, lowest)[:, None],
        lights * k_s * highlight[:, None],
    )


def summed(*arguments, **options):
    glow, diffuse, specular = terms(*arguments, **options)
    return glow + (diffuse + specular).sum(axis=0)


def illuminate(*arguments):
    return np.clip(summed(*arguments), 0, 1)


def clamped_sum(*arguments):
    return np.clip(summed(*arguments, lowest=-9.0), 0, 1)


def flip(k_d, I_L, N, L):
    return k_d * I_L * abs(N @ L)


def two_sided(front, back, I_L, N, L, V):
    side = 1 if N @ V >= 0 else -1
    return (front if side > 0 else back) * I_L * max(side * (N @ L), 0)


def subset(which):
    return lambda a, d, s, n, Ia, I, L, N, V: illuminate(
        a, d, s, n, Ia, I[which], L[which], N, V
    )


RNG = np.random.default_rng(10)


def case(lights, behind, bright, seed):
    """Some lights in front of the surface, whose highlights are seen, and some behind it."""
    N = unit_vectors(1, seed)[0]
    directions = unit_vectors(lights + behind, seed + 100)
    cosine = directions @ N
    turn = np.where(np.arange(lights + behind) < lights, cosine < 0, cosine > 0)
    directions = np.where(
        turn[:, None], directions - 2 * cosine[:, None] * N, directions
    )
    V = (
        2 * (N @ directions[0]) * N
        - directions[0]
        + 0.3 * unit_vectors(1, seed + 200)[0]
    )
    k_a, k_d, k_s, I_a = RNG.uniform(0.05, 0.5, (4, 3))
    order = RNG.permutation(lights + behind)
    return (
        k_a,
        k_d,
        k_s,
        float(RNG.integers(1, 9)),
        I_a,
        RNG.uniform(0.1, 0.7, (lights + behind, 3)) * (6.0 if bright else 1.0),
        directions[order],
        N,
        V / np.linalg.norm(V),
    )  # fmt: skip


MANY = [case(m, 0, False, m + k) for m in (1, 2, 3) for k in (0, 10, 20, 30)]
BEHIND = [case(1, m, False, 50 + m + k) for m in (1, 2, 4) for k in (0, 10, 20)]
BRIGHT = [case(2, 2, True, 400 + k) for k in range(10)]
DULL = [
    (*RNG.uniform(0.1, 1, (2, 3)), N, L)
    for N, L in zip(unit_vectors(16, 6), unit_vectors(16, 7), strict=True)
]
SIDES = [
    (*RNG.uniform(0.1, 1, (3, 3)), *vectors)
    for vectors in zip(
        unit_vectors(30, 1), unit_vectors(30, 2), unit_vectors(30, 3), strict=True
    )
]

EXERCISE = Definition(
    title="Clamp, flip, two sides, many lights",
    lesson=13,
    starter=STARTER,
    parts=[
        Call(
            "many lights",
            "illuminate",
            MANY,
            illuminate,
            hint="The glow counts once; each light adds its diffuse term and its highlight.",
            mistakes=[
                Mistake(subset(slice(0, 1)), "Only the first light counts."),
                Mistake(subset(slice(-1, None)), "Only the last light counts: add them up."),
                Mistake(lambda *a: np.clip(summed(*a) + (len(a[5]) - 1) * terms(*a)[0], 0, 1), "The ambient glow counts once, not once for each light."),
                Mistake(lambda *a: np.clip(terms(*a)[0] + sum(terms(*a)[1:]).mean(axis=0), 0, 1), "Lights are added, not averaged: two lamps are brighter than one."),
                Mistake(lambda *a: np.clip(terms(*a)[0] + sum(terms(*a)[1:]).max(axis=0), 0, 1), "Lights are added; this takes the brightest."),
                Mistake(lambda *a: np.clip(sum(terms(*a)[1:]).sum(axis=0), 0, 1), "The ambient glow is missing."),
                Mistake(lambda *a: np.clip(terms(*a)[0] + terms(*a)[1].sum(axis=0), 0, 1), "The highlights are missing."),
                Mistake(lambda *a: np.clip(terms(*a)[0] + terms(*a)[2].sum(axis=0), 0, 1), "The diffuse terms are missing."),
                Mistake(lambda a, d, s, *rest: illuminate(a, s, d, *rest), "k_d and k_s are exchanged."),
                Mistake(lambda a, d, s, n, Ia, I, L, N, V: illuminate(a, d, s, n, Ia, I.sum(axis=0)[None], L.sum(axis=0)[None] / np.linalg.norm(L.sum(axis=0)), N, V),
                        "This makes one light of all: each has its own direction."),
            ],
            points=2,
        ),
        Call(
            "lights behind the surface",
            "illuminate",
            BEHIND,
            illuminate,
            hint="A light behind the surface adds nothing; the glow and the other lights stay.",
            mistakes=[
                Mistake(clamped_sum, "Lights behind the surface take light away from the others: clamp each light's own N·L, not the sum."),
                Mistake(lambda *a: np.clip(summed(*a, tested=False), 0, 1), "A light behind the surface makes a highlight: R·V may be positive all the same."),
                Mistake(lambda *a: np.clip(summed(*a, tested=False, lowest=-9.0), 0, 1), "A light behind the surface has a negative diffuse term and may even have a highlight: it should add nothing."),
                Mistake(lambda *a: 0 * a[0], "Because one light is behind the surface everything is black: only that light's terms are 0."),
                Mistake(lambda *a: np.clip(terms(*a)[0], 0, 1), "Because one light is behind the surface all lights are left out: only that one adds nothing."),
                Mistake(lambda a, d, s, n, Ia, I, L, N, V: illuminate(a, d, s, n, Ia, I, L * np.where(L @ N < 0, -1, 1)[:, None], N, V), "Lights behind the surface shine through it."),
            ],
        ),
        Call(
            "bright lights",
            "illuminate",
            BRIGHT,
            illuminate,
            hint="A channel cannot be brighter than 1.",
            mistakes=[
                Mistake(summed, "Some channels exceed 1: clamp the sum."),
                Mistake(lambda *a: terms(*a)[0] + np.clip(sum(terms(*a)[1:]), 0, 1).sum(axis=0), "Each light is clamped, and their sum exceeds 1: clamp once, at the end."),
                Mistake(lambda *a: terms(*a)[0] + sum(np.clip(t, 0, 1).sum(axis=0) for t in terms(*a)[1:]), "Each term is clamped, and their sum exceeds 1: clamp once, at the end."),
                Mistake(lambda *a: summed(*a) / max(summed(*a).max(), 1), "This divides by the brightest channel: the lecture clamps each channel by itself."),
                Mistake(lambda *a: summed(*a) % 1.0, "What exceeds 1 begins at 0 again, as when a byte overflows: clamp."),
            ],
        ),
        Call(
            "flipped normals",
            "flip",
            DULL,
            flip,
            hint="If N·L < 0, the light falls on the other side, whose normal is -N.",
            mistakes=[
                Mistake(lambda d, I, N, L: d * I * max(N @ L, 0), "This clamps: surfaces that look away from the light are black. Here their normal is to be flipped."),
                Mistake(lambda d, I, N, L: d * I * (N @ L), "N·L is negative where the normal looks away: flip the normal there."),
                Mistake(lambda d, I, N, L: d * I * max(-(N @ L), 0), "The normal is flipped everywhere: only where it looks away from the light."),
                Mistake(lambda d, I, N, L: -d * I * (N @ L), "The normal is flipped everywhere: only where it looks away from the light."),
                Mistake(lambda d, I, N, L: d * I, "N·L is missing."),
            ],
        ),
        Call(
            "two-sided lighting",
            "two_sided",
            SIDES,
            two_sided,
            hint="The eye decides which side is seen, and with it the normal and the reflectance; then the light is clamped as ever.",
            mistakes=[
                Mistake(lambda f, b, I, N, L, V: two_sided(f, b, I, N, L, L), "Here the light decides which side is lit; it is the eye that decides which side is seen."),
                Mistake(lambda f, b, I, N, L, V: f * I * max(N @ L, 0), "The back is lit like the front: where the eye sees the back, N turns round and the reflectance is another one."),
                Mistake(lambda f, b, I, N, L, V: two_sided(f, f, I, N, L, V), "The back has a reflectance of its own."),
                Mistake(lambda f, b, I, N, L, V: two_sided(b, f, I, N, L, V), "Front and back are exchanged."),
                Mistake(lambda f, b, I, N, L, V: (f if N @ V >= 0 else b) * I * max(N @ L, 0), "The back needs -N: its light comes from the other side."),
                Mistake(lambda f, b, I, N, L, V: (f if N @ V >= 0 else b) * I * abs(N @ L), "The side that is seen is lit from behind, too: clamp after the normal was turned."),
                Mistake(lambda f, b, I, N, L, V: (f if N @ V >= 0 else b) * I * (N @ L) * (1 if N @ V >= 0 else -1), "Where the light is behind the side that is seen, the result is negative: clamp."),
                Mistake(lambda f, b, I, N, L, V: f * I * max(N @ L, 0) + b * I * max(-(N @ L), 0), "This does not ask where the eye is: the light decides."),
                Mistake(lambda f, b, I, N, L, V: f * I * max(N @ L, 0) if N @ V >= 0 else 0 * f, "The back is black: it has a reflectance and a normal of its own."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
