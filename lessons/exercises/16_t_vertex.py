r"""A polygon that lacks a vertex on one of its edges, while its neighbour has it, makes a T. With $I$, the illumination equation at a vertex, Gouraud shading jumps at the vertex $M$ between $A$ and $B$ by

$$ I(M) - \big( (1 - t)\, I(A) + t\, I(B) \big), \qquad M = A + t\, (B - A) $$

Write `jump(A, B, M, I_A, I_B, I_M)`, three numbers, one a channel; `A`, `B`, `M` are points on a line, (3,).

The cure: the polygon gets the vertex. Write `fan(polygon)`: the triangles, (k - 2, 3), into which OpenGL cuts a polygon of $k$ vertices, `polygon` is a list of their numbers: a fan round the first vertex, in the polygon's sense of
rotation. Write `mended(P, polygon, m)`: the polygon with the vertex number `m` on the edge where it belongs, k + 1 numbers in the same sense, **beginning with** `m`, so that each triangle of its fan uses the new vertex. `P` are all points, (n, 3); the point
`m` lies on exactly one edge, between its ends.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake

STARTER = '''\
import numpy as np


def jump(A, B, M, I_A, I_B, I_M):
    """Returns how much brighter the side is that has the vertex M (3,).  A, B, M: points; I_A, I_B, I_M: colours."""
    return np.zeros(3)


def fan(polygon):
    """Returns the triangles (k - 2, 3) of a polygon, a list of k numbers of vertices."""
    return np.zeros((len(polygon) - 2, 3))


def mended(P, polygon, m):
    """Returns the k + 1 numbers of the polygon with the vertex m on its edge, beginning with m.  P: points (n, 3)."""
    return [m, *polygon]
'''


def place(A, B, M):
    return (M - A) @ (B - A) / ((B - A) @ (B - A))


def jump(A, B, M, I_A, I_B, I_M, t=None):
    t = place(A, B, M) if t is None else t
    return I_M - ((1 - t) * I_A + t * I_B)


def fan(polygon):
    p = list(polygon)
    return np.array([(p[0], p[k], p[k + 1]) for k in range(1, len(p) - 1)])


def edge(P, polygon, m):
    """The number k of the edge from vertex k to k + 1 on which the point m lies."""
    A = P[list(polygon)]
    B = np.roll(A, -1, axis=0)
    detour = np.linalg.norm(P[m] - A, axis=1) + np.linalg.norm(B - P[m], axis=1)
    return int(np.argmin(detour - np.linalg.norm(B - A, axis=1)))


def mended(P, polygon, m):
    k = edge(P, polygon, m) + 1
    return np.array([m, *polygon[k:], *polygon[:k]])


def inserted(P, polygon, m, wrap=False):
    """wrap: on the last edge the vertex is put in front, not at the end."""
    k = edge(P, polygon, m) + 1
    k = k % len(polygon) if wrap else k
    return np.array([*polygon[:k], m, *polygon[k:]])


def on_first_line(P, polygon, m):
    """The vertex inserted into the first edge on whose line it lies, though it may be beyond its ends."""
    for k in range(len(polygon)):
        A, B = P[polygon[k]], P[polygon[(k + 1) % len(polygon)]]
        if np.linalg.norm(np.cross(B - A, P[m] - A)) < 1e-9:
            return np.array([m, *polygon[k + 1 :], *polygon[: k + 1]])
    return np.array(polygon)


def nearest(P, polygon, m):
    """The vertex inserted after the nearest one, whichever edge that is."""
    k = int(np.argmin(np.linalg.norm(P[list(polygon)] - P[m], axis=1))) + 1
    return np.array([m, *polygon[k:], *polygon[:k]])


RNG = np.random.default_rng(16)
SEAMS = [
    (np.array([0.0, -1.0, 0.0]), np.array([0.0, 1.0, 0.0]), np.zeros(3),
     np.array([0.4, 0.4, 0.4]), np.array([0.2, 0.3, 0.4]), np.array([1.0, 0.8, 0.6]))
]  # fmt: skip
for t in RNG.uniform(0.1, 0.9, 12):
    A, B = RNG.uniform(-2, 2, (2, 3))
    SEAMS.append((A, B, A + t * (B - A), *RNG.uniform(0, 1, (3, 3))))
FANS = [([0, 1, 2, 3],), ([4, 2, 7],)]
FANS += [(RNG.permutation(20)[:k].tolist(),) for k in (4, 5, 6, 8)]


def wall(k, which, seed):
    """A convex polygon of k points in space, numbered at random, with a further point on the edge ``which``."""
    rng = np.random.default_rng(seed)
    turn = (np.arange(k) + rng.uniform(-0.3, 0.3, k)) * 2 * np.pi / k
    ring = np.stack([3 * np.cos(turn), np.sin(turn), 0.2 * np.cos(turn)], axis=1)
    A, B = ring[which], ring[(which + 1) % k]
    points = np.concatenate([ring, [A + rng.uniform(0.15, 0.85) * (B - A)]])
    number = rng.permutation(k + 1)
    P = np.zeros((k + 1, 3))
    P[number] = points
    return P, number[:k].tolist(), int(number[k])


SQUARE = np.array([[-1.0, -1, 0], [0.0, -1, 0], [0.0, 1, 0], [-1.0, 1, 0], [0.0, 0, 0]])
TWICE = 0.5 * np.array(  # two edges on one line: mended once already
    [[-1.0, -1, 0], [0, -1, 0], [0, -0.3, 0], [0, 1, 0], [-1, 1, 0], [0, 0.5, 0]]
)
WALLS = [(SQUARE, [0, 1, 2, 3], 4), (TWICE, [0, 1, 2, 3, 4], 5)]
WALLS += [wall(k, which, 10 * k + which) for k in (3, 4, 5, 6) for which in range(k)]

EXERCISE = Definition(
    title="Mend the T-vertex",
    lesson=20,
    starter=STARTER,
    parts=[
        Call(
            "the jump at the seam",
            "jump",
            SEAMS,
            jump,
            hint="One side shows I_M, the other what is interpolated between I_A and I_B at the place of M.",
            mistakes=[
                Mistake(lambda *a: jump(*a, t=0.5), "M is not always midway: where it lies between A and B has to count."),
                Mistake(lambda *a: -jump(*a), "The sign is the other way round: how much brighter is the side that has M?"),
                Mistake(lambda *a: abs(jump(*a)), "The jump may be negative: where M is darker."),
                Mistake(lambda *a: jump(*a, t=1 - place(*a[:3])), "A and B are exchanged: near A the colour is nearly I_A."),
                Mistake(lambda A, B, M, a, b, m: m - a - b, "I_A and I_B are added: their weighted mean is what the other side shows."),
                Mistake(lambda A, B, M, a, b, m: jump(A, B, M, a, b, m, t=np.linalg.norm(M - A)), "The distance from A has to be taken as a share of the whole edge."),
                Mistake(lambda A, B, M, a, b, m: a + place(A, B, M) * (b - a), "This is what the side without M shows; the jump is the difference."),
            ],
        ),
        Call(
            "the fan",
            "fan",
            FANS,
            fan,
            hint="Each triangle has the polygon's first vertex and two neighbours.",
            mistakes=[
                Mistake(lambda p: np.array([p[k : k + 3] for k in range(len(p) - 2)]), "This is a strip of three neighbours each; in a fan all triangles share the first vertex."),
                Mistake(lambda p: fan(p)[:, [0, 2, 1]], "The triangles go round the wrong way: they would be back faces."),
                Mistake(lambda p: np.array([(p[-1], p[k], p[k + 1]) for k in range(len(p) - 2)]), "The fan goes round the last vertex; OpenGL's goes round the first."),
                Mistake(lambda p: fan(range(len(p))), "These are places in the list; the numbers of the vertices are asked for."),
                Mistake(lambda p: fan(p)[::-1], "The triangles come in the reverse order: begin with the first three vertices."),
                Mistake(lambda p: np.roll(fan(p), -1, axis=1), "These are the right triangles, but let each begin with the fan's vertex."),
            ],
        ),
        Call(
            "the mended polygon",
            "mended",
            WALLS,
            mended,
            hint="Look for the edge on which the point lies, go on from there round the polygon, and begin with the new vertex.",
            mistakes=[
                Mistake(inserted, "The vertex is in the right place, but the polygon does not begin with it: the fan round another vertex may hardly use it."),
                Mistake(lambda *a: inserted(*a, wrap=True), "The vertex is in the right place, but the polygon does not begin with it: the fan round another vertex may hardly use it."),
                Mistake(lambda P, p, m: np.array([m, *p]), "The vertex was put before the first one, whichever edge it is on: the polygon crosses itself."),
                Mistake(lambda P, p, m: np.array([*p, m]), "The vertex was put at the end, whichever edge it is on: the polygon crosses itself."),
                Mistake(lambda P, p, m: np.array([m, *mended(P, p, m)[:0:-1]]), "The polygon goes round the wrong way now: it would be a back face."),
                Mistake(on_first_line, "The point lies on the line of this edge, but beyond its ends: two edges may lie on one line. Test that it is between them, too."),
                Mistake(nearest, "The vertex was put after the nearest one; it may lie on the edge before that. Look for the edge."),
                Mistake(lambda P, p, m: np.array([m, *np.roll(mended(P, p, m)[1:], 1)]), "The polygon goes on one vertex too early: after the new vertex comes the end of its edge."),
                Mistake(lambda P, p, m: np.array([m, *np.roll(mended(P, p, m)[1:], -1)]), "The polygon goes on one vertex too late: after the new vertex comes the end of its edge."),
                Mistake(lambda P, p, m: np.roll(mended(P, p, m), 1), "The polygon begins with the vertex before the new one: one triangle of the fan is the edge itself, without area."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
