RIGHT = {
    "by geometry": """
import numpy as np


def meet(O, D, C, r):
    to_center = C - O
    along = to_center @ D
    aside = to_center - along * D
    half = r**2 - aside @ aside
    if half < 0:
        return -1
    near, far = along - half**0.5, along + half**0.5
    return near if near > 0 else far if far > 0 else -1


def in_shadow(P, lamp, C, r):
    # the point of the segment that is closest to the centre
    way = lamp - P
    share = min(max(((C - P) @ way) / (way @ way), 0), 1)
    return np.linalg.norm(P + share * way - C) < r


def bounce(O, D, C, r):
    P = O + D * meet(O, D, C, r)
    N = (P - C) / np.linalg.norm(P - C)
    L = -D
    S = (N @ L) * N - L
    return [P, (N @ L) * N + S]
""",
    "by the formula for roots": """
import math


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def meet(O, D, C, r):
    oc = [o - c for o, c in zip(O, C)]
    a, b, c = dot(D, D), 2 * dot(oc, D), dot(oc, oc) - r**2
    d = b**2 - 4 * a * c
    if d < 0:
        return -1.0
    positive = [t for t in ((-b - math.sqrt(d)) / (2 * a), (-b + math.sqrt(d)) / (2 * a)) if t > 1e-9]
    return min(positive, default=-1.0)


def in_shadow(P, lamp, C, r):
    L = [b - a for a, b in zip(P, lamp)]
    return float(0 < meet(P, L, C, r) < 1)


def bounce(O, D, C, r):
    t = meet(O, D, C, r)
    P = [o + t * d for o, d in zip(O, D)]
    N = [(p - c) / r for p, c in zip(P, C)]
    cosine = dot(D, N)
    return [P, [d - 2 * cosine * n for d, n in zip(D, N)]]
""",
}

UNDER = "b * b - (np.dot(O - C, O - C) - r * r)"
NEAR = "    if -b - root > 0:\n        return -b - root\n"
FAR = "    if -b + root > 0:\n        return -b + root\n"
MISS = "    if under < 0:\n        return -1.0\n"
SEEN = "1 if 0 < t < distance else 0"
MIRROR = "D - 2 * np.dot(D, N) * N"
WRONG = {
    "sign under the root": ([(UNDER, "np.dot(O - C, O - C) - r * r - b * b")], "what is under the root"),
    "far root": ([(NEAR, "")], "leaves the sphere"),
    "sign of b": ([("-b - root", "b - root"), ("-b + root", "b + root")], "signs of b"),
    "closest to the centre": ([("root = np.sqrt(under)", "root = 0")], "closest to the centre"),
    "through the centre": (
        [("    b = np.dot(O - C, D)\n", "    return np.linalg.norm(C - O) - r\n    b = 0\n")],
        "alone",
    ),
    "radius not squared": ([("- r * r)", "- r)")], "radius is squared"),
    "no centre": (
        [("b = np.dot(O - C, D)", "b = np.dot(O, D)"), ("np.dot(O - C, O - C)", "np.dot(O, O)")],
        "C is missing",
    ),
    "no root": ([("np.sqrt(under)", "under")], "root is missing"),
    "four c": (
        [("b = np.dot(O - C, D)", "b = 2 * np.dot(O - C, D)"), ("- (np.dot", "- 4 * (np.dot")],
        "twice too large",
    ),
    "half": ([("return -b - root", "return (-b - root) / 2")], "half of what"),
    "negative under the root": ([(MISS, "    under = max(under, 0)\n")], "taken for 0"),
    "NaN": (
        [(MISS + "    root = np.sqrt(under)\n" + NEAR + FAR + "    return -1.0", "    return -b - np.sqrt(under)")],
        "NaN",
    ),
    "0 for a miss": ([(MISS, "    if under < 0:\n        return 0.0\n")], "gives 0"),
    "behind": ([(NEAR + FAR + "    return -1.0", "    return -b - root")], "lies behind the eye"),
    "absolute": ([(NEAR + FAR + "    return -1.0", "    return abs(-b - root)")], "absolute value"),
    "inside": ([(FAR, "")], "from within"),
    "nearest by size": (
        [
            (
                NEAR + FAR + "    return -1.0",
                "    return min(abs(-b - root), abs(-b + root)) if b < 0 or under > b * b else -1.0",
            )
        ],
        "may be behind O",
    ),
    "shadow of all": ([(SEEN, "1 if t > 0 else 0")], "farther away than the lamp"),
    "shadow of the missed": ([(SEEN, "1 if t < distance else 0")], "not met at all"),
    "shadow compared with 1": ([(SEEN, "1 if 0 < t < 1 else 0")], "not with 1"),
    "shadow not normalised": ([("(lamp - P) / distance", "lamp - P")], "no unit vector"),
    "shadow exchanged": ([(SEEN, "0 if 0 < t < distance else 1")], "1 is shadow"),
    "shadow ray away": ([("L = (lamp - P)", "L = (P - lamp)")], "away from the lamp"),
    "no shadow": ([(SEEN, "0")], "Nothing casts"),
    "into the sphere": ([(MIRROR, "2 * np.dot(D, N) * N - D")], "goes into the sphere"),
    "back": ([(MIRROR, "-D")], "where it came from"),
    "through": ([(MIRROR, "D")], "goes on through"),
    "normal": ([(MIRROR, "N")], "This is the normal"),
    "once": ([(MIRROR, "D - np.dot(D, N) * N")], "subtracted twice"),
    "long normal": ([("(P - C) / r", "P - C")], "as long as the radius"),
    "normal of the origin": ([("(P - C) / r", "P / np.linalg.norm(P)")], "around the origin"),
    "no O": ([("    return np.array([P, ", "    return np.array([P - O, ")], "O is missing"),
    "one row": ([("np.array([P, " + MIRROR + "])", MIRROR)], "3 numbers; expected: a 2 x 3 array"),
}
