"""A final gather at every pixel: the picture that no mesh has spoilt, and what the meshes lose beside it.

The solution tells how much light each patch sends.  For the reference picture that light is gathered once more at the
point that each pixel shows, with the lamps' light by rays, so that nothing is interpolated.  Beside it the same pixels
are taken from meshes: one radiosity for each patch, a linear function between the patches' corners, and the mesh that
is drawn.  (Cohen & Wallace 1993, section 9.2; Reichert 1992 for the gather at pixels)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glsim.pictures import heat, tiles
from glsim.radiosity.gather import Gatherer
from glsim.radiosity.lamps import Lamps
from glsim.radiosity.mesh import PatchMesh
from glsim.radiosity.progress import Progress, silent
from glsim.radiosity.scene import View
from glsim.radiosity.tone import toned

if TYPE_CHECKING:
    from PIL import Image

    from glsim.radiosity.result import Radiosity

Float = NDArray[np.float64]
Int = NDArray[np.int64]
BACKS = 64  # of triangles, through which a ray may pass
STEP = 1e-5  # of the scene's size: so far behind a back a ray goes on
SMALLEST = 200  # pixels of a tile, so that its label has room
WORST = 0.1  # relative error that an error map shows as its brightest colour


@dataclass(frozen=True)
class Pixels:
    """What a camera sees.  triangle: (k,), the numbers of a mesh's triangles, -1 for the background; weights: (k, 3),
    barycentric coordinates."""

    triangle: Int
    weights: Float

    @property
    def seen(self) -> Int:
        """The numbers of the pixels that show a triangle."""
        return np.flatnonzero(self.triangle >= 0)

    def between(self, mesh: PatchMesh, values: Float) -> Float:
        """Return values at the vertices (V, 3), interpolated linearly at the pixels that show a triangle: (m, 3)."""
        corners = values[mesh.triangles[self.triangle[self.seen]]]
        return np.asarray((self.weights[self.seen][:, :, None] * corners).sum(axis=1))


def pixels_of(mesh: PatchMesh, view: View, size: int, scale: float) -> Pixels:
    """Return what the middles of ``size`` x ``size`` pixels show of a mesh's fronts; scale: the scene's size."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    corners = mesh.vertices[mesh.triangles]
    middle = mesh.vertices.mean(axis=0)  # Embree calculates in single precision
    tree = EmbreeScene()
    TriangleMesh(tree, np.ascontiguousarray(corners - middle, np.float32))
    directions = _directions(view, size)
    origins = np.tile(np.asarray(view.eye, np.float64) - middle, (len(directions), 1))
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    triangle, weights = np.full(len(directions), -1), np.zeros((len(directions), 3))
    waiting = np.arange(len(directions))
    for _ in range(BACKS):
        hit: dict[str, Any] = tree.run(
            origins[waiting].astype(np.float32), directions[waiting].astype(np.float32), output=True
        )
        met, found = hit["primID"].astype(np.int64), np.flatnonzero(hit["primID"] >= 0)
        front = np.einsum("nk,nk->n", normals[met[found]], directions[waiting[found]]) < 0.0
        seen = found[front]
        triangle[waiting[seen]] = met[seen]
        u, v = hit["u"][seen].astype(np.float64), hit["v"][seen].astype(np.float64)
        weights[waiting[seen]] = np.stack([1.0 - u - v, u, v], axis=1)
        behind = found[~front]
        if not len(behind):
            break
        origins[waiting[behind]] += (hit["tfar"][behind, None] + STEP * scale) * directions[waiting[behind]]
        waiting = waiting[behind]
    return Pixels(triangle, weights)


def _directions(view: View, size: int) -> Float:
    """Return unit vectors from the eye through the middles of all pixels, row by row from the top: (size^2, 3)."""
    ahead = np.subtract(view.target, view.eye)
    ahead = ahead / np.linalg.norm(ahead)
    right = np.cross(ahead, view.up)
    right = right / np.linalg.norm(right)
    half = np.tan(np.radians(view.fov) / 2.0)
    at = half * ((2.0 * np.arange(size) + 1.0) / size - 1.0)
    y, x = np.meshgrid(-at, at, indexing="ij")
    result = ahead + x.reshape(-1, 1) * right + y.reshape(-1, 1) * np.cross(right, ahead)
    return np.asarray(result / np.linalg.norm(result, axis=1, keepdims=True))


