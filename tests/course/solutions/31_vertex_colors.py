import numpy as np


def at_vertices(corners, A, B, count):
    total, areas = np.zeros((count, 3)), np.zeros(count)
    for i, patch in enumerate(corners):
        for v in patch:
            total[v] += A[i] * B[i]
            areas[v] += A[i]
    return total / areas[:, None]


def toned(B, white):
    return np.minimum(B / white, 1) ** (1 / 2.2)


def bake(corners, A, B, count, white):
    return toned(at_vertices(corners, A, B, count), white)
