"""Compiling inner loops with numba."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from glsim.radiosity.scene import SceneError

try:
    import numba as nb
except ModuleNotFoundError as error:
    raise SceneError("radiosity needs the package numba: pip install glsim[radiosity]") from error

Function = TypeVar("Function", bound=Callable[..., Any])
prange = nb.prange  # import it from here, so that a missing numba raises the SceneError above


def _compiled(function: Function, **options: Any) -> Function:
    """Compile a function, with a cache on disk where numba finds a folder for it."""
    try:
        compiled: Any = nb.njit(cache=True, nogil=True, error_model="numpy", **options)(function)
    except (RuntimeError, OSError):  # numba finds no folder that it may write into
        compiled = nb.njit(nogil=True, error_model="numpy", **options)(function)
    return compiled  # type: ignore[no-any-return]


def jit(function: Function) -> Function:
    """Compile a function at its first call.

    numba stores the machine code on disk for the next run, in the first of these folders that it can write to:
    NUMBA_CACHE_DIR, __pycache__ beside the source, one in the user's home.
    """
    return _compiled(function)


def parallel(function: Function) -> Function:
    """Compile a function like ``jit``, with several threads for its loops over ``prange``."""
    return _compiled(function, parallel=True)


def is_cached(function: Any) -> bool:
    """Return whether a compiled function is kept on disk for the next run."""
    return bool(function.stats.cache_path)
