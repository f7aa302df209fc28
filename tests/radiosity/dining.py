"""A dining room as modellers make them: 7,600 triangles, most of them far smaller than a patch.

Chairs are bent sheets with a single side, on legs that reach into the seat; rugs lie on the floor and a cloth on the
table with no gap between; cupboards stand against walls, so that two layers face each other; lamps are balls of many
small triangles; plates, bowls, glasses and curtains are thousands of triangles. Everything is deterministic.

    dining()                    the room as a Scene
    write_dining(folder)        the same room as dining.obj with dining.mtl (Kd, Ke), as others' files are
    python -m tests.radiosity.dining FOLDER
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.scene import Builder, Material, Scene, View, box, quad

Float = NDArray[np.float64]
WIDE, HIGH, DEEP = 6.0, 2.8, 5.0  # of the room, in metres
TABLE = (3.0, 0.74, 2.5)  # middle of its top
PAINT = {
    material.name: material
    for material in (
        Material("plaster", (0.75, 0.73, 0.68)),
        Material("parquet", (0.42, 0.27, 0.15)),
        Material("rug", (0.45, 0.08, 0.07)),
        Material("border", (0.12, 0.13, 0.35)),
        Material("oak", (0.5, 0.33, 0.18)),
        Material("linen", (0.8, 0.78, 0.72)),
        Material("leather", (0.2, 0.1, 0.06)),
        Material("china", (0.82, 0.82, 0.8)),
        Material("curtain", (0.5, 0.42, 0.3)),
        Material("canvas", (0.3, 0.4, 0.5)),
        Material("bulb", (0.0, 0.0, 0.0), (60.0, 48.0, 30.0)),
        Material("daylight", (0.0, 0.0, 0.0), (5.0, 6.0, 8.0)),
    )
}


class Thing(NamedTuple):
    """One object of the file.  triangles: (m, 3, 3), fronts counterclockwise; smooth: it is a curved surface."""

    name: str
    material: str
    triangles: Float
    smooth: bool = False


def things() -> list[Thing]:
    """Return all objects of the room."""
    room = box((0, 0, 0), (WIDE, HIGH, DEEP), inside=True)
    x, y, z = TABLE
    result = [
        Thing("floor", "parquet", flat(room[2:3])),
        Thing("walls", "plaster", flat(room[:2] + room[3:])),
        Thing("rug", "rug", flat([level(1.2, 4.8, 1.0, 4.0, 0.0)])),  # on the floor, and another one on that rug
        Thing("border", "border", flat([level(1.6, 4.4, 1.4, 3.6, 0.0)])),
        Thing("top", "oak", flat(box((x - 1.1, y - 0.04, z - 0.55), (x + 1.1, y, z + 0.55)))),
        Thing("cloth", "linen", flat([level(x - 0.9, x + 0.9, z - 0.4, z + 0.4, y)])),
        Thing("window", "daylight", flat([quad((0, 0.9, 1.5), (0, 2.2, 1.5), (0, 2.2, 3.5), (0, 0.9, 3.5))])),
        Thing("picture", "canvas", flat([quad((2, 1.2, 0), (4, 1.2, 0), (4, 2.2, 0), (2, 2.2, 0))])),
        Thing("cupboard", "oak", flat(box((4.6, 0, 0), (5.8, 1.9, 0.45)))),
        Thing("sideboard", "oak", flat(box((WIDE - 0.5, 0, 1.6), (WIDE, 0.9, 3.4)))),
    ]
    for k, (a, b) in enumerate(((-1, -0.45), (-1, 0.45), (1, -0.45), (1, 0.45))):
        foot = np.array((x + a, 0.0, z + b))
        result.append(Thing(f"leg {k}", "oak", lathe(foot, [(0.05, 0), (0.03, 0.35), (0.05, y)], 8), True))
    for k, (a, b, turn) in enumerate(PLACES):
        result += chair(k, np.array((x + a * 1.65, 0.0, z + b * 1.65)), turn)
        result += place(k, np.array((x + a, y, z + b)))
    for k in range(5):
        middle = np.array((x + 0.35 * np.cos(k * 2 * np.pi / 5), 1.75, z + 0.35 * np.sin(k * 2 * np.pi / 5)))
        result.append(Thing(f"bulb {k}", "bulb", ball(middle, 0.055, 12), True))
    for k, low in enumerate((0.7, 3.3)):
        result.append(Thing(f"curtain {k}", "curtain", curtain(low), True))
    return result


# where people sit, from the table's middle: x, z, and the angle to which the chair is turned
PLACES = [(-0.6, -0.38, 0.0), (0.0, -0.38, 0.0), (0.6, -0.38, 0.0), (-0.6, 0.38, np.pi), (0.0, 0.38, np.pi),
          (0.6, 0.38, np.pi)]  # fmt: skip


def dining() -> Scene:
    """Return the room as a Scene."""
    b = Builder("dining")
    for thing in things():
        b.add(thing.triangles, PAINT[thing.material], thing.smooth)
    return b.scene(View((5.6, 1.7, 4.7), (2.6, 0.8, 2.0), fov=62.0))


def write_dining(folder: Path) -> Path:
    """Write dining.obj and dining.mtl into a folder, and return the path of the former."""
    lines, many = ["mtllib dining.mtl"], 1
    for thing in things():
        points, faces = np.unique(thing.triangles.reshape(-1, 3).round(6), axis=0, return_inverse=True)
        lines += [f"o {thing.name}", f"usemtl {thing.material}", f"s {'1' if thing.smooth else 'off'}"]
        lines += ["v {:.6g} {:.6g} {:.6g}".format(*point) for point in points.tolist()]
        lines += ["f {} {} {}".format(*face) for face in (faces.reshape(-1, 3) + many).tolist()]
        many += len(points)
    text = "\n".join(f"newmtl {m.name}\nKd {numbers(m.rho)}\nKe {numbers(m.E)}\n" for m in PAINT.values())
    (folder / "dining.mtl").write_text(text)
    (folder / "dining.obj").write_text("\n".join(lines) + "\n")
    return folder / "dining.obj"


def numbers(values: tuple[float, ...]) -> str:
    return " ".join(f"{value:g}" for value in values)


# ---------------------------------------------------------------- shapes, all of them (m, 3, 3)


def flat(polygons: list[Float]) -> Float:
    """Quads as two triangles each."""
    return np.array([polygon[corners] for polygon in polygons for corners in ([0, 1, 2], [0, 2, 3])])


def level(left: float, right: float, back: float, front: float, height: float) -> Float:
    """A rectangle that looks up."""
    return quad((left, height, back), (left, height, front), (right, height, front), (right, height, back))


def sheet(points: Float) -> Float:
    """A sheet over points (rows, columns, 3); triangles without area are left out."""
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    both = np.concatenate([np.stack([a, b, c], 2).reshape(-1, 3, 3), np.stack([a, c, d], 2).reshape(-1, 3, 3)])
    area = np.linalg.norm(np.cross(both[:, 1] - both[:, 0], both[:, 2] - both[:, 0]), axis=1)
    return np.asarray(both[area > 1e-12])


def lathe(foot: Float, profile: list[tuple[float, float]], sides: int) -> Float:
    """A profile (radius, height), from below upwards, turned around an upright axis; its front looks outwards."""
    angle = np.linspace(0.0, 2.0 * np.pi, sides + 1)
    angle[-1] = 0.0
    radius, height = np.array(profile[::-1]).T[:, :, None]
    points = np.stack([radius * np.cos(-angle), height + 0 * angle, radius * np.sin(-angle)], axis=2)
    return sheet(points + foot)


def ball(middle: Float, radius: float, bands: int) -> Float:
    latitude = np.linspace(-np.pi / 2, np.pi / 2, bands + 1)
    profile = [(max(radius * np.cos(a), 0.0) if abs(a) < 1.57 else 0.0, radius * np.sin(a)) for a in latitude.tolist()]
    return lathe(middle, profile, bands)


def chair(number: int, at: Float, turn: float) -> list[Thing]:
    """Seat and back are bent sheets with one side; four legs reach through the seat."""
    u, v = np.meshgrid(np.linspace(-0.22, 0.22, 7), np.linspace(-0.22, 0.22, 7))
    seat = np.stack([u, 0.45 - 0.02 * np.cos(u * 7) * np.cos(v * 7), v], axis=2)
    u, v = np.meshgrid(np.linspace(-0.22, 0.22, 7), np.linspace(0.95, 0.43, 7))
    back = np.stack([u, v, -0.22 - 0.3 * (v - 0.43) ** 2 + 0.04 * np.cos(u * 7)], axis=2)
    spin = np.array([[np.cos(turn), 0, -np.sin(turn)], [0, 1, 0], [np.sin(turn), 0, np.cos(turn)]])
    legs = [lathe(np.array((x, 0, z)), [(0.015, 0), (0.022, 0.48)], 6) for x in (-0.18, 0.18) for z in (-0.18, 0.18)]
    parts = (("seat", "leather", sheet(seat)), ("back", "leather", sheet(back)), ("legs", "oak", np.concatenate(legs)))
    return [Thing(f"{name} {number}", paint, part @ spin.T + at, True) for name, paint, part in parts]


def place(number: int, at: Float) -> list[Thing]:
    """A plate, a bowl on it, and a glass; they stand on the cloth with no gap."""
    plate = [(0.0, 0.0), (0.07, 0.0), (0.13, 0.02), (0.128, 0.024), (0.07, 0.008), (0.0, 0.008)]
    bowl = [(0.0, 0.008), (0.03, 0.008), (0.07, 0.05), (0.066, 0.05), (0.028, 0.014), (0.0, 0.014)]
    glass = [(0.0, 0.0), (0.03, 0.0), (0.004, 0.01), (0.004, 0.07), (0.035, 0.11), (0.03, 0.17), (0.028, 0.17),
             (0.033, 0.11), (0.0, 0.075)]  # fmt: skip
    beside = at + np.array((0.17, 0.0, -0.09 if at[2] > TABLE[2] else 0.09))
    parts = (("plate", plate, at, 20), ("bowl", bowl, at, 20), ("glass", glass, beside, 20))
    return [Thing(f"{name} {number}", "china", lathe(foot, line, n), True) for name, line, foot, n in parts]


def curtain(low: float) -> Float:
    """A waved sheet beside the window, with one side, that looks into the room."""
    z, y = np.meshgrid(np.linspace(low + 1.0, low, 49), np.linspace(2.5, 0.05, 9))
    return sheet(np.stack([0.12 + 0.05 * np.sin(30 * z) * (1.1 - 0.2 * y), y, z], axis=2))


if __name__ == "__main__":
    print(write_dining(Path(sys.argv[1])))
