ANSWERS = "WHITE_IN_RED = [1.0, 0.0, 0.0]\nGREEN_IN_RED = [0, 0, 0]\nHIGHLIGHT = [1, 0, 0]\n"
RIGHT = {
    "with matrices": "import numpy as np\n" + ANSWERS + """

def diffuse_color(k_a, k_d, I_a, lights, directions, N):
    cosines = np.maximum(directions @ N, 0)
    return np.minimum(I_a * k_a + k_d * (cosines @ lights), 1)
""",
    "with loops": ANSWERS + """

def diffuse_color(k_a, k_d, I_a, lights, directions, N):
    result = []
    for c in range(3):
        total = I_a[c] * k_a[c]
        for k in range(len(lights)):
            cosine = sum(N[j] * directions[k][j] for j in range(3))
            if cosine > 0:
                total += lights[k][c] * k_d[c] * cosine
        result.append(min(total, 1.0))
    return tuple(result)
""",
}  # fmt: skip

TERM = "light * k_d * max(np.dot(N, L), 0)"
WRONG = {
    "white stays white": ([("WHITE_IN_RED = (1, 0, 0)", "WHITE_IN_RED = (1, 1, 1)")], "only red"),
    "green stays green": ([("GREEN_IN_RED = (0, 0, 0)", "GREEN_IN_RED = (0, 1, 0)")], "there is none"),
    "added": ([("GREEN_IN_RED = (0, 0, 0)", "GREEN_IN_RED = (1, 1, 0)")], "not added"),
    "white highlight": ([("HIGHLIGHT = (1, 0, 0)", "HIGHLIGHT = (1, 1, 1)")], "light is red"),
    "no ambient": ([("color = I_a * k_a", "color = 0 * k_a")], "ambient term is missing"),
    "no maximum": ([(TERM, "light * k_d * np.dot(N, L)")], "max(N·L, 0)"),
    "through": ([(TERM, "light * k_d * abs(np.dot(N, L))")], "shines through"),
    "no k_d": ([(TERM, "light * max(np.dot(N, L), 0)")], "k_d is missing"),
    "k_a": ([(TERM, "light * k_a * max(np.dot(N, L), 0)")], "not k_a"),
    "mean of channels": ([(TERM, "light.mean() * k_d * max(np.dot(N, L), 0)")], "its own intensity"),
    "last light": ([("color = color + " + TERM, "color = I_a * k_a + " + TERM)], "Only the last"),
    "mean of lights": ([(TERM, TERM + " / len(lights)")], "not averaged"),
    "glow each time": ([("color = I_a * k_a", "color = 0"), (TERM, TERM + " + I_a * k_a")], "counts once"),
    "no clamp": ([("np.clip(color, 0, 1)", "color")], "clamp the sum"),
    "scaled": ([("np.clip(color, 0, 1)", "color / max(color.max(), 1)")], "each channel by itself"),
    "each clamped": (
        [(TERM, "np.clip(" + TERM + ", 0, 1)"), ("return np.clip(color, 0, 1)", "return color")],
        "once, at the end",
    ),
}
