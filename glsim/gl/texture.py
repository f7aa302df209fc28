"""Texture objects and their parameters: section 3.8 of the specification.

Images are in teximage.py, texcopy.py and texread.py, environments and texture coordinates in texenv.py.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from glsim.gl.arguments import exactly, numbers, unit
from glsim.gl.naming import free_name, names_from, new_names, returned_names
from glsim.machine import constants as gl
from glsim.machine.constants import Enum
from glsim.machine.errors import invalid_enum, invalid_operation, invalid_value
from glsim.machine.machine import Machine
from glsim.machine.texture import (
    CUBE,
    Sampler,
    Texture,
)
from glsim.machine.types import fill

# what glBindTexture takes -> kind of texture
TARGETS: dict[int, int] = {gl.GL_TEXTURE_1D: 1, gl.GL_TEXTURE_2D: 2, gl.GL_TEXTURE_3D: 3, gl.GL_TEXTURE_CUBE_MAP: CUBE}
KIND_NAMES = {1: "one-dimensional", 2: "two-dimensional", 3: "three-dimensional", CUBE: "a cube map"}

WRAPS = (gl.GL_CLAMP, gl.GL_REPEAT, gl.GL_CLAMP_TO_EDGE, gl.GL_CLAMP_TO_BORDER, gl.GL_MIRRORED_REPEAT)
MAG_FILTERS = (gl.GL_NEAREST, gl.GL_LINEAR)
MIN_FILTERS = (
    *MAG_FILTERS, gl.GL_NEAREST_MIPMAP_NEAREST, gl.GL_LINEAR_MIPMAP_NEAREST, gl.GL_NEAREST_MIPMAP_LINEAR,
    gl.GL_LINEAR_MIPMAP_LINEAR,
)  # fmt: skip
CHOICES: dict[int, tuple[str, tuple[Enum, ...]]] = {
    gl.GL_TEXTURE_MIN_FILTER: ("min_filter", MIN_FILTERS),
    gl.GL_TEXTURE_MAG_FILTER: ("mag_filter", MAG_FILTERS),
    gl.GL_TEXTURE_WRAP_S: ("wrap_s", WRAPS),
    gl.GL_TEXTURE_WRAP_T: ("wrap_t", WRAPS),
    gl.GL_TEXTURE_WRAP_R: ("wrap_r", WRAPS),
    gl.GL_DEPTH_TEXTURE_MODE: ("depth_mode", (gl.GL_LUMINANCE, gl.GL_INTENSITY, gl.GL_ALPHA)),
    gl.GL_TEXTURE_COMPARE_MODE: ("compare_mode", (gl.GL_NONE, gl.GL_COMPARE_R_TO_TEXTURE)),
}
VALUES: dict[int, str] = {
    gl.GL_TEXTURE_PRIORITY: "priority", gl.GL_TEXTURE_MIN_LOD: "min_lod", gl.GL_TEXTURE_MAX_LOD: "max_lod",
    gl.GL_TEXTURE_LOD_BIAS: "lod_bias", gl.GL_TEXTURE_BASE_LEVEL: "base_level", gl.GL_TEXTURE_MAX_LEVEL: "max_level",
    gl.GL_TEXTURE_COMPARE_FUNC: "compare_func", gl.GL_GENERATE_MIPMAP: "generate_mipmap",
}  # fmt: skip


def _kind(target: int) -> int:
    if target not in TARGETS:
        raise invalid_enum("target", target, " or ".join(map(repr, TARGETS)))
    return TARGETS[target]


def bound(m: Machine, kind: int) -> Texture:
    """The texture object of this kind that the active unit is bound to."""
    return m.objects.textures[m.texture.unit.names[kind - 1], kind]


def change(m: Machine, name: int, texture: Texture) -> None:
    """The texture object ``name`` becomes ``texture``, in every unit where it is bound."""
    m.objects.textures[name, texture.kind] = texture
    at = texture.kind - 1
    for number, place in enumerate(m.texture.units):
        if place.names[at] == name:
            entries = (*place.bound[:at], texture, *place.bound[at + 1 :])
            m.texture = m.texture.with_unit(number, place._replace(bound=entries))


def rebind(m: Machine) -> None:
    """After glPopAttrib: textures keep the images they have now, and get the parameters that were saved."""
    for number, place in enumerate(m.texture.units):
        for saved, name in zip(place.bound, place.names, strict=True):
            now = m.objects.textures.get((name, saved.kind))
            if now is None:  # deleted meanwhile
                m.texture = m.texture.with_unit(number, _with_binding(m.texture.units[number], saved.kind, 0, m))
            elif now is not saved:
                change(m, name, replace(now, sampler=saved.sampler))


def _with_binding(place: Any, kind: int, name: int, m: Machine) -> Any:
    at = kind - 1
    return place._replace(
        names=(*place.names[:at], name, *place.names[at + 1 :]),
        bound=(*place.bound[:at], m.objects.textures[name, kind], *place.bound[at + 1 :]),
    )


# ---------------------------------------------------------------- names


def glGenTextures(m: Machine, n: int, textures: Any = None) -> Any:
    """As PyOpenGL: one name for n = 1, an array of names for more; or into ``textures``."""

    def used(name: int) -> bool:
        return name in m.objects.texture_names or any((name, kind) in m.objects.textures for kind in TARGETS.values())

    names = new_names(m, "textures", n, used)
    m.objects.texture_names |= set(names)
    return returned_names(names, textures)


def glDeleteTextures(m: Machine, n: Any, textures: Any = None) -> None:
    """glDeleteTextures(n, names), or in PyOpenGL's form glDeleteTextures(names)."""
    for name in names_from(n, textures):
        if name <= 0:
            continue
        for kind in TARGETS.values():
            for number, place in enumerate(m.texture.units):
                if place.names[kind - 1] == name:
                    m.texture = m.texture.with_unit(number, _with_binding(place, kind, 0, m))
            m.objects.textures.pop((name, kind), None)
        m.objects.texture_names.discard(name)
        free_name(m, "textures", name)


