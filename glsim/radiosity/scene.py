"""Scenes: polygons with reflectance and exitance, checked before form factors are computed.

Conventions (Cohen & Wallace 1993): everything in one unit of length; rho in [0, 1) and E >= 0 per channel, diffuse; a
polygon shows its front on the side from which its corners run counterclockwise, and only fronts reflect and emit.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim.radiosity.sheets import sheets
from glsim.radiosity.textures import Texture, mapping_of

Float = NDArray[np.float64]
Channels = tuple[float, float, float]
BRIGHTEST = 0.99  # reflectance: a file or a program may say 1, and light would never end
THINNEST = 1e-10  # area of a polygon, in squares of its diameter: thinner ones are dropped
FLAT = 1e-5  # how far a corner may be from its polygon's plane, in diameters


class SceneError(ValueError):
    """A scene for which there is no radiosity; the message says what is wrong and what to do."""


class Material(NamedTuple):
    """rho: diffuse reflectance, E: exitance (W/m^2 or any unit of it), for red, green and blue.

    texture: its texels are multiplied by rho.
    """

    name: str
    rho: Channels
    E: Channels = (0.0, 0.0, 0.0)
    texture: Texture | None = None


class View(NamedTuple):
    """A camera.  fov: degrees from bottom to top; name: by which it is chosen."""

    eye: Channels
    target: Channels
    up: Channels = (0.0, 1.0, 0.0)
    fov: float = 45.0
    name: str = ""


@dataclass(frozen=True, repr=False)
class Scene:
    """What is solved: polygons with materials, and cameras.

    polygons: convex, (k, 3) each, k >= 3; material: for each its number in ``materials``; group: for each the number of
    the object that it belongs to (for smooth normals); views: the first is the usual one; notes: what was mended;
    mapping: for each polygon the M of its texture coordinates (see textures.py), or None; white, tone: how its pictures
    are exposed, see tone.py (None: chosen by the result).
    """

    name: str
    polygons: tuple[Float, ...]
    material: tuple[int, ...]
    materials: tuple[Material, ...]
    views: tuple[View, ...] = ()
    group: tuple[int, ...] = ()
    notes: tuple[str, ...] = field(default=())
    mapping: tuple[Float | None, ...] = ()
    white: float | None = None
    tone: str = "linear"

    def __repr__(self) -> str:
        polygons, lamps = len(self.polygons), len(self.emitters)
        return f"<Scene {self.name}: {polygons} polygons, {lamps} emitting, {len(self.materials)} materials>"

    @cached_property
    def size(self) -> float:
        """The length of the bounding box's diagonal."""
        points = np.concatenate(self.polygons)
        return float(np.linalg.norm(np.ptp(points, axis=0)))

    @cached_property
    def vectors(self) -> Float:
        """Twice the areas of the polygons along their normals, by Newell's method: (number of polygons, 3)."""
        result = np.empty((len(self.polygons), 3))
        for numbers, corners in self.by_corners:
            around = corners - corners[:, :1]
            result[numbers] = np.cross(around, np.roll(around, -1, axis=1)).sum(axis=1)
        return result

    @cached_property
    def by_corners(self) -> list[tuple[NDArray[np.int64], Float]]:
        """The polygons by how many corners they have: numbers (m,) and corners (m, k, 3) for each k."""
        many = np.array([len(polygon) for polygon in self.polygons])
        numbers = [np.flatnonzero(many == k) for k in np.unique(many)]
        return [(some, np.array([self.polygons[k] for k in some.tolist()])) for some in numbers]

    @cached_property
    def normals(self) -> Float:
        """Unit normals of the polygons, (number of polygons, 3); zeros without an area."""
        length = np.linalg.norm(self.vectors, axis=1, keepdims=True)
        return np.asarray(np.divide(self.vectors, length, out=np.zeros_like(self.vectors), where=length > 0.0))

    @cached_property
    def areas(self) -> Float:
        """The areas of the polygons, (number of polygons,)."""
        return np.asarray(np.linalg.norm(self.vectors, axis=1) / 2.0)

    @property
    def emitters(self) -> list[int]:
        """The numbers of the polygons that emit."""
        return [k for k, m in enumerate(self.material) if max(self.materials[m].E) > 0.0]

    def flipped(self) -> Scene:
        """Return the scene with all fronts turned to the other side."""
        return replace(self, polygons=tuple(polygon[::-1] for polygon in self.polygons))

    def two_sided(self) -> Scene:
        """Return the scene with a second front for each sheet; the surfaces of bodies keep one."""
        open_ = np.flatnonzero(sheets(self.polygons)).tolist() if self.polygons else []
        groups = self.group or tuple(range(len(self.polygons)))
        mapping = self.mapping or (None,) * len(self.polygons)
        return replace(
            self, polygons=(*self.polygons, *(self.polygons[k][::-1] for k in open_)),
            material=(*self.material, *(self.material[k] for k in open_)),
            group=(*groups, *(max(groups) + 1 + groups[k] for k in open_)),
            mapping=(*mapping, *(mapping[k] for k in open_)),
        )  # fmt: skip

    def triangles(self) -> Float:
        """Return all polygons as fans of triangles: (m, 3, 3), one polygon after the other."""
        return np.array(
            [(polygon[0], polygon[k], polygon[k + 1]) for polygon in self.polygons for k in range(1, len(polygon) - 1)]
        )

    def checked(self) -> Scene:
        """Return the scene as a solver needs it: planar convex polygons, each once; ``notes`` say what was mended.

        Raises SceneError for what cannot be mended: reflectances that are not in [0, 1), exitances below 0, coordinates
        that are not finite, no polygon, no emitter.
        """
        for material in self.materials:
            _check_material(material)
        if not self.polygons:
            raise SceneError(f"{self.name}: there is no polygon")
        good: list[tuple[Float, int, int, Float | None]] = []
        flat, crooked, twice = (
            "degenerate polygons, dropped", "polygons that were not planar, split into triangles",
            "duplicate polygons, dropped",
        )  # fmt: skip
        counts = dict.fromkeys((flat, crooked, twice), 0)
        seen: set[Any] = set()
        scale = self.size
        groups = self.group or tuple(self.material)
        mapping = self.mapping or (None,) * len(self.polygons)
        whole = zip(self.polygons, self.material, groups, mapping, strict=True)
        sound = _sound_triangles(self.polygons, scale)
        for number, (given, paint, group, M) in enumerate(whole):
            if number in sound:
                parts = [(np.asarray(given, np.float64), sound[number])]
            elif np.isfinite(given).all():
                parts = [
                    (part, normal_of(part)) for part in planar(_without_repeats(np.asarray(given, np.float64), scale))
                ]
            else:
                raise SceneError(f"{self.name}: polygon {number} has coordinates that are not finite numbers")
            counts[crooked] += len(parts) > 1
            counts[flat] += not parts
            for polygon, normal in parts:  # the other side of a sheet has another normal and is no duplicate
                key = frozenset(map(tuple, (polygon / scale).round(7).tolist())), *(normal.round(3) + 0.0).tolist()
                counts[twice] += key in seen
                if key not in seen:
                    seen.add(key)
                    good.append((polygon, paint, group, M))
        notes = [*self.notes, *(f"{words}: {count}" for words, count in counts.items() if count)]
        if not good:
            raise SceneError(f"{self.name}: all polygons are degenerate (no area)")
        polygons, materials, good_groups, maps = zip(*good, strict=True)
        result = replace(
            self, polygons=polygons, material=materials, group=good_groups, notes=tuple(notes), mapping=maps
        )
        if not result.emitters:
            raise SceneError(
                f"{self.name}: nothing emits light: give a material an exitance E > 0 (in a file: an emissive colour;"
                " in a program: glMaterial with GL_EMISSION, drawn while GL_LIGHTING is enabled)"
            )
        return result


