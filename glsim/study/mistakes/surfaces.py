"""The triangles of a Draw in eye space and on the screen: which way they turn, and where their normals point."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import counterclockwise
from glsim.machine.frame import Draw
from glsim.machine.stage import vertex_stage
from glsim.shading import normalize

Float = NDArray[np.float64]
Bool = NDArray[np.bool_]
FAR = 1e30  # numbers that are larger, or none, are of no use here
MAX_TRIANGLES = 3000  # of a Draw that are looked at


@dataclass
class Surface:
    """n triangles.  points: corners in eye space (n, 3, 3); clip: the same in clip coordinates (n, 3, 4).  turned: unit
    vectors (n, 3) on the side from which the corners run counterclockwise; (0, 0, 0) for triangles without area.
    normals: the mean normal of the corners (n, 3), unit or (0, 0, 0)."""

    points: Float
    clip: Float
    turned: Float
    normals: Float

    def __len__(self) -> int:
        return len(self.points)

    @cached_property
    def cosine(self) -> Float:
        """Of the angle between normal and ``turned``, (n,); 0 where one of them is missing."""
        return np.asarray((self.turned * self.normals).sum(axis=1))

    @cached_property
    def outward(self) -> Float:
        """Of the angle between the normal and the way from the middle of all to a triangle, (n,)."""
        return np.asarray((normalize(self.points.mean(axis=1) - self.middle) * self.normals).sum(axis=1))

    @cached_property
    def middle(self) -> Float:
        flat = self.points.reshape(-1, 3)
        return np.asarray((flat.min(axis=0) + flat.max(axis=0)) / 2.0)

    @cached_property
    def solid(self) -> bool:
        """Whether it is no flat thing."""
        spread = np.linalg.svd(self.points.reshape(-1, 3) - self.middle, compute_uv=False)
        return bool(spread[-1] > 1e-2 * spread[0])

    @property
    def eye_inside(self) -> bool:
        """Whether the eye of a perspective projection is within the box around the corners."""
        flat = self.points.reshape(-1, 3)
        perspective = bool(np.ptp(self.clip[..., 3]) > 0.0)
        return perspective and bool((flat.min(axis=0) < 0).all() and (flat.max(axis=0) > 0).all())

    @cached_property
    def closed(self) -> bool:
        """Whether each edge is between two triangles: nothing can be seen through a hole."""
        flat = self.points.reshape(-1, 3)
        size = float(np.ptp(flat, axis=0).max()) or 1.0
        keys, corner = np.unique(np.round(flat / size * 1e4).astype(np.int64), axis=0, return_inverse=True)
        triangles = corner.reshape(-1, 3)
        distinct = (triangles[:, 0] != triangles[:, 1]) & (triangles[:, 1] != triangles[:, 2])
        triangles = triangles[distinct & (triangles[:, 0] != triangles[:, 2])]
        edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        counts = np.unique(edges[:, 0] * len(keys) + edges[:, 1], return_counts=True)[1]
        return len(counts) > 3 and bool((counts == 2).all())

    @property
    def volume(self) -> float:
        """Of what a closed surface encloses: negative if its triangles turn clockwise seen from outside."""
        a, b, c = ((self.points - self.middle)[:, k] for k in range(3))
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)

    def front(self, front_face: int) -> Bool:
        """Which triangles (n,) show their front on the screen."""
        return np.asarray(counterclockwise(self.clip) == (front_face == gl.GL_CCW))


def surface(draw: Draw, chosen: NDArray[np.uint32]) -> Surface:
    """chosen: the vertices of the triangles of ``draw``, three each."""
    numbers, places = np.unique(chosen[: 3 * MAX_TRIANGLES], return_inverse=True)
    stage = vertex_stage(draw, numbers, 0, colors=False)
    places = places.reshape(-1, 3)
    with np.errstate(all="ignore"):
        points = np.clip(np.nan_to_num((stage.eye[:, :3] / stage.eye[:, 3:])[places]), -FAR, FAR)
    turned = np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
    mean = np.nan_to_num(normalize(stage.normal))[places].sum(axis=1)
    return Surface(points, stage.clip[places], normalize(turned), normalize(mean))


def joined(parts: list[Surface]) -> Surface:
    """The triangles of several as one."""
    names = ("points", "clip", "turned", "normals")
    return Surface(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))
