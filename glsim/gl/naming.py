"""Names of objects: textures, buffer objects, queries and display lists are numbers that the machine gives out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from glsim.gl.arguments import numbers
from glsim.machine.errors import invalid_value, out_of_memory
from glsim.machine.machine import MOST_NAMES, Machine
from glsim.machine.types import fill


def new_names(m: Machine, kind: str, n: int, is_used: Callable[[int], bool]) -> list[int]:
    """The ``n`` smallest unused names.  kind: "textures", "buffers", "queries" or "lists"."""
    if n < 0:
        raise invalid_value("n", n, "at least 0")
    if n > MOST_NAMES:
        raise out_of_memory(f"{n} names are more than the {MOST_NAMES} that can be")
    names: list[int] = []
    name = m.objects.lowest.get(kind, 1)
    while len(names) < n:
        if not is_used(name):
            names.append(name)
        name += 1
    m.objects.lowest[kind] = name
    return names


def free_name(m: Machine, kind: str, name: int) -> None:
    """The name can be given again."""
    m.objects.lowest[kind] = min(m.objects.lowest.get(kind, 1), name)


def returned_names(names: Sequence[int], array: Any) -> Any:
    """Names as PyOpenGL returns them: one number, an array of several, or ``array`` filled with them."""
    if array is not None:
        return fill(array, names)
    return np.uint32(names[0]) if len(names) == 1 else np.array(names, np.uint32)


def names_from(n: Any, names: Any) -> list[int]:
    """glDeleteTextures(n, names), or in PyOpenGL's form glDeleteTextures(names)."""
    if names is None:
        return [int(name) for name in numbers(n)]
    if int(n) < 0:
        raise invalid_value("n", n, "at least 0")
    return [int(name) for name in numbers(names)[: int(n)]]
