RIGHT = {
    "by the angle": """
import math


def attenuation(d, k_0, k_1, k_2):
    return 1 / ((k_2 * d + k_1) * d + k_0)


def length(v):
    return math.sqrt(sum(x * x for x in v))


def spot(L, S, cutoff, e):
    if cutoff > 90:
        return 1
    cosine = -sum(a * b for a, b in zip(L, S)) / length(L) / length(S)
    angle = math.degrees(math.acos(max(-1, min(1, cosine))))
    return math.cos(math.radians(angle)) ** e if angle <= cutoff else 0


def lamp(P, lamp, k, S, cutoff, e):
    x, y, z, w = lamp
    if w == 0:
        return spot((x, y, z), S, cutoff, e)
    L = (x - P[0], y - P[1], z - P[2])
    return spot(L, S, cutoff, e) * attenuation(length(L), k[0], k[1], k[2])
""",
    "with arrays": """
import numpy as np


def attenuation(d, k_0, k_1, k_2):
    return np.reciprocal(np.polyval([k_2, k_1, k_0], d))


def spot(L, S, cutoff, e):
    cosine = np.maximum(-L @ S, 0)
    inside = cosine >= np.cos(np.deg2rad(cutoff))
    return np.where(cutoff == 180, 1, inside * cosine**e)


def lamp(P, lamp, k, S, cutoff, e):
    L = lamp[:3] - lamp[3] * P
    d = np.sqrt(L @ L)
    fade = attenuation(d, *k) if lamp[3] else 1
    return np.array([fade * spot(L / d, S / np.sqrt(S @ S), cutoff, e)])
""",
}

FADE = "1 / (k_0 + k_1 * d + k_2 * d**2)"
SUN = "    if lamp[3] == 0:\n        L = lamp[:3] / np.linalg.norm(lamp[:3])\n        return spot(L, S, cutoff, e)\n"
WRONG = {
    "stronger": ([(FADE, "k_0 + k_1 * d + k_2 * d**2")], "divisor itself"),
    "not squared": ([("k_2 * d**2", "k_2 * d")], "square of the distance"),
    "k squared": ([("k_2 * d**2", "(k_2 * d) ** 2")], "not k_2"),
    "exchanged": ([(FADE, "1 / (k_2 + k_1 * d + k_0 * d**2)")], "k_0 and k_2 are exchanged"),
    "no parentheses": ([(FADE, "1 / k_0 + k_1 * d + k_2 * d**2")], "parentheses"),
    "clamped": ([(FADE, "min(1, " + FADE + ")")], "clamped to 1"),
    "square law": ([(FADE, "1 / d**2")], "nature's law"),
    "integer": ([(FADE, "1 // (k_0 + k_1 * d + k_2 * d**2)")], "1 divided by a polynomial"),
    "sign of L": ([("np.dot(-L, S)", "np.dot(L, S)")], "L·S = -1"),
    "no exponent": ([("return cosine**e", "return cosine")], "exponent is missing"),
    "no fall-off": ([("return cosine**e", "return 1.0")], "darker"),
    "factor": ([("return cosine**e", "return e * cosine")], "not a factor"),
    "radians": ([("np.cos(np.radians(cutoff))", "np.cos(cutoff)")], "in degrees"),
    "cosine with angle": ([("np.cos(np.radians(cutoff))", "np.radians(cutoff)")], "cosine with cosine"),
    "whole angle": ([("np.radians(cutoff)", "np.radians(cutoff / 2)")], "not the whole angle"),
    "no edge": (
        [
            (
                "    if cosine < np.cos(np.radians(cutoff)):\n        return 0.0\n    return cosine**e",
                "    return max(cosine, 0) ** e",
            )
        ],
        "no edge",
    ),
    "two cones": ([("np.dot(-L, S)", "abs(np.dot(L, S))")], "second cone"),
    "180 forgotten": (
        [
            (
                "    if cutoff == 180:\n        return 1.0\n",
                "    if cutoff == 180:\n        return max(np.dot(-L, S), 0) ** e\n",
            )
        ],
        "no spot",
    ),
    "no attenuation": ([("attenuation(d, *k) * spot", "spot")], "attenuation is missing"),
    "no spot": ([("attenuation(d, *k) * spot(L / d, S, cutoff, e)", "attenuation(d, *k)")], "spot is missing"),
    "L not normalised": ([("spot(L / d, S", "spot(L, S")], "L is not normalised"),
    "S not normalised": ([("    S = S / np.linalg.norm(S)\n", "")], "S is not normalised"),
    "from the lamp": ([("L = lamp[:3] - P", "L = P - lamp[:3]")], "from the lamp to P"),
    "normalised too soon": (
        [("    d = np.linalg.norm(L)\n", "    L = L / np.linalg.norm(L)\n    d = np.linalg.norm(L)\n")],
        "1 everywhere",
    ),
    "squared twice": ([("d = np.linalg.norm(L)\n", "d = L @ L\n"), ("L / d", "L / d**0.5")], "take the root"),
    "sum": ([("attenuation(d, *k) * spot", "attenuation(d, *k) + spot")], "not added"),
    "sun is a lamp": ([(SUN, "")], "has no place"),
    "sun fades": (
        [("        return spot(L, S", "        return attenuation(np.linalg.norm(lamp[:3]), *k) * spot(L, S")],
        "no distance",
    ),
    "sun not normalised": ([("L = lamp[:3] / np.linalg.norm(lamp[:3])", "L = lamp[:3]")], "need not be a unit vector"),
    "sun is no spot": ([("        return spot(L, S, cutoff, e)\n", "        return 1.0\n")], "still is a spot"),
}
