"""Fixtures: one context for all tests, in its initial state for each."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings

import glsim
from glsim.render.native import Native, NoNativeError

if TYPE_CHECKING:
    from tests.browser import Browser

SIZE = 128

# Fixtures are reset by the tests themselves, and drawing takes the time that it takes.  In CI the examples are the same
# in each run, so that a failure belongs to the change and not to chance.
slow = [HealthCheck.function_scoped_fixture, HealthCheck.too_slow]
settings.register_profile("here", deadline=None, suppress_health_check=slow)
settings.register_profile("ci", settings.get_profile("here"), derandomize=True, database=None)
settings.load_profile("ci" if os.environ.get("CI") else "here")


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


@pytest.fixture(scope="module")
def native() -> Iterator[Native]:
    """The platform's real fixed function, 128 x 128 pixels; what random calls leave in it ends with their file."""
    try:
        oracle = Native(SIZE, SIZE)
    except NoNativeError as error:
        if os.environ.get("CI"):
            raise  # there the comparison must be made
        pytest.skip(f"no fixed function to compare with: {error}")
    yield oracle
    oracle.release()


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """One headless Chromium for all tests of pages."""
    try:
        from tests.browser import Browser

        chromium = Browser()
    except (ImportError, RuntimeError) as error:
        if os.environ.get("CI"):
            raise  # there the pages must be seen
        pytest.skip(f"no browser to show pages in: {error}")
    yield chromium
    chromium.quit()
