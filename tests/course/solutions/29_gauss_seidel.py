import numpy as np


def visit(F, rho, E, B, order):
    B = B.copy()
    for i in order:
        B[i] = E[i] + rho[i] * (F[i] @ B)
    return B


def sweep(F, rho, E, B):
    return visit(F, rho, E, B, range(len(B)))


def gauss_seidel(F, rho, E, sweeps):
    steps = [E]
    for _ in range(sweeps):
        steps.append(sweep(F, rho, E, steps[-1]))
    return np.array(steps)


def backwards(F, rho, E, B):
    return visit(F, rho, E, B, range(len(B) - 1, -1, -1))
