"""GLUT's shapes around an axis: spheres, cones, cylinders and tori, with freeglut's vertices, see shapes.py."""

from __future__ import annotations

import math

import numpy as np

from glsim import gl
from glsim.glut import shapes
from glsim.glut.shapes import MEMORY, Array, Indices, Shape, geometry, length, pieces_of, rows
from glsim.machine.cache import cached


def _circle(n: int, half: bool = False) -> tuple[Array, Array]:
    """Sines and cosines of abs(n) + 1 angles around, clockwise where n < 0; the last is exactly the first."""
    angle = np.float32((1 if half else 2) * np.float32(math.pi)) / np.float32(n)
    angles = (angle * np.arange(abs(n) + 1, dtype=np.float32)).astype(np.float64)
    sines, cosines = np.sin(angles).astype(np.float32), np.cos(angles).astype(np.float32)
    sines[0], cosines[0] = 0.0, 1.0
    sines[-1], cosines[-1] = 0.0, -1.0 if half else 1.0
    return sines, cosines


def _strips(upper: Indices, lower: Indices) -> Indices:
    """Triangle strips between rings: (strips, vertices around) each, closed."""
    pairs = np.stack([upper, lower], axis=-1)
    return np.concatenate([pairs, pairs[:, :1]], axis=1).reshape(len(pairs), -1)


def _steps(start: np.float32, step: np.float32, n: int) -> Array:
    """start, start + step, ... as repeated addition in float32 gives them: n + 1 numbers."""
    return np.cumsum(np.array([start] + [step] * n, np.float32), dtype=np.float32)


def _rings(first: int, rings: int, slices: int) -> Indices:
    return first + np.arange(rings * slices).reshape(rings, slices)


@cached(MEMORY)
def _sphere(radius: float, slices: int, stacks: int, wire: bool) -> Shape:
    sine, cosine = (table[:-1] for table in _circle(-slices))
    ring, axis = (table[1:-1, None] for table in _circle(stacks, half=True))
    pole = np.array([[0.0, 0.0, 1.0]], np.float32)
    normals = np.concatenate([pole, rows(cosine * ring, sine * ring, axis), -pole])
    vertices = normals * np.float32(radius)
    around = _rings(1, stacks - 1, slices)
    ends = [np.full((1, slices), pole) for pole in (0, len(vertices) - 1)]
    rings = np.concatenate([ends[0], around, ends[1]])
    if wire:
        return geometry(vertices, normals, (gl.GL_LINE_STRIP, rings.T), (gl.GL_LINE_LOOP, around))
    return geometry(vertices, normals, (gl.GL_TRIANGLE_STRIP, _strips(rings[1:], rings[:-1])))


def glutSolidSphere(radius: float, slices: int, stacks: int) -> None:
    """Around the origin, with the poles on the z axis; at least 1 slice and 2 stacks."""
    shapes.draw_geometry(_sphere(*_sphere_arguments("glutSolidSphere", radius, slices, stacks), False))


def glutWireSphere(radius: float, slices: int, stacks: int) -> None:
    """The meridians, then the circles of latitude."""
    shapes.draw_geometry(_sphere(*_sphere_arguments("glutWireSphere", radius, slices, stacks), True))


def _sphere_arguments(name: str, radius: float, slices: int, stacks: int) -> tuple[float, int, int]:
    return length(name, "radius", radius), *pieces_of(name, "slices", slices, 1, "stacks", stacks, 2)


@cached(MEMORY)
def _cone(base: float, height: float, slices: int, stacks: int, wire: bool) -> Shape:
    sine, cosine = (table[:-1] for table in _circle(-slices))
    r, h = np.float32(base), np.float32(height)
    z = _steps(np.float32(0), h / np.float32(stacks), stacks)[:, None]
    radii = _steps(r, -r / np.float32(stacks), stacks)[:, None]
    slant = math.sqrt(h * h + r * r)
    flank, slope = (np.float32(float(side) / slant if slant else 0.0) for side in (h, r))
    vertices = np.concatenate(
        [np.zeros((1, 3), np.float32), rows(cosine * r, sine * r, 0), rows(cosine * radii, sine * radii, z)]
    )
    down = np.tile(np.array([[0.0, 0.0, -1.0]], np.float32), (1 + slices, 1))
    side = rows(cosine * flank, sine * flank, slope)
    normals = np.concatenate([down, np.tile(side, (stacks + 1, 1))])
    rings = _rings(1, stacks + 2, slices)
    if wire:
        return _wire_tube(vertices, normals, rings[1:], rings[1:-1])
    upper = np.concatenate([np.zeros((1, slices), int), rings[1:-1]])
    lower = np.concatenate([rings[:1], rings[2:]])
    return geometry(vertices, normals, (gl.GL_TRIANGLE_STRIP, _strips(upper, lower)))


