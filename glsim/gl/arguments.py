"""Turning what Python programs pass into what the machine stores, as PyOpenGL does."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def numbers(values: Any) -> tuple[float, ...]:
    """A number, a (nested) sequence or an array -> a flat tuple of floats."""
    kind = type(values)
    if kind is list or kind is tuple:
        try:
            return tuple(map(float, values))
        except TypeError:
            pass
    elif kind is float or kind is int:
        return (float(values),)
    if isinstance(values, (str, bytes)) or values is None:
        raise TypeError(f"a number or a sequence of numbers is needed, not {values!r}")
    return tuple(np.asarray(values, np.float64).ravel().tolist())


def exactly(values: Any, count: int, what: str) -> tuple[float, ...]:
    """``numbers`` of which there must be ``count`` (more are ignored, as C would)."""
    given = numbers(values)
    if len(given) < count:
        raise ValueError(f"{what} needs {count} numbers, not {len(given)}")
    return given[:count]


def matrix16(values: Any) -> NDArray[np.float32]:
    """Sixteen numbers in any shape -> (4, 4) float32, column first as OpenGL stores matrices."""
    array = np.asarray(values, np.float32)
    if array.size != 16:
        raise ValueError(f"a matrix has 16 numbers, not {array.size}")
    return array.reshape(4, 4).copy()


def unit(value: float) -> float:
    """Clamped to [0, 1]."""
    return min(max(float(value), 0.0), 1.0)


def signed_colour(value: float) -> float:
    """An integer as a colour component: [-2^31, 2^31 - 1] -> [-1, 1], OpenGL 1.5 table 2.9."""
    return (2.0 * value + 1.0) / 4294967295.0


def array_from(data: Any, dtype: type, what: str) -> NDArray[Any]:
    """The memory a program points to, as a flat array of ``dtype``."""
    if data is None:
        raise ValueError(f"{what} is None: pass an array (buffer objects come with a later version)")
    if isinstance(data, (bytes, bytearray, memoryview)):
        return np.frombuffer(data, np.uint8)
    if isinstance(data, np.ndarray) and data.dtype.kind in "biuf":
        flat = np.ascontiguousarray(data)
        return (flat if flat.dtype == dtype else flat.astype(dtype)).ravel()
    try:
        return np.asarray(data, dtype).ravel()
    except (TypeError, ValueError) as error:
        raise TypeError(f"{what} must be an array or a sequence of numbers: {error}") from None
