import numpy as np


def meet(O, D, C, r):
    b = np.dot(O - C, D)
    under = b * b - (np.dot(O - C, O - C) - r * r)
    if under < 0:
        return -1.0
    root = np.sqrt(under)
    if -b - root > 0:
        return -b - root
    if -b + root > 0:
        return -b + root
    return -1.0


def in_shadow(P, lamp, C, r):
    distance = np.linalg.norm(lamp - P)
    L = (lamp - P) / distance
    t = meet(P, L, C, r)
    return 1 if 0 < t < distance else 0


def bounce(O, D, C, r):
    P = O + meet(O, D, C, r) * D
    N = (P - C) / r
    return np.array([P, D - 2 * np.dot(D, N) * N])
