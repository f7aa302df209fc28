RIGHT = {
    "by the length": """
float blinn_torrance(vec3 N, vec3 L, vec3 V, float n)
{
    vec3 sum = L + V;
    float cosine = dot(N, sum) / length(sum);
    return power(cosine, n);
}
""",
    "with a function of its own": """
// the vector halfway
vec3 halfway(vec3 L, vec3 V)
{
    return normalize(0.5 * (L + V));
}

float blinn_torrance(vec3 N, vec3 L, vec3 V, float n) {
    if (n == 0.0) return 1.0;
    return pow(max(dot(N, halfway(L, V)), 0.0), n);
}
""",
}

H = "vec3 H = normalize(L + V);"
WRONG = {
    "not normalised": ([(H, "vec3 H = L + V;")], "normalise the sum"),
    "half the sum": ([(H, "vec3 H = 0.5 * (L + V);")], "shorter than a unit vector"),
    "Phong's lobe": ([(H, "vec3 H = reflect(-L, N);"), ("dot(N, H)", "dot(V, H)")], "R·V"),
    "the slide's slip": ([("dot(N, H)", "dot(V, H)")], "V·H"),
    "no eye": ([(H, "vec3 H = L;")], "V is missing"),
    "difference": ([(H, "vec3 H = normalize(L - V);")], "add them"),
    "no exponent": ([("power(dot(N, H), n)", "dot(N, H)")], "exponent n is missing"),
    "four times the exponent": ([("n);\n}", "4.0 * n);\n}")], "exponent is n itself"),
    "a word is misspelt": ([("normalize", "normalise")], "normalise"),
    "another function": ("float phong() {\n    return 1.0;\n}\n", "defines no function blinn_torrance"),
}
