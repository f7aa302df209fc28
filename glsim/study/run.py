"""``glsim run``: play a program in a process of its own, and tell what happened.

The program may end as it likes (sys.exit, os._exit, an endless loop, a crash): this process stays, and what was drawn
until then is there.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import asdict, replace
from importlib import import_module
from pathlib import Path
from typing import Any

from glsim.study.play import Plan


def events_from(keys: str, events: str) -> list[str]:
    """--keys and --events as one list.  Raises ValueError for an event that is none."""
    from glsim.glut.loop import EVENTS

    listed = [f"key {key}" for key in keys] + [event.strip() for event in events.split(";") if event.strip()]
    counts = {"key": 1, "special": 1, "mouse": 4, "motion": 2, "passive": 2, "menu": 1, "reshape": 2}
    for event in listed:
        kind, *words = event.split()
        numbers = words[: counts.get(kind, 0)]
        if kind not in EVENTS or len(numbers) < counts.get(kind, 0):
            known = '"key a", "special 101", "mouse BUTTON STATE X Y", "motion X Y", "passive X Y", "menu VALUE"'
            raise ValueError(f'--events: events are {known}, "reshape W H" and "tick", not "{event}"')
        try:
            list(map(int, numbers if kind != "key" else ()))
        except ValueError:
            raise ValueError(f'--events: numbers are needed in "{event}"') from None
    return listed


def run(plan: Plan, timeout: float | None = 60.0) -> dict[str, Any]:
    """Play ``plan`` in a child process; what happened, as play.Record has it, and "timeout" as a further status.

    With ``plan.count`` what the program prints goes to standard error.
    timeout: seconds after which the program is stopped; None for never.  Raises FileNotFoundError for a script that is
    not there, KeyboardInterrupt after the child was stopped.
    """
    if not Path(plan.script).is_file():
        what = "is a folder; name a Python program" if Path(plan.script).is_dir() else "there is no such file"
        raise FileNotFoundError(f"{plan.script}: {what}")
    if plan.out is not None:
        try:
            Path(plan.out).mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise OSError(f"--out {plan.out}: the folder cannot be made: {error.strerror}") from None
    with tempfile.TemporaryDirectory(prefix="glsim-") as folder:
        result = os.path.join(folder, "result.json")
        words = json.dumps(asdict(replace(plan, script=os.path.abspath(plan.script), result=result,
                                          out=os.path.abspath(plan.out) if plan.out else None)))  # fmt: skip
        environment = {**os.environ, "PYTHONHASHSEED": "0", "PYTHONUNBUFFERED": "1"}
        root = str(Path(__file__).resolve().parents[2])
        environment["PYTHONPATH"] = os.pathsep.join(filter(None, (root, os.environ.get("PYTHONPATH"))))
        child = subprocess.Popen(
            [sys.executable, "-m", "glsim.study.play", words],
            cwd=os.path.dirname(os.path.abspath(plan.script)), env=environment, stdout=2 if plan.count else None,
            start_new_session=True,
        )  # fmt: skip
        timed_out = _wait(child, timeout)
        record = _read(result)
    if timed_out:
        record["status"] = "timeout"
        record["notes"].append(f"stopped after {timeout:g} seconds (--timeout)")
    elif record["status"] == "running":
        ended = f"signal {-child.returncode}" if child.returncode < 0 else f"exit code {child.returncode}"
        # os._exit(0) is how many old programs end on Escape
        record["status"] = "ok" if child.returncode == 0 and record["frames"] else "exit"
        record["notes"].append(f"the script ended the process ({ended})")
    return record


def _wait(child: subprocess.Popen[bytes], timeout: float | None) -> bool:
    """Whether the time was up.  Stops the child then, and when it is interrupted."""
    try:
        child.wait(timeout)
    except subprocess.TimeoutExpired:
        _stop(child)
        return True
    except KeyboardInterrupt:
        _stop(child)
        raise
    return False


def _stop(child: subprocess.Popen[bytes]) -> None:
    with contextlib.suppress(ProcessLookupError):
        if hasattr(os, "killpg"):
            os.killpg(child.pid, signal.SIGKILL)
        else:
            child.kill()
    child.wait()


def _read(path: str) -> dict[str, Any]:
    try:
        record: dict[str, Any] = json.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        record = {"status": "running", "frames": 0, "pictures": [], "errors": [], "notes": [], "calls": {}}
    return record


def animate(pictures: Sequence[Path], target: Path, milliseconds: float = 20.0) -> None:
    """The pictures of the first window as an animated GIF, or with imageio-ffmpeg as MP4."""
    from PIL import Image

    from glsim.files import write_atomically

    if not pictures:
        raise ValueError(f"{target}: there is no picture to animate")
    images = [Image.open(path).convert("RGB") for path in pictures]
    if target.suffix.lower() == ".gif":
        # viewers show no more than 50 pictures a second
        write_atomically(target, lambda name: images[0].save(
            name, save_all=True, append_images=images[1:], duration=max(milliseconds, 20.0), loop=0))  # fmt: skip
        return
    try:
        imageio_ffmpeg: Any = import_module("imageio_ffmpeg")
    except ImportError:
        raise ValueError(
            f"{target}: install glsim with `pip install glsim[video]` to write MP4, or use --gif"
        ) from None

    def write(name: Any) -> None:
        # players want even sizes
        width, height = (length - length % 2 for length in images[0].size)
        writer = imageio_ffmpeg.write_frames(str(name), (width, height), fps=1000.0 / milliseconds)
        writer.send(None)
        for image in images:
            writer.send(image.resize(images[0].size).crop((0, 0, width, height)).tobytes())
        writer.close()

    write_atomically(target, write)
