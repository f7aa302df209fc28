"""NURBS curves and surfaces: B-splines, rational or not, sampled as finely as the screen shows, with trimming."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu import tess
from glsim.glu.constants import NAMES
from glsim.glu.errors import GLUError

Float = NDArray[np.float64]
MOST_STEPS = 200  # between two knots
# what a map gives -> components, the command that takes them
CURVES: dict[int, tuple[str, int]] = {
    gl.GL_MAP1_VERTEX_3: ("vertex", 3), gl.GL_MAP1_VERTEX_4: ("vertex", 4), gl.GL_MAP1_NORMAL: ("normal", 3),
    gl.GL_MAP1_COLOR_4: ("color", 4), gl.GL_MAP1_TEXTURE_COORD_1: ("texcoord", 1),
    gl.GL_MAP1_TEXTURE_COORD_2: ("texcoord", 2), gl.GL_MAP1_TEXTURE_COORD_3: ("texcoord", 3),
    gl.GL_MAP1_TEXTURE_COORD_4: ("texcoord", 4), NAMES["GLU_MAP1_TRIM_2"]: ("trim", 2),
    NAMES["GLU_MAP1_TRIM_3"]: ("trim", 3),
}  # fmt: skip
SURFACES: dict[int, tuple[str, int]] = {
    gl.GL_MAP2_VERTEX_3: ("vertex", 3), gl.GL_MAP2_VERTEX_4: ("vertex", 4), gl.GL_MAP2_NORMAL: ("normal", 3),
    gl.GL_MAP2_COLOR_4: ("color", 4), gl.GL_MAP2_TEXTURE_COORD_1: ("texcoord", 1),
    gl.GL_MAP2_TEXTURE_COORD_2: ("texcoord", 2), gl.GL_MAP2_TEXTURE_COORD_3: ("texcoord", 3),
    gl.GL_MAP2_TEXTURE_COORD_4: ("texcoord", 4),
}  # fmt: skip


class Spline:
    """A B-spline of one or two parameters: knots for each, control points (n, k) or (n, m, k)."""

    def __init__(self, knots: list[Float], points: Float) -> None:
        self.knots, self.points = knots, points
        self.orders = [len(t) - n for t, n in zip(knots, points.shape, strict=False)]

    def domain(self, axis: int) -> tuple[float, float]:
        order, t = self.orders[axis], self.knots[axis]
        return float(t[order - 1]), float(t[len(t) - order])

    def spans(self, axis: int) -> Float:
        """The different knots inside the domain."""
        low, high = self.domain(axis)
        t = np.unique(self.knots[axis])
        return t[(t >= low) & (t <= high)]

    def __call__(self, *places: Float, derive: int | None = None) -> Float:
        """At places (n,) for each parameter -> (n, k); derive: the derivative by that parameter."""
        bases = [_basis(self.knots[axis], self.orders[axis], t, int(derive == axis)) for axis, t in enumerate(places)]
        letters = "ni,ik->nk" if len(places) == 1 else "ni,nj,ijk->nk"
        return np.asarray(np.einsum(letters, *bases, self.points))


def _basis(knots: Float, order: int, t: Float, derivative: int) -> Float:
    """B-spline basis functions, or their derivatives, at t (n,): (n, len(knots) - order), by Cox and de Boor."""
    last = np.searchsorted(knots, knots[len(knots) - order], side="left") - 1
    span = np.clip(np.searchsorted(knots, t, side="right") - 1, order - 1, max(last, order - 1))
    N = np.zeros((len(t), len(knots) - 1))
    N[np.arange(len(t)), span] = 1.0
    for degree in range(1, order):
        count = len(knots) - 1 - degree
        left = knots[degree : degree + count] - knots[:count]
        right = knots[degree + 1 : degree + 1 + count] - knots[1 : 1 + count]
        with np.errstate(all="ignore"):
            a, b = np.where(left > 0, 1.0 / left, 0.0), np.where(right > 0, 1.0 / right, 0.0)
        lower, upper = N[:, :count], N[:, 1 : count + 1]
        if derivative and degree == order - 1:
            N = degree * (lower * a - upper * b)
        else:
            N = lower * a * (t[:, None] - knots[:count]) + upper * b * (
                knots[degree + 1 : degree + 1 + count] - t[:, None]
            )
    return N[:, : len(knots) - order]


class Nurbs:
    """gluNewNurbsRenderer: properties, and what is being described between Begin and End."""

    def __init__(self) -> None:
        self.tolerance = 50.0
        self.method: int = NAMES["GLU_PATH_LENGTH"]
        self.steps = [100.0, 100.0]
        self.display: int = NAMES["GLU_FILL"]
        self.properties: dict[int, float] = {}
        self.maps: dict[str, Spline] = {}
        self.trims: list[list[Float]] = []
        self.trimming = False
        self.matrices: tuple[Float, Float, Float] | None = None
        self.callbacks: dict[int, Callable[..., Any]] = {}


def gluNewNurbsRenderer() -> Nurbs:
    return Nurbs()


def gluDeleteNurbsRenderer(nurb: Nurbs) -> None:
    pass


def gluNurbsCallback(nurb: Nurbs, which: int, function: Callable[..., Any] | None) -> None:
    """GLU_NURBS_ERROR; the callbacks of GLU_NURBS_TESSELLATOR are kept and not called."""
    if function is None:
        nurb.callbacks.pop(int(which), None)
    else:
        nurb.callbacks[int(which)] = function


def gluNurbsProperty(nurb: Nurbs, property: int, value: float) -> None:
    if property == NAMES["GLU_SAMPLING_TOLERANCE"]:
        nurb.tolerance = max(float(value), 0.5)
    elif property == NAMES["GLU_DISPLAY_MODE"]:
        nurb.display = int(value)
    elif property == NAMES["GLU_SAMPLING_METHOD"]:
        nurb.method = int(value)
    elif property in (NAMES["GLU_U_STEP"], NAMES["GLU_V_STEP"]):
        nurb.steps[int(property == NAMES["GLU_V_STEP"])] = max(float(value), 1.0)
    elif not NAMES["GLU_NURBS_MODE"] <= property <= NAMES["GLU_OBJECT_PATH_LENGTH"]:
        raise GLUError(int(NAMES["GLU_INVALID_ENUM"]), "gluNurbsProperty: property must be GLU_SAMPLING_TOLERANCE, ...")
    nurb.properties[int(property)] = float(value)


def gluGetNurbsProperty(nurb: Nurbs, property: int) -> float:
    defaults = {
        NAMES["GLU_SAMPLING_TOLERANCE"]: nurb.tolerance, NAMES["GLU_DISPLAY_MODE"]: nurb.display,
        NAMES["GLU_SAMPLING_METHOD"]: nurb.method, NAMES["GLU_U_STEP"]: nurb.steps[0],
        NAMES["GLU_V_STEP"]: nurb.steps[1], NAMES["GLU_AUTO_LOAD_MATRIX"]: 1.0, NAMES["GLU_CULLING"]: 0.0,
        NAMES["GLU_PARAMETRIC_TOLERANCE"]: 0.5,
    }  # fmt: skip
    known: dict[int, float] = {int(name): float(value) for name, value in defaults.items()}
    return nurb.properties.get(int(property), known.get(int(property), 0.0))


def gluLoadSamplingMatrices(nurb: Nurbs, model: Any, perspective: Any, view: Any) -> None:
    """The matrices by which sampling measures pixels, for GLU_AUTO_LOAD_MATRIX off."""
    m, p = (np.asarray(given, np.float64).reshape(4, 4) for given in (model, perspective))
    nurb.matrices = m, p, np.asarray(view, np.float64).reshape(4)


# ---------------------------------------------------------------- description


def gluBeginCurve(nurb: Nurbs) -> None:
    nurb.maps = {}


def gluBeginSurface(nurb: Nurbs) -> None:
    nurb.maps, nurb.trims = {}, []


def gluBeginTrim(nurb: Nurbs) -> None:
    nurb.trimming = True
    nurb.trims.append([])


def gluEndTrim(nurb: Nurbs) -> None:
    nurb.trimming = False


def _checked(name: str, spline: Spline) -> Spline:
    for order, knots in zip(spline.orders, spline.knots, strict=True):
        if order < 2:
            raise GLUError(
                int(NAMES["GLU_NURBS_ERROR"]), f"{name}: there must be at least 2 more knots than control points"
            )
        if (np.diff(knots) < 0).any():
            raise GLUError(int(NAMES["GLU_NURBS_ERROR"]), f"{name}: knots must not decrease")
    return spline


def gluNurbsCurve(nurb: Nurbs, *arguments: Any) -> None:
    """gluNurbsCurve(nurb, knotCount, knots, stride, control, order, type), or in PyOpenGL's form
    gluNurbsCurve(nurb, knots, control, type).  Between gluBeginTrim and gluEndTrim it is part of a trimming loop."""
    if len(arguments) == 3:
        knots, control, kind = arguments
        points = np.asarray(control, np.float64)
    else:
        count, knots, stride, control, order, kind = arguments
        knots = np.ravel(knots)[: int(count)]
        n = int(count) - int(order)
        points = np.ravel(control)[np.arange(n)[:, None] * int(stride) + np.arange(_known(CURVES, kind)[1])]
    what, size = _known(CURVES, kind)
    spline = _checked("gluNurbsCurve", Spline([np.ravel(np.asarray(knots, np.float64))], points[:, :size]))
    if what != "trim":
        nurb.maps[what] = spline
        return
    t = np.concatenate([np.linspace(a, b, 12, endpoint=False) for a, b in _pairs(spline.spans(0))])
    values = spline(np.append(t, spline.domain(0)[1]))
    nurb.trims[-1].append(values[:, :2] / values[:, 2:] if size == 3 else values)


def _known(table: dict[int, tuple[str, int]], kind: int) -> tuple[str, int]:
    if kind not in table:
        words = ", ".join(map(repr, list(table)[:3]))
        raise GLUError(int(NAMES["GLU_INVALID_ENUM"]), f"gluNurbs: type must be {words}, ..., not {kind!r}")
    return table[kind]


def _pairs(values: Float) -> list[tuple[float, float]]:
    return list(pairwise(values.tolist()))


def gluPwlCurve(nurb: Nurbs, *arguments: Any) -> None:
    """gluPwlCurve(nurb, count, data, stride, type), or in PyOpenGL's form gluPwlCurve(nurb, data, type): a piece of a
    trimming loop, straight from point to point."""
    if len(arguments) == 2:
        data, kind = arguments
        points = np.asarray(data, np.float64)
    else:
        count, data, stride, kind = arguments
        points = np.ravel(data)[np.arange(int(count))[:, None] * int(stride) + np.arange(_known(CURVES, kind)[1])]
    size = _known(CURVES, kind)[1]
    nurb.trims[-1].append(points[:, :2] / points[:, 2:3] if size == 3 else points[:, :2])


def gluNurbsSurface(nurb: Nurbs, *arguments: Any) -> None:
    """gluNurbsSurface(nurb, sKnotCount, sKnots, tKnotCount, tKnots, sStride, tStride, control, sOrder, tOrder, type),
    or in PyOpenGL's form gluNurbsSurface(nurb, sKnots, tKnots, control, type)."""
    if len(arguments) == 4:
        s_knots, t_knots, control, kind = arguments
        points = np.asarray(control, np.float64)
    else:
        s_count, s_knots, t_count, t_knots, s_stride, t_stride, control, s_order, t_order, kind = arguments
        s_knots, t_knots = np.ravel(s_knots)[: int(s_count)], np.ravel(t_knots)[: int(t_count)]
        i, j = np.arange(int(s_count) - int(s_order)), np.arange(int(t_count) - int(t_order))
        place = i[:, None, None] * int(s_stride) + j[:, None] * int(t_stride) + np.arange(_known(SURFACES, kind)[1])
        points = np.ravel(control)[place]
    what, size = _known(SURFACES, kind)
    knots = [np.ravel(np.asarray(given, np.float64)) for given in (s_knots, t_knots)]
    nurb.maps[what] = _checked("gluNurbsSurface", Spline(knots, np.asarray(points, np.float64)[..., :size]))