def _check_material(material: Material) -> None:
    """Raise SceneError if rho or E is not what it may be."""
    name = f"material {material.name!r}"
    try:
        rho, E = np.asarray(material.rho, float), np.asarray(material.E, float)
    except (TypeError, ValueError):
        raise SceneError(f"{name}: rho = {material.rho!r} and E = {material.E!r} must be numbers") from None
    if rho.shape != (3,) or E.shape != (3,):
        raise SceneError(f"{name}: rho and E need three numbers each (red, green, blue)")
    if not np.isfinite([rho, E]).all():
        raise SceneError(f"{name}: rho = {material.rho} and E = {material.E} must be finite numbers")
    brightest = rho if material.texture is None else rho * material.texture.peak
    if (rho < 0.0).any() or (brightest >= 1.0).any():
        raise SceneError(
            f"{name}: the reflectance rho = {material.rho} must be at least 0 and less than 1, or light never ends"
        )
    if (E < 0.0).any() or (E > 1e30).any():
        raise SceneError(f"{name}: the exitance E = {material.E} must not be negative, nor above 1e30")


def normal_of(polygon: Float) -> Float:
    """Return the unit normal (3,) of a polygon (k, 3) by Newell's method; zeros if it has no area."""
    polygon = polygon - polygon[0]
    n = np.cross(polygon, np.roll(polygon, -1, axis=0)).sum(axis=0)
    length = np.linalg.norm(n)
    return np.asarray(n / length if length > 0.0 else np.zeros(3))


