"""glBegin, glEnd, glRect and the current values that are not in immediate.py: sections 2.6, 2.7 and 2.10."""

from __future__ import annotations

from glsim.gl.immediate import row
from glsim.gl.texenv import unit_number
from glsim.machine.assembly import MINIMUM
from glsim.machine.constants import GL_POLYGON
from glsim.machine.errors import invalid_enum, invalid_operation
from glsim.machine.machine import Machine


def glBegin(m: Machine, mode: int) -> None:
    if m.inside is not None:
        raise invalid_operation("the glBegin before has no glEnd yet")
    if mode not in MINIMUM:
        raise invalid_enum("mode", mode, "one of the ten primitives GL_POINTS to GL_POLYGON")
    m.begin(mode)


def glEnd(m: Machine) -> None:
    m.end()


def glRect(m: Machine, x1: float, y1: float, x2: float, y2: float) -> None:
    rest = (0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha)
    rows = [row(x, y, *rest) for x, y in ((x1, y1), (x2, y1), (x2, y2), (x1, y2))]
    m.begin(GL_POLYGON)
    m.write(b"".join(rows))
    m.end()


def glSecondaryColor(m: Machine, red: float, green: float, blue: float) -> None:
    m.set_current("secondary_color", (float(red), float(green), float(blue), 1.0))


def glMultiTexCoord(m: Machine, target: int, s: float, t: float = 0.0, r: float = 0.0, q: float = 1.0) -> None:
    m.set_current(f"texcoord{unit_number(target, 'target')}", (float(s), float(t), float(r), float(q)))


def glFogCoord(m: Machine, coord: float) -> None:
    m.set_current("fog_coord", (float(coord),))


def glIndex(m: Machine, c: float) -> None:
    m.index = float(c)


def glEdgeFlag(m: Machine, flag: bool) -> None:
    m.set_current("edge_flag", (float(bool(flag)),))


def glEdgeFlagv(m: Machine, flag: object) -> None:
    glEdgeFlag(m, flag[0] if hasattr(flag, "__getitem__") else bool(flag))
