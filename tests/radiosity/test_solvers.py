"""The linear system: energy, linearity, every solver against LU."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice, pairwise

import numpy as np
import pytest

from glsim.radiosity.formfactors import FormFactors
from glsim.radiosity.scene import SceneError
from glsim.radiosity.solution import solve
from glsim.radiosity.solvers import SOLVERS, System, solved
from tests.radiosity.helpers import CASES


def test_energy_balance_and_linearity(closed: FormFactors) -> None:
    steps = solved(closed, "cg", tolerance=1e-7)
    assert steps[-1].balance == pytest.approx(1.0, abs=1e-5)
    p = closed.patches
    absorbed = (p.area[:, None] * (1 - p.rho) / np.maximum(p.rho, 1e-12) * (steps[-1].B - p.E)).sum()
    leak = ((1.0 - closed.row_sums) * p.area) @ steps[-1].B
    assert absorbed + leak.sum() == pytest.approx((p.area[:, None] * p.E).sum(), rel=1e-4)
    system = System.of(closed)
    doubled = replace(system, E=2.0 * system.E)
    twice = next(SOLVERS["lu"](doubled)).B
    assert twice == pytest.approx(2.0 * next(SOLVERS["lu"](system)).B, rel=1e-9)


@pytest.mark.parametrize("solver", SOLVERS)
def test_solvers_agree(solver: str, closed: FormFactors) -> None:
    exact = solved(closed, "lu")[-1].B
    steps = solved(closed, solver, tolerance=1e-6)
    assert np.abs(steps[-1].B - exact).max() < 3e-5 * exact.max()
    residuals = [step.residual for step in steps]
    assert residuals[-1] <= 1e-6
    assert solver == "lu" or residuals[-1] < residuals[0]


def test_jacobis_iterations_are_bounces(closed: FormFactors) -> None:
    system = System.of(closed)
    steps = SOLVERS["jacobi"](system)
    first, second = next(steps).B, next(steps).B
    assert np.array_equal(first, system.E)
    assert second == pytest.approx(system.E + system.rho * (closed.F @ system.E), rel=1e-4, abs=1e-6)


def test_a_solver_does_not_pretend(closed: FormFactors) -> None:
    with pytest.raises(SceneError, match="did not converge: after 2 iterations"):
        solved(closed, "jacobi", most=2)
    with pytest.raises(SceneError, match="the solvers are"):
        solved(closed, "magic")


@pytest.mark.parametrize("solver", SOLVERS)
def test_round_patches_of_a_sphere(solver: str) -> None:
    """The closed solution of analytic_cases.json, by every solver; a round patch also sees itself."""
    case = CASES["sphere"]["example"]
    area, E, rho = (np.array(case[name], float) for name in ("areas", "E", "rho"))
    S = (area[:, None] * area / area.sum()).astype(np.float32)
    for step in SOLVERS[solver](System(lambda B: S.astype(float) @ B, area, rho, E, S)):
        if step.residual < 1e-9 or step.iteration > 2000:
            break
    assert pytest.approx(np.array(case["B"]), rel=1e-5) == step.B
    assert step.balance == pytest.approx(1.0, abs=1e-6)


def test_the_iterations_of_a_solution_can_be_followed() -> None:
    box = solve("goral", patches=60)
    steps = list(islice(box.iterations("jacobi"), 40))
    assert [step.iteration for step in steps] == list(range(steps[0].iteration, steps[0].iteration + 40))
    assert all(later.residual < earlier.residual for earlier, later in pairwise(steps))
    np.testing.assert_allclose(steps[-1].B, box.B, atol=1e-4)
    np.testing.assert_allclose(box.at_vertices(box.patches.E), box.direct())
    with pytest.raises(SceneError, match=r"the solvers are .*, not 'jacoby'"):
        box.iterations("jacoby")
