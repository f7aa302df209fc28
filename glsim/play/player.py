"""Playing an unmodified GLUT program in this process: the child of ``glsim run``.

Time stands still within a step, random numbers begin the same, and each step's pictures go to files.
"""

from __future__ import annotations

import faulthandler
import json
import math
import os
import signal
import sys
import time
import traceback
import types
from dataclasses import asdict, replace
from importlib import import_module
from importlib.machinery import SourceFileLoader
from pathlib import Path
from typing import Any

import glsim
from glsim.files import write_atomically
from glsim.glut.display import Display, open_windows
from glsim.glut.loop import FinishedError, Loop, StepClock, loop
from glsim.glut.window import Window, flushed, picture_of
from glsim.machine import archive
from glsim.machine.frame import Frame
from glsim.machine.record import Recorder
from glsim.names import hint_for
from glsim.play import pyopengl, toolkits
from glsim.play.imports import OwnImports, repeatable_chance, steady_time
from glsim.play.plan import MADE_BY, Plan, Record
from glsim.play.python2 import ConvertingLoader, compiled_program
from glsim.play.reshade import needed, reshaded
from glsim.render.context import Offscreen, offscreen

MOST_ERRORS = 5  # a program that fails so often is stopped
MOST_SCREENS = 16  # of glsim.offscreen whose pictures are kept
MOST_VERTICES = 20  # of the first picture, for each of Plan.most_calls
MOST_PACKETS = 1 << 15  # of a picture, that are kept for clicks
PATIENCE = 1.0  # seconds between two pictures that are saved within one step


