"""Isolation by bubblewrap: namespaces of its own, read-only system files, folders in memory, no network.

The results lie in memory inside and come out through ``runner``'s standard output, which is a file outside whose size
is limited.  What comes is not trusted: names and sizes are checked.

As root two steps are needed.  Root's bubblewrap makes the view of the files, because an ordinary user may not be able
to read Python's folder; then the user is dropped, because limits of processes do not hold for root; then a second
bubblewrap takes the remaining rights.  Environment and clock are those of ``supervised``, outside.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import IO

from glsim.course.isolation.clean import environment, give, readable, sentence
from glsim.course.isolation.runner import LARGEST
from glsim.play.supervise import Outcome, supervised

NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}")  # of a result
NOBODY = 65534  # user and group
SENDING = 1.0  # seconds that the runner has for stopping a command and sending its files
SIZE = str(LARGEST)  # bytes of each folder in memory
RIGHTS = ["--unshare-user", "--disable-userns", "--cap-drop", "ALL"]


class Bubblewrap:
    """Namespaces, a view of the files without the teacher's, and limits."""

    name = "bubblewrap"

    def run(self, command: Sequence[str], folder: Path, seconds: float) -> str:
        runner = str(Path(__file__).with_name("runner.py"))
        if os.geteuid() == 0:
            give(folder, NOBODY)  # who runs the command: nobody else can read the folder, which is bound read-only
        inner = [sys.executable, "-I", "-S", runner, str(seconds), str(folder / "out"), *command]
        began = time.monotonic()
        with tempfile.TemporaryFile() as results:
            outcome = supervised(
                [*_wrapper(folder), *inner],
                cwd="/",
                environment=environment(),
                stdout=results.fileno(),
                stderr=subprocess.DEVNULL,
                timeout=seconds + SENDING,
            )
            results.seek(0)
            _unpack(results, folder / "out")
        late = outcome.code != 0 and time.monotonic() - began > seconds  # the runner has stopped it
        return sentence(Outcome(outcome.code, outcome.timed_out or late), seconds)


def _wrapper(folder: Path) -> list[str]:
    """The command before the runner's."""
    ordinary = os.geteuid() != 0
    namespaces = [
        "--unshare-ipc",
        "--unshare-pid",
        "--unshare-net",
        "--unshare-uts",
        "--die-with-parent",
        "--new-session",
    ]
    view = ["--tmpfs", "/", "--ro-bind", "/usr", "/usr"]
    for name in ("bin", "lib", "lib64", "sbin"):
        if os.path.islink(f"/{name}"):
            view += ["--symlink", f"usr/{name}", f"/{name}"]
        elif os.path.isdir(f"/{name}"):
            view += ["--ro-bind", f"/{name}", f"/{name}"]
    view += ["--proc", "/proc", "--dev", "/dev", "--perms", "1777", "--size", SIZE, "--tmpfs", "/tmp"]
    bound = [*readable(), str(folder)]
    parents = {str(parent) for path in bound for parent in Path(path).parents} - {"/", "/tmp", "/usr"}
    for path in sorted(parents | {*bound}):  # folders before what lies in them
        view += ["--ro-bind", path, path] if path in bound else ["--perms", "0755", "--dir", path]
    out = str(folder / "out")
    view += ["--perms", "1777", "--size", SIZE, "--tmpfs", out, "--remount-ro", "/", "--chdir", "/tmp"]
    if ordinary:
        return ["bwrap", *namespaces, *RIGHTS, *view, "--"]
    user = ["--reuid", str(NOBODY), "--regid", str(NOBODY), "--clear-groups"]
    drop = ["setpriv", *user, "--no-new-privs", "--bounding-set=-all", "--inh-caps=-all", "--"]
    return [
        "bwrap",
        *namespaces,
        *view,
        "--",
        *drop,
        "bwrap",
        *RIGHTS,
        "--unshare-pid",
        "--dev-bind",
        "/",
        "/",
        "--die-with-parent",
        "--",
    ]


def _unpack(results: IO[bytes], out: Path) -> None:
    """Write the files that the runner sent to ``out``; stops at the first thing that is not as it should be."""
    for _ in range(8):
        try:
            facts = json.loads(results.readline(1000))
            name, size = facts["name"], facts["size"]
        except (ValueError, KeyError, TypeError, RecursionError):
            return
        if not (isinstance(name, str) and NAME.fullmatch(name) and type(size) is int and 0 <= size <= LARGEST):
            return
        data = results.read(size)
        if len(data) < size:
            return
        (out / name).write_bytes(data)
