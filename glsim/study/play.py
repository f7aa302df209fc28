"""Playing an unmodified GLUT program in this process: the child of ``glsim run``.

Time stands still within a step, random numbers begin the same, and each step's pictures go to files.
"""

from __future__ import annotations

import json
import os
import pickle
import random
import sys
import time
import traceback
import types
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from glsim.files import write_atomically
from glsim.glut.loop import FinishedError, Loop, StepClock, loop
from glsim.glut.screen import Screen, open_windows
from glsim.glut.window import Window
from glsim.machine.frame import Draw, Frame
from glsim.machine.record import Recorder
from glsim.study import alias, toolkits
from glsim.study.frames import needed
from glsim.study.python2 import ConversionError, compiled, convert_modules, is_python_3, prepare

MOST_ERRORS = 5  # a program that fails so often is stopped
PATIENCE = 1.0  # seconds
MONOTONIC = time.monotonic  # the time module may be replaced
EPOCH = 1_000_000_000.0  # what time.time() says at the start, in seconds


@dataclass
class Plan:
    """What to play, and how: one field for each option of ``glsim run``."""

    script: str
    arguments: list[str] = field(default_factory=list)
    out: str | None = None
    frames: int = 1
    events: list[str] = field(default_factory=list)
    size: tuple[int, int] | None = None
    shade: str | None = None
    lobe: str | None = None
    window: bool = False
    real_time: bool = False
    count: bool = False
    python2: bool = True
    result: str | None = None
    capture: str | None = None  # a file for the last picture's Frame
    capture_calls: bool = False