# ---------------------------------------------------------------- sampling


def _on_screen(nurb: Nurbs, points: Float) -> Float:
    """Points (n, 3 or 4) in pixels, (n, 2)."""
    from glsim.glu.view import _matrices

    modelview, projection, viewport = nurb.matrices or _matrices(None, None, None)
    homogeneous = np.ones((len(points), 4))
    homogeneous[:, : points.shape[1]] = points
    clip = homogeneous @ modelview @ projection
    with np.errstate(all="ignore"):
        return np.nan_to_num(clip[:, :2] / np.abs(clip[:, 3:]) * viewport[2:] / 2)


def _stops(nurb: Nurbs, spline: Spline, axis: int) -> Float:
    """Where the surface or curve is sampled along one parameter: knots, and between them as many steps as are needed
    for pieces no longer than the sampling tolerance in pixels, or GLU_U_STEP a unit."""
    spans = spline.spans(axis)
    stops = [spans[:1]]
    for low, high in _pairs(spans):
        if nurb.method == NAMES["GLU_DOMAIN_DISTANCE"]:
            steps = int(np.ceil((high - low) * nurb.steps[axis]))
        else:
            t = np.linspace(low, high, 9)
            lines = [t] if len(spline.knots) == 1 else None
            length = 0.0
            others = [np.zeros(0)] if lines else np.linspace(*spline.domain(1 - axis), 5)[:, None]
            for other in others:
                places = [t] if lines else ([t, other + 0 * t] if axis == 0 else [other + 0 * t, t])
                P = _on_screen(nurb, spline(*places))
                length = max(length, float(np.hypot(*np.diff(P, axis=0).T).sum()))
            steps = int(np.ceil(length / nurb.tolerance))
            steps = max(steps, spline.orders[axis] - 1)  # a bent piece is never a single line
        stops.append(np.linspace(low, high, min(max(steps, 1), MOST_STEPS) + 1)[1:])
    return np.concatenate(stops)


