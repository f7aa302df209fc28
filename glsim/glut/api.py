"""The functions of GLUT but for menus, shapes and fonts; freeglut's where it has more."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from glsim.glut import fonts
from glsim.glut.constants import NAMES
from glsim.glut.loop import SCREEN, FinishedError, loop
from glsim.glut.menus import current_window, text_of
from glsim.machine.errors import NoContextError

DEFAULT_SIZE = (300, 300)
JOIN_DOTS = 0x0206  # GLUT_STROKE_FONT_DRAW_JOIN_DOTS


@dataclass
class Settings:
    """What glutInit... said about windows to come."""

    initialized: bool = False
    place: tuple[int, int] = (-1, -1)
    size: tuple[int, int] = DEFAULT_SIZE
    mode: int = NAMES["GLUT_DEPTH"]  # freeglut's, if glutInitDisplayMode is not called
    options: dict[int, int] = field(default_factory=dict)
    game_mode: str = ""
    full_screen_before: dict[int, tuple[int, int]] = field(default_factory=dict)


settings = Settings()


# ---------------------------------------------------------------- initialization


def glutInit(*arguments: Any) -> list[Any]:
    """glutInit(), glutInit(sys.argv) or glutInit(len(argv), argv): the arguments that are left, all of them."""
    settings.initialized = NoContextError.uses_glut = True
    given = next((a for a in arguments if isinstance(a, (list, tuple))), arguments)
    return [a for a in given if not isinstance(a, int)]


def glutInitDisplayMode(displayMode: int) -> None:
    """Choose the buffers of windows to come.  displayMode: GLUT_RGB, GLUT_DOUBLE, GLUT_DEPTH, ..., joined by |."""
    if displayMode & NAMES["GLUT_INDEX"]:
        raise ValueError("glutInitDisplayMode: colour-index mode (GLUT_INDEX) is not emulated; use GLUT_RGB")
    settings.mode = int(displayMode)


WORDS = {
    "double": "GLUT_DOUBLE", "depth": "GLUT_DEPTH", "stencil": "GLUT_STENCIL", "acc": "GLUT_ACCUM",
    "alpha": "GLUT_ALPHA", "samples": "GLUT_MULTISAMPLE", "stereo": "GLUT_STEREO",
}  # fmt: skip


def glutInitDisplayString(displayMode: Any) -> None:
    """A string such as "rgb double depth>=16 samples"."""
    mode = 0
    for word in text_of(displayMode).split():
        name = word.rstrip("0123456789").rstrip("<>=~!")
        mode |= NAMES[WORDS[name]] if name in WORDS else 0
    settings.mode = mode


def glutInitWindowPosition(x: int, y: int) -> None:
    """Where windows to come have their upper left corner: x, y in pixels from that of the screen."""
    settings.place = int(x), int(y)


def glutInitWindowSize(width: int, height: int) -> None:
    """Size of windows to come: width and height in pixels, from 1 to 16384."""
    settings.size = _size("glutInitWindowSize", width, height)


def _size(name: str, width: int, height: int) -> tuple[int, int]:
    if not (0 < int(width) <= 16384 and 0 < int(height) <= 16384):
        raise ValueError(f"{name}: width and height must be from 1 to 16384 pixels, not {width} and {height}")
    return int(width), int(height)


def glutInitContextVersion(majorVersion: int, minorVersion: int) -> None:
    """Accepted: every context has OpenGL 1.5's fixed function."""


def glutInitContextFlags(flags: int) -> None:
    """Accepted without effect."""


def glutInitContextProfile(profile: int) -> None:
    """Accepted for the compatibility profile.  Raises ValueError for GLUT_CORE_PROFILE, which has no fixed function."""
    if profile & NAMES["GLUT_CORE_PROFILE"]:
        raise ValueError("glutInitContextProfile: a core profile has no fixed function; glsim emulates nothing else")


def glutInitErrorFunc(callback: Any) -> None:
    """Accepted: errors are exceptions."""


glutInitWarningFunc = glutInitErrorFunc


def glutSetOption(option: int, value: int) -> None:
    """Set an option of freeglut, such as GLUT_ACTION_ON_WINDOW_CLOSE; glutGet gives it back."""
    settings.options[int(option)] = int(value)
    if option == JOIN_DOTS:
        fonts.draw_join_dots = bool(value)


