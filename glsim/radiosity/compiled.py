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
prange = nb.prange  # for others, so that the sentence above comes first


def _compiled(function: Function, **options: Any) -> Function:
    """Compile a function, with a cache on disk where numba finds a folder for it."""
    try:
        compiled: Any = nb.njit(cache=True, nogil=True, error_model="numpy", **options)(function)
    except (RuntimeError, OSError):  # numba finds no folder that it may write into
        compiled = nb.njit(nogil=True, error_model="numpy", **options)(function)
    return compiled  # type: ignore[no-any-return]


def jit(function: Function) -> Function:
    """Compile a function at its first call.

    The machine code is kept on disk for the next run if one of these folders can be written: NUMBA_CACHE_DIR, glsim's
    own, one in the user's home.
    """
    return _compiled(function)


def parallel(function: Function) -> Function:
    """Compile a function like ``jit``, with several threads for its loops over ``prange``."""
    return _compiled(function, parallel=True)


def is_cached(function: Any) -> bool:
    """Return whether a compiled function is kept on disk for the next run."""
    return bool(function.stats.cache_path)
