"""A radiosity solution as a live picture: its light step by step, direct or whole, and the exposure."""

from __future__ import annotations

from collections.abc import Callable
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.frame import Frame, Vertices
from glsim.play.capture import capture
from glsim.radiosity.cameras import Viewpoint
from glsim.radiosity.pointlights import ambient_of
from glsim.radiosity.result import Radiosity
from glsim.radiosity.view import look
from glsim.render.context import own_screen
from glsim.render.recorder import record
from glsim.study.live import AS_DRAWN, camera_of
from glsim.web.live import Live

Float = NDArray[np.float64]
FIRST_DIRECT = 1  # the number of bounces after which light is direct illumination
ENOUGH = 0.01  # of the light is missing: more bounces are not shown
MOST_BOUNCES = 12
COLOR = 6 * 4  # bytes before the colour in a row of vertices


def radiosity_live(
    result: Radiosity, title: str | None = None, *, size: int = 512, view: Viewpoint = 0, samples: int = 4,
    progress: Callable[[str], object] | None = None,
) -> Live:  # fmt: skip
    """A solution as a live picture, ``size`` pixels wide and high, seen first from one of its cameras.

    Its light is shown after each bounce (gathering, the steps of Jacobi's method), direct, direct with the ambient
    glow that OpenGL's lights would have instead of bounces, or whole; the exposure is a slider.

    progress: called with words about what is being done.  Raises SceneError if there is no such camera.
    """
    tell = progress or (lambda words: None)
    stages = dict(_stages(result, tell))
    names = list(stages)
    frame, blocks, vertices = _drawn(result, size, view)
    colors = result.colors(stages["radiosity"])
    for block, numbers in zip(blocks, vertices, strict=True):
        block.rows[:, 6:9] = colors[numbers]
    with own_screen(size, size, samples=samples) as screen:
        screen.execute(frame.packets)
        poster = np.ascontiguousarray(screen.pixels()[..., :3])
    tape = record({"picture": frame}, samples)
    shown = np.concatenate(vertices)
    data = {
        "stages": [{"name": name, "blob": tape.blob(_halves(B[shown]))} for name, B in stages.items()],
        "steps": names.index("radiosity") + 1,
        "choices": {name: names.index(name) for name in ("direct", "direct + ambient", "radiosity")},
        "white": result.shown_white, "gamma": result.gamma, "tone": result.shown_tone,
        "parts": [{"rows": tape.blob(block.rows.tobytes()), "count": len(block.rows)} for block in blocks],
        "stride": blocks[0].rows.itemsize * blocks[0].rows.shape[1], "offset": COLOR,
    }  # fmt: skip
    moment = {"lights": [], "materials": [], "ambient": [0, 0, 0, 1], "localViewer": False, "camera": camera_of(frame)}
    name = title or f"{result.patches.scene.name}: radiosity"
    return Live(
        name, tape, poster, {f"0 {AS_DRAWN} blinn": 0}, [moment], [AS_DRAWN], ["blinn"], AS_DRAWN, "blinn",
        radiosity=data,
    )  # fmt: skip


def _stages(result: Radiosity, tell: Callable[[str], object]) -> Any:
    """By name the radiosities at the vertices (V, 3): step by step from the lamps' own light to the solution, and then
    what OpenGL would show instead."""
    E, rho = result.patches.E, result.patches.rho
    whole = float((result.patches.area[:, None] * result.B).sum())
    of = result.mesh.patch
    direct = result.direct()
    yield "lamps alone", E[of]
    yield "direct", direct
    for step in islice(result.iterations("jacobi"), FIRST_DIRECT, MOST_BOUNCES):
        tell(f"light after {step.iteration + 1} bounces")
        if whole - float((result.patches.area[:, None] * step.B).sum()) < ENOUGH * whole:
            break
        yield f"{step.iteration + 1} bounces", result.at_vertices(step.B)
    yield "radiosity", result.vertex_radiosity
    yield "direct + ambient", direct + rho[of] * ambient_of(result)


def _drawn(result: Radiosity, size: int, view: Viewpoint) -> tuple[Frame, list[Vertices], list[NDArray[np.int64]]]:
    """The solution's picture as a Frame, its blocks of vertices, and which of the mesh's vertices stand in each.

    The vertices are drawn with their numbers as red, so that it does not matter in which order they are drawn.
    """
    count = len(result.vertex_radiosity)
    numbers = np.zeros((count, 3))
    numbers[:, 0] = np.arange(count)
    with own_screen(size, size), capture(calls=True) as frame:
        look(result.view(view), result.patches.scene)
        result.draw(numbers)
    blocks = list({id(draw.block): draw.block for draw in frame.draws}.values())
    return frame, blocks, [np.rint(block.rows[:, 6]).astype(np.int64) for block in blocks]


def _halves(values: Float) -> bytes:
    """Numbers of 16 bits, which tell steps of a two-thousandth."""
    return np.minimum(values, np.finfo(np.float16).max).astype("<f2").tobytes()
