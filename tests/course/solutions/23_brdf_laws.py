import numpy as np

ALBEDO = np.pi / 2
LARGEST = 1 / np.pi


def breach(f):
    return np.max(np.abs(f - f.T))


def albedo(f):
    rows, columns = f.shape
    d_theta, d_phi = np.pi / 2 / rows, 2 * np.pi / columns
    total = 0.0
    for i in range(rows):
        theta = (i + 0.5) * d_theta
        total += f[i].sum() * np.cos(theta) * np.sin(theta) * d_theta * d_phi
    return total


def phong(N, L, V, k_s, n):
    if np.dot(N, L) <= 0 or np.dot(N, V) <= 0:
        return 0.0
    R = 2 * np.dot(N, L) * N - L
    return k_s * (n + 2) / (2 * np.pi) * max(np.dot(R, V), 0) ** n
