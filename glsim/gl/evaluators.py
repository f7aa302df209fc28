"""Evaluators: section 5.1 of the specification.  Bezier curves and surfaces made of control points."""

from __future__ import annotations

from math import comb
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.gl.arguments import numbers
from glsim.machine import constants as gl
from glsim.machine.cache import cached
from glsim.machine.errors import invalid_enum, invalid_operation, invalid_value
from glsim.machine.frame import ROW, ROW_BYTES
from glsim.machine.machine import Machine
from glsim.machine.types import plain

Float = NDArray[np.float64]
MAX_EVAL_ORDER = 30
# the nine maps from GL_MAP1_COLOR_4 and from GL_MAP2_COLOR_4 on: what they give, and how many numbers
COLOR, INDEX, NORMAL, TEXTURE_1, TEXTURE_2, TEXTURE_3, TEXTURE_4, VERTEX_3, VERTEX_4 = range(9)
COMPONENTS = (4, 1, 3, 1, 2, 3, 4, 3, 4)


Vertices = tuple[NDArray[np.float32], dict[str, NDArray[np.float32]]]  # rows and columns


class Map(NamedTuple):
    """Control points (order, k) or (order u, order v, k), and the domain (u1, u2) or (u1, u2, v1, v2)."""

    points: Float
    domain: tuple[float, ...]


def _map_number(target: int, dimensions: int) -> int:
    what = int(target) - (gl.GL_MAP1_COLOR_4 if dimensions == 1 else gl.GL_MAP2_COLOR_4)
    if not 0 <= what < 9:
        raise invalid_enum("target", target, f"a map such as GL_MAP{dimensions}_VERTEX_3")
    return what


def _check(names: str, low: float, high: float, stride: int, order: int, components: int) -> None:
    if low == high:
        raise invalid_value(names, (low, high), "two different numbers")
    if stride < components:
        raise invalid_value("stride", stride, f"at least {components}")
    if not 1 <= order <= MAX_EVAL_ORDER:
        raise invalid_value("order", order, f"from 1 to {MAX_EVAL_ORDER}")


def _check_unit(m: Machine) -> None:
    if m.texture.active_unit:
        raise invalid_operation(f"maps belong to GL_TEXTURE0, but GL_TEXTURE{m.texture.active_unit} is active")


def _taken(points: Any, index: NDArray[np.int64]) -> Float:
    """Control points out of the program's array of numbers."""
    flat = np.asarray(numbers(plain(points, int(index.max()) + 1)))
    if index.max() >= flat.size:
        raise ValueError(f"points has {flat.size} numbers, but the map needs {int(index.max()) + 1}")
    return flat[index]


def _shaped(points: Any) -> Float:
    numbers(points)  # or a sentence
    return np.asarray(points, np.float64)


def glMap1f(m: Machine, target: int, u1: float, u2: float, stride: Any, order: Any = None, points: Any = None) -> None:
    """glMap1f(target, u1, u2, stride, order, points), or in PyOpenGL's form glMap1f(target, u1, u2, points).

    points: (order, k) numbers.
    """
    what = _map_number(target, 1)
    k = COMPONENTS[what]
    if points is None:
        points = _shaped(stride)
        if points.ndim != 2:
            raise ValueError(f"points must have the shape (order, {k}), not {points.shape}")
        order, stride = points.shape
    _check("u1 and u2", u1, u2, stride, order, k)
    _check_unit(m)
    index = np.arange(order)[:, None] * int(stride) + np.arange(k)
    m.objects.maps[target] = Map(_taken(points, index), (float(u1), float(u2)))


glMap1d = glMap1f  # noqa: N816


