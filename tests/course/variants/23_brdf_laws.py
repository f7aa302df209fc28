RIGHT = {
    "with loops": """
import math

ALBEDO = 1.5707963
LARGEST = [0.31830989]


def breach(f):
    n = len(f)
    return max(abs(f[i][j] - f[j][i]) for i in range(n) for j in range(n))


def albedo(f):
    a, b = len(f), len(f[0])
    total = 0
    for i in range(a):
        for j in range(b):
            theta = math.pi * (2 * i + 1) / (4 * a)
            total += f[i][j] * math.sin(2 * theta) / 2
    return total * math.pi**2 / (a * b)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def phong(N, L, V, k_s, n):
    cosine = 2 * dot(N, L) * dot(N, V) - dot(L, V)
    if min(dot(N, L), dot(N, V), cosine) <= 0:
        return 0
    return k_s * (n / 2 + 1) / math.pi * cosine**n
""",
    "with arrays": """
import numpy as np

LARGEST = np.float32(1 / np.pi)
ALBEDO = 0.5 / LARGEST


def breach(f):
    return (f - np.transpose(f)).max()


def albedo(f):
    theta = np.linspace(0, np.pi / 2, 2 * len(f) + 1)[1::2]
    weights = np.cos(theta) * np.sin(theta)
    return weights @ f.mean(axis=1) / len(f) * np.pi**2


def phong(N, L, V, k_s, n):
    S = (N @ L) * N - L
    R = (N @ L) * N + S
    both = (N @ L > 0) & (N @ V > 0)
    return np.where(both, k_s * (n + 2) / (2 * np.pi) * np.clip(R @ V, 0, 1) ** n, 0)
""",
}

BREACH = "np.max(np.abs(f - f.T))"
CELL = " * np.cos(theta) * np.sin(theta) * d_theta * d_phi"
LOBE = "k_s * (n + 2) / (2 * np.pi) * max(np.dot(R, V), 0) ** n"
TESTS = "    if np.dot(N, L) <= 0 or np.dot(N, V) <= 0:\n        return 0.0\n"
WRONG = {
    "albedo of f": ([("ALBEDO = np.pi / 2", "ALBEDO = 0.5")], "is not 1"),
    "albedo at most 1": ([("ALBEDO = np.pi / 2", "ALBEDO = 1")], "can be more than 1"),
    "rounded": ([("ALBEDO = np.pi / 2", "ALBEDO = 1.57")], "ALBEDO"),
    "f is a share": ([("LARGEST = 1 / np.pi", "LARGEST = 1")], "1/sr"),
    "no cosine in the hemisphere": ([("LARGEST = 1 / np.pi", "LARGEST = 1 / (2 * np.pi)")], "halves it"),
    "signs cancel": ([(BREACH, "np.sum(f - f.T)")], "cancel"),
    "mean": ([(BREACH, "np.mean(np.abs(f - f.T))")], "not the mean"),
    "sum": ([(BREACH, "np.sum(np.abs(f - f.T))")], "not their sum"),
    "range": ([(BREACH, "f.max() - f.min()")], "exchanged directions"),
    "turned round": ([(BREACH, "np.max(np.abs(f - f[::-1, ::-1]))")], "turned round"),
    "relative": ([(BREACH, "np.max(np.abs(f - f.T) / np.maximum(f, f.T))")], "not relative"),
    "a table": ([(BREACH, "np.abs(f - f.T)")], "expected: a number"),
    "no sine": ([("np.sin(theta)", "1")], "sin θ is missing"),
    "no cosine": ([("np.cos(theta)", "1")], "cos θ is missing"),
    "no weights": ([(CELL, " * d_theta * d_phi")], "cos θ and sin θ are missing"),
    "no cells": ([(" * d_theta * d_phi", "")], "dθ dφ"),
    "half a turn in theta": (
        [("np.pi / 2 / rows", "np.pi / rows"), ("(i + 0.5) * d_theta", "(i + 0.5) * d_theta / 2")],
        "dθ is too large",
    ),
    "half a turn in phi": ([("2 * np.pi / columns", "np.pi / columns")], "dφ is too small"),
    "beginning of a cell": ([("(i + 0.5)", "i")], "beginning of a cell"),
    "end of a cell": ([("(i + 0.5)", "(i + 1)")], "end of a cell"),
    "rows and columns": (
        [("rows, columns = f.shape", "columns, rows = f.shape"), ("for i in range(rows)", "for i in range(columns)")],
        "Add up",
    ),
    "divided by pi": ([("return total", "return total / np.pi")], "no π to divide by"),
    "mean of f": ([("    return total", "    return f.mean() * np.pi")], "count less"),
    "not normalised": ([(LOBE, "k_s * max(np.dot(R, V), 0) ** n")], "factor that normalises"),
    "parentheses": ([("/ (2 * np.pi)", "/ 2 * np.pi")], "below the fraction bar"),
    "n + 1": ([("(n + 2)", "(n + 1)")], "n + 1 normalises"),
    "lecture's lobe": ([(LOBE, LOBE + " / np.dot(N, L)")], "lecture's lobe"),
    "times the cosine": ([(LOBE, LOBE + " * np.dot(N, L)")], "sum over the lights"),
    "no k_s": ([("k_s * (n", "(n")], "k_s is missing"),
    "R's sign": ([("2 * np.dot(N, L) * N - L", "L - 2 * np.dot(N, L) * N")], "look at its sign"),
    "L.V": ([("np.dot(R, V)", "np.dot(L, V)")], "mirror L first"),
    "N.H": ([("np.dot(R, V)", "np.dot(N, (L + V) / np.linalg.norm(L + V))")], "This is N·H"),
    "no tests": ([(TESTS, "")], "test N·L and N·V"),
    "no test of the eye": ([(" or np.dot(N, V) <= 0", "")], "test N·V, too"),
    "no test of the light": ([("np.dot(N, L) <= 0 or ", "")], "test N·L, too"),
    "no maximum": ([("max(np.dot(R, V), 0)", "np.dot(R, V)")], "max(R·V, 0)"),
}
