"""A cache for the results of functions, limited in bytes."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar

import numpy as np

R = TypeVar("R")


def size_of(value: Any) -> int:
    """Bytes of the arrays in it."""
    if isinstance(value, np.ndarray):
        return value.nbytes
    return sum(map(size_of, value)) if isinstance(value, tuple) else 0


def cached(limit: int) -> Callable[[Callable[..., R]], Callable[..., R]]:
    """A decorator like functools.lru_cache whose cache is limited in bytes.

    limit: bytes of the arrays in all cached results.  A result of more than a quarter of ``limit`` is not cached.
    """

    def decorate(function: Callable[..., R]) -> Callable[..., R]:
        results: OrderedDict[tuple[Any, ...], tuple[R, int]] = OrderedDict()
        lock = threading.Lock()
        total = 0

        @wraps(function)
        def call(*arguments: Any) -> R:
            nonlocal total
            with lock:
                if arguments in results:
                    results.move_to_end(arguments)
                    return results[arguments][0]
            value = function(*arguments)
            size = size_of(value) + 1024  # and what Python needs
            with lock:
                if size <= limit // 4 and arguments not in results:
                    results[arguments] = value, size
                    total += size
                while total > limit:
                    total -= results.popitem(last=False)[1][1]
            return value

        return call

    return decorate
