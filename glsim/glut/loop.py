"""The steps of GLUT's main loop: in which order it calls the callbacks.  The order is the same in each run.

    step 0   reshape of each window, in the order of creation; then, window by window, visibility and display
    step k   the clock advances by a tick; by more, to the next timer, if the step has no event and the program no idle
             callback; the event of this step, if any; each timer that is due, once; the idle callback; reshape of
             each window with a new size; display of each window with a new size or marked by glutPostRedisplay

After each step one picture of each window is taken: of a double-buffered window, what glutSwapBuffers showed last; of a
single-buffered window, what has been drawn until then.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, Protocol

from glsim.glut.window import Window

TICK = 20.0  # milliseconds of a step
VISIBLE = 1
SCREEN = (1280, 1024)


class Clock(Protocol):
    """Milliseconds since the start."""

    def now(self) -> float: ...

    def advance(self, milliseconds: float) -> None: ...


class RealClock:
    """The clock on the wall: advancing waits."""

    def __init__(self) -> None:
        self.start = time.perf_counter()

    def now(self) -> float:
        return (time.perf_counter() - self.start) * 1000.0

    def advance(self, milliseconds: float) -> None:
        time.sleep(max(milliseconds, 0.0) / 1000.0)


class StepClock:
    """A clock that stands still within a step.

    After PATIENCE calls of ``now`` in a step each call adds 1 ms, so that a program waiting for a time does not hang.
    """

    PATIENCE = 10_000

    def __init__(self) -> None:
        self.milliseconds, self.readings = 0.0, 0

    def now(self) -> float:
        self.readings += 1
        if self.readings > self.PATIENCE:
            self.milliseconds += 1.0
        return self.milliseconds

    def advance(self, milliseconds: float) -> None:
        self.milliseconds, self.readings = self.milliseconds + milliseconds, 0


class FinishedError(BaseException):
    """All steps are done: unwinds the program.  Not an Exception, so that programs do not catch it by accident."""


class Loop:
    """The main loop: its windows, timers and menus, and the steps in which it calls their callbacks.

    events: as text; step k delivers events[k - 1], step 0 delivers none.  steps: the number of steps, at least
    1 + len(events); None for no end.  fixed_size: the size of every window, whatever the program asks.  on_open: called
    with each new window.  on_step: called with the loop after each step.  on_error: called with the kind of a callback
    and the exception that it raised; if on_error is None, the program gets the exception.
    """

    def __init__(self) -> None:
        self.clock: Clock = RealClock()
        self.windows: dict[int, Window] = {}
        self.current: Window | None = None
        self.numbers = 0
        self.timers: list[tuple[float, int, Callable[[Any], Any], Any]] = []
        self.idle: Callable[[], Any] | None = None
        self.menus: dict[int, Any] = {}
        self.menu = 0
        self.modifiers = 0
        self.left = False
        self.step = 0
        self.events: list[str] = []
        self.steps: int | None = None
        self.fixed_size: tuple[int, int] | None = None
        self.tick = TICK
        self.on_open: Callable[[Window], Any] | None = None
        self.on_swap: Callable[[Window], Any] | None = None
        self.text_keys = False  # keys as str, for programs of Python 2
        self.on_step: Callable[[Loop], Any] | None = None
        self.on_error: Callable[[str, Exception], Any] | None = None
        self.notes: list[str] = []

    # ------------------------------------------------------------ windows

    def open(self, title: str, place: tuple[int, int], size: tuple[int, int], mode: int, parent: Window | None) -> int:
        self.numbers += 1
        window = Window(self.numbers, title, place, self.fixed_size or size, mode, parent)
        self.windows[window.ident] = window
        if self.on_open is not None:
            self.on_open(window)
        self.choose(window)
        return window.ident

    def choose(self, window: Window | None) -> None:
        """Make a window current."""
        self.current = window
        if window is not None:
            window.make_current()

    def close(self, ident: int) -> None:
        window = self.windows.pop(ident, None)
        if window is None:
            return
        for child in [w.ident for w in self.windows.values() if w.parent is window]:
            self.close(child)
        if self.current is window:
            self.current = None
        window.release()

    # ------------------------------------------------------------ calling the program

    def call(self, where: str, function: Callable[..., Any], *arguments: Any) -> None:
        try:
            function(*arguments)
        except SystemExit:
            self.notes.append(f"the script exited in {where}")
            self.left = True
        except Exception as error:
            if self.on_error is None:
                raise
            self.on_error(where, error)

    def fire(self, window: Window, kind: str, *arguments: Any) -> bool:
        """Call a window's callback; False if it has none or the window is gone."""
        function = window.callbacks.get(kind)
        if function is None or window.ident not in self.windows:
            return False
        self.choose(window)
        if self.text_keys and kind in ("Keyboard", "KeyboardUp"):
            arguments = (arguments[0].decode("latin-1"), *arguments[1:])
        self.call(kind.lower(), function, *arguments)
        return True

    def settle(self) -> None:
        """Windows take the sizes that were asked for; those that changed are reshaped."""
        for window in list(self.windows.values()):
            if window.asked != window.size and window.ident in self.windows:
                window.resize()
                window.size, window.dirty = window.asked, True
                self.choose(window)
                if not self.fire(window, "Reshape", *window.asked):
                    from glsim import gl

                    gl.glViewport(0, 0, *window.asked)

    # ------------------------------------------------------------ steps

    def run(self) -> None:
        """glutMainLoop: until the program leaves it, or all steps are made."""
        while not self.left:
            self.one_step()
        self.left = False

    def one_step(self) -> None:
        if not self.windows:
            self.left = True
            return
        first = self.step == 0
        if not first:
            self._advance()
        self.settle()
        for window in list(self.windows.values()):
            if first:
                self.fire(window, "Visibility", VISIBLE)
            if window.dirty and not window.hidden and window.ident in self.windows:
                window.dirty = False
                if not self.fire(window, "Display") and first:
                    self.notes.append(f"window {window.ident} has no display function")
        self._show()
        self.end_step()

    def end_step(self) -> None:
        """Report the step.  Raises FinishedError after the last one."""
        self.step += 1
        for window in self.windows.values():
            self.notes += window.notes
            window.notes.clear()
        if self.on_step is not None:
            self.on_step(self)
        if self.steps is not None and self.step >= max(self.steps, 1 + len(self.events)):
            raise FinishedError

    def _advance(self) -> None:
        """Time, the event, timers, idle."""
        event = self.events[self.step - 1] if self.step <= len(self.events) else None
        jump = self.tick
        if self.timers and not self.idle and not event:
            jump = max(jump, min(timer[0] for timer in self.timers) - self.clock.now())
        self.clock.advance(jump)
        if event:
            self.deliver(event)
        now = self.clock.now()
        due = sorted((timer for timer in self.timers if timer[0] <= now), key=lambda timer: timer[:2])
        self.timers = [timer for timer in self.timers if timer not in due]
        for _, _, function, value in due:
            self.call("timer", function, value)
        if self.idle is not None:
            self.call("idle", self.idle)

    def _show(self) -> None:
        for window in self.windows.values():
            if not window.double:
                window.shown = window.picture()
            elif window.shown is None:
                self.notes.append(f"step {self.step}: the double-buffered window {window.ident} was never swapped")
                window.shown = window.picture()

    # ------------------------------------------------------------ events

    def deliver(self, event: str) -> None:
        """One event as text: "key a", "special 101", "mouse BUTTON STATE X Y", "motion X Y", "passive X Y",
        "menu VALUE", "reshape W H", "tick".  It goes to the first window.  Raises ValueError for another."""
        kind, *words = event.split()
        if kind not in EVENTS:
            raise ValueError(f"an event is one of {', '.join(EVENTS)}, not {event!r}")
        window = next(iter(self.windows.values()), None)
        if window is None or kind == "tick":
            return
        if kind == "key":
            self.fire(window, "Keyboard", key(words[0] if words else " "), 0, 0)
        elif kind == "menu":
            self.choose(window)
            for menu in list(self.menus.values())[-1:]:
                self.call("menu", menu.function, int(words[0]))
        elif kind == "reshape":
            if self.fixed_size is None:
                window.asked = int(words[0]), int(words[1])
        else:
            numbers = [int(word) for word in words]
            self.fire(window, EVENTS[kind], *(numbers if kind != "special" else [*numbers, 0, 0]))


EVENTS = {
    "key": "Keyboard", "special": "Special", "mouse": "Mouse", "motion": "Motion", "passive": "PassiveMotion",
    "menu": "", "reshape": "", "tick": "",
}  # fmt: skip


KEYS = {"esc": b"\x1b", "escape": b"\x1b", "space": b" ", "enter": b"\r", "tab": b"\t", "backspace": b"\b",
        "delete": b"\x7f"}  # fmt: skip


def key(text: str) -> bytes:
    """A key as the keyboard callback gets it: one byte.

    text: the character, a name of KEYS, or a number such as 0x1B.  Raises ValueError for anything else.
    """
    if text in KEYS:
        return KEYS[text]
    try:
        code = bytes([int(text, 16)]) if text.startswith("0x") and len(text) > 2 else text.encode("latin-1")
    except ValueError:
        code = b""
    if len(code) != 1:
        raise ValueError(f"a key is one character, {', '.join(KEYS)}, or a number from 0x00 to 0xFF, not {text!r}")
    return code


# The one loop of this process, as GLUT has it.
loop = Loop()
