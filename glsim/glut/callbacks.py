"""GLUT: the functions that the main loop calls."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from glsim.glut.loop import loop
from glsim.glut.menus import current_window

_PER_WINDOW = (
    "Display Reshape Keyboard KeyboardUp Special SpecialUp Mouse Motion PassiveMotion Visibility WindowStatus Entry "
    "MouseWheel Close WMClose OverlayDisplay Joystick SpaceballMotion SpaceballRotate SpaceballButton ButtonBox Dials "
    "TabletMotion TabletButton Position MultiEntry MultiButton MultiMotion MultiPassive InitContext AppStatus"
)
PER_WINDOW = _PER_WINDOW.split()
_CALLED_WITH = {  # what a callback gets (x, y: the mouse, in pixels from the upper left), and when
    "Display": ("()", "when the window must be drawn"),
    "Reshape": ("(width, height)", "when the window gets a size, in pixels"),
    "Keyboard": ("(key, x, y)", "when a key is pressed; key: its letter as bytes"),
    "KeyboardUp": ("(key, x, y)", "when a key is released"),
    "Special": ("(key, x, y)", "when GLUT_KEY_UP, GLUT_KEY_F1, ... is pressed"),
    "SpecialUp": ("(key, x, y)", "when GLUT_KEY_UP, GLUT_KEY_F1, ... is released"),
    "Mouse": ("(button, state, x, y)", "when GLUT_LEFT_BUTTON, ... gets GLUT_DOWN or GLUT_UP"),
    "Motion": ("(x, y)", "when the mouse moves with a button down"),
    "PassiveMotion": ("(x, y)", "when the mouse moves without a button"),
    "Entry": ("(state)", "when the mouse comes (GLUT_ENTERED) or goes (GLUT_LEFT)"),
    "Visibility": ("(state)", "when the window is shown (GLUT_VISIBLE) or hidden (GLUT_NOT_VISIBLE)"),
    "WindowStatus": ("(state)", "when the window is shown or hidden"),
    "MouseWheel": ("(wheel, direction, x, y)", "when the wheel turns: direction 1 or -1"),
    "Close": ("()", "when the window is closed"),
    "WMClose": ("()", "when the window is closed"),
}  # fmt: skip


def _registrar(kind: str) -> Callable[..., None]:
    name = f"glut{kind}Func"

    def register(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
        if callback is not None and not callable(callback):
            if callback == 0:
                callback = None
            else:
                raise TypeError(f"{name}: a function or None is needed, not {callback!r}")
        window = current_window(name)
        if callback is None and kind == "Display":  # freeglut ends the program
            raise TypeError(f"{name}: a function is needed, not None: write {name}(display), not {name}(display())")
        if callback is None:
            window.callbacks.pop(kind, None)
        else:
            window.callbacks[kind] = callback

    register.__name__ = register.__qualname__ = name
    arguments, when = _CALLED_WITH.get(kind, ("", ""))
    called = f"Call ``callback{arguments}`` of the current window {when}; None: no longer."
    register.__doc__ = called if when else "Accepted without effect: there are no such events."
    return register


globals().update({f"glut{kind}Func": _registrar(kind) for kind in PER_WINDOW})


def glutIdleFunc(callback: Callable[[], Any] | None = None) -> None:
    """Call ``callback()`` in every step of the main loop, after timers and before drawing; None: no longer."""
    loop.idle = callback if callable(callback) else None


def glutTimerFunc(msecs: float, callback: Callable[[Any], Any], value: Any = 0) -> None:
    """Call ``callback(value)`` once, in ``msecs`` milliseconds."""
    if not callable(callback):
        raise TypeError(f"glutTimerFunc: a function is needed, not {callback!r}")
    loop.timers.append((loop.clock.now() + float(msecs), len(loop.timers), callback, value))


def glutMenuStatusFunc(callback: Any = None) -> None:
    """Accepted without effect."""


glutMenuStateFunc = glutMenuDestroyFunc = glutMenuStatusFunc
