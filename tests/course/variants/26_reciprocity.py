RIGHT = {
    "with arrays": """
import numpy as np


def reverse(F_ij, A_i, A_j):
    return F_ij / (A_j / A_i)


def completed(upper, areas):
    S = upper * areas[:, None]
    return (S + S.T) / areas[:, None]


def absorbed(B, E, rho, F, areas):
    return areas @ ((1 - rho) * (F @ B))
""",
    "with sums": """
def reverse(F_ij, A_i, A_j):
    return A_i * F_ij / A_j


def completed(upper, areas):
    n = len(areas)
    return [
        [upper[i][j] if i < j else reverse(upper[j][i], areas[j], areas[i]) if j < i else 0 for j in range(n)]
        for i in range(n)
    ]


def absorbed(B, E, rho, F, areas):
    total = 0
    for i, A in enumerate(areas):
        arriving = sum(F[i][j] * B[j] for j in range(len(B)))
        total += A * arriving - A * rho[i] * arriving
    return total
""",
}

WRONG = {
    "upside down": ([("F_ij * A_i / A_j", "F_ij * A_j / A_i")], "upside down"),
    "symmetric": ([("return F_ij * A_i / A_j", "return F_ij")], "not symmetric"),
    "complement": ([("return F_ij * A_i / A_j", "return 1 - F_ij")], "not the two directions"),
    "both multiply": ([("F_ij * A_i / A_j", "F_ij * A_i * A_j")], "the other divides"),
    "matrix symmetric": ([("reverse(F[i, j], areas[i], areas[j])", "F[i, j]")], "below the diagonal the areas count"),
    "matrix upside down": (
        [("reverse(F[i, j], areas[i], areas[j])", "reverse(F[i, j], areas[j], areas[i])")],
        "upside down",
    ),
    "half done": ([("range(i + 1, n)", "range(i + 1, i + 1)")], "still 0"),
    "last column left out": ([("range(i + 1, n)", "range(i + 1, n - 1)")], "reversed form factors"),
    "rows divided": (
        [("    return F\n", "    F = upper + upper.T\n    return F / F.sum(axis=1, keepdims=True)\n")],
        "by dividing",
    ),
    "reflected": ([("(1 - rho)", "rho")], "share rho"),
    "no areas": ([("areas * (1 - rho) * H", "(1 - rho) * H")], "densities"),
    "transposed": ([("F @ B", "F.T @ B")], "transposed"),
    "leaving": ([("H = F @ B", "H = B")], "what arrives"),
    "emitted": ([("areas * (1 - rho) * H", "areas * E")], "Compute the sum itself"),
}
