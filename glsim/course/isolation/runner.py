"""Runs a student's command within limits.

    python -I -S runner.py SECONDS FOLDER COMMAND...
    python -I -S runner.py SECONDS - COMMAND...

With a FOLDER, inside bubblewrap: when the command has ended or its time is up, the files of the folder are sent to
standard output, each as a line of JSON, {"name", "size"}, and its bytes.  With "-" this process becomes the command.
Uses the standard library only.
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
PROCESSES = 64  # and threads, more than the user has already; llvmpipe needs more than four
LARGEST = 1 << 26  # bytes of one file, and of everything that is sent
STACK_SECONDS = 0.1  # seconds after SIGUSR2, at which glsim's player writes down where it is


def main(seconds: str, folder: str, *command: str) -> int:
    """Returns the exit code of the command, 128 + the signal's number if a signal ended it."""
    limit(float(seconds))
    if folder == "-":
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.execvp(command[0], command)
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        child.wait(float(seconds))
    except subprocess.TimeoutExpired:
        child.send_signal(signal.SIGUSR2)
        with contextlib.suppress(subprocess.TimeoutExpired):
            child.wait(STACK_SECONDS)
        child.kill()
    with contextlib.suppress(ProcessLookupError):  # all but this process and the first of the PID namespace
        os.kill(-1, signal.SIGKILL)
    for name in sorted(os.listdir(folder)):
        send(os.path.join(folder, name))
    code = child.wait()
    return code if code >= 0 else 128 - code


def limit(seconds: float) -> None:
    """Limit this process and its children, for ever."""
    for kind, most in (
        (resource.RLIMIT_AS, MEMORY), (resource.RLIMIT_NPROC, PROCESSES + threads()),
        (resource.RLIMIT_FSIZE, LARGEST), (resource.RLIMIT_CORE, 0), (resource.RLIMIT_NOFILE, 256),
        (resource.RLIMIT_CPU, int(seconds) + 2),
    ):  # fmt: skip
        already = resource.getrlimit(kind)[1]
        most = most if already == resource.RLIM_INFINITY else min(most, already)
        resource.setrlimit(kind, (most, most))


def threads() -> int:
    """How many threads the user has, which RLIMIT_NPROC counts together."""
    count = 0
    for name in os.listdir("/proc"):
        with contextlib.suppress(OSError):
            if name.isdigit() and os.stat(f"/proc/{name}").st_uid == os.getuid():
                count += len(os.listdir(f"/proc/{name}/task"))
    return count


def send(path: str) -> None:
    """Write a regular file to standard output; links and everything else are left out."""
    try:
        file = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
        return
    facts = os.fstat(file)
    if stat.S_ISREG(facts.st_mode) and facts.st_size <= LARGEST:
        with open(file, "rb", closefd=False) as opened:
            line = json.dumps({"name": os.path.basename(path), "size": facts.st_size}).encode() + b"\n"
            sys.stdout.buffer.write(line + opened.read(facts.st_size))
            sys.stdout.buffer.flush()
    os.close(file)


if __name__ == "__main__":
    if len(sys.argv) < 4 or (os.getpid() == 1 and sys.argv[2] != "-"):  # kill(-1) is for a PID namespace of its own
        sys.exit("this is started by glsim")
    sys.exit(main(*sys.argv[1:]))
