import numpy as np


def halfway(L, V):
    total = L + V
    return total / np.linalg.norm(total)


def highlight(N, L, V, n):
    if np.dot(N, L) <= 0:
        return 0.0
    H = halfway(L, V)
    return max(np.dot(N, H), 0.0) ** n
