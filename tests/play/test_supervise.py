"""Programs that do not want to end, or that write what they should not: nothing of them stays, and no harm is done."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest

from glsim.cli import main
from glsim.play.run import read_report
from glsim.play.supervise import LINUX, supervised

pytestmark = [
    pytest.mark.slow,  # each test runs programs in processes of their own
    pytest.mark.skipif(not LINUX, reason="processes are looked up in /proc"),
]


def alive(word: str) -> list[int]:
    """Processes, but for zombies, whose command line has a word."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            line = Path(f"/proc/{name}/cmdline").read_bytes()
            state = Path(f"/proc/{name}/stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            continue
        if word.encode() in line and state != "Z":
            found.append(int(name))
    return found


def gone(word: str, seconds: float = 5.0) -> bool:
    limit = time.monotonic() + seconds
    while alive(word) and time.monotonic() < limit:
        time.sleep(0.05)
    return not alive(word)


def play(source: str, timeout: float) -> tuple[float, object]:
    began = time.monotonic()
    outcome = supervised(
        [sys.executable, "-c", textwrap.dedent(source)], cwd=os.getcwd(), environment=os.environ, timeout=timeout
    )
    return time.monotonic() - began, outcome


# each has the word MARK in the command line of whatever it starts
STUBBORN = {
    "a loop without end": "while True: pass  # MARK",
    "a daemon": """
        import os, time  # MARK
        if os.fork() == 0:
            os.setsid()
            if os.fork() == 0:
                time.sleep(60)
            os._exit(0)
        time.sleep(60)
        """,
    "a daemon with an empty environment": """
        import os, time  # MARK
        os.execve("/bin/sh", ["sh", "-c", "setsid sleep 60 & : MARK; sleep 60"], {})
        """,
    "one that stops its parent": """
        import os, signal, time  # MARK
        os.kill(os.getppid(), signal.SIGSTOP)
        time.sleep(60)
        """,
    "one that kills its parent and leaves a child": """
        import os, signal, time  # MARK
        if os.fork() == 0:
            os.setsid()
            time.sleep(60)
        os.kill(os.getppid(), signal.SIGKILL)
        time.sleep(60)
        """,
    "one that starts others without end": """
        import os, time  # MARK
        for k in range(300):
            if os.fork() == 0:
                time.sleep(60)
        time.sleep(60)
        """,
}


@pytest.mark.parametrize("what", STUBBORN)
def test_nothing_of_it_stays(what: str) -> None:
    mark = f"mark{os.getpid()}x{len(what)}"
    seconds, outcome = play(STUBBORN[what].replace("MARK", mark), timeout=0.7)
    assert seconds < 6.0
    assert outcome.code != 0  # type: ignore[attr-defined]
    assert gone(mark)


def test_children_do_not_outlive_a_program_that_ends() -> None:
    seconds, outcome = play("import os, time  # left99\nif os.fork() == 0: time.sleep(60)\n", timeout=30)
    assert outcome == (0, False)
    assert seconds < 5.0
    assert gone("left99")


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGKILL, signal.SIGINT])
def test_the_program_ends_with_glsim_run(tmp_path: Path, number: signal.Signals) -> None:
    script = tmp_path / "loop.py"
    script.write_text("open('here', 'w').close()\nwhile True: pass\n")
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    glsim = subprocess.Popen(
        [sys.executable, "-m", "glsim", "run", str(script), "--out", str(tmp_path / "out")],
        env={**os.environ, "TMPDIR": str(temporary)}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    limit = time.monotonic() + 20
    while not (tmp_path / "here").exists() and time.monotonic() < limit:
        time.sleep(0.05)
    glsim.send_signal(number)
    assert glsim.wait(10) == {signal.SIGINT: 130, signal.SIGKILL: -9}.get(number, 128 + number)
    assert gone(str(script))
    limit = time.monotonic() + 5
    while list(temporary.iterdir()) and time.monotonic() < limit:
        time.sleep(0.05)
    assert not list(temporary.iterdir())


# ---------------------------------------------------------------- what the program's process writes

REPORT = '{"status": "ok", "frames": 3, "pictures": [], "errors": [], "notes": [], "calls": {}}'


def forger(folder: Path, write: str) -> str:
    script = folder / "forger.py"
    script.write_text(
        "import json, os, sys\nplan = json.loads(sys.orig_argv[-1])\npath = plan['result']\n"
        f"if os.path.exists(path): os.remove(path)\n{write}\nos._exit(0)\n"
    )
    return str(script)


FORGED: dict[str, str] = {
    "a FIFO": "os.mkfifo(path)",
    "a link": "os.symlink('/etc/passwd', path)",
    "a device": "os.symlink('/dev/zero', path)",
    "a folder": "os.mkdir(path)",
    "gigabytes": "open(path, 'w').truncate(10**10)",
    "a list": "open(path, 'w').write('[]')",
    "not JSON": "open(path, 'w').write('{')",
    "NaN": f"open(path, 'w').write('''{REPORT}'''.replace('3', 'NaN'))",
    "a deep list": "open(path, 'w').write('[' * 100000)",
    "other fields": f"open(path, 'w').write('''{REPORT}'''.replace('calls', 'call'))",
    "a picture elsewhere": f"open(path, 'w').write('''{REPORT}'''.replace('[]', '[\"../../etc/passwd\"]', 1))",
    "a status of its own": f"open(path, 'w').write('''{REPORT}'''.replace('ok', 'perfect'))",
    "texts for numbers": f"open(path, 'w').write('''{REPORT}'''.replace('3', '\"3\"'))",
}


@pytest.mark.parametrize("what", FORGED)
def test_a_forged_report_is_not_believed(what: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    script = forger(tmp_path, FORGED[what])
    assert main(["run", script, "--json", "--timeout", "20", "--out", str(tmp_path / "out")]) == 1
    record = json.loads(capfd.readouterr().out)
    assert record["status"] == "exit"
    assert any("report that cannot be read" in note for note in record["notes"])


def test_pictures_that_are_not_there_are_not_listed(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    script = forger(tmp_path, f"open(path, 'w').write('''{REPORT}'''.replace('[]', '[\"frame_007.png\"]', 1))")
    main(["run", script, "--json", "--out", str(tmp_path / "out")])
    assert json.loads(capfd.readouterr().out)["pictures"] == []


def test_without_a_report_nothing_is_claimed(tmp_path: Path) -> None:
    assert read_report(str(tmp_path / "none"))["status"] == "running"


READERS: dict[str, list[str]] = {
    "probe": ["1", "1"], "terms": ["-o", "terms.png"], "explain": [], "trace": [], "compare": ["--modes", "native"],
    "radiosity": ["-o", "room.png"],
}  # fmt: skip
PICKLE = """
import json, os, pickle, sys
plan = json.loads(sys.orig_argv[-1])
class Payload:
    def __reduce__(self):
        return os.mkdir, (os.path.join(os.path.dirname(os.path.abspath(plan["script"])), f"by_{os.getpid()}"),)
data = pickle.dumps(Payload())
for name in ("capture", "result"):
    if plan[name]:
        open(plan[name], "wb").write(data)
report = {"status": "ok", "frames": 1, "pictures": [], "errors": [], "notes": [], "calls": {}}
json.dump(report, open(plan["result"], "w"))
os._exit(0)
"""


@pytest.mark.parametrize("command", READERS)
def test_nothing_that_a_program_wrote_is_executed(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    script = tmp_path / "payload.py"
    script.write_text(PICKLE)
    monkeypatch.chdir(tmp_path)
    assert main([command, str(script), *READERS[command]]) == 1
    assert "is no Frame that glsim wrote" in capfd.readouterr().err
    assert not list(tmp_path.glob("by_*"))
