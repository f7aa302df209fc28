r"""A lamp with an area is replaced by many small ones. A piece of area $A$ at $\mathbf{y}$ with the normal $\mathbf{N}_y$ and the
radiance 1 gives the surface at $\mathbf{x}$ with the normal $\mathbf{N}$ the irradiance

$$ E = A\, \frac{\max(\mathbf{N} \cdot \mathbf{L}, 0)\, \max(\mathbf{N}_y \cdot (-\mathbf{L}), 0)}{d^2} $$

$\mathbf{L}$ is the unit vector from $\mathbf{x}$ to $\mathbf{y}$, $d$ their distance. The lamp is a parallelogram with a corner $C$ and the
edges $\mathbf{u}$ and $\mathbf{v}$; it shines to the side of $\mathbf{u} \times \mathbf{v}$ alone, whose length is its area. Write

- `grid(C, u, v, m)`: the middles of m x m equal pieces, (m², 3). Row $i m + j$ is the piece $i$ along $\mathbf{u}$ and $j$ along
  $\mathbf{v}$, from 0.
- `piece(x, N, y, N_y, A)`: $E$ of one piece, a number.
- `irradiance(x, N, C, u, v, m)`: $E$ of the lamp in m x m pieces, a number.
- `exact(x, N, corners)`: what the sum converges to, by Lambert's formula for a polygon that is wholly before the surface. The
  corners, (n, 3), go counterclockwise as seen from $\mathbf{x}$. $\gamma_k$ is the angle (radians) at $\mathbf{x}$ between corner $k$ and
  the next, the last one's next is the first, and $\mathbf{\Gamma}_k$ the unit vector along
  $(\mathbf{y}_{k+1} - \mathbf{x}) \times (\mathbf{y}_k - \mathbf{x})$:

$$ E = \frac{1}{2} \sum_k \gamma_k\, (\mathbf{N} \cdot \mathbf{\Gamma}_k) $$

- `RATIO`: by which factor does the error of the sum fall if `m` is doubled and is large already? A whole number.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, Value, unit_vectors

STARTER = '''\
import numpy as np

RATIO = 2


def grid(C, u, v, m):
    """The middles of m x m pieces of the lamp, (m * m, 3).  C: a corner.  u, v: edges."""
    return np.zeros((m * m, 3))


def piece(x, N, y, N_y, A):
    """The irradiance at x, whose unit normal is N, by a piece at y with the unit normal N_y and the area A."""
    return 0.0


def irradiance(x, N, C, u, v, m):
    """The irradiance at x by the whole lamp in m x m pieces."""
    return 0.0


def exact(x, N, corners):
    """The irradiance at x by a polygon, (n, 3)."""
    return 0.0
'''


def grid(C, u, v, m, offset=0.5):
    steps = (np.arange(m) + offset) / m
    return np.array([C + s * u + t * v for s in steps for t in steps])


def piece(x, N, y, N_y, A, power=2, zero=0.0):
    way = y - x
    d = np.linalg.norm(way)
    L = way / d
    return A * max(N @ L, zero) * max(-N_y @ L, zero) / d**power


def irradiance(x, N, C, u, v, m, points=grid, one=piece, share=True):
    across = np.cross(u, v)
    A = np.linalg.norm(across)
    return sum(
        one(x, N, y, across / A, A / m**2 if share else A) for y in points(C, u, v, m)
    )


def exact(x, N, corners, angle=np.arccos, scale=0.5, unit=True, closed=True):
    r = corners - x
    r = r / np.linalg.norm(r, axis=1, keepdims=True)
    following = np.roll(r, -1, axis=0)
    across = np.cross(following, r)
    if unit:
        across = across / np.linalg.norm(across, axis=1, keepdims=True)
    terms = angle(np.clip((r * following).sum(axis=1), -1, 1)) * (across @ N)
    return scale * (terms if closed else terms[:-1]).sum()


RNG = np.random.default_rng(22)
X, Z = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
Y = np.array([0.0, 1.0, 0.0])
GRIDS = [(np.zeros(3), X, Y, 1), (np.zeros(3), X, Y, 2)]
GRIDS += [(*RNG.uniform(-1, 1, (3, 3)), m) for m in (2, 3, 4, 5)]
PIECES, AWAY = (
    [(np.zeros(3), Z, 2 * Z, -Z, 1.0), (np.zeros(3), Z, Z + X, -Z, 1.0)],
    [(np.zeros(3), Z, -2 * Z, Z, 1.0)],
)
for N, N_y in zip(unit_vectors(40, 1), unit_vectors(40, 2)):
    x, y = RNG.uniform(-2, 2, (2, 3))
    before = N @ (y - x) > 0 and N_y @ (x - y) > 0
    (PIECES if before else AWAY).append((x, N, y, N_y, RNG.uniform(0.1, 2)))


def lamps(count, whole):
    """(x, N, C, u, v): parallelograms before the surface, wholly or partly, that shine at it."""
    cases = []
    while len(cases) < count:
        C, u, v, x = RNG.uniform(-2, 2, (4, 3))
        N = unit_vectors(1, len(cases) + RNG.integers(1000))[0]
        corners = np.array([C, C + u, C + u + v, C + v])
        before = (corners - x) @ N > 0.05
        facing = np.cross(u, v) @ (x - C) > 0.3
        if facing and (before.all() if whole else before.any() and not before.all()):
            cases.append((x, N, C, u, v))
    return cases


CEILING = (
    np.zeros(3),
    Z,
    np.array([-0.5, -0.5, 1.0]),
    Y,
    X,
)  # Y x X = -Z: it shines down
WHOLE = [(*CEILING, 1), (*CEILING, 4)] + [
    (*case, m) for case, m in zip(lamps(8, True), (1, 2, 3, 4, 5, 3, 2, 3))
]
PARTLY = [(*case, m) for case, m in zip(lamps(6, False), (3, 4, 5, 6, 3, 4))]
PARTLY += [
    (x, N, C, v, u, 3) for x, N, C, u, v in lamps(3, True)
]  # the lamp shines away
POLYGONS = [
    (x, N, np.array([C, C + u, C + u + v, C + v]))
    for x, N, C, u, v in [CEILING, *lamps(8, True)]
]
POLYGONS += [(x, N, corners[:3]) for x, N, corners in POLYGONS[1:5]]


def other(**changes):
    return lambda *arguments: irradiance(*arguments, **changes)


EXERCISE = Definition(
    title="An area light by many lights",
    lesson=26,
    starter=STARTER,
    parts=[
        Call(
            "points on the lamp",
            "grid",
            GRIDS,
            grid,
            hint="The middle of piece i of m lies at the share (i + a half) / m of an edge; the points begin at the corner.",
            mistakes=[
                Mistake(lambda C, u, v, m: grid(C, u, v, m, 0), "These are corners of the pieces; take their middles."),
                Mistake(lambda C, u, v, m: grid(C, u, v, m, 1), "These are the far corners of the pieces; take their middles."),
                Mistake(lambda C, u, v, m: np.array([C + s * u + t * v for s in np.linspace(0, 1, m) for t in np.linspace(0, 1, m)]), "These points go from edge to edge: those on an edge stand for half a piece only. Take the middles of m pieces."),
                Mistake(lambda C, u, v, m: grid(C, v, u, m), "The order is the other way round: v changes from row to row, u after m rows."),
                Mistake(lambda C, u, v, m: grid(0 * C, u, v, m), "The corner C is missing."),
                Mistake(lambda C, u, v, m: grid(C - (u + v) / 2, u, v, m), "C is a corner of the lamp, not its middle."),
                Mistake(lambda C, u, v, m: grid(C, u - C, v - C, m), "u and v are edges, vectors, not corners."),
            ],
        ),
        Call(
            "one piece",
            "piece",
            PIECES,
            piece,
            hint="Both cosines are of unit vectors, and the divisor is the square of the distance.",
            mistakes=[
                Mistake(lambda *a: piece(*a, power=0), "The distance does not count: is it missing in the divisor, or is L not of unit length?"),
                Mistake(lambda *a: piece(*a, power=1), "The light falls with the square of the distance."),
                Mistake(lambda *a: piece(*a, power=4), "The distance is squared twice: is the square of a square in the divisor?"),
                Mistake(lambda x, N, y, N_y, A: piece(x, N, y, N_y, 1), "The area A is missing."),
                Mistake(lambda x, N, y, N_y, A: A * (N @ (y - x)) / np.linalg.norm(y - x) ** 3, "The lamp's own cosine is missing: seen from the side the piece is smaller."),
                Mistake(lambda x, N, y, N_y, A: A * (N_y @ (x - y)) / np.linalg.norm(y - x) ** 3, "The cosine at the surface is missing."),
                Mistake(lambda x, N, y, N_y, A: piece(x, N, y, N_y, A) / np.pi, "Divided by π it is a form factor, a share of the light; the irradiance is asked for."),
                Mistake(lambda x, N, y, N_y, A: piece(x, N, y, -N_y, A), "The lamp shines to the side of its normal; from the lamp to the surface it is -L."),
                Mistake(lambda x, N, y, N_y, A: -piece(x, N, y, N_y, A), "The sign: at the lamp the direction is -L."),
            ],
        ),
        Call(
            "a piece that shines away, or behind the surface",
            "piece",
            AWAY,
            piece,
            hint="Both cosines have a maximum with 0 of their own.",
            mistakes=[
                Mistake(lambda *a: piece(*a, zero=-np.inf), "No maximum: where one cosine is negative light is taken away, and where both are it comes out of nothing."),
                Mistake(lambda *a: max(piece(*a, zero=-np.inf), 0), "The product of two negative cosines is positive: each of them needs a maximum of its own."),
                Mistake(lambda x, N, y, N_y, A: abs(piece(x, N, y, N_y, A, zero=-np.inf)), "The light shines through: use the maximum with 0, not the absolute value."),
                Mistake(lambda x, N, y, N_y, A: max(N @ (y - x), 0) * (N_y @ (x - y)) * A / np.linalg.norm(x - y) ** 4, "The lamp shines to one side alone: its own cosine needs a maximum with 0, too."),
                Mistake(lambda x, N, y, N_y, A: (N @ (y - x)) * max(N_y @ (x - y), 0) * A / np.linalg.norm(x - y) ** 4, "A surface that faces away gets no light: N·L needs a maximum with 0."),
                Mistake(lambda x, N, y, N_y, A: max(N @ (y - x), 0) * abs(N_y @ (x - y)) * A / np.linalg.norm(x - y) ** 4, "The lamp shines to one side alone."),
            ],
        ),
        Call(
            "the whole lamp",
            "irradiance",
            WHOLE,
            irradiance,
            hint="Add up all pieces; each has the m²-th part of the lamp's area, and u x v gives both area and normal.",
            mistakes=[
                Mistake(other(share=False), "Each piece has the area of the whole lamp: more pieces must not give more light."),
                Mistake(lambda x, N, C, u, v, m: irradiance(x, N, C, u, v, m) / m, "More pieces give less light: one factor m is too much in the divisor."),
                Mistake(lambda x, N, C, u, v, m: irradiance(x, N, C, u, v, m) * m, "The lamp is divided by m, but it has m² pieces."),
                Mistake(lambda x, N, C, u, v, m: irradiance(x, N, C, u, v, m) / m**2, "The share of a piece counts twice: take the sum, not the mean, if its area is divided already."),
                Mistake(lambda x, N, C, u, v, m: irradiance(x, N, C, u, v, 1), "This is one light in the middle of the lamp."),
                Mistake(lambda x, N, C, u, v, m: irradiance(x, N, C, v, u, m), "The lamp shines to the side of u x v, and this is v x u."),
                Mistake(lambda x, N, C, u, v, m: irradiance(x, N, C, u, v, m) / np.linalg.norm(np.cross(u, v)), "The area of the lamp is missing: it is the length of u x v."),
                Mistake(lambda x, N, C, u, v, m: irradiance(x, N, C, u, v, m) * np.linalg.norm(np.cross(u, v)), "u x v is not normalised: as a normal it must be a unit vector."),
                Mistake(lambda x, N, C, u, v, m: irradiance(x, N, C, u, v, m) / np.linalg.norm(np.cross(u, v)) * np.linalg.norm(u) * np.linalg.norm(v), "The area is that of a rectangle; a parallelogram's is the length of u x v."),
                Mistake(lambda x, N, C, u, v, m: exact(x, N, np.array([C, C + u, C + u + v, C + v])), "This is the value for infinitely many pieces; the sum of m x m is asked for."),
            ],
            points=2,
        ),
        Call(
            "a lamp that is partly behind the surface",
            "irradiance",
            PARTLY,
            irradiance,
            hint="Each piece is tested by itself: those behind the surface give nothing, and a lamp that shines away gives nothing at all.",
            mistakes=[
                Mistake(other(one=lambda *a: piece(*a, zero=-np.inf)), "Pieces behind the surface take light away: each one needs its own maximum."),
                Mistake(lambda *a: max(0, other(one=lambda *b: piece(*b, zero=-np.inf))(*a)), "The sum has a maximum with 0, but each piece needs its own."),
            ],
        ),
        Call(
            "Lambert's formula",
            "exact",
            POLYGONS,
            exact,
            hint="Go round the polygon: for each corner and the next one the angle between them at x, times the cosine between N and the normal of the plane through x and both.",
            mistakes=[
                Mistake(lambda *a: -exact(*a), "The sign: look at the order of the two vectors in the cross product."),
                Mistake(lambda *a: 2 * exact(*a), "The factor 1/2 is missing."),
                Mistake(lambda *a: exact(*a) / np.pi, "Divided by π it is a form factor; the irradiance is asked for."),
                Mistake(lambda *a: exact(*a, closed=False), "The last side is missing: the last corner's next is the first."),
                Mistake(lambda *a: exact(*a, unit=False), "The cross product is not normalised: Γ is a unit vector."),
                Mistake(lambda *a: exact(*a, angle=lambda cosine: cosine), "This is the cosine; the angle itself is asked for."),
                Mistake(lambda *a: exact(*a, angle=lambda cosine: np.degrees(np.arccos(cosine))), "The angles are in degrees, and radians are asked for."),
                Mistake(lambda x, N, corners: exact(0 * x, N, corners), "The corners are taken as vectors from the origin: subtract x."),
            ],
            points=2,
        ),
        Value(
            "how fast it converges",
            {"RATIO": 4},
            hint="Compute the difference to the exact value for m = 8, 16 and 32.",
            wrong={"RATIO": [(2, "Middles of the pieces are better than that: compute the difference to the exact value for m = 8, 16 and 32."),
                             (1, "The error does fall."),
                             (16, "Not so fast: compute the difference to the exact value for m = 8, 16 and 32."),
                             (0.25, "The factor by which it falls is asked for, a number above 1."),
                             (1.414, "That would be random points; a grid is better.")]},
        ),
    ],
)  # fmt: skip
