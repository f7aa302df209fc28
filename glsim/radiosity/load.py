"""Scenes for radiosity by name, from mesh files, and from what any program draws (see program.py)."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.names import did_you_mean
from glsim.radiosity.scene import BRIGHTEST, Builder, Material, Scene, SceneError, view_of
from glsim.radiosity.scenes import BUILT_IN
from glsim.scenes.mesh import MeshError

Float = NDArray[np.float64]
CREASE = np.radians(40.0)  # flatter edges of a mesh are shaded round


def scene_from(what: Any, materials: Mapping[str, Material] | None = None) -> Scene:
    """Return the scene of a built-in one's name, a mesh file (GLB, OBJ, PLY, ...), a program (.py), a Frame or a Scene.

    materials: instead of those of the same name.  Raises SceneError for what cannot be used.
    """
    from glsim.machine.frame import Frame
    from glsim.radiosity.program import from_frame

    if isinstance(what, Scene):
        scene = what
    elif not isinstance(what, (str, os.PathLike, Frame)):
        raise SceneError(
            f"a scene is a radiosity.Scene (of a Builder: builder.scene()), a name, a file, a program or a Frame, not"
            f" {what!r}"
        )
    elif isinstance(what, Frame):
        scene = from_frame(what)
    elif str(what) in BUILT_IN and not Path(what).exists():
        scene = BUILT_IN[str(what)].make()
    elif str(what).endswith(".py"):
        from glsim.play.frames import frame_of

        scene = from_frame(frame_of(what), str(what))
    elif Path(what).is_dir():
        raise SceneError(f"{what} is a folder; name a mesh file, a program or a built-in scene")
    elif Path(what).exists():
        scene = from_file(Path(what))
    else:
        known = f"the built-in scenes are {', '.join(BUILT_IN)}{did_you_mean(str(what), BUILT_IN)}"
        raise SceneError(f"{what}: there is no such file, and {known}")
    unknown = set(materials or {}) - {material.name for material in scene.materials}
    if unknown:
        known = ", ".join(sorted(material.name for material in scene.materials))
        raise SceneError(f"{scene.name} has no material named {', '.join(sorted(unknown))}; it has {known}")
    changed = tuple((materials or {}).get(material.name, material) for material in scene.materials)
    return replace(scene, materials=changed)


# ---------------------------------------------------------------- files


def from_file(path: Path) -> Scene:
    """Read a mesh file: base colour becomes rho, emissive colour E.  Smooth parts stay smooth."""
    from glsim.scenes.reading import read

    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")  # a sentence follows
            loaded, dumped = read(path)
    except MeshError as error:
        raise SceneError(str(error)) from error
    meshes = [name for name, mesh in loaded.geometry.items() if len(getattr(mesh, "faces", ()))]
    b = Builder(path.name)
    names = meshes if len(meshes) == len(dumped) else [f"part {k}" for k in range(len(dumped))]
    for name, mesh in zip(names, dumped, strict=True):
        mesh.merge_vertices(merge_norm=True, merge_tex=True)
        material = _material(mesh, name)
        for faces in _smooth_parts(mesh):
            b.add(np.asarray(mesh.vertices)[np.asarray(mesh.faces)[faces]], material, smooth=True)
    points = np.concatenate(b.polygons)
    return b.scene(view_of(points))


def _smooth_parts(mesh: Any) -> list[NDArray[np.int64]]:
    """Group the faces of a trimesh that hang together by edges flatter than CREASE."""
    import trimesh

    flat = np.asarray(mesh.face_adjacency)[np.asarray(mesh.face_adjacency_angles) < CREASE]
    parts = trimesh.graph.connected_components(flat, nodes=np.arange(len(mesh.faces)))
    return [np.asarray(part) for part in parts]


def _material(mesh: Any, name: str) -> Material:
    """Return the material of a trimesh; white paint if it has none."""
    rho, E = np.full(3, 0.7), np.zeros(3)
    material = getattr(mesh.visual, "material", None)
    if material is not None:
        name = str(getattr(material, "name", None) or name)
        base = getattr(material, "baseColorFactor", None)
        base = getattr(material, "diffuse", None) if base is None else base
        if base is not None:
            rho = _unit(base)
        emissive = getattr(material, "emissiveFactor", None)
        emissive = getattr(material, "kwargs", {}).get("ke") if emissive is None else emissive
        if emissive is not None:
            E = np.asarray(emissive, float)[:3]
    elif getattr(mesh.visual, "kind", None) in ("face", "vertex"):
        rho = _unit(np.asarray(mesh.visual.face_colors, float).mean(axis=0))
    r, g, b = np.clip(rho, 0.0, BRIGHTEST).tolist()
    return Material(name, (r, g, b), (float(E[0]), float(E[1]), float(E[2])))


def _unit(color: Any) -> Float:
    """Return a colour (3,) in [0, 1], from bytes or from numbers that are so already."""
    values = np.asarray(color, float)[:3]
    return values / 255.0 if np.asarray(color).dtype.kind in "ui" or values.max() > 1.0 else values
