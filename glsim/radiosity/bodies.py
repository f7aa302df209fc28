"""Convex regions around what stands in a scene: for most pairs of patches they save all rays.

Nothing can block outside of the regions, so two patches see each other wholly if all lines between them miss all
regions.  They do not see each other at all if every line between them goes through one region that is ``solid``: its
whole surface is proven to consist of polygons.
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
EXACT = 1e-6  # of the scene's size: the tolerance for corners that coincide and lie behind planes, see surface_of
MOST_BODIES, MOST_PLANES = 48, 24  # in a scene, else it has no regions; of a region, else it is only a box
MOST_POLYGONS = 4000
TOUCH = 1e-6  # of a line's length: a line with a shorter part inside a region counts as outside
THIN = 1e-4  # of the scene's size: a thinner region is made a little thicker, and hides nothing by itself
AT_ONCE = 1 << 12  # patches

HIDDEN, VISIBLE, UNDECIDED = 0, 1, 2  # a pair of patches: all lines are blocked, none is, rays must decide


@jit
def decide(
    reach_i: Any, reach_j: Any, rows: Any, columns: Any, starts: Any, solid: Any, exact: float, out: Any
) -> None:
    """Write what the regions tell of each pair into out (p,): VISIBLE, HIDDEN, or UNDECIDED, for which rays are needed.

    VISIBLE: all lines between the two ends miss all regions.  HIDDEN: all lines go through one region that is
    ``solid``.  reach_i, reach_j: (n, m, 2), Bodies.reach of the ends with the numbers ``rows`` and ``columns`` (p,).
    starts: (k + 1,), region b has the planes starts[b] up to starts[b + 1].  solid: (k,).

    A line runs from the first end (t = 0) to the second (t = 1).  At t its distance from a plane is at least
    (1 - t) a + t b, where a and b are the least distances of the two ends from the plane, and at most the same with the
    largest distances.  A region hides a pair only if both ends are outside of it: each end reaches in front of one of
    the region's planes by more than ``exact``, and behind that plane by less than ``exact``.
    """
    for pair in range(len(rows)):
        i, j = rows[pair], columns[pair]
        out[pair] = VISIBLE
        for region in range(len(solid)):
            enter = enter_whole = 0.0
            leave = leave_whole = 1.0
            outside_i = outside_j = False
            for m in range(starts[region], starts[region + 1]):
                enter, leave = _clip_interval(reach_i[i, m, 0], reach_j[j, m, 0], enter, leave)
                if leave - enter < TOUCH:
                    break
                enter_whole, leave_whole = _clip_interval(reach_i[i, m, 1], reach_j[j, m, 1], enter_whole, leave_whole)
                outside_i |= reach_i[i, m, 0] > -exact and reach_i[i, m, 1] > exact
                outside_j |= reach_j[j, m, 0] > -exact and reach_j[j, m, 1] > exact
            if leave - enter >= TOUCH:
                if solid[region] and outside_i and outside_j and leave_whole - enter_whole >= TOUCH:
                    out[pair] = HIDDEN
                    break
                out[pair] = UNDECIDED


@jit
def _clip_interval(a: float, b: float, enter: float, leave: float) -> tuple[float, float]:
    """Return the part of the interval of t from ``enter`` to ``leave`` in which (1 - t) a + t b is at most 0."""
    if a > 0.0:
        return (max(enter, a / (a - b)), leave) if b < 0.0 else (1.0, 0.0)
    return (enter, min(leave, a / (a - b))) if b > 0.0 else (enter, leave)


@dataclass(frozen=True)
class Bodies:
    """Convex regions of a scene; outside of them nothing blocks a line between two patches.

    planes: (m, 4), rows (n, d); a region is where n.p <= d for all of its planes; starts: (k + 1,), region b has the
    planes starts[b] up to starts[b + 1]; solid: (k,), whether every line through the region meets a polygon; exact:
    EXACT in the scene's unit.
    """

    planes: Float
    starts: Int
    solid: NDArray[np.bool_]
    exact: float

    def reach(self, corners: Float) -> NDArray[np.float32]:
        """Return the least and the largest distance of corners (n, c, 3) from each plane: (n, m, 2), > 0 in front."""
        result = np.empty((len(corners), len(self.planes), 2), np.float32)
        for first in range(0, len(corners), AT_ONCE):
            away = corners[first : first + AT_ONCE] @ self.planes[:, :3].T - self.planes[:, 3]
            result[first : first + AT_ONCE, :, 0] = away.min(axis=1)
            result[first : first + AT_ONCE, :, 1] = away.max(axis=1)
        return result


def bodies_of(scene: Scene) -> Bodies | None:
    """Return the regions of a scene; None if they are too many to be of use.

    Polygons that have the whole scene on their front side are its shell, which blocks nothing.  The other polygons are
    grouped by common corners.  The region of a group is bounded by a box aligned with the group's largest polygon and,
    if the group is a convex surface, by the planes of its polygons too.
    """
    if len(scene.polygons) > MOST_POLYGONS:
        return None
    points, size = np.concatenate(scene.polygons), scene.size
    inner = [polygon for polygon in scene.polygons if ((points - polygon[0]) @ normal_of(polygon)).min() < -GAP * size]
    groups = _connected(inner, THIN * size)
    if len(groups) > MOST_BODIES:
        return None
    planes, starts, solid = [np.zeros((0, 4))], [0], []
    for polygons in groups:
        normals, faces = _box_normals(polygons), surface_of(polygons, EXACT * size)
        convex = faces is not None and len(normals) + len(faces) <= MOST_PLANES
        if faces is not None and convex:
            normals = np.concatenate([normals, faces])
        inside = np.concatenate(polygons) @ normals.T
        thin = float(np.ptp(inside, axis=0).min()) < THIN * size
        planes.append(np.c_[normals, inside.max(axis=0) + (GAP * size if thin else 0.0)])
        starts.append(starts[-1] + len(normals))
        solid.append(convex and not thin)
    return Bodies(np.concatenate(planes), np.array(starts), np.array(solid, np.bool_), EXACT * size)


def _connected(polygons: list[Float], tolerance: float) -> list[list[Float]]:
    """Group polygons that have corners in common, at once or through others."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    if not polygons:
        return []
    owner = np.repeat(np.arange(len(polygons)), [len(polygon) for polygon in polygons])
    corner = _numbered(np.concatenate(polygons), tolerance)
    n = len(polygons)
    graph = coo_matrix((np.ones(len(owner)), (owner, n + corner)), shape=(n + len(corner),) * 2)
    _, label = connected_components(graph, directed=False)
    groups: dict[int, list[Float]] = {}
    for polygon, number in zip(polygons, label[:n].tolist(), strict=True):
        groups.setdefault(number, []).append(polygon)
    return list(groups.values())


