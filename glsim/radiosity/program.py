"""Scenes for radiosity from what a program draws: which side of a polygon reflects, and what is one smooth surface.

OpenGL lights a polygon by its normals, whichever way its corners run, and culls it by its corners, whichever way its
normals look.  Radiosity needs one front: the side to which the normals look, where the program gives them; else the
side that GL_FRONT_FACE and GL_CULL_FACE show.  Where the two disagree, or neither decides, the scene gets a note.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import BRIGHTEST, Builder, Material, Scene, SceneError, View, normal_of
from glsim.radiosity.sheets import SAME, places, sheets

Float = NDArray[np.float64]
Int = NDArray[np.int64]
ACROSS = 0.5  # of |mean vertex normal . the polygon's own|: up to this the vertex normals do not decide the front


class DrawnPolygon(NamedTuple):
    """One polygon in eye space, its front counterclockwise.

    polygon, normals: (k, 3), the normals zeros where they tell nothing; material, back: of the other side, None if
    only the front reflects; smooth: GL_SMOOTH; doubt: why the choice of the front is uncertain, a key of DOUBTS, or "".
    """

    polygon: Float
    normals: Float
    material: Material
    back: Material | None
    smooth: bool
    doubt: str


DOUBTS = {
    "against": "polygons whose normals look away from the side that winding and GL_FRONT_FACE make the front: normals"
    " decided",
    "unsaid": "polygons without fitting normals (glNormal) or GL_CULL_FACE: winding alone decided which side reflects",
}


def from_frame(frame: Any, name: str = "frame") -> Scene:
    """Return the polygons of a Frame in eye space: k_d becomes rho, emission E.

    What is drawn unlit reflects its colour.  OpenGL's lights are left out: in radiosity light comes from surfaces, so
    something must have GL_EMISSION.  A sheet that is lit with GL_LIGHT_MODEL_TWO_SIDE reflects on both sides.
    """
    from glsim.machine.assembly import corners

    draws = [draw for draw in frame.draws if corners(draw.mode) == 3 and draw.count]
    surfaces = [surface for draw in draws for surface in _surfaces(draw)]
    if not surfaces:
        raise SceneError(f"{name}: no polygons are drawn")
    b = Builder(Path(name).name)
    open_ = sheets([surface.polygon for surface in surfaces])
    for part in _parts(surfaces):
        b.add([surfaces[k].polygon for k in part], surfaces[part[0]].material, smooth=True)
        for back in dict.fromkeys(surfaces[k].back for k in part if open_[k]):
            if back is not None:
                b.add([surfaces[k].polygon[::-1] for k in part if surfaces[k].back == back], back, smooth=True)
    doubts = [surface.doubt for surface in surfaces]
    notes = [f"{words}: {doubts.count(doubt)}" for doubt, words in DOUBTS.items() if doubt in doubts]
    return replace(b.scene(_view_in(draws[0].matrices[1].get().astype(np.float64))), notes=tuple(notes))


def _surfaces(draw: Any) -> list[DrawnPolygon]:
    """Return the polygons of one Draw of a Frame."""
    from glsim.machine.assembly import outlines
    from glsim.machine.constants import GL_CW, GL_FRONT, GL_SMOOTH

    count = draw.count if draw.indices is None else len(draw.indices)
    polygons, _ = outlines(draw.mode, count)
    numbers = (np.arange(count) if draw.indices is None else draw.indices.astype(np.int64)) + draw.first
    modelview, projection = (matrix.get().astype(np.float64) for matrix in draw.matrices[:2])
    rows = draw.block.rows[numbers].astype(np.float64)
    points = np.c_[rows[:, :3], np.ones(len(rows))] @ modelview
    points = points[:, :3] / points[:, 3:]
    polygon, lighting = draw.state.polygon, draw.state.lighting
    object_normals = rows[:, 3:6]
    normals = _normals(object_normals, modelview)
    # all normals are initial, or one constant without lighting: they may confirm the front by winding, not overrule it
    left = (object_normals == (0.0, 0.0, 1.0)).all()
    left |= not lighting.enabled and len(rows) > 0 and (object_normals == object_normals[0]).all()
    shown = polygon.front_face != GL_CW  # whether the side from which corners run counterclockwise is the front
    shown ^= bool(np.linalg.det(projection[:2, :2]) < 0.0)  # the projection is a mirror
    shown ^= polygon.cull and polygon.cull_face == GL_FRONT  # only backs are seen
    both = lighting.enabled and lighting.two_side and not polygon.cull
    face_normals = np.array([normal_of(points[polygon]) for polygon in polygons])
    along = np.einsum("nk,nk->n", normals[polygons].mean(axis=1), face_normals)
    told = (np.abs(along) > ACROSS) & ~(left & ((along > 0.0) != shown))
    votes = along[told] if not left else along[:0]
    usual = bool(votes.sum() > 0.0) if len(votes) else shown  # for polygons whose normals do not decide
    unsaid = not len(votes) and not polygon.cull and not both
    surfaces = []
    for polygon, normal, sure, outwards in zip(polygons, face_normals, told, along > 0.0, strict=True):
        front = outwards if sure else usual
        doubt = "against" if front != shown else "unsaid" if unsaid and normal.any() and not sure else ""
        order = slice(None) if front else slice(None, None, -1)
        sides = _materials(draw, int(numbers[polygon[-1]]))
        surfaces.append(
            DrawnPolygon(points[polygon][order], normals[polygon][order] * sure, sides[0], sides[1] if both else None,
                    lighting.shade_model == GL_SMOOTH, doubt)
        )  # fmt: skip
    return surfaces


def _normals(object_normals: Float, modelview: Float) -> Float:
    """Return unit normals (n, 3) in eye space; zeros where the matrix has no inverse, as that of a flat shadow."""
    try:
        normals = object_normals @ np.linalg.inv(modelview)[:3, :3].T
    except np.linalg.LinAlgError:
        return np.zeros_like(object_normals)
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300))


def _materials(draw: Any, vertex: int) -> tuple[Material, Material]:
    """Return the materials of the front and of the back of a polygon, at its last vertex."""
    color = draw.color or tuple(draw.block.rows[vertex, 6:10].tolist())
    lighting = draw.state.lighting
    if not lighting.enabled:
        return (_material(color, (0.0, 0.0, 0.0)),) * 2
    from glsim.machine.constants import GL_BACK, GL_FRONT
    from glsim.machine.state import TRACKED

    sides = draw.materials_at(np.array([vertex]))[0]
    materials = []
    for side, other in ((sides.front, GL_BACK), (sides.back, GL_FRONT)):
        tracked: tuple[str, ...] = ()
        if lighting.color_material and lighting.color_material_face != other:
            tracked = TRACKED.get(lighting.color_material_mode, ("emission",))
        rho = color if "diffuse" in tracked else side.diffuse
        materials.append(_material(rho, color if "emission" in tracked else side.emission))
    return materials[0], materials[1]


def _material(rho: Any, emission: Any) -> Material:
    """Return a material from OpenGL's diffuse and emissive colour, named after both."""
    r, g, b = (min(max(float(value), 0.0), BRIGHTEST) for value in rho[:3])
    E = (float(emission[0]), float(emission[1]), float(emission[2]))
    name = f"k_d {r:.3g} {g:.3g} {b:.3g}" + (" emitting" if max(E) > 0.0 else "")
    return Material(name, (r, g, b), E)