# ---------------------------------------------------------------- windows


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
    found = loop.windows.get(int(window))
    if found is not None:
        loop.choose(found)


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
    size = _size("glutReshapeWindow", width, height)
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


# ---------------------------------------------------------------- the loop


def glutMainLoop() -> None:
    """Call the callbacks, step after step, until the program leaves it.  Raises RuntimeError without a window."""
    if not loop.windows:
        raise RuntimeError("glutMainLoop: there is no window: call glutCreateWindow first")
    if loop.on_step is None:  # not under glsim run
        from glsim.glut.display import open_windows

        loop.on_step = open_windows(loop).after_step
    loop.run()


def glutMainLoopEvent() -> None:
    """Take one step of the main loop: call the callbacks of what has happened, then draw."""
    loop.one_step()


glutCheckLoop = glutMainLoopEvent


def glutLeaveMainLoop() -> None:
    """Let glutMainLoop return after this step."""
    loop.left = True


def glutExit() -> None:
    """End the program, whatever it is doing."""
    raise FinishedError


# ---------------------------------------------------------------- callbacks

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


# ---------------------------------------------------------------- state


def glutGet(state: int) -> int:
    """Sizes in pixels, times in milliseconds; 0 for what there is not."""
    window = loop.current
    fixed: dict[str, Callable[[], int]] = {
        "GLUT_ELAPSED_TIME": lambda: int(loop.clock.now()), "GLUT_INIT_STATE": lambda: int(settings.initialized),
        "GLUT_SCREEN_WIDTH": lambda: SCREEN[0], "GLUT_SCREEN_HEIGHT": lambda: SCREEN[1],
        "GLUT_SCREEN_WIDTH_MM": lambda: 339, "GLUT_SCREEN_HEIGHT_MM": lambda: 271,
        "GLUT_INIT_WINDOW_X": lambda: settings.place[0], "GLUT_INIT_WINDOW_Y": lambda: settings.place[1],
        "GLUT_INIT_WINDOW_WIDTH": lambda: settings.size[0], "GLUT_INIT_WINDOW_HEIGHT": lambda: settings.size[1],
        "GLUT_INIT_DISPLAY_MODE": lambda: settings.mode, "GLUT_DISPLAY_MODE_POSSIBLE": lambda: 1,
        "GLUT_MENU_NUM_ITEMS": lambda: len(loop.menus[loop.menu].entries) if loop.menu in loop.menus else 0,
    }  # fmt: skip
    for name, answer in fixed.items():
        if state == NAMES[name]:
            return answer()
    if window is None:
        return 0
    samples = window.screen.samples
    values: dict[str, int] = {
        "WINDOW_X": max(window.place[0], 0), "WINDOW_Y": max(window.place[1], 0), "WINDOW_WIDTH": window.asked[0],
        "WINDOW_HEIGHT": window.asked[1], "WINDOW_BUFFER_SIZE": 32, "WINDOW_STENCIL_SIZE": window.screen.stencil_bits,
        "WINDOW_DEPTH_SIZE": window.screen.depth_bits,
        "WINDOW_RED_SIZE": 8, "WINDOW_GREEN_SIZE": 8, "WINDOW_BLUE_SIZE": 8, "WINDOW_ALPHA_SIZE": 8,
        "WINDOW_ACCUM_RED_SIZE": 32, "WINDOW_ACCUM_GREEN_SIZE": 32, "WINDOW_ACCUM_BLUE_SIZE": 32,
        "WINDOW_ACCUM_ALPHA_SIZE": 32, "WINDOW_DOUBLEBUFFER": int(window.double), "WINDOW_RGBA": 1,
        "WINDOW_PARENT": window.parent.ident if window.parent else 0,
        "WINDOW_NUM_CHILDREN": sum(w.parent is window for w in loop.windows.values()),
        "WINDOW_NUM_SAMPLES": samples, "WINDOW_CURSOR": int(window.cursor),
        "FULL_SCREEN": int(window.ident in settings.full_screen_before),
    }  # fmt: skip
    return next(
        (value for name, value in values.items() if NAMES["GLUT_" + name] == state), settings.options.get(state, 0)
    )


def glutDeviceGet(type: int) -> int:
    """What the machine's devices are: for example 3 for GLUT_NUM_MOUSE_BUTTONS."""
    if type in (NAMES["GLUT_HAS_KEYBOARD"], NAMES["GLUT_HAS_MOUSE"]):
        return 1
    return 3 if type == NAMES["GLUT_NUM_MOUSE_BUTTONS"] else 0


