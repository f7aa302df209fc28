"""Convex regions around what stands in a scene: they tell of most pairs of patches, without a ray, what is in between.

Outside of the regions there is nothing in the way, so a pair whose connections all miss them sees each other whole.
A region whose whole surface is proven to be polygons (``solid``) hides whatever lies beyond it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.compiled import jit
from glsim.radiosity.scene import Scene, area_of, normal_of

Float = NDArray[np.float64]
Int = NDArray[np.int64]
GAP = (
    1e-5  # of the scene's size: rays begin and end so far in front of patches; what is nearer to a wall does not block
)
EXACT = 1e-6  # of the scene's size: how far a corner of a proven body may be from where it should be
MOST_BODIES, MOST_PLANES = 48, 24  # more are not worth asking
MOST_POLYGONS = 4000
TOUCH = 1e-6  # of the way between two ends: what is shorter only touches
THIN = 1e-4  # of the scene's size: a thinner region is made a little thicker, and hides nothing by itself
AT_ONCE = 1 << 12  # patches

HIDDEN, SEEN, ASK = 0, 1, 2  # what the regions alone tell of a pair


@jit
def judge(one: Any, two: Any, rows: Any, columns: Any, starts: Any, solid: Any, exact: float, out: Any) -> None:
    """What regions tell of pairs: SEEN if all connections miss all of them, HIDDEN if all go through one that is
    ``solid`` (k,), else ASK.

    one, two: (n, m, 2), see Bodies.reach, of the ends ``rows`` and ``columns``; starts: (k + 1,), region b has the
    planes starts[b] to starts[b + 1].  At t between the ends the least distance from a plane is (1 - t) a + t b
    exactly, and so is the most.  A region hides only ends that are both outside of it: each in front of one of its
    planes, ``exact`` aside.
    """
    for row in range(len(rows)):
        i, j = rows[row], columns[row]
        out[row] = SEEN
        for b in range(len(solid)):
            enter = enter_whole = 0.0
            leave = leave_whole = 1.0
            outside_i = outside_j = False
            for m in range(starts[b], starts[b + 1]):
                enter, leave = _behind(one[i, m, 0], two[j, m, 0], enter, leave)
                if leave - enter < TOUCH:
                    break
                enter_whole, leave_whole = _behind(one[i, m, 1], two[j, m, 1], enter_whole, leave_whole)
                outside_i |= one[i, m, 0] > -exact and one[i, m, 1] > exact
                outside_j |= two[j, m, 0] > -exact and two[j, m, 1] > exact
            if leave - enter >= TOUCH:
                if solid[b] and outside_i and outside_j and leave_whole - enter_whole >= TOUCH:
                    out[row] = HIDDEN
                    break
                out[row] = ASK


@jit
def _behind(a: float, b: float, enter: float, leave: float) -> tuple[float, float]:
    """Where between enter and leave (1 - t) a + t b is at most 0."""
    if a > 0.0:
        return (max(enter, a / (a - b)), leave) if b < 0.0 else (1.0, 0.0)
    return (enter, min(leave, a / (a - b))) if b > 0.0 else (enter, leave)


@dataclass(frozen=True)
class Bodies:
    """Convex regions outside of which nothing can stand in between.

    planes: (m, 4), a region is where n.p <= d for all of its (n, d); starts: (k + 1,), where each region's begin;
    solid: (k,), whether nothing goes through without meeting a polygon; exact: EXACT in the scene's unit.
    """

    planes: Float
    starts: Int
    solid: NDArray[np.bool_]
    exact: float

    def reach(self, corners: Float) -> NDArray[np.float32]:
        """How far in front of each plane what has these corners (n, c, 3) is: least and most, (n, m, 2)."""
        result = np.empty((len(corners), len(self.planes), 2), np.float32)
        for first in range(0, len(corners), AT_ONCE):
            away = corners[first : first + AT_ONCE] @ self.planes[:, :3].T - self.planes[:, 3]
            result[first : first + AT_ONCE, :, 0] = away.min(axis=1)
            result[first : first + AT_ONCE, :, 1] = away.max(axis=1)
        return result


def bodies_of(scene: Scene) -> Bodies | None:
    """The regions of a scene; None if they are too many to be of use.

    Polygons that have the whole scene on their front side are its shell, which blocks nothing.  The others hang
    together by common corners; around each such group there is the box along its largest polygon, and if the group is
    convex, the planes of its polygons.
    """
    if len(scene.rings) > MOST_POLYGONS:
        return None
    points, size = np.concatenate(scene.rings), scene.size
    inner = [ring for ring in scene.rings if ((points - ring[0]) @ normal_of(ring)).min() < -GAP * size]
    groups = _connected(inner, THIN * size)
    if len(groups) > MOST_BODIES:
        return None
    planes, starts, solid = [np.zeros((0, 4))], [0], []
    for rings in groups:
        normals, faces = _box_normals(rings), surface_of(rings, EXACT * size)
        convex = faces is not None and len(normals) + len(faces) <= MOST_PLANES
        if faces is not None and convex:
            normals = np.concatenate([normals, faces])
        inside = np.concatenate(rings) @ normals.T
        thin = float(np.ptp(inside, axis=0).min()) < THIN * size
        planes.append(np.c_[normals, inside.max(axis=0) + (GAP * size if thin else 0.0)])
        starts.append(starts[-1] + len(normals))
        solid.append(convex and not thin)
    return Bodies(np.concatenate(planes), np.array(starts), np.array(solid, np.bool_), EXACT * size)


def _connected(rings: list[Float], tolerance: float) -> list[list[Float]]:
    """Polygons that have corners in common."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    if not rings:
        return []
    owner = np.repeat(np.arange(len(rings)), [len(ring) for ring in rings])
    corner = _numbered(np.concatenate(rings), tolerance)
    n = len(rings)
    graph = coo_matrix((np.ones(len(owner)), (owner, n + corner)), shape=(n + len(corner),) * 2)
    _, label = connected_components(graph, directed=False)
    groups: dict[int, list[Float]] = {}
    for ring, number in zip(rings, label[:n].tolist(), strict=True):
        groups.setdefault(number, []).append(ring)
    return list(groups.values())


