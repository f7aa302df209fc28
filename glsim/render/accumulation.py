"""The accumulation buffer, which core profiles lack: an array beside the framebuffer (OpenGL 1.5 section 4.2.4)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.frame import Accum, Clear, Pixels
from glsim.machine.pixels import PixelMode
from glsim.machine.state import RasterPosition, Scissor
from glsim.render.pixels import Reader, plain_state


class Accumulation:
    """size: (width, height) of the framebuffer.  The array is made when it is first used."""

    def __init__(self, size: tuple[int, int]) -> None:
        self.size = size
        self.array: NDArray[np.float32] | None = None

    def _array(self) -> NDArray[np.float32]:
        """(height, width, 4), bottom row first."""
        if self.array is None:
            width, height = self.size
            self.array = np.zeros((height, width, 4), np.float32)
        return self.array

    def clear(self, packet: Clear) -> None:
        self._array()[self._scissored(packet.state.scissor)] = packet.accum

    def execute(self, packet: Accum, read: Reader) -> Pixels | None:
        """One glAccum.  For GL_RETURN the answer is what must be drawn: pixels, under scissor and colour mask alone."""
        rows, columns = part = self._scissored(packet.state.scissor)
        width, height = columns.stop - columns.start, rows.stop - rows.start
        if width <= 0 or height <= 0:
            return None
        array = self._array()
        if packet.operation in (gl.GL_ACCUM, gl.GL_LOAD):
            colors = read(columns.start, rows.start, width, height, "color") * np.float32(packet.value / 255.0)
            array[part] = colors if packet.operation == gl.GL_LOAD else array[part] + colors
        elif packet.operation == gl.GL_MULT:
            array[part] *= np.float32(packet.value)
        elif packet.operation == gl.GL_ADD:
            array[part] += np.float32(packet.value)
        else:
            image = np.clip(array[part] * np.float32(packet.value), 0.0, 1.0)
            state = plain_state(packet.state, self.size, fragments=False)
            raster = RasterPosition(x=float(columns.start), y=float(rows.start))
            return Pixels("color", image, None, raster, PixelMode(), state)
        return None

    def _scissored(self, scissor: Scissor) -> tuple[slice, slice]:
        """The pixels that glScissor lets through: rows, columns."""
        width, height = self.size
        test, x, y, wide, high = scissor
        if not test:
            return slice(0, height), slice(0, width)
        return slice(max(y, 0), max(min(y + high, height), 0)), slice(max(x, 0), max(min(x + wide, width), 0))
