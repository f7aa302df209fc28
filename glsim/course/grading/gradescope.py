"""Marks as Gradescope's results.json (https://gradescope-autograders.readthedocs.io/en/latest/specs/)."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path
from typing import Any

from glsim.course.grading.record import Part, Record, Total
from glsim.files import write_text


def write(folder: Path, total: Total) -> Path:
    """Write results.json for one submission into a folder."""
    path = folder / "results.json"
    write_text(path, json.dumps(results(total), indent=1) + "\n")
    return path


def results(total: Total) -> dict[str, Any]:
    """What results.json holds: a test case for each part of each exercise, with its hint and its pictures as HTML."""
    tests = [
        _test(record, part, f"{int(record.exercise[:2])}.{number}")
        for record in total.records
        for number, part in enumerate(record.parts, 1)
    ]
    isolation = sorted({record.isolation for record in total.records if record.isolation})
    return {
        "score": total.points,
        "execution_time": round(sum(record.seconds for record in total.records), 1),
        "output": "\n".join(line for record in total.records for line in _lines(record)),
        "output_format": "text",
        "test_output_format": "html",
        "test_name_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "extra_data": {"isolation": isolation, "files": {r.exercise: r.file for r in total.records}},
        "tests": tests,
    }


def _lines(record: Record) -> list[str]:
    head = f"{record.title}: {record.points} of {record.most} points"
    return [f"{head} ({record.note})" if record.note else head]


def _test(record: Record, part: Part, number: str) -> dict[str, Any]:
    return {
        "score": part.points,
        "max_score": part.most,
        "status": "passed" if part.right else "failed",
        "name": f"{record.title}: {part.about}",
        "name_format": "text",
        "number": number,
        "output": _html(record, part),
        "output_format": "html",
        "tags": [record.exercise],
        "visibility": "visible",
    }


def _html(record: Record, part: Part) -> str:
    if part.right:
        return "<p>Right.</p>"
    blocks = [f"<p>{escape(part.hint or record.note)}</p>"]
    if part.picture:
        about = "the expected picture, yours, and 8 times their difference"
        blocks.append(f'<p><img alt="{about}" src="data:image/png;base64,{part.picture}"></p>')
    if record.printed:
        blocks.append(f"<p>Your file printed:</p><pre>{escape(record.printed)}</pre>")
    return "".join(blocks)
