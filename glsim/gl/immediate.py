"""The commands that are called once a vertex.  Written by ``python -m glsim.machine.generate``; do not edit.

A vertex is a row of ten numbers: its position beside the current normal and colour.
"""

from __future__ import annotations

from collections.abc import Sequence
from struct import Struct
from struct import error as struct_error
from typing import Any

from glsim.machine.current import on_switch
from glsim.machine.errors import explain

row = Struct("10f").pack
Numbers = Sequence[Any]
m: Any


def _switch(machine: Any) -> None:
    global m
    m = machine


on_switch(_switch)


def _misuse(name: str, arguments: tuple[Any, ...], error: Exception) -> Exception:
    """The sentence for a number that is none: an argument, or the current normal or colour."""
    if isinstance(error, struct_error):
        for what, value in (("normal", (m.nx, m.ny, m.nz)), ("color", (m.red, m.green, m.blue, m.alpha))):
            try:
                Struct(f"{len(value)}f").pack(*value)
            except struct_error:
                return TypeError(f"{name}: the current {what} (gl{what.title()}) is not made of numbers: {value!r}")
    return explain(error, name, arguments)


def _first(v: Any) -> Any:
    return v[0] if hasattr(v, "__getitem__") else v


def glVertex2s(x: int, y: int) -> None:
    if m.recorder:
        return m.recorder("glVertex2s", (x, y))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex2s", (x, y), error) from None


def glVertex2sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex2sv", (v,))  # type: ignore[no-any-return]
    try:
        x, y = v
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex2sv", (v,), error) from None


def glVertex2i(x: int, y: int) -> None:
    if m.recorder:
        return m.recorder("glVertex2i", (x, y))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex2i", (x, y), error) from None


def glVertex2iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex2iv", (v,))  # type: ignore[no-any-return]
    try:
        x, y = v
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex2iv", (v,), error) from None


def glVertex2f(x: float, y: float) -> None:
    if m.recorder:
        return m.recorder("glVertex2f", (x, y))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex2f", (x, y), error) from None


def glVertex2fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex2fv", (v,))  # type: ignore[no-any-return]
    try:
        x, y = v
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex2fv", (v,), error) from None


def glVertex2d(x: float, y: float) -> None:
    if m.recorder:
        return m.recorder("glVertex2d", (x, y))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex2d", (x, y), error) from None


def glVertex2dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex2dv", (v,))  # type: ignore[no-any-return]
    try:
        x, y = v
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex2dv", (v,), error) from None


def glVertex3s(x: int, y: int, z: int) -> None:
    if m.recorder:
        return m.recorder("glVertex3s", (x, y, z))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex3s", (x, y, z), error) from None


def glVertex3sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex3sv", (v,))  # type: ignore[no-any-return]
    try:
        x, y, z = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex3sv", (v,), error) from None


def glVertex3i(x: int, y: int, z: int) -> None:
    if m.recorder:
        return m.recorder("glVertex3i", (x, y, z))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex3i", (x, y, z), error) from None


def glVertex3iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex3iv", (v,))  # type: ignore[no-any-return]
    try:
        x, y, z = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex3iv", (v,), error) from None


def glVertex3f(x: float, y: float, z: float) -> None:
    if m.recorder:
        return m.recorder("glVertex3f", (x, y, z))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex3f", (x, y, z), error) from None


def glVertex3fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex3fv", (v,))  # type: ignore[no-any-return]
    try:
        x, y, z = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex3fv", (v,), error) from None


def glVertex3d(x: float, y: float, z: float) -> None:
    if m.recorder:
        return m.recorder("glVertex3d", (x, y, z))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex3d", (x, y, z), error) from None


def glVertex3dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex3dv", (v,))  # type: ignore[no-any-return]
    try:
        x, y, z = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except Exception as error:
        raise _misuse("glVertex3dv", (v,), error) from None


def glVertex4s(x: int, y: int, z: int, w: int) -> None:
    if m.recorder:
        return m.recorder("glVertex4s", (x, y, z, w))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except Exception as error:
        raise _misuse("glVertex4s", (x, y, z, w), error) from None


