"""GLUT's shapes: spheres, cones, cylinders, tori, the regular polyhedra and the sponge; teaset.py has the tea set.

Vertices, normals and their order are freeglut 3.4's, number by number in float32, so that flat shading, lines, points
and culling agree.  Faces are counterclockwise seen from outside.  Lengths are in object coordinates.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.machine.assembly import assemble
from glsim.machine.cache import cached
from glsim.machine.errors import show

Array = NDArray[np.float32]
Indices = NDArray[np.int64]
MEMORY = 64 * 1024 * 1024  # bytes of shapes that each function keeps
MOST_PIECES = 1 << 20  # of a shape: slices times stacks


class Part(NamedTuple):
    """``pieces`` primitives of one mode, each of ``size`` vertices."""

    mode: int
    pieces: int
    size: int


class Shape(NamedTuple):
    """What one call draws: vertices and normals (n, 3) in the order in which they are drawn."""

    vertices: Array
    normals: Array
    texture: Array | None  # (n, 2)
    parts: tuple[Part, ...]


def geometry(vertices: Array, normals: Array, *pieces: tuple[int, Indices], texture: Array | None = None) -> Shape:
    """pieces: a mode and indices (primitives, vertices of each)."""
    order = np.concatenate([indices.ravel() for _, indices in pieces])
    drawn = [None if array is None else array[order] for array in (vertices, normals, texture)]
    for array in drawn:
        if array is not None:
            array.flags.writeable = False  # it is kept
    parts = tuple(Part(mode, *indices.shape) for mode, indices in pieces)
    return Shape(drawn[0], drawn[1], drawn[2], parts)  # type: ignore[arg-type]


@cached(MEMORY)
def _triangles(first: int, strips: int, size: int) -> NDArray[np.uint32]:
    """The triangles of triangle strips of ``size`` vertices each, in their order: one call instead of many."""
    pattern = assemble(gl.GL_TRIANGLE_STRIP, size, last=False)
    assert pattern is not None
    return (first + size * np.arange(strips, dtype=np.uint32)[:, None] + pattern).astype(np.uint32).ravel()


def draw_geometry(shape: Shape) -> None:
    """As freeglut: the vertex arrays are enabled before and disabled after, the current normal stays."""
    buffer = gl.glGetIntegerv(gl.GL_ARRAY_BUFFER_BINDING)
    if buffer:
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, 0)
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glEnableClientState(gl.GL_NORMAL_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, shape.vertices)
    gl.glNormalPointer(gl.GL_FLOAT, 0, shape.normals)
    if shape.texture is not None:
        gl.glEnableClientState(gl.GL_TEXTURE_COORD_ARRAY)
        gl.glTexCoordPointer(2, gl.GL_FLOAT, 0, shape.texture)
    first = 0
    for mode, pieces, size in shape.parts:
        if mode == gl.GL_TRIANGLE_STRIP and pieces > 1:
            triangles = _triangles(first, pieces, size)
            gl.glDrawElements(gl.GL_TRIANGLES, triangles.size, gl.GL_UNSIGNED_INT, triangles)
            first += pieces * size
            continue
        for _ in range(pieces):
            gl.glDrawArrays(mode, first, size)
            first += size
    gl.glDisableClientState(gl.GL_VERTEX_ARRAY)
    gl.glDisableClientState(gl.GL_NORMAL_ARRAY)
    if shape.texture is not None:
        gl.glDisableClientState(gl.GL_TEXTURE_COORD_ARRAY)
    if buffer:
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffer)


# ---------------------------------------------------------------- arguments


def length(name: str, argument: str, value: Any) -> float:
    """The number as float32, as freeglut takes it."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        with np.errstate(over="ignore"):
            number = float(np.float32(float(value)))
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name}: {argument} must be a number, not {show(value)}") from None
    if not math.isfinite(number):
        raise ValueError(f"{name}: {argument} must be a finite number, not {show(value)}")
    return number


