"""Built-in scenes for radiosity."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from glsim.radiosity.rooms.factory import factory
from glsim.radiosity.rooms.museum import museum
from glsim.radiosity.scene import Builder, Material, Scene, View, box, quad

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
    "museum": BuiltIn("daylight in shafts, sculptures, paintings, doors to two rooms more", museum),
    "factory": BuiltIn("a steel hall at dusk: lamps, trusses, a flywheel, a furnace", factory),
}
