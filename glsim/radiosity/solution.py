"""A scene's radiosity from end to end: patches, form factors, the linear system, vertices."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.adapt import refined
from glsim.radiosity.compiled import is_cached
from glsim.radiosity.drawn import refined as finer
from glsim.radiosity.factors import Factors
from glsim.radiosity.formfactors import FormFactors
from glsim.radiosity.gather import Gatherer, Light, averaged
from glsim.radiosity.hierarchy import ACCURACY, Links, linked
from glsim.radiosity.lamps import Lamps
from glsim.radiosity.load import scene_from
from glsim.radiosity.mesh import PatchMesh, mesh_of
from glsim.radiosity.methods import METHODS, compute
from glsim.radiosity.pairs import rows
from glsim.radiosity.progress import Progress, silent
from glsim.radiosity.rays import Rays
from glsim.radiosity.result import Radiosity
from glsim.radiosity.scene import SceneError
from glsim.radiosity.scenes import cornell
from glsim.radiosity.solvers import WITHOUT_MATRIX, SolverStep, solved
from glsim.radiosity.subdivide import subdivide
from glsim.radiosity.tree import tree_of

Float = NDArray[np.float64]
VERTICES = ("gather", "average")
BRIGHT = 0.95  # reflectance: above it Gauss-Seidel takes hundreds of sweeps
MANY = 3000  # patches: above it links take less time and memory than a matrix
DRAWN, ENOUGH = 5, 8000  # vertices for each patch, but not more than that, or than twice those of the patches' mesh


def solve(
    what: Any, patches: int = 1000, *, method: str | None = None, solver: str | None = None, tolerance: float = 1e-6,
    vertices: str = "gather", adaptive: bool = False, accuracy: float = ACCURACY, flip: bool = False,
    close: bool = False, threads: int | None = None, checkpoint: str | None = None, scheduler: str | None = None,
    drawn: int | None = None, progress: Progress | None = None, on_step: Callable[[SolverStep], object] | None = None,
) -> Radiosity:  # fmt: skip
    """Solve the radiosity of a scene.

    what: whatever load.scene_from takes.  patches: about how many.  method: of form factors, see methods.METHODS; by
    default "contour", and above MANY patches "hierarchical".  accuracy: of links, in mean radiosities, see
    hierarchy.linked.  solver: see solvers.SOLVERS; by default "gauss-seidel", and "cg" without a matrix.  adaptive:
    begin with fewer patches and divide those where the light changes fast.  vertices: "gather" (a final gather at each
    vertex) or "average" (of patches).  drawn: about how many vertices the mesh that is drawn has, by default DRAWN for
    each patch; 0: the corners of the patches, as with "average" always.  close: scale the form factors so that rows sum
    to 1, for closed scenes.  flip: turn all fronts to the other side.  checkpoint: see methods.compute.  scheduler: the
    address of a Dask scheduler whose workers compute the form factors and multiply by them; checkpoint is then the name
    under which the blocks of form factors stay there (see distributed.Blocks).  threads: for rays, by default one for
    each processor; the result does not depend on it.
    Raises SceneError.
    """
    _check_numbers(patches, tolerance, accuracy, threads, drawn)
    if method is None:
        only_matrix = solver not in (None, *WITHOUT_MATRIX) or adaptive or close or scheduler
        method = "contour" if patches <= MANY or only_matrix else "hierarchical"
    _check(method, vertices, adaptive, close, scheduler)
    tell = progress or silent
    seconds: dict[str, float] = {}
    with _timed(seconds, "patches"):
        tell("patches", 0, 1)
        scene = scene_from(what)
        scene = (scene.flipped() if flip else scene).checked()
        rays = Rays(scene, threads)
    with _timed(seconds, "compiled code"):
        when = "only in the first run" if is_cached(rows) else "in each run: set NUMBA_CACHE_DIR to a folder to keep it"
        tell(f"compiling ({when})", 0, 1)
        _compiled(method == "hierarchical")
        tell(f"compiling ({when})", 1, 1)
    if method == "hierarchical":
        with _timed(seconds, "patches"):
            tree = tree_of(scene, patches, rays)
            tell("patches", 1, 1)
        computed: Factors = linked(tree, accuracy, rays, tell, checkpoint=checkpoint)
    else:
        find = _finder(method, rays, scheduler, tell)
        computed = _patch_factors(rays, patches, find, adaptive, checkpoint, tell, seconds)
    factors = computed.closed() if close and isinstance(computed, FormFactors) else computed
    if method in ("contour", "hierarchical") and isinstance(factors, FormFactors | Links):
        factors = factors.mended()
    seconds.update(factors.seconds)
    _check_sight(factors)
    try:
        with _timed(seconds, "solving"):
            steps, solver = _solved(factors, solver, tolerance, on_step)
        B = steps[-1].B
        with _timed(seconds, "vertices"):
            mesh, shown, light = _drawn(factors, B, vertices, drawn, tell)
    except KeyboardInterrupt:
        if checkpoint:
            computed.keep(checkpoint)
        raise
    return Radiosity(factors.patches, factors, steps, B, mesh, shown, light, solver, seconds)


def _drawn(
    factors: Factors, B: Float, vertices: str, drawn: int | None, tell: Progress
) -> tuple[PatchMesh, Float, Light | None]:
    """Return the mesh that is drawn, the radiosity at its vertices (V, 3), and the irradiance there if it was gathered.

    The arguments: see ``solve``.
    """
    p, mesh = factors.patches, mesh_of(factors.patches)
    if vertices == "average":
        return mesh, averaged(p, mesh, B), None
    light, gatherer = Gatherer(factors, B, Lamps.of(p, factors.visibility), tell=tell).on(mesh)
    fixed = int(p.is_cluster[mesh.patch].sum())  # vertices on pieces of clusters, which stay as they are
    usual = fixed + max(2 * (len(mesh.vertices) - fixed), min(DRAWN * len(p), ENOUGH))
    count = usual if drawn is None else drawn
    if count > len(mesh.vertices):
        mesh, light = finer(mesh, light, gatherer, count, tell)
    light = gatherer.balanced(mesh, light)
    return mesh, p.E[mesh.patch] + p.rho[mesh.patch] * light.both, light


def _patch_factors(
    rays: Rays, patches: int, find: Any, adaptive: bool, checkpoint: str | None, tell: Progress,
    seconds: dict[str, float],
) -> Factors:  # fmt: skip
    """Return the factors of about so many patches of the rays' scene; find: see _finder."""
    with _timed(seconds, "patches"):
        parts = subdivide(rays.scene, patches // 4 if adaptive else patches, rays=rays)
        tell("patches", 1, 1)
    if adaptive:
        with _timed(seconds, "refinement"):
            parts = refined(parts, patches, find)
    factors: Factors = find(parts, checkpoint)
    return factors


@cache
def _compiled(hierarchical: bool) -> None:
    """Solve a small box from end to end, so that everything is compiled or loaded from the cache."""
    scene = cornell().checked()
    rays = Rays(scene, 1)
    factors: Factors = (
        linked(tree_of(scene, 250, rays), rays=rays)
        if hierarchical
        else compute(subdivide(scene, 60, rays=rays), rays=rays)
    )
    _drawn(factors, _solved(factors, None, 1e-3, None)[0][-1].B, "gather", 1000, silent)


def _finder(method: str, rays: Rays, scheduler: str | None, tell: Progress) -> Any:
    """Return the function that finds the form factors of patches: here, or on the workers of a scheduler."""
    if scheduler is None:
        return lambda parts, checkpoint=None: compute(parts, method, rays=rays, progress=tell, checkpoint=checkpoint)
    from glsim.radiosity.distributed import Blocks, connected

    client = connected(scheduler)
    return lambda parts, dataset=None: Blocks(client, parts, tell, dataset, rays)


@contextmanager
def _timed(seconds: dict[str, float], stage: str) -> Iterator[None]:
    """Add the time of a block to seconds[stage]."""
    start = time.perf_counter()
    yield
    seconds[stage] = seconds.get(stage, 0.0) + time.perf_counter() - start


def _solved(
    factors: Factors, solver: str | None, tolerance: float, on_step: Callable[[SolverStep], object] | None
) -> tuple[list[SolverStep], str]:
    """Return the steps of a solver and its name: by default Gauss-Seidel, which is easy to follow, and conjugate
    gradients where there is no matrix, or where so much light is reflected that Gauss-Seidel would take long."""
    bright = float(factors.patches.rho.max()) > BRIGHT
    name = solver or (WITHOUT_MATRIX[0] if factors.matrix is None or bright else "gauss-seidel")
    return solved(factors, name, tolerance=tolerance, progress=on_step), name


def _check(method: str, vertices: str, adaptive: bool, close: bool, scheduler: str | None) -> None:
    """Raise SceneError for names that do not exist and for choices that exclude each other."""
    if find_spec("embreex") is None:
        raise SceneError("radiosity needs the package embreex: pip install glsim[radiosity]")
    if vertices not in VERTICES:
        raise SceneError(f"the radiosity at vertices is made by {' or '.join(VERTICES)}, not {vertices!r}")
    if method not in METHODS:
        raise SceneError(f"the methods for form factors are {', '.join(METHODS)}, not {method!r}")
    if scheduler and (method != "contour" or close):
        raise SceneError("with --scheduler the method is contour, and --close is not there")
    if method == "hierarchical" and (adaptive or close):
        raise SceneError("hierarchical radiosity neither needs --adaptive (its links adapt) nor knows --close")


def _check_numbers(patches: int, tolerance: float, accuracy: float, threads: int | None, drawn: int | None) -> None:
    """Raise SceneError for numbers out of their range."""
    if drawn is not None and (isinstance(drawn, bool) or not isinstance(drawn, (int, np.integer)) or drawn < 0):
        raise SceneError(f"drawn must be a whole number from 0 on, not {drawn!r}")
    for name, value in (("patches", patches), ("threads", 1 if threads is None else threads)):
        if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < 1:
            raise SceneError(f"{name} must be a whole number from 1 on, not {value!r}")
    for name, number in (("tolerance", tolerance), ("accuracy", accuracy)):
        if not isinstance(number, (int, float)) or not 0.0 < number < 1.0:
            raise SceneError(f"the {name} must be a number between 0 and 1, not {number!r}")


def _check_sight(factors: Factors) -> None:
    """Raise SceneError if no patch sees another."""
    parts = factors.patches
    lamps = parts.E.max(axis=1) > 0.0
    sums = factors.row_sums
    if not lamps.all() and float(sums @ parts.area) < 1e-3 * float(parts.area.sum()) and sums[lamps].max() < 1e-3:
        raise SceneError(
            f"{parts.scene.name}: no patch sees another: are the normals inverted? A room shows its fronts inside;"
            " --flip turns them"
        )