def glutGetModifiers() -> int:
    """The keys held down with the present event: GLUT_ACTIVE_SHIFT, _CTRL and _ALT, joined by |."""
    return loop.modifiers


def glutLayerGet(type: int) -> int:
    """1 for GLUT_NORMAL_DAMAGED while the current window waits to be drawn, else 0: there are no overlays."""
    return int(type == NAMES["GLUT_NORMAL_DAMAGED"] and bool(loop.current and loop.current.dirty))


def glutGameModeString(string: Any) -> None:
    """Choose size and depth for glutEnterGameMode: "640x480:32@60" is 640 x 480 pixels (the rest has no effect)."""
    settings.game_mode = text_of(string)


def glutEnterGameMode() -> int:
    """A window as large as the game mode's string says; there is no screen whose mode could change."""
    first = settings.game_mode.partition(":")[0].partition("@")[0]
    words = first.lower().split("x")
    size = (int(words[0]), int(words[1])) if len(words) == 2 and all(w.isdigit() for w in words) else SCREEN
    return loop.open("game mode", (0, 0), size, settings.mode, None)


def glutLeaveGameMode() -> None:
    """Close the window of glutEnterGameMode."""
    if loop.current is not None:
        loop.close(loop.current.ident)


def glutGameModeGet(mode: int) -> int:
    """A value of the game mode, such as GLUT_GAME_MODE_WIDTH in pixels; 0 for what is unknown."""
    known = {
        "GLUT_GAME_MODE_POSSIBLE": 1, "GLUT_GAME_MODE_WIDTH": SCREEN[0], "GLUT_GAME_MODE_HEIGHT": SCREEN[1],
        "GLUT_GAME_MODE_PIXEL_DEPTH": 32, "GLUT_GAME_MODE_REFRESH_RATE": 60,
    }  # fmt: skip
    return next((value for name, value in known.items() if NAMES[name] == mode), 0)


def glutExtensionSupported(extension: Any) -> int:
    """1 if the name is in glGetString(GL_EXTENSIONS), else 0.  Needs a window."""
    from glsim import gl

    there: Any = gl.glGetString(gl.GL_EXTENSIONS)
    return int(text_of(extension).encode() in there.split())


def glutGetProcAddress(name: Any) -> None:
    """None: there is no C function."""


def glutReportErrors() -> None:
    """Nothing to report: errors are raised by the call that causes them."""


def glutIgnoreKeyRepeat(ignore: int) -> None:
    """Accepted without effect."""


glutSetKeyRepeat = glutIgnoreKeyRepeat


def glutForceJoystickFunc() -> None:
    """Accepted: there is no joystick."""


def glutSetColor(cell: int, red: float, green: float, blue: float) -> None:
    """Accepted: there is no colour-index mode."""


def glutGetColor(cell: int, component: int) -> float:
    """Always -1.0: there is no colour-index mode."""
    return -1.0


def glutCopyColormap(window: int) -> None:
    """Accepted: there is no colour-index mode."""


def glutEstablishOverlay() -> None:
    """Raises RuntimeError: there are no overlays."""
    raise RuntimeError("glutEstablishOverlay: there are no overlays here; glutLayerGet(GLUT_OVERLAY_POSSIBLE) says so")


def glutRemoveOverlay() -> None:
    """Accepted: there are no overlays."""


glutShowOverlay = glutHideOverlay = glutPostOverlayRedisplay = glutRemoveOverlay


def glutPostWindowOverlayRedisplay(window: int) -> None:
    """Accepted: there are no overlays."""


def glutUseLayer(layer: int) -> None:
    """Accepted: there is only the normal layer."""


def glutVideoResizeGet(param: int) -> int:
    """Always 0: the size of the video signal cannot be changed."""
    return 0


def glutSetupVideoResizing() -> None:
    """Accepted without effect."""


glutStopVideoResizing = glutSetupVideoResizing


def glutVideoResize(x: int, y: int, width: int, height: int) -> None:
    """Accepted without effect."""


glutVideoPan = glutVideoResize


def glutGetModeValues(mode: int, size: Any = None) -> Any:
    """An empty array: freeglut has modes to choose from on X11 only."""
    return (ctypes.c_int * 0)()
