r"""The shadow of a point on a plane lies on the line from the light through the point. With homogeneous coordinates that is a
4 x 4 matrix. For the plane $\mathbf{p} = (a, b, c, d)$, on which $a x + b y + c z + d = 0$, and the light $\mathbf{l} = (x, y, z, w)$
it is

$$ M = (\mathbf{p} \cdot \mathbf{l})\, \mathbf{1} - \mathbf{l}\, \mathbf{p}^\mathsf{T} $$

$\mathbf{1}$ is the unit matrix; $w = 1$ is a lamp at a place, $w = 0$ a directional light towards which $(x, y, z)$ points; all dot
products have four terms. Write

- `shadow_matrix(plane, light)`: $M$, (4, 4), for columns: the shadow of $\mathbf{v}$ is $M \mathbf{v}$.
- `shadow(plane, light, v)`: the point on the plane, three numbers, that is the shadow of the point `v`, three numbers.
- `sixteen(M)`: the sixteen numbers of a matrix in the order in which `glMultMatrixf` takes them.
- `casts(plane, light, v)`: 1 if the point `v` really has a shadow on the plane: it is on the same side of the plane as the light,
  and a lamp is not nearer to the plane than it. Else 0: the matrix would then draw a false shadow.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def shadow_matrix(plane, light):
    """The matrix of the shadow, (4, 4).  plane: a, b, c, d.  light: x, y, z, w."""
    return np.eye(4)


def shadow(plane, light, v):
    """The shadow of a point v on the plane: three numbers."""
    return v


def sixteen(M):
    """The numbers of M, (4, 4), in glMultMatrixf's order: 16 numbers."""
    return np.zeros(16)


def casts(plane, light, v):
    """1 if v has a shadow on the plane, 0 if not."""
    return 1
