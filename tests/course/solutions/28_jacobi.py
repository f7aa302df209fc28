import numpy as np


def sweep(F, rho, E, B):
    return E + rho * (F @ B)


def jacobi(F, rho, E, sweeps):
    steps = [E]
    for _ in range(sweeps):
        steps.append(sweep(F, rho, E, steps[-1]))
    return np.array(steps)


def sweeps_needed(F, rho, E, small):
    B = E
    for k in range(1, 1000):
        new = sweep(F, rho, E, B)
        if np.max(np.abs(new - B)) <= small:
            return k
        B = new
    return -1
