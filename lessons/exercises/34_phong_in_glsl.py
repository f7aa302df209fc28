r"""Phong shading evaluates the illumination equation at every fragment, with the normal that the rasterizer has interpolated
between the vertices:

$$ \mathbf{N} = \frac{w_1 \mathbf{N}_1 + w_2 \mathbf{N}_2 + w_3 \mathbf{N}_3}{|w_1 \mathbf{N}_1 + w_2 \mathbf{N}_2 + w_3 \mathbf{N}_3|}, \qquad
I = E + k_a\, I_a + k_d\, I_d\, (\mathbf{N} \cdot \mathbf{L}) + k_s\, I_s\, (\mathbf{N} \cdot \mathbf{H})^n $$

Write the function `phong_shading` of shaders/main.frag; it is compiled into the shader that draws. Write the equation out, without
`shade` and `illuminate`. Everything is in eye space, where the eye is the origin:

- `normal` is the sum $w_1 \mathbf{N}_1 + w_2 \mathbf{N}_2 + w_3 \mathbf{N}_3$, `P` the point of the surface,
- `face.k_a`, `face.k_d`, `face.k_s`, `face.emission` (the $E$) and `face.n` are the material, colours of four channels (`.rgb` are three),
- `I_a_scene` is the ambient glow $I_a$; the one lamp stands at `lights[0].position.xyz` and has `lights[0].I_d` and `lights[0].I_s`,
- `color` gets the colour with the alpha of `face.k_d`; `highlight` stays 0: it is for `GL_SEPARATE_SPECULAR_COLOR`.

Where $\mathbf{N} \cdot \mathbf{L} \le 0$ the lamp is behind the surface and gives neither diffuse light nor a highlight. `power(cosine, n)`
returns `cosine` to the power of `n`, and 0 for a negative cosine.
"""

from glsim.course.exercise import Definition, Shader
from glsim.gl import *
from glsim.glut import glutSolidSphere, glutSolidTorus

SIGNATURE = "void phong_shading(Face face, vec3 normal, vec3 P, out vec4 color, out vec3 highlight)\n{\n"
STARTER = f"""{SIGNATURE}    highlight = vec3(0.0);
    color = vec4(face.k_a.rgb * I_a_scene.rgb, face.k_d.a);
}}
"""

RIGHT = """    highlight = vec3(0.0);
    vec3 N = normalize(normal);
    vec3 L = normalize(lights[0].position.xyz - P);
    vec3 V = normalize(-P);
    vec3 H = normalize(L + V);
    color = vec4(face.emission.rgb + face.k_a.rgb * I_a_scene.rgb, face.k_d.a);
    float N_L = dot(N, L);
    if (N_L > 0.0) {
        color.rgb += face.k_d.rgb * lights[0].I_d.rgb * N_L;
        color.rgb += face.k_s.rgb * lights[0].I_s.rgb * power(dot(N, H), face.n);
    }
}
"""


def scene(shape, shininess: float, specular: float, emission: float):
    """A lamp at a place, a surface with few vertices, and light that is not white: each factor shows."""

    def draw() -> None:
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glShadeModel(GL_PHONG_WIN)
        glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.3, 0.25, 0.2, 1])
        glLightfv(GL_LIGHT0, GL_POSITION, [-1.5, 1.5, -1.2, 1])
        glLightfv(GL_LIGHT0, GL_DIFFUSE, [0.7, 0.6, 0.5, 1])
        glLightfv(GL_LIGHT0, GL_SPECULAR, [0.6, 0.7, 0.8, 1])
        glMaterialfv(GL_FRONT, GL_AMBIENT, [0.3, 0.4, 0.5, 1])
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.6, 0.7, 0.5, 1])
        glMaterialfv(GL_FRONT, GL_SPECULAR, [specular, specular, 0.7 * specular, 1])
        glMaterialfv(GL_FRONT, GL_EMISSION, [0, 0, emission, 1])
        glMaterialf(GL_FRONT, GL_SHININESS, shininess)
        glMatrixMode(GL_PROJECTION)
        glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 10)
        glMatrixMode(GL_MODELVIEW)
        glTranslatef(0, 0, -3)
        glRotatef(50, 1, 0.3, 0)
        shape()

    return draw


def mistake(hint: str, *changes: tuple[str, str]) -> tuple[str, str]:
    text = SIGNATURE + RIGHT
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text, hint


