"""Tracks: current values that few programs change at each vertex (texture and fog coordinates, edge flag, ...)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.machine.frame import ROW_BYTES
from glsim.machine.state import TEXTURE_UNITS

# The values of an attribute that few programs change from vertex to vertex: pairs (byte position in the stream, value).
# A value holds for the vertices from its position to the next pair's.
Track = list[tuple[int, tuple[float, ...]]]
INITIAL_VALUES: dict[str, tuple[float, ...]] = {
    **{f"texcoord{unit}": (0.0, 0.0, 0.0, 1.0) for unit in range(TEXTURE_UNITS)},
    "secondary_color": (0.0, 0.0, 0.0, 1.0),
    "fog_coord": (0.0,),
    "edge_flag": (1.0,),
}


def column_of(track: Track, count: int) -> NDArray[np.float32]:
    """A track as a column: (count, width), or (1, width) if it never changed."""
    if len(track) == 1:
        return np.array([track[0][1]], np.float32)
    positions = np.array([position for position, _ in track]) // ROW_BYTES
    values = np.array([value for _, value in track], np.float32)
    return np.repeat(values, np.diff(np.append(positions, count)), axis=0)
