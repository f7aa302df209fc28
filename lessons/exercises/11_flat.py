r"""Flat shading evaluates the illumination equation at one vertex of each polygon, the **provoking vertex**, and paints the whole
polygon with the result. OpenGL's rule: it is the last vertex of a triangle or quad, alone or in a strip or fan, and the first of a `GL_POLYGON`.

Write `provoking(primitive, n)`: the numbers of the provoking vertices, one for each polygon, in the order in which the polygons are drawn. `n`
vertices are sent, numbered from 0. `primitive` is a string: `"GL_TRIANGLES"`, `"GL_TRIANGLE_STRIP"`, `"GL_TRIANGLE_FAN"`, `"GL_QUADS"`, `"GL_QUAD_STRIP"` or
`"GL_POLYGON"`. Vertices that complete no polygon draw nothing.

Write `flat(P, N, k_d, I_L, light)`: the colour of one triangle of `GL_TRIANGLES` with the corners `P` and the unit normals `N`, (3, 3) each, a row for each
vertex, lit by a point light at `light`: $I_L\, k_d \max(\mathbf{N} \cdot \mathbf{L}, 0)$, clamped to 1.

Write `strip(P, colors, width, height)`, the picture (height, width, 3) of a `GL_TRIANGLE_STRIP` under `GL_FLAT`: `P` are points on the screen, (n, 2), `colors` the
vertices' colours, (n, 3). The pixel in row $r$ and column $c$ is painted if its centre $(c + 0.5,\, r + 0.5)$ is inside; what no triangle covers is black. Later
triangles paint over earlier ones.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def provoking(primitive, n):
    """Returns the numbers (from 0) of the provoking vertices of a primitive of n vertices, one for each polygon."""
    return [0]


def flat(P, N, k_d, I_L, light):
    """Returns the colour of a triangle.  P, N: corners and normals (3, 3); k_d, I_L: (3,); light: its position (3,)."""
    return np.zeros(3)


def strip(P, colors, width, height):
    """Returns the picture (height, width, 3) of a GL_TRIANGLE_STRIP.  P: (n, 2); colors: (n, 3)."""
    return np.zeros((height, width, 3))
'''

# numbers of the polygons' vertices: how many polygons n vertices make, and the vertices of polygon k
POLYGONS = {
    "GL_TRIANGLES": (lambda n: n // 3, lambda k, n: (3 * k, 3 * k + 1, 3 * k + 2)),
    "GL_TRIANGLE_STRIP": (lambda n: max(n - 2, 0), lambda k, n: (k, k + 1, k + 2)),
    "GL_TRIANGLE_FAN": (lambda n: max(n - 2, 0), lambda k, n: (0, k + 1, k + 2)),
    "GL_QUADS": (lambda n: n // 4, lambda k, n: tuple(range(4 * k, 4 * k + 4))),
    "GL_QUAD_STRIP": (
        lambda n: max(n // 2 - 1, 0),
        lambda k, n: (2 * k, 2 * k + 1, 2 * k + 2, 2 * k + 3),
    ),
    "GL_POLYGON": (lambda n: int(n >= 3), lambda k, n: (*range(1, n), 0)),
}


def chosen(which):
    def vertices(primitive, n):
        count, corners = POLYGONS[primitive]
        return np.array([which(corners(k, n)) for k in range(count(n))])

    return vertices


provoking = chosen(lambda corners: corners[-1])


def last(primitive, n):
    return np.array([n - 1] if primitive == "GL_POLYGON" else provoking(primitive, n))


def first(primitive, n):
    return chosen(min)(primitive, n)


def lit(P, N, k_d, I_L, light, unit=True, lowest=0.0):
    L = light - P
    cosine = N @ (L / np.linalg.norm(L) if unit else L)
    return I_L * k_d * np.maximum(cosine, lowest)


def at(vertex):
    return lambda P, N, k_d, I_L, light: np.clip(
        lit(P[vertex], N[vertex], k_d, I_L, light), 0, 1
    )


flat = at(2)


def facet(P, N, k_d, I_L, light):
    n = np.cross(P[1] - P[0], P[2] - P[0])
    return np.clip(lit(P[2], n / np.linalg.norm(n), k_d, I_L, light), 0, 1)


def mean(P, N, k_d, I_L, light):
    return np.mean([at(k)(P, N, k_d, I_L, light) for k in range(3)], axis=0)


def inside(P, A, B, C, turn=0):
    """turn: 1 or -1 for a test that knows one sense of rotation only."""

    def side(a, b):
        return (b[0] - a[0]) * (P[1] - a[1]) - (b[1] - a[1]) * (P[0] - a[0])

    sides = np.array([side(A, B), side(B, C), side(C, A)])
    return ((sides > 0).all() and turn != -1) or ((sides < 0).all() and turn != 1)


def strip(P, colors, width, height, vertex=2, offset=0.5, turn=0, over=True):
    image = np.zeros((height, width, 3))
    for k in range(len(P) - 2) if over else range(len(P) - 3, -1, -1):
        for r in range(height):
            for c in range(width):
                if inside((c + offset, r + offset), *P[k : k + 3], turn):
                    image[r, c] = colors[k + vertex]
    return image


RNG = np.random.default_rng(11)
TRIANGLES = []
while len(TRIANGLES) < 16:
    P, light = RNG.uniform(-1, 1, (3, 3)), RNG.uniform((-1, -1, 3), (1, 1, 5))
    N = unit_vectors(3, 100 + len(TRIANGLES)) * 0.5 + (0, 0, 1)
    N /= np.linalg.norm(N, axis=1, keepdims=True)
    bright = 1.0 if len(TRIANGLES) < 10 else 3.0
    TRIANGLES.append(
        (P, N, RNG.uniform(0.1, 1, 3), bright * RNG.uniform(0.3, 0.95, 3), light)
    )
DIM, BRIGHT = TRIANGLES[:10], TRIANGLES[10:]
BEHIND = [(P, -N, k_d, I_L, light) for P, N, k_d, I_L, light in DIM]
ZIGZAG = np.array(
    [(1.213, 1.117), (3.137, 8.911), (6.219, 1.843), (8.347, 9.127), (12.611, 2.039), (13.717, 8.433)]
)  # fmt: skip
FOLDED = np.array(
    [(1.313, 1.211), (2.137, 10.911), (12.219, 5.843), (3.347, 2.127), (10.611, 11.039)]
)
STRIPS = [(ZIGZAG[:n], RNG.uniform(0.1, 1, (n, 3)), 15, 10) for n in (3, 4, 6)]
STRIPS += [(FOLDED, RNG.uniform(0.1, 1, (5, 3)), 14, 12)]


def counts(*primitives):
    return [
        (primitive, n)
        for n in (3, 4, 6, 7, 8, 9, 11, 14, 17)
        for primitive in primitives
        if n >= 4 or "QUAD" not in primitive
    ]


EXERCISE = Definition(
    title="Flat shading by hand",
    lesson=14,
    starter=STARTER,
    parts=[
        Call(
            "the provoking vertices of triangles and quads",
            "provoking",
            counts("GL_TRIANGLES", "GL_QUADS"),
            provoking,
            hint="Three vertices make a triangle, four a quad; the last of them provokes.",
            mistakes=[
                Mistake(first, "These are the first vertices. In OpenGL the last one provokes: with it the triangle is complete."),
                Mistake(lambda p, n: provoking(p, n) + 1, "The vertices are counted from 1; the first one has the number 0."),
                Mistake(lambda p, n: np.arange(2, n, 3), "A quad has four vertices, not three."),
            ],
        ),
        Call(
            "the provoking vertices of strips and fans",
            "provoking",
            counts("GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN", "GL_QUAD_STRIP"),
            provoking,
            hint="After the first triangle each vertex makes a new one, in a quad strip each pair of vertices a new quad; the last vertex of each provokes.",
            mistakes=[
                Mistake(first, "These are the first vertices of each polygon; the last one provokes."),
                Mistake(lambda p, n: provoking(p, n) + 1, "The vertices are counted from 1; the first one has the number 0."),
                Mistake(lambda p, n: np.arange(2, n), "A quad strip makes a quad of each new pair of vertices: one colour for two vertices."),
                Mistake(lambda p, n: 0 * provoking(p, n) if "FAN" in p else provoking(p, n), "A fan's first vertex belongs to all triangles, and would give all the same colour; the last of each provokes."),
                Mistake(lambda p, n: provoking(p, n) - (p == "GL_QUAD_STRIP"), "In a quad strip the second vertex of the new pair is sent last, and provokes."),
                Mistake(chosen(lambda corners: corners[1]), "These are the second vertices of each polygon; the last one provokes."),
            ],
        ),
        Call(
            "the provoking vertex of a polygon",
            "provoking",
            counts("GL_POLYGON"),
            provoking,
            hint="A GL_POLYGON is one polygon, whatever n is, and here the first vertex provokes.",
            mistakes=[
                Mistake(last, "This is the last vertex. GL_POLYGON is the exception: here the first one provokes."),
                Mistake(lambda p, n: np.array([1]), "The vertices are counted from 1; the first one has the number 0."),
            ],
        ),
        Call(
            "the colour of a triangle",
            "flat",
            DIM,
            flat,
            hint="Take normal and position of the provoking vertex, and L is the unit vector from that position to the light.",
            mistakes=[
                Mistake(at(0), "This evaluates at the first vertex; the last one of a triangle provokes."),
                Mistake(at(1), "This evaluates at the second vertex; the last one of a triangle provokes."),
                Mistake(mean, "This is the mean of three colours: flat shading uses one vertex, and mixes nothing."),
                Mistake(facet, "This uses the normal of the plane. OpenGL takes the normal that was given for the provoking vertex."),
                Mistake(lambda P, N, k, I, l: np.clip(lit(P.mean(axis=0), N[2], k, I, l), 0, 1), "L starts in the triangle's middle; it should start at the provoking vertex."),
                Mistake(lambda P, N, k, I, l: np.clip(lit(P[0], N[2], k, I, l), 0, 1), "Normal and position belong to different vertices."),
                Mistake(lambda P, N, k, I, l: np.clip(lit(P[2], N.mean(axis=0) / np.linalg.norm(N.mean(axis=0)), k, I, l), 0, 1), "This takes the mean of the normals; flat shading uses that of one vertex."),
                Mistake(lambda P, N, k, I, l: np.clip(lit(P[2], N[2], k, I, l, unit=False), 0, 1), "L is not a unit vector: divide by its length."),
                Mistake(lambda P, N, k, I, l: np.clip(lit(0 * l, N[2], k, I, l), 0, 1), "The light's position is used as its direction: a point light has another L at every vertex."),
                Mistake(lambda P, N, k, I, l: np.clip(lit(P[2], N[2], 1, I, l), 0, 1), "The reflectance k_d is missing."),
                Mistake(lambda P, N, k, I, l: np.clip(lit(P[2], N[2], k, 1, l), 0, 1), "The light's intensity is missing."),
            ],
            points=2,
        ),
        Call(
            "bright light, and light from behind",
            "flat",
            BRIGHT + BEHIND,
            flat,
            hint="The colour lies between 0 and 1.",
            mistakes=[
                Mistake(lambda P, N, k, I, l: lit(P[2], N[2], k, I, l), "Some channels exceed 1: clamp them."),
                Mistake(lambda P, N, k, I, l: np.minimum(lit(P[2], N[2], k, I, l, lowest=-9.0), 1), "Where the normal looks away from the light the colour is negative: no light is less than none."),
                Mistake(lambda P, N, k, I, l: lit(P[2], N[2], k, I, l, lowest=-9.0), "Nothing is clamped: colours are negative where the normal looks away, and exceed 1 in bright light."),
                Mistake(lambda P, N, k, I, l: np.clip(abs(lit(P[2], N[2], k, I, l, lowest=-9.0)), 0, 1), "The light shines through the surface from behind."),
            ],
        ),
        Call(
            "the picture of a strip",
            "strip",
            STRIPS,
            strip,
            hint="Paint the triangles one after the other, each in the colour of its last vertex.",
            mistakes=[
                Mistake(lambda *a: strip(*a, vertex=0), "Each triangle has the colour of its first vertex; the last one provokes."),
                Mistake(lambda *a: strip(*a, vertex=1), "Each triangle has the colour of its second vertex; the last one provokes."),
                Mistake(lambda *a: strip(*a, turn=1), "Every second triangle is missing: in a strip they go round the other way, and the test for inside has to allow that."),
                Mistake(lambda *a: strip(*a, turn=-1), "Every second triangle is missing: in a strip they go round the other way, and the test for inside has to allow that."),
                Mistake(lambda *a: strip(*a, over=False), "Where triangles overlap, the later one must be seen."),
                Mistake(lambda *a: strip(*a, offset=0.0), "These are the colours of the pixels' corners: test their centres."),
                Mistake(lambda *a: strip(*a)[::-1], "The picture stands on its head: row 0 is the one with y = 0.5."),
                Mistake(lambda P, C, w, h: strip(P[:, ::-1], C, w, h), "x and y are exchanged: the column is x, the row is y."),
                Mistake(lambda P, C, w, h: strip(P[:3], C[:3], w, h), "Only the first triangle is painted."),
                Mistake(lambda P, C, w, h: strip(P, np.repeat(C[-1:], len(C), axis=0), w, h), "All triangles have the last vertex's colour: each has its own."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
