r"""At each fragment the texture coordinates $(s, t)$ choose a colour $C_t$ of the texture, and the texture environment combines it
with the lit colour $C_f$. $A_t$ is the texel's alpha:

$$ \text{MODULATE: } C = C_f\, C_t \qquad \text{REPLACE: } C = C_t \qquad \text{DECAL: } C = C_f (1 - A_t) + C_t A_t $$

Write three functions. `texels` is an (h, w, 3) array whose first row is the bottom of the texture, $t = 0$; it is repeated without
end (`GL_REPEAT`). Texel $i$ of $w$ covers $s$ from $i / w$ to $(i + 1) / w$, and its middle lies between.

- `environment(mode, C_f, C_t)`: $C$, three numbers. `mode` is "MODULATE", "REPLACE" or "DECAL"; `C_f` is red, green, blue, `C_t` red,
  green, blue, alpha.
- `nearest(texels, s, t)`: the colour of the texel that covers $(s, t)$, `GL_NEAREST`.
- `linear(texels, s, t)`: `GL_LINEAR`: the mean of the four texels whose middles are around $(s, t)$, weighted so that at the middle
  of a texel its own colour results and between two middles all changes evenly.

And two questions: a texel is 0.25 grey, the diffuse light at the point is 0.6, the highlight 0.5. Which grey is shown with
`GL_MODULATE` (`MODULATED`), and which if `GL_SEPARATE_SPECULAR_COLOR` is chosen, too (`SEPARATE`)?
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, Value

STARTER = '''\
import numpy as np

MODULATED = 0
SEPARATE = 0


def environment(mode, C_f, C_t):
    """The colour of a fragment, three numbers.  mode: "MODULATE", "REPLACE" or "DECAL"."""
    return C_f


def nearest(texels, s, t):
    """The colour of the texel that covers (s, t), three numbers."""
    return texels[0, 0]


def linear(texels, s, t):
    """The weighted mean of four texels, three numbers."""
    return texels[0, 0]
'''


def environment(mode, C_f, C_t):
    if mode == "MODULATE":
        return C_f * C_t[:3]
    return C_t[:3] if mode == "REPLACE" else C_f * (1 - C_t[3]) + C_t[:3] * C_t[3]


def nearest(texels, s, t, clamp=False):
    h, w, _ = texels.shape
    i, j = int(np.floor(s * w)), int(np.floor(t * h))
    if clamp:
        i, j = np.clip(i, 0, w - 1), np.clip(j, 0, h - 1)
    return texels[j % h, i % w]


def linear(texels, s, t, shift=0.5, clamp=False, inside=np.floor):
    """shift: of the middles.  inside: which whole number is below."""
    h, w, _ = texels.shape
    x, y = s * w - shift, t * h - shift
    i, j = int(inside(x)), int(inside(y))
    a, b = x - i, y - j
    limit = (lambda k, n: int(np.clip(k, 0, n - 1))) if clamp else (lambda k, n: k % n)
    at = lambda i, j: texels[limit(j, h), limit(i, w)]  # noqa: E731
    return (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) + b * (
        (1 - a) * at(i, j + 1) + a * at(i + 1, j + 1)
    )


RNG = np.random.default_rng(21)
SMALL = np.array(
    [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[0.0, 0.0, 1.0], [1.0, 1.0, 1.0]]]
)
TEXTURES = [
    RNG.uniform(0, 1, (4, 6, 3)),
    RNG.uniform(0, 1, (3, 5, 3)),
    RNG.uniform(0, 1, (8, 2, 3)),
]


def points(low, high, count):
    return [(TEXTURES[k % 3], *RNG.uniform(low, high, 2)) for k in range(count)]


def mixtures(mode, count=8):
    return [(mode, *np.split(RNG.uniform(0, 1, 7), [3])) for _ in range(count)]


INNER = [
    (SMALL, 0.2, 0.2),
    (SMALL, 0.9, 0.2),
    (SMALL, 0.2, 0.9),
    *points(0.01, 0.99, 14),
]
OUTER = [
    (SMALL, 1.2, -0.2),
    (SMALL, -0.2, 0.2),
    *points(1, 4, 8),
    *points(-3, 0, 8),
]
MIDDLES = [
    (SMALL, 0.25, 0.75),
    (SMALL, 0.5, 0.25),
    (SMALL, 0.5, 0.5),
    *points(0.3, 0.6, 14),
]
EDGES = [
    (SMALL, 0.0, 0.25),
    (SMALL, 1.0, 0.75),
    *points(0, 0.06, 6),
    *points(0.94, 1, 6),
    *points(1, 4, 6),
    *points(-3, 0, 8),
]

UPSIDE_DOWN = Mistake(
    lambda x, s, t: nearest(x[::-1], s, t),
    "The texture stands on its head: the first row is its bottom, t = 0.",
)
NEAREST_MISTAKES = [
    UPSIDE_DOWN,
    Mistake(lambda x, s, t: nearest(np.swapaxes(x, 0, 1), s, t), "s and t are exchanged: s goes along a row, and an array's first index is the row."),
    Mistake(lambda x, s, t: nearest(x, s + 0.5 / x.shape[1], t + 0.5 / x.shape[0]), "Half a texel off: texel i covers s from i / w on, so nothing is rounded up."),
    Mistake(lambda x, s, t: nearest(x, s * (x.shape[1] - 1) / x.shape[1], t * (x.shape[0] - 1) / x.shape[0]), "s from 0 to 1 covers w texels, not w - 1."),
    Mistake(lambda x, s, t: nearest(x, s + 0.5 / x.shape[1] - s / x.shape[1], t + 0.5 / x.shape[0] - t / x.shape[0]), "s from 0 to 1 covers w texels, not w - 1, and nothing is rounded up."),
    Mistake(lambda x, s, t: nearest(x, s, t, clamp=True), "Beyond 0 and 1 the border is drawn out (GL_CLAMP_TO_EDGE); GL_REPEAT begins anew."),
    Mistake(lambda x, s, t: nearest(x, abs(s), abs(t)), "Below 0 the texture is mirrored; GL_REPEAT goes on in the same direction."),
    Mistake(lambda x, s, t: nearest(x, np.trunc(s * x.shape[1]) / x.shape[1] + 1e-9, np.trunc(t * x.shape[0]) / x.shape[0] + 1e-9), "Below 0 int() rounds towards 0, that is up: take the floor."),
    Mistake(lambda x, s, t: nearest(x, np.fmod(s, 1), np.fmod(t, 1), clamp=True), "Below 0 the remainder is negative: it must go from 0 to 1."),
]  # fmt: skip
LINEAR_MISTAKES = [
    Mistake(nearest, "This is GL_NEAREST: nothing is mixed."),
    Mistake(lambda x, s, t: linear(x, s, t, shift=0), "Half a texel off: the middle of texel i is at (i + a half) / w."),
    Mistake(lambda x, s, t: linear(x, s, t, shift=-0.5), "Half a texel off, in the other direction: subtract the half."),
    Mistake(lambda x, s, t: linear(x[::-1], s, t), "The texture stands on its head: the first row is its bottom, t = 0."),
    Mistake(lambda x, s, t: linear(np.swapaxes(x, 0, 1), s, t), "s and t are exchanged: s goes along a row, and an array's first index is the row."),
    Mistake(lambda x, s, t: linear(x, s, t, clamp=True), "At the border the texel itself is drawn out (GL_CLAMP_TO_EDGE); with GL_REPEAT its neighbour is the texel of the other side."),
    Mistake(lambda x, s, t: linear(x, s - np.floor(s), t - np.floor(t), clamp=True), "Between the last texel and the first nothing is mixed: the neighbours repeat, too."),
    Mistake(lambda x, s, t: linear(x, s, t, inside=np.trunc), "Below 0 int() rounds towards 0, that is up: take the floor."),
    Mistake(lambda x, s, t: 2 * linear(x, s, t), "The weights must have the sum 1."),
    Mistake(lambda x, s, t: four(x, s, t).mean(axis=0), "The four texels are mixed in equal parts: the nearer ones must count more."),
    Mistake(lambda x, s, t: linear(x, *crossed(x, s, t)), "The weights are exchanged: what is nearer must count more."),
]  # fmt: skip


def four(x, s, t):
    """The four texels around a point."""
    h, w, _ = x.shape
    i, j = int(np.floor(s * w - 0.5)), int(np.floor(t * h - 0.5))
    return np.array([x[b % h, a % w] for b in (j, j + 1) for a in (i, i + 1)])


def crossed(x, s, t):
    """Coordinates with the weights of both sides exchanged."""
    h, w, _ = x.shape
    u, v = s * w - 0.5, t * h - 0.5
    return (np.floor(u) + 1 - (u - np.floor(u)) + 0.5) / w, (
        np.floor(v) + 1 - (v - np.floor(v)) + 0.5
    ) / h


EXERCISE = Definition(
    title="Texture: environment, filter, repetition",
    lesson=25,
    starter=STARTER,
    parts=[
        Call(
            "GL_MODULATE and GL_REPLACE",
            "environment",
            mixtures("MODULATE") + mixtures("REPLACE"),
            environment,
            hint="MODULATE multiplies channel by channel; REPLACE takes the texel.",
            mistakes=[
                Mistake(lambda mode, f, c: environment("REPLACE", f, c), "MODULATE shows the texel alone: where is the light?"),
                Mistake(lambda mode, f, c: environment("MODULATE", f, c), "REPLACE takes the texel as it is, without the light."),
                Mistake(lambda mode, f, c: np.clip(f + c[:3], 0, 1) if mode == "MODULATE" else c[:3], "MODULATE multiplies; this is the sum (GL_ADD)."),
                Mistake(lambda mode, f, c: (f + c[:3]) / 2 if mode == "MODULATE" else c[:3], "MODULATE multiplies; this is the mean."),
                Mistake(lambda mode, f, c: f * c[:3] * c[3] if mode == "MODULATE" else c[:3], "The texel's alpha does not touch the colour in MODULATE."),
                Mistake(lambda mode, f, c: f * c[:3] if mode == "MODULATE" else f, "REPLACE takes the texel, and the lit colour is lost."),
            ],
        ),
        Call(
            "GL_DECAL",
            "environment",
            mixtures("DECAL", 12),
            environment,
            hint="A decal covers as far as it is opaque.",
            mistakes=[
                Mistake(lambda mode, f, c: environment("REPLACE", f, c), "Where the texel is transparent the lit colour must be seen."),
                Mistake(lambda mode, f, c: environment("MODULATE", f, c), "This multiplies; a decal covers."),
                Mistake(lambda mode, f, c: f * c[3] + c[:3] * (1 - c[3]), "The shares are exchanged: alpha is the texel's opacity."),
                Mistake(lambda mode, f, c: f + c[:3] * c[3], "The lit colour counts in full: the decal must take away its share."),
                Mistake(lambda mode, f, c: f * (1 - c[3]) + c[:3], "The texel counts in full, whatever its alpha."),
                Mistake(lambda mode, f, c: f * (1 - c[3]) + f * c[:3] * c[3], "The decal is multiplied by the light, but DECAL takes the texel's own colour."),
            ],
        ),
        Value(
            "texture and highlight",
            {"MODULATED": 0.25, "SEPARATE": 0.65},
            hint="What is clamped, and when, before the texture or after it?",
            wrong={
                "MODULATED": [(0.275, "The lit colour is clamped to 1 before it is multiplied."),
                              (0.15, "The highlight is missing: it is part of the lit colour."),
                              (0.65, "Without the separate colour the highlight is multiplied, too."),
                              (0.85, "MODULATE multiplies.")],
                "SEPARATE": [(0.25, "The highlight is added after the texture, so it is not multiplied."),
                             (0.15, "The highlight is missing: it is added after the texture."),
                             (1.0, "Only the diffuse light is multiplied, then the highlight is added: the sum stays below 1."),
                             (0.275, "The highlight is added after the texture, so it is not multiplied.")],
            },
        ),
        Call("the texel that covers", "nearest", INNER, nearest, hint="Which texel covers s? Multiply by their number.", mistakes=NEAREST_MISTAKES),
        Call("GL_REPEAT", "nearest", OUTER, nearest, hint="The texture begins anew at each whole number, below 0 too.", mistakes=NEAREST_MISTAKES),
        Call("GL_LINEAR", "linear", MIDDLES, linear,
             hint="How far is (s, t) from the middle of the texel to its left, in texels? That is the weight of the texel to its right; the same up and down.",
             mistakes=LINEAR_MISTAKES, points=2),
        Call("GL_LINEAR at the border", "linear", EDGES, linear,
             hint="The right neighbour of the last texel is the first one.", mistakes=LINEAR_MISTAKES),
    ],
)  # fmt: skip
