import numpy as np


def shooter(A, unsent):
    return np.argmax(A * unsent.sum(axis=1))


def shoot(F, rho, B, unsent, i):
    received = rho * F[:, i, None] * unsent[i]
    B = B + received
    waiting = unsent + received
    waiting[i] = 0
    return np.array([B, waiting])


def shooting(F, A, rho, E, shots):
    B, unsent = E, E
    steps = [B]
    for _ in range(shots):
        B, unsent = shoot(F, rho, B, unsent, shooter(A, unsent))
        steps.append(B)
    return np.array(steps)
