"""Real windows for GLUT programs, through glfw: they show what the offscreen contexts draw, and bring events."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

import moderngl
import numpy as np

from glsim.glut.constants import NAMES
from glsim.glut.loop import Loop
from glsim.glut.popup import Popup
from glsim.glut.window import Window
from glsim.machine.interrupts import uninterrupted

WAIT = 10.0  # milliseconds between two looks at the events when nothing is to be done
VERTEX = """#version 330 core
out vec2 st;
void main() {                       // a triangle that covers the window
    st = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(st * 2.0 - 1.0, 0.0, 1.0);
}"""
FRAGMENT = """#version 330 core
uniform sampler2D picture;
in vec2 st;
out vec4 color;
void main() { color = texture(picture, vec2(st.x, 1.0 - st.y)); }"""
# glfw's special keys -> GLUT's
SPECIAL = {
    "LEFT": "LEFT", "RIGHT": "RIGHT", "UP": "UP", "DOWN": "DOWN", "HOME": "HOME", "END": "END", "INSERT": "INSERT",
    "PAGE_UP": "PAGE_UP", "PAGE_DOWN": "PAGE_DOWN", **{f"F{k}": f"F{k}" for k in range(1, 13)},
}  # fmt: skip
PLAIN = {"ESCAPE": b"\x1b", "ENTER": b"\r", "KP_ENTER": b"\r", "TAB": b"\t", "BACKSPACE": b"\b", "DELETE": b"\x7f"}
WHEEL_UP, WHEEL_DOWN = 3, 4  # buttons of the mouse wheel, as freeglut has them


class _Loader:
    """What moderngl asks of a context that glfw made."""

    def __init__(self, glfw: Any) -> None:
        self.glfw = glfw

    def load(self, name: str) -> int:
        return int(self.glfw.get_proc_address(name) or 0)

    def __enter__(self) -> None:
        pass

    def __exit__(self, *exception: Any) -> None:
        pass

    def release(self) -> None:
        pass


class Display:
    """All real windows; the clock of a loop that shows them.

    on_click: called with a window and the pixel, x and y from the upper left, when the left button is pressed and
    released at one place; the program gets both events too."""

    def __init__(self, loop: Loop, on_click: Callable[[Window, int, int], Any] | None = None) -> None:
        try:
            self.glfw = import_module("glfw")
        except ImportError:
            raise RuntimeError(
                "windows need the package glfw (pip install glsim[window]); glsim run needs none"
            ) from None
        if not self.glfw.init():
            raise RuntimeError("no window can be opened here (is there a display?); glsim run SCRIPT needs none")
        self.loop, self.on_click = loop, on_click
        self.shown: dict[int, Shown] = {}
        self.start = time.perf_counter()
        self.counter = time.perf_counter  # time itself may be replaced

    def now(self) -> float:
        return (self.counter() - self.start) * 1000.0

    def advance(self, milliseconds: float) -> None:
        """Wait for time or an event."""
        if milliseconds > 0:
            self.glfw.wait_events_timeout(milliseconds / 1000.0)
        else:
            self.glfw.poll_events()

    def after_step(self, loop: Loop) -> None:
        for window in list(loop.windows.values()):
            if window.parent is None and window.ident not in self.shown:
                self.shown[window.ident] = Shown(self, window)
        for ident, shown in list(self.shown.items()):
            if ident not in loop.windows:
                shown.close()
                del self.shown[ident]
            else:
                shown.present()
        busy = loop.idle is not None or any(window.dirty for window in loop.windows.values())
        loop.tick = 0.0 if busy else WAIT


class Shown:
    """One real window."""

    def __init__(self, display: Display, window: Window) -> None:
        glfw = self.glfw = display.glfw
        self.display, self.window, self.loop = display, window, display.loop
        hints = {
            glfw.CONTEXT_VERSION_MAJOR: 3, glfw.CONTEXT_VERSION_MINOR: 3, glfw.OPENGL_FORWARD_COMPAT: True,
            glfw.OPENGL_PROFILE: glfw.OPENGL_CORE_PROFILE,
        }  # fmt: skip
        for hint, value in hints.items():
            glfw.window_hint(hint, value)
        window.screen.detach()
        self.handle = glfw.create_window(*window.asked, window.title, None, None)
        if not self.handle:
            raise RuntimeError("glfw could not open a window")
        self.texture: Any = None
        with self._current():
            loader: Any = _Loader(glfw)
            self.ctx = moderngl.create_context(context=loader, require=330)
            self.program = self.ctx.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
            self.triangle = self.ctx.vertex_array(self.program, [])
        self.buttons: set[int] = set()
        self.pointer = (0, 0)  # where the last event found it
        self.pressed: tuple[int, int] | None = None  # where the left button went down
        self.popup: Popup | None = None
        self._listen()

    @contextmanager
    def _current(self) -> Iterator[None]:
        """Make the real window's context current instead of the offscreen one: a thread has one current context."""
        with uninterrupted():
            self.window.screen.detach()
            self.glfw.make_context_current(self.handle)
            yield
            self.glfw.make_context_current(None)

    def present(self) -> None:
        """Show the window's picture."""
        picture = self.window.shown
        if picture is None:
            return
        if self.popup is not None:
            picture = self.popup.drawn_on(picture, self._at())
        height, width = picture.shape[:2]
        with self._current():
            if self.texture is None or self.texture.size != (width, height):
                self.texture = self.ctx.texture((width, height), 3, alignment=1)
            self.texture.write(np.ascontiguousarray(picture))
            self.texture.use()
            self.ctx.viewport = (0, 0, *self.glfw.get_framebuffer_size(self.handle))
            self.triangle.render(moderngl.TRIANGLES, vertices=3)
            self.glfw.swap_buffers(self.handle)

    def close(self) -> None:
        self.glfw.destroy_window(self.handle)

    # ------------------------------------------------------------ events

    def _listen(self) -> None:
        glfw = self.glfw
        glfw.set_window_size_callback(self.handle, self._resized)
        glfw.set_window_close_callback(self.handle, self._closed)
        glfw.set_char_callback(self.handle, self._character)
        glfw.set_key_callback(self.handle, self._key)
        glfw.set_mouse_button_callback(self.handle, self._button)
        glfw.set_cursor_pos_callback(self.handle, self._moved)
        glfw.set_scroll_callback(self.handle, self._scrolled)

    def _at(self) -> tuple[int, int]:
        """Where the pointer was at the last event; glfw.get_cursor_pos tells where it has gone since."""
        return self.pointer

    def _fire(self, kind: str, *arguments: Any) -> None:
        self.loop.fire(self.window, kind, *arguments)

    def _resized(self, handle: Any, width: int, height: int) -> None:
        if width > 0 and height > 0 and self.loop.fixed_size is None:
            self.window.asked = width, height

    def _closed(self, handle: Any) -> None:
        self._fire("Close")
        self.loop.close(self.window.ident)
        self.loop.left = self.loop.left or not self.loop.windows

    def _character(self, handle: Any, code: int) -> None:
        if code < 256:
            self._fire("Keyboard", bytes([code]), *self._at())

    def _key(self, handle: Any, key: int, scancode: int, action: int, modifiers: int) -> None:
        glfw = self.glfw
        self.loop.modifiers = (
            bool(modifiers & glfw.MOD_SHIFT) * NAMES["GLUT_ACTIVE_SHIFT"]
            | bool(modifiers & glfw.MOD_CONTROL) * NAMES["GLUT_ACTIVE_CTRL"]
            | bool(modifiers & glfw.MOD_ALT) * NAMES["GLUT_ACTIVE_ALT"]
        )
        up = action == glfw.RELEASE
        for name, plain in PLAIN.items():
            if key == getattr(glfw, f"KEY_{name}"):
                self._fire("KeyboardUp" if up else "Keyboard", plain, *self._at())
                return
        for name, special in SPECIAL.items():
            if key == getattr(glfw, f"KEY_{name}"):
                self._fire("SpecialUp" if up else "Special", int(NAMES[f"GLUT_KEY_{special}"]), *self._at())
                return
        if up and 32 <= key < 127:
            self._fire("KeyboardUp", chr(key).lower().encode("latin-1"), *self._at())
        elif modifiers & glfw.MOD_CONTROL and glfw.KEY_A <= key <= glfw.KEY_Z:
            self._fire("Keyboard", bytes([key - glfw.KEY_A + 1]), *self._at())

    def _button(self, handle: Any, button: int, action: int, modifiers: int) -> None:
        glfw = self.glfw
        number = {glfw.MOUSE_BUTTON_LEFT: 0, glfw.MOUSE_BUTTON_MIDDLE: 1, glfw.MOUSE_BUTTON_RIGHT: 2}.get(
            button, button
        )
        down = action == glfw.PRESS
        if self.popup is not None:
            if down:
                popup, self.popup = self.popup, None
                self.loop.choose(self.window)
                popup.choose(*self._at())
            return
        if down and number in self.window.menus:
            self.popup = Popup(self.loop, self.window.menus[number], *self._at())
            return
        (self.buttons.add if down else self.buttons.discard)(number)
        self._fire("Mouse", number, int(NAMES["GLUT_DOWN" if down else "GLUT_UP"]), *self._at())
        if number == 0:
            self._click(down)

    def _click(self, down: bool) -> None:
        """Left button: tell on_click if it is released where it was pressed, within two pixels."""
        (x, y), pressed = self._at(), self.pressed
        self.pressed = (x, y) if down else None
        window, picture = self.window, self.window.shown
        if down or pressed is None or picture is None or max(abs(x - pressed[0]), abs(y - pressed[1])) > 2:
            return
        if self.display.on_click is not None and window.ident in self.loop.windows:
            width, height = self.glfw.get_window_size(self.handle)
            rows, columns = picture.shape[:2]
            self.display.on_click(window, x * columns // max(width, 1), y * rows // max(height, 1))

    def _moved(self, handle: Any, x: float, y: float) -> None:
        self.pointer = int(x), int(y)
        self._fire("Motion" if self.buttons else "PassiveMotion", *self.pointer)

    def _scrolled(self, handle: Any, dx: float, dy: float) -> None:
        if "MouseWheel" in self.window.callbacks:
            self._fire("MouseWheel", 0, 1 if dy > 0 else -1, *self._at())
            return
        for state in ("GLUT_DOWN", "GLUT_UP"):
            self._fire("Mouse", WHEEL_UP if dy > 0 else WHEEL_DOWN, int(NAMES[state]), *self._at())


def open_windows(loop: Loop, on_click: Callable[[Window, int, int], Any] | None = None) -> Display:
    """Show the windows of ``loop`` on the screen.  on_click: see Display.  Raises RuntimeError if there is no glfw or
    no display."""
    display = Display(loop, on_click)
    loop.clock = display
    loop.tick = 0.0
    return display
