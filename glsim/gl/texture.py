"""Textures: section 3.8 of the specification.  One unit, one and two dimensions."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from glsim.gl.arguments import exactly, numbers, unit
from glsim.gl.pixels import unpack
from glsim.machine.constants import (
    GL_ADD,
    GL_ALPHA,
    GL_BLEND,
    GL_CLAMP,
    GL_CLAMP_TO_BORDER,
    GL_CLAMP_TO_EDGE,
    GL_COMBINE,
    GL_DECAL,
    GL_GENERATE_MIPMAP,
    GL_INTENSITY,
    GL_LINEAR,
    GL_LINEAR_MIPMAP_LINEAR,
    GL_LINEAR_MIPMAP_NEAREST,
    GL_LUMINANCE,
    GL_LUMINANCE_ALPHA,
    GL_MIRRORED_REPEAT,
    GL_MODULATE,
    GL_NEAREST,
    GL_NEAREST_MIPMAP_LINEAR,
    GL_NEAREST_MIPMAP_NEAREST,
    GL_REPEAT,
    GL_REPLACE,
    GL_RGB,
    GL_TEXTURE0,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_3D,
    GL_TEXTURE_BORDER_COLOR,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_ENV,
    GL_TEXTURE_ENV_COLOR,
    GL_TEXTURE_ENV_MODE,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_PRIORITY,
    GL_TEXTURE_RESIDENT,
    GL_TEXTURE_WRAP_R,
    GL_TEXTURE_WRAP_S,
    GL_TEXTURE_WRAP_T,
    Enum,
)
from glsim.machine.errors import invalid_enum, invalid_operation, invalid_value, out_of_memory
from glsim.machine.machine import MOST_NAMES, Machine
from glsim.machine.state import Color
from glsim.machine.texture import BASE_FORMATS, MAX_TEXTURE_SIZE, Image, Sampler, Texture, mipmaps

TARGETS: dict[int, int] = {GL_TEXTURE_1D: 1, GL_TEXTURE_2D: 2}
WRAPS = (GL_CLAMP, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT)
MAG_FILTERS = (GL_NEAREST, GL_LINEAR)
MIN_FILTERS = (
    *MAG_FILTERS, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
    GL_LINEAR_MIPMAP_LINEAR,
)  # fmt: skip
SAMPLER_FIELDS: dict[int, tuple[str, tuple[Enum, ...]]] = {
    GL_TEXTURE_MIN_FILTER: ("min_filter", MIN_FILTERS),
    GL_TEXTURE_MAG_FILTER: ("mag_filter", MAG_FILTERS),
    GL_TEXTURE_WRAP_S: ("wrap_s", WRAPS),
    GL_TEXTURE_WRAP_T: ("wrap_t", WRAPS),
}


def _dimensions(target: int) -> int:
    if target in (GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP):
        raise NotImplementedError(f"{target!r} is not in glsim yet")
    if target not in TARGETS:
        raise invalid_enum("target", target, "GL_TEXTURE_1D or GL_TEXTURE_2D")
    return TARGETS[target]


def _bound(m: Machine, dimensions: int) -> Texture:
    return m.textures[m.texture.names[dimensions - 1], dimensions]


def _change(m: Machine, dimensions: int, texture: Texture) -> None:
    """The texture object that is bound becomes ``texture``."""
    m.textures[m.texture.names[dimensions - 1], dimensions] = texture
    bound = list(m.texture.bound)
    bound[dimensions - 1] = texture
    m.texture = m.texture._replace(bound=tuple(bound))


def glActiveTexture(m: Machine, texture: int) -> None:
    if texture != GL_TEXTURE0:
        raise NotImplementedError("glActiveTexture: more than one texture unit is not in glsim yet")


def glGenTextures(m: Machine, n: int, textures: Any = None) -> Any:
    """As PyOpenGL: one name for n = 1, an array of names for more; or into ``textures``."""
    if n < 0:
        raise invalid_value("n", n, "at least 0")
    if n > MOST_NAMES:
        raise out_of_memory(f"{n} textures are more than the {MOST_NAMES} that can be")
    names: list[int] = []
    name = 1
    used = {number for number, _ in m.textures} | m.texture_names
    while len(names) < n:
        if name not in used:
            names.append(name)
        name += 1
    m.texture_names |= set(names)
    if textures is not None:
        np.asarray(textures).reshape(-1)[:n] = names
        return textures
    return np.uint32(names[0]) if n == 1 else np.array(names, np.uint32)


def glDeleteTextures(m: Machine, n: Any, textures: Any = None) -> None:
    """glDeleteTextures(n, names), or in PyOpenGL's form glDeleteTextures(names)."""
    given = numbers(n if textures is None else textures)
    for name in map(int, given if textures is None else given[: int(n)]):
        for target, dimensions in TARGETS.items():
            if name and m.texture.names[dimensions - 1] == name:
                glBindTexture(m, target, 0)
            if name:
                m.textures.pop((name, dimensions), None)
        m.texture_names.discard(name)


