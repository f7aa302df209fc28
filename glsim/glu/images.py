"""Scaling images and building mipmaps."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.constants import NAMES
from glsim.glu.errors import GLUError, one_of
from glsim.machine.current import current_machine
from glsim.machine.errors import GLError
from glsim.machine.packing import PACKED, as_numbers, pack_into, unpack
from glsim.machine.pixels import PixelStore, as_unit
from glsim.machine.types import DTYPES

# an error of OpenGL -> that of GLU
CODES: dict[int, int] = {
    gl.GL_INVALID_ENUM: NAMES["GLU_INVALID_ENUM"], gl.GL_INVALID_VALUE: NAMES["GLU_INVALID_VALUE"],
    gl.GL_INVALID_OPERATION: NAMES["GLU_INVALID_OPERATION"],
}  # fmt: skip


def scaled(image: NDArray[Any], size: tuple[int, ...], wrap: bool = False) -> NDArray[np.float64]:
    """An image (..., components) scaled to ``size``: each new pixel is the mean of the old image over its own area.

    With ``wrap`` this area is at least as large as an old pixel; where it exceeds the image, it continues at the
    opposite side.
    """
    result = image.astype(np.float64)
    for axis, (old, new) in enumerate(zip(image.shape[:-1], size, strict=True)):
        if old == new:
            continue
        middles = (np.arange(new)[:, None] + 0.5) * (old / new)
        half = max(old / new, 1.0 if wrap else 0.0) / 2
        cells = np.arange(-1, old + 1)[None]
        weights = np.clip(np.minimum(middles + half, cells + 1) - np.maximum(middles - half, cells), 0.0, None)
        weights[:, [1, -2]] += weights[:, [-1, 0]]  # beyond the end comes the beginning
        weights = weights[:, 1:-1]
        weights /= weights.sum(axis=1, keepdims=True)
        result = np.moveaxis(np.tensordot(weights, result, (1, axis)), 0, axis)
    return result


def _unpacked(name: str, size: tuple[int, ...], format: int, type: int, data: Any) -> NDArray[np.float64]:
    """The components in a program's memory, in [0, 1] or [-1, 1]."""
    if min(size) < 1:
        raise GLUError(NAMES["GLU_INVALID_VALUE"], f"{name}: the width, height and depth must be at least 1")
    try:
        return as_unit(
            unpack(current_machine().stores.unpack, size if len(size) > 1 else (1, *size), format, type, data)
        )
    except GLError as error:
        raise GLUError(CODES.get(error.err, error.err), f"{name}: {error.description}") from None


def gluScaleImage(
    format: int, widthIn: int, heightIn: int, typeIn: int, dataIn: Any, widthOut: int, heightOut: int, typeOut: int,
    dataOut: Any = None,
) -> Any:  # fmt: skip
    """An image at another size: into ``dataOut``, or, without it, as an array (heightOut, widthOut, components)."""
    if min(widthOut, heightOut) < 1:
        raise GLUError(NAMES["GLU_INVALID_VALUE"], "gluScaleImage: widthOut and heightOut must be at least 1")
    if typeOut not in DTYPES:
        raise GLUError(NAMES["GLU_INVALID_ENUM"], f"gluScaleImage: typeOut must be {one_of(DTYPES)}, not {typeOut!r}")
    image = _unpacked("gluScaleImage", (int(heightIn), int(widthIn)), format, typeIn, dataIn)
    values = as_numbers(scaled(image, (int(heightOut), int(widthOut)), wrap=True), DTYPES[typeOut])
    if dataOut is None:
        return values
    pack_into(current_machine().stores.pack, values, np.asarray(dataOut).reshape(-1).view(np.uint8))
    return 0


def _nearest_power(size: int) -> int:
    """The power of two that GLU takes for a size: the nearer one, 3 becomes 4."""
    below = 1 << (size.bit_length() - 1)
    return below if size - below < below / 2 or size == below else 2 * below


