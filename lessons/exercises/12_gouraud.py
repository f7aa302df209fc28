r"""Gouraud shading evaluates the illumination equation at the vertices and interpolates the colours:

$$ C = w_1 C_1 + w_2 C_2 + w_3 C_3, \qquad w_1 + w_2 + w_3 = 1 $$

$C_k$ is the intensity $I$ at vertex $k$, **clamped** to $[0, 1]$ there. The weight $w_k$ of a point $P$ is the area of the triangle that $P$ makes with
the two other vertices, as a share of the whole triangle's; it is negative if $P$ lies beyond the edge between these two.

Write `weights(P, triangle)`: the three weights of the point `P`, (2,), in a triangle of three points, (3, 2). Write
`gouraud(P, triangle, I)`: the colour at `P`, where `I`, (3, 3), has a row of red, green and blue for each vertex, not clamped yet. And write
`picture(triangle, I, width, height)`, an array (height, width, 3): the pixel in row $r$ and column $c$ has the colour of its centre $(c + 0.5,\, r + 0.5)$,
or black if the centre is outside.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake

STARTER = '''\
import numpy as np


def weights(P, triangle):
    """Returns the weights of P (2,) for the three vertices (3, 2)."""
    return np.ones(3) / 3


def gouraud(P, triangle, I):
    """Returns red, green and blue at P.  I: intensities at the vertices (3, 3), one row a vertex, not clamped."""
    return np.zeros(3)


def picture(triangle, I, width, height):
    """Returns the triangle's picture (height, width, 3), black outside."""
    return np.zeros((height, width, 3))
