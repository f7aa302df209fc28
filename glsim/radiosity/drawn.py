"""The mesh that is drawn: triangles of the patches, cut smaller where gathered and interpolated light disagree.

Patches must be small only where the light that they send matters; the eye sees the light that they receive.  So the
triangles of the patches are refined after the solution.  Light is gathered at the middle of each edge and compared with
the mean of its ends; the edges where the difference matters most are cut in two.  A triangle with an edge to be cut is
cut at its longest edge too (Rivara 1984), so that triangles stay plump.  An edge is cut for both of its triangles, so
there is never a T-vertex.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.gather import Gatherer, Light
from glsim.radiosity.mesh import INWARD, PatchMesh
from glsim.radiosity.progress import Progress
from glsim.radiosity.tone import GAMMA, automatic_white

Float = NDArray[np.float64]
Int = NDArray[np.int64]
Mask = NDArray[np.bool_]
ROUNDS = 24  # at most
GROWTH = 1.6  # so many times more vertices, at most, after each round
MOST = 0.25  # of a vertex's light: so much may be added to it, see _fitted
SMOOTH = 0.01  # of the mean radiosity: where bounced light is this near to linear, it is not gathered again


@dataclass(frozen=True)
class Edges:
    """The edges of triangles, each once, in the order of ``key``, which tells an edge by its ends.

    ends: (E, 2); key: (E,); of: (T, 3), the edges opposite to each triangle's corners; times: (E,), how many triangles
    an edge has, two unless it is a border; triangle: (E,), one of these.
    """

    ends: Int
    key: Int
    of: Int
    times: Int
    triangle: Int

    @staticmethod
    def of_triangles(triangles: Int) -> Edges:
        """Return the edges of triangles (T, 3)."""
        ends = np.sort(triangles[:, [[1, 2], [2, 0], [0, 1]]].reshape(-1, 2), axis=1)
        key, first, number, times = np.unique(
            (ends[:, 0] << 32) | ends[:, 1], return_index=True, return_inverse=True, return_counts=True
        )
        return Edges(ends[first], key, number.reshape(-1, 3), times, first // 3)


@dataclass(frozen=True)
class Middles:
    """What is known of edges.  key: (E,), sorted; light: at their middles; rough: (E,), how far bounced light there is
    from the mean of the ends, in radiosity; if it was not gathered, how far it may be."""

    key: Int
    light: Light
    rough: Float

    def joined(self, other: Middles) -> Middles:
        """Return what is known of both, which have no edge in common."""
        key = np.concatenate([self.key, other.key])
        order = np.argsort(key)
        light, rough = self.light.joined(other.light), np.concatenate([self.rough, other.rough])
        return Middles(key[order], light[order], rough[order])


def refined(mesh: PatchMesh, light: Light, gatherer: Gatherer, count: int, tell: Progress) -> tuple[PatchMesh, Light]:
    """Return a mesh of about ``count`` vertices, and the irradiance at them.

    mesh: of the patches; light: at its vertices; gatherer: finds more of it.
    """
    dark = gatherer.patches.rho[mesh.patch] * light.both
    mean = max(float(dark.max(axis=1).mean()), 1e-300)
    white = automatic_white(gatherer.patches, gatherer.B)
    rough = np.full(len(mesh.triangles), np.inf)  # (T,), see Middles.rough
    known = Middles(np.zeros(0, np.int64), light[:0], np.zeros(0))
    for _ in range(ROUNDS):
        edges = Edges.of_triangles(mesh.triangles)
        new = _unknown(edges, known)
        fresh = _middles(mesh, light, edges, new, rough, gatherer, SMOOTH * mean)
        known = _of(known.joined(fresh), edges.key)
        tell("drawn mesh", min(len(mesh.vertices), count), count)
        wanted = min(int(GROWTH * len(mesh.vertices)), count) - len(mesh.vertices)
        cut = _chosen(mesh, edges, _weight(mesh, light, edges, known.light, gatherer, white), wanted)
        if not cut.any():
            break
        rough = known.rough[edges.of].max(axis=1)
        mesh, light, rough = _cut(mesh, light, edges, known.light, cut, rough)
    return mesh, Light(
        _fitted(mesh, edges, light.direct, known.light.direct), _fitted(mesh, edges, light.bounced, known.light.bounced)
    )


def _fitted(mesh: PatchMesh, edges: Edges, values: Float, middle: Float) -> Float:
    """Return values at the vertices (V, 3) whose linear interpolation is nearest to what was gathered.

    values: gathered at the vertices; middle: (E, 3), gathered at the middles of edges.  Both together make a quadratic
    function of each triangle.  Its mean stays what it is if an edge whose middle is brighter than the mean of its ends
    by d adds 2/5 d to its ends and 1/5 d to the corner opposite, weighted by area (least squares with a lumped mass
    matrix).  No value leaves the range of those gathered at and around its vertex.
    """
    off = middle - (values[edges.ends[:, 0]] + values[edges.ends[:, 1]]) / 2.0
    area, corner = mesh.areas, mesh.triangles
    total, weight = np.zeros_like(values), np.zeros(len(values))
    low, high = values.copy(), values.copy()
    for k in range(3):
        for other in range(3):
            np.add.at(total, corner[:, k], (0.2 if other == k else 0.4) * area[:, None] * off[edges.of[:, other]])
        np.add.at(weight, corner[:, k], area)
    for end in (0, 1):
        np.minimum.at(low, edges.ends[:, end], middle)
        np.maximum.at(high, edges.ends[:, end], middle)
    change = np.clip(total / np.maximum(weight, 1e-300)[:, None], -MOST * values, MOST * values)
    return np.clip(values + change, low, high)


def _unknown(edges: Edges, known: Middles) -> Int:
    """Return the numbers of the edges of which nothing is known."""
    return np.flatnonzero(~np.isin(edges.key, known.key, assume_unique=True))


def _of(known: Middles, key: Int) -> Middles:
    """Return what is known of the edges with these keys, all of which are known."""
    at = np.searchsorted(known.key, key)
    return Middles(key, known.light[at], known.rough[at])


def _middles(
    mesh: PatchMesh, light: Light, edges: Edges, new: Int, rough: Float, gatherer: Gatherer, smooth: float
) -> Middles:
    """Gather the light at the middles of the edges ``new`` (k,): direct light at all, bounced light where it may be
    further than ``smooth`` from the mean of the ends.  rough: (T,), how far it may be in each triangle."""
    of_cluster = gatherer.patches.is_cluster[mesh.triangle_patch[edges.triangle[new]]]
    kept, new = new[of_cluster], new[~of_cluster]  # the pieces of clusters stay as they are
    at, normals, patch = _places(mesh, edges, new)
    mean = light.between(*edges.ends[new].T)
    worst = np.zeros(len(edges.key))
    np.maximum.at(worst, edges.of, rough[:, None])
    far, bounced = worst[new], mean.bounced.copy()
    measured = np.flatnonzero(far > smooth)
    direct = gatherer.direct(at, normals)
    bounced[measured] = gatherer.bounced(at[measured], normals[measured], patch[measured])
    inside = gatherer.covered(at, normals)
    found = Light(np.where(inside[:, None], mean.direct, direct), np.where(inside[:, None], mean.bounced, bounced))
    off = gatherer.patches.rho[patch] * np.abs(found.bounced - mean.bounced)
    far[measured] = off[measured].max(axis=1)
    small = Middles(edges.key[kept], light.between(*edges.ends[kept].T), np.zeros(len(kept)))
    return Middles(edges.key[new], found, far).joined(small)


def _places(mesh: PatchMesh, edges: Edges, chosen: Int) -> tuple[Float, Float, Int]:
    """Return where light is gathered for the middles of edges: points (k, 3), normals (k, 3), patches (k,)."""
    one, two = edges.ends[chosen].T
    middle = (mesh.vertices[one] + mesh.vertices[two]) / 2.0
    triangle = edges.triangle[chosen]
    inner = mesh.vertices[mesh.triangles[triangle]].mean(axis=1)
    border = (edges.times[chosen] == 1)[:, None]
    normals = mesh.normals[one] + mesh.normals[two]
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.where(length > 1e-6, normals / np.maximum(length, 1e-6), mesh.normals[one])
    return np.where(border, middle + INWARD * (inner - middle), middle), normals, mesh.triangle_patch[triangle]


def _weight(mesh: PatchMesh, light: Light, edges: Edges, middle: Light, gatherer: Gatherer, white: float) -> Float:
    """Return how much the errors at the middles of edges matter, (E,): their squares times the area.

    Errors are those of the colours on the screen, of all light and of direct light alone, because it is colours that
    the screen interpolates; but what is brighter than white still counts.
    """
    rho = gatherer.patches.rho[mesh.triangle_patch[edges.triangle]]
    area = np.bincount(edges.of.ravel(), np.repeat(mesh.areas, 3), len(edges.key))
    total = np.zeros(len(area))
    for at_ends, here in ((light.both, middle.both), (light.direct, middle.direct)):
        one, two, between = (
            (rho * H / white) ** (1.0 / GAMMA) for H in (at_ends[edges.ends[:, 0]], at_ends[edges.ends[:, 1]], here)
        )
        total += ((between - (one + two) / 2.0) ** 2).sum(axis=1)
    return np.asarray(area * total)


def _chosen(mesh: PatchMesh, edges: Edges, weight: Float, wanted: int) -> Mask:
    """Return a mask (E,) of at most ``wanted`` edges to cut, those of most weight, and with each the longest edges of
    its triangles, of their neighbours, and so on."""
    length = np.linalg.norm(mesh.vertices[edges.ends[:, 0]] - mesh.vertices[edges.ends[:, 1]], axis=1)
    order = np.lexsort((edges.key, length))
    rank = np.empty(len(order), np.int64)
    rank[order] = np.arange(len(order))
    longest = edges.of[np.arange(len(edges.of)), rank[edges.of].argmax(axis=1)]
    heavy = np.argsort(-weight)
    heavy = heavy[weight[heavy] > 0.0]
    first = wanted
    while first > 0:
        cut = np.zeros(len(edges.key), bool)
        cut[heavy[:first]] = True
        while (more := longest[cut[edges.of].any(axis=1)])[~cut[more]].size:
            cut[more] = True
        if cut.sum() <= wanted:
            return cut
        first = int(first * 0.7)
    return np.zeros(len(edges.key), bool)


def _cut(
    mesh: PatchMesh, light: Light, edges: Edges, middle: Light, cut: Mask, rough: Float
) -> tuple[PatchMesh, Light, Float]:
    """Return mesh, light and rough (T,) with the edges ``cut`` (E,) in two parts, of which each triangle's longest is
    one if it has any."""
    chosen = np.flatnonzero(cut)
    number = np.full(len(cut), -1)
    number[chosen] = len(mesh.vertices) + np.arange(len(chosen))
    length = np.linalg.norm(mesh.vertices[edges.ends[:, 0]] - mesh.vertices[edges.ends[:, 1]], axis=1)
    order = np.lexsort((edges.key, length))
    rank = np.empty(len(order), np.int64)
    rank[order] = np.arange(len(order))
    parted = np.flatnonzero(cut[edges.of].any(axis=1))
    turn = (rank[edges.of[parted]].argmax(axis=1)[:, None] + np.arange(3)) % 3  # first the corner opposite the longest
    corners = np.take_along_axis(mesh.triangles[parted], turn, 1)
    middles = number[np.take_along_axis(edges.of[parted], turn, 1)]
    (a, b, c), (m, m_b, m_c) = corners.T, middles.T
    halves = []
    for apex, tip, extra, flip in ((b, a, m_c, False), (c, a, m_b, True)):
        whole = extra < 0
        for chosen_here, triangle in (
            (whole, (m, tip, apex)), (~whole, (m, tip, extra)), (~whole, (m, extra, apex)),
        ):  # fmt: skip
            part = np.stack(triangle, axis=1)[chosen_here]
            halves.append((part[:, ::-1] if flip else part, parted[chosen_here]))
    kept = np.setdiff1d(np.arange(len(mesh.triangles)), parted)
    of = np.concatenate([kept, *(owner for _, owner in halves)])
    triangles = np.concatenate([mesh.triangles[kept], *(part for part, _ in halves)])
    at, normals, patch = _places(mesh, edges, chosen)
    ends = edges.ends[chosen]
    grown = replace(
        mesh,
        vertices=np.concatenate([mesh.vertices, (mesh.vertices[ends[:, 0]] + mesh.vertices[ends[:, 1]]) / 2.0]),
        normals=np.concatenate([mesh.normals, normals]),
        at=np.concatenate([mesh.at, at]),
        patch=np.concatenate([mesh.patch, patch]),
        triangles=triangles,
        triangle_patch=mesh.triangle_patch[of],
    )
    finer = np.where(np.arange(len(of)) < len(kept), 1.0, 0.25)
    return grown, light.joined(middle[chosen]), rough[of] * finer
