"""Built-in scenes for radiosity."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import Builder, Material, Scene, View, box, quad
from glsim.scenes import shapes
from glsim.scenes.mesh import Mesh

Float = NDArray[np.float64]

# The Cornell box as measured at Cornell University's Program of Computer Graphics (millimetres; spectra averaged over
# 600-700, 500-600 and 400-500 nm).
WHITE = Material("white", (0.7337, 0.7357, 0.7059))
GREEN = Material("green", (0.1319, 0.3483, 0.1175))
RED = Material("red", (0.5805, 0.0878, 0.0566))
BLACK = Material("black", (0.0, 0.0, 0.0))
LIGHT = Material("light", (0.78, 0.78, 0.78), (17.0, 11.8, 4.0))


def cornell(closed: bool = False) -> Scene:
    """The Cornell box, closed by a front wall that is black, or with ``closed`` white."""
    b = Builder("cornell-closed" if closed else "cornell")
    x, y, z = 556.0, 548.8, 559.2
    b.add([quad((552.8, 0, 0), (0, 0, 0), (0, 0, z), (549.6, 0, z))], WHITE)  # floor
    b.add([quad((x, y, 0), (x, y, z), (0, y, z), (0, y, 0))], WHITE)  # ceiling
    b.add([quad((549.6, 0, z), (0, 0, z), (0, y, z), (x, y, z))], WHITE)  # back
    b.add([quad((0, 0, z), (0, 0, 0), (0, y, 0), (0, y, z))], GREEN)
    b.add([quad((552.8, 0, 0), (549.6, 0, z), (x, y, z), (x, y, 0))], RED)
    b.add([quad((552.8, 0, 0), (x, y, 0), (0, y, 0), (0, 0, 0))], WHITE if closed else BLACK)  # front
    b.add([quad((343, y, 227), (343, y, 332), (213, y, 332), (213, y, 227))], LIGHT)
    short = np.array([(130, 165, 65), (82, 165, 225), (240, 165, 272), (290, 165, 114)], float)
    tall = np.array([(423, 330, 247), (265, 330, 296), (314, 330, 456), (472, 330, 406)], float)
    for top in (short, tall):
        ground = top * (1, 0, 1)
        sides = [quad(top[k], ground[k], ground[(k + 1) % 4], top[(k + 1) % 4]) for k in range(4)]
        b.add([top, *sides], WHITE)
    return b.scene(View((278, 273, -800), (278, 273, 0), fov=39.3))


def plates() -> Scene:
    """Two facing unit squares, half a unit apart; the lower one emits."""
    b = Builder("plates")
    b.add([quad((0, 0, 0), (0, 0, 1), (1, 0, 1), (1, 0, 0))], Material("lamp", (0.3, 0.3, 0.3), (1.0, 0.9, 0.7)))
    b.add([quad((0, 0.5, 0), (1, 0.5, 0), (1, 0.5, 1), (0, 0.5, 1))], Material("grey", (0.6, 0.6, 0.6)))
    return b.scene(View((1.7, 0.22, 2.3), (0.5, 0.26, 0.5), fov=40))


def furnace() -> Scene:
    """A closed cube whose walls all emit 1 and reflect a half: B = E / (1 - rho) = 2 everywhere."""
    b = Builder("furnace")
    b.add(box((0, 0, 0), (1, 1, 1), inside=True), Material("wall", (0.5, 0.5, 0.5), (1.0, 1.0, 1.0)))
    return b.scene(View((0.5, 0.5, 0.95), (0.5, 0.5, 0), fov=80))


def goral() -> Scene:
    """The cube of Goral, Torrance, Greenberg and Battaile (1984): red and blue side walls, a black front wall that
    emits 1, all other walls white."""
    b = Builder("goral")
    left, right, floor, ceiling, back, front = box((0, 0, 0), (1, 1, 1), inside=True)
    white = Material("white", (0.8, 0.8, 0.8))
    b.add([left], Material("red", (0.75, 0.1, 0.1)))
    b.add([right], Material("blue", (0.1, 0.15, 0.75)))
    b.add([floor, ceiling, back], white)
    b.add([front], Material("lamp", (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)))
    return b.scene(View((0.5, 0.5, 2.6), (0.5, 0.5, 0.5), fov=32))


# ---------------------------------------------------------------- larger rooms


def _placed(mesh: Mesh, at: tuple[float, float, float], size: float) -> list[Float]:
    """Return a mesh's polygons, scaled to the height ``size``; the middle of the bounding box's base is ``at`` (3,)."""
    points = mesh.positions.astype(np.float64)
    low, high = points.min(axis=0), points.max(axis=0)
    points = (points - [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2]) * (size / (high[1] - low[1])) + at
    return [points[face] for face in (*mesh.triangles, *mesh.quads)]


def _cylinder(at: tuple[float, float, float], radius: float, height: float, sides: int = 12) -> list[Float]:
    """An upright cylinder with a lid; open below."""
    angle = np.arange(sides) * 2 * np.pi / sides
    base = np.stack([radius * np.cos(angle), 0 * angle, -radius * np.sin(angle)], axis=1) + at
    up = np.array((0.0, height, 0.0))
    top = base + up
    walls = [np.array([base[k], base[(k + 1) % sides], top[(k + 1) % sides], top[k]]) for k in range(sides)]
    middle = np.array(at) + up
    return [*walls, *(np.array([middle, top[k], top[(k + 1) % sides]]) for k in range(sides))]


def museum() -> Scene:
    """A room with two skylights, pictures on the walls, and a teapot, a sphere, a torus and a column on pedestals."""
    b = Builder("museum")
    left, right, floor, ceiling, back, front = box((0, 0, 0), (10, 4.5, 8), inside=True)
    plaster, wood = Material("plaster", (0.78, 0.76, 0.72)), Material("wood", (0.42, 0.27, 0.16))
    sky = Material("skylight", (0.1, 0.1, 0.1), (9.0, 9.5, 10.5))
    b.add([left, right, ceiling, back, front], plaster)
    b.add([floor], wood)
    for x in (1.5, 5.5):
        b.add([quad((x, 4.5, 2.5), (x + 3, 4.5, 2.5), (x + 3, 4.5, 5.5), (x, 4.5, 5.5))], sky)
    paints = (("vermilion", (0.7, 0.2, 0.1)), ("ultramarine", (0.1, 0.16, 0.6)), ("ochre", (0.7, 0.5, 0.15)),
              ("viridian", (0.1, 0.45, 0.3)))  # fmt: skip
    for k, (name, rho) in enumerate(paints[:3]):
        x = 1.2 + 2.8 * k
        b.add([quad((x, 1.3, 0), (x + 1.8, 1.3, 0), (x + 1.8, 2.9, 0), (x, 2.9, 0))], Material(name, rho))
    b.add([quad((0, 1.2, 5.5), (0, 1.2, 3.0), (0, 3.0, 3.0), (0, 3.0, 5.5))], Material(*paints[3]))
    stone = Material("stone", (0.65, 0.63, 0.6))
    places = ((2.0, 3.0), (5.0, 2.4), (8.0, 3.2), (3.4, 5.2))
    for x, z in places:
        b.add(box((x - 0.45, 0, z - 0.45), (x + 0.45, 1.0, z + 0.45)), stone)
    (x_1, z_1), (x_2, z_2), (x_3, z_3), (x_4, z_4) = places
    b.add(_placed(shapes.teapot(3), (x_1, 1.0, z_1), 0.7), Material("copper", (0.7, 0.4, 0.25)), smooth=True)
    b.add(_placed(shapes.sphere(16), (x_2, 1.0, z_2), 0.9), Material("marble", (0.8, 0.8, 0.82)), smooth=True)
    b.add(_placed(shapes.torus(16), (x_3, 1.0, z_3), 0.28), Material("jade", (0.25, 0.55, 0.4)), smooth=True)
    b.add(_cylinder((x_4, 1.0, z_4), 0.22, 1.1), Material("terracotta", (0.65, 0.35, 0.25)))
    b.add(box((5.8, 0, 5.4), (7.8, 0.45, 6.0)), wood)
    return b.scene(View((9.3, 2.1, 7.6), (3.2, 1.2, 1.6), fov=52), View((1.0, 1.7, 7.4), (6.0, 1.2, 1.0), fov=52))


def factory() -> Scene:
    """A hall with three skylights and lamps over the aisle, columns, machines, tanks, crates and a crane."""
    b = Builder("factory")
    left, right, floor, ceiling, back, front = box((0, 0, 0), (24, 8, 14), inside=True)
    b.add([left, right, back, front], Material("brick", (0.55, 0.35, 0.28)))
    b.add([floor], Material("concrete", (0.45, 0.45, 0.43)))
    b.add([ceiling], Material("tin", (0.5, 0.52, 0.55)))
    sky, lamp = Material("skylight", (0.1,) * 3, (10.0, 10.5, 11.5)), Material("lamp", (0.3,) * 3, (26.0, 20.0, 11.0))
    for x in (3.0, 10.5, 18.0):
        b.add([quad((x, 8, 2.0), (x + 3, 8, 2.0), (x + 3, 8, 5.0), (x, 8, 5.0))], sky)
        b.add(box((x + 0.9, 6.3, 10.2), (x + 2.1, 6.45, 10.8))[2:3], lamp)
        b.add([face for k, face in enumerate(box((x + 0.9, 6.3, 10.2), (x + 2.1, 6.45, 10.8))) if k != 2],
              Material("shade", (0.2,) * 3))  # fmt: skip
    steel, green = Material("steel", (0.45, 0.47, 0.5)), Material("machine green", (0.2, 0.42, 0.32))
    orange, blue = Material("orange", (0.75, 0.35, 0.08)), Material("blue", (0.15, 0.25, 0.6))
    for x in (6.0, 12.0, 18.0):
        for z in (1.0, 12.4):
            b.add(box((x, 0, z), (x + 0.5, 8, z + 0.5)), steel)
    for k, x in enumerate((2.0, 8.0, 14.0)):
        b.add(box((x, 0, 3.0), (x + 3.2, 1.5, 5.2)), green if k % 2 == 0 else blue)
        b.add(box((x + 0.6, 1.5, 3.4), (x + 1.8, 2.6, 4.6)), orange)
    for x in (20.5, 22.5):
        b.add(_cylinder((x, 0.0, 3.5), 0.85, 3.2), steel)
    for x, z, size in ((3.0, 10.0, 1.4), (4.9, 10.3, 1.0), (9.5, 10.8, 1.6), (20.0, 10.0, 1.5), (20.2, 11.9, 1.0)):
        b.add(box((x, 0, z), (x + size, size, z + size)), Material("crate", (0.6, 0.42, 0.22)))
    b.add(box((8.6, 6.0, 0.6), (9.4, 6.7, 13.4)), orange)  # the crane
    b.add(box((8.8, 3.4, 6.6), (9.2, 6.0, 7.0)), steel)
    return b.scene(View((22.6, 3.6, 11.9), (8.0, 2.0, 3.5), fov=55), View((0.8, 2.2, 13.0), (14.0, 2.0, 4.0), fov=55))


@dataclass(frozen=True)
class BuiltIn:
    about: str
    make: Callable[[], Scene]


BUILT_IN = {
    "cornell": BuiltIn("the Cornell box, measured data, black front wall", cornell),
    "cornell-closed": BuiltIn("the Cornell box with a white front wall", lambda: cornell(closed=True)),
    "plates": BuiltIn("two facing squares", plates),
    "furnace": BuiltIn("a closed cube that glows everywhere", furnace),
    "goral": BuiltIn("the cube of Goral et al. 1984", goral),
    "museum": BuiltIn("a room with skylights, pictures and sculptures", museum),
    "factory": BuiltIn("a hall with skylights, lamps, machines and crates", factory),
}
