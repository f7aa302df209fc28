import numpy as np


def form_factor(x_i, N_i, x_j, N_j, A_j):
    d = x_j - x_i
    r = np.linalg.norm(d)
    w = d / r
    cos_i = np.dot(N_i, w)
    cos_j = -np.dot(N_j, w)
    if cos_i <= 0 or cos_j <= 0:
        return 0.0
    return A_j * cos_i * cos_j / (np.pi * r**2)


def point_to_points(x_i, N_i, points, N_j, A_j):
    return np.mean([form_factor(x_i, N_i, x, N_j, A_j) for x in points])
