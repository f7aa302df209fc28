"""Where NURBS are sampled: as finely as the sampling method of gluNurbsProperty asks for."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from glsim.glu.constants import NAMES
from glsim.glu.nurbsobject import (
    AUTO_LOAD_MATRIX,
    OBJECT_METHODS,
    PARAMETRIC_TOLERANCE,
    SAMPLING_METHOD,
    TOLERANCE,
    U_STEP,
    V_STEP,
    Nurbs,
)
from glsim.glu.spline import Spline
from glsim.glu.view import matrices

Float = NDArray[np.float64]
MOST_STEPS = 200  # between two knots
MOST_SAMPLES = 1 << 20  # of a curve or surface


def measured(nurb: Nurbs, points: Float) -> Float:
    """Points (..., 3 or 4) in the units of the sampling method: pixels, or object coordinates."""
    homogeneous = np.ones((*points.shape[:-1], 4))
    homogeneous[..., : points.shape[-1]] = points
    if nurb.properties[SAMPLING_METHOD] in OBJECT_METHODS:
        return homogeneous[..., :3] / homogeneous[..., 3:]
    loaded = nurb.matrices if nurb.properties[AUTO_LOAD_MATRIX] == 0.0 else None
    modelview, projection, viewport = loaded or matrices(None, None, None)
    clip = homogeneous @ modelview @ projection
    with np.errstate(all="ignore"):
        return np.nan_to_num(clip[..., :2] / np.abs(clip[..., 3:]) * viewport[2:] / 2, posinf=1e9, neginf=-1e9)


def bezier_patches(spline: Spline) -> Float:
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


def largest_derivative(points: Float, axis: int, *axes: int) -> Float:
    """The largest derivative by the parameters of ``axes`` over each span of ``axis``, in units of a span.

    A Bezier curve of degree d changes no faster than d times the differences of its control points.
    """
    for by in axes:
        points = np.diff(points, axis=2 * by + 1) * (points.shape[2 * by + 1] - 1)
    lengths = np.linalg.norm(points, axis=-1)
    others = tuple(k for k in range(lengths.ndim) if k != 2 * axis)
    return np.asarray(lengths.max(axis=others, initial=0.0))


def step_counts(nurb: Nurbs, spline: Spline, axis: int) -> NDArray[np.int64]:
    """How many steps each span of a parameter needs, by the sampling method."""
    method, surface = nurb.properties[SAMPLING_METHOD], len(spline.knots) == 2
    if method == NAMES["GLU_DOMAIN_DISTANCE"]:
        steps = np.diff(spline.spans(axis)) * nurb.properties[V_STEP if axis else U_STEP]
        return np.minimum(np.ceil(steps) if surface else np.floor(steps) + 1, MOST_SAMPLES).astype(np.int64)
    points = measured(nurb, bezier_patches(spline))
    if method in (NAMES["GLU_PATH_LENGTH"], NAMES["GLU_OBJECT_PATH_LENGTH"]):
        # on a surface a step is half as long as the tolerance
        steps = largest_derivative(points, axis, axis) * (2 if surface else 1) / nurb.properties[TOLERANCE]
    else:  # a chord of length h leaves a curve by at most h^2 / 8 times its second derivative
        bend = largest_derivative(points, axis, axis, axis)
        if surface:
            bend += 2 * largest_derivative(points, axis, 0, 1) + largest_derivative(points, axis, 1 - axis, 1 - axis)
        steps = np.sqrt(bend / (8 * nurb.properties[PARAMETRIC_TOLERANCE]))
    extra = 1 if surface and axis == 0 else 0  # so has the sample implementation
    return np.asarray(np.clip(np.ceil(steps * (1 - 1e-9)) + extra, 1, MOST_STEPS).astype(np.int64))


def stops_of(nurb: Nurbs, spline: Spline, name: str) -> list[Float]:
    """Where a curve or surface is sampled along each parameter: at knots, and between them as often as is needed; empty
    after an error."""
    counts = [np.clip(step_counts(nurb, spline, axis), 1, None) for axis in range(len(spline.knots))]
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