def glVertex4sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex4sv", (v,))  # type: ignore[no-any-return]
    try:
        x, y, z, w = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except Exception as error:
        raise _misuse("glVertex4sv", (v,), error) from None


def glVertex4i(x: int, y: int, z: int, w: int) -> None:
    if m.recorder:
        return m.recorder("glVertex4i", (x, y, z, w))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except Exception as error:
        raise _misuse("glVertex4i", (x, y, z, w), error) from None


def glVertex4iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex4iv", (v,))  # type: ignore[no-any-return]
    try:
        x, y, z, w = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except Exception as error:
        raise _misuse("glVertex4iv", (v,), error) from None


def glVertex4f(x: float, y: float, z: float, w: float) -> None:
    if m.recorder:
        return m.recorder("glVertex4f", (x, y, z, w))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except Exception as error:
        raise _misuse("glVertex4f", (x, y, z, w), error) from None


def glVertex4fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex4fv", (v,))  # type: ignore[no-any-return]
    try:
        x, y, z, w = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except Exception as error:
        raise _misuse("glVertex4fv", (v,), error) from None


def glVertex4d(x: float, y: float, z: float, w: float) -> None:
    if m.recorder:
        return m.recorder("glVertex4d", (x, y, z, w))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except Exception as error:
        raise _misuse("glVertex4d", (x, y, z, w), error) from None


def glVertex4dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glVertex4dv", (v,))  # type: ignore[no-any-return]
    try:
        x, y, z, w = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except Exception as error:
        raise _misuse("glVertex4dv", (v,), error) from None


def glNormal3b(nx: int, ny: int, nz: int) -> None:
    if m.recorder:
        return m.recorder("glNormal3b", (nx, ny, nz))  # type: ignore[no-any-return]
    try:
        m.nx = (2 * nx + 1) / 255.0
        m.ny = (2 * ny + 1) / 255.0
        m.nz = (2 * nz + 1) / 255.0
    except Exception as error:
        raise _misuse("glNormal3b", (nx, ny, nz), error) from None


def glNormal3bv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glNormal3bv", (v,))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = (2 * nx + 1) / 255.0
        m.ny = (2 * ny + 1) / 255.0
        m.nz = (2 * nz + 1) / 255.0
    except Exception as error:
        raise _misuse("glNormal3bv", (v,), error) from None


def glNormal3s(nx: int, ny: int, nz: int) -> None:
    if m.recorder:
        return m.recorder("glNormal3s", (nx, ny, nz))  # type: ignore[no-any-return]
    try:
        m.nx = (2 * nx + 1) / 65535.0
        m.ny = (2 * ny + 1) / 65535.0
        m.nz = (2 * nz + 1) / 65535.0
    except Exception as error:
        raise _misuse("glNormal3s", (nx, ny, nz), error) from None


def glNormal3sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glNormal3sv", (v,))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = (2 * nx + 1) / 65535.0
        m.ny = (2 * ny + 1) / 65535.0
        m.nz = (2 * nz + 1) / 65535.0
    except Exception as error:
        raise _misuse("glNormal3sv", (v,), error) from None


def glNormal3i(nx: int, ny: int, nz: int) -> None:
    if m.recorder:
        return m.recorder("glNormal3i", (nx, ny, nz))  # type: ignore[no-any-return]
    try:
        m.nx = (2 * nx + 1) / 4294967295.0
        m.ny = (2 * ny + 1) / 4294967295.0
        m.nz = (2 * nz + 1) / 4294967295.0
    except Exception as error:
        raise _misuse("glNormal3i", (nx, ny, nz), error) from None


def glNormal3iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glNormal3iv", (v,))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = (2 * nx + 1) / 4294967295.0
        m.ny = (2 * ny + 1) / 4294967295.0
        m.nz = (2 * nz + 1) / 4294967295.0
    except Exception as error:
        raise _misuse("glNormal3iv", (v,), error) from None


def glNormal3f(nx: float, ny: float, nz: float) -> None:
    if m.recorder:
        return m.recorder("glNormal3f", (nx, ny, nz))  # type: ignore[no-any-return]
    try:
        m.nx = nx
        m.ny = ny
        m.nz = nz
    except Exception as error:
        raise _misuse("glNormal3f", (nx, ny, nz), error) from None


