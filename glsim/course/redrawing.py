"""Redraws what a student's program drew, in a process of its own: how many triangles there are is the program's choice,
so drawing them needs the same limits of time and memory as the program.

    python -m glsim.course.redrawing FRAME PICTURE

PICTURE is written as the bytes of (height, width, 3) uint8.  None of the student's code runs in this process.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from glsim.course.isolation import Isolation
from glsim.files import read_regular
from glsim.machine import archive
from glsim.machine.frame import Frame


class RedrawError(RuntimeError):
    """A Frame was not drawn within the limits; the message says so to the student."""


def redrawn(frame: Frame, isolation: Isolation, seconds: float) -> NDArray[np.uint8]:
    """The picture of a Frame, (height, width, 3), top row first.

    seconds: after which drawing is stopped.  Raises RedrawError if there is no picture then."""
    shape = frame.height, frame.width, 3
    with tempfile.TemporaryDirectory(prefix="glsim-") as name:
        folder = Path(name)
        for inside in ("work", "out"):
            (folder / inside).mkdir()
        source, target = folder / "frame", folder / "out" / "picture"
        archive.save(frame, source)
        command = [sys.executable, "-P", "-m", "glsim.course.redrawing", str(source), str(target)]
        note = isolation.run(command, folder, seconds)
        try:
            return np.frombuffer(read_regular(target, int(np.prod(shape))), np.uint8).reshape(shape)
        except (OSError, ValueError):
            raise RedrawError(
                f"what the program draws cannot be drawn again within {seconds:g} seconds and the limits of memory"
                f" ({note.partition(':')[0] or 'no picture came'}): does it draw far more than is seen?"
            ) from None


def main() -> None:
    """Draw the Frame of a file: the process's own main function."""
    from glsim.render.context import drawn

    source, target = sys.argv[1:]
    Path(target).write_bytes(drawn(archive.load(source))[..., :3].tobytes())


if __name__ == "__main__":
    main()
