import numpy as np

RATIO = 4


def grid(C, u, v, m):
    points = []
    for i in range(m):
        for j in range(m):
            points.append(C + (i + 0.5) / m * u + (j + 0.5) / m * v)
    return np.array(points)


def piece(x, N, y, N_y, A):
    d = np.linalg.norm(y - x)
    L = (y - x) / d
    return A * max(np.dot(N, L), 0) * max(np.dot(N_y, -L), 0) / d**2


def irradiance(x, N, C, u, v, m):
    across = np.cross(u, v)
    A = np.linalg.norm(across)
    total = 0.0
    for y in grid(C, u, v, m):
        total += piece(x, N, y, across / A, A / m**2)
    return total


def exact(x, N, corners):
    total = 0.0
    for k in range(len(corners)):
        a = corners[k] - x
        b = corners[(k + 1) % len(corners)] - x
        across = np.cross(b, a)
        angle = np.arccos(np.dot(a, b) / (np.linalg.norm(a) * np.linalg.norm(b)))
        total += angle * np.dot(N, across / np.linalg.norm(across))
    return total / 2
