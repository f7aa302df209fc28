"""Drawing the samples of NURBS with gl, or handing them to the callbacks of GLU_NURBS_TESSELLATOR."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.gl.arrays import ARRAYS
from glsim.glu.constants import NAMES
from glsim.glu.nurbsobject import MODE, Nurbs
from glsim.glu.spline import Spline
from glsim.glu.trimming import clipped, filled, holds, inside
from glsim.machine.state import TEXTURE_UNITS

Float = NDArray[np.float64]
# what a map gives -> the callback that takes it; the vertex array, and the command that says where it lies
CALLBACKS = {"vertex": "VERTEX", "normal": "NORMAL", "color": "COLOR", "texcoord": "TEXTURE_COORD"}
POINTERS: dict[str, tuple[int, Callable[..., Any]]] = {
    "vertex": (gl.GL_VERTEX_ARRAY, gl.glVertexPointer), "normal": (gl.GL_NORMAL_ARRAY, gl.glNormalPointer),
    "color": (gl.GL_COLOR_ARRAY, gl.glColorPointer), "texcoord": (gl.GL_TEXTURE_COORD_ARRAY, gl.glTexCoordPointer),
}  # fmt: skip


class Output:
    """The samples at some places, with all that the maps say, for OpenGL or for the callbacks.

    places: parameters (n,); of a surface u and v, each place a pair, or with ``grid`` every u with every v.
    """

    def __init__(self, nurb: Nurbs, *places: Float, grid: bool = False) -> None:
        def at_places(spline: Spline, derive: int | None = None) -> Float:
            return spline.grid(*places, derive=derive) if grid else spline(*places, derive=derive)

        self.nurb, maps = nurb, nurb.maps
        self.calls = nurb.properties[MODE] == NAMES["GLU_NURBS_TESSELLATOR"]
        values = {name: at_places(spline) for name, spline in maps.items()}
        points = values["vertex"]
        wanted = "NORMAL" in nurb.callbacks if self.calls else gl.glIsEnabled(gl.GL_AUTO_NORMAL)
        if len(places) == 2 and wanted and ("normal" not in values or not self.calls):
            values["normal"] = _normals(points, *(at_places(maps["vertex"], axis) for axis in (0, 1)))
        if self.calls and points.shape[1] == 4:
            values["vertex"] = points[:, :3] / points[:, 3:]
        self.columns = [(name, values[name]) for name in ("color", "texcoord", "normal", "vertex") if name in values]

    def draw(self, mode: int, numbers: Sequence[int] | NDArray[np.intp]) -> None:
        """Primitives of the samples with these numbers."""
        if self.calls:
            self.nurb.call("BEGIN", mode)
            for n in numbers:
                for name, values in self.columns:
                    self.nurb.call(CALLBACKS[name], values[n].astype(np.float32))
            self.nurb.call("END")
            return
        gl.glPushClientAttrib(gl.GL_CLIENT_VERTEX_ARRAY_BIT)
        _no_arrays()
        for name, values in self.columns:
            array, pointer = POINTERS[name]
            gl.glEnableClientState(array)
            pointer(*(() if name == "normal" else (values.shape[1],)), gl.GL_DOUBLE, 0, values)
        gl.glDrawElements(mode, len(numbers), gl.GL_UNSIGNED_INT, np.asarray(numbers, np.uint32))
        gl.glPopClientAttrib()


def _no_arrays() -> None:
    """Disable the vertex arrays that the program may have left enabled."""
    for target in (gl.GL_ARRAY_BUFFER, gl.GL_ELEMENT_ARRAY_BUFFER):
        gl.glBindBuffer(target, 0)
    for unit in reversed(range(TEXTURE_UNITS)):
        gl.glClientActiveTexture(gl.GL_TEXTURE0 + unit)
        gl.glDisableClientState(gl.GL_TEXTURE_COORD_ARRAY)
    for array in ARRAYS.values():
        gl.glDisableClientState(array)


def _normals(points: Float, du: Float, dv: Float) -> Float:
    """Unit normals at points (n, 3 or 4), along the derivative by u x the derivative by v."""
    if points.shape[1] == 4:  # of (x/w, y/w, z/w), by the quotient rule
        du, dv = (d[:, :3] * points[:, 3:] - points[:, :3] * d[:, 3:] for d in (du, dv))
    normals = np.cross(du, dv)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    result = np.tile([0.0, 0.0, 1.0], (len(normals), 1))
    return np.asarray(np.divide(normals, length, out=result, where=length > 0))


def draw_cells(nurb: Nurbs, u: Float, v: Float, loops: list[Float]) -> None:
    """The cells of the grid, counterclockwise seen from where u x v points."""
    whole, cut = np.ones((len(u) - 1, len(v) - 1), bool), np.zeros((len(u) - 1, len(v) - 1), bool)
    if loops:
        whole, cut = inside(u, v, loops)
    grid = Output(nurb, u, v, grid=True)
    if grid.calls:
        _draw_strips(grid, whole)
    elif whole.any():
        n = np.add.outer(np.arange(len(u) - 1) * len(v), np.arange(len(v) - 1))[whole]
        # the corners (i, j + 1), (i, j), (i + 1, j), (i + 1, j + 1): cut and coloured as those of a strip
        grid.draw(gl.GL_QUADS, np.stack([n + 1, n, n + len(v), n + len(v) + 1], axis=1).ravel())
    corners: list[tuple[float, float]] = []
    for i, j in np.argwhere(cut).tolist():
        corners += filled([clipped(loop, u[i], u[i + 1], v[j], v[j + 1]) for loop in loops])
    if corners:
        u_v = np.array(corners)
        Output(nurb, u_v[:, 0], u_v[:, 1]).draw(gl.GL_TRIANGLES, range(len(u_v)))


def _draw_strips(grid: Output, whole: NDArray[np.bool_]) -> None:
    """The whole cells as quad strips, for the callbacks."""
    columns = whole.shape[1] + 1
    for i, row in enumerate(whole):
        below, above = i * columns, (i + 1) * columns
        edges = np.flatnonzero(np.diff(row.astype(np.int8), prepend=0, append=0)).tolist()
        for first, last in zip(edges[::2], edges[1::2], strict=True):
            grid.draw(gl.GL_QUAD_STRIP, [n + j for j in range(first, last + 1) for n in (below, above)])


def draw_patches(nurb: Nurbs, spline: Spline, u: Float, v: Float, loops: list[Float]) -> None:
    """The edges of the patches; of a trimmed surface the trimming loops, and the edges between patches inside them."""
    for loop in loops:
        closed = np.concatenate([loop, loop[:1]])
        Output(nurb, closed[:, 0], closed[:, 1]).draw(gl.GL_LINE_STRIP, range(len(closed)))
    for axis, stops in ((0, v), (1, u)):
        for knot in spline.spans(axis)[1:-1] if loops else spline.spans(axis):
            places = (np.full_like(stops, knot), stops) if axis == 0 else (stops, np.full_like(stops, knot))
            output = Output(nurb, *places)
            middles = [(place[:-1] + place[1:]) / 2 for place in places]
            kept = [k for k, at in enumerate(zip(*middles, strict=True)) if not loops or holds(loops, *at)]
            segments = np.add.outer(kept, [0, 1])
            for ends in segments if output.calls else [segments.ravel()]:
                output.draw(gl.GL_LINES, ends)
