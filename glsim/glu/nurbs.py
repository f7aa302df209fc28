"""NURBS curves and surfaces: B-splines, rational or not, sampled as finely as the screen shows, with trimming."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu import tess
from glsim.glu.constants import NAMES
from glsim.glu.errors import GLUError, one_of, warn
from glsim.glu.spline import Spline
from glsim.glu.view import matrices

Float = NDArray[np.float64]
MOST_STEPS = 200  # between two knots
MOST_SAMPLES = 1 << 20  # of a curve or surface
MOST_ORDER = 8
TRIM_STEPS = 12  # of a trimming curve between two knots
CALLBACKS = ("ERROR", "BEGIN", "VERTEX", "NORMAL", "COLOR", "TEXTURE_COORD", "END")
TOLERANCE, DISPLAY_MODE, SAMPLING_METHOD, U_STEP, V_STEP, AUTO_LOAD_MATRIX, CULLING, PARAMETRIC_TOLERANCE, MODE = (
    NAMES[f"GLU_{name}"]
    for name in (
        "SAMPLING_TOLERANCE", "DISPLAY_MODE", "SAMPLING_METHOD", "U_STEP", "V_STEP", "AUTO_LOAD_MATRIX", "CULLING",
        "PARAMETRIC_TOLERANCE", "NURBS_MODE",
    )
)  # fmt: skip
RENDERER = NAMES["GLU_NURBS_RENDERER"]
OBJECT_METHODS: tuple[int, ...] = (NAMES["GLU_OBJECT_PATH_LENGTH"], NAMES["GLU_OBJECT_PARAMETRIC_ERROR"])
CHOICES: dict[int, tuple[int, ...]] = {
    DISPLAY_MODE: (NAMES["GLU_FILL"], NAMES["GLU_OUTLINE_POLYGON"], NAMES["GLU_OUTLINE_PATCH"]),
    SAMPLING_METHOD: (
        NAMES["GLU_PATH_LENGTH"], NAMES["GLU_PARAMETRIC_ERROR"], NAMES["GLU_DOMAIN_DISTANCE"], *OBJECT_METHODS,
    ),
    MODE: (RENDERER, NAMES["GLU_NURBS_TESSELLATOR"]),
}  # fmt: skip
# what a map gives -> components, the command that takes them
CURVES: dict[int, tuple[str, int]] = {
    gl.GL_MAP1_VERTEX_3: ("vertex", 3), gl.GL_MAP1_VERTEX_4: ("vertex", 4), gl.GL_MAP1_NORMAL: ("normal", 3),
    gl.GL_MAP1_COLOR_4: ("color", 4), gl.GL_MAP1_TEXTURE_COORD_1: ("texcoord", 1),
    gl.GL_MAP1_TEXTURE_COORD_2: ("texcoord", 2), gl.GL_MAP1_TEXTURE_COORD_3: ("texcoord", 3),
    gl.GL_MAP1_TEXTURE_COORD_4: ("texcoord", 4), NAMES["GLU_MAP1_TRIM_2"]: ("trim", 2),
    NAMES["GLU_MAP1_TRIM_3"]: ("trim", 3),
}  # fmt: skip
TRIMS = {kind: found for kind, found in CURVES.items() if found[0] == "trim"}
SURFACES: dict[int, tuple[str, int]] = {
    gl.GL_MAP2_VERTEX_3: ("vertex", 3), gl.GL_MAP2_VERTEX_4: ("vertex", 4), gl.GL_MAP2_NORMAL: ("normal", 3),
    gl.GL_MAP2_COLOR_4: ("color", 4), gl.GL_MAP2_TEXTURE_COORD_1: ("texcoord", 1),
    gl.GL_MAP2_TEXTURE_COORD_2: ("texcoord", 2), gl.GL_MAP2_TEXTURE_COORD_3: ("texcoord", 3),
    gl.GL_MAP2_TEXTURE_COORD_4: ("texcoord", 4),
}  # fmt: skip


class Nurbs:
    """gluNewNurbsRenderer: properties, and what is being described between Begin and End."""

    def __init__(self) -> None:
        self.properties: dict[int, float] = {
            TOLERANCE: 50.0, DISPLAY_MODE: NAMES["GLU_FILL"], SAMPLING_METHOD: NAMES["GLU_PATH_LENGTH"], U_STEP: 100.0,
            V_STEP: 100.0, AUTO_LOAD_MATRIX: 1.0, CULLING: 0.0, PARAMETRIC_TOLERANCE: 0.5, MODE: RENDERER,
        }  # fmt: skip
        self.begun = ""  # "Curve" or "Surface"
        self.maps: dict[str, Spline] = {}
        self.trims: list[list[Float]] = []
        self.trimming = False
        self.matrices: tuple[Float, Float, Float] | None = None
        self.callbacks: dict[str, tuple[Callable[..., Any], bool]] = {}  # name -> function, whether it wants the data
        self.data: Any = None

    def fail(self, error: str | int, sentence: str) -> None:
        """Call the error callback, or issue a GLUWarning.  error: name of the code, or k of GLU_NURBS_ERRORk."""
        code = NAMES[error if isinstance(error, str) else f"GLU_NURBS_ERROR{error}"]
        if "ERROR" not in self.callbacks:
            warn(code, sentence)
        else:
            self.callbacks["ERROR"][0](code)

    def call(self, name: str, *arguments: Any) -> None:
        if name in self.callbacks:
            function, wants_data = self.callbacks[name]
            function(*arguments, *((self.data,) if wants_data else ()))


def gluNewNurbsRenderer() -> Nurbs:
    """A new object for the gluNurbs... functions, with the initial properties."""
    return Nurbs()


def gluDeleteNurbsRenderer(nurb: Nurbs) -> None:
    """Accepted without effect: Python frees the object."""


def gluNurbsCallback(nurb: Nurbs, which: int, CallBackFunc: Callable[..., Any] | None) -> None:
    """Set a callback: GLU_NURBS_ERROR, or one that gets the vertices in mode GLU_NURBS_TESSELLATOR; None: remove it."""
    for name in CALLBACKS:
        for wants_data in (False, True) if name != "ERROR" else (False,):
            if which == NAMES[f"GLU_NURBS_{name}{'_DATA' if wants_data else ''}"]:
                if CallBackFunc is None:
                    nurb.callbacks.pop(name, None)
                else:
                    nurb.callbacks[name] = CallBackFunc, wants_data
                return
    nurb.fail("GLU_INVALID_ENUM", f"gluNurbsCallback: which must be GLU_NURBS_ERROR or another callback, not {which!r}")


def gluNurbsCallbackData(nurb: Nurbs, userData: Any) -> None:
    """What the callbacks whose names end in _DATA get."""
    nurb.data = userData


gluNurbsCallbackDataEXT = gluNurbsCallbackData


def gluNurbsProperty(nurb: Nurbs, property: int, value: float) -> None:
    """Lengths of GLU_SAMPLING_TOLERANCE and GLU_PARAMETRIC_TOLERANCE are in pixels, for the methods GLU_OBJECT_... in
    object coordinates; GLU_U_STEP and GLU_V_STEP are samples per unit of the parameter."""
    choices = CHOICES.get(property)
    if property not in nurb.properties:
        sentence = f"gluNurbsProperty: property must be {one_of(nurb.properties)}, not {property!r}"
        nurb.fail("GLU_INVALID_ENUM", sentence)
    elif choices is not None and value not in choices:
        nurb.fail("GLU_INVALID_VALUE", f"gluNurbsProperty: value must be {one_of(choices)}, not {value!r}")
    elif property not in (TOLERANCE, PARAMETRIC_TOLERANCE, U_STEP, V_STEP) or value > 0:
        nurb.properties[property] = float(value)


def gluGetNurbsProperty(nurb: Nurbs, property: int, data: Any = None) -> Any:
    """The value, also in ``data``, an array of one number, if given."""
    if property not in nurb.properties:
        sentence = f"gluGetNurbsProperty: property must be {one_of(nurb.properties)}, not {property!r}"
        nurb.fail("GLU_INVALID_ENUM", sentence)
        return None
    value = float(nurb.properties[property])
    if data is None:
        return value
    data[0] = value
    return None


def gluLoadSamplingMatrices(nurb: Nurbs, model: Any, perspective: Any, view: Any) -> None:
    """The matrices by which sampling measures pixels, for GLU_AUTO_LOAD_MATRIX off."""
    m, p = (np.asarray(given, np.float64).reshape(4, 4) for given in (model, perspective))
    nurb.matrices = m, p, np.asarray(view, np.float64).reshape(4)


# ---------------------------------------------------------------- description


def gluBeginCurve(nurb: Nurbs) -> None:
    """Begin a NURBS curve: gluNurbsCurve describes it, gluEndCurve draws it."""
    if nurb.begun == "Curve":
        nurb.fail(6, "gluBeginCurve: gluEndCurve must come first")
    nurb.begun, nurb.maps = "Curve", {}


def gluBeginSurface(nurb: Nurbs) -> None:
    """Begin a NURBS surface: gluNurbsSurface describes it, gluEndSurface draws it."""
    if nurb.begun == "Surface":
        nurb.fail(27, "gluBeginSurface: gluEndSurface must come first")
    nurb.begun, nurb.maps, nurb.trims = "Surface", {}, []


def gluBeginTrim(nurb: Nurbs) -> None:
    """Begin a closed loop of trimming curves in the surface's (u, v); the part on the left of the loop stays."""
    if nurb.begun != "Surface":
        nurb.fail(15, "gluBeginTrim: gluBeginSurface must come first")
        return
    nurb.trimming = True
    nurb.trims.append([])