def gathered_pixels(result: Radiosity, pixels: Pixels, tell: Progress = silent) -> Float:
    """Return the radiosity (m, 3) gathered at the points that pixels show of a solution's mesh."""
    p, mesh, chosen = result.patches, result.mesh, pixels.seen
    lamps = Lamps.of(p, result.factors.visibility)
    _, gatherer = Gatherer(result.factors, result.B, lamps).on(result.patch_mesh)
    points, normals = pixels.between(mesh, mesh.vertices), pixels.between(mesh, mesh.normals)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    patch = mesh.triangle_patch[pixels.triangle[chosen]]
    H = np.empty((len(chosen), 3))
    for first in range(0, len(chosen), 4096):
        now = slice(first, first + 4096)
        H[now] = gatherer.direct(points[now], normals[now]) + gatherer.bounced(points[now], normals[now], patch[now])
        tell("final gather", min(first + 4096, len(chosen)), len(chosen))
    return np.asarray(p.E[patch] + p.rho[patch] * H)


def losses(result: Radiosity, size: int, view: View, tell: Progress = silent) -> Image.Image:
    """Return a sheet: pictures of constant patches, of their corners, of the drawn mesh, and gathered at every pixel.

    Below them is how far each is from the last, relative to it, with the root of the mean square.
    """
    scale = result.patches.scene.size
    drawn = pixels_of(result.mesh, view, size, scale)
    true = gathered_pixels(result, drawn, tell)
    coarse = pixels_of(result.patch_mesh, view, size, scale)
    patch = result.mesh.triangle_patch[drawn.triangle[drawn.seen]]
    shown = {
        "patches, constant": (drawn, result.B[patch]),
        "their corners, linear": (coarse, coarse.between(result.patch_mesh, result.corner_radiosity)),
        "drawn mesh, linear": (drawn, drawn.between(result.mesh, result.vertex_radiosity)),
        "every pixel gathered": (drawn, true),
    }
    reference = _spread(drawn, true, size)
    bright = reference.max(axis=2)
    covered = (drawn.triangle >= 0).reshape(size, size) & (coarse.triangle >= 0).reshape(size, size)
    emitting = _spread(drawn, result.patches.E[patch], size).max(axis=2) > 0.0
    dark = covered & ~emitting
    floor = 0.02 * float(bright[dark].mean()) if dark.any() else 1.0
    pictures, errors = [], []
    for name, (pixels, values) in shown.items():
        image = _spread(pixels, values, size)
        colors = toned(image, result.shown_white, result.shown_tone, result.gamma)
        pictures.append((name, np.asarray(np.round(255.0 * colors), np.uint8)))
        off = np.abs(image - reference).max(axis=2)
        rms = 100.0 * float(np.sqrt((off[dark] ** 2).sum() / max((bright[dark] ** 2).sum(), 1e-300)))
        if name != "every pixel gathered":
            errors.append((f"off by {rms:.2f} % rms", heat(np.minimum(off / (bright + floor) / WORST, 1.0), covered)))
    scale_bar = np.repeat(np.linspace(1.0, 0.0, size)[:, None], size, axis=1)
    bar = heat(scale_bar, np.broadcast_to(np.arange(size) < size // 8, (size, size)))
    errors.append((f"0 (violet) to {100 * WORST:.0f} % (yellow)", bar))
    return tiles(f"{result.patches.scene.name}: what the mesh loses", [pictures, errors], max(size, SMALLEST))


def _spread(pixels: Pixels, values: Float, size: int) -> Float:
    """Return an image (size, size, 3) of the values (m, 3) at the pixels that show something; black elsewhere."""
    image = np.zeros((size * size, 3))
    image[pixels.seen] = values
    return image.reshape(size, size, 3)
