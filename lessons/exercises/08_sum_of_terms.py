r"""The lecture's whole equation for one light, in each channel:

$$ I = I_a\, k_a + I_L\, k_d \max(\mathbf{N} \cdot \mathbf{L}, 0) + I_L\, k_s \max(\mathbf{R} \cdot \mathbf{V}, 0)^n $$

Write `illuminate(k_a, k_d, k_s, n, I_a, I_L, N, L, V)`, which returns $I$ for red, green and blue, clamped to $[0, 1]$ at
the end. `k_a`, `k_d`, `k_s`, the ambient glow `I_a` and the light's intensity `I_L` are arrays of three numbers, `n` is a
number. Where $\mathbf{N} \cdot \mathbf{L} \le 0$ only the glow is left.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def illuminate(k_a, k_d, k_s, n, I_a, I_L, N, L, V):
    """Returns the intensity of red, green and blue: three numbers in [0, 1]."""
    return I_L * k_d
'''


def terms(k_a, k_d, k_s, n, I_a, I_L, N, L, V):
    cosine = N @ L
    R = 2 * cosine * N - L
    if cosine <= 0:
        return I_a * k_a, 0 * k_d, 0 * k_s
    return I_a * k_a, I_L * k_d * cosine, I_L * k_s * max(R @ V, 0.0) ** n


def illuminate(*arguments):
    return np.clip(sum(terms(*arguments)), 0, 1)


def unclamped(*arguments):
    return sum(terms(*arguments))


RNG = np.random.default_rng(8)


def case(seed, bright):
    N = unit_vectors(1, seed)[0]
    w = N + 0.7 * unit_vectors(1, seed + 100)[0]
    L = w / np.linalg.norm(w)
    w = 2 * (N @ L) * N - L + 0.4 * unit_vectors(1, seed + 200)[0]
    V = w / np.linalg.norm(w)
    k_a, k_d, k_s, I_a, I_L = RNG.uniform(0.05, 0.5 if not bright else 1.0, (5, 3))
    return (
        k_a,
        k_d,
        k_s,
        float(RNG.uniform(2, 12)),
        I_a,
        I_L * (3.0 if bright else 1.0),
        N,
        L,
        V,
    )


DARK = [case(k, False) for k in range(16)]
BRIGHT = [case(k, True) for k in range(16, 32)]
BEHIND = [(*DARK[k][:6], -DARK[k][6], *DARK[k][7:]) for k in range(8)]
BEHIND += [
    (
        *DARK[0][:6],
        np.array([0.0, 0.0, 1.0]),
        np.array([1.0, 0.0, 0.0]),
        np.array([-0.6, 0.0, 0.8]),
    )
]  # N.L = 0


def aside(L, seed):
    """An eye beside the light, where R.V is negative, for N = (0, 0, 1)."""
    w = L + 0.2 * unit_vectors(1, seed)[0]
    return w / np.linalg.norm(w)


LOW = [np.array([np.cos(t) * 0.9, np.sin(t) * 0.9, 0.19**0.5]) for t in range(8)]
ASIDE = [
    (
        *DARK[k][:3],
        float(2 + k % 4),
        *DARK[k][4:6],
        np.array([0.0, 0.0, 1.0]),
        L,
        aside(L, 300 + k),
    )
    for k, L in enumerate(LOW)
]


def with_power(power):
    """The sum with another power of R.V."""
    return lambda k_a, k_d, k_s, n, I_a, I_L, N, L, V: np.clip(
        I_a * k_a
        + I_L * k_d * (N @ L)
        + I_L * k_s * power((2 * (N @ L) * N - L) @ V, n),
        0,
        1,
    )


def with_clamped_terms(*arguments):
    return sum(np.clip(term, 0, 1) for term in terms(*arguments))


EXERCISE = Definition(
    title="The sum of all terms",
    lesson=11,
    starter=STARTER,
    parts=[
        Call(
            "the sum of the three terms",
            "illuminate",
            DARK,
            illuminate,
            hint="Ambient, diffuse and specular term are added, each with its own reflectance.",
            mistakes=[
                Mistake(lambda *a: sum(terms(*a)[1:]), "The ambient glow I_a k_a is missing."),
                Mistake(lambda *a: sum(terms(*a)[:2]), "The highlight is missing."),
                Mistake(lambda *a: terms(*a)[0] + terms(*a)[2], "The diffuse term is missing."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: unclamped(a, a, s, n, Ia, IL, N, L, V),
                        "The diffuse term has k_d, not k_a: that is the slide's slip."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: unclamped(a, s, d, n, Ia, IL, N, L, V), "k_d and k_s are exchanged."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: Ia * a * (N @ L) + sum(terms(a, d, s, n, Ia, IL, N, L, V)[1:]),
                        "The glow comes from everywhere: it has no N·L."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: IL * a + sum(terms(a, d, s, n, Ia, IL, N, L, V)[1:]),
                        "The ambient term has an intensity of its own, I_a."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: sum(terms(a, d, s, n, Ia, IL, N, L, V)[:2])
                        + IL * s * max(N @ (L + V) / np.linalg.norm(L + V), 0) ** n, "This is Blinn's highlight; here it is (R·V)^n."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: sum(terms(a, d, s, n, Ia, IL, N, L, V)[:2])
                        + IL * d * max((2 * (N @ L) * N - L) @ V, 0) ** n, "The highlight has a reflectance of its own, k_s."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: Ia * a + IL * d * (N @ L)
                        + IL * s * max((2 * (N @ L) * N - L) @ V, 0) ** n * (N @ L), "The highlight has no N·L."),
            ],
            points=3,
        ),
        Call(
            "bright light",
            "illuminate",
            BRIGHT,
            illuminate,
            hint="A channel cannot be brighter than 1: clamp the sum.",
            mistakes=[
                Mistake(unclamped, "Some channels exceed 1, and a screen cannot show that: clamp the sum."),
                Mistake(with_clamped_terms, "Each term is clamped, and their sum exceeds 1: clamp once, at the end."),
                Mistake(lambda *a: unclamped(*a) / max(unclamped(*a).max(), 1.0),
                        "This scales all channels by the brightest. The exercise asks to clamp each channel by itself."),
            ],
        ),
        Call(
            "far from the mirror direction",
            "illuminate",
            ASIDE,
            illuminate,
            hint="Where the angle between R and V is more than 90 degrees there is no highlight.",
            mistakes=[
                Mistake(with_power(lambda cosine, n: cosine**n),
                        "R·V is negative here, and its power is not 0: an even power even makes a second highlight."),
                Mistake(with_power(lambda cosine, n: abs(cosine) ** n), "There is a second highlight on the side of the light: R·V is negative there."),
            ],
        ),
        Call(
            "light from behind",
            "illuminate",
            BEHIND,
            illuminate,
            hint="Where N·L <= 0 the light adds nothing, but the glow stays.",
            mistakes=[
                Mistake(lambda *a: 0 * a[0], "The whole sum became 0. Clamp the light's own terms: the glow stays."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: np.clip(Ia * a + IL * d * (N @ L), 0, 1),
                        "N·L is negative here and takes away from the glow: no light is less than none."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: np.clip(Ia * a + IL * d * abs(N @ L), 0, 1),
                        "The light shines through the surface."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: np.clip(Ia * a + IL * s * max((2 * (N @ L) * N - L) @ V, 0) ** n, 0, 1),
                        "There is a highlight where the surface gets no light."),
                Mistake(lambda a, d, s, n, Ia, IL, N, L, V: np.clip(Ia * a + IL * d * (N @ L) + IL * s * max((2 * (N @ L) * N - L) @ V, 0) ** n, 0, 1),
                        "Both terms of the light must be 0 here: N·L is negative, and R·V may be positive all the same."),
            ],
        ),
    ],
)  # fmt: skip
