r"""Shooting, or progressive refinement: the patch that has the most **power not yet sent**, $A_i\, \Delta B_i$ (summed over the channels), sends it to all others at once:

$$ B_j \mathrel{+}= \rho_j F_{ji}\, \Delta B_i , \qquad \Delta B_j \mathrel{+}= \rho_j F_{ji}\, \Delta B_i \quad (j \ne i), \qquad \Delta B_i = 0 $$

It begins with $B = \Delta B = E$. Write `shooter(A, unsent)`: the number of the patch that shoots next; `A` are the areas, (n,), `unsent` is $\Delta B$, (n, 3). Write
`shoot(F, rho, B, unsent, i)`: patch $i$ shoots; returns the new $B$ and the new $\Delta B$, together an array (2, n, 3). `F` is the matrix of form factors, (n, n); `rho`, `B`, `unsent` are (n, 3). Write
`shooting(F, A, rho, E, shots)`: $B$ after 0, 1, ..., `shots` shots, an array (shots + 1, n, 3).
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, closed_room

STARTER = '''\
import numpy as np


def shooter(A, unsent):
    """Returns the number of the patch with the most unsent power.  A: areas (n,); unsent: (n, 3)."""
    return 0


def shoot(F, rho, B, unsent, i):
    """Returns the new B and the new unsent, an array (2, n, 3), after patch i has shot."""
    return np.array([B, unsent])


def shooting(F, A, rho, E, shots):
    """Returns B after 0, 1, ..., shots shots: (shots + 1, n, 3)."""
    return np.zeros((shots + 1, *E.shape))
'''


def shooter(A, unsent):
    return int(np.argmax(A * unsent.sum(axis=1)))


def shoot(F, rho, B, unsent, i, received=None, rest=0.0, keep=1.0, show=1.0):
    """received, rest, keep, show: what mistakes change."""
    if received is None:
        received = rho * F[:, i, None] * unsent[i]
    waiting = keep * unsent + received
    waiting[i] = rest * unsent[i] + received[i]
    return np.array([B + show * received, waiting])


def sequence(F, A, rho, E, shots, choose=shooter, step=shoot, first=1.0):
    B, unsent = first * E, E
    result = [B]
    for k in range(shots):
        i = choose(A, unsent) if choose is not None else k % len(E)
        B, unsent = step(F, rho, B, unsent, i)
        result.append(B)
    return np.array(result)


def by_brightest_B(F, A, rho, E, shots):
    B, unsent, result = E, E, [E]
    for _ in range(shots):
        B, unsent = shoot(F, rho, B, unsent, shooter(A, B))
        result.append(B)
    return np.array(result)


RNG = np.random.default_rng(30)
ROOMS = [closed_room(n, n) for n in (4, 5, 8, 12)]
UNSENT = [(np.array([1.0, 4.0]), np.array([[3.0, 3.0, 3.0], [1.0, 1.0, 1.0]]))]
UNSENT += [
    (RNG.uniform(0.2, 3, n), RNG.uniform(0, 2, (n, 3))) for n in [3, 5, 8, 20] * 6
]
PAIR = (
    np.array([[0.0, 0.5], [0.25, 0.0]]),
    np.array([[0.5, 0.5, 0.5], [0.8, 0.4, 0.2]]),
    np.array([[1.0, 1.0, 1.0], [0.2, 0.2, 0.2]]),
    np.array([[1.0, 1.0, 1.0], [0.1, 0.1, 0.1]]),
    0,
)
SHOTS = [PAIR] + [
    (F, rho, *RNG.uniform(0, 2, (2, *E.shape)), int(RNG.integers(len(E))))
    for F, _, rho, E in ROOMS
]

EXERCISE = Definition(
    title="Shooting",
    lesson=32,
    starter=STARTER,
    parts=[
        Call(
            "who shoots next",
            "shooter",
            UNSENT,
            shooter,
            hint="Power is area times radiosity; add the three channels, and take the patch with most of it.",
            mistakes=[
                Mistake(lambda A, u: np.argmax(u.sum(axis=1)), "This is the brightest patch. The area counts, too: a large dim patch may have more power."),
                Mistake(lambda A, u: np.argmax(A), "This is the largest patch; its radiosity counts, too."),
                Mistake(lambda A, u: np.argmax(u.sum(axis=1) / A), "The radiosity is divided by the area; power is their product."),
                Mistake(lambda A, u: np.argmin(A * u.sum(axis=1)), "This is the patch with the least power."),
                Mistake(lambda A, u: np.argmax(A * u[:, 0]), "Only the red channel is looked at."),
                Mistake(lambda A, u: np.argmax(A * u.max(axis=1)), "The channels are to be added; this takes the brightest one."),
                Mistake(lambda A, u: shooter(A, u) + 1, "Patches are numbered from 0."),
                Mistake(lambda A, u: (A * u.sum(axis=1)).max(), "This is the power itself; the number of the patch is asked for."),
            ],
        ),
        Call(
            "one shot",
            "shoot",
            SHOTS,
            shoot,
            hint="What j receives is added to both its B and its unsent part; the shooter has nothing left to send.",
            mistakes=[
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i, r * F[i][:, None] * u[i]), "This is F_ij, row i. Patch j receives rho_j F_ji times the shooter's radiosity: by reciprocity the areas differ."),
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i, rest=1.0), "The shooter keeps what it has sent: it would shoot the same light again and again. Its unsent part becomes 0."),
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i, r[i] * F[:, i, None] * u[i]), "The light is reflected by the patch that receives it: rho_j, not rho_i."),
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i, F[:, i, None] * u[i]), "The reflectances are missing: each patch reflects a share of what it receives."),
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i, r * u[i] * (np.arange(len(u)) != i)[:, None]), "The form factors are missing."),
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i, r * F[:, i, None] * B[i]), "The shooter sends all its radiosity B_i: what was sent before must not be sent again."),
                Mistake(lambda F, r, B, u, i: np.array([shoot(F, r, B, u, i)[0], np.where((np.arange(len(u)) == i)[:, None], 0, u)]), "What a patch receives it has to send on later: it belongs to its unsent part, too."),
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i, keep=0.0), "The unsent part of the others is replaced; what they had not sent yet is lost. Add to it."),
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i, show=0.0), "The received light is missing in B."),
                Mistake(lambda F, r, B, u, i: shoot(F, r, B, u, i)[::-1], "B comes first, then the unsent part."),
                Mistake(lambda F, r, B, u, i: np.array([shoot(F, r, B, u, i)[0] - u * (np.arange(len(u)) == i)[:, None], shoot(F, r, B, u, i)[1]]), "The shooter's own B must stay: it goes on shining."),
            ],
            points=2,
        ),
        Call(
            "the sequence",
            "shooting",
            [(*room, k) for room, k in zip(ROOMS, (1, 4, 10, 20), strict=True)],
            sequence,
            hint="Begin with B and the unsent part both equal to E; then choose a patch and let it shoot, again and again.",
            mistakes=[
                Mistake(lambda *a: sequence(*a, first=0.0), "B begins with 0: the lamps themselves are dark. Begin with E."),
                Mistake(lambda *a: np.repeat(sequence(*a)[-1:], a[4] + 1, axis=0), "All are equal to the last: the same array was changed and kept again and again. Keep a copy of each."),
                Mistake(lambda *a: sequence(*a, choose=None), "The patches shoot in turn; the one with the most unsent power shoots."),
                Mistake(lambda *a: sequence(*a, choose=lambda A, u: int(np.argmax(u.sum(axis=1)))), "The brightest patch shoots; the one with the most unsent power should."),
                Mistake(by_brightest_B, "The patch with the largest A B shoots, though it may have sent everything: look at the unsent part."),
                Mistake(lambda *a: sequence(*a[:4], a[4] + 1)[1:], "This begins after the first shot; B = E, after no shot, comes first."),
                Mistake(lambda F, A, r, E, k: np.array([sum([np.linalg.matrix_power(r[:, c, None] * F, m) @ E[:, c] for m in range(j + 1)], 0 * E[:, 0]) for j in range(k + 1) for c in range(3)]).reshape(k + 1, 3, -1).transpose(0, 2, 1),
                        "This is gathering by Jacobi: all patches at once. In a shot one patch sends."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
