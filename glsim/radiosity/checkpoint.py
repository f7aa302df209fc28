"""A file with the results of interrupted work, from which the next run continues."""

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
    """Return a hash of all that form factors depend on: the patches, the scene, and ``how`` they are found."""
    content = patches.corners.tobytes() + how.encode() + repr([p.tolist() for p in patches.scene.polygons]).encode()
    return hashlib.sha256(content).hexdigest()


class Checkpoint:
    """A file of arrays, with a hash of the patches and the method they belong to; without a path nothing is saved."""

    def __init__(self, path: str | None, patches: Patches, how: str) -> None:
        self.path = path
        self.mark = mark_of(patches, how) if path else ""

    def save(self, **arrays: NDArray[Any]) -> None:
        """Write the arrays, under their names, in place of what the file holds."""
        named: dict[str, Any] = {"mark": self.mark, **arrays}

        def write(name: str) -> None:
            with open(name, "wb") as file:
                np.savez(file, **named)

        if self.path:
            write_atomically(self.path, write)

    def load(self) -> dict[str, NDArray[Any]]:
        """Return the arrays; none if there is no file, or if it belongs to other patches.

        Raises SceneError for a file that is no checkpoint.
        """
        if not self.path or not os.path.exists(self.path):
            return {}
        try:
            with np.load(self.path) as stored:
                return {name: stored[name] for name in stored.files} if str(stored["mark"]) == self.mark else {}
        except DAMAGED as error:
            raise SceneError(f"{self.path} is no checkpoint: name another file, or remove it") from error

    def remove(self) -> None:
        """Remove the file, when the work is done, unless it belongs to other patches."""
        if self.path and self.load():
            os.remove(self.path)
