"""The scene in the light that fixed function knows: lamps are points, nothing has a shadow, an ambient term stands for
what bounces.

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
