"""Scenes for radiosity from mesh files: which of their materials' numbers are reflectances and exitances.

Kd, the base colour and vertex colours are rho, their textures texels of it; Ke and the emissive colour, times its
strength, are E.  Sheets of a material that is doubleSided have two fronts.  Notes say what is left out.
"""

from __future__ import annotations

import warnings
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import BRIGHTEST, Builder, Material, Scene, SceneError, View
from glsim.radiosity.sheets import quads, sheets
from glsim.radiosity.textures import Texture, texture_of
from glsim.scenes.mesh import MeshError

Float = NDArray[np.float64]
Int = NDArray[np.int64]
CREASE = np.radians(40.0)  # flatter edges of a mesh are shaded round
LARGEST = 1024  # texels along an edge; larger pictures are made smaller
USED = ("KHR_materials_emissive_strength", "KHR_materials_pbrSpecularGlossiness", "EXT_texture_webp",
        "KHR_draco_mesh_compression", "KHR_mesh_quantization", "KHR_materials_unlit")  # fmt: skip


class Paint(NamedTuple):
    """What a file says about a mesh.  rho, E: (3,); both: whether sheets reflect on both sides; notes: what is lost."""

    name: str
    rho: Float
    E: Float
    texture: Texture | None
    both: bool
    notes: tuple[str, ...]


def from_file(path: Path) -> Scene:
    """Read a mesh file (GLB, OBJ, PLY, ...).

    Pairs of triangles that are a flat quad become one; parts flatter than CREASE stay smooth; the cameras of a glTF
    file are views.  Raises SceneError for what cannot be read.
    """
    from glsim.scenes.reading import read

    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")  # a sentence follows
            loaded, dumped = read(path)
    except MeshError as error:
        raise SceneError(str(error)) from error
    meshes = [name for name, mesh in loaded.geometry.items() if len(getattr(mesh, "faces", ()))]
    names = meshes if len(meshes) == len(dumped) else [f"part {k}" for k in range(len(dumped))]
    b, lost = Builder(path.name), Counter[str]()
    textures: dict[int, Texture] = {}
    for name, mesh in zip(names, dumped, strict=True):
        paint = _paint(mesh, name, textures)
        lost.update(paint.notes)
        _add(b, mesh, paint)
    header = _header(path)
    notes = [f"{words}: {count}" for words, count in lost.items()]
    if missing := sorted(set(loaded.metadata["missing"])):
        notes.append(f"files that are not in its folder: {', '.join(missing)}")
    if unused := sorted(set(header.get("extensionsUsed", ())) - set(USED)):
        notes.append(f"parts of the file that radiosity does not use: {', '.join(unused)}")
    return replace(b.scene(*_views(header)), notes=tuple(notes))


# ---------------------------------------------------------------- shapes


