"""A steel hall at dusk: evening light through the west windows, lamps under the trusses, a furnace, a loading bay."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from glsim.radiosity.rooms import surfaces
from glsim.radiosity.rooms.shapes import (
    beam,
    between,
    block,
    facing,
    pipe,
    reveal,
    ring,
    stairs,
    tiled,
    turned,
    wall,
)  # fmt: skip
from glsim.radiosity.scene import Builder, Material, Scene, View, quad

LONG, WIDE, EAVES, RIDGE = 20.0, 12.0, 6.2, 8.8  # of the hall: x, z, and heights
MIDDLE = (LONG / 2, 3.0, WIDE / 2)
UP = (0.0, EAVES, 0.0)
WINDOWS = [(z, 1.3, z + 2.2, 5.4) for z in (1.2, 4.9, 8.6)]  # in the west wall, from its left
PANES = [(x, 4.5, x + 2.4, 5.6) for x in (0.8, 4.8, 8.8, 12.8)]  # in the north wall
DOOR = (5.4, 0.0, 8.4, 3.3)  # in the east wall
MEZZANINE = 3.0  # how high it is
FURNACE = (17.0, 2.9, 9.4)  # its near corner, and its height
CABINETS = [((9.8, 0, 0), (12.1, 0.9, 0.8)), ((14.2, 0, 0), (15.4, 2.0, 0.6))]
OFFICE = (16.4, 2.15, 0.12)  # its left wall, its height, and how thick its walls are
SLABS = [  # the gallery's, and the office's roof
    ((9.0, MEZZANINE - 0.2, 0), (LONG, MEZZANINE, 3.2)),
    ((OFFICE[0], MEZZANINE + OFFICE[1], 0), (LONG, MEZZANINE + OFFICE[1] + OFFICE[2], 3.2)),
]

RED_LEAD = Material("red lead", (0.42, 0.12, 0.07))
STEEL = Material("steel", (0.38, 0.4, 0.42))
GREEN = Material("machine green", (0.13, 0.36, 0.25))
YELLOW = Material("crane yellow", (0.72, 0.48, 0.05))
BLUE = Material("tank blue", (0.1, 0.22, 0.5))
ENAMEL = Material("enamel", (0.1, 0.22, 0.16))
IRON = Material("iron", (0.16, 0.15, 0.15))
WOOD = Material("crate", (0.5, 0.34, 0.18))
CONCRETE = Material("bare concrete", (0.4, 0.4, 0.39))
WHITE = Material("whitewash", (0.72, 0.7, 0.66))
EVENING = Material("evening sky", (0.05,) * 3, (0.75, 0.25, 0.075))
DUSK = Material("dusk", (0.05,) * 3, (0.12, 0.2, 0.42))
LAMP = Material("lamp", (0.3,) * 3, (1500.0, 1030.0, 470.0))
FLOOD = Material("floodlight", (0.3,) * 3, (700.0, 930.0, 1030.0))
OFFICE_LAMP = Material("office lamp", (0.3,) * 3, (50.0, 48.0, 34.0))
BULKHEAD = Material("bulkhead lamp", (0.3,) * 3, (70.0, 44.0, 18.0))
FIRE = Material("fire", (0.1,) * 3, (150.0, 34.0, 4.5))


def factory() -> Scene:
    """Return the hall."""
    b = Builder("factory")
    for build in (_shell, _roof, _bay, _lamps, _mezzanine, _office, _engine, _tanks, _furnace, _crane, _goods):
        build(b)
    scene = b.scene(
        View((0.7, 2.5, 9.0), (14.0, 2.6, 5.0), fov=64.0, name="hall"),
        View((15.7, 4.75, 2.3), (3.0, 1.5, 7.6), fov=64.0, name="gallery"),
        View((9.6, 1.5, 9.7), (18.6, 2.0, 8.2), fov=66.0, name="furnace"),
    )
    return replace(scene, white=1.15)


def _shell(b: Builder) -> None:
    """Floor, walls of brick with windows, and the sky behind these."""
    bricks = Material("brick", (1.0,) * 3, texture=surfaces.bricks())
    (x, y, z), south = FURNACE, LONG - FURNACE[0]
    west, north = ((0, 0, WIDE), (0, 0, -WIDE), UP), ((0, 0, 0), (LONG, 0, 0), UP)
    behind = [(low[0], low[1], high[0], high[1]) for low, high in (*CABINETS, *SLABS)]  # where nobody sees the wall
    under = [(low[0], WIDE - high[2], high[0], WIDE) for low, high in CABINETS]
    floor = wall((0, 0, WIDE), (LONG, 0, 0), (0, 0, -WIDE), [(x, 0.0, LONG, WIDE - z), *under])
    tiled(b, floor, Material("concrete", (1.0,) * 3, texture=surfaces.concrete()), 4.0)
    tiled(b, wall(*west, WINDOWS), bricks, 2.0)
    tiled(b, wall(*north, [*PANES, *behind]), bricks, 2.0)
    ends = [(low[2], low[1], high[2], high[1]) for low, high in SLABS]
    tiled(b, wall((LONG, 0, 0), (0, 0, WIDE), UP, [DOOR, (z, 0.0, WIDE, y), *ends]), bricks, 2.0)
    tiled(b, wall((LONG, 0, WIDE), (-LONG, 0, 0), UP, [(0.0, 0.0, south, y)]), bricks, 2.0)
    for x in (0.0, LONG):
        gable = np.array([(x, EAVES, 0), (x, EAVES, WIDE), (x, RIDGE, WIDE / 2)], float)
        tiled(b, [facing(gable, MIDDLE)], bricks, 2.0)
    for opening in WINDOWS:
        b.add(reveal(*west, 0.4, opening), WHITE)
        left, low, right, high = opening
        b.add(
            [np.array([(-0.4, y, WIDE - z) for z, y in ((left, low), (right, low), (right, high), (left, high))])],
            EVENING,
        )
        for z in np.linspace(WIDE - left, WIDE - right, 4)[1:-1].tolist():
            b.add(beam((-0.2, low, z), (-0.2, high, z), 0.07, 0.07), IRON)
        for y in np.linspace(low, high, 6)[1:-1].tolist():
            b.add(beam((-0.2, y, WIDE - left), (-0.2, y, WIDE - right), 0.06, 0.06), IRON)
    for opening in PANES:
        b.add(reveal(*north, 0.3, opening), WHITE)
        left, low, right, high = opening
        b.add([quad((left, low, -0.3), (right, low, -0.3), (right, high, -0.3), (left, high, -0.3))], DUSK)


def _roof(b: Builder) -> None:
    """Two slopes of corrugated steel on four trusses, which stand on columns."""
    tin = Material("corrugated steel", (1.0,) * 3, texture=surfaces.sheets())
    for z in (0.0, WIDE):
        slope = quad((0, EAVES, z), (LONG, EAVES, z), (LONG, RIDGE, WIDE / 2), (0, RIDGE, WIDE / 2))
        tiled(b, [facing(slope, MIDDLE)], tin, 2.0)
    for x in (2.5, 7.5, 12.5, 17.5):
        for z in (0.3, WIDE - 0.3):
            low = FURNACE[1] if (x, z) == (17.5, WIDE - 0.3) else 0.0  # a column that stands on the furnace
            b.add(beam((x, low, z), (x, EAVES - 0.3, z), 0.22, 0.3), RED_LEAD)
        _truss(b, x)


def _truss(b: Builder, x: float) -> None:
    """Two chords, and diagonals between them."""
    low, panels = EAVES - 0.25, 8
    z = np.linspace(0.15, WIDE - 0.15, panels + 1)
    top = EAVES - 0.14 + (RIDGE - EAVES) / (WIDE / 2) * np.minimum(z, WIDE - z)
    b.add(beam((x, low, 0.02), (x, low, WIDE - 0.02), 0.16, 0.16), RED_LEAD)
    for side in (0, panels):
        b.add(beam((x, top[side], z[side]), (x, top[panels // 2], WIDE / 2), 0.14, 0.14), RED_LEAD)
    for k in range(1, panels):
        b.add(beam((x, low, z[k]), (x, top[k], z[k]), 0.07, 0.07), RED_LEAD)
        if k != panels // 2:
            b.add(beam((x, top[k], z[k]), (x, low, z[k + 1 if k < panels // 2 else k - 1]), 0.07, 0.07), RED_LEAD)


def _bay(b: Builder) -> None:
    """A loading bay behind the east door: a floodlight there shines into the hall."""
    near, far, left, right, high = LONG + 0.35, LONG + 5.0, 3.4, 10.2, 4.2
    middle = (near + 1.0, 2.0, 6.0)
    b.add(reveal((LONG, 0, 0), (0, 0, WIDE), UP, 0.35, DOOR), WHITE)
    b.add([facing(face, middle) for face in block((near, 0, left), (far, high, right), "-x")], CONCRETE)
    front = wall((near, 0, left), (0, 0, right - left), (0, high, 0), [(DOOR[0] - left, 0.0, DOOR[2] - left, DOOR[3])])
    b.add([facing(face, middle) for face in front], CONCRETE)
    b.add([facing(quad((far, 2.6, 6.4), (far, 2.6, 7.2), (far, 3.2, 7.2), (far, 3.2, 6.4)), middle)], FLOOD)
    b.add(block((near + 1.6, 0, 8.0), (near + 4.0, 2.1, 10.0)), Material("container", (0.55, 0.06, 0.04)))
    b.add(block((near + 1.0, 0, 5.2), (near + 2.0, 1.3, 6.1)), WOOD)


def _lamps(b: Builder) -> None:
    """Two rows of small lamps deep in enamelled shades, which cut their light to pools on the floor."""
    for x in (4.0, 8.0, 12.0, 16.0):
        for z in (4.2, 8.6):
            foot = (x, 3.7, z)
            outer, inner = [(0.3, 0.0), (0.13, 0.46), (0.0, 0.52)], [(0.28, 0.0), (0.11, 0.44)]
            b.add(turned(foot, outer, 8), ENAMEL, smooth=True)
            b.add([face[::-1] for face in turned(foot, inner, 8)], WHITE, smooth=True)
            b.add([ring((x, 4.14, z), (0, -1, 0), 0.11, 8)], LAMP)
            b.add(pipe([(x, 4.2, z), (x, RIDGE - 1.0, z)], 0.02, 3), IRON)


def _mezzanine(b: Builder) -> None:
    """A gallery along the north wall, with stairs and railings; lamps are below it."""
    (near, _, _), (_, high, deep) = SLABS[0]
    b.add(block(*SLABS[0], "+x -z"), STEEL)
    treads, carriers = stairs((near - 3.9, 0, deep - 0.6), (3.9, 0, 0), 14, 1.0, high / 14)
    b.add(treads, STEEL)
    b.add(carriers, YELLOW)
    for x in (near + 0.2, near + 3.8, near + 7.4):
        b.add(beam((x, 0, deep - 0.15), (x, high - 0.2, deep - 0.15), 0.16, 0.16), STEEL)
    for y in (0.55, 1.05):
        b.add(beam((near, high + y, deep - 0.1), (OFFICE[0], high + y, deep - 0.1), 0.05, 0.05), YELLOW)
    for x in np.linspace(near + 0.05, 16.3, 6):
        b.add(beam((x, high + 0.02, deep - 0.1), (x, high + 1.05, deep - 0.1), 0.05, 0.05), YELLOW)
    for x in (10.8, 14.4):
        y = high - 0.2
        b.add([quad((x, y, 1.4), (x + 0.3, y, 1.4), (x + 0.3, y, 1.7), (x, y, 1.7))], BULKHEAD)
    for (low, top), paint in zip(CABINETS, (GREEN, BLUE), strict=True):
        b.add(block(low, top, "-y -z"), paint)


def _office(b: Builder) -> None:
    """The foreman's office on the gallery; its light falls through window and door onto the steel."""
    (left, high, thick), low, deep = OFFICE, MEZZANINE, 3.2
    up, window, door = (0, high, 0), (0.6, 0.9, 3.1, 1.9), (1.2, 0.0, 2.1, 2.0)
    front, side = ((left, low, deep), (LONG - left, 0, 0), up), ((left, low, 0), (0, 0, deep), up)
    b.add([*wall(*front, [window]), *wall(*side, [door])], WHITE)
    b.add([*reveal(*front, thick, window), *reveal(*side, thick, door)], WHITE)
    inner = wall((left + thick, low, deep - thick), (LONG - left - thick, 0, 0), up,
                 [(window[0] - thick, window[1], window[2] - thick, window[3])])  # fmt: skip
    inner += wall((left + thick, low, 0), (0, 0, deep - thick), up, [door])
    b.add([face[::-1] for face in inner], WHITE)
    b.add(block(*SLABS[1], "+x -z"), WHITE)
    y = low + high
    b.add([quad((17.6, y, 1.3), (19.0, y, 1.3), (19.0, y, 1.6), (17.6, y, 1.6))], OFFICE_LAMP)


