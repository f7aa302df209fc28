"""The linear system (I - R F) B = E, solved by textbook methods: each is a generator that yields every step.

B_i = E_i + rho_i sum_j F_ij B_j for each channel.  Gathering (Jacobi, Gauss-Seidel) lets each patch collect what the
others send; shooting sends the unshot power of the patch that has most of it to all others.  Sources: Cohen & Wallace
(1993), chapter 5.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.factors import Factors
from glsim.radiosity.matrix import sweep
from glsim.radiosity.scene import SceneError

Float = NDArray[np.float64]
Int = NDArray[np.int64]


class SolverStep(NamedTuple):
    """After one iteration.  B: (n, 3); residual: largest norm of E - (I - R F) B over the channels, relative to E's;
    balance: power that leaves the patches for good (absorbed or escaped) over the power emitted, 1 at the solution."""

    iteration: int
    B: Float
    residual: float
    balance: float


@dataclass(frozen=True)
class System:
    """The equations of n patches in three channels.

    times: returns S B for B (n, 3); area: (n,); rho, E: (n, 3); S: (n, n) symmetric, if there is a matrix.
    """

    times: Callable[[Float], Float]
    area: Float
    rho: Float
    E: Float
    S: NDArray[np.float32] | None = None

    @staticmethod
    def of(factors: Factors) -> System:
        """Return the system of patches with these form factors."""
        patches = factors.patches
        return System(factors.times, patches.area, patches.rho, patches.E, factors.matrix)

    def gathered(self, B: Float) -> Float:
        """Return the irradiance sum_j F_ij B_j of each patch, (n, 3)."""
        return self.times(B) / self.area[:, None]

    @property
    def rows(self) -> NDArray[np.float32]:
        """S.  Raises SceneError if there are only links."""
        if self.S is None:
            raise SceneError(f"there is no matrix for this solver: choose {' or '.join(WITHOUT_MATRIX)} (--solver)")
        return self.S

    def matrix(self, channel: int) -> Float:
        """Return I - R F for one channel, (n, n) float64."""
        result = -(self.rho[:, channel] / self.area)[:, None] * self.rows.astype(np.float64)
        result[np.diag_indices(len(result))] += 1.0
        return np.asarray(result)

    def step(self, iteration: int, B: Float, arriving: Float | None = None) -> SolverStep:
        """Return the SolverStep for radiosities B (n, 3); arriving: their irradiance (n, 3), if it is known already."""
        H = self.gathered(B) if arriving is None else arriving
        residual = self.E + self.rho * H - B
        norms = np.linalg.norm(residual, axis=0) / np.maximum(np.linalg.norm(self.E, axis=0), 1e-300)
        emitted = float((self.area[:, None] * self.E).sum())
        lost = float((self.area[:, None] * (B - self.rho * H)).sum())
        used = norms[np.linalg.norm(self.E, axis=0) > 0.0]
        return SolverStep(iteration, B, float(used.max(initial=0.0)), lost / emitted if emitted else 1.0)


def lu(system: System) -> Iterator[SolverStep]:
    """Solve directly, by LU factorisation of each channel's matrix: one step."""
    from scipy.linalg import lu_factor, lu_solve

    B = np.empty_like(system.E)
    for channel in range(3):
        B[:, channel] = lu_solve(lu_factor(system.matrix(channel), overwrite_a=True), system.E[:, channel])
    yield system.step(1, B, _exact(system, B))


def _exact(system: System, B: Float) -> Float:
    """Return the irradiance (n, 3), calculated in float64 throughout."""
    return np.asarray(system.rows.astype(np.float64) @ B / system.area[:, None])


def jacobi(system: System) -> Iterator[SolverStep]:
    """Gather with all patches at once.  Iteration k is the light after k bounces."""
    B = system.E.copy()
    iteration = 0
    while True:
        H = system.gathered(B)
        yield system.step(iteration, B, H)
        B = system.E + system.rho * H
        iteration += 1


def gauss_seidel(system: System, omega: float = 1.0) -> Iterator[SolverStep]:
    """Gather with one patch after the other, from what the others have already gathered; omega: over-relaxation."""
    if not 0.0 < omega < 2.0:
        raise SceneError(f"over-relaxation converges for omega between 0 and 2, not {omega}")
    B = system.E.copy()
    iteration = 0
    yield system.step(0, B)
    while True:
        sweep(system.rows, system.area, system.rho, system.E, B, omega)
        iteration += 1
        yield system.step(iteration, B.copy())


