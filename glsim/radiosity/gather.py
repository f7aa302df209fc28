"""From the radiosity of patches to the radiosity of vertices.

A final gather collects the light of all patches once more at each vertex, as if the vertex were a small patch.
``averaged`` takes the mean of the patches around a vertex instead, as textbooks do (Cohen & Wallace 1993, section 9.1).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.compiled import jit
from glsim.radiosity.factors import Factors
from glsim.radiosity.hidden import covered
from glsim.radiosity.lamps import Lamps
from glsim.radiosity.mesh import PatchMesh
from glsim.radiosity.patches import Patches
from glsim.radiosity.polygon import MOST_CORNERS, area, at_point, bilinear
from glsim.radiosity.progress import Progress, silent
from glsim.radiosity.visibility import EFFORTS

Float = NDArray[np.float64]
Int = NDArray[np.int64]
AT_ONCE = 1024  # points
PARTS = 4  # along each edge of a patch, of which near points see different radiosities
SAMPLES = 12  # vertices of a cluster at which bounced light is gathered; at the others it is interpolated
MOST = 0.05  # by which bounced light is scaled, see Gatherer.balanced
NEAR = 0.02  # from this form factor on a patch is near, below it evenly bright


@dataclass(frozen=True)
class Light:
    """Irradiance at k points.  direct: (k, 3), straight from lamps; bounced: (k, 3), what other surfaces reflect."""

    direct: Float
    bounced: Float

    @property
    def both(self) -> Float:
        """All that arrives, (k, 3)."""
        return self.direct + self.bounced

    def __getitem__(self, chosen: Any) -> Light:
        return Light(self.direct[chosen], self.bounced[chosen])

    def between(self, one: Int, two: Int) -> Light:
        """Return the means of the light at the points ``one`` (m,) and ``two`` (m,)."""
        return Light((self.direct[one] + self.direct[two]) / 2.0, (self.bounced[one] + self.bounced[two]) / 2.0)

    def joined(self, other: Light) -> Light:
        """Return the light at these points and after them at those of another."""
        return Light(np.concatenate([self.direct, other.direct]), np.concatenate([self.bounced, other.bounced]))


@dataclass(frozen=True, repr=False)
class Gatherer:
    """Finds irradiance at points of a solved scene.

    B: (n, 3), the radiosity of the patches; lamps: whose light is gathered apart; parts: (n, PARTS^2, 3), the reflected
    radiosity of the parts of each patch, which matters for near patches; None: all parts are alike.
    """

    factors: Factors
    B: Float
    lamps: Lamps
    parts: Float | None = None
    tell: Progress = silent

    @property
    def patches(self) -> Patches:
        return self.factors.patches

    def direct(self, points: Float, normals: Float) -> Float:
        """Return the irradiance (k, 3) straight from lamps at points (k, 3) with unit normals (k, 3)."""
        return self.lamps.at_points(raised(self.patches, points, normals), normals)

    def bounced(self, points: Float, normals: Float, patch: Int) -> Float:
        """Return the irradiance (k, 3) by reflected light at points (k, 3), with unit normals (k, 3), on ``patch``."""
        H = irradiance_at(self.factors, points, normals, patch, self.B - self.patches.E, self.tell)
        if self.parts is not None:
            H = np.maximum(H + unevenness(self.factors, points, normals, self.parts), 0.0)
        return H

    def covered(self, points: Float, normals: Float) -> NDArray[np.bool_]:
        """Return whether points (k, 3) with unit normals (k, 3) are inside of bodies: (k,)."""
        return covered(self.factors.visibility.rays, points, normals)

    def on(self, mesh: PatchMesh) -> tuple[Light, Gatherer]:
        """Return the irradiance at the vertices of the patches' mesh, and a gatherer that knows the patches' parts.

        The first gather takes the radiosity of each patch as constant.  Then direct light is gathered at the middles of
        all parts of the patches, bounced light is bilinear between their corners, and together they correct the light
        from near patches, twice.  A vertex inside a body, whose triangles reach out of it, takes the mean of the
        patches around it.
        """
        p = self.patches
        at, normals, patch = mesh.at, mesh.normals, mesh.patch
        some = _sampled(p, patch)
        direct, even = self.direct(at, normals), np.zeros((len(at), 3))
        even[some] = self.bounced(at[some], normals[some], patch[some])
        middles = bilinear_parts(p.corners)
        lit = self.direct(middles.reshape(-1, 3), np.repeat(p.normal, PARTS**2, axis=0)).reshape(middles.shape)
        bounced, parts = even, np.zeros((len(p), PARTS**2, 3))
        for _ in range(2):  # the second time with the corners that the first one corrected
            parts = self._scaled(p.rho[:, None] * (lit + bilinear_parts(bounced[mesh.corners])))
            parts[p.is_cluster] = (self.B - p.E)[p.is_cluster, None]
            bounced = even.copy()
            bounced[some] += unevenness(self.factors, at[some], normals[some], parts)
            bounced = _filled(np.maximum(bounced, 0.0), some, mesh, p)
        inside = self.covered(at, normals)[:, None]
        reflecting = np.maximum(p.rho, 1e-9)
        around = averaged(p, mesh, (self.B - p.E) / reflecting) - direct
        light = Light(direct, np.where(inside, np.maximum(around, 0.0), bounced))
        return light, replace(self, parts=parts)

    def balanced(self, mesh: PatchMesh, light: Light) -> Light:
        """Return light at a mesh's vertices, scaled so that as much bounced light arrives at each wall and each smooth
        body as in the solution.

        A gather takes patches that are not near as evenly bright, and so loses or wins some tenths of a percent.
        """
        p = self.patches
        group = p.group
        solved = np.zeros((group.max() + 1, 3))
        np.add.at(solved, group, self.factors.times(self.B - p.E))
        shown = np.zeros_like(solved)
        mean = light.bounced[mesh.triangles].mean(axis=1)
        np.add.at(shown, group[mesh.triangle_patch], mesh.areas[:, None] * mean)
        scale = np.divide(solved, shown, out=np.ones_like(solved), where=shown > 0.0)
        return replace(light, bounced=light.bounced * np.clip(scale, 1.0 - MOST, 1.0 + MOST)[group[mesh.patch]])

    def _scaled(self, parts: Float) -> Float:
        """Return the reflected radiosity of the patches' parts (n, PARTS^2, 3), scaled so that each patch's mean is its
        own."""
        mean, true = parts.mean(axis=1), self.B - self.patches.E
        return np.asarray(parts * np.divide(true, mean, out=np.ones_like(true), where=mean > 0.0)[:, None])


def _sampled(patches: Patches, patch: Int) -> Int:
    """Return the numbers of the vertices, on the patches ``patch`` (V,), at which bounced light is gathered.

    All are, but of a cluster only about SAMPLES.
    """
    many = np.where(patches.is_cluster, np.bincount(patch, minlength=len(patches)) // SAMPLES, 1)
    order = np.argsort(patch, kind="stable")
    place = np.arange(len(order)) - np.searchsorted(patch[order], patch[order])
    return np.sort(order[place % np.maximum(many[patch[order]], 1) == 0])


def _filled(values: Float, some: Int, mesh: PatchMesh, patches: Patches) -> Float:
    """Return values at all vertices (V, 3) from those at ``some`` of them: a mean of the nearest four.

    Near are vertices of clusters at the same place that look to the same side.
    """
    from scipy.spatial import cKDTree

    missing = np.setdiff1d(np.arange(len(values)), some)
    if not len(missing):
        return values
    known = some[patches.is_cluster[mesh.patch[some]]]
    size = float(patches.size[patches.is_cluster].mean())
    place = np.concatenate([mesh.vertices / size, mesh.normals], axis=1)
    apart, nearest = cKDTree(place[known]).query(place[missing], k=min(4, len(known)))
    weight = 1.0 / (apart.reshape(len(missing), -1, 1) ** 2 + 1e-6)
    near = values[known[nearest.reshape(len(missing), -1)]]
    values[missing] = (weight * near).sum(axis=1) / weight.sum(axis=1)
    return values


def bilinear_parts(corners: Float) -> Float:
    """Return values at the middles of each patch's parts (n, PARTS^2, 3), bilinear between its corners (n, 4, 3)."""
    t = (np.arange(PARTS) + 0.5) / PARTS
    u, v = np.tile(t, PARTS), np.repeat(t, PARTS)
    weight = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=1)
    return np.asarray(np.einsum("pc,nck->npk", weight, corners))


