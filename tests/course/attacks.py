"""Hostile files.  Each but the forgeries defines the right functions first, so that it gets full marks if the attack
does not stand in the way.  RIGHT stands for their text, PARTS for forged answers, SECRET for a file of the teacher.
"""

from __future__ import annotations

from dataclasses import dataclass

ANSWERS = "from pathlib import Path\nout = Path(__file__).parent.parent / 'out'\nanswers = out / 'answers.json'\n"
FORGED = '{"answers": [PARTS], "printed": "", "points": 99, "status": "ok"}'


@dataclass(frozen=True)
class Attack:
    """text: of the file.  hint: words of it if there are no points, "" if there are all.  seconds: that it may run."""

    text: str
    hint: str = ""
    seconds: float = 20.0


NO_ANSWER = "ended its process before it had answered"
ATTACKS = {
    "endless loop": Attack("RIGHT\nwhile True: pass", "stopped after", 2.0),
    "fork bomb": Attack(
        "RIGHT\nimport os, time\nwhile True:\n    try: os.fork()\n    except OSError: time.sleep(0.5)",
        "stopped after", 2.0,
    ),
    "allocation of 50 GB": Attack("RIGHT\nx = bytearray(50 << 30)", "MemoryError"),
    "file of 10 GB": Attack(
        "RIGHT\nimport tempfile\nwith tempfile.TemporaryFile() as file:\n"
        "    for _ in range(10 << 10): file.write(bytes(1 << 20))",
        "OSError",
    ),
    "many files": Attack(
        "RIGHT\nimport tempfile\nfor k in range(3):\n"
        "    with open(f'{tempfile.gettempdir()}/{k}', 'wb') as file: file.write(bytes(40 << 20))",
        "OSError",
    ),
    "printing 1 GB": Attack(
        "RIGHT\nimport os\nfor _ in range(512):\n    print('x' * (1 << 20))\n    os.write(1, bytes(1 << 20))\n"
        "    os.write(2, bytes(1 << 20))"
    ),
    "os._exit(0)": Attack("RIGHT\nimport os\nos._exit(0)", NO_ANSWER),
    "killing all it can": Attack(
        "RIGHT\nimport os\nfor pid in (os.getppid(), -1, 0):\n    try: os.kill(pid, 9)\n    except OSError: pass",
        "ended",
    ),
    "daemon": Attack(
        "RIGHT\nimport os, sys\nif not os.fork():\n    os.setsid()\n    if not os.fork():\n"
        "        os.execve(sys.executable, ['python', '-c', 'import time; time.sleep(60)', 'DAEMON'], {})\n"
        "    os._exit(0)"
    ),
    "a link to right answers": Attack(f"import os\n{ANSWERS}answers.symlink_to('SECRET')\nos._exit(0)", NO_ANSWER),
    "a FIFO as answers": Attack(f"import os\n{ANSWERS}os.mkfifo(answers)\nos._exit(0)", NO_ANSWER),
    "deep folders": Attack(
        f"RIGHT\nimport os\n{ANSWERS}for start in (out, out.parent / 'work'):\n"
        "    try:\n        os.chdir(start)\n        for _ in range(2000):\n            os.mkdir('d')\n"
        "            os.chdir('d')\n    except OSError: pass\nos.chdir('/')"
    ),
}  # fmt: skip
FORGERIES = {  # what becomes of them does not depend on the isolation
    "printing a result": Attack(f"print({FORGED!r})\ndef lambert(N, L): return 1.0", "equally bright"),
    "forging the answers": Attack(f"import os\n{ANSWERS}answers.write_text({FORGED!r})\nos._exit(0)", "no answer came"),
    "a pickle as answers": Attack(
        f"import os, pickle\n{ANSWERS}class Evil:\n    def __reduce__(self): return os.mkdir, ('SECRET-2',)\n"
        "answers.write_bytes(pickle.dumps(Evil()))\nos._exit(0)",
        NO_ANSWER,
    ),
    "deep JSON": Attack(f"import os\n{ANSWERS}answers.write_text('[' * 1000000)\nos._exit(0)", NO_ANSWER),
    "tampering with numpy and glsim": Attack(
        "import numpy, glsim.course.judging as judging\nnumpy.allclose = lambda *a, **k: True\n"
        "judging.agree = lambda *a, **k: True\ndef lambert(N, L): return 1.0\ndef diffuse(I_L, k_d, N, L): return I_L",
        "equally bright",
    ),
    "NaN": Attack("RIGHT\ndef lambert(N, L): return float('nan')\ndef diffuse(*a): return [float('inf')] * 3", "NaN"),
    "syntax error": Attack("RIGHT\ndef (", "SyntaxError"),
    "not UTF-8": Attack("RIGHT\nx = '\udcff'", "SyntaxError"),
}  # fmt: skip

