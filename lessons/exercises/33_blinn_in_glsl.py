r"""The highlight of Blinn and Torrance uses the vector $\mathbf{H}$ halfway between $\mathbf{L}$ and $\mathbf{V}$:

$$ I_s = I_L\, k_s\, (\mathbf{N} \cdot \mathbf{H})^n $$

Write the function `blinn_torrance` of shaders/specular.glsl: it returns $(\mathbf{N} \cdot \mathbf{H})^n$. `N`, `L` and `V` are
unit vectors in eye space: the normal, towards the light, towards the eye. `power(cosine, n)`, above it in the same file,
returns `cosine` to the power of `n`, and 0 for a negative cosine. Your function is compiled into the shader that draws.
"""

from glsim.course.exercise import Definition, Shader
from glsim.gl import *
from glsim.glut import glutSolidSphere, glutSolidTorus

STARTER = """\
float blinn_torrance(vec3 N, vec3 L, vec3 V, float n)
{
    return 0.0;
}
"""

SIGNATURE = "float blinn_torrance(vec3 N, vec3 L, vec3 V, float n)\n{\n"


def mistake(body: str) -> str:
    return f"{SIGNATURE}    {body}\n}}\n"


def scene(position: tuple[float, ...], shininess: float, torus: bool):
    def draw() -> None:
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
        glShadeModel(GL_PHONG_WIN)
        glLightfv(GL_LIGHT0, GL_POSITION, position)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.2, 0.1, 0.1, 1])
        glMaterialfv(GL_FRONT, GL_SPECULAR, [0.8, 0.8, 0.8, 1])
        glMaterialf(GL_FRONT, GL_SHININESS, shininess)
        glMatrixMode(GL_PROJECTION)
        glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 10)
        glMatrixMode(GL_MODELVIEW)
        glTranslatef(0, 0, -3)
        if torus:
            glRotatef(50, 1, 0.3, 0)
            glutSolidTorus(0.4, 0.8, 24, 48)
        else:
            glutSolidSphere(1.2, 40, 30)

    return draw


MISTAKES = [
    (mistake("return power(dot(N, L + V), n);"), "H must be a unit vector: normalise the sum of L and V."),
    (mistake("return power(dot(N, (L + V) / 2.0), n);"), "Half of L + V is shorter than a unit vector: normalise it."),
    (mistake("vec3 R = 2.0 * dot(N, L) * N - L; return power(dot(R, V), n);"),
     "Your highlight is where R·V would put it; the exercise asks for N·H."),
    (mistake("return power(dot(N, L), n);"), "The highlight does not move with the eye: V is missing."),
    (mistake("return power(dot(N, normalize(L - V)), n);"), "H lies between L and V: add them."),
    (mistake("return power(dot(V, normalize(L + V)), n);"), "V·H is the slide's slip: H·V does not depend on the surface; use N·H."),
    (mistake("return dot(N, normalize(L + V));"), "The exponent n is missing: the highlight is as wide as the object."),
    (mistake("return power(dot(N, normalize(L + V)), 4.0 * n);"), "The highlight is too small: the exponent is n itself."),
    (mistake("return 0.0;"), "There is no highlight yet."),
]  # fmt: skip

EXERCISE = Definition(
    title="Blinn's highlight in GLSL",
    lesson=10,
    ending=".glsl",
    starter=STARTER,
    parts=[
        Shader(
            "a sphere under a lamp on the left",
            "specular.glsl",
            "blinn_torrance",
            scene((-2.0, 1.0, 2.0, 1.0), 20.0, torus=False),
            hint="The highlight is not where N·H puts it.",
            mistakes=MISTAKES,
            points=2,
        ),
        Shader(
            "a torus under a light that is far away",
            "specular.glsl",
            "blinn_torrance",
            scene((1.0, 1.0, 0.5, 0.0), 5.0, torus=True),
            hint="The highlight is not where N·H puts it.",
            mistakes=MISTAKES,
        ),
    ],
)
