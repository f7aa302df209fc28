RIGHT = {
    "by the cosine": """
import math


def halfway(L, V):
    # |L + V|^2 = 2 + 2 L.V
    return (L + V) / math.sqrt(2 + 2 * (L @ V))


def highlight(N, L, V, n):
    return max(N @ halfway(L, V), 0) ** n * (N @ L > 0)
""",
    "in steps": """
def halfway(L, V):
    H = [(a + b) / 2 for a, b in zip(L, V)]
    length = sum(h * h for h in H) ** 0.5
    return [h / length for h in H]


def highlight(N, L, V, n):
    if sum(a * b for a, b in zip(N, L)) <= 0:
        return 0
    cosine = sum(a * b for a, b in zip(N, halfway(L, V)))
    if cosine < 0:
        cosine = 0
    return [cosine**n]
""",
}

H, POWER = "total / np.linalg.norm(total)", "max(np.dot(N, H), 0.0) ** n"
WRONG = {
    "no maximum": ([(POWER, "np.dot(N, H) ** n")], "its power is not 0"),
    "absolute value": ([(POWER, "abs(np.dot(N, H)) ** n")], "the absolute value"),
    "not normalised": ([(H, "total")], "divide the sum by its length"),
    "half": ([(H, "total / 2")], "shorter than a unit vector"),
    "difference": ([("L + V", "L - V")], "between them"),
    "sum of components": ([(H, "total / np.sum(total)")], "root of the sum"),
    "squared length": ([(H, "total / np.dot(total, total)")], "take its root"),
    "cross": ([(H, "np.cross(L, V)")], "right angle"),
    "R.V": ([("np.dot(N, H)", "np.dot(2 * np.dot(N, L) * N - L, V)")], "R·V"),
    "H.V": ([("np.dot(N, H)", "np.dot(H, V)")], "slide's slip"),
    "no exponent": ([(POWER, "max(np.dot(N, H), 0.0)")], "exponent n is missing"),
    "factor": ([(POWER, "n * max(np.dot(N, H), 0.0)")], "not a factor"),
    "not normalised inside": ([("H = halfway(L, V)", "H = L + V")], "not normalised"),
    "four n": ([("** n", "** (4 * n)")], "not 4 n"),
    "no test": ([("    if np.dot(N, L) <= 0:\n        return 0.0\n", "")], "Test N·L"),
}
