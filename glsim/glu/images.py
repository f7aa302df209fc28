"""Scaling images and building mipmaps."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.constants import NAMES
from glsim.glu.errors import GLUError
from glsim.machine.current import current_machine
from glsim.machine.pixels import PixelStore, as_numbers, as_unit, unpack
from glsim.machine.types import DTYPES


def scaled(image: NDArray[Any], size: tuple[int, ...]) -> NDArray[np.float64]:
    """An image (..., components) at another size: each new pixel is the mean over its part of the old ones."""
    result = image.astype(np.float64)
    for axis, (old, new) in enumerate(zip(image.shape[:-1], size, strict=True)):
        if old == new:
            continue
        edges = np.arange(new + 1) * (old / new)
        starts, ends = edges[:-1, None], edges[1:, None]
        cells = np.arange(old)[None]
        weights = np.clip(np.minimum(ends, cells + 1) - np.maximum(starts, cells), 0.0, None)
        weights /= weights.sum(axis=1, keepdims=True)
        result = np.moveaxis(np.tensordot(weights, result, (1, axis)), 0, axis)
    return result


def gluScaleImage(
    format: int, widthIn: int, heightIn: int, typeIn: int, dataIn: Any, widthOut: int, heightOut: int, typeOut: int,
    dataOut: Any = None,
) -> Any:  # fmt: skip
    """An image at another size, as an array (heightOut, widthOut, components), or in ``dataOut``."""
    if min(widthIn, heightIn, widthOut, heightOut) < 0:
        raise GLUError(int(NAMES["GLU_INVALID_VALUE"]), "gluScaleImage: sizes must be at least 0")
    store = current_machine().unpack_store
    unit = as_unit(unpack(store, (int(heightIn), int(widthIn)), format, typeIn, dataIn))
    values = as_numbers(scaled(unit, (int(heightOut), int(widthOut))), DTYPES[typeOut])
    if dataOut is None:
        return values
    np.asarray(dataOut).reshape(-1)[: values.size] = values.ravel()
    return dataOut


def _nearest_power(size: int) -> int:
    """The power of two that GLU takes for a size: the nearer one, 3 becomes 4."""
    below = 1 << (size.bit_length() - 1)
    return below if size - below < below / 2 or size == below else 2 * below


def _build(target: int, internalFormat: int, size: tuple[int, ...], format: int, type: int, data: Any) -> int:
    """Levels of a texture from the image at powers of two down to a single texel."""
    if min(size) < 1:
        raise GLUError(int(NAMES["GLU_INVALID_VALUE"]), "gluBuildMipmaps: sizes must be at least 1")
    machine = current_machine()
    image = as_unit(unpack(machine.unpack_store, size if len(size) > 1 else (1, *size), format, type, data))
    one_dimension = len(size) == 1
    image = image[0] if one_dimension else image
    limit = 512 if len(size) == 3 else 4096
    level_size = tuple(min(_nearest_power(length), limit) for length in size)
    image = scaled(image, level_size)
    upload: Any = (gl.glTexImage1D, gl.glTexImage2D, gl.glTexImage3D)[len(size) - 1]
    kept, machine.unpack_store = machine.unpack_store, PixelStore(alignment=1)
    try:
        for level in range(max(level_size).bit_length()):
            texels = as_numbers(image, np.uint8)
            upload(target, level, internalFormat, *image.shape[-2::-1], 0, format, gl.GL_UNSIGNED_BYTE, texels)
            image = scaled(texels / 255.0, tuple(max(length // 2, 1) for length in image.shape[:-1]))
    finally:
        machine.unpack_store = kept
    return 0


def gluBuild1DMipmaps(target: int, internalFormat: int, width: int, format: int, type: int, data: Any) -> int:
    return _build(target, internalFormat, (int(width),), format, type, data)


def gluBuild2DMipmaps(
    target: int, internalFormat: int, width: int, height: int, format: int, type: int, data: Any
) -> int:
    """All levels of a texture from an image of any size; it is scaled to powers of two first."""
    return _build(target, internalFormat, (int(height), int(width)), format, type, data)


def gluBuild3DMipmaps(
    target: int, internalFormat: int, width: int, height: int, depth: int, format: int, type: int, data: Any
) -> int:
    return _build(target, internalFormat, (int(depth), int(height), int(width)), format, type, data)
