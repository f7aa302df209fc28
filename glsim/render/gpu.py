"""What the renderer needs of a GPU, as protocols: moderngl's objects and raw.RawGL fulfil them, and so can an object
that only writes down what it is told.

Arguments mean what they mean in moderngl; enumerants are OpenGL's.  Only driver.py and context.py make the real
objects.
"""

from __future__ import annotations

from types import TracebackType
from typing import Any, Protocol


class Commands(Protocol):
    """Commands of the core profile as methods, with OpenGL's names and arguments: those of raw.SIGNATURES."""

    def __getattr__(self, name: str) -> Any: ...


class Buffer(Protocol):
    """Memory of the GPU.  size: in bytes."""

    @property
    def size(self) -> int: ...

    def write(self, data: Any) -> None:
        """Copy the bytes of an array to the beginning."""

    def orphan(self, size: int = -1) -> None:
        """Take new memory of that size, while draws may still read the old."""

    def bind_to_uniform_block(self, binding: int = 0, *, offset: int = 0, size: int = -1) -> None:
        """Let the uniform block with this binding read ``size`` bytes from ``offset`` on."""


class Program(Protocol):
    """A linked program.  By name: its inputs, samplers and uniform blocks, as far as they are in use."""

    def __contains__(self, name: str) -> bool: ...

    def __setitem__(self, name: str, value: Any) -> None: ...

    def get(self, key: str, default: Any) -> Any: ...


class VertexArray(Protocol):
    """A program's inputs, each with the buffer it comes from, and the buffer of indices."""

    def render(self, mode: int | None = None, vertices: int = -1, *, first: int = 0, instances: int = -1) -> None:
        """Draw ``vertices`` indices from ``first`` on as points, lines or triangles, ``instances`` times."""


class Framebuffer(Protocol):
    """Pictures to draw into.  glo: its name in OpenGL."""

    @property
    def glo(self) -> int: ...

    def use(self) -> None: ...

    def read(
        self, viewport: Any = None, components: int = 3, *, attachment: int = 0, alignment: int = 1, dtype: str = "f1"
    ) -> bytes: ...


class GPU(Protocol):
    """A context.  ``with gpu:`` makes it current and then the one from before again."""

    @property
    def info(self) -> dict[str, Any]: ...

    @property
    def max_samples(self) -> int: ...

    def __enter__(self) -> Any: ...

    def __exit__(
        self, exc_type: type[BaseException] | None, exc: BaseException | None, trace: TracebackType | None
    ) -> Any: ...

    def gc(self) -> int:
        """Release what nobody holds any more."""

    def buffer(self, data: Any = None, *, reserve: int = 0, dynamic: bool = False) -> Any: ...

    def program(self, *, vertex_shader: str, fragment_shader: str) -> Any:
        """Compile and link.  Raises an exception whose text is the compiler's message."""

    def vertex_array(self, program: Any, content: Any, *, index_buffer: Any) -> Any: ...

    def renderbuffer(
        self, size: tuple[int, int], components: int = 4, *, samples: int = 0, dtype: str = "f1"
    ) -> Any: ...

    def framebuffer(self, color_attachments: Any) -> Any: ...
