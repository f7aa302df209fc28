"""The polygon tessellator: contours of any shape, with holes and crossings, become triangles.

plane.py puts the points on a grid of whole numbers and cuts the contours where they meet.  sweep.py moves a line over
the pieces: it counts the winding numbers, which say what lies inside, and cuts the inside into triangles.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from glsim import gl
from glsim.glu.constants import GLU_TESS_MAX_COORD, NAMES
from glsim.glu.errors import one_of, warn
from glsim.glu.plane import Contour, NeedCombineError, Plane
from glsim.glu.sweep import Edge, boundary_of, loops_of, triangles_of

RULES: dict[int, Callable[[int], bool]] = {
    NAMES["GLU_TESS_WINDING_ODD"]: lambda n: n % 2 == 1,
    NAMES["GLU_TESS_WINDING_NONZERO"]: lambda n: n != 0,
    NAMES["GLU_TESS_WINDING_POSITIVE"]: lambda n: n > 0,
    NAMES["GLU_TESS_WINDING_NEGATIVE"]: lambda n: n < 0,
    NAMES["GLU_TESS_WINDING_ABS_GEQ_TWO"]: lambda n: abs(n) >= 2,
}
PROPERTIES: tuple[int, ...] = tuple(
    NAMES[f"GLU_TESS_{name}"] for name in ("WINDING_RULE", "BOUNDARY_ONLY", "TOLERANCE")
)
CALLBACKS = ("BEGIN", "VERTEX", "END", "ERROR", "EDGE_FLAG", "COMBINE")


class Tessellator:
    """gluNewTess: callbacks, properties and the contours of the polygon that is being described."""

    def __init__(self) -> None:
        self.callbacks: dict[str, tuple[Callable[..., Any], bool]] = {}  # name -> function, whether it wants the data
        self.rule: int = NAMES["GLU_TESS_WINDING_ODD"]
        self.boundary_only = False
        self.tolerance = 0.0
        self.normal = np.zeros(3)
        self.contours: list[Contour] | None = None
        self.open = False  # between gluTessBeginContour and gluTessEndContour
        self.polygon_data: Any = None

    def call(self, name: str, *arguments: Any) -> Any:
        if name not in self.callbacks:
            return None
        function, wants_data = self.callbacks[name]
        return function(*arguments, self.polygon_data) if wants_data else function(*arguments)

    def fail(self, sentence: str, error: str) -> None:
        """To the callback; without one there is a warning."""
        if "ERROR" not in self.callbacks:
            warn(NAMES[error], sentence)
        else:
            self.call("ERROR", NAMES[error])

    @property
    def depth(self) -> int:
        """0: no polygon is begun; 1: a polygon; 2: a contour."""
        return 0 if self.contours is None else 1 + self.open

    def require(self, depth: int, name: str) -> None:
        """Report each begin or end that is missing before the call ``name``, and go on as if it had been there."""
        while self.depth < depth:
            if self.depth == 0:
                self.fail(f"{name}: gluTessBeginPolygon must come first", "GLU_TESS_MISSING_BEGIN_POLYGON")
                self.contours = []
            else:
                self.fail(f"{name}: gluTessBeginContour must come first", "GLU_TESS_MISSING_BEGIN_CONTOUR")
                gluTessBeginContour(self)
        while self.depth > depth:
            if self.depth == 2:
                self.open = False
                self.fail(f"{name}: gluTessEndContour must come first", "GLU_TESS_MISSING_END_CONTOUR")
            else:
                self.contours = None
                self.fail(f"{name}: gluTessEndPolygon must come first", "GLU_TESS_MISSING_END_POLYGON")


def gluNewTess() -> Tessellator:
    """A new object for the gluTess... functions, without callbacks, with the winding rule GLU_TESS_WINDING_ODD."""
    return Tessellator()


def gluDeleteTess(tess: Tessellator) -> None:
    """Accepted without effect: Python frees the object."""


def gluTessCallback(tess: Tessellator, which: int, function: Callable[..., Any] | None) -> None:
    """function: what is called; None for nothing."""
    for name in CALLBACKS:
        for wants_data in (False, True):
            if which == NAMES[f"GLU_TESS_{name}{'_DATA' if wants_data else ''}"]:
                if function is None:
                    tess.callbacks.pop(name, None)
                else:
                    tess.callbacks[name] = function, wants_data
                return
    sentence = f"gluTessCallback: which must be GLU_TESS_BEGIN, GLU_TESS_VERTEX or another callback, not {which!r}"
    tess.fail(sentence, "GLU_INVALID_ENUM")


def gluTessProperty(tess: Tessellator, which: int, data: float) -> None:
    """The winding rule, whether only the boundary is wanted, and a tolerance, which has no effect."""
    if which == NAMES["GLU_TESS_WINDING_RULE"] and data in RULES:
        tess.rule = int(data)
    elif which == NAMES["GLU_TESS_BOUNDARY_ONLY"]:
        tess.boundary_only = bool(data)
    elif which == NAMES["GLU_TESS_TOLERANCE"] and 0.0 <= data <= 1.0:
        tess.tolerance = float(data)
    elif which in PROPERTIES:
        expected = "from 0 to 1" if which == NAMES["GLU_TESS_TOLERANCE"] else one_of(RULES)
        tess.fail(f"gluTessProperty: data must be {expected}, not {data!r}", "GLU_INVALID_VALUE")
    else:
        tess.fail(f"gluTessProperty: which must be {one_of(PROPERTIES)}, not {which!r}", "GLU_INVALID_ENUM")


def gluGetTessProperty(tess: Tessellator, which: int, data: Any = None) -> Any:
    """The value, also in ``data``, an array of one number, if given."""
    if which not in PROPERTIES:
        tess.fail(f"gluGetTessProperty: which must be {one_of(PROPERTIES)}, not {which!r}", "GLU_INVALID_ENUM")
        return data
    value = float((tess.rule, tess.boundary_only, tess.tolerance)[PROPERTIES.index(which)])
    if data is None:
        return value
    data[0] = value
    return data


def gluTessNormal(tess: Tessellator, x: float, y: float, z: float) -> None:
    """Set the normal of the polygon's plane; (0, 0, 0): glsim computes it from the contours."""
    tess.normal = np.array([x, y, z], np.float64)