def _view_in(projection: Float) -> View:
    """Return the program's own camera, at the origin of eye space, from its projection matrix (stored by columns)."""
    fov = float(np.degrees(2.0 * np.arctan(1.0 / projection[1, 1]))) if projection[2, 3] != 0.0 else 60.0
    return View((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), fov=fov)


# ---------------------------------------------------------------- what belongs together


def _parts(surfaces: list[DrawnPolygon]) -> list[list[int]]:
    """Group the numbers of polygons that form one smooth surface.

    They have one material, and share a corner and the normal there, at once or through others.
    """
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    owner, place = places([surface.polygon for surface in surfaces])
    normals = np.concatenate([surface.normals for surface in surfaces])
    kinds = {material: k for k, material in enumerate(dict.fromkeys(surface.material for surface in surfaces))}
    kind = np.array([kinds[surface.material] for surface in surfaces])[owner]
    keys = np.c_[place, kind, np.round(normals / SAME)]
    _, key = np.unique(keys, axis=0, return_inverse=True)
    smooth = normals.any(axis=1) & np.array([surface.smooth for surface in surfaces])[owner]
    n = len(surfaces)
    edges = owner[smooth], n + key.ravel()[smooth]
    graph = coo_matrix((np.ones(len(edges[0])), edges), shape=(n + len(keys),) * 2)
    label = connected_components(graph, directed=False)[1][:n].tolist()
    parts: dict[int, list[int]] = {}
    for surface, number in enumerate(label):
        parts.setdefault(number, []).append(surface)
    return list(parts.values())
