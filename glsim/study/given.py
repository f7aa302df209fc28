"""Pictures that are given to a comparison: files, arrays, PIL images."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

Given = Mapping[str, Any] | Sequence[str | os.PathLike[str]]


def is_picture(path: Any) -> bool:
    """Whether a path ends as a picture file does."""
    return isinstance(path, (str, Path)) and Path(path).suffix.lower() in Image.registered_extensions()


def are_given(what: Any) -> bool:
    """Whether what is to be compared are pictures, rather than something to draw."""
    return isinstance(what, (Mapping, list, tuple)) or is_picture(what)


def pictures_of(given: Any) -> dict[str, NDArray[np.uint8]]:
    """Name -> (height, width, 3) uint8, top row first.  Files are named by their names, or their paths where names are
    the same.  Raises ValueError for what is no picture, OSError for a file that cannot be read."""
    if isinstance(given, (str, Path)):
        given = [given]
    if not isinstance(given, Mapping):
        paths = [str(path) for path in given]
        twice = next((path for path in paths if paths.count(path) > 1), None)
        if twice is not None:
            raise ValueError(f"compare: the picture {twice} is given twice")
        short = [Path(path).name for path in paths]
        given = dict(zip(short if len(set(short)) == len(short) else paths, paths, strict=True))
    return {name: _pixels(name, picture) for name, picture in given.items()}


def _pixels(name: str, picture: Any) -> NDArray[np.uint8]:
    if isinstance(picture, (str, Path)):
        if not Path(picture).exists():
            raise FileNotFoundError(f"compare: {picture}: there is no such picture")
        with Image.open(picture) as file:
            return np.asarray(file.convert("RGB"))
    if isinstance(picture, Image.Image):
        return np.asarray(picture.convert("RGB"))
    pixels = np.asarray(picture)
    if pixels.dtype != np.uint8 or pixels.ndim != 3 or pixels.shape[2] not in (3, 4) or not pixels.size:
        raise ValueError(
            f"compare: the picture {name!r} must be (height, width, 3 or 4) of uint8, not {pixels.shape} {pixels.dtype}"
        )
    return np.ascontiguousarray(pixels[..., :3])