def _wire_tube(vertices: Array, normals: Array, rings: Indices, drawn: Indices) -> Shape:
    """Straight lines from the first to the last ring, then the rings that are drawn."""
    lines = np.stack([rings[0], rings[-1]], axis=1).reshape(1, -1)
    return geometry(vertices, normals, (gl.GL_LINES, lines), (gl.GL_LINE_LOOP, drawn))


def glutSolidCone(base: float, height: float, slices: int, stacks: int) -> None:
    """The base, a disc of radius ``base``, is in the plane z = 0, the tip at z = height."""
    shapes.draw_geometry(_cone(*_tube_arguments("glutSolidCone", "base", base, height, slices, stacks), False))


def glutWireCone(base: float, height: float, slices: int, stacks: int) -> None:
    """The lines to the tip, then the circles."""
    shapes.draw_geometry(_cone(*_tube_arguments("glutWireCone", "base", base, height, slices, stacks), True))


@cached(MEMORY)
def _cylinder(radius: float, height: float, slices: int, stacks: int, wire: bool) -> Shape:
    sine, cosine = (table[:-1] for table in _circle(-slices))
    r, h = np.float32(radius), np.float32(height)
    step = h / np.float32(stacks)
    z = _steps(np.float32(0), step, stacks)
    levels = np.array([z[0], *z, (z[-1] + step) - step], np.float32)[:, None]
    middle = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, h]], np.float32)
    vertices = np.concatenate([middle[:1], rows(cosine * r, sine * r, levels), middle[1:]])
    down = np.tile(np.array([[0.0, 0.0, -1.0]], np.float32), (1 + slices, 1))
    normals = np.concatenate([down, np.tile(rows(cosine, sine, 0), (stacks + 1, 1)), np.abs(down)])
    rings = _rings(1, stacks + 3, slices)
    if wire:
        return _wire_tube(vertices, normals, rings[1:-1], rings[1:-1])
    upper = np.concatenate([np.zeros((1, slices), int), rings[1:-2], rings[-1:]])
    lower = np.concatenate([rings[:1], rings[2:-1], np.full((1, slices), len(vertices) - 1)])
    return geometry(vertices, normals, (gl.GL_TRIANGLE_STRIP, _strips(upper, lower)))


def glutSolidCylinder(radius: float, height: float, slices: int, stacks: int) -> None:
    """Around the z axis from z = 0 to z = height, with both ends closed."""
    shapes.draw_geometry(
        _cylinder(*_tube_arguments("glutSolidCylinder", "radius", radius, height, slices, stacks), False)
    )


def glutWireCylinder(radius: float, height: float, slices: int, stacks: int) -> None:
    """The lines along z, then the circles."""
    shapes.draw_geometry(
        _cylinder(*_tube_arguments("glutWireCylinder", "radius", radius, height, slices, stacks), True)
    )


def _tube_arguments(
    name: str, radius_name: str, radius: float, height: float, slices: int, stacks: int
) -> tuple[float, float, int, int]:
    lengths = length(name, radius_name, radius), length(name, "height", height)
    return *lengths, *pieces_of(name, "slices", slices, 1, "stacks", stacks, 1)


@cached(MEMORY)
def _torus(inner: float, outer: float, sides: int, rings: int, wire: bool) -> Shape:
    sine, cosine = (table[:-1] for table in _circle(-sides))
    around_sine, around_cosine = (table[:-1, None] for table in _circle(rings))
    reach = np.float32(outer) + cosine * np.float32(inner)
    vertices = rows(around_cosine * reach, around_sine * reach, sine * np.float32(inner))
    normals = rows(around_cosine * cosine, around_sine * cosine, sine)
    tubes = _rings(0, rings, sides)
    if wire:
        return geometry(vertices, normals, (gl.GL_LINE_LOOP, tubes), (gl.GL_LINE_LOOP, tubes.T))
    return geometry(vertices, normals, (gl.GL_TRIANGLE_STRIP, _strips(tubes.T, np.roll(tubes.T, -1, axis=0))))


def glutSolidTorus(dInnerRadius: float, dOuterRadius: float, nSides: int, nRings: int) -> None:
    """Around the z axis: a tube of radius dInnerRadius whose middle is dOuterRadius from the origin."""
    shapes.draw_geometry(_torus(*_torus_arguments("glutSolidTorus", dInnerRadius, dOuterRadius, nSides, nRings), False))


def glutWireTorus(dInnerRadius: float, dOuterRadius: float, nSides: int, nRings: int) -> None:
    """The circles of the tube, then those around the axis."""
    shapes.draw_geometry(_torus(*_torus_arguments("glutWireTorus", dInnerRadius, dOuterRadius, nSides, nRings), True))


def _torus_arguments(name: str, inner: float, outer: float, sides: int, rings: int) -> tuple[float, float, int, int]:
    radii = length(name, "dInnerRadius", inner), length(name, "dOuterRadius", outer)
    return *radii, *pieces_of(name, "nSides", sides, 2, "nRings", rings, 2)
