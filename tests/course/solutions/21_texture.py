import numpy as np

MODULATED = 0.25
SEPARATE = 0.65


def environment(mode, C_f, C_t):
    color, alpha = C_t[:3], C_t[3]
    if mode == "MODULATE":
        return C_f * color
    if mode == "REPLACE":
        return color
    return C_f * (1 - alpha) + color * alpha


def nearest(texels, s, t):
    h, w, _ = texels.shape
    i = int(np.floor(s * w))
    j = int(np.floor(t * h))
    return texels[j % h, i % w]


def linear(texels, s, t):
    h, w, _ = texels.shape
    x = s * w - 0.5
    y = t * h - 0.5
    i = int(np.floor(x))
    j = int(np.floor(y))
    a, b = x - i, y - j
    below = (1 - a) * texels[j % h, i % w] + a * texels[j % h, (i + 1) % w]
    above = (1 - a) * texels[(j + 1) % h, i % w] + a * texels[(j + 1) % h, (i + 1) % w]
    return (1 - b) * below + b * above