def _engine(b: Builder) -> None:
    """A flywheel with six spokes between two bearings, and the engine beside it."""
    x, y, z, radius = 8.6, 1.62, 6.4, 1.6
    front, back = (
        [ring((x, y, z + side), (0, 0, 1), r, 20) for r in (radius, radius - 0.22)] for side in (0.14, -0.14)
    )
    b.add(between(back[0], front[0]), GREEN, smooth=True)
    b.add([face[::-1] for face in between(back[1], front[1])], GREEN, smooth=True)
    b.add([*between(front[0], front[1]), *(face[::-1] for face in between(back[0], back[1]))], GREEN)
    for angle in (np.arange(6) * np.pi / 3 + 0.2).tolist():
        b.add(beam((x, y, z), (x + 1.42 * np.cos(angle), y + 1.42 * np.sin(angle), z), 0.1, 0.1), GREEN)
    b.add(pipe([(x, y, z - 0.7), (x, y, z + 0.7)], 0.14, 8, ends=True), STEEL)
    for side in (-0.75, 0.55):
        b.add(block((x - 0.35, 0, z + side), (x + 0.35, y + 0.22, z + side + 0.2)), IRON)
    b.add(block((x + 1.9, 0, z - 0.6), (x + 3.9, 0.8, z + 0.6)), GREEN)
    b.add(pipe([(x + 2.0, 1.21, z), (x + 3.8, 1.21, z)], 0.42, 12, ends=True), GREEN, smooth=True)
    b.add(beam((x + 0.1, y, z + 0.42), (x + 2.2, 1.21, z + 0.42), 0.08, 0.12), STEEL)


