# ruff: noqa: E501
RIGHT = {
    "with loops": """
def shooter(A, unsent):
    power = [a * sum(u) for a, u in zip(A, unsent)]
    return power.index(max(power))


def shoot(F, rho, B, unsent, i):
    n = len(B)
    new, waiting = [list(b) for b in B], [list(u) for u in unsent]
    for j in range(n):
        if j == i:
            continue
        for c in range(3):
            light = rho[j][c] * F[j][i] * unsent[i][c]
            new[j][c] += light
            waiting[j][c] += light
    waiting[i] = [0, 0, 0]
    return new, waiting


def shooting(F, A, rho, E, shots):
    result, unsent = [E], E
    while len(result) <= shots:
        B, unsent = shoot(F, rho, result[-1], unsent, shooter(A, unsent))
        result.append(B)
    return [[list(b) for b in B] for B in result]
""",
    "in place, with copies": """
import numpy as np


def shooter(A, unsent):
    return np.array([np.argsort(A @ np.diag(unsent @ np.ones(3)))[-1]])


def shoot(F, rho, B, unsent, i):
    state = np.stack([B, unsent])
    state[1, i] = 0
    state += rho * np.outer(F[:, i], unsent[i])
    return state


def shooting(F, A, rho, E, shots):
    steps = np.empty((shots + 1, *E.shape))
    state = np.stack([E, E])
    for k in range(shots + 1):
        steps[k] = state[0]
        state = shoot(F, rho, *state, int(shooter(A, state[1])[0]))
    return steps
""",
}

CHOSEN = "np.argmax(A * unsent.sum(axis=1))"
LIGHT = "rho * F[:, i, None] * unsent[i]"
NEXT = "shooter(A, unsent))"
WRONG = {
    "brightest": ([(CHOSEN, "np.argmax(unsent.sum(axis=1))")], "brightest patch"),
    "largest": ([(CHOSEN, "np.argmax(A)")], "largest patch"),
    "divided": ([(CHOSEN, "np.argmax(unsent.sum(axis=1) / A)")], "divided by the area"),
    "least": ([(CHOSEN, "np.argmin(A * unsent.sum(axis=1))")], "least power"),
    "red": ([(CHOSEN, "np.argmax(A * unsent[:, 0])")], "red channel"),
    "counted from 1": ([(CHOSEN, CHOSEN + " + 1")], "numbered from 0"),
    "power itself": ([(CHOSEN, "np.max(A * unsent.sum(axis=1))")], "power itself"),
    "F_ij": ([("F[:, i, None]", "F[i][:, None]")], "F_ij, row i"),
    "not reset": ([("    waiting[i] = 0\n", "")], "again and again"),
    "rho of the shooter": ([(LIGHT, "rho[i] * F[:, i, None] * unsent[i]")], "not rho_i"),
    "no reflectance": ([(LIGHT, "F[:, i, None] * unsent[i]")], "reflectances are missing"),
    "all of B sent": ([(LIGHT, "rho * F[:, i, None] * B[i]")], "sent before"),
    "nothing passed on": ([("waiting = unsent + received", "waiting = unsent.copy()")], "send on later"),
    "unsent replaced": ([("waiting = unsent + received", "waiting = 1 * received")], "is lost"),
    "B unchanged": ([("B = B + received", "B = 1 * B")], "missing in B"),
    "order of the results": ([("np.array([B, waiting])", "np.array([waiting, B])")], "B comes first"),
    "shooter dark": ([("waiting[i] = 0", "waiting[i] = 0\n    B[i] -= unsent[i]")], "goes on shining"),
    "from the dark": ([("B, unsent = E, E", "B, unsent = 0 * E, E")], "lamps themselves"),
    "the same array": ([("B, unsent = E, E", "B, unsent = 1 * E, E"), ("        B, unsent = shoot(", "        B[:], unsent = shoot(")], "Keep a copy"),
    "in turn": ([("for _ in", "for k in"), (NEXT, "k % len(E))")], "in turn"),
    "largest B": ([(NEXT, "shooter(A, B))")], "sent everything"),
    "without the beginning": ([("np.array(steps)", "np.array(steps[1:])")], "expected: a 2 x 4 x 3 array"),
    "sum of the squares": ([(NEXT, "np.argmax((A[:, None] * unsent**2).sum(axis=1)))")], "choose a patch"),
}  # fmt: skip
