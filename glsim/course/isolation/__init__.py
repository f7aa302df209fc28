"""How a student's file is kept apart from everything else while it runs."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Protocol

from glsim.course.isolation.clean import environment
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
        if outcome.timed_out:
            return f"stopped after {seconds:g} seconds: is there a loop that never ends?"
        return "" if outcome.code == 0 else f"the process ended with exit code {outcome.code}"


@cache
def best() -> Isolation:
    """Bubblewrap if it works on this machine, else ``Separate``.  Each is tried once, by drawing a picture in it."""
    from glsim.course.isolation.bubblewrap import Bubblewrap, works

    return Bubblewrap() if works() else Separate()
