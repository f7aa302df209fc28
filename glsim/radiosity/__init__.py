"""Radiosity: diffuse light that bounces, solved patch by patch and baked into vertex colours.

    scene        polygons with reflectance and exitance, and their checks
    patches      breaking them into patches, cut where they touch (contacts) and without what is hidden (exposure)
    formfactors  how much of what leaves one patch arrives at another; textbook, hemicube: other ways to find it
    hierarchy    links between levels of detail instead of a matrix
    solvers      the linear system (I - R F) B = E
    adapt        more patches where the light changes fast
    bake         radiosity at vertices, tone mapping
    solution     glsim.radiosity.solve: all of it
    result       what it returns: pictures, files, a report

Needs numba and embreex: ``pip install glsim[radiosity]``.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from glsim.radiosity.result import Radiosity as Radiosity
    from glsim.radiosity.scene import Builder as Builder
    from glsim.radiosity.scene import Material as Material
    from glsim.radiosity.scene import Scene as Scene
    from glsim.radiosity.scene import SceneError as SceneError
    from glsim.radiosity.scene import View as View
    from glsim.radiosity.scenes import BUILT_IN as BUILT_IN
    from glsim.radiosity.solution import solve as solve

_HOME = {
    "Radiosity": "result", "solve": "solution", "Builder": "scene", "Material": "scene", "Scene": "scene",
    "SceneError": "scene", "View": "scene", "BUILT_IN": "scenes",
}  # fmt: skip
__all__ = list(_HOME)


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"glsim.radiosity.{_HOME[name]}"), name)
    from glsim.names import missing

    raise missing(__name__, name, _HOME)


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOME})
