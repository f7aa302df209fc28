"""Form factors of the closed Cornell box: glsim and, if it is installed, pyviewfactor, on the same patches in one run.

    python tests/benchmarks/radiosity.py [--patches 500,2000,5000] [--rounds 3]

Prints seconds (medians of interleaved rounds, compiled code warm) and how far rows are from the sum 1; and for glsim
the whole way to a picture, with its peak memory.
"""

from __future__ import annotations

import argparse
import resource
import time
from collections.abc import Callable
from statistics import median
from typing import Any

import numpy as np

from glsim.radiosity.bake import gathered
from glsim.radiosity.formfactors import compute
from glsim.radiosity.mesh import mesh_of
from glsim.radiosity.patches import Patches, subdivide
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.solvers import solved


def ours(parts: Patches) -> np.ndarray:
    return compute(parts).row_sums


def theirs(parts: Patches) -> np.ndarray:
    """pyviewfactor's matrix, rows of F(i -> j) summed."""
    import pyviewfactor as pvf
    import pyvista as pv

    faces, points = [], []
    for ring, count in zip(parts.rings, parts.counts, strict=True):
        faces.append([count, *range(len(points), len(points) + count)])
        points += list(ring[:count])
    mesh = pv.PolyData(np.array(points), np.concatenate(faces))
    triangles = parts.scene.triangles()
    corners = np.arange(3 * len(triangles)).reshape(-1, 3)
    obstacle = pv.PolyData(triangles.reshape(-1, 3), np.c_[np.full(len(triangles), 3), corners])
    matrix: Any = pvf.compute_viewfactor_matrix(mesh, obstacles=[obstacle])
    return np.asarray(matrix.sum(axis=0))


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--patches", default="500,2000,5000")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
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
    for count in map(int, options.patches.split(",")):
        parts = subdivide(scene, count)
        times: dict[str, list[float]] = {name: [] for name in tools}
        sums: dict[str, np.ndarray] = {}
        for _ in range(options.rounds):
            for name, tool in tools.items():
                start = time.perf_counter()
                sums[name] = tool(parts)
                times[name].append(time.perf_counter() - start)
        for name in tools:
            error = np.abs(sums[name] - 1.0)
            row = f"{len(parts):6} {name:14} {median(times[name]):8.2f}"
            print(f"{row} {100 * error.mean():13.4f} % {100 * error.max():6.2f} %")
        factors = compute(parts)
        start = time.perf_counter()
        steps = solved(factors)
        middle = time.perf_counter()
        mesh = mesh_of(parts)
        gathered(factors, mesh, steps[-1].B)
        end = time.perf_counter()
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**10
        vertices = f"{len(mesh.vertices)} vertices {end - middle:.2f} s"
        print(f"{'':6} solving {middle - start:.2f} s, {vertices}, peak memory {memory:.0f} MiB")


if __name__ == "__main__":
    main()
