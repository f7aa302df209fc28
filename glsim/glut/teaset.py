"""GLUT's tea set: teapot, teacup and teaspoon from Bezier patches, number by number as freeglut 3.4 draws them.

Faces are clockwise seen from outside; lengths are in object coordinates.  shapes.npz has the patches: control points
(n, 3), z up, and for each patch the 16 that it joins.  They are Martin Newell's teapot of 1975, and the teacup and
teaspoon of the same family, in the form that freeglut ships (MIT licence; FONTS.md has the notice).
"""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from glsim import gl
from glsim.glut import shapes
from glsim.glut.shapes import MEMORY, Array, Shape, geometry, length, rows
from glsim.machine.cache import cached


class Vessel(NamedTuple):
    """How a member of the tea set follows from its patches."""

    part: float  # the scale is the size divided by ``part``
    middle: float  # the z of the control points that becomes y = 0
    copies: tuple[int, ...]  # for each patch how often it is drawn: 4 quarter turns, 2 by a reflection, or 1
    poles: dict[int, float]  # number of a patch whose first row is one point -> y of the normal at this point


VESSELS = {
    "teapot": Vessel(1.0, 1.575, (4,) * 6 + (2,) * 4, {3: 1.0, 5: -1.0}),
    "teacup": Vessel(2.5, 1.5121, (4,) * 6 + (2,), {}),
    "teaspoon": Vessel(2.5, -0.0315, (1,) * 16, {}),
}


@lru_cache(1)
def _patches() -> dict[str, Array]:
    """Control points (patches, 4, 4, 3) of each vessel, z up."""
    with np.load(Path(__file__).with_name("shapes.npz")) as data:
        return {name: data[f"{name}_points"][data[f"{name}_patches"]].reshape(-1, 4, 4, 3) for name in VESSELS}


def _bernstein(n: int) -> tuple[Array, Array]:
    """The four cubic Bernstein polynomials at n points of [0, 1], and their derivatives: (n, 4) each, in float32."""
    x = np.arange(n, dtype=np.float32) / np.float32(n - 1)
    y = 1 - x
    values = np.stack([y * (y * y), 3 * x * (y * y), 3 * (x * x) * y, x * (x * x)], axis=1)
    slopes = np.stack([-3 * (y * y), 3 * (y * y) - 6 * x * y, 6 * x * y - 3 * (x * x), 3 * (x * x)], axis=1)
    return values, slopes


def _blend(weights: Array, points: Array) -> Array:
    """Sum over axis -2 of the points (..., 4, m) with weights (n, 4): (..., n, m), added from first to last."""
    total: Array = weights[:, 0, None] * points[..., :1, :]
    for k in range(1, 4):
        total = total + weights[:, k, None] * points[..., k : k + 1, :]
    return total


def _surface(along: Array, across: Array, control: Array) -> Array:
    """Points (patches, n, n, 3): ``along`` weighs the rows of the control points, ``across`` the columns."""
    patches, n = len(control), len(along)
    rows: Array = _blend(across, control).reshape(patches, 4, n * 3)
    points: Array = _blend(along, rows).reshape(patches, n, n, 3)
    return points


def _unit_normals(control: Array, n: int, poles: dict[int, float]) -> Array:
    values, slopes = _bernstein(n)
    a, b = _surface(values, slopes, control), _surface(slopes, values, control)
    (ax, ay, az), (bx, by, bz) = np.moveaxis(a, -1, 0), np.moveaxis(b, -1, 0)
    normals: Array = np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=-1)
    x, y, z = np.moveaxis(normals, -1, 0)
    with np.errstate(invalid="ignore"):
        normals = normals / np.sqrt(x * x + y * y + z * z)[..., None]
    normals[np.isnan(normals).any(axis=-1)] = 0.0, 0.0, 1.0  # the tip of the teaspoon: freeglut has no number there
    for patch, up in poles.items():
        normals[patch, 0] = 0.0, up, 0.0
    return normals


def _copies(grid: Array, copies: int) -> list[Array]:
    """A patch (n, n, 3) turned around y by quarters, or reflected in z with its rows backwards."""
    if copies == 1:
        return [grid]
    if copies == 2:
        return [grid, grid[::-1] * np.array([1, 1, -1], np.float32)]
    x, y, z = np.moveaxis(grid, -1, 0)
    return [np.stack(turned, axis=-1) for turned in ((x, y, z), (z, y, -x), (-x, y, -z), (-z, y, x))]


@cached(MEMORY)
def _tea(name: str, size: float, wire: bool) -> Shape:
    """Solid: 7 x 7 quads for each patch, in two triangles each; wire: 10 x 10 line strips."""
    vessel, n = VESSELS[name], 10 if wire else 8
    scale = np.float32(size) / np.float32(vessel.part)
    x, y, z = np.moveaxis(_patches()[name], -1, 0)
    control = rows(x * scale / 2, (z - np.float32(vessel.middle)) * scale / 2, -y * scale / 2).reshape(-1, 4, 4, 3)
    values, _ = _bernstein(n)
    surfaces = _surface(values, values, control), _unit_normals(control, n, vessel.poles)
    vertices, normals = (
        np.concatenate([copy for k, grid in enumerate(s) for copy in _copies(grid, vessel.copies[k])]).reshape(-1, 3)
        for s in surfaces
    )
    grids = np.arange(len(vertices)).reshape(-1, n, n)
    if wire:
        strips = [grids.transpose(0, 2, 1).reshape(-1, n), grids.reshape(-1, n)]
        return geometry(vertices, normals, (gl.GL_LINE_STRIP, np.concatenate(strips)))
    a, b, c, d = grids[:, :-1, :-1], grids[:, 1:, :-1], grids[:, 1:, 1:], grids[:, :-1, 1:]
    u, v = np.meshgrid(*[np.arange(n, dtype=np.float32) / np.float32(n - 1)] * 2, indexing="ij")
    texture = np.tile(np.stack([u, v], axis=-1).reshape(-1, 2), (len(grids), 1))
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(1, -1)
    return geometry(vertices, normals, (gl.GL_TRIANGLES, triangles), texture=texture)


def glutSolidTeapot(size: float) -> None:
    """The Utah teapot, y up, its middle height at y = 0, with texture coordinates."""
    shapes.draw_geometry(_tea("teapot", length("glutSolidTeapot", "size", size), False))


def glutWireTeapot(size: float) -> None:
    """The Utah teapot in lines along both directions of each patch."""
    shapes.draw_geometry(_tea("teapot", length("glutWireTeapot", "size", size), True))


def glutSolidTeacup(size: float) -> None:
    """The Utah teacup, y up, with texture coordinates."""
    shapes.draw_geometry(_tea("teacup", length("glutSolidTeacup", "size", size), False))


def glutWireTeacup(size: float) -> None:
    """The Utah teacup in lines along both directions of each patch."""
    shapes.draw_geometry(_tea("teacup", length("glutWireTeacup", "size", size), True))


def glutSolidTeaspoon(size: float) -> None:
    """The Utah teaspoon, y up, with texture coordinates."""
    shapes.draw_geometry(_tea("teaspoon", length("glutSolidTeaspoon", "size", size), False))


def glutWireTeaspoon(size: float) -> None:
    """The Utah teaspoon in lines along both directions of each patch."""
    shapes.draw_geometry(_tea("teaspoon", length("glutWireTeaspoon", "size", size), True))
