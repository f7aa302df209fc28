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
import shutil
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import IO

from glsim.course.isolation.clean import environment
from glsim.course.isolation.runner import LARGEST
from glsim.play.supervise import supervised

NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}")  # of a result
NOBODY = 65534  # user and group
SIZE = str(LARGEST)  # bytes of each folder in memory
RIGHTS = ["--unshare-user", "--disable-userns", "--cap-drop", "ALL"]


class Bubblewrap:
    """Namespaces, a view of the files without the teacher's, and limits."""

    name = "bubblewrap"

    def run(self, command: Sequence[str], folder: Path, seconds: float) -> str:
        runner = str(Path(__file__).with_name("runner.py"))
        if os.geteuid() == 0:
            _give(folder)
        inner = [sys.executable, "-I", "-S", runner, str(seconds), str(folder / "out"), *command]
        with tempfile.TemporaryFile() as results:
            outcome = supervised(
                [*_wrapper(folder), *inner],
                cwd="/",
                environment=environment(),
                stdout=results.fileno(),
                timeout=seconds,
            )
            results.seek(0)
            _unpack(results, folder / "out")
        if outcome.timed_out:
            return f"stopped after {seconds:g} seconds: is there a loop that never ends?"
        return "" if outcome.code == 0 else f"the process ended with exit code {outcome.code}"


def works() -> bool:
    """Whether a picture can be drawn in bubblewrap here."""
    if not sys.platform.startswith("linux") or not shutil.which("bwrap"):
        return False
    draw = "import sys, glsim; glsim.offscreen(8, 8); open(sys.argv[1], 'w').write('drawn')"
    with tempfile.TemporaryDirectory(prefix="glsim-") as name:
        folder = Path(name)
        for inside in ("work", "out"):
            (folder / inside).mkdir()
        Bubblewrap().run([sys.executable, "-c", draw, str(folder / "out" / "drawn")], folder, 20.0)
        return (folder / "out" / "drawn").is_file()


def _give(folder: Path) -> None:
    """Make the user who runs the command the owner of a folder, which is bound read-only: nobody else can read it."""
    for path, _, files in os.walk(folder):
        for name in (path, *(os.path.join(path, file) for file in files)):
            os.chown(name, NOBODY, NOBODY, follow_symlinks=False)


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
    bound = [*_readable(), str(folder)]
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


def _readable() -> list[str]:
    """What Python and glsim need to read besides /usr: folders, those that hold others first."""
    root = Path(__file__).resolve().parents[3]
    glsim = [root / name for name in ("glsim", "shaders", "lessons")]
    packages = [Path(path) for path in sys.path if "site-packages" in path]
    needed = [Path(sys.base_prefix), Path(sys.prefix), *glsim, *packages]
    return sorted({str(path) for path in needed if path.is_dir() and not path.is_relative_to("/usr")})


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
