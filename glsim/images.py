"""Any picture as an array: ``rgba``."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[np.uint8]

SHAPES = "(height, width), or (height, width, n) with n = 1 for grey, 2 for grey and alpha, 3 for RGB, 4 for RGBA"
LARGEST = 1 << 28  # pixels of a picture


def rgba(what: Any, *, size: Sequence[int] | None = None, origin: str = "upper") -> Pixels:
    """A picture as (height, width, 4) uint8: RGBA, top row first.

    what: one of
        an array (height, width) or (height, width, n), n = 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA, of uint8, uint16
        (0..65535), float in [0, 1] or bool; values are rounded to 8 bits;
        a PIL image of any mode, or the path of a picture file;
        what glReadPixels returned for GL_UNSIGNED_BYTE, bytes or array: with ``size`` and ``origin="lower"``;
        a moderngl.Framebuffer, a vtkRenderWindow or vtkImageData, what pyrender's OffscreenRenderer.render returned, a
        screen of glsim.  These know their size and where their first row is.
    size: (width, height).  The values lie row by row in memory; PyOpenGL's arrays have their dimensions the other
        way round, so their shape alone does not say this.
    origin: "upper" if the first row is at the top, "lower" if it is at the bottom, as OpenGL's is.

    Raises TypeError or ValueError, with a sentence, for what is no picture.
    """
    if origin not in ("upper", "lower"):
        raise ValueError(f'origin is "upper" or "lower", where the first row is, not {origin!r}')
    wanted = None if size is None else _checked_size(size)
    values, upwards = _values(what, wanted)
    pixels = _four_channels(_eight_bits(_checked_shape(values)))
    if wanted is not None and pixels.shape[1::-1] != wanted:
        raise ValueError(f"the picture is {pixels.shape[1]} x {pixels.shape[0]} pixels, and size says {wanted}")
    return np.ascontiguousarray(pixels[::-1] if upwards or origin == "lower" else pixels)


def on_paper(pixels: Pixels, square: int = 8) -> Pixels:
    """RGBA laid over a chequerboard of two greys, so that transparency is seen: (height, width, 3) uint8."""
    height, width = pixels.shape[:2]
    odd = (np.arange(height)[:, None] // square + np.arange(width) // square) % 2
    board = np.where(odd, 204, 255)[..., None]
    alpha = pixels[..., 3:] / 255.0
    return np.asarray(np.rint(pixels[..., :3] * alpha + board * (1.0 - alpha)), np.uint8)


def _checked_size(size: Sequence[int]) -> tuple[int, int]:
    try:
        width, height = (int(n) for n in size)
    except (TypeError, ValueError):
        raise TypeError(f"size is (width, height) in pixels, not {size!r}") from None
    if width < 1 or height < 1 or width * height > LARGEST:
        raise ValueError(f"size is (width, height) in pixels, each at least 1, not {size!r}")
    return width, height


def _values(what: Any, size: tuple[int, int] | None) -> tuple[NDArray[Any], bool]:
    """The values of a picture as an array, and whether the first row is known to be at the bottom."""
    from PIL import Image

    if isinstance(what, (bytes, bytearray, memoryview)):
        return _of_bytes(np.frombuffer(what, np.uint8), size), False
    if isinstance(what, (str, os.PathLike)):
        return _of_file(what), False
    if isinstance(what, Image.Image):
        return _of_pil(what), False
    if hasattr(what, "color_attachments") and hasattr(what, "read"):
        return _of_moderngl(what), True
    if hasattr(what, "IsA"):
        return _of_vtk(what), True
    if hasattr(what, "make_current") and callable(getattr(what, "pixels", None)):  # a screen of glsim
        return np.asarray(what.pixels()), False
    if isinstance(what, tuple) and len(what) == 2 and [np.ndim(part) for part in what] == [3, 2]:
        return np.asarray(what[0]), False  # pyrender: colour and depth
    return _of_array(what, size), False


def _of_bytes(data: NDArray[Any], size: tuple[int, int] | None) -> NDArray[Any]:
    if size is None:
        raise ValueError("bytes do not say how wide the picture is: add size=(width, height)")
    width, height = size
    if data.size not in [n * width * height for n in (1, 2, 3, 4)]:
        raise ValueError(
            f"{data.size} values are not 1, 2, 3 or 4 for each of {width} x {height} pixels: check size, and read with"
            " glPixelStorei(GL_PACK_ALIGNMENT, 1), which leaves no gaps between rows"
        )
    return data.reshape(height, width, -1)


def _of_file(path: str | os.PathLike[str]) -> NDArray[Any]:
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(path) as image:
            return _of_pil(image)
    except UnidentifiedImageError:
        raise ValueError(f"{os.fspath(path)} is no picture file that Pillow can read") from None
    except OSError as error:
        raise type(error)(f"{os.fspath(path)} cannot be read: {error.strerror or error}") from None


def _of_pil(image: Any) -> NDArray[Any]:
    if image.mode.startswith("I;16"):
        return np.asarray(image).astype(np.uint16)
    if image.mode == "I":  # 32 bits: Pillow reads some 16-bit files so
        wide = np.asarray(image)
        if wide.size and not 0 <= int(wide.min()) <= int(wide.max()) <= 65535:
            raise ValueError(f"a PIL image of mode I holds 0..65535, not {wide.min()}..{wide.max()}")
        return wide.astype(np.uint16)
    if image.mode == "F":
        return np.asarray(image)
    for steps in (["RGBA"], ["RGB"], ["LA", "RGBA"]):  # Pillow has no direct conversion of some modes
        try:
            converted = image
            for mode in steps:
                converted = converted.convert(mode)
            return np.asarray(converted)
        except ValueError:
            continue
    raise ValueError(f"a PIL image of mode {image.mode} cannot be made RGBA: convert it to RGB first")


def _of_moderngl(framebuffer: Any) -> NDArray[Any]:
    """Colour attachment 0.  moderngl reads the bottom row first."""
    attached = framebuffer.color_attachments
    if framebuffer.samples:
        raise ValueError(
            "a multisampled framebuffer cannot be read: copy it into one without samples first, with"
            " ctx.copy_framebuffer(dst, src)"
        )
    if attached is not None and not attached:
        raise ValueError("the framebuffer has no colour attachment")
    count, kind = (attached[0].components, attached[0].dtype) if attached else (3, "f1")
    if kind not in ("f1", "f2", "f4"):
        raise ValueError(f"a colour attachment of dtype f1, f2 or f4 is needed, not {kind}")
    width, height = framebuffer.size
    dtype = "f1" if kind == "f1" else "f4"
    data = framebuffer.read(viewport=(0, 0, width, height), components=count, alignment=1, dtype=dtype)
    return np.frombuffer(data, np.uint8 if dtype == "f1" else np.float32).reshape(height, width, count)


def _of_vtk(what: Any) -> NDArray[Any]:
    """vtkRenderWindow as it is shown, or vtkImageData of one slice.  VTK's first row is at the bottom."""
    if what.IsA("vtkRenderWindow"):
        rendering: Any = __import__("vtkmodules.vtkRenderingCore", fromlist=["vtkRenderingCore"])
        reader = rendering.vtkWindowToImageFilter()
        reader.SetInput(what)
        reader.ReadFrontBufferOff()
        reader.Update()
        what = reader.GetOutput()
    if not what.IsA("vtkImageData") or what.GetPointData().GetScalars() is None:
        raise TypeError(f"a vtkRenderWindow or vtkImageData with scalars is needed, not {what.GetClassName()}")
    width, height, depth = what.GetDimensions()
    if depth != 1:
        raise ValueError(f"vtkImageData of one slice is needed, not of {depth}")
    support: Any = __import__("vtkmodules.util.numpy_support", fromlist=["numpy_support"])
    scalars = support.vtk_to_numpy(what.GetPointData().GetScalars())
    return np.asarray(scalars).reshape(height, width, -1)