@dataclass
class Record:
    """What happened: the line of JSON that ``glsim run --json`` prints."""

    status: str = "running"
    frames: int = 0
    pictures: list[str] = field(default_factory=list)
    errors: list[dict[str, Any]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    calls: dict[str, int] = field(default_factory=dict)


class Player:
    """One run of a program."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.record = plan, Record()
        self.screen: Screen | None = None
        self.saved = MONOTONIC()
        self.frame: Frame | None = None  # what the first window draws, with plan.capture
        self.swapped = 0, 0  # its packets and calls at the last swap
        self.script = str(Path(plan.script).resolve())

    def play(self) -> Record:
        """Run the program to its end or to the last step."""
        plan = self.plan
        self.screen = open_windows(loop) if plan.window else None
        if not plan.real_time:
            clock = StepClock()
            loop.clock = clock
            freeze_time(clock)
            random.seed(0)
            np.random.seed(0)
        loop.events, loop.fixed_size = plan.events, plan.size
        loop.steps = None if plan.window and plan.frames == 1 else plan.frames
        loop.on_swap = self._swapped
        loop.on_open, loop.on_step, loop.on_error = self._opened, self._after_step, self._failed
        toolkits.adopt(loop, plan.window)
        alias.install(self._counted if plan.count else None)
        try:
            self._execute()
            if loop.windows and loop.step == 0 and not self.record.errors:
                self.record.notes.append("the script ended without glutMainLoop")
                loop.one_step()
        except FinishedError:
            pass
        self._finish()
        return self.record

    def _execute(self) -> None:
        try:
            code = self._compiled()
        except (SyntaxError, ConversionError, OSError, ValueError) as error:
            self._failed("reading", error)
            return
        sys.argv = [self.script, *self.plan.arguments]
        sys.path[0:0] = [os.path.dirname(self.script)]
        main = types.ModuleType("__main__")
        main.__file__ = self.script
        sys.modules["__main__"] = main
        try:
            exec(code, main.__dict__)
        except SystemExit as leaving:
            self.record.notes.append("the script called sys.exit")
            if leaving.code not in (None, 0):
                print(leaving.code, file=sys.stderr)
        except Exception as error:
            self._failed("script", error)

    def _compiled(self) -> types.CodeType:
        source = Path(self.script).read_bytes()
        if self.plan.python2:
            convert_modules(os.path.dirname(self.script))
        if self.plan.python2 and not is_python_3(source, self.script):
            code = compiled(source, self.script)
            prepare()
            loop.text_keys = True
            self.record.notes.append("converted from Python 2 (--no-python2 switches that off)")
            print(f"glsim run: {self.plan.script} is Python 2: converted in memory", file=sys.stderr)
            return code
        return compile(source, self.script, "exec")

    # ------------------------------------------------------------ what the loop reports

    def _counted(self, name: str, function: Any) -> Any:
        calls = self.record.calls

        def counting(*arguments: Any, **named: Any) -> Any:
            calls[name] = calls.get(name, 0) + 1
            return function(*arguments, **named)

        return counting

    def _failed(self, where: str, error: Exception) -> None:
        """An exception of the script, shown as the script's own, with its line."""
        frames = [f for f in traceback.extract_tb(error.__traceback__) if not _is_ours(f.filename)]
        print("".join(["Traceback (most recent call last):\n", *traceback.format_list(frames),
                       *traceback.format_exception_only(error)]), file=sys.stderr, end="")  # fmt: skip
        line = next((f.lineno for f in reversed(frames) if f.filename == self.script), getattr(error, "lineno", None))
        kind = "gl-error" if any(c.__name__ == "GLError" for c in type(error).__mro__) else "python-error"
        self.record.errors.append(
            {"kind": kind, "where": where, "line": line, "error": f"{type(error).__name__}: {error}"[:400]}
        )
        if len(self.record.errors) >= MOST_ERRORS:
            loop.left = True

    def _opened(self, window: Window) -> None:
        machine = window.screen.machine
        machine.change = reshaded(self.plan.shade, self.plan.lobe)
        if self.plan.capture is not None and self.frame is None:
            self.frame = machine.capturing = Frame(*window.asked)
            if self.plan.capture_calls:
                machine.record(Recorder(machine, self.frame))

    def _swapped(self, window: Window) -> None:
        """Within a step that takes long, or never ends, pictures are kept now and then."""
        if self.frame is not None and window.screen.machine.capturing is self.frame:
            self.frame.packets[:] = needed(self.frame.packets)
            self.swapped = len(self.frame.packets), len(self.frame.calls)
        now = MONOTONIC()
        if now - self.saved > PATIENCE:
            self.saved = now
            if self.plan.out is not None and window.shown is not None and window is next(iter(loop.windows.values())):
                name = f"frame_{loop.step:03d}.png"
                self._keep(window.shown, name)
                self.record.frames = max(self.record.frames, loop.step + 1)
                self._report()

    def _after_step(self, played: Loop) -> None:
        for order, window in enumerate(played.windows.values()):
            if self.plan.out is not None and window.shown is not None:
                suffix = "" if order == 0 else f"_w{order + 1}"
                name = f"frame_{played.step - 1:03d}{suffix}.png"
                self._keep(window.shown, name)
        self.saved = MONOTONIC()
        if self.frame is not None and played.step == max(played.steps or 1, 1 + len(played.events)):
            self._keep_frame(self.frame)
        if self.screen is not None:
            self.screen.after_step(played)
        self.record.frames = played.step
        self.record.notes += played.notes
        played.notes = []
        self._report()

    def _keep(self, picture: Any, name: str) -> None:
        from PIL import Image

        write_atomically(Path(self.plan.out or ".") / name, lambda place: Image.fromarray(picture).save(place))
        if name not in self.record.pictures:
            self.record.pictures.append(name)

    def _keep_frame(self, frame: Frame) -> None:
        """Write the Frame that is shown to plan.capture: of a double-buffered window what was drawn before the swap."""
        window = next((w for w in loop.windows.values() if w.screen.machine.capturing is frame), None)
        if window is None or self.plan.capture is None:
            return
        packets, calls = self.swapped if window.double and self.swapped[0] else (None, None)
        frame.width, frame.height = window.screen.width, window.screen.height
        shown = replace(frame, packets=needed(frame.packets[:packets]), calls=frame.calls[:calls])
        write_atomically(self.plan.capture, lambda name: Path(name).write_bytes(pickle.dumps(shown)))

    def _finish(self) -> None:
        record = self.record
        kinds = {error["kind"] for error in record.errors}
        if self.frame is not None and self.plan.capture is not None and not os.path.exists(self.plan.capture):
            self._keep_frame(self.frame)  # the program ended before the last step
        if kinds:
            record.status = "gl-error" if "gl-error" in kinds else "python-error"
        else:
            record.status = "ok" if record.frames else "no-window"
        self._report()

    def _report(self) -> None:
        if self.plan.result is not None:
            text = json.dumps(asdict(self.record))
            write_atomically(self.plan.result, lambda name: Path(name).write_text(text, encoding="utf-8"))


HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def _is_ours(filename: str) -> bool:
    return filename.startswith((HERE, "<gl command", "<frozen"))


def reshaded(shade: str | None, lobe: str | None) -> Callable[[Draw], Draw] | None:
    """What gives a Draw this mode of study.compare and this lobe, whatever the program says; None if it keeps both."""
    if shade is None and lobe is None:
        return None
    from glsim.study.compare import LOBE, shaded

    def change(draw: Draw) -> Draw:
        if shade is None:
            lighting = draw.state.lighting._replace(lobe=LOBE[lobe or "blinn"])
            return draw.with_state(draw.state._replace(lighting=lighting))
        mode = "gouraud" if shade == "smooth" else shade
        return next(shaded(Frame(0, 0, [draw]), mode, lobe or "blinn").draws)

    return change


def freeze_time(clock: StepClock) -> None:
    """The time module and datetime follow the clock of the steps."""
    import datetime

    real = {name: getattr(time, name) for name in ("gmtime", "localtime", "ctime", "strftime")}

    def seconds() -> float:
        return clock.now() / 1000.0

    def now() -> float:
        return EPOCH + seconds()

    time.time = now
    time.time_ns = lambda: int(now() * 1e9)
    time.perf_counter = time.monotonic = time.process_time = seconds
    time.sleep = lambda s, /: clock.advance(float(s) * 1000.0)
    for name in ("gmtime", "localtime", "ctime"):
        setattr(time, name, lambda s=None, f=real[name]: f(now() if s is None else s))
    time.strftime = lambda form, t=None: real["strftime"](form, time.localtime() if t is None else t)

    class Datetime(datetime.datetime):
        @classmethod
        def now(cls, tz: Any = None) -> Any:
            return cls.fromtimestamp(time.time(), tz)

        today = utcnow = now

    datetime.datetime = Datetime  # type: ignore[misc]


def main() -> None:
    """python -m glsim.study.play PLAN, with the plan as JSON."""
    given = json.loads(sys.argv[1])
    if given.get("size"):
        given["size"] = tuple(given["size"])
    try:
        Player(Plan(**given)).play()
    except RuntimeError as error:  # no display, no graphics library
        print(f"glsim run: {error}", file=sys.stderr)
        sys.stderr.flush()
        os._exit(1)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
