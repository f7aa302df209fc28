RIGHT = {
    "with S": """
def highlight(N, L, V, n):
    c = N @ L
    if not c > 0:
        return 0
    S = c * N - L
    R = c * N + S
    cosine = R @ V
    return cosine**n if cosine > 0 else 0


def half_angle(n):
    import math

    return math.degrees(math.acos(math.exp(math.log(0.5) / n)))
""",
    "with where": """
import numpy as np


def highlight(N, L, V, n):
    N, L, V = map(np.asarray, (N, L, V))
    R = 2 * np.sum(N * L) * N - L
    return np.where(np.sum(N * L) > 0, np.power(np.clip(np.sum(R * V), 0, None), n), 0)


def half_angle(n):
    return np.rad2deg(np.arccos(np.power(2.0, -1.0 / n)))
""",
}

POWER = "max(np.dot(R, V), 0.0) ** n"
WRONG = {
    "no exponent": ([(POWER, "max(np.dot(R, V), 0.0)")], "exponent n is missing"),
    "a factor": ([(POWER, "n * max(np.dot(R, V), 0.0)")], "not a factor"),
    "Blinn": (
        [("R = 2 * np.dot(N, L) * N - L", "R = (L + V) / np.linalg.norm(L + V)"), ("np.dot(R, V)", "np.dot(R, N)")],
        "N·H",
    ),
    "N.V": ([("np.dot(R, V)", "np.dot(N, V)")], "N·V"),
    "N.L": ([(POWER, "max(np.dot(N, L), 0.0) ** n")], "moves with the eye"),
    "L.V": ([("np.dot(R, V)", "np.dot(L, V)")], "mirrored at N first"),
    "sign of R": ([("2 * np.dot(N, L) * N - L", "L - 2 * np.dot(N, L) * N")], "wrong sign"),
    "whole exponent": ([("** n\n\n", "** int(n)\n\n")], "whole number"),
    "no maximum": ([(POWER, "abs(np.dot(R, V)) ** n")], "before the power"),
    "no test of N.L": ([("    if np.dot(N, L) <= 0:\n        return 0.0\n", "")], "gets no light"),
    "radians": ([("np.degrees(np.arccos(0.5 ** (1 / n)))", "np.arccos(0.5 ** (1 / n))")], "in degrees"),
    "quotient": ([("0.5 ** (1 / n)", "0.5 / n")], "n-th root"),
    "integer division": ([("(1 / n)", "(1 // n)")], "Solve"),
}