def glMap2f(
    m: Machine, target: int, u1: float, u2: float, ustride: Any, uorder: Any, v1: Any, v2: Any = None,
    vstride: Any = None, vorder: Any = None, points: Any = None,
) -> None:  # fmt: skip
    """glMap2f(target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points), or in PyOpenGL's form
    glMap2f(target, u1, u2, v1, v2, points).

    points: (uorder, vorder, k) numbers.
    """
    what = _map_number(target, 2)
    k = COMPONENTS[what]
    if points is None:
        points = _shaped(v1)
        v1, v2 = ustride, uorder
        if points.ndim != 3:
            raise ValueError(f"points must have the shape (uorder, vorder, {k}), not {points.shape}")
        uorder, vorder, vstride = points.shape
        ustride = vorder * vstride
    _check("u1 and u2", u1, u2, ustride, uorder, k)
    _check("v1 and v2", v1, v2, vstride, vorder, k)
    _check_unit(m)
    u, v = np.arange(uorder)[:, None, None] * int(ustride), np.arange(vorder)[:, None] * int(vstride)
    m.objects.maps[target] = Map(_taken(points, u + v + np.arange(k)), (float(u1), float(u2), float(v1), float(v2)))


glMap2d = glMap2f  # noqa: N816


def glMapGrid1f(m: Machine, un: int, u1: float, u2: float) -> None:
    if un < 1:
        raise invalid_value("un", un, "at least 1")
    m.evaluators = m.evaluators._replace(grid_1=(int(un), float(u1), float(u2)))


glMapGrid1d = glMapGrid1f  # noqa: N816


def glMapGrid2f(m: Machine, un: int, u1: float, u2: float, vn: int, v1: float, v2: float) -> None:
    if un < 1 or vn < 1:
        raise invalid_value("un and vn", (un, vn), "at least 1")
    m.evaluators = m.evaluators._replace(grid_2=(int(un), float(u1), float(u2), int(vn), float(v1), float(v2)))


glMapGrid2d = glMapGrid2f  # noqa: N816


# ---------------------------------------------------------------- evaluation


def bernstein(order: int, t: Float) -> Float:
    """Bernstein polynomials of degree order - 1 at t (n,): (n, order)."""
    i = np.arange(order)
    binomial = np.array([comb(order - 1, int(k)) for k in i], np.float64)
    return np.asarray(binomial * t[:, None] ** i * (1.0 - t[:, None]) ** (order - 1 - i))


def bernstein_derivative(order: int, t: Float) -> Float:
    """Derivatives by t of the Bernstein polynomials: (n, order)."""
    result = np.zeros((len(t), order))
    if order > 1:
        lower = (order - 1) * bernstein(order - 1, t)
        result[:, 1:] += lower
        result[:, :-1] -= lower
    return result


def _evaluated(map: Map, places: tuple[Float, ...], grid: bool, derive: int | None = None) -> Float:
    """The map, or its derivative by u (0) or v (1), at some places: (n, k).  grid: at every u with every v."""
    bases = []
    for axis, t in enumerate(places):
        low, high = map.domain[2 * axis : 2 * axis + 2]
        basis = bernstein_derivative if derive == axis else bernstein
        bases.append(basis(map.points.shape[axis], (t - low) / (high - low)))
    if len(places) == 1:
        return np.asarray(bases[0] @ map.points)
    along_v = np.tensordot(bases[1], map.points, (1, 1))  # (v, i, k)
    if grid:
        return np.asarray(np.tensordot(bases[0], along_v, (1, 1))).reshape(-1, map.points.shape[2])
    return np.asarray(np.einsum("ni,nik->nk", bases[0], along_v))