def glNormal3fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glNormal3fv", (v,))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = nx
        m.ny = ny
        m.nz = nz
    except Exception as error:
        raise _misuse("glNormal3fv", (v,), error) from None


def glNormal3d(nx: float, ny: float, nz: float) -> None:
    if m.recorder:
        return m.recorder("glNormal3d", (nx, ny, nz))  # type: ignore[no-any-return]
    try:
        m.nx = nx
        m.ny = ny
        m.nz = nz
    except Exception as error:
        raise _misuse("glNormal3d", (nx, ny, nz), error) from None


def glNormal3dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glNormal3dv", (v,))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = nx
        m.ny = ny
        m.nz = nz
    except Exception as error:
        raise _misuse("glNormal3dv", (v,), error) from None


def glColor3b(red: int, green: int, blue: int) -> None:
    if m.recorder:
        return m.recorder("glColor3b", (red, green, blue))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 255.0
        m.green = (2 * green + 1) / 255.0
        m.blue = (2 * blue + 1) / 255.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3b", (red, green, blue), error) from None


def glColor3bv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor3bv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (2 * red + 1) / 255.0
        m.green = (2 * green + 1) / 255.0
        m.blue = (2 * blue + 1) / 255.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3bv", (v,), error) from None


def glColor3s(red: int, green: int, blue: int) -> None:
    if m.recorder:
        return m.recorder("glColor3s", (red, green, blue))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 65535.0
        m.green = (2 * green + 1) / 65535.0
        m.blue = (2 * blue + 1) / 65535.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3s", (red, green, blue), error) from None


def glColor3sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor3sv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (2 * red + 1) / 65535.0
        m.green = (2 * green + 1) / 65535.0
        m.blue = (2 * blue + 1) / 65535.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3sv", (v,), error) from None


def glColor3i(red: int, green: int, blue: int) -> None:
    if m.recorder:
        return m.recorder("glColor3i", (red, green, blue))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 4294967295.0
        m.green = (2 * green + 1) / 4294967295.0
        m.blue = (2 * blue + 1) / 4294967295.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3i", (red, green, blue), error) from None


def glColor3iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor3iv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (2 * red + 1) / 4294967295.0
        m.green = (2 * green + 1) / 4294967295.0
        m.blue = (2 * blue + 1) / 4294967295.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3iv", (v,), error) from None


def glColor3f(red: float, green: float, blue: float) -> None:
    if m.recorder:
        return m.recorder("glColor3f", (red, green, blue))  # type: ignore[no-any-return]
    try:
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3f", (red, green, blue), error) from None


def glColor3fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor3fv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3fv", (v,), error) from None


def glColor3d(red: float, green: float, blue: float) -> None:
    if m.recorder:
        return m.recorder("glColor3d", (red, green, blue))  # type: ignore[no-any-return]
    try:
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3d", (red, green, blue), error) from None


def glColor3dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor3dv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3dv", (v,), error) from None


def glColor3ub(red: int, green: int, blue: int) -> None:
    if m.recorder:
        return m.recorder("glColor3ub", (red, green, blue))  # type: ignore[no-any-return]
    try:
        m.red = (red & 255) / 255.0
        m.green = (green & 255) / 255.0
        m.blue = (blue & 255) / 255.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3ub", (red, green, blue), error) from None


def glColor3ubv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor3ubv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (red & 255) / 255.0
        m.green = (green & 255) / 255.0
        m.blue = (blue & 255) / 255.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3ubv", (v,), error) from None


def glColor3us(red: int, green: int, blue: int) -> None:
    if m.recorder:
        return m.recorder("glColor3us", (red, green, blue))  # type: ignore[no-any-return]
    try:
        m.red = (red & 65535) / 65535.0
        m.green = (green & 65535) / 65535.0
        m.blue = (blue & 65535) / 65535.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3us", (red, green, blue), error) from None


def glColor3usv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor3usv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (red & 65535) / 65535.0
        m.green = (green & 65535) / 65535.0
        m.blue = (blue & 65535) / 65535.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3usv", (v,), error) from None


