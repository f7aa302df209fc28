r"""Form factors obey two laws. **Reciprocity**: $A_i F_{ij} = A_j F_{ji}$. **Closure**: in a closed room all that leaves a patch
arrives somewhere, so every row sums to 1.

Write `reverse(F_ij, A_i, A_j)`, which returns $F_{ji}$. Write `completed(upper, areas)`: of a closed room of $n$ flat patches the form
factors above the diagonal are known, `upper[i, j]` for $i < j$ (the rest of the array is 0); return the whole matrix
$F$, (n, n). Write `absorbed(B, E, rho, F, areas)`: the power that all patches absorb, $\sum_i A_i (1 - \rho_i) H_i$, where
$H_i = \sum_j F_{ij} B_j$ is what arrives at patch $i$ per unit of area. (At the solution it equals the power emitted.)
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, closed_room

STARTER = '''\
import numpy as np


def reverse(F_ij, A_i, A_j):
    """Returns F_ji."""
    return F_ij


def completed(upper, areas):
    """Returns the whole matrix F (n, n).  upper: F_ij for i < j, else 0.  areas: (n,)."""
    return upper


def absorbed(B, E, rho, F, areas):
    """Returns the power that all patches absorb, a number.  B, E, rho, areas: (n,); F: (n, n)."""
    return 0.0
'''


def completed(upper, areas):
    return upper + (upper * areas[:, None] / areas[None, :]).T


def absorbed(B, E, rho, F, areas):
    return float(np.sum(areas * (1 - rho) * (F @ B)))


def room(n):
    """A closed room in one channel: form factors, areas, reflectances, exitances and the solution."""
    F, areas, rho, E = closed_room(n, n)
    rho, E = rho[:, 0], E[:, 0]
    return F, areas, rho, E, np.linalg.solve(np.eye(n) - rho[:, None] * F, E)


ROOMS = [room(n) for n in (4, 5, 8, 12)]

EXERCISE = Definition(
    title="Reciprocity and energy balance",
    lesson=30,
    starter=STARTER,
    parts=[
        Call(
            "the way back",
            "reverse",
            [(0.2, 1.0, 4.0), (0.5, 3.0, 2.0), (0.05, 2.0, 0.3), (0.125, 1.0, 1.0)],
            lambda F, A_i, A_j: F * A_i / A_j,
            hint="Solve A_i F_ij = A_j F_ji for F_ji.",
            mistakes=[
                Mistake(lambda F, A_i, A_j: F * A_j / A_i, "The ratio of the areas is upside down: the small patch sends a large share to the large one."),
                Mistake(lambda F, A_i, A_j: F, "Form factors are not symmetric: the areas count."),
                Mistake(lambda F, A_i, A_j: 1 - F, "Rows sum to 1, not the two directions of a pair."),
                Mistake(lambda F, A_i, A_j: F * A_i * A_j, "One area multiplies, the other divides."),
                Mistake(lambda F, A_i, A_j: F * A_i, "The area of patch j is missing."),
                Mistake(lambda F, A_i, A_j: F / A_j, "The area of patch i is missing."),
            ],
        ),
        Call(
            "the whole matrix",
            "completed",
            [(np.triu(F), areas) for F, areas, *_ in ROOMS],
            completed,
            hint="Below the diagonal stand the reversed form factors: F_ji = F_ij A_i / A_j.",
            mistakes=[
                Mistake(lambda u, A: u + u.T, "The matrix is not symmetric: below the diagonal the areas count."),
                Mistake(lambda u, A: u + (u * A[None, :] / A[:, None]).T, "The ratio of the areas is upside down."),
                Mistake(lambda u, A: u, "The entries below the diagonal are still 0."),
                Mistake(lambda u, A: (lambda F: F + np.diag(1 - F.sum(axis=1)))(u + u.T), "The diagonal of flat patches is 0; rows get their sum by reciprocity."),
                Mistake(lambda u, A: completed(u, A) + np.eye(len(A)), "A flat patch does not see itself: the diagonal is 0."),
                Mistake(lambda u, A: (u + u.T) / (u + u.T).sum(axis=1, keepdims=True), "Rows are not made to sum to 1 by dividing: reciprocity gives the numbers, and then they do."),
            ],
            points=2,
        ),
        Call(
            "the power that is absorbed",
            "absorbed",
            [(B + 0.3 * rho, E, rho, F, areas) for F, areas, rho, E, B in ROOMS],  # not the solution: the sum is asked
            absorbed,
            hint="What arrives per unit of area is F B; the share 1 - rho of it is absorbed, on the whole area.",
            mistakes=[
                Mistake(lambda B, E, r, F, A: float(np.sum(A * E)), "At the solution it equals the power emitted; here B is another. Compute the sum itself."),
                Mistake(lambda B, E, r, F, A: float(np.sum(A * r * (F @ B))), "This is what is reflected: the share rho. The rest, 1 - rho, is absorbed."),
                Mistake(lambda B, E, r, F, A: float(np.sum((1 - r) * (F @ B))), "The areas are missing: B and H are densities, power per unit of area."),
                Mistake(lambda B, E, r, F, A: float(np.sum(A * (1 - r) * (F.T @ B))), "The matrix is transposed: H_i is the sum over F_ij B_j, row i."),
                Mistake(lambda B, E, r, F, A: float(np.sum(A * (1 - r) * B)), "This takes what leaves the patches; absorbed is a share of what arrives."),
                Mistake(lambda B, E, r, F, A: float(np.sum(A * (F @ B))), "This is all that arrives: only the share 1 - rho of it is absorbed."),
            ],
        ),
    ],
)  # fmt: skip