def evaluate(
    m: Machine, *places: Float, grid: bool = False
) -> tuple[NDArray[np.float32], dict[str, NDArray[np.float32]]] | None:
    """Vertices at u (n,) or u, v (n,) of the enabled maps: rows (n, 10) and columns; None without a vertex map.

    An attribute without an enabled map has its current value.  grid: at each u with each v, u changing slowest.
    """
    dimensions = len(places)
    enabled = m.evaluators.enabled_1 if dimensions == 1 else m.evaluators.enabled_2
    first = int(gl.GL_MAP1_COLOR_4 if dimensions == 1 else gl.GL_MAP2_COLOR_4)
    maps = {what: m.objects.maps.get(first + what, _default(what, dimensions)) for what in range(9) if enabled[what]}
    vertex = maps.get(VERTEX_4, maps.get(VERTEX_3))
    if vertex is None:
        return None
    P = _evaluated(vertex, places, grid)
    rows = np.empty((len(P), ROW), np.float32)
    columns: dict[str, NDArray[np.float32]] = {}
    rows[:, :3] = P[:, :3]
    if P.shape[1] == 4:
        columns["w"] = P[:, 3:].astype(np.float32)
    if dimensions == 2 and m.evaluators.auto_normal:
        rows[:, 3:6] = _normals(vertex, P, places, grid)
    else:
        rows[:, 3:6] = _evaluated(maps[NORMAL], places, grid) if NORMAL in maps else (m.nx, m.ny, m.nz)
    rows[:, 6:10] = _evaluated(maps[COLOR], places, grid) if COLOR in maps else (m.red, m.green, m.blue, m.alpha)
    for what in (TEXTURE_4, TEXTURE_3, TEXTURE_2, TEXTURE_1):
        if what in maps:
            coordinates = np.tile(np.array([0.0, 0.0, 0.0, 1.0], np.float32), (len(rows), 1))
            coordinates[:, : COMPONENTS[what]] = _evaluated(maps[what], places, grid)
            columns["texcoord0"] = coordinates
            break
    return rows, columns


def _default(what: int, dimensions: int) -> Map:
    """Initial control point of a map (table 6.22)."""
    point = {COLOR: [1.0] * 4, INDEX: [1.0], NORMAL: [0.0, 0.0, 1.0]}.get(what)
    point = point or [0.0, 0.0, 0.0, 1.0][: COMPONENTS[what]]
    return Map(np.array(point).reshape((1,) * dimensions + (-1,)), (0.0, 1.0) * dimensions)


def _normals(vertex: Map, P: Float, places: tuple[Float, ...], grid: bool) -> Float:
    """GL_AUTO_NORMAL: the unit vector along dP/du x dP/dv."""
    du, dv = _evaluated(vertex, places, grid, 0), _evaluated(vertex, places, grid, 1)
    if P.shape[1] == 4:  # derivatives of x / w, but for a positive factor
        du, dv = (d[:, :3] * P[:, 3:] - P[:, :3] * d[:, 3:] for d in (du, dv))
    N = np.cross(du, dv)
    length = np.linalg.norm(N, axis=1, keepdims=True)
    return np.asarray(np.divide(N, length, out=np.zeros_like(N), where=length > 0.0))


