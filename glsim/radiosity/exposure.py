"""Leaving out what cannot be seen: patches inside of a body that stands on them, or behind a coplanar lamp."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.contacts import MANY, TOUCHING
from glsim.radiosity.patches import Patches, patches_from
from glsim.radiosity.scene import SceneError, area_of, normal_of

Float = NDArray[np.float64]


def exposed(patches: Patches) -> Patches:
    """Without patches that are covered: inside of a body that stands on them, or behind a coplanar lamp.

    A patch is covered where most rays from it meet the backs of others, or where a smaller polygon of its own plane
    lies on it.
    """
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    scene = patches.scene
    embree = EmbreeScene()
    triangles = scene.triangles()
    middle = triangles.mean(axis=(0, 1))  # around which single precision is enough
    TriangleMesh(embree, np.ascontiguousarray(triangles - middle, np.float32))
    owner = np.array([k for k, ring in enumerate(scene.rings) for _ in range(len(ring) - 2)])
    normals = np.array([normal_of(ring) for ring in scene.rings])
    lift = 1e-4 * scene.size
    covered = np.zeros(len(patches), np.int64)
    ways = _fan(patches.normal)
    for way in np.moveaxis(ways, 1, 0):
        origins = (patches.center - middle + lift * patches.normal).astype(np.float32)
        hit = embree.run(origins, np.ascontiguousarray(way, np.float32))
        met = owner[np.maximum(hit, 0)]
        covered += (hit >= 0) & (np.einsum("nk,nk->n", normals[met], way) > 1e-9)
    hidden = covered > ways.shape[1] // 2
    hidden |= _behind_coplanar(patches, normals)
    if not hidden.any():
        return patches
    if np.average(hidden, weights=patches.area) > 0.9:
        raise SceneError(
            f"{scene.name}: nearly all fronts look at backs: are the normals inverted? A room shows its fronts inside;"
            " --flip turns them"
        )
    note = f"patches left out, inside of bodies or behind coplanar polygons: {hidden.sum()}"
    return patches_from(
        replace(scene, notes=(*scene.notes, note)), *(values[~hidden] for values in
        (patches.rings, patches.counts, patches.polygon, patches.level))
    )  # fmt: skip


def _fan(normals: Float) -> Float:
    """Five directions about each normal: (n, 5, 3)."""
    other = np.where(np.abs(normals[:, :1]) < 0.7, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    t = np.cross(normals, other)
    t /= np.linalg.norm(t, axis=1, keepdims=True)
    b = np.cross(normals, t)
    return np.stack([normals, *(normals + 0.8 * side for side in (t, -t, b, -b))], axis=1)


def _behind_coplanar(patches: Patches, normals: Float) -> NDArray[np.bool_]:
    """Patches whose middle lies on another polygon of the same plane: a smaller one that looks the same way, which is
    seen instead, or one that looks the other way, which lies face to face."""
    scene = patches.scene
    hidden = np.zeros(len(patches), bool)
    areas = np.array([area_of(ring) for ring in scene.rings])
    if len(scene.rings) > MANY:
        return hidden
    tolerance = TOUCHING * scene.size
    for number, ring in enumerate(scene.rings):
        cosine = patches.normal @ normals[number]
        smaller = (cosine > 1.0 - 1e-6) & (areas[patches.polygon] > areas[number] * (1.0 + 1e-9))
        there = (smaller | (cosine < -1.0 + 1e-6)) & (patches.polygon != number)
        there &= np.abs((patches.center - ring[0]) @ normals[number]) < tolerance
        inward = np.cross(normals[number], np.roll(ring, -1, axis=0) - ring)
        to = patches.center[there][:, None] - ring
        hidden[there] |= ((to * inward).sum(axis=2) > 0.0).all(axis=1)
    return hidden
