r"""Radiosity is a linear system of $n$ equations for $n$ patches:

$$ E_i = B_i - \rho_i \sum_{j=1}^n F_{ij} B_j \qquad\text{or}\qquad E = (I - R F)\, B $$

Write `system(F, rho)`, which returns the matrix $I - R F$, (n, n), for one colour channel: `F` is the matrix of form factors, `rho`
has the reflectances of the $n$ patches. Write `solve(F, rho, E)`, which returns the radiosities $B$ of **three** channels,
(n, 3): `rho` and `E` are (n, 3) here. `numpy.linalg.solve` may be used.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, closed_room

STARTER = '''\
import numpy as np


def system(F, rho):
    """Returns the matrix I - R F (n, n) of one channel.  F: (n, n); rho: (n,)."""
    return F


def solve(F, rho, E):
    """Returns the radiosities B (n, 3).  F: (n, n); rho, E: (n, 3)."""
    return E
'''


def system(F, rho):
    return np.eye(len(F)) - rho[:, None] * F


def solve(F, rho, E):
    return np.stack(
        [np.linalg.solve(system(F, rho[:, c]), E[:, c]) for c in range(3)], axis=1
    )


def room(n):
    F, _, rho, E = closed_room(n, n)
    return F, rho, E


ROOMS = [room(n) for n in (3, 6, 10, 14)]

EXERCISE = Definition(
    title="The linear system",
    lesson=31,
    starter=STARTER,
    parts=[
        Call(
            "the matrix",
            "system",
            [(F, rho[:, 0]) for F, rho, _ in ROOMS],
            system,
            hint="On the diagonal stands 1 - rho_i F_ii, elsewhere -rho_i F_ij: rho belongs to the row.",
            mistakes=[
                Mistake(lambda F, r: np.eye(len(F)) - F * r[None, :], "rho_i belongs to row i, the patch that reflects: here it multiplies the columns."),
                Mistake(lambda F, r: np.eye(len(F)) + r[:, None] * F, "The sign is wrong: reflected light is moved to the other side of the equation."),
                Mistake(lambda F, r: np.eye(len(F)) - F, "The reflectances are missing."),
                Mistake(lambda F, r: r[:, None] * F, "I is missing: B_i itself is in the equation, too."),
                Mistake(lambda F, r: np.eye(len(F)) - r[:, None] * F.T, "F is transposed: the patch i gathers, with F_ij."),
                Mistake(lambda F, r: 1 - r[:, None] * F, "I is the identity matrix, with ones on the diagonal only."),
                Mistake(lambda F, r: r[:, None] * F - np.eye(len(F)), "This is the negative of the matrix."),
                Mistake(lambda F, r: np.eye(len(F)) - r.mean() * F, "Each patch has its own reflectance."),
            ],
            points=2,
        ),
        Call(
            "the radiosities of three channels",
            "solve",
            ROOMS,
            solve,
            hint="Solve one system for each channel, with the channel's own rho and E.",
            mistakes=[
                Mistake(lambda F, r, E: np.linalg.solve(system(F, r[:, 0]), E), "Every channel has its own matrix: here the red reflectances are used for all."),
                Mistake(lambda F, r, E: np.linalg.solve(system(F, r.mean(axis=1)), E), "The mean of the reflectances over the channels loses the colours."),
                Mistake(lambda F, r, E: np.stack([system(F, r[:, c]) @ E[:, c] for c in range(3)], axis=1), "This multiplies E by the matrix; the system has to be solved for B."),
                Mistake(lambda F, r, E: E + r * (F @ E), "This is one bounce of light: direct illumination. The system has them all."),
                Mistake(lambda F, r, E: E, "This is the emitted light alone."),
            ],
        ),
    ],
)  # fmt: skip
