"""Lessons as files: Python programs in percent format, cut into cells of Markdown and of code.

    # %% [markdown]
    # # 7. Lambert's law
    # The cosine of the angle between $N$ and $L$ ...

    # %% The caption of the figure that this cell shows
    glutSolidSphere(1, 40, 40)
    screen

Jupyter (through jupytext), VS Code and Spyder open such a file as a notebook; Python runs it as a program.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from pathlib import Path

from glsim.files import data_folder
from glsim.names import did_you_mean

MARKER = re.compile(r"# %%(?P<title>.*)")
NAME = re.compile(r"(?P<number>\d\d)_(?P<topic>\w+)\.py")
MARKDOWN = "[markdown]"
PREDICTION = re.compile(r"^## Predict\b", re.MULTILINE)
ANSWER = re.compile(r"^## What you should see\n+(.*?)\n*(?=^## |\Z)", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Cell:
    """A cell of a lesson.

    kind: "markdown" or "code".  source: Markdown without the leading "# ", or Python.  title: what stands
    behind ``# %%``; of code that shows a figure it is the caption.  line: of the file, where the source begins, from 1.
    """

    kind: str
    source: str
    title: str
    line: int


def folded(source: str) -> str:
    """A cell's Markdown with the answer to the prediction folded into <details>, as the answers to questions are."""
    return ANSWER.sub(r'<details class="answer"><summary>What you should see</summary>\n\n\1\n\n</details>\n\n', source)


def unanswered(source: str) -> str:
    """A cell's Markdown with dots in place of every answer: that to the prediction, and those to questions."""
    return re.sub(r"<details.*?<summary>(.*?)</summary>.*?</details>", r"*\1: …*", folded(source), flags=re.DOTALL)


@dataclass(frozen=True)
class Lesson:
    """A lesson: its file, its number in the lecture's order, and its cells."""

    path: Path
    number: int
    cells: tuple[Cell, ...]

    @property
    def name(self) -> str:
        """The file's name without its ending: 07_lambert."""
        return self.path.stem

    @cached_property
    def title(self) -> str:
        """The first heading, without the number."""
        heading = re.search(r"^# (?:\d+\. )?(.+)$", self._prose, re.MULTILINE)
        return heading[1] if heading else self.name

    @cached_property
    def about(self) -> str:
        """The first paragraph below the title."""
        paragraphs = [p.strip() for p in self._prose.split("\n\n")]
        return next((" ".join(p.split()) for p in paragraphs if p and p[0] not in "#>-$<"), "")

    @cached_property
    def _prose(self) -> str:
        return "\n\n".join(cell.source for cell in self.cells if cell.kind == "markdown")


def read(path: Path) -> Lesson:
    """The lesson in a file.

    Raises FileNotFoundError if there is no such file, ValueError if its name is not NN_topic.py, if it has no cells or
    if a line of a Markdown cell is no comment."""
    name = NAME.fullmatch(path.name)
    if not name:
        raise ValueError(f"{path}: the name of a lesson is NN_topic.py, such as 07_lambert.py")
    if not path.is_file():
        raise FileNotFoundError(f"there is no lesson {path}")
    lines = path.read_text(encoding="utf-8").splitlines()
    starts = [k for k, line in enumerate(lines) if MARKER.fullmatch(line)]
    if not starts:
        raise ValueError(f"{path}: a lesson has cells that begin with # %% or # %% [markdown]")
    ends = [*starts[1:], len(lines)]
    return Lesson(
        path, int(name["number"]), tuple(_cell(path, lines, *span) for span in zip(starts, ends, strict=True))
    )


def _cell(path: Path, lines: list[str], start: int, end: int) -> Cell:
    title = lines[start].removeprefix("# %%").strip()
    first = start + 1
    while first < end and not lines[first].strip():
        first += 1
    body = lines[first:end]
    if not title.startswith(MARKDOWN):
        return Cell("code", "\n".join(body).rstrip(), title, first + 1)
    for number, line in enumerate(body, first + 1):
        if line.strip() and not line.startswith("#"):
            raise ValueError(f"{path}, line {number}: lines of a Markdown cell begin with #")
    text = "\n".join(line.removeprefix("#").removeprefix(" ") for line in body)
    return Cell("markdown", text.strip(), title.removeprefix(MARKDOWN).strip(), first + 1)


def lessons(folder: Path | None = None) -> list[Lesson]:
    """All lessons of a folder (glsim's own without one), in the order of their numbers.

    Raises ValueError if two have one number."""
    folder = folder or data_folder("lessons")
    found = [read(path) for path in sorted(folder.glob("*.py")) if NAME.fullmatch(path.name)]
    for lesson, following in pairwise(found):
        if lesson.number == following.number:
            raise ValueError(f"{following.path.name}: {lesson.path.name} has the number {lesson.number} already")
    return found


def lesson(which: str, folder: Path | None = None) -> Lesson:
    """The lesson with a number ("7") or a name ("lambert", "07_lambert"), or in a file ("my/07_lambert.py").

    Raises ValueError for an unknown one, with the nearest name."""
    if which.endswith(".py"):
        return read(Path(which))
    known = lessons(folder)
    for one in known:
        if which in (str(one.number), f"{one.number:02}", one.name, one.name[3:]):
            return one
    names = [one.name[3:] for one in known]
    numbers = f"{known[0].number} to {known[-1].number}" if known else "none"
    raise ValueError(
        f"no lesson {which!r}: numbers are {numbers}, glsim lesson list shows all{did_you_mean(which, names)}"
    )