def gluEndTrim(nurb: Nurbs) -> None:
    """End the trimming loop that gluBeginTrim began."""
    if not nurb.trimming:
        nurb.fail(17, "gluEndTrim: gluBeginTrim must come first")
    nurb.trimming = False


def _spline(nurb: Nurbs, name: str, knots: list[Any], control: Any, size: int) -> Spline | None:
    """What a command describes; None after an error.  control: (n, k) or (n, m, k)."""
    arrays = [np.ravel(np.asarray(given, np.float64)) for given in knots]
    points = np.asarray(control, np.float64)
    if points.ndim != len(arrays) + 1 or points.shape[-1] < size:
        raise GLUError(
            NAMES["GLU_INVALID_VALUE"],
            f"{name}: control must be an array of {len(arrays) + 1} dimensions, {size} numbers a point,"
            f" not of shape {points.shape}",
        )
    spline = Spline(arrays, points[..., :size])
    for order, t in zip(spline.orders, arrays, strict=True):
        if not 2 <= order <= MOST_ORDER:
            sentence = f"{name}: the order, knots minus control points, must be from 2 to {MOST_ORDER}, not {order}"
            nurb.fail(1, sentence)
        elif len(t) < 2 * order:
            nurb.fail(2, f"{name}: order {order} needs at least {2 * order} knots, not {len(t)}")
        elif (np.diff(t) < 0).any():
            nurb.fail(4, f"{name}: knots must not decrease")
        elif t[order - 1] >= t[len(t) - order]:
            nurb.fail(3, f"{name}: the range of the knots is empty")
        else:
            continue
        return None
    return spline


