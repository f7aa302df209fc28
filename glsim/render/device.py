"""Opening an OpenGL context without a window: EGL, OSMesa, X11, or what macOS and Windows have.

A loader is an object with ``load(name)``, ``__enter__``, ``__exit__`` and ``release``, as glcontext makes them.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from glsim.machine.current import forget

LIBRARIES = "apt install libegl1 libgl1 libgl1-mesa-dri"
FIXES = {
    "egl": LIBRARIES,
    "osmesa": "apt install libosmesa6 (Mesa older than 25.1)",
    "x11": "set DISPLAY, or start the program with xvfb-run -a",
    "native": "install the graphics driver of this machine",
}


FORKED = (
    "this process was forked from one that had opened a context, and the driver's threads stayed behind there: start"
    ' processes with multiprocessing.get_context("spawn"), or fork before the first glsim.offscreen'
)
_opened_by = 0  # the process that opened contexts


@dataclass(frozen=True)
class Attempt:
    """One way that was tried: what it said, and what would help."""

    backend: str
    said: str
    fix: str


class NoDeviceError(RuntimeError):
    """No OpenGL context could be opened; ``attempts`` lists what was tried."""

    def __init__(self, attempts: list[Attempt]) -> None:
        self.attempts = attempts
        lines = [f"  {a.backend}: {a.said}  ->  {a.fix}" for a in attempts]
        super().__init__("no OpenGL context could be opened. Tried:\n" + "\n".join(lines))


def _glcontext(**settings: Any) -> Any:
    import glcontext

    return glcontext.default_backend()(mode="standalone", glversion=330, **settings)


def _egl(device: int | None) -> Any:
    from glsim.render.egl import EGLLoader

    return EGLLoader(core=True, device=device)


def _x11(device: int | None) -> Any:
    if not os.environ.get("DISPLAY"):
        raise RuntimeError("DISPLAY is not set")
    return _glcontext(libgl="libGL.so.1", libx11="libX11.so.6")


def _osmesa(device: int | None) -> Any:
    from glsim.render.osmesa import OSMesaLoader

    return OSMesaLoader(core=True)


def _native(device: int | None) -> Any:
    return _glcontext()


BACKENDS: dict[str, Callable[[int | None], Any]] = {"egl": _egl, "osmesa": _osmesa, "x11": _x11, "native": _native}


def order(backend: str = "auto") -> list[tuple[str, int | None]]:
    """The ways to try: ``backend`` if it names one ("egl", "egl:1", ...), else GLSIM_BACKEND, else the platform's.

    The number after a colon is the EGL device index; without one GLCONTEXT_DEVICE_INDEX is honoured.
    """
    wanted = backend if backend != "auto" else os.environ.get("GLSIM_BACKEND", "auto")
    if wanted == "auto":
        names = ["egl", "osmesa", "x11"] if platform.system() == "Linux" else ["native"]
        return [(name, None) for name in names]
    name, _, index = wanted.partition(":")
    if name not in BACKENDS or (index and not index.isdigit()):
        raise ValueError(f"backend must be auto, {', '.join(BACKENDS)} or egl:N, not {wanted!r}")
    return [(name, int(index) if index else None)]


def forked() -> bool:
    """Whether contexts were opened in the process from which this one was forked."""
    return _opened_by not in (0, os.getpid())


def refuse_fork() -> None:
    """Raise RuntimeError in a process that was forked after a context had been opened: drawing would hang there.

    A new context would hang too: Mesa's screens and locks exist once for a process, and their threads do not survive a
    fork.
    """
    if forked():
        raise RuntimeError(FORKED)


def opening() -> None:
    """Note that this process opens a context; after a fork the gl commands say what is wrong."""
    global _opened_by
    refuse_fork()
    if not _opened_by and hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=lambda: forget(FORKED))
    _opened_by = os.getpid()


def open_loader(backend: str = "auto") -> tuple[str, Any]:
    """The first way that opens: (name, loader).  Raises NoDeviceError that tells about every attempt."""
    opening()
    attempts = []
    for name, device in order(backend):
        try:
            return name, BACKENDS[name](device)
        except Exception as error:  # whatever a driver says is told to the user
            attempts.append(Attempt(name, one_line(error), FIXES[name]))
    raise NoDeviceError(attempts)


def one_line(error: BaseException) -> str:
    return " ".join(str(error).split()) or type(error).__name__
