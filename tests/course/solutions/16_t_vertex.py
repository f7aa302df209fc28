import numpy as np


def jump(A, B, M, I_A, I_B, I_M):
    t = np.linalg.norm(M - A) / np.linalg.norm(B - A)
    return I_M - ((1 - t) * I_A + t * I_B)


def fan(polygon):
    return [[polygon[0], polygon[k], polygon[k + 1]] for k in range(1, len(polygon) - 1)]


def mended(P, polygon, m):
    for k in range(len(polygon)):
        A, B = P[polygon[k - 1]], P[polygon[k]]
        on_the_line = np.linalg.norm(np.cross(B - A, P[m] - A)) < 1e-9
        if on_the_line and (A - P[m]) @ (B - P[m]) < 0:
            return [m, *polygon[k:], *polygon[:k]]
    return polygon