def glIsTexture(m: Machine, texture: int) -> int:
    return int(texture > 0 and any(name == texture for name, _ in m.objects.textures))


def glBindTexture(m: Machine, target: int, texture: int) -> None:
    kind, name = _kind(target), int(texture)
    for other in TARGETS.values():
        if name and other != kind and (name, other) in m.objects.textures:
            raise invalid_operation(f"texture {name} is {KIND_NAMES[other]}, not {KIND_NAMES[kind]}")
    m.objects.textures.setdefault((name, kind), Texture(kind))
    m.texture = m.texture.with_unit(m.texture.active_unit, _with_binding(m.texture.unit, kind, name, m))


def glAreTexturesResident(m: Machine, n: Any, textures: Any = None, residences: Any = None) -> Any:
    """All are.  As PyOpenGL: glAreTexturesResident(names) or (n, names), an array with one flag each."""
    names = names_from(n, textures)
    for name in names:
        if not glIsTexture(m, name):
            raise invalid_value("textures", name, "names of textures")
    count = len(names)
    if residences is None:
        return np.ones(count, np.uint8)
    return fill(residences, [1] * count)


def glPrioritizeTextures(m: Machine, n: int, textures: Any, priorities: Any) -> None:
    """Sets GL_TEXTURE_PRIORITY, which has no effect."""
    for name, priority in zip(names_from(n, textures), numbers(priorities), strict=False):
        for kind in TARGETS.values():
            texture = m.objects.textures.get((name, kind))
            if name and texture is not None:
                change(m, name, replace(texture, sampler=replace(texture.sampler, priority=unit(priority))))


# ---------------------------------------------------------------- parameters


def glTexParameter(m: Machine, target: int, pname: int, params: Any) -> None:
    kind = _kind(target)
    texture = bound(m, kind)
    change(m, m.texture.unit.names[kind - 1], replace(texture, sampler=_sampler(texture.sampler, pname, params)))


def _sampler(sampler: Sampler, pname: int, params: Any) -> Sampler:
    if pname == gl.GL_TEXTURE_BORDER_COLOR:
        r, g, b, a = map(unit, exactly(params, 4, "GL_TEXTURE_BORDER_COLOR"))
        return replace(sampler, border_color=(r, g, b, a))
    (value,) = exactly(params, 1, "this parameter")
    if pname in CHOICES:
        field, choices = CHOICES[pname]
        if value not in choices:
            raise invalid_enum("param", int(value), " or ".join(map(repr, choices)))
        return replace(sampler, **{field: int(value)})  # type: ignore[arg-type]
    if pname not in VALUES:
        raise invalid_enum("pname", pname, "a texture parameter such as GL_TEXTURE_MIN_FILTER or GL_TEXTURE_WRAP_S")
    if pname == gl.GL_TEXTURE_COMPARE_FUNC and not gl.GL_NEVER <= value <= gl.GL_ALWAYS:
        raise invalid_enum("param", int(value), "a comparison such as GL_LEQUAL")
    if pname in (gl.GL_TEXTURE_BASE_LEVEL, gl.GL_TEXTURE_MAX_LEVEL) and value < 0:
        raise invalid_value("param", value, "at least 0")
    before = getattr(sampler, VALUES[pname])
    kind: Any = int if isinstance(before, Enum) else type(before)
    changes: dict[str, Any] = {VALUES[pname]: unit(value) if pname == gl.GL_TEXTURE_PRIORITY else kind(value)}
    return replace(sampler, **changes)


def glGetTexParameter(m: Machine, target: int, pname: int) -> tuple[float, ...]:
    sampler = bound(m, _kind(target)).sampler
    if pname == gl.GL_TEXTURE_BORDER_COLOR:
        return sampler.border_color
    if pname == gl.GL_TEXTURE_RESIDENT:
        return (1.0,)
    field = CHOICES[pname][0] if pname in CHOICES else VALUES.get(pname)
    if field is None:
        raise invalid_enum("pname", pname, "a texture parameter such as GL_TEXTURE_MIN_FILTER")
    return (float(getattr(sampler, field)),)
