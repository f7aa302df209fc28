import numpy as np


def reverse(F_ij, A_i, A_j):
    return F_ij * A_i / A_j


def completed(upper, areas):
    F = upper.copy()
    n = len(areas)
    for i in range(n):
        for j in range(i + 1, n):
            F[j, i] = reverse(F[i, j], areas[i], areas[j])
    return F


def absorbed(B, E, rho, F, areas):
    H = F @ B
    return np.sum(areas * (1 - rho) * H)
