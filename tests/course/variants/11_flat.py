# ruff: noqa: E501
RIGHT = {
    "one by one": """
import math


def provoking(primitive, n):
    found = []
    for k in range(n):
        if primitive == "GL_TRIANGLES" and k % 3 == 2:
            found.append(k)
        if primitive in ("GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN") and k >= 2:
            found.append(k)
        if primitive == "GL_QUADS" and k % 4 == 3:
            found.append(k)
        if primitive == "GL_QUAD_STRIP" and k >= 3 and k % 2 == 1:
            found.append(k)
    return 0 if primitive == "GL_POLYGON" else found


def flat(P, N, k_d, I_L, light):
    d = [light[i] - P[-1][i] for i in range(3)]
    cosine = sum(N[-1][i] * d[i] for i in range(3)) / math.hypot(*d)
    return [min(1.0, I_L[c] * k_d[c] * max(cosine, 0.0)) for c in range(3)]


def strip(P, colors, width, height):
    def weights(x, y, A, B, C):
        d = (B[1] - C[1]) * (A[0] - C[0]) + (C[0] - B[0]) * (A[1] - C[1])
        u = ((B[1] - C[1]) * (x - C[0]) + (C[0] - B[0]) * (y - C[1])) / d
        v = ((C[1] - A[1]) * (x - C[0]) + (A[0] - C[0]) * (y - C[1])) / d
        return u, v, 1 - u - v

    def color(x, y):
        for k in range(len(P) - 1, 1, -1):
            if min(weights(x, y, P[k - 2], P[k - 1], P[k])) >= 0:
                return list(colors[k])
        return [0, 0, 0]

    return [[color(c + 0.5, r + 0.5) for c in range(width)] for r in range(height)]
""",
    "with arrays": """
import numpy as np


def provoking(primitive, n):
    v = np.arange(n)
    if primitive == "GL_TRIANGLES":
        return v[2::3]
    if primitive == "GL_QUADS":
        return v[3::4]
    if primitive == "GL_QUAD_STRIP":
        return v[3::2]
    return v[:1] if primitive == "GL_POLYGON" else v[2:]


def flat(P, N, k_d, I_L, light):
    L = (light - P) / np.linalg.norm(light - P, axis=1)[:, None]
    cosine = np.maximum(np.sum(N * L, axis=1), 0)
    return np.minimum(cosine[:, None] * I_L * k_d, 1)[2]


def strip(P, colors, width, height):
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    image = np.zeros((height, width, 3))
    for A, B, C, color in zip(P, P[1:], P[2:], colors[2:]):
        sides = [(b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) for a, b in ((A, B), (B, C), (C, A))]
        image[abs(sum(np.sign(sides))) == 3] = color
    return image
""",
}

COLOR = "np.clip(I_L * k_d * max(N[2] @ L, 0), 0, 1)"
FACET = "np.cross(P[1] - P[0], P[2] - P[0])"
SHADED = """def shaded(P, N, k_d, I_L, light):
    L = (light - P) / np.linalg.norm(light - P)
    return np.clip(I_L * k_d * max(N @ L, 0), 0, 1)


"""
BY_FIRST = "    if 'FAN' in primitive:\n        return [0] * (n - 2)\n    return list(range(first"
WRONG = {
    "first vertex": (
        [("(2, 3)", "(0, 3)"), ("(3, 4)", "(0, 4)"), ("range(first, n, step)", "range(first, n - 2 - (step == 4), step)")],
        "These are the first vertices",
    ),
    "counted from 1": ([("list(range(first, n, step))", "list(range(first + 1, n + 1, step))")], "counted from 1"),
    "quads as triangles": ([("(3, 4)", "(2, 3)")], "expected: a number"),
    "fan": ([("    return list(range(first", BY_FIRST)], "all the same colour"),
    "quad strip": ([("(3, 2)", "(2, 2)"), ("range(first, n,", "range(first, n - (step == 2),")], "new pair is sent last"),
    "polygon": ([("return [0]", "return [n - 1]")], "is the exception"),
    "first normal": ([("P[2]", "P[0]"), ("N[2]", "N[0]")], "at the first vertex"),
    "mixed": ([("P[2]", "P[0]")], "different vertices"),
    "mean": ([("def flat", SHADED + "def flat"), (COLOR, "np.mean([shaded(P[k], N[k], k_d, I_L, light) for k in range(3)], axis=0)")],
             "mean of three colours"),
    "facet normal": ([("N[2] @ L", f"{FACET} @ L / np.linalg.norm({FACET})")], "normal of the plane"),
    "middle": ([("P[2]", "P.mean(axis=0)")], "triangle's middle"),
    "L not a unit vector": ([("    L = L / np.linalg.norm(L)\n", "")], "not a unit vector"),
    "position as direction": ([("light - P[2]", "light")], "used as its direction"),
    "no k_d": ([("I_L * k_d *", "I_L *")], "k_d is missing"),
    "no I_L": ([("I_L * k_d *", "k_d *")], "intensity is missing"),
    "no clamp": ([(COLOR, "I_L * k_d * max(N[2] @ L, 0)")], "exceed 1"),
    "no maximum": ([(COLOR, "np.minimum(I_L * k_d * (N[2] @ L), 1)")], "less than none"),
    "absolute value": ([("max(N[2] @ L, 0)", "abs(N[2] @ L)")], "shines through"),
    "strip by first": ([("colors[k + 2]", "colors[k]")], "colour of its first vertex"),
    "strip by second": ([("colors[k + 2]", "colors[k + 1]")], "colour of its second vertex"),
    "one winding": ([("min(sides) > 0 or max(sides) < 0", "max(sides) < 0")], "Every second triangle"),
    "pixel corners": ([("(column + 0.5, row + 0.5)", "(column, row)")], "pixels' corners"),
    "x and y": ([("(column + 0.5, row + 0.5)", "(row + 0.5, column + 0.5)")], "exchanged"),
    "upside down": ([("image[row, column]", "image[-1 - row, column]")], "on its head"),
    "one triangle": ([("range(len(P) - 2)", "range(1)")], "first triangle"),
    "painted once": ([("range(len(P) - 2)", "reversed(range(len(P) - 2))")], "later one must be seen"),
}  # fmt: skip
