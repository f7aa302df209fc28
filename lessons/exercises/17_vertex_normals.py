r"""A vertex gets a mean of the unit normals $\mathbf{n}_k$ of the triangles that meet there:

$$ \mathbf{N} = \frac{\sum_k w_k\, \mathbf{n}_k}{\big| \sum_k w_k\, \mathbf{n}_k \big|} $$

`P` are points, (m, 3); `T` are triangles, (t, 3), each three numbers of points, anticlockwise as seen from outside. Write `face_normals(P, T)`: the unit normals of the
triangles, (t, 3). Write `by_area(P, T)`, the normals of the points, (m, 3), where $w_k$ is the triangle's area, and `by_angle(P, T)`, where it is the triangle's angle at
the vertex. Every point belongs to at least one triangle.

Then write `with_crease(P, T, degrees)`: each **corner of each triangle** gets a normal of its own, (t, 3, 3). Of the triangles that meet at the vertex it takes into the mean (weighted by angles)
only those whose normals are within `degrees` of the normal of the triangle itself.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake

STARTER = '''\
import numpy as np


def face_normals(P, T):
    """Returns the unit normals (t, 3) of triangles T (t, 3) between points P (m, 3)."""
    return np.zeros(T.shape)


def by_area(P, T):
    """Returns the normals (m, 3) of the points, weighted by the triangles' areas."""
    return np.zeros(P.shape)


def by_angle(P, T):
    """Returns the normals (m, 3) of the points, weighted by the triangles' angles."""
    return np.zeros(P.shape)


def with_crease(P, T, degrees):
    """Returns a normal for each corner of each triangle: (t, 3, 3)."""
    return np.zeros((len(T), 3, 3))
