"""Points, lines and polygons: section 3 of the specification."""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.gl.arguments import exactly, numbers
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_value
from glsim.machine.machine import Machine
from glsim.machine.packing import unpack
from glsim.machine.types import raw_bytes

LARGEST_POINT = 255.0
LARGEST_LINE = 255.0


def glPointSize(m: Machine, size: float) -> None:
    if not size > 0:
        raise invalid_value("size", size, "more than 0")
    m.point = m.point._replace(size=float(size))


POINT_PARAMETERS: dict[int, str] = {
    gl.GL_POINT_SIZE_MIN: "size_min",
    gl.GL_POINT_SIZE_MAX: "size_max",
    gl.GL_POINT_FADE_THRESHOLD_SIZE: "fade_threshold",
}


def glPointParameter(m: Machine, pname: int, params: Any) -> None:
    if pname == gl.GL_POINT_DISTANCE_ATTENUATION:
        a, b, c = exactly(params, 3, "GL_POINT_DISTANCE_ATTENUATION")
        m.point = m.point._replace(distance_attenuation=(a, b, c))
        return
    field = POINT_PARAMETERS.get(pname)
    if field is None:
        raise invalid_enum("pname", pname, "a point parameter such as GL_POINT_DISTANCE_ATTENUATION")
    (value,) = exactly(params, 1, "this parameter")
    if not value >= 0:
        raise invalid_value("param", value, "at least 0")
    m.point = m.point._replace(**{field: value})  # type: ignore[arg-type]


def glLineWidth(m: Machine, width: float) -> None:
    if not width > 0:
        raise invalid_value("width", width, "more than 0")
    m.line = m.line._replace(width=float(width))


def glLineStipple(m: Machine, factor: int, pattern: int) -> None:
    m.line = m.line._replace(stipple_factor=min(max(int(factor), 1), 256), stipple_pattern=int(pattern) & 0xFFFF)


def glCullFace(m: Machine, mode: int) -> None:
    if mode not in (gl.GL_FRONT, gl.GL_BACK, gl.GL_FRONT_AND_BACK):
        raise invalid_enum("mode", mode, "GL_FRONT, GL_BACK or GL_FRONT_AND_BACK")
    m.polygon = m.polygon._replace(cull_face=mode)


def glFrontFace(m: Machine, mode: int) -> None:
    if mode not in (gl.GL_CW, gl.GL_CCW):
        raise invalid_enum("mode", mode, "GL_CW or GL_CCW")
    m.polygon = m.polygon._replace(front_face=mode)


def glPolygonMode(m: Machine, face: int, mode: int) -> None:
    if face not in (gl.GL_FRONT, gl.GL_BACK, gl.GL_FRONT_AND_BACK):
        raise invalid_enum("face", face, "GL_FRONT, GL_BACK or GL_FRONT_AND_BACK")
    if mode not in (gl.GL_POINT, gl.GL_LINE, gl.GL_FILL):
        raise invalid_enum("mode", mode, "GL_POINT, GL_LINE or GL_FILL")
    front = mode if face != gl.GL_BACK else m.polygon.front_mode
    back = mode if face != gl.GL_FRONT else m.polygon.back_mode
    m.polygon = m.polygon._replace(front_mode=front, back_mode=back)


def glPolygonOffset(m: Machine, factor: float, units: float) -> None:
    m.polygon = m.polygon._replace(offset_factor=float(factor), offset_units=float(units))


def glPolygonStipple(m: Machine, mask: Any) -> None:
    """mask: a bitmap of 32 x 32 pixels, rows from the bottom, or PyOpenGL's (32, 32) array of ones and zeros."""
    bits = np.asarray(numbers(mask)) if raw_bytes(mask) is None and np.size(mask) == 1024 else None
    if bits is None:
        bits = unpack(m.stores.unpack, (32, 32), gl.GL_COLOR_INDEX, gl.GL_BITMAP, mask)
    rows = np.packbits(bits.reshape(32, 32) != 0, axis=1).view(">u4").ravel().tolist()
    m.polygon_stipple = m.polygon_stipple._replace(rows=tuple(rows))


def glGetPolygonStipple(m: Machine) -> bytes:
    return np.array(m.polygon_stipple.rows, ">u4").tobytes()
