"""Hostile files in bubblewrap: each is contained, gets an honest mark, and the next file is judged as usual."""

from __future__ import annotations

import os
import socket
import sys
from pathlib import Path

import pytest

import glsim
from glsim.course.checking import check
from glsim.course.exercise import exercises
from glsim.course.isolation.bubblewrap import Bubblewrap, works
from tests.course.grading import solution_of

pytestmark = [pytest.mark.slow, pytest.mark.skipif(not works(), reason="bubblewrap does not work here")]
ONE = exercises()[0]
TAMPER = "import glsim, numpy\nnumpy.allclose = numpy.isclose = lambda *a, **k: True\n"
ATTACKS = {
    "endless loop": "while True: pass",
    "fork bomb": "import os\nwhile True:\n    try: os.fork()\n    except OSError: pass",
    "allocation": "x = bytearray(50 << 30)",
    "file": "f = open('/tmp/x', 'wb')\nwhile True: f.write(bytes(1 << 20))",
    "exit": "import os\nos._exit(0)",
    "kill all": "import os\nos.kill(os.getppid(), 9)\nos.kill(-1, 9)",
    "a fake result": 'print(\'{"answers": [{"value": 1}]}\')',
    "tampering": TAMPER,
    "print": "while True: print('x' * (1 << 20))",
    "link": "import os\nos.symlink('/etc/passwd', __file__.replace('work/', 'out/x'))",
    "syntax": "def (",
    "not a text": "x = '\udcff'",
    "daemon": "import os, time\nif not os.fork():\n    os.setsid()\n    if not os.fork(): time.sleep(99)",
}


@pytest.mark.parametrize("name", ATTACKS)
def test_no_points_and_the_next_is_judged(name: str, tmp_path: Path) -> None:
    path, good = tmp_path / "bad.py", tmp_path / "good.py"
    path.write_text(ATTACKS[name], encoding="utf-8", errors="surrogateescape")
    good.write_text(solution_of(ONE), encoding="utf-8")
    assert check(ONE, path, Bubblewrap(), 1.5).points == 0
    result = check(ONE, good, Bubblewrap())
    assert (result.points, result.note) == (ONE.points, "")


PROBE = """\
import ctypes, os, socket, sys
libc = ctypes.CDLL(None, use_errno=True)
done = []
def attempt(name, action):
    try:
        if action() != -1: done.append(name)
    except OSError:
        pass
attempt("write home", lambda: open(os.path.expanduser("~/.bashrc"), "a"))
attempt("write package", lambda: open(sys.argv[1], "a"))
attempt("read secret", lambda: open(sys.argv[2]))
attempt("connect", lambda: socket.create_connection(("127.0.0.1", int(sys.argv[3])), 0.5))
attempt("see parent", lambda: open(f"/proc/{sys.argv[4]}/environ"))
attempt("kill parent", lambda: os.kill(int(sys.argv[4]), 0))
attempt("trace", lambda: libc.ptrace(16, int(sys.argv[4]), 0, 0))
attempt("mount", lambda: libc.mount(b"x", b"/tmp", b"tmpfs", 0, None))
attempt("user namespace", lambda: libc.unshare(0x10000000))
if os.getuid() == 0: done.append("root")
open(sys.argv[5], "w").write("tried:" + ",".join(done))
"""


def test_nothing_outside_is_reached(tmp_path: Path) -> None:
    """Other submissions, the solution, the network, the parent's process, glsim's files, the rights of root."""
    secret = tmp_path / "secret.py"
    secret.write_text("the solution")
    folder = tmp_path / "run"
    (folder / "work").mkdir(parents=True)
    (folder / "out").mkdir()
    (folder / "work" / "probe.py").write_text(PROBE)
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        command = [sys.executable, str(folder / "work" / "probe.py"), str(glsim.__file__), str(secret), str(port),
                   str(os.getpid()), str(folder / "out" / "tried")]  # fmt: skip
        assert Bubblewrap().run(command, folder, 10.0) == ""
    assert (folder / "out" / "tried").read_text() == "tried:"
