# ruff: noqa: E501
RIGHT = {
    "by the detour": """
import numpy as np


def jump(A, B, M, I_A, I_B, I_M):
    a, b = np.linalg.norm(M - A), np.linalg.norm(M - B)
    return I_M - (b * I_A + a * I_B) / (a + b)


def fan(polygon):
    p = np.array(polygon)
    return np.stack([np.repeat(p[0], len(p) - 2), p[1:-1], p[2:]], axis=1)


def mended(P, polygon, m):
    A = P[polygon]
    B = np.roll(A, -1, axis=0)
    t = ((P[m] - A) * (B - A)).sum(axis=1) / ((B - A) ** 2).sum(axis=1)
    away = np.linalg.norm(A + np.clip(t, 0, 1)[:, None] * (B - A) - P[m], axis=1)
    return np.concatenate([[m], np.roll(polygon, -1 - np.argmin(away))])
""",
    "with lists": """
import math


def jump(A, B, M, I_A, I_B, I_M):
    t = math.dist(A, M) / math.dist(A, B)
    return [m - a - t * (b - a) for a, b, m in zip(I_A, I_B, I_M)]


def fan(polygon):
    first, *rest = polygon
    return [(first, b, c) for b, c in zip(rest, rest[1:])]


def mended(P, polygon, m):
    turned = list(polygon)
    while abs(math.dist(P[turned[-1]], P[m]) + math.dist(P[m], P[turned[0]]) - math.dist(P[turned[-1]], P[turned[0]])) > 1e-9:
        turned = turned[1:] + turned[:1]
    return [m] + turned
""",
}

PLACE = "np.linalg.norm(M - A) / np.linalg.norm(B - A)"
JUMP = "I_M - ((1 - t) * I_A + t * I_B)"
FAN = "[[polygon[0], polygon[k], polygon[k + 1]] for k in range(1, len(polygon) - 1)]"
MENDED = "[m, *polygon[k:], *polygon[:k]]"
WRONG = {
    "midway": ([(PLACE, "0.5")], "not always midway"),
    "sign": ([(JUMP, "((1 - t) * I_A + t * I_B) - I_M")], "other way round"),
    "absolute value": ([(JUMP, "abs(I_M - ((1 - t) * I_A + t * I_B))")], "may be negative"),
    "ends exchanged": ([(JUMP, "I_M - (t * I_A + (1 - t) * I_B)")], "A and B are exchanged"),
    "sum": ([(JUMP, "I_M - I_A - I_B")], "are added"),
    "distance": ([(PLACE, "np.linalg.norm(M - A)")], "share of the whole edge"),
    "one side": ([(JUMP, "(1 - t) * I_A + t * I_B")], "side without M"),
    "strip": ([(FAN, "[polygon[k : k + 3] for k in range(len(polygon) - 2)]")], "strip of three"),
    "wrong way round": ([(FAN, "[[polygon[0], polygon[k + 1], polygon[k]] for k in range(1, len(polygon) - 1)]")], "back faces"),
    "round the last": ([(FAN, "[[polygon[-1], polygon[k], polygon[k + 1]] for k in range(len(polygon) - 2)]")], "round the last vertex"),
    "places": ([(FAN, "[[0, k, k + 1] for k in range(1, len(polygon) - 1)]")], "places in the list"),
    "one triangle short": ([("range(1, len(polygon) - 1)", "range(1, len(polygon) - 2)")], "expected: a 2 x 3 array"),
    "not first": ([(MENDED, "[*polygon[:k], m, *polygon[k:]]")], "does not begin with it"),
    "in front": ([(MENDED, "[m, *polygon]")], "before the first one"),
    "at the end": ([(MENDED, "[*polygon, m]")], "at the end"),
    "back face": ([(MENDED, "[m, *[*polygon[k:], *polygon[:k]][::-1]]")], "would be a back face"),
    "too late": ([(MENDED, "[m, *polygon[k + 1 :], *polygon[: k + 1]]")], "too late"),
    "line without ends": ([(" and (A - P[m]) @ (B - P[m]) < 0", "")], "beyond its ends"),
    "any line": ([("on_the_line and (A", "(A")], "Look for the edge"),
    "no vertex": ([(MENDED, "polygon")], "expected: 5 numbers"),
}  # fmt: skip
