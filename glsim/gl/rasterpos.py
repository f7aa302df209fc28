"""The current raster position: section 2.13 of the specification."""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.gl.immediate import row
from glsim.gl.select import raster_hit
from glsim.machine.constants import GL_FOG_COORDINATE, GL_POINTS
from glsim.machine.frame import ROW, Draw, Vertices
from glsim.machine.machine import Machine
from glsim.machine.stage import vertex_stage, window
from glsim.machine.state import TEXTURE_UNITS, RasterPosition


def glRasterPos(m: Machine, x: float, y: float, z: float = 0.0, w: float = 1.0) -> None:
    """Transformed and lit like a vertex; invalid where a point would be clipped."""
    values = row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha)
    columns = {name: np.array([value], np.float32) for name, value in m.current.items()}
    columns["w"] = np.array([[w]], np.float32)
    vertices = Vertices(np.frombuffer(values, np.float32).reshape(1, ROW), columns, [])
    state = m.snapshot()
    draw = Draw(GL_POINTS, 0, 1, None, m.matrices(), m.material, state, vertices)
    stage = vertex_stage(draw, np.zeros(1, np.uint32), TEXTURE_UNITS)
    clip, eye = stage.clip[0], stage.eye[0]
    inside = clip[3] > 0.0 and bool((np.abs(clip[:3]) <= clip[3]).all())
    for plane, enabled in zip(state.transform.clip_planes, state.transform.clip_enabled, strict=True):
        inside &= not enabled or float(eye @ np.array(plane)) >= 0.0
    if not inside or not np.isfinite(clip).all():
        m.raster = m.raster._replace(valid=False)
        return
    at = window(stage.clip, m.viewport)[0].tolist()
    distance = m.current["fog_coord"][0] if m.fog.coordinate_source == GL_FOG_COORDINATE else abs(float(eye[2]))
    r, g, b, a = stage.front[0].tolist()
    highlight = (*stage.highlight[0].tolist(), 1.0)
    secondary: Any = highlight if m.lighting.enabled else m.current["secondary_color"]
    texcoords: Any = tuple(tuple(coordinates[0].tolist()) for coordinates in stage.texcoords)
    m.raster = RasterPosition(True, at[0], at[1], at[2], at[3], distance, (r, g, b, a), secondary, texcoords)
    raster_hit(m)


def glWindowPos(m: Machine, x: float, y: float, z: float = 0.0) -> None:
    """x, y: window coordinates in pixels.  The position is valid; its colours are the current ones, not lit."""
    near, far = m.viewport[4:]
    depth = near + min(max(float(z), 0.0), 1.0) * (far - near)
    distance = m.current["fog_coord"][0] if m.fog.coordinate_source == GL_FOG_COORDINATE else 0.0
    r, g, b, a = (min(max(float(c), 0.0), 1.0) for c in (m.red, m.green, m.blue, m.alpha))
    texcoords: Any = tuple(m.current[f"texcoord{unit}"] for unit in range(TEXTURE_UNITS))
    secondary: Any = m.current["secondary_color"]
    m.raster = RasterPosition(
        True,
        float(x),
        float(y),
        depth,
        1.0,
        distance,
        (r, g, b, a),
        secondary,
        texcoords,
    )
    raster_hit(m)