AMBIENT = "color = vec4(face.emission.rgb + face.k_a.rgb * I_a_scene.rgb, face.k_d.a);"
MISTAKES = [
    (STARTER, "There is only the ambient glow yet: add the lamp's diffuse light and its highlight."),
    mistake("The interpolated normal is shorter than the normals of the vertices: normalise it, or the middle of each polygon is too dark.",
            ("normalize(normal)", "normal")),
    mistake("L must be a unit vector: normalise it, or what is far from the lamp is too bright.",
            ("normalize(lights[0].position.xyz - P)", "lights[0].position.xyz - P")),
    mistake("L points from the lamp to the surface: it must point from P to the lamp, position - P.",
            ("lights[0].position.xyz - P", "P - lights[0].position.xyz")),
    mistake("The lamp stands at a place: the direction to it is its position minus P, another one at each fragment.",
            ("lights[0].position.xyz - P", "lights[0].position.xyz")),
    mistake("The diffuse light does not depend on the normal: its factor N·L is missing.", (" * N_L;", ";")),
    mistake("Where N·L is negative the lamp is behind the surface: it must not take light away.", ("if (N_L > 0.0) {", "{")),
    mistake("Where N·L is negative the lamp is behind the surface: abs lights the dark side.",
            ("float N_L = dot(N, L);", "float N_L = abs(dot(N, L));")),
    mistake("There is a highlight where the lamp is behind the surface: add it only where N·L > 0.",
            ("* N_L;", "* N_L; }"), ("power(dot(N, H), face.n);\n    }", "power(dot(N, H), face.n);")),
    mistake("The ambient glow is missing: add k_a I_a.", (" + face.k_a.rgb * I_a_scene.rgb", "")),
    mistake("The ambient glow is reflected with k_a, not with k_d.", ("face.k_a.rgb", "face.k_d.rgb")),
    mistake("The ambient glow is everywhere: it does not depend on N·L.",
            (AMBIENT, AMBIENT.replace(" + face.k_a.rgb * I_a_scene.rgb", "")),
            ("if (N_L > 0.0) {", "if (N_L > 0.0) { color.rgb += face.k_a.rgb * I_a_scene.rgb;")),
    mistake("What the material emits is missing: add its emission.", ("face.emission.rgb + ", "")),
    mistake("The diffuse light is without the lamp's I_d: multiply by it.", (" * lights[0].I_d.rgb", "")),
    mistake("The highlight is without the lamp's I_s: multiply by it.", (" * lights[0].I_s.rgb", "")),
    mistake("The highlight has the lamp's I_d: its intensity is I_s.", ("lights[0].I_s", "lights[0].I_d")),
    mistake("The highlight is reflected with k_s, not with k_d.", ("face.k_s.rgb", "face.k_d.rgb")),
    mistake("The highlight is without k_s: multiply by it.", ("face.k_s.rgb * lights[0].I_s.rgb", "lights[0].I_s.rgb")),
    mistake("There is no highlight yet: add k_s I_s (N·H)^n.", ("face.k_s.rgb * lights[0].I_s.rgb", "vec3(0.0)")),
    mistake("V points from the eye to the surface: the eye is the origin, so V is normalize(-P).", ("normalize(-P)", "normalize(P)")),
    mistake("V is the same everywhere: the eye is the origin, so V is normalize(-P).", ("normalize(-P)", "vec3(0.0, 0.0, 1.0)")),
    mistake("V must be a unit vector before it is added to L.", ("normalize(-P)", "-P")),
    mistake("H must be a unit vector: normalise the sum of L and V.", ("normalize(L + V)", "L + V")),
    mistake("Half of L + V is shorter than a unit vector: normalise it.", ("normalize(L + V)", "0.5 * (L + V)")),
    mistake("Your highlight is where R·V would put it; the exercise asks for N·H.", ("dot(N, H)", "dot(reflect(-L, N), V)")),
    mistake("V·H is the slide's slip: it does not depend on the surface; use N·H.", ("dot(N, H)", "dot(V, H)")),
    mistake("The highlight is N·L to the n: it does not move with the eye. Use N·H.", ("dot(N, H)", "dot(N, L)")),
    mistake("The exponent n is missing: the highlight is as wide as the object.", ("power(dot(N, H), face.n)", "max(dot(N, H), 0.0)")),
]  # fmt: skip

EXERCISE = Definition(
    title="Phong shading per fragment in GLSL",
    lesson=16,
    ending=".glsl",
    starter=STARTER,
    parts=[
        Shader(
            "a dull sphere of few vertices: emission, ambient and diffuse light",
            "main.frag",
            "phong_shading",
            scene(lambda: glutSolidSphere(1.2, 9, 7), 20.0, 0.0, 0.2),
            hint="The picture is not what emission, k_a I_a and k_d I_d (N·L) give.",
            mistakes=MISTAKES,
        ),
        Shader(
            "a shiny torus: the highlight",
            "main.frag",
            "phong_shading",
            scene(lambda: glutSolidTorus(0.45, 0.75, 10, 16), 3.0, 0.8, 0.0),
            hint="The highlight is not what k_s I_s (N·H)^n gives at each fragment.",
            mistakes=MISTAKES,
            points=2,
        ),
    ],
)