def _whole(name: str, argument: str, value: Any, least: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: {argument} must be a whole number, not {value!r}") from None
    if number < least:
        raise ValueError(f"{name}: {argument} must be at least {least}, not {number}")
    return number


def _pieces(name: str, one: str, n: Any, least: int, other: str, k: Any, least_other: int) -> tuple[int, int]:
    """The numbers of pieces both ways around."""
    n, k = _whole(name, one, n, least), _whole(name, other, k, least_other)
    if n * k > MOST_PIECES:
        raise ValueError(f"{name}: {one} times {other} must be at most {MOST_PIECES}, not {n} * {k}")
    return n, k


# ---------------------------------------------------------------- round shapes


def _circle(n: int, half: bool = False) -> tuple[Array, Array]:
    """Sines and cosines of abs(n) + 1 angles around, clockwise where n < 0; the last is exactly the first."""
    angle = np.float32((1 if half else 2) * np.float32(math.pi)) / np.float32(n)
    angles = (angle * np.arange(abs(n) + 1, dtype=np.float32)).astype(np.float64)
    sines, cosines = np.sin(angles).astype(np.float32), np.cos(angles).astype(np.float32)
    sines[0], cosines[0] = 0.0, 1.0
    sines[-1], cosines[-1] = 0.0, -1.0 if half else 1.0
    return sines, cosines


def rows(*columns: Any) -> Array:
    """Points (n, 3) from their three coordinates, broadcast against each other."""
    return np.stack(np.broadcast_arrays(*columns), axis=-1).astype(np.float32).reshape(-1, 3)


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
    draw_geometry(_sphere(*_sphere_arguments("glutSolidSphere", radius, slices, stacks), False))


def glutWireSphere(radius: float, slices: int, stacks: int) -> None:
    """The meridians, then the circles of latitude."""
    draw_geometry(_sphere(*_sphere_arguments("glutWireSphere", radius, slices, stacks), True))


def _sphere_arguments(name: str, radius: float, slices: int, stacks: int) -> tuple[float, int, int]:
    return length(name, "radius", radius), *_pieces(name, "slices", slices, 1, "stacks", stacks, 2)


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
    draw_geometry(_cone(*_tube_arguments("glutSolidCone", "base", base, height, slices, stacks), False))


def glutWireCone(base: float, height: float, slices: int, stacks: int) -> None:
    """The lines to the tip, then the circles."""
    draw_geometry(_cone(*_tube_arguments("glutWireCone", "base", base, height, slices, stacks), True))


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
    draw_geometry(_cylinder(*_tube_arguments("glutSolidCylinder", "radius", radius, height, slices, stacks), False))


def glutWireCylinder(radius: float, height: float, slices: int, stacks: int) -> None:
    """The lines along z, then the circles."""
    draw_geometry(_cylinder(*_tube_arguments("glutWireCylinder", "radius", radius, height, slices, stacks), True))


def _tube_arguments(
    name: str, radius_name: str, radius: float, height: float, slices: int, stacks: int
) -> tuple[float, float, int, int]:
    lengths = length(name, radius_name, radius), length(name, "height", height)
    return *lengths, *_pieces(name, "slices", slices, 1, "stacks", stacks, 1)


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
    draw_geometry(_torus(*_torus_arguments("glutSolidTorus", dInnerRadius, dOuterRadius, nSides, nRings), False))


def glutWireTorus(dInnerRadius: float, dOuterRadius: float, nSides: int, nRings: int) -> None:
    """The circles of the tube, then those around the axis."""
    draw_geometry(_torus(*_torus_arguments("glutWireTorus", dInnerRadius, dOuterRadius, nSides, nRings), True))


def _torus_arguments(name: str, inner: float, outer: float, sides: int, rings: int) -> tuple[float, float, int, int]:
    radii = length(name, "dInnerRadius", inner), length(name, "dOuterRadius", outer)
    return *radii, *_pieces(name, "nSides", sides, 2, "nRings", rings, 2)


# ---------------------------------------------------------------- polyhedra


class Polyhedron(NamedTuple):
    """Corners (n, 3), faces (f, corners of one) counterclockwise seen from outside, and a normal for each face."""

    corners: Array
    faces: Indices
    normals: Array


def _polyhedron(corners: Any, faces: str, lengths: Any = 1.0) -> Polyhedron:
    """faces: one word each, a letter for each corner.  lengths: of the normals, if they are not 1."""
    points = np.array(corners, np.float64)
    table = np.array([[ord(letter) - ord("a") for letter in word] for word in faces.split()])
    a, b, c = (points[table[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    across[np.abs(across) < 1e-12] = 0.0
    across *= np.reshape(lengths, (-1, 1)) / np.linalg.norm(across, axis=1, keepdims=True)
    return Polyhedron(points.astype(np.float32), table, across.astype(np.float32))


# corners of the triangles into which a face is cut
CUTS = {3: (0, 1, 2), 4: (0, 1, 2, 0, 2, 3), 5: (0, 1, 2, 0, 2, 4, 4, 2, 3)}
PHI = (1 + math.sqrt(5)) / 2
S, T = math.sqrt(0.2), math.sqrt(0.5)

TETRAHEDRON = _polyhedron(
    [(1, 0, 0), (-1 / 3, 2 * math.sqrt(2) / 3, 0)]
    + [(-1 / 3, -math.sqrt(2) / 3, side * math.sqrt(6) / 3) for side in (1, -1)],
    "bdc acd adb abc",
)
CUBE = _polyhedron(
    np.array([(1, 1, 1), (-1, 1, 1), (-1, -1, 1), (1, -1, 1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, -1)]) / 2,
    "abcd adef afgb bghc hedc ehgf",
)
OCTAHEDRON = _polyhedron(
    [*np.eye(3), *-np.eye(3)],
    "abc afb ace aef dcb dbf dec dfe",
)
ICOSAHEDRON = _polyhedron(
    [(1, 0, 0)]
    + [(S, 2 * S * math.cos(turn), 2 * S * math.sin(turn)) for turn in 2 * math.pi * np.arange(5) / 5]
    + [(-S, -2 * S * math.cos(turn), 2 * S * math.sin(turn)) for turn in 2 * math.pi * np.arange(5) / 5]
    + [(-1, 0, 0)],
    "abc acd ade aef afb bic chd dge ekf fjb bji cih dhg egk fkj ljk lij lhi lgh lkg",
    math.sqrt(3) * (1 - S),  # freeglut's length
)
DODECAHEDRON = _polyhedron(
    [
        (0, PHI, PHI - 1), (-1, 1, 1), (1 - PHI, 0, PHI), (PHI - 1, 0, PHI), (1, 1, 1), (0, PHI, 1 - PHI), (1, 1, -1),
        (PHI - 1, 0, -PHI), (1 - PHI, 0, -PHI), (-1, 1, -1), (0, -PHI, PHI - 1), (1, -1, 1), (-1, -1, 1),
        (0, -PHI, 1 - PHI), (-1, -1, -1), (1, -1, -1), (PHI, 1 - PHI, 0), (PHI, PHI - 1, 0), (-PHI, PHI - 1, 0),
        (-PHI, 1 - PHI, 0),
    ],
    "abcde fghij kldcm noihp dlqre cbstm hgrqp iotsj rgfae qlknp sbafj tonkm",
)  # fmt: skip
RHOMBIC_DODECAHEDRON = _polyhedron(
    [
        (0, 0, 1), (T, 0, 0.5), (0, T, 0.5), (-T, 0, 0.5), (0, -T, 0.5), (T, T, 0), (-T, T, 0), (-T, -T, 0), (T, -T, 0),
        (T, 0, -0.5), (0, T, -0.5), (-T, 0, -0.5), (0, -T, -0.5), (0, 0, -1),
    ],
    "abfc acgd adhe aeib fkgc glhd hmie ijfb fjnk gknl hlnm imnj",
    [T] * 4 + [1] * 4 + [T] * 4,  # freeglut's lengths: only four are 1
)  # fmt: skip


SOLIDS = {
    "tetrahedron": TETRAHEDRON,
    "cube": CUBE,
    "octahedron": OCTAHEDRON,
    "icosahedron": ICOSAHEDRON,
    "dodecahedron": DODECAHEDRON,
    "rhombic dodecahedron": RHOMBIC_DODECAHEDRON,
}


@cached(MEMORY)
def _solid(name: str, wire: bool, size: float = 1.0) -> Shape:
    """Each face has corners of its own, with its normal."""
    shape = SOLIDS[name]
    vertices = shape.corners[shape.faces.ravel()] * np.float32(size)
    return _faces(vertices, np.repeat(shape.normals, shape.faces.shape[1], axis=0), shape.faces.shape[1], wire)


def _faces(vertices: Array, normals: Array, corners: int, wire: bool) -> Shape:
    faces = np.arange(len(vertices)).reshape(-1, corners)
    if wire:
        return geometry(vertices, normals, (gl.GL_LINE_LOOP, faces))
    return geometry(vertices, normals, (gl.GL_TRIANGLES, faces[:, CUTS[corners]].reshape(1, -1)))


def glutSolidCube(size: float) -> None:
    """Draw a cube around the origin with edges of length ``size``, in object coordinates."""
    draw_geometry(_solid("cube", False, length("glutSolidCube", "size", size)))


def glutWireCube(size: float) -> None:
    """Draw the edges of a cube around the origin; ``size``: their length, in object coordinates."""
    draw_geometry(_solid("cube", True, length("glutWireCube", "size", size)))


def glutSolidTetrahedron() -> None:
    """Corners at distance 1 from the origin."""
    draw_geometry(_solid("tetrahedron", False))


def glutWireTetrahedron() -> None:
    """One line loop for each face."""
    draw_geometry(_solid("tetrahedron", True))


def glutSolidOctahedron() -> None:
    """Corners at distance 1 from the origin."""
    draw_geometry(_solid("octahedron", False))


def glutWireOctahedron() -> None:
    """One line loop for each face."""
    draw_geometry(_solid("octahedron", True))


def glutSolidIcosahedron() -> None:
    """Corners at distance 1 from the origin; the normals have length 0.957, as freeglut's."""
    draw_geometry(_solid("icosahedron", False))


def glutWireIcosahedron() -> None:
    """One line loop for each face."""
    draw_geometry(_solid("icosahedron", True))


def glutSolidDodecahedron() -> None:
    """Corners at distance sqrt(3) from the origin."""
    draw_geometry(_solid("dodecahedron", False))


def glutWireDodecahedron() -> None:
    """One line loop for each face."""
    draw_geometry(_solid("dodecahedron", True))


def glutSolidRhombicDodecahedron() -> None:
    """Faces at distance 0.707 from the origin; eight of the normals have that length, as freeglut's."""
    draw_geometry(_solid("rhombic dodecahedron", False))


def glutWireRhombicDodecahedron() -> None:
    """One line loop for each face."""
    draw_geometry(_solid("rhombic dodecahedron", True))


# ---------------------------------------------------------------- sponge

MOST_LEVELS = 10  # a million tetrahedra


@cached(MEMORY)
def _sponge(levels: int, offset: tuple[float, float, float], scale: float, wire: bool) -> Shape:
    """Tetrahedra; each of the ``levels`` replaces a tetrahedron by four of half the size at its corners."""
    size, middles = np.float32(scale), np.array([offset], np.float64)
    for _ in range(levels):
        size /= np.float32(2)
        middles = (middles[:, None] + size * TETRAHEDRON.corners).reshape(-1, 3)
    vertices = middles.astype(np.float32)[:, None] + size * TETRAHEDRON.corners[TETRAHEDRON.faces.ravel()]
    normals = np.tile(np.repeat(TETRAHEDRON.normals, 3, axis=0), (len(middles), 1))
    return _faces(vertices.reshape(-1, 3), normals, 3, wire)


def glutSolidSierpinskiSponge(num_levels: int, offset: Sequence[float], scale: float) -> None:
    """Tetrahedra, 4 ** num_levels of them, around the point ``offset``; below level 0 there are none."""
    _draw_sponge("glutSolidSierpinskiSponge", num_levels, offset, scale, False)


def glutWireSierpinskiSponge(num_levels: int, offset: Sequence[float], scale: float) -> None:
    """The edges of glutSolidSierpinskiSponge: one line loop for each face."""
    _draw_sponge("glutWireSierpinskiSponge", num_levels, offset, scale, True)


def _draw_sponge(name: str, num_levels: int, offset: Sequence[float], scale: float, wire: bool) -> None:
    levels = _whole(name, "num_levels", num_levels, -(2**31))
    if levels > MOST_LEVELS:
        raise ValueError(f"{name}: num_levels must be at most {MOST_LEVELS}, not {levels}")
    try:
        x, y, z = map(float, offset)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: offset must be three numbers, not {offset!r}") from None
    size = length(name, "scale", scale)
    if levels >= 0:
        draw_geometry(_sponge(levels, (x, y, z), size, wire))
