"""GLUT: initialization and the main loop; freeglut's functions where it has more."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from glsim.glut import fonts
from glsim.glut.constants import NAMES
from glsim.glut.loop import FinishedError, loop
from glsim.glut.menus import text_of
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
    argv = next((a for a in arguments if isinstance(a, (list, tuple))), arguments)
    return [a for a in argv if not isinstance(a, int)]


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
    settings.size = checked_size("glutInitWindowSize", width, height)


def checked_size(name: str, width: int, height: int) -> tuple[int, int]:
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
