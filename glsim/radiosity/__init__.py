"""Radiosity: diffuse light that bounces, solved patch by patch and baked into vertex colours.

    scene        polygons with reflectance and exitance, and their checks
    patches      breaking them into patches
    formfactors  how much of what leaves one patch arrives at another
    solvers      the linear system (I - R F) B = E
    bake         radiosity at vertices, tone mapping
    result       glsim.radiosity.solve: all of it, and pictures, files, a report

Needs numba and embreex: ``pip install glsim[radiosity]``.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from glsim.radiosity.result import Radiosity as Radiosity
    from glsim.radiosity.result import solve as solve
    from glsim.radiosity.scene import Builder as Builder
    from glsim.radiosity.scene import Material as Material
    from glsim.radiosity.scene import Scene as Scene
    from glsim.radiosity.scene import SceneError as SceneError
    from glsim.radiosity.scene import View as View
    from glsim.radiosity.scenes import BUILT_IN as BUILT_IN

_HOME = {
    "Radiosity": "result", "solve": "result", "Builder": "scene", "Material": "scene", "Scene": "scene",
    "SceneError": "scene", "View": "scene", "BUILT_IN": "scenes",
}  # fmt: skip
__all__ = list(_HOME)


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"glsim.radiosity.{_HOME[name]}"), name)
    raise AttributeError(f"module 'glsim.radiosity' has no attribute {name!r}")
