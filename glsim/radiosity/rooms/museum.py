"""A museum: daylight falls through three shafts on sculptures, and light through two doors into the next rooms."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from glsim.radiosity.rooms import paintings, surfaces
from glsim.radiosity.rooms.shapes import (
    Point,
    block,
    facing,
    pipe,
    placed,
    reveal,
    tiled,
    turned,
    unit,
    wall,
)  # fmt: skip
from glsim.radiosity.scene import Builder, Material, Scene, View, quad
from glsim.radiosity.textures import Texture
from glsim.scenes import shapes

LONG, DEEP, HIGH = 14.0, 9.0, 5.4  # of the hall: x, z, y
UP = (0.0, HIGH, 0.0)
SHAFTS = [(x - 0.6, 3.9, x + 0.6, 5.1) for x in (3.5, 7.0, 10.5)]  # of daylight: x, z, x, z
SHAFT = 2.6  # their height
EAST_DOOR, NORTH_DOOR = (3.5, 0.0, 5.5, 3.1), (7.9, 0.0, 9.6, 2.9)
THICK = 0.45  # of the walls with doors

PLASTER = Material("plaster", (0.6, 0.58, 0.51))
CEILING = Material("ceiling", (0.7, 0.69, 0.66))
STONE = Material("limestone", (0.55, 0.5, 0.41))
MARBLE = Material("marble", (0.78, 0.78, 0.76))
GILT = Material("gilt", (0.55, 0.37, 0.1))
OAK = Material("oak", (0.38, 0.23, 0.12))
POMPEII = Material("red wall", (0.58, 0.06, 0.04))
BLUE = Material("blue wall", (0.07, 0.16, 0.5))
DAYLIGHT = Material("daylight", (0.1,) * 3, (430.0, 470.0, 530.0))
LAMP = Material("lamp", (0.3,) * 3, (110.0, 72.0, 34.0))
COOL = Material("cool lamp", (0.3,) * 3, (200.0, 235.0, 280.0))


def museum() -> Scene:
    """Return the three rooms."""
    b = Builder("museum")
    for build in (_hall, _shafts, _red_room, _blue_room, _columns, _sculptures, _pictures):
        build(b)
    scene = b.scene(
        View((0.5, 2.0, 6.1), (9.0, 1.75, 3.4), fov=68.0, name="hall"),
        View((18.9, 1.75, 6.9), (14.4, 1.5, 3.8), fov=68.0, name="door"),
        View((13.3, 1.9, 6.1), (4.0, 1.6, 3.0), fov=66.0, name="sculptures"),
    )
    return replace(scene, white=1.8)


def _hall(b: Builder) -> None:
    """Floor, four walls, and a ceiling with three holes."""
    tiled(b, [quad((0, 0, 0), (0, 0, DEEP), (LONG, 0, DEEP), (LONG, 0, 0))],
          Material("terrazzo", (1.0,) * 3, texture=surfaces.terrazzo()), 2.0)  # fmt: skip
    b.add(wall((0, 0, DEEP), (0, 0, -DEEP), UP), PLASTER, smooth=True)
    b.add(wall((0, 0, 0), (LONG, 0, 0), UP, [NORTH_DOOR]), PLASTER, smooth=True)
    b.add(wall((LONG, 0, 0), (0, 0, DEEP), UP, [EAST_DOOR]), PLASTER, smooth=True)
    b.add(wall((LONG, 0, DEEP), (-LONG, 0, 0), UP), PLASTER, smooth=True)
    b.add(wall((0, HIGH, 0), (LONG, 0, 0), (0, 0, DEEP), SHAFTS), CEILING, smooth=True)


def _shafts(b: Builder) -> None:
    """Deep white shafts through the roof, with the sky on top."""
    for opening in SHAFTS:
        left, back, right, front = opening
        y = HIGH + SHAFT
        b.add(reveal((0, HIGH, 0), (LONG, 0, 0), (0, 0, DEEP), SHAFT, opening), CEILING)
        b.add([quad((left, y, back), (right, y, back), (right, y, front), (left, y, front))], DAYLIGHT)


def _red_room(b: Builder) -> None:
    """A cabinet with red walls behind the east door, in warm light."""
    near, far, left, right, high = LONG + THICK, LONG + 5.2, 1.4, 7.6, 3.9
    middle = (near + 1.0, 2.0, 4.5)
    b.add(reveal((LONG, 0, 0), (0, 0, DEEP), UP, THICK, EAST_DOOR), STONE)
    boards = Material("boards", (1.0,) * 3, texture=surfaces.boards())
    tiled(b, [quad((near, 0, left), (near, 0, right), (far, 0, right), (far, 0, left))], boards, 2.0)
    b.add([facing(face, middle) for face in block((near, 0, left), (far, high, right), "-x -y +y")], POMPEII)
    door = (EAST_DOOR[0] - left, 0.0, EAST_DOOR[2] - left, EAST_DOOR[3])
    b.add([facing(face, middle) for face in wall((near, 0, left), (0, 0, right - left), (0, high, 0), [door])], POMPEII)
    b.add([quad((near, high, left), (far, high, left), (far, high, right), (near, high, right))], CEILING)
    b.add([quad((16.9, high, 3.1), (17.3, high, 3.1), (17.3, high, 3.5), (16.9, high, 3.5))], LAMP)
    b.add([quad((16.9, high, 5.6), (17.3, high, 5.6), (17.3, high, 6.0), (16.9, high, 6.0))], LAMP)
    b.add(block((16.45, 0, 2.35), (17.15, 1.0, 3.05)), MARBLE)
    b.add(placed(shapes.sphere(16), (16.8, 1.0, 2.7), 0.8), MARBLE, smooth=True)


def _blue_room(b: Builder) -> None:
    """A room with blue walls behind the north door."""
    left, right, near, far, high = 6.4, 11.2, -THICK, -4.6, 3.6
    middle = (8.7, 2.0, near - 1.0)
    b.add(reveal((0, 0, 0), (LONG, 0, 0), UP, THICK, NORTH_DOOR), STONE)
    boards = Material("boards", (1.0,) * 3, texture=surfaces.boards())
    tiled(b, [quad((left, 0, far), (left, 0, near), (right, 0, near), (right, 0, far))], boards, 2.0)
    b.add([facing(face, middle) for face in block((left, 0, far), (right, high, near), "-y +y +z")], BLUE)
    door = (NORTH_DOOR[0] - left, 0.0, NORTH_DOOR[2] - left, NORTH_DOOR[3])
    b.add([facing(face, middle) for face in wall((left, 0, near), (right - left, 0, 0), (0, high, 0), [door])], BLUE)
    b.add([quad((left, high, far), (right, high, far), (right, high, near), (left, high, near))], CEILING)
    b.add([quad((8.55, high, -3.2), (8.95, high, -3.2), (8.95, high, -2.8), (8.55, high, -2.8))], COOL)
    b.add(block((8.35, 0, -3.4), (9.15, 0.9, -2.6)), MARBLE)
    b.add(turned((8.75, 0.9, -3.0), [(0.28, 0.0), (0.16, 0.2), (0.34, 0.62), (0.14, 0.9), (0.2, 1.05)], 12), GILT, True)


def _columns(b: Builder) -> None:
    """Two rows of columns with plinths and capitals."""
    for x in (1.75, 5.25, 8.75, 12.25):
        for z in (1.9, 7.1):
            b.add(block((x - 0.42, 0, z - 0.42), (x + 0.42, 0.22, z + 0.42)), STONE)
            b.add(turned((x, 0.22, z), [(0.31, 0.0), (0.26, HIGH - 0.62)], 12), STONE, smooth=True)
            b.add(turned((x, HIGH - 0.4, z), [(0.26, 0.0), (0.4, 0.22)], 12), STONE, smooth=True)
            b.add(block((x - 0.42, HIGH - 0.18, z - 0.42), (x + 0.42, HIGH, z + 0.42), "+y"), STONE)


def _sculptures(b: Builder) -> None:
    """On plinths below the shafts: an endless column, a knot, a teapot; two benches."""
    for x in (3.5, 7.0, 10.5):
        b.add(block((x - 0.5, 0, 4.0), (x + 0.5, 0.9 if x != 3.5 else 0.4, 5.0)), MARBLE)
    profile = [(0.14, 0.0)]
    for k in range(5):
        profile += [(0.3, 0.3 + 0.55 * k), (0.14, 0.55 + 0.55 * k)]
    b.add(turned((3.5, 0.4, 4.5), [*profile, (0.0, profile[-1][1])], 4), GILT)
    t = np.linspace(0.0, 2.0 * np.pi, 37) - np.pi / 2.0
    knot = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -1.3 * np.sin(3 * t)], axis=1)
    knot = 0.24 * knot
    knot += np.array((7.0, 0.98, 4.5)) - (0.0, knot[:, 1].min(), 0.0)
    b.add(pipe([*knot], 0.1, 6), Material("bronze", (0.3, 0.42, 0.34)), smooth=True)
    b.add(placed(shapes.teapot(3), (10.5, 0.9, 4.5), 0.75, 35.0), Material("copper", (0.62, 0.3, 0.16)), smooth=True)
    for z in (2.7, 6.0):
        b.add(block((4.5, 0.38, z), (6.0, 0.46, z + 0.45), ""), OAK)
        for x in (4.6, 5.8):
            b.add(block((x, 0.02, z + 0.05), (x + 0.1, 0.4, z + 0.4), ""), OAK)


def _pictures(b: Builder) -> None:
    """Paintings in gilt frames."""
    for x, wide, high, what in ((1.0, 2.2, 1.7, paintings.mountains()), (4.1, 2.2, 2.2, paintings.circles()),
                                (10.9, 2.0, 2.0, paintings.squares())):  # fmt: skip
        _picture(b, (x, 1.1, 0.0), (wide, 0, 0), high, what)
    _picture(b, (0.0, 1.0, 6.0), (0, 0, -3.0), 2.6, paintings.fields())
    _picture(b, (5.2, 1.1, DEEP), (-2.2, 0, 0), 2.2, paintings.bulge())
    _picture(b, (11.2, 1.1, DEEP), (-2.2, 0, 0), 2.2, paintings.grid())
    _picture(b, (LONG + 5.2, 1.2, 3.6), (0, 0, 1.8), 1.8, paintings.bulge())
    _picture(b, (15.6, 1.1, 1.4), (1.7, 0, 0), 1.7, paintings.squares())


def _picture(b: Builder, corner: Point, along: Point, high: float, picture: Texture) -> None:
    """Hang a painting on a wall whose front looks along ``along`` x up, from its lower left corner on."""
    rim, thick, side, up = 0.09, 0.07, unit(along), np.array((0.0, 1.0, 0.0))
    wide, out = float(np.linalg.norm(along)), np.cross(unit(along), (0.0, 1.0, 0.0))
    low = np.asarray(corner, float) - rim * (side + up) + thick * out
    outline = ((wide + 2 * rim) * side, (high + 2 * rim) * up)
    inside = (rim, rim, wide + rim, high + rim)
    b.add(wall(low, *outline, [inside]), GILT, smooth=True)
    back = [face[::-1] for face in reveal(low, *outline, thick, (0.0, 0.0, wide + 2 * rim, high + 2 * rim))]
    b.add([*back, *reveal(low, *outline, 0.03, inside)], GILT)
    canvas = [
        low - 0.03 * out + x * side + y * up
        for x, y in ((rim, rim), (wide + rim, rim), (wide + rim, high + rim), (rim, high + rim))
    ]
    b.add([np.array(canvas)], Material("painting", (1.0,) * 3, texture=picture), st=[[(0, 0), (1, 0), (1, 1), (0, 1)]])
