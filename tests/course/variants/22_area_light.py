RIGHT = {
    "with loops": """
import math

RATIO = 4.0


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def grid(C, u, v, m):
    return [
        [C[c] + (2 * i + 1) * u[c] / (2 * m) + (2 * j + 1) * v[c] / (2 * m) for c in range(3)]
        for i in range(m)
        for j in range(m)
    ]


def piece(x, N, y, N_y, A):
    way = [q - p for p, q in zip(x, y)]
    here, there = dot(N, way), -dot(N_y, way)
    if here <= 0 or there <= 0:
        return 0
    return A * here * there / dot(way, way) ** 2


def irradiance(x, N, C, u, v, m):
    across = cross(u, v)
    A = math.sqrt(dot(across, across))
    normal = [c / A for c in across]
    return sum(piece(x, N, y, normal, A) for y in grid(C, u, v, m)) / (m * m)


def exact(x, N, corners):
    r = [[c - o for c, o in zip(corner, x)] for corner in corners]
    E = 0
    for a, b in zip(r, r[1:] + r[:1]):
        n = cross(b, a)
        length = math.sqrt(dot(n, n))
        E += math.atan2(length, dot(a, b)) * dot(N, n) / length
    return 0.5 * E
""",
    "with arrays": """
import numpy as np

RATIO = 2**2


def grid(C, u, v, m):
    s = (np.arange(m) + 0.5) / m
    i, j = np.meshgrid(s, s, indexing="ij")
    return C + i.reshape(-1, 1) * u + j.reshape(-1, 1) * v


def piece(x, N, y, N_y, A):
    way = np.asarray(y) - x
    squared = np.sum(way * way, axis=-1)
    return A * np.maximum(way @ N, 0) * np.maximum(-(way @ N_y), 0) / squared**2


def irradiance(x, N, C, u, v, m):
    normal = np.cross(u, v)
    area = np.sqrt(normal @ normal)
    return piece(x, N, grid(C, u, v, m), normal / area, area).mean()


def exact(x, N, corners):
    r = corners - x
    r = r / np.linalg.norm(r, axis=1)[:, None]
    s = np.roll(r, -1, axis=0)
    n = np.cross(r, s)
    sine = np.linalg.norm(n, axis=1)
    angle = np.arctan2(sine, np.einsum("ij,ij->i", r, s))
    return -np.sum(angle * (n @ N) / sine) / 2
""",
}

POINT = "C + (i + 0.5) / m * u + (j + 0.5) / m * v"
E = "A * max(np.dot(N, L), 0) * max(np.dot(N_y, -L), 0) / d**2"
SUM = "piece(x, N, y, across / A, A / m**2)"
WRONG = {
    "corners of the pieces": ([("(i + 0.5)", "i"), ("(j + 0.5)", "j")], "corners of the pieces"),
    "edge to edge": ([(POINT, "C + i / max(m - 1, 1) * u + j / max(m - 1, 1) * v")], "half a piece only"),
    "other order": ([(POINT, "C + (j + 0.5) / m * u + (i + 0.5) / m * v")], "order is the other way"),
    "no corner": ([(POINT, POINT[4:])], "C is missing"),
    "middle": ([(POINT, "C + ((i + 0.5) / m - 0.5) * u + ((j + 0.5) / m - 0.5) * v")], "not its middle"),
    "one row": ([("    return np.array(points)", "    return np.mean(points, axis=0)")], "expected: a"),
    "no distance": ([(E, E.replace(" / d**2", ""))], "distance does not count"),
    "not squared": ([(E, E.replace("d**2", "d"))], "square of the distance"),
    "not normalised": ([("L = (y - x) / d", "L = y - x")], "distance does not count"),
    "no area": ([(E, E.replace("A * ", ""))], "A is missing"),
    "no cosine of the lamp": ([(E, E.replace(" * max(np.dot(N_y, -L), 0)", ""))], "lamp's own cosine is missing"),
    "no cosine of the surface": ([(E, E.replace(" * max(np.dot(N, L), 0)", ""))], "cosine at the surface is missing"),
    "form factor": ([(E, E + " / np.pi")], "form factor"),
    "wrong side": ([("np.dot(N_y, -L)", "np.dot(N_y, L)")], "side of its normal"),
    "no maximum": ([(E, "A * np.dot(N, L) * np.dot(N_y, -L) / d**2")], "out of nothing"),
    "one maximum": ([(E, "A * max(np.dot(N, L) * np.dot(N_y, -L), 0) / d**2")], "two negative cosines"),
    "absolute": ([(E, "A * abs(np.dot(N, L) * np.dot(N_y, -L)) / d**2")], "shines through"),
    "two-sided lamp": ([(E, "A * max(np.dot(N, L), 0) * abs(np.dot(N_y, L)) / d**2")], "one side alone"),
    "whole area each": ([("A / m**2)", "A)")], "more pieces must not"),
    "m pieces": ([("A / m**2)", "A / m)")], "m² pieces"),
    "mean of shares": ([("    return total\n", "    return total / m**2\n")], "counts twice"),
    "one light": ([("in grid(C, u, v, m):", "in grid(C, u, v, 1):"), ("A / m**2)", "A)")], "in the middle of the lamp"),
    "v x u": ([("np.cross(u, v)", "np.cross(v, u)")], "side of u x v"),
    "long normal": ([("across / A, A", "across, A")], "must be a unit vector"),
    "rectangle": (
        [("across / A, A / m**2", "across / A, np.linalg.norm(u) * np.linalg.norm(v) / m**2")],
        "of a rectangle",
    ),
    "maximum of the sum": (
        [
            (
                "total += " + SUM,
                "total += A / m**2 * np.dot(N, y - x) * np.dot(across / A, x - y) / np.dot(y - x, y - x) ** 2",
            ),
            ("    return total\n", "    return max(total, 0)\n"),
        ],
        "each piece needs its own",
    ),
    "sign": ([("np.cross(b, a)", "np.cross(a, b)")], "order of the two vectors"),
    "no half": ([("return total / 2", "return total")], "1/2 is missing"),
    "open": ([("in range(len(corners))", "in range(len(corners) - 1)")], "last side is missing"),
    "long cross product": (
        [("across / np.linalg.norm(across))", "across / (np.linalg.norm(a) * np.linalg.norm(b)))")],
        "Γ is a unit vector",
    ),
    "cosine": ([("np.arccos(np.dot(a, b)", "(np.dot(a, b)")], "the angle itself"),
    "degrees": ([("angle = np.arccos(", "angle = 180 / np.pi * np.arccos(")], "in degrees"),
    "from the origin": ([("corners[k] - x", "corners[k]"), ("% len(corners)] - x", "% len(corners)]")], "subtract x"),
    "ratio": ([("RATIO = 4", "RATIO = 2")], "better than that"),
}
