import numpy as np

WHITE_IN_RED = (1, 0, 0)
GREEN_IN_RED = (0, 0, 0)
HIGHLIGHT = (1, 0, 0)


def diffuse_color(k_a, k_d, I_a, lights, directions, N):
    color = I_a * k_a
    for light, L in zip(lights, directions, strict=True):
        color = color + light * k_d * max(np.dot(N, L), 0)
    return np.clip(color, 0, 1)
