"""Fixtures: one context for all tests, in its initial state for each."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

import glsim
from glsim.render.native import Native, NoNativeError

SIZE = 128


@pytest.fixture(scope="session")
def _screen() -> Iterator[glsim.Offscreen]:
    screen = glsim.offscreen(SIZE, SIZE)
    yield screen
    screen.release()


@pytest.fixture
def screen(_screen: glsim.Offscreen) -> glsim.Offscreen:
    """A current context of 128 x 128 pixels with all state reset."""
    _screen.reset()
    return _screen.make_current()


@pytest.fixture(scope="session")
def native() -> Iterator[Native]:
    """The platform's real fixed function, 128 x 128 pixels."""
    try:
        oracle = Native(SIZE, SIZE)
    except NoNativeError as error:
        if os.environ.get("CI"):
            raise  # there the comparison must be made
        pytest.skip(f"no fixed function to compare with: {error}")
    yield oracle
    oracle.release()
