"""The polygon tessellator: contours of any shape, with holes and crossings, become triangles.

The contours cut each other into pieces.  For each piece the winding number on its two sides says whether it separates
inside from outside; the pieces that do are the boundary.  Boundaries are joined to loops, and the loops, outer ones with
their holes, are cut into triangles by ears.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.constants import NAMES
from glsim.glu.errors import GLUError

Float = NDArray[np.float64]
RULES: dict[int, Callable[[int], bool]] = {
    NAMES["GLU_TESS_WINDING_ODD"]: lambda n: n % 2 == 1,
    NAMES["GLU_TESS_WINDING_NONZERO"]: lambda n: n != 0,
    NAMES["GLU_TESS_WINDING_POSITIVE"]: lambda n: n > 0,
    NAMES["GLU_TESS_WINDING_NEGATIVE"]: lambda n: n < 0,
    NAMES["GLU_TESS_WINDING_ABS_GEQ_TWO"]: lambda n: abs(n) >= 2,
}
CALLBACKS = ("BEGIN", "VERTEX", "END", "ERROR", "EDGE_FLAG", "COMBINE")


class Tessellator:
    """gluNewTess: callbacks, properties and the contours of the polygon that is being described."""

    def __init__(self) -> None:
        self.callbacks: dict[str, tuple[Callable[..., Any], bool]] = {}  # name -> function, whether it wants the data
        self.rule: int = NAMES["GLU_TESS_WINDING_ODD"]
        self.boundary_only = False
        self.tolerance = 0.0
        self.normal = np.zeros(3)
        self.contours: list[list[tuple[Float, Any]]] | None = None
        self.open = False  # between gluTessBeginContour and gluTessEndContour
        self.polygon_data: Any = None

    def call(self, name: str, *arguments: Any) -> Any:
        found = self.callbacks.get(name)
        if found is None:
            return None
        function, wants_data = found
        return function(*arguments, self.polygon_data) if wants_data else function(*arguments)

    def fail(self, name: str, error: str) -> None:
        """To the callback; without one the error is raised."""
        code = int(NAMES[error])
        if "ERROR" not in self.callbacks:
            raise GLUError(code, name)
        self.call("ERROR", code)


def gluNewTess() -> Tessellator:
    return Tessellator()


def gluDeleteTess(tess: Tessellator) -> None:
    pass


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
    raise GLUError(int(NAMES["GLU_INVALID_ENUM"]), "gluTessCallback: which must be GLU_TESS_BEGIN or another callback")


def gluTessProperty(tess: Tessellator, which: int, data: float) -> None:
    if which == NAMES["GLU_TESS_WINDING_RULE"]:
        if int(data) not in RULES:
            raise GLUError(int(NAMES["GLU_INVALID_VALUE"]), "gluTessProperty: data must be a winding rule")
        tess.rule = int(data)
    elif which == NAMES["GLU_TESS_BOUNDARY_ONLY"]:
        tess.boundary_only = bool(data)
    elif which == NAMES["GLU_TESS_TOLERANCE"]:
        tess.tolerance = float(data)
    else:
        raise GLUError(int(NAMES["GLU_INVALID_ENUM"]), "gluTessProperty: which must be GLU_TESS_WINDING_RULE, ...")


def gluGetTessProperty(tess: Tessellator, which: int) -> float:
    values = {
        NAMES["GLU_TESS_WINDING_RULE"]: float(tess.rule),
        NAMES["GLU_TESS_BOUNDARY_ONLY"]: float(tess.boundary_only),
        NAMES["GLU_TESS_TOLERANCE"]: tess.tolerance,
    }
    if which not in values:
        raise GLUError(int(NAMES["GLU_INVALID_ENUM"]), "gluGetTessProperty: which must be GLU_TESS_WINDING_RULE, ...")
    return values[which]  # type: ignore[index]


def gluTessNormal(tess: Tessellator, x: float, y: float, z: float) -> None:
    """The normal of the polygon's plane; 0, 0, 0 lets it be found."""
    tess.normal = np.array([x, y, z], np.float64)


def gluTessBeginPolygon(tess: Tessellator, data: Any = None) -> None:
    tess.contours, tess.open, tess.polygon_data = [], False, data


