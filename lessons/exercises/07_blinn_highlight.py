r"""Blinn's highlight needs no mirror direction, but the vector halfway between the light and the eye:

$$ \mathbf{H} = \frac{\mathbf{L} + \mathbf{V}}{|\mathbf{L} + \mathbf{V}|}, \qquad I_s = I_L\, k_s\, (\mathbf{N} \cdot \mathbf{H})^n $$

Write `halfway(L, V)`, the unit vector $\mathbf{H}$, and `highlight(N, L, V, n)`, the factor $\max(\mathbf{N} \cdot \mathbf{H}, 0)^n$,
0 where the light is behind the surface. `N`, `L`, `V` are unit vectors: the normal, towards the light, towards the eye.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def halfway(L, V):
    """Returns the unit vector halfway between L and V: three numbers."""
    return L


def highlight(N, L, V, n):
    """Returns max(N.H, 0) to the power of n, a number; 0 where the light is behind the surface."""
    return 0.0
'''

UP = np.array([0.0, 0.0, 1.0])


def halfway(L, V):
    return (L + V) / np.linalg.norm(L + V)


def highlight(N, L, V, n):
    return float(max(N @ halfway(L, V), 0.0) ** n) if N @ L > 0 else 0.0


def towards(N, spread, seed):
    w = N + spread * unit_vectors(len(N), seed)
    return w / np.linalg.norm(w, axis=1, keepdims=True)


N = unit_vectors(24, 11)
L, V = towards(N, 0.8, 12), towards(N, 0.8, 13)
n = np.random.default_rng(14).uniform(1, 40, 24)
FRONT = [(UP, np.array([0.6, 0.0, 0.8]), np.array([0.0, 0.6, 0.8]), 10.0)]
FRONT += [(N[k], L[k], V[k], float(n[k])) for k in range(24) if N[k] @ L[k] > 0]
BEHIND = [(UP, np.array([0.6, 0.0, -0.8]), np.array([0.0, 0.28, 0.96]), 4.0)]
BEHIND += [(-N[k], L[k], -towards(N, 0.3, 15)[k], 3.0) for k in range(8)]

# the eye so far behind the surface that H is behind it, too
UNDER = [
    (
        UP,
        np.array([0.8 * np.cos(t), 0.8 * np.sin(t), 0.6]),
        np.array([0.28 * np.sin(t), 0.28 * np.cos(t), -0.96]),
        float(2 + t % 4),
    )
    for t in range(8)
]

EXERCISE = Definition(
    title="Blinn's highlight",
    lesson=10,
    starter=STARTER,
    parts=[
        Call(
            "the halfway vector",
            "halfway",
            [(UP, np.array([0.6, 0.0, 0.8])), *zip(L, V, strict=True)],
            halfway,
            hint="H has the length 1 and the same angle to L and to V.",
            mistakes=[
                Mistake(lambda L, V: L + V, "H must be a unit vector: divide the sum by its length."),
                Mistake(lambda L, V: (L + V) / 2, "Half the sum is shorter than a unit vector: divide by its length instead."),
                Mistake(lambda L, V: (L - V) / np.linalg.norm(L - V), "The difference leads from V to L; H lies between them."),
                Mistake(lambda L, V: (L + V) / np.sum(L + V), "The length of a vector is the root of the sum of its squares."),
                Mistake(lambda L, V: (L + V) / ((L + V) @ (L + V)), "This divides by the square of the length: take its root."),
                Mistake(lambda L, V: np.cross(L, V), "The cross product stands at a right angle to both."),
            ],
        ),
        Call(
            "the highlight",
            "highlight",
            FRONT,
            highlight,
            hint="The highlight is the cosine of the angle between N and H, to the power of n.",
            mistakes=[
                Mistake(lambda N, L, V, n: max((2 * (N @ L) * N - L) @ V, 0) ** n,
                        "Your highlight is where R·V would put it; the exercise asks for N·H."),
                Mistake(lambda N, L, V, n: (V @ halfway(L, V)) ** n, "This is H·V, the slide's slip: it does not depend on the surface."),
                Mistake(lambda N, L, V, n: (L @ halfway(L, V)) ** n, "This is H·L: it does not depend on the surface."),
                Mistake(lambda N, L, V, n: N @ halfway(L, V), "The exponent n is missing: the highlight is far too wide."),
                Mistake(lambda N, L, V, n: max(N @ (L + V), 0) ** n, "H is not normalised: the highlight is much too strong."),
                Mistake(lambda N, L, V, n: max(N @ (L + V) / 2, 0) ** n, "H is too short: the highlight is too weak."),
                Mistake(lambda N, L, V, n: n * (N @ halfway(L, V)), "n is an exponent, not a factor."),
                Mistake(lambda N, L, V, n: max(N @ halfway(L, V), 0) ** (4 * n), "The exponent is n itself, not 4 n."),
                Mistake(lambda N, L, V, n: max(N @ L, 0) ** n, "The eye is missing: a highlight moves with it."),
            ],
            points=2,
        ),
        Call(
            "H behind the surface",
            "highlight",
            UNDER,
            highlight,
            hint="Where N·H is negative there is no highlight.",
            mistakes=[
                Mistake(lambda N, L, V, n: (N @ halfway(L, V)) ** n, "N·H is negative here, and its power is not 0."),
                Mistake(lambda N, L, V, n: abs(N @ halfway(L, V)) ** n, "N·H is negative here: the absolute value makes a highlight of it."),
            ],
        ),
        Call(
            "lights behind the surface",
            "highlight",
            BEHIND,
            highlight,
            hint="Where N·L <= 0 the light is behind the surface, and there is no highlight.",
            mistakes=[
                Mistake(lambda N, L, V, n: max(N @ halfway(L, V), 0) ** n,
                        "There is a highlight where the surface gets no light: N·H may be positive all the same. Test N·L."),
                Mistake(lambda N, L, V, n: abs(N @ halfway(L, V)) ** n, "The light shines through the surface: test N·L."),
            ],
        ),
    ],
)  # fmt: skip
