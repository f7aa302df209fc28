"""The commands that are called once a vertex.  Written by ``python -m glsim.gl.generate``; do not edit.

A vertex is a row of ten numbers: its position beside the current normal and colour.
"""

from __future__ import annotations

from collections.abc import Sequence
from struct import Struct
from typing import Any

from glsim.gl.arguments import retry
from glsim.machine.current import attach
from glsim.machine.sentences import MISUSE as BAD

row = Struct("10f").pack
Numbers = Sequence[Any]
current: Any  # the machine; see glsim/machine/current.py
attach(globals())


def _first(v: Any) -> Any:
    return v[0] if hasattr(v, "__getitem__") else v


def glVertex2s(x: int, y: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex2s", (x, y) if surplus is None else (x, y, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex2s", (x, y))


def glVertex2sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex2sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y = v
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex2sv", (v,))


def glVertex2i(x: int, y: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex2i", (x, y) if surplus is None else (x, y, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex2i", (x, y))


def glVertex2iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex2iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y = v
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex2iv", (v,))


def glVertex2f(x: float, y: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex2f", (x, y) if surplus is None else (x, y, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex2f", (x, y))


def glVertex2fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex2fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y = v
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex2fv", (v,))


def glVertex2d(x: float, y: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex2d", (x, y) if surplus is None else (x, y, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex2d", (x, y))


