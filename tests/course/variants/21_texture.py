RIGHT = {
    "with loops": """
import math

MODULATED = 1 / 4
SEPARATE = 0.25 * 0.6 + 0.5


def environment(mode, C_f, C_t):
    A = C_t[3]
    return {
        "MODULATE": [C_f[c] * C_t[c] for c in range(3)],
        "REPLACE": [C_t[c] for c in range(3)],
        "DECAL": [C_f[c] + A * (C_t[c] - C_f[c]) for c in range(3)],
    }[mode]


def nearest(texels, s, t):
    rows, columns = len(texels), len(texels[0])
    s, t = s - math.floor(s), t - math.floor(t)
    return texels[min(int(t * rows), rows - 1)][min(int(s * columns), columns - 1)]


def linear(texels, s, t):
    rows, columns = len(texels), len(texels[0])
    total = [0, 0, 0]
    for row in range(rows):
        for column in range(columns):
            # a tent of the width of a texel around each middle
            dx = (s * columns - 0.5 - column + columns / 2) % columns - columns / 2
            dy = (t * rows - 0.5 - row + rows / 2) % rows - rows / 2
            weight = max(0, 1 - abs(dx)) * max(0, 1 - abs(dy))
            total = [x + weight * c for x, c in zip(total, texels[row][column])]
    return total
""",
    "with rolled arrays": """
import numpy as np

MODULATED = min(0.6 + 0.5, 1) * 0.25
SEPARATE = np.array([0.65])


def environment(mode, C_f, C_t):
    if mode == "DECAL":
        return np.average([C_f, C_t[:3]], axis=0, weights=[1 - C_t[3], C_t[3]])
    return C_t[:3] * (C_f if mode == "MODULATE" else 1)


def nearest(texels, s, t):
    h, w = texels.shape[:2]
    return texels[int(t * h // 1) % h, int(s * w // 1) % w]


def linear(texels, s, t):
    h, w = texels.shape[:2]
    y, x = t * h - 0.5, s * w - 0.5
    j, i = int(y // 1), int(x // 1)
    corner = np.roll(texels, (-j, -i), axis=(0, 1))
    corner = np.pad(corner, ((0, 2), (0, 2), (0, 0)), mode="wrap")[:2, :2]
    return np.array([1 - y % 1, y % 1]) @ np.array([1 - x % 1, x % 1] @ corner)
""",
}

DECAL = "C_f * (1 - alpha) + color * alpha"
TEXEL = "texels[j % h, i % w]"
WRONG = {
    "replace": ([("return C_f * color", "return color")], "where is the light"),
    "modulate": ([("        return color\n", "        return C_f * color\n")], "as it is"),
    "sum": ([("return C_f * color", "return np.clip(C_f + color, 0, 1)")], "GL_ADD"),
    "alpha in modulate": ([("return C_f * color", "return C_f * color * alpha")], "does not touch the colour"),
    "replace by light": ([("        return color\n", "        return C_f\n")], "lit colour is lost"),
    "four numbers": ([("        return color\n", "        return C_t\n")], "4 numbers; expected: 3 numbers"),
    "decal exchanged": ([(DECAL, "C_f * alpha + color * (1 - alpha)")], "texel's opacity"),
    "decal added": ([(DECAL, "C_f + color * alpha")], "take away its share"),
    "decal in full": ([(DECAL, "C_f * (1 - alpha) + color")], "whatever its alpha"),
    "decal lit": ([(DECAL, "C_f * (1 - alpha) + C_f * color * alpha")], "own colour"),
    "not clamped": ([("MODULATED = 0.25", "MODULATED = 0.275")], "clamped to 1 before"),
    "highlight multiplied": ([("SEPARATE = 0.65", "SEPARATE = 0.25")], "is not multiplied"),
    "upside down": ([("return " + TEXEL, "return texels[(h - 1 - j) % h, i % w]")], "on its head"),
    "s and t": (
        [("return " + TEXEL, "return texels[int(np.floor(s * h)) % h, int(np.floor(t * w)) % w]")],
        "s and t are exchanged",
    ),
    "rounded": ([("np.floor(s * w)", "np.round(s * w)"), ("np.floor(t * h)", "np.round(t * h)")], "Half a texel off"),
    "w - 1": (
        [("np.floor(s * w)", "np.floor(s * (w - 1))"), ("np.floor(t * h)", "np.floor(t * (h - 1))")],
        "not w - 1",
    ),
    "clamped": ([("return " + TEXEL, "return texels[min(max(j, 0), h - 1), min(max(i, 0), w - 1)]")], "begins anew"),
    "int": ([("int(np.floor(s * w))", "int(s * w)"), ("int(np.floor(t * h))", "int(t * h)")], "take the floor"),
    "mirrored": (
        [("np.floor(s * w)", "np.floor(abs(s) * w)"), ("np.floor(t * h)", "np.floor(abs(t) * h)")],
        "mirrored",
    ),
    "nearest for linear": (
        [("    x = s * w - 0.5\n", "    return nearest(texels, s, t)\n    x = s * w - 0.5\n")],
        "nothing is mixed",
    ),
    "no half": ([("s * w - 0.5", "s * w"), ("t * h - 0.5", "t * h")], "Half a texel off"),
    "half added": ([("s * w - 0.5", "s * w + 0.5"), ("t * h - 0.5", "t * h + 0.5")], "other direction"),
    "equal parts": ([("a, b = x - i, y - j", "a, b = 0.5, 0.5")], "nearer ones must count more"),
    "weights exchanged": ([("a, b = x - i, y - j", "a, b = 1 - x + i, 1 - y + j")], "weights are exchanged"),
    "along s alone": ([("return (1 - b) * below + b * above", "return below")], "the same up and down"),
    "sum 2": ([("return (1 - b) * below + b * above", "return 2 * ((1 - b) * below + b * above)")], "sum 1"),
    "border drawn out": (
        [
            ("(i + 1) % w", "min(i + 1, w - 1)"),
            ("(j + 1) % h", "min(j + 1, h - 1)"),
            ("x = s * w - 0.5", "x = s % 1 * w - 0.5"),
            ("y = t * h - 0.5", "y = t % 1 * h - 0.5"),
            ("below = (1 - a) * " + TEXEL, "i, j = max(i, 0), max(j, 0)\n    below = (1 - a) * " + TEXEL),
        ],
        "the first one",
    ),
    "int in linear": ([("int(np.floor(x))", "int(x)"), ("int(np.floor(y))", "int(y)")], "take the floor"),
}
