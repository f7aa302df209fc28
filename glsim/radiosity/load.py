"""Scenes for radiosity from mesh files and from what any program draws."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import Builder, Material, Scene, SceneError, View, view_of
from glsim.radiosity.scenes import BUILT_IN
from glsim.scenes.mesh import MeshError

Float = NDArray[np.float64]
CREASE = np.radians(40.0)  # flatter edges of a mesh are shaded round
BRIGHTEST = 0.99  # reflectance: a file may say 1, and light would never end


def scene_from(what: Any, materials: Mapping[str, Material] | None = None) -> Scene:
    """A built-in scene by name, a mesh file (GLB, OBJ, PLY, ...), a program (.py), a Frame, or a Scene as it is.

    materials: instead of those of the same name.  Raises SceneError for what cannot be used.
    """
    from glsim.machine.frame import Frame

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
        raise SceneError(f"{what}: there is no such file, and the built-in scenes are {', '.join(BUILT_IN)}")
    unknown = set(materials or {}) - {material.name for material in scene.materials}
    if unknown:
        known = ", ".join(sorted(material.name for material in scene.materials))
        raise SceneError(f"{scene.name} has no material named {', '.join(sorted(unknown))}; it has {known}")
    changed = tuple((materials or {}).get(material.name, material) for material in scene.materials)
    return Scene(scene.name, scene.rings, scene.material, changed, scene.views, scene.group, scene.notes)


# ---------------------------------------------------------------- files


def from_file(path: Path) -> Scene:
    """A mesh file: base colour becomes rho, emissive colour E.  Smooth parts stay smooth."""
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
    points = np.concatenate(b.rings)
    return b.scene(view_of(points))


def _smooth_parts(mesh: Any) -> list[NDArray[np.int64]]:
    """Faces that hang together by edges flatter than CREASE."""
    import trimesh

    flat = np.asarray(mesh.face_adjacency)[np.asarray(mesh.face_adjacency_angles) < CREASE]
    parts = trimesh.graph.connected_components(flat, nodes=np.arange(len(mesh.faces)))
    return [np.asarray(part) for part in parts]


def _material(mesh: Any, name: str) -> Material:
    """Of a trimesh visual; white paint if there is none."""
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
    values = np.asarray(color, float)[:3]
    return values / 255.0 if np.asarray(color).dtype.kind in "ui" or values.max() > 1.0 else values


# ---------------------------------------------------------------- programs


def from_frame(frame: Any, name: str = "frame") -> Scene:
    """The polygons of a Frame in eye space: k_d becomes rho, emission E; what is drawn unlit reflects its colour.

    OpenGL's lights are left out: in radiosity light comes from surfaces, so something must have GL_EMISSION.
    """
    from glsim.machine.assembly import corners, outlines

    b = Builder(Path(name).name)
    view: View | None = None
    for draw in frame.draws:
        if corners(draw.mode) != 3 or not draw.count:
            continue
        count = draw.count if draw.indices is None else len(draw.indices)
        rings, _ = outlines(draw.mode, count)
        numbers = (np.arange(count) if draw.indices is None else draw.indices.astype(np.int64)) + draw.first
        modelview = draw.matrices[0].get().astype(np.float64)
        block = draw.block
        points = np.concatenate([block.rows[:, :3], np.ones((len(block.rows), 1))], axis=1) @ modelview
        view = view or _view_in(draw.matrices[1].get().astype(np.float64))
        for ring in numbers[rings]:
            b.add([points[ring, :3] / points[ring, 3:]], _surface_material(draw, int(ring[-1])))
    if not b.rings:
        raise SceneError(f"{name}: no polygons are drawn")
    return b.scene(*([view] if view else []))


def _surface_material(draw: Any, vertex: int) -> Material:
    color = draw.color or tuple(draw.block.rows[vertex, 6:10].tolist())
    rho, E = color[:3], (0.0, 0.0, 0.0)
    if draw.state.lighting.enabled:
        from glsim.machine.constants import GL_BACK
        from glsim.machine.stage import TRACKED

        face = draw.materials_at(np.array([vertex]))[0].front
        lighting = draw.state.lighting
        tracked: tuple[str, ...] = ()
        if lighting.color_material and lighting.color_material_face != GL_BACK:
            tracked = TRACKED.get(lighting.color_material_mode, ("emission",))
        rho = color[:3] if "diffuse" in tracked else face.diffuse[:3]
        E = color[:3] if "emission" in tracked else face.emission[:3]
    r, g, b = (min(max(float(value), 0.0), BRIGHTEST) for value in rho)
    name = f"k_d {r:.3g} {g:.3g} {b:.3g}" + (" emitting" if max(E) > 0.0 else "")
    return Material(name, (r, g, b), (float(E[0]), float(E[1]), float(E[2])))


def _view_in(projection: Float) -> View:
    """The program's own camera: at the origin of eye space.  Column-first matrix."""
    fov = float(np.degrees(2.0 * np.arctan(1.0 / projection[1, 1]))) if projection[2, 3] != 0.0 else 60.0
    return View((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), fov=fov)