def gluNurbsCurve(nurb: Nurbs, *arguments: Any) -> None:
    """gluNurbsCurve(nurb, knotCount, knots, stride, control, order, type), or in PyOpenGL's form
    gluNurbsCurve(nurb, knots, control, type).  Between gluBeginTrim and gluEndTrim it is part of a trimming loop."""
    what, size = _known(nurb, "gluNurbsCurve", CURVES, arguments[-1])
    if not size:
        return
    if len(arguments) == 3:
        knots, control, _ = arguments
    else:
        count, knots, stride, control, order, _ = arguments
        knots = np.ravel(knots)[: int(count)]
        control = np.ravel(control)[np.arange(int(count) - int(order))[:, None] * int(stride) + np.arange(size)]
    spline = _spline(nurb, "gluNurbsCurve", [knots], control, size)
    if spline is None:
        return
    if what != "trim":
        nurb.maps[what] = spline
    elif not nurb.trimming:
        nurb.fail(18, "gluNurbsCurve: gluBeginTrim must come first")
    else:
        t = np.concatenate([np.linspace(a, b, TRIM_STEPS, endpoint=False) for a, b in pairwise(spline.spans(0))])
        values = spline(np.append(t, spline.domain(0)[1]))
        nurb.trims[-1].append(values[:, :2] / values[:, 2:] if size == 3 else values)


def _known(nurb: Nurbs, name: str, table: dict[int, tuple[str, int]], kind: int) -> tuple[str, int]:
    """What a map gives, and how many numbers; 0 after an error."""
    if kind not in table:
        nurb.fail(35, f"{name}: type must be {one_of(table)}, not {kind!r}")
        return "", 0
    return table[kind]