def glVertex2dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex2dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y = v
        m.write(row(x, y, 0.0, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex2dv", (v,))


def glVertex3s(x: int, y: int, z: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex3s", (x, y, z) if surplus is None else (x, y, z, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex3s", (x, y, z))


def glVertex3sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex3sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y, z = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex3sv", (v,))


def glVertex3i(x: int, y: int, z: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex3i", (x, y, z) if surplus is None else (x, y, z, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex3i", (x, y, z))


def glVertex3iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex3iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y, z = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex3iv", (v,))


def glVertex3f(x: float, y: float, z: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex3f", (x, y, z) if surplus is None else (x, y, z, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex3f", (x, y, z))


def glVertex3fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex3fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y, z = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex3fv", (v,))


def glVertex3d(x: float, y: float, z: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex3d", (x, y, z) if surplus is None else (x, y, z, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex3d", (x, y, z))


def glVertex3dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex3dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y, z = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
    except BAD as error:
        retry(error, "glVertex3dv", (v,))


def glVertex4s(x: int, y: int, z: int, w: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex4s", (x, y, z, w) if surplus is None else (x, y, z, w, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except BAD as error:
        retry(error, "glVertex4s", (x, y, z, w))


def glVertex4sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex4sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y, z, w = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except BAD as error:
        retry(error, "glVertex4sv", (v,))


def glVertex4i(x: int, y: int, z: int, w: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex4i", (x, y, z, w) if surplus is None else (x, y, z, w, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except BAD as error:
        retry(error, "glVertex4i", (x, y, z, w))


def glVertex4iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex4iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y, z, w = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except BAD as error:
        retry(error, "glVertex4iv", (v,))


def glVertex4f(x: float, y: float, z: float, w: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex4f", (x, y, z, w) if surplus is None else (x, y, z, w, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except BAD as error:
        retry(error, "glVertex4f", (x, y, z, w))


def glVertex4fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex4fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y, z, w = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except BAD as error:
        retry(error, "glVertex4fv", (v,))


def glVertex4d(x: float, y: float, z: float, w: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex4d", (x, y, z, w) if surplus is None else (x, y, z, w, surplus))  # type: ignore[no-any-return]
    try:
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except BAD as error:
        retry(error, "glVertex4d", (x, y, z, w))


def glVertex4dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glVertex4dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        x, y, z, w = v
        m.write(row(x, y, z, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))
        if w != 1.0 and m.inside is not None:
            m.columns.append(("w", m.stream.tell() // 40 - 1, w))
    except BAD as error:
        retry(error, "glVertex4dv", (v,))


def glNormal3b(nx: int, ny: int, nz: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3b", (nx, ny, nz) if surplus is None else (nx, ny, nz, surplus))  # type: ignore[no-any-return]
    try:
        m.nx = (2 * nx + 1) / 255.0
        m.ny = (2 * ny + 1) / 255.0
        m.nz = (2 * nz + 1) / 255.0
    except BAD as error:
        retry(error, "glNormal3b", (nx, ny, nz))


def glNormal3bv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3bv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = (2 * nx + 1) / 255.0
        m.ny = (2 * ny + 1) / 255.0
        m.nz = (2 * nz + 1) / 255.0
    except BAD as error:
        retry(error, "glNormal3bv", (v,))


def glNormal3s(nx: int, ny: int, nz: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3s", (nx, ny, nz) if surplus is None else (nx, ny, nz, surplus))  # type: ignore[no-any-return]
    try:
        m.nx = (2 * nx + 1) / 65535.0
        m.ny = (2 * ny + 1) / 65535.0
        m.nz = (2 * nz + 1) / 65535.0
    except BAD as error:
        retry(error, "glNormal3s", (nx, ny, nz))


def glNormal3sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = (2 * nx + 1) / 65535.0
        m.ny = (2 * ny + 1) / 65535.0
        m.nz = (2 * nz + 1) / 65535.0
    except BAD as error:
        retry(error, "glNormal3sv", (v,))


def glNormal3i(nx: int, ny: int, nz: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3i", (nx, ny, nz) if surplus is None else (nx, ny, nz, surplus))  # type: ignore[no-any-return]
    try:
        m.nx = (2 * nx + 1) / 4294967295.0
        m.ny = (2 * ny + 1) / 4294967295.0
        m.nz = (2 * nz + 1) / 4294967295.0
    except BAD as error:
        retry(error, "glNormal3i", (nx, ny, nz))


def glNormal3iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = (2 * nx + 1) / 4294967295.0
        m.ny = (2 * ny + 1) / 4294967295.0
        m.nz = (2 * nz + 1) / 4294967295.0
    except BAD as error:
        retry(error, "glNormal3iv", (v,))


def glNormal3f(nx: float, ny: float, nz: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3f", (nx, ny, nz) if surplus is None else (nx, ny, nz, surplus))  # type: ignore[no-any-return]
    try:
        m.nx = nx
        m.ny = ny
        m.nz = nz
    except BAD as error:
        retry(error, "glNormal3f", (nx, ny, nz))


def glNormal3fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = nx
        m.ny = ny
        m.nz = nz
    except BAD as error:
        retry(error, "glNormal3fv", (v,))


def glNormal3d(nx: float, ny: float, nz: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3d", (nx, ny, nz) if surplus is None else (nx, ny, nz, surplus))  # type: ignore[no-any-return]
    try:
        m.nx = nx
        m.ny = ny
        m.nz = nz
    except BAD as error:
        retry(error, "glNormal3d", (nx, ny, nz))


def glNormal3dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glNormal3dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        nx, ny, nz = v
        m.nx = nx
        m.ny = ny
        m.nz = nz
    except BAD as error:
        retry(error, "glNormal3dv", (v,))


def glColor3b(red: int, green: int, blue: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3b", (red, green, blue) if surplus is None else (red, green, blue, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 255.0
        m.green = (2 * green + 1) / 255.0
        m.blue = (2 * blue + 1) / 255.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3b", (red, green, blue))


def glColor3bv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3bv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (2 * red + 1) / 255.0
        m.green = (2 * green + 1) / 255.0
        m.blue = (2 * blue + 1) / 255.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3bv", (v,))


def glColor3s(red: int, green: int, blue: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3s", (red, green, blue) if surplus is None else (red, green, blue, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 65535.0
        m.green = (2 * green + 1) / 65535.0
        m.blue = (2 * blue + 1) / 65535.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3s", (red, green, blue))


def glColor3sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (2 * red + 1) / 65535.0
        m.green = (2 * green + 1) / 65535.0
        m.blue = (2 * blue + 1) / 65535.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3sv", (v,))


def glColor3i(red: int, green: int, blue: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3i", (red, green, blue) if surplus is None else (red, green, blue, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 4294967295.0
        m.green = (2 * green + 1) / 4294967295.0
        m.blue = (2 * blue + 1) / 4294967295.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3i", (red, green, blue))


def glColor3iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (2 * red + 1) / 4294967295.0
        m.green = (2 * green + 1) / 4294967295.0
        m.blue = (2 * blue + 1) / 4294967295.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3iv", (v,))


def glColor3f(red: float, green: float, blue: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3f", (red, green, blue) if surplus is None else (red, green, blue, surplus))  # type: ignore[no-any-return]
    try:
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3f", (red, green, blue))


def glColor3fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3fv", (v,))


def glColor3d(red: float, green: float, blue: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3d", (red, green, blue) if surplus is None else (red, green, blue, surplus))  # type: ignore[no-any-return]
    try:
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3d", (red, green, blue))


def glColor3dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3dv", (v,))


def glColor3ub(red: int, green: int, blue: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3ub", (red, green, blue) if surplus is None else (red, green, blue, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (red & 255) / 255.0
        m.green = (green & 255) / 255.0
        m.blue = (blue & 255) / 255.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3ub", (red, green, blue))


def glColor3ubv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3ubv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (red & 255) / 255.0
        m.green = (green & 255) / 255.0
        m.blue = (blue & 255) / 255.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3ubv", (v,))


def glColor3us(red: int, green: int, blue: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3us", (red, green, blue) if surplus is None else (red, green, blue, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (red & 65535) / 65535.0
        m.green = (green & 65535) / 65535.0
        m.blue = (blue & 65535) / 65535.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3us", (red, green, blue))


def glColor3usv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3usv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (red & 65535) / 65535.0
        m.green = (green & 65535) / 65535.0
        m.blue = (blue & 65535) / 65535.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3usv", (v,))


def glColor3ui(red: int, green: int, blue: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3ui", (red, green, blue) if surplus is None else (red, green, blue, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (red & 4294967295) / 4294967295.0
        m.green = (green & 4294967295) / 4294967295.0
        m.blue = (blue & 4294967295) / 4294967295.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3ui", (red, green, blue))


def glColor3uiv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor3uiv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue = v
        m.red = (red & 4294967295) / 4294967295.0
        m.green = (green & 4294967295) / 4294967295.0
        m.blue = (blue & 4294967295) / 4294967295.0
        m.alpha = 1.0
    except BAD as error:
        retry(error, "glColor3uiv", (v,))


def glColor4b(red: int, green: int, blue: int, alpha: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4b", (red, green, blue, alpha) if surplus is None else (red, green, blue, alpha, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 255.0
        m.green = (2 * green + 1) / 255.0
        m.blue = (2 * blue + 1) / 255.0
        m.alpha = (2 * alpha + 1) / 255.0
    except BAD as error:
        retry(error, "glColor4b", (red, green, blue, alpha))


def glColor4bv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4bv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (2 * red + 1) / 255.0
        m.green = (2 * green + 1) / 255.0
        m.blue = (2 * blue + 1) / 255.0
        m.alpha = (2 * alpha + 1) / 255.0
    except BAD as error:
        retry(error, "glColor4bv", (v,))


def glColor4s(red: int, green: int, blue: int, alpha: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4s", (red, green, blue, alpha) if surplus is None else (red, green, blue, alpha, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 65535.0
        m.green = (2 * green + 1) / 65535.0
        m.blue = (2 * blue + 1) / 65535.0
        m.alpha = (2 * alpha + 1) / 65535.0
    except BAD as error:
        retry(error, "glColor4s", (red, green, blue, alpha))


def glColor4sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (2 * red + 1) / 65535.0
        m.green = (2 * green + 1) / 65535.0
        m.blue = (2 * blue + 1) / 65535.0
        m.alpha = (2 * alpha + 1) / 65535.0
    except BAD as error:
        retry(error, "glColor4sv", (v,))


def glColor4i(red: int, green: int, blue: int, alpha: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4i", (red, green, blue, alpha) if surplus is None else (red, green, blue, alpha, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (2 * red + 1) / 4294967295.0
        m.green = (2 * green + 1) / 4294967295.0
        m.blue = (2 * blue + 1) / 4294967295.0
        m.alpha = (2 * alpha + 1) / 4294967295.0
    except BAD as error:
        retry(error, "glColor4i", (red, green, blue, alpha))


def glColor4iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (2 * red + 1) / 4294967295.0
        m.green = (2 * green + 1) / 4294967295.0
        m.blue = (2 * blue + 1) / 4294967295.0
        m.alpha = (2 * alpha + 1) / 4294967295.0
    except BAD as error:
        retry(error, "glColor4iv", (v,))


def glColor4f(red: float, green: float, blue: float, alpha: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4f", (red, green, blue, alpha) if surplus is None else (red, green, blue, alpha, surplus))  # type: ignore[no-any-return]
    try:
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = alpha
    except BAD as error:
        retry(error, "glColor4f", (red, green, blue, alpha))


def glColor4fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = alpha
    except BAD as error:
        retry(error, "glColor4fv", (v,))


def glColor4d(red: float, green: float, blue: float, alpha: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4d", (red, green, blue, alpha) if surplus is None else (red, green, blue, alpha, surplus))  # type: ignore[no-any-return]
    try:
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = alpha
    except BAD as error:
        retry(error, "glColor4d", (red, green, blue, alpha))


def glColor4dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = red
        m.green = green
        m.blue = blue
        m.alpha = alpha
    except BAD as error:
        retry(error, "glColor4dv", (v,))


def glColor4ub(red: int, green: int, blue: int, alpha: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4ub", (red, green, blue, alpha) if surplus is None else (red, green, blue, alpha, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (red & 255) / 255.0
        m.green = (green & 255) / 255.0
        m.blue = (blue & 255) / 255.0
        m.alpha = (alpha & 255) / 255.0
    except BAD as error:
        retry(error, "glColor4ub", (red, green, blue, alpha))


def glColor4ubv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4ubv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (red & 255) / 255.0
        m.green = (green & 255) / 255.0
        m.blue = (blue & 255) / 255.0
        m.alpha = (alpha & 255) / 255.0
    except BAD as error:
        retry(error, "glColor4ubv", (v,))


def glColor4us(red: int, green: int, blue: int, alpha: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4us", (red, green, blue, alpha) if surplus is None else (red, green, blue, alpha, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (red & 65535) / 65535.0
        m.green = (green & 65535) / 65535.0
        m.blue = (blue & 65535) / 65535.0
        m.alpha = (alpha & 65535) / 65535.0
    except BAD as error:
        retry(error, "glColor4us", (red, green, blue, alpha))


def glColor4usv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4usv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (red & 65535) / 65535.0
        m.green = (green & 65535) / 65535.0
        m.blue = (blue & 65535) / 65535.0
        m.alpha = (alpha & 65535) / 65535.0
    except BAD as error:
        retry(error, "glColor4usv", (v,))


def glColor4ui(red: int, green: int, blue: int, alpha: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4ui", (red, green, blue, alpha) if surplus is None else (red, green, blue, alpha, surplus))  # type: ignore[no-any-return]
    try:
        m.red = (red & 4294967295) / 4294967295.0
        m.green = (green & 4294967295) / 4294967295.0
        m.blue = (blue & 4294967295) / 4294967295.0
        m.alpha = (alpha & 4294967295) / 4294967295.0
    except BAD as error:
        retry(error, "glColor4ui", (red, green, blue, alpha))


def glColor4uiv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glColor4uiv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        red, green, blue, alpha = v
        m.red = (red & 4294967295) / 4294967295.0
        m.green = (green & 4294967295) / 4294967295.0
        m.blue = (blue & 4294967295) / 4294967295.0
        m.alpha = (alpha & 4294967295) / 4294967295.0
    except BAD as error:
        retry(error, "glColor4uiv", (v,))


def glTexCoord1s(s: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord1s", (s,) if surplus is None else (s, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord1s", (s,))


def glTexCoord1sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord1sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s = _first(v)
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord1sv", (v,))


def glTexCoord1i(s: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord1i", (s,) if surplus is None else (s, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord1i", (s,))


def glTexCoord1iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord1iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s = _first(v)
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord1iv", (v,))


def glTexCoord1f(s: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord1f", (s,) if surplus is None else (s, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord1f", (s,))


def glTexCoord1fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord1fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s = _first(v)
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord1fv", (v,))


def glTexCoord1d(s: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord1d", (s,) if surplus is None else (s, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord1d", (s,))


def glTexCoord1dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord1dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s = _first(v)
        m.texcoord.append((m.stream.tell(), (s + 0.0, 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord1dv", (v,))


def glTexCoord2s(s: int, t: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord2s", (s, t) if surplus is None else (s, t, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord2s", (s, t))


def glTexCoord2sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord2sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord2sv", (v,))


def glTexCoord2i(s: int, t: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord2i", (s, t) if surplus is None else (s, t, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord2i", (s, t))


def glTexCoord2iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord2iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord2iv", (v,))


def glTexCoord2f(s: float, t: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord2f", (s, t) if surplus is None else (s, t, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord2f", (s, t))


def glTexCoord2fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord2fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord2fv", (v,))


def glTexCoord2d(s: float, t: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord2d", (s, t) if surplus is None else (s, t, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord2d", (s, t))


def glTexCoord2dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord2dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord2dv", (v,))


def glTexCoord3s(s: int, t: int, r: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord3s", (s, t, r) if surplus is None else (s, t, r, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord3s", (s, t, r))


def glTexCoord3sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord3sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t, r = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord3sv", (v,))


def glTexCoord3i(s: int, t: int, r: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord3i", (s, t, r) if surplus is None else (s, t, r, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord3i", (s, t, r))


def glTexCoord3iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord3iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t, r = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord3iv", (v,))


def glTexCoord3f(s: float, t: float, r: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord3f", (s, t, r) if surplus is None else (s, t, r, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord3f", (s, t, r))


def glTexCoord3fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord3fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t, r = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord3fv", (v,))


def glTexCoord3d(s: float, t: float, r: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord3d", (s, t, r) if surplus is None else (s, t, r, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord3d", (s, t, r))


def glTexCoord3dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord3dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t, r = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, 1.0)))
    except BAD as error:
        retry(error, "glTexCoord3dv", (v,))


def glTexCoord4s(s: int, t: int, r: int, q: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord4s", (s, t, r, q) if surplus is None else (s, t, r, q, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except BAD as error:
        retry(error, "glTexCoord4s", (s, t, r, q))


def glTexCoord4sv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord4sv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t, r, q = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except BAD as error:
        retry(error, "glTexCoord4sv", (v,))


def glTexCoord4i(s: int, t: int, r: int, q: int, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord4i", (s, t, r, q) if surplus is None else (s, t, r, q, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except BAD as error:
        retry(error, "glTexCoord4i", (s, t, r, q))


def glTexCoord4iv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord4iv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t, r, q = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except BAD as error:
        retry(error, "glTexCoord4iv", (v,))


def glTexCoord4f(s: float, t: float, r: float, q: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord4f", (s, t, r, q) if surplus is None else (s, t, r, q, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except BAD as error:
        retry(error, "glTexCoord4f", (s, t, r, q))


def glTexCoord4fv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord4fv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t, r, q = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except BAD as error:
        retry(error, "glTexCoord4fv", (v,))


def glTexCoord4d(s: float, t: float, r: float, q: float, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord4d", (s, t, r, q) if surplus is None else (s, t, r, q, surplus))  # type: ignore[no-any-return]
    try:
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except BAD as error:
        retry(error, "glTexCoord4d", (s, t, r, q))


def glTexCoord4dv(v: Numbers, surplus: Any = None) -> None:
    m = current
    if m.recorder:
        return m.recorder("glTexCoord4dv", (v,) if surplus is None else (v, surplus))  # type: ignore[no-any-return]
    try:
        s, t, r, q = v
        m.texcoord.append((m.stream.tell(), (s + 0.0, t + 0.0, r + 0.0, q + 0.0)))
    except BAD as error:
        retry(error, "glTexCoord4dv", (v,))
