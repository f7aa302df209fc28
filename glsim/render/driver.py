"""A context of the driver: the thread that it belongs to, and when it is released."""

from __future__ import annotations

import weakref
from contextlib import suppress
from typing import Any

import moderngl

from glsim.machine.current import ThreadState, this_thread
from glsim.machine.interrupts import uninterrupted
from glsim.render.device import forked, open_loader
from glsim.render.egl import EGLLoader
from glsim.render.osmesa import OSMesaLoader


class DriverContext:
    """A context of the driver, and the thread that it belongs to."""

    def __init__(self, backend: str) -> None:
        self.backend, self.loader = open_loader(backend)
        try:
            self.ctx = moderngl.create_context(context=self.loader, require=330)
        except BaseException:
            self.loader.release()
            raise
        self.take()

    def take(self) -> None:
        """Make the calling thread the owner; when that thread ends, the context has no owner."""
        self.owner: weakref.ref[ThreadState] = weakref.ref(this_thread())
        self.finalizer = weakref.finalize(this_thread(), self._release_current, self.loader)
        self.finalizer.atexit = False

    def is_free(self) -> bool:
        """Whether the calling thread may use it: it is the owner, or the owner has ended."""
        return self.owner() in (None, this_thread())

    @staticmethod
    def _release_current(loader: Any) -> None:
        if isinstance(loader, (EGLLoader, OSMesaLoader)) and not forked():
            loader.release_current()

    def detach(self) -> None:
        self._release_current(self.loader)

    def release(self) -> None:
        self.finalizer.detach()
        with uninterrupted():
            self.loader.__enter__()
            self.ctx.release()  # releases the loader too
            if isinstance(self.loader, EGLLoader):
                self.loader.__exit__()


_abandoned: list[DriverContext] = []  # contexts without a reference left, to be released at the next occasion


def abandon(context: DriverContext) -> None:
    """Release a context a little later: now another one may be drawing, which must stay current."""
    _abandoned.append(context)


def release_abandoned() -> None:
    """Release the contexts that nobody holds, of this thread and of those that have ended; not while one is drawing."""
    for context in [context for context in _abandoned if context.is_free()]:
        with suppress(Exception):
            _abandoned.remove(context)  # ValueError: another thread was faster
            context.release()
