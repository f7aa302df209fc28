import numpy as np


def illuminate(k_a, k_d, k_s, n, I_a, I_L, N, L, V):
    color = I_a * k_a
    N_L = np.dot(N, L)
    if N_L > 0:
        R = 2 * N_L * N - L
        color = color + I_L * k_d * N_L
        color = color + I_L * k_s * max(np.dot(R, V), 0) ** n
    return np.clip(color, 0, 1)
