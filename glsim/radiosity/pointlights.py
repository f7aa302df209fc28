"""A scene's lamps as OpenGL's lights: they are points, nothing casts a shadow, and an ambient term
stands for bounced light.

A lamp of area A that emits E becomes a spotlight with exponent 1 and the attenuation 1 / (1 + pi r^2 / A): what arrives
is E cos cos A / (A + pi r^2), the form factor of a disc.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine.state import MAX_LIGHTS
from glsim.radiosity.patches import Patches
from glsim.radiosity.scene import area_of, normal_of

if TYPE_CHECKING:
    from glsim.radiosity.result import Radiosity

Float = NDArray[np.float64]


class PointLamp(NamedTuple):
    """An OpenGL light that stands for a lamp.

    at: position (3,); direction: unit vector (3,) to which its front looks, None for a lamp that shines all around;
    E: exitance (3,); area: of the lamp, in the scene's unit squared.
    """

    at: Float
    direction: Float | None
    E: Float
    area: float


def lamps_of(patches: Patches) -> list[PointLamp]:
    """Return at most MAX_LIGHTS point lights for the emitting polygons.

    If there are too many polygons, all of one material become one light; if there are still too many, the strongest
    stay, and shine brighter so that no power is lost.
    """
    scene = patches.scene
    each = [[k] for k in scene.emitters]
    if len(each) > MAX_LIGHTS:
        materials = sorted({scene.material[k] for k in scene.emitters})
        each = [[k for k in scene.emitters if scene.material[k] == m] for m in materials]
    lamps = []
    for numbers in each:
        areas = np.array([area_of(scene.polygons[k]) for k in numbers])
        normals = np.array([normal_of(scene.polygons[k]) for k in numbers])
        normal = areas @ normals / areas.sum()
        at = areas @ np.array([scene.polygons[k].mean(axis=0) for k in numbers]) / areas.sum()
        E = np.array(scene.materials[scene.material[numbers[0]]].E)
        directed = float(np.linalg.norm(normal)) > 0.5
        lamps.append(PointLamp(at, normal / np.linalg.norm(normal) if directed else None, E, float(areas.sum())))
    lamps.sort(key=lambda lamp: -lamp.area * float(lamp.E.sum()))
    total, shown = (sum(lamp.area * lamp.E for lamp in some) for some in (lamps, lamps[:MAX_LIGHTS]))
    gain = np.divide(total, shown, out=np.ones(3), where=np.asarray(shown) > 0.0)
    return [lamp._replace(E=lamp.E * gain) for lamp in lamps[:MAX_LIGHTS]]


def ambient_of(result: Radiosity) -> Float:
    """Return the mean irradiance of light that has bounced (3,).

    It is s E s rho / (1 - s rho), with the means of E and rho over the area, and the share s of light that does not
    escape.
    """
    area = result.patches.area / result.patches.area.sum()
    rho, E, stays = area @ result.patches.rho, area @ result.patches.E, float(area @ result.factors.row_sums)
    return np.asarray(stays * E * stays * rho / (1.0 - stays * rho))
