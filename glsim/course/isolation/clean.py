"""What all isolations have in common: the environment of a student's process, what it must read, how it ended."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from glsim.play.supervise import Outcome

ROOT = Path(__file__).resolve().parents[3]  # holds the folder glsim


def environment() -> dict[str, str]:
    """The environment of a student's process: nothing of the teacher's but what Python and the GL library need."""
    kept = {name: os.environ[name] for name in ("PATH", "LANG", "GLSIM_BACKEND", "SYSTEMROOT") if name in os.environ}
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "LP_NUM_THREADS"), "1")
    packages = os.pathsep.join([str(ROOT), *(path for path in sys.path if "site-packages" in path)])
    fixed = {"PYTHONPATH": packages, "PYTHONHASHSEED": "0", "PYTHONDONTWRITEBYTECODE": "1"}
    return {**kept, **threads, **fixed}


def readable() -> list[str]:
    """The folders that Python and glsim need to read besides /usr; one that holds another comes before it."""
    glsim = [ROOT / name for name in ("glsim", "shaders", "lessons")]
    packages = [Path(path) for path in sys.path if "site-packages" in path]
    needed = [Path(sys.base_prefix), Path(sys.prefix), *glsim, *packages]
    return sorted({str(path) for path in needed if path.is_dir() and not path.is_relative_to("/usr")})


def give(folder: Path, user: int) -> None:
    """Make a user and the group of the same number the owner of a folder and all that is in it."""
    for path, _, files in os.walk(folder):
        for name in (path, *(os.path.join(path, file) for file in files)):
            os.chown(name, user, user, follow_symlinks=False)


def sentence(outcome: Outcome, seconds: float) -> str:
    """How a command ended; "" if it ended by itself with exit code 0."""
    if outcome.timed_out:
        return f"stopped after {seconds:g} seconds: is there a loop that never ends?"
    return "" if outcome.code == 0 else f"the process ended with exit code {outcome.code}"
