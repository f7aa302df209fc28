"""``gl_snapshot`` of one test: takes pictures, judges them, and tells at the end of the test what failed."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from glsim.images import Pixels, rgba
from glsim.testing import baselines
from glsim.testing.baselines import Baseline
from glsim.testing.report import write_difference
from glsim.testing.rule import empty, judge, must_differ, ranges_of
from glsim.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable

    from glsim.render.context import Offscreen
    from glsim.testing.settings import Settings

__tracebackhide__ = True  # pytest then shows the lines of tests, and none of this file
GLSIM = Path(__file__).parents[1]
PASSED, CLOSE, FAILED, MISSING, UPDATED = "passed", "close", "failed", "missing", "updated"


@dataclass
class Entry:
    """What became of one snapshot, for the report; paths are relative, with slashes.

    status: "passed" (equal), "close" (within the rule or the tolerances), "failed", "missing" (no baseline yet) or
        "updated".  base: the name of its baselines without ending; folder: where they lie, from the project's root.
    closest: the file name of the closest baseline.  candidate, difference: files in the report's folder.
    """

    test: str
    name: str
    base: str
    folder: str
    status: str = PASSED
    message: str = ""
    closest: str = ""
    candidate: str = ""
    difference: str = ""
    baselines: list[str] = field(default_factory=list)


class Snapshot:
    """The fixture ``gl_snapshot``.  Call it with a picture, or what makes one."""

    def __init__(self, item: Any, settings: Settings, screen: Callable[[str, Any], Offscreen]) -> None:
        self._item, self._settings, self._screen = item, settings, screen
        self._folder = baselines.folder_of(item.path)
        self._test = item.nodeid.partition("::")[2]
        self._taken: dict[str, str] = {}  # name -> the line that took it
        self._failures: list[str] = []
        self.entries: list[Entry] = []

    def __call__(
        self,
        what: Any,
        name: str | None = None,
        *,
        size: Sequence[int] | None = None,
        origin: str = "upper",
        renderer: str = "",
        **tolerances: float | tuple[float, float],
    ) -> None:
        """Hold a picture against its approved baselines.  The test fails at its end if a picture did.

        what: the fixture ``gl`` (its picture as a window shows it, without alpha), a Frame, a function that draws with
            the gl commands (into a clean context of its own), or whatever ``glsim.images.rgba`` takes.
        name: tells the snapshots of one test apart.
        size, origin: of what glReadPixels returned, see ``rgba``.
        renderer: who drew a picture that does not know it, for example ctx.info["GL_RENDERER"].  Pictures of another
            renderer than the baselines' may differ as its rounding does.
        tolerances: instead of the rule, the range (least, most) of a number, or its most alone: ``max``, ``mean``,
            ``rmse`` (0 to 255), ``different`` (share of pixels), ``ssim``, ``flip``, ``blocks``.  With a least above 0
            the picture must differ from the snapshot of this name, which the test has taken before.

        Raises TypeError or ValueError for what is no picture or no tolerance.
        """
        try:
            self._hold(what, name, size, origin, renderer, ranges_of(tolerances))
        except Exception as error:
            if not self._item.config.getoption("fulltrace"):
                _end_outside(error)
            raise

    def _hold(
        self, what: Any, name: str | None, size: Sequence[int] | None, origin: str, renderer: str, ranges: Any
    ) -> None:
        line = _line(self._item.path)
        name = self._checked_name(name or "", line, must_differ(ranges))
        pixels, made = self._picture(what, size, origin, renderer)
        entry = Entry(self._item.nodeid, name, baselines.base_name(self._test, name), self._relative(self._folder))
        approved = [(found, baselines.read(found.path)) for found in baselines.find(self._folder, entry.base)]
        entry.baselines = [baseline.path.name for baseline, _ in approved]
        if approved:
            self._judged(entry, pixels, made, approved, ranges)
        elif must_differ(ranges):
            entry.status, entry.message = FAILED, "There is no baseline that the picture could differ from."
        elif self._settings.update:
            self._write(entry, pixels, made)
        else:
            self._missing(entry, pixels, made)
        self.entries.append(entry)
        if entry.status in (FAILED, MISSING):
            self._failures.append(self._told(entry, line))

    # ------------------------------------------------------------ the picture

    def _picture(
        self, what: Any, size: Sequence[int] | None, origin: str, renderer: str
    ) -> tuple[Pixels, dict[str, str]]:
        """The pixels of anything, and what is known of who drew them."""
        render = sys.modules.get("glsim.render.context")  # whoever has a screen has imported it
        frames = sys.modules.get("glsim.machine.frame")
        if render is not None and isinstance(what, render.Offscreen):
            return self._of_screen(what, renderer)
        if frames is not None and isinstance(what, frames.Frame):
            screen = self._screen("picture", (what.width, what.height))
            screen.execute(what.packets)
            return self._of_screen(screen, renderer)
        if callable(what) and not hasattr(what, "__array__"):
            screen = self._screen("picture", None)
            with screen:
                what()
                return self._of_screen(screen, renderer)
        made = {"renderer": renderer} if renderer else _known_renderer(what)
        return rgba(what, size=size, origin=origin), made

    @staticmethod
    def _of_screen(screen: Offscreen, renderer: str) -> tuple[Pixels, dict[str, str]]:
        from glsim.testing.screens import digest, facts, opaque, probe

        made = facts(screen)
        if renderer:
            return opaque(screen), {**made, "renderer": renderer}
        return opaque(screen), {**made, "probe": digest()} if made == probe()[0] else made

    def _checked_name(self, name: str, line: str, differs: bool) -> str:
        if not isinstance(name, str):
            raise TypeError(f"gl_snapshot: name is a string, not {name!r}")
        if differs:
            return name
        if name in self._taken:
            told = f'name="{name}"' if name else "no name"
            raise ValueError(
                f"gl_snapshot: this test has taken a snapshot with {told} before ({self._taken[name]}): give each its"
                " own name=..."
            )
        self._taken[name] = line
        return name

    # ------------------------------------------------------------ the verdict

    def _judged(
        self, entry: Entry, pixels: Pixels, made: dict[str, str], approved: list[tuple[Baseline, Pixels]], ranges: Any
    ) -> None:
        verdict, differs = judge(pixels, made, approved, ranges), must_differ(ranges)
        entry.closest, entry.message = verdict.closest.path.name, verdict.reason
        if verdict.passed:
            entry.status = PASSED if verdict.exact else CLOSE
            if entry.status == CLOSE and self._settings.report_all and not differs:
                self._keep(entry, pixels, made, verdict.expected)
        elif differs:  # the picture of another snapshot, which must never be approved in this one's place
            entry.status, entry.message = FAILED, verdict.reason
            entry.difference = f"differences/{self._place(entry)}-differs.png"
            write_difference(self._settings.folder / entry.difference, verdict.expected, pixels)
        elif self._settings.update:
            self._write(entry, pixels, made)
        else:
            entry.status = FAILED
            entry.message = verdict.reason
            self._keep(entry, pixels, made, verdict.expected)

    def _missing(self, entry: Entry, pixels: Pixels, made: dict[str, str]) -> None:
        self._keep(entry, pixels, made, None)
        entry.status = MISSING
        entry.message = f"There is no approved baseline. {empty(pixels)}".strip()

    def _write(self, entry: Entry, pixels: Pixels, made: dict[str, str]) -> None:
        path = baselines.target(self._folder, entry.base, made, entry.closest)
        baselines.write(path, pixels, self._facts(pixels, made))
        entry.status, entry.message = UPDATED, self._relative(path)
        entry.baselines = [baseline.path.name for baseline in baselines.find(self._folder, entry.base)]

    def _keep(self, entry: Entry, pixels: Pixels, made: dict[str, str], expected: Pixels | None) -> None:
        """Write the picture, and how it differs, into the report's folder."""
        place = self._place(entry)
        entry.candidate = f"candidates/{place}.png"
        baselines.write(self._settings.folder / entry.candidate, pixels, self._facts(pixels, made))
        if expected is not None:
            entry.difference = f"differences/{place}.png"
            write_difference(self._settings.folder / entry.difference, expected, pixels)

    @staticmethod
    def _place(entry: Entry) -> str:
        return f"{entry.folder.replace('../', '')}/{entry.base}"

    @staticmethod
    def _facts(pixels: Pixels, made: dict[str, str]) -> dict[str, str]:
        """The text chunks of a picture that is written."""
        return {**made, "size": f"{pixels.shape[1]} x {pixels.shape[0]}", "glsim": __version__}

    def _told(self, entry: Entry, line: str) -> str:
        """What failed, and where to look."""
        lines = [f"{line}: snapshot {entry.base}", entry.message]
        lines += [f"closest baseline:  {entry.folder}/{entry.closest}"] if entry.closest else []
        lines += (
            [f"picture:           {self._relative(self._settings.folder / entry.candidate)}"] if entry.candidate else []
        )
        lines += (
            [f"difference:        {self._relative(self._settings.folder / entry.difference)}"]
            if entry.difference
            else []
        )
        return "\n    ".join(lines)

    def _relative(self, path: Path) -> str:
        try:
            return path.relative_to(self._settings.root).as_posix()
        except ValueError:
            return path.as_posix()

    # ------------------------------------------------------------ the end of the test

    def verify(self) -> None:
        """Fail the test for each picture that failed, or if none was taken."""
        if not self.entries and not self._failures:
            pytest.fail("the fixture gl_snapshot was never called: call it with a picture, or remove it", pytrace=False)
        failures, self._failures = self._failures, []
        if failures:
            pytest.fail("\n".join(failures), pytrace=False)

    def told_beside_another_error(self) -> None:
        """Put the pictures that failed into a section of the test's report, when the test ended with another error."""
        if self._failures:
            self._item.add_report_section("call", "glsim", "\n".join(self._failures))
            self._failures = []

    def results(self) -> list[dict[str, Any]]:
        """The entries as plain values, which workers can send."""
        return [asdict(entry) for entry in self.entries]


def _known_renderer(what: Any) -> dict[str, str]:
    """Who drew a picture that knows its context: a moderngl.Framebuffer."""
    info = getattr(getattr(what, "ctx", None), "info", None)
    if not isinstance(info, dict) or "GL_RENDERER" not in info:
        return {}
    return {"renderer": str(info["GL_RENDERER"]), "version": str(info.get("GL_VERSION", ""))}


def _end_outside(error: Exception) -> None:
    """Let a traceback end in the last line that is none of glsim's: what is wrong is there.  --full-trace has all."""
    last = entry = error.__traceback__
    while entry is not None:
        if not Path(entry.tb_frame.f_code.co_filename).is_relative_to(GLSIM):
            last = entry
        entry = entry.tb_next
    if last is not None:
        last.tb_next = None


def _line(test_file: Path) -> str:
    """``test_ball.py:12``: the innermost line of the test's file that is being executed."""
    frame = sys._getframe(2)
    while frame is not None and frame.f_back is not None and Path(frame.f_code.co_filename) != test_file:
        frame = frame.f_back
    inside = frame is not None and Path(frame.f_code.co_filename) == test_file
    return f"{test_file.name}:{frame.f_lineno}" if inside else test_file.name
