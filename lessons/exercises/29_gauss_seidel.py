r"""Gauss-Seidel's iteration visits one patch after the other, and each takes the new values of those visited before it:

$$ B_i^{(k+1)} = E_i + \rho_i \Big( \sum_{j<i} F_{ij} B_j^{(k+1)} + \sum_{j>i} F_{ij} B_j^{(k)} \Big), \qquad B^{(0)} = E $$

Write `sweep(F, rho, E, B)`: it visits the patches 0, 1, ..., n - 1 once, and returns $B^{(k+1)}$ for $B^{(k)}$. `F` is the matrix of
form factors, (n, n), with zeros on its diagonal; `rho`, `E` and `B` have three channels, (n, 3). Write `gauss_seidel(F, rho, E, sweeps)`, which
returns all of $B^{(0)}$ to $B^{(\mathrm{sweeps})}$, an array (sweeps + 1, n, 3). And write `backwards(F, rho, E, B)`: one sweep that
visits the patches in the order n - 1, ..., 1, 0.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, closed_room

STARTER = '''\
import numpy as np


def sweep(F, rho, E, B):
    """Returns the radiosities (n, 3) after one sweep.  F: (n, n); rho, E, B: (n, 3)."""
    return B


def gauss_seidel(F, rho, E, sweeps):
    """Returns B of sweep 0, 1, ..., sweeps: (sweeps + 1, n, 3)."""
    return np.zeros((sweeps + 1, *E.shape))


def backwards(F, rho, E, B):
    """Returns the radiosities (n, 3) after one sweep from the last patch to the first."""
    return B
'''


def visited(F, rho, E, B, order):
    B = B.copy()
    for i in order:
        B[i] = E[i] + rho[i] * (F[i] @ B)
    return B


def sweep(F, rho, E, B):
    return visited(F, rho, E, B, range(len(B)))


def backwards(F, rho, E, B):
    return visited(F, rho, E, B, reversed(range(len(B))))


def jacobi(F, rho, E, B):
    return E + rho * (F @ B)


def new_only(F, rho, E, B):
    """The sum over j < i alone: patches that were not visited yet send nothing."""
    return visited(F, rho, E, np.zeros(B.shape), range(len(B)))


def added(F, rho, E, B):
    """The gathered light added to the old B_i instead of E_i."""
    B = B.copy()
    for i in range(len(B)):
        B[i] += rho[i] * (F[i] @ B)
    return B


def sequence(F, rho, E, sweeps, step=sweep, first=None):
    B = [E if first is None else first]
    for _ in range(sweeps):
        B.append(step(F, rho, E, B[-1]))
    return np.array(B)


TRIO = (
    np.array([[0.0, 0.5, 0.25], [0.25, 0.0, 0.5], [0.5, 0.5, 0.0]]),
    np.array([[0.5, 0.5, 0.5], [0.8, 0.4, 0.2], [0.6, 0.5, 0.4]]),
    np.array([[1.0, 1.0, 1.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]),
)
ROOMS = [TRIO]
for n in (4, 5, 8, 12):
    F, _, rho, E = closed_room(n, n)
    ROOMS.append((F, rho, E))
STEPS = [
    (F, rho, E, np.random.default_rng(k).uniform(0, 2, E.shape))
    for k, (F, rho, E) in enumerate(ROOMS)
]

EXERCISE = Definition(
    title="Gauss-Seidel's iteration",
    lesson=32,
    starter=STARTER,
    parts=[
        Call(
            "one sweep",
            "sweep",
            STEPS,
            sweep,
            hint="Visit one patch after the other. Each gathers from all others, and what it gets is used by those that follow.",
            mistakes=[
                Mistake(lambda F, r, E, B: B, "Nothing has changed: the patches gather no light."),
                Mistake(jacobi, "All patches gather from the sweep before: that is Jacobi's order. Gauss-Seidel uses the new value of every patch that was visited already."),
                Mistake(backwards, "The patches are visited from the last to the first; begin with patch 0."),
                Mistake(lambda *a: backwards(*a[:3], sweep(*a)), "This sweeps twice, forwards and back; once is asked for."),
                Mistake(lambda *a: sweep(*a[:3], sweep(*a)), "These are two sweeps; one is asked for."),
                Mistake(new_only, "Patches that were not visited yet send nothing: their old values belong into the sum."),
                Mistake(lambda F, r, E, B: E + r * (np.triu(F) @ B), "Patches that were visited already send nothing: their new values belong into the sum."),
                Mistake(lambda F, r, E, B: sweep(F, r, 0 * E, B), "The emitted radiosity E is missing."),
                Mistake(lambda F, r, E, B: sweep(F, np.ones(r.shape), E, B), "The reflectances are missing: every patch reflects all that it gathers."),
                Mistake(lambda F, r, E, B: sweep(F.T, r, E, B), "F is transposed: patch i gathers with row i of F."),
                Mistake(lambda F, r, E, B: sweep(F, r, r * E, B), "E_i is emitted, not reflected: rho_i multiplies the sum only."),
                Mistake(lambda F, r, E, B: sweep(F, r, E, E), "This begins with E, not with the B that it gets: only the first sweep would be right."),
                Mistake(added, "The old B_i stays in the result: the equation begins with E_i."),
                Mistake(lambda F, r, E, B: sweep(F, np.repeat(r.mean(axis=1, keepdims=True), 3, axis=1), E, B), "Each channel has its own reflectance."),
            ],
            points=3,
        ),
        Call(
            "the sequence",
            "gauss_seidel",
            [(*room, k) for k, room in zip((1, 2, 3, 5, 4), ROOMS, strict=True)],
            sequence,
            hint="Sweep 0 is E; every further one begins with the result of the one before.",
            mistakes=[
                Mistake(lambda *a: sequence(*a, first=np.zeros(a[2].shape)), "The sequence begins with B = 0, in the dark; it should begin with B = E, the lamps."),
                Mistake(lambda *a: np.repeat(sequence(*a)[-1:], a[3] + 1, axis=0), "All sweeps are equal to the last: the same array was changed and kept again and again. Keep a copy of each."),
                Mistake(lambda *a: np.repeat(sequence(*a, step=added)[-1:], a[3] + 1, axis=0), "E itself was changed, and all sweeps are one array: sweep must not change the B that it gets."),
                Mistake(lambda *a: sequence(a[0], a[1], a[2], a[3] + 1)[1:], "The sequence begins after the first sweep; sweep 0, B = E, comes first."),
                Mistake(lambda *a: np.concatenate([sequence(*a)[1:], sequence(*a)[-1:]]), "Sweep 0 was changed by sweep 1, and each one by the next: sweep must not change the B that it gets."),
                Mistake(lambda *a: sequence(*a, step=jacobi), "This is the sequence of Jacobi: the light moves on by one bounce in each sweep."),
                Mistake(lambda F, r, E, k: np.array([E] + [sweep(F, r, E, E)] * k), "From sweep 2 on nothing changes: each must begin with the one before, not with E."),
                Mistake(lambda *a: sequence(*a, step=backwards), "The patches are visited from the last to the first; begin with patch 0."),
            ],
            points=2,
        ),
        Call(
            "the other way round",
            "backwards",
            STEPS,
            backwards,
            hint="Now the last patch gathers first, and the first one gets the new values of all others.",
            mistakes=[
                Mistake(sweep, "The patches are visited from the first to the last, as in sweep: which ones have new values depends on the order."),
                Mistake(jacobi, "The order makes no difference here: all patches gather old values, as with Jacobi."),
                Mistake(lambda *a: sweep(*a)[::-1], "This reverses the result of sweep; the order of the visits is to be reversed."),
                Mistake(lambda *a: visited(*a, range(len(a[3]) - 1, 0, -1)), "Patch 0 is not visited."),
                Mistake(lambda *a: visited(*a, range(len(a[3]) - 2, -1, -1)), "The last patch is not visited."),
                Mistake(lambda *a: backwards(*a[:3], sweep(*a)), "This sweeps forwards and back; one sweep is asked for."),
            ],
        ),
    ],
)  # fmt: skip
