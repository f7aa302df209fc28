"""Images of textures: glTexImage and glTexSubImage write them (section 3.8.1).

texcopy.py copies them from the framebuffer, texread.py reads them back.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from glsim.gl.texture import bound, change
from glsim.machine import constants as gl
from glsim.machine.errors import GLError, invalid_enum, invalid_operation, invalid_value
from glsim.machine.machine import Machine
from glsim.machine.packing import check, unpack
from glsim.machine.pixels import COMPONENTS, as_bytes, colors, depths
from glsim.machine.texture import (
    BASE_FORMATS,
    CUBE,
    MAX_3D_TEXTURE_SIZE,
    MAX_TEXTURE_SIZE,
    Image,
    Images,
    Texture,
    in_base_format,
    mipmaps,
)

# what glTexImage takes -> kind of texture, face
IMAGE_TARGETS: dict[int, tuple[int, int]] = {
    gl.GL_TEXTURE_1D: (1, 0), gl.GL_TEXTURE_2D: (2, 0), gl.GL_TEXTURE_3D: (3, 0),
    **{gl.GL_TEXTURE_CUBE_MAP_POSITIVE_X + face: (CUBE, face) for face in range(6)},
}  # fmt: skip
PROXIES: dict[int, int] = {
    gl.GL_PROXY_TEXTURE_1D: 1, gl.GL_PROXY_TEXTURE_2D: 2, gl.GL_PROXY_TEXTURE_3D: 3, gl.GL_PROXY_TEXTURE_CUBE_MAP: CUBE,
}  # fmt: skip
PROXY = -1  # the name under which a proxy texture is kept


def image_target(target: int, kinds: tuple[int, ...]) -> tuple[int, int]:
    """Kind and face; a target of another dimension is an error."""
    kind, face = IMAGE_TARGETS.get(target, (0, 0))
    if kind not in kinds:
        words = [repr(name) for name, (other, _) in IMAGE_TARGETS.items() if other in kinds]
        raise invalid_enum("target", target, words[0] if len(words) == 1 else f"{words[0]} or a face of a cube map")
    return kind, face


def largest(kind: int) -> int:
    return MAX_3D_TEXTURE_SIZE if kind == 3 else MAX_TEXTURE_SIZE


def check_image(kind: int, level: int, internalformat: int, border: int, size: Sequence[int]) -> None:
    if internalformat not in BASE_FORMATS:
        raise invalid_value(
            "internalformat", internalformat, "1, 2, 3, 4, GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, ..."
        )
    if not 0 <= level < largest(kind).bit_length():
        raise invalid_value("level", level, f"from 0 to {largest(kind).bit_length() - 1}")
    if border not in (0, 1):
        raise invalid_value("border", border, "0 or 1")
    for length in size:
        if length < 2 * border:
            raise invalid_value("the size", length, f"at least {2 * border}")
    if kind in (3, CUBE) and BASE_FORMATS[internalformat] == gl.GL_DEPTH_COMPONENT:
        raise invalid_operation("a depth texture must have one or two dimensions")


def check_room(kind: int, border: int, size: Sequence[int]) -> None:
    """Raise GLError if there cannot be an image of this size: the question that a proxy texture answers."""
    for length in size:
        if length > largest(kind) + 2 * border:
            raise invalid_value("the size", length, f"from {2 * border} to {largest(kind) + 2 * border}")
    if kind == CUBE and size[0] != size[1]:
        raise invalid_value("the size", tuple(size), "square for the faces of a cube map")


def _check_format(internalformat: int, format: int, type: int) -> None:
    check(format, type)
    if (format == gl.GL_DEPTH_COMPONENT) != (BASE_FORMATS[internalformat] == gl.GL_DEPTH_COMPONENT):
        raise invalid_operation("a depth texture needs format GL_DEPTH_COMPONENT, and no other texture does")
    if format not in COMPONENTS and format not in (gl.GL_COLOR_INDEX, gl.GL_DEPTH_COMPONENT):
        raise invalid_enum("format", format, "a format of colours")


def _texels(m: Machine, internalformat: int, size: tuple[int, ...], format: int, type: int, pixels: Any) -> Any:
    """A rectangle out of the program's memory as an image keeps it; zeros if ``pixels`` is None."""
    _check_format(internalformat, format, type)
    base = BASE_FORMATS[internalformat]
    if base == gl.GL_DEPTH_COMPONENT:
        if pixels is None:
            return np.zeros((*size, 1), np.float32)
        return depths(m.pixel, unpack(m.stores.unpack, size, format, type, pixels))
    if pixels is None:
        return np.zeros((*size, 4), np.uint8)
    rgba = as_bytes(colors(m.pixel, format, unpack(m.stores.unpack, size, format, type, pixels)))
    return in_base_format(rgba, base, 255)


def define(m: Machine, kind: int, face: int, level: int, image: Image) -> None:
    name = m.texture.unit.names[kind - 1]
    texture = m.objects.textures[name, kind]
    images = {**texture.images.by_level, (face, level): image}
    if texture.sampler.generate_mipmap and level == texture.sampler.base_level and 0 not in image.size:
        images |= {(face, level + k): smaller for k, smaller in enumerate(mipmaps(image))}
    change(m, name, replace(texture, images=Images(images)))


