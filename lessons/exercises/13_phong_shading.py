r"""Phong shading interpolates the **normal**, and evaluates the illumination equation at every pixel:

$$ \mathbf{N} = \frac{w_1 \mathbf{N}_1 + w_2 \mathbf{N}_2 + w_3 \mathbf{N}_3}{|w_1 \mathbf{N}_1 + w_2 \mathbf{N}_2 + w_3 \mathbf{N}_3|}, \qquad
I = I_L \big( k_d\, (\mathbf{N} \cdot \mathbf{L}) + k_s\, (\mathbf{N} \cdot \mathbf{H})^n \big), \qquad \mathbf{H} = \frac{\mathbf{L} + \mathbf{V}}{|\mathbf{L} + \mathbf{V}|} $$

Write `normal(w, normals)`: the unit normal at a pixel with the weights `w`, (3,), between three vertices with the unit normals `normals`, (3, 3), a row for each vertex.
Write `shade(N, k_d, k_s, n, I_L, L, V)`: the colour for one normal, clamped to $[0, 1]$; it is black where $\mathbf{N} \cdot \mathbf{L} \le 0$. `k_d`, `k_s`, `I_L` have three channels, `L` and `V` are unit
vectors. Write `picture(weights, normals, k_d, k_s, n, I_L, L, V)`: the colours (h, w, 3) of the pixels of a triangle, whose weights are given, (h, w, 3); a pixel with a
negative weight lies outside and is black.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors

STARTER = '''\
import numpy as np


def normal(w, normals):
    """Returns the unit normal (3,) at a pixel.  w: weights (3,); normals: (3, 3), one row a vertex."""
    return normals[0]


def shade(N, k_d, k_s, n, I_L, L, V):
    """Returns red, green and blue in [0, 1] for the unit normal N."""
    return k_d


def picture(weights, normals, k_d, k_s, n, I_L, L, V):
    """Returns the colours (h, w, 3) of pixels with these weights (h, w, 3), black outside."""
    return np.zeros(weights.shape)
'''


def unit(v):
    return v / np.linalg.norm(v)


def normal(w, normals):
    return unit(w @ normals)


def equation(N, k_d, k_s, n, I_L, L, V, lobe="blinn"):
    if N @ L <= 0:
        return np.zeros(3)
    cosine = (
        N @ unit(L + V)
        if lobe == "blinn"
        else (2 * (N @ L) * N - L) @ V
        if lobe == "phong"
        else lobe(N, L, V)
    )
    return I_L * (k_d * (N @ L) + k_s * max(cosine, 0) ** n)


def shade(*arguments):
    return np.clip(equation(*arguments), 0, 1)


def changed(lobe="blinn", **replaced):
    """shade with another highlight or other arguments: a mistake."""

    def answer(N, k_d, k_s, n, I_L, L, V):
        given = {
            "N": N,
            "k_d": k_d,
            "k_s": k_s,
            "n": n,
            "I_L": I_L,
            "L": L,
            "V": V,
        } | replaced
        return np.clip(equation(**given, lobe=lobe), 0, 1)

    return answer


def picture(weights, normals, *rest, at=None, outside=False):
    at = at or (lambda w, normals: shade(normal(w, normals), *rest))
    flat = [
        at(w, normals) if outside or w.min() >= 0 else np.zeros(3)
        for w in weights.reshape(-1, 3)
    ]
    return np.reshape(flat, weights.shape)


def drawn_as(at, outside=False):
    return lambda weights, normals, *rest: picture(
        weights, normals, *rest, at=lambda w, n: at(w, n, *rest), outside=outside
    )


RNG = np.random.default_rng(13)


def corner_normals(seed, spread=0.9):
    N = unit_vectors(3, seed) * spread + (0, 0, 1.1)
    return N / np.linalg.norm(N, axis=1, keepdims=True)


def light(seed, bright=1.0):
    """k_d, k_s, n, I_L, L, V"""
    k_d, k_s = RNG.uniform(0.1, 0.5, (2, 3))
    L, V = (unit(v * 0.7 + (0, 0, 1)) for v in unit_vectors(2, seed))
    return (
        k_d,
        k_s,
        float(RNG.integers(4, 30)),
        bright * RNG.uniform(0.6, 1, 3),
        L,
        V,
    )


def triangle(width, height):
    """Weights of the pixels of a triangle that fills half of a picture."""
    x, y = np.meshgrid(
        (np.arange(width) + 0.47) / width, (np.arange(height) + 0.52) / height
    )
    return np.stack([1.02 - x - y, x - 0.013, y - 0.007], axis=-1)


WEIGHTS = [
    (np.array([0.5, 0.5, 0.0]), np.array([[0.6, 0, 0.8], [-0.6, 0, 0.8], [0.0, 1, 0]]))
]
WEIGHTS += [(RNG.dirichlet((1, 1, 1)), corner_normals(k)) for k in range(20)]
FRONT = [(corner_normals(40 + k)[0], *light(60 + k)) for k in range(16)]
BRIGHT = [(corner_normals(80 + k)[0], *light(100 + k, 4.0)) for k in range(12)]
BEHIND = []  # the eye in front, the light a little behind: N.L < 0, N.H > 0
for k in range(12):
    k_d, k_s, _, I_L, _, _ = light(120 + k)
    N, along = unit_vectors(2, 140 + k)
    along = unit(along - (along @ N) * N)
    L, V = unit(along - 0.2 * N), unit(N + 0.3 * along)
    BEHIND.append((N, k_d, k_s, float(RNG.integers(2, 6)), I_L, L, V))
PICTURES = [
    (triangle(w, h), corner_normals(160 + w), *light(180 + w, 1.5))
    for w, h in ((8, 8), (14, 10), (10, 16))
]

EXERCISE = Definition(
    title="Phong shading by hand",
    lesson=16,
    starter=STARTER,
    parts=[
        Call(
            "the normal at a pixel",
            "normal",
            WEIGHTS,
            normal,
            hint="The weighted sum of the three normals, made a unit vector again.",
            mistakes=[
                Mistake(lambda w, N: w @ N, "The mean of unit vectors is shorter than 1: it has to be made a unit vector again."),
                Mistake(lambda w, N: N @ w / np.linalg.norm(N @ w), "The normals are used by columns: each row is the normal of a vertex."),
                Mistake(lambda w, N: N @ w, "The normals are used by columns: each row is the normal of a vertex."),
                Mistake(lambda w, N: unit(N.sum(axis=0)), "The weights are missing: each pixel has a normal of its own."),
                Mistake(lambda w, N: N[np.argmax(w)], "This is the normal of the nearest vertex: interpolate."),
                Mistake(lambda w, N: N[2], "This is the normal of the last vertex, as in flat shading: interpolate."),
                Mistake(lambda w, N: (w @ N) / np.sum(w @ N), "Divide by the vector's length, not by the sum of its components."),
                Mistake(lambda w, N: (w @ N) / np.sum(abs(w @ N)), "Divide by the vector's length, not by the sum of its components."),
                Mistake(lambda w, N: (w @ N) / np.max(abs(w @ N)), "Divide by the vector's length, not by its largest component."),
                Mistake(lambda w, N: (w @ N) / ((w @ N) @ (w @ N)), "This divides by the square of the length: the root is missing."),
                Mistake(lambda w, N: unit(unit(w) @ N) * np.linalg.norm(unit(w) @ N), "The weights were normalised; the normal must be."),
            ],
            points=2,
        ),
        Call(
            "the colour of one normal",
            "shade",
            FRONT,
            shade,
            hint="Diffuse term and highlight are added, each with its own reflectance, and H is a unit vector.",
            mistakes=[
                Mistake(changed("phong"), "Your highlight is where R·V would put it; the exercise asks for N·H."),
                Mistake(changed(lambda N, L, V: N @ (L + V)), "H is not a unit vector: the highlight is too strong."),
                Mistake(changed(lambda N, L, V: N @ (L + V) / 2), "H is not a unit vector: half of L + V is too short."),
                Mistake(changed(lambda N, L, V: V @ unit(L + V)), "This is V·H, which does not depend on the normal; N·H is asked for."),
                Mistake(changed(lambda N, L, V: N @ L), "The highlight has N·H: the eye has to count."),
                Mistake(changed(k_s=0), "The highlight is missing."),
                Mistake(changed(k_d=0), "The diffuse term is missing."),
                Mistake(changed(n=1.0), "The exponent n is missing: the highlight is far too wide."),
                Mistake(lambda N, d, s, n, I, L, V: shade(N, s, d, n, I, L, V), "k_d and k_s are exchanged."),
                Mistake(lambda N, d, s, n, I, L, V: shade(N, d, d, n, I, L, V), "The highlight has a reflectance of its own, k_s."),
                Mistake(changed(I_L=1.0), "The light's intensity is missing."),
                Mistake(lambda N, d, s, n, I, L, V: np.clip(I * (d + s * max(N @ unit(L + V), 0) ** n), 0, 1), "N·L is missing in the diffuse term."),
                Mistake(lambda N, d, s, n, I, L, V: np.clip(I * d * (N @ L) + s * max(N @ unit(L + V), 0) ** n, 0, 1), "The highlight is reflected light, too: it is multiplied by I_L."),
                Mistake(lambda N, d, s, n, I, L, V: np.clip(I * (N @ L) * (d + s * max(N @ unit(L + V), 0) ** n), 0, 1), "The highlight has no N·L."),
            ],
            points=2,
        ),
        Call(
            "bright light, and light from behind",
            "shade",
            BRIGHT + BEHIND,
            shade,
            hint="Each channel lies between 0 and 1, and where N·L <= 0 there is neither diffuse light nor a highlight.",
            mistakes=[
                Mistake(equation, "Some channels exceed 1: clamp them."),
                Mistake(lambda N, d, s, n, I, L, V: np.clip(I * (d * max(N @ L, 0) + s * max(N @ unit(L + V), 0) ** n), 0, 1),
                        "There is a highlight where the surface gets no light: N·H may be positive all the same. Test N·L."),
                Mistake(lambda N, d, s, n, I, L, V: np.clip(I * (d * (N @ L) + s * max(N @ unit(L + V), 0) ** n), 0, 1),
                        "Where N·L is negative the light is behind the surface, and both terms are 0."),
                Mistake(lambda N, d, s, n, I, L, V: np.clip(I * (d * abs(N @ L) + s * abs(N @ unit(L + V)) ** n), 0, 1), "The light shines through the surface."),
            ],
        ),
        Call(
            "the picture",
            "picture",
            PICTURES,
            picture,
            hint="At each pixel inside: first the normal, then the colour for it.",
            mistakes=[
                Mistake(drawn_as(lambda w, N, *rest: w @ [shade(one, *rest) for one in N]), "This is Gouraud shading: the colours of the vertices are interpolated. Interpolate the normals, and shade each pixel."),
                Mistake(drawn_as(lambda w, N, *rest: shade(N[2], *rest)), "This is flat shading: one colour for all pixels."),
                Mistake(drawn_as(lambda w, N, *rest: shade(w @ N, *rest)), "The interpolated normal is not a unit vector: the highlight is too weak between the vertices."),
                Mistake(drawn_as(lambda w, N, *rest: shade(unit(w @ N), *rest), outside=True), "Pixels outside are painted, too: there one of the weights is negative."),
                Mistake(drawn_as(lambda w, N, *rest: shade(unit(N.sum(axis=0)), *rest)), "One normal is used for all pixels."),
                Mistake(lambda *a: picture(*a)[::-1], "The picture stands on its head: keep the order of the weights."),
                Mistake(lambda *a: picture(*a)[:, ::-1], "Left and right are exchanged: keep the order of the weights."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