def _build(
    name: str, target: int, internalFormat: int, size: tuple[int, ...], format: int, type: int, data: Any,
    levels: tuple[int, int, int] | None = None,
) -> int:  # fmt: skip
    """Load levels of a texture from an image.

    size: (width,), (height, width) or (depth, height, width) of the image.  levels: (level of the image, first level to
    load, last level to load); None: the image is scaled to powers of two, and all levels down to one texel are loaded.
    """
    image = _unpacked(name, size, format, type, data).reshape(*size, -1)
    level, base, last = levels or (0, 0, 31)
    if levels is None:
        limit = 512 if len(size) == 3 else 4096
        # As GLU's sample implementation: it wraps what it first unpacks to 16 bits; in 2D these are the packed types.
        wrap = len(size) != 2 or type in PACKED
        image = scaled(image, tuple(min(_nearest_power(length), limit) for length in size), wrap)
    elif not 0 <= level <= base <= last < level + max(size).bit_length():
        sentence = f"{name}: 0 <= level <= base <= max <= {level} + log2 of the longest side is needed, not {levels}"
        raise GLUError(NAMES["GLU_INVALID_VALUE"], sentence)
    upload: Any = (gl.glTexImage1D, gl.glTexImage2D, gl.glTexImage3D)[len(size) - 1]
    number = np.uint8 if type in PACKED or np.dtype(DTYPES.get(type, np.uint8)).itemsize == 1 else np.float32
    machine = current_machine()
    saved, machine.stores.unpack = machine.stores.unpack, PixelStore(alignment=1)
    try:
        for k in range(level, min(last, level + max(image.shape[:-1]).bit_length() - 1) + 1):
            if k >= base:
                texels = as_numbers(image, number)
                kind = gl.GL_FLOAT if number is np.float32 else gl.GL_UNSIGNED_BYTE
                upload(target, k, internalFormat, *image.shape[-2::-1], 0, format, kind, texels)
            image = scaled(image, tuple(max(length // 2, 1) for length in image.shape[:-1]))
    finally:
        machine.stores.unpack = saved
    return 0


def gluBuild1DMipmaps(target: int, internalFormat: int, width: int, format: int, type: int, data: Any) -> int:
    """All levels of a one-dimensional texture from a row of ``width`` pixels; it is scaled to a power of two first."""
    return _build("gluBuild1DMipmaps", target, internalFormat, (int(width),), format, type, data)


def gluBuild2DMipmaps(
    target: int, internalFormat: int, width: int, height: int, format: int, type: int, data: Any
) -> int:
    """All levels of a texture from an image of any size; it is scaled to powers of two first."""
    return _build("gluBuild2DMipmaps", target, internalFormat, (int(height), int(width)), format, type, data)


def gluBuild3DMipmaps(
    target: int, internalFormat: int, width: int, height: int, depth: int, format: int, type: int, data: Any
) -> int:
    """All levels of a three-dimensional texture from an image of any size; it is scaled to powers of two first."""
    size = int(depth), int(height), int(width)
    return _build("gluBuild3DMipmaps", target, internalFormat, size, format, type, data)


def gluBuild1DMipmapLevels(
    target: int, internalFormat: int, width: int, format: int, type: int, level: int, base: int, max: int, data: Any
) -> int:
    """The levels from base to max, from an image that is level ``level``."""
    levels = int(level), int(base), int(max)
    return _build("gluBuild1DMipmapLevels", target, internalFormat, (int(width),), format, type, data, levels)


def gluBuild2DMipmapLevels(
    target: int, internalFormat: int, width: int, height: int, format: int, type: int, level: int, base: int, max: int,
    data: Any,
) -> int:  # fmt: skip
    """The levels from base to max, from an image that is level ``level``."""
    size, levels = (int(height), int(width)), (int(level), int(base), int(max))
    return _build("gluBuild2DMipmapLevels", target, internalFormat, size, format, type, data, levels)


def gluBuild3DMipmapLevels(
    target: int, internalFormat: int, width: int, height: int, depth: int, format: int, type: int, level: int,
    base: int, max: int, data: Any,
) -> int:  # fmt: skip
    """The levels from base to max, from an image that is level ``level``."""
    size, levels = (int(depth), int(height), int(width)), (int(level), int(base), int(max))
    return _build("gluBuild3DMipmapLevels", target, internalFormat, size, format, type, data, levels)
