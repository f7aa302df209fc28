"""Work that was interrupted, in a file, so that the next run goes on with it."""

from __future__ import annotations

import hashlib
import os
import zipfile
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.files import write_atomically
from glsim.radiosity.patches import Patches
from glsim.radiosity.scene import SceneError

# what NumPy raises for a file that is empty, cut off, or something else than npz
DAMAGED = (OSError, EOFError, ValueError, KeyError, TypeError, AttributeError, zipfile.BadZipFile, zlib.error)


def mark_of(patches: Patches, how: str) -> str:
    """A mark of what form factors depend on."""
    content = patches.rings.tobytes() + how.encode() + repr([ring.tolist() for ring in patches.scene.rings]).encode()
    return hashlib.sha256(content).hexdigest()


class Checkpoint:
    """Arrays in a file, marked by the patches they are of and how they were made; without a path it keeps nothing."""

    def __init__(self, path: str | None, patches: Patches, how: str) -> None:
        self.path = path
        self.mark = mark_of(patches, how) if path else ""

    def save(self, **arrays: NDArray[Any]) -> None:
        named: dict[str, Any] = {"mark": self.mark, **arrays}

        def write(name: str) -> None:
            with open(name, "wb") as file:
                np.savez(file, **named)

        if self.path:
            write_atomically(self.path, write)

    def load(self) -> dict[str, NDArray[Any]]:
        """The arrays; none if there is no file, or if it is of something else.  Raises SceneError for another file."""
        if not self.path or not os.path.exists(self.path):
            return {}
        try:
            with np.load(self.path) as kept:
                return {name: kept[name] for name in kept.files} if str(kept["mark"]) == self.mark else {}
        except DAMAGED as error:
            raise SceneError(f"{self.path} is no checkpoint: name another file, or remove it") from error

    def remove(self) -> None:
        """When the work is done."""
        if self.path and self.load():
            os.remove(self.path)