def raised(patches: Patches, points: Float, normals: Float) -> Float:
    """Return points (k, 3) moved along their normals (k, 3), off the surfaces on which they lie."""
    return points + 1e-6 * patches.scene.size * normals


def irradiance_at(
    factors: Factors, points: Float, normals: Float, patch: Int, B: Float, progress: Progress | None = None
) -> Float:
    """Return the irradiance (k, 3) at points from all patches.

    points: (k, 3), with unit normals (k, 3), on the patches numbered ``patch`` (k,); B: (n, 3) of the patches.
    """
    tell = progress or silent
    above = raised(factors.patches, points, normals)
    H = np.empty((len(points), 3))
    for first in range(0, len(points), AT_ONCE):
        now = slice(first, min(first + AT_ONCE, len(points)))
        H[now] = factors.at_points(above[now], normals[now], patch[now], B)
        tell("vertices", now.stop, len(points))
    return H


def radiosity_at(
    factors: Factors, points: Float, normals: Float, patch: Int, B: Float, progress: Progress | None = None
) -> Float:
    """Return the radiosity (k, 3) at points: E + rho times their irradiance, see ``irradiance_at``."""
    p = factors.patches
    return np.asarray(p.E[patch] + p.rho[patch] * irradiance_at(factors, points, normals, patch, B, progress))


