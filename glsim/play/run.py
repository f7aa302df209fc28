"""``glsim run``: play a program in a process of its own, and tell what happened.

However the program ends (sys.exit, os._exit, a time limit, a crash), this process continues, the pictures drawn so far
are in the folder, and all processes of the program are ended.  The files that the program's process writes are not
trusted: its report must be JSON with the fields of Record.
"""

from __future__ import annotations

import json
import os
import re
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import asdict, fields, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.files import read_regular, write_atomically
from glsim.play.plan import MADE_BY, PICTURE, Plan, Record
from glsim.play.supervise import Outcome, supervised

if TYPE_CHECKING:
    from glsim.machine.frame import Frame

MOST_REPORT = 1 << 24  # bytes of the report of a run
REPORTABLE = ("running", "ok", "gl-error", "python-error", "no-window")  # the statuses that a run itself can report


def events_from(keys: str, events: str) -> list[str]:
    """--keys and --events as one list.  Raises ValueError for words that are no event."""
    from glsim.glut.loop import EVENTS, key

    listed = [f"key {'space' if letter == ' ' else letter}" for letter in keys] + [
        event.strip() for event in events.split(";") if event.strip()
    ]
    counts = {"key": 1, "special": 1, "mouse": 4, "motion": 2, "passive": 2, "menu": 1, "reshape": 2}
    for event in listed:
        kind, *words = event.split()
        numbers = words[: counts.get(kind, 0)]
        if kind not in EVENTS or len(numbers) < counts.get(kind, 0):
            known = (
                '"key a", "key esc", "special 101", "mouse BUTTON STATE X Y", "motion X Y", "passive X Y", "menu VALUE"'
            )
            raise ValueError(f'--events: events are {known}, "reshape W H" and "tick", not "{event}"')
        if kind == "key":
            try:
                key(words[0])
            except ValueError as error:
                raise ValueError(f'--events "{event}": {error}') from None
            continue
        try:
            list(map(int, numbers))
        except ValueError:
            raise ValueError(f'--events: numbers are needed in "{event}"') from None
    return listed


def run(
    plan: Plan,
    timeout: float | None = 60.0,
    look: Callable[[Frame], object] | None = None,
) -> dict[str, Any]:
    """Play ``plan`` in a child process.  Returns the fields of play.plan.Record as a dictionary.

    status has three further values: "timeout", "interrupted" (by Ctrl-C) and "exit" (the program ended its process
    itself, or crashed).

    With ``plan.count`` what the program prints goes to standard error.  Pictures of an earlier run are removed from the
    folder ``plan.out``.
    timeout: seconds after which the program is stopped; None for never.  look: called with the Frame of the first
    picture, with its calls, if these are no more than ``plan.most_calls`` and there was no error.

    Raises FileNotFoundError for a script that is not there, OSError if the folder for the pictures cannot be made.
    """
    if not Path(plan.script).is_file():
        what = "is a folder; name a Python program" if Path(plan.script).is_dir() else "there is no such file"
        raise FileNotFoundError(f"{plan.script}: {what}")
    if plan.out is not None:
        _prepare(Path(plan.out))
    interrupted = False
    outcome = Outcome(None)
    with tempfile.TemporaryDirectory(prefix="glsim-") as folder:
        script, stack = os.path.abspath(plan.script), os.path.join(folder, "stack.txt")
        plan = replace(
            plan, script=script, result=os.path.join(folder, "result.json"), stack=stack,
            out=os.path.abspath(plan.out) if plan.out else None,
            capture=plan.capture if look is None else os.path.join(folder, "frame"),
            capture_calls=plan.capture_calls or look is not None,
        )  # fmt: skip
        environment = {**os.environ, "PYTHONHASHSEED": "0", "PYTHONUNBUFFERED": "1"}
        root = str(Path(__file__).resolve().parents[2])
        environment["PYTHONPATH"] = os.pathsep.join(filter(None, (root, os.environ.get("PYTHONPATH"))))
        try:
            outcome = supervised(
                [sys.executable, "-P", "-m", "glsim.play.player", json.dumps(asdict(plan))],
                cwd=os.path.dirname(script), environment=environment, stdout=2 if plan.count else None,
                timeout=timeout, scratch=folder,
            )  # fmt: skip
        except KeyboardInterrupt:
            interrupted = True
        record = read_report(plan.result or "")
        line = _hung_at(stack, script) if outcome.timed_out else None
        if look is not None and not interrupted and not record["errors"] and os.path.exists(plan.capture or ""):
            _look_at(plan.capture or "", look)
    written = [name for name in record["pictures"] if plan.out and _is_regular(Path(plan.out) / name)]
    record["pictures"] = written
    if interrupted:
        record["status"] = "interrupted"
        record["notes"].append(f"interrupted; {len(written)} pictures are kept")
    elif outcome.timed_out:
        record["status"] = "timeout"
        where = f", in line {line} of {Path(script).name}" if line else ""
        record["notes"].append(f"stopped after {timeout:g} seconds (--timeout){where}")
    elif record["status"] == "running":
        # os._exit(0) is how many old programs end on Escape
        record["status"] = "ok" if outcome.code == 0 and record["frames"] else "exit"
        record["notes"].append(f"the script ended the process ({_ending(outcome.code)})")
    return record


