r"""Phong's highlight is the power of a cosine:

$$ I_s = I_L\, k_s\, \max(\mathbf{R} \cdot \mathbf{V},\, 0)^n $$

Write `highlight(N, L, V, n)`, the factor $\max(\mathbf{R} \cdot \mathbf{V}, 0)^n$, a number in $[0, 1]$. `N`, `L`, `V` are unit
vectors: the normal, towards the light, towards the eye; `n` is the shininess. Where the light is behind the surface,
$\mathbf{N} \cdot \mathbf{L} \le 0$, there is no highlight. Then write `half_angle(n)`: the angle $\varphi$ between $\mathbf{R}$ and
$\mathbf{V}$, in degrees, at which the highlight has fallen to a half.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def highlight(N, L, V, n):
    """Returns max(R.V, 0) to the power of n, a number; 0 where the light is behind the surface."""
    return 1.0


def half_angle(n):
    """Returns the angle between R and V, in degrees, at which the highlight is 0.5."""
    return 0.0
'''

UP = np.array([0.0, 0.0, 1.0])


def mirrored(N, L):
    return 2.0 * (N @ L) * N - L


def highlight(N, L, V, n):
    return float(max(mirrored(N, L) @ V, 0.0) ** n) if N @ L > 0 else 0.0


def half_angle(n):
    return float(np.degrees(np.arccos(0.5 ** (1.0 / n))))


def near(v, spread, seed):
    """Unit vectors near v, so that powers are not all 0."""
    w = v + spread * unit_vectors(len(v), seed)
    return w / np.linalg.norm(w, axis=1, keepdims=True)


N = unit_vectors(24, 1)
L = near(N, 0.7, 2)
R = np.array([mirrored(n, light) for n, light in zip(N, L, strict=True)])
V = near(R, 0.5, 3)
n = np.random.default_rng(4).uniform(1, 30, 24)
FRONT = [
    (UP, np.array([0.6, 0.0, 0.8]), np.array([-0.6, 0.0, 0.8]), 10.0),
    (UP, UP, np.array([0.6, 0.0, 0.8]), 2.0),
]
FRONT += [
    (N[k], L[k], V[k], float(n[k]))
    for k in range(24)
    if N[k] @ L[k] > 0 and R[k] @ V[k] > 0
]
AWAY = [(UP, np.array([0.8, 0.0, 0.6]), np.array([0.96, 0.0, 0.28]), 2.0)]  # R.V < 0
AWAY += [(N[k], L[k], -V[k], 4.0) for k in range(8)]
BEHIND = [(UP, np.array([0.6, 0.0, -0.8]), np.array([-0.6, 0.0, -0.8]), 4.0)]
BEHIND += [(-N[k], L[k], V[k], 3.0) for k in range(8)]
BEHIND += [(UP, np.array([1.0, 0.0, 0.0]), np.array([-0.6, 0.0, 0.8]), 4.0)]  # N.L = 0

EXERCISE = Definition(
    title="Phong's highlight",
    lesson=8,
    starter=STARTER,
    parts=[
        Call(
            "the highlight in front",
            "highlight",
            FRONT,
            highlight,
            hint="R is L mirrored at N; the highlight is the cosine of the angle between R and V, to the power of n.",
            mistakes=[
                Mistake(lambda N, L, V, n: (mirrored(N, L) @ V), "The exponent n is missing: the highlight is far too wide."),
                Mistake(lambda N, L, V, n: n * (mirrored(N, L) @ V), "n is an exponent, not a factor."),
                Mistake(lambda N, L, V, n: max(N @ (L + V) / np.linalg.norm(L + V), 0) ** n,
                        "This is N·H, Blinn's highlight; the exercise asks for R·V."),
                Mistake(lambda N, L, V, n: max(N @ V, 0) ** n, "This is N·V: the light is missing."),
                Mistake(lambda N, L, V, n: max(N @ L, 0) ** n, "This is N·L: a highlight moves with the eye."),
                Mistake(lambda N, L, V, n: max(L @ V, 0) ** n, "This is L·V: the light has to be mirrored at N first."),
                Mistake(lambda N, L, V, n: max(-(mirrored(N, L) @ V), 0) ** n, "R has the wrong sign: it points into the surface."),
                Mistake(lambda N, L, V, n: float((mirrored(N, L) @ V) * n > 0), "This is 1 wherever the eye is on the right side."),
                Mistake(lambda N, L, V, n: max(mirrored(N, L) @ V, 0) ** int(n), "n need not be a whole number."),
            ],
            points=2,
        ),
        Call(
            "eyes that look from elsewhere",
            "highlight",
            AWAY,
            highlight,
            hint="Where R·V < 0 the eye is on the wrong side: the highlight is 0.",
            mistakes=[
                Mistake(lambda N, L, V, n: abs(mirrored(N, L) @ V) ** n if N @ L > 0 else 0.0,
                        "An even power makes a negative cosine positive: take max(R·V, 0) before the power."),
            ],
        ),
        Call(
            "lights behind the surface",
            "highlight",
            BEHIND,
            highlight,
            hint="Where N·L <= 0 the light is behind the surface, and there is no highlight, whatever R·V is.",
            mistakes=[
                Mistake(lambda N, L, V, n: max(mirrored(N, L) @ V, 0) ** n,
                        "There is a highlight where the surface gets no light: test N·L."),
            ],
        ),
        Call(
            "its width",
            "half_angle",
            [(k,) for k in (1.0, 5.0, 20.0, 80.0, 128.0)],
            half_angle,
            hint="Solve cos(phi)^n = 0.5 for phi.",
            mistakes=[
                Mistake(lambda n: np.arccos(0.5 ** (1 / n)), "The angle is asked for in degrees."),
                Mistake(lambda n: np.degrees(np.arccos(0.5 / n)), "cos(phi)^n = 0.5 needs the n-th root, not a quotient."),
                Mistake(lambda n: 60.0 / n, "The angle falls with the root of n, not with n."),
                Mistake(lambda n: 0.5 ** (1 / n), "This is the cosine of the angle."),
            ],
        ),
    ],
)  # fmt: skip
