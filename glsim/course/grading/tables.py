"""Marks as a table for the terminal, as CSV for a spreadsheet, and as JSON with everything that was found out."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.course.grading.record import Record, Total
from glsim.files import write_text

if TYPE_CHECKING:
    from rich.table import Table

FORMULA = ("=", "+", "-", "@", "\t", "\r")  # with which a spreadsheet's formula begins


def exercise_names(totals: Sequence[Total]) -> list[str]:
    """The exercises that were graded, in their order."""
    return sorted({record.exercise for total in totals for record in total.records})


def table(totals: Sequence[Total]) -> Table:
    """A row for each submission: its points for each exercise, all its points, and what is to be said about it."""
    from rich.table import Table
    from rich.text import Text

    names = exercise_names(totals)
    grid = Table("submission", *(name[:2] if len(names) > 3 else name for name in names), "points", "first hint")
    for column in grid.columns[1:-1]:
        column.justify = "right"
    for total in totals:
        marks = {record.exercise: _points(record) for record in total.records}
        cells = [marks.get(name, "") for name in names]
        sentence = Text(first_sentence(total), overflow="ellipsis", no_wrap=True)
        grid.add_row(Text(total.submission), *cells, f"{total.points} of {total.most}", sentence)
    return grid


def _points(record: Record) -> str:
    return "failed" if record.failure else str(record.points)


def first_sentence(total: Total) -> str:
    """The first thing to say about a submission.  What is said about a file comes before the sentence that one is
    missing."""
    sentences = [
        sentence
        for record in sorted(total.records, key=lambda record: not record.file)
        for sentence in (record.failure, record.note, *(part.hint for part in record.parts))
        if sentence
    ]
    return sentences[0] if sentences else ""


def write_csv(folder: Path, totals: Sequence[Total]) -> Path:
    """Write marks.csv: a row for each submission, a column for each exercise."""
    names = exercise_names(totals)
    text = io.StringIO()
    rows = csv.writer(text)
    rows.writerow(["submission", *names, "points", "of", "first hint"])
    for total in totals:
        marks = {record.exercise: "" if record.failure else record.points for record in total.records}
        points = [marks.get(name, "") for name in names]
        sum_ = "" if "" in points else total.points
        rows.writerow([_cell(total.submission), *points, sum_, total.most, _cell(first_sentence(total))])
    path = folder / "marks.csv"
    write_text(path, text.getvalue())
    return path


def _cell(text: str) -> str:
    """Text that no spreadsheet takes for a formula."""
    return "'" + text if text.startswith(FORMULA) else text


def write_json(folder: Path, totals: Sequence[Total]) -> Path:
    """Write marks.json: all that was found out but for pictures and times, so that equal marks give equal files."""
    path = folder / "marks.json"
    document = {"exercises": exercise_names(totals), "submissions": [_plain(total) for total in totals]}
    write_text(path, json.dumps(document, indent=1, ensure_ascii=False) + "\n")
    return path


def _plain(total: Total) -> dict[str, Any]:
    marks = [
        {
            "exercise": record.exercise,
            "points": None if record.failure else record.points,
            "of": record.most,
            "parts": [{"about": p.about, "points": p.points, "of": p.most, "hint": p.hint} for p in record.parts],
            "file": record.file,
            "note": record.note,
            "printed": record.printed,
            "isolation": record.isolation,
            "failure": record.failure,
        }
        for record in total.records
    ]
    return {"submission": total.submission, "points": total.points, "of": total.most, "marks": marks}
