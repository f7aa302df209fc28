"""A whole run: which snapshots there were, which baselines nobody used, the report, what the terminal says.

With pytest-xdist each worker tells what it collected and the tests' reports carry the snapshots, so that the controller
knows as much as a single process does.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from glsim.testing import baselines
from glsim.testing.settings import Settings, is_foreign

SHOWN = 4  # pictures in a terminal, at most


class Session:
    """Collects what the tests' reports tell.

    tests: test -> its snapshots.  ran: tests that ran; passed: those of them that passed.  whole: files that were
    collected whole -> their tests.  unused: baselines, relative to the root.  lines: what the header says.
    """

    def __init__(self, config: pytest.Config, settings: Settings) -> None:
        self.config, self.settings = config, settings
        self.worker: dict[str, Any] | None = getattr(config, "workeroutput", None)
        self.tests: dict[str, list[dict[str, Any]]] = {}
        self.ran: set[str] = set()
        self.passed: set[str] = set()
        self.whole: dict[str, list[str]] = {}
        self.unused: list[str] = []
        self.lines: list[str] = []
        self.written, self.kept = False, 0
        self._collected: Counter[str] = Counter()

    # ------------------------------------------------------------ before the tests

    def pytest_sessionstart(self, session: pytest.Session) -> None:
        folder = self.settings.folder
        if self.worker is None and is_foreign(folder):
            raise pytest.UsageError(f"--gl-report: {folder} has other files in it: name an empty or a new folder")

    @pytest.hookimpl(optionalhook=True)
    def pytest_configure_node(self, node: Any) -> None:
        node.workerinput["gl_report"] = str(self.settings.folder)

    def pytest_itemcollected(self, item: pytest.Item) -> None:
        self._collected[_file(item.nodeid)] += 1

    @pytest.hookimpl(tryfirst=True)  # the terminal asks for the header's lines in its own hook of this name
    def pytest_collection_finish(self, session: pytest.Session) -> None:
        """Which files were collected whole, and what the header says of the renderer."""
        narrowed = self.config.getoption("lf", False) or any("::" in word for word in self.config.args)
        chosen: dict[str, list[str]] = {}
        for item in session.items:
            chosen.setdefault(_file(item.nodeid), []).append(item.nodeid)
        self.whole = {} if narrowed else {f: ids for f, ids in chosen.items() if len(ids) == self._collected[f]}
        asking = [item for item in session.items if "gl" in getattr(item, "fixturenames", ())]
        first = self.worker is None or os.environ.get("PYTEST_XDIST_WORKER") == "gw0"
        if asking and first and not self.config.getoption("collectonly"):
            self.lines = _header({baselines.folder_of(item.path) for item in asking})
        if self.worker is not None:
            self.worker["glsim"] = {"whole": self.whole, "lines": self.lines}

    def pytest_report_collectionfinish(self) -> list[str]:
        return self.lines

    # ------------------------------------------------------------ the tests

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if hasattr(report, "gl_snapshots"):
            self.tests[report.nodeid] = report.gl_snapshots
        self.ran.add(report.nodeid)
        if report.when == "call" and report.passed and not hasattr(report, "wasxfail"):
            self.passed.add(report.nodeid)
        elif not report.passed:
            self.passed.discard(report.nodeid)

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any, error: Any) -> None:
        told = getattr(node, "workeroutput", {}).get("glsim")
        if told:
            self.whole.update(told["whole"])
            self.lines = self.lines or told["lines"]

    # ------------------------------------------------------------ after the tests

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if self.worker is not None or self.config.getoption("collectonly"):
            return
        if self.settings.unused_fails:
            self.unused = [self._told(path) for path in self._unused()]
        if self.unused and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED
        failed = self.unused or self._of("failed", "missing")
        if failed or (self.settings.report_all and self.tests) or (self.ran and self.settings.folder.is_dir()):
            from glsim.testing.report import update_report

            self.written, self.kept = update_report(self.settings, self._of(), self.unused, self.lines, self._is_old)

    def _is_old(self, test: str) -> bool:
        """Whether what an earlier run said of a test, or of a file's baselines, no longer holds: it ran, or is gone."""
        file, _, name = test.partition("::")
        if not name:
            return file in self.whole
        gone = not (self.settings.root / file).is_file() or test not in self.whole.get(file, [test])
        return gone or test in self.ran

    def _of(self, *statuses: str) -> list[dict[str, Any]]:
        """The snapshots with one of these statuses; all if none is named."""
        return [e for entries in self.tests.values() for e in entries if not statuses or e["status"] in statuses]

    def _unused(self) -> list[Path]:
        """Baselines that no snapshot asked for, of test files that ran whole, and of files that are gone.

        A test that did not pass may not have come to all its snapshots: what can be its baseline is none of them."""
        used: dict[Path, set[str]] = {}
        for entry in self._of():
            used.setdefault(self.settings.root / entry["folder"], set()).update(entry["baselines"])
        unused, folders = [], set()
        for file, tests in self.whole.items():
            path = self.settings.root / file
            folders.add(path.parent / baselines.FOLDER)
            folder = baselines.folder_of(path)
            open_ = [test.partition("::")[2] for test in tests if test not in self.passed]
            unused += [
                picture
                for picture in baselines.pictures(folder)
                if picture.name not in used.get(folder, ())
                and not any(baselines.may_belong(picture.name, test) for test in open_)
            ]
        for folder in (inner for outer in folders if outer.is_dir() for inner in outer.iterdir() if inner.is_dir()):
            if not any(folder.parent.parent.glob(f"{_escaped(folder.name)}.*")):
                unused += baselines.pictures(folder)
        return sorted(unused)

    def _told(self, path: Path) -> str:
        return path.relative_to(self.settings.root).as_posix() if path.is_relative_to(self.settings.root) else str(path)

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        write: Callable[..., None] = terminalreporter.write_line
        failed, missing, updated = (self._of(status) for status in ("failed", "missing", "updated"))
        if not (failed or missing or updated or self.unused or self.written):
            return
        terminalreporter.section("pictures (glsim)", sep="=")
        if self.config.getoption("numprocesses", None):
            for line in self.lines:
                write(line)
        for entry in updated:
            write(f"baseline written: {entry['message']}")
        for path in self.unused:
            write(f"unused baseline: {path}", red=True)
        if self.unused:
            write(
                f"{len(self.unused)} unused baselines are a failure (--gl-unused=ignore: they are none); remove"
                f" them: glsim snapshots clean {self._folder()}",
                red=True,
            )
        if failed or missing:
            write(f"{len(failed)} pictures failed, {len(missing)} have no baseline", red=True)
        if self.written:
            earlier = f", with {self.kept} pictures of an earlier run, whose tests did not run" if self.kept else ""
            write(f"report: {self._folder()}/index.html{earlier}")
        if failed or missing:
            write(f"approve pictures that are right: glsim snapshots approve {self._folder()}")
        from glsim.testing.terminal import show

        shown = [entry["difference"] or entry["candidate"] for entry in failed + missing]
        show(self.config, terminalreporter, [self.settings.folder / path for path in shown if path][:SHOWN])

    def _folder(self) -> str:
        """The report's folder, as it is typed."""
        folder, here = self.settings.folder, self.config.invocation_params.dir
        return str(folder.relative_to(here)) if folder.is_relative_to(here) else str(folder)


def _file(nodeid: str) -> str:
    return nodeid.partition("::")[0]


def _escaped(name: str) -> str:
    from glob import escape

    return escape(name)


def _header(folders: set[Path]) -> list[str]:
    """Who draws here, who drew the baselines, and whether the two can be compared."""
    from glsim.testing import screens

    try:
        here = {**screens.probe()[0], "probe": screens.digest()}
    except Exception as error:  # each test that draws says it again, as its own error
        return [f"glsim: nothing can be drawn here: {str(error).splitlines()[0]}"]
    lines = [f"glsim: pictures are drawn by {here['renderer']}, {here['version']}"]
    made: Counter[tuple[str, str, str]] = Counter()
    for folder in folders:
        for path in baselines.pictures(folder):
            facts = baselines.facts(path)
            if facts.get("renderer") and not baselines.same_renderer(facts, here):
                made[facts["renderer"], facts.get("version", ""), facts.get("probe", "")] += 1
    for (renderer, version, digest), count in made.most_common():
        alike = digest == screens.digest()
        verdict = "which draws glsim's probe picture as this one does" if alike else screens.comparable()
        lines.append(f"glsim: {count} baselines are of {renderer}, {version}: {verdict}")
    return lines