'''


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def crosses(P, T):
    return np.cross(P[T[:, 1]] - P[T[:, 0]], P[T[:, 2]] - P[T[:, 0]])


def face_normals(P, T):
    return unit(crosses(P, T))


def area_weights(P, T):
    return np.repeat(np.linalg.norm(crosses(P, T), axis=1)[:, None] / 2, 3, axis=1)


def cosines(P, T):
    corner = P[T]
    to_next = unit(np.roll(corner, -1, axis=1) - corner)
    to_last = unit(np.roll(corner, 1, axis=1) - corner)
    return np.clip((to_next * to_last).sum(axis=2), -1, 1)


def angle_weights(P, T):
    return np.arccos(cosines(P, T))


def equal_weights(P, T):
    return np.ones(T.shape)


def mean(P, T, weights, faces=face_normals, length=unit):
    N = np.zeros(P.shape)
    for corner in range(3):
        np.add.at(N, T[:, corner], weights(P, T)[:, corner, None] * faces(P, T))
    return length(N)


def by_area(P, T):
    return mean(P, T, area_weights)


def by_angle(P, T):
    return mean(P, T, angle_weights)


def with_crease(P, T, degrees, weights=angle_weights, within=None):
    n, w = face_normals(P, T), weights(P, T)
    close = (
        n @ n.T >= np.cos(np.radians(degrees)) if within is None else within(n, degrees)
    )
    result = np.zeros((len(T), 3, 3))
    for a in range(len(T)):
        for corner in range(3):
            meet = (T[a, corner] == T) & close[a][:, None]
            result[a, corner] = (w * meet).sum(axis=1) @ n
    return unit(result)


def box(x, y, z):
    P = np.array([(i, j, k) for i in (0, x) for j in (0, y) for k in (0, z)], float)
    faces = "0132", "6754", "0451", "7623", "0264", "5731"
    halves = (0, 1, 2), (0, 2, 3)
    return P, np.array(
        [[int(face[k]) for k in half] for face in faces for half in halves]
    )


RNG = np.random.default_rng(17)


def hill(n, height=1.0):
    """A field of n x n points at random heights."""
    x, y = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    P = np.stack([x, y, RNG.uniform(0, height, (n, n))], axis=-1).reshape(-1, 3)
    P[:, :2] += RNG.uniform(-0.3, 0.3, (n * n, 2))
    T = []
    for a in range(n - 1):
        for b in range(n - 1):
            k = a * n + b
            T += [(k, k + n, k + n + 1), (k, k + n + 1, k + 1)]
    return P, np.array(T)


ROOF = (
    np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 3.0]]),
    np.array([[0, 1, 2], [0, 3, 1]]),
)
BOX, FACES = box(2.0, 1.0, 1.0)
LEANING = BOX @ np.array([[1.0, 0.2, 0.0], [0.0, 1.0, 0.1], [0.1, 0.0, 1.0]])
MESHES = [ROOF, (LEANING, FACES), hill(3), hill(4), hill(3, 3.0)]
CREASES = [(*MESHES[1], 60.0), (*MESHES[1], 100.0)]
CREASES += [(*mesh, degrees) for mesh in MESHES[2:] for degrees in (10.0, 35.0, 60.0)]

EXERCISE = Definition(
    title="Vertex normals",
    lesson=21,
    starter=STARTER,
    parts=[
        Call(
            "the triangles' normals",
            "face_normals",
            MESHES,
            face_normals,
            hint="The cross product of two edges that begin at the same corner, made a unit vector.",
            mistakes=[
                Mistake(crosses, "The cross product is as long as twice the area: make it a unit vector."),
                Mistake(lambda P, T: -face_normals(P, T), "The normals point inwards: the order of the factors in the cross product decides."),
                Mistake(lambda P, T: crosses(P, T) / np.linalg.norm(crosses(P, T)), "All normals together were divided by one length: each has its own."),
                Mistake(lambda P, T: unit(np.cross(P[T[:, 0]], P[T[:, 1]])), "This is the cross product of two points; edges, differences of points, are needed."),
                Mistake(lambda P, T: unit(P[T].mean(axis=1)), "This is the direction from the origin: only a sphere has such normals."),
                Mistake(lambda P, T: crosses(P, T) / 2, "This vector is as long as the area: make it a unit vector."),
            ],
        ),
        Call(
            "weighted by areas",
            "by_area",
            MESHES,
            by_area,
            hint="Add area times unit normal of all triangles at the vertex, and make the sum a unit vector.",
            mistakes=[
                Mistake(lambda P, T: mean(P, T, equal_weights), "This is the plain mean: large triangles should count more."),
                Mistake(by_angle, "These weights are angles; areas are asked for."),
                Mistake(lambda P, T: mean(P, T, area_weights, length=lambda N: N), "The sum is not a unit vector."),
                Mistake(lambda P, T: mean(P, T, area_weights, length=lambda N: 2 * N), "The sum is not a unit vector."),
                Mistake(lambda P, T: mean(P, T, area_weights, faces=crosses), "The area counts twice: the cross product has it already."),
                Mistake(lambda P, T: -by_area(P, T), "The normals point inwards."),
                Mistake(lambda P, T: mean(P, T, lambda P, T: 1 / area_weights(P, T)), "Large triangles count less here, not more."),
            ],
            points=2,
        ),
        Call(
            "weighted by angles",
            "by_angle",
            MESHES,
            by_angle,
            hint="The angle at the vertex is that between the two edges that begin there; a triangle has another one at each corner.",
            mistakes=[
                Mistake(by_area, "These weights are areas; angles are asked for."),
                Mistake(lambda P, T: mean(P, T, equal_weights), "This is the plain mean: triangles with a wide angle at the vertex should count more."),
                Mistake(lambda P, T: mean(P, T, cosines), "The weights are cosines of the angles: the angles themselves are asked for."),
                Mistake(lambda P, T: mean(P, T, lambda P, T: np.sin(angle_weights(P, T))), "The weights are sines of the angles: the angles themselves are asked for."),
                Mistake(lambda P, T: mean(P, T, lambda P, T: np.repeat(angle_weights(P, T)[:, :1], 3, axis=1)), "The angle at the triangle's first corner is used for all three."),
                Mistake(lambda P, T: mean(P, T, lambda P, T: np.roll(angle_weights(P, T), 1, axis=1)), "The angle belongs to another corner of the triangle."),
                Mistake(lambda P, T: mean(P, T, lambda P, T: np.roll(angle_weights(P, T), -1, axis=1)), "The angle belongs to another corner of the triangle."),
                Mistake(lambda P, T: mean(P, T, lambda P, T: np.pi - angle_weights(P, T)), "These are the outer angles: one of the two edges points the wrong way."),
                Mistake(lambda P, T: mean(P, T, angle_weights, faces=crosses), "Angle and area both count here: use unit normals."),
                Mistake(lambda P, T: mean(P, T, angle_weights, length=lambda N: N), "The sum is not a unit vector."),
            ],
            points=2,
        ),
        Call(
            "the crease angle",
            "with_crease",
            CREASES,
            with_crease,
            hint="For each corner look at all triangles that share its point, and keep those whose normal is near the triangle's own.",
            mistakes=[
                Mistake(lambda P, T, d: by_angle(P, T)[T], "All triangles at the vertex count, whatever the crease angle is."),
                Mistake(lambda P, T, d: np.repeat(face_normals(P, T)[:, None], 3, axis=1), "Each triangle has its own normal only: this is flat shading."),
                Mistake(lambda P, T, d: with_crease(P, T, d, within=lambda n, d: n @ n.T >= np.cos(d)), "Degrees are used as radians."),
                Mistake(lambda P, T, d: with_crease(P, T, d, within=lambda n, d: (n @ n.T <= np.cos(np.radians(d))) | np.eye(len(n), dtype=bool)), "The comparison is the wrong way round: a small angle has a large cosine."),
                Mistake(lambda P, T, d: with_crease(P, T, d / 2), "The angle between two normals is compared with the whole crease angle, not with half of it."),
                Mistake(lambda P, T, d: with_crease(P, T, d, weights=area_weights), "These means are weighted by areas; here they are to be weighted by angles."),
                Mistake(lambda P, T, d: with_crease(P, T, d, weights=equal_weights), "These are plain means; here they are to be weighted by angles."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