def gathered(factors: Factors, mesh: PatchMesh, B: Float, progress: Progress | None = None) -> Float:
    """Return the radiosity at the vertices of the patches' mesh (V, 3), from the radiosity B (n, 3) of the patches."""
    p = factors.patches
    lamps = Lamps.of(p, factors.visibility)
    light, _ = Gatherer(factors, B, lamps, tell=progress or silent).on(mesh)
    return np.asarray(p.E[mesh.patch] + p.rho[mesh.patch] * light.both)


def unevenness(factors: Factors, points: Float, normals: Float, parts: Float) -> Float:
    """Return how much the irradiance at points changes if near patches are not evenly bright: (k, 3).

    points: (k, 3), with unit normals (k, 3); parts: (n, PARTS^2, 3), the radiosity of the patches' parts.
    """
    from scipy.spatial import cKDTree

    patches = factors.patches
    points = points + 1e-6 * patches.scene.size * normals
    uneven = np.flatnonzero(~patches.is_cluster)
    around = cKDTree(points).query_ball_point(patches.center[uneven], patches.size[uneven])
    columns = np.repeat(uneven, [len(some) for some in around])
    rows = np.concatenate([np.asarray(some, np.int64) for some in around])
    added = np.zeros((len(rows), 3))

    def some(first: int, last: int) -> None:
        p, here = patches, slice(first, last)
        of = (p.corners, p.counts, p.normal, columns[here], parts)
        _uneven(points, normals, rows[here], *of, NEAR, added[here])

    factors.visibility.rays.share(some, len(rows), 4096)
    near = np.flatnonzero(added.any(axis=1))
    rows, columns, added = rows[near], columns[near], added[near]
    many = np.full(len(rows), len(EFFORTS) - 1)
    seen = factors.visibility.from_points(points, normals, patches, rows, columns, many)
    return np.stack([np.bincount(rows, seen * added[:, k], len(points)) for k in range(3)], axis=1)


@jit
def _uneven(
    points: Any, normals: Any, rows: Any, corners: Any, counts: Any, patch_normals: Any, columns: Any, bright: Any,
    least: float, out: Any,
) -> None:  # fmt: skip
    """Write how the irradiance at points[rows] changes if patches[columns] are not evenly bright, into out (k, 3).

    rows, columns: (k,).  The change is the light from all parts of a patch, each with its own radiosity ``bright``
    (n, PARTS^2, 3), minus the light from the whole patch with their mean.  Form factors below ``least`` give 0.
    Occlusion is ignored.
    """
    parts = PARTS
    work, part = np.empty((MOST_CORNERS, 3)), np.empty((4, 3))
    value, total = np.zeros(3), np.zeros(3)
    for row in range(len(rows)):
        v, j = rows[row], columns[row]
        whole = at_point(points[v], normals[v], corners[j], counts[j], patch_normals[j], work)
        if whole < least:
            continue
        whole_area = 0.0
        for k in range(3):
            value[k] = total[k] = 0.0
        for s in range(parts):
            for t in range(parts):
                for c in range(4):
                    u, w = (s + (c == 1 or c == 2)) / parts, (t + (c >= 2)) / parts
                    for k in range(3):
                        part[c, k] = bilinear(corners[j], u, w, k)
                factor = at_point(points[v], normals[v], part, 4, patch_normals[j], work)
                weight = area(part, 4)
                whole_area += weight
                for k in range(3):
                    b = bright[j, t * parts + s, k]
                    value[k] += factor * b
                    total[k] += weight * b
        for k in range(3):
            out[row, k] = value[k] - whole * total[k] / whole_area


def averaged(patches: Patches, mesh: PatchMesh, B: Float) -> Float:
    """Return the radiosity at the vertices (V, 3): the mean of the patches around, weighted by their areas."""
    vertex, patch = np.divmod(
        np.unique(mesh.triangles.ravel() * len(patches) + np.repeat(mesh.triangle_patch, 3)), len(patches)
    )
    area = patches.area[patch]
    weight = np.bincount(vertex, area, len(mesh.vertices))
    return np.stack([np.bincount(vertex, area * B[patch, k], len(weight)) / weight for k in range(3)], axis=1)
