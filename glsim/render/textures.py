"""Textures on the GPU: uploaded when they are first drawn with, kept as long as the machine keeps them."""

from __future__ import annotations

import ctypes
import weakref
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.state import TextureUnit
from glsim.machine.texture import CUBE, Images, Texture
from glsim.render.compile import RECTANGLE_UNIT
from glsim.render.gpu import Commands

TARGETS: dict[int, int] = {1: gl.GL_TEXTURE_2D, 2: gl.GL_TEXTURE_2D, 3: gl.GL_TEXTURE_3D, CUBE: gl.GL_TEXTURE_CUBE_MAP}
# how a rectangle's elements lie on the GPU: (components, type) -> internal format, format, type
GL_R8, GL_R32F, GL_RGBA32F = 0x8229, 0x822E, 0x8814
RECTANGLES: dict[tuple[int, str], tuple[int, int, int]] = {
    (4, "u"): (gl.GL_RGBA8, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE),
    (4, "f"): (GL_RGBA32F, gl.GL_RGBA, gl.GL_FLOAT),
    (1, "u"): (GL_R8, gl.GL_RED, gl.GL_UNSIGNED_BYTE),
    (1, "f"): (GL_R32F, gl.GL_RED, gl.GL_FLOAT),
}


class _Name:
    """A texture's name in the driver; when nobody needs it any more it waits to be deleted."""

    def __init__(self, name: int, garbage: list[int]) -> None:
        self.name, self.garbage = name, garbage
        self.parameters: Any = None  # those it has

    def __del__(self) -> None:
        self.garbage.append(self.name)


class Textures:
    def __init__(self, raw: Commands) -> None:
        self.raw = raw
        self.names: weakref.WeakKeyDictionary[Images, _Name] = weakref.WeakKeyDictionary()
        self.garbage: list[int] = []  # deleted when the context is current
        self.rectangle_name = 0

    def bind(self, number: int, unit: TextureUnit) -> None:
        """Make the texture of a unit the one that textureNUMBER samples."""
        texture, raw = unit.active, self.raw
        assert texture is not None
        target = TARGETS[texture.kind]
        raw.glActiveTexture(gl.GL_TEXTURE0 + number)
        uploaded = self.names.get(texture.images)
        if uploaded is None:
            self._delete_garbage()
            uploaded = self.names[texture.images] = _Name(self._upload(texture, target), self.garbage)
        raw.glBindTexture(target, uploaded.name)
        parameters = texture.sampler, unit.level_bias
        if uploaded.parameters != parameters:
            self._set_parameters(texture, target, unit.level_bias)
            uploaded.parameters = parameters

    def rectangle(self, image: NDArray[Any]) -> None:
        """Make a rectangle of pixels the one that main.frag looks up."""
        raw = self.raw
        raw.glActiveTexture(gl.GL_TEXTURE0 + RECTANGLE_UNIT)
        if not self.rectangle_name:
            self.rectangle_name = self._new_name()
            raw.glBindTexture(gl.GL_TEXTURE_2D, self.rectangle_name)
            for pname, value in ((gl.GL_TEXTURE_MIN_FILTER, gl.GL_NEAREST), (gl.GL_TEXTURE_MAG_FILTER, gl.GL_NEAREST)):
                raw.glTexParameteri(gl.GL_TEXTURE_2D, pname, value)
        raw.glBindTexture(gl.GL_TEXTURE_2D, self.rectangle_name)
        raw.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
        texels = np.ascontiguousarray(image if image.dtype == np.uint8 else image.astype(np.float32))
        height, width, components = texels.shape
        internal, format, kind = RECTANGLES[components, texels.dtype.kind]
        raw.glTexImage2D(gl.GL_TEXTURE_2D, 0, internal, width, height, 0, format, kind, texels.ctypes.data)

    def _new_name(self) -> int:
        name = ctypes.c_uint()
        self.raw.glGenTextures(1, ctypes.byref(name))
        return name.value

    def _delete_garbage(self) -> None:
        if self.garbage:
            names = (ctypes.c_uint * len(self.garbage))(*self.garbage)
            self.raw.glDeleteTextures(len(names), names)
            self.garbage.clear()

    def _upload(self, texture: Texture, target: int) -> int:
        raw = self.raw
        name = self._new_name()
        raw.glBindTexture(target, name)
        raw.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
        for (face, level), image in texture.images.by_level.items():
            if 0 in image.size:
                continue
            texels = np.ascontiguousarray(image.texels)
            size = texels.shape[-2::-1]  # width, height and depth
            if image.base_format == gl.GL_DEPTH_COMPONENT:
                form: tuple[int, ...] = (gl.GL_DEPTH_COMPONENT24, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT)
            else:
                form = (gl.GL_RGBA8, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE)
            place = gl.GL_TEXTURE_CUBE_MAP_POSITIVE_X + face if texture.kind == CUBE else target
            upload = raw.glTexImage3D if texture.kind == 3 else raw.glTexImage2D
            upload(place, level, form[0], *size, 0, *form[1:], texels.ctypes.data)
        return name

    def _set_parameters(self, texture: Texture, target: int, level_bias: float) -> None:
        raw, sampler = self.raw, texture.sampler
        last = sampler.max_level if texture.mipmapped else sampler.base_level
        integers: list[tuple[int, int]] = [
            (gl.GL_TEXTURE_MIN_FILTER, sampler.min_filter),
            (gl.GL_TEXTURE_MAG_FILTER, sampler.mag_filter),
            (gl.GL_TEXTURE_BASE_LEVEL, sampler.base_level),
            (gl.GL_TEXTURE_MAX_LEVEL, max(last, sampler.base_level)),
            (gl.GL_TEXTURE_COMPARE_MODE, sampler.compare_mode if texture.is_depth else 0),
            (gl.GL_TEXTURE_COMPARE_FUNC, sampler.compare_func),
        ]
        wraps = zip(
            (gl.GL_TEXTURE_WRAP_S, gl.GL_TEXTURE_WRAP_T, gl.GL_TEXTURE_WRAP_R),
            (sampler.wrap_s, sampler.wrap_t, sampler.wrap_r),
            strict=True,
        )
        integers += [(pname, gl.GL_CLAMP_TO_BORDER if wrap == gl.GL_CLAMP else wrap) for pname, wrap in wraps]
        for pname, value in integers:
            raw.glTexParameteri(target, pname, value)
        for pname, number in (
            (gl.GL_TEXTURE_MIN_LOD, sampler.min_lod), (gl.GL_TEXTURE_MAX_LOD, sampler.max_lod),
            (gl.GL_TEXTURE_LOD_BIAS, level_bias),
        ):  # fmt: skip
            raw.glTexParameterf(target, pname, number)
        border = (ctypes.c_float * 4)(*texture.border_color)
        raw.glTexParameterfv(target, gl.GL_TEXTURE_BORDER_COLOR, border)
