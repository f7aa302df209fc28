RIGHT = {
    "with loops": """
def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def shadow_matrix(plane, light):
    d = dot(plane, light)
    return [[(d if i == j else 0) - light[i] * plane[j] for j in range(4)] for i in range(4)]


def shadow(plane, light, v):
    M = shadow_matrix(plane, light)
    x, y, z, w = (dot(row, (*v, 1)) for row in M)
    return x / w, y / w, z / w


def sixteen(M):
    return [M[i][j] for j in range(4) for i in range(4)]


def casts(plane, light, v):
    mine, its = dot(plane, (*v, 1)), dot(plane, light)
    if its < 0:
        mine, its = -mine, -its
    return 0 < mine and (light[3] == 0 or mine < its)
""",
    "by the ray": """
import numpy as np


def shadow_matrix(plane, light):
    M = -light[:, None] * plane[None, :]
    M[np.arange(4), np.arange(4)] += plane @ light
    return M


def shadow(plane, light, v):
    N, d = plane[:3], plane[3]
    direction = light[:3] - v if light[3] else light[:3]
    return v - (N @ v + d) / (N @ direction) * direction


def sixteen(M):
    return M.reshape(16, order="F")


def casts(plane, light, v):
    # the plane must be met by the ray that goes on from the light through v
    N, d = plane[:3], plane[3]
    away = v - light[:3] if light[3] else -light[:3]
    t = -(N @ v + d) / (N @ away)
    return int(t > 0 and (N @ v + d) * (plane @ light) > 0)
""",
}

MATRIX = "np.dot(plane, light) * np.eye(4) - np.outer(light, plane)"
SHADOW = "    s = shadow_matrix(plane, light) @ np.append(v, 1)\n    return s[:3] / s[3]"
SIDE = "    if height * height_of_light <= 0:\n        return 0\n"
SUN = "    if light[3] == 0:\n        return 1\n"
NEARER = "abs(height) < abs(height_of_light)"
WRONG = {
    "transposed": ([("np.outer(light, plane)", "np.outer(plane, light)")], "transposed"),
    "all signs": ([(MATRIX, "np.outer(light, plane) - np.dot(plane, light) * np.eye(4)")], "clips it away"),
    "plus": ([(MATRIX, MATRIX.replace(" - ", " + "))], "must be subtracted"),
    "divided": ([(MATRIX, "np.eye(4) - np.outer(light, plane) / np.dot(plane, light)")], "divided by p·l"),
    "no factor": ([(MATRIX, "np.eye(4) - np.outer(light, plane)")], "factor p·l"),
    "no diagonal": ([(MATRIX, "-np.outer(light, plane)")], "first part"),
    "no unit matrix": ([("np.dot(plane, light) * np.eye(4)", "np.dot(plane, light)")], "on the diagonal alone"),
    "three terms": ([("np.dot(plane, light) * np", "np.dot(plane[:3], light[:3]) * np")], "four terms"),
    "number by number": ([("np.outer(light, plane)", "light * plane")], "number by number"),
    "sign of d": ([(MATRIX, "(lambda p: " + MATRIX.replace("plane", "p") + ")(plane * [1, 1, 1, -1])")], "sign of d"),
    "normalised": (
        [(MATRIX, "(lambda p: " + MATRIX.replace("plane", "p") + ")(plane / np.linalg.norm(plane[:3]))")],
        "plane as it is",
    ),
    "sun as a lamp": (
        [(MATRIX, "(lambda a: " + MATRIX.replace("light", "a") + ")(np.append(light[:3], 1))")],
        "no lamp",
    ),
    "no division": ([("return s[:3] / s[3]", "return s[:3]")], "divide by its fourth number"),
    "a direction": ([("@ np.append(v, 1)", "@ np.append(v, 0)")], "0 is a direction"),
    "rows": (
        [
            (
                SHADOW,
                SHADOW.replace(
                    "shadow_matrix(plane, light) @ np.append(v, 1)", "np.append(v, 1) @ shadow_matrix(plane, light)"
                ),
            )
        ],
        "M v, not v M",
    ),
    "straight down": (
        [(SHADOW, "    N = plane[:3]\n    return v - (N @ v + plane[3]) / (N @ N) * N")],
        "straight down",
    ),
    "four numbers": ([("return s[:3] / s[3]", "return s / s[3]")], "4 numbers; expected: 3 numbers"),
    "row by row": ([("M.T.flatten()", "M.flatten()")], "column by column"),
    "4 x 4": ([("M.T.flatten()", "M.T")], "expected: 16 numbers"),
    "everything casts": ([(SIDE, "    return 1\n")], "Not everything"),
    "no side": ([(SIDE, "")], "look at the signs"),
    "looks up": ([(SIDE, "    if height < 0 or height_of_light < 0:\n        return 0\n")], "either way"),
    "no beyond": ([(NEARER, "True")], "farther from the plane than the lamp"),
    "sun has a place": ([(SUN, "")], "however high"),
    "comparison": ([(NEARER, NEARER.replace("<", ">"))], "other way round"),
    "no d": ([("height = np.dot(plane, np.append(v, 1))", "height = np.dot(plane[:3], v)")], "d is missing"),
}