def glIsTexture(m: Machine, texture: int) -> int:
    return int(texture != 0 and any(name == texture for name, _ in m.textures))


def glBindTexture(m: Machine, target: int, texture: int) -> None:
    dimensions, name = _dimensions(target), int(texture)
    if name and (name, 3 - dimensions) in m.textures:
        raise invalid_operation(f"texture {name} has {3 - dimensions} dimension(s), not {dimensions}")
    found = m.textures.setdefault((name, dimensions), Texture(dimensions))
    names, bound = list(m.texture.names), list(m.texture.bound)
    names[dimensions - 1], bound[dimensions - 1] = name, found
    m.texture = m.texture._replace(names=tuple(names), bound=tuple(bound))


def glAreTexturesResident(m: Machine, n: int, textures: Any) -> int:
    return 1


def glPrioritizeTextures(m: Machine, n: int, textures: Any, priorities: Any) -> None:
    """Accepted; it has no effect."""


# ---------------------------------------------------------------- images


def _check_image(level: int, internalformat: int, border: int, *sizes: int) -> None:
    if internalformat not in BASE_FORMATS:
        raise invalid_value(
            "internalformat", internalformat, "1, 2, 3, 4, GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA, ..."
        )
    if level < 0:
        raise invalid_value("level", level, "at least 0")
    if border == 1:
        raise NotImplementedError("textures with a border are not in glsim yet")
    if border != 0:
        raise invalid_value("border", border, "0 or 1")
    for size in sizes:
        if not 0 <= size <= MAX_TEXTURE_SIZE:
            raise invalid_value("the size", size, f"from 0 to {MAX_TEXTURE_SIZE}")


def in_base_format(texels: Any, base: int) -> Any:
    """Red, green, blue, alpha as a base internal format keeps them."""
    result = texels.copy()
    if base in (GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY):
        result[..., :3] = texels[..., :1]
    if base == GL_INTENSITY:
        result[..., 3] = texels[..., 0]
    elif base in (GL_LUMINANCE, GL_RGB):
        result[..., 3] = 255
    elif base == GL_ALPHA:
        result[..., :3] = 0
    return result


def _set_image(m: Machine, dimensions: int, level: int, internalformat: int, texels: Any) -> None:
    texture = _bound(m, dimensions)
    image = Image(in_base_format(texels, BASE_FORMATS[internalformat]), internalformat)
    images = {**texture.images, level: image}
    if level == 0 and texture.sampler.generate_mipmap and texels.size:
        images = mipmaps(image)
    _change(m, dimensions, replace(texture, images=images))


def glTexImage2D(
    m: Machine, target: int, level: int, internalformat: int, width: int, height: int, border: int, format: int,
    type: int, pixels: Any,
) -> None:  # fmt: skip
    dimensions = _dimensions(target)
    if dimensions != 2:
        raise invalid_enum("target", target, "GL_TEXTURE_2D")
    _check_image(level, internalformat, border, width, height)
    _set_image(m, 2, level, internalformat, unpack(m, width, height, format, type, pixels))


def glTexImage1D(
    m: Machine, target: int, level: int, internalformat: int, width: int, border: int, format: int, type: int,
    pixels: Any,
) -> None:  # fmt: skip
    if _dimensions(target) != 1:
        raise invalid_enum("target", target, "GL_TEXTURE_1D")
    _check_image(level, internalformat, border, width)
    _set_image(m, 1, level, internalformat, unpack(m, width, 1, format, type, pixels))


def _set_part(m: Machine, dimensions: int, level: int, x: int, y: int, texels: Any) -> None:
    texture = _bound(m, dimensions)
    image = texture.images.get(level)
    if image is None:
        raise invalid_operation(f"level {level} of the texture has no image yet: call glTexImage first")
    height, width = texels.shape[:2]
    if x < 0 or y < 0 or x + width > image.texels.shape[1] or y + height > image.texels.shape[0]:
        there = f"{image.texels.shape[1]} x {image.texels.shape[0]}"
        raise invalid_value("the rectangle", (x, y, width, height), f"inside of the image of {there} texels")
    changed = image.texels.copy()
    changed[y : y + height, x : x + width] = in_base_format(texels, BASE_FORMATS[image.internal_format])
    images = {**texture.images, level: Image(changed, image.internal_format)}
    if level == 0 and texture.sampler.generate_mipmap:
        images = mipmaps(images[0])
    _change(m, dimensions, replace(texture, images=images))


def glTexSubImage2D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, width: int, height: int, format: int, type: int,
    pixels: Any,
) -> None:  # fmt: skip
    if _dimensions(target) != 2:
        raise invalid_enum("target", target, "GL_TEXTURE_2D")
    _set_part(m, 2, level, xoffset, yoffset, unpack(m, width, height, format, type, pixels))


