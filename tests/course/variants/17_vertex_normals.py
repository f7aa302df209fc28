# ruff: noqa: E501
RIGHT = {
    "with arrays": """
import numpy as np


def unit(v):
    return v / np.sqrt((v**2).sum(axis=-1))[..., None]


def face_normals(P, T):
    return unit(np.cross(P[T[:, 2]] - P[T[:, 1]], P[T[:, 0]] - P[T[:, 1]]))


def by_area(P, T):
    cross = np.cross(P[T[:, 1]] - P[T[:, 0]], P[T[:, 2]] - P[T[:, 0]])
    belongs = (T[None] == np.arange(len(P))[:, None, None]).any(axis=2)
    return unit(belongs @ cross)


def angles(P, T):
    e = P[np.roll(T, -1, axis=1)] - P[T]
    f = P[np.roll(T, 1, axis=1)] - P[T]
    return np.arctan2(np.linalg.norm(np.cross(e, f), axis=2), (e * f).sum(axis=2))


def by_angle(P, T):
    weight = ((T[None] == np.arange(len(P))[:, None, None]) * angles(P, T)).sum(axis=2)
    return unit(weight @ face_normals(P, T))


def with_crease(P, T, degrees):
    n = face_normals(P, T)
    close = np.degrees(np.arccos(np.clip(n @ n.T, -1, 1))) <= degrees + 1e-9
    meet = T[:, :, None, None] == T
    return unit(np.einsum("acbd,ab,bd,bk->ack", meet, close, angles(P, T), n))
""",
    "by hand": """
import math


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    return [x / math.sqrt(dot(v, v)) for x in v]


def face_normals(P, T):
    return [unit(cross(minus(P[b], P[a]), minus(P[c], P[a]))) for a, b, c in T]


def total(parts):
    return unit([sum(w * n[i] for w, n in parts) for i in range(3)])


def by_area(P, T):
    crosses = [cross(minus(P[b], P[a]), minus(P[c], P[a])) for a, b, c in T]
    return [total([(1, n) for t, n in zip(T, crosses) if v in t]) for v in range(len(P))]


def angle(P, t, v):
    e, f = (unit(minus(P[other], P[v])) for other in t if other != v)
    return math.acos(dot(e, f))


def by_angle(P, T):
    faces = face_normals(P, T)
    return [total([(angle(P, t, v), n) for t, n in zip(T, faces) if v in t]) for v in range(len(P))]


def with_crease(P, T, degrees):
    faces, least = face_normals(P, T), math.cos(math.radians(degrees))
    return [
        [total([(angle(P, t, v), n) for t, n in zip(T, faces) if v in t and dot(n, own) >= least]) for v in mine]
        for mine, own in zip(T, faces)
    ]
""",
}

FACE = "unit(np.cross(B - A, C - A))"
ADD = "N[triangle[corner]] += weight(P, triangle, corner) * n[k]"
AREA, ANGLE = "mean_normals(P, T, area)", "mean_normals(P, T, angle)"
ARC = "np.arccos(np.clip(cosine, -1, 1))"
NEAR = "n[k] @ n[other] >= least"
PLAIN = "mean_normals(P, T, lambda *_: 1)"
WRONG = {
    "face not unit": ([(FACE, "np.cross(B - A, C - A)")], "twice the area"),
    "inwards": ([(FACE, "unit(np.cross(C - A, B - A))")], "point inwards"),
    "one length": ([(FACE, "np.cross(B - A, C - A) / np.linalg.norm(np.cross(B - A, C - A))")], "one length"),
    "points, not edges": ([(FACE, "unit(np.cross(A, B) + 1e-30)")], "cross product of two"),
    "from the origin": ([(FACE, "unit((A + B + C) / 3)")], "from the origin"),
    "plain mean": ([(AREA, PLAIN)], "large triangles should count more"),
    "angles for areas": ([(AREA, ANGLE)], "areas are asked for"),
    "sum not unit": ([(AREA, "mean_normals(P, T, area, 1)"), ("T, weight):", "T, weight, raw=0):"), ("    return unit(N)\n\n\ndef by_area", "    return N if raw else unit(N)\n\n\ndef by_area")], "not a unit vector"),
    "area twice": ([(AREA, "mean_normals(P, T, lambda *a: area(*a) ** 2)")], "area counts twice"),
    "small ones first": ([(AREA, "mean_normals(P, T, lambda *a: 1 / area(*a))")], "count less here"),
    "last triangle only": ([(ADD, ADD.replace("+=", "="))], "all triangles at the vertex"),
    "areas for angles": ([(ANGLE, AREA)], "angles are asked for"),
    "plain mean for angles": ([(ANGLE, PLAIN)], "wide angle"),
    "cosines": ([(ARC, "cosine")], "cosines of the angles"),
    "sines": ([(ARC, "np.sqrt(1 - cosine**2)")], "sines of the angles"),
    "first corner": ([("(corner + k) % 3", "k")], "first corner is used"),
    "another corner": ([("(corner + k) % 3", "(corner + k + 1) % 3")], "another corner"),
    "outer angle": ([("unit(before - here)", "unit(here - before)")], "outer angles"),
    "no crease": ([(" and " + NEAR, "")], "whatever the crease angle"),
    "flat": ([(NEAR, "other == k")], "flat shading"),
    "radians": ([("np.cos(np.radians(degrees))", "np.cos(degrees)")], "used as radians"),
    "wrong way round": ([(NEAR, "(n[k] @ n[other] <= least or k == other)")], "wrong way round"),
    "half the angle": ([("np.radians(degrees)", "np.radians(degrees / 2)")], "half of it"),
    "crease by areas": ([("angle(P, T[other], j) * n", "area(P, T[other], j) * n")], "weighted by areas"),
    "crease plain": ([("angle(P, T[other], j) * n", "n")], "plain means"),
}  # fmt: skip
