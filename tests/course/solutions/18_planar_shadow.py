import numpy as np


def shadow_matrix(plane, light):
    return np.dot(plane, light) * np.eye(4) - np.outer(light, plane)


def shadow(plane, light, v):
    s = shadow_matrix(plane, light) @ np.append(v, 1)
    return s[:3] / s[3]


def sixteen(M):
    return M.T.flatten()


def casts(plane, light, v):
    height = np.dot(plane, np.append(v, 1))
    height_of_light = np.dot(plane, light)
    if height * height_of_light <= 0:
        return 0
    if light[3] == 0:
        return 1
    return 1 if abs(height) < abs(height_of_light) else 0
