"""Compressed images of textures (section 3.8.3): OpenGL 1.5 names no format, so each call is an error."""

from __future__ import annotations

from typing import Any

from glsim.machine.errors import invalid_enum, invalid_operation
from glsim.machine.machine import Machine


def _no_compressed_format(internalformat: int) -> None:
    raise invalid_enum(
        "internalformat", internalformat, "a compressed format, of which there is none (OpenGL 1.5 names no one)"
    )


def glCompressedTexImage1D(
    m: Machine, target: int, level: int, internalformat: int, width: int, border: int, imageSize: int, data: Any
) -> None:
    _no_compressed_format(internalformat)


def glCompressedTexImage2D(
    m: Machine, target: int, level: int, internalformat: int, width: int, height: int, border: int, imageSize: int,
    data: Any,
) -> None:  # fmt: skip
    _no_compressed_format(internalformat)


def glCompressedTexImage3D(
    m: Machine, target: int, level: int, internalformat: int, width: int, height: int, depth: int, border: int,
    imageSize: int, data: Any,
) -> None:  # fmt: skip
    _no_compressed_format(internalformat)


def glCompressedTexSubImage1D(
    m: Machine, target: int, level: int, xoffset: int, width: int, format: int, imageSize: int, data: Any
) -> None:
    _no_compressed_format(format)


def glCompressedTexSubImage2D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, width: int, height: int, format: int,
    imageSize: int, data: Any,
) -> None:  # fmt: skip
    _no_compressed_format(format)


def glCompressedTexSubImage3D(
    m: Machine, target: int, level: int, xoffset: int, yoffset: int, zoffset: int, width: int, height: int, depth: int,
    format: int, imageSize: int, data: Any,
) -> None:  # fmt: skip
    _no_compressed_format(format)


def glGetCompressedTexImage(m: Machine, target: int, lod: int) -> None:
    raise invalid_operation("no texture is compressed: read it with glGetTexImage")
