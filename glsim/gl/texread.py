"""Images of textures read back: glGetTexImage and glGetTexLevelParameter (sections 6.1.3 and 6.1.4)."""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.gl.teximage import PROXIES, PROXY, image_target, largest
from glsim.gl.texture import bound
from glsim.machine import constants as gl
from glsim.machine.errors import invalid_enum, invalid_operation, invalid_value
from glsim.machine.machine import Machine
from glsim.machine.packing import as_numbers, check, pack_colors
from glsim.machine.pixels import COMPONENTS, transferred
from glsim.machine.texture import CUBE, Image, Texture
from glsim.machine.types import DTYPES, fill


def _level(m: Machine, target: int, level: int) -> tuple[int, Image | None]:
    """Kind and image of a level for glGetTex..., which take faces and proxies too."""
    if target in PROXIES:
        kind, face = PROXIES[target], 0
        texture = m.objects.textures.get((PROXY, kind), Texture(kind))
    else:
        kind, face = image_target(target, (1, 2, 3, CUBE))
        texture = bound(m, kind)
    if not 0 <= level < largest(kind).bit_length():
        raise invalid_value("level", level, f"from 0 to {largest(kind).bit_length() - 1}")
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
        has_component = image is not None and repr(image.base_format) in SIZES[pname].split()
        return (8 if has_component else 0,)
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
