"""The scene in the light that fixed function knows: lamps are points, nothing has a shadow, an ambient term stands for
what bounces.

A lamp of area A that emits E becomes a spotlight with exponent 1 and the attenuation 1 / (1 + pi r^2 / A): what arrives
is E cos cos A / (A + pi r^2), the form factor of a disc.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine.state import MAX_LIGHTS
from glsim.radiosity.patches import Patches
from glsim.radiosity.result import Radiosity, look
from glsim.radiosity.scene import View, area_of, normal_of

Float = NDArray[np.float64]


class PointLamp(NamedTuple):
    """at: where; way: where its front looks, None if all around; E: exitance (3,); area."""

    at: Float
    way: Float | None
    E: Float
    area: float


def lamps_of(patches: Patches) -> list[PointLamp]:
    """The emitting polygons, or if these are more than MAX_LIGHTS all of a material as one; of too many the strongest,
    made so strong that no power is lost."""
    scene = patches.scene
    each = [[k] for k in scene.emitters]
    if len(each) > MAX_LIGHTS:
        materials = sorted({scene.material[k] for k in scene.emitters})
        each = [[k for k in scene.emitters if scene.material[k] == m] for m in materials]
    lamps = []
    for numbers in each:
        areas = np.array([area_of(scene.rings[k]) for k in numbers])
        ways = np.array([normal_of(scene.rings[k]) for k in numbers])
        way = areas @ ways / areas.sum()
        at = areas @ np.array([scene.rings[k].mean(axis=0) for k in numbers]) / areas.sum()
        E = np.array(scene.materials[scene.material[numbers[0]]].E)
        directed = float(np.linalg.norm(way)) > 0.5
        lamps.append(PointLamp(at, way / np.linalg.norm(way) if directed else None, E, float(areas.sum())))
    lamps.sort(key=lambda lamp: -lamp.area * float(lamp.E.sum()))
    total, kept = (sum(lamp.area * lamp.E for lamp in some) for some in (lamps, lamps[:MAX_LIGHTS]))
    more = np.divide(total, kept, out=np.ones(3), where=np.asarray(kept) > 0.0)
    return [lamp._replace(E=lamp.E * more) for lamp in lamps[:MAX_LIGHTS]]


def ambient_of(result: Radiosity) -> Float:
    """(3,): the mean irradiance of what has bounced, s E s rho / (1 - s rho) with means over the area; s: the share of
    light that does not escape."""
    area = result.patches.area / result.patches.area.sum()
    rho, E, stays = area @ result.patches.rho, area @ result.patches.E, float(area @ result.factors.row_sums)
    return np.asarray(stays * E * stays * rho / (1.0 - stays * rho))


def draw_lit(result: Radiosity, view: View, white: float) -> None:
    """Draw with GL_LIGHTING and clear before: rho is the material, E / white the lamps' light."""
    from glsim import gl

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
    from glsim import gl

    gl.glEnable(light)
    gl.glLightfv(light, gl.GL_DIFFUSE, [*(lamp.E / white), 1.0])
    gl.glLightfv(light, gl.GL_SPECULAR, [0.0, 0.0, 0.0, 1.0])
    gl.glLightf(light, gl.GL_CONSTANT_ATTENUATION, 1.0)
    if lamp.way is None:  # a closed body sends E A / (4 pi r^2) everywhere
        gl.glLightfv(light, gl.GL_POSITION, [*lamp.at, 1.0])
        gl.glLightf(light, gl.GL_QUADRATIC_ATTENUATION, 4.0 * np.pi / lamp.area)
    else:
        gl.glLightfv(light, gl.GL_POSITION, [*(lamp.at + 1e-4 * size * lamp.way), 1.0])
        gl.glLightf(light, gl.GL_QUADRATIC_ATTENUATION, np.pi / lamp.area)
        gl.glLightfv(light, gl.GL_SPOT_DIRECTION, lamp.way)
        gl.glLightf(light, gl.GL_SPOT_CUTOFF, 90.0)
        gl.glLightf(light, gl.GL_SPOT_EXPONENT, 1.0)


def _draw_triangles(corners: Float, normals: Float, colors: Float) -> None:
    """Triangles (m, 3, 3) with normals at their corners and one colour (m, 3) each."""
    from glsim import gl

    arrays = (gl.GL_VERTEX_ARRAY, gl.GL_NORMAL_ARRAY, gl.GL_COLOR_ARRAY)
    for array in arrays:
        gl.glEnableClientState(array)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, corners.reshape(-1, 3).astype(np.float32))
    gl.glNormalPointer(gl.GL_FLOAT, 0, normals.reshape(-1, 3).astype(np.float32))
    gl.glColorPointer(3, gl.GL_FLOAT, 0, np.repeat(colors, 3, axis=0).astype(np.float32))
    gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3 * len(corners))
    for array in arrays:
        gl.glDisableClientState(array)