def gluTessBeginContour(tess: Tessellator) -> None:
    if tess.contours is None:
        tess.fail("gluTessBeginContour", "GLU_TESS_MISSING_BEGIN_POLYGON")
        gluTessBeginPolygon(tess)
    assert tess.contours is not None
    tess.contours.append([])
    tess.open = True


def gluTessVertex(tess: Tessellator, location: Any, data: Any = None) -> None:
    """location: x, y, z; data: what the vertex callback gets."""
    if not tess.open:
        tess.fail("gluTessVertex", "GLU_TESS_MISSING_BEGIN_CONTOUR")
        gluTessBeginContour(tess)
    point = np.array([float(c) for c in location][:3], np.float64)
    if np.abs(point).max() > 1e150:
        tess.fail("gluTessVertex", "GLU_TESS_COORD_TOO_LARGE")
        point = np.clip(point, -1e150, 1e150)
    assert tess.contours is not None
    tess.contours[-1].append((point, data))


def gluTessEndContour(tess: Tessellator) -> None:
    if not tess.open:
        tess.fail("gluTessEndContour", "GLU_TESS_MISSING_BEGIN_CONTOUR")
    tess.open = False


def gluTessEndPolygon(tess: Tessellator) -> None:
    """Cut the polygon into triangles, or into its boundary, and hand them to the callbacks."""
    if tess.contours is None:
        tess.fail("gluTessEndPolygon", "GLU_TESS_MISSING_BEGIN_POLYGON")
        return
    contours, tess.contours, tess.open = [c for c in tess.contours if len(c) > 2], None, False
    if not contours:
        return
    arrangement = _Arrangement(tess, contours)
    loops = arrangement.loops()
    if tess.boundary_only:
        for loop in loops:
            tess.call("BEGIN", gl.GL_LINE_LOOP)
            for number in loop:
                tess.call("VERTEX", arrangement.data[number])
            tess.call("END")
        return
    _emit(tess, arrangement, loops)


# The interface of GLU 1.1


def gluBeginPolygon(tess: Tessellator) -> None:
    gluTessBeginPolygon(tess)
    gluTessBeginContour(tess)


def gluNextContour(tess: Tessellator, type: int = 0) -> None:
    gluTessEndContour(tess)
    gluTessBeginContour(tess)


def gluEndPolygon(tess: Tessellator) -> None:
    gluTessEndContour(tess)
    gluTessEndPolygon(tess)


# ---------------------------------------------------------------- the plane


def _given(data: Any) -> Any:
    return data


def _newell(contours: list[list[tuple[Float, Any]]]) -> Float:
    """The normal of the plane that fits the contours: the sum of their areas."""
    total, largest = np.zeros(3), np.zeros(3)
    for contour in contours:
        points = np.array([point for point, _ in contour])
        area = np.cross(points - points[0], np.roll(points, -1, axis=0) - points[0]).sum(axis=0)
        total += area
        if area @ area > largest @ largest:
            largest = area
    return total if np.abs(total).max() > 1e-9 * np.abs(largest).max() else largest


def _flat(normal: Float, points: Float) -> Float:
    """Points (n, 3) in the plane: along the coordinate axis that the normal is nearest to, counterclockwise seen from
    where it points."""
    axis = int(np.argmax(np.abs(normal)))
    side = 1.0 if normal[axis] >= 0 else -1.0
    u, v = points[:, (axis + 1) % 3], points[:, (axis + 2) % 3]
    return np.stack([u * side, v], axis=1)