def _tanks(b: Builder) -> None:
    """Two tanks in the north-west corner, and pipes along the walls."""
    for x in (1.5, 3.9):
        b.add(turned((x, 0.0, 1.7), [(0.95, 0.0), (0.95, 3.0), (0.66, 3.4), (0.0, 3.55)], 16), BLUE, smooth=True)
        b.add(pipe([(x, 3.5, 1.7), (x, 4.1, 1.7), (x, 4.1, 0.7)], 0.13, 8), STEEL, smooth=True)
    b.add(pipe([(0.0, 4.1, 0.7), (8.2, 4.1, 0.7), (8.2, 0.0, 0.7)], 0.17, 8), STEEL, smooth=True)
    for y, paint in ((4.5, RED_LEAD), (4.95, STEEL)):
        b.add(pipe([(0.0, y, 11.36), (LONG, y, 11.36)], 0.14, 8), paint, smooth=True)
    b.add(pipe([(13.4, 4.5, 11.36), (13.4, 1.0, 11.36), (17.0, 1.0, 11.36)], 0.14, 8), RED_LEAD, smooth=True)


def _furnace(b: Builder) -> None:
    """A furnace of brick with a chimney; its mouth glows towards the hall."""
    left, low, near = FURNACE
    bricks = Material("brick", (1.0,) * 3, texture=surfaces.bricks())
    mouth = (0.6, 0.5, 1.8, 1.4)
    place = ((left, 0, near), (0, 0, WIDE - near), (0, low, 0))
    tiled(b, wall(*place, [mouth]), bricks, 2.0)
    b.add(reveal(*place, 0.5, mouth), IRON)
    z, w = near + mouth[0], near + mouth[2]
    b.add([quad((left + 0.5, 0.5, z), (left + 0.5, 0.5, w), (left + 0.5, 1.4, w), (left + 0.5, 1.4, z))], FIRE)
    tiled(b, block((left, 0, near), (LONG, low, WIDE), "-x +x -y +y +z"), bricks, 2.0)
    x, z, half = 18.6, 10.6, 0.5  # the chimney, from the furnace's top to the roof
    flue = (x - half - left, WIDE - z - half, x + half - left, WIDE - z + half)
    tiled(b, wall((left, low, WIDE), (LONG - left, 0, 0), (0, 0, near - WIDE), [flue]), bricks, 2.0)
    foot = np.array(
        [(x - half, low, z + half), (x + half, low, z + half), (x + half, low, z - half), (x - half, low, z - half)]
    )
    head = foot.copy()
    head[:, 1] = EAVES + (RIDGE - EAVES) / (WIDE / 2) * (WIDE - foot[:, 2])
    tiled(b, between(foot, head), bricks, 2.0)


