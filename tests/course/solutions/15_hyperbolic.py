MIDDLE = 1 / 4
MIDDLE_AFFINE = 1 / 2


def affine(s, f_1, f_2):
    return (1 - s) * f_1 + s * f_2


def hyperbolic(s, f_1, f_2, w_1, w_2):
    return affine(s, f_1 / w_1, f_2 / w_2) / affine(s, 1 / w_1, 1 / w_2)


def in_triangle(s, f, w):
    share = s / w
    return share @ f / share.sum()
