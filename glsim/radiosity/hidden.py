"""Leaving out what cannot be seen: patches inside of a body that stands on them, or behind a coplanar lamp."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.contacts import LAYER, TOUCHING
from glsim.radiosity.near import overlapping
from glsim.radiosity.patches import Patches, patches_from
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Scene, SceneError

Float = NDArray[np.float64]
Int = NDArray[np.int64]
RAYS = 9  # from a point, see _fan
FLAT = 1.0 - 1e-6  # the cosine between the normals of two layers
SHIFT = 2e-5  # of the scene's size: how far coinciding polygons are moved apart


def exposed(patches: Patches, rays: Rays) -> Patches:
    """Return the patches without those that nobody can see.

    Three kinds are left out.  A patch inside a body: nearly all rays from its middle and from near its corners meet the
    backs of polygons.  A patch behind another layer, as a lamp in the ceiling or a rug on the floor: a polygon of the
    same front lies on it or a hair's breadth before it, see ``_coplanar``.  A patch under a body that stands on it, as
    the floor under a crate: a coplanar polygon of the opposite front lies on it, and all rays meet backs, or the whole
    scene is behind the patch's plane.

    Raises SceneError if nearly everything would be left out: then the normals are inverted.
    """
    scene = patches.scene
    hidden = covered(rays, patches.center, patches.normal)
    for corner in range(4):
        chosen = np.flatnonzero(hidden)
        near = 0.9 * patches.corners[chosen, corner] + 0.1 * patches.center[chosen]
        hidden[chosen] = covered(rays, near, patches.normal[chosen], least=0)
    smaller, opposite = _coplanar(patches)
    hidden |= smaller
    under = np.flatnonzero(opposite)
    fronts, backs, unclear = count_faces(rays, patches.center[under], patches.normal[under])
    shut = backs + unclear == RAYS
    for corner in range(4):  # the end of a beam may hide the middle of a patch alone
        chosen = np.flatnonzero(shut)
        near = 0.9 * patches.corners[under[chosen], corner] + 0.1 * patches.center[under[chosen]]
        _, backs, unclear = count_faces(rays, near, patches.normal[under[chosen]])
        shut[chosen] = backs + unclear == RAYS
    hidden[under] |= (fronts == 0) & (shut | _faces_outwards(patches, under))
    if not hidden.any():
        return patches
    if np.average(hidden, weights=patches.area) > 0.9:
        raise SceneError(
            f"{scene.name}: nearly all fronts look at backs: are the normals inverted? A room shows its fronts inside;"
            " --flip turns them"
        )
    note = f"patches left out, inside of bodies or behind coplanar polygons: {hidden.sum()}"
    p, seen = patches, ~hidden
    noted = replace(scene, notes=(*scene.notes, note))
    return patches_from(noted, p.corners[seen], p.counts[seen], p.polygon[seen], p.level[seen])


def covered(rays: Rays, points: Float, normals: Float, least: int = 3) -> NDArray[np.bool_]:
    """Return whether points (n, 3) on surfaces with unit normals (n, 3) are inside of a body: (n,).

    A point counts as inside if at least ``least`` of its nine rays meet the backs of polygons, and none meets a
    front or nothing; if eight rays meet backs, the ninth does not matter.
    """
    fronts, backs, unclear = count_faces(rays, points, normals)
    nothing = RAYS - fronts - backs - unclear
    return np.asarray((backs >= least) & (fronts + nothing <= backs // 8))


def count_faces(rays: Rays, points: Float, normals: Float) -> tuple[Int, Int, Int]:
    """Send nine rays from each point (n, 3) to the side of its unit normal (n, 3), and count what they meet.

    Returns the numbers of fronts, of backs, and of unclear cases, (n,) each.  A case is unclear where two polygons
    coincide and one shows its front, the other its back: it is found by sending each ray twice, once with all polygons
    moved a little along their normals, and once with all moved back.
    """
    scene = rays.scene
    origins = (points - rays.middle + 1e-4 * scene.size * normals).astype(np.float32)
    facing = np.zeros((2, RAYS, len(points)), np.int64)  # 1: a front, -1: a back, 0: nothing
    for which, shift in enumerate((SHIFT, -SHIFT)):
        for number, direction in enumerate(np.moveaxis(_fan(normals), 1, 0) if len(points) else ()):
            hit = rays.nearest(origins, direction, shift)
            cosine = np.einsum("nk,nk->n", scene.normals[np.maximum(hit, 0)], direction)
            facing[which, number] = np.where(hit >= 0, -np.sign(np.round(cosine, 9)), 0)
    same = facing[0] == facing[1]
    counts = [(same & (facing[0] == kind)).sum(axis=0) for kind in (1, -1)]
    return counts[0], counts[1], (~same).sum(axis=0)


def _faces_outwards(patches: Patches, chosen: Int) -> NDArray[np.bool_]:
    """Return for each of the ``chosen`` patches whether the whole scene is behind its plane."""
    points = np.concatenate(patches.scene.polygons)
    beyond = np.array([(points @ direction).max() - middle @ direction for middle, direction in
                   zip(patches.center[chosen], patches.normal[chosen], strict=True)])  # fmt: skip
    return beyond < TOUCHING * patches.scene.size


def _fan(normals: Float) -> Float:
    """Return nine directions (n, 9, 3): each unit normal (n, 3), four at 39 and four at 80 degrees from it."""
    other = np.where(np.abs(normals[:, :1]) < 0.7, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    t = np.cross(normals, other)
    t /= np.linalg.norm(t, axis=1, keepdims=True)
    b = np.cross(normals, t)
    sides = [slope * side for slope, side in ((0.8, t), (0.8, b), (4.0, t + b), (4.0, t - b))]
    return np.stack([normals, *(normals + side for side in sides), *(normals - side for side in sides)], axis=1)


def _coplanar(patches: Patches) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Find the patches whose middle lies on another polygon, no further from it than rays can tell.

    Returns two masks (n,): the other polygon has the same front and is seen instead, because it lies a little in front
    or is the smaller one in the same plane (of two equal ones the later); the other polygon has the opposite front.
    """
    scene = patches.scene
    exact, layer = TOUCHING * scene.size, LAYER * scene.size
    low, high = (np.array([f(polygon, axis=0) for polygon in scene.polygons]) for f in (np.min, np.max))
    patch, number = overlapping((patches.center, patches.center), (low - layer, high + layer))
    cosine = np.einsum("nk,nk->n", patches.normal[patch], scene.normals[number])
    first = np.array([polygon[0] for polygon in scene.polygons])
    ahead = np.einsum("nk,nk->n", first[number] - patches.center[patch], patches.normal[patch])
    on = (np.abs(cosine) > FLAT) & (patches.polygon[patch] != number) & (np.abs(ahead) < layer)
    patch, number, cosine, ahead = patch[on], number[on], cosine[on], ahead[on]
    on = _inside(scene, number, patches.center[patch])
    own, other = scene.areas[patches.polygon[patch]], scene.areas[number]
    equal = np.abs(own - other) <= 1e-9 * own
    wins = (other < own) & ~equal | equal & (number > patches.polygon[patch])
    in_front = np.where(np.abs(ahead) < exact, wins, ahead > 0.0)
    results = np.zeros((2, len(patches)), bool)
    results[0, patch[on & (cosine > 0.0) & in_front]] = True
    results[1, patch[on & (cosine < 0.0) & (np.abs(ahead) < exact)]] = True
    return results[0], results[1]


def _inside(scene: Scene, number: Int, points: Float) -> NDArray[np.bool_]:
    """Return whether points (k, 3) are inside of the polygons ``number`` (k,), looked at along their normals: (k,)."""
    result = np.zeros(len(number), bool)
    for numbers, corners in scene.by_corners:
        of = np.flatnonzero(np.isin(number, numbers))
        some = corners[np.searchsorted(numbers, number[of])]
        inward = np.cross(scene.normals[number[of], None], np.roll(some, -1, axis=1) - some)
        result[of] = (((points[of, None] - some) * inward).sum(axis=2) > 0.0).all(axis=1)
    return result