class _Arrangement:
    """The contours cut at their crossings: points (n, 2), the data of each, and directed edges (a, b)."""

    def __init__(self, tess: Tessellator, contours: list[list[tuple[Float, Any]]]) -> None:
        self.tess = tess
        places = np.array([point for contour in contours for point, _ in contour])
        normal = tess.normal if tess.normal.any() else _newell(contours)
        self.space: list[Float] = []
        self.data: list[Any] = []
        self.numbers: dict[tuple[float, float], int] = {}
        self.flat: list[tuple[float, float]] = []
        flat = _flat(normal, places)
        self.grain = max(float(np.ptp(flat, axis=0).max()), 1e-300) * 1e-11
        edges, start = [], 0
        for contour in contours:
            numbers = [
                self._number(flat[start + k], point, lambda data=data: data) for k, (point, data) in enumerate(contour)
            ]
            start += len(contour)
            edges += [(a, b) for a, b in zip(numbers, [*numbers[1:], numbers[0]], strict=True) if a != b]
        self.edges = self._cut(edges)

    def _number(self, place: Any, point: Float, data: Callable[[], Any]) -> int:
        """The number of a point; points at the same place are one."""
        key = round(float(place[0]) / self.grain), round(float(place[1]) / self.grain)
        if key not in self.numbers:
            self.numbers[key] = len(self.flat)
            self.flat.append((float(place[0]), float(place[1])))
            self.space.append(point)
            self.data.append(data())
        return self.numbers[key]

    def _cut(self, edges: list[tuple[int, int]]) -> list[tuple[int, int]]:
        """The edges as pieces that meet at their ends only."""
        cuts: list[dict[int, float]] = [{} for _ in edges]
        P = np.array(self.flat)
        A, B = P[[a for a, _ in edges]], P[[b for _, b in edges]]
        D = B - A
        low, high = np.minimum(A, B), np.maximum(A, B)
        for i in range(len(edges)):
            near = np.flatnonzero(((low[i + 1 :] <= high[i]) & (high[i + 1 :] >= low[i])).all(axis=1)) + i + 1
            for j in near.tolist():
                self._cross(edges, cuts, A, D, i, j)
        pieces = []
        for (a, b), places in zip(edges, cuts, strict=True):
            stops = [a, *sorted(places, key=places.__getitem__), b]
            pieces += [(p, q) for p, q in pairwise(stops) if p != q]
        return pieces

    def _cross(
        self, edges: list[tuple[int, int]], cuts: list[dict[int, float]], A: Float, D: Float, i: int, j: int
    ) -> None:
        """Note where edges i and j meet."""
        (a, b), (c, d) = edges[i], edges[j]
        cross = float(D[i][0] * D[j][1] - D[i][1] * D[j][0])
        scale = float(np.hypot(*D[i]) * np.hypot(*D[j]))
        for k, ends, other in ((i, (c, d), (a, b)), (j, (a, b), (c, d))):  # an end of one on the other
            for end in ends:
                if end not in other:
                    t = self._along(end, A[k], D[k])
                    if t is not None:
                        cuts[k][end] = t
        if abs(cross) <= 1e-12 * scale or {a, b} & {c, d}:
            return
        gap = A[j] - A[i]
        t = float(gap[0] * D[j][1] - gap[1] * D[j][0]) / cross
        u = float(gap[0] * D[i][1] - gap[1] * D[i][0]) / cross
        if 0.0 < t < 1.0 and 0.0 < u < 1.0:
            place = A[i] + t * D[i]
            point = self.space[a] + t * (self.space[b] - self.space[a])
            number = self._number(place, point, lambda: self._combined(point, (a, b, c, d), t, u))
            if number not in (a, b):
                cuts[i][number] = t
            if number not in (c, d):
                cuts[j][number] = u

    def _along(self, number: int, start: Float, direction: Float) -> float | None:
        """Where on an edge a point lies, in (0, 1); None if it lies beside it."""
        gap = np.array(self.flat[number]) - start
        square = float(direction @ direction)
        t = float(gap @ direction) / square
        if not 0.0 < t < 1.0:
            return None
        aside = abs(float(gap[0] * direction[1] - gap[1] * direction[0])) / square**0.5
        return t if aside < 4 * self.grain else None

    def _combined(self, point: Float, ends: tuple[int, int, int, int], t: float, u: float) -> Any:
        """The data of a new vertex where two edges cross: from the combine callback."""
        if "COMBINE" not in self.tess.callbacks:
            self.tess.fail("gluTessEndPolygon", "GLU_TESS_NEED_COMBINE_CALLBACK")
            return None
        weights = [(1 - t) / 2, t / 2, (1 - u) / 2, u / 2]
        return self.tess.call("COMBINE", tuple(point.tolist()), [self.data[end] for end in ends], weights)

    def loops(self) -> list[list[int]]:
        """The boundary as loops of point numbers with the inside on their left."""
        inside = RULES[self.tess.rule]
        net: dict[tuple[int, int], int] = {}  # pieces that lie on each other, with how often they go each way
        for a, b in self.edges:
            key, step = ((a, b), 1) if a < b else ((b, a), -1)
            net[key] = net.get(key, 0) + step
        pieces = list(net)
        windings = self._windings(pieces, net)
        boundary = []
        for (a, b), right in zip(pieces, windings, strict=True):
            left = right + net[a, b]
            if inside(left) != inside(right):
                boundary.append((a, b) if inside(left) else (b, a))
        return _joined(boundary, self.flat)

    def _windings(self, pieces: list[tuple[int, int]], net: dict[tuple[int, int], int]) -> list[int]:
        """The winding number just right of each piece, by a ray from its middle to the right side."""
        P = np.array(self.flat)
        A, B = P[[a for a, _ in pieces]], P[[b for _, b in pieces]]
        steps = np.array([net[piece] for piece in pieces])
        D = B - A
        result = []
        for k in range(len(pieces)):
            middle, along = (A[k] + B[k]) / 2, D[k] / np.hypot(*D[k])
            ray = np.array([along[1], -along[0]])  # to the right
            s, e = (A - middle) @ along, (B - middle) @ along  # where each piece begins and ends across the ray
            crossing = (s <= 0) != (e <= 0)
            crossing[k] = False
            with np.errstate(all="ignore"):
                t = s / (s - e)
                far = ((A - middle) @ ray) * (1 - t) + ((B - middle) @ ray) * t
            crossing &= far > 0
            # going along the piece's own direction from right to left of the ray counts one way
            result.append(int((steps[crossing] * np.where(e[crossing] > s[crossing], 1, -1)).sum()))
        return result