'''


def shadow_matrix(plane, light):
    return (plane @ light) * np.eye(4) - np.outer(light, plane)


def point(v):
    return np.array([*v, 1.0])


def shadow(plane, light, v, M=shadow_matrix):
    x, y, z, w = M(plane, light) @ point(v)
    return np.array([x, y, z]) / w


def casts(plane, light, v):
    mine, its = plane @ point(v), plane @ light
    return int(mine * its > 0 and (light[3] == 0 or abs(mine) < abs(its)))


RNG = np.random.default_rng(18)
FLOOR = np.array([0.0, 1.0, 0.0, 0.0])


def planes(count, seed):
    """Planes (a, b, c, d) whose normals are no unit vectors."""
    rng = np.random.default_rng(seed)
    for N in unit_vectors(count, seed):
        yield np.array([*N, rng.uniform(-2, 2)]) * rng.uniform(0.5, 2)


def above(plane, height):
    """A random point at a height above a plane."""
    N = plane[:3] / np.linalg.norm(plane[:3])
    aside = RNG.uniform(-2, 2, 3)
    return aside + (height - (plane @ point(aside)) / np.linalg.norm(plane[:3])) * N


def lamps(count, seed):
    """(plane, light, point): a lamp at a place, and a point between it and the plane."""
    for plane in planes(count, seed):
        high = RNG.uniform(3, 6)
        yield (
            plane,
            point(above(plane, high)),
            above(plane, high * RNG.uniform(0.1, 0.8)),
        )


def suns(count, seed):
    for plane in planes(count, seed):
        N = plane[:3] / np.linalg.norm(plane[:3])
        aside = RNG.normal(size=3)
        yield (
            plane,
            np.array([*(2 * N + aside - (aside @ N) * N), 0.0]),
            above(plane, RNG.uniform(0.5, 3)),
        )


LAMP, SUN = np.array([0.0, 4.0, 0.0, 1.0]), np.array([1.0, 2.0, 0.0, 0.0])
WITH_LAMPS = [(FLOOR, LAMP, np.array([1.0, 2.0, 0.0])), *lamps(12, 1)]
WITH_SUNS = [(FLOOR, SUN, np.array([1.0, 2.0, 0.0])), *suns(12, 2)]
LOW = [(p, light, above(p, -9.0)) for p, light, _ in lamps(4, 9)]
NEAR = [
    (p, light, above(p, height))
    for height in (0.02, -0.02)
    for p, light, _ in lamps(4, 10)
]
BELOW = [(p, light, above(p, -1.5)) for p, light, _ in [*lamps(4, 3), *suns(4, 4)]]
OTHER_SIDE = [(-p, light, v) for p, light, v in [*lamps(4, 5), *suns(4, 6)]]
BEYOND = [(FLOOR, LAMP, np.array([1.0, 5.0, 0.0]))]
BEYOND += [(p, light, above(p, 7.0)) for p, light, _ in lamps(5, 7)]
BEYOND += [(-p, light, v) for p, light, v in BEYOND]
HIGH = [(p, light, above(p, 9.0)) for p, light, _ in suns(5, 8)]


MATRIX_MISTAKES = [
    Mistake(lambda p, l: shadow_matrix(p, l).T, "The matrix is transposed: l p^T has a row for each number of the light and a column for each of the plane."),
    Mistake(lambda p, l: -shadow_matrix(p, l), "All signs are turned. The shadow is the same, but its w is negative, and OpenGL clips it away."),
    Mistake(lambda p, l: shadow_matrix(p, l) / (p @ l), "The matrix is divided by p·l. The shadow is the same; the matrix of the formula is asked for."),
    Mistake(lambda p, l: (p @ l) * np.eye(4) + np.outer(l, p), "The second part must be subtracted: a point on the plane has p·v = 0 and stays where it is, all others move."),
    Mistake(lambda p, l: -np.outer(l, p), "The first part, (p·l) times the unit matrix, is missing."),
    Mistake(lambda p, l: (p @ l) - np.outer(l, p), "p·l is subtracted from everywhere: the unit matrix has it on the diagonal alone."),
    Mistake(lambda p, l: np.eye(4) - np.outer(l, p), "The factor p·l of the unit matrix is missing."),
    Mistake(lambda p, l: (p[:3] @ l[:3]) * np.eye(4) - np.outer(l, p), "The dot product p·l has four terms here: d w counts too."),
    Mistake(lambda p, l: shadow_matrix(np.array([*p[:3], 0]), l), "The plane's fourth number is lost: this plane goes through the origin."),
    Mistake(lambda p, l: shadow_matrix(np.array([*p[:3], -p[3]]), l), "The sign of d: the plane is a x + b y + c z + d = 0."),
    Mistake(lambda p, l: shadow_matrix(p, np.array([*l[:3], 1])), "The light's fourth number is taken for 1: a directional light is no lamp."),
    Mistake(lambda p, l: shadow_matrix(p, np.array([*l[:3], 0])), "The light's fourth number is taken for 0: a lamp has a place."),
    Mistake(lambda p, l: shadow_matrix(p / np.linalg.norm(p[:3]), l), "The plane is normalised; the shadow is the same, but the matrix of the formula has the plane as it is."),
    Mistake(lambda p, l: (p @ l) * np.eye(4) - p * l, "l p^T is a matrix, of each number of the light with each of the plane; this is the product number by number."),
]  # fmt: skip
SHADOW_MISTAKES = [
    Mistake(lambda p, l, v: v, "This is the point itself."),
    Mistake(lambda p, l, v: (shadow_matrix(p, l) @ point(v))[:3], "The result is homogeneous: divide by its fourth number."),
    Mistake(lambda p, l, v: shadow_matrix(p, l)[:3, :3] @ v, "A point has a fourth coordinate, 1, and the result is to be divided by its own."),
    Mistake(lambda p, l, v: (lambda s: s[:3] / s[3])(shadow_matrix(p, l) @ np.array([*v, 0])), "A point has the fourth coordinate 1; 0 is a direction."),
    Mistake(lambda p, l, v: (lambda s: s[:3] / s[3])(point(v) @ shadow_matrix(p, l)), "The matrix is for columns: M v, not v M."),
    Mistake(lambda p, l, v: v - (p @ point(v)) / (p[:3] @ p[:3]) * p[:3], "This goes straight down to the plane; the shadow lies on the line from the light through the point."),
    Mistake(lambda p, l, v: shadow(p, np.array([*l[:3], 1.0]), v), "The light's fourth number is taken for 1: a directional light is no lamp."),
    Mistake(lambda p, l, v: shadow(p, np.array([*l[:3], 0.0]), v), "The light's fourth number is taken for 0: a lamp has a place."),
    Mistake(lambda p, l, v: shadow(np.array([*p[:3], -p[3]]), l, v), "The sign of d: the plane is a x + b y + c z + d = 0."),
    Mistake(lambda p, l, v: shadow(np.array([*p[:3], 0]), l, v), "The plane's fourth number is lost: this plane goes through the origin."),
]  # fmt: skip
CAST_MISTAKES = [
    Mistake(lambda p, l, v: 1, "Not everything casts a shadow: what is on the other side of the plane does not."),
    Mistake(lambda p, l, v: 0, "Nothing casts a shadow here."),
    Mistake(lambda p, l, v: 1 - casts(p, l, v), "Yes and no are exchanged."),
    Mistake(lambda p, l, v: int((p @ point(v)) * (p @ l) > 0), "What is farther from the plane than the lamp has no shadow on it: the line from the lamp goes up."),
    Mistake(lambda p, l, v: int((p @ point(v)) * (p @ l) > 0 and abs(p @ point(v)) < abs(p @ l)), "A directional light has no place: nothing is beyond it, however high."),
    Mistake(lambda p, l, v: int(p @ point(v) > 0 and p @ l > 0 and (l[3] == 0 or p @ point(v) < p @ l)), "The plane may look either way: what counts is that the point and the light are on the same side."),
    Mistake(lambda p, l, v: int(l[3] == 0 or abs(p @ point(v)) < abs(p @ l)), "What is on the other side of the plane casts no shadow on it: look at the signs, too."),
    Mistake(lambda p, l, v: int((p @ [*v, 0]) * (p @ l) > 0 and (l[3] == 0 or abs(p @ [*v, 0]) < abs(p @ l))), "d is missing for the point: its fourth coordinate is 1."),
    Mistake(lambda p, l, v: int((p @ point(v)) * (p @ l) > 0 and (l[3] == 0 or abs(p @ point(v)) > abs(p @ l))), "The comparison is the other way round: the point must be nearer to the plane than the lamp."),
]  # fmt: skip

EXERCISE = Definition(
    title="The planar shadow matrix",
    lesson=22,
    starter=STARTER,
    parts=[
        Call("the matrix for a lamp", "shadow_matrix", [case[:2] for case in WITH_LAMPS], shadow_matrix,
             hint="The dot product of plane and light on the diagonal, minus the product of each number of the light (rows) with each of the plane (columns).",
             mistakes=MATRIX_MISTAKES, points=2),
        Call("the matrix for a directional light", "shadow_matrix", [case[:2] for case in WITH_SUNS], shadow_matrix,
             hint="The same formula holds; the light's fourth number is 0.", mistakes=MATRIX_MISTAKES),
        Call("the shadow of a point under a lamp", "shadow", WITH_LAMPS, shadow,
             hint="Multiply the matrix and the point, which has a fourth coordinate.", mistakes=SHADOW_MISTAKES),
        Call("the shadow of a point in the sun", "shadow", WITH_SUNS, shadow,
             hint="All lines to a directional light have the same direction.", mistakes=SHADOW_MISTAKES),
        Call(
            "OpenGL's order",
            "sixteen",
            [(np.arange(1.0, 17.0).reshape(4, 4),), *((RNG.uniform(-1, 1, (4, 4)),) for _ in range(3))],
            lambda M: M.T.ravel(),
            hint="OpenGL takes a matrix column by column.",
            mistakes=[Mistake(lambda M: M.ravel(), "This is row by row; OpenGL takes the matrix column by column.")],
        ),
        Call("what casts a shadow", "casts", WITH_LAMPS[:6] + WITH_SUNS[:6] + BELOW + LOW + NEAR + OTHER_SIDE, casts,
             hint="p·v tells by its sign on which side of the plane a point is.", mistakes=CAST_MISTAKES),
        Call("beyond the lamp", "casts", BEYOND + WITH_LAMPS[:4] + HIGH + BELOW + LOW + OTHER_SIDE, casts,
             hint="A lamp lights the plane downwards: what is higher than it has no shadow there.", mistakes=CAST_MISTAKES),
    ],
)  # fmt: skip
