"""Telling how far the work is."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[str, int, int], object]  # is called with the stage's name, how much is done, and of how much


def silent(stage: str, done: int, of: int) -> None:
    """Do nothing: the Progress that is used where the caller gives none."""
