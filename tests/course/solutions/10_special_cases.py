import numpy as np


def illuminate(k_a, k_d, k_s, n, I_a, lights, directions, N, V):
    color = I_a * k_a
    for I_L, L in zip(lights, directions, strict=True):
        cosine = N @ L
        if cosine > 0:
            R = 2 * cosine * N - L
            color = color + I_L * (k_d * cosine + k_s * max(R @ V, 0) ** n)
    return np.clip(color, 0, 1)


def flip(k_d, I_L, N, L):
    if N @ L < 0:
        N = -N
    return k_d * I_L * (N @ L)


def two_sided(front, back, I_L, N, L, V):
    if N @ V < 0:
        N, front = -N, back
    return front * I_L * max(N @ L, 0)