def area_of(polygon: Float) -> float:
    """Return the area of a planar polygon (k, 3)."""
    edges = polygon[1:] - polygon[0]
    return float(np.linalg.norm(np.cross(edges[:-1], edges[1:]).sum(axis=0)) / 2.0)


def _sound_triangles(polygons: Sequence[Float], scale: float) -> dict[int, Float]:
    """Return the unit normals of triangles that need no mending, by their numbers: most polygons of a large file."""
    numbers = [number for number, polygon in enumerate(polygons) if len(polygon) == 3]
    corners = np.array([polygons[number] for number in numbers], np.float64).reshape(-1, 3, 3)
    with np.errstate(invalid="ignore", over="ignore"):
        edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        length, size = np.linalg.norm(normals, axis=1), np.linalg.norm(np.ptp(corners, axis=1), axis=1)
        good = (edges > 1e-9 * scale).all(axis=1) & (length >= 2.0 * THINNEST * size * size) & (length > 0.0)
        good &= np.isfinite(length)
    return dict(zip(np.array(numbers, int)[good].tolist(), normals[good] / length[good, None], strict=True))


def _without_repeats(polygon: Float, scale: float) -> Float:
    """Return the polygon without corners that coincide with the corner before."""
    apart = np.linalg.norm(polygon - np.roll(polygon, 1, axis=0), axis=1) > 1e-9 * scale
    return np.asarray(polygon[apart])


def planar(polygon: Float) -> list[Float]:
    """Return the polygon if it is planar and convex, else triangles of it; nothing if it has no area."""
    if len(polygon) < 3:
        return []
    size = float(np.linalg.norm(np.ptp(polygon, axis=0)))
    normal = normal_of(polygon)
    if area_of(polygon) < THINNEST * size * size or not normal.any():
        return []
    if len(polygon) == 3:
        return [polygon]
    flat = np.abs((polygon - polygon[0]) @ normal).max() <= FLAT * size
    turns = np.cross(np.roll(polygon, -1, 0) - polygon, np.roll(polygon, -2, 0) - np.roll(polygon, -1, 0)) @ normal
    if flat and (turns >= -1e-9 * size * size).all():
        return [polygon]
    if len(polygon) == 4:  # along the diagonal that makes a hollow, so that neither triangle hides the other
        hollow = (polygon[3] - polygon[0]) @ normal_of(polygon[[0, 1, 2]]) >= 0.0
        parts = [polygon[[0, 1, 2]], polygon[[0, 2, 3]]] if hollow else [polygon[[0, 1, 3]], polygon[[1, 2, 3]]]
        if all(normal_of(part) @ normal > 0.0 for part in parts):
            return parts
    return _ears(polygon, normal)


def _ears(polygon: Float, normal: Float) -> list[Float]:
    """Cut a simple polygon into triangles, ear by ear."""
    corners = list(range(len(polygon)))
    triangles = []
    while len(corners) > 3:
        for k in range(len(corners)):
            a, b, c = (corners[(k + d) % len(corners)] for d in (-1, 0, 1))
            triangle = polygon[[a, b, c]]
            if normal_of(triangle) @ normal <= 0.0:
                continue
            others = polygon[[m for m in corners if m not in (a, b, c)]]
            if not _inside(others, triangle, normal).any():
                triangles.append(triangle)
                corners.pop(k)
                break
        else:
            break
    if len(corners) == 3:
        triangles.append(polygon[corners])
    return triangles