def gluPwlCurve(nurb: Nurbs, *arguments: Any) -> None:
    """gluPwlCurve(nurb, count, data, stride, type), or in PyOpenGL's form gluPwlCurve(nurb, data, type): a piece of a
    trimming loop, straight from point to point."""
    size = _known(nurb, "gluPwlCurve", TRIMS, arguments[-1])[1]
    if not size:
        return
    if not nurb.trimming:
        nurb.fail(19, "gluPwlCurve: gluBeginTrim must come first")
        return
    if len(arguments) == 2:
        points = np.asarray(arguments[0], np.float64).reshape(-1, size)
    else:
        count, data, stride, _ = arguments
        points = np.ravel(data)[np.arange(int(count))[:, None] * int(stride) + np.arange(size)].astype(np.float64)
    nurb.trims[-1].append(points[:, :2] / points[:, 2:] if size == 3 else points)


def gluNurbsSurface(nurb: Nurbs, *arguments: Any) -> None:
    """gluNurbsSurface(nurb, sKnotCount, sKnots, tKnotCount, tKnots, sStride, tStride, control, sOrder, tOrder, type),
    or in PyOpenGL's form gluNurbsSurface(nurb, sKnots, tKnots, control, type)."""
    what, size = _known(nurb, "gluNurbsSurface", SURFACES, arguments[-1])
    if not size:
        return
    if len(arguments) == 4:
        s_knots, t_knots, control, _ = arguments
    else:
        s_count, s_knots, t_count, t_knots, s_stride, t_stride, control, s_order, t_order, _ = arguments
        s_knots, t_knots = np.ravel(s_knots)[: int(s_count)], np.ravel(t_knots)[: int(t_count)]
        i, j = np.arange(int(s_count) - int(s_order)), np.arange(int(t_count) - int(t_order))
        control = np.ravel(control)[i[:, None, None] * int(s_stride) + j[:, None] * int(t_stride) + np.arange(size)]
    spline = _spline(nurb, "gluNurbsSurface", [s_knots, t_knots], control, size)
    if spline is not None:
        nurb.maps[what] = spline


# ---------------------------------------------------------------- sampling


def _measured(nurb: Nurbs, points: Float) -> Float:
    """Points (..., 3 or 4) in the units of the sampling method: pixels, or object coordinates."""
    homogeneous = np.ones((*points.shape[:-1], 4))
    homogeneous[..., : points.shape[-1]] = points
    if nurb.properties[SAMPLING_METHOD] in OBJECT_METHODS:
        return homogeneous[..., :3] / homogeneous[..., 3:]
    own = nurb.matrices if nurb.properties[AUTO_LOAD_MATRIX] == 0.0 else None
    modelview, projection, viewport = own or matrices(None, None, None)
    clip = homogeneous @ modelview @ projection
    with np.errstate(all="ignore"):
        return np.nan_to_num(clip[..., :2] / np.abs(clip[..., 3:]) * viewport[2:] / 2, posinf=1e9, neginf=-1e9)


def _patches(spline: Spline) -> Float:
    """The Bezier control points of each patch: (spans, order, k), or (u spans, u order, v spans, v order, k)."""
    places, inverses, shape = [], [], []
    for axis, order in enumerate(spline.orders):
        t = (np.arange(order) + 0.5) / order  # inside the spans, where each is one polynomial
        spans = spline.spans(axis)
        places.append((spans[:-1, None] + t * np.diff(spans)[:, None]).ravel())
        shape += [len(spans) - 1, order]
        bernstein = [math.comb(order - 1, k) * t**k * (1 - t) ** (order - 1 - k) for k in range(order)]
        inverses.append(np.linalg.inv(np.stack(bernstein, axis=1)))
    if len(places) == 1:
        return np.asarray(np.einsum("ab,sbk->sak", inverses[0], spline(*places).reshape(*shape, -1)))
    grid = np.meshgrid(*places, indexing="ij")
    values = spline(grid[0].ravel(), grid[1].ravel()).reshape(*shape, -1)
    return np.asarray(np.einsum("ab,cd,sbtdk->satck", *inverses, values))


def _fastest(points: Float, axis: int, *axes: int) -> Float:
    """The largest derivative by the parameters of ``axes`` over each span of ``axis``, in units of a span.

    A Bezier curve of degree d changes no faster than d times the differences of its control points.
    """
    for each in axes:
        points = np.diff(points, axis=2 * each + 1) * (points.shape[2 * each + 1] - 1)
    lengths = np.linalg.norm(points, axis=-1)
    others = tuple(k for k in range(lengths.ndim) if k != 2 * axis)
    return np.asarray(lengths.max(axis=others, initial=0.0))


