RIGHT = {
    "by a system of equations": """
import numpy as np


def weights(P, triangle):
    M = np.vstack([triangle.T, np.ones(3)])
    return np.linalg.solve(M, [P[0], P[1], 1])


def gouraud(P, triangle, I):
    w = weights(P, triangle)
    return [sum(w[k] * min(max(I[k][c], 0), 1) for k in range(3)) for c in range(3)]


def picture(triangle, I, width, height):
    black = [0, 0, 0]
    return [
        [
            gouraud((c + 0.5, r + 0.5), triangle, I) if all(weights((c + 0.5, r + 0.5), triangle) >= 0) else black
            for c in range(width)
        ]
        for r in range(height)
    ]
""",
    "all pixels at once": """
import numpy as np


def weights(P, triangle):
    a, b, c = triangle
    d = (b[1] - c[1]) * (a[0] - c[0]) + (c[0] - b[0]) * (a[1] - c[1])
    w1 = ((b[1] - c[1]) * (P[0] - c[0]) + (c[0] - b[0]) * (P[1] - c[1])) / d
    w2 = ((c[1] - a[1]) * (P[0] - c[0]) + (a[0] - c[0]) * (P[1] - c[1])) / d
    return np.array([w1, w2, 1 - w1 - w2])


def gouraud(P, triangle, I):
    return (np.minimum(I, 1) * weights(P, triangle)[:, None]).sum(axis=0)


def picture(triangle, I, width, height):
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    w = np.moveaxis(weights((x, y), triangle), 0, -1)
    return np.where((w >= 0).all(axis=-1)[..., None], w @ np.minimum(I, 1), 0.0)
""",
}

AREAS = "np.array([twice_area(P, B, C), twice_area(A, P, C), twice_area(A, B, P)])"
SHARE = "areas / twice_area(A, B, C)"
COLOR = "    return weights(P, triangle) @ colors"
CENTRE = "np.array([column + 0.5, row + 0.5])"
WRONG = {
    "constant": ([(SHARE, "np.ones(3) / 3")], "place in the triangle"),
    "other vertices": ([(SHARE, "np.roll(areas, 1) / twice_area(A, B, C)")], "opposite to it"),
    "2 and 3 exchanged": ([(SHARE, "areas[[0, 2, 1]] / twice_area(A, B, C)")], "2 and 3 are exchanged"),
    "distances": ([(SHARE, "1 / (1e-9 + np.linalg.norm(triangle - P, axis=1))")], "1 at that vertex"),
    "areas": ([(SHARE, "abs(areas) / 2")], "areas themselves"),
    "half": ([(SHARE, "areas / 2 / twice_area(A, B, C)")], "one half"),
    "no sign of the whole": ([(SHARE, "areas / abs(twice_area(A, B, C))")], "clockwise"),
    "no signs": ([(SHARE, "abs(areas) / abs(twice_area(A, B, C))")], "lost their signs"),
    "weights clamped": ([(SHARE, "np.clip(areas / twice_area(A, B, C), 0, 1)")], "weights are clamped"),
    "columns": ([(COLOR, "    return colors @ weights(P, triangle)")], "by columns"),
    "mean colour": ([(COLOR, "    return colors.mean(axis=0)")], "mean of the three"),
    "nearest vertex": ([(COLOR, "    return colors[np.argmax(weights(P, triangle))]")], "nearest vertex"),
    "flat": ([(COLOR, "    return colors[2]")], "flat shading"),
    "no clamp": ([("np.clip(intensities, 0, 1)", "intensities")], "clamps at each vertex first"),
    "clamped late": (
        [
            ("np.clip(intensities, 0, 1)", "intensities"),
            (COLOR, "    return np.clip(weights(P, triangle) @ colors, 0, 1)"),
        ],
        "the vertices must be",
    ),
    "scaled": ([("np.clip(intensities, 0, 1)", "intensities / max(intensities.max(), 1)")], "brightest channel of all"),
    "corners": ([(CENTRE, "np.array([column, row])")], "pixels' corners"),
    "all pixels": ([(">= 0:", "> -1e9:")], "outside the triangle"),
    "upside down": ([("image[row, column]", "image[-1 - row, column]")], "on its head"),
    "x and y": ([(CENTRE, "np.array([row + 0.5, column + 0.5])")], "exchanged"),
    "width first": (
        [("(height, width, 3)", "(width, height, 3)"), ("image[row, column]", "image[column, row]")],
        "a 10 x 14 x 3 array",
    ),
    "nothing returned": ([("    return image", "    print(image)")], "does the function return"),
}
