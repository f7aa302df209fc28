"""Runs the cells of a lesson and collects what they print and show."""

from __future__ import annotations

import ast
import contextlib
import io
import os
import tempfile
from base64 import b64decode, b64encode
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from glsim.course.cells import PREDICTION, Cell, Lesson
from glsim.files import write_bytes
from glsim.machine.current import current_again

# The kinds of content that Jupyter asks an object for, and the method that answers.  The first that is there is shown.
LIVE = "application/vnd.glsim.live"  # an element of web/live.py, without its code
SHOWN = {
    LIVE: "_repr_live_",
    "text/html": "_repr_html_",
    "image/svg+xml": "_repr_svg_",
    "image/png": "_repr_png_",
    "text/latex": "_repr_latex_",
    "text/markdown": "_repr_markdown_",
}
FILE_ENDINGS = {"image/svg+xml": ".svg", "image/png": ".png"}


@dataclass
class Output:
    """What a cell gave.

    printed: what the cell printed.  shown: the cell's last expression, as a kind of content -> its text (base64 for
    pictures), as in a notebook file; empty if the cell ends with a statement or with None.
    """

    printed: str = ""
    shown: dict[str, str] = field(default_factory=dict)

    @property
    def is_figure(self) -> bool:
        return bool(self.shown.keys() & SHOWN.keys())


class LessonError(RuntimeError):
    """A cell raised an exception: the message says in which file and line."""


def execute(lesson: Lesson) -> list[Output]:
    """Run a lesson's code cells in their order, and return an Output for every cell of the lesson.

    The lesson runs in a temporary folder; the context that was current stays so.
    Raises LessonError if a cell raises an exception."""
    names: dict[str, Any] = {"__name__": "__main__", "__file__": str(lesson.path)}
    with current_again(), _temporary_folder():
        return [_run(lesson, cell, names) if cell.kind == "code" else Output() for cell in lesson.cells]


def _run(lesson: Lesson, cell: Cell, names: dict[str, Any]) -> Output:
    try:
        tree = ast.parse("\n" * (cell.line - 1) + cell.source, str(lesson.path))
    except SyntaxError as error:
        raise LessonError(f"{lesson.path.name}, line {error.lineno}: SyntaxError: {error.msg}") from None
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    output, printed = Output(), io.StringIO()
    try:
        with contextlib.redirect_stdout(printed):
            exec(compile(tree, str(lesson.path), "exec"), names)
            if isinstance(last, ast.Expr):
                output.shown = shown(eval(compile(ast.Expression(last.value), str(lesson.path), "eval"), names))
    except Exception as error:
        raise LessonError(f"{lesson.path.name}, {_line(error, lesson)}: {type(error).__name__}: {error}") from error
    output.printed = printed.getvalue()
    return output


def _line(error: BaseException, lesson: Lesson) -> str:
    """The line of the lesson in which an exception was raised or from which it came."""
    lines, trace = [], error.__traceback__
    while trace:
        if trace.tb_frame.f_code.co_filename == str(lesson.path):
            lines.append(trace.tb_lineno)
        trace = trace.tb_next
    return f"line {lines[-1]}" if lines else "at its start"


def shown(value: object) -> dict[str, str]:
    """What Jupyter shows of an object: kind of content -> text, with pictures in base64.  Nothing for None."""
    if value is None:
        return {}
    contents = {}
    for kind, method in SHOWN.items():
        content = getattr(value, method, lambda: None)() if not isinstance(value, type) else None
        if content is not None:
            contents[kind] = b64encode(content).decode("ascii") if isinstance(content, bytes) else str(content)
    return {**contents, "text/plain": repr(value)}


def awaited(lesson: Lesson, outputs: Sequence[Output]) -> set[int]:
    """The cells, from 0, whose outputs answer a prediction: those behind the question, up to the first figure."""
    found, waiting = set(), False
    for number, (cell, output) in enumerate(zip(lesson.cells, outputs, strict=True)):
        if cell.kind == "markdown":
            waiting = bool(PREDICTION.search(cell.source))
        elif waiting:
            found.add(number)
            waiting = not output.shown
    return found


def write_figures(folder: Path, lesson: Lesson, outputs: Sequence[Output]) -> list[Path]:
    """Write what the cells of a lesson show as PNG or SVG files, NN_topic-CELL.png; returns their paths.

    folder: made if it does not exist."""
    written = []
    for number, output in enumerate(outputs):
        for kind, ending in FILE_ENDINGS.items():
            if kind in output.shown:
                folder.mkdir(parents=True, exist_ok=True)
                path = folder / f"{lesson.name}-{number}{ending}"
                content = output.shown[kind]
                data = content.encode() if kind == "image/svg+xml" else b64decode(content)
                write_bytes(path, data)
                written.append(path)
    return written


@contextlib.contextmanager
def _temporary_folder() -> Iterator[None]:
    """What a lesson saves goes to a folder that is removed afterwards."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory(prefix="glsim-lesson-") as folder:
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)