def _of_array(what: Any, size: tuple[int, int] | None) -> NDArray[Any]:
    try:
        values = np.asarray(what)
    except (TypeError, ValueError, RuntimeError):
        values = np.asarray(None)
    if values.dtype.kind not in "biuf":
        raise TypeError(
            "a picture is needed (an array, a PIL image, the path of a picture file, a frame buffer), not"
            f" {type(what).__module__}.{type(what).__qualname__}"
        )
    return values if size is None else _of_bytes(np.ascontiguousarray(values).reshape(-1), size)


def _checked_shape(values: NDArray[Any]) -> NDArray[Any]:
    shape = values.shape
    if values.ndim == 2:
        values = values[..., None]
    if values.ndim != 3 or not (values.shape[2] <= 4 or 0 in shape):
        hint = ""
        if len(shape) == 3 and shape[0] in (1, 3, 4):
            hint = "; if the channels come first, np.moveaxis(picture, 0, 2) puts them last"
        elif len(shape) == 1:
            hint = "; add size=(width, height)"
        raise ValueError(f"a picture has the shape {SHAPES}, not {shape}{hint}")
    if 0 in shape:
        raise ValueError(f"the picture is empty: its shape is {shape}")
    return values


def _eight_bits(values: NDArray[Any]) -> Pixels:
    if values.dtype == np.uint8:
        return values
    if values.dtype == np.bool_:
        return np.asarray(values * np.uint8(255), np.uint8)
    if values.dtype == np.uint16:
        if 0 < values.max() <= 255:
            raise ValueError(
                f"in uint16 white is 65535, and the largest value here is {values.max()}: if the values go to 255, use"
                " .astype(np.uint8)"
            )
        return np.asarray((values.astype(np.uint32) * 2 + 257) // 514, np.uint8)  # nearest of v / 257
    if values.dtype.kind == "f":
        least, most = float(values.min()), float(values.max())
        if not (least >= 0.0 and most <= 1.0):  # NaN too
            scale = ": divide by 255, or use .astype(np.uint8)" if 1.0 < most <= 255.0 and least >= 0.0 else ""
            raise ValueError(f"a picture of floats has values in [0, 1], not {least:g} to {most:g}{scale}")
        return np.asarray(np.rint(values.astype(np.float64) * 255.0), np.uint8)
    raise ValueError(
        f"a picture has values of uint8, uint16, float or bool, not {values.dtype}: if they go to 255, use"
        " .astype(np.uint8)"
    )


def _four_channels(pixels: Pixels) -> Pixels:
    height, width, channels = pixels.shape
    result = np.full((height, width, 4), 255, np.uint8)
    result[..., :3] = pixels[..., :1] if channels < 3 else pixels[..., :3]
    if channels in (2, 4):
        result[..., 3] = pixels[..., -1]
    return result
