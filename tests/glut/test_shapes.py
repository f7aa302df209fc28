"""GLUT's shapes: closed forms, and sums over freeglut 3.4's own vertices."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glut import shapes
from glsim.glut.polyhedra import *
from glsim.glut.revolved import *
from glsim.glut.teaset import *

# call, arguments, primitives, vertices, and moments of the vertices and of the normals that freeglut hands to OpenGL
FREEGLUT: list[tuple[str, tuple[Any, ...], int, int, float, float]] = [
    ("glutSolidSphere", (0.7, 3, 2), 2, 16, -1.9606, -2.8009),
    ("glutSolidSphere", (2.5, 31, 17), 17, 1088, 0.0211, 0.0084),
    ("glutSolidCone", (0.3, 0.7, 13, 7), 8, 224, 1.9933, 0.1252),
    ("glutSolidCylinder", (0.3, 0.7, 13, 7), 9, 252, 0.9532, 0.3483),
    ("glutSolidTorus", (0.25, 0.8, 7, 31), 7, 448, 0.2951, -0.2205),
    ("glutSolidCube", (1.5,), 1, 36, -8.4193, -0.1344),
    ("glutSolidTetrahedron", (), 1, 12, 1.9371, -1.3334),
    ("glutSolidOctahedron", (), 1, 24, -3.2580, 2.3077),
    ("glutSolidIcosahedron", (), 1, 60, 1.7813, 1.3246),
    ("glutSolidDodecahedron", (), 1, 108, 7.9155, -0.6284),
    ("glutSolidRhombicDodecahedron", (), 1, 72, -2.3470, -0.0993),
    ("glutSolidSierpinskiSponge", (3, (0.1, -0.2, 0.7), 0.9), 1, 768, 1.9108, -1.4715),
    ("glutSolidTeapot", (1.0,), 1, 9408, -4.5983, 37.9082),
    ("glutSolidTeacup", (1.0,), 1, 7644, -0.1361, 12.7069),
    ("glutSolidTeaspoon", (1.0,), 1, 4704, -0.2103, -1.3998),
    ("glutWireSphere", (0.7, 3, 2), 4, 12, -3.4367, -4.9095),
    ("glutWireSphere", (2.5, 31, 17), 47, 1054, -0.4637, -0.1855),
    ("glutWireCone", (0.3, 0.7, 13, 7), 8, 117, -5.7185, -1.0396),
    ("glutWireCylinder", (0.3, 0.7, 13, 7), 9, 130, -4.6407, -0.9264),
    ("glutWireTorus", (0.25, 0.8, 7, 31), 38, 434, 0.2788, 0.0526),
    ("glutWireCube", (1.5,), 6, 24, -1.1361, -0.7671),
    ("glutWireTetrahedron", (), 4, 12, 1.9371, -1.3334),
    ("glutWireOctahedron", (), 8, 24, -3.2580, 2.3077),
    ("glutWireIcosahedron", (), 20, 60, 1.7813, 1.3246),
    ("glutWireDodecahedron", (), 12, 60, 0.4750, 2.3409),
    ("glutWireRhombicDodecahedron", (), 12, 48, 0.4696, -0.4926),
    ("glutWireSierpinskiSponge", (3, (0.1, -0.2, 0.7), 0.9), 256, 768, 1.9108, -1.4715),
    ("glutWireTeapot", (1.0,), 640, 6400, -1.6952, 0.1400),
    ("glutWireTeacup", (1.0,), 520, 5200, 0.9799, 0.0588),
    ("glutWireTeaspoon", (1.0,), 320, 3200, 0.0315, -3.3588),
]  # fmt: skip


def moment(array: np.ndarray) -> float:
    """A sum that depends on the order."""
    flat = array.astype(np.float64).ravel()
    return float(flat @ np.cos(np.arange(flat.size)))


@pytest.fixture
def geometry(monkeypatch: pytest.MonkeyPatch) -> Callable[..., shapes.Shape]:
    """What a call would draw."""

    def of(name: str, *arguments: Any) -> shapes.Shape:
        drawn: list[shapes.Shape] = []
        with monkeypatch.context() as patch:
            patch.setattr(shapes, "draw_geometry", drawn.append)
            globals()[name](*arguments)
        return drawn[0]

    return of


def triangles(shape: shapes.Shape) -> np.ndarray:
    """Vertex numbers (n, 3), without triangles that have shrunk to nothing."""
    found, first = [], 0
    for mode, pieces, size in shape.parts:
        for _ in range(pieces):
            numbers = np.arange(first, first + size)
            first += size
            if mode == GL_TRIANGLES:
                found.append(numbers.reshape(-1, 3))
            else:
                assert mode == GL_TRIANGLE_STRIP
                strip = np.stack([numbers[:-2], numbers[1:-1], numbers[2:]], axis=1)
                strip[1::2] = strip[1::2, [1, 0, 2]]
                found.append(strip)
    table = np.concatenate(found)
    return table[np.linalg.norm(across(shape, table), axis=1) > 1e-9]


def corners(shape: shapes.Shape, table: np.ndarray) -> list[np.ndarray]:
    return [shape.vertices[table[:, k]].astype(np.float64) for k in range(3)]


def across(shape: shapes.Shape, table: np.ndarray) -> np.ndarray:
    a, b, c = corners(shape, table)
    return np.cross(b - a, c - a)


def volume(shape: shapes.Shape) -> float:
    a, b, c = corners(shape, triangles(shape))
    return float((np.cross(a, b) * c).sum() / 6)


def euler(shape: shapes.Shape) -> int:
    """Vertices - edges + faces of a closed surface, each edge used once in either direction."""
    _, number = np.unique(np.round(shape.vertices, 5) + 0.0, axis=0, return_inverse=True)
    faces = number.reshape(-1)[triangles(shape)]
    edges = [tuple(face[[k, (k + 1) % 3]]) for face in faces for k in range(3)]
    assert len(set(edges)) == len(edges)
    assert {(b, a) for a, b in edges} == set(edges)
    return len(np.unique(faces)) - len(edges) // 2 + len(faces)


SOLIDS: list[tuple[str, tuple[Any, ...], float]] = [
    ("glutSolidSphere", (1.0, 64, 64), 4 / 3 * np.pi),
    ("glutSolidCone", (1.0, 2.0, 64, 4), 2 / 3 * np.pi),
    ("glutSolidCylinder", (0.5, 2.0, 64, 5), np.pi / 2),
    ("glutSolidTorus", (0.25, 0.75, 64, 64), 2 * np.pi**2 * 0.25**2 * 0.75),
    ("glutSolidCube", (1.5,), 1.5**3),
    ("glutSolidTetrahedron", (), 8 / 27 * np.sqrt(3)),
    ("glutSolidOctahedron", (), 4 / 3),
    ("glutSolidIcosahedron", (), 2.53615),
    ("glutSolidDodecahedron", (), (15 + 7 * np.sqrt(5)) / 4 * (np.sqrt(5) - 1) ** 3),
    ("glutSolidRhombicDodecahedron", (), 2.0),
]


@pytest.mark.parametrize(("name", "arguments", "expected"), SOLIDS)
def test_solids_are_closed_and_as_large_as_they_should_be(
    geometry: Callable[..., shapes.Shape], name: str, arguments: tuple[Any, ...], expected: float
) -> None:
    shape = geometry(name, *arguments)
    assert volume(shape) == pytest.approx(expected, rel=0.005)
    assert euler(shape) == (0 if name.endswith("Torus") else 2)
    table = triangles(shape)
    assert ((across(shape, table)[:, None] * shape.normals[table]).sum(axis=2) > 0).all()  # outward, counterclockwise


@pytest.mark.parametrize(("name", "arguments", "primitives", "vertices", "positions", "normals"), FREEGLUT)
def test_freeglut_draws_the_same(
    geometry: Callable[..., shapes.Shape], name: str, arguments: tuple[Any, ...], primitives: int, vertices: int,
    positions: float, normals: float,
) -> None:  # fmt: skip
    shape = geometry(name, *arguments)
    assert sum(part.pieces for part in shape.parts) == primitives
    assert sum(part.pieces * part.size for part in shape.parts) == len(shape.vertices) == len(shape.normals) == vertices
    assert moment(shape.vertices) == pytest.approx(positions, abs=1e-3)
    # the spoon's normals are sensitive to rounding where its patches shrink to a point
    assert moment(shape.normals) == pytest.approx(normals, abs=0.1 if "spoon" in name else 1e-2)


def test_sphere(geometry: Callable[..., shapes.Shape]) -> None:
    shape = geometry("glutSolidSphere", 2.0, 20, 16)
    assert shape.parts == ((GL_TRIANGLE_STRIP, 16, 42),)
    assert np.abs(np.linalg.norm(shape.vertices, axis=1) - 2).max() < 1e-6
    assert np.abs(shape.normals - shape.vertices / 2).max() < 1e-6
    wire = geometry("glutWireSphere", 2.0, 20, 16)
    assert wire.parts == ((GL_LINE_STRIP, 20, 17), (GL_LINE_LOOP, 15, 20))


def test_torus(geometry: Callable[..., shapes.Shape]) -> None:
    shape = geometry("glutSolidTorus", 0.25, 0.75, 12, 24)
    x, y, z = shape.vertices.T
    assert np.abs(np.hypot(np.hypot(x, y) - 0.75, z) - 0.25).max() < 1e-6


def test_cone_and_cylinder_normals(geometry: Callable[..., shapes.Shape]) -> None:
    cone = geometry("glutSolidCone", 3.0, 4.0, 9, 2)
    side = cone.normals[cone.normals[:, 2] > 0]
    assert side[:, 2] == pytest.approx(0.6)
    assert np.linalg.norm(side[:, :2], axis=1) == pytest.approx(0.8)
    cylinder = geometry("glutSolidCylinder", 3.0, 4.0, 9, 2)
    assert set(cylinder.normals[:, 2]) == {-1.0, 0.0, 1.0}
    assert (cylinder.vertices[cylinder.normals[:, 2] == 1, 2] == 4).all()
    assert (cylinder.vertices[cylinder.normals[:, 2] == -1, 2] == 0).all()


def test_regular_polyhedra(geometry: Callable[..., shapes.Shape]) -> None:
    for name, count, faces, radius in (
        ("Tetrahedron", 4, (4, 3), 1.0), ("Cube", 8, (6, 4), np.sqrt(0.75)), ("Octahedron", 6, (8, 3), 1.0),
        ("Icosahedron", 12, (20, 3), 1.0), ("Dodecahedron", 20, (12, 5), np.sqrt(3)),
    ):  # fmt: skip
        shape = geometry(f"glutWire{name}", *([1.0] if name == "Cube" else []))
        assert shape.parts == ((GL_LINE_LOOP, *faces),)
        assert len(np.unique(np.round(shape.vertices, 5) + 0.0, axis=0)) == count
        assert np.linalg.norm(shape.vertices, axis=1) == pytest.approx(radius)
        ring = shape.vertices.reshape(*faces, 3)
        edges = np.linalg.norm(np.roll(ring, -1, axis=1) - ring, axis=2)
        assert edges == pytest.approx(edges[0, 0])
        length = 0.957454 if name == "Icosahedron" else 1.0
        assert np.linalg.norm(shape.normals, axis=1) == pytest.approx(length)


def test_sponge(geometry: Callable[..., shapes.Shape]) -> None:
    shape = geometry("glutSolidSierpinskiSponge", 3, (1.0, 2.0, 3.0), 2.0)
    assert len(shape.vertices) == 12 * 4**3
    assert volume(shape) == pytest.approx(8 / 27 * np.sqrt(3) * 8 / 2**3, rel=1e-4)
    assert shape.vertices.mean(axis=0) == pytest.approx([1, 2, 3], abs=1e-4)
    assert glutSolidSierpinskiSponge(-1, (0, 0, 0), 1.0) is None


@pytest.mark.parametrize("name", ["Teapot", "Teacup", "Teaspoon"])
def test_tea_set(geometry: Callable[..., shapes.Shape], name: str) -> None:
    small, large = (geometry(f"glutSolid{name}", size) for size in (1.0, 2.0))
    assert np.abs(large.vertices - 2 * small.vertices).max() < 1e-6
    assert np.abs(np.linalg.norm(small.normals, axis=1) - 1).max() < 1e-5
    assert small.texture is not None
    assert (small.texture.min(), small.texture.max()) == (0.0, 1.0)
    assert geometry(f"glutWire{name}", 1.0).texture is None
    table = triangles(small)
    facing = (across(small, table) * small.normals[table].mean(axis=1)).sum(axis=1)
    assert (facing < 0).mean() > 0.99  # clockwise seen from outside
    middle = (small.vertices.min(axis=0) + small.vertices.max(axis=0)) / 2
    assert abs(middle[1]) < 2e-3  # y up, with half of the height below 0


def lit(screen: glsim.Offscreen) -> int:
    return int((screen.pixels()[..., :3] > 0).any(axis=2).sum())


def test_pictures(screen: glsim.Offscreen) -> None:
    glutSolidSphere(0.5, 64, 64)
    assert lit(screen) == pytest.approx(np.pi * 32**2, rel=0.01)
    glClear(GL_COLOR_BUFFER_BIT)
    glutSolidCube(1.0)
    assert lit(screen) == 64 * 64
    glClear(GL_COLOR_BUFFER_BIT)
    glutWireCube(1.0)
    assert 4 * 63 <= lit(screen) <= 4 * 65


def test_state_is_left_as_freeglut_leaves_it(screen: glsim.Offscreen) -> None:
    glNormal3f(0, 1, 0)
    glTexCoord2f(0.25, 0.75)
    glEnableClientState(GL_VERTEX_ARRAY)
    glutSolidTeapot(0.5)
    for array in (GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY):
        assert not glIsEnabled(array)
    assert list(glGetFloatv(GL_CURRENT_NORMAL)) == [0, 1, 0]
    assert list(glGetFloatv(GL_CURRENT_TEXTURE_COORDS)) == [0.25, 0.75, 0, 1]


def test_a_bound_buffer_stays_bound(screen: glsim.Offscreen) -> None:
    buffer = glGenBuffers(1)
    glBindBuffer(GL_ARRAY_BUFFER, buffer)
    glutSolidCube(1.0)
    assert glGetIntegerv(GL_ARRAY_BUFFER_BINDING) == buffer
    assert lit(screen) == 64 * 64


def test_shapes_go_into_display_lists(screen: glsim.Offscreen) -> None:
    glNewList(1, GL_COMPILE)
    glutSolidCube(1.0)
    glEndList()
    assert lit(screen) == 0
    glCallList(1)
    assert lit(screen) == 64 * 64


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: glutSolidSphere(1.0, 0, 8), "glutSolidSphere: slices must be at least 1, not 0"),
        (lambda: glutWireSphere(1.0, 8, 1), "glutWireSphere: stacks must be at least 2, not 1"),
        (lambda: glutSolidCone(1.0, 1.0, 8, 0), "glutSolidCone: stacks must be at least 1, not 0"),
        (lambda: glutWireCylinder(1.0, 1.0, -3, 1), "glutWireCylinder: slices must be at least 1, not -3"),
        (lambda: glutSolidTorus(0.1, 0.5, 1, 8), "glutSolidTorus: nSides must be at least 2, not 1"),
        (lambda: glutSolidSphere(1.0, 8.5, 8), "glutSolidSphere: slices must be a whole number, not 8.5"),
        (lambda: glutSolidCube("1"), "glutSolidCube: size must be a number, not '1'"),
        (lambda: glutSolidTeapot(None), "glutSolidTeapot: size must be a number, not None"),
        (lambda: glutWireSierpinskiSponge(1, 0.0, 1.0), "glutWireSierpinskiSponge: offset must be three numbers"),
        (lambda: glutWireSierpinskiSponge(11, (0, 0, 0), 1), "glutWireSierpinskiSponge: num_levels must be at most"),
    ],
)
def test_bad_arguments_are_named(call: Callable[[], None], sentence: str) -> None:
    with pytest.raises((TypeError, ValueError)) as caught:
        call()
    assert str(caught.value).startswith(sentence)