def _counts(nurb: Nurbs, spline: Spline, axis: int) -> NDArray[np.int64]:
    """How many steps each span of a parameter needs, by the sampling method."""
    method, surface = nurb.properties[SAMPLING_METHOD], len(spline.knots) == 2
    if method == NAMES["GLU_DOMAIN_DISTANCE"]:
        steps = np.diff(spline.spans(axis)) * nurb.properties[V_STEP if axis else U_STEP]
        return np.minimum(np.ceil(steps) if surface else np.floor(steps) + 1, MOST_SAMPLES).astype(np.int64)
    points = _measured(nurb, _patches(spline))
    if method in (NAMES["GLU_PATH_LENGTH"], NAMES["GLU_OBJECT_PATH_LENGTH"]):
        # on a surface a step is half as long as the tolerance
        steps = _fastest(points, axis, axis) * (2 if surface else 1) / nurb.properties[TOLERANCE]
    else:  # a chord of length h leaves a curve by at most h^2 / 8 times its second derivative
        bend = _fastest(points, axis, axis, axis)
        if surface:
            bend += 2 * _fastest(points, axis, 0, 1) + _fastest(points, axis, 1 - axis, 1 - axis)
        steps = np.sqrt(bend / (8 * nurb.properties[PARAMETRIC_TOLERANCE]))
    more = 1 if surface and axis == 0 else 0  # so has the sample implementation
    return np.asarray(np.clip(np.ceil(steps * (1 - 1e-9)) + more, 1, MOST_STEPS).astype(np.int64))


def _stops(nurb: Nurbs, spline: Spline, name: str) -> list[Float]:
    """Where a curve or surface is sampled along each parameter: at knots, and between them as often as is needed; empty
    after an error."""
    counts = [np.clip(_counts(nurb, spline, axis), 1, None) for axis in range(len(spline.knots))]
    samples = math.prod(int(count.sum()) + 1 for count in counts)
    if samples > MOST_SAMPLES:
        sentence = f"{name}: this sampling makes {samples} vertices, more than {MOST_SAMPLES}; take a larger tolerance,"
        nurb.fail("GLU_OUT_OF_MEMORY", f"{sentence} or smaller GLU_U_STEP and GLU_V_STEP")
        return []
    stops = []
    for axis, count in enumerate(counts):
        spans = spline.spans(axis)
        pieces = [np.linspace(*ends, n, endpoint=False) for ends, n in zip(pairwise(spans), count, strict=True)]
        stops.append(np.concatenate([*pieces, spans[-1:]]))
    return stops


# ---------------------------------------------------------------- drawing


class _Output:
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


def gluEndCurve(nurb: Nurbs) -> None:
    """Draw the curve."""
    if nurb.begun != "Curve":
        nurb.fail(7, "gluEndCurve: gluBeginCurve must come first")
        return
    nurb.begun = ""
    if "vertex" not in nurb.maps:
        nurb.fail(8, "gluEndCurve: gluNurbsCurve with GL_MAP1_VERTEX_3 or GL_MAP1_VERTEX_4 must come first")
        return
    stops = _stops(nurb, nurb.maps["vertex"], "gluEndCurve")
    if not stops:
        return
    (t,) = stops
    gl.glPushAttrib(gl.GL_CURRENT_BIT)
    _Output(nurb, t).draw(gl.GL_LINE_STRIP, range(len(t)))
    gl.glPopAttrib()


def gluEndSurface(nurb: Nurbs) -> None:
    """Draw the surface: filled, as the edges of its polygons, or as the edges of its patches."""
    if nurb.begun != "Surface":
        nurb.fail(13, "gluEndSurface: gluBeginSurface must come first")
        return
    nurb.begun = ""
    spline = nurb.maps.get("vertex")
    if spline is None:
        return
    stops = _stops(nurb, spline, "gluEndSurface")
    if not stops:
        return
    u, v = stops
    loops = [np.concatenate(trim) for trim in nurb.trims if trim]
    mode = nurb.properties[DISPLAY_MODE]
    gl.glPushAttrib(gl.GL_POLYGON_BIT | gl.GL_CURRENT_BIT)
    if mode == NAMES["GLU_OUTLINE_PATCH"]:
        _draw_patches(nurb, spline, u, v, loops)
    else:
        gl.glPolygonMode(gl.GL_FRONT_AND_BACK, gl.GL_FILL if mode == NAMES["GLU_FILL"] else gl.GL_LINE)
        _draw_cells(nurb, u, v, loops)
    gl.glPopAttrib()


