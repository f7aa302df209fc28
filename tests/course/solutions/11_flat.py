import numpy as np


def provoking(primitive, n):
    if primitive == "GL_POLYGON":
        return [0]
    first, step = {
        "GL_TRIANGLES": (2, 3),
        "GL_TRIANGLE_STRIP": (2, 1),
        "GL_TRIANGLE_FAN": (2, 1),
        "GL_QUADS": (3, 4),
        "GL_QUAD_STRIP": (3, 2),
    }[primitive]
    return list(range(first, n, step))


def flat(P, N, k_d, I_L, light):
    L = light - P[2]
    L = L / np.linalg.norm(L)
    return np.clip(I_L * k_d * max(N[2] @ L, 0), 0, 1)


def side(P, A, B):
    return (B[0] - A[0]) * (P[1] - A[1]) - (B[1] - A[1]) * (P[0] - A[0])


def strip(P, colors, width, height):
    image = np.zeros((height, width, 3))
    for k in range(len(P) - 2):
        A, B, C = P[k : k + 3]
        for row in range(height):
            for column in range(width):
                pixel = (column + 0.5, row + 0.5)
                sides = [side(pixel, A, B), side(pixel, B, C), side(pixel, C, A)]
                if min(sides) > 0 or max(sides) < 0:
                    image[row, column] = colors[k + 2]
    return image
