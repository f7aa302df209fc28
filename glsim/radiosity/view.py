"""Drawing with the gl commands: a solution's vertex colours, and the same scene in the light of OpenGL's lights."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.view import gluLookAt, gluPerspective
from glsim.radiosity.mesh import PatchMesh
from glsim.radiosity.pointlights import PointLamp, ambient_of, lamps_of
from glsim.radiosity.scene import Scene, View
from glsim.radiosity.textures import mapped
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


def picture_of(draw: Callable[[], object], scene: Scene, view: View, size: int, samples: int) -> Image.Image:
    """Return what ``draw`` draws, seen from a camera, as a square picture, ``size`` pixels wide."""
    with offscreen(size, size, samples=samples) as screen:
        look(view, scene)
        draw()
        return screen.image()


def draw_colors(mesh: PatchMesh, colors: Float, chosen: NDArray[np.bool_] | None = None) -> None:
    """Draw a mesh under the current matrices: colours (V, 3) at its vertices, GL_SMOOTH, no lighting, fronts only.

    chosen: (T,), which triangles; by default all.
    """
    triangles = mesh.triangles if chosen is None else mesh.triangles[chosen]
    with _client_arrays(gl.GL_VERTEX_ARRAY, gl.GL_COLOR_ARRAY):
        gl.glVertexPointer(3, gl.GL_FLOAT, 0, mesh.vertices.astype(np.float32))
        gl.glColorPointer(3, gl.GL_FLOAT, 0, np.ascontiguousarray(colors, np.float32))
        gl.glDrawElements(gl.GL_TRIANGLES, triangles.size, gl.GL_UNSIGNED_INT, triangles.astype(np.uint32))


def draw_solution(result: Radiosity, B: Float) -> None:
    """Draw the radiosity B (V, 3) at a solution's vertices as ``draw_colors`` does; textured polygons have all texels.

    On these the vertex colour is what a surface would show that is everywhere as bright as the brightest texel, and
    GL_MODULATE multiplies it by the texel's share of that.  Both are raised to the power 1 / gamma before, and the
    product of two powers is the power of the product.
    """
    scene, mesh, p = result.patches.scene, result.mesh, result.patches
    paint = np.asarray(scene.material)[p.polygon[mesh.triangle_patch]]
    textured = [k for k, material in enumerate(scene.materials) if material.texture is not None]
    draw_colors(mesh, result.colors(B), ~np.isin(paint, textured))
    if not textured:
        return
    own = p.rho[mesh.patch]
    H = np.divide(np.maximum(B - p.E[mesh.patch], 0.0), own, out=np.zeros_like(own), where=own > 0.0)
    for number in textured:
        material, chosen = scene.materials[number], np.flatnonzero(paint == number)
        assert material.texture is not None
        texels, peak = material.texture.texels, material.texture.peak
        colors = result.colors(np.asarray(material.E) + np.asarray(material.rho) * peak * H)
        corners = mesh.triangles[chosen]
        M = np.array([scene.mapping[k] for k in p.polygon[mesh.triangle_patch[chosen]].tolist()], np.float64)
        shares = np.round(255.0 * (texels / peak) ** (1.0 / result.gamma)).astype(np.uint8)
        _draw_textured(mesh.vertices[corners], colors[corners], mapped(M, mesh.vertices[corners]), shares)


def _draw_textured(corners: Float, colors: Float, st: Float, texels: NDArray[np.uint8]) -> None:
    """Draw triangles (m, 3, 3) with colours (m, 3, 3) and texture coordinates (m, 3, 2) at their corners.

    texels: (height, width, 3), the first row at t = 1.
    """
    height, width = texels.shape[:2]
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    gl.glBindTexture(gl.GL_TEXTURE_2D, gl.glGenTextures(1))
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_GENERATE_MIPMAP, gl.GL_TRUE)
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_LINEAR_MIPMAP_LINEAR)
    upwards = np.ascontiguousarray(texels[::-1])  # OpenGL's first row is at t = 0
    gl.glTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, width, height, 0, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, upwards)
    gl.glTexEnvi(gl.GL_TEXTURE_ENV, gl.GL_TEXTURE_ENV_MODE, gl.GL_MODULATE)
    gl.glEnable(gl.GL_TEXTURE_2D)
    with _client_arrays(gl.GL_VERTEX_ARRAY, gl.GL_COLOR_ARRAY, gl.GL_TEXTURE_COORD_ARRAY):
        gl.glVertexPointer(3, gl.GL_FLOAT, 0, np.ascontiguousarray(corners.reshape(-1, 3), np.float32))
        gl.glColorPointer(3, gl.GL_FLOAT, 0, np.ascontiguousarray(colors.reshape(-1, 3), np.float32))
        gl.glTexCoordPointer(2, gl.GL_FLOAT, 0, np.ascontiguousarray(st.reshape(-1, 2), np.float32))
        gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3 * len(corners))
    gl.glDisable(gl.GL_TEXTURE_2D)


def seen_patches(result: Radiosity, view: View, size: int = 96) -> NDArray[np.int64]:
    """Return the numbers of the patches that a camera sees, ascending: each is drawn in a colour of its own."""
    mesh = result.mesh
    code = mesh.triangle_patch + 1  # 0 is the background
    colors = np.stack([code >> 16, code >> 8 & 255, code & 255], axis=1) / 255.0

    def draw() -> None:
        with _client_arrays(gl.GL_VERTEX_ARRAY, gl.GL_COLOR_ARRAY):
            gl.glVertexPointer(3, gl.GL_FLOAT, 0, mesh.vertices[mesh.triangles].reshape(-1, 3).astype(np.float32))
            gl.glColorPointer(3, gl.GL_FLOAT, 0, np.repeat(colors, 3, axis=0).astype(np.float32))
            gl.glDrawArrays(gl.GL_TRIANGLES, 0, mesh.triangles.size)

    pixels = np.asarray(picture_of(draw, result.patches.scene, view, size, 0)).astype(np.int64)
    numbers = np.unique(pixels[..., 0] << 16 | pixels[..., 1] << 8 | pixels[..., 2]) - 1
    return np.asarray(numbers[numbers >= 0])


@contextmanager
def _client_arrays(*arrays: int) -> Iterator[None]:
    """Draw from these arrays, GL_SMOOTH, without lighting, fronts only, with the depth test."""
    gl.glDisable(gl.GL_LIGHTING)
    gl.glShadeModel(gl.GL_SMOOTH)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_CULL_FACE)
    for array in arrays:
        gl.glEnableClientState(array)
    yield
    for array in arrays:
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
