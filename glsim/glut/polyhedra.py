"""GLUT's polyhedra and the sponge that is made of them, with freeglut's vertices, see shapes.py."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from glsim import gl
from glsim.glut import shapes
from glsim.glut.shapes import MEMORY, Array, Indices, Shape, geometry, length, whole
from glsim.machine.cache import cached


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
    shapes.draw_geometry(_solid("cube", False, length("glutSolidCube", "size", size)))


def glutWireCube(size: float) -> None:
    """Draw the edges of a cube around the origin; ``size``: their length, in object coordinates."""
    shapes.draw_geometry(_solid("cube", True, length("glutWireCube", "size", size)))


def glutSolidTetrahedron() -> None:
    """Corners at distance 1 from the origin."""
    shapes.draw_geometry(_solid("tetrahedron", False))


def glutWireTetrahedron() -> None:
    """One line loop for each face."""
    shapes.draw_geometry(_solid("tetrahedron", True))


def glutSolidOctahedron() -> None:
    """Corners at distance 1 from the origin."""
    shapes.draw_geometry(_solid("octahedron", False))


def glutWireOctahedron() -> None:
    """One line loop for each face."""
    shapes.draw_geometry(_solid("octahedron", True))


def glutSolidIcosahedron() -> None:
    """Corners at distance 1 from the origin; the normals have length 0.957, as freeglut's."""
    shapes.draw_geometry(_solid("icosahedron", False))


def glutWireIcosahedron() -> None:
    """One line loop for each face."""
    shapes.draw_geometry(_solid("icosahedron", True))


def glutSolidDodecahedron() -> None:
    """Corners at distance sqrt(3) from the origin."""
    shapes.draw_geometry(_solid("dodecahedron", False))


def glutWireDodecahedron() -> None:
    """One line loop for each face."""
    shapes.draw_geometry(_solid("dodecahedron", True))


def glutSolidRhombicDodecahedron() -> None:
    """Faces at distance 0.707 from the origin; eight of the normals have that length, as freeglut's."""
    shapes.draw_geometry(_solid("rhombic dodecahedron", False))


def glutWireRhombicDodecahedron() -> None:
    """One line loop for each face."""
    shapes.draw_geometry(_solid("rhombic dodecahedron", True))


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
    levels = whole(name, "num_levels", num_levels, -(2**31))
    if levels > MOST_LEVELS:
        raise ValueError(f"{name}: num_levels must be at most {MOST_LEVELS}, not {levels}")
    try:
        x, y, z = map(float, offset)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: offset must be three numbers, not {offset!r}") from None
    size = length(name, "scale", scale)
    if levels >= 0:
        shapes.draw_geometry(_sponge(levels, (x, y, z), size, wire))