def _draw_cells(nurb: Nurbs, u: Float, v: Float, loops: list[Float]) -> None:
    """The cells of the grid, counterclockwise seen from where u x v points."""
    whole, cut = np.ones((len(u) - 1, len(v) - 1), bool), np.zeros((len(u) - 1, len(v) - 1), bool)
    if loops:
        whole, cut = _inside(u, v, loops)
    places = np.meshgrid(u, v, indexing="ij")
    grid = _Output(nurb, places[0].ravel(), places[1].ravel())
    for i, row in enumerate(whole):
        below, above = i * len(v), (i + 1) * len(v)
        edges = np.flatnonzero(np.diff(row.astype(np.int8), prepend=0, append=0)).tolist()
        for first, last in zip(edges[::2], edges[1::2], strict=True):
            strip = [n + j for j in range(first, last + 1) for n in (below, above)]
            grid.draw(gl.GL_QUAD_STRIP, strip)
    corners: list[tuple[float, float]] = []
    for i, j in np.argwhere(cut).tolist():
        corners += _trimmed([_clipped(loop, u[i], u[i + 1], v[j], v[j + 1]) for loop in loops])
    if corners:
        at = np.array(corners)
        _Output(nurb, at[:, 0], at[:, 1]).draw(gl.GL_TRIANGLES, range(len(at)))


def _inside(u: Float, v: Float, loops: list[Float]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which cells of the grid lie inside the trimming loops (on their left), and which may be cut by them."""
    winding = np.zeros((len(u) - 1, len(v) - 1), np.int64)
    cut = np.zeros_like(winding, bool)
    x, y = ((u[:-1] + u[1:]) / 2)[:, None], ((v[:-1] + v[1:]) / 2)[None]
    for loop in loops:
        for (x0, y0), (x1, y1) in zip(loop, np.roll(loop, -1, axis=0), strict=True):
            left = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) > 0
            winding += (y0 <= y) & (y < y1) & left
            winding -= (y1 <= y) & (y < y0) & ~left
            near_u = (u[:-1] < max(x0, x1)) & (u[1:] > min(x0, x1))
            near_v = (v[:-1] < max(y0, y1)) & (v[1:] > min(y0, y1))
            cut |= near_u[:, None] & near_v[None]
    return (winding > 0) & ~cut, cut


def _trimmed(loops: list[list[tuple[float, float]]]) -> list[tuple[float, float]]:
    """The corners of triangles that fill loops."""
    corners: list[tuple[float, float]] = []
    cutter = tess.gluNewTess()
    tess.gluTessProperty(cutter, NAMES["GLU_TESS_WINDING_RULE"], NAMES["GLU_TESS_WINDING_POSITIVE"])
    tess.gluTessNormal(cutter, 0, 0, 1)
    tess.gluTessCallback(cutter, NAMES["GLU_TESS_VERTEX"], corners.append)
    tess.gluTessCallback(cutter, NAMES["GLU_TESS_COMBINE"], lambda at, data, weights: (at[0], at[1]))
    tess.gluTessBeginPolygon(cutter)
    for loop in loops:
        tess.gluTessBeginContour(cutter)
        for x, y in loop:
            tess.gluTessVertex(cutter, (x, y, 0.0), (x, y))
        tess.gluTessEndContour(cutter)
    tess.gluTessEndPolygon(cutter)
    return corners


def _draw_patches(nurb: Nurbs, spline: Spline, u: Float, v: Float, loops: list[Float]) -> None:
    """The edges of the patches; of a trimmed surface the trimming loops, and the edges between patches inside them."""
    for loop in loops:
        ring = np.concatenate([loop, loop[:1]])
        _Output(nurb, ring[:, 0], ring[:, 1]).draw(gl.GL_LINE_STRIP, range(len(ring)))
    for axis, stops in ((0, v), (1, u)):
        for knot in spline.spans(axis)[1:-1] if loops else spline.spans(axis):
            places = (np.full_like(stops, knot), stops) if axis == 0 else (stops, np.full_like(stops, knot))
            output = _Output(nurb, *places)
            for k in range(len(stops) - 1):
                if not loops or _holds(loops, *((place[k] + place[k + 1]) / 2 for place in places)):
                    output.draw(gl.GL_LINES, (k, k + 1))


def _holds(loops: list[Float], x: float, y: float) -> bool:
    """Whether a point lies inside the trimming loops."""
    return bool(_inside(np.array([x, x]), np.array([y, y]), loops)[0].any())


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