def gluTessBeginPolygon(tess: Tessellator, data: Any = None) -> None:
    """data: what the callbacks whose names end in _DATA get."""
    tess.require(0, "gluTessBeginPolygon")
    tess.contours, tess.polygon_data = [], data


def gluTessBeginContour(tess: Tessellator) -> None:
    """Begin a contour of the polygon: its vertices come by gluTessVertex, in order around it."""
    tess.require(1, "gluTessBeginContour")
    assert tess.contours is not None
    tess.contours.append([])
    tess.open = True


def gluTessVertex(tess: Tessellator, location: Any, data: Any = None) -> None:
    """location: x, y, z; data: what the vertex callback gets."""
    tess.require(2, "gluTessVertex")
    x, y, z = (float(c) for c in location[:3])
    if not max(abs(x), abs(y), abs(z)) <= GLU_TESS_MAX_COORD:
        tess.fail("gluTessVertex: location must be within 1e150 of the origin", "GLU_TESS_COORD_TOO_LARGE")
        x, y, z = (min(max(c, -GLU_TESS_MAX_COORD), GLU_TESS_MAX_COORD) if c == c else 0.0 for c in (x, y, z))
    assert tess.contours is not None
    tess.contours[-1].append((np.array([x, y, z]), data))


def gluTessEndContour(tess: Tessellator) -> None:
    """End the contour; its last vertex is joined to its first."""
    tess.require(2, "gluTessEndContour")
    tess.open = False


def gluTessEndPolygon(tess: Tessellator) -> None:
    """Cut the polygon into triangles, or into its boundary, and hand them to the callbacks."""
    tess.require(1, "gluTessEndPolygon")
    assert tess.contours is not None
    contours, tess.contours = [c for c in tess.contours if len(c) > 2], None
    if not contours:
        return
    combine = partial(tess.call, "COMBINE") if "COMBINE" in tess.callbacks else None
    try:
        plane = Plane(contours, tess.normal, combine)
    except NeedCombineError:
        sentence = "gluTessEndPolygon: contours cross, so a GLU_TESS_COMBINE callback must make the new vertex"
        tess.fail(sentence, "GLU_TESS_NEED_COMBINE_CALLBACK")
        return
    boundary = boundary_of(plane.grid, plane.edges, RULES[tess.rule])
    if tess.boundary_only:
        for loop in loops_of(boundary, plane.grid):
            tess.call("BEGIN", gl.GL_LINE_LOOP)
            for number in loop:
                tess.call("VERTEX", plane.data[number])
            tess.call("END")
        return
    _emit(tess, triangles_of(plane.grid, boundary), plane, set(boundary))


# The interface of GLU 1.1


def gluBeginPolygon(tess: Tessellator) -> None:
    """GLU 1.1: begin a polygon and its first contour."""
    gluTessBeginPolygon(tess)
    gluTessBeginContour(tess)


def gluNextContour(tess: Tessellator, type: int = 0) -> None:
    """GLU 1.1: end a contour and begin the next one.  type: ignored, the winding rule says what is a hole."""
    gluTessEndContour(tess)
    gluTessBeginContour(tess)


def gluEndPolygon(tess: Tessellator) -> None:
    """GLU 1.1: end the last contour and the polygon, which is cut into triangles."""
    gluTessEndContour(tess)
    gluTessEndPolygon(tess)


def _emit(tess: Tessellator, triangles: list[tuple[int, int, int]], plane: Plane, boundary: set[Edge]) -> None:
    """Triangles to the callbacks, as one GL_TRIANGLES."""
    if not triangles:
        return
    flags = "EDGE_FLAG" in tess.callbacks
    tess.call("BEGIN", gl.GL_TRIANGLES)
    last: bool | None = None
    for a, b, c in triangles:
        for edge in ((a, b), (b, c), (c, a)):
            if flags and (edge in boundary) != last:
                last = edge in boundary
                tess.call("EDGE_FLAG", last)
            tess.call("VERTEX", plane.data[edge[0]])
    tess.call("END")