def glColor3ui(red: int, green: int, blue: int) -> None:
    if m.recorder:
        return m.recorder("glColor3ui", (red, green, blue))  # type: ignore[no-any-return]
    try:
        m.red = (red & 4294967295) / 4294967295.0
        m.green = (green & 4294967295) / 4294967295.0
        m.blue = (blue & 4294967295) / 4294967295.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3ui", (red, green, blue), error) from None


def glColor3uiv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor3uiv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (red & 4294967295) / 4294967295.0
        m.green = (green & 4294967295) / 4294967295.0
        m.blue = (blue & 4294967295) / 4294967295.0
        m.alpha = 1.0
    except Exception as error:
        raise _misuse("glColor3uiv", (v,), error) from None


def glColor4b(red: int, green: int, blue: int, alpha: int) -> None:
    if m.recorder:
        return m.recorder("glColor4b", (red, green, blue, alpha))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 255.0
        m.green = (2 * green + 1) / 255.0
        m.blue = (2 * blue + 1) / 255.0
        m.alpha = (2 * alpha + 1) / 255.0
    except Exception as error:
        raise _misuse("glColor4b", (red, green, blue, alpha), error) from None


def glColor4bv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor4bv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (2 * red + 1) / 255.0
        m.green = (2 * green + 1) / 255.0
        m.blue = (2 * blue + 1) / 255.0
        m.alpha = (2 * alpha + 1) / 255.0
    except Exception as error:
        raise _misuse("glColor4bv", (v,), error) from None


def glColor4s(red: int, green: int, blue: int, alpha: int) -> None:
    if m.recorder:
        return m.recorder("glColor4s", (red, green, blue, alpha))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 65535.0
        m.green = (2 * green + 1) / 65535.0
        m.blue = (2 * blue + 1) / 65535.0
        m.alpha = (2 * alpha + 1) / 65535.0
    except Exception as error:
        raise _misuse("glColor4s", (red, green, blue, alpha), error) from None


def glColor4sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor4sv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (2 * red + 1) / 65535.0
        m.green = (2 * green + 1) / 65535.0
        m.blue = (2 * blue + 1) / 65535.0
        m.alpha = (2 * alpha + 1) / 65535.0
    except Exception as error:
        raise _misuse("glColor4sv", (v,), error) from None


def glColor4i(red: int, green: int, blue: int, alpha: int) -> None:
    if m.recorder:
        return m.recorder("glColor4i", (red, green, blue, alpha))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 4294967295.0
        m.green = (2 * green + 1) / 4294967295.0
        m.blue = (2 * blue + 1) / 4294967295.0
        m.alpha = (2 * alpha + 1) / 4294967295.0
    except Exception as error:
        raise _misuse("glColor4i", (red, green, blue, alpha), error) from None


def glColor4iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor4iv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (2 * red + 1) / 4294967295.0
        m.green = (2 * green + 1) / 4294967295.0
        m.blue = (2 * blue + 1) / 4294967295.0
        m.alpha = (2 * alpha + 1) / 4294967295.0
    except Exception as error:
        raise _misuse("glColor4iv", (v,), error) from None


def glColor4f(red: float, green: float, blue: float, alpha: float) -> None:
    if m.recorder:
        return m.recorder("glColor4f", (red, green, blue, alpha))  # type: ignore[no-any-return]
    try:
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = alpha
    except Exception as error:
        raise _misuse("glColor4f", (red, green, blue, alpha), error) from None


def glColor4fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor4fv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = alpha
    except Exception as error:
        raise _misuse("glColor4fv", (v,), error) from None


def glColor4d(red: float, green: float, blue: float, alpha: float) -> None:
    if m.recorder:
        return m.recorder("glColor4d", (red, green, blue, alpha))  # type: ignore[no-any-return]
    try:
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = alpha
    except Exception as error:
        raise _misuse("glColor4d", (red, green, blue, alpha), error) from None


def glColor4dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor4dv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = alpha
    except Exception as error:
        raise _misuse("glColor4dv", (v,), error) from None


def glColor4ub(red: int, green: int, blue: int, alpha: int) -> None:
    if m.recorder:
        return m.recorder("glColor4ub", (red, green, blue, alpha))  # type: ignore[no-any-return]
    try:
        m.red = (red & 255) / 255.0
        m.green = (green & 255) / 255.0
        m.blue = (blue & 255) / 255.0
        m.alpha = (alpha & 255) / 255.0
    except Exception as error:
        raise _misuse("glColor4ub", (red, green, blue, alpha), error) from None


