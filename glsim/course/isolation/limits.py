"""Isolation where bubblewrap does not work: resource limits, alone or with Landlock.

If root grades, each command runs as a user of its own, who owns nothing: limits of processes do not hold for root, and
another user's processes cannot be touched.  That user keeps one right, to read all files, because Python may
lie in root's folder; Landlock takes it back.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import secrets
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from glsim.course.isolation import landlock
from glsim.course.isolation.clean import ROOT, environment, give, readable, sentence
from glsim.play.supervise import supervised

FIRST_USER = 1 << 30  # above all users that there are
READ_ALL = 1 << 2  # CAP_DAC_READ_SEARCH, linux/capability.h
DEVICES = ("/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")


class Limits:
    """Limits of memory, processes, time and size of a file; clean environment.  Files and network are open."""

    name = "resource limits"

    def run(self, command: Sequence[str], folder: Path, seconds: float) -> str:
        scratch = folder / "scratch"
        scratch.mkdir()
        here = Path(__file__)
        limited = [sys.executable, "-I", "-S", str(here.with_name("runner.py")), str(seconds), "-"]
        try:
            outcome = supervised(
                [*_another_user(folder), *limited, *self.walls(folder), *command],
                cwd=str(folder / "work"),
                environment={**environment(), "TMPDIR": str(scratch)},
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                timeout=seconds,
            )
        finally:
            _tidy(folder)
        return sentence(outcome, seconds)

    def walls(self, folder: Path) -> list[str]:
        """What stands before the command."""
        return []


class Landlock(Limits):
    """The same limits and Landlock: the command may read Python, glsim and its own folder, write ``out`` and a folder
    for scratch, and use no TCP."""

    name = "Landlock"

    def walls(self, folder: Path) -> list[str]:
        system = [path for path in ("/usr", "/bin", "/lib", "/lib64", "/sbin", *DEVICES) if os.path.exists(path)]
        own = [str(folder / "out"), str(folder / "scratch"), "/dev/null"]
        rules = {"read": [*system, *readable(), str(folder)], "write": own, "names": [str(ROOT)]}
        return [sys.executable, "-I", "-S", landlock.__file__, json.dumps(rules)]


def _another_user(folder: Path) -> list[str]:
    """The command that changes the user, who gets the folder, if this is root."""
    if os.geteuid() != 0:
        return []
    user = FIRST_USER + secrets.randbelow(FIRST_USER)
    give(folder, user)
    held = int(re.findall(r"CapPrm:\s*(\w+)", Path("/proc/self/status").read_text())[0], 16)
    right = "-all,+dac_read_search" if held & READ_ALL else "-all"  # Docker's root does not have it
    return ["setpriv", "--reuid", str(user), "--regid", str(user), "--clear-groups", "--no-new-privs",
            "--inh-caps", right, "--ambient-caps", right, "--bounding-set", right, "--"]  # fmt: skip


def _tidy(folder: Path) -> None:
    """Leave only the regular files in ``out``: no links, and no folders, which may be deep."""
    out = folder / "out"
    with contextlib.suppress(OSError):
        if folder.is_symlink():
            return
        if out.is_symlink():
            out.unlink()
        inside = (
            [entry for entry in os.scandir(out) if not entry.is_file(follow_symlinks=False)] if out.is_dir() else []
        )
        beside = [entry for entry in os.scandir(folder) if entry.name != "out"]
        paths = [entry.path for entry in (*inside, *beside)]
        subprocess.run(["rm", "-rf", "--", *paths], stderr=subprocess.DEVNULL, check=False)
