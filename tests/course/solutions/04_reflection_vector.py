import numpy as np


def reflection(N, L):
    projection = np.dot(N, L) * N
    S = projection - L
    return projection + S


def mirror_ray(D, N):
    return reflection(N, -D)
