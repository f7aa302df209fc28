import numpy as np


def highlight(N, L, V, n):
    if np.dot(N, L) <= 0:
        return 0.0
    R = 2 * np.dot(N, L) * N - L
    return max(np.dot(R, V), 0.0) ** n


def half_angle(n):
    return np.degrees(np.arccos(0.5 ** (1 / n)))
