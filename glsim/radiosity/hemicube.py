"""Form factors by drawing: the scene as each patch sees it, on the five faces of half a cube over its middle.

The gl commands draw every patch in a colour that is its number.  F_ij is the sum of the delta form factors of the
pixels that show patch j in the hemicube of patch i; the depth buffer removes what is hidden.  Source: Cohen and
Greenberg, The hemi-cube: a radiosity solution for complex environments (1985); Cohen & Wallace (1993), section 4.8.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.view import gluLookAt
from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress
from glsim.render.context import own_screen

Float = NDArray[np.float64]
RESOLUTION = 128  # pixels along an edge of the cube
AT_ONCE = 16  # hemicubes in one picture, above each other


def hemicube(patches: Patches, progress: Progress, resolution: int = RESOLUTION) -> NDArray[np.float32]:
    """Return S (n, n) from hemicubes with ``resolution`` pixels along an edge.

    Each hemicube gives a row A_i F_ij; S_ij and S_ji differ a little, and their mean is taken.
    """
    n, width = len(patches), 3 * resolution
    weights = delta_form_factors(resolution).ravel()
    S = np.zeros((n, n), np.float32)
    with own_screen(width, AT_ONCE * resolution) as screen:
        scene = _compiled(patches)
        for first in range(0, n, AT_ONCE):
            batch = range(first, min(first + AT_ONCE, n))
            _clear()
            for place, i in enumerate(batch):
                _draw(patches, i, resolution, place * resolution, scene)
            seen = _numbers(screen.pixels()[::-1])
            for place, i in enumerate(batch):
                ids = seen[place * resolution : (place + 1) * resolution].ravel()
                S[i] = patches.area[i] * np.bincount(ids, weights, n + 1)[1:]
            progress("form factors", batch.stop, n)
    for k in range(0, n, 1024):  # block by block, so that no second n x n array is needed
        mean = (S[k : k + 1024, k:] + S[k:, k : k + 1024].T) / 2.0
        S[k : k + 1024, k:], S[k:, k : k + 1024] = mean, mean.T
    return S


def delta_form_factors(resolution: int) -> Float:
    """Return the form factor of each pixel, (resolution, 3 resolution).

    The first ``resolution`` columns are the top face, dA / (pi (x^2 + y^2 + 1)^2).  The others are the upper halves of
    the four side faces, in two rows of two, z dA / (pi (y^2 + z^2 + 1)^2).  The sum of all is close to 1.
    """
    at = (2.0 * np.arange(resolution) + 1.0) / resolution - 1.0
    area = (2.0 / resolution) ** 2
    top = area / (np.pi * (at[None, :] ** 2 + at[:, None] ** 2 + 1.0) ** 2)
    z = at[resolution // 2 :, None]
    side = z * area / (np.pi * (at[None, :] ** 2 + z**2 + 1.0) ** 2)
    return np.asarray(np.hstack([top, np.block([[side, side], [side, side]])]))


def _compiled(patches: Patches) -> int:
    """Compile a display list that draws all patches: fronts in the colour of their number, from 1, backs black."""
    n = len(patches)
    number = np.repeat(np.arange(1, n + 1), 4)
    colors = np.stack([number & 255, number >> 8 & 255, number >> 16], axis=1).astype(np.uint8)
    corners = patches.corners.reshape(-1, 3).astype(np.float32)
    name = int(gl.glGenLists(1))
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, corners)
    gl.glNewList(name, gl.GL_COMPILE)
    for culled, shown in ((gl.GL_BACK, colors), (gl.GL_FRONT, np.zeros_like(colors))):
        gl.glEnableClientState(gl.GL_COLOR_ARRAY)
        gl.glColorPointer(3, gl.GL_UNSIGNED_BYTE, 0, shown)
        gl.glCullFace(culled)
        gl.glDrawArrays(gl.GL_QUADS, 0, len(corners))
    gl.glEndList()
    return name


def _clear() -> None:
    """Clear the picture, and set the state that leaves the patches' colours exact: no dithering, flat shading."""
    gl.glDisable(gl.GL_DITHER)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_CULL_FACE)
    gl.glShadeModel(gl.GL_FLAT)
    gl.glClearColor(0.0, 0.0, 0.0, 0.0)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)


def _draw(patches: Patches, i: int, resolution: int, bottom: int, scene: int) -> None:
    """Draw the five faces over patch i: the top one, and of the sides the half above the patch."""
    eye, up = patches.center[i], patches.normal[i]
    across = patches.corners[i, 1] - patches.corners[i, 0]
    across = across / np.linalg.norm(across)
    along = np.cross(up, across)
    half, near, far = resolution // 2, 1e-3 * patches.size[i], 2.0 * patches.scene.size
    faces = [(up, along, (0, 0, resolution, resolution), -near)]
    for k, direction in enumerate((across, along, -across, -along)):
        faces.append((direction, up, (resolution * (1 + k % 2), half * (k // 2), resolution, half), 0.0))
    for direction, above, (x, y, width, height), low in faces:
        gl.glViewport(x, bottom + y, width, height)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.glFrustum(-near, near, low, near, near, far)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glLoadIdentity()
        gluLookAt(*eye, *(eye + direction), *above)
        gl.glCallList(scene)


def _numbers(pixels: NDArray[np.uint8]) -> NDArray[np.int64]:
    """Return the numbers of patches from the colours of pixels; 0 where no front is seen."""
    r, g, b = (pixels[..., k].astype(np.int64) for k in range(3))
    return np.asarray(r + 256 * g + 65536 * b)