def sor(system: System) -> Iterator[SolverStep]:
    """Gather with successive over-relaxation, omega = 1.15."""
    return gauss_seidel(system, 1.15)


def conjugate_gradients(system: System) -> Iterator[SolverStep]:
    """Solve by conjugate gradients, preconditioned by the diagonal, the three channels side by side.

    They need a symmetric system: (A / rho - S) B = A E / rho.  Patches that reflect nothing have B = E and stay out.
    """
    free = system.rho > 0.0
    diagonal = np.where(free, system.area[:, None] / np.where(free, system.rho, 1.0), 1.0)
    B = system.E.copy()
    arriving = system.times(B)
    r = np.where(free, arriving, 0.0)  # A E / rho - (A / rho - S) E
    p, before = np.zeros_like(B), np.ones(3)
    iteration = 0
    while True:
        yield system.step(iteration, B.copy(), arriving / system.area[:, None])
        z = r / diagonal
        rz = (r * z).sum(axis=0)
        p = z + rz / before * p
        image = system.times(p)
        curvature = (p * np.where(free, diagonal * p - image, 0.0)).sum(axis=0)
        alpha = np.divide(rz, curvature, out=np.zeros(3), where=curvature > 0.0)
        B = B + alpha * p
        arriving = arriving + alpha * image
        r = r - alpha * np.where(free, diagonal * p - image, 0.0)
        before = np.where(rz > 0.0, rz, 1.0)
        iteration += 1


def shooting(system: System, ambient: bool = False, many: int | None = None) -> Iterator[SolverStep]:
    """Shoot: the patch with most unshot power sends it to all others (progressive refinement, Cohen et al. 1988).

    A step is ``many`` shots, by default a twentieth of the patches.  ambient: add to B an estimate of what is still to
    come, for display.
    """
    B, unshot = system.E.copy(), system.E.copy()
    n = len(B)
    shots = many or max(1, n // 20)
    mean_rho = (system.area[:, None] * system.rho).sum(axis=0) / system.area.sum()
    iteration = 0
    while True:
        shown = B
        if ambient:
            still = (system.area[:, None] * unshot).sum(axis=0) / system.area.sum() / (1.0 - mean_rho)
            shown = B + system.rho * still
        yield system.step(iteration, shown.copy())
        for _ in range(shots):
            i = int(np.argmax(system.area * unshot.sum(axis=1)))
            column = system.rows[i].astype(np.float64) / system.area  # F_ji = S_ij / A_j
            received = system.rho * column[:, None] * unshot[i]
            unshot[i] = 0.0
            B += received
            unshot += received
        iteration += 1


SOLVERS: dict[str, Callable[[System], Iterator[SolverStep]]] = {
    "gauss-seidel": gauss_seidel, "jacobi": jacobi, "sor": sor, "cg": conjugate_gradients, "shooting": shooting,
    "lu": lu,
}  # fmt: skip
WITHOUT_MATRIX = ("cg", "jacobi")  # solvers that read no row of S and need only products S B


def solved(
    factors: Factors, solver: str = "gauss-seidel", *, tolerance: float = 1e-6, most: int = 1000,
    progress: Callable[[SolverStep], object] | None = None,
) -> list[SolverStep]:  # fmt: skip
    """Return all steps up to the one whose residual is at most ``tolerance``; only the last keeps its own B.

    Raises SceneError for an unknown solver, and if ``most`` steps are not enough.
    """
    if solver not in SOLVERS:
        raise SceneError(f"the solvers are {', '.join(SOLVERS)}, not {solver!r}")
    steps: list[SolverStep] = []
    for step in SOLVERS[solver](System.of(factors)):
        steps.append(step)
        if len(steps) > 1:
            steps[-2] = steps[-2]._replace(B=np.empty((0, 3)))
        if progress is not None:
            progress(step)
        if not np.isfinite(step.residual):
            raise SceneError(f"{solver} diverges: the residual is {step.residual} after {step.iteration} iterations")
        if step.residual <= tolerance:
            return steps
        if step.iteration >= most:
            break
    raise SceneError(
        f"{solver} did not converge: after {steps[-1].iteration} iterations the residual is {steps[-1].residual:.2g},"
        f" more than the tolerance {tolerance:g}"
    )
