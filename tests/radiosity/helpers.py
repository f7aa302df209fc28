"""What several test files use: reference data, small scenes, form factors of single polygons."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np

from glsim.radiosity.pairs import pair
from glsim.radiosity.polygon import area
from glsim.radiosity.rooms.shapes import block, turned
from glsim.radiosity.scene import Builder, Material, Scene, View, box, normal_of, quad

ENVIRONMENT = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
REFERENCE = Path(__file__).parents[1] / "reference"
CASES = json.loads((REFERENCE / "analytic_cases.json").read_text())


def form_factor(one: Any, two: Any, exact: bool = True) -> float:
    """F from polygon one to polygon two."""
    polygons = [np.array(polygon, float) for polygon in (one, two)]
    normals = [normal_of(polygon) for polygon in polygons]
    centers = [polygon.mean(axis=0) for polygon in polygons]
    sizes = [
        2 * float(np.linalg.norm(polygon - center, axis=1).max())
        for polygon, center in zip(polygons, centers, strict=True)
    ]
    work = np.empty((6, 3)), np.empty((6, 3))
    first, second = ((polygon, len(polygon), normal) for polygon, normal in zip(polygons, normals, strict=True))
    S = pair(*first, *second, *centers, *sizes, exact, *work)
    return S / area(polygons[0], len(polygons[0]))


def disc(radius: float, z: float, up: bool, corners: int = 400) -> np.ndarray:
    """A polygon with the disc's area."""
    angle = np.arange(corners) * 2 * np.pi / corners
    r = radius * np.sqrt(2 * np.pi / (corners * np.sin(2 * np.pi / corners)))
    polygon = np.stack([r * np.cos(angle), r * np.sin(angle), 0 * angle + z], axis=1)
    return polygon if up else polygon[::-1]


def room(size: tuple[float, float, float], materials: list[Material]) -> Scene:
    b = Builder("room")
    for polygon, material in zip(box((0, 0, 0), size, inside=True), materials, strict=True):
        b.add([polygon], material)
    return b.scene()


def hall() -> Scene:
    """A hall with lamps in the ceiling, columns, tanks, and crates into which cones reach; two cameras."""
    b = Builder("hall")
    b.add(box((0, 0, 0), (24, 8, 14), inside=True), Material("wall", (0.55, 0.45, 0.4)))
    for x in (3.0, 10.5, 18.0):
        b.add([quad((x, 8, 2), (x + 3, 8, 2), (x + 3, 8, 5), (x, 8, 5))], Material("lamp", (0.1,) * 3, (10.0,) * 3))
    for x in (6.0, 12.0, 18.0):
        b.add(block((x, 0, 1), (x + 0.5, 8, 1.5), "-y +y"), Material("steel", (0.45, 0.47, 0.5)))
        b.add(block((x - 3.0, 0, 6), (x - 1.0, 1.5, 8.2)), Material("crate", (0.6, 0.42, 0.22)))
        b.add(turned((x - 2.0, 1.4, 7.1), [(0.3, 0.0), (0.0, 0.9)], 8), Material("cone", (0.7, 0.3, 0.2)), smooth=True)
        tank = turned((x + 2.0, 0, 10), [(0.85, 0.0), (0.85, 3.2), (0.0, 3.6)], 12)
        b.add(tank, Material("tank", (0.2, 0.3, 0.6)), smooth=True)
    b.add(block((8.6, 6.0, 0.6), (9.4, 6.7, 13.4), ""), Material("crane", (0.75, 0.35, 0.08)))
    return b.scene(View((22.6, 3.6, 11.9), (8, 2, 3.5), fov=55), View((0.8, 2.2, 13.0), (14, 2, 4), fov=55))


def mesh_area(triangles: np.ndarray) -> float:
    return float(
        np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1).sum() / 2
    )
