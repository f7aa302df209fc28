r"""The form factor of a small patch $i$ and a small patch $j$ that see each other, as shares of the light that leaves $i$:

$$ F_{ij} \approx \frac{A_j \cos\theta_i \cos\theta_j}{\pi r^2} $$

$r$ is the distance between the patches' middles, $\theta_i$ the angle between the normal of $i$ and the line towards $j$,
$\theta_j$ the angle between the normal of $j$ and the line back.

Write `form_factor(x_i, N_i, x_j, N_j, A_j)` for small patches: `x_i`, `x_j` are the middles, `N_i`, `N_j` the unit normals, arrays
of three numbers. A patch that turns its back gets nothing. Then write `point_to_points(x_i, N_i, points, N_j, A_j)`: the same
for a large patch $j$, as the mean over an array of its points, (m, 3), each with its own distance and angles.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def form_factor(x_i, N_i, x_j, N_j, A_j):
    """Returns the share of the light leaving a small patch i that arrives at a small patch j."""
    return A_j


def point_to_points(x_i, N_i, points, N_j, A_j):
    """Returns the same for a large patch j: the mean over its points, an array (m, 3)."""
    return A_j
'''


def kernel(x_i, N_i, x_j, N_j, A_j, power=2, pi=np.pi, clamp=True, back=1.0, unit=True):
    d = x_j - x_i
    r = np.sqrt(d @ d)
    w = d / r if unit else d
    cos_i, cos_j = N_i @ w, -back * (N_j @ w)
    if clamp:
        cos_i, cos_j = max(cos_i, 0.0), max(cos_j, 0.0)
    return float(A_j * cos_i * cos_j / (pi * r**power))


def form_factor(*arguments):
    return kernel(*arguments)


def point_to_points(x_i, N_i, points, N_j, A_j):
    return float(np.mean([kernel(x_i, N_i, x, N_j, A_j) for x in points]))


RNG = np.random.default_rng(25)
UP, DOWN = np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -1.0])
SEEN = [
    (np.zeros(3), UP, np.array([0.0, 0.0, 2.0]), DOWN, 0.1),
    (np.zeros(3), UP, np.array([1.0, 0.0, 1.0]), DOWN, 0.2),
]
AWAY = [(np.zeros(3), DOWN, np.array([0.0, 0.0, 2.0]), DOWN, 0.1), (np.zeros(3), UP, np.array([0.0, 0.0, 2.0]), UP, 0.1),
        (np.zeros(3), DOWN, np.array([0.0, 0.0, 2.0]), UP, 0.1)]  # fmt: skip
for N_i, N_j, x in zip(
    unit_vectors(60, 1), unit_vectors(60, 2), RNG.uniform(-2, 2, (60, 3)), strict=True
):
    case = (RNG.uniform(-1, 1, 3), N_i, x, N_j, float(RNG.uniform(0.05, 0.3)))
    facing = kernel(*case) > 1e-3
    (
        SEEN
        if facing and len(SEEN) < 20
        else AWAY
        if not facing and len(AWAY) < 20
        else []
    ).append(case)


def square(side, height, m):
    steps = (np.arange(m) + 0.5) / m - 0.5
    return np.array([(side * u, side * v, height) for u in steps for v in steps])


LARGE = [
    (np.zeros(3), UP, square(side, height, 6), DOWN, side**2)
    for side, height in ((1.0, 1.0), (3.0, 0.5), (0.5, 2.0))
]
LARGE += [
    (np.array([0.4, -0.2, 0.1]), UP, square(4.0, 0.8, 8) - (2.5, 0, 0), DOWN, 16.0)
]

EXERCISE = Definition(
    title="The form factor of two patches",
    lesson=29,
    starter=STARTER,
    parts=[
        Call(
            "patches that face each other",
            "form_factor",
            SEEN,
            form_factor,
            hint="Divide the vector between the middles by its length, then take both cosines, and divide by pi r².",
            mistakes=[
                Mistake(lambda *a: kernel(*a, power=1), "The share falls with the square of the distance."),
                Mistake(lambda *a: kernel(*a, power=4), "r² appears once: the cosines need unit vectors, not the distance again."),
                Mistake(lambda *a: kernel(*a, unit=False), "The vector between the middles is not a unit vector: its dot products are no cosines."),
                Mistake(lambda *a: kernel(*a, pi=1.0), "pi is missing: a patch sends its light into a whole hemisphere."),
                Mistake(lambda *a: kernel(*a, pi=4 * np.pi), "4 pi is for a point light; a diffuse patch has pi."),
                Mistake(lambda a, n, b, m, A: kernel(a, n, b, m, A) / A, "A_j is missing: a larger patch gets more."),
                Mistake(lambda a, n, b, m, A: kernel(a, n, b, -(b - a) / np.linalg.norm(b - a), A), "The angle at the receiving patch is missing."),
                Mistake(lambda a, n, b, m, A: kernel(a, (b - a) / np.linalg.norm(b - a), b, m, A), "The angle at the sending patch is missing."),
                Mistake(lambda *a: kernel(*a, back=-1.0, clamp=False), "At patch j the line goes back to i: its cosine has the other sign."),
                Mistake(lambda *a: kernel(*a, back=-1.0), "At patch j the line goes back to i: its cosine has the other sign."),
            ],
            points=2,
        ),
        Call(
            "patches that turn their backs",
            "form_factor",
            AWAY,
            form_factor,
            hint="If one of the cosines is negative, a patch turns its back: the form factor is 0.",
            mistakes=[
                Mistake(lambda *a: kernel(*a, clamp=False), "A negative cosine is a back: two backs would even give a positive product. Test each."),
                Mistake(lambda *a: max(kernel(*a, clamp=False), 0.0), "Two backs give a positive product: test each cosine, not the product."),
                Mistake(lambda *a: abs(kernel(*a, clamp=False)), "Light does not leave through the back."),
            ],
        ),
        Call(
            "a large patch",
            "point_to_points",
            LARGE,
            point_to_points,
            hint="Take the mean of form_factor over the points of patch j, with the whole area A_j.",
            mistakes=[
                Mistake(lambda a, n, p, m, A: kernel(a, n, p.mean(axis=0), m, A), "This takes the middle of the patch; each point has its own distance and angles."),
                Mistake(lambda a, n, p, m, A: point_to_points(a, n, p, m, A) * len(p), "The sum over the points counts the area many times: take the mean."),
                Mistake(lambda a, n, p, m, A: kernel(a, n, p[0], m, A), "Only the first point counts."),
            ],
        ),
    ],
)  # fmt: skip
