# ruff: noqa: E501
RIGHT = {
    "all lights at once": """
import numpy as np


def illuminate(k_a, k_d, k_s, n, I_a, lights, directions, N, V):
    cosine = directions @ N
    R = 2 * np.outer(cosine, N) - directions
    front = cosine > 0
    diffuse = np.where(front, cosine, 0)
    specular = np.where(front, np.maximum(R @ V, 0) ** n, 0)
    return np.minimum(I_a * k_a + (diffuse @ lights) * k_d + (specular @ lights) * k_s, 1)


def flip(k_d, I_L, N, L):
    return abs(N @ L) * (k_d * I_L)


def two_sided(front, back, I_L, N, L, V):
    return np.where(N @ V >= 0, front * max(N @ L, 0), back * max(-N @ L, 0)) * I_L
""",
    "channel by channel": """
def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def illuminate(k_a, k_d, k_s, n, I_a, lights, directions, N, V):
    result = []
    for c in range(3):
        I = I_a[c] * k_a[c]
        for I_L, L in zip(lights, directions):
            a = dot(N, L)
            h = 2 * a * dot(N, V) - dot(L, V)
            I += I_L[c] * (k_d[c] * a + k_s[c] * (h**n if h > 0 else 0)) if a > 0 else 0
        result.append(min(I, 1.0))
    return result


def flip(k_d, I_L, N, L):
    sign = 1 if dot(N, L) >= 0 else -1
    return [sign * dot(N, L) * k_d[c] * I_L[c] for c in range(3)]


def two_sided(front, back, I_L, N, L, V):
    if dot(N, V) < 0:
        return two_sided(back, front, I_L, [-x for x in N], L, V)
    return tuple(front[c] * I_L[c] * max(dot(N, L), 0) for c in range(3))
""",
}

LOOP = "for I_L, L in zip(lights, directions, strict=True):"
ADD = "color = color + I_L * (k_d * cosine + k_s * max(R @ V, 0) ** n)"
CLAMP = "np.clip(color, 0, 1)"
FLIP = "    if N @ L < 0:\n        N = -N\n"
WRONG = {
    "first light": ([(LOOP, "for I_L, L in zip(lights[:1], directions[:1], strict=True):")], "first light"),
    "last light": ([(ADD, ADD.replace("color + I_L", "I_a * k_a + I_L"))], "last light"),
    "glow for each light": ([(ADD, ADD.replace("color + I_L", "color + I_a * k_a + I_L"))], "counts once"),
    "no glow": ([("color = I_a * k_a", "color = 0 * I_a")], "glow is missing"),
    "mean": ([(ADD, ADD.replace("I_L *", "I_L / len(lights) *"))], "not averaged"),
    "no highlights": ([(" + k_s * max(R @ V, 0) ** n", "")], "highlights are missing"),
    "exchanged": ([("k_d * cosine + k_s", "k_s * cosine + k_d")], "exchanged"),
    "the sum clamped": ([("if cosine > 0:", "if True:"), ("max(R @ V, 0)", "(cosine > 0) * max(R @ V, 0)")], "not the sum"),
    "highlight behind": ([("if cosine > 0:", "if True:"), ("k_d * cosine", "k_d * max(cosine, 0)")], "makes a highlight"),
    "neither tested": ([("if cosine > 0:", "if True:")], "should add nothing"),
    "black": ([(CLAMP, CLAMP + " * (min(directions @ N) > 0)")], "everything is black"),
    "absolute value": ([("cosine = N @ L", "L = L if N @ L > 0 else -L\n        cosine = N @ L")], "shine through"),
    "no clamp": ([(CLAMP, "color")], "exceed 1"),
    "each light clamped": ([(ADD, "color = color + np.clip(I_L * (k_d * cosine + k_s * max(R @ V, 0) ** n), 0, 1)"), (CLAMP, "color")], "Each light is clamped"),
    "divided": ([(CLAMP, "color / max(color.max(), 1)")], "brightest channel"),
    "overflow": ([(CLAMP, "color % 1.0")], "begins at 0 again"),
    "not flipped": ([(FLIP, "")], "flip the normal"),
    "clamped": ([(FLIP, ""), ("k_d * I_L * (N @ L)", "k_d * I_L * max(N @ L, 0)")], "This clamps"),
    "always flipped": ([(FLIP, "    N = -N\n")], "flipped everywhere"),
    "by the light": ([("if N @ V < 0:", "if N @ L < 0:")], "eye that decides"),
    "front only": ([("if N @ V < 0:", "if False:")], "lit like the front"),
    "no back": ([("N, front = -N, back", "N, front = -N, front")], "reflectance of its own"),
    "N not turned": ([("N, front = -N, back", "front = back")], "needs -N"),
    "sides exchanged": ([("    if N @ V < 0:", "    front, back = back, front\n    if N @ V < 0:")], "exchanged"),
    "lit from behind": ([("front * I_L * max(N @ L, 0)", "front * I_L * abs(N @ L)")], "from behind, too"),
    "two-sided not clamped": ([("front * I_L * max(N @ L, 0)", "front * I_L * (N @ L)")], "negative: clamp"),
}  # fmt: skip
