"""State of a context that is in no group of state.py: vertex arrays, pixel storage, objects and the render mode."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from glsim.machine.constants import GL_RENDER
from glsim.machine.pixels import PixelStore
from glsim.machine.texture import Texture


@dataclass(slots=True)
class VertexArrays:
    """State of the client that glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT) saves (sections 2.8 and 2.9).

    arrays: GL_NORMAL_ARRAY, ..., or (GL_TEXTURE_COORD_ARRAY, unit) for units from 1 on -> Client (enabled, pointer).
    unit: chosen by glClientActiveTexture.  array_buffer, element_buffer: names of the bound buffer objects, 0 for none.
    """

    arrays: dict[Any, Any] = field(default_factory=dict)
    unit: int = 0
    array_buffer: int = 0
    element_buffer: int = 0

    def copy(self) -> VertexArrays:
        return replace(self, arrays=dict(self.arrays))


@dataclass(slots=True)
class PixelStores:
    """How pixels lie in the program's memory: where they are read (unpack) and written (pack); glPixelStore."""

    unpack: PixelStore = field(default_factory=PixelStore)
    pack: PixelStore = field(default_factory=PixelStore)

    def copy(self) -> PixelStores:
        return replace(self)


@dataclass(slots=True)
class Objects:
    """The objects of the program, by name: textures, buffer objects, queries, display lists; evaluator maps by target.

    textures: by (name, kind); name 0 are the default ones.  texture_names: those that glGenTextures returned.
    lists: compiled display lists.  maps: glMap1 and glMap2, by target.
    lowest: for "textures", "buffers", "queries" and "lists": no name below this one is free.
    """

    textures: dict[tuple[int, int], Texture]
    texture_names: set[int] = field(default_factory=set)
    buffers: dict[int, Any] = field(default_factory=dict)
    queries: dict[int, Any] = field(default_factory=dict)
    lists: dict[int, Any] = field(default_factory=dict)
    maps: dict[int, Any] = field(default_factory=dict)
    lowest: dict[str, int] = field(default_factory=dict)


@dataclass(slots=True)
class Rendering:
    """glRenderMode: the mode, and what glSelectBuffer and glFeedbackBuffer made (None before)."""

    mode: int = GL_RENDER
    selection: Any = None
    feedback: Any = None