DRAWN = {  # programs that draw; forgeries too
    "picture of the wrong size": Attack("import glsim\nglsim.offscreen(33, 32)", "33 x 32 pixels"),
    "pickle as a Frame": Attack(
        "import atexit, os, sys, json, numpy\nout = json.loads(sys.orig_argv[-1])['capture']\nclass Evil:\n"
        "    def __reduce__(self): return os.mkdir, ('SECRET-2',)\n"
        "numpy.savez(open(out, 'wb'), document=numpy.array([Evil()]), bytes=numpy.array([Evil()]))\nos._exit(0)",
        "draws nothing",
    ),
    "compressed Frame": Attack(
        "import os, sys, json, zipfile\nout = json.loads(sys.orig_argv[-1])['capture']\n"
        "with zipfile.ZipFile(out, 'w', zipfile.ZIP_DEFLATED, compresslevel=1) as file:\n"
        "    for name in ('document.npy', 'bytes.npy'):\n        with file.open(name, 'w') as entry:\n"
        "            for _ in range(64): entry.write(bytes(1 << 20))\nos._exit(0)",
        "draws nothing",
    ),
    "Frame of endless drawing": Attack(
        "import os, sys, json, glsim\nfrom glsim.gl import *\nfrom glsim.machine import archive\n"
        "with glsim.offscreen(32, 32), glsim.capture() as frame:\n    glRectf(-1, -1, 1, 1)\n"
        "frame.packets = frame.packets[:1] * 1_500_000\n"
        "archive.save(frame, json.loads(sys.orig_argv[-1])['capture'])\nos._exit(0)",
        "cannot be drawn again within 5 seconds",
        seconds=5.0,
    ),
}

PROBE = """\
import ctypes, json, os, socket, sys
libc = ctypes.CDLL(None, use_errno=True)
facts = json.loads(sys.argv[1])
done = []
def attempt(name, action):
    try:
        if action() != -1: done.append(name)
    except OSError:
        pass
def udp():
    socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b"x", ("127.0.0.1", facts["udp"]))
def abstract():
    with socket.socket(socket.AF_UNIX) as s: s.connect(facts["abstract"])
def by_handle():  # needs the right to read all files, which root's students have
    handle = (ctypes.c_char * 136)()
    ctypes.memmove(handle, (ctypes.c_uint * 2)(128, 0), 8)
    mount = ctypes.c_int()
    if libc.name_to_handle_at(-100, facts["secret"].encode(), handle, ctypes.byref(mount), 0): return -1
    mounted = os.open(facts["folder"], os.O_RDONLY)
    return os.read(fd, 1) if (fd := libc.open_by_handle_at(mounted, handle, os.O_RDONLY)) >= 0 else -1
attempt("writing the teacher's files", lambda: os.open(facts["home"], os.O_WRONLY))
attempt("writing glsim's files", lambda: os.open(facts["package"], os.O_WRONLY))
attempt("reading other submissions", lambda: open(facts["secret"]))
attempt("reading other submissions", by_handle)
attempt("TCP", lambda: socket.create_connection(("127.0.0.1", facts["tcp"]), 0.5))
attempt("UDP", udp)
attempt("abstract sockets", abstract)
attempt("seeing other processes", lambda: open(f"/proc/{facts['pid']}/cmdline"))
attempt("reading the teacher's environment", lambda: open(f"/proc/{facts['pid']}/environ").read(1))
attempt("signals to other processes", lambda: os.kill(facts["pid"], 0))
attempt("tracing other processes", lambda: libc.ptrace(0x4206, facts["pid"], 0, 0))
attempt("mounting", lambda: libc.mount(b"x", facts["folder"].encode(), b"tmpfs", 0, None))
if os.getuid() == 0: done.append("being root")
open(facts["result"], "w").write(json.dumps(done))
"""
