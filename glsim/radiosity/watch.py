"""Radiosity as one watches it: the picture after some of the iterations, as a strip or as an animation."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.files import write_atomically
from glsim.pictures import tiles
from glsim.radiosity.cameras import Viewpoint
from glsim.radiosity.gather import averaged

if TYPE_CHECKING:
    from PIL import Image

    from glsim.radiosity.result import Radiosity

Float = NDArray[np.float64]
CONVERGED = 1e-3  # residual from which on the eye sees no difference
MOST = 8  # pictures
IN_A_ROW = 4  # pictures of a strip
SECONDS, LAST = 0.8, 2.5  # that a picture of an animation, and the last one, is seen
WORDS = {"shooting": "shots", "jacobi": "bounces"}  # what an iteration is called; other solvers' are iterations


class Watched(NamedTuple):
    """One picture: its caption, and the pixels (size, size, 3)."""

    caption: str
    pixels: NDArray[np.uint8]


def watched(result: Radiosity, solver: str | None = None, size: int = 256, view: Viewpoint = 0) -> list[Watched]:
    """Solve a result's system again, and draw it after 0, 1, 2, ... iterations, wider apart the later they are.

    solver: as of the result by default; of shooting an iteration is one shot.  At most MOST pictures, the last when the
    residual is CONVERGED.  A vertex has the mean of the patches around it, so that iteration 0 shows the lamps alone.
    """
    name, result = solver or result.solver, replace(result, mesh=result.patch_mesh)
    steps = []
    for step in result.iterations(name, many=1):
        steps.append(step)
        if step.residual <= CONVERGED or name == "lu" or step.iteration >= 4 * len(result.B):
            break
    last = len(steps) - 1
    apart = np.geomspace(1.0, max(last, 1), MOST - 1)
    chosen = sorted({0, *np.round(apart).astype(int).tolist()} & set(range(last + 1)))
    unit = WORDS.get(name, "iterations")
    return [
        Watched(
            f"{name}, {unit}: {steps[k].iteration}, residual {steps[k].residual:.1g}",
            np.asarray(result.picture(size, view, B=_at_vertices(result, steps[k].B))),
        )
        for k in chosen
    ]


def strip(result: Radiosity, solver: str | None = None, size: int = 256, view: Viewpoint = 0) -> Image.Image:
    """Return the pictures of ``watched`` on one sheet."""
    pictures = watched(result, solver, size, view)
    rows = [pictures[k : k + IN_A_ROW] for k in range(0, len(pictures), IN_A_ROW)]
    return tiles(f"{result.patches.scene.name}, {len(result.patches)} patches", rows, size)


def save_steps(
    result: Radiosity, path: str | os.PathLike[str], solver: str | None = None, size: int = 256, view: Viewpoint = 0
) -> None:
    """Write the pictures of ``watched``: as an animation if the name ends in .gif, else on one sheet."""
    if Path(path).suffix.lower() != ".gif":
        sheet = strip(result, solver, size, view)
        write_atomically(path, lambda name: sheet.save(name))
        return
    title = f"{result.patches.scene.name}, {len(result.patches)} patches"
    frames = [tiles(title, [[picture]], size) for picture in watched(result, solver, size, view)]
    seconds = [SECONDS] * (len(frames) - 1) + [LAST]
    times = [round(1000 * value) for value in seconds]
    write_atomically(
        path, lambda name: frames[0].save(name, save_all=True, append_images=frames[1:], duration=times, loop=0)
    )


def _at_vertices(result: Radiosity, B: Float) -> Float:
    """Return the radiosity at the vertices (V, 3): E and rho of each, and the mean irradiance of the patches around.

    The irradiance is (B - E) / rho, so that patches of a texture do not lend each other their colours.
    """
    p, mesh = result.patches, result.mesh
    H = np.divide(B - p.E, p.rho, out=np.zeros_like(B), where=p.rho > 0.0)
    return np.asarray(p.E[mesh.patch] + p.rho[mesh.patch] * averaged(p, mesh, H))