def _crane(b: Builder) -> None:
    """A travelling crane on two rails, with a hook."""
    for z in (0.62, WIDE - 0.62):
        b.add(beam((0, 5.4, z), (LONG, 5.4, z), 0.16, 0.2), STEEL)
    x = 5.2
    for side in (-0.45, 0.45):
        b.add(beam((x + side, 5.67, 0.5), (x + side, 5.67, WIDE - 0.5), 0.2, 0.34), YELLOW)
    b.add(block((x - 0.7, 5.26, 6.6), (x + 0.7, 5.5, 7.6), ""), YELLOW)
    for side in (-0.1, 0.1):
        b.add(pipe([(x + side, 2.9, 7.1), (x + side, 5.27, 7.1)], 0.02, 3), IRON)
    b.add(block((x - 0.2, 2.45, 6.9), (x + 0.2, 2.95, 7.3), ""), YELLOW)
    hook = [(0.0, 2.5), (0.0, 2.2), (0.16, 2.0), (0.02, 1.86), (-0.14, 1.96)]
    b.add(pipe([(x + side, y, 7.1) for side, y in hook], 0.05, 6, ends=True), IRON)


def _goods(b: Builder) -> None:
    """Crates, barrels, a work bench with a drill."""
    for x, z, size, low, high in ((10.4, 10.6, 1.2, 0.0, 1.1), (10.5, 10.7, 0.8, 1.1, 1.8), (14.6, 4.6, 1.3, 0.0, 1.0)):
        b.add(block((x, low, z), (x + size, high, z + size)), WOOD)
    for x, z in ((5.2, 5.3), (5.9, 4.7), (13.6, 5.4)):
        b.add(turned((x, 0, z), [(0.3, 0.0), (0.3, 0.9), (0.0, 0.9)], 12), Material("barrel", (0.5, 0.08, 0.05)))
    b.add(block((2.6, 0.82, 10.4), (5.4, 0.92, 11.3), ""), WOOD)
    for x, z in ((2.7, 10.5), (5.3, 10.5), (2.7, 11.2), (5.3, 11.2)):
        b.add(beam((x, 0.02, z), (x, 0.83, z), 0.1, 0.1), IRON)
    b.add(block((3.2, 0.92, 10.9), (3.5, 2.0, 11.2)), GREEN)
    b.add(block((3.05, 1.75, 10.5), (3.65, 2.15, 11.25), ""), GREEN)