def _vertex_call(maps: dict[str, Spline], places: tuple[Float, ...]) -> Callable[[int], None]:
    """A function that gives vertex number n of the samples, with all that the maps say."""
    P = maps["vertex"](*places)
    normals = None
    if "normal" in maps:
        normals = maps["normal"](*places)
    elif len(places) == 2 and gl.glIsEnabled(gl.GL_AUTO_NORMAL):
        du, dv = (maps["vertex"](*places, derive=axis) for axis in (0, 1))
        if P.shape[1] == 4:
            du, dv = (d[:, :3] * P[:, 3:] - P[:, :3] * d[:, 3:] for d in (du, dv))
        N = np.cross(du, dv)
        length = np.linalg.norm(N, axis=1, keepdims=True)
        normals = np.divide(N, length, out=np.zeros_like(N), where=length > 0)
    colors = maps["color"](*places).tolist() if "color" in maps else None
    texcoords = maps["texcoord"](*places).tolist() if "texcoord" in maps else None
    points, normal_list = P.tolist(), None if normals is None else normals.tolist()
    vertex = gl.glVertex4dv if P.shape[1] == 4 else gl.glVertex3dv

    def call(n: int) -> None:
        if colors is not None:
            gl.glColor4dv(colors[n])
        if texcoords is not None:
            gl.glTexCoord(*texcoords[n])
        if normal_list is not None:
            gl.glNormal3dv(normal_list[n])
        vertex(points[n])

    return call


