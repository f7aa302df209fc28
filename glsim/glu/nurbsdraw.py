"""Drawing the samples of NURBS with gl, or handing them to the callbacks of GLU_NURBS_TESSELLATOR."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.constants import NAMES
from glsim.glu.nurbsobject import MODE, Nurbs
from glsim.glu.spline import Spline
from glsim.glu.trimming import clipped, filled, holds, inside

Float = NDArray[np.float64]


class Output:
    """The samples at some places, with all that the maps say, for OpenGL or for the callbacks."""

    def __init__(self, nurb: Nurbs, *places: Float) -> None:
        self.nurb, maps = nurb, nurb.maps
        self.calls = nurb.properties[MODE] == NAMES["GLU_NURBS_TESSELLATOR"]
        points = maps["vertex"](*places)
        normals = maps["normal"](*places) if "normal" in maps else None
        wanted = "NORMAL" in nurb.callbacks if self.calls else gl.glIsEnabled(gl.GL_AUTO_NORMAL)
        if len(places) == 2 and wanted and (normals is None or not self.calls):
            normals = _normals(maps["vertex"], points, places)
        if self.calls and points.shape[1] == 4:
            points = points[:, :3] / points[:, 3:]
        columns: list[tuple[str, Callable[..., Any], Float | None]] = [
            ("COLOR", gl.glColor4dv, maps["color"](*places) if "color" in maps else None),
            ("TEXTURE_COORD", _texcoord, maps["texcoord"](*places) if "texcoord" in maps else None),
            ("NORMAL", gl.glNormal3dv, normals),
            ("VERTEX", gl.glVertex4dv if points.shape[1] == 4 else gl.glVertex3dv, points),
        ]
        self.columns = [(name, call, values) for name, call, values in columns if values is not None]
        self.rows = [(call, values.tolist()) for _, call, values in self.columns]

    def draw(self, mode: int, numbers: Iterable[int]) -> None:
        """One primitive of the samples with these numbers."""
        if self.calls:
            self.nurb.call("BEGIN", mode)
            for n in numbers:
                for name, _, values in self.columns:
                    self.nurb.call(name, values[n].astype(np.float32))
            self.nurb.call("END")
            return
        gl.glBegin(mode)
        for n in numbers:
            for call, rows in self.rows:
                call(rows[n])
        gl.glEnd()


def _texcoord(values: list[float]) -> None:
    gl.glTexCoord(*values)


def _normals(spline: Spline, points: Float, places: tuple[Float, ...]) -> Float:
    """Unit normals, along the derivative by u x the derivative by v."""
    du, dv = (spline(*places, derive=axis) for axis in (0, 1))
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
    places = np.meshgrid(u, v, indexing="ij")
    grid = Output(nurb, places[0].ravel(), places[1].ravel())
    for i, row in enumerate(whole):
        below, above = i * len(v), (i + 1) * len(v)
        edges = np.flatnonzero(np.diff(row.astype(np.int8), prepend=0, append=0)).tolist()
        for first, last in zip(edges[::2], edges[1::2], strict=True):
            strip = [n + j for j in range(first, last + 1) for n in (below, above)]
            grid.draw(gl.GL_QUAD_STRIP, strip)
    corners: list[tuple[float, float]] = []
    for i, j in np.argwhere(cut).tolist():
        corners += filled([clipped(loop, u[i], u[i + 1], v[j], v[j + 1]) for loop in loops])
    if corners:
        u_v = np.array(corners)
        Output(nurb, u_v[:, 0], u_v[:, 1]).draw(gl.GL_TRIANGLES, range(len(u_v)))


def draw_patches(nurb: Nurbs, spline: Spline, u: Float, v: Float, loops: list[Float]) -> None:
    """The edges of the patches; of a trimmed surface the trimming loops, and the edges between patches inside them."""
    for loop in loops:
        closed = np.concatenate([loop, loop[:1]])
        Output(nurb, closed[:, 0], closed[:, 1]).draw(gl.GL_LINE_STRIP, range(len(closed)))
    for axis, stops in ((0, v), (1, u)):
        for knot in spline.spans(axis)[1:-1] if loops else spline.spans(axis):
            places = (np.full_like(stops, knot), stops) if axis == 0 else (stops, np.full_like(stops, knot))
            output = Output(nurb, *places)
            for k in range(len(stops) - 1):
                if not loops or holds(loops, *((place[k] + place[k + 1]) / 2 for place in places)):
                    output.draw(gl.GL_LINES, (k, k + 1))
