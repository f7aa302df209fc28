"""GLUT: what glutGet and its kin answer; game mode; and what has no effect here (overlays, colour maps, video)."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

from glsim.glut.api import settings
from glsim.glut.constants import NAMES
from glsim.glut.loop import SCREEN, loop
from glsim.glut.menus import text_of


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
    values = {
        "GLUT_GAME_MODE_POSSIBLE": 1, "GLUT_GAME_MODE_WIDTH": SCREEN[0], "GLUT_GAME_MODE_HEIGHT": SCREEN[1],
        "GLUT_GAME_MODE_PIXEL_DEPTH": 32, "GLUT_GAME_MODE_REFRESH_RATE": 60,
    }  # fmt: skip
    return next((value for name, value in values.items() if NAMES[name] == mode), 0)


def glutExtensionSupported(extension: Any) -> int:
    """1 if the name is in glGetString(GL_EXTENSIONS), else 0.  Needs a window."""
    from glsim import gl

    extensions: Any = gl.glGetString(gl.GL_EXTENSIONS)
    return int(text_of(extension).encode() in extensions.split())


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
