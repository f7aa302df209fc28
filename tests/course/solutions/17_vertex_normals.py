import numpy as np


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def face_normals(P, T):
    A, B, C = P[T[:, 0]], P[T[:, 1]], P[T[:, 2]]
    return unit(np.cross(B - A, C - A))


def area(P, triangle, corner):
    A, B, C = P[triangle]
    return np.linalg.norm(np.cross(B - A, C - A)) / 2


def angle(P, triangle, corner):
    here, after, before = (P[triangle[(corner + k) % 3]] for k in (0, 1, 2))
    cosine = unit(after - here) @ unit(before - here)
    return np.arccos(np.clip(cosine, -1, 1))


def mean_normals(P, T, weight):
    n, N = face_normals(P, T), np.zeros(P.shape)
    for k, triangle in enumerate(T):
        for corner in range(3):
            N[triangle[corner]] += weight(P, triangle, corner) * n[k]
    return unit(N)


def by_area(P, T):
    return mean_normals(P, T, area)


def by_angle(P, T):
    return mean_normals(P, T, angle)


def with_crease(P, T, degrees):
    n, N = face_normals(P, T), np.zeros((len(T), 3, 3))
    least = np.cos(np.radians(degrees))
    for k in range(len(T)):
        for corner in range(3):
            for other in range(len(T)):
                for j in range(3):
                    if T[other, j] == T[k, corner] and n[k] @ n[other] >= least:
                        N[k, corner] += angle(P, T[other], j) * n[other]
    return unit(N)
