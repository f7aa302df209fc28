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
    rings = [np.array(ring, float) for ring in (one, two)]
    normals = [normal_of(ring) for ring in rings]
    centers = [ring.mean(axis=0) for ring in rings]
    sizes = [
        2 * float(np.linalg.norm(ring - center, axis=1).max()) for ring, center in zip(rings, centers, strict=True)
    ]
    work = np.empty((6, 3)), np.empty((6, 3))
    S = pair(
        rings[0], len(rings[0]), normals[0], rings[1], len(rings[1]), normals[1], centers[0], centers[1], sizes[0],
        sizes[1], exact, *work,
    )  # fmt: skip
    return S / area(rings[0], len(rings[0]))


def disc(radius: float, z: float, up: bool, corners: int = 400) -> np.ndarray:
    """A polygon with the disc's area."""
    angle = np.arange(corners) * 2 * np.pi / corners
    r = radius * np.sqrt(2 * np.pi / (corners * np.sin(2 * np.pi / corners)))
    ring = np.stack([r * np.cos(angle), r * np.sin(angle), 0 * angle + z], axis=1)
    return ring if up else ring[::-1]


def room(size: tuple[float, float, float], materials: list[Material]) -> Scene:
    b = Builder("room")
    for ring, material in zip(box((0, 0, 0), size, inside=True), materials, strict=True):
        b.add([ring], material)
    return b.scene()


def mesh_area(triangles: np.ndarray) -> float:
    return float(
        np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1).sum() / 2
    )
