r"""Jacobi's iteration gathers the light of all patches at once, from the radiosities of the step before:

$$ B_i^{(k+1)} = E_i + \rho_i \sum_j F_{ij} B_j^{(k)}, \qquad B^{(0)} = E $$

Write `sweep(F, rho, E, B)`, one step: it gets $B^{(k)}$ and returns $B^{(k+1)}$. `F` is the matrix of form factors, (n, n); `rho`, `E`
and `B` have three channels, (n, 3). Write `jacobi(F, rho, E, sweeps)`, which returns all of $B^{(0)}$ to
$B^{(\mathrm{sweeps})}$, an array (sweeps + 1, n, 3). And write `sweeps_needed(F, rho, E, small)`: the first number $k \ge 1$ for which
$B^{(k)}$ and $B^{(k-1)}$ differ by at most `small`, in every patch and channel.

The whole sequence is asked for, not only where it leads: $B^{(k)}$ is the light after $k$ bounces.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, closed_room

STARTER = '''\
import numpy as np


def sweep(F, rho, E, B):
    """Returns the radiosities (n, 3) after one more step.  F: (n, n); rho, E, B: (n, 3)."""
    return B


def jacobi(F, rho, E, sweeps):
    """Returns B of step 0, 1, ..., sweeps: (sweeps + 1, n, 3)."""
    return np.zeros((sweeps + 1, *E.shape))


def sweeps_needed(F, rho, E, small):
    """Returns the first step k >= 1 whose B differs from that of step k - 1 by at most small everywhere."""
    return 1
'''


def sweep(F, rho, E, B):
    return E + rho * (F @ B)


def gauss_seidel(F, rho, E, B):
    B = B.copy()
    for i in range(len(B)):
        B[i] = E[i] + rho[i] * (F[i] @ B)
    return B


def sequence(F, rho, E, sweeps, step=sweep, first=None):
    B = [E if first is None else first]
    for _ in range(sweeps):
        B.append(step(F, rho, E, B[-1]))
    return np.array(B)


def needed(F, rho, E, small, step=sweep, measure=np.max):
    B = sequence(F, rho, E, 200, step)
    change = [measure(step) for step in abs(np.diff(B, axis=0))]
    return 1 + next((k for k, one in enumerate(change) if one <= small), len(change))


PAIR = (
    np.array([[0.0, 0.5], [0.25, 0.0]]),
    np.array([[0.5, 0.5, 0.5], [0.8, 0.4, 0.2]]),
    np.array([[1.0, 1.0, 1.0], [0.0, 0.0, 0.0]]),
)
ROOMS = [PAIR]
for n in (3, 5, 8, 12):
    F, _, rho, E = closed_room(n, n)
    ROOMS.append((F, rho, E))
STEPS = [
    (F, rho, E, np.random.default_rng(k).uniform(0, 2, E.shape))
    for k, (F, rho, E) in enumerate(ROOMS)
]

EXERCISE = Definition(
    title="Jacobi's iteration",
    lesson=32,
    starter=STARTER,
    parts=[
        Call(
            "one step",
            "sweep",
            STEPS,
            sweep,
            hint="Each patch emits E_i, and reflects the share rho_i of what it gathers: the sum of F_ij B_j over all j.",
            mistakes=[
                Mistake(lambda F, r, E, B: B, "Nothing has changed: the patches gather no light."),
                Mistake(gauss_seidel, "Patches that come later use new values of the same step already: that is Gauss-Seidel's order. Jacobi takes all B_j from the step before."),
                Mistake(lambda F, r, E, B: r * (F @ B), "The emitted radiosity E is missing."),
                Mistake(lambda F, r, E, B: E + F @ B, "The reflectances are missing: every patch reflects all that it gathers."),
                Mistake(lambda F, r, E, B: E + r * (F.T @ B), "F is transposed: patch i gathers with row i of F."),
                Mistake(lambda F, r, E, B: E + F @ (r * B), "The light is reflected by the patch that gathers it: rho belongs to i, not to j."),
                Mistake(lambda F, r, E, B: r * (E + F @ B), "E_i is emitted, not reflected: rho_i multiplies the sum only."),
                Mistake(lambda F, r, E, B: B + r * (F @ B), "The old B_i stays in the result: the equation begins with E_i."),
                Mistake(lambda F, r, E, B: B + E + r * (F @ B), "The old B_i is added: the equation begins with E_i alone."),
                Mistake(lambda F, r, E, B: E + r * (F @ E), "This gathers E, not B: only the first step would be right."),
                Mistake(lambda F, r, E, B: E - r * (F @ B), "Gathered light is added, not taken away."),
                Mistake(lambda F, r, E, B: E + r.mean(axis=1, keepdims=True) * (F @ B), "Each channel has its own reflectance."),
                Mistake(lambda F, r, E, B: E + r * B, "The form factors are missing: each patch reflects its own light."),
            ],
            points=2,
        ),
        Call(
            "the sequence",
            "jacobi",
            [(*room, k) for k, room in zip((1, 2, 3, 5, 4), ROOMS, strict=True)],
            sequence,
            hint="Step 0 is E; every further step is sweep of the one before.",
            mistakes=[
                Mistake(lambda *a: sequence(*a, first=np.zeros(a[2].shape)), "The sequence begins with B = 0, in the dark; it should begin with B = E, the lamps."),
                Mistake(lambda *a: np.repeat(sequence(*a)[-1:], a[3] + 1, axis=0), "All steps are equal to the last: the same array was changed and kept again and again. Keep a copy of each step."),
                Mistake(lambda *a: sequence(*a)[::-1], "The order is reversed: step 0 comes first."),
                Mistake(lambda *a: sequence(a[0], a[1], a[2], a[3] + 1)[1:], "The sequence begins with step 1; step 0, B = E, comes first."),
                Mistake(lambda *a: sequence(*a, step=gauss_seidel), "This is the sequence of Gauss-Seidel: within a step new values are used already."),
                Mistake(lambda F, r, E, k: np.array([E] + [sweep(F, r, E, E)] * k), "From step 2 on nothing changes: each step must gather from the one before, not from E."),
                Mistake(lambda *a: np.diff(sequence(*a), axis=0, prepend=0), "These are the single bounces; their sum up to step k is asked for."),
            ],
            points=2,
        ),
        Call(
            "how many steps",
            "sweeps_needed",
            [(*room, small) for room in ROOMS for small in (0.3, 0.02, 1e-3, 1e-5)],
            needed,
            hint="Compare B of step k with that of step k - 1, in all patches and channels, and count the steps done.",
            mistakes=[
                Mistake(lambda *a: needed(*a) - 1, "This is one too small: if step k changes little, the answer is k, for step k had to be done to see it."),
                Mistake(lambda *a: needed(*a) + 1, "This is one too large: step 1 is the first one, and it counts as 1."),
                Mistake(lambda *a: needed(*a, measure=np.mean), "The mean change is small while single patches still change much: the largest change counts."),
                Mistake(lambda *a: needed(*a, measure=np.sum), "The sum of all changes grows with the number of patches: the largest change counts."),
                Mistake(lambda *a: needed(*a, measure=np.linalg.norm), "This is the length of the vector of all changes; the largest single one counts."),
                Mistake(lambda *a: needed(*a, measure=lambda d: d[:, 0].max()), "Only the red channel is looked at."),
                Mistake(lambda *a: needed(*a, measure=np.min), "One patch that changes little is not enough: all must."),
                Mistake(lambda *a: needed(*a, step=gauss_seidel), "This is the number for Gauss-Seidel's order, which needs fewer sweeps."),
            ],
        ),
    ],
)  # fmt: skip
