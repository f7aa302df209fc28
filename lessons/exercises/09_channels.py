r"""Red, green and blue are computed apart, and several lights are added:

$$ I_c = I_{a,c}\, k_{a,c} + \sum_i I_{i,c}\, k_{d,c} \max(\mathbf{N} \cdot \mathbf{L}_i, 0), \qquad c \in \{r, g, b\} $$

Write `diffuse_color(k_a, k_d, I_a, lights, directions, N)`: the colour of a dull surface, three numbers, clamped to 1. `lights`
is an array of $m$ rows of three numbers, the intensities $I_i$ of the lights; `directions` has $m$ rows, the unit vectors
$\mathbf{L}_i$; `N` is the unit normal.

Then answer the lecture's questions, each as three numbers for red, green and blue: which colour has a **white** diffuse
object in the red light (1, 0, 0)? Which has a **green** one, (0, 1, 0)? Which colour has the **highlight** if the green
object is shiny and its highlight reflects all colours alike?
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, Value, unit_vectors

STARTER = '''\
import numpy as np

WHITE_IN_RED = (0, 0, 0)
GREEN_IN_RED = (0, 1, 0)
HIGHLIGHT = (0, 0, 0)


def diffuse_color(k_a, k_d, I_a, lights, directions, N):
    """Returns red, green and blue of a dull surface under several lights: three numbers in [0, 1]."""
    return k_d
'''


def parts(k_a, k_d, I_a, lights, directions, N):
    return I_a * k_a, lights * k_d * np.clip(directions @ N, 0, None)[:, None]


def diffuse_color(*arguments):
    ambient, terms = parts(*arguments)
    return np.clip(ambient + terms.sum(axis=0), 0, 1)


RNG = np.random.default_rng(9)


def case(lights, bright, seed):
    k_a, k_d, I_a = RNG.uniform(0, 1, (3, 3))
    scale = 2.5 if bright else 0.6 / lights
    return (
        0.3 * k_a,
        k_d,
        I_a,
        RNG.uniform(0, scale, (lights, 3)),
        unit_vectors(lights, seed),
        unit_vectors(1, seed + 50)[0],
    )


ONE = [case(1, False, k) for k in range(12)]
MANY = [case(3, False, 20 + k) for k in range(6)] + [
    case(8, False, 30 + k) for k in range(6)
]
BRIGHT = [case(4, True, 40 + k) for k in range(8)]


def with_one_light(which):
    return lambda k_a, k_d, I_a, lights, directions, N: np.clip(
        I_a * k_a + lights[which] * k_d * max(directions[which] @ N, 0), 0, 1
    )


EXERCISE = Definition(
    title="Lights and materials, channel by channel",
    lesson=12,
    starter=STARTER,
    parts=[
        Value(
            "the lecture's three questions",
            {"WHITE_IN_RED": (1, 0, 0), "GREEN_IN_RED": (0, 0, 0), "HIGHLIGHT": (1, 0, 0)},
            hint="Multiply light and reflectance channel by channel.",
            wrong={
                "WHITE_IN_RED": [((1, 1, 1), "White reflects what there is, and there is only red."),
                                 ((0, 0, 0), "White reflects all of the red light.")],
                "GREEN_IN_RED": [((0, 1, 0), "The object reflects green light, and there is none."),
                                 ((1, 1, 0), "Colours of light and surface are multiplied, not added."),
                                 ((0.5, 0.5, 0), "Colours of light and surface are multiplied, not mixed."),
                                 ((1, 0, 0), "A green surface reflects no red.")],
                "HIGHLIGHT": [((1, 1, 1), "The highlight is the light, reflected alike in all channels: and the light is red."),
                              ((0, 1, 0), "The highlight has a reflectance of its own, k_s, which is white here; the light is red."),
                              ((0, 0, 0), "The highlight has a reflectance of its own, k_s, which is white here.")],
            },
            points=2,
        ),
        Call(
            "one light",
            "diffuse_color",
            ONE,
            diffuse_color,
            hint="Each channel is I_a k_a + I k_d max(N·L, 0), with the channel's own numbers.",
            mistakes=[
                Mistake(lambda a, d, Ia, I, L, N: np.clip((I * d * np.clip(L @ N, 0, None)[:, None]).sum(axis=0), 0, 1), "The ambient term is missing."),
                Mistake(lambda a, d, Ia, I, L, N: np.clip(Ia * a + (I * d * (L @ N)[:, None]).sum(axis=0), 0, 1), "A light behind the surface takes light away: use max(N·L, 0) for each light."),
                Mistake(lambda a, d, Ia, I, L, N: np.clip(Ia * a + (I * d * abs(L @ N)[:, None]).sum(axis=0), 0, 1), "A light behind the surface shines through."),
                Mistake(lambda a, d, Ia, I, L, N: np.clip(Ia * a + (I * np.clip(L @ N, 0, None)[:, None]).sum(axis=0), 0, 1), "The reflectance k_d is missing."),
                Mistake(lambda a, d, Ia, I, L, N: np.clip(Ia * a + (d * np.clip(L @ N, 0, None)[:, None]).sum(axis=0), 0, 1), "The lights' intensities are missing."),
                Mistake(lambda a, d, Ia, I, L, N: np.clip(Ia * a + (I * a * np.clip(L @ N, 0, None)[:, None]).sum(axis=0), 0, 1), "The diffuse term has k_d, not k_a."),
                Mistake(lambda a, d, Ia, I, L, N: np.clip(Ia * a + (I.mean() * d * np.clip(L @ N, 0, None)[:, None]).sum(axis=0), 0, 1), "Each channel has its own intensity: no mean over the colours."),
            ],
        ),
        Call(
            "several lights",
            "diffuse_color",
            MANY,
            diffuse_color,
            hint="The contributions of all lights are added; the ambient term counts once.",
            mistakes=[
                Mistake(with_one_light(0), "Only the first light counts."),
                Mistake(with_one_light(-1), "Only the last light counts: add them up."),
                Mistake(lambda *a: np.clip(parts(*a)[0] + parts(*a)[1].mean(axis=0), 0, 1), "Lights are added, not averaged: two lamps are brighter than one."),
                Mistake(lambda *a: np.clip(len(a[3]) * parts(*a)[0] + parts(*a)[1].sum(axis=0), 0, 1), "The ambient glow counts once, not once for each light."),
                Mistake(lambda *a: np.clip(parts(*a)[0] + parts(*a)[1].max(axis=0), 0, 1), "Lights are added; this takes the brightest one."),
                Mistake(lambda a, d, Ia, I, L, N: np.clip(Ia * a + np.clip((I * d * (L @ N)[:, None]).sum(axis=0), 0, None), 0, 1), "The sum is clamped to 0, but each light's own N·L must be: a light behind the surface darkens the others."),
            ],
        ),
        Call(
            "bright lights",
            "diffuse_color",
            BRIGHT,
            diffuse_color,
            hint="Clamp the sum to 1.",
            mistakes=[
                Mistake(lambda *a: parts(*a)[0] + parts(*a)[1].sum(axis=0), "Some channels exceed 1: clamp the sum."),
                Mistake(lambda *a: parts(*a)[0] + np.clip(parts(*a)[1], 0, 1).sum(axis=0), "Each light is clamped, and their sum exceeds 1: clamp once, at the end."),
                Mistake(lambda *a: (parts(*a)[0] + parts(*a)[1].sum(axis=0)) / max((parts(*a)[0] + parts(*a)[1].sum(axis=0)).max(), 1), "This divides by the brightest channel; clamp each channel by itself."),
            ],
        ),
    ],
)  # fmt: skip
