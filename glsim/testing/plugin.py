"""The pytest plugin: the fixtures ``gl`` and ``gl_snapshot``, the marker ``gl``, the options.

pytest imports this file wherever glsim is installed, so NumPy, moderngl and the rest of glsim are imported by the
fixtures, when a test asks for them.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from typing import TYPE_CHECKING, Any

import pytest

from glsim.testing.session import Session
from glsim.testing.settings import Settings, in_ci, settings_of

if TYPE_CHECKING:
    from glsim.render.context import Offscreen
    from glsim.testing.screens import Screens
    from glsim.testing.snapshot import Snapshot

SIZE = (256, 256)
MARKER = "gl(size=(width, height), samples=n): the picture of the fixture gl; 256 x 256, no multisampling if not given"
SETTINGS = pytest.StashKey[Settings]()
SNAPSHOT = pytest.StashKey["Snapshot | None"]()
SCREEN = pytest.StashKey["Offscreen | None"]()


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("glsim", "snapshots of pictures (glsim)")
    group.addoption(
        "--gl-update", action="store_true", help="write baselines: the first one, or that of this renderer anew"
    )
    group.addoption(
        "--gl-unused", choices=("fail", "ignore"), default="fail", help="what an unused baseline does (default: fail)"
    )
    group.addoption(
        "--gl-report", metavar="DIR", help="write the report of all pictures there (default: gl-report, if one fails)"
    )


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", MARKER)
    if config.getoption("--gl-update") and in_ci():
        raise pytest.UsageError(
            "--gl-update writes baselines into the source, and in CI nobody looks at them first: approve the report's"
            " pictures with 'glsim snapshots approve', or empty the environment variable CI for this command"
        )
    config.stash[SETTINGS] = settings_of(config)
    config.pluginmanager.register(Session(config, config.stash[SETTINGS]), "glsim-session")


# ---------------------------------------------------------------- fixtures


@pytest.fixture(scope="session")
def _gl_screens() -> Iterator[Screens]:
    from glsim.testing.screens import Screens

    screens = Screens()
    yield screens
    screens.release()


@pytest.fixture
def gl(request: pytest.FixtureRequest, _gl_screens: Screens) -> Iterator[Offscreen]:
    """A current context in its initial state: a glsim.Offscreen.  ``from glsim.gl import *`` has the commands.

    ``@pytest.mark.gl(size=(width, height), samples=4)`` says how large.  A test that passes, but leaves textures,
    buffer objects, queries or display lists behind, or glBegin or glNewList open, fails.
    """
    screen = _clean(request, _gl_screens, "test", None)
    request.node.stash[SCREEN] = screen
    with screen:
        yield screen


@pytest.fixture
def gl_snapshot(request: pytest.FixtureRequest) -> Snapshot:
    """``gl_snapshot(what, name=None, ...)`` holds a picture against its approved baselines: see snapshot.py."""
    from glsim.testing.snapshot import Snapshot

    def screen(purpose: str, size: Any) -> Offscreen:
        return _clean(request, request.getfixturevalue("_gl_screens"), purpose, size)

    snapshot = Snapshot(request.node, request.config.stash[SETTINGS], screen)
    request.node.stash[SNAPSHOT] = snapshot
    return snapshot


def _clean(request: pytest.FixtureRequest, screens: Screens, purpose: str, size: Any) -> Offscreen:
    """A clean context, as the test's markers say; ``size`` overrides theirs."""
    from glsim.render.device import NoDeviceError

    values: dict[str, Any] = {"size": SIZE, "samples": 0}
    for marker in reversed(list(request.node.iter_markers("gl"))):  # the closest one last
        if marker.args or not marker.kwargs.keys() <= values.keys():
            pytest.fail(f"a marker is {MARKER}; not {marker.args or marker.kwargs}", pytrace=False)
        values.update(marker.kwargs)
    try:
        width, height = size or values["size"]
    except (TypeError, ValueError):
        pytest.fail(f"pytest.mark.gl: size is (width, height), not {values['size']!r}", pytrace=False)
    try:
        return screens.clean(purpose, width, height, values["samples"])
    except (ValueError, NoDeviceError) as error:
        sentence = str(error)
    pytest.fail(sentence, pytrace=False)


# ---------------------------------------------------------------- the end of a test


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Generator[None, Any, Any]:
    """Let a test that passed fail if one of its pictures does, or if it leaves GL objects behind or something open."""
    try:
        result = yield
    except BaseException:
        if snapshot := item.stash.get(SNAPSHOT, None):
            snapshot.told_beside_another_error()
        raise
    if snapshot := item.stash.get(SNAPSHOT, None):
        snapshot.verify()
    if screen := item.stash.get(SCREEN, None):
        from glsim.testing.screens import leaks

        if sentence := leaks(screen):
            pytest.fail(sentence, pytrace=False)
    return result


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: Any) -> Generator[None, Any, Any]:
    """The results of a test's snapshots travel with its report, from workers too."""
    report = yield
    if call.when == "call" and (snapshot := item.stash.get(SNAPSHOT, None)):
        report.gl_snapshots = snapshot.results()
    if call.when == "teardown":
        item.stash[SNAPSHOT], item.stash[SCREEN] = None, None  # a test that is run again begins anew
    return report
