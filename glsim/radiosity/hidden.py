"""Leaving out what cannot be seen: patches inside of a body that stands on them, or behind a coplanar lamp."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.contacts import MANY, TOUCHING
from glsim.radiosity.patches import Patches, patches_from
from glsim.radiosity.scene import Scene, SceneError, area_of, normal_of

Float = NDArray[np.float64]
Int = NDArray[np.int64]
RAYS = 9  # from a point, see _fan


def exposed(patches: Patches) -> Patches:
    """Without patches that are covered: inside of a body that stands on them, or behind a coplanar lamp.

    A patch is covered where nearly all rays from its middle and from near its corners meet the backs of others;
    where a smaller polygon of its own plane lies on it; or where one of its plane looks the other way, as a floor does
    to a crate's bottom, and all rays meet backs, or there is nothing at all on the side to which it looks.
    """
    scene = patches.scene
    normals = np.array([normal_of(ring) for ring in scene.rings])
    hidden = covered(scene, patches.center, patches.normal)
    for corner in range(4):
        some = np.flatnonzero(hidden)
        near = 0.9 * patches.rings[some, corner] + 0.1 * patches.center[some]
        hidden[some] = covered(scene, near, patches.normal[some], least=0)
    smaller, opposite = _coplanar(patches, normals)
    hidden |= smaller
    there = np.flatnonzero(opposite)
    fronts, backs, both = met(scene, patches.center[there], patches.normal[there])
    hidden[there] |= (fronts == 0) & ((backs + both == RAYS) | _at_the_end(patches, there))
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
    return patches_from(noted, p.rings[seen], p.counts[seen], p.polygon[seen], p.level[seen])


def covered(scene: Scene, points: Float, ways: Float, least: int = 3) -> NDArray[np.bool_]:
    """Whether points (n, 3) with normals are inside of something: rays from them, at least so many, meet backs."""
    fronts, backs, both = met(scene, points, ways)
    missed = RAYS - fronts - backs - both
    return np.asarray((backs >= least) & (fronts + missed <= backs // 8))


def met(scene: Scene, points: Float, ways: Float) -> tuple[Int, Int, Int]:
    """How many of nine rays from points (n, 3) with normals meet fronts, how many backs, and how many a place where one
    polygon shows its front and another its back, (n,) each: nobody can say which comes first."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    owner = np.array([k for k, ring in enumerate(scene.rings) for _ in range(len(ring) - 2)])
    normals = np.array([normal_of(ring) for ring in scene.rings])
    middle = scene.triangles().mean(axis=(0, 1))  # around which single precision is enough
    origins = (points - middle + 1e-4 * scene.size * ways).astype(np.float32)
    facing = np.zeros((2, RAYS, len(points)), np.int64)  # 1: a front, -1: a back, 0: nothing
    for which, shift in enumerate((2e-5, -2e-5)):  # polygons a little before or behind where they are
        embree = EmbreeScene()
        triangles = scene.triangles() - middle + shift * scene.size * normals[owner, None]
        TriangleMesh(embree, np.ascontiguousarray(triangles, np.float32))
        for number, way in enumerate(np.moveaxis(_fan(ways), 1, 0) if len(points) else ()):
            hit = embree.run(origins, np.ascontiguousarray(way, np.float32))
            cosine = np.einsum("nk,nk->n", normals[owner[np.maximum(hit, 0)]], way)
            facing[which, number] = np.where(hit >= 0, -np.sign(np.round(cosine, 9)), 0)
    same = facing[0] == facing[1]
    counts = [(same & (facing[0] == kind)).sum(axis=0) for kind in (1, -1)]
    return counts[0], counts[1], (~same).sum(axis=0)


def _at_the_end(patches: Patches, chosen: Int) -> NDArray[np.bool_]:
    """Of which patches the whole scene is behind."""
    points = np.concatenate(patches.scene.rings)
    to = np.array([(points @ way).max() - middle @ way for middle, way in
                   zip(patches.center[chosen], patches.normal[chosen], strict=True)])  # fmt: skip
    return to < TOUCHING * patches.scene.size


def _fan(normals: Float) -> Float:
    """Nine directions about each normal, the last four far from it: (n, 9, 3)."""
    other = np.where(np.abs(normals[:, :1]) < 0.7, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    t = np.cross(normals, other)
    t /= np.linalg.norm(t, axis=1, keepdims=True)
    b = np.cross(normals, t)
    sides = [slope * side for slope, side in ((0.8, t), (0.8, b), (4.0, t + b), (4.0, t - b))]
    return np.stack([normals, *(normals + side for side in sides), *(normals - side for side in sides)], axis=1)


def _coplanar(patches: Patches, normals: Float) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Patches whose middle lies on another polygon of the same plane: on a smaller one that looks the same way, and so
    is seen instead; on one that looks the other way."""
    scene = patches.scene
    smaller, opposite = np.zeros(len(patches), bool), np.zeros(len(patches), bool)
    areas = np.array([area_of(ring) for ring in scene.rings])
    if len(scene.rings) > MANY:
        return smaller, opposite
    tolerance = TOUCHING * scene.size
    for number, ring in enumerate(scene.rings):
        cosine = patches.normal @ normals[number]
        there = (np.abs(cosine) > 1.0 - 1e-6) & (patches.polygon != number)
        there &= np.abs((patches.center - ring[0]) @ normals[number]) < tolerance
        inward = np.cross(normals[number], np.roll(ring, -1, axis=0) - ring)
        to = patches.center[there][:, None] - ring
        there[there] = ((to * inward).sum(axis=2) > 0.0).all(axis=1)
        smaller |= there & (cosine > 0.0) & (areas[patches.polygon] > areas[number] * (1.0 + 1e-9))
        opposite |= there & (cosine < 0.0)
    return smaller, opposite
