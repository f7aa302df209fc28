"""NURBS curves and surfaces: B-splines, rational or not, sampled as finely as the screen shows, with trimming."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

from glsim import gl
from glsim.glu.constants import NAMES
from glsim.glu.errors import GLUError, one_of
from glsim.glu.nurbsdraw import Output, draw_cells, draw_patches
from glsim.glu.nurbsobject import (
    CHOICES,
    DISPLAY_MODE,
    PARAMETRIC_TOLERANCE,
    TOLERANCE,
    U_STEP,
    V_STEP,
    Nurbs,
)
from glsim.glu.sampling import stops_of
from glsim.glu.spline import Spline

MOST_ORDER = 8
TRIM_STEPS = 12  # of a trimming curve between two knots
CALLBACKS = ("ERROR", "BEGIN", "VERTEX", "NORMAL", "COLOR", "TEXTURE_COORD", "END")
# what a map gives -> components, the command that takes them
CURVES: dict[int, tuple[str, int]] = {
    gl.GL_MAP1_VERTEX_3: ("vertex", 3), gl.GL_MAP1_VERTEX_4: ("vertex", 4), gl.GL_MAP1_NORMAL: ("normal", 3),
    gl.GL_MAP1_COLOR_4: ("color", 4), gl.GL_MAP1_TEXTURE_COORD_1: ("texcoord", 1),
    gl.GL_MAP1_TEXTURE_COORD_2: ("texcoord", 2), gl.GL_MAP1_TEXTURE_COORD_3: ("texcoord", 3),
    gl.GL_MAP1_TEXTURE_COORD_4: ("texcoord", 4), NAMES["GLU_MAP1_TRIM_2"]: ("trim", 2),
    NAMES["GLU_MAP1_TRIM_3"]: ("trim", 3),
}  # fmt: skip
TRIMS = {kind: entry for kind, entry in CURVES.items() if entry[0] == "trim"}
SURFACES: dict[int, tuple[str, int]] = {
    gl.GL_MAP2_VERTEX_3: ("vertex", 3), gl.GL_MAP2_VERTEX_4: ("vertex", 4), gl.GL_MAP2_NORMAL: ("normal", 3),
    gl.GL_MAP2_COLOR_4: ("color", 4), gl.GL_MAP2_TEXTURE_COORD_1: ("texcoord", 1),
    gl.GL_MAP2_TEXTURE_COORD_2: ("texcoord", 2), gl.GL_MAP2_TEXTURE_COORD_3: ("texcoord", 3),
    gl.GL_MAP2_TEXTURE_COORD_4: ("texcoord", 4),
}  # fmt: skip


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
    what, size = _map_of(nurb, "gluNurbsCurve", CURVES, arguments[-1])
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


def _map_of(nurb: Nurbs, name: str, table: dict[int, tuple[str, int]], kind: int) -> tuple[str, int]:
    """What a map gives, and how many numbers; 0 after an error."""
    if kind not in table:
        nurb.fail(35, f"{name}: type must be {one_of(table)}, not {kind!r}")
        return "", 0
    return table[kind]


def gluPwlCurve(nurb: Nurbs, *arguments: Any) -> None:
    """gluPwlCurve(nurb, count, data, stride, type), or in PyOpenGL's form gluPwlCurve(nurb, data, type): a piece of a
    trimming loop, straight from point to point."""
    size = _map_of(nurb, "gluPwlCurve", TRIMS, arguments[-1])[1]
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
    what, size = _map_of(nurb, "gluNurbsSurface", SURFACES, arguments[-1])
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


# ---------------------------------------------------------------- drawing


def gluEndCurve(nurb: Nurbs) -> None:
    """Draw the curve."""
    if nurb.begun != "Curve":
        nurb.fail(7, "gluEndCurve: gluBeginCurve must come first")
        return
    nurb.begun = ""
    if "vertex" not in nurb.maps:
        nurb.fail(8, "gluEndCurve: gluNurbsCurve with GL_MAP1_VERTEX_3 or GL_MAP1_VERTEX_4 must come first")
        return
    stops = stops_of(nurb, nurb.maps["vertex"], "gluEndCurve")
    if not stops:
        return
    (t,) = stops
    gl.glPushAttrib(gl.GL_CURRENT_BIT)
    Output(nurb, t).draw(gl.GL_LINE_STRIP, range(len(t)))
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
    stops = stops_of(nurb, spline, "gluEndSurface")
    if not stops:
        return
    u, v = stops
    loops = [np.concatenate(trim) for trim in nurb.trims if trim]
    mode = nurb.properties[DISPLAY_MODE]
    gl.glPushAttrib(gl.GL_POLYGON_BIT | gl.GL_CURRENT_BIT)
    if mode == NAMES["GLU_OUTLINE_PATCH"]:
        draw_patches(nurb, spline, u, v, loops)
    else:
        gl.glPolygonMode(gl.GL_FRONT_AND_BACK, gl.GL_FILL if mode == NAMES["GLU_FILL"] else gl.GL_LINE)
        draw_cells(nurb, u, v, loops)
    gl.glPopAttrib()