def gluEndCurve(nurb: Nurbs) -> None:
    """Draw the curve."""
    if "vertex" not in nurb.maps:
        return
    t = _stops(nurb, nurb.maps["vertex"], 0)
    vertex = _vertex_call(nurb.maps, (t,))
    gl.glBegin(gl.GL_LINE_STRIP)
    for n in range(len(t)):
        vertex(n)
    gl.glEnd()


def gluEndSurface(nurb: Nurbs) -> None:
    """Draw the surface: filled, as the edges of its polygons, or as the edges of its patches."""
    spline = nurb.maps.get("vertex")
    if spline is None:
        return
    u, v = _stops(nurb, spline, 0), _stops(nurb, spline, 1)
    loops = [np.concatenate(trim) for trim in nurb.trims if trim]
    if nurb.display == NAMES["GLU_OUTLINE_PATCH"]:
        _draw_patches(nurb, spline, u, v)
        return
    gl.glPushAttrib(gl.GL_POLYGON_BIT | gl.GL_CURRENT_BIT)
    if nurb.display == NAMES["GLU_OUTLINE_POLYGON"]:
        gl.glPolygonMode(gl.GL_FRONT_AND_BACK, gl.GL_LINE)
    if loops:
        _draw_trimmed(nurb, u, v, loops)
    else:
        grid = np.meshgrid(u, v, indexing="ij")
        vertex = _vertex_call(nurb.maps, (grid[0].ravel(), grid[1].ravel()))
        for i in range(len(u) - 1):
            gl.glBegin(gl.GL_QUAD_STRIP)
            for j in range(len(v)):
                vertex((i + 1) * len(v) + j)
                vertex(i * len(v) + j)
            gl.glEnd()
    gl.glPopAttrib()


