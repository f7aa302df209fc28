"""The matrix S of a system in inner loops; S is float32, sums are float64."""

from __future__ import annotations

from typing import Any

from glsim.radiosity.compiled import jit, parallel, prange


@parallel
def product(S: Any, B: Any, out: Any) -> None:
    """out = S B for B (n, 3)."""
    n = len(S)
    for i in prange(n):
        r = g = b = 0.0
        for j in range(n):
            s = S[i, j]
            r += s * B[j, 0]
            g += s * B[j, 1]
            b += s * B[j, 2]
        out[i, 0], out[i, 1], out[i, 2] = r, g, b


@jit
def sweep(S: Any, area: Any, rho: Any, E: Any, B: Any, omega: float) -> None:
    """B_i <- (1 - omega) B_i + omega (E_i + rho_i sum_j S_ij B_j / A_i), in order; B (n, 3) is changed."""
    n = len(area)
    for i in range(n):
        r = g = b = 0.0
        for j in range(n):
            s = S[i, j]
            r += s * B[j, 0]
            g += s * B[j, 1]
            b += s * B[j, 2]
        B[i, 0] += omega * (E[i, 0] + rho[i, 0] * r / area[i] - B[i, 0])
        B[i, 1] += omega * (E[i, 1] + rho[i, 1] * g / area[i] - B[i, 1])
        B[i, 2] += omega * (E[i, 2] + rho[i, 2] * b / area[i] - B[i, 2])
