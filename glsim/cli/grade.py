"""``glsim grade``: many submissions at once."""

from __future__ import annotations

import argparse
import json
import os
import sys
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.cli.options import console, count, positive

if TYPE_CHECKING:
    from glsim.course.exercise import Exercise
    from glsim.course.grading.record import Record, Total
    from glsim.course.grading.submissions import Submission

FORMATS = ("table", "csv", "json", "junit", "gradescope", "classroom50")


def add(commands: Any) -> None:
    text = "grade many submissions of exercises at once"
    p = commands.add_parser(
        "grade", help=text, description=text[0].upper() + text[1:] + ".",
        epilog="Exit codes: 0 everything has its mark, however low; 1 something could not be graded; "
               "2 wrong command line; 130 Ctrl-C, after which --resume goes on.",
    )  # fmt: skip
    p.add_argument("submissions", metavar="SUBMISSIONS", nargs="?",
                   help="a folder; each entry is one submission: a file, a folder or a zip archive. "
                        "With --scaffold the folder to be written")  # fmt: skip
    p.add_argument("--exercise", metavar="N", required=True, help="a number or a name, several with commas, or all")
    p.add_argument("--format", choices=FORMATS, default="table",
                   help="table is printed; the others are written to DIR (default: %(default)s)")  # fmt: skip
    p.add_argument("-o", "--output", metavar="DIR", default="marks",
                   help="for the overview, the marks and what --format writes (default: %(default)s)")  # fmt: skip
    p.add_argument("-j", "--jobs", type=count, metavar="N", default=os.cpu_count() or 1,
                   help="processes (default: one for each core)")  # fmt: skip
    p.add_argument("--resume", action="store_true",
                   help="keep the marks in DIR of files and exercises that have not changed")  # fmt: skip
    p.add_argument("--one", action="store_true",
                   help="SUBMISSIONS is one submission; write what --format writes, and nothing else")  # fmt: skip
    p.add_argument("--scaffold", choices=("classroom50", "gradescope"),
                   help="grade nothing; write the folder that a learning platform wants as its autograder")  # fmt: skip
    p.add_argument("--timeout", type=positive, default=20.0, metavar="SECONDS",
                   help="that a student's file may run (default: %(default)g)")  # fmt: skip
    p.add_argument("--json", action="store_true", help="print one JSON object")
    p.set_defaults(run=_run, error=p.error)


def _run(options: argparse.Namespace) -> int:
    from glsim.course.grading.record import totals
    from glsim.course.grading.submissions import Submission, submissions

    if options.submissions is None:
        options.error("the following arguments are required: SUBMISSIONS")
    wanted, folder, output = _wanted(options.exercise), Path(options.submissions), Path(options.output)
    if options.scaffold:
        return _scaffold(options, wanted, folder)
    if options.one and not folder.exists():
        raise FileNotFoundError(f"{folder}: there is no such file or folder")
    chosen = [Submission(folder.resolve().name, (folder,))] if options.one else submissions(folder, output)
    records = _graded(chosen, wanted, options)
    order = {one.slug: number for number, one in enumerate(chosen)}
    graded = totals(sorted(records, key=lambda record: (order[record.slug], record.exercise)))
    written = _write(graded, options)
    failures = [record for record in records if record.failure]
    if options.json:
        print(json.dumps({"status": "failures" if failures else "ok", "submissions": len(graded),
                          "points": [total.points for total in graded], "of": sum(one.points for one in wanted),
                          "isolation": _isolation(records), "failures": [f.failure for f in failures],
                          "files": [str(path) for path in written]}))  # fmt: skip
    else:
        _tell(graded, failures, written, options)
    return 1 if failures else 0


def _scaffold(options: argparse.Namespace, wanted: list[Exercise], folder: Path) -> int:
    from glsim.course.grading.scaffold import scaffold

    written = [str(path) for path in scaffold(options.scaffold, folder, wanted)]
    print(json.dumps({"status": "ok", "files": written}) if options.json else "\n".join(f"wrote {w}" for w in written))
    return 0


def _wanted(text: str) -> list[Exercise]:
    from glsim.course.exercise import exercise, exercises

    if text == "all":
        return exercises()
    found = {one.name: one for one in (exercise(word.strip()) for word in text.split(","))}
    return [found[name] for name in sorted(found)]


def _graded(chosen: list[Submission], wanted: list[Exercise], options: argparse.Namespace) -> list[Record]:
    """The Records of all submissions, with a progress bar on the terminal."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    from glsim.course.grading.record import Store
    from glsim.course.grading.run import grade

    store = None if options.one else Store(Path(options.output) / "records")
    records: list[Record] = []
    all_ = len(chosen) * len(wanted)
    running = grade(
        chosen, wanted, jobs=options.jobs, seconds=options.timeout, store=store, resume=options.resume
    )  # fmt: skip
    columns = (TextColumn("grading"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    try:
        with closing(running), Progress(*columns, console=Console(stderr=True), transient=True) as progress:
            task = progress.add_task("", total=all_)
            for record in running:
                records.append(record)
                progress.advance(task)
    except KeyboardInterrupt:
        print(f"glsim: {len(records)} of {all_} marks are kept; --resume goes on", file=sys.stderr)
        raise
    return records


def _write(graded: list[Total], options: argparse.Namespace) -> list[Path]:
    """Write what the options ask for; returns the files."""
    from glsim.course.grading import classroom50, gradescope, junit, overview, tables

    output = Path(options.output)
    if options.one and options.format == "table":
        return []
    output.mkdir(parents=True, exist_ok=True)
    written = [] if options.one else [overview.write(output, graded)]
    for_all = {"csv": tables.write_csv, "json": tables.write_json, "junit": junit.write}
    for_each = {"gradescope": gradescope.write, "classroom50": classroom50.write}
    if options.format in for_all:
        written.append(for_all[options.format](output, graded))
    for total in graded if options.format in for_each else []:
        if any(record.failure for record in total.records):
            continue  # no file rather than a wrong one: a learning platform then shows an error and not a mark
        folder = output if options.one else output / total.slug
        folder.mkdir(exist_ok=True)
        written.append(for_each[options.format](folder, total))
    return written


def _isolation(records: list[Record]) -> list[str]:
    return sorted({record.isolation for record in records if record.isolation})


def _tell(graded: list[Total], failures: list[Record], written: list[Path], options: argparse.Namespace) -> None:
    from glsim.course.grading.tables import table

    if options.format == "table":
        console().print(table(graded))
    records = [record for total in graded for record in total.records]
    print(f"graded {len(graded)} submissions; isolation: {', '.join(_isolation(records)) or 'nothing was run'}")
    for path in written[:4]:
        print(f"wrote {path}")
    if len(written) > 4:
        print(f"wrote {len(written) - 4} files more")
    for record in failures:
        print(f"glsim: {record.submission}, {record.exercise}: not graded: {record.failure}", file=sys.stderr)
