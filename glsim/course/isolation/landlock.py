"""Landlock, Linux's access control that a process lays upon itself and its children, without any rights.

    python -I -S landlock.py RULES COMMAND...

RULES is JSON: {"read": paths, "write": paths, "names": paths}.  From then on this process may read and execute below
the paths of "read", do everything below those of "write", see names below those of "names", use no TCP, and send
signals and connect to abstract sockets only among its own children; then it becomes COMMAND.  What a kernel can
restrict depends on the version of its interface, the ABI: files since 1 (Linux 5.13), truncation since 3, TCP since 4,
signals and sockets since 6 (Linux 6.12).
System calls and numbers: linux/landlock.h, landlock(7).  Uses the standard library only.
"""

from __future__ import annotations

import ctypes
import json
import os
import sys

CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446  # system calls, the same on all architectures
VERSION = 1  # a flag of CREATE_RULESET
PATH_BENEATH = 1  # a type of rule
PR_SET_NO_NEW_PRIVS = 38  # linux/prctl.h
EXECUTE, WRITE_FILE, READ_FILE, READ_DIR, REFER, TRUNCATE, IOCTL_DEV = (1 << n for n in (0, 1, 2, 3, 13, 14, 15))
OF_FILES = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE | IOCTL_DEV  # the others hold for folders only
TCP = 1 << 0 | 1 << 1  # bind, connect
SCOPES = 1 << 0 | 1 << 1  # abstract sockets, signals


class Ruleset(ctypes.Structure):
    _fields_ = (("files", ctypes.c_uint64), ("net", ctypes.c_uint64), ("scopes", ctypes.c_uint64))


class PathBeneath(ctypes.Structure):
    _pack_ = 1
    _fields_ = (("allowed", ctypes.c_uint64), ("folder", ctypes.c_int32))


def _call(number: int, *arguments: object) -> int:
    libc = ctypes.CDLL(None, use_errno=True)
    result: int = libc.syscall(ctypes.c_long(number), *arguments)
    if result < 0:
        raise OSError(ctypes.get_errno(), f"Landlock: {os.strerror(ctypes.get_errno())}")
    return result


def abi() -> int:
    """The version of the kernel's Landlock; 0 if it has none."""
    if not sys.platform.startswith("linux"):
        return 0
    try:
        return _call(CREATE_RULESET, None, ctypes.c_size_t(0), VERSION)
    except OSError:
        return 0


def file_rights(version: int) -> int:
    """All rights concerning files that a version knows."""
    last = REFER if version == 2 else TRUNCATE if version in (3, 4) else IOCTL_DEV if version >= 5 else 1 << 12
    return last * 2 - 1


def restrict(read: list[str], write: list[str], names: list[str]) -> None:
    """Lay the rules upon this process, for ever.  Raises OSError if the kernel has no Landlock."""
    version = abi()
    every = file_rights(version)
    rules = Ruleset(every, TCP if version >= 4 else 0, SCOPES if version >= 6 else 0)
    size = ctypes.c_size_t(24 if version >= 6 else 16 if version >= 4 else 8)
    ruleset = _call(CREATE_RULESET, ctypes.byref(rules), size, 0)
    for paths, rights in ((read, EXECUTE | READ_FILE | READ_DIR), (write, every), (names, READ_DIR)):
        for path in paths:
            folder = os.open(path, os.O_PATH | os.O_CLOEXEC)
            allowed = rights & (every if os.path.isdir(path) else OF_FILES)
            _call(ADD_RULE, ruleset, PATH_BENEATH, ctypes.byref(PathBeneath(allowed, folder)), 0)
            os.close(folder)
    ctypes.CDLL(None).prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    _call(RESTRICT_SELF, ruleset, 0)
    os.close(ruleset)


if __name__ == "__main__":
    restrict(**json.loads(sys.argv[1]))
    os.execvp(sys.argv[2], sys.argv[2:])
