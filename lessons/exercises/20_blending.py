r"""A transparent layer of colour $C_s$ and opacity $\alpha_s$ before what the picture holds already, $C_d$:

$$ C = \alpha_s\, C_s + (1 - \alpha_s)\, C_d $$

Write

- `over(layer, behind)`: the colour $C$, three numbers. `layer` is red, green, blue, alpha; `behind` three numbers.
- `composite(layers, depths, background)`: the colour of a pixel that several layers cover. `layers` has a row of four
  numbers for each layer, in any order; `depths` its distance from the eye; `background` three numbers.
- `merge(front, back)`: one layer that looks like two, before every background: red, green, blue, alpha. All three are
  **premultiplied**: their colour is $\alpha C$ already.
- `visible(layers, depths, solid)`: the share of light from behind all layers that reaches the eye, a number; `solid` is the
  distance of an opaque wall: it hides all layers behind it, and the share is that of the wall's own light.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake

STARTER = '''\
import numpy as np


def over(layer, behind):
    """The colour of a layer (red, green, blue, alpha) before another colour: three numbers."""
    return behind


def composite(layers, depths, background):
    """The colour of a pixel.  layers: (n, 4).  depths: n distances from the eye.  background: three numbers."""
    return background


def merge(front, back):
    """One premultiplied layer for two, four numbers."""
    return front


def visible(layers, depths, solid):
    """The share of light of a wall at the distance ``solid`` that passes the layers before it, a number."""
    return 1.0
'''


def over(layer, behind):
    return layer[3] * layer[:3] + (1 - layer[3]) * behind


def stacked(layers, background, mix=over):
    """Layers laid over each other, the last one in front."""
    for layer in layers:
        background = mix(layer, background)
    return background


def composite(layers, depths, background):
    return stacked(layers[np.argsort(-depths)], background)


def merge(front, back):
    return front + (1 - front[3]) * back


def visible(layers, depths, solid):
    return float(np.prod(1 - layers[depths < solid, 3]))


RNG = np.random.default_rng(20)
RED, BLUE = np.array([0.9, 0.1, 0.1, 0.5]), np.array([0.1, 0.2, 0.9, 0.4])
WHITE = np.ones(3)
PAIRS = [(RED, WHITE), (np.array([0.0, 1.0, 0.0, 0.25]), np.array([1.0, 0.0, 0.0]))]
PAIRS += [(row[:4], row[4:]) for row in RNG.uniform(0, 1, (15, 7))]
EXTREMES = [
    (np.array([0.2, 0.4, 0.6, 0.0]), WHITE),
    (np.array([0.2, 0.4, 0.6, 1.0]), WHITE),
]


def pile(count, rising=None):
    """Layers with depths: from far to near, from near to far, or mixed."""
    depths = RNG.permutation(np.arange(1.0, count + 1)) + RNG.uniform(0, 0.5, count)
    if rising is not None:
        depths = np.sort(depths) if rising else -np.sort(-depths)
    layers = np.column_stack(
        [RNG.uniform(0, 1, (count, 3)), RNG.uniform(0.2, 0.9, count)]
    )
    return layers, depths


FAR_FIRST = [(np.array([BLUE, RED]), np.array([2.0, 1.0]), WHITE)]
FAR_FIRST += [(*pile(n, rising=False), RNG.uniform(0, 1, 3)) for n in (2, 3, 4, 6)]
MIXED = [(np.array([RED, BLUE]), np.array([1.0, 2.0]), WHITE)]
MIXED += [(*pile(n), RNG.uniform(0, 1, 3)) for n in (3, 4, 5, 5, 6, 8, 8)]
MIXED += [(*pile(n, rising=True), RNG.uniform(0, 1, 3)) for n in (3, 5)]


def premultiplied(layer):
    return np.array([*layer[3] * layer[:3], layer[3]])


MERGED = [(premultiplied(RED), premultiplied(BLUE))]
MERGED += [tuple(map(premultiplied, pile(2)[0])) for _ in range(12)]
BEHIND_ALL = [(np.array([RED, BLUE]), np.array([1.0, 2.0]), 3.0)]
BEHIND_ALL += [(*pile(n), 20.0) for n in (1, 3, 4, 6)]
BETWEEN = [(np.array([RED, BLUE]), np.array([1.0, 2.0]), 1.5)]
BETWEEN += [(*pile(6), wall) for wall in (0.5, 1.8, 2.8, 3.8, 4.8, 5.8)]

EXERCISE = Definition(
    title="The order of blending",
    lesson=24,
    starter=STARTER,
    parts=[
        Call(
            "one layer",
            "over",
            PAIRS + EXTREMES,
            over,
            hint="Alpha is the share of the layer, and the rest is the share of what lies behind.",
            mistakes=[
                Mistake(lambda s, d: s[:3], "The layer covers what is behind: it is opaque here."),
                Mistake(lambda s, d: s[3] * s[:3], "What is behind does not shine through."),
                Mistake(lambda s, d: s[3] * s[:3] + d, "The background counts in full: the layer must take away its share. (That is GL_SRC_ALPHA, GL_ONE.)"),
                Mistake(lambda s, d: s[:3] + (1 - s[3]) * d, "The layer counts in full; that is right for premultiplied colours alone."),
                Mistake(lambda s, d: (1 - s[3]) * s[:3] + s[3] * d, "The shares are exchanged: alpha is opacity, not transparency."),
                Mistake(lambda s, d: s[3] * d + s[3] * s[:3], "Both have the share alpha; together the shares must be 1."),
                Mistake(lambda s, d: (s[:3] + d) / 2, "This is the mean: alpha does not count."),
                Mistake(lambda s, d: np.clip(s[:3] + d, 0, 1), "The colours are added; blending mixes them."),
                Mistake(lambda s, d: s[:3] * d, "The colours are multiplied, as a filter does; blending mixes them."),
            ],
        ),
        Call(
            "several layers, the farthest first",
            "composite",
            FAR_FIRST,
            composite,
            hint="Lay the layers over the background one after the other, each over the result of those before.",
            mistakes=[
                Mistake(lambda s, z, b: over(s[-1], b), "Only the last layer counts: what the picture holds already is the result so far, not the background."),
                Mistake(lambda s, z, b: over(s[0], b), "Only the first layer counts."),
                Mistake(lambda s, z, b: stacked(s[::-1], b), "The nearest layer is laid first, and the farthest covers it: begin with the farthest."),
                Mistake(lambda s, z, b: np.mean([over(one, b) for one in s], axis=0), "Layers are not averaged: each is laid over the result of those before."),
                Mistake(lambda s, z, b: stacked(s[np.argsort(s[:, 3])], b), "They are sorted by alpha, not by distance."),
                Mistake(lambda s, z, b: stacked(s[np.argsort(-s[:, 3])], b), "They are sorted by alpha, not by distance."),
                Mistake(lambda s, z, b: stacked(s, np.zeros(3)), "The background is missing: it is what is behind the farthest layer."),
            ],
        ),
        Call(
            "several layers, in any order",
            "composite",
            MIXED,
            composite,
            hint="The order of the rows does not say which layer is nearer: the distances do. What is farther away is laid first.",
            mistakes=[
                Mistake(lambda s, z, b: stacked(s, b), "The layers are laid in the order of the rows: sort them by their distance."),
                Mistake(lambda s, z, b: stacked(s[::-1], b), "The layers are laid in the reverse order of the rows: sort them by their distance."),
                Mistake(lambda s, z, b: stacked(s[np.argsort(z)], b), "They are sorted, but the nearest is laid first: begin with the farthest."),
                Mistake(lambda s, z, b: stacked(s[np.argsort(s[:, 3])], b), "They are sorted by alpha, not by distance."),
            ],
            points=2,
        ),
        Call(
            "two layers in one, premultiplied",
            "merge",
            MERGED,
            merge,
            hint="What passes the front layer, 1 minus its alpha, is the share of the back one, in colour and in alpha.",
            mistakes=[
                Mistake(lambda f, b: f + b, "The back layer counts in full: the front one covers a share of it."),
                Mistake(lambda f, b: b + (1 - b[3]) * f, "Front and back are exchanged."),
                Mistake(lambda f, b: f[3] * f + (1 - f[3]) * b, "The colours are premultiplied: alpha is in them already, so the front layer counts as it is."),
                Mistake(lambda f, b: np.array([*(f[3] * f[:3] + (1 - f[3]) * b[:3]), f[3] + (1 - f[3]) * b[3]]), "The colours are premultiplied: alpha is in them already, so the front colour counts as it is."),
                Mistake(lambda f, b: np.array([*(f + (1 - f[3]) * b)[:3], f[3]]), "The alpha is that of the front layer alone: two layers cover more than one."),
                Mistake(lambda f, b: np.array([*(f + (1 - f[3]) * b)[:3], f[3] + b[3]]), "The alphas are added, and may exceed 1: the back layer covers a share of what the front one leaves."),
                Mistake(lambda f, b: np.array([*(f + (1 - f[3]) * b)[:3], f[3] * b[3]]), "The alphas are multiplied; it is what they let through, 1 - alpha, that is multiplied."),
                Mistake(lambda f, b: np.array([*(f + (1 - f[3]) * b[3] * b)[:3], f[3] + (1 - f[3]) * b[3]]), "The back colour is multiplied by its alpha once more: it is premultiplied already."),
                Mistake(lambda f, b: np.array([*merge(f, b)[:3] / merge(f, b)[3], merge(f, b)[3]]), "The result must be premultiplied too: do not divide by alpha."),
            ],
        ),
        Call(
            "what passes all layers",
            "visible",
            BEHIND_ALL,
            visible,
            hint="Each layer lets the share 1 - alpha pass, and what passes one meets the next.",
            mistakes=[
                Mistake(lambda s, z, w: 1.0, "All light passes: do the layers before the wall count?"),
                Mistake(lambda s, z, w: 1 - np.prod(1 - s[z < w, 3]), "This is what the layers hold back; what passes is asked for."),
                Mistake(lambda s, z, w: np.prod(s[z < w, 3]), "Alpha is what a layer holds back; 1 - alpha passes."),
                Mistake(lambda s, z, w: 1 - s[z < w, 3].sum(), "The alphas are added, and may exceed 1: each layer takes its share of what is left."),
                Mistake(lambda s, z, w: np.clip(1 - s[z < w, 3].sum(), 0, None), "The alphas are added: each layer takes its share of what is left, so the shares are multiplied."),
                Mistake(lambda s, z, w: 1 - s[z < w, 3].mean(), "Layers are not averaged: each takes its share of what is left."),
                Mistake(lambda s, z, w: 1 - s[z < w, 3].max(), "Only the densest layer counts."),
            ],
        ),
        Call(
            "a wall between the layers",
            "visible",
            BETWEEN,
            visible,
            hint="Only layers that are nearer than the wall are before it.",
            mistakes=[
                Mistake(lambda s, z, w: np.prod(1 - s[:, 3]), "Layers behind the wall count too: the wall is opaque, and they are hidden."),
                Mistake(lambda s, z, w: np.prod(1 - s[z > w, 3]), "The layers behind the wall are taken, not those before it."),
            ],
        ),
    ],
)  # fmt: skip
