"""Runs a command and ends it with all the processes that it started: within a time limit, and whatever happens.

Two processes watch.  The caller (``supervised``) starts a supervisor, which is this file run as a program; the
supervisor starts the command.  A command that is stopped by its time limit, by Ctrl-C, or by the death of the caller
takes its children along, also those that moved to another session or were abandoned by their parent.  If the command
stops or kills its supervisor, the caller ends both.  Uses the standard library only, so that it starts in milliseconds.

On Linux all descendants are found; on macOS those of the command's own process group; on Windows the command alone.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import select
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

GRACE = 1.5  # seconds that the supervisor has for what it is asked to do
STACK_SECONDS = 0.1  # seconds after SIGUSR2
POLL_SECONDS = 0.25  # seconds between two looks whether the caller lives
MARK = "GLSIM_RUN"  # variable of the environment that all processes of one run inherit
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36  # linux/prctl.h
LINUX = sys.platform.startswith("linux")


class Outcome(NamedTuple):
    """How a command ended.  code: its exit code, or minus the signal that ended it; None if nobody knows."""

    code: int | None
    timed_out: bool = False


def supervised(
    command: Sequence[str],
    *,
    cwd: str,
    environment: Mapping[str, str],
    stdout: int | None = None,
    stderr: int | None = None,
    timeout: float | None = None,
    scratch: str | None = None,
) -> Outcome:
    """Run ``command`` to its end, at most ``timeout`` seconds; afterwards none of its processes is left.

    stdout, stderr: file descriptors for its output.  scratch: a folder to be removed if the caller is killed.
    When its time is up, the command gets SIGUSR2 and a moment to write down where it is.
    An exception that comes meanwhile, such as KeyboardInterrupt, is raised again when the command has been ended.
    """
    mark = uuid.uuid4().hex
    environment = {**environment, MARK: mark}
    if os.name != "posix":
        return _alone(command, cwd, environment, stdout, stderr, timeout)
    reading, writing = os.pipe()
    order = {"command": list(command), "cwd": cwd, "timeout": timeout, "status": writing, "scratch": scratch}
    supervisor = subprocess.Popen(
        [sys.executable, "-I", "-S", __file__, json.dumps(order)],
        env=environment, stdout=stdout, stderr=stderr, pass_fds=[writing], start_new_session=True,
    )  # fmt: skip
    os.close(writing)
    report: dict[str, Any] = {}
    began = time.monotonic()
    try:
        report = _read_report(reading, None if timeout is None else timeout + GRACE)
    finally:
        if not report:
            supervisor.terminate()
            report = _read_report(reading, GRACE)
        os.close(reading)
        end_family(supervisor.pid, mark)
        supervisor.kill()
        supervisor.wait()
    late = timeout is not None and time.monotonic() - began > timeout
    return Outcome(report.get("code"), bool(report.get("timed_out", late)))


def _read_report(pipe: int, seconds: float | None) -> dict[str, Any]:
    """What the supervisor writes when the command has ended; {} if it says nothing within this time, or dies."""
    limit = None if seconds is None else time.monotonic() + seconds
    text = b""
    while limit is None or time.monotonic() < limit:
        if not select.select([pipe], [], [], 1.0 if limit is None else max(limit - time.monotonic(), 0.0))[0]:
            continue
        part = os.read(pipe, 1000)
        text += part
        if not part or len(text) > 1000:
            break
    try:
        report = json.loads(text)
    except ValueError:
        return {}
    return report if isinstance(report, dict) else {}


def _alone(
    command: Sequence[str],
    cwd: str,
    environment: Mapping[str, str],
    stdout: int | None,
    stderr: int | None,
    timeout: float | None,
) -> Outcome:
    """Without a supervisor: Windows."""
    child = subprocess.Popen(command, cwd=cwd, env=environment, stdout=stdout, stderr=stderr)
    try:
        return Outcome(child.wait(timeout))
    except subprocess.TimeoutExpired:
        return Outcome(None, True)
    finally:
        child.kill()
        child.wait()


# ---------------------------------------------------------------- processes


def end_family(ancestor: int, mark: str) -> None:
    """Kill all descendants of a process and all processes that have the mark; not the process itself, nor this one.

    They are stopped first, so that none starts another one meanwhile.
    """
    stopped: set[int] = set()
    for _ in range(100):  # a fork bomb needs several rounds
        running = set(_family(ancestor, mark)) - stopped
        if not running:
            break
        for pid in running:
            _signal(pid, signal.SIGSTOP)
        stopped |= running
    for pid in stopped:
        _signal(pid, signal.SIGKILL)


def _signal(pid: int, number: int) -> None:
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.kill(pid, number)


def _family(ancestor: int, mark: str) -> Iterator[int]:
    """Living descendants of a process, and whoever has the mark in its environment."""
    parents: dict[int, int] = {}
    words = f"{MARK}={mark}".encode()
    for name in os.listdir("/proc") if LINUX else ():
        if not name.isdigit():
            continue
        with contextlib.suppress(OSError, ValueError, IndexError):  # it has ended meanwhile
            with open(f"/proc/{name}/stat", "rb") as file:
                state, parent = file.read().rpartition(b")")[2].split()[:2]
            if state not in (b"Z", b"X"):
                parents[int(name)] = int(parent)
    for pid in parents:
        if pid in (os.getpid(), ancestor):
            continue
        line = [pid]
        while line[-1] in parents and parents[line[-1]] not in line:
            line.append(parents[line[-1]])
        if ancestor in line or _marked(pid, words):
            yield pid


def _marked(pid: int, words: bytes) -> bool:
    try:
        with open(f"/proc/{pid}/environ", "rb") as file:
            return words in file.read(1 << 20).split(b"\0")
    except OSError:
        return False


def _prctl(option: int, value: int) -> None:
    if LINUX:
        ctypes.CDLL(None).prctl(option, value, 0, 0, 0)


# ---------------------------------------------------------------- the supervisor


def main() -> None:
    """Start the command, wait for it, the time limit, a signal or the caller's death; then end all its processes."""
    order = json.loads(sys.argv[1])
    caller = os.getppid()
    _prctl(PR_SET_CHILD_SUBREAPER, 1)  # abandoned processes become children of the supervisor
    wake, woken = os.pipe()
    os.set_blocking(woken, False)
    signal.set_wakeup_fd(woken, warn_on_full_buffer=False)
    signals: list[int] = []
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, lambda number, frame: signals.append(number))
    signal.signal(signal.SIGCHLD, lambda number, frame: None)
    limit = None if order["timeout"] is None else time.monotonic() + order["timeout"]
    child = subprocess.Popen(
        order["command"], cwd=order["cwd"], start_new_session=True, preexec_fn=lambda: _prctl(PR_SET_PDEATHSIG, 9)
    )
    timed_out = False
    while child.poll() is None and not signals and os.getppid() == caller and not timed_out:
        timed_out = limit is not None and time.monotonic() > limit
        wait = POLL_SECONDS if limit is None else min(POLL_SECONDS, max(limit - time.monotonic(), 0.0))
        if not timed_out and select.select([wake], [], [], wait)[0]:
            os.read(wake, 100)
    if timed_out:
        _signal(child.pid, signal.SIGUSR2)
        time.sleep(STACK_SECONDS)
    if child.poll() is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(child.pid, signal.SIGKILL)
    end_family(os.getpid(), os.environ[MARK])
    code = child.wait()
    if os.getppid() != caller and order["scratch"]:
        from shutil import rmtree

        rmtree(order["scratch"], ignore_errors=True)
    with contextlib.suppress(OSError):
        os.write(order["status"], json.dumps({"code": code, "timed_out": timed_out}).encode())


if __name__ == "__main__":
    main()
