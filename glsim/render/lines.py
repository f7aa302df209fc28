"""How large lines and points are; wide, smooth and stippled lines as vertices for shaders/line.glsl."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.machine.clipping import distances
from glsim.machine.constants import GL_LINE_LOOP, GL_LINE_STRIP, GL_LINES
from glsim.machine.frame import Draw, Vertices
from glsim.machine.matrix import evaluate, multiply
from glsim.machine.stage import window
from glsim.machine.state import Material, Snapshot
from glsim.render.batch import assembled

Float = NDArray[np.float32]
MOST = 4096.0  # pixels beyond the viewport that are drawn


def line_width(state: Snapshot) -> float:
    """The width lines are drawn with: rounded, at least one pixel (section 3.4.2); a smooth line's is exact."""
    return state.line.width if state.line.smooth else max(float(np.floor(state.line.width + 0.5)), 1.0)


def widened(state: Snapshot) -> bool:
    """Whether the state's lines are drawn as triangles: smooth ones, and those wider than a pixel."""
    return state.line.smooth or line_width(state) > 1.0


def point_size(state: Snapshot) -> float:
    """The largest diameter in pixels that a point can have; with distance attenuation, the largest that is allowed."""
    point = state.point
    return point.size if point.distance_attenuation == (1.0, 0.0, 0.0) else point.size_max


def margin(state: Snapshot, corners: int) -> int:
    """By how many pixels the driver's viewport is larger than the program's on all sides (shaders/margin.glsl).

    Points and wide lines are clipped as if they had no extent (section 2.11), and may then reach beyond the viewport.
    """
    if corners == 3 or (corners == 2 and not widened(state)):
        return 0
    extent = point_size(state) if corners == 1 else line_width(state)
    return int(np.ceil(min(extent, MOST) / 2.0)) + 1


def positions(block: Vertices, chosen: NDArray[np.uint32]) -> Float:
    """Homogeneous positions (n, 4) in object space of the vertices with these numbers (n,)."""
    result = np.ones((len(chosen), 4), np.float32)
    result[:, :3] = block.rows[chosen, :3]
    if "w" in block.columns:
        result[:, 3] = block.column("w")[chosen, 0]
    return result


