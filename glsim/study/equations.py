"""The probe's equations for a coarse grid of pixels, as text: what a page of pictures shows where one is clicked."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from textwrap import wrap

from glsim.machine.frame import Frame
from glsim.study.probe import Evaluation, LightTerms, Probe
from glsim.study.studio import Cell, Key

POINTS = 16  # of a row and of a column of the grid
SECONDS = 3.0  # for a picture, about, on two cores
COST, COST_OF_A_VERTEX = 0.02, 2.5e-6  # seconds for a pixel, measured with the teapot of 1152 to 32768 quads

WIDTH = 44  # letters of a line

Equations = dict[tuple[int, int], str]


def equations(cells: Mapping[Key, Cell], tell: Callable[[str], object]) -> dict[Key, Equations]:
    """For each picture that glsim shaded some pixels (x, y), from the upper left, and their equations.

    tell: called with the progress in words."""
    frames = {key: cell.frame for key, cell in cells.items() if cell.frame is not None}
    found = {}
    for number, (key, frame) in enumerate(frames.items(), 1):
        tell(f"equations of picture {number} of {len(frames)}")
        found[key] = of_picture(frame, cells[key])
    return found


def of_picture(frame: Frame, cell: Cell) -> Equations:
    from glsim.study.prober import Prober

    prober = Prober(frame)
    try:
        return {(x, y): text for x, y in grid(frame, cell) if (text := words(prober.at(x, y)))}
    finally:
        prober.release()


def grid(frame: Frame, cell: Cell) -> list[tuple[int, int]]:
    """Pixels in rows and columns where something other than the corner's colour is seen; fewer of large meshes."""
    assert cell.pixels is not None
    height, width = cell.pixels.shape[:2]
    vertices = sum(draw.count if draw.indices is None else len(draw.indices) for draw in frame.draws)
    most = max(SECONDS / (COST + COST_OF_A_VERTEX * vertices), 9.0)
    for points in range(min(POINTS, width, height), 2, -1):
        places = [((2 * i + 1) * width // (2 * points), (2 * j + 1) * height // (2 * points))
                  for j in range(points) for i in range(points)]  # fmt: skip
        seen = [(x, y) for x, y in places if (cell.pixels[y, x] != cell.pixels[0, 0]).any()]
        if len(seen) <= most:
            return seen
    return []


# ---------------------------------------------------------------- words


def words(probe: Probe) -> str:
    """The winning fragment's equation with its numbers, in short lines; "" where the background is seen."""
    winner = probe.winner
    if winner is None:
        return ""
    lines = [winner.what, winner.shading]
    for evaluation in winner.evaluations:
        lines += _equation(evaluation, len(winner.evaluations) > 1)
    if not winner.evaluations:
        lines.append(f"C = {_three(winner.primary)}")
    steps = (step for step in winner.steps if step.name != "depth test")
    lines += [f"{step.name}: {step.formula}: {_three(step.color)}" for step in steps]
    r, g, b, _ = probe.pixel
    lines.append(f"8 bits: ({r}, {g}, {b})")
    return "\n".join(part for line in lines for part in wrap(line, WIDTH, subsequent_indent="  "))


def _equation(e: Evaluation, several: bool) -> Iterator[str]:
    yield f"at the {e.at}" + (f", weight {e.weight:.3f}" if several else "")
    yield f"  N = {_three(e.N)}"
    if any(e.emission):
        yield f"  emission {_three(e.emission)}"
    yield f"  k_a I_a = {_three(e.ambient)}"
    for light in e.lights:
        yield from _light(light, e.n)
    yield f"  I = {_three(e.sum)}"
    if e.sum != e.clamped:
        yield f"  clamped {_three(e.clamped)}"


def _light(light: LightTerms, n: float) -> Iterator[str]:
    cosine = "N·H" if light.vector == "H" else "R·V"
    weaker = "" if light.attenuation == light.spot == 1.0 else f", weaker by {light.attenuation * light.spot:.3f}"
    yield f"  light {light.light}: N·L = {light.N_L:.3f}{weaker}"
    if any(light.ambient):
        yield f"    k_a I_a = {_three(light.ambient)}"
    yield f"    k_d I_d (N·L) = {_three(light.diffuse)}"
    if light.N_L > 0.0:
        yield f"    {cosine} = {light.cosine:.3f}, to the {n:g}: {light.power:.3f}"
        yield f"    k_s I_s ({cosine})^n = {_three(light.specular)}"


def _three(values: tuple[float, ...]) -> str:
    return "(" + ", ".join(f"{value:.3f}" for value in values[:3]) + ")"
