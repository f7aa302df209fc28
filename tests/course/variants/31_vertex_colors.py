# ruff: noqa: E501
RIGHT = {
    "with a matrix": """
import numpy as np


def at_vertices(corners, A, B, count):
    M = (corners[None] == np.arange(count)[:, None, None]).any(axis=2) * A
    return M @ B / M.sum(axis=1)[:, None]


def toned(B, white):
    return np.clip(B / white, 0, 1) ** (5 / 11)


def bake(corners, A, B, count, white):
    return np.exp(np.log(np.clip(at_vertices(corners, A, B, count) / white, 1e-300, 1)) / 2.2)
""",
    "vertex by vertex": """
def at_vertices(corners, A, B, count):
    result = []
    for v in range(count):
        mine = [i for i in range(len(A)) if v in corners[i]]
        whole = sum(A[i] for i in mine)
        result.append([sum(A[i] * B[i][c] for i in mine) / whole for c in range(3)])
    return result


def toned(B, white):
    return [[min(x / white, 1.0) ** (1 / 2.2) for x in row] for row in B]


def bake(corners, A, B, count, white):
    return toned(at_vertices(corners, A, B, count), white)
""",
}

MEAN = "total / areas[:, None]"
TONE = "np.minimum(B / white, 1) ** (1 / 2.2)"
BAKED = "toned(at_vertices(corners, A, B, count), white)"
WRONG = {
    "plain mean": ([("A[i] * B[i]", "B[i]"), ("areas[v] += A[i]", "areas[v] += 1")], "large patches should count"),
    "not divided": ([(MEAN, "total")], "sum of the areas is missing"),
    "sum": ([("A[i] * B[i]", "B[i]"), (MEAN, "total")], "sum of the patches' radiosities"),
    "divided by the area": ([("A[i] * B[i]", "B[i] / A[i]"), ("areas[v] += A[i]", "areas[v] += 1 / A[i]")], "Small patches count more"),
    "all areas": ([(MEAN, "total / A.sum()")], "of all patches"),
    "number of patches": ([("areas[v] += A[i]", "areas[v] += 1")], "number of patches"),
    "overwritten": ([("total[v] += A[i] * B[i]", "total[v] = B[i]"), (MEAN, "total")], "overwritten"),
    "the sum overwritten": ([("total[v] += ", "total[v] = ")], "For each vertex add"),
    "integer": ([("np.zeros((count, 3))", "np.zeros((count, 3), int)"), ("total[v] += A[i] * B[i]", "total[v] += (A[i] * B[i]).astype(int)")], "For each vertex add"),
    "gamma inverted": ([("(1 / 2.2)", "2.2")], "power is 2.2 here"),
    "no gamma": ([(" ** (1 / 2.2)", "")], "1 / gamma is missing"),
    "integer gamma": ([("(1 / 2.2)", "(1 // 2.2)")], "cut off at 1"),
    "not cut off": ([("np.minimum(B / white, 1)", "(B / white)")], "exceed 1"),
    "no white": ([("B / white, 1", "B, 1")], "white is missing"),
    "cut off first": ([("np.minimum(B / white, 1)", "(np.minimum(B, 1) / white)")], "first, then cut off at 1"),
    "times white": ([("B / white", "B * white")], "Divide by white"),
    "brightest is white": ([(TONE, "(B / B.max()) ** (1 / 2.2)")], "brightest place"),
    "square root": ([("(1 / 2.2)", "(1 / 2)")], "square root"),
    "colours averaged": ([(BAKED, "at_vertices(corners, A, toned(B, white), count)")], "were averaged"),
    "cut off before the mean": ([(BAKED, "toned(at_vertices(corners, A, np.minimum(B, white), count), white)")], "before the mean"),
    "no tone": ([(BAKED, "at_vertices(corners, A, B, count)")], "tone is missing"),
    "white not used": ([(BAKED, "toned(at_vertices(corners, A, B, count), 1)")], "white is not used"),
    "twice": ([(BAKED, "toned(toned(at_vertices(corners, A, B, count), white), 1)")], "applied twice"),
}  # fmt: skip
