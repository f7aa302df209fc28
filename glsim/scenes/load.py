"""Mesh files: everything trimesh reads, with errors a user understands."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from glsim.machine.state import BLACK, Color, Face
from glsim.scenes.mesh import Mesh, MeshError, area_vectors, blocks, unit, with_normals


def load(path: str | Path) -> list[Mesh]:
    """The meshes of a file, centred and scaled into a sphere of radius 1.

    Normals are taken from the file or made; materials are mapped to k_a, k_d, k_s and n.
    Raises MeshError for a missing, broken, empty or too large file, or one with coordinates that are not numbers.
    """
    path = Path(path)
    if not path.exists():
        raise MeshError(f"{path}: there is no such file, and no built-in scene of this name")
    from glsim.scenes.reading import read

    return from_trimesh(read(path)[1], str(path))


def from_trimesh(geometries: list[Any], name: str) -> list[Mesh]:
    """Trimeshes, centred and scaled together in float64 into a sphere of radius 1."""
    used = []
    for geometry in geometries:
        faces = np.asarray(geometry.faces)
        if not len(faces):
            raise MeshError(f"{name} has no triangles to draw")
        if faces.min() < 0 or faces.max() >= len(geometry.vertices):
            raise MeshError(
                f"{name}: a triangle uses vertex {faces.max()}, but there are {len(geometry.vertices)} vertices"
            )
        used.append(np.asarray(geometry.vertices, np.float64)[np.unique(faces)])
    points = np.concatenate(used)
    with np.errstate(all="ignore"):
        centre = (points.min(axis=0) + points.max(axis=0)) / 2
        radius = float(np.linalg.norm(points - centre, axis=1).max())
    if radius == 0.0:
        raise MeshError(f"{name}: all its triangles are degenerate (they are one point)")
    return [convert(geometry, name, centre, radius) for geometry in geometries]


def convert(geometry: Any, name: str, centre: Any, radius: float) -> Mesh:
    """A trimesh.Trimesh as a Mesh.  Raises MeshError if it has no usable triangle."""
    with np.errstate(all="ignore"):
        positions = (np.asarray(geometry.vertices, np.float64) - centre) / radius
    triangles = np.asarray(geometry.faces, np.uint32)
    area = np.concatenate(
        [np.linalg.norm(area_vectors(positions, triangles[block]), axis=1) for block in blocks(triangles)]
    )
    broken = int((~np.isfinite(area)).sum())
    if broken:
        raise MeshError(
            f"{name}: {broken} of {len(triangles)} triangles have NaN or infinite coordinates; mend the file"
        )
    if not (area > 0.0).any():
        raise MeshError(f"{name}: all {len(triangles)} triangles are degenerate (they have no area)")
    nondegenerate = area > 0.0
    triangles = triangles[nondegenerate]
    colors = _colors(geometry)
    if colors is not None and len(colors) == len(geometry.faces) and len(colors) != len(positions):
        colors = np.repeat(colors[nondegenerate], 3, axis=0)
        positions, triangles = (
            positions[triangles].reshape(-1, 3),
            np.arange(triangles.size, dtype=np.uint32).reshape(-1, 3),
        )
    own_normals = "vertex_normals" in geometry._cache.cache
    normals = np.asarray(geometry.vertex_normals) if own_normals else None
    if normals is not None and normals.shape == positions.shape and np.isfinite(normals).all():
        mesh = Mesh(
            positions.astype(np.float32), unit(normals).astype(np.float32), triangles, np.empty((0, 4), np.uint32)
        )
    else:
        before = len(positions)
        mesh = with_normals(positions, triangles)
        if colors is not None and len(mesh.positions) != before:
            colors = colors[triangles.ravel()]
    mesh.colors = colors
    mesh.material = _material(geometry)
    return mesh


def _colors(geometry: Any) -> Any:
    """Colours per vertex or per face, in [0, 1], if the file has them."""
    kind = getattr(geometry.visual, "kind", None)
    if kind not in ("vertex", "face"):
        return None
    colors = geometry.visual.vertex_colors if kind == "vertex" else geometry.visual.face_colors
    return np.asarray(colors, np.float32) / 255.0


def _material(geometry: Any) -> Face | None:
    """The file's material as k_a, k_d, k_s, emission and shininess n; None if the file has none.

    A physically based material keeps its base colour as k_d; its roughness r becomes the Blinn exponent
    n = 2 / r^4 - 2 (Walter et al. 2007, with alpha = r^2), at most 128.
    """
    source = getattr(geometry.visual, "material", None)
    if source is None:
        return None
    rgba = np.asarray(getattr(source, "main_color", (204, 204, 204, 255)), float) / 255.0
    diffuse: Color = (float(rgba[0]), float(rgba[1]), float(rgba[2]), 1.0)
    roughness = getattr(source, "roughnessFactor", None)
    if hasattr(source, "baseColorFactor"):
        r = 1.0 if roughness is None else max(float(roughness), 0.05)
        n = min(max(2.0 / r**4 - 2.0, 0.0), 128.0)
        k_s = 0.04 if not getattr(source, "metallicFactor", 0.0) else 0.6
        specular: Color = (k_s, k_s, k_s, 1.0)
    else:
        given = np.asarray(getattr(source, "specular", (0, 0, 0, 255)), float)[:3] / 255.0
        specular = (*map(float, given), 1.0)  # type: ignore[assignment]
        n = min(max(float(getattr(source, "glossiness", 0.0) or 0.0), 0.0), 128.0)
    emissive = getattr(source, "emissiveFactor", None)
    emission: Color = BLACK if emissive is None else (*map(float, emissive[:3]), 1.0)  # type: ignore[assignment]
    ambient: Color = (diffuse[0], diffuse[1], diffuse[2], 1.0)
    return Face(ambient, diffuse, specular, emission, n)


def fit(meshes: list[Mesh]) -> list[Mesh]:
    """Move and scale meshes together into the unit sphere around the origin."""
    used = [mesh.positions[np.concatenate([mesh.triangles.ravel(), mesh.quads.ravel()])] for mesh in meshes]
    low = np.min([points.min(axis=0) for points in used], axis=0)
    high = np.max([points.max(axis=0) for points in used], axis=0)
    centre = (low.astype(np.float64) + high) / 2
    radius = max(float(np.linalg.norm(points - centre, axis=1).max()) for points in used)
    for mesh in meshes:
        mesh.positions = ((mesh.positions - centre) / radius).astype(np.float32)
    return meshes
