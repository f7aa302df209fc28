"""Images of textures copied from the framebuffer: glCopyTexImage and glCopyTexSubImage (section 3.8.2)."""

from __future__ import annotations

from typing import Any

from glsim.gl.teximage import check_image, check_room, define, image_of, image_target, part_of, replace_part
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_value
from glsim.machine.machine import Machine
from glsim.machine.pixels import as_bytes, depths, transferred
from glsim.machine.texture import BASE_FORMATS, CUBE, Image, in_base_format


def _from_framebuffer(m: Machine, internalformat: int, x: int, y: int, width: int, height: int) -> Any:
    m.flush()
    base = BASE_FORMATS[internalformat]
    if base == gl.GL_DEPTH_COMPONENT:
        return depths(m.pixel, m.device.read(x, y, width, height, "depth")[..., None])
    rgba = as_bytes(transferred(m.pixel, m.device.read(x, y, width, height, "color")))
    return in_base_format(rgba, base, 255)


def _copy_image(
    m: Machine, kinds: tuple[int, ...], target: int, level: int, internalformat: int, border: int,
    x: int, y: int, width: int, height: int,
) -> None:  # fmt: skip
    kind, face = image_target(target, kinds)
    if internalformat in (1, 2, 3, 4):
        raise invalid_enum("internalformat", internalformat, "a named format such as GL_RGB")
    check_image(kind, level, internalformat, border, (width,) if kind == 1 else (height, width))
    check_room(kind, border, (width,) if kind == 1 else (height, width))
    inner = border if kind != 1 else 0
    rectangle = x + border, y + inner, width - 2 * border, height - 2 * inner
    define(m, kind, face, level, Image(_from_framebuffer(m, internalformat, *rectangle), internalformat))


def glCopyTexImage1D(
    m: Machine, target: int, level: int, internalformat: int, x: int, y: int, width: int, border: int
) -> None:
    _copy_image(m, (1,), target, level, internalformat, border, x, y, width, 1)


def glCopyTexImage2D(
    m: Machine, target: int, level: int, internalformat: int, x: int, y: int, width: int, height: int, border: int
) -> None:
    _copy_image(m, (2, CUBE), target, level, internalformat, border, x, y, width, height)


def _copy_sub_image(
    m: Machine, kinds: tuple[int, ...], target: int, level: int, offset: tuple[int, ...], x: int, y: int, width: int,
    height: int,
) -> None:  # fmt: skip
    kind, face = image_target(target, kinds)
    if width < 0 or height < 0:
        raise invalid_value("width and height", (width, height), "at least 0")
    image = image_of(m, kind, face, level)
    part = part_of(image, offset, (1, height, width) if kind == 3 else (height, width))
    texels = _from_framebuffer(m, image.internal_format, x, y, width, height)
    replace_part(m, kind, face, level, image, part, texels)


def glCopyTexSubImage1D(m: Machine, target: int, level: int, xoffset: int, x: int, y: int, width: int) -> None:
    _copy_sub_image(m, (1,), target, level, (0, xoffset), x, y, width, 1)


def glCopyTexSubImage2D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, x: int, y: int, width: int, height: int
) -> None:
    _copy_sub_image(m, (2, CUBE), target, level, (yoffset, xoffset), x, y, width, height)


def glCopyTexSubImage3D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, zoffset: int, x: int, y: int, width: int,
    height: int,
) -> None:  # fmt: skip
    _copy_sub_image(m, (3,), target, level, (zoffset, yoffset, xoffset), x, y, width, height)
