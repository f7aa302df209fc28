r"""A mirror sends the light from the direction $\mathbf{L}$ into the direction $\mathbf{R}$:

$$ \mathbf{S} = (\mathbf{N} \cdot \mathbf{L})\,\mathbf{N} - \mathbf{L}, \qquad \mathbf{R} = (\mathbf{N} \cdot \mathbf{L})\,\mathbf{N} + \mathbf{S} $$

Write `reflection(N, L)`, which returns $\mathbf{R}$, an array of three numbers. `N` is the unit normal, `L` the unit vector
from the surface towards the light. Write `mirror_ray(D, N)` with it: the direction in which a ray goes on that arrives
in the direction `D`, as a ray tracer needs it. `D` points *to* the surface, so it is not `L`.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def reflection(N, L):
    """Returns R, the direction of the mirrored light: three numbers."""
    return L


def mirror_ray(D, N):
    """Returns the direction in which a ray of the direction D goes on: three numbers."""
    return D
'''

UP = np.array([0.0, 0.0, 1.0])


def reflection(N, L):
    return 2.0 * (N @ L) * N - L


PAIRS = [(UP, np.array([0.6, 0.0, 0.8])), (UP, UP)]
PAIRS += list(zip(unit_vectors(20, 1), unit_vectors(20, 2), strict=True))

EXERCISE = Definition(
    title="The reflection vector",
    lesson=9,
    starter=STARTER,
    parts=[
        Call(
            "the mirrored light",
            "reflection",
            PAIRS,
            reflection,
            hint="R has the length of L and the same angle to N, on the other side.",
            mistakes=[
                Mistake(
                    lambda N, L: L - 2 * (N @ L) * N,
                    "This is -R: it points into the surface.",
                ),
                Mistake(
                    lambda N, L: (N @ L) * N - L,
                    "This is S alone; R is the projection of L on N, plus S.",
                ),
                Mistake(
                    lambda N, L: (N @ L) * N,
                    "This is the projection of L on N; S has to be added.",
                ),
                Mistake(
                    lambda N, L: (N @ L) * N + L,
                    "S is what leads from L to its projection on N, not L itself.",
                ),
                Mistake(
                    lambda N, L: -L,
                    "The light goes straight back: the part along N keeps its sign, the rest turns.",
                ),
                Mistake(
                    lambda N, L: 2 * (N @ L) * L - N,
                    "N and L are exchanged: this mirrors N at L.",
                ),
                Mistake(
                    lambda N, L: 2 * N - L,
                    "N has to be scaled by N·L before it is doubled.",
                ),
                Mistake(lambda N, L: L, "Nothing is mirrored yet."),
                Mistake(
                    lambda N, L: np.array([-L[0], -L[1], L[2]]),
                    "This is right for a surface that faces +z only.",
                ),
            ],
            points=2,
        ),
        Call(
            "a ray that goes on",
            "mirror_ray",
            [(-L, N) for N, L in PAIRS],
            lambda D, N: reflection(N, -D),
            hint="L is -D: L points away from the surface, D towards it.",
            mistakes=[
                Mistake(
                    lambda D, N: reflection(N, D),
                    "D points to the surface: L is -D, and this ray goes into the wall.",
                ),
                Mistake(lambda D, N: D, "The ray goes on as if there were no surface."),
                Mistake(lambda D, N: -D, "The ray goes back where it came from."),
                Mistake(
                    lambda D, N: reflection(D, N),
                    "The arguments are exchanged: D comes first here, then N.",
                ),
            ],
        ),
    ],
)