def glColor4ubv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor4ubv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (red & 255) / 255.0
        m.green = (green & 255) / 255.0
        m.blue = (blue & 255) / 255.0
        m.alpha = (alpha & 255) / 255.0
    except Exception as error:
        raise _misuse("glColor4ubv", (v,), error) from None


def glColor4us(red: int, green: int, blue: int, alpha: int) -> None:
    if m.recorder:
        return m.recorder("glColor4us", (red, green, blue, alpha))  # type: ignore[no-any-return]
    try:
        m.red = (red & 65535) / 65535.0
        m.green = (green & 65535) / 65535.0
        m.blue = (blue & 65535) / 65535.0
        m.alpha = (alpha & 65535) / 65535.0
    except Exception as error:
        raise _misuse("glColor4us", (red, green, blue, alpha), error) from None


def glColor4usv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor4usv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (red & 65535) / 65535.0
        m.green = (green & 65535) / 65535.0
        m.blue = (blue & 65535) / 65535.0
        m.alpha = (alpha & 65535) / 65535.0
    except Exception as error:
        raise _misuse("glColor4usv", (v,), error) from None


def glColor4ui(red: int, green: int, blue: int, alpha: int) -> None:
    if m.recorder:
        return m.recorder("glColor4ui", (red, green, blue, alpha))  # type: ignore[no-any-return]
    try:
        m.red = (red & 4294967295) / 4294967295.0
        m.green = (green & 4294967295) / 4294967295.0
        m.blue = (blue & 4294967295) / 4294967295.0
        m.alpha = (alpha & 4294967295) / 4294967295.0
    except Exception as error:
        raise _misuse("glColor4ui", (red, green, blue, alpha), error) from None


def glColor4uiv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glColor4uiv", (v,))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (red & 4294967295) / 4294967295.0
        m.green = (green & 4294967295) / 4294967295.0
        m.blue = (blue & 4294967295) / 4294967295.0
        m.alpha = (alpha & 4294967295) / 4294967295.0
    except Exception as error:
        raise _misuse("glColor4uiv", (v,), error) from None


def glTexCoord1s(s: int) -> None:
    if m.recorder:
        return m.recorder("glTexCoord1s", (s,))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord1s", (s,), error) from None


def glTexCoord1sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord1sv", (v,))  # type: ignore[no-any-return]
    try:
        s = _first(v)
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord1sv", (v,), error) from None


def glTexCoord1i(s: int) -> None:
    if m.recorder:
        return m.recorder("glTexCoord1i", (s,))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord1i", (s,), error) from None


def glTexCoord1iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord1iv", (v,))  # type: ignore[no-any-return]
    try:
        s = _first(v)
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord1iv", (v,), error) from None


def glTexCoord1f(s: float) -> None:
    if m.recorder:
        return m.recorder("glTexCoord1f", (s,))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord1f", (s,), error) from None


def glTexCoord1fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord1fv", (v,))  # type: ignore[no-any-return]
    try:
        s = _first(v)
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord1fv", (v,), error) from None


def glTexCoord1d(s: float) -> None:
    if m.recorder:
        return m.recorder("glTexCoord1d", (s,))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord1d", (s,), error) from None


def glTexCoord1dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord1dv", (v,))  # type: ignore[no-any-return]
    try:
        s = _first(v)
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord1dv", (v,), error) from None


def glTexCoord2s(s: int, t: int) -> None:
    if m.recorder:
        return m.recorder("glTexCoord2s", (s, t))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord2s", (s, t), error) from None


def glTexCoord2sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord2sv", (v,))  # type: ignore[no-any-return]
    try:
        s, t = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord2sv", (v,), error) from None


def glTexCoord2i(s: int, t: int) -> None:
    if m.recorder:
        return m.recorder("glTexCoord2i", (s, t))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord2i", (s, t), error) from None


def glTexCoord2iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord2iv", (v,))  # type: ignore[no-any-return]
    try:
        s, t = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord2iv", (v,), error) from None


