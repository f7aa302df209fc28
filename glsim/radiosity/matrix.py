"""The matrix S of a linear system in inner loops.  S is float32 to save memory, sums are float64."""

from __future__ import annotations

from typing import Any

from glsim.radiosity.compiled import jit, parallel, prange


@jit
def row_product(S: Any, B: Any, i: int) -> tuple[float, float, float]:
    """Return row i of S B: one sum for each of red, green and blue."""
    r = g = b = 0.0
    for j in range(len(S)):
        s = S[i, j]
        r += s * B[j, 0]
        g += s * B[j, 1]
        b += s * B[j, 2]
    return r, g, b


@parallel
def product(S: Any, B: Any, out: Any) -> None:
    """Write S B into out (n, 3), for S (n, n) and B (n, 3)."""
    for i in prange(len(S)):
        out[i, 0], out[i, 1], out[i, 2] = row_product(S, B, i)


@jit
def sweep(S: Any, area: Any, rho: Any, E: Any, B: Any, omega: float) -> None:
    """Improve B (n, 3), in place, by one sweep of Gauss-Seidel with over-relaxation.

    One patch after the other: B_i <- (1 - omega) B_i + omega (E_i + rho_i sum_j S_ij B_j / A_i).  S: (n, n); area:
    (n,); rho, E: (n, 3).  (Cohen & Wallace 1993, section 5.3)
    """
    for i in range(len(area)):
        r, g, b = row_product(S, B, i)
        B[i, 0] += omega * (E[i, 0] + rho[i, 0] * r / area[i] - B[i, 0])
        B[i, 1] += omega * (E[i, 1] + rho[i, 1] * g / area[i] - B[i, 1])
        B[i, 2] += omega * (E[i, 2] + rho[i, 2] * b / area[i] - B[i, 2])
