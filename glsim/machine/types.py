"""Number types: the suffix of a command, the constant of an array, the numpy type."""

from __future__ import annotations

import numpy as np

from glsim.machine.constants import (
    GL_BYTE,
    GL_DOUBLE,
    GL_FLOAT,
    GL_INT,
    GL_SHORT,
    GL_UNSIGNED_BYTE,
    GL_UNSIGNED_INT,
    GL_UNSIGNED_SHORT,
    Enum,
)

SUFFIXES: dict[str, Enum] = {
    "b": GL_BYTE,
    "s": GL_SHORT,
    "i": GL_INT,
    "f": GL_FLOAT,
    "d": GL_DOUBLE,
    "ub": GL_UNSIGNED_BYTE,
    "us": GL_UNSIGNED_SHORT,
    "ui": GL_UNSIGNED_INT,
}
DTYPES: dict[int, type] = {
    GL_BYTE: np.int8,
    GL_UNSIGNED_BYTE: np.uint8,
    GL_SHORT: np.int16,
    GL_UNSIGNED_SHORT: np.uint16,
    GL_INT: np.int32,
    GL_UNSIGNED_INT: np.uint32,
    GL_FLOAT: np.float32,
    GL_DOUBLE: np.float64,
}
