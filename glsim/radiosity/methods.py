"""The ways to find form factors: a table from names to functions, and ``compute``, which picks one of them.

To add a method, write a function that takes patches, visibility and options and returns a Result, and add its row.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.formfactors import FormFactors, by_pairs
from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress, silent
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import SceneError
from glsim.radiosity.textbook import disc_or_point, monte_carlo
from glsim.radiosity.visibility import Visibility


@dataclass(frozen=True)
class Options:
    """The arguments of ``compute`` that its methods may read; ``compute`` says what they mean."""

    exact: bool
    samples: int
    seed: int
    progress: Progress
    checkpoint: str | None


class Result(NamedTuple):
    """S: (n, n) float32, S_ij = A_i F_ij, symmetric; seconds by stage, if the method has several; error: (n, n), the
    standard errors of S, if the method estimates them."""

    S: NDArray[np.float32]
    seconds: dict[str, float] | None = None
    error: NDArray[np.float32] | None = None


def _contour(patches: Patches, visibility: Visibility, options: Options) -> Result:
    return Result(
        *by_pairs(patches, visibility, visibility.rays, "contour", options.exact, options.progress, options.checkpoint)
    )


def _analytic(patches: Patches, visibility: Visibility, options: Options) -> Result:
    return Result(
        *by_pairs(patches, None, visibility.rays, "analytic", options.exact, options.progress, options.checkpoint)
    )


def _point(patches: Patches, visibility: Visibility, options: Options) -> Result:
    return Result(disc_or_point(patches, visibility.rays, disc=False, progress=options.progress))


def _disc(patches: Patches, visibility: Visibility, options: Options) -> Result:
    return Result(disc_or_point(patches, visibility.rays, disc=True, progress=options.progress))


def _monte_carlo(patches: Patches, visibility: Visibility, options: Options) -> Result:
    S, error = monte_carlo(patches, visibility.rays, options.samples, options.seed, options.progress)
    return Result(S, error=error)


def _hemicube(patches: Patches, visibility: Visibility, options: Options) -> Result:
    from glsim.radiosity.hemicube import hemicube  # the only method that needs a GPU

    return Result(hemicube(patches, options.progress))


class Method(NamedTuple):
    """about: one sentence for a list of methods; function: finds the form factors of patches."""

    about: str
    function: Callable[[Patches, Visibility, Options], Result]


MATRICES = {
    "contour": Method(
        "each polygon whole: contour integrals near, Lambert's formula far, visibility by rays", _contour
    ),
    "analytic": Method("the same without visibility: nothing blocks anything", _analytic),
    "point": Method("textbook: from centre to centre, cos cos A / (pi r^2), one ray", _point),
    "disc": Method("from centre to disc, cos cos A / (pi r^2 + A), one ray", _disc),
    "monte-carlo": Method("rays between random points of both patches, with standard errors", _monte_carlo),
    "hemicube": Method("the scene as each patch sees it, drawn on half a cube (Cohen and Greenberg 1985)", _hemicube),
}
METHODS = {
    **{name: method.about for name, method in MATRICES.items()},
    "hierarchical": "links between levels of detail: for tens of thousands of patches",
}


def compute(
    patches: Patches, method: str = "contour", *, exact: bool = False, rays: Rays | None = None,
    progress: Progress | None = None, seed: int = 0, samples: int = 64, limit: int | None = None,
    checkpoint: str | None = None,
) -> FormFactors:  # fmt: skip
    """Find the form factors of all pairs of patches, as a matrix.

    method: a name in MATRICES.  exact: contour integrals for all pairs, not only near ones.  samples, seed: of
    "monte-carlo".  rays: of the patches' scene, by default new ones.  limit: bytes that the matrix may take, by
    default half of the machine's memory.  checkpoint: a file in which finished rows are kept when the work is
    interrupted, and from which they are taken if it is there.  Raises SceneError for another method, or if the matrix
    would not fit.
    """
    if method not in MATRICES:
        raise SceneError(f"the methods for form factors are {', '.join(MATRICES)}, not {method!r}")
    n = len(patches)
    allowed = limit if limit is not None else memory_of_machine() // 2
    if memory_needed(n) > allowed:
        raise SceneError(
            f"{n} patches need {memory_needed(n) / 2**30:.1f} GiB for their form factors, and there are"
            f" {allowed / 2**30:.1f} GiB: take fewer patches (--patches), links (--method hierarchical) or a"
            " cluster (--scheduler)"
        )
    visibility = Visibility(rays or Rays(patches.scene))
    options = Options(exact, samples, seed, progress or silent, checkpoint)
    start = time.perf_counter()
    S, seconds, error = MATRICES[method].function(patches, visibility, options)
    return FormFactors(patches, visibility, S, method, seconds or {"form factors": time.perf_counter() - start}, error)


def memory_needed(n: int) -> int:
    """The bytes of a matrix of n patches."""
    return 4 * n * n


def memory_of_machine() -> int:
    """The bytes of the machine's memory; 8 GiB where the system does not tell."""
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (ValueError, OSError, AttributeError):
        return 8 * 2**30
