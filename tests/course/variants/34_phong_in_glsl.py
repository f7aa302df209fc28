RIGHT = {
    "with functions of its own": """
vec3 towards(vec3 from, vec3 to)
{
    return (to - from) / distance(from, to);
}

vec4 lamp(Face face, vec3 N, vec3 L, vec3 V)
{
    vec3 sum = L + V;
    float cosine = dot(N, sum) / length(sum);
    vec4 diffuse = face.k_d * lights[0].I_d * dot(N, L);
    return dot(N, L) <= 0.0 ? vec4(0.0) : diffuse + face.k_s * lights[0].I_s * power(cosine, face.n);
}

void phong_shading(Face face, vec3 normal, vec3 P, out vec4 color, out vec3 highlight)
{
    vec3 N = normal / length(normal);
    vec3 L = towards(P, lights[0].position.xyz);
    color = face.emission + face.k_a * I_a_scene + lamp(face, N, L, towards(P, vec3(0.0)));
    color = vec4(min(color.rgb, 1.0), face.k_d.a);
    highlight = vec3(0.0);
}
""",
    "without a branch": """
void phong_shading(Face face, vec3 normal, vec3 P, out vec4 color, out vec3 highlight) {
    Light light = lights[0];
    vec3 N = inversesqrt(dot(normal, normal)) * normal;
    vec3 L = normalize(light.position.xyz - P), H = normalize(L - normalize(P));
    float in_front = sign(max(dot(N, L), 0.0));
    vec3 diffuse = light.I_d.rgb * face.k_d.rgb * max(dot(N, L), 0.0);
    vec3 shiny = light.I_s.rgb * face.k_s.rgb * pow(max(dot(N, H), 0.0), face.n) * in_front;
    color.rgb = shiny + diffuse + I_a_scene.rgb * face.k_a.rgb + face.emission.rgb;
    color.a = face.k_d.a;
    highlight = vec3(0.0);
}
""",
}

L, V, H = "normalize(lights[0].position.xyz - P)", "normalize(-P)", "normalize(L + V)"
GLOW, LAMP = "face.k_a.rgb * I_a_scene.rgb", "if (dot(N, L) > 0.0) {"
WRONG = {
    "the normal not normalised": ([("normalize(normal)", "normal")], "shorter than the normals of the vertices"),
    "L not normalised": ([(L, "lights[0].position.xyz - P")], "L must be a unit vector"),
    "L from the lamp": ([("position.xyz - P", "position.xyz + P"), ("lights[0].position", "-lights[0].position")],
                        "from the lamp to the surface"),
    "L as if the lamp were far away": ([(L, "normalize(lights[0].position.xyz)")], "stands at a place"),
    "the diffuse light without N·L": ([(" * dot(N, L);", ";")], "N·L is missing"),
    "negative light": ([(LAMP, "{")], "must not take light away"),
    "the dark side lit": ([("dot(N, L)", "abs(dot(N, L))")], "abs lights the dark side"),
    "a highlight behind": ([(" * dot(N, L);", " * dot(N, L); }"), ("face.n);\n    }", "face.n);")],
                           "only where N·L > 0"),
    "no ambient glow": ([(" + " + GLOW, "")], "ambient glow is missing"),
    "the glow with k_d": ([("face.k_a", "face.k_d")], "with k_a, not with k_d"),
    "the glow on the lit side only": ([(" + " + GLOW, ""), (LAMP, f"{LAMP} I += {GLOW};")], "does not depend on N·L"),
    "no emission": ([("face.emission.rgb + ", "")], "add its emission"),
    "no I_d": ([(" * lights[0].I_d.rgb", "")], "without the lamp's I_d"),
    "no I_s": ([(" * lights[0].I_s.rgb", "")], "without the lamp's I_s"),
    "I_d for the highlight": ([("lights[0].I_s", "lights[0].I_d")], "its intensity is I_s"),
    "k_d for the highlight": ([("face.k_s", "face.k_d")], "with k_s, not with k_d"),
    "no k_s": ([("face.k_s.rgb * ", "")], "without k_s"),
    "no highlight": ([("power(dot(N, H), face.n)", "0.0")], "no highlight yet"),
    "V from the eye": ([(V, "normalize(P)")], "from the eye to the surface"),
    "V along z": ([(V, "vec3(0.0, 0.0, 1.0)")], "V is the same everywhere"),
    "V not normalised": ([(V, "-P")], "V must be a unit vector"),
    "H not normalised": ([(H, "L + V")], "normalise the sum"),
    "half the sum": ([(H, "(L + V) / 2.0")], "shorter than a unit vector"),
    "Phong's lobe": ([("dot(N, H)", "dot(2.0 * dot(N, L) * N - L, V)")], "R·V"),
    "the slide's slip": ([("dot(N, H)", "dot(V, H)")], "slide's slip"),
    "no eye in the highlight": ([("dot(N, H)", "dot(N, L)")], "does not move with the eye"),
    "no exponent": ([("power(dot(N, H), face.n)", "max(dot(N, H), 0.0)")], "exponent n is missing"),
    "a word is misspelt": ([("normalize(normal)", "normalise(normal)")], "normalise"),
    "another function": ("void shade() {\n}\n", "defines no function phong_shading"),
}  # fmt: skip
