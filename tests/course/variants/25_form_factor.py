RIGHT = {
    "without the root": """
import math


def form_factor(x_i, N_i, x_j, N_j, A_j):
    d = [b - a for a, b in zip(x_i, x_j)]
    rr = sum(c * c for c in d)
    a = max(sum(n * c for n, c in zip(N_i, d)), 0)
    b = max(-sum(n * c for n, c in zip(N_j, d)), 0)
    return a * b * A_j / (math.pi * rr * rr)


def point_to_points(x_i, N_i, points, N_j, A_j):
    return sum(form_factor(x_i, N_i, x, N_j, A_j / len(points)) for x in points)
""",
    "with arrays": """
import numpy as np


def point_to_points(x_i, N_i, points, N_j, A_j):
    d = points - x_i
    r2 = (d * d).sum(axis=1)
    w = d / np.sqrt(r2)[:, None]
    product = np.clip(w @ N_i, 0, None) * np.clip(-(w @ N_j), 0, None)
    return (A_j * product / (np.pi * r2)).mean()


def form_factor(x_i, N_i, x_j, N_j, A_j):
    return point_to_points(x_i, N_i, np.array([x_j]), N_j, A_j)
""",
}

RETURN = "A_j * cos_i * cos_j / (np.pi * r**2)"
TEST = "    if cos_i <= 0 or cos_j <= 0:\n        return 0.0\n"
WRONG = {
    "distance": ([("r**2", "r")], "square of the distance"),
    "not a unit vector": ([("w = d / r", "w = d")], "no cosines"),
    "no pi": ([("np.pi * r**2", "r**2")], "pi is missing"),
    "four pi": ([("np.pi * r**2", "4 * np.pi * r**2")], "point light"),
    "no area": ([(RETURN, "cos_i * cos_j / (np.pi * r**2)")], "A_j is missing"),
    "one cosine": ([(RETURN, "A_j * cos_i / (np.pi * r**2)")], "at the receiving patch"),
    "other cosine": ([(RETURN, "A_j * cos_j / (np.pi * r**2)")], "at the sending patch"),
    "sign": ([("cos_j = -np", "cos_j = np")], "other sign"),
    "no test": ([(TEST, "")], "Test each"),
    "product tested": ([(TEST, "    if cos_i * cos_j <= 0:\n        return 0.0\n")], "not the product"),
    "absolute": ([(TEST, "    cos_i, cos_j = abs(cos_i), abs(cos_j)\n")], "through the back"),
    "middle": (
        [
            (
                "np.mean([form_factor(x_i, N_i, x, N_j, A_j) for x in points])",
                "form_factor(x_i, N_i, points.mean(axis=0), N_j, A_j)",
            )
        ],
        "middle of the patch",
    ),
    "sum": ([("np.mean", "np.sum")], "take the mean"),
}