'''


def weights(P, triangle):
    A, B, C = triangle
    return np.linalg.solve(np.array([B - A, C - A]).T, P - A) @ [
        [-1, 1, 0],
        [-1, 0, 1],
    ] + [1, 0, 0]


def gouraud(P, triangle, I):
    return weights(P, triangle) @ np.clip(I, 0, 1)


def unclamped(P, triangle, I):
    return weights(P, triangle) @ I


def by_distance(P, triangle):
    near = 1 / np.linalg.norm(triangle - P, axis=1)
    return near / near.sum()


def picture(triangle, I, width, height, offset=0.5, color=gouraud, outside=False):
    image = np.zeros((height, width, 3))
    for row in range(height):
        for column in range(width):
            P = np.array([column + offset, row + offset])
            if outside or weights(P, triangle).min() >= 0:
                image[row, column] = color(P, triangle, I)
    return image


RNG = np.random.default_rng(12)
CORNERS = np.array([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])
TRIANGLES = [CORNERS]
while len(TRIANGLES) < 16:
    T = RNG.uniform(-3, 3, (3, 2))
    u, v = T[1:] - T[0]
    if u[0] * v[1] - u[1] * v[0] > 2:
        TRIANGLES.append(T)
TRIANGLES[3:6] = [T[::-1] for T in TRIANGLES[3:6]]  # clockwise ones, too
INSIDE = [(np.array([1.0, 2.0]), CORNERS), (np.array([0.0, 0.0]), CORNERS)]
INSIDE += [(RNG.dirichlet((1, 1, 1)) @ T, T) for T in TRIANGLES]
OUTSIDE = [(np.array([3.0, 3.0]), CORNERS)]
OUTSIDE += [(np.array((1.5, 0.4, -0.9)) @ T, T) for T in TRIANGLES]
DIM = [(P, T, RNG.uniform(0, 1, (3, 3))) for P, T in INSIDE]
BRIGHT = [(P, T, RNG.uniform(0, 1, (3, 3)) * [[3], [1], [2]]) for P, T in INSIDE]
PICTURES = [
    (np.array([[1.213, 1.117], [12.731, 3.319], [4.127, 8.611]]), np.eye(3), 14, 10),
    (np.array([[3.413, 11.817], [8.131, -2.313], [0.719, 2.237]]), 1.5 * np.eye(3)[::-1] + 0.1, 9, 12),
]  # fmt: skip
for _ in range(2):
    T = RNG.uniform(-2, 18, (2, 2))
    PICTURES.append(
        (np.array([(2.317, 2.923), *T]), RNG.uniform(0, 1.6, (3, 3)), 16, 12)
    )

EXERCISE = Definition(
    title="Gouraud shading by hand",
    lesson=15,
    starter=STARTER,
    parts=[
        Call(
            "the weights of points inside",
            "weights",
            INSIDE,
            weights,
            hint="The weight of a vertex is 1 at that vertex and 0 on the edge opposite to it; the three sum to 1.",
            mistakes=[
                Mistake(lambda P, T: np.ones(3) / 3, "All points get the mean of the vertices: the place in the triangle has to count."),
                Mistake(lambda P, T: np.roll(weights(P, T), 1), "The weights belong to other vertices: that of vertex 1 is the area opposite to it, between P and vertices 2 and 3."),
                Mistake(lambda P, T: np.roll(weights(P, T), -1), "The weights belong to other vertices: that of vertex 1 is the area opposite to it, between P and vertices 2 and 3."),
                Mistake(lambda P, T: weights(P, T)[[0, 2, 1]], "The weights of vertices 2 and 3 are exchanged."),
                Mistake(lambda P, T: weights(P, T)[::-1], "The weights of vertices 1 and 3 are exchanged."),
                Mistake(by_distance, "These are weights by distance. They are not 0 on the opposite edge: use areas."),
                Mistake(lambda P, T: weights(P, T) * abs(np.linalg.det(np.c_[T, np.ones(3)])) / 2, "These are the areas themselves: divide by the whole triangle's, so that they sum to 1."),
                Mistake(lambda P, T: weights(P, T) * abs(np.linalg.det(np.c_[T, np.ones(3)])), "These are twice the areas: divide by the whole triangle's, so that they sum to 1."),
                Mistake(lambda P, T: weights(P, T) / 2, "The weights sum to one half: an area was halved in one place and not in the other."),
                Mistake(lambda P, T: weights(P, T) * 2, "The weights sum to 2: an area was halved in one place and not in the other."),
                Mistake(lambda P, T: weights(P, T) * np.sign(np.linalg.det(np.c_[T, np.ones(3)])), "The signs are wrong for triangles whose vertices go round clockwise: divide by the whole area with its sign."),
            ],
        ),
        Call(
            "the weights of points outside",
            "weights",
            OUTSIDE,
            weights,
            hint="Beyond an edge the area, and so the weight, is negative; the sum is 1 all the same.",
            mistakes=[
                Mistake(lambda P, T: abs(weights(P, T)), "These areas have lost their signs: how would one see that P is outside?"),
                Mistake(lambda P, T: abs(weights(P, T)) / abs(weights(P, T)).sum(), "These areas have lost their signs: how would one see that P is outside?"),
                Mistake(lambda P, T: np.clip(weights(P, T), 0, 1), "The weights are clamped: beyond an edge one of them is negative, and others may exceed 1."),
                Mistake(lambda P, T: np.zeros(3), "Outside the weights are not 0: they still sum to 1, and one or two of them are negative."),
            ],
        ),
        Call(
            "colours below 1",
            "gouraud",
            DIM,
            gouraud,
            hint="The colour is the weighted sum of the three vertices' colours, for each channel.",
            mistakes=[
                Mistake(lambda P, T, I: I @ weights(P, T), "The matrix of intensities is used by columns: a row belongs to a vertex, a column to a channel."),
                Mistake(lambda P, T, I: I.mean(axis=0), "This is the mean of the three colours, the same at all points."),
                Mistake(lambda P, T, I: I[np.argmax(weights(P, T))], "This takes the colour of the nearest vertex: interpolate."),
                Mistake(lambda P, T, I: I[2], "This is flat shading: the colour of the last vertex."),
                Mistake(lambda P, T, I: I.sum(axis=0), "The weights are missing."),
            ],
        ),
        Call(
            "bright vertices",
            "gouraud",
            BRIGHT,
            gouraud,
            hint="Clamp the intensities at the vertices to [0, 1], then interpolate.",
            mistakes=[
                Mistake(unclamped, "Intensities above 1 are interpolated: OpenGL clamps at each vertex first."),
                Mistake(lambda *a: np.clip(unclamped(*a), 0, 1), "The pixel is clamped, but the vertices must be, before the interpolation: the bright vertex spreads too far."),
                Mistake(lambda P, T, I: weights(P, T) @ (I / np.maximum(I.max(axis=1, keepdims=True), 1)), "This scales a bright vertex by its brightest channel: clamp each channel by itself."),
                Mistake(lambda P, T, I: weights(P, T) @ (I / max(I.max(), 1)), "This divides by the brightest channel of all: clamp each channel by itself."),
            ],
        ),
        Call(
            "the picture",
            "picture",
            PICTURES,
            picture,
            hint="For each pixel take its centre; if all three weights are at least 0, it is inside.",
            mistakes=[
                Mistake(lambda *a: picture(*a, offset=0.0), "The colours are those of the pixels' corners: the centre is half a pixel further, in both directions."),
                Mistake(lambda *a: picture(*a, outside=True), "Pixels outside the triangle are painted, too: there one of the weights is negative."),
                Mistake(lambda *a: picture(*a)[::-1], "The picture stands on its head: row 0 is the one with y = 0.5."),
                Mistake(lambda *a: picture(*a)[:, ::-1], "Left and right are exchanged."),
                Mistake(lambda *a: picture(*a, color=unclamped), "The vertices' intensities are not clamped."),
                Mistake(lambda *a: picture(*a, color=lambda P, T, I: np.clip(I[2], 0, 1)), "This is flat shading: the whole triangle has the last vertex's colour."),
                Mistake(lambda T, I, w, h: np.array([[gouraud(np.array([c + 0.5, r + 0.5]), T, I) if (weights(np.array([r + 0.5, c + 0.5]), T) >= 0).all() else np.zeros(3) for c in range(w)] for r in range(h)]),
                        "x and y are exchanged: the column is x, the row is y."),
                Mistake(lambda T, I, w, h: picture(T[:, ::-1], I, w, h), "x and y are exchanged: the column is x, the row is y."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
