RIGHT = {
    "with math": """
import math


def refracted_angle(theta_1, n_1, n_2):
    try:
        return math.degrees(math.asin(n_1 * math.sin(math.radians(theta_1)) / n_2))
    except ValueError:
        return -1


def critical_angle(n_1, n_2):
    return math.degrees(math.asin(n_2 / n_1))


def schlick(cosine, n_1, n_2):
    F_0 = (n_1 - n_2) ** 2 / (n_1 + n_2) ** 2
    return 1 - (1 - F_0) * (1 - (1 - cosine) ** 5)
""",
    "with vectors": """
import numpy as np


def refracted_angle(theta_1, n_1, n_2):
    t = np.deg2rad(theta_1)
    eta = n_1 / n_2
    k = 1 - eta**2 * (1 - np.cos(t) ** 2)
    if k < 0:
        return np.array(-1.0)
    return np.rad2deg(np.arctan2(eta * np.sin(t), np.sqrt(k)))


def critical_angle(n_1, n_2):
    return np.rad2deg(np.arctan2(n_2, np.sqrt(n_1**2 - n_2**2)))


def schlick(cosine, n_1, n_2):
    r = (n_2 - n_1) / (n_2 + n_1)
    return r * r + (1 - r * r) * np.power(1 - cosine, 5)
""",
}

SINE = "n_1 / n_2 * np.sin(np.radians(theta_1))"
WRONG = {
    "exchanged indices": ([(SINE, "min(n_2 / n_1 * np.sin(np.radians(theta_1)), 1.0)")], "exchanged"),
    "angles proportional": ([("return np.degrees(np.arcsin(sine))", "return n_1 / n_2 * theta_1")], "their sines are"),
    "radians out": ([("np.degrees(np.arcsin(sine))", "np.arcsin(sine)")], "in degrees"),
    "sine itself": ([("np.degrees(np.arcsin(sine))", "sine")], "sine of the angle"),
    "degrees into sin": ([(SINE, "np.clip(n_1 / n_2 * np.sin(theta_1), -1, 1)")], "takes radians"),
    "cosines": (
        [(SINE, "n_1 / n_2 * np.cos(np.radians(theta_1))"), ("np.arcsin(sine)", "np.arccos(sine)")],
        "sines, not cosines",
    ),
    "no total reflection": (
        [("    if sine > 1:\n        return -1.0\n", "    sine = min(sine, 1)\n")],
        "not 90 degrees",
    ),
    "NaN": ([("    if sine > 1:\n        return -1.0\n", "")], "NaN"),
    "critical in radians": ([("np.degrees(np.arcsin(n_2 / n_1))", "np.arcsin(n_2 / n_1)")], "in degrees"),
    "critical from the surface": ([("np.arcsin(n_2 / n_1)", "np.arccos(n_2 / n_1)")], "to the normal"),
    "Brewster": ([("np.arcsin(n_2 / n_1)", "np.arctan(n_2 / n_1)")], "Brewster"),
    "no growth": ([("F_0 + (1 - F_0) * (1 - cosine) ** 5", "F_0")], "grazing incidence"),
    "not squared": ([("((n_1 - n_2) / (n_1 + n_2)) ** 2", "abs((n_1 - n_2) / (n_1 + n_2))")], "square of the quotient"),
    "cosine itself": ([("(1 - cosine) ** 5", "cosine ** 5")], "as the cosine falls"),
    "fourth power": ([("** 5", "** 4")], "at normal incidence"),
}
