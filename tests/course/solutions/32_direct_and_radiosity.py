import numpy as np

DIRECT = (1, 1 / 2)
FULL = (4 / 3, 2 / 3)
SHARE = 3 / 4


def direct(F, rho, E):
    return E + rho * (F @ E)


def full(F, rho, E):
    B = np.empty(E.shape)
    for c in range(3):
        B[:, c] = np.linalg.solve(np.eye(len(F)) - rho[:, c, None] * F, E[:, c])
    return B


def indirect(F, rho, E):
    return full(F, rho, E) - direct(F, rho, E)


def glow(F, A, rho, E):
    power = A @ indirect(F, rho, E)
    return power / (A @ rho)
