import numpy as np


def normal(w, normals):
    N = w[0] * normals[0] + w[1] * normals[1] + w[2] * normals[2]
    return N / np.linalg.norm(N)


def shade(N, k_d, k_s, n, I_L, L, V):
    cosine = N @ L
    if cosine <= 0:
        return np.zeros(3)
    H = (L + V) / np.linalg.norm(L + V)
    highlight = max(N @ H, 0) ** n
    return np.clip(I_L * (k_d * cosine + k_s * highlight), 0, 1)


def picture(weights, normals, k_d, k_s, n, I_L, L, V):
    image = np.zeros(weights.shape)
    for row in range(weights.shape[0]):
        for column in range(weights.shape[1]):
            w = weights[row, column]
            if min(w) >= 0:
                image[row, column] = shade(normal(w, normals), k_d, k_s, n, I_L, L, V)
    return image