def _joined(boundary: list[tuple[int, int]], flat: list[tuple[float, float]]) -> list[list[int]]:
    """Directed edges as loops; where several go on, the one that turns most to the left, so that loops stay simple."""
    onward: dict[int, list[int]] = {}
    for a, b in boundary:
        onward.setdefault(a, []).append(b)
    loops = []
    while onward:
        first = next(iter(onward))
        loop, before = [first], None
        while loop[-1] in onward:
            here = loop[-1]
            choices = onward[here]
            if before is None or len(choices) == 1:
                following = choices[0]
            else:
                origin, came = np.array(flat[here]), np.array(flat[before])
                back = came - origin

                def turn(n: int, origin: Float = origin, back: Float = back) -> float:
                    out = np.array(flat[n]) - origin
                    angle = np.arctan2(back[1], back[0]) - np.arctan2(out[1], out[0])
                    return float(angle % (2 * np.pi))

                following = min(choices, key=turn)
            choices.remove(following)
            if not choices:
                del onward[here]
            before = here
            if following == first:
                break
            loop.append(following)
        if len(loop) > 2:
            loops.append(loop)
    return loops


def _area(loop: list[int], P: Float) -> float:
    x, y = P[loop].T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()) / 2


def _emit(tess: Tessellator, arrangement: _Arrangement, loops: list[list[int]]) -> None:
    """Triangles to the callbacks, as one GL_TRIANGLES."""
    P = np.array(arrangement.flat)
    edges = {(a, b) for loop in loops for a, b in zip(loop, [*loop[1:], loop[0]], strict=True)}
    triangles = [t for ring in _with_holes(loops, P) for t in _ears(ring, P)]
    if not triangles:
        return
    flags = "EDGE_FLAG" in tess.callbacks
    tess.call("BEGIN", gl.GL_TRIANGLES)
    last: bool | None = None
    for a, b, c in triangles:
        for here, following in ((a, b), (b, c), (c, a)):
            on_boundary = (here, following) in edges
            if flags and on_boundary != last:
                tess.call("EDGE_FLAG", on_boundary)
                last = on_boundary
            tess.call("VERTEX", arrangement.data[here])
    tess.call("END")


def _with_holes(loops: list[list[int]], P: Float) -> list[list[int]]:
    """Each outer loop as one ring, with its holes joined to it by bridges."""
    outer = [loop for loop in loops if _area(loop, P) > 0]
    holes = sorted((loop for loop in loops if _area(loop, P) <= 0), key=lambda loop: -P[loop, 0].max())
    owners: list[list[int]] = [list(loop) for loop in outer]
    areas = [_area(loop, P) for loop in outer]
    for hole in holes:
        at = hole[int(np.argmax(P[hole, 0]))]
        around = [k for k, loop in enumerate(outer) if at not in loop and _contains(P[loop], P[at])]
        if not around:
            around = [k for k, loop in enumerate(outer) if at in loop]
        if around:
            k = min(around, key=lambda k: areas[k])
            owners[k] = _bridged(owners[k], hole, P)
    return owners


