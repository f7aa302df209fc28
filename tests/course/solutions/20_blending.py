import numpy as np


def over(layer, behind):
    alpha = layer[3]
    return alpha * layer[:3] + (1 - alpha) * behind


def composite(layers, depths, background):
    color = background
    for k in np.argsort(depths)[::-1]:
        color = over(layers[k], color)
    return color


def merge(front, back):
    return front + (1 - front[3]) * back


def visible(layers, depths, solid):
    share = 1.0
    for layer, depth in zip(layers, depths, strict=True):
        if depth < solid:
            share *= 1 - layer[3]
    return share