def _numbered(points: Float, tolerance: float) -> Int:
    """(n,): a number for each point, the same where points are rounded to the same place."""
    return np.unique(np.round(points / tolerance), axis=0, return_inverse=True)[1].ravel()


def _box_normals(rings: list[Float]) -> Float:
    """The six normals of a box along the largest polygon's normal and longest edge."""
    largest = max(rings, key=area_of)
    edges = np.roll(largest, -1, axis=0) - largest
    x = edges[np.argmax(np.linalg.norm(edges, axis=1))]
    x = x / np.linalg.norm(x)
    z = normal_of(largest)
    axes = np.stack([x, np.cross(z, x), z])
    return np.concatenate([axes, -axes])


def surface_of(rings: list[Float], tolerance: float) -> Float | None:
    """The normals (k, 3) of a convex body, if polygons are proven to be its whole surface but for at most one flat
    hole; else None.

    The proof: each edge belongs to two polygons that run along it in opposite directions, or to the one polygon that
    would fill the hole; and all corners are behind all polygons.  Then the polygons lie on the hull of the corners with
    their fronts outwards, and since they have no border there, they cover it.  What goes through the body crosses its
    surface twice, at most once of it in the hole.  (A body without thickness proves nothing: see THIN.)
    """
    corners = np.concatenate(rings)
    number = np.split(_numbered(corners, tolerance), np.cumsum([len(ring) for ring in rings])[:-1])
    edges = [edge for ring in number for edge in zip(ring.tolist(), np.roll(ring, -1).tolist(), strict=True)]
    there = set(edges)
    if len(there) < len(edges):
        return None
    border = [(b, a) for a, b in edges if (b, a) not in there]
    hole = _loop(border)
    if len(hole) < len(border):
        return None
    where = dict(zip(np.concatenate(number).tolist(), corners, strict=True))
    faces = [*rings, np.array([where[k] for k in hole])] if hole else rings
    normals = np.array([normal_of(face) for face in faces])
    at = np.array([(face @ normal).min() for face, normal in zip(faces, normals, strict=True)])
    if not normals.any(axis=1).all() or (corners @ normals.T - at).max() > tolerance:
        return None
    return np.asarray(normals[np.unique(np.round(normals, 6), axis=0, return_index=True)[1]])


def _loop(edges: list[tuple[int, int]]) -> list[int]:
    """The corners that follow each other along edges from the first one on, if this comes back to the beginning."""
    after = dict(edges)
    way = [edges[0][0]] if edges else []
    while len(way) < len(after) and (following := after.get(way[-1])) is not None:
        way.append(following)
    return way if way and after.get(way[-1]) == way[0] and len(set(way)) == len(way) else []
