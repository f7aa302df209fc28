RIGHT = {
    "per channel": """
def illuminate(k_a, k_d, k_s, n, I_a, I_L, N, L, V):
    N_L = sum(a * b for a, b in zip(N, L))
    R_V = sum((2 * N_L * a - b) * c for a, b, c in zip(N, L, V))
    diffuse = max(N_L, 0)
    specular = max(R_V, 0) ** n if N_L > 0 else 0
    return [min(I_a[c] * k_a[c] + I_L[c] * (k_d[c] * diffuse + k_s[c] * specular), 1) for c in range(3)]
""",
    "with glsim": """
import numpy as np
from glsim import shading


def illuminate(k_a, k_d, k_s, n, I_a, I_L, N, L, V):
    front = float(np.dot(N, L) > 0)
    total = shading.ambient(k_a, I_a) + shading.diffuse(k_d, I_L, N, L)
    total = total + front * I_L * k_s * shading.phong_specular(N, L, V, n)
    return shading.clamp(total)
""",
}

WRONG = {
    "no maximum of R.V": ([("max(np.dot(R, V), 0)", "np.dot(R, V)")], "its power is not 0"),
    "absolute value of R.V": ([("max(np.dot(R, V), 0)", "abs(np.dot(R, V))")], "second highlight"),
    "no ambient": ([("color = I_a * k_a", "color = 0 * k_a")], "glow I_a k_a is missing"),
    "no diffuse": ([("        color = color + I_L * k_d * N_L\n", "")], "diffuse term is missing"),
    "no highlight": ([("        color = color + I_L * k_s * max(np.dot(R, V), 0) ** n\n", "")], "highlight is missing"),
    "k_a for k_d": ([("I_L * k_d * N_L", "I_L * k_a * N_L")], "slide's slip"),
    "exchanged": ([("I_L * k_d * N_L", "I_L * k_s * N_L"), ("I_L * k_s * max", "I_L * k_d * max")], "exchanged"),
    "glow with N.L": ([("color = I_a * k_a", "color = I_a * k_a * np.dot(N, L)")], "no N·L"),
    "I_L for the glow": ([("color = I_a * k_a", "color = I_L * k_a")], "of its own, I_a"),
    "Blinn": ([("np.dot(R, V)", "np.dot(N, (L + V) / np.linalg.norm(L + V))")], "Blinn"),
    "highlight times N.L": ([("** n\n", "** n * N_L\n")], "highlight has no N·L"),
    "no clamp": ([("np.clip(color, 0, 1)", "color")], "clamp the sum"),
    "scaled": ([("np.clip(color, 0, 1)", "color / max(color.max(), 1)")], "brightest"),
    "all 0 behind": (
        [("    return np.clip", "    else:\n        return 0 * k_a\n    return np.clip")],
        "The whole sum became 0",
    ),
    "no test": ([("if N_L > 0:", "if True:")], "Both terms"),
    "absolute": ([("N_L = np.dot(N, L)", "N_L = abs(np.dot(N, L))")], "shines through the surface"),
}