def _look_at(path: str, look: Callable[[Frame], object]) -> None:
    from glsim.machine import archive

    try:
        frame = archive.load(path)
    except (ValueError, OSError):  # the program's process left something else there
        return
    look(frame)


def _ending(code: int | None) -> str:
    if code is None:
        return "with the process that watched over it"
    return f"signal {-code}" if code < 0 else f"exit code {code}"


def _is_regular(path: Path) -> bool:
    return path.is_file() and not path.is_symlink()


def _prepare(out: Path) -> None:
    """Make the folder for pictures, and delete the pictures of an earlier run from it."""
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OSError(f"--out {out}: the folder cannot be made: {error.strerror}") from None
    from PIL import Image

    for path in out.iterdir():
        if not re.fullmatch(PICTURE, path.name) or not _is_regular(path):
            continue
        try:
            with Image.open(path) as image:
                ours = image.info.get("Software") == MADE_BY
        except (OSError, ValueError, SyntaxError):
            continue
        if ours:
            path.unlink(missing_ok=True)


def read_report(path: str) -> dict[str, Any]:
    """What the process of a program wrote about its run; an empty report if the file has not the fields of
    plan.Record."""
    empty = asdict(Record())
    try:
        report = json.loads(read_regular(path, MOST_REPORT), parse_constant=_no_number)
        _check_report(report)
    except FileNotFoundError:
        return empty
    except (OSError, ValueError, TypeError, KeyError, RecursionError) as error:
        return {**empty, "notes": [f"the program's process left a report that cannot be read: {error}"]}
    return report  # type: ignore[no-any-return]


def _no_number(word: str) -> float:
    raise ValueError(f"{word} is no finite number")


def _check_report(report: Any) -> None:
    """Raises ValueError if a report is not of the form of play.Record."""
    if not isinstance(report, dict) or sorted(report) != sorted(f.name for f in fields(Record)):
        raise ValueError("a report has the fields of Record")
    texts = (*report["pictures"], *report["notes"], *report["calls"])
    counts = (report["frames"], *report["calls"].values())
    if report["status"] not in REPORTABLE or not all(type(text) is str for text in texts):
        raise ValueError("a status and texts are expected")
    if not all(type(count) is int and 0 <= count < 1 << 53 for count in counts):
        raise ValueError("counts are expected")
    if not all(re.fullmatch(PICTURE, name) for name in report["pictures"]):
        raise ValueError("pictures are named frame_000.png and so on")
    for error in report["errors"]:
        if not (type(error["kind"]) is type(error["where"]) is type(error["error"]) is str):
            raise ValueError("errors are texts")
        if error["line"] is not None and type(error["line"]) is not int:
            raise ValueError("a line is a number")


def _hung_at(stack: str, script: str) -> int | None:
    """The innermost line of the script in what faulthandler wrote; None if it wrote nothing of the script."""
    try:
        text = read_regular(stack, 1 << 20).decode("utf-8", "replace")
    except (OSError, ValueError):
        return None
    name = script.encode("ascii", "backslashreplace").decode()
    match = re.search(rf'File "{re.escape(name)}", line (\d+) ', text)
    return int(match[1]) if match else None


# ---------------------------------------------------------------- animations


def check_animation(option: str, target: Path) -> None:
    """Raises ValueError, before the program runs, if --gif or --mp4 (``option``) cannot write the file ``target``."""
    if target.suffix.lower() != f".{option}":
        raise ValueError(f"--{option} {target}: the name must end in .{option}")
    if not target.parent.is_dir():
        raise ValueError(f"--{option} {target}: there is no folder {target.parent}; make it first")
    if option == "mp4":
        _ffmpeg(target)


def _ffmpeg(target: Path) -> Any:
    try:
        return import_module("imageio_ffmpeg")
    except ImportError:
        raise ValueError(
            f"{target}: install glsim with `pip install glsim[video]` to write MP4, or use --gif"
        ) from None


def animate(pictures: Sequence[Path], target: Path, milliseconds: float = 20.0) -> None:
    """The pictures of the first window as an animated GIF, or with imageio-ffmpeg as MP4.

    Raises ValueError if there are none, or if they are too small for MP4.
    """
    from PIL import Image

    if not pictures:
        raise ValueError(f"{target}: there is no picture to animate")
    images = [Image.open(path).convert("RGB") for path in pictures]
    if target.suffix.lower() == ".gif":
        # viewers show no more than 50 pictures a second
        write_atomically(target, lambda name: images[0].save(
            name, save_all=True, append_images=images[1:], duration=max(milliseconds, 20.0), loop=0))  # fmt: skip
        return
    width, height = (length - length % 2 for length in images[0].size)  # players want even sizes
    if not width or not height:
        raise ValueError(f"{target}: pictures of {images[0].width} x {images[0].height} are too small for MP4")
    imageio_ffmpeg = _ffmpeg(target)

    def write(name: Any) -> None:
        writer = imageio_ffmpeg.write_frames(str(name), (width, height), fps=1000.0 / milliseconds)
        writer.send(None)
        for image in images:
            writer.send(image.resize(images[0].size).crop((0, 0, width, height)).tobytes())
        writer.close()

    write_atomically(target, write)
