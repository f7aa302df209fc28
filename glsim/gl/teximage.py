"""Images of textures: glTexImage and its kin write them, glGetTexImage reads them (section 3.8)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from glsim.gl.texture import bound, change
from glsim.machine import constants as gl
from glsim.machine.errors import GLError, invalid_enum, invalid_operation, invalid_value
from glsim.machine.machine import Machine
from glsim.machine.pixels import (
    COMPONENTS,
    as_bytes,
    as_numbers,
    check,
    colors,
    depths,
    pack_colors,
    transferred,
    unpack,
)
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
from glsim.machine.types import DTYPES, fill

# what glTexImage takes -> kind of texture, face
IMAGE_TARGETS: dict[int, tuple[int, int]] = {
    gl.GL_TEXTURE_1D: (1, 0), gl.GL_TEXTURE_2D: (2, 0), gl.GL_TEXTURE_3D: (3, 0),
    **{gl.GL_TEXTURE_CUBE_MAP_POSITIVE_X + face: (CUBE, face) for face in range(6)},
}  # fmt: skip
PROXIES: dict[int, int] = {
    gl.GL_PROXY_TEXTURE_1D: 1, gl.GL_PROXY_TEXTURE_2D: 2, gl.GL_PROXY_TEXTURE_3D: 3, gl.GL_PROXY_TEXTURE_CUBE_MAP: CUBE,
}  # fmt: skip
PROXY = -1  # the name under which a proxy texture is kept
# ---------------------------------------------------------------- images


def _image_target(target: int, kinds: tuple[int, ...]) -> tuple[int, int]:
    """Kind and face; a target of another dimension is an error."""
    found = IMAGE_TARGETS.get(target)
    if found is None or found[0] not in kinds:
        words = [repr(name) for name, (kind, _) in IMAGE_TARGETS.items() if kind in kinds]
        raise invalid_enum("target", target, words[0] if len(words) == 1 else f"{words[0]} or a face of a cube map")
    return found


def _largest(kind: int) -> int:
    return MAX_3D_TEXTURE_SIZE if kind == 3 else MAX_TEXTURE_SIZE


def _check_image(kind: int, level: int, internalformat: int, border: int, size: Sequence[int]) -> None:
    if internalformat not in BASE_FORMATS:
        raise invalid_value(
            "internalformat", internalformat, "1, 2, 3, 4, GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, ..."
        )
    if not 0 <= level < _largest(kind).bit_length():
        raise invalid_value("level", level, f"from 0 to {_largest(kind).bit_length() - 1}")
    if border not in (0, 1):
        raise invalid_value("border", border, "0 or 1")
    for length in size:
        if length < 2 * border:
            raise invalid_value("the size", length, f"at least {2 * border}")
    if kind in (3, CUBE) and BASE_FORMATS[internalformat] == gl.GL_DEPTH_COMPONENT:
        raise invalid_operation("a depth texture must have one or two dimensions")


def _check_room(kind: int, border: int, size: Sequence[int]) -> None:
    """Raise GLError if there cannot be an image of this size: the question that a proxy texture answers."""
    for length in size:
        if length > _largest(kind) + 2 * border:
            raise invalid_value("the size", length, f"from {2 * border} to {_largest(kind) + 2 * border}")
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


def _define(m: Machine, kind: int, face: int, level: int, image: Image) -> None:
    name = m.texture.unit.names[kind - 1]
    texture = m.objects.textures[name, kind]
    images = {**texture.images.by_level, (face, level): image}
    if texture.sampler.generate_mipmap and level == texture.sampler.base_level and 0 not in image.size:
        images |= {(face, level + k): made for k, made in enumerate(mipmaps(image))}
    change(m, name, replace(texture, images=Images(images)))


def _tex_image(
    m: Machine, kinds: tuple[int, ...], target: int, level: int, internalformat: int, border: int,
    size: tuple[int, ...], format: int, type: int, pixels: Any,
) -> None:  # fmt: skip
    """glTexImage: ``size`` with its border, (height, width) or (depth, height, width)."""
    if PROXIES.get(target) in kinds:
        return _proxy(m, PROXIES[target], level, internalformat, border, size, format, type)
    kind, face = _image_target(target, kinds)
    _check_image(kind, level, internalformat, border, size if kind != 1 else size[1:])
    _check_room(kind, border, size if kind != 1 else size[1:])
    texels = _texels(m, internalformat, size, format, type, pixels)
    if border:  # as drivers have done for decades: the border's own texels are dropped
        inner = slice(1, -1)
        texels = texels[:, inner] if kind == 1 else texels[(inner,) * len(size)]
    _define(m, kind, face, level, Image(texels, internalformat))
    return None


def _proxy(
    m: Machine, kind: int, level: int, internalformat: int, border: int, size: tuple[int, ...], format: int, type: int
) -> None:
    """A proxy texture answers whether there is room for the image; other errors are errors (section 3.8.11)."""
    _check_image(kind, level, internalformat, border, size if kind != 1 else size[1:])
    _check_format(internalformat, format, type)
    try:
        _check_room(kind, border, size if kind != 1 else size[1:])
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


def _image(m: Machine, kind: int, face: int, level: int) -> Image:
    image = bound(m, kind).images.get(level, face)
    if image is None:
        raise invalid_operation(f"level {level} of the texture has no image yet: call glTexImage first")
    return image


def _place(image: Image, offset: tuple[int, ...], size: tuple[int, ...]) -> tuple[slice, ...]:
    """The part of an image that a sub-image replaces; offset and size in the order of the array."""
    if any(not 0 <= o <= o + n <= there for o, n, there in zip(offset, size, image.size, strict=True)):
        there = " x ".join(map(str, reversed(image.size)))
        raise invalid_value("the rectangle", (*offset[::-1], *size[::-1]), f"inside of the image of {there} texels")
    return tuple(slice(o, o + n) for o, n in zip(offset, size, strict=True))


def _replace_part(
    m: Machine, kind: int, face: int, level: int, image: Image, place: tuple[slice, ...], texels: Any
) -> None:
    changed = image.texels.copy()
    changed[place] = texels
    _define(m, kind, face, level, Image(changed, image.internal_format))


def _tex_sub_image(
    m: Machine, kinds: tuple[int, ...], target: int, level: int, offset: tuple[int, ...], size: tuple[int, ...],
    format: int, type: int, pixels: Any,
) -> None:  # fmt: skip
    kind, face = _image_target(target, kinds)
    if min(size) < 0:
        raise invalid_value("the size", size[::-1], "at least 0")
    image = _image(m, kind, face, level)
    place = _place(image, offset, size)
    _replace_part(m, kind, face, level, image, place, _texels(m, image.internal_format, size, format, type, pixels))


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


# ---------------------------------------------------------------- images from the framebuffer


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
    kind, face = _image_target(target, kinds)
    if internalformat in (1, 2, 3, 4):
        raise invalid_enum("internalformat", internalformat, "a named format such as GL_RGB")
    _check_image(kind, level, internalformat, border, (width,) if kind == 1 else (height, width))
    _check_room(kind, border, (width,) if kind == 1 else (height, width))
    inner = border if kind != 1 else 0
    rectangle = x + border, y + inner, width - 2 * border, height - 2 * inner
    _define(m, kind, face, level, Image(_from_framebuffer(m, internalformat, *rectangle), internalformat))


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
    kind, face = _image_target(target, kinds)
    if width < 0 or height < 0:
        raise invalid_value("width and height", (width, height), "at least 0")
    image = _image(m, kind, face, level)
    place = _place(image, offset, (1, height, width) if kind == 3 else (height, width))
    texels = _from_framebuffer(m, image.internal_format, x, y, width, height)
    _replace_part(m, kind, face, level, image, place, texels)


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


# ---------------------------------------------------------------- compressed images: OpenGL 1.5 names no format


def _no_compressed_format(internalformat: int) -> None:
    raise invalid_enum(
        "internalformat", internalformat, "a compressed format, of which there is none (OpenGL 1.5 names no one)"
    )


def glCompressedTexImage1D(
    m: Machine, target: int, level: int, internalformat: int, width: int, border: int, imageSize: int, data: Any
) -> None:
    _no_compressed_format(internalformat)


def glCompressedTexImage2D(
    m: Machine, target: int, level: int, internalformat: int, width: int, height: int, border: int, imageSize: int,
    data: Any,
) -> None:  # fmt: skip
    _no_compressed_format(internalformat)


def glCompressedTexImage3D(
    m: Machine, target: int, level: int, internalformat: int, width: int, height: int, depth: int, border: int,
    imageSize: int, data: Any,
) -> None:  # fmt: skip
    _no_compressed_format(internalformat)


def glCompressedTexSubImage1D(
    m: Machine, target: int, level: int, xoffset: int, width: int, format: int, imageSize: int, data: Any
) -> None:
    _no_compressed_format(format)


def glCompressedTexSubImage2D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, width: int, height: int, format: int,
    imageSize: int, data: Any,
) -> None:  # fmt: skip
    _no_compressed_format(format)


def glCompressedTexSubImage3D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, zoffset: int, width: int, height: int, depth: int,
    format: int, imageSize: int, data: Any,
) -> None:  # fmt: skip
    _no_compressed_format(format)


def glGetCompressedTexImage(m: Machine, target: int, lod: int) -> None:
    raise invalid_operation("no texture is compressed: read it with glGetTexImage")


# ---------------------------------------------------------------- read-back


def _level(m: Machine, target: int, level: int) -> tuple[int, Image | None]:
    """Kind and image of a level for glGetTex..., which take faces and proxies too."""
    if target in PROXIES:
        kind, face = PROXIES[target], 0
        texture = m.objects.textures.get((PROXY, kind), Texture(kind))
    else:
        kind, face = _image_target(target, (1, 2, 3, CUBE))
        texture = bound(m, kind)
    if not 0 <= level < _largest(kind).bit_length():
        raise invalid_value("level", level, f"from 0 to {_largest(kind).bit_length() - 1}")
    return kind, texture.images.get(level, face)


# component sizes -> base formats that have the component
SIZES: dict[int, str] = {
    gl.GL_TEXTURE_RED_SIZE: "GL_RGB GL_RGBA",
    gl.GL_TEXTURE_GREEN_SIZE: "GL_RGB GL_RGBA",
    gl.GL_TEXTURE_BLUE_SIZE: "GL_RGB GL_RGBA",
    gl.GL_TEXTURE_ALPHA_SIZE: "GL_RGBA GL_ALPHA GL_LUMINANCE_ALPHA",
    gl.GL_TEXTURE_LUMINANCE_SIZE: "GL_LUMINANCE GL_LUMINANCE_ALPHA",
    gl.GL_TEXTURE_INTENSITY_SIZE: "GL_INTENSITY",
}


def glGetTexLevelParameter(m: Machine, target: int, level: int, pname: int) -> tuple[float, ...]:
    kind, image = _level(m, target, level)
    size = image.size if image is not None else (0, 0, 0)
    if pname == gl.GL_TEXTURE_WIDTH:
        return (size[-1],)
    if pname == gl.GL_TEXTURE_HEIGHT:
        return (size[-2],)
    if pname == gl.GL_TEXTURE_DEPTH:
        return (size[0] if kind == 3 else int(0 not in size),)
    if pname == gl.GL_TEXTURE_INTERNAL_FORMAT:
        return (image.internal_format if image is not None else 1,)
    if pname in (gl.GL_TEXTURE_BORDER, gl.GL_TEXTURE_COMPRESSED):
        return (0,)
    if pname == gl.GL_TEXTURE_DEPTH_SIZE:
        return (24 if image is not None and image.base_format == gl.GL_DEPTH_COMPONENT else 0,)
    if pname in SIZES:
        has = image is not None and repr(image.base_format) in SIZES[pname].split()
        return (8 if has else 0,)
    raise invalid_enum("pname", pname, "a parameter of an image such as GL_TEXTURE_WIDTH")


def glGetTexImage(
    m: Machine, target: int, level: int, format: int, type: int, array: Any = None, outputType: Any = bytes
) -> Any:
    """Texels of the bound texture.  As PyOpenGL: bytes for GL_UNSIGNED_BYTE, else an array; or into ``array``."""
    check(format, type)
    kind, image = _level(m, target, level)
    if image is None:
        raise invalid_operation(f"level {level} of the texture has no image")
    if (format == gl.GL_DEPTH_COMPONENT) != (image.base_format == gl.GL_DEPTH_COMPONENT):
        raise invalid_operation("only a depth texture is read as GL_DEPTH_COMPONENT")
    if format == gl.GL_DEPTH_COMPONENT:
        values = as_numbers(image.texels, DTYPES[type])
    elif format not in COMPONENTS:
        raise invalid_enum("format", format, "a format of colours")
    else:
        texels = image.texels.copy()
        if image.base_format in (gl.GL_LUMINANCE, gl.GL_LUMINANCE_ALPHA, gl.GL_INTENSITY):  # table 6.1: in red alone
            texels[..., 1:3] = 0
        if image.base_format == gl.GL_INTENSITY:
            texels[..., 3] = 255
        values = pack_colors(format, type, transferred(m.pixel, texels))
    size = image.size[1:] if kind == 1 else image.size
    return deliver(values.reshape(*size, values.shape[-1]), type, array, outputType)


def deliver(values: Any, type: int, array: Any, outputType: Any) -> Any:
    """Pixels ([depth,] [height,] width, components) in the form that PyOpenGL returns: width first."""
    if array is not None:
        return fill(array, values)
    if values.dtype == np.uint8 and outputType is bytes:
        return values.tobytes()
    size = values.shape[-2::-1]
    return values.reshape((*size, values.shape[-1]) if values.shape[-1] > 1 else size)
