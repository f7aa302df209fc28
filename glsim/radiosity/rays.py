"""Rays through a scene, with one pool of threads and one Embree tree for each shift of the polygons (see nearest).

Hidden-patch removal, form factors and the final gather share one object, Rays.  Embree calculates in single precision,
so all coordinates are counted from the middle of the scene, wherever the scene is.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.bodies import GAP
from glsim.radiosity.scene import Scene

Float = NDArray[np.float64]
Single = NDArray[np.float32]
Int = NDArray[np.int64]


class Rays:
    """The triangles of a scene, and the threads in which rays are sent against them.

    middle: (3,), the origin of all rays' coordinates; gap: how far in front of polygons rays begin and end, in the
    scene's unit; owner: (m,), the polygon of each triangle; pool: as many threads as were asked for, by default one for
    each processor.
    """

    def __init__(self, scene: Scene, threads: int | None = None) -> None:
        self.scene = scene
        triangles = scene.triangles()
        self.middle = (triangles.min(axis=(0, 1)) + triangles.max(axis=(0, 1))) / 2.0
        self.gap = GAP * scene.size
        self.owner = np.repeat(np.arange(len(scene.polygons)), [len(polygon) - 2 for polygon in scene.polygons])
        self.pool = ThreadPoolExecutor(threads or os.cpu_count() or 1)
        self.trees = {0.0: _tree(triangles - self.middle)}
        self.local = threading.local()

    def share(self, work: Callable[[int, int], object], count: int, step: int) -> None:
        """Call ``work(first, last)`` for all parts of 0 to ``count`` that are ``step`` long, in all threads."""
        list(self.pool.map(lambda k: work(k, min(k + step, count)), range(0, count, step)))

    def blocked(self, origins: Single, directions: Single) -> NDArray[np.bool_]:
        """Whether each ray meets a triangle: (n,).

        origins: (n, 3), from the middle; directions: (n, 3), as long as the rays.
        """
        lengths = self._lengths(len(origins))
        hit = self.trees[0.0].run(origins, directions, dists=lengths, query="OCCLUDED")
        return np.asarray(hit >= 0)

    def between(self, starts: Float, ends: Float) -> NDArray[np.bool_]:
        """Whether points (n, 3) see the points ``ends`` (n, 3), both in the scene's coordinates: (n,)."""
        direction = ends - starts
        off = np.minimum(self.gap / np.maximum(np.linalg.norm(direction, axis=1), 1e-300), 0.5)[:, None]
        origins = (starts - self.middle + off * direction).astype(np.float32)
        return ~self.blocked(origins, ((1.0 - 2.0 * off) * direction).astype(np.float32))

    def nearest(self, origins: Single, directions: Float, shift: float) -> Int:
        """Return the number of the polygon that each endless ray meets first, (n,), or -1.

        origins: (n, 3), from the middle; directions: (n, 3); shift: how far all polygons are moved along their normals
        before that, as a part of the scene's size.
        """
        if shift not in self.trees:
            moved = self.scene.triangles() + shift * self.scene.size * self.scene.normals[self.owner, None]
            self.trees[shift] = _tree(moved - self.middle)
        triangle = self.trees[shift].run(origins, np.ascontiguousarray(directions, np.float32))
        return np.where(triangle >= 0, self.owner[np.maximum(triangle, 0)], -1)

    def _lengths(self, count: int) -> Single:
        """Return ones (count,): how far rays go along their directions.  Each thread reuses its own array."""
        lengths = getattr(self.local, "lengths", None)
        if lengths is None or len(lengths) < count:
            lengths = self.local.lengths = np.empty(count, np.float32)
        lengths[:count] = 1.0
        return np.asarray(lengths[:count])


def _tree(triangles: Float) -> Any:
    """Build Embree's tree of triangles (m, 3, 3), ready for threads."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    tree = EmbreeScene()
    TriangleMesh(tree, np.ascontiguousarray(triangles, np.float32))
    tree.run(np.zeros((1, 3), np.float32), np.ones((1, 3), np.float32))  # the first ray builds it
    return tree