def glTexSubImage1D(
    m: Machine, target: int, level: int, xoffset: int, width: int, format: int, type: int, pixels: Any
) -> None:
    if _dimensions(target) != 1:
        raise invalid_enum("target", target, "GL_TEXTURE_1D")
    _set_part(m, 1, level, xoffset, 0, unpack(m, width, 1, format, type, pixels))


def _from_framebuffer(m: Machine, x: int, y: int, width: int, height: int) -> Any:
    m.flush()
    return m.device.read(x, y, width, height, "color")


def glCopyTexImage2D(
    m: Machine, target: int, level: int, internalformat: int, x: int, y: int, width: int, height: int, border: int
) -> None:
    if _dimensions(target) != 2:
        raise invalid_enum("target", target, "GL_TEXTURE_2D")
    _check_image(level, internalformat, border, width, height)
    _set_image(m, 2, level, internalformat, _from_framebuffer(m, x, y, width, height))


def glCopyTexSubImage2D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, x: int, y: int, width: int, height: int
) -> None:
    if _dimensions(target) != 2:
        raise invalid_enum("target", target, "GL_TEXTURE_2D")
    _set_part(m, 2, level, xoffset, yoffset, _from_framebuffer(m, x, y, width, height))


# ---------------------------------------------------------------- parameters and environment


def glTexParameter(m: Machine, target: int, pname: int, params: Any) -> None:
    dimensions = _dimensions(target)
    texture = _bound(m, dimensions)
    _change(m, dimensions, replace(texture, sampler=_sampler(texture.sampler, pname, params)))


def _sampler(sampler: Sampler, pname: int, params: Any) -> Sampler:
    if pname == GL_TEXTURE_BORDER_COLOR:
        r, g, b, a = map(unit, exactly(params, 4, "GL_TEXTURE_BORDER_COLOR"))
        return replace(sampler, border_color=(r, g, b, a))
    (value,) = exactly(params, 1, "this parameter")
    if pname in SAMPLER_FIELDS:
        field, choices = SAMPLER_FIELDS[pname]
        if value not in choices:
            raise invalid_enum("param", int(value), " or ".join(map(repr, choices)))
        return replace(sampler, **{field: int(value)})  # type: ignore[arg-type]
    if pname == GL_TEXTURE_WRAP_R:
        return sampler
    if pname == GL_TEXTURE_PRIORITY:
        return replace(sampler, priority=unit(value))
    if pname == GL_GENERATE_MIPMAP:
        return replace(sampler, generate_mipmap=value != 0.0)
    raise invalid_enum("pname", pname, "a texture parameter such as GL_TEXTURE_MIN_FILTER or GL_TEXTURE_WRAP_S")


def glGetTexParameter(m: Machine, target: int, pname: int) -> tuple[float, ...]:
    sampler = _bound(m, _dimensions(target)).sampler
    if pname in SAMPLER_FIELDS:
        return (float(getattr(sampler, SAMPLER_FIELDS[pname][0])),)
    if pname == GL_TEXTURE_BORDER_COLOR:
        return sampler.border_color
    if pname in (GL_TEXTURE_PRIORITY, GL_GENERATE_MIPMAP):
        return (float(sampler.priority if pname == GL_TEXTURE_PRIORITY else sampler.generate_mipmap),)
    if pname == GL_TEXTURE_RESIDENT:
        return (1.0,)
    raise invalid_enum("pname", pname, "a texture parameter such as GL_TEXTURE_MIN_FILTER")


ENVIRONMENTS = (GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD)


def glTexEnv(m: Machine, target: int, pname: int, params: Any) -> None:
    if target != GL_TEXTURE_ENV:
        raise invalid_enum("target", target, "GL_TEXTURE_ENV")
    if pname == GL_TEXTURE_ENV_MODE:
        (mode,) = exactly(params, 1, "GL_TEXTURE_ENV_MODE")
        if mode == GL_COMBINE:
            raise NotImplementedError("glTexEnv with GL_COMBINE is not in glsim yet")
        if mode not in ENVIRONMENTS:
            raise invalid_enum("param", int(mode), "GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE or GL_ADD")
        m.texture = m.texture._replace(environment=int(mode))
    elif pname == GL_TEXTURE_ENV_COLOR:
        r, g, b, a = map(unit, exactly(params, 4, "GL_TEXTURE_ENV_COLOR"))
        color: Color = (r, g, b, a)
        m.texture = m.texture._replace(environment_color=color)
    else:
        raise NotImplementedError("glTexEnv with this parameter is not in glsim yet")


def glGetTexEnv(m: Machine, env: int, pname: int) -> tuple[float, ...]:
    if env != GL_TEXTURE_ENV:
        raise invalid_enum("env", env, "GL_TEXTURE_ENV")
    if pname == GL_TEXTURE_ENV_MODE:
        return (float(m.texture.environment),)
    if pname == GL_TEXTURE_ENV_COLOR:
        return m.texture.environment_color
    raise invalid_enum("pname", pname, "GL_TEXTURE_ENV_MODE or GL_TEXTURE_ENV_COLOR")
