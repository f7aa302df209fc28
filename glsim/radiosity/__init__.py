"""Radiosity: diffuse light that bounces, solved patch by patch and baked into vertex colours.

    scene, scenes     polygons with reflectance and exitance, checks; the built-in ones; load, files, program: others
    textures, sheets  reflectance from pictures; what has two sides
    patches           what light is exchanged between; subdivide makes them, contacts cuts them where polygons touch,
                      hidden leaves out what nobody sees, clusters makes one of many; near: boxes that overlap
    methods           a table of the ways to find form factors; formfactors (contour), textbook, hemicube
    visibility        how much of one patch another one sees; rays owns Embree and the threads, bodies save most rays
    hierarchy         links between the levels of a tree instead of a matrix; distributed: blocks elsewhere
    factors           the protocol that a matrix, links and blocks of form factors fulfil
    solvers           the linear system (I - R F) B = E
    adapt             more patches where the light changes fast
    gather, lamps     light at points: bounced from all patches, direct from lamps
    mesh, drawn       triangles of the patches; smaller ones where the light changes fast; tone: colours for the screen
    pixels            a gather at each pixel, and what meshes lose against it
    solution          glsim.radiosity.solve: all steps, from the scene to the radiosity at vertices
    result, view      what it returns: numbers, files, a report; drawing it; pointlights: OpenGL's lights instead
    compiled          numba; inner loops are in polygon, contour, pairs, samples, links and matrix

Needs numba and embreex: ``pip install glsim[radiosity]``.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from glsim.radiosity.load import scene_from as scene_from
    from glsim.radiosity.result import Radiosity as Radiosity
    from glsim.radiosity.scene import Builder as Builder
    from glsim.radiosity.scene import Material as Material
    from glsim.radiosity.scene import Scene as Scene
    from glsim.radiosity.scene import SceneError as SceneError
    from glsim.radiosity.scene import View as View
    from glsim.radiosity.scenes import BUILT_IN as BUILT_IN
    from glsim.radiosity.solution import solve as solve
    from glsim.radiosity.textures import Texture as Texture
    from glsim.radiosity.textures import texture_of as texture_of

_HOME = {
    "Radiosity": "result", "solve": "solution", "Builder": "scene", "Material": "scene", "Scene": "scene",
    "SceneError": "scene", "View": "scene", "BUILT_IN": "scenes", "Texture": "textures", "texture_of": "textures",
    "scene_from": "load",
}  # fmt: skip
__all__ = list(_HOME)


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"glsim.radiosity.{_HOME[name]}"), name)
    from glsim.names import missing

    raise missing(__name__, name, _HOME)


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOME})
