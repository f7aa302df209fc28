"""A picture to draw into: ``glsim.offscreen``."""

from __future__ import annotations

import contextlib
import ctypes
import os
import weakref
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glsim.files import write_atomically
from glsim.machine import constants as gl
from glsim.machine.current import current_again, current_machine, make_current
from glsim.machine.frame import Frame, Packet
from glsim.machine.interrupts import uninterrupted
from glsim.machine.machine import Machine
from glsim.render.device import refuse_fork
from glsim.render.draw import Renderer
from glsim.render.driver import DriverContext, abandon, release_abandoned
from glsim.render.gpu import Framebuffer
from glsim.render.raw import RawGL

if TYPE_CHECKING:
    import PIL.Image

LARGEST = 16384
GL_FRAMEBUFFER, GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT = 0x8D40, 0x8D41, 0x88F0, 0x821A
GL_ALL_BUFFERS, GL_READ_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER = 0x4500, 0x8CA8, 0x8CA9
# what `read` can read: format, type
READABLE: dict[str, tuple[int, int]] = {
    "color": (gl.GL_RGBA, gl.GL_UNSIGNED_BYTE),
    "depth": (gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT),
    "stencil": (gl.GL_STENCIL_INDEX, gl.GL_UNSIGNED_BYTE),
}


def _checked_size(call: str, width: int, height: int) -> tuple[int, int]:
    for name, value in (("width", width), ("height", height)):
        if not isinstance(value, (int, np.integer)) or not 1 <= value <= LARGEST:
            raise ValueError(f"{call}: {name} must be an integer from 1 to {LARGEST}, not {value!r}")
    return int(width), int(height)


