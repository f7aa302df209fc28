"""Textures on the GPU: uploaded when they are first drawn with, kept as long as the machine keeps them."""

from __future__ import annotations

import ctypes
import weakref
from typing import Any

import numpy as np

from glsim.machine.constants import (
    GL_CLAMP,
    GL_CLAMP_TO_BORDER,
    GL_RGBA,
    GL_RGBA8,
    GL_TEXTURE0,
    GL_TEXTURE_2D,
    GL_TEXTURE_BORDER_COLOR,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_MAX_LEVEL,
    GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_WRAP_S,
    GL_TEXTURE_WRAP_T,
    GL_UNPACK_ALIGNMENT,
    GL_UNSIGNED_BYTE,
)
from glsim.machine.texture import Texture
from glsim.render.raw import RawGL


class _Name:
    """A texture's name in the driver; when nobody needs it any more it waits to be deleted."""

    def __init__(self, name: int, garbage: list[int]) -> None:
        self.name, self.garbage = name, garbage

    def __del__(self) -> None:
        self.garbage.append(self.name)


class Textures:
    def __init__(self, raw: RawGL) -> None:
        self.raw = raw
        self.names: weakref.WeakKeyDictionary[Texture, _Name] = weakref.WeakKeyDictionary()
        self.garbage: list[int] = []  # deleted when the context is current

    def bind(self, texture: Texture) -> None:
        """Make ``texture`` the one that texture0 samples."""
        self.raw.glActiveTexture(GL_TEXTURE0)
        kept = self.names.get(texture)
        if kept is None:
            self._delete_garbage()
            kept = self.names[texture] = _Name(self._upload(texture), self.garbage)
        self.raw.glBindTexture(GL_TEXTURE_2D, kept.name)

    def _delete_garbage(self) -> None:
        if self.garbage:
            names = (ctypes.c_uint * len(self.garbage))(*self.garbage)
            self.raw.glDeleteTextures(len(names), names)
            self.garbage.clear()

    def _upload(self, texture: Texture) -> int:
        raw, target, sampler = self.raw, GL_TEXTURE_2D, texture.sampler
        name = ctypes.c_uint()
        raw.glGenTextures(1, ctypes.byref(name))
        raw.glBindTexture(target, name.value)
        raw.glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
        levels = sorted(texture.images) if texture.mipmapped else [0]
        for level in levels:
            texels = np.ascontiguousarray(texture.images[level].texels)
            height, width = texels.shape[:2]
            kind = (GL_RGBA, GL_UNSIGNED_BYTE)
            raw.glTexImage2D(target, level, GL_RGBA8, width, height, 0, *kind, texels.ctypes.data)
        parameters: list[tuple[Any, Any]] = [
            (GL_TEXTURE_MAX_LEVEL, levels[-1]),
            (GL_TEXTURE_MIN_FILTER, sampler.min_filter),
            (GL_TEXTURE_MAG_FILTER, sampler.mag_filter),
            (GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER if sampler.wrap_s == GL_CLAMP else sampler.wrap_s),
            (GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER if sampler.wrap_t == GL_CLAMP else sampler.wrap_t),
        ]
        for parameter, value in parameters:
            raw.glTexParameteri(target, parameter, value)
        border = (ctypes.c_float * 4)(*sampler.border_color)
        raw.glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, border)
        return name.value
