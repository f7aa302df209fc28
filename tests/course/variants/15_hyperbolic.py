# ruff: noqa: E501
RIGHT = {
    "by the place on the edge": """
import numpy as np

MIDDLE = np.array([0.25])
MIDDLE_AFFINE = 0.5


def affine(s, f_1, f_2):
    return f_1 + s * (f_2 - f_1)


def hyperbolic(s, f_1, f_2, w_1, w_2):
    t = s * w_1 / (s * w_1 + (1 - s) * w_2)
    return affine(t, f_1, f_2)


def in_triangle(s, f, w):
    far = [s[0] * w[1] * w[2], s[1] * w[0] * w[2], s[2] * w[0] * w[1]]
    return [sum(far[k] * f[k][c] for k in range(3)) / sum(far) for c in range(f.shape[1])]
""",
    "by distance": """
import numpy as np


def affine(s, f_1, f_2):
    return np.dot([1 - s, s], [f_1, f_2])


def hyperbolic(s, f_1, f_2, w_1, w_2):
    w = 1 / ((1 - s) / w_1 + s / w_2)
    return w * ((1 - s) * np.array(f_1) / w_1 + s * np.array(f_2) / w_2)


MIDDLE = hyperbolic(0.5, 0, 1, 1, 3)
MIDDLE_AFFINE = affine(0.5, 0, 1)


def in_triangle(s, f, w):
    return np.average(f, axis=0, weights=np.divide(s, w))
""",
}

AFFINE = "(1 - s) * f_1 + s * f_2"
DEEP = "affine(s, f_1 / w_1, f_2 / w_2) / affine(s, 1 / w_1, 1 / w_2)"
LAST = "share @ f / share.sum()"
WRONG = {
    "the middle is in the middle": ([("MIDDLE = 1 / 4", "MIDDLE = 0.5")], "not reached yet"),
    "the far half": ([("MIDDLE = 1 / 4", "MIDDLE = 0.75")], "still near the beginning"),
    "ratio of distances": ([("MIDDLE = 1 / 4", "MIDDLE = 1 / 3")], "ratio of the distances"),
    "integer division": ([("MIDDLE = 1 / 4", "MIDDLE = 1 // 4")], "Use s = 1/2"),
    "affine is right": ([("MIDDLE_AFFINE = 1 / 2", "MIDDLE_AFFINE = 0.25")], "ignores the distances"),
    "ends exchanged": ([(AFFINE, "s * f_1 + (1 - s) * f_2")], "ends are exchanged"),
    "mean": ([(AFFINE, "(f_1 + f_2) / 2")], "s has to count"),
    "added": ([(AFFINE, "f_1 + s * f_2")], "has to shrink"),
    "nearer end": ([(AFFINE, "f_1 if s < 0.5 else f_2")], "nearer end"),
    "from 0": ([(AFFINE, "s * (f_2 - f_1)")], "begins at 0"),
    "affine": ([(DEEP, "affine(s, f_1, f_2)")], "This is affine"),
    "distances exchanged": ([(DEEP, "affine(s, f_1 / w_2, f_2 / w_1) / affine(s, 1 / w_2, 1 / w_1)")], "distances are exchanged"),
    "multiplied": ([(DEEP, "affine(s, f_1 * w_1, f_2 * w_2) / affine(s, w_1, w_2)")], "multiplied by w: divide"),
    "not divided": ([(DEEP, "affine(s, f_1 / w_1, f_2 / w_2)")], "1 / w is missing"),
    "w interpolated": ([(DEEP, "affine(s, f_1 / w_1, f_2 / w_2) * affine(s, w_1, w_2)")], "w is not linear"),
    "f not divided": ([(DEEP, "affine(s, f_1, f_2) / affine(s, 1 / w_1, 1 / w_2)")], "by their own w"),
    "triangle affine": ([(LAST, "s @ f")], "This is affine"),
    "triangle not divided": ([(LAST, "share @ f")], "sum of s / w is missing"),
    "triangle multiplied": ([("s / w", "s * w")], "multiplied by w"),
    "triangle without s": ([("s / w", "1 / w")], "s are missing"),
    "triangle w interpolated": ([(LAST, "share @ f * (s @ w)")], "w is not linear"),
    "divisor without s": ([(LAST, "share @ f / (1 / w).sum()")], "s belong there"),
    "one value": ([(LAST, "(share @ f / share.sum())[0]")], "gives a number; expected: 2 numbers"),
}  # fmt: skip
