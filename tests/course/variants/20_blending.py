RIGHT = {
    "front to back": """
import numpy as np


def over(layer, behind):
    return [layer[3] * layer[c] + (1 - layer[3]) * behind[c] for c in range(3)]


def composite(layers, depths, background):
    color, through = np.zeros(3), 1.0
    for depth, layer in sorted(zip(depths.tolist(), layers.tolist())):
        color += through * layer[3] * np.array(layer[:3])
        through *= 1 - layer[3]
    return color + through * background


def merge(front, back):
    alpha = front[3] + back[3] - front[3] * back[3]
    color = front[:3] + (1 - front[3]) * back[:3]
    return np.concatenate([color, [alpha]])


def visible(layers, depths, solid):
    return np.prod(np.where(depths < solid, 1 - layers[:, 3], 1))
""",
    "by merging": """
import math
from functools import reduce


def over(layer, behind):
    r, g, b, a = layer
    return (
        behind[0] + a * (r - behind[0]),
        behind[1] + a * (g - behind[1]),
        behind[2] + a * (b - behind[2]),
    )


def merge(front, back):
    return tuple(f + (1 - front[3]) * b for f, b in zip(front, back))


def composite(layers, depths, background):
    order = sorted(range(len(depths)), key=lambda k: depths[k])
    ready = [(a * r, a * g, a * b, a) for r, g, b, a in (layers[k] for k in order)]
    return reduce(merge, ready + [(*background, 1)])[:3]


def visible(layers, depths, solid):
    return math.prod(1 - layer[3] for layer, depth in zip(layers, depths) if depth <= solid)
""",
}

MIX = "alpha * layer[:3] + (1 - alpha) * behind"
STEP = "        color = over(layers[k], color)\n"
ORDER = "np.argsort(depths)[::-1]"
MERGE = "front + (1 - front[3]) * back"
LAYER = "share *= 1 - layer[3]"


def merged(color, alpha):
    return [("    return " + MERGE, f"    color = {color}\n    return np.array([*color[:3], {alpha}])")]


WRONG = {
    "opaque": ([(MIX, "layer[:3]")], "opaque here"),
    "added": ([(MIX, "alpha * layer[:3] + behind")], "GL_ONE"),
    "premultiplied": ([(MIX, "layer[:3] + (1 - alpha) * behind")], "premultiplied colours alone"),
    "exchanged": ([(MIX, "(1 - alpha) * layer[:3] + alpha * behind")], "not transparency"),
    "mean": ([(MIX, "(layer[:3] + behind) / 2")], "the mean"),
    "filter": ([(MIX, "layer[:3] * behind")], "multiplied"),
    "dark": ([(MIX, "alpha * layer[:3]")], "does not shine through"),
    "four numbers": ([(MIX, "alpha * layer + (1 - alpha) * behind[[0, 1, 2, 2]]")], "4 numbers; expected: 3 numbers"),
    "cleared": (
        [
            ("color = background", "color = background\n    color *= 0"),
            (STEP, "        color[:] = over(layers[k], color)\n"),
        ],
        "background is missing",
    ),
    "last layer": ([(STEP, "        color = over(layers[k], background)\n")], "Only the last layer"),
    "nearest first": ([(ORDER, "np.argsort(depths)")], "begin with the farthest"),
    "not sorted": ([(ORDER, "range(len(layers))")], "order of the rows"),
    "by alpha": ([(ORDER, "np.argsort(layers[:, 3])")], "sorted by alpha"),
    "no background": ([("color = background", "color = np.zeros(3)")], "background is missing"),
    "merge added": ([(MERGE, "front + back")], "counts in full"),
    "merge exchanged": ([(MERGE, "back + (1 - back[3]) * front")], "Front and back are exchanged"),
    "merge not premultiplied": ([(MERGE, "front[3] * front + (1 - front[3]) * back")], "alpha is in them already"),
    "merge alpha of the front": (merged(MERGE, "front[3]"), "front layer alone"),
    "merge alphas added": (merged(MERGE, "front[3] + back[3]"), "may exceed 1"),
    "merge alphas multiplied": (merged(MERGE, "front[3] * back[3]"), "it is what they let through"),
    "merge divided": (
        [("return " + MERGE, "m = " + MERGE + "\n    return np.array([*m[:3] / m[3], m[3]])")],
        "do not divide",
    ),
    "held back": ([(LAYER, "share *= layer[3]")], "1 - alpha passes"),
    "alphas added": ([(LAYER, "share -= layer[3]")], "each layer takes its share"),
    "the rest": ([("    return share", "    return 1 - share")], "hold back"),
    "all layers": ([("if depth < solid", "if True")], "are hidden"),
    "behind the wall": ([("if depth < solid", "if depth > solid")], "do the layers before the wall count"),
}