def _contains(ring: Float, point: Float) -> bool:
    (x, y), (a, b) = ring.T, point
    x2, y2 = np.roll(x, -1), np.roll(y, -1)
    crossing = (y > b) != (y2 > b)
    with np.errstate(all="ignore"):
        where = x + (b - y) * (x2 - x) / (y2 - y)
    return bool((crossing & (where > a)).sum() % 2)


def _bridged(ring: list[int], hole: list[int], P: Float) -> list[int]:
    """Ring and hole as one ring: a bridge from the hole's rightmost point to a point of the ring that it sees."""
    k = int(np.argmax(P[hole, 0]))
    M = P[hole[k]]
    starts, ends = P[ring], P[[*ring[1:], ring[0]]]
    order = np.argsort(((starts - M) ** 2).sum(axis=1), kind="stable")
    hole_starts, hole_ends = P[hole], P[[*hole[1:], hole[0]]]
    blockers_a = np.concatenate([starts, hole_starts])
    blockers_b = np.concatenate([ends, hole_ends])
    for n in order.tolist():
        V = P[ring[n]]
        if _opens(ring, n, M, P) and not _blocked(M, V, blockers_a, blockers_b):
            return [*ring[: n + 1], *hole[k:], *hole[: k + 1], *ring[n:]]
    n = int(order[0])
    return [*ring[: n + 1], *hole[k:], *hole[: k + 1], *ring[n:]]


def _side(a: Float, b: Float, c: Float) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def _opens(ring: list[int], n: int, M: Float, P: Float) -> bool:
    """Whether M lies in the inner angle of corner n of the ring."""
    a, v, b = P[ring[n - 1]], P[ring[n]], P[ring[(n + 1) % len(ring)]]
    if _side(a, v, b) >= 0:
        return _side(a, v, M) >= 0 and _side(v, b, M) >= 0
    return _side(a, v, M) >= 0 or _side(v, b, M) >= 0


def _blocked(M: Float, V: Float, A: Float, B: Float) -> bool:
    """Whether a segment properly crosses the line of sight from M to V."""
    d = V - M

    def side(points: Float) -> Float:
        return np.asarray(d[0] * (points[:, 1] - M[1]) - d[1] * (points[:, 0] - M[0]))

    e = B - A
    m = e[:, 0] * (M[1] - A[:, 1]) - e[:, 1] * (M[0] - A[:, 0])
    v = e[:, 0] * (V[1] - A[:, 1]) - e[:, 1] * (V[0] - A[:, 0])
    return bool(((side(A) * side(B) < 0) & (m * v < 0)).any())


def _ears(ring: list[int], P: Float) -> list[tuple[int, int, int]]:
    """A simple ring, counterclockwise, as triangles."""
    left, triangles = list(ring), []
    misses = 0
    k = 0
    while len(left) > 3 and misses < len(left):
        k %= len(left)
        a, b, c = left[k - 1], left[k], left[(k + 1) % len(left)]
        if _is_ear(a, b, c, left, P):
            triangles.append((a, b, c))
            del left[k]
            misses = 0
            k = max(k - 1, 0)
        else:
            misses += 1
            k += 1
    if len(left) == 3:
        triangles.append((left[0], left[1], left[2]))
    return [t for t in triangles if len(set(t)) == 3]


def _is_ear(a: int, b: int, c: int, left: list[int], P: Float) -> bool:
    A, B, C = P[a], P[b], P[c]
    area = _side(A, B, C)
    if area < 0:
        return False
    if area == 0.0:
        return True  # a flat corner can go
    others = P[[n for n in left if n not in (a, b, c)]]
    if not len(others):
        return True
    inside = np.ones(len(others), bool)
    for p, q in ((A, B), (B, C), (C, A)):
        inside &= (q[0] - p[0]) * (others[:, 1] - p[1]) - (q[1] - p[1]) * (others[:, 0] - p[0]) >= 0
    return not inside.any()