def _vertex(m: Machine, *places: float) -> None:
    """One vertex between glBegin and glEnd; the current values stay."""
    vertex = evaluate(m, *(np.array([float(t)]) for t in places))
    if vertex is None or m.inside is None:
        return
    rows, columns = vertex
    if "texcoord0" in columns:
        before = m.current["texcoord0"]
        m.set_current("texcoord0", tuple(columns["texcoord0"][0].tolist()))
    if "w" in columns:
        m.columns.append(("w", m.stream.tell() // ROW_BYTES, columns["w"]))
    m.write(rows.tobytes())
    if "texcoord0" in columns:
        m.set_current("texcoord0", before)


def glEvalCoord(m: Machine, u: float, v: float | None = None) -> None:
    if v is None:
        _vertex(m, u)
    else:
        _vertex(m, u, v)


# ---------------------------------------------------------------- grids


def _grid(steps: int, low: float, high: float, chosen: NDArray[np.int64]) -> Float:
    """Places on a grid; its end is hit exactly."""
    return np.where(chosen == steps, high, chosen * ((high - low) / steps) + low)


def glEvalPoint1(m: Machine, p: int) -> None:
    _vertex(m, _grid(*m.evaluators.grid_1, np.array(int(p))))  # type: ignore[arg-type]


def glEvalPoint2(m: Machine, p: int, q: int) -> None:
    grid = m.evaluators.grid_2
    _vertex(m, _grid(*grid[:3], np.array(int(p))), _grid(*grid[3:], np.array(int(q))))  # type: ignore[arg-type]


MOST_STEPS = 1 << 20


def _range(m: Machine, first: int, last: int) -> NDArray[np.int64]:
    if last - first > MOST_STEPS:
        raise invalid_value("the range of the mesh", (first, last), f"of at most {MOST_STEPS} steps")
    return np.arange(int(first), int(last) + 1)


def glEvalMesh1(m: Machine, mode: int, p1: int, p2: int) -> None:
    if mode not in (gl.GL_POINT, gl.GL_LINE):
        raise invalid_enum("mode", mode, "GL_POINT or GL_LINE")
    chosen = _range(m, p1, p2)
    vertices = evaluate(m, _grid(*m.evaluators.grid_1, chosen)) if len(chosen) else None
    if vertices is not None:
        m.add_draw(gl.GL_POINTS if mode == gl.GL_POINT else gl.GL_LINE_STRIP, *vertices, None)


def glEvalMesh2(m: Machine, mode: int, p1: int, p2: int, q1: int, q2: int) -> None:
    if mode not in (gl.GL_POINT, gl.GL_LINE, gl.GL_FILL):
        raise invalid_enum("mode", mode, "GL_POINT, GL_LINE or GL_FILL")
    p, q = _range(m, p1, p2), _range(m, q1, q2)
    if not len(p) or not len(q):
        return
    if len(p) * len(q) > MOST_STEPS:
        raise invalid_value("the range of the mesh", (p1, p2, q1, q2), f"of at most {MOST_STEPS} points")
    grid = m.evaluators.grid_2
    vertices = evaluate(m, _grid(*grid[:3], p), _grid(*grid[3:], q), grid=True)
    if vertices is None:
        return
    rows, columns = vertices
    number = np.arange(len(p) * len(q)).reshape(len(p), len(q))  # of the grid point (p, q)
    if mode == gl.GL_LINE:
        lines: list[Any] = [*number.T, *number]
        for line in lines:
            m.add_draw(gl.GL_LINE_STRIP, rows[line], {name: values[line] for name, values in columns.items()}, None)
    elif mode == gl.GL_POINT:
        m.add_draw(gl.GL_POINTS, rows, columns, None)
    elif len(p) > 1 and len(q) > 1:
        # The specification leaves the diagonal of a quad open: triangles as drivers make them, unless quads show.
        seen = (
            m.polygon.front_mode != gl.GL_FILL
            or m.polygon.back_mode != gl.GL_FILL
            or m.lighting.shade_model == gl.GL_FLAT
        )
        m.add_draw(gl.GL_QUADS if seen else gl.GL_TRIANGLES, rows, columns, _strips(len(p), len(q), seen))


@cached(64 * 1024 * 1024)
def _strips(nu: int, nv: int, quads: bool) -> NDArray[np.uint32]:
    """The strips of a filled mesh of nu x nv points: as quads that end in the strips' provoking vertices (the fourth
    of each), or as the triangles of triangle strips."""
    number = np.arange(nu * nv, dtype=np.uint32).reshape(nu, nv)
    a, b, c, d = number[:-1, :-1].T, number[:-1, 1:].T, number[1:, :-1].T, number[1:, 1:].T  # strip after strip
    if quads:
        return np.stack([c, a, b, d], axis=-1).ravel()
    return np.stack([a, b, c, c, b, d], axis=-1).ravel()


# ---------------------------------------------------------------- queries


def glGetMap(m: Machine, target: int, query: int) -> tuple[float, ...]:
    dimensions = 1 if 0 <= target - gl.GL_MAP1_COLOR_4 < 9 else 2
    what = _map_number(target, dimensions)
    map: Map = m.objects.maps.get(target, _default(what, dimensions))
    if query == gl.GL_COEFF:
        return tuple(float(number) for number in map.points.ravel())
    if query == gl.GL_ORDER:
        return tuple(float(n) for n in map.points.shape[:-1])
    if query == gl.GL_DOMAIN:
        return map.domain
    raise invalid_enum("query", query, "GL_COEFF, GL_ORDER or GL_DOMAIN")
