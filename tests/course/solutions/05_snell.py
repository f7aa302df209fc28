import numpy as np


def refracted_angle(theta_1, n_1, n_2):
    sine = n_1 / n_2 * np.sin(np.radians(theta_1))
    if sine > 1:
        return -1.0
    return np.degrees(np.arcsin(sine))


def critical_angle(n_1, n_2):
    return np.degrees(np.arcsin(n_2 / n_1))


def schlick(cosine, n_1, n_2):
    F_0 = ((n_1 - n_2) / (n_1 + n_2)) ** 2
    return F_0 + (1 - F_0) * (1 - cosine) ** 5