def eye_and_clip(draw: Draw, chosen: NDArray[np.uint32]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions (n, 4) in eye space and in clip space of the vertices with these numbers (n,).

    A row of ``places`` is a point P.  Matrices are kept column first, so the array ``modelview`` is the transpose of M,
    and the row P @ modelview is the column M P.  For a translation by 5 along x:

        modelview = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [5, 0, 0, 1]]
        [1, 2, 3, 1] @ modelview = [6, 2, 3, 1]
    """
    evaluate(draw.matrices)
    modelview, projection = (matrix.get()[None] for matrix in draw.matrices[:2])
    places = positions(draw.block, chosen).astype(np.float64)
    return places @ modelview[0], np.asarray(places @ multiply(projection, modelview)[0].astype(np.float64))


def clip_positions(draw: Draw, chosen: NDArray[np.uint32]) -> NDArray[np.float64]:
    """Positions (n, 4) in clip space."""
    return eye_and_clip(draw, chosen)[1]


ENDS = np.array([0, 0, 1, 1])  # of a wide line's corners
CORNERS = np.array([(-1, -1), (-1, 1), (1, -1), (1, 1)], np.float32)
TRIANGLES = np.array([0, 1, 2, 1, 3, 2], np.uint32)  # both end in the line's second vertex, the provoking one


def lines(draws: list[Draw]) -> list[Draw]:
    """Draws of wide or stippled lines -> Draws over new vertices that shaders/line.glsl can widen and count along.

    draws: they share their vertices and their state.  A wide line becomes two triangles over four vertices, two at each
    end; a thin one keeps two.  Each vertex also gets the line's other end, and which corner of the line it is.
    """
    block, state = draws[0].block, draws[0].state
    wide = widened(state)
    ends = [assembled(draw).reshape(-1, 2) for draw in draws]
    order = ENDS if wide else np.array([0, 1])
    chosen = np.concatenate(ends)[:, order].ravel()
    materials: list[tuple[int, Material]] = []
    result, first = [], 0
    vertices = block.take(chosen)
    for draw, pairs in zip(draws, ends, strict=True):
        count = pairs.size * (2 if wide else 1)
        if block.materials:
            used = draw.materials_at(chosen[first : first + count])
            materials += [(first + k, material) for k, material in enumerate(used)]
        part = Draw(GL_LINES, first, count, None, draw.matrices, draw.material, state, vertices)
        if wide:
            part.indices = (np.arange(len(pairs), dtype=np.uint32)[:, None] * 4 + TRIANGLES).ravel()
        part.color, part.call = draw.color, draw.call
        result.append(part)
        first += count
    others = np.concatenate(ends)[:, 1 - order].ravel()
    vertices.columns["other_end"] = positions(block, others)
    vertices.columns["line_corner"] = np.tile(CORNERS if wide else CORNERS[[0, 2]], (len(chosen) // len(order), 1))
    if state.line.stipple:
        begins = [_begins(draw, pairs) for draw, pairs in zip(draws, ends, strict=True)]
        vertices.columns["line_begin"] = np.repeat(np.concatenate(begins), len(order))[:, None]
    vertices.materials = materials
    return result


def _begins(draw: Draw, pairs: NDArray[np.uint32]) -> Float:
    """How many pixels of the stipple pattern come before each line (n, 2): (n,).

    A strip or loop goes on where its last line ended; separate lines begin anew (section 3.4.2).
    """
    begins = np.zeros(len(pairs), np.float32)
    if draw.mode in (GL_LINE_STRIP, GL_LINE_LOOP) and len(pairs):
        ends = _visible_ends(draw, pairs)
        counts = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) if draw.state.line.smooth else _fragments(ends)
        begins[1:] = np.floor(np.cumsum(counts))[:-1]
    return begins


def _visible_ends(draw: Draw, pairs: NDArray[np.uint32]) -> NDArray[np.float64]:
    """Both ends in pixels of what clipping leaves of each line, (n, 2, 2); equal ends if nothing is left."""
    eye, clip = eye_and_clip(draw, pairs.ravel())
    planes = distances(clip, eye, draw.state.transform).reshape(*pairs.shape, -1)
    a, b = planes[:, 0], planes[:, 1]
    with np.errstate(all="ignore"):
        at = a / (a - b)
        enters = np.where((a < 0.0) & (b >= 0.0), at, 0.0).max(axis=1)
        leaves = np.where((a >= 0.0) & (b < 0.0), at, 1.0).min(axis=1)
        part = np.stack([enters, leaves], axis=1)[..., None]
        clip = clip.reshape(-1, 2, 4)
        left = (clip[:, :1] + part * (clip[:, 1:] - clip[:, :1])).reshape(-1, 4)
        ends = window(left, draw.state.viewport)[:, :2].reshape(-1, 2, 2)
    ends[(enters > leaves) | ((a < 0.0) & (b < 0.0)).any(axis=1)] = 0.0
    return np.nan_to_num(ends, posinf=0.0, neginf=0.0)


def _fragments(ends: NDArray[np.float64]) -> NDArray[np.float64]:
    """How many fragments each line (n, 2, 2) has: (n,) (section 3.4.1, figure 3.4).

    A line has a fragment for each pixel whose diamond it leaves.  The diamond is |x| + |y| < 1/2 around the centre of
    the pixel.  ``behind`` counts the diamonds that lie behind an end, seen along the line.
    """
    size = np.abs(ends[:, 1] - ends[:, 0])
    steep = (size[:, 1] > size[:, 0])[:, None]
    along, across = np.where(steep, ends[..., 1], ends[..., 0]), np.where(steep, ends[..., 0], ends[..., 1])
    along = along * np.where(along[:, 1] < along[:, 0], -1.0, 1.0)[:, None]
    behind = np.floor(along + np.abs(across - np.floor(across) - 0.5) + 1e-4)
    return behind[:, 1] - behind[:, 0]
