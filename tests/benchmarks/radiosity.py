"""Form factors of the closed Cornell box: glsim and, if it is installed, pyviewfactor, on the same patches in one run.

    python tests/benchmarks/radiosity.py [--patches 500,2000,5000] [--rounds 3]
    python tests/benchmarks/radiosity.py --hierarchical 5000,20000,100000 [--accuracy 5e-5] [--dense 20000]
    python tests/benchmarks/radiosity.py --vertices 500,2000 [--fine 8000]

The first prints seconds (medians of interleaved rounds, compiled code warm) and how far rows are from the sum 1; for
glsim the whole way to a picture, with its peak memory.  The second prints links, seconds and the error of the elements'
radiosity against the whole matrix, for as many as --dense elements.  The third prints how far vertices are from a final
gather at the same points from many more patches.
"""

from __future__ import annotations

import argparse
import resource
import time
from collections.abc import Callable
from statistics import median
from typing import Any

import numpy as np

from glsim.radiosity.gather import averaged, gathered, unevenness
from glsim.radiosity.hierarchy import ACCURACY, linked
from glsim.radiosity.mesh import mesh_of
from glsim.radiosity.methods import compute
from glsim.radiosity.patches import Patches
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.solvers import solved
from glsim.radiosity.subdivide import subdivide
from glsim.radiosity.tree import tree_of


def ours(parts: Patches) -> np.ndarray:
    return compute(parts).row_sums


def theirs(parts: Patches) -> np.ndarray:
    """pyviewfactor's matrix, rows of F(i -> j) summed."""
    import pyviewfactor as pvf
    import pyvista as pv

    faces, points = [], []
    for polygon, count in zip(parts.corners, parts.counts, strict=True):
        faces.append([count, *range(len(points), len(points) + count)])
        points += list(polygon[:count])
    mesh = pv.PolyData(np.array(points), np.concatenate(faces))
    triangles = parts.scene.triangles()
    corners = np.arange(3 * len(triangles)).reshape(-1, 3)
    obstacle = pv.PolyData(triangles.reshape(-1, 3), np.c_[np.full(len(triangles), 3), corners])
    matrix: Any = pvf.compute_viewfactor_matrix(mesh, obstacles=[obstacle])
    return np.asarray(matrix.sum(axis=0))


def pairs(counts: list[int], rounds: int) -> None:
    tools: dict[str, Callable[[Patches], np.ndarray]] = {"glsim": ours}
    try:
        import pyviewfactor  # noqa: F401

        tools["pyviewfactor"] = theirs
    except ImportError:
        print("pyviewfactor is not installed: glsim alone")
    scene = BUILT_IN["cornell-closed"].make().checked()
    warm = subdivide(scene, 60)
    for name, tool in tools.items():
        start = time.perf_counter()
        tool(warm)
        print(f"{name}: {time.perf_counter() - start:.1f} s for a first, small scene (with compiling)")
    print(f"{'n':>6} {'tool':14} {'seconds':>8} {'mean |sum - 1|':>15} {'max':>8}")
    for count in counts:
        parts = subdivide(scene, count)
        times: dict[str, list[float]] = {name: [] for name in tools}
        sums: dict[str, np.ndarray] = {}
        for _ in range(rounds):
            for name, tool in tools.items():
                start = time.perf_counter()
                sums[name] = tool(parts)
                times[name].append(time.perf_counter() - start)
        for name in tools:
            error = np.abs(sums[name] - 1.0)
            row = f"{len(parts):6} {name:14} {median(times[name]):8.2f}"
            print(f"{row} {100 * error.mean():13.4f} % {100 * error.max():6.2f} %")
        whole_way(parts)


def whole_way(parts: Patches) -> None:
    factors = compute(parts)
    start = time.perf_counter()
    steps = solved(factors)
    middle = time.perf_counter()
    mesh = mesh_of(parts)
    gathered(factors, mesh, steps[-1].B)
    end = time.perf_counter()
    vertices = f"{len(mesh.vertices)} vertices {end - middle:.2f} s"
    print(f"{'':6} solving {middle - start:.2f} s, {vertices}, {memory()}")


def memory() -> str:
    return f"peak memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**10:.0f} MiB"


def deviation(B: np.ndarray, true: np.ndarray, patches: Patches) -> str:
    area, reflected = patches.area[:, None], true - patches.E
    rms = np.sqrt((area * (B - true) ** 2).sum() / (area * reflected**2).sum())
    bias = (area * (B - true)).sum() / (area * reflected).sum()
    return f"rms {100 * rms:.3f} %, bias {100 * bias:+.3f} %"


def hierarchical(counts: list[int], accuracy: float, dense: int) -> None:
    scene = BUILT_IN["cornell"].make().checked()
    linked(tree_of(scene, 500))  # compiles
    for count in counts:
        start = time.perf_counter()
        links = linked(tree_of(scene, count), accuracy)
        middle = time.perf_counter()
        steps = solved(links, "cg")
        end = time.perf_counter()
        mesh = mesh_of(links.patches)
        gathered(links, mesh, steps[-1].B)
        took = f"links {middle - start:.1f} s, solving {end - middle:.1f} s, vertices {time.perf_counter() - end:.1f} s"
        print(f"{len(links.patches):7} elements {len(links.S):9} links: {took}, {memory()}")
        if len(links.patches) <= dense:
            start = time.perf_counter()
            matrix = compute(links.patches)
            B = solved(matrix)[-1].B
            took = f"{time.perf_counter() - start:.1f} s"
            print(f"{'':7} against the matrix ({took}): {deviation(steps[-1].B, B, links.patches)}")


def vertices(counts: list[int], fine: int) -> None:
    scene = BUILT_IN["cornell"].make().checked()
    many = compute(subdivide(scene, fine))
    B = solved(many)[-1].B
    mesh_of_many = mesh_of(many.patches)
    bright = gathered(many, mesh_of_many, B)[mesh_of_many.corners]
    print(f"final gather from {len(many.patches)} patches as the reference")
    for count in counts:
        parts = subdivide(scene, count)
        factors = compute(parts)
        coarse = solved(factors)[-1].B
        mesh = mesh_of(parts)
        shown = gathered(factors, mesh, coarse)
        mean = averaged(parts, mesh, coarse)
        H = many.at_points(mesh.at + 1e-6 * scene.size * mesh.normals, mesh.normals, mesh.patch, B)
        H += unevenness(many, mesh.at, mesh.normals, bright)
        true = parts.E[mesh.patch] + parts.rho[mesh.patch] * H
        lit = parts.E[mesh.patch].max(axis=1) == 0.0

        def rms(values: np.ndarray, true: np.ndarray = true, lit: np.ndarray = lit) -> float:
            return 100.0 * float(np.sqrt(((values - true)[lit] ** 2).sum() / (true[lit] ** 2).sum()))

        print(f"{len(parts):6} patches: gathered rms {rms(shown):.3f} %, averaged rms {rms(mean):.2f} %")


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--patches", default="500,2000,5000")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--hierarchical")
    parser.add_argument("--accuracy", type=float, default=ACCURACY)
    parser.add_argument("--dense", type=int, default=0)
    parser.add_argument("--vertices")
    parser.add_argument("--fine", type=int, default=8000)
    options = parser.parse_args()
    if options.hierarchical:
        hierarchical([int(n) for n in options.hierarchical.split(",")], options.accuracy, options.dense)
    elif options.vertices:
        vertices([int(n) for n in options.vertices.split(",")], options.fine)
    else:
        pairs([int(n) for n in options.patches.split(",")], options.rounds)


if __name__ == "__main__":
    main()
