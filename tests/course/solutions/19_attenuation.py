import numpy as np


def attenuation(d, k_0, k_1, k_2):
    return 1 / (k_0 + k_1 * d + k_2 * d**2)


def spot(L, S, cutoff, e):
    if cutoff == 180:
        return 1.0
    cosine = np.dot(-L, S)
    if cosine < np.cos(np.radians(cutoff)):
        return 0.0
    return cosine**e


def lamp(P, lamp, k, S, cutoff, e):
    S = S / np.linalg.norm(S)
    if lamp[3] == 0:
        L = lamp[:3] / np.linalg.norm(lamp[:3])
        return spot(L, S, cutoff, e)
    L = lamp[:3] - P
    d = np.linalg.norm(L)
    return attenuation(d, *k) * spot(L / d, S, cutoff, e)
