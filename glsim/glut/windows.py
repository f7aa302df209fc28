"""GLUT: opening, arranging and redrawing windows."""

from __future__ import annotations

from typing import Any

from glsim.glut.api import checked_size, settings
from glsim.glut.loop import SCREEN, loop
from glsim.glut.menus import current_window, text_of


def glutCreateWindow(title: Any = "", *rest: Any) -> int:
    """Open a window with this title, as glutInit... said, make it current and return its number."""
    return loop.open(text_of(title), settings.place, settings.size, settings.mode, None)


def glutCreateSubWindow(window: int, x: int, y: int, width: int, height: int) -> int:
    """A window inside of another; it has a picture of its own."""
    parent = loop.windows.get(int(window))
    if parent is None:
        raise ValueError(f"glutCreateSubWindow: there is no window {window}")
    w = int(width) or parent.asked[0]
    h = int(height) or parent.asked[1]
    return loop.open("", (int(x), int(y)), (max(w, 1), max(h, 1)), settings.mode, parent)


def glutDestroyWindow(window: int) -> None:
    """Close the window with this number, and the windows inside of it."""
    loop.close(int(window))


def glutSetWindow(window: int) -> None:
    """Make the window with this number current: gl and glut functions act on it."""
    if int(window) in loop.windows:
        loop.choose(loop.windows[int(window)])


def glutGetWindow() -> int:
    """The number of the current window; 0 if there is none."""
    return loop.current.ident if loop.current is not None else 0


def glutSetWindowTitle(title: Any) -> None:
    """Write a title, a str or bytes, above the current window."""
    current_window("glutSetWindowTitle").title = text_of(title)


def glutSetIconTitle(title: Any) -> None:
    """Accepted without effect."""


def glutPositionWindow(x: int, y: int) -> None:
    """Move the current window: x, y of its upper left corner, in pixels from that of the screen."""
    current_window("glutPositionWindow").place = int(x), int(y)


def glutReshapeWindow(width: int, height: int) -> None:
    """Takes effect at the next step, with a call of the reshape callback."""
    size = checked_size("glutReshapeWindow", width, height)
    if loop.fixed_size is None:
        current_window("glutReshapeWindow").asked = size


def glutFullScreen() -> None:
    """Make the current window as large as the screen, which has 1280 x 1024 pixels in glsim."""
    window = current_window("glutFullScreen")
    if loop.fixed_size is None and window.asked != SCREEN:
        settings.full_screen_before[window.ident] = window.asked
        window.asked = SCREEN


def glutLeaveFullScreen() -> None:
    """Give the current window the size again that it had before glutFullScreen."""
    window = current_window("glutLeaveFullScreen")
    window.asked = settings.full_screen_before.pop(window.ident, window.asked)


def glutFullScreenToggle() -> None:
    """glutFullScreen, or glutLeaveFullScreen if the current window is as large as the screen already."""
    if current_window("glutFullScreenToggle").ident in settings.full_screen_before:
        glutLeaveFullScreen()
    else:
        glutFullScreen()


def glutShowWindow() -> None:
    """Show the current window again, after glutHideWindow or glutIconifyWindow."""
    window = current_window("glutShowWindow")
    window.hidden, window.dirty = False, True


def glutHideWindow() -> None:
    """Hide the current window: it is not drawn until glutShowWindow."""
    current_window("glutHideWindow").hidden = True


glutIconifyWindow = glutHideWindow


def glutPopWindow() -> None:
    """Accepted without effect: windows do not cover each other."""


glutPushWindow = glutPopWindow


def glutSetCursor(cursor: int) -> None:
    """Choose the mouse cursor of the current window, such as GLUT_CURSOR_CROSSHAIR."""
    current_window("glutSetCursor").cursor = cursor  # type: ignore[assignment]


def glutWarpPointer(x: int, y: int) -> None:
    """Accepted: there is no pointer to move; programs get the positions that events bring."""


def glutGetWindowData() -> Any:
    """What glutSetWindowData attached to the current window; None at first."""
    return current_window("glutGetWindowData").data


def glutSetWindowData(data: Any) -> None:
    """Attach any object to the current window."""
    current_window("glutSetWindowData").data = data


def glutSwapBuffers() -> None:
    """Show what has been drawn."""
    window = loop.current
    if window is not None:
        window.shown, window.swapped = window.picture(), True
        if loop.on_swap is not None:
            loop.on_swap(window)


def glutPostRedisplay() -> None:
    """Ask for the current window to be drawn: its display callback is called in the next step."""
    if loop.current is not None:
        loop.current.dirty = True


def glutPostWindowRedisplay(window: int) -> None:
    """Ask for the window with this number to be drawn in the next step."""
    if int(window) in loop.windows:
        loop.windows[int(window)].dirty = True