def _draw_patches(nurb: Nurbs, spline: Spline, u: Float, v: Float) -> None:
    for axis, stops in ((0, v), (1, u)):
        for knot in spline.spans(axis):
            places = (np.full_like(stops, knot), stops) if axis == 0 else (stops, np.full_like(stops, knot))
            vertex = _vertex_call(nurb.maps, places)
            gl.glBegin(gl.GL_LINE_STRIP)
            for n in range(len(stops)):
                vertex(n)
            gl.glEnd()


def _draw_trimmed(nurb: Nurbs, u: Float, v: Float, loops: list[Float]) -> None:
    """The cells of the grid, each as far as it is inside of the trimming loops (on their left)."""
    corners: list[tuple[float, float]] = []
    for low, high in _pairs(u):
        for bottom, top in _pairs(v):
            cut = tess.gluNewTess()
            tess.gluTessProperty(cut, NAMES["GLU_TESS_WINDING_RULE"], NAMES["GLU_TESS_WINDING_POSITIVE"])
            tess.gluTessNormal(cut, 0, 0, 1)
            tess.gluTessCallback(cut, NAMES["GLU_TESS_VERTEX"], corners.append)
            tess.gluTessCallback(cut, NAMES["GLU_TESS_COMBINE"], lambda at, data, weights: at[:2])
            tess.gluTessBeginPolygon(cut)
            for loop in loops:
                tess.gluTessBeginContour(cut)
                for x, y in _clipped(loop, low, high, bottom, top):
                    tess.gluTessVertex(cut, (x, y, 0.0), (x, y))
                tess.gluTessEndContour(cut)
            tess.gluTessEndPolygon(cut)
    if not corners:
        return
    places = np.array(corners)
    vertex = _vertex_call(nurb.maps, (places[:, 0], places[:, 1]))
    gl.glBegin(gl.GL_TRIANGLES)
    for k in range(0, len(corners), 3):
        for n in (k, k + 2, k + 1):  # seen like the strips of a whole surface
            vertex(n)
    gl.glEnd()


def _clipped(loop: Float, low: float, high: float, bottom: float, top: float) -> list[tuple[float, float]]:
    """A loop cut to a rectangle (Sutherland and Hodgman)."""
    points = [(float(x), float(y)) for x, y in loop]
    for axis, limit, sign in ((0, low, 1), (0, high, -1), (1, bottom, 1), (1, top, -1)):
        kept: list[tuple[float, float]] = []
        for a, b in zip(points, [*points[1:], *points[:1]], strict=True):
            inside_a, inside_b = sign * (a[axis] - limit) >= 0, sign * (b[axis] - limit) >= 0
            if inside_a:
                kept.append(a)
            if inside_a != inside_b:
                t = (limit - a[axis]) / (b[axis] - a[axis])
                kept.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
        points = kept
    return points
