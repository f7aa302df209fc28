RIGHT = {
    "by hand": """
def lambert(N, L):
    cosine = N[0] * L[0] + N[1] * L[1] + N[2] * L[2]
    return cosine if cosine > 0 else 0


def diffuse(I_L, k_d, N, L):
    return [I_L[c] * k_d[c] * lambert(N, L) for c in range(3)]
""",
    "by the angle": """
import math

import numpy as np


def lambert(N, L):
    angle = math.acos(min(max(N @ L, -1.0), 1.0))
    return np.array([max(math.cos(angle), 0.0)])


def diffuse(I_L, k_d, N, L):
    return np.clip(np.dot(N, L), 0, None) * np.multiply(I_L, k_d)
""",
}

COSINE = "max(float(np.dot(N, L)), 0.0)"
WRONG = {
    "no maximum": ([(COSINE, "float(np.dot(N, L))")], "no light is less than none"),
    "absolute value": ([(COSINE, "abs(float(np.dot(N, L)))")], "must not shine through"),
    "the angle": ([(COSINE, "float(np.arccos(np.dot(N, L)))")], "the angle between N and L"),
    "the sine": ([(COSINE, "float(np.sqrt(1 - np.dot(N, L) ** 2))")], "sine"),
    "degrees": ([(COSINE, "float(np.cos(np.radians(np.arccos(np.dot(N, L)))))")], "in radians already"),
    "product of components": ([(COSINE, "N * L")], "3 numbers"),
    "squared": ([(COSINE, "max(float(np.dot(N, L)), 0.0) ** 2")], "square"),
    "constant": ([(COSINE, "1.0")], "equally bright"),
    "integer": ([(COSINE, "int(max(float(np.dot(N, L)), 0.0))")], "cosine of the angle"),
    "no reflectance": ([("I_L * k_d * lambert", "I_L * lambert")], "k_d is missing"),
    "no intensity": ([("I_L * k_d * lambert", "k_d * lambert")], "I_L is missing"),
    "sum": ([("I_L * k_d * lambert", "(I_L + k_d) * lambert")], "do not add"),
    "one channel": ([("I_L * k_d * lambert", "I_L[0] * k_d[0] * lambert")], "gives a number; expected: 3 numbers"),
    "nothing returned": ([("    return max", "    x = max")], "does the function return"),
}
