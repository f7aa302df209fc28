RIGHT = {
    "in one line": """
def reflection(N, L):
    return 2 * (N @ L) * N - L


def mirror_ray(D, N):
    return D - 2 * (D @ N) * N
""",
    "component by component": """
def reflection(N, L):
    c = sum(n * l for n, l in zip(N, L))
    return [2 * c * n - l for n, l in zip(N, L)]


def mirror_ray(D, N):
    return reflection(N, [-d for d in D])
""",
}

SUM = "return projection + S"
WRONG = {
    "S alone": ([(SUM, "return S")], "S alone"),
    "projection alone": ([(SUM, "return projection")], "S has to be added"),
    "sign of R": ([(SUM, "return -(projection + S)")], "points into the surface"),
    "plus L": ([("projection - L", "L")], "not L itself"),
    "back": ([(SUM, "return -L")], "straight back"),
    "exchanged": ([("np.dot(N, L) * N", "np.dot(N, L) * L"), ("projection - L", "projection - N")], "exchanged"),
    "not scaled": ([("np.dot(N, L) * N", "N")], "scaled by N·L"),
    "only for +z": ([(SUM, "return np.array([-L[0], -L[1], L[2]])")], "faces +z only"),
    "normalised sum of components": ([("np.dot(N, L) * N", "N * L")], "same angle to N"),
    "L for the ray": ([("reflection(N, -D)", "reflection(N, D)")], "L is -D"),
    "ray not mirrored": ([("return reflection(N, -D)", "return D")], "no surface"),
    "ray's arguments": ([("reflection(N, -D)", "reflection(D, N)")], "exchanged"),
}
