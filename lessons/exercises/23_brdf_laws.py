r"""A BRDF $f(\mathbf{L}, \mathbf{V})$, in 1/sr, says how much of the light from $\mathbf{L}$ leaves towards $\mathbf{V}$. Two laws of
physics can be checked:

$$ f(\mathbf{L}, \mathbf{V}) = f(\mathbf{V}, \mathbf{L}), \qquad
\int_0^{2\pi} \int_0^{\pi/2} f(\mathbf{L}, \mathbf{V}) \cos\theta \, \sin\theta \; d\theta \, d\varphi \le 1 $$

The integral is the **albedo**; $\theta$ is the angle between $\mathbf{N}$ and $\mathbf{V}$, $\varphi$ the angle around $\mathbf{N}$. Answer two
questions and write three functions:

- `ALBEDO`: the albedo of the surface with $f = 0.5$ in all directions. `LARGEST`: the largest constant $f$ that the second law
  allows.
- `breach(f)`: how far a BRDF is from reciprocity: the largest difference, without sign, between its two sides, a number. `f` is
  an (n, n) array: row $i$, column $j$ has the value for light from direction $i$ and the eye in direction $j$.
- `albedo(f)`: the integral, a number. `f` is an (a, b) array of values for one $\mathbf{L}$, in the middles of a x b equal cells:
  $\theta$ goes from 0 to $\pi/2$ with the rows, $\varphi$ from 0 to $2\pi$ with the columns. Each value holds for its cell.
- `phong(N, L, V, k_s, n)`: the normalised lobe $k_s \frac{n + 2}{2 \pi} (\mathbf{R} \cdot \mathbf{V})^n$, a number, 0 where light or
  eye is behind the surface. `N`, `L`, `V` are unit vectors; $\mathbf{R}$ is $\mathbf{L}$ mirrored at $\mathbf{N}$.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, Value, unit_vectors
from glsim.shading import NormalizedPhong
from glsim.shading.terms import power, reflection

STARTER = '''\
import numpy as np

ALBEDO = 0.5
LARGEST = 1


def breach(f):
    """The largest difference between f(L, V) and f(V, L), a number.  f: (n, n)."""
    return 0.0


def albedo(f):
    """The share of the light that leaves, a number.  f: (a, b), rows are cells of theta, columns of phi."""
    return 1.0


def phong(N, L, V, k_s, n):
    """The normalised Phong lobe in 1/sr, a number."""
    return k_s
'''


def breach(f):
    return np.abs(f - f.T).max()


def middles(f):
    """The polar angles of the rows of a table, (a, 1)."""
    return ((np.arange(len(f)) + 0.5) * np.pi / 2 / len(f))[:, None]


def albedo(f, weight=lambda t: np.cos(t) * np.sin(t), solid=np.pi**2):
    """solid: the area of all cells in theta and phi."""
    return (f * weight(middles(f))).mean() * solid


def phong(N, L, V, k_s, n):
    return float(NormalizedPhong(k_s, n).evaluate(N, L, V)[..., 0])


def lobe(N, L, V, k_s, n, scale=lambda n: (n + 2) / (2 * np.pi)):
    """Wrong lobes: with another factor, or without the tests."""
    return float(k_s * scale(n) * power(reflection(N, L) @ V, n))


def seen(formula):
    return lambda N, L, V, k_s, n: (
        formula(N, L, V, k_s, n) if N @ L > 0 and N @ V > 0 else 0.0
    )


RNG = np.random.default_rng(23)
SYMMETRIC = [
    (np.array([[1.0, 2.0], [2.0, 5.0]]),),
    (np.array([[0.2, 0.5], [0.1, 0.3]]),),
]
TABLES = SYMMETRIC + [(RNG.uniform(0, 2, (n, n)),) for n in (2, 3, 4, 4, 5, 6, 8)]
TABLES += [
    (np.array([[1.0, 0.2], [0.9, 1.0]]),)
]  # the largest difference is below the diagonal
CELLS = [(np.full((9, 4), 1 / np.pi),)] + [
    (RNG.uniform(0, 1, shape),)
    for shape in ((2, 3), (3, 8), (4, 4), (6, 12), (10, 5), (1, 6))
]


def facing(count, seed):
    """N, L, V with the light and the eye before the surface, and the eye near the mirror direction."""
    rng = np.random.default_rng(seed)
    for N, L, off in zip(
        unit_vectors(count, seed),
        unit_vectors(count, seed + 1),
        unit_vectors(count, seed + 2),
    ):
        L = L if N @ L > 0 else -L
        V = reflection(N, L) + 0.5 * off
        V = V if N @ V > 0 else V - 2 * (N @ V) * N
        yield (
            N,
            L,
            V / np.linalg.norm(V),
            rng.uniform(0.1, 1),
            float(rng.integers(2, 20)),
        )


UP = np.array([0.0, 0.0, 1.0])
LOBES = [(UP, UP, UP, 1.0, 10.0), *facing(16, 40)]
AWAY = [(N, -L, V, k, n) for N, L, V, k, n in facing(4, 50)]
AWAY += [
    (N, L - 2 * (N @ L) * N, V - 2 * (N @ V) * N, k, n)
    for N, L, V, k, n in facing(4, 60)
]  # both behind
AWAY += [
    (UP, np.array([0.8, 0.0, 0.6]), np.array([-0.96, 0.0, -0.28]), 1.0, 3.0)
]  # the eye just behind
AWAY += [
    (UP, np.array([0.96, 0.0, -0.28]), np.array([-0.8, 0.0, 0.6]), 1.0, 3.0)
]  # the light just behind
AWAY += [
    (UP, np.array([0.8, 0.0, 0.6]), np.array([0.96, 0.0, 0.28]), 1.0, 3.0)
]  # R.V < 0, both before it

EXERCISE = Definition(
    title="Energy and reciprocity of a BRDF",
    lesson=27,
    starter=STARTER,
    parts=[
        Value(
            "the same in all directions",
            {"ALBEDO": np.pi / 2, "LARGEST": 1 / np.pi},
            hint="The integral of cos times sin over the hemisphere is π.",
            wrong={
                "ALBEDO": [(0.5, "The integral of the cosine over the hemisphere is not 1."),
                           (np.pi, "This is the integral of 2 f; f is 0.5."),
                           (1.0, "An albedo can be more than 1, where a BRDF breaks the law; compute the integral."),
                           (0.5 / np.pi, "Multiply by π: f = k_d / π has the albedo k_d.")],
                "LARGEST": [(1.0, "f is no share: its unit is 1/sr, and the light leaves into a whole hemisphere."),
                            (np.pi, "It is the other way round: π times the largest f is 1."),
                            (1 / (2 * np.pi), "The hemisphere has the solid angle 2 π, but the cosine halves it.")],
            },
        ),
        Call(
            "reciprocity",
            "breach",
            TABLES,
            breach,
            hint="Exchanging light and eye is exchanging rows and columns.",
            mistakes=[
                Mistake(lambda f: (f - f.T).sum(), "Differences of both signs cancel in a sum."),
                Mistake(lambda f: np.abs(f - f.T).mean(), "The largest difference is asked for, not the mean."),
                Mistake(lambda f: np.abs(f - f.T).sum(), "The largest difference is asked for, not their sum."),
                Mistake(lambda f: np.abs(np.triu(f - f.T)).sum(), "The largest difference is asked for, not their sum."),
                Mistake(lambda f: max(0, np.triu(f - f.T).max()), "A difference below 0 counts as well: take it without its sign."),
                Mistake(lambda f: f.max() - f.min(), "f may well change with the direction; compare each value with the one for exchanged directions."),
                Mistake(lambda f: np.abs(f - f[::-1, ::-1]).max(), "The table is turned round; exchange its rows and columns."),
                Mistake(lambda f: np.abs(f - f[::-1]).max(), "The rows are reversed; exchange rows and columns."),
                Mistake(lambda f: (np.abs(f - f.T) / np.maximum(f, f.T)).max(), "The difference itself is asked for, not relative to f."),
                Mistake(lambda f: ((f - f.T) ** 2).max(), "The difference itself is asked for, not its square."),
            ],
        ),
        Call(
            "energy",
            "albedo",
            CELLS,
            albedo,
            hint="Add up f cos θ sin θ of all cells, times the size of a cell in both angles; θ is that of the middle of its cell.",
            mistakes=[
                Mistake(lambda f: albedo(f, np.cos), "sin θ is missing: near the normal a cell covers less of the hemisphere."),
                Mistake(lambda f: albedo(f, np.sin), "cos θ is missing: what leaves at a low angle comes from a foreshortened surface."),
                Mistake(lambda f: albedo(f, lambda t: 1.0 + 0 * t), "cos θ and sin θ are missing."),
                Mistake(lambda f: albedo(f, lambda t: np.cos(t) ** 2), "There is one cosine and one sine."),
                Mistake(lambda f: albedo(f, solid=1.0), "This is a mean over the cells; the integral has the size of a cell in both angles."),
                Mistake(lambda f: albedo(f) / np.pi**2 * f.size, "The size of a cell is missing: dθ dφ."),
                Mistake(lambda f: albedo(f, solid=2 * np.pi**2), "The rows cover a right angle, from 0 to π/2: dθ is too large."),
                Mistake(lambda f: albedo(f, solid=np.pi**2 / 2), "The columns go round once, from 0 to 2 π: dφ is too small."),
                Mistake(lambda f: albedo(f, solid=90.0 * 360.0), "Angles of a cell in degrees: the integral has radians."),
                Mistake(lambda f: albedo(f) / np.pi, "There is no π to divide by: f = k_d / π has it already."),
                Mistake(lambda f: albedo(f, lambda t: np.cos(t - np.pi / 4 / len(f)) * np.sin(t - np.pi / 4 / len(f))), "θ is that of the beginning of a cell; take its middle."),
                Mistake(lambda f: albedo(f, lambda t: np.cos(t + np.pi / 4 / len(f)) * np.sin(t + np.pi / 4 / len(f))), "θ is that of the end of a cell; take its middle."),
                Mistake(lambda f: f.mean() * np.pi, "The mean of f times π: cells near the normal and near the horizon count less than those between."),
            ],
            points=2,
        ),
        Call(
            "the normalised lobe",
            "phong",
            LOBES,
            phong,
            hint="Compute the mirror direction of L, then the power, then the factor in front of it.",
            mistakes=[
                Mistake(lambda *a: lobe(*a, scale=lambda n: 1.0), "The factor that normalises is missing."),
                Mistake(lambda *a: lobe(*a, scale=lambda n: (n + 2) / 2 * np.pi), "2 π belongs below the fraction bar."),
                Mistake(lambda *a: lobe(*a, scale=lambda n: (n + 2) / np.pi), "It is 2 π that stands below the fraction bar."),
                Mistake(lambda *a: lobe(*a, scale=lambda n: (n + 1) / (2 * np.pi)), "n + 1 normalises the density of directions; with the cosine of the second law it is n + 2."),
                Mistake(lambda N, L, V, k_s, n: lobe(N, L, V, k_s, n) / (N @ L), "Divided by N·L it is the lecture's lobe, which is not reciprocal."),
                Mistake(lambda N, L, V, k_s, n: lobe(N, L, V, k_s, n) * (N @ L), "N·L belongs to the sum over the lights, not to f."),
                Mistake(lambda N, L, V, k_s, n: lobe(N, L, V, 1, n), "k_s is missing."),
                Mistake(lambda N, L, V, k_s, n: lobe(N, -L, V, k_s, n), "R points into the surface: look at its sign."),
                Mistake(lambda N, L, V, k_s, n: k_s * (n + 2) / (2 * np.pi) * max(L @ V, 0) ** n, "This is L·V: mirror L first."),
                Mistake(lambda N, L, V, k_s, n: k_s * (n + 2) / (2 * np.pi) * max(N @ (L + V) / np.linalg.norm(L + V), 0) ** n, "This is N·H; the lobe is one of R·V."),
            ],
            points=2,
        ),
        Call(
            "behind the surface",
            "phong",
            AWAY,
            phong,
            hint="f is 0 where N·L or N·V is not positive, and where R·V is negative.",
            mistakes=[
                Mistake(lobe, "Light or eye are behind the surface: test N·L and N·V."),
                Mistake(lambda N, L, V, k_s, n: lobe(N, L, V, k_s, n) if N @ L > 0 else 0, "The eye may be behind the surface: test N·V, too."),
                Mistake(lambda N, L, V, k_s, n: lobe(N, L, V, k_s, n) if N @ V > 0 else 0, "The light may be behind the surface: test N·L, too."),
                Mistake(seen(lambda N, L, V, k_s, n: k_s * (n + 2) / (2 * np.pi) * (reflection(N, L) @ V) ** n), "R·V is negative, and an odd power of it, too: use max(R·V, 0)."),
                Mistake(lambda N, L, V, k_s, n: k_s * (n + 2) / (2 * np.pi) * (reflection(N, L) @ V) ** n, "Nothing is tested: N·L, N·V and R·V may all be negative."),
            ],
        ),
    ],
)  # fmt: skip
