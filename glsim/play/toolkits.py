"""Programs that open their window with pygame or glfw, when those packages are installed.

The program keeps its library; only what makes a context, swaps buffers and tells the time is replaced.  A swap of
buffers is a step of the loop: its picture is taken, time advances by a tick, and the next event is delivered.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

from glsim.glut.constants import NAMES
from glsim.glut.loop import Loop
from glsim.glut.window import Window

WINDOW = "--window is for programs that open their window with GLUT; run one of pygame or glfw without it"
BUFFERS = int(NAMES["GLUT_DOUBLE"] | NAMES["GLUT_DEPTH"] | NAMES["GLUT_STENCIL"])


def adopt(loop: Loop, real_windows: bool) -> None:
    """Replace the window and time functions of pygame and glfw when the program imports them.

    loop: the loop whose steps the swaps of buffers end.  real_windows: whether --window was given."""
    if not real_windows:
        os.environ["SDL_VIDEODRIVER"] = os.environ["SDL_AUDIODRIVER"] = "dummy"
        os.environ["PYGAME_HIDE_SUPPORT_PROMPT"] = "1"
    sys.modules.pop("glfw", None)  # the screen keeps its own glfw; the program gets another
    sys.meta_path.insert(
        0,
        _Watcher({"pygame": lambda m: _Pygame(loop, m, real_windows), "glfw": lambda m: _Glfw(loop, m, real_windows)}),
    )


class _Watcher:
    """An import finder that patches modules: once a module is loaded, its entry in ``changes`` is called with it."""

    def __init__(self, changes: dict[str, Callable[[Any], Any]]) -> None:
        self.changes = changes

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        change = self.changes.pop(name, None)
        if change is None:
            return None
        spec = find_spec(name)
        if spec is None or spec.loader is None:
            return None
        load = spec.loader.exec_module

        def exec_module(module: Any) -> None:
            load(module)
            change(module)

        spec.loader.exec_module = exec_module  # type: ignore[method-assign]
        return spec


def swap(loop: Loop, window: Window, deliver: Callable[[list[str]], None]) -> None:
    """A swap of buffers ends a step."""
    window.shown, window.swapped = window.picture(), True
    loop.end_step()
    loop.clock.advance(loop.tick)
    if loop.step <= len(loop.events):
        deliver(loop.events[loop.step - 1].split())


# ---------------------------------------------------------------- pygame


class _Pygame:
    def __init__(self, loop: Loop, pygame: Any, real_windows: bool) -> None:
        self.loop, self.pygame, self.window = loop, pygame, None
        self.real_windows = real_windows
        display = pygame.display
        self.set_mode, self.flip = display.set_mode, display.flip
        display.set_mode, display.flip, display.update = self._set_mode, self._flip, self._flip
        if hasattr(loop.clock, "milliseconds"):  # time stands still within a step
            pygame.time.get_ticks = lambda: int(loop.clock.now())
            pygame.time.wait = pygame.time.delay = self._wait
            pygame.time.Clock = lambda: _Clock(loop)

    window: Window | None

    def _set_mode(self, size: Any = (0, 0), flags: int = 0, *rest: Any, **named: Any) -> Any:
        pygame = self.pygame
        if not flags & pygame.OPENGL:
            return self.set_mode(size, flags, *rest, **named)
        if self.real_windows:
            raise RuntimeError(WINDOW)
        width, height = self.loop.fixed_size or (size if size and size[0] else (640, 480))
        named.pop("vsync", None)
        surface = self.set_mode((width, height), flags & ~(pygame.OPENGL | pygame.DOUBLEBUF), *rest, **named)
        if self.window is None:
            self.loop.open("pygame", (0, 0), (width, height), BUFFERS, None)
            self.window = self.loop.current
        else:
            self.window.asked = int(width), int(height)
            self.window.resize()
        from glsim import gl

        gl.glViewport(0, 0, int(width), int(height))
        return surface

    def _wait(self, milliseconds: float) -> int:
        self.loop.clock.advance(milliseconds)
        return int(milliseconds)

    def _flip(self, *rectangles: Any) -> None:
        if self.window is None:
            self.flip()
            return
        swap(self.loop, self.window, self._deliver)
        picture = self.window.shown
        surface = self.pygame.display.get_surface()
        if picture is not None and surface is not None:
            size = picture.shape[1], picture.shape[0]
            surface.blit(self.pygame.image.frombuffer(picture.tobytes(), size, "RGB"), (0, 0))
            self.flip()

    def _deliver(self, words: list[str]) -> None:
        pygame = self.pygame
        kind, *rest = words
        post = pygame.event.post
        if kind == "key":
            for what in (pygame.KEYDOWN, pygame.KEYUP):
                post(pygame.event.Event(what, key=ord(rest[0]), unicode=rest[0], mod=0))
        elif kind == "mouse":
            button, state, x, y = map(int, rest)
            what = pygame.MOUSEBUTTONUP if state else pygame.MOUSEBUTTONDOWN
            post(pygame.event.Event(what, button=button + 1, pos=(x, y)))
        elif kind in ("motion", "passive"):
            buttons = (int(kind == "motion"), 0, 0)
            post(pygame.event.Event(pygame.MOUSEMOTION, pos=tuple(map(int, rest)), rel=(0, 0), buttons=buttons))


class _Clock:
    """pygame.time.Clock on the clock of the steps."""

    def __init__(self, loop: Loop) -> None:
        self.loop, self.last, self.between = loop, loop.clock.now(), 0

    def tick(self, framerate: float = 0) -> int:
        now = self.loop.clock.now()
        self.between, self.last = int(now - self.last), now
        return self.between

    tick_busy_loop = tick

    def get_time(self) -> int:
        return self.between

    get_rawtime = get_time

    def get_fps(self) -> float:
        return 1000.0 / self.loop.tick if self.loop.tick else 0.0


# ---------------------------------------------------------------- glfw


class _Glfw:
    """The functions of glfw that make windows, without a display."""

    def __init__(self, loop: Loop, glfw: Any, real_windows: bool) -> None:
        self.loop, self.glfw, self.real_windows = loop, glfw, real_windows
        self.closing: set[int] = set()
        self.listeners: dict[str, Callable[..., Any]] = {}
        self.waiting: list[str] = []
        self.cursor = (0.0, 0.0)
        accept = lambda *arguments, **named: None  # noqa: E731
        for name in dir(glfw):
            if name.startswith(("set_", "window_hint", "focus_", "show_", "hide_", "iconify", "restore", "maximize")):
                setattr(glfw, name, self._listener(name) if name.endswith("_callback") else accept)
        for name in (
            "create_window", "destroy_window", "make_context_current", "get_current_context", "swap_buffers",
            "poll_events", "window_should_close", "set_window_should_close", "get_window_size", "get_framebuffer_size",
            "set_window_size", "get_time", "get_cursor_pos", "get_key", "get_mouse_button",
        ):  # fmt: skip
            setattr(glfw, name, getattr(self, name))
        glfw.init = lambda: True
        glfw.terminate = glfw.swap_interval = accept
        glfw.wait_events = glfw.wait_events_timeout = lambda *seconds: self.poll_events()
        glfw.get_primary_monitor = lambda: None
        glfw.get_window_content_scale = lambda window: (1.0, 1.0)

    def _listener(self, name: str) -> Callable[..., None]:
        def register(window: Any, callback: Callable[..., Any] | None = None) -> None:
            if callback is not None:
                self.listeners[name] = callback

        return register

    def create_window(self, width: int, height: int, title: str, monitor: Any = None, share: Any = None) -> int:
        if self.real_windows:
            raise RuntimeError(WINDOW)
        return self.loop.open(str(title), (0, 0), (int(width), int(height)), BUFFERS, None)

    def destroy_window(self, window: int) -> None:
        self.loop.close(window)

    def make_context_current(self, window: int | None) -> None:
        if window:
            self.loop.choose(self.loop.windows[window])

    def get_current_context(self) -> int | None:
        return self.loop.current.ident if self.loop.current else None

    def swap_buffers(self, window: int) -> None:
        swap(self.loop, self.loop.windows[window], self.waiting.extend)

    def window_should_close(self, window: int) -> bool:
        return window in self.closing

    def set_window_should_close(self, window: int, value: bool) -> None:
        (self.closing.add if value else self.closing.discard)(window)

    def get_window_size(self, window: int) -> tuple[int, int]:
        return self.loop.windows[window].asked

    get_framebuffer_size = get_window_size

    def set_window_size(self, window: int, width: int, height: int) -> None:
        self.loop.windows[window].asked = int(width), int(height)
        self.loop.windows[window].resize()

    def get_time(self) -> float:
        return self.loop.clock.now() / 1000.0

    def get_cursor_pos(self, window: int) -> tuple[float, float]:
        return self.cursor

    def get_key(self, window: int, key: int) -> int:
        return int(self.glfw.RELEASE)

    get_mouse_button = get_key

    def poll_events(self) -> None:
        """Call the callbacks for the event of this step."""
        words, self.waiting = self.waiting, []
        if not words:
            return
        kind, *rest = words
        window, glfw = next(iter(self.loop.windows)), self.glfw
        if kind == "key":
            for action in (glfw.PRESS, glfw.RELEASE):
                self._tell("set_key_callback", window, ord(rest[0].upper()), 0, action, 0)
            self._tell("set_char_callback", window, ord(rest[0]))
        elif kind == "mouse":
            button, state, x, y = map(int, rest)
            self.cursor = float(x), float(y)
            number = {1: 2, 2: 1}.get(button, button)
            self._tell("set_mouse_button_callback", window, number, glfw.RELEASE if state else glfw.PRESS, 0)
        elif kind in ("motion", "passive"):
            self.cursor = float(rest[0]), float(rest[1])
            self._tell("set_cursor_pos_callback", window, *self.cursor)

    def _tell(self, name: str, *arguments: Any) -> None:
        listener = self.listeners.get(name)
        if listener is not None:
            listener(*arguments)