def _add(b: Builder, mesh: Any, paint: Paint) -> None:
    """Add a trimesh to a scene: its smooth parts, with quads where two triangles are one."""
    rho = _face_rho(mesh, paint)
    uv = getattr(mesh.visual, "uv", None) if paint.texture is not None else None
    st = None if uv is None else np.nan_to_num(np.asarray(uv, float)[np.asarray(mesh.faces)])
    mesh.merge_vertices(merge_norm=True, merge_tex=True)
    corners = np.asarray(mesh.vertices, np.float64)[np.asarray(mesh.faces)]
    if mesh.is_empty or not np.isfinite(corners).all():
        raise SceneError(f"{b.name}: {paint.name} has coordinates that are not finite numbers")
    pairs = np.asarray(mesh.face_adjacency).reshape(-1, 2)
    one_paint = pairs[(rho[pairs[:, 0]] == rho[pairs[:, 1]]).all(axis=1)]
    four, alone = quads(corners, one_paint, st)
    three = 3 * np.flatnonzero(alone)[:, None] + np.arange(3)
    polygons = [*four, *three]  # as numbers of corners
    part = _smooth_parts(mesh)
    open_ = sheets(corners) if paint.both else np.zeros(len(corners), bool)
    of_part = part[[polygon[0] // 3 for polygon in polygons]]
    order = np.argsort(of_part, kind="stable")
    for same in np.split(order, np.flatnonzero(np.diff(of_part[order])) + 1):
        chosen = [polygons[k] for k in same]
        _add_part(b, corners, st, chosen, rho, paint)
        if open_[chosen[0][0] // 3]:
            _add_part(b, corners, st, [polygon[::-1] for polygon in chosen], rho, paint)


def _add_part(b: Builder, corners: Float, st: Float | None, polygons: list[Int], rho: Float, paint: Paint) -> None:
    """Add polygons, given as numbers of corners, as one smooth surface; faces may differ in rho (m, 3)."""
    first = len(b.group)
    colors = rho[[polygon[-1] // 3 for polygon in polygons]]
    for color in np.unique(colors, axis=0):
        chosen = [polygons[k] for k in np.flatnonzero((colors == color).all(axis=1))]
        material = Material(paint.name, tuple(color.tolist()), tuple(paint.E.tolist()), paint.texture)
        pairs = None if st is None else [st.reshape(-1, 2)[polygon] for polygon in chosen]
        b.add([corners.reshape(-1, 3)[polygon] for polygon in chosen], material, True, pairs)
    b.group[first:] = [b.group[first]] * (len(b.group) - first)


def _smooth_parts(mesh: Any) -> Int:
    """Return for each face of a trimesh the part: the number of those that hang together by flat edges."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    flat = np.asarray(mesh.face_adjacency)[np.asarray(mesh.face_adjacency_angles) < CREASE].reshape(-1, 2)
    n = len(mesh.faces)
    return np.asarray(connected_components(coo_matrix((np.ones(len(flat)), flat.T), shape=(n, n)), False)[1], np.int64)


# ---------------------------------------------------------------- materials


def _paint(mesh: Any, name: str, textures: dict[int, Texture]) -> Paint:
    """Return what is known of a trimesh's material; without one it is painted .7 white.

    textures: those that are made already, by the identity of their pictures.
    """
    material = getattr(mesh.visual, "material", None)
    if material is None:
        return Paint(name, np.full(3, 0.7), np.zeros(3), None, False, ())
    name = str(getattr(material, "name", None) or name)
    physical = hasattr(material, "baseColorFactor")
    rho, E, both, notes = (_physical if physical else _classic)(material)
    picture = getattr(material, "baseColorTexture" if physical else "image", None)
    if picture is None or getattr(mesh.visual, "uv", None) is None:
        return Paint(name, rho, E, None, both, notes)
    if not physical and not rho.any():
        rho, notes = np.ones(3), (*notes, "materials with Kd 0 and map_Kd, whose Kd is taken as 1")
    if id(picture) not in textures:
        small = picture.convert("RGB")
        small.thumbnail((LARGEST, LARGEST))
        textures[id(picture)] = texture_of(np.asarray(small))
    return Paint(name, rho, E, textures[id(picture)], both, notes)


def _physical(material: Any) -> tuple[Float, Float, bool, tuple[str, ...]]:
    """Return rho, E, whether it is doubleSided, and notes for a material of glTF."""
    base = material.baseColorFactor
    rho = np.ones(3) if base is None else _unit(base)
    E = np.zeros(3) if material.emissiveFactor is None else np.asarray(material.emissiveFactor, float)
    metal = material.metallicFactor
    notes = {
        "transparent materials, taken as opaque": material.alphaMode in ("BLEND", "MASK"),
        "metals, which reflect diffusely here": metal is not None and metal > 0.5,
        "normal maps, left out": material.normalTexture is not None,
    }
    if material.emissiveTexture is not None and E.any():
        E = E * texture_of(np.asarray(material.emissiveTexture.convert("RGB"))).texels.mean(axis=(0, 1))
        notes["emissive textures, whose mean is E"] = True
    return rho, E, bool(material.doubleSided), tuple(words for words, true in notes.items() if true)


def _classic(material: Any) -> tuple[Float, Float, bool, tuple[str, ...]]:
    """Return rho, E, whether it has two sides (never), and notes for a material of an MTL file or another format."""
    more = {name.lower(): value for name, value in (material.kwargs or {}).items()}
    given = more.get("kd")
    rho = _unit(material.diffuse) if given is None else np.clip(_three(given, 0.7), 0.0, 1.0)
    E = _three(more.get("ke", 0.0), 0.0)
    opaque = float(_three(more.get("d", 1.0), 1.0)[0]) >= 1.0 and not _three(more.get("tr", 0.0), 0.0)[0] > 0.0
    notes = {
        "transparent materials, taken as opaque": not opaque,
        "materials with Ks, which reflect diffusely alone": _three(more.get("ks", 0.0), 0.0).any(),
        "emissive textures (map_Ke), left out": "map_ke" in more,
        "normal maps, left out": any("bump" in name or name == "norm" for name in more),
    }
    return rho, E, False, tuple(words for words, true in notes.items() if true)


def _three(values: Any, default: float) -> Float:
    """Return three numbers of an MTL line, of which one may stand for all; ``default`` for what is no number."""
    try:
        return np.broadcast_to(np.asarray(values, float).ravel()[:3], 3).copy()
    except ValueError:
        return np.full(3, default)


def _face_rho(mesh: Any, paint: Paint) -> Float:
    """Return the reflectance of each face of a trimesh, (m, 3): its material's, times the colours of its corners."""
    visual, faces = mesh.visual, np.asarray(mesh.faces)
    shade = np.ones((len(faces), 3))
    kind = getattr(visual, "kind", None)
    attributes = getattr(visual, "vertex_attributes", {})
    if kind == "face":
        shade = _unit(visual.face_colors) / paint.rho
    elif kind == "vertex":
        shade = _unit(visual.vertex_colors)[faces].mean(axis=1) / paint.rho
    elif "color" in attributes and len(attributes["color"]) == len(mesh.vertices):
        shade = _unit(attributes["color"])[faces].mean(axis=1)
    return np.asarray(np.clip(np.round(paint.rho * shade, 4), 0.0, BRIGHTEST))


def _unit(color: Any) -> Float:
    """Return colours (..., 3) in [0, 1], from whole numbers of any width or from numbers that are so already."""
    values = np.asarray(color)
    scale = float(np.iinfo(values.dtype).max) if values.dtype.kind in "ui" else 255.0 if values.max() > 1.0 else 1.0
    return np.asarray(values[..., :3] / scale, np.float64)


# ---------------------------------------------------------------- cameras


def _header(path: Path) -> dict[str, Any]:
    """Return the JSON of a glTF file; nothing of another."""
    from glsim.scenes.plain import header_of

    kind = path.suffix.lower()[1:]
    return dict(header_of(path.read_bytes(), kind)) if kind in ("gltf", "glb") else {}


def _views(header: dict[str, Any]) -> list[View]:
    """Return the perspective cameras of a glTF file (2.0, section 3.10): they look along -z of their nodes."""
    import trimesh

    nodes, cameras = header.get("nodes", []), header.get("cameras", [])
    local, above = [], {child: k for k, node in enumerate(nodes) for child in node.get("children", ())}
    for node in nodes:
        x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
        turn: Float = trimesh.transformations.quaternion_matrix((w, x, y, z))  # type: ignore[no-untyped-call]
        M = turn @ np.diag([*node.get("scale", (1.0, 1.0, 1.0)), 1.0])
        M[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
        local.append(np.reshape(node["matrix"], (4, 4)).T if "matrix" in node else M)
    views: list[View] = []
    for k, node in enumerate(nodes):
        lens = cameras[node["camera"]] if node.get("camera", len(cameras)) < len(cameras) else {}
        if "yfov" not in lens.get("perspective", {}):
            continue
        M, parent = local[k], above.get(k)
        while parent is not None:
            M, parent = local[parent] @ M, above.get(parent)
        (x, y, z), ahead, up = M[:3, 3].tolist(), (M[:3, 3] - M[:3, 2]).tolist(), M[:3, 1].tolist()
        fov = float(np.degrees(lens["perspective"]["yfov"]))
        name = str(node.get("name") or lens.get("name") or f"camera {len(views)}")
        views.append(View((x, y, z), tuple(ahead), tuple(up), fov, name))
    return views
