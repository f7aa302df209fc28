RIGHT = {
    "by hand": """
import math


def unit(v):
    length = math.hypot(*v)
    return [x / length for x in v]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def normal(w, normals):
    return unit([sum(w[k] * normals[k][i] for k in range(3)) for i in range(3)])


def shade(N, k_d, k_s, n, I_L, L, V):
    H = unit([a + b for a, b in zip(L, V)])
    if dot(N, L) <= 0:
        return 0, 0, 0
    h = max(0.0, dot(N, H)) ** n
    return [min(1.0, I_L[c] * (k_d[c] * dot(N, L) + k_s[c] * h)) for c in range(3)]


def picture(weights, normals, *rest):
    def pixel(w):
        return shade(normal(w, normals), *rest) if min(w) >= 0 else (0, 0, 0)

    return [[pixel(w) for w in row] for row in weights]
""",
    "all pixels at once": """
import numpy as np


def normal(w, normals):
    N = w @ normals
    return N / np.sqrt((N * N).sum(axis=-1, keepdims=True))


def shade(N, k_d, k_s, n, I_L, L, V):
    H = L + V
    H = H / np.sqrt(H @ H)
    cosine = (N @ L)[..., None]
    color = k_d * cosine + k_s * np.maximum(N @ H, 0)[..., None] ** n
    return np.where(cosine > 0, np.minimum(I_L * color, 1), 0)


def picture(weights, normals, *rest):
    inside = np.all(weights >= 0, axis=-1, keepdims=True)
    return inside * shade(normal(weights, normals), *rest)
""",
}

UNIT = "N / np.linalg.norm(N)"
SUM = "w[0] * normals[0] + w[1] * normals[1] + w[2] * normals[2]"
H = "(L + V) / np.linalg.norm(L + V)"
ALL = "np.clip(I_L * (k_d * cosine + k_s * highlight), 0, 1)"
PIXEL = "shade(normal(w, normals), k_d, k_s, n, I_L, L, V)"
WRONG = {
    "not normalised": ([(UNIT, "N")], "shorter than 1"),
    "columns": ([(SUM, "normals @ w")], "by columns"),
    "no weights": ([(SUM, "normals.sum(axis=0)")], "weights are missing"),
    "nearest": ([(SUM, "normals[np.argmax(w)]")], "nearest vertex"),
    "sum of components": ([(UNIT, "N / np.sum(N)")], "sum of its components"),
    "no root": ([(UNIT, "N / (N @ N)")], "root is missing"),
    "R.V": ([("max(N @ H, 0)", "max((2 * cosine * N - L) @ V, 0)")], "R·V would put it"),
    "H too long": ([(H, "L + V")], "too strong"),
    "H too short": ([(H, "(L + V) / 2")], "too short"),
    "V.H": ([("N @ H", "V @ H")], "V·H"),
    "no exponent": ([(" ** n", "")], "exponent n is missing"),
    "no highlight": ([(" + k_s * highlight", "")], "highlight is missing"),
    "k_d and k_s exchanged": ([("k_d * cosine + k_s", "k_s * cosine + k_d")], "exchanged"),
    "one reflectance": ([("k_s * highlight", "k_d * highlight")], "of its own, k_s"),
    "no intensity": ([("I_L * (k_d", "(k_d")], "intensity is missing"),
    "no N.L": ([("k_d * cosine", "k_d")], "N·L is missing"),
    "N.L for both": ([("(k_d * cosine + k_s * highlight)", "cosine * (k_d + k_s * highlight)")], "no N·L"),
    "no clamp": ([(ALL, "I_L * (k_d * cosine + k_s * highlight)")], "exceed 1"),
    "highlight behind": (
        [("    if cosine <= 0:\n        return np.zeros(3)\n", "    cosine = max(cosine, 0)\n")],
        "gets no light",
    ),
    "not tested": ([("    if cosine <= 0:\n        return np.zeros(3)\n", "")], "both terms are 0"),
    "Gouraud": ([(PIXEL, "w @ [shade(N, k_d, k_s, n, I_L, L, V) for N in normals]")], "This is Gouraud shading"),
    "flat": ([(PIXEL, "shade(normals[2], k_d, k_s, n, I_L, L, V)")], "This is flat shading"),
    "short normals": ([(PIXEL, PIXEL.replace("normal(w, normals)", "w @ normals"))], "not a unit vector"),
    "all pixels": ([("min(w) >= 0", "True")], "outside are painted"),
    "upside down": ([("image[row, column]", "image[-1 - row, column]")], "on its head"),
}
