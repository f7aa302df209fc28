"""How a student's file is kept apart from everything else while it runs.  ISOLATION.md says what that contains."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Protocol

from glsim.course.isolation.clean import environment, sentence
from glsim.play.supervise import supervised


class Isolation(Protocol):
    """Runs a command so that it can change nothing but the folders ``out`` and ``work`` below ``folder``."""

    name: str  # for the report, such as "bubblewrap"

    def run(self, command: Sequence[str], folder: Path, seconds: float) -> str:
        """Run ``command`` for at most ``seconds``; afterwards none of its processes is left.

        The command may read ``folder`` and what Python and the GL library need.
        Returns a sentence about how it ended, "" if it ended by itself with exit code 0."""


class Separate:
    """A process of its own with a time limit and a clean environment, and nothing more."""

    name = "not isolated"

    def run(self, command: Sequence[str], folder: Path, seconds: float) -> str:
        outcome = supervised(
            command, cwd=str(folder / "work"), environment=environment(), stdout=subprocess.DEVNULL, timeout=seconds
        )
        return sentence(outcome, seconds)


@cache
def best() -> Isolation:
    """Bubblewrap, else Landlock with resource limits, else resource limits alone, else (not Linux) ``Separate``.

    The first that works on this machine: each is tried by drawing a picture in it, once."""
    if not sys.platform.startswith("linux"):
        return Separate()
    from glsim.course.isolation.bubblewrap import Bubblewrap
    from glsim.course.isolation.limits import Landlock, Limits

    ways: tuple[Isolation, ...] = (Bubblewrap(), Landlock(), Limits())
    return next(filter(works, ways), Separate())


def works(isolation: Isolation) -> bool:
    """Whether a picture can be drawn in an isolation on this machine."""
    draw = "import sys, glsim; glsim.offscreen(8, 8); open(sys.argv[1], 'w').write('drawn')"
    with tempfile.TemporaryDirectory(prefix="glsim-") as name:
        folder = Path(name)
        for inside in ("work", "out"):
            (folder / inside).mkdir()
        try:
            isolation.run([sys.executable, "-c", draw, str(folder / "out" / "drawn")], folder, 20.0)
        except OSError:
            return False
        return (folder / "out" / "drawn").is_file()