class Offscreen:
    """A context of its own that draws without a window.  Make one with ``glsim.offscreen``.

    Attributes:
        width, height: size in pixels.  samples: multisampling, 0 for none.  backend: how it was opened.
        machine: the state that the gl commands change.
    """

    def __init__(self, width: int, height: int, samples: int = 0, backend: str = "auto") -> None:
        self._released = False
        self.double_buffered = False  # what glGet(GL_DOUBLEBUFFER) says
        self.depth_bits, self.stencil_bits = 24, 8  # 0 if the program is to find none
        refuse_fork()
        release_abandoned()
        self.width, self.height = _checked_size("glsim.offscreen", width, height)
        before = current_machine()
        self._before = weakref.ref(before) if isinstance(before, Machine) else None
        self._previous: list[Any] = []
        with uninterrupted():
            self._driver = DriverContext(backend)
            self.backend, self.ctx = self._driver.backend, self._driver.ctx
            self.samples = self._samples(samples)
            self._raw = RawGL(self._driver.loader)
            self._depths: list[ctypes.c_uint] = []  # names of the renderbuffers of depth and stencil
            self._target = self._framebuffer(self.samples)
            self._resolved = self._framebuffer(0) if self.samples else self._target
            self.ctx.gc_mode = "context_gc"  # buffers of lists that are gone are released when the context is current
            self._renderer = Renderer(self.ctx, self._raw, (self.width, self.height))
            self.machine = Machine(self)
            self.make_current()

    def _samples(self, wanted: int) -> int:
        most = self.ctx.max_samples
        allowed = [0, *(n for n in (2, 4, 8, 16, 32) if n <= most)]
        if wanted not in allowed:
            choices = ", ".join(map(str, allowed))
            raise ValueError(f"glsim.offscreen: samples must be one of {choices} on this device, not {wanted!r}")
        return int(wanted)

    def _framebuffer(self, samples: int, probes: int = 0) -> Framebuffer:
        """A framebuffer with RGBA of 8 bits each, 24 bits of depth and 8 of stencil.

        probes: number of further RGBA float32 attachments, for the outputs of shaders/probe.frag."""
        size, raw = (self.width, self.height), self._raw
        colors = [self.ctx.renderbuffer(size, 4, samples=samples)]
        colors += [self.ctx.renderbuffer(size, 4, dtype="f4") for _ in range(probes)]
        framebuffer: Framebuffer = self.ctx.framebuffer(colors)
        framebuffer.use()
        name = ctypes.c_uint()
        raw.glGenRenderbuffers(1, ctypes.byref(name))
        raw.glBindRenderbuffer(GL_RENDERBUFFER, name.value)
        raw.glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8, *size)
        raw.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, name.value)
        self._depths.append(name)
        self._clear(framebuffer)
        return framebuffer

    def _clear(self, framebuffer: Framebuffer) -> None:
        """Clear the whole framebuffer: colour (0, 0, 0, 0), depth 1, stencil 0."""
        framebuffer.use()
        raw = self._raw
        raw.glDisable(gl.GL_SCISSOR_TEST)
        raw.glColorMask(1, 1, 1, 1)
        raw.glDepthMask(1)
        raw.glStencilMask(0xFFFFFFFF)
        raw.glClearColor(0.0, 0.0, 0.0, 0.0)
        raw.glClearDepth(1.0)
        raw.glClearStencil(0)
        raw.glClear(GL_ALL_BUFFERS)

    # ------------------------------------------------------------ current context

    def make_current(self) -> Offscreen:
        """Send this thread's gl commands here from now on."""
        self.check()
        make_current(self.machine)
        return self

    def __enter__(self) -> Offscreen:
        current: Any = current_machine()
        if current is self.machine and not self._previous and self._before is not None:
            current = self._before()  # the one that was current before this was made
        self._previous.append(current)
        return self.make_current()

    def __exit__(self, *exception: Any) -> None:
        previous = self._previous.pop()
        make_current(previous if isinstance(previous, Machine) and previous is not self.machine else None)

    def release(self) -> None:
        """Give the context's memory back now; it cannot be used afterwards.  It goes by itself when nobody holds it."""
        if self._released:
            return
        self.check()
        self._released = True
        if current_machine() is self.machine:
            make_current(None)
        self._driver.release()

    def __del__(self) -> None:
        if hasattr(self, "_driver") and not self._released:
            abandon(self._driver)

    def check(self) -> None:
        """Raise RuntimeError if the context was released, or belongs to another thread that is alive.

        If that thread has ended, the calling thread takes the context over."""
        refuse_fork()
        release_abandoned()
        if self._released:
            raise RuntimeError("this context was released: make another one with glsim.offscreen")
        if not self._driver.is_free():
            raise RuntimeError(
                "a context can only be drawn with in the thread that made it: each thread opens its own, with"
                " glsim.offscreen"
            )
        if self._driver.owner() is None:
            self._driver.take()

    # ------------------------------------------------------------ what the machine asks of its device

    def execute(self, packets: list[Packet]) -> None:
        with uninterrupted(), self.ctx:
            self._target.use()
            self._renderer.execute(packets, self._reread)

    def detach(self) -> None:
        """Let another library's context be current in this thread, until something is drawn here again."""
        self._driver.detach()

    def finish(self) -> None:
        self.check()
        with uninterrupted(), self.ctx:
            self._raw.glFinish()
        self._renderer.busy = False

    def read(self, x: int, y: int, width: int, height: int, what: str) -> NDArray[Any]:
        """Pixels of a rectangle, bottom row first; outside of the picture they are 0.

        what: "color" (height, width, 4) uint8, "depth" (height, width) float32 or "stencil" (height, width) uint8.
        """
        self.check()
        with uninterrupted(), self.ctx:
            pixels = self._read(x, y, width, height, what)
        self._renderer.busy = False
        return pixels

    def _read(self, x: int, y: int, width: int, height: int, what: str) -> NDArray[Any]:
        format, kind = READABLE[what]
        dtype = np.float32 if kind == gl.GL_FLOAT else np.uint8
        pixels = np.zeros((height, width, 4) if what == "color" else (height, width), dtype)
        self._resolve()
        self._resolved.use()
        self._raw.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        left, bottom = max(x, 0), max(y, 0)  # drivers add x and width in 32 bits, and may crash where that is too much
        right, top = min(x + width, self.width), min(y + height, self.height)
        if left >= right or bottom >= top:
            return pixels
        part = (
            pixels
            if (right - left, top - bottom) == (width, height)
            else np.zeros_like(pixels, shape=(top - bottom, right - left, *pixels.shape[2:]))
        )
        self._raw.glReadPixels(left, bottom, right - left, top - bottom, format, kind, part.ctypes.data)
        if part is not pixels:
            pixels[bottom - y : top - y, left - x : right - x] = part
        return pixels

    def _reread(self, x: int, y: int, width: int, height: int, what: str) -> NDArray[Any]:
        """Read for the renderer during ``execute``, and bind the framebuffer that it draws into again."""
        pixels = self._read(x, y, width, height, what)
        self._target.use()
        return pixels

    def _resolve(self) -> None:
        """Resolve multisampling: blit the multisampled framebuffer into the one with a single sample for each pixel."""
        if self.samples:
            raw, corners = self._raw, (0, 0, self.width, self.height)
            raw.glDisable(gl.GL_SCISSOR_TEST)
            raw.glBindFramebuffer(GL_READ_FRAMEBUFFER, self._target.glo)
            raw.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, self._resolved.glo)
            raw.glBlitFramebuffer(*corners, *corners, GL_ALL_BUFFERS, gl.GL_NEAREST)

    def describe(self) -> dict[str, Any]:
        """Vendor, renderer and version of the driver beneath, the backend, the number of samples."""
        info = self.ctx.info
        return {
            "backend": self.backend,
            "vendor": info["GL_VENDOR"],
            "renderer": info["GL_RENDERER"],
            "version": info["GL_VERSION"],
            "samples": self.samples,
            "double": self.double_buffered,
            "depth_bits": self.depth_bits,
            "stencil_bits": self.stencil_bits,
        }

    # ------------------------------------------------------------ pictures

    def pixels(self) -> NDArray[np.uint8]:
        """The picture, top row first: (height, width, 4) uint8, RGBA."""
        self.machine.complete()
        return self.read(0, 0, self.width, self.height, "color")[::-1]

    def depth(self) -> NDArray[np.float32]:
        """The depth buffer, top row first: (height, width) float32 in [0, 1]."""
        self.machine.complete()
        return self.read(0, 0, self.width, self.height, "depth")[::-1]

    def image(self) -> PIL.Image.Image:
        """The picture as a PIL image without alpha."""
        from PIL import Image

        return Image.fromarray(np.ascontiguousarray(self.pixels()[..., :3]))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the picture to a file; its ending says the format."""
        image = self.image()
        write_atomically(path, lambda name: image.save(name))

    def resize(self, width: int, height: int) -> None:
        """Another size; the picture is black afterwards, all state stays."""
        self.check()
        width, height = _checked_size("resize", width, height)
        self.machine.flush()
        with uninterrupted(), self.ctx:
            for depth in self._depths:  # moderngl's objects go when they are replaced
                self._raw.glDeleteRenderbuffers(1, ctypes.byref(depth))
            self._depths.clear()
            self.width, self.height = width, height
            self._target = self._framebuffer(self.samples)
            self._resolved = self._framebuffer(0) if self.samples else self._target
            self._renderer.resize((self.width, self.height))

    def reset(self) -> None:
        """Return to the state of a new context: initial state, black picture."""
        self.check()
        self.machine.reset()
        with uninterrupted(), self.ctx:
            self._renderer.reset()
            for framebuffer in {self._target, self._resolved}:
                self._clear(framebuffer)

    def _repr_png_(self) -> bytes | None:
        return self.image()._repr_png_()


def offscreen(width: int, height: int, *, samples: int = 0, backend: str = "auto") -> Offscreen:
    """Open a picture of ``width`` x ``height`` pixels to draw into, and send this thread's gl commands to it.

    As in OpenGL each thread has its own current context.  A context is drawn with in the thread that made it; when that
    has ended, in the first other one that uses it.  A process that was forked afterwards cannot draw: spawn it.

    samples: multisampling, 0 for none.  backend: "auto", "egl", "egl:N" (device N), "osmesa", "x11" or "native";
    "auto" honours the environment variable GLSIM_BACKEND and then tries what the platform has.

    Raises NoDeviceError if no OpenGL can be opened (it says what was tried and what to install), ValueError for a
    size or a number of samples that cannot be.
    """
    return Offscreen(width, height, samples, backend)


def drawn(frame: Frame) -> NDArray[np.uint8]:
    """The picture of a Frame, drawn on a screen of its own: (height, width, 4) uint8, top row first."""
    with own_screen(frame.width, frame.height) as screen:
        screen.execute(frame.packets)
        return screen.pixels()


@contextlib.contextmanager
def own_screen(width: int, height: int, *, samples: int = 0, backend: str = "auto") -> Iterator[Offscreen]:
    """A screen for the block alone, made with the options of ``offscreen``.

    After the block it is released, and the gl commands go again to what they went to before.
    """
    with current_again():
        screen = offscreen(width, height, samples=samples, backend=backend)
        try:
            yield screen
        finally:
            screen.release()