def _tex_image(
    m: Machine, kinds: tuple[int, ...], target: int, level: int, internalformat: int, border: int,
    size: tuple[int, ...], format: int, type: int, pixels: Any,
) -> None:  # fmt: skip
    """glTexImage: ``size`` with its border, (height, width) or (depth, height, width)."""
    if PROXIES.get(target) in kinds:
        return _proxy(m, PROXIES[target], level, internalformat, border, size, format, type)
    kind, face = image_target(target, kinds)
    check_image(kind, level, internalformat, border, size if kind != 1 else size[1:])
    check_room(kind, border, size if kind != 1 else size[1:])
    texels = _texels(m, internalformat, size, format, type, pixels)
    if border:  # as drivers have done for decades: the border's own texels are dropped
        inner = slice(1, -1)
        texels = texels[:, inner] if kind == 1 else texels[(inner,) * len(size)]
    define(m, kind, face, level, Image(texels, internalformat))
    return None


def _proxy(
    m: Machine, kind: int, level: int, internalformat: int, border: int, size: tuple[int, ...], format: int, type: int
) -> None:
    """A proxy texture answers whether there is room for the image; other errors are errors (section 3.8.11)."""
    check_image(kind, level, internalformat, border, size if kind != 1 else size[1:])
    _check_format(internalformat, format, type)
    try:
        check_room(kind, border, size if kind != 1 else size[1:])
        image = Image(np.broadcast_to(np.uint8(0), (*size, 4)), internalformat)
    except GLError:
        image = Image(np.zeros((0,) * len(size) + (4,), np.uint8), internalformat)
    m.objects.textures[PROXY, kind] = Texture(kind, Images({(0, level): image}))


def glTexImage1D(
    m: Machine, target: int, level: int, internalformat: int, width: int, border: int, format: int, type: int,
    pixels: Any,
) -> None:  # fmt: skip
    _tex_image(m, (1,), target, level, internalformat, border, (1, int(width)), format, type, pixels)


def glTexImage2D(
    m: Machine, target: int, level: int, internalformat: int, width: int, height: int, border: int, format: int,
    type: int, pixels: Any,
) -> None:  # fmt: skip
    _tex_image(m, (2, CUBE), target, level, internalformat, border, (int(height), int(width)), format, type, pixels)


def glTexImage3D(
    m: Machine, target: int, level: int, internalformat: int, width: int, height: int, depth: int, border: int,
    format: int, type: int, pixels: Any,
) -> None:  # fmt: skip
    size = int(depth), int(height), int(width)
    _tex_image(m, (3,), target, level, internalformat, border, size, format, type, pixels)


def image_of(m: Machine, kind: int, face: int, level: int) -> Image:
    image = bound(m, kind).images.get(level, face)
    if image is None:
        raise invalid_operation(f"level {level} of the texture has no image yet: call glTexImage first")
    return image


def part_of(image: Image, offset: tuple[int, ...], size: tuple[int, ...]) -> tuple[slice, ...]:
    """The part of an image that a sub-image replaces; offset and size in the order of the array."""
    if any(not 0 <= o <= o + n <= length for o, n, length in zip(offset, size, image.size, strict=True)):
        lengths = " x ".join(map(str, reversed(image.size)))
        raise invalid_value("the rectangle", (*offset[::-1], *size[::-1]), f"inside of the image of {lengths} texels")
    return tuple(slice(o, o + n) for o, n in zip(offset, size, strict=True))


def replace_part(
    m: Machine, kind: int, face: int, level: int, image: Image, part: tuple[slice, ...], texels: Any
) -> None:
    changed = image.texels.copy()
    changed[part] = texels
    define(m, kind, face, level, Image(changed, image.internal_format))


def _tex_sub_image(
    m: Machine, kinds: tuple[int, ...], target: int, level: int, offset: tuple[int, ...], size: tuple[int, ...],
    format: int, type: int, pixels: Any,
) -> None:  # fmt: skip
    kind, face = image_target(target, kinds)
    if min(size) < 0:
        raise invalid_value("the size", size[::-1], "at least 0")
    image = image_of(m, kind, face, level)
    part = part_of(image, offset, size)
    replace_part(m, kind, face, level, image, part, _texels(m, image.internal_format, size, format, type, pixels))


def glTexSubImage1D(
    m: Machine, target: int, level: int, xoffset: int, width: int, format: int, type: int, pixels: Any
) -> None:
    _tex_sub_image(m, (1,), target, level, (0, xoffset), (1, width), format, type, pixels)


def glTexSubImage2D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, width: int, height: int, format: int, type: int,
    pixels: Any,
) -> None:  # fmt: skip
    _tex_sub_image(m, (2, CUBE), target, level, (yoffset, xoffset), (height, width), format, type, pixels)


def glTexSubImage3D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, zoffset: int, width: int, height: int, depth: int,
    format: int, type: int, pixels: Any,
) -> None:  # fmt: skip
    offset, size = (zoffset, yoffset, xoffset), (depth, height, width)
    _tex_sub_image(m, (3,), target, level, offset, size, format, type, pixels)