def _numbered(points: Float, tolerance: float) -> Int:
    """Return a number for each point (n, 3): the same for points that are rounded to the same place."""
    return np.unique(np.round(points / tolerance), axis=0, return_inverse=True)[1].ravel()


def _box_normals(polygons: list[Float]) -> Float:
    """Return the six normals (6, 3) of a box along the largest polygon's normal and longest edge."""
    largest = max(polygons, key=area_of)
    edges = np.roll(largest, -1, axis=0) - largest
    x = edges[np.argmax(np.linalg.norm(edges, axis=1))]
    x = x / np.linalg.norm(x)
    z = normal_of(largest)
    axes = np.stack([x, np.cross(z, x), z])
    return np.concatenate([axes, -axes])


def surface_of(polygons: list[Float], tolerance: float) -> Float | None:
    """Return the normals (k, 3) of a convex body if polygons are proven to be its surface, else None.

    One flat hole is allowed, as under a crate that stands on the floor.

    The proof: each edge belongs to two polygons that run along it in opposite directions, or to the one polygon that
    would fill the hole; and all corners are behind all polygons.  Then the polygons lie on the hull of the corners with
    their fronts outwards, and since they have no border there, they cover it.  What goes through the body crosses its
    surface twice, at most once of it in the hole.  (A body without thickness proves nothing: see THIN.)
    """
    corners = np.concatenate(polygons)
    number = np.split(_numbered(corners, tolerance), np.cumsum([len(polygon) for polygon in polygons])[:-1])
    edges = [edge for polygon in number for edge in zip(polygon.tolist(), np.roll(polygon, -1).tolist(), strict=True)]
    known = set(edges)
    if len(known) < len(edges):
        return None
    border = [(b, a) for a, b in edges if (b, a) not in known]
    hole = _loop(border)
    if len(hole) < len(border):
        return None
    where = dict(zip(np.concatenate(number).tolist(), corners, strict=True))
    faces = [*polygons, np.array([where[k] for k in hole])] if hole else polygons
    normals = np.array([normal_of(face) for face in faces])
    at = np.array([(face @ normal).min() for face, normal in zip(faces, normals, strict=True)])
    if not normals.any(axis=1).all() or (corners @ normals.T - at).max() > tolerance:
        return None
    return np.asarray(normals[np.unique(np.round(normals, 6), axis=0, return_index=True)[1]])


def _loop(edges: list[tuple[int, int]]) -> list[int]:
    """Return the corners along edges (pairs of corners), from the first on, if they form one closed loop, else []."""
    after = dict(edges)
    loop = [edges[0][0]] if edges else []
    while len(loop) < len(after) and (following := after.get(loop[-1])) is not None:
        loop.append(following)
    return loop if loop and after.get(loop[-1]) == loop[0] and len(set(loop)) == len(loop) else []
