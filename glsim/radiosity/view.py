"""Drawing with the gl commands: a solution's vertex colours, and the same scene in the light of OpenGL's lights."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.view import gluLookAt, gluPerspective
from glsim.radiosity.mesh import PatchMesh
from glsim.radiosity.pointlights import PointLamp, ambient_of, lamps_of
from glsim.radiosity.scene import Scene, View
from glsim.render.context import offscreen

if TYPE_CHECKING:
    from PIL import Image

    from glsim.radiosity.result import Radiosity

Float = NDArray[np.float64]


def look(view: View, scene: Scene) -> None:
    """Set projection and modelview for a camera, and clear."""
    distance = float(np.linalg.norm(np.subtract(view.target, view.eye)))
    far = distance + 2.0 * scene.size
    gl.glClearColor(0.0, 0.0, 0.0, 1.0)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gluPerspective(view.fov, 1.0, far / 2000.0, far)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gluLookAt(*view.eye, *view.target, *view.up)


def picture_of(mesh: PatchMesh, colors: Float, scene: Scene, view: View, size: int, samples: int) -> Image.Image:
    """Draw a mesh with vertex colours (V, 3) from a camera into a square picture, ``size`` pixels wide."""
    with offscreen(size, size, samples=samples) as screen:
        look(view, scene)
        draw_colors(mesh, colors)
        return screen.image()


def draw_colors(mesh: PatchMesh, colors: Float) -> None:
    """Draw a mesh under the current matrices: colours (V, 3) at its vertices, GL_SMOOTH, no lighting, fronts only."""
    gl.glDisable(gl.GL_LIGHTING)
    gl.glShadeModel(gl.GL_SMOOTH)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_CULL_FACE)
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glEnableClientState(gl.GL_COLOR_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, mesh.vertices.astype(np.float32))
    gl.glColorPointer(3, gl.GL_FLOAT, 0, np.ascontiguousarray(colors, np.float32))
    triangles = mesh.triangles.astype(np.uint32)
    gl.glDrawElements(gl.GL_TRIANGLES, triangles.size, gl.GL_UNSIGNED_INT, triangles)
    for array in (gl.GL_VERTEX_ARRAY, gl.GL_COLOR_ARRAY):
        gl.glDisableClientState(array)
    gl.glDisable(gl.GL_CULL_FACE)


def draw_point_lights(result: Radiosity, view: View, white: float) -> None:
    """Clear, and draw a solution's scene with GL_LIGHTING from a camera.

    rho is the diffuse material, E / white the light of the lamps, see pointlights.lamps_of.
    """
    scene, mesh, p = result.patches.scene, result.mesh, result.patches
    look(view, scene)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_CULL_FACE)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glLightModelfv(gl.GL_LIGHT_MODEL_AMBIENT, [*(ambient_of(result) / white), 1.0])
    for number, lamp in enumerate(lamps_of(p)):
        _switch_on(gl.GL_LIGHT0 + number, lamp, white, scene.size)
    gl.glColorMaterial(gl.GL_FRONT, gl.GL_AMBIENT_AND_DIFFUSE)
    gl.glEnable(gl.GL_COLOR_MATERIAL)
    patch = mesh.triangle_patch
    for E in np.unique(p.E, axis=0):
        chosen = np.flatnonzero((p.E[patch] == E).all(axis=1))
        gl.glMaterialfv(gl.GL_FRONT, gl.GL_EMISSION, [*(E / white), 1.0])
        _draw_triangles(
            mesh.vertices[mesh.triangles[chosen]], mesh.normals[mesh.triangles[chosen]], p.rho[patch[chosen]]
        )


def _switch_on(light: int, lamp: PointLamp, white: float, size: float) -> None:
    """Set and enable GL_LIGHTi for a lamp; size: of the scene."""
    gl.glEnable(light)
    gl.glLightfv(light, gl.GL_DIFFUSE, [*(lamp.E / white), 1.0])
    gl.glLightfv(light, gl.GL_SPECULAR, [0.0, 0.0, 0.0, 1.0])
    gl.glLightf(light, gl.GL_CONSTANT_ATTENUATION, 1.0)
    if lamp.direction is None:  # a closed body sends E A / (4 pi r^2) everywhere
        gl.glLightfv(light, gl.GL_POSITION, [*lamp.at, 1.0])
        gl.glLightf(light, gl.GL_QUADRATIC_ATTENUATION, 4.0 * np.pi / lamp.area)
    else:
        gl.glLightfv(light, gl.GL_POSITION, [*(lamp.at + 1e-4 * size * lamp.direction), 1.0])
        gl.glLightf(light, gl.GL_QUADRATIC_ATTENUATION, np.pi / lamp.area)
        gl.glLightfv(light, gl.GL_SPOT_DIRECTION, lamp.direction)
        gl.glLightf(light, gl.GL_SPOT_CUTOFF, 90.0)
        gl.glLightf(light, gl.GL_SPOT_EXPONENT, 1.0)


def _draw_triangles(corners: Float, normals: Float, colors: Float) -> None:
    """Draw triangles (m, 3, 3) with normals (m, 3, 3) at their corners and one colour (m, 3) each."""
    arrays = (gl.GL_VERTEX_ARRAY, gl.GL_NORMAL_ARRAY, gl.GL_COLOR_ARRAY)
    for array in arrays:
        gl.glEnableClientState(array)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, corners.reshape(-1, 3).astype(np.float32))
    gl.glNormalPointer(gl.GL_FLOAT, 0, normals.reshape(-1, 3).astype(np.float32))
    gl.glColorPointer(3, gl.GL_FLOAT, 0, np.repeat(colors, 3, axis=0).astype(np.float32))
    gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3 * len(corners))
    for array in arrays:
        gl.glDisableClientState(array)
