"""What several test files use: reference data, small scenes, form factors of single polygons."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np

from glsim.radiosity.pairs import pair
from glsim.radiosity.polygon import area
from glsim.radiosity.scene import Builder, Material, Scene, box, normal_of

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


def mesh_area(triangles: np.ndarray) -> float:
    return float(
        np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1).sum() / 2
    )