class Player:
    """One run of a program."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.record = plan, Record()
        self.display: Display | None = None
        self.last_save = -PATIENCE  # seconds: the first swap is saved at once
        self.frame: Frame | None = None  # what the first window draws, with plan.capture
        self.screens = 0  # that the program opened with glsim.offscreen
        self.unsaved_screens: dict[int, Offscreen] = {}
        self.lengths_at_swap = 0, 0  # of self.frame.packets and .calls, at the last swap
        self.script = str(Path(plan.script).resolve())

    def play(self) -> Record:
        """Run the program to its end or to the last step."""
        plan = self.plan
        self.display = open_windows(loop, self._clicked) if plan.window else None
        loop.events, loop.fixed_size = plan.events, plan.size
        loop.steps = None if plan.window and plan.frames == 1 else plan.frames
        loop.on_swap = self._on_swap
        loop.on_open, loop.on_step, loop.on_error = self._on_open, self._on_step, self._on_error
        glsim.offscreen = self._offscreen
        pyopengl.install(self._counting if plan.count else None)
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
            code, python2 = compiled_program(Path(self.script).read_bytes(), self.script, self.plan.python2)
        except (SyntaxError, OSError, ValueError) as error:
            self._on_error("reading", error)
            return
        if python2:
            loop.text_keys = True
            self.record.notes.append("converted from Python 2 (--no-python2 switches that off)")
            print(f"glsim run: {self.plan.script} is Python 2: converted in memory", file=sys.stderr)
        stand_ins: dict[str, types.ModuleType] = {}
        if not self.plan.real_time:
            clock = loop.clock = StepClock()
            stand_ins = steady_time(lambda: clock.now() / 1000.0, lambda s: clock.advance(1000.0 * s), python2)
            repeatable_chance()
        if self.plan.count:
            stand_ins |= pyopengl.counted_libraries(self._counting)
        toolkits.adopt(loop, self.plan.window)
        loader = ConvertingLoader if self.plan.python2 else SourceFileLoader
        OwnImports(os.path.dirname(self.script), stand_ins, loader).install()
        sys.argv = [self.script, *self.plan.arguments]
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
            self._on_error("script", error)

    # ------------------------------------------------------------ programs that draw into glsim.offscreen

    def _offscreen(self, width: int, height: int, **named: Any) -> Offscreen:
        """Replaces glsim.offscreen in the program: pictures of its screens are saved if the program opens no window."""
        screen = offscreen(width, height, **named)
        self.screens += 1
        if self.screens <= MOST_SCREENS:
            number, release = self.screens, screen.release

            def keep_and_release() -> None:
                self._show(number, screen)
                release()

            self.unsaved_screens[number] = screen
            screen.release = keep_and_release  # type: ignore[method-assign]
            self._watch(screen, (width, height))
        return screen

    def _show(self, number: int, screen: Offscreen) -> None:
        """Save the picture, and the Frame, of screen ``number`` once: when the program releases it, or ends."""
        if self.unsaved_screens.pop(number, None) is None or loop.windows:
            return
        machine = screen.machine
        if machine.outlet.frame is not None and machine.outlet.frame is self.frame:
            self._save_frame(self.frame, screen)
        if self.plan.out is not None:
            self._save_picture(picture_of(screen, screen.width, screen.height), _name(0, number))
        self.record.frames = 1

    # ------------------------------------------------------------ what the loop reports

    def _counting(self, name: str, function: Any) -> Any:
        calls = self.record.calls

        def counted(*arguments: Any, **named: Any) -> Any:
            calls[name] = calls.get(name, 0) + 1
            return function(*arguments, **named)

        return counted

    def _on_error(self, where: str, error: Exception) -> None:
        """An exception of the script, shown as the script's own, with its line."""
        hint = hint_for(error)
        frames = [f for f in traceback.extract_tb(error.__traceback__) if not _is_glsims(f.filename)]
        print("".join(["Traceback (most recent call last):\n", *traceback.format_list(frames),
                       *traceback.format_exception_only(error)]), file=sys.stderr, end="")  # fmt: skip
        if hint:
            print(f"glsim run: {hint.removeprefix('; ')}", file=sys.stderr)
        line = next((f.lineno for f in reversed(frames) if f.filename == self.script), getattr(error, "lineno", None))
        sentence = "; ".join([f"{type(error).__name__}: {error}{hint}", *getattr(error, "__notes__", [])])
        kind = "gl-error" if any(c.__name__ == "GLError" for c in type(error).__mro__) else "python-error"
        self.record.errors.append({"kind": kind, "where": where, "line": line, "error": sentence[:400]})
        if len(self.record.errors) >= MOST_ERRORS:
            loop.left = True

    def _on_open(self, window: Window) -> None:
        if len(loop.windows) == 1:
            self.frame = None  # drop the Frame of a glsim.offscreen screen: windows take precedence
        self._watch(window.screen, window.asked)

    def _watch(self, screen: Offscreen, size: tuple[int, int]) -> None:
        """Shade what a new context draws as the plan says, and capture what the first one draws."""
        machine = screen.machine
        machine.outlet.change = reshaded(self.plan.shade, self.plan.lobe)
        if self.plan.capture is not None and self.frame is None:
            self.frame = machine.outlet.frame = Frame(*size)
            if self.plan.capture_calls:
                most = math.inf if self.plan.most_calls is None else self.plan.most_calls
                machine.record(Recorder(machine, self.frame, most))
        elif self.plan.clicked is not None:
            machine.outlet.frame = Frame(*size)

    def _on_swap(self, window: Window) -> None:
        """Called at each buffer swap: saves the picture if the last was saved more than PATIENCE seconds ago, so that a
        step that never ends leaves pictures too.  Also notes how much of the Frame is visible."""
        if self.frame is not None and window.screen.machine.outlet.frame is self.frame:
            self.frame.packets[:] = needed(self.frame.packets)
            self.lengths_at_swap = len(self.frame.packets), len(self.frame.calls)
        now = time.monotonic()
        if now - self.last_save > PATIENCE:
            self.last_save = now
            if self.plan.out is not None and window.shown is not None and window is next(iter(loop.windows.values())):
                self._save_picture(window.shown, _name(loop.step, 1))
                self.record.frames = max(self.record.frames, loop.step + 1)
                self._report()

    def _check_ended(self, window: Window) -> None:
        """A step is over: glEnd must have come, or nothing that the program draws from now on is seen."""
        mode = window.screen.machine.inside
        if mode is not None and not self.record.errors:
            sentence = f"glBegin({mode!r}) is never ended: glEnd is missing before the buffers are swapped"
            print(f"glsim run: {sentence}", file=sys.stderr)
            self.record.errors.append({"kind": "gl-error", "where": "display", "line": None, "error": sentence})

    def _on_step(self, played: Loop) -> None:
        for order, window in enumerate(played.windows.values(), 1):
            self._check_ended(window)
            if self.plan.out is not None and window.shown is not None:
                self._save_picture(window.shown, _name(played.step - 1, order))
        self.last_save = time.monotonic()
        first = self.plan.most_calls is not None
        if self.frame is not None and self.plan.capture_each:
            self._save_frame(self.frame, suffix=f"-{played.step - 1}")
        if self.frame is not None and played.step == (1 if first else max(played.steps or 1, 1 + len(played.events))):
            self._save_frame(self.frame)
            if first:
                self._stop_recording(self.frame)
        if self.plan.clicked is not None:
            for window in played.windows.values():
                self._trim(window)
        if self.display is not None:
            self.display.after_step(played)
        self.record.frames = played.step
        self.record.notes += played.notes
        played.notes = []
        self._report()

    def _stop_recording(self, frame: Frame) -> None:
        """The first picture is done.  For clicks the packets are collected on; where recording was given up, the window
        is drawn again for that."""
        for window in loop.windows.values():
            machine = window.screen.machine
            if machine.outlet.frame is frame:
                if isinstance(machine.recorder, Recorder):  # a display list may be open
                    machine.record(None)
                machine.outlet.frame = frame if self.plan.clicked is not None else None
            elif machine.outlet.frame is None and self.plan.clicked is not None:
                machine.outlet.frame, window.dirty = Frame(*window.asked), True
        self.frame = None

    # ------------------------------------------------------------ clicks

    def _trim(self, window: Window) -> None:
        """Keep only the packets of the picture that is shown; none if the program never clears its picture."""
        frame = window.screen.machine.outlet.frame
        if frame is not None and frame is not self.frame:
            frame.packets[:] = needed(frame.packets)
            if len(frame.packets) > MOST_PACKETS:
                frame.packets.clear()

    def _clicked(self, window: Window, x: int, y: int) -> None:
        """A pixel of a real window was clicked: tell the function that the plan names."""
        frame = window.screen.machine.outlet.frame
        if self.plan.clicked is None or frame is None:
            return
        module, _, name = self.plan.clicked.partition(":")
        flushed(window.screen)
        shown = replace(frame, packets=needed(frame.packets), width=window.screen.width, height=window.screen.height)
        getattr(import_module(module), name)(shown, x, y)

    def _save_picture(self, picture: Any, name: str) -> None:
        from PIL import Image
        from PIL.PngImagePlugin import PngInfo

        facts = PngInfo()
        facts.add_text("Software", MADE_BY)
        image = Image.fromarray(picture)
        try:
            write_atomically(Path(self.plan.out or ".") / name, lambda path: image.save(path, pnginfo=facts))
        except OSError as error:  # the disk is full, say
            sentence = f"{name} cannot be written to {self.plan.out}: {error.strerror}"
            self.record.errors.append({"kind": "python-error", "where": "writing", "line": None, "error": sentence})
            loop.left = True
            return
        if name not in self.record.pictures:
            self.record.pictures.append(name)

    def _save_frame(self, frame: Frame, screen: Offscreen | None = None, suffix: str = "") -> None:
        """Write the Frame of the visible picture to plan.capture; of a double-buffered window up to its last swap.

        screen: the one it was drawn on, if that is a screen of glsim.offscreen; None for a window.  suffix: of the
        file's name.
        """
        window = next((w for w in loop.windows.values() if w.screen.machine.outlet.frame is frame), None)
        screen = window.screen if window is not None else screen
        if screen is None or self.plan.capture is None:
            return
        if window is None:
            flushed(screen)
        packets, calls = self.lengths_at_swap if window and window.double and self.lengths_at_swap[0] else (None, None)
        frame.width, frame.height = screen.width, screen.height
        unswapped = window is not None and window.double and not window.swapped
        shown = replace(frame, packets=needed(frame.packets[:packets]), calls=frame.calls[:calls], unswapped=unswapped)
        most = self.plan.most_calls
        count = sum(draw.count for draw in shown.draws)
        if most is None or (shown.history and count <= MOST_VERTICES * most):  # without history recording was given up
            archive.save(shown, self.plan.capture + suffix)

    def _finish(self) -> None:
        record = self.record
        if self.frame is not None and self.plan.capture is not None and not os.path.exists(self.plan.capture):
            self._save_frame(self.frame)  # the program ended before the last step
        if self.plan.window and self.unsaved_screens and not loop.windows:
            record.notes.append("--window shows the windows of GLUT; this program draws into glsim.offscreen")
        for number, screen in list(self.unsaved_screens.items()):
            self._show(number, screen)
        if self.screens > MOST_SCREENS and not loop.windows:
            record.notes.append(f"pictures of the first {MOST_SCREENS} of {self.screens} screens are kept")
        kinds = {error["kind"] for error in record.errors}
        if kinds:
            record.status = "gl-error" if "gl-error" in kinds else "python-error"
        else:
            record.status = "ok" if record.frames else "no-window"
        self._report()

    def _report(self) -> None:
        if self.plan.result is not None:
            text = json.dumps(asdict(self.record))
            write_atomically(self.plan.result, lambda name: Path(name).write_text(text, encoding="utf-8"))


def _name(step: int, window: int) -> str:
    """The file name of the picture of a window, counted from 1, after a step."""
    return f"frame_{step:03d}{'' if window == 1 else f'_w{window}'}.png"


PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def _is_glsims(filename: str) -> bool:
    """Whether a line of a traceback is glsim's own, not the program's."""
    return filename.startswith((PACKAGE, "<gl command", "<frozen"))


def main() -> None:
    """python -m glsim.play.player PLAN, with the plan as JSON."""
    given = json.loads(sys.argv[1])
    if given.get("size"):
        given["size"] = tuple(given["size"])
    plan = Plan(**given)
    if plan.stack is not None and hasattr(faulthandler, "register"):
        faulthandler.register(signal.SIGUSR2, open(plan.stack, "w"), all_threads=False)  # noqa: SIM115
    try:
        Player(plan).play()
    except RuntimeError as error:  # no display, no graphics library
        print(f"glsim run: {error}", file=sys.stderr)
        sys.stderr.flush()
        os._exit(1)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
