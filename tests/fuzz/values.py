"""What a program might pass for an argument: numbers, arrays and memory of every kind, and what is none of them."""

from __future__ import annotations

import array
import ctypes
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np

DTYPES = [
    "f4", "f8", "f2", ">f4", ">f8", "i1", "u1", "i2", "u2", ">u2", "i4", "u4", "i8", "u8", "?", "c8", "O", "U3", "S2",
    "M8[s]",
]  # fmt: skip
ENORMOUS = (
    float("nan"), float("inf"), float("-inf"), 1e30, -1e30, 1e300, 5e-324, 2**31 - 1, 2**31, -(2**31), 2**32, 2**40,
    2**63, 2**64, 10**400, 65536, 16385,
)  # fmt: skip
SCALARS: tuple[Callable[[Any], Any], ...] = (
    np.float16, np.float32, np.float64, np.int8, np.uint8, np.int32, np.uint32, np.int64, np.bool_,
    ctypes.c_float, ctypes.c_double, ctypes.c_int, ctypes.c_ubyte, ctypes.c_uint, Fraction, Decimal,
    np.array, lambda value: np.array([value]), lambda value: np.array([[value]]),
)  # fmt: skip
NOTHING: tuple[Any, ...] = (
    None, "a", "", b"bytes", [], (), {}, 1 + 2j, object(), [1, [2, 3]], ["a"], [None], np.nan, int, range(4), {1, 2},
    np.zeros(0), bytearray(), memoryview(b""), ctypes.c_void_p(0), ctypes.POINTER(ctypes.c_float)(), Ellipsis, True,
)  # fmt: skip
# pointers lead into memory that is large enough for whatever a call may take from it
_MEMORY = (ctypes.c_double * 65536)(*(0.25 * (k % 5) for k in range(65536)))


def number(random: Random, whole: bool) -> Any:
    """An integer or a float that programs use, small."""
    if whole or random.random() < 0.4:
        return random.randint(-2, 12) if random.random() < 0.8 else random.randint(0, 100)
    return random.choice([0.0, 1.0, -1.0, 0.5, 0.25, 2.0, 30.0, 90.0, random.uniform(-2, 2)])


def odd_number(random: Random, whole: bool) -> Any:
    """A number of another type or size, or no number."""
    choice = random.random()
    if choice < 0.4:
        return random.choice(ENORMOUS)
    if choice < 0.8:
        value = number(random, whole)
        try:
            return random.choice(SCALARS)(value)
        except (TypeError, OverflowError):
            return random.choice(SCALARS[:3])(value)
    return random.choice(NOTHING)


def data(random: Random, length: int) -> Any:
    """Numbers as programs pass them: a list, a tuple, an array, bytes."""
    values = [number(random, False) for _ in range(length)]
    kind = random.randrange(6)
    if kind == 0:
        return tuple(values)
    if kind == 1:
        return np.array(values, random.choice(["f4", "f8"]))
    if kind == 2:
        return np.array(np.abs(values), random.choice(["u1", "u2", "u4"]))
    if kind == 3:
        return bytes(random.randrange(256) for _ in range(length))
    if kind == 4 and length % 4 == 0:
        return np.array(values, "f4").reshape(-1, 4)
    return values


def odd_array(random: Random, length: int) -> Any:
    """A NumPy array with an odd type, shape or stride."""
    dtype = random.choice(DTYPES)
    source = np.arange(2 * length + 2) % 7
    try:
        values: Any = source.astype(dtype) if dtype[0] != "M" else source.astype("i8").astype(dtype)
    except (TypeError, ValueError):
        values = source.astype("f4")
    view = random.randrange(7)
    if view == 0:
        values = values[length::-1]
    elif view == 1:
        values = values[::2][:length]
    elif view == 2:
        values = np.broadcast_to(values[:1], (length,))
    elif view == 3:
        values = values[: length // 4 * 4].reshape(-1, 2, 2).T
    elif view == 4:
        values = values[:length].copy()
        values.flags.writeable = False
    elif view == 5:
        values = values[0]
    else:
        values = values[:length]
    return values


def odd_memory(random: Random, length: int) -> Any:
    """Memory that is not an array of NumPy's: memoryview, array, ctypes arrays, pointers."""
    kind = random.randrange(8)
    letter = random.choice("bBhHiIfd")
    values = array.array(letter, [k % 5 for k in range(length)])
    if kind == 0:
        return values
    if kind == 1:
        return memoryview(values)
    if kind == 2:
        return memoryview(values)[::-1] if random.random() < 0.5 else memoryview(values)[::2]
    if kind == 3:
        return bytearray(values.tobytes())
    if kind == 4:
        element = random.choice([ctypes.c_float, ctypes.c_double, ctypes.c_ubyte, ctypes.c_int, ctypes.c_ushort])
        return (element * length)(*range(length))
    if kind == 5:
        element = random.choice([ctypes.c_float, ctypes.c_double, ctypes.c_ubyte, ctypes.c_int])
        return ctypes.cast(_MEMORY, ctypes.POINTER(element))
    if kind == 6:
        return ctypes.c_void_p(random.choice([0, 4, 64]))
    return ((ctypes.c_float * 4) * max(length // 4, 1))()


def odd_data(random: Random, length: int) -> Any:
    choice = random.random()
    if choice < 0.45:
        return odd_array(random, length)
    if choice < 0.75:
        return odd_memory(random, length)
    if choice < 0.9:
        values = data(random, length)
        if isinstance(values, list) and values:
            values[random.randrange(len(values))] = random.choice([*ENORMOUS, *NOTHING])
        return values
    return random.choice(NOTHING)
