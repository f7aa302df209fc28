"""Runs a student's command within limits inside bubblewrap, then sends the files of a folder to standard output.

    python -I -S runner.py SECONDS FOLDER COMMAND...

A file is sent as a line of JSON, {"name", "size"}, and its bytes.  Uses the standard library only.
"""

from __future__ import annotations

import contextlib
import json
import os
import resource
import signal
import stat
import subprocess
import sys

MEMORY = 2 << 30  # bytes of address space of one process
PROCESSES = 64  # llvmpipe needs more than four
LARGEST = 1 << 26  # bytes of one file, and of everything that is sent


def main(seconds: str, folder: str, *command: str) -> int:
    """Returns the exit code of the command, 128 + the signal's number if a signal ended it."""
    for kind, most in (
        (resource.RLIMIT_AS, MEMORY), (resource.RLIMIT_NPROC, PROCESSES), (resource.RLIMIT_FSIZE, LARGEST),
        (resource.RLIMIT_CORE, 0), (resource.RLIMIT_NOFILE, 256), (resource.RLIMIT_CPU, int(float(seconds)) + 2),
    ):  # fmt: skip
        resource.setrlimit(kind, (most, most))
    code = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          check=False).returncode  # fmt: skip
    with contextlib.suppress(ProcessLookupError):
        os.kill(
            -1, signal.SIGKILL
        )  # whatever the command left: all but this process and the first of the PID namespace
    for name in sorted(os.listdir(folder)):
        send(os.path.join(folder, name))
    return code if code >= 0 else 128 - code


def send(path: str) -> None:
    """Write a regular file to standard output; links and everything else are left out."""
    try:
        file = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
        return
    with open(file, "rb") as opened:
        facts = os.fstat(opened.fileno())
        if stat.S_ISREG(facts.st_mode) and facts.st_size <= LARGEST:
            line = json.dumps({"name": os.path.basename(path), "size": facts.st_size}).encode() + b"\n"
            sys.stdout.buffer.write(line + opened.read(facts.st_size))
            sys.stdout.buffer.flush()


if __name__ == "__main__":
    if os.getpid() == 1 or len(sys.argv) < 4:  # kill(-1) is for a PID namespace of its own
        sys.exit("this is started by glsim inside bubblewrap")
    sys.exit(main(*sys.argv[1:]))