def _inside(points: Float, polygon: Float, normal: Float) -> NDArray[np.bool_]:
    """Return which points (n, 3) of its plane are inside a convex polygon: (n,)."""
    result = np.ones(len(points), bool)
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
        result &= np.cross(b - a, points - a) @ normal > 0.0
    return result


# ---------------------------------------------------------------- building


def quad(*corners: ArrayLike) -> Float:
    """Return a polygon from its corners (x, y, z), counterclockwise as seen from its front."""
    return np.array(corners, np.float64)


def box(low: Sequence[float], high: Sequence[float], inside: bool = False) -> list[Float]:
    """Return the six faces of a box, -x, +x, -y, +y, -z, +z; their fronts look outwards, with ``inside`` inwards."""
    (a, b, c), (d, e, f) = low, high
    faces = [
        quad((a, b, c), (a, b, f), (a, e, f), (a, e, c)), quad((d, b, c), (d, e, c), (d, e, f), (d, b, f)),
        quad((a, b, c), (d, b, c), (d, b, f), (a, b, f)), quad((a, e, c), (a, e, f), (d, e, f), (d, e, c)),
        quad((a, b, c), (a, e, c), (d, e, c), (d, b, c)), quad((a, b, f), (d, b, f), (d, e, f), (a, e, f)),
    ]  # fmt: skip
    return [face[::-1] for face in faces] if inside else faces


class Builder:
    """Collects polygons, one material after the other, for a Scene."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.polygons: list[Float] = []
        self.material: list[int] = []
        self.group: list[int] = []
        self.mapping: list[Float | None] = []
        self.materials: list[Material] = []
        self.numbers: dict[Any, int] = {}  # of the materials

    def add(
        self, polygons: Iterable[ArrayLike], material: Material, smooth: bool = False,
        st: Iterable[ArrayLike] | None = None,
    ) -> None:  # fmt: skip
        """Add polygons (k, 3) of one material; ``smooth``: they are one curved surface.

        st: for each the texture coordinates (k, 2) of its corners, from the lower left of the picture on; needed by a
        material with a texture.  Raises SceneError for other shapes.
        """
        number = self.numbers.setdefault((repr(material[:3]), material.texture), len(self.materials))
        self.materials += [material] if number == len(self.materials) else []
        group = self.group[-1] + 1 if self.group else 0
        polygons = list(polygons)
        coordinates = [None] * len(polygons) if st is None else list(st)
        if (material.texture is not None and st is None) or len(coordinates) != len(polygons):
            raise SceneError(
                f"{self.name}: material {material.name!r} has a texture: add needs st, the texture coordinates (k, 2)"
                f" of each of the {len(polygons)} polygons"
            )
        for given, pair in zip(polygons, coordinates, strict=True):
            corners = self._array(given, 3, "a list of polygons, each a list of corners (x, y, z)")
            self.polygons.append(corners)
            self.mapping.append(None if pair is None else self._mapping(corners, pair))
            self.material.append(number)
            self.group.append(group)
            group += not smooth

    def _array(self, given: Any, many: int, wanted: str) -> Float:
        """Return an array (k, many).  Raises SceneError for another shape."""
        try:
            values = np.array(given, np.float64)
        except (TypeError, ValueError):
            values = np.zeros(0)
        if values.ndim != 2 or values.shape[1] != many:
            raise SceneError(f"{self.name}: add takes {wanted}, not {given!r}")
        return values

    def _mapping(self, corners: Float, given: Any) -> Float:
        """Return the M of a polygon's texture coordinates.  Raises SceneError if they are none."""
        st = self._array(given, 2, "texture coordinates (s, t) of each corner")
        M = mapping_of(corners, st) if len(st) == len(corners) else None
        if M is None:
            raise SceneError(
                f"{self.name}: texture coordinates must fit a flat picture, one pair a corner, not {given}"
            )
        return M

    def scene(self, *views: View) -> Scene:
        """Return the scene with these cameras."""
        return Scene(
            self.name, tuple(self.polygons), tuple(self.material), tuple(self.materials), views, tuple(self.group),
            mapping=tuple(self.mapping),
        )  # fmt: skip