def glTexCoord2f(s: float, t: float) -> None:
    if m.recorder:
        return m.recorder("glTexCoord2f", (s, t))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord2f", (s, t), error) from None


def glTexCoord2fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord2fv", (v,))  # type: ignore[no-any-return]
    try:
        s, t = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord2fv", (v,), error) from None


def glTexCoord2d(s: float, t: float) -> None:
    if m.recorder:
        return m.recorder("glTexCoord2d", (s, t))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord2d", (s, t), error) from None


def glTexCoord2dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord2dv", (v,))  # type: ignore[no-any-return]
    try:
        s, t = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord2dv", (v,), error) from None


def glTexCoord3s(s: int, t: int, r: int) -> None:
    if m.recorder:
        return m.recorder("glTexCoord3s", (s, t, r))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord3s", (s, t, r), error) from None


def glTexCoord3sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord3sv", (v,))  # type: ignore[no-any-return]
    try:
        s, t, r = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord3sv", (v,), error) from None


def glTexCoord3i(s: int, t: int, r: int) -> None:
    if m.recorder:
        return m.recorder("glTexCoord3i", (s, t, r))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord3i", (s, t, r), error) from None


def glTexCoord3iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord3iv", (v,))  # type: ignore[no-any-return]
    try:
        s, t, r = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord3iv", (v,), error) from None


def glTexCoord3f(s: float, t: float, r: float) -> None:
    if m.recorder:
        return m.recorder("glTexCoord3f", (s, t, r))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord3f", (s, t, r), error) from None


def glTexCoord3fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord3fv", (v,))  # type: ignore[no-any-return]
    try:
        s, t, r = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord3fv", (v,), error) from None


def glTexCoord3d(s: float, t: float, r: float) -> None:
    if m.recorder:
        return m.recorder("glTexCoord3d", (s, t, r))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord3d", (s, t, r), error) from None


def glTexCoord3dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord3dv", (v,))  # type: ignore[no-any-return]
    try:
        s, t, r = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except Exception as error:
        raise _misuse("glTexCoord3dv", (v,), error) from None


def glTexCoord4s(s: int, t: int, r: int, q: int) -> None:
    if m.recorder:
        return m.recorder("glTexCoord4s", (s, t, r, q))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except Exception as error:
        raise _misuse("glTexCoord4s", (s, t, r, q), error) from None


def glTexCoord4sv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord4sv", (v,))  # type: ignore[no-any-return]
    try:
        s, t, r, q = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except Exception as error:
        raise _misuse("glTexCoord4sv", (v,), error) from None


def glTexCoord4i(s: int, t: int, r: int, q: int) -> None:
    if m.recorder:
        return m.recorder("glTexCoord4i", (s, t, r, q))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except Exception as error:
        raise _misuse("glTexCoord4i", (s, t, r, q), error) from None


def glTexCoord4iv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord4iv", (v,))  # type: ignore[no-any-return]
    try:
        s, t, r, q = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except Exception as error:
        raise _misuse("glTexCoord4iv", (v,), error) from None


def glTexCoord4f(s: float, t: float, r: float, q: float) -> None:
    if m.recorder:
        return m.recorder("glTexCoord4f", (s, t, r, q))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except Exception as error:
        raise _misuse("glTexCoord4f", (s, t, r, q), error) from None


def glTexCoord4fv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord4fv", (v,))  # type: ignore[no-any-return]
    try:
        s, t, r, q = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except Exception as error:
        raise _misuse("glTexCoord4fv", (v,), error) from None


def glTexCoord4d(s: float, t: float, r: float, q: float) -> None:
    if m.recorder:
        return m.recorder("glTexCoord4d", (s, t, r, q))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except Exception as error:
        raise _misuse("glTexCoord4d", (s, t, r, q), error) from None


def glTexCoord4dv(v: Numbers) -> None:
    if m.recorder:
        return m.recorder("glTexCoord4dv", (v,))  # type: ignore[no-any-return]
    try:
        s, t, r, q = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except Exception as error:
        raise _misuse("glTexCoord4dv", (v,), error) from None
