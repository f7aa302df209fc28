import numpy as np


def lambert(N, L):
    return max(float(np.dot(N, L)), 0.0)


def diffuse(I_L, k_d, N, L):
    return I_L * k_d * lambert(N, L)
